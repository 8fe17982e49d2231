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
  logic not_2810;
  assign not_2810 = ~cfg_prove_i;
  logic [5:0] sum_3020;
  assign sum_3020 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4063;
  assign difference_4063 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4276;
  assign not_4276 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4334;
  assign difference_4334 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4550;
  assign less_4550 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4551;
  assign sum_4551 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

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
  logic [2:0] select_501;
  assign select_501 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_505;
  assign select_505 = select_501[0] ? averager_place_q : (row_starts ? 9'h0 : (averager_place_q + 9'h1));
  // hls/stages/census.hpp:122
  logic or_509;
  assign or_509 = row_starts | (averager_inside_q & (~(averager_place_q == 9'h13f)));
  // hls/stages/census.hpp:124
  logic select_510;
  assign select_510 = select_501[0] ? averager_inside_q : or_509;
  // hls/stages/census.hpp:42
  logic or_511;
  assign or_511 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_513;
  assign and_513 = select_510 & (select_501[0] & or_511);
  // hls/stages/census.hpp:42
  logic [2:0] select_518;
  assign select_518 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [6:0] select_534;
  assign select_534 = sample_pair_first_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_534 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_536;
  assign equal_536 = select_501 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_537;
  assign equal_537 = select_518 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_538;
  assign and_538 = equal_537 & and_513;
  // hls/stages/agreement.hpp:276
  logic and_540;
  assign and_540 = sample_pair_whole_q & (equal_536 & and_538);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_569;
  assign equal_569 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_570;
  assign or_570 = so | equal_569;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_571;
  assign sum_571 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_572;
  assign select_572 = run_shift_q[5] ? x_q : sum_571;
  logic less_573;
  assign less_573 = {1'b0, last_q} < select_572;
  // hls/stages/agreement.hpp:226
  logic not_574;
  assign not_574 = ~less_573;
  // hls/stages/agreement.hpp:614
  logic equal_584;
  assign equal_584 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_585;
  assign equal_585 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_586;
  assign and_586 = equal_585 & not_574;
  logic select_588;
  assign select_588 = or_570 ? not_574 : (equal_584 ? not_574 : and_586);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_606;
  assign and_606 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_572)));
  logic and_607;
  assign and_607 = equal_584 & and_606;
  logic select_608;
  assign select_608 = or_570 ? not_574 : and_607;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_571[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:594
  logic not_638;
  assign not_638 = ~or_570;
  // hls/stages/agreement.hpp:149
  logic and_641;
  assign and_641 = not_638 & ((~equal_584) & and_586);
  // hls/stages/census.hpp:42
  logic [5:0] select_668;
  assign select_668 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_668 : 6'h0;
  // hls/stages/patches.hpp:393
  logic not_2138;
  assign not_2138 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_2141;
  assign not_2141 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:363
  logic and_2142;
  assign and_2142 = patches_capturing_q & not_2141;
  // hls/stages/patches.hpp:365
  logic equal_2143;
  assign equal_2143 = {or_511, select_518} == 4'hc;
  // hls/stages/patches.hpp:312
  logic equal_2145;
  assign equal_2145 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2150;
  assign and_2150 = (not_2138 & (patches_work_q == 3'h0)) & (~(and_2142 | ((~equal_2143) | (~equal_2145))));
  // hls/stages/patches.hpp:535
  logic equal_2241;
  assign equal_2241 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:513
  logic not_2242;
  assign not_2242 = ~equal_2241;
  // hls/stages/patches.hpp:506
  logic equal_2243;
  assign equal_2243 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:459
  logic not_2244;
  assign not_2244 = ~equal_2243;
  // hls/stages/patches.hpp:500
  logic equal_2245;
  assign equal_2245 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2246;
  assign equal_2246 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_2247;
  assign or_2247 = equal_2245 | equal_2246;
  // hls/stages/patches.hpp:461
  logic not_2248;
  assign not_2248 = ~patches_second_q;
  // hls/stages/patches.hpp:374
  logic [4:0] select_2270;
  assign select_2270 = and_2150 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2271;
  assign select_2271 = row_starts ? select_2270 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2273;
  assign and_2273 = and_2142 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2277;
  assign select_2277 = row_starts ? (and_2150 | (and_2142 & (~and_2273))) : patches_capturing_q;
  // hls/stages/patches.hpp:185
  logic and_2285;
  assign and_2285 = not_2242 & (not_2244 & (or_2247 & (patches_second_q & equal_2246)));
  // hls/stages/patches.hpp:168
  logic not_2301;
  assign not_2301 = ~equal_2246;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2317;
  assign select_2317 = row_starts ? {select_2270[4], select_2270[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:459
  logic and_2327;
  assign and_2327 = not_2242 & (or_2247 & not_2244);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2600;
  assign select_2600 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_501 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2603;
  assign select_2603 = sample_pair_whole_q ? (sample_last_q ? (select_518 + 3'h1) : select_518) : raster_at_y_q;
  logic [6:0] select_2606;
  assign select_2606 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_534 + {6'h0, equal_536})) : raster_at_column_q;
  logic [5:0] select_2609;
  assign select_2609 = sample_pair_whole_q ? (sample_last_q ? (select_668 + {5'h0, equal_537}) : select_668) : raster_at_row_q;
  logic select_2613;
  assign select_2613 = sample_pair_whole_q ? (sample_last_q ? (or_511 & (~raster_final_row_q)) : or_511) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2615;
  assign select_2615 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2619;
  assign select_2619 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2928;
  assign sum_2928 = {1'b0, last} + 8'h1;
  logic equal_2929;
  assign equal_2929 = {sum_2928[7], cfg_width_i[9:3]} == {1'b0, sum_2928[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2930;
  assign and_2930 = and_540 & equal_2929;
  // hls/stages/agreement.hpp:523
  logic select_2933;
  assign select_2933 = (and_2930 | (~ends_cell_q)) ? and_2930 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2933 ? (and_2930 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2937;
  assign select_2937 = select_2933 ? (and_2930 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2940;
  assign select_2940 = select_2933 ? (following_last_shift_q & (~and_2930)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2943;
  assign and_2943 = run_last_shift_q & equal_584;
  // hls/stages/agreement.hpp:616
  logic select_2945;
  assign select_2945 = equal_584 ? (~run_last_shift_q) : equal_585;
  // hls/stages/agreement.hpp:620
  logic equal_2946;
  assign equal_2946 = run_phase_q == 3'h1;
  logic not_2949;
  assign not_2949 = ~select_2945;
  // hls/stages/agreement.hpp:623
  logic equal_2951;
  assign equal_2951 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2952;
  assign and_2952 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2953;
  assign select_2953 = equal_2951 ? 2'h1 : {2{and_2952}};
  logic [2:0] select_2955;
  assign select_2955 = (and_2943 | (select_2945 | equal_2946)) ? (equal_2946 ? 3'h2 : {not_2949, {2{select_2945}}}) : (equal_569 ? 3'h6 : {select_2953[0], select_2953});
  // hls/stages/agreement.hpp:607
  logic and_2958;
  assign and_2958 = select_2945 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2961;
  assign select_2961 = (plan_shift_q[5] & select_2945) ? value : 7'h0;
  logic [1:0] or_2962;
  assign or_2962 = {2{so}} | select_2961[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2966;
  assign or_2966 = (select_2945 ? plan_columns_q : 8'h0) | ((equal_2946 | equal_2951) ? whole_q : 8'h0);
  logic [1:0] or_2967;
  assign or_2967 = {2{and_2943}} | or_2966[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2969;
  assign or_2969 = {or_2966[7:4], or_2967, or_2966[1:0]} | (equal_569 ? drawn_q : 8'h0);
  logic [4:0] or_2970;
  assign or_2970 = {5{so}} | {or_2969[6], or_2969[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2974;
  assign not_2974 = ~run_shift_q[5];
  logic [7:0] select_2977;
  assign select_2977 = equal_584 ? ({{7{not_2974}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2981;
  assign select_2981 = and_2930 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2983;
  assign select_2983 = select_2933 ? {select_2981[6], select_2981} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2986;
  assign select_2986 = select_2933 ? (and_2930 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2994;
  assign select_2994 = and_540 ? (equal_2929 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [5:0] sum_2995;
  assign sum_2995 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2997;
  assign select_2997 = and_540 ? (equal_2929 ? {sum_2995, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2998;
  assign sum_2998 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3000;
  assign select_3000 = and_540 ? (equal_2929 ? {sum_2998, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_3011;
  assign select_3011 = (ends_cell_q | select_2933) ? (~(now == 3'h6)) : (equal_584 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_3015;
  assign and_3015 = (~select_2933) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_3016;
  assign sum_3016 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_3018;
  assign select_3018 = equal_2929 ? ({sum_3016[6], cfg_height_i[8:3]} == {1'b0, sum_3016[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3377;
  assign select_3377 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3378;
  assign select_3378 = sample_pair_whole_q ? select_3377 : patches_phase_q;
  // hls/stages/patches.hpp:374
  logic and_3379;
  assign and_3379 = not_2141 & equal_2143;
  logic [8:0] select_3380;
  assign select_3380 = and_3379 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3381;
  assign select_3381 = and_3379 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3382;
  assign select_3382 = sample_pair_first_q ? select_3380 : select_3381;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3384;
  assign select_3384 = sample_pair_whole_q ? (row_starts ? select_3382[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3386;
  assign select_3386 = sample_pair_whole_q ? (row_starts ? select_3382[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3389;
  assign select_3389 = sample_pair_whole_q ? (equal_2145 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3391;
  assign select_3391 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2145}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_3392;
  assign equal_3392 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:332
  logic not_3393;
  assign not_3393 = ~equal_3392;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3395;
  assign select_3395 = sample_pair_whole_q ? (phase + {not_3393, 1'b1, not_3393, equal_3392}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3397;
  assign equal_3397 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3401;
  assign select_3401 = equal_3397 ? ((select_3378 == 4'h6) ? 4'h0 : (select_3378 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3402;
  assign equal_3402 = select_3401 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3405;
  assign select_3405 = equal_2929 ? (equal_3402 ? 4'h6 : (select_3401 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3407;
  assign select_3407 = equal_3397 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3409;
  assign select_3409 = equal_2929 ? (select_3407 + {4'h0, equal_3402}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3414;
  assign select_3414 = and_540 ? (equal_2929 ? ((6'h2 < row) & equal_3402) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3416;
  assign select_3416 = and_540 ? (equal_2929 ? select_3407 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:372
  logic [5:0] sum_3440;
  assign sum_3440 = {1'b0, select_668[5:1]} + 6'h1;
  logic less_3441;
  assign less_3441 = {sum_3440, select_668[0], select_518, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3444;
  assign select_3444 = row_starts ? (and_2150 ? (~less_3441) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:394
  logic or_3483;
  assign or_3483 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3489;
  assign and_3489 = equal_2241 & not_2248;
  // hls/stages/patches.hpp:400
  logic and_3490;
  assign and_3490 = not_2301 & and_3489;
  logic [1:0] select_3492;
  assign select_3492 = equal_2243 ? 2'h0 : (equal_2245 ? 2'h3 : {equal_2246, and_3490});
  // hls/stages/patches.hpp:280
  logic equal_3494;
  assign equal_3494 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3495;
  assign not_3495 = ~equal_3494;
  // hls/stages/patches.hpp:280
  logic equal_3496;
  assign equal_3496 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3497;
  assign not_3497 = ~equal_3496;
  // hls/stages/patches.hpp:284
  logic not_3499;
  assign not_3499 = ~(patches_following_q == 3'h2);
  logic and_3502;
  assign and_3502 = (~(patches_following_q == 3'h1)) & not_3499;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3503;
  assign select_3503 = equal_3496 ? 2'h2 : {and_3502, not_3499};
  logic [3:0] select_3504;
  assign select_3504 = equal_3494 ? 4'h2 : {select_3503, {2{not_3497}}};
  // hls/stages/patches.hpp:406
  logic not_3507;
  assign not_3507 = ~or_3483;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3512;
  assign select_3512 = or_3483 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:188
  logic [4:0] select_3514;
  assign select_3514 = or_3483 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
  assign fresh_re = s0_en & and_641;
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
  assign left_re = s0_en & select_588;
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
  assign right_codes_raddr = or_570 ? x_q[6:0] : (equal_584 ? sum_571[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_588;
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
  assign best_left_raddr = or_570 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_608;
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
  assign patches_right_0_re = s0_en & (not_2242 & (not_2244 & (or_2247 & (equal_2246 & not_2248))));
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
  assign patches_right_1_re = s0_en & and_2285;
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
  assign patches_left_re = s0_en & (not_2242 & (not_2244 & (not_2301 & or_2247)));
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
  assign patches_columns_above_re = s0_en & and_2327;
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
      raster_at_x_q <= select_2600;
      raster_at_y_q <= select_2603;
      raster_at_column_q <= select_2606;
      raster_at_row_q <= select_2609;
      raster_at_live_q <= select_2613;
      raster_rows_left_q <= sample_pair_whole_q ? select_2615 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2619;
      averager_place_q <= sample_pair_whole_q ? select_505 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_510 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2937;
      run_last_shift_q <= select_2940;
      run_span_q <= select_2933 ? (and_2930 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2955;
      following_shift_q <= select_2945 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2958;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2961[6], or_2962, select_2961[3:0]};
      following_columns_q <= {or_2969[7], or_2970[4], or_2969[5:4], or_2970[3:0]};
      plan_shift_q <= equal_584 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2977;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2983;
      columns_left_q <= select_2986;
      last_q <= and_540 ? (equal_2929 ? last : last_q) : last_q;
      least_q <= select_2994;
      whole_q <= select_2997;
      drawn_q <= select_3000;
      age_q <= select_2933 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2933 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3011;
      ends_q <= and_3015;
      final_row_q <= and_540 ? select_3018 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3378;
      patches_band_rows_rows_to_next_q <= select_3384;
      patches_band_rows_number_q <= select_3386;
      patches_next_band_rows_to_next_q <= select_3389;
      patches_next_band_number_q <= select_3391;
      patches_first_band_rows_to_next_q <= select_3395;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3392 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_540 ? select_3405 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_540 ? select_3409 : patches_choosing_number_q;
      patches_chooses_q <= select_3414;
      patches_choosing_band_q <= select_3416;
      patches_capturing_q <= sample_pair_whole_q ? select_2277 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3444 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2271 : patches_row_q;
      patches_work_q <= or_3483 ? following : patches_work_q;
      patches_second_q <= not_2138 & (patches_second_q | (patches_ends_q & equal_2241));
      patches_following_q <= equal_2241 ? {2'h0, and_3489} : {equal_2243, select_3492};
      patches_following_beats_q <= {select_3504, not_3495};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2273);
      patches_ends_q <= not_3507 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3512;
      patches_code_row_q <= select_3514;
      patches_column_q <= or_3483 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3507 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_501_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_505_s1_q;
  logic and_513_s1_q;
  logic equal_519_s1_q;
  logic [6:0] select_534_s1_q;
  logic [6:0] last_s1_2_q;
  logic and_538_s1_q;
  logic and_540_s1_q;
  logic equal_565_s1_q;
  logic so_s1_q;
  logic equal_569_s1_q;
  logic or_570_s1_q;
  logic less_573_s1_q;
  logic not_574_s1_q;
  logic equal_584_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_608_s1_q;
  logic [6:0] right_s1_q;
  logic and_641_s1_q;
  logic [5:0] row_s1_q;
  logic and_2026_s1_q;
  logic equal_2027_s1_q;
  logic and_2150_s1_q;
  logic equal_2241_s1_q;
  logic not_2242_s1_q;
  logic equal_2243_s1_q;
  logic not_2244_s1_q;
  logic equal_2245_s1_q;
  logic equal_2246_s1_q;
  logic or_2247_s1_q;
  logic [4:0] select_2271_s1_q;
  logic select_2277_s1_q;
  logic [3:0] select_2317_s1_q;
  logic and_2327_s1_q;
  logic equal_2929_s1_q;
  logic and_2930_s1_q;
  logic or_3483_s1_q;
  logic not_3507_s1_q;
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
      select_501_s1_q <= select_501;
      row_starts_s1_q <= row_starts;
      select_505_s1_q <= select_505;
      and_513_s1_q <= and_513;
      equal_519_s1_q <= select_518 == 3'h0;
      select_534_s1_q <= select_534;
      last_s1_2_q <= last;
      and_538_s1_q <= and_538;
      and_540_s1_q <= and_540;
      equal_565_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_569_s1_q <= equal_569;
      or_570_s1_q <= or_570;
      less_573_s1_q <= less_573;
      not_574_s1_q <= not_574;
      equal_584_s1_q <= equal_584;
      x_s1_2_q <= x[6:0];
      select_608_s1_q <= select_608;
      right_s1_q <= right;
      and_641_s1_q <= and_641;
      row_s1_q <= row;
      and_2026_s1_q <= not_638 & and_607;
      equal_2027_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2150_s1_q <= and_2150;
      equal_2241_s1_q <= equal_2241;
      not_2242_s1_q <= not_2242;
      equal_2243_s1_q <= equal_2243;
      not_2244_s1_q <= not_2244;
      equal_2245_s1_q <= equal_2245;
      equal_2246_s1_q <= equal_2246;
      or_2247_s1_q <= or_2247;
      select_2271_s1_q <= select_2271;
      select_2277_s1_q <= select_2277;
      select_2317_s1_q <= select_2317;
      and_2327_s1_q <= and_2327;
      equal_2929_s1_q <= equal_2929;
      and_2930_s1_q <= and_2930;
      or_3483_s1_q <= or_3483;
      not_3507_s1_q <= not_3507;
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
  logic and_514;
  assign and_514 = sample_pair_whole_s1_q & and_513_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_559;
  assign equal_559 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_560;
  assign equal_560 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_559 & equal_560;
  // hls/stages/moments.hpp:57
  logic [13:0] select_563;
  assign select_563 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [12:0] select_564;
  assign select_564 = first ? 13'h0 : select_563[12:0];
  // hls/stages/agreement.hpp:1009
  logic not_566;
  assign not_566 = ~equal_565_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_568;
  assign not_568 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_570_s1_q & not_574_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_563[13:6];
  // hls/stages/moments.hpp:104
  logic not_578;
  assign not_578 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:788
  logic and_582;
  assign and_582 = not_566 & (not_568 & (equal_569_s1_q & (inside_v & not_578)));
  // hls/stages/agreement.hpp:975
  logic and_598;
  assign and_598 = (or_570_s1_q & (left_rdata_q[67] & not_574_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [6:0] select_617;
  assign select_617 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:668
  logic not_738;
  assign not_738 = ~equal_559;
  // hls/stages/agreement.hpp:671
  logic and_739;
  assign and_739 = left_rdata_q[12] & not_738;
  logic and_740;
  assign and_740 = left_rdata_q[30] & not_738;
  logic and_741;
  assign and_741 = left_rdata_q[48] & not_738;
  logic and_742;
  assign and_742 = left_rdata_q[66] & not_738;
  // hls/stages/agreement.hpp:672
  logic and_743;
  assign and_743 = right_codes_rdata_q[12] & not_738;
  logic and_744;
  assign and_744 = right_codes_rdata_q[27] & not_738;
  logic and_745;
  assign and_745 = right_codes_rdata_q[42] & not_738;
  logic and_746;
  assign and_746 = right_codes_rdata_q[57] & not_738;
  logic and_747;
  assign and_747 = right_codes_rdata_q[72] & not_738;
  logic and_748;
  assign and_748 = right_codes_rdata_q[85] & not_738;
  // hls/stages/agreement.hpp:221
  logic and_753;
  assign and_753 = left_rdata_q[48] & not_574_s1_q;
  logic and_754;
  assign and_754 = right_codes_rdata_q[42] & not_574_s1_q;
  logic [11:0] select_755;
  assign select_755 = less_573_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_756;
  assign select_756 = less_573_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_760;
  assign select_760 = and_753 ? (and_754 ? (~(select_755 ^ select_756)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_766;
  assign parity_766 = ^select_760[5:3];
  logic parity_769;
  assign parity_769 = ^select_760[8:6];
  logic parity_772;
  assign parity_772 = ^select_760[11:3];
  // hls/stages/agreement.hpp:221
  logic and_776;
  assign and_776 = left_rdata_q[66] & not_574_s1_q;
  logic and_777;
  assign and_777 = right_codes_rdata_q[57] & not_574_s1_q;
  logic [11:0] select_778;
  assign select_778 = less_573_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_779;
  assign select_779 = less_573_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_783;
  assign select_783 = and_776 ? (and_777 ? (~(select_778 ^ select_779)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_786;
  assign parity_786 = ^select_783[8:6];
  logic parity_789;
  assign parity_789 = ^select_783[11:9];
  // hls/stages/agreement.hpp:221
  logic and_793;
  assign and_793 = left_rdata_q[84] & not_574_s1_q;
  logic and_794;
  assign and_794 = right_codes_rdata_q[72] & not_574_s1_q;
  logic [11:0] select_795;
  assign select_795 = less_573_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_796;
  assign select_796 = less_573_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_800;
  assign select_800 = and_793 ? (and_794 ? (~(select_795 ^ select_796)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_806;
  assign parity_806 = ^select_800[2:0];
  logic parity_809;
  assign parity_809 = ^select_800[5:3];
  logic parity_812;
  assign parity_812 = ^select_800[8:0];
  logic parity_818;
  assign parity_818 = ^select_800[11:9];
  logic parity_821;
  assign parity_821 = ^select_783[2:0];
  logic parity_824;
  assign parity_824 = ^{select_800[11:9], select_783[5:0]};
  logic parity_827;
  assign parity_827 = ^{select_800, select_783, select_760[2:0]};
  logic xor_828;
  assign xor_828 = parity_772 ^ parity_827;
  // hls/stages/count_bits.hpp:23
  logic or_832;
  assign or_832 = (select_760[1:0] == 2'h3) | (select_760[2] & (select_760[0] | select_760[1]));
  // hls/stages/count_bits.hpp:25
  logic or_836;
  assign or_836 = (select_783[7:6] == 2'h3) | (select_783[8] & (select_783[6] | select_783[7]));
  logic or_840;
  assign or_840 = (select_783[10:9] == 2'h3) | (select_783[11] & (select_783[9] | select_783[10]));
  // hls/stages/count_bits.hpp:23
  logic or_848;
  assign or_848 = (select_800[7:6] == 2'h3) | (select_800[8] & (~(select_800[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_852;
  assign or_852 = (select_800[1:0] == 2'h3) | (select_800[2] & (select_800[0] | select_800[1]));
  logic or_856;
  assign or_856 = (select_800[4:3] == 2'h3) | (select_800[5] & (select_800[3] | select_800[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_859;
  assign parity_859 = ^{or_856, or_852, or_848};
  // hls/stages/count_bits.hpp:23
  logic or_863;
  assign or_863 = (select_783[4:3] == 2'h3) | (select_783[5] & (select_783[3] | select_783[4]));
  // hls/stages/count_bits.hpp:25
  logic or_867;
  assign or_867 = (select_800[10:9] == 2'h3) | (select_800[11] & (select_800[9] | select_800[10]));
  logic or_871;
  assign or_871 = (select_783[1:0] == 2'h3) | (select_783[2] & (select_783[0] | select_783[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_874;
  assign parity_874 = ^{or_871, or_867, or_863};
  logic parity_877;
  assign parity_877 = ^{or_871, or_867, or_863, or_856, or_852, or_848, or_840, or_836, or_832};
  // hls/stages/count_bits.hpp:25
  logic and_878;
  assign and_878 = parity_772 & parity_827;
  logic or_882;
  assign or_882 = (parity_766 & parity_769) | ((^select_760[11:9]) & (parity_766 | parity_769));
  logic and_885;
  assign and_885 = (^{select_783[11:6], select_760[2:0]}) & (parity_812 | parity_824);
  logic or_886;
  assign or_886 = (parity_812 & parity_824) | and_885;
  // hls/stages/count_bits.hpp:23
  logic or_893;
  assign or_893 = (select_760[10:9] == 2'h3) | (select_760[11] & (select_760[9] | select_760[10]));
  // hls/stages/count_bits.hpp:25
  logic or_897;
  assign or_897 = (select_760[4:3] == 2'h3) | (select_760[5] & (select_760[3] | select_760[4]));
  logic or_901;
  assign or_901 = (select_760[7:6] == 2'h3) | (select_760[8] & (select_760[6] | select_760[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_904;
  assign parity_904 = ^{or_901, or_897, or_893};
  // hls/stages/count_bits.hpp:25
  logic or_908;
  assign or_908 = (parity_786 & parity_789) | ((^select_760[2:0]) & (parity_786 | parity_789));
  logic or_912;
  assign or_912 = (parity_806 & parity_809) | ((^select_800[8:6]) & (parity_806 | parity_809));
  logic or_916;
  assign or_916 = (parity_818 & parity_821) | ((^select_783[5:3]) & (parity_818 | parity_821));
  // hls/stages/count_bits.hpp:24
  logic parity_919;
  assign parity_919 = ^{or_916, or_912, or_908};
  logic parity_922;
  assign parity_922 = ^{or_916, or_912, or_908, or_901, or_897, or_893, or_886, or_882, and_878};
  logic xor_923;
  assign xor_923 = parity_877 ^ parity_922;
  // hls/stages/count_bits.hpp:25
  logic and_924;
  assign and_924 = parity_877 & parity_922;
  logic or_928;
  assign or_928 = (parity_859 & parity_874) | ((^{or_840, or_836, or_832}) & (parity_859 | parity_874));
  logic or_932;
  assign or_932 = (parity_904 & parity_919) | ((^{or_886, or_882, and_878}) & (parity_904 | parity_919));
  logic or_939;
  assign or_939 = (or_836 & or_840) | (or_832 & (or_836 | or_840));
  logic or_943;
  assign or_943 = (or_852 & or_856) | (or_848 & (or_852 | or_856));
  logic or_947;
  assign or_947 = (or_867 & or_871) | (or_863 & (or_867 | or_871));
  // hls/stages/count_bits.hpp:24
  logic parity_950;
  assign parity_950 = ^{or_947, or_943, or_939};
  // hls/stages/count_bits.hpp:25
  logic or_954;
  assign or_954 = (or_882 & or_886) | (and_878 & (or_882 | or_886));
  logic or_958;
  assign or_958 = (or_897 & or_901) | (or_893 & (or_897 | or_901));
  logic or_962;
  assign or_962 = (or_912 & or_916) | (or_908 & (or_912 | or_916));
  // hls/stages/count_bits.hpp:24
  logic parity_965;
  assign parity_965 = ^{or_962, or_958, or_954};
  logic parity_968;
  assign parity_968 = ^{or_962, or_958, or_954, or_947, or_943, or_939, or_932, or_928, and_924};
  // hls/stages/count_bits.hpp:25
  logic or_972;
  assign or_972 = (parity_950 & parity_965) | ((^{or_932, or_928, and_924}) & (parity_950 | parity_965));
  logic or_976;
  assign or_976 = (or_928 & or_932) | (and_924 & (or_928 | or_932));
  logic or_980;
  assign or_980 = (or_943 & or_947) | (or_939 & (or_943 | or_947));
  logic or_984;
  assign or_984 = (or_958 & or_962) | (or_954 & (or_958 | or_962));
  // hls/stages/count_bits.hpp:24
  logic parity_989;
  assign parity_989 = ^{or_984, or_980, or_976, or_972};
  // hls/stages/count_bits.hpp:25
  logic or_993;
  assign or_993 = (or_980 & or_984) | (or_976 & (or_980 | or_984));
  logic and_994;
  assign and_994 = or_972 & (^{or_984, or_980, or_976});
  // hls/stages/count_bits.hpp:24
  logic xor_995;
  assign xor_995 = or_993 ^ and_994;
  // hls/stages/count_bits.hpp:27
  logic and_996;
  assign and_996 = or_993 & and_994;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_997;
  assign select_997 = equal_584_s1_q ? {and_996, xor_995, parity_989, parity_968, xor_923, xor_828} : 6'h0;
  logic [5:0] column;
  assign column = or_570_s1_q ? 6'h0 : select_997;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_999;
  assign select_999 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1000;
  assign difference_1000 = {1'b0, column} - {1'b0, select_999};
  logic [7:0] sum_1002;
  assign sum_1002 = {difference_1000[6], difference_1000} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1006;
  assign select_1006 = and_753 ? (and_777 ? (~(select_755 ^ select_779)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1012;
  assign parity_1012 = ^select_1006[5:3];
  logic parity_1015;
  assign parity_1015 = ^select_1006[8:6];
  logic parity_1018;
  assign parity_1018 = ^select_1006[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1025;
  assign select_1025 = and_776 ? (and_794 ? (~(select_778 ^ select_796)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1028;
  assign parity_1028 = ^select_1025[8:6];
  logic parity_1031;
  assign parity_1031 = ^select_1025[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1035;
  assign and_1035 = right_codes_rdata_q[85] & not_574_s1_q;
  logic [11:0] select_1036;
  assign select_1036 = less_573_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1040;
  assign select_1040 = and_793 ? (and_1035 ? (~(select_795 ^ select_1036)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1046;
  assign parity_1046 = ^select_1040[2:0];
  logic parity_1049;
  assign parity_1049 = ^select_1040[5:3];
  logic parity_1052;
  assign parity_1052 = ^select_1040[8:0];
  logic parity_1058;
  assign parity_1058 = ^select_1040[11:9];
  logic parity_1061;
  assign parity_1061 = ^select_1025[2:0];
  logic parity_1064;
  assign parity_1064 = ^{select_1040[11:9], select_1025[5:0]};
  logic parity_1067;
  assign parity_1067 = ^{select_1040, select_1025, select_1006[2:0]};
  logic xor_1068;
  assign xor_1068 = parity_1018 ^ parity_1067;
  // hls/stages/count_bits.hpp:23
  logic or_1072;
  assign or_1072 = (select_1006[1:0] == 2'h3) | (select_1006[2] & (select_1006[0] | select_1006[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1076;
  assign or_1076 = (select_1025[7:6] == 2'h3) | (select_1025[8] & (select_1025[6] | select_1025[7]));
  logic or_1080;
  assign or_1080 = (select_1025[10:9] == 2'h3) | (select_1025[11] & (select_1025[9] | select_1025[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1088;
  assign or_1088 = (select_1040[7:6] == 2'h3) | (select_1040[8] & (~(select_1040[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1092;
  assign or_1092 = (select_1040[1:0] == 2'h3) | (select_1040[2] & (select_1040[0] | select_1040[1]));
  logic or_1096;
  assign or_1096 = (select_1040[4:3] == 2'h3) | (select_1040[5] & (select_1040[3] | select_1040[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1099;
  assign parity_1099 = ^{or_1096, or_1092, or_1088};
  // hls/stages/count_bits.hpp:23
  logic or_1103;
  assign or_1103 = (select_1025[4:3] == 2'h3) | (select_1025[5] & (select_1025[3] | select_1025[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1107;
  assign or_1107 = (select_1040[10:9] == 2'h3) | (select_1040[11] & (select_1040[9] | select_1040[10]));
  logic or_1111;
  assign or_1111 = (select_1025[1:0] == 2'h3) | (select_1025[2] & (select_1025[0] | select_1025[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1114;
  assign parity_1114 = ^{or_1111, or_1107, or_1103};
  logic parity_1117;
  assign parity_1117 = ^{or_1111, or_1107, or_1103, or_1096, or_1092, or_1088, or_1080, or_1076, or_1072};
  // hls/stages/count_bits.hpp:25
  logic and_1118;
  assign and_1118 = parity_1018 & parity_1067;
  logic or_1122;
  assign or_1122 = (parity_1012 & parity_1015) | ((^select_1006[11:9]) & (parity_1012 | parity_1015));
  logic and_1125;
  assign and_1125 = (^{select_1025[11:6], select_1006[2:0]}) & (parity_1052 | parity_1064);
  logic or_1126;
  assign or_1126 = (parity_1052 & parity_1064) | and_1125;
  // hls/stages/count_bits.hpp:23
  logic or_1133;
  assign or_1133 = (select_1006[10:9] == 2'h3) | (select_1006[11] & (select_1006[9] | select_1006[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = (select_1006[4:3] == 2'h3) | (select_1006[5] & (select_1006[3] | select_1006[4]));
  logic or_1141;
  assign or_1141 = (select_1006[7:6] == 2'h3) | (select_1006[8] & (select_1006[6] | select_1006[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^{or_1141, or_1137, or_1133};
  // hls/stages/count_bits.hpp:25
  logic or_1148;
  assign or_1148 = (parity_1028 & parity_1031) | ((^select_1006[2:0]) & (parity_1028 | parity_1031));
  logic or_1152;
  assign or_1152 = (parity_1046 & parity_1049) | ((^select_1040[8:6]) & (parity_1046 | parity_1049));
  logic or_1156;
  assign or_1156 = (parity_1058 & parity_1061) | ((^select_1025[5:3]) & (parity_1058 | parity_1061));
  // hls/stages/count_bits.hpp:24
  logic parity_1159;
  assign parity_1159 = ^{or_1156, or_1152, or_1148};
  logic parity_1162;
  assign parity_1162 = ^{or_1156, or_1152, or_1148, or_1141, or_1137, or_1133, or_1126, or_1122, and_1118};
  logic xor_1163;
  assign xor_1163 = parity_1117 ^ parity_1162;
  // hls/stages/count_bits.hpp:25
  logic and_1164;
  assign and_1164 = parity_1117 & parity_1162;
  logic or_1168;
  assign or_1168 = (parity_1099 & parity_1114) | ((^{or_1080, or_1076, or_1072}) & (parity_1099 | parity_1114));
  logic or_1172;
  assign or_1172 = (parity_1144 & parity_1159) | ((^{or_1126, or_1122, and_1118}) & (parity_1144 | parity_1159));
  logic or_1179;
  assign or_1179 = (or_1076 & or_1080) | (or_1072 & (or_1076 | or_1080));
  logic or_1183;
  assign or_1183 = (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
  logic or_1187;
  assign or_1187 = (or_1107 & or_1111) | (or_1103 & (or_1107 | or_1111));
  // hls/stages/count_bits.hpp:24
  logic parity_1190;
  assign parity_1190 = ^{or_1187, or_1183, or_1179};
  // hls/stages/count_bits.hpp:25
  logic or_1194;
  assign or_1194 = (or_1122 & or_1126) | (and_1118 & (or_1122 | or_1126));
  logic or_1198;
  assign or_1198 = (or_1137 & or_1141) | (or_1133 & (or_1137 | or_1141));
  logic or_1202;
  assign or_1202 = (or_1152 & or_1156) | (or_1148 & (or_1152 | or_1156));
  // hls/stages/count_bits.hpp:24
  logic parity_1205;
  assign parity_1205 = ^{or_1202, or_1198, or_1194};
  logic parity_1208;
  assign parity_1208 = ^{or_1202, or_1198, or_1194, or_1187, or_1183, or_1179, or_1172, or_1168, and_1164};
  // hls/stages/count_bits.hpp:25
  logic or_1212;
  assign or_1212 = (parity_1190 & parity_1205) | ((^{or_1172, or_1168, and_1164}) & (parity_1190 | parity_1205));
  logic or_1216;
  assign or_1216 = (or_1168 & or_1172) | (and_1164 & (or_1168 | or_1172));
  logic or_1220;
  assign or_1220 = (or_1183 & or_1187) | (or_1179 & (or_1183 | or_1187));
  logic or_1224;
  assign or_1224 = (or_1198 & or_1202) | (or_1194 & (or_1198 | or_1202));
  // hls/stages/count_bits.hpp:24
  logic parity_1229;
  assign parity_1229 = ^{or_1224, or_1220, or_1216, or_1212};
  // hls/stages/count_bits.hpp:25
  logic or_1233;
  assign or_1233 = (or_1220 & or_1224) | (or_1216 & (or_1220 | or_1224));
  logic and_1234;
  assign and_1234 = or_1212 & (^{or_1224, or_1220, or_1216});
  // hls/stages/count_bits.hpp:24
  logic xor_1235;
  assign xor_1235 = or_1233 ^ and_1234;
  // hls/stages/count_bits.hpp:27
  logic and_1236;
  assign and_1236 = or_1233 & and_1234;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1237;
  assign select_1237 = equal_584_s1_q ? {and_1236, xor_1235, parity_1229, parity_1208, xor_1163, xor_1068} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_570_s1_q ? 6'h0 : select_1237;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1239;
  assign select_1239 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1240;
  assign difference_1240 = {1'b0, column_2} - {1'b0, select_1239};
  logic [7:0] sum_1242;
  assign sum_1242 = {difference_1240[6], difference_1240} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1243;
  assign and_1243 = right_codes_rdata_q[27] & not_574_s1_q;
  logic [11:0] select_1244;
  assign select_1244 = less_573_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1248;
  assign select_1248 = and_753 ? (and_1243 ? (~(select_755 ^ select_1244)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1254;
  assign parity_1254 = ^select_1248[5:3];
  logic parity_1257;
  assign parity_1257 = ^select_1248[8:6];
  logic parity_1260;
  assign parity_1260 = ^select_1248[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1267;
  assign select_1267 = and_776 ? (and_754 ? (~(select_778 ^ select_756)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1270;
  assign parity_1270 = ^select_1267[8:6];
  logic parity_1273;
  assign parity_1273 = ^select_1267[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1280;
  assign select_1280 = and_793 ? (and_777 ? (~(select_795 ^ select_779)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1286;
  assign parity_1286 = ^select_1280[2:0];
  logic parity_1289;
  assign parity_1289 = ^select_1280[5:3];
  logic parity_1292;
  assign parity_1292 = ^select_1280[8:0];
  logic parity_1298;
  assign parity_1298 = ^select_1280[11:9];
  logic parity_1301;
  assign parity_1301 = ^select_1267[2:0];
  logic parity_1304;
  assign parity_1304 = ^{select_1280[11:9], select_1267[5:0]};
  logic parity_1307;
  assign parity_1307 = ^{select_1280, select_1267, select_1248[2:0]};
  logic xor_1308;
  assign xor_1308 = parity_1260 ^ parity_1307;
  // hls/stages/count_bits.hpp:23
  logic or_1312;
  assign or_1312 = (select_1248[1:0] == 2'h3) | (select_1248[2] & (select_1248[0] | select_1248[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1316;
  assign or_1316 = (select_1267[7:6] == 2'h3) | (select_1267[8] & (select_1267[6] | select_1267[7]));
  logic or_1320;
  assign or_1320 = (select_1267[10:9] == 2'h3) | (select_1267[11] & (select_1267[9] | select_1267[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1328;
  assign or_1328 = (select_1280[7:6] == 2'h3) | (select_1280[8] & (~(select_1280[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1332;
  assign or_1332 = (select_1280[1:0] == 2'h3) | (select_1280[2] & (select_1280[0] | select_1280[1]));
  logic or_1336;
  assign or_1336 = (select_1280[4:3] == 2'h3) | (select_1280[5] & (select_1280[3] | select_1280[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1339;
  assign parity_1339 = ^{or_1336, or_1332, or_1328};
  // hls/stages/count_bits.hpp:23
  logic or_1343;
  assign or_1343 = (select_1267[4:3] == 2'h3) | (select_1267[5] & (select_1267[3] | select_1267[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1347;
  assign or_1347 = (select_1280[10:9] == 2'h3) | (select_1280[11] & (select_1280[9] | select_1280[10]));
  logic or_1351;
  assign or_1351 = (select_1267[1:0] == 2'h3) | (select_1267[2] & (select_1267[0] | select_1267[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1354;
  assign parity_1354 = ^{or_1351, or_1347, or_1343};
  logic parity_1357;
  assign parity_1357 = ^{or_1351, or_1347, or_1343, or_1336, or_1332, or_1328, or_1320, or_1316, or_1312};
  // hls/stages/count_bits.hpp:25
  logic and_1358;
  assign and_1358 = parity_1260 & parity_1307;
  logic or_1362;
  assign or_1362 = (parity_1254 & parity_1257) | ((^select_1248[11:9]) & (parity_1254 | parity_1257));
  logic and_1365;
  assign and_1365 = (^{select_1267[11:6], select_1248[2:0]}) & (parity_1292 | parity_1304);
  logic or_1366;
  assign or_1366 = (parity_1292 & parity_1304) | and_1365;
  // hls/stages/count_bits.hpp:23
  logic or_1373;
  assign or_1373 = (select_1248[10:9] == 2'h3) | (select_1248[11] & (select_1248[9] | select_1248[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1377;
  assign or_1377 = (select_1248[4:3] == 2'h3) | (select_1248[5] & (select_1248[3] | select_1248[4]));
  logic or_1381;
  assign or_1381 = (select_1248[7:6] == 2'h3) | (select_1248[8] & (select_1248[6] | select_1248[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1384;
  assign parity_1384 = ^{or_1381, or_1377, or_1373};
  // hls/stages/count_bits.hpp:25
  logic or_1388;
  assign or_1388 = (parity_1270 & parity_1273) | ((^select_1248[2:0]) & (parity_1270 | parity_1273));
  logic or_1392;
  assign or_1392 = (parity_1286 & parity_1289) | ((^select_1280[8:6]) & (parity_1286 | parity_1289));
  logic or_1396;
  assign or_1396 = (parity_1298 & parity_1301) | ((^select_1267[5:3]) & (parity_1298 | parity_1301));
  // hls/stages/count_bits.hpp:24
  logic parity_1399;
  assign parity_1399 = ^{or_1396, or_1392, or_1388};
  logic parity_1402;
  assign parity_1402 = ^{or_1396, or_1392, or_1388, or_1381, or_1377, or_1373, or_1366, or_1362, and_1358};
  logic xor_1403;
  assign xor_1403 = parity_1357 ^ parity_1402;
  // hls/stages/count_bits.hpp:25
  logic and_1404;
  assign and_1404 = parity_1357 & parity_1402;
  logic or_1408;
  assign or_1408 = (parity_1339 & parity_1354) | ((^{or_1320, or_1316, or_1312}) & (parity_1339 | parity_1354));
  logic or_1412;
  assign or_1412 = (parity_1384 & parity_1399) | ((^{or_1366, or_1362, and_1358}) & (parity_1384 | parity_1399));
  logic or_1419;
  assign or_1419 = (or_1316 & or_1320) | (or_1312 & (or_1316 | or_1320));
  logic or_1423;
  assign or_1423 = (or_1332 & or_1336) | (or_1328 & (or_1332 | or_1336));
  logic or_1427;
  assign or_1427 = (or_1347 & or_1351) | (or_1343 & (or_1347 | or_1351));
  // hls/stages/count_bits.hpp:24
  logic parity_1430;
  assign parity_1430 = ^{or_1427, or_1423, or_1419};
  // hls/stages/count_bits.hpp:25
  logic or_1434;
  assign or_1434 = (or_1362 & or_1366) | (and_1358 & (or_1362 | or_1366));
  logic or_1438;
  assign or_1438 = (or_1377 & or_1381) | (or_1373 & (or_1377 | or_1381));
  logic or_1442;
  assign or_1442 = (or_1392 & or_1396) | (or_1388 & (or_1392 | or_1396));
  // hls/stages/count_bits.hpp:24
  logic parity_1445;
  assign parity_1445 = ^{or_1442, or_1438, or_1434};
  logic parity_1448;
  assign parity_1448 = ^{or_1442, or_1438, or_1434, or_1427, or_1423, or_1419, or_1412, or_1408, and_1404};
  // hls/stages/count_bits.hpp:25
  logic or_1452;
  assign or_1452 = (parity_1430 & parity_1445) | ((^{or_1412, or_1408, and_1404}) & (parity_1430 | parity_1445));
  logic or_1456;
  assign or_1456 = (or_1408 & or_1412) | (and_1404 & (or_1408 | or_1412));
  logic or_1460;
  assign or_1460 = (or_1423 & or_1427) | (or_1419 & (or_1423 | or_1427));
  logic or_1464;
  assign or_1464 = (or_1438 & or_1442) | (or_1434 & (or_1438 | or_1442));
  // hls/stages/count_bits.hpp:24
  logic parity_1469;
  assign parity_1469 = ^{or_1464, or_1460, or_1456, or_1452};
  // hls/stages/count_bits.hpp:25
  logic or_1473;
  assign or_1473 = (or_1460 & or_1464) | (or_1456 & (or_1460 | or_1464));
  logic and_1474;
  assign and_1474 = or_1452 & (^{or_1464, or_1460, or_1456});
  // hls/stages/count_bits.hpp:24
  logic xor_1475;
  assign xor_1475 = or_1473 ^ and_1474;
  // hls/stages/count_bits.hpp:27
  logic and_1476;
  assign and_1476 = or_1473 & and_1474;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1477;
  assign select_1477 = equal_584_s1_q ? {and_1476, xor_1475, parity_1469, parity_1448, xor_1403, xor_1308} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_570_s1_q ? 6'h0 : select_1477;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1479;
  assign select_1479 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1480;
  assign difference_1480 = {1'b0, column_3} - {1'b0, select_1479};
  logic [7:0] sum_1482;
  assign sum_1482 = {difference_1480[6], difference_1480} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1490;
  assign select_1490 = and_753 ? (and_794 ? (~(select_755 ^ select_796)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1496;
  assign parity_1496 = ^select_1490[5:3];
  logic parity_1499;
  assign parity_1499 = ^select_1490[8:6];
  logic parity_1502;
  assign parity_1502 = ^select_1490[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1509;
  assign select_1509 = and_776 ? (and_1035 ? (~(select_778 ^ select_1036)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1512;
  assign parity_1512 = ^select_1509[8:6];
  logic parity_1515;
  assign parity_1515 = ^select_1509[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] xor_1521;
  assign xor_1521 = select_795 ^ (less_573_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1524;
  assign select_1524 = and_793 ? ((right_codes_rdata_q[98] & not_574_s1_q) ? (~xor_1521) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1530;
  assign parity_1530 = ^select_1524[2:0];
  logic parity_1533;
  assign parity_1533 = ^select_1524[5:3];
  logic parity_1536;
  assign parity_1536 = ^select_1524[8:0];
  logic parity_1542;
  assign parity_1542 = ^select_1524[11:9];
  logic parity_1545;
  assign parity_1545 = ^select_1509[2:0];
  logic parity_1548;
  assign parity_1548 = ^{select_1524[11:9], select_1509[5:0]};
  logic parity_1551;
  assign parity_1551 = ^{select_1524, select_1509, select_1490[2:0]};
  logic xor_1552;
  assign xor_1552 = parity_1502 ^ parity_1551;
  // hls/stages/count_bits.hpp:23
  logic or_1556;
  assign or_1556 = (select_1490[1:0] == 2'h3) | (select_1490[2] & (select_1490[0] | select_1490[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1560;
  assign or_1560 = (select_1509[7:6] == 2'h3) | (select_1509[8] & (select_1509[6] | select_1509[7]));
  logic or_1564;
  assign or_1564 = (select_1509[10:9] == 2'h3) | (select_1509[11] & (select_1509[9] | select_1509[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1572;
  assign or_1572 = (select_1524[7:6] == 2'h3) | (select_1524[8] & (~(select_1524[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1576;
  assign or_1576 = (select_1524[1:0] == 2'h3) | (select_1524[2] & (select_1524[0] | select_1524[1]));
  logic or_1580;
  assign or_1580 = (select_1524[4:3] == 2'h3) | (select_1524[5] & (select_1524[3] | select_1524[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1583;
  assign parity_1583 = ^{or_1580, or_1576, or_1572};
  // hls/stages/count_bits.hpp:23
  logic or_1587;
  assign or_1587 = (select_1509[4:3] == 2'h3) | (select_1509[5] & (select_1509[3] | select_1509[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1591;
  assign or_1591 = (select_1524[10:9] == 2'h3) | (select_1524[11] & (select_1524[9] | select_1524[10]));
  logic or_1595;
  assign or_1595 = (select_1509[1:0] == 2'h3) | (select_1509[2] & (select_1509[0] | select_1509[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1598;
  assign parity_1598 = ^{or_1595, or_1591, or_1587};
  logic parity_1601;
  assign parity_1601 = ^{or_1595, or_1591, or_1587, or_1580, or_1576, or_1572, or_1564, or_1560, or_1556};
  // hls/stages/count_bits.hpp:25
  logic and_1602;
  assign and_1602 = parity_1502 & parity_1551;
  logic or_1606;
  assign or_1606 = (parity_1496 & parity_1499) | ((^select_1490[11:9]) & (parity_1496 | parity_1499));
  logic and_1609;
  assign and_1609 = (^{select_1509[11:6], select_1490[2:0]}) & (parity_1536 | parity_1548);
  logic or_1610;
  assign or_1610 = (parity_1536 & parity_1548) | and_1609;
  // hls/stages/count_bits.hpp:23
  logic or_1617;
  assign or_1617 = (select_1490[10:9] == 2'h3) | (select_1490[11] & (select_1490[9] | select_1490[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1621;
  assign or_1621 = (select_1490[4:3] == 2'h3) | (select_1490[5] & (select_1490[3] | select_1490[4]));
  logic or_1625;
  assign or_1625 = (select_1490[7:6] == 2'h3) | (select_1490[8] & (select_1490[6] | select_1490[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1628;
  assign parity_1628 = ^{or_1625, or_1621, or_1617};
  // hls/stages/count_bits.hpp:25
  logic or_1632;
  assign or_1632 = (parity_1512 & parity_1515) | ((^select_1490[2:0]) & (parity_1512 | parity_1515));
  logic or_1636;
  assign or_1636 = (parity_1530 & parity_1533) | ((^select_1524[8:6]) & (parity_1530 | parity_1533));
  logic or_1640;
  assign or_1640 = (parity_1542 & parity_1545) | ((^select_1509[5:3]) & (parity_1542 | parity_1545));
  // hls/stages/count_bits.hpp:24
  logic parity_1643;
  assign parity_1643 = ^{or_1640, or_1636, or_1632};
  logic parity_1646;
  assign parity_1646 = ^{or_1640, or_1636, or_1632, or_1625, or_1621, or_1617, or_1610, or_1606, and_1602};
  logic xor_1647;
  assign xor_1647 = parity_1601 ^ parity_1646;
  // hls/stages/count_bits.hpp:25
  logic and_1648;
  assign and_1648 = parity_1601 & parity_1646;
  logic or_1652;
  assign or_1652 = (parity_1583 & parity_1598) | ((^{or_1564, or_1560, or_1556}) & (parity_1583 | parity_1598));
  logic or_1656;
  assign or_1656 = (parity_1628 & parity_1643) | ((^{or_1610, or_1606, and_1602}) & (parity_1628 | parity_1643));
  logic or_1663;
  assign or_1663 = (or_1560 & or_1564) | (or_1556 & (or_1560 | or_1564));
  logic or_1667;
  assign or_1667 = (or_1576 & or_1580) | (or_1572 & (or_1576 | or_1580));
  logic or_1671;
  assign or_1671 = (or_1591 & or_1595) | (or_1587 & (or_1591 | or_1595));
  // hls/stages/count_bits.hpp:24
  logic parity_1674;
  assign parity_1674 = ^{or_1671, or_1667, or_1663};
  // hls/stages/count_bits.hpp:25
  logic or_1678;
  assign or_1678 = (or_1606 & or_1610) | (and_1602 & (or_1606 | or_1610));
  logic or_1682;
  assign or_1682 = (or_1621 & or_1625) | (or_1617 & (or_1621 | or_1625));
  logic or_1686;
  assign or_1686 = (or_1636 & or_1640) | (or_1632 & (or_1636 | or_1640));
  // hls/stages/count_bits.hpp:24
  logic parity_1689;
  assign parity_1689 = ^{or_1686, or_1682, or_1678};
  logic parity_1692;
  assign parity_1692 = ^{or_1686, or_1682, or_1678, or_1671, or_1667, or_1663, or_1656, or_1652, and_1648};
  // hls/stages/count_bits.hpp:25
  logic or_1696;
  assign or_1696 = (parity_1674 & parity_1689) | ((^{or_1656, or_1652, and_1648}) & (parity_1674 | parity_1689));
  logic or_1700;
  assign or_1700 = (or_1652 & or_1656) | (and_1648 & (or_1652 | or_1656));
  logic or_1704;
  assign or_1704 = (or_1667 & or_1671) | (or_1663 & (or_1667 | or_1671));
  logic or_1708;
  assign or_1708 = (or_1682 & or_1686) | (or_1678 & (or_1682 | or_1686));
  // hls/stages/count_bits.hpp:24
  logic parity_1713;
  assign parity_1713 = ^{or_1708, or_1704, or_1700, or_1696};
  // hls/stages/count_bits.hpp:25
  logic or_1717;
  assign or_1717 = (or_1704 & or_1708) | (or_1700 & (or_1704 | or_1708));
  logic and_1718;
  assign and_1718 = or_1696 & (^{or_1708, or_1704, or_1700});
  // hls/stages/count_bits.hpp:24
  logic xor_1719;
  assign xor_1719 = or_1717 ^ and_1718;
  // hls/stages/count_bits.hpp:27
  logic and_1720;
  assign and_1720 = or_1717 & and_1718;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1721;
  assign select_1721 = equal_584_s1_q ? {and_1720, xor_1719, parity_1713, parity_1692, xor_1647, xor_1552} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_570_s1_q ? 6'h0 : select_1721;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1723;
  assign select_1723 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1724;
  assign difference_1724 = {1'b0, column_4} - {1'b0, select_1723};
  logic [7:0] sum_1726;
  assign sum_1726 = {difference_1724[6], difference_1724} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] not_1730;
  assign not_1730 = ~(select_755 ^ (less_573_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1732;
  assign select_1732 = and_753 ? ((right_codes_rdata_q[12] & not_574_s1_q) ? not_1730 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1738;
  assign parity_1738 = ^select_1732[5:3];
  logic parity_1741;
  assign parity_1741 = ^select_1732[8:6];
  logic parity_1744;
  assign parity_1744 = ^select_1732[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1751;
  assign select_1751 = and_776 ? (and_1243 ? (~(select_778 ^ select_1244)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1754;
  assign parity_1754 = ^select_1751[8:6];
  logic parity_1757;
  assign parity_1757 = ^select_1751[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1764;
  assign select_1764 = and_793 ? (and_754 ? (~(select_795 ^ select_756)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1770;
  assign parity_1770 = ^select_1764[2:0];
  logic parity_1773;
  assign parity_1773 = ^select_1764[5:3];
  logic parity_1776;
  assign parity_1776 = ^select_1764[8:0];
  logic parity_1782;
  assign parity_1782 = ^select_1764[11:9];
  logic parity_1785;
  assign parity_1785 = ^select_1751[2:0];
  logic parity_1788;
  assign parity_1788 = ^{select_1764[11:9], select_1751[5:0]};
  logic parity_1791;
  assign parity_1791 = ^{select_1764, select_1751, select_1732[2:0]};
  logic xor_1792;
  assign xor_1792 = parity_1744 ^ parity_1791;
  // hls/stages/count_bits.hpp:23
  logic or_1796;
  assign or_1796 = (select_1732[1:0] == 2'h3) | (select_1732[2] & (select_1732[0] | select_1732[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1800;
  assign or_1800 = (select_1751[7:6] == 2'h3) | (select_1751[8] & (select_1751[6] | select_1751[7]));
  logic or_1804;
  assign or_1804 = (select_1751[10:9] == 2'h3) | (select_1751[11] & (select_1751[9] | select_1751[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1812;
  assign or_1812 = (select_1764[7:6] == 2'h3) | (select_1764[8] & (~(select_1764[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1816;
  assign or_1816 = (select_1764[1:0] == 2'h3) | (select_1764[2] & (select_1764[0] | select_1764[1]));
  logic or_1820;
  assign or_1820 = (select_1764[4:3] == 2'h3) | (select_1764[5] & (select_1764[3] | select_1764[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1823;
  assign parity_1823 = ^{or_1820, or_1816, or_1812};
  // hls/stages/count_bits.hpp:23
  logic or_1827;
  assign or_1827 = (select_1751[4:3] == 2'h3) | (select_1751[5] & (select_1751[3] | select_1751[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1831;
  assign or_1831 = (select_1764[10:9] == 2'h3) | (select_1764[11] & (select_1764[9] | select_1764[10]));
  logic or_1835;
  assign or_1835 = (select_1751[1:0] == 2'h3) | (select_1751[2] & (select_1751[0] | select_1751[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1838;
  assign parity_1838 = ^{or_1835, or_1831, or_1827};
  logic parity_1841;
  assign parity_1841 = ^{or_1835, or_1831, or_1827, or_1820, or_1816, or_1812, or_1804, or_1800, or_1796};
  // hls/stages/count_bits.hpp:25
  logic and_1842;
  assign and_1842 = parity_1744 & parity_1791;
  logic or_1846;
  assign or_1846 = (parity_1738 & parity_1741) | ((^select_1732[11:9]) & (parity_1738 | parity_1741));
  logic and_1849;
  assign and_1849 = (^{select_1751[11:6], select_1732[2:0]}) & (parity_1776 | parity_1788);
  logic or_1850;
  assign or_1850 = (parity_1776 & parity_1788) | and_1849;
  // hls/stages/count_bits.hpp:23
  logic or_1857;
  assign or_1857 = (select_1732[10:9] == 2'h3) | (select_1732[11] & (select_1732[9] | select_1732[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1861;
  assign or_1861 = (select_1732[4:3] == 2'h3) | (select_1732[5] & (select_1732[3] | select_1732[4]));
  logic or_1865;
  assign or_1865 = (select_1732[7:6] == 2'h3) | (select_1732[8] & (select_1732[6] | select_1732[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1868;
  assign parity_1868 = ^{or_1865, or_1861, or_1857};
  // hls/stages/count_bits.hpp:25
  logic or_1872;
  assign or_1872 = (parity_1754 & parity_1757) | ((^select_1732[2:0]) & (parity_1754 | parity_1757));
  logic or_1876;
  assign or_1876 = (parity_1770 & parity_1773) | ((^select_1764[8:6]) & (parity_1770 | parity_1773));
  logic or_1880;
  assign or_1880 = (parity_1782 & parity_1785) | ((^select_1751[5:3]) & (parity_1782 | parity_1785));
  // hls/stages/count_bits.hpp:24
  logic parity_1883;
  assign parity_1883 = ^{or_1880, or_1876, or_1872};
  logic parity_1886;
  assign parity_1886 = ^{or_1880, or_1876, or_1872, or_1865, or_1861, or_1857, or_1850, or_1846, and_1842};
  logic xor_1887;
  assign xor_1887 = parity_1841 ^ parity_1886;
  // hls/stages/count_bits.hpp:25
  logic and_1888;
  assign and_1888 = parity_1841 & parity_1886;
  logic or_1892;
  assign or_1892 = (parity_1823 & parity_1838) | ((^{or_1804, or_1800, or_1796}) & (parity_1823 | parity_1838));
  logic or_1896;
  assign or_1896 = (parity_1868 & parity_1883) | ((^{or_1850, or_1846, and_1842}) & (parity_1868 | parity_1883));
  logic or_1903;
  assign or_1903 = (or_1800 & or_1804) | (or_1796 & (or_1800 | or_1804));
  logic or_1907;
  assign or_1907 = (or_1816 & or_1820) | (or_1812 & (or_1816 | or_1820));
  logic or_1911;
  assign or_1911 = (or_1831 & or_1835) | (or_1827 & (or_1831 | or_1835));
  // hls/stages/count_bits.hpp:24
  logic parity_1914;
  assign parity_1914 = ^{or_1911, or_1907, or_1903};
  // hls/stages/count_bits.hpp:25
  logic or_1918;
  assign or_1918 = (or_1846 & or_1850) | (and_1842 & (or_1846 | or_1850));
  logic or_1922;
  assign or_1922 = (or_1861 & or_1865) | (or_1857 & (or_1861 | or_1865));
  logic or_1926;
  assign or_1926 = (or_1876 & or_1880) | (or_1872 & (or_1876 | or_1880));
  // hls/stages/count_bits.hpp:24
  logic parity_1929;
  assign parity_1929 = ^{or_1926, or_1922, or_1918};
  logic parity_1932;
  assign parity_1932 = ^{or_1926, or_1922, or_1918, or_1911, or_1907, or_1903, or_1896, or_1892, and_1888};
  // hls/stages/count_bits.hpp:25
  logic or_1936;
  assign or_1936 = (parity_1914 & parity_1929) | ((^{or_1896, or_1892, and_1888}) & (parity_1914 | parity_1929));
  logic or_1940;
  assign or_1940 = (or_1892 & or_1896) | (and_1888 & (or_1892 | or_1896));
  logic or_1944;
  assign or_1944 = (or_1907 & or_1911) | (or_1903 & (or_1907 | or_1911));
  logic or_1948;
  assign or_1948 = (or_1922 & or_1926) | (or_1918 & (or_1922 | or_1926));
  // hls/stages/count_bits.hpp:24
  logic parity_1953;
  assign parity_1953 = ^{or_1948, or_1944, or_1940, or_1936};
  // hls/stages/count_bits.hpp:25
  logic or_1957;
  assign or_1957 = (or_1944 & or_1948) | (or_1940 & (or_1944 | or_1948));
  logic and_1958;
  assign and_1958 = or_1936 & (^{or_1948, or_1944, or_1940});
  // hls/stages/count_bits.hpp:24
  logic xor_1959;
  assign xor_1959 = or_1957 ^ and_1958;
  // hls/stages/count_bits.hpp:27
  logic and_1960;
  assign and_1960 = or_1957 & and_1958;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1961;
  assign select_1961 = equal_584_s1_q ? {and_1960, xor_1959, parity_1953, parity_1932, xor_1887, xor_1792} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_570_s1_q ? 6'h0 : select_1961;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1963;
  assign select_1963 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1964;
  assign difference_1964 = {1'b0, column_5} - {1'b0, select_1963};
  logic [7:0] sum_1966;
  assign sum_1966 = {difference_1964[6], difference_1964} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_2037;
  assign and_2037 = ends_cell_s1_q & inside_v;
  logic and_2039;
  assign and_2039 = not_566 & (so_s1_q & and_2037);
  logic [6:0] select_2043;
  assign select_2043 = so_s1_q ? x_s1_q[6:0] : (or_570_s1_q ? (less_573_s1_q ? 7'h0 : select_617) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2047;
  assign or_2047 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2056;
  assign and_2056 = or_570_s1_q & (slot_s1_q[2] & not_574_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2169;
  assign select_2169 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2169[16:7])) ? 8'h7f : select_2169[7:0];
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_2246_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2246_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:501
  logic less_2333;
  assign less_2333 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:502
  logic or_2334;
  assign or_2334 = equal_2245_s1_q | less_2333;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2339;
  assign select_2339 = equal_2245_s1_q ? patches_column_s1_q[0] : (or_2334 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2340;
  assign not_2340 = ~or_2334;
  // hls/stages/patches.hpp:502
  logic [4:0] sum_2341;
  assign sum_2341 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:504
  logic [4:0] select_2344;
  assign select_2344 = or_2334 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2341) + 5'h1) : sum_2341;
  // hls/stages/patches.hpp:506
  logic [4:0] select_2345;
  assign select_2345 = equal_2245_s1_q ? 5'h0 : select_2344;
  logic or_2346;
  assign or_2346 = equal_2245_s1_q | equal_2243_s1_q;
  // hls/stages/patches.hpp:482
  logic equal_2348;
  assign equal_2348 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2350;
  assign equal_2350 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_2352;
  assign and_2352 = of_row & (~equal_2350);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2348 ? 2'h3 : {equal_2350, and_2352};
  // hls/stages/patches.hpp:470
  logic [8:0] sum_2355;
  assign sum_2355 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2356;
  assign sum_2356 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2355, pixel_2[0]} - {1'b0, sum_2356, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_2358;
  assign sum_2358 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2359;
  assign sum_2359 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2358[11], sum_2358};
  logic [13:0] sum_2360;
  assign sum_2360 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2359, down_2[1]};
  logic [12:0] sum_2361;
  assign sum_2361 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2360[13:1];
  logic [14:0] sum_2362;
  assign sum_2362 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2361, sum_2360[0], down_2[0]};
  // hls/stages/patches.hpp:454
  logic or_2369;
  assign or_2369 = (sum_2362[8] & (~(sum_2362[7:0] == 8'h0))) | (~(sum_2362[13:9] == 5'h0));
  // hls/stages/patches.hpp:468
  logic [8:0] sum_2374;
  assign sum_2374 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2375;
  assign sum_2375 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2374};
  logic [10:0] sum_2376;
  assign sum_2376 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2375, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2377;
  assign sum_2377 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2376[10:1];
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_2377, sum_2376[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:471
  logic [12:0] sum_2379;
  assign sum_2379 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2380;
  assign sum_2380 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2381;
  assign difference_2381 = {1'b0, sum_2379, smooth[0]} - {1'b0, sum_2380, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:454
  logic or_2388;
  assign or_2388 = (difference_2381[8] & (~(difference_2381[7:0] == 8'h0))) | (~(difference_2381[13:9] == 5'h0));
  // hls/stages/patches.hpp:483
  logic or_2396;
  assign or_2396 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2350) | equal_2348;
  // hls/stages/patches.hpp:478
  logic and_2401;
  assign and_2401 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:185
  logic and_2405;
  assign and_2405 = not_2244_s1_q & (or_2247_s1_q & (or_2396 & (equal_2246_s1_q & and_2401)));
  // hls/stages/patches.hpp:173
  logic and_2415;
  assign and_2415 = (~(equal_2246_s1_q | (~and_2401))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:185
  logic and_2419;
  assign and_2419 = not_2244_s1_q & (or_2247_s1_q & (and_2415 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:547
  logic less_2421;
  assign less_2421 = patches_step_q[4:0] < 5'h11;
  logic equal_2422;
  assign equal_2422 = patches_step_q[6:5] == 2'h0;
  logic not_2423;
  assign not_2423 = ~equal_2422;
  logic equal_2424;
  assign equal_2424 = patches_step_q[6:5] == 2'h3;
  logic not_2425;
  assign not_2425 = ~equal_2424;
  // hls/stages/patches.hpp:561
  logic select_2428;
  assign select_2428 = equal_2424 ? (less_2421 & (less_2421 & not_2425)) : less_2421;
  // hls/stages/patches.hpp:185
  logic and_2431;
  assign and_2431 = equal_2241_s1_q & (less_2421 ? (not_2423 & select_2428) : select_2428);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2453;
  assign sum_2453 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2739;
  assign or_2739 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:460
  logic select_3023;
  assign select_3023 = equal_2929_s1_q ? (~({row_s1_q, 1'b0} < {sum_3020, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3267;
  assign and_3267 = and_540_s1_q & (equal_2929_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3268;
  assign and_3268 = and_2930_s1_q & and_3267;
  // hls/stages/registration.hpp:127
  logic and_3270;
  assign and_3270 = and_2930_s1_q & (~and_3267);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3271;
  assign select_3271 = and_3270 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3273;
  assign select_3273 = and_3268 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3271[15]}}, select_3271});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3274;
  assign select_3274 = and_3270 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3274[15]}}, select_3274};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3276;
  assign select_3276 = and_3268 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3277;
  assign and_3277 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3277 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:188
  logic select_3522;
  assign select_3522 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3525;
  assign select_3525 = equal_2243_s1_q ? patches_smooth_values_0_q : (or_2247_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3527;
  assign select_3527 = or_2247_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3529;
  assign select_3529 = equal_2241_s1_q ? patches_smooth_values_1_q : (equal_2243_s1_q ? patches_smooth_values_1_q : select_3527);
  logic [11:0] select_3530;
  assign select_3530 = or_2247_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3532;
  assign select_3532 = equal_2241_s1_q ? patches_smooth_values_2_q : (equal_2243_s1_q ? patches_smooth_values_2_q : select_3530);
  logic [11:0] select_3533;
  assign select_3533 = or_2247_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3535;
  assign select_3535 = equal_2241_s1_q ? patches_smooth_values_3_q : (equal_2243_s1_q ? patches_smooth_values_3_q : select_3533);
  logic [10:0] select_3537;
  assign select_3537 = equal_2243_s1_q ? patches_down_values_0_q : (or_2247_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3540;
  assign select_3540 = equal_2243_s1_q ? patches_down_values_1_q : (or_2247_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3543;
  assign select_3543 = equal_2243_s1_q ? patches_down_values_2_q : (or_2247_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3546;
  assign select_3546 = equal_2243_s1_q ? patches_down_values_3_q : (or_2247_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:176
  logic and_3583;
  assign and_3583 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3588;
  assign select_3588 = or_3483_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3590;
  assign select_3590 = and_3583 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:185
  logic [4:0] select_3946;
  assign select_3946 = equal_2241_s1_q ? patches_summed_down_by_q : (equal_2243_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:557
  logic and_3979;
  assign and_3979 = less_2421 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:561
  logic select_3982;
  assign select_3982 = equal_2424 ? (less_2421 ? (not_2425 & and_3979) : and_3979) : and_3979;
  // hls/stages/patches.hpp:185
  logic select_3985;
  assign select_3985 = equal_2241_s1_q ? (less_2421 ? (not_2423 & select_3982) : select_3982) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4324;
  assign select_4324 = so_s1_q ? (and_3277 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4326;
  assign sum_4326 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4327;
  assign select_4327 = sum_2453[5] ? {1'b1, sum_2453[4:0], region_across_rest_q[2:0]} : sum_4326;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4329;
  assign select_4329 = equal_2929_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4332;
  assign select_4332 = equal_2929_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_505_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_514;
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
  assign census_memory_re = s1_en & and_540_s1_q;
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
  assign moments_memory_raddr = select_564;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_582;
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
  assign best_right_raddr = or_570_s1_q ? select_617 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_608_s1_q;
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
  assign shown_right_re = s1_en & and_2039;
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
  assign left_turns_re = s1_en & and_2056;
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
  assign right_turns_raddr = select_617;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2056;
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
  assign patches_right_codes_raddr = {select_2345, not_2340, select_2339};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2346;
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
  assign patches_left_codes_re = s1_en & (not_2242_s1_q & (new_row & equal_2243_s1_q));
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
  assign patches_rows_re = s1_en & and_2431;
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
  assign seen_columns_re = s1_en & and_2039;
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
  assign left_we = s1_en & and_641_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_742, left_rdata_q[65:49], and_741, left_rdata_q[47:31], and_740, left_rdata_q[29:13], and_739, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_641_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_748, right_codes_rdata_q[84:73], and_747, right_codes_rdata_q[71:60], and_746, right_codes_rdata_q[56:43], and_745, right_codes_rdata_q[41:28], and_744, right_codes_rdata_q[26:13], and_743, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2327_s1_q;
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
      moments_place_q <= select_563;
      moments_taken_q <= not_566 & (not_568 & (equal_569_s1_q & inside_v));
      moments_starts_q <= not_566 & (not_568 & (equal_569_s1_q & (inside_v & first)));
      row_q <= and_540_s1_q ? (equal_2929_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_540_s1_q ? select_3023 : lower_half_q;
      registration_slope_row_q <= select_3273;
      registration_slope_change_q <= select_3276;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3507_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3507_s1_q & select_3522;
      patches_smooth_values_0_q <= equal_2241_s1_q ? patches_smooth_values_0_q : select_3525;
      patches_smooth_values_1_q <= select_3529;
      patches_smooth_values_2_q <= select_3532;
      patches_smooth_values_3_q <= select_3535;
      patches_down_values_0_q <= equal_2241_s1_q ? patches_down_values_0_q : select_3537;
      patches_down_values_1_q <= equal_2241_s1_q ? patches_down_values_1_q : select_3540;
      patches_down_values_2_q <= equal_2241_s1_q ? patches_down_values_2_q : select_3543;
      patches_down_values_3_q <= equal_2241_s1_q ? patches_down_values_3_q : select_3546;
      patches_down_by_q <= or_3483_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3583});
      patches_along_q <= select_3588;
      patches_match_row_q <= or_3483_s1_q ? 4'h0 : select_3590;
      patches_summed_last_q <= not_2242_s1_q & (equal_2243_s1_q & and_3583);
      patches_summed_down_by_q <= select_3946;
      patches_step_q <= or_3483_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3985;
      region_across_rest_q <= select_4324;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4327;
      columns_begin_rest_q <= and_540_s1_q ? select_4329 : columns_begin_rest_q;
      columns_begin_back_q <= and_540_s1_q ? select_4332 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= sum_1002;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1242;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1482;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1726;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1966;
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
  logic [2:0] select_501_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_505_s2_q;
  logic and_513_s2_q;
  logic and_514_s2_q;
  logic equal_519_s2_q;
  logic [6:0] select_534_s2_q;
  logic [6:0] last_s2_2_q;
  logic and_538_s2_q;
  logic and_540_s2_q;
  logic equal_560_s2_q;
  logic [12:0] select_564_s2_q;
  logic equal_565_s2_q;
  logic not_566_s2_q;
  logic so_s2_q;
  logic not_568_s2_q;
  logic equal_569_s2_q;
  logic or_570_s2_q;
  logic less_573_s2_q;
  logic not_574_s2_q;
  logic inside_v_s2_q;
  logic not_578_s2_q;
  logic and_582_s2_q;
  logic and_591_s2_q;
  logic and_599_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_630_s2_q;
  logic and_635_s2_q;
  logic and_637_s2_q;
  logic equal_670_s2_q;
  logic and_2026_s2_q;
  logic equal_2027_s2_q;
  logic and_2037_s2_q;
  logic and_2039_s2_q;
  logic [6:0] select_2043_s2_q;
  logic or_2047_s2_q;
  logic and_2150_s2_q;
  logic less_2164_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2241_s2_q;
  logic equal_2243_s2_q;
  logic equal_2246_s2_q;
  logic or_2247_s2_q;
  logic [4:0] select_2271_s2_q;
  logic select_2277_s2_q;
  logic [3:0] select_2317_s2_q;
  logic less_2333_s2_q;
  logic new_row_s2_q;
  logic or_2346_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2363_s2_q;
  logic or_2369_s2_q;
  logic and_2373_s2_q;
  logic and_2389_s2_q;
  logic and_2392_s2_q;
  logic and_2406_s2_q;
  logic and_2415_s2_q;
  logic and_2420_s2_q;
  logic less_2421_s2_q;
  logic equal_2422_s2_q;
  logic not_2423_s2_q;
  logic equal_2424_s2_q;
  logic not_2425_s2_q;
  logic sum_2453_s2_q;
  logic and_2474_s2_q;
  logic and_2591_s2_q;
  logic equal_2740_s2_q;
  logic equal_2929_s2_q;
  logic and_3036_s2_q;
  logic equal_3121_s2_q;
  logic less_3559_s2_q;
  logic equal_3902_s2_q;
  logic equal_3986_s2_q;
  logic less_4312_s2_q;
  logic equal_4531_s2_q;
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
      select_501_s2_q <= select_501_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_505_s2_q <= select_505_s1_q;
      and_513_s2_q <= and_513_s1_q;
      and_514_s2_q <= and_514;
      equal_519_s2_q <= equal_519_s1_q;
      select_534_s2_q <= select_534_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_538_s2_q <= and_538_s1_q;
      and_540_s2_q <= and_540_s1_q;
      equal_560_s2_q <= equal_560;
      select_564_s2_q <= select_564;
      equal_565_s2_q <= equal_565_s1_q;
      not_566_s2_q <= not_566;
      so_s2_q <= so_s1_q;
      not_568_s2_q <= not_568;
      equal_569_s2_q <= equal_569_s1_q;
      or_570_s2_q <= or_570_s1_q;
      less_573_s2_q <= less_573_s1_q;
      not_574_s2_q <= not_574_s1_q;
      inside_v_s2_q <= inside_v;
      not_578_s2_q <= not_578;
      and_582_s2_q <= and_582;
      and_591_s2_q <= or_570_s1_q & (left_rdata_q[70] & not_574_s1_q);
      and_599_s2_q <= (or_570_s1_q & (left_rdata_q[68] & not_574_s1_q)) & and_598;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_630_s2_q <= or_570_s1_q & (left_rdata_q[71] & not_574_s1_q);
      and_635_s2_q <= or_570_s1_q & (right_codes_rdata_q[58] & not_574_s1_q);
      and_637_s2_q <= or_570_s1_q & (right_codes_rdata_q[59] & not_574_s1_q);
      equal_670_s2_q <= row_s1_q == 6'h0;
      and_2026_s2_q <= and_2026_s1_q;
      equal_2027_s2_q <= equal_2027_s1_q;
      and_2037_s2_q <= and_2037;
      and_2039_s2_q <= and_2039;
      select_2043_s2_q <= select_2043;
      or_2047_s2_q <= or_2047;
      and_2150_s2_q <= and_2150_s1_q;
      less_2164_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2241_s2_q <= equal_2241_s1_q;
      equal_2243_s2_q <= equal_2243_s1_q;
      equal_2246_s2_q <= equal_2246_s1_q;
      or_2247_s2_q <= or_2247_s1_q;
      select_2271_s2_q <= select_2271_s1_q;
      select_2277_s2_q <= select_2277_s1_q;
      select_2317_s2_q <= select_2317_s1_q;
      less_2333_s2_q <= less_2333;
      new_row_s2_q <= new_row;
      or_2346_s2_q <= or_2346;
      of_row_2_s2_q <= of_row_2;
      not_2363_s2_q <= ~sum_2362[14];
      or_2369_s2_q <= or_2369;
      and_2373_s2_q <= sum_2362[14] & (~(sum_2362[13:8] == 6'h3f));
      and_2389_s2_q <= (~difference_2381[14]) & or_2388;
      and_2392_s2_q <= difference_2381[14] & (~(difference_2381[13:8] == 6'h3f));
      and_2406_s2_q <= not_2242_s1_q & and_2405;
      and_2415_s2_q <= and_2415;
      and_2420_s2_q <= not_2242_s1_q & and_2419;
      less_2421_s2_q <= less_2421;
      equal_2422_s2_q <= equal_2422;
      not_2423_s2_q <= not_2423;
      equal_2424_s2_q <= equal_2424;
      not_2425_s2_q <= not_2425;
      sum_2453_s2_q <= sum_2453[5];
      and_2474_s2_q <= or_570_s1_q & (left_rdata_q[69] & not_574_s1_q);
      and_2591_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2740_s2_q <= {last_s1_2_q[6], or_2739} == 7'h0;
      equal_2929_s2_q <= equal_2929_s1_q;
      and_3036_s2_q <= or_570_s1_q & (not_574_s1_q & and_598);
      equal_3121_s2_q <= shift == 6'h0;
      less_3559_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3902_s2_q <= patches_match_row_q == 4'h0;
      equal_3986_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4312_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4531_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/census.hpp:117
  logic [11:0] select_517;
  assign select_517 = select_501_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_521;
  assign sum_521 = select_517 + (equal_519_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_523;
  assign sum_523 = {4'h0, sample_pair_pixel_1_q} + (select_501_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_525;
  assign sum_525 = sum_523 + (equal_519_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_501_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_529;
  assign and_529 = whole & (averager_memory_rdata_q[24] | equal_519_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_501_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_533;
  assign and_533 = all_of_skin & (averager_memory_rdata_q[25] | equal_519_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_513_s2_q ? sum_521[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_543;
  assign equal_543 = select_501_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_543 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_546;
  assign select_546 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_513_s2_q ? sum_525[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_543 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_550;
  assign select_550 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_551;
  assign and_551 = and_513_s2_q & and_529;
  // hls/stages/census.hpp:134
  logic select_553;
  assign select_553 = equal_543 ? and_551 : (averager_mask_q & and_551);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_553;
  // hls/stages/census.hpp:218
  logic and_555;
  assign and_555 = and_513_s2_q & and_533;
  // hls/stages/census.hpp:134
  logic select_557;
  assign select_557 = equal_543 ? and_555 : (averager_of_skin_q & and_555);
  // hls/stages/agreement.hpp:276
  logic and_558;
  assign and_558 = sample_pair_whole_s2_q & select_557;
  // hls/stages/agreement.hpp:978
  logic select_612;
  assign select_612 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_622;
  assign difference_622 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_623;
  assign sum_623 = {difference_622[8], difference_622} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_625;
  assign and_625 = (and_599_s2_q & select_612) & ({{22{sum_623[9]}}, sum_623} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_627;
  assign and_627 = or_570_s2_q & (not_574_s2_q & and_625);
  // hls/stages/moments.hpp:77
  logic and_628;
  assign and_628 = and_591_s2_q & and_627;
  // hls/stages/census.hpp:308
  logic less_643;
  assign less_643 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_644;
  assign less_644 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_645;
  assign less_645 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_646;
  assign less_646 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_647;
  assign less_647 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_648;
  assign less_648 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_655;
  assign less_655 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_656;
  assign less_656 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_657;
  assign less_657 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_658;
  assign less_658 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_659;
  assign less_659 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_660;
  assign less_660 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_667;
  assign equal_667 = last_s2_2_q == 7'h0;
  logic [3:0] select_671;
  assign select_671 = equal_670_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_672;
  assign select_672 = equal_667 ? {select_671, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_673;
  assign select_673 = equal_667 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_674;
  assign and_674 = select_672[4] & select_673[3];
  // hls/stages/census.hpp:300
  logic and_676;
  assign and_676 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_678;
  assign and_678 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_676);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_678;
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
  logic [9:0] difference_701;
  assign difference_701 = {1'b0, select_546} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_702;
  assign xor_702 = difference_701[8:0] ^ {9{difference_701[9]}};
  logic [9:0] sum_703;
  assign sum_703 = {9'h0, difference_701[9]} + {1'b0, xor_702};
  logic [9:0] difference_704;
  assign difference_704 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_705;
  assign xor_705 = difference_704[8:0] ^ {9{difference_704[9]}};
  logic [9:0] sum_706;
  assign sum_706 = {9'h0, difference_704[9]} + {1'b0, xor_705};
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_709;
  assign xor_709 = difference_708[8:0] ^ {9{difference_708[9]}};
  logic [9:0] sum_710;
  assign sum_710 = {9'h0, difference_708[9]} + {1'b0, xor_709};
  logic [10:0] sum_711;
  assign sum_711 = ({1'b0, sum_703} + {1'b0, sum_706}) + {1'b0, sum_710};
  logic [9:0] difference_712;
  assign difference_712 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_713;
  assign xor_713 = difference_712[8:0] ^ {9{difference_712[9]}};
  logic [9:0] sum_714;
  assign sum_714 = {9'h0, difference_712[9]} + {1'b0, xor_713};
  logic [9:0] difference_716;
  assign difference_716 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_717;
  assign xor_717 = difference_716[8:0] ^ {9{difference_716[9]}};
  // hls/stages/agreement.hpp:456
  logic and_725;
  assign and_725 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_726;
  assign and_726 = and_674 & and_725;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_728;
  assign sum_728 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_730;
  assign and_730 = and_726 & ({{5{sum_728[6]}}, sum_728, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_734;
  assign sum_734 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_750;
  assign or_750 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_752;
  assign select_752 = or_750 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:751
  logic less_1483;
  assign less_1483 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1484;
  assign select_1484 = less_1483 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1485;
  assign less_1485 = middle_sum_sum_sums_values_0_q < select_1484;
  logic [7:0] select_1486;
  assign select_1486 = less_1485 ? select_1484 : middle_sum_sum_sums_values_0_q;
  logic less_1967;
  assign less_1967 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1968;
  assign select_1968 = less_1967 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1969;
  assign less_1969 = select_1486 < select_1968;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1969 ? select_1968 : select_1486) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1973;
  assign or_1973 = select_752 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1974;
  assign select_1974 = or_1973 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:752
  logic or_1976;
  assign or_1976 = less_1483 | (~less_1485);
  logic [2:0] select_1977;
  assign select_1977 = less_1969 ? {less_1967, 2'h0} : {1'b0, or_1976, less_1485};
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1978;
  assign select_1978 = or_1973 ? select_1977 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1979;
  assign select_1979 = or_1973 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1980;
  assign equal_1980 = select_1977 == 3'h1;
  logic or_1983;
  assign or_1983 = equal_1980 | (~(select_1977 == 3'h2));
  logic [7:0] select_1985;
  assign select_1985 = or_1983 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1986;
  assign select_1986 = equal_1980 ? (or_1983 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1985;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1987;
  assign select_1987 = or_1973 ? select_1986 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1988;
  assign select_1988 = or_1983 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1990;
  assign select_1990 = or_1973 ? (equal_1980 ? select_1985 : select_1988) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1992;
  assign sum_1992 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1993;
  assign sum_1993 = {1'b0, before_v} + sum_1992;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1995;
  assign sum_1995 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1996;
  assign sum_1996 = {1'b0, before_v_2} + sum_1995;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1998;
  assign sum_1998 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1999;
  assign sum_1999 = {1'b0, before_v_3} + sum_1998;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2001;
  assign select_2001 = (sum_1996 < sum_1999) ? sum_1999 : sum_1996;
  logic [6:0] select_2003;
  assign select_2003 = (sum_1993 < select_2001) ? select_2001 : sum_1993;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2005;
  assign sum_2005 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2006;
  assign sum_2006 = {1'b0, before_v_4} + sum_2005;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2008;
  assign sum_2008 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2009;
  assign sum_2009 = {1'b0, before_v_5} + sum_2008;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2011;
  assign select_2011 = (sum_2006 < sum_2009) ? sum_2009 : sum_2006;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2003 < select_2011) ? select_2011 : select_2003) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_2015;
  assign less_2015 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_2017;
  assign select_2017 = select_752 ? of_near : (less_2015 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2019;
  assign select_2019 = select_752 ? run_shift_s2_q : (less_2015 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2022;
  assign select_2022 = (run_shift_s2_q == 6'h3f) ? of_best : (select_752 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_2025;
  assign select_2025 = (run_shift_s2_q == 6'h1) ? of_best : (select_752 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_2028;
  assign select_2028 = or_750 ? shift_first_s2_q : equal_2027_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_2030;
  assign or_2030 = select_2028 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2031;
  assign select_2031 = or_2030 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2032;
  assign select_2032 = or_2030 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2034;
  assign or_2034 = select_2028 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_2035;
  assign select_2035 = or_2034 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2036;
  assign select_2036 = or_2034 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2050;
  assign and_2050 = or_570_s2_q & (not_574_s2_q & (and_625 & or_2047_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_2051;
  assign and_2051 = not_568_s2_q & and_2050;
  logic and_2054;
  assign and_2054 = not_566_s2_q & (so_s2_q ? and_2037_s2_q : (equal_569_s2_q & and_627));
  // hls/stages/moments.hpp:73
  logic and_2058;
  assign and_2058 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_2059;
  assign and_2059 = not_578_s2_q & and_2058;
  logic and_2062;
  assign and_2062 = not_578_s2_q & (and_2058 & (moments_memory_rdata_q[1] ^ and_630_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2067;
  assign and_2067 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_2068;
  assign and_2068 = not_578_s2_q & and_2067;
  logic and_2071;
  assign and_2071 = not_578_s2_q & (and_2067 & (moments_memory_rdata_q[3] ^ and_637_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_2072;
  assign equal_2072 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_2075;
  assign select_2075 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_2077;
  assign select_2077 = equal_2072 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2075});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2078;
  assign sum_2078 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2079;
  assign select_2079 = equal_565_s2_q ? select_2077 : {sum_2078, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:211
  logic equal_2080;
  assign equal_2080 = x_s2_q[5:0] == 6'h3f;
  logic equal_2082;
  assign equal_2082 = x_s2_q[5:0] == 6'h3e;
  logic equal_2084;
  assign equal_2084 = x_s2_q[5:0] == 6'h3d;
  logic equal_2086;
  assign equal_2086 = x_s2_q[5:0] == 6'h3c;
  logic equal_2088;
  assign equal_2088 = x_s2_q[5:0] == 6'h3b;
  logic equal_2090;
  assign equal_2090 = x_s2_q[5:0] == 6'h36;
  logic equal_2092;
  assign equal_2092 = x_s2_q[5:0] == 6'h35;
  logic equal_2094;
  assign equal_2094 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_2098;
  assign and_2098 = (~equal_2088) & ((~equal_2090) & ((~equal_2092) & (~equal_2094)));
  logic and_2102;
  assign and_2102 = (~equal_2080) & ((~equal_2082) & ((~equal_2084) & ((~equal_2086) & and_2098)));
  // hls/stages/agreement.hpp:1129
  logic less_2103;
  assign less_2103 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2107;
  assign or_2107 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_2112;
  assign sum_2112 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2112, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2118;
  assign sum_2118 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2120;
  assign and_2120 = half_ends & ({{3{sum_2118[4]}}, sum_2118} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_2121;
  assign and_2121 = so_s2_q & and_2120;
  logic select_2122;
  assign select_2122 = equal_565_s2_q ? (x_s2_q[6] & (equal_2072 ? and_2102 : (less_2103 & (~or_2107)))) : and_2121;
  // hls/stages/registration.hpp:258
  logic not_2124;
  assign not_2124 = ~lower_half_s2_q;
  logic [3:0] select_2125;
  assign select_2125 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2124, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2124};
  // hls/stages/patches.hpp:374
  logic [1:0] select_2151;
  assign select_2151 = and_2150_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2152;
  assign select_2152 = and_2150_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2153;
  assign select_2153 = row_starts_s2_q ? {select_2152, select_2151[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2154;
  assign select_2154 = row_starts_s2_q ? select_2151 : patches_fetch_q;
  logic equal_2155;
  assign equal_2155 = select_2154 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_2163;
  assign and_2163 = not_566_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2165;
  assign equal_2165 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_570_s2_q ? (less_573_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2165 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2173;
  assign select_2173 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2174;
  assign select_2174 = b[1] ? a : 8'h0;
  logic [8:0] sum_2175;
  assign sum_2175 = {{2{select_2173[6]}}, select_2173} + {select_2174[7], select_2174};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2176;
  assign select_2176 = b[2] ? a : 8'h0;
  logic [7:0] select_2177;
  assign select_2177 = b[3] ? a : 8'h0;
  logic [8:0] sum_2178;
  assign sum_2178 = {{2{select_2176[7]}}, select_2176[7:1]} + {select_2177[7], select_2177};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2179;
  assign sum_2179 = {{3{sum_2175[8]}}, sum_2175[8:1]} + {sum_2178[8], sum_2178, select_2176[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2180;
  assign select_2180 = b[4] ? a : 8'h0;
  logic [7:0] select_2181;
  assign select_2181 = b[5] ? a : 8'h0;
  logic [8:0] difference_2182;
  assign difference_2182 = {{2{select_2180[7]}}, select_2180[7:1]} - {select_2181[7], select_2181};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2183;
  assign sum_2183 = {difference_2182, select_2180[0]} + {sum_2179[10], sum_2179[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2165 ? {sum_2183, sum_2179[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2185;
  assign sum_2185 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2188;
  assign and_2188 = less_2164_s2_q & (and_627 & ({{4{sum_2185[9]}}, sum_2185, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2192;
  assign and_2192 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2198;
  assign sum_2198 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2200;
  assign sum_2200 = {sum_2198[9], sum_2198[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_2203;
  assign and_2203 = ($signed(9'h0) < $signed(sum_2198[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2200, sum_2198[0]})));
  logic and_2204;
  assign and_2204 = (~(and_2192 | (equal_560_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2203;
  // hls/stages/agreement.hpp:788
  logic and_2208;
  assign and_2208 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2188 & and_2204)));
  logic and_2209;
  assign and_2209 = not_566_s2_q & and_2208;
  // hls/stages/patches.hpp:157
  logic and_2211;
  assign and_2211 = and_2209 & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_2212;
  assign select_2212 = and_2211 ? and_2209 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2215;
  assign select_2215 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_2217;
  assign select_2217 = and_2211 ? (equal_565_s2_q ? 8'h0 : select_2215) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2220;
  assign select_2220 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:345
  logic [5:0] select_2222;
  assign select_2222 = and_2211 ? (equal_565_s2_q ? 6'h0 : select_2220) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2223;
  assign sum_2223 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2183[9]}}, sum_2183[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2226;
  assign select_2226 = ($signed(sum_2223[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2223[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2165 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2223[12:7])) ? 8'h7f : select_2226);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2231;
  assign select_2231 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_2233;
  assign select_2233 = and_2211 ? (equal_565_s2_q ? 8'h0 : select_2231) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2234;
  assign equal_2234 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_2238;
  assign and_2238 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2192 | equal_2234)));
  logic and_2239;
  assign and_2239 = not_566_s2_q & and_2238;
  // hls/stages/patches.hpp:345
  logic and_2240;
  assign and_2240 = patches_chooses_s2_q & and_2239;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2254;
  assign select_2254 = row_starts_s2_q ? select_2152 : patches_band_q;
  // hls/stages/patches.hpp:354
  logic equal_2255;
  assign equal_2255 = {patches_choosing_band_s2_q, and_2163} == {select_2254, select_2154[1]};
  // hls/stages/patches.hpp:487
  logic [2:0] sum_2354;
  assign sum_2354 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_2370;
  assign and_2370 = not_2363_s2_q & or_2369_s2_q;
  // hls/stages/patches.hpp:491
  logic [1:0] sum_2410;
  assign sum_2410 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2440;
  assign select_2440 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2443;
  assign or_2443 = select_2440[7] | (~({select_2440[5], select_2440[3], select_2440[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2446;
  assign or_2446 = select_2440[7] | (~({select_2440[6], select_2440[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2449;
  assign or_2449 = select_2440[7] | (~(select_2440[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2450;
  assign select_2450 = equal_565_s2_q ? x_s2_q[5:0] : {region_row_q, or_2449, or_2446, or_2443};
  // hls/stages/agreement.hpp:1128
  logic not_2451;
  assign not_2451 = ~equal_2072;
  // hls/stages/agreement.hpp:1058
  logic or_2455;
  assign or_2455 = (~sum_2453_s2_q) | equal_2234;
  // hls/stages/agreement.hpp:788
  logic and_2458;
  assign and_2458 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2455));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_570_s2_q & (not_574_s2_q & and_599_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_627;
  // hls/stages/agreement.hpp:149
  logic and_2476;
  assign and_2476 = or_570_s2_q & (not_574_s2_q & and_2474_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2485;
  assign and_2485 = inside_v_s2_q & and_2476;
  // hls/stages/agreement.hpp:1014
  logic select_2486;
  assign select_2486 = slot_s2_q[2] ? shown_shown_q : and_627;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2486);
  // hls/stages/agreement.hpp:1014
  logic select_2489;
  assign select_2489 = slot_s2_q[2] ? shown_nearer_q : and_2050;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2486 ? select_2489 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1275
  logic or_2492;
  assign or_2492 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [16:0] select_2494;
  assign select_2494 = marks_first_s2_q ? 17'h1 : (or_2492 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2496;
  assign select_2496 = or_2492 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2498;
  assign select_2498 = cfg_compete_i ? (or_2492 & select_2494[16]) : (select_2496[8] & select_2494[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2498 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2501;
  assign select_2501 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2503;
  assign select_2503 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2501});
  // hls/stages/agreement.hpp:1301
  logic equal_2504;
  assign equal_2504 = seen_x_q == 3'h7;
  logic [7:0] select_2506;
  assign select_2506 = select_2498 ? 8'h0 : (seen_column_q + {7'h0, equal_2504});
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = select_2503 + {5'h0, select_2506};
  // hls/stages/agreement.hpp:1275
  logic select_2509;
  assign select_2509 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2510;
  assign sum_2510 = {1'b0, select_2509, 2'h0, select_2509, 1'b0, {2{select_2509}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1274
  logic not_2511;
  assign not_2511 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2513;
  assign and_2513 = not_2511 & (began_q | select_2498);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2515;
  assign select_2515 = select_2498 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2517;
  assign and_2517 = and_2513 & (select_2515 == 3'h0);
  logic less_2518;
  assign less_2518 = select_2506 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2521;
  assign sum_2521 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2521[7]}}, sum_2521, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2523;
  assign sum_2523 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2524;
  assign and_2524 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2525;
  assign and_2525 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2526;
  assign and_2526 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2527;
  assign and_2527 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2529;
  assign sum_2529 = {1'b0, and_2526} + ({1'b0, textured} + {1'b0, and_2527});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2524} + ({2'h0, and_2525} + {1'b0, sum_2529});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2538;
  assign select_2538 = inside_v_s2_q ? (sum_2453_s2_q ? select_2440 : {select_2440[6:0], 1'b0}) : select_2440;
  // hls/stages/agreement.hpp:1050
  logic or_2541;
  assign or_2541 = select_2538[7] | (~({select_2538[5], select_2538[3], select_2538[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2558;
  assign and_2558 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2559;
  assign and_2559 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2560;
  assign and_2560 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2561;
  assign and_2561 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2563;
  assign sum_2563 = {1'b0, and_2560} + ({1'b0, shown} + {1'b0, and_2561});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2558} + ({2'h0, and_2559} + {1'b0, sum_2563});
  // hls/stages/agreement.hpp:1030
  logic and_2574;
  assign and_2574 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2575;
  assign and_2575 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2576;
  assign and_2576 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2577;
  assign and_2577 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2579;
  assign sum_2579 = {1'b0, and_2576} + ({1'b0, near} + {1'b0, and_2577});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2574} + ({2'h0, and_2575} + {1'b0, sum_2579});
  // hls/stages/agreement.hpp:788
  logic and_2595;
  assign and_2595 = ends_cell_s2_q & (and_2591_s2_q & (~({sum_2112, last_s2_q[1:0]} < x_s2_q)));
  logic and_2597;
  assign and_2597 = not_566_s2_q & (so_s2_q & and_2595);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2631;
  assign select_2631 = sample_pair_whole_s2_q ? (and_538_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2633;
  assign select_2633 = sample_pair_whole_s2_q ? (and_538_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2653;
  assign select_2653 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2655;
  assign select_2655 = sample_pair_whole_s2_q ? (and_538_s2_q ? select_553 : averager_mask_q) : averager_mask_q;
  logic select_2657;
  assign select_2657 = sample_pair_whole_s2_q ? (and_538_s2_q ? select_557 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2658;
  assign select_2658 = and_540_s2_q ? select_546 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2659;
  assign select_2659 = and_540_s2_q ? select_550 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2661;
  assign select_2661 = and_540_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2662;
  assign select_2662 = and_540_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2663;
  assign select_2663 = and_540_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2664;
  assign select_2664 = and_540_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2665;
  assign select_2665 = and_540_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2666;
  assign select_2666 = and_540_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2667;
  assign select_2667 = and_540_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2668;
  assign select_2668 = and_540_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2669;
  assign select_2669 = and_540_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2670;
  assign select_2670 = and_540_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2671;
  assign select_2671 = and_540_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_540_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2673;
  assign select_2673 = and_540_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_540_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_540_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2676;
  assign select_2676 = and_540_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_540_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_540_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2679;
  assign select_2679 = and_540_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2680;
  assign select_2680 = and_540_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2681;
  assign select_2681 = and_540_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2682;
  assign select_2682 = and_540_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2683;
  assign select_2683 = and_540_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2684;
  assign select_2684 = and_540_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2685;
  assign select_2685 = and_540_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2686;
  assign select_2686 = and_540_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2687;
  assign select_2687 = and_540_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_540_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2689;
  assign select_2689 = and_540_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_540_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_540_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2692;
  assign select_2692 = and_540_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_540_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_540_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2695;
  assign select_2695 = and_540_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2696;
  assign select_2696 = and_540_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2697;
  assign select_2697 = and_540_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2698;
  assign select_2698 = and_540_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2699;
  assign select_2699 = and_540_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2700;
  assign select_2700 = and_540_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2701;
  assign select_2701 = and_540_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2702;
  assign select_2702 = and_540_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2703;
  assign select_2703 = and_540_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2704;
  assign select_2704 = and_540_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2705;
  assign select_2705 = and_540_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2706;
  assign select_2706 = and_540_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2707;
  assign select_2707 = and_540_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2708;
  assign select_2708 = and_540_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2709;
  assign select_2709 = and_540_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2710;
  assign select_2710 = and_540_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2711;
  assign select_2711 = and_540_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2712;
  assign select_2712 = and_540_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2713;
  assign select_2713 = and_540_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2715;
  assign difference_2715 = {1'b0, select_550} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2716;
  assign xor_2716 = difference_2715[8:0] ^ {9{difference_2715[9]}};
  logic [9:0] sum_2717;
  assign sum_2717 = {9'h0, difference_2715[9]} + {1'b0, xor_2716};
  logic [9:0] difference_2718;
  assign difference_2718 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2719;
  assign xor_2719 = difference_2718[8:0] ^ {9{difference_2718[9]}};
  logic [9:0] sum_2720;
  assign sum_2720 = {9'h0, difference_2718[9]} + {1'b0, xor_2719};
  logic [9:0] difference_2722;
  assign difference_2722 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2723;
  assign xor_2723 = difference_2722[8:0] ^ {9{difference_2722[9]}};
  logic [9:0] sum_2724;
  assign sum_2724 = {9'h0, difference_2722[9]} + {1'b0, xor_2723};
  logic [10:0] sum_2725;
  assign sum_2725 = ({1'b0, sum_2717} + {1'b0, sum_2720}) + {1'b0, sum_2724};
  logic [9:0] difference_2726;
  assign difference_2726 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2727;
  assign xor_2727 = difference_2726[8:0] ^ {9{difference_2726[9]}};
  logic [9:0] sum_2728;
  assign sum_2728 = {9'h0, difference_2726[9]} + {1'b0, xor_2727};
  logic [9:0] difference_2730;
  assign difference_2730 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2731;
  assign xor_2731 = difference_2730[8:0] ^ {9{difference_2730[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2752;
  assign sum_2752 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2754;
  assign sum_2754 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2755;
  assign equal_2755 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2756;
  assign select_2756 = equal_2755 ? sum_2752 : moments_before_0_q;
  logic [13:0] select_2758;
  assign select_2758 = equal_2755 ? sum_2754 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2761;
  assign select_2761 = equal_565_s2_q ? (moments_has_before_q | equal_2755) : moments_has_before_q;
  logic [13:0] select_2764;
  assign select_2764 = equal_565_s2_q ? ((select_2758 < select_2756) ? select_2756 : select_2758) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2765;
  assign sum_2765 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2768;
  assign select_2768 = equal_565_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2765)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2769;
  assign sum_2769 = {1'b0, sum_2754} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2772;
  assign select_2772 = equal_565_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2769)) : moments_left_alone_q;
  logic select_2775;
  assign select_2775 = equal_565_s2_q ? (~({3'h0, select_2758[13:2]} < sum_2769)) : moments_left_other_stops_q;
  logic select_2778;
  assign select_2778 = equal_565_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2765)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2779;
  assign sum_2779 = {1'b0, sum_2752} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2782;
  assign select_2782 = equal_565_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2779)) : moments_right_alone_q;
  logic select_2785;
  assign select_2785 = equal_565_s2_q ? (~({3'h0, select_2756[13:2]} < sum_2779)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2788;
  assign or_2788 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2796;
  assign and_2796 = not_566_s2_q & (not_568_s2_q & (equal_569_s2_q & (inside_v_s2_q & and_2062)));
  logic and_2800;
  assign and_2800 = not_566_s2_q & (not_568_s2_q & (equal_569_s2_q & (inside_v_s2_q & and_2071)));
  // hls/stages/moments.hpp:94
  logic and_2802;
  assign and_2802 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2805;
  assign select_2805 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2802)) : and_2802;
  // hls/stages/agreement.hpp:788
  logic and_2809;
  assign and_2809 = equal_565_s2_q & (equal_2755 & (cfg_prove_i & (cfg_same_table_i & select_2805)));
  // hls/stages/moments.hpp:95
  logic and_2812;
  assign and_2812 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2826;
  assign difference_2826 = {1'b0, select_546} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2826[9]} + (difference_2826[8:0] ^ {9{difference_2826[9]}});
  logic [9:0] difference_2838;
  assign difference_2838 = {1'b0, select_550} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2838[9]} + (difference_2838[8:0] ^ {9{difference_2838[9]}});
  // hls/stages/agreement.hpp:788
  logic not_3026;
  assign not_3026 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3027;
  assign less_3027 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_3034;
  assign and_3034 = and_540_s2_q & (equal_670_s2_q & equal_2929_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_3040;
  assign and_3040 = not_566_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3036_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3060;
  assign and_3060 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3061;
  assign and_3061 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3062;
  assign and_3062 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3063;
  assign and_3063 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3065;
  assign sum_3065 = {1'b0, and_3062} + ({1'b0, explained} + {1'b0, and_3063});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3060} + ({2'h0, and_3061} + {1'b0, sum_3065});
  // hls/stages/agreement.hpp:788
  logic and_3101;
  assign and_3101 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3036_s2_q & and_2476)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3125;
  assign difference_3125 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3128;
  assign less_3128 = {2'h0, difference_3125[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3131;
  assign and_3131 = not_574_s2_q & (((and_2474_s2_q & and_625) & equal_3121_s2_q) & (~less_3128));
  // hls/stages/agreement.hpp:788
  logic and_3135;
  assign and_3135 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_570_s2_q & and_3131)));
  // hls/stages/agreement.hpp:149
  logic and_3140;
  assign and_3140 = not_574_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3142;
  assign and_3142 = not_574_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3143;
  assign select_3143 = or_570_s2_q ? {and_3142, and_3140} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3145;
  assign select_3145 = less_573_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3146;
  assign select_3146 = or_570_s2_q ? select_3145 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3148;
  assign and_3148 = and_627 & (select_3143[0] & select_3146[0]);
  // hls/stages/agreement.hpp:788
  logic and_3152;
  assign and_3152 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3143[1] & and_3148)));
  logic and_3153;
  assign and_3153 = not_566_s2_q & and_3152;
  logic and_3159;
  assign and_3159 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3146[1] & and_3148)));
  logic and_3160;
  assign and_3160 = not_566_s2_q & and_3159;
  // hls/stages/registration.hpp:76
  logic less_3163;
  assign less_3163 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3165;
  assign select_3165 = or_570_s2_q ? (less_573_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3167;
  assign select_3167 = or_570_s2_q ? (less_573_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3169;
  assign select_3169 = or_570_s2_q ? (less_573_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3167} - {1'b0, select_3169};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3171;
  assign select_3171 = rise_2[8] ? select_3167 : select_3169;
  logic [8:0] fall;
  assign fall = {1'b0, select_3165} - {1'b0, select_3171};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3174;
  assign not_3174 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3163 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3174};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3176;
  assign xor_3176 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3176};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3182;
  assign select_3182 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3163 ? {taken, 1'b1} : {not_3174, select_3182, not_3174};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3184;
  assign sum_3184 = {left, 1'b1} + {taken_2, less_3163};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3186;
  assign select_3186 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3188;
  assign select_3188 = equal_565_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3190;
  assign select_3190 = equal_565_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3191;
  assign equal_3191 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3195;
  assign and_3195 = and_627 & less_2164_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3197;
  assign select_3197 = or_570_s2_q ? (less_573_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3201;
  assign sum_3201 = select_3197[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3204;
  assign select_3204 = (select_3167 < select_3169) ? ({sum_3201, select_3197[0], 5'h0} - {3'h0, select_3186}) : {sum_3201, select_3197[0], select_3186};
  logic [7:0] select_3205;
  assign select_3205 = ((select_3197 == 3'h0) | (select_3197 == 3'h4)) ? {sum_3201, select_3197[0], 5'h0} : select_3204;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3205[7]}}, select_3205} - {sum_2183[9], sum_2183, sum_2179[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3208;
  assign select_3208 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3208[11:7])) ? 12'h7f : select_3208;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3229;
  assign difference_3229 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3231;
  assign and_3231 = and_3195 & ($signed(difference_3229) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3244;
  assign less_3244 = $signed(difference_3229) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3252;
  assign select_3252 = so_s2_q ? (equal_3191 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3255;
  assign select_3255 = so_s2_q ? (equal_2165 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3260;
  assign select_3260 = (sum_2078 == 2'h2) ? (registration_fresh_q & (~select_2125)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3262;
  assign select_3262 = so_s2_q ? (and_2120 ? select_3260 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3264;
  assign select_3264 = and_3034 ? 4'hf : (equal_565_s2_q ? registration_fresh_q : select_3262);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2075;
  // hls/stages/registration.hpp:258
  logic not_3285;
  assign not_3285 = ~quarter_2[1];
  logic [3:0] select_3286;
  assign select_3286 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3285, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3285};
  // hls/stages/patches.hpp:91
  logic parity_3420;
  assign parity_3420 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3421;
  assign select_3421 = equal_2929_s2_q ? {patches_chance_q[14:0], parity_3420} : patches_chance_q;
  // hls/stages/patches.hpp:346
  logic not_3423;
  assign not_3423 = ~and_2239;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3426;
  assign select_3426 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3426};
  // hls/stages/agreement.hpp:788
  logic and_3432;
  assign and_3432 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3436;
  assign and_3436 = not_3423 & (patches_fixed_q | ((not_566_s2_q & and_3432) & and_2211));
  // hls/stages/patches.hpp:355
  logic not_3448;
  assign not_3448 = ~select_2154[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3450;
  assign select_3450 = sample_pair_whole_s2_q ? (equal_2155 ? select_2154 : {not_3448, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3549;
  assign select_3549 = or_2247_s2_q ? {and_2392_s2_q, and_2389_s2_q, and_2373_s2_q, and_2370, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3551;
  assign select_3551 = equal_2241_s2_q ? patches_codes_at_q : (equal_2243_s2_q ? other[55:4] : select_3549);
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_2346_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [27:0] select_3554;
  assign select_3554 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3556;
  assign select_3556 = equal_2243_s2_q ? (new_row_s2_q ? word : select_3554) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3558;
  assign select_3558 = less_2333_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3560;
  assign select_3560 = less_3559_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3562;
  assign select_3562 = or_2247_s2_q ? (equal_2246_s2_q ? patches_next_codes_q : select_3560) : patches_next_codes_q;
  logic [55:0] select_3564;
  assign select_3564 = equal_2241_s2_q ? patches_next_codes_q : (equal_2243_s2_q ? select_3558 : select_3562);
  // hls/stages/count_bits.hpp:24
  logic parity_3569;
  assign parity_3569 = ^{and_2392_s2_q, and_2389_s2_q, and_2373_s2_q, and_2370};
  // hls/stages/count_bits.hpp:25
  logic or_3573;
  assign or_3573 = ({and_2373_s2_q, and_2370} == 2'h3) | (and_2389_s2_q & (and_2373_s2_q | and_2370));
  logic and_3574;
  assign and_3574 = and_2392_s2_q & (^{and_2389_s2_q, and_2373_s2_q, and_2370});
  // hls/stages/count_bits.hpp:24
  logic xor_3575;
  assign xor_3575 = or_3573 ^ and_3574;
  // hls/stages/count_bits.hpp:27
  logic and_3576;
  assign and_3576 = or_3573 & and_3574;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3578;
  assign select_3578 = or_2247_s2_q ? (and_2415_s2_q ? {and_3576, xor_3575, parity_3569} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3582;
  assign sum_3582 = {7'h0, patches_set_q} + (equal_2246_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:523
  logic [47:0] select_3592;
  assign select_3592 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3594;
  assign select_3594 = equal_2241_s2_q ? patches_left_row_q : (equal_2243_s2_q ? select_3592 : patches_left_row_q);
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3592;
  // hls/stages/count_bits.hpp:24
  logic xor_3598;
  assign xor_3598 = bits[17] ^ (^{select_3592[16:15], other[16:15]});
  logic xor_3601;
  assign xor_3601 = bits[11] ^ (^{select_3592[10:9], other[10:9]});
  logic xor_3604;
  assign xor_3604 = bits[14] ^ (^{select_3592[13:12], other[13:12]});
  logic xor_3607;
  assign xor_3607 = xor_3598 ^ (^{select_3592[14:9], other[14:9]});
  logic xor_3610;
  assign xor_3610 = bits[47] ^ (^{select_3592[46:45], other[46:45]});
  logic xor_3613;
  assign xor_3613 = bits[8] ^ (^{select_3592[7:6], other[7:6]});
  logic xor_3616;
  assign xor_3616 = bits[2] ^ (^{select_3592[1:0], other[1:0]});
  logic xor_3619;
  assign xor_3619 = bits[5] ^ (^{select_3592[4:3], other[4:3]});
  logic xor_3622;
  assign xor_3622 = xor_3613 ^ (^{select_3592[5:0], other[5:0]});
  logic parity_3624;
  assign parity_3624 = ^{select_3592[47:45], select_3592[8:0], other[47:45], other[8:0]};
  logic xor_3625;
  assign xor_3625 = xor_3607 ^ parity_3624;
  logic xor_3628;
  assign xor_3628 = bits[44] ^ (^{select_3592[43:42], other[43:42]});
  logic xor_3631;
  assign xor_3631 = bits[38] ^ (^{select_3592[37:36], other[37:36]});
  logic xor_3634;
  assign xor_3634 = bits[41] ^ (^{select_3592[40:39], other[40:39]});
  logic xor_3640;
  assign xor_3640 = bits[26] ^ (^{select_3592[25:24], other[25:24]});
  logic xor_3643;
  assign xor_3643 = bits[20] ^ (^{select_3592[19:18], other[19:18]});
  logic xor_3646;
  assign xor_3646 = bits[23] ^ (^{select_3592[22:21], other[22:21]});
  logic xor_3649;
  assign xor_3649 = xor_3640 ^ (^{select_3592[23:18], other[23:18]});
  logic xor_3652;
  assign xor_3652 = bits[35] ^ (^{select_3592[34:33], other[34:33]});
  logic xor_3655;
  assign xor_3655 = bits[29] ^ (^{select_3592[28:27], other[28:27]});
  logic xor_3658;
  assign xor_3658 = bits[32] ^ (^{select_3592[31:30], other[31:30]});
  logic xor_3661;
  assign xor_3661 = xor_3652 ^ (^{select_3592[32:27], other[32:27]});
  logic xor_3662;
  assign xor_3662 = xor_3649 ^ xor_3661;
  // hls/stages/count_bits.hpp:25
  logic or_3670;
  assign or_3670 = (xor_3601 & xor_3604) | (xor_3598 & (xor_3601 | xor_3604));
  logic or_3674;
  assign or_3674 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3678;
  assign or_3678 = (xor_3616 & xor_3619) | (xor_3613 & (xor_3616 | xor_3619));
  // hls/stages/count_bits.hpp:23
  logic or_3685;
  assign or_3685 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3689;
  assign or_3689 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3693;
  assign or_3693 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3696;
  assign parity_3696 = ^{or_3693, or_3689, or_3685};
  // hls/stages/count_bits.hpp:23
  logic or_3700;
  assign or_3700 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3704;
  assign or_3704 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3708;
  assign or_3708 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3711;
  assign parity_3711 = ^{or_3708, or_3704, or_3700};
  logic parity_3714;
  assign parity_3714 = ^{or_3708, or_3704, or_3700, or_3693, or_3689, or_3685, or_3678, or_3674, or_3670};
  // hls/stages/count_bits.hpp:23
  logic or_3718;
  assign or_3718 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3722;
  assign or_3722 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3726;
  assign or_3726 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3734;
  assign or_3734 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3738;
  assign or_3738 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3742;
  assign or_3742 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3745;
  assign parity_3745 = ^{or_3742, or_3738, or_3734};
  // hls/stages/count_bits.hpp:23
  logic or_3749;
  assign or_3749 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3753;
  assign or_3753 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3757;
  assign or_3757 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3760;
  assign parity_3760 = ^{or_3757, or_3753, or_3749};
  logic parity_3763;
  assign parity_3763 = ^{or_3757, or_3753, or_3749, or_3742, or_3738, or_3734, or_3726, or_3722, or_3718};
  // hls/stages/count_bits.hpp:25
  logic or_3767;
  assign or_3767 = (xor_3631 & xor_3634) | (xor_3628 & (xor_3631 | xor_3634));
  logic or_3771;
  assign or_3771 = (xor_3643 & xor_3646) | (xor_3640 & (xor_3643 | xor_3646));
  logic or_3775;
  assign or_3775 = (xor_3655 & xor_3658) | (xor_3652 & (xor_3655 | xor_3658));
  // hls/stages/count_bits.hpp:24
  logic parity_3778;
  assign parity_3778 = ^{or_3775, or_3771, or_3767};
  // hls/stages/count_bits.hpp:25
  logic and_3779;
  assign and_3779 = xor_3625 & (^{xor_3662, select_3592[44:36], other[44:36]});
  logic or_3783;
  assign or_3783 = (xor_3610 & xor_3622) | (xor_3607 & (xor_3610 | xor_3622));
  logic and_3786;
  assign and_3786 = (xor_3628 ^ (^{select_3592[41:36], other[41:36]})) & (xor_3649 | xor_3661);
  logic or_3787;
  assign or_3787 = (xor_3649 & xor_3661) | and_3786;
  // hls/stages/count_bits.hpp:24
  logic parity_3790;
  assign parity_3790 = ^{or_3787, or_3783, and_3779};
  logic parity_3793;
  assign parity_3793 = ^{or_3787, or_3783, and_3779, or_3775, or_3771, or_3767, or_3757, or_3753, or_3749, or_3742, or_3738, or_3734, or_3726, or_3722, or_3718};
  logic parity_3795;
  assign parity_3795 = ^{or_3787, or_3783, and_3779, or_3775, or_3771, or_3767, or_3757, or_3753, or_3749, or_3742, or_3738, or_3734, or_3726, or_3722, or_3718, or_3708, or_3704, or_3700, or_3693, or_3689, or_3685, or_3678, or_3674, or_3670};
  // hls/stages/count_bits.hpp:25
  logic and_3796;
  assign and_3796 = parity_3714 & parity_3793;
  logic or_3800;
  assign or_3800 = (parity_3696 & parity_3711) | ((^{or_3678, or_3674, or_3670}) & (parity_3696 | parity_3711));
  logic or_3804;
  assign or_3804 = (parity_3778 & parity_3790) | (parity_3763 & (parity_3778 | parity_3790));
  logic or_3811;
  assign or_3811 = (parity_3745 & parity_3760) | ((^{or_3726, or_3722, or_3718}) & (parity_3745 | parity_3760));
  logic or_3815;
  assign or_3815 = (or_3771 & or_3775) | (or_3767 & (or_3771 | or_3775));
  logic or_3819;
  assign or_3819 = (or_3783 & or_3787) | (and_3779 & (or_3783 | or_3787));
  // hls/stages/count_bits.hpp:23
  logic or_3826;
  assign or_3826 = (or_3722 & or_3726) | (or_3718 & (or_3722 | or_3726));
  // hls/stages/count_bits.hpp:25
  logic or_3830;
  assign or_3830 = (or_3738 & or_3742) | (or_3734 & (or_3738 | or_3742));
  logic or_3834;
  assign or_3834 = (or_3753 & or_3757) | (or_3749 & (or_3753 | or_3757));
  // hls/stages/count_bits.hpp:24
  logic parity_3837;
  assign parity_3837 = ^{or_3834, or_3830, or_3826};
  // hls/stages/count_bits.hpp:23
  logic or_3841;
  assign or_3841 = (or_3674 & or_3678) | (or_3670 & (or_3674 | or_3678));
  // hls/stages/count_bits.hpp:25
  logic or_3845;
  assign or_3845 = (or_3689 & or_3693) | (or_3685 & (or_3689 | or_3693));
  logic or_3849;
  assign or_3849 = (or_3704 & or_3708) | (or_3700 & (or_3704 | or_3708));
  // hls/stages/count_bits.hpp:24
  logic parity_3852;
  assign parity_3852 = ^{or_3849, or_3845, or_3841};
  logic parity_3855;
  assign parity_3855 = ^{or_3849, or_3845, or_3841, or_3834, or_3830, or_3826, or_3819, or_3815, or_3811};
  logic parity_3857;
  assign parity_3857 = ^{or_3849, or_3845, or_3841, or_3834, or_3830, or_3826, or_3819, or_3815, or_3811, or_3804, or_3800, and_3796};
  // hls/stages/count_bits.hpp:25
  logic or_3861;
  assign or_3861 = (or_3815 & or_3819) | (or_3811 & (or_3815 | or_3819));
  logic or_3865;
  assign or_3865 = (or_3830 & or_3834) | (or_3826 & (or_3830 | or_3834));
  logic or_3869;
  assign or_3869 = (or_3845 & or_3849) | (or_3841 & (or_3845 | or_3849));
  // hls/stages/count_bits.hpp:24
  logic parity_3872;
  assign parity_3872 = ^{or_3869, or_3865, or_3861};
  // hls/stages/count_bits.hpp:25
  logic and_3873;
  assign and_3873 = (^{or_3804, or_3800, and_3796}) & parity_3855;
  logic or_3877;
  assign or_3877 = (or_3800 & or_3804) | (and_3796 & (or_3800 | or_3804));
  logic or_3881;
  assign or_3881 = (parity_3837 & parity_3852) | ((^{or_3819, or_3815, or_3811}) & (parity_3837 | parity_3852));
  // hls/stages/count_bits.hpp:24
  logic parity_3884;
  assign parity_3884 = ^{or_3881, or_3877, and_3873};
  // hls/stages/count_bits.hpp:25
  logic and_3886;
  assign and_3886 = parity_3872 & parity_3884;
  logic or_3890;
  assign or_3890 = (or_3865 & or_3869) | (or_3861 & (or_3865 | or_3869));
  logic or_3894;
  assign or_3894 = (or_3877 & or_3881) | (and_3873 & (or_3877 | or_3881));
  // hls/stages/patches.hpp:185
  logic [4:0] select_3939;
  assign select_3939 = equal_2243_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3942;
  assign select_3942 = equal_2241_s2_q ? patches_summed_first_q : (equal_2243_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:557
  logic [9:0] select_3949;
  assign select_3949 = less_2421_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3952;
  assign select_3952 = equal_2424_s2_q ? (less_2421_s2_q ? (equal_2424_s2_q ? 10'h0 : select_3949) : 10'h0) : select_3949;
  logic [9:0] select_3954;
  assign select_3954 = less_2421_s2_q ? (equal_2422_s2_q ? 10'h0 : select_3952) : select_3952;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3956;
  assign select_3956 = less_2421_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3959;
  assign select_3959 = equal_2424_s2_q ? (less_2421_s2_q ? (equal_2424_s2_q ? 5'h0 : select_3956) : 5'h0) : select_3956;
  logic [4:0] select_3961;
  assign select_3961 = less_2421_s2_q ? (equal_2422_s2_q ? 5'h0 : select_3959) : select_3959;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3963;
  assign select_3963 = less_2421_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3966;
  assign select_3966 = equal_2424_s2_q ? (less_2421_s2_q ? (equal_2424_s2_q ? 5'h0 : select_3963) : 5'h0) : select_3963;
  logic [4:0] select_3968;
  assign select_3968 = less_2421_s2_q ? (equal_2422_s2_q ? 5'h0 : select_3966) : select_3966;
  // hls/stages/patches.hpp:557
  logic and_3971;
  assign and_3971 = less_2421_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3974;
  assign select_3974 = equal_2424_s2_q ? (less_2421_s2_q ? (not_2425_s2_q & and_3971) : and_3971) : and_3971;
  // hls/stages/patches.hpp:185
  logic select_3977;
  assign select_3977 = equal_2241_s2_q ? (less_2421_s2_q ? (not_2423_s2_q & select_3974) : select_3974) : patches_read_first_q;
  // hls/stages/patches.hpp:179
  logic or_3988;
  assign or_3988 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3989;
  assign and_3989 = patches_read_searches_s2_q & or_3988;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3990;
  assign select_3990 = and_3989 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3990};
  // hls/stages/patches.hpp:557
  logic and_3994;
  assign and_3994 = less_2421_s2_q & (equal_3986_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:561
  logic select_3997;
  assign select_3997 = equal_2424_s2_q ? (less_2421_s2_q ? (not_2425_s2_q & and_3994) : and_3994) : and_3994;
  // hls/stages/patches.hpp:185
  logic select_4000;
  assign select_4000 = equal_2241_s2_q ? (less_2421_s2_q ? (not_2423_s2_q & select_3997) : select_3997) : patches_read_above_q;
  // hls/stages/patches.hpp:557
  logic and_4003;
  assign and_4003 = less_2421_s2_q & (equal_3986_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:561
  logic select_4006;
  assign select_4006 = equal_2424_s2_q ? (less_2421_s2_q ? (not_2425_s2_q & and_4003) : and_4003) : and_4003;
  // hls/stages/patches.hpp:185
  logic select_4009;
  assign select_4009 = equal_2241_s2_q ? (less_2421_s2_q ? (not_2423_s2_q & select_4006) : select_4006) : patches_read_below_q;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_4010;
  assign sum_4010 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:555
  logic [9:0] select_4013;
  assign select_4013 = (equal_3986_s2_q & ({sum_4010[6], sum_4010} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4014;
  assign select_4014 = less_2421_s2_q ? select_4013 : 10'h3ff;
  // hls/stages/patches.hpp:558
  logic [9:0] select_4016;
  assign select_4016 = less_2421_s2_q ? (equal_2424_s2_q ? 10'h3ff : select_4014) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_4017;
  assign select_4017 = equal_2424_s2_q ? select_4016 : select_4014;
  logic [9:0] select_4019;
  assign select_4019 = less_2421_s2_q ? (equal_2422_s2_q ? 10'h3ff : select_4017) : select_4017;
  // hls/stages/patches.hpp:540
  logic [14:0] select_4021;
  assign select_4021 = and_3989 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_4022;
  assign select_4022 = equal_2241_s2_q ? select_4021[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4023;
  assign select_4023 = equal_2241_s2_q ? select_4021[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_4025;
  assign select_4025 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_4027;
  assign select_4027 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_4030;
  assign select_4030 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_4031;
  assign select_4031 = patches_read_first_q ? patches_read_far_q : select_4030;
  // hls/stages/patches.hpp:595
  logic [9:0] difference_4034;
  assign difference_4034 = select_4031 - select_4021[9:0];
  // hls/stages/patches.hpp:580
  logic less_4064;
  assign less_4064 = select_4025 < select_4027;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4065;
  assign sum_4065 = select_3990[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4064 ? select_4027 : select_4025;
  logic [9:0] low;
  assign low = (select_4027 < select_4025) ? select_4027 : select_4025;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_4021[9:0];
  // hls/stages/patches.hpp:584
  logic not_4072;
  assign not_4072 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4073;
  assign sum_4073 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4075;
  assign not_4075 = ~({eight, 3'h0} < {1'b0, sum_4073, fall_2[0]});
  logic [1:0] sum_4076;
  assign sum_4076 = {1'b0, not_4072} + {1'b0, not_4075};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4077;
  assign sum_4077 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4079;
  assign not_4079 = ~({eight, 3'h0} < {sum_4077, fall_2[1:0]});
  logic not_4082;
  assign not_4082 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4083;
  assign sum_4083 = {1'b0, not_4079} + {1'b0, not_4082};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4076} + {1'b0, sum_4083};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4086;
  assign select_4086 = less_4064 ? ({sum_4065, select_3990[2:0], 3'h0} - {5'h0, fraction}) : {sum_4065, select_3990[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_4309;
  assign select_4309 = equal_565_s2_q ? shown_shown_q : (so_s2_q ? select_2486 : shown_shown_q);
  logic select_4311;
  assign select_4311 = equal_565_s2_q ? shown_nearer_q : (so_s2_q ? select_2489 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4313;
  assign sum_4313 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4315;
  assign select_4315 = less_4312_s2_q ? (sum_4313[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4317;
  assign select_4317 = equal_2929_s2_q ? (equal_670_s2_q ? 3'h0 : select_4315) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4322;
  assign select_4322 = equal_565_s2_q ? select_2440 : (so_s2_q ? (ends_cell_s2_q ? select_2538 : select_2440) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4336;
  assign select_4336 = equal_670_s2_q ? {{2{difference_4334[6]}}, difference_4334} : (less_4312_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4338;
  assign select_4338 = and_540_s2_q ? (equal_2929_s2_q ? select_4336 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4340;
  assign select_4340 = equal_670_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4342;
  assign select_4342 = and_540_s2_q ? (equal_2929_s2_q ? select_4340 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4343;
  assign sum_4343 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4344;
  assign select_4344 = sum_4313[7] ? {1'b1, sum_4313[6:0], region_down_rest_q[0]} : sum_4343;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4313[7];
  // hls/stages/agreement.hpp:460
  logic select_4348;
  assign select_4348 = equal_2929_s2_q ? (equal_670_s2_q | (less_4312_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4353;
  assign or_4353 = segment_starts_q | not_568_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4356;
  assign select_4356 = inside_v_s2_q ? (sum_2453_s2_q ? (equal_2234 & or_2455) : or_2455) : or_4353;
  // hls/stages/agreement.hpp:788
  logic select_4359;
  assign select_4359 = equal_565_s2_q ? or_4353 : (so_s2_q ? (ends_cell_s2_q ? select_4356 : or_4353) : or_4353);
  // hls/stages/agreement.hpp:1147
  logic equal_4383;
  assign equal_4383 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4519;
  assign select_4519 = so_s2_q ? (ends_cell_s2_q ? and_2526 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4522;
  assign select_4522 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4524;
  assign select_4524 = equal_565_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4522 : centres_values_0_of_skin_q);
  logic select_4525;
  assign select_4525 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4527;
  assign select_4527 = equal_565_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4525 : centres_values_1_textured_q);
  logic select_4528;
  assign select_4528 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4530;
  assign select_4530 = equal_565_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4528 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4534;
  assign select_4534 = equal_2929_s2_q ? (equal_4531_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4537;
  assign select_4537 = and_540_s2_q ? (equal_2929_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4548;
  assign select_4548 = select_2498 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4554;
  assign select_4554 = marks_first_s2_q ? (less_4550 ? {sum_4551, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4624;
  assign not_4624 = ~quarter[1];
  logic [3:0] select_4625;
  assign select_4625 = quarter[0] ? {quarter[1], 1'b0, not_4624, 1'b0} : {1'b0, quarter[1], 1'b0, not_4624};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2079;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2122;
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
  assign patches_choices_raddr = select_2153;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2155));
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
  assign regions_raddr = select_2450;
  logic regions_re;
  assign regions_re = s2_en & (equal_565_s2_q ? (x_s2_q[6] & not_2451) : and_2458);
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
  assign map_raddr = {sum_2510, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2517 & less_2518);
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
  assign averager_memory_waddr = select_505_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_514_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_533, and_529, sum_525, sum_521};
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
  assign census_memory_we = s2_en & and_540_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_558, whole_2, select_550, select_546};
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
  assign moments_memory_waddr = select_564_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_582_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_637_s2_q, and_635_s2_q, and_630_s2_q, and_628};
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
  assign best_left_we = s2_en & and_2026_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2025, select_2022, select_2019, select_2017, select_1990, select_1987, select_1979, select_1978, select_1974};
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
  assign best_right_we = s2_en & and_2026_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2036, select_2035, select_2032, select_2031};
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
  assign shown_right_waddr = select_2043_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2054;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2051, not_568_s2_q};
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
  assign left_turns_wdata = {and_2062, and_2059};
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
  assign right_turns_wdata = {and_2071, and_2068};
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
  assign patches_right_codes_waddr = {sum_2354, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2406_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2392_s2_q, and_2389_s2_q, and_2373_s2_q, and_2370, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2410, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2420_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2392_s2_q, and_2389_s2_q, and_2373_s2_q, and_2370, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2039_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2485, textured};
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
      averager_running_of_skin_q <= select_2653;
      averager_mask_q <= select_2655;
      averager_of_skin_q <= select_2657;
      census_filled_q <= and_540_s2_q ? {select_673[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2752;
      moments_turned_1_q <= sum_2754;
      moments_before_0_q <= equal_565_s2_q ? select_2756 : moments_before_0_q;
      moments_before_1_q <= equal_565_s2_q ? select_2758 : moments_before_1_q;
      moments_has_before_q <= select_2761;
      moments_most_before_q <= select_2764;
      moments_left_begins_q <= select_2768;
      moments_left_alone_q <= select_2772;
      moments_left_other_stops_q <= select_2775;
      moments_right_begins_q <= select_2778;
      moments_right_alone_q <= select_2782;
      moments_right_other_stops_q <= select_2785;
      moments_out_of_step_q <= or_2788;
      moments_turns_0_q <= and_2796;
      moments_turns_1_q <= and_2800;
      moments_begins_alone_q <= and_2809;
      moments_ends_q <= equal_565_s2_q & (equal_2755 & (not_2810 | and_2812));
      rows_passed_above_q <= and_540_s2_q ? select_672 : rows_passed_above_q;
      shift_allowed_q <= not_3026 & (~less_3027);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3034 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3153});
      counts_turned_right_q <= and_3034 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3160});
      registration_displacement_over_q <= so_s2_q ? sum_3184[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3186;
      registration_slope_here_q <= select_3188;
      registration_expected_q <= select_3190;
      registration_of_right_q <= equal_565_s2_q ? registration_of_right_q : select_3252;
      registration_was_inside_q <= equal_565_s2_q ? registration_was_inside_q : select_3255;
      registration_fresh_q <= select_3264;
      patches_chance_q <= and_540_s2_q ? select_3421 : patches_chance_q;
      patches_fixed_q <= and_3436;
      patches_choice_valid_q <= and_2239 ? (select_2212 & not_3423) : select_2212;
      patches_choice_column_q <= select_2217;
      patches_choice_shift_q <= select_2222;
      patches_choice_slope_q <= select_2233;
      patches_band_q <= sample_pair_whole_s2_q ? select_2254 : patches_band_q;
      patches_fetch_q <= select_3450;
      patches_codes_at_q <= select_3551;
      patches_codes_further_q <= equal_2241_s2_q ? patches_codes_further_q : select_3556;
      patches_next_codes_q <= select_3564;
      patches_set_q <= equal_2241_s2_q ? 3'h0 : (equal_2243_s2_q ? 3'h0 : select_3578);
      patches_size_q <= sum_3582;
      patches_left_row_q <= select_3594;
      patches_summed_row_column_q <= equal_2241_s2_q ? patches_summed_row_column_q : select_3939;
      patches_summed_first_q <= select_3942;
      patches_read_row_differing_q <= equal_2241_s2_q ? select_3954 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2241_s2_q ? select_3961 : patches_read_row_column_q;
      patches_read_at_q <= equal_2241_s2_q ? select_3968 : patches_read_at_q;
      patches_read_first_q <= select_3977;
      patches_read_above_q <= select_4000;
      patches_read_below_q <= select_4009;
      patches_read_far_q <= equal_2241_s2_q ? select_4019 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4022;
      patches_peak_best_column_q <= select_4023;
      patches_peak_row_q <= equal_2241_s2_q ? select_3990 : patches_peak_row_q;
      patches_peak_above_q <= equal_2241_s2_q ? select_4025 : patches_peak_above_q;
      patches_peak_below_q <= equal_2241_s2_q ? select_4027 : patches_peak_below_q;
      patches_peak_far_q <= equal_2241_s2_q ? select_4031 : patches_peak_far_q;
      patches_frame_ended_q <= equal_565_s2_q & equal_2755;
      shown_shown_q <= select_4309;
      shown_nearer_q <= select_4311;
      region_row_q <= and_540_s2_q ? select_4317 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4322;
      region_down_rest_q <= select_4338;
      region_down_back_q <= select_4342;
      region_down_next_q <= select_4344;
      region_fresh_q <= and_540_s2_q ? select_4348 : region_fresh_q;
      segment_starts_q <= select_4359;
      centres_values_0_textured_q <= equal_565_s2_q ? centres_values_0_textured_q : select_4519;
      centres_values_0_of_skin_q <= select_4524;
      centres_values_1_textured_q <= select_4527;
      centres_values_1_of_skin_q <= select_4530;
      map_row_q <= and_540_s2_q ? select_4534 : map_row_q;
      map_width_q <= select_4537;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2509;
      done_q <= not_2511 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_565_s2_q & equal_4383;
      rows_passed_q <= select_2494;
      columns_passed_q <= {select_2496[7:0], or_2492};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2513;
      seen_x_q <= select_2515;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4548;
      seen_column_q <= select_2506;
      seen_rows_left_q <= select_4554;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2503;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_517 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_523 : averager_running_1_q;
      averager_total_0_q <= select_2631;
      averager_total_1_q <= select_2633;
      census_columns_values_0_cell_0_left_q <= select_2658;
      census_columns_values_0_cell_0_right_q <= select_2659;
      census_columns_values_0_cell_0_mask_q <= and_540_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2661;
      census_columns_values_0_cell_1_right_q <= select_2662;
      census_columns_values_0_cell_1_mask_q <= select_2663;
      census_columns_values_0_cell_2_left_q <= select_2664;
      census_columns_values_0_cell_2_right_q <= select_2665;
      census_columns_values_0_cell_2_mask_q <= select_2666;
      census_columns_values_0_cell_2_of_skin_q <= select_2667;
      census_columns_values_0_cell_3_left_q <= select_2668;
      census_columns_values_0_cell_3_right_q <= select_2669;
      census_columns_values_0_cell_3_mask_q <= select_2670;
      census_columns_values_0_cell_4_left_q <= select_2671;
      census_columns_values_0_cell_4_right_q <= select_2672;
      census_columns_values_0_cell_4_mask_q <= select_2673;
      census_columns_values_1_cell_0_left_q <= select_2674;
      census_columns_values_1_cell_0_right_q <= select_2675;
      census_columns_values_1_cell_0_mask_q <= select_2676;
      census_columns_values_1_cell_1_left_q <= select_2677;
      census_columns_values_1_cell_1_right_q <= select_2678;
      census_columns_values_1_cell_1_mask_q <= select_2679;
      census_columns_values_1_cell_2_left_q <= select_2680;
      census_columns_values_1_cell_2_right_q <= select_2681;
      census_columns_values_1_cell_2_mask_q <= select_2682;
      census_columns_values_1_cell_2_of_skin_q <= select_2683;
      census_columns_values_1_cell_3_left_q <= select_2684;
      census_columns_values_1_cell_3_right_q <= select_2685;
      census_columns_values_1_cell_3_mask_q <= select_2686;
      census_columns_values_1_cell_4_left_q <= select_2687;
      census_columns_values_1_cell_4_right_q <= select_2688;
      census_columns_values_1_cell_4_mask_q <= select_2689;
      census_columns_values_2_cell_0_left_q <= select_2690;
      census_columns_values_2_cell_0_right_q <= select_2691;
      census_columns_values_2_cell_0_mask_q <= select_2692;
      census_columns_values_2_cell_1_left_q <= select_2693;
      census_columns_values_2_cell_1_right_q <= select_2694;
      census_columns_values_2_cell_1_mask_q <= select_2695;
      census_columns_values_2_cell_2_left_q <= select_2696;
      census_columns_values_2_cell_2_right_q <= select_2697;
      census_columns_values_2_cell_2_mask_q <= select_2698;
      census_columns_values_2_cell_3_left_q <= select_2699;
      census_columns_values_2_cell_3_right_q <= select_2700;
      census_columns_values_2_cell_3_mask_q <= select_2701;
      census_columns_values_2_cell_4_left_q <= select_2702;
      census_columns_values_2_cell_4_right_q <= select_2703;
      census_columns_values_2_cell_4_mask_q <= select_2704;
      census_columns_values_3_cell_0_mask_q <= select_2705;
      census_columns_values_3_cell_1_left_q <= select_2706;
      census_columns_values_3_cell_1_right_q <= select_2707;
      census_columns_values_3_cell_1_mask_q <= select_2708;
      census_columns_values_3_cell_2_mask_q <= select_2709;
      census_columns_values_3_cell_3_left_q <= select_2710;
      census_columns_values_3_cell_3_right_q <= select_2711;
      census_columns_values_3_cell_3_mask_q <= select_2712;
      census_columns_values_3_cell_4_mask_q <= select_2713;
      sharpness_last_mean_0_q <= and_540_s2_q ? select_546 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_540_s2_q ? select_550 : sharpness_last_mean_1_q;
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
  logic [2:0] select_501_s3_q;
  logic row_starts_s3_q;
  logic [6:0] select_534_s3_q;
  logic [6:0] last_s3_q;
  logic and_538_s3_q;
  logic and_540_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_543_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_560_s3_q;
  logic equal_565_s3_q;
  logic not_566_s3_q;
  logic less_643_s3_q;
  logic less_644_s3_q;
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
  logic and_674_s3_q;
  logic and_699_s3_q;
  logic and_700_s3_q;
  logic [11:0] sum_715_s3_q;
  logic [9:0] sum_718_s3_q;
  logic and_726_s3_q;
  logic and_730_s3_q;
  logic less_731_s3_q;
  logic less_735_s3_q;
  logic less_737_s3_q;
  logic equal_2072_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2078_s3_q;
  logic equal_2080_s3_q;
  logic equal_2082_s3_q;
  logic equal_2084_s3_q;
  logic equal_2086_s3_q;
  logic equal_2088_s3_q;
  logic equal_2090_s3_q;
  logic equal_2092_s3_q;
  logic equal_2094_s3_q;
  logic less_2103_s3_q;
  logic or_2107_s3_q;
  logic equal_2127_s3_q;
  logic and_2137_s3_q;
  logic select_2154_s3_q;
  logic equal_2155_s3_q;
  logic and_2163_s3_q;
  logic equal_2165_s3_q;
  logic select_2212_s3_q;
  logic and_2240_s3_q;
  logic equal_2241_s3_q;
  logic equal_2243_s3_q;
  logic and_2256_s3_q;
  logic [4:0] select_2271_s3_q;
  logic select_2277_s3_q;
  logic [3:0] select_2317_s3_q;
  logic less_2421_s3_q;
  logic equal_2422_s3_q;
  logic not_2423_s3_q;
  logic equal_2424_s3_q;
  logic or_2443_s3_q;
  logic or_2446_s3_q;
  logic or_2449_s3_q;
  logic not_2451_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2478_s3_q;
  logic and_2483_s3_q;
  logic and_2517_s3_q;
  logic less_2518_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2523_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2541_s3_q;
  logic or_2544_s3_q;
  logic or_2547_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2597_s3_q;
  logic [11:0] sum_2729_s3_q;
  logic [9:0] sum_2732_s3_q;
  logic equal_2740_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3034_s3_q;
  logic and_3040_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3102_s3_q;
  logic and_3136_s3_q;
  logic and_3194_s3_q;
  logic and_3195_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3231_s3_q;
  logic and_3245_s3_q;
  logic equal_3288_s3_q;
  logic parity_3666_s3_q;
  logic parity_3795_s3_q;
  logic parity_3857_s3_q;
  logic xor_3885_s3_q;
  logic parity_3897_s3_q;
  logic or_3901_s3_q;
  logic equal_3902_s3_q;
  logic [4:0] select_4021_s3_q;
  logic equal_4033_s3_q;
  logic less_4035_s3_q;
  logic less_4036_s3_q;
  logic or_4041_s3_q;
  logic [7:0] select_4086_s3_q;
  logic equal_4383_s3_q;
  logic and_4560_s3_q;
  logic not_4574_s3_q;
  logic equal_4627_s3_q;
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
      select_501_s3_q <= select_501_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_534_s3_q <= select_534_s2_q;
      last_s3_q <= last_s2_2_q;
      and_538_s3_q <= and_538_s2_q;
      and_540_s3_q <= and_540_s2_q;
      grey_s3_q <= grey;
      equal_543_s3_q <= equal_543;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_560_s3_q <= equal_560_s2_q;
      equal_565_s3_q <= equal_565_s2_q;
      not_566_s3_q <= not_566_s2_q;
      less_643_s3_q <= less_643;
      less_644_s3_q <= less_644;
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
      and_674_s3_q <= and_674;
      and_699_s3_q <= whole_22 & and_674;
      and_700_s3_q <= census_columns_values_1_cell_2_mask_q & and_674;
      sum_715_s3_q <= {1'b0, sum_711} + {2'h0, sum_714};
      sum_718_s3_q <= {9'h0, difference_716[9]} + {1'b0, xor_717};
      and_726_s3_q <= and_726;
      and_730_s3_q <= and_730;
      less_731_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_735_s3_q <= {{5{sum_734[6]}}, sum_734, half_grey_levels_2[3:0]} < 16'hffe1;
      less_737_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2072_s3_q <= equal_2072;
      all_s3_q <= all;
      sum_2078_s3_q <= sum_2078;
      equal_2080_s3_q <= equal_2080;
      equal_2082_s3_q <= equal_2082;
      equal_2084_s3_q <= equal_2084;
      equal_2086_s3_q <= equal_2086;
      equal_2088_s3_q <= equal_2088;
      equal_2090_s3_q <= equal_2090;
      equal_2092_s3_q <= equal_2092;
      equal_2094_s3_q <= equal_2094;
      less_2103_s3_q <= less_2103;
      or_2107_s3_q <= or_2107;
      equal_2127_s3_q <= (registration_fresh_q & select_2125) == 4'h0;
      and_2137_s3_q <= not_566_s2_q & and_2121;
      select_2154_s3_q <= select_2154[1];
      equal_2155_s3_q <= equal_2155;
      and_2163_s3_q <= and_2163;
      equal_2165_s3_q <= equal_2165;
      select_2212_s3_q <= select_2212;
      and_2240_s3_q <= and_2240;
      equal_2241_s3_q <= equal_2241_s2_q;
      equal_2243_s3_q <= equal_2243_s2_q;
      and_2256_s3_q <= and_2240 & equal_2255;
      select_2271_s3_q <= select_2271_s2_q;
      select_2277_s3_q <= select_2277_s2_q;
      select_2317_s3_q <= select_2317_s2_q;
      less_2421_s3_q <= less_2421_s2_q;
      equal_2422_s3_q <= equal_2422_s2_q;
      not_2423_s3_q <= not_2423_s2_q;
      equal_2424_s3_q <= equal_2424_s2_q;
      or_2443_s3_q <= or_2443;
      or_2446_s3_q <= or_2446;
      or_2449_s3_q <= or_2449;
      not_2451_s3_q <= not_2451;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2478_s3_q <= inside_v_s2_q & (and_2476 & and_2050);
      and_2483_s3_q <= not_566_s2_q & and_2458;
      and_2517_s3_q <= and_2517;
      less_2518_s3_q <= less_2518;
      index_2_s3_q <= index_2[5:0];
      sum_2523_s3_q <= sum_2523;
      textured_2_s3_q <= textured_2;
      or_2541_s3_q <= or_2541;
      or_2544_s3_q <= select_2538[7] | (~({select_2538[6], select_2538[3:2]} == 3'h0));
      or_2547_s3_q <= select_2538[7] | (~(select_2538[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2597_s3_q <= and_2597;
      sum_2729_s3_q <= {1'b0, sum_2725} + {2'h0, sum_2728};
      sum_2732_s3_q <= {9'h0, difference_2730[9]} + {1'b0, xor_2731};
      equal_2740_s3_q <= equal_2740_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3034_s3_q <= and_3034;
      and_3040_s3_q <= and_3040;
      explained_2_s3_q <= explained_2;
      and_3102_s3_q <= not_566_s2_q & and_3101;
      and_3136_s3_q <= not_566_s2_q & and_3135;
      and_3194_s3_q <= not_566_s2_q & (so_s2_q & (half_ends & equal_3191));
      and_3195_s3_q <= and_3195;
      residual_s3_q <= residual[7:0];
      and_3231_s3_q <= and_3231;
      and_3245_s3_q <= and_3195 & less_3244;
      equal_3288_s3_q <= (registration_fresh_q & select_3286) == 4'h0;
      parity_3666_s3_q <= ^{xor_3662, xor_3625, select_3592[44:36], other[44:36]};
      parity_3795_s3_q <= parity_3795;
      parity_3857_s3_q <= parity_3857;
      xor_3885_s3_q <= parity_3872 ^ parity_3884;
      parity_3897_s3_q <= ^{or_3894, or_3890, and_3886};
      or_3901_s3_q <= (or_3890 & or_3894) | (and_3886 & (or_3890 | or_3894));
      equal_3902_s3_q <= equal_3902_s2_q;
      select_4021_s3_q <= select_4021[14:10];
      equal_4033_s3_q <= select_3990[3:0] == 4'h0;
      less_4035_s3_q <= {difference_4034, 3'h0} < {3'h0, sum_3582};
      less_4036_s3_q <= select_4031 < select_4021[9:0];
      or_4041_s3_q <= (sum_3582 < 10'h39) | ({1'b0, sum_3582[9:1]} < select_4021[9:0]);
      select_4086_s3_q <= select_4086;
      equal_4383_s3_q <= equal_4383;
      and_4560_s3_q <= and_2597 & ({sum_2523, index_2[5:0]} == {sum_2510, index[5:0]});
      not_4574_s3_q <= ~proven_q;
      equal_4627_s3_q <= (registration_fresh_q & select_4625) == 4'h0;
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
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_715_s3_q + {2'h0, sum_718_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_720;
  assign sum_720 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_722;
  assign sum_722 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_720});
  // hls/stages/census.hpp:317
  logic less_723;
  assign less_723 = 9'h4 < sum_722[13:5];
  logic and_724;
  assign and_724 = and_674_s3_q & less_723;
  // hls/stages/moments.hpp:30
  logic and_736;
  assign and_736 = (and_699_s3_q & and_726_s3_q) & less_735_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2129;
  assign equal_2129 = sum_2078_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2078_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2131;
  assign select_2131 = equal_2129 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2132;
  assign sum_2132 = (equal_2127_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2131[13]}}, select_2131};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2078_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2135;
  assign select_2135 = equal_2129 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2136;
  assign sum_2136 = (equal_2127_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2135[6]}}, select_2135};
  // hls/stages/patches.hpp:354
  logic [22:0] select_2257;
  assign select_2257 = and_2256_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2212_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2259;
  assign select_2259 = equal_2155_s3_q ? patches_place_0_valid_q : (select_2154_s3_q ? patches_place_0_valid_q : select_2257[0]);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2260;
  assign sum_2260 = {1'b0, select_534_s3_q, select_501_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:355
  logic [21:0] select_2261;
  assign select_2261 = select_2154_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2257[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2262;
  assign select_2262 = equal_2155_s3_q ? patches_place_0_column_q : select_2261[7:0];
  logic [5:0] select_2263;
  assign select_2263 = equal_2155_s3_q ? patches_place_0_shift_q : select_2261[13:8];
  // hls/stages/patches.hpp:324
  logic [8:0] sum_2264;
  assign sum_2264 = {1'b0, select_2262} + {{3{select_2263[5]}}, select_2263};
  // hls/stages/patches.hpp:132
  logic equal_2265;
  assign equal_2265 = {sum_2264, sum_2260[0], select_501_s3_q[1:0]} == {1'b0, sum_2260[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2267;
  assign or_2267 = row_starts_s3_q | (select_2259 & equal_2265);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2268;
  assign select_2268 = or_2267 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2278;
  assign select_2278 = or_2267 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2280;
  assign and_2280 = select_2277_s3_q & (~select_2278[5]);
  // hls/stages/patches.hpp:127
  logic select_2288;
  assign select_2288 = equal_2155_s3_q ? patches_place_1_valid_q : (select_2154_s3_q ? select_2257[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:355
  logic [21:0] select_2289;
  assign select_2289 = select_2154_s3_q ? select_2257[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2290;
  assign select_2290 = equal_2155_s3_q ? patches_place_1_column_q : select_2289[7:0];
  logic [5:0] select_2291;
  assign select_2291 = equal_2155_s3_q ? patches_place_1_shift_q : select_2289[13:8];
  // hls/stages/patches.hpp:324
  logic [8:0] sum_2292;
  assign sum_2292 = {1'b0, select_2290} + {{3{select_2291[5]}}, select_2291};
  // hls/stages/patches.hpp:132
  logic equal_2293;
  assign equal_2293 = {sum_2292[8], sum_2260, select_501_s3_q[1:0]} == {1'b0, sum_2292[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2295;
  assign or_2295 = row_starts_s3_q | (select_2288 & equal_2293);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2296;
  assign select_2296 = or_2295 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2297;
  assign select_2297 = or_2295 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2299;
  assign and_2299 = select_2277_s3_q & (~select_2297[5]);
  // hls/stages/patches.hpp:320
  logic [7:0] sum_2306;
  assign sum_2306 = select_2262 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2307;
  assign equal_2307 = {sum_2306[7], select_534_s3_q, select_501_s3_q} == {1'b0, sum_2306[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2309;
  assign or_2309 = row_starts_s3_q | (select_2259 & equal_2307);
  logic [4:0] select_2310;
  assign select_2310 = or_2309 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:320
  logic [7:0] sum_2311;
  assign sum_2311 = select_2290 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2312;
  assign equal_2312 = {sum_2311[7], select_534_s3_q, select_501_s3_q} == {1'b0, sum_2311[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2315;
  assign select_2315 = (row_starts_s3_q | (select_2288 & equal_2312)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2310[4] ? select_2315[3:0] : select_2310[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2318;
  assign select_2318 = or_2309 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2324;
  assign and_2324 = (select_2277_s3_q & (select_2271_s3_q[3] ^ select_2271_s3_q[4])) & ((~select_2310[4]) | (~select_2315[4]));
  // hls/stages/patches.hpp:185
  logic less_2433;
  assign less_2433 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_2434;
  assign not_2434 = ~less_2433;
  logic [1:0] select_2435;
  assign select_2435 = patches_summed_first_s3_q ? 2'h2 : {less_2433, not_2434};
  logic [12:0] select_2437;
  assign select_2437 = select_2435[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2438;
  assign select_2438 = select_2435[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2439;
  assign select_2439 = (select_2435 == 2'h2) ? {select_2437[12:8], patches_sums_values_0_q[9:8], select_2437[7:0]} : select_2438;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2464;
  assign select_2464 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2465;
  assign sum_2465 = {6'h0, textured_s3_q} + select_2464;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2467;
  assign sum_2467 = {3'h0, sum_2465} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2469;
  assign select_2469 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2470;
  assign sum_2470 = {6'h0, explained_s3_q} + select_2469;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2472;
  assign sum_2472 = {3'h0, sum_2470} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2479;
  assign select_2479 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2480;
  assign sum_2480 = {6'h0, and_2478_s3_q} + select_2479;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2482;
  assign sum_2482 = {3'h0, sum_2480} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2532;
  assign select_2532 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2533;
  assign difference_2533 = {1'b0, textured_2_s3_q} - {1'b0, select_2532};
  logic [4:0] t;
  assign t = {difference_2533[3], difference_2533} + (equal_560_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2536;
  assign equal_2536 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2548;
  assign not_2548 = ~region_row_s3_q[2];
  logic [2:0] select_2549;
  assign select_2549 = region_row_s3_q[1] ? {1'b0, not_2548, 1'b0} : {region_row_s3_q[2], 1'b0, not_2548};
  logic [5:0] select_2550;
  assign select_2550 = region_row_s3_q[0] ? {select_2549[2], 1'b0, select_2549[1], 1'b0, select_2549[0], 1'b0} : {1'b0, select_2549[2], 1'b0, select_2549[1], 1'b0, select_2549[0]};
  logic [11:0] select_2551;
  assign select_2551 = or_2547_s3_q ? {select_2550[5], 1'b0, select_2550[4], 1'b0, select_2550[3], 1'b0, select_2550[2], 1'b0, select_2550[1], 1'b0, select_2550[0], 1'b0} : {1'b0, select_2550[5], 1'b0, select_2550[4], 1'b0, select_2550[3], 1'b0, select_2550[2], 1'b0, select_2550[1], 1'b0, select_2550[0]};
  logic [23:0] select_2552;
  assign select_2552 = or_2544_s3_q ? {select_2551[11], 1'b0, select_2551[10], 1'b0, select_2551[9], 1'b0, select_2551[8], 1'b0, select_2551[7], 1'b0, select_2551[6], 1'b0, select_2551[5], 1'b0, select_2551[4], 1'b0, select_2551[3], 1'b0, select_2551[2], 1'b0, select_2551[1], 1'b0, select_2551[0], 1'b0} : {1'b0, select_2551[11], 1'b0, select_2551[10], 1'b0, select_2551[9], 1'b0, select_2551[8], 1'b0, select_2551[7], 1'b0, select_2551[6], 1'b0, select_2551[5], 1'b0, select_2551[4], 1'b0, select_2551[3], 1'b0, select_2551[2], 1'b0, select_2551[1], 1'b0, select_2551[0]};
  logic [47:0] select_2553;
  assign select_2553 = or_2541_s3_q ? {select_2552[23], 1'b0, select_2552[22], 1'b0, select_2552[21], 1'b0, select_2552[20], 1'b0, select_2552[19], 1'b0, select_2552[18], 1'b0, select_2552[17], 1'b0, select_2552[16], 1'b0, select_2552[15], 1'b0, select_2552[14], 1'b0, select_2552[13], 1'b0, select_2552[12], 1'b0, select_2552[11], 1'b0, select_2552[10], 1'b0, select_2552[9], 1'b0, select_2552[8], 1'b0, select_2552[7], 1'b0, select_2552[6], 1'b0, select_2552[5], 1'b0, select_2552[4], 1'b0, select_2552[3], 1'b0, select_2552[2], 1'b0, select_2552[1], 1'b0, select_2552[0], 1'b0} : {1'b0, select_2552[23], 1'b0, select_2552[22], 1'b0, select_2552[21], 1'b0, select_2552[20], 1'b0, select_2552[19], 1'b0, select_2552[18], 1'b0, select_2552[17], 1'b0, select_2552[16], 1'b0, select_2552[15], 1'b0, select_2552[14], 1'b0, select_2552[13], 1'b0, select_2552[12], 1'b0, select_2552[11], 1'b0, select_2552[10], 1'b0, select_2552[9], 1'b0, select_2552[8], 1'b0, select_2552[7], 1'b0, select_2552[6], 1'b0, select_2552[5], 1'b0, select_2552[4], 1'b0, select_2552[3], 1'b0, select_2552[2], 1'b0, select_2552[1], 1'b0, select_2552[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2557;
  assign and_2557 = good_known_q & (~((good_q & select_2553) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2566;
  assign select_2566 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2567;
  assign difference_2567 = {1'b0, shown_2_s3_q} - {1'b0, select_2566};
  logic [4:0] around;
  assign around = {difference_2567[3], difference_2567} + (equal_560_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2570;
  assign sum_2570 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2536 ? and_2557 : (~({sum_2570, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2582;
  assign select_2582 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2583;
  assign difference_2583 = {1'b0, near_2_s3_q} - {1'b0, select_2582};
  logic [4:0] n;
  assign n = {difference_2583[3], difference_2583} + (equal_560_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2587;
  assign and_2587 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2623;
  assign select_2623 = sample_pair_whole_s3_q ? (and_538_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2625;
  assign select_2625 = sample_pair_whole_s3_q ? (and_538_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2627;
  assign select_2627 = sample_pair_whole_s3_q ? (and_538_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2629;
  assign select_2629 = sample_pair_whole_s3_q ? (and_538_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2634;
  assign sum_2634 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2635;
  assign difference_2635 = {1'b0, sum_2634[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2636;
  assign xor_2636 = {difference_2635[8:0], sum_2634[0]} ^ {10{difference_2635[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2635[9]} + {1'b0, xor_2636};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_543_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2641;
  assign select_2641 = sample_pair_whole_s3_q ? (and_538_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2642;
  assign sum_2642 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2643;
  assign difference_2643 = {1'b0, sum_2642[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2644;
  assign xor_2644 = {difference_2643[8:0], sum_2642[0]} ^ {10{difference_2643[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2643[9]} + {1'b0, xor_2644};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_543_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2649;
  assign select_2649 = sample_pair_whole_s3_q ? (and_538_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2733;
  assign sum_2733 = sum_2729_s3_q + {2'h0, sum_2732_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2735;
  assign select_2735 = and_540_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2736;
  assign select_2736 = and_540_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2737;
  assign select_2737 = and_540_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2738;
  assign select_2738 = and_540_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2741;
  assign sum_2741 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2733};
  logic [13:0] sum_2743;
  assign sum_2743 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2741});
  // hls/stages/census.hpp:323
  logic and_2745;
  assign and_2745 = and_699_s3_q & (9'h4 < sum_2743[13:5]);
  // hls/stages/census.hpp:324
  logic and_2746;
  assign and_2746 = and_699_s3_q & less_723;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2747;
  assign sum_2747 = census_left_misses_q + {{17{and_2746}}, and_2745, 1'b0, and_2745};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2749;
  assign select_2749 = and_540_s3_q ? (equal_2740_s3_q ? 20'h0 : sum_2747) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2819;
  assign select_2819 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2822;
  assign select_2822 = and_540_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2825;
  assign and_2825 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2831;
  assign and_2831 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2832;
  assign and_2832 = and_2825 & and_2831;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2819[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2834;
  assign select_2834 = and_2832 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2836;
  assign select_2836 = equal_2740_s3_q ? {11'h0, select_2834} : (sharpness_sums_detail_0_q + {11'h0, select_2834});
  // hls/stages/agreement.hpp:457
  logic and_2843;
  assign and_2843 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2844;
  assign and_2844 = and_2825 & and_2843;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2819[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2846;
  assign select_2846 = and_2844 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2848;
  assign select_2848 = equal_2740_s3_q ? {11'h0, select_2846} : (sharpness_sums_detail_1_q + {11'h0, select_2846});
  logic [8:0] select_2851;
  assign select_2851 = and_2832 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2852;
  assign sum_2852 = (equal_2740_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2851};
  logic [8:0] select_2855;
  assign select_2855 = and_2844 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2856;
  assign sum_2856 = (equal_2740_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2855};
  // hls/stages/agreement.hpp:211
  logic equal_2858;
  assign equal_2858 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2859;
  assign less_2859 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2860;
  assign less_2860 = x_s3_q[4:0] < 5'h3;
  logic not_2861;
  assign not_2861 = ~x_s3_q[1];
  logic [2:0] select_2862;
  assign select_2862 = x_s3_q[0] ? {1'b0, not_2861, 1'b0} : {x_s3_q[1], 1'b0, not_2861};
  logic [5:0] select_2863;
  assign select_2863 = slot_s3_q[2] ? {select_2862[2], 1'b0, select_2862[1], 1'b0, select_2862[0], 1'b0} : {1'b0, select_2862[2], 1'b0, select_2862[1], 1'b0, select_2862[0]};
  logic [11:0] select_2864;
  assign select_2864 = slot_s3_q[1] ? {select_2863[5], 1'b0, select_2863[4], 1'b0, select_2863[3], 1'b0, select_2863[2], 1'b0, select_2863[1], 1'b0, select_2863[0], 1'b0} : {1'b0, select_2863[5], 1'b0, select_2863[4], 1'b0, select_2863[3], 1'b0, select_2863[2], 1'b0, select_2863[1], 1'b0, select_2863[0]};
  logic [23:0] select_2865;
  assign select_2865 = slot_s3_q[0] ? {select_2864[11], 1'b0, select_2864[10], 1'b0, select_2864[9], 1'b0, select_2864[8], 1'b0, select_2864[7], 1'b0, select_2864[6], 1'b0, select_2864[5], 1'b0, select_2864[4], 1'b0, select_2864[3], 1'b0, select_2864[2], 1'b0, select_2864[1], 1'b0, select_2864[0], 1'b0} : {1'b0, select_2864[11], 1'b0, select_2864[10], 1'b0, select_2864[9], 1'b0, select_2864[8], 1'b0, select_2864[7], 1'b0, select_2864[6], 1'b0, select_2864[5], 1'b0, select_2864[4], 1'b0, select_2864[3], 1'b0, select_2864[2], 1'b0, select_2864[1], 1'b0, select_2864[0]};
  // hls/stages/census.hpp:390
  logic and_2869;
  assign and_2869 = less_2860 & (~((sharpness_sums_contrast_1_q & select_2865) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2871;
  assign select_2871 = (less_2859 & and_2869) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2871};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2874;
  assign select_2874 = equal_2858 ? (less_2859 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2879;
  assign and_2879 = less_2860 & (~((sharpness_sums_contrast_0_q & select_2865) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2881;
  assign select_2881 = (less_2859 & and_2879) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2881};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2884;
  assign select_2884 = equal_2858 ? (less_2859 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2886;
  assign select_2886 = equal_2858 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2888;
  assign select_2888 = equal_2858 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2890;
  assign select_2890 = equal_2858 ? {sharpness_comparing_contrast_0_q[0], and_2879} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2892;
  assign select_2892 = equal_2858 ? {sharpness_comparing_contrast_1_q[0], and_2869} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2897;
  assign select_2897 = drew_q ? (equal_2858 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2901;
  assign select_2901 = drew_q ? (equal_2858 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2902;
  assign equal_2902 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2903;
  assign xor_2903 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2906;
  assign select_2906 = (equal_2902 | xor_2903) ? (five_times[0] & xor_2903) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2908;
  assign select_2908 = drew_q ? (equal_2858 ? select_2906 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2909;
  assign xor_2909 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2912;
  assign select_2912 = (equal_2902 | xor_2909) ? (five_times_2[0] & xor_2909) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2914;
  assign select_2914 = drew_q ? (equal_2858 ? select_2912 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2915;
  assign xor_2915 = sharpness_comparing_contrast_0_q[1] ^ and_2869;
  logic select_2918;
  assign select_2918 = (equal_2902 | xor_2915) ? (and_2869 & xor_2915) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2920;
  assign select_2920 = drew_q ? (equal_2858 ? select_2918 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2921;
  assign xor_2921 = sharpness_comparing_contrast_1_q[1] ^ and_2879;
  logic select_2924;
  assign select_2924 = (equal_2902 | xor_2921) ? (and_2879 & xor_2921) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2926;
  assign select_2926 = drew_q ? (equal_2858 ? select_2924 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3042;
  assign select_3042 = and_3034_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3040_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3045;
  assign and_3045 = not_566_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3050;
  assign and_3050 = not_566_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3055;
  assign and_3055 = not_566_s3_q & (drew_q & (ends_cell_s3_q & and_2478_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3059;
  assign not_3059 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3068;
  assign select_3068 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3069;
  assign difference_3069 = {1'b0, explained_2_s3_q} - {1'b0, select_3068};
  logic [4:0] e;
  assign e = {difference_3069[3], difference_3069} + (equal_560_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3072;
  assign sum_3072 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3076;
  assign not_3076 = ~(equal_2536 ? and_2557 : (~({sum_3072, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3079;
  assign and_3079 = ends_cell_s3_q & (not_3059 & (centres_values_1_textured_s3_q & not_3076));
  logic and_3081;
  assign and_3081 = not_566_s3_q & (drew_q & and_3079);
  // hls/stages/agreement.hpp:1132
  logic less_3084;
  assign less_3084 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3085;
  assign select_3085 = less_3084 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3088;
  assign select_3088 = less_3084 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3089;
  assign sum_3089 = {1'b0, select_3088} + {3'h0, select_3088[9:2]};
  logic and_3091;
  assign and_3091 = (~(select_3085[9:4] == 6'h0)) & ({sum_3089, select_3088[1:0]} < {3'h0, select_3085});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3094;
  assign select_3094 = x_s3_q[6] ? (equal_2072_s3_q ? 10'h0 : (and_3091 ? select_3085 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3095;
  assign select_3095 = equal_565_s3_q ? select_3094 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3097;
  assign select_3097 = and_3034_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3095});
  logic [13:0] select_3104;
  assign select_3104 = and_3034_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3102_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3106;
  assign and_3106 = not_3059 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3109;
  assign and_3109 = not_566_s3_q & (drew_q & (ends_cell_s3_q & and_3106));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3111;
  assign select_3111 = and_3034_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3109});
  // hls/stages/agreement.hpp:1110
  logic and_3113;
  assign and_3113 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3076);
  // hls/stages/agreement.hpp:788
  logic and_3117;
  assign and_3117 = not_566_s3_q & (drew_q & (ends_cell_s3_q & (not_3059 & and_3113)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3119;
  assign select_3119 = and_3034_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3117});
  logic [13:0] select_3138;
  assign select_3138 = and_3034_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3136_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3213;
  assign select_3213 = drew_q ? (equal_2165_s3_q ? (and_3195_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3214;
  assign select_3214 = equal_565_s3_q ? 8'h0 : select_3213;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3216;
  assign select_3216 = and_3194_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3214[7]}}, select_3214});
  // hls/stages/agreement.hpp:788
  logic and_3219;
  assign and_3219 = not_566_s3_q & (drew_q & (and_3195_s3_q & equal_2165_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3221;
  assign select_3221 = and_3194_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3219});
  // hls/stages/registration.hpp:107
  logic and_3223;
  assign and_3223 = and_3195_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3225;
  assign select_3225 = drew_q ? (equal_2165_s3_q ? {and_3223, and_3195_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3226;
  assign select_3226 = equal_565_s3_q ? 2'h0 : select_3225;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3227;
  assign sum_3227 = registration_half_votes_down_q + {{5{select_3226[1]}}, select_3226};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3233;
  assign select_3233 = drew_q ? (equal_2165_s3_q ? {and_3231_s3_q, and_3195_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3234;
  assign select_3234 = equal_565_s3_q ? 2'h0 : select_3233;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3235;
  assign sum_3235 = registration_half_votes_up_q + {{5{select_3234[1]}}, select_3234};
  // hls/stages/registration.hpp:107
  logic and_3238;
  assign and_3238 = and_3195_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3240;
  assign select_3240 = drew_q ? (equal_2165_s3_q ? {and_3238, and_3195_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3241;
  assign select_3241 = equal_565_s3_q ? 2'h0 : select_3240;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3242;
  assign sum_3242 = registration_half_half_votes_down_q + {{5{select_3241[1]}}, select_3241};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3247;
  assign select_3247 = drew_q ? (equal_2165_s3_q ? {and_3245_s3_q, and_3195_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3248;
  assign select_3248 = equal_565_s3_q ? 2'h0 : select_3247;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3249;
  assign sum_3249 = registration_half_half_votes_up_q + {{5{select_3248[1]}}, select_3248};
  // hls/stages/agreement.hpp:788
  logic and_3283;
  assign and_3283 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & less_2103_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3290;
  assign select_3290 = or_2107_s3_q ? 12'h0 : (equal_3288_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3293;
  assign select_3293 = x_s3_q[6] ? (equal_2072_s3_q ? 12'h0 : (less_2103_s3_q ? select_3290 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3294;
  assign select_3294 = equal_565_s3_q ? select_3293 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3295;
  assign and_3295 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3298;
  assign and_3298 = not_2451_s3_q & (less_2103_s3_q & ({and_3295, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3300;
  assign and_3300 = equal_565_s3_q & (x_s3_q[6] & and_3298);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3302;
  assign sum_3302 = {{2{select_3294[11]}}, select_3294} + (and_3300 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3305;
  assign select_3305 = or_2107_s3_q ? 12'h0 : (equal_3288_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3308;
  assign select_3308 = x_s3_q[6] ? (equal_2072_s3_q ? 12'h0 : (less_2103_s3_q ? select_3305 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3309;
  assign select_3309 = equal_565_s3_q ? select_3308 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3311;
  assign sum_3311 = {{2{select_3309[11]}}, select_3309} + (and_3300 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3313;
  assign not_3313 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3316;
  assign and_3316 = not_2451_s3_q & (less_2103_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3313, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3322;
  assign and_3322 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & (less_2103_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3323;
  assign not_3323 = ~and_3322;
  logic less_3324;
  assign less_3324 = $signed({9'h1, {2{not_3323}}, and_3322}) < $signed(registration_up_q[13:2]);
  logic select_3325;
  assign select_3325 = (equal_565_s3_q & (x_s3_q[6] & and_3316)) ? less_3324 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3329;
  assign and_3329 = x_s3_q[6] & (not_2451_s3_q & (less_2103_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3330;
  assign and_3330 = equal_565_s3_q & and_3329;
  // hls/stages/registration.hpp:242
  logic less_3331;
  assign less_3331 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3333;
  assign less_3333 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3335;
  assign equal_3335 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3339;
  assign and_3339 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & (less_2103_s3_q & equal_3335)));
  // hls/stages/agreement.hpp:1142
  logic and_3346;
  assign and_3346 = x_s3_q[6] & (not_2451_s3_q & (less_2103_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3349;
  assign equal_3349 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3352;
  assign and_3352 = not_2451_s3_q & (less_2103_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3349));
  // hls/stages/registration.hpp:244
  logic and_3356;
  assign and_3356 = (equal_565_s3_q & (x_s3_q[6] & and_3352)) & (less_3333 | less_3331);
  // hls/stages/agreement.hpp:1142
  logic and_3361;
  assign and_3361 = not_2451_s3_q & (less_2103_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3349)));
  // hls/stages/registration.hpp:244
  logic and_3364;
  assign and_3364 = registration_votes_up_q & registration_other_down_q;
  logic select_3366;
  assign select_3366 = registration_votes_down_q ? (registration_other_up_q | and_3364) : and_3364;
  // hls/stages/registration.hpp:138
  logic and_3368;
  assign and_3368 = (equal_565_s3_q & (x_s3_q[6] & and_3361)) & (registration_other_enough_q & select_3366);
  // hls/stages/registration.hpp:245
  logic or_3371;
  assign or_3371 = registration_moved_q | (registration_enough_q & (and_3356 | and_3368));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3455;
  assign select_3455 = sample_pair_whole_s3_q ? (equal_2155_s3_q ? patches_place_0_slope_q : select_2261[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3460;
  assign select_3460 = sample_pair_whole_s3_q ? (equal_2155_s3_q ? patches_place_1_slope_q : select_2289[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3462;
  assign select_3462 = equal_2155_s3_q ? patches_valid_0_q : (select_2154_s3_q ? patches_valid_0_q : select_2257[0]);
  // hls/stages/agreement.hpp:276
  logic select_3465;
  assign select_3465 = sample_pair_whole_s3_q ? (and_2280 ? (sample_present_s3_q & select_3462) : select_3462) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3467;
  assign select_3467 = equal_2155_s3_q ? patches_valid_1_q : (select_2154_s3_q ? select_2257[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3470;
  assign select_3470 = sample_pair_whole_s3_q ? (and_2299 ? (sample_present_s3_q & select_3467) : select_3467) : patches_valid_1_q;
  logic [5:0] select_3473;
  assign select_3473 = sample_pair_whole_s3_q ? (select_2278[5] ? {1'b1, select_2278[4:0]} : (select_2278 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3476;
  assign select_3476 = sample_pair_whole_s3_q ? (select_2297[5] ? {1'b1, select_2297[4:0]} : (select_2297 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3479;
  assign select_3479 = sample_pair_whole_s3_q ? (select_2310[4] ? {1'b1, select_2310[3:0]} : (select_2310 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3482;
  assign select_3482 = sample_pair_whole_s3_q ? (select_2315[4] ? {1'b1, select_2315[3:0]} : (select_2315 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3901_s3_q, parity_3897_s3_q, xor_3885_s3_q, parity_3857_s3_q, parity_3795_s3_q, parity_3666_s3_q} + (equal_3902_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3906;
  assign select_3906 = equal_2241_s3_q ? patches_sums_values_0_q : (equal_2243_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3907;
  assign select_3907 = equal_2243_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3909;
  assign select_3909 = equal_2243_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3911;
  assign select_3911 = equal_2243_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3913;
  assign select_3913 = equal_2243_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3915;
  assign select_3915 = equal_2243_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3917;
  assign select_3917 = equal_2243_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3919;
  assign select_3919 = equal_2243_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3921;
  assign select_3921 = equal_2243_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3923;
  assign select_3923 = equal_2243_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3925;
  assign select_3925 = equal_2243_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3927;
  assign select_3927 = equal_2243_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3929;
  assign select_3929 = equal_2243_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3931;
  assign select_3931 = equal_2243_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3933;
  assign select_3933 = equal_2243_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3935;
  assign select_3935 = equal_2243_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3937;
  assign select_3937 = equal_2243_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:600
  logic or_4042;
  assign or_4042 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4041_s3_q;
  logic or_4045;
  assign or_4045 = equal_4033_s3_q | (less_4035_s3_q | (less_4036_s3_q | or_4042));
  // hls/stages/patches.hpp:580
  logic not_4046;
  assign not_4046 = ~or_4045;
  // hls/stages/patches.hpp:561
  logic and_4047;
  assign and_4047 = equal_2424_s3_q & not_4046;
  // hls/stages/patches.hpp:185
  logic and_4050;
  assign and_4050 = equal_2241_s3_q & (less_2421_s3_q ? (not_2423_s3_q & and_4047) : and_4047);
  // hls/stages/patches.hpp:658
  logic not_4051;
  assign not_4051 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:561
  logic and_4053;
  assign and_4053 = equal_2424_s3_q & (patches_second_s3_q & not_4046);
  // hls/stages/patches.hpp:185
  logic and_4056;
  assign and_4056 = equal_2241_s3_q & (less_2421_s3_q ? (not_2423_s3_q & and_4053) : and_4053);
  // hls/stages/patches.hpp:658
  logic not_4057;
  assign not_4057 = ~and_4056;
  // hls/stages/patches.hpp:189
  logic and_4059;
  assign and_4059 = and_4050 & (not_4051 & not_4057);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4061;
  assign sum_4061 = {7'h0, and_4059} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:598
  logic [7:0] select_4087;
  assign select_4087 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [5:0] select_4088;
  assign select_4088 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4089;
  assign sum_4089 = {2'h0, select_4021_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4090;
  assign sum_4090 = {select_4088[5], select_4088} + {{3{sum_4089[3]}}, sum_4089};
  // hls/stages/patches.hpp:598
  logic [17:0] product_4091;
  assign product_4091 = $signed({{10{select_4087[7]}}, select_4087}) * $signed({{8{sum_4090[6]}}, sum_4090, select_4021_s3_q[2:0]});
  // hls/stages/patches.hpp:599
  logic [13:0] difference_4092;
  assign difference_4092 = {{6{select_4086_s3_q[7]}}, select_4086_s3_q} - {product_4091[17], product_4091[17:5]};
  // hls/stages/patches.hpp:605
  logic less_4093;
  assign less_4093 = $signed({{7{difference_4063[6]}}, difference_4063}) < $signed(difference_4092);
  // hls/stages/patches.hpp:561
  logic and_4096;
  assign and_4096 = equal_2424_s3_q & (not_4046 & (~less_4093));
  // hls/stages/patches.hpp:185
  logic and_4099;
  assign and_4099 = equal_2241_s3_q & (less_2421_s3_q ? (not_2423_s3_q & and_4096) : and_4096);
  // hls/stages/patches.hpp:661
  logic and_4100;
  assign and_4100 = and_4099 & and_4059;
  logic [7:0] sum_4101;
  assign sum_4101 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4100};
  // hls/stages/patches.hpp:561
  logic and_4105;
  assign and_4105 = not_4046 & (~($signed(difference_4092) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4106;
  assign and_4106 = equal_2424_s3_q & and_4105;
  // hls/stages/patches.hpp:185
  logic and_4109;
  assign and_4109 = equal_2241_s3_q & (less_2421_s3_q ? (not_2423_s3_q & and_4106) : and_4106);
  // hls/stages/patches.hpp:662
  logic and_4110;
  assign and_4110 = and_4109 & and_4059;
  logic [7:0] sum_4111;
  assign sum_4111 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4110};
  // hls/stages/patches.hpp:189
  logic and_4113;
  assign and_4113 = and_4050 & (and_4056 & not_4051);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4115;
  assign sum_4115 = {7'h0, and_4113} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_4117;
  assign and_4117 = and_4099 & and_4113;
  logic [7:0] sum_4118;
  assign sum_4118 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4117};
  // hls/stages/patches.hpp:662
  logic and_4120;
  assign and_4120 = and_4109 & and_4113;
  logic [7:0] sum_4121;
  assign sum_4121 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4120};
  // hls/stages/patches.hpp:189
  logic and_4123;
  assign and_4123 = and_4050 & (patches_lower_s3_q & not_4057);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4125;
  assign sum_4125 = {7'h0, and_4123} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_4127;
  assign and_4127 = and_4099 & and_4123;
  logic [7:0] sum_4128;
  assign sum_4128 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4127};
  // hls/stages/patches.hpp:662
  logic and_4130;
  assign and_4130 = and_4109 & and_4123;
  logic [7:0] sum_4131;
  assign sum_4131 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4130};
  // hls/stages/patches.hpp:189
  logic and_4133;
  assign and_4133 = and_4050 & (patches_lower_s3_q & and_4056);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4135;
  assign sum_4135 = {7'h0, and_4133} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_4137;
  assign and_4137 = and_4099 & and_4133;
  logic [7:0] sum_4138;
  assign sum_4138 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4137};
  // hls/stages/patches.hpp:662
  logic and_4140;
  assign and_4140 = and_4109 & and_4133;
  logic [7:0] sum_4141;
  assign sum_4141 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4140};
  // hls/stages/agreement.hpp:1223
  logic equal_4142;
  assign equal_4142 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4143;
  assign less_4143 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4147;
  assign and_4147 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & (equal_4142 & less_4143)));
  // hls/stages/agreement.hpp:1142
  logic and_4152;
  assign and_4152 = x_s3_q[6] & (not_2451_s3_q & (less_4143 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4153;
  assign and_4153 = equal_565_s3_q & and_4152;
  // hls/stages/patches.hpp:624
  logic [7:0] or_4155;
  assign or_4155 = (and_4147 ? patches_quarters_0_places_q : 8'h0) | (and_4153 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4159;
  assign and_4159 = x_s3_q[6] & (not_2451_s3_q & (less_4143 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4160;
  assign and_4160 = equal_565_s3_q & and_4159;
  // hls/stages/agreement.hpp:1142
  logic and_4166;
  assign and_4166 = x_s3_q[6] & (not_2451_s3_q & (less_4143 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4167;
  assign and_4167 = equal_565_s3_q & and_4166;
  // hls/stages/patches.hpp:624
  logic [7:0] or_4169;
  assign or_4169 = (or_4155 | (and_4160 ? patches_quarters_2_places_q : 8'h0)) | (and_4167 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:200
  logic select_4173;
  assign select_4173 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4177;
  assign and_4177 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & (less_4143 & select_4173)));
  // hls/stages/patches.hpp:625
  logic [7:0] select_4179;
  assign select_4179 = and_4147 ? (and_4177 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4181;
  assign select_4181 = and_4153 ? (and_4177 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4184;
  assign select_4184 = and_4160 ? (and_4177 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4187;
  assign select_4187 = and_4167 ? (and_4177 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_4190;
  assign select_4190 = and_4147 ? (and_4177 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4192;
  assign select_4192 = and_4153 ? (and_4177 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4195;
  assign select_4195 = and_4160 ? (and_4177 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4198;
  assign select_4198 = and_4167 ? (and_4177 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:203
  logic [4:0] sum_4200;
  assign sum_4200 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4204;
  assign and_4204 = x_s3_q[6] & (not_2451_s3_q & (less_4143 & (sum_4200[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4205;
  assign and_4205 = equal_565_s3_q & and_4204;
  // hls/stages/patches.hpp:621
  logic [7:0] select_4208;
  assign select_4208 = and_4205 ? (patches_word_places_q + (and_4153 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4211;
  assign select_4211 = and_4205 ? (patches_word_up_q + (and_4153 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4214;
  assign select_4214 = and_4205 ? (patches_word_down_q + (and_4153 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:607
  logic [5:0] select_4218;
  assign select_4218 = ($signed(difference_4092[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4092[5:0];
  logic [5:0] select_4219;
  assign select_4219 = ($signed(14'h10) < $signed(difference_4092)) ? 6'h10 : select_4218;
  // hls/stages/patches.hpp:561
  logic [5:0] select_4221;
  assign select_4221 = equal_2424_s3_q ? (or_4045 ? 6'h0 : select_4219) : 6'h0;
  logic [5:0] select_4223;
  assign select_4223 = less_2421_s3_q ? (equal_2422_s3_q ? 6'h0 : select_4221) : select_4221;
  // hls/stages/patches.hpp:664
  logic [5:0] select_4225;
  assign select_4225 = and_4050 ? (equal_2241_s3_q ? select_4223 : 6'h0) : 6'h0;
  logic [11:0] sum_4226;
  assign sum_4226 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4225[5]}}, select_4225};
  // hls/stages/agreement.hpp:788
  logic and_4230;
  assign and_4230 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q & (equal_3335 & less_4143)));
  // hls/stages/agreement.hpp:1142
  logic and_4234;
  assign and_4234 = x_s3_q[6] & (not_2451_s3_q & (less_4143 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4235;
  assign and_4235 = equal_565_s3_q & and_4234;
  // hls/stages/patches.hpp:648
  logic [7:0] select_4237;
  assign select_4237 = and_4230 ? (and_4235 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_4241;
  assign or_4241 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_4244;
  assign or_4244 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_4245;
  assign sum_4245 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_4247;
  assign select_4247 = and_4230 ? (and_4235 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_4250;
  assign and_4250 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_4252;
  assign select_4252 = and_4235 ? {and_4250, patches_found_q[2:1]} : (and_4230 ? {and_4250, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:646
  logic or_4256;
  assign or_4256 = patches_partly_q | (patches_doubted_q & (~and_4235));
  // hls/stages/patches.hpp:647
  logic select_4259;
  assign select_4259 = and_4230 ? (and_4235 ? or_4256 : (and_4230 ? or_4256 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:645
  logic select_4260;
  assign select_4260 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_4264;
  assign select_4264 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:606
  logic [10:0] sum_4266;
  assign sum_4266 = {sum_4090[6], sum_4090, select_4021_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:561
  logic and_4269;
  assign and_4269 = equal_2424_s3_q & (not_4046 & ({{5{sum_4266[10]}}, sum_4266} < 16'h3));
  // hls/stages/patches.hpp:185
  logic and_4272;
  assign and_4272 = equal_2241_s3_q & (less_2421_s3_q ? (not_2423_s3_q & and_4269) : and_4269);
  // hls/stages/patches.hpp:189
  logic and_4273;
  assign and_4273 = and_4050 & and_4272;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_4274;
  assign sum_4274 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4273};
  // hls/stages/patches.hpp:654
  logic [12:0] product_4279;
  assign product_4279 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4237};
  // hls/stages/patches.hpp:189
  logic and_4281;
  assign and_4281 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4279[12:5] < patches_on_skin_q);
  logic select_4286;
  assign select_4286 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_4290;
  assign or_4290 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_4297;
  assign select_4297 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_4303;
  assign and_4303 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4304;
  assign sum_4304 = patches_age_q + {9'h0, and_4303};
  logic [9:0] select_4307;
  assign select_4307 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4304)) : sum_4304;
  // hls/stages/agreement.hpp:1188
  logic or_4364;
  assign or_4364 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_4366;
  assign equal_4366 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_4372;
  assign select_4372 = (equal_4366 & equal_4142) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4375;
  assign sum_4375 = {1'b0, select_3088} + {2'h0, select_3088[9:1]};
  logic select_4378;
  assign select_4378 = (select_3085[9:3] == 7'h0) ? ((~or_4364) & (~select_4372)) : (~({sum_4375, select_3088[0]} < {2'h0, select_3085}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4380;
  assign select_4380 = x_s3_q[6] ? (equal_2072_s3_q ? good_q : {select_4378, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4385;
  assign select_4385 = equal_565_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4383_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_4386;
  assign equal_4386 = x_s3_q[6:3] == 4'ha;
  logic equal_4388;
  assign equal_4388 = x_s3_q[6:3] == 4'hc;
  logic equal_4389;
  assign equal_4389 = x_s3_q[6:3] == 4'hb;
  logic equal_4390;
  assign equal_4390 = x_s3_q[6:3] == 4'h9;
  logic equal_4391;
  assign equal_4391 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4393;
  assign select_4393 = equal_4390 ? counts_skin_unproven_q : (equal_4391 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4395;
  assign select_4395 = equal_4389 ? counts_regions_bad_q : (equal_4386 ? counts_nearer_q : select_4393);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4388 ? counts_on_skin_q : select_4395;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1230
  logic select_4398;
  assign select_4398 = (equal_4386 & equal_4142) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_4399;
  assign not_4399 = ~hidden_for_q[7];
  logic [7:0] select_4401;
  assign select_4401 = select_4398 ? (hidden_for_q + {7'h0, not_4399}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4403;
  assign select_4403 = equal_565_s3_q ? (equal_4383_s3_q ? select_4401 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4404;
  assign select_4404 = equal_4142 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4406;
  assign select_4406 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4408;
  assign select_4408 = equal_4391 ? cfg_unproven_skin_limit_i : (equal_4366 ? cfg_unproven_limit_i : select_4406);
  logic [7:0] select_4410;
  assign select_4410 = equal_4386 ? cfg_regions_limit_i : (equal_4390 ? cfg_hidden_limit_i : select_4408);
  logic [7:0] limit;
  assign limit = equal_4388 ? cfg_regions_limit_i : (equal_4389 ? {cfg_on_skin_limit_i, 3'h0} : select_4410);
  // hls/stages/agreement.hpp:1231
  logic not_4413;
  assign not_4413 = ~x_s3_q[2];
  logic [3:0] select_4414;
  assign select_4414 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4413, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4413};
  logic [7:0] select_4415;
  assign select_4415 = x_s3_q[0] ? {select_4414[3], 1'b0, select_4414[2], 1'b0, select_4414[1], 1'b0, select_4414[0], 1'b0} : {1'b0, select_4414[3], 1'b0, select_4414[2], 1'b0, select_4414[1], 1'b0, select_4414[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4419;
  assign select_4419 = equal_4390 ? counts_skin_supervised_q : (equal_4391 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4421;
  assign select_4421 = equal_4389 ? counts_skin_textured_q : (equal_4386 ? counts_textured_q : select_4419);
  logic [13:0] of;
  assign of = equal_4388 ? counts_textured_q : select_4421;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4423;
  assign select_4423 = ((limit & select_4415) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4404} + {1'b0, select_4423};
  // hls/stages/agreement.hpp:788
  logic select_4428;
  assign select_4428 = equal_565_s3_q ? (equal_4142 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_4433;
  assign and_4433 = too_much_q & (~(equal_4391 & equal_4142));
  // hls/stages/agreement.hpp:1229
  logic select_4438;
  assign select_4438 = (over[14] & equal_4142) ? (and_4433 | ((equal_4391 | equal_4390) | (x_s3_q[6:3] == 4'hf))) : and_4433;
  // hls/stages/agreement.hpp:1125
  logic and_4443;
  assign and_4443 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4444;
  assign select_4444 = (equal_4388 & equal_4142) ? and_4443 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_565_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4446 : box_textured_columns_values_0_q);
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_565_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4449 : box_textured_columns_values_1_q);
  logic [2:0] select_4452;
  assign select_4452 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4454;
  assign select_4454 = equal_565_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4452 : box_textured_columns_values_2_q);
  logic [2:0] select_4455;
  assign select_4455 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4457;
  assign select_4457 = equal_565_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4455 : box_textured_columns_values_3_q);
  logic [2:0] select_4458;
  assign select_4458 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4460;
  assign select_4460 = equal_565_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4458 : box_textured_columns_values_4_q);
  logic [4:0] select_4462;
  assign select_4462 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4464;
  assign select_4464 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4466;
  assign select_4466 = equal_565_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4464 : box_explained_columns_values_0_q);
  logic [2:0] select_4467;
  assign select_4467 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4469;
  assign select_4469 = equal_565_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4467 : box_explained_columns_values_1_q);
  logic [2:0] select_4470;
  assign select_4470 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4472;
  assign select_4472 = equal_565_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4470 : box_explained_columns_values_2_q);
  logic [2:0] select_4473;
  assign select_4473 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4475;
  assign select_4475 = equal_565_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4473 : box_explained_columns_values_3_q);
  logic [2:0] select_4476;
  assign select_4476 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4478;
  assign select_4478 = equal_565_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4476 : box_explained_columns_values_4_q);
  logic [4:0] select_4480;
  assign select_4480 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4483;
  assign select_4483 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4485;
  assign select_4485 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4487;
  assign select_4487 = equal_565_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4485 : box_shown_columns_values_1_q);
  logic [2:0] select_4488;
  assign select_4488 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4490;
  assign select_4490 = equal_565_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4488 : box_shown_columns_values_2_q);
  logic [2:0] select_4491;
  assign select_4491 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4493;
  assign select_4493 = equal_565_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4491 : box_shown_columns_values_3_q);
  logic [2:0] select_4494;
  assign select_4494 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4496;
  assign select_4496 = equal_565_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4494 : box_shown_columns_values_4_q);
  logic [4:0] select_4498;
  assign select_4498 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4501;
  assign select_4501 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4503;
  assign select_4503 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4505;
  assign select_4505 = equal_565_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4503 : box_nearer_columns_values_1_q);
  logic [2:0] select_4506;
  assign select_4506 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4508;
  assign select_4508 = equal_565_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4506 : box_nearer_columns_values_2_q);
  logic [2:0] select_4509;
  assign select_4509 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4511;
  assign select_4511 = equal_565_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4509 : box_nearer_columns_values_3_q);
  logic [2:0] select_4512;
  assign select_4512 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4514;
  assign select_4514 = equal_565_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4512 : box_nearer_columns_values_4_q);
  logic [4:0] select_4516;
  assign select_4516 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4561;
  assign select_4561 = and_4560_s3_q ? {and_2587, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4562;
  assign and_4562 = proven_q & less_4550;
  // hls/stages/agreement.hpp:438
  logic select_4565;
  assign select_4565 = and_2517_s3_q ? (less_2518_s3_q ? (select_4561[0] & and_4562) : seen_q) : seen_q;
  logic select_4568;
  assign select_4568 = and_2517_s3_q ? (less_2518_s3_q ? (select_4561[1] & and_4562) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4575;
  assign or_4575 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4574_s3_q;
  // hls/stages/agreement.hpp:1241
  logic not_4583;
  assign not_4583 = ~(or_4364 | not_2810);
  // hls/stages/agreement.hpp:788
  logic and_4587;
  assign and_4587 = equal_565_s3_q & (equal_4383_s3_q & (not_4583 & (select_4372 | select_4438)));
  logic and_4590;
  assign and_4590 = equal_4383_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4594;
  assign or_4594 = select_2908 | (select_2920 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4601;
  assign and_4601 = equal_565_s3_q & (equal_4383_s3_q & (not_4583 & (select_2914 | select_2926)));
  // hls/stages/agreement.hpp:1150
  logic and_4606;
  assign and_4606 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4401 < cfg_hidden_frames_i));
  logic select_4612;
  assign select_4612 = (not_2810 | (select_4444 & not_4276)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4617;
  assign and_4617 = equal_565_s3_q & (equal_4383_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4621;
  assign and_4621 = equal_565_s3_q & (x_s3_q[6] & (not_2451_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4629;
  assign select_4629 = equal_2094_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4627_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4630;
  assign select_4630 = equal_2092_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4629;
  logic [31:0] select_4631;
  assign select_4631 = equal_2090_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4630;
  logic [31:0] select_4632;
  assign select_4632 = equal_2088_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4631;
  logic [31:0] select_4633;
  assign select_4633 = equal_2086_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4632;
  logic [31:0] select_4634;
  assign select_4634 = equal_2084_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4633;
  logic [31:0] select_4635;
  assign select_4635 = equal_2082_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4634;
  logic [31:0] select_4636;
  assign select_4636 = equal_2080_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4635;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4637;
  assign select_4637 = less_3084 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4638;
  assign select_4638 = equal_2072_s3_q ? select_4636 : {2'h0, select_4637, select_3088, select_3085};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_540_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_737_s3_q, and_736, less_731_s3_q, and_730_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_724, and_700_s3_q, and_699_s3_q, and_674_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q};
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
  assign registration_sums_waddr = {sum_2078_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2137_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2136, sum_2132};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2163_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2240_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2212_s3_q};
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
  assign patches_right_0_waddr = {select_2271_s3_q, select_2268};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2280);
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
  assign patches_right_1_waddr = {select_2271_s3_q, select_2296};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2299);
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
  assign patches_left_waddr = {select_2318, select_2317_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2324);
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
  assign patches_rows_wdata = select_2439;
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
  assign regions_waddr = {region_row_s3_q, or_2449_s3_q, or_2446_s3_q, or_2443_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2483_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2482, sum_2472, sum_2467};
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
  assign map_waddr = {sum_2523_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2597_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2587, is_seen};
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
      census_left_misses_q <= select_2749;
      sharpness_before_last_mask_q <= select_2822;
      sharpness_sums_detail_0_q <= and_540_s3_q ? select_2836 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_540_s3_q ? select_2848 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_540_s3_q ? sum_2852 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_540_s3_q ? sum_2856 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2874 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2884 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2886 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2888 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2890 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2892 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2897;
      sharpness_comparing_carry_1_q <= select_2901;
      sharpness_comparing_less_detail_0_q <= select_2908;
      sharpness_comparing_less_detail_1_q <= select_2914;
      sharpness_comparing_less_contrast_0_q <= select_2920;
      sharpness_comparing_less_contrast_1_q <= select_2926;
      counts_supervised_q <= select_3042;
      counts_textured_q <= and_3034_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3045});
      counts_explained_q <= and_3034_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3050});
      counts_nearer_q <= and_3034_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3055});
      counts_unproven_q <= and_3034_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3081});
      counts_regions_bad_q <= select_3097;
      counts_skin_supervised_q <= select_3104;
      counts_skin_textured_q <= select_3111;
      counts_skin_unproven_q <= select_3119;
      counts_on_skin_q <= select_3138;
      registration_half_across_q <= select_3216;
      registration_half_measured_q <= select_3221;
      registration_half_votes_down_q <= and_3194_s3_q ? 7'h0 : sum_3227;
      registration_half_votes_up_q <= and_3194_s3_q ? 7'h0 : sum_3235;
      registration_half_half_votes_down_q <= and_3194_s3_q ? 7'h0 : sum_3242;
      registration_half_half_votes_up_q <= and_3194_s3_q ? 7'h0 : sum_3249;
      registration_down_q <= and_3283 ? sum_3302 : registration_down_q;
      registration_up_q <= and_3283 ? sum_3311 : registration_up_q;
      registration_enough_q <= select_3325;
      registration_votes_down_q <= and_3330 ? less_3331 : registration_votes_down_q;
      registration_votes_up_q <= and_3330 ? less_3333 : registration_votes_up_q;
      registration_other_enough_q <= and_3339 ? select_3325 : registration_other_enough_q;
      registration_other_down_q <= and_3339 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3339 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_565_s3_q & and_3346)) & or_3371;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2259 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2262 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2263 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3455;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2288 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2290 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2291 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3460;
      patches_valid_0_q <= select_3465;
      patches_valid_1_q <= select_3470;
      patches_right_next_0_q <= select_3473;
      patches_right_next_1_q <= select_3476;
      patches_left_next_0_q <= select_3479;
      patches_left_next_1_q <= select_3482;
      patches_sums_values_0_q <= select_3906;
      patches_sums_values_1_q <= equal_2241_s3_q ? patches_sums_values_1_q : select_3907;
      patches_sums_values_2_q <= equal_2241_s3_q ? patches_sums_values_2_q : select_3909;
      patches_sums_values_3_q <= equal_2241_s3_q ? patches_sums_values_3_q : select_3911;
      patches_sums_values_4_q <= equal_2241_s3_q ? patches_sums_values_4_q : select_3913;
      patches_sums_values_5_q <= equal_2241_s3_q ? patches_sums_values_5_q : select_3915;
      patches_sums_values_6_q <= equal_2241_s3_q ? patches_sums_values_6_q : select_3917;
      patches_sums_values_7_q <= equal_2241_s3_q ? patches_sums_values_7_q : select_3919;
      patches_sums_values_8_q <= equal_2241_s3_q ? patches_sums_values_8_q : select_3921;
      patches_sums_values_9_q <= equal_2241_s3_q ? patches_sums_values_9_q : select_3923;
      patches_sums_values_10_q <= equal_2241_s3_q ? patches_sums_values_10_q : select_3925;
      patches_sums_values_11_q <= equal_2241_s3_q ? patches_sums_values_11_q : select_3927;
      patches_sums_values_12_q <= equal_2241_s3_q ? patches_sums_values_12_q : select_3929;
      patches_sums_values_13_q <= equal_2241_s3_q ? patches_sums_values_13_q : select_3931;
      patches_sums_values_14_q <= equal_2241_s3_q ? patches_sums_values_14_q : select_3933;
      patches_sums_values_15_q <= equal_2241_s3_q ? patches_sums_values_15_q : select_3935;
      patches_sums_values_16_q <= equal_2241_s3_q ? patches_sums_values_16_q : select_3937;
      patches_best_differing_q <= select_2439[9:0];
      patches_best_column_q <= select_2439[14:10];
      patches_quarters_0_places_q <= sum_4061;
      patches_quarters_0_up_q <= sum_4101;
      patches_quarters_0_down_q <= sum_4111;
      patches_quarters_1_places_q <= sum_4115;
      patches_quarters_1_up_q <= sum_4118;
      patches_quarters_1_down_q <= sum_4121;
      patches_quarters_2_places_q <= sum_4125;
      patches_quarters_2_up_q <= sum_4128;
      patches_quarters_2_down_q <= sum_4131;
      patches_quarters_3_places_q <= sum_4135;
      patches_quarters_3_up_q <= sum_4138;
      patches_quarters_3_down_q <= sum_4141;
      patches_word_places_q <= or_4169;
      patches_word_up_q <= ((select_4179 | select_4181) | select_4184) | select_4187;
      patches_word_down_q <= ((select_4190 | select_4192) | select_4195) | select_4198;
      patches_sum_places_q <= select_4208;
      patches_sum_up_q <= select_4211;
      patches_sum_down_q <= select_4214;
      patches_across_q <= sum_4226;
      patches_places_q <= select_4237;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4241;
      patches_partly_q <= or_4244;
      patches_clear_limit_q <= sum_4245[8:2];
      patches_complete_q <= select_4247;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4230 ? select_4252 : patches_found_q;
      patches_doubted_q <= select_4259;
      patches_doubted_before_q <= select_4260;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4264;
      patches_on_skin_q <= sum_4274;
      patches_large_q <= not_4276 & and_4281;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4286;
      patches_spoiled_q <= or_4290;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4297;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4307;
      segment_textured_q <= select_2464 + {6'h0, and_3045};
      segment_explained_q <= select_2469 + {6'h0, and_3050};
      segment_nearer_q <= select_2479 + {6'h0, and_3055};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_565_s3_q ? select_4380 : good_q;
      good_known_q <= select_4385;
      hidden_for_q <= select_4403;
      product_q <= equal_565_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4428;
      disagree_q <= equal_565_s3_q ? select_4372 : disagree_q;
      too_much_q <= equal_565_s3_q ? select_4438 : too_much_q;
      hides_q <= equal_565_s3_q ? select_4398 : hides_q;
      overlooks_q <= equal_565_s3_q ? select_4444 : overlooks_q;
      seen_q <= select_4565;
      nearer_q <= select_4568;
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
      averager_quarter_1_0_q <= select_2623;
      averager_quarter_1_1_q <= select_2625;
      averager_quarter_2_0_q <= select_2627;
      averager_quarter_2_1_q <= select_2629;
      averager_detail_0_q <= select_2641;
      averager_detail_1_q <= select_2649;
      census_changes_values_0_left_q <= and_540_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_540_s3_q ? sum_2733 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2735;
      census_changes_values_1_right_q <= select_2736;
      census_changes_values_2_left_q <= select_2737;
      census_changes_values_2_right_q <= select_2738;
      sharpness_last_mask_q <= and_540_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_540_s3_q ? select_2819[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_540_s3_q ? select_2819[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4448;
      box_textured_columns_values_1_q <= select_4451;
      box_textured_columns_values_2_q <= select_4454;
      box_textured_columns_values_3_q <= select_4457;
      box_textured_columns_values_4_q <= select_4460;
      box_textured_sum_sums_values_0_q <= equal_565_s3_q ? box_textured_sum_sums_values_0_q : select_4462;
      box_explained_columns_values_0_q <= select_4466;
      box_explained_columns_values_1_q <= select_4469;
      box_explained_columns_values_2_q <= select_4472;
      box_explained_columns_values_3_q <= select_4475;
      box_explained_columns_values_4_q <= select_4478;
      box_explained_sum_sums_values_0_q <= equal_565_s3_q ? box_explained_sum_sums_values_0_q : select_4480;
      box_shown_columns_values_0_q <= equal_565_s3_q ? box_shown_columns_values_0_q : select_4483;
      box_shown_columns_values_1_q <= select_4487;
      box_shown_columns_values_2_q <= select_4490;
      box_shown_columns_values_3_q <= select_4493;
      box_shown_columns_values_4_q <= select_4496;
      box_shown_sum_sums_values_0_q <= equal_565_s3_q ? box_shown_sum_sums_values_0_q : select_4498;
      box_nearer_columns_values_0_q <= equal_565_s3_q ? box_nearer_columns_values_0_q : select_4501;
      box_nearer_columns_values_1_q <= select_4505;
      box_nearer_columns_values_2_q <= select_4508;
      box_nearer_columns_values_3_q <= select_4511;
      box_nearer_columns_values_4_q <= select_4514;
      box_nearer_sum_sums_values_0_q <= equal_565_s3_q ? box_nearer_sum_sums_values_0_q : select_4516;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4545_s4_q;
  logic or_4569_s4_q;
  logic and_4570_s4_q;
  logic and_4578_s4_q;
  logic and_4581_s4_q;
  logic and_4587_s4_q;
  logic and_4591_s4_q;
  logic and_4597_s4_q;
  logic and_4601_s4_q;
  logic and_4609_s4_q;
  logic and_4614_s4_q;
  logic and_4617_s4_q;
  logic and_4621_s4_q;
  logic [5:0] select_4623_s4_q;
  logic [31:0] select_4640_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4545_s4_q <= said_q;
      or_4569_s4_q <= not_2810 | select_4565;
      and_4570_s4_q <= cfg_prove_i & select_4568;
      and_4578_s4_q <= equal_565_s3_q & (equal_4383_s3_q & (cfg_prove_i & or_4575));
      and_4581_s4_q <= equal_565_s3_q & (equal_4383_s3_q & (cfg_prove_i & or_4364));
      and_4587_s4_q <= and_4587;
      and_4591_s4_q <= equal_565_s3_q & and_4590;
      and_4597_s4_q <= equal_565_s3_q & (equal_4383_s3_q & (not_4583 & or_4594));
      and_4601_s4_q <= and_4601;
      and_4609_s4_q <= equal_565_s3_q & (equal_4383_s3_q & (cfg_prove_i & and_4606));
      and_4614_s4_q <= equal_565_s3_q & (equal_4383_s3_q & select_4612);
      and_4617_s4_q <= and_4617;
      and_4621_s4_q <= and_4621;
      select_4623_s4_q <= equal_565_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4640_s4_q <= equal_565_s3_q ? (x_s3_q[6] ? select_4638 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4569_s4_q;
  assign marks_nearer_o = and_4570_s4_q;
  assign verdict_valid_o = and_4545_s4_q;
  assign verdict_unproven_yet_o = and_4578_s4_q;
  assign verdict_untextured_o = and_4581_s4_q;
  assign verdict_disagree_o = and_4587_s4_q;
  assign verdict_moved_o = and_4591_s4_q;
  assign verdict_unsharp_left_o = and_4597_s4_q;
  assign verdict_unsharp_right_o = and_4601_s4_q;
  assign verdict_hidden_o = and_4609_s4_q;
  assign verdict_overlooked_o = and_4614_s4_q;
  assign verdict_out_of_step_o = and_4617_s4_q;
  assign frame_valid_o = and_4621_s4_q;
  assign frame_index_o = select_4623_s4_q;
  assign frame_word_o = select_4640_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4279[4:0], sum_4245[1:0], sum_4200[1:0], product_4091[4:0], sum_3184[0], difference_3125[1:0], detail_4[1:0], detail_3[1:0], sum_2743[4:0], sum_2179[0], sum_2175[0], sum_722[4:0], cfg_width_i[2:0]};

endmodule
