// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3065 bits, pipeline 861 bits, memories 127160 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [9:0] cfg_width_i,
  input  logic [8:0] cfg_height_i,
  input  logic cfg_compete_i,
  input  logic cfg_prove_i,
  input  logic signed [5:0] cfg_shift_lowest_i,
  input  logic signed [5:0] cfg_shift_highest_i,
  input  logic cfg_nearer_below_i,
  input  logic cfg_nearer_above_i,
  input  logic [7:0] cfg_explained_limit_i,
  input  logic [7:0] cfg_regions_limit_i,
  input  logic [7:0] cfg_unproven_limit_i,
  input  logic [7:0] cfg_unproven_skin_limit_i,
  input  logic [7:0] cfg_hidden_limit_i,
  input  logic [7:0] cfg_hidden_frames_i,
  input  logic [5:0] cfg_moved_limit_i,
  input  logic [5:0] cfg_moved_half_limit_i,
  input  logic [5:0] cfg_patch_limit_i,
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic [7:0] cfg_on_skin_cells_i,
  input  logic cfg_alarm_before_i,
  input  logic cfg_same_table_i,
  input  logic signed [15:0] cfg_epipolar_slope_i,
  input  logic signed [15:0] cfg_epipolar_column_i,
  input  logic signed [15:0] cfg_epipolar_row_i,
  input  logic signed [15:0] cfg_epipolar_both_i,
  output logic parity_error_o,
  output logic valid_o,
  output logic [7:0] pixel_0_o,
  output logic [7:0] pixel_1_o,
  output logic saturated_o,
  output logic mask_o,
  output logic marks_first_o,
  output logic marks_last_o,
  output logic marks_seen_o,
  output logic marks_nearer_o,
  output logic verdict_valid_o,
  output logic verdict_unproven_yet_o,
  output logic verdict_untextured_o,
  output logic verdict_disagree_o,
  output logic verdict_moved_o,
  output logic verdict_unsharp_left_o,
  output logic verdict_unsharp_right_o,
  output logic verdict_hidden_o,
  output logic verdict_overlooked_o,
  output logic verdict_out_of_step_o,
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q;
  logic s0_en, s1_en, s2_en, s3_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;

  // Of the configuration alone: not pipelined.
  logic not_2813;
  assign not_2813 = ~cfg_prove_i;
  logic [5:0] sum_3023;
  assign sum_3023 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4067;
  assign difference_4067 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4280;
  assign not_4280 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4338;
  assign difference_4338 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4554;
  assign less_4554 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4555;
  assign sum_4555 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [8:0] averager_place_q;
  logic averager_inside_q;
  logic [2:0] run_phase_q;
  logic [5:0] run_shift_q;
  logic run_last_shift_q;
  logic [7:0] run_span_q;
  logic [2:0] following_phase_q;
  logic [5:0] following_shift_q;
  logic following_last_shift_q;
  logic [7:0] following_span_q;
  logic [6:0] following_lowest_q;
  logic [7:0] following_columns_q;
  logic [5:0] plan_shift_q;
  logic [7:0] plan_span_q;
  logic [7:0] plan_columns_q;
  logic [7:0] x_q;
  logic [7:0] columns_left_q;
  logic [6:0] last_q;
  logic [6:0] least_q;
  logic [7:0] whole_q;
  logic [7:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  logic shift_first_q;
  logic [3:0] patches_phase_q;
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic [4:0] patches_choosing_number_q;
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  logic patches_capturing_q;
  logic patches_lower_q;
  logic [4:0] patches_row_q;
  logic [2:0] patches_work_q;
  logic patches_second_q;
  logic [2:0] patches_following_q;
  logic [4:0] patches_following_beats_q;
  logic patches_begins_q;
  logic patches_ends_q;
  logic [11:0] patches_remaining_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/census.hpp:36
  logic [2:0] select_502;
  assign select_502 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_504;
  assign select_504 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:117
  logic equal_505;
  assign equal_505 = {select_504, select_502} == 10'h0;
  // hls/stages/census.hpp:121
  logic [8:0] select_508;
  assign select_508 = select_502[0] ? averager_place_q : (equal_505 ? 9'h0 : (averager_place_q + 9'h1));
  // hls/stages/census.hpp:119
  logic or_512;
  assign or_512 = equal_505 | (averager_inside_q & (~(averager_place_q == 9'h13f)));
  // hls/stages/census.hpp:121
  logic select_513;
  assign select_513 = select_502[0] ? averager_inside_q : or_512;
  // hls/stages/census.hpp:42
  logic or_514;
  assign or_514 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_516;
  assign and_516 = select_513 & (select_502[0] & or_514);
  // hls/stages/census.hpp:42
  logic [2:0] select_521;
  assign select_521 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_504 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_538;
  assign equal_538 = select_502 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_539;
  assign equal_539 = select_521 == 3'h7;
  // hls/stages/census.hpp:131
  logic and_540;
  assign and_540 = equal_539 & and_516;
  // hls/stages/agreement.hpp:276
  logic and_542;
  assign and_542 = sample_pair_whole_q & (equal_538 & and_540);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_571;
  assign equal_571 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_572;
  assign or_572 = so | equal_571;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_573;
  assign sum_573 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_574;
  assign select_574 = run_shift_q[5] ? x_q : sum_573;
  logic less_575;
  assign less_575 = {1'b0, last_q} < select_574;
  // hls/stages/agreement.hpp:226
  logic not_576;
  assign not_576 = ~less_575;
  // hls/stages/agreement.hpp:614
  logic equal_586;
  assign equal_586 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_587;
  assign equal_587 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_588;
  assign and_588 = equal_587 & not_576;
  logic select_590;
  assign select_590 = or_572 ? not_576 : (equal_586 ? not_576 : and_588);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_608;
  assign and_608 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_574)));
  logic and_609;
  assign and_609 = equal_586 & and_608;
  logic select_610;
  assign select_610 = or_572 ? not_576 : and_609;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_573[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:594
  logic not_640;
  assign not_640 = ~or_572;
  // hls/stages/agreement.hpp:149
  logic and_643;
  assign and_643 = not_640 & ((~equal_586) & and_588);
  // hls/stages/census.hpp:42
  logic [5:0] select_670;
  assign select_670 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_670 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_2142;
  assign and_2142 = (select_502 == 3'h0) & (select_504 == 7'h0);
  // hls/stages/patches.hpp:393
  logic not_2143;
  assign not_2143 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2146;
  assign not_2146 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:363
  logic and_2147;
  assign and_2147 = patches_capturing_q & not_2146;
  // hls/stages/patches.hpp:365
  logic equal_2148;
  assign equal_2148 = {or_514, select_521} == 4'hc;
  // hls/stages/patches.hpp:312
  logic equal_2150;
  assign equal_2150 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2155;
  assign and_2155 = (not_2143 & (patches_work_q == 3'h0)) & (~(and_2147 | ((~equal_2148) | (~equal_2150))));
  // hls/stages/patches.hpp:535
  logic equal_2246;
  assign equal_2246 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:513
  logic not_2247;
  assign not_2247 = ~equal_2246;
  // hls/stages/patches.hpp:506
  logic equal_2248;
  assign equal_2248 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:459
  logic not_2249;
  assign not_2249 = ~equal_2248;
  // hls/stages/patches.hpp:500
  logic equal_2250;
  assign equal_2250 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2251;
  assign equal_2251 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_2252;
  assign or_2252 = equal_2250 | equal_2251;
  // hls/stages/patches.hpp:461
  logic not_2253;
  assign not_2253 = ~patches_second_q;
  // hls/stages/patches.hpp:374
  logic [4:0] select_2275;
  assign select_2275 = and_2155 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2276;
  assign select_2276 = and_2142 ? select_2275 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2278;
  assign and_2278 = and_2147 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2282;
  assign select_2282 = and_2142 ? (and_2155 | (and_2147 & (~and_2278))) : patches_capturing_q;
  // hls/stages/patches.hpp:185
  logic and_2290;
  assign and_2290 = not_2247 & (not_2249 & (or_2252 & (patches_second_q & equal_2251)));
  // hls/stages/patches.hpp:168
  logic not_2306;
  assign not_2306 = ~equal_2251;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2322;
  assign select_2322 = and_2142 ? {select_2275[4], select_2275[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:459
  logic and_2332;
  assign and_2332 = not_2247 & (or_2252 & not_2249);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2607;
  assign select_2607 = sample_pair_whole_q ? (sample_last_q ? (select_521 + 3'h1) : select_521) : raster_at_y_q;
  logic [6:0] select_2609;
  assign select_2609 = sample_pair_whole_q ? (select_504 + {6'h0, equal_538}) : raster_at_column_q;
  logic [5:0] select_2612;
  assign select_2612 = sample_pair_whole_q ? (sample_last_q ? (select_670 + {5'h0, equal_539}) : select_670) : raster_at_row_q;
  logic select_2616;
  assign select_2616 = sample_pair_whole_q ? (sample_last_q ? (or_514 & (~raster_final_row_q)) : or_514) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2618;
  assign select_2618 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2622;
  assign select_2622 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2931;
  assign sum_2931 = {1'b0, last} + 8'h1;
  logic equal_2932;
  assign equal_2932 = {sum_2931[7], cfg_width_i[9:3]} == {1'b0, sum_2931[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2933;
  assign and_2933 = and_542 & equal_2932;
  // hls/stages/agreement.hpp:523
  logic select_2936;
  assign select_2936 = (and_2933 | (~ends_cell_q)) ? and_2933 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2936 ? (and_2933 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2940;
  assign select_2940 = select_2936 ? (and_2933 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2943;
  assign select_2943 = select_2936 ? (following_last_shift_q & (~and_2933)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2946;
  assign and_2946 = run_last_shift_q & equal_586;
  // hls/stages/agreement.hpp:616
  logic select_2948;
  assign select_2948 = equal_586 ? (~run_last_shift_q) : equal_587;
  // hls/stages/agreement.hpp:620
  logic equal_2949;
  assign equal_2949 = run_phase_q == 3'h1;
  logic not_2952;
  assign not_2952 = ~select_2948;
  // hls/stages/agreement.hpp:623
  logic equal_2954;
  assign equal_2954 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2955;
  assign and_2955 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2956;
  assign select_2956 = equal_2954 ? 2'h1 : {2{and_2955}};
  logic [2:0] select_2958;
  assign select_2958 = (and_2946 | (select_2948 | equal_2949)) ? (equal_2949 ? 3'h2 : {not_2952, {2{select_2948}}}) : (equal_571 ? 3'h6 : {select_2956[0], select_2956});
  // hls/stages/agreement.hpp:607
  logic and_2961;
  assign and_2961 = select_2948 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2964;
  assign select_2964 = (plan_shift_q[5] & select_2948) ? value : 7'h0;
  logic [1:0] or_2965;
  assign or_2965 = {2{so}} | select_2964[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2969;
  assign or_2969 = (select_2948 ? plan_columns_q : 8'h0) | ((equal_2949 | equal_2954) ? whole_q : 8'h0);
  logic [1:0] or_2970;
  assign or_2970 = {2{and_2946}} | or_2969[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2972;
  assign or_2972 = {or_2969[7:4], or_2970, or_2969[1:0]} | (equal_571 ? drawn_q : 8'h0);
  logic [4:0] or_2973;
  assign or_2973 = {5{so}} | {or_2972[6], or_2972[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2977;
  assign not_2977 = ~run_shift_q[5];
  logic [7:0] select_2980;
  assign select_2980 = equal_586 ? ({{7{not_2977}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2984;
  assign select_2984 = and_2933 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2986;
  assign select_2986 = select_2936 ? {select_2984[6], select_2984} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2989;
  assign select_2989 = select_2936 ? (and_2933 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2997;
  assign select_2997 = and_542 ? (equal_2932 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [5:0] sum_2998;
  assign sum_2998 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3000;
  assign select_3000 = and_542 ? (equal_2932 ? {sum_2998, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_3001;
  assign sum_3001 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3003;
  assign select_3003 = and_542 ? (equal_2932 ? {sum_3001, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_3014;
  assign select_3014 = (ends_cell_q | select_2936) ? (~(now == 3'h6)) : (equal_586 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_3018;
  assign and_3018 = (~select_2936) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_3019;
  assign sum_3019 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_3021;
  assign select_3021 = equal_2932 ? ({sum_3019[6], cfg_height_i[8:3]} == {1'b0, sum_3019[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3380;
  assign select_3380 = and_2142 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3381;
  assign select_3381 = sample_pair_whole_q ? select_3380 : patches_phase_q;
  // hls/stages/patches.hpp:374
  logic and_3382;
  assign and_3382 = not_2146 & equal_2148;
  logic [8:0] select_3383;
  assign select_3383 = and_3382 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3384;
  assign select_3384 = and_3382 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3385;
  assign select_3385 = sample_pair_first_q ? select_3383 : select_3384;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3387;
  assign select_3387 = sample_pair_whole_q ? (and_2142 ? select_3385[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3389;
  assign select_3389 = sample_pair_whole_q ? (and_2142 ? select_3385[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3392;
  assign select_3392 = sample_pair_whole_q ? (equal_2150 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3394;
  assign select_3394 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2150}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_3395;
  assign equal_3395 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:332
  logic not_3396;
  assign not_3396 = ~equal_3395;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3398;
  assign select_3398 = sample_pair_whole_q ? (phase + {not_3396, 1'b1, not_3396, equal_3395}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3400;
  assign equal_3400 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3404;
  assign select_3404 = equal_3400 ? ((select_3381 == 4'h6) ? 4'h0 : (select_3381 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3405;
  assign equal_3405 = select_3404 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3408;
  assign select_3408 = equal_2932 ? (equal_3405 ? 4'h6 : (select_3404 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3410;
  assign select_3410 = equal_3400 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3412;
  assign select_3412 = equal_2932 ? (select_3410 + {4'h0, equal_3405}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3417;
  assign select_3417 = and_542 ? (equal_2932 ? ((6'h2 < row) & equal_3405) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3419;
  assign select_3419 = and_542 ? (equal_2932 ? select_3410 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:372
  logic or_3443;
  assign or_3443 = select_504[0] | select_670[5];
  logic [7:0] sum_3444;
  assign sum_3444 = {1'b0, select_504[2:1], or_3443, select_670[4:1]} + 8'h1;
  logic less_3445;
  assign less_3445 = {sum_3444, select_670[0], select_521, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3448;
  assign select_3448 = and_2142 ? (and_2155 ? (~less_3445) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:394
  logic or_3487;
  assign or_3487 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3493;
  assign and_3493 = equal_2246 & not_2253;
  // hls/stages/patches.hpp:400
  logic and_3494;
  assign and_3494 = not_2306 & and_3493;
  logic [1:0] select_3496;
  assign select_3496 = equal_2248 ? 2'h0 : (equal_2250 ? 2'h3 : {equal_2251, and_3494});
  // hls/stages/patches.hpp:280
  logic equal_3498;
  assign equal_3498 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3499;
  assign not_3499 = ~equal_3498;
  // hls/stages/patches.hpp:280
  logic equal_3500;
  assign equal_3500 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3501;
  assign not_3501 = ~equal_3500;
  // hls/stages/patches.hpp:284
  logic not_3503;
  assign not_3503 = ~(patches_following_q == 3'h2);
  logic and_3506;
  assign and_3506 = (~(patches_following_q == 3'h1)) & not_3503;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3507;
  assign select_3507 = equal_3500 ? 2'h2 : {and_3506, not_3503};
  logic [3:0] select_3508;
  assign select_3508 = equal_3498 ? 4'h2 : {select_3507, {2{not_3501}}};
  // hls/stages/patches.hpp:406
  logic not_3511;
  assign not_3511 = ~or_3487;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3516;
  assign select_3516 = or_3487 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:188
  logic [4:0] select_3518;
  assign select_3518 = or_3487 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1372; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_643;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_590;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_572 ? x_q[6:0] : (equal_586 ? sum_573[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_590;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_572 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_610;
  logic [62:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [61:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[61:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2247 & (not_2249 & (or_2252 & (equal_2251 & not_2253))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2290;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:781; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2247 & (not_2249 & (not_2306 & or_2252)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 33'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_2332;
  logic [32:0] patches_columns_above_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_word_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end
  logic [31:0] patches_columns_above_rdata_q;
  assign patches_columns_above_rdata_q = patches_columns_above_word_q[31:0];
  logic patches_columns_above_read_q, patches_columns_above_error;
  always_ff @(posedge clk_i) patches_columns_above_read_q <= rst_ni & patches_columns_above_re;
  assign patches_columns_above_error = patches_columns_above_read_q & ^patches_columns_above_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 9'h0;
      averager_inside_q <= 1'b1;
      run_phase_q <= 3'h0;
      run_shift_q <= 6'h0;
      run_last_shift_q <= 1'b0;
      run_span_q <= 8'h0;
      following_phase_q <= 3'h0;
      following_shift_q <= 6'h0;
      following_last_shift_q <= 1'b0;
      following_span_q <= 8'h0;
      following_lowest_q <= 7'h0;
      following_columns_q <= 8'h0;
      plan_shift_q <= 6'h0;
      plan_span_q <= 8'h0;
      plan_columns_q <= 8'h0;
      x_q <= 8'h0;
      columns_left_q <= 8'h0;
      last_q <= 7'h0;
      least_q <= 7'h0;
      whole_q <= 8'h0;
      drawn_q <= 8'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      shift_first_q <= 1'b0;
      patches_phase_q <= 4'h0;
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
      patches_capturing_q <= 1'b0;
      patches_lower_q <= 1'b0;
      patches_row_q <= 5'h0;
      patches_work_q <= 3'h0;
      patches_second_q <= 1'b0;
      patches_following_q <= 3'h0;
      patches_following_beats_q <= 5'h0;
      patches_begins_q <= 1'b0;
      patches_ends_q <= 1'b0;
      patches_remaining_q <= 12'h0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_502 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2607;
      raster_at_column_q <= select_2609;
      raster_at_row_q <= select_2612;
      raster_at_live_q <= select_2616;
      raster_rows_left_q <= sample_pair_whole_q ? select_2618 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2622;
      averager_place_q <= sample_pair_whole_q ? select_508 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_513 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2940;
      run_last_shift_q <= select_2943;
      run_span_q <= select_2936 ? (and_2933 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2958;
      following_shift_q <= select_2948 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2961;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2964[6], or_2965, select_2964[3:0]};
      following_columns_q <= {or_2972[7], or_2973[4], or_2972[5:4], or_2973[3:0]};
      plan_shift_q <= equal_586 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2980;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2986;
      columns_left_q <= select_2989;
      last_q <= and_542 ? (equal_2932 ? last : last_q) : last_q;
      least_q <= select_2997;
      whole_q <= select_3000;
      drawn_q <= select_3003;
      age_q <= select_2936 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2936 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3014;
      ends_q <= and_3018;
      final_row_q <= and_542 ? select_3021 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3381;
      patches_band_rows_rows_to_next_q <= select_3387;
      patches_band_rows_number_q <= select_3389;
      patches_next_band_rows_to_next_q <= select_3392;
      patches_next_band_number_q <= select_3394;
      patches_first_band_rows_to_next_q <= select_3398;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3395 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_542 ? select_3408 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_542 ? select_3412 : patches_choosing_number_q;
      patches_chooses_q <= select_3417;
      patches_choosing_band_q <= select_3419;
      patches_capturing_q <= sample_pair_whole_q ? select_2282 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3448 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2276 : patches_row_q;
      patches_work_q <= or_3487 ? following : patches_work_q;
      patches_second_q <= not_2143 & (patches_second_q | (patches_ends_q & equal_2246));
      patches_following_q <= equal_2246 ? {2'h0, and_3493} : {equal_2248, select_3496};
      patches_following_beats_q <= {select_3508, not_3499};
      patches_begins_q <= sample_pair_whole_q & (and_2142 & and_2278);
      patches_ends_q <= not_3511 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3516;
      patches_code_row_q <= select_3518;
      patches_column_q <= or_3487 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3511 & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [6:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic shift_first_s1_q;
  logic [4:0] patches_band_rows_number_s1_q;
  logic patches_chooses_s1_q;
  logic [4:0] patches_choosing_band_s1_q;
  logic patches_lower_s1_q;
  logic patches_second_s1_q;
  logic [4:0] patches_code_row_s1_q;
  logic [4:0] patches_column_s1_q;
  logic [2:0] select_502_s1_q;
  logic [6:0] select_504_s1_q;
  logic [8:0] select_508_s1_q;
  logic and_516_s1_q;
  logic equal_522_s1_q;
  logic [6:0] last_s1_2_q;
  logic and_540_s1_q;
  logic and_542_s1_q;
  logic equal_567_s1_q;
  logic so_s1_q;
  logic equal_571_s1_q;
  logic or_572_s1_q;
  logic less_575_s1_q;
  logic not_576_s1_q;
  logic equal_586_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_610_s1_q;
  logic [6:0] right_s1_q;
  logic and_643_s1_q;
  logic [5:0] row_s1_q;
  logic and_2028_s1_q;
  logic equal_2029_s1_q;
  logic and_2142_s1_q;
  logic and_2155_s1_q;
  logic equal_2246_s1_q;
  logic not_2247_s1_q;
  logic equal_2248_s1_q;
  logic not_2249_s1_q;
  logic equal_2250_s1_q;
  logic equal_2251_s1_q;
  logic or_2252_s1_q;
  logic [4:0] select_2276_s1_q;
  logic select_2282_s1_q;
  logic [3:0] select_2322_s1_q;
  logic and_2332_s1_q;
  logic equal_2932_s1_q;
  logic and_2933_s1_q;
  logic or_3487_s1_q;
  logic not_3511_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_present_s1_q <= sample_present_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      shift_first_s1_q <= shift_first_q;
      patches_band_rows_number_s1_q <= patches_band_rows_number_q;
      patches_chooses_s1_q <= patches_chooses_q;
      patches_choosing_band_s1_q <= patches_choosing_band_q;
      patches_lower_s1_q <= patches_lower_q;
      patches_second_s1_q <= patches_second_q;
      patches_code_row_s1_q <= patches_code_row_q;
      patches_column_s1_q <= patches_column_q;
      select_502_s1_q <= select_502;
      select_504_s1_q <= select_504;
      select_508_s1_q <= select_508;
      and_516_s1_q <= and_516;
      equal_522_s1_q <= select_521 == 3'h0;
      last_s1_2_q <= last;
      and_540_s1_q <= and_540;
      and_542_s1_q <= and_542;
      equal_567_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_571_s1_q <= equal_571;
      or_572_s1_q <= or_572;
      less_575_s1_q <= less_575;
      not_576_s1_q <= not_576;
      equal_586_s1_q <= equal_586;
      x_s1_2_q <= x[6:0];
      select_610_s1_q <= select_610;
      right_s1_q <= right;
      and_643_s1_q <= and_643;
      row_s1_q <= row;
      and_2028_s1_q <= not_640 & and_609;
      equal_2029_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2142_s1_q <= and_2142;
      and_2155_s1_q <= and_2155;
      equal_2246_s1_q <= equal_2246;
      not_2247_s1_q <= not_2247;
      equal_2248_s1_q <= equal_2248;
      not_2249_s1_q <= not_2249;
      equal_2250_s1_q <= equal_2250;
      equal_2251_s1_q <= equal_2251;
      or_2252_s1_q <= or_2252;
      select_2276_s1_q <= select_2276;
      select_2282_s1_q <= select_2282;
      select_2322_s1_q <= select_2322;
      and_2332_s1_q <= and_2332;
      equal_2932_s1_q <= equal_2932;
      and_2933_s1_q <= and_2933;
      or_3487_s1_q <= or_3487;
      not_3511_s1_q <= not_3511;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [5:0] sums_0_columns_values_0_q;
  logic [5:0] sums_0_columns_values_1_q;
  logic [5:0] sums_0_columns_values_2_q;
  logic [5:0] sums_0_columns_values_3_q;
  logic [5:0] sums_0_columns_values_4_q;
  logic [5:0] sums_0_columns_values_5_q;
  logic [5:0] sums_0_columns_values_6_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [5:0] sums_1_columns_values_0_q;
  logic [5:0] sums_1_columns_values_1_q;
  logic [5:0] sums_1_columns_values_2_q;
  logic [5:0] sums_1_columns_values_3_q;
  logic [5:0] sums_1_columns_values_4_q;
  logic [5:0] sums_1_columns_values_5_q;
  logic [5:0] sums_1_columns_values_6_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [5:0] sums_2_columns_values_0_q;
  logic [5:0] sums_2_columns_values_1_q;
  logic [5:0] sums_2_columns_values_2_q;
  logic [5:0] sums_2_columns_values_3_q;
  logic [5:0] sums_2_columns_values_4_q;
  logic [5:0] sums_2_columns_values_5_q;
  logic [5:0] sums_2_columns_values_6_q;
  logic [7:0] sums_2_sum_sums_values_0_q;
  logic [5:0] sums_3_columns_values_0_q;
  logic [5:0] sums_3_columns_values_1_q;
  logic [5:0] sums_3_columns_values_2_q;
  logic [5:0] sums_3_columns_values_3_q;
  logic [5:0] sums_3_columns_values_4_q;
  logic [5:0] sums_3_columns_values_5_q;
  logic [5:0] sums_3_columns_values_6_q;
  logic [7:0] sums_3_sum_sums_values_0_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic [4:0] patches_summed_down_by_q;
  logic [6:0] patches_step_q;
  logic patches_read_searches_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:124
  logic and_517;
  assign and_517 = sample_pair_whole_s1_q & and_516_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_561;
  assign equal_561 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_562;
  assign equal_562 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_561 & equal_562;
  // hls/stages/moments.hpp:57
  logic [13:0] select_565;
  assign select_565 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [12:0] select_566;
  assign select_566 = first ? 13'h0 : select_565[12:0];
  // hls/stages/agreement.hpp:1009
  logic not_568;
  assign not_568 = ~equal_567_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_570;
  assign not_570 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_572_s1_q & not_576_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_565[13:6];
  // hls/stages/moments.hpp:104
  logic not_580;
  assign not_580 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:788
  logic and_584;
  assign and_584 = not_568 & (not_570 & (equal_571_s1_q & (inside_v & not_580)));
  // hls/stages/agreement.hpp:975
  logic and_600;
  assign and_600 = (or_572_s1_q & (left_rdata_q[67] & not_576_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [6:0] select_619;
  assign select_619 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:668
  logic not_740;
  assign not_740 = ~equal_561;
  // hls/stages/agreement.hpp:671
  logic and_741;
  assign and_741 = left_rdata_q[12] & not_740;
  logic and_742;
  assign and_742 = left_rdata_q[30] & not_740;
  logic and_743;
  assign and_743 = left_rdata_q[48] & not_740;
  logic and_744;
  assign and_744 = left_rdata_q[66] & not_740;
  // hls/stages/agreement.hpp:672
  logic and_745;
  assign and_745 = right_codes_rdata_q[12] & not_740;
  logic and_746;
  assign and_746 = right_codes_rdata_q[27] & not_740;
  logic and_747;
  assign and_747 = right_codes_rdata_q[42] & not_740;
  logic and_748;
  assign and_748 = right_codes_rdata_q[57] & not_740;
  logic and_749;
  assign and_749 = right_codes_rdata_q[72] & not_740;
  logic and_750;
  assign and_750 = right_codes_rdata_q[85] & not_740;
  // hls/stages/agreement.hpp:221
  logic and_755;
  assign and_755 = left_rdata_q[48] & not_576_s1_q;
  logic and_756;
  assign and_756 = right_codes_rdata_q[42] & not_576_s1_q;
  logic [11:0] select_757;
  assign select_757 = less_575_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_758;
  assign select_758 = less_575_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_762;
  assign select_762 = and_755 ? (and_756 ? (~(select_757 ^ select_758)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_768;
  assign parity_768 = ^select_762[5:3];
  logic parity_771;
  assign parity_771 = ^select_762[8:6];
  logic parity_774;
  assign parity_774 = ^select_762[11:3];
  // hls/stages/agreement.hpp:221
  logic and_778;
  assign and_778 = left_rdata_q[66] & not_576_s1_q;
  logic and_779;
  assign and_779 = right_codes_rdata_q[57] & not_576_s1_q;
  logic [11:0] select_780;
  assign select_780 = less_575_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_781;
  assign select_781 = less_575_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_785;
  assign select_785 = and_778 ? (and_779 ? (~(select_780 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_788;
  assign parity_788 = ^select_785[8:6];
  logic parity_791;
  assign parity_791 = ^select_785[11:9];
  // hls/stages/agreement.hpp:221
  logic and_795;
  assign and_795 = left_rdata_q[84] & not_576_s1_q;
  logic and_796;
  assign and_796 = right_codes_rdata_q[72] & not_576_s1_q;
  logic [11:0] select_797;
  assign select_797 = less_575_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_798;
  assign select_798 = less_575_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_802;
  assign select_802 = and_795 ? (and_796 ? (~(select_797 ^ select_798)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_808;
  assign parity_808 = ^select_802[2:0];
  logic parity_811;
  assign parity_811 = ^select_802[5:3];
  logic parity_814;
  assign parity_814 = ^select_802[8:0];
  logic parity_820;
  assign parity_820 = ^select_802[11:9];
  logic parity_823;
  assign parity_823 = ^select_785[2:0];
  logic parity_826;
  assign parity_826 = ^{select_802[11:9], select_785[5:0]};
  logic parity_829;
  assign parity_829 = ^{select_802, select_785, select_762[2:0]};
  logic xor_830;
  assign xor_830 = parity_774 ^ parity_829;
  // hls/stages/count_bits.hpp:23
  logic or_834;
  assign or_834 = (select_762[1:0] == 2'h3) | (select_762[2] & (select_762[0] | select_762[1]));
  // hls/stages/count_bits.hpp:25
  logic or_838;
  assign or_838 = (select_785[7:6] == 2'h3) | (select_785[8] & (select_785[6] | select_785[7]));
  logic or_842;
  assign or_842 = (select_785[10:9] == 2'h3) | (select_785[11] & (select_785[9] | select_785[10]));
  // hls/stages/count_bits.hpp:23
  logic or_850;
  assign or_850 = (select_802[7:6] == 2'h3) | (select_802[8] & (~(select_802[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_854;
  assign or_854 = (select_802[1:0] == 2'h3) | (select_802[2] & (select_802[0] | select_802[1]));
  logic or_858;
  assign or_858 = (select_802[4:3] == 2'h3) | (select_802[5] & (select_802[3] | select_802[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_861;
  assign parity_861 = ^{or_858, or_854, or_850};
  // hls/stages/count_bits.hpp:23
  logic or_865;
  assign or_865 = (select_785[4:3] == 2'h3) | (select_785[5] & (select_785[3] | select_785[4]));
  // hls/stages/count_bits.hpp:25
  logic or_869;
  assign or_869 = (select_802[10:9] == 2'h3) | (select_802[11] & (select_802[9] | select_802[10]));
  logic or_873;
  assign or_873 = (select_785[1:0] == 2'h3) | (select_785[2] & (select_785[0] | select_785[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_876;
  assign parity_876 = ^{or_873, or_869, or_865};
  logic parity_879;
  assign parity_879 = ^{or_873, or_869, or_865, or_858, or_854, or_850, or_842, or_838, or_834};
  // hls/stages/count_bits.hpp:25
  logic and_880;
  assign and_880 = parity_774 & parity_829;
  logic or_884;
  assign or_884 = (parity_768 & parity_771) | ((^select_762[11:9]) & (parity_768 | parity_771));
  logic and_887;
  assign and_887 = (^{select_785[11:6], select_762[2:0]}) & (parity_814 | parity_826);
  logic or_888;
  assign or_888 = (parity_814 & parity_826) | and_887;
  // hls/stages/count_bits.hpp:23
  logic or_895;
  assign or_895 = (select_762[10:9] == 2'h3) | (select_762[11] & (select_762[9] | select_762[10]));
  // hls/stages/count_bits.hpp:25
  logic or_899;
  assign or_899 = (select_762[4:3] == 2'h3) | (select_762[5] & (select_762[3] | select_762[4]));
  logic or_903;
  assign or_903 = (select_762[7:6] == 2'h3) | (select_762[8] & (select_762[6] | select_762[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_906;
  assign parity_906 = ^{or_903, or_899, or_895};
  // hls/stages/count_bits.hpp:25
  logic or_910;
  assign or_910 = (parity_788 & parity_791) | ((^select_762[2:0]) & (parity_788 | parity_791));
  logic or_914;
  assign or_914 = (parity_808 & parity_811) | ((^select_802[8:6]) & (parity_808 | parity_811));
  logic or_918;
  assign or_918 = (parity_820 & parity_823) | ((^select_785[5:3]) & (parity_820 | parity_823));
  // hls/stages/count_bits.hpp:24
  logic parity_921;
  assign parity_921 = ^{or_918, or_914, or_910};
  logic parity_924;
  assign parity_924 = ^{or_918, or_914, or_910, or_903, or_899, or_895, or_888, or_884, and_880};
  logic xor_925;
  assign xor_925 = parity_879 ^ parity_924;
  // hls/stages/count_bits.hpp:25
  logic and_926;
  assign and_926 = parity_879 & parity_924;
  logic or_930;
  assign or_930 = (parity_861 & parity_876) | ((^{or_842, or_838, or_834}) & (parity_861 | parity_876));
  logic or_934;
  assign or_934 = (parity_906 & parity_921) | ((^{or_888, or_884, and_880}) & (parity_906 | parity_921));
  logic or_941;
  assign or_941 = (or_838 & or_842) | (or_834 & (or_838 | or_842));
  logic or_945;
  assign or_945 = (or_854 & or_858) | (or_850 & (or_854 | or_858));
  logic or_949;
  assign or_949 = (or_869 & or_873) | (or_865 & (or_869 | or_873));
  // hls/stages/count_bits.hpp:24
  logic parity_952;
  assign parity_952 = ^{or_949, or_945, or_941};
  // hls/stages/count_bits.hpp:25
  logic or_956;
  assign or_956 = (or_884 & or_888) | (and_880 & (or_884 | or_888));
  logic or_960;
  assign or_960 = (or_899 & or_903) | (or_895 & (or_899 | or_903));
  logic or_964;
  assign or_964 = (or_914 & or_918) | (or_910 & (or_914 | or_918));
  // hls/stages/count_bits.hpp:24
  logic parity_967;
  assign parity_967 = ^{or_964, or_960, or_956};
  logic parity_970;
  assign parity_970 = ^{or_964, or_960, or_956, or_949, or_945, or_941, or_934, or_930, and_926};
  // hls/stages/count_bits.hpp:25
  logic or_974;
  assign or_974 = (parity_952 & parity_967) | ((^{or_934, or_930, and_926}) & (parity_952 | parity_967));
  logic or_978;
  assign or_978 = (or_930 & or_934) | (and_926 & (or_930 | or_934));
  logic or_982;
  assign or_982 = (or_945 & or_949) | (or_941 & (or_945 | or_949));
  logic or_986;
  assign or_986 = (or_960 & or_964) | (or_956 & (or_960 | or_964));
  // hls/stages/count_bits.hpp:24
  logic parity_991;
  assign parity_991 = ^{or_986, or_982, or_978, or_974};
  // hls/stages/count_bits.hpp:25
  logic or_995;
  assign or_995 = (or_982 & or_986) | (or_978 & (or_982 | or_986));
  logic and_996;
  assign and_996 = or_974 & (^{or_986, or_982, or_978});
  // hls/stages/count_bits.hpp:24
  logic xor_997;
  assign xor_997 = or_995 ^ and_996;
  // hls/stages/count_bits.hpp:27
  logic and_998;
  assign and_998 = or_995 & and_996;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_999;
  assign select_999 = equal_586_s1_q ? {and_998, xor_997, parity_991, parity_970, xor_925, xor_830} : 6'h0;
  logic [5:0] column;
  assign column = or_572_s1_q ? 6'h0 : select_999;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1001;
  assign select_1001 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1002;
  assign difference_1002 = {1'b0, column} - {1'b0, select_1001};
  logic [7:0] sum_1004;
  assign sum_1004 = {difference_1002[6], difference_1002} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1008;
  assign select_1008 = and_755 ? (and_779 ? (~(select_757 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1014;
  assign parity_1014 = ^select_1008[5:3];
  logic parity_1017;
  assign parity_1017 = ^select_1008[8:6];
  logic parity_1020;
  assign parity_1020 = ^select_1008[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1027;
  assign select_1027 = and_778 ? (and_796 ? (~(select_780 ^ select_798)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1030;
  assign parity_1030 = ^select_1027[8:6];
  logic parity_1033;
  assign parity_1033 = ^select_1027[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1037;
  assign and_1037 = right_codes_rdata_q[85] & not_576_s1_q;
  logic [11:0] select_1038;
  assign select_1038 = less_575_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1042;
  assign select_1042 = and_795 ? (and_1037 ? (~(select_797 ^ select_1038)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1048;
  assign parity_1048 = ^select_1042[2:0];
  logic parity_1051;
  assign parity_1051 = ^select_1042[5:3];
  logic parity_1054;
  assign parity_1054 = ^select_1042[8:0];
  logic parity_1060;
  assign parity_1060 = ^select_1042[11:9];
  logic parity_1063;
  assign parity_1063 = ^select_1027[2:0];
  logic parity_1066;
  assign parity_1066 = ^{select_1042[11:9], select_1027[5:0]};
  logic parity_1069;
  assign parity_1069 = ^{select_1042, select_1027, select_1008[2:0]};
  logic xor_1070;
  assign xor_1070 = parity_1020 ^ parity_1069;
  // hls/stages/count_bits.hpp:23
  logic or_1074;
  assign or_1074 = (select_1008[1:0] == 2'h3) | (select_1008[2] & (select_1008[0] | select_1008[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1078;
  assign or_1078 = (select_1027[7:6] == 2'h3) | (select_1027[8] & (select_1027[6] | select_1027[7]));
  logic or_1082;
  assign or_1082 = (select_1027[10:9] == 2'h3) | (select_1027[11] & (select_1027[9] | select_1027[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1090;
  assign or_1090 = (select_1042[7:6] == 2'h3) | (select_1042[8] & (~(select_1042[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1094;
  assign or_1094 = (select_1042[1:0] == 2'h3) | (select_1042[2] & (select_1042[0] | select_1042[1]));
  logic or_1098;
  assign or_1098 = (select_1042[4:3] == 2'h3) | (select_1042[5] & (select_1042[3] | select_1042[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1101;
  assign parity_1101 = ^{or_1098, or_1094, or_1090};
  // hls/stages/count_bits.hpp:23
  logic or_1105;
  assign or_1105 = (select_1027[4:3] == 2'h3) | (select_1027[5] & (select_1027[3] | select_1027[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1109;
  assign or_1109 = (select_1042[10:9] == 2'h3) | (select_1042[11] & (select_1042[9] | select_1042[10]));
  logic or_1113;
  assign or_1113 = (select_1027[1:0] == 2'h3) | (select_1027[2] & (select_1027[0] | select_1027[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  logic parity_1119;
  assign parity_1119 = ^{or_1113, or_1109, or_1105, or_1098, or_1094, or_1090, or_1082, or_1078, or_1074};
  // hls/stages/count_bits.hpp:25
  logic and_1120;
  assign and_1120 = parity_1020 & parity_1069;
  logic or_1124;
  assign or_1124 = (parity_1014 & parity_1017) | ((^select_1008[11:9]) & (parity_1014 | parity_1017));
  logic and_1127;
  assign and_1127 = (^{select_1027[11:6], select_1008[2:0]}) & (parity_1054 | parity_1066);
  logic or_1128;
  assign or_1128 = (parity_1054 & parity_1066) | and_1127;
  // hls/stages/count_bits.hpp:23
  logic or_1135;
  assign or_1135 = (select_1008[10:9] == 2'h3) | (select_1008[11] & (select_1008[9] | select_1008[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1139;
  assign or_1139 = (select_1008[4:3] == 2'h3) | (select_1008[5] & (select_1008[3] | select_1008[4]));
  logic or_1143;
  assign or_1143 = (select_1008[7:6] == 2'h3) | (select_1008[8] & (select_1008[6] | select_1008[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1146;
  assign parity_1146 = ^{or_1143, or_1139, or_1135};
  // hls/stages/count_bits.hpp:25
  logic or_1150;
  assign or_1150 = (parity_1030 & parity_1033) | ((^select_1008[2:0]) & (parity_1030 | parity_1033));
  logic or_1154;
  assign or_1154 = (parity_1048 & parity_1051) | ((^select_1042[8:6]) & (parity_1048 | parity_1051));
  logic or_1158;
  assign or_1158 = (parity_1060 & parity_1063) | ((^select_1027[5:3]) & (parity_1060 | parity_1063));
  // hls/stages/count_bits.hpp:24
  logic parity_1161;
  assign parity_1161 = ^{or_1158, or_1154, or_1150};
  logic parity_1164;
  assign parity_1164 = ^{or_1158, or_1154, or_1150, or_1143, or_1139, or_1135, or_1128, or_1124, and_1120};
  logic xor_1165;
  assign xor_1165 = parity_1119 ^ parity_1164;
  // hls/stages/count_bits.hpp:25
  logic and_1166;
  assign and_1166 = parity_1119 & parity_1164;
  logic or_1170;
  assign or_1170 = (parity_1101 & parity_1116) | ((^{or_1082, or_1078, or_1074}) & (parity_1101 | parity_1116));
  logic or_1174;
  assign or_1174 = (parity_1146 & parity_1161) | ((^{or_1128, or_1124, and_1120}) & (parity_1146 | parity_1161));
  logic or_1181;
  assign or_1181 = (or_1078 & or_1082) | (or_1074 & (or_1078 | or_1082));
  logic or_1185;
  assign or_1185 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  logic or_1189;
  assign or_1189 = (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
  // hls/stages/count_bits.hpp:24
  logic parity_1192;
  assign parity_1192 = ^{or_1189, or_1185, or_1181};
  // hls/stages/count_bits.hpp:25
  logic or_1196;
  assign or_1196 = (or_1124 & or_1128) | (and_1120 & (or_1124 | or_1128));
  logic or_1200;
  assign or_1200 = (or_1139 & or_1143) | (or_1135 & (or_1139 | or_1143));
  logic or_1204;
  assign or_1204 = (or_1154 & or_1158) | (or_1150 & (or_1154 | or_1158));
  // hls/stages/count_bits.hpp:24
  logic parity_1207;
  assign parity_1207 = ^{or_1204, or_1200, or_1196};
  logic parity_1210;
  assign parity_1210 = ^{or_1204, or_1200, or_1196, or_1189, or_1185, or_1181, or_1174, or_1170, and_1166};
  // hls/stages/count_bits.hpp:25
  logic or_1214;
  assign or_1214 = (parity_1192 & parity_1207) | ((^{or_1174, or_1170, and_1166}) & (parity_1192 | parity_1207));
  logic or_1218;
  assign or_1218 = (or_1170 & or_1174) | (and_1166 & (or_1170 | or_1174));
  logic or_1222;
  assign or_1222 = (or_1185 & or_1189) | (or_1181 & (or_1185 | or_1189));
  logic or_1226;
  assign or_1226 = (or_1200 & or_1204) | (or_1196 & (or_1200 | or_1204));
  // hls/stages/count_bits.hpp:24
  logic parity_1231;
  assign parity_1231 = ^{or_1226, or_1222, or_1218, or_1214};
  // hls/stages/count_bits.hpp:25
  logic or_1235;
  assign or_1235 = (or_1222 & or_1226) | (or_1218 & (or_1222 | or_1226));
  logic and_1236;
  assign and_1236 = or_1214 & (^{or_1226, or_1222, or_1218});
  // hls/stages/count_bits.hpp:24
  logic xor_1237;
  assign xor_1237 = or_1235 ^ and_1236;
  // hls/stages/count_bits.hpp:27
  logic and_1238;
  assign and_1238 = or_1235 & and_1236;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1239;
  assign select_1239 = equal_586_s1_q ? {and_1238, xor_1237, parity_1231, parity_1210, xor_1165, xor_1070} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_572_s1_q ? 6'h0 : select_1239;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1241;
  assign select_1241 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1242;
  assign difference_1242 = {1'b0, column_2} - {1'b0, select_1241};
  logic [7:0] sum_1244;
  assign sum_1244 = {difference_1242[6], difference_1242} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1245;
  assign and_1245 = right_codes_rdata_q[27] & not_576_s1_q;
  logic [11:0] select_1246;
  assign select_1246 = less_575_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1250;
  assign select_1250 = and_755 ? (and_1245 ? (~(select_757 ^ select_1246)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1256;
  assign parity_1256 = ^select_1250[5:3];
  logic parity_1259;
  assign parity_1259 = ^select_1250[8:6];
  logic parity_1262;
  assign parity_1262 = ^select_1250[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1269;
  assign select_1269 = and_778 ? (and_756 ? (~(select_780 ^ select_758)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1272;
  assign parity_1272 = ^select_1269[8:6];
  logic parity_1275;
  assign parity_1275 = ^select_1269[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1282;
  assign select_1282 = and_795 ? (and_779 ? (~(select_797 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1288;
  assign parity_1288 = ^select_1282[2:0];
  logic parity_1291;
  assign parity_1291 = ^select_1282[5:3];
  logic parity_1294;
  assign parity_1294 = ^select_1282[8:0];
  logic parity_1300;
  assign parity_1300 = ^select_1282[11:9];
  logic parity_1303;
  assign parity_1303 = ^select_1269[2:0];
  logic parity_1306;
  assign parity_1306 = ^{select_1282[11:9], select_1269[5:0]};
  logic parity_1309;
  assign parity_1309 = ^{select_1282, select_1269, select_1250[2:0]};
  logic xor_1310;
  assign xor_1310 = parity_1262 ^ parity_1309;
  // hls/stages/count_bits.hpp:23
  logic or_1314;
  assign or_1314 = (select_1250[1:0] == 2'h3) | (select_1250[2] & (select_1250[0] | select_1250[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1318;
  assign or_1318 = (select_1269[7:6] == 2'h3) | (select_1269[8] & (select_1269[6] | select_1269[7]));
  logic or_1322;
  assign or_1322 = (select_1269[10:9] == 2'h3) | (select_1269[11] & (select_1269[9] | select_1269[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1330;
  assign or_1330 = (select_1282[7:6] == 2'h3) | (select_1282[8] & (~(select_1282[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1334;
  assign or_1334 = (select_1282[1:0] == 2'h3) | (select_1282[2] & (select_1282[0] | select_1282[1]));
  logic or_1338;
  assign or_1338 = (select_1282[4:3] == 2'h3) | (select_1282[5] & (select_1282[3] | select_1282[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1341;
  assign parity_1341 = ^{or_1338, or_1334, or_1330};
  // hls/stages/count_bits.hpp:23
  logic or_1345;
  assign or_1345 = (select_1269[4:3] == 2'h3) | (select_1269[5] & (select_1269[3] | select_1269[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1349;
  assign or_1349 = (select_1282[10:9] == 2'h3) | (select_1282[11] & (select_1282[9] | select_1282[10]));
  logic or_1353;
  assign or_1353 = (select_1269[1:0] == 2'h3) | (select_1269[2] & (select_1269[0] | select_1269[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1356;
  assign parity_1356 = ^{or_1353, or_1349, or_1345};
  logic parity_1359;
  assign parity_1359 = ^{or_1353, or_1349, or_1345, or_1338, or_1334, or_1330, or_1322, or_1318, or_1314};
  // hls/stages/count_bits.hpp:25
  logic and_1360;
  assign and_1360 = parity_1262 & parity_1309;
  logic or_1364;
  assign or_1364 = (parity_1256 & parity_1259) | ((^select_1250[11:9]) & (parity_1256 | parity_1259));
  logic and_1367;
  assign and_1367 = (^{select_1269[11:6], select_1250[2:0]}) & (parity_1294 | parity_1306);
  logic or_1368;
  assign or_1368 = (parity_1294 & parity_1306) | and_1367;
  // hls/stages/count_bits.hpp:23
  logic or_1375;
  assign or_1375 = (select_1250[10:9] == 2'h3) | (select_1250[11] & (select_1250[9] | select_1250[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1379;
  assign or_1379 = (select_1250[4:3] == 2'h3) | (select_1250[5] & (select_1250[3] | select_1250[4]));
  logic or_1383;
  assign or_1383 = (select_1250[7:6] == 2'h3) | (select_1250[8] & (select_1250[6] | select_1250[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1386;
  assign parity_1386 = ^{or_1383, or_1379, or_1375};
  // hls/stages/count_bits.hpp:25
  logic or_1390;
  assign or_1390 = (parity_1272 & parity_1275) | ((^select_1250[2:0]) & (parity_1272 | parity_1275));
  logic or_1394;
  assign or_1394 = (parity_1288 & parity_1291) | ((^select_1282[8:6]) & (parity_1288 | parity_1291));
  logic or_1398;
  assign or_1398 = (parity_1300 & parity_1303) | ((^select_1269[5:3]) & (parity_1300 | parity_1303));
  // hls/stages/count_bits.hpp:24
  logic parity_1401;
  assign parity_1401 = ^{or_1398, or_1394, or_1390};
  logic parity_1404;
  assign parity_1404 = ^{or_1398, or_1394, or_1390, or_1383, or_1379, or_1375, or_1368, or_1364, and_1360};
  logic xor_1405;
  assign xor_1405 = parity_1359 ^ parity_1404;
  // hls/stages/count_bits.hpp:25
  logic and_1406;
  assign and_1406 = parity_1359 & parity_1404;
  logic or_1410;
  assign or_1410 = (parity_1341 & parity_1356) | ((^{or_1322, or_1318, or_1314}) & (parity_1341 | parity_1356));
  logic or_1414;
  assign or_1414 = (parity_1386 & parity_1401) | ((^{or_1368, or_1364, and_1360}) & (parity_1386 | parity_1401));
  logic or_1421;
  assign or_1421 = (or_1318 & or_1322) | (or_1314 & (or_1318 | or_1322));
  logic or_1425;
  assign or_1425 = (or_1334 & or_1338) | (or_1330 & (or_1334 | or_1338));
  logic or_1429;
  assign or_1429 = (or_1349 & or_1353) | (or_1345 & (or_1349 | or_1353));
  // hls/stages/count_bits.hpp:24
  logic parity_1432;
  assign parity_1432 = ^{or_1429, or_1425, or_1421};
  // hls/stages/count_bits.hpp:25
  logic or_1436;
  assign or_1436 = (or_1364 & or_1368) | (and_1360 & (or_1364 | or_1368));
  logic or_1440;
  assign or_1440 = (or_1379 & or_1383) | (or_1375 & (or_1379 | or_1383));
  logic or_1444;
  assign or_1444 = (or_1394 & or_1398) | (or_1390 & (or_1394 | or_1398));
  // hls/stages/count_bits.hpp:24
  logic parity_1447;
  assign parity_1447 = ^{or_1444, or_1440, or_1436};
  logic parity_1450;
  assign parity_1450 = ^{or_1444, or_1440, or_1436, or_1429, or_1425, or_1421, or_1414, or_1410, and_1406};
  // hls/stages/count_bits.hpp:25
  logic or_1454;
  assign or_1454 = (parity_1432 & parity_1447) | ((^{or_1414, or_1410, and_1406}) & (parity_1432 | parity_1447));
  logic or_1458;
  assign or_1458 = (or_1410 & or_1414) | (and_1406 & (or_1410 | or_1414));
  logic or_1462;
  assign or_1462 = (or_1425 & or_1429) | (or_1421 & (or_1425 | or_1429));
  logic or_1466;
  assign or_1466 = (or_1440 & or_1444) | (or_1436 & (or_1440 | or_1444));
  // hls/stages/count_bits.hpp:24
  logic parity_1471;
  assign parity_1471 = ^{or_1466, or_1462, or_1458, or_1454};
  // hls/stages/count_bits.hpp:25
  logic or_1475;
  assign or_1475 = (or_1462 & or_1466) | (or_1458 & (or_1462 | or_1466));
  logic and_1476;
  assign and_1476 = or_1454 & (^{or_1466, or_1462, or_1458});
  // hls/stages/count_bits.hpp:24
  logic xor_1477;
  assign xor_1477 = or_1475 ^ and_1476;
  // hls/stages/count_bits.hpp:27
  logic and_1478;
  assign and_1478 = or_1475 & and_1476;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1479;
  assign select_1479 = equal_586_s1_q ? {and_1478, xor_1477, parity_1471, parity_1450, xor_1405, xor_1310} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_572_s1_q ? 6'h0 : select_1479;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1481;
  assign select_1481 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1482;
  assign difference_1482 = {1'b0, column_3} - {1'b0, select_1481};
  logic [7:0] sum_1484;
  assign sum_1484 = {difference_1482[6], difference_1482} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1492;
  assign select_1492 = and_755 ? (and_796 ? (~(select_757 ^ select_798)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1498;
  assign parity_1498 = ^select_1492[5:3];
  logic parity_1501;
  assign parity_1501 = ^select_1492[8:6];
  logic parity_1504;
  assign parity_1504 = ^select_1492[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1511;
  assign select_1511 = and_778 ? (and_1037 ? (~(select_780 ^ select_1038)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1514;
  assign parity_1514 = ^select_1511[8:6];
  logic parity_1517;
  assign parity_1517 = ^select_1511[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] xor_1523;
  assign xor_1523 = select_797 ^ (less_575_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1526;
  assign select_1526 = and_795 ? ((right_codes_rdata_q[98] & not_576_s1_q) ? (~xor_1523) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1532;
  assign parity_1532 = ^select_1526[2:0];
  logic parity_1535;
  assign parity_1535 = ^select_1526[5:3];
  logic parity_1538;
  assign parity_1538 = ^select_1526[8:0];
  logic parity_1544;
  assign parity_1544 = ^select_1526[11:9];
  logic parity_1547;
  assign parity_1547 = ^select_1511[2:0];
  logic parity_1550;
  assign parity_1550 = ^{select_1526[11:9], select_1511[5:0]};
  logic parity_1553;
  assign parity_1553 = ^{select_1526, select_1511, select_1492[2:0]};
  logic xor_1554;
  assign xor_1554 = parity_1504 ^ parity_1553;
  // hls/stages/count_bits.hpp:23
  logic or_1558;
  assign or_1558 = (select_1492[1:0] == 2'h3) | (select_1492[2] & (select_1492[0] | select_1492[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1562;
  assign or_1562 = (select_1511[7:6] == 2'h3) | (select_1511[8] & (select_1511[6] | select_1511[7]));
  logic or_1566;
  assign or_1566 = (select_1511[10:9] == 2'h3) | (select_1511[11] & (select_1511[9] | select_1511[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1574;
  assign or_1574 = (select_1526[7:6] == 2'h3) | (select_1526[8] & (~(select_1526[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1578;
  assign or_1578 = (select_1526[1:0] == 2'h3) | (select_1526[2] & (select_1526[0] | select_1526[1]));
  logic or_1582;
  assign or_1582 = (select_1526[4:3] == 2'h3) | (select_1526[5] & (select_1526[3] | select_1526[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1585;
  assign parity_1585 = ^{or_1582, or_1578, or_1574};
  // hls/stages/count_bits.hpp:23
  logic or_1589;
  assign or_1589 = (select_1511[4:3] == 2'h3) | (select_1511[5] & (select_1511[3] | select_1511[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1593;
  assign or_1593 = (select_1526[10:9] == 2'h3) | (select_1526[11] & (select_1526[9] | select_1526[10]));
  logic or_1597;
  assign or_1597 = (select_1511[1:0] == 2'h3) | (select_1511[2] & (select_1511[0] | select_1511[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1600;
  assign parity_1600 = ^{or_1597, or_1593, or_1589};
  logic parity_1603;
  assign parity_1603 = ^{or_1597, or_1593, or_1589, or_1582, or_1578, or_1574, or_1566, or_1562, or_1558};
  // hls/stages/count_bits.hpp:25
  logic and_1604;
  assign and_1604 = parity_1504 & parity_1553;
  logic or_1608;
  assign or_1608 = (parity_1498 & parity_1501) | ((^select_1492[11:9]) & (parity_1498 | parity_1501));
  logic and_1611;
  assign and_1611 = (^{select_1511[11:6], select_1492[2:0]}) & (parity_1538 | parity_1550);
  logic or_1612;
  assign or_1612 = (parity_1538 & parity_1550) | and_1611;
  // hls/stages/count_bits.hpp:23
  logic or_1619;
  assign or_1619 = (select_1492[10:9] == 2'h3) | (select_1492[11] & (select_1492[9] | select_1492[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1623;
  assign or_1623 = (select_1492[4:3] == 2'h3) | (select_1492[5] & (select_1492[3] | select_1492[4]));
  logic or_1627;
  assign or_1627 = (select_1492[7:6] == 2'h3) | (select_1492[8] & (select_1492[6] | select_1492[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1630;
  assign parity_1630 = ^{or_1627, or_1623, or_1619};
  // hls/stages/count_bits.hpp:25
  logic or_1634;
  assign or_1634 = (parity_1514 & parity_1517) | ((^select_1492[2:0]) & (parity_1514 | parity_1517));
  logic or_1638;
  assign or_1638 = (parity_1532 & parity_1535) | ((^select_1526[8:6]) & (parity_1532 | parity_1535));
  logic or_1642;
  assign or_1642 = (parity_1544 & parity_1547) | ((^select_1511[5:3]) & (parity_1544 | parity_1547));
  // hls/stages/count_bits.hpp:24
  logic parity_1645;
  assign parity_1645 = ^{or_1642, or_1638, or_1634};
  logic parity_1648;
  assign parity_1648 = ^{or_1642, or_1638, or_1634, or_1627, or_1623, or_1619, or_1612, or_1608, and_1604};
  logic xor_1649;
  assign xor_1649 = parity_1603 ^ parity_1648;
  // hls/stages/count_bits.hpp:25
  logic and_1650;
  assign and_1650 = parity_1603 & parity_1648;
  logic or_1654;
  assign or_1654 = (parity_1585 & parity_1600) | ((^{or_1566, or_1562, or_1558}) & (parity_1585 | parity_1600));
  logic or_1658;
  assign or_1658 = (parity_1630 & parity_1645) | ((^{or_1612, or_1608, and_1604}) & (parity_1630 | parity_1645));
  logic or_1665;
  assign or_1665 = (or_1562 & or_1566) | (or_1558 & (or_1562 | or_1566));
  logic or_1669;
  assign or_1669 = (or_1578 & or_1582) | (or_1574 & (or_1578 | or_1582));
  logic or_1673;
  assign or_1673 = (or_1593 & or_1597) | (or_1589 & (or_1593 | or_1597));
  // hls/stages/count_bits.hpp:24
  logic parity_1676;
  assign parity_1676 = ^{or_1673, or_1669, or_1665};
  // hls/stages/count_bits.hpp:25
  logic or_1680;
  assign or_1680 = (or_1608 & or_1612) | (and_1604 & (or_1608 | or_1612));
  logic or_1684;
  assign or_1684 = (or_1623 & or_1627) | (or_1619 & (or_1623 | or_1627));
  logic or_1688;
  assign or_1688 = (or_1638 & or_1642) | (or_1634 & (or_1638 | or_1642));
  // hls/stages/count_bits.hpp:24
  logic parity_1691;
  assign parity_1691 = ^{or_1688, or_1684, or_1680};
  logic parity_1694;
  assign parity_1694 = ^{or_1688, or_1684, or_1680, or_1673, or_1669, or_1665, or_1658, or_1654, and_1650};
  // hls/stages/count_bits.hpp:25
  logic or_1698;
  assign or_1698 = (parity_1676 & parity_1691) | ((^{or_1658, or_1654, and_1650}) & (parity_1676 | parity_1691));
  logic or_1702;
  assign or_1702 = (or_1654 & or_1658) | (and_1650 & (or_1654 | or_1658));
  logic or_1706;
  assign or_1706 = (or_1669 & or_1673) | (or_1665 & (or_1669 | or_1673));
  logic or_1710;
  assign or_1710 = (or_1684 & or_1688) | (or_1680 & (or_1684 | or_1688));
  // hls/stages/count_bits.hpp:24
  logic parity_1715;
  assign parity_1715 = ^{or_1710, or_1706, or_1702, or_1698};
  // hls/stages/count_bits.hpp:25
  logic or_1719;
  assign or_1719 = (or_1706 & or_1710) | (or_1702 & (or_1706 | or_1710));
  logic and_1720;
  assign and_1720 = or_1698 & (^{or_1710, or_1706, or_1702});
  // hls/stages/count_bits.hpp:24
  logic xor_1721;
  assign xor_1721 = or_1719 ^ and_1720;
  // hls/stages/count_bits.hpp:27
  logic and_1722;
  assign and_1722 = or_1719 & and_1720;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1723;
  assign select_1723 = equal_586_s1_q ? {and_1722, xor_1721, parity_1715, parity_1694, xor_1649, xor_1554} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_572_s1_q ? 6'h0 : select_1723;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1725;
  assign select_1725 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1726;
  assign difference_1726 = {1'b0, column_4} - {1'b0, select_1725};
  logic [7:0] sum_1728;
  assign sum_1728 = {difference_1726[6], difference_1726} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] not_1732;
  assign not_1732 = ~(select_757 ^ (less_575_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1734;
  assign select_1734 = and_755 ? ((right_codes_rdata_q[12] & not_576_s1_q) ? not_1732 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1740;
  assign parity_1740 = ^select_1734[5:3];
  logic parity_1743;
  assign parity_1743 = ^select_1734[8:6];
  logic parity_1746;
  assign parity_1746 = ^select_1734[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1753;
  assign select_1753 = and_778 ? (and_1245 ? (~(select_780 ^ select_1246)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1756;
  assign parity_1756 = ^select_1753[8:6];
  logic parity_1759;
  assign parity_1759 = ^select_1753[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1766;
  assign select_1766 = and_795 ? (and_756 ? (~(select_797 ^ select_758)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1772;
  assign parity_1772 = ^select_1766[2:0];
  logic parity_1775;
  assign parity_1775 = ^select_1766[5:3];
  logic parity_1778;
  assign parity_1778 = ^select_1766[8:0];
  logic parity_1784;
  assign parity_1784 = ^select_1766[11:9];
  logic parity_1787;
  assign parity_1787 = ^select_1753[2:0];
  logic parity_1790;
  assign parity_1790 = ^{select_1766[11:9], select_1753[5:0]};
  logic parity_1793;
  assign parity_1793 = ^{select_1766, select_1753, select_1734[2:0]};
  logic xor_1794;
  assign xor_1794 = parity_1746 ^ parity_1793;
  // hls/stages/count_bits.hpp:23
  logic or_1798;
  assign or_1798 = (select_1734[1:0] == 2'h3) | (select_1734[2] & (select_1734[0] | select_1734[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1802;
  assign or_1802 = (select_1753[7:6] == 2'h3) | (select_1753[8] & (select_1753[6] | select_1753[7]));
  logic or_1806;
  assign or_1806 = (select_1753[10:9] == 2'h3) | (select_1753[11] & (select_1753[9] | select_1753[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1814;
  assign or_1814 = (select_1766[7:6] == 2'h3) | (select_1766[8] & (~(select_1766[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1818;
  assign or_1818 = (select_1766[1:0] == 2'h3) | (select_1766[2] & (select_1766[0] | select_1766[1]));
  logic or_1822;
  assign or_1822 = (select_1766[4:3] == 2'h3) | (select_1766[5] & (select_1766[3] | select_1766[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1825;
  assign parity_1825 = ^{or_1822, or_1818, or_1814};
  // hls/stages/count_bits.hpp:23
  logic or_1829;
  assign or_1829 = (select_1753[4:3] == 2'h3) | (select_1753[5] & (select_1753[3] | select_1753[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1833;
  assign or_1833 = (select_1766[10:9] == 2'h3) | (select_1766[11] & (select_1766[9] | select_1766[10]));
  logic or_1837;
  assign or_1837 = (select_1753[1:0] == 2'h3) | (select_1753[2] & (select_1753[0] | select_1753[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1840;
  assign parity_1840 = ^{or_1837, or_1833, or_1829};
  logic parity_1843;
  assign parity_1843 = ^{or_1837, or_1833, or_1829, or_1822, or_1818, or_1814, or_1806, or_1802, or_1798};
  // hls/stages/count_bits.hpp:25
  logic and_1844;
  assign and_1844 = parity_1746 & parity_1793;
  logic or_1848;
  assign or_1848 = (parity_1740 & parity_1743) | ((^select_1734[11:9]) & (parity_1740 | parity_1743));
  logic and_1851;
  assign and_1851 = (^{select_1753[11:6], select_1734[2:0]}) & (parity_1778 | parity_1790);
  logic or_1852;
  assign or_1852 = (parity_1778 & parity_1790) | and_1851;
  // hls/stages/count_bits.hpp:23
  logic or_1859;
  assign or_1859 = (select_1734[10:9] == 2'h3) | (select_1734[11] & (select_1734[9] | select_1734[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1863;
  assign or_1863 = (select_1734[4:3] == 2'h3) | (select_1734[5] & (select_1734[3] | select_1734[4]));
  logic or_1867;
  assign or_1867 = (select_1734[7:6] == 2'h3) | (select_1734[8] & (select_1734[6] | select_1734[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1870;
  assign parity_1870 = ^{or_1867, or_1863, or_1859};
  // hls/stages/count_bits.hpp:25
  logic or_1874;
  assign or_1874 = (parity_1756 & parity_1759) | ((^select_1734[2:0]) & (parity_1756 | parity_1759));
  logic or_1878;
  assign or_1878 = (parity_1772 & parity_1775) | ((^select_1766[8:6]) & (parity_1772 | parity_1775));
  logic or_1882;
  assign or_1882 = (parity_1784 & parity_1787) | ((^select_1753[5:3]) & (parity_1784 | parity_1787));
  // hls/stages/count_bits.hpp:24
  logic parity_1885;
  assign parity_1885 = ^{or_1882, or_1878, or_1874};
  logic parity_1888;
  assign parity_1888 = ^{or_1882, or_1878, or_1874, or_1867, or_1863, or_1859, or_1852, or_1848, and_1844};
  logic xor_1889;
  assign xor_1889 = parity_1843 ^ parity_1888;
  // hls/stages/count_bits.hpp:25
  logic and_1890;
  assign and_1890 = parity_1843 & parity_1888;
  logic or_1894;
  assign or_1894 = (parity_1825 & parity_1840) | ((^{or_1806, or_1802, or_1798}) & (parity_1825 | parity_1840));
  logic or_1898;
  assign or_1898 = (parity_1870 & parity_1885) | ((^{or_1852, or_1848, and_1844}) & (parity_1870 | parity_1885));
  logic or_1905;
  assign or_1905 = (or_1802 & or_1806) | (or_1798 & (or_1802 | or_1806));
  logic or_1909;
  assign or_1909 = (or_1818 & or_1822) | (or_1814 & (or_1818 | or_1822));
  logic or_1913;
  assign or_1913 = (or_1833 & or_1837) | (or_1829 & (or_1833 | or_1837));
  // hls/stages/count_bits.hpp:24
  logic parity_1916;
  assign parity_1916 = ^{or_1913, or_1909, or_1905};
  // hls/stages/count_bits.hpp:25
  logic or_1920;
  assign or_1920 = (or_1848 & or_1852) | (and_1844 & (or_1848 | or_1852));
  logic or_1924;
  assign or_1924 = (or_1863 & or_1867) | (or_1859 & (or_1863 | or_1867));
  logic or_1928;
  assign or_1928 = (or_1878 & or_1882) | (or_1874 & (or_1878 | or_1882));
  // hls/stages/count_bits.hpp:24
  logic parity_1931;
  assign parity_1931 = ^{or_1928, or_1924, or_1920};
  logic parity_1934;
  assign parity_1934 = ^{or_1928, or_1924, or_1920, or_1913, or_1909, or_1905, or_1898, or_1894, and_1890};
  // hls/stages/count_bits.hpp:25
  logic or_1938;
  assign or_1938 = (parity_1916 & parity_1931) | ((^{or_1898, or_1894, and_1890}) & (parity_1916 | parity_1931));
  logic or_1942;
  assign or_1942 = (or_1894 & or_1898) | (and_1890 & (or_1894 | or_1898));
  logic or_1946;
  assign or_1946 = (or_1909 & or_1913) | (or_1905 & (or_1909 | or_1913));
  logic or_1950;
  assign or_1950 = (or_1924 & or_1928) | (or_1920 & (or_1924 | or_1928));
  // hls/stages/count_bits.hpp:24
  logic parity_1955;
  assign parity_1955 = ^{or_1950, or_1946, or_1942, or_1938};
  // hls/stages/count_bits.hpp:25
  logic or_1959;
  assign or_1959 = (or_1946 & or_1950) | (or_1942 & (or_1946 | or_1950));
  logic and_1960;
  assign and_1960 = or_1938 & (^{or_1950, or_1946, or_1942});
  // hls/stages/count_bits.hpp:24
  logic xor_1961;
  assign xor_1961 = or_1959 ^ and_1960;
  // hls/stages/count_bits.hpp:27
  logic and_1962;
  assign and_1962 = or_1959 & and_1960;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1963;
  assign select_1963 = equal_586_s1_q ? {and_1962, xor_1961, parity_1955, parity_1934, xor_1889, xor_1794} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_572_s1_q ? 6'h0 : select_1963;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1965;
  assign select_1965 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1966;
  assign difference_1966 = {1'b0, column_5} - {1'b0, select_1965};
  logic [7:0] sum_1968;
  assign sum_1968 = {difference_1966[6], difference_1966} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_2039;
  assign and_2039 = ends_cell_s1_q & inside_v;
  logic and_2041;
  assign and_2041 = not_568 & (so_s1_q & and_2039);
  logic [6:0] select_2045;
  assign select_2045 = so_s1_q ? x_s1_q[6:0] : (or_572_s1_q ? (less_575_s1_q ? 7'h0 : select_619) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2049;
  assign or_2049 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2058;
  assign and_2058 = or_572_s1_q & (slot_s1_q[2] & not_576_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2174;
  assign select_2174 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2174[16:7])) ? 8'h7f : select_2174[7:0];
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_2251_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2251_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:501
  logic less_2338;
  assign less_2338 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:502
  logic or_2339;
  assign or_2339 = equal_2250_s1_q | less_2338;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2344;
  assign select_2344 = equal_2250_s1_q ? patches_column_s1_q[0] : (or_2339 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2345;
  assign not_2345 = ~or_2339;
  // hls/stages/patches.hpp:502
  logic [4:0] sum_2346;
  assign sum_2346 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:504
  logic [4:0] select_2349;
  assign select_2349 = or_2339 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2346) + 5'h1) : sum_2346;
  // hls/stages/patches.hpp:506
  logic [4:0] select_2350;
  assign select_2350 = equal_2250_s1_q ? 5'h0 : select_2349;
  logic or_2351;
  assign or_2351 = equal_2250_s1_q | equal_2248_s1_q;
  // hls/stages/patches.hpp:482
  logic equal_2353;
  assign equal_2353 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2355;
  assign equal_2355 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_2357;
  assign and_2357 = of_row & (~equal_2355);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2353 ? 2'h3 : {equal_2355, and_2357};
  // hls/stages/patches.hpp:470
  logic [8:0] sum_2360;
  assign sum_2360 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2361;
  assign sum_2361 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2360, pixel_2[0]} - {1'b0, sum_2361, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_2363;
  assign sum_2363 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2364;
  assign sum_2364 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2363[11], sum_2363};
  logic [13:0] sum_2365;
  assign sum_2365 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2364, down_2[1]};
  logic [12:0] sum_2366;
  assign sum_2366 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2365[13:1];
  logic [14:0] sum_2367;
  assign sum_2367 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2366, sum_2365[0], down_2[0]};
  // hls/stages/patches.hpp:454
  logic or_2374;
  assign or_2374 = (sum_2367[8] & (~(sum_2367[7:0] == 8'h0))) | (~(sum_2367[13:9] == 5'h0));
  // hls/stages/patches.hpp:468
  logic [8:0] sum_2379;
  assign sum_2379 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2380;
  assign sum_2380 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2379};
  logic [10:0] sum_2381;
  assign sum_2381 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2380, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2382;
  assign sum_2382 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2381[10:1];
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_2382, sum_2381[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:471
  logic [12:0] sum_2384;
  assign sum_2384 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2385;
  assign sum_2385 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2386;
  assign difference_2386 = {1'b0, sum_2384, smooth[0]} - {1'b0, sum_2385, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:454
  logic or_2393;
  assign or_2393 = (difference_2386[8] & (~(difference_2386[7:0] == 8'h0))) | (~(difference_2386[13:9] == 5'h0));
  // hls/stages/patches.hpp:483
  logic or_2401;
  assign or_2401 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2355) | equal_2353;
  // hls/stages/patches.hpp:478
  logic and_2406;
  assign and_2406 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:185
  logic and_2410;
  assign and_2410 = not_2249_s1_q & (or_2252_s1_q & (or_2401 & (equal_2251_s1_q & and_2406)));
  // hls/stages/patches.hpp:173
  logic and_2420;
  assign and_2420 = (~(equal_2251_s1_q | (~and_2406))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:185
  logic and_2424;
  assign and_2424 = not_2249_s1_q & (or_2252_s1_q & (and_2420 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:547
  logic less_2426;
  assign less_2426 = patches_step_q[4:0] < 5'h11;
  logic equal_2427;
  assign equal_2427 = patches_step_q[6:5] == 2'h0;
  logic not_2428;
  assign not_2428 = ~equal_2427;
  logic equal_2429;
  assign equal_2429 = patches_step_q[6:5] == 2'h3;
  logic not_2430;
  assign not_2430 = ~equal_2429;
  // hls/stages/patches.hpp:561
  logic select_2433;
  assign select_2433 = equal_2429 ? (less_2426 & (less_2426 & not_2430)) : less_2426;
  // hls/stages/patches.hpp:185
  logic and_2436;
  assign and_2436 = equal_2246_s1_q & (less_2426 ? (not_2428 & select_2433) : select_2433);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2458;
  assign sum_2458 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2742;
  assign or_2742 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:460
  logic select_3026;
  assign select_3026 = equal_2932_s1_q ? (~({row_s1_q, 1'b0} < {sum_3023, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3270;
  assign and_3270 = and_542_s1_q & (equal_2932_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3271;
  assign and_3271 = and_2933_s1_q & and_3270;
  // hls/stages/registration.hpp:127
  logic and_3273;
  assign and_3273 = and_2933_s1_q & (~and_3270);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3274;
  assign select_3274 = and_3273 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3276;
  assign select_3276 = and_3271 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3274[15]}}, select_3274});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3277;
  assign select_3277 = and_3273 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3277[15]}}, select_3277};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3279;
  assign select_3279 = and_3271 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3280;
  assign and_3280 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3280 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:188
  logic select_3526;
  assign select_3526 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3529;
  assign select_3529 = equal_2248_s1_q ? patches_smooth_values_0_q : (or_2252_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3531;
  assign select_3531 = or_2252_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3533;
  assign select_3533 = equal_2246_s1_q ? patches_smooth_values_1_q : (equal_2248_s1_q ? patches_smooth_values_1_q : select_3531);
  logic [11:0] select_3534;
  assign select_3534 = or_2252_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3536;
  assign select_3536 = equal_2246_s1_q ? patches_smooth_values_2_q : (equal_2248_s1_q ? patches_smooth_values_2_q : select_3534);
  logic [11:0] select_3537;
  assign select_3537 = or_2252_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3539;
  assign select_3539 = equal_2246_s1_q ? patches_smooth_values_3_q : (equal_2248_s1_q ? patches_smooth_values_3_q : select_3537);
  logic [10:0] select_3541;
  assign select_3541 = equal_2248_s1_q ? patches_down_values_0_q : (or_2252_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3544;
  assign select_3544 = equal_2248_s1_q ? patches_down_values_1_q : (or_2252_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3547;
  assign select_3547 = equal_2248_s1_q ? patches_down_values_2_q : (or_2252_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3550;
  assign select_3550 = equal_2248_s1_q ? patches_down_values_3_q : (or_2252_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:176
  logic and_3587;
  assign and_3587 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3592;
  assign select_3592 = or_3487_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3594;
  assign select_3594 = and_3587 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:185
  logic [4:0] select_3950;
  assign select_3950 = equal_2246_s1_q ? patches_summed_down_by_q : (equal_2248_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:557
  logic and_3983;
  assign and_3983 = less_2426 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:561
  logic select_3986;
  assign select_3986 = equal_2429 ? (less_2426 ? (not_2430 & and_3983) : and_3983) : and_3983;
  // hls/stages/patches.hpp:185
  logic select_3989;
  assign select_3989 = equal_2246_s1_q ? (less_2426 ? (not_2428 & select_3986) : select_3986) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4328;
  assign select_4328 = so_s1_q ? (and_3280 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4330;
  assign sum_4330 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4331;
  assign select_4331 = sum_2458[5] ? {1'b1, sum_2458[4:0], region_across_rest_q[2:0]} : sum_4330;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4333;
  assign select_4333 = equal_2932_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4336;
  assign select_4336 = equal_2932_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:235; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_508_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_517;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:349; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s1_2_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_542_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [4:0] moments_memory_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) moments_memory_mem[i] = 5'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_566;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_584;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_572_s1_q ? select_619 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_610_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_2041;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] left_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_turns_mem[i] = 3'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[6:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_2058;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_619;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2058;
  logic [2:0] right_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_word_q <= right_turns_mem[right_turns_raddr];
  end
  logic [1:0] right_turns_rdata_q;
  assign right_turns_rdata_q = right_turns_word_q[1:0];
  logic right_turns_read_q, right_turns_error;
  always_ff @(posedge clk_i) right_turns_read_q <= rst_ni & right_turns_re;
  assign right_turns_error = right_turns_read_q & ^right_turns_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:797; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2350, not_2345, select_2344};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2351;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:798; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [48:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 49'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_2247_s1_q & (new_row & equal_2248_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:812; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 16'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s1_en & and_2436;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1405; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2041;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [17:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[17:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_643_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_744, left_rdata_q[65:49], and_743, left_rdata_q[47:31], and_742, left_rdata_q[29:13], and_741, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {^left_wdata, left_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd80) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd80) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s1_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s1_en & and_643_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_750, right_codes_rdata_q[84:73], and_749, right_codes_rdata_q[71:60], and_748, right_codes_rdata_q[56:43], and_747, right_codes_rdata_q[41:28], and_746, right_codes_rdata_q[26:13], and_745, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {^right_codes_wdata, right_codes_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd80) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd80) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s1_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s1_en & and_2332_s1_q;
  logic [31:0] patches_columns_above_wdata;
  assign patches_columns_above_wdata = {patches_columns_above_rdata_q[23:0], pixel_2};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {^patches_columns_above_wdata, patches_columns_above_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_place_q <= 14'h0;
      moments_taken_q <= 1'b0;
      moments_starts_q <= 1'b0;
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
      patches_step_q <= 7'h0;
      patches_read_searches_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s1_en) begin
      moments_place_q <= select_565;
      moments_taken_q <= not_568 & (not_570 & (equal_571_s1_q & inside_v));
      moments_starts_q <= not_568 & (not_570 & (equal_571_s1_q & (inside_v & first)));
      row_q <= and_542_s1_q ? (equal_2932_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_542_s1_q ? select_3026 : lower_half_q;
      registration_slope_row_q <= select_3276;
      registration_slope_change_q <= select_3279;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3511_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3511_s1_q & select_3526;
      patches_smooth_values_0_q <= equal_2246_s1_q ? patches_smooth_values_0_q : select_3529;
      patches_smooth_values_1_q <= select_3533;
      patches_smooth_values_2_q <= select_3536;
      patches_smooth_values_3_q <= select_3539;
      patches_down_values_0_q <= equal_2246_s1_q ? patches_down_values_0_q : select_3541;
      patches_down_values_1_q <= equal_2246_s1_q ? patches_down_values_1_q : select_3544;
      patches_down_values_2_q <= equal_2246_s1_q ? patches_down_values_2_q : select_3547;
      patches_down_values_3_q <= equal_2246_s1_q ? patches_down_values_3_q : select_3550;
      patches_down_by_q <= or_3487_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3587});
      patches_along_q <= select_3592;
      patches_match_row_q <= or_3487_s1_q ? 4'h0 : select_3594;
      patches_summed_last_q <= not_2247_s1_q & (equal_2248_s1_q & and_3587);
      patches_summed_down_by_q <= select_3950;
      patches_step_q <= or_3487_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3989;
      region_across_rest_q <= select_4328;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4331;
      columns_begin_rest_q <= and_542_s1_q ? select_4333 : columns_begin_rest_q;
      columns_begin_back_q <= and_542_s1_q ? select_4336 : columns_begin_back_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    middle_sum_columns_values_0_q = 6'h0;
    middle_sum_columns_values_1_q = 6'h0;
    middle_sum_columns_values_2_q = 6'h0;
    middle_sum_columns_values_3_q = 6'h0;
    middle_sum_columns_values_4_q = 6'h0;
    middle_sum_columns_values_5_q = 6'h0;
    middle_sum_columns_values_6_q = 6'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_columns_values_0_q = 6'h0;
    sums_0_columns_values_1_q = 6'h0;
    sums_0_columns_values_2_q = 6'h0;
    sums_0_columns_values_3_q = 6'h0;
    sums_0_columns_values_4_q = 6'h0;
    sums_0_columns_values_5_q = 6'h0;
    sums_0_columns_values_6_q = 6'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_1_columns_values_0_q = 6'h0;
    sums_1_columns_values_1_q = 6'h0;
    sums_1_columns_values_2_q = 6'h0;
    sums_1_columns_values_3_q = 6'h0;
    sums_1_columns_values_4_q = 6'h0;
    sums_1_columns_values_5_q = 6'h0;
    sums_1_columns_values_6_q = 6'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_2_columns_values_0_q = 6'h0;
    sums_2_columns_values_1_q = 6'h0;
    sums_2_columns_values_2_q = 6'h0;
    sums_2_columns_values_3_q = 6'h0;
    sums_2_columns_values_4_q = 6'h0;
    sums_2_columns_values_5_q = 6'h0;
    sums_2_columns_values_6_q = 6'h0;
    sums_2_sum_sums_values_0_q = 8'h0;
    sums_3_columns_values_0_q = 6'h0;
    sums_3_columns_values_1_q = 6'h0;
    sums_3_columns_values_2_q = 6'h0;
    sums_3_columns_values_3_q = 6'h0;
    sums_3_columns_values_4_q = 6'h0;
    sums_3_columns_values_5_q = 6'h0;
    sums_3_columns_values_6_q = 6'h0;
    sums_3_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      middle_sum_columns_values_0_q <= column;
      middle_sum_columns_values_1_q <= middle_sum_columns_values_0_q;
      middle_sum_columns_values_2_q <= middle_sum_columns_values_1_q;
      middle_sum_columns_values_3_q <= middle_sum_columns_values_2_q;
      middle_sum_columns_values_4_q <= middle_sum_columns_values_3_q;
      middle_sum_columns_values_5_q <= middle_sum_columns_values_4_q;
      middle_sum_columns_values_6_q <= middle_sum_columns_values_5_q;
      middle_sum_sum_sums_values_0_q <= sum_1004;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1244;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1484;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1728;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1968;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_present_s2_q;
  logic moments_starts_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [6:0] last_s2_q;
  logic [1:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic shift_first_s2_q;
  logic [11:0] registration_slope_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_along_s2_q;
  logic patches_summed_last_s2_q;
  logic [4:0] patches_summed_down_by_s2_q;
  logic [4:0] patches_step_s2_q;
  logic patches_read_searches_s2_q;
  logic [2:0] select_502_s2_q;
  logic [6:0] select_504_s2_q;
  logic [8:0] select_508_s2_q;
  logic and_516_s2_q;
  logic and_517_s2_q;
  logic equal_522_s2_q;
  logic [6:0] last_s2_2_q;
  logic and_540_s2_q;
  logic and_542_s2_q;
  logic equal_562_s2_q;
  logic [12:0] select_566_s2_q;
  logic equal_567_s2_q;
  logic not_568_s2_q;
  logic so_s2_q;
  logic not_570_s2_q;
  logic equal_571_s2_q;
  logic or_572_s2_q;
  logic less_575_s2_q;
  logic not_576_s2_q;
  logic inside_v_s2_q;
  logic not_580_s2_q;
  logic and_584_s2_q;
  logic and_593_s2_q;
  logic and_601_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_632_s2_q;
  logic and_637_s2_q;
  logic and_639_s2_q;
  logic equal_672_s2_q;
  logic and_2028_s2_q;
  logic equal_2029_s2_q;
  logic and_2039_s2_q;
  logic and_2041_s2_q;
  logic [6:0] select_2045_s2_q;
  logic or_2049_s2_q;
  logic and_2142_s2_q;
  logic and_2155_s2_q;
  logic less_2169_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2246_s2_q;
  logic equal_2248_s2_q;
  logic equal_2251_s2_q;
  logic or_2252_s2_q;
  logic [4:0] select_2276_s2_q;
  logic select_2282_s2_q;
  logic [3:0] select_2322_s2_q;
  logic less_2338_s2_q;
  logic new_row_s2_q;
  logic or_2351_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2368_s2_q;
  logic or_2374_s2_q;
  logic and_2378_s2_q;
  logic and_2394_s2_q;
  logic and_2397_s2_q;
  logic and_2411_s2_q;
  logic and_2420_s2_q;
  logic and_2425_s2_q;
  logic less_2426_s2_q;
  logic equal_2427_s2_q;
  logic not_2428_s2_q;
  logic equal_2429_s2_q;
  logic not_2430_s2_q;
  logic sum_2458_s2_q;
  logic and_2479_s2_q;
  logic and_2596_s2_q;
  logic equal_2743_s2_q;
  logic equal_2932_s2_q;
  logic and_3039_s2_q;
  logic equal_3124_s2_q;
  logic less_3563_s2_q;
  logic equal_3906_s2_q;
  logic equal_3990_s2_q;
  logic less_4316_s2_q;
  logic equal_4535_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      moments_starts_s2_q <= moments_starts_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q[2:1];
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      shift_first_s2_q <= shift_first_s1_q;
      registration_slope_s2_q <= registration_slope_q[27:16];
      patches_band_rows_number_s2_q <= patches_band_rows_number_s1_q;
      patches_chooses_s2_q <= patches_chooses_s1_q;
      patches_choosing_band_s2_q <= patches_choosing_band_s1_q;
      patches_lower_s2_q <= patches_lower_s1_q;
      patches_second_s2_q <= patches_second_s1_q;
      patches_code_row_s2_q <= patches_code_row_s1_q;
      patches_along_s2_q <= patches_along_q;
      patches_summed_last_s2_q <= patches_summed_last_q;
      patches_summed_down_by_s2_q <= patches_summed_down_by_q;
      patches_step_s2_q <= patches_step_q[4:0];
      patches_read_searches_s2_q <= patches_read_searches_q;
      select_502_s2_q <= select_502_s1_q;
      select_504_s2_q <= select_504_s1_q;
      select_508_s2_q <= select_508_s1_q;
      and_516_s2_q <= and_516_s1_q;
      and_517_s2_q <= and_517;
      equal_522_s2_q <= equal_522_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_540_s2_q <= and_540_s1_q;
      and_542_s2_q <= and_542_s1_q;
      equal_562_s2_q <= equal_562;
      select_566_s2_q <= select_566;
      equal_567_s2_q <= equal_567_s1_q;
      not_568_s2_q <= not_568;
      so_s2_q <= so_s1_q;
      not_570_s2_q <= not_570;
      equal_571_s2_q <= equal_571_s1_q;
      or_572_s2_q <= or_572_s1_q;
      less_575_s2_q <= less_575_s1_q;
      not_576_s2_q <= not_576_s1_q;
      inside_v_s2_q <= inside_v;
      not_580_s2_q <= not_580;
      and_584_s2_q <= and_584;
      and_593_s2_q <= or_572_s1_q & (left_rdata_q[70] & not_576_s1_q);
      and_601_s2_q <= (or_572_s1_q & (left_rdata_q[68] & not_576_s1_q)) & and_600;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_632_s2_q <= or_572_s1_q & (left_rdata_q[71] & not_576_s1_q);
      and_637_s2_q <= or_572_s1_q & (right_codes_rdata_q[58] & not_576_s1_q);
      and_639_s2_q <= or_572_s1_q & (right_codes_rdata_q[59] & not_576_s1_q);
      equal_672_s2_q <= row_s1_q == 6'h0;
      and_2028_s2_q <= and_2028_s1_q;
      equal_2029_s2_q <= equal_2029_s1_q;
      and_2039_s2_q <= and_2039;
      and_2041_s2_q <= and_2041;
      select_2045_s2_q <= select_2045;
      or_2049_s2_q <= or_2049;
      and_2142_s2_q <= and_2142_s1_q;
      and_2155_s2_q <= and_2155_s1_q;
      less_2169_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2246_s2_q <= equal_2246_s1_q;
      equal_2248_s2_q <= equal_2248_s1_q;
      equal_2251_s2_q <= equal_2251_s1_q;
      or_2252_s2_q <= or_2252_s1_q;
      select_2276_s2_q <= select_2276_s1_q;
      select_2282_s2_q <= select_2282_s1_q;
      select_2322_s2_q <= select_2322_s1_q;
      less_2338_s2_q <= less_2338;
      new_row_s2_q <= new_row;
      or_2351_s2_q <= or_2351;
      of_row_2_s2_q <= of_row_2;
      not_2368_s2_q <= ~sum_2367[14];
      or_2374_s2_q <= or_2374;
      and_2378_s2_q <= sum_2367[14] & (~(sum_2367[13:8] == 6'h3f));
      and_2394_s2_q <= (~difference_2386[14]) & or_2393;
      and_2397_s2_q <= difference_2386[14] & (~(difference_2386[13:8] == 6'h3f));
      and_2411_s2_q <= not_2247_s1_q & and_2410;
      and_2420_s2_q <= and_2420;
      and_2425_s2_q <= not_2247_s1_q & and_2424;
      less_2426_s2_q <= less_2426;
      equal_2427_s2_q <= equal_2427;
      not_2428_s2_q <= not_2428;
      equal_2429_s2_q <= equal_2429;
      not_2430_s2_q <= not_2430;
      sum_2458_s2_q <= sum_2458[5];
      and_2479_s2_q <= or_572_s1_q & (left_rdata_q[69] & not_576_s1_q);
      and_2596_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2743_s2_q <= {last_s1_2_q[6], or_2742} == 7'h0;
      equal_2932_s2_q <= equal_2932_s1_q;
      and_3039_s2_q <= or_572_s1_q & (not_576_s1_q & and_600);
      equal_3124_s2_q <= shift == 6'h0;
      less_3563_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3906_s2_q <= patches_match_row_q == 4'h0;
      equal_3990_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4316_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4535_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
  logic census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] census_columns_values_0_cell_3_left_q;
  logic [8:0] census_columns_values_0_cell_3_right_q;
  logic census_columns_values_0_cell_3_mask_q;
  logic [8:0] census_columns_values_0_cell_4_left_q;
  logic [8:0] census_columns_values_0_cell_4_right_q;
  logic census_columns_values_0_cell_4_mask_q;
  logic [8:0] census_columns_values_1_cell_0_left_q;
  logic [8:0] census_columns_values_1_cell_0_right_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic census_columns_values_3_cell_4_mask_q;
  logic [3:0] census_filled_q;
  logic [13:0] moments_turned_0_q;
  logic [13:0] moments_turned_1_q;
  logic [13:0] moments_before_0_q;
  logic [13:0] moments_before_1_q;
  logic moments_has_before_q;
  logic [13:0] moments_most_before_q;
  logic moments_left_begins_q;
  logic moments_left_alone_q;
  logic moments_left_other_stops_q;
  logic moments_right_begins_q;
  logic moments_right_alone_q;
  logic moments_right_other_stops_q;
  logic moments_out_of_step_q;
  logic moments_turns_0_q;
  logic moments_turns_1_q;
  logic moments_begins_alone_q;
  logic moments_ends_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic shift_allowed_q;
  logic shift_not_right_q;
  logic [13:0] counts_turned_left_q;
  logic [13:0] counts_turned_right_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic [10:0] registration_expected_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [3:0] registration_fresh_q;
  logic [15:0] patches_chance_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic patches_summed_first_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  logic [4:0] patches_read_at_q;
  logic patches_read_first_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_read_far_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [4:0] patches_peak_row_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic [9:0] patches_peak_far_q;
  logic patches_frame_ended_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic proven_q;
  logic drew_q;
  logic said_q;
  logic [16:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/census.hpp:113
  logic [11:0] select_520;
  assign select_520 = select_502_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:126
  logic [11:0] sum_524;
  assign sum_524 = select_520 + (equal_522_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_526;
  assign sum_526 = {4'h0, sample_pair_pixel_1_q} + (select_502_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:126
  logic [11:0] sum_528;
  assign sum_528 = sum_526 + (equal_522_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_502_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:127
  logic and_532;
  assign and_532 = whole & (averager_memory_rdata_q[24] | equal_522_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_502_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:128
  logic and_536;
  assign and_536 = all_of_skin & (averager_memory_rdata_q[25] | equal_522_s2_q);
  // hls/stages/census.hpp:215
  logic [8:0] grey;
  assign grey = and_516_s2_q ? sum_524[11:3] : 9'h0;
  // hls/stages/census.hpp:131
  logic equal_545;
  assign equal_545 = select_502_s2_q == 3'h1;
  // hls/stages/census.hpp:216
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_545 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_548;
  assign select_548 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:215
  logic [8:0] grey_2;
  assign grey_2 = and_516_s2_q ? sum_528[11:3] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_545 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_552;
  assign select_552 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:215
  logic and_553;
  assign and_553 = and_516_s2_q & and_532;
  // hls/stages/census.hpp:131
  logic select_555;
  assign select_555 = equal_545 ? and_553 : (averager_mask_q & and_553);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_555;
  // hls/stages/census.hpp:215
  logic and_557;
  assign and_557 = and_516_s2_q & and_536;
  // hls/stages/census.hpp:131
  logic select_559;
  assign select_559 = equal_545 ? and_557 : (averager_of_skin_q & and_557);
  // hls/stages/agreement.hpp:276
  logic and_560;
  assign and_560 = sample_pair_whole_s2_q & select_559;
  // hls/stages/agreement.hpp:978
  logic select_614;
  assign select_614 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_624;
  assign difference_624 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_625;
  assign sum_625 = {difference_624[8], difference_624} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_627;
  assign and_627 = (and_601_s2_q & select_614) & ({{22{sum_625[9]}}, sum_625} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_629;
  assign and_629 = or_572_s2_q & (not_576_s2_q & and_627);
  // hls/stages/moments.hpp:77
  logic and_630;
  assign and_630 = and_593_s2_q & and_629;
  // hls/stages/census.hpp:305
  logic less_645;
  assign less_645 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_646;
  assign less_646 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_647;
  assign less_647 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_648;
  assign less_648 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:306
  logic less_657;
  assign less_657 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_658;
  assign less_658 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_659;
  assign less_659 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_660;
  assign less_660 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_669;
  assign equal_669 = last_s2_2_q == 7'h0;
  logic [3:0] select_673;
  assign select_673 = equal_672_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_674;
  assign select_674 = equal_669 ? {select_673, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:287
  logic [3:0] select_675;
  assign select_675 = equal_669 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:310
  logic and_676;
  assign and_676 = select_674[4] & select_675[3];
  // hls/stages/census.hpp:297
  logic and_678;
  assign and_678 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_680;
  assign and_680 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_678);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_680;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_q & whole_16;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:281
  logic [9:0] difference_703;
  assign difference_703 = {1'b0, select_548} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_704;
  assign xor_704 = difference_703[8:0] ^ {9{difference_703[9]}};
  logic [9:0] sum_705;
  assign sum_705 = {9'h0, difference_703[9]} + {1'b0, xor_704};
  logic [9:0] difference_706;
  assign difference_706 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_707;
  assign xor_707 = difference_706[8:0] ^ {9{difference_706[9]}};
  logic [9:0] sum_708;
  assign sum_708 = {9'h0, difference_706[9]} + {1'b0, xor_707};
  logic [9:0] difference_710;
  assign difference_710 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_711;
  assign xor_711 = difference_710[8:0] ^ {9{difference_710[9]}};
  logic [9:0] sum_712;
  assign sum_712 = {9'h0, difference_710[9]} + {1'b0, xor_711};
  logic [10:0] sum_713;
  assign sum_713 = ({1'b0, sum_705} + {1'b0, sum_708}) + {1'b0, sum_712};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_715;
  assign xor_715 = difference_714[8:0] ^ {9{difference_714[9]}};
  logic [9:0] sum_716;
  assign sum_716 = {9'h0, difference_714[9]} + {1'b0, xor_715};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_719;
  assign xor_719 = difference_718[8:0] ^ {9{difference_718[9]}};
  // hls/stages/agreement.hpp:456
  logic and_727;
  assign and_727 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_728;
  assign and_728 = and_676 & and_727;
  // hls/stages/census.hpp:317
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_730;
  assign sum_730 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:317
  logic and_732;
  assign and_732 = and_728 & ({{5{sum_730[6]}}, sum_730, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:318
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_736;
  assign sum_736 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_752;
  assign or_752 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_754;
  assign select_754 = or_752 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:751
  logic less_1485;
  assign less_1485 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1486;
  assign select_1486 = less_1485 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1487;
  assign less_1487 = middle_sum_sum_sums_values_0_q < select_1486;
  logic [7:0] select_1488;
  assign select_1488 = less_1487 ? select_1486 : middle_sum_sum_sums_values_0_q;
  logic less_1969;
  assign less_1969 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1970;
  assign select_1970 = less_1969 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1971;
  assign less_1971 = select_1488 < select_1970;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1971 ? select_1970 : select_1488) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1975;
  assign or_1975 = select_754 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1976;
  assign select_1976 = or_1975 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:752
  logic or_1978;
  assign or_1978 = less_1485 | (~less_1487);
  logic [2:0] select_1979;
  assign select_1979 = less_1971 ? {less_1969, 2'h0} : {1'b0, or_1978, less_1487};
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1980;
  assign select_1980 = or_1975 ? select_1979 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1981;
  assign select_1981 = or_1975 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1982;
  assign equal_1982 = select_1979 == 3'h1;
  logic or_1985;
  assign or_1985 = equal_1982 | (~(select_1979 == 3'h2));
  logic [7:0] select_1987;
  assign select_1987 = or_1985 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1988;
  assign select_1988 = equal_1982 ? (or_1985 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1987;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1989;
  assign select_1989 = or_1975 ? select_1988 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1990;
  assign select_1990 = or_1985 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1992;
  assign select_1992 = or_1975 ? (equal_1982 ? select_1987 : select_1990) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1994;
  assign sum_1994 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1995;
  assign sum_1995 = {1'b0, before_v} + sum_1994;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1997;
  assign sum_1997 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1998;
  assign sum_1998 = {1'b0, before_v_2} + sum_1997;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2000;
  assign sum_2000 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_2001;
  assign sum_2001 = {1'b0, before_v_3} + sum_2000;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2003;
  assign select_2003 = (sum_1998 < sum_2001) ? sum_2001 : sum_1998;
  logic [6:0] select_2005;
  assign select_2005 = (sum_1995 < select_2003) ? select_2003 : sum_1995;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2008;
  assign sum_2008 = {1'b0, before_v_4} + sum_2007;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2010;
  assign sum_2010 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2011;
  assign sum_2011 = {1'b0, before_v_5} + sum_2010;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2013;
  assign select_2013 = (sum_2008 < sum_2011) ? sum_2011 : sum_2008;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2005 < select_2013) ? select_2013 : select_2005) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_2017;
  assign less_2017 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_2019;
  assign select_2019 = select_754 ? of_near : (less_2017 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2021;
  assign select_2021 = select_754 ? run_shift_s2_q : (less_2017 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2024;
  assign select_2024 = (run_shift_s2_q == 6'h3f) ? of_best : (select_754 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_2027;
  assign select_2027 = (run_shift_s2_q == 6'h1) ? of_best : (select_754 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_2030;
  assign select_2030 = or_752 ? shift_first_s2_q : equal_2029_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_2032;
  assign or_2032 = select_2030 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2033;
  assign select_2033 = or_2032 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2034;
  assign select_2034 = or_2032 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2036;
  assign or_2036 = select_2030 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_2037;
  assign select_2037 = or_2036 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2038;
  assign select_2038 = or_2036 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2052;
  assign and_2052 = or_572_s2_q & (not_576_s2_q & (and_627 & or_2049_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_2053;
  assign and_2053 = not_570_s2_q & and_2052;
  logic and_2056;
  assign and_2056 = not_568_s2_q & (so_s2_q ? and_2039_s2_q : (equal_571_s2_q & and_629));
  // hls/stages/moments.hpp:73
  logic and_2060;
  assign and_2060 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_2061;
  assign and_2061 = not_580_s2_q & and_2060;
  logic and_2064;
  assign and_2064 = not_580_s2_q & (and_2060 & (moments_memory_rdata_q[1] ^ and_632_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2069;
  assign and_2069 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_2070;
  assign and_2070 = not_580_s2_q & and_2069;
  logic and_2073;
  assign and_2073 = not_580_s2_q & (and_2069 & (moments_memory_rdata_q[3] ^ and_639_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_2074;
  assign equal_2074 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_2077;
  assign select_2077 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_2079;
  assign select_2079 = equal_2074 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2077});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2080;
  assign sum_2080 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2081;
  assign select_2081 = equal_567_s2_q ? select_2079 : {sum_2080, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:211
  logic equal_2082;
  assign equal_2082 = x_s2_q[5:0] == 6'h3f;
  logic equal_2084;
  assign equal_2084 = x_s2_q[5:0] == 6'h3e;
  logic equal_2086;
  assign equal_2086 = x_s2_q[5:0] == 6'h3d;
  logic equal_2088;
  assign equal_2088 = x_s2_q[5:0] == 6'h3c;
  logic equal_2090;
  assign equal_2090 = x_s2_q[5:0] == 6'h3b;
  logic equal_2092;
  assign equal_2092 = x_s2_q[5:0] == 6'h36;
  logic equal_2094;
  assign equal_2094 = x_s2_q[5:0] == 6'h35;
  logic equal_2096;
  assign equal_2096 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_2100;
  assign and_2100 = (~equal_2090) & ((~equal_2092) & ((~equal_2094) & (~equal_2096)));
  logic and_2104;
  assign and_2104 = (~equal_2082) & ((~equal_2084) & ((~equal_2086) & ((~equal_2088) & and_2100)));
  // hls/stages/agreement.hpp:1129
  logic less_2105;
  assign less_2105 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2109;
  assign or_2109 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_2114;
  assign sum_2114 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2114, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2120;
  assign sum_2120 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2122;
  assign and_2122 = half_ends & ({{3{sum_2120[4]}}, sum_2120} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_2123;
  assign and_2123 = so_s2_q & and_2122;
  logic select_2124;
  assign select_2124 = equal_567_s2_q ? (x_s2_q[6] & (equal_2074 ? and_2104 : (less_2105 & (~or_2109)))) : and_2123;
  // hls/stages/registration.hpp:258
  logic not_2126;
  assign not_2126 = ~lower_half_s2_q;
  logic [3:0] select_2127;
  assign select_2127 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2126, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2126};
  // hls/stages/patches.hpp:374
  logic [1:0] select_2156;
  assign select_2156 = and_2155_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2157;
  assign select_2157 = and_2155_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2158;
  assign select_2158 = and_2142_s2_q ? {select_2157, select_2156[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2159;
  assign select_2159 = and_2142_s2_q ? select_2156 : patches_fetch_q;
  logic equal_2160;
  assign equal_2160 = select_2159 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_2168;
  assign and_2168 = not_568_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2170;
  assign equal_2170 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_572_s2_q ? (less_575_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2170 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2178;
  assign select_2178 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2179;
  assign select_2179 = b[1] ? a : 8'h0;
  logic [8:0] sum_2180;
  assign sum_2180 = {{2{select_2178[6]}}, select_2178} + {select_2179[7], select_2179};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2181;
  assign select_2181 = b[2] ? a : 8'h0;
  logic [7:0] select_2182;
  assign select_2182 = b[3] ? a : 8'h0;
  logic [8:0] sum_2183;
  assign sum_2183 = {{2{select_2181[7]}}, select_2181[7:1]} + {select_2182[7], select_2182};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2184;
  assign sum_2184 = {{3{sum_2180[8]}}, sum_2180[8:1]} + {sum_2183[8], sum_2183, select_2181[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2185;
  assign select_2185 = b[4] ? a : 8'h0;
  logic [7:0] select_2186;
  assign select_2186 = b[5] ? a : 8'h0;
  logic [8:0] difference_2187;
  assign difference_2187 = {{2{select_2185[7]}}, select_2185[7:1]} - {select_2186[7], select_2186};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2188;
  assign sum_2188 = {difference_2187, select_2185[0]} + {sum_2184[10], sum_2184[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2170 ? {sum_2188, sum_2184[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2190;
  assign sum_2190 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2193;
  assign and_2193 = less_2169_s2_q & (and_629 & ({{4{sum_2190[9]}}, sum_2190, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2197;
  assign and_2197 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2203;
  assign sum_2203 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2205;
  assign sum_2205 = {sum_2203[9], sum_2203[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_2208;
  assign and_2208 = ($signed(9'h0) < $signed(sum_2203[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2205, sum_2203[0]})));
  logic and_2209;
  assign and_2209 = (~(and_2197 | (equal_562_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2208;
  // hls/stages/agreement.hpp:788
  logic and_2213;
  assign and_2213 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2193 & and_2209)));
  logic and_2214;
  assign and_2214 = not_568_s2_q & and_2213;
  // hls/stages/patches.hpp:157
  logic and_2216;
  assign and_2216 = and_2214 & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_2217;
  assign select_2217 = and_2216 ? and_2214 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2220;
  assign select_2220 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_2222;
  assign select_2222 = and_2216 ? (equal_567_s2_q ? 8'h0 : select_2220) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2225;
  assign select_2225 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:345
  logic [5:0] select_2227;
  assign select_2227 = and_2216 ? (equal_567_s2_q ? 6'h0 : select_2225) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2228;
  assign sum_2228 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2188[9]}}, sum_2188[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2231;
  assign select_2231 = ($signed(sum_2228[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2228[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2170 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2228[12:7])) ? 8'h7f : select_2231);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2236;
  assign select_2236 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_2238;
  assign select_2238 = and_2216 ? (equal_567_s2_q ? 8'h0 : select_2236) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2239;
  assign equal_2239 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_2243;
  assign and_2243 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2197 | equal_2239)));
  logic and_2244;
  assign and_2244 = not_568_s2_q & and_2243;
  // hls/stages/patches.hpp:345
  logic and_2245;
  assign and_2245 = patches_chooses_s2_q & and_2244;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2259;
  assign select_2259 = and_2142_s2_q ? select_2157 : patches_band_q;
  // hls/stages/patches.hpp:354
  logic equal_2260;
  assign equal_2260 = {patches_choosing_band_s2_q, and_2168} == {select_2259, select_2159[1]};
  // hls/stages/patches.hpp:487
  logic [2:0] sum_2359;
  assign sum_2359 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_2375;
  assign and_2375 = not_2368_s2_q & or_2374_s2_q;
  // hls/stages/patches.hpp:491
  logic [1:0] sum_2415;
  assign sum_2415 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2445;
  assign select_2445 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2448;
  assign or_2448 = select_2445[7] | (~({select_2445[5], select_2445[3], select_2445[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2451;
  assign or_2451 = select_2445[7] | (~({select_2445[6], select_2445[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2454;
  assign or_2454 = select_2445[7] | (~(select_2445[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2455;
  assign select_2455 = equal_567_s2_q ? x_s2_q[5:0] : {region_row_q, or_2454, or_2451, or_2448};
  // hls/stages/agreement.hpp:1128
  logic not_2456;
  assign not_2456 = ~equal_2074;
  // hls/stages/agreement.hpp:1058
  logic or_2460;
  assign or_2460 = (~sum_2458_s2_q) | equal_2239;
  // hls/stages/agreement.hpp:788
  logic and_2463;
  assign and_2463 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2460));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_572_s2_q & (not_576_s2_q & and_601_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_629;
  // hls/stages/agreement.hpp:149
  logic and_2481;
  assign and_2481 = or_572_s2_q & (not_576_s2_q & and_2479_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2490;
  assign and_2490 = inside_v_s2_q & and_2481;
  // hls/stages/agreement.hpp:1014
  logic select_2491;
  assign select_2491 = slot_s2_q[2] ? shown_shown_q : and_629;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2491);
  // hls/stages/agreement.hpp:1014
  logic select_2494;
  assign select_2494 = slot_s2_q[2] ? shown_nearer_q : and_2052;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2491 ? select_2494 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1275
  logic or_2497;
  assign or_2497 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [16:0] select_2499;
  assign select_2499 = marks_first_s2_q ? 17'h1 : (or_2497 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2501;
  assign select_2501 = or_2497 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2503;
  assign select_2503 = cfg_compete_i ? (or_2497 & select_2499[16]) : (select_2501[8] & select_2499[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2503 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2506;
  assign select_2506 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2508;
  assign select_2508 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2506});
  // hls/stages/agreement.hpp:1301
  logic equal_2509;
  assign equal_2509 = seen_x_q == 3'h7;
  logic [7:0] select_2511;
  assign select_2511 = select_2503 ? 8'h0 : (seen_column_q + {7'h0, equal_2509});
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = select_2508 + {5'h0, select_2511};
  // hls/stages/agreement.hpp:1275
  logic select_2514;
  assign select_2514 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2515;
  assign sum_2515 = {1'b0, select_2514, 2'h0, select_2514, 1'b0, {2{select_2514}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1274
  logic not_2516;
  assign not_2516 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2518;
  assign and_2518 = not_2516 & (began_q | select_2503);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2520;
  assign select_2520 = select_2503 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2522;
  assign and_2522 = and_2518 & (select_2520 == 3'h0);
  logic less_2523;
  assign less_2523 = select_2511 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2526;
  assign sum_2526 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2526[7]}}, sum_2526, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2528;
  assign sum_2528 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2529;
  assign and_2529 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2530;
  assign and_2530 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2531;
  assign and_2531 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2532;
  assign and_2532 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2534;
  assign sum_2534 = {1'b0, and_2531} + ({1'b0, textured} + {1'b0, and_2532});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2529} + ({2'h0, and_2530} + {1'b0, sum_2534});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2543;
  assign select_2543 = inside_v_s2_q ? (sum_2458_s2_q ? select_2445 : {select_2445[6:0], 1'b0}) : select_2445;
  // hls/stages/agreement.hpp:1050
  logic or_2546;
  assign or_2546 = select_2543[7] | (~({select_2543[5], select_2543[3], select_2543[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2563;
  assign and_2563 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2564;
  assign and_2564 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2565;
  assign and_2565 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2566;
  assign and_2566 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2568;
  assign sum_2568 = {1'b0, and_2565} + ({1'b0, shown} + {1'b0, and_2566});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2563} + ({2'h0, and_2564} + {1'b0, sum_2568});
  // hls/stages/agreement.hpp:1030
  logic and_2579;
  assign and_2579 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2580;
  assign and_2580 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2581;
  assign and_2581 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2582;
  assign and_2582 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2584;
  assign sum_2584 = {1'b0, and_2581} + ({1'b0, near} + {1'b0, and_2582});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2579} + ({2'h0, and_2580} + {1'b0, sum_2584});
  // hls/stages/agreement.hpp:788
  logic and_2600;
  assign and_2600 = ends_cell_s2_q & (and_2596_s2_q & (~({sum_2114, last_s2_q[1:0]} < x_s2_q)));
  logic and_2602;
  assign and_2602 = not_568_s2_q & (so_s2_q & and_2600);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2634;
  assign select_2634 = sample_pair_whole_s2_q ? (and_540_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2636;
  assign select_2636 = sample_pair_whole_s2_q ? (and_540_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2656;
  assign select_2656 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2658;
  assign select_2658 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_555 : averager_mask_q) : averager_mask_q;
  logic select_2660;
  assign select_2660 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_559 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2661;
  assign select_2661 = and_542_s2_q ? select_548 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2662;
  assign select_2662 = and_542_s2_q ? select_552 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2664;
  assign select_2664 = and_542_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2665;
  assign select_2665 = and_542_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2666;
  assign select_2666 = and_542_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2667;
  assign select_2667 = and_542_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2668;
  assign select_2668 = and_542_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2669;
  assign select_2669 = and_542_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2670;
  assign select_2670 = and_542_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2671;
  assign select_2671 = and_542_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_542_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2673;
  assign select_2673 = and_542_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_542_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_542_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2676;
  assign select_2676 = and_542_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_542_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_542_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2679;
  assign select_2679 = and_542_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2680;
  assign select_2680 = and_542_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2681;
  assign select_2681 = and_542_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2682;
  assign select_2682 = and_542_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2683;
  assign select_2683 = and_542_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2684;
  assign select_2684 = and_542_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2685;
  assign select_2685 = and_542_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2686;
  assign select_2686 = and_542_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2687;
  assign select_2687 = and_542_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_542_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2689;
  assign select_2689 = and_542_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_542_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_542_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2692;
  assign select_2692 = and_542_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_542_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_542_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2695;
  assign select_2695 = and_542_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2696;
  assign select_2696 = and_542_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2697;
  assign select_2697 = and_542_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2698;
  assign select_2698 = and_542_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2699;
  assign select_2699 = and_542_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2700;
  assign select_2700 = and_542_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2701;
  assign select_2701 = and_542_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2702;
  assign select_2702 = and_542_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2703;
  assign select_2703 = and_542_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2704;
  assign select_2704 = and_542_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2705;
  assign select_2705 = and_542_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2706;
  assign select_2706 = and_542_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2707;
  assign select_2707 = and_542_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2708;
  assign select_2708 = and_542_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2709;
  assign select_2709 = and_542_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2710;
  assign select_2710 = and_542_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2711;
  assign select_2711 = and_542_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2712;
  assign select_2712 = and_542_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2713;
  assign select_2713 = and_542_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2714;
  assign select_2714 = and_542_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2715;
  assign select_2715 = and_542_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2716;
  assign select_2716 = and_542_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2718;
  assign difference_2718 = {1'b0, select_552} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2719;
  assign xor_2719 = difference_2718[8:0] ^ {9{difference_2718[9]}};
  logic [9:0] sum_2720;
  assign sum_2720 = {9'h0, difference_2718[9]} + {1'b0, xor_2719};
  logic [9:0] difference_2721;
  assign difference_2721 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2722;
  assign xor_2722 = difference_2721[8:0] ^ {9{difference_2721[9]}};
  logic [9:0] sum_2723;
  assign sum_2723 = {9'h0, difference_2721[9]} + {1'b0, xor_2722};
  logic [9:0] difference_2725;
  assign difference_2725 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2726;
  assign xor_2726 = difference_2725[8:0] ^ {9{difference_2725[9]}};
  logic [9:0] sum_2727;
  assign sum_2727 = {9'h0, difference_2725[9]} + {1'b0, xor_2726};
  logic [10:0] sum_2728;
  assign sum_2728 = ({1'b0, sum_2720} + {1'b0, sum_2723}) + {1'b0, sum_2727};
  logic [9:0] difference_2729;
  assign difference_2729 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2730;
  assign xor_2730 = difference_2729[8:0] ^ {9{difference_2729[9]}};
  logic [9:0] sum_2731;
  assign sum_2731 = {9'h0, difference_2729[9]} + {1'b0, xor_2730};
  logic [9:0] difference_2733;
  assign difference_2733 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2734;
  assign xor_2734 = difference_2733[8:0] ^ {9{difference_2733[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2755;
  assign sum_2755 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2757;
  assign sum_2757 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2758;
  assign equal_2758 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2759;
  assign select_2759 = equal_2758 ? sum_2755 : moments_before_0_q;
  logic [13:0] select_2761;
  assign select_2761 = equal_2758 ? sum_2757 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2764;
  assign select_2764 = equal_567_s2_q ? (moments_has_before_q | equal_2758) : moments_has_before_q;
  logic [13:0] select_2767;
  assign select_2767 = equal_567_s2_q ? ((select_2761 < select_2759) ? select_2759 : select_2761) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2768;
  assign sum_2768 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2771;
  assign select_2771 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2768)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2772;
  assign sum_2772 = {1'b0, sum_2757} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2775;
  assign select_2775 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2772)) : moments_left_alone_q;
  logic select_2778;
  assign select_2778 = equal_567_s2_q ? (~({3'h0, select_2761[13:2]} < sum_2772)) : moments_left_other_stops_q;
  logic select_2781;
  assign select_2781 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2768)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2782;
  assign sum_2782 = {1'b0, sum_2755} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2785;
  assign select_2785 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2782)) : moments_right_alone_q;
  logic select_2788;
  assign select_2788 = equal_567_s2_q ? (~({3'h0, select_2759[13:2]} < sum_2782)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2791;
  assign or_2791 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2799;
  assign and_2799 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2064)));
  logic and_2803;
  assign and_2803 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2073)));
  // hls/stages/moments.hpp:94
  logic and_2805;
  assign and_2805 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2808;
  assign select_2808 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2805)) : and_2805;
  // hls/stages/agreement.hpp:788
  logic and_2812;
  assign and_2812 = equal_567_s2_q & (equal_2758 & (cfg_prove_i & (cfg_same_table_i & select_2808)));
  // hls/stages/moments.hpp:95
  logic and_2815;
  assign and_2815 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:368
  logic [9:0] difference_2829;
  assign difference_2829 = {1'b0, select_548} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2829[9]} + (difference_2829[8:0] ^ {9{difference_2829[9]}});
  logic [9:0] difference_2841;
  assign difference_2841 = {1'b0, select_552} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2841[9]} + (difference_2841[8:0] ^ {9{difference_2841[9]}});
  // hls/stages/agreement.hpp:788
  logic not_3029;
  assign not_3029 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3030;
  assign less_3030 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_3037;
  assign and_3037 = and_542_s2_q & (equal_672_s2_q & equal_2932_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_3043;
  assign and_3043 = not_568_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3039_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3063;
  assign and_3063 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3064;
  assign and_3064 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3065;
  assign and_3065 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3066;
  assign and_3066 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3068;
  assign sum_3068 = {1'b0, and_3065} + ({1'b0, explained} + {1'b0, and_3066});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3063} + ({2'h0, and_3064} + {1'b0, sum_3068});
  // hls/stages/agreement.hpp:788
  logic and_3104;
  assign and_3104 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3039_s2_q & and_2481)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3128;
  assign difference_3128 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3131;
  assign less_3131 = {2'h0, difference_3128[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3134;
  assign and_3134 = not_576_s2_q & (((and_2479_s2_q & and_627) & equal_3124_s2_q) & (~less_3131));
  // hls/stages/agreement.hpp:788
  logic and_3138;
  assign and_3138 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_572_s2_q & and_3134)));
  // hls/stages/agreement.hpp:149
  logic and_3143;
  assign and_3143 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3145;
  assign and_3145 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3146;
  assign select_3146 = or_572_s2_q ? {and_3145, and_3143} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3148;
  assign select_3148 = less_575_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3149;
  assign select_3149 = or_572_s2_q ? select_3148 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3151;
  assign and_3151 = and_629 & (select_3146[0] & select_3149[0]);
  // hls/stages/agreement.hpp:788
  logic and_3155;
  assign and_3155 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3146[1] & and_3151)));
  logic and_3156;
  assign and_3156 = not_568_s2_q & and_3155;
  logic and_3162;
  assign and_3162 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3149[1] & and_3151)));
  logic and_3163;
  assign and_3163 = not_568_s2_q & and_3162;
  // hls/stages/registration.hpp:76
  logic less_3166;
  assign less_3166 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3168;
  assign select_3168 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3170;
  assign select_3170 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3172;
  assign select_3172 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3170} - {1'b0, select_3172};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3174;
  assign select_3174 = rise_2[8] ? select_3170 : select_3172;
  logic [8:0] fall;
  assign fall = {1'b0, select_3168} - {1'b0, select_3174};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3177;
  assign not_3177 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3166 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3177};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3179;
  assign xor_3179 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3179};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3185;
  assign select_3185 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3166 ? {taken, 1'b1} : {not_3177, select_3185, not_3177};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3187;
  assign sum_3187 = {left, 1'b1} + {taken_2, less_3166};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3189;
  assign select_3189 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3191;
  assign select_3191 = equal_567_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3193;
  assign select_3193 = equal_567_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3194;
  assign equal_3194 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3198;
  assign and_3198 = and_629 & less_2169_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3200;
  assign select_3200 = or_572_s2_q ? (less_575_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3204;
  assign sum_3204 = select_3200[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3207;
  assign select_3207 = (select_3170 < select_3172) ? ({sum_3204, select_3200[0], 5'h0} - {3'h0, select_3189}) : {sum_3204, select_3200[0], select_3189};
  logic [7:0] select_3208;
  assign select_3208 = ((select_3200 == 3'h0) | (select_3200 == 3'h4)) ? {sum_3204, select_3200[0], 5'h0} : select_3207;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3208[7]}}, select_3208} - {sum_2188[9], sum_2188, sum_2184[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3211;
  assign select_3211 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3211[11:7])) ? 12'h7f : select_3211;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3232;
  assign difference_3232 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3234;
  assign and_3234 = and_3198 & ($signed(difference_3232) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3247;
  assign less_3247 = $signed(difference_3232) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3255;
  assign select_3255 = so_s2_q ? (equal_3194 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3258;
  assign select_3258 = so_s2_q ? (equal_2170 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3263;
  assign select_3263 = (sum_2080 == 2'h2) ? (registration_fresh_q & (~select_2127)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3265;
  assign select_3265 = so_s2_q ? (and_2122 ? select_3263 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3267;
  assign select_3267 = and_3037 ? 4'hf : (equal_567_s2_q ? registration_fresh_q : select_3265);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2077;
  // hls/stages/registration.hpp:258
  logic not_3288;
  assign not_3288 = ~quarter_2[1];
  logic [3:0] select_3289;
  assign select_3289 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3288, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3288};
  // hls/stages/patches.hpp:91
  logic parity_3423;
  assign parity_3423 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3424;
  assign select_3424 = equal_2932_s2_q ? {patches_chance_q[14:0], parity_3423} : patches_chance_q;
  // hls/stages/patches.hpp:346
  logic not_3426;
  assign not_3426 = ~and_2244;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3429;
  assign select_3429 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3429};
  // hls/stages/agreement.hpp:788
  logic and_3435;
  assign and_3435 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3439;
  assign and_3439 = not_3426 & (patches_fixed_q | ((not_568_s2_q & and_3435) & and_2216));
  // hls/stages/patches.hpp:355
  logic not_3452;
  assign not_3452 = ~select_2159[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3454;
  assign select_3454 = sample_pair_whole_s2_q ? (equal_2160 ? select_2159 : {not_3452, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3553;
  assign select_3553 = or_2252_s2_q ? {and_2397_s2_q, and_2394_s2_q, and_2378_s2_q, and_2375, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3555;
  assign select_3555 = equal_2246_s2_q ? patches_codes_at_q : (equal_2248_s2_q ? other[55:4] : select_3553);
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_2351_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [27:0] select_3558;
  assign select_3558 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3560;
  assign select_3560 = equal_2248_s2_q ? (new_row_s2_q ? word : select_3558) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3562;
  assign select_3562 = less_2338_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3564;
  assign select_3564 = less_3563_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3566;
  assign select_3566 = or_2252_s2_q ? (equal_2251_s2_q ? patches_next_codes_q : select_3564) : patches_next_codes_q;
  logic [55:0] select_3568;
  assign select_3568 = equal_2246_s2_q ? patches_next_codes_q : (equal_2248_s2_q ? select_3562 : select_3566);
  // hls/stages/count_bits.hpp:24
  logic parity_3573;
  assign parity_3573 = ^{and_2397_s2_q, and_2394_s2_q, and_2378_s2_q, and_2375};
  // hls/stages/count_bits.hpp:25
  logic or_3577;
  assign or_3577 = ({and_2378_s2_q, and_2375} == 2'h3) | (and_2394_s2_q & (and_2378_s2_q | and_2375));
  logic and_3578;
  assign and_3578 = and_2397_s2_q & (^{and_2394_s2_q, and_2378_s2_q, and_2375});
  // hls/stages/count_bits.hpp:24
  logic xor_3579;
  assign xor_3579 = or_3577 ^ and_3578;
  // hls/stages/count_bits.hpp:27
  logic and_3580;
  assign and_3580 = or_3577 & and_3578;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3582;
  assign select_3582 = or_2252_s2_q ? (and_2420_s2_q ? {and_3580, xor_3579, parity_3573} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3586;
  assign sum_3586 = {7'h0, patches_set_q} + (equal_2251_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:523
  logic [47:0] select_3596;
  assign select_3596 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3598;
  assign select_3598 = equal_2246_s2_q ? patches_left_row_q : (equal_2248_s2_q ? select_3596 : patches_left_row_q);
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3596;
  // hls/stages/count_bits.hpp:24
  logic xor_3602;
  assign xor_3602 = bits[17] ^ (^{select_3596[16:15], other[16:15]});
  logic xor_3605;
  assign xor_3605 = bits[11] ^ (^{select_3596[10:9], other[10:9]});
  logic xor_3608;
  assign xor_3608 = bits[14] ^ (^{select_3596[13:12], other[13:12]});
  logic xor_3611;
  assign xor_3611 = xor_3602 ^ (^{select_3596[14:9], other[14:9]});
  logic xor_3614;
  assign xor_3614 = bits[47] ^ (^{select_3596[46:45], other[46:45]});
  logic xor_3617;
  assign xor_3617 = bits[8] ^ (^{select_3596[7:6], other[7:6]});
  logic xor_3620;
  assign xor_3620 = bits[2] ^ (^{select_3596[1:0], other[1:0]});
  logic xor_3623;
  assign xor_3623 = bits[5] ^ (^{select_3596[4:3], other[4:3]});
  logic xor_3626;
  assign xor_3626 = xor_3617 ^ (^{select_3596[5:0], other[5:0]});
  logic parity_3628;
  assign parity_3628 = ^{select_3596[47:45], select_3596[8:0], other[47:45], other[8:0]};
  logic xor_3629;
  assign xor_3629 = xor_3611 ^ parity_3628;
  logic xor_3632;
  assign xor_3632 = bits[44] ^ (^{select_3596[43:42], other[43:42]});
  logic xor_3635;
  assign xor_3635 = bits[38] ^ (^{select_3596[37:36], other[37:36]});
  logic xor_3638;
  assign xor_3638 = bits[41] ^ (^{select_3596[40:39], other[40:39]});
  logic xor_3644;
  assign xor_3644 = bits[26] ^ (^{select_3596[25:24], other[25:24]});
  logic xor_3647;
  assign xor_3647 = bits[20] ^ (^{select_3596[19:18], other[19:18]});
  logic xor_3650;
  assign xor_3650 = bits[23] ^ (^{select_3596[22:21], other[22:21]});
  logic xor_3653;
  assign xor_3653 = xor_3644 ^ (^{select_3596[23:18], other[23:18]});
  logic xor_3656;
  assign xor_3656 = bits[35] ^ (^{select_3596[34:33], other[34:33]});
  logic xor_3659;
  assign xor_3659 = bits[29] ^ (^{select_3596[28:27], other[28:27]});
  logic xor_3662;
  assign xor_3662 = bits[32] ^ (^{select_3596[31:30], other[31:30]});
  logic xor_3665;
  assign xor_3665 = xor_3656 ^ (^{select_3596[32:27], other[32:27]});
  logic xor_3666;
  assign xor_3666 = xor_3653 ^ xor_3665;
  // hls/stages/count_bits.hpp:25
  logic or_3674;
  assign or_3674 = (xor_3605 & xor_3608) | (xor_3602 & (xor_3605 | xor_3608));
  logic or_3678;
  assign or_3678 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3682;
  assign or_3682 = (xor_3620 & xor_3623) | (xor_3617 & (xor_3620 | xor_3623));
  // hls/stages/count_bits.hpp:23
  logic or_3689;
  assign or_3689 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3693;
  assign or_3693 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3697;
  assign or_3697 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3700;
  assign parity_3700 = ^{or_3697, or_3693, or_3689};
  // hls/stages/count_bits.hpp:23
  logic or_3704;
  assign or_3704 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3708;
  assign or_3708 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3712;
  assign or_3712 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3715;
  assign parity_3715 = ^{or_3712, or_3708, or_3704};
  logic parity_3718;
  assign parity_3718 = ^{or_3712, or_3708, or_3704, or_3697, or_3693, or_3689, or_3682, or_3678, or_3674};
  // hls/stages/count_bits.hpp:23
  logic or_3722;
  assign or_3722 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3726;
  assign or_3726 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3730;
  assign or_3730 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3738;
  assign or_3738 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3742;
  assign or_3742 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3746;
  assign or_3746 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3749;
  assign parity_3749 = ^{or_3746, or_3742, or_3738};
  // hls/stages/count_bits.hpp:23
  logic or_3753;
  assign or_3753 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3757;
  assign or_3757 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3761;
  assign or_3761 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3764;
  assign parity_3764 = ^{or_3761, or_3757, or_3753};
  logic parity_3767;
  assign parity_3767 = ^{or_3761, or_3757, or_3753, or_3746, or_3742, or_3738, or_3730, or_3726, or_3722};
  // hls/stages/count_bits.hpp:25
  logic or_3771;
  assign or_3771 = (xor_3635 & xor_3638) | (xor_3632 & (xor_3635 | xor_3638));
  logic or_3775;
  assign or_3775 = (xor_3647 & xor_3650) | (xor_3644 & (xor_3647 | xor_3650));
  logic or_3779;
  assign or_3779 = (xor_3659 & xor_3662) | (xor_3656 & (xor_3659 | xor_3662));
  // hls/stages/count_bits.hpp:24
  logic parity_3782;
  assign parity_3782 = ^{or_3779, or_3775, or_3771};
  // hls/stages/count_bits.hpp:25
  logic and_3783;
  assign and_3783 = xor_3629 & (^{xor_3666, select_3596[44:36], other[44:36]});
  logic or_3787;
  assign or_3787 = (xor_3614 & xor_3626) | (xor_3611 & (xor_3614 | xor_3626));
  logic and_3790;
  assign and_3790 = (xor_3632 ^ (^{select_3596[41:36], other[41:36]})) & (xor_3653 | xor_3665);
  logic or_3791;
  assign or_3791 = (xor_3653 & xor_3665) | and_3790;
  // hls/stages/count_bits.hpp:24
  logic parity_3794;
  assign parity_3794 = ^{or_3791, or_3787, and_3783};
  logic parity_3797;
  assign parity_3797 = ^{or_3791, or_3787, and_3783, or_3779, or_3775, or_3771, or_3761, or_3757, or_3753, or_3746, or_3742, or_3738, or_3730, or_3726, or_3722};
  logic parity_3799;
  assign parity_3799 = ^{or_3791, or_3787, and_3783, or_3779, or_3775, or_3771, or_3761, or_3757, or_3753, or_3746, or_3742, or_3738, or_3730, or_3726, or_3722, or_3712, or_3708, or_3704, or_3697, or_3693, or_3689, or_3682, or_3678, or_3674};
  // hls/stages/count_bits.hpp:25
  logic and_3800;
  assign and_3800 = parity_3718 & parity_3797;
  logic or_3804;
  assign or_3804 = (parity_3700 & parity_3715) | ((^{or_3682, or_3678, or_3674}) & (parity_3700 | parity_3715));
  logic or_3808;
  assign or_3808 = (parity_3782 & parity_3794) | (parity_3767 & (parity_3782 | parity_3794));
  logic or_3815;
  assign or_3815 = (parity_3749 & parity_3764) | ((^{or_3730, or_3726, or_3722}) & (parity_3749 | parity_3764));
  logic or_3819;
  assign or_3819 = (or_3775 & or_3779) | (or_3771 & (or_3775 | or_3779));
  logic or_3823;
  assign or_3823 = (or_3787 & or_3791) | (and_3783 & (or_3787 | or_3791));
  // hls/stages/count_bits.hpp:23
  logic or_3830;
  assign or_3830 = (or_3726 & or_3730) | (or_3722 & (or_3726 | or_3730));
  // hls/stages/count_bits.hpp:25
  logic or_3834;
  assign or_3834 = (or_3742 & or_3746) | (or_3738 & (or_3742 | or_3746));
  logic or_3838;
  assign or_3838 = (or_3757 & or_3761) | (or_3753 & (or_3757 | or_3761));
  // hls/stages/count_bits.hpp:24
  logic parity_3841;
  assign parity_3841 = ^{or_3838, or_3834, or_3830};
  // hls/stages/count_bits.hpp:23
  logic or_3845;
  assign or_3845 = (or_3678 & or_3682) | (or_3674 & (or_3678 | or_3682));
  // hls/stages/count_bits.hpp:25
  logic or_3849;
  assign or_3849 = (or_3693 & or_3697) | (or_3689 & (or_3693 | or_3697));
  logic or_3853;
  assign or_3853 = (or_3708 & or_3712) | (or_3704 & (or_3708 | or_3712));
  // hls/stages/count_bits.hpp:24
  logic parity_3856;
  assign parity_3856 = ^{or_3853, or_3849, or_3845};
  logic parity_3859;
  assign parity_3859 = ^{or_3853, or_3849, or_3845, or_3838, or_3834, or_3830, or_3823, or_3819, or_3815};
  logic parity_3861;
  assign parity_3861 = ^{or_3853, or_3849, or_3845, or_3838, or_3834, or_3830, or_3823, or_3819, or_3815, or_3808, or_3804, and_3800};
  // hls/stages/count_bits.hpp:25
  logic or_3865;
  assign or_3865 = (or_3819 & or_3823) | (or_3815 & (or_3819 | or_3823));
  logic or_3869;
  assign or_3869 = (or_3834 & or_3838) | (or_3830 & (or_3834 | or_3838));
  logic or_3873;
  assign or_3873 = (or_3849 & or_3853) | (or_3845 & (or_3849 | or_3853));
  // hls/stages/count_bits.hpp:24
  logic parity_3876;
  assign parity_3876 = ^{or_3873, or_3869, or_3865};
  // hls/stages/count_bits.hpp:25
  logic and_3877;
  assign and_3877 = (^{or_3808, or_3804, and_3800}) & parity_3859;
  logic or_3881;
  assign or_3881 = (or_3804 & or_3808) | (and_3800 & (or_3804 | or_3808));
  logic or_3885;
  assign or_3885 = (parity_3841 & parity_3856) | ((^{or_3823, or_3819, or_3815}) & (parity_3841 | parity_3856));
  // hls/stages/count_bits.hpp:24
  logic parity_3888;
  assign parity_3888 = ^{or_3885, or_3881, and_3877};
  // hls/stages/count_bits.hpp:25
  logic and_3890;
  assign and_3890 = parity_3876 & parity_3888;
  logic or_3894;
  assign or_3894 = (or_3869 & or_3873) | (or_3865 & (or_3869 | or_3873));
  logic or_3898;
  assign or_3898 = (or_3881 & or_3885) | (and_3877 & (or_3881 | or_3885));
  // hls/stages/patches.hpp:185
  logic [4:0] select_3943;
  assign select_3943 = equal_2248_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3946;
  assign select_3946 = equal_2246_s2_q ? patches_summed_first_q : (equal_2248_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:557
  logic [9:0] select_3953;
  assign select_3953 = less_2426_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3956;
  assign select_3956 = equal_2429_s2_q ? (less_2426_s2_q ? (equal_2429_s2_q ? 10'h0 : select_3953) : 10'h0) : select_3953;
  logic [9:0] select_3958;
  assign select_3958 = less_2426_s2_q ? (equal_2427_s2_q ? 10'h0 : select_3956) : select_3956;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3960;
  assign select_3960 = less_2426_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3963;
  assign select_3963 = equal_2429_s2_q ? (less_2426_s2_q ? (equal_2429_s2_q ? 5'h0 : select_3960) : 5'h0) : select_3960;
  logic [4:0] select_3965;
  assign select_3965 = less_2426_s2_q ? (equal_2427_s2_q ? 5'h0 : select_3963) : select_3963;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3967;
  assign select_3967 = less_2426_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3970;
  assign select_3970 = equal_2429_s2_q ? (less_2426_s2_q ? (equal_2429_s2_q ? 5'h0 : select_3967) : 5'h0) : select_3967;
  logic [4:0] select_3972;
  assign select_3972 = less_2426_s2_q ? (equal_2427_s2_q ? 5'h0 : select_3970) : select_3970;
  // hls/stages/patches.hpp:557
  logic and_3975;
  assign and_3975 = less_2426_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3978;
  assign select_3978 = equal_2429_s2_q ? (less_2426_s2_q ? (not_2430_s2_q & and_3975) : and_3975) : and_3975;
  // hls/stages/patches.hpp:185
  logic select_3981;
  assign select_3981 = equal_2246_s2_q ? (less_2426_s2_q ? (not_2428_s2_q & select_3978) : select_3978) : patches_read_first_q;
  // hls/stages/patches.hpp:179
  logic or_3992;
  assign or_3992 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3993;
  assign and_3993 = patches_read_searches_s2_q & or_3992;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3994;
  assign select_3994 = and_3993 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3994};
  // hls/stages/patches.hpp:557
  logic and_3998;
  assign and_3998 = less_2426_s2_q & (equal_3990_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:561
  logic select_4001;
  assign select_4001 = equal_2429_s2_q ? (less_2426_s2_q ? (not_2430_s2_q & and_3998) : and_3998) : and_3998;
  // hls/stages/patches.hpp:185
  logic select_4004;
  assign select_4004 = equal_2246_s2_q ? (less_2426_s2_q ? (not_2428_s2_q & select_4001) : select_4001) : patches_read_above_q;
  // hls/stages/patches.hpp:557
  logic and_4007;
  assign and_4007 = less_2426_s2_q & (equal_3990_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:561
  logic select_4010;
  assign select_4010 = equal_2429_s2_q ? (less_2426_s2_q ? (not_2430_s2_q & and_4007) : and_4007) : and_4007;
  // hls/stages/patches.hpp:185
  logic select_4013;
  assign select_4013 = equal_2246_s2_q ? (less_2426_s2_q ? (not_2428_s2_q & select_4010) : select_4010) : patches_read_below_q;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_4014;
  assign sum_4014 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:555
  logic [9:0] select_4017;
  assign select_4017 = (equal_3990_s2_q & ({sum_4014[6], sum_4014} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4018;
  assign select_4018 = less_2426_s2_q ? select_4017 : 10'h3ff;
  // hls/stages/patches.hpp:558
  logic [9:0] select_4020;
  assign select_4020 = less_2426_s2_q ? (equal_2429_s2_q ? 10'h3ff : select_4018) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_4021;
  assign select_4021 = equal_2429_s2_q ? select_4020 : select_4018;
  logic [9:0] select_4023;
  assign select_4023 = less_2426_s2_q ? (equal_2427_s2_q ? 10'h3ff : select_4021) : select_4021;
  // hls/stages/patches.hpp:540
  logic [14:0] select_4025;
  assign select_4025 = and_3993 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_4026;
  assign select_4026 = equal_2246_s2_q ? select_4025[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4027;
  assign select_4027 = equal_2246_s2_q ? select_4025[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_4029;
  assign select_4029 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_4031;
  assign select_4031 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_4034;
  assign select_4034 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_4035;
  assign select_4035 = patches_read_first_q ? patches_read_far_q : select_4034;
  // hls/stages/patches.hpp:595
  logic [9:0] difference_4038;
  assign difference_4038 = select_4035 - select_4025[9:0];
  // hls/stages/patches.hpp:580
  logic less_4068;
  assign less_4068 = select_4029 < select_4031;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4069;
  assign sum_4069 = select_3994[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4068 ? select_4031 : select_4029;
  logic [9:0] low;
  assign low = (select_4031 < select_4029) ? select_4031 : select_4029;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_4025[9:0];
  // hls/stages/patches.hpp:584
  logic not_4076;
  assign not_4076 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4077;
  assign sum_4077 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4079;
  assign not_4079 = ~({eight, 3'h0} < {1'b0, sum_4077, fall_2[0]});
  logic [1:0] sum_4080;
  assign sum_4080 = {1'b0, not_4076} + {1'b0, not_4079};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4081;
  assign sum_4081 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4083;
  assign not_4083 = ~({eight, 3'h0} < {sum_4081, fall_2[1:0]});
  logic not_4086;
  assign not_4086 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4087;
  assign sum_4087 = {1'b0, not_4083} + {1'b0, not_4086};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4080} + {1'b0, sum_4087};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4090;
  assign select_4090 = less_4068 ? ({sum_4069, select_3994[2:0], 3'h0} - {5'h0, fraction}) : {sum_4069, select_3994[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_4313;
  assign select_4313 = equal_567_s2_q ? shown_shown_q : (so_s2_q ? select_2491 : shown_shown_q);
  logic select_4315;
  assign select_4315 = equal_567_s2_q ? shown_nearer_q : (so_s2_q ? select_2494 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4317;
  assign sum_4317 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4319;
  assign select_4319 = less_4316_s2_q ? (sum_4317[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4321;
  assign select_4321 = equal_2932_s2_q ? (equal_672_s2_q ? 3'h0 : select_4319) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4326;
  assign select_4326 = equal_567_s2_q ? select_2445 : (so_s2_q ? (ends_cell_s2_q ? select_2543 : select_2445) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4340;
  assign select_4340 = equal_672_s2_q ? {{2{difference_4338[6]}}, difference_4338} : (less_4316_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4342;
  assign select_4342 = and_542_s2_q ? (equal_2932_s2_q ? select_4340 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4344;
  assign select_4344 = equal_672_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4346;
  assign select_4346 = and_542_s2_q ? (equal_2932_s2_q ? select_4344 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4347;
  assign sum_4347 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4348;
  assign select_4348 = sum_4317[7] ? {1'b1, sum_4317[6:0], region_down_rest_q[0]} : sum_4347;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4317[7];
  // hls/stages/agreement.hpp:460
  logic select_4352;
  assign select_4352 = equal_2932_s2_q ? (equal_672_s2_q | (less_4316_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4357;
  assign or_4357 = segment_starts_q | not_570_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4360;
  assign select_4360 = inside_v_s2_q ? (sum_2458_s2_q ? (equal_2239 & or_2460) : or_2460) : or_4357;
  // hls/stages/agreement.hpp:788
  logic select_4363;
  assign select_4363 = equal_567_s2_q ? or_4357 : (so_s2_q ? (ends_cell_s2_q ? select_4360 : or_4357) : or_4357);
  // hls/stages/agreement.hpp:1147
  logic equal_4387;
  assign equal_4387 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4523;
  assign select_4523 = so_s2_q ? (ends_cell_s2_q ? and_2531 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4526;
  assign select_4526 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4528;
  assign select_4528 = equal_567_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4526 : centres_values_0_of_skin_q);
  logic select_4529;
  assign select_4529 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4531;
  assign select_4531 = equal_567_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4529 : centres_values_1_textured_q);
  logic select_4532;
  assign select_4532 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4534;
  assign select_4534 = equal_567_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4532 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4538;
  assign select_4538 = equal_2932_s2_q ? (equal_4535_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4541;
  assign select_4541 = and_542_s2_q ? (equal_2932_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4552;
  assign select_4552 = select_2503 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4558;
  assign select_4558 = marks_first_s2_q ? (less_4554 ? {sum_4555, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4628;
  assign not_4628 = ~quarter[1];
  logic [3:0] select_4629;
  assign select_4629 = quarter[0] ? {quarter[1], 1'b0, not_4628, 1'b0} : {1'b0, quarter[1], 1'b0, not_4628};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2081;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2124;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:768; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2158;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2160));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1398; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2455;
  logic regions_re;
  assign regions_re = s2_en & (equal_567_s2_q ? (x_s2_q[6] & not_2456) : and_2463);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2515, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2522 & less_2523);
  logic [2:0] map_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_word_q <= map_mem[map_raddr];
  end
  logic [1:0] map_rdata_q;
  assign map_rdata_q = map_word_q[1:0];
  logic map_read_q, map_error;
  always_ff @(posedge clk_i) map_read_q <= rst_ni & map_re;
  assign map_error = map_read_q & ^map_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_508_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_517_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_536, and_532, sum_528, sum_524};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {^averager_memory_wdata, averager_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd320) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd320) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s2_2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_542_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_560, whole_2, select_552, select_548};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {^census_memory_wdata, census_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd80) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd80) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_566_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_584_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_639_s2_q, and_637_s2_q, and_632_s2_q, and_630};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {^moments_memory_wdata, moments_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 13'd4800) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 13'd4800) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_2028_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2027, select_2024, select_2021, select_2019, select_1992, select_1989, select_1981, select_1980, select_1976};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {^best_left_wdata, best_left_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s1_sim;
  logic best_left_re_s1_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s1_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s1_sim <= best_left_re;
      best_left_raddr_s1_sim <= best_left_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s1_sim && best_left_raddr_s1_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 7'd80) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd80) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s2_q;
  logic best_right_we;
  assign best_right_we = s2_en & and_2028_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2038, select_2037, select_2034, select_2033};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {^best_right_wdata, best_right_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd80) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd80) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_2045_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2056;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2053, not_570_s2_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {^shown_right_wdata, shown_right_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd80) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd80) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory left_turns, write
  logic [6:0] left_turns_waddr;
  assign left_turns_waddr = x_s2_q[6:0];
  logic left_turns_we;
  assign left_turns_we = s2_en & moments_taken_q;
  logic [1:0] left_turns_wdata;
  assign left_turns_wdata = {and_2064, and_2061};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {^left_turns_wdata, left_turns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 7'd80) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 7'd80) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s2_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s2_en & moments_taken_q;
  logic [1:0] right_turns_wdata;
  assign right_turns_wdata = {and_2073, and_2070};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {^right_turns_wdata, right_turns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd80) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd80) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_2359, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2411_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2397_s2_q, and_2394_s2_q, and_2378_s2_q, and_2375, patches_codes_at_q[51:28]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {^patches_right_codes_wdata, patches_right_codes_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_2415, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2425_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2397_s2_q, and_2394_s2_q, and_2378_s2_q, and_2375, patches_codes_at_q[51:8]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {^patches_left_codes_wdata, patches_left_codes_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s2_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s2_en & and_2041_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2490, textured};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {^seen_columns_wdata, seen_columns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd80) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd80) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      moments_turned_0_q <= 14'h0;
      moments_turned_1_q <= 14'h0;
      moments_before_0_q <= 14'h0;
      moments_before_1_q <= 14'h0;
      moments_has_before_q <= 1'b0;
      moments_most_before_q <= 14'h0;
      moments_left_begins_q <= 1'b0;
      moments_left_alone_q <= 1'b0;
      moments_left_other_stops_q <= 1'b0;
      moments_right_begins_q <= 1'b0;
      moments_right_alone_q <= 1'b0;
      moments_right_other_stops_q <= 1'b0;
      moments_out_of_step_q <= 1'b0;
      moments_turns_0_q <= 1'b0;
      moments_turns_1_q <= 1'b0;
      moments_begins_alone_q <= 1'b0;
      moments_ends_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
      counts_turned_left_q <= 14'h0;
      counts_turned_right_q <= 14'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      registration_expected_q <= 11'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      patches_chance_q <= 16'h1;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_summed_first_q <= 1'b0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_read_first_q <= 1'b0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_read_far_q <= 10'h3ff;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      patches_peak_far_q <= 10'h0;
      patches_frame_ended_q <= 1'b0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
      rows_passed_q <= 17'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2656;
      averager_mask_q <= select_2658;
      averager_of_skin_q <= select_2660;
      census_filled_q <= and_542_s2_q ? {select_675[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2755;
      moments_turned_1_q <= sum_2757;
      moments_before_0_q <= equal_567_s2_q ? select_2759 : moments_before_0_q;
      moments_before_1_q <= equal_567_s2_q ? select_2761 : moments_before_1_q;
      moments_has_before_q <= select_2764;
      moments_most_before_q <= select_2767;
      moments_left_begins_q <= select_2771;
      moments_left_alone_q <= select_2775;
      moments_left_other_stops_q <= select_2778;
      moments_right_begins_q <= select_2781;
      moments_right_alone_q <= select_2785;
      moments_right_other_stops_q <= select_2788;
      moments_out_of_step_q <= or_2791;
      moments_turns_0_q <= and_2799;
      moments_turns_1_q <= and_2803;
      moments_begins_alone_q <= and_2812;
      moments_ends_q <= equal_567_s2_q & (equal_2758 & (not_2813 | and_2815));
      rows_passed_above_q <= and_542_s2_q ? select_674 : rows_passed_above_q;
      shift_allowed_q <= not_3029 & (~less_3030);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3037 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3156});
      counts_turned_right_q <= and_3037 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3163});
      registration_displacement_over_q <= so_s2_q ? sum_3187[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3189;
      registration_slope_here_q <= select_3191;
      registration_expected_q <= select_3193;
      registration_of_right_q <= equal_567_s2_q ? registration_of_right_q : select_3255;
      registration_was_inside_q <= equal_567_s2_q ? registration_was_inside_q : select_3258;
      registration_fresh_q <= select_3267;
      patches_chance_q <= and_542_s2_q ? select_3424 : patches_chance_q;
      patches_fixed_q <= and_3439;
      patches_choice_valid_q <= and_2244 ? (select_2217 & not_3426) : select_2217;
      patches_choice_column_q <= select_2222;
      patches_choice_shift_q <= select_2227;
      patches_choice_slope_q <= select_2238;
      patches_band_q <= sample_pair_whole_s2_q ? select_2259 : patches_band_q;
      patches_fetch_q <= select_3454;
      patches_codes_at_q <= select_3555;
      patches_codes_further_q <= equal_2246_s2_q ? patches_codes_further_q : select_3560;
      patches_next_codes_q <= select_3568;
      patches_set_q <= equal_2246_s2_q ? 3'h0 : (equal_2248_s2_q ? 3'h0 : select_3582);
      patches_size_q <= sum_3586;
      patches_left_row_q <= select_3598;
      patches_summed_row_column_q <= equal_2246_s2_q ? patches_summed_row_column_q : select_3943;
      patches_summed_first_q <= select_3946;
      patches_read_row_differing_q <= equal_2246_s2_q ? select_3958 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2246_s2_q ? select_3965 : patches_read_row_column_q;
      patches_read_at_q <= equal_2246_s2_q ? select_3972 : patches_read_at_q;
      patches_read_first_q <= select_3981;
      patches_read_above_q <= select_4004;
      patches_read_below_q <= select_4013;
      patches_read_far_q <= equal_2246_s2_q ? select_4023 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4026;
      patches_peak_best_column_q <= select_4027;
      patches_peak_row_q <= equal_2246_s2_q ? select_3994 : patches_peak_row_q;
      patches_peak_above_q <= equal_2246_s2_q ? select_4029 : patches_peak_above_q;
      patches_peak_below_q <= equal_2246_s2_q ? select_4031 : patches_peak_below_q;
      patches_peak_far_q <= equal_2246_s2_q ? select_4035 : patches_peak_far_q;
      patches_frame_ended_q <= equal_567_s2_q & equal_2758;
      shown_shown_q <= select_4313;
      shown_nearer_q <= select_4315;
      region_row_q <= and_542_s2_q ? select_4321 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4326;
      region_down_rest_q <= select_4342;
      region_down_back_q <= select_4346;
      region_down_next_q <= select_4348;
      region_fresh_q <= and_542_s2_q ? select_4352 : region_fresh_q;
      segment_starts_q <= select_4363;
      centres_values_0_textured_q <= equal_567_s2_q ? centres_values_0_textured_q : select_4523;
      centres_values_0_of_skin_q <= select_4528;
      centres_values_1_textured_q <= select_4531;
      centres_values_1_of_skin_q <= select_4534;
      map_row_q <= and_542_s2_q ? select_4538 : map_row_q;
      map_width_q <= select_4541;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2514;
      done_q <= not_2516 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_567_s2_q & equal_4387;
      rows_passed_q <= select_2499;
      columns_passed_q <= {select_2501[7:0], or_2497};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2518;
      seen_x_q <= select_2520;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4552;
      seen_column_q <= select_2511;
      seen_rows_left_q <= select_4558;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2508;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_0_cell_1_left_q = 9'h0;
    census_columns_values_0_cell_1_right_q = 9'h0;
    census_columns_values_0_cell_1_mask_q = 1'b0;
    census_columns_values_0_cell_2_left_q = 9'h0;
    census_columns_values_0_cell_2_right_q = 9'h0;
    census_columns_values_0_cell_2_mask_q = 1'b0;
    census_columns_values_0_cell_2_of_skin_q = 1'b0;
    census_columns_values_0_cell_3_left_q = 9'h0;
    census_columns_values_0_cell_3_right_q = 9'h0;
    census_columns_values_0_cell_3_mask_q = 1'b0;
    census_columns_values_0_cell_4_left_q = 9'h0;
    census_columns_values_0_cell_4_right_q = 9'h0;
    census_columns_values_0_cell_4_mask_q = 1'b0;
    census_columns_values_1_cell_0_left_q = 9'h0;
    census_columns_values_1_cell_0_right_q = 9'h0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    census_columns_values_3_cell_4_mask_q = 1'b0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      averager_running_0_q <= sample_pair_whole_s2_q ? select_520 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_526 : averager_running_1_q;
      averager_total_0_q <= select_2634;
      averager_total_1_q <= select_2636;
      census_columns_values_0_cell_0_left_q <= select_2661;
      census_columns_values_0_cell_0_right_q <= select_2662;
      census_columns_values_0_cell_0_mask_q <= and_542_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2664;
      census_columns_values_0_cell_1_right_q <= select_2665;
      census_columns_values_0_cell_1_mask_q <= select_2666;
      census_columns_values_0_cell_2_left_q <= select_2667;
      census_columns_values_0_cell_2_right_q <= select_2668;
      census_columns_values_0_cell_2_mask_q <= select_2669;
      census_columns_values_0_cell_2_of_skin_q <= select_2670;
      census_columns_values_0_cell_3_left_q <= select_2671;
      census_columns_values_0_cell_3_right_q <= select_2672;
      census_columns_values_0_cell_3_mask_q <= select_2673;
      census_columns_values_0_cell_4_left_q <= select_2674;
      census_columns_values_0_cell_4_right_q <= select_2675;
      census_columns_values_0_cell_4_mask_q <= select_2676;
      census_columns_values_1_cell_0_left_q <= select_2677;
      census_columns_values_1_cell_0_right_q <= select_2678;
      census_columns_values_1_cell_0_mask_q <= select_2679;
      census_columns_values_1_cell_1_left_q <= select_2680;
      census_columns_values_1_cell_1_right_q <= select_2681;
      census_columns_values_1_cell_1_mask_q <= select_2682;
      census_columns_values_1_cell_2_left_q <= select_2683;
      census_columns_values_1_cell_2_right_q <= select_2684;
      census_columns_values_1_cell_2_mask_q <= select_2685;
      census_columns_values_1_cell_2_of_skin_q <= select_2686;
      census_columns_values_1_cell_3_left_q <= select_2687;
      census_columns_values_1_cell_3_right_q <= select_2688;
      census_columns_values_1_cell_3_mask_q <= select_2689;
      census_columns_values_1_cell_4_left_q <= select_2690;
      census_columns_values_1_cell_4_right_q <= select_2691;
      census_columns_values_1_cell_4_mask_q <= select_2692;
      census_columns_values_2_cell_0_left_q <= select_2693;
      census_columns_values_2_cell_0_right_q <= select_2694;
      census_columns_values_2_cell_0_mask_q <= select_2695;
      census_columns_values_2_cell_1_left_q <= select_2696;
      census_columns_values_2_cell_1_right_q <= select_2697;
      census_columns_values_2_cell_1_mask_q <= select_2698;
      census_columns_values_2_cell_2_left_q <= select_2699;
      census_columns_values_2_cell_2_right_q <= select_2700;
      census_columns_values_2_cell_2_mask_q <= select_2701;
      census_columns_values_2_cell_3_left_q <= select_2702;
      census_columns_values_2_cell_3_right_q <= select_2703;
      census_columns_values_2_cell_3_mask_q <= select_2704;
      census_columns_values_2_cell_4_left_q <= select_2705;
      census_columns_values_2_cell_4_right_q <= select_2706;
      census_columns_values_2_cell_4_mask_q <= select_2707;
      census_columns_values_3_cell_0_mask_q <= select_2708;
      census_columns_values_3_cell_1_left_q <= select_2709;
      census_columns_values_3_cell_1_right_q <= select_2710;
      census_columns_values_3_cell_1_mask_q <= select_2711;
      census_columns_values_3_cell_2_mask_q <= select_2712;
      census_columns_values_3_cell_3_left_q <= select_2713;
      census_columns_values_3_cell_3_right_q <= select_2714;
      census_columns_values_3_cell_3_mask_q <= select_2715;
      census_columns_values_3_cell_4_mask_q <= select_2716;
      sharpness_last_mean_0_q <= and_542_s2_q ? select_548 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_542_s2_q ? select_552 : sharpness_last_mean_1_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic [7:0] sample_pair_pixel_0_s3_q;
  logic [7:0] sample_pair_pixel_1_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic census_columns_values_1_cell_2_of_skin_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic registration_of_right_s3_q;
  logic [4:0] patches_choosing_band_s3_q;
  logic patches_lower_s3_q;
  logic patches_second_s3_q;
  logic [4:0] patches_summed_row_column_s3_q;
  logic patches_summed_first_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic patches_frame_ended_s3_q;
  logic [2:0] region_row_s3_q;
  logic region_fresh_s3_q;
  logic centres_values_1_textured_s3_q;
  logic centres_values_1_of_skin_s3_q;
  logic [2:0] select_502_s3_q;
  logic [6:0] select_504_s3_q;
  logic [6:0] last_s3_q;
  logic and_540_s3_q;
  logic and_542_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_545_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_562_s3_q;
  logic equal_567_s3_q;
  logic not_568_s3_q;
  logic less_645_s3_q;
  logic less_646_s3_q;
  logic less_647_s3_q;
  logic less_648_s3_q;
  logic less_649_s3_q;
  logic less_650_s3_q;
  logic less_651_s3_q;
  logic less_652_s3_q;
  logic less_653_s3_q;
  logic less_654_s3_q;
  logic less_655_s3_q;
  logic less_656_s3_q;
  logic less_657_s3_q;
  logic less_658_s3_q;
  logic less_659_s3_q;
  logic less_660_s3_q;
  logic less_661_s3_q;
  logic less_662_s3_q;
  logic less_663_s3_q;
  logic less_664_s3_q;
  logic less_665_s3_q;
  logic less_666_s3_q;
  logic less_667_s3_q;
  logic less_668_s3_q;
  logic and_676_s3_q;
  logic and_701_s3_q;
  logic and_702_s3_q;
  logic [11:0] sum_717_s3_q;
  logic [9:0] sum_720_s3_q;
  logic and_728_s3_q;
  logic and_732_s3_q;
  logic less_733_s3_q;
  logic less_737_s3_q;
  logic less_739_s3_q;
  logic equal_2074_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2080_s3_q;
  logic equal_2082_s3_q;
  logic equal_2084_s3_q;
  logic equal_2086_s3_q;
  logic equal_2088_s3_q;
  logic equal_2090_s3_q;
  logic equal_2092_s3_q;
  logic equal_2094_s3_q;
  logic equal_2096_s3_q;
  logic less_2105_s3_q;
  logic or_2109_s3_q;
  logic equal_2129_s3_q;
  logic and_2139_s3_q;
  logic and_2142_s3_q;
  logic select_2159_s3_q;
  logic equal_2160_s3_q;
  logic and_2168_s3_q;
  logic equal_2170_s3_q;
  logic select_2217_s3_q;
  logic and_2245_s3_q;
  logic equal_2246_s3_q;
  logic equal_2248_s3_q;
  logic and_2261_s3_q;
  logic [4:0] select_2276_s3_q;
  logic select_2282_s3_q;
  logic [3:0] select_2322_s3_q;
  logic less_2426_s3_q;
  logic equal_2427_s3_q;
  logic not_2428_s3_q;
  logic equal_2429_s3_q;
  logic or_2448_s3_q;
  logic or_2451_s3_q;
  logic or_2454_s3_q;
  logic not_2456_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2483_s3_q;
  logic and_2488_s3_q;
  logic and_2522_s3_q;
  logic less_2523_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2528_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2546_s3_q;
  logic or_2549_s3_q;
  logic or_2552_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2602_s3_q;
  logic [11:0] sum_2732_s3_q;
  logic [9:0] sum_2735_s3_q;
  logic equal_2743_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3037_s3_q;
  logic and_3043_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3105_s3_q;
  logic and_3139_s3_q;
  logic and_3197_s3_q;
  logic and_3198_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3234_s3_q;
  logic and_3248_s3_q;
  logic equal_3291_s3_q;
  logic parity_3670_s3_q;
  logic parity_3799_s3_q;
  logic parity_3861_s3_q;
  logic xor_3889_s3_q;
  logic parity_3901_s3_q;
  logic or_3905_s3_q;
  logic equal_3906_s3_q;
  logic [4:0] select_4025_s3_q;
  logic equal_4037_s3_q;
  logic less_4039_s3_q;
  logic less_4040_s3_q;
  logic or_4045_s3_q;
  logic [7:0] select_4090_s3_q;
  logic equal_4387_s3_q;
  logic and_4564_s3_q;
  logic not_4578_s3_q;
  logic equal_4631_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      sample_pair_pixel_0_s3_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s3_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      census_columns_values_1_cell_2_of_skin_s3_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      registration_of_right_s3_q <= registration_of_right_q;
      patches_choosing_band_s3_q <= patches_choosing_band_s2_q;
      patches_lower_s3_q <= patches_lower_s2_q;
      patches_second_s3_q <= patches_second_s2_q;
      patches_summed_row_column_s3_q <= patches_summed_row_column_q;
      patches_summed_first_s3_q <= patches_summed_first_q;
      patches_summed_last_s3_q <= patches_summed_last_s2_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_s2_q;
      patches_frame_ended_s3_q <= patches_frame_ended_q;
      region_row_s3_q <= region_row_q;
      region_fresh_s3_q <= region_fresh_q;
      centres_values_1_textured_s3_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s3_q <= centres_values_1_of_skin_q;
      select_502_s3_q <= select_502_s2_q;
      select_504_s3_q <= select_504_s2_q;
      last_s3_q <= last_s2_2_q;
      and_540_s3_q <= and_540_s2_q;
      and_542_s3_q <= and_542_s2_q;
      grey_s3_q <= grey;
      equal_545_s3_q <= equal_545;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_562_s3_q <= equal_562_s2_q;
      equal_567_s3_q <= equal_567_s2_q;
      not_568_s3_q <= not_568_s2_q;
      less_645_s3_q <= less_645;
      less_646_s3_q <= less_646;
      less_647_s3_q <= less_647;
      less_648_s3_q <= less_648;
      less_649_s3_q <= less_649;
      less_650_s3_q <= less_650;
      less_651_s3_q <= less_651;
      less_652_s3_q <= less_652;
      less_653_s3_q <= less_653;
      less_654_s3_q <= less_654;
      less_655_s3_q <= less_655;
      less_656_s3_q <= less_656;
      less_657_s3_q <= less_657;
      less_658_s3_q <= less_658;
      less_659_s3_q <= less_659;
      less_660_s3_q <= less_660;
      less_661_s3_q <= less_661;
      less_662_s3_q <= less_662;
      less_663_s3_q <= less_663;
      less_664_s3_q <= less_664;
      less_665_s3_q <= less_665;
      less_666_s3_q <= less_666;
      less_667_s3_q <= less_667;
      less_668_s3_q <= less_668;
      and_676_s3_q <= and_676;
      and_701_s3_q <= whole_22 & and_676;
      and_702_s3_q <= census_columns_values_1_cell_2_mask_q & and_676;
      sum_717_s3_q <= {1'b0, sum_713} + {2'h0, sum_716};
      sum_720_s3_q <= {9'h0, difference_718[9]} + {1'b0, xor_719};
      and_728_s3_q <= and_728;
      and_732_s3_q <= and_732;
      less_733_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_737_s3_q <= {{5{sum_736[6]}}, sum_736, half_grey_levels_2[3:0]} < 16'hffe1;
      less_739_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2074_s3_q <= equal_2074;
      all_s3_q <= all;
      sum_2080_s3_q <= sum_2080;
      equal_2082_s3_q <= equal_2082;
      equal_2084_s3_q <= equal_2084;
      equal_2086_s3_q <= equal_2086;
      equal_2088_s3_q <= equal_2088;
      equal_2090_s3_q <= equal_2090;
      equal_2092_s3_q <= equal_2092;
      equal_2094_s3_q <= equal_2094;
      equal_2096_s3_q <= equal_2096;
      less_2105_s3_q <= less_2105;
      or_2109_s3_q <= or_2109;
      equal_2129_s3_q <= (registration_fresh_q & select_2127) == 4'h0;
      and_2139_s3_q <= not_568_s2_q & and_2123;
      and_2142_s3_q <= and_2142_s2_q;
      select_2159_s3_q <= select_2159[1];
      equal_2160_s3_q <= equal_2160;
      and_2168_s3_q <= and_2168;
      equal_2170_s3_q <= equal_2170;
      select_2217_s3_q <= select_2217;
      and_2245_s3_q <= and_2245;
      equal_2246_s3_q <= equal_2246_s2_q;
      equal_2248_s3_q <= equal_2248_s2_q;
      and_2261_s3_q <= and_2245 & equal_2260;
      select_2276_s3_q <= select_2276_s2_q;
      select_2282_s3_q <= select_2282_s2_q;
      select_2322_s3_q <= select_2322_s2_q;
      less_2426_s3_q <= less_2426_s2_q;
      equal_2427_s3_q <= equal_2427_s2_q;
      not_2428_s3_q <= not_2428_s2_q;
      equal_2429_s3_q <= equal_2429_s2_q;
      or_2448_s3_q <= or_2448;
      or_2451_s3_q <= or_2451;
      or_2454_s3_q <= or_2454;
      not_2456_s3_q <= not_2456;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2483_s3_q <= inside_v_s2_q & (and_2481 & and_2052);
      and_2488_s3_q <= not_568_s2_q & and_2463;
      and_2522_s3_q <= and_2522;
      less_2523_s3_q <= less_2523;
      index_2_s3_q <= index_2[5:0];
      sum_2528_s3_q <= sum_2528;
      textured_2_s3_q <= textured_2;
      or_2546_s3_q <= or_2546;
      or_2549_s3_q <= select_2543[7] | (~({select_2543[6], select_2543[3:2]} == 3'h0));
      or_2552_s3_q <= select_2543[7] | (~(select_2543[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2602_s3_q <= and_2602;
      sum_2732_s3_q <= {1'b0, sum_2728} + {2'h0, sum_2731};
      sum_2735_s3_q <= {9'h0, difference_2733[9]} + {1'b0, xor_2734};
      equal_2743_s3_q <= equal_2743_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3037_s3_q <= and_3037;
      and_3043_s3_q <= and_3043;
      explained_2_s3_q <= explained_2;
      and_3105_s3_q <= not_568_s2_q & and_3104;
      and_3139_s3_q <= not_568_s2_q & and_3138;
      and_3197_s3_q <= not_568_s2_q & (so_s2_q & (half_ends & equal_3194));
      and_3198_s3_q <= and_3198;
      residual_s3_q <= residual[7:0];
      and_3234_s3_q <= and_3234;
      and_3248_s3_q <= and_3198 & less_3247;
      equal_3291_s3_q <= (registration_fresh_q & select_3289) == 4'h0;
      parity_3670_s3_q <= ^{xor_3666, xor_3629, select_3596[44:36], other[44:36]};
      parity_3799_s3_q <= parity_3799;
      parity_3861_s3_q <= parity_3861;
      xor_3889_s3_q <= parity_3876 ^ parity_3888;
      parity_3901_s3_q <= ^{or_3898, or_3894, and_3890};
      or_3905_s3_q <= (or_3894 & or_3898) | (and_3890 & (or_3894 | or_3898));
      equal_3906_s3_q <= equal_3906_s2_q;
      select_4025_s3_q <= select_4025[14:10];
      equal_4037_s3_q <= select_3994[3:0] == 4'h0;
      less_4039_s3_q <= {difference_4038, 3'h0} < {3'h0, sum_3586};
      less_4040_s3_q <= select_4035 < select_4025[9:0];
      or_4045_s3_q <= (sum_3586 < 10'h39) | ({1'b0, sum_3586[9:1]} < select_4025[9:0]);
      select_4090_s3_q <= select_4090;
      equal_4387_s3_q <= equal_4387;
      and_4564_s3_q <= and_2602 & ({sum_2528, index_2[5:0]} == {sum_2515, index[5:0]});
      not_4578_s3_q <= ~proven_q;
      equal_4631_s3_q <= (registration_fresh_q & select_4629) == 4'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [19:0] census_left_misses_q;
  logic sharpness_last_mask_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic sharpness_before_last_mask_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [13:0] counts_skin_unproven_q;
  logic [13:0] counts_on_skin_q;
  logic [13:0] registration_half_across_q;
  logic [5:0] registration_half_measured_q;
  logic [6:0] registration_half_votes_down_q;
  logic [6:0] registration_half_votes_up_q;
  logic [6:0] registration_half_half_votes_down_q;
  logic [6:0] registration_half_half_votes_up_q;
  logic [13:0] registration_down_q;
  logic [13:0] registration_up_q;
  logic registration_enough_q;
  logic registration_votes_down_q;
  logic registration_votes_up_q;
  logic registration_other_enough_q;
  logic registration_other_down_q;
  logic registration_other_up_q;
  logic registration_moved_q;
  logic patches_place_0_valid_q;
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic patches_place_1_valid_q;
  logic [7:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic [9:0] patches_sums_values_0_q;
  logic [9:0] patches_sums_values_1_q;
  logic [9:0] patches_sums_values_2_q;
  logic [9:0] patches_sums_values_3_q;
  logic [9:0] patches_sums_values_4_q;
  logic [9:0] patches_sums_values_5_q;
  logic [9:0] patches_sums_values_6_q;
  logic [9:0] patches_sums_values_7_q;
  logic [9:0] patches_sums_values_8_q;
  logic [9:0] patches_sums_values_9_q;
  logic [9:0] patches_sums_values_10_q;
  logic [9:0] patches_sums_values_11_q;
  logic [9:0] patches_sums_values_12_q;
  logic [9:0] patches_sums_values_13_q;
  logic [9:0] patches_sums_values_14_q;
  logic [9:0] patches_sums_values_15_q;
  logic [9:0] patches_sums_values_16_q;
  logic [9:0] patches_best_differing_q;
  logic [4:0] patches_best_column_q;
  logic [7:0] patches_quarters_0_places_q;
  logic [7:0] patches_quarters_0_up_q;
  logic [7:0] patches_quarters_0_down_q;
  logic [7:0] patches_quarters_1_places_q;
  logic [7:0] patches_quarters_1_up_q;
  logic [7:0] patches_quarters_1_down_q;
  logic [7:0] patches_quarters_2_places_q;
  logic [7:0] patches_quarters_2_up_q;
  logic [7:0] patches_quarters_2_down_q;
  logic [7:0] patches_quarters_3_places_q;
  logic [7:0] patches_quarters_3_up_q;
  logic [7:0] patches_quarters_3_down_q;
  logic [7:0] patches_word_places_q;
  logic [7:0] patches_word_up_q;
  logic [7:0] patches_word_down_q;
  logic [7:0] patches_sum_places_q;
  logic [7:0] patches_sum_up_q;
  logic [7:0] patches_sum_down_q;
  logic [11:0] patches_across_q;
  logic [7:0] patches_places_q;
  logic patches_enough_q;
  logic patches_mostly_q;
  logic patches_partly_q;
  logic [6:0] patches_clear_limit_q;
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [2:0] patches_found_q;
  logic patches_doubted_q;
  logic patches_doubted_before_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic [7:0] patches_round_on_skin_q;
  logic [7:0] patches_on_skin_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_twice_q;
  logic patches_clear_q;
  logic [9:0] patches_age_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic good_known_q;
  logic [7:0] hidden_for_q;
  logic [13:0] product_q;
  logic product_rest_q;
  logic disagree_q;
  logic too_much_q;
  logic hides_q;
  logic overlooks_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [2:0] box_explained_columns_values_0_q;
  logic [2:0] box_explained_columns_values_1_q;
  logic [2:0] box_explained_columns_values_2_q;
  logic [2:0] box_explained_columns_values_3_q;
  logic [2:0] box_explained_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [2:0] box_shown_columns_values_0_q;
  logic [2:0] box_shown_columns_values_1_q;
  logic [2:0] box_shown_columns_values_2_q;
  logic [2:0] box_shown_columns_values_3_q;
  logic [2:0] box_shown_columns_values_4_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [2:0] box_nearer_columns_values_0_q;
  logic [2:0] box_nearer_columns_values_1_q;
  logic [2:0] box_nearer_columns_values_2_q;
  logic [2:0] box_nearer_columns_values_3_q;
  logic [2:0] box_nearer_columns_values_4_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:281
  logic [11:0] texture;
  assign texture = sum_717_s3_q + {2'h0, sum_720_s3_q};
  // hls/stages/census.hpp:292
  logic [12:0] sum_722;
  assign sum_722 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_724;
  assign sum_724 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_722});
  // hls/stages/census.hpp:314
  logic less_725;
  assign less_725 = 9'h4 < sum_724[13:5];
  logic and_726;
  assign and_726 = and_676_s3_q & less_725;
  // hls/stages/moments.hpp:30
  logic and_738;
  assign and_738 = (and_701_s3_q & and_728_s3_q) & less_737_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2131;
  assign equal_2131 = sum_2080_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2080_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2133;
  assign select_2133 = equal_2131 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2134;
  assign sum_2134 = (equal_2129_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2133[13]}}, select_2133};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2080_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2137;
  assign select_2137 = equal_2131 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2138;
  assign sum_2138 = (equal_2129_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2137[6]}}, select_2137};
  // hls/stages/patches.hpp:354
  logic [22:0] select_2262;
  assign select_2262 = and_2261_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2217_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2264;
  assign select_2264 = equal_2160_s3_q ? patches_place_0_valid_q : (select_2159_s3_q ? patches_place_0_valid_q : select_2262[0]);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2265;
  assign sum_2265 = {1'b0, select_504_s3_q, select_502_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:355
  logic [21:0] select_2266;
  assign select_2266 = select_2159_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2262[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2267;
  assign select_2267 = equal_2160_s3_q ? patches_place_0_column_q : select_2266[7:0];
  logic [5:0] select_2268;
  assign select_2268 = equal_2160_s3_q ? patches_place_0_shift_q : select_2266[13:8];
  // hls/stages/patches.hpp:324
  logic [8:0] sum_2269;
  assign sum_2269 = {1'b0, select_2267} + {{3{select_2268[5]}}, select_2268};
  // hls/stages/patches.hpp:132
  logic equal_2270;
  assign equal_2270 = {sum_2269, sum_2265[0], select_502_s3_q[1:0]} == {1'b0, sum_2265[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2272;
  assign or_2272 = and_2142_s3_q | (select_2264 & equal_2270);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2273;
  assign select_2273 = or_2272 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2283;
  assign select_2283 = or_2272 ? {and_2142_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2285;
  assign and_2285 = select_2282_s3_q & (~select_2283[5]);
  // hls/stages/patches.hpp:127
  logic select_2293;
  assign select_2293 = equal_2160_s3_q ? patches_place_1_valid_q : (select_2159_s3_q ? select_2262[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:355
  logic [21:0] select_2294;
  assign select_2294 = select_2159_s3_q ? select_2262[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2295;
  assign select_2295 = equal_2160_s3_q ? patches_place_1_column_q : select_2294[7:0];
  logic [5:0] select_2296;
  assign select_2296 = equal_2160_s3_q ? patches_place_1_shift_q : select_2294[13:8];
  // hls/stages/patches.hpp:324
  logic [8:0] sum_2297;
  assign sum_2297 = {1'b0, select_2295} + {{3{select_2296[5]}}, select_2296};
  // hls/stages/patches.hpp:132
  logic equal_2298;
  assign equal_2298 = {sum_2297[8], sum_2265, select_502_s3_q[1:0]} == {1'b0, sum_2297[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2300;
  assign or_2300 = and_2142_s3_q | (select_2293 & equal_2298);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2301;
  assign select_2301 = or_2300 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2302;
  assign select_2302 = or_2300 ? {and_2142_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2304;
  assign and_2304 = select_2282_s3_q & (~select_2302[5]);
  // hls/stages/patches.hpp:320
  logic [7:0] sum_2311;
  assign sum_2311 = select_2267 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2312;
  assign equal_2312 = {sum_2311[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2311[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2314;
  assign or_2314 = and_2142_s3_q | (select_2264 & equal_2312);
  logic [4:0] select_2315;
  assign select_2315 = or_2314 ? {and_2142_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:320
  logic [7:0] sum_2316;
  assign sum_2316 = select_2295 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2317;
  assign equal_2317 = {sum_2316[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2316[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2320;
  assign select_2320 = (and_2142_s3_q | (select_2293 & equal_2317)) ? {and_2142_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2315[4] ? select_2320[3:0] : select_2315[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2323;
  assign select_2323 = or_2314 ? and_2142_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2329;
  assign and_2329 = (select_2282_s3_q & (select_2276_s3_q[3] ^ select_2276_s3_q[4])) & ((~select_2315[4]) | (~select_2320[4]));
  // hls/stages/patches.hpp:185
  logic less_2438;
  assign less_2438 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_2439;
  assign not_2439 = ~less_2438;
  logic [1:0] select_2440;
  assign select_2440 = patches_summed_first_s3_q ? 2'h2 : {less_2438, not_2439};
  logic [12:0] select_2442;
  assign select_2442 = select_2440[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2443;
  assign select_2443 = select_2440[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2444;
  assign select_2444 = (select_2440 == 2'h2) ? {select_2442[12:8], patches_sums_values_0_q[9:8], select_2442[7:0]} : select_2443;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2469;
  assign select_2469 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2470;
  assign sum_2470 = {6'h0, textured_s3_q} + select_2469;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2472;
  assign sum_2472 = {3'h0, sum_2470} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2474;
  assign select_2474 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2475;
  assign sum_2475 = {6'h0, explained_s3_q} + select_2474;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2477;
  assign sum_2477 = {3'h0, sum_2475} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2484;
  assign select_2484 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2485;
  assign sum_2485 = {6'h0, and_2483_s3_q} + select_2484;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2487;
  assign sum_2487 = {3'h0, sum_2485} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2537;
  assign select_2537 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2538;
  assign difference_2538 = {1'b0, textured_2_s3_q} - {1'b0, select_2537};
  logic [4:0] t;
  assign t = {difference_2538[3], difference_2538} + (equal_562_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2541;
  assign equal_2541 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2553;
  assign not_2553 = ~region_row_s3_q[2];
  logic [2:0] select_2554;
  assign select_2554 = region_row_s3_q[1] ? {1'b0, not_2553, 1'b0} : {region_row_s3_q[2], 1'b0, not_2553};
  logic [5:0] select_2555;
  assign select_2555 = region_row_s3_q[0] ? {select_2554[2], 1'b0, select_2554[1], 1'b0, select_2554[0], 1'b0} : {1'b0, select_2554[2], 1'b0, select_2554[1], 1'b0, select_2554[0]};
  logic [11:0] select_2556;
  assign select_2556 = or_2552_s3_q ? {select_2555[5], 1'b0, select_2555[4], 1'b0, select_2555[3], 1'b0, select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0], 1'b0} : {1'b0, select_2555[5], 1'b0, select_2555[4], 1'b0, select_2555[3], 1'b0, select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0]};
  logic [23:0] select_2557;
  assign select_2557 = or_2549_s3_q ? {select_2556[11], 1'b0, select_2556[10], 1'b0, select_2556[9], 1'b0, select_2556[8], 1'b0, select_2556[7], 1'b0, select_2556[6], 1'b0, select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0], 1'b0} : {1'b0, select_2556[11], 1'b0, select_2556[10], 1'b0, select_2556[9], 1'b0, select_2556[8], 1'b0, select_2556[7], 1'b0, select_2556[6], 1'b0, select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0]};
  logic [47:0] select_2558;
  assign select_2558 = or_2546_s3_q ? {select_2557[23], 1'b0, select_2557[22], 1'b0, select_2557[21], 1'b0, select_2557[20], 1'b0, select_2557[19], 1'b0, select_2557[18], 1'b0, select_2557[17], 1'b0, select_2557[16], 1'b0, select_2557[15], 1'b0, select_2557[14], 1'b0, select_2557[13], 1'b0, select_2557[12], 1'b0, select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0], 1'b0} : {1'b0, select_2557[23], 1'b0, select_2557[22], 1'b0, select_2557[21], 1'b0, select_2557[20], 1'b0, select_2557[19], 1'b0, select_2557[18], 1'b0, select_2557[17], 1'b0, select_2557[16], 1'b0, select_2557[15], 1'b0, select_2557[14], 1'b0, select_2557[13], 1'b0, select_2557[12], 1'b0, select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2562;
  assign and_2562 = good_known_q & (~((good_q & select_2558) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2571;
  assign select_2571 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2572;
  assign difference_2572 = {1'b0, shown_2_s3_q} - {1'b0, select_2571};
  logic [4:0] around;
  assign around = {difference_2572[3], difference_2572} + (equal_562_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2575;
  assign sum_2575 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2541 ? and_2562 : (~({sum_2575, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2587;
  assign select_2587 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2588;
  assign difference_2588 = {1'b0, near_2_s3_q} - {1'b0, select_2587};
  logic [4:0] n;
  assign n = {difference_2588[3], difference_2588} + (equal_562_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2592;
  assign and_2592 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2626;
  assign select_2626 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2628;
  assign select_2628 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2630;
  assign select_2630 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2632;
  assign select_2632 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2637;
  assign sum_2637 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2638;
  assign difference_2638 = {1'b0, sum_2637[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2639;
  assign xor_2639 = {difference_2638[8:0], sum_2637[0]} ^ {10{difference_2638[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2638[9]} + {1'b0, xor_2639};
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_545_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2644;
  assign select_2644 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2645;
  assign sum_2645 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2646;
  assign difference_2646 = {1'b0, sum_2645[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2647;
  assign xor_2647 = {difference_2646[8:0], sum_2645[0]} ^ {10{difference_2646[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2646[9]} + {1'b0, xor_2647};
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_545_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2652;
  assign select_2652 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2736;
  assign sum_2736 = sum_2732_s3_q + {2'h0, sum_2735_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2738;
  assign select_2738 = and_542_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2739;
  assign select_2739 = and_542_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2740;
  assign select_2740 = and_542_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2741;
  assign select_2741 = and_542_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [12:0] sum_2744;
  assign sum_2744 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2736};
  logic [13:0] sum_2746;
  assign sum_2746 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2744});
  // hls/stages/census.hpp:320
  logic and_2748;
  assign and_2748 = and_701_s3_q & (9'h4 < sum_2746[13:5]);
  // hls/stages/census.hpp:321
  logic and_2749;
  assign and_2749 = and_701_s3_q & less_725;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2750;
  assign sum_2750 = census_left_misses_q + {{17{and_2749}}, and_2748, 1'b0, and_2748};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2752;
  assign select_2752 = and_542_s3_q ? (equal_2743_s3_q ? 20'h0 : sum_2750) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2822;
  assign select_2822 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2825;
  assign select_2825 = and_542_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2828;
  assign and_2828 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2834;
  assign and_2834 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2835;
  assign and_2835 = and_2828 & and_2834;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2822[13:0]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2837;
  assign select_2837 = and_2835 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2839;
  assign select_2839 = equal_2743_s3_q ? {11'h0, select_2837} : (sharpness_sums_detail_0_q + {11'h0, select_2837});
  // hls/stages/agreement.hpp:457
  logic and_2846;
  assign and_2846 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2847;
  assign and_2847 = and_2828 & and_2846;
  // hls/stages/census.hpp:369
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2822[27:14]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2849;
  assign select_2849 = and_2847 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2851;
  assign select_2851 = equal_2743_s3_q ? {11'h0, select_2849} : (sharpness_sums_detail_1_q + {11'h0, select_2849});
  logic [8:0] select_2854;
  assign select_2854 = and_2835 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2855;
  assign sum_2855 = (equal_2743_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2854};
  logic [8:0] select_2858;
  assign select_2858 = and_2847 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2859;
  assign sum_2859 = (equal_2743_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2858};
  // hls/stages/agreement.hpp:211
  logic equal_2861;
  assign equal_2861 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:385
  logic less_2862;
  assign less_2862 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:424
  logic less_2863;
  assign less_2863 = x_s3_q[4:0] < 5'h3;
  logic not_2864;
  assign not_2864 = ~x_s3_q[1];
  logic [2:0] select_2865;
  assign select_2865 = x_s3_q[0] ? {1'b0, not_2864, 1'b0} : {x_s3_q[1], 1'b0, not_2864};
  logic [5:0] select_2866;
  assign select_2866 = slot_s3_q[2] ? {select_2865[2], 1'b0, select_2865[1], 1'b0, select_2865[0], 1'b0} : {1'b0, select_2865[2], 1'b0, select_2865[1], 1'b0, select_2865[0]};
  logic [11:0] select_2867;
  assign select_2867 = slot_s3_q[1] ? {select_2866[5], 1'b0, select_2866[4], 1'b0, select_2866[3], 1'b0, select_2866[2], 1'b0, select_2866[1], 1'b0, select_2866[0], 1'b0} : {1'b0, select_2866[5], 1'b0, select_2866[4], 1'b0, select_2866[3], 1'b0, select_2866[2], 1'b0, select_2866[1], 1'b0, select_2866[0]};
  logic [23:0] select_2868;
  assign select_2868 = slot_s3_q[0] ? {select_2867[11], 1'b0, select_2867[10], 1'b0, select_2867[9], 1'b0, select_2867[8], 1'b0, select_2867[7], 1'b0, select_2867[6], 1'b0, select_2867[5], 1'b0, select_2867[4], 1'b0, select_2867[3], 1'b0, select_2867[2], 1'b0, select_2867[1], 1'b0, select_2867[0], 1'b0} : {1'b0, select_2867[11], 1'b0, select_2867[10], 1'b0, select_2867[9], 1'b0, select_2867[8], 1'b0, select_2867[7], 1'b0, select_2867[6], 1'b0, select_2867[5], 1'b0, select_2867[4], 1'b0, select_2867[3], 1'b0, select_2867[2], 1'b0, select_2867[1], 1'b0, select_2867[0]};
  // hls/stages/census.hpp:387
  logic and_2872;
  assign and_2872 = less_2863 & (~((sharpness_sums_contrast_1_q & select_2868) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2874;
  assign select_2874 = (less_2862 & and_2872) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2874};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2877;
  assign select_2877 = equal_2861 ? (less_2862 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:387
  logic and_2882;
  assign and_2882 = less_2863 & (~((sharpness_sums_contrast_0_q & select_2868) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2884;
  assign select_2884 = (less_2862 & and_2882) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2884};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2887;
  assign select_2887 = equal_2861 ? (less_2862 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2889;
  assign select_2889 = equal_2861 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2891;
  assign select_2891 = equal_2861 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2893;
  assign select_2893 = equal_2861 ? {sharpness_comparing_contrast_0_q[0], and_2882} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2895;
  assign select_2895 = equal_2861 ? {sharpness_comparing_contrast_1_q[0], and_2872} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2900;
  assign select_2900 = drew_q ? (equal_2861 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2904;
  assign select_2904 = drew_q ? (equal_2861 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:384
  logic equal_2905;
  assign equal_2905 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:400
  logic xor_2906;
  assign xor_2906 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2909;
  assign select_2909 = (equal_2905 | xor_2906) ? (five_times[0] & xor_2906) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2911;
  assign select_2911 = drew_q ? (equal_2861 ? select_2909 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic xor_2912;
  assign xor_2912 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2915;
  assign select_2915 = (equal_2905 | xor_2912) ? (five_times_2[0] & xor_2912) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2917;
  assign select_2917 = drew_q ? (equal_2861 ? select_2915 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:401
  logic xor_2918;
  assign xor_2918 = sharpness_comparing_contrast_0_q[1] ^ and_2872;
  logic select_2921;
  assign select_2921 = (equal_2905 | xor_2918) ? (and_2872 & xor_2918) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2923;
  assign select_2923 = drew_q ? (equal_2861 ? select_2921 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2924;
  assign xor_2924 = sharpness_comparing_contrast_1_q[1] ^ and_2882;
  logic select_2927;
  assign select_2927 = (equal_2905 | xor_2924) ? (and_2882 & xor_2924) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2929;
  assign select_2929 = drew_q ? (equal_2861 ? select_2927 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3045;
  assign select_3045 = and_3037_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3043_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3048;
  assign and_3048 = not_568_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3053;
  assign and_3053 = not_568_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3058;
  assign and_3058 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_2483_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3062;
  assign not_3062 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3071;
  assign select_3071 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3072;
  assign difference_3072 = {1'b0, explained_2_s3_q} - {1'b0, select_3071};
  logic [4:0] e;
  assign e = {difference_3072[3], difference_3072} + (equal_562_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3075;
  assign sum_3075 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3079;
  assign not_3079 = ~(equal_2541 ? and_2562 : (~({sum_3075, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3082;
  assign and_3082 = ends_cell_s3_q & (not_3062 & (centres_values_1_textured_s3_q & not_3079));
  logic and_3084;
  assign and_3084 = not_568_s3_q & (drew_q & and_3082);
  // hls/stages/agreement.hpp:1132
  logic less_3087;
  assign less_3087 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3088;
  assign select_3088 = less_3087 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3091;
  assign select_3091 = less_3087 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3092;
  assign sum_3092 = {1'b0, select_3091} + {3'h0, select_3091[9:2]};
  logic and_3094;
  assign and_3094 = (~(select_3088[9:4] == 6'h0)) & ({sum_3092, select_3091[1:0]} < {3'h0, select_3088});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3097;
  assign select_3097 = x_s3_q[6] ? (equal_2074_s3_q ? 10'h0 : (and_3094 ? select_3088 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3098;
  assign select_3098 = equal_567_s3_q ? select_3097 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3100;
  assign select_3100 = and_3037_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3098});
  logic [13:0] select_3107;
  assign select_3107 = and_3037_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3105_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3109;
  assign and_3109 = not_3062 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3112;
  assign and_3112 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_3109));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3114;
  assign select_3114 = and_3037_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3112});
  // hls/stages/agreement.hpp:1110
  logic and_3116;
  assign and_3116 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3079);
  // hls/stages/agreement.hpp:788
  logic and_3120;
  assign and_3120 = not_568_s3_q & (drew_q & (ends_cell_s3_q & (not_3062 & and_3116)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3122;
  assign select_3122 = and_3037_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3120});
  logic [13:0] select_3141;
  assign select_3141 = and_3037_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3139_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3216;
  assign select_3216 = drew_q ? (equal_2170_s3_q ? (and_3198_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3217;
  assign select_3217 = equal_567_s3_q ? 8'h0 : select_3216;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3219;
  assign select_3219 = and_3197_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3217[7]}}, select_3217});
  // hls/stages/agreement.hpp:788
  logic and_3222;
  assign and_3222 = not_568_s3_q & (drew_q & (and_3198_s3_q & equal_2170_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3224;
  assign select_3224 = and_3197_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3222});
  // hls/stages/registration.hpp:107
  logic and_3226;
  assign and_3226 = and_3198_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3228;
  assign select_3228 = drew_q ? (equal_2170_s3_q ? {and_3226, and_3198_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3229;
  assign select_3229 = equal_567_s3_q ? 2'h0 : select_3228;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3230;
  assign sum_3230 = registration_half_votes_down_q + {{5{select_3229[1]}}, select_3229};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3236;
  assign select_3236 = drew_q ? (equal_2170_s3_q ? {and_3234_s3_q, and_3198_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3237;
  assign select_3237 = equal_567_s3_q ? 2'h0 : select_3236;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3238;
  assign sum_3238 = registration_half_votes_up_q + {{5{select_3237[1]}}, select_3237};
  // hls/stages/registration.hpp:107
  logic and_3241;
  assign and_3241 = and_3198_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3243;
  assign select_3243 = drew_q ? (equal_2170_s3_q ? {and_3241, and_3198_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3244;
  assign select_3244 = equal_567_s3_q ? 2'h0 : select_3243;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3245;
  assign sum_3245 = registration_half_half_votes_down_q + {{5{select_3244[1]}}, select_3244};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3250;
  assign select_3250 = drew_q ? (equal_2170_s3_q ? {and_3248_s3_q, and_3198_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3251;
  assign select_3251 = equal_567_s3_q ? 2'h0 : select_3250;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3252;
  assign sum_3252 = registration_half_half_votes_up_q + {{5{select_3251[1]}}, select_3251};
  // hls/stages/agreement.hpp:788
  logic and_3286;
  assign and_3286 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & less_2105_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3293;
  assign select_3293 = or_2109_s3_q ? 12'h0 : (equal_3291_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3296;
  assign select_3296 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3293 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3297;
  assign select_3297 = equal_567_s3_q ? select_3296 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3298;
  assign and_3298 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3301;
  assign and_3301 = not_2456_s3_q & (less_2105_s3_q & ({and_3298, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3303;
  assign and_3303 = equal_567_s3_q & (x_s3_q[6] & and_3301);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3305;
  assign sum_3305 = {{2{select_3297[11]}}, select_3297} + (and_3303 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3308;
  assign select_3308 = or_2109_s3_q ? 12'h0 : (equal_3291_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3311;
  assign select_3311 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3308 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3312;
  assign select_3312 = equal_567_s3_q ? select_3311 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3314;
  assign sum_3314 = {{2{select_3312[11]}}, select_3312} + (and_3303 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3316;
  assign not_3316 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3319;
  assign and_3319 = not_2456_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3316, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3325;
  assign and_3325 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & (less_2105_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3326;
  assign not_3326 = ~and_3325;
  logic less_3327;
  assign less_3327 = $signed({9'h1, {2{not_3326}}, and_3325}) < $signed(registration_up_q[13:2]);
  logic select_3328;
  assign select_3328 = (equal_567_s3_q & (x_s3_q[6] & and_3319)) ? less_3327 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3332;
  assign and_3332 = x_s3_q[6] & (not_2456_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3333;
  assign and_3333 = equal_567_s3_q & and_3332;
  // hls/stages/registration.hpp:242
  logic less_3334;
  assign less_3334 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3336;
  assign less_3336 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3338;
  assign equal_3338 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3342;
  assign and_3342 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & (less_2105_s3_q & equal_3338)));
  // hls/stages/agreement.hpp:1142
  logic and_3349;
  assign and_3349 = x_s3_q[6] & (not_2456_s3_q & (less_2105_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3352;
  assign equal_3352 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3355;
  assign and_3355 = not_2456_s3_q & (less_2105_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3352));
  // hls/stages/registration.hpp:244
  logic and_3359;
  assign and_3359 = (equal_567_s3_q & (x_s3_q[6] & and_3355)) & (less_3336 | less_3334);
  // hls/stages/agreement.hpp:1142
  logic and_3364;
  assign and_3364 = not_2456_s3_q & (less_2105_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3352)));
  // hls/stages/registration.hpp:244
  logic and_3367;
  assign and_3367 = registration_votes_up_q & registration_other_down_q;
  logic select_3369;
  assign select_3369 = registration_votes_down_q ? (registration_other_up_q | and_3367) : and_3367;
  // hls/stages/registration.hpp:138
  logic and_3371;
  assign and_3371 = (equal_567_s3_q & (x_s3_q[6] & and_3364)) & (registration_other_enough_q & select_3369);
  // hls/stages/registration.hpp:245
  logic or_3374;
  assign or_3374 = registration_moved_q | (registration_enough_q & (and_3359 | and_3371));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3459;
  assign select_3459 = sample_pair_whole_s3_q ? (equal_2160_s3_q ? patches_place_0_slope_q : select_2266[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3464;
  assign select_3464 = sample_pair_whole_s3_q ? (equal_2160_s3_q ? patches_place_1_slope_q : select_2294[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3466;
  assign select_3466 = equal_2160_s3_q ? patches_valid_0_q : (select_2159_s3_q ? patches_valid_0_q : select_2262[0]);
  // hls/stages/agreement.hpp:276
  logic select_3469;
  assign select_3469 = sample_pair_whole_s3_q ? (and_2285 ? (sample_present_s3_q & select_3466) : select_3466) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3471;
  assign select_3471 = equal_2160_s3_q ? patches_valid_1_q : (select_2159_s3_q ? select_2262[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3474;
  assign select_3474 = sample_pair_whole_s3_q ? (and_2304 ? (sample_present_s3_q & select_3471) : select_3471) : patches_valid_1_q;
  logic [5:0] select_3477;
  assign select_3477 = sample_pair_whole_s3_q ? (select_2283[5] ? {1'b1, select_2283[4:0]} : (select_2283 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3480;
  assign select_3480 = sample_pair_whole_s3_q ? (select_2302[5] ? {1'b1, select_2302[4:0]} : (select_2302 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3483;
  assign select_3483 = sample_pair_whole_s3_q ? (select_2315[4] ? {1'b1, select_2315[3:0]} : (select_2315 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3486;
  assign select_3486 = sample_pair_whole_s3_q ? (select_2320[4] ? {1'b1, select_2320[3:0]} : (select_2320 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3905_s3_q, parity_3901_s3_q, xor_3889_s3_q, parity_3861_s3_q, parity_3799_s3_q, parity_3670_s3_q} + (equal_3906_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3910;
  assign select_3910 = equal_2246_s3_q ? patches_sums_values_0_q : (equal_2248_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3911;
  assign select_3911 = equal_2248_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3913;
  assign select_3913 = equal_2248_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3915;
  assign select_3915 = equal_2248_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3917;
  assign select_3917 = equal_2248_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3919;
  assign select_3919 = equal_2248_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3921;
  assign select_3921 = equal_2248_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3923;
  assign select_3923 = equal_2248_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3925;
  assign select_3925 = equal_2248_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3927;
  assign select_3927 = equal_2248_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3929;
  assign select_3929 = equal_2248_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3931;
  assign select_3931 = equal_2248_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3933;
  assign select_3933 = equal_2248_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3935;
  assign select_3935 = equal_2248_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3937;
  assign select_3937 = equal_2248_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3939;
  assign select_3939 = equal_2248_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3941;
  assign select_3941 = equal_2248_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:600
  logic or_4046;
  assign or_4046 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4045_s3_q;
  logic or_4049;
  assign or_4049 = equal_4037_s3_q | (less_4039_s3_q | (less_4040_s3_q | or_4046));
  // hls/stages/patches.hpp:580
  logic not_4050;
  assign not_4050 = ~or_4049;
  // hls/stages/patches.hpp:561
  logic and_4051;
  assign and_4051 = equal_2429_s3_q & not_4050;
  // hls/stages/patches.hpp:185
  logic and_4054;
  assign and_4054 = equal_2246_s3_q & (less_2426_s3_q ? (not_2428_s3_q & and_4051) : and_4051);
  // hls/stages/patches.hpp:658
  logic not_4055;
  assign not_4055 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:561
  logic and_4057;
  assign and_4057 = equal_2429_s3_q & (patches_second_s3_q & not_4050);
  // hls/stages/patches.hpp:185
  logic and_4060;
  assign and_4060 = equal_2246_s3_q & (less_2426_s3_q ? (not_2428_s3_q & and_4057) : and_4057);
  // hls/stages/patches.hpp:658
  logic not_4061;
  assign not_4061 = ~and_4060;
  // hls/stages/patches.hpp:189
  logic and_4063;
  assign and_4063 = and_4054 & (not_4055 & not_4061);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4065;
  assign sum_4065 = {7'h0, and_4063} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:598
  logic [7:0] select_4091;
  assign select_4091 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [5:0] select_4092;
  assign select_4092 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4093;
  assign sum_4093 = {2'h0, select_4025_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4094;
  assign sum_4094 = {select_4092[5], select_4092} + {{3{sum_4093[3]}}, sum_4093};
  // hls/stages/patches.hpp:598
  logic [17:0] product_4095;
  assign product_4095 = $signed({{10{select_4091[7]}}, select_4091}) * $signed({{8{sum_4094[6]}}, sum_4094, select_4025_s3_q[2:0]});
  // hls/stages/patches.hpp:599
  logic [13:0] difference_4096;
  assign difference_4096 = {{6{select_4090_s3_q[7]}}, select_4090_s3_q} - {product_4095[17], product_4095[17:5]};
  // hls/stages/patches.hpp:605
  logic less_4097;
  assign less_4097 = $signed({{7{difference_4067[6]}}, difference_4067}) < $signed(difference_4096);
  // hls/stages/patches.hpp:561
  logic and_4100;
  assign and_4100 = equal_2429_s3_q & (not_4050 & (~less_4097));
  // hls/stages/patches.hpp:185
  logic and_4103;
  assign and_4103 = equal_2246_s3_q & (less_2426_s3_q ? (not_2428_s3_q & and_4100) : and_4100);
  // hls/stages/patches.hpp:661
  logic and_4104;
  assign and_4104 = and_4103 & and_4063;
  logic [7:0] sum_4105;
  assign sum_4105 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4104};
  // hls/stages/patches.hpp:561
  logic and_4109;
  assign and_4109 = not_4050 & (~($signed(difference_4096) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4110;
  assign and_4110 = equal_2429_s3_q & and_4109;
  // hls/stages/patches.hpp:185
  logic and_4113;
  assign and_4113 = equal_2246_s3_q & (less_2426_s3_q ? (not_2428_s3_q & and_4110) : and_4110);
  // hls/stages/patches.hpp:662
  logic and_4114;
  assign and_4114 = and_4113 & and_4063;
  logic [7:0] sum_4115;
  assign sum_4115 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4114};
  // hls/stages/patches.hpp:189
  logic and_4117;
  assign and_4117 = and_4054 & (and_4060 & not_4055);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4119;
  assign sum_4119 = {7'h0, and_4117} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_4121;
  assign and_4121 = and_4103 & and_4117;
  logic [7:0] sum_4122;
  assign sum_4122 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4121};
  // hls/stages/patches.hpp:662
  logic and_4124;
  assign and_4124 = and_4113 & and_4117;
  logic [7:0] sum_4125;
  assign sum_4125 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4124};
  // hls/stages/patches.hpp:189
  logic and_4127;
  assign and_4127 = and_4054 & (patches_lower_s3_q & not_4061);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4129;
  assign sum_4129 = {7'h0, and_4127} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_4131;
  assign and_4131 = and_4103 & and_4127;
  logic [7:0] sum_4132;
  assign sum_4132 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4131};
  // hls/stages/patches.hpp:662
  logic and_4134;
  assign and_4134 = and_4113 & and_4127;
  logic [7:0] sum_4135;
  assign sum_4135 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4134};
  // hls/stages/patches.hpp:189
  logic and_4137;
  assign and_4137 = and_4054 & (patches_lower_s3_q & and_4060);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4139;
  assign sum_4139 = {7'h0, and_4137} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_4141;
  assign and_4141 = and_4103 & and_4137;
  logic [7:0] sum_4142;
  assign sum_4142 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4141};
  // hls/stages/patches.hpp:662
  logic and_4144;
  assign and_4144 = and_4113 & and_4137;
  logic [7:0] sum_4145;
  assign sum_4145 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4144};
  // hls/stages/agreement.hpp:1223
  logic equal_4146;
  assign equal_4146 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4147;
  assign less_4147 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4151;
  assign and_4151 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & (equal_4146 & less_4147)));
  // hls/stages/agreement.hpp:1142
  logic and_4156;
  assign and_4156 = x_s3_q[6] & (not_2456_s3_q & (less_4147 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4157;
  assign and_4157 = equal_567_s3_q & and_4156;
  // hls/stages/patches.hpp:624
  logic [7:0] or_4159;
  assign or_4159 = (and_4151 ? patches_quarters_0_places_q : 8'h0) | (and_4157 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4163;
  assign and_4163 = x_s3_q[6] & (not_2456_s3_q & (less_4147 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4164;
  assign and_4164 = equal_567_s3_q & and_4163;
  // hls/stages/agreement.hpp:1142
  logic and_4170;
  assign and_4170 = x_s3_q[6] & (not_2456_s3_q & (less_4147 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4171;
  assign and_4171 = equal_567_s3_q & and_4170;
  // hls/stages/patches.hpp:624
  logic [7:0] or_4173;
  assign or_4173 = (or_4159 | (and_4164 ? patches_quarters_2_places_q : 8'h0)) | (and_4171 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:200
  logic select_4177;
  assign select_4177 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4181;
  assign and_4181 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & (less_4147 & select_4177)));
  // hls/stages/patches.hpp:625
  logic [7:0] select_4183;
  assign select_4183 = and_4151 ? (and_4181 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4185;
  assign select_4185 = and_4157 ? (and_4181 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4188;
  assign select_4188 = and_4164 ? (and_4181 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4191;
  assign select_4191 = and_4171 ? (and_4181 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_4194;
  assign select_4194 = and_4151 ? (and_4181 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4196;
  assign select_4196 = and_4157 ? (and_4181 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4199;
  assign select_4199 = and_4164 ? (and_4181 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4202;
  assign select_4202 = and_4171 ? (and_4181 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:203
  logic [4:0] sum_4204;
  assign sum_4204 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4208;
  assign and_4208 = x_s3_q[6] & (not_2456_s3_q & (less_4147 & (sum_4204[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4209;
  assign and_4209 = equal_567_s3_q & and_4208;
  // hls/stages/patches.hpp:621
  logic [7:0] select_4212;
  assign select_4212 = and_4209 ? (patches_word_places_q + (and_4157 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4215;
  assign select_4215 = and_4209 ? (patches_word_up_q + (and_4157 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4218;
  assign select_4218 = and_4209 ? (patches_word_down_q + (and_4157 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:607
  logic [5:0] select_4222;
  assign select_4222 = ($signed(difference_4096[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4096[5:0];
  logic [5:0] select_4223;
  assign select_4223 = ($signed(14'h10) < $signed(difference_4096)) ? 6'h10 : select_4222;
  // hls/stages/patches.hpp:561
  logic [5:0] select_4225;
  assign select_4225 = equal_2429_s3_q ? (or_4049 ? 6'h0 : select_4223) : 6'h0;
  logic [5:0] select_4227;
  assign select_4227 = less_2426_s3_q ? (equal_2427_s3_q ? 6'h0 : select_4225) : select_4225;
  // hls/stages/patches.hpp:664
  logic [5:0] select_4229;
  assign select_4229 = and_4054 ? (equal_2246_s3_q ? select_4227 : 6'h0) : 6'h0;
  logic [11:0] sum_4230;
  assign sum_4230 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4229[5]}}, select_4229};
  // hls/stages/agreement.hpp:788
  logic and_4234;
  assign and_4234 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q & (equal_3338 & less_4147)));
  // hls/stages/agreement.hpp:1142
  logic and_4238;
  assign and_4238 = x_s3_q[6] & (not_2456_s3_q & (less_4147 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4239;
  assign and_4239 = equal_567_s3_q & and_4238;
  // hls/stages/patches.hpp:648
  logic [7:0] select_4241;
  assign select_4241 = and_4234 ? (and_4239 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_4245;
  assign or_4245 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_4248;
  assign or_4248 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_4249;
  assign sum_4249 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_4251;
  assign select_4251 = and_4234 ? (and_4239 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_4254;
  assign and_4254 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_4256;
  assign select_4256 = and_4239 ? {and_4254, patches_found_q[2:1]} : (and_4234 ? {and_4254, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:646
  logic or_4260;
  assign or_4260 = patches_partly_q | (patches_doubted_q & (~and_4239));
  // hls/stages/patches.hpp:647
  logic select_4263;
  assign select_4263 = and_4234 ? (and_4239 ? or_4260 : (and_4234 ? or_4260 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:645
  logic select_4264;
  assign select_4264 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_4268;
  assign select_4268 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:606
  logic [10:0] sum_4270;
  assign sum_4270 = {sum_4094[6], sum_4094, select_4025_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:561
  logic and_4273;
  assign and_4273 = equal_2429_s3_q & (not_4050 & ({{5{sum_4270[10]}}, sum_4270} < 16'h3));
  // hls/stages/patches.hpp:185
  logic and_4276;
  assign and_4276 = equal_2246_s3_q & (less_2426_s3_q ? (not_2428_s3_q & and_4273) : and_4273);
  // hls/stages/patches.hpp:189
  logic and_4277;
  assign and_4277 = and_4054 & and_4276;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_4278;
  assign sum_4278 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4277};
  // hls/stages/patches.hpp:654
  logic [12:0] product_4283;
  assign product_4283 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4241};
  // hls/stages/patches.hpp:189
  logic and_4285;
  assign and_4285 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4283[12:5] < patches_on_skin_q);
  logic select_4290;
  assign select_4290 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_4294;
  assign or_4294 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_4301;
  assign select_4301 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_4307;
  assign and_4307 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4308;
  assign sum_4308 = patches_age_q + {9'h0, and_4307};
  logic [9:0] select_4311;
  assign select_4311 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4308)) : sum_4308;
  // hls/stages/agreement.hpp:1188
  logic or_4368;
  assign or_4368 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_4370;
  assign equal_4370 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_4376;
  assign select_4376 = (equal_4370 & equal_4146) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4379;
  assign sum_4379 = {1'b0, select_3091} + {2'h0, select_3091[9:1]};
  logic select_4382;
  assign select_4382 = (select_3088[9:3] == 7'h0) ? ((~or_4368) & (~select_4376)) : (~({sum_4379, select_3091[0]} < {2'h0, select_3088}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4384;
  assign select_4384 = x_s3_q[6] ? (equal_2074_s3_q ? good_q : {select_4382, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4389;
  assign select_4389 = equal_567_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4387_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_4390;
  assign equal_4390 = x_s3_q[6:3] == 4'ha;
  logic equal_4392;
  assign equal_4392 = x_s3_q[6:3] == 4'hc;
  logic equal_4393;
  assign equal_4393 = x_s3_q[6:3] == 4'hb;
  logic equal_4394;
  assign equal_4394 = x_s3_q[6:3] == 4'h9;
  logic equal_4395;
  assign equal_4395 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4397;
  assign select_4397 = equal_4394 ? counts_skin_unproven_q : (equal_4395 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4399;
  assign select_4399 = equal_4393 ? counts_regions_bad_q : (equal_4390 ? counts_nearer_q : select_4397);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4392 ? counts_on_skin_q : select_4399;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1230
  logic select_4402;
  assign select_4402 = (equal_4390 & equal_4146) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_4403;
  assign not_4403 = ~hidden_for_q[7];
  logic [7:0] select_4405;
  assign select_4405 = select_4402 ? (hidden_for_q + {7'h0, not_4403}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4407;
  assign select_4407 = equal_567_s3_q ? (equal_4387_s3_q ? select_4405 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4408;
  assign select_4408 = equal_4146 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4410;
  assign select_4410 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4412;
  assign select_4412 = equal_4395 ? cfg_unproven_skin_limit_i : (equal_4370 ? cfg_unproven_limit_i : select_4410);
  logic [7:0] select_4414;
  assign select_4414 = equal_4390 ? cfg_regions_limit_i : (equal_4394 ? cfg_hidden_limit_i : select_4412);
  logic [7:0] limit;
  assign limit = equal_4392 ? cfg_regions_limit_i : (equal_4393 ? {cfg_on_skin_limit_i, 3'h0} : select_4414);
  // hls/stages/agreement.hpp:1231
  logic not_4417;
  assign not_4417 = ~x_s3_q[2];
  logic [3:0] select_4418;
  assign select_4418 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4417, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4417};
  logic [7:0] select_4419;
  assign select_4419 = x_s3_q[0] ? {select_4418[3], 1'b0, select_4418[2], 1'b0, select_4418[1], 1'b0, select_4418[0], 1'b0} : {1'b0, select_4418[3], 1'b0, select_4418[2], 1'b0, select_4418[1], 1'b0, select_4418[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4423;
  assign select_4423 = equal_4394 ? counts_skin_supervised_q : (equal_4395 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4425;
  assign select_4425 = equal_4393 ? counts_skin_textured_q : (equal_4390 ? counts_textured_q : select_4423);
  logic [13:0] of;
  assign of = equal_4392 ? counts_textured_q : select_4425;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4427;
  assign select_4427 = ((limit & select_4419) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4408} + {1'b0, select_4427};
  // hls/stages/agreement.hpp:788
  logic select_4432;
  assign select_4432 = equal_567_s3_q ? (equal_4146 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_4437;
  assign and_4437 = too_much_q & (~(equal_4395 & equal_4146));
  // hls/stages/agreement.hpp:1229
  logic select_4442;
  assign select_4442 = (over[14] & equal_4146) ? (and_4437 | ((equal_4395 | equal_4394) | (x_s3_q[6:3] == 4'hf))) : and_4437;
  // hls/stages/agreement.hpp:1125
  logic and_4447;
  assign and_4447 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4448;
  assign select_4448 = (equal_4392 & equal_4146) ? and_4447 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4450;
  assign select_4450 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4452;
  assign select_4452 = equal_567_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4450 : box_textured_columns_values_0_q);
  logic [2:0] select_4453;
  assign select_4453 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4455;
  assign select_4455 = equal_567_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4453 : box_textured_columns_values_1_q);
  logic [2:0] select_4456;
  assign select_4456 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4458;
  assign select_4458 = equal_567_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4456 : box_textured_columns_values_2_q);
  logic [2:0] select_4459;
  assign select_4459 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4461;
  assign select_4461 = equal_567_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4459 : box_textured_columns_values_3_q);
  logic [2:0] select_4462;
  assign select_4462 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4464;
  assign select_4464 = equal_567_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4462 : box_textured_columns_values_4_q);
  logic [4:0] select_4466;
  assign select_4466 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4468;
  assign select_4468 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4470;
  assign select_4470 = equal_567_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4468 : box_explained_columns_values_0_q);
  logic [2:0] select_4471;
  assign select_4471 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4473;
  assign select_4473 = equal_567_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4471 : box_explained_columns_values_1_q);
  logic [2:0] select_4474;
  assign select_4474 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4476;
  assign select_4476 = equal_567_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4474 : box_explained_columns_values_2_q);
  logic [2:0] select_4477;
  assign select_4477 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4479;
  assign select_4479 = equal_567_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4477 : box_explained_columns_values_3_q);
  logic [2:0] select_4480;
  assign select_4480 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4482;
  assign select_4482 = equal_567_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4480 : box_explained_columns_values_4_q);
  logic [4:0] select_4484;
  assign select_4484 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4487;
  assign select_4487 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4489;
  assign select_4489 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4491;
  assign select_4491 = equal_567_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4489 : box_shown_columns_values_1_q);
  logic [2:0] select_4492;
  assign select_4492 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4494;
  assign select_4494 = equal_567_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4492 : box_shown_columns_values_2_q);
  logic [2:0] select_4495;
  assign select_4495 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4497;
  assign select_4497 = equal_567_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4495 : box_shown_columns_values_3_q);
  logic [2:0] select_4498;
  assign select_4498 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4500;
  assign select_4500 = equal_567_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4498 : box_shown_columns_values_4_q);
  logic [4:0] select_4502;
  assign select_4502 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4505;
  assign select_4505 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4507;
  assign select_4507 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4509;
  assign select_4509 = equal_567_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4507 : box_nearer_columns_values_1_q);
  logic [2:0] select_4510;
  assign select_4510 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4512;
  assign select_4512 = equal_567_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4510 : box_nearer_columns_values_2_q);
  logic [2:0] select_4513;
  assign select_4513 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4515;
  assign select_4515 = equal_567_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4513 : box_nearer_columns_values_3_q);
  logic [2:0] select_4516;
  assign select_4516 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4518;
  assign select_4518 = equal_567_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4516 : box_nearer_columns_values_4_q);
  logic [4:0] select_4520;
  assign select_4520 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4565;
  assign select_4565 = and_4564_s3_q ? {and_2592, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4566;
  assign and_4566 = proven_q & less_4554;
  // hls/stages/agreement.hpp:438
  logic select_4569;
  assign select_4569 = and_2522_s3_q ? (less_2523_s3_q ? (select_4565[0] & and_4566) : seen_q) : seen_q;
  logic select_4572;
  assign select_4572 = and_2522_s3_q ? (less_2523_s3_q ? (select_4565[1] & and_4566) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4579;
  assign or_4579 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4578_s3_q;
  // hls/stages/agreement.hpp:1241
  logic not_4587;
  assign not_4587 = ~(or_4368 | not_2813);
  // hls/stages/agreement.hpp:788
  logic and_4591;
  assign and_4591 = equal_567_s3_q & (equal_4387_s3_q & (not_4587 & (select_4376 | select_4442)));
  logic and_4594;
  assign and_4594 = equal_4387_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4598;
  assign or_4598 = select_2911 | (select_2923 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4605;
  assign and_4605 = equal_567_s3_q & (equal_4387_s3_q & (not_4587 & (select_2917 | select_2929)));
  // hls/stages/agreement.hpp:1150
  logic and_4610;
  assign and_4610 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4405 < cfg_hidden_frames_i));
  logic select_4616;
  assign select_4616 = (not_2813 | (select_4448 & not_4280)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4621;
  assign and_4621 = equal_567_s3_q & (equal_4387_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4625;
  assign and_4625 = equal_567_s3_q & (x_s3_q[6] & (not_2456_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4633;
  assign select_4633 = equal_2096_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4631_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4634;
  assign select_4634 = equal_2094_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4633;
  logic [31:0] select_4635;
  assign select_4635 = equal_2092_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4634;
  logic [31:0] select_4636;
  assign select_4636 = equal_2090_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4635;
  logic [31:0] select_4637;
  assign select_4637 = equal_2088_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4636;
  logic [31:0] select_4638;
  assign select_4638 = equal_2086_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4637;
  logic [31:0] select_4639;
  assign select_4639 = equal_2084_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4638;
  logic [31:0] select_4640;
  assign select_4640 = equal_2082_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4639;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4641;
  assign select_4641 = less_3087 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4642;
  assign select_4642 = equal_2074_s3_q ? select_4640 : {2'h0, select_4641, select_3091, select_3088};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_542_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_739_s3_q, and_738, less_733_s3_q, and_732_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_726, and_702_s3_q, and_701_s3_q, and_676_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {^fresh_wdata, fresh_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [6:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s1_sim && fresh_raddr_s1_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s2_sim && fresh_raddr_s2_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd80) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd80) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_2080_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2139_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2138, sum_2134};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {^registration_sums_wdata, registration_sums_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2168_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2245_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2217_s3_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {^patches_choices_wdata, patches_choices_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_2276_s3_q, select_2273};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2285);
  logic [7:0] patches_right_0_wdata;
  assign patches_right_0_wdata = sample_pair_pixel_1_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= {^patches_right_0_wdata, patches_right_0_wdata};
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s1_sim;
  logic patches_right_0_re_s1_sim;
  logic [9:0] patches_right_0_raddr_s2_sim;
  logic patches_right_0_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s1_sim <= 1'b0;
      patches_right_0_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s1_sim <= patches_right_0_re;
      patches_right_0_raddr_s1_sim <= patches_right_0_raddr;
      patches_right_0_re_s2_sim <= patches_right_0_re_s1_sim;
      patches_right_0_raddr_s2_sim <= patches_right_0_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s1_sim && patches_right_0_raddr_s1_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s2_sim && patches_right_0_raddr_s2_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_2276_s3_q, select_2301};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2304);
  logic [7:0] patches_right_1_wdata;
  assign patches_right_1_wdata = sample_pair_pixel_1_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= {^patches_right_1_wdata, patches_right_1_wdata};
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s1_sim;
  logic patches_right_1_re_s1_sim;
  logic [9:0] patches_right_1_raddr_s2_sim;
  logic patches_right_1_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s1_sim <= 1'b0;
      patches_right_1_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s1_sim <= patches_right_1_re;
      patches_right_1_raddr_s1_sim <= patches_right_1_raddr;
      patches_right_1_re_s2_sim <= patches_right_1_re_s1_sim;
      patches_right_1_raddr_s2_sim <= patches_right_1_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s1_sim && patches_right_1_raddr_s1_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s2_sim && patches_right_1_raddr_s2_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_2323, select_2322_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2329);
  logic [7:0] patches_left_wdata;
  assign patches_left_wdata = sample_pair_pixel_0_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= {^patches_left_wdata, patches_left_wdata};
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s1_sim;
  logic patches_left_re_s1_sim;
  logic [8:0] patches_left_raddr_s2_sim;
  logic patches_left_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s1_sim <= 1'b0;
      patches_left_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s1_sim <= patches_left_re;
      patches_left_raddr_s1_sim <= patches_left_raddr;
      patches_left_re_s2_sim <= patches_left_re_s1_sim;
      patches_left_raddr_s2_sim <= patches_left_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s1_sim && patches_left_raddr_s1_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s2_sim && patches_left_raddr_s2_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s3_q;
  logic patches_rows_we;
  assign patches_rows_we = s3_en & patches_summed_last_s3_q;
  logic [14:0] patches_rows_wdata;
  assign patches_rows_wdata = select_2444;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {^patches_rows_wdata, patches_rows_wdata};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s2_sim;
  logic patches_rows_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s2_sim <= patches_rows_re;
      patches_rows_raddr_s2_sim <= patches_rows_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s2_sim && patches_rows_raddr_s2_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s3_q, or_2454_s3_q, or_2451_s3_q, or_2448_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2488_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2487, sum_2477, sum_2472};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {^regions_wdata, regions_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_2528_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2602_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2592, is_seen};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {^map_wdata, map_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 14'd9600) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 14'd9600) $error("map: read outside, address %0d", map_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_before_last_mask_q <= 1'b0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      counts_on_skin_q <= 14'h0;
      registration_half_across_q <= 14'h0;
      registration_half_measured_q <= 6'h0;
      registration_half_votes_down_q <= 7'h0;
      registration_half_votes_up_q <= 7'h0;
      registration_half_half_votes_down_q <= 7'h0;
      registration_half_half_votes_up_q <= 7'h0;
      registration_down_q <= 14'h0;
      registration_up_q <= 14'h0;
      registration_enough_q <= 1'b0;
      registration_votes_down_q <= 1'b0;
      registration_votes_up_q <= 1'b0;
      registration_other_enough_q <= 1'b0;
      registration_other_down_q <= 1'b0;
      registration_other_up_q <= 1'b0;
      registration_moved_q <= 1'b0;
      patches_place_0_valid_q <= 1'b0;
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_valid_q <= 1'b0;
      patches_place_1_column_q <= 8'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      patches_sums_values_0_q <= 10'h0;
      patches_sums_values_1_q <= 10'h0;
      patches_sums_values_2_q <= 10'h0;
      patches_sums_values_3_q <= 10'h0;
      patches_sums_values_4_q <= 10'h0;
      patches_sums_values_5_q <= 10'h0;
      patches_sums_values_6_q <= 10'h0;
      patches_sums_values_7_q <= 10'h0;
      patches_sums_values_8_q <= 10'h0;
      patches_sums_values_9_q <= 10'h0;
      patches_sums_values_10_q <= 10'h0;
      patches_sums_values_11_q <= 10'h0;
      patches_sums_values_12_q <= 10'h0;
      patches_sums_values_13_q <= 10'h0;
      patches_sums_values_14_q <= 10'h0;
      patches_sums_values_15_q <= 10'h0;
      patches_sums_values_16_q <= 10'h0;
      patches_best_differing_q <= 10'h0;
      patches_best_column_q <= 5'h0;
      patches_quarters_0_places_q <= 8'h0;
      patches_quarters_0_up_q <= 8'h0;
      patches_quarters_0_down_q <= 8'h0;
      patches_quarters_1_places_q <= 8'h0;
      patches_quarters_1_up_q <= 8'h0;
      patches_quarters_1_down_q <= 8'h0;
      patches_quarters_2_places_q <= 8'h0;
      patches_quarters_2_up_q <= 8'h0;
      patches_quarters_2_down_q <= 8'h0;
      patches_quarters_3_places_q <= 8'h0;
      patches_quarters_3_up_q <= 8'h0;
      patches_quarters_3_down_q <= 8'h0;
      patches_word_places_q <= 8'h0;
      patches_word_up_q <= 8'h0;
      patches_word_down_q <= 8'h0;
      patches_sum_places_q <= 8'h0;
      patches_sum_up_q <= 8'h0;
      patches_sum_down_q <= 8'h0;
      patches_across_q <= 12'h0;
      patches_places_q <= 8'h0;
      patches_enough_q <= 1'b0;
      patches_mostly_q <= 1'b0;
      patches_partly_q <= 1'b0;
      patches_clear_limit_q <= 7'h0;
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 3'h0;
      patches_doubted_q <= 1'b0;
      patches_doubted_before_q <= 1'b0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_round_on_skin_q <= 8'h0;
      patches_on_skin_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_twice_q <= 1'b0;
      patches_clear_q <= 1'b0;
      patches_age_q <= 10'h200;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_known_q <= 1'b0;
      hidden_for_q <= 8'h0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2752;
      sharpness_before_last_mask_q <= select_2825;
      sharpness_sums_detail_0_q <= and_542_s3_q ? select_2839 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_542_s3_q ? select_2851 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_542_s3_q ? sum_2855 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_542_s3_q ? sum_2859 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2877 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2887 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2889 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2891 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2893 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2895 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2900;
      sharpness_comparing_carry_1_q <= select_2904;
      sharpness_comparing_less_detail_0_q <= select_2911;
      sharpness_comparing_less_detail_1_q <= select_2917;
      sharpness_comparing_less_contrast_0_q <= select_2923;
      sharpness_comparing_less_contrast_1_q <= select_2929;
      counts_supervised_q <= select_3045;
      counts_textured_q <= and_3037_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3048});
      counts_explained_q <= and_3037_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3053});
      counts_nearer_q <= and_3037_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3058});
      counts_unproven_q <= and_3037_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3084});
      counts_regions_bad_q <= select_3100;
      counts_skin_supervised_q <= select_3107;
      counts_skin_textured_q <= select_3114;
      counts_skin_unproven_q <= select_3122;
      counts_on_skin_q <= select_3141;
      registration_half_across_q <= select_3219;
      registration_half_measured_q <= select_3224;
      registration_half_votes_down_q <= and_3197_s3_q ? 7'h0 : sum_3230;
      registration_half_votes_up_q <= and_3197_s3_q ? 7'h0 : sum_3238;
      registration_half_half_votes_down_q <= and_3197_s3_q ? 7'h0 : sum_3245;
      registration_half_half_votes_up_q <= and_3197_s3_q ? 7'h0 : sum_3252;
      registration_down_q <= and_3286 ? sum_3305 : registration_down_q;
      registration_up_q <= and_3286 ? sum_3314 : registration_up_q;
      registration_enough_q <= select_3328;
      registration_votes_down_q <= and_3333 ? less_3334 : registration_votes_down_q;
      registration_votes_up_q <= and_3333 ? less_3336 : registration_votes_up_q;
      registration_other_enough_q <= and_3342 ? select_3328 : registration_other_enough_q;
      registration_other_down_q <= and_3342 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3342 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_567_s3_q & and_3349)) & or_3374;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2264 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2267 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2268 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3459;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2293 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2295 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2296 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3464;
      patches_valid_0_q <= select_3469;
      patches_valid_1_q <= select_3474;
      patches_right_next_0_q <= select_3477;
      patches_right_next_1_q <= select_3480;
      patches_left_next_0_q <= select_3483;
      patches_left_next_1_q <= select_3486;
      patches_sums_values_0_q <= select_3910;
      patches_sums_values_1_q <= equal_2246_s3_q ? patches_sums_values_1_q : select_3911;
      patches_sums_values_2_q <= equal_2246_s3_q ? patches_sums_values_2_q : select_3913;
      patches_sums_values_3_q <= equal_2246_s3_q ? patches_sums_values_3_q : select_3915;
      patches_sums_values_4_q <= equal_2246_s3_q ? patches_sums_values_4_q : select_3917;
      patches_sums_values_5_q <= equal_2246_s3_q ? patches_sums_values_5_q : select_3919;
      patches_sums_values_6_q <= equal_2246_s3_q ? patches_sums_values_6_q : select_3921;
      patches_sums_values_7_q <= equal_2246_s3_q ? patches_sums_values_7_q : select_3923;
      patches_sums_values_8_q <= equal_2246_s3_q ? patches_sums_values_8_q : select_3925;
      patches_sums_values_9_q <= equal_2246_s3_q ? patches_sums_values_9_q : select_3927;
      patches_sums_values_10_q <= equal_2246_s3_q ? patches_sums_values_10_q : select_3929;
      patches_sums_values_11_q <= equal_2246_s3_q ? patches_sums_values_11_q : select_3931;
      patches_sums_values_12_q <= equal_2246_s3_q ? patches_sums_values_12_q : select_3933;
      patches_sums_values_13_q <= equal_2246_s3_q ? patches_sums_values_13_q : select_3935;
      patches_sums_values_14_q <= equal_2246_s3_q ? patches_sums_values_14_q : select_3937;
      patches_sums_values_15_q <= equal_2246_s3_q ? patches_sums_values_15_q : select_3939;
      patches_sums_values_16_q <= equal_2246_s3_q ? patches_sums_values_16_q : select_3941;
      patches_best_differing_q <= select_2444[9:0];
      patches_best_column_q <= select_2444[14:10];
      patches_quarters_0_places_q <= sum_4065;
      patches_quarters_0_up_q <= sum_4105;
      patches_quarters_0_down_q <= sum_4115;
      patches_quarters_1_places_q <= sum_4119;
      patches_quarters_1_up_q <= sum_4122;
      patches_quarters_1_down_q <= sum_4125;
      patches_quarters_2_places_q <= sum_4129;
      patches_quarters_2_up_q <= sum_4132;
      patches_quarters_2_down_q <= sum_4135;
      patches_quarters_3_places_q <= sum_4139;
      patches_quarters_3_up_q <= sum_4142;
      patches_quarters_3_down_q <= sum_4145;
      patches_word_places_q <= or_4173;
      patches_word_up_q <= ((select_4183 | select_4185) | select_4188) | select_4191;
      patches_word_down_q <= ((select_4194 | select_4196) | select_4199) | select_4202;
      patches_sum_places_q <= select_4212;
      patches_sum_up_q <= select_4215;
      patches_sum_down_q <= select_4218;
      patches_across_q <= sum_4230;
      patches_places_q <= select_4241;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4245;
      patches_partly_q <= or_4248;
      patches_clear_limit_q <= sum_4249[8:2];
      patches_complete_q <= select_4251;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4234 ? select_4256 : patches_found_q;
      patches_doubted_q <= select_4263;
      patches_doubted_before_q <= select_4264;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4268;
      patches_on_skin_q <= sum_4278;
      patches_large_q <= not_4280 & and_4285;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4290;
      patches_spoiled_q <= or_4294;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4301;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4311;
      segment_textured_q <= select_2469 + {6'h0, and_3048};
      segment_explained_q <= select_2474 + {6'h0, and_3053};
      segment_nearer_q <= select_2484 + {6'h0, and_3058};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_567_s3_q ? select_4384 : good_q;
      good_known_q <= select_4389;
      hidden_for_q <= select_4407;
      product_q <= equal_567_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4432;
      disagree_q <= equal_567_s3_q ? select_4376 : disagree_q;
      too_much_q <= equal_567_s3_q ? select_4442 : too_much_q;
      hides_q <= equal_567_s3_q ? select_4402 : hides_q;
      overlooks_q <= equal_567_s3_q ? select_4448 : overlooks_q;
      seen_q <= select_4569;
      nearer_q <= select_4572;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_columns_values_0_q = 3'h0;
    box_explained_columns_values_1_q = 3'h0;
    box_explained_columns_values_2_q = 3'h0;
    box_explained_columns_values_3_q = 3'h0;
    box_explained_columns_values_4_q = 3'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_columns_values_0_q = 3'h0;
    box_shown_columns_values_1_q = 3'h0;
    box_shown_columns_values_2_q = 3'h0;
    box_shown_columns_values_3_q = 3'h0;
    box_shown_columns_values_4_q = 3'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_columns_values_0_q = 3'h0;
    box_nearer_columns_values_1_q = 3'h0;
    box_nearer_columns_values_2_q = 3'h0;
    box_nearer_columns_values_3_q = 3'h0;
    box_nearer_columns_values_4_q = 3'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      left_pixel_q <= left_pixel_q;
      averager_quarter_1_0_q <= select_2626;
      averager_quarter_1_1_q <= select_2628;
      averager_quarter_2_0_q <= select_2630;
      averager_quarter_2_1_q <= select_2632;
      averager_detail_0_q <= select_2644;
      averager_detail_1_q <= select_2652;
      census_changes_values_0_left_q <= and_542_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_542_s3_q ? sum_2736 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2738;
      census_changes_values_1_right_q <= select_2739;
      census_changes_values_2_left_q <= select_2740;
      census_changes_values_2_right_q <= select_2741;
      sharpness_last_mask_q <= and_542_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_542_s3_q ? select_2822[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_542_s3_q ? select_2822[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4452;
      box_textured_columns_values_1_q <= select_4455;
      box_textured_columns_values_2_q <= select_4458;
      box_textured_columns_values_3_q <= select_4461;
      box_textured_columns_values_4_q <= select_4464;
      box_textured_sum_sums_values_0_q <= equal_567_s3_q ? box_textured_sum_sums_values_0_q : select_4466;
      box_explained_columns_values_0_q <= select_4470;
      box_explained_columns_values_1_q <= select_4473;
      box_explained_columns_values_2_q <= select_4476;
      box_explained_columns_values_3_q <= select_4479;
      box_explained_columns_values_4_q <= select_4482;
      box_explained_sum_sums_values_0_q <= equal_567_s3_q ? box_explained_sum_sums_values_0_q : select_4484;
      box_shown_columns_values_0_q <= equal_567_s3_q ? box_shown_columns_values_0_q : select_4487;
      box_shown_columns_values_1_q <= select_4491;
      box_shown_columns_values_2_q <= select_4494;
      box_shown_columns_values_3_q <= select_4497;
      box_shown_columns_values_4_q <= select_4500;
      box_shown_sum_sums_values_0_q <= equal_567_s3_q ? box_shown_sum_sums_values_0_q : select_4502;
      box_nearer_columns_values_0_q <= equal_567_s3_q ? box_nearer_columns_values_0_q : select_4505;
      box_nearer_columns_values_1_q <= select_4509;
      box_nearer_columns_values_2_q <= select_4512;
      box_nearer_columns_values_3_q <= select_4515;
      box_nearer_columns_values_4_q <= select_4518;
      box_nearer_sum_sums_values_0_q <= equal_567_s3_q ? box_nearer_sum_sums_values_0_q : select_4520;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4549_s4_q;
  logic or_4573_s4_q;
  logic and_4574_s4_q;
  logic and_4582_s4_q;
  logic and_4585_s4_q;
  logic and_4591_s4_q;
  logic and_4595_s4_q;
  logic and_4601_s4_q;
  logic and_4605_s4_q;
  logic and_4613_s4_q;
  logic and_4618_s4_q;
  logic and_4621_s4_q;
  logic and_4625_s4_q;
  logic [5:0] select_4627_s4_q;
  logic [31:0] select_4644_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4549_s4_q <= said_q;
      or_4573_s4_q <= not_2813 | select_4569;
      and_4574_s4_q <= cfg_prove_i & select_4572;
      and_4582_s4_q <= equal_567_s3_q & (equal_4387_s3_q & (cfg_prove_i & or_4579));
      and_4585_s4_q <= equal_567_s3_q & (equal_4387_s3_q & (cfg_prove_i & or_4368));
      and_4591_s4_q <= and_4591;
      and_4595_s4_q <= equal_567_s3_q & and_4594;
      and_4601_s4_q <= equal_567_s3_q & (equal_4387_s3_q & (not_4587 & or_4598));
      and_4605_s4_q <= and_4605;
      and_4613_s4_q <= equal_567_s3_q & (equal_4387_s3_q & (cfg_prove_i & and_4610));
      and_4618_s4_q <= equal_567_s3_q & (equal_4387_s3_q & select_4616);
      and_4621_s4_q <= and_4621;
      and_4625_s4_q <= and_4625;
      select_4627_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4644_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? select_4642 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | moments_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | left_turns_error | right_turns_error | registration_sums_error | patches_choices_error | patches_right_0_error | patches_right_1_error | patches_left_error | patches_columns_above_error | patches_right_codes_error | patches_left_codes_error | patches_rows_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign pixel_1_o = pixel_1_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4573_s4_q;
  assign marks_nearer_o = and_4574_s4_q;
  assign verdict_valid_o = and_4549_s4_q;
  assign verdict_unproven_yet_o = and_4582_s4_q;
  assign verdict_untextured_o = and_4585_s4_q;
  assign verdict_disagree_o = and_4591_s4_q;
  assign verdict_moved_o = and_4595_s4_q;
  assign verdict_unsharp_left_o = and_4601_s4_q;
  assign verdict_unsharp_right_o = and_4605_s4_q;
  assign verdict_hidden_o = and_4613_s4_q;
  assign verdict_overlooked_o = and_4618_s4_q;
  assign verdict_out_of_step_o = and_4621_s4_q;
  assign frame_valid_o = and_4625_s4_q;
  assign frame_index_o = select_4627_s4_q;
  assign frame_word_o = select_4644_s4_q;
  assign valid_o = valid_s4_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_4283[4:0], sum_4249[1:0], sum_4204[1:0], product_4095[4:0], sum_3187[0], difference_3128[1:0], detail_4[1:0], detail_3[1:0], sum_2746[4:0], sum_2184[0], sum_2180[0], sum_724[4:0], cfg_width_i[2:0]};

endmodule
