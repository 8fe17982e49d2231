// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3080 bits, pipeline 843 bits, memories 127160 bits.
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
  logic not_2807;
  assign not_2807 = ~cfg_prove_i;
  logic [5:0] sum_3017;
  assign sum_3017 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4023;
  assign difference_4023 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4216;
  assign not_4216 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4274;
  assign difference_4274 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4490;
  assign less_4490 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4491;
  assign sum_4491 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

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
  // hls/stages/census.hpp:42
  logic [2:0] select_503;
  assign select_503 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_507;
  assign select_507 = select_503[0] ? averager_place_q : (row_starts ? 9'h0 : (averager_place_q + 9'h1));
  // hls/stages/census.hpp:122
  logic or_511;
  assign or_511 = row_starts | (averager_inside_q & (~(averager_place_q == 9'h13f)));
  // hls/stages/census.hpp:124
  logic select_512;
  assign select_512 = select_503[0] ? averager_inside_q : or_511;
  // hls/stages/census.hpp:42
  logic or_513;
  assign or_513 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_515;
  assign and_515 = select_512 & (select_503[0] & or_513);
  // hls/stages/census.hpp:42
  logic [2:0] select_520;
  assign select_520 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [6:0] select_536;
  assign select_536 = sample_pair_first_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_536 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_538;
  assign equal_538 = select_503 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_539;
  assign equal_539 = select_520 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_540;
  assign and_540 = equal_539 & and_515;
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
  // hls/stages/patches.hpp:396
  logic not_2140;
  assign not_2140 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_2143;
  assign not_2143 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_2144;
  assign and_2144 = patches_capturing_q & not_2143;
  // hls/stages/patches.hpp:368
  logic equal_2145;
  assign equal_2145 = {or_513, select_520} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_2147;
  assign equal_2147 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2152;
  assign and_2152 = (not_2140 & (patches_work_q == 3'h0)) & (~(and_2144 | ((~equal_2145) | (~equal_2147))));
  // hls/stages/patches.hpp:537
  logic equal_2243;
  assign equal_2243 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_2244;
  assign not_2244 = ~equal_2243;
  // hls/stages/patches.hpp:509
  logic equal_2245;
  assign equal_2245 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_2246;
  assign not_2246 = ~equal_2245;
  // hls/stages/patches.hpp:503
  logic equal_2247;
  assign equal_2247 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2248;
  assign equal_2248 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_2249;
  assign or_2249 = equal_2247 | equal_2248;
  // hls/stages/patches.hpp:464
  logic not_2250;
  assign not_2250 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_2272;
  assign select_2272 = and_2152 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2273;
  assign select_2273 = row_starts ? select_2272 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2275;
  assign and_2275 = and_2144 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2279;
  assign select_2279 = row_starts ? (and_2152 | (and_2144 & (~and_2275))) : patches_capturing_q;
  // hls/stages/agreement.hpp:275
  logic and_2287;
  assign and_2287 = not_2244 & (not_2246 & (or_2249 & (patches_second_q & equal_2248)));
  // hls/stages/patches.hpp:168
  logic not_2303;
  assign not_2303 = ~equal_2248;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2319;
  assign select_2319 = row_starts ? {select_2272[4], select_2272[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_2329;
  assign and_2329 = not_2244 & (or_2249 & not_2246);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2597;
  assign select_2597 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_503 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2600;
  assign select_2600 = sample_pair_whole_q ? (sample_last_q ? (select_520 + 3'h1) : select_520) : raster_at_y_q;
  logic [6:0] select_2603;
  assign select_2603 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_536 + {6'h0, equal_538})) : raster_at_column_q;
  logic [5:0] select_2606;
  assign select_2606 = sample_pair_whole_q ? (sample_last_q ? (select_670 + {5'h0, equal_539}) : select_670) : raster_at_row_q;
  logic select_2610;
  assign select_2610 = sample_pair_whole_q ? (sample_last_q ? (or_513 & (~raster_final_row_q)) : or_513) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2612;
  assign select_2612 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2616;
  assign select_2616 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2925;
  assign sum_2925 = {1'b0, last} + 8'h1;
  logic equal_2926;
  assign equal_2926 = {sum_2925[7], cfg_width_i[9:3]} == {1'b0, sum_2925[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2927;
  assign and_2927 = and_542 & equal_2926;
  // hls/stages/agreement.hpp:523
  logic select_2930;
  assign select_2930 = (and_2927 | (~ends_cell_q)) ? and_2927 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2930 ? (and_2927 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2934;
  assign select_2934 = select_2930 ? (and_2927 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2937;
  assign select_2937 = select_2930 ? (following_last_shift_q & (~and_2927)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2940;
  assign and_2940 = run_last_shift_q & equal_586;
  // hls/stages/agreement.hpp:616
  logic select_2942;
  assign select_2942 = equal_586 ? (~run_last_shift_q) : equal_587;
  // hls/stages/agreement.hpp:620
  logic equal_2943;
  assign equal_2943 = run_phase_q == 3'h1;
  logic not_2946;
  assign not_2946 = ~select_2942;
  // hls/stages/agreement.hpp:623
  logic equal_2948;
  assign equal_2948 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2949;
  assign and_2949 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2950;
  assign select_2950 = equal_2948 ? 2'h1 : {2{and_2949}};
  logic [2:0] select_2952;
  assign select_2952 = (and_2940 | (select_2942 | equal_2943)) ? (equal_2943 ? 3'h2 : {not_2946, {2{select_2942}}}) : (equal_571 ? 3'h6 : {select_2950[0], select_2950});
  // hls/stages/agreement.hpp:607
  logic and_2955;
  assign and_2955 = select_2942 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2958;
  assign select_2958 = (plan_shift_q[5] & select_2942) ? value : 7'h0;
  logic [1:0] or_2959;
  assign or_2959 = {2{so}} | select_2958[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2963;
  assign or_2963 = (select_2942 ? plan_columns_q : 8'h0) | ((equal_2943 | equal_2948) ? whole_q : 8'h0);
  logic [1:0] or_2964;
  assign or_2964 = {2{and_2940}} | or_2963[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2966;
  assign or_2966 = {or_2963[7:4], or_2964, or_2963[1:0]} | (equal_571 ? drawn_q : 8'h0);
  logic [4:0] or_2967;
  assign or_2967 = {5{so}} | {or_2966[6], or_2966[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2971;
  assign not_2971 = ~run_shift_q[5];
  logic [7:0] select_2974;
  assign select_2974 = equal_586 ? ({{7{not_2971}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2978;
  assign select_2978 = and_2927 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2980;
  assign select_2980 = select_2930 ? {select_2978[6], select_2978} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2983;
  assign select_2983 = select_2930 ? (and_2927 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2991;
  assign select_2991 = and_542 ? (equal_2926 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [5:0] sum_2992;
  assign sum_2992 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2994;
  assign select_2994 = and_542 ? (equal_2926 ? {sum_2992, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2995;
  assign sum_2995 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2997;
  assign select_2997 = and_542 ? (equal_2926 ? {sum_2995, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_3008;
  assign select_3008 = (ends_cell_q | select_2930) ? (~(now == 3'h6)) : (equal_586 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_3012;
  assign and_3012 = (~select_2930) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_3013;
  assign sum_3013 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_3015;
  assign select_3015 = equal_2926 ? ({sum_3013[6], cfg_height_i[8:3]} == {1'b0, sum_3013[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3374;
  assign select_3374 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3375;
  assign select_3375 = sample_pair_whole_q ? select_3374 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_3376;
  assign and_3376 = not_2143 & equal_2145;
  logic [8:0] select_3377;
  assign select_3377 = and_3376 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3378;
  assign select_3378 = and_3376 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3379;
  assign select_3379 = sample_pair_first_q ? select_3377 : select_3378;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3381;
  assign select_3381 = sample_pair_whole_q ? (row_starts ? select_3379[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3383;
  assign select_3383 = sample_pair_whole_q ? (row_starts ? select_3379[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3386;
  assign select_3386 = sample_pair_whole_q ? (equal_2147 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3388;
  assign select_3388 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2147}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_3389;
  assign equal_3389 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_3390;
  assign not_3390 = ~equal_3389;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3392;
  assign select_3392 = sample_pair_whole_q ? (phase + {not_3390, 1'b1, not_3390, equal_3389}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3394;
  assign equal_3394 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3398;
  assign select_3398 = equal_3394 ? ((select_3375 == 4'h6) ? 4'h0 : (select_3375 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3399;
  assign equal_3399 = select_3398 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3402;
  assign select_3402 = equal_2926 ? (equal_3399 ? 4'h6 : (select_3398 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3404;
  assign select_3404 = equal_3394 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3406;
  assign select_3406 = equal_2926 ? (select_3404 + {4'h0, equal_3399}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3411;
  assign select_3411 = and_542 ? (equal_2926 ? ((6'h2 < row) & equal_3399) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3413;
  assign select_3413 = and_542 ? (equal_2926 ? select_3404 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3437;
  assign sum_3437 = {1'b0, select_670[5:1]} + 6'h1;
  logic less_3438;
  assign less_3438 = {sum_3437, select_670[0], select_520, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3441;
  assign select_3441 = row_starts ? (and_2152 ? (~less_3438) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3480;
  assign or_3480 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3485;
  assign select_3485 = (patches_second_q | patches_begins_q) ? not_2140 : (patches_ends_q & equal_2243);
  logic and_3486;
  assign and_3486 = equal_2243 & not_2250;
  // hls/stages/patches.hpp:403
  logic and_3487;
  assign and_3487 = not_2303 & and_3486;
  logic [1:0] select_3489;
  assign select_3489 = equal_2245 ? 2'h0 : (equal_2247 ? 2'h3 : {equal_2248, and_3487});
  // hls/stages/patches.hpp:283
  logic equal_3491;
  assign equal_3491 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3492;
  assign not_3492 = ~equal_3491;
  // hls/stages/patches.hpp:283
  logic equal_3493;
  assign equal_3493 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3494;
  assign not_3494 = ~equal_3493;
  // hls/stages/patches.hpp:287
  logic not_3496;
  assign not_3496 = ~(patches_following_q == 3'h2);
  logic and_3499;
  assign and_3499 = (~(patches_following_q == 3'h1)) & not_3496;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3500;
  assign select_3500 = equal_3493 ? 2'h2 : {and_3499, not_3496};
  logic [3:0] select_3501;
  assign select_3501 = equal_3491 ? 4'h2 : {select_3500, {2{not_3494}}};
  // hls/stages/patches.hpp:409
  logic not_3504;
  assign not_3504 = ~or_3480;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3509;
  assign select_3509 = or_3480 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3511;
  assign select_3511 = or_3480 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2244 & (not_2246 & (or_2249 & (equal_2248 & not_2250))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2287;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:790; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2244 & (not_2246 & (not_2303 & or_2249)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:801; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_2329;
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
      raster_at_x_q <= select_2597;
      raster_at_y_q <= select_2600;
      raster_at_column_q <= select_2603;
      raster_at_row_q <= select_2606;
      raster_at_live_q <= select_2610;
      raster_rows_left_q <= sample_pair_whole_q ? select_2612 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2616;
      averager_place_q <= sample_pair_whole_q ? select_507 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_512 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2934;
      run_last_shift_q <= select_2937;
      run_span_q <= select_2930 ? (and_2927 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2952;
      following_shift_q <= select_2942 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2955;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2958[6], or_2959, select_2958[3:0]};
      following_columns_q <= {or_2966[7], or_2967[4], or_2966[5:4], or_2967[3:0]};
      plan_shift_q <= equal_586 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2974;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2980;
      columns_left_q <= select_2983;
      last_q <= and_542 ? (equal_2926 ? last : last_q) : last_q;
      least_q <= select_2991;
      whole_q <= select_2994;
      drawn_q <= select_2997;
      age_q <= select_2930 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2930 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3008;
      ends_q <= and_3012;
      final_row_q <= and_542 ? select_3015 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3375;
      patches_band_rows_rows_to_next_q <= select_3381;
      patches_band_rows_number_q <= select_3383;
      patches_next_band_rows_to_next_q <= select_3386;
      patches_next_band_number_q <= select_3388;
      patches_first_band_rows_to_next_q <= select_3392;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3389 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_542 ? select_3402 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_542 ? select_3406 : patches_choosing_number_q;
      patches_chooses_q <= select_3411;
      patches_choosing_band_q <= select_3413;
      patches_capturing_q <= sample_pair_whole_q ? select_2279 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3441 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2273 : patches_row_q;
      patches_work_q <= or_3480 ? following : patches_work_q;
      patches_second_q <= select_3485;
      patches_following_q <= equal_2243 ? {2'h0, and_3486} : {equal_2245, select_3489};
      patches_following_beats_q <= {select_3501, not_3492};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2275);
      patches_ends_q <= not_3504 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3509;
      patches_code_row_q <= select_3511;
      patches_column_q <= or_3480 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3504 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_503_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_507_s1_q;
  logic and_515_s1_q;
  logic equal_521_s1_q;
  logic [6:0] select_536_s1_q;
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
  logic and_2152_s1_q;
  logic equal_2243_s1_q;
  logic not_2244_s1_q;
  logic equal_2245_s1_q;
  logic not_2246_s1_q;
  logic equal_2247_s1_q;
  logic equal_2248_s1_q;
  logic or_2249_s1_q;
  logic not_2250_s1_q;
  logic [4:0] select_2273_s1_q;
  logic select_2279_s1_q;
  logic [3:0] select_2319_s1_q;
  logic and_2329_s1_q;
  logic equal_2926_s1_q;
  logic and_2927_s1_q;
  logic or_3480_s1_q;
  logic not_3504_s1_q;
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
      select_503_s1_q <= select_503;
      row_starts_s1_q <= row_starts;
      select_507_s1_q <= select_507;
      and_515_s1_q <= and_515;
      equal_521_s1_q <= select_520 == 3'h0;
      select_536_s1_q <= select_536;
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
      and_2152_s1_q <= and_2152;
      equal_2243_s1_q <= equal_2243;
      not_2244_s1_q <= not_2244;
      equal_2245_s1_q <= equal_2245;
      not_2246_s1_q <= not_2246;
      equal_2247_s1_q <= equal_2247;
      equal_2248_s1_q <= equal_2248;
      or_2249_s1_q <= or_2249;
      not_2250_s1_q <= not_2250;
      select_2273_s1_q <= select_2273;
      select_2279_s1_q <= select_2279;
      select_2319_s1_q <= select_2319;
      and_2329_s1_q <= and_2329;
      equal_2926_s1_q <= equal_2926;
      and_2927_s1_q <= and_2927;
      or_3480_s1_q <= or_3480;
      not_3504_s1_q <= not_3504;
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
  // hls/stages/census.hpp:127
  logic and_516;
  assign and_516 = sample_pair_whole_s1_q & and_515_s1_q;
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
  logic [16:0] select_2171;
  assign select_2171 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2171[16:7])) ? 8'h7f : select_2171[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_2248_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2248_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_2335;
  assign less_2335 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_2336;
  assign or_2336 = equal_2247_s1_q | less_2335;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2341;
  assign select_2341 = equal_2247_s1_q ? patches_column_s1_q[0] : (or_2336 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2342;
  assign not_2342 = ~or_2336;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_2343;
  assign sum_2343 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_2346;
  assign select_2346 = or_2336 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2343) + 5'h1) : sum_2343;
  // hls/stages/patches.hpp:509
  logic [4:0] select_2347;
  assign select_2347 = equal_2247_s1_q ? 5'h0 : select_2346;
  logic or_2348;
  assign or_2348 = equal_2247_s1_q | equal_2245_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_2350;
  assign equal_2350 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2352;
  assign equal_2352 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_2354;
  assign and_2354 = of_row & (~equal_2352);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2350 ? 2'h3 : {equal_2352, and_2354};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_2357;
  assign sum_2357 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2358;
  assign sum_2358 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2357, pixel_2[0]} - {1'b0, sum_2358, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_2360;
  assign sum_2360 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2361;
  assign sum_2361 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2360[11], sum_2360};
  logic [13:0] sum_2362;
  assign sum_2362 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2361, down_2[1]};
  logic [12:0] sum_2363;
  assign sum_2363 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2362[13:1];
  logic [14:0] sum_2364;
  assign sum_2364 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2363, sum_2362[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_2371;
  assign or_2371 = (sum_2364[8] & (~(sum_2364[7:0] == 8'h0))) | (~(sum_2364[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_2376;
  assign sum_2376 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2377;
  assign sum_2377 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2376};
  logic [10:0] sum_2378;
  assign sum_2378 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2377, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2379;
  assign sum_2379 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2378[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_2379, sum_2378[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_2381;
  assign sum_2381 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2382;
  assign sum_2382 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2383;
  assign difference_2383 = {1'b0, sum_2381, smooth[0]} - {1'b0, sum_2382, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_2390;
  assign or_2390 = (difference_2383[8] & (~(difference_2383[7:0] == 8'h0))) | (~(difference_2383[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_2398;
  assign or_2398 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2352) | equal_2350;
  // hls/stages/patches.hpp:481
  logic and_2403;
  assign and_2403 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:275
  logic and_2407;
  assign and_2407 = not_2246_s1_q & (or_2249_s1_q & (or_2398 & (equal_2248_s1_q & and_2403)));
  // hls/stages/patches.hpp:174
  logic and_2417;
  assign and_2417 = (~(equal_2248_s1_q | (~and_2403))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:275
  logic and_2421;
  assign and_2421 = not_2246_s1_q & (or_2249_s1_q & (and_2417 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_2423;
  assign less_2423 = patches_step_q[4:0] < 5'h11;
  logic equal_2424;
  assign equal_2424 = patches_step_q[6:5] == 2'h2;
  logic equal_2425;
  assign equal_2425 = patches_step_q[6:5] == 2'h1;
  logic or_2426;
  assign or_2426 = equal_2424 | equal_2425;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2450;
  assign sum_2450 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2736;
  assign or_2736 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:460
  logic select_3020;
  assign select_3020 = equal_2926_s1_q ? (~({row_s1_q, 1'b0} < {sum_3017, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3264;
  assign and_3264 = and_542_s1_q & (equal_2926_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3265;
  assign and_3265 = and_2927_s1_q & and_3264;
  // hls/stages/registration.hpp:127
  logic and_3267;
  assign and_3267 = and_2927_s1_q & (~and_3264);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3268;
  assign select_3268 = and_3267 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3270;
  assign select_3270 = and_3265 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3268[15]}}, select_3268});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3271;
  assign select_3271 = and_3267 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3271[15]}}, select_3271};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3273;
  assign select_3273 = and_3265 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3274;
  assign and_3274 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3274 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3519;
  assign select_3519 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:275
  logic [11:0] select_3522;
  assign select_3522 = equal_2245_s1_q ? patches_smooth_values_0_q : (or_2249_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3524;
  assign select_3524 = or_2249_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3526;
  assign select_3526 = equal_2243_s1_q ? patches_smooth_values_1_q : (equal_2245_s1_q ? patches_smooth_values_1_q : select_3524);
  logic [11:0] select_3527;
  assign select_3527 = or_2249_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3529;
  assign select_3529 = equal_2243_s1_q ? patches_smooth_values_2_q : (equal_2245_s1_q ? patches_smooth_values_2_q : select_3527);
  logic [11:0] select_3530;
  assign select_3530 = or_2249_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3532;
  assign select_3532 = equal_2243_s1_q ? patches_smooth_values_3_q : (equal_2245_s1_q ? patches_smooth_values_3_q : select_3530);
  logic [10:0] select_3534;
  assign select_3534 = equal_2245_s1_q ? patches_down_values_0_q : (or_2249_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3537;
  assign select_3537 = equal_2245_s1_q ? patches_down_values_1_q : (or_2249_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3540;
  assign select_3540 = equal_2245_s1_q ? patches_down_values_2_q : (or_2249_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3543;
  assign select_3543 = equal_2245_s1_q ? patches_down_values_3_q : (or_2249_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3580;
  assign and_3580 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3585;
  assign select_3585 = or_3480_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3587;
  assign select_3587 = and_3580 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3943;
  assign select_3943 = equal_2243_s1_q ? patches_summed_down_by_q : (equal_2245_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3961;
  assign select_3961 = equal_2243_s1_q ? (less_2423 & (equal_2425 & or_2426)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4264;
  assign select_4264 = so_s1_q ? (and_3274 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4266;
  assign sum_4266 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4267;
  assign select_4267 = sum_2450[5] ? {1'b1, sum_2450[4:0], region_across_rest_q[2:0]} : sum_4266;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4269;
  assign select_4269 = equal_2926_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4272;
  assign select_4272 = equal_2926_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_507_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_516;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:352; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  (* ram_style = "distributed" *)
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
  (* ram_style = "distributed" *)
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
  (* ram_style = "distributed" *)
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

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2347, not_2342, select_2341};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2348;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_2244_s1_q & (new_row & equal_2245_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:821; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & (equal_2243_s1_q & (less_2423 & or_2426));
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
  assign patches_columns_above_we = s1_en & and_2329_s1_q;
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
      row_q <= and_542_s1_q ? (equal_2926_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_542_s1_q ? select_3020 : lower_half_q;
      registration_slope_row_q <= select_3270;
      registration_slope_change_q <= select_3273;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3504_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3504_s1_q & select_3519;
      patches_smooth_values_0_q <= equal_2243_s1_q ? patches_smooth_values_0_q : select_3522;
      patches_smooth_values_1_q <= select_3526;
      patches_smooth_values_2_q <= select_3529;
      patches_smooth_values_3_q <= select_3532;
      patches_down_values_0_q <= equal_2243_s1_q ? patches_down_values_0_q : select_3534;
      patches_down_values_1_q <= equal_2243_s1_q ? patches_down_values_1_q : select_3537;
      patches_down_values_2_q <= equal_2243_s1_q ? patches_down_values_2_q : select_3540;
      patches_down_values_3_q <= equal_2243_s1_q ? patches_down_values_3_q : select_3543;
      patches_down_by_q <= or_3480_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3580});
      patches_along_q <= select_3585;
      patches_match_row_q <= or_3480_s1_q ? 4'h0 : select_3587;
      patches_summed_last_q <= not_2244_s1_q & (equal_2245_s1_q & and_3580);
      patches_summed_down_by_q <= select_3943;
      patches_step_q <= or_3480_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3961;
      region_across_rest_q <= select_4264;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4267;
      columns_begin_rest_q <= and_542_s1_q ? select_4269 : columns_begin_rest_q;
      columns_begin_back_q <= and_542_s1_q ? select_4272 : columns_begin_back_q;
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
  logic [2:0] select_503_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_507_s2_q;
  logic and_515_s2_q;
  logic and_516_s2_q;
  logic equal_521_s2_q;
  logic [6:0] select_536_s2_q;
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
  logic and_2152_s2_q;
  logic less_2166_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2243_s2_q;
  logic equal_2245_s2_q;
  logic equal_2248_s2_q;
  logic or_2249_s2_q;
  logic not_2250_s2_q;
  logic [4:0] select_2273_s2_q;
  logic select_2279_s2_q;
  logic [3:0] select_2319_s2_q;
  logic less_2335_s2_q;
  logic new_row_s2_q;
  logic or_2348_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2365_s2_q;
  logic or_2371_s2_q;
  logic and_2375_s2_q;
  logic and_2391_s2_q;
  logic and_2394_s2_q;
  logic and_2408_s2_q;
  logic and_2417_s2_q;
  logic and_2422_s2_q;
  logic less_2423_s2_q;
  logic equal_2424_s2_q;
  logic or_2426_s2_q;
  logic sum_2450_s2_q;
  logic and_2471_s2_q;
  logic and_2588_s2_q;
  logic equal_2737_s2_q;
  logic equal_2926_s2_q;
  logic and_3033_s2_q;
  logic equal_3118_s2_q;
  logic less_3556_s2_q;
  logic equal_3899_s2_q;
  logic equal_3996_s2_q;
  logic less_4252_s2_q;
  logic equal_4471_s2_q;
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
      select_503_s2_q <= select_503_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_507_s2_q <= select_507_s1_q;
      and_515_s2_q <= and_515_s1_q;
      and_516_s2_q <= and_516;
      equal_521_s2_q <= equal_521_s1_q;
      select_536_s2_q <= select_536_s1_q;
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
      and_2152_s2_q <= and_2152_s1_q;
      less_2166_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2243_s2_q <= equal_2243_s1_q;
      equal_2245_s2_q <= equal_2245_s1_q;
      equal_2248_s2_q <= equal_2248_s1_q;
      or_2249_s2_q <= or_2249_s1_q;
      not_2250_s2_q <= not_2250_s1_q;
      select_2273_s2_q <= select_2273_s1_q;
      select_2279_s2_q <= select_2279_s1_q;
      select_2319_s2_q <= select_2319_s1_q;
      less_2335_s2_q <= less_2335;
      new_row_s2_q <= new_row;
      or_2348_s2_q <= or_2348;
      of_row_2_s2_q <= of_row_2;
      not_2365_s2_q <= ~sum_2364[14];
      or_2371_s2_q <= or_2371;
      and_2375_s2_q <= sum_2364[14] & (~(sum_2364[13:8] == 6'h3f));
      and_2391_s2_q <= (~difference_2383[14]) & or_2390;
      and_2394_s2_q <= difference_2383[14] & (~(difference_2383[13:8] == 6'h3f));
      and_2408_s2_q <= not_2244_s1_q & and_2407;
      and_2417_s2_q <= and_2417;
      and_2422_s2_q <= not_2244_s1_q & and_2421;
      less_2423_s2_q <= less_2423;
      equal_2424_s2_q <= equal_2424;
      or_2426_s2_q <= or_2426;
      sum_2450_s2_q <= sum_2450[5];
      and_2471_s2_q <= or_572_s1_q & (left_rdata_q[69] & not_576_s1_q);
      and_2588_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2737_s2_q <= {last_s1_2_q[6], or_2736} == 7'h0;
      equal_2926_s2_q <= equal_2926_s1_q;
      and_3033_s2_q <= or_572_s1_q & (not_576_s1_q & and_600);
      equal_3118_s2_q <= shift == 6'h0;
      less_3556_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3899_s2_q <= patches_match_row_q == 4'h0;
      equal_3996_s2_q <= patches_step_q[6:5] == 2'h3;
      less_4252_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4471_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [9:0] patches_peak_size_q;
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
  // hls/stages/census.hpp:117
  logic [11:0] select_519;
  assign select_519 = select_503_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_523;
  assign sum_523 = select_519 + (equal_521_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_525;
  assign sum_525 = {4'h0, sample_pair_pixel_1_q} + (select_503_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_527;
  assign sum_527 = sum_525 + (equal_521_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_503_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_531;
  assign and_531 = whole & (averager_memory_rdata_q[24] | equal_521_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_503_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_535;
  assign and_535 = all_of_skin & (averager_memory_rdata_q[25] | equal_521_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_515_s2_q ? sum_523[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_545;
  assign equal_545 = select_503_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_545 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_548;
  assign select_548 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_515_s2_q ? sum_527[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_545 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_552;
  assign select_552 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_553;
  assign and_553 = and_515_s2_q & and_531;
  // hls/stages/census.hpp:134
  logic select_555;
  assign select_555 = equal_545 ? and_553 : (averager_mask_q & and_553);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_555;
  // hls/stages/census.hpp:218
  logic and_557;
  assign and_557 = and_515_s2_q & and_535;
  // hls/stages/census.hpp:134
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
  // hls/stages/census.hpp:308
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
  // hls/stages/census.hpp:309
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
  // hls/stages/census.hpp:290
  logic [3:0] select_675;
  assign select_675 = equal_669 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_676;
  assign and_676 = select_674[4] & select_675[3];
  // hls/stages/census.hpp:300
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
  // hls/stages/census.hpp:284
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
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_730;
  assign sum_730 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_732;
  assign and_732 = and_728 & ({{5{sum_730[6]}}, sum_730, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
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
  // hls/stages/patches.hpp:214
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
  // hls/stages/patches.hpp:377
  logic [1:0] select_2153;
  assign select_2153 = and_2152_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2154;
  assign select_2154 = and_2152_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2155;
  assign select_2155 = row_starts_s2_q ? {select_2154, select_2153[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2156;
  assign select_2156 = row_starts_s2_q ? select_2153 : patches_fetch_q;
  logic equal_2157;
  assign equal_2157 = select_2156 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_2165;
  assign and_2165 = not_568_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2167;
  assign equal_2167 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_572_s2_q ? (less_575_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2167 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2175;
  assign select_2175 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2176;
  assign select_2176 = b[1] ? a : 8'h0;
  logic [8:0] sum_2177;
  assign sum_2177 = {{2{select_2175[6]}}, select_2175} + {select_2176[7], select_2176};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2178;
  assign select_2178 = b[2] ? a : 8'h0;
  logic [7:0] select_2179;
  assign select_2179 = b[3] ? a : 8'h0;
  logic [8:0] sum_2180;
  assign sum_2180 = {{2{select_2178[7]}}, select_2178[7:1]} + {select_2179[7], select_2179};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2181;
  assign sum_2181 = {{3{sum_2177[8]}}, sum_2177[8:1]} + {sum_2180[8], sum_2180, select_2178[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2182;
  assign select_2182 = b[4] ? a : 8'h0;
  logic [7:0] select_2183;
  assign select_2183 = b[5] ? a : 8'h0;
  logic [8:0] difference_2184;
  assign difference_2184 = {{2{select_2182[7]}}, select_2182[7:1]} - {select_2183[7], select_2183};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2185;
  assign sum_2185 = {difference_2184, select_2182[0]} + {sum_2181[10], sum_2181[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2167 ? {sum_2185, sum_2181[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2187;
  assign sum_2187 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2190;
  assign and_2190 = less_2166_s2_q & (and_629 & ({{4{sum_2187[9]}}, sum_2187, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2194;
  assign and_2194 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2200;
  assign sum_2200 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2202;
  assign sum_2202 = {sum_2200[9], sum_2200[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_2205;
  assign and_2205 = ($signed(9'h0) < $signed(sum_2200[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2202, sum_2200[0]})));
  logic and_2206;
  assign and_2206 = (~(and_2194 | (equal_562_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2205;
  // hls/stages/agreement.hpp:788
  logic and_2210;
  assign and_2210 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2190 & and_2206)));
  logic and_2211;
  assign and_2211 = not_568_s2_q & and_2210;
  // hls/stages/patches.hpp:157
  logic and_2213;
  assign and_2213 = and_2211 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_2214;
  assign select_2214 = and_2213 ? and_2211 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2217;
  assign select_2217 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2219;
  assign select_2219 = and_2213 ? (equal_567_s2_q ? 8'h0 : select_2217) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2222;
  assign select_2222 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_2224;
  assign select_2224 = and_2213 ? (equal_567_s2_q ? 6'h0 : select_2222) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2225;
  assign sum_2225 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2185[9]}}, sum_2185[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2228;
  assign select_2228 = ($signed(sum_2225[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2225[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2167 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2225[12:7])) ? 8'h7f : select_2228);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2233;
  assign select_2233 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2235;
  assign select_2235 = and_2213 ? (equal_567_s2_q ? 8'h0 : select_2233) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2236;
  assign equal_2236 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_2240;
  assign and_2240 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2194 | equal_2236)));
  logic and_2241;
  assign and_2241 = not_568_s2_q & and_2240;
  // hls/stages/patches.hpp:348
  logic and_2242;
  assign and_2242 = patches_chooses_s2_q & and_2241;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2256;
  assign select_2256 = row_starts_s2_q ? select_2154 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_2257;
  assign equal_2257 = {patches_choosing_band_s2_q, and_2165} == {select_2256, select_2156[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_2356;
  assign sum_2356 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_2372;
  assign and_2372 = not_2365_s2_q & or_2371_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_2412;
  assign sum_2412 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2437;
  assign select_2437 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2440;
  assign or_2440 = select_2437[7] | (~({select_2437[5], select_2437[3], select_2437[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2443;
  assign or_2443 = select_2437[7] | (~({select_2437[6], select_2437[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2446;
  assign or_2446 = select_2437[7] | (~(select_2437[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2447;
  assign select_2447 = equal_567_s2_q ? x_s2_q[5:0] : {region_row_q, or_2446, or_2443, or_2440};
  // hls/stages/agreement.hpp:1128
  logic not_2448;
  assign not_2448 = ~equal_2074;
  // hls/stages/agreement.hpp:1058
  logic or_2452;
  assign or_2452 = (~sum_2450_s2_q) | equal_2236;
  // hls/stages/agreement.hpp:788
  logic and_2455;
  assign and_2455 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2452));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_572_s2_q & (not_576_s2_q & and_601_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_629;
  // hls/stages/agreement.hpp:149
  logic and_2473;
  assign and_2473 = or_572_s2_q & (not_576_s2_q & and_2471_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2482;
  assign and_2482 = inside_v_s2_q & and_2473;
  // hls/stages/agreement.hpp:1014
  logic select_2483;
  assign select_2483 = slot_s2_q[2] ? shown_shown_q : and_629;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2483);
  // hls/stages/agreement.hpp:1014
  logic select_2486;
  assign select_2486 = slot_s2_q[2] ? shown_nearer_q : and_2052;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2483 ? select_2486 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1275
  logic or_2489;
  assign or_2489 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [16:0] select_2491;
  assign select_2491 = marks_first_s2_q ? 17'h1 : (or_2489 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2493;
  assign select_2493 = or_2489 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2495;
  assign select_2495 = cfg_compete_i ? (or_2489 & select_2491[16]) : (select_2493[8] & select_2491[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2495 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2498;
  assign select_2498 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2500;
  assign select_2500 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2498});
  // hls/stages/agreement.hpp:1301
  logic equal_2501;
  assign equal_2501 = seen_x_q == 3'h7;
  logic [7:0] select_2503;
  assign select_2503 = select_2495 ? 8'h0 : (seen_column_q + {7'h0, equal_2501});
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = select_2500 + {5'h0, select_2503};
  // hls/stages/agreement.hpp:1275
  logic select_2506;
  assign select_2506 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2507;
  assign sum_2507 = {1'b0, select_2506, 2'h0, select_2506, 1'b0, {2{select_2506}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1274
  logic not_2508;
  assign not_2508 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2510;
  assign and_2510 = not_2508 & (began_q | select_2495);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2512;
  assign select_2512 = select_2495 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2514;
  assign and_2514 = and_2510 & (select_2512 == 3'h0);
  logic less_2515;
  assign less_2515 = select_2503 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2518;
  assign sum_2518 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2518[7]}}, sum_2518, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2520;
  assign sum_2520 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2521;
  assign and_2521 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2522;
  assign and_2522 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2523;
  assign and_2523 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2524;
  assign and_2524 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2526;
  assign sum_2526 = {1'b0, and_2523} + ({1'b0, textured} + {1'b0, and_2524});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2521} + ({2'h0, and_2522} + {1'b0, sum_2526});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2535;
  assign select_2535 = inside_v_s2_q ? (sum_2450_s2_q ? select_2437 : {select_2437[6:0], 1'b0}) : select_2437;
  // hls/stages/agreement.hpp:1050
  logic or_2538;
  assign or_2538 = select_2535[7] | (~({select_2535[5], select_2535[3], select_2535[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2555;
  assign and_2555 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2556;
  assign and_2556 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2557;
  assign and_2557 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2558;
  assign and_2558 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2560;
  assign sum_2560 = {1'b0, and_2557} + ({1'b0, shown} + {1'b0, and_2558});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2555} + ({2'h0, and_2556} + {1'b0, sum_2560});
  // hls/stages/agreement.hpp:1030
  logic and_2571;
  assign and_2571 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2572;
  assign and_2572 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2573;
  assign and_2573 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2574;
  assign and_2574 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2576;
  assign sum_2576 = {1'b0, and_2573} + ({1'b0, near} + {1'b0, and_2574});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2571} + ({2'h0, and_2572} + {1'b0, sum_2576});
  // hls/stages/agreement.hpp:788
  logic and_2592;
  assign and_2592 = ends_cell_s2_q & (and_2588_s2_q & (~({sum_2114, last_s2_q[1:0]} < x_s2_q)));
  logic and_2594;
  assign and_2594 = not_568_s2_q & (so_s2_q & and_2592);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2628;
  assign select_2628 = sample_pair_whole_s2_q ? (and_540_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2630;
  assign select_2630 = sample_pair_whole_s2_q ? (and_540_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2650;
  assign select_2650 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2652;
  assign select_2652 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_555 : averager_mask_q) : averager_mask_q;
  logic select_2654;
  assign select_2654 = sample_pair_whole_s2_q ? (and_540_s2_q ? select_559 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2655;
  assign select_2655 = and_542_s2_q ? select_548 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2656;
  assign select_2656 = and_542_s2_q ? select_552 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2658;
  assign select_2658 = and_542_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2659;
  assign select_2659 = and_542_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2660;
  assign select_2660 = and_542_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2661;
  assign select_2661 = and_542_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2662;
  assign select_2662 = and_542_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2663;
  assign select_2663 = and_542_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2664;
  assign select_2664 = and_542_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2665;
  assign select_2665 = and_542_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2666;
  assign select_2666 = and_542_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2667;
  assign select_2667 = and_542_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2668;
  assign select_2668 = and_542_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2669;
  assign select_2669 = and_542_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2670;
  assign select_2670 = and_542_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2671;
  assign select_2671 = and_542_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_542_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2673;
  assign select_2673 = and_542_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_542_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_542_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2676;
  assign select_2676 = and_542_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_542_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_542_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2679;
  assign select_2679 = and_542_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2680;
  assign select_2680 = and_542_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2681;
  assign select_2681 = and_542_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2682;
  assign select_2682 = and_542_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2683;
  assign select_2683 = and_542_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2684;
  assign select_2684 = and_542_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2685;
  assign select_2685 = and_542_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2686;
  assign select_2686 = and_542_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2687;
  assign select_2687 = and_542_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_542_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2689;
  assign select_2689 = and_542_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_542_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_542_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2692;
  assign select_2692 = and_542_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_542_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_542_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2695;
  assign select_2695 = and_542_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2696;
  assign select_2696 = and_542_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2697;
  assign select_2697 = and_542_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2698;
  assign select_2698 = and_542_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2699;
  assign select_2699 = and_542_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2700;
  assign select_2700 = and_542_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2701;
  assign select_2701 = and_542_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2702;
  assign select_2702 = and_542_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2703;
  assign select_2703 = and_542_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2704;
  assign select_2704 = and_542_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2705;
  assign select_2705 = and_542_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2706;
  assign select_2706 = and_542_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2707;
  assign select_2707 = and_542_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2708;
  assign select_2708 = and_542_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2709;
  assign select_2709 = and_542_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2710;
  assign select_2710 = and_542_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2712;
  assign difference_2712 = {1'b0, select_552} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2713;
  assign xor_2713 = difference_2712[8:0] ^ {9{difference_2712[9]}};
  logic [9:0] sum_2714;
  assign sum_2714 = {9'h0, difference_2712[9]} + {1'b0, xor_2713};
  logic [9:0] difference_2715;
  assign difference_2715 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2716;
  assign xor_2716 = difference_2715[8:0] ^ {9{difference_2715[9]}};
  logic [9:0] sum_2717;
  assign sum_2717 = {9'h0, difference_2715[9]} + {1'b0, xor_2716};
  logic [9:0] difference_2719;
  assign difference_2719 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2720;
  assign xor_2720 = difference_2719[8:0] ^ {9{difference_2719[9]}};
  logic [9:0] sum_2721;
  assign sum_2721 = {9'h0, difference_2719[9]} + {1'b0, xor_2720};
  logic [10:0] sum_2722;
  assign sum_2722 = ({1'b0, sum_2714} + {1'b0, sum_2717}) + {1'b0, sum_2721};
  logic [9:0] difference_2723;
  assign difference_2723 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2724;
  assign xor_2724 = difference_2723[8:0] ^ {9{difference_2723[9]}};
  logic [9:0] sum_2725;
  assign sum_2725 = {9'h0, difference_2723[9]} + {1'b0, xor_2724};
  logic [9:0] difference_2727;
  assign difference_2727 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2728;
  assign xor_2728 = difference_2727[8:0] ^ {9{difference_2727[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2749;
  assign sum_2749 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2751;
  assign sum_2751 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2752;
  assign equal_2752 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2753;
  assign select_2753 = equal_2752 ? sum_2749 : moments_before_0_q;
  logic [13:0] select_2755;
  assign select_2755 = equal_2752 ? sum_2751 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2758;
  assign select_2758 = equal_567_s2_q ? (moments_has_before_q | equal_2752) : moments_has_before_q;
  logic [13:0] select_2761;
  assign select_2761 = equal_567_s2_q ? ((select_2755 < select_2753) ? select_2753 : select_2755) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2762;
  assign sum_2762 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2765;
  assign select_2765 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2762)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2766;
  assign sum_2766 = {1'b0, sum_2751} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2769;
  assign select_2769 = equal_567_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2766)) : moments_left_alone_q;
  logic select_2772;
  assign select_2772 = equal_567_s2_q ? (~({3'h0, select_2755[13:2]} < sum_2766)) : moments_left_other_stops_q;
  logic select_2775;
  assign select_2775 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2762)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2776;
  assign sum_2776 = {1'b0, sum_2749} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2779;
  assign select_2779 = equal_567_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2776)) : moments_right_alone_q;
  logic select_2782;
  assign select_2782 = equal_567_s2_q ? (~({3'h0, select_2753[13:2]} < sum_2776)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2785;
  assign or_2785 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2793;
  assign and_2793 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2064)));
  logic and_2797;
  assign and_2797 = not_568_s2_q & (not_570_s2_q & (equal_571_s2_q & (inside_v_s2_q & and_2073)));
  // hls/stages/moments.hpp:94
  logic and_2799;
  assign and_2799 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2802;
  assign select_2802 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2799)) : and_2799;
  // hls/stages/agreement.hpp:788
  logic and_2806;
  assign and_2806 = equal_567_s2_q & (equal_2752 & (cfg_prove_i & (cfg_same_table_i & select_2802)));
  // hls/stages/moments.hpp:95
  logic and_2809;
  assign and_2809 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2823;
  assign difference_2823 = {1'b0, select_548} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2823[9]} + (difference_2823[8:0] ^ {9{difference_2823[9]}});
  logic [9:0] difference_2835;
  assign difference_2835 = {1'b0, select_552} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2835[9]} + (difference_2835[8:0] ^ {9{difference_2835[9]}});
  // hls/stages/agreement.hpp:788
  logic not_3023;
  assign not_3023 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3024;
  assign less_3024 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_3031;
  assign and_3031 = and_542_s2_q & (equal_672_s2_q & equal_2926_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_3037;
  assign and_3037 = not_568_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3033_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3057;
  assign and_3057 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3058;
  assign and_3058 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3059;
  assign and_3059 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3060;
  assign and_3060 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3062;
  assign sum_3062 = {1'b0, and_3059} + ({1'b0, explained} + {1'b0, and_3060});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3057} + ({2'h0, and_3058} + {1'b0, sum_3062});
  // hls/stages/agreement.hpp:788
  logic and_3098;
  assign and_3098 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3033_s2_q & and_2473)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3122;
  assign difference_3122 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3125;
  assign less_3125 = {2'h0, difference_3122[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3128;
  assign and_3128 = not_576_s2_q & (((and_2471_s2_q & and_627) & equal_3118_s2_q) & (~less_3125));
  // hls/stages/agreement.hpp:788
  logic and_3132;
  assign and_3132 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_572_s2_q & and_3128)));
  // hls/stages/agreement.hpp:149
  logic and_3137;
  assign and_3137 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3139;
  assign and_3139 = not_576_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3140;
  assign select_3140 = or_572_s2_q ? {and_3139, and_3137} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3142;
  assign select_3142 = less_575_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3143;
  assign select_3143 = or_572_s2_q ? select_3142 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3145;
  assign and_3145 = and_629 & (select_3140[0] & select_3143[0]);
  // hls/stages/agreement.hpp:788
  logic and_3149;
  assign and_3149 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3140[1] & and_3145)));
  logic and_3150;
  assign and_3150 = not_568_s2_q & and_3149;
  logic and_3156;
  assign and_3156 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3143[1] & and_3145)));
  logic and_3157;
  assign and_3157 = not_568_s2_q & and_3156;
  // hls/stages/registration.hpp:76
  logic less_3160;
  assign less_3160 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3162;
  assign select_3162 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3164;
  assign select_3164 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3166;
  assign select_3166 = or_572_s2_q ? (less_575_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3164} - {1'b0, select_3166};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3168;
  assign select_3168 = rise_2[8] ? select_3164 : select_3166;
  logic [8:0] fall;
  assign fall = {1'b0, select_3162} - {1'b0, select_3168};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3171;
  assign not_3171 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3160 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3171};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3173;
  assign xor_3173 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3173};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3179;
  assign select_3179 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3160 ? {taken, 1'b1} : {not_3171, select_3179, not_3171};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3181;
  assign sum_3181 = {left, 1'b1} + {taken_2, less_3160};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3183;
  assign select_3183 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3185;
  assign select_3185 = equal_567_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3187;
  assign select_3187 = equal_567_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3188;
  assign equal_3188 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3192;
  assign and_3192 = and_629 & less_2166_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3194;
  assign select_3194 = or_572_s2_q ? (less_575_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3198;
  assign sum_3198 = select_3194[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3201;
  assign select_3201 = (select_3164 < select_3166) ? ({sum_3198, select_3194[0], 5'h0} - {3'h0, select_3183}) : {sum_3198, select_3194[0], select_3183};
  logic [7:0] select_3202;
  assign select_3202 = ((select_3194 == 3'h0) | (select_3194 == 3'h4)) ? {sum_3198, select_3194[0], 5'h0} : select_3201;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3202[7]}}, select_3202} - {sum_2185[9], sum_2185, sum_2181[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3205;
  assign select_3205 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3205[11:7])) ? 12'h7f : select_3205;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3226;
  assign difference_3226 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3228;
  assign and_3228 = and_3192 & ($signed(difference_3226) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3241;
  assign less_3241 = $signed(difference_3226) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3249;
  assign select_3249 = so_s2_q ? (equal_3188 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3252;
  assign select_3252 = so_s2_q ? (equal_2167 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3257;
  assign select_3257 = (sum_2080 == 2'h2) ? (registration_fresh_q & (~select_2127)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3259;
  assign select_3259 = so_s2_q ? (and_2122 ? select_3257 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3261;
  assign select_3261 = and_3031 ? 4'hf : (equal_567_s2_q ? registration_fresh_q : select_3259);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2077;
  // hls/stages/registration.hpp:258
  logic not_3282;
  assign not_3282 = ~quarter_2[1];
  logic [3:0] select_3283;
  assign select_3283 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3282, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3282};
  // hls/stages/patches.hpp:91
  logic parity_3417;
  assign parity_3417 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3418;
  assign select_3418 = equal_2926_s2_q ? {patches_chance_q[14:0], parity_3417} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3420;
  assign not_3420 = ~and_2241;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3423;
  assign select_3423 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3423};
  // hls/stages/agreement.hpp:788
  logic and_3429;
  assign and_3429 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3433;
  assign and_3433 = not_3420 & (patches_fixed_q | ((not_568_s2_q & and_3429) & and_2213));
  // hls/stages/patches.hpp:358
  logic not_3445;
  assign not_3445 = ~select_2156[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3447;
  assign select_3447 = sample_pair_whole_s2_q ? (equal_2157 ? select_2156 : {not_3445, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:275
  logic [51:0] select_3546;
  assign select_3546 = or_2249_s2_q ? {and_2394_s2_q, and_2391_s2_q, and_2375_s2_q, and_2372, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3548;
  assign select_3548 = equal_2243_s2_q ? patches_codes_at_q : (equal_2245_s2_q ? other[55:4] : select_3546);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_2348_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3551;
  assign select_3551 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:275
  logic [27:0] select_3553;
  assign select_3553 = equal_2245_s2_q ? (new_row_s2_q ? word : select_3551) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3555;
  assign select_3555 = less_2335_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3557;
  assign select_3557 = less_3556_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:275
  logic [55:0] select_3559;
  assign select_3559 = or_2249_s2_q ? (equal_2248_s2_q ? patches_next_codes_q : select_3557) : patches_next_codes_q;
  logic [55:0] select_3561;
  assign select_3561 = equal_2243_s2_q ? patches_next_codes_q : (equal_2245_s2_q ? select_3555 : select_3559);
  // hls/stages/count_bits.hpp:24
  logic parity_3566;
  assign parity_3566 = ^{and_2394_s2_q, and_2391_s2_q, and_2375_s2_q, and_2372};
  // hls/stages/count_bits.hpp:25
  logic or_3570;
  assign or_3570 = ({and_2375_s2_q, and_2372} == 2'h3) | (and_2391_s2_q & (and_2375_s2_q | and_2372));
  logic and_3571;
  assign and_3571 = and_2394_s2_q & (^{and_2391_s2_q, and_2375_s2_q, and_2372});
  // hls/stages/count_bits.hpp:24
  logic xor_3572;
  assign xor_3572 = or_3570 ^ and_3571;
  // hls/stages/count_bits.hpp:27
  logic and_3573;
  assign and_3573 = or_3570 & and_3571;
  // hls/stages/agreement.hpp:275
  logic [2:0] select_3575;
  assign select_3575 = or_2249_s2_q ? (and_2417_s2_q ? {and_3573, xor_3572, parity_3566} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3579;
  assign sum_3579 = {7'h0, patches_set_q} + (equal_2248_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3589;
  assign select_3589 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:275
  logic [47:0] select_3591;
  assign select_3591 = equal_2243_s2_q ? patches_left_row_q : (equal_2245_s2_q ? select_3589 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3589;
  // hls/stages/count_bits.hpp:24
  logic xor_3595;
  assign xor_3595 = bits[17] ^ (^{select_3589[16:15], other[16:15]});
  logic xor_3598;
  assign xor_3598 = bits[11] ^ (^{select_3589[10:9], other[10:9]});
  logic xor_3601;
  assign xor_3601 = bits[14] ^ (^{select_3589[13:12], other[13:12]});
  logic xor_3604;
  assign xor_3604 = xor_3595 ^ (^{select_3589[14:9], other[14:9]});
  logic xor_3607;
  assign xor_3607 = bits[47] ^ (^{select_3589[46:45], other[46:45]});
  logic xor_3610;
  assign xor_3610 = bits[8] ^ (^{select_3589[7:6], other[7:6]});
  logic xor_3613;
  assign xor_3613 = bits[2] ^ (^{select_3589[1:0], other[1:0]});
  logic xor_3616;
  assign xor_3616 = bits[5] ^ (^{select_3589[4:3], other[4:3]});
  logic xor_3619;
  assign xor_3619 = xor_3610 ^ (^{select_3589[5:0], other[5:0]});
  logic parity_3621;
  assign parity_3621 = ^{select_3589[47:45], select_3589[8:0], other[47:45], other[8:0]};
  logic xor_3622;
  assign xor_3622 = xor_3604 ^ parity_3621;
  logic xor_3625;
  assign xor_3625 = bits[44] ^ (^{select_3589[43:42], other[43:42]});
  logic xor_3628;
  assign xor_3628 = bits[38] ^ (^{select_3589[37:36], other[37:36]});
  logic xor_3631;
  assign xor_3631 = bits[41] ^ (^{select_3589[40:39], other[40:39]});
  logic xor_3637;
  assign xor_3637 = bits[26] ^ (^{select_3589[25:24], other[25:24]});
  logic xor_3640;
  assign xor_3640 = bits[20] ^ (^{select_3589[19:18], other[19:18]});
  logic xor_3643;
  assign xor_3643 = bits[23] ^ (^{select_3589[22:21], other[22:21]});
  logic xor_3646;
  assign xor_3646 = xor_3637 ^ (^{select_3589[23:18], other[23:18]});
  logic xor_3649;
  assign xor_3649 = bits[35] ^ (^{select_3589[34:33], other[34:33]});
  logic xor_3652;
  assign xor_3652 = bits[29] ^ (^{select_3589[28:27], other[28:27]});
  logic xor_3655;
  assign xor_3655 = bits[32] ^ (^{select_3589[31:30], other[31:30]});
  logic xor_3658;
  assign xor_3658 = xor_3649 ^ (^{select_3589[32:27], other[32:27]});
  logic xor_3659;
  assign xor_3659 = xor_3646 ^ xor_3658;
  // hls/stages/count_bits.hpp:25
  logic or_3667;
  assign or_3667 = (xor_3598 & xor_3601) | (xor_3595 & (xor_3598 | xor_3601));
  logic or_3671;
  assign or_3671 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3675;
  assign or_3675 = (xor_3613 & xor_3616) | (xor_3610 & (xor_3613 | xor_3616));
  // hls/stages/count_bits.hpp:23
  logic or_3682;
  assign or_3682 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3686;
  assign or_3686 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3690;
  assign or_3690 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3693;
  assign parity_3693 = ^{or_3690, or_3686, or_3682};
  // hls/stages/count_bits.hpp:23
  logic or_3697;
  assign or_3697 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3701;
  assign or_3701 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3705;
  assign or_3705 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3708;
  assign parity_3708 = ^{or_3705, or_3701, or_3697};
  logic parity_3711;
  assign parity_3711 = ^{or_3705, or_3701, or_3697, or_3690, or_3686, or_3682, or_3675, or_3671, or_3667};
  // hls/stages/count_bits.hpp:23
  logic or_3715;
  assign or_3715 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3719;
  assign or_3719 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3723;
  assign or_3723 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3731;
  assign or_3731 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3735;
  assign or_3735 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3739;
  assign or_3739 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3742;
  assign parity_3742 = ^{or_3739, or_3735, or_3731};
  // hls/stages/count_bits.hpp:23
  logic or_3746;
  assign or_3746 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3750;
  assign or_3750 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3754;
  assign or_3754 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3757;
  assign parity_3757 = ^{or_3754, or_3750, or_3746};
  logic parity_3760;
  assign parity_3760 = ^{or_3754, or_3750, or_3746, or_3739, or_3735, or_3731, or_3723, or_3719, or_3715};
  // hls/stages/count_bits.hpp:25
  logic or_3764;
  assign or_3764 = (xor_3628 & xor_3631) | (xor_3625 & (xor_3628 | xor_3631));
  logic or_3768;
  assign or_3768 = (xor_3640 & xor_3643) | (xor_3637 & (xor_3640 | xor_3643));
  logic or_3772;
  assign or_3772 = (xor_3652 & xor_3655) | (xor_3649 & (xor_3652 | xor_3655));
  // hls/stages/count_bits.hpp:24
  logic parity_3775;
  assign parity_3775 = ^{or_3772, or_3768, or_3764};
  // hls/stages/count_bits.hpp:25
  logic and_3776;
  assign and_3776 = xor_3622 & (^{xor_3659, select_3589[44:36], other[44:36]});
  logic or_3780;
  assign or_3780 = (xor_3607 & xor_3619) | (xor_3604 & (xor_3607 | xor_3619));
  logic and_3783;
  assign and_3783 = (xor_3625 ^ (^{select_3589[41:36], other[41:36]})) & (xor_3646 | xor_3658);
  logic or_3784;
  assign or_3784 = (xor_3646 & xor_3658) | and_3783;
  // hls/stages/count_bits.hpp:24
  logic parity_3787;
  assign parity_3787 = ^{or_3784, or_3780, and_3776};
  logic parity_3790;
  assign parity_3790 = ^{or_3784, or_3780, and_3776, or_3772, or_3768, or_3764, or_3754, or_3750, or_3746, or_3739, or_3735, or_3731, or_3723, or_3719, or_3715};
  logic parity_3792;
  assign parity_3792 = ^{or_3784, or_3780, and_3776, or_3772, or_3768, or_3764, or_3754, or_3750, or_3746, or_3739, or_3735, or_3731, or_3723, or_3719, or_3715, or_3705, or_3701, or_3697, or_3690, or_3686, or_3682, or_3675, or_3671, or_3667};
  // hls/stages/count_bits.hpp:25
  logic and_3793;
  assign and_3793 = parity_3711 & parity_3790;
  logic or_3797;
  assign or_3797 = (parity_3693 & parity_3708) | ((^{or_3675, or_3671, or_3667}) & (parity_3693 | parity_3708));
  logic or_3801;
  assign or_3801 = (parity_3775 & parity_3787) | (parity_3760 & (parity_3775 | parity_3787));
  logic or_3808;
  assign or_3808 = (parity_3742 & parity_3757) | ((^{or_3723, or_3719, or_3715}) & (parity_3742 | parity_3757));
  logic or_3812;
  assign or_3812 = (or_3768 & or_3772) | (or_3764 & (or_3768 | or_3772));
  logic or_3816;
  assign or_3816 = (or_3780 & or_3784) | (and_3776 & (or_3780 | or_3784));
  // hls/stages/count_bits.hpp:23
  logic or_3823;
  assign or_3823 = (or_3719 & or_3723) | (or_3715 & (or_3719 | or_3723));
  // hls/stages/count_bits.hpp:25
  logic or_3827;
  assign or_3827 = (or_3735 & or_3739) | (or_3731 & (or_3735 | or_3739));
  logic or_3831;
  assign or_3831 = (or_3750 & or_3754) | (or_3746 & (or_3750 | or_3754));
  // hls/stages/count_bits.hpp:24
  logic parity_3834;
  assign parity_3834 = ^{or_3831, or_3827, or_3823};
  // hls/stages/count_bits.hpp:23
  logic or_3838;
  assign or_3838 = (or_3671 & or_3675) | (or_3667 & (or_3671 | or_3675));
  // hls/stages/count_bits.hpp:25
  logic or_3842;
  assign or_3842 = (or_3686 & or_3690) | (or_3682 & (or_3686 | or_3690));
  logic or_3846;
  assign or_3846 = (or_3701 & or_3705) | (or_3697 & (or_3701 | or_3705));
  // hls/stages/count_bits.hpp:24
  logic parity_3849;
  assign parity_3849 = ^{or_3846, or_3842, or_3838};
  logic parity_3852;
  assign parity_3852 = ^{or_3846, or_3842, or_3838, or_3831, or_3827, or_3823, or_3816, or_3812, or_3808};
  logic parity_3854;
  assign parity_3854 = ^{or_3846, or_3842, or_3838, or_3831, or_3827, or_3823, or_3816, or_3812, or_3808, or_3801, or_3797, and_3793};
  // hls/stages/count_bits.hpp:25
  logic or_3858;
  assign or_3858 = (or_3812 & or_3816) | (or_3808 & (or_3812 | or_3816));
  logic or_3862;
  assign or_3862 = (or_3827 & or_3831) | (or_3823 & (or_3827 | or_3831));
  logic or_3866;
  assign or_3866 = (or_3842 & or_3846) | (or_3838 & (or_3842 | or_3846));
  // hls/stages/count_bits.hpp:24
  logic parity_3869;
  assign parity_3869 = ^{or_3866, or_3862, or_3858};
  // hls/stages/count_bits.hpp:25
  logic and_3870;
  assign and_3870 = (^{or_3801, or_3797, and_3793}) & parity_3852;
  logic or_3874;
  assign or_3874 = (or_3797 & or_3801) | (and_3793 & (or_3797 | or_3801));
  logic or_3878;
  assign or_3878 = (parity_3834 & parity_3849) | ((^{or_3816, or_3812, or_3808}) & (parity_3834 | parity_3849));
  // hls/stages/count_bits.hpp:24
  logic parity_3881;
  assign parity_3881 = ^{or_3878, or_3874, and_3870};
  // hls/stages/count_bits.hpp:25
  logic and_3883;
  assign and_3883 = parity_3869 & parity_3881;
  logic or_3887;
  assign or_3887 = (or_3862 & or_3866) | (or_3858 & (or_3862 | or_3866));
  logic or_3891;
  assign or_3891 = (or_3874 & or_3878) | (and_3870 & (or_3874 | or_3878));
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3936;
  assign select_3936 = equal_2245_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3939;
  assign select_3939 = equal_2243_s2_q ? patches_summed_first_q : (equal_2245_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3947;
  assign select_3947 = less_2423_s2_q ? (or_2426_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3950;
  assign select_3950 = less_2423_s2_q ? (or_2426_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3953;
  assign select_3953 = less_2423_s2_q ? (or_2426_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:275
  logic select_3958;
  assign select_3958 = equal_2243_s2_q ? (less_2423_s2_q & (or_2426_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3963;
  assign or_3963 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3964;
  assign and_3964 = patches_read_searches_s2_q & or_3963;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3965;
  assign select_3965 = and_3964 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3965};
  // hls/stages/patches.hpp:559
  logic and_3970;
  assign and_3970 = less_2423_s2_q & (or_2426_s2_q & (equal_2424_s2_q & (away == 6'h3f)));
  logic and_3975;
  assign and_3975 = less_2423_s2_q & (or_2426_s2_q & (equal_2424_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3977;
  assign sum_3977 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3980;
  assign select_3980 = (equal_2424_s2_q & ({sum_3977[6], sum_3977} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3982;
  assign select_3982 = less_2423_s2_q ? (or_2426_s2_q ? select_3980 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3984;
  assign select_3984 = and_3964 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3985;
  assign select_3985 = equal_2243_s2_q ? select_3984[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3986;
  assign select_3986 = equal_2243_s2_q ? select_3984[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3988;
  assign select_3988 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3989;
  assign select_3989 = equal_2243_s2_q ? select_3988 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3990;
  assign select_3990 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3991;
  assign select_3991 = equal_2243_s2_q ? select_3990 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3993;
  assign select_3993 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3995;
  assign select_3995 = equal_2243_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3993) : patches_peak_far_q;
  logic [9:0] select_3998;
  assign select_3998 = equal_2243_s2_q ? (equal_3996_s2_q ? sum_3579 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:788
  logic select_4249;
  assign select_4249 = equal_567_s2_q ? shown_shown_q : (so_s2_q ? select_2483 : shown_shown_q);
  logic select_4251;
  assign select_4251 = equal_567_s2_q ? shown_nearer_q : (so_s2_q ? select_2486 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4253;
  assign sum_4253 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4255;
  assign select_4255 = less_4252_s2_q ? (sum_4253[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4257;
  assign select_4257 = equal_2926_s2_q ? (equal_672_s2_q ? 3'h0 : select_4255) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4262;
  assign select_4262 = equal_567_s2_q ? select_2437 : (so_s2_q ? (ends_cell_s2_q ? select_2535 : select_2437) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4276;
  assign select_4276 = equal_672_s2_q ? {{2{difference_4274[6]}}, difference_4274} : (less_4252_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4278;
  assign select_4278 = and_542_s2_q ? (equal_2926_s2_q ? select_4276 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4280;
  assign select_4280 = equal_672_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4282;
  assign select_4282 = and_542_s2_q ? (equal_2926_s2_q ? select_4280 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4283;
  assign sum_4283 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4284;
  assign select_4284 = sum_4253[7] ? {1'b1, sum_4253[6:0], region_down_rest_q[0]} : sum_4283;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4253[7];
  // hls/stages/agreement.hpp:460
  logic select_4288;
  assign select_4288 = equal_2926_s2_q ? (equal_672_s2_q | (less_4252_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4293;
  assign or_4293 = segment_starts_q | not_570_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4296;
  assign select_4296 = inside_v_s2_q ? (sum_2450_s2_q ? (equal_2236 & or_2452) : or_2452) : or_4293;
  // hls/stages/agreement.hpp:788
  logic select_4299;
  assign select_4299 = equal_567_s2_q ? or_4293 : (so_s2_q ? (ends_cell_s2_q ? select_4296 : or_4293) : or_4293);
  // hls/stages/agreement.hpp:1147
  logic equal_4323;
  assign equal_4323 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4459;
  assign select_4459 = so_s2_q ? (ends_cell_s2_q ? and_2523 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4462;
  assign select_4462 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4464;
  assign select_4464 = equal_567_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4462 : centres_values_0_of_skin_q);
  logic select_4465;
  assign select_4465 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4467;
  assign select_4467 = equal_567_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4465 : centres_values_1_textured_q);
  logic select_4468;
  assign select_4468 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4470;
  assign select_4470 = equal_567_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4468 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4474;
  assign select_4474 = equal_2926_s2_q ? (equal_4471_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4477;
  assign select_4477 = and_542_s2_q ? (equal_2926_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4488;
  assign select_4488 = select_2495 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4494;
  assign select_4494 = marks_first_s2_q ? (less_4490 ? {sum_4491, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4564;
  assign not_4564 = ~quarter[1];
  logic [3:0] select_4565;
  assign select_4565 = quarter[0] ? {quarter[1], 1'b0, not_4564, 1'b0} : {1'b0, quarter[1], 1'b0, not_4564};

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

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:777; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2155;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2157));
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
  assign regions_raddr = select_2447;
  logic regions_re;
  assign regions_re = s2_en & (equal_567_s2_q ? (x_s2_q[6] & not_2448) : and_2455);
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
  assign map_raddr = {sum_2507, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2514 & less_2515);
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
  assign averager_memory_waddr = select_507_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_516_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_535, and_531, sum_527, sum_523};
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
  assign patches_right_codes_waddr = {sum_2356, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2408_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2394_s2_q, and_2391_s2_q, and_2375_s2_q, and_2372, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2412, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2422_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2394_s2_q, and_2391_s2_q, and_2375_s2_q, and_2372, patches_codes_at_q[51:8]};
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
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2482, textured};
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
      patches_peak_size_q <= 10'h0;
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
      averager_running_of_skin_q <= select_2650;
      averager_mask_q <= select_2652;
      averager_of_skin_q <= select_2654;
      census_filled_q <= and_542_s2_q ? {select_675[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2749;
      moments_turned_1_q <= sum_2751;
      moments_before_0_q <= equal_567_s2_q ? select_2753 : moments_before_0_q;
      moments_before_1_q <= equal_567_s2_q ? select_2755 : moments_before_1_q;
      moments_has_before_q <= select_2758;
      moments_most_before_q <= select_2761;
      moments_left_begins_q <= select_2765;
      moments_left_alone_q <= select_2769;
      moments_left_other_stops_q <= select_2772;
      moments_right_begins_q <= select_2775;
      moments_right_alone_q <= select_2779;
      moments_right_other_stops_q <= select_2782;
      moments_out_of_step_q <= or_2785;
      moments_turns_0_q <= and_2793;
      moments_turns_1_q <= and_2797;
      moments_begins_alone_q <= and_2806;
      moments_ends_q <= equal_567_s2_q & (equal_2752 & (not_2807 | and_2809));
      rows_passed_above_q <= and_542_s2_q ? select_674 : rows_passed_above_q;
      shift_allowed_q <= not_3023 & (~less_3024);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3031 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3150});
      counts_turned_right_q <= and_3031 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3157});
      registration_displacement_over_q <= so_s2_q ? sum_3181[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3183;
      registration_slope_here_q <= select_3185;
      registration_expected_q <= select_3187;
      registration_of_right_q <= equal_567_s2_q ? registration_of_right_q : select_3249;
      registration_was_inside_q <= equal_567_s2_q ? registration_was_inside_q : select_3252;
      registration_fresh_q <= select_3261;
      patches_chance_q <= and_542_s2_q ? select_3418 : patches_chance_q;
      patches_fixed_q <= and_3433;
      patches_choice_valid_q <= and_2241 ? (select_2214 & not_3420) : select_2214;
      patches_choice_column_q <= select_2219;
      patches_choice_shift_q <= select_2224;
      patches_choice_slope_q <= select_2235;
      patches_band_q <= sample_pair_whole_s2_q ? select_2256 : patches_band_q;
      patches_fetch_q <= select_3447;
      patches_codes_at_q <= select_3548;
      patches_codes_further_q <= equal_2243_s2_q ? patches_codes_further_q : select_3553;
      patches_next_codes_q <= select_3561;
      patches_set_q <= equal_2243_s2_q ? 3'h0 : (equal_2245_s2_q ? 3'h0 : select_3575);
      patches_size_q <= sum_3579;
      patches_left_row_q <= select_3591;
      patches_summed_row_column_q <= equal_2243_s2_q ? patches_summed_row_column_q : select_3936;
      patches_summed_first_q <= select_3939;
      patches_read_row_differing_q <= equal_2243_s2_q ? select_3947 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2243_s2_q ? select_3950 : patches_read_row_column_q;
      patches_read_at_q <= equal_2243_s2_q ? select_3953 : patches_read_at_q;
      patches_read_first_q <= select_3958;
      patches_read_above_q <= equal_2243_s2_q ? and_3970 : patches_read_above_q;
      patches_read_below_q <= equal_2243_s2_q ? and_3975 : patches_read_below_q;
      patches_read_far_q <= equal_2243_s2_q ? select_3982 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3985;
      patches_peak_best_column_q <= select_3986;
      patches_peak_row_q <= equal_2243_s2_q ? select_3965 : patches_peak_row_q;
      patches_peak_above_q <= select_3989;
      patches_peak_below_q <= select_3991;
      patches_peak_far_q <= select_3995;
      patches_peak_size_q <= select_3998;
      patches_frame_ended_q <= equal_567_s2_q & equal_2752;
      shown_shown_q <= select_4249;
      shown_nearer_q <= select_4251;
      region_row_q <= and_542_s2_q ? select_4257 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4262;
      region_down_rest_q <= select_4278;
      region_down_back_q <= select_4282;
      region_down_next_q <= select_4284;
      region_fresh_q <= and_542_s2_q ? select_4288 : region_fresh_q;
      segment_starts_q <= select_4299;
      centres_values_0_textured_q <= equal_567_s2_q ? centres_values_0_textured_q : select_4459;
      centres_values_0_of_skin_q <= select_4464;
      centres_values_1_textured_q <= select_4467;
      centres_values_1_of_skin_q <= select_4470;
      map_row_q <= and_542_s2_q ? select_4474 : map_row_q;
      map_width_q <= select_4477;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2506;
      done_q <= not_2508 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_567_s2_q & equal_4323;
      rows_passed_q <= select_2491;
      columns_passed_q <= {select_2493[7:0], or_2489};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2510;
      seen_x_q <= select_2512;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4488;
      seen_column_q <= select_2503;
      seen_rows_left_q <= select_4494;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2500;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_519 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_525 : averager_running_1_q;
      averager_total_0_q <= select_2628;
      averager_total_1_q <= select_2630;
      census_columns_values_0_cell_0_left_q <= select_2655;
      census_columns_values_0_cell_0_right_q <= select_2656;
      census_columns_values_0_cell_0_mask_q <= and_542_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2658;
      census_columns_values_0_cell_1_right_q <= select_2659;
      census_columns_values_0_cell_1_mask_q <= select_2660;
      census_columns_values_0_cell_2_left_q <= select_2661;
      census_columns_values_0_cell_2_right_q <= select_2662;
      census_columns_values_0_cell_2_mask_q <= select_2663;
      census_columns_values_0_cell_2_of_skin_q <= select_2664;
      census_columns_values_0_cell_3_left_q <= select_2665;
      census_columns_values_0_cell_3_right_q <= select_2666;
      census_columns_values_0_cell_3_mask_q <= select_2667;
      census_columns_values_0_cell_4_left_q <= select_2668;
      census_columns_values_0_cell_4_right_q <= select_2669;
      census_columns_values_0_cell_4_mask_q <= select_2670;
      census_columns_values_1_cell_0_left_q <= select_2671;
      census_columns_values_1_cell_0_right_q <= select_2672;
      census_columns_values_1_cell_0_mask_q <= select_2673;
      census_columns_values_1_cell_1_left_q <= select_2674;
      census_columns_values_1_cell_1_right_q <= select_2675;
      census_columns_values_1_cell_1_mask_q <= select_2676;
      census_columns_values_1_cell_2_left_q <= select_2677;
      census_columns_values_1_cell_2_right_q <= select_2678;
      census_columns_values_1_cell_2_mask_q <= select_2679;
      census_columns_values_1_cell_2_of_skin_q <= select_2680;
      census_columns_values_1_cell_3_left_q <= select_2681;
      census_columns_values_1_cell_3_right_q <= select_2682;
      census_columns_values_1_cell_3_mask_q <= select_2683;
      census_columns_values_1_cell_4_left_q <= select_2684;
      census_columns_values_1_cell_4_right_q <= select_2685;
      census_columns_values_1_cell_4_mask_q <= select_2686;
      census_columns_values_2_cell_0_left_q <= select_2687;
      census_columns_values_2_cell_0_right_q <= select_2688;
      census_columns_values_2_cell_0_mask_q <= select_2689;
      census_columns_values_2_cell_1_left_q <= select_2690;
      census_columns_values_2_cell_1_right_q <= select_2691;
      census_columns_values_2_cell_1_mask_q <= select_2692;
      census_columns_values_2_cell_2_left_q <= select_2693;
      census_columns_values_2_cell_2_right_q <= select_2694;
      census_columns_values_2_cell_2_mask_q <= select_2695;
      census_columns_values_2_cell_3_left_q <= select_2696;
      census_columns_values_2_cell_3_right_q <= select_2697;
      census_columns_values_2_cell_3_mask_q <= select_2698;
      census_columns_values_2_cell_4_left_q <= select_2699;
      census_columns_values_2_cell_4_right_q <= select_2700;
      census_columns_values_2_cell_4_mask_q <= select_2701;
      census_columns_values_3_cell_0_mask_q <= select_2702;
      census_columns_values_3_cell_1_left_q <= select_2703;
      census_columns_values_3_cell_1_right_q <= select_2704;
      census_columns_values_3_cell_1_mask_q <= select_2705;
      census_columns_values_3_cell_2_mask_q <= select_2706;
      census_columns_values_3_cell_3_left_q <= select_2707;
      census_columns_values_3_cell_3_right_q <= select_2708;
      census_columns_values_3_cell_3_mask_q <= select_2709;
      census_columns_values_3_cell_4_mask_q <= select_2710;
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
  logic [2:0] select_503_s3_q;
  logic row_starts_s3_q;
  logic [6:0] select_536_s3_q;
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
  logic select_2156_s3_q;
  logic equal_2157_s3_q;
  logic and_2165_s3_q;
  logic equal_2167_s3_q;
  logic select_2214_s3_q;
  logic and_2242_s3_q;
  logic equal_2243_s3_q;
  logic equal_2245_s3_q;
  logic not_2250_s3_q;
  logic and_2258_s3_q;
  logic [4:0] select_2273_s3_q;
  logic select_2279_s3_q;
  logic [3:0] select_2319_s3_q;
  logic or_2440_s3_q;
  logic or_2443_s3_q;
  logic or_2446_s3_q;
  logic not_2448_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2475_s3_q;
  logic and_2480_s3_q;
  logic and_2514_s3_q;
  logic less_2515_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2520_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2538_s3_q;
  logic or_2541_s3_q;
  logic or_2544_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2594_s3_q;
  logic [11:0] sum_2726_s3_q;
  logic [9:0] sum_2729_s3_q;
  logic equal_2737_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3031_s3_q;
  logic and_3037_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3099_s3_q;
  logic and_3133_s3_q;
  logic and_3191_s3_q;
  logic and_3192_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3228_s3_q;
  logic and_3242_s3_q;
  logic equal_3285_s3_q;
  logic parity_3663_s3_q;
  logic parity_3792_s3_q;
  logic parity_3854_s3_q;
  logic xor_3882_s3_q;
  logic parity_3894_s3_q;
  logic or_3898_s3_q;
  logic equal_3899_s3_q;
  logic and_3999_s3_q;
  logic less_4024_s3_q;
  logic equal_4323_s3_q;
  logic and_4500_s3_q;
  logic not_4514_s3_q;
  logic equal_4567_s3_q;
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
      select_503_s3_q <= select_503_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_536_s3_q <= select_536_s2_q;
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
      select_2156_s3_q <= select_2156[1];
      equal_2157_s3_q <= equal_2157;
      and_2165_s3_q <= and_2165;
      equal_2167_s3_q <= equal_2167;
      select_2214_s3_q <= select_2214;
      and_2242_s3_q <= and_2242;
      equal_2243_s3_q <= equal_2243_s2_q;
      equal_2245_s3_q <= equal_2245_s2_q;
      not_2250_s3_q <= not_2250_s2_q;
      and_2258_s3_q <= and_2242 & equal_2257;
      select_2273_s3_q <= select_2273_s2_q;
      select_2279_s3_q <= select_2279_s2_q;
      select_2319_s3_q <= select_2319_s2_q;
      or_2440_s3_q <= or_2440;
      or_2443_s3_q <= or_2443;
      or_2446_s3_q <= or_2446;
      not_2448_s3_q <= not_2448;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2475_s3_q <= inside_v_s2_q & (and_2473 & and_2052);
      and_2480_s3_q <= not_568_s2_q & and_2455;
      and_2514_s3_q <= and_2514;
      less_2515_s3_q <= less_2515;
      index_2_s3_q <= index_2[5:0];
      sum_2520_s3_q <= sum_2520;
      textured_2_s3_q <= textured_2;
      or_2538_s3_q <= or_2538;
      or_2541_s3_q <= select_2535[7] | (~({select_2535[6], select_2535[3:2]} == 3'h0));
      or_2544_s3_q <= select_2535[7] | (~(select_2535[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2594_s3_q <= and_2594;
      sum_2726_s3_q <= {1'b0, sum_2722} + {2'h0, sum_2725};
      sum_2729_s3_q <= {9'h0, difference_2727[9]} + {1'b0, xor_2728};
      equal_2737_s3_q <= equal_2737_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3031_s3_q <= and_3031;
      and_3037_s3_q <= and_3037;
      explained_2_s3_q <= explained_2;
      and_3099_s3_q <= not_568_s2_q & and_3098;
      and_3133_s3_q <= not_568_s2_q & and_3132;
      and_3191_s3_q <= not_568_s2_q & (so_s2_q & (half_ends & equal_3188));
      and_3192_s3_q <= and_3192;
      residual_s3_q <= residual[7:0];
      and_3228_s3_q <= and_3228;
      and_3242_s3_q <= and_3192 & less_3241;
      equal_3285_s3_q <= (registration_fresh_q & select_3283) == 4'h0;
      parity_3663_s3_q <= ^{xor_3659, xor_3622, select_3589[44:36], other[44:36]};
      parity_3792_s3_q <= parity_3792;
      parity_3854_s3_q <= parity_3854;
      xor_3882_s3_q <= parity_3869 ^ parity_3881;
      parity_3894_s3_q <= ^{or_3891, or_3887, and_3883};
      or_3898_s3_q <= (or_3887 & or_3891) | (and_3883 & (or_3887 | or_3891));
      equal_3899_s3_q <= equal_3899_s2_q;
      and_3999_s3_q <= equal_2243_s2_q & equal_3996_s2_q;
      less_4024_s3_q <= select_3989 < select_3991;
      equal_4323_s3_q <= equal_4323;
      and_4500_s3_q <= and_2594 & ({sum_2520, index_2[5:0]} == {sum_2507, index[5:0]});
      not_4514_s3_q <= ~proven_q;
      equal_4567_s3_q <= (registration_fresh_q & select_4565) == 4'h0;
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
  logic [4:0] patches_on_skin_limit_q;
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
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_717_s3_q + {2'h0, sum_720_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_722;
  assign sum_722 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_724;
  assign sum_724 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_722});
  // hls/stages/census.hpp:317
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
  // hls/stages/patches.hpp:357
  logic [22:0] select_2259;
  assign select_2259 = and_2258_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2214_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2261;
  assign select_2261 = equal_2157_s3_q ? patches_place_0_valid_q : (select_2156_s3_q ? patches_place_0_valid_q : select_2259[0]);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2262;
  assign sum_2262 = {1'b0, select_536_s3_q, select_503_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_2263;
  assign select_2263 = select_2156_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2259[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2264;
  assign select_2264 = equal_2157_s3_q ? patches_place_0_column_q : select_2263[7:0];
  logic [5:0] select_2265;
  assign select_2265 = equal_2157_s3_q ? patches_place_0_shift_q : select_2263[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2266;
  assign sum_2266 = {1'b0, select_2264} + {{3{select_2265[5]}}, select_2265};
  // hls/stages/patches.hpp:132
  logic equal_2267;
  assign equal_2267 = {sum_2266, sum_2262[0], select_503_s3_q[1:0]} == {1'b0, sum_2262[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2269;
  assign or_2269 = row_starts_s3_q | (select_2261 & equal_2267);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2270;
  assign select_2270 = or_2269 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2280;
  assign select_2280 = or_2269 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2282;
  assign and_2282 = select_2279_s3_q & (~select_2280[5]);
  // hls/stages/patches.hpp:127
  logic select_2290;
  assign select_2290 = equal_2157_s3_q ? patches_place_1_valid_q : (select_2156_s3_q ? select_2259[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_2291;
  assign select_2291 = select_2156_s3_q ? select_2259[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2292;
  assign select_2292 = equal_2157_s3_q ? patches_place_1_column_q : select_2291[7:0];
  logic [5:0] select_2293;
  assign select_2293 = equal_2157_s3_q ? patches_place_1_shift_q : select_2291[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2294;
  assign sum_2294 = {1'b0, select_2292} + {{3{select_2293[5]}}, select_2293};
  // hls/stages/patches.hpp:132
  logic equal_2295;
  assign equal_2295 = {sum_2294[8], sum_2262, select_503_s3_q[1:0]} == {1'b0, sum_2294[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2297;
  assign or_2297 = row_starts_s3_q | (select_2290 & equal_2295);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2298;
  assign select_2298 = or_2297 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2299;
  assign select_2299 = or_2297 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2301;
  assign and_2301 = select_2279_s3_q & (~select_2299[5]);
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2308;
  assign sum_2308 = select_2264 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2309;
  assign equal_2309 = {sum_2308[7], select_536_s3_q, select_503_s3_q} == {1'b0, sum_2308[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2311;
  assign or_2311 = row_starts_s3_q | (select_2261 & equal_2309);
  logic [4:0] select_2312;
  assign select_2312 = or_2311 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2313;
  assign sum_2313 = select_2292 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2314;
  assign equal_2314 = {sum_2313[7], select_536_s3_q, select_503_s3_q} == {1'b0, sum_2313[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2317;
  assign select_2317 = (row_starts_s3_q | (select_2290 & equal_2314)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2312[4] ? select_2317[3:0] : select_2312[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2320;
  assign select_2320 = or_2311 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2326;
  assign and_2326 = (select_2279_s3_q & (select_2273_s3_q[3] ^ select_2273_s3_q[4])) & ((~select_2312[4]) | (~select_2317[4]));
  // hls/stages/patches.hpp:186
  logic less_2430;
  assign less_2430 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_2431;
  assign not_2431 = ~less_2430;
  logic [1:0] select_2432;
  assign select_2432 = patches_summed_first_s3_q ? 2'h2 : {less_2430, not_2431};
  logic [12:0] select_2434;
  assign select_2434 = select_2432[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2435;
  assign select_2435 = select_2432[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2436;
  assign select_2436 = (select_2432 == 2'h2) ? {select_2434[12:8], patches_sums_values_0_q[9:8], select_2434[7:0]} : select_2435;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2461;
  assign select_2461 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2462;
  assign sum_2462 = {6'h0, textured_s3_q} + select_2461;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2464;
  assign sum_2464 = {3'h0, sum_2462} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2466;
  assign select_2466 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2467;
  assign sum_2467 = {6'h0, explained_s3_q} + select_2466;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2469;
  assign sum_2469 = {3'h0, sum_2467} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2476;
  assign select_2476 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2477;
  assign sum_2477 = {6'h0, and_2475_s3_q} + select_2476;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2479;
  assign sum_2479 = {3'h0, sum_2477} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2529;
  assign select_2529 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2530;
  assign difference_2530 = {1'b0, textured_2_s3_q} - {1'b0, select_2529};
  logic [4:0] t;
  assign t = {difference_2530[3], difference_2530} + (equal_562_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2533;
  assign equal_2533 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2545;
  assign not_2545 = ~region_row_s3_q[2];
  logic [2:0] select_2546;
  assign select_2546 = region_row_s3_q[1] ? {1'b0, not_2545, 1'b0} : {region_row_s3_q[2], 1'b0, not_2545};
  logic [5:0] select_2547;
  assign select_2547 = region_row_s3_q[0] ? {select_2546[2], 1'b0, select_2546[1], 1'b0, select_2546[0], 1'b0} : {1'b0, select_2546[2], 1'b0, select_2546[1], 1'b0, select_2546[0]};
  logic [11:0] select_2548;
  assign select_2548 = or_2544_s3_q ? {select_2547[5], 1'b0, select_2547[4], 1'b0, select_2547[3], 1'b0, select_2547[2], 1'b0, select_2547[1], 1'b0, select_2547[0], 1'b0} : {1'b0, select_2547[5], 1'b0, select_2547[4], 1'b0, select_2547[3], 1'b0, select_2547[2], 1'b0, select_2547[1], 1'b0, select_2547[0]};
  logic [23:0] select_2549;
  assign select_2549 = or_2541_s3_q ? {select_2548[11], 1'b0, select_2548[10], 1'b0, select_2548[9], 1'b0, select_2548[8], 1'b0, select_2548[7], 1'b0, select_2548[6], 1'b0, select_2548[5], 1'b0, select_2548[4], 1'b0, select_2548[3], 1'b0, select_2548[2], 1'b0, select_2548[1], 1'b0, select_2548[0], 1'b0} : {1'b0, select_2548[11], 1'b0, select_2548[10], 1'b0, select_2548[9], 1'b0, select_2548[8], 1'b0, select_2548[7], 1'b0, select_2548[6], 1'b0, select_2548[5], 1'b0, select_2548[4], 1'b0, select_2548[3], 1'b0, select_2548[2], 1'b0, select_2548[1], 1'b0, select_2548[0]};
  logic [47:0] select_2550;
  assign select_2550 = or_2538_s3_q ? {select_2549[23], 1'b0, select_2549[22], 1'b0, select_2549[21], 1'b0, select_2549[20], 1'b0, select_2549[19], 1'b0, select_2549[18], 1'b0, select_2549[17], 1'b0, select_2549[16], 1'b0, select_2549[15], 1'b0, select_2549[14], 1'b0, select_2549[13], 1'b0, select_2549[12], 1'b0, select_2549[11], 1'b0, select_2549[10], 1'b0, select_2549[9], 1'b0, select_2549[8], 1'b0, select_2549[7], 1'b0, select_2549[6], 1'b0, select_2549[5], 1'b0, select_2549[4], 1'b0, select_2549[3], 1'b0, select_2549[2], 1'b0, select_2549[1], 1'b0, select_2549[0], 1'b0} : {1'b0, select_2549[23], 1'b0, select_2549[22], 1'b0, select_2549[21], 1'b0, select_2549[20], 1'b0, select_2549[19], 1'b0, select_2549[18], 1'b0, select_2549[17], 1'b0, select_2549[16], 1'b0, select_2549[15], 1'b0, select_2549[14], 1'b0, select_2549[13], 1'b0, select_2549[12], 1'b0, select_2549[11], 1'b0, select_2549[10], 1'b0, select_2549[9], 1'b0, select_2549[8], 1'b0, select_2549[7], 1'b0, select_2549[6], 1'b0, select_2549[5], 1'b0, select_2549[4], 1'b0, select_2549[3], 1'b0, select_2549[2], 1'b0, select_2549[1], 1'b0, select_2549[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2554;
  assign and_2554 = good_known_q & (~((good_q & select_2550) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2563;
  assign select_2563 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2564;
  assign difference_2564 = {1'b0, shown_2_s3_q} - {1'b0, select_2563};
  logic [4:0] around;
  assign around = {difference_2564[3], difference_2564} + (equal_562_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2567;
  assign sum_2567 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2533 ? and_2554 : (~({sum_2567, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2579;
  assign select_2579 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2580;
  assign difference_2580 = {1'b0, near_2_s3_q} - {1'b0, select_2579};
  logic [4:0] n;
  assign n = {difference_2580[3], difference_2580} + (equal_562_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2584;
  assign and_2584 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2620;
  assign select_2620 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2622;
  assign select_2622 = sample_pair_whole_s3_q ? (and_540_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2624;
  assign select_2624 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2626;
  assign select_2626 = sample_pair_whole_s3_q ? (and_540_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2631;
  assign sum_2631 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2632;
  assign difference_2632 = {1'b0, sum_2631[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2633;
  assign xor_2633 = {difference_2632[8:0], sum_2631[0]} ^ {10{difference_2632[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2632[9]} + {1'b0, xor_2633};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_545_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2638;
  assign select_2638 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2639;
  assign sum_2639 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2640;
  assign difference_2640 = {1'b0, sum_2639[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2641;
  assign xor_2641 = {difference_2640[8:0], sum_2639[0]} ^ {10{difference_2640[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2640[9]} + {1'b0, xor_2641};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_545_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2646;
  assign select_2646 = sample_pair_whole_s3_q ? (and_540_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2730;
  assign sum_2730 = sum_2726_s3_q + {2'h0, sum_2729_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2732;
  assign select_2732 = and_542_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2733;
  assign select_2733 = and_542_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2734;
  assign select_2734 = and_542_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2735;
  assign select_2735 = and_542_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2738;
  assign sum_2738 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2730};
  logic [13:0] sum_2740;
  assign sum_2740 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2738});
  // hls/stages/census.hpp:323
  logic and_2742;
  assign and_2742 = and_701_s3_q & (9'h4 < sum_2740[13:5]);
  // hls/stages/census.hpp:324
  logic and_2743;
  assign and_2743 = and_701_s3_q & less_725;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2744;
  assign sum_2744 = census_left_misses_q + {{17{and_2743}}, and_2742, 1'b0, and_2742};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2746;
  assign select_2746 = and_542_s3_q ? (equal_2737_s3_q ? 20'h0 : sum_2744) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2816;
  assign select_2816 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2819;
  assign select_2819 = and_542_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2822;
  assign and_2822 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2828;
  assign and_2828 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2829;
  assign and_2829 = and_2822 & and_2828;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2816[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2831;
  assign select_2831 = and_2829 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2833;
  assign select_2833 = equal_2737_s3_q ? {11'h0, select_2831} : (sharpness_sums_detail_0_q + {11'h0, select_2831});
  // hls/stages/agreement.hpp:457
  logic and_2840;
  assign and_2840 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2841;
  assign and_2841 = and_2822 & and_2840;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2816[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2843;
  assign select_2843 = and_2841 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2845;
  assign select_2845 = equal_2737_s3_q ? {11'h0, select_2843} : (sharpness_sums_detail_1_q + {11'h0, select_2843});
  logic [8:0] select_2848;
  assign select_2848 = and_2829 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2849;
  assign sum_2849 = (equal_2737_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2848};
  logic [8:0] select_2852;
  assign select_2852 = and_2841 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2853;
  assign sum_2853 = (equal_2737_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2852};
  // hls/stages/agreement.hpp:211
  logic equal_2855;
  assign equal_2855 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2856;
  assign less_2856 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2857;
  assign less_2857 = x_s3_q[4:0] < 5'h3;
  logic not_2858;
  assign not_2858 = ~x_s3_q[1];
  logic [2:0] select_2859;
  assign select_2859 = x_s3_q[0] ? {1'b0, not_2858, 1'b0} : {x_s3_q[1], 1'b0, not_2858};
  logic [5:0] select_2860;
  assign select_2860 = slot_s3_q[2] ? {select_2859[2], 1'b0, select_2859[1], 1'b0, select_2859[0], 1'b0} : {1'b0, select_2859[2], 1'b0, select_2859[1], 1'b0, select_2859[0]};
  logic [11:0] select_2861;
  assign select_2861 = slot_s3_q[1] ? {select_2860[5], 1'b0, select_2860[4], 1'b0, select_2860[3], 1'b0, select_2860[2], 1'b0, select_2860[1], 1'b0, select_2860[0], 1'b0} : {1'b0, select_2860[5], 1'b0, select_2860[4], 1'b0, select_2860[3], 1'b0, select_2860[2], 1'b0, select_2860[1], 1'b0, select_2860[0]};
  logic [23:0] select_2862;
  assign select_2862 = slot_s3_q[0] ? {select_2861[11], 1'b0, select_2861[10], 1'b0, select_2861[9], 1'b0, select_2861[8], 1'b0, select_2861[7], 1'b0, select_2861[6], 1'b0, select_2861[5], 1'b0, select_2861[4], 1'b0, select_2861[3], 1'b0, select_2861[2], 1'b0, select_2861[1], 1'b0, select_2861[0], 1'b0} : {1'b0, select_2861[11], 1'b0, select_2861[10], 1'b0, select_2861[9], 1'b0, select_2861[8], 1'b0, select_2861[7], 1'b0, select_2861[6], 1'b0, select_2861[5], 1'b0, select_2861[4], 1'b0, select_2861[3], 1'b0, select_2861[2], 1'b0, select_2861[1], 1'b0, select_2861[0]};
  // hls/stages/census.hpp:390
  logic and_2866;
  assign and_2866 = less_2857 & (~((sharpness_sums_contrast_1_q & select_2862) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2868;
  assign select_2868 = (less_2856 & and_2866) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2868};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2871;
  assign select_2871 = equal_2855 ? (less_2856 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2876;
  assign and_2876 = less_2857 & (~((sharpness_sums_contrast_0_q & select_2862) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2878;
  assign select_2878 = (less_2856 & and_2876) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2878};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2881;
  assign select_2881 = equal_2855 ? (less_2856 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2883;
  assign select_2883 = equal_2855 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2885;
  assign select_2885 = equal_2855 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2887;
  assign select_2887 = equal_2855 ? {sharpness_comparing_contrast_0_q[0], and_2876} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2889;
  assign select_2889 = equal_2855 ? {sharpness_comparing_contrast_1_q[0], and_2866} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2894;
  assign select_2894 = drew_q ? (equal_2855 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2898;
  assign select_2898 = drew_q ? (equal_2855 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2899;
  assign equal_2899 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2900;
  assign xor_2900 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2903;
  assign select_2903 = (equal_2899 | xor_2900) ? (five_times[0] & xor_2900) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2905;
  assign select_2905 = drew_q ? (equal_2855 ? select_2903 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2906;
  assign xor_2906 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2909;
  assign select_2909 = (equal_2899 | xor_2906) ? (five_times_2[0] & xor_2906) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2911;
  assign select_2911 = drew_q ? (equal_2855 ? select_2909 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2912;
  assign xor_2912 = sharpness_comparing_contrast_0_q[1] ^ and_2866;
  logic select_2915;
  assign select_2915 = (equal_2899 | xor_2912) ? (and_2866 & xor_2912) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2917;
  assign select_2917 = drew_q ? (equal_2855 ? select_2915 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2918;
  assign xor_2918 = sharpness_comparing_contrast_1_q[1] ^ and_2876;
  logic select_2921;
  assign select_2921 = (equal_2899 | xor_2918) ? (and_2876 & xor_2918) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2923;
  assign select_2923 = drew_q ? (equal_2855 ? select_2921 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3039;
  assign select_3039 = and_3031_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3037_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3042;
  assign and_3042 = not_568_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3047;
  assign and_3047 = not_568_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3052;
  assign and_3052 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_2475_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3056;
  assign not_3056 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3065;
  assign select_3065 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3066;
  assign difference_3066 = {1'b0, explained_2_s3_q} - {1'b0, select_3065};
  logic [4:0] e;
  assign e = {difference_3066[3], difference_3066} + (equal_562_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3069;
  assign sum_3069 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3073;
  assign not_3073 = ~(equal_2533 ? and_2554 : (~({sum_3069, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3076;
  assign and_3076 = ends_cell_s3_q & (not_3056 & (centres_values_1_textured_s3_q & not_3073));
  logic and_3078;
  assign and_3078 = not_568_s3_q & (drew_q & and_3076);
  // hls/stages/agreement.hpp:1132
  logic less_3081;
  assign less_3081 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3082;
  assign select_3082 = less_3081 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3085;
  assign select_3085 = less_3081 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3086;
  assign sum_3086 = {1'b0, select_3085} + {3'h0, select_3085[9:2]};
  logic and_3088;
  assign and_3088 = (~(select_3082[9:4] == 6'h0)) & ({sum_3086, select_3085[1:0]} < {3'h0, select_3082});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3091;
  assign select_3091 = x_s3_q[6] ? (equal_2074_s3_q ? 10'h0 : (and_3088 ? select_3082 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3092;
  assign select_3092 = equal_567_s3_q ? select_3091 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3094;
  assign select_3094 = and_3031_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3092});
  logic [13:0] select_3101;
  assign select_3101 = and_3031_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3099_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3103;
  assign and_3103 = not_3056 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3106;
  assign and_3106 = not_568_s3_q & (drew_q & (ends_cell_s3_q & and_3103));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3108;
  assign select_3108 = and_3031_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3106});
  // hls/stages/agreement.hpp:1110
  logic and_3110;
  assign and_3110 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3073);
  // hls/stages/agreement.hpp:788
  logic and_3114;
  assign and_3114 = not_568_s3_q & (drew_q & (ends_cell_s3_q & (not_3056 & and_3110)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3116;
  assign select_3116 = and_3031_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3114});
  logic [13:0] select_3135;
  assign select_3135 = and_3031_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3133_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3210;
  assign select_3210 = drew_q ? (equal_2167_s3_q ? (and_3192_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3211;
  assign select_3211 = equal_567_s3_q ? 8'h0 : select_3210;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3213;
  assign select_3213 = and_3191_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3211[7]}}, select_3211});
  // hls/stages/agreement.hpp:788
  logic and_3216;
  assign and_3216 = not_568_s3_q & (drew_q & (and_3192_s3_q & equal_2167_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3218;
  assign select_3218 = and_3191_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3216});
  // hls/stages/registration.hpp:107
  logic and_3220;
  assign and_3220 = and_3192_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3222;
  assign select_3222 = drew_q ? (equal_2167_s3_q ? {and_3220, and_3192_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3223;
  assign select_3223 = equal_567_s3_q ? 2'h0 : select_3222;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3224;
  assign sum_3224 = registration_half_votes_down_q + {{5{select_3223[1]}}, select_3223};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3230;
  assign select_3230 = drew_q ? (equal_2167_s3_q ? {and_3228_s3_q, and_3192_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3231;
  assign select_3231 = equal_567_s3_q ? 2'h0 : select_3230;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3232;
  assign sum_3232 = registration_half_votes_up_q + {{5{select_3231[1]}}, select_3231};
  // hls/stages/registration.hpp:107
  logic and_3235;
  assign and_3235 = and_3192_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3237;
  assign select_3237 = drew_q ? (equal_2167_s3_q ? {and_3235, and_3192_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3238;
  assign select_3238 = equal_567_s3_q ? 2'h0 : select_3237;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3239;
  assign sum_3239 = registration_half_half_votes_down_q + {{5{select_3238[1]}}, select_3238};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3244;
  assign select_3244 = drew_q ? (equal_2167_s3_q ? {and_3242_s3_q, and_3192_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3245;
  assign select_3245 = equal_567_s3_q ? 2'h0 : select_3244;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3246;
  assign sum_3246 = registration_half_half_votes_up_q + {{5{select_3245[1]}}, select_3245};
  // hls/stages/agreement.hpp:788
  logic and_3280;
  assign and_3280 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & less_2105_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3287;
  assign select_3287 = or_2109_s3_q ? 12'h0 : (equal_3285_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3290;
  assign select_3290 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3287 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3291;
  assign select_3291 = equal_567_s3_q ? select_3290 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3292;
  assign and_3292 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3295;
  assign and_3295 = not_2448_s3_q & (less_2105_s3_q & ({and_3292, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3297;
  assign and_3297 = equal_567_s3_q & (x_s3_q[6] & and_3295);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3299;
  assign sum_3299 = {{2{select_3291[11]}}, select_3291} + (and_3297 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3302;
  assign select_3302 = or_2109_s3_q ? 12'h0 : (equal_3285_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3305;
  assign select_3305 = x_s3_q[6] ? (equal_2074_s3_q ? 12'h0 : (less_2105_s3_q ? select_3302 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3306;
  assign select_3306 = equal_567_s3_q ? select_3305 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3308;
  assign sum_3308 = {{2{select_3306[11]}}, select_3306} + (and_3297 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3310;
  assign not_3310 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3313;
  assign and_3313 = not_2448_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3310, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3319;
  assign and_3319 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & (less_2105_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3320;
  assign not_3320 = ~and_3319;
  logic less_3321;
  assign less_3321 = $signed({9'h1, {2{not_3320}}, and_3319}) < $signed(registration_up_q[13:2]);
  logic select_3322;
  assign select_3322 = (equal_567_s3_q & (x_s3_q[6] & and_3313)) ? less_3321 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3326;
  assign and_3326 = x_s3_q[6] & (not_2448_s3_q & (less_2105_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3327;
  assign and_3327 = equal_567_s3_q & and_3326;
  // hls/stages/registration.hpp:242
  logic less_3328;
  assign less_3328 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3330;
  assign less_3330 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3332;
  assign equal_3332 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3336;
  assign and_3336 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & (less_2105_s3_q & equal_3332)));
  // hls/stages/agreement.hpp:1142
  logic and_3343;
  assign and_3343 = x_s3_q[6] & (not_2448_s3_q & (less_2105_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3346;
  assign equal_3346 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3349;
  assign and_3349 = not_2448_s3_q & (less_2105_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3346));
  // hls/stages/registration.hpp:244
  logic and_3353;
  assign and_3353 = (equal_567_s3_q & (x_s3_q[6] & and_3349)) & (less_3330 | less_3328);
  // hls/stages/agreement.hpp:1142
  logic and_3358;
  assign and_3358 = not_2448_s3_q & (less_2105_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3346)));
  // hls/stages/registration.hpp:244
  logic and_3361;
  assign and_3361 = registration_votes_up_q & registration_other_down_q;
  logic select_3363;
  assign select_3363 = registration_votes_down_q ? (registration_other_up_q | and_3361) : and_3361;
  // hls/stages/registration.hpp:138
  logic and_3365;
  assign and_3365 = (equal_567_s3_q & (x_s3_q[6] & and_3358)) & (registration_other_enough_q & select_3363);
  // hls/stages/registration.hpp:245
  logic or_3368;
  assign or_3368 = registration_moved_q | (registration_enough_q & (and_3353 | and_3365));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3452;
  assign select_3452 = sample_pair_whole_s3_q ? (equal_2157_s3_q ? patches_place_0_slope_q : select_2263[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3457;
  assign select_3457 = sample_pair_whole_s3_q ? (equal_2157_s3_q ? patches_place_1_slope_q : select_2291[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3459;
  assign select_3459 = equal_2157_s3_q ? patches_valid_0_q : (select_2156_s3_q ? patches_valid_0_q : select_2259[0]);
  // hls/stages/agreement.hpp:276
  logic select_3462;
  assign select_3462 = sample_pair_whole_s3_q ? (and_2282 ? (sample_present_s3_q & select_3459) : select_3459) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3464;
  assign select_3464 = equal_2157_s3_q ? patches_valid_1_q : (select_2156_s3_q ? select_2259[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3467;
  assign select_3467 = sample_pair_whole_s3_q ? (and_2301 ? (sample_present_s3_q & select_3464) : select_3464) : patches_valid_1_q;
  logic [5:0] select_3470;
  assign select_3470 = sample_pair_whole_s3_q ? (select_2280[5] ? {1'b1, select_2280[4:0]} : (select_2280 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3473;
  assign select_3473 = sample_pair_whole_s3_q ? (select_2299[5] ? {1'b1, select_2299[4:0]} : (select_2299 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3476;
  assign select_3476 = sample_pair_whole_s3_q ? (select_2312[4] ? {1'b1, select_2312[3:0]} : (select_2312 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3479;
  assign select_3479 = sample_pair_whole_s3_q ? (select_2317[4] ? {1'b1, select_2317[3:0]} : (select_2317 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3898_s3_q, parity_3894_s3_q, xor_3882_s3_q, parity_3854_s3_q, parity_3792_s3_q, parity_3663_s3_q} + (equal_3899_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3903;
  assign select_3903 = equal_2243_s3_q ? patches_sums_values_0_q : (equal_2245_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3904;
  assign select_3904 = equal_2245_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3906;
  assign select_3906 = equal_2245_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3908;
  assign select_3908 = equal_2245_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3910;
  assign select_3910 = equal_2245_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3912;
  assign select_3912 = equal_2245_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3914;
  assign select_3914 = equal_2245_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3916;
  assign select_3916 = equal_2245_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3918;
  assign select_3918 = equal_2245_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3920;
  assign select_3920 = equal_2245_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3922;
  assign select_3922 = equal_2245_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3924;
  assign select_3924 = equal_2245_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3926;
  assign select_3926 = equal_2245_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3928;
  assign select_3928 = equal_2245_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3930;
  assign select_3930 = equal_2245_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3932;
  assign select_3932 = equal_2245_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3934;
  assign select_3934 = equal_2245_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_4005;
  assign difference_4005 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_4008;
  assign and_4008 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_4005, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_4011;
  assign not_4011 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_4014;
  assign and_4014 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_4008 & ((10'h38 < patches_peak_size_q) & not_4011));
  // hls/stages/patches.hpp:190
  logic and_4016;
  assign and_4016 = and_3999_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_4014);
  // hls/stages/patches.hpp:667
  logic not_4017;
  assign not_4017 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_4019;
  assign and_4019 = and_4016 & (not_2250_s3_q & not_4017);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4021;
  assign sum_4021 = {7'h0, and_4019} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4025;
  assign sum_4025 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4024_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_4032;
  assign not_4032 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4033;
  assign sum_4033 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4035;
  assign not_4035 = ~({eight, 3'h0} < {1'b0, sum_4033, fall_2[0]});
  logic [1:0] sum_4036;
  assign sum_4036 = {1'b0, not_4032} + {1'b0, not_4035};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4037;
  assign sum_4037 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4039;
  assign not_4039 = ~({eight, 3'h0} < {sum_4037, fall_2[1:0]});
  logic not_4042;
  assign not_4042 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4043;
  assign sum_4043 = {1'b0, not_4039} + {1'b0, not_4042};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4036} + {1'b0, sum_4043};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4046;
  assign select_4046 = less_4024_s3_q ? ({sum_4025, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_4025, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_4047;
  assign select_4047 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_4048;
  assign select_4048 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4049;
  assign sum_4049 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_4050;
  assign sum_4050 = {select_4048[5], select_4048} + {{3{sum_4049[3]}}, sum_4049};
  // hls/stages/patches.hpp:604
  logic [17:0] product_4051;
  assign product_4051 = $signed({{10{select_4047[7]}}, select_4047}) * $signed({{8{sum_4050[6]}}, sum_4050, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_4052;
  assign difference_4052 = {{6{select_4046[7]}}, select_4046} - {product_4051[17], product_4051[17:5]};
  // hls/stages/patches.hpp:611
  logic less_4053;
  assign less_4053 = $signed({{7{difference_4023[6]}}, difference_4023}) < $signed(difference_4052);
  // hls/stages/patches.hpp:189
  logic not_4054;
  assign not_4054 = ~less_4053;
  // hls/stages/patches.hpp:670
  logic and_4055;
  assign and_4055 = not_4054 & and_4019;
  logic [7:0] sum_4056;
  assign sum_4056 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4055};
  // hls/stages/patches.hpp:189
  logic not_4059;
  assign not_4059 = ~($signed(difference_4052) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_4060;
  assign and_4060 = not_4059 & and_4019;
  logic [7:0] sum_4061;
  assign sum_4061 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4060};
  // hls/stages/patches.hpp:192
  logic and_4063;
  assign and_4063 = and_4016 & (patches_second_s3_q & not_4017);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4065;
  assign sum_4065 = {7'h0, and_4063} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_4067;
  assign and_4067 = not_4054 & and_4063;
  logic [7:0] sum_4068;
  assign sum_4068 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4067};
  // hls/stages/patches.hpp:671
  logic and_4070;
  assign and_4070 = not_4059 & and_4063;
  logic [7:0] sum_4071;
  assign sum_4071 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4070};
  // hls/stages/patches.hpp:192
  logic and_4073;
  assign and_4073 = and_4016 & (patches_lower_s3_q & not_2250_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4075;
  assign sum_4075 = {7'h0, and_4073} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_4077;
  assign and_4077 = not_4054 & and_4073;
  logic [7:0] sum_4078;
  assign sum_4078 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4077};
  // hls/stages/patches.hpp:671
  logic and_4080;
  assign and_4080 = not_4059 & and_4073;
  logic [7:0] sum_4081;
  assign sum_4081 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4080};
  // hls/stages/patches.hpp:192
  logic and_4083;
  assign and_4083 = and_4016 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4085;
  assign sum_4085 = {7'h0, and_4083} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_4087;
  assign and_4087 = not_4054 & and_4083;
  logic [7:0] sum_4088;
  assign sum_4088 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4087};
  // hls/stages/patches.hpp:671
  logic and_4090;
  assign and_4090 = not_4059 & and_4083;
  logic [7:0] sum_4091;
  assign sum_4091 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4090};
  // hls/stages/agreement.hpp:1223
  logic equal_4092;
  assign equal_4092 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4093;
  assign less_4093 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4097;
  assign and_4097 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & (equal_4092 & less_4093)));
  // hls/stages/agreement.hpp:1142
  logic and_4102;
  assign and_4102 = x_s3_q[6] & (not_2448_s3_q & (less_4093 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4103;
  assign and_4103 = equal_567_s3_q & and_4102;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4105;
  assign or_4105 = (and_4097 ? patches_quarters_0_places_q : 8'h0) | (and_4103 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4109;
  assign and_4109 = x_s3_q[6] & (not_2448_s3_q & (less_4093 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4110;
  assign and_4110 = equal_567_s3_q & and_4109;
  // hls/stages/agreement.hpp:1142
  logic and_4116;
  assign and_4116 = x_s3_q[6] & (not_2448_s3_q & (less_4093 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4117;
  assign and_4117 = equal_567_s3_q & and_4116;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4119;
  assign or_4119 = (or_4105 | (and_4110 ? patches_quarters_2_places_q : 8'h0)) | (and_4117 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_4123;
  assign select_4123 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4127;
  assign and_4127 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & (less_4093 & select_4123)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_4129;
  assign select_4129 = and_4097 ? (and_4127 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4131;
  assign select_4131 = and_4103 ? (and_4127 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4134;
  assign select_4134 = and_4110 ? (and_4127 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4137;
  assign select_4137 = and_4117 ? (and_4127 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_4140;
  assign select_4140 = and_4097 ? (and_4127 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4142;
  assign select_4142 = and_4103 ? (and_4127 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4145;
  assign select_4145 = and_4110 ? (and_4127 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4148;
  assign select_4148 = and_4117 ? (and_4127 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_4150;
  assign sum_4150 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4154;
  assign and_4154 = x_s3_q[6] & (not_2448_s3_q & (less_4093 & (sum_4150[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4155;
  assign and_4155 = equal_567_s3_q & and_4154;
  // hls/stages/patches.hpp:630
  logic [7:0] select_4158;
  assign select_4158 = and_4155 ? (patches_word_places_q + (and_4103 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4161;
  assign select_4161 = and_4155 ? (patches_word_up_q + (and_4103 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4164;
  assign select_4164 = and_4155 ? (patches_word_down_q + (and_4103 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_4167;
  assign select_4167 = ($signed(difference_4052[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4052[5:0];
  logic [5:0] select_4168;
  assign select_4168 = ($signed(14'h10) < $signed(difference_4052)) ? 6'h10 : select_4167;
  // hls/stages/patches.hpp:673
  logic [5:0] select_4169;
  assign select_4169 = and_4016 ? select_4168 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_4171;
  assign select_4171 = patches_round_ends_q ? {{6{select_4169[5]}}, select_4169} : (patches_across_q + {{6{select_4169[5]}}, select_4169});
  // hls/stages/agreement.hpp:788
  logic and_4175;
  assign and_4175 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q & (equal_3332 & less_4093)));
  // hls/stages/agreement.hpp:1142
  logic and_4179;
  assign and_4179 = x_s3_q[6] & (not_2448_s3_q & (less_4093 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4180;
  assign and_4180 = equal_567_s3_q & and_4179;
  // hls/stages/patches.hpp:657
  logic [7:0] select_4182;
  assign select_4182 = and_4175 ? (and_4180 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_4186;
  assign or_4186 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_4189;
  assign or_4189 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_4190;
  assign sum_4190 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_4192;
  assign select_4192 = and_4175 ? (and_4180 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_4195;
  assign and_4195 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_4197;
  assign select_4197 = and_4180 ? {and_4195, patches_found_q[2:1]} : (and_4175 ? {and_4195, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_4201;
  assign or_4201 = patches_partly_q | (patches_doubted_q & (~and_4180));
  // hls/stages/patches.hpp:656
  logic select_4204;
  assign select_4204 = and_4175 ? (and_4180 ? or_4201 : (and_4175 ? or_4201 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_4205;
  assign select_4205 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4209;
  assign select_4209 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_4211;
  assign sum_4211 = {sum_4050[6], sum_4050, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_4213;
  assign and_4213 = ({{5{sum_4211[10]}}, sum_4211} < 16'h3) & and_4016;
  logic [7:0] sum_4214;
  assign sum_4214 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4213};
  // hls/stages/patches.hpp:663
  logic [12:0] product_4219;
  assign product_4219 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_4182};
  // hls/stages/patches.hpp:192
  logic and_4221;
  assign and_4221 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4219[12:5] < patches_on_skin_q);
  logic select_4226;
  assign select_4226 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_4230;
  assign or_4230 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_4237;
  assign select_4237 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_4243;
  assign and_4243 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4244;
  assign sum_4244 = patches_age_q + {9'h0, and_4243};
  logic [9:0] select_4247;
  assign select_4247 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4244)) : sum_4244;
  // hls/stages/agreement.hpp:1188
  logic or_4304;
  assign or_4304 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_4306;
  assign equal_4306 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_4312;
  assign select_4312 = (equal_4306 & equal_4092) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4315;
  assign sum_4315 = {1'b0, select_3085} + {2'h0, select_3085[9:1]};
  logic select_4318;
  assign select_4318 = (select_3082[9:3] == 7'h0) ? ((~or_4304) & (~select_4312)) : (~({sum_4315, select_3085[0]} < {2'h0, select_3082}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4320;
  assign select_4320 = x_s3_q[6] ? (equal_2074_s3_q ? good_q : {select_4318, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4325;
  assign select_4325 = equal_567_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4323_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_4326;
  assign equal_4326 = x_s3_q[6:3] == 4'ha;
  logic equal_4328;
  assign equal_4328 = x_s3_q[6:3] == 4'hc;
  logic equal_4329;
  assign equal_4329 = x_s3_q[6:3] == 4'hb;
  logic equal_4330;
  assign equal_4330 = x_s3_q[6:3] == 4'h9;
  logic equal_4331;
  assign equal_4331 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4333;
  assign select_4333 = equal_4330 ? counts_skin_unproven_q : (equal_4331 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4335;
  assign select_4335 = equal_4329 ? counts_regions_bad_q : (equal_4326 ? counts_nearer_q : select_4333);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4328 ? counts_on_skin_q : select_4335;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1230
  logic select_4338;
  assign select_4338 = (equal_4326 & equal_4092) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_4339;
  assign not_4339 = ~hidden_for_q[7];
  logic [7:0] select_4341;
  assign select_4341 = select_4338 ? (hidden_for_q + {7'h0, not_4339}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4343;
  assign select_4343 = equal_567_s3_q ? (equal_4323_s3_q ? select_4341 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4344;
  assign select_4344 = equal_4092 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4346;
  assign select_4346 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4348;
  assign select_4348 = equal_4331 ? cfg_unproven_skin_limit_i : (equal_4306 ? cfg_unproven_limit_i : select_4346);
  logic [7:0] select_4350;
  assign select_4350 = equal_4326 ? cfg_regions_limit_i : (equal_4330 ? cfg_hidden_limit_i : select_4348);
  logic [7:0] limit;
  assign limit = equal_4328 ? cfg_regions_limit_i : (equal_4329 ? {cfg_on_skin_limit_i, 3'h0} : select_4350);
  // hls/stages/agreement.hpp:1231
  logic not_4353;
  assign not_4353 = ~x_s3_q[2];
  logic [3:0] select_4354;
  assign select_4354 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4353, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4353};
  logic [7:0] select_4355;
  assign select_4355 = x_s3_q[0] ? {select_4354[3], 1'b0, select_4354[2], 1'b0, select_4354[1], 1'b0, select_4354[0], 1'b0} : {1'b0, select_4354[3], 1'b0, select_4354[2], 1'b0, select_4354[1], 1'b0, select_4354[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4359;
  assign select_4359 = equal_4330 ? counts_skin_supervised_q : (equal_4331 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4361;
  assign select_4361 = equal_4329 ? counts_skin_textured_q : (equal_4326 ? counts_textured_q : select_4359);
  logic [13:0] of;
  assign of = equal_4328 ? counts_textured_q : select_4361;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4363;
  assign select_4363 = ((limit & select_4355) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4344} + {1'b0, select_4363};
  // hls/stages/agreement.hpp:788
  logic select_4368;
  assign select_4368 = equal_567_s3_q ? (equal_4092 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_4373;
  assign and_4373 = too_much_q & (~(equal_4331 & equal_4092));
  // hls/stages/agreement.hpp:1229
  logic select_4378;
  assign select_4378 = (over[14] & equal_4092) ? (and_4373 | ((equal_4331 | equal_4330) | (x_s3_q[6:3] == 4'hf))) : and_4373;
  // hls/stages/agreement.hpp:1125
  logic and_4383;
  assign and_4383 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4384;
  assign select_4384 = (equal_4328 & equal_4092) ? and_4383 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4386;
  assign select_4386 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4388;
  assign select_4388 = equal_567_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4386 : box_textured_columns_values_0_q);
  logic [2:0] select_4389;
  assign select_4389 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4391;
  assign select_4391 = equal_567_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4389 : box_textured_columns_values_1_q);
  logic [2:0] select_4392;
  assign select_4392 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4394;
  assign select_4394 = equal_567_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4392 : box_textured_columns_values_2_q);
  logic [2:0] select_4395;
  assign select_4395 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4397;
  assign select_4397 = equal_567_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4395 : box_textured_columns_values_3_q);
  logic [2:0] select_4398;
  assign select_4398 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4400;
  assign select_4400 = equal_567_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4398 : box_textured_columns_values_4_q);
  logic [4:0] select_4402;
  assign select_4402 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4404;
  assign select_4404 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4406;
  assign select_4406 = equal_567_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4404 : box_explained_columns_values_0_q);
  logic [2:0] select_4407;
  assign select_4407 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4409;
  assign select_4409 = equal_567_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4407 : box_explained_columns_values_1_q);
  logic [2:0] select_4410;
  assign select_4410 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4412;
  assign select_4412 = equal_567_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4410 : box_explained_columns_values_2_q);
  logic [2:0] select_4413;
  assign select_4413 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4415;
  assign select_4415 = equal_567_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4413 : box_explained_columns_values_3_q);
  logic [2:0] select_4416;
  assign select_4416 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4418;
  assign select_4418 = equal_567_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4416 : box_explained_columns_values_4_q);
  logic [4:0] select_4420;
  assign select_4420 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4423;
  assign select_4423 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4425;
  assign select_4425 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4427;
  assign select_4427 = equal_567_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4425 : box_shown_columns_values_1_q);
  logic [2:0] select_4428;
  assign select_4428 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4430;
  assign select_4430 = equal_567_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4428 : box_shown_columns_values_2_q);
  logic [2:0] select_4431;
  assign select_4431 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4433;
  assign select_4433 = equal_567_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4431 : box_shown_columns_values_3_q);
  logic [2:0] select_4434;
  assign select_4434 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4436;
  assign select_4436 = equal_567_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4434 : box_shown_columns_values_4_q);
  logic [4:0] select_4438;
  assign select_4438 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4441;
  assign select_4441 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4443;
  assign select_4443 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4445;
  assign select_4445 = equal_567_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4443 : box_nearer_columns_values_1_q);
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_567_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4446 : box_nearer_columns_values_2_q);
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_567_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4449 : box_nearer_columns_values_3_q);
  logic [2:0] select_4452;
  assign select_4452 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4454;
  assign select_4454 = equal_567_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4452 : box_nearer_columns_values_4_q);
  logic [4:0] select_4456;
  assign select_4456 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4501;
  assign select_4501 = and_4500_s3_q ? {and_2584, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4502;
  assign and_4502 = proven_q & less_4490;
  // hls/stages/agreement.hpp:438
  logic select_4505;
  assign select_4505 = and_2514_s3_q ? (less_2515_s3_q ? (select_4501[0] & and_4502) : seen_q) : seen_q;
  logic select_4508;
  assign select_4508 = and_2514_s3_q ? (less_2515_s3_q ? (select_4501[1] & and_4502) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4515;
  assign or_4515 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4514_s3_q;
  // hls/stages/agreement.hpp:1241
  logic not_4523;
  assign not_4523 = ~(or_4304 | not_2807);
  // hls/stages/agreement.hpp:788
  logic and_4527;
  assign and_4527 = equal_567_s3_q & (equal_4323_s3_q & (not_4523 & (select_4312 | select_4378)));
  logic and_4530;
  assign and_4530 = equal_4323_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4534;
  assign or_4534 = select_2905 | (select_2917 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4541;
  assign and_4541 = equal_567_s3_q & (equal_4323_s3_q & (not_4523 & (select_2911 | select_2923)));
  // hls/stages/agreement.hpp:1150
  logic and_4546;
  assign and_4546 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4341 < cfg_hidden_frames_i));
  logic select_4552;
  assign select_4552 = (not_2807 | (select_4384 & not_4216)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4557;
  assign and_4557 = equal_567_s3_q & (equal_4323_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4561;
  assign and_4561 = equal_567_s3_q & (x_s3_q[6] & (not_2448_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4569;
  assign select_4569 = equal_2096_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4567_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4570;
  assign select_4570 = equal_2094_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4569;
  logic [31:0] select_4571;
  assign select_4571 = equal_2092_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4570;
  logic [31:0] select_4572;
  assign select_4572 = equal_2090_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4571;
  logic [31:0] select_4573;
  assign select_4573 = equal_2088_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4572;
  logic [31:0] select_4574;
  assign select_4574 = equal_2086_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4573;
  logic [31:0] select_4575;
  assign select_4575 = equal_2084_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4574;
  logic [31:0] select_4576;
  assign select_4576 = equal_2082_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4575;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4577;
  assign select_4577 = less_3081 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4578;
  assign select_4578 = equal_2074_s3_q ? select_4576 : {2'h0, select_4577, select_3085, select_3082};

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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2165_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2242_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2214_s3_q};
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
  assign patches_right_0_waddr = {select_2273_s3_q, select_2270};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2282);
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
  assign patches_right_1_waddr = {select_2273_s3_q, select_2298};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2301);
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
  assign patches_left_waddr = {select_2320, select_2319_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2326);
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
  assign patches_rows_wdata = select_2436;
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
  assign regions_waddr = {region_row_s3_q, or_2446_s3_q, or_2443_s3_q, or_2440_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2480_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2479, sum_2469, sum_2464};
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
  assign map_waddr = {sum_2520_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2594_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2584, is_seen};
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
      patches_on_skin_limit_q <= 5'h0;
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
      census_left_misses_q <= select_2746;
      sharpness_before_last_mask_q <= select_2819;
      sharpness_sums_detail_0_q <= and_542_s3_q ? select_2833 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_542_s3_q ? select_2845 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_542_s3_q ? sum_2849 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_542_s3_q ? sum_2853 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2871 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2881 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2883 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2885 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2887 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2889 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2894;
      sharpness_comparing_carry_1_q <= select_2898;
      sharpness_comparing_less_detail_0_q <= select_2905;
      sharpness_comparing_less_detail_1_q <= select_2911;
      sharpness_comparing_less_contrast_0_q <= select_2917;
      sharpness_comparing_less_contrast_1_q <= select_2923;
      counts_supervised_q <= select_3039;
      counts_textured_q <= and_3031_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3042});
      counts_explained_q <= and_3031_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3047});
      counts_nearer_q <= and_3031_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3052});
      counts_unproven_q <= and_3031_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3078});
      counts_regions_bad_q <= select_3094;
      counts_skin_supervised_q <= select_3101;
      counts_skin_textured_q <= select_3108;
      counts_skin_unproven_q <= select_3116;
      counts_on_skin_q <= select_3135;
      registration_half_across_q <= select_3213;
      registration_half_measured_q <= select_3218;
      registration_half_votes_down_q <= and_3191_s3_q ? 7'h0 : sum_3224;
      registration_half_votes_up_q <= and_3191_s3_q ? 7'h0 : sum_3232;
      registration_half_half_votes_down_q <= and_3191_s3_q ? 7'h0 : sum_3239;
      registration_half_half_votes_up_q <= and_3191_s3_q ? 7'h0 : sum_3246;
      registration_down_q <= and_3280 ? sum_3299 : registration_down_q;
      registration_up_q <= and_3280 ? sum_3308 : registration_up_q;
      registration_enough_q <= select_3322;
      registration_votes_down_q <= and_3327 ? less_3328 : registration_votes_down_q;
      registration_votes_up_q <= and_3327 ? less_3330 : registration_votes_up_q;
      registration_other_enough_q <= and_3336 ? select_3322 : registration_other_enough_q;
      registration_other_down_q <= and_3336 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3336 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_567_s3_q & and_3343)) & or_3368;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2261 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2264 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2265 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3452;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2290 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2292 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2293 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3457;
      patches_valid_0_q <= select_3462;
      patches_valid_1_q <= select_3467;
      patches_right_next_0_q <= select_3470;
      patches_right_next_1_q <= select_3473;
      patches_left_next_0_q <= select_3476;
      patches_left_next_1_q <= select_3479;
      patches_sums_values_0_q <= select_3903;
      patches_sums_values_1_q <= equal_2243_s3_q ? patches_sums_values_1_q : select_3904;
      patches_sums_values_2_q <= equal_2243_s3_q ? patches_sums_values_2_q : select_3906;
      patches_sums_values_3_q <= equal_2243_s3_q ? patches_sums_values_3_q : select_3908;
      patches_sums_values_4_q <= equal_2243_s3_q ? patches_sums_values_4_q : select_3910;
      patches_sums_values_5_q <= equal_2243_s3_q ? patches_sums_values_5_q : select_3912;
      patches_sums_values_6_q <= equal_2243_s3_q ? patches_sums_values_6_q : select_3914;
      patches_sums_values_7_q <= equal_2243_s3_q ? patches_sums_values_7_q : select_3916;
      patches_sums_values_8_q <= equal_2243_s3_q ? patches_sums_values_8_q : select_3918;
      patches_sums_values_9_q <= equal_2243_s3_q ? patches_sums_values_9_q : select_3920;
      patches_sums_values_10_q <= equal_2243_s3_q ? patches_sums_values_10_q : select_3922;
      patches_sums_values_11_q <= equal_2243_s3_q ? patches_sums_values_11_q : select_3924;
      patches_sums_values_12_q <= equal_2243_s3_q ? patches_sums_values_12_q : select_3926;
      patches_sums_values_13_q <= equal_2243_s3_q ? patches_sums_values_13_q : select_3928;
      patches_sums_values_14_q <= equal_2243_s3_q ? patches_sums_values_14_q : select_3930;
      patches_sums_values_15_q <= equal_2243_s3_q ? patches_sums_values_15_q : select_3932;
      patches_sums_values_16_q <= equal_2243_s3_q ? patches_sums_values_16_q : select_3934;
      patches_best_differing_q <= select_2436[9:0];
      patches_best_column_q <= select_2436[14:10];
      patches_quarters_0_places_q <= sum_4021;
      patches_quarters_0_up_q <= sum_4056;
      patches_quarters_0_down_q <= sum_4061;
      patches_quarters_1_places_q <= sum_4065;
      patches_quarters_1_up_q <= sum_4068;
      patches_quarters_1_down_q <= sum_4071;
      patches_quarters_2_places_q <= sum_4075;
      patches_quarters_2_up_q <= sum_4078;
      patches_quarters_2_down_q <= sum_4081;
      patches_quarters_3_places_q <= sum_4085;
      patches_quarters_3_up_q <= sum_4088;
      patches_quarters_3_down_q <= sum_4091;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_4119;
      patches_word_up_q <= ((select_4129 | select_4131) | select_4134) | select_4137;
      patches_word_down_q <= ((select_4140 | select_4142) | select_4145) | select_4148;
      patches_sum_places_q <= select_4158;
      patches_sum_up_q <= select_4161;
      patches_sum_down_q <= select_4164;
      patches_across_q <= select_4171;
      patches_places_q <= select_4182;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4186;
      patches_partly_q <= or_4189;
      patches_clear_limit_q <= sum_4190[8:2];
      patches_complete_q <= select_4192;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4175 ? select_4197 : patches_found_q;
      patches_doubted_q <= select_4204;
      patches_doubted_before_q <= select_4205;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4209;
      patches_on_skin_q <= sum_4214;
      patches_large_q <= not_4216 & and_4221;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4226;
      patches_spoiled_q <= or_4230;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4237;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4247;
      segment_textured_q <= select_2461 + {6'h0, and_3042};
      segment_explained_q <= select_2466 + {6'h0, and_3047};
      segment_nearer_q <= select_2476 + {6'h0, and_3052};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_567_s3_q ? select_4320 : good_q;
      good_known_q <= select_4325;
      hidden_for_q <= select_4343;
      product_q <= equal_567_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4368;
      disagree_q <= equal_567_s3_q ? select_4312 : disagree_q;
      too_much_q <= equal_567_s3_q ? select_4378 : too_much_q;
      hides_q <= equal_567_s3_q ? select_4338 : hides_q;
      overlooks_q <= equal_567_s3_q ? select_4384 : overlooks_q;
      seen_q <= select_4505;
      nearer_q <= select_4508;
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
      averager_quarter_1_0_q <= select_2620;
      averager_quarter_1_1_q <= select_2622;
      averager_quarter_2_0_q <= select_2624;
      averager_quarter_2_1_q <= select_2626;
      averager_detail_0_q <= select_2638;
      averager_detail_1_q <= select_2646;
      census_changes_values_0_left_q <= and_542_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_542_s3_q ? sum_2730 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2732;
      census_changes_values_1_right_q <= select_2733;
      census_changes_values_2_left_q <= select_2734;
      census_changes_values_2_right_q <= select_2735;
      sharpness_last_mask_q <= and_542_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_542_s3_q ? select_2816[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_542_s3_q ? select_2816[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4388;
      box_textured_columns_values_1_q <= select_4391;
      box_textured_columns_values_2_q <= select_4394;
      box_textured_columns_values_3_q <= select_4397;
      box_textured_columns_values_4_q <= select_4400;
      box_textured_sum_sums_values_0_q <= equal_567_s3_q ? box_textured_sum_sums_values_0_q : select_4402;
      box_explained_columns_values_0_q <= select_4406;
      box_explained_columns_values_1_q <= select_4409;
      box_explained_columns_values_2_q <= select_4412;
      box_explained_columns_values_3_q <= select_4415;
      box_explained_columns_values_4_q <= select_4418;
      box_explained_sum_sums_values_0_q <= equal_567_s3_q ? box_explained_sum_sums_values_0_q : select_4420;
      box_shown_columns_values_0_q <= equal_567_s3_q ? box_shown_columns_values_0_q : select_4423;
      box_shown_columns_values_1_q <= select_4427;
      box_shown_columns_values_2_q <= select_4430;
      box_shown_columns_values_3_q <= select_4433;
      box_shown_columns_values_4_q <= select_4436;
      box_shown_sum_sums_values_0_q <= equal_567_s3_q ? box_shown_sum_sums_values_0_q : select_4438;
      box_nearer_columns_values_0_q <= equal_567_s3_q ? box_nearer_columns_values_0_q : select_4441;
      box_nearer_columns_values_1_q <= select_4445;
      box_nearer_columns_values_2_q <= select_4448;
      box_nearer_columns_values_3_q <= select_4451;
      box_nearer_columns_values_4_q <= select_4454;
      box_nearer_sum_sums_values_0_q <= equal_567_s3_q ? box_nearer_sum_sums_values_0_q : select_4456;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4485_s4_q;
  logic or_4509_s4_q;
  logic and_4510_s4_q;
  logic and_4518_s4_q;
  logic and_4521_s4_q;
  logic and_4527_s4_q;
  logic and_4531_s4_q;
  logic and_4537_s4_q;
  logic and_4541_s4_q;
  logic and_4549_s4_q;
  logic and_4554_s4_q;
  logic and_4557_s4_q;
  logic and_4561_s4_q;
  logic [5:0] select_4563_s4_q;
  logic [31:0] select_4580_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4485_s4_q <= said_q;
      or_4509_s4_q <= not_2807 | select_4505;
      and_4510_s4_q <= cfg_prove_i & select_4508;
      and_4518_s4_q <= equal_567_s3_q & (equal_4323_s3_q & (cfg_prove_i & or_4515));
      and_4521_s4_q <= equal_567_s3_q & (equal_4323_s3_q & (cfg_prove_i & or_4304));
      and_4527_s4_q <= and_4527;
      and_4531_s4_q <= equal_567_s3_q & and_4530;
      and_4537_s4_q <= equal_567_s3_q & (equal_4323_s3_q & (not_4523 & or_4534));
      and_4541_s4_q <= and_4541;
      and_4549_s4_q <= equal_567_s3_q & (equal_4323_s3_q & (cfg_prove_i & and_4546));
      and_4554_s4_q <= equal_567_s3_q & (equal_4323_s3_q & select_4552);
      and_4557_s4_q <= and_4557;
      and_4561_s4_q <= and_4561;
      select_4563_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4580_s4_q <= equal_567_s3_q ? (x_s3_q[6] ? select_4578 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4509_s4_q;
  assign marks_nearer_o = and_4510_s4_q;
  assign verdict_valid_o = and_4485_s4_q;
  assign verdict_unproven_yet_o = and_4518_s4_q;
  assign verdict_untextured_o = and_4521_s4_q;
  assign verdict_disagree_o = and_4527_s4_q;
  assign verdict_moved_o = and_4531_s4_q;
  assign verdict_unsharp_left_o = and_4537_s4_q;
  assign verdict_unsharp_right_o = and_4541_s4_q;
  assign verdict_hidden_o = and_4549_s4_q;
  assign verdict_overlooked_o = and_4554_s4_q;
  assign verdict_out_of_step_o = and_4557_s4_q;
  assign frame_valid_o = and_4561_s4_q;
  assign frame_index_o = select_4563_s4_q;
  assign frame_word_o = select_4580_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4219[4:0], sum_4190[1:0], sum_4150[1:0], product_4051[4:0], sum_3181[0], difference_3122[1:0], detail_4[1:0], detail_3[1:0], sum_2740[4:0], sum_2181[0], sum_2177[0], sum_724[4:0], cfg_width_i[2:0]};

endmodule
