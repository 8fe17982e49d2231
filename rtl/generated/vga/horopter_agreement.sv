// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3082 bits, pipeline 851 bits, memories 127160 bits.
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
  logic not_2816;
  assign not_2816 = ~cfg_prove_i;
  logic [5:0] sum_3026;
  assign sum_3026 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_3031;
  assign less_3031 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_4042;
  assign difference_4042 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4235;
  assign not_4235 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4293;
  assign difference_4293 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4512;
  assign sum_4512 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4513;
  assign select_4513 = (6'h4 < cfg_height_i[8:3]) ? {sum_4512, cfg_height_i[4:3]} : 8'h0;

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
  logic [2:0] select_505;
  assign select_505 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_509;
  assign select_509 = select_505[0] ? averager_place_q : (row_starts ? 9'h0 : (averager_place_q + 9'h1));
  // hls/stages/census.hpp:122
  logic or_513;
  assign or_513 = row_starts | (averager_inside_q & (~(averager_place_q == 9'h13f)));
  // hls/stages/census.hpp:124
  logic select_514;
  assign select_514 = select_505[0] ? averager_inside_q : or_513;
  // hls/stages/census.hpp:42
  logic or_515;
  assign or_515 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:422
  logic and_517;
  assign and_517 = select_514 & (select_505[0] & or_515);
  // hls/stages/census.hpp:42
  logic [2:0] select_522;
  assign select_522 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [6:0] select_538;
  assign select_538 = sample_pair_first_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_q ? select_538 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_540;
  assign equal_540 = select_505 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_541;
  assign equal_541 = select_522 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_542;
  assign and_542 = equal_541 & and_517;
  // hls/stages/agreement.hpp:276
  logic and_544;
  assign and_544 = sample_pair_whole_q & (equal_540 & and_542);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:630
  logic equal_573;
  assign equal_573 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic or_574;
  assign or_574 = so | equal_573;
  // hls/stages/agreement.hpp:599
  logic [7:0] sum_575;
  assign sum_575 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:601
  logic [7:0] select_576;
  assign select_576 = run_shift_q[5] ? x_q : sum_575;
  logic less_577;
  assign less_577 = {1'b0, last_q} < select_576;
  // hls/stages/agreement.hpp:226
  logic not_578;
  assign not_578 = ~less_577;
  // hls/stages/agreement.hpp:621
  logic equal_588;
  assign equal_588 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:622
  logic equal_589;
  assign equal_589 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_590;
  assign and_590 = equal_589 & not_578;
  logic select_592;
  assign select_592 = or_574 ? not_578 : (equal_588 ? not_578 : and_590);
  // hls/stages/agreement.hpp:805
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_611;
  assign and_611 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_576)));
  logic and_612;
  assign and_612 = equal_588 & and_611;
  logic select_613;
  assign select_613 = or_574 ? not_578 : and_612;
  // hls/stages/agreement.hpp:828
  logic [6:0] right;
  assign right = sum_575[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:601
  logic not_645;
  assign not_645 = ~or_574;
  // hls/stages/agreement.hpp:149
  logic and_648;
  assign and_648 = not_645 & ((~equal_588) & and_590);
  // hls/stages/census.hpp:42
  logic [5:0] select_675;
  assign select_675 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_675 : 6'h0;
  // hls/stages/patches.hpp:396
  logic not_2146;
  assign not_2146 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_2149;
  assign not_2149 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_2150;
  assign and_2150 = patches_capturing_q & not_2149;
  // hls/stages/patches.hpp:368
  logic equal_2151;
  assign equal_2151 = {or_515, select_522} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_2153;
  assign equal_2153 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2158;
  assign and_2158 = (not_2146 & (patches_work_q == 3'h0)) & (~(and_2150 | ((~equal_2151) | (~equal_2153))));
  // hls/stages/patches.hpp:537
  logic equal_2249;
  assign equal_2249 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_2250;
  assign not_2250 = ~equal_2249;
  // hls/stages/patches.hpp:509
  logic equal_2251;
  assign equal_2251 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_2252;
  assign not_2252 = ~equal_2251;
  // hls/stages/patches.hpp:503
  logic equal_2253;
  assign equal_2253 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2254;
  assign equal_2254 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_2255;
  assign or_2255 = equal_2253 | equal_2254;
  // hls/stages/patches.hpp:464
  logic not_2256;
  assign not_2256 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_2278;
  assign select_2278 = and_2158 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2279;
  assign select_2279 = row_starts ? select_2278 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2281;
  assign and_2281 = and_2150 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2285;
  assign select_2285 = row_starts ? (and_2158 | (and_2150 & (~and_2281))) : patches_capturing_q;
  // hls/stages/agreement.hpp:275
  logic and_2293;
  assign and_2293 = not_2250 & (not_2252 & (or_2255 & (patches_second_q & equal_2254)));
  // hls/stages/patches.hpp:168
  logic not_2309;
  assign not_2309 = ~equal_2254;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2325;
  assign select_2325 = row_starts ? {select_2278[4], select_2278[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_2335;
  assign and_2335 = not_2250 & (or_2255 & not_2252);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2606;
  assign select_2606 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_505 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2609;
  assign select_2609 = sample_pair_whole_q ? (sample_last_q ? (select_522 + 3'h1) : select_522) : raster_at_y_q;
  logic [6:0] select_2612;
  assign select_2612 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_538 + {6'h0, equal_540})) : raster_at_column_q;
  logic [5:0] select_2615;
  assign select_2615 = sample_pair_whole_q ? (sample_last_q ? (select_675 + {5'h0, equal_541}) : select_675) : raster_at_row_q;
  logic select_2619;
  assign select_2619 = sample_pair_whole_q ? (sample_last_q ? (or_515 & (~raster_final_row_q)) : or_515) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2621;
  assign select_2621 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2625;
  assign select_2625 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:463
  logic [7:0] sum_2934;
  assign sum_2934 = {1'b0, last} + 8'h1;
  logic equal_2935;
  assign equal_2935 = {sum_2934[7], cfg_width_i[9:3]} == {1'b0, sum_2934[6:0]};
  // hls/stages/agreement.hpp:468
  logic and_2936;
  assign and_2936 = and_544 & equal_2935;
  // hls/stages/agreement.hpp:530
  logic select_2939;
  assign select_2939 = (and_2936 | (~ends_cell_q)) ? and_2936 : ends_q;
  // hls/stages/agreement.hpp:536
  logic [2:0] now;
  assign now = select_2939 ? (and_2936 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:541
  logic [5:0] select_2943;
  assign select_2943 = select_2939 ? (and_2936 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2946;
  assign select_2946 = select_2939 ? (following_last_shift_q & (~and_2936)) : run_last_shift_q;
  // hls/stages/agreement.hpp:614
  logic and_2949;
  assign and_2949 = run_last_shift_q & equal_588;
  // hls/stages/agreement.hpp:623
  logic select_2951;
  assign select_2951 = equal_588 ? (~run_last_shift_q) : equal_589;
  // hls/stages/agreement.hpp:627
  logic equal_2952;
  assign equal_2952 = run_phase_q == 3'h1;
  logic not_2955;
  assign not_2955 = ~select_2951;
  // hls/stages/agreement.hpp:630
  logic equal_2957;
  assign equal_2957 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:614
  logic and_2958;
  assign and_2958 = final_row_q & so;
  // hls/stages/agreement.hpp:627
  logic [1:0] select_2959;
  assign select_2959 = equal_2957 ? 2'h1 : {2{and_2958}};
  logic [2:0] select_2961;
  assign select_2961 = (and_2949 | (select_2951 | equal_2952)) ? (equal_2952 ? 3'h2 : {not_2955, {2{select_2951}}}) : (equal_573 ? 3'h6 : {select_2959[0], select_2959});
  // hls/stages/agreement.hpp:614
  logic and_2964;
  assign and_2964 = select_2951 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:637
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2967;
  assign select_2967 = (plan_shift_q[5] & select_2951) ? value : 7'h0;
  logic [1:0] or_2968;
  assign or_2968 = {2{so}} | select_2967[5:4];
  // hls/stages/agreement.hpp:640
  logic [7:0] or_2972;
  assign or_2972 = (select_2951 ? plan_columns_q : 8'h0) | ((equal_2952 | equal_2957) ? whole_q : 8'h0);
  logic [1:0] or_2973;
  assign or_2973 = {2{and_2949}} | or_2972[3:2];
  // hls/stages/agreement.hpp:641
  logic [7:0] or_2975;
  assign or_2975 = {or_2972[7:4], or_2973, or_2972[1:0]} | (equal_573 ? drawn_q : 8'h0);
  logic [4:0] or_2976;
  assign or_2976 = {5{so}} | {or_2975[6], or_2975[3:0]};
  // hls/stages/agreement.hpp:647
  logic not_2980;
  assign not_2980 = ~run_shift_q[5];
  logic [7:0] select_2983;
  assign select_2983 = equal_588 ? ({{7{not_2980}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2987;
  assign select_2987 = and_2936 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:533
  logic [7:0] select_2989;
  assign select_2989 = select_2939 ? {select_2987[6], select_2987} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2992;
  assign select_2992 = select_2939 ? (and_2936 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:527
  logic [6:0] select_3000;
  assign select_3000 = and_544 ? (equal_2935 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:480
  logic [5:0] sum_3001;
  assign sum_3001 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_3003;
  assign select_3003 = and_544 ? (equal_2935 ? {sum_3001, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:481
  logic [5:0] sum_3004;
  assign sum_3004 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_3006;
  assign select_3006 = and_544 ? (equal_2935 ? {sum_3004, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:538
  logic select_3017;
  assign select_3017 = (ends_cell_q | select_2939) ? (~(now == 3'h6)) : (equal_588 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:533
  logic and_3021;
  assign and_3021 = (~select_2939) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:483
  logic [6:0] sum_3022;
  assign sum_3022 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:464
  logic select_3024;
  assign select_3024 = equal_2935 ? ({sum_3022[6], cfg_height_i[8:3]} == {1'b0, sum_3022[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3393;
  assign select_3393 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3394;
  assign select_3394 = sample_pair_whole_q ? select_3393 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_3395;
  assign and_3395 = not_2149 & equal_2151;
  logic [8:0] select_3396;
  assign select_3396 = and_3395 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3397;
  assign select_3397 = and_3395 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3398;
  assign select_3398 = sample_pair_first_q ? select_3396 : select_3397;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3400;
  assign select_3400 = sample_pair_whole_q ? (row_starts ? select_3398[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3402;
  assign select_3402 = sample_pair_whole_q ? (row_starts ? select_3398[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3405;
  assign select_3405 = sample_pair_whole_q ? (equal_2153 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3407;
  assign select_3407 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2153}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_3408;
  assign equal_3408 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_3409;
  assign not_3409 = ~equal_3408;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3411;
  assign select_3411 = sample_pair_whole_q ? (phase + {not_3409, 1'b1, not_3409, equal_3408}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:477
  logic equal_3413;
  assign equal_3413 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3417;
  assign select_3417 = equal_3413 ? ((select_3394 == 4'h6) ? 4'h0 : (select_3394 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3418;
  assign equal_3418 = select_3417 == 4'h0;
  // hls/stages/agreement.hpp:464
  logic [3:0] select_3421;
  assign select_3421 = equal_2935 ? (equal_3418 ? 4'h6 : (select_3417 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3423;
  assign select_3423 = equal_3413 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:464
  logic [4:0] select_3425;
  assign select_3425 = equal_2935 ? (select_3423 + {4'h0, equal_3418}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:527
  logic select_3430;
  assign select_3430 = and_544 ? (equal_2935 ? ((6'h2 < row) & equal_3418) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3432;
  assign select_3432 = and_544 ? (equal_2935 ? select_3423 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3456;
  assign sum_3456 = {1'b0, select_675[5:1]} + 6'h1;
  logic less_3457;
  assign less_3457 = {sum_3456, select_675[0], select_522, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3460;
  assign select_3460 = row_starts ? (and_2158 ? (~less_3457) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3499;
  assign or_3499 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3504;
  assign select_3504 = (patches_second_q | patches_begins_q) ? not_2146 : (patches_ends_q & equal_2249);
  logic and_3505;
  assign and_3505 = equal_2249 & not_2256;
  // hls/stages/patches.hpp:403
  logic and_3506;
  assign and_3506 = not_2309 & and_3505;
  logic [1:0] select_3508;
  assign select_3508 = equal_2251 ? 2'h0 : (equal_2253 ? 2'h3 : {equal_2254, and_3506});
  // hls/stages/patches.hpp:283
  logic equal_3510;
  assign equal_3510 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3511;
  assign not_3511 = ~equal_3510;
  // hls/stages/patches.hpp:283
  logic equal_3512;
  assign equal_3512 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3513;
  assign not_3513 = ~equal_3512;
  // hls/stages/patches.hpp:287
  logic not_3515;
  assign not_3515 = ~(patches_following_q == 3'h2);
  logic and_3518;
  assign and_3518 = (~(patches_following_q == 3'h1)) & not_3515;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3519;
  assign select_3519 = equal_3512 ? 2'h2 : {and_3518, not_3515};
  logic [3:0] select_3520;
  assign select_3520 = equal_3510 ? 4'h2 : {select_3519, {2{not_3513}}};
  // hls/stages/patches.hpp:409
  logic not_3523;
  assign not_3523 = ~or_3499;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3528;
  assign select_3528 = or_3499 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3530;
  assign select_3530 = or_3499 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1382; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_648;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1383; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_592;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1384; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_574 ? x_q[6:0] : (equal_588 ? sum_575[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_592;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1385; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_574 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_613;
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
  assign patches_right_1_re = s0_en & and_2293;
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
  assign patches_left_re = s0_en & (not_2250 & (not_2252 & (not_2309 & or_2255)));
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
  assign patches_columns_above_re = s0_en & and_2335;
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
      raster_at_x_q <= select_2606;
      raster_at_y_q <= select_2609;
      raster_at_column_q <= select_2612;
      raster_at_row_q <= select_2615;
      raster_at_live_q <= select_2619;
      raster_rows_left_q <= sample_pair_whole_q ? select_2621 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2625;
      averager_place_q <= sample_pair_whole_q ? select_509 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_514 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2943;
      run_last_shift_q <= select_2946;
      run_span_q <= select_2939 ? (and_2936 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2961;
      following_shift_q <= select_2951 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2964;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2967[6], or_2968, select_2967[3:0]};
      following_columns_q <= {or_2975[7], or_2976[4], or_2975[5:4], or_2976[3:0]};
      plan_shift_q <= equal_588 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2983;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2989;
      columns_left_q <= select_2992;
      last_q <= and_544 ? (equal_2935 ? last : last_q) : last_q;
      least_q <= select_3000;
      whole_q <= select_3003;
      drawn_q <= select_3006;
      age_q <= select_2939 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2939 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3017;
      ends_q <= and_3021;
      final_row_q <= and_544 ? select_3024 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3394;
      patches_band_rows_rows_to_next_q <= select_3400;
      patches_band_rows_number_q <= select_3402;
      patches_next_band_rows_to_next_q <= select_3405;
      patches_next_band_number_q <= select_3407;
      patches_first_band_rows_to_next_q <= select_3411;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3408 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_544 ? select_3421 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_544 ? select_3425 : patches_choosing_number_q;
      patches_chooses_q <= select_3430;
      patches_choosing_band_q <= select_3432;
      patches_capturing_q <= sample_pair_whole_q ? select_2285 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3460 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2279 : patches_row_q;
      patches_work_q <= or_3499 ? following : patches_work_q;
      patches_second_q <= select_3504;
      patches_following_q <= equal_2249 ? {2'h0, and_3505} : {equal_2251, select_3508};
      patches_following_beats_q <= {select_3520, not_3511};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2281);
      patches_ends_q <= not_3523 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3528;
      patches_code_row_q <= select_3530;
      patches_column_q <= or_3499 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3523 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_505_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_509_s1_q;
  logic and_517_s1_q;
  logic equal_523_s1_q;
  logic [6:0] select_538_s1_q;
  logic [6:0] last_s1_2_q;
  logic and_542_s1_q;
  logic and_544_s1_q;
  logic equal_569_s1_q;
  logic so_s1_q;
  logic equal_573_s1_q;
  logic or_574_s1_q;
  logic less_577_s1_q;
  logic not_578_s1_q;
  logic equal_588_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_613_s1_q;
  logic [6:0] right_s1_q;
  logic and_648_s1_q;
  logic [5:0] row_s1_q;
  logic and_2034_s1_q;
  logic equal_2035_s1_q;
  logic and_2158_s1_q;
  logic equal_2249_s1_q;
  logic not_2250_s1_q;
  logic equal_2251_s1_q;
  logic not_2252_s1_q;
  logic equal_2253_s1_q;
  logic equal_2254_s1_q;
  logic or_2255_s1_q;
  logic not_2256_s1_q;
  logic [4:0] select_2279_s1_q;
  logic select_2285_s1_q;
  logic [3:0] select_2325_s1_q;
  logic and_2335_s1_q;
  logic equal_2935_s1_q;
  logic and_2936_s1_q;
  logic or_3499_s1_q;
  logic not_3523_s1_q;
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
      select_505_s1_q <= select_505;
      row_starts_s1_q <= row_starts;
      select_509_s1_q <= select_509;
      and_517_s1_q <= and_517;
      equal_523_s1_q <= select_522 == 3'h0;
      select_538_s1_q <= select_538;
      last_s1_2_q <= last;
      and_542_s1_q <= and_542;
      and_544_s1_q <= and_544;
      equal_569_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_573_s1_q <= equal_573;
      or_574_s1_q <= or_574;
      less_577_s1_q <= less_577;
      not_578_s1_q <= not_578;
      equal_588_s1_q <= equal_588;
      x_s1_2_q <= x[6:0];
      select_613_s1_q <= select_613;
      right_s1_q <= right;
      and_648_s1_q <= and_648;
      row_s1_q <= row;
      and_2034_s1_q <= not_645 & and_612;
      equal_2035_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2158_s1_q <= and_2158;
      equal_2249_s1_q <= equal_2249;
      not_2250_s1_q <= not_2250;
      equal_2251_s1_q <= equal_2251;
      not_2252_s1_q <= not_2252;
      equal_2253_s1_q <= equal_2253;
      equal_2254_s1_q <= equal_2254;
      or_2255_s1_q <= or_2255;
      not_2256_s1_q <= not_2256;
      select_2279_s1_q <= select_2279;
      select_2285_s1_q <= select_2285;
      select_2325_s1_q <= select_2325;
      and_2335_s1_q <= and_2335;
      equal_2935_s1_q <= equal_2935;
      and_2936_s1_q <= and_2936;
      or_3499_s1_q <= or_3499;
      not_3523_s1_q <= not_3523;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic late_q;
  logic draws_late_q;
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
  // hls/stages/census.hpp:127
  logic and_518;
  assign and_518 = sample_pair_whole_s1_q & and_517_s1_q;
  // hls/stages/agreement.hpp:675
  logic equal_563;
  assign equal_563 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_564;
  assign equal_564 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_563 & equal_564;
  // hls/stages/moments.hpp:57
  logic [13:0] select_567;
  assign select_567 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:795
  logic [12:0] select_568;
  assign select_568 = first ? 13'h0 : select_567[12:0];
  // hls/stages/agreement.hpp:1016
  logic not_570;
  assign not_570 = ~equal_569_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_572;
  assign not_572 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_574_s1_q & not_578_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_567[13:6];
  // hls/stages/moments.hpp:104
  logic not_582;
  assign not_582 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:795
  logic and_586;
  assign and_586 = not_570 & (not_572 & (equal_573_s1_q & (inside_v & not_582)));
  // hls/stages/agreement.hpp:982
  logic and_603;
  assign and_603 = (or_574_s1_q & (left_rdata_q[67] & not_578_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:973
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:974
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:975
  logic [6:0] select_622;
  assign select_622 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:676
  logic or_746;
  assign or_746 = late_q | (~equal_563);
  // hls/stages/agreement.hpp:678
  logic and_747;
  assign and_747 = left_rdata_q[12] & or_746;
  logic and_748;
  assign and_748 = left_rdata_q[30] & or_746;
  logic and_749;
  assign and_749 = left_rdata_q[48] & or_746;
  logic and_750;
  assign and_750 = left_rdata_q[66] & or_746;
  // hls/stages/agreement.hpp:679
  logic and_751;
  assign and_751 = right_codes_rdata_q[12] & or_746;
  logic and_752;
  assign and_752 = right_codes_rdata_q[27] & or_746;
  logic and_753;
  assign and_753 = right_codes_rdata_q[42] & or_746;
  logic and_754;
  assign and_754 = right_codes_rdata_q[57] & or_746;
  logic and_755;
  assign and_755 = right_codes_rdata_q[72] & or_746;
  logic and_756;
  assign and_756 = right_codes_rdata_q[85] & or_746;
  // hls/stages/agreement.hpp:221
  logic and_761;
  assign and_761 = left_rdata_q[48] & not_578_s1_q;
  logic and_762;
  assign and_762 = right_codes_rdata_q[42] & not_578_s1_q;
  logic [11:0] select_763;
  assign select_763 = less_577_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_764;
  assign select_764 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_768;
  assign select_768 = and_761 ? (and_762 ? (~(select_763 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_774;
  assign parity_774 = ^select_768[5:3];
  logic parity_777;
  assign parity_777 = ^select_768[8:6];
  logic parity_780;
  assign parity_780 = ^select_768[11:3];
  // hls/stages/agreement.hpp:221
  logic and_784;
  assign and_784 = left_rdata_q[66] & not_578_s1_q;
  logic and_785;
  assign and_785 = right_codes_rdata_q[57] & not_578_s1_q;
  logic [11:0] select_786;
  assign select_786 = less_577_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_787;
  assign select_787 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_791;
  assign select_791 = and_784 ? (and_785 ? (~(select_786 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_794;
  assign parity_794 = ^select_791[8:6];
  logic parity_797;
  assign parity_797 = ^select_791[11:9];
  // hls/stages/agreement.hpp:221
  logic and_801;
  assign and_801 = left_rdata_q[84] & not_578_s1_q;
  logic and_802;
  assign and_802 = right_codes_rdata_q[72] & not_578_s1_q;
  logic [11:0] select_803;
  assign select_803 = less_577_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_804;
  assign select_804 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_808;
  assign select_808 = and_801 ? (and_802 ? (~(select_803 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_814;
  assign parity_814 = ^select_808[2:0];
  logic parity_817;
  assign parity_817 = ^select_808[5:3];
  logic parity_820;
  assign parity_820 = ^select_808[8:0];
  logic parity_826;
  assign parity_826 = ^select_808[11:9];
  logic parity_829;
  assign parity_829 = ^select_791[2:0];
  logic parity_832;
  assign parity_832 = ^{select_808[11:9], select_791[5:0]};
  logic parity_835;
  assign parity_835 = ^{select_808, select_791, select_768[2:0]};
  logic xor_836;
  assign xor_836 = parity_780 ^ parity_835;
  // hls/stages/count_bits.hpp:23
  logic or_840;
  assign or_840 = (select_768[1:0] == 2'h3) | (select_768[2] & (select_768[0] | select_768[1]));
  // hls/stages/count_bits.hpp:25
  logic or_844;
  assign or_844 = (select_791[7:6] == 2'h3) | (select_791[8] & (select_791[6] | select_791[7]));
  logic or_848;
  assign or_848 = (select_791[10:9] == 2'h3) | (select_791[11] & (select_791[9] | select_791[10]));
  // hls/stages/count_bits.hpp:23
  logic or_856;
  assign or_856 = (select_808[7:6] == 2'h3) | (select_808[8] & (~(select_808[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_860;
  assign or_860 = (select_808[1:0] == 2'h3) | (select_808[2] & (select_808[0] | select_808[1]));
  logic or_864;
  assign or_864 = (select_808[4:3] == 2'h3) | (select_808[5] & (select_808[3] | select_808[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_867;
  assign parity_867 = ^{or_864, or_860, or_856};
  // hls/stages/count_bits.hpp:23
  logic or_871;
  assign or_871 = (select_791[4:3] == 2'h3) | (select_791[5] & (select_791[3] | select_791[4]));
  // hls/stages/count_bits.hpp:25
  logic or_875;
  assign or_875 = (select_808[10:9] == 2'h3) | (select_808[11] & (select_808[9] | select_808[10]));
  logic or_879;
  assign or_879 = (select_791[1:0] == 2'h3) | (select_791[2] & (select_791[0] | select_791[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_882;
  assign parity_882 = ^{or_879, or_875, or_871};
  logic parity_885;
  assign parity_885 = ^{or_879, or_875, or_871, or_864, or_860, or_856, or_848, or_844, or_840};
  // hls/stages/count_bits.hpp:25
  logic and_886;
  assign and_886 = parity_780 & parity_835;
  logic or_890;
  assign or_890 = (parity_774 & parity_777) | ((^select_768[11:9]) & (parity_774 | parity_777));
  logic and_893;
  assign and_893 = (^{select_791[11:6], select_768[2:0]}) & (parity_820 | parity_832);
  logic or_894;
  assign or_894 = (parity_820 & parity_832) | and_893;
  // hls/stages/count_bits.hpp:23
  logic or_901;
  assign or_901 = (select_768[10:9] == 2'h3) | (select_768[11] & (select_768[9] | select_768[10]));
  // hls/stages/count_bits.hpp:25
  logic or_905;
  assign or_905 = (select_768[4:3] == 2'h3) | (select_768[5] & (select_768[3] | select_768[4]));
  logic or_909;
  assign or_909 = (select_768[7:6] == 2'h3) | (select_768[8] & (select_768[6] | select_768[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_912;
  assign parity_912 = ^{or_909, or_905, or_901};
  // hls/stages/count_bits.hpp:25
  logic or_916;
  assign or_916 = (parity_794 & parity_797) | ((^select_768[2:0]) & (parity_794 | parity_797));
  logic or_920;
  assign or_920 = (parity_814 & parity_817) | ((^select_808[8:6]) & (parity_814 | parity_817));
  logic or_924;
  assign or_924 = (parity_826 & parity_829) | ((^select_791[5:3]) & (parity_826 | parity_829));
  // hls/stages/count_bits.hpp:24
  logic parity_927;
  assign parity_927 = ^{or_924, or_920, or_916};
  logic parity_930;
  assign parity_930 = ^{or_924, or_920, or_916, or_909, or_905, or_901, or_894, or_890, and_886};
  logic xor_931;
  assign xor_931 = parity_885 ^ parity_930;
  // hls/stages/count_bits.hpp:25
  logic and_932;
  assign and_932 = parity_885 & parity_930;
  logic or_936;
  assign or_936 = (parity_867 & parity_882) | ((^{or_848, or_844, or_840}) & (parity_867 | parity_882));
  logic or_940;
  assign or_940 = (parity_912 & parity_927) | ((^{or_894, or_890, and_886}) & (parity_912 | parity_927));
  logic or_947;
  assign or_947 = (or_844 & or_848) | (or_840 & (or_844 | or_848));
  logic or_951;
  assign or_951 = (or_860 & or_864) | (or_856 & (or_860 | or_864));
  logic or_955;
  assign or_955 = (or_875 & or_879) | (or_871 & (or_875 | or_879));
  // hls/stages/count_bits.hpp:24
  logic parity_958;
  assign parity_958 = ^{or_955, or_951, or_947};
  // hls/stages/count_bits.hpp:25
  logic or_962;
  assign or_962 = (or_890 & or_894) | (and_886 & (or_890 | or_894));
  logic or_966;
  assign or_966 = (or_905 & or_909) | (or_901 & (or_905 | or_909));
  logic or_970;
  assign or_970 = (or_920 & or_924) | (or_916 & (or_920 | or_924));
  // hls/stages/count_bits.hpp:24
  logic parity_973;
  assign parity_973 = ^{or_970, or_966, or_962};
  logic parity_976;
  assign parity_976 = ^{or_970, or_966, or_962, or_955, or_951, or_947, or_940, or_936, and_932};
  // hls/stages/count_bits.hpp:25
  logic or_980;
  assign or_980 = (parity_958 & parity_973) | ((^{or_940, or_936, and_932}) & (parity_958 | parity_973));
  logic or_984;
  assign or_984 = (or_936 & or_940) | (and_932 & (or_936 | or_940));
  logic or_988;
  assign or_988 = (or_951 & or_955) | (or_947 & (or_951 | or_955));
  logic or_992;
  assign or_992 = (or_966 & or_970) | (or_962 & (or_966 | or_970));
  // hls/stages/count_bits.hpp:24
  logic parity_997;
  assign parity_997 = ^{or_992, or_988, or_984, or_980};
  // hls/stages/count_bits.hpp:25
  logic or_1001;
  assign or_1001 = (or_988 & or_992) | (or_984 & (or_988 | or_992));
  logic and_1002;
  assign and_1002 = or_980 & (^{or_992, or_988, or_984});
  // hls/stages/count_bits.hpp:24
  logic xor_1003;
  assign xor_1003 = or_1001 ^ and_1002;
  // hls/stages/count_bits.hpp:27
  logic and_1004;
  assign and_1004 = or_1001 & and_1002;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1005;
  assign select_1005 = equal_588_s1_q ? {and_1004, xor_1003, parity_997, parity_976, xor_931, xor_836} : 6'h0;
  logic [5:0] column;
  assign column = or_574_s1_q ? 6'h0 : select_1005;
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1007;
  assign select_1007 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1008;
  assign difference_1008 = {1'b0, column} - {1'b0, select_1007};
  logic [7:0] sum_1010;
  assign sum_1010 = {difference_1008[6], difference_1008} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1014;
  assign select_1014 = and_761 ? (and_785 ? (~(select_763 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1020;
  assign parity_1020 = ^select_1014[5:3];
  logic parity_1023;
  assign parity_1023 = ^select_1014[8:6];
  logic parity_1026;
  assign parity_1026 = ^select_1014[11:3];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1033;
  assign select_1033 = and_784 ? (and_802 ? (~(select_786 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1036;
  assign parity_1036 = ^select_1033[8:6];
  logic parity_1039;
  assign parity_1039 = ^select_1033[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1043;
  assign and_1043 = right_codes_rdata_q[85] & not_578_s1_q;
  logic [11:0] select_1044;
  assign select_1044 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1048;
  assign select_1048 = and_801 ? (and_1043 ? (~(select_803 ^ select_1044)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1054;
  assign parity_1054 = ^select_1048[2:0];
  logic parity_1057;
  assign parity_1057 = ^select_1048[5:3];
  logic parity_1060;
  assign parity_1060 = ^select_1048[8:0];
  logic parity_1066;
  assign parity_1066 = ^select_1048[11:9];
  logic parity_1069;
  assign parity_1069 = ^select_1033[2:0];
  logic parity_1072;
  assign parity_1072 = ^{select_1048[11:9], select_1033[5:0]};
  logic parity_1075;
  assign parity_1075 = ^{select_1048, select_1033, select_1014[2:0]};
  logic xor_1076;
  assign xor_1076 = parity_1026 ^ parity_1075;
  // hls/stages/count_bits.hpp:23
  logic or_1080;
  assign or_1080 = (select_1014[1:0] == 2'h3) | (select_1014[2] & (select_1014[0] | select_1014[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1084;
  assign or_1084 = (select_1033[7:6] == 2'h3) | (select_1033[8] & (select_1033[6] | select_1033[7]));
  logic or_1088;
  assign or_1088 = (select_1033[10:9] == 2'h3) | (select_1033[11] & (select_1033[9] | select_1033[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1096;
  assign or_1096 = (select_1048[7:6] == 2'h3) | (select_1048[8] & (~(select_1048[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1100;
  assign or_1100 = (select_1048[1:0] == 2'h3) | (select_1048[2] & (select_1048[0] | select_1048[1]));
  logic or_1104;
  assign or_1104 = (select_1048[4:3] == 2'h3) | (select_1048[5] & (select_1048[3] | select_1048[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1107;
  assign parity_1107 = ^{or_1104, or_1100, or_1096};
  // hls/stages/count_bits.hpp:23
  logic or_1111;
  assign or_1111 = (select_1033[4:3] == 2'h3) | (select_1033[5] & (select_1033[3] | select_1033[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1115;
  assign or_1115 = (select_1048[10:9] == 2'h3) | (select_1048[11] & (select_1048[9] | select_1048[10]));
  logic or_1119;
  assign or_1119 = (select_1033[1:0] == 2'h3) | (select_1033[2] & (select_1033[0] | select_1033[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1122;
  assign parity_1122 = ^{or_1119, or_1115, or_1111};
  logic parity_1125;
  assign parity_1125 = ^{or_1119, or_1115, or_1111, or_1104, or_1100, or_1096, or_1088, or_1084, or_1080};
  // hls/stages/count_bits.hpp:25
  logic and_1126;
  assign and_1126 = parity_1026 & parity_1075;
  logic or_1130;
  assign or_1130 = (parity_1020 & parity_1023) | ((^select_1014[11:9]) & (parity_1020 | parity_1023));
  logic and_1133;
  assign and_1133 = (^{select_1033[11:6], select_1014[2:0]}) & (parity_1060 | parity_1072);
  logic or_1134;
  assign or_1134 = (parity_1060 & parity_1072) | and_1133;
  // hls/stages/count_bits.hpp:23
  logic or_1141;
  assign or_1141 = (select_1014[10:9] == 2'h3) | (select_1014[11] & (select_1014[9] | select_1014[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1145;
  assign or_1145 = (select_1014[4:3] == 2'h3) | (select_1014[5] & (select_1014[3] | select_1014[4]));
  logic or_1149;
  assign or_1149 = (select_1014[7:6] == 2'h3) | (select_1014[8] & (select_1014[6] | select_1014[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1152;
  assign parity_1152 = ^{or_1149, or_1145, or_1141};
  // hls/stages/count_bits.hpp:25
  logic or_1156;
  assign or_1156 = (parity_1036 & parity_1039) | ((^select_1014[2:0]) & (parity_1036 | parity_1039));
  logic or_1160;
  assign or_1160 = (parity_1054 & parity_1057) | ((^select_1048[8:6]) & (parity_1054 | parity_1057));
  logic or_1164;
  assign or_1164 = (parity_1066 & parity_1069) | ((^select_1033[5:3]) & (parity_1066 | parity_1069));
  // hls/stages/count_bits.hpp:24
  logic parity_1167;
  assign parity_1167 = ^{or_1164, or_1160, or_1156};
  logic parity_1170;
  assign parity_1170 = ^{or_1164, or_1160, or_1156, or_1149, or_1145, or_1141, or_1134, or_1130, and_1126};
  logic xor_1171;
  assign xor_1171 = parity_1125 ^ parity_1170;
  // hls/stages/count_bits.hpp:25
  logic and_1172;
  assign and_1172 = parity_1125 & parity_1170;
  logic or_1176;
  assign or_1176 = (parity_1107 & parity_1122) | ((^{or_1088, or_1084, or_1080}) & (parity_1107 | parity_1122));
  logic or_1180;
  assign or_1180 = (parity_1152 & parity_1167) | ((^{or_1134, or_1130, and_1126}) & (parity_1152 | parity_1167));
  logic or_1187;
  assign or_1187 = (or_1084 & or_1088) | (or_1080 & (or_1084 | or_1088));
  logic or_1191;
  assign or_1191 = (or_1100 & or_1104) | (or_1096 & (or_1100 | or_1104));
  logic or_1195;
  assign or_1195 = (or_1115 & or_1119) | (or_1111 & (or_1115 | or_1119));
  // hls/stages/count_bits.hpp:24
  logic parity_1198;
  assign parity_1198 = ^{or_1195, or_1191, or_1187};
  // hls/stages/count_bits.hpp:25
  logic or_1202;
  assign or_1202 = (or_1130 & or_1134) | (and_1126 & (or_1130 | or_1134));
  logic or_1206;
  assign or_1206 = (or_1145 & or_1149) | (or_1141 & (or_1145 | or_1149));
  logic or_1210;
  assign or_1210 = (or_1160 & or_1164) | (or_1156 & (or_1160 | or_1164));
  // hls/stages/count_bits.hpp:24
  logic parity_1213;
  assign parity_1213 = ^{or_1210, or_1206, or_1202};
  logic parity_1216;
  assign parity_1216 = ^{or_1210, or_1206, or_1202, or_1195, or_1191, or_1187, or_1180, or_1176, and_1172};
  // hls/stages/count_bits.hpp:25
  logic or_1220;
  assign or_1220 = (parity_1198 & parity_1213) | ((^{or_1180, or_1176, and_1172}) & (parity_1198 | parity_1213));
  logic or_1224;
  assign or_1224 = (or_1176 & or_1180) | (and_1172 & (or_1176 | or_1180));
  logic or_1228;
  assign or_1228 = (or_1191 & or_1195) | (or_1187 & (or_1191 | or_1195));
  logic or_1232;
  assign or_1232 = (or_1206 & or_1210) | (or_1202 & (or_1206 | or_1210));
  // hls/stages/count_bits.hpp:24
  logic parity_1237;
  assign parity_1237 = ^{or_1232, or_1228, or_1224, or_1220};
  // hls/stages/count_bits.hpp:25
  logic or_1241;
  assign or_1241 = (or_1228 & or_1232) | (or_1224 & (or_1228 | or_1232));
  logic and_1242;
  assign and_1242 = or_1220 & (^{or_1232, or_1228, or_1224});
  // hls/stages/count_bits.hpp:24
  logic xor_1243;
  assign xor_1243 = or_1241 ^ and_1242;
  // hls/stages/count_bits.hpp:27
  logic and_1244;
  assign and_1244 = or_1241 & and_1242;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1245;
  assign select_1245 = equal_588_s1_q ? {and_1244, xor_1243, parity_1237, parity_1216, xor_1171, xor_1076} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_574_s1_q ? 6'h0 : select_1245;
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1247;
  assign select_1247 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1248;
  assign difference_1248 = {1'b0, column_2} - {1'b0, select_1247};
  logic [7:0] sum_1250;
  assign sum_1250 = {difference_1248[6], difference_1248} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1251;
  assign and_1251 = right_codes_rdata_q[27] & not_578_s1_q;
  logic [11:0] select_1252;
  assign select_1252 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1256;
  assign select_1256 = and_761 ? (and_1251 ? (~(select_763 ^ select_1252)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1262;
  assign parity_1262 = ^select_1256[5:3];
  logic parity_1265;
  assign parity_1265 = ^select_1256[8:6];
  logic parity_1268;
  assign parity_1268 = ^select_1256[11:3];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1275;
  assign select_1275 = and_784 ? (and_762 ? (~(select_786 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1275[8:6];
  logic parity_1281;
  assign parity_1281 = ^select_1275[11:9];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1288;
  assign select_1288 = and_801 ? (and_785 ? (~(select_803 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1294;
  assign parity_1294 = ^select_1288[2:0];
  logic parity_1297;
  assign parity_1297 = ^select_1288[5:3];
  logic parity_1300;
  assign parity_1300 = ^select_1288[8:0];
  logic parity_1306;
  assign parity_1306 = ^select_1288[11:9];
  logic parity_1309;
  assign parity_1309 = ^select_1275[2:0];
  logic parity_1312;
  assign parity_1312 = ^{select_1288[11:9], select_1275[5:0]};
  logic parity_1315;
  assign parity_1315 = ^{select_1288, select_1275, select_1256[2:0]};
  logic xor_1316;
  assign xor_1316 = parity_1268 ^ parity_1315;
  // hls/stages/count_bits.hpp:23
  logic or_1320;
  assign or_1320 = (select_1256[1:0] == 2'h3) | (select_1256[2] & (select_1256[0] | select_1256[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1324;
  assign or_1324 = (select_1275[7:6] == 2'h3) | (select_1275[8] & (select_1275[6] | select_1275[7]));
  logic or_1328;
  assign or_1328 = (select_1275[10:9] == 2'h3) | (select_1275[11] & (select_1275[9] | select_1275[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1336;
  assign or_1336 = (select_1288[7:6] == 2'h3) | (select_1288[8] & (~(select_1288[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1340;
  assign or_1340 = (select_1288[1:0] == 2'h3) | (select_1288[2] & (select_1288[0] | select_1288[1]));
  logic or_1344;
  assign or_1344 = (select_1288[4:3] == 2'h3) | (select_1288[5] & (select_1288[3] | select_1288[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1347;
  assign parity_1347 = ^{or_1344, or_1340, or_1336};
  // hls/stages/count_bits.hpp:23
  logic or_1351;
  assign or_1351 = (select_1275[4:3] == 2'h3) | (select_1275[5] & (select_1275[3] | select_1275[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1355;
  assign or_1355 = (select_1288[10:9] == 2'h3) | (select_1288[11] & (select_1288[9] | select_1288[10]));
  logic or_1359;
  assign or_1359 = (select_1275[1:0] == 2'h3) | (select_1275[2] & (select_1275[0] | select_1275[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1362;
  assign parity_1362 = ^{or_1359, or_1355, or_1351};
  logic parity_1365;
  assign parity_1365 = ^{or_1359, or_1355, or_1351, or_1344, or_1340, or_1336, or_1328, or_1324, or_1320};
  // hls/stages/count_bits.hpp:25
  logic and_1366;
  assign and_1366 = parity_1268 & parity_1315;
  logic or_1370;
  assign or_1370 = (parity_1262 & parity_1265) | ((^select_1256[11:9]) & (parity_1262 | parity_1265));
  logic and_1373;
  assign and_1373 = (^{select_1275[11:6], select_1256[2:0]}) & (parity_1300 | parity_1312);
  logic or_1374;
  assign or_1374 = (parity_1300 & parity_1312) | and_1373;
  // hls/stages/count_bits.hpp:23
  logic or_1381;
  assign or_1381 = (select_1256[10:9] == 2'h3) | (select_1256[11] & (select_1256[9] | select_1256[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1385;
  assign or_1385 = (select_1256[4:3] == 2'h3) | (select_1256[5] & (select_1256[3] | select_1256[4]));
  logic or_1389;
  assign or_1389 = (select_1256[7:6] == 2'h3) | (select_1256[8] & (select_1256[6] | select_1256[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1392;
  assign parity_1392 = ^{or_1389, or_1385, or_1381};
  // hls/stages/count_bits.hpp:25
  logic or_1396;
  assign or_1396 = (parity_1278 & parity_1281) | ((^select_1256[2:0]) & (parity_1278 | parity_1281));
  logic or_1400;
  assign or_1400 = (parity_1294 & parity_1297) | ((^select_1288[8:6]) & (parity_1294 | parity_1297));
  logic or_1404;
  assign or_1404 = (parity_1306 & parity_1309) | ((^select_1275[5:3]) & (parity_1306 | parity_1309));
  // hls/stages/count_bits.hpp:24
  logic parity_1407;
  assign parity_1407 = ^{or_1404, or_1400, or_1396};
  logic parity_1410;
  assign parity_1410 = ^{or_1404, or_1400, or_1396, or_1389, or_1385, or_1381, or_1374, or_1370, and_1366};
  logic xor_1411;
  assign xor_1411 = parity_1365 ^ parity_1410;
  // hls/stages/count_bits.hpp:25
  logic and_1412;
  assign and_1412 = parity_1365 & parity_1410;
  logic or_1416;
  assign or_1416 = (parity_1347 & parity_1362) | ((^{or_1328, or_1324, or_1320}) & (parity_1347 | parity_1362));
  logic or_1420;
  assign or_1420 = (parity_1392 & parity_1407) | ((^{or_1374, or_1370, and_1366}) & (parity_1392 | parity_1407));
  logic or_1427;
  assign or_1427 = (or_1324 & or_1328) | (or_1320 & (or_1324 | or_1328));
  logic or_1431;
  assign or_1431 = (or_1340 & or_1344) | (or_1336 & (or_1340 | or_1344));
  logic or_1435;
  assign or_1435 = (or_1355 & or_1359) | (or_1351 & (or_1355 | or_1359));
  // hls/stages/count_bits.hpp:24
  logic parity_1438;
  assign parity_1438 = ^{or_1435, or_1431, or_1427};
  // hls/stages/count_bits.hpp:25
  logic or_1442;
  assign or_1442 = (or_1370 & or_1374) | (and_1366 & (or_1370 | or_1374));
  logic or_1446;
  assign or_1446 = (or_1385 & or_1389) | (or_1381 & (or_1385 | or_1389));
  logic or_1450;
  assign or_1450 = (or_1400 & or_1404) | (or_1396 & (or_1400 | or_1404));
  // hls/stages/count_bits.hpp:24
  logic parity_1453;
  assign parity_1453 = ^{or_1450, or_1446, or_1442};
  logic parity_1456;
  assign parity_1456 = ^{or_1450, or_1446, or_1442, or_1435, or_1431, or_1427, or_1420, or_1416, and_1412};
  // hls/stages/count_bits.hpp:25
  logic or_1460;
  assign or_1460 = (parity_1438 & parity_1453) | ((^{or_1420, or_1416, and_1412}) & (parity_1438 | parity_1453));
  logic or_1464;
  assign or_1464 = (or_1416 & or_1420) | (and_1412 & (or_1416 | or_1420));
  logic or_1468;
  assign or_1468 = (or_1431 & or_1435) | (or_1427 & (or_1431 | or_1435));
  logic or_1472;
  assign or_1472 = (or_1446 & or_1450) | (or_1442 & (or_1446 | or_1450));
  // hls/stages/count_bits.hpp:24
  logic parity_1477;
  assign parity_1477 = ^{or_1472, or_1468, or_1464, or_1460};
  // hls/stages/count_bits.hpp:25
  logic or_1481;
  assign or_1481 = (or_1468 & or_1472) | (or_1464 & (or_1468 | or_1472));
  logic and_1482;
  assign and_1482 = or_1460 & (^{or_1472, or_1468, or_1464});
  // hls/stages/count_bits.hpp:24
  logic xor_1483;
  assign xor_1483 = or_1481 ^ and_1482;
  // hls/stages/count_bits.hpp:27
  logic and_1484;
  assign and_1484 = or_1481 & and_1482;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1485;
  assign select_1485 = equal_588_s1_q ? {and_1484, xor_1483, parity_1477, parity_1456, xor_1411, xor_1316} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_574_s1_q ? 6'h0 : select_1485;
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1487;
  assign select_1487 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1488;
  assign difference_1488 = {1'b0, column_3} - {1'b0, select_1487};
  logic [7:0] sum_1490;
  assign sum_1490 = {difference_1488[6], difference_1488} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1498;
  assign select_1498 = and_761 ? (and_802 ? (~(select_763 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1504;
  assign parity_1504 = ^select_1498[5:3];
  logic parity_1507;
  assign parity_1507 = ^select_1498[8:6];
  logic parity_1510;
  assign parity_1510 = ^select_1498[11:3];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1517;
  assign select_1517 = and_784 ? (and_1043 ? (~(select_786 ^ select_1044)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1520;
  assign parity_1520 = ^select_1517[8:6];
  logic parity_1523;
  assign parity_1523 = ^select_1517[11:9];
  // hls/stages/agreement.hpp:691
  logic [11:0] xor_1529;
  assign xor_1529 = select_803 ^ (less_577_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1532;
  assign select_1532 = and_801 ? ((right_codes_rdata_q[98] & not_578_s1_q) ? (~xor_1529) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1538;
  assign parity_1538 = ^select_1532[2:0];
  logic parity_1541;
  assign parity_1541 = ^select_1532[5:3];
  logic parity_1544;
  assign parity_1544 = ^select_1532[8:0];
  logic parity_1550;
  assign parity_1550 = ^select_1532[11:9];
  logic parity_1553;
  assign parity_1553 = ^select_1517[2:0];
  logic parity_1556;
  assign parity_1556 = ^{select_1532[11:9], select_1517[5:0]};
  logic parity_1559;
  assign parity_1559 = ^{select_1532, select_1517, select_1498[2:0]};
  logic xor_1560;
  assign xor_1560 = parity_1510 ^ parity_1559;
  // hls/stages/count_bits.hpp:23
  logic or_1564;
  assign or_1564 = (select_1498[1:0] == 2'h3) | (select_1498[2] & (select_1498[0] | select_1498[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1568;
  assign or_1568 = (select_1517[7:6] == 2'h3) | (select_1517[8] & (select_1517[6] | select_1517[7]));
  logic or_1572;
  assign or_1572 = (select_1517[10:9] == 2'h3) | (select_1517[11] & (select_1517[9] | select_1517[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1580;
  assign or_1580 = (select_1532[7:6] == 2'h3) | (select_1532[8] & (~(select_1532[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1584;
  assign or_1584 = (select_1532[1:0] == 2'h3) | (select_1532[2] & (select_1532[0] | select_1532[1]));
  logic or_1588;
  assign or_1588 = (select_1532[4:3] == 2'h3) | (select_1532[5] & (select_1532[3] | select_1532[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1591;
  assign parity_1591 = ^{or_1588, or_1584, or_1580};
  // hls/stages/count_bits.hpp:23
  logic or_1595;
  assign or_1595 = (select_1517[4:3] == 2'h3) | (select_1517[5] & (select_1517[3] | select_1517[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1599;
  assign or_1599 = (select_1532[10:9] == 2'h3) | (select_1532[11] & (select_1532[9] | select_1532[10]));
  logic or_1603;
  assign or_1603 = (select_1517[1:0] == 2'h3) | (select_1517[2] & (select_1517[0] | select_1517[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1606;
  assign parity_1606 = ^{or_1603, or_1599, or_1595};
  logic parity_1609;
  assign parity_1609 = ^{or_1603, or_1599, or_1595, or_1588, or_1584, or_1580, or_1572, or_1568, or_1564};
  // hls/stages/count_bits.hpp:25
  logic and_1610;
  assign and_1610 = parity_1510 & parity_1559;
  logic or_1614;
  assign or_1614 = (parity_1504 & parity_1507) | ((^select_1498[11:9]) & (parity_1504 | parity_1507));
  logic and_1617;
  assign and_1617 = (^{select_1517[11:6], select_1498[2:0]}) & (parity_1544 | parity_1556);
  logic or_1618;
  assign or_1618 = (parity_1544 & parity_1556) | and_1617;
  // hls/stages/count_bits.hpp:23
  logic or_1625;
  assign or_1625 = (select_1498[10:9] == 2'h3) | (select_1498[11] & (select_1498[9] | select_1498[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1629;
  assign or_1629 = (select_1498[4:3] == 2'h3) | (select_1498[5] & (select_1498[3] | select_1498[4]));
  logic or_1633;
  assign or_1633 = (select_1498[7:6] == 2'h3) | (select_1498[8] & (select_1498[6] | select_1498[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1636;
  assign parity_1636 = ^{or_1633, or_1629, or_1625};
  // hls/stages/count_bits.hpp:25
  logic or_1640;
  assign or_1640 = (parity_1520 & parity_1523) | ((^select_1498[2:0]) & (parity_1520 | parity_1523));
  logic or_1644;
  assign or_1644 = (parity_1538 & parity_1541) | ((^select_1532[8:6]) & (parity_1538 | parity_1541));
  logic or_1648;
  assign or_1648 = (parity_1550 & parity_1553) | ((^select_1517[5:3]) & (parity_1550 | parity_1553));
  // hls/stages/count_bits.hpp:24
  logic parity_1651;
  assign parity_1651 = ^{or_1648, or_1644, or_1640};
  logic parity_1654;
  assign parity_1654 = ^{or_1648, or_1644, or_1640, or_1633, or_1629, or_1625, or_1618, or_1614, and_1610};
  logic xor_1655;
  assign xor_1655 = parity_1609 ^ parity_1654;
  // hls/stages/count_bits.hpp:25
  logic and_1656;
  assign and_1656 = parity_1609 & parity_1654;
  logic or_1660;
  assign or_1660 = (parity_1591 & parity_1606) | ((^{or_1572, or_1568, or_1564}) & (parity_1591 | parity_1606));
  logic or_1664;
  assign or_1664 = (parity_1636 & parity_1651) | ((^{or_1618, or_1614, and_1610}) & (parity_1636 | parity_1651));
  logic or_1671;
  assign or_1671 = (or_1568 & or_1572) | (or_1564 & (or_1568 | or_1572));
  logic or_1675;
  assign or_1675 = (or_1584 & or_1588) | (or_1580 & (or_1584 | or_1588));
  logic or_1679;
  assign or_1679 = (or_1599 & or_1603) | (or_1595 & (or_1599 | or_1603));
  // hls/stages/count_bits.hpp:24
  logic parity_1682;
  assign parity_1682 = ^{or_1679, or_1675, or_1671};
  // hls/stages/count_bits.hpp:25
  logic or_1686;
  assign or_1686 = (or_1614 & or_1618) | (and_1610 & (or_1614 | or_1618));
  logic or_1690;
  assign or_1690 = (or_1629 & or_1633) | (or_1625 & (or_1629 | or_1633));
  logic or_1694;
  assign or_1694 = (or_1644 & or_1648) | (or_1640 & (or_1644 | or_1648));
  // hls/stages/count_bits.hpp:24
  logic parity_1697;
  assign parity_1697 = ^{or_1694, or_1690, or_1686};
  logic parity_1700;
  assign parity_1700 = ^{or_1694, or_1690, or_1686, or_1679, or_1675, or_1671, or_1664, or_1660, and_1656};
  // hls/stages/count_bits.hpp:25
  logic or_1704;
  assign or_1704 = (parity_1682 & parity_1697) | ((^{or_1664, or_1660, and_1656}) & (parity_1682 | parity_1697));
  logic or_1708;
  assign or_1708 = (or_1660 & or_1664) | (and_1656 & (or_1660 | or_1664));
  logic or_1712;
  assign or_1712 = (or_1675 & or_1679) | (or_1671 & (or_1675 | or_1679));
  logic or_1716;
  assign or_1716 = (or_1690 & or_1694) | (or_1686 & (or_1690 | or_1694));
  // hls/stages/count_bits.hpp:24
  logic parity_1721;
  assign parity_1721 = ^{or_1716, or_1712, or_1708, or_1704};
  // hls/stages/count_bits.hpp:25
  logic or_1725;
  assign or_1725 = (or_1712 & or_1716) | (or_1708 & (or_1712 | or_1716));
  logic and_1726;
  assign and_1726 = or_1704 & (^{or_1716, or_1712, or_1708});
  // hls/stages/count_bits.hpp:24
  logic xor_1727;
  assign xor_1727 = or_1725 ^ and_1726;
  // hls/stages/count_bits.hpp:27
  logic and_1728;
  assign and_1728 = or_1725 & and_1726;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1729;
  assign select_1729 = equal_588_s1_q ? {and_1728, xor_1727, parity_1721, parity_1700, xor_1655, xor_1560} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_574_s1_q ? 6'h0 : select_1729;
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1731;
  assign select_1731 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1732;
  assign difference_1732 = {1'b0, column_4} - {1'b0, select_1731};
  logic [7:0] sum_1734;
  assign sum_1734 = {difference_1732[6], difference_1732} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:691
  logic [11:0] not_1738;
  assign not_1738 = ~(select_763 ^ (less_577_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1740;
  assign select_1740 = and_761 ? ((right_codes_rdata_q[12] & not_578_s1_q) ? not_1738 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1746;
  assign parity_1746 = ^select_1740[5:3];
  logic parity_1749;
  assign parity_1749 = ^select_1740[8:6];
  logic parity_1752;
  assign parity_1752 = ^select_1740[11:3];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1759;
  assign select_1759 = and_784 ? (and_1251 ? (~(select_786 ^ select_1252)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1762;
  assign parity_1762 = ^select_1759[8:6];
  logic parity_1765;
  assign parity_1765 = ^select_1759[11:9];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1772;
  assign select_1772 = and_801 ? (and_762 ? (~(select_803 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1778;
  assign parity_1778 = ^select_1772[2:0];
  logic parity_1781;
  assign parity_1781 = ^select_1772[5:3];
  logic parity_1784;
  assign parity_1784 = ^select_1772[8:0];
  logic parity_1790;
  assign parity_1790 = ^select_1772[11:9];
  logic parity_1793;
  assign parity_1793 = ^select_1759[2:0];
  logic parity_1796;
  assign parity_1796 = ^{select_1772[11:9], select_1759[5:0]};
  logic parity_1799;
  assign parity_1799 = ^{select_1772, select_1759, select_1740[2:0]};
  logic xor_1800;
  assign xor_1800 = parity_1752 ^ parity_1799;
  // hls/stages/count_bits.hpp:23
  logic or_1804;
  assign or_1804 = (select_1740[1:0] == 2'h3) | (select_1740[2] & (select_1740[0] | select_1740[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1808;
  assign or_1808 = (select_1759[7:6] == 2'h3) | (select_1759[8] & (select_1759[6] | select_1759[7]));
  logic or_1812;
  assign or_1812 = (select_1759[10:9] == 2'h3) | (select_1759[11] & (select_1759[9] | select_1759[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1820;
  assign or_1820 = (select_1772[7:6] == 2'h3) | (select_1772[8] & (~(select_1772[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1824;
  assign or_1824 = (select_1772[1:0] == 2'h3) | (select_1772[2] & (select_1772[0] | select_1772[1]));
  logic or_1828;
  assign or_1828 = (select_1772[4:3] == 2'h3) | (select_1772[5] & (select_1772[3] | select_1772[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1831;
  assign parity_1831 = ^{or_1828, or_1824, or_1820};
  // hls/stages/count_bits.hpp:23
  logic or_1835;
  assign or_1835 = (select_1759[4:3] == 2'h3) | (select_1759[5] & (select_1759[3] | select_1759[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1839;
  assign or_1839 = (select_1772[10:9] == 2'h3) | (select_1772[11] & (select_1772[9] | select_1772[10]));
  logic or_1843;
  assign or_1843 = (select_1759[1:0] == 2'h3) | (select_1759[2] & (select_1759[0] | select_1759[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1846;
  assign parity_1846 = ^{or_1843, or_1839, or_1835};
  logic parity_1849;
  assign parity_1849 = ^{or_1843, or_1839, or_1835, or_1828, or_1824, or_1820, or_1812, or_1808, or_1804};
  // hls/stages/count_bits.hpp:25
  logic and_1850;
  assign and_1850 = parity_1752 & parity_1799;
  logic or_1854;
  assign or_1854 = (parity_1746 & parity_1749) | ((^select_1740[11:9]) & (parity_1746 | parity_1749));
  logic and_1857;
  assign and_1857 = (^{select_1759[11:6], select_1740[2:0]}) & (parity_1784 | parity_1796);
  logic or_1858;
  assign or_1858 = (parity_1784 & parity_1796) | and_1857;
  // hls/stages/count_bits.hpp:23
  logic or_1865;
  assign or_1865 = (select_1740[10:9] == 2'h3) | (select_1740[11] & (select_1740[9] | select_1740[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1869;
  assign or_1869 = (select_1740[4:3] == 2'h3) | (select_1740[5] & (select_1740[3] | select_1740[4]));
  logic or_1873;
  assign or_1873 = (select_1740[7:6] == 2'h3) | (select_1740[8] & (select_1740[6] | select_1740[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1876;
  assign parity_1876 = ^{or_1873, or_1869, or_1865};
  // hls/stages/count_bits.hpp:25
  logic or_1880;
  assign or_1880 = (parity_1762 & parity_1765) | ((^select_1740[2:0]) & (parity_1762 | parity_1765));
  logic or_1884;
  assign or_1884 = (parity_1778 & parity_1781) | ((^select_1772[8:6]) & (parity_1778 | parity_1781));
  logic or_1888;
  assign or_1888 = (parity_1790 & parity_1793) | ((^select_1759[5:3]) & (parity_1790 | parity_1793));
  // hls/stages/count_bits.hpp:24
  logic parity_1891;
  assign parity_1891 = ^{or_1888, or_1884, or_1880};
  logic parity_1894;
  assign parity_1894 = ^{or_1888, or_1884, or_1880, or_1873, or_1869, or_1865, or_1858, or_1854, and_1850};
  logic xor_1895;
  assign xor_1895 = parity_1849 ^ parity_1894;
  // hls/stages/count_bits.hpp:25
  logic and_1896;
  assign and_1896 = parity_1849 & parity_1894;
  logic or_1900;
  assign or_1900 = (parity_1831 & parity_1846) | ((^{or_1812, or_1808, or_1804}) & (parity_1831 | parity_1846));
  logic or_1904;
  assign or_1904 = (parity_1876 & parity_1891) | ((^{or_1858, or_1854, and_1850}) & (parity_1876 | parity_1891));
  logic or_1911;
  assign or_1911 = (or_1808 & or_1812) | (or_1804 & (or_1808 | or_1812));
  logic or_1915;
  assign or_1915 = (or_1824 & or_1828) | (or_1820 & (or_1824 | or_1828));
  logic or_1919;
  assign or_1919 = (or_1839 & or_1843) | (or_1835 & (or_1839 | or_1843));
  // hls/stages/count_bits.hpp:24
  logic parity_1922;
  assign parity_1922 = ^{or_1919, or_1915, or_1911};
  // hls/stages/count_bits.hpp:25
  logic or_1926;
  assign or_1926 = (or_1854 & or_1858) | (and_1850 & (or_1854 | or_1858));
  logic or_1930;
  assign or_1930 = (or_1869 & or_1873) | (or_1865 & (or_1869 | or_1873));
  logic or_1934;
  assign or_1934 = (or_1884 & or_1888) | (or_1880 & (or_1884 | or_1888));
  // hls/stages/count_bits.hpp:24
  logic parity_1937;
  assign parity_1937 = ^{or_1934, or_1930, or_1926};
  logic parity_1940;
  assign parity_1940 = ^{or_1934, or_1930, or_1926, or_1919, or_1915, or_1911, or_1904, or_1900, and_1896};
  // hls/stages/count_bits.hpp:25
  logic or_1944;
  assign or_1944 = (parity_1922 & parity_1937) | ((^{or_1904, or_1900, and_1896}) & (parity_1922 | parity_1937));
  logic or_1948;
  assign or_1948 = (or_1900 & or_1904) | (and_1896 & (or_1900 | or_1904));
  logic or_1952;
  assign or_1952 = (or_1915 & or_1919) | (or_1911 & (or_1915 | or_1919));
  logic or_1956;
  assign or_1956 = (or_1930 & or_1934) | (or_1926 & (or_1930 | or_1934));
  // hls/stages/count_bits.hpp:24
  logic parity_1961;
  assign parity_1961 = ^{or_1956, or_1952, or_1948, or_1944};
  // hls/stages/count_bits.hpp:25
  logic or_1965;
  assign or_1965 = (or_1952 & or_1956) | (or_1948 & (or_1952 | or_1956));
  logic and_1966;
  assign and_1966 = or_1944 & (^{or_1956, or_1952, or_1948});
  // hls/stages/count_bits.hpp:24
  logic xor_1967;
  assign xor_1967 = or_1965 ^ and_1966;
  // hls/stages/count_bits.hpp:27
  logic and_1968;
  assign and_1968 = or_1965 & and_1966;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1969;
  assign select_1969 = equal_588_s1_q ? {and_1968, xor_1967, parity_1961, parity_1940, xor_1895, xor_1800} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_574_s1_q ? 6'h0 : select_1969;
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1971;
  assign select_1971 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1972;
  assign difference_1972 = {1'b0, column_5} - {1'b0, select_1971};
  logic [7:0] sum_1974;
  assign sum_1974 = {difference_1972[6], difference_1972} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:795
  logic and_2045;
  assign and_2045 = ends_cell_s1_q & inside_v;
  logic and_2047;
  assign and_2047 = not_570 & (so_s1_q & and_2045);
  logic [6:0] select_2051;
  assign select_2051 = so_s1_q ? x_s1_q[6:0] : (or_574_s1_q ? (less_577_s1_q ? 7'h0 : select_622) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2055;
  assign or_2055 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2064;
  assign and_2064 = or_574_s1_q & (slot_s1_q[2] & not_578_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2177;
  assign select_2177 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2177[16:7])) ? 8'h7f : select_2177[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_2254_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2254_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_2341;
  assign less_2341 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_2342;
  assign or_2342 = equal_2253_s1_q | less_2341;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2347;
  assign select_2347 = equal_2253_s1_q ? patches_column_s1_q[0] : (or_2342 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2348;
  assign not_2348 = ~or_2342;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_2349;
  assign sum_2349 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_2352;
  assign select_2352 = or_2342 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2349) + 5'h1) : sum_2349;
  // hls/stages/patches.hpp:509
  logic [4:0] select_2353;
  assign select_2353 = equal_2253_s1_q ? 5'h0 : select_2352;
  logic or_2354;
  assign or_2354 = equal_2253_s1_q | equal_2251_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_2356;
  assign equal_2356 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2358;
  assign equal_2358 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_2360;
  assign and_2360 = of_row & (~equal_2358);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2356 ? 2'h3 : {equal_2358, and_2360};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_2363;
  assign sum_2363 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2364;
  assign sum_2364 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2363, pixel_2[0]} - {1'b0, sum_2364, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_2366;
  assign sum_2366 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2367;
  assign sum_2367 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2366[11], sum_2366};
  logic [13:0] sum_2368;
  assign sum_2368 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2367, down_2[1]};
  logic [12:0] sum_2369;
  assign sum_2369 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2368[13:1];
  logic [14:0] sum_2370;
  assign sum_2370 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2369, sum_2368[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_2377;
  assign or_2377 = (sum_2370[8] & (~(sum_2370[7:0] == 8'h0))) | (~(sum_2370[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_2382;
  assign sum_2382 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2383;
  assign sum_2383 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2382};
  logic [10:0] sum_2384;
  assign sum_2384 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2383, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2385;
  assign sum_2385 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2384[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_2385, sum_2384[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_2387;
  assign sum_2387 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2388;
  assign sum_2388 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2389;
  assign difference_2389 = {1'b0, sum_2387, smooth[0]} - {1'b0, sum_2388, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_2396;
  assign or_2396 = (difference_2389[8] & (~(difference_2389[7:0] == 8'h0))) | (~(difference_2389[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_2404;
  assign or_2404 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2358) | equal_2356;
  // hls/stages/patches.hpp:481
  logic and_2409;
  assign and_2409 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:275
  logic and_2413;
  assign and_2413 = not_2252_s1_q & (or_2255_s1_q & (or_2404 & (equal_2254_s1_q & and_2409)));
  // hls/stages/patches.hpp:174
  logic and_2423;
  assign and_2423 = (~(equal_2254_s1_q | (~and_2409))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:275
  logic and_2427;
  assign and_2427 = not_2252_s1_q & (or_2255_s1_q & (and_2423 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_2429;
  assign less_2429 = patches_step_q[4:0] < 5'h11;
  logic equal_2430;
  assign equal_2430 = patches_step_q[6:5] == 2'h2;
  logic equal_2431;
  assign equal_2431 = patches_step_q[6:5] == 2'h1;
  logic or_2432;
  assign or_2432 = equal_2430 | equal_2431;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2456;
  assign sum_2456 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1283
  logic or_2495;
  assign or_2495 = sample_pair_first_q | line_ended_q;
  // hls/stages/agreement.hpp:1285
  logic [16:0] select_2497;
  assign select_2497 = sample_pair_first_q ? 17'h1 : (or_2495 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1284
  logic [8:0] select_2499;
  assign select_2499 = or_2495 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1292
  logic select_2501;
  assign select_2501 = cfg_compete_i ? (or_2495 & select_2497[16]) : (select_2499[8] & select_2497[9]);
  // hls/stages/agreement.hpp:440
  logic next_row;
  assign next_row = select_2501 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1299
  logic [6:0] select_2504;
  assign select_2504 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2506;
  assign select_2506 = sample_pair_first_q ? 13'h0 : (seen_base_q + {6'h0, select_2504});
  // hls/stages/agreement.hpp:1310
  logic equal_2507;
  assign equal_2507 = seen_x_q == 3'h7;
  // hls/stages/agreement.hpp:1283
  logic select_2512;
  assign select_2512 = sample_pair_first_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1282
  logic not_2514;
  assign not_2514 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:460
  logic [5:0] or_2745;
  assign or_2745 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:464
  logic select_3029;
  assign select_3029 = equal_2935_s1_q ? (~({row_s1_q, 1'b0} < {sum_3026, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:471
  logic and_3032;
  assign and_3032 = proven_q & less_3031;
  // hls/stages/agreement.hpp:527
  logic select_3036;
  assign select_3036 = and_544_s1_q ? (equal_2935_s1_q ? (and_3032 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:472
  logic equal_3037;
  assign equal_3037 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:473
  logic and_3038;
  assign and_3038 = and_3032 & equal_3037;
  // hls/stages/agreement.hpp:527
  logic select_3040;
  assign select_3040 = and_544_s1_q ? (equal_2935_s1_q ? and_3038 : draws_late_q) : draws_late_q;
  logic and_3283;
  assign and_3283 = and_544_s1_q & (equal_2935_s1_q & equal_3037);
  // hls/stages/registration.hpp:128
  logic and_3284;
  assign and_3284 = and_2936_s1_q & and_3283;
  // hls/stages/registration.hpp:127
  logic and_3286;
  assign and_3286 = and_2936_s1_q & (~and_3283);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3287;
  assign select_3287 = and_3286 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3289;
  assign select_3289 = and_3284 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3287[15]}}, select_3287});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3290;
  assign select_3290 = and_3286 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3290[15]}}, select_3290};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3292;
  assign select_3292 = and_3284 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3293;
  assign and_3293 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3293 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3538;
  assign select_3538 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:275
  logic [11:0] select_3541;
  assign select_3541 = equal_2251_s1_q ? patches_smooth_values_0_q : (or_2255_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3543;
  assign select_3543 = or_2255_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3545;
  assign select_3545 = equal_2249_s1_q ? patches_smooth_values_1_q : (equal_2251_s1_q ? patches_smooth_values_1_q : select_3543);
  logic [11:0] select_3546;
  assign select_3546 = or_2255_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3548;
  assign select_3548 = equal_2249_s1_q ? patches_smooth_values_2_q : (equal_2251_s1_q ? patches_smooth_values_2_q : select_3546);
  logic [11:0] select_3549;
  assign select_3549 = or_2255_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3551;
  assign select_3551 = equal_2249_s1_q ? patches_smooth_values_3_q : (equal_2251_s1_q ? patches_smooth_values_3_q : select_3549);
  logic [10:0] select_3553;
  assign select_3553 = equal_2251_s1_q ? patches_down_values_0_q : (or_2255_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3556;
  assign select_3556 = equal_2251_s1_q ? patches_down_values_1_q : (or_2255_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3559;
  assign select_3559 = equal_2251_s1_q ? patches_down_values_2_q : (or_2255_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3562;
  assign select_3562 = equal_2251_s1_q ? patches_down_values_3_q : (or_2255_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3599;
  assign and_3599 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3604;
  assign select_3604 = or_3499_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3606;
  assign select_3606 = and_3599 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3962;
  assign select_3962 = equal_2249_s1_q ? patches_summed_down_by_q : (equal_2251_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3980;
  assign select_3980 = equal_2249_s1_q ? (less_2429 & (equal_2431 & or_2432)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4283;
  assign select_4283 = so_s1_q ? (and_3293 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4285;
  assign sum_4285 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4286;
  assign select_4286 = sum_2456[5] ? {1'b1, sum_2456[4:0], region_across_rest_q[2:0]} : sum_4285;
  // hls/stages/agreement.hpp:464
  logic [8:0] select_4288;
  assign select_4288 = equal_2935_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4291;
  assign select_4291 = equal_2935_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1155
  logic equal_4342;
  assign equal_4342 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:1309
  logic [2:0] select_4509;
  assign select_4509 = select_2501 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:440
  logic [7:0] select_4515;
  assign select_4515 = sample_pair_first_q ? select_4513 : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_509_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_518;
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
  assign census_memory_re = s1_en & and_544_s1_q;
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
  assign moments_memory_raddr = select_568;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_586;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1386; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_574_s1_q ? select_622 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_613_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1387; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_2047;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_2064;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_622;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2064;
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
  assign patches_right_codes_raddr = {select_2353, not_2348, select_2347};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2354;
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
  assign patches_rows_re = s1_en & (equal_2249_s1_q & (less_2429 & or_2432));
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1415; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2047;
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
  assign left_we = s1_en & and_648_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_750, left_rdata_q[65:49], and_749, left_rdata_q[47:31], and_748, left_rdata_q[29:13], and_747, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_648_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_756, right_codes_rdata_q[84:73], and_755, right_codes_rdata_q[71:60], and_754, right_codes_rdata_q[56:43], and_753, right_codes_rdata_q[41:28], and_752, right_codes_rdata_q[26:13], and_751, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2335_s1_q;
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
      draws_late_q <= 1'b0;
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
    end else if (s1_en) begin
      moments_place_q <= select_567;
      moments_taken_q <= not_570 & (not_572 & (equal_573_s1_q & inside_v));
      moments_starts_q <= not_570 & (not_572 & (equal_573_s1_q & (inside_v & first)));
      row_q <= and_544_s1_q ? (equal_2935_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_544_s1_q ? select_3029 : lower_half_q;
      late_q <= select_3036;
      draws_late_q <= select_3040;
      registration_slope_row_q <= select_3289;
      registration_slope_change_q <= select_3292;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3523_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3523_s1_q & select_3538;
      patches_smooth_values_0_q <= equal_2249_s1_q ? patches_smooth_values_0_q : select_3541;
      patches_smooth_values_1_q <= select_3545;
      patches_smooth_values_2_q <= select_3548;
      patches_smooth_values_3_q <= select_3551;
      patches_down_values_0_q <= equal_2249_s1_q ? patches_down_values_0_q : select_3553;
      patches_down_values_1_q <= equal_2249_s1_q ? patches_down_values_1_q : select_3556;
      patches_down_values_2_q <= equal_2249_s1_q ? patches_down_values_2_q : select_3559;
      patches_down_values_3_q <= equal_2249_s1_q ? patches_down_values_3_q : select_3562;
      patches_down_by_q <= or_3499_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3599});
      patches_along_q <= select_3604;
      patches_match_row_q <= or_3499_s1_q ? 4'h0 : select_3606;
      patches_summed_last_q <= not_2250_s1_q & (equal_2251_s1_q & and_3599);
      patches_summed_down_by_q <= select_3962;
      patches_step_q <= or_3499_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3980;
      region_across_rest_q <= select_4283;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4286;
      columns_begin_rest_q <= and_544_s1_q ? select_4288 : columns_begin_rest_q;
      columns_begin_back_q <= and_544_s1_q ? select_4291 : columns_begin_back_q;
      write_half_q <= sample_pair_first_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2512;
      done_q <= not_2514 & ((~drew_q) & (done_q | said_q));
      proven_q <= sample_pair_first_q ? done_q : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_569_s1_q & equal_4342;
      rows_passed_q <= select_2497;
      columns_passed_q <= {select_2499[7:0], or_2495};
      line_ended_q <= sample_last_q;
      began_q <= not_2514 & (began_q | select_2501);
      seen_x_q <= select_2501 ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= sample_pair_first_q ? 3'h0 : select_4509;
      seen_column_q <= select_2501 ? 8'h0 : (seen_column_q + {7'h0, equal_2507});
      seen_rows_left_q <= select_4515;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2506;
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
      middle_sum_sum_sums_values_0_q <= sum_1010;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1250;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1490;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1734;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1974;
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
  logic draws_late_s2_q;
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
  logic [2:0] select_505_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_509_s2_q;
  logic and_517_s2_q;
  logic and_518_s2_q;
  logic equal_523_s2_q;
  logic [6:0] select_538_s2_q;
  logic [6:0] last_s2_2_q;
  logic and_542_s2_q;
  logic and_544_s2_q;
  logic equal_564_s2_q;
  logic [12:0] select_568_s2_q;
  logic equal_569_s2_q;
  logic not_570_s2_q;
  logic not_572_s2_q;
  logic equal_573_s2_q;
  logic or_574_s2_q;
  logic less_577_s2_q;
  logic not_578_s2_q;
  logic inside_v_s2_q;
  logic not_582_s2_q;
  logic and_586_s2_q;
  logic and_595_s2_q;
  logic and_604_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic not_633_s2_q;
  logic and_637_s2_q;
  logic and_642_s2_q;
  logic and_644_s2_q;
  logic equal_677_s2_q;
  logic and_2034_s2_q;
  logic equal_2035_s2_q;
  logic and_2045_s2_q;
  logic and_2047_s2_q;
  logic [6:0] select_2051_s2_q;
  logic or_2055_s2_q;
  logic and_2158_s2_q;
  logic less_2172_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2249_s2_q;
  logic equal_2251_s2_q;
  logic equal_2254_s2_q;
  logic or_2255_s2_q;
  logic not_2256_s2_q;
  logic [4:0] select_2279_s2_q;
  logic select_2285_s2_q;
  logic [3:0] select_2325_s2_q;
  logic less_2341_s2_q;
  logic new_row_s2_q;
  logic or_2354_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2371_s2_q;
  logic or_2377_s2_q;
  logic and_2381_s2_q;
  logic and_2397_s2_q;
  logic and_2400_s2_q;
  logic and_2414_s2_q;
  logic and_2423_s2_q;
  logic and_2428_s2_q;
  logic less_2429_s2_q;
  logic equal_2430_s2_q;
  logic or_2432_s2_q;
  logic sum_2456_s2_q;
  logic and_2477_s2_q;
  logic select_2526_s2_q;
  logic and_2597_s2_q;
  logic equal_2746_s2_q;
  logic equal_2935_s2_q;
  logic and_3052_s2_q;
  logic equal_3137_s2_q;
  logic less_3575_s2_q;
  logic equal_3918_s2_q;
  logic equal_4015_s2_q;
  logic less_4271_s2_q;
  logic equal_4342_s2_q;
  logic or_4492_s2_q;
  logic not_4535_s2_q;
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
      draws_late_s2_q <= draws_late_q;
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
      select_505_s2_q <= select_505_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_509_s2_q <= select_509_s1_q;
      and_517_s2_q <= and_517_s1_q;
      and_518_s2_q <= and_518;
      equal_523_s2_q <= equal_523_s1_q;
      select_538_s2_q <= select_538_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_542_s2_q <= and_542_s1_q;
      and_544_s2_q <= and_544_s1_q;
      equal_564_s2_q <= equal_564;
      select_568_s2_q <= select_568;
      equal_569_s2_q <= equal_569_s1_q;
      not_570_s2_q <= not_570;
      not_572_s2_q <= not_572;
      equal_573_s2_q <= equal_573_s1_q;
      or_574_s2_q <= or_574_s1_q;
      less_577_s2_q <= less_577_s1_q;
      not_578_s2_q <= not_578_s1_q;
      inside_v_s2_q <= inside_v;
      not_582_s2_q <= not_582;
      and_586_s2_q <= and_586;
      and_595_s2_q <= or_574_s1_q & (left_rdata_q[70] & not_578_s1_q);
      and_604_s2_q <= (or_574_s1_q & (left_rdata_q[68] & not_578_s1_q)) & and_603;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      not_633_s2_q <= ~late_q;
      and_637_s2_q <= or_574_s1_q & (left_rdata_q[71] & not_578_s1_q);
      and_642_s2_q <= or_574_s1_q & (right_codes_rdata_q[58] & not_578_s1_q);
      and_644_s2_q <= or_574_s1_q & (right_codes_rdata_q[59] & not_578_s1_q);
      equal_677_s2_q <= row_s1_q == 6'h0;
      and_2034_s2_q <= and_2034_s1_q;
      equal_2035_s2_q <= equal_2035_s1_q;
      and_2045_s2_q <= and_2045;
      and_2047_s2_q <= and_2047;
      select_2051_s2_q <= select_2051;
      or_2055_s2_q <= or_2055;
      and_2158_s2_q <= and_2158_s1_q;
      less_2172_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2249_s2_q <= equal_2249_s1_q;
      equal_2251_s2_q <= equal_2251_s1_q;
      equal_2254_s2_q <= equal_2254_s1_q;
      or_2255_s2_q <= or_2255_s1_q;
      not_2256_s2_q <= not_2256_s1_q;
      select_2279_s2_q <= select_2279_s1_q;
      select_2285_s2_q <= select_2285_s1_q;
      select_2325_s2_q <= select_2325_s1_q;
      less_2341_s2_q <= less_2341;
      new_row_s2_q <= new_row;
      or_2354_s2_q <= or_2354;
      of_row_2_s2_q <= of_row_2;
      not_2371_s2_q <= ~sum_2370[14];
      or_2377_s2_q <= or_2377;
      and_2381_s2_q <= sum_2370[14] & (~(sum_2370[13:8] == 6'h3f));
      and_2397_s2_q <= (~difference_2389[14]) & or_2396;
      and_2400_s2_q <= difference_2389[14] & (~(difference_2389[13:8] == 6'h3f));
      and_2414_s2_q <= not_2250_s1_q & and_2413;
      and_2423_s2_q <= and_2423;
      and_2428_s2_q <= not_2250_s1_q & and_2427;
      less_2429_s2_q <= less_2429;
      equal_2430_s2_q <= equal_2430;
      or_2432_s2_q <= or_2432;
      sum_2456_s2_q <= sum_2456[5];
      and_2477_s2_q <= or_574_s1_q & (left_rdata_q[69] & not_578_s1_q);
      select_2526_s2_q <= draws_late_q ? read_half_q : write_half_q;
      and_2597_s2_q <= (draws_late_q | (6'h6 < row_q)) & (~(x_s1_q[7:2] == 6'h0));
      equal_2746_s2_q <= {last_s1_2_q[6], or_2745} == 7'h0;
      equal_2935_s2_q <= equal_2935_s1_q;
      and_3052_s2_q <= or_574_s1_q & (not_578_s1_q & and_603);
      equal_3137_s2_q <= shift == 6'h0;
      less_3575_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3918_s2_q <= patches_match_row_q == 4'h0;
      equal_4015_s2_q <= patches_step_q[6:5] == 2'h3;
      less_4271_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4342_s2_q <= equal_4342;
      or_4492_s2_q <= and_3038 | (~(row_s1_q[5:3] == 3'h0));
      not_4535_s2_q <= ~proven_q;
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
  // hls/stages/census.hpp:117
  logic [11:0] select_521;
  assign select_521 = select_505_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_525;
  assign sum_525 = select_521 + (equal_523_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_527;
  assign sum_527 = {4'h0, sample_pair_pixel_1_q} + (select_505_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_529;
  assign sum_529 = sum_527 + (equal_523_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:422
  logic whole;
  assign whole = select_505_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_533;
  assign and_533 = whole & (averager_memory_rdata_q[24] | equal_523_s2_q);
  // hls/stages/agreement.hpp:422
  logic all_of_skin;
  assign all_of_skin = select_505_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_537;
  assign and_537 = all_of_skin & (averager_memory_rdata_q[25] | equal_523_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_517_s2_q ? sum_525[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_547;
  assign equal_547 = select_505_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_547 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_550;
  assign select_550 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_517_s2_q ? sum_529[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_547 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_554;
  assign select_554 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_555;
  assign and_555 = and_517_s2_q & and_533;
  // hls/stages/census.hpp:134
  logic select_557;
  assign select_557 = equal_547 ? and_555 : (averager_mask_q & and_555);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_557;
  // hls/stages/census.hpp:218
  logic and_559;
  assign and_559 = and_517_s2_q & and_537;
  // hls/stages/census.hpp:134
  logic select_561;
  assign select_561 = equal_547 ? and_559 : (averager_of_skin_q & and_559);
  // hls/stages/agreement.hpp:276
  logic and_562;
  assign and_562 = sample_pair_whole_s2_q & select_561;
  // hls/stages/agreement.hpp:985
  logic select_617;
  assign select_617 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:986
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:999
  logic [8:0] difference_627;
  assign difference_627 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1000
  logic [9:0] sum_628;
  assign sum_628 = {difference_627[8], difference_627} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_630;
  assign and_630 = (and_604_s2_q & select_617) & ({{22{sum_628[9]}}, sum_628} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_632;
  assign and_632 = or_574_s2_q & (not_578_s2_q & and_630);
  // hls/stages/moments.hpp:77
  logic and_635;
  assign and_635 = and_595_s2_q & (and_632 & not_633_s2_q);
  // hls/stages/census.hpp:308
  logic less_650;
  assign less_650 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_662;
  assign less_662 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:459
  logic equal_674;
  assign equal_674 = last_s2_2_q == 7'h0;
  logic [3:0] select_678;
  assign select_678 = equal_677_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:460
  logic [4:0] select_679;
  assign select_679 = equal_674 ? {select_678, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_680;
  assign select_680 = equal_674 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_681;
  assign and_681 = select_679[4] & select_680[3];
  // hls/stages/census.hpp:300
  logic and_683;
  assign and_683 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_685;
  assign and_685 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_683);
  // hls/stages/agreement.hpp:460
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_685;
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
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, select_550} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_709;
  assign xor_709 = difference_708[8:0] ^ {9{difference_708[9]}};
  logic [9:0] sum_710;
  assign sum_710 = {9'h0, difference_708[9]} + {1'b0, xor_709};
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_712;
  assign xor_712 = difference_711[8:0] ^ {9{difference_711[9]}};
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711[9]} + {1'b0, xor_712};
  logic [9:0] difference_715;
  assign difference_715 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_716;
  assign xor_716 = difference_715[8:0] ^ {9{difference_715[9]}};
  logic [9:0] sum_717;
  assign sum_717 = {9'h0, difference_715[9]} + {1'b0, xor_716};
  logic [10:0] sum_718;
  assign sum_718 = ({1'b0, sum_710} + {1'b0, sum_713}) + {1'b0, sum_717};
  logic [9:0] difference_719;
  assign difference_719 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_720;
  assign xor_720 = difference_719[8:0] ^ {9{difference_719[9]}};
  logic [9:0] sum_721;
  assign sum_721 = {9'h0, difference_719[9]} + {1'b0, xor_720};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_724;
  assign xor_724 = difference_723[8:0] ^ {9{difference_723[9]}};
  // hls/stages/agreement.hpp:460
  logic and_732;
  assign and_732 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_733;
  assign and_733 = and_681 & and_732;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_735;
  assign sum_735 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_737;
  assign and_737 = and_733 & ({{5{sum_735[6]}}, sum_735, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_741;
  assign sum_741 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:814
  logic or_758;
  assign or_758 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:815
  logic select_760;
  assign select_760 = or_758 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:758
  logic less_1491;
  assign less_1491 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1492;
  assign select_1492 = less_1491 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1493;
  assign less_1493 = middle_sum_sum_sums_values_0_q < select_1492;
  logic [7:0] select_1494;
  assign select_1494 = less_1493 ? select_1492 : middle_sum_sum_sums_values_0_q;
  logic less_1975;
  assign less_1975 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1976;
  assign select_1976 = less_1975 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1977;
  assign less_1977 = select_1494 < select_1976;
  // hls/stages/agreement.hpp:808
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1977 ? select_1976 : select_1494) : 8'h0;
  // hls/stages/agreement.hpp:815
  logic or_1981;
  assign or_1981 = select_760 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:820
  logic [5:0] select_1982;
  assign select_1982 = or_1981 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:759
  logic or_1984;
  assign or_1984 = less_1491 | (~less_1493);
  logic [2:0] select_1985;
  assign select_1985 = less_1977 ? {less_1975, 2'h0} : {1'b0, or_1984, less_1493};
  // hls/stages/agreement.hpp:820
  logic [2:0] select_1986;
  assign select_1986 = or_1981 ? select_1985 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1987;
  assign select_1987 = or_1981 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:817
  logic equal_1988;
  assign equal_1988 = select_1985 == 3'h1;
  logic or_1991;
  assign or_1991 = equal_1988 | (~(select_1985 == 3'h2));
  logic [7:0] select_1993;
  assign select_1993 = or_1991 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1994;
  assign select_1994 = equal_1988 ? (or_1991 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1993;
  // hls/stages/agreement.hpp:820
  logic [7:0] select_1995;
  assign select_1995 = or_1981 ? select_1994 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1996;
  assign select_1996 = or_1991 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:820
  logic [7:0] select_1998;
  assign select_1998 = or_1981 ? (equal_1988 ? select_1993 : select_1996) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_2000;
  assign sum_2000 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_2001;
  assign sum_2001 = {1'b0, before_v} + sum_2000;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_2003;
  assign sum_2003 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_2004;
  assign sum_2004 = {1'b0, before_v_2} + sum_2003;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_2006;
  assign sum_2006 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, before_v_3} + sum_2006;
  // hls/stages/agreement.hpp:758
  logic [6:0] select_2009;
  assign select_2009 = (sum_2004 < sum_2007) ? sum_2007 : sum_2004;
  logic [6:0] select_2011;
  assign select_2011 = (sum_2001 < select_2009) ? select_2009 : sum_2001;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_2013;
  assign sum_2013 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2014;
  assign sum_2014 = {1'b0, before_v_4} + sum_2013;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_2016;
  assign sum_2016 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2017;
  assign sum_2017 = {1'b0, before_v_5} + sum_2016;
  // hls/stages/agreement.hpp:758
  logic [6:0] select_2019;
  assign select_2019 = (sum_2014 < sum_2017) ? sum_2017 : sum_2014;
  // hls/stages/agreement.hpp:809
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2011 < select_2019) ? select_2019 : select_2011) : 7'h0;
  // hls/stages/agreement.hpp:820
  logic less_2023;
  assign less_2023 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:824
  logic [6:0] select_2025;
  assign select_2025 = select_760 ? of_near : (less_2023 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2027;
  assign select_2027 = select_760 ? run_shift_s2_q : (less_2023 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2030;
  assign select_2030 = (run_shift_s2_q == 6'h3f) ? of_best : (select_760 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:825
  logic [7:0] select_2033;
  assign select_2033 = (run_shift_s2_q == 6'h1) ? of_best : (select_760 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:830
  logic select_2036;
  assign select_2036 = or_758 ? shift_first_s2_q : equal_2035_s2_q;
  // hls/stages/agreement.hpp:831
  logic or_2038;
  assign or_2038 = select_2036 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:835
  logic [7:0] select_2039;
  assign select_2039 = or_2038 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2040;
  assign select_2040 = or_2038 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2042;
  assign or_2042 = select_2036 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:839
  logic [6:0] select_2043;
  assign select_2043 = or_2042 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2044;
  assign select_2044 = or_2042 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2058;
  assign and_2058 = or_574_s2_q & (not_578_s2_q & (and_630 & or_2055_s2_q));
  // hls/stages/agreement.hpp:795
  logic and_2059;
  assign and_2059 = not_572_s2_q & and_2058;
  logic and_2062;
  assign and_2062 = not_570_s2_q & (drew_q ? and_2045_s2_q : (equal_573_s2_q & and_632));
  // hls/stages/moments.hpp:73
  logic and_2066;
  assign and_2066 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1010
  logic and_2067;
  assign and_2067 = not_582_s2_q & and_2066;
  logic and_2070;
  assign and_2070 = not_582_s2_q & (and_2066 & (moments_memory_rdata_q[1] ^ and_637_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2075;
  assign and_2075 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1010
  logic and_2076;
  assign and_2076 = not_582_s2_q & and_2075;
  logic and_2079;
  assign and_2079 = not_582_s2_q & (and_2075 & (moments_memory_rdata_q[3] ^ and_644_s2_q));
  // hls/stages/agreement.hpp:1136
  logic equal_2080;
  assign equal_2080 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1186
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1137
  logic [1:0] select_2083;
  assign select_2083 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1150
  logic [3:0] select_2085;
  assign select_2085 = equal_2080 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2083});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2086;
  assign sum_2086 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:795
  logic [3:0] select_2087;
  assign select_2087 = equal_569_s2_q ? select_2085 : {sum_2086, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_2088;
  assign equal_2088 = x_s2_q[5:0] == 6'h3f;
  logic equal_2090;
  assign equal_2090 = x_s2_q[5:0] == 6'h3e;
  logic equal_2092;
  assign equal_2092 = x_s2_q[5:0] == 6'h3d;
  logic equal_2094;
  assign equal_2094 = x_s2_q[5:0] == 6'h3c;
  logic equal_2096;
  assign equal_2096 = x_s2_q[5:0] == 6'h3b;
  logic equal_2098;
  assign equal_2098 = x_s2_q[5:0] == 6'h36;
  logic equal_2100;
  assign equal_2100 = x_s2_q[5:0] == 6'h35;
  logic equal_2102;
  assign equal_2102 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1186
  logic and_2106;
  assign and_2106 = (~equal_2096) & ((~equal_2098) & ((~equal_2100) & (~equal_2102)));
  logic and_2110;
  assign and_2110 = (~equal_2088) & ((~equal_2090) & ((~equal_2092) & ((~equal_2094) & and_2106)));
  // hls/stages/agreement.hpp:1137
  logic less_2111;
  assign less_2111 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2115;
  assign or_2115 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1016
  logic [5:0] sum_2120;
  assign sum_2120 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2120, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2126;
  assign sum_2126 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2128;
  assign and_2128 = half_ends & ({{3{sum_2126[4]}}, sum_2126} < 8'h3);
  // hls/stages/agreement.hpp:795
  logic and_2129;
  assign and_2129 = drew_q & and_2128;
  logic select_2130;
  assign select_2130 = equal_569_s2_q ? (x_s2_q[6] & (equal_2080 ? and_2110 : (less_2111 & (~or_2115)))) : and_2129;
  // hls/stages/registration.hpp:258
  logic not_2132;
  assign not_2132 = ~lower_half_s2_q;
  logic [3:0] select_2133;
  assign select_2133 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2132, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2132};
  // hls/stages/patches.hpp:377
  logic [1:0] select_2159;
  assign select_2159 = and_2158_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2160;
  assign select_2160 = and_2158_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2161;
  assign select_2161 = row_starts_s2_q ? {select_2160, select_2159[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2162;
  assign select_2162 = row_starts_s2_q ? select_2159 : patches_fetch_q;
  logic equal_2163;
  assign equal_2163 = select_2162 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:795
  logic and_2171;
  assign and_2171 = not_570_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2173;
  assign equal_2173 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_574_s2_q ? (less_577_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2173 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2181;
  assign select_2181 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2182;
  assign select_2182 = b[1] ? a : 8'h0;
  logic [8:0] sum_2183;
  assign sum_2183 = {{2{select_2181[6]}}, select_2181} + {select_2182[7], select_2182};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2184;
  assign select_2184 = b[2] ? a : 8'h0;
  logic [7:0] select_2185;
  assign select_2185 = b[3] ? a : 8'h0;
  logic [8:0] sum_2186;
  assign sum_2186 = {{2{select_2184[7]}}, select_2184[7:1]} + {select_2185[7], select_2185};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2187;
  assign sum_2187 = {{3{sum_2183[8]}}, sum_2183[8:1]} + {sum_2186[8], sum_2186, select_2184[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2188;
  assign select_2188 = b[4] ? a : 8'h0;
  logic [7:0] select_2189;
  assign select_2189 = b[5] ? a : 8'h0;
  logic [8:0] difference_2190;
  assign difference_2190 = {{2{select_2188[7]}}, select_2188[7:1]} - {select_2189[7], select_2189};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2191;
  assign sum_2191 = {difference_2190, select_2188[0]} + {sum_2187[10], sum_2187[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2173 ? {sum_2191, sum_2187[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2193;
  assign sum_2193 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2196;
  assign and_2196 = less_2172_s2_q & (and_632 & ({{4{sum_2193[9]}}, sum_2193, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2200;
  assign and_2200 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2206;
  assign sum_2206 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2208;
  assign sum_2208 = {sum_2206[9], sum_2206[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1025
  logic and_2211;
  assign and_2211 = ($signed(9'h0) < $signed(sum_2206[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2208, sum_2206[0]})));
  logic and_2212;
  assign and_2212 = (~(and_2200 | (equal_564_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2211;
  // hls/stages/agreement.hpp:795
  logic and_2216;
  assign and_2216 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2196 & and_2212)));
  logic and_2217;
  assign and_2217 = not_570_s2_q & and_2216;
  // hls/stages/patches.hpp:157
  logic and_2219;
  assign and_2219 = and_2217 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_2220;
  assign select_2220 = and_2219 ? and_2217 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_2223;
  assign select_2223 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2225;
  assign select_2225 = and_2219 ? (equal_569_s2_q ? 8'h0 : select_2223) : patches_choice_column_q;
  // hls/stages/agreement.hpp:795
  logic [5:0] select_2228;
  assign select_2228 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_2230;
  assign select_2230 = and_2219 ? (equal_569_s2_q ? 6'h0 : select_2228) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2231;
  assign sum_2231 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2191[9]}}, sum_2191[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2234;
  assign select_2234 = ($signed(sum_2231[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2231[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2173 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2231[12:7])) ? 8'h7f : select_2234);
  // hls/stages/agreement.hpp:795
  logic [7:0] select_2239;
  assign select_2239 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2241;
  assign select_2241 = and_2219 ? (equal_569_s2_q ? 8'h0 : select_2239) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2242;
  assign equal_2242 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:795
  logic and_2246;
  assign and_2246 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2200 | equal_2242)));
  logic and_2247;
  assign and_2247 = not_570_s2_q & and_2246;
  // hls/stages/patches.hpp:348
  logic and_2248;
  assign and_2248 = patches_chooses_s2_q & and_2247;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2262;
  assign select_2262 = row_starts_s2_q ? select_2160 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_2263;
  assign equal_2263 = {patches_choosing_band_s2_q, and_2171} == {select_2262, select_2162[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_2362;
  assign sum_2362 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_2378;
  assign and_2378 = not_2371_s2_q & or_2377_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_2418;
  assign sum_2418 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2443;
  assign select_2443 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1057
  logic or_2446;
  assign or_2446 = select_2443[7] | (~({select_2443[5], select_2443[3], select_2443[1]} == 3'h0));
  // hls/stages/agreement.hpp:1056
  logic or_2449;
  assign or_2449 = select_2443[7] | (~({select_2443[6], select_2443[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1055
  logic or_2452;
  assign or_2452 = select_2443[7] | (~(select_2443[6:4] == 3'h0));
  // hls/stages/agreement.hpp:795
  logic [5:0] select_2453;
  assign select_2453 = equal_569_s2_q ? x_s2_q[5:0] : {region_row_q, or_2452, or_2449, or_2446};
  // hls/stages/agreement.hpp:1136
  logic not_2454;
  assign not_2454 = ~equal_2080;
  // hls/stages/agreement.hpp:1065
  logic or_2458;
  assign or_2458 = (~sum_2456_s2_q) | equal_2242;
  // hls/stages/agreement.hpp:795
  logic and_2461;
  assign and_2461 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2458));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_574_s2_q & (not_578_s2_q & and_604_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_632;
  // hls/stages/agreement.hpp:149
  logic and_2479;
  assign and_2479 = or_574_s2_q & (not_578_s2_q & and_2477_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2488;
  assign and_2488 = inside_v_s2_q & and_2479;
  // hls/stages/agreement.hpp:1021
  logic select_2489;
  assign select_2489 = slot_s2_q[2] ? shown_shown_q : and_632;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2489);
  // hls/stages/agreement.hpp:1021
  logic select_2492;
  assign select_2492 = slot_s2_q[2] ? shown_nearer_q : and_2058;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2489 ? select_2492 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1317
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1269
  logic [7:0] sum_2513;
  assign sum_2513 = {1'b0, read_half_q, 2'h0, read_half_q, 1'b0, {2{read_half_q}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1316
  logic and_2520;
  assign and_2520 = began_q & (seen_x_q == 3'h0);
  logic less_2521;
  assign less_2521 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1119
  logic [7:0] sum_2524;
  assign sum_2524 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2524[7]}}, sum_2524, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1269
  logic [7:0] sum_2527;
  assign sum_2527 = {1'b0, select_2526_s2_q, 2'h0, select_2526_s2_q, 1'b0, {2{select_2526_s2_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1037
  logic and_2528;
  assign and_2528 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2529;
  assign and_2529 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2530;
  assign and_2530 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2531;
  assign and_2531 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1094
  logic [1:0] sum_2533;
  assign sum_2533 = {1'b0, and_2530} + ({1'b0, textured} + {1'b0, and_2531});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2528} + ({2'h0, and_2529} + {1'b0, sum_2533});
  // hls/stages/agreement.hpp:1037
  logic [7:0] select_2542;
  assign select_2542 = inside_v_s2_q ? (sum_2456_s2_q ? select_2443 : {select_2443[6:0], 1'b0}) : select_2443;
  // hls/stages/agreement.hpp:1057
  logic or_2545;
  assign or_2545 = select_2542[7] | (~({select_2542[5], select_2542[3], select_2542[1]} == 3'h0));
  // hls/stages/agreement.hpp:1037
  logic and_2563;
  assign and_2563 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2564;
  assign and_2564 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2565;
  assign and_2565 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2566;
  assign and_2566 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1096
  logic [1:0] sum_2568;
  assign sum_2568 = {1'b0, and_2565} + ({1'b0, shown} + {1'b0, and_2566});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2563} + ({2'h0, and_2564} + {1'b0, sum_2568});
  // hls/stages/agreement.hpp:1037
  logic and_2579;
  assign and_2579 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2580;
  assign and_2580 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2581;
  assign and_2581 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2582;
  assign and_2582 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1097
  logic [1:0] sum_2584;
  assign sum_2584 = {1'b0, and_2581} + ({1'b0, near} + {1'b0, and_2582});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2579} + ({2'h0, and_2580} + {1'b0, sum_2584});
  // hls/stages/agreement.hpp:795
  logic and_2601;
  assign and_2601 = ends_cell_s2_q & (and_2597_s2_q & (~({sum_2120, last_s2_q[1:0]} < x_s2_q)));
  logic and_2603;
  assign and_2603 = not_570_s2_q & (drew_q & and_2601);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2637;
  assign select_2637 = sample_pair_whole_s2_q ? (and_542_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2639;
  assign select_2639 = sample_pair_whole_s2_q ? (and_542_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2659;
  assign select_2659 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2661;
  assign select_2661 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_557 : averager_mask_q) : averager_mask_q;
  logic select_2663;
  assign select_2663 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_561 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:527
  logic [8:0] select_2664;
  assign select_2664 = and_544_s2_q ? select_550 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2665;
  assign select_2665 = and_544_s2_q ? select_554 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2667;
  assign select_2667 = and_544_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2668;
  assign select_2668 = and_544_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2669;
  assign select_2669 = and_544_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2670;
  assign select_2670 = and_544_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2671;
  assign select_2671 = and_544_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2672;
  assign select_2672 = and_544_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2673;
  assign select_2673 = and_544_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2674;
  assign select_2674 = and_544_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_544_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2676;
  assign select_2676 = and_544_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_544_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_544_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2679;
  assign select_2679 = and_544_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2680;
  assign select_2680 = and_544_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2681;
  assign select_2681 = and_544_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2682;
  assign select_2682 = and_544_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2683;
  assign select_2683 = and_544_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2684;
  assign select_2684 = and_544_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2685;
  assign select_2685 = and_544_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2686;
  assign select_2686 = and_544_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2687;
  assign select_2687 = and_544_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2688;
  assign select_2688 = and_544_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2689;
  assign select_2689 = and_544_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2690;
  assign select_2690 = and_544_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_544_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2692;
  assign select_2692 = and_544_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_544_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_544_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2695;
  assign select_2695 = and_544_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2696;
  assign select_2696 = and_544_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2697;
  assign select_2697 = and_544_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2698;
  assign select_2698 = and_544_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2699;
  assign select_2699 = and_544_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2700;
  assign select_2700 = and_544_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2701;
  assign select_2701 = and_544_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2702;
  assign select_2702 = and_544_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2703;
  assign select_2703 = and_544_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2704;
  assign select_2704 = and_544_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2705;
  assign select_2705 = and_544_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2706;
  assign select_2706 = and_544_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2707;
  assign select_2707 = and_544_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2708;
  assign select_2708 = and_544_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2709;
  assign select_2709 = and_544_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2710;
  assign select_2710 = and_544_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2711;
  assign select_2711 = and_544_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2712;
  assign select_2712 = and_544_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2713;
  assign select_2713 = and_544_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2714;
  assign select_2714 = and_544_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2715;
  assign select_2715 = and_544_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2716;
  assign select_2716 = and_544_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2717;
  assign select_2717 = and_544_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2718;
  assign select_2718 = and_544_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2719;
  assign select_2719 = and_544_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2721;
  assign difference_2721 = {1'b0, select_554} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2722;
  assign xor_2722 = difference_2721[8:0] ^ {9{difference_2721[9]}};
  logic [9:0] sum_2723;
  assign sum_2723 = {9'h0, difference_2721[9]} + {1'b0, xor_2722};
  logic [9:0] difference_2724;
  assign difference_2724 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2725;
  assign xor_2725 = difference_2724[8:0] ^ {9{difference_2724[9]}};
  logic [9:0] sum_2726;
  assign sum_2726 = {9'h0, difference_2724[9]} + {1'b0, xor_2725};
  logic [9:0] difference_2728;
  assign difference_2728 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2729;
  assign xor_2729 = difference_2728[8:0] ^ {9{difference_2728[9]}};
  logic [9:0] sum_2730;
  assign sum_2730 = {9'h0, difference_2728[9]} + {1'b0, xor_2729};
  logic [10:0] sum_2731;
  assign sum_2731 = ({1'b0, sum_2723} + {1'b0, sum_2726}) + {1'b0, sum_2730};
  logic [9:0] difference_2732;
  assign difference_2732 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2733;
  assign xor_2733 = difference_2732[8:0] ^ {9{difference_2732[9]}};
  logic [9:0] sum_2734;
  assign sum_2734 = {9'h0, difference_2732[9]} + {1'b0, xor_2733};
  logic [9:0] difference_2736;
  assign difference_2736 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2737;
  assign xor_2737 = difference_2736[8:0] ^ {9{difference_2736[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2758;
  assign sum_2758 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2760;
  assign sum_2760 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1150
  logic equal_2761;
  assign equal_2761 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2762;
  assign select_2762 = equal_2761 ? sum_2758 : moments_before_0_q;
  logic [13:0] select_2764;
  assign select_2764 = equal_2761 ? sum_2760 : moments_before_1_q;
  // hls/stages/agreement.hpp:795
  logic select_2767;
  assign select_2767 = equal_569_s2_q ? (moments_has_before_q | equal_2761) : moments_has_before_q;
  logic [13:0] select_2770;
  assign select_2770 = equal_569_s2_q ? ((select_2764 < select_2762) ? select_2762 : select_2764) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2771;
  assign sum_2771 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2774;
  assign select_2774 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2771)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2775;
  assign sum_2775 = {1'b0, sum_2760} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2778;
  assign select_2778 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2775)) : moments_left_alone_q;
  logic select_2781;
  assign select_2781 = equal_569_s2_q ? (~({3'h0, select_2764[13:2]} < sum_2775)) : moments_left_other_stops_q;
  logic select_2784;
  assign select_2784 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2771)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2785;
  assign sum_2785 = {1'b0, sum_2758} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2788;
  assign select_2788 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2785)) : moments_right_alone_q;
  logic select_2791;
  assign select_2791 = equal_569_s2_q ? (~({3'h0, select_2762[13:2]} < sum_2785)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2794;
  assign or_2794 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:795
  logic and_2802;
  assign and_2802 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2070)));
  logic and_2806;
  assign and_2806 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2079)));
  // hls/stages/moments.hpp:94
  logic and_2808;
  assign and_2808 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2811;
  assign select_2811 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2808)) : and_2808;
  // hls/stages/agreement.hpp:795
  logic and_2815;
  assign and_2815 = equal_569_s2_q & (equal_2761 & (cfg_prove_i & (cfg_same_table_i & select_2811)));
  // hls/stages/moments.hpp:95
  logic and_2818;
  assign and_2818 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2832;
  assign difference_2832 = {1'b0, select_550} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2832[9]} + (difference_2832[8:0] ^ {9{difference_2832[9]}});
  logic [9:0] difference_2844;
  assign difference_2844 = {1'b0, select_554} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2844[9]} + (difference_2844[8:0] ^ {9{difference_2844[9]}});
  // hls/stages/agreement.hpp:795
  logic not_3042;
  assign not_3042 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3043;
  assign less_3043 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:527
  logic and_3050;
  assign and_3050 = and_544_s2_q & (equal_677_s2_q & equal_2935_s2_q);
  // hls/stages/agreement.hpp:795
  logic and_3056;
  assign and_3056 = not_570_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & and_3052_s2_q)));
  // hls/stages/agreement.hpp:1037
  logic and_3076;
  assign and_3076 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3077;
  assign and_3077 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3078;
  assign and_3078 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3079;
  assign and_3079 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1095
  logic [1:0] sum_3081;
  assign sum_3081 = {1'b0, and_3078} + ({1'b0, explained} + {1'b0, and_3079});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3076} + ({2'h0, and_3077} + {1'b0, sum_3081});
  // hls/stages/agreement.hpp:795
  logic and_3117;
  assign and_3117 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3052_s2_q & and_2479)));
  // hls/stages/agreement.hpp:993
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:994
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:995
  logic [7:0] difference_3141;
  assign difference_3141 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3144;
  assign less_3144 = {2'h0, difference_3141[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3147;
  assign and_3147 = not_578_s2_q & (((and_2477_s2_q & and_630) & equal_3137_s2_q) & (~less_3144));
  // hls/stages/agreement.hpp:795
  logic and_3151;
  assign and_3151 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (or_574_s2_q & and_3147)));
  // hls/stages/agreement.hpp:149
  logic and_3156;
  assign and_3156 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3158;
  assign and_3158 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3159;
  assign select_3159 = or_574_s2_q ? {and_3158, and_3156} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3161;
  assign select_3161 = less_577_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3162;
  assign select_3162 = or_574_s2_q ? select_3161 : 2'h0;
  // hls/stages/agreement.hpp:1034
  logic and_3165;
  assign and_3165 = and_632 & (not_633_s2_q & (select_3159[0] & select_3162[0]));
  // hls/stages/agreement.hpp:795
  logic and_3169;
  assign and_3169 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3159[1] & and_3165)));
  logic and_3170;
  assign and_3170 = not_570_s2_q & and_3169;
  logic and_3176;
  assign and_3176 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3162[1] & and_3165)));
  logic and_3177;
  assign and_3177 = not_570_s2_q & and_3176;
  // hls/stages/registration.hpp:76
  logic less_3180;
  assign less_3180 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3182;
  assign select_3182 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3184;
  assign select_3184 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3186;
  assign select_3186 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3184} - {1'b0, select_3186};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3188;
  assign select_3188 = rise_2[8] ? select_3184 : select_3186;
  logic [8:0] fall;
  assign fall = {1'b0, select_3182} - {1'b0, select_3188};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3191;
  assign not_3191 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3180 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3191};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3193;
  assign xor_3193 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3193};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3199;
  assign select_3199 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3180 ? {taken, 1'b1} : {not_3191, select_3199, not_3191};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3201;
  assign sum_3201 = {left, 1'b1} + {taken_2, less_3180};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3203;
  assign select_3203 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_3205;
  assign select_3205 = equal_569_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_3207;
  assign select_3207 = equal_569_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3208;
  assign equal_3208 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3212;
  assign and_3212 = and_632 & less_2172_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3214;
  assign select_3214 = or_574_s2_q ? (less_577_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3218;
  assign sum_3218 = select_3214[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3221;
  assign select_3221 = (select_3184 < select_3186) ? ({sum_3218, select_3214[0], 5'h0} - {3'h0, select_3203}) : {sum_3218, select_3214[0], select_3203};
  logic [7:0] select_3222;
  assign select_3222 = ((select_3214 == 3'h0) | (select_3214 == 3'h4)) ? {sum_3218, select_3214[0], 5'h0} : select_3221;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3222[7]}}, select_3222} - {sum_2191[9], sum_2191, sum_2187[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3225;
  assign select_3225 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3225[11:7])) ? 12'h7f : select_3225;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3246;
  assign difference_3246 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3248;
  assign and_3248 = and_3212 & ($signed(difference_3246) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3261;
  assign less_3261 = $signed(difference_3246) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:795
  logic select_3269;
  assign select_3269 = drew_q ? (equal_3208 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3272;
  assign select_3272 = drew_q ? (equal_2173 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3277;
  assign select_3277 = (sum_2086 == 2'h2) ? (registration_fresh_q & (~select_2133)) : registration_fresh_q;
  // hls/stages/agreement.hpp:795
  logic [3:0] select_3279;
  assign select_3279 = drew_q ? (and_2128 ? select_3277 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3281;
  assign select_3281 = and_3050 ? 4'hf : (equal_569_s2_q ? registration_fresh_q : select_3279);
  // hls/stages/agreement.hpp:1137
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2083;
  // hls/stages/registration.hpp:258
  logic not_3301;
  assign not_3301 = ~quarter_2[1];
  logic [3:0] select_3302;
  assign select_3302 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3301, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3301};
  // hls/stages/patches.hpp:91
  logic parity_3436;
  assign parity_3436 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:464
  logic [15:0] select_3437;
  assign select_3437 = equal_2935_s2_q ? {patches_chance_q[14:0], parity_3436} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3439;
  assign not_3439 = ~and_2247;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3442;
  assign select_3442 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3442};
  // hls/stages/agreement.hpp:795
  logic and_3448;
  assign and_3448 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3452;
  assign and_3452 = not_3439 & (patches_fixed_q | ((not_570_s2_q & and_3448) & and_2219));
  // hls/stages/patches.hpp:358
  logic not_3464;
  assign not_3464 = ~select_2162[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3466;
  assign select_3466 = sample_pair_whole_s2_q ? (equal_2163 ? select_2162 : {not_3464, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:275
  logic [51:0] select_3565;
  assign select_3565 = or_2255_s2_q ? {and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3567;
  assign select_3567 = equal_2249_s2_q ? patches_codes_at_q : (equal_2251_s2_q ? other[55:4] : select_3565);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_2354_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3570;
  assign select_3570 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:275
  logic [27:0] select_3572;
  assign select_3572 = equal_2251_s2_q ? (new_row_s2_q ? word : select_3570) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3574;
  assign select_3574 = less_2341_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3576;
  assign select_3576 = less_3575_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:275
  logic [55:0] select_3578;
  assign select_3578 = or_2255_s2_q ? (equal_2254_s2_q ? patches_next_codes_q : select_3576) : patches_next_codes_q;
  logic [55:0] select_3580;
  assign select_3580 = equal_2249_s2_q ? patches_next_codes_q : (equal_2251_s2_q ? select_3574 : select_3578);
  // hls/stages/count_bits.hpp:24
  logic parity_3585;
  assign parity_3585 = ^{and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378};
  // hls/stages/count_bits.hpp:25
  logic or_3589;
  assign or_3589 = ({and_2381_s2_q, and_2378} == 2'h3) | (and_2397_s2_q & (and_2381_s2_q | and_2378));
  logic and_3590;
  assign and_3590 = and_2400_s2_q & (^{and_2397_s2_q, and_2381_s2_q, and_2378});
  // hls/stages/count_bits.hpp:24
  logic xor_3591;
  assign xor_3591 = or_3589 ^ and_3590;
  // hls/stages/count_bits.hpp:27
  logic and_3592;
  assign and_3592 = or_3589 & and_3590;
  // hls/stages/agreement.hpp:275
  logic [2:0] select_3594;
  assign select_3594 = or_2255_s2_q ? (and_2423_s2_q ? {and_3592, xor_3591, parity_3585} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3598;
  assign sum_3598 = {7'h0, patches_set_q} + (equal_2254_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3608;
  assign select_3608 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:275
  logic [47:0] select_3610;
  assign select_3610 = equal_2249_s2_q ? patches_left_row_q : (equal_2251_s2_q ? select_3608 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3608;
  // hls/stages/count_bits.hpp:24
  logic xor_3614;
  assign xor_3614 = bits[17] ^ (^{select_3608[16:15], other[16:15]});
  logic xor_3617;
  assign xor_3617 = bits[11] ^ (^{select_3608[10:9], other[10:9]});
  logic xor_3620;
  assign xor_3620 = bits[14] ^ (^{select_3608[13:12], other[13:12]});
  logic xor_3623;
  assign xor_3623 = xor_3614 ^ (^{select_3608[14:9], other[14:9]});
  logic xor_3626;
  assign xor_3626 = bits[47] ^ (^{select_3608[46:45], other[46:45]});
  logic xor_3629;
  assign xor_3629 = bits[8] ^ (^{select_3608[7:6], other[7:6]});
  logic xor_3632;
  assign xor_3632 = bits[2] ^ (^{select_3608[1:0], other[1:0]});
  logic xor_3635;
  assign xor_3635 = bits[5] ^ (^{select_3608[4:3], other[4:3]});
  logic xor_3638;
  assign xor_3638 = xor_3629 ^ (^{select_3608[5:0], other[5:0]});
  logic parity_3640;
  assign parity_3640 = ^{select_3608[47:45], select_3608[8:0], other[47:45], other[8:0]};
  logic xor_3641;
  assign xor_3641 = xor_3623 ^ parity_3640;
  logic xor_3644;
  assign xor_3644 = bits[44] ^ (^{select_3608[43:42], other[43:42]});
  logic xor_3647;
  assign xor_3647 = bits[38] ^ (^{select_3608[37:36], other[37:36]});
  logic xor_3650;
  assign xor_3650 = bits[41] ^ (^{select_3608[40:39], other[40:39]});
  logic xor_3656;
  assign xor_3656 = bits[26] ^ (^{select_3608[25:24], other[25:24]});
  logic xor_3659;
  assign xor_3659 = bits[20] ^ (^{select_3608[19:18], other[19:18]});
  logic xor_3662;
  assign xor_3662 = bits[23] ^ (^{select_3608[22:21], other[22:21]});
  logic xor_3665;
  assign xor_3665 = xor_3656 ^ (^{select_3608[23:18], other[23:18]});
  logic xor_3668;
  assign xor_3668 = bits[35] ^ (^{select_3608[34:33], other[34:33]});
  logic xor_3671;
  assign xor_3671 = bits[29] ^ (^{select_3608[28:27], other[28:27]});
  logic xor_3674;
  assign xor_3674 = bits[32] ^ (^{select_3608[31:30], other[31:30]});
  logic xor_3677;
  assign xor_3677 = xor_3668 ^ (^{select_3608[32:27], other[32:27]});
  logic xor_3678;
  assign xor_3678 = xor_3665 ^ xor_3677;
  // hls/stages/count_bits.hpp:25
  logic or_3686;
  assign or_3686 = (xor_3617 & xor_3620) | (xor_3614 & (xor_3617 | xor_3620));
  logic or_3690;
  assign or_3690 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3694;
  assign or_3694 = (xor_3632 & xor_3635) | (xor_3629 & (xor_3632 | xor_3635));
  // hls/stages/count_bits.hpp:23
  logic or_3701;
  assign or_3701 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3705;
  assign or_3705 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3709;
  assign or_3709 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3712;
  assign parity_3712 = ^{or_3709, or_3705, or_3701};
  // hls/stages/count_bits.hpp:23
  logic or_3716;
  assign or_3716 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3720;
  assign or_3720 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3724;
  assign or_3724 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3727;
  assign parity_3727 = ^{or_3724, or_3720, or_3716};
  logic parity_3730;
  assign parity_3730 = ^{or_3724, or_3720, or_3716, or_3709, or_3705, or_3701, or_3694, or_3690, or_3686};
  // hls/stages/count_bits.hpp:23
  logic or_3734;
  assign or_3734 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3738;
  assign or_3738 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3742;
  assign or_3742 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3750;
  assign or_3750 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3754;
  assign or_3754 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3758;
  assign or_3758 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3761;
  assign parity_3761 = ^{or_3758, or_3754, or_3750};
  // hls/stages/count_bits.hpp:23
  logic or_3765;
  assign or_3765 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3769;
  assign or_3769 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3773;
  assign or_3773 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3776;
  assign parity_3776 = ^{or_3773, or_3769, or_3765};
  logic parity_3779;
  assign parity_3779 = ^{or_3773, or_3769, or_3765, or_3758, or_3754, or_3750, or_3742, or_3738, or_3734};
  // hls/stages/count_bits.hpp:25
  logic or_3783;
  assign or_3783 = (xor_3647 & xor_3650) | (xor_3644 & (xor_3647 | xor_3650));
  logic or_3787;
  assign or_3787 = (xor_3659 & xor_3662) | (xor_3656 & (xor_3659 | xor_3662));
  logic or_3791;
  assign or_3791 = (xor_3671 & xor_3674) | (xor_3668 & (xor_3671 | xor_3674));
  // hls/stages/count_bits.hpp:24
  logic parity_3794;
  assign parity_3794 = ^{or_3791, or_3787, or_3783};
  // hls/stages/count_bits.hpp:25
  logic and_3795;
  assign and_3795 = xor_3641 & (^{xor_3678, select_3608[44:36], other[44:36]});
  logic or_3799;
  assign or_3799 = (xor_3626 & xor_3638) | (xor_3623 & (xor_3626 | xor_3638));
  logic and_3802;
  assign and_3802 = (xor_3644 ^ (^{select_3608[41:36], other[41:36]})) & (xor_3665 | xor_3677);
  logic or_3803;
  assign or_3803 = (xor_3665 & xor_3677) | and_3802;
  // hls/stages/count_bits.hpp:24
  logic parity_3806;
  assign parity_3806 = ^{or_3803, or_3799, and_3795};
  logic parity_3809;
  assign parity_3809 = ^{or_3803, or_3799, and_3795, or_3791, or_3787, or_3783, or_3773, or_3769, or_3765, or_3758, or_3754, or_3750, or_3742, or_3738, or_3734};
  logic parity_3811;
  assign parity_3811 = ^{or_3803, or_3799, and_3795, or_3791, or_3787, or_3783, or_3773, or_3769, or_3765, or_3758, or_3754, or_3750, or_3742, or_3738, or_3734, or_3724, or_3720, or_3716, or_3709, or_3705, or_3701, or_3694, or_3690, or_3686};
  // hls/stages/count_bits.hpp:25
  logic and_3812;
  assign and_3812 = parity_3730 & parity_3809;
  logic or_3816;
  assign or_3816 = (parity_3712 & parity_3727) | ((^{or_3694, or_3690, or_3686}) & (parity_3712 | parity_3727));
  logic or_3820;
  assign or_3820 = (parity_3794 & parity_3806) | (parity_3779 & (parity_3794 | parity_3806));
  logic or_3827;
  assign or_3827 = (parity_3761 & parity_3776) | ((^{or_3742, or_3738, or_3734}) & (parity_3761 | parity_3776));
  logic or_3831;
  assign or_3831 = (or_3787 & or_3791) | (or_3783 & (or_3787 | or_3791));
  logic or_3835;
  assign or_3835 = (or_3799 & or_3803) | (and_3795 & (or_3799 | or_3803));
  // hls/stages/count_bits.hpp:23
  logic or_3842;
  assign or_3842 = (or_3738 & or_3742) | (or_3734 & (or_3738 | or_3742));
  // hls/stages/count_bits.hpp:25
  logic or_3846;
  assign or_3846 = (or_3754 & or_3758) | (or_3750 & (or_3754 | or_3758));
  logic or_3850;
  assign or_3850 = (or_3769 & or_3773) | (or_3765 & (or_3769 | or_3773));
  // hls/stages/count_bits.hpp:24
  logic parity_3853;
  assign parity_3853 = ^{or_3850, or_3846, or_3842};
  // hls/stages/count_bits.hpp:23
  logic or_3857;
  assign or_3857 = (or_3690 & or_3694) | (or_3686 & (or_3690 | or_3694));
  // hls/stages/count_bits.hpp:25
  logic or_3861;
  assign or_3861 = (or_3705 & or_3709) | (or_3701 & (or_3705 | or_3709));
  logic or_3865;
  assign or_3865 = (or_3720 & or_3724) | (or_3716 & (or_3720 | or_3724));
  // hls/stages/count_bits.hpp:24
  logic parity_3868;
  assign parity_3868 = ^{or_3865, or_3861, or_3857};
  logic parity_3871;
  assign parity_3871 = ^{or_3865, or_3861, or_3857, or_3850, or_3846, or_3842, or_3835, or_3831, or_3827};
  logic parity_3873;
  assign parity_3873 = ^{or_3865, or_3861, or_3857, or_3850, or_3846, or_3842, or_3835, or_3831, or_3827, or_3820, or_3816, and_3812};
  // hls/stages/count_bits.hpp:25
  logic or_3877;
  assign or_3877 = (or_3831 & or_3835) | (or_3827 & (or_3831 | or_3835));
  logic or_3881;
  assign or_3881 = (or_3846 & or_3850) | (or_3842 & (or_3846 | or_3850));
  logic or_3885;
  assign or_3885 = (or_3861 & or_3865) | (or_3857 & (or_3861 | or_3865));
  // hls/stages/count_bits.hpp:24
  logic parity_3888;
  assign parity_3888 = ^{or_3885, or_3881, or_3877};
  // hls/stages/count_bits.hpp:25
  logic and_3889;
  assign and_3889 = (^{or_3820, or_3816, and_3812}) & parity_3871;
  logic or_3893;
  assign or_3893 = (or_3816 & or_3820) | (and_3812 & (or_3816 | or_3820));
  logic or_3897;
  assign or_3897 = (parity_3853 & parity_3868) | ((^{or_3835, or_3831, or_3827}) & (parity_3853 | parity_3868));
  // hls/stages/count_bits.hpp:24
  logic parity_3900;
  assign parity_3900 = ^{or_3897, or_3893, and_3889};
  // hls/stages/count_bits.hpp:25
  logic and_3902;
  assign and_3902 = parity_3888 & parity_3900;
  logic or_3906;
  assign or_3906 = (or_3881 & or_3885) | (or_3877 & (or_3881 | or_3885));
  logic or_3910;
  assign or_3910 = (or_3893 & or_3897) | (and_3889 & (or_3893 | or_3897));
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3955;
  assign select_3955 = equal_2251_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3958;
  assign select_3958 = equal_2249_s2_q ? patches_summed_first_q : (equal_2251_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3966;
  assign select_3966 = less_2429_s2_q ? (or_2432_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3969;
  assign select_3969 = less_2429_s2_q ? (or_2432_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3972;
  assign select_3972 = less_2429_s2_q ? (or_2432_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:275
  logic select_3977;
  assign select_3977 = equal_2249_s2_q ? (less_2429_s2_q & (or_2432_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3982;
  assign or_3982 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3983;
  assign and_3983 = patches_read_searches_s2_q & or_3982;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3984;
  assign select_3984 = and_3983 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3984};
  // hls/stages/patches.hpp:559
  logic and_3989;
  assign and_3989 = less_2429_s2_q & (or_2432_s2_q & (equal_2430_s2_q & (away == 6'h3f)));
  logic and_3994;
  assign and_3994 = less_2429_s2_q & (or_2432_s2_q & (equal_2430_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3996;
  assign sum_3996 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3999;
  assign select_3999 = (equal_2430_s2_q & ({sum_3996[6], sum_3996} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_4001;
  assign select_4001 = less_2429_s2_q ? (or_2432_s2_q ? select_3999 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_4003;
  assign select_4003 = and_3983 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:275
  logic [9:0] select_4004;
  assign select_4004 = equal_2249_s2_q ? select_4003[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4005;
  assign select_4005 = equal_2249_s2_q ? select_4003[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_4007;
  assign select_4007 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_4008;
  assign select_4008 = equal_2249_s2_q ? select_4007 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_4009;
  assign select_4009 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_4010;
  assign select_4010 = equal_2249_s2_q ? select_4009 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_4012;
  assign select_4012 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_4014;
  assign select_4014 = equal_2249_s2_q ? (patches_read_first_q ? patches_read_far_q : select_4012) : patches_peak_far_q;
  logic [9:0] select_4017;
  assign select_4017 = equal_2249_s2_q ? (equal_4015_s2_q ? sum_3598 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:795
  logic select_4268;
  assign select_4268 = equal_569_s2_q ? shown_shown_q : (drew_q ? select_2489 : shown_shown_q);
  logic select_4270;
  assign select_4270 = equal_569_s2_q ? shown_nearer_q : (drew_q ? select_2492 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4272;
  assign sum_4272 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:464
  logic [2:0] select_4274;
  assign select_4274 = less_4271_s2_q ? (sum_4272[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4276;
  assign select_4276 = equal_2935_s2_q ? (equal_677_s2_q ? 3'h0 : select_4274) : region_row_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_4281;
  assign select_4281 = equal_569_s2_q ? select_2443 : (drew_q ? (ends_cell_s2_q ? select_2542 : select_2443) : 8'h1);
  // hls/stages/agreement.hpp:464
  logic [8:0] select_4295;
  assign select_4295 = equal_677_s2_q ? {{2{difference_4293[6]}}, difference_4293} : (less_4271_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:527
  logic [8:0] select_4297;
  assign select_4297 = and_544_s2_q ? (equal_2935_s2_q ? select_4295 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] select_4299;
  assign select_4299 = equal_677_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:527
  logic [6:0] select_4301;
  assign select_4301 = and_544_s2_q ? (equal_2935_s2_q ? select_4299 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4302;
  assign sum_4302 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4303;
  assign select_4303 = sum_4272[7] ? {1'b1, sum_4272[6:0], region_down_rest_q[0]} : sum_4302;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4272[7];
  // hls/stages/agreement.hpp:464
  logic select_4307;
  assign select_4307 = equal_2935_s2_q ? (equal_677_s2_q | (less_4271_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4312;
  assign or_4312 = segment_starts_q | not_572_s2_q;
  // hls/stages/agreement.hpp:1037
  logic select_4315;
  assign select_4315 = inside_v_s2_q ? (sum_2456_s2_q ? (equal_2242 & or_2458) : or_2458) : or_4312;
  // hls/stages/agreement.hpp:795
  logic select_4318;
  assign select_4318 = equal_569_s2_q ? or_4312 : (drew_q ? (ends_cell_s2_q ? select_4315 : or_4312) : or_4312);
  logic select_4478;
  assign select_4478 = drew_q ? (ends_cell_s2_q ? and_2530 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4481;
  assign select_4481 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4483;
  assign select_4483 = equal_569_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4481 : centres_values_0_of_skin_q);
  logic select_4484;
  assign select_4484 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4486;
  assign select_4486 = equal_569_s2_q ? centres_values_1_textured_q : (drew_q ? select_4484 : centres_values_1_textured_q);
  logic select_4487;
  assign select_4487 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4489;
  assign select_4489 = equal_569_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4487 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:464
  logic [12:0] select_4495;
  assign select_4495 = equal_2935_s2_q ? (or_4492_s2_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:527
  logic [6:0] select_4498;
  assign select_4498 = and_544_s2_q ? (equal_2935_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/registration.hpp:258
  logic not_4585;
  assign not_4585 = ~quarter[1];
  logic [3:0] select_4586;
  assign select_4586 = quarter[0] ? {quarter[1], 1'b0, not_4585, 1'b0} : {1'b0, quarter[1], 1'b0, not_4585};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2087;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2130;
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
  assign patches_choices_raddr = select_2161;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2163));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1408; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2453;
  logic regions_re;
  assign regions_re = s2_en & (equal_569_s2_q ? (x_s2_q[6] & not_2454) : and_2461);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1419; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2513, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2520 & less_2521);
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
  assign averager_memory_waddr = select_509_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_518_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_537, and_533, sum_529, sum_525};
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
  assign census_memory_we = s2_en & and_544_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_562, whole_2, select_554, select_550};
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
  assign moments_memory_waddr = select_568_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_586_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_644_s2_q, and_642_s2_q, and_637_s2_q, and_635};
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
  assign best_left_we = s2_en & and_2034_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2033, select_2030, select_2027, select_2025, select_1998, select_1995, select_1987, select_1986, select_1982};
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
  assign best_right_we = s2_en & and_2034_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2044, select_2043, select_2040, select_2039};
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
  assign shown_right_waddr = select_2051_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2062;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2059, not_572_s2_q};
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
  assign left_turns_wdata = {and_2070, and_2067};
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
  assign right_turns_wdata = {and_2079, and_2076};
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
  assign patches_right_codes_waddr = {sum_2362, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2414_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2418, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2428_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2047_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2488, textured};
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
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2659;
      averager_mask_q <= select_2661;
      averager_of_skin_q <= select_2663;
      census_filled_q <= and_544_s2_q ? {select_680[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2758;
      moments_turned_1_q <= sum_2760;
      moments_before_0_q <= equal_569_s2_q ? select_2762 : moments_before_0_q;
      moments_before_1_q <= equal_569_s2_q ? select_2764 : moments_before_1_q;
      moments_has_before_q <= select_2767;
      moments_most_before_q <= select_2770;
      moments_left_begins_q <= select_2774;
      moments_left_alone_q <= select_2778;
      moments_left_other_stops_q <= select_2781;
      moments_right_begins_q <= select_2784;
      moments_right_alone_q <= select_2788;
      moments_right_other_stops_q <= select_2791;
      moments_out_of_step_q <= or_2794;
      moments_turns_0_q <= and_2802;
      moments_turns_1_q <= and_2806;
      moments_begins_alone_q <= and_2815;
      moments_ends_q <= equal_569_s2_q & (equal_2761 & (not_2816 | and_2818));
      rows_passed_above_q <= and_544_s2_q ? select_679 : rows_passed_above_q;
      shift_allowed_q <= not_3042 & (~less_3043);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3050 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3170});
      counts_turned_right_q <= and_3050 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3177});
      registration_displacement_over_q <= drew_q ? sum_3201[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3203;
      registration_slope_here_q <= select_3205;
      registration_expected_q <= select_3207;
      registration_of_right_q <= equal_569_s2_q ? registration_of_right_q : select_3269;
      registration_was_inside_q <= equal_569_s2_q ? registration_was_inside_q : select_3272;
      registration_fresh_q <= select_3281;
      patches_chance_q <= and_544_s2_q ? select_3437 : patches_chance_q;
      patches_fixed_q <= and_3452;
      patches_choice_valid_q <= and_2247 ? (select_2220 & not_3439) : select_2220;
      patches_choice_column_q <= select_2225;
      patches_choice_shift_q <= select_2230;
      patches_choice_slope_q <= select_2241;
      patches_band_q <= sample_pair_whole_s2_q ? select_2262 : patches_band_q;
      patches_fetch_q <= select_3466;
      patches_codes_at_q <= select_3567;
      patches_codes_further_q <= equal_2249_s2_q ? patches_codes_further_q : select_3572;
      patches_next_codes_q <= select_3580;
      patches_set_q <= equal_2249_s2_q ? 3'h0 : (equal_2251_s2_q ? 3'h0 : select_3594);
      patches_size_q <= sum_3598;
      patches_left_row_q <= select_3610;
      patches_summed_row_column_q <= equal_2249_s2_q ? patches_summed_row_column_q : select_3955;
      patches_summed_first_q <= select_3958;
      patches_read_row_differing_q <= equal_2249_s2_q ? select_3966 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2249_s2_q ? select_3969 : patches_read_row_column_q;
      patches_read_at_q <= equal_2249_s2_q ? select_3972 : patches_read_at_q;
      patches_read_first_q <= select_3977;
      patches_read_above_q <= equal_2249_s2_q ? and_3989 : patches_read_above_q;
      patches_read_below_q <= equal_2249_s2_q ? and_3994 : patches_read_below_q;
      patches_read_far_q <= equal_2249_s2_q ? select_4001 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4004;
      patches_peak_best_column_q <= select_4005;
      patches_peak_row_q <= equal_2249_s2_q ? select_3984 : patches_peak_row_q;
      patches_peak_above_q <= select_4008;
      patches_peak_below_q <= select_4010;
      patches_peak_far_q <= select_4014;
      patches_peak_size_q <= select_4017;
      patches_frame_ended_q <= equal_569_s2_q & equal_2761;
      shown_shown_q <= select_4268;
      shown_nearer_q <= select_4270;
      region_row_q <= and_544_s2_q ? select_4276 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4281;
      region_down_rest_q <= select_4297;
      region_down_back_q <= select_4301;
      region_down_next_q <= select_4303;
      region_fresh_q <= and_544_s2_q ? select_4307 : region_fresh_q;
      segment_starts_q <= select_4318;
      centres_values_0_textured_q <= equal_569_s2_q ? centres_values_0_textured_q : select_4478;
      centres_values_0_of_skin_q <= select_4483;
      centres_values_1_textured_q <= select_4486;
      centres_values_1_of_skin_q <= select_4489;
      map_row_q <= and_544_s2_q ? select_4495 : map_row_q;
      map_width_q <= select_4498;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_521 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_527 : averager_running_1_q;
      averager_total_0_q <= select_2637;
      averager_total_1_q <= select_2639;
      census_columns_values_0_cell_0_left_q <= select_2664;
      census_columns_values_0_cell_0_right_q <= select_2665;
      census_columns_values_0_cell_0_mask_q <= and_544_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2667;
      census_columns_values_0_cell_1_right_q <= select_2668;
      census_columns_values_0_cell_1_mask_q <= select_2669;
      census_columns_values_0_cell_2_left_q <= select_2670;
      census_columns_values_0_cell_2_right_q <= select_2671;
      census_columns_values_0_cell_2_mask_q <= select_2672;
      census_columns_values_0_cell_2_of_skin_q <= select_2673;
      census_columns_values_0_cell_3_left_q <= select_2674;
      census_columns_values_0_cell_3_right_q <= select_2675;
      census_columns_values_0_cell_3_mask_q <= select_2676;
      census_columns_values_0_cell_4_left_q <= select_2677;
      census_columns_values_0_cell_4_right_q <= select_2678;
      census_columns_values_0_cell_4_mask_q <= select_2679;
      census_columns_values_1_cell_0_left_q <= select_2680;
      census_columns_values_1_cell_0_right_q <= select_2681;
      census_columns_values_1_cell_0_mask_q <= select_2682;
      census_columns_values_1_cell_1_left_q <= select_2683;
      census_columns_values_1_cell_1_right_q <= select_2684;
      census_columns_values_1_cell_1_mask_q <= select_2685;
      census_columns_values_1_cell_2_left_q <= select_2686;
      census_columns_values_1_cell_2_right_q <= select_2687;
      census_columns_values_1_cell_2_mask_q <= select_2688;
      census_columns_values_1_cell_2_of_skin_q <= select_2689;
      census_columns_values_1_cell_3_left_q <= select_2690;
      census_columns_values_1_cell_3_right_q <= select_2691;
      census_columns_values_1_cell_3_mask_q <= select_2692;
      census_columns_values_1_cell_4_left_q <= select_2693;
      census_columns_values_1_cell_4_right_q <= select_2694;
      census_columns_values_1_cell_4_mask_q <= select_2695;
      census_columns_values_2_cell_0_left_q <= select_2696;
      census_columns_values_2_cell_0_right_q <= select_2697;
      census_columns_values_2_cell_0_mask_q <= select_2698;
      census_columns_values_2_cell_1_left_q <= select_2699;
      census_columns_values_2_cell_1_right_q <= select_2700;
      census_columns_values_2_cell_1_mask_q <= select_2701;
      census_columns_values_2_cell_2_left_q <= select_2702;
      census_columns_values_2_cell_2_right_q <= select_2703;
      census_columns_values_2_cell_2_mask_q <= select_2704;
      census_columns_values_2_cell_3_left_q <= select_2705;
      census_columns_values_2_cell_3_right_q <= select_2706;
      census_columns_values_2_cell_3_mask_q <= select_2707;
      census_columns_values_2_cell_4_left_q <= select_2708;
      census_columns_values_2_cell_4_right_q <= select_2709;
      census_columns_values_2_cell_4_mask_q <= select_2710;
      census_columns_values_3_cell_0_mask_q <= select_2711;
      census_columns_values_3_cell_1_left_q <= select_2712;
      census_columns_values_3_cell_1_right_q <= select_2713;
      census_columns_values_3_cell_1_mask_q <= select_2714;
      census_columns_values_3_cell_2_mask_q <= select_2715;
      census_columns_values_3_cell_3_left_q <= select_2716;
      census_columns_values_3_cell_3_right_q <= select_2717;
      census_columns_values_3_cell_3_mask_q <= select_2718;
      census_columns_values_3_cell_4_mask_q <= select_2719;
      sharpness_last_mean_0_q <= and_544_s2_q ? select_550 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_544_s2_q ? select_554 : sharpness_last_mean_1_q;
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
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic draws_late_s3_q;
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
  logic [2:0] select_505_s3_q;
  logic row_starts_s3_q;
  logic [6:0] select_538_s3_q;
  logic [6:0] last_s3_q;
  logic and_542_s3_q;
  logic and_544_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_547_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_564_s3_q;
  logic equal_569_s3_q;
  logic not_570_s3_q;
  logic so_s3_q;
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
  logic less_669_s3_q;
  logic less_670_s3_q;
  logic less_671_s3_q;
  logic less_672_s3_q;
  logic less_673_s3_q;
  logic and_681_s3_q;
  logic and_706_s3_q;
  logic and_707_s3_q;
  logic [11:0] sum_722_s3_q;
  logic [9:0] sum_725_s3_q;
  logic and_733_s3_q;
  logic and_737_s3_q;
  logic less_738_s3_q;
  logic less_742_s3_q;
  logic less_744_s3_q;
  logic equal_2080_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2086_s3_q;
  logic equal_2088_s3_q;
  logic equal_2090_s3_q;
  logic equal_2092_s3_q;
  logic equal_2094_s3_q;
  logic equal_2096_s3_q;
  logic equal_2098_s3_q;
  logic equal_2100_s3_q;
  logic equal_2102_s3_q;
  logic less_2111_s3_q;
  logic or_2115_s3_q;
  logic equal_2135_s3_q;
  logic and_2145_s3_q;
  logic select_2162_s3_q;
  logic equal_2163_s3_q;
  logic and_2171_s3_q;
  logic equal_2173_s3_q;
  logic select_2220_s3_q;
  logic and_2248_s3_q;
  logic equal_2249_s3_q;
  logic equal_2251_s3_q;
  logic not_2256_s3_q;
  logic and_2264_s3_q;
  logic [4:0] select_2279_s3_q;
  logic select_2285_s3_q;
  logic [3:0] select_2325_s3_q;
  logic or_2446_s3_q;
  logic or_2449_s3_q;
  logic or_2452_s3_q;
  logic not_2454_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2481_s3_q;
  logic and_2486_s3_q;
  logic and_2520_s3_q;
  logic less_2521_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2527_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2545_s3_q;
  logic or_2548_s3_q;
  logic or_2551_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2603_s3_q;
  logic [11:0] sum_2735_s3_q;
  logic [9:0] sum_2738_s3_q;
  logic equal_2746_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3050_s3_q;
  logic and_3056_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3118_s3_q;
  logic and_3152_s3_q;
  logic and_3211_s3_q;
  logic and_3212_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3248_s3_q;
  logic and_3262_s3_q;
  logic equal_3304_s3_q;
  logic parity_3682_s3_q;
  logic parity_3811_s3_q;
  logic parity_3873_s3_q;
  logic xor_3901_s3_q;
  logic parity_3913_s3_q;
  logic or_3917_s3_q;
  logic equal_3918_s3_q;
  logic and_4018_s3_q;
  logic less_4043_s3_q;
  logic equal_4342_s3_q;
  logic and_4506_s3_q;
  logic and_4521_s3_q;
  logic and_4523_s3_q;
  logic not_4535_s3_q;
  logic equal_4588_s3_q;
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
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      draws_late_s3_q <= draws_late_s2_q;
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
      select_505_s3_q <= select_505_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_538_s3_q <= select_538_s2_q;
      last_s3_q <= last_s2_2_q;
      and_542_s3_q <= and_542_s2_q;
      and_544_s3_q <= and_544_s2_q;
      grey_s3_q <= grey;
      equal_547_s3_q <= equal_547;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_564_s3_q <= equal_564_s2_q;
      equal_569_s3_q <= equal_569_s2_q;
      not_570_s3_q <= not_570_s2_q;
      so_s3_q <= drew_q;
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
      less_669_s3_q <= less_669;
      less_670_s3_q <= less_670;
      less_671_s3_q <= less_671;
      less_672_s3_q <= less_672;
      less_673_s3_q <= less_673;
      and_681_s3_q <= and_681;
      and_706_s3_q <= whole_22 & and_681;
      and_707_s3_q <= census_columns_values_1_cell_2_mask_q & and_681;
      sum_722_s3_q <= {1'b0, sum_718} + {2'h0, sum_721};
      sum_725_s3_q <= {9'h0, difference_723[9]} + {1'b0, xor_724};
      and_733_s3_q <= and_733;
      and_737_s3_q <= and_737;
      less_738_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_742_s3_q <= {{5{sum_741[6]}}, sum_741, half_grey_levels_2[3:0]} < 16'hffe1;
      less_744_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2080_s3_q <= equal_2080;
      all_s3_q <= all;
      sum_2086_s3_q <= sum_2086;
      equal_2088_s3_q <= equal_2088;
      equal_2090_s3_q <= equal_2090;
      equal_2092_s3_q <= equal_2092;
      equal_2094_s3_q <= equal_2094;
      equal_2096_s3_q <= equal_2096;
      equal_2098_s3_q <= equal_2098;
      equal_2100_s3_q <= equal_2100;
      equal_2102_s3_q <= equal_2102;
      less_2111_s3_q <= less_2111;
      or_2115_s3_q <= or_2115;
      equal_2135_s3_q <= (registration_fresh_q & select_2133) == 4'h0;
      and_2145_s3_q <= not_570_s2_q & and_2129;
      select_2162_s3_q <= select_2162[1];
      equal_2163_s3_q <= equal_2163;
      and_2171_s3_q <= and_2171;
      equal_2173_s3_q <= equal_2173;
      select_2220_s3_q <= select_2220;
      and_2248_s3_q <= and_2248;
      equal_2249_s3_q <= equal_2249_s2_q;
      equal_2251_s3_q <= equal_2251_s2_q;
      not_2256_s3_q <= not_2256_s2_q;
      and_2264_s3_q <= and_2248 & equal_2263;
      select_2279_s3_q <= select_2279_s2_q;
      select_2285_s3_q <= select_2285_s2_q;
      select_2325_s3_q <= select_2325_s2_q;
      or_2446_s3_q <= or_2446;
      or_2449_s3_q <= or_2449;
      or_2452_s3_q <= or_2452;
      not_2454_s3_q <= not_2454;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2481_s3_q <= inside_v_s2_q & (and_2479 & and_2058);
      and_2486_s3_q <= not_570_s2_q & and_2461;
      and_2520_s3_q <= and_2520;
      less_2521_s3_q <= less_2521;
      index_2_s3_q <= index_2[5:0];
      sum_2527_s3_q <= sum_2527;
      textured_2_s3_q <= textured_2;
      or_2545_s3_q <= or_2545;
      or_2548_s3_q <= select_2542[7] | (~({select_2542[6], select_2542[3:2]} == 3'h0));
      or_2551_s3_q <= select_2542[7] | (~(select_2542[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2603_s3_q <= and_2603;
      sum_2735_s3_q <= {1'b0, sum_2731} + {2'h0, sum_2734};
      sum_2738_s3_q <= {9'h0, difference_2736[9]} + {1'b0, xor_2737};
      equal_2746_s3_q <= equal_2746_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3050_s3_q <= and_3050;
      and_3056_s3_q <= and_3056;
      explained_2_s3_q <= explained_2;
      and_3118_s3_q <= not_570_s2_q & and_3117;
      and_3152_s3_q <= not_570_s2_q & and_3151;
      and_3211_s3_q <= not_570_s2_q & (drew_q & (half_ends & equal_3208));
      and_3212_s3_q <= and_3212;
      residual_s3_q <= residual[7:0];
      and_3248_s3_q <= and_3248;
      and_3262_s3_q <= and_3212 & less_3261;
      equal_3304_s3_q <= (registration_fresh_q & select_3302) == 4'h0;
      parity_3682_s3_q <= ^{xor_3678, xor_3641, select_3608[44:36], other[44:36]};
      parity_3811_s3_q <= parity_3811;
      parity_3873_s3_q <= parity_3873;
      xor_3901_s3_q <= parity_3888 ^ parity_3900;
      parity_3913_s3_q <= ^{or_3910, or_3906, and_3902};
      or_3917_s3_q <= (or_3906 & or_3910) | (and_3902 & (or_3906 | or_3910));
      equal_3918_s3_q <= equal_3918_s2_q;
      and_4018_s3_q <= equal_2249_s2_q & equal_4015_s2_q;
      less_4043_s3_q <= select_4008 < select_4010;
      equal_4342_s3_q <= equal_4342_s2_q;
      and_4506_s3_q <= said_q;
      and_4521_s3_q <= and_2603 & ({sum_2527, index_2[5:0]} == {sum_2513, index[5:0]});
      and_4523_s3_q <= less_3031 & proven_q;
      not_4535_s3_q <= not_4535_s2_q;
      equal_4588_s3_q <= (registration_fresh_q & select_4586) == 4'h0;
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
  assign texture = sum_722_s3_q + {2'h0, sum_725_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_727;
  assign sum_727 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_729;
  assign sum_729 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_727});
  // hls/stages/census.hpp:317
  logic less_730;
  assign less_730 = 9'h4 < sum_729[13:5];
  logic and_731;
  assign and_731 = and_681_s3_q & less_730;
  // hls/stages/moments.hpp:30
  logic and_743;
  assign and_743 = (and_706_s3_q & and_733_s3_q) & less_742_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2137;
  assign equal_2137 = sum_2086_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2086_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2139;
  assign select_2139 = equal_2137 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2140;
  assign sum_2140 = (equal_2135_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2139[13]}}, select_2139};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2086_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2143;
  assign select_2143 = equal_2137 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2144;
  assign sum_2144 = (equal_2135_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2143[6]}}, select_2143};
  // hls/stages/patches.hpp:357
  logic [22:0] select_2265;
  assign select_2265 = and_2264_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2220_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2267;
  assign select_2267 = equal_2163_s3_q ? patches_place_0_valid_q : (select_2162_s3_q ? patches_place_0_valid_q : select_2265[0]);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2268;
  assign sum_2268 = {1'b0, select_538_s3_q, select_505_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_2269;
  assign select_2269 = select_2162_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2265[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2270;
  assign select_2270 = equal_2163_s3_q ? patches_place_0_column_q : select_2269[7:0];
  logic [5:0] select_2271;
  assign select_2271 = equal_2163_s3_q ? patches_place_0_shift_q : select_2269[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2272;
  assign sum_2272 = {1'b0, select_2270} + {{3{select_2271[5]}}, select_2271};
  // hls/stages/patches.hpp:132
  logic equal_2273;
  assign equal_2273 = {sum_2272, sum_2268[0], select_505_s3_q[1:0]} == {1'b0, sum_2268[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2275;
  assign or_2275 = row_starts_s3_q | (select_2267 & equal_2273);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2276;
  assign select_2276 = or_2275 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2286;
  assign select_2286 = or_2275 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2288;
  assign and_2288 = select_2285_s3_q & (~select_2286[5]);
  // hls/stages/patches.hpp:127
  logic select_2296;
  assign select_2296 = equal_2163_s3_q ? patches_place_1_valid_q : (select_2162_s3_q ? select_2265[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_2297;
  assign select_2297 = select_2162_s3_q ? select_2265[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2298;
  assign select_2298 = equal_2163_s3_q ? patches_place_1_column_q : select_2297[7:0];
  logic [5:0] select_2299;
  assign select_2299 = equal_2163_s3_q ? patches_place_1_shift_q : select_2297[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2300;
  assign sum_2300 = {1'b0, select_2298} + {{3{select_2299[5]}}, select_2299};
  // hls/stages/patches.hpp:132
  logic equal_2301;
  assign equal_2301 = {sum_2300[8], sum_2268, select_505_s3_q[1:0]} == {1'b0, sum_2300[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2303;
  assign or_2303 = row_starts_s3_q | (select_2296 & equal_2301);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2304;
  assign select_2304 = or_2303 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2305;
  assign select_2305 = or_2303 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2307;
  assign and_2307 = select_2285_s3_q & (~select_2305[5]);
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2314;
  assign sum_2314 = select_2270 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2315;
  assign equal_2315 = {sum_2314[7], select_538_s3_q, select_505_s3_q} == {1'b0, sum_2314[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2317;
  assign or_2317 = row_starts_s3_q | (select_2267 & equal_2315);
  logic [4:0] select_2318;
  assign select_2318 = or_2317 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2319;
  assign sum_2319 = select_2298 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2320;
  assign equal_2320 = {sum_2319[7], select_538_s3_q, select_505_s3_q} == {1'b0, sum_2319[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2323;
  assign select_2323 = (row_starts_s3_q | (select_2296 & equal_2320)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2318[4] ? select_2323[3:0] : select_2318[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2326;
  assign select_2326 = or_2317 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2332;
  assign and_2332 = (select_2285_s3_q & (select_2279_s3_q[3] ^ select_2279_s3_q[4])) & ((~select_2318[4]) | (~select_2323[4]));
  // hls/stages/patches.hpp:186
  logic less_2436;
  assign less_2436 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_2437;
  assign not_2437 = ~less_2436;
  logic [1:0] select_2438;
  assign select_2438 = patches_summed_first_s3_q ? 2'h2 : {less_2436, not_2437};
  logic [12:0] select_2440;
  assign select_2440 = select_2438[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2441;
  assign select_2441 = select_2438[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2442;
  assign select_2442 = (select_2438 == 2'h2) ? {select_2440[12:8], patches_sums_values_0_q[9:8], select_2440[7:0]} : select_2441;
  // hls/stages/agreement.hpp:907
  logic [6:0] select_2467;
  assign select_2467 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:908
  logic [6:0] sum_2468;
  assign sum_2468 = {6'h0, textured_s3_q} + select_2467;
  // hls/stages/agreement.hpp:1068
  logic [9:0] sum_2470;
  assign sum_2470 = {3'h0, sum_2468} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:907
  logic [6:0] select_2472;
  assign select_2472 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:908
  logic [6:0] sum_2473;
  assign sum_2473 = {6'h0, explained_s3_q} + select_2472;
  // hls/stages/agreement.hpp:1069
  logic [9:0] sum_2475;
  assign sum_2475 = {3'h0, sum_2473} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:907
  logic [6:0] select_2482;
  assign select_2482 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:909
  logic [6:0] sum_2483;
  assign sum_2483 = {6'h0, and_2481_s3_q} + select_2482;
  // hls/stages/agreement.hpp:1070
  logic [9:0] sum_2485;
  assign sum_2485 = {3'h0, sum_2483} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1101
  logic [2:0] select_2536;
  assign select_2536 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2537;
  assign difference_2537 = {1'b0, textured_2_s3_q} - {1'b0, select_2536};
  logic [4:0] t;
  assign t = {difference_2537[3], difference_2537} + (equal_564_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1107
  logic equal_2540;
  assign equal_2540 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1108
  logic [2:0] region_row;
  assign region_row = draws_late_s3_q ? 3'h5 : region_row_s3_q;
  // hls/stages/agreement.hpp:1109
  logic not_2553;
  assign not_2553 = ~region_row[2];
  logic [2:0] select_2554;
  assign select_2554 = region_row[1] ? {1'b0, not_2553, 1'b0} : {region_row[2], 1'b0, not_2553};
  logic [5:0] select_2555;
  assign select_2555 = region_row[0] ? {select_2554[2], 1'b0, select_2554[1], 1'b0, select_2554[0], 1'b0} : {1'b0, select_2554[2], 1'b0, select_2554[1], 1'b0, select_2554[0]};
  logic [11:0] select_2556;
  assign select_2556 = or_2551_s3_q ? {select_2555[5], 1'b0, select_2555[4], 1'b0, select_2555[3], 1'b0, select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0], 1'b0} : {1'b0, select_2555[5], 1'b0, select_2555[4], 1'b0, select_2555[3], 1'b0, select_2555[2], 1'b0, select_2555[1], 1'b0, select_2555[0]};
  logic [23:0] select_2557;
  assign select_2557 = or_2548_s3_q ? {select_2556[11], 1'b0, select_2556[10], 1'b0, select_2556[9], 1'b0, select_2556[8], 1'b0, select_2556[7], 1'b0, select_2556[6], 1'b0, select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0], 1'b0} : {1'b0, select_2556[11], 1'b0, select_2556[10], 1'b0, select_2556[9], 1'b0, select_2556[8], 1'b0, select_2556[7], 1'b0, select_2556[6], 1'b0, select_2556[5], 1'b0, select_2556[4], 1'b0, select_2556[3], 1'b0, select_2556[2], 1'b0, select_2556[1], 1'b0, select_2556[0]};
  logic [47:0] select_2558;
  assign select_2558 = or_2545_s3_q ? {select_2557[23], 1'b0, select_2557[22], 1'b0, select_2557[21], 1'b0, select_2557[20], 1'b0, select_2557[19], 1'b0, select_2557[18], 1'b0, select_2557[17], 1'b0, select_2557[16], 1'b0, select_2557[15], 1'b0, select_2557[14], 1'b0, select_2557[13], 1'b0, select_2557[12], 1'b0, select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0], 1'b0} : {1'b0, select_2557[23], 1'b0, select_2557[22], 1'b0, select_2557[21], 1'b0, select_2557[20], 1'b0, select_2557[19], 1'b0, select_2557[18], 1'b0, select_2557[17], 1'b0, select_2557[16], 1'b0, select_2557[15], 1'b0, select_2557[14], 1'b0, select_2557[13], 1'b0, select_2557[12], 1'b0, select_2557[11], 1'b0, select_2557[10], 1'b0, select_2557[9], 1'b0, select_2557[8], 1'b0, select_2557[7], 1'b0, select_2557[6], 1'b0, select_2557[5], 1'b0, select_2557[4], 1'b0, select_2557[3], 1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0]};
  // hls/stages/agreement.hpp:1037
  logic and_2562;
  assign and_2562 = good_known_q & (~((good_q & select_2558) == 48'h0));
  // hls/stages/agreement.hpp:1103
  logic [2:0] select_2571;
  assign select_2571 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2572;
  assign difference_2572 = {1'b0, shown_2_s3_q} - {1'b0, select_2571};
  logic [4:0] around;
  assign around = {difference_2572[3], difference_2572} + (equal_564_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1111
  logic [5:0] sum_2575;
  assign sum_2575 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2540 ? and_2562 : (~({sum_2575, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1104
  logic [2:0] select_2587;
  assign select_2587 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2588;
  assign difference_2588 = {1'b0, near_2_s3_q} - {1'b0, select_2587};
  logic [4:0] n;
  assign n = {difference_2588[3], difference_2588} + (equal_564_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1120
  logic and_2592;
  assign and_2592 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2629;
  assign select_2629 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2631;
  assign select_2631 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2633;
  assign select_2633 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2635;
  assign select_2635 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2640;
  assign sum_2640 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2641;
  assign difference_2641 = {1'b0, sum_2640[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2642;
  assign xor_2642 = {difference_2641[8:0], sum_2640[0]} ^ {10{difference_2641[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2641[9]} + {1'b0, xor_2642};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_547_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2647;
  assign select_2647 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2648;
  assign sum_2648 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2649;
  assign difference_2649 = {1'b0, sum_2648[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2650;
  assign xor_2650 = {difference_2649[8:0], sum_2648[0]} ^ {10{difference_2649[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2649[9]} + {1'b0, xor_2650};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_547_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2655;
  assign select_2655 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2739;
  assign sum_2739 = sum_2735_s3_q + {2'h0, sum_2738_s3_q};
  // hls/stages/agreement.hpp:527
  logic [11:0] select_2741;
  assign select_2741 = and_544_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2742;
  assign select_2742 = and_544_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2743;
  assign select_2743 = and_544_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2744;
  assign select_2744 = and_544_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2747;
  assign sum_2747 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2739};
  logic [13:0] sum_2749;
  assign sum_2749 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2747});
  // hls/stages/census.hpp:323
  logic and_2751;
  assign and_2751 = and_706_s3_q & (9'h4 < sum_2749[13:5]);
  // hls/stages/census.hpp:324
  logic and_2752;
  assign and_2752 = and_706_s3_q & less_730;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2753;
  assign sum_2753 = census_left_misses_q + {{17{and_2752}}, and_2751, 1'b0, and_2751};
  // hls/stages/agreement.hpp:527
  logic [19:0] select_2755;
  assign select_2755 = and_544_s3_q ? (equal_2746_s3_q ? 20'h0 : sum_2753) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2825;
  assign select_2825 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:527
  logic select_2828;
  assign select_2828 = and_544_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2831;
  assign and_2831 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:461
  logic and_2837;
  assign and_2837 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2838;
  assign and_2838 = and_2831 & and_2837;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2825[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2840;
  assign select_2840 = and_2838 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2842;
  assign select_2842 = equal_2746_s3_q ? {11'h0, select_2840} : (sharpness_sums_detail_0_q + {11'h0, select_2840});
  // hls/stages/agreement.hpp:461
  logic and_2849;
  assign and_2849 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2850;
  assign and_2850 = and_2831 & and_2849;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2825[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2852;
  assign select_2852 = and_2850 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2854;
  assign select_2854 = equal_2746_s3_q ? {11'h0, select_2852} : (sharpness_sums_detail_1_q + {11'h0, select_2852});
  logic [8:0] select_2857;
  assign select_2857 = and_2838 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2858;
  assign sum_2858 = (equal_2746_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2857};
  logic [8:0] select_2861;
  assign select_2861 = and_2850 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2862;
  assign sum_2862 = (equal_2746_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2861};
  // hls/stages/agreement.hpp:211
  logic equal_2864;
  assign equal_2864 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2865;
  assign less_2865 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2866;
  assign less_2866 = x_s3_q[4:0] < 5'h3;
  logic not_2867;
  assign not_2867 = ~x_s3_q[1];
  logic [2:0] select_2868;
  assign select_2868 = x_s3_q[0] ? {1'b0, not_2867, 1'b0} : {x_s3_q[1], 1'b0, not_2867};
  logic [5:0] select_2869;
  assign select_2869 = slot_s3_q[2] ? {select_2868[2], 1'b0, select_2868[1], 1'b0, select_2868[0], 1'b0} : {1'b0, select_2868[2], 1'b0, select_2868[1], 1'b0, select_2868[0]};
  logic [11:0] select_2870;
  assign select_2870 = slot_s3_q[1] ? {select_2869[5], 1'b0, select_2869[4], 1'b0, select_2869[3], 1'b0, select_2869[2], 1'b0, select_2869[1], 1'b0, select_2869[0], 1'b0} : {1'b0, select_2869[5], 1'b0, select_2869[4], 1'b0, select_2869[3], 1'b0, select_2869[2], 1'b0, select_2869[1], 1'b0, select_2869[0]};
  logic [23:0] select_2871;
  assign select_2871 = slot_s3_q[0] ? {select_2870[11], 1'b0, select_2870[10], 1'b0, select_2870[9], 1'b0, select_2870[8], 1'b0, select_2870[7], 1'b0, select_2870[6], 1'b0, select_2870[5], 1'b0, select_2870[4], 1'b0, select_2870[3], 1'b0, select_2870[2], 1'b0, select_2870[1], 1'b0, select_2870[0], 1'b0} : {1'b0, select_2870[11], 1'b0, select_2870[10], 1'b0, select_2870[9], 1'b0, select_2870[8], 1'b0, select_2870[7], 1'b0, select_2870[6], 1'b0, select_2870[5], 1'b0, select_2870[4], 1'b0, select_2870[3], 1'b0, select_2870[2], 1'b0, select_2870[1], 1'b0, select_2870[0]};
  // hls/stages/census.hpp:390
  logic and_2875;
  assign and_2875 = less_2866 & (~((sharpness_sums_contrast_1_q & select_2871) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2877;
  assign select_2877 = (less_2865 & and_2875) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2877};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2880;
  assign select_2880 = equal_2864 ? (less_2865 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2885;
  assign and_2885 = less_2866 & (~((sharpness_sums_contrast_0_q & select_2871) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2887;
  assign select_2887 = (less_2865 & and_2885) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2887};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2890;
  assign select_2890 = equal_2864 ? (less_2865 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2892;
  assign select_2892 = equal_2864 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2894;
  assign select_2894 = equal_2864 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2896;
  assign select_2896 = equal_2864 ? {sharpness_comparing_contrast_0_q[0], and_2885} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2898;
  assign select_2898 = equal_2864 ? {sharpness_comparing_contrast_1_q[0], and_2875} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2903;
  assign select_2903 = so_s3_q ? (equal_2864 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2907;
  assign select_2907 = so_s3_q ? (equal_2864 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2908;
  assign equal_2908 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2909;
  assign xor_2909 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2912;
  assign select_2912 = (equal_2908 | xor_2909) ? (five_times[0] & xor_2909) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2914;
  assign select_2914 = so_s3_q ? (equal_2864 ? select_2912 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2915;
  assign xor_2915 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2918;
  assign select_2918 = (equal_2908 | xor_2915) ? (five_times_2[0] & xor_2915) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2920;
  assign select_2920 = so_s3_q ? (equal_2864 ? select_2918 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2921;
  assign xor_2921 = sharpness_comparing_contrast_0_q[1] ^ and_2875;
  logic select_2924;
  assign select_2924 = (equal_2908 | xor_2921) ? (and_2875 & xor_2921) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2926;
  assign select_2926 = so_s3_q ? (equal_2864 ? select_2924 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2927;
  assign xor_2927 = sharpness_comparing_contrast_1_q[1] ^ and_2885;
  logic select_2930;
  assign select_2930 = (equal_2908 | xor_2927) ? (and_2885 & xor_2927) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2932;
  assign select_2932 = so_s3_q ? (equal_2864 ? select_2930 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:933
  logic [13:0] select_3058;
  assign select_3058 = and_3050_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3056_s3_q});
  // hls/stages/agreement.hpp:795
  logic and_3061;
  assign and_3061 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3066;
  assign and_3066 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3071;
  assign and_3071 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2481_s3_q));
  // hls/stages/agreement.hpp:1113
  logic not_3075;
  assign not_3075 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1102
  logic [2:0] select_3084;
  assign select_3084 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3085;
  assign difference_3085 = {1'b0, explained_2_s3_q} - {1'b0, select_3084};
  logic [4:0] e;
  assign e = {difference_3085[3], difference_3085} + (equal_564_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1110
  logic [5:0] sum_3088;
  assign sum_3088 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1114
  logic not_3092;
  assign not_3092 = ~(equal_2540 ? and_2562 : (~({sum_3088, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:795
  logic and_3095;
  assign and_3095 = ends_cell_s3_q & (not_3075 & (centres_values_1_textured_s3_q & not_3092));
  logic and_3097;
  assign and_3097 = not_570_s3_q & (so_s3_q & and_3095);
  // hls/stages/agreement.hpp:1140
  logic less_3100;
  assign less_3100 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3101;
  assign select_3101 = less_3100 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3104;
  assign select_3104 = less_3100 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1141
  logic [10:0] sum_3105;
  assign sum_3105 = {1'b0, select_3104} + {3'h0, select_3104[9:2]};
  logic and_3107;
  assign and_3107 = (~(select_3101[9:4] == 6'h0)) & ({sum_3105, select_3104[1:0]} < {3'h0, select_3101});
  // hls/stages/agreement.hpp:1150
  logic [9:0] select_3110;
  assign select_3110 = x_s3_q[6] ? (equal_2080_s3_q ? 10'h0 : (and_3107 ? select_3101 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:795
  logic [9:0] select_3111;
  assign select_3111 = equal_569_s3_q ? select_3110 : 10'h0;
  // hls/stages/agreement.hpp:933
  logic [13:0] select_3113;
  assign select_3113 = and_3050_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3111});
  logic [13:0] select_3120;
  assign select_3120 = and_3050_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3118_s3_q});
  // hls/stages/agreement.hpp:1118
  logic and_3122;
  assign and_3122 = not_3075 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:795
  logic and_3125;
  assign and_3125 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_3122));
  // hls/stages/agreement.hpp:933
  logic [13:0] select_3127;
  assign select_3127 = and_3050_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3125});
  // hls/stages/agreement.hpp:1118
  logic and_3129;
  assign and_3129 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3092);
  // hls/stages/agreement.hpp:795
  logic and_3133;
  assign and_3133 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & (not_3075 & and_3129)));
  // hls/stages/agreement.hpp:933
  logic [13:0] select_3135;
  assign select_3135 = and_3050_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3133});
  logic [13:0] select_3154;
  assign select_3154 = and_3050_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3152_s3_q});
  // hls/stages/agreement.hpp:795
  logic [7:0] select_3230;
  assign select_3230 = so_s3_q ? (equal_2173_s3_q ? (and_3212_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3231;
  assign select_3231 = equal_569_s3_q ? 8'h0 : select_3230;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3233;
  assign select_3233 = and_3211_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3231[7]}}, select_3231});
  // hls/stages/agreement.hpp:795
  logic and_3236;
  assign and_3236 = not_570_s3_q & (so_s3_q & (and_3212_s3_q & equal_2173_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3238;
  assign select_3238 = and_3211_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3236});
  // hls/stages/registration.hpp:107
  logic and_3240;
  assign and_3240 = and_3212_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:795
  logic [1:0] select_3242;
  assign select_3242 = so_s3_q ? (equal_2173_s3_q ? {and_3240, and_3212_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3243;
  assign select_3243 = equal_569_s3_q ? 2'h0 : select_3242;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3244;
  assign sum_3244 = registration_half_votes_down_q + {{5{select_3243[1]}}, select_3243};
  // hls/stages/agreement.hpp:795
  logic [1:0] select_3250;
  assign select_3250 = so_s3_q ? (equal_2173_s3_q ? {and_3248_s3_q, and_3212_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3251;
  assign select_3251 = equal_569_s3_q ? 2'h0 : select_3250;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3252;
  assign sum_3252 = registration_half_votes_up_q + {{5{select_3251[1]}}, select_3251};
  // hls/stages/registration.hpp:107
  logic and_3255;
  assign and_3255 = and_3212_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:795
  logic [1:0] select_3257;
  assign select_3257 = so_s3_q ? (equal_2173_s3_q ? {and_3255, and_3212_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3258;
  assign select_3258 = equal_569_s3_q ? 2'h0 : select_3257;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3259;
  assign sum_3259 = registration_half_half_votes_down_q + {{5{select_3258[1]}}, select_3258};
  // hls/stages/agreement.hpp:795
  logic [1:0] select_3264;
  assign select_3264 = so_s3_q ? (equal_2173_s3_q ? {and_3262_s3_q, and_3212_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3265;
  assign select_3265 = equal_569_s3_q ? 2'h0 : select_3264;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3266;
  assign sum_3266 = registration_half_half_votes_up_q + {{5{select_3265[1]}}, select_3265};
  // hls/stages/agreement.hpp:795
  logic and_3299;
  assign and_3299 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & less_2111_s3_q));
  // hls/stages/agreement.hpp:1138
  logic [11:0] select_3306;
  assign select_3306 = or_2115_s3_q ? 12'h0 : (equal_3304_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1150
  logic [11:0] select_3309;
  assign select_3309 = x_s3_q[6] ? (equal_2080_s3_q ? 12'h0 : (less_2111_s3_q ? select_3306 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:795
  logic [11:0] select_3310;
  assign select_3310 = equal_569_s3_q ? select_3309 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3311;
  assign and_3311 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1150
  logic and_3314;
  assign and_3314 = not_2454_s3_q & (less_2111_s3_q & ({and_3311, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:795
  logic and_3316;
  assign and_3316 = equal_569_s3_q & (x_s3_q[6] & and_3314);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3318;
  assign sum_3318 = {{2{select_3310[11]}}, select_3310} + (and_3316 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1138
  logic [11:0] select_3321;
  assign select_3321 = or_2115_s3_q ? 12'h0 : (equal_3304_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1150
  logic [11:0] select_3324;
  assign select_3324 = x_s3_q[6] ? (equal_2080_s3_q ? 12'h0 : (less_2111_s3_q ? select_3321 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:795
  logic [11:0] select_3325;
  assign select_3325 = equal_569_s3_q ? select_3324 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3327;
  assign sum_3327 = {{2{select_3325[11]}}, select_3325} + (and_3316 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3329;
  assign not_3329 = ~all_s3_q;
  // hls/stages/agreement.hpp:1150
  logic and_3332;
  assign and_3332 = not_2454_s3_q & (less_2111_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3329, 1'b0}));
  // hls/stages/agreement.hpp:795
  logic and_3338;
  assign and_3338 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3339;
  assign not_3339 = ~and_3338;
  logic less_3340;
  assign less_3340 = $signed({9'h1, {2{not_3339}}, and_3338}) < $signed(registration_up_q[13:2]);
  logic select_3341;
  assign select_3341 = (equal_569_s3_q & (x_s3_q[6] & and_3332)) ? less_3340 : registration_enough_q;
  // hls/stages/agreement.hpp:1150
  logic and_3345;
  assign and_3345 = x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:795
  logic and_3346;
  assign and_3346 = equal_569_s3_q & and_3345;
  // hls/stages/registration.hpp:242
  logic less_3347;
  assign less_3347 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3349;
  assign less_3349 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3351;
  assign equal_3351 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:795
  logic and_3355;
  assign and_3355 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & equal_3351)));
  // hls/stages/agreement.hpp:1150
  logic and_3362;
  assign and_3362 = x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3365;
  assign equal_3365 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1150
  logic and_3368;
  assign and_3368 = not_2454_s3_q & (less_2111_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3365));
  // hls/stages/registration.hpp:244
  logic and_3372;
  assign and_3372 = (equal_569_s3_q & (x_s3_q[6] & and_3368)) & (less_3349 | less_3347);
  // hls/stages/agreement.hpp:1150
  logic and_3377;
  assign and_3377 = not_2454_s3_q & (less_2111_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3365)));
  // hls/stages/registration.hpp:244
  logic and_3380;
  assign and_3380 = registration_votes_up_q & registration_other_down_q;
  logic select_3382;
  assign select_3382 = registration_votes_down_q ? (registration_other_up_q | and_3380) : and_3380;
  // hls/stages/registration.hpp:138
  logic and_3384;
  assign and_3384 = (equal_569_s3_q & (x_s3_q[6] & and_3377)) & (registration_other_enough_q & select_3382);
  // hls/stages/registration.hpp:245
  logic or_3387;
  assign or_3387 = registration_moved_q | (registration_enough_q & (and_3372 | and_3384));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3471;
  assign select_3471 = sample_pair_whole_s3_q ? (equal_2163_s3_q ? patches_place_0_slope_q : select_2269[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3476;
  assign select_3476 = sample_pair_whole_s3_q ? (equal_2163_s3_q ? patches_place_1_slope_q : select_2297[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3478;
  assign select_3478 = equal_2163_s3_q ? patches_valid_0_q : (select_2162_s3_q ? patches_valid_0_q : select_2265[0]);
  // hls/stages/agreement.hpp:276
  logic select_3481;
  assign select_3481 = sample_pair_whole_s3_q ? (and_2288 ? (sample_present_s3_q & select_3478) : select_3478) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3483;
  assign select_3483 = equal_2163_s3_q ? patches_valid_1_q : (select_2162_s3_q ? select_2265[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3486;
  assign select_3486 = sample_pair_whole_s3_q ? (and_2307 ? (sample_present_s3_q & select_3483) : select_3483) : patches_valid_1_q;
  logic [5:0] select_3489;
  assign select_3489 = sample_pair_whole_s3_q ? (select_2286[5] ? {1'b1, select_2286[4:0]} : (select_2286 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3492;
  assign select_3492 = sample_pair_whole_s3_q ? (select_2305[5] ? {1'b1, select_2305[4:0]} : (select_2305 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3495;
  assign select_3495 = sample_pair_whole_s3_q ? (select_2318[4] ? {1'b1, select_2318[3:0]} : (select_2318 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3498;
  assign select_3498 = sample_pair_whole_s3_q ? (select_2323[4] ? {1'b1, select_2323[3:0]} : (select_2323 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3917_s3_q, parity_3913_s3_q, xor_3901_s3_q, parity_3873_s3_q, parity_3811_s3_q, parity_3682_s3_q} + (equal_3918_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3922;
  assign select_3922 = equal_2249_s3_q ? patches_sums_values_0_q : (equal_2251_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3923;
  assign select_3923 = equal_2251_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3925;
  assign select_3925 = equal_2251_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3927;
  assign select_3927 = equal_2251_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3929;
  assign select_3929 = equal_2251_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3931;
  assign select_3931 = equal_2251_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3933;
  assign select_3933 = equal_2251_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3935;
  assign select_3935 = equal_2251_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3937;
  assign select_3937 = equal_2251_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3939;
  assign select_3939 = equal_2251_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3941;
  assign select_3941 = equal_2251_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3943;
  assign select_3943 = equal_2251_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3945;
  assign select_3945 = equal_2251_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3947;
  assign select_3947 = equal_2251_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3949;
  assign select_3949 = equal_2251_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3951;
  assign select_3951 = equal_2251_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3953;
  assign select_3953 = equal_2251_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_4024;
  assign difference_4024 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_4027;
  assign and_4027 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_4024, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_4030;
  assign not_4030 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_4033;
  assign and_4033 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_4027 & ((10'h38 < patches_peak_size_q) & not_4030));
  // hls/stages/patches.hpp:190
  logic and_4035;
  assign and_4035 = and_4018_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_4033);
  // hls/stages/patches.hpp:667
  logic not_4036;
  assign not_4036 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_4038;
  assign and_4038 = and_4035 & (not_2256_s3_q & not_4036);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4040;
  assign sum_4040 = {7'h0, and_4038} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4044;
  assign sum_4044 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4043_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_4051;
  assign not_4051 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4052;
  assign sum_4052 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4054;
  assign not_4054 = ~({eight, 3'h0} < {1'b0, sum_4052, fall_2[0]});
  logic [1:0] sum_4055;
  assign sum_4055 = {1'b0, not_4051} + {1'b0, not_4054};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4056;
  assign sum_4056 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4058;
  assign not_4058 = ~({eight, 3'h0} < {sum_4056, fall_2[1:0]});
  logic not_4061;
  assign not_4061 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4062;
  assign sum_4062 = {1'b0, not_4058} + {1'b0, not_4061};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4055} + {1'b0, sum_4062};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4065;
  assign select_4065 = less_4043_s3_q ? ({sum_4044, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_4044, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_4066;
  assign select_4066 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_4067;
  assign select_4067 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4068;
  assign sum_4068 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_4069;
  assign sum_4069 = {select_4067[5], select_4067} + {{3{sum_4068[3]}}, sum_4068};
  // hls/stages/patches.hpp:604
  logic [17:0] product_4070;
  assign product_4070 = $signed({{10{select_4066[7]}}, select_4066}) * $signed({{8{sum_4069[6]}}, sum_4069, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_4071;
  assign difference_4071 = {{6{select_4065[7]}}, select_4065} - {product_4070[17], product_4070[17:5]};
  // hls/stages/patches.hpp:611
  logic less_4072;
  assign less_4072 = $signed({{7{difference_4042[6]}}, difference_4042}) < $signed(difference_4071);
  // hls/stages/patches.hpp:189
  logic not_4073;
  assign not_4073 = ~less_4072;
  // hls/stages/patches.hpp:670
  logic and_4074;
  assign and_4074 = not_4073 & and_4038;
  logic [7:0] sum_4075;
  assign sum_4075 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4074};
  // hls/stages/patches.hpp:189
  logic not_4078;
  assign not_4078 = ~($signed(difference_4071) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_4079;
  assign and_4079 = not_4078 & and_4038;
  logic [7:0] sum_4080;
  assign sum_4080 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4079};
  // hls/stages/patches.hpp:192
  logic and_4082;
  assign and_4082 = and_4035 & (patches_second_s3_q & not_4036);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4084;
  assign sum_4084 = {7'h0, and_4082} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_4086;
  assign and_4086 = not_4073 & and_4082;
  logic [7:0] sum_4087;
  assign sum_4087 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4086};
  // hls/stages/patches.hpp:671
  logic and_4089;
  assign and_4089 = not_4078 & and_4082;
  logic [7:0] sum_4090;
  assign sum_4090 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4089};
  // hls/stages/patches.hpp:192
  logic and_4092;
  assign and_4092 = and_4035 & (patches_lower_s3_q & not_2256_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4094;
  assign sum_4094 = {7'h0, and_4092} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_4096;
  assign and_4096 = not_4073 & and_4092;
  logic [7:0] sum_4097;
  assign sum_4097 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4096};
  // hls/stages/patches.hpp:671
  logic and_4099;
  assign and_4099 = not_4078 & and_4092;
  logic [7:0] sum_4100;
  assign sum_4100 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4099};
  // hls/stages/patches.hpp:192
  logic and_4102;
  assign and_4102 = and_4035 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4104;
  assign sum_4104 = {7'h0, and_4102} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_4106;
  assign and_4106 = not_4073 & and_4102;
  logic [7:0] sum_4107;
  assign sum_4107 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4106};
  // hls/stages/patches.hpp:671
  logic and_4109;
  assign and_4109 = not_4078 & and_4102;
  logic [7:0] sum_4110;
  assign sum_4110 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4109};
  // hls/stages/agreement.hpp:1231
  logic equal_4111;
  assign equal_4111 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1138
  logic less_4112;
  assign less_4112 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:795
  logic and_4116;
  assign and_4116 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (equal_4111 & less_4112)));
  // hls/stages/agreement.hpp:1150
  logic and_4121;
  assign and_4121 = x_s3_q[6] & (not_2454_s3_q & (less_4112 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:795
  logic and_4122;
  assign and_4122 = equal_569_s3_q & and_4121;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4124;
  assign or_4124 = (and_4116 ? patches_quarters_0_places_q : 8'h0) | (and_4122 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1150
  logic and_4128;
  assign and_4128 = x_s3_q[6] & (not_2454_s3_q & (less_4112 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:795
  logic and_4129;
  assign and_4129 = equal_569_s3_q & and_4128;
  // hls/stages/agreement.hpp:1150
  logic and_4135;
  assign and_4135 = x_s3_q[6] & (not_2454_s3_q & (less_4112 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:795
  logic and_4136;
  assign and_4136 = equal_569_s3_q & and_4135;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4138;
  assign or_4138 = (or_4124 | (and_4129 ? patches_quarters_2_places_q : 8'h0)) | (and_4136 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_4142;
  assign select_4142 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:795
  logic and_4146;
  assign and_4146 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_4112 & select_4142)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_4148;
  assign select_4148 = and_4116 ? (and_4146 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4150;
  assign select_4150 = and_4122 ? (and_4146 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4153;
  assign select_4153 = and_4129 ? (and_4146 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4156;
  assign select_4156 = and_4136 ? (and_4146 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_4159;
  assign select_4159 = and_4116 ? (and_4146 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4161;
  assign select_4161 = and_4122 ? (and_4146 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4164;
  assign select_4164 = and_4129 ? (and_4146 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4167;
  assign select_4167 = and_4136 ? (and_4146 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_4169;
  assign sum_4169 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1150
  logic and_4173;
  assign and_4173 = x_s3_q[6] & (not_2454_s3_q & (less_4112 & (sum_4169[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:795
  logic and_4174;
  assign and_4174 = equal_569_s3_q & and_4173;
  // hls/stages/patches.hpp:630
  logic [7:0] select_4177;
  assign select_4177 = and_4174 ? (patches_word_places_q + (and_4122 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4180;
  assign select_4180 = and_4174 ? (patches_word_up_q + (and_4122 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4183;
  assign select_4183 = and_4174 ? (patches_word_down_q + (and_4122 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_4186;
  assign select_4186 = ($signed(difference_4071[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4071[5:0];
  logic [5:0] select_4187;
  assign select_4187 = ($signed(14'h10) < $signed(difference_4071)) ? 6'h10 : select_4186;
  // hls/stages/patches.hpp:673
  logic [5:0] select_4188;
  assign select_4188 = and_4035 ? select_4187 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_4190;
  assign select_4190 = patches_round_ends_q ? {{6{select_4188[5]}}, select_4188} : (patches_across_q + {{6{select_4188[5]}}, select_4188});
  // hls/stages/agreement.hpp:795
  logic and_4194;
  assign and_4194 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (equal_3351 & less_4112)));
  // hls/stages/agreement.hpp:1150
  logic and_4198;
  assign and_4198 = x_s3_q[6] & (not_2454_s3_q & (less_4112 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:795
  logic and_4199;
  assign and_4199 = equal_569_s3_q & and_4198;
  // hls/stages/patches.hpp:657
  logic [7:0] select_4201;
  assign select_4201 = and_4194 ? (and_4199 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_4205;
  assign or_4205 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_4208;
  assign or_4208 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_4209;
  assign sum_4209 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_4211;
  assign select_4211 = and_4194 ? (and_4199 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_4214;
  assign and_4214 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_4216;
  assign select_4216 = and_4199 ? {and_4214, patches_found_q[2:1]} : (and_4194 ? {and_4214, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_4220;
  assign or_4220 = patches_partly_q | (patches_doubted_q & (~and_4199));
  // hls/stages/patches.hpp:656
  logic select_4223;
  assign select_4223 = and_4194 ? (and_4199 ? or_4220 : (and_4194 ? or_4220 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_4224;
  assign select_4224 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4228;
  assign select_4228 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_4230;
  assign sum_4230 = {sum_4069[6], sum_4069, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_4232;
  assign and_4232 = ({{5{sum_4230[10]}}, sum_4230} < 16'h3) & and_4035;
  logic [7:0] sum_4233;
  assign sum_4233 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4232};
  // hls/stages/patches.hpp:663
  logic [12:0] product_4238;
  assign product_4238 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_4201};
  // hls/stages/patches.hpp:192
  logic and_4240;
  assign and_4240 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4238[12:5] < patches_on_skin_q);
  logic select_4245;
  assign select_4245 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_4249;
  assign or_4249 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_4256;
  assign select_4256 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_4262;
  assign and_4262 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4263;
  assign sum_4263 = patches_age_q + {9'h0, and_4262};
  logic [9:0] select_4266;
  assign select_4266 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4263)) : sum_4263;
  // hls/stages/agreement.hpp:1196
  logic or_4323;
  assign or_4323 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1225
  logic equal_4325;
  assign equal_4325 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1234
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1235
  logic select_4331;
  assign select_4331 = (equal_4325 & equal_4111) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1143
  logic [10:0] sum_4334;
  assign sum_4334 = {1'b0, select_3104} + {2'h0, select_3104[9:1]};
  logic select_4337;
  assign select_4337 = (select_3101[9:3] == 7'h0) ? ((~or_4323) & (~select_4331)) : (~({sum_4334, select_3104[0]} < {2'h0, select_3101}));
  // hls/stages/agreement.hpp:1150
  logic [47:0] select_4339;
  assign select_4339 = x_s3_q[6] ? (equal_2080_s3_q ? good_q : {select_4337, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:795
  logic select_4344;
  assign select_4344 = equal_569_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4342_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1225
  logic equal_4345;
  assign equal_4345 = x_s3_q[6:3] == 4'ha;
  logic equal_4347;
  assign equal_4347 = x_s3_q[6:3] == 4'hc;
  logic equal_4348;
  assign equal_4348 = x_s3_q[6:3] == 4'hb;
  logic equal_4349;
  assign equal_4349 = x_s3_q[6:3] == 4'h9;
  logic equal_4350;
  assign equal_4350 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1133
  logic [13:0] select_4352;
  assign select_4352 = equal_4349 ? counts_skin_unproven_q : (equal_4350 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4354;
  assign select_4354 = equal_4348 ? counts_regions_bad_q : (equal_4345 ? counts_nearer_q : select_4352);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4347 ? counts_on_skin_q : select_4354;
  // hls/stages/agreement.hpp:1230
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1238
  logic select_4357;
  assign select_4357 = (equal_4345 & equal_4111) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1156
  logic not_4358;
  assign not_4358 = ~hidden_for_q[7];
  logic [7:0] select_4360;
  assign select_4360 = select_4357 ? (hidden_for_q + {7'h0, not_4358}) : 8'h0;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_4362;
  assign select_4362 = equal_569_s3_q ? (equal_4342_s3_q ? select_4360 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1239
  logic [13:0] select_4363;
  assign select_4363 = equal_4111 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1133
  logic [7:0] select_4365;
  assign select_4365 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4367;
  assign select_4367 = equal_4350 ? cfg_unproven_skin_limit_i : (equal_4325 ? cfg_unproven_limit_i : select_4365);
  logic [7:0] select_4369;
  assign select_4369 = equal_4345 ? cfg_regions_limit_i : (equal_4349 ? cfg_hidden_limit_i : select_4367);
  logic [7:0] limit;
  assign limit = equal_4347 ? cfg_regions_limit_i : (equal_4348 ? {cfg_on_skin_limit_i, 3'h0} : select_4369);
  // hls/stages/agreement.hpp:1239
  logic not_4372;
  assign not_4372 = ~x_s3_q[2];
  logic [3:0] select_4373;
  assign select_4373 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4372, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4372};
  logic [7:0] select_4374;
  assign select_4374 = x_s3_q[0] ? {select_4373[3], 1'b0, select_4373[2], 1'b0, select_4373[1], 1'b0, select_4373[0], 1'b0} : {1'b0, select_4373[3], 1'b0, select_4373[2], 1'b0, select_4373[1], 1'b0, select_4373[0]};
  // hls/stages/agreement.hpp:1133
  logic [13:0] select_4378;
  assign select_4378 = equal_4349 ? counts_skin_supervised_q : (equal_4350 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4380;
  assign select_4380 = equal_4348 ? counts_skin_textured_q : (equal_4345 ? counts_textured_q : select_4378);
  logic [13:0] of;
  assign of = equal_4347 ? counts_textured_q : select_4380;
  // hls/stages/agreement.hpp:1239
  logic [13:0] select_4382;
  assign select_4382 = ((limit & select_4374) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4363} + {1'b0, select_4382};
  // hls/stages/agreement.hpp:795
  logic select_4387;
  assign select_4387 = equal_569_s3_q ? (equal_4111 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1236
  logic and_4392;
  assign and_4392 = too_much_q & (~(equal_4350 & equal_4111));
  // hls/stages/agreement.hpp:1237
  logic select_4397;
  assign select_4397 = (over[14] & equal_4111) ? (and_4392 | ((equal_4350 | equal_4349) | (x_s3_q[6:3] == 4'hf))) : and_4392;
  // hls/stages/agreement.hpp:1133
  logic and_4402;
  assign and_4402 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1239
  logic select_4403;
  assign select_4403 = (equal_4347 & equal_4111) ? and_4402 : overlooks_q;
  // hls/stages/agreement.hpp:795
  logic [2:0] select_4405;
  assign select_4405 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4407;
  assign select_4407 = equal_569_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_4405 : box_textured_columns_values_0_q);
  logic [2:0] select_4408;
  assign select_4408 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4410;
  assign select_4410 = equal_569_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4408 : box_textured_columns_values_1_q);
  logic [2:0] select_4411;
  assign select_4411 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4413;
  assign select_4413 = equal_569_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4411 : box_textured_columns_values_2_q);
  logic [2:0] select_4414;
  assign select_4414 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4416;
  assign select_4416 = equal_569_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4414 : box_textured_columns_values_3_q);
  logic [2:0] select_4417;
  assign select_4417 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4419;
  assign select_4419 = equal_569_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4417 : box_textured_columns_values_4_q);
  logic [4:0] select_4421;
  assign select_4421 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4423;
  assign select_4423 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4425;
  assign select_4425 = equal_569_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4423 : box_explained_columns_values_0_q);
  logic [2:0] select_4426;
  assign select_4426 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4428;
  assign select_4428 = equal_569_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4426 : box_explained_columns_values_1_q);
  logic [2:0] select_4429;
  assign select_4429 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4431;
  assign select_4431 = equal_569_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4429 : box_explained_columns_values_2_q);
  logic [2:0] select_4432;
  assign select_4432 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4434;
  assign select_4434 = equal_569_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4432 : box_explained_columns_values_3_q);
  logic [2:0] select_4435;
  assign select_4435 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4437;
  assign select_4437 = equal_569_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4435 : box_explained_columns_values_4_q);
  logic [4:0] select_4439;
  assign select_4439 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4442;
  assign select_4442 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4444;
  assign select_4444 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4446;
  assign select_4446 = equal_569_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4444 : box_shown_columns_values_1_q);
  logic [2:0] select_4447;
  assign select_4447 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4449;
  assign select_4449 = equal_569_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4447 : box_shown_columns_values_2_q);
  logic [2:0] select_4450;
  assign select_4450 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4452;
  assign select_4452 = equal_569_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4450 : box_shown_columns_values_3_q);
  logic [2:0] select_4453;
  assign select_4453 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4455;
  assign select_4455 = equal_569_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4453 : box_shown_columns_values_4_q);
  logic [4:0] select_4457;
  assign select_4457 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4460;
  assign select_4460 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4462;
  assign select_4462 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4464;
  assign select_4464 = equal_569_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4462 : box_nearer_columns_values_1_q);
  logic [2:0] select_4465;
  assign select_4465 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4467;
  assign select_4467 = equal_569_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4465 : box_nearer_columns_values_2_q);
  logic [2:0] select_4468;
  assign select_4468 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4470;
  assign select_4470 = equal_569_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4468 : box_nearer_columns_values_3_q);
  logic [2:0] select_4471;
  assign select_4471 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4473;
  assign select_4473 = equal_569_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4471 : box_nearer_columns_values_4_q);
  logic [4:0] select_4475;
  assign select_4475 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1317
  logic [1:0] select_4522;
  assign select_4522 = and_4521_s3_q ? {and_2592, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:442
  logic select_4526;
  assign select_4526 = and_2520_s3_q ? (less_2521_s3_q ? (select_4522[0] & and_4523_s3_q) : seen_q) : seen_q;
  logic select_4529;
  assign select_4529 = and_2520_s3_q ? (less_2521_s3_q ? (select_4522[1] & and_4523_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1247
  logic or_4536;
  assign or_4536 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4535_s3_q;
  // hls/stages/agreement.hpp:1249
  logic not_4544;
  assign not_4544 = ~(or_4323 | not_2816);
  // hls/stages/agreement.hpp:795
  logic and_4548;
  assign and_4548 = equal_569_s3_q & (equal_4342_s3_q & (not_4544 & (select_4331 | select_4397)));
  logic and_4551;
  assign and_4551 = equal_4342_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1158
  logic or_4555;
  assign or_4555 = select_2914 | (select_2926 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:795
  logic and_4562;
  assign and_4562 = equal_569_s3_q & (equal_4342_s3_q & (not_4544 & (select_2920 | select_2932)));
  // hls/stages/agreement.hpp:1158
  logic and_4567;
  assign and_4567 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4360 < cfg_hidden_frames_i));
  logic select_4573;
  assign select_4573 = (not_2816 | (select_4403 & not_4235)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:795
  logic and_4578;
  assign and_4578 = equal_569_s3_q & (equal_4342_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4582;
  assign and_4582 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1148
  logic [31:0] select_4590;
  assign select_4590 = equal_2102_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4588_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4591;
  assign select_4591 = equal_2100_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4590;
  logic [31:0] select_4592;
  assign select_4592 = equal_2098_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4591;
  logic [31:0] select_4593;
  assign select_4593 = equal_2096_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4592;
  logic [31:0] select_4594;
  assign select_4594 = equal_2094_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4593;
  logic [31:0] select_4595;
  assign select_4595 = equal_2092_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4594;
  logic [31:0] select_4596;
  assign select_4596 = equal_2090_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4595;
  logic [31:0] select_4597;
  assign select_4597 = equal_2088_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4596;
  // hls/stages/agreement.hpp:1146
  logic [9:0] select_4598;
  assign select_4598 = less_3100 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1150
  logic [31:0] select_4599;
  assign select_4599 = equal_2080_s3_q ? select_4597 : {2'h0, select_4598, select_3104, select_3101};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_544_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_744_s3_q, and_743, less_738_s3_q, and_737_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_731, and_707_s3_q, and_706_s3_q, and_681_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q};
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
  assign registration_sums_waddr = {sum_2086_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2145_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2144, sum_2140};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2171_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2248_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2220_s3_q};
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
  assign patches_right_0_waddr = {select_2279_s3_q, select_2276};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2288);
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
  assign patches_right_1_waddr = {select_2279_s3_q, select_2304};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2307);
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
  assign patches_left_waddr = {select_2326, select_2325_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2332);
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
  assign patches_rows_wdata = select_2442;
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
  assign regions_waddr = {region_row_s3_q, or_2452_s3_q, or_2449_s3_q, or_2446_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2486_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2485, sum_2475, sum_2470};
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
  assign map_waddr = {sum_2527_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2603_s3_q;
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
      census_left_misses_q <= select_2755;
      sharpness_before_last_mask_q <= select_2828;
      sharpness_sums_detail_0_q <= and_544_s3_q ? select_2842 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_544_s3_q ? select_2854 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_544_s3_q ? sum_2858 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_544_s3_q ? sum_2862 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2880 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2890 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2892 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2894 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2896 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2898 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2903;
      sharpness_comparing_carry_1_q <= select_2907;
      sharpness_comparing_less_detail_0_q <= select_2914;
      sharpness_comparing_less_detail_1_q <= select_2920;
      sharpness_comparing_less_contrast_0_q <= select_2926;
      sharpness_comparing_less_contrast_1_q <= select_2932;
      counts_supervised_q <= select_3058;
      counts_textured_q <= and_3050_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3061});
      counts_explained_q <= and_3050_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3066});
      counts_nearer_q <= and_3050_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3071});
      counts_unproven_q <= and_3050_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3097});
      counts_regions_bad_q <= select_3113;
      counts_skin_supervised_q <= select_3120;
      counts_skin_textured_q <= select_3127;
      counts_skin_unproven_q <= select_3135;
      counts_on_skin_q <= select_3154;
      registration_half_across_q <= select_3233;
      registration_half_measured_q <= select_3238;
      registration_half_votes_down_q <= and_3211_s3_q ? 7'h0 : sum_3244;
      registration_half_votes_up_q <= and_3211_s3_q ? 7'h0 : sum_3252;
      registration_half_half_votes_down_q <= and_3211_s3_q ? 7'h0 : sum_3259;
      registration_half_half_votes_up_q <= and_3211_s3_q ? 7'h0 : sum_3266;
      registration_down_q <= and_3299 ? sum_3318 : registration_down_q;
      registration_up_q <= and_3299 ? sum_3327 : registration_up_q;
      registration_enough_q <= select_3341;
      registration_votes_down_q <= and_3346 ? less_3347 : registration_votes_down_q;
      registration_votes_up_q <= and_3346 ? less_3349 : registration_votes_up_q;
      registration_other_enough_q <= and_3355 ? select_3341 : registration_other_enough_q;
      registration_other_down_q <= and_3355 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3355 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_569_s3_q & and_3362)) & or_3387;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2267 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2270 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2271 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3471;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2296 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2298 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2299 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3476;
      patches_valid_0_q <= select_3481;
      patches_valid_1_q <= select_3486;
      patches_right_next_0_q <= select_3489;
      patches_right_next_1_q <= select_3492;
      patches_left_next_0_q <= select_3495;
      patches_left_next_1_q <= select_3498;
      patches_sums_values_0_q <= select_3922;
      patches_sums_values_1_q <= equal_2249_s3_q ? patches_sums_values_1_q : select_3923;
      patches_sums_values_2_q <= equal_2249_s3_q ? patches_sums_values_2_q : select_3925;
      patches_sums_values_3_q <= equal_2249_s3_q ? patches_sums_values_3_q : select_3927;
      patches_sums_values_4_q <= equal_2249_s3_q ? patches_sums_values_4_q : select_3929;
      patches_sums_values_5_q <= equal_2249_s3_q ? patches_sums_values_5_q : select_3931;
      patches_sums_values_6_q <= equal_2249_s3_q ? patches_sums_values_6_q : select_3933;
      patches_sums_values_7_q <= equal_2249_s3_q ? patches_sums_values_7_q : select_3935;
      patches_sums_values_8_q <= equal_2249_s3_q ? patches_sums_values_8_q : select_3937;
      patches_sums_values_9_q <= equal_2249_s3_q ? patches_sums_values_9_q : select_3939;
      patches_sums_values_10_q <= equal_2249_s3_q ? patches_sums_values_10_q : select_3941;
      patches_sums_values_11_q <= equal_2249_s3_q ? patches_sums_values_11_q : select_3943;
      patches_sums_values_12_q <= equal_2249_s3_q ? patches_sums_values_12_q : select_3945;
      patches_sums_values_13_q <= equal_2249_s3_q ? patches_sums_values_13_q : select_3947;
      patches_sums_values_14_q <= equal_2249_s3_q ? patches_sums_values_14_q : select_3949;
      patches_sums_values_15_q <= equal_2249_s3_q ? patches_sums_values_15_q : select_3951;
      patches_sums_values_16_q <= equal_2249_s3_q ? patches_sums_values_16_q : select_3953;
      patches_best_differing_q <= select_2442[9:0];
      patches_best_column_q <= select_2442[14:10];
      patches_quarters_0_places_q <= sum_4040;
      patches_quarters_0_up_q <= sum_4075;
      patches_quarters_0_down_q <= sum_4080;
      patches_quarters_1_places_q <= sum_4084;
      patches_quarters_1_up_q <= sum_4087;
      patches_quarters_1_down_q <= sum_4090;
      patches_quarters_2_places_q <= sum_4094;
      patches_quarters_2_up_q <= sum_4097;
      patches_quarters_2_down_q <= sum_4100;
      patches_quarters_3_places_q <= sum_4104;
      patches_quarters_3_up_q <= sum_4107;
      patches_quarters_3_down_q <= sum_4110;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_4138;
      patches_word_up_q <= ((select_4148 | select_4150) | select_4153) | select_4156;
      patches_word_down_q <= ((select_4159 | select_4161) | select_4164) | select_4167;
      patches_sum_places_q <= select_4177;
      patches_sum_up_q <= select_4180;
      patches_sum_down_q <= select_4183;
      patches_across_q <= select_4190;
      patches_places_q <= select_4201;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4205;
      patches_partly_q <= or_4208;
      patches_clear_limit_q <= sum_4209[8:2];
      patches_complete_q <= select_4211;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4194 ? select_4216 : patches_found_q;
      patches_doubted_q <= select_4223;
      patches_doubted_before_q <= select_4224;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4228;
      patches_on_skin_q <= sum_4233;
      patches_large_q <= not_4235 & and_4240;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4245;
      patches_spoiled_q <= or_4249;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4256;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4266;
      segment_textured_q <= select_2467 + {6'h0, and_3061};
      segment_explained_q <= select_2472 + {6'h0, and_3066};
      segment_nearer_q <= select_2482 + {6'h0, and_3071};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_569_s3_q ? select_4339 : good_q;
      good_known_q <= select_4344;
      hidden_for_q <= select_4362;
      product_q <= equal_569_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4387;
      disagree_q <= equal_569_s3_q ? select_4331 : disagree_q;
      too_much_q <= equal_569_s3_q ? select_4397 : too_much_q;
      hides_q <= equal_569_s3_q ? select_4357 : hides_q;
      overlooks_q <= equal_569_s3_q ? select_4403 : overlooks_q;
      seen_q <= select_4526;
      nearer_q <= select_4529;
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
      averager_quarter_1_0_q <= select_2629;
      averager_quarter_1_1_q <= select_2631;
      averager_quarter_2_0_q <= select_2633;
      averager_quarter_2_1_q <= select_2635;
      averager_detail_0_q <= select_2647;
      averager_detail_1_q <= select_2655;
      census_changes_values_0_left_q <= and_544_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_544_s3_q ? sum_2739 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2741;
      census_changes_values_1_right_q <= select_2742;
      census_changes_values_2_left_q <= select_2743;
      census_changes_values_2_right_q <= select_2744;
      sharpness_last_mask_q <= and_544_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_544_s3_q ? select_2825[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_544_s3_q ? select_2825[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4407;
      box_textured_columns_values_1_q <= select_4410;
      box_textured_columns_values_2_q <= select_4413;
      box_textured_columns_values_3_q <= select_4416;
      box_textured_columns_values_4_q <= select_4419;
      box_textured_sum_sums_values_0_q <= equal_569_s3_q ? box_textured_sum_sums_values_0_q : select_4421;
      box_explained_columns_values_0_q <= select_4425;
      box_explained_columns_values_1_q <= select_4428;
      box_explained_columns_values_2_q <= select_4431;
      box_explained_columns_values_3_q <= select_4434;
      box_explained_columns_values_4_q <= select_4437;
      box_explained_sum_sums_values_0_q <= equal_569_s3_q ? box_explained_sum_sums_values_0_q : select_4439;
      box_shown_columns_values_0_q <= equal_569_s3_q ? box_shown_columns_values_0_q : select_4442;
      box_shown_columns_values_1_q <= select_4446;
      box_shown_columns_values_2_q <= select_4449;
      box_shown_columns_values_3_q <= select_4452;
      box_shown_columns_values_4_q <= select_4455;
      box_shown_sum_sums_values_0_q <= equal_569_s3_q ? box_shown_sum_sums_values_0_q : select_4457;
      box_nearer_columns_values_0_q <= equal_569_s3_q ? box_nearer_columns_values_0_q : select_4460;
      box_nearer_columns_values_1_q <= select_4464;
      box_nearer_columns_values_2_q <= select_4467;
      box_nearer_columns_values_3_q <= select_4470;
      box_nearer_columns_values_4_q <= select_4473;
      box_nearer_sum_sums_values_0_q <= equal_569_s3_q ? box_nearer_sum_sums_values_0_q : select_4475;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4506_s4_q;
  logic or_4530_s4_q;
  logic and_4531_s4_q;
  logic and_4539_s4_q;
  logic and_4542_s4_q;
  logic and_4548_s4_q;
  logic and_4552_s4_q;
  logic and_4558_s4_q;
  logic and_4562_s4_q;
  logic and_4570_s4_q;
  logic and_4575_s4_q;
  logic and_4578_s4_q;
  logic and_4582_s4_q;
  logic [5:0] select_4584_s4_q;
  logic [31:0] select_4601_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4506_s4_q <= and_4506_s3_q;
      or_4530_s4_q <= not_2816 | select_4526;
      and_4531_s4_q <= cfg_prove_i & select_4529;
      and_4539_s4_q <= equal_569_s3_q & (equal_4342_s3_q & (cfg_prove_i & or_4536));
      and_4542_s4_q <= equal_569_s3_q & (equal_4342_s3_q & (cfg_prove_i & or_4323));
      and_4548_s4_q <= and_4548;
      and_4552_s4_q <= equal_569_s3_q & and_4551;
      and_4558_s4_q <= equal_569_s3_q & (equal_4342_s3_q & (not_4544 & or_4555));
      and_4562_s4_q <= and_4562;
      and_4570_s4_q <= equal_569_s3_q & (equal_4342_s3_q & (cfg_prove_i & and_4567));
      and_4575_s4_q <= equal_569_s3_q & (equal_4342_s3_q & select_4573);
      and_4578_s4_q <= and_4578;
      and_4582_s4_q <= and_4582;
      select_4584_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4601_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? select_4599 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4530_s4_q;
  assign marks_nearer_o = and_4531_s4_q;
  assign verdict_valid_o = and_4506_s4_q;
  assign verdict_unproven_yet_o = and_4539_s4_q;
  assign verdict_untextured_o = and_4542_s4_q;
  assign verdict_disagree_o = and_4548_s4_q;
  assign verdict_moved_o = and_4552_s4_q;
  assign verdict_unsharp_left_o = and_4558_s4_q;
  assign verdict_unsharp_right_o = and_4562_s4_q;
  assign verdict_hidden_o = and_4570_s4_q;
  assign verdict_overlooked_o = and_4575_s4_q;
  assign verdict_out_of_step_o = and_4578_s4_q;
  assign frame_valid_o = and_4582_s4_q;
  assign frame_index_o = select_4584_s4_q;
  assign frame_word_o = select_4601_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4238[4:0], sum_4209[1:0], sum_4169[1:0], product_4070[4:0], sum_3201[0], difference_3141[1:0], detail_4[1:0], detail_3[1:0], sum_2749[4:0], sum_2187[0], sum_2183[0], sum_729[4:0], cfg_width_i[2:0]};

endmodule
