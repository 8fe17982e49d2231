// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3064 bits, pipeline 861 bits, memories 127160 bits.
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
  logic not_2808;
  assign not_2808 = ~cfg_prove_i;
  logic [5:0] sum_3018;
  assign sum_3018 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4062;
  assign difference_4062 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4275;
  assign not_4275 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4333;
  assign difference_4333 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4549;
  assign less_4549 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4550;
  assign sum_4550 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

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
  logic [2:0] select_501;
  assign select_501 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_503;
  assign select_503 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [8:0] select_506;
  assign select_506 = ({select_503, select_501} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_507;
  assign select_507 = select_501[0] ? averager_place_q : select_506;
  // hls/stages/census.hpp:42
  logic or_508;
  assign or_508 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_511;
  assign and_511 = (select_501[0] & or_508) & (select_507[8:6] < 3'h5);
  // hls/stages/census.hpp:42
  logic [2:0] select_516;
  assign select_516 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_503 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_533;
  assign equal_533 = select_501 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_534;
  assign equal_534 = select_516 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_535;
  assign and_535 = equal_534 & and_511;
  // hls/stages/agreement.hpp:276
  logic and_537;
  assign and_537 = sample_pair_whole_q & (equal_533 & and_535);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_566;
  assign equal_566 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_567;
  assign or_567 = so | equal_566;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_568;
  assign sum_568 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_569;
  assign select_569 = run_shift_q[5] ? x_q : sum_568;
  logic less_570;
  assign less_570 = {1'b0, last_q} < select_569;
  // hls/stages/agreement.hpp:226
  logic not_571;
  assign not_571 = ~less_570;
  // hls/stages/agreement.hpp:614
  logic equal_581;
  assign equal_581 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_582;
  assign equal_582 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_583;
  assign and_583 = equal_582 & not_571;
  logic select_585;
  assign select_585 = or_567 ? not_571 : (equal_581 ? not_571 : and_583);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_603;
  assign and_603 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_569)));
  logic and_604;
  assign and_604 = equal_581 & and_603;
  logic select_605;
  assign select_605 = or_567 ? not_571 : and_604;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_568[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:594
  logic not_635;
  assign not_635 = ~or_567;
  // hls/stages/agreement.hpp:149
  logic and_638;
  assign and_638 = not_635 & ((~equal_581) & and_583);
  // hls/stages/census.hpp:42
  logic [5:0] select_665;
  assign select_665 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_665 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_2137;
  assign and_2137 = (select_501 == 3'h0) & (select_503 == 7'h0);
  // hls/stages/patches.hpp:392
  logic not_2138;
  assign not_2138 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2141;
  assign not_2141 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_2142;
  assign and_2142 = patches_capturing_q & not_2141;
  // hls/stages/patches.hpp:364
  logic equal_2143;
  assign equal_2143 = {or_508, select_516} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2145;
  assign equal_2145 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2150;
  assign and_2150 = (not_2138 & (patches_work_q == 3'h0)) & (~(and_2142 | ((~equal_2143) | (~equal_2145))));
  // hls/stages/patches.hpp:534
  logic equal_2241;
  assign equal_2241 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:512
  logic not_2242;
  assign not_2242 = ~equal_2241;
  // hls/stages/patches.hpp:505
  logic equal_2243;
  assign equal_2243 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:458
  logic not_2244;
  assign not_2244 = ~equal_2243;
  // hls/stages/patches.hpp:499
  logic equal_2245;
  assign equal_2245 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2246;
  assign equal_2246 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_2247;
  assign or_2247 = equal_2245 | equal_2246;
  // hls/stages/patches.hpp:460
  logic not_2248;
  assign not_2248 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_2270;
  assign select_2270 = and_2150 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2271;
  assign select_2271 = and_2137 ? select_2270 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2273;
  assign and_2273 = and_2142 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2277;
  assign select_2277 = and_2137 ? (and_2150 | (and_2142 & (~and_2273))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2285;
  assign and_2285 = not_2242 & (not_2244 & (or_2247 & (patches_second_q & equal_2246)));
  // hls/stages/patches.hpp:167
  logic not_2302;
  assign not_2302 = ~equal_2246;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2318;
  assign select_2318 = and_2137 ? {select_2270[4], select_2270[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:458
  logic and_2328;
  assign and_2328 = not_2242 & (or_2247 & not_2244);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2603;
  assign select_2603 = sample_pair_whole_q ? (sample_last_q ? (select_516 + 3'h1) : select_516) : raster_at_y_q;
  logic [6:0] select_2605;
  assign select_2605 = sample_pair_whole_q ? (select_503 + {6'h0, equal_533}) : raster_at_column_q;
  logic [5:0] select_2608;
  assign select_2608 = sample_pair_whole_q ? (sample_last_q ? (select_665 + {5'h0, equal_534}) : select_665) : raster_at_row_q;
  logic select_2612;
  assign select_2612 = sample_pair_whole_q ? (sample_last_q ? (or_508 & (~raster_final_row_q)) : or_508) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2614;
  assign select_2614 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2618;
  assign select_2618 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2926;
  assign sum_2926 = {1'b0, last} + 8'h1;
  logic equal_2927;
  assign equal_2927 = {sum_2926[7], cfg_width_i[9:3]} == {1'b0, sum_2926[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2928;
  assign and_2928 = and_537 & equal_2927;
  // hls/stages/agreement.hpp:523
  logic select_2931;
  assign select_2931 = (and_2928 | (~ends_cell_q)) ? and_2928 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2931 ? (and_2928 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2935;
  assign select_2935 = select_2931 ? (and_2928 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2938;
  assign select_2938 = select_2931 ? (following_last_shift_q & (~and_2928)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2941;
  assign and_2941 = run_last_shift_q & equal_581;
  // hls/stages/agreement.hpp:616
  logic select_2943;
  assign select_2943 = equal_581 ? (~run_last_shift_q) : equal_582;
  // hls/stages/agreement.hpp:620
  logic equal_2944;
  assign equal_2944 = run_phase_q == 3'h1;
  logic not_2947;
  assign not_2947 = ~select_2943;
  // hls/stages/agreement.hpp:623
  logic equal_2949;
  assign equal_2949 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2950;
  assign and_2950 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2951;
  assign select_2951 = equal_2949 ? 2'h1 : {2{and_2950}};
  logic [2:0] select_2953;
  assign select_2953 = (and_2941 | (select_2943 | equal_2944)) ? (equal_2944 ? 3'h2 : {not_2947, {2{select_2943}}}) : (equal_566 ? 3'h6 : {select_2951[0], select_2951});
  // hls/stages/agreement.hpp:607
  logic and_2956;
  assign and_2956 = select_2943 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2959;
  assign select_2959 = (plan_shift_q[5] & select_2943) ? value : 7'h0;
  logic [1:0] or_2960;
  assign or_2960 = {2{so}} | select_2959[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2964;
  assign or_2964 = (select_2943 ? plan_columns_q : 8'h0) | ((equal_2944 | equal_2949) ? whole_q : 8'h0);
  logic [1:0] or_2965;
  assign or_2965 = {2{and_2941}} | or_2964[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2967;
  assign or_2967 = {or_2964[7:4], or_2965, or_2964[1:0]} | (equal_566 ? drawn_q : 8'h0);
  logic [4:0] or_2968;
  assign or_2968 = {5{so}} | {or_2967[6], or_2967[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2972;
  assign not_2972 = ~run_shift_q[5];
  logic [7:0] select_2975;
  assign select_2975 = equal_581 ? ({{7{not_2972}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2979;
  assign select_2979 = and_2928 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2981;
  assign select_2981 = select_2931 ? {select_2979[6], select_2979} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2984;
  assign select_2984 = select_2931 ? (and_2928 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2992;
  assign select_2992 = and_537 ? (equal_2927 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [5:0] sum_2993;
  assign sum_2993 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2995;
  assign select_2995 = and_537 ? (equal_2927 ? {sum_2993, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2996;
  assign sum_2996 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2998;
  assign select_2998 = and_537 ? (equal_2927 ? {sum_2996, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_3009;
  assign select_3009 = (ends_cell_q | select_2931) ? (~(now == 3'h6)) : (equal_581 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_3013;
  assign and_3013 = (~select_2931) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_3014;
  assign sum_3014 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_3016;
  assign select_3016 = equal_2927 ? ({sum_3014[6], cfg_height_i[8:3]} == {1'b0, sum_3014[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3375;
  assign select_3375 = and_2137 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3376;
  assign select_3376 = sample_pair_whole_q ? select_3375 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_3377;
  assign and_3377 = not_2141 & equal_2143;
  logic [8:0] select_3378;
  assign select_3378 = and_3377 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3379;
  assign select_3379 = and_3377 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3380;
  assign select_3380 = sample_pair_first_q ? select_3378 : select_3379;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3382;
  assign select_3382 = sample_pair_whole_q ? (and_2137 ? select_3380[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3384;
  assign select_3384 = sample_pair_whole_q ? (and_2137 ? select_3380[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3387;
  assign select_3387 = sample_pair_whole_q ? (equal_2145 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3389;
  assign select_3389 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2145}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3390;
  assign equal_3390 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3391;
  assign not_3391 = ~equal_3390;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3393;
  assign select_3393 = sample_pair_whole_q ? (phase + {not_3391, 1'b1, not_3391, equal_3390}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3395;
  assign equal_3395 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3399;
  assign select_3399 = equal_3395 ? ((select_3376 == 4'h6) ? 4'h0 : (select_3376 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3400;
  assign equal_3400 = select_3399 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3403;
  assign select_3403 = equal_2927 ? (equal_3400 ? 4'h6 : (select_3399 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3405;
  assign select_3405 = equal_3395 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3407;
  assign select_3407 = equal_2927 ? (select_3405 + {4'h0, equal_3400}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3412;
  assign select_3412 = and_537 ? (equal_2927 ? ((6'h2 < row) & equal_3400) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3414;
  assign select_3414 = and_537 ? (equal_2927 ? select_3405 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_3438;
  assign or_3438 = select_503[0] | select_665[5];
  logic [7:0] sum_3439;
  assign sum_3439 = {1'b0, select_503[2:1], or_3438, select_665[4:1]} + 8'h1;
  logic less_3440;
  assign less_3440 = {sum_3439, select_665[0], select_516, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3443;
  assign select_3443 = and_2137 ? (and_2150 ? (~less_3440) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3482;
  assign or_3482 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3488;
  assign and_3488 = equal_2241 & not_2248;
  // hls/stages/patches.hpp:399
  logic and_3489;
  assign and_3489 = not_2302 & and_3488;
  logic [1:0] select_3491;
  assign select_3491 = equal_2243 ? 2'h0 : (equal_2245 ? 2'h3 : {equal_2246, and_3489});
  // hls/stages/patches.hpp:279
  logic equal_3493;
  assign equal_3493 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3494;
  assign not_3494 = ~equal_3493;
  // hls/stages/patches.hpp:279
  logic equal_3495;
  assign equal_3495 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3496;
  assign not_3496 = ~equal_3495;
  // hls/stages/patches.hpp:283
  logic not_3498;
  assign not_3498 = ~(patches_following_q == 3'h2);
  logic and_3501;
  assign and_3501 = (~(patches_following_q == 3'h1)) & not_3498;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3502;
  assign select_3502 = equal_3495 ? 2'h2 : {and_3501, not_3498};
  logic [3:0] select_3503;
  assign select_3503 = equal_3493 ? 4'h2 : {select_3502, {2{not_3496}}};
  // hls/stages/patches.hpp:405
  logic not_3506;
  assign not_3506 = ~or_3482;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3511;
  assign select_3511 = or_3482 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3513;
  assign select_3513 = or_3482 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
  assign fresh_re = s0_en & and_638;
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
  assign left_re = s0_en & select_585;
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
  assign right_codes_raddr = or_567 ? x_q[6:0] : (equal_581 ? sum_568[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_585;
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
  assign best_left_raddr = or_567 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_605;
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
  assign patches_left_re = s0_en & (not_2242 & (not_2244 & (not_2302 & or_2247)));
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
  assign patches_columns_above_re = s0_en & and_2328;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_501 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2603;
      raster_at_column_q <= select_2605;
      raster_at_row_q <= select_2608;
      raster_at_live_q <= select_2612;
      raster_rows_left_q <= sample_pair_whole_q ? select_2614 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2618;
      averager_place_q <= sample_pair_whole_q ? select_507 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2935;
      run_last_shift_q <= select_2938;
      run_span_q <= select_2931 ? (and_2928 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2953;
      following_shift_q <= select_2943 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2956;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2959[6], or_2960, select_2959[3:0]};
      following_columns_q <= {or_2967[7], or_2968[4], or_2967[5:4], or_2968[3:0]};
      plan_shift_q <= equal_581 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2975;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2981;
      columns_left_q <= select_2984;
      last_q <= and_537 ? (equal_2927 ? last : last_q) : last_q;
      least_q <= select_2992;
      whole_q <= select_2995;
      drawn_q <= select_2998;
      age_q <= select_2931 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2931 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3009;
      ends_q <= and_3013;
      final_row_q <= and_537 ? select_3016 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3376;
      patches_band_rows_rows_to_next_q <= select_3382;
      patches_band_rows_number_q <= select_3384;
      patches_next_band_rows_to_next_q <= select_3387;
      patches_next_band_number_q <= select_3389;
      patches_first_band_rows_to_next_q <= select_3393;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3390 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_537 ? select_3403 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_537 ? select_3407 : patches_choosing_number_q;
      patches_chooses_q <= select_3412;
      patches_choosing_band_q <= select_3414;
      patches_capturing_q <= sample_pair_whole_q ? select_2277 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3443 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2271 : patches_row_q;
      patches_work_q <= or_3482 ? following : patches_work_q;
      patches_second_q <= not_2138 & (patches_second_q | (patches_ends_q & equal_2241));
      patches_following_q <= equal_2241 ? {2'h0, and_3488} : {equal_2243, select_3491};
      patches_following_beats_q <= {select_3503, not_3494};
      patches_begins_q <= sample_pair_whole_q & (and_2137 & and_2273);
      patches_ends_q <= not_3506 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3511;
      patches_code_row_q <= select_3513;
      patches_column_q <= or_3482 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3506 & (patches_column_q == 5'h1e);
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
  logic [6:0] select_503_s1_q;
  logic [8:0] select_507_s1_q;
  logic and_511_s1_q;
  logic equal_517_s1_q;
  logic [6:0] last_s1_2_q;
  logic and_535_s1_q;
  logic and_537_s1_q;
  logic equal_562_s1_q;
  logic so_s1_q;
  logic equal_566_s1_q;
  logic or_567_s1_q;
  logic less_570_s1_q;
  logic not_571_s1_q;
  logic equal_581_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_605_s1_q;
  logic [6:0] right_s1_q;
  logic and_638_s1_q;
  logic [5:0] row_s1_q;
  logic and_2023_s1_q;
  logic equal_2024_s1_q;
  logic and_2137_s1_q;
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
  logic [3:0] select_2318_s1_q;
  logic and_2328_s1_q;
  logic equal_2927_s1_q;
  logic and_2928_s1_q;
  logic or_3482_s1_q;
  logic not_3506_s1_q;
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
      select_503_s1_q <= select_503;
      select_507_s1_q <= select_507;
      and_511_s1_q <= and_511;
      equal_517_s1_q <= select_516 == 3'h0;
      last_s1_2_q <= last;
      and_535_s1_q <= and_535;
      and_537_s1_q <= and_537;
      equal_562_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_566_s1_q <= equal_566;
      or_567_s1_q <= or_567;
      less_570_s1_q <= less_570;
      not_571_s1_q <= not_571;
      equal_581_s1_q <= equal_581;
      x_s1_2_q <= x[6:0];
      select_605_s1_q <= select_605;
      right_s1_q <= right;
      and_638_s1_q <= and_638;
      row_s1_q <= row;
      and_2023_s1_q <= not_635 & and_604;
      equal_2024_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2137_s1_q <= and_2137;
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
      select_2318_s1_q <= select_2318;
      and_2328_s1_q <= and_2328;
      equal_2927_s1_q <= equal_2927;
      and_2928_s1_q <= and_2928;
      or_3482_s1_q <= or_3482;
      not_3506_s1_q <= not_3506;
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
  // hls/stages/census.hpp:120
  logic and_512;
  assign and_512 = sample_pair_whole_s1_q & and_511_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_556;
  assign equal_556 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_557;
  assign equal_557 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_556 & equal_557;
  // hls/stages/moments.hpp:57
  logic [13:0] select_560;
  assign select_560 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [12:0] select_561;
  assign select_561 = first ? 13'h0 : select_560[12:0];
  // hls/stages/agreement.hpp:1009
  logic not_563;
  assign not_563 = ~equal_562_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_565;
  assign not_565 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_567_s1_q & not_571_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_560[13:6];
  // hls/stages/moments.hpp:104
  logic not_575;
  assign not_575 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:788
  logic and_579;
  assign and_579 = not_563 & (not_565 & (equal_566_s1_q & (inside_v & not_575)));
  // hls/stages/agreement.hpp:975
  logic and_595;
  assign and_595 = (or_567_s1_q & (left_rdata_q[67] & not_571_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [6:0] select_614;
  assign select_614 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:668
  logic not_735;
  assign not_735 = ~equal_556;
  // hls/stages/agreement.hpp:671
  logic and_736;
  assign and_736 = left_rdata_q[12] & not_735;
  logic and_737;
  assign and_737 = left_rdata_q[30] & not_735;
  logic and_738;
  assign and_738 = left_rdata_q[48] & not_735;
  logic and_739;
  assign and_739 = left_rdata_q[66] & not_735;
  // hls/stages/agreement.hpp:672
  logic and_740;
  assign and_740 = right_codes_rdata_q[12] & not_735;
  logic and_741;
  assign and_741 = right_codes_rdata_q[27] & not_735;
  logic and_742;
  assign and_742 = right_codes_rdata_q[42] & not_735;
  logic and_743;
  assign and_743 = right_codes_rdata_q[57] & not_735;
  logic and_744;
  assign and_744 = right_codes_rdata_q[72] & not_735;
  logic and_745;
  assign and_745 = right_codes_rdata_q[85] & not_735;
  // hls/stages/agreement.hpp:221
  logic and_750;
  assign and_750 = left_rdata_q[48] & not_571_s1_q;
  logic and_751;
  assign and_751 = right_codes_rdata_q[42] & not_571_s1_q;
  logic [11:0] select_752;
  assign select_752 = less_570_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_753;
  assign select_753 = less_570_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_757;
  assign select_757 = and_750 ? (and_751 ? (~(select_752 ^ select_753)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_763;
  assign parity_763 = ^select_757[5:3];
  logic parity_766;
  assign parity_766 = ^select_757[8:6];
  logic parity_769;
  assign parity_769 = ^select_757[11:3];
  // hls/stages/agreement.hpp:221
  logic and_773;
  assign and_773 = left_rdata_q[66] & not_571_s1_q;
  logic and_774;
  assign and_774 = right_codes_rdata_q[57] & not_571_s1_q;
  logic [11:0] select_775;
  assign select_775 = less_570_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_776;
  assign select_776 = less_570_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_780;
  assign select_780 = and_773 ? (and_774 ? (~(select_775 ^ select_776)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_783;
  assign parity_783 = ^select_780[8:6];
  logic parity_786;
  assign parity_786 = ^select_780[11:9];
  // hls/stages/agreement.hpp:221
  logic and_790;
  assign and_790 = left_rdata_q[84] & not_571_s1_q;
  logic and_791;
  assign and_791 = right_codes_rdata_q[72] & not_571_s1_q;
  logic [11:0] select_792;
  assign select_792 = less_570_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_793;
  assign select_793 = less_570_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_797;
  assign select_797 = and_790 ? (and_791 ? (~(select_792 ^ select_793)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_803;
  assign parity_803 = ^select_797[2:0];
  logic parity_806;
  assign parity_806 = ^select_797[5:3];
  logic parity_809;
  assign parity_809 = ^select_797[8:0];
  logic parity_815;
  assign parity_815 = ^select_797[11:9];
  logic parity_818;
  assign parity_818 = ^select_780[2:0];
  logic parity_821;
  assign parity_821 = ^{select_797[11:9], select_780[5:0]};
  logic parity_824;
  assign parity_824 = ^{select_797, select_780, select_757[2:0]};
  logic xor_825;
  assign xor_825 = parity_769 ^ parity_824;
  // hls/stages/count_bits.hpp:23
  logic or_829;
  assign or_829 = (select_757[1:0] == 2'h3) | (select_757[2] & (select_757[0] | select_757[1]));
  // hls/stages/count_bits.hpp:25
  logic or_833;
  assign or_833 = (select_780[7:6] == 2'h3) | (select_780[8] & (select_780[6] | select_780[7]));
  logic or_837;
  assign or_837 = (select_780[10:9] == 2'h3) | (select_780[11] & (select_780[9] | select_780[10]));
  // hls/stages/count_bits.hpp:23
  logic or_845;
  assign or_845 = (select_797[7:6] == 2'h3) | (select_797[8] & (~(select_797[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_849;
  assign or_849 = (select_797[1:0] == 2'h3) | (select_797[2] & (select_797[0] | select_797[1]));
  logic or_853;
  assign or_853 = (select_797[4:3] == 2'h3) | (select_797[5] & (select_797[3] | select_797[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_856;
  assign parity_856 = ^{or_853, or_849, or_845};
  // hls/stages/count_bits.hpp:23
  logic or_860;
  assign or_860 = (select_780[4:3] == 2'h3) | (select_780[5] & (select_780[3] | select_780[4]));
  // hls/stages/count_bits.hpp:25
  logic or_864;
  assign or_864 = (select_797[10:9] == 2'h3) | (select_797[11] & (select_797[9] | select_797[10]));
  logic or_868;
  assign or_868 = (select_780[1:0] == 2'h3) | (select_780[2] & (select_780[0] | select_780[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_871;
  assign parity_871 = ^{or_868, or_864, or_860};
  logic parity_874;
  assign parity_874 = ^{or_868, or_864, or_860, or_853, or_849, or_845, or_837, or_833, or_829};
  // hls/stages/count_bits.hpp:25
  logic and_875;
  assign and_875 = parity_769 & parity_824;
  logic or_879;
  assign or_879 = (parity_763 & parity_766) | ((^select_757[11:9]) & (parity_763 | parity_766));
  logic and_882;
  assign and_882 = (^{select_780[11:6], select_757[2:0]}) & (parity_809 | parity_821);
  logic or_883;
  assign or_883 = (parity_809 & parity_821) | and_882;
  // hls/stages/count_bits.hpp:23
  logic or_890;
  assign or_890 = (select_757[10:9] == 2'h3) | (select_757[11] & (select_757[9] | select_757[10]));
  // hls/stages/count_bits.hpp:25
  logic or_894;
  assign or_894 = (select_757[4:3] == 2'h3) | (select_757[5] & (select_757[3] | select_757[4]));
  logic or_898;
  assign or_898 = (select_757[7:6] == 2'h3) | (select_757[8] & (select_757[6] | select_757[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_901;
  assign parity_901 = ^{or_898, or_894, or_890};
  // hls/stages/count_bits.hpp:25
  logic or_905;
  assign or_905 = (parity_783 & parity_786) | ((^select_757[2:0]) & (parity_783 | parity_786));
  logic or_909;
  assign or_909 = (parity_803 & parity_806) | ((^select_797[8:6]) & (parity_803 | parity_806));
  logic or_913;
  assign or_913 = (parity_815 & parity_818) | ((^select_780[5:3]) & (parity_815 | parity_818));
  // hls/stages/count_bits.hpp:24
  logic parity_916;
  assign parity_916 = ^{or_913, or_909, or_905};
  logic parity_919;
  assign parity_919 = ^{or_913, or_909, or_905, or_898, or_894, or_890, or_883, or_879, and_875};
  logic xor_920;
  assign xor_920 = parity_874 ^ parity_919;
  // hls/stages/count_bits.hpp:25
  logic and_921;
  assign and_921 = parity_874 & parity_919;
  logic or_925;
  assign or_925 = (parity_856 & parity_871) | ((^{or_837, or_833, or_829}) & (parity_856 | parity_871));
  logic or_929;
  assign or_929 = (parity_901 & parity_916) | ((^{or_883, or_879, and_875}) & (parity_901 | parity_916));
  logic or_936;
  assign or_936 = (or_833 & or_837) | (or_829 & (or_833 | or_837));
  logic or_940;
  assign or_940 = (or_849 & or_853) | (or_845 & (or_849 | or_853));
  logic or_944;
  assign or_944 = (or_864 & or_868) | (or_860 & (or_864 | or_868));
  // hls/stages/count_bits.hpp:24
  logic parity_947;
  assign parity_947 = ^{or_944, or_940, or_936};
  // hls/stages/count_bits.hpp:25
  logic or_951;
  assign or_951 = (or_879 & or_883) | (and_875 & (or_879 | or_883));
  logic or_955;
  assign or_955 = (or_894 & or_898) | (or_890 & (or_894 | or_898));
  logic or_959;
  assign or_959 = (or_909 & or_913) | (or_905 & (or_909 | or_913));
  // hls/stages/count_bits.hpp:24
  logic parity_962;
  assign parity_962 = ^{or_959, or_955, or_951};
  logic parity_965;
  assign parity_965 = ^{or_959, or_955, or_951, or_944, or_940, or_936, or_929, or_925, and_921};
  // hls/stages/count_bits.hpp:25
  logic or_969;
  assign or_969 = (parity_947 & parity_962) | ((^{or_929, or_925, and_921}) & (parity_947 | parity_962));
  logic or_973;
  assign or_973 = (or_925 & or_929) | (and_921 & (or_925 | or_929));
  logic or_977;
  assign or_977 = (or_940 & or_944) | (or_936 & (or_940 | or_944));
  logic or_981;
  assign or_981 = (or_955 & or_959) | (or_951 & (or_955 | or_959));
  // hls/stages/count_bits.hpp:24
  logic parity_986;
  assign parity_986 = ^{or_981, or_977, or_973, or_969};
  // hls/stages/count_bits.hpp:25
  logic or_990;
  assign or_990 = (or_977 & or_981) | (or_973 & (or_977 | or_981));
  logic and_991;
  assign and_991 = or_969 & (^{or_981, or_977, or_973});
  // hls/stages/count_bits.hpp:24
  logic xor_992;
  assign xor_992 = or_990 ^ and_991;
  // hls/stages/count_bits.hpp:27
  logic and_993;
  assign and_993 = or_990 & and_991;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_994;
  assign select_994 = equal_581_s1_q ? {and_993, xor_992, parity_986, parity_965, xor_920, xor_825} : 6'h0;
  logic [5:0] column;
  assign column = or_567_s1_q ? 6'h0 : select_994;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_996;
  assign select_996 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_997;
  assign difference_997 = {1'b0, column} - {1'b0, select_996};
  logic [7:0] sum_999;
  assign sum_999 = {difference_997[6], difference_997} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1003;
  assign select_1003 = and_750 ? (and_774 ? (~(select_752 ^ select_776)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1009;
  assign parity_1009 = ^select_1003[5:3];
  logic parity_1012;
  assign parity_1012 = ^select_1003[8:6];
  logic parity_1015;
  assign parity_1015 = ^select_1003[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1022;
  assign select_1022 = and_773 ? (and_791 ? (~(select_775 ^ select_793)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^select_1022[8:6];
  logic parity_1028;
  assign parity_1028 = ^select_1022[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1032;
  assign and_1032 = right_codes_rdata_q[85] & not_571_s1_q;
  logic [11:0] select_1033;
  assign select_1033 = less_570_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1037;
  assign select_1037 = and_790 ? (and_1032 ? (~(select_792 ^ select_1033)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1043;
  assign parity_1043 = ^select_1037[2:0];
  logic parity_1046;
  assign parity_1046 = ^select_1037[5:3];
  logic parity_1049;
  assign parity_1049 = ^select_1037[8:0];
  logic parity_1055;
  assign parity_1055 = ^select_1037[11:9];
  logic parity_1058;
  assign parity_1058 = ^select_1022[2:0];
  logic parity_1061;
  assign parity_1061 = ^{select_1037[11:9], select_1022[5:0]};
  logic parity_1064;
  assign parity_1064 = ^{select_1037, select_1022, select_1003[2:0]};
  logic xor_1065;
  assign xor_1065 = parity_1015 ^ parity_1064;
  // hls/stages/count_bits.hpp:23
  logic or_1069;
  assign or_1069 = (select_1003[1:0] == 2'h3) | (select_1003[2] & (select_1003[0] | select_1003[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1073;
  assign or_1073 = (select_1022[7:6] == 2'h3) | (select_1022[8] & (select_1022[6] | select_1022[7]));
  logic or_1077;
  assign or_1077 = (select_1022[10:9] == 2'h3) | (select_1022[11] & (select_1022[9] | select_1022[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1085;
  assign or_1085 = (select_1037[7:6] == 2'h3) | (select_1037[8] & (~(select_1037[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1089;
  assign or_1089 = (select_1037[1:0] == 2'h3) | (select_1037[2] & (select_1037[0] | select_1037[1]));
  logic or_1093;
  assign or_1093 = (select_1037[4:3] == 2'h3) | (select_1037[5] & (select_1037[3] | select_1037[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1096;
  assign parity_1096 = ^{or_1093, or_1089, or_1085};
  // hls/stages/count_bits.hpp:23
  logic or_1100;
  assign or_1100 = (select_1022[4:3] == 2'h3) | (select_1022[5] & (select_1022[3] | select_1022[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1104;
  assign or_1104 = (select_1037[10:9] == 2'h3) | (select_1037[11] & (select_1037[9] | select_1037[10]));
  logic or_1108;
  assign or_1108 = (select_1022[1:0] == 2'h3) | (select_1022[2] & (select_1022[0] | select_1022[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1111;
  assign parity_1111 = ^{or_1108, or_1104, or_1100};
  logic parity_1114;
  assign parity_1114 = ^{or_1108, or_1104, or_1100, or_1093, or_1089, or_1085, or_1077, or_1073, or_1069};
  // hls/stages/count_bits.hpp:25
  logic and_1115;
  assign and_1115 = parity_1015 & parity_1064;
  logic or_1119;
  assign or_1119 = (parity_1009 & parity_1012) | ((^select_1003[11:9]) & (parity_1009 | parity_1012));
  logic and_1122;
  assign and_1122 = (^{select_1022[11:6], select_1003[2:0]}) & (parity_1049 | parity_1061);
  logic or_1123;
  assign or_1123 = (parity_1049 & parity_1061) | and_1122;
  // hls/stages/count_bits.hpp:23
  logic or_1130;
  assign or_1130 = (select_1003[10:9] == 2'h3) | (select_1003[11] & (select_1003[9] | select_1003[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1134;
  assign or_1134 = (select_1003[4:3] == 2'h3) | (select_1003[5] & (select_1003[3] | select_1003[4]));
  logic or_1138;
  assign or_1138 = (select_1003[7:6] == 2'h3) | (select_1003[8] & (select_1003[6] | select_1003[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1141;
  assign parity_1141 = ^{or_1138, or_1134, or_1130};
  // hls/stages/count_bits.hpp:25
  logic or_1145;
  assign or_1145 = (parity_1025 & parity_1028) | ((^select_1003[2:0]) & (parity_1025 | parity_1028));
  logic or_1149;
  assign or_1149 = (parity_1043 & parity_1046) | ((^select_1037[8:6]) & (parity_1043 | parity_1046));
  logic or_1153;
  assign or_1153 = (parity_1055 & parity_1058) | ((^select_1022[5:3]) & (parity_1055 | parity_1058));
  // hls/stages/count_bits.hpp:24
  logic parity_1156;
  assign parity_1156 = ^{or_1153, or_1149, or_1145};
  logic parity_1159;
  assign parity_1159 = ^{or_1153, or_1149, or_1145, or_1138, or_1134, or_1130, or_1123, or_1119, and_1115};
  logic xor_1160;
  assign xor_1160 = parity_1114 ^ parity_1159;
  // hls/stages/count_bits.hpp:25
  logic and_1161;
  assign and_1161 = parity_1114 & parity_1159;
  logic or_1165;
  assign or_1165 = (parity_1096 & parity_1111) | ((^{or_1077, or_1073, or_1069}) & (parity_1096 | parity_1111));
  logic or_1169;
  assign or_1169 = (parity_1141 & parity_1156) | ((^{or_1123, or_1119, and_1115}) & (parity_1141 | parity_1156));
  logic or_1176;
  assign or_1176 = (or_1073 & or_1077) | (or_1069 & (or_1073 | or_1077));
  logic or_1180;
  assign or_1180 = (or_1089 & or_1093) | (or_1085 & (or_1089 | or_1093));
  logic or_1184;
  assign or_1184 = (or_1104 & or_1108) | (or_1100 & (or_1104 | or_1108));
  // hls/stages/count_bits.hpp:24
  logic parity_1187;
  assign parity_1187 = ^{or_1184, or_1180, or_1176};
  // hls/stages/count_bits.hpp:25
  logic or_1191;
  assign or_1191 = (or_1119 & or_1123) | (and_1115 & (or_1119 | or_1123));
  logic or_1195;
  assign or_1195 = (or_1134 & or_1138) | (or_1130 & (or_1134 | or_1138));
  logic or_1199;
  assign or_1199 = (or_1149 & or_1153) | (or_1145 & (or_1149 | or_1153));
  // hls/stages/count_bits.hpp:24
  logic parity_1202;
  assign parity_1202 = ^{or_1199, or_1195, or_1191};
  logic parity_1205;
  assign parity_1205 = ^{or_1199, or_1195, or_1191, or_1184, or_1180, or_1176, or_1169, or_1165, and_1161};
  // hls/stages/count_bits.hpp:25
  logic or_1209;
  assign or_1209 = (parity_1187 & parity_1202) | ((^{or_1169, or_1165, and_1161}) & (parity_1187 | parity_1202));
  logic or_1213;
  assign or_1213 = (or_1165 & or_1169) | (and_1161 & (or_1165 | or_1169));
  logic or_1217;
  assign or_1217 = (or_1180 & or_1184) | (or_1176 & (or_1180 | or_1184));
  logic or_1221;
  assign or_1221 = (or_1195 & or_1199) | (or_1191 & (or_1195 | or_1199));
  // hls/stages/count_bits.hpp:24
  logic parity_1226;
  assign parity_1226 = ^{or_1221, or_1217, or_1213, or_1209};
  // hls/stages/count_bits.hpp:25
  logic or_1230;
  assign or_1230 = (or_1217 & or_1221) | (or_1213 & (or_1217 | or_1221));
  logic and_1231;
  assign and_1231 = or_1209 & (^{or_1221, or_1217, or_1213});
  // hls/stages/count_bits.hpp:24
  logic xor_1232;
  assign xor_1232 = or_1230 ^ and_1231;
  // hls/stages/count_bits.hpp:27
  logic and_1233;
  assign and_1233 = or_1230 & and_1231;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1234;
  assign select_1234 = equal_581_s1_q ? {and_1233, xor_1232, parity_1226, parity_1205, xor_1160, xor_1065} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_567_s1_q ? 6'h0 : select_1234;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1236;
  assign select_1236 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1237;
  assign difference_1237 = {1'b0, column_2} - {1'b0, select_1236};
  logic [7:0] sum_1239;
  assign sum_1239 = {difference_1237[6], difference_1237} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1240;
  assign and_1240 = right_codes_rdata_q[27] & not_571_s1_q;
  logic [11:0] select_1241;
  assign select_1241 = less_570_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1245;
  assign select_1245 = and_750 ? (and_1240 ? (~(select_752 ^ select_1241)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1251;
  assign parity_1251 = ^select_1245[5:3];
  logic parity_1254;
  assign parity_1254 = ^select_1245[8:6];
  logic parity_1257;
  assign parity_1257 = ^select_1245[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1264;
  assign select_1264 = and_773 ? (and_751 ? (~(select_775 ^ select_753)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1267;
  assign parity_1267 = ^select_1264[8:6];
  logic parity_1270;
  assign parity_1270 = ^select_1264[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1277;
  assign select_1277 = and_790 ? (and_774 ? (~(select_792 ^ select_776)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1283;
  assign parity_1283 = ^select_1277[2:0];
  logic parity_1286;
  assign parity_1286 = ^select_1277[5:3];
  logic parity_1289;
  assign parity_1289 = ^select_1277[8:0];
  logic parity_1295;
  assign parity_1295 = ^select_1277[11:9];
  logic parity_1298;
  assign parity_1298 = ^select_1264[2:0];
  logic parity_1301;
  assign parity_1301 = ^{select_1277[11:9], select_1264[5:0]};
  logic parity_1304;
  assign parity_1304 = ^{select_1277, select_1264, select_1245[2:0]};
  logic xor_1305;
  assign xor_1305 = parity_1257 ^ parity_1304;
  // hls/stages/count_bits.hpp:23
  logic or_1309;
  assign or_1309 = (select_1245[1:0] == 2'h3) | (select_1245[2] & (select_1245[0] | select_1245[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1313;
  assign or_1313 = (select_1264[7:6] == 2'h3) | (select_1264[8] & (select_1264[6] | select_1264[7]));
  logic or_1317;
  assign or_1317 = (select_1264[10:9] == 2'h3) | (select_1264[11] & (select_1264[9] | select_1264[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1325;
  assign or_1325 = (select_1277[7:6] == 2'h3) | (select_1277[8] & (~(select_1277[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1329;
  assign or_1329 = (select_1277[1:0] == 2'h3) | (select_1277[2] & (select_1277[0] | select_1277[1]));
  logic or_1333;
  assign or_1333 = (select_1277[4:3] == 2'h3) | (select_1277[5] & (select_1277[3] | select_1277[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1336;
  assign parity_1336 = ^{or_1333, or_1329, or_1325};
  // hls/stages/count_bits.hpp:23
  logic or_1340;
  assign or_1340 = (select_1264[4:3] == 2'h3) | (select_1264[5] & (select_1264[3] | select_1264[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1344;
  assign or_1344 = (select_1277[10:9] == 2'h3) | (select_1277[11] & (select_1277[9] | select_1277[10]));
  logic or_1348;
  assign or_1348 = (select_1264[1:0] == 2'h3) | (select_1264[2] & (select_1264[0] | select_1264[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1351;
  assign parity_1351 = ^{or_1348, or_1344, or_1340};
  logic parity_1354;
  assign parity_1354 = ^{or_1348, or_1344, or_1340, or_1333, or_1329, or_1325, or_1317, or_1313, or_1309};
  // hls/stages/count_bits.hpp:25
  logic and_1355;
  assign and_1355 = parity_1257 & parity_1304;
  logic or_1359;
  assign or_1359 = (parity_1251 & parity_1254) | ((^select_1245[11:9]) & (parity_1251 | parity_1254));
  logic and_1362;
  assign and_1362 = (^{select_1264[11:6], select_1245[2:0]}) & (parity_1289 | parity_1301);
  logic or_1363;
  assign or_1363 = (parity_1289 & parity_1301) | and_1362;
  // hls/stages/count_bits.hpp:23
  logic or_1370;
  assign or_1370 = (select_1245[10:9] == 2'h3) | (select_1245[11] & (select_1245[9] | select_1245[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1374;
  assign or_1374 = (select_1245[4:3] == 2'h3) | (select_1245[5] & (select_1245[3] | select_1245[4]));
  logic or_1378;
  assign or_1378 = (select_1245[7:6] == 2'h3) | (select_1245[8] & (select_1245[6] | select_1245[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1381;
  assign parity_1381 = ^{or_1378, or_1374, or_1370};
  // hls/stages/count_bits.hpp:25
  logic or_1385;
  assign or_1385 = (parity_1267 & parity_1270) | ((^select_1245[2:0]) & (parity_1267 | parity_1270));
  logic or_1389;
  assign or_1389 = (parity_1283 & parity_1286) | ((^select_1277[8:6]) & (parity_1283 | parity_1286));
  logic or_1393;
  assign or_1393 = (parity_1295 & parity_1298) | ((^select_1264[5:3]) & (parity_1295 | parity_1298));
  // hls/stages/count_bits.hpp:24
  logic parity_1396;
  assign parity_1396 = ^{or_1393, or_1389, or_1385};
  logic parity_1399;
  assign parity_1399 = ^{or_1393, or_1389, or_1385, or_1378, or_1374, or_1370, or_1363, or_1359, and_1355};
  logic xor_1400;
  assign xor_1400 = parity_1354 ^ parity_1399;
  // hls/stages/count_bits.hpp:25
  logic and_1401;
  assign and_1401 = parity_1354 & parity_1399;
  logic or_1405;
  assign or_1405 = (parity_1336 & parity_1351) | ((^{or_1317, or_1313, or_1309}) & (parity_1336 | parity_1351));
  logic or_1409;
  assign or_1409 = (parity_1381 & parity_1396) | ((^{or_1363, or_1359, and_1355}) & (parity_1381 | parity_1396));
  logic or_1416;
  assign or_1416 = (or_1313 & or_1317) | (or_1309 & (or_1313 | or_1317));
  logic or_1420;
  assign or_1420 = (or_1329 & or_1333) | (or_1325 & (or_1329 | or_1333));
  logic or_1424;
  assign or_1424 = (or_1344 & or_1348) | (or_1340 & (or_1344 | or_1348));
  // hls/stages/count_bits.hpp:24
  logic parity_1427;
  assign parity_1427 = ^{or_1424, or_1420, or_1416};
  // hls/stages/count_bits.hpp:25
  logic or_1431;
  assign or_1431 = (or_1359 & or_1363) | (and_1355 & (or_1359 | or_1363));
  logic or_1435;
  assign or_1435 = (or_1374 & or_1378) | (or_1370 & (or_1374 | or_1378));
  logic or_1439;
  assign or_1439 = (or_1389 & or_1393) | (or_1385 & (or_1389 | or_1393));
  // hls/stages/count_bits.hpp:24
  logic parity_1442;
  assign parity_1442 = ^{or_1439, or_1435, or_1431};
  logic parity_1445;
  assign parity_1445 = ^{or_1439, or_1435, or_1431, or_1424, or_1420, or_1416, or_1409, or_1405, and_1401};
  // hls/stages/count_bits.hpp:25
  logic or_1449;
  assign or_1449 = (parity_1427 & parity_1442) | ((^{or_1409, or_1405, and_1401}) & (parity_1427 | parity_1442));
  logic or_1453;
  assign or_1453 = (or_1405 & or_1409) | (and_1401 & (or_1405 | or_1409));
  logic or_1457;
  assign or_1457 = (or_1420 & or_1424) | (or_1416 & (or_1420 | or_1424));
  logic or_1461;
  assign or_1461 = (or_1435 & or_1439) | (or_1431 & (or_1435 | or_1439));
  // hls/stages/count_bits.hpp:24
  logic parity_1466;
  assign parity_1466 = ^{or_1461, or_1457, or_1453, or_1449};
  // hls/stages/count_bits.hpp:25
  logic or_1470;
  assign or_1470 = (or_1457 & or_1461) | (or_1453 & (or_1457 | or_1461));
  logic and_1471;
  assign and_1471 = or_1449 & (^{or_1461, or_1457, or_1453});
  // hls/stages/count_bits.hpp:24
  logic xor_1472;
  assign xor_1472 = or_1470 ^ and_1471;
  // hls/stages/count_bits.hpp:27
  logic and_1473;
  assign and_1473 = or_1470 & and_1471;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1474;
  assign select_1474 = equal_581_s1_q ? {and_1473, xor_1472, parity_1466, parity_1445, xor_1400, xor_1305} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_567_s1_q ? 6'h0 : select_1474;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1476;
  assign select_1476 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1477;
  assign difference_1477 = {1'b0, column_3} - {1'b0, select_1476};
  logic [7:0] sum_1479;
  assign sum_1479 = {difference_1477[6], difference_1477} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1487;
  assign select_1487 = and_750 ? (and_791 ? (~(select_752 ^ select_793)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1493;
  assign parity_1493 = ^select_1487[5:3];
  logic parity_1496;
  assign parity_1496 = ^select_1487[8:6];
  logic parity_1499;
  assign parity_1499 = ^select_1487[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1506;
  assign select_1506 = and_773 ? (and_1032 ? (~(select_775 ^ select_1033)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1509;
  assign parity_1509 = ^select_1506[8:6];
  logic parity_1512;
  assign parity_1512 = ^select_1506[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] xor_1518;
  assign xor_1518 = select_792 ^ (less_570_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1521;
  assign select_1521 = and_790 ? ((right_codes_rdata_q[98] & not_571_s1_q) ? (~xor_1518) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1527;
  assign parity_1527 = ^select_1521[2:0];
  logic parity_1530;
  assign parity_1530 = ^select_1521[5:3];
  logic parity_1533;
  assign parity_1533 = ^select_1521[8:0];
  logic parity_1539;
  assign parity_1539 = ^select_1521[11:9];
  logic parity_1542;
  assign parity_1542 = ^select_1506[2:0];
  logic parity_1545;
  assign parity_1545 = ^{select_1521[11:9], select_1506[5:0]};
  logic parity_1548;
  assign parity_1548 = ^{select_1521, select_1506, select_1487[2:0]};
  logic xor_1549;
  assign xor_1549 = parity_1499 ^ parity_1548;
  // hls/stages/count_bits.hpp:23
  logic or_1553;
  assign or_1553 = (select_1487[1:0] == 2'h3) | (select_1487[2] & (select_1487[0] | select_1487[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1557;
  assign or_1557 = (select_1506[7:6] == 2'h3) | (select_1506[8] & (select_1506[6] | select_1506[7]));
  logic or_1561;
  assign or_1561 = (select_1506[10:9] == 2'h3) | (select_1506[11] & (select_1506[9] | select_1506[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1569;
  assign or_1569 = (select_1521[7:6] == 2'h3) | (select_1521[8] & (~(select_1521[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1573;
  assign or_1573 = (select_1521[1:0] == 2'h3) | (select_1521[2] & (select_1521[0] | select_1521[1]));
  logic or_1577;
  assign or_1577 = (select_1521[4:3] == 2'h3) | (select_1521[5] & (select_1521[3] | select_1521[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1580;
  assign parity_1580 = ^{or_1577, or_1573, or_1569};
  // hls/stages/count_bits.hpp:23
  logic or_1584;
  assign or_1584 = (select_1506[4:3] == 2'h3) | (select_1506[5] & (select_1506[3] | select_1506[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1588;
  assign or_1588 = (select_1521[10:9] == 2'h3) | (select_1521[11] & (select_1521[9] | select_1521[10]));
  logic or_1592;
  assign or_1592 = (select_1506[1:0] == 2'h3) | (select_1506[2] & (select_1506[0] | select_1506[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1595;
  assign parity_1595 = ^{or_1592, or_1588, or_1584};
  logic parity_1598;
  assign parity_1598 = ^{or_1592, or_1588, or_1584, or_1577, or_1573, or_1569, or_1561, or_1557, or_1553};
  // hls/stages/count_bits.hpp:25
  logic and_1599;
  assign and_1599 = parity_1499 & parity_1548;
  logic or_1603;
  assign or_1603 = (parity_1493 & parity_1496) | ((^select_1487[11:9]) & (parity_1493 | parity_1496));
  logic and_1606;
  assign and_1606 = (^{select_1506[11:6], select_1487[2:0]}) & (parity_1533 | parity_1545);
  logic or_1607;
  assign or_1607 = (parity_1533 & parity_1545) | and_1606;
  // hls/stages/count_bits.hpp:23
  logic or_1614;
  assign or_1614 = (select_1487[10:9] == 2'h3) | (select_1487[11] & (select_1487[9] | select_1487[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1618;
  assign or_1618 = (select_1487[4:3] == 2'h3) | (select_1487[5] & (select_1487[3] | select_1487[4]));
  logic or_1622;
  assign or_1622 = (select_1487[7:6] == 2'h3) | (select_1487[8] & (select_1487[6] | select_1487[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1625;
  assign parity_1625 = ^{or_1622, or_1618, or_1614};
  // hls/stages/count_bits.hpp:25
  logic or_1629;
  assign or_1629 = (parity_1509 & parity_1512) | ((^select_1487[2:0]) & (parity_1509 | parity_1512));
  logic or_1633;
  assign or_1633 = (parity_1527 & parity_1530) | ((^select_1521[8:6]) & (parity_1527 | parity_1530));
  logic or_1637;
  assign or_1637 = (parity_1539 & parity_1542) | ((^select_1506[5:3]) & (parity_1539 | parity_1542));
  // hls/stages/count_bits.hpp:24
  logic parity_1640;
  assign parity_1640 = ^{or_1637, or_1633, or_1629};
  logic parity_1643;
  assign parity_1643 = ^{or_1637, or_1633, or_1629, or_1622, or_1618, or_1614, or_1607, or_1603, and_1599};
  logic xor_1644;
  assign xor_1644 = parity_1598 ^ parity_1643;
  // hls/stages/count_bits.hpp:25
  logic and_1645;
  assign and_1645 = parity_1598 & parity_1643;
  logic or_1649;
  assign or_1649 = (parity_1580 & parity_1595) | ((^{or_1561, or_1557, or_1553}) & (parity_1580 | parity_1595));
  logic or_1653;
  assign or_1653 = (parity_1625 & parity_1640) | ((^{or_1607, or_1603, and_1599}) & (parity_1625 | parity_1640));
  logic or_1660;
  assign or_1660 = (or_1557 & or_1561) | (or_1553 & (or_1557 | or_1561));
  logic or_1664;
  assign or_1664 = (or_1573 & or_1577) | (or_1569 & (or_1573 | or_1577));
  logic or_1668;
  assign or_1668 = (or_1588 & or_1592) | (or_1584 & (or_1588 | or_1592));
  // hls/stages/count_bits.hpp:24
  logic parity_1671;
  assign parity_1671 = ^{or_1668, or_1664, or_1660};
  // hls/stages/count_bits.hpp:25
  logic or_1675;
  assign or_1675 = (or_1603 & or_1607) | (and_1599 & (or_1603 | or_1607));
  logic or_1679;
  assign or_1679 = (or_1618 & or_1622) | (or_1614 & (or_1618 | or_1622));
  logic or_1683;
  assign or_1683 = (or_1633 & or_1637) | (or_1629 & (or_1633 | or_1637));
  // hls/stages/count_bits.hpp:24
  logic parity_1686;
  assign parity_1686 = ^{or_1683, or_1679, or_1675};
  logic parity_1689;
  assign parity_1689 = ^{or_1683, or_1679, or_1675, or_1668, or_1664, or_1660, or_1653, or_1649, and_1645};
  // hls/stages/count_bits.hpp:25
  logic or_1693;
  assign or_1693 = (parity_1671 & parity_1686) | ((^{or_1653, or_1649, and_1645}) & (parity_1671 | parity_1686));
  logic or_1697;
  assign or_1697 = (or_1649 & or_1653) | (and_1645 & (or_1649 | or_1653));
  logic or_1701;
  assign or_1701 = (or_1664 & or_1668) | (or_1660 & (or_1664 | or_1668));
  logic or_1705;
  assign or_1705 = (or_1679 & or_1683) | (or_1675 & (or_1679 | or_1683));
  // hls/stages/count_bits.hpp:24
  logic parity_1710;
  assign parity_1710 = ^{or_1705, or_1701, or_1697, or_1693};
  // hls/stages/count_bits.hpp:25
  logic or_1714;
  assign or_1714 = (or_1701 & or_1705) | (or_1697 & (or_1701 | or_1705));
  logic and_1715;
  assign and_1715 = or_1693 & (^{or_1705, or_1701, or_1697});
  // hls/stages/count_bits.hpp:24
  logic xor_1716;
  assign xor_1716 = or_1714 ^ and_1715;
  // hls/stages/count_bits.hpp:27
  logic and_1717;
  assign and_1717 = or_1714 & and_1715;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1718;
  assign select_1718 = equal_581_s1_q ? {and_1717, xor_1716, parity_1710, parity_1689, xor_1644, xor_1549} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_567_s1_q ? 6'h0 : select_1718;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1720;
  assign select_1720 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1721;
  assign difference_1721 = {1'b0, column_4} - {1'b0, select_1720};
  logic [7:0] sum_1723;
  assign sum_1723 = {difference_1721[6], difference_1721} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] not_1727;
  assign not_1727 = ~(select_752 ^ (less_570_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1729;
  assign select_1729 = and_750 ? ((right_codes_rdata_q[12] & not_571_s1_q) ? not_1727 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1735;
  assign parity_1735 = ^select_1729[5:3];
  logic parity_1738;
  assign parity_1738 = ^select_1729[8:6];
  logic parity_1741;
  assign parity_1741 = ^select_1729[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1748;
  assign select_1748 = and_773 ? (and_1240 ? (~(select_775 ^ select_1241)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1751;
  assign parity_1751 = ^select_1748[8:6];
  logic parity_1754;
  assign parity_1754 = ^select_1748[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1761;
  assign select_1761 = and_790 ? (and_751 ? (~(select_792 ^ select_753)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1767;
  assign parity_1767 = ^select_1761[2:0];
  logic parity_1770;
  assign parity_1770 = ^select_1761[5:3];
  logic parity_1773;
  assign parity_1773 = ^select_1761[8:0];
  logic parity_1779;
  assign parity_1779 = ^select_1761[11:9];
  logic parity_1782;
  assign parity_1782 = ^select_1748[2:0];
  logic parity_1785;
  assign parity_1785 = ^{select_1761[11:9], select_1748[5:0]};
  logic parity_1788;
  assign parity_1788 = ^{select_1761, select_1748, select_1729[2:0]};
  logic xor_1789;
  assign xor_1789 = parity_1741 ^ parity_1788;
  // hls/stages/count_bits.hpp:23
  logic or_1793;
  assign or_1793 = (select_1729[1:0] == 2'h3) | (select_1729[2] & (select_1729[0] | select_1729[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1797;
  assign or_1797 = (select_1748[7:6] == 2'h3) | (select_1748[8] & (select_1748[6] | select_1748[7]));
  logic or_1801;
  assign or_1801 = (select_1748[10:9] == 2'h3) | (select_1748[11] & (select_1748[9] | select_1748[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1809;
  assign or_1809 = (select_1761[7:6] == 2'h3) | (select_1761[8] & (~(select_1761[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1813;
  assign or_1813 = (select_1761[1:0] == 2'h3) | (select_1761[2] & (select_1761[0] | select_1761[1]));
  logic or_1817;
  assign or_1817 = (select_1761[4:3] == 2'h3) | (select_1761[5] & (select_1761[3] | select_1761[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1820;
  assign parity_1820 = ^{or_1817, or_1813, or_1809};
  // hls/stages/count_bits.hpp:23
  logic or_1824;
  assign or_1824 = (select_1748[4:3] == 2'h3) | (select_1748[5] & (select_1748[3] | select_1748[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1828;
  assign or_1828 = (select_1761[10:9] == 2'h3) | (select_1761[11] & (select_1761[9] | select_1761[10]));
  logic or_1832;
  assign or_1832 = (select_1748[1:0] == 2'h3) | (select_1748[2] & (select_1748[0] | select_1748[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1835;
  assign parity_1835 = ^{or_1832, or_1828, or_1824};
  logic parity_1838;
  assign parity_1838 = ^{or_1832, or_1828, or_1824, or_1817, or_1813, or_1809, or_1801, or_1797, or_1793};
  // hls/stages/count_bits.hpp:25
  logic and_1839;
  assign and_1839 = parity_1741 & parity_1788;
  logic or_1843;
  assign or_1843 = (parity_1735 & parity_1738) | ((^select_1729[11:9]) & (parity_1735 | parity_1738));
  logic and_1846;
  assign and_1846 = (^{select_1748[11:6], select_1729[2:0]}) & (parity_1773 | parity_1785);
  logic or_1847;
  assign or_1847 = (parity_1773 & parity_1785) | and_1846;
  // hls/stages/count_bits.hpp:23
  logic or_1854;
  assign or_1854 = (select_1729[10:9] == 2'h3) | (select_1729[11] & (select_1729[9] | select_1729[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1858;
  assign or_1858 = (select_1729[4:3] == 2'h3) | (select_1729[5] & (select_1729[3] | select_1729[4]));
  logic or_1862;
  assign or_1862 = (select_1729[7:6] == 2'h3) | (select_1729[8] & (select_1729[6] | select_1729[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1865;
  assign parity_1865 = ^{or_1862, or_1858, or_1854};
  // hls/stages/count_bits.hpp:25
  logic or_1869;
  assign or_1869 = (parity_1751 & parity_1754) | ((^select_1729[2:0]) & (parity_1751 | parity_1754));
  logic or_1873;
  assign or_1873 = (parity_1767 & parity_1770) | ((^select_1761[8:6]) & (parity_1767 | parity_1770));
  logic or_1877;
  assign or_1877 = (parity_1779 & parity_1782) | ((^select_1748[5:3]) & (parity_1779 | parity_1782));
  // hls/stages/count_bits.hpp:24
  logic parity_1880;
  assign parity_1880 = ^{or_1877, or_1873, or_1869};
  logic parity_1883;
  assign parity_1883 = ^{or_1877, or_1873, or_1869, or_1862, or_1858, or_1854, or_1847, or_1843, and_1839};
  logic xor_1884;
  assign xor_1884 = parity_1838 ^ parity_1883;
  // hls/stages/count_bits.hpp:25
  logic and_1885;
  assign and_1885 = parity_1838 & parity_1883;
  logic or_1889;
  assign or_1889 = (parity_1820 & parity_1835) | ((^{or_1801, or_1797, or_1793}) & (parity_1820 | parity_1835));
  logic or_1893;
  assign or_1893 = (parity_1865 & parity_1880) | ((^{or_1847, or_1843, and_1839}) & (parity_1865 | parity_1880));
  logic or_1900;
  assign or_1900 = (or_1797 & or_1801) | (or_1793 & (or_1797 | or_1801));
  logic or_1904;
  assign or_1904 = (or_1813 & or_1817) | (or_1809 & (or_1813 | or_1817));
  logic or_1908;
  assign or_1908 = (or_1828 & or_1832) | (or_1824 & (or_1828 | or_1832));
  // hls/stages/count_bits.hpp:24
  logic parity_1911;
  assign parity_1911 = ^{or_1908, or_1904, or_1900};
  // hls/stages/count_bits.hpp:25
  logic or_1915;
  assign or_1915 = (or_1843 & or_1847) | (and_1839 & (or_1843 | or_1847));
  logic or_1919;
  assign or_1919 = (or_1858 & or_1862) | (or_1854 & (or_1858 | or_1862));
  logic or_1923;
  assign or_1923 = (or_1873 & or_1877) | (or_1869 & (or_1873 | or_1877));
  // hls/stages/count_bits.hpp:24
  logic parity_1926;
  assign parity_1926 = ^{or_1923, or_1919, or_1915};
  logic parity_1929;
  assign parity_1929 = ^{or_1923, or_1919, or_1915, or_1908, or_1904, or_1900, or_1893, or_1889, and_1885};
  // hls/stages/count_bits.hpp:25
  logic or_1933;
  assign or_1933 = (parity_1911 & parity_1926) | ((^{or_1893, or_1889, and_1885}) & (parity_1911 | parity_1926));
  logic or_1937;
  assign or_1937 = (or_1889 & or_1893) | (and_1885 & (or_1889 | or_1893));
  logic or_1941;
  assign or_1941 = (or_1904 & or_1908) | (or_1900 & (or_1904 | or_1908));
  logic or_1945;
  assign or_1945 = (or_1919 & or_1923) | (or_1915 & (or_1919 | or_1923));
  // hls/stages/count_bits.hpp:24
  logic parity_1950;
  assign parity_1950 = ^{or_1945, or_1941, or_1937, or_1933};
  // hls/stages/count_bits.hpp:25
  logic or_1954;
  assign or_1954 = (or_1941 & or_1945) | (or_1937 & (or_1941 | or_1945));
  logic and_1955;
  assign and_1955 = or_1933 & (^{or_1945, or_1941, or_1937});
  // hls/stages/count_bits.hpp:24
  logic xor_1956;
  assign xor_1956 = or_1954 ^ and_1955;
  // hls/stages/count_bits.hpp:27
  logic and_1957;
  assign and_1957 = or_1954 & and_1955;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1958;
  assign select_1958 = equal_581_s1_q ? {and_1957, xor_1956, parity_1950, parity_1929, xor_1884, xor_1789} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_567_s1_q ? 6'h0 : select_1958;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1960;
  assign select_1960 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1961;
  assign difference_1961 = {1'b0, column_5} - {1'b0, select_1960};
  logic [7:0] sum_1963;
  assign sum_1963 = {difference_1961[6], difference_1961} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_2034;
  assign and_2034 = ends_cell_s1_q & inside_v;
  logic and_2036;
  assign and_2036 = not_563 & (so_s1_q & and_2034);
  logic [6:0] select_2040;
  assign select_2040 = so_s1_q ? x_s1_q[6:0] : (or_567_s1_q ? (less_570_s1_q ? 7'h0 : select_614) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2044;
  assign or_2044 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2053;
  assign and_2053 = or_567_s1_q & (slot_s1_q[2] & not_571_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2169;
  assign select_2169 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2169[16:7])) ? 8'h7f : select_2169[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2246_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2246_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:500
  logic less_2334;
  assign less_2334 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:501
  logic or_2335;
  assign or_2335 = equal_2245_s1_q | less_2334;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2340;
  assign select_2340 = equal_2245_s1_q ? patches_column_s1_q[0] : (or_2335 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2341;
  assign not_2341 = ~or_2335;
  // hls/stages/patches.hpp:501
  logic [4:0] sum_2342;
  assign sum_2342 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:503
  logic [4:0] select_2345;
  assign select_2345 = or_2335 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2342) + 5'h1) : sum_2342;
  // hls/stages/patches.hpp:505
  logic [4:0] select_2346;
  assign select_2346 = equal_2245_s1_q ? 5'h0 : select_2345;
  logic or_2347;
  assign or_2347 = equal_2245_s1_q | equal_2243_s1_q;
  // hls/stages/patches.hpp:481
  logic equal_2349;
  assign equal_2349 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2351;
  assign equal_2351 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_2353;
  assign and_2353 = of_row & (~equal_2351);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2349 ? 2'h3 : {equal_2351, and_2353};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_2356;
  assign sum_2356 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2357;
  assign sum_2357 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2356, pixel_2[0]} - {1'b0, sum_2357, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:471
  logic [11:0] sum_2359;
  assign sum_2359 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2360;
  assign sum_2360 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2359[11], sum_2359};
  logic [13:0] sum_2361;
  assign sum_2361 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2360, down_2[1]};
  logic [12:0] sum_2362;
  assign sum_2362 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2361[13:1];
  logic [14:0] sum_2363;
  assign sum_2363 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2362, sum_2361[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic or_2370;
  assign or_2370 = (sum_2363[8] & (~(sum_2363[7:0] == 8'h0))) | (~(sum_2363[13:9] == 5'h0));
  // hls/stages/patches.hpp:467
  logic [8:0] sum_2375;
  assign sum_2375 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2376;
  assign sum_2376 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2375};
  logic [10:0] sum_2377;
  assign sum_2377 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2376, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2378;
  assign sum_2378 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2377[10:1];
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_2378, sum_2377[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:470
  logic [12:0] sum_2380;
  assign sum_2380 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2381;
  assign sum_2381 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2382;
  assign difference_2382 = {1'b0, sum_2380, smooth[0]} - {1'b0, sum_2381, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:453
  logic or_2389;
  assign or_2389 = (difference_2382[8] & (~(difference_2382[7:0] == 8'h0))) | (~(difference_2382[13:9] == 5'h0));
  // hls/stages/patches.hpp:482
  logic or_2397;
  assign or_2397 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2351) | equal_2349;
  // hls/stages/patches.hpp:477
  logic and_2402;
  assign and_2402 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2406;
  assign and_2406 = not_2244_s1_q & (or_2247_s1_q & (or_2397 & (equal_2246_s1_q & and_2402)));
  // hls/stages/patches.hpp:172
  logic and_2416;
  assign and_2416 = (~(equal_2246_s1_q | (~and_2402))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2420;
  assign and_2420 = not_2244_s1_q & (or_2247_s1_q & (and_2416 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:546
  logic less_2422;
  assign less_2422 = patches_step_q[4:0] < 5'h11;
  logic equal_2423;
  assign equal_2423 = patches_step_q[6:5] == 2'h0;
  logic not_2424;
  assign not_2424 = ~equal_2423;
  logic equal_2425;
  assign equal_2425 = patches_step_q[6:5] == 2'h3;
  logic not_2426;
  assign not_2426 = ~equal_2425;
  // hls/stages/patches.hpp:560
  logic select_2429;
  assign select_2429 = equal_2425 ? (less_2422 & (less_2422 & not_2426)) : less_2422;
  // hls/stages/patches.hpp:184
  logic and_2432;
  assign and_2432 = equal_2241_s1_q & (less_2422 ? (not_2424 & select_2429) : select_2429);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2454;
  assign sum_2454 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2737;
  assign or_2737 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:460
  logic select_3021;
  assign select_3021 = equal_2927_s1_q ? (~({row_s1_q, 1'b0} < {sum_3018, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3265;
  assign and_3265 = and_537_s1_q & (equal_2927_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3266;
  assign and_3266 = and_2928_s1_q & and_3265;
  // hls/stages/registration.hpp:127
  logic and_3268;
  assign and_3268 = and_2928_s1_q & (~and_3265);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3269;
  assign select_3269 = and_3268 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3271;
  assign select_3271 = and_3266 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3269[15]}}, select_3269});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3272;
  assign select_3272 = and_3268 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3272[15]}}, select_3272};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3274;
  assign select_3274 = and_3266 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3275;
  assign and_3275 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3275 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3521;
  assign select_3521 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3524;
  assign select_3524 = equal_2243_s1_q ? patches_smooth_values_0_q : (or_2247_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3526;
  assign select_3526 = or_2247_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3528;
  assign select_3528 = equal_2241_s1_q ? patches_smooth_values_1_q : (equal_2243_s1_q ? patches_smooth_values_1_q : select_3526);
  logic [11:0] select_3529;
  assign select_3529 = or_2247_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3531;
  assign select_3531 = equal_2241_s1_q ? patches_smooth_values_2_q : (equal_2243_s1_q ? patches_smooth_values_2_q : select_3529);
  logic [11:0] select_3532;
  assign select_3532 = or_2247_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3534;
  assign select_3534 = equal_2241_s1_q ? patches_smooth_values_3_q : (equal_2243_s1_q ? patches_smooth_values_3_q : select_3532);
  logic [10:0] select_3536;
  assign select_3536 = equal_2243_s1_q ? patches_down_values_0_q : (or_2247_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3539;
  assign select_3539 = equal_2243_s1_q ? patches_down_values_1_q : (or_2247_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3542;
  assign select_3542 = equal_2243_s1_q ? patches_down_values_2_q : (or_2247_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3545;
  assign select_3545 = equal_2243_s1_q ? patches_down_values_3_q : (or_2247_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3582;
  assign and_3582 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3587;
  assign select_3587 = or_3482_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3589;
  assign select_3589 = and_3582 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3945;
  assign select_3945 = equal_2241_s1_q ? patches_summed_down_by_q : (equal_2243_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:556
  logic and_3978;
  assign and_3978 = less_2422 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:560
  logic select_3981;
  assign select_3981 = equal_2425 ? (less_2422 ? (not_2426 & and_3978) : and_3978) : and_3978;
  // hls/stages/patches.hpp:184
  logic select_3984;
  assign select_3984 = equal_2241_s1_q ? (less_2422 ? (not_2424 & select_3981) : select_3981) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4323;
  assign select_4323 = so_s1_q ? (and_3275 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4325;
  assign sum_4325 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4326;
  assign select_4326 = sum_2454[5] ? {1'b1, sum_2454[4:0], region_across_rest_q[2:0]} : sum_4325;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4328;
  assign select_4328 = equal_2927_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4331;
  assign select_4331 = equal_2927_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_507_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_512;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:340; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s1_2_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_537_s1_q;
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
  assign moments_memory_raddr = select_561;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_579;
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
  assign best_right_raddr = or_567_s1_q ? select_614 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_605_s1_q;
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
  assign shown_right_re = s1_en & and_2036;
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
  assign left_turns_re = s1_en & and_2053;
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
  assign right_turns_raddr = select_614;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2053;
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
  assign patches_right_codes_raddr = {select_2346, not_2341, select_2340};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2347;
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
  assign patches_rows_re = s1_en & and_2432;
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
  assign seen_columns_re = s1_en & and_2036;
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
  assign left_we = s1_en & and_638_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_739, left_rdata_q[65:49], and_738, left_rdata_q[47:31], and_737, left_rdata_q[29:13], and_736, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_638_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_745, right_codes_rdata_q[84:73], and_744, right_codes_rdata_q[71:60], and_743, right_codes_rdata_q[56:43], and_742, right_codes_rdata_q[41:28], and_741, right_codes_rdata_q[26:13], and_740, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2328_s1_q;
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
      moments_place_q <= select_560;
      moments_taken_q <= not_563 & (not_565 & (equal_566_s1_q & inside_v));
      moments_starts_q <= not_563 & (not_565 & (equal_566_s1_q & (inside_v & first)));
      row_q <= and_537_s1_q ? (equal_2927_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_537_s1_q ? select_3021 : lower_half_q;
      registration_slope_row_q <= select_3271;
      registration_slope_change_q <= select_3274;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3506_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3506_s1_q & select_3521;
      patches_smooth_values_0_q <= equal_2241_s1_q ? patches_smooth_values_0_q : select_3524;
      patches_smooth_values_1_q <= select_3528;
      patches_smooth_values_2_q <= select_3531;
      patches_smooth_values_3_q <= select_3534;
      patches_down_values_0_q <= equal_2241_s1_q ? patches_down_values_0_q : select_3536;
      patches_down_values_1_q <= equal_2241_s1_q ? patches_down_values_1_q : select_3539;
      patches_down_values_2_q <= equal_2241_s1_q ? patches_down_values_2_q : select_3542;
      patches_down_values_3_q <= equal_2241_s1_q ? patches_down_values_3_q : select_3545;
      patches_down_by_q <= or_3482_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3582});
      patches_along_q <= select_3587;
      patches_match_row_q <= or_3482_s1_q ? 4'h0 : select_3589;
      patches_summed_last_q <= not_2242_s1_q & (equal_2243_s1_q & and_3582);
      patches_summed_down_by_q <= select_3945;
      patches_step_q <= or_3482_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3984;
      region_across_rest_q <= select_4323;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4326;
      columns_begin_rest_q <= and_537_s1_q ? select_4328 : columns_begin_rest_q;
      columns_begin_back_q <= and_537_s1_q ? select_4331 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= sum_999;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1239;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1479;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1723;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1963;
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
  logic [6:0] select_503_s2_q;
  logic [8:0] select_507_s2_q;
  logic and_511_s2_q;
  logic and_512_s2_q;
  logic equal_517_s2_q;
  logic [6:0] last_s2_2_q;
  logic and_535_s2_q;
  logic and_537_s2_q;
  logic equal_557_s2_q;
  logic [12:0] select_561_s2_q;
  logic equal_562_s2_q;
  logic not_563_s2_q;
  logic so_s2_q;
  logic not_565_s2_q;
  logic equal_566_s2_q;
  logic or_567_s2_q;
  logic less_570_s2_q;
  logic not_571_s2_q;
  logic inside_v_s2_q;
  logic not_575_s2_q;
  logic and_579_s2_q;
  logic and_588_s2_q;
  logic and_596_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_627_s2_q;
  logic and_632_s2_q;
  logic and_634_s2_q;
  logic equal_667_s2_q;
  logic and_2023_s2_q;
  logic equal_2024_s2_q;
  logic and_2034_s2_q;
  logic and_2036_s2_q;
  logic [6:0] select_2040_s2_q;
  logic or_2044_s2_q;
  logic and_2137_s2_q;
  logic and_2150_s2_q;
  logic less_2164_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2241_s2_q;
  logic equal_2243_s2_q;
  logic equal_2246_s2_q;
  logic or_2247_s2_q;
  logic [4:0] select_2271_s2_q;
  logic select_2277_s2_q;
  logic [3:0] select_2318_s2_q;
  logic less_2334_s2_q;
  logic new_row_s2_q;
  logic or_2347_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2364_s2_q;
  logic or_2370_s2_q;
  logic and_2374_s2_q;
  logic and_2390_s2_q;
  logic and_2393_s2_q;
  logic and_2407_s2_q;
  logic and_2416_s2_q;
  logic and_2421_s2_q;
  logic less_2422_s2_q;
  logic equal_2423_s2_q;
  logic not_2424_s2_q;
  logic equal_2425_s2_q;
  logic not_2426_s2_q;
  logic sum_2454_s2_q;
  logic and_2475_s2_q;
  logic and_2592_s2_q;
  logic equal_2738_s2_q;
  logic equal_2927_s2_q;
  logic and_3034_s2_q;
  logic equal_3119_s2_q;
  logic less_3558_s2_q;
  logic equal_3901_s2_q;
  logic equal_3985_s2_q;
  logic less_4311_s2_q;
  logic equal_4530_s2_q;
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
      select_503_s2_q <= select_503_s1_q;
      select_507_s2_q <= select_507_s1_q;
      and_511_s2_q <= and_511_s1_q;
      and_512_s2_q <= and_512;
      equal_517_s2_q <= equal_517_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_535_s2_q <= and_535_s1_q;
      and_537_s2_q <= and_537_s1_q;
      equal_557_s2_q <= equal_557;
      select_561_s2_q <= select_561;
      equal_562_s2_q <= equal_562_s1_q;
      not_563_s2_q <= not_563;
      so_s2_q <= so_s1_q;
      not_565_s2_q <= not_565;
      equal_566_s2_q <= equal_566_s1_q;
      or_567_s2_q <= or_567_s1_q;
      less_570_s2_q <= less_570_s1_q;
      not_571_s2_q <= not_571_s1_q;
      inside_v_s2_q <= inside_v;
      not_575_s2_q <= not_575;
      and_579_s2_q <= and_579;
      and_588_s2_q <= or_567_s1_q & (left_rdata_q[70] & not_571_s1_q);
      and_596_s2_q <= (or_567_s1_q & (left_rdata_q[68] & not_571_s1_q)) & and_595;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_627_s2_q <= or_567_s1_q & (left_rdata_q[71] & not_571_s1_q);
      and_632_s2_q <= or_567_s1_q & (right_codes_rdata_q[58] & not_571_s1_q);
      and_634_s2_q <= or_567_s1_q & (right_codes_rdata_q[59] & not_571_s1_q);
      equal_667_s2_q <= row_s1_q == 6'h0;
      and_2023_s2_q <= and_2023_s1_q;
      equal_2024_s2_q <= equal_2024_s1_q;
      and_2034_s2_q <= and_2034;
      and_2036_s2_q <= and_2036;
      select_2040_s2_q <= select_2040;
      or_2044_s2_q <= or_2044;
      and_2137_s2_q <= and_2137_s1_q;
      and_2150_s2_q <= and_2150_s1_q;
      less_2164_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2241_s2_q <= equal_2241_s1_q;
      equal_2243_s2_q <= equal_2243_s1_q;
      equal_2246_s2_q <= equal_2246_s1_q;
      or_2247_s2_q <= or_2247_s1_q;
      select_2271_s2_q <= select_2271_s1_q;
      select_2277_s2_q <= select_2277_s1_q;
      select_2318_s2_q <= select_2318_s1_q;
      less_2334_s2_q <= less_2334;
      new_row_s2_q <= new_row;
      or_2347_s2_q <= or_2347;
      of_row_2_s2_q <= of_row_2;
      not_2364_s2_q <= ~sum_2363[14];
      or_2370_s2_q <= or_2370;
      and_2374_s2_q <= sum_2363[14] & (~(sum_2363[13:8] == 6'h3f));
      and_2390_s2_q <= (~difference_2382[14]) & or_2389;
      and_2393_s2_q <= difference_2382[14] & (~(difference_2382[13:8] == 6'h3f));
      and_2407_s2_q <= not_2242_s1_q & and_2406;
      and_2416_s2_q <= and_2416;
      and_2421_s2_q <= not_2242_s1_q & and_2420;
      less_2422_s2_q <= less_2422;
      equal_2423_s2_q <= equal_2423;
      not_2424_s2_q <= not_2424;
      equal_2425_s2_q <= equal_2425;
      not_2426_s2_q <= not_2426;
      sum_2454_s2_q <= sum_2454[5];
      and_2475_s2_q <= or_567_s1_q & (left_rdata_q[69] & not_571_s1_q);
      and_2592_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2738_s2_q <= {last_s1_2_q[6], or_2737} == 7'h0;
      equal_2927_s2_q <= equal_2927_s1_q;
      and_3034_s2_q <= or_567_s1_q & (not_571_s1_q & and_595);
      equal_3119_s2_q <= shift == 6'h0;
      less_3558_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3901_s2_q <= patches_match_row_q == 4'h0;
      equal_3985_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4311_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4530_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [11:0] select_515;
  assign select_515 = select_501_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_519;
  assign sum_519 = select_515 + (equal_517_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_521;
  assign sum_521 = {4'h0, sample_pair_pixel_1_q} + (select_501_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_523;
  assign sum_523 = sum_521 + (equal_517_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_501_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_527;
  assign and_527 = whole & (averager_memory_rdata_q[24] | equal_517_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_501_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_531;
  assign and_531 = all_of_skin & (averager_memory_rdata_q[25] | equal_517_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_511_s2_q ? sum_519[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_540;
  assign equal_540 = select_501_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_540 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_543;
  assign select_543 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_511_s2_q ? sum_523[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_540 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_547;
  assign select_547 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_548;
  assign and_548 = and_511_s2_q & and_527;
  // hls/stages/census.hpp:127
  logic select_550;
  assign select_550 = equal_540 ? and_548 : (averager_mask_q & and_548);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_550;
  // hls/stages/census.hpp:207
  logic and_552;
  assign and_552 = and_511_s2_q & and_531;
  // hls/stages/census.hpp:127
  logic select_554;
  assign select_554 = equal_540 ? and_552 : (averager_of_skin_q & and_552);
  // hls/stages/agreement.hpp:276
  logic and_555;
  assign and_555 = sample_pair_whole_s2_q & select_554;
  // hls/stages/agreement.hpp:978
  logic select_609;
  assign select_609 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_619;
  assign difference_619 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_620;
  assign sum_620 = {difference_619[8], difference_619} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_622;
  assign and_622 = (and_596_s2_q & select_609) & ({{22{sum_620[9]}}, sum_620} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_624;
  assign and_624 = or_567_s2_q & (not_571_s2_q & and_622);
  // hls/stages/moments.hpp:77
  logic and_625;
  assign and_625 = and_588_s2_q & and_624;
  // hls/stages/census.hpp:296
  logic less_640;
  assign less_640 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_641;
  assign less_641 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_642;
  assign less_642 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_643;
  assign less_643 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_644;
  assign less_644 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_645;
  assign less_645 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_646;
  assign less_646 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_647;
  assign less_647 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_648;
  assign less_648 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_652;
  assign less_652 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_653;
  assign less_653 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_657;
  assign less_657 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_658;
  assign less_658 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_664;
  assign equal_664 = last_s2_2_q == 7'h0;
  logic [3:0] select_668;
  assign select_668 = equal_667_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_669;
  assign select_669 = equal_664 ? {select_668, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_670;
  assign select_670 = equal_664 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_671;
  assign and_671 = select_669[4] & select_670[3];
  // hls/stages/census.hpp:288
  logic and_673;
  assign and_673 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_675;
  assign and_675 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_673);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_675;
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
  // hls/stages/census.hpp:272
  logic [9:0] difference_698;
  assign difference_698 = {1'b0, select_543} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_699;
  assign xor_699 = difference_698[8:0] ^ {9{difference_698[9]}};
  logic [9:0] sum_700;
  assign sum_700 = {9'h0, difference_698[9]} + {1'b0, xor_699};
  logic [9:0] difference_701;
  assign difference_701 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_702;
  assign xor_702 = difference_701[8:0] ^ {9{difference_701[9]}};
  logic [9:0] sum_703;
  assign sum_703 = {9'h0, difference_701[9]} + {1'b0, xor_702};
  logic [9:0] difference_705;
  assign difference_705 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_706;
  assign xor_706 = difference_705[8:0] ^ {9{difference_705[9]}};
  logic [9:0] sum_707;
  assign sum_707 = {9'h0, difference_705[9]} + {1'b0, xor_706};
  logic [10:0] sum_708;
  assign sum_708 = ({1'b0, sum_700} + {1'b0, sum_703}) + {1'b0, sum_707};
  logic [9:0] difference_709;
  assign difference_709 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_710;
  assign xor_710 = difference_709[8:0] ^ {9{difference_709[9]}};
  logic [9:0] sum_711;
  assign sum_711 = {9'h0, difference_709[9]} + {1'b0, xor_710};
  logic [9:0] difference_713;
  assign difference_713 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_714;
  assign xor_714 = difference_713[8:0] ^ {9{difference_713[9]}};
  // hls/stages/agreement.hpp:456
  logic and_722;
  assign and_722 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_723;
  assign and_723 = and_671 & and_722;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_725;
  assign sum_725 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_727;
  assign and_727 = and_723 & ({{5{sum_725[6]}}, sum_725, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_731;
  assign sum_731 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_747;
  assign or_747 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_749;
  assign select_749 = or_747 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:751
  logic less_1480;
  assign less_1480 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1481;
  assign select_1481 = less_1480 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1482;
  assign less_1482 = middle_sum_sum_sums_values_0_q < select_1481;
  logic [7:0] select_1483;
  assign select_1483 = less_1482 ? select_1481 : middle_sum_sum_sums_values_0_q;
  logic less_1964;
  assign less_1964 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1965;
  assign select_1965 = less_1964 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1966;
  assign less_1966 = select_1483 < select_1965;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1966 ? select_1965 : select_1483) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1970;
  assign or_1970 = select_749 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1971;
  assign select_1971 = or_1970 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:752
  logic or_1973;
  assign or_1973 = less_1480 | (~less_1482);
  logic [2:0] select_1974;
  assign select_1974 = less_1966 ? {less_1964, 2'h0} : {1'b0, or_1973, less_1482};
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1975;
  assign select_1975 = or_1970 ? select_1974 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1976;
  assign select_1976 = or_1970 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1977;
  assign equal_1977 = select_1974 == 3'h1;
  logic or_1980;
  assign or_1980 = equal_1977 | (~(select_1974 == 3'h2));
  logic [7:0] select_1982;
  assign select_1982 = or_1980 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1983;
  assign select_1983 = equal_1977 ? (or_1980 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1982;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1984;
  assign select_1984 = or_1970 ? select_1983 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1985;
  assign select_1985 = or_1980 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1987;
  assign select_1987 = or_1970 ? (equal_1977 ? select_1982 : select_1985) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1989;
  assign sum_1989 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1990;
  assign sum_1990 = {1'b0, before_v} + sum_1989;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1992;
  assign sum_1992 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1993;
  assign sum_1993 = {1'b0, before_v_2} + sum_1992;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1995;
  assign sum_1995 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1996;
  assign sum_1996 = {1'b0, before_v_3} + sum_1995;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1998;
  assign select_1998 = (sum_1993 < sum_1996) ? sum_1996 : sum_1993;
  logic [6:0] select_2000;
  assign select_2000 = (sum_1990 < select_1998) ? select_1998 : sum_1990;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2002;
  assign sum_2002 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2003;
  assign sum_2003 = {1'b0, before_v_4} + sum_2002;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_2005;
  assign sum_2005 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2006;
  assign sum_2006 = {1'b0, before_v_5} + sum_2005;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2008;
  assign select_2008 = (sum_2003 < sum_2006) ? sum_2006 : sum_2003;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2000 < select_2008) ? select_2008 : select_2000) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_2012;
  assign less_2012 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_2014;
  assign select_2014 = select_749 ? of_near : (less_2012 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2016;
  assign select_2016 = select_749 ? run_shift_s2_q : (less_2012 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2019;
  assign select_2019 = (run_shift_s2_q == 6'h3f) ? of_best : (select_749 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_2022;
  assign select_2022 = (run_shift_s2_q == 6'h1) ? of_best : (select_749 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_2025;
  assign select_2025 = or_747 ? shift_first_s2_q : equal_2024_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_2027;
  assign or_2027 = select_2025 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2028;
  assign select_2028 = or_2027 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2029;
  assign select_2029 = or_2027 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2031;
  assign or_2031 = select_2025 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_2032;
  assign select_2032 = or_2031 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2033;
  assign select_2033 = or_2031 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2047;
  assign and_2047 = or_567_s2_q & (not_571_s2_q & (and_622 & or_2044_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_2048;
  assign and_2048 = not_565_s2_q & and_2047;
  logic and_2051;
  assign and_2051 = not_563_s2_q & (so_s2_q ? and_2034_s2_q : (equal_566_s2_q & and_624));
  // hls/stages/moments.hpp:73
  logic and_2055;
  assign and_2055 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_2056;
  assign and_2056 = not_575_s2_q & and_2055;
  logic and_2059;
  assign and_2059 = not_575_s2_q & (and_2055 & (moments_memory_rdata_q[1] ^ and_627_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2064;
  assign and_2064 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_2065;
  assign and_2065 = not_575_s2_q & and_2064;
  logic and_2068;
  assign and_2068 = not_575_s2_q & (and_2064 & (moments_memory_rdata_q[3] ^ and_634_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_2069;
  assign equal_2069 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_2072;
  assign select_2072 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_2074;
  assign select_2074 = equal_2069 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2072});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2075;
  assign sum_2075 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2076;
  assign select_2076 = equal_562_s2_q ? select_2074 : {sum_2075, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_2077;
  assign equal_2077 = x_s2_q[5:0] == 6'h3f;
  logic equal_2079;
  assign equal_2079 = x_s2_q[5:0] == 6'h3e;
  logic equal_2081;
  assign equal_2081 = x_s2_q[5:0] == 6'h3d;
  logic equal_2083;
  assign equal_2083 = x_s2_q[5:0] == 6'h3c;
  logic equal_2085;
  assign equal_2085 = x_s2_q[5:0] == 6'h3b;
  logic equal_2087;
  assign equal_2087 = x_s2_q[5:0] == 6'h36;
  logic equal_2089;
  assign equal_2089 = x_s2_q[5:0] == 6'h35;
  logic equal_2091;
  assign equal_2091 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_2095;
  assign and_2095 = (~equal_2085) & ((~equal_2087) & ((~equal_2089) & (~equal_2091)));
  logic and_2099;
  assign and_2099 = (~equal_2077) & ((~equal_2079) & ((~equal_2081) & ((~equal_2083) & and_2095)));
  // hls/stages/agreement.hpp:1129
  logic less_2100;
  assign less_2100 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2104;
  assign or_2104 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_2109;
  assign sum_2109 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2109, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2115;
  assign sum_2115 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2117;
  assign and_2117 = half_ends & ({{3{sum_2115[4]}}, sum_2115} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_2118;
  assign and_2118 = so_s2_q & and_2117;
  logic select_2119;
  assign select_2119 = equal_562_s2_q ? (x_s2_q[6] & (equal_2069 ? and_2099 : (less_2100 & (~or_2104)))) : and_2118;
  // hls/stages/registration.hpp:258
  logic not_2121;
  assign not_2121 = ~lower_half_s2_q;
  logic [3:0] select_2122;
  assign select_2122 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2121, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2121};
  // hls/stages/patches.hpp:373
  logic [1:0] select_2151;
  assign select_2151 = and_2150_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2152;
  assign select_2152 = and_2150_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2153;
  assign select_2153 = and_2137_s2_q ? {select_2152, select_2151[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2154;
  assign select_2154 = and_2137_s2_q ? select_2151 : patches_fetch_q;
  logic equal_2155;
  assign equal_2155 = select_2154 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_2163;
  assign and_2163 = not_563_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2165;
  assign equal_2165 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_567_s2_q ? (less_570_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
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
  assign and_2188 = less_2164_s2_q & (and_624 & ({{4{sum_2185[9]}}, sum_2185, expected[1:0]} < 16'h29));
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
  assign and_2204 = (~(and_2192 | (equal_557_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2203;
  // hls/stages/agreement.hpp:788
  logic and_2208;
  assign and_2208 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2188 & and_2204)));
  logic and_2209;
  assign and_2209 = not_563_s2_q & and_2208;
  // hls/stages/patches.hpp:156
  logic and_2211;
  assign and_2211 = and_2209 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_2212;
  assign select_2212 = and_2211 ? and_2209 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2215;
  assign select_2215 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2217;
  assign select_2217 = and_2211 ? (equal_562_s2_q ? 8'h0 : select_2215) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2220;
  assign select_2220 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_2222;
  assign select_2222 = and_2211 ? (equal_562_s2_q ? 6'h0 : select_2220) : patches_choice_shift_q;
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
  // hls/stages/patches.hpp:344
  logic [7:0] select_2233;
  assign select_2233 = and_2211 ? (equal_562_s2_q ? 8'h0 : select_2231) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2234;
  assign equal_2234 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_2238;
  assign and_2238 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2192 | equal_2234)));
  logic and_2239;
  assign and_2239 = not_563_s2_q & and_2238;
  // hls/stages/patches.hpp:344
  logic and_2240;
  assign and_2240 = patches_chooses_s2_q & and_2239;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2254;
  assign select_2254 = and_2137_s2_q ? select_2152 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_2255;
  assign equal_2255 = {patches_choosing_band_s2_q, and_2163} == {select_2254, select_2154[1]};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_2355;
  assign sum_2355 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_2371;
  assign and_2371 = not_2364_s2_q & or_2370_s2_q;
  // hls/stages/patches.hpp:490
  logic [1:0] sum_2411;
  assign sum_2411 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2441;
  assign select_2441 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2444;
  assign or_2444 = select_2441[7] | (~({select_2441[5], select_2441[3], select_2441[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2447;
  assign or_2447 = select_2441[7] | (~({select_2441[6], select_2441[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2450;
  assign or_2450 = select_2441[7] | (~(select_2441[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2451;
  assign select_2451 = equal_562_s2_q ? x_s2_q[5:0] : {region_row_q, or_2450, or_2447, or_2444};
  // hls/stages/agreement.hpp:1128
  logic not_2452;
  assign not_2452 = ~equal_2069;
  // hls/stages/agreement.hpp:1058
  logic or_2456;
  assign or_2456 = (~sum_2454_s2_q) | equal_2234;
  // hls/stages/agreement.hpp:788
  logic and_2459;
  assign and_2459 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2456));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_567_s2_q & (not_571_s2_q & and_596_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_624;
  // hls/stages/agreement.hpp:149
  logic and_2477;
  assign and_2477 = or_567_s2_q & (not_571_s2_q & and_2475_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2486;
  assign and_2486 = inside_v_s2_q & and_2477;
  // hls/stages/agreement.hpp:1014
  logic select_2487;
  assign select_2487 = slot_s2_q[2] ? shown_shown_q : and_624;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2487);
  // hls/stages/agreement.hpp:1014
  logic select_2490;
  assign select_2490 = slot_s2_q[2] ? shown_nearer_q : and_2047;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2487 ? select_2490 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1275
  logic or_2493;
  assign or_2493 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [16:0] select_2495;
  assign select_2495 = marks_first_s2_q ? 17'h1 : (or_2493 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2497;
  assign select_2497 = or_2493 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2499;
  assign select_2499 = cfg_compete_i ? (or_2493 & select_2495[16]) : (select_2497[8] & select_2495[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2499 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2502;
  assign select_2502 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2504;
  assign select_2504 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2502});
  // hls/stages/agreement.hpp:1301
  logic equal_2505;
  assign equal_2505 = seen_x_q == 3'h7;
  logic [7:0] select_2507;
  assign select_2507 = select_2499 ? 8'h0 : (seen_column_q + {7'h0, equal_2505});
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = select_2504 + {5'h0, select_2507};
  // hls/stages/agreement.hpp:1275
  logic select_2510;
  assign select_2510 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2511;
  assign sum_2511 = {1'b0, select_2510, 2'h0, select_2510, 1'b0, {2{select_2510}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1274
  logic not_2512;
  assign not_2512 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2514;
  assign and_2514 = not_2512 & (began_q | select_2499);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2516;
  assign select_2516 = select_2499 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2518;
  assign and_2518 = and_2514 & (select_2516 == 3'h0);
  logic less_2519;
  assign less_2519 = select_2507 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2522;
  assign sum_2522 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2522[7]}}, sum_2522, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [7:0] sum_2524;
  assign sum_2524 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2525;
  assign and_2525 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2526;
  assign and_2526 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2527;
  assign and_2527 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2528;
  assign and_2528 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2530;
  assign sum_2530 = {1'b0, and_2527} + ({1'b0, textured} + {1'b0, and_2528});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2525} + ({2'h0, and_2526} + {1'b0, sum_2530});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2539;
  assign select_2539 = inside_v_s2_q ? (sum_2454_s2_q ? select_2441 : {select_2441[6:0], 1'b0}) : select_2441;
  // hls/stages/agreement.hpp:1050
  logic or_2542;
  assign or_2542 = select_2539[7] | (~({select_2539[5], select_2539[3], select_2539[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2559;
  assign and_2559 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2560;
  assign and_2560 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2561;
  assign and_2561 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2562;
  assign and_2562 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2564;
  assign sum_2564 = {1'b0, and_2561} + ({1'b0, shown} + {1'b0, and_2562});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2559} + ({2'h0, and_2560} + {1'b0, sum_2564});
  // hls/stages/agreement.hpp:1030
  logic and_2575;
  assign and_2575 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2576;
  assign and_2576 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2577;
  assign and_2577 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2578;
  assign and_2578 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2580;
  assign sum_2580 = {1'b0, and_2577} + ({1'b0, near} + {1'b0, and_2578});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2575} + ({2'h0, and_2576} + {1'b0, sum_2580});
  // hls/stages/agreement.hpp:788
  logic and_2596;
  assign and_2596 = ends_cell_s2_q & (and_2592_s2_q & (~({sum_2109, last_s2_q[1:0]} < x_s2_q)));
  logic and_2598;
  assign and_2598 = not_563_s2_q & (so_s2_q & and_2596);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2630;
  assign select_2630 = sample_pair_whole_s2_q ? (and_535_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2632;
  assign select_2632 = sample_pair_whole_s2_q ? (and_535_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2651;
  assign select_2651 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2653;
  assign select_2653 = sample_pair_whole_s2_q ? (and_535_s2_q ? select_550 : averager_mask_q) : averager_mask_q;
  logic select_2655;
  assign select_2655 = sample_pair_whole_s2_q ? (and_535_s2_q ? select_554 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2656;
  assign select_2656 = and_537_s2_q ? select_543 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2657;
  assign select_2657 = and_537_s2_q ? select_547 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2659;
  assign select_2659 = and_537_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2660;
  assign select_2660 = and_537_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2661;
  assign select_2661 = and_537_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2662;
  assign select_2662 = and_537_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2663;
  assign select_2663 = and_537_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2664;
  assign select_2664 = and_537_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2665;
  assign select_2665 = and_537_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2666;
  assign select_2666 = and_537_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2667;
  assign select_2667 = and_537_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2668;
  assign select_2668 = and_537_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2669;
  assign select_2669 = and_537_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2670;
  assign select_2670 = and_537_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2671;
  assign select_2671 = and_537_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2672;
  assign select_2672 = and_537_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2673;
  assign select_2673 = and_537_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2674;
  assign select_2674 = and_537_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2675;
  assign select_2675 = and_537_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2676;
  assign select_2676 = and_537_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2677;
  assign select_2677 = and_537_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2678;
  assign select_2678 = and_537_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2679;
  assign select_2679 = and_537_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2680;
  assign select_2680 = and_537_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2681;
  assign select_2681 = and_537_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2682;
  assign select_2682 = and_537_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2683;
  assign select_2683 = and_537_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2684;
  assign select_2684 = and_537_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2685;
  assign select_2685 = and_537_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2686;
  assign select_2686 = and_537_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2687;
  assign select_2687 = and_537_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2688;
  assign select_2688 = and_537_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2689;
  assign select_2689 = and_537_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2690;
  assign select_2690 = and_537_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2691;
  assign select_2691 = and_537_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2692;
  assign select_2692 = and_537_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2693;
  assign select_2693 = and_537_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2694;
  assign select_2694 = and_537_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2695;
  assign select_2695 = and_537_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2696;
  assign select_2696 = and_537_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2697;
  assign select_2697 = and_537_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2698;
  assign select_2698 = and_537_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2699;
  assign select_2699 = and_537_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2700;
  assign select_2700 = and_537_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2701;
  assign select_2701 = and_537_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2702;
  assign select_2702 = and_537_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2703;
  assign select_2703 = and_537_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2704;
  assign select_2704 = and_537_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2705;
  assign select_2705 = and_537_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2706;
  assign select_2706 = and_537_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2707;
  assign select_2707 = and_537_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2708;
  assign select_2708 = and_537_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2709;
  assign select_2709 = and_537_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2710;
  assign select_2710 = and_537_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2711;
  assign select_2711 = and_537_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2713;
  assign difference_2713 = {1'b0, select_547} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2714;
  assign xor_2714 = difference_2713[8:0] ^ {9{difference_2713[9]}};
  logic [9:0] sum_2715;
  assign sum_2715 = {9'h0, difference_2713[9]} + {1'b0, xor_2714};
  logic [9:0] difference_2716;
  assign difference_2716 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2717;
  assign xor_2717 = difference_2716[8:0] ^ {9{difference_2716[9]}};
  logic [9:0] sum_2718;
  assign sum_2718 = {9'h0, difference_2716[9]} + {1'b0, xor_2717};
  logic [9:0] difference_2720;
  assign difference_2720 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2721;
  assign xor_2721 = difference_2720[8:0] ^ {9{difference_2720[9]}};
  logic [9:0] sum_2722;
  assign sum_2722 = {9'h0, difference_2720[9]} + {1'b0, xor_2721};
  logic [10:0] sum_2723;
  assign sum_2723 = ({1'b0, sum_2715} + {1'b0, sum_2718}) + {1'b0, sum_2722};
  logic [9:0] difference_2724;
  assign difference_2724 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2725;
  assign xor_2725 = difference_2724[8:0] ^ {9{difference_2724[9]}};
  logic [9:0] sum_2726;
  assign sum_2726 = {9'h0, difference_2724[9]} + {1'b0, xor_2725};
  logic [9:0] difference_2728;
  assign difference_2728 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2729;
  assign xor_2729 = difference_2728[8:0] ^ {9{difference_2728[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2750;
  assign sum_2750 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2752;
  assign sum_2752 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2753;
  assign equal_2753 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2754;
  assign select_2754 = equal_2753 ? sum_2750 : moments_before_0_q;
  logic [13:0] select_2756;
  assign select_2756 = equal_2753 ? sum_2752 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2759;
  assign select_2759 = equal_562_s2_q ? (moments_has_before_q | equal_2753) : moments_has_before_q;
  logic [13:0] select_2762;
  assign select_2762 = equal_562_s2_q ? ((select_2756 < select_2754) ? select_2754 : select_2756) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2763;
  assign sum_2763 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2766;
  assign select_2766 = equal_562_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2763)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2767;
  assign sum_2767 = {1'b0, sum_2752} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2770;
  assign select_2770 = equal_562_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2767)) : moments_left_alone_q;
  logic select_2773;
  assign select_2773 = equal_562_s2_q ? (~({3'h0, select_2756[13:2]} < sum_2767)) : moments_left_other_stops_q;
  logic select_2776;
  assign select_2776 = equal_562_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2763)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2777;
  assign sum_2777 = {1'b0, sum_2750} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2780;
  assign select_2780 = equal_562_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2777)) : moments_right_alone_q;
  logic select_2783;
  assign select_2783 = equal_562_s2_q ? (~({3'h0, select_2754[13:2]} < sum_2777)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2786;
  assign or_2786 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2794;
  assign and_2794 = not_563_s2_q & (not_565_s2_q & (equal_566_s2_q & (inside_v_s2_q & and_2059)));
  logic and_2798;
  assign and_2798 = not_563_s2_q & (not_565_s2_q & (equal_566_s2_q & (inside_v_s2_q & and_2068)));
  // hls/stages/moments.hpp:94
  logic and_2800;
  assign and_2800 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2803;
  assign select_2803 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2800)) : and_2800;
  // hls/stages/agreement.hpp:788
  logic and_2807;
  assign and_2807 = equal_562_s2_q & (equal_2753 & (cfg_prove_i & (cfg_same_table_i & select_2803)));
  // hls/stages/moments.hpp:95
  logic and_2810;
  assign and_2810 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2824;
  assign difference_2824 = {1'b0, select_543} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2824[9]} + (difference_2824[8:0] ^ {9{difference_2824[9]}});
  logic [9:0] difference_2836;
  assign difference_2836 = {1'b0, select_547} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2836[9]} + (difference_2836[8:0] ^ {9{difference_2836[9]}});
  // hls/stages/agreement.hpp:788
  logic not_3024;
  assign not_3024 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3025;
  assign less_3025 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_3032;
  assign and_3032 = and_537_s2_q & (equal_667_s2_q & equal_2927_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_3038;
  assign and_3038 = not_563_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3034_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3058;
  assign and_3058 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3059;
  assign and_3059 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3060;
  assign and_3060 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3061;
  assign and_3061 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3063;
  assign sum_3063 = {1'b0, and_3060} + ({1'b0, explained} + {1'b0, and_3061});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3058} + ({2'h0, and_3059} + {1'b0, sum_3063});
  // hls/stages/agreement.hpp:788
  logic and_3099;
  assign and_3099 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3034_s2_q & and_2477)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3123;
  assign difference_3123 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3126;
  assign less_3126 = {2'h0, difference_3123[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3129;
  assign and_3129 = not_571_s2_q & (((and_2475_s2_q & and_622) & equal_3119_s2_q) & (~less_3126));
  // hls/stages/agreement.hpp:788
  logic and_3133;
  assign and_3133 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_567_s2_q & and_3129)));
  // hls/stages/agreement.hpp:149
  logic and_3138;
  assign and_3138 = not_571_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3140;
  assign and_3140 = not_571_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3141;
  assign select_3141 = or_567_s2_q ? {and_3140, and_3138} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3143;
  assign select_3143 = less_570_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3144;
  assign select_3144 = or_567_s2_q ? select_3143 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3146;
  assign and_3146 = and_624 & (select_3141[0] & select_3144[0]);
  // hls/stages/agreement.hpp:788
  logic and_3150;
  assign and_3150 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3141[1] & and_3146)));
  logic and_3151;
  assign and_3151 = not_563_s2_q & and_3150;
  logic and_3157;
  assign and_3157 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3144[1] & and_3146)));
  logic and_3158;
  assign and_3158 = not_563_s2_q & and_3157;
  // hls/stages/registration.hpp:76
  logic less_3161;
  assign less_3161 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3163;
  assign select_3163 = or_567_s2_q ? (less_570_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3165;
  assign select_3165 = or_567_s2_q ? (less_570_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3167;
  assign select_3167 = or_567_s2_q ? (less_570_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3165} - {1'b0, select_3167};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3169;
  assign select_3169 = rise_2[8] ? select_3165 : select_3167;
  logic [8:0] fall;
  assign fall = {1'b0, select_3163} - {1'b0, select_3169};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3172;
  assign not_3172 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3161 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3172};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3174;
  assign xor_3174 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3174};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3180;
  assign select_3180 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3161 ? {taken, 1'b1} : {not_3172, select_3180, not_3172};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3182;
  assign sum_3182 = {left, 1'b1} + {taken_2, less_3161};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3184;
  assign select_3184 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3186;
  assign select_3186 = equal_562_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3188;
  assign select_3188 = equal_562_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3189;
  assign equal_3189 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3193;
  assign and_3193 = and_624 & less_2164_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3195;
  assign select_3195 = or_567_s2_q ? (less_570_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3199;
  assign sum_3199 = select_3195[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3202;
  assign select_3202 = (select_3165 < select_3167) ? ({sum_3199, select_3195[0], 5'h0} - {3'h0, select_3184}) : {sum_3199, select_3195[0], select_3184};
  logic [7:0] select_3203;
  assign select_3203 = ((select_3195 == 3'h0) | (select_3195 == 3'h4)) ? {sum_3199, select_3195[0], 5'h0} : select_3202;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3203[7]}}, select_3203} - {sum_2183[9], sum_2183, sum_2179[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3206;
  assign select_3206 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3206[11:7])) ? 12'h7f : select_3206;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3227;
  assign difference_3227 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3229;
  assign and_3229 = and_3193 & ($signed(difference_3227) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3242;
  assign less_3242 = $signed(difference_3227) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3250;
  assign select_3250 = so_s2_q ? (equal_3189 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3253;
  assign select_3253 = so_s2_q ? (equal_2165 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3258;
  assign select_3258 = (sum_2075 == 2'h2) ? (registration_fresh_q & (~select_2122)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3260;
  assign select_3260 = so_s2_q ? (and_2117 ? select_3258 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3262;
  assign select_3262 = and_3032 ? 4'hf : (equal_562_s2_q ? registration_fresh_q : select_3260);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2072;
  // hls/stages/registration.hpp:258
  logic not_3283;
  assign not_3283 = ~quarter_2[1];
  logic [3:0] select_3284;
  assign select_3284 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3283, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3283};
  // hls/stages/patches.hpp:91
  logic parity_3418;
  assign parity_3418 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3419;
  assign select_3419 = equal_2927_s2_q ? {patches_chance_q[14:0], parity_3418} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_3421;
  assign not_3421 = ~and_2239;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3424;
  assign select_3424 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3424};
  // hls/stages/agreement.hpp:788
  logic and_3430;
  assign and_3430 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3434;
  assign and_3434 = not_3421 & (patches_fixed_q | ((not_563_s2_q & and_3430) & and_2211));
  // hls/stages/patches.hpp:354
  logic not_3447;
  assign not_3447 = ~select_2154[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3449;
  assign select_3449 = sample_pair_whole_s2_q ? (equal_2155 ? select_2154 : {not_3447, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3548;
  assign select_3548 = or_2247_s2_q ? {and_2393_s2_q, and_2390_s2_q, and_2374_s2_q, and_2371, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3550;
  assign select_3550 = equal_2241_s2_q ? patches_codes_at_q : (equal_2243_s2_q ? other[55:4] : select_3548);
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_2347_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:521
  logic [27:0] select_3553;
  assign select_3553 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3555;
  assign select_3555 = equal_2243_s2_q ? (new_row_s2_q ? word : select_3553) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3557;
  assign select_3557 = less_2334_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3559;
  assign select_3559 = less_3558_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3561;
  assign select_3561 = or_2247_s2_q ? (equal_2246_s2_q ? patches_next_codes_q : select_3559) : patches_next_codes_q;
  logic [55:0] select_3563;
  assign select_3563 = equal_2241_s2_q ? patches_next_codes_q : (equal_2243_s2_q ? select_3557 : select_3561);
  // hls/stages/count_bits.hpp:24
  logic parity_3568;
  assign parity_3568 = ^{and_2393_s2_q, and_2390_s2_q, and_2374_s2_q, and_2371};
  // hls/stages/count_bits.hpp:25
  logic or_3572;
  assign or_3572 = ({and_2374_s2_q, and_2371} == 2'h3) | (and_2390_s2_q & (and_2374_s2_q | and_2371));
  logic and_3573;
  assign and_3573 = and_2393_s2_q & (^{and_2390_s2_q, and_2374_s2_q, and_2371});
  // hls/stages/count_bits.hpp:24
  logic xor_3574;
  assign xor_3574 = or_3572 ^ and_3573;
  // hls/stages/count_bits.hpp:27
  logic and_3575;
  assign and_3575 = or_3572 & and_3573;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3577;
  assign select_3577 = or_2247_s2_q ? (and_2416_s2_q ? {and_3575, xor_3574, parity_3568} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3581;
  assign sum_3581 = {7'h0, patches_set_q} + (equal_2246_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:522
  logic [47:0] select_3591;
  assign select_3591 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3593;
  assign select_3593 = equal_2241_s2_q ? patches_left_row_q : (equal_2243_s2_q ? select_3591 : patches_left_row_q);
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3591;
  // hls/stages/count_bits.hpp:24
  logic xor_3597;
  assign xor_3597 = bits[17] ^ (^{select_3591[16:15], other[16:15]});
  logic xor_3600;
  assign xor_3600 = bits[11] ^ (^{select_3591[10:9], other[10:9]});
  logic xor_3603;
  assign xor_3603 = bits[14] ^ (^{select_3591[13:12], other[13:12]});
  logic xor_3606;
  assign xor_3606 = xor_3597 ^ (^{select_3591[14:9], other[14:9]});
  logic xor_3609;
  assign xor_3609 = bits[47] ^ (^{select_3591[46:45], other[46:45]});
  logic xor_3612;
  assign xor_3612 = bits[8] ^ (^{select_3591[7:6], other[7:6]});
  logic xor_3615;
  assign xor_3615 = bits[2] ^ (^{select_3591[1:0], other[1:0]});
  logic xor_3618;
  assign xor_3618 = bits[5] ^ (^{select_3591[4:3], other[4:3]});
  logic xor_3621;
  assign xor_3621 = xor_3612 ^ (^{select_3591[5:0], other[5:0]});
  logic parity_3623;
  assign parity_3623 = ^{select_3591[47:45], select_3591[8:0], other[47:45], other[8:0]};
  logic xor_3624;
  assign xor_3624 = xor_3606 ^ parity_3623;
  logic xor_3627;
  assign xor_3627 = bits[44] ^ (^{select_3591[43:42], other[43:42]});
  logic xor_3630;
  assign xor_3630 = bits[38] ^ (^{select_3591[37:36], other[37:36]});
  logic xor_3633;
  assign xor_3633 = bits[41] ^ (^{select_3591[40:39], other[40:39]});
  logic xor_3639;
  assign xor_3639 = bits[26] ^ (^{select_3591[25:24], other[25:24]});
  logic xor_3642;
  assign xor_3642 = bits[20] ^ (^{select_3591[19:18], other[19:18]});
  logic xor_3645;
  assign xor_3645 = bits[23] ^ (^{select_3591[22:21], other[22:21]});
  logic xor_3648;
  assign xor_3648 = xor_3639 ^ (^{select_3591[23:18], other[23:18]});
  logic xor_3651;
  assign xor_3651 = bits[35] ^ (^{select_3591[34:33], other[34:33]});
  logic xor_3654;
  assign xor_3654 = bits[29] ^ (^{select_3591[28:27], other[28:27]});
  logic xor_3657;
  assign xor_3657 = bits[32] ^ (^{select_3591[31:30], other[31:30]});
  logic xor_3660;
  assign xor_3660 = xor_3651 ^ (^{select_3591[32:27], other[32:27]});
  logic xor_3661;
  assign xor_3661 = xor_3648 ^ xor_3660;
  // hls/stages/count_bits.hpp:25
  logic or_3669;
  assign or_3669 = (xor_3600 & xor_3603) | (xor_3597 & (xor_3600 | xor_3603));
  logic or_3673;
  assign or_3673 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3677;
  assign or_3677 = (xor_3615 & xor_3618) | (xor_3612 & (xor_3615 | xor_3618));
  // hls/stages/count_bits.hpp:23
  logic or_3684;
  assign or_3684 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3688;
  assign or_3688 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3692;
  assign or_3692 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3695;
  assign parity_3695 = ^{or_3692, or_3688, or_3684};
  // hls/stages/count_bits.hpp:23
  logic or_3699;
  assign or_3699 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3703;
  assign or_3703 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3707;
  assign or_3707 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3710;
  assign parity_3710 = ^{or_3707, or_3703, or_3699};
  logic parity_3713;
  assign parity_3713 = ^{or_3707, or_3703, or_3699, or_3692, or_3688, or_3684, or_3677, or_3673, or_3669};
  // hls/stages/count_bits.hpp:23
  logic or_3717;
  assign or_3717 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3721;
  assign or_3721 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3725;
  assign or_3725 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3733;
  assign or_3733 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3737;
  assign or_3737 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3741;
  assign or_3741 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3744;
  assign parity_3744 = ^{or_3741, or_3737, or_3733};
  // hls/stages/count_bits.hpp:23
  logic or_3748;
  assign or_3748 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3752;
  assign or_3752 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3756;
  assign or_3756 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3759;
  assign parity_3759 = ^{or_3756, or_3752, or_3748};
  logic parity_3762;
  assign parity_3762 = ^{or_3756, or_3752, or_3748, or_3741, or_3737, or_3733, or_3725, or_3721, or_3717};
  // hls/stages/count_bits.hpp:25
  logic or_3766;
  assign or_3766 = (xor_3630 & xor_3633) | (xor_3627 & (xor_3630 | xor_3633));
  logic or_3770;
  assign or_3770 = (xor_3642 & xor_3645) | (xor_3639 & (xor_3642 | xor_3645));
  logic or_3774;
  assign or_3774 = (xor_3654 & xor_3657) | (xor_3651 & (xor_3654 | xor_3657));
  // hls/stages/count_bits.hpp:24
  logic parity_3777;
  assign parity_3777 = ^{or_3774, or_3770, or_3766};
  // hls/stages/count_bits.hpp:25
  logic and_3778;
  assign and_3778 = xor_3624 & (^{xor_3661, select_3591[44:36], other[44:36]});
  logic or_3782;
  assign or_3782 = (xor_3609 & xor_3621) | (xor_3606 & (xor_3609 | xor_3621));
  logic and_3785;
  assign and_3785 = (xor_3627 ^ (^{select_3591[41:36], other[41:36]})) & (xor_3648 | xor_3660);
  logic or_3786;
  assign or_3786 = (xor_3648 & xor_3660) | and_3785;
  // hls/stages/count_bits.hpp:24
  logic parity_3789;
  assign parity_3789 = ^{or_3786, or_3782, and_3778};
  logic parity_3792;
  assign parity_3792 = ^{or_3786, or_3782, and_3778, or_3774, or_3770, or_3766, or_3756, or_3752, or_3748, or_3741, or_3737, or_3733, or_3725, or_3721, or_3717};
  logic parity_3794;
  assign parity_3794 = ^{or_3786, or_3782, and_3778, or_3774, or_3770, or_3766, or_3756, or_3752, or_3748, or_3741, or_3737, or_3733, or_3725, or_3721, or_3717, or_3707, or_3703, or_3699, or_3692, or_3688, or_3684, or_3677, or_3673, or_3669};
  // hls/stages/count_bits.hpp:25
  logic and_3795;
  assign and_3795 = parity_3713 & parity_3792;
  logic or_3799;
  assign or_3799 = (parity_3695 & parity_3710) | ((^{or_3677, or_3673, or_3669}) & (parity_3695 | parity_3710));
  logic or_3803;
  assign or_3803 = (parity_3777 & parity_3789) | (parity_3762 & (parity_3777 | parity_3789));
  logic or_3810;
  assign or_3810 = (parity_3744 & parity_3759) | ((^{or_3725, or_3721, or_3717}) & (parity_3744 | parity_3759));
  logic or_3814;
  assign or_3814 = (or_3770 & or_3774) | (or_3766 & (or_3770 | or_3774));
  logic or_3818;
  assign or_3818 = (or_3782 & or_3786) | (and_3778 & (or_3782 | or_3786));
  // hls/stages/count_bits.hpp:23
  logic or_3825;
  assign or_3825 = (or_3721 & or_3725) | (or_3717 & (or_3721 | or_3725));
  // hls/stages/count_bits.hpp:25
  logic or_3829;
  assign or_3829 = (or_3737 & or_3741) | (or_3733 & (or_3737 | or_3741));
  logic or_3833;
  assign or_3833 = (or_3752 & or_3756) | (or_3748 & (or_3752 | or_3756));
  // hls/stages/count_bits.hpp:24
  logic parity_3836;
  assign parity_3836 = ^{or_3833, or_3829, or_3825};
  // hls/stages/count_bits.hpp:23
  logic or_3840;
  assign or_3840 = (or_3673 & or_3677) | (or_3669 & (or_3673 | or_3677));
  // hls/stages/count_bits.hpp:25
  logic or_3844;
  assign or_3844 = (or_3688 & or_3692) | (or_3684 & (or_3688 | or_3692));
  logic or_3848;
  assign or_3848 = (or_3703 & or_3707) | (or_3699 & (or_3703 | or_3707));
  // hls/stages/count_bits.hpp:24
  logic parity_3851;
  assign parity_3851 = ^{or_3848, or_3844, or_3840};
  logic parity_3854;
  assign parity_3854 = ^{or_3848, or_3844, or_3840, or_3833, or_3829, or_3825, or_3818, or_3814, or_3810};
  logic parity_3856;
  assign parity_3856 = ^{or_3848, or_3844, or_3840, or_3833, or_3829, or_3825, or_3818, or_3814, or_3810, or_3803, or_3799, and_3795};
  // hls/stages/count_bits.hpp:25
  logic or_3860;
  assign or_3860 = (or_3814 & or_3818) | (or_3810 & (or_3814 | or_3818));
  logic or_3864;
  assign or_3864 = (or_3829 & or_3833) | (or_3825 & (or_3829 | or_3833));
  logic or_3868;
  assign or_3868 = (or_3844 & or_3848) | (or_3840 & (or_3844 | or_3848));
  // hls/stages/count_bits.hpp:24
  logic parity_3871;
  assign parity_3871 = ^{or_3868, or_3864, or_3860};
  // hls/stages/count_bits.hpp:25
  logic and_3872;
  assign and_3872 = (^{or_3803, or_3799, and_3795}) & parity_3854;
  logic or_3876;
  assign or_3876 = (or_3799 & or_3803) | (and_3795 & (or_3799 | or_3803));
  logic or_3880;
  assign or_3880 = (parity_3836 & parity_3851) | ((^{or_3818, or_3814, or_3810}) & (parity_3836 | parity_3851));
  // hls/stages/count_bits.hpp:24
  logic parity_3883;
  assign parity_3883 = ^{or_3880, or_3876, and_3872};
  // hls/stages/count_bits.hpp:25
  logic and_3885;
  assign and_3885 = parity_3871 & parity_3883;
  logic or_3889;
  assign or_3889 = (or_3864 & or_3868) | (or_3860 & (or_3864 | or_3868));
  logic or_3893;
  assign or_3893 = (or_3876 & or_3880) | (and_3872 & (or_3876 | or_3880));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3938;
  assign select_3938 = equal_2243_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3941;
  assign select_3941 = equal_2241_s2_q ? patches_summed_first_q : (equal_2243_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:556
  logic [9:0] select_3948;
  assign select_3948 = less_2422_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3951;
  assign select_3951 = equal_2425_s2_q ? (less_2422_s2_q ? (equal_2425_s2_q ? 10'h0 : select_3948) : 10'h0) : select_3948;
  logic [9:0] select_3953;
  assign select_3953 = less_2422_s2_q ? (equal_2423_s2_q ? 10'h0 : select_3951) : select_3951;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3955;
  assign select_3955 = less_2422_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3958;
  assign select_3958 = equal_2425_s2_q ? (less_2422_s2_q ? (equal_2425_s2_q ? 5'h0 : select_3955) : 5'h0) : select_3955;
  logic [4:0] select_3960;
  assign select_3960 = less_2422_s2_q ? (equal_2423_s2_q ? 5'h0 : select_3958) : select_3958;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3962;
  assign select_3962 = less_2422_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3965;
  assign select_3965 = equal_2425_s2_q ? (less_2422_s2_q ? (equal_2425_s2_q ? 5'h0 : select_3962) : 5'h0) : select_3962;
  logic [4:0] select_3967;
  assign select_3967 = less_2422_s2_q ? (equal_2423_s2_q ? 5'h0 : select_3965) : select_3965;
  // hls/stages/patches.hpp:556
  logic and_3970;
  assign and_3970 = less_2422_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3973;
  assign select_3973 = equal_2425_s2_q ? (less_2422_s2_q ? (not_2426_s2_q & and_3970) : and_3970) : and_3970;
  // hls/stages/patches.hpp:184
  logic select_3976;
  assign select_3976 = equal_2241_s2_q ? (less_2422_s2_q ? (not_2424_s2_q & select_3973) : select_3973) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3987;
  assign or_3987 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3988;
  assign and_3988 = patches_read_searches_s2_q & or_3987;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3989;
  assign select_3989 = and_3988 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3989};
  // hls/stages/patches.hpp:556
  logic and_3993;
  assign and_3993 = less_2422_s2_q & (equal_3985_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:560
  logic select_3996;
  assign select_3996 = equal_2425_s2_q ? (less_2422_s2_q ? (not_2426_s2_q & and_3993) : and_3993) : and_3993;
  // hls/stages/patches.hpp:184
  logic select_3999;
  assign select_3999 = equal_2241_s2_q ? (less_2422_s2_q ? (not_2424_s2_q & select_3996) : select_3996) : patches_read_above_q;
  // hls/stages/patches.hpp:556
  logic and_4002;
  assign and_4002 = less_2422_s2_q & (equal_3985_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:560
  logic select_4005;
  assign select_4005 = equal_2425_s2_q ? (less_2422_s2_q ? (not_2426_s2_q & and_4002) : and_4002) : and_4002;
  // hls/stages/patches.hpp:184
  logic select_4008;
  assign select_4008 = equal_2241_s2_q ? (less_2422_s2_q ? (not_2424_s2_q & select_4005) : select_4005) : patches_read_below_q;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_4009;
  assign sum_4009 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:554
  logic [9:0] select_4012;
  assign select_4012 = (equal_3985_s2_q & ({sum_4009[6], sum_4009} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_4013;
  assign select_4013 = less_2422_s2_q ? select_4012 : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4015;
  assign select_4015 = less_2422_s2_q ? (equal_2425_s2_q ? 10'h3ff : select_4013) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_4016;
  assign select_4016 = equal_2425_s2_q ? select_4015 : select_4013;
  logic [9:0] select_4018;
  assign select_4018 = less_2422_s2_q ? (equal_2423_s2_q ? 10'h3ff : select_4016) : select_4016;
  // hls/stages/patches.hpp:539
  logic [14:0] select_4020;
  assign select_4020 = and_3988 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_4021;
  assign select_4021 = equal_2241_s2_q ? select_4020[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4022;
  assign select_4022 = equal_2241_s2_q ? select_4020[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:541
  logic [9:0] select_4024;
  assign select_4024 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_4026;
  assign select_4026 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_4029;
  assign select_4029 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_4030;
  assign select_4030 = patches_read_first_q ? patches_read_far_q : select_4029;
  // hls/stages/patches.hpp:594
  logic [9:0] difference_4033;
  assign difference_4033 = select_4030 - select_4020[9:0];
  // hls/stages/patches.hpp:579
  logic less_4063;
  assign less_4063 = select_4024 < select_4026;
  // hls/stages/patches.hpp:585
  logic [1:0] sum_4064;
  assign sum_4064 = select_3989[4:3] + 2'h3;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_4063 ? select_4026 : select_4024;
  logic [9:0] low;
  assign low = (select_4026 < select_4024) ? select_4026 : select_4024;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_4020[9:0];
  // hls/stages/patches.hpp:583
  logic not_4071;
  assign not_4071 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4072;
  assign sum_4072 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4074;
  assign not_4074 = ~({eight, 3'h0} < {1'b0, sum_4072, fall_2[0]});
  logic [1:0] sum_4075;
  assign sum_4075 = {1'b0, not_4071} + {1'b0, not_4074};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_4076;
  assign sum_4076 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4078;
  assign not_4078 = ~({eight, 3'h0} < {sum_4076, fall_2[1:0]});
  logic not_4081;
  assign not_4081 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4082;
  assign sum_4082 = {1'b0, not_4078} + {1'b0, not_4081};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4075} + {1'b0, sum_4082};
  // hls/stages/patches.hpp:586
  logic [7:0] select_4085;
  assign select_4085 = less_4063 ? ({sum_4064, select_3989[2:0], 3'h0} - {5'h0, fraction}) : {sum_4064, select_3989[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_4308;
  assign select_4308 = equal_562_s2_q ? shown_shown_q : (so_s2_q ? select_2487 : shown_shown_q);
  logic select_4310;
  assign select_4310 = equal_562_s2_q ? shown_nearer_q : (so_s2_q ? select_2490 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4312;
  assign sum_4312 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4314;
  assign select_4314 = less_4311_s2_q ? (sum_4312[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4316;
  assign select_4316 = equal_2927_s2_q ? (equal_667_s2_q ? 3'h0 : select_4314) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4321;
  assign select_4321 = equal_562_s2_q ? select_2441 : (so_s2_q ? (ends_cell_s2_q ? select_2539 : select_2441) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4335;
  assign select_4335 = equal_667_s2_q ? {{2{difference_4333[6]}}, difference_4333} : (less_4311_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4337;
  assign select_4337 = and_537_s2_q ? (equal_2927_s2_q ? select_4335 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4339;
  assign select_4339 = equal_667_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4341;
  assign select_4341 = and_537_s2_q ? (equal_2927_s2_q ? select_4339 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4342;
  assign sum_4342 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4343;
  assign select_4343 = sum_4312[7] ? {1'b1, sum_4312[6:0], region_down_rest_q[0]} : sum_4342;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4312[7];
  // hls/stages/agreement.hpp:460
  logic select_4347;
  assign select_4347 = equal_2927_s2_q ? (equal_667_s2_q | (less_4311_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4352;
  assign or_4352 = segment_starts_q | not_565_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4355;
  assign select_4355 = inside_v_s2_q ? (sum_2454_s2_q ? (equal_2234 & or_2456) : or_2456) : or_4352;
  // hls/stages/agreement.hpp:788
  logic select_4358;
  assign select_4358 = equal_562_s2_q ? or_4352 : (so_s2_q ? (ends_cell_s2_q ? select_4355 : or_4352) : or_4352);
  // hls/stages/agreement.hpp:1147
  logic equal_4382;
  assign equal_4382 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4518;
  assign select_4518 = so_s2_q ? (ends_cell_s2_q ? and_2527 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4521;
  assign select_4521 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4523;
  assign select_4523 = equal_562_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4521 : centres_values_0_of_skin_q);
  logic select_4524;
  assign select_4524 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4526;
  assign select_4526 = equal_562_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4524 : centres_values_1_textured_q);
  logic select_4527;
  assign select_4527 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4529;
  assign select_4529 = equal_562_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4527 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4533;
  assign select_4533 = equal_2927_s2_q ? (equal_4530_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4536;
  assign select_4536 = and_537_s2_q ? (equal_2927_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4547;
  assign select_4547 = select_2499 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4553;
  assign select_4553 = marks_first_s2_q ? (less_4549 ? {sum_4550, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4623;
  assign not_4623 = ~quarter[1];
  logic [3:0] select_4624;
  assign select_4624 = quarter[0] ? {quarter[1], 1'b0, not_4623, 1'b0} : {1'b0, quarter[1], 1'b0, not_4623};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2076;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2119;
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
  assign regions_raddr = select_2451;
  logic regions_re;
  assign regions_re = s2_en & (equal_562_s2_q ? (x_s2_q[6] & not_2452) : and_2459);
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
  assign map_raddr = {sum_2511, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2518 & less_2519);
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
  assign averager_memory_we = s2_en & and_512_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_531, and_527, sum_523, sum_519};
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
  assign census_memory_we = s2_en & and_537_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_555, whole_2, select_547, select_543};
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
  assign moments_memory_waddr = select_561_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_579_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_634_s2_q, and_632_s2_q, and_627_s2_q, and_625};
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
  assign best_left_we = s2_en & and_2023_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2022, select_2019, select_2016, select_2014, select_1987, select_1984, select_1976, select_1975, select_1971};
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
  assign best_right_we = s2_en & and_2023_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2033, select_2032, select_2029, select_2028};
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
  assign shown_right_waddr = select_2040_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2051;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2048, not_565_s2_q};
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
  assign left_turns_wdata = {and_2059, and_2056};
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
  assign right_turns_wdata = {and_2068, and_2065};
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
  assign patches_right_codes_waddr = {sum_2355, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2407_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2393_s2_q, and_2390_s2_q, and_2374_s2_q, and_2371, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2411, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2421_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2393_s2_q, and_2390_s2_q, and_2374_s2_q, and_2371, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2036_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2486, textured};
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
      averager_running_of_skin_q <= select_2651;
      averager_mask_q <= select_2653;
      averager_of_skin_q <= select_2655;
      census_filled_q <= and_537_s2_q ? {select_670[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2750;
      moments_turned_1_q <= sum_2752;
      moments_before_0_q <= equal_562_s2_q ? select_2754 : moments_before_0_q;
      moments_before_1_q <= equal_562_s2_q ? select_2756 : moments_before_1_q;
      moments_has_before_q <= select_2759;
      moments_most_before_q <= select_2762;
      moments_left_begins_q <= select_2766;
      moments_left_alone_q <= select_2770;
      moments_left_other_stops_q <= select_2773;
      moments_right_begins_q <= select_2776;
      moments_right_alone_q <= select_2780;
      moments_right_other_stops_q <= select_2783;
      moments_out_of_step_q <= or_2786;
      moments_turns_0_q <= and_2794;
      moments_turns_1_q <= and_2798;
      moments_begins_alone_q <= and_2807;
      moments_ends_q <= equal_562_s2_q & (equal_2753 & (not_2808 | and_2810));
      rows_passed_above_q <= and_537_s2_q ? select_669 : rows_passed_above_q;
      shift_allowed_q <= not_3024 & (~less_3025);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3032 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3151});
      counts_turned_right_q <= and_3032 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3158});
      registration_displacement_over_q <= so_s2_q ? sum_3182[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3184;
      registration_slope_here_q <= select_3186;
      registration_expected_q <= select_3188;
      registration_of_right_q <= equal_562_s2_q ? registration_of_right_q : select_3250;
      registration_was_inside_q <= equal_562_s2_q ? registration_was_inside_q : select_3253;
      registration_fresh_q <= select_3262;
      patches_chance_q <= and_537_s2_q ? select_3419 : patches_chance_q;
      patches_fixed_q <= and_3434;
      patches_choice_valid_q <= and_2239 ? (select_2212 & not_3421) : select_2212;
      patches_choice_column_q <= select_2217;
      patches_choice_shift_q <= select_2222;
      patches_choice_slope_q <= select_2233;
      patches_band_q <= sample_pair_whole_s2_q ? select_2254 : patches_band_q;
      patches_fetch_q <= select_3449;
      patches_codes_at_q <= select_3550;
      patches_codes_further_q <= equal_2241_s2_q ? patches_codes_further_q : select_3555;
      patches_next_codes_q <= select_3563;
      patches_set_q <= equal_2241_s2_q ? 3'h0 : (equal_2243_s2_q ? 3'h0 : select_3577);
      patches_size_q <= sum_3581;
      patches_left_row_q <= select_3593;
      patches_summed_row_column_q <= equal_2241_s2_q ? patches_summed_row_column_q : select_3938;
      patches_summed_first_q <= select_3941;
      patches_read_row_differing_q <= equal_2241_s2_q ? select_3953 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2241_s2_q ? select_3960 : patches_read_row_column_q;
      patches_read_at_q <= equal_2241_s2_q ? select_3967 : patches_read_at_q;
      patches_read_first_q <= select_3976;
      patches_read_above_q <= select_3999;
      patches_read_below_q <= select_4008;
      patches_read_far_q <= equal_2241_s2_q ? select_4018 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4021;
      patches_peak_best_column_q <= select_4022;
      patches_peak_row_q <= equal_2241_s2_q ? select_3989 : patches_peak_row_q;
      patches_peak_above_q <= equal_2241_s2_q ? select_4024 : patches_peak_above_q;
      patches_peak_below_q <= equal_2241_s2_q ? select_4026 : patches_peak_below_q;
      patches_peak_far_q <= equal_2241_s2_q ? select_4030 : patches_peak_far_q;
      patches_frame_ended_q <= equal_562_s2_q & equal_2753;
      shown_shown_q <= select_4308;
      shown_nearer_q <= select_4310;
      region_row_q <= and_537_s2_q ? select_4316 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4321;
      region_down_rest_q <= select_4337;
      region_down_back_q <= select_4341;
      region_down_next_q <= select_4343;
      region_fresh_q <= and_537_s2_q ? select_4347 : region_fresh_q;
      segment_starts_q <= select_4358;
      centres_values_0_textured_q <= equal_562_s2_q ? centres_values_0_textured_q : select_4518;
      centres_values_0_of_skin_q <= select_4523;
      centres_values_1_textured_q <= select_4526;
      centres_values_1_of_skin_q <= select_4529;
      map_row_q <= and_537_s2_q ? select_4533 : map_row_q;
      map_width_q <= select_4536;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2510;
      done_q <= not_2512 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_562_s2_q & equal_4382;
      rows_passed_q <= select_2495;
      columns_passed_q <= {select_2497[7:0], or_2493};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2514;
      seen_x_q <= select_2516;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4547;
      seen_column_q <= select_2507;
      seen_rows_left_q <= select_4553;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2504;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_515 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_521 : averager_running_1_q;
      averager_total_0_q <= select_2630;
      averager_total_1_q <= select_2632;
      census_columns_values_0_cell_0_left_q <= select_2656;
      census_columns_values_0_cell_0_right_q <= select_2657;
      census_columns_values_0_cell_0_mask_q <= and_537_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2659;
      census_columns_values_0_cell_1_right_q <= select_2660;
      census_columns_values_0_cell_1_mask_q <= select_2661;
      census_columns_values_0_cell_2_left_q <= select_2662;
      census_columns_values_0_cell_2_right_q <= select_2663;
      census_columns_values_0_cell_2_mask_q <= select_2664;
      census_columns_values_0_cell_2_of_skin_q <= select_2665;
      census_columns_values_0_cell_3_left_q <= select_2666;
      census_columns_values_0_cell_3_right_q <= select_2667;
      census_columns_values_0_cell_3_mask_q <= select_2668;
      census_columns_values_0_cell_4_left_q <= select_2669;
      census_columns_values_0_cell_4_right_q <= select_2670;
      census_columns_values_0_cell_4_mask_q <= select_2671;
      census_columns_values_1_cell_0_left_q <= select_2672;
      census_columns_values_1_cell_0_right_q <= select_2673;
      census_columns_values_1_cell_0_mask_q <= select_2674;
      census_columns_values_1_cell_1_left_q <= select_2675;
      census_columns_values_1_cell_1_right_q <= select_2676;
      census_columns_values_1_cell_1_mask_q <= select_2677;
      census_columns_values_1_cell_2_left_q <= select_2678;
      census_columns_values_1_cell_2_right_q <= select_2679;
      census_columns_values_1_cell_2_mask_q <= select_2680;
      census_columns_values_1_cell_2_of_skin_q <= select_2681;
      census_columns_values_1_cell_3_left_q <= select_2682;
      census_columns_values_1_cell_3_right_q <= select_2683;
      census_columns_values_1_cell_3_mask_q <= select_2684;
      census_columns_values_1_cell_4_left_q <= select_2685;
      census_columns_values_1_cell_4_right_q <= select_2686;
      census_columns_values_1_cell_4_mask_q <= select_2687;
      census_columns_values_2_cell_0_left_q <= select_2688;
      census_columns_values_2_cell_0_right_q <= select_2689;
      census_columns_values_2_cell_0_mask_q <= select_2690;
      census_columns_values_2_cell_1_left_q <= select_2691;
      census_columns_values_2_cell_1_right_q <= select_2692;
      census_columns_values_2_cell_1_mask_q <= select_2693;
      census_columns_values_2_cell_2_left_q <= select_2694;
      census_columns_values_2_cell_2_right_q <= select_2695;
      census_columns_values_2_cell_2_mask_q <= select_2696;
      census_columns_values_2_cell_3_left_q <= select_2697;
      census_columns_values_2_cell_3_right_q <= select_2698;
      census_columns_values_2_cell_3_mask_q <= select_2699;
      census_columns_values_2_cell_4_left_q <= select_2700;
      census_columns_values_2_cell_4_right_q <= select_2701;
      census_columns_values_2_cell_4_mask_q <= select_2702;
      census_columns_values_3_cell_0_mask_q <= select_2703;
      census_columns_values_3_cell_1_left_q <= select_2704;
      census_columns_values_3_cell_1_right_q <= select_2705;
      census_columns_values_3_cell_1_mask_q <= select_2706;
      census_columns_values_3_cell_2_mask_q <= select_2707;
      census_columns_values_3_cell_3_left_q <= select_2708;
      census_columns_values_3_cell_3_right_q <= select_2709;
      census_columns_values_3_cell_3_mask_q <= select_2710;
      census_columns_values_3_cell_4_mask_q <= select_2711;
      sharpness_last_mean_0_q <= and_537_s2_q ? select_543 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_537_s2_q ? select_547 : sharpness_last_mean_1_q;
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
  logic [6:0] select_503_s3_q;
  logic [6:0] last_s3_q;
  logic and_535_s3_q;
  logic and_537_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_540_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_557_s3_q;
  logic equal_562_s3_q;
  logic not_563_s3_q;
  logic less_640_s3_q;
  logic less_641_s3_q;
  logic less_642_s3_q;
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
  logic and_671_s3_q;
  logic and_696_s3_q;
  logic and_697_s3_q;
  logic [11:0] sum_712_s3_q;
  logic [9:0] sum_715_s3_q;
  logic and_723_s3_q;
  logic and_727_s3_q;
  logic less_728_s3_q;
  logic less_732_s3_q;
  logic less_734_s3_q;
  logic equal_2069_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2075_s3_q;
  logic equal_2077_s3_q;
  logic equal_2079_s3_q;
  logic equal_2081_s3_q;
  logic equal_2083_s3_q;
  logic equal_2085_s3_q;
  logic equal_2087_s3_q;
  logic equal_2089_s3_q;
  logic equal_2091_s3_q;
  logic less_2100_s3_q;
  logic or_2104_s3_q;
  logic equal_2124_s3_q;
  logic and_2134_s3_q;
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
  logic [3:0] select_2318_s3_q;
  logic less_2422_s3_q;
  logic equal_2423_s3_q;
  logic not_2424_s3_q;
  logic equal_2425_s3_q;
  logic or_2444_s3_q;
  logic or_2447_s3_q;
  logic or_2450_s3_q;
  logic not_2452_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2479_s3_q;
  logic and_2484_s3_q;
  logic and_2518_s3_q;
  logic less_2519_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2524_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2542_s3_q;
  logic or_2545_s3_q;
  logic or_2548_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2598_s3_q;
  logic [11:0] sum_2727_s3_q;
  logic [9:0] sum_2730_s3_q;
  logic equal_2738_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3032_s3_q;
  logic and_3038_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3100_s3_q;
  logic and_3134_s3_q;
  logic and_3192_s3_q;
  logic and_3193_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3229_s3_q;
  logic and_3243_s3_q;
  logic equal_3286_s3_q;
  logic parity_3665_s3_q;
  logic parity_3794_s3_q;
  logic parity_3856_s3_q;
  logic xor_3884_s3_q;
  logic parity_3896_s3_q;
  logic or_3900_s3_q;
  logic equal_3901_s3_q;
  logic [4:0] select_4020_s3_q;
  logic equal_4032_s3_q;
  logic less_4034_s3_q;
  logic less_4035_s3_q;
  logic or_4040_s3_q;
  logic [7:0] select_4085_s3_q;
  logic equal_4382_s3_q;
  logic and_4559_s3_q;
  logic not_4573_s3_q;
  logic equal_4626_s3_q;
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
      select_503_s3_q <= select_503_s2_q;
      last_s3_q <= last_s2_2_q;
      and_535_s3_q <= and_535_s2_q;
      and_537_s3_q <= and_537_s2_q;
      grey_s3_q <= grey;
      equal_540_s3_q <= equal_540;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_557_s3_q <= equal_557_s2_q;
      equal_562_s3_q <= equal_562_s2_q;
      not_563_s3_q <= not_563_s2_q;
      less_640_s3_q <= less_640;
      less_641_s3_q <= less_641;
      less_642_s3_q <= less_642;
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
      and_671_s3_q <= and_671;
      and_696_s3_q <= whole_22 & and_671;
      and_697_s3_q <= census_columns_values_1_cell_2_mask_q & and_671;
      sum_712_s3_q <= {1'b0, sum_708} + {2'h0, sum_711};
      sum_715_s3_q <= {9'h0, difference_713[9]} + {1'b0, xor_714};
      and_723_s3_q <= and_723;
      and_727_s3_q <= and_727;
      less_728_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_732_s3_q <= {{5{sum_731[6]}}, sum_731, half_grey_levels_2[3:0]} < 16'hffe1;
      less_734_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2069_s3_q <= equal_2069;
      all_s3_q <= all;
      sum_2075_s3_q <= sum_2075;
      equal_2077_s3_q <= equal_2077;
      equal_2079_s3_q <= equal_2079;
      equal_2081_s3_q <= equal_2081;
      equal_2083_s3_q <= equal_2083;
      equal_2085_s3_q <= equal_2085;
      equal_2087_s3_q <= equal_2087;
      equal_2089_s3_q <= equal_2089;
      equal_2091_s3_q <= equal_2091;
      less_2100_s3_q <= less_2100;
      or_2104_s3_q <= or_2104;
      equal_2124_s3_q <= (registration_fresh_q & select_2122) == 4'h0;
      and_2134_s3_q <= not_563_s2_q & and_2118;
      and_2137_s3_q <= and_2137_s2_q;
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
      select_2318_s3_q <= select_2318_s2_q;
      less_2422_s3_q <= less_2422_s2_q;
      equal_2423_s3_q <= equal_2423_s2_q;
      not_2424_s3_q <= not_2424_s2_q;
      equal_2425_s3_q <= equal_2425_s2_q;
      or_2444_s3_q <= or_2444;
      or_2447_s3_q <= or_2447;
      or_2450_s3_q <= or_2450;
      not_2452_s3_q <= not_2452;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2479_s3_q <= inside_v_s2_q & (and_2477 & and_2047);
      and_2484_s3_q <= not_563_s2_q & and_2459;
      and_2518_s3_q <= and_2518;
      less_2519_s3_q <= less_2519;
      index_2_s3_q <= index_2[5:0];
      sum_2524_s3_q <= sum_2524;
      textured_2_s3_q <= textured_2;
      or_2542_s3_q <= or_2542;
      or_2545_s3_q <= select_2539[7] | (~({select_2539[6], select_2539[3:2]} == 3'h0));
      or_2548_s3_q <= select_2539[7] | (~(select_2539[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2598_s3_q <= and_2598;
      sum_2727_s3_q <= {1'b0, sum_2723} + {2'h0, sum_2726};
      sum_2730_s3_q <= {9'h0, difference_2728[9]} + {1'b0, xor_2729};
      equal_2738_s3_q <= equal_2738_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3032_s3_q <= and_3032;
      and_3038_s3_q <= and_3038;
      explained_2_s3_q <= explained_2;
      and_3100_s3_q <= not_563_s2_q & and_3099;
      and_3134_s3_q <= not_563_s2_q & and_3133;
      and_3192_s3_q <= not_563_s2_q & (so_s2_q & (half_ends & equal_3189));
      and_3193_s3_q <= and_3193;
      residual_s3_q <= residual[7:0];
      and_3229_s3_q <= and_3229;
      and_3243_s3_q <= and_3193 & less_3242;
      equal_3286_s3_q <= (registration_fresh_q & select_3284) == 4'h0;
      parity_3665_s3_q <= ^{xor_3661, xor_3624, select_3591[44:36], other[44:36]};
      parity_3794_s3_q <= parity_3794;
      parity_3856_s3_q <= parity_3856;
      xor_3884_s3_q <= parity_3871 ^ parity_3883;
      parity_3896_s3_q <= ^{or_3893, or_3889, and_3885};
      or_3900_s3_q <= (or_3889 & or_3893) | (and_3885 & (or_3889 | or_3893));
      equal_3901_s3_q <= equal_3901_s2_q;
      select_4020_s3_q <= select_4020[14:10];
      equal_4032_s3_q <= select_3989[3:0] == 4'h0;
      less_4034_s3_q <= {difference_4033, 3'h0} < {3'h0, sum_3581};
      less_4035_s3_q <= select_4030 < select_4020[9:0];
      or_4040_s3_q <= (sum_3581 < 10'h39) | ({1'b0, sum_3581[9:1]} < select_4020[9:0]);
      select_4085_s3_q <= select_4085;
      equal_4382_s3_q <= equal_4382;
      and_4559_s3_q <= and_2598 & ({sum_2524, index_2[5:0]} == {sum_2511, index[5:0]});
      not_4573_s3_q <= ~proven_q;
      equal_4626_s3_q <= (registration_fresh_q & select_4624) == 4'h0;
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
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_712_s3_q + {2'h0, sum_715_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_717;
  assign sum_717 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_719;
  assign sum_719 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_717});
  // hls/stages/census.hpp:305
  logic less_720;
  assign less_720 = 9'h4 < sum_719[13:5];
  logic and_721;
  assign and_721 = and_671_s3_q & less_720;
  // hls/stages/moments.hpp:30
  logic and_733;
  assign and_733 = (and_696_s3_q & and_723_s3_q) & less_732_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2126;
  assign equal_2126 = sum_2075_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2075_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2128;
  assign select_2128 = equal_2126 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2129;
  assign sum_2129 = (equal_2124_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2128[13]}}, select_2128};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2075_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2132;
  assign select_2132 = equal_2126 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2133;
  assign sum_2133 = (equal_2124_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2132[6]}}, select_2132};
  // hls/stages/patches.hpp:353
  logic [22:0] select_2257;
  assign select_2257 = and_2256_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2212_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2259;
  assign select_2259 = equal_2155_s3_q ? patches_place_0_valid_q : (select_2154_s3_q ? patches_place_0_valid_q : select_2257[0]);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2260;
  assign select_2260 = select_2154_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2257[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2261;
  assign select_2261 = equal_2155_s3_q ? patches_place_0_column_q : select_2260[7:0];
  logic [5:0] select_2262;
  assign select_2262 = equal_2155_s3_q ? patches_place_0_shift_q : select_2260[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2263;
  assign sum_2263 = select_2261 + {{2{select_2262[5]}}, select_2262};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2264;
  assign sum_2264 = sum_2263[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2265;
  assign equal_2265 = {sum_2264[6], select_503_s3_q, select_501_s3_q} == {1'b0, sum_2264[5:0], sum_2263[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2267;
  assign or_2267 = and_2137_s3_q | (select_2259 & equal_2265);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2268;
  assign select_2268 = or_2267 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2278;
  assign select_2278 = or_2267 ? {and_2137_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2280;
  assign and_2280 = select_2277_s3_q & (~select_2278[5]);
  // hls/stages/patches.hpp:127
  logic select_2288;
  assign select_2288 = equal_2155_s3_q ? patches_place_1_valid_q : (select_2154_s3_q ? select_2257[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2289;
  assign select_2289 = select_2154_s3_q ? select_2257[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2290;
  assign select_2290 = equal_2155_s3_q ? patches_place_1_column_q : select_2289[7:0];
  logic [5:0] select_2291;
  assign select_2291 = equal_2155_s3_q ? patches_place_1_shift_q : select_2289[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2292;
  assign sum_2292 = select_2290 + {{2{select_2291[5]}}, select_2291};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2293;
  assign sum_2293 = sum_2292[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2294;
  assign equal_2294 = {sum_2293[6], select_503_s3_q, select_501_s3_q} == {1'b0, sum_2293[5:0], sum_2292[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2296;
  assign or_2296 = and_2137_s3_q | (select_2288 & equal_2294);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2297;
  assign select_2297 = or_2296 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2298;
  assign select_2298 = or_2296 ? {and_2137_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2300;
  assign and_2300 = select_2277_s3_q & (~select_2298[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2307;
  assign sum_2307 = select_2261 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2308;
  assign equal_2308 = {sum_2307[7], select_503_s3_q, select_501_s3_q} == {1'b0, sum_2307[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2310;
  assign or_2310 = and_2137_s3_q | (select_2259 & equal_2308);
  logic [4:0] select_2311;
  assign select_2311 = or_2310 ? {and_2137_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2312;
  assign sum_2312 = select_2290 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2313;
  assign equal_2313 = {sum_2312[7], select_503_s3_q, select_501_s3_q} == {1'b0, sum_2312[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2316;
  assign select_2316 = (and_2137_s3_q | (select_2288 & equal_2313)) ? {and_2137_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_6;
  assign column_6 = select_2311[4] ? select_2316[3:0] : select_2311[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2319;
  assign select_2319 = or_2310 ? and_2137_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2325;
  assign and_2325 = (select_2277_s3_q & (select_2271_s3_q[3] ^ select_2271_s3_q[4])) & ((~select_2311[4]) | (~select_2316[4]));
  // hls/stages/patches.hpp:184
  logic less_2434;
  assign less_2434 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2435;
  assign not_2435 = ~less_2434;
  logic [1:0] select_2436;
  assign select_2436 = patches_summed_first_s3_q ? 2'h2 : {less_2434, not_2435};
  logic [12:0] select_2438;
  assign select_2438 = select_2436[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2439;
  assign select_2439 = select_2436[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2440;
  assign select_2440 = (select_2436 == 2'h2) ? {select_2438[12:8], patches_sums_values_0_q[9:8], select_2438[7:0]} : select_2439;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2465;
  assign select_2465 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2466;
  assign sum_2466 = {6'h0, textured_s3_q} + select_2465;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2468;
  assign sum_2468 = {3'h0, sum_2466} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2470;
  assign select_2470 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2471;
  assign sum_2471 = {6'h0, explained_s3_q} + select_2470;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2473;
  assign sum_2473 = {3'h0, sum_2471} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2480;
  assign select_2480 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2481;
  assign sum_2481 = {6'h0, and_2479_s3_q} + select_2480;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2483;
  assign sum_2483 = {3'h0, sum_2481} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2533;
  assign select_2533 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2534;
  assign difference_2534 = {1'b0, textured_2_s3_q} - {1'b0, select_2533};
  logic [4:0] t;
  assign t = {difference_2534[3], difference_2534} + (equal_557_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2537;
  assign equal_2537 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2549;
  assign not_2549 = ~region_row_s3_q[2];
  logic [2:0] select_2550;
  assign select_2550 = region_row_s3_q[1] ? {1'b0, not_2549, 1'b0} : {region_row_s3_q[2], 1'b0, not_2549};
  logic [5:0] select_2551;
  assign select_2551 = region_row_s3_q[0] ? {select_2550[2], 1'b0, select_2550[1], 1'b0, select_2550[0], 1'b0} : {1'b0, select_2550[2], 1'b0, select_2550[1], 1'b0, select_2550[0]};
  logic [11:0] select_2552;
  assign select_2552 = or_2548_s3_q ? {select_2551[5], 1'b0, select_2551[4], 1'b0, select_2551[3], 1'b0, select_2551[2], 1'b0, select_2551[1], 1'b0, select_2551[0], 1'b0} : {1'b0, select_2551[5], 1'b0, select_2551[4], 1'b0, select_2551[3], 1'b0, select_2551[2], 1'b0, select_2551[1], 1'b0, select_2551[0]};
  logic [23:0] select_2553;
  assign select_2553 = or_2545_s3_q ? {select_2552[11], 1'b0, select_2552[10], 1'b0, select_2552[9], 1'b0, select_2552[8], 1'b0, select_2552[7], 1'b0, select_2552[6], 1'b0, select_2552[5], 1'b0, select_2552[4], 1'b0, select_2552[3], 1'b0, select_2552[2], 1'b0, select_2552[1], 1'b0, select_2552[0], 1'b0} : {1'b0, select_2552[11], 1'b0, select_2552[10], 1'b0, select_2552[9], 1'b0, select_2552[8], 1'b0, select_2552[7], 1'b0, select_2552[6], 1'b0, select_2552[5], 1'b0, select_2552[4], 1'b0, select_2552[3], 1'b0, select_2552[2], 1'b0, select_2552[1], 1'b0, select_2552[0]};
  logic [47:0] select_2554;
  assign select_2554 = or_2542_s3_q ? {select_2553[23], 1'b0, select_2553[22], 1'b0, select_2553[21], 1'b0, select_2553[20], 1'b0, select_2553[19], 1'b0, select_2553[18], 1'b0, select_2553[17], 1'b0, select_2553[16], 1'b0, select_2553[15], 1'b0, select_2553[14], 1'b0, select_2553[13], 1'b0, select_2553[12], 1'b0, select_2553[11], 1'b0, select_2553[10], 1'b0, select_2553[9], 1'b0, select_2553[8], 1'b0, select_2553[7], 1'b0, select_2553[6], 1'b0, select_2553[5], 1'b0, select_2553[4], 1'b0, select_2553[3], 1'b0, select_2553[2], 1'b0, select_2553[1], 1'b0, select_2553[0], 1'b0} : {1'b0, select_2553[23], 1'b0, select_2553[22], 1'b0, select_2553[21], 1'b0, select_2553[20], 1'b0, select_2553[19], 1'b0, select_2553[18], 1'b0, select_2553[17], 1'b0, select_2553[16], 1'b0, select_2553[15], 1'b0, select_2553[14], 1'b0, select_2553[13], 1'b0, select_2553[12], 1'b0, select_2553[11], 1'b0, select_2553[10], 1'b0, select_2553[9], 1'b0, select_2553[8], 1'b0, select_2553[7], 1'b0, select_2553[6], 1'b0, select_2553[5], 1'b0, select_2553[4], 1'b0, select_2553[3], 1'b0, select_2553[2], 1'b0, select_2553[1], 1'b0, select_2553[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2558;
  assign and_2558 = good_known_q & (~((good_q & select_2554) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2567;
  assign select_2567 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2568;
  assign difference_2568 = {1'b0, shown_2_s3_q} - {1'b0, select_2567};
  logic [4:0] around;
  assign around = {difference_2568[3], difference_2568} + (equal_557_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2571;
  assign sum_2571 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2537 ? and_2558 : (~({sum_2571, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2583;
  assign select_2583 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2584;
  assign difference_2584 = {1'b0, near_2_s3_q} - {1'b0, select_2583};
  logic [4:0] n;
  assign n = {difference_2584[3], difference_2584} + (equal_557_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2588;
  assign and_2588 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2622;
  assign select_2622 = sample_pair_whole_s3_q ? (and_535_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2624;
  assign select_2624 = sample_pair_whole_s3_q ? (and_535_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2626;
  assign select_2626 = sample_pair_whole_s3_q ? (and_535_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2628;
  assign select_2628 = sample_pair_whole_s3_q ? (and_535_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2633;
  assign sum_2633 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2634;
  assign difference_2634 = {1'b0, sum_2633[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2635;
  assign xor_2635 = {difference_2634[8:0], sum_2633[0]} ^ {10{difference_2634[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2634[9]} + {1'b0, xor_2635};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_540_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2640;
  assign select_2640 = sample_pair_whole_s3_q ? (and_535_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2641;
  assign sum_2641 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2642;
  assign difference_2642 = {1'b0, sum_2641[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2643;
  assign xor_2643 = {difference_2642[8:0], sum_2641[0]} ^ {10{difference_2642[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2642[9]} + {1'b0, xor_2643};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_540_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2648;
  assign select_2648 = sample_pair_whole_s3_q ? (and_535_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2731;
  assign sum_2731 = sum_2727_s3_q + {2'h0, sum_2730_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2733;
  assign select_2733 = and_537_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2734;
  assign select_2734 = and_537_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2735;
  assign select_2735 = and_537_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2736;
  assign select_2736 = and_537_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2739;
  assign sum_2739 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2731};
  logic [13:0] sum_2741;
  assign sum_2741 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2739});
  // hls/stages/census.hpp:311
  logic and_2743;
  assign and_2743 = and_696_s3_q & (9'h4 < sum_2741[13:5]);
  // hls/stages/census.hpp:312
  logic and_2744;
  assign and_2744 = and_696_s3_q & less_720;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2745;
  assign sum_2745 = census_left_misses_q + {{17{and_2744}}, and_2743, 1'b0, and_2743};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2747;
  assign select_2747 = and_537_s3_q ? (equal_2738_s3_q ? 20'h0 : sum_2745) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2817;
  assign select_2817 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2820;
  assign select_2820 = and_537_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2823;
  assign and_2823 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2829;
  assign and_2829 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2830;
  assign and_2830 = and_2823 & and_2829;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2817[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2832;
  assign select_2832 = and_2830 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2834;
  assign select_2834 = equal_2738_s3_q ? {11'h0, select_2832} : (sharpness_sums_detail_0_q + {11'h0, select_2832});
  // hls/stages/agreement.hpp:457
  logic and_2841;
  assign and_2841 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2842;
  assign and_2842 = and_2823 & and_2841;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2817[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2844;
  assign select_2844 = and_2842 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2846;
  assign select_2846 = equal_2738_s3_q ? {11'h0, select_2844} : (sharpness_sums_detail_1_q + {11'h0, select_2844});
  logic [8:0] select_2849;
  assign select_2849 = and_2830 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2850;
  assign sum_2850 = (equal_2738_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2849};
  logic [8:0] select_2853;
  assign select_2853 = and_2842 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2854;
  assign sum_2854 = (equal_2738_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2853};
  // hls/stages/agreement.hpp:211
  logic equal_2856;
  assign equal_2856 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2857;
  assign less_2857 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2858;
  assign less_2858 = x_s3_q[4:0] < 5'h3;
  logic not_2859;
  assign not_2859 = ~x_s3_q[1];
  logic [2:0] select_2860;
  assign select_2860 = x_s3_q[0] ? {1'b0, not_2859, 1'b0} : {x_s3_q[1], 1'b0, not_2859};
  logic [5:0] select_2861;
  assign select_2861 = slot_s3_q[2] ? {select_2860[2], 1'b0, select_2860[1], 1'b0, select_2860[0], 1'b0} : {1'b0, select_2860[2], 1'b0, select_2860[1], 1'b0, select_2860[0]};
  logic [11:0] select_2862;
  assign select_2862 = slot_s3_q[1] ? {select_2861[5], 1'b0, select_2861[4], 1'b0, select_2861[3], 1'b0, select_2861[2], 1'b0, select_2861[1], 1'b0, select_2861[0], 1'b0} : {1'b0, select_2861[5], 1'b0, select_2861[4], 1'b0, select_2861[3], 1'b0, select_2861[2], 1'b0, select_2861[1], 1'b0, select_2861[0]};
  logic [23:0] select_2863;
  assign select_2863 = slot_s3_q[0] ? {select_2862[11], 1'b0, select_2862[10], 1'b0, select_2862[9], 1'b0, select_2862[8], 1'b0, select_2862[7], 1'b0, select_2862[6], 1'b0, select_2862[5], 1'b0, select_2862[4], 1'b0, select_2862[3], 1'b0, select_2862[2], 1'b0, select_2862[1], 1'b0, select_2862[0], 1'b0} : {1'b0, select_2862[11], 1'b0, select_2862[10], 1'b0, select_2862[9], 1'b0, select_2862[8], 1'b0, select_2862[7], 1'b0, select_2862[6], 1'b0, select_2862[5], 1'b0, select_2862[4], 1'b0, select_2862[3], 1'b0, select_2862[2], 1'b0, select_2862[1], 1'b0, select_2862[0]};
  // hls/stages/census.hpp:378
  logic and_2867;
  assign and_2867 = less_2858 & (~((sharpness_sums_contrast_1_q & select_2863) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2869;
  assign select_2869 = (less_2857 & and_2867) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2869};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2872;
  assign select_2872 = equal_2856 ? (less_2857 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2877;
  assign and_2877 = less_2858 & (~((sharpness_sums_contrast_0_q & select_2863) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2879;
  assign select_2879 = (less_2857 & and_2877) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2879};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2882;
  assign select_2882 = equal_2856 ? (less_2857 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2884;
  assign select_2884 = equal_2856 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2886;
  assign select_2886 = equal_2856 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2888;
  assign select_2888 = equal_2856 ? {sharpness_comparing_contrast_0_q[0], and_2877} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2890;
  assign select_2890 = equal_2856 ? {sharpness_comparing_contrast_1_q[0], and_2867} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2895;
  assign select_2895 = drew_q ? (equal_2856 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2899;
  assign select_2899 = drew_q ? (equal_2856 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2900;
  assign equal_2900 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2901;
  assign xor_2901 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2904;
  assign select_2904 = (equal_2900 | xor_2901) ? (five_times[0] & xor_2901) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2906;
  assign select_2906 = drew_q ? (equal_2856 ? select_2904 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2907;
  assign xor_2907 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2910;
  assign select_2910 = (equal_2900 | xor_2907) ? (five_times_2[0] & xor_2907) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2912;
  assign select_2912 = drew_q ? (equal_2856 ? select_2910 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2913;
  assign xor_2913 = sharpness_comparing_contrast_0_q[1] ^ and_2867;
  logic select_2916;
  assign select_2916 = (equal_2900 | xor_2913) ? (and_2867 & xor_2913) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2918;
  assign select_2918 = drew_q ? (equal_2856 ? select_2916 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2919;
  assign xor_2919 = sharpness_comparing_contrast_1_q[1] ^ and_2877;
  logic select_2922;
  assign select_2922 = (equal_2900 | xor_2919) ? (and_2877 & xor_2919) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2924;
  assign select_2924 = drew_q ? (equal_2856 ? select_2922 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3040;
  assign select_3040 = and_3032_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3038_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3043;
  assign and_3043 = not_563_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3048;
  assign and_3048 = not_563_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3053;
  assign and_3053 = not_563_s3_q & (drew_q & (ends_cell_s3_q & and_2479_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3057;
  assign not_3057 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3066;
  assign select_3066 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3067;
  assign difference_3067 = {1'b0, explained_2_s3_q} - {1'b0, select_3066};
  logic [4:0] e;
  assign e = {difference_3067[3], difference_3067} + (equal_557_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3070;
  assign sum_3070 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3074;
  assign not_3074 = ~(equal_2537 ? and_2558 : (~({sum_3070, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3077;
  assign and_3077 = ends_cell_s3_q & (not_3057 & (centres_values_1_textured_s3_q & not_3074));
  logic and_3079;
  assign and_3079 = not_563_s3_q & (drew_q & and_3077);
  // hls/stages/agreement.hpp:1132
  logic less_3082;
  assign less_3082 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3083;
  assign select_3083 = less_3082 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3086;
  assign select_3086 = less_3082 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3087;
  assign sum_3087 = {1'b0, select_3086} + {3'h0, select_3086[9:2]};
  logic and_3089;
  assign and_3089 = (~(select_3083[9:4] == 6'h0)) & ({sum_3087, select_3086[1:0]} < {3'h0, select_3083});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3092;
  assign select_3092 = x_s3_q[6] ? (equal_2069_s3_q ? 10'h0 : (and_3089 ? select_3083 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3093;
  assign select_3093 = equal_562_s3_q ? select_3092 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3095;
  assign select_3095 = and_3032_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3093});
  logic [13:0] select_3102;
  assign select_3102 = and_3032_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3100_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3104;
  assign and_3104 = not_3057 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3107;
  assign and_3107 = not_563_s3_q & (drew_q & (ends_cell_s3_q & and_3104));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3109;
  assign select_3109 = and_3032_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3107});
  // hls/stages/agreement.hpp:1110
  logic and_3111;
  assign and_3111 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3074);
  // hls/stages/agreement.hpp:788
  logic and_3115;
  assign and_3115 = not_563_s3_q & (drew_q & (ends_cell_s3_q & (not_3057 & and_3111)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3117;
  assign select_3117 = and_3032_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3115});
  logic [13:0] select_3136;
  assign select_3136 = and_3032_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3134_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3211;
  assign select_3211 = drew_q ? (equal_2165_s3_q ? (and_3193_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3212;
  assign select_3212 = equal_562_s3_q ? 8'h0 : select_3211;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3214;
  assign select_3214 = and_3192_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3212[7]}}, select_3212});
  // hls/stages/agreement.hpp:788
  logic and_3217;
  assign and_3217 = not_563_s3_q & (drew_q & (and_3193_s3_q & equal_2165_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3219;
  assign select_3219 = and_3192_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3217});
  // hls/stages/registration.hpp:107
  logic and_3221;
  assign and_3221 = and_3193_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3223;
  assign select_3223 = drew_q ? (equal_2165_s3_q ? {and_3221, and_3193_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3224;
  assign select_3224 = equal_562_s3_q ? 2'h0 : select_3223;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3225;
  assign sum_3225 = registration_half_votes_down_q + {{5{select_3224[1]}}, select_3224};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3231;
  assign select_3231 = drew_q ? (equal_2165_s3_q ? {and_3229_s3_q, and_3193_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3232;
  assign select_3232 = equal_562_s3_q ? 2'h0 : select_3231;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3233;
  assign sum_3233 = registration_half_votes_up_q + {{5{select_3232[1]}}, select_3232};
  // hls/stages/registration.hpp:107
  logic and_3236;
  assign and_3236 = and_3193_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3238;
  assign select_3238 = drew_q ? (equal_2165_s3_q ? {and_3236, and_3193_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3239;
  assign select_3239 = equal_562_s3_q ? 2'h0 : select_3238;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3240;
  assign sum_3240 = registration_half_half_votes_down_q + {{5{select_3239[1]}}, select_3239};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3245;
  assign select_3245 = drew_q ? (equal_2165_s3_q ? {and_3243_s3_q, and_3193_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3246;
  assign select_3246 = equal_562_s3_q ? 2'h0 : select_3245;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3247;
  assign sum_3247 = registration_half_half_votes_up_q + {{5{select_3246[1]}}, select_3246};
  // hls/stages/agreement.hpp:788
  logic and_3281;
  assign and_3281 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & less_2100_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3288;
  assign select_3288 = or_2104_s3_q ? 12'h0 : (equal_3286_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3291;
  assign select_3291 = x_s3_q[6] ? (equal_2069_s3_q ? 12'h0 : (less_2100_s3_q ? select_3288 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3292;
  assign select_3292 = equal_562_s3_q ? select_3291 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3293;
  assign and_3293 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3296;
  assign and_3296 = not_2452_s3_q & (less_2100_s3_q & ({and_3293, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3298;
  assign and_3298 = equal_562_s3_q & (x_s3_q[6] & and_3296);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3300;
  assign sum_3300 = {{2{select_3292[11]}}, select_3292} + (and_3298 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3303;
  assign select_3303 = or_2104_s3_q ? 12'h0 : (equal_3286_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3306;
  assign select_3306 = x_s3_q[6] ? (equal_2069_s3_q ? 12'h0 : (less_2100_s3_q ? select_3303 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3307;
  assign select_3307 = equal_562_s3_q ? select_3306 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3309;
  assign sum_3309 = {{2{select_3307[11]}}, select_3307} + (and_3298 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3311;
  assign not_3311 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3314;
  assign and_3314 = not_2452_s3_q & (less_2100_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3311, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3320;
  assign and_3320 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & (less_2100_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3321;
  assign not_3321 = ~and_3320;
  logic less_3322;
  assign less_3322 = $signed({9'h1, {2{not_3321}}, and_3320}) < $signed(registration_up_q[13:2]);
  logic select_3323;
  assign select_3323 = (equal_562_s3_q & (x_s3_q[6] & and_3314)) ? less_3322 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3327;
  assign and_3327 = x_s3_q[6] & (not_2452_s3_q & (less_2100_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3328;
  assign and_3328 = equal_562_s3_q & and_3327;
  // hls/stages/registration.hpp:242
  logic less_3329;
  assign less_3329 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3331;
  assign less_3331 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3333;
  assign equal_3333 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3337;
  assign and_3337 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & (less_2100_s3_q & equal_3333)));
  // hls/stages/agreement.hpp:1142
  logic and_3344;
  assign and_3344 = x_s3_q[6] & (not_2452_s3_q & (less_2100_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3347;
  assign equal_3347 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3350;
  assign and_3350 = not_2452_s3_q & (less_2100_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3347));
  // hls/stages/registration.hpp:244
  logic and_3354;
  assign and_3354 = (equal_562_s3_q & (x_s3_q[6] & and_3350)) & (less_3331 | less_3329);
  // hls/stages/agreement.hpp:1142
  logic and_3359;
  assign and_3359 = not_2452_s3_q & (less_2100_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3347)));
  // hls/stages/registration.hpp:244
  logic and_3362;
  assign and_3362 = registration_votes_up_q & registration_other_down_q;
  logic select_3364;
  assign select_3364 = registration_votes_down_q ? (registration_other_up_q | and_3362) : and_3362;
  // hls/stages/registration.hpp:138
  logic and_3366;
  assign and_3366 = (equal_562_s3_q & (x_s3_q[6] & and_3359)) & (registration_other_enough_q & select_3364);
  // hls/stages/registration.hpp:245
  logic or_3369;
  assign or_3369 = registration_moved_q | (registration_enough_q & (and_3354 | and_3366));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3454;
  assign select_3454 = sample_pair_whole_s3_q ? (equal_2155_s3_q ? patches_place_0_slope_q : select_2260[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3459;
  assign select_3459 = sample_pair_whole_s3_q ? (equal_2155_s3_q ? patches_place_1_slope_q : select_2289[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3461;
  assign select_3461 = equal_2155_s3_q ? patches_valid_0_q : (select_2154_s3_q ? patches_valid_0_q : select_2257[0]);
  // hls/stages/agreement.hpp:276
  logic select_3464;
  assign select_3464 = sample_pair_whole_s3_q ? (and_2280 ? (sample_present_s3_q & select_3461) : select_3461) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3466;
  assign select_3466 = equal_2155_s3_q ? patches_valid_1_q : (select_2154_s3_q ? select_2257[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3469;
  assign select_3469 = sample_pair_whole_s3_q ? (and_2300 ? (sample_present_s3_q & select_3466) : select_3466) : patches_valid_1_q;
  logic [5:0] select_3472;
  assign select_3472 = sample_pair_whole_s3_q ? (select_2278[5] ? {1'b1, select_2278[4:0]} : (select_2278 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3475;
  assign select_3475 = sample_pair_whole_s3_q ? (select_2298[5] ? {1'b1, select_2298[4:0]} : (select_2298 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3478;
  assign select_3478 = sample_pair_whole_s3_q ? (select_2311[4] ? {1'b1, select_2311[3:0]} : (select_2311 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3481;
  assign select_3481 = sample_pair_whole_s3_q ? (select_2316[4] ? {1'b1, select_2316[3:0]} : (select_2316 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3900_s3_q, parity_3896_s3_q, xor_3884_s3_q, parity_3856_s3_q, parity_3794_s3_q, parity_3665_s3_q} + (equal_3901_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3905;
  assign select_3905 = equal_2241_s3_q ? patches_sums_values_0_q : (equal_2243_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3906;
  assign select_3906 = equal_2243_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3908;
  assign select_3908 = equal_2243_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3910;
  assign select_3910 = equal_2243_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3912;
  assign select_3912 = equal_2243_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3914;
  assign select_3914 = equal_2243_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3916;
  assign select_3916 = equal_2243_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3918;
  assign select_3918 = equal_2243_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3920;
  assign select_3920 = equal_2243_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3922;
  assign select_3922 = equal_2243_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3924;
  assign select_3924 = equal_2243_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3926;
  assign select_3926 = equal_2243_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3928;
  assign select_3928 = equal_2243_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3930;
  assign select_3930 = equal_2243_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3932;
  assign select_3932 = equal_2243_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3934;
  assign select_3934 = equal_2243_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3936;
  assign select_3936 = equal_2243_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:599
  logic or_4041;
  assign or_4041 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4040_s3_q;
  logic or_4044;
  assign or_4044 = equal_4032_s3_q | (less_4034_s3_q | (less_4035_s3_q | or_4041));
  // hls/stages/patches.hpp:579
  logic not_4045;
  assign not_4045 = ~or_4044;
  // hls/stages/patches.hpp:560
  logic and_4046;
  assign and_4046 = equal_2425_s3_q & not_4045;
  // hls/stages/patches.hpp:184
  logic and_4049;
  assign and_4049 = equal_2241_s3_q & (less_2422_s3_q ? (not_2424_s3_q & and_4046) : and_4046);
  // hls/stages/patches.hpp:657
  logic not_4050;
  assign not_4050 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:560
  logic and_4052;
  assign and_4052 = equal_2425_s3_q & (patches_second_s3_q & not_4045);
  // hls/stages/patches.hpp:184
  logic and_4055;
  assign and_4055 = equal_2241_s3_q & (less_2422_s3_q ? (not_2424_s3_q & and_4052) : and_4052);
  // hls/stages/patches.hpp:657
  logic not_4056;
  assign not_4056 = ~and_4055;
  // hls/stages/patches.hpp:188
  logic and_4058;
  assign and_4058 = and_4049 & (not_4050 & not_4056);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4060;
  assign sum_4060 = {7'h0, and_4058} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:597
  logic [7:0] select_4086;
  assign select_4086 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [5:0] select_4087;
  assign select_4087 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4088;
  assign sum_4088 = {2'h0, select_4020_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4089;
  assign sum_4089 = {select_4087[5], select_4087} + {{3{sum_4088[3]}}, sum_4088};
  // hls/stages/patches.hpp:597
  logic [17:0] product_4090;
  assign product_4090 = $signed({{10{select_4086[7]}}, select_4086}) * $signed({{8{sum_4089[6]}}, sum_4089, select_4020_s3_q[2:0]});
  // hls/stages/patches.hpp:598
  logic [13:0] difference_4091;
  assign difference_4091 = {{6{select_4085_s3_q[7]}}, select_4085_s3_q} - {product_4090[17], product_4090[17:5]};
  // hls/stages/patches.hpp:604
  logic less_4092;
  assign less_4092 = $signed({{7{difference_4062[6]}}, difference_4062}) < $signed(difference_4091);
  // hls/stages/patches.hpp:560
  logic and_4095;
  assign and_4095 = equal_2425_s3_q & (not_4045 & (~less_4092));
  // hls/stages/patches.hpp:184
  logic and_4098;
  assign and_4098 = equal_2241_s3_q & (less_2422_s3_q ? (not_2424_s3_q & and_4095) : and_4095);
  // hls/stages/patches.hpp:660
  logic and_4099;
  assign and_4099 = and_4098 & and_4058;
  logic [7:0] sum_4100;
  assign sum_4100 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4099};
  // hls/stages/patches.hpp:560
  logic and_4104;
  assign and_4104 = not_4045 & (~($signed(difference_4091) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4105;
  assign and_4105 = equal_2425_s3_q & and_4104;
  // hls/stages/patches.hpp:184
  logic and_4108;
  assign and_4108 = equal_2241_s3_q & (less_2422_s3_q ? (not_2424_s3_q & and_4105) : and_4105);
  // hls/stages/patches.hpp:661
  logic and_4109;
  assign and_4109 = and_4108 & and_4058;
  logic [7:0] sum_4110;
  assign sum_4110 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4109};
  // hls/stages/patches.hpp:188
  logic and_4112;
  assign and_4112 = and_4049 & (and_4055 & not_4050);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4114;
  assign sum_4114 = {7'h0, and_4112} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_4116;
  assign and_4116 = and_4098 & and_4112;
  logic [7:0] sum_4117;
  assign sum_4117 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4116};
  // hls/stages/patches.hpp:661
  logic and_4119;
  assign and_4119 = and_4108 & and_4112;
  logic [7:0] sum_4120;
  assign sum_4120 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4119};
  // hls/stages/patches.hpp:188
  logic and_4122;
  assign and_4122 = and_4049 & (patches_lower_s3_q & not_4056);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4124;
  assign sum_4124 = {7'h0, and_4122} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_4126;
  assign and_4126 = and_4098 & and_4122;
  logic [7:0] sum_4127;
  assign sum_4127 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4126};
  // hls/stages/patches.hpp:661
  logic and_4129;
  assign and_4129 = and_4108 & and_4122;
  logic [7:0] sum_4130;
  assign sum_4130 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4129};
  // hls/stages/patches.hpp:188
  logic and_4132;
  assign and_4132 = and_4049 & (patches_lower_s3_q & and_4055);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4134;
  assign sum_4134 = {7'h0, and_4132} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_4136;
  assign and_4136 = and_4098 & and_4132;
  logic [7:0] sum_4137;
  assign sum_4137 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4136};
  // hls/stages/patches.hpp:661
  logic and_4139;
  assign and_4139 = and_4108 & and_4132;
  logic [7:0] sum_4140;
  assign sum_4140 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4139};
  // hls/stages/agreement.hpp:1223
  logic equal_4141;
  assign equal_4141 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4142;
  assign less_4142 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4146;
  assign and_4146 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & (equal_4141 & less_4142)));
  // hls/stages/agreement.hpp:1142
  logic and_4151;
  assign and_4151 = x_s3_q[6] & (not_2452_s3_q & (less_4142 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4152;
  assign and_4152 = equal_562_s3_q & and_4151;
  // hls/stages/patches.hpp:623
  logic [7:0] or_4154;
  assign or_4154 = (and_4146 ? patches_quarters_0_places_q : 8'h0) | (and_4152 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4158;
  assign and_4158 = x_s3_q[6] & (not_2452_s3_q & (less_4142 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4159;
  assign and_4159 = equal_562_s3_q & and_4158;
  // hls/stages/agreement.hpp:1142
  logic and_4165;
  assign and_4165 = x_s3_q[6] & (not_2452_s3_q & (less_4142 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4166;
  assign and_4166 = equal_562_s3_q & and_4165;
  // hls/stages/patches.hpp:623
  logic [7:0] or_4168;
  assign or_4168 = (or_4154 | (and_4159 ? patches_quarters_2_places_q : 8'h0)) | (and_4166 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_4172;
  assign select_4172 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4176;
  assign and_4176 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & (less_4142 & select_4172)));
  // hls/stages/patches.hpp:624
  logic [7:0] select_4178;
  assign select_4178 = and_4146 ? (and_4176 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4180;
  assign select_4180 = and_4152 ? (and_4176 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4183;
  assign select_4183 = and_4159 ? (and_4176 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4186;
  assign select_4186 = and_4166 ? (and_4176 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_4189;
  assign select_4189 = and_4146 ? (and_4176 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4191;
  assign select_4191 = and_4152 ? (and_4176 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4194;
  assign select_4194 = and_4159 ? (and_4176 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4197;
  assign select_4197 = and_4166 ? (and_4176 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4199;
  assign sum_4199 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4203;
  assign and_4203 = x_s3_q[6] & (not_2452_s3_q & (less_4142 & (sum_4199[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4204;
  assign and_4204 = equal_562_s3_q & and_4203;
  // hls/stages/patches.hpp:620
  logic [7:0] select_4207;
  assign select_4207 = and_4204 ? (patches_word_places_q + (and_4152 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4210;
  assign select_4210 = and_4204 ? (patches_word_up_q + (and_4152 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4213;
  assign select_4213 = and_4204 ? (patches_word_down_q + (and_4152 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:606
  logic [5:0] select_4217;
  assign select_4217 = ($signed(difference_4091[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4091[5:0];
  logic [5:0] select_4218;
  assign select_4218 = ($signed(14'h10) < $signed(difference_4091)) ? 6'h10 : select_4217;
  // hls/stages/patches.hpp:560
  logic [5:0] select_4220;
  assign select_4220 = equal_2425_s3_q ? (or_4044 ? 6'h0 : select_4218) : 6'h0;
  logic [5:0] select_4222;
  assign select_4222 = less_2422_s3_q ? (equal_2423_s3_q ? 6'h0 : select_4220) : select_4220;
  // hls/stages/patches.hpp:663
  logic [5:0] select_4224;
  assign select_4224 = and_4049 ? (equal_2241_s3_q ? select_4222 : 6'h0) : 6'h0;
  logic [11:0] sum_4225;
  assign sum_4225 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4224[5]}}, select_4224};
  // hls/stages/agreement.hpp:788
  logic and_4229;
  assign and_4229 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q & (equal_3333 & less_4142)));
  // hls/stages/agreement.hpp:1142
  logic and_4233;
  assign and_4233 = x_s3_q[6] & (not_2452_s3_q & (less_4142 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4234;
  assign and_4234 = equal_562_s3_q & and_4233;
  // hls/stages/patches.hpp:647
  logic [7:0] select_4236;
  assign select_4236 = and_4229 ? (and_4234 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_4240;
  assign or_4240 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_4243;
  assign or_4243 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_4244;
  assign sum_4244 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_4246;
  assign select_4246 = and_4229 ? (and_4234 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_4249;
  assign and_4249 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_4251;
  assign select_4251 = and_4234 ? {and_4249, patches_found_q[2:1]} : (and_4229 ? {and_4249, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:645
  logic or_4255;
  assign or_4255 = patches_partly_q | (patches_doubted_q & (~and_4234));
  // hls/stages/patches.hpp:646
  logic select_4258;
  assign select_4258 = and_4229 ? (and_4234 ? or_4255 : (and_4229 ? or_4255 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:644
  logic select_4259;
  assign select_4259 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_4263;
  assign select_4263 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:605
  logic [10:0] sum_4265;
  assign sum_4265 = {sum_4089[6], sum_4089, select_4020_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:560
  logic and_4268;
  assign and_4268 = equal_2425_s3_q & (not_4045 & ({{5{sum_4265[10]}}, sum_4265} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4271;
  assign and_4271 = equal_2241_s3_q & (less_2422_s3_q ? (not_2424_s3_q & and_4268) : and_4268);
  // hls/stages/patches.hpp:188
  logic and_4272;
  assign and_4272 = and_4049 & and_4271;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_4273;
  assign sum_4273 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4272};
  // hls/stages/patches.hpp:653
  logic [12:0] product_4278;
  assign product_4278 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4236};
  // hls/stages/patches.hpp:188
  logic and_4280;
  assign and_4280 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4278[12:5] < patches_on_skin_q);
  logic select_4285;
  assign select_4285 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_4289;
  assign or_4289 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_4296;
  assign select_4296 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_4302;
  assign and_4302 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4303;
  assign sum_4303 = patches_age_q + {9'h0, and_4302};
  logic [9:0] select_4306;
  assign select_4306 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4303)) : sum_4303;
  // hls/stages/agreement.hpp:1188
  logic or_4363;
  assign or_4363 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_4365;
  assign equal_4365 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_4371;
  assign select_4371 = (equal_4365 & equal_4141) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4374;
  assign sum_4374 = {1'b0, select_3086} + {2'h0, select_3086[9:1]};
  logic select_4377;
  assign select_4377 = (select_3083[9:3] == 7'h0) ? ((~or_4363) & (~select_4371)) : (~({sum_4374, select_3086[0]} < {2'h0, select_3083}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4379;
  assign select_4379 = x_s3_q[6] ? (equal_2069_s3_q ? good_q : {select_4377, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4384;
  assign select_4384 = equal_562_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4382_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_4385;
  assign equal_4385 = x_s3_q[6:3] == 4'ha;
  logic equal_4387;
  assign equal_4387 = x_s3_q[6:3] == 4'hc;
  logic equal_4388;
  assign equal_4388 = x_s3_q[6:3] == 4'hb;
  logic equal_4389;
  assign equal_4389 = x_s3_q[6:3] == 4'h9;
  logic equal_4390;
  assign equal_4390 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4392;
  assign select_4392 = equal_4389 ? counts_skin_unproven_q : (equal_4390 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4394;
  assign select_4394 = equal_4388 ? counts_regions_bad_q : (equal_4385 ? counts_nearer_q : select_4392);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4387 ? counts_on_skin_q : select_4394;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1230
  logic select_4397;
  assign select_4397 = (equal_4385 & equal_4141) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_4398;
  assign not_4398 = ~hidden_for_q[7];
  logic [7:0] select_4400;
  assign select_4400 = select_4397 ? (hidden_for_q + {7'h0, not_4398}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4402;
  assign select_4402 = equal_562_s3_q ? (equal_4382_s3_q ? select_4400 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4403;
  assign select_4403 = equal_4141 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4405;
  assign select_4405 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4407;
  assign select_4407 = equal_4390 ? cfg_unproven_skin_limit_i : (equal_4365 ? cfg_unproven_limit_i : select_4405);
  logic [7:0] select_4409;
  assign select_4409 = equal_4385 ? cfg_regions_limit_i : (equal_4389 ? cfg_hidden_limit_i : select_4407);
  logic [7:0] limit;
  assign limit = equal_4387 ? cfg_regions_limit_i : (equal_4388 ? {cfg_on_skin_limit_i, 3'h0} : select_4409);
  // hls/stages/agreement.hpp:1231
  logic not_4412;
  assign not_4412 = ~x_s3_q[2];
  logic [3:0] select_4413;
  assign select_4413 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4412, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4412};
  logic [7:0] select_4414;
  assign select_4414 = x_s3_q[0] ? {select_4413[3], 1'b0, select_4413[2], 1'b0, select_4413[1], 1'b0, select_4413[0], 1'b0} : {1'b0, select_4413[3], 1'b0, select_4413[2], 1'b0, select_4413[1], 1'b0, select_4413[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4418;
  assign select_4418 = equal_4389 ? counts_skin_supervised_q : (equal_4390 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4420;
  assign select_4420 = equal_4388 ? counts_skin_textured_q : (equal_4385 ? counts_textured_q : select_4418);
  logic [13:0] of;
  assign of = equal_4387 ? counts_textured_q : select_4420;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_4422;
  assign select_4422 = ((limit & select_4414) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4403} + {1'b0, select_4422};
  // hls/stages/agreement.hpp:788
  logic select_4427;
  assign select_4427 = equal_562_s3_q ? (equal_4141 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_4432;
  assign and_4432 = too_much_q & (~(equal_4390 & equal_4141));
  // hls/stages/agreement.hpp:1229
  logic select_4437;
  assign select_4437 = (over[14] & equal_4141) ? (and_4432 | ((equal_4390 | equal_4389) | (x_s3_q[6:3] == 4'hf))) : and_4432;
  // hls/stages/agreement.hpp:1125
  logic and_4442;
  assign and_4442 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4443;
  assign select_4443 = (equal_4387 & equal_4141) ? and_4442 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4445;
  assign select_4445 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4447;
  assign select_4447 = equal_562_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4445 : box_textured_columns_values_0_q);
  logic [2:0] select_4448;
  assign select_4448 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4450;
  assign select_4450 = equal_562_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4448 : box_textured_columns_values_1_q);
  logic [2:0] select_4451;
  assign select_4451 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4453;
  assign select_4453 = equal_562_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4451 : box_textured_columns_values_2_q);
  logic [2:0] select_4454;
  assign select_4454 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4456;
  assign select_4456 = equal_562_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4454 : box_textured_columns_values_3_q);
  logic [2:0] select_4457;
  assign select_4457 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4459;
  assign select_4459 = equal_562_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4457 : box_textured_columns_values_4_q);
  logic [4:0] select_4461;
  assign select_4461 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4463;
  assign select_4463 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4465;
  assign select_4465 = equal_562_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4463 : box_explained_columns_values_0_q);
  logic [2:0] select_4466;
  assign select_4466 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4468;
  assign select_4468 = equal_562_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4466 : box_explained_columns_values_1_q);
  logic [2:0] select_4469;
  assign select_4469 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4471;
  assign select_4471 = equal_562_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4469 : box_explained_columns_values_2_q);
  logic [2:0] select_4472;
  assign select_4472 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4474;
  assign select_4474 = equal_562_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4472 : box_explained_columns_values_3_q);
  logic [2:0] select_4475;
  assign select_4475 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4477;
  assign select_4477 = equal_562_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4475 : box_explained_columns_values_4_q);
  logic [4:0] select_4479;
  assign select_4479 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4482;
  assign select_4482 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4484;
  assign select_4484 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4486;
  assign select_4486 = equal_562_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4484 : box_shown_columns_values_1_q);
  logic [2:0] select_4487;
  assign select_4487 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4489;
  assign select_4489 = equal_562_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4487 : box_shown_columns_values_2_q);
  logic [2:0] select_4490;
  assign select_4490 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4492;
  assign select_4492 = equal_562_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4490 : box_shown_columns_values_3_q);
  logic [2:0] select_4493;
  assign select_4493 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4495;
  assign select_4495 = equal_562_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4493 : box_shown_columns_values_4_q);
  logic [4:0] select_4497;
  assign select_4497 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4500;
  assign select_4500 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4502;
  assign select_4502 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4504;
  assign select_4504 = equal_562_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4502 : box_nearer_columns_values_1_q);
  logic [2:0] select_4505;
  assign select_4505 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4507;
  assign select_4507 = equal_562_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4505 : box_nearer_columns_values_2_q);
  logic [2:0] select_4508;
  assign select_4508 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4510;
  assign select_4510 = equal_562_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4508 : box_nearer_columns_values_3_q);
  logic [2:0] select_4511;
  assign select_4511 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4513;
  assign select_4513 = equal_562_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4511 : box_nearer_columns_values_4_q);
  logic [4:0] select_4515;
  assign select_4515 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4560;
  assign select_4560 = and_4559_s3_q ? {and_2588, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4561;
  assign and_4561 = proven_q & less_4549;
  // hls/stages/agreement.hpp:438
  logic select_4564;
  assign select_4564 = and_2518_s3_q ? (less_2519_s3_q ? (select_4560[0] & and_4561) : seen_q) : seen_q;
  logic select_4567;
  assign select_4567 = and_2518_s3_q ? (less_2519_s3_q ? (select_4560[1] & and_4561) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4574;
  assign or_4574 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4573_s3_q;
  // hls/stages/agreement.hpp:1241
  logic not_4582;
  assign not_4582 = ~(or_4363 | not_2808);
  // hls/stages/agreement.hpp:788
  logic and_4586;
  assign and_4586 = equal_562_s3_q & (equal_4382_s3_q & (not_4582 & (select_4371 | select_4437)));
  logic and_4589;
  assign and_4589 = equal_4382_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4593;
  assign or_4593 = select_2906 | (select_2918 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4600;
  assign and_4600 = equal_562_s3_q & (equal_4382_s3_q & (not_4582 & (select_2912 | select_2924)));
  // hls/stages/agreement.hpp:1150
  logic and_4605;
  assign and_4605 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4400 < cfg_hidden_frames_i));
  logic select_4611;
  assign select_4611 = (not_2808 | (select_4443 & not_4275)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4616;
  assign and_4616 = equal_562_s3_q & (equal_4382_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4620;
  assign and_4620 = equal_562_s3_q & (x_s3_q[6] & (not_2452_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4628;
  assign select_4628 = equal_2091_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4626_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4629;
  assign select_4629 = equal_2089_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4628;
  logic [31:0] select_4630;
  assign select_4630 = equal_2087_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4629;
  logic [31:0] select_4631;
  assign select_4631 = equal_2085_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4630;
  logic [31:0] select_4632;
  assign select_4632 = equal_2083_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4631;
  logic [31:0] select_4633;
  assign select_4633 = equal_2081_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4632;
  logic [31:0] select_4634;
  assign select_4634 = equal_2079_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4633;
  logic [31:0] select_4635;
  assign select_4635 = equal_2077_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4634;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4636;
  assign select_4636 = less_3082 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4637;
  assign select_4637 = equal_2069_s3_q ? select_4635 : {2'h0, select_4636, select_3086, select_3083};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_537_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_734_s3_q, and_733, less_728_s3_q, and_727_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_721, and_697_s3_q, and_696_s3_q, and_671_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q, less_640_s3_q};
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
  assign registration_sums_waddr = {sum_2075_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2134_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2133, sum_2129};
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
  assign patches_right_1_waddr = {select_2271_s3_q, select_2297};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2300);
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
  assign patches_left_waddr = {select_2319, select_2318_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2325);
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
  assign patches_rows_wdata = select_2440;
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
  assign regions_waddr = {region_row_s3_q, or_2450_s3_q, or_2447_s3_q, or_2444_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2484_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2483, sum_2473, sum_2468};
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
  assign map_waddr = {sum_2524_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2598_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2588, is_seen};
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
      census_left_misses_q <= select_2747;
      sharpness_before_last_mask_q <= select_2820;
      sharpness_sums_detail_0_q <= and_537_s3_q ? select_2834 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_537_s3_q ? select_2846 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_537_s3_q ? sum_2850 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_537_s3_q ? sum_2854 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2872 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2882 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2884 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2886 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2888 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2890 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2895;
      sharpness_comparing_carry_1_q <= select_2899;
      sharpness_comparing_less_detail_0_q <= select_2906;
      sharpness_comparing_less_detail_1_q <= select_2912;
      sharpness_comparing_less_contrast_0_q <= select_2918;
      sharpness_comparing_less_contrast_1_q <= select_2924;
      counts_supervised_q <= select_3040;
      counts_textured_q <= and_3032_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3043});
      counts_explained_q <= and_3032_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3048});
      counts_nearer_q <= and_3032_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3053});
      counts_unproven_q <= and_3032_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3079});
      counts_regions_bad_q <= select_3095;
      counts_skin_supervised_q <= select_3102;
      counts_skin_textured_q <= select_3109;
      counts_skin_unproven_q <= select_3117;
      counts_on_skin_q <= select_3136;
      registration_half_across_q <= select_3214;
      registration_half_measured_q <= select_3219;
      registration_half_votes_down_q <= and_3192_s3_q ? 7'h0 : sum_3225;
      registration_half_votes_up_q <= and_3192_s3_q ? 7'h0 : sum_3233;
      registration_half_half_votes_down_q <= and_3192_s3_q ? 7'h0 : sum_3240;
      registration_half_half_votes_up_q <= and_3192_s3_q ? 7'h0 : sum_3247;
      registration_down_q <= and_3281 ? sum_3300 : registration_down_q;
      registration_up_q <= and_3281 ? sum_3309 : registration_up_q;
      registration_enough_q <= select_3323;
      registration_votes_down_q <= and_3328 ? less_3329 : registration_votes_down_q;
      registration_votes_up_q <= and_3328 ? less_3331 : registration_votes_up_q;
      registration_other_enough_q <= and_3337 ? select_3323 : registration_other_enough_q;
      registration_other_down_q <= and_3337 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3337 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_562_s3_q & and_3344)) & or_3369;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2259 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2261 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2262 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3454;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2288 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2290 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2291 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3459;
      patches_valid_0_q <= select_3464;
      patches_valid_1_q <= select_3469;
      patches_right_next_0_q <= select_3472;
      patches_right_next_1_q <= select_3475;
      patches_left_next_0_q <= select_3478;
      patches_left_next_1_q <= select_3481;
      patches_sums_values_0_q <= select_3905;
      patches_sums_values_1_q <= equal_2241_s3_q ? patches_sums_values_1_q : select_3906;
      patches_sums_values_2_q <= equal_2241_s3_q ? patches_sums_values_2_q : select_3908;
      patches_sums_values_3_q <= equal_2241_s3_q ? patches_sums_values_3_q : select_3910;
      patches_sums_values_4_q <= equal_2241_s3_q ? patches_sums_values_4_q : select_3912;
      patches_sums_values_5_q <= equal_2241_s3_q ? patches_sums_values_5_q : select_3914;
      patches_sums_values_6_q <= equal_2241_s3_q ? patches_sums_values_6_q : select_3916;
      patches_sums_values_7_q <= equal_2241_s3_q ? patches_sums_values_7_q : select_3918;
      patches_sums_values_8_q <= equal_2241_s3_q ? patches_sums_values_8_q : select_3920;
      patches_sums_values_9_q <= equal_2241_s3_q ? patches_sums_values_9_q : select_3922;
      patches_sums_values_10_q <= equal_2241_s3_q ? patches_sums_values_10_q : select_3924;
      patches_sums_values_11_q <= equal_2241_s3_q ? patches_sums_values_11_q : select_3926;
      patches_sums_values_12_q <= equal_2241_s3_q ? patches_sums_values_12_q : select_3928;
      patches_sums_values_13_q <= equal_2241_s3_q ? patches_sums_values_13_q : select_3930;
      patches_sums_values_14_q <= equal_2241_s3_q ? patches_sums_values_14_q : select_3932;
      patches_sums_values_15_q <= equal_2241_s3_q ? patches_sums_values_15_q : select_3934;
      patches_sums_values_16_q <= equal_2241_s3_q ? patches_sums_values_16_q : select_3936;
      patches_best_differing_q <= select_2440[9:0];
      patches_best_column_q <= select_2440[14:10];
      patches_quarters_0_places_q <= sum_4060;
      patches_quarters_0_up_q <= sum_4100;
      patches_quarters_0_down_q <= sum_4110;
      patches_quarters_1_places_q <= sum_4114;
      patches_quarters_1_up_q <= sum_4117;
      patches_quarters_1_down_q <= sum_4120;
      patches_quarters_2_places_q <= sum_4124;
      patches_quarters_2_up_q <= sum_4127;
      patches_quarters_2_down_q <= sum_4130;
      patches_quarters_3_places_q <= sum_4134;
      patches_quarters_3_up_q <= sum_4137;
      patches_quarters_3_down_q <= sum_4140;
      patches_word_places_q <= or_4168;
      patches_word_up_q <= ((select_4178 | select_4180) | select_4183) | select_4186;
      patches_word_down_q <= ((select_4189 | select_4191) | select_4194) | select_4197;
      patches_sum_places_q <= select_4207;
      patches_sum_up_q <= select_4210;
      patches_sum_down_q <= select_4213;
      patches_across_q <= sum_4225;
      patches_places_q <= select_4236;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4240;
      patches_partly_q <= or_4243;
      patches_clear_limit_q <= sum_4244[8:2];
      patches_complete_q <= select_4246;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4229 ? select_4251 : patches_found_q;
      patches_doubted_q <= select_4258;
      patches_doubted_before_q <= select_4259;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4263;
      patches_on_skin_q <= sum_4273;
      patches_large_q <= not_4275 & and_4280;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4285;
      patches_spoiled_q <= or_4289;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4296;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4306;
      segment_textured_q <= select_2465 + {6'h0, and_3043};
      segment_explained_q <= select_2470 + {6'h0, and_3048};
      segment_nearer_q <= select_2480 + {6'h0, and_3053};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_562_s3_q ? select_4379 : good_q;
      good_known_q <= select_4384;
      hidden_for_q <= select_4402;
      product_q <= equal_562_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4427;
      disagree_q <= equal_562_s3_q ? select_4371 : disagree_q;
      too_much_q <= equal_562_s3_q ? select_4437 : too_much_q;
      hides_q <= equal_562_s3_q ? select_4397 : hides_q;
      overlooks_q <= equal_562_s3_q ? select_4443 : overlooks_q;
      seen_q <= select_4564;
      nearer_q <= select_4567;
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
      averager_quarter_1_0_q <= select_2622;
      averager_quarter_1_1_q <= select_2624;
      averager_quarter_2_0_q <= select_2626;
      averager_quarter_2_1_q <= select_2628;
      averager_detail_0_q <= select_2640;
      averager_detail_1_q <= select_2648;
      census_changes_values_0_left_q <= and_537_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_537_s3_q ? sum_2731 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2733;
      census_changes_values_1_right_q <= select_2734;
      census_changes_values_2_left_q <= select_2735;
      census_changes_values_2_right_q <= select_2736;
      sharpness_last_mask_q <= and_537_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_537_s3_q ? select_2817[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_537_s3_q ? select_2817[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4447;
      box_textured_columns_values_1_q <= select_4450;
      box_textured_columns_values_2_q <= select_4453;
      box_textured_columns_values_3_q <= select_4456;
      box_textured_columns_values_4_q <= select_4459;
      box_textured_sum_sums_values_0_q <= equal_562_s3_q ? box_textured_sum_sums_values_0_q : select_4461;
      box_explained_columns_values_0_q <= select_4465;
      box_explained_columns_values_1_q <= select_4468;
      box_explained_columns_values_2_q <= select_4471;
      box_explained_columns_values_3_q <= select_4474;
      box_explained_columns_values_4_q <= select_4477;
      box_explained_sum_sums_values_0_q <= equal_562_s3_q ? box_explained_sum_sums_values_0_q : select_4479;
      box_shown_columns_values_0_q <= equal_562_s3_q ? box_shown_columns_values_0_q : select_4482;
      box_shown_columns_values_1_q <= select_4486;
      box_shown_columns_values_2_q <= select_4489;
      box_shown_columns_values_3_q <= select_4492;
      box_shown_columns_values_4_q <= select_4495;
      box_shown_sum_sums_values_0_q <= equal_562_s3_q ? box_shown_sum_sums_values_0_q : select_4497;
      box_nearer_columns_values_0_q <= equal_562_s3_q ? box_nearer_columns_values_0_q : select_4500;
      box_nearer_columns_values_1_q <= select_4504;
      box_nearer_columns_values_2_q <= select_4507;
      box_nearer_columns_values_3_q <= select_4510;
      box_nearer_columns_values_4_q <= select_4513;
      box_nearer_sum_sums_values_0_q <= equal_562_s3_q ? box_nearer_sum_sums_values_0_q : select_4515;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4544_s4_q;
  logic or_4568_s4_q;
  logic and_4569_s4_q;
  logic and_4577_s4_q;
  logic and_4580_s4_q;
  logic and_4586_s4_q;
  logic and_4590_s4_q;
  logic and_4596_s4_q;
  logic and_4600_s4_q;
  logic and_4608_s4_q;
  logic and_4613_s4_q;
  logic and_4616_s4_q;
  logic and_4620_s4_q;
  logic [5:0] select_4622_s4_q;
  logic [31:0] select_4639_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4544_s4_q <= said_q;
      or_4568_s4_q <= not_2808 | select_4564;
      and_4569_s4_q <= cfg_prove_i & select_4567;
      and_4577_s4_q <= equal_562_s3_q & (equal_4382_s3_q & (cfg_prove_i & or_4574));
      and_4580_s4_q <= equal_562_s3_q & (equal_4382_s3_q & (cfg_prove_i & or_4363));
      and_4586_s4_q <= and_4586;
      and_4590_s4_q <= equal_562_s3_q & and_4589;
      and_4596_s4_q <= equal_562_s3_q & (equal_4382_s3_q & (not_4582 & or_4593));
      and_4600_s4_q <= and_4600;
      and_4608_s4_q <= equal_562_s3_q & (equal_4382_s3_q & (cfg_prove_i & and_4605));
      and_4613_s4_q <= equal_562_s3_q & (equal_4382_s3_q & select_4611);
      and_4616_s4_q <= and_4616;
      and_4620_s4_q <= and_4620;
      select_4622_s4_q <= equal_562_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4639_s4_q <= equal_562_s3_q ? (x_s3_q[6] ? select_4637 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4568_s4_q;
  assign marks_nearer_o = and_4569_s4_q;
  assign verdict_valid_o = and_4544_s4_q;
  assign verdict_unproven_yet_o = and_4577_s4_q;
  assign verdict_untextured_o = and_4580_s4_q;
  assign verdict_disagree_o = and_4586_s4_q;
  assign verdict_moved_o = and_4590_s4_q;
  assign verdict_unsharp_left_o = and_4596_s4_q;
  assign verdict_unsharp_right_o = and_4600_s4_q;
  assign verdict_hidden_o = and_4608_s4_q;
  assign verdict_overlooked_o = and_4613_s4_q;
  assign verdict_out_of_step_o = and_4616_s4_q;
  assign frame_valid_o = and_4620_s4_q;
  assign frame_index_o = select_4622_s4_q;
  assign frame_word_o = select_4639_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4278[4:0], sum_4244[1:0], sum_4199[1:0], product_4090[4:0], sum_3182[0], difference_3123[1:0], detail_4[1:0], detail_3[1:0], sum_2741[4:0], sum_2179[0], sum_2175[0], sum_719[4:0], cfg_width_i[2:0]};

endmodule
