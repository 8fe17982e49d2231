// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3091 bits, pipeline 858 bits, memories 127160 bits.
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
  logic not_2828;
  assign not_2828 = ~cfg_prove_i;
  logic [5:0] sum_3038;
  assign sum_3038 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_3043;
  assign less_3043 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_4059;
  assign difference_4059 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4252;
  assign not_4252 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4310;
  assign difference_4310 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4538;
  assign sum_4538 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4539;
  assign select_4539 = (6'h4 < cfg_height_i[8:3]) ? {sum_4538, cfg_height_i[4:3]} : 8'h0;

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
  logic [2:0] select_508;
  assign select_508 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_512;
  assign select_512 = select_508[0] ? averager_place_q : (row_starts ? 9'h0 : (averager_place_q + 9'h1));
  // hls/stages/census.hpp:122
  logic or_516;
  assign or_516 = row_starts | (averager_inside_q & (~(averager_place_q == 9'h13f)));
  // hls/stages/census.hpp:124
  logic select_517;
  assign select_517 = select_508[0] ? averager_inside_q : or_516;
  // hls/stages/census.hpp:42
  logic or_518;
  assign or_518 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:423
  logic and_520;
  assign and_520 = select_517 & (select_508[0] & or_518);
  // hls/stages/census.hpp:42
  logic [2:0] select_525;
  assign select_525 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [6:0] select_541;
  assign select_541 = sample_pair_first_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_541 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_543;
  assign equal_543 = select_508 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_544;
  assign equal_544 = select_525 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_545;
  assign and_545 = equal_544 & and_520;
  // hls/stages/agreement.hpp:277
  logic and_547;
  assign and_547 = sample_pair_whole_q & (equal_543 & and_545);
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:634
  logic equal_576;
  assign equal_576 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:605
  logic or_577;
  assign or_577 = so | equal_576;
  // hls/stages/agreement.hpp:603
  logic [7:0] sum_578;
  assign sum_578 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:605
  logic [7:0] select_579;
  assign select_579 = run_shift_q[5] ? x_q : sum_578;
  logic less_580;
  assign less_580 = {1'b0, last_q} < select_579;
  // hls/stages/agreement.hpp:227
  logic not_581;
  assign not_581 = ~less_580;
  // hls/stages/agreement.hpp:625
  logic equal_591;
  assign equal_591 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:626
  logic equal_592;
  assign equal_592 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:150
  logic and_593;
  assign and_593 = equal_592 & not_581;
  logic select_595;
  assign select_595 = or_577 ? not_581 : (equal_591 ? not_581 : and_593);
  // hls/stages/agreement.hpp:809
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:150
  logic and_612;
  assign and_612 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_579)));
  logic and_613;
  assign and_613 = equal_591 & and_612;
  logic select_614;
  assign select_614 = or_577 ? not_581 : and_613;
  // hls/stages/agreement.hpp:832
  logic [6:0] right;
  assign right = sum_578[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:605
  logic not_649;
  assign not_649 = ~or_577;
  // hls/stages/agreement.hpp:150
  logic and_652;
  assign and_652 = not_649 & ((~equal_591) & and_593);
  // hls/stages/census.hpp:42
  logic [5:0] select_679;
  assign select_679 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_679 : 6'h0;
  // hls/stages/patches.hpp:401
  logic not_2150;
  assign not_2150 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_2153;
  assign not_2153 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:371
  logic and_2154;
  assign and_2154 = patches_capturing_q & not_2153;
  // hls/stages/patches.hpp:373
  logic equal_2155;
  assign equal_2155 = {or_518, select_525} == 4'hc;
  // hls/stages/patches.hpp:318
  logic equal_2157;
  assign equal_2157 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2162;
  assign and_2162 = (not_2150 & (patches_work_q == 3'h0)) & (~(and_2154 | ((~equal_2155) | (~equal_2157))));
  // hls/stages/patches.hpp:542
  logic equal_2249;
  assign equal_2249 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:521
  logic not_2250;
  assign not_2250 = ~equal_2249;
  // hls/stages/patches.hpp:514
  logic equal_2251;
  assign equal_2251 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:467
  logic not_2252;
  assign not_2252 = ~equal_2251;
  // hls/stages/patches.hpp:508
  logic equal_2253;
  assign equal_2253 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2254;
  assign equal_2254 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:542
  logic or_2255;
  assign or_2255 = equal_2253 | equal_2254;
  // hls/stages/patches.hpp:469
  logic not_2256;
  assign not_2256 = ~patches_second_q;
  // hls/stages/patches.hpp:382
  logic [4:0] select_2283;
  assign select_2283 = and_2162 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2284;
  assign select_2284 = row_starts ? select_2283 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2286;
  assign and_2286 = and_2154 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2290;
  assign select_2290 = row_starts ? (and_2162 | (and_2154 & (~and_2286))) : patches_capturing_q;
  // hls/stages/agreement.hpp:276
  logic and_2298;
  assign and_2298 = not_2250 & (not_2252 & (or_2255 & (patches_second_q & equal_2254)));
  // hls/stages/patches.hpp:168
  logic not_2314;
  assign not_2314 = ~equal_2254;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2330;
  assign select_2330 = row_starts ? {select_2283[4], select_2283[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:467
  logic and_2340;
  assign and_2340 = not_2250 & (or_2255 & not_2252);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2619;
  assign select_2619 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_508 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2622;
  assign select_2622 = sample_pair_whole_q ? (sample_last_q ? (select_525 + 3'h1) : select_525) : raster_at_y_q;
  logic [6:0] select_2625;
  assign select_2625 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_541 + {6'h0, equal_543})) : raster_at_column_q;
  logic [5:0] select_2628;
  assign select_2628 = sample_pair_whole_q ? (sample_last_q ? (select_679 + {5'h0, equal_544}) : select_679) : raster_at_row_q;
  logic select_2632;
  assign select_2632 = sample_pair_whole_q ? (sample_last_q ? (or_518 & (~raster_final_row_q)) : or_518) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2634;
  assign select_2634 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2638;
  assign select_2638 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [7:0] sum_2946;
  assign sum_2946 = {1'b0, last} + 8'h1;
  logic equal_2947;
  assign equal_2947 = {sum_2946[7], cfg_width_i[9:3]} == {1'b0, sum_2946[6:0]};
  // hls/stages/agreement.hpp:469
  logic and_2948;
  assign and_2948 = and_547 & equal_2947;
  // hls/stages/agreement.hpp:534
  logic select_2951;
  assign select_2951 = (and_2948 | (~ends_cell_q)) ? and_2948 : ends_q;
  // hls/stages/agreement.hpp:540
  logic [2:0] now;
  assign now = select_2951 ? (and_2948 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:545
  logic [5:0] select_2955;
  assign select_2955 = select_2951 ? (and_2948 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2958;
  assign select_2958 = select_2951 ? (following_last_shift_q & (~and_2948)) : run_last_shift_q;
  // hls/stages/agreement.hpp:618
  logic and_2961;
  assign and_2961 = run_last_shift_q & equal_591;
  // hls/stages/agreement.hpp:627
  logic select_2963;
  assign select_2963 = equal_591 ? (~run_last_shift_q) : equal_592;
  // hls/stages/agreement.hpp:631
  logic equal_2964;
  assign equal_2964 = run_phase_q == 3'h1;
  logic not_2967;
  assign not_2967 = ~select_2963;
  // hls/stages/agreement.hpp:634
  logic equal_2969;
  assign equal_2969 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:618
  logic and_2970;
  assign and_2970 = final_row_q & so;
  // hls/stages/agreement.hpp:631
  logic [1:0] select_2971;
  assign select_2971 = equal_2969 ? 2'h1 : {2{and_2970}};
  logic [2:0] select_2973;
  assign select_2973 = (and_2961 | (select_2963 | equal_2964)) ? (equal_2964 ? 3'h2 : {not_2967, {2{select_2963}}}) : (equal_576 ? 3'h6 : {select_2971[0], select_2971});
  // hls/stages/agreement.hpp:618
  logic and_2976;
  assign and_2976 = select_2963 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:641
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2979;
  assign select_2979 = (plan_shift_q[5] & select_2963) ? value : 7'h0;
  logic [1:0] or_2980;
  assign or_2980 = {2{so}} | select_2979[5:4];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2984;
  assign or_2984 = (select_2963 ? plan_columns_q : 8'h0) | ((equal_2964 | equal_2969) ? whole_q : 8'h0);
  logic [1:0] or_2985;
  assign or_2985 = {2{and_2961}} | or_2984[3:2];
  // hls/stages/agreement.hpp:645
  logic [7:0] or_2987;
  assign or_2987 = {or_2984[7:4], or_2985, or_2984[1:0]} | (equal_576 ? drawn_q : 8'h0);
  logic [4:0] or_2988;
  assign or_2988 = {5{so}} | {or_2987[6], or_2987[3:0]};
  // hls/stages/agreement.hpp:651
  logic not_2992;
  assign not_2992 = ~run_shift_q[5];
  logic [7:0] select_2995;
  assign select_2995 = equal_591 ? ({{7{not_2992}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:534
  logic [6:0] select_2999;
  assign select_2999 = and_2948 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:537
  logic [7:0] select_3001;
  assign select_3001 = select_2951 ? {select_2999[6], select_2999} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_3004;
  assign select_3004 = select_2951 ? (and_2948 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:531
  logic [6:0] select_3012;
  assign select_3012 = and_547 ? (equal_2947 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [5:0] sum_3013;
  assign sum_3013 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:531
  logic [7:0] select_3015;
  assign select_3015 = and_547 ? (equal_2947 ? {sum_3013, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_3016;
  assign sum_3016 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:531
  logic [7:0] select_3018;
  assign select_3018 = and_547 ? (equal_2947 ? {sum_3016, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:542
  logic select_3029;
  assign select_3029 = (ends_cell_q | select_2951) ? (~(now == 3'h6)) : (equal_591 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:537
  logic and_3033;
  assign and_3033 = (~select_2951) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_3034;
  assign sum_3034 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_3036;
  assign select_3036 = equal_2947 ? ({sum_3034[6], cfg_height_i[8:3]} == {1'b0, sum_3034[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:324
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3411;
  assign select_3411 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3412;
  assign select_3412 = sample_pair_whole_q ? select_3411 : patches_phase_q;
  // hls/stages/patches.hpp:382
  logic and_3413;
  assign and_3413 = not_2153 & equal_2155;
  logic [8:0] select_3414;
  assign select_3414 = and_3413 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3415;
  assign select_3415 = and_3413 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3416;
  assign select_3416 = sample_pair_first_q ? select_3414 : select_3415;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3418;
  assign select_3418 = sample_pair_whole_q ? (row_starts ? select_3416[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3420;
  assign select_3420 = sample_pair_whole_q ? (row_starts ? select_3416[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3423;
  assign select_3423 = sample_pair_whole_q ? (equal_2157 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3425;
  assign select_3425 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2157}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:337
  logic equal_3426;
  assign equal_3426 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:338
  logic not_3427;
  assign not_3427 = ~equal_3426;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3429;
  assign select_3429 = sample_pair_whole_q ? (phase + {not_3427, 1'b1, not_3427, equal_3426}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_3431;
  assign equal_3431 = row == 6'h5;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3435;
  assign select_3435 = equal_3431 ? ((select_3412 == 4'h6) ? 4'h0 : (select_3412 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3436;
  assign equal_3436 = select_3435 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_3439;
  assign select_3439 = equal_2947 ? (equal_3436 ? 4'h6 : (select_3435 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3441;
  assign select_3441 = equal_3431 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3443;
  assign select_3443 = equal_2947 ? (select_3441 + {4'h0, equal_3436}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:531
  logic select_3448;
  assign select_3448 = and_547 ? (equal_2947 ? ((6'h4 < row) & equal_3436) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3450;
  assign select_3450 = and_547 ? (equal_2947 ? select_3441 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:380
  logic [5:0] sum_3473;
  assign sum_3473 = {1'b0, select_679[5:1]} + 6'h1;
  logic less_3474;
  assign less_3474 = {sum_3473, select_679[0], select_525, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3477;
  assign select_3477 = row_starts ? (and_2162 ? (~less_3474) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:402
  logic or_3516;
  assign or_3516 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:404
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3521;
  assign select_3521 = (patches_second_q | patches_begins_q) ? not_2150 : (patches_ends_q & equal_2249);
  logic and_3522;
  assign and_3522 = equal_2249 & not_2256;
  // hls/stages/patches.hpp:408
  logic and_3523;
  assign and_3523 = not_2314 & and_3522;
  logic [1:0] select_3525;
  assign select_3525 = equal_2251 ? 2'h0 : (equal_2253 ? 2'h3 : {equal_2254, and_3523});
  // hls/stages/patches.hpp:286
  logic equal_3527;
  assign equal_3527 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:284
  logic not_3528;
  assign not_3528 = ~equal_3527;
  // hls/stages/patches.hpp:286
  logic equal_3529;
  assign equal_3529 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:282
  logic not_3530;
  assign not_3530 = ~equal_3529;
  // hls/stages/patches.hpp:290
  logic not_3532;
  assign not_3532 = ~(patches_following_q == 3'h2);
  logic and_3535;
  assign and_3535 = (~(patches_following_q == 3'h1)) & not_3532;
  // hls/stages/patches.hpp:406
  logic [1:0] select_3536;
  assign select_3536 = equal_3529 ? 2'h2 : {and_3535, not_3532};
  logic [3:0] select_3537;
  assign select_3537 = equal_3527 ? 4'h2 : {select_3536, {2{not_3530}}};
  // hls/stages/patches.hpp:414
  logic not_3540;
  assign not_3540 = ~or_3516;
  // hls/stages/patches.hpp:403
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:415
  logic [11:0] select_3545;
  assign select_3545 = or_3516 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3547;
  assign select_3547 = or_3516 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1405; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_652;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1406; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_595;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1407; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_577 ? x_q[6:0] : (equal_591 ? sum_578[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_595;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1408; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_577 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_614;
  logic [62:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [61:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[61:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:794; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2250 & (not_2252 & (or_2255 & (equal_2254 & not_2256))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:794; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2298;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:795; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2250 & (not_2252 & (not_2314 & or_2255)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_2340;
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
      raster_at_x_q <= select_2619;
      raster_at_y_q <= select_2622;
      raster_at_column_q <= select_2625;
      raster_at_row_q <= select_2628;
      raster_at_live_q <= select_2632;
      raster_rows_left_q <= sample_pair_whole_q ? select_2634 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2638;
      averager_place_q <= sample_pair_whole_q ? select_512 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_517 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2955;
      run_last_shift_q <= select_2958;
      run_span_q <= select_2951 ? (and_2948 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2973;
      following_shift_q <= select_2963 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2976;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2979[6], or_2980, select_2979[3:0]};
      following_columns_q <= {or_2987[7], or_2988[4], or_2987[5:4], or_2988[3:0]};
      plan_shift_q <= equal_591 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2995;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_3001;
      columns_left_q <= select_3004;
      last_q <= and_547 ? (equal_2947 ? last : last_q) : last_q;
      least_q <= select_3012;
      whole_q <= select_3015;
      drawn_q <= select_3018;
      age_q <= select_2951 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2951 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3029;
      ends_q <= and_3033;
      final_row_q <= and_547 ? select_3036 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3412;
      patches_band_rows_rows_to_next_q <= select_3418;
      patches_band_rows_number_q <= select_3420;
      patches_next_band_rows_to_next_q <= select_3423;
      patches_next_band_number_q <= select_3425;
      patches_first_band_rows_to_next_q <= select_3429;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3426 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_547 ? select_3439 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_547 ? select_3443 : patches_choosing_number_q;
      patches_chooses_q <= select_3448;
      patches_choosing_band_q <= select_3450;
      patches_capturing_q <= sample_pair_whole_q ? select_2290 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3477 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2284 : patches_row_q;
      patches_work_q <= or_3516 ? following : patches_work_q;
      patches_second_q <= select_3521;
      patches_following_q <= equal_2249 ? {2'h0, and_3522} : {equal_2251, select_3525};
      patches_following_beats_q <= {select_3537, not_3528};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2286);
      patches_ends_q <= not_3540 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3545;
      patches_code_row_q <= select_3547;
      patches_column_q <= or_3516 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3540 & (patches_column_q == 5'h1e);
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
  logic [4:0] patches_choosing_number_s1_q;
  logic patches_chooses_s1_q;
  logic [4:0] patches_choosing_band_s1_q;
  logic patches_lower_s1_q;
  logic patches_second_s1_q;
  logic [4:0] patches_code_row_s1_q;
  logic [4:0] patches_column_s1_q;
  logic [2:0] select_508_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_512_s1_q;
  logic and_520_s1_q;
  logic equal_526_s1_q;
  logic [6:0] select_541_s1_q;
  logic [6:0] last_s1_2_q;
  logic and_545_s1_q;
  logic and_547_s1_q;
  logic equal_572_s1_q;
  logic so_s1_q;
  logic equal_576_s1_q;
  logic or_577_s1_q;
  logic less_580_s1_q;
  logic not_581_s1_q;
  logic equal_591_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_614_s1_q;
  logic [6:0] right_s1_q;
  logic and_652_s1_q;
  logic [5:0] row_s1_q;
  logic and_2038_s1_q;
  logic equal_2039_s1_q;
  logic and_2162_s1_q;
  logic equal_2249_s1_q;
  logic not_2250_s1_q;
  logic equal_2251_s1_q;
  logic not_2252_s1_q;
  logic equal_2253_s1_q;
  logic equal_2254_s1_q;
  logic or_2255_s1_q;
  logic not_2256_s1_q;
  logic [4:0] select_2284_s1_q;
  logic select_2290_s1_q;
  logic [3:0] select_2330_s1_q;
  logic and_2340_s1_q;
  logic equal_2947_s1_q;
  logic and_2948_s1_q;
  logic or_3516_s1_q;
  logic not_3540_s1_q;
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
      patches_choosing_number_s1_q <= patches_choosing_number_q;
      patches_chooses_s1_q <= patches_chooses_q;
      patches_choosing_band_s1_q <= patches_choosing_band_q;
      patches_lower_s1_q <= patches_lower_q;
      patches_second_s1_q <= patches_second_q;
      patches_code_row_s1_q <= patches_code_row_q;
      patches_column_s1_q <= patches_column_q;
      select_508_s1_q <= select_508;
      row_starts_s1_q <= row_starts;
      select_512_s1_q <= select_512;
      and_520_s1_q <= and_520;
      equal_526_s1_q <= select_525 == 3'h0;
      select_541_s1_q <= select_541;
      last_s1_2_q <= last;
      and_545_s1_q <= and_545;
      and_547_s1_q <= and_547;
      equal_572_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_576_s1_q <= equal_576;
      or_577_s1_q <= or_577;
      less_580_s1_q <= less_580;
      not_581_s1_q <= not_581;
      equal_591_s1_q <= equal_591;
      x_s1_2_q <= x[6:0];
      select_614_s1_q <= select_614;
      right_s1_q <= right;
      and_652_s1_q <= and_652;
      row_s1_q <= row;
      and_2038_s1_q <= not_649 & and_613;
      equal_2039_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2162_s1_q <= and_2162;
      equal_2249_s1_q <= equal_2249;
      not_2250_s1_q <= not_2250;
      equal_2251_s1_q <= equal_2251;
      not_2252_s1_q <= not_2252;
      equal_2253_s1_q <= equal_2253;
      equal_2254_s1_q <= equal_2254;
      or_2255_s1_q <= or_2255;
      not_2256_s1_q <= not_2256;
      select_2284_s1_q <= select_2284;
      select_2290_s1_q <= select_2290;
      select_2330_s1_q <= select_2330;
      and_2340_s1_q <= and_2340;
      equal_2947_s1_q <= equal_2947;
      and_2948_s1_q <= and_2948;
      or_3516_s1_q <= or_3516;
      not_3540_s1_q <= not_3540;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic late_q;
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
  logic [4:0] patches_bands_chosen_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
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
  // hls/stages/census.hpp:127
  logic and_521;
  assign and_521 = sample_pair_whole_s1_q & and_520_s1_q;
  // hls/stages/agreement.hpp:679
  logic equal_566;
  assign equal_566 = row_q == 6'h0;
  // hls/stages/agreement.hpp:1108
  logic equal_567;
  assign equal_567 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_566 & equal_567;
  // hls/stages/moments.hpp:68
  logic [13:0] select_570;
  assign select_570 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:799
  logic [12:0] select_571;
  assign select_571 = first ? 13'h0 : select_570[12:0];
  // hls/stages/agreement.hpp:1023
  logic not_573;
  assign not_573 = ~equal_572_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_575;
  assign not_575 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_577_s1_q & not_581_s1_q;
  // hls/stages/moments.hpp:74
  logic [7:0] place;
  assign place = first ? 8'h0 : select_570[13:6];
  // hls/stages/moments.hpp:131
  logic not_585;
  assign not_585 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:799
  logic and_589;
  assign and_589 = not_573 & (not_575 & (equal_576_s1_q & (inside_v & not_585)));
  // hls/stages/agreement.hpp:986
  logic and_604;
  assign and_604 = (or_577_s1_q & (left_rdata_q[67] & not_581_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:977
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:978
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:979
  logic [6:0] select_623;
  assign select_623 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:1015
  logic less_636;
  assign less_636 = 6'h2 < row_q;
  // hls/stages/agreement.hpp:1017
  logic and_646;
  assign and_646 = (or_577_s1_q & (right_codes_rdata_q[58] & not_581_s1_q)) & less_636;
  // hls/stages/agreement.hpp:680
  logic or_750;
  assign or_750 = late_q | (~equal_566);
  // hls/stages/agreement.hpp:682
  logic and_751;
  assign and_751 = left_rdata_q[12] & or_750;
  logic and_752;
  assign and_752 = left_rdata_q[30] & or_750;
  logic and_753;
  assign and_753 = left_rdata_q[48] & or_750;
  logic and_754;
  assign and_754 = left_rdata_q[66] & or_750;
  // hls/stages/agreement.hpp:683
  logic and_755;
  assign and_755 = right_codes_rdata_q[12] & or_750;
  logic and_756;
  assign and_756 = right_codes_rdata_q[27] & or_750;
  logic and_757;
  assign and_757 = right_codes_rdata_q[42] & or_750;
  logic and_758;
  assign and_758 = right_codes_rdata_q[57] & or_750;
  logic and_759;
  assign and_759 = right_codes_rdata_q[72] & or_750;
  logic and_760;
  assign and_760 = right_codes_rdata_q[85] & or_750;
  // hls/stages/agreement.hpp:222
  logic and_765;
  assign and_765 = left_rdata_q[48] & not_581_s1_q;
  logic and_766;
  assign and_766 = right_codes_rdata_q[42] & not_581_s1_q;
  logic [11:0] select_767;
  assign select_767 = less_580_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_768;
  assign select_768 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_772;
  assign select_772 = and_765 ? (and_766 ? (~(select_767 ^ select_768)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_778;
  assign parity_778 = ^select_772[5:3];
  logic parity_781;
  assign parity_781 = ^select_772[8:6];
  logic parity_784;
  assign parity_784 = ^select_772[11:3];
  // hls/stages/agreement.hpp:222
  logic and_788;
  assign and_788 = left_rdata_q[66] & not_581_s1_q;
  logic and_789;
  assign and_789 = right_codes_rdata_q[57] & not_581_s1_q;
  logic [11:0] select_790;
  assign select_790 = less_580_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_791;
  assign select_791 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_795;
  assign select_795 = and_788 ? (and_789 ? (~(select_790 ^ select_791)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_798;
  assign parity_798 = ^select_795[8:6];
  logic parity_801;
  assign parity_801 = ^select_795[11:9];
  // hls/stages/agreement.hpp:222
  logic and_805;
  assign and_805 = left_rdata_q[84] & not_581_s1_q;
  logic and_806;
  assign and_806 = right_codes_rdata_q[72] & not_581_s1_q;
  logic [11:0] select_807;
  assign select_807 = less_580_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_808;
  assign select_808 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_812;
  assign select_812 = and_805 ? (and_806 ? (~(select_807 ^ select_808)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_818;
  assign parity_818 = ^select_812[2:0];
  logic parity_821;
  assign parity_821 = ^select_812[5:3];
  logic parity_824;
  assign parity_824 = ^select_812[8:0];
  logic parity_830;
  assign parity_830 = ^select_812[11:9];
  logic parity_833;
  assign parity_833 = ^select_795[2:0];
  logic parity_836;
  assign parity_836 = ^{select_812[11:9], select_795[5:0]};
  logic parity_839;
  assign parity_839 = ^{select_812, select_795, select_772[2:0]};
  logic xor_840;
  assign xor_840 = parity_784 ^ parity_839;
  // hls/stages/count_bits.hpp:23
  logic or_844;
  assign or_844 = (select_772[1:0] == 2'h3) | (select_772[2] & (select_772[0] | select_772[1]));
  // hls/stages/count_bits.hpp:25
  logic or_848;
  assign or_848 = (select_795[7:6] == 2'h3) | (select_795[8] & (select_795[6] | select_795[7]));
  logic or_852;
  assign or_852 = (select_795[10:9] == 2'h3) | (select_795[11] & (select_795[9] | select_795[10]));
  // hls/stages/count_bits.hpp:23
  logic or_860;
  assign or_860 = (select_812[7:6] == 2'h3) | (select_812[8] & (~(select_812[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_864;
  assign or_864 = (select_812[1:0] == 2'h3) | (select_812[2] & (select_812[0] | select_812[1]));
  logic or_868;
  assign or_868 = (select_812[4:3] == 2'h3) | (select_812[5] & (select_812[3] | select_812[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_871;
  assign parity_871 = ^{or_868, or_864, or_860};
  // hls/stages/count_bits.hpp:23
  logic or_875;
  assign or_875 = (select_795[4:3] == 2'h3) | (select_795[5] & (select_795[3] | select_795[4]));
  // hls/stages/count_bits.hpp:25
  logic or_879;
  assign or_879 = (select_812[10:9] == 2'h3) | (select_812[11] & (select_812[9] | select_812[10]));
  logic or_883;
  assign or_883 = (select_795[1:0] == 2'h3) | (select_795[2] & (select_795[0] | select_795[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_886;
  assign parity_886 = ^{or_883, or_879, or_875};
  logic parity_889;
  assign parity_889 = ^{or_883, or_879, or_875, or_868, or_864, or_860, or_852, or_848, or_844};
  // hls/stages/count_bits.hpp:25
  logic and_890;
  assign and_890 = parity_784 & parity_839;
  logic or_894;
  assign or_894 = (parity_778 & parity_781) | ((^select_772[11:9]) & (parity_778 | parity_781));
  logic and_897;
  assign and_897 = (^{select_795[11:6], select_772[2:0]}) & (parity_824 | parity_836);
  logic or_898;
  assign or_898 = (parity_824 & parity_836) | and_897;
  // hls/stages/count_bits.hpp:23
  logic or_905;
  assign or_905 = (select_772[10:9] == 2'h3) | (select_772[11] & (select_772[9] | select_772[10]));
  // hls/stages/count_bits.hpp:25
  logic or_909;
  assign or_909 = (select_772[4:3] == 2'h3) | (select_772[5] & (select_772[3] | select_772[4]));
  logic or_913;
  assign or_913 = (select_772[7:6] == 2'h3) | (select_772[8] & (select_772[6] | select_772[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_916;
  assign parity_916 = ^{or_913, or_909, or_905};
  // hls/stages/count_bits.hpp:25
  logic or_920;
  assign or_920 = (parity_798 & parity_801) | ((^select_772[2:0]) & (parity_798 | parity_801));
  logic or_924;
  assign or_924 = (parity_818 & parity_821) | ((^select_812[8:6]) & (parity_818 | parity_821));
  logic or_928;
  assign or_928 = (parity_830 & parity_833) | ((^select_795[5:3]) & (parity_830 | parity_833));
  // hls/stages/count_bits.hpp:24
  logic parity_931;
  assign parity_931 = ^{or_928, or_924, or_920};
  logic parity_934;
  assign parity_934 = ^{or_928, or_924, or_920, or_913, or_909, or_905, or_898, or_894, and_890};
  logic xor_935;
  assign xor_935 = parity_889 ^ parity_934;
  // hls/stages/count_bits.hpp:25
  logic and_936;
  assign and_936 = parity_889 & parity_934;
  logic or_940;
  assign or_940 = (parity_871 & parity_886) | ((^{or_852, or_848, or_844}) & (parity_871 | parity_886));
  logic or_944;
  assign or_944 = (parity_916 & parity_931) | ((^{or_898, or_894, and_890}) & (parity_916 | parity_931));
  logic or_951;
  assign or_951 = (or_848 & or_852) | (or_844 & (or_848 | or_852));
  logic or_955;
  assign or_955 = (or_864 & or_868) | (or_860 & (or_864 | or_868));
  logic or_959;
  assign or_959 = (or_879 & or_883) | (or_875 & (or_879 | or_883));
  // hls/stages/count_bits.hpp:24
  logic parity_962;
  assign parity_962 = ^{or_959, or_955, or_951};
  // hls/stages/count_bits.hpp:25
  logic or_966;
  assign or_966 = (or_894 & or_898) | (and_890 & (or_894 | or_898));
  logic or_970;
  assign or_970 = (or_909 & or_913) | (or_905 & (or_909 | or_913));
  logic or_974;
  assign or_974 = (or_924 & or_928) | (or_920 & (or_924 | or_928));
  // hls/stages/count_bits.hpp:24
  logic parity_977;
  assign parity_977 = ^{or_974, or_970, or_966};
  logic parity_980;
  assign parity_980 = ^{or_974, or_970, or_966, or_959, or_955, or_951, or_944, or_940, and_936};
  // hls/stages/count_bits.hpp:25
  logic or_984;
  assign or_984 = (parity_962 & parity_977) | ((^{or_944, or_940, and_936}) & (parity_962 | parity_977));
  logic or_988;
  assign or_988 = (or_940 & or_944) | (and_936 & (or_940 | or_944));
  logic or_992;
  assign or_992 = (or_955 & or_959) | (or_951 & (or_955 | or_959));
  logic or_996;
  assign or_996 = (or_970 & or_974) | (or_966 & (or_970 | or_974));
  // hls/stages/count_bits.hpp:24
  logic parity_1001;
  assign parity_1001 = ^{or_996, or_992, or_988, or_984};
  // hls/stages/count_bits.hpp:25
  logic or_1005;
  assign or_1005 = (or_992 & or_996) | (or_988 & (or_992 | or_996));
  logic and_1006;
  assign and_1006 = or_984 & (^{or_996, or_992, or_988});
  // hls/stages/count_bits.hpp:24
  logic xor_1007;
  assign xor_1007 = or_1005 ^ and_1006;
  // hls/stages/count_bits.hpp:27
  logic and_1008;
  assign and_1008 = or_1005 & and_1006;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1009;
  assign select_1009 = equal_591_s1_q ? {and_1008, xor_1007, parity_1001, parity_980, xor_935, xor_840} : 6'h0;
  logic [5:0] column;
  assign column = or_577_s1_q ? 6'h0 : select_1009;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1011;
  assign select_1011 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1012;
  assign difference_1012 = {1'b0, column} - {1'b0, select_1011};
  logic [7:0] sum_1014;
  assign sum_1014 = {difference_1012[6], difference_1012} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1018;
  assign select_1018 = and_765 ? (and_789 ? (~(select_767 ^ select_791)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1024;
  assign parity_1024 = ^select_1018[5:3];
  logic parity_1027;
  assign parity_1027 = ^select_1018[8:6];
  logic parity_1030;
  assign parity_1030 = ^select_1018[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1037;
  assign select_1037 = and_788 ? (and_806 ? (~(select_790 ^ select_808)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^select_1037[8:6];
  logic parity_1043;
  assign parity_1043 = ^select_1037[11:9];
  // hls/stages/agreement.hpp:222
  logic and_1047;
  assign and_1047 = right_codes_rdata_q[85] & not_581_s1_q;
  logic [11:0] select_1048;
  assign select_1048 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1052;
  assign select_1052 = and_805 ? (and_1047 ? (~(select_807 ^ select_1048)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1058;
  assign parity_1058 = ^select_1052[2:0];
  logic parity_1061;
  assign parity_1061 = ^select_1052[5:3];
  logic parity_1064;
  assign parity_1064 = ^select_1052[8:0];
  logic parity_1070;
  assign parity_1070 = ^select_1052[11:9];
  logic parity_1073;
  assign parity_1073 = ^select_1037[2:0];
  logic parity_1076;
  assign parity_1076 = ^{select_1052[11:9], select_1037[5:0]};
  logic parity_1079;
  assign parity_1079 = ^{select_1052, select_1037, select_1018[2:0]};
  logic xor_1080;
  assign xor_1080 = parity_1030 ^ parity_1079;
  // hls/stages/count_bits.hpp:23
  logic or_1084;
  assign or_1084 = (select_1018[1:0] == 2'h3) | (select_1018[2] & (select_1018[0] | select_1018[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1088;
  assign or_1088 = (select_1037[7:6] == 2'h3) | (select_1037[8] & (select_1037[6] | select_1037[7]));
  logic or_1092;
  assign or_1092 = (select_1037[10:9] == 2'h3) | (select_1037[11] & (select_1037[9] | select_1037[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1100;
  assign or_1100 = (select_1052[7:6] == 2'h3) | (select_1052[8] & (~(select_1052[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1104;
  assign or_1104 = (select_1052[1:0] == 2'h3) | (select_1052[2] & (select_1052[0] | select_1052[1]));
  logic or_1108;
  assign or_1108 = (select_1052[4:3] == 2'h3) | (select_1052[5] & (select_1052[3] | select_1052[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1111;
  assign parity_1111 = ^{or_1108, or_1104, or_1100};
  // hls/stages/count_bits.hpp:23
  logic or_1115;
  assign or_1115 = (select_1037[4:3] == 2'h3) | (select_1037[5] & (select_1037[3] | select_1037[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1119;
  assign or_1119 = (select_1052[10:9] == 2'h3) | (select_1052[11] & (select_1052[9] | select_1052[10]));
  logic or_1123;
  assign or_1123 = (select_1037[1:0] == 2'h3) | (select_1037[2] & (select_1037[0] | select_1037[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1126;
  assign parity_1126 = ^{or_1123, or_1119, or_1115};
  logic parity_1129;
  assign parity_1129 = ^{or_1123, or_1119, or_1115, or_1108, or_1104, or_1100, or_1092, or_1088, or_1084};
  // hls/stages/count_bits.hpp:25
  logic and_1130;
  assign and_1130 = parity_1030 & parity_1079;
  logic or_1134;
  assign or_1134 = (parity_1024 & parity_1027) | ((^select_1018[11:9]) & (parity_1024 | parity_1027));
  logic and_1137;
  assign and_1137 = (^{select_1037[11:6], select_1018[2:0]}) & (parity_1064 | parity_1076);
  logic or_1138;
  assign or_1138 = (parity_1064 & parity_1076) | and_1137;
  // hls/stages/count_bits.hpp:23
  logic or_1145;
  assign or_1145 = (select_1018[10:9] == 2'h3) | (select_1018[11] & (select_1018[9] | select_1018[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1149;
  assign or_1149 = (select_1018[4:3] == 2'h3) | (select_1018[5] & (select_1018[3] | select_1018[4]));
  logic or_1153;
  assign or_1153 = (select_1018[7:6] == 2'h3) | (select_1018[8] & (select_1018[6] | select_1018[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1156;
  assign parity_1156 = ^{or_1153, or_1149, or_1145};
  // hls/stages/count_bits.hpp:25
  logic or_1160;
  assign or_1160 = (parity_1040 & parity_1043) | ((^select_1018[2:0]) & (parity_1040 | parity_1043));
  logic or_1164;
  assign or_1164 = (parity_1058 & parity_1061) | ((^select_1052[8:6]) & (parity_1058 | parity_1061));
  logic or_1168;
  assign or_1168 = (parity_1070 & parity_1073) | ((^select_1037[5:3]) & (parity_1070 | parity_1073));
  // hls/stages/count_bits.hpp:24
  logic parity_1171;
  assign parity_1171 = ^{or_1168, or_1164, or_1160};
  logic parity_1174;
  assign parity_1174 = ^{or_1168, or_1164, or_1160, or_1153, or_1149, or_1145, or_1138, or_1134, and_1130};
  logic xor_1175;
  assign xor_1175 = parity_1129 ^ parity_1174;
  // hls/stages/count_bits.hpp:25
  logic and_1176;
  assign and_1176 = parity_1129 & parity_1174;
  logic or_1180;
  assign or_1180 = (parity_1111 & parity_1126) | ((^{or_1092, or_1088, or_1084}) & (parity_1111 | parity_1126));
  logic or_1184;
  assign or_1184 = (parity_1156 & parity_1171) | ((^{or_1138, or_1134, and_1130}) & (parity_1156 | parity_1171));
  logic or_1191;
  assign or_1191 = (or_1088 & or_1092) | (or_1084 & (or_1088 | or_1092));
  logic or_1195;
  assign or_1195 = (or_1104 & or_1108) | (or_1100 & (or_1104 | or_1108));
  logic or_1199;
  assign or_1199 = (or_1119 & or_1123) | (or_1115 & (or_1119 | or_1123));
  // hls/stages/count_bits.hpp:24
  logic parity_1202;
  assign parity_1202 = ^{or_1199, or_1195, or_1191};
  // hls/stages/count_bits.hpp:25
  logic or_1206;
  assign or_1206 = (or_1134 & or_1138) | (and_1130 & (or_1134 | or_1138));
  logic or_1210;
  assign or_1210 = (or_1149 & or_1153) | (or_1145 & (or_1149 | or_1153));
  logic or_1214;
  assign or_1214 = (or_1164 & or_1168) | (or_1160 & (or_1164 | or_1168));
  // hls/stages/count_bits.hpp:24
  logic parity_1217;
  assign parity_1217 = ^{or_1214, or_1210, or_1206};
  logic parity_1220;
  assign parity_1220 = ^{or_1214, or_1210, or_1206, or_1199, or_1195, or_1191, or_1184, or_1180, and_1176};
  // hls/stages/count_bits.hpp:25
  logic or_1224;
  assign or_1224 = (parity_1202 & parity_1217) | ((^{or_1184, or_1180, and_1176}) & (parity_1202 | parity_1217));
  logic or_1228;
  assign or_1228 = (or_1180 & or_1184) | (and_1176 & (or_1180 | or_1184));
  logic or_1232;
  assign or_1232 = (or_1195 & or_1199) | (or_1191 & (or_1195 | or_1199));
  logic or_1236;
  assign or_1236 = (or_1210 & or_1214) | (or_1206 & (or_1210 | or_1214));
  // hls/stages/count_bits.hpp:24
  logic parity_1241;
  assign parity_1241 = ^{or_1236, or_1232, or_1228, or_1224};
  // hls/stages/count_bits.hpp:25
  logic or_1245;
  assign or_1245 = (or_1232 & or_1236) | (or_1228 & (or_1232 | or_1236));
  logic and_1246;
  assign and_1246 = or_1224 & (^{or_1236, or_1232, or_1228});
  // hls/stages/count_bits.hpp:24
  logic xor_1247;
  assign xor_1247 = or_1245 ^ and_1246;
  // hls/stages/count_bits.hpp:27
  logic and_1248;
  assign and_1248 = or_1245 & and_1246;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1249;
  assign select_1249 = equal_591_s1_q ? {and_1248, xor_1247, parity_1241, parity_1220, xor_1175, xor_1080} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_577_s1_q ? 6'h0 : select_1249;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1251;
  assign select_1251 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1252;
  assign difference_1252 = {1'b0, column_2} - {1'b0, select_1251};
  logic [7:0] sum_1254;
  assign sum_1254 = {difference_1252[6], difference_1252} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:222
  logic and_1255;
  assign and_1255 = right_codes_rdata_q[27] & not_581_s1_q;
  logic [11:0] select_1256;
  assign select_1256 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1260;
  assign select_1260 = and_765 ? (and_1255 ? (~(select_767 ^ select_1256)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1266;
  assign parity_1266 = ^select_1260[5:3];
  logic parity_1269;
  assign parity_1269 = ^select_1260[8:6];
  logic parity_1272;
  assign parity_1272 = ^select_1260[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1279;
  assign select_1279 = and_788 ? (and_766 ? (~(select_790 ^ select_768)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1282;
  assign parity_1282 = ^select_1279[8:6];
  logic parity_1285;
  assign parity_1285 = ^select_1279[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1292;
  assign select_1292 = and_805 ? (and_789 ? (~(select_807 ^ select_791)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1298;
  assign parity_1298 = ^select_1292[2:0];
  logic parity_1301;
  assign parity_1301 = ^select_1292[5:3];
  logic parity_1304;
  assign parity_1304 = ^select_1292[8:0];
  logic parity_1310;
  assign parity_1310 = ^select_1292[11:9];
  logic parity_1313;
  assign parity_1313 = ^select_1279[2:0];
  logic parity_1316;
  assign parity_1316 = ^{select_1292[11:9], select_1279[5:0]};
  logic parity_1319;
  assign parity_1319 = ^{select_1292, select_1279, select_1260[2:0]};
  logic xor_1320;
  assign xor_1320 = parity_1272 ^ parity_1319;
  // hls/stages/count_bits.hpp:23
  logic or_1324;
  assign or_1324 = (select_1260[1:0] == 2'h3) | (select_1260[2] & (select_1260[0] | select_1260[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1328;
  assign or_1328 = (select_1279[7:6] == 2'h3) | (select_1279[8] & (select_1279[6] | select_1279[7]));
  logic or_1332;
  assign or_1332 = (select_1279[10:9] == 2'h3) | (select_1279[11] & (select_1279[9] | select_1279[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1340;
  assign or_1340 = (select_1292[7:6] == 2'h3) | (select_1292[8] & (~(select_1292[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1344;
  assign or_1344 = (select_1292[1:0] == 2'h3) | (select_1292[2] & (select_1292[0] | select_1292[1]));
  logic or_1348;
  assign or_1348 = (select_1292[4:3] == 2'h3) | (select_1292[5] & (select_1292[3] | select_1292[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1351;
  assign parity_1351 = ^{or_1348, or_1344, or_1340};
  // hls/stages/count_bits.hpp:23
  logic or_1355;
  assign or_1355 = (select_1279[4:3] == 2'h3) | (select_1279[5] & (select_1279[3] | select_1279[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1359;
  assign or_1359 = (select_1292[10:9] == 2'h3) | (select_1292[11] & (select_1292[9] | select_1292[10]));
  logic or_1363;
  assign or_1363 = (select_1279[1:0] == 2'h3) | (select_1279[2] & (select_1279[0] | select_1279[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1366;
  assign parity_1366 = ^{or_1363, or_1359, or_1355};
  logic parity_1369;
  assign parity_1369 = ^{or_1363, or_1359, or_1355, or_1348, or_1344, or_1340, or_1332, or_1328, or_1324};
  // hls/stages/count_bits.hpp:25
  logic and_1370;
  assign and_1370 = parity_1272 & parity_1319;
  logic or_1374;
  assign or_1374 = (parity_1266 & parity_1269) | ((^select_1260[11:9]) & (parity_1266 | parity_1269));
  logic and_1377;
  assign and_1377 = (^{select_1279[11:6], select_1260[2:0]}) & (parity_1304 | parity_1316);
  logic or_1378;
  assign or_1378 = (parity_1304 & parity_1316) | and_1377;
  // hls/stages/count_bits.hpp:23
  logic or_1385;
  assign or_1385 = (select_1260[10:9] == 2'h3) | (select_1260[11] & (select_1260[9] | select_1260[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1389;
  assign or_1389 = (select_1260[4:3] == 2'h3) | (select_1260[5] & (select_1260[3] | select_1260[4]));
  logic or_1393;
  assign or_1393 = (select_1260[7:6] == 2'h3) | (select_1260[8] & (select_1260[6] | select_1260[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1396;
  assign parity_1396 = ^{or_1393, or_1389, or_1385};
  // hls/stages/count_bits.hpp:25
  logic or_1400;
  assign or_1400 = (parity_1282 & parity_1285) | ((^select_1260[2:0]) & (parity_1282 | parity_1285));
  logic or_1404;
  assign or_1404 = (parity_1298 & parity_1301) | ((^select_1292[8:6]) & (parity_1298 | parity_1301));
  logic or_1408;
  assign or_1408 = (parity_1310 & parity_1313) | ((^select_1279[5:3]) & (parity_1310 | parity_1313));
  // hls/stages/count_bits.hpp:24
  logic parity_1411;
  assign parity_1411 = ^{or_1408, or_1404, or_1400};
  logic parity_1414;
  assign parity_1414 = ^{or_1408, or_1404, or_1400, or_1393, or_1389, or_1385, or_1378, or_1374, and_1370};
  logic xor_1415;
  assign xor_1415 = parity_1369 ^ parity_1414;
  // hls/stages/count_bits.hpp:25
  logic and_1416;
  assign and_1416 = parity_1369 & parity_1414;
  logic or_1420;
  assign or_1420 = (parity_1351 & parity_1366) | ((^{or_1332, or_1328, or_1324}) & (parity_1351 | parity_1366));
  logic or_1424;
  assign or_1424 = (parity_1396 & parity_1411) | ((^{or_1378, or_1374, and_1370}) & (parity_1396 | parity_1411));
  logic or_1431;
  assign or_1431 = (or_1328 & or_1332) | (or_1324 & (or_1328 | or_1332));
  logic or_1435;
  assign or_1435 = (or_1344 & or_1348) | (or_1340 & (or_1344 | or_1348));
  logic or_1439;
  assign or_1439 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  // hls/stages/count_bits.hpp:24
  logic parity_1442;
  assign parity_1442 = ^{or_1439, or_1435, or_1431};
  // hls/stages/count_bits.hpp:25
  logic or_1446;
  assign or_1446 = (or_1374 & or_1378) | (and_1370 & (or_1374 | or_1378));
  logic or_1450;
  assign or_1450 = (or_1389 & or_1393) | (or_1385 & (or_1389 | or_1393));
  logic or_1454;
  assign or_1454 = (or_1404 & or_1408) | (or_1400 & (or_1404 | or_1408));
  // hls/stages/count_bits.hpp:24
  logic parity_1457;
  assign parity_1457 = ^{or_1454, or_1450, or_1446};
  logic parity_1460;
  assign parity_1460 = ^{or_1454, or_1450, or_1446, or_1439, or_1435, or_1431, or_1424, or_1420, and_1416};
  // hls/stages/count_bits.hpp:25
  logic or_1464;
  assign or_1464 = (parity_1442 & parity_1457) | ((^{or_1424, or_1420, and_1416}) & (parity_1442 | parity_1457));
  logic or_1468;
  assign or_1468 = (or_1420 & or_1424) | (and_1416 & (or_1420 | or_1424));
  logic or_1472;
  assign or_1472 = (or_1435 & or_1439) | (or_1431 & (or_1435 | or_1439));
  logic or_1476;
  assign or_1476 = (or_1450 & or_1454) | (or_1446 & (or_1450 | or_1454));
  // hls/stages/count_bits.hpp:24
  logic parity_1481;
  assign parity_1481 = ^{or_1476, or_1472, or_1468, or_1464};
  // hls/stages/count_bits.hpp:25
  logic or_1485;
  assign or_1485 = (or_1472 & or_1476) | (or_1468 & (or_1472 | or_1476));
  logic and_1486;
  assign and_1486 = or_1464 & (^{or_1476, or_1472, or_1468});
  // hls/stages/count_bits.hpp:24
  logic xor_1487;
  assign xor_1487 = or_1485 ^ and_1486;
  // hls/stages/count_bits.hpp:27
  logic and_1488;
  assign and_1488 = or_1485 & and_1486;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1489;
  assign select_1489 = equal_591_s1_q ? {and_1488, xor_1487, parity_1481, parity_1460, xor_1415, xor_1320} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_577_s1_q ? 6'h0 : select_1489;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1491;
  assign select_1491 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1492;
  assign difference_1492 = {1'b0, column_3} - {1'b0, select_1491};
  logic [7:0] sum_1494;
  assign sum_1494 = {difference_1492[6], difference_1492} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1502;
  assign select_1502 = and_765 ? (and_806 ? (~(select_767 ^ select_808)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1508;
  assign parity_1508 = ^select_1502[5:3];
  logic parity_1511;
  assign parity_1511 = ^select_1502[8:6];
  logic parity_1514;
  assign parity_1514 = ^select_1502[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1521;
  assign select_1521 = and_788 ? (and_1047 ? (~(select_790 ^ select_1048)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1524;
  assign parity_1524 = ^select_1521[8:6];
  logic parity_1527;
  assign parity_1527 = ^select_1521[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] xor_1533;
  assign xor_1533 = select_807 ^ (less_580_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1536;
  assign select_1536 = and_805 ? ((right_codes_rdata_q[98] & not_581_s1_q) ? (~xor_1533) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1542;
  assign parity_1542 = ^select_1536[2:0];
  logic parity_1545;
  assign parity_1545 = ^select_1536[5:3];
  logic parity_1548;
  assign parity_1548 = ^select_1536[8:0];
  logic parity_1554;
  assign parity_1554 = ^select_1536[11:9];
  logic parity_1557;
  assign parity_1557 = ^select_1521[2:0];
  logic parity_1560;
  assign parity_1560 = ^{select_1536[11:9], select_1521[5:0]};
  logic parity_1563;
  assign parity_1563 = ^{select_1536, select_1521, select_1502[2:0]};
  logic xor_1564;
  assign xor_1564 = parity_1514 ^ parity_1563;
  // hls/stages/count_bits.hpp:23
  logic or_1568;
  assign or_1568 = (select_1502[1:0] == 2'h3) | (select_1502[2] & (select_1502[0] | select_1502[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1572;
  assign or_1572 = (select_1521[7:6] == 2'h3) | (select_1521[8] & (select_1521[6] | select_1521[7]));
  logic or_1576;
  assign or_1576 = (select_1521[10:9] == 2'h3) | (select_1521[11] & (select_1521[9] | select_1521[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1584;
  assign or_1584 = (select_1536[7:6] == 2'h3) | (select_1536[8] & (~(select_1536[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1588;
  assign or_1588 = (select_1536[1:0] == 2'h3) | (select_1536[2] & (select_1536[0] | select_1536[1]));
  logic or_1592;
  assign or_1592 = (select_1536[4:3] == 2'h3) | (select_1536[5] & (select_1536[3] | select_1536[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1595;
  assign parity_1595 = ^{or_1592, or_1588, or_1584};
  // hls/stages/count_bits.hpp:23
  logic or_1599;
  assign or_1599 = (select_1521[4:3] == 2'h3) | (select_1521[5] & (select_1521[3] | select_1521[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1603;
  assign or_1603 = (select_1536[10:9] == 2'h3) | (select_1536[11] & (select_1536[9] | select_1536[10]));
  logic or_1607;
  assign or_1607 = (select_1521[1:0] == 2'h3) | (select_1521[2] & (select_1521[0] | select_1521[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1610;
  assign parity_1610 = ^{or_1607, or_1603, or_1599};
  logic parity_1613;
  assign parity_1613 = ^{or_1607, or_1603, or_1599, or_1592, or_1588, or_1584, or_1576, or_1572, or_1568};
  // hls/stages/count_bits.hpp:25
  logic and_1614;
  assign and_1614 = parity_1514 & parity_1563;
  logic or_1618;
  assign or_1618 = (parity_1508 & parity_1511) | ((^select_1502[11:9]) & (parity_1508 | parity_1511));
  logic and_1621;
  assign and_1621 = (^{select_1521[11:6], select_1502[2:0]}) & (parity_1548 | parity_1560);
  logic or_1622;
  assign or_1622 = (parity_1548 & parity_1560) | and_1621;
  // hls/stages/count_bits.hpp:23
  logic or_1629;
  assign or_1629 = (select_1502[10:9] == 2'h3) | (select_1502[11] & (select_1502[9] | select_1502[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1633;
  assign or_1633 = (select_1502[4:3] == 2'h3) | (select_1502[5] & (select_1502[3] | select_1502[4]));
  logic or_1637;
  assign or_1637 = (select_1502[7:6] == 2'h3) | (select_1502[8] & (select_1502[6] | select_1502[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1640;
  assign parity_1640 = ^{or_1637, or_1633, or_1629};
  // hls/stages/count_bits.hpp:25
  logic or_1644;
  assign or_1644 = (parity_1524 & parity_1527) | ((^select_1502[2:0]) & (parity_1524 | parity_1527));
  logic or_1648;
  assign or_1648 = (parity_1542 & parity_1545) | ((^select_1536[8:6]) & (parity_1542 | parity_1545));
  logic or_1652;
  assign or_1652 = (parity_1554 & parity_1557) | ((^select_1521[5:3]) & (parity_1554 | parity_1557));
  // hls/stages/count_bits.hpp:24
  logic parity_1655;
  assign parity_1655 = ^{or_1652, or_1648, or_1644};
  logic parity_1658;
  assign parity_1658 = ^{or_1652, or_1648, or_1644, or_1637, or_1633, or_1629, or_1622, or_1618, and_1614};
  logic xor_1659;
  assign xor_1659 = parity_1613 ^ parity_1658;
  // hls/stages/count_bits.hpp:25
  logic and_1660;
  assign and_1660 = parity_1613 & parity_1658;
  logic or_1664;
  assign or_1664 = (parity_1595 & parity_1610) | ((^{or_1576, or_1572, or_1568}) & (parity_1595 | parity_1610));
  logic or_1668;
  assign or_1668 = (parity_1640 & parity_1655) | ((^{or_1622, or_1618, and_1614}) & (parity_1640 | parity_1655));
  logic or_1675;
  assign or_1675 = (or_1572 & or_1576) | (or_1568 & (or_1572 | or_1576));
  logic or_1679;
  assign or_1679 = (or_1588 & or_1592) | (or_1584 & (or_1588 | or_1592));
  logic or_1683;
  assign or_1683 = (or_1603 & or_1607) | (or_1599 & (or_1603 | or_1607));
  // hls/stages/count_bits.hpp:24
  logic parity_1686;
  assign parity_1686 = ^{or_1683, or_1679, or_1675};
  // hls/stages/count_bits.hpp:25
  logic or_1690;
  assign or_1690 = (or_1618 & or_1622) | (and_1614 & (or_1618 | or_1622));
  logic or_1694;
  assign or_1694 = (or_1633 & or_1637) | (or_1629 & (or_1633 | or_1637));
  logic or_1698;
  assign or_1698 = (or_1648 & or_1652) | (or_1644 & (or_1648 | or_1652));
  // hls/stages/count_bits.hpp:24
  logic parity_1701;
  assign parity_1701 = ^{or_1698, or_1694, or_1690};
  logic parity_1704;
  assign parity_1704 = ^{or_1698, or_1694, or_1690, or_1683, or_1679, or_1675, or_1668, or_1664, and_1660};
  // hls/stages/count_bits.hpp:25
  logic or_1708;
  assign or_1708 = (parity_1686 & parity_1701) | ((^{or_1668, or_1664, and_1660}) & (parity_1686 | parity_1701));
  logic or_1712;
  assign or_1712 = (or_1664 & or_1668) | (and_1660 & (or_1664 | or_1668));
  logic or_1716;
  assign or_1716 = (or_1679 & or_1683) | (or_1675 & (or_1679 | or_1683));
  logic or_1720;
  assign or_1720 = (or_1694 & or_1698) | (or_1690 & (or_1694 | or_1698));
  // hls/stages/count_bits.hpp:24
  logic parity_1725;
  assign parity_1725 = ^{or_1720, or_1716, or_1712, or_1708};
  // hls/stages/count_bits.hpp:25
  logic or_1729;
  assign or_1729 = (or_1716 & or_1720) | (or_1712 & (or_1716 | or_1720));
  logic and_1730;
  assign and_1730 = or_1708 & (^{or_1720, or_1716, or_1712});
  // hls/stages/count_bits.hpp:24
  logic xor_1731;
  assign xor_1731 = or_1729 ^ and_1730;
  // hls/stages/count_bits.hpp:27
  logic and_1732;
  assign and_1732 = or_1729 & and_1730;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1733;
  assign select_1733 = equal_591_s1_q ? {and_1732, xor_1731, parity_1725, parity_1704, xor_1659, xor_1564} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_577_s1_q ? 6'h0 : select_1733;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1735;
  assign select_1735 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1736;
  assign difference_1736 = {1'b0, column_4} - {1'b0, select_1735};
  logic [7:0] sum_1738;
  assign sum_1738 = {difference_1736[6], difference_1736} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:695
  logic [11:0] not_1742;
  assign not_1742 = ~(select_767 ^ (less_580_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1744;
  assign select_1744 = and_765 ? ((right_codes_rdata_q[12] & not_581_s1_q) ? not_1742 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1750;
  assign parity_1750 = ^select_1744[5:3];
  logic parity_1753;
  assign parity_1753 = ^select_1744[8:6];
  logic parity_1756;
  assign parity_1756 = ^select_1744[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1763;
  assign select_1763 = and_788 ? (and_1255 ? (~(select_790 ^ select_1256)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1766;
  assign parity_1766 = ^select_1763[8:6];
  logic parity_1769;
  assign parity_1769 = ^select_1763[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1776;
  assign select_1776 = and_805 ? (and_766 ? (~(select_807 ^ select_768)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1782;
  assign parity_1782 = ^select_1776[2:0];
  logic parity_1785;
  assign parity_1785 = ^select_1776[5:3];
  logic parity_1788;
  assign parity_1788 = ^select_1776[8:0];
  logic parity_1794;
  assign parity_1794 = ^select_1776[11:9];
  logic parity_1797;
  assign parity_1797 = ^select_1763[2:0];
  logic parity_1800;
  assign parity_1800 = ^{select_1776[11:9], select_1763[5:0]};
  logic parity_1803;
  assign parity_1803 = ^{select_1776, select_1763, select_1744[2:0]};
  logic xor_1804;
  assign xor_1804 = parity_1756 ^ parity_1803;
  // hls/stages/count_bits.hpp:23
  logic or_1808;
  assign or_1808 = (select_1744[1:0] == 2'h3) | (select_1744[2] & (select_1744[0] | select_1744[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1812;
  assign or_1812 = (select_1763[7:6] == 2'h3) | (select_1763[8] & (select_1763[6] | select_1763[7]));
  logic or_1816;
  assign or_1816 = (select_1763[10:9] == 2'h3) | (select_1763[11] & (select_1763[9] | select_1763[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1824;
  assign or_1824 = (select_1776[7:6] == 2'h3) | (select_1776[8] & (~(select_1776[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1828;
  assign or_1828 = (select_1776[1:0] == 2'h3) | (select_1776[2] & (select_1776[0] | select_1776[1]));
  logic or_1832;
  assign or_1832 = (select_1776[4:3] == 2'h3) | (select_1776[5] & (select_1776[3] | select_1776[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1835;
  assign parity_1835 = ^{or_1832, or_1828, or_1824};
  // hls/stages/count_bits.hpp:23
  logic or_1839;
  assign or_1839 = (select_1763[4:3] == 2'h3) | (select_1763[5] & (select_1763[3] | select_1763[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1843;
  assign or_1843 = (select_1776[10:9] == 2'h3) | (select_1776[11] & (select_1776[9] | select_1776[10]));
  logic or_1847;
  assign or_1847 = (select_1763[1:0] == 2'h3) | (select_1763[2] & (select_1763[0] | select_1763[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1850;
  assign parity_1850 = ^{or_1847, or_1843, or_1839};
  logic parity_1853;
  assign parity_1853 = ^{or_1847, or_1843, or_1839, or_1832, or_1828, or_1824, or_1816, or_1812, or_1808};
  // hls/stages/count_bits.hpp:25
  logic and_1854;
  assign and_1854 = parity_1756 & parity_1803;
  logic or_1858;
  assign or_1858 = (parity_1750 & parity_1753) | ((^select_1744[11:9]) & (parity_1750 | parity_1753));
  logic and_1861;
  assign and_1861 = (^{select_1763[11:6], select_1744[2:0]}) & (parity_1788 | parity_1800);
  logic or_1862;
  assign or_1862 = (parity_1788 & parity_1800) | and_1861;
  // hls/stages/count_bits.hpp:23
  logic or_1869;
  assign or_1869 = (select_1744[10:9] == 2'h3) | (select_1744[11] & (select_1744[9] | select_1744[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1873;
  assign or_1873 = (select_1744[4:3] == 2'h3) | (select_1744[5] & (select_1744[3] | select_1744[4]));
  logic or_1877;
  assign or_1877 = (select_1744[7:6] == 2'h3) | (select_1744[8] & (select_1744[6] | select_1744[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1880;
  assign parity_1880 = ^{or_1877, or_1873, or_1869};
  // hls/stages/count_bits.hpp:25
  logic or_1884;
  assign or_1884 = (parity_1766 & parity_1769) | ((^select_1744[2:0]) & (parity_1766 | parity_1769));
  logic or_1888;
  assign or_1888 = (parity_1782 & parity_1785) | ((^select_1776[8:6]) & (parity_1782 | parity_1785));
  logic or_1892;
  assign or_1892 = (parity_1794 & parity_1797) | ((^select_1763[5:3]) & (parity_1794 | parity_1797));
  // hls/stages/count_bits.hpp:24
  logic parity_1895;
  assign parity_1895 = ^{or_1892, or_1888, or_1884};
  logic parity_1898;
  assign parity_1898 = ^{or_1892, or_1888, or_1884, or_1877, or_1873, or_1869, or_1862, or_1858, and_1854};
  logic xor_1899;
  assign xor_1899 = parity_1853 ^ parity_1898;
  // hls/stages/count_bits.hpp:25
  logic and_1900;
  assign and_1900 = parity_1853 & parity_1898;
  logic or_1904;
  assign or_1904 = (parity_1835 & parity_1850) | ((^{or_1816, or_1812, or_1808}) & (parity_1835 | parity_1850));
  logic or_1908;
  assign or_1908 = (parity_1880 & parity_1895) | ((^{or_1862, or_1858, and_1854}) & (parity_1880 | parity_1895));
  logic or_1915;
  assign or_1915 = (or_1812 & or_1816) | (or_1808 & (or_1812 | or_1816));
  logic or_1919;
  assign or_1919 = (or_1828 & or_1832) | (or_1824 & (or_1828 | or_1832));
  logic or_1923;
  assign or_1923 = (or_1843 & or_1847) | (or_1839 & (or_1843 | or_1847));
  // hls/stages/count_bits.hpp:24
  logic parity_1926;
  assign parity_1926 = ^{or_1923, or_1919, or_1915};
  // hls/stages/count_bits.hpp:25
  logic or_1930;
  assign or_1930 = (or_1858 & or_1862) | (and_1854 & (or_1858 | or_1862));
  logic or_1934;
  assign or_1934 = (or_1873 & or_1877) | (or_1869 & (or_1873 | or_1877));
  logic or_1938;
  assign or_1938 = (or_1888 & or_1892) | (or_1884 & (or_1888 | or_1892));
  // hls/stages/count_bits.hpp:24
  logic parity_1941;
  assign parity_1941 = ^{or_1938, or_1934, or_1930};
  logic parity_1944;
  assign parity_1944 = ^{or_1938, or_1934, or_1930, or_1923, or_1919, or_1915, or_1908, or_1904, and_1900};
  // hls/stages/count_bits.hpp:25
  logic or_1948;
  assign or_1948 = (parity_1926 & parity_1941) | ((^{or_1908, or_1904, and_1900}) & (parity_1926 | parity_1941));
  logic or_1952;
  assign or_1952 = (or_1904 & or_1908) | (and_1900 & (or_1904 | or_1908));
  logic or_1956;
  assign or_1956 = (or_1919 & or_1923) | (or_1915 & (or_1919 | or_1923));
  logic or_1960;
  assign or_1960 = (or_1934 & or_1938) | (or_1930 & (or_1934 | or_1938));
  // hls/stages/count_bits.hpp:24
  logic parity_1965;
  assign parity_1965 = ^{or_1960, or_1956, or_1952, or_1948};
  // hls/stages/count_bits.hpp:25
  logic or_1969;
  assign or_1969 = (or_1956 & or_1960) | (or_1952 & (or_1956 | or_1960));
  logic and_1970;
  assign and_1970 = or_1948 & (^{or_1960, or_1956, or_1952});
  // hls/stages/count_bits.hpp:24
  logic xor_1971;
  assign xor_1971 = or_1969 ^ and_1970;
  // hls/stages/count_bits.hpp:27
  logic and_1972;
  assign and_1972 = or_1969 & and_1970;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1973;
  assign select_1973 = equal_591_s1_q ? {and_1972, xor_1971, parity_1965, parity_1944, xor_1899, xor_1804} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_577_s1_q ? 6'h0 : select_1973;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1975;
  assign select_1975 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1976;
  assign difference_1976 = {1'b0, column_5} - {1'b0, select_1975};
  logic [7:0] sum_1978;
  assign sum_1978 = {difference_1976[6], difference_1976} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:799
  logic and_2049;
  assign and_2049 = ends_cell_s1_q & inside_v;
  logic and_2051;
  assign and_2051 = not_573 & (so_s1_q & and_2049);
  logic [6:0] select_2055;
  assign select_2055 = so_s1_q ? x_s1_q[6:0] : (or_577_s1_q ? (less_580_s1_q ? 7'h0 : select_623) : 7'h0);
  // hls/stages/agreement.hpp:248
  logic or_2059;
  assign or_2059 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
  logic and_2068;
  assign and_2068 = or_577_s1_q & (slot_s1_q[2] & not_581_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2181;
  assign select_2181 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2181[16:7])) ? 8'h7f : select_2181[7:0];
  // hls/stages/agreement.hpp:1159
  logic equal_2266;
  assign equal_2266 = x_s1_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:153
  logic [4:0] select_2267;
  assign select_2267 = equal_2266 ? patches_choosing_number_s1_q : patches_bands_chosen_q;
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_2254_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2254_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:509
  logic less_2346;
  assign less_2346 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:510
  logic or_2347;
  assign or_2347 = equal_2253_s1_q | less_2346;
  // hls/stages/patches.hpp:513
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2352;
  assign select_2352 = equal_2253_s1_q ? patches_column_s1_q[0] : (or_2347 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2353;
  assign not_2353 = ~or_2347;
  // hls/stages/patches.hpp:510
  logic [4:0] sum_2354;
  assign sum_2354 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:512
  logic [4:0] select_2357;
  assign select_2357 = or_2347 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2354) + 5'h1) : sum_2354;
  // hls/stages/patches.hpp:514
  logic [4:0] select_2358;
  assign select_2358 = equal_2253_s1_q ? 5'h0 : select_2357;
  logic or_2359;
  assign or_2359 = equal_2253_s1_q | equal_2251_s1_q;
  // hls/stages/patches.hpp:490
  logic equal_2361;
  assign equal_2361 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2363;
  assign equal_2363 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:492
  logic and_2365;
  assign and_2365 = of_row & (~equal_2363);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2361 ? 2'h3 : {equal_2363, and_2365};
  // hls/stages/patches.hpp:478
  logic [8:0] sum_2368;
  assign sum_2368 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2369;
  assign sum_2369 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2368, pixel_2[0]} - {1'b0, sum_2369, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:480
  logic [11:0] sum_2371;
  assign sum_2371 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2372;
  assign sum_2372 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2371[11], sum_2371};
  logic [13:0] sum_2373;
  assign sum_2373 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2372, down_2[1]};
  logic [12:0] sum_2374;
  assign sum_2374 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2373[13:1];
  logic [14:0] sum_2375;
  assign sum_2375 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2374, sum_2373[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic or_2382;
  assign or_2382 = (sum_2375[8] & (~(sum_2375[7:0] == 8'h0))) | (~(sum_2375[13:9] == 5'h0));
  // hls/stages/patches.hpp:476
  logic [8:0] sum_2387;
  assign sum_2387 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2388;
  assign sum_2388 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2387};
  logic [10:0] sum_2389;
  assign sum_2389 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2388, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2390;
  assign sum_2390 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2389[10:1];
  // hls/stages/patches.hpp:477
  logic [11:0] smooth;
  assign smooth = {sum_2390, sum_2389[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:479
  logic [12:0] sum_2392;
  assign sum_2392 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2393;
  assign sum_2393 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2394;
  assign difference_2394 = {1'b0, sum_2392, smooth[0]} - {1'b0, sum_2393, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:462
  logic or_2401;
  assign or_2401 = (difference_2394[8] & (~(difference_2394[7:0] == 8'h0))) | (~(difference_2394[13:9] == 5'h0));
  // hls/stages/patches.hpp:491
  logic or_2409;
  assign or_2409 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2363) | equal_2361;
  // hls/stages/patches.hpp:486
  logic and_2414;
  assign and_2414 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:276
  logic and_2418;
  assign and_2418 = not_2252_s1_q & (or_2255_s1_q & (or_2409 & (equal_2254_s1_q & and_2414)));
  // hls/stages/patches.hpp:174
  logic and_2428;
  assign and_2428 = (~(equal_2254_s1_q | (~and_2414))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
  logic and_2432;
  assign and_2432 = not_2252_s1_q & (or_2255_s1_q & (and_2428 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:554
  logic less_2434;
  assign less_2434 = patches_step_q[4:0] < 5'h11;
  logic equal_2435;
  assign equal_2435 = patches_step_q[6:5] == 2'h2;
  logic equal_2436;
  assign equal_2436 = patches_step_q[6:5] == 2'h1;
  logic or_2437;
  assign or_2437 = equal_2435 | equal_2436;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2461;
  assign sum_2461 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1306
  logic or_2507;
  assign or_2507 = sample_pair_first_q | line_ended_q;
  // hls/stages/agreement.hpp:1308
  logic [16:0] select_2509;
  assign select_2509 = sample_pair_first_q ? 17'h1 : (or_2507 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1307
  logic [8:0] select_2511;
  assign select_2511 = or_2507 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1315
  logic select_2513;
  assign select_2513 = cfg_compete_i ? (or_2507 & select_2509[16]) : (select_2511[8] & select_2509[9]);
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2513 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1322
  logic [6:0] select_2516;
  assign select_2516 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2518;
  assign select_2518 = sample_pair_first_q ? 13'h0 : (seen_base_q + {6'h0, select_2516});
  // hls/stages/agreement.hpp:1333
  logic equal_2519;
  assign equal_2519 = seen_x_q == 3'h7;
  // hls/stages/agreement.hpp:1305
  logic not_2526;
  assign not_2526 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:461
  logic [5:0] or_2758;
  assign or_2758 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:465
  logic select_3041;
  assign select_3041 = equal_2947_s1_q ? (~({row_s1_q, 1'b0} < {sum_3038, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_3044;
  assign and_3044 = proven_q & less_3043;
  // hls/stages/agreement.hpp:531
  logic select_3048;
  assign select_3048 = and_547_s1_q ? (equal_2947_s1_q ? (and_3044 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_3049;
  assign equal_3049 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_3050;
  assign and_3050 = and_3044 & equal_3049;
  // hls/stages/agreement.hpp:531
  logic and_3301;
  assign and_3301 = and_547_s1_q & (equal_2947_s1_q & equal_3049);
  // hls/stages/registration.hpp:128
  logic and_3302;
  assign and_3302 = and_2948_s1_q & and_3301;
  // hls/stages/registration.hpp:127
  logic and_3304;
  assign and_3304 = and_2948_s1_q & (~and_3301);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3305;
  assign select_3305 = and_3304 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3307;
  assign select_3307 = and_3302 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3305[15]}}, select_3305});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3308;
  assign select_3308 = and_3304 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3308[15]}}, select_3308};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3310;
  assign select_3310 = and_3302 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_3311;
  assign and_3311 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3311 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3555;
  assign select_3555 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3558;
  assign select_3558 = equal_2251_s1_q ? patches_smooth_values_0_q : (or_2255_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3560;
  assign select_3560 = or_2255_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3562;
  assign select_3562 = equal_2249_s1_q ? patches_smooth_values_1_q : (equal_2251_s1_q ? patches_smooth_values_1_q : select_3560);
  logic [11:0] select_3563;
  assign select_3563 = or_2255_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3565;
  assign select_3565 = equal_2249_s1_q ? patches_smooth_values_2_q : (equal_2251_s1_q ? patches_smooth_values_2_q : select_3563);
  logic [11:0] select_3566;
  assign select_3566 = or_2255_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3568;
  assign select_3568 = equal_2249_s1_q ? patches_smooth_values_3_q : (equal_2251_s1_q ? patches_smooth_values_3_q : select_3566);
  logic [10:0] select_3570;
  assign select_3570 = equal_2251_s1_q ? patches_down_values_0_q : (or_2255_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3573;
  assign select_3573 = equal_2251_s1_q ? patches_down_values_1_q : (or_2255_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3576;
  assign select_3576 = equal_2251_s1_q ? patches_down_values_2_q : (or_2255_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3579;
  assign select_3579 = equal_2251_s1_q ? patches_down_values_3_q : (or_2255_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3616;
  assign and_3616 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:422
  logic [4:0] select_3621;
  assign select_3621 = or_3516_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:424
  logic [3:0] select_3623;
  assign select_3623 = and_3616 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3979;
  assign select_3979 = equal_2249_s1_q ? patches_summed_down_by_q : (equal_2251_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3997;
  assign select_3997 = equal_2249_s1_q ? (less_2434 & (equal_2436 & or_2437)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_4300;
  assign select_4300 = so_s1_q ? (and_3311 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4302;
  assign sum_4302 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4303;
  assign select_4303 = sum_2461[5] ? {1'b1, sum_2461[4:0], region_across_rest_q[2:0]} : sum_4302;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4305;
  assign select_4305 = equal_2947_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4308;
  assign select_4308 = equal_2947_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1165
  logic equal_4360;
  assign equal_4360 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:1332
  logic [2:0] select_4535;
  assign select_4535 = select_2513 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4541;
  assign select_4541 = sample_pair_first_q ? select_4539 : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_512_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_521;
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
  assign census_memory_re = s1_en & and_547_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:155; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [4:0] moments_memory_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) moments_memory_mem[i] = 5'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_571;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_589;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1409; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_577_s1_q ? select_623 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_614_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1410; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_2051;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1411; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_2068;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1411; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_623;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2068;
  logic [2:0] right_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_word_q <= right_turns_mem[right_turns_raddr];
  end
  logic [1:0] right_turns_rdata_q;
  assign right_turns_rdata_q = right_turns_word_q[1:0];
  logic right_turns_read_q, right_turns_error;
  always_ff @(posedge clk_i) right_turns_read_q <= rst_ni & right_turns_re;
  assign right_turns_error = right_turns_read_q & ^right_turns_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:811; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2358, not_2353, select_2352};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2359;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:812; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_2250_s1_q & (new_row & equal_2251_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:826; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & (equal_2249_s1_q & (less_2434 & or_2437));
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1440; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2051;
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
  assign left_we = s1_en & and_652_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_754, left_rdata_q[65:49], and_753, left_rdata_q[47:31], and_752, left_rdata_q[29:13], and_751, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_652_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_760, right_codes_rdata_q[84:73], and_759, right_codes_rdata_q[71:60], and_758, right_codes_rdata_q[56:43], and_757, right_codes_rdata_q[41:28], and_756, right_codes_rdata_q[26:13], and_755, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2340_s1_q;
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
      late_q <= 1'b0;
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
      patches_bands_chosen_q <= 5'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
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
    end else if (s1_en) begin
      moments_place_q <= select_570;
      moments_taken_q <= not_573 & (not_575 & (equal_576_s1_q & inside_v));
      moments_starts_q <= not_573 & (not_575 & (equal_576_s1_q & (inside_v & first)));
      row_q <= and_547_s1_q ? (equal_2947_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_547_s1_q ? select_3041 : lower_half_q;
      late_q <= select_3048;
      registration_slope_row_q <= select_3307;
      registration_slope_change_q <= select_3310;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3540_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3540_s1_q & select_3555;
      patches_smooth_values_0_q <= equal_2249_s1_q ? patches_smooth_values_0_q : select_3558;
      patches_smooth_values_1_q <= select_3562;
      patches_smooth_values_2_q <= select_3565;
      patches_smooth_values_3_q <= select_3568;
      patches_down_values_0_q <= equal_2249_s1_q ? patches_down_values_0_q : select_3570;
      patches_down_values_1_q <= equal_2249_s1_q ? patches_down_values_1_q : select_3573;
      patches_down_values_2_q <= equal_2249_s1_q ? patches_down_values_2_q : select_3576;
      patches_down_values_3_q <= equal_2249_s1_q ? patches_down_values_3_q : select_3579;
      patches_down_by_q <= or_3516_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3616});
      patches_along_q <= select_3621;
      patches_match_row_q <= or_3516_s1_q ? 4'h0 : select_3623;
      patches_summed_last_q <= not_2250_s1_q & (equal_2251_s1_q & and_3616);
      patches_summed_down_by_q <= select_3979;
      patches_step_q <= or_3516_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3997;
      patches_bands_chosen_q <= equal_572_s1_q ? select_2267 : patches_bands_chosen_q;
      region_across_rest_q <= select_4300;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4303;
      columns_begin_rest_q <= and_547_s1_q ? select_4305 : columns_begin_rest_q;
      columns_begin_back_q <= and_547_s1_q ? select_4308 : columns_begin_back_q;
      done_q <= not_2526 & ((~drew_q) & (done_q | said_q));
      proven_q <= sample_pair_first_q ? done_q : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_572_s1_q & equal_4360;
      rows_passed_q <= select_2509;
      columns_passed_q <= {select_2511[7:0], or_2507};
      line_ended_q <= sample_last_q;
      began_q <= not_2526 & (began_q | select_2513);
      seen_x_q <= select_2513 ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= sample_pair_first_q ? 3'h0 : select_4535;
      seen_column_q <= select_2513 ? 8'h0 : (seen_column_q + {7'h0, equal_2519});
      seen_rows_left_q <= select_4541;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2518;
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
      middle_sum_sum_sums_values_0_q <= sum_1014;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1254;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1494;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1738;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1978;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
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
  logic done_s2_q;
  logic proven_s2_q;
  logic [2:0] select_508_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_512_s2_q;
  logic and_520_s2_q;
  logic and_521_s2_q;
  logic equal_526_s2_q;
  logic [6:0] select_541_s2_q;
  logic [6:0] last_s2_2_q;
  logic and_545_s2_q;
  logic and_547_s2_q;
  logic equal_567_s2_q;
  logic [12:0] select_571_s2_q;
  logic equal_572_s2_q;
  logic not_573_s2_q;
  logic not_575_s2_q;
  logic equal_576_s2_q;
  logic or_577_s2_q;
  logic less_580_s2_q;
  logic not_581_s2_q;
  logic inside_v_s2_q;
  logic not_585_s2_q;
  logic and_589_s2_q;
  logic and_605_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_637_s2_q;
  logic and_640_s2_q;
  logic and_646_s2_q;
  logic and_648_s2_q;
  logic equal_681_s2_q;
  logic and_2038_s2_q;
  logic equal_2039_s2_q;
  logic and_2049_s2_q;
  logic and_2051_s2_q;
  logic [6:0] select_2055_s2_q;
  logic or_2059_s2_q;
  logic and_2162_s2_q;
  logic less_2176_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2249_s2_q;
  logic equal_2251_s2_q;
  logic equal_2254_s2_q;
  logic or_2255_s2_q;
  logic not_2256_s2_q;
  logic equal_2266_s2_q;
  logic [4:0] select_2284_s2_q;
  logic select_2290_s2_q;
  logic [3:0] select_2330_s2_q;
  logic less_2346_s2_q;
  logic new_row_s2_q;
  logic or_2359_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2376_s2_q;
  logic or_2382_s2_q;
  logic and_2386_s2_q;
  logic and_2402_s2_q;
  logic and_2405_s2_q;
  logic and_2419_s2_q;
  logic and_2428_s2_q;
  logic and_2433_s2_q;
  logic less_2434_s2_q;
  logic equal_2435_s2_q;
  logic or_2437_s2_q;
  logic sum_2461_s2_q;
  logic not_2472_s2_q;
  logic and_2486_s2_q;
  logic less_2605_s2_q;
  logic equal_2759_s2_q;
  logic equal_2947_s2_q;
  logic and_3050_s2_q;
  logic and_3064_s2_q;
  logic equal_3153_s2_q;
  logic less_3592_s2_q;
  logic equal_3935_s2_q;
  logic equal_4032_s2_q;
  logic less_4288_s2_q;
  logic equal_4360_s2_q;
  logic or_4518_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
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
      done_s2_q <= done_q;
      proven_s2_q <= proven_q;
      select_508_s2_q <= select_508_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_512_s2_q <= select_512_s1_q;
      and_520_s2_q <= and_520_s1_q;
      and_521_s2_q <= and_521;
      equal_526_s2_q <= equal_526_s1_q;
      select_541_s2_q <= select_541_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_545_s2_q <= and_545_s1_q;
      and_547_s2_q <= and_547_s1_q;
      equal_567_s2_q <= equal_567;
      select_571_s2_q <= select_571;
      equal_572_s2_q <= equal_572_s1_q;
      not_573_s2_q <= not_573;
      not_575_s2_q <= not_575;
      equal_576_s2_q <= equal_576_s1_q;
      or_577_s2_q <= or_577_s1_q;
      less_580_s2_q <= less_580_s1_q;
      not_581_s2_q <= not_581_s1_q;
      inside_v_s2_q <= inside_v;
      not_585_s2_q <= not_585;
      and_589_s2_q <= and_589;
      and_605_s2_q <= (or_577_s1_q & (left_rdata_q[68] & not_581_s1_q)) & and_604;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_637_s2_q <= (or_577_s1_q & (left_rdata_q[70] & not_581_s1_q)) & less_636;
      and_640_s2_q <= or_577_s1_q & (left_rdata_q[71] & not_581_s1_q);
      and_646_s2_q <= and_646;
      and_648_s2_q <= or_577_s1_q & (right_codes_rdata_q[59] & not_581_s1_q);
      equal_681_s2_q <= row_s1_q == 6'h0;
      and_2038_s2_q <= and_2038_s1_q;
      equal_2039_s2_q <= equal_2039_s1_q;
      and_2049_s2_q <= and_2049;
      and_2051_s2_q <= and_2051;
      select_2055_s2_q <= select_2055;
      or_2059_s2_q <= or_2059;
      and_2162_s2_q <= and_2162_s1_q;
      less_2176_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2249_s2_q <= equal_2249_s1_q;
      equal_2251_s2_q <= equal_2251_s1_q;
      equal_2254_s2_q <= equal_2254_s1_q;
      or_2255_s2_q <= or_2255_s1_q;
      not_2256_s2_q <= not_2256_s1_q;
      equal_2266_s2_q <= equal_2266;
      select_2284_s2_q <= select_2284_s1_q;
      select_2290_s2_q <= select_2290_s1_q;
      select_2330_s2_q <= select_2330_s1_q;
      less_2346_s2_q <= less_2346;
      new_row_s2_q <= new_row;
      or_2359_s2_q <= or_2359;
      of_row_2_s2_q <= of_row_2;
      not_2376_s2_q <= ~sum_2375[14];
      or_2382_s2_q <= or_2382;
      and_2386_s2_q <= sum_2375[14] & (~(sum_2375[13:8] == 6'h3f));
      and_2402_s2_q <= (~difference_2394[14]) & or_2401;
      and_2405_s2_q <= difference_2394[14] & (~(difference_2394[13:8] == 6'h3f));
      and_2419_s2_q <= not_2250_s1_q & and_2418;
      and_2428_s2_q <= and_2428;
      and_2433_s2_q <= not_2250_s1_q & and_2432;
      less_2434_s2_q <= less_2434;
      equal_2435_s2_q <= equal_2435;
      or_2437_s2_q <= or_2437;
      sum_2461_s2_q <= sum_2461[5];
      not_2472_s2_q <= ~late_q;
      and_2486_s2_q <= or_577_s1_q & (left_rdata_q[69] & not_581_s1_q);
      less_2605_s2_q <= 6'h6 < row_q;
      equal_2759_s2_q <= {last_s1_2_q[6], or_2758} == 7'h0;
      equal_2947_s2_q <= equal_2947_s1_q;
      and_3050_s2_q <= and_3050;
      and_3064_s2_q <= or_577_s1_q & (not_581_s1_q & and_604);
      equal_3153_s2_q <= shift == 6'h0;
      less_3592_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3935_s2_q <= patches_match_row_q == 4'h0;
      equal_4032_s2_q <= patches_step_q[6:5] == 2'h3;
      less_4288_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4360_s2_q <= equal_4360;
      or_4518_s2_q <= and_3050 | (~(row_s1_q[5:3] == 3'h0));
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
  logic draws_late_q;
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
  // hls/stages/census.hpp:117
  logic [11:0] select_524;
  assign select_524 = select_508_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_528;
  assign sum_528 = select_524 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_530;
  assign sum_530 = {4'h0, sample_pair_pixel_1_q} + (select_508_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_532;
  assign sum_532 = sum_530 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = select_508_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_536;
  assign and_536 = whole & (averager_memory_rdata_q[24] | equal_526_s2_q);
  // hls/stages/agreement.hpp:423
  logic all_of_skin;
  assign all_of_skin = select_508_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_540;
  assign and_540 = all_of_skin & (averager_memory_rdata_q[25] | equal_526_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_520_s2_q ? sum_528[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_550;
  assign equal_550 = select_508_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_550 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_553;
  assign select_553 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_520_s2_q ? sum_532[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_550 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_557;
  assign select_557 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_558;
  assign and_558 = and_520_s2_q & and_536;
  // hls/stages/census.hpp:134
  logic select_560;
  assign select_560 = equal_550 ? and_558 : (averager_mask_q & and_558);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_560;
  // hls/stages/census.hpp:218
  logic and_562;
  assign and_562 = and_520_s2_q & and_540;
  // hls/stages/census.hpp:134
  logic select_564;
  assign select_564 = equal_550 ? and_562 : (averager_of_skin_q & and_562);
  // hls/stages/agreement.hpp:277
  logic and_565;
  assign and_565 = sample_pair_whole_s2_q & select_564;
  // hls/stages/agreement.hpp:989
  logic select_618;
  assign select_618 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:990
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1003
  logic [8:0] difference_628;
  assign difference_628 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_629;
  assign sum_629 = {difference_628[8], difference_628} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_631;
  assign and_631 = (and_605_s2_q & select_618) & ({{22{sum_629[9]}}, sum_629} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_633;
  assign and_633 = or_577_s2_q & (not_581_s2_q & and_631);
  // hls/stages/moments.hpp:89
  logic and_638;
  assign and_638 = and_633 & and_637_s2_q;
  // hls/stages/census.hpp:308
  logic less_654;
  assign less_654 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_666;
  assign less_666 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_678;
  assign equal_678 = last_s2_2_q == 7'h0;
  logic [3:0] select_682;
  assign select_682 = equal_681_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_683;
  assign select_683 = equal_678 ? {select_682, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_684;
  assign select_684 = equal_678 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_685;
  assign and_685 = select_683[4] & select_684[3];
  // hls/stages/census.hpp:300
  logic and_687;
  assign and_687 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_689;
  assign and_689 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_687);
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_689;
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
  logic [9:0] difference_712;
  assign difference_712 = {1'b0, select_553} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_713;
  assign xor_713 = difference_712[8:0] ^ {9{difference_712[9]}};
  logic [9:0] sum_714;
  assign sum_714 = {9'h0, difference_712[9]} + {1'b0, xor_713};
  logic [9:0] difference_715;
  assign difference_715 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_716;
  assign xor_716 = difference_715[8:0] ^ {9{difference_715[9]}};
  logic [9:0] sum_717;
  assign sum_717 = {9'h0, difference_715[9]} + {1'b0, xor_716};
  logic [9:0] difference_719;
  assign difference_719 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_720;
  assign xor_720 = difference_719[8:0] ^ {9{difference_719[9]}};
  logic [9:0] sum_721;
  assign sum_721 = {9'h0, difference_719[9]} + {1'b0, xor_720};
  logic [10:0] sum_722;
  assign sum_722 = ({1'b0, sum_714} + {1'b0, sum_717}) + {1'b0, sum_721};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_724;
  assign xor_724 = difference_723[8:0] ^ {9{difference_723[9]}};
  logic [9:0] sum_725;
  assign sum_725 = {9'h0, difference_723[9]} + {1'b0, xor_724};
  logic [9:0] difference_727;
  assign difference_727 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_728;
  assign xor_728 = difference_727[8:0] ^ {9{difference_727[9]}};
  // hls/stages/agreement.hpp:461
  logic and_736;
  assign and_736 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_737;
  assign and_737 = and_685 & and_736;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_739;
  assign sum_739 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_741;
  assign and_741 = and_737 & ({{5{sum_739[6]}}, sum_739, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_745;
  assign sum_745 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:818
  logic or_762;
  assign or_762 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:819
  logic select_764;
  assign select_764 = or_762 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:762
  logic less_1495;
  assign less_1495 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1496;
  assign select_1496 = less_1495 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1497;
  assign less_1497 = middle_sum_sum_sums_values_0_q < select_1496;
  logic [7:0] select_1498;
  assign select_1498 = less_1497 ? select_1496 : middle_sum_sum_sums_values_0_q;
  logic less_1979;
  assign less_1979 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1980;
  assign select_1980 = less_1979 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1981;
  assign less_1981 = select_1498 < select_1980;
  // hls/stages/agreement.hpp:812
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1981 ? select_1980 : select_1498) : 8'h0;
  // hls/stages/agreement.hpp:819
  logic or_1985;
  assign or_1985 = select_764 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:824
  logic [5:0] select_1986;
  assign select_1986 = or_1985 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:763
  logic or_1988;
  assign or_1988 = less_1495 | (~less_1497);
  logic [2:0] select_1989;
  assign select_1989 = less_1981 ? {less_1979, 2'h0} : {1'b0, or_1988, less_1497};
  // hls/stages/agreement.hpp:824
  logic [2:0] select_1990;
  assign select_1990 = or_1985 ? select_1989 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1991;
  assign select_1991 = or_1985 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:821
  logic equal_1992;
  assign equal_1992 = select_1989 == 3'h1;
  logic or_1995;
  assign or_1995 = equal_1992 | (~(select_1989 == 3'h2));
  logic [7:0] select_1997;
  assign select_1997 = or_1995 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1998;
  assign select_1998 = equal_1992 ? (or_1995 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1997;
  // hls/stages/agreement.hpp:824
  logic [7:0] select_1999;
  assign select_1999 = or_1985 ? select_1998 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:822
  logic [7:0] select_2000;
  assign select_2000 = or_1995 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:824
  logic [7:0] select_2002;
  assign select_2002 = or_1985 ? (equal_1992 ? select_1997 : select_2000) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_2004;
  assign sum_2004 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_2005;
  assign sum_2005 = {1'b0, before_v} + sum_2004;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_2008;
  assign sum_2008 = {1'b0, before_v_2} + sum_2007;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_2010;
  assign sum_2010 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_2011;
  assign sum_2011 = {1'b0, before_v_3} + sum_2010;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_2013;
  assign select_2013 = (sum_2008 < sum_2011) ? sum_2011 : sum_2008;
  logic [6:0] select_2015;
  assign select_2015 = (sum_2005 < select_2013) ? select_2013 : sum_2005;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_2017;
  assign sum_2017 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2018;
  assign sum_2018 = {1'b0, before_v_4} + sum_2017;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_2020;
  assign sum_2020 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2021;
  assign sum_2021 = {1'b0, before_v_5} + sum_2020;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_2023;
  assign select_2023 = (sum_2018 < sum_2021) ? sum_2021 : sum_2018;
  // hls/stages/agreement.hpp:813
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2015 < select_2023) ? select_2023 : select_2015) : 7'h0;
  // hls/stages/agreement.hpp:824
  logic less_2027;
  assign less_2027 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:828
  logic [6:0] select_2029;
  assign select_2029 = select_764 ? of_near : (less_2027 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2031;
  assign select_2031 = select_764 ? run_shift_s2_q : (less_2027 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2034;
  assign select_2034 = (run_shift_s2_q == 6'h3f) ? of_best : (select_764 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_2037;
  assign select_2037 = (run_shift_s2_q == 6'h1) ? of_best : (select_764 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:834
  logic select_2040;
  assign select_2040 = or_762 ? shift_first_s2_q : equal_2039_s2_q;
  // hls/stages/agreement.hpp:835
  logic or_2042;
  assign or_2042 = select_2040 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:839
  logic [7:0] select_2043;
  assign select_2043 = or_2042 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2044;
  assign select_2044 = or_2042 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2046;
  assign or_2046 = select_2040 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:843
  logic [6:0] select_2047;
  assign select_2047 = or_2046 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2048;
  assign select_2048 = or_2046 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_2062;
  assign and_2062 = or_577_s2_q & (not_581_s2_q & (and_631 & or_2059_s2_q));
  // hls/stages/agreement.hpp:799
  logic and_2063;
  assign and_2063 = not_575_s2_q & and_2062;
  logic and_2066;
  assign and_2066 = not_573_s2_q & (drew_q ? and_2049_s2_q : (equal_576_s2_q & and_633));
  // hls/stages/moments.hpp:85
  logic and_2070;
  assign and_2070 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1016
  logic and_2071;
  assign and_2071 = not_585_s2_q & and_2070;
  logic and_2074;
  assign and_2074 = not_585_s2_q & (and_2070 & (moments_memory_rdata_q[1] ^ and_640_s2_q));
  // hls/stages/moments.hpp:85
  logic and_2079;
  assign and_2079 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1016
  logic and_2080;
  assign and_2080 = not_585_s2_q & and_2079;
  logic and_2083;
  assign and_2083 = not_585_s2_q & (and_2079 & (moments_memory_rdata_q[3] ^ and_648_s2_q));
  // hls/stages/agreement.hpp:1145
  logic equal_2084;
  assign equal_2084 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1208
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1146
  logic [1:0] select_2087;
  assign select_2087 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1159
  logic [3:0] select_2089;
  assign select_2089 = equal_2084 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2087});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2090;
  assign sum_2090 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_2091;
  assign select_2091 = equal_572_s2_q ? select_2089 : {sum_2090, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:217
  logic equal_2092;
  assign equal_2092 = x_s2_q[5:0] == 6'h3f;
  logic equal_2094;
  assign equal_2094 = x_s2_q[5:0] == 6'h3e;
  logic equal_2096;
  assign equal_2096 = x_s2_q[5:0] == 6'h3d;
  logic equal_2098;
  assign equal_2098 = x_s2_q[5:0] == 6'h3c;
  logic equal_2100;
  assign equal_2100 = x_s2_q[5:0] == 6'h3b;
  logic equal_2102;
  assign equal_2102 = x_s2_q[5:0] == 6'h36;
  logic equal_2104;
  assign equal_2104 = x_s2_q[5:0] == 6'h35;
  logic equal_2106;
  assign equal_2106 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1208
  logic and_2110;
  assign and_2110 = (~equal_2100) & ((~equal_2102) & ((~equal_2104) & (~equal_2106)));
  logic and_2114;
  assign and_2114 = (~equal_2092) & ((~equal_2094) & ((~equal_2096) & ((~equal_2098) & and_2110)));
  // hls/stages/agreement.hpp:1146
  logic less_2115;
  assign less_2115 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2119;
  assign or_2119 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1023
  logic [5:0] sum_2124;
  assign sum_2124 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2124, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2130;
  assign sum_2130 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2132;
  assign and_2132 = half_ends & ({{3{sum_2130[4]}}, sum_2130} < 8'h3);
  // hls/stages/agreement.hpp:799
  logic and_2133;
  assign and_2133 = drew_q & and_2132;
  logic select_2134;
  assign select_2134 = equal_572_s2_q ? (x_s2_q[6] & (equal_2084 ? and_2114 : (less_2115 & (~or_2119)))) : and_2133;
  // hls/stages/registration.hpp:258
  logic not_2136;
  assign not_2136 = ~lower_half_s2_q;
  logic [3:0] select_2137;
  assign select_2137 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2136, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2136};
  // hls/stages/patches.hpp:382
  logic [1:0] select_2163;
  assign select_2163 = and_2162_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2164;
  assign select_2164 = and_2162_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_2165;
  assign select_2165 = row_starts_s2_q ? {select_2164, select_2163[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2166;
  assign select_2166 = row_starts_s2_q ? select_2163 : patches_fetch_q;
  logic equal_2167;
  assign equal_2167 = select_2166 == 2'h0;
  // hls/stages/agreement.hpp:1032
  logic [6:0] sum_2171;
  assign sum_2171 = x_s2_q[7:1] + 7'h7f;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < {sum_2171, x_s2_q[0]};
  // hls/stages/agreement.hpp:799
  logic and_2175;
  assign and_2175 = not_573_s2_q & (drew_q & (ends_cell_s2_q & right_3));
  // hls/stages/registration.hpp:83
  logic equal_2177;
  assign equal_2177 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_577_s2_q ? (less_580_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2177 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2185;
  assign select_2185 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2186;
  assign select_2186 = b[1] ? a : 8'h0;
  logic [8:0] sum_2187;
  assign sum_2187 = {{2{select_2185[6]}}, select_2185} + {select_2186[7], select_2186};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2188;
  assign select_2188 = b[2] ? a : 8'h0;
  logic [7:0] select_2189;
  assign select_2189 = b[3] ? a : 8'h0;
  logic [8:0] sum_2190;
  assign sum_2190 = {{2{select_2188[7]}}, select_2188[7:1]} + {select_2189[7], select_2189};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2191;
  assign sum_2191 = {{3{sum_2187[8]}}, sum_2187[8:1]} + {sum_2190[8], sum_2190, select_2188[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2192;
  assign select_2192 = b[4] ? a : 8'h0;
  logic [7:0] select_2193;
  assign select_2193 = b[5] ? a : 8'h0;
  logic [8:0] difference_2194;
  assign difference_2194 = {{2{select_2192[7]}}, select_2192[7:1]} - {select_2193[7], select_2193};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2195;
  assign sum_2195 = {difference_2194, select_2192[0]} + {sum_2191[10], sum_2191[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2177 ? {sum_2195, sum_2191[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2197;
  assign sum_2197 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:263
  logic and_2200;
  assign and_2200 = less_2176_s2_q & (and_633 & ({{4{sum_2197[9]}}, sum_2197, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2204;
  assign and_2204 = ({3'h0, last_s2_q[6:1]} < ({1'b0, sum_2171, x_s2_q[0]} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic or_2208;
  assign or_2208 = ({sum_2171, x_s2_q[0]} == 8'h0) | (~({sum_2171, x_s2_q[0]} < {1'b0, last_s2_q}));
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2211;
  assign sum_2211 = {2'h0, sum_2171, x_s2_q[0]} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2213;
  assign sum_2213 = {sum_2211[9], sum_2211[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1032
  logic and_2216;
  assign and_2216 = ($signed(9'h0) < $signed(sum_2211[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2213, sum_2211[0]})));
  // hls/stages/agreement.hpp:799
  logic and_2219;
  assign and_2219 = ends_cell_s2_q & (and_2200 & ((~(and_2204 | or_2208)) & and_2216));
  logic and_2221;
  assign and_2221 = not_573_s2_q & (drew_q & and_2219);
  // hls/stages/patches.hpp:157
  logic and_2223;
  assign and_2223 = and_2221 & (~patches_fixed_q);
  // hls/stages/patches.hpp:351
  logic select_2224;
  assign select_2224 = and_2223 ? and_2221 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_2227;
  assign select_2227 = equal_572_s2_q ? 8'h0 : (drew_q ? (ends_cell_s2_q ? {sum_2171, x_s2_q[0]} : 8'h0) : 8'h0);
  logic [5:0] select_2231;
  assign select_2231 = equal_572_s2_q ? 6'h0 : (drew_q ? (ends_cell_s2_q ? b : 6'h0) : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2233;
  assign sum_2233 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2195[9]}}, sum_2195[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2236;
  assign select_2236 = ($signed(sum_2233[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2233[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2177 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2233[12:7])) ? 8'h7f : select_2236);
  // hls/stages/agreement.hpp:799
  logic [7:0] select_2241;
  assign select_2241 = equal_572_s2_q ? 8'h0 : (drew_q ? (ends_cell_s2_q ? slope : 8'h0) : 8'h0);
  // hls/stages/patches.hpp:113
  logic equal_2243;
  assign equal_2243 = {sum_2171[6], last_s2_q[6:1], x_s2_q[0]} == {1'b0, sum_2171[5:0], last_s2_q[0]};
  // hls/stages/agreement.hpp:799
  logic and_2247;
  assign and_2247 = not_573_s2_q & (drew_q & (ends_cell_s2_q & (and_2204 | equal_2243)));
  // hls/stages/patches.hpp:351
  logic and_2248;
  assign and_2248 = patches_chooses_s2_q & and_2247;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2262;
  assign select_2262 = row_starts_s2_q ? select_2164 : patches_band_q;
  // hls/stages/patches.hpp:360
  logic equal_2263;
  assign equal_2263 = {patches_choosing_band_s2_q, and_2175} == {select_2262, select_2166[1]};
  // hls/stages/patches.hpp:495
  logic [2:0] sum_2367;
  assign sum_2367 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:462
  logic and_2383;
  assign and_2383 = not_2376_s2_q & or_2382_s2_q;
  // hls/stages/patches.hpp:499
  logic [1:0] sum_2423;
  assign sum_2423 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2448;
  assign select_2448 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1066
  logic or_2451;
  assign or_2451 = select_2448[7] | (~({select_2448[5], select_2448[3], select_2448[1]} == 3'h0));
  // hls/stages/agreement.hpp:1065
  logic or_2454;
  assign or_2454 = select_2448[7] | (~({select_2448[6], select_2448[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1064
  logic or_2457;
  assign or_2457 = select_2448[7] | (~(select_2448[6:4] == 3'h0));
  // hls/stages/agreement.hpp:799
  logic [5:0] select_2458;
  assign select_2458 = equal_572_s2_q ? x_s2_q[5:0] : {region_row_q, or_2457, or_2454, or_2451};
  // hls/stages/agreement.hpp:1145
  logic not_2459;
  assign not_2459 = ~equal_2084;
  // hls/stages/agreement.hpp:1072
  logic equal_2463;
  assign equal_2463 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:1074
  logic or_2464;
  assign or_2464 = (~sum_2461_s2_q) | equal_2463;
  // hls/stages/agreement.hpp:799
  logic and_2467;
  assign and_2467 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2464));
  // hls/stages/agreement.hpp:150
  logic and_2471;
  assign and_2471 = or_577_s2_q & (not_581_s2_q & and_605_s2_q);
  logic and_2488;
  assign and_2488 = or_577_s2_q & (not_581_s2_q & and_2486_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2471;
  logic and_2499;
  assign and_2499 = inside_v_s2_q & and_2488;
  logic explained;
  assign explained = inside_v_s2_q & and_633;
  // hls/stages/agreement.hpp:1028
  logic select_2501;
  assign select_2501 = slot_s2_q[2] ? shown_shown_q : and_633;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2501);
  // hls/stages/agreement.hpp:1028
  logic select_2504;
  assign select_2504 = slot_s2_q[2] ? shown_nearer_q : and_2062;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2501 ? select_2504 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1340
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1306
  logic select_2524;
  assign select_2524 = marks_first_s2_q ? (done_s2_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1292
  logic [7:0] sum_2525;
  assign sum_2525 = {1'b0, select_2524, 2'h0, select_2524, 1'b0, {2{select_2524}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1339
  logic and_2532;
  assign and_2532 = began_q & (seen_x_q == 3'h0);
  logic less_2533;
  assign less_2533 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1128
  logic [7:0] sum_2536;
  assign sum_2536 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2536[7]}}, sum_2536, x_s2_q[1:0]} + map_row_q;
  logic select_2539;
  assign select_2539 = draws_late_q ? (draws_late_q & read_half_q) : write_half_q;
  // hls/stages/agreement.hpp:1292
  logic [7:0] sum_2540;
  assign sum_2540 = {1'b0, select_2539, 2'h0, select_2539, 1'b0, {2{select_2539}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1045
  logic and_2541;
  assign and_2541 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2542;
  assign and_2542 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2543;
  assign and_2543 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2544;
  assign and_2544 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2546;
  assign sum_2546 = {1'b0, and_2543} + ({1'b0, textured} + {1'b0, and_2544});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2541} + ({2'h0, and_2542} + {1'b0, sum_2546});
  // hls/stages/agreement.hpp:1045
  logic [7:0] select_2555;
  assign select_2555 = inside_v_s2_q ? (sum_2461_s2_q ? select_2448 : {select_2448[6:0], 1'b0}) : select_2448;
  // hls/stages/agreement.hpp:1066
  logic or_2558;
  assign or_2558 = select_2555[7] | (~({select_2555[5], select_2555[3], select_2555[1]} == 3'h0));
  // hls/stages/agreement.hpp:1045
  logic and_2575;
  assign and_2575 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2576;
  assign and_2576 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2577;
  assign and_2577 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2578;
  assign and_2578 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1105
  logic [1:0] sum_2580;
  assign sum_2580 = {1'b0, and_2577} + ({1'b0, shown} + {1'b0, and_2578});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2575} + ({2'h0, and_2576} + {1'b0, sum_2580});
  // hls/stages/agreement.hpp:1045
  logic and_2591;
  assign and_2591 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2592;
  assign and_2592 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2593;
  assign and_2593 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2594;
  assign and_2594 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1106
  logic [1:0] sum_2596;
  assign sum_2596 = {1'b0, and_2593} + ({1'b0, near} + {1'b0, and_2594});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2591} + ({2'h0, and_2592} + {1'b0, sum_2596});
  // hls/stages/agreement.hpp:1127
  logic not_2607;
  assign not_2607 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1128
  logic not_2609;
  assign not_2609 = ~({sum_2124, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:799
  logic select_2613;
  assign select_2613 = less_2605_s2_q ? (not_2607 & not_2609) : ((draws_late_q & not_2607) & not_2609);
  logic and_2616;
  assign and_2616 = not_573_s2_q & (drew_q & (ends_cell_s2_q & select_2613));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2650;
  assign select_2650 = sample_pair_whole_s2_q ? (and_545_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2652;
  assign select_2652 = sample_pair_whole_s2_q ? (and_545_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2672;
  assign select_2672 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2674;
  assign select_2674 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_560 : averager_mask_q) : averager_mask_q;
  logic select_2676;
  assign select_2676 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_564 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:531
  logic [8:0] select_2677;
  assign select_2677 = and_547_s2_q ? select_553 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_547_s2_q ? select_557 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2680;
  assign select_2680 = and_547_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2681;
  assign select_2681 = and_547_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2682;
  assign select_2682 = and_547_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2683;
  assign select_2683 = and_547_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2684;
  assign select_2684 = and_547_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2685;
  assign select_2685 = and_547_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2686;
  assign select_2686 = and_547_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2687;
  assign select_2687 = and_547_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_547_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2689;
  assign select_2689 = and_547_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_547_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_547_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2692;
  assign select_2692 = and_547_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_547_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_547_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2695;
  assign select_2695 = and_547_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2696;
  assign select_2696 = and_547_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2697;
  assign select_2697 = and_547_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2698;
  assign select_2698 = and_547_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2699;
  assign select_2699 = and_547_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2700;
  assign select_2700 = and_547_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2701;
  assign select_2701 = and_547_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2702;
  assign select_2702 = and_547_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2703;
  assign select_2703 = and_547_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2704;
  assign select_2704 = and_547_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2705;
  assign select_2705 = and_547_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2706;
  assign select_2706 = and_547_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2707;
  assign select_2707 = and_547_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2708;
  assign select_2708 = and_547_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2709;
  assign select_2709 = and_547_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2710;
  assign select_2710 = and_547_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2711;
  assign select_2711 = and_547_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2712;
  assign select_2712 = and_547_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2713;
  assign select_2713 = and_547_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2714;
  assign select_2714 = and_547_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2715;
  assign select_2715 = and_547_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2716;
  assign select_2716 = and_547_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2717;
  assign select_2717 = and_547_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2718;
  assign select_2718 = and_547_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2719;
  assign select_2719 = and_547_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2720;
  assign select_2720 = and_547_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2721;
  assign select_2721 = and_547_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2722;
  assign select_2722 = and_547_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2723;
  assign select_2723 = and_547_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2724;
  assign select_2724 = and_547_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2725;
  assign select_2725 = and_547_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2726;
  assign select_2726 = and_547_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2727;
  assign select_2727 = and_547_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2728;
  assign select_2728 = and_547_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2729;
  assign select_2729 = and_547_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2730;
  assign select_2730 = and_547_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2731;
  assign select_2731 = and_547_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2732;
  assign select_2732 = and_547_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2734;
  assign difference_2734 = {1'b0, select_557} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2735;
  assign xor_2735 = difference_2734[8:0] ^ {9{difference_2734[9]}};
  logic [9:0] sum_2736;
  assign sum_2736 = {9'h0, difference_2734[9]} + {1'b0, xor_2735};
  logic [9:0] difference_2737;
  assign difference_2737 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2738;
  assign xor_2738 = difference_2737[8:0] ^ {9{difference_2737[9]}};
  logic [9:0] sum_2739;
  assign sum_2739 = {9'h0, difference_2737[9]} + {1'b0, xor_2738};
  logic [9:0] difference_2741;
  assign difference_2741 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2742;
  assign xor_2742 = difference_2741[8:0] ^ {9{difference_2741[9]}};
  logic [9:0] sum_2743;
  assign sum_2743 = {9'h0, difference_2741[9]} + {1'b0, xor_2742};
  logic [10:0] sum_2744;
  assign sum_2744 = ({1'b0, sum_2736} + {1'b0, sum_2739}) + {1'b0, sum_2743};
  logic [9:0] difference_2745;
  assign difference_2745 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2746;
  assign xor_2746 = difference_2745[8:0] ^ {9{difference_2745[9]}};
  logic [9:0] sum_2747;
  assign sum_2747 = {9'h0, difference_2745[9]} + {1'b0, xor_2746};
  logic [9:0] difference_2749;
  assign difference_2749 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2750;
  assign xor_2750 = difference_2749[8:0] ^ {9{difference_2749[9]}};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2771;
  assign sum_2771 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2773;
  assign sum_2773 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/moments.hpp:153
  logic [13:0] select_2774;
  assign select_2774 = equal_2266_s2_q ? sum_2771 : moments_before_0_q;
  logic [13:0] select_2776;
  assign select_2776 = equal_2266_s2_q ? sum_2773 : moments_before_1_q;
  // hls/stages/agreement.hpp:799
  logic select_2779;
  assign select_2779 = equal_572_s2_q ? (moments_has_before_q | equal_2266_s2_q) : moments_has_before_q;
  logic [13:0] select_2782;
  assign select_2782 = equal_572_s2_q ? ((select_2776 < select_2774) ? select_2774 : select_2776) : moments_most_before_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2783;
  assign sum_2783 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2786;
  assign select_2786 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2783)) : moments_left_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2787;
  assign sum_2787 = {1'b0, sum_2773} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2790;
  assign select_2790 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2787)) : moments_left_alone_q;
  logic select_2793;
  assign select_2793 = equal_572_s2_q ? (~({3'h0, select_2776[13:2]} < sum_2787)) : moments_left_other_stops_q;
  logic select_2796;
  assign select_2796 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2783)) : moments_right_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2797;
  assign sum_2797 = {1'b0, sum_2771} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2800;
  assign select_2800 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2797)) : moments_right_alone_q;
  logic select_2803;
  assign select_2803 = equal_572_s2_q ? (~({3'h0, select_2774[13:2]} < sum_2797)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:799
  logic and_2814;
  assign and_2814 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_2074)));
  logic and_2818;
  assign and_2818 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_2083)));
  // hls/stages/moments.hpp:106
  logic and_2820;
  assign and_2820 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2823;
  assign select_2823 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2820)) : and_2820;
  // hls/stages/moments.hpp:153
  logic and_2826;
  assign and_2826 = equal_2266_s2_q & (cfg_prove_i & (cfg_same_table_i & select_2823));
  // hls/stages/moments.hpp:107
  logic and_2830;
  assign and_2830 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2844;
  assign difference_2844 = {1'b0, select_553} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2844[9]} + (difference_2844[8:0] ^ {9{difference_2844[9]}});
  logic [9:0] difference_2856;
  assign difference_2856 = {1'b0, select_557} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2856[9]} + (difference_2856[8:0] ^ {9{difference_2856[9]}});
  // hls/stages/agreement.hpp:531
  logic select_3052;
  assign select_3052 = and_547_s2_q ? (equal_2947_s2_q ? and_3050_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:799
  logic not_3054;
  assign not_3054 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3055;
  assign less_3055 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:531
  logic and_3062;
  assign and_3062 = and_547_s2_q & (equal_681_s2_q & equal_2947_s2_q);
  // hls/stages/agreement.hpp:799
  logic and_3067;
  assign and_3067 = ends_cell_s2_q & (inside_v_s2_q & (and_3064_s2_q & not_2472_s2_q));
  // hls/stages/agreement.hpp:1045
  logic and_3091;
  assign and_3091 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3092;
  assign and_3092 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3093;
  assign and_3093 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3094;
  assign and_3094 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_3096;
  assign sum_3096 = {1'b0, and_3093} + ({1'b0, explained} + {1'b0, and_3094});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3091} + ({2'h0, and_3092} + {1'b0, sum_3096});
  // hls/stages/agreement.hpp:799
  logic and_3132;
  assign and_3132 = ends_cell_s2_q & (inside_v_s2_q & (not_2472_s2_q & (and_3064_s2_q & and_2488)));
  // hls/stages/agreement.hpp:997
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:998
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:999
  logic [7:0] difference_3157;
  assign difference_3157 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3160;
  assign less_3160 = {2'h0, difference_3157[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_3163;
  assign and_3163 = not_581_s2_q & (((and_2486_s2_q & and_631) & equal_3153_s2_q) & (~less_3160));
  // hls/stages/agreement.hpp:799
  logic and_3167;
  assign and_3167 = ends_cell_s2_q & (inside_v_s2_q & ((or_577_s2_q & and_3163) & not_2472_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_3173;
  assign and_3173 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_3175;
  assign and_3175 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3176;
  assign select_3176 = or_577_s2_q ? {and_3175, and_3173} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_3178;
  assign select_3178 = less_580_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3179;
  assign select_3179 = or_577_s2_q ? select_3178 : 2'h0;
  // hls/stages/agreement.hpp:1042
  logic and_3181;
  assign and_3181 = and_633 & (select_3176[0] & select_3179[0]);
  // hls/stages/agreement.hpp:799
  logic and_3185;
  assign and_3185 = ends_cell_s2_q & (inside_v_s2_q & (not_2472_s2_q & (select_3176[1] & and_3181)));
  logic and_3187;
  assign and_3187 = not_573_s2_q & (drew_q & and_3185);
  logic and_3193;
  assign and_3193 = ends_cell_s2_q & (inside_v_s2_q & (not_2472_s2_q & (select_3179[1] & and_3181)));
  logic and_3195;
  assign and_3195 = not_573_s2_q & (drew_q & and_3193);
  // hls/stages/registration.hpp:76
  logic less_3198;
  assign less_3198 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_3200;
  assign select_3200 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3202;
  assign select_3202 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3204;
  assign select_3204 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3202} - {1'b0, select_3204};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3206;
  assign select_3206 = rise_2[8] ? select_3202 : select_3204;
  logic [8:0] fall;
  assign fall = {1'b0, select_3200} - {1'b0, select_3206};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3209;
  assign not_3209 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3198 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3209};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3211;
  assign xor_3211 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3211};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3217;
  assign select_3217 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3198 ? {taken, 1'b1} : {not_3209, select_3217, not_3209};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3219;
  assign sum_3219 = {left, 1'b1} + {taken_2, less_3198};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_3221;
  assign select_3221 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_3223;
  assign select_3223 = equal_572_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_3225;
  assign select_3225 = equal_572_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3226;
  assign equal_3226 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_3230;
  assign and_3230 = and_633 & less_2176_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_3232;
  assign select_3232 = or_577_s2_q ? (less_580_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3236;
  assign sum_3236 = select_3232[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3239;
  assign select_3239 = (select_3202 < select_3204) ? ({sum_3236, select_3232[0], 5'h0} - {3'h0, select_3221}) : {sum_3236, select_3232[0], select_3221};
  logic [7:0] select_3240;
  assign select_3240 = ((select_3232 == 3'h0) | (select_3232 == 3'h4)) ? {sum_3236, select_3232[0], 5'h0} : select_3239;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3240[7]}}, select_3240} - {sum_2195[9], sum_2195, sum_2191[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3243;
  assign select_3243 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3243[11:7])) ? 12'h7f : select_3243;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3264;
  assign difference_3264 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3266;
  assign and_3266 = and_3230 & ($signed(difference_3264) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3279;
  assign less_3279 = $signed(difference_3264) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:799
  logic select_3287;
  assign select_3287 = drew_q ? (equal_3226 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3290;
  assign select_3290 = drew_q ? (equal_2177 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3295;
  assign select_3295 = (sum_2090 == 2'h2) ? (registration_fresh_q & (~select_2137)) : registration_fresh_q;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_3297;
  assign select_3297 = drew_q ? (and_2132 ? select_3295 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3299;
  assign select_3299 = and_3062 ? 4'hf : (equal_572_s2_q ? registration_fresh_q : select_3297);
  // hls/stages/agreement.hpp:1146
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2087;
  // hls/stages/registration.hpp:258
  logic not_3319;
  assign not_3319 = ~quarter_2[1];
  logic [3:0] select_3320;
  assign select_3320 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3319, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3319};
  // hls/stages/patches.hpp:91
  logic parity_3454;
  assign parity_3454 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3455;
  assign select_3455 = equal_2947_s2_q ? {patches_chance_q[14:0], parity_3454} : patches_chance_q;
  // hls/stages/patches.hpp:352
  logic not_3457;
  assign not_3457 = ~and_2247;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3460;
  assign select_3460 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3460};
  // hls/stages/agreement.hpp:799
  logic and_3465;
  assign and_3465 = drew_q & (ends_cell_s2_q & (~({sum_2171, x_s2_q[0]} < {1'b0, from})));
  // hls/stages/patches.hpp:157
  logic and_3469;
  assign and_3469 = not_3457 & (patches_fixed_q | ((not_573_s2_q & and_3465) & and_2223));
  // hls/stages/patches.hpp:362
  logic not_3481;
  assign not_3481 = ~select_2166[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3483;
  assign select_3483 = sample_pair_whole_s2_q ? (equal_2167 ? select_2166 : {not_3481, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:531
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3582;
  assign select_3582 = or_2255_s2_q ? {and_2405_s2_q, and_2402_s2_q, and_2386_s2_q, and_2383, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3584;
  assign select_3584 = equal_2249_s2_q ? patches_codes_at_q : (equal_2251_s2_q ? other[55:4] : select_3582);
  // hls/stages/patches.hpp:514
  logic [27:0] word;
  assign word = or_2359_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:530
  logic [27:0] select_3587;
  assign select_3587 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3589;
  assign select_3589 = equal_2251_s2_q ? (new_row_s2_q ? word : select_3587) : patches_codes_further_q;
  // hls/stages/patches.hpp:532
  logic [55:0] select_3591;
  assign select_3591 = less_2346_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:502
  logic [55:0] select_3593;
  assign select_3593 = less_3592_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3595;
  assign select_3595 = or_2255_s2_q ? (equal_2254_s2_q ? patches_next_codes_q : select_3593) : patches_next_codes_q;
  logic [55:0] select_3597;
  assign select_3597 = equal_2249_s2_q ? patches_next_codes_q : (equal_2251_s2_q ? select_3591 : select_3595);
  // hls/stages/count_bits.hpp:24
  logic parity_3602;
  assign parity_3602 = ^{and_2405_s2_q, and_2402_s2_q, and_2386_s2_q, and_2383};
  // hls/stages/count_bits.hpp:25
  logic or_3606;
  assign or_3606 = ({and_2386_s2_q, and_2383} == 2'h3) | (and_2402_s2_q & (and_2386_s2_q | and_2383));
  logic and_3607;
  assign and_3607 = and_2405_s2_q & (^{and_2402_s2_q, and_2386_s2_q, and_2383});
  // hls/stages/count_bits.hpp:24
  logic xor_3608;
  assign xor_3608 = or_3606 ^ and_3607;
  // hls/stages/count_bits.hpp:27
  logic and_3609;
  assign and_3609 = or_3606 & and_3607;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3611;
  assign select_3611 = or_2255_s2_q ? (and_2428_s2_q ? {and_3609, xor_3608, parity_3602} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3615;
  assign sum_3615 = {7'h0, patches_set_q} + (equal_2254_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:531
  logic [47:0] select_3625;
  assign select_3625 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3627;
  assign select_3627 = equal_2249_s2_q ? patches_left_row_q : (equal_2251_s2_q ? select_3625 : patches_left_row_q);
  // hls/stages/patches.hpp:533
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3625;
  // hls/stages/count_bits.hpp:24
  logic xor_3631;
  assign xor_3631 = bits[17] ^ (^{select_3625[16:15], other[16:15]});
  logic xor_3634;
  assign xor_3634 = bits[11] ^ (^{select_3625[10:9], other[10:9]});
  logic xor_3637;
  assign xor_3637 = bits[14] ^ (^{select_3625[13:12], other[13:12]});
  logic xor_3640;
  assign xor_3640 = xor_3631 ^ (^{select_3625[14:9], other[14:9]});
  logic xor_3643;
  assign xor_3643 = bits[47] ^ (^{select_3625[46:45], other[46:45]});
  logic xor_3646;
  assign xor_3646 = bits[8] ^ (^{select_3625[7:6], other[7:6]});
  logic xor_3649;
  assign xor_3649 = bits[2] ^ (^{select_3625[1:0], other[1:0]});
  logic xor_3652;
  assign xor_3652 = bits[5] ^ (^{select_3625[4:3], other[4:3]});
  logic xor_3655;
  assign xor_3655 = xor_3646 ^ (^{select_3625[5:0], other[5:0]});
  logic parity_3657;
  assign parity_3657 = ^{select_3625[47:45], select_3625[8:0], other[47:45], other[8:0]};
  logic xor_3658;
  assign xor_3658 = xor_3640 ^ parity_3657;
  logic xor_3661;
  assign xor_3661 = bits[44] ^ (^{select_3625[43:42], other[43:42]});
  logic xor_3664;
  assign xor_3664 = bits[38] ^ (^{select_3625[37:36], other[37:36]});
  logic xor_3667;
  assign xor_3667 = bits[41] ^ (^{select_3625[40:39], other[40:39]});
  logic xor_3673;
  assign xor_3673 = bits[26] ^ (^{select_3625[25:24], other[25:24]});
  logic xor_3676;
  assign xor_3676 = bits[20] ^ (^{select_3625[19:18], other[19:18]});
  logic xor_3679;
  assign xor_3679 = bits[23] ^ (^{select_3625[22:21], other[22:21]});
  logic xor_3682;
  assign xor_3682 = xor_3673 ^ (^{select_3625[23:18], other[23:18]});
  logic xor_3685;
  assign xor_3685 = bits[35] ^ (^{select_3625[34:33], other[34:33]});
  logic xor_3688;
  assign xor_3688 = bits[29] ^ (^{select_3625[28:27], other[28:27]});
  logic xor_3691;
  assign xor_3691 = bits[32] ^ (^{select_3625[31:30], other[31:30]});
  logic xor_3694;
  assign xor_3694 = xor_3685 ^ (^{select_3625[32:27], other[32:27]});
  logic xor_3695;
  assign xor_3695 = xor_3682 ^ xor_3694;
  // hls/stages/count_bits.hpp:25
  logic or_3703;
  assign or_3703 = (xor_3634 & xor_3637) | (xor_3631 & (xor_3634 | xor_3637));
  logic or_3707;
  assign or_3707 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3711;
  assign or_3711 = (xor_3649 & xor_3652) | (xor_3646 & (xor_3649 | xor_3652));
  // hls/stages/count_bits.hpp:23
  logic or_3718;
  assign or_3718 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3722;
  assign or_3722 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3726;
  assign or_3726 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3729;
  assign parity_3729 = ^{or_3726, or_3722, or_3718};
  // hls/stages/count_bits.hpp:23
  logic or_3733;
  assign or_3733 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3737;
  assign or_3737 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3741;
  assign or_3741 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3744;
  assign parity_3744 = ^{or_3741, or_3737, or_3733};
  logic parity_3747;
  assign parity_3747 = ^{or_3741, or_3737, or_3733, or_3726, or_3722, or_3718, or_3711, or_3707, or_3703};
  // hls/stages/count_bits.hpp:23
  logic or_3751;
  assign or_3751 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3755;
  assign or_3755 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3759;
  assign or_3759 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3767;
  assign or_3767 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3771;
  assign or_3771 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3775;
  assign or_3775 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3778;
  assign parity_3778 = ^{or_3775, or_3771, or_3767};
  // hls/stages/count_bits.hpp:23
  logic or_3782;
  assign or_3782 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3786;
  assign or_3786 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3790;
  assign or_3790 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3793;
  assign parity_3793 = ^{or_3790, or_3786, or_3782};
  logic parity_3796;
  assign parity_3796 = ^{or_3790, or_3786, or_3782, or_3775, or_3771, or_3767, or_3759, or_3755, or_3751};
  // hls/stages/count_bits.hpp:25
  logic or_3800;
  assign or_3800 = (xor_3664 & xor_3667) | (xor_3661 & (xor_3664 | xor_3667));
  logic or_3804;
  assign or_3804 = (xor_3676 & xor_3679) | (xor_3673 & (xor_3676 | xor_3679));
  logic or_3808;
  assign or_3808 = (xor_3688 & xor_3691) | (xor_3685 & (xor_3688 | xor_3691));
  // hls/stages/count_bits.hpp:24
  logic parity_3811;
  assign parity_3811 = ^{or_3808, or_3804, or_3800};
  // hls/stages/count_bits.hpp:25
  logic and_3812;
  assign and_3812 = xor_3658 & (^{xor_3695, select_3625[44:36], other[44:36]});
  logic or_3816;
  assign or_3816 = (xor_3643 & xor_3655) | (xor_3640 & (xor_3643 | xor_3655));
  logic and_3819;
  assign and_3819 = (xor_3661 ^ (^{select_3625[41:36], other[41:36]})) & (xor_3682 | xor_3694);
  logic or_3820;
  assign or_3820 = (xor_3682 & xor_3694) | and_3819;
  // hls/stages/count_bits.hpp:24
  logic parity_3823;
  assign parity_3823 = ^{or_3820, or_3816, and_3812};
  logic parity_3826;
  assign parity_3826 = ^{or_3820, or_3816, and_3812, or_3808, or_3804, or_3800, or_3790, or_3786, or_3782, or_3775, or_3771, or_3767, or_3759, or_3755, or_3751};
  logic parity_3828;
  assign parity_3828 = ^{or_3820, or_3816, and_3812, or_3808, or_3804, or_3800, or_3790, or_3786, or_3782, or_3775, or_3771, or_3767, or_3759, or_3755, or_3751, or_3741, or_3737, or_3733, or_3726, or_3722, or_3718, or_3711, or_3707, or_3703};
  // hls/stages/count_bits.hpp:25
  logic and_3829;
  assign and_3829 = parity_3747 & parity_3826;
  logic or_3833;
  assign or_3833 = (parity_3729 & parity_3744) | ((^{or_3711, or_3707, or_3703}) & (parity_3729 | parity_3744));
  logic or_3837;
  assign or_3837 = (parity_3811 & parity_3823) | (parity_3796 & (parity_3811 | parity_3823));
  logic or_3844;
  assign or_3844 = (parity_3778 & parity_3793) | ((^{or_3759, or_3755, or_3751}) & (parity_3778 | parity_3793));
  logic or_3848;
  assign or_3848 = (or_3804 & or_3808) | (or_3800 & (or_3804 | or_3808));
  logic or_3852;
  assign or_3852 = (or_3816 & or_3820) | (and_3812 & (or_3816 | or_3820));
  // hls/stages/count_bits.hpp:23
  logic or_3859;
  assign or_3859 = (or_3755 & or_3759) | (or_3751 & (or_3755 | or_3759));
  // hls/stages/count_bits.hpp:25
  logic or_3863;
  assign or_3863 = (or_3771 & or_3775) | (or_3767 & (or_3771 | or_3775));
  logic or_3867;
  assign or_3867 = (or_3786 & or_3790) | (or_3782 & (or_3786 | or_3790));
  // hls/stages/count_bits.hpp:24
  logic parity_3870;
  assign parity_3870 = ^{or_3867, or_3863, or_3859};
  // hls/stages/count_bits.hpp:23
  logic or_3874;
  assign or_3874 = (or_3707 & or_3711) | (or_3703 & (or_3707 | or_3711));
  // hls/stages/count_bits.hpp:25
  logic or_3878;
  assign or_3878 = (or_3722 & or_3726) | (or_3718 & (or_3722 | or_3726));
  logic or_3882;
  assign or_3882 = (or_3737 & or_3741) | (or_3733 & (or_3737 | or_3741));
  // hls/stages/count_bits.hpp:24
  logic parity_3885;
  assign parity_3885 = ^{or_3882, or_3878, or_3874};
  logic parity_3888;
  assign parity_3888 = ^{or_3882, or_3878, or_3874, or_3867, or_3863, or_3859, or_3852, or_3848, or_3844};
  logic parity_3890;
  assign parity_3890 = ^{or_3882, or_3878, or_3874, or_3867, or_3863, or_3859, or_3852, or_3848, or_3844, or_3837, or_3833, and_3829};
  // hls/stages/count_bits.hpp:25
  logic or_3894;
  assign or_3894 = (or_3848 & or_3852) | (or_3844 & (or_3848 | or_3852));
  logic or_3898;
  assign or_3898 = (or_3863 & or_3867) | (or_3859 & (or_3863 | or_3867));
  logic or_3902;
  assign or_3902 = (or_3878 & or_3882) | (or_3874 & (or_3878 | or_3882));
  // hls/stages/count_bits.hpp:24
  logic parity_3905;
  assign parity_3905 = ^{or_3902, or_3898, or_3894};
  // hls/stages/count_bits.hpp:25
  logic and_3906;
  assign and_3906 = (^{or_3837, or_3833, and_3829}) & parity_3888;
  logic or_3910;
  assign or_3910 = (or_3833 & or_3837) | (and_3829 & (or_3833 | or_3837));
  logic or_3914;
  assign or_3914 = (parity_3870 & parity_3885) | ((^{or_3852, or_3848, or_3844}) & (parity_3870 | parity_3885));
  // hls/stages/count_bits.hpp:24
  logic parity_3917;
  assign parity_3917 = ^{or_3914, or_3910, and_3906};
  // hls/stages/count_bits.hpp:25
  logic and_3919;
  assign and_3919 = parity_3905 & parity_3917;
  logic or_3923;
  assign or_3923 = (or_3898 & or_3902) | (or_3894 & (or_3898 | or_3902));
  logic or_3927;
  assign or_3927 = (or_3910 & or_3914) | (and_3906 & (or_3910 | or_3914));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3972;
  assign select_3972 = equal_2251_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3975;
  assign select_3975 = equal_2249_s2_q ? patches_summed_first_q : (equal_2251_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:564
  logic [9:0] select_3983;
  assign select_3983 = less_2434_s2_q ? (or_2437_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3986;
  assign select_3986 = less_2434_s2_q ? (or_2437_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3989;
  assign select_3989 = less_2434_s2_q ? (or_2437_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3994;
  assign select_3994 = equal_2249_s2_q ? (less_2434_s2_q & (or_2437_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3999;
  assign or_3999 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_4000;
  assign and_4000 = patches_read_searches_s2_q & or_3999;
  // hls/stages/patches.hpp:548
  logic [4:0] select_4001;
  assign select_4001 = and_4000 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:555
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_4001};
  // hls/stages/patches.hpp:564
  logic and_4006;
  assign and_4006 = less_2434_s2_q & (or_2437_s2_q & (equal_2435_s2_q & (away == 6'h3f)));
  logic and_4011;
  assign and_4011 = less_2434_s2_q & (or_2437_s2_q & (equal_2435_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:561
  logic [6:0] sum_4013;
  assign sum_4013 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:562
  logic [9:0] select_4016;
  assign select_4016 = (equal_2435_s2_q & ({sum_4013[6], sum_4013} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:564
  logic [9:0] select_4018;
  assign select_4018 = less_2434_s2_q ? (or_2437_s2_q ? select_4016 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:547
  logic [14:0] select_4020;
  assign select_4020 = and_4000 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4021;
  assign select_4021 = equal_2249_s2_q ? select_4020[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4022;
  assign select_4022 = equal_2249_s2_q ? select_4020[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:549
  logic [9:0] select_4024;
  assign select_4024 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4025;
  assign select_4025 = equal_2249_s2_q ? select_4024 : patches_peak_above_q;
  // hls/stages/patches.hpp:550
  logic [9:0] select_4026;
  assign select_4026 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4027;
  assign select_4027 = equal_2249_s2_q ? select_4026 : patches_peak_below_q;
  // hls/stages/patches.hpp:551
  logic [9:0] select_4029;
  assign select_4029 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4031;
  assign select_4031 = equal_2249_s2_q ? (patches_read_first_q ? patches_read_far_q : select_4029) : patches_peak_far_q;
  logic [9:0] select_4034;
  assign select_4034 = equal_2249_s2_q ? (equal_4032_s2_q ? sum_3615 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:799
  logic select_4285;
  assign select_4285 = equal_572_s2_q ? shown_shown_q : (drew_q ? select_2501 : shown_shown_q);
  logic select_4287;
  assign select_4287 = equal_572_s2_q ? shown_nearer_q : (drew_q ? select_2504 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4289;
  assign sum_4289 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_4292;
  assign select_4292 = less_4288_s2_q ? (sum_4289[7] ? region_row_q : next_region_row_q) : (and_3050_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:531
  logic [2:0] select_4294;
  assign select_4294 = and_547_s2_q ? (equal_2947_s2_q ? select_4292 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_4298;
  assign select_4298 = equal_572_s2_q ? select_2448 : (drew_q ? (ends_cell_s2_q ? select_2555 : select_2448) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4311;
  assign select_4311 = equal_681_s2_q ? {{2{difference_4310[6]}}, difference_4310} : region_down_rest_q;
  logic [8:0] select_4313;
  assign select_4313 = equal_2947_s2_q ? (less_4288_s2_q ? region_down_next_q : select_4311) : region_down_rest_q;
  logic [6:0] select_4316;
  assign select_4316 = equal_681_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  logic [6:0] select_4318;
  assign select_4318 = equal_2947_s2_q ? (less_4288_s2_q ? region_down_back_q : select_4316) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4320;
  assign sum_4320 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4321;
  assign select_4321 = sum_4289[7] ? {1'b1, sum_4289[6:0], region_down_rest_q[0]} : sum_4320;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4289[7];
  // hls/stages/agreement.hpp:465
  logic select_4325;
  assign select_4325 = equal_2947_s2_q ? (less_4288_s2_q ? next : (region_fresh_q | equal_681_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_4330;
  assign or_4330 = segment_starts_q | not_575_s2_q;
  // hls/stages/agreement.hpp:1045
  logic select_4333;
  assign select_4333 = inside_v_s2_q ? (sum_2461_s2_q ? (equal_2463 & or_2464) : or_2464) : or_4330;
  // hls/stages/agreement.hpp:799
  logic select_4336;
  assign select_4336 = equal_572_s2_q ? or_4330 : (drew_q ? (ends_cell_s2_q ? select_4333 : or_4330) : or_4330);
  logic select_4504;
  assign select_4504 = drew_q ? (ends_cell_s2_q ? and_2543 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4507;
  assign select_4507 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4509;
  assign select_4509 = equal_572_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4507 : centres_values_0_of_skin_q);
  logic select_4510;
  assign select_4510 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4512;
  assign select_4512 = equal_572_s2_q ? centres_values_1_textured_q : (drew_q ? select_4510 : centres_values_1_textured_q);
  logic select_4513;
  assign select_4513 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4515;
  assign select_4515 = equal_572_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4513 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4521;
  assign select_4521 = equal_2947_s2_q ? (or_4518_s2_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:531
  logic [6:0] select_4524;
  assign select_4524 = and_547_s2_q ? (equal_2947_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/registration.hpp:258
  logic not_4617;
  assign not_4617 = ~quarter[1];
  logic [3:0] select_4618;
  assign select_4618 = quarter[0] ? {quarter[1], 1'b0, not_4617, 1'b0} : {1'b0, quarter[1], 1'b0, not_4617};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2091;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2134;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:782; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2165;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2167));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1431; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2458;
  logic regions_re;
  assign regions_re = s2_en & (equal_572_s2_q ? (x_s2_q[6] & not_2459) : and_2467);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1444; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2525, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2532 & less_2533);
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
  assign averager_memory_waddr = select_512_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_521_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_540, and_536, sum_532, sum_528};
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
  assign census_memory_we = s2_en & and_547_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_565, whole_2, select_557, select_553};
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
  assign moments_memory_waddr = select_571_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_589_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_648_s2_q, and_646_s2_q, and_640_s2_q, and_638};
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
  assign best_left_we = s2_en & and_2038_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2037, select_2034, select_2031, select_2029, select_2002, select_1999, select_1991, select_1990, select_1986};
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
  assign best_right_we = s2_en & and_2038_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2048, select_2047, select_2044, select_2043};
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
  assign shown_right_waddr = select_2055_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2066;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2063, not_575_s2_q};
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
  assign left_turns_wdata = {and_2074, and_2071};
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
  assign right_turns_wdata = {and_2083, and_2080};
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
  assign patches_right_codes_waddr = {sum_2367, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2419_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2405_s2_q, and_2402_s2_q, and_2386_s2_q, and_2383, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2423, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2433_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2405_s2_q, and_2402_s2_q, and_2386_s2_q, and_2383, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2051_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2499, textured};
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
      draws_late_q <= 1'b0;
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
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2672;
      averager_mask_q <= select_2674;
      averager_of_skin_q <= select_2676;
      census_filled_q <= and_547_s2_q ? {select_684[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2771;
      moments_turned_1_q <= sum_2773;
      moments_before_0_q <= equal_572_s2_q ? select_2774 : moments_before_0_q;
      moments_before_1_q <= equal_572_s2_q ? select_2776 : moments_before_1_q;
      moments_has_before_q <= select_2779;
      moments_most_before_q <= select_2782;
      moments_left_begins_q <= select_2786;
      moments_left_alone_q <= select_2790;
      moments_left_other_stops_q <= select_2793;
      moments_right_begins_q <= select_2796;
      moments_right_alone_q <= select_2800;
      moments_right_other_stops_q <= select_2803;
      moments_out_of_step_q <= out_of_step;
      moments_turns_0_q <= and_2814;
      moments_turns_1_q <= and_2818;
      moments_begins_alone_q <= equal_572_s2_q & and_2826;
      moments_ends_q <= equal_572_s2_q & (equal_2266_s2_q & (not_2828 | and_2830));
      rows_passed_above_q <= and_547_s2_q ? select_683 : rows_passed_above_q;
      draws_late_q <= select_3052;
      shift_allowed_q <= not_3054 & (~less_3055);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3062 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3187});
      counts_turned_right_q <= and_3062 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3195});
      registration_displacement_over_q <= drew_q ? sum_3219[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3221;
      registration_slope_here_q <= select_3223;
      registration_expected_q <= select_3225;
      registration_of_right_q <= equal_572_s2_q ? registration_of_right_q : select_3287;
      registration_was_inside_q <= equal_572_s2_q ? registration_was_inside_q : select_3290;
      registration_fresh_q <= select_3299;
      patches_chance_q <= and_547_s2_q ? select_3455 : patches_chance_q;
      patches_fixed_q <= and_3469;
      patches_choice_valid_q <= and_2247 ? (select_2224 & not_3457) : select_2224;
      patches_choice_column_q <= and_2223 ? select_2227 : patches_choice_column_q;
      patches_choice_shift_q <= and_2223 ? select_2231 : patches_choice_shift_q;
      patches_choice_slope_q <= and_2223 ? select_2241 : patches_choice_slope_q;
      patches_band_q <= sample_pair_whole_s2_q ? select_2262 : patches_band_q;
      patches_fetch_q <= select_3483;
      patches_codes_at_q <= select_3584;
      patches_codes_further_q <= equal_2249_s2_q ? patches_codes_further_q : select_3589;
      patches_next_codes_q <= select_3597;
      patches_set_q <= equal_2249_s2_q ? 3'h0 : (equal_2251_s2_q ? 3'h0 : select_3611);
      patches_size_q <= sum_3615;
      patches_left_row_q <= select_3627;
      patches_summed_row_column_q <= equal_2249_s2_q ? patches_summed_row_column_q : select_3972;
      patches_summed_first_q <= select_3975;
      patches_read_row_differing_q <= equal_2249_s2_q ? select_3983 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2249_s2_q ? select_3986 : patches_read_row_column_q;
      patches_read_at_q <= equal_2249_s2_q ? select_3989 : patches_read_at_q;
      patches_read_first_q <= select_3994;
      patches_read_above_q <= equal_2249_s2_q ? and_4006 : patches_read_above_q;
      patches_read_below_q <= equal_2249_s2_q ? and_4011 : patches_read_below_q;
      patches_read_far_q <= equal_2249_s2_q ? select_4018 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4021;
      patches_peak_best_column_q <= select_4022;
      patches_peak_row_q <= equal_2249_s2_q ? select_4001 : patches_peak_row_q;
      patches_peak_above_q <= select_4025;
      patches_peak_below_q <= select_4027;
      patches_peak_far_q <= select_4031;
      patches_peak_size_q <= select_4034;
      patches_frame_ended_q <= equal_572_s2_q & equal_2266_s2_q;
      shown_shown_q <= select_4285;
      shown_nearer_q <= select_4287;
      region_row_q <= select_4294;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4298;
      region_down_rest_q <= and_547_s2_q ? select_4313 : region_down_rest_q;
      region_down_back_q <= and_547_s2_q ? select_4318 : region_down_back_q;
      region_down_next_q <= select_4321;
      region_fresh_q <= and_547_s2_q ? select_4325 : region_fresh_q;
      segment_starts_q <= select_4336;
      centres_values_0_textured_q <= equal_572_s2_q ? centres_values_0_textured_q : select_4504;
      centres_values_0_of_skin_q <= select_4509;
      centres_values_1_textured_q <= select_4512;
      centres_values_1_of_skin_q <= select_4515;
      map_row_q <= and_547_s2_q ? select_4521 : map_row_q;
      map_width_q <= select_4524;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_s2_q) : write_half_q;
      read_half_q <= select_2524;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_524 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_530 : averager_running_1_q;
      averager_total_0_q <= select_2650;
      averager_total_1_q <= select_2652;
      census_columns_values_0_cell_0_left_q <= select_2677;
      census_columns_values_0_cell_0_right_q <= select_2678;
      census_columns_values_0_cell_0_mask_q <= and_547_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2680;
      census_columns_values_0_cell_1_right_q <= select_2681;
      census_columns_values_0_cell_1_mask_q <= select_2682;
      census_columns_values_0_cell_2_left_q <= select_2683;
      census_columns_values_0_cell_2_right_q <= select_2684;
      census_columns_values_0_cell_2_mask_q <= select_2685;
      census_columns_values_0_cell_2_of_skin_q <= select_2686;
      census_columns_values_0_cell_3_left_q <= select_2687;
      census_columns_values_0_cell_3_right_q <= select_2688;
      census_columns_values_0_cell_3_mask_q <= select_2689;
      census_columns_values_0_cell_4_left_q <= select_2690;
      census_columns_values_0_cell_4_right_q <= select_2691;
      census_columns_values_0_cell_4_mask_q <= select_2692;
      census_columns_values_1_cell_0_left_q <= select_2693;
      census_columns_values_1_cell_0_right_q <= select_2694;
      census_columns_values_1_cell_0_mask_q <= select_2695;
      census_columns_values_1_cell_1_left_q <= select_2696;
      census_columns_values_1_cell_1_right_q <= select_2697;
      census_columns_values_1_cell_1_mask_q <= select_2698;
      census_columns_values_1_cell_2_left_q <= select_2699;
      census_columns_values_1_cell_2_right_q <= select_2700;
      census_columns_values_1_cell_2_mask_q <= select_2701;
      census_columns_values_1_cell_2_of_skin_q <= select_2702;
      census_columns_values_1_cell_3_left_q <= select_2703;
      census_columns_values_1_cell_3_right_q <= select_2704;
      census_columns_values_1_cell_3_mask_q <= select_2705;
      census_columns_values_1_cell_4_left_q <= select_2706;
      census_columns_values_1_cell_4_right_q <= select_2707;
      census_columns_values_1_cell_4_mask_q <= select_2708;
      census_columns_values_2_cell_0_left_q <= select_2709;
      census_columns_values_2_cell_0_right_q <= select_2710;
      census_columns_values_2_cell_0_mask_q <= select_2711;
      census_columns_values_2_cell_1_left_q <= select_2712;
      census_columns_values_2_cell_1_right_q <= select_2713;
      census_columns_values_2_cell_1_mask_q <= select_2714;
      census_columns_values_2_cell_2_left_q <= select_2715;
      census_columns_values_2_cell_2_right_q <= select_2716;
      census_columns_values_2_cell_2_mask_q <= select_2717;
      census_columns_values_2_cell_3_left_q <= select_2718;
      census_columns_values_2_cell_3_right_q <= select_2719;
      census_columns_values_2_cell_3_mask_q <= select_2720;
      census_columns_values_2_cell_4_left_q <= select_2721;
      census_columns_values_2_cell_4_right_q <= select_2722;
      census_columns_values_2_cell_4_mask_q <= select_2723;
      census_columns_values_3_cell_0_mask_q <= select_2724;
      census_columns_values_3_cell_1_left_q <= select_2725;
      census_columns_values_3_cell_1_right_q <= select_2726;
      census_columns_values_3_cell_1_mask_q <= select_2727;
      census_columns_values_3_cell_2_mask_q <= select_2728;
      census_columns_values_3_cell_3_left_q <= select_2729;
      census_columns_values_3_cell_3_right_q <= select_2730;
      census_columns_values_3_cell_3_mask_q <= select_2731;
      census_columns_values_3_cell_4_mask_q <= select_2732;
      sharpness_last_mean_0_q <= and_547_s2_q ? select_553 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_547_s2_q ? select_557 : sharpness_last_mean_1_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [7:0] sample_pair_pixel_0_s3_q;
  logic [7:0] sample_pair_pixel_1_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic census_columns_values_1_cell_2_of_skin_s3_q;
  logic [6:0] x_s3_q;
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
  logic proven_s3_q;
  logic [2:0] select_508_s3_q;
  logic row_starts_s3_q;
  logic [6:0] select_541_s3_q;
  logic [6:0] last_s3_q;
  logic and_545_s3_q;
  logic and_547_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_550_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_567_s3_q;
  logic equal_572_s3_q;
  logic not_573_s3_q;
  logic so_s3_q;
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
  logic less_669_s3_q;
  logic less_670_s3_q;
  logic less_671_s3_q;
  logic less_672_s3_q;
  logic less_673_s3_q;
  logic less_674_s3_q;
  logic less_675_s3_q;
  logic less_676_s3_q;
  logic less_677_s3_q;
  logic and_685_s3_q;
  logic and_710_s3_q;
  logic and_711_s3_q;
  logic [11:0] sum_726_s3_q;
  logic [9:0] sum_729_s3_q;
  logic and_737_s3_q;
  logic and_741_s3_q;
  logic less_742_s3_q;
  logic less_746_s3_q;
  logic less_748_s3_q;
  logic equal_2084_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2090_s3_q;
  logic equal_2092_s3_q;
  logic equal_2094_s3_q;
  logic equal_2096_s3_q;
  logic equal_2098_s3_q;
  logic equal_2100_s3_q;
  logic equal_2102_s3_q;
  logic equal_2104_s3_q;
  logic equal_2106_s3_q;
  logic less_2115_s3_q;
  logic or_2119_s3_q;
  logic equal_2139_s3_q;
  logic and_2149_s3_q;
  logic select_2166_s3_q;
  logic equal_2167_s3_q;
  logic and_2175_s3_q;
  logic equal_2177_s3_q;
  logic select_2224_s3_q;
  logic and_2248_s3_q;
  logic equal_2249_s3_q;
  logic equal_2251_s3_q;
  logic not_2256_s3_q;
  logic and_2264_s3_q;
  logic less_2269_s3_q;
  logic [4:0] select_2284_s3_q;
  logic select_2290_s3_q;
  logic [3:0] select_2330_s3_q;
  logic or_2451_s3_q;
  logic or_2454_s3_q;
  logic or_2457_s3_q;
  logic not_2459_s3_q;
  logic and_2474_s3_q;
  logic and_2480_s3_q;
  logic and_2491_s3_q;
  logic and_2496_s3_q;
  logic and_2532_s3_q;
  logic less_2533_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2540_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2558_s3_q;
  logic or_2561_s3_q;
  logic or_2564_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2616_s3_q;
  logic [11:0] sum_2748_s3_q;
  logic [9:0] sum_2751_s3_q;
  logic equal_2759_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2876_s3_q;
  logic and_3062_s3_q;
  logic and_3069_s3_q;
  logic not_3090_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3134_s3_q;
  logic and_3169_s3_q;
  logic and_3229_s3_q;
  logic and_3230_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3266_s3_q;
  logic and_3280_s3_q;
  logic equal_3322_s3_q;
  logic parity_3699_s3_q;
  logic parity_3828_s3_q;
  logic parity_3890_s3_q;
  logic xor_3918_s3_q;
  logic parity_3930_s3_q;
  logic or_3934_s3_q;
  logic equal_3935_s3_q;
  logic and_4035_s3_q;
  logic less_4060_s3_q;
  logic equal_4360_s3_q;
  logic and_4532_s3_q;
  logic and_4547_s3_q;
  logic and_4549_s3_q;
  logic equal_4620_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= line_ended_q;
      sample_pair_pixel_0_s3_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s3_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      census_columns_values_1_cell_2_of_skin_s3_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s3_q <= x_s2_q[6:0];
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
      proven_s3_q <= proven_s2_q;
      select_508_s3_q <= select_508_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_541_s3_q <= select_541_s2_q;
      last_s3_q <= last_s2_2_q;
      and_545_s3_q <= and_545_s2_q;
      and_547_s3_q <= and_547_s2_q;
      grey_s3_q <= grey;
      equal_550_s3_q <= equal_550;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_567_s3_q <= equal_567_s2_q;
      equal_572_s3_q <= equal_572_s2_q;
      not_573_s3_q <= not_573_s2_q;
      so_s3_q <= drew_q;
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
      less_669_s3_q <= less_669;
      less_670_s3_q <= less_670;
      less_671_s3_q <= less_671;
      less_672_s3_q <= less_672;
      less_673_s3_q <= less_673;
      less_674_s3_q <= less_674;
      less_675_s3_q <= less_675;
      less_676_s3_q <= less_676;
      less_677_s3_q <= less_677;
      and_685_s3_q <= and_685;
      and_710_s3_q <= whole_22 & and_685;
      and_711_s3_q <= census_columns_values_1_cell_2_mask_q & and_685;
      sum_726_s3_q <= {1'b0, sum_722} + {2'h0, sum_725};
      sum_729_s3_q <= {9'h0, difference_727[9]} + {1'b0, xor_728};
      and_737_s3_q <= and_737;
      and_741_s3_q <= and_741;
      less_742_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_746_s3_q <= {{5{sum_745[6]}}, sum_745, half_grey_levels_2[3:0]} < 16'hffe1;
      less_748_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2084_s3_q <= equal_2084;
      all_s3_q <= all;
      sum_2090_s3_q <= sum_2090;
      equal_2092_s3_q <= equal_2092;
      equal_2094_s3_q <= equal_2094;
      equal_2096_s3_q <= equal_2096;
      equal_2098_s3_q <= equal_2098;
      equal_2100_s3_q <= equal_2100;
      equal_2102_s3_q <= equal_2102;
      equal_2104_s3_q <= equal_2104;
      equal_2106_s3_q <= equal_2106;
      less_2115_s3_q <= less_2115;
      or_2119_s3_q <= or_2119;
      equal_2139_s3_q <= (registration_fresh_q & select_2137) == 4'h0;
      and_2149_s3_q <= not_573_s2_q & and_2133;
      select_2166_s3_q <= select_2166[1];
      equal_2167_s3_q <= equal_2167;
      and_2175_s3_q <= and_2175;
      equal_2177_s3_q <= equal_2177;
      select_2224_s3_q <= select_2224;
      and_2248_s3_q <= and_2248;
      equal_2249_s3_q <= equal_2249_s2_q;
      equal_2251_s3_q <= equal_2251_s2_q;
      not_2256_s3_q <= not_2256_s2_q;
      and_2264_s3_q <= and_2248 & equal_2263;
      less_2269_s3_q <= select_2262 < patches_bands_chosen_q;
      select_2284_s3_q <= select_2284_s2_q;
      select_2290_s3_q <= select_2290_s2_q;
      select_2330_s3_q <= select_2330_s2_q;
      or_2451_s3_q <= or_2451;
      or_2454_s3_q <= or_2454;
      or_2457_s3_q <= or_2457;
      not_2459_s3_q <= not_2459;
      and_2474_s3_q <= inside_v_s2_q & (and_2471 & not_2472_s2_q);
      and_2480_s3_q <= inside_v_s2_q & (and_633 & not_2472_s2_q);
      and_2491_s3_q <= inside_v_s2_q & (not_2472_s2_q & (and_2488 & and_2062));
      and_2496_s3_q <= not_573_s2_q & and_2467;
      and_2532_s3_q <= and_2532;
      less_2533_s3_q <= less_2533;
      index_2_s3_q <= index_2[5:0];
      sum_2540_s3_q <= sum_2540;
      textured_2_s3_q <= textured_2;
      or_2558_s3_q <= or_2558;
      or_2561_s3_q <= select_2555[7] | (~({select_2555[6], select_2555[3:2]} == 3'h0));
      or_2564_s3_q <= select_2555[7] | (~(select_2555[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2616_s3_q <= and_2616;
      sum_2748_s3_q <= {1'b0, sum_2744} + {2'h0, sum_2747};
      sum_2751_s3_q <= {9'h0, difference_2749[9]} + {1'b0, xor_2750};
      equal_2759_s3_q <= equal_2759_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2876_s3_q <= x_s2_q[7:3] == 5'h0;
      and_3062_s3_q <= and_3062;
      and_3069_s3_q <= not_573_s2_q & (drew_q & and_3067);
      not_3090_s3_q <= ~((draws_late_q & not_2472_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_3134_s3_q <= not_573_s2_q & (drew_q & and_3132);
      and_3169_s3_q <= not_573_s2_q & (drew_q & and_3167);
      and_3229_s3_q <= not_573_s2_q & (drew_q & (half_ends & equal_3226));
      and_3230_s3_q <= and_3230;
      residual_s3_q <= residual[7:0];
      and_3266_s3_q <= and_3266;
      and_3280_s3_q <= and_3230 & less_3279;
      equal_3322_s3_q <= (registration_fresh_q & select_3320) == 4'h0;
      parity_3699_s3_q <= ^{xor_3695, xor_3658, select_3625[44:36], other[44:36]};
      parity_3828_s3_q <= parity_3828;
      parity_3890_s3_q <= parity_3890;
      xor_3918_s3_q <= parity_3905 ^ parity_3917;
      parity_3930_s3_q <= ^{or_3927, or_3923, and_3919};
      or_3934_s3_q <= (or_3923 & or_3927) | (and_3919 & (or_3923 | or_3927));
      equal_3935_s3_q <= equal_3935_s2_q;
      and_4035_s3_q <= equal_2249_s2_q & equal_4032_s2_q;
      less_4060_s3_q <= select_4025 < select_4027;
      equal_4360_s3_q <= equal_4360_s2_q;
      and_4532_s3_q <= said_q;
      and_4547_s3_q <= and_2616 & ({sum_2540, index_2[5:0]} == {sum_2525, index[5:0]});
      and_4549_s3_q <= less_3043 & proven_q;
      equal_4620_s3_q <= (registration_fresh_q & select_4618) == 4'h0;
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
  logic [8:0] hidden_for_q;
  logic [1:0] hidden_more_q;
  logic hidden_ends_q;
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
  assign texture = sum_726_s3_q + {2'h0, sum_729_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_731;
  assign sum_731 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_733;
  assign sum_733 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_731});
  // hls/stages/census.hpp:317
  logic less_734;
  assign less_734 = 9'h4 < sum_733[13:5];
  logic and_735;
  assign and_735 = and_685_s3_q & less_734;
  // hls/stages/moments.hpp:33
  logic and_747;
  assign and_747 = (and_710_s3_q & and_737_s3_q) & less_746_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2141;
  assign equal_2141 = sum_2090_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2090_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2143;
  assign select_2143 = equal_2141 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2144;
  assign sum_2144 = (equal_2139_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2143[13]}}, select_2143};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2090_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2147;
  assign select_2147 = equal_2141 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2148;
  assign sum_2148 = (equal_2139_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2147[6]}}, select_2147};
  // hls/stages/patches.hpp:360
  logic [22:0] select_2265;
  assign select_2265 = and_2264_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2224_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:126
  logic is_chosen;
  assign is_chosen = select_2265[0] & less_2269_s3_q;
  // hls/stages/patches.hpp:127
  logic select_2272;
  assign select_2272 = equal_2167_s3_q ? patches_place_0_valid_q : (select_2166_s3_q ? patches_place_0_valid_q : is_chosen);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2273;
  assign sum_2273 = {1'b0, select_541_s3_q, select_508_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:362
  logic [21:0] select_2274;
  assign select_2274 = select_2166_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2265[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2275;
  assign select_2275 = equal_2167_s3_q ? patches_place_0_column_q : select_2274[7:0];
  logic [5:0] select_2276;
  assign select_2276 = equal_2167_s3_q ? patches_place_0_shift_q : select_2274[13:8];
  // hls/stages/patches.hpp:330
  logic [8:0] sum_2277;
  assign sum_2277 = {1'b0, select_2275} + {{3{select_2276[5]}}, select_2276};
  // hls/stages/patches.hpp:132
  logic equal_2278;
  assign equal_2278 = {sum_2277, sum_2273[0], select_508_s3_q[1:0]} == {1'b0, sum_2273[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2280;
  assign or_2280 = row_starts_s3_q | (select_2272 & equal_2278);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_2281;
  assign select_2281 = or_2280 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2291;
  assign select_2291 = or_2280 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2293;
  assign and_2293 = select_2290_s3_q & (~select_2291[5]);
  // hls/stages/patches.hpp:127
  logic select_2301;
  assign select_2301 = equal_2167_s3_q ? patches_place_1_valid_q : (select_2166_s3_q ? is_chosen : patches_place_1_valid_q);
  // hls/stages/patches.hpp:362
  logic [21:0] select_2302;
  assign select_2302 = select_2166_s3_q ? select_2265[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2303;
  assign select_2303 = equal_2167_s3_q ? patches_place_1_column_q : select_2302[7:0];
  logic [5:0] select_2304;
  assign select_2304 = equal_2167_s3_q ? patches_place_1_shift_q : select_2302[13:8];
  // hls/stages/patches.hpp:330
  logic [8:0] sum_2305;
  assign sum_2305 = {1'b0, select_2303} + {{3{select_2304[5]}}, select_2304};
  // hls/stages/patches.hpp:132
  logic equal_2306;
  assign equal_2306 = {sum_2305[8], sum_2273, select_508_s3_q[1:0]} == {1'b0, sum_2305[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2308;
  assign or_2308 = row_starts_s3_q | (select_2301 & equal_2306);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_2309;
  assign select_2309 = or_2308 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2310;
  assign select_2310 = or_2308 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2312;
  assign and_2312 = select_2290_s3_q & (~select_2310[5]);
  // hls/stages/patches.hpp:326
  logic [7:0] sum_2319;
  assign sum_2319 = select_2275 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2320;
  assign equal_2320 = {sum_2319[7], select_541_s3_q, select_508_s3_q} == {1'b0, sum_2319[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2322;
  assign or_2322 = row_starts_s3_q | (select_2272 & equal_2320);
  logic [4:0] select_2323;
  assign select_2323 = or_2322 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:326
  logic [7:0] sum_2324;
  assign sum_2324 = select_2303 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2325;
  assign equal_2325 = {sum_2324[7], select_541_s3_q, select_508_s3_q} == {1'b0, sum_2324[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2328;
  assign select_2328 = (row_starts_s3_q | (select_2301 & equal_2325)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2323[4] ? select_2328[3:0] : select_2323[3:0];
  // hls/stages/agreement.hpp:277
  logic select_2331;
  assign select_2331 = or_2322 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2337;
  assign and_2337 = (select_2290_s3_q & (select_2284_s3_q[3] ^ select_2284_s3_q[4])) & ((~select_2323[4]) | (~select_2328[4]));
  // hls/stages/patches.hpp:186
  logic less_2441;
  assign less_2441 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_2442;
  assign not_2442 = ~less_2441;
  logic [1:0] select_2443;
  assign select_2443 = patches_summed_first_s3_q ? 2'h2 : {less_2441, not_2442};
  logic [12:0] select_2445;
  assign select_2445 = select_2443[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2446;
  assign select_2446 = select_2443[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2447;
  assign select_2447 = (select_2443 == 2'h2) ? {select_2445[12:8], patches_sums_values_0_q[9:8], select_2445[7:0]} : select_2446;
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2475;
  assign select_2475 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2476;
  assign sum_2476 = {6'h0, and_2474_s3_q} + select_2475;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2478;
  assign sum_2478 = {3'h0, sum_2476} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2481;
  assign select_2481 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2482;
  assign sum_2482 = {6'h0, and_2480_s3_q} + select_2481;
  // hls/stages/agreement.hpp:1078
  logic [9:0] sum_2484;
  assign sum_2484 = {3'h0, sum_2482} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2492;
  assign select_2492 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:913
  logic [6:0] sum_2493;
  assign sum_2493 = {6'h0, and_2491_s3_q} + select_2492;
  // hls/stages/agreement.hpp:1079
  logic [9:0] sum_2495;
  assign sum_2495 = {3'h0, sum_2493} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2549;
  assign select_2549 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2550;
  assign difference_2550 = {1'b0, textured_2_s3_q} - {1'b0, select_2549};
  logic [4:0] t;
  assign t = {difference_2550[3], difference_2550} + (equal_567_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1116
  logic equal_2553;
  assign equal_2553 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1117
  logic not_2565;
  assign not_2565 = ~region_row_s3_q[2];
  logic [2:0] select_2566;
  assign select_2566 = region_row_s3_q[1] ? {1'b0, not_2565, 1'b0} : {region_row_s3_q[2], 1'b0, not_2565};
  logic [5:0] select_2567;
  assign select_2567 = region_row_s3_q[0] ? {select_2566[2], 1'b0, select_2566[1], 1'b0, select_2566[0], 1'b0} : {1'b0, select_2566[2], 1'b0, select_2566[1], 1'b0, select_2566[0]};
  logic [11:0] select_2568;
  assign select_2568 = or_2564_s3_q ? {select_2567[5], 1'b0, select_2567[4], 1'b0, select_2567[3], 1'b0, select_2567[2], 1'b0, select_2567[1], 1'b0, select_2567[0], 1'b0} : {1'b0, select_2567[5], 1'b0, select_2567[4], 1'b0, select_2567[3], 1'b0, select_2567[2], 1'b0, select_2567[1], 1'b0, select_2567[0]};
  logic [23:0] select_2569;
  assign select_2569 = or_2561_s3_q ? {select_2568[11], 1'b0, select_2568[10], 1'b0, select_2568[9], 1'b0, select_2568[8], 1'b0, select_2568[7], 1'b0, select_2568[6], 1'b0, select_2568[5], 1'b0, select_2568[4], 1'b0, select_2568[3], 1'b0, select_2568[2], 1'b0, select_2568[1], 1'b0, select_2568[0], 1'b0} : {1'b0, select_2568[11], 1'b0, select_2568[10], 1'b0, select_2568[9], 1'b0, select_2568[8], 1'b0, select_2568[7], 1'b0, select_2568[6], 1'b0, select_2568[5], 1'b0, select_2568[4], 1'b0, select_2568[3], 1'b0, select_2568[2], 1'b0, select_2568[1], 1'b0, select_2568[0]};
  logic [47:0] select_2570;
  assign select_2570 = or_2558_s3_q ? {select_2569[23], 1'b0, select_2569[22], 1'b0, select_2569[21], 1'b0, select_2569[20], 1'b0, select_2569[19], 1'b0, select_2569[18], 1'b0, select_2569[17], 1'b0, select_2569[16], 1'b0, select_2569[15], 1'b0, select_2569[14], 1'b0, select_2569[13], 1'b0, select_2569[12], 1'b0, select_2569[11], 1'b0, select_2569[10], 1'b0, select_2569[9], 1'b0, select_2569[8], 1'b0, select_2569[7], 1'b0, select_2569[6], 1'b0, select_2569[5], 1'b0, select_2569[4], 1'b0, select_2569[3], 1'b0, select_2569[2], 1'b0, select_2569[1], 1'b0, select_2569[0], 1'b0} : {1'b0, select_2569[23], 1'b0, select_2569[22], 1'b0, select_2569[21], 1'b0, select_2569[20], 1'b0, select_2569[19], 1'b0, select_2569[18], 1'b0, select_2569[17], 1'b0, select_2569[16], 1'b0, select_2569[15], 1'b0, select_2569[14], 1'b0, select_2569[13], 1'b0, select_2569[12], 1'b0, select_2569[11], 1'b0, select_2569[10], 1'b0, select_2569[9], 1'b0, select_2569[8], 1'b0, select_2569[7], 1'b0, select_2569[6], 1'b0, select_2569[5], 1'b0, select_2569[4], 1'b0, select_2569[3], 1'b0, select_2569[2], 1'b0, select_2569[1], 1'b0, select_2569[0]};
  // hls/stages/agreement.hpp:1045
  logic and_2574;
  assign and_2574 = good_known_q & (~((good_q & select_2570) == 48'h0));
  // hls/stages/agreement.hpp:1112
  logic [2:0] select_2583;
  assign select_2583 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2584;
  assign difference_2584 = {1'b0, shown_2_s3_q} - {1'b0, select_2583};
  logic [4:0] around;
  assign around = {difference_2584[3], difference_2584} + (equal_567_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1119
  logic [5:0] sum_2587;
  assign sum_2587 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2553 ? and_2574 : (~({sum_2587, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1113
  logic [2:0] select_2599;
  assign select_2599 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2600;
  assign difference_2600 = {1'b0, near_2_s3_q} - {1'b0, select_2599};
  logic [4:0] n;
  assign n = {difference_2600[3], difference_2600} + (equal_567_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1129
  logic and_2604;
  assign and_2604 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2642;
  assign select_2642 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2644;
  assign select_2644 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2646;
  assign select_2646 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2648;
  assign select_2648 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2653;
  assign sum_2653 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2654;
  assign difference_2654 = {1'b0, sum_2653[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2655;
  assign xor_2655 = {difference_2654[8:0], sum_2653[0]} ^ {10{difference_2654[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2654[9]} + {1'b0, xor_2655};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_550_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2660;
  assign select_2660 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2661;
  assign sum_2661 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2662;
  assign difference_2662 = {1'b0, sum_2661[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2663;
  assign xor_2663 = {difference_2662[8:0], sum_2661[0]} ^ {10{difference_2662[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2662[9]} + {1'b0, xor_2663};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_550_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2668;
  assign select_2668 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2752;
  assign sum_2752 = sum_2748_s3_q + {2'h0, sum_2751_s3_q};
  // hls/stages/agreement.hpp:531
  logic [11:0] select_2754;
  assign select_2754 = and_547_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2755;
  assign select_2755 = and_547_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2756;
  assign select_2756 = and_547_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2757;
  assign select_2757 = and_547_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2760;
  assign sum_2760 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2752};
  logic [13:0] sum_2762;
  assign sum_2762 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2760});
  // hls/stages/census.hpp:323
  logic and_2764;
  assign and_2764 = and_710_s3_q & (9'h4 < sum_2762[13:5]);
  // hls/stages/census.hpp:324
  logic and_2765;
  assign and_2765 = and_710_s3_q & less_734;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2766;
  assign sum_2766 = census_left_misses_q + {{17{and_2765}}, and_2764, 1'b0, and_2764};
  // hls/stages/agreement.hpp:531
  logic [19:0] select_2768;
  assign select_2768 = and_547_s3_q ? (equal_2759_s3_q ? 20'h0 : sum_2766) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2837;
  assign select_2837 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:531
  logic select_2840;
  assign select_2840 = and_547_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2843;
  assign and_2843 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2849;
  assign and_2849 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2850;
  assign and_2850 = and_2843 & and_2849;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2837[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2852;
  assign select_2852 = and_2850 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2854;
  assign select_2854 = equal_2759_s3_q ? {11'h0, select_2852} : (sharpness_sums_detail_0_q + {11'h0, select_2852});
  // hls/stages/agreement.hpp:462
  logic and_2861;
  assign and_2861 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2862;
  assign and_2862 = and_2843 & and_2861;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2837[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2864;
  assign select_2864 = and_2862 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2866;
  assign select_2866 = equal_2759_s3_q ? {11'h0, select_2864} : (sharpness_sums_detail_1_q + {11'h0, select_2864});
  logic [8:0] select_2869;
  assign select_2869 = and_2850 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2870;
  assign sum_2870 = (equal_2759_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2869};
  logic [8:0] select_2873;
  assign select_2873 = and_2862 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2874;
  assign sum_2874 = (equal_2759_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2873};
  // hls/stages/census.hpp:388
  logic less_2877;
  assign less_2877 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2878;
  assign less_2878 = x_s3_q[4:0] < 5'h3;
  logic not_2879;
  assign not_2879 = ~x_s3_q[1];
  logic [2:0] select_2880;
  assign select_2880 = x_s3_q[0] ? {1'b0, not_2879, 1'b0} : {x_s3_q[1], 1'b0, not_2879};
  logic [5:0] select_2881;
  assign select_2881 = slot_s3_q[2] ? {select_2880[2], 1'b0, select_2880[1], 1'b0, select_2880[0], 1'b0} : {1'b0, select_2880[2], 1'b0, select_2880[1], 1'b0, select_2880[0]};
  logic [11:0] select_2882;
  assign select_2882 = slot_s3_q[1] ? {select_2881[5], 1'b0, select_2881[4], 1'b0, select_2881[3], 1'b0, select_2881[2], 1'b0, select_2881[1], 1'b0, select_2881[0], 1'b0} : {1'b0, select_2881[5], 1'b0, select_2881[4], 1'b0, select_2881[3], 1'b0, select_2881[2], 1'b0, select_2881[1], 1'b0, select_2881[0]};
  logic [23:0] select_2883;
  assign select_2883 = slot_s3_q[0] ? {select_2882[11], 1'b0, select_2882[10], 1'b0, select_2882[9], 1'b0, select_2882[8], 1'b0, select_2882[7], 1'b0, select_2882[6], 1'b0, select_2882[5], 1'b0, select_2882[4], 1'b0, select_2882[3], 1'b0, select_2882[2], 1'b0, select_2882[1], 1'b0, select_2882[0], 1'b0} : {1'b0, select_2882[11], 1'b0, select_2882[10], 1'b0, select_2882[9], 1'b0, select_2882[8], 1'b0, select_2882[7], 1'b0, select_2882[6], 1'b0, select_2882[5], 1'b0, select_2882[4], 1'b0, select_2882[3], 1'b0, select_2882[2], 1'b0, select_2882[1], 1'b0, select_2882[0]};
  // hls/stages/census.hpp:390
  logic and_2887;
  assign and_2887 = less_2878 & (~((sharpness_sums_contrast_1_q & select_2883) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2889;
  assign select_2889 = (less_2877 & and_2887) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2889};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2892;
  assign select_2892 = equal_2876_s3_q ? (less_2877 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2897;
  assign and_2897 = less_2878 & (~((sharpness_sums_contrast_0_q & select_2883) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2899;
  assign select_2899 = (less_2877 & and_2897) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2899};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2902;
  assign select_2902 = equal_2876_s3_q ? (less_2877 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2904;
  assign select_2904 = equal_2876_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2906;
  assign select_2906 = equal_2876_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2908;
  assign select_2908 = equal_2876_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2897} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2910;
  assign select_2910 = equal_2876_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2887} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2915;
  assign select_2915 = so_s3_q ? (equal_2876_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2918;
  assign select_2918 = equal_2876_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2920;
  assign equal_2920 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2921;
  assign xor_2921 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2924;
  assign select_2924 = (equal_2920 | xor_2921) ? (five_times[0] & xor_2921) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2925;
  assign select_2925 = equal_2876_s3_q ? select_2924 : sharpness_comparing_less_detail_0_q;
  logic select_2926;
  assign select_2926 = so_s3_q ? select_2925 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2927;
  assign xor_2927 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2930;
  assign select_2930 = (equal_2920 | xor_2927) ? (five_times_2[0] & xor_2927) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2931;
  assign select_2931 = equal_2876_s3_q ? select_2930 : sharpness_comparing_less_detail_1_q;
  logic select_2932;
  assign select_2932 = so_s3_q ? select_2931 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2933;
  assign xor_2933 = sharpness_comparing_contrast_0_q[1] ^ and_2887;
  logic select_2936;
  assign select_2936 = (equal_2920 | xor_2933) ? (and_2887 & xor_2933) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2937;
  assign select_2937 = equal_2876_s3_q ? select_2936 : sharpness_comparing_less_contrast_0_q;
  logic select_2938;
  assign select_2938 = so_s3_q ? select_2937 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2939;
  assign xor_2939 = sharpness_comparing_contrast_1_q[1] ^ and_2897;
  logic select_2942;
  assign select_2942 = (equal_2920 | xor_2939) ? (and_2897 & xor_2939) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2943;
  assign select_2943 = equal_2876_s3_q ? select_2942 : sharpness_comparing_less_contrast_1_q;
  logic select_2944;
  assign select_2944 = so_s3_q ? select_2943 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_3071;
  assign select_3071 = and_3062_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3069_s3_q});
  // hls/stages/agreement.hpp:799
  logic and_3074;
  assign and_3074 = not_573_s3_q & (so_s3_q & (ends_cell_s3_q & and_2474_s3_q));
  logic and_3079;
  assign and_3079 = not_573_s3_q & (so_s3_q & (ends_cell_s3_q & and_2480_s3_q));
  logic and_3084;
  assign and_3084 = not_573_s3_q & (so_s3_q & (ends_cell_s3_q & and_2491_s3_q));
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_3099;
  assign select_3099 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3100;
  assign difference_3100 = {1'b0, explained_2_s3_q} - {1'b0, select_3099};
  logic [4:0] e;
  assign e = {difference_3100[3], difference_3100} + (equal_567_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1118
  logic [5:0] sum_3103;
  assign sum_3103 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1123
  logic not_3107;
  assign not_3107 = ~(equal_2553 ? and_2574 : (~({sum_3103, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:799
  logic and_3110;
  assign and_3110 = ends_cell_s3_q & (not_3090_s3_q & (centres_values_1_textured_s3_q & not_3107));
  logic and_3112;
  assign and_3112 = not_573_s3_q & (so_s3_q & and_3110);
  // hls/stages/agreement.hpp:1149
  logic less_3115;
  assign less_3115 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3116;
  assign select_3116 = less_3115 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3119;
  assign select_3119 = less_3115 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_3120;
  assign sum_3120 = {1'b0, select_3119} + {3'h0, select_3119[9:2]};
  logic and_3122;
  assign and_3122 = (~(select_3116[9:4] == 6'h0)) & ({sum_3120, select_3119[1:0]} < {3'h0, select_3116});
  // hls/stages/agreement.hpp:1159
  logic [9:0] select_3125;
  assign select_3125 = x_s3_q[6] ? (equal_2084_s3_q ? 10'h0 : (and_3122 ? select_3116 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:799
  logic [9:0] select_3126;
  assign select_3126 = equal_572_s3_q ? select_3125 : 10'h0;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_3128;
  assign select_3128 = and_3062_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3126});
  logic [13:0] select_3136;
  assign select_3136 = and_3062_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3134_s3_q});
  // hls/stages/agreement.hpp:1127
  logic and_3138;
  assign and_3138 = not_3090_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:799
  logic and_3141;
  assign and_3141 = not_573_s3_q & (so_s3_q & (ends_cell_s3_q & and_3138));
  // hls/stages/agreement.hpp:937
  logic [13:0] select_3143;
  assign select_3143 = and_3062_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3141});
  // hls/stages/agreement.hpp:1127
  logic and_3145;
  assign and_3145 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3107);
  // hls/stages/agreement.hpp:799
  logic and_3149;
  assign and_3149 = not_573_s3_q & (so_s3_q & (ends_cell_s3_q & (not_3090_s3_q & and_3145)));
  // hls/stages/agreement.hpp:937
  logic [13:0] select_3151;
  assign select_3151 = and_3062_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3149});
  logic [13:0] select_3171;
  assign select_3171 = and_3062_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3169_s3_q});
  // hls/stages/agreement.hpp:799
  logic [7:0] select_3248;
  assign select_3248 = so_s3_q ? (equal_2177_s3_q ? (and_3230_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3249;
  assign select_3249 = equal_572_s3_q ? 8'h0 : select_3248;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3251;
  assign select_3251 = and_3229_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3249[7]}}, select_3249});
  // hls/stages/agreement.hpp:799
  logic and_3254;
  assign and_3254 = not_573_s3_q & (so_s3_q & (and_3230_s3_q & equal_2177_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3256;
  assign select_3256 = and_3229_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3254});
  // hls/stages/registration.hpp:107
  logic and_3258;
  assign and_3258 = and_3230_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:799
  logic [1:0] select_3260;
  assign select_3260 = so_s3_q ? (equal_2177_s3_q ? {and_3258, and_3230_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3261;
  assign select_3261 = equal_572_s3_q ? 2'h0 : select_3260;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3262;
  assign sum_3262 = registration_half_votes_down_q + {{5{select_3261[1]}}, select_3261};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_3268;
  assign select_3268 = so_s3_q ? (equal_2177_s3_q ? {and_3266_s3_q, and_3230_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3269;
  assign select_3269 = equal_572_s3_q ? 2'h0 : select_3268;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3270;
  assign sum_3270 = registration_half_votes_up_q + {{5{select_3269[1]}}, select_3269};
  // hls/stages/registration.hpp:107
  logic and_3273;
  assign and_3273 = and_3230_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:799
  logic [1:0] select_3275;
  assign select_3275 = so_s3_q ? (equal_2177_s3_q ? {and_3273, and_3230_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3276;
  assign select_3276 = equal_572_s3_q ? 2'h0 : select_3275;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3277;
  assign sum_3277 = registration_half_half_votes_down_q + {{5{select_3276[1]}}, select_3276};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_3282;
  assign select_3282 = so_s3_q ? (equal_2177_s3_q ? {and_3280_s3_q, and_3230_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3283;
  assign select_3283 = equal_572_s3_q ? 2'h0 : select_3282;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3284;
  assign sum_3284 = registration_half_half_votes_up_q + {{5{select_3283[1]}}, select_3283};
  // hls/stages/agreement.hpp:799
  logic and_3317;
  assign and_3317 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & less_2115_s3_q));
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_3324;
  assign select_3324 = or_2119_s3_q ? 12'h0 : (equal_3322_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_3327;
  assign select_3327 = x_s3_q[6] ? (equal_2084_s3_q ? 12'h0 : (less_2115_s3_q ? select_3324 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:799
  logic [11:0] select_3328;
  assign select_3328 = equal_572_s3_q ? select_3327 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3329;
  assign and_3329 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1159
  logic and_3332;
  assign and_3332 = not_2459_s3_q & (less_2115_s3_q & ({and_3329, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:799
  logic and_3334;
  assign and_3334 = equal_572_s3_q & (x_s3_q[6] & and_3332);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3336;
  assign sum_3336 = {{2{select_3328[11]}}, select_3328} + (and_3334 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_3339;
  assign select_3339 = or_2119_s3_q ? 12'h0 : (equal_3322_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_3342;
  assign select_3342 = x_s3_q[6] ? (equal_2084_s3_q ? 12'h0 : (less_2115_s3_q ? select_3339 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:799
  logic [11:0] select_3343;
  assign select_3343 = equal_572_s3_q ? select_3342 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3345;
  assign sum_3345 = {{2{select_3343[11]}}, select_3343} + (and_3334 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3347;
  assign not_3347 = ~all_s3_q;
  // hls/stages/agreement.hpp:1159
  logic and_3350;
  assign and_3350 = not_2459_s3_q & (less_2115_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3347, 1'b0}));
  // hls/stages/agreement.hpp:799
  logic and_3356;
  assign and_3356 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & (less_2115_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3357;
  assign not_3357 = ~and_3356;
  logic less_3358;
  assign less_3358 = $signed({9'h1, {2{not_3357}}, and_3356}) < $signed(registration_up_q[13:2]);
  logic select_3359;
  assign select_3359 = (equal_572_s3_q & (x_s3_q[6] & and_3350)) ? less_3358 : registration_enough_q;
  // hls/stages/agreement.hpp:1159
  logic and_3363;
  assign and_3363 = x_s3_q[6] & (not_2459_s3_q & (less_2115_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:799
  logic and_3364;
  assign and_3364 = equal_572_s3_q & and_3363;
  // hls/stages/registration.hpp:242
  logic less_3365;
  assign less_3365 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3367;
  assign less_3367 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3369;
  assign equal_3369 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:799
  logic and_3373;
  assign and_3373 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & (less_2115_s3_q & equal_3369)));
  // hls/stages/agreement.hpp:1159
  logic and_3380;
  assign and_3380 = x_s3_q[6] & (not_2459_s3_q & (less_2115_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3383;
  assign equal_3383 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1159
  logic and_3386;
  assign and_3386 = not_2459_s3_q & (less_2115_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3383));
  // hls/stages/registration.hpp:244
  logic and_3390;
  assign and_3390 = (equal_572_s3_q & (x_s3_q[6] & and_3386)) & (less_3367 | less_3365);
  // hls/stages/agreement.hpp:1159
  logic and_3395;
  assign and_3395 = not_2459_s3_q & (less_2115_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3383)));
  // hls/stages/registration.hpp:244
  logic and_3398;
  assign and_3398 = registration_votes_up_q & registration_other_down_q;
  logic select_3400;
  assign select_3400 = registration_votes_down_q ? (registration_other_up_q | and_3398) : and_3398;
  // hls/stages/registration.hpp:138
  logic and_3402;
  assign and_3402 = (equal_572_s3_q & (x_s3_q[6] & and_3395)) & (registration_other_enough_q & select_3400);
  // hls/stages/registration.hpp:245
  logic or_3405;
  assign or_3405 = registration_moved_q | (registration_enough_q & (and_3390 | and_3402));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3488;
  assign select_3488 = sample_pair_whole_s3_q ? (equal_2167_s3_q ? patches_place_0_slope_q : select_2274[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3493;
  assign select_3493 = sample_pair_whole_s3_q ? (equal_2167_s3_q ? patches_place_1_slope_q : select_2302[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3495;
  assign select_3495 = equal_2167_s3_q ? patches_valid_0_q : (select_2166_s3_q ? patches_valid_0_q : is_chosen);
  // hls/stages/agreement.hpp:277
  logic select_3498;
  assign select_3498 = sample_pair_whole_s3_q ? (and_2293 ? (sample_present_s3_q & select_3495) : select_3495) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3500;
  assign select_3500 = equal_2167_s3_q ? patches_valid_1_q : (select_2166_s3_q ? is_chosen : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3503;
  assign select_3503 = sample_pair_whole_s3_q ? (and_2312 ? (sample_present_s3_q & select_3500) : select_3500) : patches_valid_1_q;
  logic [5:0] select_3506;
  assign select_3506 = sample_pair_whole_s3_q ? (select_2291[5] ? {1'b1, select_2291[4:0]} : (select_2291 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3509;
  assign select_3509 = sample_pair_whole_s3_q ? (select_2310[5] ? {1'b1, select_2310[4:0]} : (select_2310 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3512;
  assign select_3512 = sample_pair_whole_s3_q ? (select_2323[4] ? {1'b1, select_2323[3:0]} : (select_2323 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3515;
  assign select_3515 = sample_pair_whole_s3_q ? (select_2328[4] ? {1'b1, select_2328[3:0]} : (select_2328 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:534
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3934_s3_q, parity_3930_s3_q, xor_3918_s3_q, parity_3890_s3_q, parity_3828_s3_q, parity_3699_s3_q} + (equal_3935_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3939;
  assign select_3939 = equal_2249_s3_q ? patches_sums_values_0_q : (equal_2251_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3940;
  assign select_3940 = equal_2251_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3942;
  assign select_3942 = equal_2251_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3944;
  assign select_3944 = equal_2251_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3946;
  assign select_3946 = equal_2251_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3948;
  assign select_3948 = equal_2251_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3950;
  assign select_3950 = equal_2251_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3952;
  assign select_3952 = equal_2251_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3954;
  assign select_3954 = equal_2251_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3956;
  assign select_3956 = equal_2251_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3958;
  assign select_3958 = equal_2251_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3960;
  assign select_3960 = equal_2251_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3962;
  assign select_3962 = equal_2251_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3964;
  assign select_3964 = equal_2251_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3966;
  assign select_3966 = equal_2251_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3968;
  assign select_3968 = equal_2251_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3970;
  assign select_3970 = equal_2251_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:606
  logic [9:0] difference_4041;
  assign difference_4041 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_4044;
  assign and_4044 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_4041, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:605
  logic not_4047;
  assign not_4047 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:613
  logic and_4050;
  assign and_4050 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_4044 & ((10'h38 < patches_peak_size_q) & not_4047));
  // hls/stages/patches.hpp:190
  logic and_4052;
  assign and_4052 = and_4035_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_4050);
  // hls/stages/patches.hpp:672
  logic not_4053;
  assign not_4053 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_4055;
  assign and_4055 = and_4052 & (not_2256_s3_q & not_4053);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_4057;
  assign sum_4057 = {7'h0, and_4055} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:591
  logic [1:0] sum_4061;
  assign sum_4061 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:586
  logic [9:0] high;
  assign high = less_4060_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:587
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:589
  logic not_4068;
  assign not_4068 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4069;
  assign sum_4069 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4071;
  assign not_4071 = ~({eight, 3'h0} < {1'b0, sum_4069, fall_2[0]});
  logic [1:0] sum_4072;
  assign sum_4072 = {1'b0, not_4068} + {1'b0, not_4071};
  // hls/stages/patches.hpp:590
  logic [10:0] sum_4073;
  assign sum_4073 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4075;
  assign not_4075 = ~({eight, 3'h0} < {sum_4073, fall_2[1:0]});
  logic not_4078;
  assign not_4078 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4079;
  assign sum_4079 = {1'b0, not_4075} + {1'b0, not_4078};
  // hls/stages/patches.hpp:589
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4072} + {1'b0, sum_4079};
  // hls/stages/patches.hpp:592
  logic [7:0] select_4082;
  assign select_4082 = less_4060_s3_q ? ({sum_4061, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_4061, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:609
  logic [7:0] select_4083;
  assign select_4083 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:608
  logic [5:0] select_4084;
  assign select_4084 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4085;
  assign sum_4085 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_4086;
  assign sum_4086 = {select_4084[5], select_4084} + {{3{sum_4085[3]}}, sum_4085};
  // hls/stages/patches.hpp:609
  logic [17:0] product_4087;
  assign product_4087 = $signed({{10{select_4083[7]}}, select_4083}) * $signed({{8{sum_4086[6]}}, sum_4086, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:610
  logic [13:0] difference_4088;
  assign difference_4088 = {{6{select_4082[7]}}, select_4082} - {product_4087[17], product_4087[17:5]};
  // hls/stages/patches.hpp:616
  logic less_4089;
  assign less_4089 = $signed({{7{difference_4059[6]}}, difference_4059}) < $signed(difference_4088);
  // hls/stages/patches.hpp:189
  logic not_4090;
  assign not_4090 = ~less_4089;
  // hls/stages/patches.hpp:675
  logic and_4091;
  assign and_4091 = not_4090 & and_4055;
  logic [7:0] sum_4092;
  assign sum_4092 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4091};
  // hls/stages/patches.hpp:189
  logic not_4095;
  assign not_4095 = ~($signed(difference_4088) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:676
  logic and_4096;
  assign and_4096 = not_4095 & and_4055;
  logic [7:0] sum_4097;
  assign sum_4097 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4096};
  // hls/stages/patches.hpp:192
  logic and_4099;
  assign and_4099 = and_4052 & (patches_second_s3_q & not_4053);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_4101;
  assign sum_4101 = {7'h0, and_4099} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:675
  logic and_4103;
  assign and_4103 = not_4090 & and_4099;
  logic [7:0] sum_4104;
  assign sum_4104 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4103};
  // hls/stages/patches.hpp:676
  logic and_4106;
  assign and_4106 = not_4095 & and_4099;
  logic [7:0] sum_4107;
  assign sum_4107 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4106};
  // hls/stages/patches.hpp:192
  logic and_4109;
  assign and_4109 = and_4052 & (patches_lower_s3_q & not_2256_s3_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_4111;
  assign sum_4111 = {7'h0, and_4109} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:675
  logic and_4113;
  assign and_4113 = not_4090 & and_4109;
  logic [7:0] sum_4114;
  assign sum_4114 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4113};
  // hls/stages/patches.hpp:676
  logic and_4116;
  assign and_4116 = not_4095 & and_4109;
  logic [7:0] sum_4117;
  assign sum_4117 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4116};
  // hls/stages/patches.hpp:192
  logic and_4119;
  assign and_4119 = and_4052 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_4121;
  assign sum_4121 = {7'h0, and_4119} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:675
  logic and_4123;
  assign and_4123 = not_4090 & and_4119;
  logic [7:0] sum_4124;
  assign sum_4124 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4123};
  // hls/stages/patches.hpp:676
  logic and_4126;
  assign and_4126 = not_4095 & and_4119;
  logic [7:0] sum_4127;
  assign sum_4127 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4126};
  // hls/stages/agreement.hpp:1253
  logic equal_4128;
  assign equal_4128 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1147
  logic less_4129;
  assign less_4129 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:799
  logic and_4133;
  assign and_4133 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & (equal_4128 & less_4129)));
  // hls/stages/agreement.hpp:1159
  logic and_4138;
  assign and_4138 = x_s3_q[6] & (not_2459_s3_q & (less_4129 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:799
  logic and_4139;
  assign and_4139 = equal_572_s3_q & and_4138;
  // hls/stages/patches.hpp:638
  logic [7:0] or_4141;
  assign or_4141 = (and_4133 ? patches_quarters_0_places_q : 8'h0) | (and_4139 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1159
  logic and_4145;
  assign and_4145 = x_s3_q[6] & (not_2459_s3_q & (less_4129 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:799
  logic and_4146;
  assign and_4146 = equal_572_s3_q & and_4145;
  // hls/stages/agreement.hpp:1159
  logic and_4152;
  assign and_4152 = x_s3_q[6] & (not_2459_s3_q & (less_4129 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:799
  logic and_4153;
  assign and_4153 = equal_572_s3_q & and_4152;
  // hls/stages/patches.hpp:638
  logic [7:0] or_4155;
  assign or_4155 = (or_4141 | (and_4146 ? patches_quarters_2_places_q : 8'h0)) | (and_4153 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_4159;
  assign select_4159 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:799
  logic and_4163;
  assign and_4163 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & (less_4129 & select_4159)));
  // hls/stages/patches.hpp:639
  logic [7:0] select_4165;
  assign select_4165 = and_4133 ? (and_4163 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4167;
  assign select_4167 = and_4139 ? (and_4163 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4170;
  assign select_4170 = and_4146 ? (and_4163 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4173;
  assign select_4173 = and_4153 ? (and_4163 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:640
  logic [7:0] select_4176;
  assign select_4176 = and_4133 ? (and_4163 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4178;
  assign select_4178 = and_4139 ? (and_4163 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4181;
  assign select_4181 = and_4146 ? (and_4163 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4184;
  assign select_4184 = and_4153 ? (and_4163 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_4186;
  assign sum_4186 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1159
  logic and_4190;
  assign and_4190 = x_s3_q[6] & (not_2459_s3_q & (less_4129 & (sum_4186[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:799
  logic and_4191;
  assign and_4191 = equal_572_s3_q & and_4190;
  // hls/stages/patches.hpp:635
  logic [7:0] select_4194;
  assign select_4194 = and_4191 ? (patches_word_places_q + (and_4139 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4197;
  assign select_4197 = and_4191 ? (patches_word_up_q + (and_4139 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4200;
  assign select_4200 = and_4191 ? (patches_word_down_q + (and_4139 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_4203;
  assign select_4203 = ($signed(difference_4088[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4088[5:0];
  logic [5:0] select_4204;
  assign select_4204 = ($signed(14'h10) < $signed(difference_4088)) ? 6'h10 : select_4203;
  // hls/stages/patches.hpp:678
  logic [5:0] select_4205;
  assign select_4205 = and_4052 ? select_4204 : 6'h0;
  // hls/stages/patches.hpp:679
  logic [11:0] select_4207;
  assign select_4207 = patches_round_ends_q ? {{6{select_4205[5]}}, select_4205} : (patches_across_q + {{6{select_4205[5]}}, select_4205});
  // hls/stages/agreement.hpp:799
  logic and_4211;
  assign and_4211 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q & (equal_3369 & less_4129)));
  // hls/stages/agreement.hpp:1159
  logic and_4215;
  assign and_4215 = x_s3_q[6] & (not_2459_s3_q & (less_4129 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:799
  logic and_4216;
  assign and_4216 = equal_572_s3_q & and_4215;
  // hls/stages/patches.hpp:662
  logic [7:0] select_4218;
  assign select_4218 = and_4211 ? (and_4216 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:664
  logic or_4222;
  assign or_4222 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:665
  logic or_4225;
  assign or_4225 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:666
  logic [8:0] sum_4226;
  assign sum_4226 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:661
  logic select_4228;
  assign select_4228 = and_4211 ? (and_4216 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_4231;
  assign and_4231 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:661
  logic [2:0] select_4233;
  assign select_4233 = and_4216 ? {and_4231, patches_found_q[2:1]} : (and_4211 ? {and_4231, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:660
  logic or_4237;
  assign or_4237 = patches_partly_q | (patches_doubted_q & (~and_4216));
  // hls/stages/patches.hpp:661
  logic select_4240;
  assign select_4240 = and_4211 ? (and_4216 ? or_4237 : (and_4211 ? or_4237 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:659
  logic select_4241;
  assign select_4241 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:648
  logic [7:0] select_4245;
  assign select_4245 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:617
  logic [10:0] sum_4247;
  assign sum_4247 = {sum_4086[6], sum_4086, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:679
  logic and_4249;
  assign and_4249 = ({{5{sum_4247[10]}}, sum_4247} < 16'h3) & and_4052;
  logic [7:0] sum_4250;
  assign sum_4250 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4249};
  // hls/stages/patches.hpp:668
  logic [12:0] product_4255;
  assign product_4255 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_4218};
  // hls/stages/patches.hpp:192
  logic and_4257;
  assign and_4257 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4255[12:5] < patches_on_skin_q);
  logic select_4262;
  assign select_4262 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:649
  logic or_4266;
  assign or_4266 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:650
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:651
  logic select_4273;
  assign select_4273 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:652
  logic and_4279;
  assign and_4279 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4280;
  assign sum_4280 = patches_age_q + {9'h0, and_4279};
  logic [9:0] select_4283;
  assign select_4283 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4280)) : sum_4280;
  // hls/stages/agreement.hpp:1218
  logic or_4341;
  assign or_4341 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1247
  logic equal_4343;
  assign equal_4343 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1256
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1257
  logic select_4349;
  assign select_4349 = (equal_4343 & equal_4128) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1152
  logic [10:0] sum_4352;
  assign sum_4352 = {1'b0, select_3119} + {2'h0, select_3119[9:1]};
  logic select_4355;
  assign select_4355 = (select_3116[9:3] == 7'h0) ? ((~or_4341) & (~select_4349)) : (~({sum_4352, select_3119[0]} < {2'h0, select_3116}));
  // hls/stages/agreement.hpp:1159
  logic [47:0] select_4357;
  assign select_4357 = x_s3_q[6] ? (equal_2084_s3_q ? good_q : {select_4355, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:799
  logic select_4362;
  assign select_4362 = equal_572_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4360_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1165
  logic [8:0] select_4364;
  assign select_4364 = hidden_ends_q ? 9'h0 : (hidden_for_q + {{7{hidden_more_q[0]}}, hidden_more_q});
  // hls/stages/agreement.hpp:1177
  logic [8:0] select_4365;
  assign select_4365 = equal_4360_s3_q ? select_4364 : hidden_for_q;
  // hls/stages/agreement.hpp:1247
  logic equal_4367;
  assign equal_4367 = x_s3_q[6:3] == 4'ha;
  logic equal_4369;
  assign equal_4369 = x_s3_q[6:3] == 4'hc;
  logic equal_4370;
  assign equal_4370 = x_s3_q[6:3] == 4'hb;
  logic equal_4371;
  assign equal_4371 = x_s3_q[6:3] == 4'h9;
  logic equal_4372;
  assign equal_4372 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_4374;
  assign select_4374 = equal_4371 ? counts_skin_unproven_q : (equal_4372 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4376;
  assign select_4376 = equal_4370 ? counts_regions_bad_q : (equal_4367 ? counts_nearer_q : select_4374);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4369 ? counts_on_skin_q : select_4376;
  // hls/stages/agreement.hpp:1252
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1260
  logic select_4379;
  assign select_4379 = (equal_4367 & equal_4128) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1179
  logic not_4380;
  assign not_4380 = ~select_4379;
  // hls/stages/agreement.hpp:1180
  logic or_4383;
  assign or_4383 = not_4380 | (~(hidden_for_q[8:1] == 8'hff));
  // hls/stages/agreement.hpp:799
  logic select_4388;
  assign select_4388 = equal_572_s3_q ? (not_4380 & (cfg_same_table_i | (hidden_for_q == 9'h0))) : hidden_ends_q;
  // hls/stages/agreement.hpp:1261
  logic [13:0] select_4389;
  assign select_4389 = equal_4128 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1142
  logic [7:0] select_4391;
  assign select_4391 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4393;
  assign select_4393 = equal_4372 ? cfg_unproven_skin_limit_i : (equal_4343 ? cfg_unproven_limit_i : select_4391);
  logic [7:0] select_4395;
  assign select_4395 = equal_4367 ? cfg_regions_limit_i : (equal_4371 ? cfg_hidden_limit_i : select_4393);
  logic [7:0] limit;
  assign limit = equal_4369 ? cfg_regions_limit_i : (equal_4370 ? {cfg_on_skin_limit_i, 3'h0} : select_4395);
  // hls/stages/agreement.hpp:1261
  logic not_4398;
  assign not_4398 = ~x_s3_q[2];
  logic [3:0] select_4399;
  assign select_4399 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4398, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4398};
  logic [7:0] select_4400;
  assign select_4400 = x_s3_q[0] ? {select_4399[3], 1'b0, select_4399[2], 1'b0, select_4399[1], 1'b0, select_4399[0], 1'b0} : {1'b0, select_4399[3], 1'b0, select_4399[2], 1'b0, select_4399[1], 1'b0, select_4399[0]};
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_4404;
  assign select_4404 = equal_4371 ? counts_skin_supervised_q : (equal_4372 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4406;
  assign select_4406 = equal_4370 ? counts_skin_textured_q : (equal_4367 ? counts_textured_q : select_4404);
  logic [13:0] of;
  assign of = equal_4369 ? counts_textured_q : select_4406;
  // hls/stages/agreement.hpp:1261
  logic [13:0] select_4408;
  assign select_4408 = ((limit & select_4400) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4389} + {1'b0, select_4408};
  // hls/stages/agreement.hpp:799
  logic select_4413;
  assign select_4413 = equal_572_s3_q ? (equal_4128 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1258
  logic and_4418;
  assign and_4418 = too_much_q & (~(equal_4372 & equal_4128));
  // hls/stages/agreement.hpp:1259
  logic select_4423;
  assign select_4423 = (over[14] & equal_4128) ? (and_4418 | ((equal_4372 | equal_4371) | (x_s3_q[6:3] == 4'hf))) : and_4418;
  // hls/stages/agreement.hpp:1142
  logic and_4428;
  assign and_4428 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1261
  logic select_4429;
  assign select_4429 = (equal_4369 & equal_4128) ? and_4428 : overlooks_q;
  // hls/stages/agreement.hpp:799
  logic [2:0] select_4431;
  assign select_4431 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4433;
  assign select_4433 = equal_572_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_4431 : box_textured_columns_values_0_q);
  logic [2:0] select_4434;
  assign select_4434 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4436;
  assign select_4436 = equal_572_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4434 : box_textured_columns_values_1_q);
  logic [2:0] select_4437;
  assign select_4437 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4439;
  assign select_4439 = equal_572_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4437 : box_textured_columns_values_2_q);
  logic [2:0] select_4440;
  assign select_4440 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4442;
  assign select_4442 = equal_572_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4440 : box_textured_columns_values_3_q);
  logic [2:0] select_4443;
  assign select_4443 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4445;
  assign select_4445 = equal_572_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4443 : box_textured_columns_values_4_q);
  logic [4:0] select_4447;
  assign select_4447 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_572_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4449 : box_explained_columns_values_0_q);
  logic [2:0] select_4452;
  assign select_4452 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4454;
  assign select_4454 = equal_572_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4452 : box_explained_columns_values_1_q);
  logic [2:0] select_4455;
  assign select_4455 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4457;
  assign select_4457 = equal_572_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4455 : box_explained_columns_values_2_q);
  logic [2:0] select_4458;
  assign select_4458 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4460;
  assign select_4460 = equal_572_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4458 : box_explained_columns_values_3_q);
  logic [2:0] select_4461;
  assign select_4461 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4463;
  assign select_4463 = equal_572_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4461 : box_explained_columns_values_4_q);
  logic [4:0] select_4465;
  assign select_4465 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4468;
  assign select_4468 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4470;
  assign select_4470 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4472;
  assign select_4472 = equal_572_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4470 : box_shown_columns_values_1_q);
  logic [2:0] select_4473;
  assign select_4473 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4475;
  assign select_4475 = equal_572_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4473 : box_shown_columns_values_2_q);
  logic [2:0] select_4476;
  assign select_4476 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4478;
  assign select_4478 = equal_572_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4476 : box_shown_columns_values_3_q);
  logic [2:0] select_4479;
  assign select_4479 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4481;
  assign select_4481 = equal_572_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4479 : box_shown_columns_values_4_q);
  logic [4:0] select_4483;
  assign select_4483 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4486;
  assign select_4486 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4488;
  assign select_4488 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4490;
  assign select_4490 = equal_572_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4488 : box_nearer_columns_values_1_q);
  logic [2:0] select_4491;
  assign select_4491 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4493;
  assign select_4493 = equal_572_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4491 : box_nearer_columns_values_2_q);
  logic [2:0] select_4494;
  assign select_4494 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4496;
  assign select_4496 = equal_572_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4494 : box_nearer_columns_values_3_q);
  logic [2:0] select_4497;
  assign select_4497 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4499;
  assign select_4499 = equal_572_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4497 : box_nearer_columns_values_4_q);
  logic [4:0] select_4501;
  assign select_4501 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1340
  logic [1:0] select_4548;
  assign select_4548 = and_4547_s3_q ? {and_2604, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4552;
  assign select_4552 = and_2532_s3_q ? (less_2533_s3_q ? (select_4548[0] & and_4549_s3_q) : seen_q) : seen_q;
  logic select_4555;
  assign select_4555 = and_2532_s3_q ? (less_2533_s3_q ? (select_4548[1] & and_4549_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1269
  logic or_4562;
  assign or_4562 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_s3_q);
  // hls/stages/agreement.hpp:1271
  logic not_4570;
  assign not_4570 = ~(or_4341 | not_2828);
  // hls/stages/agreement.hpp:799
  logic and_4574;
  assign and_4574 = equal_572_s3_q & (equal_4360_s3_q & (not_4570 & (select_4349 | select_4423)));
  logic and_4577;
  assign and_4577 = equal_4360_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1169
  logic or_4581;
  assign or_4581 = select_2926 | (select_2938 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:799
  logic and_4588;
  assign and_4588 = equal_572_s3_q & (equal_4360_s3_q & (not_4570 & (select_2932 | select_2944)));
  // hls/stages/agreement.hpp:1169
  logic and_4593;
  assign and_4593 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4365[8:1] < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:1181
  logic [14:0] sum_4597;
  assign sum_4597 = {1'b0, counts_skin_textured_q} + {2'h0, counts_skin_textured_q[13:1]};
  // hls/stages/agreement.hpp:1166
  logic and_4599;
  assign and_4599 = (proven_s3_q & (~cfg_same_table_i)) & (sum_4597[14:1] < counts_nearer_q);
  // hls/stages/agreement.hpp:799
  logic and_4601;
  assign and_4601 = equal_4360_s3_q & ((not_2828 | and_4593) ? cfg_prove_i : and_4599);
  // hls/stages/agreement.hpp:1169
  logic select_4605;
  assign select_4605 = (not_2828 | (select_4429 & not_4252)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:799
  logic and_4610;
  assign and_4610 = equal_572_s3_q & (equal_4360_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4614;
  assign and_4614 = equal_572_s3_q & (x_s3_q[6] & (not_2459_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4622;
  assign select_4622 = equal_2106_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4620_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4623;
  assign select_4623 = equal_2104_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4622;
  logic [31:0] select_4624;
  assign select_4624 = equal_2102_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4623;
  logic [31:0] select_4625;
  assign select_4625 = equal_2100_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4624;
  logic [31:0] select_4626;
  assign select_4626 = equal_2098_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4625;
  logic [31:0] select_4627;
  assign select_4627 = equal_2096_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4626;
  logic [31:0] select_4628;
  assign select_4628 = equal_2094_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4627;
  logic [31:0] select_4629;
  assign select_4629 = equal_2092_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4628;
  // hls/stages/agreement.hpp:1155
  logic [9:0] select_4630;
  assign select_4630 = less_3115 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1159
  logic [31:0] select_4631;
  assign select_4631 = equal_2084_s3_q ? select_4629 : {2'h0, select_4630, select_3119, select_3116};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_547_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_748_s3_q, and_747, less_742_s3_q, and_741_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_735, and_711_s3_q, and_710_s3_q, and_685_s3_q, less_677_s3_q, less_676_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q};
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
  assign registration_sums_waddr = {sum_2090_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2149_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2148, sum_2144};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2175_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2248_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2224_s3_q};
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
  assign patches_right_0_waddr = {select_2284_s3_q, select_2281};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2293);
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
  assign patches_right_1_waddr = {select_2284_s3_q, select_2309};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2312);
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
  assign patches_left_waddr = {select_2331, select_2330_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2337);
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
  assign patches_rows_wdata = select_2447;
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
  assign regions_waddr = {region_row_s3_q, or_2457_s3_q, or_2454_s3_q, or_2451_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2496_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2495, sum_2484, sum_2478};
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
  assign map_waddr = {sum_2540_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2616_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2604, is_seen};
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
      hidden_for_q <= 9'h0;
      hidden_more_q <= 2'h0;
      hidden_ends_q <= 1'b0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2768;
      sharpness_before_last_mask_q <= select_2840;
      sharpness_sums_detail_0_q <= and_547_s3_q ? select_2854 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_547_s3_q ? select_2866 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_547_s3_q ? sum_2870 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_547_s3_q ? sum_2874 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2892 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2902 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2904 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2906 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2908 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2910 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2915;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2918 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2926;
      sharpness_comparing_less_detail_1_q <= select_2932;
      sharpness_comparing_less_contrast_0_q <= select_2938;
      sharpness_comparing_less_contrast_1_q <= select_2944;
      counts_supervised_q <= select_3071;
      counts_textured_q <= and_3062_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3074});
      counts_explained_q <= and_3062_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3079});
      counts_nearer_q <= and_3062_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3084});
      counts_unproven_q <= and_3062_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3112});
      counts_regions_bad_q <= select_3128;
      counts_skin_supervised_q <= select_3136;
      counts_skin_textured_q <= select_3143;
      counts_skin_unproven_q <= select_3151;
      counts_on_skin_q <= select_3171;
      registration_half_across_q <= select_3251;
      registration_half_measured_q <= select_3256;
      registration_half_votes_down_q <= and_3229_s3_q ? 7'h0 : sum_3262;
      registration_half_votes_up_q <= and_3229_s3_q ? 7'h0 : sum_3270;
      registration_half_half_votes_down_q <= and_3229_s3_q ? 7'h0 : sum_3277;
      registration_half_half_votes_up_q <= and_3229_s3_q ? 7'h0 : sum_3284;
      registration_down_q <= and_3317 ? sum_3336 : registration_down_q;
      registration_up_q <= and_3317 ? sum_3345 : registration_up_q;
      registration_enough_q <= select_3359;
      registration_votes_down_q <= and_3364 ? less_3365 : registration_votes_down_q;
      registration_votes_up_q <= and_3364 ? less_3367 : registration_votes_up_q;
      registration_other_enough_q <= and_3373 ? select_3359 : registration_other_enough_q;
      registration_other_down_q <= and_3373 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3373 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_572_s3_q & and_3380)) & or_3405;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2272 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2275 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2276 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3488;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2301 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2303 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2304 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3493;
      patches_valid_0_q <= select_3498;
      patches_valid_1_q <= select_3503;
      patches_right_next_0_q <= select_3506;
      patches_right_next_1_q <= select_3509;
      patches_left_next_0_q <= select_3512;
      patches_left_next_1_q <= select_3515;
      patches_sums_values_0_q <= select_3939;
      patches_sums_values_1_q <= equal_2249_s3_q ? patches_sums_values_1_q : select_3940;
      patches_sums_values_2_q <= equal_2249_s3_q ? patches_sums_values_2_q : select_3942;
      patches_sums_values_3_q <= equal_2249_s3_q ? patches_sums_values_3_q : select_3944;
      patches_sums_values_4_q <= equal_2249_s3_q ? patches_sums_values_4_q : select_3946;
      patches_sums_values_5_q <= equal_2249_s3_q ? patches_sums_values_5_q : select_3948;
      patches_sums_values_6_q <= equal_2249_s3_q ? patches_sums_values_6_q : select_3950;
      patches_sums_values_7_q <= equal_2249_s3_q ? patches_sums_values_7_q : select_3952;
      patches_sums_values_8_q <= equal_2249_s3_q ? patches_sums_values_8_q : select_3954;
      patches_sums_values_9_q <= equal_2249_s3_q ? patches_sums_values_9_q : select_3956;
      patches_sums_values_10_q <= equal_2249_s3_q ? patches_sums_values_10_q : select_3958;
      patches_sums_values_11_q <= equal_2249_s3_q ? patches_sums_values_11_q : select_3960;
      patches_sums_values_12_q <= equal_2249_s3_q ? patches_sums_values_12_q : select_3962;
      patches_sums_values_13_q <= equal_2249_s3_q ? patches_sums_values_13_q : select_3964;
      patches_sums_values_14_q <= equal_2249_s3_q ? patches_sums_values_14_q : select_3966;
      patches_sums_values_15_q <= equal_2249_s3_q ? patches_sums_values_15_q : select_3968;
      patches_sums_values_16_q <= equal_2249_s3_q ? patches_sums_values_16_q : select_3970;
      patches_best_differing_q <= select_2447[9:0];
      patches_best_column_q <= select_2447[14:10];
      patches_quarters_0_places_q <= sum_4057;
      patches_quarters_0_up_q <= sum_4092;
      patches_quarters_0_down_q <= sum_4097;
      patches_quarters_1_places_q <= sum_4101;
      patches_quarters_1_up_q <= sum_4104;
      patches_quarters_1_down_q <= sum_4107;
      patches_quarters_2_places_q <= sum_4111;
      patches_quarters_2_up_q <= sum_4114;
      patches_quarters_2_down_q <= sum_4117;
      patches_quarters_3_places_q <= sum_4121;
      patches_quarters_3_up_q <= sum_4124;
      patches_quarters_3_down_q <= sum_4127;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_4155;
      patches_word_up_q <= ((select_4165 | select_4167) | select_4170) | select_4173;
      patches_word_down_q <= ((select_4176 | select_4178) | select_4181) | select_4184;
      patches_sum_places_q <= select_4194;
      patches_sum_up_q <= select_4197;
      patches_sum_down_q <= select_4200;
      patches_across_q <= select_4207;
      patches_places_q <= select_4218;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4222;
      patches_partly_q <= or_4225;
      patches_clear_limit_q <= sum_4226[8:2];
      patches_complete_q <= select_4228;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4211 ? select_4233 : patches_found_q;
      patches_doubted_q <= select_4240;
      patches_doubted_before_q <= select_4241;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4245;
      patches_on_skin_q <= sum_4250;
      patches_large_q <= not_4252 & and_4257;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4262;
      patches_spoiled_q <= or_4266;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4273;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4283;
      segment_textured_q <= select_2475 + {6'h0, and_3074};
      segment_explained_q <= select_2481 + {6'h0, and_3079};
      segment_nearer_q <= select_2492 + {6'h0, and_3084};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_572_s3_q ? select_4357 : good_q;
      good_known_q <= select_4362;
      hidden_for_q <= equal_572_s3_q ? select_4365 : hidden_for_q;
      hidden_more_q <= equal_572_s3_q ? {or_4383, not_4380} : hidden_more_q;
      hidden_ends_q <= select_4388;
      product_q <= equal_572_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4413;
      disagree_q <= equal_572_s3_q ? select_4349 : disagree_q;
      too_much_q <= equal_572_s3_q ? select_4423 : too_much_q;
      hides_q <= equal_572_s3_q ? select_4379 : hides_q;
      overlooks_q <= equal_572_s3_q ? select_4429 : overlooks_q;
      seen_q <= select_4552;
      nearer_q <= select_4555;
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
      averager_quarter_1_0_q <= select_2642;
      averager_quarter_1_1_q <= select_2644;
      averager_quarter_2_0_q <= select_2646;
      averager_quarter_2_1_q <= select_2648;
      averager_detail_0_q <= select_2660;
      averager_detail_1_q <= select_2668;
      census_changes_values_0_left_q <= and_547_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_547_s3_q ? sum_2752 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2754;
      census_changes_values_1_right_q <= select_2755;
      census_changes_values_2_left_q <= select_2756;
      census_changes_values_2_right_q <= select_2757;
      sharpness_last_mask_q <= and_547_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_547_s3_q ? select_2837[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_547_s3_q ? select_2837[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4433;
      box_textured_columns_values_1_q <= select_4436;
      box_textured_columns_values_2_q <= select_4439;
      box_textured_columns_values_3_q <= select_4442;
      box_textured_columns_values_4_q <= select_4445;
      box_textured_sum_sums_values_0_q <= equal_572_s3_q ? box_textured_sum_sums_values_0_q : select_4447;
      box_explained_columns_values_0_q <= select_4451;
      box_explained_columns_values_1_q <= select_4454;
      box_explained_columns_values_2_q <= select_4457;
      box_explained_columns_values_3_q <= select_4460;
      box_explained_columns_values_4_q <= select_4463;
      box_explained_sum_sums_values_0_q <= equal_572_s3_q ? box_explained_sum_sums_values_0_q : select_4465;
      box_shown_columns_values_0_q <= equal_572_s3_q ? box_shown_columns_values_0_q : select_4468;
      box_shown_columns_values_1_q <= select_4472;
      box_shown_columns_values_2_q <= select_4475;
      box_shown_columns_values_3_q <= select_4478;
      box_shown_columns_values_4_q <= select_4481;
      box_shown_sum_sums_values_0_q <= equal_572_s3_q ? box_shown_sum_sums_values_0_q : select_4483;
      box_nearer_columns_values_0_q <= equal_572_s3_q ? box_nearer_columns_values_0_q : select_4486;
      box_nearer_columns_values_1_q <= select_4490;
      box_nearer_columns_values_2_q <= select_4493;
      box_nearer_columns_values_3_q <= select_4496;
      box_nearer_columns_values_4_q <= select_4499;
      box_nearer_sum_sums_values_0_q <= equal_572_s3_q ? box_nearer_sum_sums_values_0_q : select_4501;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4532_s4_q;
  logic or_4556_s4_q;
  logic and_4557_s4_q;
  logic and_4565_s4_q;
  logic and_4568_s4_q;
  logic and_4574_s4_q;
  logic and_4578_s4_q;
  logic and_4584_s4_q;
  logic and_4588_s4_q;
  logic and_4602_s4_q;
  logic and_4607_s4_q;
  logic and_4610_s4_q;
  logic and_4614_s4_q;
  logic [5:0] select_4616_s4_q;
  logic [31:0] select_4633_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4532_s4_q <= and_4532_s3_q;
      or_4556_s4_q <= not_2828 | select_4552;
      and_4557_s4_q <= cfg_prove_i & select_4555;
      and_4565_s4_q <= equal_572_s3_q & (equal_4360_s3_q & (cfg_prove_i & or_4562));
      and_4568_s4_q <= equal_572_s3_q & (equal_4360_s3_q & (cfg_prove_i & or_4341));
      and_4574_s4_q <= and_4574;
      and_4578_s4_q <= equal_572_s3_q & and_4577;
      and_4584_s4_q <= equal_572_s3_q & (equal_4360_s3_q & (not_4570 & or_4581));
      and_4588_s4_q <= and_4588;
      and_4602_s4_q <= equal_572_s3_q & and_4601;
      and_4607_s4_q <= equal_572_s3_q & (equal_4360_s3_q & select_4605);
      and_4610_s4_q <= and_4610;
      and_4614_s4_q <= and_4614;
      select_4616_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4633_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? select_4631 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4556_s4_q;
  assign marks_nearer_o = and_4557_s4_q;
  assign verdict_valid_o = and_4532_s4_q;
  assign verdict_unproven_yet_o = and_4565_s4_q;
  assign verdict_untextured_o = and_4568_s4_q;
  assign verdict_disagree_o = and_4574_s4_q;
  assign verdict_moved_o = and_4578_s4_q;
  assign verdict_unsharp_left_o = and_4584_s4_q;
  assign verdict_unsharp_right_o = and_4588_s4_q;
  assign verdict_hidden_o = and_4602_s4_q;
  assign verdict_overlooked_o = and_4607_s4_q;
  assign verdict_out_of_step_o = and_4610_s4_q;
  assign frame_valid_o = and_4614_s4_q;
  assign frame_index_o = select_4616_s4_q;
  assign frame_word_o = select_4633_s4_q;
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
  assign unused_bits = ^{sum_4597[0], over[13:0], product_4255[4:0], sum_4226[1:0], sum_4186[1:0], product_4087[4:0], sum_3219[0], difference_3157[1:0], detail_4[1:0], detail_3[1:0], sum_2762[4:0], sum_2191[0], sum_2187[0], sum_733[4:0], cfg_width_i[2:0]};

endmodule
