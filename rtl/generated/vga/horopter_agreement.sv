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
  logic not_2814;
  assign not_2814 = ~cfg_prove_i;
  logic [5:0] sum_3024;
  assign sum_3024 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4068;
  assign difference_4068 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4281;
  assign not_4281 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4339;
  assign difference_4339 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4555;
  assign less_4555 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4556;
  assign sum_4556 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

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
  // hls/stages/patches.hpp:392
  logic not_2143;
  assign not_2143 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2146;
  assign not_2146 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_2147;
  assign and_2147 = patches_capturing_q & not_2146;
  // hls/stages/patches.hpp:364
  logic equal_2148;
  assign equal_2148 = {or_514, select_521} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2150;
  assign equal_2150 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2155;
  assign and_2155 = (not_2143 & (patches_work_q == 3'h0)) & (~(and_2147 | ((~equal_2148) | (~equal_2150))));
  // hls/stages/patches.hpp:534
  logic equal_2246;
  assign equal_2246 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:512
  logic not_2247;
  assign not_2247 = ~equal_2246;
  // hls/stages/patches.hpp:505
  logic equal_2248;
  assign equal_2248 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:458
  logic not_2249;
  assign not_2249 = ~equal_2248;
  // hls/stages/patches.hpp:499
  logic equal_2250;
  assign equal_2250 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2251;
  assign equal_2251 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_2252;
  assign or_2252 = equal_2250 | equal_2251;
  // hls/stages/patches.hpp:460
  logic not_2253;
  assign not_2253 = ~patches_second_q;
  // hls/stages/patches.hpp:373
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
  // hls/stages/patches.hpp:184
  logic and_2290;
  assign and_2290 = not_2247 & (not_2249 & (or_2252 & (patches_second_q & equal_2251)));
  // hls/stages/patches.hpp:167
  logic not_2307;
  assign not_2307 = ~equal_2251;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2323;
  assign select_2323 = and_2142 ? {select_2275[4], select_2275[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:458
  logic and_2333;
  assign and_2333 = not_2247 & (or_2252 & not_2249);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2608;
  assign select_2608 = sample_pair_whole_q ? (sample_last_q ? (select_521 + 3'h1) : select_521) : raster_at_y_q;
  logic [6:0] select_2610;
  assign select_2610 = sample_pair_whole_q ? (select_504 + {6'h0, equal_538}) : raster_at_column_q;
  logic [5:0] select_2613;
  assign select_2613 = sample_pair_whole_q ? (sample_last_q ? (select_670 + {5'h0, equal_539}) : select_670) : raster_at_row_q;
  logic select_2617;
  assign select_2617 = sample_pair_whole_q ? (sample_last_q ? (or_514 & (~raster_final_row_q)) : or_514) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2619;
  assign select_2619 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2623;
  assign select_2623 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2932;
  assign sum_2932 = {1'b0, last} + 8'h1;
  logic equal_2933;
  assign equal_2933 = {sum_2932[7], cfg_width_i[9:3]} == {1'b0, sum_2932[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2934;
  assign and_2934 = and_542 & equal_2933;
  // hls/stages/agreement.hpp:523
  logic select_2937;
  assign select_2937 = (and_2934 | (~ends_cell_q)) ? and_2934 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2937 ? (and_2934 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2941;
  assign select_2941 = select_2937 ? (and_2934 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2944;
  assign select_2944 = select_2937 ? (following_last_shift_q & (~and_2934)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2947;
  assign and_2947 = run_last_shift_q & equal_586;
  // hls/stages/agreement.hpp:616
  logic select_2949;
  assign select_2949 = equal_586 ? (~run_last_shift_q) : equal_587;
  // hls/stages/agreement.hpp:620
  logic equal_2950;
  assign equal_2950 = run_phase_q == 3'h1;
  logic not_2953;
  assign not_2953 = ~select_2949;
  // hls/stages/agreement.hpp:623
  logic equal_2955;
  assign equal_2955 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2956;
  assign and_2956 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2957;
  assign select_2957 = equal_2955 ? 2'h1 : {2{and_2956}};
  logic [2:0] select_2959;
  assign select_2959 = (and_2947 | (select_2949 | equal_2950)) ? (equal_2950 ? 3'h2 : {not_2953, {2{select_2949}}}) : (equal_571 ? 3'h6 : {select_2957[0], select_2957});
  // hls/stages/agreement.hpp:607
  logic and_2962;
  assign and_2962 = select_2949 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2965;
  assign select_2965 = (plan_shift_q[5] & select_2949) ? value : 7'h0;
  logic [1:0] or_2966;
  assign or_2966 = {2{so}} | select_2965[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2970;
  assign or_2970 = (select_2949 ? plan_columns_q : 8'h0) | ((equal_2950 | equal_2955) ? whole_q : 8'h0);
  logic [1:0] or_2971;
  assign or_2971 = {2{and_2947}} | or_2970[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2973;
  assign or_2973 = {or_2970[7:4], or_2971, or_2970[1:0]} | (equal_571 ? drawn_q : 8'h0);
  logic [4:0] or_2974;
  assign or_2974 = {5{so}} | {or_2973[6], or_2973[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2978;
  assign not_2978 = ~run_shift_q[5];
  logic [7:0] select_2981;
  assign select_2981 = equal_586 ? ({{7{not_2978}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2985;
  assign select_2985 = and_2934 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2987;
  assign select_2987 = select_2937 ? {select_2985[6], select_2985} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2990;
  assign select_2990 = select_2937 ? (and_2934 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2998;
  assign select_2998 = and_542 ? (equal_2933 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [5:0] sum_2999;
  assign sum_2999 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3001;
  assign select_3001 = and_542 ? (equal_2933 ? {sum_2999, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_3002;
  assign sum_3002 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3004;
  assign select_3004 = and_542 ? (equal_2933 ? {sum_3002, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_3015;
  assign select_3015 = (ends_cell_q | select_2937) ? (~(now == 3'h6)) : (equal_586 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_3019;
  assign and_3019 = (~select_2937) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_3020;
  assign sum_3020 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_3022;
  assign select_3022 = equal_2933 ? ({sum_3020[6], cfg_height_i[8:3]} == {1'b0, sum_3020[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3381;
  assign select_3381 = and_2142 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3382;
  assign select_3382 = sample_pair_whole_q ? select_3381 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_3383;
  assign and_3383 = not_2146 & equal_2148;
  logic [8:0] select_3384;
  assign select_3384 = and_3383 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3385;
  assign select_3385 = and_3383 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3386;
  assign select_3386 = sample_pair_first_q ? select_3384 : select_3385;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3388;
  assign select_3388 = sample_pair_whole_q ? (and_2142 ? select_3386[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3390;
  assign select_3390 = sample_pair_whole_q ? (and_2142 ? select_3386[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3393;
  assign select_3393 = sample_pair_whole_q ? (equal_2150 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3395;
  assign select_3395 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2150}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3396;
  assign equal_3396 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3397;
  assign not_3397 = ~equal_3396;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3399;
  assign select_3399 = sample_pair_whole_q ? (phase + {not_3397, 1'b1, not_3397, equal_3396}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3401;
  assign equal_3401 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3405;
  assign select_3405 = equal_3401 ? ((select_3382 == 4'h6) ? 4'h0 : (select_3382 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3406;
  assign equal_3406 = select_3405 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3409;
  assign select_3409 = equal_2933 ? (equal_3406 ? 4'h6 : (select_3405 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3411;
  assign select_3411 = equal_3401 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3413;
  assign select_3413 = equal_2933 ? (select_3411 + {4'h0, equal_3406}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3418;
  assign select_3418 = and_542 ? (equal_2933 ? ((6'h2 < row) & equal_3406) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3420;
  assign select_3420 = and_542 ? (equal_2933 ? select_3411 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_3444;
  assign or_3444 = select_504[0] | select_670[5];
  logic [7:0] sum_3445;
  assign sum_3445 = {1'b0, select_504[2:1], or_3444, select_670[4:1]} + 8'h1;
  logic less_3446;
  assign less_3446 = {sum_3445, select_670[0], select_521, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3449;
  assign select_3449 = and_2142 ? (and_2155 ? (~less_3446) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3488;
  assign or_3488 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3494;
  assign and_3494 = equal_2246 & not_2253;
  // hls/stages/patches.hpp:399
  logic and_3495;
  assign and_3495 = not_2307 & and_3494;
  logic [1:0] select_3497;
  assign select_3497 = equal_2248 ? 2'h0 : (equal_2250 ? 2'h3 : {equal_2251, and_3495});
  // hls/stages/patches.hpp:279
  logic equal_3499;
  assign equal_3499 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3500;
  assign not_3500 = ~equal_3499;
  // hls/stages/patches.hpp:279
  logic equal_3501;
  assign equal_3501 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3502;
  assign not_3502 = ~equal_3501;
  // hls/stages/patches.hpp:283
  logic not_3504;
  assign not_3504 = ~(patches_following_q == 3'h2);
  logic and_3507;
  assign and_3507 = (~(patches_following_q == 3'h1)) & not_3504;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3508;
  assign select_3508 = equal_3501 ? 2'h2 : {and_3507, not_3504};
  logic [3:0] select_3509;
  assign select_3509 = equal_3499 ? 4'h2 : {select_3508, {2{not_3502}}};
  // hls/stages/patches.hpp:405
  logic not_3512;
  assign not_3512 = ~or_3488;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3517;
  assign select_3517 = or_3488 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3519;
  assign select_3519 = or_3488 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:779; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:779; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2247 & (not_2249 & (not_2307 & or_2252)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_2333;
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
      raster_at_y_q <= select_2608;
      raster_at_column_q <= select_2610;
      raster_at_row_q <= select_2613;
      raster_at_live_q <= select_2617;
      raster_rows_left_q <= sample_pair_whole_q ? select_2619 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2623;
      averager_place_q <= sample_pair_whole_q ? select_508 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_513 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2941;
      run_last_shift_q <= select_2944;
      run_span_q <= select_2937 ? (and_2934 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2959;
      following_shift_q <= select_2949 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2962;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2965[6], or_2966, select_2965[3:0]};
      following_columns_q <= {or_2973[7], or_2974[4], or_2973[5:4], or_2974[3:0]};
      plan_shift_q <= equal_586 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2981;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2987;
      columns_left_q <= select_2990;
      last_q <= and_542 ? (equal_2933 ? last : last_q) : last_q;
      least_q <= select_2998;
      whole_q <= select_3001;
      drawn_q <= select_3004;
      age_q <= select_2937 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2937 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3015;
      ends_q <= and_3019;
      final_row_q <= and_542 ? select_3022 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3382;
      patches_band_rows_rows_to_next_q <= select_3388;
      patches_band_rows_number_q <= select_3390;
      patches_next_band_rows_to_next_q <= select_3393;
      patches_next_band_number_q <= select_3395;
      patches_first_band_rows_to_next_q <= select_3399;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3396 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_542 ? select_3409 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_542 ? select_3413 : patches_choosing_number_q;
      patches_chooses_q <= select_3418;
      patches_choosing_band_q <= select_3420;
      patches_capturing_q <= sample_pair_whole_q ? select_2282 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3449 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2276 : patches_row_q;
      patches_work_q <= or_3488 ? following : patches_work_q;
      patches_second_q <= not_2143 & (patches_second_q | (patches_ends_q & equal_2246));
      patches_following_q <= equal_2246 ? {2'h0, and_3494} : {equal_2248, select_3497};
      patches_following_beats_q <= {select_3509, not_3500};
      patches_begins_q <= sample_pair_whole_q & (and_2142 & and_2278);
      patches_ends_q <= not_3512 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3517;
      patches_code_row_q <= select_3519;
      patches_column_q <= or_3488 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3512 & (patches_column_q == 5'h1e);
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
  logic [3:0] select_2323_s1_q;
  logic and_2333_s1_q;
  logic equal_2933_s1_q;
  logic and_2934_s1_q;
  logic or_3488_s1_q;
  logic not_3512_s1_q;
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
      select_2323_s1_q <= select_2323;
      and_2333_s1_q <= and_2333;
      equal_2933_s1_q <= equal_2933;
      and_2934_s1_q <= and_2934;
      or_3488_s1_q <= or_3488;
      not_3512_s1_q <= not_3512;
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
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2251_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2251_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:500
  logic less_2339;
  assign less_2339 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:501
  logic or_2340;
  assign or_2340 = equal_2250_s1_q | less_2339;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2345;
  assign select_2345 = equal_2250_s1_q ? patches_column_s1_q[0] : (or_2340 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2346;
  assign not_2346 = ~or_2340;
  // hls/stages/patches.hpp:501
  logic [4:0] sum_2347;
  assign sum_2347 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:503
  logic [4:0] select_2350;
  assign select_2350 = or_2340 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2347) + 5'h1) : sum_2347;
  // hls/stages/patches.hpp:505
  logic [4:0] select_2351;
  assign select_2351 = equal_2250_s1_q ? 5'h0 : select_2350;
  logic or_2352;
  assign or_2352 = equal_2250_s1_q | equal_2248_s1_q;
  // hls/stages/patches.hpp:481
  logic equal_2354;
  assign equal_2354 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2356;
  assign equal_2356 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_2358;
  assign and_2358 = of_row & (~equal_2356);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2354 ? 2'h3 : {equal_2356, and_2358};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_2361;
  assign sum_2361 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2362;
  assign sum_2362 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2361, pixel_2[0]} - {1'b0, sum_2362, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:471
  logic [11:0] sum_2364;
  assign sum_2364 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2365;
  assign sum_2365 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2364[11], sum_2364};
  logic [13:0] sum_2366;
  assign sum_2366 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2365, down_2[1]};
  logic [12:0] sum_2367;
  assign sum_2367 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2366[13:1];
  logic [14:0] sum_2368;
  assign sum_2368 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2367, sum_2366[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic or_2375;
  assign or_2375 = (sum_2368[8] & (~(sum_2368[7:0] == 8'h0))) | (~(sum_2368[13:9] == 5'h0));
  // hls/stages/patches.hpp:467
  logic [8:0] sum_2380;
  assign sum_2380 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2381;
  assign sum_2381 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2380};
  logic [10:0] sum_2382;
  assign sum_2382 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2381, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2383;
  assign sum_2383 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2382[10:1];
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_2383, sum_2382[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:470
  logic [12:0] sum_2385;
  assign sum_2385 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2386;
  assign sum_2386 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2387;
  assign difference_2387 = {1'b0, sum_2385, smooth[0]} - {1'b0, sum_2386, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:453
  logic or_2394;
  assign or_2394 = (difference_2387[8] & (~(difference_2387[7:0] == 8'h0))) | (~(difference_2387[13:9] == 5'h0));
  // hls/stages/patches.hpp:482
  logic or_2402;
  assign or_2402 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2356) | equal_2354;
  // hls/stages/patches.hpp:477
  logic and_2407;
  assign and_2407 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2411;
  assign and_2411 = not_2249_s1_q & (or_2252_s1_q & (or_2402 & (equal_2251_s1_q & and_2407)));
  // hls/stages/patches.hpp:172
  logic and_2421;
  assign and_2421 = (~(equal_2251_s1_q | (~and_2407))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2425;
  assign and_2425 = not_2249_s1_q & (or_2252_s1_q & (and_2421 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:546
  logic less_2427;
  assign less_2427 = patches_step_q[4:0] < 5'h11;
  logic equal_2428;
  assign equal_2428 = patches_step_q[6:5] == 2'h0;
  logic not_2429;
  assign not_2429 = ~equal_2428;
  logic equal_2430;
  assign equal_2430 = patches_step_q[6:5] == 2'h3;
  logic not_2431;
  assign not_2431 = ~equal_2430;
  // hls/stages/patches.hpp:560
  logic select_2434;
  assign select_2434 = equal_2430 ? (less_2427 & (less_2427 & not_2431)) : less_2427;
  // hls/stages/patches.hpp:184
  logic and_2437;
  assign and_2437 = equal_2246_s1_q & (less_2427 ? (not_2429 & select_2434) : select_2434);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2459;
  assign sum_2459 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2743;
  assign or_2743 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:460
  logic select_3027;
  assign select_3027 = equal_2933_s1_q ? (~({row_s1_q, 1'b0} < {sum_3024, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3271;
  assign and_3271 = and_542_s1_q & (equal_2933_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3272;
  assign and_3272 = and_2934_s1_q & and_3271;
  // hls/stages/registration.hpp:127
  logic and_3274;
  assign and_3274 = and_2934_s1_q & (~and_3271);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3275;
  assign select_3275 = and_3274 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3277;
  assign select_3277 = and_3272 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3275[15]}}, select_3275});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3278;
  assign select_3278 = and_3274 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3278[15]}}, select_3278};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3280;
  assign select_3280 = and_3272 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3281;
  assign and_3281 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3281 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3527;
  assign select_3527 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3530;
  assign select_3530 = equal_2248_s1_q ? patches_smooth_values_0_q : (or_2252_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3532;
  assign select_3532 = or_2252_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3534;
  assign select_3534 = equal_2246_s1_q ? patches_smooth_values_1_q : (equal_2248_s1_q ? patches_smooth_values_1_q : select_3532);
  logic [11:0] select_3535;
  assign select_3535 = or_2252_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3537;
  assign select_3537 = equal_2246_s1_q ? patches_smooth_values_2_q : (equal_2248_s1_q ? patches_smooth_values_2_q : select_3535);
  logic [11:0] select_3538;
  assign select_3538 = or_2252_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3540;
  assign select_3540 = equal_2246_s1_q ? patches_smooth_values_3_q : (equal_2248_s1_q ? patches_smooth_values_3_q : select_3538);
  logic [10:0] select_3542;
  assign select_3542 = equal_2248_s1_q ? patches_down_values_0_q : (or_2252_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3545;
  assign select_3545 = equal_2248_s1_q ? patches_down_values_1_q : (or_2252_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3548;
  assign select_3548 = equal_2248_s1_q ? patches_down_values_2_q : (or_2252_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3551;
  assign select_3551 = equal_2248_s1_q ? patches_down_values_3_q : (or_2252_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3588;
  assign and_3588 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3593;
  assign select_3593 = or_3488_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3595;
  assign select_3595 = and_3588 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3951;
  assign select_3951 = equal_2246_s1_q ? patches_summed_down_by_q : (equal_2248_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:556
  logic and_3984;
  assign and_3984 = less_2427 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:560
  logic select_3987;
  assign select_3987 = equal_2430 ? (less_2427 ? (not_2431 & and_3984) : and_3984) : and_3984;
  // hls/stages/patches.hpp:184
  logic select_3990;
  assign select_3990 = equal_2246_s1_q ? (less_2427 ? (not_2429 & select_3987) : select_3987) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4329;
  assign select_4329 = so_s1_q ? (and_3281 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4331;
  assign sum_4331 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4332;
  assign select_4332 = sum_2459[5] ? {1'b1, sum_2459[4:0], region_across_rest_q[2:0]} : sum_4331;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4334;
  assign select_4334 = equal_2933_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4337;
  assign select_4337 = equal_2933_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

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

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:796; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2351, not_2346, select_2345};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2352;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:797; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:811; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & and_2437;
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
  assign patches_columns_above_we = s1_en & and_2333_s1_q;
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
      row_q <= and_542_s1_q ? (equal_2933_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_542_s1_q ? select_3027 : lower_half_q;
      registration_slope_row_q <= select_3277;
      registration_slope_change_q <= select_3280;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3512_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3512_s1_q & select_3527;
      patches_smooth_values_0_q <= equal_2246_s1_q ? patches_smooth_values_0_q : select_3530;
      patches_smooth_values_1_q <= select_3534;
      patches_smooth_values_2_q <= select_3537;
      patches_smooth_values_3_q <= select_3540;
      patches_down_values_0_q <= equal_2246_s1_q ? patches_down_values_0_q : select_3542;
      patches_down_values_1_q <= equal_2246_s1_q ? patches_down_values_1_q : select_3545;
      patches_down_values_2_q <= equal_2246_s1_q ? patches_down_values_2_q : select_3548;
      patches_down_values_3_q <= equal_2246_s1_q ? patches_down_values_3_q : select_3551;
      patches_down_by_q <= or_3488_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3588});
      patches_along_q <= select_3593;
      patches_match_row_q <= or_3488_s1_q ? 4'h0 : select_3595;
      patches_summed_last_q <= not_2247_s1_q & (equal_2248_s1_q & and_3588);
      patches_summed_down_by_q <= select_3951;
      patches_step_q <= or_3488_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3990;
      region_across_rest_q <= select_4329;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4332;
      columns_begin_rest_q <= and_542_s1_q ? select_4334 : columns_begin_rest_q;
      columns_begin_back_q <= and_542_s1_q ? select_4337 : columns_begin_back_q;
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
  logic [3:0] select_2323_s2_q;
  logic less_2339_s2_q;
  logic new_row_s2_q;
  logic or_2352_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2369_s2_q;
  logic or_2375_s2_q;
  logic and_2379_s2_q;
  logic and_2395_s2_q;
  logic and_2398_s2_q;
  logic and_2412_s2_q;
  logic and_2421_s2_q;
  logic and_2426_s2_q;
  logic less_2427_s2_q;
  logic equal_2428_s2_q;
  logic not_2429_s2_q;
  logic equal_2430_s2_q;
  logic not_2431_s2_q;
  logic sum_2459_s2_q;
  logic and_2480_s2_q;
  logic and_2597_s2_q;
  logic equal_2744_s2_q;
  logic equal_2933_s2_q;
  logic and_3040_s2_q;
  logic equal_3125_s2_q;
  logic less_3564_s2_q;
  logic equal_3907_s2_q;
  logic equal_3991_s2_q;
  logic less_4317_s2_q;
  logic equal_4536_s2_q;
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
      select_2323_s2_q <= select_2323_s1_q;
      less_2339_s2_q <= less_2339;
      new_row_s2_q <= new_row;
      or_2352_s2_q <= or_2352;
      of_row_2_s2_q <= of_row_2;
      not_2369_s2_q <= ~sum_2368[14];
      or_2375_s2_q <= or_2375;
      and_2379_s2_q <= sum_2368[14] & (~(sum_2368[13:8] == 6'h3f));
      and_2395_s2_q <= (~difference_2387[14]) & or_2394;
      and_2398_s2_q <= difference_2387[14] & (~(difference_2387[13:8] == 6'h3f));
      and_2412_s2_q <= not_2247_s1_q & and_2411;
      and_2421_s2_q <= and_2421;
      and_2426_s2_q <= not_2247_s1_q & and_2425;
      less_2427_s2_q <= less_2427;
      equal_2428_s2_q <= equal_2428;
      not_2429_s2_q <= not_2429;
      equal_2430_s2_q <= equal_2430;
      not_2431_s2_q <= not_2431;
      sum_2459_s2_q <= sum_2459[5];
      and_2480_s2_q <= or_572_s1_q & (left_rdata_q[69] & not_576_s1_q);
      and_2597_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2744_s2_q <= {last_s1_2_q[6], or_2743} == 7'h0;
      equal_2933_s2_q <= equal_2933_s1_q;
      and_3040_s2_q <= or_572_s1_q & (not_576_s1_q & and_600);
      equal_3125_s2_q <= shift == 6'h0;
      less_3564_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3907_s2_q <= patches_match_row_q == 4'h0;
      equal_3991_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4317_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4536_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/patches.hpp:210
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
  // hls/stages/patches.hpp:373
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
  // hls/stages/patches.hpp:156
  logic and_2216;
  assign and_2216 = and_2214 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_2217;
  assign select_2217 = and_2216 ? and_2214 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2220;
  assign select_2220 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2222;
  assign select_2222 = and_2216 ? (equal_567_s2_q ? 8'h0 : select_2220) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2225;
  assign select_2225 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
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
  // hls/stages/patches.hpp:344
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
  // hls/stages/patches.hpp:344
  logic and_2245;
  assign and_2245 = patches_chooses_s2_q & and_2244;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2259;
  assign select_2259 = and_2142_s2_q ? select_2157 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_2260;
  assign equal_2260 = {patches_choosing_band_s2_q, and_2168} == {select_2259, select_2159[1]};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_2360;
  assign sum_2360 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_2376;
  assign and_2376 = not_2369_s2_q & or_2375_s2_q;
  // hls/stages/patches.hpp:490
  logic [1:0] sum_2416;
  assign sum_2416 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2446;
  assign select_2446 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2449;
  assign or_2449 = select_2446[7] | (~({select_2446[5], select_2446[3], select_2446[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2452;
  assign or_2452 = select_2446[7] | (~({select_2446[6], select_2446[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2455;
  assign or_2455 = select_2446[7] | (~(select_2446[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2456;
  assign select_2456 = equal_567_s2_q ? x_s2_q[5:0] : {region_row_q, or_2455, or_2452, or_2449};
  // hls/stages/agreement.hpp:1128
  logic not_2457;
  assign not_2457 = ~equal_2074;
  // hls/stages/agreement.hpp:1058
  logic or_2461;
  assign or_2461 = (~sum_2459_s2_q) | equal_2239;
  // hls/stages/agreement.hpp:788
  logic and_2464;
  assign and_2464 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2461));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_572_s2_q & (not_576_s2_q & and_601_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_629;
  // hls/stages/agreement.hpp:149
  logic and_2482;
  assign and_2482 = or_572_s2_q & (not_576_s2_q & and_2480_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2491;
  assign and_2491 = inside_v_s2_q & and_2482;
  // hls/stages/agreement.hpp:1014
  logic select_2492;
  assign select_2492 = slot_s2_q[2] ? shown_shown_q : and_629;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2492);
  // hls/stages/agreement.hpp:1014
  logic select_2495;
  assign select_2495 = slot_s2_q[2] ? shown_nearer_q : and_2052;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2492 ? select_2495 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1275
  logic or_2498;
  assign or_2498 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [16:0] select_2500;
  assign select_2500 = marks_first_s2_q ? 17'h1 : (or_2498 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2502;
  assign select_2502 = or_2498 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2504;
  assign select_2504 = cfg_compete_i ? (or_2498 & select_2500[16]) : (select_2502[8] & select_2500[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2504 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2507;
  assign select_2507 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2509;
  assign select_2509 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2507});
  // hls/stages/agreement.hpp:1301
  logic equal_2510;
  assign equal_2510 = seen_x_q == 3'h7;
  logic [7:0] select_2512;
  assign select_2512 = select_2504 ? 8'h0 : (seen_column_q + {7'h0, equal_2510});
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = select_2509 + {5'h0, select_2512};
  // hls/stages/agreement.hpp:1275
  logic select_2515;
  assign select_2515 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2516;
  assign sum_2516 = {1'b0, select_2515, 2'h0, select_2515, 1'b0, {2{select_2515}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1274
  logic not_2517;
  assign not_2517 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2519;
  assign and_2519 = not_2517 & (began_q | select_2504);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2521;
  assign select_2521 = select_2504 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2523;
  assign and_2523 = and_2519 & (select_2521 == 3'h0);
  logic less_2524;
  assign less_2524 = select_2512 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2527;
  assign sum_2527 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2527[7]}}, sum_2527, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2529;
  assign sum_2529 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2530;
  assign and_2530 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2531;
  assign and_2531 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2532;
  assign and_2532 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2533;
  assign and_2533 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2535;
  assign sum_2535 = {1'b0, and_2532} + ({1'b0, textured} + {1'b0, and_2533});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2530} + ({2'h0, and_2531} + {1'b0, sum_2535});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2544;
  assign select_2544 = inside_v_s2_q ? (sum_2459_s2_q ? select_2446 : {select_2446[6:0], 1'b0}) : select_2446;
  // hls/stages/agreement.hpp:1050
  logic or_2547;
  assign or_2547 = select_2544[7] | (~({select_2544[5], select_2544[3], select_2544[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2564;
  assign and_2564 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2565;
  assign and_2565 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2566;
  assign and_2566 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2567;
  assign and_2567 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2569;
  assign sum_2569 = {1'b0, and_2566} + ({1'b0, shown} + {1'b0, and_2567});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2564} + ({2'h0, and_2565} + {1'b0, sum_2569});
  // hls/stages/agreement.hpp:1030
  logic and_2580;
  assign and_2580 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2581;
  assign and_2581 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2582;
  assign and_2582 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2583;
  assign and_2583 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2585;
  assign sum_2585 = {1'b0, and_2582} + ({1'b0, near} + {1'b0, and_2583});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2580} + ({2'h0, and_2581} + {1'b0, sum_2585});
  // hls/stages/agreement.hpp:788
  logic and_2601;
  assign and_2601 = ends_cell_s2_q & (and_2597_s2_q & (~({sum_2114, last_s2_q[1:0]} < x_s2_q)));
  logic and_2603;
  assign and_2603 = not_568_s2_q & (so_s2_q & and_2601);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2635;
  assign select_2635 = sample_pair_whole_s2_q ? (and_540_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2637;
  assign select_2637 = sample_pair_whole_s2_q ? (and_540_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2657;
  assign select_2657 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2659;
  assign select_2659 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_555 : averager_mask_q) : averager_mask_q;
  logic select_2661;
  assign select_2661 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_559 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2662;
  assign select_2662 = and_542_s2_q ? select_548 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2663;
  assign select_2663 = and_542_s2_q ? select_552 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2665;
  assign select_2665 = and_542_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2666;
  assign select_2666 = and_542_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2667;
  assign select_2667 = and_542_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2668;
  assign select_2668 = and_542_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2669;
  assign select_2669 = and_542_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2670;
  assign select_2670 = and_542_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2671;
  assign select_2671 = and_542_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2672;
  assign select_2672 = and_542_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2673;
  assign select_2673 = and_542_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2674;
  assign select_2674 = and_542_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2675;
  assign select_2675 = and_542_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2676;
  assign select_2676 = and_542_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2677;
  assign select_2677 = and_542_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2678;
  assign select_2678 = and_542_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2679;
  assign select_2679 = and_542_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2680;
  assign select_2680 = and_542_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2681;
  assign select_2681 = and_542_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2682;
  assign select_2682 = and_542_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2683;
  assign select_2683 = and_542_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2684;
  assign select_2684 = and_542_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2685;
  assign select_2685 = and_542_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2686;
  assign select_2686 = and_542_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2687;
  assign select_2687 = and_542_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2688;
  assign select_2688 = and_542_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2689;
  assign select_2689 = and_542_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2690;
  assign select_2690 = and_542_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2691;
  assign select_2691 = and_542_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2692;
  assign select_2692 = and_542_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2693;
  assign select_2693 = and_542_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2694;
  assign select_2694 = and_542_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2695;
  assign select_2695 = and_542_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2696;
  assign select_2696 = and_542_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2697;
  assign select_2697 = and_542_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2698;
  assign select_2698 = and_542_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2699;
  assign select_2699 = and_542_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2700;
  assign select_2700 = and_542_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2701;
  assign select_2701 = and_542_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2702;
  assign select_2702 = and_542_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2703;
  assign select_2703 = and_542_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2704;
  assign select_2704 = and_542_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2705;
  assign select_2705 = and_542_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2706;
  assign select_2706 = and_542_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2707;
  assign select_2707 = and_542_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2708;
  assign select_2708 = and_542_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2709;
  assign select_2709 = and_542_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2710;
  assign select_2710 = and_542_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2711;
  assign select_2711 = and_542_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2712;
  assign select_2712 = and_542_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2713;
  assign select_2713 = and_542_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2714;
  assign select_2714 = and_542_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2715;
  assign select_2715 = and_542_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2716;
  assign select_2716 = and_542_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2717;
  assign select_2717 = and_542_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2719;
  assign difference_2719 = {1'b0, select_552} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2720;
  assign xor_2720 = difference_2719[8:0] ^ {9{difference_2719[9]}};
  logic [9:0] sum_2721;
  assign sum_2721 = {9'h0, difference_2719[9]} + {1'b0, xor_2720};
  logic [9:0] difference_2722;
  assign difference_2722 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2723;
  assign xor_2723 = difference_2722[8:0] ^ {9{difference_2722[9]}};
  logic [9:0] sum_2724;
  assign sum_2724 = {9'h0, difference_2722[9]} + {1'b0, xor_2723};
  logic [9:0] difference_2726;
  assign difference_2726 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2727;
  assign xor_2727 = difference_2726[8:0] ^ {9{difference_2726[9]}};
  logic [9:0] sum_2728;
  assign sum_2728 = {9'h0, difference_2726[9]} + {1'b0, xor_2727};
  logic [10:0] sum_2729;
  assign sum_2729 = ({1'b0, sum_2721} + {1'b0, sum_2724}) + {1'b0, sum_2728};
  logic [9:0] difference_2730;
  assign difference_2730 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2731;
  assign xor_2731 = difference_2730[8:0] ^ {9{difference_2730[9]}};
  logic [9:0] sum_2732;
  assign sum_2732 = {9'h0, difference_2730[9]} + {1'b0, xor_2731};
  logic [9:0] difference_2734;
  assign difference_2734 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2735;
  assign xor_2735 = difference_2734[8:0] ^ {9{difference_2734[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2756;
  assign sum_2756 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2758;
  assign sum_2758 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2759;
  assign equal_2759 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2760;
  assign select_2760 = equal_2759 ? sum_2756 : moments_before_0_q;
  logic [13:0] select_2762;
  assign select_2762 = equal_2759 ? sum_2758 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2765;
  assign select_2765 = equal_567_s2_q ? (moments_has_before_q | equal_2759) : moments_has_before_q;
  logic [13:0] select_2768;
  assign select_2768 = equal_567_s2_q ? ((select_2762 < select_2760) ? select_2760 : select_2762) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2769;
  assign sum_2769 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2772;
  assign select_2772 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2769)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2773;
  assign sum_2773 = {1'b0, sum_2758} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2776;
  assign select_2776 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2773)) : moments_left_alone_q;
  logic select_2779;
  assign select_2779 = equal_567_s2_q ? (~({3'h0, select_2762[13:2]} < sum_2773)) : moments_left_other_stops_q;
  logic select_2782;
  assign select_2782 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2769)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2783;
  assign sum_2783 = {1'b0, sum_2756} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2786;
  assign select_2786 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2783)) : moments_right_alone_q;
  logic select_2789;
  assign select_2789 = equal_567_s2_q ? (~({3'h0, select_2760[13:2]} < sum_2783)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2792;
  assign or_2792 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2800;
  assign and_2800 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2064)));
  logic and_2804;
  assign and_2804 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2073)));
  // hls/stages/moments.hpp:94
  logic and_2806;
  assign and_2806 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2809;
  assign select_2809 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2806)) : and_2806;
  // hls/stages/agreement.hpp:788
  logic and_2813;
  assign and_2813 = equal_567_s2_q & (equal_2759 & (cfg_prove_i & (cfg_same_table_i & select_2809)));
  // hls/stages/moments.hpp:95
  logic and_2816;
  assign and_2816 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:368
  logic [9:0] difference_2830;
  assign difference_2830 = {1'b0, select_548} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2830[9]} + (difference_2830[8:0] ^ {9{difference_2830[9]}});
  logic [9:0] difference_2842;
  assign difference_2842 = {1'b0, select_552} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2842[9]} + (difference_2842[8:0] ^ {9{difference_2842[9]}});
  // hls/stages/agreement.hpp:788
  logic not_3030;
  assign not_3030 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3031;
  assign less_3031 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_3038;
  assign and_3038 = and_542_s2_q & (equal_672_s2_q & equal_2933_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_3044;
  assign and_3044 = not_568_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3040_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3064;
  assign and_3064 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3065;
  assign and_3065 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3066;
  assign and_3066 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3067;
  assign and_3067 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3069;
  assign sum_3069 = {1'b0, and_3066} + ({1'b0, explained} + {1'b0, and_3067});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3064} + ({2'h0, and_3065} + {1'b0, sum_3069});
  // hls/stages/agreement.hpp:788
  logic and_3105;
  assign and_3105 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3040_s2_q & and_2482)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3129;
  assign difference_3129 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3132;
  assign less_3132 = {2'h0, difference_3129[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3135;
  assign and_3135 = not_576_s2_q & (((and_2480_s2_q & and_627) & equal_3125_s2_q) & (~less_3132));
  // hls/stages/agreement.hpp:788
  logic and_3139;
  assign and_3139 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_572_s2_q & and_3135)));
  // hls/stages/agreement.hpp:149
  logic and_3144;
  assign and_3144 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3146;
  assign and_3146 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3147;
  assign select_3147 = or_572_s2_q ? {and_3146, and_3144} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3149;
  assign select_3149 = less_575_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3150;
  assign select_3150 = or_572_s2_q ? select_3149 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3152;
  assign and_3152 = and_629 & (select_3147[0] & select_3150[0]);
  // hls/stages/agreement.hpp:788
  logic and_3156;
  assign and_3156 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3147[1] & and_3152)));
  logic and_3157;
  assign and_3157 = not_568_s2_q & and_3156;
  logic and_3163;
  assign and_3163 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3150[1] & and_3152)));
  logic and_3164;
  assign and_3164 = not_568_s2_q & and_3163;
  // hls/stages/registration.hpp:76
  logic less_3167;
  assign less_3167 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3169;
  assign select_3169 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3171;
  assign select_3171 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3173;
  assign select_3173 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3171} - {1'b0, select_3173};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3175;
  assign select_3175 = rise_2[8] ? select_3171 : select_3173;
  logic [8:0] fall;
  assign fall = {1'b0, select_3169} - {1'b0, select_3175};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3178;
  assign not_3178 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3167 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3178};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3180;
  assign xor_3180 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3180};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3186;
  assign select_3186 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3167 ? {taken, 1'b1} : {not_3178, select_3186, not_3178};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3188;
  assign sum_3188 = {left, 1'b1} + {taken_2, less_3167};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3190;
  assign select_3190 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3192;
  assign select_3192 = equal_567_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3194;
  assign select_3194 = equal_567_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3195;
  assign equal_3195 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3199;
  assign and_3199 = and_629 & less_2169_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3201;
  assign select_3201 = or_572_s2_q ? (less_575_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3205;
  assign sum_3205 = select_3201[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3208;
  assign select_3208 = (select_3171 < select_3173) ? ({sum_3205, select_3201[0], 5'h0} - {3'h0, select_3190}) : {sum_3205, select_3201[0], select_3190};
  logic [7:0] select_3209;
  assign select_3209 = ((select_3201 == 3'h0) | (select_3201 == 3'h4)) ? {sum_3205, select_3201[0], 5'h0} : select_3208;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3209[7]}}, select_3209} - {sum_2188[9], sum_2188, sum_2184[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3212;
  assign select_3212 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3212[11:7])) ? 12'h7f : select_3212;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3233;
  assign difference_3233 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3235;
  assign and_3235 = and_3199 & ($signed(difference_3233) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3248;
  assign less_3248 = $signed(difference_3233) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3256;
  assign select_3256 = so_s2_q ? (equal_3195 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3259;
  assign select_3259 = so_s2_q ? (equal_2170 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3264;
  assign select_3264 = (sum_2080 == 2'h2) ? (registration_fresh_q & (~select_2127)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3266;
  assign select_3266 = so_s2_q ? (and_2122 ? select_3264 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3268;
  assign select_3268 = and_3038 ? 4'hf : (equal_567_s2_q ? registration_fresh_q : select_3266);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2077;
  // hls/stages/registration.hpp:258
  logic not_3289;
  assign not_3289 = ~quarter_2[1];
  logic [3:0] select_3290;
  assign select_3290 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3289, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3289};
  // hls/stages/patches.hpp:91
  logic parity_3424;
  assign parity_3424 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3425;
  assign select_3425 = equal_2933_s2_q ? {patches_chance_q[14:0], parity_3424} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_3427;
  assign not_3427 = ~and_2244;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3430;
  assign select_3430 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3430};
  // hls/stages/agreement.hpp:788
  logic and_3436;
  assign and_3436 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3440;
  assign and_3440 = not_3427 & (patches_fixed_q | ((not_568_s2_q & and_3436) & and_2216));
  // hls/stages/patches.hpp:354
  logic not_3453;
  assign not_3453 = ~select_2159[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3455;
  assign select_3455 = sample_pair_whole_s2_q ? (equal_2160 ? select_2159 : {not_3453, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3554;
  assign select_3554 = or_2252_s2_q ? {and_2398_s2_q, and_2395_s2_q, and_2379_s2_q, and_2376, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3556;
  assign select_3556 = equal_2246_s2_q ? patches_codes_at_q : (equal_2248_s2_q ? other[55:4] : select_3554);
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_2352_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:521
  logic [27:0] select_3559;
  assign select_3559 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3561;
  assign select_3561 = equal_2248_s2_q ? (new_row_s2_q ? word : select_3559) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3563;
  assign select_3563 = less_2339_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3565;
  assign select_3565 = less_3564_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3567;
  assign select_3567 = or_2252_s2_q ? (equal_2251_s2_q ? patches_next_codes_q : select_3565) : patches_next_codes_q;
  logic [55:0] select_3569;
  assign select_3569 = equal_2246_s2_q ? patches_next_codes_q : (equal_2248_s2_q ? select_3563 : select_3567);
  // hls/stages/count_bits.hpp:24
  logic parity_3574;
  assign parity_3574 = ^{and_2398_s2_q, and_2395_s2_q, and_2379_s2_q, and_2376};
  // hls/stages/count_bits.hpp:25
  logic or_3578;
  assign or_3578 = ({and_2379_s2_q, and_2376} == 2'h3) | (and_2395_s2_q & (and_2379_s2_q | and_2376));
  logic and_3579;
  assign and_3579 = and_2398_s2_q & (^{and_2395_s2_q, and_2379_s2_q, and_2376});
  // hls/stages/count_bits.hpp:24
  logic xor_3580;
  assign xor_3580 = or_3578 ^ and_3579;
  // hls/stages/count_bits.hpp:27
  logic and_3581;
  assign and_3581 = or_3578 & and_3579;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3583;
  assign select_3583 = or_2252_s2_q ? (and_2421_s2_q ? {and_3581, xor_3580, parity_3574} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3587;
  assign sum_3587 = {7'h0, patches_set_q} + (equal_2251_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:522
  logic [47:0] select_3597;
  assign select_3597 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3599;
  assign select_3599 = equal_2246_s2_q ? patches_left_row_q : (equal_2248_s2_q ? select_3597 : patches_left_row_q);
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3597;
  // hls/stages/count_bits.hpp:24
  logic xor_3603;
  assign xor_3603 = bits[17] ^ (^{select_3597[16:15], other[16:15]});
  logic xor_3606;
  assign xor_3606 = bits[11] ^ (^{select_3597[10:9], other[10:9]});
  logic xor_3609;
  assign xor_3609 = bits[14] ^ (^{select_3597[13:12], other[13:12]});
  logic xor_3612;
  assign xor_3612 = xor_3603 ^ (^{select_3597[14:9], other[14:9]});
  logic xor_3615;
  assign xor_3615 = bits[47] ^ (^{select_3597[46:45], other[46:45]});
  logic xor_3618;
  assign xor_3618 = bits[8] ^ (^{select_3597[7:6], other[7:6]});
  logic xor_3621;
  assign xor_3621 = bits[2] ^ (^{select_3597[1:0], other[1:0]});
  logic xor_3624;
  assign xor_3624 = bits[5] ^ (^{select_3597[4:3], other[4:3]});
  logic xor_3627;
  assign xor_3627 = xor_3618 ^ (^{select_3597[5:0], other[5:0]});
  logic parity_3629;
  assign parity_3629 = ^{select_3597[47:45], select_3597[8:0], other[47:45], other[8:0]};
  logic xor_3630;
  assign xor_3630 = xor_3612 ^ parity_3629;
  logic xor_3633;
  assign xor_3633 = bits[44] ^ (^{select_3597[43:42], other[43:42]});
  logic xor_3636;
  assign xor_3636 = bits[38] ^ (^{select_3597[37:36], other[37:36]});
  logic xor_3639;
  assign xor_3639 = bits[41] ^ (^{select_3597[40:39], other[40:39]});
  logic xor_3645;
  assign xor_3645 = bits[26] ^ (^{select_3597[25:24], other[25:24]});
  logic xor_3648;
  assign xor_3648 = bits[20] ^ (^{select_3597[19:18], other[19:18]});
  logic xor_3651;
  assign xor_3651 = bits[23] ^ (^{select_3597[22:21], other[22:21]});
  logic xor_3654;
  assign xor_3654 = xor_3645 ^ (^{select_3597[23:18], other[23:18]});
  logic xor_3657;
  assign xor_3657 = bits[35] ^ (^{select_3597[34:33], other[34:33]});
  logic xor_3660;
  assign xor_3660 = bits[29] ^ (^{select_3597[28:27], other[28:27]});
  logic xor_3663;
  assign xor_3663 = bits[32] ^ (^{select_3597[31:30], other[31:30]});
  logic xor_3666;
  assign xor_3666 = xor_3657 ^ (^{select_3597[32:27], other[32:27]});
  logic xor_3667;
  assign xor_3667 = xor_3654 ^ xor_3666;
  // hls/stages/count_bits.hpp:25
  logic or_3675;
  assign or_3675 = (xor_3606 & xor_3609) | (xor_3603 & (xor_3606 | xor_3609));
  logic or_3679;
  assign or_3679 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3683;
  assign or_3683 = (xor_3621 & xor_3624) | (xor_3618 & (xor_3621 | xor_3624));
  // hls/stages/count_bits.hpp:23
  logic or_3690;
  assign or_3690 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3694;
  assign or_3694 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3698;
  assign or_3698 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3701;
  assign parity_3701 = ^{or_3698, or_3694, or_3690};
  // hls/stages/count_bits.hpp:23
  logic or_3705;
  assign or_3705 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3709;
  assign or_3709 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3713;
  assign or_3713 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3716;
  assign parity_3716 = ^{or_3713, or_3709, or_3705};
  logic parity_3719;
  assign parity_3719 = ^{or_3713, or_3709, or_3705, or_3698, or_3694, or_3690, or_3683, or_3679, or_3675};
  // hls/stages/count_bits.hpp:23
  logic or_3723;
  assign or_3723 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3727;
  assign or_3727 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3731;
  assign or_3731 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3739;
  assign or_3739 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3743;
  assign or_3743 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3747;
  assign or_3747 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3750;
  assign parity_3750 = ^{or_3747, or_3743, or_3739};
  // hls/stages/count_bits.hpp:23
  logic or_3754;
  assign or_3754 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3758;
  assign or_3758 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3762;
  assign or_3762 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3765;
  assign parity_3765 = ^{or_3762, or_3758, or_3754};
  logic parity_3768;
  assign parity_3768 = ^{or_3762, or_3758, or_3754, or_3747, or_3743, or_3739, or_3731, or_3727, or_3723};
  // hls/stages/count_bits.hpp:25
  logic or_3772;
  assign or_3772 = (xor_3636 & xor_3639) | (xor_3633 & (xor_3636 | xor_3639));
  logic or_3776;
  assign or_3776 = (xor_3648 & xor_3651) | (xor_3645 & (xor_3648 | xor_3651));
  logic or_3780;
  assign or_3780 = (xor_3660 & xor_3663) | (xor_3657 & (xor_3660 | xor_3663));
  // hls/stages/count_bits.hpp:24
  logic parity_3783;
  assign parity_3783 = ^{or_3780, or_3776, or_3772};
  // hls/stages/count_bits.hpp:25
  logic and_3784;
  assign and_3784 = xor_3630 & (^{xor_3667, select_3597[44:36], other[44:36]});
  logic or_3788;
  assign or_3788 = (xor_3615 & xor_3627) | (xor_3612 & (xor_3615 | xor_3627));
  logic and_3791;
  assign and_3791 = (xor_3633 ^ (^{select_3597[41:36], other[41:36]})) & (xor_3654 | xor_3666);
  logic or_3792;
  assign or_3792 = (xor_3654 & xor_3666) | and_3791;
  // hls/stages/count_bits.hpp:24
  logic parity_3795;
  assign parity_3795 = ^{or_3792, or_3788, and_3784};
  logic parity_3798;
  assign parity_3798 = ^{or_3792, or_3788, and_3784, or_3780, or_3776, or_3772, or_3762, or_3758, or_3754, or_3747, or_3743, or_3739, or_3731, or_3727, or_3723};
  logic parity_3800;
  assign parity_3800 = ^{or_3792, or_3788, and_3784, or_3780, or_3776, or_3772, or_3762, or_3758, or_3754, or_3747, or_3743, or_3739, or_3731, or_3727, or_3723, or_3713, or_3709, or_3705, or_3698, or_3694, or_3690, or_3683, or_3679, or_3675};
  // hls/stages/count_bits.hpp:25
  logic and_3801;
  assign and_3801 = parity_3719 & parity_3798;
  logic or_3805;
  assign or_3805 = (parity_3701 & parity_3716) | ((^{or_3683, or_3679, or_3675}) & (parity_3701 | parity_3716));
  logic or_3809;
  assign or_3809 = (parity_3783 & parity_3795) | (parity_3768 & (parity_3783 | parity_3795));
  logic or_3816;
  assign or_3816 = (parity_3750 & parity_3765) | ((^{or_3731, or_3727, or_3723}) & (parity_3750 | parity_3765));
  logic or_3820;
  assign or_3820 = (or_3776 & or_3780) | (or_3772 & (or_3776 | or_3780));
  logic or_3824;
  assign or_3824 = (or_3788 & or_3792) | (and_3784 & (or_3788 | or_3792));
  // hls/stages/count_bits.hpp:23
  logic or_3831;
  assign or_3831 = (or_3727 & or_3731) | (or_3723 & (or_3727 | or_3731));
  // hls/stages/count_bits.hpp:25
  logic or_3835;
  assign or_3835 = (or_3743 & or_3747) | (or_3739 & (or_3743 | or_3747));
  logic or_3839;
  assign or_3839 = (or_3758 & or_3762) | (or_3754 & (or_3758 | or_3762));
  // hls/stages/count_bits.hpp:24
  logic parity_3842;
  assign parity_3842 = ^{or_3839, or_3835, or_3831};
  // hls/stages/count_bits.hpp:23
  logic or_3846;
  assign or_3846 = (or_3679 & or_3683) | (or_3675 & (or_3679 | or_3683));
  // hls/stages/count_bits.hpp:25
  logic or_3850;
  assign or_3850 = (or_3694 & or_3698) | (or_3690 & (or_3694 | or_3698));
  logic or_3854;
  assign or_3854 = (or_3709 & or_3713) | (or_3705 & (or_3709 | or_3713));
  // hls/stages/count_bits.hpp:24
  logic parity_3857;
  assign parity_3857 = ^{or_3854, or_3850, or_3846};
  logic parity_3860;
  assign parity_3860 = ^{or_3854, or_3850, or_3846, or_3839, or_3835, or_3831, or_3824, or_3820, or_3816};
  logic parity_3862;
  assign parity_3862 = ^{or_3854, or_3850, or_3846, or_3839, or_3835, or_3831, or_3824, or_3820, or_3816, or_3809, or_3805, and_3801};
  // hls/stages/count_bits.hpp:25
  logic or_3866;
  assign or_3866 = (or_3820 & or_3824) | (or_3816 & (or_3820 | or_3824));
  logic or_3870;
  assign or_3870 = (or_3835 & or_3839) | (or_3831 & (or_3835 | or_3839));
  logic or_3874;
  assign or_3874 = (or_3850 & or_3854) | (or_3846 & (or_3850 | or_3854));
  // hls/stages/count_bits.hpp:24
  logic parity_3877;
  assign parity_3877 = ^{or_3874, or_3870, or_3866};
  // hls/stages/count_bits.hpp:25
  logic and_3878;
  assign and_3878 = (^{or_3809, or_3805, and_3801}) & parity_3860;
  logic or_3882;
  assign or_3882 = (or_3805 & or_3809) | (and_3801 & (or_3805 | or_3809));
  logic or_3886;
  assign or_3886 = (parity_3842 & parity_3857) | ((^{or_3824, or_3820, or_3816}) & (parity_3842 | parity_3857));
  // hls/stages/count_bits.hpp:24
  logic parity_3889;
  assign parity_3889 = ^{or_3886, or_3882, and_3878};
  // hls/stages/count_bits.hpp:25
  logic and_3891;
  assign and_3891 = parity_3877 & parity_3889;
  logic or_3895;
  assign or_3895 = (or_3870 & or_3874) | (or_3866 & (or_3870 | or_3874));
  logic or_3899;
  assign or_3899 = (or_3882 & or_3886) | (and_3878 & (or_3882 | or_3886));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3944;
  assign select_3944 = equal_2248_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3947;
  assign select_3947 = equal_2246_s2_q ? patches_summed_first_q : (equal_2248_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:556
  logic [9:0] select_3954;
  assign select_3954 = less_2427_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3957;
  assign select_3957 = equal_2430_s2_q ? (less_2427_s2_q ? (equal_2430_s2_q ? 10'h0 : select_3954) : 10'h0) : select_3954;
  logic [9:0] select_3959;
  assign select_3959 = less_2427_s2_q ? (equal_2428_s2_q ? 10'h0 : select_3957) : select_3957;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3961;
  assign select_3961 = less_2427_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3964;
  assign select_3964 = equal_2430_s2_q ? (less_2427_s2_q ? (equal_2430_s2_q ? 5'h0 : select_3961) : 5'h0) : select_3961;
  logic [4:0] select_3966;
  assign select_3966 = less_2427_s2_q ? (equal_2428_s2_q ? 5'h0 : select_3964) : select_3964;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3968;
  assign select_3968 = less_2427_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3971;
  assign select_3971 = equal_2430_s2_q ? (less_2427_s2_q ? (equal_2430_s2_q ? 5'h0 : select_3968) : 5'h0) : select_3968;
  logic [4:0] select_3973;
  assign select_3973 = less_2427_s2_q ? (equal_2428_s2_q ? 5'h0 : select_3971) : select_3971;
  // hls/stages/patches.hpp:556
  logic and_3976;
  assign and_3976 = less_2427_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3979;
  assign select_3979 = equal_2430_s2_q ? (less_2427_s2_q ? (not_2431_s2_q & and_3976) : and_3976) : and_3976;
  // hls/stages/patches.hpp:184
  logic select_3982;
  assign select_3982 = equal_2246_s2_q ? (less_2427_s2_q ? (not_2429_s2_q & select_3979) : select_3979) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3993;
  assign or_3993 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3994;
  assign and_3994 = patches_read_searches_s2_q & or_3993;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3995;
  assign select_3995 = and_3994 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3995};
  // hls/stages/patches.hpp:556
  logic and_3999;
  assign and_3999 = less_2427_s2_q & (equal_3991_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:560
  logic select_4002;
  assign select_4002 = equal_2430_s2_q ? (less_2427_s2_q ? (not_2431_s2_q & and_3999) : and_3999) : and_3999;
  // hls/stages/patches.hpp:184
  logic select_4005;
  assign select_4005 = equal_2246_s2_q ? (less_2427_s2_q ? (not_2429_s2_q & select_4002) : select_4002) : patches_read_above_q;
  // hls/stages/patches.hpp:556
  logic and_4008;
  assign and_4008 = less_2427_s2_q & (equal_3991_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:560
  logic select_4011;
  assign select_4011 = equal_2430_s2_q ? (less_2427_s2_q ? (not_2431_s2_q & and_4008) : and_4008) : and_4008;
  // hls/stages/patches.hpp:184
  logic select_4014;
  assign select_4014 = equal_2246_s2_q ? (less_2427_s2_q ? (not_2429_s2_q & select_4011) : select_4011) : patches_read_below_q;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_4015;
  assign sum_4015 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:554
  logic [9:0] select_4018;
  assign select_4018 = (equal_3991_s2_q & ({sum_4015[6], sum_4015} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_4019;
  assign select_4019 = less_2427_s2_q ? select_4018 : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4021;
  assign select_4021 = less_2427_s2_q ? (equal_2430_s2_q ? 10'h3ff : select_4019) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_4022;
  assign select_4022 = equal_2430_s2_q ? select_4021 : select_4019;
  logic [9:0] select_4024;
  assign select_4024 = less_2427_s2_q ? (equal_2428_s2_q ? 10'h3ff : select_4022) : select_4022;
  // hls/stages/patches.hpp:539
  logic [14:0] select_4026;
  assign select_4026 = and_3994 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_4027;
  assign select_4027 = equal_2246_s2_q ? select_4026[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4028;
  assign select_4028 = equal_2246_s2_q ? select_4026[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:541
  logic [9:0] select_4030;
  assign select_4030 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_4032;
  assign select_4032 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_4035;
  assign select_4035 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_4036;
  assign select_4036 = patches_read_first_q ? patches_read_far_q : select_4035;
  // hls/stages/patches.hpp:594
  logic [9:0] difference_4039;
  assign difference_4039 = select_4036 - select_4026[9:0];
  // hls/stages/patches.hpp:579
  logic less_4069;
  assign less_4069 = select_4030 < select_4032;
  // hls/stages/patches.hpp:585
  logic [1:0] sum_4070;
  assign sum_4070 = select_3995[4:3] + 2'h3;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_4069 ? select_4032 : select_4030;
  logic [9:0] low;
  assign low = (select_4032 < select_4030) ? select_4032 : select_4030;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_4026[9:0];
  // hls/stages/patches.hpp:583
  logic not_4077;
  assign not_4077 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4078;
  assign sum_4078 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4080;
  assign not_4080 = ~({eight, 3'h0} < {1'b0, sum_4078, fall_2[0]});
  logic [1:0] sum_4081;
  assign sum_4081 = {1'b0, not_4077} + {1'b0, not_4080};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_4082;
  assign sum_4082 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4084;
  assign not_4084 = ~({eight, 3'h0} < {sum_4082, fall_2[1:0]});
  logic not_4087;
  assign not_4087 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4088;
  assign sum_4088 = {1'b0, not_4084} + {1'b0, not_4087};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4081} + {1'b0, sum_4088};
  // hls/stages/patches.hpp:586
  logic [7:0] select_4091;
  assign select_4091 = less_4069 ? ({sum_4070, select_3995[2:0], 3'h0} - {5'h0, fraction}) : {sum_4070, select_3995[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_4314;
  assign select_4314 = equal_567_s2_q ? shown_shown_q : (so_s2_q ? select_2492 : shown_shown_q);
  logic select_4316;
  assign select_4316 = equal_567_s2_q ? shown_nearer_q : (so_s2_q ? select_2495 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4318;
  assign sum_4318 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4320;
  assign select_4320 = less_4317_s2_q ? (sum_4318[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4322;
  assign select_4322 = equal_2933_s2_q ? (equal_672_s2_q ? 3'h0 : select_4320) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4327;
  assign select_4327 = equal_567_s2_q ? select_2446 : (so_s2_q ? (ends_cell_s2_q ? select_2544 : select_2446) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4341;
  assign select_4341 = equal_672_s2_q ? {{2{difference_4339[6]}}, difference_4339} : (less_4317_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4343;
  assign select_4343 = and_542_s2_q ? (equal_2933_s2_q ? select_4341 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4345;
  assign select_4345 = equal_672_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4347;
  assign select_4347 = and_542_s2_q ? (equal_2933_s2_q ? select_4345 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4348;
  assign sum_4348 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4349;
  assign select_4349 = sum_4318[7] ? {1'b1, sum_4318[6:0], region_down_rest_q[0]} : sum_4348;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4318[7];
  // hls/stages/agreement.hpp:460
  logic select_4353;
  assign select_4353 = equal_2933_s2_q ? (equal_672_s2_q | (less_4317_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4358;
  assign or_4358 = segment_starts_q | not_570_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4361;
  assign select_4361 = inside_v_s2_q ? (sum_2459_s2_q ? (equal_2239 & or_2461) : or_2461) : or_4358;
  // hls/stages/agreement.hpp:788
  logic select_4364;
  assign select_4364 = equal_567_s2_q ? or_4358 : (so_s2_q ? (ends_cell_s2_q ? select_4361 : or_4358) : or_4358);
  // hls/stages/agreement.hpp:1147
  logic equal_4388;
  assign equal_4388 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4524;
  assign select_4524 = so_s2_q ? (ends_cell_s2_q ? and_2532 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4527;
  assign select_4527 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4529;
  assign select_4529 = equal_567_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4527 : centres_values_0_of_skin_q);
  logic select_4530;
  assign select_4530 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4532;
  assign select_4532 = equal_567_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4530 : centres_values_1_textured_q);
  logic select_4533;
  assign select_4533 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4535;
  assign select_4535 = equal_567_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4533 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4539;
  assign select_4539 = equal_2933_s2_q ? (equal_4536_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4542;
  assign select_4542 = and_542_s2_q ? (equal_2933_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4553;
  assign select_4553 = select_2504 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4559;
  assign select_4559 = marks_first_s2_q ? (less_4555 ? {sum_4556, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4629;
  assign not_4629 = ~quarter[1];
  logic [3:0] select_4630;
  assign select_4630 = quarter[0] ? {quarter[1], 1'b0, not_4629, 1'b0} : {1'b0, quarter[1], 1'b0, not_4629};

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

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:767; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign regions_raddr = select_2456;
  logic regions_re;
  assign regions_re = s2_en & (equal_567_s2_q ? (x_s2_q[6] & not_2457) : and_2464);
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
  assign map_raddr = {sum_2516, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2523 & less_2524);
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
  assign patches_right_codes_waddr = {sum_2360, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2412_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2398_s2_q, and_2395_s2_q, and_2379_s2_q, and_2376, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2416, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2426_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2398_s2_q, and_2395_s2_q, and_2379_s2_q, and_2376, patches_codes_at_q[51:8]};
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
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2491, textured};
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
      averager_running_of_skin_q <= select_2657;
      averager_mask_q <= select_2659;
      averager_of_skin_q <= select_2661;
      census_filled_q <= and_542_s2_q ? {select_675[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2756;
      moments_turned_1_q <= sum_2758;
      moments_before_0_q <= equal_567_s2_q ? select_2760 : moments_before_0_q;
      moments_before_1_q <= equal_567_s2_q ? select_2762 : moments_before_1_q;
      moments_has_before_q <= select_2765;
      moments_most_before_q <= select_2768;
      moments_left_begins_q <= select_2772;
      moments_left_alone_q <= select_2776;
      moments_left_other_stops_q <= select_2779;
      moments_right_begins_q <= select_2782;
      moments_right_alone_q <= select_2786;
      moments_right_other_stops_q <= select_2789;
      moments_out_of_step_q <= or_2792;
      moments_turns_0_q <= and_2800;
      moments_turns_1_q <= and_2804;
      moments_begins_alone_q <= and_2813;
      moments_ends_q <= equal_567_s2_q & (equal_2759 & (not_2814 | and_2816));
      rows_passed_above_q <= and_542_s2_q ? select_674 : rows_passed_above_q;
      shift_allowed_q <= not_3030 & (~less_3031);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3038 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3157});
      counts_turned_right_q <= and_3038 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3164});
      registration_displacement_over_q <= so_s2_q ? sum_3188[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3190;
      registration_slope_here_q <= select_3192;
      registration_expected_q <= select_3194;
      registration_of_right_q <= equal_567_s2_q ? registration_of_right_q : select_3256;
      registration_was_inside_q <= equal_567_s2_q ? registration_was_inside_q : select_3259;
      registration_fresh_q <= select_3268;
      patches_chance_q <= and_542_s2_q ? select_3425 : patches_chance_q;
      patches_fixed_q <= and_3440;
      patches_choice_valid_q <= and_2244 ? (select_2217 & not_3427) : select_2217;
      patches_choice_column_q <= select_2222;
      patches_choice_shift_q <= select_2227;
      patches_choice_slope_q <= select_2238;
      patches_band_q <= sample_pair_whole_s2_q ? select_2259 : patches_band_q;
      patches_fetch_q <= select_3455;
      patches_codes_at_q <= select_3556;
      patches_codes_further_q <= equal_2246_s2_q ? patches_codes_further_q : select_3561;
      patches_next_codes_q <= select_3569;
      patches_set_q <= equal_2246_s2_q ? 3'h0 : (equal_2248_s2_q ? 3'h0 : select_3583);
      patches_size_q <= sum_3587;
      patches_left_row_q <= select_3599;
      patches_summed_row_column_q <= equal_2246_s2_q ? patches_summed_row_column_q : select_3944;
      patches_summed_first_q <= select_3947;
      patches_read_row_differing_q <= equal_2246_s2_q ? select_3959 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2246_s2_q ? select_3966 : patches_read_row_column_q;
      patches_read_at_q <= equal_2246_s2_q ? select_3973 : patches_read_at_q;
      patches_read_first_q <= select_3982;
      patches_read_above_q <= select_4005;
      patches_read_below_q <= select_4014;
      patches_read_far_q <= equal_2246_s2_q ? select_4024 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4027;
      patches_peak_best_column_q <= select_4028;
      patches_peak_row_q <= equal_2246_s2_q ? select_3995 : patches_peak_row_q;
      patches_peak_above_q <= equal_2246_s2_q ? select_4030 : patches_peak_above_q;
      patches_peak_below_q <= equal_2246_s2_q ? select_4032 : patches_peak_below_q;
      patches_peak_far_q <= equal_2246_s2_q ? select_4036 : patches_peak_far_q;
      patches_frame_ended_q <= equal_567_s2_q & equal_2759;
      shown_shown_q <= select_4314;
      shown_nearer_q <= select_4316;
      region_row_q <= and_542_s2_q ? select_4322 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4327;
      region_down_rest_q <= select_4343;
      region_down_back_q <= select_4347;
      region_down_next_q <= select_4349;
      region_fresh_q <= and_542_s2_q ? select_4353 : region_fresh_q;
      segment_starts_q <= select_4364;
      centres_values_0_textured_q <= equal_567_s2_q ? centres_values_0_textured_q : select_4524;
      centres_values_0_of_skin_q <= select_4529;
      centres_values_1_textured_q <= select_4532;
      centres_values_1_of_skin_q <= select_4535;
      map_row_q <= and_542_s2_q ? select_4539 : map_row_q;
      map_width_q <= select_4542;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2515;
      done_q <= not_2517 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_567_s2_q & equal_4388;
      rows_passed_q <= select_2500;
      columns_passed_q <= {select_2502[7:0], or_2498};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2519;
      seen_x_q <= select_2521;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4553;
      seen_column_q <= select_2512;
      seen_rows_left_q <= select_4559;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2509;
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
      averager_total_0_q <= select_2635;
      averager_total_1_q <= select_2637;
      census_columns_values_0_cell_0_left_q <= select_2662;
      census_columns_values_0_cell_0_right_q <= select_2663;
      census_columns_values_0_cell_0_mask_q <= and_542_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2665;
      census_columns_values_0_cell_1_right_q <= select_2666;
      census_columns_values_0_cell_1_mask_q <= select_2667;
      census_columns_values_0_cell_2_left_q <= select_2668;
      census_columns_values_0_cell_2_right_q <= select_2669;
      census_columns_values_0_cell_2_mask_q <= select_2670;
      census_columns_values_0_cell_2_of_skin_q <= select_2671;
      census_columns_values_0_cell_3_left_q <= select_2672;
      census_columns_values_0_cell_3_right_q <= select_2673;
      census_columns_values_0_cell_3_mask_q <= select_2674;
      census_columns_values_0_cell_4_left_q <= select_2675;
      census_columns_values_0_cell_4_right_q <= select_2676;
      census_columns_values_0_cell_4_mask_q <= select_2677;
      census_columns_values_1_cell_0_left_q <= select_2678;
      census_columns_values_1_cell_0_right_q <= select_2679;
      census_columns_values_1_cell_0_mask_q <= select_2680;
      census_columns_values_1_cell_1_left_q <= select_2681;
      census_columns_values_1_cell_1_right_q <= select_2682;
      census_columns_values_1_cell_1_mask_q <= select_2683;
      census_columns_values_1_cell_2_left_q <= select_2684;
      census_columns_values_1_cell_2_right_q <= select_2685;
      census_columns_values_1_cell_2_mask_q <= select_2686;
      census_columns_values_1_cell_2_of_skin_q <= select_2687;
      census_columns_values_1_cell_3_left_q <= select_2688;
      census_columns_values_1_cell_3_right_q <= select_2689;
      census_columns_values_1_cell_3_mask_q <= select_2690;
      census_columns_values_1_cell_4_left_q <= select_2691;
      census_columns_values_1_cell_4_right_q <= select_2692;
      census_columns_values_1_cell_4_mask_q <= select_2693;
      census_columns_values_2_cell_0_left_q <= select_2694;
      census_columns_values_2_cell_0_right_q <= select_2695;
      census_columns_values_2_cell_0_mask_q <= select_2696;
      census_columns_values_2_cell_1_left_q <= select_2697;
      census_columns_values_2_cell_1_right_q <= select_2698;
      census_columns_values_2_cell_1_mask_q <= select_2699;
      census_columns_values_2_cell_2_left_q <= select_2700;
      census_columns_values_2_cell_2_right_q <= select_2701;
      census_columns_values_2_cell_2_mask_q <= select_2702;
      census_columns_values_2_cell_3_left_q <= select_2703;
      census_columns_values_2_cell_3_right_q <= select_2704;
      census_columns_values_2_cell_3_mask_q <= select_2705;
      census_columns_values_2_cell_4_left_q <= select_2706;
      census_columns_values_2_cell_4_right_q <= select_2707;
      census_columns_values_2_cell_4_mask_q <= select_2708;
      census_columns_values_3_cell_0_mask_q <= select_2709;
      census_columns_values_3_cell_1_left_q <= select_2710;
      census_columns_values_3_cell_1_right_q <= select_2711;
      census_columns_values_3_cell_1_mask_q <= select_2712;
      census_columns_values_3_cell_2_mask_q <= select_2713;
      census_columns_values_3_cell_3_left_q <= select_2714;
      census_columns_values_3_cell_3_right_q <= select_2715;
      census_columns_values_3_cell_3_mask_q <= select_2716;
      census_columns_values_3_cell_4_mask_q <= select_2717;
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
  logic [3:0] select_2323_s3_q;
  logic less_2427_s3_q;
  logic equal_2428_s3_q;
  logic not_2429_s3_q;
  logic equal_2430_s3_q;
  logic or_2449_s3_q;
  logic or_2452_s3_q;
  logic or_2455_s3_q;
  logic not_2457_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2484_s3_q;
  logic and_2489_s3_q;
  logic and_2523_s3_q;
  logic less_2524_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2529_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2547_s3_q;
  logic or_2550_s3_q;
  logic or_2553_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2603_s3_q;
  logic [11:0] sum_2733_s3_q;
  logic [9:0] sum_2736_s3_q;
  logic equal_2744_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3038_s3_q;
  logic and_3044_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3106_s3_q;
  logic and_3140_s3_q;
  logic and_3198_s3_q;
  logic and_3199_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3235_s3_q;
  logic and_3249_s3_q;
  logic equal_3292_s3_q;
  logic parity_3671_s3_q;
  logic parity_3800_s3_q;
  logic parity_3862_s3_q;
  logic xor_3890_s3_q;
  logic parity_3902_s3_q;
  logic or_3906_s3_q;
  logic equal_3907_s3_q;
  logic [4:0] select_4026_s3_q;
  logic equal_4038_s3_q;
  logic less_4040_s3_q;
  logic less_4041_s3_q;
  logic or_4046_s3_q;
  logic [7:0] select_4091_s3_q;
  logic equal_4388_s3_q;
  logic and_4565_s3_q;
  logic not_4579_s3_q;
  logic equal_4632_s3_q;
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
      select_2323_s3_q <= select_2323_s2_q;
      less_2427_s3_q <= less_2427_s2_q;
      equal_2428_s3_q <= equal_2428_s2_q;
      not_2429_s3_q <= not_2429_s2_q;
      equal_2430_s3_q <= equal_2430_s2_q;
      or_2449_s3_q <= or_2449;
      or_2452_s3_q <= or_2452;
      or_2455_s3_q <= or_2455;
      not_2457_s3_q <= not_2457;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2484_s3_q <= inside_v_s2_q & (and_2482 & and_2052);
      and_2489_s3_q <= not_568_s2_q & and_2464;
      and_2523_s3_q <= and_2523;
      less_2524_s3_q <= less_2524;
      index_2_s3_q <= index_2[5:0];
      sum_2529_s3_q <= sum_2529;
      textured_2_s3_q <= textured_2;
      or_2547_s3_q <= or_2547;
      or_2550_s3_q <= select_2544[7] | (~({select_2544[6], select_2544[3:2]} == 3'h0));
      or_2553_s3_q <= select_2544[7] | (~(select_2544[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2603_s3_q <= and_2603;
      sum_2733_s3_q <= {1'b0, sum_2729} + {2'h0, sum_2732};
      sum_2736_s3_q <= {9'h0, difference_2734[9]} + {1'b0, xor_2735};
      equal_2744_s3_q <= equal_2744_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3038_s3_q <= and_3038;
      and_3044_s3_q <= and_3044;
      explained_2_s3_q <= explained_2;
      and_3106_s3_q <= not_568_s2_q & and_3105;
      and_3140_s3_q <= not_568_s2_q & and_3139;
      and_3198_s3_q <= not_568_s2_q & (so_s2_q & (half_ends & equal_3195));
      and_3199_s3_q <= and_3199;
      residual_s3_q <= residual[7:0];
      and_3235_s3_q <= and_3235;
      and_3249_s3_q <= and_3199 & less_3248;
      equal_3292_s3_q <= (registration_fresh_q & select_3290) == 4'h0;
      parity_3671_s3_q <= ^{xor_3667, xor_3630, select_3597[44:36], other[44:36]};
      parity_3800_s3_q <= parity_3800;
      parity_3862_s3_q <= parity_3862;
      xor_3890_s3_q <= parity_3877 ^ parity_3889;
      parity_3902_s3_q <= ^{or_3899, or_3895, and_3891};
      or_3906_s3_q <= (or_3895 & or_3899) | (and_3891 & (or_3895 | or_3899));
      equal_3907_s3_q <= equal_3907_s2_q;
      select_4026_s3_q <= select_4026[14:10];
      equal_4038_s3_q <= select_3995[3:0] == 4'h0;
      less_4040_s3_q <= {difference_4039, 3'h0} < {3'h0, sum_3587};
      less_4041_s3_q <= select_4036 < select_4026[9:0];
      or_4046_s3_q <= (sum_3587 < 10'h39) | ({1'b0, sum_3587[9:1]} < select_4026[9:0]);
      select_4091_s3_q <= select_4091;
      equal_4388_s3_q <= equal_4388;
      and_4565_s3_q <= and_2603 & ({sum_2529, index_2[5:0]} == {sum_2516, index[5:0]});
      not_4579_s3_q <= ~proven_q;
      equal_4632_s3_q <= (registration_fresh_q & select_4630) == 4'h0;
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
  // hls/stages/patches.hpp:353
  logic [22:0] select_2262;
  assign select_2262 = and_2261_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2217_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2264;
  assign select_2264 = equal_2160_s3_q ? patches_place_0_valid_q : (select_2159_s3_q ? patches_place_0_valid_q : select_2262[0]);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2265;
  assign select_2265 = select_2159_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2262[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2266;
  assign select_2266 = equal_2160_s3_q ? patches_place_0_column_q : select_2265[7:0];
  logic [5:0] select_2267;
  assign select_2267 = equal_2160_s3_q ? patches_place_0_shift_q : select_2265[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2268;
  assign sum_2268 = select_2266 + {{2{select_2267[5]}}, select_2267};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2269;
  assign sum_2269 = sum_2268[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2270;
  assign equal_2270 = {sum_2269[6], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2269[5:0], sum_2268[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2272;
  assign or_2272 = and_2142_s3_q | (select_2264 & equal_2270);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2273;
  assign select_2273 = or_2272 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2283;
  assign select_2283 = or_2272 ? {and_2142_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2285;
  assign and_2285 = select_2282_s3_q & (~select_2283[5]);
  // hls/stages/patches.hpp:127
  logic select_2293;
  assign select_2293 = equal_2160_s3_q ? patches_place_1_valid_q : (select_2159_s3_q ? select_2262[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2294;
  assign select_2294 = select_2159_s3_q ? select_2262[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2295;
  assign select_2295 = equal_2160_s3_q ? patches_place_1_column_q : select_2294[7:0];
  logic [5:0] select_2296;
  assign select_2296 = equal_2160_s3_q ? patches_place_1_shift_q : select_2294[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2297;
  assign sum_2297 = select_2295 + {{2{select_2296[5]}}, select_2296};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2298;
  assign sum_2298 = sum_2297[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2299;
  assign equal_2299 = {sum_2298[6], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2298[5:0], sum_2297[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2301;
  assign or_2301 = and_2142_s3_q | (select_2293 & equal_2299);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2302;
  assign select_2302 = or_2301 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2303;
  assign select_2303 = or_2301 ? {and_2142_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2305;
  assign and_2305 = select_2282_s3_q & (~select_2303[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2312;
  assign sum_2312 = select_2266 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2313;
  assign equal_2313 = {sum_2312[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2312[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2315;
  assign or_2315 = and_2142_s3_q | (select_2264 & equal_2313);
  logic [4:0] select_2316;
  assign select_2316 = or_2315 ? {and_2142_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2317;
  assign sum_2317 = select_2295 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2318;
  assign equal_2318 = {sum_2317[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2317[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2321;
  assign select_2321 = (and_2142_s3_q | (select_2293 & equal_2318)) ? {and_2142_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_6;
  assign column_6 = select_2316[4] ? select_2321[3:0] : select_2316[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2324;
  assign select_2324 = or_2315 ? and_2142_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2330;
  assign and_2330 = (select_2282_s3_q & (select_2276_s3_q[3] ^ select_2276_s3_q[4])) & ((~select_2316[4]) | (~select_2321[4]));
  // hls/stages/patches.hpp:184
  logic less_2439;
  assign less_2439 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2440;
  assign not_2440 = ~less_2439;
  logic [1:0] select_2441;
  assign select_2441 = patches_summed_first_s3_q ? 2'h2 : {less_2439, not_2440};
  logic [12:0] select_2443;
  assign select_2443 = select_2441[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2444;
  assign select_2444 = select_2441[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2445;
  assign select_2445 = (select_2441 == 2'h2) ? {select_2443[12:8], patches_sums_values_0_q[9:8], select_2443[7:0]} : select_2444;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2470;
  assign select_2470 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2471;
  assign sum_2471 = {6'h0, textured_s3_q} + select_2470;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2473;
  assign sum_2473 = {3'h0, sum_2471} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2475;
  assign select_2475 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2476;
  assign sum_2476 = {6'h0, explained_s3_q} + select_2475;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2478;
  assign sum_2478 = {3'h0, sum_2476} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2485;
  assign select_2485 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2486;
  assign sum_2486 = {6'h0, and_2484_s3_q} + select_2485;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2488;
  assign sum_2488 = {3'h0, sum_2486} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2538;
  assign select_2538 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2539;
  assign difference_2539 = {1'b0, textured_2_s3_q} - {1'b0, select_2538};
  logic [4:0] t;
  assign t = {difference_2539[3], difference_2539} + (equal_562_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2542;
  assign equal_2542 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2554;
  assign not_2554 = ~region_row_s3_q[2];
  logic [2:0] select_2555;
  assign select_2555 = region_row_s3_q[1] ? {1'b0, not_2554, 1'b0} : {region_row_s3_q[2], 1'b0, not_2554};
  logic [5:0] select_2556;
  assign select_2556 = region_row_s3_q[0] ? {select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0], 1'b0} : {1'b0, select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0]};
  logic [11:0] select_2557;
  assign select_2557 = or_2553_s3_q ? {select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0], 1'b0} : {1'b0, select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0]};
  logic [23:0] select_2558;
  assign select_2558 = or_2550_s3_q ? {select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0], 1'b0} : {1'b0, select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0]};
  logic [47:0] select_2559;
  assign select_2559 = or_2547_s3_q ? {select_2558[23], 1'b0, select_2558[22], 1'b0, select_2558[21], 1'b0, select_2558[20], 1'b0, select_2558[19], 1'b0, select_2558[18], 1'b0, select_2558[17], 1'b0, select_2558[16], 1'b0, select_2558[15], 1'b0, select_2558[14], 1'b0, select_2558[13], 1'b0, select_2558[12], 1'b0, select_2558[11], 1'b0, select_2558[10], 1'b0, select_2558[9], 1'b0, select_2558[8], 1'b0, select_2558[7], 1'b0, select_2558[6], 1'b0, select_2558[5], 1'b0, select_2558[4], 1'b0, select_2558[3], 1'b0, select_2558[2], 1'b0, select_2558[1], 1'b0, select_2558[0], 1'b0} : {1'b0, select_2558[23], 1'b0, select_2558[22], 1'b0, select_2558[21], 1'b0, select_2558[20], 1'b0, select_2558[19], 1'b0, select_2558[18], 1'b0, select_2558[17], 1'b0, select_2558[16], 1'b0, select_2558[15], 1'b0, select_2558[14], 1'b0, select_2558[13], 1'b0, select_2558[12], 1'b0, select_2558[11], 1'b0, select_2558[10], 1'b0, select_2558[9], 1'b0, select_2558[8], 1'b0, select_2558[7], 1'b0, select_2558[6], 1'b0, select_2558[5], 1'b0, select_2558[4], 1'b0, select_2558[3], 1'b0, select_2558[2], 1'b0, select_2558[1], 1'b0, select_2558[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2563;
  assign and_2563 = good_known_q & (~((good_q & select_2559) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2572;
  assign select_2572 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2573;
  assign difference_2573 = {1'b0, shown_2_s3_q} - {1'b0, select_2572};
  logic [4:0] around;
  assign around = {difference_2573[3], difference_2573} + (equal_562_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2576;
  assign sum_2576 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2542 ? and_2563 : (~({sum_2576, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2588;
  assign select_2588 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2589;
  assign difference_2589 = {1'b0, near_2_s3_q} - {1'b0, select_2588};
  logic [4:0] n;
  assign n = {difference_2589[3], difference_2589} + (equal_562_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2593;
  assign and_2593 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2627;
  assign select_2627 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2629;
  assign select_2629 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2631;
  assign select_2631 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2633;
  assign select_2633 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2638;
  assign sum_2638 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2639;
  assign difference_2639 = {1'b0, sum_2638[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2640;
  assign xor_2640 = {difference_2639[8:0], sum_2638[0]} ^ {10{difference_2639[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2639[9]} + {1'b0, xor_2640};
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_545_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2645;
  assign select_2645 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2646;
  assign sum_2646 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2647;
  assign difference_2647 = {1'b0, sum_2646[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2648;
  assign xor_2648 = {difference_2647[8:0], sum_2646[0]} ^ {10{difference_2647[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2647[9]} + {1'b0, xor_2648};
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_545_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2653;
  assign select_2653 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2737;
  assign sum_2737 = sum_2733_s3_q + {2'h0, sum_2736_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2739;
  assign select_2739 = and_542_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2740;
  assign select_2740 = and_542_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2741;
  assign select_2741 = and_542_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2742;
  assign select_2742 = and_542_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [12:0] sum_2745;
  assign sum_2745 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2737};
  logic [13:0] sum_2747;
  assign sum_2747 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2745});
  // hls/stages/census.hpp:320
  logic and_2749;
  assign and_2749 = and_701_s3_q & (9'h4 < sum_2747[13:5]);
  // hls/stages/census.hpp:321
  logic and_2750;
  assign and_2750 = and_701_s3_q & less_725;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2751;
  assign sum_2751 = census_left_misses_q + {{17{and_2750}}, and_2749, 1'b0, and_2749};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2753;
  assign select_2753 = and_542_s3_q ? (equal_2744_s3_q ? 20'h0 : sum_2751) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2823;
  assign select_2823 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2826;
  assign select_2826 = and_542_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2829;
  assign and_2829 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2835;
  assign and_2835 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2836;
  assign and_2836 = and_2829 & and_2835;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2823[13:0]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2838;
  assign select_2838 = and_2836 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2840;
  assign select_2840 = equal_2744_s3_q ? {11'h0, select_2838} : (sharpness_sums_detail_0_q + {11'h0, select_2838});
  // hls/stages/agreement.hpp:457
  logic and_2847;
  assign and_2847 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2848;
  assign and_2848 = and_2829 & and_2847;
  // hls/stages/census.hpp:369
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2823[27:14]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2850;
  assign select_2850 = and_2848 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2852;
  assign select_2852 = equal_2744_s3_q ? {11'h0, select_2850} : (sharpness_sums_detail_1_q + {11'h0, select_2850});
  logic [8:0] select_2855;
  assign select_2855 = and_2836 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2856;
  assign sum_2856 = (equal_2744_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2855};
  logic [8:0] select_2859;
  assign select_2859 = and_2848 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2860;
  assign sum_2860 = (equal_2744_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2859};
  // hls/stages/agreement.hpp:211
  logic equal_2862;
  assign equal_2862 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:385
  logic less_2863;
  assign less_2863 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:424
  logic less_2864;
  assign less_2864 = x_s3_q[4:0] < 5'h3;
  logic not_2865;
  assign not_2865 = ~x_s3_q[1];
  logic [2:0] select_2866;
  assign select_2866 = x_s3_q[0] ? {1'b0, not_2865, 1'b0} : {x_s3_q[1], 1'b0, not_2865};
  logic [5:0] select_2867;
  assign select_2867 = slot_s3_q[2] ? {select_2866[2], 1'b0, select_2866[1], 1'b0, select_2866[0], 1'b0} : {1'b0, select_2866[2], 1'b0, select_2866[1], 1'b0, select_2866[0]};
  logic [11:0] select_2868;
  assign select_2868 = slot_s3_q[1] ? {select_2867[5], 1'b0, select_2867[4], 1'b0, select_2867[3], 1'b0, select_2867[2], 1'b0, select_2867[1], 1'b0, select_2867[0], 1'b0} : {1'b0, select_2867[5], 1'b0, select_2867[4], 1'b0, select_2867[3], 1'b0, select_2867[2], 1'b0, select_2867[1], 1'b0, select_2867[0]};
  logic [23:0] select_2869;
  assign select_2869 = slot_s3_q[0] ? {select_2868[11], 1'b0, select_2868[10], 1'b0, select_2868[9], 1'b0, select_2868[8], 1'b0, select_2868[7], 1'b0, select_2868[6], 1'b0, select_2868[5], 1'b0, select_2868[4], 1'b0, select_2868[3], 1'b0, select_2868[2], 1'b0, select_2868[1], 1'b0, select_2868[0], 1'b0} : {1'b0, select_2868[11], 1'b0, select_2868[10], 1'b0, select_2868[9], 1'b0, select_2868[8], 1'b0, select_2868[7], 1'b0, select_2868[6], 1'b0, select_2868[5], 1'b0, select_2868[4], 1'b0, select_2868[3], 1'b0, select_2868[2], 1'b0, select_2868[1], 1'b0, select_2868[0]};
  // hls/stages/census.hpp:387
  logic and_2873;
  assign and_2873 = less_2864 & (~((sharpness_sums_contrast_1_q & select_2869) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2875;
  assign select_2875 = (less_2863 & and_2873) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2875};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2878;
  assign select_2878 = equal_2862 ? (less_2863 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:387
  logic and_2883;
  assign and_2883 = less_2864 & (~((sharpness_sums_contrast_0_q & select_2869) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2885;
  assign select_2885 = (less_2863 & and_2883) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2885};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2888;
  assign select_2888 = equal_2862 ? (less_2863 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2890;
  assign select_2890 = equal_2862 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2892;
  assign select_2892 = equal_2862 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2894;
  assign select_2894 = equal_2862 ? {sharpness_comparing_contrast_0_q[0], and_2883} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2896;
  assign select_2896 = equal_2862 ? {sharpness_comparing_contrast_1_q[0], and_2873} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2901;
  assign select_2901 = drew_q ? (equal_2862 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2905;
  assign select_2905 = drew_q ? (equal_2862 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:384
  logic equal_2906;
  assign equal_2906 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:400
  logic xor_2907;
  assign xor_2907 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2910;
  assign select_2910 = (equal_2906 | xor_2907) ? (five_times[0] & xor_2907) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2912;
  assign select_2912 = drew_q ? (equal_2862 ? select_2910 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic xor_2913;
  assign xor_2913 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2916;
  assign select_2916 = (equal_2906 | xor_2913) ? (five_times_2[0] & xor_2913) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2918;
  assign select_2918 = drew_q ? (equal_2862 ? select_2916 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:401
  logic xor_2919;
  assign xor_2919 = sharpness_comparing_contrast_0_q[1] ^ and_2873;
  logic select_2922;
  assign select_2922 = (equal_2906 | xor_2919) ? (and_2873 & xor_2919) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2924;
  assign select_2924 = drew_q ? (equal_2862 ? select_2922 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2925;
  assign xor_2925 = sharpness_comparing_contrast_1_q[1] ^ and_2883;
  logic select_2928;
  assign select_2928 = (equal_2906 | xor_2925) ? (and_2883 & xor_2925) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2930;
  assign select_2930 = drew_q ? (equal_2862 ? select_2928 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3046;
  assign select_3046 = and_3038_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3044_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3049;
  assign and_3049 = not_568_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3054;
  assign and_3054 = not_568_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3059;
  assign and_3059 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_2484_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3063;
  assign not_3063 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3072;
  assign select_3072 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3073;
  assign difference_3073 = {1'b0, explained_2_s3_q} - {1'b0, select_3072};
  logic [4:0] e;
  assign e = {difference_3073[3], difference_3073} + (equal_562_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3076;
  assign sum_3076 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3080;
  assign not_3080 = ~(equal_2542 ? and_2563 : (~({sum_3076, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3083;
  assign and_3083 = ends_cell_s3_q & (not_3063 & (centres_values_1_textured_s3_q & not_3080));
  logic and_3085;
  assign and_3085 = not_568_s3_q & (drew_q & and_3083);
  // hls/stages/agreement.hpp:1132
  logic less_3088;
  assign less_3088 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3089;
  assign select_3089 = less_3088 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3092;
  assign select_3092 = less_3088 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3093;
  assign sum_3093 = {1'b0, select_3092} + {3'h0, select_3092[9:2]};
  logic and_3095;
  assign and_3095 = (~(select_3089[9:4] == 6'h0)) & ({sum_3093, select_3092[1:0]} < {3'h0, select_3089});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3098;
  assign select_3098 = x_s3_q[6] ? (equal_2074_s3_q ? 10'h0 : (and_3095 ? select_3089 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3099;
  assign select_3099 = equal_567_s3_q ? select_3098 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3101;
  assign select_3101 = and_3038_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3099});
  logic [13:0] select_3108;
  assign select_3108 = and_3038_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3106_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3110;
  assign and_3110 = not_3063 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3113;
  assign and_3113 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_3110));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3115;
  assign select_3115 = and_3038_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3113});
  // hls/stages/agreement.hpp:1110
  logic and_3117;
  assign and_3117 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3080);
  // hls/stages/agreement.hpp:788
  logic and_3121;
  assign and_3121 = not_568_s3_q & (drew_q & (ends_cell_s3_q & (not_3063 & and_3117)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3123;
  assign select_3123 = and_3038_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3121});
  logic [13:0] select_3142;
  assign select_3142 = and_3038_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3140_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3217;
  assign select_3217 = drew_q ? (equal_2170_s3_q ? (and_3199_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3218;
  assign select_3218 = equal_567_s3_q ? 8'h0 : select_3217;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3220;
  assign select_3220 = and_3198_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3218[7]}}, select_3218});
  // hls/stages/agreement.hpp:788
  logic and_3223;
  assign and_3223 = not_568_s3_q & (drew_q & (and_3199_s3_q & equal_2170_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3225;
  assign select_3225 = and_3198_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3223});
  // hls/stages/registration.hpp:107
  logic and_3227;
  assign and_3227 = and_3199_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3229;
  assign select_3229 = drew_q ? (equal_2170_s3_q ? {and_3227, and_3199_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3230;
  assign select_3230 = equal_567_s3_q ? 2'h0 : select_3229;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3231;
  assign sum_3231 = registration_half_votes_down_q + {{5{select_3230[1]}}, select_3230};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3237;
  assign select_3237 = drew_q ? (equal_2170_s3_q ? {and_3235_s3_q, and_3199_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3238;
  assign select_3238 = equal_567_s3_q ? 2'h0 : select_3237;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3239;
  assign sum_3239 = registration_half_votes_up_q + {{5{select_3238[1]}}, select_3238};
  // hls/stages/registration.hpp:107
  logic and_3242;
  assign and_3242 = and_3199_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3244;
  assign select_3244 = drew_q ? (equal_2170_s3_q ? {and_3242, and_3199_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3245;
  assign select_3245 = equal_567_s3_q ? 2'h0 : select_3244;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3246;
  assign sum_3246 = registration_half_half_votes_down_q + {{5{select_3245[1]}}, select_3245};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3251;
  assign select_3251 = drew_q ? (equal_2170_s3_q ? {and_3249_s3_q, and_3199_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3252;
  assign select_3252 = equal_567_s3_q ? 2'h0 : select_3251;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3253;
  assign sum_3253 = registration_half_half_votes_up_q + {{5{select_3252[1]}}, select_3252};
  // hls/stages/agreement.hpp:788
  logic and_3287;
  assign and_3287 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & less_2105_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3294;
  assign select_3294 = or_2109_s3_q ? 12'h0 : (equal_3292_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3297;
  assign select_3297 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3294 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3298;
  assign select_3298 = equal_567_s3_q ? select_3297 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3299;
  assign and_3299 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3302;
  assign and_3302 = not_2457_s3_q & (less_2105_s3_q & ({and_3299, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3304;
  assign and_3304 = equal_567_s3_q & (x_s3_q[6] & and_3302);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3306;
  assign sum_3306 = {{2{select_3298[11]}}, select_3298} + (and_3304 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3309;
  assign select_3309 = or_2109_s3_q ? 12'h0 : (equal_3292_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3312;
  assign select_3312 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3309 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3313;
  assign select_3313 = equal_567_s3_q ? select_3312 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3315;
  assign sum_3315 = {{2{select_3313[11]}}, select_3313} + (and_3304 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3317;
  assign not_3317 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3320;
  assign and_3320 = not_2457_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3317, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3326;
  assign and_3326 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & (less_2105_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3327;
  assign not_3327 = ~and_3326;
  logic less_3328;
  assign less_3328 = $signed({9'h1, {2{not_3327}}, and_3326}) < $signed(registration_up_q[13:2]);
  logic select_3329;
  assign select_3329 = (equal_567_s3_q & (x_s3_q[6] & and_3320)) ? less_3328 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3333;
  assign and_3333 = x_s3_q[6] & (not_2457_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3334;
  assign and_3334 = equal_567_s3_q & and_3333;
  // hls/stages/registration.hpp:242
  logic less_3335;
  assign less_3335 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3337;
  assign less_3337 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3339;
  assign equal_3339 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3343;
  assign and_3343 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & (less_2105_s3_q & equal_3339)));
  // hls/stages/agreement.hpp:1142
  logic and_3350;
  assign and_3350 = x_s3_q[6] & (not_2457_s3_q & (less_2105_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3353;
  assign equal_3353 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3356;
  assign and_3356 = not_2457_s3_q & (less_2105_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3353));
  // hls/stages/registration.hpp:244
  logic and_3360;
  assign and_3360 = (equal_567_s3_q & (x_s3_q[6] & and_3356)) & (less_3337 | less_3335);
  // hls/stages/agreement.hpp:1142
  logic and_3365;
  assign and_3365 = not_2457_s3_q & (less_2105_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3353)));
  // hls/stages/registration.hpp:244
  logic and_3368;
  assign and_3368 = registration_votes_up_q & registration_other_down_q;
  logic select_3370;
  assign select_3370 = registration_votes_down_q ? (registration_other_up_q | and_3368) : and_3368;
  // hls/stages/registration.hpp:138
  logic and_3372;
  assign and_3372 = (equal_567_s3_q & (x_s3_q[6] & and_3365)) & (registration_other_enough_q & select_3370);
  // hls/stages/registration.hpp:245
  logic or_3375;
  assign or_3375 = registration_moved_q | (registration_enough_q & (and_3360 | and_3372));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3460;
  assign select_3460 = sample_pair_whole_s3_q ? (equal_2160_s3_q ? patches_place_0_slope_q : select_2265[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3465;
  assign select_3465 = sample_pair_whole_s3_q ? (equal_2160_s3_q ? patches_place_1_slope_q : select_2294[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3467;
  assign select_3467 = equal_2160_s3_q ? patches_valid_0_q : (select_2159_s3_q ? patches_valid_0_q : select_2262[0]);
  // hls/stages/agreement.hpp:276
  logic select_3470;
  assign select_3470 = sample_pair_whole_s3_q ? (and_2285 ? (sample_present_s3_q & select_3467) : select_3467) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3472;
  assign select_3472 = equal_2160_s3_q ? patches_valid_1_q : (select_2159_s3_q ? select_2262[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3475;
  assign select_3475 = sample_pair_whole_s3_q ? (and_2305 ? (sample_present_s3_q & select_3472) : select_3472) : patches_valid_1_q;
  logic [5:0] select_3478;
  assign select_3478 = sample_pair_whole_s3_q ? (select_2283[5] ? {1'b1, select_2283[4:0]} : (select_2283 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3481;
  assign select_3481 = sample_pair_whole_s3_q ? (select_2303[5] ? {1'b1, select_2303[4:0]} : (select_2303 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3484;
  assign select_3484 = sample_pair_whole_s3_q ? (select_2316[4] ? {1'b1, select_2316[3:0]} : (select_2316 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3487;
  assign select_3487 = sample_pair_whole_s3_q ? (select_2321[4] ? {1'b1, select_2321[3:0]} : (select_2321 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3906_s3_q, parity_3902_s3_q, xor_3890_s3_q, parity_3862_s3_q, parity_3800_s3_q, parity_3671_s3_q} + (equal_3907_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3911;
  assign select_3911 = equal_2246_s3_q ? patches_sums_values_0_q : (equal_2248_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3912;
  assign select_3912 = equal_2248_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3914;
  assign select_3914 = equal_2248_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3916;
  assign select_3916 = equal_2248_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3918;
  assign select_3918 = equal_2248_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3920;
  assign select_3920 = equal_2248_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3922;
  assign select_3922 = equal_2248_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3924;
  assign select_3924 = equal_2248_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3926;
  assign select_3926 = equal_2248_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3928;
  assign select_3928 = equal_2248_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3930;
  assign select_3930 = equal_2248_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3932;
  assign select_3932 = equal_2248_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3934;
  assign select_3934 = equal_2248_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3936;
  assign select_3936 = equal_2248_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3938;
  assign select_3938 = equal_2248_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3940;
  assign select_3940 = equal_2248_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3942;
  assign select_3942 = equal_2248_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:599
  logic or_4047;
  assign or_4047 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4046_s3_q;
  logic or_4050;
  assign or_4050 = equal_4038_s3_q | (less_4040_s3_q | (less_4041_s3_q | or_4047));
  // hls/stages/patches.hpp:579
  logic not_4051;
  assign not_4051 = ~or_4050;
  // hls/stages/patches.hpp:560
  logic and_4052;
  assign and_4052 = equal_2430_s3_q & not_4051;
  // hls/stages/patches.hpp:184
  logic and_4055;
  assign and_4055 = equal_2246_s3_q & (less_2427_s3_q ? (not_2429_s3_q & and_4052) : and_4052);
  // hls/stages/patches.hpp:657
  logic not_4056;
  assign not_4056 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:560
  logic and_4058;
  assign and_4058 = equal_2430_s3_q & (patches_second_s3_q & not_4051);
  // hls/stages/patches.hpp:184
  logic and_4061;
  assign and_4061 = equal_2246_s3_q & (less_2427_s3_q ? (not_2429_s3_q & and_4058) : and_4058);
  // hls/stages/patches.hpp:657
  logic not_4062;
  assign not_4062 = ~and_4061;
  // hls/stages/patches.hpp:188
  logic and_4064;
  assign and_4064 = and_4055 & (not_4056 & not_4062);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4066;
  assign sum_4066 = {7'h0, and_4064} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:597
  logic [7:0] select_4092;
  assign select_4092 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [5:0] select_4093;
  assign select_4093 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4094;
  assign sum_4094 = {2'h0, select_4026_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4095;
  assign sum_4095 = {select_4093[5], select_4093} + {{3{sum_4094[3]}}, sum_4094};
  // hls/stages/patches.hpp:597
  logic [17:0] product_4096;
  assign product_4096 = $signed({{10{select_4092[7]}}, select_4092}) * $signed({{8{sum_4095[6]}}, sum_4095, select_4026_s3_q[2:0]});
  // hls/stages/patches.hpp:598
  logic [13:0] difference_4097;
  assign difference_4097 = {{6{select_4091_s3_q[7]}}, select_4091_s3_q} - {product_4096[17], product_4096[17:5]};
  // hls/stages/patches.hpp:604
  logic less_4098;
  assign less_4098 = $signed({{7{difference_4068[6]}}, difference_4068}) < $signed(difference_4097);
  // hls/stages/patches.hpp:560
  logic and_4101;
  assign and_4101 = equal_2430_s3_q & (not_4051 & (~less_4098));
  // hls/stages/patches.hpp:184
  logic and_4104;
  assign and_4104 = equal_2246_s3_q & (less_2427_s3_q ? (not_2429_s3_q & and_4101) : and_4101);
  // hls/stages/patches.hpp:660
  logic and_4105;
  assign and_4105 = and_4104 & and_4064;
  logic [7:0] sum_4106;
  assign sum_4106 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4105};
  // hls/stages/patches.hpp:560
  logic and_4110;
  assign and_4110 = not_4051 & (~($signed(difference_4097) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4111;
  assign and_4111 = equal_2430_s3_q & and_4110;
  // hls/stages/patches.hpp:184
  logic and_4114;
  assign and_4114 = equal_2246_s3_q & (less_2427_s3_q ? (not_2429_s3_q & and_4111) : and_4111);
  // hls/stages/patches.hpp:661
  logic and_4115;
  assign and_4115 = and_4114 & and_4064;
  logic [7:0] sum_4116;
  assign sum_4116 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4115};
  // hls/stages/patches.hpp:188
  logic and_4118;
  assign and_4118 = and_4055 & (and_4061 & not_4056);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4120;
  assign sum_4120 = {7'h0, and_4118} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_4122;
  assign and_4122 = and_4104 & and_4118;
  logic [7:0] sum_4123;
  assign sum_4123 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4122};
  // hls/stages/patches.hpp:661
  logic and_4125;
  assign and_4125 = and_4114 & and_4118;
  logic [7:0] sum_4126;
  assign sum_4126 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4125};
  // hls/stages/patches.hpp:188
  logic and_4128;
  assign and_4128 = and_4055 & (patches_lower_s3_q & not_4062);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4130;
  assign sum_4130 = {7'h0, and_4128} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_4132;
  assign and_4132 = and_4104 & and_4128;
  logic [7:0] sum_4133;
  assign sum_4133 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4132};
  // hls/stages/patches.hpp:661
  logic and_4135;
  assign and_4135 = and_4114 & and_4128;
  logic [7:0] sum_4136;
  assign sum_4136 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4135};
  // hls/stages/patches.hpp:188
  logic and_4138;
  assign and_4138 = and_4055 & (patches_lower_s3_q & and_4061);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4140;
  assign sum_4140 = {7'h0, and_4138} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_4142;
  assign and_4142 = and_4104 & and_4138;
  logic [7:0] sum_4143;
  assign sum_4143 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4142};
  // hls/stages/patches.hpp:661
  logic and_4145;
  assign and_4145 = and_4114 & and_4138;
  logic [7:0] sum_4146;
  assign sum_4146 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4145};
  // hls/stages/agreement.hpp:1223
  logic equal_4147;
  assign equal_4147 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4148;
  assign less_4148 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4152;
  assign and_4152 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & (equal_4147 & less_4148)));
  // hls/stages/agreement.hpp:1142
  logic and_4157;
  assign and_4157 = x_s3_q[6] & (not_2457_s3_q & (less_4148 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4158;
  assign and_4158 = equal_567_s3_q & and_4157;
  // hls/stages/patches.hpp:623
  logic [7:0] or_4160;
  assign or_4160 = (and_4152 ? patches_quarters_0_places_q : 8'h0) | (and_4158 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4164;
  assign and_4164 = x_s3_q[6] & (not_2457_s3_q & (less_4148 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4165;
  assign and_4165 = equal_567_s3_q & and_4164;
  // hls/stages/agreement.hpp:1142
  logic and_4171;
  assign and_4171 = x_s3_q[6] & (not_2457_s3_q & (less_4148 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4172;
  assign and_4172 = equal_567_s3_q & and_4171;
  // hls/stages/patches.hpp:623
  logic [7:0] or_4174;
  assign or_4174 = (or_4160 | (and_4165 ? patches_quarters_2_places_q : 8'h0)) | (and_4172 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_4178;
  assign select_4178 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4182;
  assign and_4182 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & (less_4148 & select_4178)));
  // hls/stages/patches.hpp:624
  logic [7:0] select_4184;
  assign select_4184 = and_4152 ? (and_4182 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4186;
  assign select_4186 = and_4158 ? (and_4182 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4189;
  assign select_4189 = and_4165 ? (and_4182 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4192;
  assign select_4192 = and_4172 ? (and_4182 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_4195;
  assign select_4195 = and_4152 ? (and_4182 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4197;
  assign select_4197 = and_4158 ? (and_4182 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4200;
  assign select_4200 = and_4165 ? (and_4182 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4203;
  assign select_4203 = and_4172 ? (and_4182 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4205;
  assign sum_4205 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4209;
  assign and_4209 = x_s3_q[6] & (not_2457_s3_q & (less_4148 & (sum_4205[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4210;
  assign and_4210 = equal_567_s3_q & and_4209;
  // hls/stages/patches.hpp:620
  logic [7:0] select_4213;
  assign select_4213 = and_4210 ? (patches_word_places_q + (and_4158 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4216;
  assign select_4216 = and_4210 ? (patches_word_up_q + (and_4158 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4219;
  assign select_4219 = and_4210 ? (patches_word_down_q + (and_4158 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:606
  logic [5:0] select_4223;
  assign select_4223 = ($signed(difference_4097[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4097[5:0];
  logic [5:0] select_4224;
  assign select_4224 = ($signed(14'h10) < $signed(difference_4097)) ? 6'h10 : select_4223;
  // hls/stages/patches.hpp:560
  logic [5:0] select_4226;
  assign select_4226 = equal_2430_s3_q ? (or_4050 ? 6'h0 : select_4224) : 6'h0;
  logic [5:0] select_4228;
  assign select_4228 = less_2427_s3_q ? (equal_2428_s3_q ? 6'h0 : select_4226) : select_4226;
  // hls/stages/patches.hpp:663
  logic [5:0] select_4230;
  assign select_4230 = and_4055 ? (equal_2246_s3_q ? select_4228 : 6'h0) : 6'h0;
  logic [11:0] sum_4231;
  assign sum_4231 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4230[5]}}, select_4230};
  // hls/stages/agreement.hpp:788
  logic and_4235;
  assign and_4235 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q & (equal_3339 & less_4148)));
  // hls/stages/agreement.hpp:1142
  logic and_4239;
  assign and_4239 = x_s3_q[6] & (not_2457_s3_q & (less_4148 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4240;
  assign and_4240 = equal_567_s3_q & and_4239;
  // hls/stages/patches.hpp:647
  logic [7:0] select_4242;
  assign select_4242 = and_4235 ? (and_4240 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_4246;
  assign or_4246 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_4249;
  assign or_4249 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_4250;
  assign sum_4250 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_4252;
  assign select_4252 = and_4235 ? (and_4240 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_4255;
  assign and_4255 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_4257;
  assign select_4257 = and_4240 ? {and_4255, patches_found_q[2:1]} : (and_4235 ? {and_4255, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:645
  logic or_4261;
  assign or_4261 = patches_partly_q | (patches_doubted_q & (~and_4240));
  // hls/stages/patches.hpp:646
  logic select_4264;
  assign select_4264 = and_4235 ? (and_4240 ? or_4261 : (and_4235 ? or_4261 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:644
  logic select_4265;
  assign select_4265 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_4269;
  assign select_4269 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:605
  logic [10:0] sum_4271;
  assign sum_4271 = {sum_4095[6], sum_4095, select_4026_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:560
  logic and_4274;
  assign and_4274 = equal_2430_s3_q & (not_4051 & ({{5{sum_4271[10]}}, sum_4271} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4277;
  assign and_4277 = equal_2246_s3_q & (less_2427_s3_q ? (not_2429_s3_q & and_4274) : and_4274);
  // hls/stages/patches.hpp:188
  logic and_4278;
  assign and_4278 = and_4055 & and_4277;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_4279;
  assign sum_4279 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4278};
  // hls/stages/patches.hpp:653
  logic [12:0] product_4284;
  assign product_4284 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4242};
  // hls/stages/patches.hpp:188
  logic and_4286;
  assign and_4286 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4284[12:5] < patches_on_skin_q);
  logic select_4291;
  assign select_4291 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_4295;
  assign or_4295 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_4302;
  assign select_4302 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_4308;
  assign and_4308 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4309;
  assign sum_4309 = patches_age_q + {9'h0, and_4308};
  logic [9:0] select_4312;
  assign select_4312 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4309)) : sum_4309;
  // hls/stages/agreement.hpp:1188
  logic or_4369;
  assign or_4369 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_4371;
  assign equal_4371 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_4377;
  assign select_4377 = (equal_4371 & equal_4147) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4380;
  assign sum_4380 = {1'b0, select_3092} + {2'h0, select_3092[9:1]};
  logic select_4383;
  assign select_4383 = (select_3089[9:3] == 7'h0) ? ((~or_4369) & (~select_4377)) : (~({sum_4380, select_3092[0]} < {2'h0, select_3089}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4385;
  assign select_4385 = x_s3_q[6] ? (equal_2074_s3_q ? good_q : {select_4383, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4390;
  assign select_4390 = equal_567_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4388_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_4391;
  assign equal_4391 = x_s3_q[6:3] == 4'ha;
  logic equal_4393;
  assign equal_4393 = x_s3_q[6:3] == 4'hc;
  logic equal_4394;
  assign equal_4394 = x_s3_q[6:3] == 4'hb;
  logic equal_4395;
  assign equal_4395 = x_s3_q[6:3] == 4'h9;
  logic equal_4396;
  assign equal_4396 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4398;
  assign select_4398 = equal_4395 ? counts_skin_unproven_q : (equal_4396 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4400;
  assign select_4400 = equal_4394 ? counts_regions_bad_q : (equal_4391 ? counts_nearer_q : select_4398);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4393 ? counts_on_skin_q : select_4400;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1230
  logic select_4403;
  assign select_4403 = (equal_4391 & equal_4147) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_4404;
  assign not_4404 = ~hidden_for_q[7];
  logic [7:0] select_4406;
  assign select_4406 = select_4403 ? (hidden_for_q + {7'h0, not_4404}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4408;
  assign select_4408 = equal_567_s3_q ? (equal_4388_s3_q ? select_4406 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4409;
  assign select_4409 = equal_4147 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4411;
  assign select_4411 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4413;
  assign select_4413 = equal_4396 ? cfg_unproven_skin_limit_i : (equal_4371 ? cfg_unproven_limit_i : select_4411);
  logic [7:0] select_4415;
  assign select_4415 = equal_4391 ? cfg_regions_limit_i : (equal_4395 ? cfg_hidden_limit_i : select_4413);
  logic [7:0] limit;
  assign limit = equal_4393 ? cfg_regions_limit_i : (equal_4394 ? {cfg_on_skin_limit_i, 3'h0} : select_4415);
  // hls/stages/agreement.hpp:1231
  logic not_4418;
  assign not_4418 = ~x_s3_q[2];
  logic [3:0] select_4419;
  assign select_4419 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4418, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4418};
  logic [7:0] select_4420;
  assign select_4420 = x_s3_q[0] ? {select_4419[3], 1'b0, select_4419[2], 1'b0, select_4419[1], 1'b0, select_4419[0], 1'b0} : {1'b0, select_4419[3], 1'b0, select_4419[2], 1'b0, select_4419[1], 1'b0, select_4419[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4424;
  assign select_4424 = equal_4395 ? counts_skin_supervised_q : (equal_4396 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4426;
  assign select_4426 = equal_4394 ? counts_skin_textured_q : (equal_4391 ? counts_textured_q : select_4424);
  logic [13:0] of;
  assign of = equal_4393 ? counts_textured_q : select_4426;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4428;
  assign select_4428 = ((limit & select_4420) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4409} + {1'b0, select_4428};
  // hls/stages/agreement.hpp:788
  logic select_4433;
  assign select_4433 = equal_567_s3_q ? (equal_4147 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_4438;
  assign and_4438 = too_much_q & (~(equal_4396 & equal_4147));
  // hls/stages/agreement.hpp:1229
  logic select_4443;
  assign select_4443 = (over[14] & equal_4147) ? (and_4438 | ((equal_4396 | equal_4395) | (x_s3_q[6:3] == 4'hf))) : and_4438;
  // hls/stages/agreement.hpp:1125
  logic and_4448;
  assign and_4448 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4449;
  assign select_4449 = (equal_4393 & equal_4147) ? and_4448 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4451;
  assign select_4451 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4453;
  assign select_4453 = equal_567_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4451 : box_textured_columns_values_0_q);
  logic [2:0] select_4454;
  assign select_4454 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4456;
  assign select_4456 = equal_567_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4454 : box_textured_columns_values_1_q);
  logic [2:0] select_4457;
  assign select_4457 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4459;
  assign select_4459 = equal_567_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4457 : box_textured_columns_values_2_q);
  logic [2:0] select_4460;
  assign select_4460 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4462;
  assign select_4462 = equal_567_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4460 : box_textured_columns_values_3_q);
  logic [2:0] select_4463;
  assign select_4463 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4465;
  assign select_4465 = equal_567_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4463 : box_textured_columns_values_4_q);
  logic [4:0] select_4467;
  assign select_4467 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4469;
  assign select_4469 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4471;
  assign select_4471 = equal_567_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4469 : box_explained_columns_values_0_q);
  logic [2:0] select_4472;
  assign select_4472 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4474;
  assign select_4474 = equal_567_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4472 : box_explained_columns_values_1_q);
  logic [2:0] select_4475;
  assign select_4475 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4477;
  assign select_4477 = equal_567_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4475 : box_explained_columns_values_2_q);
  logic [2:0] select_4478;
  assign select_4478 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4480;
  assign select_4480 = equal_567_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4478 : box_explained_columns_values_3_q);
  logic [2:0] select_4481;
  assign select_4481 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4483;
  assign select_4483 = equal_567_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4481 : box_explained_columns_values_4_q);
  logic [4:0] select_4485;
  assign select_4485 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4488;
  assign select_4488 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4490;
  assign select_4490 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4492;
  assign select_4492 = equal_567_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4490 : box_shown_columns_values_1_q);
  logic [2:0] select_4493;
  assign select_4493 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4495;
  assign select_4495 = equal_567_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4493 : box_shown_columns_values_2_q);
  logic [2:0] select_4496;
  assign select_4496 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4498;
  assign select_4498 = equal_567_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4496 : box_shown_columns_values_3_q);
  logic [2:0] select_4499;
  assign select_4499 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4501;
  assign select_4501 = equal_567_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4499 : box_shown_columns_values_4_q);
  logic [4:0] select_4503;
  assign select_4503 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4506;
  assign select_4506 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4508;
  assign select_4508 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4510;
  assign select_4510 = equal_567_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4508 : box_nearer_columns_values_1_q);
  logic [2:0] select_4511;
  assign select_4511 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4513;
  assign select_4513 = equal_567_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4511 : box_nearer_columns_values_2_q);
  logic [2:0] select_4514;
  assign select_4514 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4516;
  assign select_4516 = equal_567_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4514 : box_nearer_columns_values_3_q);
  logic [2:0] select_4517;
  assign select_4517 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4519;
  assign select_4519 = equal_567_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4517 : box_nearer_columns_values_4_q);
  logic [4:0] select_4521;
  assign select_4521 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4566;
  assign select_4566 = and_4565_s3_q ? {and_2593, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4567;
  assign and_4567 = proven_q & less_4555;
  // hls/stages/agreement.hpp:438
  logic select_4570;
  assign select_4570 = and_2523_s3_q ? (less_2524_s3_q ? (select_4566[0] & and_4567) : seen_q) : seen_q;
  logic select_4573;
  assign select_4573 = and_2523_s3_q ? (less_2524_s3_q ? (select_4566[1] & and_4567) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4580;
  assign or_4580 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4579_s3_q;
  // hls/stages/agreement.hpp:1241
  logic not_4588;
  assign not_4588 = ~(or_4369 | not_2814);
  // hls/stages/agreement.hpp:788
  logic and_4592;
  assign and_4592 = equal_567_s3_q & (equal_4388_s3_q & (not_4588 & (select_4377 | select_4443)));
  logic and_4595;
  assign and_4595 = equal_4388_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4599;
  assign or_4599 = select_2912 | (select_2924 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4606;
  assign and_4606 = equal_567_s3_q & (equal_4388_s3_q & (not_4588 & (select_2918 | select_2930)));
  // hls/stages/agreement.hpp:1150
  logic and_4611;
  assign and_4611 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4406 < cfg_hidden_frames_i));
  logic select_4617;
  assign select_4617 = (not_2814 | (select_4449 & not_4281)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4622;
  assign and_4622 = equal_567_s3_q & (equal_4388_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4626;
  assign and_4626 = equal_567_s3_q & (x_s3_q[6] & (not_2457_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4634;
  assign select_4634 = equal_2096_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4632_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4635;
  assign select_4635 = equal_2094_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4634;
  logic [31:0] select_4636;
  assign select_4636 = equal_2092_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4635;
  logic [31:0] select_4637;
  assign select_4637 = equal_2090_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4636;
  logic [31:0] select_4638;
  assign select_4638 = equal_2088_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4637;
  logic [31:0] select_4639;
  assign select_4639 = equal_2086_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4638;
  logic [31:0] select_4640;
  assign select_4640 = equal_2084_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4639;
  logic [31:0] select_4641;
  assign select_4641 = equal_2082_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4640;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4642;
  assign select_4642 = less_3088 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4643;
  assign select_4643 = equal_2074_s3_q ? select_4641 : {2'h0, select_4642, select_3092, select_3089};

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
  assign patches_right_1_waddr = {select_2276_s3_q, select_2302};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2305);
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
  assign patches_left_waddr = {select_2324, select_2323_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2330);
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
  assign patches_rows_wdata = select_2445;
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
  assign regions_waddr = {region_row_s3_q, or_2455_s3_q, or_2452_s3_q, or_2449_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2489_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2488, sum_2478, sum_2473};
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
  assign map_waddr = {sum_2529_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2603_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2593, is_seen};
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
      census_left_misses_q <= select_2753;
      sharpness_before_last_mask_q <= select_2826;
      sharpness_sums_detail_0_q <= and_542_s3_q ? select_2840 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_542_s3_q ? select_2852 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_542_s3_q ? sum_2856 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_542_s3_q ? sum_2860 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2878 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2888 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2890 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2892 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2894 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2896 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2901;
      sharpness_comparing_carry_1_q <= select_2905;
      sharpness_comparing_less_detail_0_q <= select_2912;
      sharpness_comparing_less_detail_1_q <= select_2918;
      sharpness_comparing_less_contrast_0_q <= select_2924;
      sharpness_comparing_less_contrast_1_q <= select_2930;
      counts_supervised_q <= select_3046;
      counts_textured_q <= and_3038_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3049});
      counts_explained_q <= and_3038_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3054});
      counts_nearer_q <= and_3038_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3059});
      counts_unproven_q <= and_3038_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3085});
      counts_regions_bad_q <= select_3101;
      counts_skin_supervised_q <= select_3108;
      counts_skin_textured_q <= select_3115;
      counts_skin_unproven_q <= select_3123;
      counts_on_skin_q <= select_3142;
      registration_half_across_q <= select_3220;
      registration_half_measured_q <= select_3225;
      registration_half_votes_down_q <= and_3198_s3_q ? 7'h0 : sum_3231;
      registration_half_votes_up_q <= and_3198_s3_q ? 7'h0 : sum_3239;
      registration_half_half_votes_down_q <= and_3198_s3_q ? 7'h0 : sum_3246;
      registration_half_half_votes_up_q <= and_3198_s3_q ? 7'h0 : sum_3253;
      registration_down_q <= and_3287 ? sum_3306 : registration_down_q;
      registration_up_q <= and_3287 ? sum_3315 : registration_up_q;
      registration_enough_q <= select_3329;
      registration_votes_down_q <= and_3334 ? less_3335 : registration_votes_down_q;
      registration_votes_up_q <= and_3334 ? less_3337 : registration_votes_up_q;
      registration_other_enough_q <= and_3343 ? select_3329 : registration_other_enough_q;
      registration_other_down_q <= and_3343 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3343 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_567_s3_q & and_3350)) & or_3375;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2264 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2266 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2267 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3460;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2293 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2295 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2296 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3465;
      patches_valid_0_q <= select_3470;
      patches_valid_1_q <= select_3475;
      patches_right_next_0_q <= select_3478;
      patches_right_next_1_q <= select_3481;
      patches_left_next_0_q <= select_3484;
      patches_left_next_1_q <= select_3487;
      patches_sums_values_0_q <= select_3911;
      patches_sums_values_1_q <= equal_2246_s3_q ? patches_sums_values_1_q : select_3912;
      patches_sums_values_2_q <= equal_2246_s3_q ? patches_sums_values_2_q : select_3914;
      patches_sums_values_3_q <= equal_2246_s3_q ? patches_sums_values_3_q : select_3916;
      patches_sums_values_4_q <= equal_2246_s3_q ? patches_sums_values_4_q : select_3918;
      patches_sums_values_5_q <= equal_2246_s3_q ? patches_sums_values_5_q : select_3920;
      patches_sums_values_6_q <= equal_2246_s3_q ? patches_sums_values_6_q : select_3922;
      patches_sums_values_7_q <= equal_2246_s3_q ? patches_sums_values_7_q : select_3924;
      patches_sums_values_8_q <= equal_2246_s3_q ? patches_sums_values_8_q : select_3926;
      patches_sums_values_9_q <= equal_2246_s3_q ? patches_sums_values_9_q : select_3928;
      patches_sums_values_10_q <= equal_2246_s3_q ? patches_sums_values_10_q : select_3930;
      patches_sums_values_11_q <= equal_2246_s3_q ? patches_sums_values_11_q : select_3932;
      patches_sums_values_12_q <= equal_2246_s3_q ? patches_sums_values_12_q : select_3934;
      patches_sums_values_13_q <= equal_2246_s3_q ? patches_sums_values_13_q : select_3936;
      patches_sums_values_14_q <= equal_2246_s3_q ? patches_sums_values_14_q : select_3938;
      patches_sums_values_15_q <= equal_2246_s3_q ? patches_sums_values_15_q : select_3940;
      patches_sums_values_16_q <= equal_2246_s3_q ? patches_sums_values_16_q : select_3942;
      patches_best_differing_q <= select_2445[9:0];
      patches_best_column_q <= select_2445[14:10];
      patches_quarters_0_places_q <= sum_4066;
      patches_quarters_0_up_q <= sum_4106;
      patches_quarters_0_down_q <= sum_4116;
      patches_quarters_1_places_q <= sum_4120;
      patches_quarters_1_up_q <= sum_4123;
      patches_quarters_1_down_q <= sum_4126;
      patches_quarters_2_places_q <= sum_4130;
      patches_quarters_2_up_q <= sum_4133;
      patches_quarters_2_down_q <= sum_4136;
      patches_quarters_3_places_q <= sum_4140;
      patches_quarters_3_up_q <= sum_4143;
      patches_quarters_3_down_q <= sum_4146;
      patches_word_places_q <= or_4174;
      patches_word_up_q <= ((select_4184 | select_4186) | select_4189) | select_4192;
      patches_word_down_q <= ((select_4195 | select_4197) | select_4200) | select_4203;
      patches_sum_places_q <= select_4213;
      patches_sum_up_q <= select_4216;
      patches_sum_down_q <= select_4219;
      patches_across_q <= sum_4231;
      patches_places_q <= select_4242;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4246;
      patches_partly_q <= or_4249;
      patches_clear_limit_q <= sum_4250[8:2];
      patches_complete_q <= select_4252;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4235 ? select_4257 : patches_found_q;
      patches_doubted_q <= select_4264;
      patches_doubted_before_q <= select_4265;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4269;
      patches_on_skin_q <= sum_4279;
      patches_large_q <= not_4281 & and_4286;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4291;
      patches_spoiled_q <= or_4295;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4302;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4312;
      segment_textured_q <= select_2470 + {6'h0, and_3049};
      segment_explained_q <= select_2475 + {6'h0, and_3054};
      segment_nearer_q <= select_2485 + {6'h0, and_3059};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_567_s3_q ? select_4385 : good_q;
      good_known_q <= select_4390;
      hidden_for_q <= select_4408;
      product_q <= equal_567_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4433;
      disagree_q <= equal_567_s3_q ? select_4377 : disagree_q;
      too_much_q <= equal_567_s3_q ? select_4443 : too_much_q;
      hides_q <= equal_567_s3_q ? select_4403 : hides_q;
      overlooks_q <= equal_567_s3_q ? select_4449 : overlooks_q;
      seen_q <= select_4570;
      nearer_q <= select_4573;
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
      averager_quarter_1_0_q <= select_2627;
      averager_quarter_1_1_q <= select_2629;
      averager_quarter_2_0_q <= select_2631;
      averager_quarter_2_1_q <= select_2633;
      averager_detail_0_q <= select_2645;
      averager_detail_1_q <= select_2653;
      census_changes_values_0_left_q <= and_542_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_542_s3_q ? sum_2737 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2739;
      census_changes_values_1_right_q <= select_2740;
      census_changes_values_2_left_q <= select_2741;
      census_changes_values_2_right_q <= select_2742;
      sharpness_last_mask_q <= and_542_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_542_s3_q ? select_2823[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_542_s3_q ? select_2823[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4453;
      box_textured_columns_values_1_q <= select_4456;
      box_textured_columns_values_2_q <= select_4459;
      box_textured_columns_values_3_q <= select_4462;
      box_textured_columns_values_4_q <= select_4465;
      box_textured_sum_sums_values_0_q <= equal_567_s3_q ? box_textured_sum_sums_values_0_q : select_4467;
      box_explained_columns_values_0_q <= select_4471;
      box_explained_columns_values_1_q <= select_4474;
      box_explained_columns_values_2_q <= select_4477;
      box_explained_columns_values_3_q <= select_4480;
      box_explained_columns_values_4_q <= select_4483;
      box_explained_sum_sums_values_0_q <= equal_567_s3_q ? box_explained_sum_sums_values_0_q : select_4485;
      box_shown_columns_values_0_q <= equal_567_s3_q ? box_shown_columns_values_0_q : select_4488;
      box_shown_columns_values_1_q <= select_4492;
      box_shown_columns_values_2_q <= select_4495;
      box_shown_columns_values_3_q <= select_4498;
      box_shown_columns_values_4_q <= select_4501;
      box_shown_sum_sums_values_0_q <= equal_567_s3_q ? box_shown_sum_sums_values_0_q : select_4503;
      box_nearer_columns_values_0_q <= equal_567_s3_q ? box_nearer_columns_values_0_q : select_4506;
      box_nearer_columns_values_1_q <= select_4510;
      box_nearer_columns_values_2_q <= select_4513;
      box_nearer_columns_values_3_q <= select_4516;
      box_nearer_columns_values_4_q <= select_4519;
      box_nearer_sum_sums_values_0_q <= equal_567_s3_q ? box_nearer_sum_sums_values_0_q : select_4521;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4550_s4_q;
  logic or_4574_s4_q;
  logic and_4575_s4_q;
  logic and_4583_s4_q;
  logic and_4586_s4_q;
  logic and_4592_s4_q;
  logic and_4596_s4_q;
  logic and_4602_s4_q;
  logic and_4606_s4_q;
  logic and_4614_s4_q;
  logic and_4619_s4_q;
  logic and_4622_s4_q;
  logic and_4626_s4_q;
  logic [5:0] select_4628_s4_q;
  logic [31:0] select_4645_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4550_s4_q <= said_q;
      or_4574_s4_q <= not_2814 | select_4570;
      and_4575_s4_q <= cfg_prove_i & select_4573;
      and_4583_s4_q <= equal_567_s3_q & (equal_4388_s3_q & (cfg_prove_i & or_4580));
      and_4586_s4_q <= equal_567_s3_q & (equal_4388_s3_q & (cfg_prove_i & or_4369));
      and_4592_s4_q <= and_4592;
      and_4596_s4_q <= equal_567_s3_q & and_4595;
      and_4602_s4_q <= equal_567_s3_q & (equal_4388_s3_q & (not_4588 & or_4599));
      and_4606_s4_q <= and_4606;
      and_4614_s4_q <= equal_567_s3_q & (equal_4388_s3_q & (cfg_prove_i & and_4611));
      and_4619_s4_q <= equal_567_s3_q & (equal_4388_s3_q & select_4617);
      and_4622_s4_q <= and_4622;
      and_4626_s4_q <= and_4626;
      select_4628_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4645_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? select_4643 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4574_s4_q;
  assign marks_nearer_o = and_4575_s4_q;
  assign verdict_valid_o = and_4550_s4_q;
  assign verdict_unproven_yet_o = and_4583_s4_q;
  assign verdict_untextured_o = and_4586_s4_q;
  assign verdict_disagree_o = and_4592_s4_q;
  assign verdict_moved_o = and_4596_s4_q;
  assign verdict_unsharp_left_o = and_4602_s4_q;
  assign verdict_unsharp_right_o = and_4606_s4_q;
  assign verdict_hidden_o = and_4614_s4_q;
  assign verdict_overlooked_o = and_4619_s4_q;
  assign verdict_out_of_step_o = and_4622_s4_q;
  assign frame_valid_o = and_4626_s4_q;
  assign frame_index_o = select_4628_s4_q;
  assign frame_word_o = select_4645_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4284[4:0], sum_4250[1:0], sum_4205[1:0], product_4096[4:0], sum_3188[0], difference_3129[1:0], detail_4[1:0], detail_3[1:0], sum_2747[4:0], sum_2184[0], sum_2180[0], sum_724[4:0], cfg_width_i[2:0]};

endmodule
