// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3060 bits, pipeline 862 bits, memories 127160 bits.
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
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [5:0] sum_2984;
  assign sum_2984 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4028;
  assign difference_4028 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4244;
  assign not_4244 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4301;
  assign difference_4301 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4516;
  assign less_4516 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4517;
  assign sum_4517 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4535;
  assign not_4535 = ~cfg_prove_i;

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
  logic [2:0] select_490;
  assign select_490 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_492;
  assign select_492 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [8:0] select_495;
  assign select_495 = ({select_492, select_490} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_496;
  assign select_496 = select_490[0] ? averager_place_q : select_495;
  // hls/stages/census.hpp:42
  logic or_497;
  assign or_497 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_500;
  assign and_500 = (select_490[0] & or_497) & (select_496[8:6] < 3'h5);
  // hls/stages/census.hpp:42
  logic [2:0] select_505;
  assign select_505 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_492 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_522;
  assign equal_522 = select_490 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_523;
  assign equal_523 = select_505 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_524;
  assign and_524 = equal_523 & and_500;
  // hls/stages/agreement.hpp:276
  logic and_526;
  assign and_526 = sample_pair_whole_q & (equal_522 & and_524);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:624
  logic equal_554;
  assign equal_554 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:595
  logic or_555;
  assign or_555 = so | equal_554;
  // hls/stages/agreement.hpp:593
  logic [7:0] sum_556;
  assign sum_556 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:595
  logic [7:0] select_557;
  assign select_557 = run_shift_q[5] ? x_q : sum_556;
  logic less_558;
  assign less_558 = {1'b0, last_q} < select_557;
  // hls/stages/agreement.hpp:226
  logic not_559;
  assign not_559 = ~less_558;
  // hls/stages/agreement.hpp:615
  logic equal_569;
  assign equal_569 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:616
  logic equal_570;
  assign equal_570 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_571;
  assign and_571 = equal_570 & not_559;
  logic select_573;
  assign select_573 = or_555 ? not_559 : (equal_569 ? not_559 : and_571);
  // hls/stages/agreement.hpp:799
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_591;
  assign and_591 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_557)));
  logic and_592;
  assign and_592 = equal_569 & and_591;
  logic select_593;
  assign select_593 = or_555 ? not_559 : and_592;
  // hls/stages/agreement.hpp:822
  logic [6:0] right;
  assign right = sum_556[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:595
  logic not_623;
  assign not_623 = ~or_555;
  // hls/stages/agreement.hpp:149
  logic and_626;
  assign and_626 = not_623 & ((~equal_569) & and_571);
  // hls/stages/census.hpp:42
  logic [5:0] select_653;
  assign select_653 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_653 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_2125;
  assign and_2125 = (select_490 == 3'h0) & (select_492 == 7'h0);
  // hls/stages/patches.hpp:392
  logic not_2126;
  assign not_2126 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2129;
  assign not_2129 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_2130;
  assign and_2130 = patches_capturing_q & not_2129;
  // hls/stages/patches.hpp:364
  logic equal_2131;
  assign equal_2131 = {or_497, select_505} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2133;
  assign equal_2133 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2138;
  assign and_2138 = (not_2126 & (patches_work_q == 3'h0)) & (~(and_2130 | ((~equal_2131) | (~equal_2133))));
  // hls/stages/patches.hpp:530
  logic equal_2229;
  assign equal_2229 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:508
  logic not_2230;
  assign not_2230 = ~equal_2229;
  // hls/stages/patches.hpp:501
  logic equal_2231;
  assign equal_2231 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:454
  logic not_2232;
  assign not_2232 = ~equal_2231;
  // hls/stages/patches.hpp:495
  logic equal_2233;
  assign equal_2233 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2234;
  assign equal_2234 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:530
  logic or_2235;
  assign or_2235 = equal_2233 | equal_2234;
  // hls/stages/patches.hpp:456
  logic not_2236;
  assign not_2236 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_2258;
  assign select_2258 = and_2138 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2259;
  assign select_2259 = and_2125 ? select_2258 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2261;
  assign and_2261 = and_2130 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2265;
  assign select_2265 = and_2125 ? (and_2138 | (and_2130 & (~and_2261))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2273;
  assign and_2273 = not_2230 & (not_2232 & (or_2235 & (patches_second_q & equal_2234)));
  // hls/stages/patches.hpp:167
  logic not_2290;
  assign not_2290 = ~equal_2234;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2306;
  assign select_2306 = and_2125 ? {select_2258[4], select_2258[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:454
  logic and_2316;
  assign and_2316 = not_2230 & (or_2235 & not_2232);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2573;
  assign select_2573 = sample_pair_whole_q ? (sample_last_q ? (select_505 + 3'h1) : select_505) : raster_at_y_q;
  logic [6:0] select_2575;
  assign select_2575 = sample_pair_whole_q ? (select_492 + {6'h0, equal_522}) : raster_at_column_q;
  logic [5:0] select_2578;
  assign select_2578 = sample_pair_whole_q ? (sample_last_q ? (select_653 + {5'h0, equal_523}) : select_653) : raster_at_row_q;
  logic select_2582;
  assign select_2582 = sample_pair_whole_q ? (sample_last_q ? (or_497 & (~raster_final_row_q)) : or_497) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2584;
  assign select_2584 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2588;
  assign select_2588 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:460
  logic equal_2893;
  assign equal_2893 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:465
  logic and_2894;
  assign and_2894 = and_526 & equal_2893;
  // hls/stages/agreement.hpp:524
  logic select_2897;
  assign select_2897 = (and_2894 | (~ends_cell_q)) ? and_2894 : ends_q;
  // hls/stages/agreement.hpp:530
  logic [2:0] now;
  assign now = select_2897 ? (and_2894 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:535
  logic [5:0] select_2901;
  assign select_2901 = select_2897 ? (and_2894 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2904;
  assign select_2904 = select_2897 ? (following_last_shift_q & (~and_2894)) : run_last_shift_q;
  // hls/stages/agreement.hpp:608
  logic and_2907;
  assign and_2907 = run_last_shift_q & equal_569;
  // hls/stages/agreement.hpp:617
  logic select_2909;
  assign select_2909 = equal_569 ? (~run_last_shift_q) : equal_570;
  // hls/stages/agreement.hpp:621
  logic equal_2910;
  assign equal_2910 = run_phase_q == 3'h1;
  logic not_2913;
  assign not_2913 = ~select_2909;
  // hls/stages/agreement.hpp:624
  logic equal_2915;
  assign equal_2915 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:608
  logic and_2916;
  assign and_2916 = final_row_q & so;
  // hls/stages/agreement.hpp:621
  logic [1:0] select_2917;
  assign select_2917 = equal_2915 ? 2'h1 : {2{and_2916}};
  logic [2:0] select_2919;
  assign select_2919 = (and_2907 | (select_2909 | equal_2910)) ? (equal_2910 ? 3'h2 : {not_2913, {2{select_2909}}}) : (equal_554 ? 3'h6 : {select_2917[0], select_2917});
  // hls/stages/agreement.hpp:608
  logic and_2922;
  assign and_2922 = select_2909 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:631
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2925;
  assign select_2925 = (plan_shift_q[5] & select_2909) ? value : 7'h0;
  logic [1:0] or_2926;
  assign or_2926 = {2{so}} | select_2925[5:4];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2930;
  assign or_2930 = (select_2909 ? plan_columns_q : 8'h0) | ((equal_2910 | equal_2915) ? whole_q : 8'h0);
  logic [1:0] or_2931;
  assign or_2931 = {2{and_2907}} | or_2930[3:2];
  // hls/stages/agreement.hpp:635
  logic [7:0] or_2933;
  assign or_2933 = {or_2930[7:4], or_2931, or_2930[1:0]} | (equal_554 ? drawn_q : 8'h0);
  logic [4:0] or_2934;
  assign or_2934 = {5{so}} | {or_2933[6], or_2933[3:0]};
  // hls/stages/agreement.hpp:641
  logic not_2938;
  assign not_2938 = ~run_shift_q[5];
  logic [7:0] select_2941;
  assign select_2941 = equal_569 ? ({{7{not_2938}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:524
  logic [6:0] select_2945;
  assign select_2945 = and_2894 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_2947;
  assign select_2947 = select_2897 ? {select_2945[6], select_2945} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2950;
  assign select_2950 = select_2897 ? (and_2894 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:521
  logic [6:0] select_2958;
  assign select_2958 = and_526 ? (equal_2893 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2961;
  assign select_2961 = and_526 ? (equal_2893 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2964;
  assign select_2964 = and_526 ? (equal_2893 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:532
  logic select_2975;
  assign select_2975 = (ends_cell_q | select_2897) ? (~(now == 3'h6)) : (equal_569 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:527
  logic and_2979;
  assign and_2979 = (~select_2897) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:477
  logic [6:0] sum_2980;
  assign sum_2980 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:461
  logic select_2982;
  assign select_2982 = equal_2893 ? ({sum_2980[6], cfg_height_i[8:3]} == {1'b0, sum_2980[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3341;
  assign select_3341 = and_2125 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3342;
  assign select_3342 = sample_pair_whole_q ? select_3341 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_3343;
  assign and_3343 = not_2129 & equal_2131;
  logic [8:0] select_3344;
  assign select_3344 = and_3343 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3345;
  assign select_3345 = and_3343 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3346;
  assign select_3346 = sample_pair_first_q ? select_3344 : select_3345;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3348;
  assign select_3348 = sample_pair_whole_q ? (and_2125 ? select_3346[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3350;
  assign select_3350 = sample_pair_whole_q ? (and_2125 ? select_3346[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3353;
  assign select_3353 = sample_pair_whole_q ? (equal_2133 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3355;
  assign select_3355 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2133}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3356;
  assign equal_3356 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3357;
  assign not_3357 = ~equal_3356;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3359;
  assign select_3359 = sample_pair_whole_q ? (phase + {not_3357, 1'b1, not_3357, equal_3356}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:471
  logic equal_3361;
  assign equal_3361 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3365;
  assign select_3365 = equal_3361 ? ((select_3342 == 4'h6) ? 4'h0 : (select_3342 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3366;
  assign equal_3366 = select_3365 == 4'h0;
  // hls/stages/agreement.hpp:461
  logic [3:0] select_3369;
  assign select_3369 = equal_2893 ? (equal_3366 ? 4'h6 : (select_3365 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3371;
  assign select_3371 = equal_3361 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] select_3373;
  assign select_3373 = equal_2893 ? (select_3371 + {4'h0, equal_3366}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:521
  logic select_3378;
  assign select_3378 = and_526 ? (equal_2893 ? ((6'h2 < row) & equal_3366) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3380;
  assign select_3380 = and_526 ? (equal_2893 ? select_3371 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_3404;
  assign or_3404 = select_492[0] | select_653[5];
  logic [7:0] sum_3405;
  assign sum_3405 = {1'b0, select_492[2:1], or_3404, select_653[4:1]} + 8'h1;
  logic less_3406;
  assign less_3406 = {sum_3405, select_653[0], select_505, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3409;
  assign select_3409 = and_2125 ? (and_2138 ? (~less_3406) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3448;
  assign or_3448 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3454;
  assign and_3454 = equal_2229 & not_2236;
  // hls/stages/patches.hpp:399
  logic and_3455;
  assign and_3455 = not_2290 & and_3454;
  logic [1:0] select_3457;
  assign select_3457 = equal_2231 ? 2'h0 : (equal_2233 ? 2'h3 : {equal_2234, and_3455});
  // hls/stages/patches.hpp:279
  logic equal_3459;
  assign equal_3459 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3460;
  assign not_3460 = ~equal_3459;
  // hls/stages/patches.hpp:279
  logic equal_3461;
  assign equal_3461 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3462;
  assign not_3462 = ~equal_3461;
  // hls/stages/patches.hpp:283
  logic not_3464;
  assign not_3464 = ~(patches_following_q == 3'h2);
  logic and_3467;
  assign and_3467 = (~(patches_following_q == 3'h1)) & not_3464;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3468;
  assign select_3468 = equal_3461 ? 2'h2 : {and_3467, not_3464};
  logic [3:0] select_3469;
  assign select_3469 = equal_3459 ? 4'h2 : {select_3468, {2{not_3462}}};
  // hls/stages/patches.hpp:405
  logic not_3472;
  assign not_3472 = ~or_3448;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3477;
  assign select_3477 = or_3448 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3479;
  assign select_3479 = or_3448 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_626;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_573;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_555 ? x_q[6:0] : (equal_569 ? sum_556[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_573;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_555 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_593;
  logic [62:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [61:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[61:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2230 & (not_2232 & (or_2235 & (equal_2234 & not_2236))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2273;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:776; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2230 & (not_2232 & (not_2290 & or_2235)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:787; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_2316;
  logic [32:0] patches_columns_above_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_word_q <= patches_columns_above_mem[patches_columns_above_raddr];
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
      raster_at_x_q <= sample_pair_whole_q ? (select_490 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2573;
      raster_at_column_q <= select_2575;
      raster_at_row_q <= select_2578;
      raster_at_live_q <= select_2582;
      raster_rows_left_q <= sample_pair_whole_q ? select_2584 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2588;
      averager_place_q <= sample_pair_whole_q ? select_496 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2901;
      run_last_shift_q <= select_2904;
      run_span_q <= select_2897 ? (and_2894 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2919;
      following_shift_q <= select_2909 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2922;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2925[6], or_2926, select_2925[3:0]};
      following_columns_q <= {or_2933[7], or_2934[4], or_2933[5:4], or_2934[3:0]};
      plan_shift_q <= equal_569 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2941;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2947;
      columns_left_q <= select_2950;
      last_q <= and_526 ? (equal_2893 ? column : last_q) : last_q;
      least_q <= select_2958;
      whole_q <= select_2961;
      drawn_q <= select_2964;
      age_q <= select_2897 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2897 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2975;
      ends_q <= and_2979;
      final_row_q <= and_526 ? select_2982 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3342;
      patches_band_rows_rows_to_next_q <= select_3348;
      patches_band_rows_number_q <= select_3350;
      patches_next_band_rows_to_next_q <= select_3353;
      patches_next_band_number_q <= select_3355;
      patches_first_band_rows_to_next_q <= select_3359;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3356 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_526 ? select_3369 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_526 ? select_3373 : patches_choosing_number_q;
      patches_chooses_q <= select_3378;
      patches_choosing_band_q <= select_3380;
      patches_capturing_q <= sample_pair_whole_q ? select_2265 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3409 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2259 : patches_row_q;
      patches_work_q <= or_3448 ? following : patches_work_q;
      patches_second_q <= not_2126 & (patches_second_q | (patches_ends_q & equal_2229));
      patches_following_q <= equal_2229 ? {2'h0, and_3454} : {equal_2231, select_3457};
      patches_following_beats_q <= {select_3469, not_3460};
      patches_begins_q <= sample_pair_whole_q & (and_2125 & and_2261);
      patches_ends_q <= not_3472 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3477;
      patches_code_row_q <= select_3479;
      patches_column_q <= or_3448 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3472 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_490_s1_q;
  logic [6:0] select_492_s1_q;
  logic [8:0] select_496_s1_q;
  logic and_500_s1_q;
  logic equal_506_s1_q;
  logic [6:0] column_s1_q;
  logic and_524_s1_q;
  logic and_526_s1_q;
  logic equal_550_s1_q;
  logic so_s1_q;
  logic equal_554_s1_q;
  logic or_555_s1_q;
  logic less_558_s1_q;
  logic not_559_s1_q;
  logic equal_569_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_593_s1_q;
  logic [6:0] right_s1_q;
  logic and_626_s1_q;
  logic [5:0] row_s1_q;
  logic and_2011_s1_q;
  logic equal_2012_s1_q;
  logic and_2125_s1_q;
  logic and_2138_s1_q;
  logic equal_2229_s1_q;
  logic not_2230_s1_q;
  logic equal_2231_s1_q;
  logic not_2232_s1_q;
  logic equal_2233_s1_q;
  logic equal_2234_s1_q;
  logic or_2235_s1_q;
  logic [4:0] select_2259_s1_q;
  logic select_2265_s1_q;
  logic [3:0] select_2306_s1_q;
  logic and_2316_s1_q;
  logic equal_2893_s1_q;
  logic and_2894_s1_q;
  logic or_3448_s1_q;
  logic not_3472_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
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
      select_490_s1_q <= select_490;
      select_492_s1_q <= select_492;
      select_496_s1_q <= select_496;
      and_500_s1_q <= and_500;
      equal_506_s1_q <= select_505 == 3'h0;
      column_s1_q <= column;
      and_524_s1_q <= and_524;
      and_526_s1_q <= and_526;
      equal_550_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_554_s1_q <= equal_554;
      or_555_s1_q <= or_555;
      less_558_s1_q <= less_558;
      not_559_s1_q <= not_559;
      equal_569_s1_q <= equal_569;
      x_s1_2_q <= x[6:0];
      select_593_s1_q <= select_593;
      right_s1_q <= right;
      and_626_s1_q <= and_626;
      row_s1_q <= row;
      and_2011_s1_q <= not_623 & and_592;
      equal_2012_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2125_s1_q <= and_2125;
      and_2138_s1_q <= and_2138;
      equal_2229_s1_q <= equal_2229;
      not_2230_s1_q <= not_2230;
      equal_2231_s1_q <= equal_2231;
      not_2232_s1_q <= not_2232;
      equal_2233_s1_q <= equal_2233;
      equal_2234_s1_q <= equal_2234;
      or_2235_s1_q <= or_2235;
      select_2259_s1_q <= select_2259;
      select_2265_s1_q <= select_2265;
      select_2306_s1_q <= select_2306;
      and_2316_s1_q <= and_2316;
      equal_2893_s1_q <= equal_2893;
      and_2894_s1_q <= and_2894;
      or_3448_s1_q <= or_3448;
      not_3472_s1_q <= not_3472;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
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
  logic and_501;
  assign and_501 = sample_pair_whole_s1_q & and_500_s1_q;
  // hls/stages/agreement.hpp:669
  logic equal_545;
  assign equal_545 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_546;
  assign equal_546 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic and_547;
  assign and_547 = equal_545 & equal_546;
  // hls/stages/moments.hpp:52
  logic [13:0] sum_548;
  assign sum_548 = moments_place_q + 14'h1;
  // hls/stages/agreement.hpp:1004
  logic [12:0] select_549;
  assign select_549 = and_547 ? 13'h0 : sum_548[12:0];
  // hls/stages/agreement.hpp:1010
  logic not_551;
  assign not_551 = ~equal_550_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_553;
  assign not_553 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_555_s1_q & not_559_s1_q;
  // hls/stages/moments.hpp:52
  logic [13:0] select_561;
  assign select_561 = and_547 ? 14'h0 : sum_548;
  // hls/stages/moments.hpp:54
  logic less_562;
  assign less_562 = 8'h4a < select_561[13:6];
  // hls/stages/moments.hpp:91
  logic not_563;
  assign not_563 = ~less_562;
  // hls/stages/agreement.hpp:789
  logic and_567;
  assign and_567 = not_551 & (not_553 & (equal_554_s1_q & (inside_v & not_563)));
  // hls/stages/agreement.hpp:976
  logic and_583;
  assign and_583 = (or_555_s1_q & (left_rdata_q[67] & not_559_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:967
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:968
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:969
  logic [6:0] select_602;
  assign select_602 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:669
  logic not_723;
  assign not_723 = ~equal_545;
  // hls/stages/agreement.hpp:672
  logic and_724;
  assign and_724 = left_rdata_q[12] & not_723;
  logic and_725;
  assign and_725 = left_rdata_q[30] & not_723;
  logic and_726;
  assign and_726 = left_rdata_q[48] & not_723;
  logic and_727;
  assign and_727 = left_rdata_q[66] & not_723;
  // hls/stages/agreement.hpp:673
  logic and_728;
  assign and_728 = right_codes_rdata_q[12] & not_723;
  logic and_729;
  assign and_729 = right_codes_rdata_q[27] & not_723;
  logic and_730;
  assign and_730 = right_codes_rdata_q[42] & not_723;
  logic and_731;
  assign and_731 = right_codes_rdata_q[57] & not_723;
  logic and_732;
  assign and_732 = right_codes_rdata_q[72] & not_723;
  logic and_733;
  assign and_733 = right_codes_rdata_q[85] & not_723;
  // hls/stages/agreement.hpp:221
  logic and_738;
  assign and_738 = left_rdata_q[48] & not_559_s1_q;
  logic and_739;
  assign and_739 = right_codes_rdata_q[42] & not_559_s1_q;
  logic [11:0] select_740;
  assign select_740 = less_558_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_741;
  assign select_741 = less_558_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_745;
  assign select_745 = and_738 ? (and_739 ? (~(select_740 ^ select_741)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_751;
  assign parity_751 = ^select_745[5:3];
  logic parity_754;
  assign parity_754 = ^select_745[8:6];
  logic parity_757;
  assign parity_757 = ^select_745[11:3];
  // hls/stages/agreement.hpp:221
  logic and_761;
  assign and_761 = left_rdata_q[66] & not_559_s1_q;
  logic and_762;
  assign and_762 = right_codes_rdata_q[57] & not_559_s1_q;
  logic [11:0] select_763;
  assign select_763 = less_558_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_764;
  assign select_764 = less_558_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_768;
  assign select_768 = and_761 ? (and_762 ? (~(select_763 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_771;
  assign parity_771 = ^select_768[8:6];
  logic parity_774;
  assign parity_774 = ^select_768[11:9];
  // hls/stages/agreement.hpp:221
  logic and_778;
  assign and_778 = left_rdata_q[84] & not_559_s1_q;
  logic and_779;
  assign and_779 = right_codes_rdata_q[72] & not_559_s1_q;
  logic [11:0] select_780;
  assign select_780 = less_558_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_781;
  assign select_781 = less_558_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_785;
  assign select_785 = and_778 ? (and_779 ? (~(select_780 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_791;
  assign parity_791 = ^select_785[2:0];
  logic parity_794;
  assign parity_794 = ^select_785[5:3];
  logic parity_797;
  assign parity_797 = ^select_785[8:0];
  logic parity_803;
  assign parity_803 = ^select_785[11:9];
  logic parity_806;
  assign parity_806 = ^select_768[2:0];
  logic parity_809;
  assign parity_809 = ^{select_785[11:9], select_768[5:0]};
  logic parity_812;
  assign parity_812 = ^{select_785, select_768, select_745[2:0]};
  logic xor_813;
  assign xor_813 = parity_757 ^ parity_812;
  // hls/stages/count_bits.hpp:23
  logic or_817;
  assign or_817 = (select_745[1:0] == 2'h3) | (select_745[2] & (select_745[0] | select_745[1]));
  // hls/stages/count_bits.hpp:25
  logic or_821;
  assign or_821 = (select_768[7:6] == 2'h3) | (select_768[8] & (select_768[6] | select_768[7]));
  logic or_825;
  assign or_825 = (select_768[10:9] == 2'h3) | (select_768[11] & (select_768[9] | select_768[10]));
  // hls/stages/count_bits.hpp:23
  logic or_833;
  assign or_833 = (select_785[7:6] == 2'h3) | (select_785[8] & (~(select_785[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_837;
  assign or_837 = (select_785[1:0] == 2'h3) | (select_785[2] & (select_785[0] | select_785[1]));
  logic or_841;
  assign or_841 = (select_785[4:3] == 2'h3) | (select_785[5] & (select_785[3] | select_785[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_844;
  assign parity_844 = ^{or_841, or_837, or_833};
  // hls/stages/count_bits.hpp:23
  logic or_848;
  assign or_848 = (select_768[4:3] == 2'h3) | (select_768[5] & (select_768[3] | select_768[4]));
  // hls/stages/count_bits.hpp:25
  logic or_852;
  assign or_852 = (select_785[10:9] == 2'h3) | (select_785[11] & (select_785[9] | select_785[10]));
  logic or_856;
  assign or_856 = (select_768[1:0] == 2'h3) | (select_768[2] & (select_768[0] | select_768[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_859;
  assign parity_859 = ^{or_856, or_852, or_848};
  logic parity_862;
  assign parity_862 = ^{or_856, or_852, or_848, or_841, or_837, or_833, or_825, or_821, or_817};
  // hls/stages/count_bits.hpp:25
  logic and_863;
  assign and_863 = parity_757 & parity_812;
  logic or_867;
  assign or_867 = (parity_751 & parity_754) | ((^select_745[11:9]) & (parity_751 | parity_754));
  logic and_870;
  assign and_870 = (^{select_768[11:6], select_745[2:0]}) & (parity_797 | parity_809);
  logic or_871;
  assign or_871 = (parity_797 & parity_809) | and_870;
  // hls/stages/count_bits.hpp:23
  logic or_878;
  assign or_878 = (select_745[10:9] == 2'h3) | (select_745[11] & (select_745[9] | select_745[10]));
  // hls/stages/count_bits.hpp:25
  logic or_882;
  assign or_882 = (select_745[4:3] == 2'h3) | (select_745[5] & (select_745[3] | select_745[4]));
  logic or_886;
  assign or_886 = (select_745[7:6] == 2'h3) | (select_745[8] & (select_745[6] | select_745[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_889;
  assign parity_889 = ^{or_886, or_882, or_878};
  // hls/stages/count_bits.hpp:25
  logic or_893;
  assign or_893 = (parity_771 & parity_774) | ((^select_745[2:0]) & (parity_771 | parity_774));
  logic or_897;
  assign or_897 = (parity_791 & parity_794) | ((^select_785[8:6]) & (parity_791 | parity_794));
  logic or_901;
  assign or_901 = (parity_803 & parity_806) | ((^select_768[5:3]) & (parity_803 | parity_806));
  // hls/stages/count_bits.hpp:24
  logic parity_904;
  assign parity_904 = ^{or_901, or_897, or_893};
  logic parity_907;
  assign parity_907 = ^{or_901, or_897, or_893, or_886, or_882, or_878, or_871, or_867, and_863};
  logic xor_908;
  assign xor_908 = parity_862 ^ parity_907;
  // hls/stages/count_bits.hpp:25
  logic and_909;
  assign and_909 = parity_862 & parity_907;
  logic or_913;
  assign or_913 = (parity_844 & parity_859) | ((^{or_825, or_821, or_817}) & (parity_844 | parity_859));
  logic or_917;
  assign or_917 = (parity_889 & parity_904) | ((^{or_871, or_867, and_863}) & (parity_889 | parity_904));
  logic or_924;
  assign or_924 = (or_821 & or_825) | (or_817 & (or_821 | or_825));
  logic or_928;
  assign or_928 = (or_837 & or_841) | (or_833 & (or_837 | or_841));
  logic or_932;
  assign or_932 = (or_852 & or_856) | (or_848 & (or_852 | or_856));
  // hls/stages/count_bits.hpp:24
  logic parity_935;
  assign parity_935 = ^{or_932, or_928, or_924};
  // hls/stages/count_bits.hpp:25
  logic or_939;
  assign or_939 = (or_867 & or_871) | (and_863 & (or_867 | or_871));
  logic or_943;
  assign or_943 = (or_882 & or_886) | (or_878 & (or_882 | or_886));
  logic or_947;
  assign or_947 = (or_897 & or_901) | (or_893 & (or_897 | or_901));
  // hls/stages/count_bits.hpp:24
  logic parity_950;
  assign parity_950 = ^{or_947, or_943, or_939};
  logic parity_953;
  assign parity_953 = ^{or_947, or_943, or_939, or_932, or_928, or_924, or_917, or_913, and_909};
  // hls/stages/count_bits.hpp:25
  logic or_957;
  assign or_957 = (parity_935 & parity_950) | ((^{or_917, or_913, and_909}) & (parity_935 | parity_950));
  logic or_961;
  assign or_961 = (or_913 & or_917) | (and_909 & (or_913 | or_917));
  logic or_965;
  assign or_965 = (or_928 & or_932) | (or_924 & (or_928 | or_932));
  logic or_969;
  assign or_969 = (or_943 & or_947) | (or_939 & (or_943 | or_947));
  // hls/stages/count_bits.hpp:24
  logic parity_974;
  assign parity_974 = ^{or_969, or_965, or_961, or_957};
  // hls/stages/count_bits.hpp:25
  logic or_978;
  assign or_978 = (or_965 & or_969) | (or_961 & (or_965 | or_969));
  logic and_979;
  assign and_979 = or_957 & (^{or_969, or_965, or_961});
  // hls/stages/count_bits.hpp:24
  logic xor_980;
  assign xor_980 = or_978 ^ and_979;
  // hls/stages/count_bits.hpp:27
  logic and_981;
  assign and_981 = or_978 & and_979;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_982;
  assign select_982 = equal_569_s1_q ? {and_981, xor_980, parity_974, parity_953, xor_908, xor_813} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_555_s1_q ? 6'h0 : select_982;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_984;
  assign select_984 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_985;
  assign difference_985 = {1'b0, column_2} - {1'b0, select_984};
  logic [7:0] sum_987;
  assign sum_987 = {difference_985[6], difference_985} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] select_991;
  assign select_991 = and_738 ? (and_762 ? (~(select_740 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_997;
  assign parity_997 = ^select_991[5:3];
  logic parity_1000;
  assign parity_1000 = ^select_991[8:6];
  logic parity_1003;
  assign parity_1003 = ^select_991[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1010;
  assign select_1010 = and_761 ? (and_779 ? (~(select_763 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1013;
  assign parity_1013 = ^select_1010[8:6];
  logic parity_1016;
  assign parity_1016 = ^select_1010[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1020;
  assign and_1020 = right_codes_rdata_q[85] & not_559_s1_q;
  logic [11:0] select_1021;
  assign select_1021 = less_558_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1025;
  assign select_1025 = and_778 ? (and_1020 ? (~(select_780 ^ select_1021)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1031;
  assign parity_1031 = ^select_1025[2:0];
  logic parity_1034;
  assign parity_1034 = ^select_1025[5:3];
  logic parity_1037;
  assign parity_1037 = ^select_1025[8:0];
  logic parity_1043;
  assign parity_1043 = ^select_1025[11:9];
  logic parity_1046;
  assign parity_1046 = ^select_1010[2:0];
  logic parity_1049;
  assign parity_1049 = ^{select_1025[11:9], select_1010[5:0]};
  logic parity_1052;
  assign parity_1052 = ^{select_1025, select_1010, select_991[2:0]};
  logic xor_1053;
  assign xor_1053 = parity_1003 ^ parity_1052;
  // hls/stages/count_bits.hpp:23
  logic or_1057;
  assign or_1057 = (select_991[1:0] == 2'h3) | (select_991[2] & (select_991[0] | select_991[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1061;
  assign or_1061 = (select_1010[7:6] == 2'h3) | (select_1010[8] & (select_1010[6] | select_1010[7]));
  logic or_1065;
  assign or_1065 = (select_1010[10:9] == 2'h3) | (select_1010[11] & (select_1010[9] | select_1010[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1073;
  assign or_1073 = (select_1025[7:6] == 2'h3) | (select_1025[8] & (~(select_1025[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1077;
  assign or_1077 = (select_1025[1:0] == 2'h3) | (select_1025[2] & (select_1025[0] | select_1025[1]));
  logic or_1081;
  assign or_1081 = (select_1025[4:3] == 2'h3) | (select_1025[5] & (select_1025[3] | select_1025[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1084;
  assign parity_1084 = ^{or_1081, or_1077, or_1073};
  // hls/stages/count_bits.hpp:23
  logic or_1088;
  assign or_1088 = (select_1010[4:3] == 2'h3) | (select_1010[5] & (select_1010[3] | select_1010[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1092;
  assign or_1092 = (select_1025[10:9] == 2'h3) | (select_1025[11] & (select_1025[9] | select_1025[10]));
  logic or_1096;
  assign or_1096 = (select_1010[1:0] == 2'h3) | (select_1010[2] & (select_1010[0] | select_1010[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1099;
  assign parity_1099 = ^{or_1096, or_1092, or_1088};
  logic parity_1102;
  assign parity_1102 = ^{or_1096, or_1092, or_1088, or_1081, or_1077, or_1073, or_1065, or_1061, or_1057};
  // hls/stages/count_bits.hpp:25
  logic and_1103;
  assign and_1103 = parity_1003 & parity_1052;
  logic or_1107;
  assign or_1107 = (parity_997 & parity_1000) | ((^select_991[11:9]) & (parity_997 | parity_1000));
  logic and_1110;
  assign and_1110 = (^{select_1010[11:6], select_991[2:0]}) & (parity_1037 | parity_1049);
  logic or_1111;
  assign or_1111 = (parity_1037 & parity_1049) | and_1110;
  // hls/stages/count_bits.hpp:23
  logic or_1118;
  assign or_1118 = (select_991[10:9] == 2'h3) | (select_991[11] & (select_991[9] | select_991[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1122;
  assign or_1122 = (select_991[4:3] == 2'h3) | (select_991[5] & (select_991[3] | select_991[4]));
  logic or_1126;
  assign or_1126 = (select_991[7:6] == 2'h3) | (select_991[8] & (select_991[6] | select_991[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1129;
  assign parity_1129 = ^{or_1126, or_1122, or_1118};
  // hls/stages/count_bits.hpp:25
  logic or_1133;
  assign or_1133 = (parity_1013 & parity_1016) | ((^select_991[2:0]) & (parity_1013 | parity_1016));
  logic or_1137;
  assign or_1137 = (parity_1031 & parity_1034) | ((^select_1025[8:6]) & (parity_1031 | parity_1034));
  logic or_1141;
  assign or_1141 = (parity_1043 & parity_1046) | ((^select_1010[5:3]) & (parity_1043 | parity_1046));
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^{or_1141, or_1137, or_1133};
  logic parity_1147;
  assign parity_1147 = ^{or_1141, or_1137, or_1133, or_1126, or_1122, or_1118, or_1111, or_1107, and_1103};
  logic xor_1148;
  assign xor_1148 = parity_1102 ^ parity_1147;
  // hls/stages/count_bits.hpp:25
  logic and_1149;
  assign and_1149 = parity_1102 & parity_1147;
  logic or_1153;
  assign or_1153 = (parity_1084 & parity_1099) | ((^{or_1065, or_1061, or_1057}) & (parity_1084 | parity_1099));
  logic or_1157;
  assign or_1157 = (parity_1129 & parity_1144) | ((^{or_1111, or_1107, and_1103}) & (parity_1129 | parity_1144));
  logic or_1164;
  assign or_1164 = (or_1061 & or_1065) | (or_1057 & (or_1061 | or_1065));
  logic or_1168;
  assign or_1168 = (or_1077 & or_1081) | (or_1073 & (or_1077 | or_1081));
  logic or_1172;
  assign or_1172 = (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
  // hls/stages/count_bits.hpp:24
  logic parity_1175;
  assign parity_1175 = ^{or_1172, or_1168, or_1164};
  // hls/stages/count_bits.hpp:25
  logic or_1179;
  assign or_1179 = (or_1107 & or_1111) | (and_1103 & (or_1107 | or_1111));
  logic or_1183;
  assign or_1183 = (or_1122 & or_1126) | (or_1118 & (or_1122 | or_1126));
  logic or_1187;
  assign or_1187 = (or_1137 & or_1141) | (or_1133 & (or_1137 | or_1141));
  // hls/stages/count_bits.hpp:24
  logic parity_1190;
  assign parity_1190 = ^{or_1187, or_1183, or_1179};
  logic parity_1193;
  assign parity_1193 = ^{or_1187, or_1183, or_1179, or_1172, or_1168, or_1164, or_1157, or_1153, and_1149};
  // hls/stages/count_bits.hpp:25
  logic or_1197;
  assign or_1197 = (parity_1175 & parity_1190) | ((^{or_1157, or_1153, and_1149}) & (parity_1175 | parity_1190));
  logic or_1201;
  assign or_1201 = (or_1153 & or_1157) | (and_1149 & (or_1153 | or_1157));
  logic or_1205;
  assign or_1205 = (or_1168 & or_1172) | (or_1164 & (or_1168 | or_1172));
  logic or_1209;
  assign or_1209 = (or_1183 & or_1187) | (or_1179 & (or_1183 | or_1187));
  // hls/stages/count_bits.hpp:24
  logic parity_1214;
  assign parity_1214 = ^{or_1209, or_1205, or_1201, or_1197};
  // hls/stages/count_bits.hpp:25
  logic or_1218;
  assign or_1218 = (or_1205 & or_1209) | (or_1201 & (or_1205 | or_1209));
  logic and_1219;
  assign and_1219 = or_1197 & (^{or_1209, or_1205, or_1201});
  // hls/stages/count_bits.hpp:24
  logic xor_1220;
  assign xor_1220 = or_1218 ^ and_1219;
  // hls/stages/count_bits.hpp:27
  logic and_1221;
  assign and_1221 = or_1218 & and_1219;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1222;
  assign select_1222 = equal_569_s1_q ? {and_1221, xor_1220, parity_1214, parity_1193, xor_1148, xor_1053} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_555_s1_q ? 6'h0 : select_1222;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1224;
  assign select_1224 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1225;
  assign difference_1225 = {1'b0, column_3} - {1'b0, select_1224};
  logic [7:0] sum_1227;
  assign sum_1227 = {difference_1225[6], difference_1225} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1228;
  assign and_1228 = right_codes_rdata_q[27] & not_559_s1_q;
  logic [11:0] select_1229;
  assign select_1229 = less_558_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1233;
  assign select_1233 = and_738 ? (and_1228 ? (~(select_740 ^ select_1229)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1239;
  assign parity_1239 = ^select_1233[5:3];
  logic parity_1242;
  assign parity_1242 = ^select_1233[8:6];
  logic parity_1245;
  assign parity_1245 = ^select_1233[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1252;
  assign select_1252 = and_761 ? (and_739 ? (~(select_763 ^ select_741)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1255;
  assign parity_1255 = ^select_1252[8:6];
  logic parity_1258;
  assign parity_1258 = ^select_1252[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1265;
  assign select_1265 = and_778 ? (and_762 ? (~(select_780 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1271;
  assign parity_1271 = ^select_1265[2:0];
  logic parity_1274;
  assign parity_1274 = ^select_1265[5:3];
  logic parity_1277;
  assign parity_1277 = ^select_1265[8:0];
  logic parity_1283;
  assign parity_1283 = ^select_1265[11:9];
  logic parity_1286;
  assign parity_1286 = ^select_1252[2:0];
  logic parity_1289;
  assign parity_1289 = ^{select_1265[11:9], select_1252[5:0]};
  logic parity_1292;
  assign parity_1292 = ^{select_1265, select_1252, select_1233[2:0]};
  logic xor_1293;
  assign xor_1293 = parity_1245 ^ parity_1292;
  // hls/stages/count_bits.hpp:23
  logic or_1297;
  assign or_1297 = (select_1233[1:0] == 2'h3) | (select_1233[2] & (select_1233[0] | select_1233[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1301;
  assign or_1301 = (select_1252[7:6] == 2'h3) | (select_1252[8] & (select_1252[6] | select_1252[7]));
  logic or_1305;
  assign or_1305 = (select_1252[10:9] == 2'h3) | (select_1252[11] & (select_1252[9] | select_1252[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1313;
  assign or_1313 = (select_1265[7:6] == 2'h3) | (select_1265[8] & (~(select_1265[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1317;
  assign or_1317 = (select_1265[1:0] == 2'h3) | (select_1265[2] & (select_1265[0] | select_1265[1]));
  logic or_1321;
  assign or_1321 = (select_1265[4:3] == 2'h3) | (select_1265[5] & (select_1265[3] | select_1265[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1324;
  assign parity_1324 = ^{or_1321, or_1317, or_1313};
  // hls/stages/count_bits.hpp:23
  logic or_1328;
  assign or_1328 = (select_1252[4:3] == 2'h3) | (select_1252[5] & (select_1252[3] | select_1252[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1332;
  assign or_1332 = (select_1265[10:9] == 2'h3) | (select_1265[11] & (select_1265[9] | select_1265[10]));
  logic or_1336;
  assign or_1336 = (select_1252[1:0] == 2'h3) | (select_1252[2] & (select_1252[0] | select_1252[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1339;
  assign parity_1339 = ^{or_1336, or_1332, or_1328};
  logic parity_1342;
  assign parity_1342 = ^{or_1336, or_1332, or_1328, or_1321, or_1317, or_1313, or_1305, or_1301, or_1297};
  // hls/stages/count_bits.hpp:25
  logic and_1343;
  assign and_1343 = parity_1245 & parity_1292;
  logic or_1347;
  assign or_1347 = (parity_1239 & parity_1242) | ((^select_1233[11:9]) & (parity_1239 | parity_1242));
  logic and_1350;
  assign and_1350 = (^{select_1252[11:6], select_1233[2:0]}) & (parity_1277 | parity_1289);
  logic or_1351;
  assign or_1351 = (parity_1277 & parity_1289) | and_1350;
  // hls/stages/count_bits.hpp:23
  logic or_1358;
  assign or_1358 = (select_1233[10:9] == 2'h3) | (select_1233[11] & (select_1233[9] | select_1233[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1362;
  assign or_1362 = (select_1233[4:3] == 2'h3) | (select_1233[5] & (select_1233[3] | select_1233[4]));
  logic or_1366;
  assign or_1366 = (select_1233[7:6] == 2'h3) | (select_1233[8] & (select_1233[6] | select_1233[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1369;
  assign parity_1369 = ^{or_1366, or_1362, or_1358};
  // hls/stages/count_bits.hpp:25
  logic or_1373;
  assign or_1373 = (parity_1255 & parity_1258) | ((^select_1233[2:0]) & (parity_1255 | parity_1258));
  logic or_1377;
  assign or_1377 = (parity_1271 & parity_1274) | ((^select_1265[8:6]) & (parity_1271 | parity_1274));
  logic or_1381;
  assign or_1381 = (parity_1283 & parity_1286) | ((^select_1252[5:3]) & (parity_1283 | parity_1286));
  // hls/stages/count_bits.hpp:24
  logic parity_1384;
  assign parity_1384 = ^{or_1381, or_1377, or_1373};
  logic parity_1387;
  assign parity_1387 = ^{or_1381, or_1377, or_1373, or_1366, or_1362, or_1358, or_1351, or_1347, and_1343};
  logic xor_1388;
  assign xor_1388 = parity_1342 ^ parity_1387;
  // hls/stages/count_bits.hpp:25
  logic and_1389;
  assign and_1389 = parity_1342 & parity_1387;
  logic or_1393;
  assign or_1393 = (parity_1324 & parity_1339) | ((^{or_1305, or_1301, or_1297}) & (parity_1324 | parity_1339));
  logic or_1397;
  assign or_1397 = (parity_1369 & parity_1384) | ((^{or_1351, or_1347, and_1343}) & (parity_1369 | parity_1384));
  logic or_1404;
  assign or_1404 = (or_1301 & or_1305) | (or_1297 & (or_1301 | or_1305));
  logic or_1408;
  assign or_1408 = (or_1317 & or_1321) | (or_1313 & (or_1317 | or_1321));
  logic or_1412;
  assign or_1412 = (or_1332 & or_1336) | (or_1328 & (or_1332 | or_1336));
  // hls/stages/count_bits.hpp:24
  logic parity_1415;
  assign parity_1415 = ^{or_1412, or_1408, or_1404};
  // hls/stages/count_bits.hpp:25
  logic or_1419;
  assign or_1419 = (or_1347 & or_1351) | (and_1343 & (or_1347 | or_1351));
  logic or_1423;
  assign or_1423 = (or_1362 & or_1366) | (or_1358 & (or_1362 | or_1366));
  logic or_1427;
  assign or_1427 = (or_1377 & or_1381) | (or_1373 & (or_1377 | or_1381));
  // hls/stages/count_bits.hpp:24
  logic parity_1430;
  assign parity_1430 = ^{or_1427, or_1423, or_1419};
  logic parity_1433;
  assign parity_1433 = ^{or_1427, or_1423, or_1419, or_1412, or_1408, or_1404, or_1397, or_1393, and_1389};
  // hls/stages/count_bits.hpp:25
  logic or_1437;
  assign or_1437 = (parity_1415 & parity_1430) | ((^{or_1397, or_1393, and_1389}) & (parity_1415 | parity_1430));
  logic or_1441;
  assign or_1441 = (or_1393 & or_1397) | (and_1389 & (or_1393 | or_1397));
  logic or_1445;
  assign or_1445 = (or_1408 & or_1412) | (or_1404 & (or_1408 | or_1412));
  logic or_1449;
  assign or_1449 = (or_1423 & or_1427) | (or_1419 & (or_1423 | or_1427));
  // hls/stages/count_bits.hpp:24
  logic parity_1454;
  assign parity_1454 = ^{or_1449, or_1445, or_1441, or_1437};
  // hls/stages/count_bits.hpp:25
  logic or_1458;
  assign or_1458 = (or_1445 & or_1449) | (or_1441 & (or_1445 | or_1449));
  logic and_1459;
  assign and_1459 = or_1437 & (^{or_1449, or_1445, or_1441});
  // hls/stages/count_bits.hpp:24
  logic xor_1460;
  assign xor_1460 = or_1458 ^ and_1459;
  // hls/stages/count_bits.hpp:27
  logic and_1461;
  assign and_1461 = or_1458 & and_1459;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1462;
  assign select_1462 = equal_569_s1_q ? {and_1461, xor_1460, parity_1454, parity_1433, xor_1388, xor_1293} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_555_s1_q ? 6'h0 : select_1462;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1464;
  assign select_1464 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1465;
  assign difference_1465 = {1'b0, column_4} - {1'b0, select_1464};
  logic [7:0] sum_1467;
  assign sum_1467 = {difference_1465[6], difference_1465} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1475;
  assign select_1475 = and_738 ? (and_779 ? (~(select_740 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1481;
  assign parity_1481 = ^select_1475[5:3];
  logic parity_1484;
  assign parity_1484 = ^select_1475[8:6];
  logic parity_1487;
  assign parity_1487 = ^select_1475[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1494;
  assign select_1494 = and_761 ? (and_1020 ? (~(select_763 ^ select_1021)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1497;
  assign parity_1497 = ^select_1494[8:6];
  logic parity_1500;
  assign parity_1500 = ^select_1494[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] xor_1506;
  assign xor_1506 = select_780 ^ (less_558_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1509;
  assign select_1509 = and_778 ? ((right_codes_rdata_q[98] & not_559_s1_q) ? (~xor_1506) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1515;
  assign parity_1515 = ^select_1509[2:0];
  logic parity_1518;
  assign parity_1518 = ^select_1509[5:3];
  logic parity_1521;
  assign parity_1521 = ^select_1509[8:0];
  logic parity_1527;
  assign parity_1527 = ^select_1509[11:9];
  logic parity_1530;
  assign parity_1530 = ^select_1494[2:0];
  logic parity_1533;
  assign parity_1533 = ^{select_1509[11:9], select_1494[5:0]};
  logic parity_1536;
  assign parity_1536 = ^{select_1509, select_1494, select_1475[2:0]};
  logic xor_1537;
  assign xor_1537 = parity_1487 ^ parity_1536;
  // hls/stages/count_bits.hpp:23
  logic or_1541;
  assign or_1541 = (select_1475[1:0] == 2'h3) | (select_1475[2] & (select_1475[0] | select_1475[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1545;
  assign or_1545 = (select_1494[7:6] == 2'h3) | (select_1494[8] & (select_1494[6] | select_1494[7]));
  logic or_1549;
  assign or_1549 = (select_1494[10:9] == 2'h3) | (select_1494[11] & (select_1494[9] | select_1494[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1557;
  assign or_1557 = (select_1509[7:6] == 2'h3) | (select_1509[8] & (~(select_1509[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1561;
  assign or_1561 = (select_1509[1:0] == 2'h3) | (select_1509[2] & (select_1509[0] | select_1509[1]));
  logic or_1565;
  assign or_1565 = (select_1509[4:3] == 2'h3) | (select_1509[5] & (select_1509[3] | select_1509[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1568;
  assign parity_1568 = ^{or_1565, or_1561, or_1557};
  // hls/stages/count_bits.hpp:23
  logic or_1572;
  assign or_1572 = (select_1494[4:3] == 2'h3) | (select_1494[5] & (select_1494[3] | select_1494[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1576;
  assign or_1576 = (select_1509[10:9] == 2'h3) | (select_1509[11] & (select_1509[9] | select_1509[10]));
  logic or_1580;
  assign or_1580 = (select_1494[1:0] == 2'h3) | (select_1494[2] & (select_1494[0] | select_1494[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1583;
  assign parity_1583 = ^{or_1580, or_1576, or_1572};
  logic parity_1586;
  assign parity_1586 = ^{or_1580, or_1576, or_1572, or_1565, or_1561, or_1557, or_1549, or_1545, or_1541};
  // hls/stages/count_bits.hpp:25
  logic and_1587;
  assign and_1587 = parity_1487 & parity_1536;
  logic or_1591;
  assign or_1591 = (parity_1481 & parity_1484) | ((^select_1475[11:9]) & (parity_1481 | parity_1484));
  logic and_1594;
  assign and_1594 = (^{select_1494[11:6], select_1475[2:0]}) & (parity_1521 | parity_1533);
  logic or_1595;
  assign or_1595 = (parity_1521 & parity_1533) | and_1594;
  // hls/stages/count_bits.hpp:23
  logic or_1602;
  assign or_1602 = (select_1475[10:9] == 2'h3) | (select_1475[11] & (select_1475[9] | select_1475[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1606;
  assign or_1606 = (select_1475[4:3] == 2'h3) | (select_1475[5] & (select_1475[3] | select_1475[4]));
  logic or_1610;
  assign or_1610 = (select_1475[7:6] == 2'h3) | (select_1475[8] & (select_1475[6] | select_1475[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1613;
  assign parity_1613 = ^{or_1610, or_1606, or_1602};
  // hls/stages/count_bits.hpp:25
  logic or_1617;
  assign or_1617 = (parity_1497 & parity_1500) | ((^select_1475[2:0]) & (parity_1497 | parity_1500));
  logic or_1621;
  assign or_1621 = (parity_1515 & parity_1518) | ((^select_1509[8:6]) & (parity_1515 | parity_1518));
  logic or_1625;
  assign or_1625 = (parity_1527 & parity_1530) | ((^select_1494[5:3]) & (parity_1527 | parity_1530));
  // hls/stages/count_bits.hpp:24
  logic parity_1628;
  assign parity_1628 = ^{or_1625, or_1621, or_1617};
  logic parity_1631;
  assign parity_1631 = ^{or_1625, or_1621, or_1617, or_1610, or_1606, or_1602, or_1595, or_1591, and_1587};
  logic xor_1632;
  assign xor_1632 = parity_1586 ^ parity_1631;
  // hls/stages/count_bits.hpp:25
  logic and_1633;
  assign and_1633 = parity_1586 & parity_1631;
  logic or_1637;
  assign or_1637 = (parity_1568 & parity_1583) | ((^{or_1549, or_1545, or_1541}) & (parity_1568 | parity_1583));
  logic or_1641;
  assign or_1641 = (parity_1613 & parity_1628) | ((^{or_1595, or_1591, and_1587}) & (parity_1613 | parity_1628));
  logic or_1648;
  assign or_1648 = (or_1545 & or_1549) | (or_1541 & (or_1545 | or_1549));
  logic or_1652;
  assign or_1652 = (or_1561 & or_1565) | (or_1557 & (or_1561 | or_1565));
  logic or_1656;
  assign or_1656 = (or_1576 & or_1580) | (or_1572 & (or_1576 | or_1580));
  // hls/stages/count_bits.hpp:24
  logic parity_1659;
  assign parity_1659 = ^{or_1656, or_1652, or_1648};
  // hls/stages/count_bits.hpp:25
  logic or_1663;
  assign or_1663 = (or_1591 & or_1595) | (and_1587 & (or_1591 | or_1595));
  logic or_1667;
  assign or_1667 = (or_1606 & or_1610) | (or_1602 & (or_1606 | or_1610));
  logic or_1671;
  assign or_1671 = (or_1621 & or_1625) | (or_1617 & (or_1621 | or_1625));
  // hls/stages/count_bits.hpp:24
  logic parity_1674;
  assign parity_1674 = ^{or_1671, or_1667, or_1663};
  logic parity_1677;
  assign parity_1677 = ^{or_1671, or_1667, or_1663, or_1656, or_1652, or_1648, or_1641, or_1637, and_1633};
  // hls/stages/count_bits.hpp:25
  logic or_1681;
  assign or_1681 = (parity_1659 & parity_1674) | ((^{or_1641, or_1637, and_1633}) & (parity_1659 | parity_1674));
  logic or_1685;
  assign or_1685 = (or_1637 & or_1641) | (and_1633 & (or_1637 | or_1641));
  logic or_1689;
  assign or_1689 = (or_1652 & or_1656) | (or_1648 & (or_1652 | or_1656));
  logic or_1693;
  assign or_1693 = (or_1667 & or_1671) | (or_1663 & (or_1667 | or_1671));
  // hls/stages/count_bits.hpp:24
  logic parity_1698;
  assign parity_1698 = ^{or_1693, or_1689, or_1685, or_1681};
  // hls/stages/count_bits.hpp:25
  logic or_1702;
  assign or_1702 = (or_1689 & or_1693) | (or_1685 & (or_1689 | or_1693));
  logic and_1703;
  assign and_1703 = or_1681 & (^{or_1693, or_1689, or_1685});
  // hls/stages/count_bits.hpp:24
  logic xor_1704;
  assign xor_1704 = or_1702 ^ and_1703;
  // hls/stages/count_bits.hpp:27
  logic and_1705;
  assign and_1705 = or_1702 & and_1703;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1706;
  assign select_1706 = equal_569_s1_q ? {and_1705, xor_1704, parity_1698, parity_1677, xor_1632, xor_1537} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_555_s1_q ? 6'h0 : select_1706;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1708;
  assign select_1708 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1709;
  assign difference_1709 = {1'b0, column_5} - {1'b0, select_1708};
  logic [7:0] sum_1711;
  assign sum_1711 = {difference_1709[6], difference_1709} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] not_1715;
  assign not_1715 = ~(select_740 ^ (less_558_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1717;
  assign select_1717 = and_738 ? ((right_codes_rdata_q[12] & not_559_s1_q) ? not_1715 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1723;
  assign parity_1723 = ^select_1717[5:3];
  logic parity_1726;
  assign parity_1726 = ^select_1717[8:6];
  logic parity_1729;
  assign parity_1729 = ^select_1717[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1736;
  assign select_1736 = and_761 ? (and_1228 ? (~(select_763 ^ select_1229)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1739;
  assign parity_1739 = ^select_1736[8:6];
  logic parity_1742;
  assign parity_1742 = ^select_1736[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1749;
  assign select_1749 = and_778 ? (and_739 ? (~(select_780 ^ select_741)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1755;
  assign parity_1755 = ^select_1749[2:0];
  logic parity_1758;
  assign parity_1758 = ^select_1749[5:3];
  logic parity_1761;
  assign parity_1761 = ^select_1749[8:0];
  logic parity_1767;
  assign parity_1767 = ^select_1749[11:9];
  logic parity_1770;
  assign parity_1770 = ^select_1736[2:0];
  logic parity_1773;
  assign parity_1773 = ^{select_1749[11:9], select_1736[5:0]};
  logic parity_1776;
  assign parity_1776 = ^{select_1749, select_1736, select_1717[2:0]};
  logic xor_1777;
  assign xor_1777 = parity_1729 ^ parity_1776;
  // hls/stages/count_bits.hpp:23
  logic or_1781;
  assign or_1781 = (select_1717[1:0] == 2'h3) | (select_1717[2] & (select_1717[0] | select_1717[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1785;
  assign or_1785 = (select_1736[7:6] == 2'h3) | (select_1736[8] & (select_1736[6] | select_1736[7]));
  logic or_1789;
  assign or_1789 = (select_1736[10:9] == 2'h3) | (select_1736[11] & (select_1736[9] | select_1736[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1797;
  assign or_1797 = (select_1749[7:6] == 2'h3) | (select_1749[8] & (~(select_1749[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1801;
  assign or_1801 = (select_1749[1:0] == 2'h3) | (select_1749[2] & (select_1749[0] | select_1749[1]));
  logic or_1805;
  assign or_1805 = (select_1749[4:3] == 2'h3) | (select_1749[5] & (select_1749[3] | select_1749[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1808;
  assign parity_1808 = ^{or_1805, or_1801, or_1797};
  // hls/stages/count_bits.hpp:23
  logic or_1812;
  assign or_1812 = (select_1736[4:3] == 2'h3) | (select_1736[5] & (select_1736[3] | select_1736[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1816;
  assign or_1816 = (select_1749[10:9] == 2'h3) | (select_1749[11] & (select_1749[9] | select_1749[10]));
  logic or_1820;
  assign or_1820 = (select_1736[1:0] == 2'h3) | (select_1736[2] & (select_1736[0] | select_1736[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1823;
  assign parity_1823 = ^{or_1820, or_1816, or_1812};
  logic parity_1826;
  assign parity_1826 = ^{or_1820, or_1816, or_1812, or_1805, or_1801, or_1797, or_1789, or_1785, or_1781};
  // hls/stages/count_bits.hpp:25
  logic and_1827;
  assign and_1827 = parity_1729 & parity_1776;
  logic or_1831;
  assign or_1831 = (parity_1723 & parity_1726) | ((^select_1717[11:9]) & (parity_1723 | parity_1726));
  logic and_1834;
  assign and_1834 = (^{select_1736[11:6], select_1717[2:0]}) & (parity_1761 | parity_1773);
  logic or_1835;
  assign or_1835 = (parity_1761 & parity_1773) | and_1834;
  // hls/stages/count_bits.hpp:23
  logic or_1842;
  assign or_1842 = (select_1717[10:9] == 2'h3) | (select_1717[11] & (select_1717[9] | select_1717[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1846;
  assign or_1846 = (select_1717[4:3] == 2'h3) | (select_1717[5] & (select_1717[3] | select_1717[4]));
  logic or_1850;
  assign or_1850 = (select_1717[7:6] == 2'h3) | (select_1717[8] & (select_1717[6] | select_1717[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1853;
  assign parity_1853 = ^{or_1850, or_1846, or_1842};
  // hls/stages/count_bits.hpp:25
  logic or_1857;
  assign or_1857 = (parity_1739 & parity_1742) | ((^select_1717[2:0]) & (parity_1739 | parity_1742));
  logic or_1861;
  assign or_1861 = (parity_1755 & parity_1758) | ((^select_1749[8:6]) & (parity_1755 | parity_1758));
  logic or_1865;
  assign or_1865 = (parity_1767 & parity_1770) | ((^select_1736[5:3]) & (parity_1767 | parity_1770));
  // hls/stages/count_bits.hpp:24
  logic parity_1868;
  assign parity_1868 = ^{or_1865, or_1861, or_1857};
  logic parity_1871;
  assign parity_1871 = ^{or_1865, or_1861, or_1857, or_1850, or_1846, or_1842, or_1835, or_1831, and_1827};
  logic xor_1872;
  assign xor_1872 = parity_1826 ^ parity_1871;
  // hls/stages/count_bits.hpp:25
  logic and_1873;
  assign and_1873 = parity_1826 & parity_1871;
  logic or_1877;
  assign or_1877 = (parity_1808 & parity_1823) | ((^{or_1789, or_1785, or_1781}) & (parity_1808 | parity_1823));
  logic or_1881;
  assign or_1881 = (parity_1853 & parity_1868) | ((^{or_1835, or_1831, and_1827}) & (parity_1853 | parity_1868));
  logic or_1888;
  assign or_1888 = (or_1785 & or_1789) | (or_1781 & (or_1785 | or_1789));
  logic or_1892;
  assign or_1892 = (or_1801 & or_1805) | (or_1797 & (or_1801 | or_1805));
  logic or_1896;
  assign or_1896 = (or_1816 & or_1820) | (or_1812 & (or_1816 | or_1820));
  // hls/stages/count_bits.hpp:24
  logic parity_1899;
  assign parity_1899 = ^{or_1896, or_1892, or_1888};
  // hls/stages/count_bits.hpp:25
  logic or_1903;
  assign or_1903 = (or_1831 & or_1835) | (and_1827 & (or_1831 | or_1835));
  logic or_1907;
  assign or_1907 = (or_1846 & or_1850) | (or_1842 & (or_1846 | or_1850));
  logic or_1911;
  assign or_1911 = (or_1861 & or_1865) | (or_1857 & (or_1861 | or_1865));
  // hls/stages/count_bits.hpp:24
  logic parity_1914;
  assign parity_1914 = ^{or_1911, or_1907, or_1903};
  logic parity_1917;
  assign parity_1917 = ^{or_1911, or_1907, or_1903, or_1896, or_1892, or_1888, or_1881, or_1877, and_1873};
  // hls/stages/count_bits.hpp:25
  logic or_1921;
  assign or_1921 = (parity_1899 & parity_1914) | ((^{or_1881, or_1877, and_1873}) & (parity_1899 | parity_1914));
  logic or_1925;
  assign or_1925 = (or_1877 & or_1881) | (and_1873 & (or_1877 | or_1881));
  logic or_1929;
  assign or_1929 = (or_1892 & or_1896) | (or_1888 & (or_1892 | or_1896));
  logic or_1933;
  assign or_1933 = (or_1907 & or_1911) | (or_1903 & (or_1907 | or_1911));
  // hls/stages/count_bits.hpp:24
  logic parity_1938;
  assign parity_1938 = ^{or_1933, or_1929, or_1925, or_1921};
  // hls/stages/count_bits.hpp:25
  logic or_1942;
  assign or_1942 = (or_1929 & or_1933) | (or_1925 & (or_1929 | or_1933));
  logic and_1943;
  assign and_1943 = or_1921 & (^{or_1933, or_1929, or_1925});
  // hls/stages/count_bits.hpp:24
  logic xor_1944;
  assign xor_1944 = or_1942 ^ and_1943;
  // hls/stages/count_bits.hpp:27
  logic and_1945;
  assign and_1945 = or_1942 & and_1943;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1946;
  assign select_1946 = equal_569_s1_q ? {and_1945, xor_1944, parity_1938, parity_1917, xor_1872, xor_1777} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_555_s1_q ? 6'h0 : select_1946;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1948;
  assign select_1948 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1949;
  assign difference_1949 = {1'b0, column_6} - {1'b0, select_1948};
  logic [7:0] sum_1951;
  assign sum_1951 = {difference_1949[6], difference_1949} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:789
  logic and_2022;
  assign and_2022 = ends_cell_s1_q & inside_v;
  logic and_2024;
  assign and_2024 = not_551 & (so_s1_q & and_2022);
  logic [6:0] select_2028;
  assign select_2028 = so_s1_q ? x_s1_q[6:0] : (or_555_s1_q ? (less_558_s1_q ? 7'h0 : select_602) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2032;
  assign or_2032 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2041;
  assign and_2041 = or_555_s1_q & (slot_s1_q[2] & not_559_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2157;
  assign select_2157 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2157[16:7])) ? 8'h7f : select_2157[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2234_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2234_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:496
  logic less_2322;
  assign less_2322 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:497
  logic or_2323;
  assign or_2323 = equal_2233_s1_q | less_2322;
  // hls/stages/patches.hpp:500
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2328;
  assign select_2328 = equal_2233_s1_q ? patches_column_s1_q[0] : (or_2323 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2329;
  assign not_2329 = ~or_2323;
  // hls/stages/patches.hpp:497
  logic [4:0] sum_2330;
  assign sum_2330 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:499
  logic [4:0] select_2333;
  assign select_2333 = or_2323 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2330) + 5'h1) : sum_2330;
  // hls/stages/patches.hpp:501
  logic [4:0] select_2334;
  assign select_2334 = equal_2233_s1_q ? 5'h0 : select_2333;
  logic or_2335;
  assign or_2335 = equal_2233_s1_q | equal_2231_s1_q;
  // hls/stages/patches.hpp:477
  logic equal_2337;
  assign equal_2337 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2339;
  assign equal_2339 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:479
  logic and_2341;
  assign and_2341 = of_row & (~equal_2339);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2337 ? 2'h3 : {equal_2339, and_2341};
  // hls/stages/patches.hpp:465
  logic [8:0] sum_2344;
  assign sum_2344 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2345;
  assign sum_2345 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2344, pixel_2[0]} - {1'b0, sum_2345, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:467
  logic [11:0] sum_2347;
  assign sum_2347 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2348;
  assign sum_2348 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2347[11], sum_2347};
  logic [13:0] sum_2349;
  assign sum_2349 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2348, down_2[1]};
  logic [12:0] sum_2350;
  assign sum_2350 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2349[13:1];
  logic [14:0] sum_2351;
  assign sum_2351 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2350, sum_2349[0], down_2[0]};
  // hls/stages/patches.hpp:463
  logic [8:0] sum_2354;
  assign sum_2354 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2355;
  assign sum_2355 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2354};
  logic [10:0] sum_2356;
  assign sum_2356 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2355, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2357;
  assign sum_2357 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2356[10:1];
  // hls/stages/patches.hpp:464
  logic [11:0] smooth;
  assign smooth = {sum_2357, sum_2356[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:466
  logic [12:0] sum_2359;
  assign sum_2359 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2360;
  assign sum_2360 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2361;
  assign difference_2361 = {1'b0, sum_2359, smooth[0]} - {1'b0, sum_2360, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:478
  logic or_2367;
  assign or_2367 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2339) | equal_2337;
  // hls/stages/patches.hpp:473
  logic and_2372;
  assign and_2372 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2376;
  assign and_2376 = not_2232_s1_q & (or_2235_s1_q & (or_2367 & (equal_2234_s1_q & and_2372)));
  // hls/stages/patches.hpp:172
  logic and_2386;
  assign and_2386 = (~(equal_2234_s1_q | (~and_2372))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2390;
  assign and_2390 = not_2232_s1_q & (or_2235_s1_q & (and_2386 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:542
  logic less_2392;
  assign less_2392 = patches_step_q[4:0] < 5'h11;
  logic equal_2393;
  assign equal_2393 = patches_step_q[6:5] == 2'h0;
  logic not_2394;
  assign not_2394 = ~equal_2393;
  logic equal_2395;
  assign equal_2395 = patches_step_q[6:5] == 2'h3;
  logic not_2396;
  assign not_2396 = ~equal_2395;
  // hls/stages/patches.hpp:556
  logic select_2399;
  assign select_2399 = equal_2395 ? (less_2392 & (less_2392 & not_2396)) : less_2392;
  // hls/stages/patches.hpp:184
  logic and_2402;
  assign and_2402 = equal_2229_s1_q & (less_2392 ? (not_2394 & select_2399) : select_2399);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2424;
  assign sum_2424 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:457
  logic [5:0] or_2707;
  assign or_2707 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2720;
  assign select_2720 = equal_554_s1_q ? (inside_v ? select_561 : moments_place_q) : moments_place_q;
  logic [13:0] select_2722;
  assign select_2722 = equal_550_s1_q ? moments_place_q : (so_s1_q ? moments_place_q : select_2720);
  // hls/stages/agreement.hpp:461
  logic select_2987;
  assign select_2987 = equal_2893_s1_q ? (~({row_s1_q, 1'b0} < {sum_2984, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:521
  logic and_3231;
  assign and_3231 = and_526_s1_q & (equal_2893_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3232;
  assign and_3232 = and_2894_s1_q & and_3231;
  // hls/stages/registration.hpp:127
  logic and_3234;
  assign and_3234 = and_2894_s1_q & (~and_3231);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3235;
  assign select_3235 = and_3234 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3237;
  assign select_3237 = and_3232 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3235[15]}}, select_3235});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3238;
  assign select_3238 = and_3234 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3238[15]}}, select_3238};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3240;
  assign select_3240 = and_3232 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3241;
  assign and_3241 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3241 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3487;
  assign select_3487 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3490;
  assign select_3490 = equal_2231_s1_q ? patches_smooth_values_0_q : (or_2235_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3492;
  assign select_3492 = or_2235_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3494;
  assign select_3494 = equal_2229_s1_q ? patches_smooth_values_1_q : (equal_2231_s1_q ? patches_smooth_values_1_q : select_3492);
  logic [11:0] select_3495;
  assign select_3495 = or_2235_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3497;
  assign select_3497 = equal_2229_s1_q ? patches_smooth_values_2_q : (equal_2231_s1_q ? patches_smooth_values_2_q : select_3495);
  logic [11:0] select_3498;
  assign select_3498 = or_2235_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3500;
  assign select_3500 = equal_2229_s1_q ? patches_smooth_values_3_q : (equal_2231_s1_q ? patches_smooth_values_3_q : select_3498);
  logic [10:0] select_3502;
  assign select_3502 = equal_2231_s1_q ? patches_down_values_0_q : (or_2235_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3505;
  assign select_3505 = equal_2231_s1_q ? patches_down_values_1_q : (or_2235_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3508;
  assign select_3508 = equal_2231_s1_q ? patches_down_values_2_q : (or_2235_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3511;
  assign select_3511 = equal_2231_s1_q ? patches_down_values_3_q : (or_2235_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3548;
  assign and_3548 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3553;
  assign select_3553 = or_3448_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3555;
  assign select_3555 = and_3548 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3911;
  assign select_3911 = equal_2229_s1_q ? patches_summed_down_by_q : (equal_2231_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:552
  logic and_3944;
  assign and_3944 = less_2392 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:556
  logic select_3947;
  assign select_3947 = equal_2395 ? (less_2392 ? (not_2396 & and_3944) : and_3944) : and_3944;
  // hls/stages/patches.hpp:184
  logic select_3950;
  assign select_3950 = equal_2229_s1_q ? (less_2392 ? (not_2394 & select_3947) : select_3947) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4291;
  assign select_4291 = so_s1_q ? (and_3241 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4293;
  assign sum_4293 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4294;
  assign select_4294 = sum_2424[5] ? {1'b1, sum_2424[4:0], region_across_rest_q[2:0]} : sum_4293;
  // hls/stages/agreement.hpp:461
  logic [8:0] select_4296;
  assign select_4296 = equal_2893_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4299;
  assign select_4299 = equal_2893_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_496_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_501;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
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
  assign census_memory_raddr = column_s1_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_526_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:106; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [4:0] moments_memory_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) moments_memory_mem[i] = 5'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_549;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_567;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_555_s1_q ? select_602 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_593_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_2024;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] left_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_turns_mem[i] = 3'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[6:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_2041;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_602;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2041;
  logic [2:0] right_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_word_q <= right_turns_mem[right_turns_raddr];
  end
  logic [1:0] right_turns_rdata_q;
  assign right_turns_rdata_q = right_turns_word_q[1:0];
  logic right_turns_read_q, right_turns_error;
  always_ff @(posedge clk_i) right_turns_read_q <= rst_ni & right_turns_re;
  assign right_turns_error = right_turns_read_q & ^right_turns_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2334, not_2329, select_2328};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2335;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:793; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_2230_s1_q & (new_row & equal_2231_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & and_2402;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1406; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2024;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
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
  assign left_we = s1_en & and_626_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_727, left_rdata_q[65:49], and_726, left_rdata_q[47:31], and_725, left_rdata_q[29:13], and_724, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_626_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_733, right_codes_rdata_q[84:73], and_732, right_codes_rdata_q[71:60], and_731, right_codes_rdata_q[56:43], and_730, right_codes_rdata_q[41:28], and_729, right_codes_rdata_q[26:13], and_728, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2316_s1_q;
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
      moments_place_q <= select_2722;
      row_q <= and_526_s1_q ? (equal_2893_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_526_s1_q ? select_2987 : lower_half_q;
      registration_slope_row_q <= select_3237;
      registration_slope_change_q <= select_3240;
      registration_slope_q <= so_s1_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3472_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3472_s1_q & select_3487;
      patches_smooth_values_0_q <= equal_2229_s1_q ? patches_smooth_values_0_q : select_3490;
      patches_smooth_values_1_q <= select_3494;
      patches_smooth_values_2_q <= select_3497;
      patches_smooth_values_3_q <= select_3500;
      patches_down_values_0_q <= equal_2229_s1_q ? patches_down_values_0_q : select_3502;
      patches_down_values_1_q <= equal_2229_s1_q ? patches_down_values_1_q : select_3505;
      patches_down_values_2_q <= equal_2229_s1_q ? patches_down_values_2_q : select_3508;
      patches_down_values_3_q <= equal_2229_s1_q ? patches_down_values_3_q : select_3511;
      patches_down_by_q <= or_3448_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3548});
      patches_along_q <= select_3553;
      patches_match_row_q <= or_3448_s1_q ? 4'h0 : select_3555;
      patches_summed_last_q <= not_2230_s1_q & (equal_2231_s1_q & and_3548);
      patches_summed_down_by_q <= select_3911;
      patches_step_q <= or_3448_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3950;
      region_across_rest_q <= select_4291;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4294;
      columns_begin_rest_q <= and_526_s1_q ? select_4296 : columns_begin_rest_q;
      columns_begin_back_q <= and_526_s1_q ? select_4299 : columns_begin_back_q;
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
      middle_sum_columns_values_0_q <= column_2;
      middle_sum_columns_values_1_q <= middle_sum_columns_values_0_q;
      middle_sum_columns_values_2_q <= middle_sum_columns_values_1_q;
      middle_sum_columns_values_3_q <= middle_sum_columns_values_2_q;
      middle_sum_columns_values_4_q <= middle_sum_columns_values_3_q;
      middle_sum_columns_values_5_q <= middle_sum_columns_values_4_q;
      middle_sum_columns_values_6_q <= middle_sum_columns_values_5_q;
      middle_sum_sum_sums_values_0_q <= sum_987;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1227;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1467;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1711;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1951;
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
  logic [2:0] select_490_s2_q;
  logic [6:0] select_492_s2_q;
  logic [8:0] select_496_s2_q;
  logic and_500_s2_q;
  logic and_501_s2_q;
  logic equal_506_s2_q;
  logic [6:0] column_s2_q;
  logic and_524_s2_q;
  logic and_526_s2_q;
  logic equal_546_s2_q;
  logic and_547_s2_q;
  logic [12:0] select_549_s2_q;
  logic equal_550_s2_q;
  logic not_551_s2_q;
  logic so_s2_q;
  logic not_553_s2_q;
  logic equal_554_s2_q;
  logic or_555_s2_q;
  logic less_558_s2_q;
  logic not_559_s2_q;
  logic inside_v_s2_q;
  logic less_562_s2_q;
  logic not_563_s2_q;
  logic and_567_s2_q;
  logic and_576_s2_q;
  logic and_584_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_615_s2_q;
  logic and_620_s2_q;
  logic and_622_s2_q;
  logic equal_655_s2_q;
  logic and_2011_s2_q;
  logic equal_2012_s2_q;
  logic and_2022_s2_q;
  logic and_2024_s2_q;
  logic [6:0] select_2028_s2_q;
  logic or_2032_s2_q;
  logic and_2125_s2_q;
  logic and_2138_s2_q;
  logic less_2152_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2229_s2_q;
  logic equal_2231_s2_q;
  logic equal_2234_s2_q;
  logic or_2235_s2_q;
  logic [4:0] select_2259_s2_q;
  logic select_2265_s2_q;
  logic [3:0] select_2306_s2_q;
  logic less_2322_s2_q;
  logic new_row_s2_q;
  logic or_2335_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_2352_s2_q;
  logic less_2353_s2_q;
  logic less_2362_s2_q;
  logic less_2363_s2_q;
  logic and_2377_s2_q;
  logic and_2386_s2_q;
  logic and_2391_s2_q;
  logic less_2392_s2_q;
  logic equal_2393_s2_q;
  logic not_2394_s2_q;
  logic equal_2395_s2_q;
  logic not_2396_s2_q;
  logic sum_2424_s2_q;
  logic and_2445_s2_q;
  logic and_2562_s2_q;
  logic equal_2708_s2_q;
  logic equal_2893_s2_q;
  logic and_3000_s2_q;
  logic equal_3085_s2_q;
  logic less_3524_s2_q;
  logic equal_3867_s2_q;
  logic equal_3951_s2_q;
  logic less_4279_s2_q;
  logic equal_4497_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
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
      select_490_s2_q <= select_490_s1_q;
      select_492_s2_q <= select_492_s1_q;
      select_496_s2_q <= select_496_s1_q;
      and_500_s2_q <= and_500_s1_q;
      and_501_s2_q <= and_501;
      equal_506_s2_q <= equal_506_s1_q;
      column_s2_q <= column_s1_q;
      and_524_s2_q <= and_524_s1_q;
      and_526_s2_q <= and_526_s1_q;
      equal_546_s2_q <= equal_546;
      and_547_s2_q <= and_547;
      select_549_s2_q <= select_549;
      equal_550_s2_q <= equal_550_s1_q;
      not_551_s2_q <= not_551;
      so_s2_q <= so_s1_q;
      not_553_s2_q <= not_553;
      equal_554_s2_q <= equal_554_s1_q;
      or_555_s2_q <= or_555_s1_q;
      less_558_s2_q <= less_558_s1_q;
      not_559_s2_q <= not_559_s1_q;
      inside_v_s2_q <= inside_v;
      less_562_s2_q <= less_562;
      not_563_s2_q <= not_563;
      and_567_s2_q <= and_567;
      and_576_s2_q <= or_555_s1_q & (left_rdata_q[70] & not_559_s1_q);
      and_584_s2_q <= (or_555_s1_q & (left_rdata_q[68] & not_559_s1_q)) & and_583;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_615_s2_q <= or_555_s1_q & (left_rdata_q[71] & not_559_s1_q);
      and_620_s2_q <= or_555_s1_q & (right_codes_rdata_q[58] & not_559_s1_q);
      and_622_s2_q <= or_555_s1_q & (right_codes_rdata_q[59] & not_559_s1_q);
      equal_655_s2_q <= row_s1_q == 6'h0;
      and_2011_s2_q <= and_2011_s1_q;
      equal_2012_s2_q <= equal_2012_s1_q;
      and_2022_s2_q <= and_2022;
      and_2024_s2_q <= and_2024;
      select_2028_s2_q <= select_2028;
      or_2032_s2_q <= or_2032;
      and_2125_s2_q <= and_2125_s1_q;
      and_2138_s2_q <= and_2138_s1_q;
      less_2152_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2229_s2_q <= equal_2229_s1_q;
      equal_2231_s2_q <= equal_2231_s1_q;
      equal_2234_s2_q <= equal_2234_s1_q;
      or_2235_s2_q <= or_2235_s1_q;
      select_2259_s2_q <= select_2259_s1_q;
      select_2265_s2_q <= select_2265_s1_q;
      select_2306_s2_q <= select_2306_s1_q;
      less_2322_s2_q <= less_2322;
      new_row_s2_q <= new_row;
      or_2335_s2_q <= or_2335;
      of_row_2_s2_q <= of_row_2;
      less_2352_s2_q <= $signed(15'h100) < $signed(sum_2351);
      less_2353_s2_q <= $signed(sum_2351[14:8]) < $signed(7'h7f);
      less_2362_s2_q <= $signed(15'h100) < $signed(difference_2361);
      less_2363_s2_q <= $signed(difference_2361[14:8]) < $signed(7'h7f);
      and_2377_s2_q <= not_2230_s1_q & and_2376;
      and_2386_s2_q <= and_2386;
      and_2391_s2_q <= not_2230_s1_q & and_2390;
      less_2392_s2_q <= less_2392;
      equal_2393_s2_q <= equal_2393;
      not_2394_s2_q <= not_2394;
      equal_2395_s2_q <= equal_2395;
      not_2396_s2_q <= not_2396;
      sum_2424_s2_q <= sum_2424[5];
      and_2445_s2_q <= or_555_s1_q & (left_rdata_q[69] & not_559_s1_q);
      and_2562_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2708_s2_q <= {column_s1_q[6], or_2707} == 7'h0;
      equal_2893_s2_q <= equal_2893_s1_q;
      and_3000_s2_q <= or_555_s1_q & (not_559_s1_q & and_583);
      equal_3085_s2_q <= shift == 6'h0;
      less_3524_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3867_s2_q <= patches_match_row_q == 4'h0;
      equal_3951_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4279_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4497_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic moments_out_of_step_q;
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
  logic [11:0] select_504;
  assign select_504 = select_490_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_508;
  assign sum_508 = select_504 + (equal_506_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_510;
  assign sum_510 = {4'h0, sample_pair_pixel_1_q} + (select_490_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_512;
  assign sum_512 = sum_510 + (equal_506_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_490_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_516;
  assign and_516 = whole & (averager_memory_rdata_q[24] | equal_506_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_490_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_520;
  assign and_520 = all_of_skin & (averager_memory_rdata_q[25] | equal_506_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_500_s2_q ? sum_508[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_529;
  assign equal_529 = select_490_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_529 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_532;
  assign select_532 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_500_s2_q ? sum_512[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_529 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_536;
  assign select_536 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_537;
  assign and_537 = and_500_s2_q & and_516;
  // hls/stages/census.hpp:127
  logic select_539;
  assign select_539 = equal_529 ? and_537 : (averager_mask_q & and_537);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_539;
  // hls/stages/census.hpp:207
  logic and_541;
  assign and_541 = and_500_s2_q & and_520;
  // hls/stages/census.hpp:127
  logic select_543;
  assign select_543 = equal_529 ? and_541 : (averager_of_skin_q & and_541);
  // hls/stages/agreement.hpp:276
  logic and_544;
  assign and_544 = sample_pair_whole_s2_q & select_543;
  // hls/stages/agreement.hpp:979
  logic select_597;
  assign select_597 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:980
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:993
  logic [8:0] difference_607;
  assign difference_607 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:994
  logic [9:0] sum_608;
  assign sum_608 = {difference_607[8], difference_607} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_610;
  assign and_610 = (and_584_s2_q & select_597) & ({{22{sum_608[9]}}, sum_608} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_612;
  assign and_612 = or_555_s2_q & (not_559_s2_q & and_610);
  // hls/stages/moments.hpp:64
  logic and_613;
  assign and_613 = and_576_s2_q & and_612;
  // hls/stages/census.hpp:296
  logic less_628;
  assign less_628 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_629;
  assign less_629 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_630;
  assign less_630 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_631;
  assign less_631 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_632;
  assign less_632 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_633;
  assign less_633 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_634;
  assign less_634 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_635;
  assign less_635 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_636;
  assign less_636 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_637;
  assign less_637 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_638;
  assign less_638 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_639;
  assign less_639 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_640;
  assign less_640 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_641;
  assign less_641 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_642;
  assign less_642 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_643;
  assign less_643 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_644;
  assign less_644 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_645;
  assign less_645 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_646;
  assign less_646 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_647;
  assign less_647 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_648;
  assign less_648 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_649;
  assign less_649 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_650;
  assign less_650 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_651;
  assign less_651 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:456
  logic equal_652;
  assign equal_652 = column_s2_q == 7'h0;
  logic [3:0] select_656;
  assign select_656 = equal_655_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:457
  logic [4:0] select_657;
  assign select_657 = equal_652 ? {select_656, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_658;
  assign select_658 = equal_652 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_659;
  assign and_659 = select_657[4] & select_658[3];
  // hls/stages/census.hpp:288
  logic and_661;
  assign and_661 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_663;
  assign and_663 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_661);
  // hls/stages/agreement.hpp:457
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_663;
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
  logic [9:0] difference_686;
  assign difference_686 = {1'b0, select_532} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_687;
  assign xor_687 = difference_686[8:0] ^ {9{difference_686[9]}};
  logic [9:0] sum_688;
  assign sum_688 = {9'h0, difference_686[9]} + {1'b0, xor_687};
  logic [9:0] difference_689;
  assign difference_689 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_690;
  assign xor_690 = difference_689[8:0] ^ {9{difference_689[9]}};
  logic [9:0] sum_691;
  assign sum_691 = {9'h0, difference_689[9]} + {1'b0, xor_690};
  logic [9:0] difference_693;
  assign difference_693 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_694;
  assign xor_694 = difference_693[8:0] ^ {9{difference_693[9]}};
  logic [9:0] sum_695;
  assign sum_695 = {9'h0, difference_693[9]} + {1'b0, xor_694};
  logic [10:0] sum_696;
  assign sum_696 = ({1'b0, sum_688} + {1'b0, sum_691}) + {1'b0, sum_695};
  logic [9:0] difference_697;
  assign difference_697 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_698;
  assign xor_698 = difference_697[8:0] ^ {9{difference_697[9]}};
  logic [9:0] sum_699;
  assign sum_699 = {9'h0, difference_697[9]} + {1'b0, xor_698};
  logic [9:0] difference_701;
  assign difference_701 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_702;
  assign xor_702 = difference_701[8:0] ^ {9{difference_701[9]}};
  // hls/stages/agreement.hpp:457
  logic and_710;
  assign and_710 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_711;
  assign and_711 = and_659 & and_710;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_713;
  assign sum_713 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_715;
  assign and_715 = and_711 & ({{5{sum_713[6]}}, sum_713, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_719;
  assign sum_719 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:808
  logic or_735;
  assign or_735 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:809
  logic select_737;
  assign select_737 = or_735 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:752
  logic less_1468;
  assign less_1468 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1469;
  assign select_1469 = less_1468 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1470;
  assign less_1470 = middle_sum_sum_sums_values_0_q < select_1469;
  logic [7:0] select_1471;
  assign select_1471 = less_1470 ? select_1469 : middle_sum_sum_sums_values_0_q;
  logic less_1952;
  assign less_1952 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1953;
  assign select_1953 = less_1952 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1954;
  assign less_1954 = select_1471 < select_1953;
  // hls/stages/agreement.hpp:802
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1954 ? select_1953 : select_1471) : 8'h0;
  // hls/stages/agreement.hpp:809
  logic or_1958;
  assign or_1958 = select_737 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:814
  logic [5:0] select_1959;
  assign select_1959 = or_1958 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:753
  logic or_1961;
  assign or_1961 = less_1468 | (~less_1470);
  logic [2:0] select_1962;
  assign select_1962 = less_1954 ? {less_1952, 2'h0} : {1'b0, or_1961, less_1470};
  // hls/stages/agreement.hpp:814
  logic [2:0] select_1963;
  assign select_1963 = or_1958 ? select_1962 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1964;
  assign select_1964 = or_1958 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:811
  logic equal_1965;
  assign equal_1965 = select_1962 == 3'h1;
  logic or_1968;
  assign or_1968 = equal_1965 | (~(select_1962 == 3'h2));
  logic [7:0] select_1970;
  assign select_1970 = or_1968 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1971;
  assign select_1971 = equal_1965 ? (or_1968 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1970;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1972;
  assign select_1972 = or_1958 ? select_1971 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1973;
  assign select_1973 = or_1968 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1975;
  assign select_1975 = or_1958 ? (equal_1965 ? select_1970 : select_1973) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1977;
  assign sum_1977 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1978;
  assign sum_1978 = {1'b0, before_v} + sum_1977;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1980;
  assign sum_1980 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1981;
  assign sum_1981 = {1'b0, before_v_2} + sum_1980;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1983;
  assign sum_1983 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1984;
  assign sum_1984 = {1'b0, before_v_3} + sum_1983;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1986;
  assign select_1986 = (sum_1981 < sum_1984) ? sum_1984 : sum_1981;
  logic [6:0] select_1988;
  assign select_1988 = (sum_1978 < select_1986) ? select_1986 : sum_1978;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1990;
  assign sum_1990 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1991;
  assign sum_1991 = {1'b0, before_v_4} + sum_1990;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1993;
  assign sum_1993 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1994;
  assign sum_1994 = {1'b0, before_v_5} + sum_1993;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1996;
  assign select_1996 = (sum_1991 < sum_1994) ? sum_1994 : sum_1991;
  // hls/stages/agreement.hpp:803
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1988 < select_1996) ? select_1996 : select_1988) : 7'h0;
  // hls/stages/agreement.hpp:814
  logic less_2000;
  assign less_2000 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:818
  logic [6:0] select_2002;
  assign select_2002 = select_737 ? of_near : (less_2000 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2004;
  assign select_2004 = select_737 ? run_shift_s2_q : (less_2000 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2007;
  assign select_2007 = (run_shift_s2_q == 6'h3f) ? of_best : (select_737 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:819
  logic [7:0] select_2010;
  assign select_2010 = (run_shift_s2_q == 6'h1) ? of_best : (select_737 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:824
  logic select_2013;
  assign select_2013 = or_735 ? shift_first_s2_q : equal_2012_s2_q;
  // hls/stages/agreement.hpp:825
  logic or_2015;
  assign or_2015 = select_2013 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_2016;
  assign select_2016 = or_2015 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2017;
  assign select_2017 = or_2015 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2019;
  assign or_2019 = select_2013 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:833
  logic [6:0] select_2020;
  assign select_2020 = or_2019 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2021;
  assign select_2021 = or_2019 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2035;
  assign and_2035 = or_555_s2_q & (not_559_s2_q & (and_610 & or_2032_s2_q));
  // hls/stages/agreement.hpp:789
  logic and_2036;
  assign and_2036 = not_553_s2_q & and_2035;
  logic and_2039;
  assign and_2039 = not_551_s2_q & (so_s2_q ? and_2022_s2_q : (equal_554_s2_q & and_612));
  // hls/stages/moments.hpp:60
  logic and_2043;
  assign and_2043 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1004
  logic and_2044;
  assign and_2044 = not_563_s2_q & and_2043;
  logic and_2046;
  assign and_2046 = and_2043 & (moments_memory_rdata_q[1] ^ and_615_s2_q);
  logic and_2047;
  assign and_2047 = not_563_s2_q & and_2046;
  // hls/stages/agreement.hpp:789
  logic and_2050;
  assign and_2050 = not_551_s2_q & (not_553_s2_q & (equal_554_s2_q & inside_v_s2_q));
  // hls/stages/moments.hpp:60
  logic and_2052;
  assign and_2052 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1004
  logic and_2053;
  assign and_2053 = not_563_s2_q & and_2052;
  // hls/stages/moments.hpp:61
  logic and_2055;
  assign and_2055 = and_2052 & (moments_memory_rdata_q[3] ^ and_622_s2_q);
  // hls/stages/agreement.hpp:1004
  logic and_2056;
  assign and_2056 = not_563_s2_q & and_2055;
  // hls/stages/agreement.hpp:1129
  logic equal_2057;
  assign equal_2057 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1179
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1130
  logic [1:0] select_2060;
  assign select_2060 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1143
  logic [3:0] select_2062;
  assign select_2062 = equal_2057 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2060});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2063;
  assign sum_2063 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_2064;
  assign select_2064 = equal_550_s2_q ? select_2062 : {sum_2063, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_2065;
  assign equal_2065 = x_s2_q[5:0] == 6'h3f;
  logic equal_2067;
  assign equal_2067 = x_s2_q[5:0] == 6'h3e;
  logic equal_2069;
  assign equal_2069 = x_s2_q[5:0] == 6'h3d;
  logic equal_2071;
  assign equal_2071 = x_s2_q[5:0] == 6'h3c;
  logic equal_2073;
  assign equal_2073 = x_s2_q[5:0] == 6'h3b;
  logic equal_2075;
  assign equal_2075 = x_s2_q[5:0] == 6'h36;
  logic equal_2077;
  assign equal_2077 = x_s2_q[5:0] == 6'h35;
  logic equal_2079;
  assign equal_2079 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1179
  logic and_2083;
  assign and_2083 = (~equal_2073) & ((~equal_2075) & ((~equal_2077) & (~equal_2079)));
  logic and_2087;
  assign and_2087 = (~equal_2065) & ((~equal_2067) & ((~equal_2069) & ((~equal_2071) & and_2083)));
  // hls/stages/agreement.hpp:1130
  logic less_2088;
  assign less_2088 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2092;
  assign or_2092 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1010
  logic [5:0] sum_2097;
  assign sum_2097 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2097, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2103;
  assign sum_2103 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2105;
  assign and_2105 = half_ends & ({{3{sum_2103[4]}}, sum_2103} < 8'h3);
  // hls/stages/agreement.hpp:789
  logic and_2106;
  assign and_2106 = so_s2_q & and_2105;
  logic select_2107;
  assign select_2107 = equal_550_s2_q ? (x_s2_q[6] & (equal_2057 ? and_2087 : (less_2088 & (~or_2092)))) : and_2106;
  // hls/stages/registration.hpp:258
  logic not_2109;
  assign not_2109 = ~lower_half_s2_q;
  logic [3:0] select_2110;
  assign select_2110 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2109, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2109};
  // hls/stages/patches.hpp:373
  logic [1:0] select_2139;
  assign select_2139 = and_2138_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2140;
  assign select_2140 = and_2138_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2141;
  assign select_2141 = and_2125_s2_q ? {select_2140, select_2139[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2142;
  assign select_2142 = and_2125_s2_q ? select_2139 : patches_fetch_q;
  logic equal_2143;
  assign equal_2143 = select_2142 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:789
  logic and_2151;
  assign and_2151 = not_551_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2153;
  assign equal_2153 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_555_s2_q ? (less_558_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2153 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2161;
  assign select_2161 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2162;
  assign select_2162 = b[1] ? a : 8'h0;
  logic [8:0] sum_2163;
  assign sum_2163 = {{2{select_2161[6]}}, select_2161} + {select_2162[7], select_2162};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2164;
  assign select_2164 = b[2] ? a : 8'h0;
  logic [7:0] select_2165;
  assign select_2165 = b[3] ? a : 8'h0;
  logic [8:0] sum_2166;
  assign sum_2166 = {{2{select_2164[7]}}, select_2164[7:1]} + {select_2165[7], select_2165};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2167;
  assign sum_2167 = {{3{sum_2163[8]}}, sum_2163[8:1]} + {sum_2166[8], sum_2166, select_2164[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2168;
  assign select_2168 = b[4] ? a : 8'h0;
  logic [7:0] select_2169;
  assign select_2169 = b[5] ? a : 8'h0;
  logic [8:0] difference_2170;
  assign difference_2170 = {{2{select_2168[7]}}, select_2168[7:1]} - {select_2169[7], select_2169};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2171;
  assign sum_2171 = {difference_2170, select_2168[0]} + {sum_2167[10], sum_2167[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2153 ? {sum_2171, sum_2167[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2173;
  assign sum_2173 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2176;
  assign and_2176 = less_2152_s2_q & (and_612 & ({{4{sum_2173[9]}}, sum_2173, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2180;
  assign and_2180 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2186;
  assign sum_2186 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2188;
  assign sum_2188 = {sum_2186[9], sum_2186[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1019
  logic and_2191;
  assign and_2191 = ($signed(9'h0) < $signed(sum_2186[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2188, sum_2186[0]})));
  logic and_2192;
  assign and_2192 = (~(and_2180 | (equal_546_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2191;
  // hls/stages/agreement.hpp:789
  logic and_2196;
  assign and_2196 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2176 & and_2192)));
  logic and_2197;
  assign and_2197 = not_551_s2_q & and_2196;
  // hls/stages/patches.hpp:156
  logic and_2199;
  assign and_2199 = and_2197 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_2200;
  assign select_2200 = and_2199 ? and_2197 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2203;
  assign select_2203 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2205;
  assign select_2205 = and_2199 ? (equal_550_s2_q ? 8'h0 : select_2203) : patches_choice_column_q;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_2208;
  assign select_2208 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_2210;
  assign select_2210 = and_2199 ? (equal_550_s2_q ? 6'h0 : select_2208) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2211;
  assign sum_2211 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2171[9]}}, sum_2171[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2214;
  assign select_2214 = ($signed(sum_2211[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2211[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2153 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2211[12:7])) ? 8'h7f : select_2214);
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2219;
  assign select_2219 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2221;
  assign select_2221 = and_2199 ? (equal_550_s2_q ? 8'h0 : select_2219) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2222;
  assign equal_2222 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:789
  logic and_2226;
  assign and_2226 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2180 | equal_2222)));
  logic and_2227;
  assign and_2227 = not_551_s2_q & and_2226;
  // hls/stages/patches.hpp:344
  logic and_2228;
  assign and_2228 = patches_chooses_s2_q & and_2227;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2242;
  assign select_2242 = and_2125_s2_q ? select_2140 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_2243;
  assign equal_2243 = {patches_choosing_band_s2_q, and_2151} == {select_2242, select_2142[1]};
  // hls/stages/patches.hpp:482
  logic [2:0] sum_2343;
  assign sum_2343 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:486
  logic [1:0] sum_2381;
  assign sum_2381 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2411;
  assign select_2411 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1051
  logic or_2414;
  assign or_2414 = select_2411[7] | (~({select_2411[5], select_2411[3], select_2411[1]} == 3'h0));
  // hls/stages/agreement.hpp:1050
  logic or_2417;
  assign or_2417 = select_2411[7] | (~({select_2411[6], select_2411[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2420;
  assign or_2420 = select_2411[7] | (~(select_2411[6:4] == 3'h0));
  // hls/stages/agreement.hpp:789
  logic [5:0] select_2421;
  assign select_2421 = equal_550_s2_q ? x_s2_q[5:0] : {region_row_q, or_2420, or_2417, or_2414};
  // hls/stages/agreement.hpp:1129
  logic not_2422;
  assign not_2422 = ~equal_2057;
  // hls/stages/agreement.hpp:1059
  logic or_2426;
  assign or_2426 = (~sum_2424_s2_q) | equal_2222;
  // hls/stages/agreement.hpp:789
  logic and_2429;
  assign and_2429 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2426));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_555_s2_q & (not_559_s2_q & and_584_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_612;
  // hls/stages/agreement.hpp:149
  logic and_2447;
  assign and_2447 = or_555_s2_q & (not_559_s2_q & and_2445_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2456;
  assign and_2456 = inside_v_s2_q & and_2447;
  // hls/stages/agreement.hpp:1015
  logic select_2457;
  assign select_2457 = slot_s2_q[2] ? shown_shown_q : and_612;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2457);
  // hls/stages/agreement.hpp:1015
  logic select_2460;
  assign select_2460 = slot_s2_q[2] ? shown_nearer_q : and_2035;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2457 ? select_2460 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1276
  logic or_2463;
  assign or_2463 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1278
  logic [16:0] select_2465;
  assign select_2465 = marks_first_s2_q ? 17'h1 : (or_2463 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1277
  logic [8:0] select_2467;
  assign select_2467 = or_2463 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1285
  logic select_2469;
  assign select_2469 = cfg_compete_i ? (or_2463 & select_2465[16]) : (select_2467[8] & select_2465[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2469 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1292
  logic [6:0] select_2472;
  assign select_2472 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2474;
  assign select_2474 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2472});
  // hls/stages/agreement.hpp:1302
  logic equal_2475;
  assign equal_2475 = seen_x_q == 3'h7;
  logic [7:0] select_2477;
  assign select_2477 = select_2469 ? 8'h0 : (seen_column_q + {7'h0, equal_2475});
  // hls/stages/agreement.hpp:1309
  logic [12:0] index;
  assign index = select_2474 + {5'h0, select_2477};
  // hls/stages/agreement.hpp:1276
  logic select_2480;
  assign select_2480 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1262
  logic [7:0] sum_2481;
  assign sum_2481 = {1'b0, select_2480, 2'h0, select_2480, 1'b0, {2{select_2480}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1275
  logic not_2482;
  assign not_2482 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2484;
  assign and_2484 = not_2482 & (began_q | select_2469);
  // hls/stages/agreement.hpp:1303
  logic [2:0] select_2486;
  assign select_2486 = select_2469 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1308
  logic and_2488;
  assign and_2488 = and_2484 & (select_2486 == 3'h0);
  logic less_2489;
  assign less_2489 = select_2477 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1112
  logic [7:0] sum_2492;
  assign sum_2492 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2492[7]}}, sum_2492, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1262
  logic [7:0] sum_2494;
  assign sum_2494 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1031
  logic and_2495;
  assign and_2495 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2496;
  assign and_2496 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2497;
  assign and_2497 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2498;
  assign and_2498 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2500;
  assign sum_2500 = {1'b0, and_2497} + ({1'b0, textured} + {1'b0, and_2498});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2495} + ({2'h0, and_2496} + {1'b0, sum_2500});
  // hls/stages/agreement.hpp:1031
  logic [7:0] select_2509;
  assign select_2509 = inside_v_s2_q ? (sum_2424_s2_q ? select_2411 : {select_2411[6:0], 1'b0}) : select_2411;
  // hls/stages/agreement.hpp:1051
  logic or_2512;
  assign or_2512 = select_2509[7] | (~({select_2509[5], select_2509[3], select_2509[1]} == 3'h0));
  // hls/stages/agreement.hpp:1031
  logic and_2529;
  assign and_2529 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2530;
  assign and_2530 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2531;
  assign and_2531 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2532;
  assign and_2532 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2534;
  assign sum_2534 = {1'b0, and_2531} + ({1'b0, shown} + {1'b0, and_2532});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2529} + ({2'h0, and_2530} + {1'b0, sum_2534});
  // hls/stages/agreement.hpp:1031
  logic and_2545;
  assign and_2545 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2546;
  assign and_2546 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2547;
  assign and_2547 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2548;
  assign and_2548 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1091
  logic [1:0] sum_2550;
  assign sum_2550 = {1'b0, and_2547} + ({1'b0, near} + {1'b0, and_2548});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2545} + ({2'h0, and_2546} + {1'b0, sum_2550});
  // hls/stages/agreement.hpp:789
  logic and_2566;
  assign and_2566 = ends_cell_s2_q & (and_2562_s2_q & (~({sum_2097, last_s2_q[1:0]} < x_s2_q)));
  logic and_2568;
  assign and_2568 = not_551_s2_q & (so_s2_q & and_2566);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2600;
  assign select_2600 = sample_pair_whole_s2_q ? (and_524_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2602;
  assign select_2602 = sample_pair_whole_s2_q ? (and_524_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2621;
  assign select_2621 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2623;
  assign select_2623 = sample_pair_whole_s2_q ? (and_524_s2_q ? select_539 : averager_mask_q) : averager_mask_q;
  logic select_2625;
  assign select_2625 = sample_pair_whole_s2_q ? (and_524_s2_q ? select_543 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:521
  logic [8:0] select_2626;
  assign select_2626 = and_526_s2_q ? select_532 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2627;
  assign select_2627 = and_526_s2_q ? select_536 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2629;
  assign select_2629 = and_526_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2630;
  assign select_2630 = and_526_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2631;
  assign select_2631 = and_526_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2632;
  assign select_2632 = and_526_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2633;
  assign select_2633 = and_526_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2634;
  assign select_2634 = and_526_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2635;
  assign select_2635 = and_526_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2636;
  assign select_2636 = and_526_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2637;
  assign select_2637 = and_526_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2638;
  assign select_2638 = and_526_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2639;
  assign select_2639 = and_526_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2640;
  assign select_2640 = and_526_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2641;
  assign select_2641 = and_526_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2642;
  assign select_2642 = and_526_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2643;
  assign select_2643 = and_526_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2644;
  assign select_2644 = and_526_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2645;
  assign select_2645 = and_526_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2646;
  assign select_2646 = and_526_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2647;
  assign select_2647 = and_526_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2648;
  assign select_2648 = and_526_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2649;
  assign select_2649 = and_526_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2650;
  assign select_2650 = and_526_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2651;
  assign select_2651 = and_526_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2652;
  assign select_2652 = and_526_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2653;
  assign select_2653 = and_526_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2654;
  assign select_2654 = and_526_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2655;
  assign select_2655 = and_526_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2656;
  assign select_2656 = and_526_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2657;
  assign select_2657 = and_526_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2658;
  assign select_2658 = and_526_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2659;
  assign select_2659 = and_526_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2660;
  assign select_2660 = and_526_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2661;
  assign select_2661 = and_526_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2662;
  assign select_2662 = and_526_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2663;
  assign select_2663 = and_526_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2664;
  assign select_2664 = and_526_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2665;
  assign select_2665 = and_526_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2666;
  assign select_2666 = and_526_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2667;
  assign select_2667 = and_526_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2668;
  assign select_2668 = and_526_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2669;
  assign select_2669 = and_526_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2670;
  assign select_2670 = and_526_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2671;
  assign select_2671 = and_526_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2672;
  assign select_2672 = and_526_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2673;
  assign select_2673 = and_526_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_526_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_526_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2676;
  assign select_2676 = and_526_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2677;
  assign select_2677 = and_526_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2678;
  assign select_2678 = and_526_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2679;
  assign select_2679 = and_526_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2680;
  assign select_2680 = and_526_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2681;
  assign select_2681 = and_526_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2683;
  assign difference_2683 = {1'b0, select_536} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2684;
  assign xor_2684 = difference_2683[8:0] ^ {9{difference_2683[9]}};
  logic [9:0] sum_2685;
  assign sum_2685 = {9'h0, difference_2683[9]} + {1'b0, xor_2684};
  logic [9:0] difference_2686;
  assign difference_2686 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2687;
  assign xor_2687 = difference_2686[8:0] ^ {9{difference_2686[9]}};
  logic [9:0] sum_2688;
  assign sum_2688 = {9'h0, difference_2686[9]} + {1'b0, xor_2687};
  logic [9:0] difference_2690;
  assign difference_2690 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2691;
  assign xor_2691 = difference_2690[8:0] ^ {9{difference_2690[9]}};
  logic [9:0] sum_2692;
  assign sum_2692 = {9'h0, difference_2690[9]} + {1'b0, xor_2691};
  logic [10:0] sum_2693;
  assign sum_2693 = ({1'b0, sum_2685} + {1'b0, sum_2688}) + {1'b0, sum_2692};
  logic [9:0] difference_2694;
  assign difference_2694 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2695;
  assign xor_2695 = difference_2694[8:0] ^ {9{difference_2694[9]}};
  logic [9:0] sum_2696;
  assign sum_2696 = {9'h0, difference_2694[9]} + {1'b0, xor_2695};
  logic [9:0] difference_2698;
  assign difference_2698 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2699;
  assign xor_2699 = difference_2698[8:0] ^ {9{difference_2698[9]}};
  // hls/stages/agreement.hpp:1004
  logic [13:0] select_2725;
  assign select_2725 = less_562_s2_q ? moments_turned_0_q : ({13'h0, and_2046} + (and_547_s2_q ? 14'h0 : moments_turned_0_q));
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2727;
  assign select_2727 = equal_554_s2_q ? (inside_v_s2_q ? select_2725 : moments_turned_0_q) : moments_turned_0_q;
  logic [13:0] select_2729;
  assign select_2729 = equal_550_s2_q ? moments_turned_0_q : (so_s2_q ? moments_turned_0_q : select_2727);
  // hls/stages/agreement.hpp:1004
  logic [13:0] select_2732;
  assign select_2732 = less_562_s2_q ? moments_turned_1_q : ({13'h0, and_2055} + (and_547_s2_q ? 14'h0 : moments_turned_1_q));
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2734;
  assign select_2734 = equal_554_s2_q ? (inside_v_s2_q ? select_2732 : moments_turned_1_q) : moments_turned_1_q;
  logic [13:0] select_2736;
  assign select_2736 = equal_550_s2_q ? moments_turned_1_q : (so_s2_q ? moments_turned_1_q : select_2734);
  // hls/stages/agreement.hpp:1149
  logic equal_2737;
  assign equal_2737 = x_s2_q[6:0] == 7'h7f;
  logic equal_2738;
  assign equal_2738 = x_s2_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2740;
  assign select_2740 = equal_2737 ? moments_before_0_q : (equal_2738 ? moments_turned_0_q : moments_before_0_q);
  logic [13:0] select_2743;
  assign select_2743 = equal_2737 ? moments_before_1_q : (equal_2738 ? moments_turned_1_q : moments_before_1_q);
  logic select_2746;
  assign select_2746 = equal_2737 ? moments_has_before_q : (moments_has_before_q | equal_2738);
  // hls/stages/moments.hpp:74
  logic [13:0] select_2749;
  assign select_2749 = (moments_before_1_q < moments_before_0_q) ? moments_before_0_q : moments_before_1_q;
  // hls/stages/moments.hpp:104
  logic [14:0] sum_2751;
  assign sum_2751 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2753;
  assign sum_2753 = {1'b0, moments_turned_0_q} + 15'h3;
  logic less_2754;
  assign less_2754 = {3'h0, counts_turned_right_q[13:2]} < sum_2753;
  logic [14:0] sum_2756;
  assign sum_2756 = {1'b0, moments_most_before_q} + 15'h3;
  logic not_2758;
  assign not_2758 = ~({3'h0, counts_turned_right_q[13:2]} < sum_2756);
  // hls/stages/moments.hpp:79
  logic or_2761;
  assign or_2761 = not_2758 | (~({3'h0, moments_before_0_q[13:2]} < sum_2753));
  // hls/stages/moments.hpp:104
  logic not_2764;
  assign not_2764 = ~({3'h0, counts_turned_left_q[13:2]} < sum_2756);
  // hls/stages/moments.hpp:79
  logic or_2767;
  assign or_2767 = not_2764 | (~({3'h0, moments_before_1_q[13:2]} < sum_2751));
  // hls/stages/moments.hpp:80
  logic select_2770;
  assign select_2770 = ({3'h0, counts_turned_left_q[13:2]} < sum_2751) ? ((~less_2754) & or_2761) : ((less_2754 | or_2767) ? or_2767 : or_2761);
  // hls/stages/moments.hpp:82
  logic select_2775;
  assign select_2775 = cfg_same_table_i ? (select_2770 | (moments_out_of_step_q & (~(not_2764 & not_2758)))) : moments_out_of_step_q;
  // hls/stages/agreement.hpp:789
  logic select_2778;
  assign select_2778 = equal_2737 ? moments_out_of_step_q : (equal_2738 ? (cfg_prove_i & select_2775) : moments_out_of_step_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2790;
  assign difference_2790 = {1'b0, select_532} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2790[9]} + (difference_2790[8:0] ^ {9{difference_2790[9]}});
  logic [9:0] difference_2802;
  assign difference_2802 = {1'b0, select_536} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2802[9]} + (difference_2802[8:0] ^ {9{difference_2802[9]}});
  // hls/stages/agreement.hpp:789
  logic not_2990;
  assign not_2990 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2991;
  assign less_2991 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:521
  logic and_2998;
  assign and_2998 = and_526_s2_q & (equal_655_s2_q & equal_2893_s2_q);
  // hls/stages/agreement.hpp:789
  logic and_3004;
  assign and_3004 = not_551_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3000_s2_q)));
  // hls/stages/agreement.hpp:1031
  logic and_3024;
  assign and_3024 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3025;
  assign and_3025 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3026;
  assign and_3026 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3027;
  assign and_3027 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_3029;
  assign sum_3029 = {1'b0, and_3026} + ({1'b0, explained} + {1'b0, and_3027});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3024} + ({2'h0, and_3025} + {1'b0, sum_3029});
  // hls/stages/agreement.hpp:789
  logic and_3065;
  assign and_3065 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3000_s2_q & and_2447)));
  // hls/stages/agreement.hpp:987
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:988
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:989
  logic [7:0] difference_3089;
  assign difference_3089 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3092;
  assign less_3092 = {2'h0, difference_3089[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3095;
  assign and_3095 = not_559_s2_q & (((and_2445_s2_q & and_610) & equal_3085_s2_q) & (~less_3092));
  // hls/stages/agreement.hpp:789
  logic and_3099;
  assign and_3099 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_555_s2_q & and_3095)));
  // hls/stages/agreement.hpp:149
  logic and_3104;
  assign and_3104 = not_559_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3106;
  assign and_3106 = not_559_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3107;
  assign select_3107 = or_555_s2_q ? {and_3106, and_3104} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3109;
  assign select_3109 = less_558_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3110;
  assign select_3110 = or_555_s2_q ? select_3109 : 2'h0;
  // hls/stages/agreement.hpp:1028
  logic and_3112;
  assign and_3112 = and_612 & (select_3107[0] & select_3110[0]);
  // hls/stages/agreement.hpp:789
  logic and_3116;
  assign and_3116 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3107[1] & and_3112)));
  logic and_3117;
  assign and_3117 = not_551_s2_q & and_3116;
  logic and_3123;
  assign and_3123 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3110[1] & and_3112)));
  logic and_3124;
  assign and_3124 = not_551_s2_q & and_3123;
  // hls/stages/registration.hpp:76
  logic less_3127;
  assign less_3127 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3129;
  assign select_3129 = or_555_s2_q ? (less_558_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3131;
  assign select_3131 = or_555_s2_q ? (less_558_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3133;
  assign select_3133 = or_555_s2_q ? (less_558_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3131} - {1'b0, select_3133};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3135;
  assign select_3135 = rise_2[8] ? select_3131 : select_3133;
  logic [8:0] fall;
  assign fall = {1'b0, select_3129} - {1'b0, select_3135};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3138;
  assign not_3138 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3127 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3138};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3140;
  assign xor_3140 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3140};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3146;
  assign select_3146 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3127 ? {taken, 1'b1} : {not_3138, select_3146, not_3138};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3148;
  assign sum_3148 = {left, 1'b1} + {taken_2, less_3127};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3150;
  assign select_3150 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3152;
  assign select_3152 = equal_550_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3154;
  assign select_3154 = equal_550_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3155;
  assign equal_3155 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3159;
  assign and_3159 = and_612 & less_2152_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3161;
  assign select_3161 = or_555_s2_q ? (less_558_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3165;
  assign sum_3165 = select_3161[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3168;
  assign select_3168 = (select_3131 < select_3133) ? ({sum_3165, select_3161[0], 5'h0} - {3'h0, select_3150}) : {sum_3165, select_3161[0], select_3150};
  logic [7:0] select_3169;
  assign select_3169 = ((select_3161 == 3'h0) | (select_3161 == 3'h4)) ? {sum_3165, select_3161[0], 5'h0} : select_3168;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3169[7]}}, select_3169} - {sum_2171[9], sum_2171, sum_2167[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3172;
  assign select_3172 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3172[11:7])) ? 12'h7f : select_3172;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3193;
  assign difference_3193 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3195;
  assign and_3195 = and_3159 & ($signed(difference_3193) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3208;
  assign less_3208 = $signed(difference_3193) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:789
  logic select_3216;
  assign select_3216 = so_s2_q ? (equal_3155 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3219;
  assign select_3219 = so_s2_q ? (equal_2153 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3224;
  assign select_3224 = (sum_2063 == 2'h2) ? (registration_fresh_q & (~select_2110)) : registration_fresh_q;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_3226;
  assign select_3226 = so_s2_q ? (and_2105 ? select_3224 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3228;
  assign select_3228 = and_2998 ? 4'hf : (equal_550_s2_q ? registration_fresh_q : select_3226);
  // hls/stages/agreement.hpp:1130
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2060;
  // hls/stages/registration.hpp:258
  logic not_3249;
  assign not_3249 = ~quarter_2[1];
  logic [3:0] select_3250;
  assign select_3250 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3249, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3249};
  // hls/stages/patches.hpp:91
  logic parity_3384;
  assign parity_3384 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:461
  logic [15:0] select_3385;
  assign select_3385 = equal_2893_s2_q ? {patches_chance_q[14:0], parity_3384} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_3387;
  assign not_3387 = ~and_2227;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3390;
  assign select_3390 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3390};
  // hls/stages/agreement.hpp:789
  logic and_3396;
  assign and_3396 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3400;
  assign and_3400 = not_3387 & (patches_fixed_q | ((not_551_s2_q & and_3396) & and_2199));
  // hls/stages/patches.hpp:354
  logic not_3413;
  assign not_3413 = ~select_2142[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3415;
  assign select_3415 = sample_pair_whole_s2_q ? (equal_2143 ? select_2142 : {not_3413, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:518
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3514;
  assign select_3514 = or_2235_s2_q ? {less_2363_s2_q, less_2362_s2_q, less_2353_s2_q, less_2352_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3516;
  assign select_3516 = equal_2229_s2_q ? patches_codes_at_q : (equal_2231_s2_q ? other[55:4] : select_3514);
  // hls/stages/patches.hpp:501
  logic [27:0] word;
  assign word = or_2335_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [27:0] select_3519;
  assign select_3519 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3521;
  assign select_3521 = equal_2231_s2_q ? (new_row_s2_q ? word : select_3519) : patches_codes_further_q;
  // hls/stages/patches.hpp:519
  logic [55:0] select_3523;
  assign select_3523 = less_2322_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:489
  logic [55:0] select_3525;
  assign select_3525 = less_3524_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3527;
  assign select_3527 = or_2235_s2_q ? (equal_2234_s2_q ? patches_next_codes_q : select_3525) : patches_next_codes_q;
  logic [55:0] select_3529;
  assign select_3529 = equal_2229_s2_q ? patches_next_codes_q : (equal_2231_s2_q ? select_3523 : select_3527);
  // hls/stages/count_bits.hpp:24
  logic parity_3534;
  assign parity_3534 = ^{less_2363_s2_q, less_2362_s2_q, less_2353_s2_q, less_2352_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3538;
  assign or_3538 = ({less_2353_s2_q, less_2352_s2_q} == 2'h3) | (less_2362_s2_q & (less_2353_s2_q | less_2352_s2_q));
  logic and_3539;
  assign and_3539 = less_2363_s2_q & (^{less_2362_s2_q, less_2353_s2_q, less_2352_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3540;
  assign xor_3540 = or_3538 ^ and_3539;
  // hls/stages/count_bits.hpp:27
  logic and_3541;
  assign and_3541 = or_3538 & and_3539;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3543;
  assign select_3543 = or_2235_s2_q ? (and_2386_s2_q ? {and_3541, xor_3540, parity_3534} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3547;
  assign sum_3547 = {7'h0, patches_set_q} + (equal_2234_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:518
  logic [47:0] select_3557;
  assign select_3557 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3559;
  assign select_3559 = equal_2229_s2_q ? patches_left_row_q : (equal_2231_s2_q ? select_3557 : patches_left_row_q);
  // hls/stages/patches.hpp:520
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3557;
  // hls/stages/count_bits.hpp:24
  logic xor_3563;
  assign xor_3563 = bits[17] ^ (^{select_3557[16:15], other[16:15]});
  logic xor_3566;
  assign xor_3566 = bits[11] ^ (^{select_3557[10:9], other[10:9]});
  logic xor_3569;
  assign xor_3569 = bits[14] ^ (^{select_3557[13:12], other[13:12]});
  logic xor_3572;
  assign xor_3572 = xor_3563 ^ (^{select_3557[14:9], other[14:9]});
  logic xor_3575;
  assign xor_3575 = bits[47] ^ (^{select_3557[46:45], other[46:45]});
  logic xor_3578;
  assign xor_3578 = bits[8] ^ (^{select_3557[7:6], other[7:6]});
  logic xor_3581;
  assign xor_3581 = bits[2] ^ (^{select_3557[1:0], other[1:0]});
  logic xor_3584;
  assign xor_3584 = bits[5] ^ (^{select_3557[4:3], other[4:3]});
  logic xor_3587;
  assign xor_3587 = xor_3578 ^ (^{select_3557[5:0], other[5:0]});
  logic parity_3589;
  assign parity_3589 = ^{select_3557[47:45], select_3557[8:0], other[47:45], other[8:0]};
  logic xor_3590;
  assign xor_3590 = xor_3572 ^ parity_3589;
  logic xor_3593;
  assign xor_3593 = bits[44] ^ (^{select_3557[43:42], other[43:42]});
  logic xor_3596;
  assign xor_3596 = bits[38] ^ (^{select_3557[37:36], other[37:36]});
  logic xor_3599;
  assign xor_3599 = bits[41] ^ (^{select_3557[40:39], other[40:39]});
  logic xor_3605;
  assign xor_3605 = bits[26] ^ (^{select_3557[25:24], other[25:24]});
  logic xor_3608;
  assign xor_3608 = bits[20] ^ (^{select_3557[19:18], other[19:18]});
  logic xor_3611;
  assign xor_3611 = bits[23] ^ (^{select_3557[22:21], other[22:21]});
  logic xor_3614;
  assign xor_3614 = xor_3605 ^ (^{select_3557[23:18], other[23:18]});
  logic xor_3617;
  assign xor_3617 = bits[35] ^ (^{select_3557[34:33], other[34:33]});
  logic xor_3620;
  assign xor_3620 = bits[29] ^ (^{select_3557[28:27], other[28:27]});
  logic xor_3623;
  assign xor_3623 = bits[32] ^ (^{select_3557[31:30], other[31:30]});
  logic xor_3626;
  assign xor_3626 = xor_3617 ^ (^{select_3557[32:27], other[32:27]});
  logic xor_3627;
  assign xor_3627 = xor_3614 ^ xor_3626;
  // hls/stages/count_bits.hpp:25
  logic or_3635;
  assign or_3635 = (xor_3566 & xor_3569) | (xor_3563 & (xor_3566 | xor_3569));
  logic or_3639;
  assign or_3639 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3643;
  assign or_3643 = (xor_3581 & xor_3584) | (xor_3578 & (xor_3581 | xor_3584));
  // hls/stages/count_bits.hpp:23
  logic or_3650;
  assign or_3650 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3654;
  assign or_3654 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3658;
  assign or_3658 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3661;
  assign parity_3661 = ^{or_3658, or_3654, or_3650};
  // hls/stages/count_bits.hpp:23
  logic or_3665;
  assign or_3665 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3669;
  assign or_3669 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3673;
  assign or_3673 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3676;
  assign parity_3676 = ^{or_3673, or_3669, or_3665};
  logic parity_3679;
  assign parity_3679 = ^{or_3673, or_3669, or_3665, or_3658, or_3654, or_3650, or_3643, or_3639, or_3635};
  // hls/stages/count_bits.hpp:23
  logic or_3683;
  assign or_3683 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3687;
  assign or_3687 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3691;
  assign or_3691 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3699;
  assign or_3699 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3703;
  assign or_3703 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3707;
  assign or_3707 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3710;
  assign parity_3710 = ^{or_3707, or_3703, or_3699};
  // hls/stages/count_bits.hpp:23
  logic or_3714;
  assign or_3714 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3718;
  assign or_3718 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3722;
  assign or_3722 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3725;
  assign parity_3725 = ^{or_3722, or_3718, or_3714};
  logic parity_3728;
  assign parity_3728 = ^{or_3722, or_3718, or_3714, or_3707, or_3703, or_3699, or_3691, or_3687, or_3683};
  // hls/stages/count_bits.hpp:25
  logic or_3732;
  assign or_3732 = (xor_3596 & xor_3599) | (xor_3593 & (xor_3596 | xor_3599));
  logic or_3736;
  assign or_3736 = (xor_3608 & xor_3611) | (xor_3605 & (xor_3608 | xor_3611));
  logic or_3740;
  assign or_3740 = (xor_3620 & xor_3623) | (xor_3617 & (xor_3620 | xor_3623));
  // hls/stages/count_bits.hpp:24
  logic parity_3743;
  assign parity_3743 = ^{or_3740, or_3736, or_3732};
  // hls/stages/count_bits.hpp:25
  logic and_3744;
  assign and_3744 = xor_3590 & (^{xor_3627, select_3557[44:36], other[44:36]});
  logic or_3748;
  assign or_3748 = (xor_3575 & xor_3587) | (xor_3572 & (xor_3575 | xor_3587));
  logic and_3751;
  assign and_3751 = (xor_3593 ^ (^{select_3557[41:36], other[41:36]})) & (xor_3614 | xor_3626);
  logic or_3752;
  assign or_3752 = (xor_3614 & xor_3626) | and_3751;
  // hls/stages/count_bits.hpp:24
  logic parity_3755;
  assign parity_3755 = ^{or_3752, or_3748, and_3744};
  logic parity_3758;
  assign parity_3758 = ^{or_3752, or_3748, and_3744, or_3740, or_3736, or_3732, or_3722, or_3718, or_3714, or_3707, or_3703, or_3699, or_3691, or_3687, or_3683};
  logic parity_3760;
  assign parity_3760 = ^{or_3752, or_3748, and_3744, or_3740, or_3736, or_3732, or_3722, or_3718, or_3714, or_3707, or_3703, or_3699, or_3691, or_3687, or_3683, or_3673, or_3669, or_3665, or_3658, or_3654, or_3650, or_3643, or_3639, or_3635};
  // hls/stages/count_bits.hpp:25
  logic and_3761;
  assign and_3761 = parity_3679 & parity_3758;
  logic or_3765;
  assign or_3765 = (parity_3661 & parity_3676) | ((^{or_3643, or_3639, or_3635}) & (parity_3661 | parity_3676));
  logic or_3769;
  assign or_3769 = (parity_3743 & parity_3755) | (parity_3728 & (parity_3743 | parity_3755));
  logic or_3776;
  assign or_3776 = (parity_3710 & parity_3725) | ((^{or_3691, or_3687, or_3683}) & (parity_3710 | parity_3725));
  logic or_3780;
  assign or_3780 = (or_3736 & or_3740) | (or_3732 & (or_3736 | or_3740));
  logic or_3784;
  assign or_3784 = (or_3748 & or_3752) | (and_3744 & (or_3748 | or_3752));
  // hls/stages/count_bits.hpp:23
  logic or_3791;
  assign or_3791 = (or_3687 & or_3691) | (or_3683 & (or_3687 | or_3691));
  // hls/stages/count_bits.hpp:25
  logic or_3795;
  assign or_3795 = (or_3703 & or_3707) | (or_3699 & (or_3703 | or_3707));
  logic or_3799;
  assign or_3799 = (or_3718 & or_3722) | (or_3714 & (or_3718 | or_3722));
  // hls/stages/count_bits.hpp:24
  logic parity_3802;
  assign parity_3802 = ^{or_3799, or_3795, or_3791};
  // hls/stages/count_bits.hpp:23
  logic or_3806;
  assign or_3806 = (or_3639 & or_3643) | (or_3635 & (or_3639 | or_3643));
  // hls/stages/count_bits.hpp:25
  logic or_3810;
  assign or_3810 = (or_3654 & or_3658) | (or_3650 & (or_3654 | or_3658));
  logic or_3814;
  assign or_3814 = (or_3669 & or_3673) | (or_3665 & (or_3669 | or_3673));
  // hls/stages/count_bits.hpp:24
  logic parity_3817;
  assign parity_3817 = ^{or_3814, or_3810, or_3806};
  logic parity_3820;
  assign parity_3820 = ^{or_3814, or_3810, or_3806, or_3799, or_3795, or_3791, or_3784, or_3780, or_3776};
  logic parity_3822;
  assign parity_3822 = ^{or_3814, or_3810, or_3806, or_3799, or_3795, or_3791, or_3784, or_3780, or_3776, or_3769, or_3765, and_3761};
  // hls/stages/count_bits.hpp:25
  logic or_3826;
  assign or_3826 = (or_3780 & or_3784) | (or_3776 & (or_3780 | or_3784));
  logic or_3830;
  assign or_3830 = (or_3795 & or_3799) | (or_3791 & (or_3795 | or_3799));
  logic or_3834;
  assign or_3834 = (or_3810 & or_3814) | (or_3806 & (or_3810 | or_3814));
  // hls/stages/count_bits.hpp:24
  logic parity_3837;
  assign parity_3837 = ^{or_3834, or_3830, or_3826};
  // hls/stages/count_bits.hpp:25
  logic and_3838;
  assign and_3838 = (^{or_3769, or_3765, and_3761}) & parity_3820;
  logic or_3842;
  assign or_3842 = (or_3765 & or_3769) | (and_3761 & (or_3765 | or_3769));
  logic or_3846;
  assign or_3846 = (parity_3802 & parity_3817) | ((^{or_3784, or_3780, or_3776}) & (parity_3802 | parity_3817));
  // hls/stages/count_bits.hpp:24
  logic parity_3849;
  assign parity_3849 = ^{or_3846, or_3842, and_3838};
  // hls/stages/count_bits.hpp:25
  logic and_3851;
  assign and_3851 = parity_3837 & parity_3849;
  logic or_3855;
  assign or_3855 = (or_3830 & or_3834) | (or_3826 & (or_3830 | or_3834));
  logic or_3859;
  assign or_3859 = (or_3842 & or_3846) | (and_3838 & (or_3842 | or_3846));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3904;
  assign select_3904 = equal_2231_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3907;
  assign select_3907 = equal_2229_s2_q ? patches_summed_first_q : (equal_2231_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:552
  logic [9:0] select_3914;
  assign select_3914 = less_2392_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3917;
  assign select_3917 = equal_2395_s2_q ? (less_2392_s2_q ? (equal_2395_s2_q ? 10'h0 : select_3914) : 10'h0) : select_3914;
  logic [9:0] select_3919;
  assign select_3919 = less_2392_s2_q ? (equal_2393_s2_q ? 10'h0 : select_3917) : select_3917;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3921;
  assign select_3921 = less_2392_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3924;
  assign select_3924 = equal_2395_s2_q ? (less_2392_s2_q ? (equal_2395_s2_q ? 5'h0 : select_3921) : 5'h0) : select_3921;
  logic [4:0] select_3926;
  assign select_3926 = less_2392_s2_q ? (equal_2393_s2_q ? 5'h0 : select_3924) : select_3924;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3928;
  assign select_3928 = less_2392_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3931;
  assign select_3931 = equal_2395_s2_q ? (less_2392_s2_q ? (equal_2395_s2_q ? 5'h0 : select_3928) : 5'h0) : select_3928;
  logic [4:0] select_3933;
  assign select_3933 = less_2392_s2_q ? (equal_2393_s2_q ? 5'h0 : select_3931) : select_3931;
  // hls/stages/patches.hpp:552
  logic and_3936;
  assign and_3936 = less_2392_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:556
  logic select_3939;
  assign select_3939 = equal_2395_s2_q ? (less_2392_s2_q ? (not_2396_s2_q & and_3936) : and_3936) : and_3936;
  // hls/stages/patches.hpp:184
  logic select_3942;
  assign select_3942 = equal_2229_s2_q ? (less_2392_s2_q ? (not_2394_s2_q & select_3939) : select_3939) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3953;
  assign or_3953 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3954;
  assign and_3954 = patches_read_searches_s2_q & or_3953;
  // hls/stages/patches.hpp:536
  logic [4:0] select_3955;
  assign select_3955 = and_3954 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:543
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3955};
  // hls/stages/patches.hpp:552
  logic and_3959;
  assign and_3959 = less_2392_s2_q & (equal_3951_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:556
  logic select_3962;
  assign select_3962 = equal_2395_s2_q ? (less_2392_s2_q ? (not_2396_s2_q & and_3959) : and_3959) : and_3959;
  // hls/stages/patches.hpp:184
  logic select_3965;
  assign select_3965 = equal_2229_s2_q ? (less_2392_s2_q ? (not_2394_s2_q & select_3962) : select_3962) : patches_read_above_q;
  // hls/stages/patches.hpp:552
  logic and_3968;
  assign and_3968 = less_2392_s2_q & (equal_3951_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:556
  logic select_3971;
  assign select_3971 = equal_2395_s2_q ? (less_2392_s2_q ? (not_2396_s2_q & and_3968) : and_3968) : and_3968;
  // hls/stages/patches.hpp:184
  logic select_3974;
  assign select_3974 = equal_2229_s2_q ? (less_2392_s2_q ? (not_2394_s2_q & select_3971) : select_3971) : patches_read_below_q;
  // hls/stages/patches.hpp:549
  logic [6:0] sum_3975;
  assign sum_3975 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3978;
  assign select_3978 = (equal_3951_s2_q & ({sum_3975[6], sum_3975} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3979;
  assign select_3979 = less_2392_s2_q ? select_3978 : 10'h3ff;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3981;
  assign select_3981 = less_2392_s2_q ? (equal_2395_s2_q ? 10'h3ff : select_3979) : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3982;
  assign select_3982 = equal_2395_s2_q ? select_3981 : select_3979;
  logic [9:0] select_3984;
  assign select_3984 = less_2392_s2_q ? (equal_2393_s2_q ? 10'h3ff : select_3982) : select_3982;
  // hls/stages/patches.hpp:535
  logic [14:0] select_3986;
  assign select_3986 = and_3954 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3987;
  assign select_3987 = equal_2229_s2_q ? select_3986[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3988;
  assign select_3988 = equal_2229_s2_q ? select_3986[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3990;
  assign select_3990 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3992;
  assign select_3992 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:539
  logic [9:0] select_3995;
  assign select_3995 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3996;
  assign select_3996 = patches_read_first_q ? patches_read_far_q : select_3995;
  // hls/stages/patches.hpp:590
  logic [9:0] difference_3999;
  assign difference_3999 = select_3996 - select_3986[9:0];
  // hls/stages/patches.hpp:575
  logic less_4029;
  assign less_4029 = select_3990 < select_3992;
  // hls/stages/patches.hpp:581
  logic [1:0] sum_4030;
  assign sum_4030 = select_3955[4:3] + 2'h3;
  // hls/stages/patches.hpp:576
  logic [9:0] high;
  assign high = less_4029 ? select_3992 : select_3990;
  logic [9:0] low;
  assign low = (select_3992 < select_3990) ? select_3992 : select_3990;
  // hls/stages/patches.hpp:577
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3986[9:0];
  // hls/stages/patches.hpp:579
  logic not_4037;
  assign not_4037 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4038;
  assign sum_4038 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4040;
  assign not_4040 = ~({eight, 3'h0} < {1'b0, sum_4038, fall_2[0]});
  logic [1:0] sum_4041;
  assign sum_4041 = {1'b0, not_4037} + {1'b0, not_4040};
  // hls/stages/patches.hpp:580
  logic [10:0] sum_4042;
  assign sum_4042 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4044;
  assign not_4044 = ~({eight, 3'h0} < {sum_4042, fall_2[1:0]});
  logic not_4047;
  assign not_4047 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4048;
  assign sum_4048 = {1'b0, not_4044} + {1'b0, not_4047};
  // hls/stages/patches.hpp:579
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4041} + {1'b0, sum_4048};
  // hls/stages/patches.hpp:582
  logic [7:0] select_4051;
  assign select_4051 = less_4029 ? ({sum_4030, select_3955[2:0], 3'h0} - {5'h0, fraction}) : {sum_4030, select_3955[2:0], fraction};
  // hls/stages/agreement.hpp:789
  logic select_4276;
  assign select_4276 = equal_550_s2_q ? shown_shown_q : (so_s2_q ? select_2457 : shown_shown_q);
  logic select_4278;
  assign select_4278 = equal_550_s2_q ? shown_nearer_q : (so_s2_q ? select_2460 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4280;
  assign sum_4280 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:461
  logic [2:0] select_4282;
  assign select_4282 = less_4279_s2_q ? (sum_4280[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4284;
  assign select_4284 = equal_2893_s2_q ? (equal_655_s2_q ? 3'h0 : select_4282) : region_row_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_4289;
  assign select_4289 = equal_550_s2_q ? select_2411 : (so_s2_q ? (ends_cell_s2_q ? select_2509 : select_2411) : 8'h1);
  // hls/stages/agreement.hpp:461
  logic [8:0] select_4303;
  assign select_4303 = equal_655_s2_q ? {{2{difference_4301[6]}}, difference_4301} : (less_4279_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:521
  logic [8:0] select_4305;
  assign select_4305 = and_526_s2_q ? (equal_2893_s2_q ? select_4303 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:461
  logic [6:0] select_4307;
  assign select_4307 = equal_655_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_4309;
  assign select_4309 = and_526_s2_q ? (equal_2893_s2_q ? select_4307 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4310;
  assign sum_4310 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4311;
  assign select_4311 = sum_4280[7] ? {1'b1, sum_4280[6:0], region_down_rest_q[0]} : sum_4310;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4280[7];
  // hls/stages/agreement.hpp:461
  logic select_4315;
  assign select_4315 = equal_2893_s2_q ? (equal_655_s2_q | (less_4279_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4320;
  assign or_4320 = segment_starts_q | not_553_s2_q;
  // hls/stages/agreement.hpp:1031
  logic select_4323;
  assign select_4323 = inside_v_s2_q ? (sum_2424_s2_q ? (equal_2222 & or_2426) : or_2426) : or_4320;
  // hls/stages/agreement.hpp:789
  logic select_4326;
  assign select_4326 = equal_550_s2_q ? or_4320 : (so_s2_q ? (ends_cell_s2_q ? select_4323 : or_4320) : or_4320);
  logic select_4485;
  assign select_4485 = so_s2_q ? (ends_cell_s2_q ? and_2497 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4488;
  assign select_4488 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4490;
  assign select_4490 = equal_550_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4488 : centres_values_0_of_skin_q);
  logic select_4491;
  assign select_4491 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4493;
  assign select_4493 = equal_550_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4491 : centres_values_1_textured_q);
  logic select_4494;
  assign select_4494 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4496;
  assign select_4496 = equal_550_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4494 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:461
  logic [12:0] select_4500;
  assign select_4500 = equal_2893_s2_q ? (equal_4497_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_4503;
  assign select_4503 = and_526_s2_q ? (equal_2893_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_4514;
  assign select_4514 = select_2469 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4520;
  assign select_4520 = marks_first_s2_q ? (less_4516 ? {sum_4517, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:789
  logic and_4584;
  assign and_4584 = equal_550_s2_q & (equal_2737 & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/registration.hpp:258
  logic not_4591;
  assign not_4591 = ~quarter[1];
  logic [3:0] select_4592;
  assign select_4592 = quarter[0] ? {quarter[1], 1'b0, not_4591, 1'b0} : {1'b0, quarter[1], 1'b0, not_4591};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2064;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2107;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:763; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2141;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2143));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1399; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2421;
  logic regions_re;
  assign regions_re = s2_en & (equal_550_s2_q ? (x_s2_q[6] & not_2422) : and_2429);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1410; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2481, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2488 & less_2489);
  logic [2:0] map_word_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_word_q <= map_mem[map_raddr];
  end
  logic [1:0] map_rdata_q;
  assign map_rdata_q = map_word_q[1:0];
  logic map_read_q, map_error;
  always_ff @(posedge clk_i) map_read_q <= rst_ni & map_re;
  assign map_error = map_read_q & ^map_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_496_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_501_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_520, and_516, sum_512, sum_508};
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
  assign census_memory_waddr = column_s2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_526_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_544, whole_2, select_536, select_532};
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
  assign moments_memory_waddr = select_549_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_567_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_622_s2_q, and_620_s2_q, and_615_s2_q, and_613};
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
  assign best_left_we = s2_en & and_2011_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2010, select_2007, select_2004, select_2002, select_1975, select_1972, select_1964, select_1963, select_1959};
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
  assign best_right_we = s2_en & and_2011_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2021, select_2020, select_2017, select_2016};
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
  assign shown_right_waddr = select_2028_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2039;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2036, not_553_s2_q};
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
  assign left_turns_we = s2_en & and_2050;
  logic [1:0] left_turns_wdata;
  assign left_turns_wdata = {and_2047, and_2044};
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
  assign right_turns_we = s2_en & and_2050;
  logic [1:0] right_turns_wdata;
  assign right_turns_wdata = {and_2056, and_2053};
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
  assign patches_right_codes_waddr = {sum_2343, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2377_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2363_s2_q, less_2362_s2_q, less_2353_s2_q, less_2352_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2381, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2391_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2363_s2_q, less_2362_s2_q, less_2353_s2_q, less_2352_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2024_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2456, textured};
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
      moments_out_of_step_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2621;
      averager_mask_q <= select_2623;
      averager_of_skin_q <= select_2625;
      census_filled_q <= and_526_s2_q ? {select_658[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= select_2729;
      moments_turned_1_q <= select_2736;
      moments_before_0_q <= equal_550_s2_q ? select_2740 : moments_before_0_q;
      moments_before_1_q <= equal_550_s2_q ? select_2743 : moments_before_1_q;
      moments_has_before_q <= equal_550_s2_q ? select_2746 : moments_has_before_q;
      moments_most_before_q <= equal_550_s2_q ? select_2749 : moments_most_before_q;
      moments_out_of_step_q <= equal_550_s2_q ? select_2778 : moments_out_of_step_q;
      rows_passed_above_q <= and_526_s2_q ? select_657 : rows_passed_above_q;
      shift_allowed_q <= not_2990 & (~less_2991);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2998 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3117});
      counts_turned_right_q <= and_2998 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3124});
      registration_displacement_over_q <= so_s2_q ? sum_3148[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3150;
      registration_slope_here_q <= select_3152;
      registration_expected_q <= select_3154;
      registration_of_right_q <= equal_550_s2_q ? registration_of_right_q : select_3216;
      registration_was_inside_q <= equal_550_s2_q ? registration_was_inside_q : select_3219;
      registration_fresh_q <= select_3228;
      patches_chance_q <= and_526_s2_q ? select_3385 : patches_chance_q;
      patches_fixed_q <= and_3400;
      patches_choice_valid_q <= and_2227 ? (select_2200 & not_3387) : select_2200;
      patches_choice_column_q <= select_2205;
      patches_choice_shift_q <= select_2210;
      patches_choice_slope_q <= select_2221;
      patches_band_q <= sample_pair_whole_s2_q ? select_2242 : patches_band_q;
      patches_fetch_q <= select_3415;
      patches_codes_at_q <= select_3516;
      patches_codes_further_q <= equal_2229_s2_q ? patches_codes_further_q : select_3521;
      patches_next_codes_q <= select_3529;
      patches_set_q <= equal_2229_s2_q ? 3'h0 : (equal_2231_s2_q ? 3'h0 : select_3543);
      patches_size_q <= sum_3547;
      patches_left_row_q <= select_3559;
      patches_summed_row_column_q <= equal_2229_s2_q ? patches_summed_row_column_q : select_3904;
      patches_summed_first_q <= select_3907;
      patches_read_row_differing_q <= equal_2229_s2_q ? select_3919 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2229_s2_q ? select_3926 : patches_read_row_column_q;
      patches_read_at_q <= equal_2229_s2_q ? select_3933 : patches_read_at_q;
      patches_read_first_q <= select_3942;
      patches_read_above_q <= select_3965;
      patches_read_below_q <= select_3974;
      patches_read_far_q <= equal_2229_s2_q ? select_3984 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3987;
      patches_peak_best_column_q <= select_3988;
      patches_peak_row_q <= equal_2229_s2_q ? select_3955 : patches_peak_row_q;
      patches_peak_above_q <= equal_2229_s2_q ? select_3990 : patches_peak_above_q;
      patches_peak_below_q <= equal_2229_s2_q ? select_3992 : patches_peak_below_q;
      patches_peak_far_q <= equal_2229_s2_q ? select_3996 : patches_peak_far_q;
      patches_frame_ended_q <= equal_550_s2_q & (equal_2738 & (~equal_2737));
      shown_shown_q <= select_4276;
      shown_nearer_q <= select_4278;
      region_row_q <= and_526_s2_q ? select_4284 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4289;
      region_down_rest_q <= select_4305;
      region_down_back_q <= select_4309;
      region_down_next_q <= select_4311;
      region_fresh_q <= and_526_s2_q ? select_4315 : region_fresh_q;
      segment_starts_q <= select_4326;
      centres_values_0_textured_q <= equal_550_s2_q ? centres_values_0_textured_q : select_4485;
      centres_values_0_of_skin_q <= select_4490;
      centres_values_1_textured_q <= select_4493;
      centres_values_1_of_skin_q <= select_4496;
      map_row_q <= and_526_s2_q ? select_4500 : map_row_q;
      map_width_q <= select_4503;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2480;
      done_q <= not_2482 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_550_s2_q & equal_2737;
      rows_passed_q <= select_2465;
      columns_passed_q <= {select_2467[7:0], or_2463};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2484;
      seen_x_q <= select_2486;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4514;
      seen_column_q <= select_2477;
      seen_rows_left_q <= select_4520;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2474;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_504 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_510 : averager_running_1_q;
      averager_total_0_q <= select_2600;
      averager_total_1_q <= select_2602;
      census_columns_values_0_cell_0_left_q <= select_2626;
      census_columns_values_0_cell_0_right_q <= select_2627;
      census_columns_values_0_cell_0_mask_q <= and_526_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2629;
      census_columns_values_0_cell_1_right_q <= select_2630;
      census_columns_values_0_cell_1_mask_q <= select_2631;
      census_columns_values_0_cell_2_left_q <= select_2632;
      census_columns_values_0_cell_2_right_q <= select_2633;
      census_columns_values_0_cell_2_mask_q <= select_2634;
      census_columns_values_0_cell_2_of_skin_q <= select_2635;
      census_columns_values_0_cell_3_left_q <= select_2636;
      census_columns_values_0_cell_3_right_q <= select_2637;
      census_columns_values_0_cell_3_mask_q <= select_2638;
      census_columns_values_0_cell_4_left_q <= select_2639;
      census_columns_values_0_cell_4_right_q <= select_2640;
      census_columns_values_0_cell_4_mask_q <= select_2641;
      census_columns_values_1_cell_0_left_q <= select_2642;
      census_columns_values_1_cell_0_right_q <= select_2643;
      census_columns_values_1_cell_0_mask_q <= select_2644;
      census_columns_values_1_cell_1_left_q <= select_2645;
      census_columns_values_1_cell_1_right_q <= select_2646;
      census_columns_values_1_cell_1_mask_q <= select_2647;
      census_columns_values_1_cell_2_left_q <= select_2648;
      census_columns_values_1_cell_2_right_q <= select_2649;
      census_columns_values_1_cell_2_mask_q <= select_2650;
      census_columns_values_1_cell_2_of_skin_q <= select_2651;
      census_columns_values_1_cell_3_left_q <= select_2652;
      census_columns_values_1_cell_3_right_q <= select_2653;
      census_columns_values_1_cell_3_mask_q <= select_2654;
      census_columns_values_1_cell_4_left_q <= select_2655;
      census_columns_values_1_cell_4_right_q <= select_2656;
      census_columns_values_1_cell_4_mask_q <= select_2657;
      census_columns_values_2_cell_0_left_q <= select_2658;
      census_columns_values_2_cell_0_right_q <= select_2659;
      census_columns_values_2_cell_0_mask_q <= select_2660;
      census_columns_values_2_cell_1_left_q <= select_2661;
      census_columns_values_2_cell_1_right_q <= select_2662;
      census_columns_values_2_cell_1_mask_q <= select_2663;
      census_columns_values_2_cell_2_left_q <= select_2664;
      census_columns_values_2_cell_2_right_q <= select_2665;
      census_columns_values_2_cell_2_mask_q <= select_2666;
      census_columns_values_2_cell_3_left_q <= select_2667;
      census_columns_values_2_cell_3_right_q <= select_2668;
      census_columns_values_2_cell_3_mask_q <= select_2669;
      census_columns_values_2_cell_4_left_q <= select_2670;
      census_columns_values_2_cell_4_right_q <= select_2671;
      census_columns_values_2_cell_4_mask_q <= select_2672;
      census_columns_values_3_cell_0_mask_q <= select_2673;
      census_columns_values_3_cell_1_left_q <= select_2674;
      census_columns_values_3_cell_1_right_q <= select_2675;
      census_columns_values_3_cell_1_mask_q <= select_2676;
      census_columns_values_3_cell_2_mask_q <= select_2677;
      census_columns_values_3_cell_3_left_q <= select_2678;
      census_columns_values_3_cell_3_right_q <= select_2679;
      census_columns_values_3_cell_3_mask_q <= select_2680;
      census_columns_values_3_cell_4_mask_q <= select_2681;
      sharpness_last_mean_0_q <= and_526_s2_q ? select_532 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_526_s2_q ? select_536 : sharpness_last_mean_1_q;
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
  logic [2:0] select_490_s3_q;
  logic [6:0] select_492_s3_q;
  logic [6:0] column_s3_q;
  logic and_524_s3_q;
  logic and_526_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_529_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_546_s3_q;
  logic equal_550_s3_q;
  logic not_551_s3_q;
  logic less_628_s3_q;
  logic less_629_s3_q;
  logic less_630_s3_q;
  logic less_631_s3_q;
  logic less_632_s3_q;
  logic less_633_s3_q;
  logic less_634_s3_q;
  logic less_635_s3_q;
  logic less_636_s3_q;
  logic less_637_s3_q;
  logic less_638_s3_q;
  logic less_639_s3_q;
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
  logic and_659_s3_q;
  logic and_684_s3_q;
  logic and_685_s3_q;
  logic [11:0] sum_700_s3_q;
  logic [9:0] sum_703_s3_q;
  logic and_711_s3_q;
  logic and_715_s3_q;
  logic less_716_s3_q;
  logic less_720_s3_q;
  logic less_722_s3_q;
  logic equal_2057_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2063_s3_q;
  logic equal_2065_s3_q;
  logic equal_2067_s3_q;
  logic equal_2069_s3_q;
  logic equal_2071_s3_q;
  logic equal_2073_s3_q;
  logic equal_2075_s3_q;
  logic equal_2077_s3_q;
  logic equal_2079_s3_q;
  logic less_2088_s3_q;
  logic or_2092_s3_q;
  logic equal_2112_s3_q;
  logic and_2122_s3_q;
  logic and_2125_s3_q;
  logic select_2142_s3_q;
  logic equal_2143_s3_q;
  logic and_2151_s3_q;
  logic equal_2153_s3_q;
  logic select_2200_s3_q;
  logic and_2228_s3_q;
  logic equal_2229_s3_q;
  logic equal_2231_s3_q;
  logic and_2244_s3_q;
  logic [4:0] select_2259_s3_q;
  logic select_2265_s3_q;
  logic [3:0] select_2306_s3_q;
  logic less_2392_s3_q;
  logic equal_2393_s3_q;
  logic not_2394_s3_q;
  logic equal_2395_s3_q;
  logic or_2414_s3_q;
  logic or_2417_s3_q;
  logic or_2420_s3_q;
  logic not_2422_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2449_s3_q;
  logic and_2454_s3_q;
  logic and_2488_s3_q;
  logic less_2489_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2494_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2512_s3_q;
  logic or_2515_s3_q;
  logic or_2518_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2568_s3_q;
  logic [11:0] sum_2697_s3_q;
  logic [9:0] sum_2700_s3_q;
  logic equal_2708_s3_q;
  logic equal_2737_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2998_s3_q;
  logic and_3004_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3066_s3_q;
  logic and_3100_s3_q;
  logic and_3158_s3_q;
  logic and_3159_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3195_s3_q;
  logic and_3209_s3_q;
  logic equal_3252_s3_q;
  logic parity_3631_s3_q;
  logic parity_3760_s3_q;
  logic parity_3822_s3_q;
  logic xor_3850_s3_q;
  logic parity_3862_s3_q;
  logic or_3866_s3_q;
  logic equal_3867_s3_q;
  logic [4:0] select_3986_s3_q;
  logic equal_3998_s3_q;
  logic less_4000_s3_q;
  logic less_4001_s3_q;
  logic or_4006_s3_q;
  logic [7:0] select_4051_s3_q;
  logic and_4526_s3_q;
  logic not_4541_s3_q;
  logic and_4584_s3_q;
  logic equal_4594_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
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
      select_490_s3_q <= select_490_s2_q;
      select_492_s3_q <= select_492_s2_q;
      column_s3_q <= column_s2_q;
      and_524_s3_q <= and_524_s2_q;
      and_526_s3_q <= and_526_s2_q;
      grey_s3_q <= grey;
      equal_529_s3_q <= equal_529;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_546_s3_q <= equal_546_s2_q;
      equal_550_s3_q <= equal_550_s2_q;
      not_551_s3_q <= not_551_s2_q;
      less_628_s3_q <= less_628;
      less_629_s3_q <= less_629;
      less_630_s3_q <= less_630;
      less_631_s3_q <= less_631;
      less_632_s3_q <= less_632;
      less_633_s3_q <= less_633;
      less_634_s3_q <= less_634;
      less_635_s3_q <= less_635;
      less_636_s3_q <= less_636;
      less_637_s3_q <= less_637;
      less_638_s3_q <= less_638;
      less_639_s3_q <= less_639;
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
      and_659_s3_q <= and_659;
      and_684_s3_q <= whole_22 & and_659;
      and_685_s3_q <= census_columns_values_1_cell_2_mask_q & and_659;
      sum_700_s3_q <= {1'b0, sum_696} + {2'h0, sum_699};
      sum_703_s3_q <= {9'h0, difference_701[9]} + {1'b0, xor_702};
      and_711_s3_q <= and_711;
      and_715_s3_q <= and_715;
      less_716_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_720_s3_q <= {{5{sum_719[6]}}, sum_719, half_grey_levels_2[3:0]} < 16'hffe1;
      less_722_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2057_s3_q <= equal_2057;
      all_s3_q <= all;
      sum_2063_s3_q <= sum_2063;
      equal_2065_s3_q <= equal_2065;
      equal_2067_s3_q <= equal_2067;
      equal_2069_s3_q <= equal_2069;
      equal_2071_s3_q <= equal_2071;
      equal_2073_s3_q <= equal_2073;
      equal_2075_s3_q <= equal_2075;
      equal_2077_s3_q <= equal_2077;
      equal_2079_s3_q <= equal_2079;
      less_2088_s3_q <= less_2088;
      or_2092_s3_q <= or_2092;
      equal_2112_s3_q <= (registration_fresh_q & select_2110) == 4'h0;
      and_2122_s3_q <= not_551_s2_q & and_2106;
      and_2125_s3_q <= and_2125_s2_q;
      select_2142_s3_q <= select_2142[1];
      equal_2143_s3_q <= equal_2143;
      and_2151_s3_q <= and_2151;
      equal_2153_s3_q <= equal_2153;
      select_2200_s3_q <= select_2200;
      and_2228_s3_q <= and_2228;
      equal_2229_s3_q <= equal_2229_s2_q;
      equal_2231_s3_q <= equal_2231_s2_q;
      and_2244_s3_q <= and_2228 & equal_2243;
      select_2259_s3_q <= select_2259_s2_q;
      select_2265_s3_q <= select_2265_s2_q;
      select_2306_s3_q <= select_2306_s2_q;
      less_2392_s3_q <= less_2392_s2_q;
      equal_2393_s3_q <= equal_2393_s2_q;
      not_2394_s3_q <= not_2394_s2_q;
      equal_2395_s3_q <= equal_2395_s2_q;
      or_2414_s3_q <= or_2414;
      or_2417_s3_q <= or_2417;
      or_2420_s3_q <= or_2420;
      not_2422_s3_q <= not_2422;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2449_s3_q <= inside_v_s2_q & (and_2447 & and_2035);
      and_2454_s3_q <= not_551_s2_q & and_2429;
      and_2488_s3_q <= and_2488;
      less_2489_s3_q <= less_2489;
      index_2_s3_q <= index_2[5:0];
      sum_2494_s3_q <= sum_2494;
      textured_2_s3_q <= textured_2;
      or_2512_s3_q <= or_2512;
      or_2515_s3_q <= select_2509[7] | (~({select_2509[6], select_2509[3:2]} == 3'h0));
      or_2518_s3_q <= select_2509[7] | (~(select_2509[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2568_s3_q <= and_2568;
      sum_2697_s3_q <= {1'b0, sum_2693} + {2'h0, sum_2696};
      sum_2700_s3_q <= {9'h0, difference_2698[9]} + {1'b0, xor_2699};
      equal_2708_s3_q <= equal_2708_s2_q;
      equal_2737_s3_q <= equal_2737;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2998_s3_q <= and_2998;
      and_3004_s3_q <= and_3004;
      explained_2_s3_q <= explained_2;
      and_3066_s3_q <= not_551_s2_q & and_3065;
      and_3100_s3_q <= not_551_s2_q & and_3099;
      and_3158_s3_q <= not_551_s2_q & (so_s2_q & (half_ends & equal_3155));
      and_3159_s3_q <= and_3159;
      residual_s3_q <= residual[7:0];
      and_3195_s3_q <= and_3195;
      and_3209_s3_q <= and_3159 & less_3208;
      equal_3252_s3_q <= (registration_fresh_q & select_3250) == 4'h0;
      parity_3631_s3_q <= ^{xor_3627, xor_3590, select_3557[44:36], other[44:36]};
      parity_3760_s3_q <= parity_3760;
      parity_3822_s3_q <= parity_3822;
      xor_3850_s3_q <= parity_3837 ^ parity_3849;
      parity_3862_s3_q <= ^{or_3859, or_3855, and_3851};
      or_3866_s3_q <= (or_3855 & or_3859) | (and_3851 & (or_3855 | or_3859));
      equal_3867_s3_q <= equal_3867_s2_q;
      select_3986_s3_q <= select_3986[14:10];
      equal_3998_s3_q <= select_3955[3:0] == 4'h0;
      less_4000_s3_q <= {difference_3999, 3'h0} < {3'h0, sum_3547};
      less_4001_s3_q <= select_3996 < select_3986[9:0];
      or_4006_s3_q <= (sum_3547 < 10'h39) | ({1'b0, sum_3547[9:1]} < select_3986[9:0]);
      select_4051_s3_q <= select_4051;
      and_4526_s3_q <= and_2568 & ({sum_2494, index_2[5:0]} == {sum_2481, index[5:0]});
      not_4541_s3_q <= ~proven_q;
      and_4584_s3_q <= and_4584;
      equal_4594_s3_q <= (registration_fresh_q & select_4592) == 4'h0;
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
  logic [7:0] patches_on_skin_most_q;
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
  assign texture = sum_700_s3_q + {2'h0, sum_703_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_705;
  assign sum_705 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_707;
  assign sum_707 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_705});
  // hls/stages/census.hpp:305
  logic less_708;
  assign less_708 = 9'h4 < sum_707[13:5];
  logic and_709;
  assign and_709 = and_659_s3_q & less_708;
  // hls/stages/moments.hpp:30
  logic and_721;
  assign and_721 = (and_684_s3_q & and_711_s3_q) & less_720_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2114;
  assign equal_2114 = sum_2063_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2063_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2116;
  assign select_2116 = equal_2114 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2117;
  assign sum_2117 = (equal_2112_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2116[13]}}, select_2116};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2063_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2120;
  assign select_2120 = equal_2114 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2121;
  assign sum_2121 = (equal_2112_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2120[6]}}, select_2120};
  // hls/stages/patches.hpp:353
  logic [22:0] select_2245;
  assign select_2245 = and_2244_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2200_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2247;
  assign select_2247 = equal_2143_s3_q ? patches_place_0_valid_q : (select_2142_s3_q ? patches_place_0_valid_q : select_2245[0]);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2248;
  assign select_2248 = select_2142_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2245[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2249;
  assign select_2249 = equal_2143_s3_q ? patches_place_0_column_q : select_2248[7:0];
  logic [5:0] select_2250;
  assign select_2250 = equal_2143_s3_q ? patches_place_0_shift_q : select_2248[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2251;
  assign sum_2251 = select_2249 + {{2{select_2250[5]}}, select_2250};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2252;
  assign sum_2252 = sum_2251[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2253;
  assign equal_2253 = {sum_2252[6], select_492_s3_q, select_490_s3_q} == {1'b0, sum_2252[5:0], sum_2251[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2255;
  assign or_2255 = and_2125_s3_q | (select_2247 & equal_2253);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2256;
  assign select_2256 = or_2255 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2266;
  assign select_2266 = or_2255 ? {and_2125_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2268;
  assign and_2268 = select_2265_s3_q & (~select_2266[5]);
  // hls/stages/patches.hpp:127
  logic select_2276;
  assign select_2276 = equal_2143_s3_q ? patches_place_1_valid_q : (select_2142_s3_q ? select_2245[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2277;
  assign select_2277 = select_2142_s3_q ? select_2245[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2278;
  assign select_2278 = equal_2143_s3_q ? patches_place_1_column_q : select_2277[7:0];
  logic [5:0] select_2279;
  assign select_2279 = equal_2143_s3_q ? patches_place_1_shift_q : select_2277[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2280;
  assign sum_2280 = select_2278 + {{2{select_2279[5]}}, select_2279};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2281;
  assign sum_2281 = sum_2280[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2282;
  assign equal_2282 = {sum_2281[6], select_492_s3_q, select_490_s3_q} == {1'b0, sum_2281[5:0], sum_2280[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2284;
  assign or_2284 = and_2125_s3_q | (select_2276 & equal_2282);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2285;
  assign select_2285 = or_2284 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2286;
  assign select_2286 = or_2284 ? {and_2125_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2288;
  assign and_2288 = select_2265_s3_q & (~select_2286[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2295;
  assign sum_2295 = select_2249 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2296;
  assign equal_2296 = {sum_2295[7], select_492_s3_q, select_490_s3_q} == {1'b0, sum_2295[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2298;
  assign or_2298 = and_2125_s3_q | (select_2247 & equal_2296);
  logic [4:0] select_2299;
  assign select_2299 = or_2298 ? {and_2125_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2300;
  assign sum_2300 = select_2278 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2301;
  assign equal_2301 = {sum_2300[7], select_492_s3_q, select_490_s3_q} == {1'b0, sum_2300[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2304;
  assign select_2304 = (and_2125_s3_q | (select_2276 & equal_2301)) ? {and_2125_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_7;
  assign column_7 = select_2299[4] ? select_2304[3:0] : select_2299[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2307;
  assign select_2307 = or_2298 ? and_2125_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2313;
  assign and_2313 = (select_2265_s3_q & (select_2259_s3_q[3] ^ select_2259_s3_q[4])) & ((~select_2299[4]) | (~select_2304[4]));
  // hls/stages/patches.hpp:184
  logic less_2404;
  assign less_2404 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2405;
  assign not_2405 = ~less_2404;
  logic [1:0] select_2406;
  assign select_2406 = patches_summed_first_s3_q ? 2'h2 : {less_2404, not_2405};
  logic [12:0] select_2408;
  assign select_2408 = select_2406[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2409;
  assign select_2409 = select_2406[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2410;
  assign select_2410 = (select_2406 == 2'h2) ? {select_2408[12:8], patches_sums_values_0_q[9:8], select_2408[7:0]} : select_2409;
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2435;
  assign select_2435 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2436;
  assign sum_2436 = {6'h0, textured_s3_q} + select_2435;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2438;
  assign sum_2438 = {3'h0, sum_2436} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2440;
  assign select_2440 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2441;
  assign sum_2441 = {6'h0, explained_s3_q} + select_2440;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2443;
  assign sum_2443 = {3'h0, sum_2441} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2450;
  assign select_2450 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:903
  logic [6:0] sum_2451;
  assign sum_2451 = {6'h0, and_2449_s3_q} + select_2450;
  // hls/stages/agreement.hpp:1064
  logic [9:0] sum_2453;
  assign sum_2453 = {3'h0, sum_2451} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2503;
  assign select_2503 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2504;
  assign difference_2504 = {1'b0, textured_2_s3_q} - {1'b0, select_2503};
  logic [4:0] t;
  assign t = {difference_2504[3], difference_2504} + (equal_546_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic equal_2507;
  assign equal_2507 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1102
  logic not_2519;
  assign not_2519 = ~region_row_s3_q[2];
  logic [2:0] select_2520;
  assign select_2520 = region_row_s3_q[1] ? {1'b0, not_2519, 1'b0} : {region_row_s3_q[2], 1'b0, not_2519};
  logic [5:0] select_2521;
  assign select_2521 = region_row_s3_q[0] ? {select_2520[2], 1'b0, select_2520[1], 1'b0, select_2520[0], 1'b0} : {1'b0, select_2520[2], 1'b0, select_2520[1], 1'b0, select_2520[0]};
  logic [11:0] select_2522;
  assign select_2522 = or_2518_s3_q ? {select_2521[5], 1'b0, select_2521[4], 1'b0, select_2521[3], 1'b0, select_2521[2], 1'b0, select_2521[1], 1'b0, select_2521[0], 1'b0} : {1'b0, select_2521[5], 1'b0, select_2521[4], 1'b0, select_2521[3], 1'b0, select_2521[2], 1'b0, select_2521[1], 1'b0, select_2521[0]};
  logic [23:0] select_2523;
  assign select_2523 = or_2515_s3_q ? {select_2522[11], 1'b0, select_2522[10], 1'b0, select_2522[9], 1'b0, select_2522[8], 1'b0, select_2522[7], 1'b0, select_2522[6], 1'b0, select_2522[5], 1'b0, select_2522[4], 1'b0, select_2522[3], 1'b0, select_2522[2], 1'b0, select_2522[1], 1'b0, select_2522[0], 1'b0} : {1'b0, select_2522[11], 1'b0, select_2522[10], 1'b0, select_2522[9], 1'b0, select_2522[8], 1'b0, select_2522[7], 1'b0, select_2522[6], 1'b0, select_2522[5], 1'b0, select_2522[4], 1'b0, select_2522[3], 1'b0, select_2522[2], 1'b0, select_2522[1], 1'b0, select_2522[0]};
  logic [47:0] select_2524;
  assign select_2524 = or_2512_s3_q ? {select_2523[23], 1'b0, select_2523[22], 1'b0, select_2523[21], 1'b0, select_2523[20], 1'b0, select_2523[19], 1'b0, select_2523[18], 1'b0, select_2523[17], 1'b0, select_2523[16], 1'b0, select_2523[15], 1'b0, select_2523[14], 1'b0, select_2523[13], 1'b0, select_2523[12], 1'b0, select_2523[11], 1'b0, select_2523[10], 1'b0, select_2523[9], 1'b0, select_2523[8], 1'b0, select_2523[7], 1'b0, select_2523[6], 1'b0, select_2523[5], 1'b0, select_2523[4], 1'b0, select_2523[3], 1'b0, select_2523[2], 1'b0, select_2523[1], 1'b0, select_2523[0], 1'b0} : {1'b0, select_2523[23], 1'b0, select_2523[22], 1'b0, select_2523[21], 1'b0, select_2523[20], 1'b0, select_2523[19], 1'b0, select_2523[18], 1'b0, select_2523[17], 1'b0, select_2523[16], 1'b0, select_2523[15], 1'b0, select_2523[14], 1'b0, select_2523[13], 1'b0, select_2523[12], 1'b0, select_2523[11], 1'b0, select_2523[10], 1'b0, select_2523[9], 1'b0, select_2523[8], 1'b0, select_2523[7], 1'b0, select_2523[6], 1'b0, select_2523[5], 1'b0, select_2523[4], 1'b0, select_2523[3], 1'b0, select_2523[2], 1'b0, select_2523[1], 1'b0, select_2523[0]};
  // hls/stages/agreement.hpp:1031
  logic and_2528;
  assign and_2528 = good_known_q & (~((good_q & select_2524) == 48'h0));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2537;
  assign select_2537 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2538;
  assign difference_2538 = {1'b0, shown_2_s3_q} - {1'b0, select_2537};
  logic [4:0] around;
  assign around = {difference_2538[3], difference_2538} + (equal_546_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1104
  logic [5:0] sum_2541;
  assign sum_2541 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2507 ? and_2528 : (~({sum_2541, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1098
  logic [2:0] select_2553;
  assign select_2553 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2554;
  assign difference_2554 = {1'b0, near_2_s3_q} - {1'b0, select_2553};
  logic [4:0] n;
  assign n = {difference_2554[3], difference_2554} + (equal_546_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic and_2558;
  assign and_2558 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2592;
  assign select_2592 = sample_pair_whole_s3_q ? (and_524_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2594;
  assign select_2594 = sample_pair_whole_s3_q ? (and_524_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2596;
  assign select_2596 = sample_pair_whole_s3_q ? (and_524_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2598;
  assign select_2598 = sample_pair_whole_s3_q ? (and_524_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2603;
  assign sum_2603 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2604;
  assign difference_2604 = {1'b0, sum_2603[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2605;
  assign xor_2605 = {difference_2604[8:0], sum_2603[0]} ^ {10{difference_2604[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2604[9]} + {1'b0, xor_2605};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_529_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2610;
  assign select_2610 = sample_pair_whole_s3_q ? (and_524_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2611;
  assign sum_2611 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2612;
  assign difference_2612 = {1'b0, sum_2611[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2613;
  assign xor_2613 = {difference_2612[8:0], sum_2611[0]} ^ {10{difference_2612[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2612[9]} + {1'b0, xor_2613};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_529_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2618;
  assign select_2618 = sample_pair_whole_s3_q ? (and_524_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2701;
  assign sum_2701 = sum_2697_s3_q + {2'h0, sum_2700_s3_q};
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2703;
  assign select_2703 = and_526_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2704;
  assign select_2704 = and_526_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2705;
  assign select_2705 = and_526_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2706;
  assign select_2706 = and_526_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2709;
  assign sum_2709 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2701};
  logic [13:0] sum_2711;
  assign sum_2711 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2709});
  // hls/stages/census.hpp:311
  logic and_2713;
  assign and_2713 = and_684_s3_q & (9'h4 < sum_2711[13:5]);
  // hls/stages/census.hpp:312
  logic and_2714;
  assign and_2714 = and_684_s3_q & less_708;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2715;
  assign sum_2715 = census_left_misses_q + {{17{and_2714}}, and_2713, 1'b0, and_2713};
  // hls/stages/agreement.hpp:521
  logic [19:0] select_2717;
  assign select_2717 = and_526_s3_q ? (equal_2708_s3_q ? 20'h0 : sum_2715) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2783;
  assign select_2783 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:521
  logic select_2786;
  assign select_2786 = and_526_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2789;
  assign and_2789 = whole_2_s3_q & (~(column_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:458
  logic and_2795;
  assign and_2795 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2796;
  assign and_2796 = and_2789 & and_2795;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2783[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2798;
  assign select_2798 = and_2796 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2800;
  assign select_2800 = equal_2708_s3_q ? {11'h0, select_2798} : (sharpness_sums_detail_0_q + {11'h0, select_2798});
  // hls/stages/agreement.hpp:458
  logic and_2807;
  assign and_2807 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2808;
  assign and_2808 = and_2789 & and_2807;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2783[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2810;
  assign select_2810 = and_2808 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2812;
  assign select_2812 = equal_2708_s3_q ? {11'h0, select_2810} : (sharpness_sums_detail_1_q + {11'h0, select_2810});
  logic [8:0] select_2815;
  assign select_2815 = and_2796 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2816;
  assign sum_2816 = (equal_2708_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2815};
  logic [8:0] select_2819;
  assign select_2819 = and_2808 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2820;
  assign sum_2820 = (equal_2708_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2819};
  // hls/stages/agreement.hpp:211
  logic equal_2822;
  assign equal_2822 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2823;
  assign less_2823 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2824;
  assign less_2824 = x_s3_q[4:0] < 5'h3;
  logic not_2825;
  assign not_2825 = ~x_s3_q[1];
  logic [2:0] select_2826;
  assign select_2826 = x_s3_q[0] ? {1'b0, not_2825, 1'b0} : {x_s3_q[1], 1'b0, not_2825};
  logic [5:0] select_2827;
  assign select_2827 = slot_s3_q[2] ? {select_2826[2], 1'b0, select_2826[1], 1'b0, select_2826[0], 1'b0} : {1'b0, select_2826[2], 1'b0, select_2826[1], 1'b0, select_2826[0]};
  logic [11:0] select_2828;
  assign select_2828 = slot_s3_q[1] ? {select_2827[5], 1'b0, select_2827[4], 1'b0, select_2827[3], 1'b0, select_2827[2], 1'b0, select_2827[1], 1'b0, select_2827[0], 1'b0} : {1'b0, select_2827[5], 1'b0, select_2827[4], 1'b0, select_2827[3], 1'b0, select_2827[2], 1'b0, select_2827[1], 1'b0, select_2827[0]};
  logic [23:0] select_2829;
  assign select_2829 = slot_s3_q[0] ? {select_2828[11], 1'b0, select_2828[10], 1'b0, select_2828[9], 1'b0, select_2828[8], 1'b0, select_2828[7], 1'b0, select_2828[6], 1'b0, select_2828[5], 1'b0, select_2828[4], 1'b0, select_2828[3], 1'b0, select_2828[2], 1'b0, select_2828[1], 1'b0, select_2828[0], 1'b0} : {1'b0, select_2828[11], 1'b0, select_2828[10], 1'b0, select_2828[9], 1'b0, select_2828[8], 1'b0, select_2828[7], 1'b0, select_2828[6], 1'b0, select_2828[5], 1'b0, select_2828[4], 1'b0, select_2828[3], 1'b0, select_2828[2], 1'b0, select_2828[1], 1'b0, select_2828[0]};
  // hls/stages/census.hpp:378
  logic and_2833;
  assign and_2833 = less_2824 & (~((sharpness_sums_contrast_1_q & select_2829) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2835;
  assign select_2835 = (less_2823 & and_2833) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2835};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2838;
  assign select_2838 = equal_2822 ? (less_2823 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2843;
  assign and_2843 = less_2824 & (~((sharpness_sums_contrast_0_q & select_2829) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2845;
  assign select_2845 = (less_2823 & and_2843) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2845};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2848;
  assign select_2848 = equal_2822 ? (less_2823 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2850;
  assign select_2850 = equal_2822 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2852;
  assign select_2852 = equal_2822 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2854;
  assign select_2854 = equal_2822 ? {sharpness_comparing_contrast_0_q[0], and_2843} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2856;
  assign select_2856 = equal_2822 ? {sharpness_comparing_contrast_1_q[0], and_2833} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2861;
  assign select_2861 = drew_q ? (equal_2822 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2865;
  assign select_2865 = drew_q ? (equal_2822 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2866;
  assign equal_2866 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2867;
  assign xor_2867 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2870;
  assign select_2870 = (equal_2866 | xor_2867) ? (five_times[0] & xor_2867) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2872;
  assign select_2872 = drew_q ? (equal_2822 ? select_2870 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2873;
  assign xor_2873 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2876;
  assign select_2876 = (equal_2866 | xor_2873) ? (five_times_2[0] & xor_2873) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2878;
  assign select_2878 = drew_q ? (equal_2822 ? select_2876 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2879;
  assign xor_2879 = sharpness_comparing_contrast_0_q[1] ^ and_2833;
  logic select_2882;
  assign select_2882 = (equal_2866 | xor_2879) ? (and_2833 & xor_2879) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2884;
  assign select_2884 = drew_q ? (equal_2822 ? select_2882 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2885;
  assign xor_2885 = sharpness_comparing_contrast_1_q[1] ^ and_2843;
  logic select_2888;
  assign select_2888 = (equal_2866 | xor_2885) ? (and_2843 & xor_2885) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2890;
  assign select_2890 = drew_q ? (equal_2822 ? select_2888 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3006;
  assign select_3006 = and_2998_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3004_s3_q});
  // hls/stages/agreement.hpp:789
  logic and_3009;
  assign and_3009 = not_551_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3014;
  assign and_3014 = not_551_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3019;
  assign and_3019 = not_551_s3_q & (drew_q & (ends_cell_s3_q & and_2449_s3_q));
  // hls/stages/agreement.hpp:1106
  logic not_3023;
  assign not_3023 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_3032;
  assign select_3032 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3033;
  assign difference_3033 = {1'b0, explained_2_s3_q} - {1'b0, select_3032};
  logic [4:0] e;
  assign e = {difference_3033[3], difference_3033} + (equal_546_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_3036;
  assign sum_3036 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1107
  logic not_3040;
  assign not_3040 = ~(equal_2507 ? and_2528 : (~({sum_3036, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:789
  logic and_3043;
  assign and_3043 = ends_cell_s3_q & (not_3023 & (centres_values_1_textured_s3_q & not_3040));
  logic and_3045;
  assign and_3045 = not_551_s3_q & (drew_q & and_3043);
  // hls/stages/agreement.hpp:1133
  logic less_3048;
  assign less_3048 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3049;
  assign select_3049 = less_3048 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3052;
  assign select_3052 = less_3048 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1134
  logic [10:0] sum_3053;
  assign sum_3053 = {1'b0, select_3052} + {3'h0, select_3052[9:2]};
  logic and_3055;
  assign and_3055 = (~(select_3049[9:4] == 6'h0)) & ({sum_3053, select_3052[1:0]} < {3'h0, select_3049});
  // hls/stages/agreement.hpp:1143
  logic [9:0] select_3058;
  assign select_3058 = x_s3_q[6] ? (equal_2057_s3_q ? 10'h0 : (and_3055 ? select_3049 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:789
  logic [9:0] select_3059;
  assign select_3059 = equal_550_s3_q ? select_3058 : 10'h0;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3061;
  assign select_3061 = and_2998_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3059});
  logic [13:0] select_3068;
  assign select_3068 = and_2998_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3066_s3_q});
  // hls/stages/agreement.hpp:1111
  logic and_3070;
  assign and_3070 = not_3023 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:789
  logic and_3073;
  assign and_3073 = not_551_s3_q & (drew_q & (ends_cell_s3_q & and_3070));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3075;
  assign select_3075 = and_2998_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3073});
  // hls/stages/agreement.hpp:1111
  logic and_3077;
  assign and_3077 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3040);
  // hls/stages/agreement.hpp:789
  logic and_3081;
  assign and_3081 = not_551_s3_q & (drew_q & (ends_cell_s3_q & (not_3023 & and_3077)));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3083;
  assign select_3083 = and_2998_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3081});
  logic [13:0] select_3102;
  assign select_3102 = and_2998_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3100_s3_q});
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3177;
  assign select_3177 = drew_q ? (equal_2153_s3_q ? (and_3159_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3178;
  assign select_3178 = equal_550_s3_q ? 8'h0 : select_3177;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3180;
  assign select_3180 = and_3158_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3178[7]}}, select_3178});
  // hls/stages/agreement.hpp:789
  logic and_3183;
  assign and_3183 = not_551_s3_q & (drew_q & (and_3159_s3_q & equal_2153_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3185;
  assign select_3185 = and_3158_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3183});
  // hls/stages/registration.hpp:107
  logic and_3187;
  assign and_3187 = and_3159_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3189;
  assign select_3189 = drew_q ? (equal_2153_s3_q ? {and_3187, and_3159_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3190;
  assign select_3190 = equal_550_s3_q ? 2'h0 : select_3189;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3191;
  assign sum_3191 = registration_half_votes_down_q + {{5{select_3190[1]}}, select_3190};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3197;
  assign select_3197 = drew_q ? (equal_2153_s3_q ? {and_3195_s3_q, and_3159_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3198;
  assign select_3198 = equal_550_s3_q ? 2'h0 : select_3197;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3199;
  assign sum_3199 = registration_half_votes_up_q + {{5{select_3198[1]}}, select_3198};
  // hls/stages/registration.hpp:107
  logic and_3202;
  assign and_3202 = and_3159_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3204;
  assign select_3204 = drew_q ? (equal_2153_s3_q ? {and_3202, and_3159_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3205;
  assign select_3205 = equal_550_s3_q ? 2'h0 : select_3204;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3206;
  assign sum_3206 = registration_half_half_votes_down_q + {{5{select_3205[1]}}, select_3205};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3211;
  assign select_3211 = drew_q ? (equal_2153_s3_q ? {and_3209_s3_q, and_3159_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3212;
  assign select_3212 = equal_550_s3_q ? 2'h0 : select_3211;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3213;
  assign sum_3213 = registration_half_half_votes_up_q + {{5{select_3212[1]}}, select_3212};
  // hls/stages/agreement.hpp:789
  logic and_3247;
  assign and_3247 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & less_2088_s3_q));
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_3254;
  assign select_3254 = or_2092_s3_q ? 12'h0 : (equal_3252_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_3257;
  assign select_3257 = x_s3_q[6] ? (equal_2057_s3_q ? 12'h0 : (less_2088_s3_q ? select_3254 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_3258;
  assign select_3258 = equal_550_s3_q ? select_3257 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3259;
  assign and_3259 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_3262;
  assign and_3262 = not_2422_s3_q & (less_2088_s3_q & ({and_3259, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:789
  logic and_3264;
  assign and_3264 = equal_550_s3_q & (x_s3_q[6] & and_3262);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3266;
  assign sum_3266 = {{2{select_3258[11]}}, select_3258} + (and_3264 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_3269;
  assign select_3269 = or_2092_s3_q ? 12'h0 : (equal_3252_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_3272;
  assign select_3272 = x_s3_q[6] ? (equal_2057_s3_q ? 12'h0 : (less_2088_s3_q ? select_3269 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_3273;
  assign select_3273 = equal_550_s3_q ? select_3272 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3275;
  assign sum_3275 = {{2{select_3273[11]}}, select_3273} + (and_3264 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3277;
  assign not_3277 = ~all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_3280;
  assign and_3280 = not_2422_s3_q & (less_2088_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3277, 1'b0}));
  // hls/stages/agreement.hpp:789
  logic and_3286;
  assign and_3286 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & (less_2088_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3287;
  assign not_3287 = ~and_3286;
  logic less_3288;
  assign less_3288 = $signed({9'h1, {2{not_3287}}, and_3286}) < $signed(registration_up_q[13:2]);
  logic select_3289;
  assign select_3289 = (equal_550_s3_q & (x_s3_q[6] & and_3280)) ? less_3288 : registration_enough_q;
  // hls/stages/agreement.hpp:1143
  logic and_3293;
  assign and_3293 = x_s3_q[6] & (not_2422_s3_q & (less_2088_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:789
  logic and_3294;
  assign and_3294 = equal_550_s3_q & and_3293;
  // hls/stages/registration.hpp:242
  logic less_3295;
  assign less_3295 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3297;
  assign less_3297 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3299;
  assign equal_3299 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:789
  logic and_3303;
  assign and_3303 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & (less_2088_s3_q & equal_3299)));
  // hls/stages/agreement.hpp:1143
  logic and_3310;
  assign and_3310 = x_s3_q[6] & (not_2422_s3_q & (less_2088_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3313;
  assign equal_3313 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1143
  logic and_3316;
  assign and_3316 = not_2422_s3_q & (less_2088_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3313));
  // hls/stages/registration.hpp:244
  logic and_3320;
  assign and_3320 = (equal_550_s3_q & (x_s3_q[6] & and_3316)) & (less_3297 | less_3295);
  // hls/stages/agreement.hpp:1143
  logic and_3325;
  assign and_3325 = not_2422_s3_q & (less_2088_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3313)));
  // hls/stages/registration.hpp:244
  logic and_3328;
  assign and_3328 = registration_votes_up_q & registration_other_down_q;
  logic select_3330;
  assign select_3330 = registration_votes_down_q ? (registration_other_up_q | and_3328) : and_3328;
  // hls/stages/registration.hpp:138
  logic and_3332;
  assign and_3332 = (equal_550_s3_q & (x_s3_q[6] & and_3325)) & (registration_other_enough_q & select_3330);
  // hls/stages/registration.hpp:245
  logic or_3335;
  assign or_3335 = registration_moved_q | (registration_enough_q & (and_3320 | and_3332));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3420;
  assign select_3420 = sample_pair_whole_s3_q ? (equal_2143_s3_q ? patches_place_0_slope_q : select_2248[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3425;
  assign select_3425 = sample_pair_whole_s3_q ? (equal_2143_s3_q ? patches_place_1_slope_q : select_2277[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3427;
  assign select_3427 = equal_2143_s3_q ? patches_valid_0_q : (select_2142_s3_q ? patches_valid_0_q : select_2245[0]);
  // hls/stages/agreement.hpp:276
  logic select_3430;
  assign select_3430 = sample_pair_whole_s3_q ? (and_2268 ? (sample_present_s3_q & select_3427) : select_3427) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3432;
  assign select_3432 = equal_2143_s3_q ? patches_valid_1_q : (select_2142_s3_q ? select_2245[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3435;
  assign select_3435 = sample_pair_whole_s3_q ? (and_2288 ? (sample_present_s3_q & select_3432) : select_3432) : patches_valid_1_q;
  logic [5:0] select_3438;
  assign select_3438 = sample_pair_whole_s3_q ? (select_2266[5] ? {1'b1, select_2266[4:0]} : (select_2266 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3441;
  assign select_3441 = sample_pair_whole_s3_q ? (select_2286[5] ? {1'b1, select_2286[4:0]} : (select_2286 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3444;
  assign select_3444 = sample_pair_whole_s3_q ? (select_2299[4] ? {1'b1, select_2299[3:0]} : (select_2299 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3447;
  assign select_3447 = sample_pair_whole_s3_q ? (select_2304[4] ? {1'b1, select_2304[3:0]} : (select_2304 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:521
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3866_s3_q, parity_3862_s3_q, xor_3850_s3_q, parity_3822_s3_q, parity_3760_s3_q, parity_3631_s3_q} + (equal_3867_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3871;
  assign select_3871 = equal_2229_s3_q ? patches_sums_values_0_q : (equal_2231_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3872;
  assign select_3872 = equal_2231_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3874;
  assign select_3874 = equal_2231_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3876;
  assign select_3876 = equal_2231_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3878;
  assign select_3878 = equal_2231_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3880;
  assign select_3880 = equal_2231_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3882;
  assign select_3882 = equal_2231_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3884;
  assign select_3884 = equal_2231_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3886;
  assign select_3886 = equal_2231_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3888;
  assign select_3888 = equal_2231_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3890;
  assign select_3890 = equal_2231_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3892;
  assign select_3892 = equal_2231_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3894;
  assign select_3894 = equal_2231_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3896;
  assign select_3896 = equal_2231_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3898;
  assign select_3898 = equal_2231_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3900;
  assign select_3900 = equal_2231_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3902;
  assign select_3902 = equal_2231_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:595
  logic or_4007;
  assign or_4007 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4006_s3_q;
  logic or_4010;
  assign or_4010 = equal_3998_s3_q | (less_4000_s3_q | (less_4001_s3_q | or_4007));
  // hls/stages/patches.hpp:575
  logic not_4011;
  assign not_4011 = ~or_4010;
  // hls/stages/patches.hpp:556
  logic and_4012;
  assign and_4012 = equal_2395_s3_q & not_4011;
  // hls/stages/patches.hpp:184
  logic and_4015;
  assign and_4015 = equal_2229_s3_q & (less_2392_s3_q ? (not_2394_s3_q & and_4012) : and_4012);
  // hls/stages/patches.hpp:653
  logic not_4016;
  assign not_4016 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:556
  logic and_4018;
  assign and_4018 = equal_2395_s3_q & (patches_second_s3_q & not_4011);
  // hls/stages/patches.hpp:184
  logic and_4021;
  assign and_4021 = equal_2229_s3_q & (less_2392_s3_q ? (not_2394_s3_q & and_4018) : and_4018);
  // hls/stages/patches.hpp:653
  logic not_4022;
  assign not_4022 = ~and_4021;
  // hls/stages/patches.hpp:188
  logic and_4024;
  assign and_4024 = and_4015 & (not_4016 & not_4022);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4026;
  assign sum_4026 = {7'h0, and_4024} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:593
  logic [7:0] select_4052;
  assign select_4052 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:592
  logic [5:0] select_4053;
  assign select_4053 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4054;
  assign sum_4054 = {2'h0, select_3986_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4055;
  assign sum_4055 = {select_4053[5], select_4053} + {{3{sum_4054[3]}}, sum_4054};
  // hls/stages/patches.hpp:593
  logic [17:0] product_4056;
  assign product_4056 = $signed({{10{select_4052[7]}}, select_4052}) * $signed({{8{sum_4055[6]}}, sum_4055, select_3986_s3_q[2:0]});
  // hls/stages/patches.hpp:594
  logic [13:0] difference_4057;
  assign difference_4057 = {{6{select_4051_s3_q[7]}}, select_4051_s3_q} - {product_4056[17], product_4056[17:5]};
  // hls/stages/patches.hpp:600
  logic less_4058;
  assign less_4058 = $signed({{7{difference_4028[6]}}, difference_4028}) < $signed(difference_4057);
  // hls/stages/patches.hpp:556
  logic and_4061;
  assign and_4061 = equal_2395_s3_q & (not_4011 & (~less_4058));
  // hls/stages/patches.hpp:184
  logic and_4064;
  assign and_4064 = equal_2229_s3_q & (less_2392_s3_q ? (not_2394_s3_q & and_4061) : and_4061);
  // hls/stages/patches.hpp:656
  logic and_4065;
  assign and_4065 = and_4064 & and_4024;
  logic [7:0] sum_4066;
  assign sum_4066 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4065};
  // hls/stages/patches.hpp:556
  logic and_4070;
  assign and_4070 = not_4011 & (~($signed(difference_4057) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4071;
  assign and_4071 = equal_2395_s3_q & and_4070;
  // hls/stages/patches.hpp:184
  logic and_4074;
  assign and_4074 = equal_2229_s3_q & (less_2392_s3_q ? (not_2394_s3_q & and_4071) : and_4071);
  // hls/stages/patches.hpp:657
  logic and_4075;
  assign and_4075 = and_4074 & and_4024;
  logic [7:0] sum_4076;
  assign sum_4076 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4075};
  // hls/stages/patches.hpp:188
  logic and_4078;
  assign and_4078 = and_4015 & (and_4021 & not_4016);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4080;
  assign sum_4080 = {7'h0, and_4078} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:656
  logic and_4082;
  assign and_4082 = and_4064 & and_4078;
  logic [7:0] sum_4083;
  assign sum_4083 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4082};
  // hls/stages/patches.hpp:657
  logic and_4085;
  assign and_4085 = and_4074 & and_4078;
  logic [7:0] sum_4086;
  assign sum_4086 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4085};
  // hls/stages/patches.hpp:188
  logic and_4088;
  assign and_4088 = and_4015 & (patches_lower_s3_q & not_4022);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4090;
  assign sum_4090 = {7'h0, and_4088} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:656
  logic and_4092;
  assign and_4092 = and_4064 & and_4088;
  logic [7:0] sum_4093;
  assign sum_4093 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4092};
  // hls/stages/patches.hpp:657
  logic and_4095;
  assign and_4095 = and_4074 & and_4088;
  logic [7:0] sum_4096;
  assign sum_4096 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4095};
  // hls/stages/patches.hpp:188
  logic and_4098;
  assign and_4098 = and_4015 & (patches_lower_s3_q & and_4021);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4100;
  assign sum_4100 = {7'h0, and_4098} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:656
  logic and_4102;
  assign and_4102 = and_4064 & and_4098;
  logic [7:0] sum_4103;
  assign sum_4103 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4102};
  // hls/stages/patches.hpp:657
  logic and_4105;
  assign and_4105 = and_4074 & and_4098;
  logic [7:0] sum_4106;
  assign sum_4106 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4105};
  // hls/stages/agreement.hpp:1224
  logic equal_4107;
  assign equal_4107 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1131
  logic less_4108;
  assign less_4108 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:789
  logic and_4112;
  assign and_4112 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & (equal_4107 & less_4108)));
  // hls/stages/agreement.hpp:1143
  logic and_4117;
  assign and_4117 = x_s3_q[6] & (not_2422_s3_q & (less_4108 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:789
  logic and_4118;
  assign and_4118 = equal_550_s3_q & and_4117;
  // hls/stages/patches.hpp:619
  logic [7:0] or_4120;
  assign or_4120 = (and_4112 ? patches_quarters_0_places_q : 8'h0) | (and_4118 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1143
  logic and_4124;
  assign and_4124 = x_s3_q[6] & (not_2422_s3_q & (less_4108 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:789
  logic and_4125;
  assign and_4125 = equal_550_s3_q & and_4124;
  // hls/stages/agreement.hpp:1143
  logic and_4131;
  assign and_4131 = x_s3_q[6] & (not_2422_s3_q & (less_4108 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:789
  logic and_4132;
  assign and_4132 = equal_550_s3_q & and_4131;
  // hls/stages/patches.hpp:619
  logic [7:0] or_4134;
  assign or_4134 = (or_4120 | (and_4125 ? patches_quarters_2_places_q : 8'h0)) | (and_4132 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_4138;
  assign select_4138 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:789
  logic and_4142;
  assign and_4142 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & (less_4108 & select_4138)));
  // hls/stages/patches.hpp:620
  logic [7:0] select_4144;
  assign select_4144 = and_4112 ? (and_4142 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4146;
  assign select_4146 = and_4118 ? (and_4142 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4149;
  assign select_4149 = and_4125 ? (and_4142 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4152;
  assign select_4152 = and_4132 ? (and_4142 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:621
  logic [7:0] select_4155;
  assign select_4155 = and_4112 ? (and_4142 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4157;
  assign select_4157 = and_4118 ? (and_4142 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4160;
  assign select_4160 = and_4125 ? (and_4142 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4163;
  assign select_4163 = and_4132 ? (and_4142 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4165;
  assign sum_4165 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1143
  logic and_4169;
  assign and_4169 = x_s3_q[6] & (not_2422_s3_q & (less_4108 & (sum_4165[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_4170;
  assign and_4170 = equal_550_s3_q & and_4169;
  // hls/stages/patches.hpp:616
  logic [7:0] select_4173;
  assign select_4173 = and_4170 ? (patches_word_places_q + (and_4118 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4176;
  assign select_4176 = and_4170 ? (patches_word_up_q + (and_4118 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4179;
  assign select_4179 = and_4170 ? (patches_word_down_q + (and_4118 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:602
  logic [5:0] select_4183;
  assign select_4183 = ($signed(difference_4057[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4057[5:0];
  logic [5:0] select_4184;
  assign select_4184 = ($signed(14'h10) < $signed(difference_4057)) ? 6'h10 : select_4183;
  // hls/stages/patches.hpp:556
  logic [5:0] select_4186;
  assign select_4186 = equal_2395_s3_q ? (or_4010 ? 6'h0 : select_4184) : 6'h0;
  logic [5:0] select_4188;
  assign select_4188 = less_2392_s3_q ? (equal_2393_s3_q ? 6'h0 : select_4186) : select_4186;
  // hls/stages/patches.hpp:659
  logic [5:0] select_4190;
  assign select_4190 = and_4015 ? (equal_2229_s3_q ? select_4188 : 6'h0) : 6'h0;
  logic [11:0] sum_4191;
  assign sum_4191 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4190[5]}}, select_4190};
  // hls/stages/agreement.hpp:789
  logic and_4195;
  assign and_4195 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q & (equal_3299 & less_4108)));
  // hls/stages/agreement.hpp:1143
  logic and_4199;
  assign and_4199 = x_s3_q[6] & (not_2422_s3_q & (less_4108 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_4200;
  assign and_4200 = equal_550_s3_q & and_4199;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4202;
  assign select_4202 = and_4195 ? (and_4200 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:645
  logic or_4206;
  assign or_4206 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic or_4209;
  assign or_4209 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:647
  logic [8:0] sum_4210;
  assign sum_4210 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:642
  logic select_4212;
  assign select_4212 = and_4195 ? (and_4200 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_4217;
  assign and_4217 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:642
  logic [2:0] select_4219;
  assign select_4219 = and_4200 ? {and_4217, patches_found_q[2:1]} : (and_4195 ? {and_4217, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:641
  logic or_4223;
  assign or_4223 = patches_partly_q | (patches_doubted_q & (~and_4200));
  // hls/stages/patches.hpp:642
  logic select_4226;
  assign select_4226 = and_4195 ? (and_4200 ? or_4223 : (and_4195 ? or_4223 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:640
  logic select_4227;
  assign select_4227 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:629
  logic [7:0] select_4231;
  assign select_4231 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:601
  logic [10:0] sum_4233;
  assign sum_4233 = {sum_4055[6], sum_4055, select_3986_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:556
  logic and_4236;
  assign and_4236 = equal_2395_s3_q & (not_4011 & ({{5{sum_4233[10]}}, sum_4233} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4239;
  assign and_4239 = equal_2229_s3_q & (less_2392_s3_q ? (not_2394_s3_q & and_4236) : and_4236);
  // hls/stages/patches.hpp:188
  logic and_4240;
  assign and_4240 = and_4015 & and_4239;
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4241;
  assign sum_4241 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4240};
  // hls/stages/patches.hpp:650
  logic [12:0] product_4242;
  assign product_4242 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4202};
  // hls/stages/patches.hpp:188
  logic and_4248;
  assign and_4248 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_4253;
  assign select_4253 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:630
  logic or_4257;
  assign or_4257 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:631
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:632
  logic select_4264;
  assign select_4264 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:633
  logic and_4270;
  assign and_4270 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4271;
  assign sum_4271 = patches_age_q + {9'h0, and_4270};
  logic [9:0] select_4274;
  assign select_4274 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4271)) : sum_4271;
  // hls/stages/agreement.hpp:1189
  logic or_4331;
  assign or_4331 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1218
  logic equal_4333;
  assign equal_4333 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1227
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1228
  logic select_4339;
  assign select_4339 = (equal_4333 & equal_4107) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1136
  logic [10:0] sum_4342;
  assign sum_4342 = {1'b0, select_3052} + {2'h0, select_3052[9:1]};
  logic select_4345;
  assign select_4345 = (select_3049[9:3] == 7'h0) ? ((~or_4331) & (~select_4339)) : (~({sum_4342, select_3052[0]} < {2'h0, select_3049}));
  // hls/stages/agreement.hpp:1143
  logic [47:0] select_4347;
  assign select_4347 = x_s3_q[6] ? (equal_2057_s3_q ? good_q : {select_4345, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:789
  logic select_4351;
  assign select_4351 = equal_550_s3_q ? ((x_s3_q[6] & good_known_q) | equal_2737_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1218
  logic equal_4352;
  assign equal_4352 = x_s3_q[6:3] == 4'ha;
  logic equal_4354;
  assign equal_4354 = x_s3_q[6:3] == 4'hc;
  logic equal_4355;
  assign equal_4355 = x_s3_q[6:3] == 4'hb;
  logic equal_4356;
  assign equal_4356 = x_s3_q[6:3] == 4'h9;
  logic equal_4357;
  assign equal_4357 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_4359;
  assign select_4359 = equal_4356 ? counts_skin_unproven_q : (equal_4357 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4361;
  assign select_4361 = equal_4355 ? counts_regions_bad_q : (equal_4352 ? counts_nearer_q : select_4359);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4354 ? counts_on_skin_q : select_4361;
  // hls/stages/agreement.hpp:1223
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1231
  logic select_4364;
  assign select_4364 = (equal_4352 & equal_4107) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1149
  logic not_4365;
  assign not_4365 = ~hidden_for_q[7];
  logic [7:0] select_4367;
  assign select_4367 = select_4364 ? (hidden_for_q + {7'h0, not_4365}) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_4369;
  assign select_4369 = equal_550_s3_q ? (equal_2737_s3_q ? select_4367 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_4370;
  assign select_4370 = equal_4107 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_4372;
  assign select_4372 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4374;
  assign select_4374 = equal_4357 ? cfg_unproven_skin_limit_i : (equal_4333 ? cfg_unproven_limit_i : select_4372);
  logic [7:0] select_4376;
  assign select_4376 = equal_4352 ? cfg_regions_limit_i : (equal_4356 ? cfg_hidden_limit_i : select_4374);
  logic [7:0] limit;
  assign limit = equal_4354 ? cfg_regions_limit_i : (equal_4355 ? {cfg_on_skin_limit_i, 3'h0} : select_4376);
  // hls/stages/agreement.hpp:1232
  logic not_4379;
  assign not_4379 = ~x_s3_q[2];
  logic [3:0] select_4380;
  assign select_4380 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4379, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4379};
  logic [7:0] select_4381;
  assign select_4381 = x_s3_q[0] ? {select_4380[3], 1'b0, select_4380[2], 1'b0, select_4380[1], 1'b0, select_4380[0], 1'b0} : {1'b0, select_4380[3], 1'b0, select_4380[2], 1'b0, select_4380[1], 1'b0, select_4380[0]};
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_4385;
  assign select_4385 = equal_4356 ? counts_skin_supervised_q : (equal_4357 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4387;
  assign select_4387 = equal_4355 ? counts_skin_textured_q : (equal_4352 ? counts_textured_q : select_4385);
  logic [13:0] of;
  assign of = equal_4354 ? counts_textured_q : select_4387;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_4389;
  assign select_4389 = ((limit & select_4381) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4370} + {1'b0, select_4389};
  // hls/stages/agreement.hpp:789
  logic select_4394;
  assign select_4394 = equal_550_s3_q ? (equal_4107 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1229
  logic and_4399;
  assign and_4399 = too_much_q & (~(equal_4357 & equal_4107));
  // hls/stages/agreement.hpp:1230
  logic select_4404;
  assign select_4404 = (over[14] & equal_4107) ? (and_4399 | ((equal_4357 | equal_4356) | (x_s3_q[6:3] == 4'hf))) : and_4399;
  // hls/stages/agreement.hpp:1126
  logic and_4409;
  assign and_4409 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1232
  logic select_4410;
  assign select_4410 = (equal_4354 & equal_4107) ? and_4409 : overlooks_q;
  // hls/stages/agreement.hpp:789
  logic [2:0] select_4412;
  assign select_4412 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4414;
  assign select_4414 = equal_550_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4412 : box_textured_columns_values_0_q);
  logic [2:0] select_4415;
  assign select_4415 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4417;
  assign select_4417 = equal_550_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4415 : box_textured_columns_values_1_q);
  logic [2:0] select_4418;
  assign select_4418 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4420;
  assign select_4420 = equal_550_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4418 : box_textured_columns_values_2_q);
  logic [2:0] select_4421;
  assign select_4421 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4423;
  assign select_4423 = equal_550_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4421 : box_textured_columns_values_3_q);
  logic [2:0] select_4424;
  assign select_4424 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4426;
  assign select_4426 = equal_550_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4424 : box_textured_columns_values_4_q);
  logic [4:0] select_4428;
  assign select_4428 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4430;
  assign select_4430 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4432;
  assign select_4432 = equal_550_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4430 : box_explained_columns_values_0_q);
  logic [2:0] select_4433;
  assign select_4433 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4435;
  assign select_4435 = equal_550_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4433 : box_explained_columns_values_1_q);
  logic [2:0] select_4436;
  assign select_4436 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4438;
  assign select_4438 = equal_550_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4436 : box_explained_columns_values_2_q);
  logic [2:0] select_4439;
  assign select_4439 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4441;
  assign select_4441 = equal_550_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4439 : box_explained_columns_values_3_q);
  logic [2:0] select_4442;
  assign select_4442 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4444;
  assign select_4444 = equal_550_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4442 : box_explained_columns_values_4_q);
  logic [4:0] select_4446;
  assign select_4446 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4449;
  assign select_4449 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4451;
  assign select_4451 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4453;
  assign select_4453 = equal_550_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4451 : box_shown_columns_values_1_q);
  logic [2:0] select_4454;
  assign select_4454 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4456;
  assign select_4456 = equal_550_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4454 : box_shown_columns_values_2_q);
  logic [2:0] select_4457;
  assign select_4457 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4459;
  assign select_4459 = equal_550_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4457 : box_shown_columns_values_3_q);
  logic [2:0] select_4460;
  assign select_4460 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4462;
  assign select_4462 = equal_550_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4460 : box_shown_columns_values_4_q);
  logic [4:0] select_4464;
  assign select_4464 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4467;
  assign select_4467 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4469;
  assign select_4469 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4471;
  assign select_4471 = equal_550_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4469 : box_nearer_columns_values_1_q);
  logic [2:0] select_4472;
  assign select_4472 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4474;
  assign select_4474 = equal_550_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4472 : box_nearer_columns_values_2_q);
  logic [2:0] select_4475;
  assign select_4475 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4477;
  assign select_4477 = equal_550_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4475 : box_nearer_columns_values_3_q);
  logic [2:0] select_4478;
  assign select_4478 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4480;
  assign select_4480 = equal_550_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4478 : box_nearer_columns_values_4_q);
  logic [4:0] select_4482;
  assign select_4482 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1309
  logic [1:0] select_4527;
  assign select_4527 = and_4526_s3_q ? {and_2558, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1310
  logic and_4528;
  assign and_4528 = proven_q & less_4516;
  // hls/stages/agreement.hpp:438
  logic select_4531;
  assign select_4531 = and_2488_s3_q ? (less_2489_s3_q ? (select_4527[0] & and_4528) : seen_q) : seen_q;
  logic select_4534;
  assign select_4534 = and_2488_s3_q ? (less_2489_s3_q ? (select_4527[1] & and_4528) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1240
  logic or_4542;
  assign or_4542 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4541_s3_q;
  // hls/stages/agreement.hpp:1242
  logic not_4550;
  assign not_4550 = ~(or_4331 | not_4535);
  // hls/stages/agreement.hpp:789
  logic and_4554;
  assign and_4554 = equal_550_s3_q & (equal_2737_s3_q & (not_4550 & (select_4339 | select_4404)));
  logic and_4557;
  assign and_4557 = equal_2737_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1151
  logic or_4561;
  assign or_4561 = select_2872 | (select_2884 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:789
  logic and_4568;
  assign and_4568 = equal_550_s3_q & (equal_2737_s3_q & (not_4550 & (select_2878 | select_2890)));
  // hls/stages/agreement.hpp:1151
  logic and_4573;
  assign and_4573 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4367 < cfg_hidden_frames_i));
  logic select_4579;
  assign select_4579 = (not_4535 | (select_4410 & not_4244)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:789
  logic and_4588;
  assign and_4588 = equal_550_s3_q & (x_s3_q[6] & (not_2422_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4596;
  assign select_4596 = equal_2079_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4594_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4597;
  assign select_4597 = equal_2077_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4596;
  logic [31:0] select_4598;
  assign select_4598 = equal_2075_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4597;
  logic [31:0] select_4599;
  assign select_4599 = equal_2073_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4598;
  logic [31:0] select_4600;
  assign select_4600 = equal_2071_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4599;
  logic [31:0] select_4601;
  assign select_4601 = equal_2069_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4600;
  logic [31:0] select_4602;
  assign select_4602 = equal_2067_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4601;
  logic [31:0] select_4603;
  assign select_4603 = equal_2065_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4602;
  // hls/stages/agreement.hpp:1139
  logic [9:0] select_4604;
  assign select_4604 = less_3048 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1143
  logic [31:0] select_4605;
  assign select_4605 = equal_2057_s3_q ? select_4603 : {2'h0, select_4604, select_3052, select_3049};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_526_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_722_s3_q, and_721, less_716_s3_q, and_715_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_709, and_685_s3_q, and_684_s3_q, and_659_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q, less_640_s3_q, less_639_s3_q, less_638_s3_q, less_637_s3_q, less_636_s3_q, less_635_s3_q, less_634_s3_q, less_633_s3_q, less_632_s3_q, less_631_s3_q, less_630_s3_q, less_629_s3_q, less_628_s3_q};
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
  assign registration_sums_waddr = {sum_2063_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2122_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2121, sum_2117};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2151_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2228_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2200_s3_q};
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
  assign patches_right_0_waddr = {select_2259_s3_q, select_2256};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2268);
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
  assign patches_right_1_waddr = {select_2259_s3_q, select_2285};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2288);
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
  assign patches_left_waddr = {select_2307, select_2306_s3_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2313);
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
  assign patches_rows_wdata = select_2410;
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
  assign regions_waddr = {region_row_s3_q, or_2420_s3_q, or_2417_s3_q, or_2414_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2454_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2453, sum_2443, sum_2438};
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
  assign map_waddr = {sum_2494_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2568_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2558, is_seen};
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
      patches_on_skin_most_q <= 8'h0;
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
      census_left_misses_q <= select_2717;
      sharpness_before_last_mask_q <= select_2786;
      sharpness_sums_detail_0_q <= and_526_s3_q ? select_2800 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_526_s3_q ? select_2812 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_526_s3_q ? sum_2816 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_526_s3_q ? sum_2820 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2838 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2848 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2850 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2852 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2854 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2856 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2861;
      sharpness_comparing_carry_1_q <= select_2865;
      sharpness_comparing_less_detail_0_q <= select_2872;
      sharpness_comparing_less_detail_1_q <= select_2878;
      sharpness_comparing_less_contrast_0_q <= select_2884;
      sharpness_comparing_less_contrast_1_q <= select_2890;
      counts_supervised_q <= select_3006;
      counts_textured_q <= and_2998_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3009});
      counts_explained_q <= and_2998_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3014});
      counts_nearer_q <= and_2998_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3019});
      counts_unproven_q <= and_2998_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3045});
      counts_regions_bad_q <= select_3061;
      counts_skin_supervised_q <= select_3068;
      counts_skin_textured_q <= select_3075;
      counts_skin_unproven_q <= select_3083;
      counts_on_skin_q <= select_3102;
      registration_half_across_q <= select_3180;
      registration_half_measured_q <= select_3185;
      registration_half_votes_down_q <= and_3158_s3_q ? 7'h0 : sum_3191;
      registration_half_votes_up_q <= and_3158_s3_q ? 7'h0 : sum_3199;
      registration_half_half_votes_down_q <= and_3158_s3_q ? 7'h0 : sum_3206;
      registration_half_half_votes_up_q <= and_3158_s3_q ? 7'h0 : sum_3213;
      registration_down_q <= and_3247 ? sum_3266 : registration_down_q;
      registration_up_q <= and_3247 ? sum_3275 : registration_up_q;
      registration_enough_q <= select_3289;
      registration_votes_down_q <= and_3294 ? less_3295 : registration_votes_down_q;
      registration_votes_up_q <= and_3294 ? less_3297 : registration_votes_up_q;
      registration_other_enough_q <= and_3303 ? select_3289 : registration_other_enough_q;
      registration_other_down_q <= and_3303 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3303 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_550_s3_q & and_3310)) & or_3335;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2247 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2249 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2250 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3420;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2276 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2278 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2279 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3425;
      patches_valid_0_q <= select_3430;
      patches_valid_1_q <= select_3435;
      patches_right_next_0_q <= select_3438;
      patches_right_next_1_q <= select_3441;
      patches_left_next_0_q <= select_3444;
      patches_left_next_1_q <= select_3447;
      patches_sums_values_0_q <= select_3871;
      patches_sums_values_1_q <= equal_2229_s3_q ? patches_sums_values_1_q : select_3872;
      patches_sums_values_2_q <= equal_2229_s3_q ? patches_sums_values_2_q : select_3874;
      patches_sums_values_3_q <= equal_2229_s3_q ? patches_sums_values_3_q : select_3876;
      patches_sums_values_4_q <= equal_2229_s3_q ? patches_sums_values_4_q : select_3878;
      patches_sums_values_5_q <= equal_2229_s3_q ? patches_sums_values_5_q : select_3880;
      patches_sums_values_6_q <= equal_2229_s3_q ? patches_sums_values_6_q : select_3882;
      patches_sums_values_7_q <= equal_2229_s3_q ? patches_sums_values_7_q : select_3884;
      patches_sums_values_8_q <= equal_2229_s3_q ? patches_sums_values_8_q : select_3886;
      patches_sums_values_9_q <= equal_2229_s3_q ? patches_sums_values_9_q : select_3888;
      patches_sums_values_10_q <= equal_2229_s3_q ? patches_sums_values_10_q : select_3890;
      patches_sums_values_11_q <= equal_2229_s3_q ? patches_sums_values_11_q : select_3892;
      patches_sums_values_12_q <= equal_2229_s3_q ? patches_sums_values_12_q : select_3894;
      patches_sums_values_13_q <= equal_2229_s3_q ? patches_sums_values_13_q : select_3896;
      patches_sums_values_14_q <= equal_2229_s3_q ? patches_sums_values_14_q : select_3898;
      patches_sums_values_15_q <= equal_2229_s3_q ? patches_sums_values_15_q : select_3900;
      patches_sums_values_16_q <= equal_2229_s3_q ? patches_sums_values_16_q : select_3902;
      patches_best_differing_q <= select_2410[9:0];
      patches_best_column_q <= select_2410[14:10];
      patches_quarters_0_places_q <= sum_4026;
      patches_quarters_0_up_q <= sum_4066;
      patches_quarters_0_down_q <= sum_4076;
      patches_quarters_1_places_q <= sum_4080;
      patches_quarters_1_up_q <= sum_4083;
      patches_quarters_1_down_q <= sum_4086;
      patches_quarters_2_places_q <= sum_4090;
      patches_quarters_2_up_q <= sum_4093;
      patches_quarters_2_down_q <= sum_4096;
      patches_quarters_3_places_q <= sum_4100;
      patches_quarters_3_up_q <= sum_4103;
      patches_quarters_3_down_q <= sum_4106;
      patches_word_places_q <= or_4134;
      patches_word_up_q <= ((select_4144 | select_4146) | select_4149) | select_4152;
      patches_word_down_q <= ((select_4155 | select_4157) | select_4160) | select_4163;
      patches_sum_places_q <= select_4173;
      patches_sum_up_q <= select_4176;
      patches_sum_down_q <= select_4179;
      patches_across_q <= sum_4191;
      patches_places_q <= select_4202;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4206;
      patches_partly_q <= or_4209;
      patches_clear_limit_q <= sum_4210[8:2];
      patches_complete_q <= select_4212;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4195 ? select_4219 : patches_found_q;
      patches_doubted_q <= select_4226;
      patches_doubted_before_q <= select_4227;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4231;
      patches_on_skin_q <= sum_4241;
      patches_on_skin_most_q <= product_4242[12:5];
      patches_large_q <= not_4244 & and_4248;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4253;
      patches_spoiled_q <= or_4257;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4264;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4274;
      segment_textured_q <= select_2435 + {6'h0, and_3009};
      segment_explained_q <= select_2440 + {6'h0, and_3014};
      segment_nearer_q <= select_2450 + {6'h0, and_3019};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_550_s3_q ? select_4347 : good_q;
      good_known_q <= select_4351;
      hidden_for_q <= select_4369;
      product_q <= equal_550_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4394;
      disagree_q <= equal_550_s3_q ? select_4339 : disagree_q;
      too_much_q <= equal_550_s3_q ? select_4404 : too_much_q;
      hides_q <= equal_550_s3_q ? select_4364 : hides_q;
      overlooks_q <= equal_550_s3_q ? select_4410 : overlooks_q;
      seen_q <= select_4531;
      nearer_q <= select_4534;
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
      averager_quarter_1_0_q <= select_2592;
      averager_quarter_1_1_q <= select_2594;
      averager_quarter_2_0_q <= select_2596;
      averager_quarter_2_1_q <= select_2598;
      averager_detail_0_q <= select_2610;
      averager_detail_1_q <= select_2618;
      census_changes_values_0_left_q <= and_526_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_526_s3_q ? sum_2701 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2703;
      census_changes_values_1_right_q <= select_2704;
      census_changes_values_2_left_q <= select_2705;
      census_changes_values_2_right_q <= select_2706;
      sharpness_last_mask_q <= and_526_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_526_s3_q ? select_2783[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_526_s3_q ? select_2783[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4414;
      box_textured_columns_values_1_q <= select_4417;
      box_textured_columns_values_2_q <= select_4420;
      box_textured_columns_values_3_q <= select_4423;
      box_textured_columns_values_4_q <= select_4426;
      box_textured_sum_sums_values_0_q <= equal_550_s3_q ? box_textured_sum_sums_values_0_q : select_4428;
      box_explained_columns_values_0_q <= select_4432;
      box_explained_columns_values_1_q <= select_4435;
      box_explained_columns_values_2_q <= select_4438;
      box_explained_columns_values_3_q <= select_4441;
      box_explained_columns_values_4_q <= select_4444;
      box_explained_sum_sums_values_0_q <= equal_550_s3_q ? box_explained_sum_sums_values_0_q : select_4446;
      box_shown_columns_values_0_q <= equal_550_s3_q ? box_shown_columns_values_0_q : select_4449;
      box_shown_columns_values_1_q <= select_4453;
      box_shown_columns_values_2_q <= select_4456;
      box_shown_columns_values_3_q <= select_4459;
      box_shown_columns_values_4_q <= select_4462;
      box_shown_sum_sums_values_0_q <= equal_550_s3_q ? box_shown_sum_sums_values_0_q : select_4464;
      box_nearer_columns_values_0_q <= equal_550_s3_q ? box_nearer_columns_values_0_q : select_4467;
      box_nearer_columns_values_1_q <= select_4471;
      box_nearer_columns_values_2_q <= select_4474;
      box_nearer_columns_values_3_q <= select_4477;
      box_nearer_columns_values_4_q <= select_4480;
      box_nearer_sum_sums_values_0_q <= equal_550_s3_q ? box_nearer_sum_sums_values_0_q : select_4482;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4511_s4_q;
  logic or_4536_s4_q;
  logic and_4537_s4_q;
  logic and_4545_s4_q;
  logic and_4548_s4_q;
  logic and_4554_s4_q;
  logic and_4558_s4_q;
  logic and_4564_s4_q;
  logic and_4568_s4_q;
  logic and_4576_s4_q;
  logic and_4581_s4_q;
  logic and_4584_s4_q;
  logic and_4588_s4_q;
  logic [5:0] select_4590_s4_q;
  logic [31:0] select_4607_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4511_s4_q <= said_q;
      or_4536_s4_q <= not_4535 | select_4531;
      and_4537_s4_q <= cfg_prove_i & select_4534;
      and_4545_s4_q <= equal_550_s3_q & (equal_2737_s3_q & (cfg_prove_i & or_4542));
      and_4548_s4_q <= equal_550_s3_q & (equal_2737_s3_q & (cfg_prove_i & or_4331));
      and_4554_s4_q <= and_4554;
      and_4558_s4_q <= equal_550_s3_q & and_4557;
      and_4564_s4_q <= equal_550_s3_q & (equal_2737_s3_q & (not_4550 & or_4561));
      and_4568_s4_q <= and_4568;
      and_4576_s4_q <= equal_550_s3_q & (equal_2737_s3_q & (cfg_prove_i & and_4573));
      and_4581_s4_q <= equal_550_s3_q & (equal_2737_s3_q & select_4579);
      and_4584_s4_q <= and_4584_s3_q;
      and_4588_s4_q <= and_4588;
      select_4590_s4_q <= equal_550_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4607_s4_q <= equal_550_s3_q ? (x_s3_q[6] ? select_4605 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4536_s4_q;
  assign marks_nearer_o = and_4537_s4_q;
  assign verdict_valid_o = and_4511_s4_q;
  assign verdict_unproven_yet_o = and_4545_s4_q;
  assign verdict_untextured_o = and_4548_s4_q;
  assign verdict_disagree_o = and_4554_s4_q;
  assign verdict_moved_o = and_4558_s4_q;
  assign verdict_unsharp_left_o = and_4564_s4_q;
  assign verdict_unsharp_right_o = and_4568_s4_q;
  assign verdict_hidden_o = and_4576_s4_q;
  assign verdict_overlooked_o = and_4581_s4_q;
  assign verdict_out_of_step_o = and_4584_s4_q;
  assign frame_valid_o = and_4588_s4_q;
  assign frame_index_o = select_4590_s4_q;
  assign frame_word_o = select_4607_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4242[4:0], sum_4210[1:0], sum_4165[1:0], product_4056[4:0], sum_3148[0], difference_3089[1:0], detail_4[1:0], detail_3[1:0], sum_2711[4:0], sum_2167[0], sum_2163[0], sum_707[4:0], cfg_width_i[2:0]};

endmodule
