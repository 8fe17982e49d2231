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
  logic not_2820;
  assign not_2820 = ~cfg_prove_i;
  logic [5:0] sum_3030;
  assign sum_3030 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_3035;
  assign less_3035 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_4052;
  assign difference_4052 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4245;
  assign not_4245 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4282;
  assign difference_4282 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4523;
  assign sum_4523 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4524;
  assign select_4524 = (6'h4 < cfg_height_i[8:3]) ? {sum_4523, cfg_height_i[4:3]} : 8'h0;

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
  // hls/stages/agreement.hpp:423
  logic and_517;
  assign and_517 = select_514 & (select_505[0] & or_515);
  // hls/stages/census.hpp:42
  logic [2:0] select_522;
  assign select_522 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [6:0] select_538;
  assign select_538 = sample_pair_first_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
  logic and_544;
  assign and_544 = sample_pair_whole_q & (equal_540 & and_542);
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:633
  logic equal_573;
  assign equal_573 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:604
  logic or_574;
  assign or_574 = so | equal_573;
  // hls/stages/agreement.hpp:602
  logic [7:0] sum_575;
  assign sum_575 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:604
  logic [7:0] select_576;
  assign select_576 = run_shift_q[5] ? x_q : sum_575;
  logic less_577;
  assign less_577 = {1'b0, last_q} < select_576;
  // hls/stages/agreement.hpp:227
  logic not_578;
  assign not_578 = ~less_577;
  // hls/stages/agreement.hpp:624
  logic equal_588;
  assign equal_588 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:625
  logic equal_589;
  assign equal_589 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:150
  logic and_590;
  assign and_590 = equal_589 & not_578;
  logic select_592;
  assign select_592 = or_574 ? not_578 : (equal_588 ? not_578 : and_590);
  // hls/stages/agreement.hpp:808
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:150
  logic and_611;
  assign and_611 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_576)));
  logic and_612;
  assign and_612 = equal_588 & and_611;
  logic select_613;
  assign select_613 = or_574 ? not_578 : and_612;
  // hls/stages/agreement.hpp:831
  logic [6:0] right;
  assign right = sum_575[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:604
  logic not_645;
  assign not_645 = ~or_574;
  // hls/stages/agreement.hpp:150
  logic and_648;
  assign and_648 = not_645 & ((~equal_588) & and_590);
  // hls/stages/census.hpp:42
  logic [5:0] select_675;
  assign select_675 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:276
  logic and_2293;
  assign and_2293 = not_2250 & (not_2252 & (or_2255 & (patches_second_q & equal_2254)));
  // hls/stages/patches.hpp:168
  logic not_2309;
  assign not_2309 = ~equal_2254;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2325;
  assign select_2325 = row_starts ? {select_2278[4], select_2278[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_2335;
  assign and_2335 = not_2250 & (or_2255 & not_2252);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2610;
  assign select_2610 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_505 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2613;
  assign select_2613 = sample_pair_whole_q ? (sample_last_q ? (select_522 + 3'h1) : select_522) : raster_at_y_q;
  logic [6:0] select_2616;
  assign select_2616 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_538 + {6'h0, equal_540})) : raster_at_column_q;
  logic [5:0] select_2619;
  assign select_2619 = sample_pair_whole_q ? (sample_last_q ? (select_675 + {5'h0, equal_541}) : select_675) : raster_at_row_q;
  logic select_2623;
  assign select_2623 = sample_pair_whole_q ? (sample_last_q ? (or_515 & (~raster_final_row_q)) : or_515) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2625;
  assign select_2625 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2629;
  assign select_2629 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [7:0] sum_2938;
  assign sum_2938 = {1'b0, last} + 8'h1;
  logic equal_2939;
  assign equal_2939 = {sum_2938[7], cfg_width_i[9:3]} == {1'b0, sum_2938[6:0]};
  // hls/stages/agreement.hpp:469
  logic and_2940;
  assign and_2940 = and_544 & equal_2939;
  // hls/stages/agreement.hpp:533
  logic select_2943;
  assign select_2943 = (and_2940 | (~ends_cell_q)) ? and_2940 : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2943 ? (and_2940 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2947;
  assign select_2947 = select_2943 ? (and_2940 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2950;
  assign select_2950 = select_2943 ? (following_last_shift_q & (~and_2940)) : run_last_shift_q;
  // hls/stages/agreement.hpp:617
  logic and_2953;
  assign and_2953 = run_last_shift_q & equal_588;
  // hls/stages/agreement.hpp:626
  logic select_2955;
  assign select_2955 = equal_588 ? (~run_last_shift_q) : equal_589;
  // hls/stages/agreement.hpp:630
  logic equal_2956;
  assign equal_2956 = run_phase_q == 3'h1;
  logic not_2959;
  assign not_2959 = ~select_2955;
  // hls/stages/agreement.hpp:633
  logic equal_2961;
  assign equal_2961 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2962;
  assign and_2962 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2963;
  assign select_2963 = equal_2961 ? 2'h1 : {2{and_2962}};
  logic [2:0] select_2965;
  assign select_2965 = (and_2953 | (select_2955 | equal_2956)) ? (equal_2956 ? 3'h2 : {not_2959, {2{select_2955}}}) : (equal_573 ? 3'h6 : {select_2963[0], select_2963});
  // hls/stages/agreement.hpp:617
  logic and_2968;
  assign and_2968 = select_2955 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2971;
  assign select_2971 = (plan_shift_q[5] & select_2955) ? value : 7'h0;
  logic [1:0] or_2972;
  assign or_2972 = {2{so}} | select_2971[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] or_2976;
  assign or_2976 = (select_2955 ? plan_columns_q : 8'h0) | ((equal_2956 | equal_2961) ? whole_q : 8'h0);
  logic [1:0] or_2977;
  assign or_2977 = {2{and_2953}} | or_2976[3:2];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2979;
  assign or_2979 = {or_2976[7:4], or_2977, or_2976[1:0]} | (equal_573 ? drawn_q : 8'h0);
  logic [4:0] or_2980;
  assign or_2980 = {5{so}} | {or_2979[6], or_2979[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2984;
  assign not_2984 = ~run_shift_q[5];
  logic [7:0] select_2987;
  assign select_2987 = equal_588 ? ({{7{not_2984}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2991;
  assign select_2991 = and_2940 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2993;
  assign select_2993 = select_2943 ? {select_2991[6], select_2991} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2996;
  assign select_2996 = select_2943 ? (and_2940 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:530
  logic [6:0] select_3004;
  assign select_3004 = and_544 ? (equal_2939 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [5:0] sum_3005;
  assign sum_3005 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3007;
  assign select_3007 = and_544 ? (equal_2939 ? {sum_3005, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_3008;
  assign sum_3008 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3010;
  assign select_3010 = and_544 ? (equal_2939 ? {sum_3008, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_3021;
  assign select_3021 = (ends_cell_q | select_2943) ? (~(now == 3'h6)) : (equal_588 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_3025;
  assign and_3025 = (~select_2943) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_3026;
  assign sum_3026 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_3028;
  assign select_3028 = equal_2939 ? ({sum_3026[6], cfg_height_i[8:3]} == {1'b0, sum_3026[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3403;
  assign select_3403 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3404;
  assign select_3404 = sample_pair_whole_q ? select_3403 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_3405;
  assign and_3405 = not_2149 & equal_2151;
  logic [8:0] select_3406;
  assign select_3406 = and_3405 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3407;
  assign select_3407 = and_3405 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3408;
  assign select_3408 = sample_pair_first_q ? select_3406 : select_3407;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3410;
  assign select_3410 = sample_pair_whole_q ? (row_starts ? select_3408[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3412;
  assign select_3412 = sample_pair_whole_q ? (row_starts ? select_3408[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3415;
  assign select_3415 = sample_pair_whole_q ? (equal_2153 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3417;
  assign select_3417 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2153}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_3418;
  assign equal_3418 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_3419;
  assign not_3419 = ~equal_3418;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3421;
  assign select_3421 = sample_pair_whole_q ? (phase + {not_3419, 1'b1, not_3419, equal_3418}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_3423;
  assign equal_3423 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3427;
  assign select_3427 = equal_3423 ? ((select_3404 == 4'h6) ? 4'h0 : (select_3404 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3428;
  assign equal_3428 = select_3427 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_3431;
  assign select_3431 = equal_2939 ? (equal_3428 ? 4'h6 : (select_3427 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3433;
  assign select_3433 = equal_3423 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3435;
  assign select_3435 = equal_2939 ? (select_3433 + {4'h0, equal_3428}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:530
  logic select_3440;
  assign select_3440 = and_544 ? (equal_2939 ? ((6'h2 < row) & equal_3428) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3442;
  assign select_3442 = and_544 ? (equal_2939 ? select_3433 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3466;
  assign sum_3466 = {1'b0, select_675[5:1]} + 6'h1;
  logic less_3467;
  assign less_3467 = {sum_3466, select_675[0], select_522, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3470;
  assign select_3470 = row_starts ? (and_2158 ? (~less_3467) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3509;
  assign or_3509 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3514;
  assign select_3514 = (patches_second_q | patches_begins_q) ? not_2146 : (patches_ends_q & equal_2249);
  logic and_3515;
  assign and_3515 = equal_2249 & not_2256;
  // hls/stages/patches.hpp:403
  logic and_3516;
  assign and_3516 = not_2309 & and_3515;
  logic [1:0] select_3518;
  assign select_3518 = equal_2251 ? 2'h0 : (equal_2253 ? 2'h3 : {equal_2254, and_3516});
  // hls/stages/patches.hpp:283
  logic equal_3520;
  assign equal_3520 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3521;
  assign not_3521 = ~equal_3520;
  // hls/stages/patches.hpp:283
  logic equal_3522;
  assign equal_3522 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3523;
  assign not_3523 = ~equal_3522;
  // hls/stages/patches.hpp:287
  logic not_3525;
  assign not_3525 = ~(patches_following_q == 3'h2);
  logic and_3528;
  assign and_3528 = (~(patches_following_q == 3'h1)) & not_3525;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3529;
  assign select_3529 = equal_3522 ? 2'h2 : {and_3528, not_3525};
  logic [3:0] select_3530;
  assign select_3530 = equal_3520 ? 4'h2 : {select_3529, {2{not_3523}}};
  // hls/stages/patches.hpp:409
  logic not_3533;
  assign not_3533 = ~or_3509;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3538;
  assign select_3538 = or_3509 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3540;
  assign select_3540 = or_3509 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1386; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1387; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1389; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
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
      raster_at_x_q <= select_2610;
      raster_at_y_q <= select_2613;
      raster_at_column_q <= select_2616;
      raster_at_row_q <= select_2619;
      raster_at_live_q <= select_2623;
      raster_rows_left_q <= sample_pair_whole_q ? select_2625 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2629;
      averager_place_q <= sample_pair_whole_q ? select_509 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_514 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2947;
      run_last_shift_q <= select_2950;
      run_span_q <= select_2943 ? (and_2940 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2965;
      following_shift_q <= select_2955 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2968;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2971[6], or_2972, select_2971[3:0]};
      following_columns_q <= {or_2979[7], or_2980[4], or_2979[5:4], or_2980[3:0]};
      plan_shift_q <= equal_588 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2987;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2993;
      columns_left_q <= select_2996;
      last_q <= and_544 ? (equal_2939 ? last : last_q) : last_q;
      least_q <= select_3004;
      whole_q <= select_3007;
      drawn_q <= select_3010;
      age_q <= select_2943 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2943 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3021;
      ends_q <= and_3025;
      final_row_q <= and_544 ? select_3028 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3404;
      patches_band_rows_rows_to_next_q <= select_3410;
      patches_band_rows_number_q <= select_3412;
      patches_next_band_rows_to_next_q <= select_3415;
      patches_next_band_number_q <= select_3417;
      patches_first_band_rows_to_next_q <= select_3421;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3418 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_544 ? select_3431 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_544 ? select_3435 : patches_choosing_number_q;
      patches_chooses_q <= select_3440;
      patches_choosing_band_q <= select_3442;
      patches_capturing_q <= sample_pair_whole_q ? select_2285 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3470 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2279 : patches_row_q;
      patches_work_q <= or_3509 ? following : patches_work_q;
      patches_second_q <= select_3514;
      patches_following_q <= equal_2249 ? {2'h0, and_3515} : {equal_2251, select_3518};
      patches_following_beats_q <= {select_3530, not_3521};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2281);
      patches_ends_q <= not_3533 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3538;
      patches_code_row_q <= select_3540;
      patches_column_q <= or_3509 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3533 & (patches_column_q == 5'h1e);
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
  logic equal_2939_s1_q;
  logic and_2940_s1_q;
  logic or_3509_s1_q;
  logic not_3533_s1_q;
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
      equal_2939_s1_q <= equal_2939;
      and_2940_s1_q <= and_2940;
      or_3509_s1_q <= or_3509;
      not_3533_s1_q <= not_3533;
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
  logic and_518;
  assign and_518 = sample_pair_whole_s1_q & and_517_s1_q;
  // hls/stages/agreement.hpp:678
  logic equal_563;
  assign equal_563 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_564;
  assign equal_564 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_563 & equal_564;
  // hls/stages/moments.hpp:57
  logic [13:0] select_567;
  assign select_567 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:798
  logic [12:0] select_568;
  assign select_568 = first ? 13'h0 : select_567[12:0];
  // hls/stages/agreement.hpp:1019
  logic not_570;
  assign not_570 = ~equal_569_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_572;
  assign not_572 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_574_s1_q & not_578_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_567[13:6];
  // hls/stages/moments.hpp:104
  logic not_582;
  assign not_582 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:798
  logic and_586;
  assign and_586 = not_570 & (not_572 & (equal_573_s1_q & (inside_v & not_582)));
  // hls/stages/agreement.hpp:985
  logic and_603;
  assign and_603 = (or_574_s1_q & (left_rdata_q[67] & not_578_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:977
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:978
  logic [6:0] select_622;
  assign select_622 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:679
  logic or_746;
  assign or_746 = late_q | (~equal_563);
  // hls/stages/agreement.hpp:681
  logic and_747;
  assign and_747 = left_rdata_q[12] & or_746;
  logic and_748;
  assign and_748 = left_rdata_q[30] & or_746;
  logic and_749;
  assign and_749 = left_rdata_q[48] & or_746;
  logic and_750;
  assign and_750 = left_rdata_q[66] & or_746;
  // hls/stages/agreement.hpp:682
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
  // hls/stages/agreement.hpp:222
  logic and_761;
  assign and_761 = left_rdata_q[48] & not_578_s1_q;
  logic and_762;
  assign and_762 = right_codes_rdata_q[42] & not_578_s1_q;
  logic [11:0] select_763;
  assign select_763 = less_577_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_764;
  assign select_764 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_768;
  assign select_768 = and_761 ? (and_762 ? (~(select_763 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_774;
  assign parity_774 = ^select_768[5:3];
  logic parity_777;
  assign parity_777 = ^select_768[8:6];
  logic parity_780;
  assign parity_780 = ^select_768[11:3];
  // hls/stages/agreement.hpp:222
  logic and_784;
  assign and_784 = left_rdata_q[66] & not_578_s1_q;
  logic and_785;
  assign and_785 = right_codes_rdata_q[57] & not_578_s1_q;
  logic [11:0] select_786;
  assign select_786 = less_577_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_787;
  assign select_787 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_791;
  assign select_791 = and_784 ? (and_785 ? (~(select_786 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_794;
  assign parity_794 = ^select_791[8:6];
  logic parity_797;
  assign parity_797 = ^select_791[11:9];
  // hls/stages/agreement.hpp:222
  logic and_801;
  assign and_801 = left_rdata_q[84] & not_578_s1_q;
  logic and_802;
  assign and_802 = right_codes_rdata_q[72] & not_578_s1_q;
  logic [11:0] select_803;
  assign select_803 = less_577_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_804;
  assign select_804 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1005;
  assign select_1005 = equal_588_s1_q ? {and_1004, xor_1003, parity_997, parity_976, xor_931, xor_836} : 6'h0;
  logic [5:0] column;
  assign column = or_574_s1_q ? 6'h0 : select_1005;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1007;
  assign select_1007 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1008;
  assign difference_1008 = {1'b0, column} - {1'b0, select_1007};
  logic [7:0] sum_1010;
  assign sum_1010 = {difference_1008[6], difference_1008} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1014;
  assign select_1014 = and_761 ? (and_785 ? (~(select_763 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1020;
  assign parity_1020 = ^select_1014[5:3];
  logic parity_1023;
  assign parity_1023 = ^select_1014[8:6];
  logic parity_1026;
  assign parity_1026 = ^select_1014[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1033;
  assign select_1033 = and_784 ? (and_802 ? (~(select_786 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1036;
  assign parity_1036 = ^select_1033[8:6];
  logic parity_1039;
  assign parity_1039 = ^select_1033[11:9];
  // hls/stages/agreement.hpp:222
  logic and_1043;
  assign and_1043 = right_codes_rdata_q[85] & not_578_s1_q;
  logic [11:0] select_1044;
  assign select_1044 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1245;
  assign select_1245 = equal_588_s1_q ? {and_1244, xor_1243, parity_1237, parity_1216, xor_1171, xor_1076} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_574_s1_q ? 6'h0 : select_1245;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1247;
  assign select_1247 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1248;
  assign difference_1248 = {1'b0, column_2} - {1'b0, select_1247};
  logic [7:0] sum_1250;
  assign sum_1250 = {difference_1248[6], difference_1248} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:222
  logic and_1251;
  assign and_1251 = right_codes_rdata_q[27] & not_578_s1_q;
  logic [11:0] select_1252;
  assign select_1252 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1256;
  assign select_1256 = and_761 ? (and_1251 ? (~(select_763 ^ select_1252)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1262;
  assign parity_1262 = ^select_1256[5:3];
  logic parity_1265;
  assign parity_1265 = ^select_1256[8:6];
  logic parity_1268;
  assign parity_1268 = ^select_1256[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1275;
  assign select_1275 = and_784 ? (and_762 ? (~(select_786 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1275[8:6];
  logic parity_1281;
  assign parity_1281 = ^select_1275[11:9];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1485;
  assign select_1485 = equal_588_s1_q ? {and_1484, xor_1483, parity_1477, parity_1456, xor_1411, xor_1316} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_574_s1_q ? 6'h0 : select_1485;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1487;
  assign select_1487 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1488;
  assign difference_1488 = {1'b0, column_3} - {1'b0, select_1487};
  logic [7:0] sum_1490;
  assign sum_1490 = {difference_1488[6], difference_1488} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1498;
  assign select_1498 = and_761 ? (and_802 ? (~(select_763 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1504;
  assign parity_1504 = ^select_1498[5:3];
  logic parity_1507;
  assign parity_1507 = ^select_1498[8:6];
  logic parity_1510;
  assign parity_1510 = ^select_1498[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1517;
  assign select_1517 = and_784 ? (and_1043 ? (~(select_786 ^ select_1044)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1520;
  assign parity_1520 = ^select_1517[8:6];
  logic parity_1523;
  assign parity_1523 = ^select_1517[11:9];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1729;
  assign select_1729 = equal_588_s1_q ? {and_1728, xor_1727, parity_1721, parity_1700, xor_1655, xor_1560} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_574_s1_q ? 6'h0 : select_1729;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1731;
  assign select_1731 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1732;
  assign difference_1732 = {1'b0, column_4} - {1'b0, select_1731};
  logic [7:0] sum_1734;
  assign sum_1734 = {difference_1732[6], difference_1732} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1759;
  assign select_1759 = and_784 ? (and_1251 ? (~(select_786 ^ select_1252)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1762;
  assign parity_1762 = ^select_1759[8:6];
  logic parity_1765;
  assign parity_1765 = ^select_1759[11:9];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1969;
  assign select_1969 = equal_588_s1_q ? {and_1968, xor_1967, parity_1961, parity_1940, xor_1895, xor_1800} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_574_s1_q ? 6'h0 : select_1969;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1971;
  assign select_1971 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1972;
  assign difference_1972 = {1'b0, column_5} - {1'b0, select_1971};
  logic [7:0] sum_1974;
  assign sum_1974 = {difference_1972[6], difference_1972} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:798
  logic and_2045;
  assign and_2045 = ends_cell_s1_q & inside_v;
  logic and_2047;
  assign and_2047 = not_570 & (so_s1_q & and_2045);
  logic [6:0] select_2051;
  assign select_2051 = so_s1_q ? x_s1_q[6:0] : (or_574_s1_q ? (less_577_s1_q ? 7'h0 : select_622) : 7'h0);
  // hls/stages/agreement.hpp:248
  logic or_2055;
  assign or_2055 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
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
  // hls/stages/agreement.hpp:276
  logic and_2413;
  assign and_2413 = not_2252_s1_q & (or_2255_s1_q & (or_2404 & (equal_2254_s1_q & and_2409)));
  // hls/stages/patches.hpp:174
  logic and_2423;
  assign and_2423 = (~(equal_2254_s1_q | (~and_2409))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
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
  // hls/stages/agreement.hpp:1287
  logic or_2499;
  assign or_2499 = sample_pair_first_q | line_ended_q;
  // hls/stages/agreement.hpp:1289
  logic [16:0] select_2501;
  assign select_2501 = sample_pair_first_q ? 17'h1 : (or_2499 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1288
  logic [8:0] select_2503;
  assign select_2503 = or_2499 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1296
  logic select_2505;
  assign select_2505 = cfg_compete_i ? (or_2499 & select_2501[16]) : (select_2503[8] & select_2501[9]);
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2505 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1303
  logic [6:0] select_2508;
  assign select_2508 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2510;
  assign select_2510 = sample_pair_first_q ? 13'h0 : (seen_base_q + {6'h0, select_2508});
  // hls/stages/agreement.hpp:1314
  logic equal_2511;
  assign equal_2511 = seen_x_q == 3'h7;
  // hls/stages/agreement.hpp:1286
  logic not_2518;
  assign not_2518 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:461
  logic [5:0] or_2749;
  assign or_2749 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:465
  logic select_3033;
  assign select_3033 = equal_2939_s1_q ? (~({row_s1_q, 1'b0} < {sum_3030, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_3036;
  assign and_3036 = proven_q & less_3035;
  // hls/stages/agreement.hpp:530
  logic select_3040;
  assign select_3040 = and_544_s1_q ? (equal_2939_s1_q ? (and_3036 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_3041;
  assign equal_3041 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_3042;
  assign and_3042 = and_3036 & equal_3041;
  // hls/stages/agreement.hpp:530
  logic and_3293;
  assign and_3293 = and_544_s1_q & (equal_2939_s1_q & equal_3041);
  // hls/stages/registration.hpp:128
  logic and_3294;
  assign and_3294 = and_2940_s1_q & and_3293;
  // hls/stages/registration.hpp:127
  logic and_3296;
  assign and_3296 = and_2940_s1_q & (~and_3293);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3297;
  assign select_3297 = and_3296 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3299;
  assign select_3299 = and_3294 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3297[15]}}, select_3297});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3300;
  assign select_3300 = and_3296 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3300[15]}}, select_3300};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3302;
  assign select_3302 = and_3294 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_3303;
  assign and_3303 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3303 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3548;
  assign select_3548 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3551;
  assign select_3551 = equal_2251_s1_q ? patches_smooth_values_0_q : (or_2255_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3553;
  assign select_3553 = or_2255_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3555;
  assign select_3555 = equal_2249_s1_q ? patches_smooth_values_1_q : (equal_2251_s1_q ? patches_smooth_values_1_q : select_3553);
  logic [11:0] select_3556;
  assign select_3556 = or_2255_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3558;
  assign select_3558 = equal_2249_s1_q ? patches_smooth_values_2_q : (equal_2251_s1_q ? patches_smooth_values_2_q : select_3556);
  logic [11:0] select_3559;
  assign select_3559 = or_2255_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3561;
  assign select_3561 = equal_2249_s1_q ? patches_smooth_values_3_q : (equal_2251_s1_q ? patches_smooth_values_3_q : select_3559);
  logic [10:0] select_3563;
  assign select_3563 = equal_2251_s1_q ? patches_down_values_0_q : (or_2255_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3566;
  assign select_3566 = equal_2251_s1_q ? patches_down_values_1_q : (or_2255_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3569;
  assign select_3569 = equal_2251_s1_q ? patches_down_values_2_q : (or_2255_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3572;
  assign select_3572 = equal_2251_s1_q ? patches_down_values_3_q : (or_2255_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3609;
  assign and_3609 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3614;
  assign select_3614 = or_3509_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3616;
  assign select_3616 = and_3609 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3972;
  assign select_3972 = equal_2249_s1_q ? patches_summed_down_by_q : (equal_2251_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3990;
  assign select_3990 = equal_2249_s1_q ? (less_2429 & (equal_2431 & or_2432)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_4295;
  assign select_4295 = so_s1_q ? (and_3303 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4297;
  assign sum_4297 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4298;
  assign select_4298 = sum_2456[5] ? {1'b1, sum_2456[4:0], region_across_rest_q[2:0]} : sum_4297;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4300;
  assign select_4300 = equal_2939_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4303;
  assign select_4303 = equal_2939_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1159
  logic equal_4353;
  assign equal_4353 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:1313
  logic [2:0] select_4520;
  assign select_4520 = select_2505 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4526;
  assign select_4526 = sample_pair_first_q ? select_4524 : (seen_rows_left_q - {7'h0, was_next_row_q});

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

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1390; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1391; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1419; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
      row_q <= and_544_s1_q ? (equal_2939_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_544_s1_q ? select_3033 : lower_half_q;
      late_q <= select_3040;
      registration_slope_row_q <= select_3299;
      registration_slope_change_q <= select_3302;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3533_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3533_s1_q & select_3548;
      patches_smooth_values_0_q <= equal_2249_s1_q ? patches_smooth_values_0_q : select_3551;
      patches_smooth_values_1_q <= select_3555;
      patches_smooth_values_2_q <= select_3558;
      patches_smooth_values_3_q <= select_3561;
      patches_down_values_0_q <= equal_2249_s1_q ? patches_down_values_0_q : select_3563;
      patches_down_values_1_q <= equal_2249_s1_q ? patches_down_values_1_q : select_3566;
      patches_down_values_2_q <= equal_2249_s1_q ? patches_down_values_2_q : select_3569;
      patches_down_values_3_q <= equal_2249_s1_q ? patches_down_values_3_q : select_3572;
      patches_down_by_q <= or_3509_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3609});
      patches_along_q <= select_3614;
      patches_match_row_q <= or_3509_s1_q ? 4'h0 : select_3616;
      patches_summed_last_q <= not_2250_s1_q & (equal_2251_s1_q & and_3609);
      patches_summed_down_by_q <= select_3972;
      patches_step_q <= or_3509_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3990;
      region_across_rest_q <= select_4295;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4298;
      columns_begin_rest_q <= and_544_s1_q ? select_4300 : columns_begin_rest_q;
      columns_begin_back_q <= and_544_s1_q ? select_4303 : columns_begin_back_q;
      done_q <= not_2518 & ((~drew_q) & (done_q | said_q));
      proven_q <= sample_pair_first_q ? done_q : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_569_s1_q & equal_4353;
      rows_passed_q <= select_2501;
      columns_passed_q <= {select_2503[7:0], or_2499};
      line_ended_q <= sample_last_q;
      began_q <= not_2518 & (began_q | select_2505);
      seen_x_q <= select_2505 ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= sample_pair_first_q ? 3'h0 : select_4520;
      seen_column_q <= select_2505 ? 8'h0 : (seen_column_q + {7'h0, equal_2511});
      seen_rows_left_q <= select_4526;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2510;
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
  logic and_2478_s2_q;
  logic less_2596_s2_q;
  logic equal_2750_s2_q;
  logic equal_2939_s2_q;
  logic and_3042_s2_q;
  logic and_3056_s2_q;
  logic equal_3145_s2_q;
  logic less_3585_s2_q;
  logic equal_3928_s2_q;
  logic equal_4025_s2_q;
  logic less_4281_s2_q;
  logic equal_4353_s2_q;
  logic or_4503_s2_q;
  logic not_4546_s2_q;
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
      and_2478_s2_q <= or_574_s1_q & (left_rdata_q[69] & not_578_s1_q);
      less_2596_s2_q <= 6'h6 < row_q;
      equal_2750_s2_q <= {last_s1_2_q[6], or_2749} == 7'h0;
      equal_2939_s2_q <= equal_2939_s1_q;
      and_3042_s2_q <= and_3042;
      and_3056_s2_q <= or_574_s1_q & (not_578_s1_q & and_603);
      equal_3145_s2_q <= shift == 6'h0;
      less_3585_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3928_s2_q <= patches_match_row_q == 4'h0;
      equal_4025_s2_q <= patches_step_q[6:5] == 2'h3;
      less_4281_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4353_s2_q <= equal_4353;
      or_4503_s2_q <= and_3042 | (~(row_s1_q[5:3] == 3'h0));
      not_4546_s2_q <= ~proven_q;
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
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = select_505_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_533;
  assign and_533 = whole & (averager_memory_rdata_q[24] | equal_523_s2_q);
  // hls/stages/agreement.hpp:423
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
  // hls/stages/agreement.hpp:277
  logic [8:0] select_550;
  assign select_550 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_517_s2_q ? sum_529[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_547 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_554;
  assign select_554 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_555;
  assign and_555 = and_517_s2_q & and_533;
  // hls/stages/census.hpp:134
  logic select_557;
  assign select_557 = equal_547 ? and_555 : (averager_mask_q & and_555);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_557;
  // hls/stages/census.hpp:218
  logic and_559;
  assign and_559 = and_517_s2_q & and_537;
  // hls/stages/census.hpp:134
  logic select_561;
  assign select_561 = equal_547 ? and_559 : (averager_of_skin_q & and_559);
  // hls/stages/agreement.hpp:277
  logic and_562;
  assign and_562 = sample_pair_whole_s2_q & select_561;
  // hls/stages/agreement.hpp:988
  logic select_617;
  assign select_617 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_627;
  assign difference_627 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_628;
  assign sum_628 = {difference_627[8], difference_627} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_630;
  assign and_630 = (and_604_s2_q & select_617) & ({{22{sum_628[9]}}, sum_628} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_632;
  assign and_632 = or_574_s2_q & (not_578_s2_q & and_630);
  // hls/stages/agreement.hpp:263
  logic and_634;
  assign and_634 = and_632 & not_633_s2_q;
  // hls/stages/moments.hpp:77
  logic and_635;
  assign and_635 = and_595_s2_q & and_634;
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
  // hls/stages/agreement.hpp:460
  logic equal_674;
  assign equal_674 = last_s2_2_q == 7'h0;
  logic [3:0] select_678;
  assign select_678 = equal_677_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:817
  logic or_758;
  assign or_758 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:818
  logic select_760;
  assign select_760 = or_758 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:761
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
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1977 ? select_1976 : select_1494) : 8'h0;
  // hls/stages/agreement.hpp:818
  logic or_1981;
  assign or_1981 = select_760 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:823
  logic [5:0] select_1982;
  assign select_1982 = or_1981 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:762
  logic or_1984;
  assign or_1984 = less_1491 | (~less_1493);
  logic [2:0] select_1985;
  assign select_1985 = less_1977 ? {less_1975, 2'h0} : {1'b0, or_1984, less_1493};
  // hls/stages/agreement.hpp:823
  logic [2:0] select_1986;
  assign select_1986 = or_1981 ? select_1985 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1987;
  assign select_1987 = or_1981 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:820
  logic equal_1988;
  assign equal_1988 = select_1985 == 3'h1;
  logic or_1991;
  assign or_1991 = equal_1988 | (~(select_1985 == 3'h2));
  logic [7:0] select_1993;
  assign select_1993 = or_1991 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1994;
  assign select_1994 = equal_1988 ? (or_1991 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1993;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1995;
  assign select_1995 = or_1981 ? select_1994 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:821
  logic [7:0] select_1996;
  assign select_1996 = or_1991 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1998;
  assign select_1998 = or_1981 ? (equal_1988 ? select_1993 : select_1996) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2000;
  assign sum_2000 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_2001;
  assign sum_2001 = {1'b0, before_v} + sum_2000;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2003;
  assign sum_2003 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_2004;
  assign sum_2004 = {1'b0, before_v_2} + sum_2003;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2006;
  assign sum_2006 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, before_v_3} + sum_2006;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2009;
  assign select_2009 = (sum_2004 < sum_2007) ? sum_2007 : sum_2004;
  logic [6:0] select_2011;
  assign select_2011 = (sum_2001 < select_2009) ? select_2009 : sum_2001;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2013;
  assign sum_2013 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2014;
  assign sum_2014 = {1'b0, before_v_4} + sum_2013;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2016;
  assign sum_2016 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2017;
  assign sum_2017 = {1'b0, before_v_5} + sum_2016;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2019;
  assign select_2019 = (sum_2014 < sum_2017) ? sum_2017 : sum_2014;
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2011 < select_2019) ? select_2019 : select_2011) : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_2023;
  assign less_2023 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:827
  logic [6:0] select_2025;
  assign select_2025 = select_760 ? of_near : (less_2023 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2027;
  assign select_2027 = select_760 ? run_shift_s2_q : (less_2023 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2030;
  assign select_2030 = (run_shift_s2_q == 6'h3f) ? of_best : (select_760 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2033;
  assign select_2033 = (run_shift_s2_q == 6'h1) ? of_best : (select_760 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:833
  logic select_2036;
  assign select_2036 = or_758 ? shift_first_s2_q : equal_2035_s2_q;
  // hls/stages/agreement.hpp:834
  logic or_2038;
  assign or_2038 = select_2036 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:838
  logic [7:0] select_2039;
  assign select_2039 = or_2038 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2040;
  assign select_2040 = or_2038 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2042;
  assign or_2042 = select_2036 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:842
  logic [6:0] select_2043;
  assign select_2043 = or_2042 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2044;
  assign select_2044 = or_2042 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_2058;
  assign and_2058 = or_574_s2_q & (not_578_s2_q & (and_630 & or_2055_s2_q));
  // hls/stages/agreement.hpp:798
  logic and_2059;
  assign and_2059 = not_572_s2_q & and_2058;
  logic and_2062;
  assign and_2062 = not_570_s2_q & (drew_q ? and_2045_s2_q : (equal_573_s2_q & and_632));
  // hls/stages/moments.hpp:73
  logic and_2066;
  assign and_2066 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1013
  logic and_2067;
  assign and_2067 = not_582_s2_q & and_2066;
  logic and_2070;
  assign and_2070 = not_582_s2_q & (and_2066 & (moments_memory_rdata_q[1] ^ and_637_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2075;
  assign and_2075 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1013
  logic and_2076;
  assign and_2076 = not_582_s2_q & and_2075;
  logic and_2079;
  assign and_2079 = not_582_s2_q & (and_2075 & (moments_memory_rdata_q[3] ^ and_644_s2_q));
  // hls/stages/agreement.hpp:1140
  logic equal_2080;
  assign equal_2080 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1190
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1141
  logic [1:0] select_2083;
  assign select_2083 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1154
  logic [3:0] select_2085;
  assign select_2085 = equal_2080 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2083});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2086;
  assign sum_2086 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:1190
  logic and_2106;
  assign and_2106 = (~equal_2096) & ((~equal_2098) & ((~equal_2100) & (~equal_2102)));
  logic and_2110;
  assign and_2110 = (~equal_2088) & ((~equal_2090) & ((~equal_2092) & ((~equal_2094) & and_2106)));
  // hls/stages/agreement.hpp:1141
  logic less_2111;
  assign less_2111 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2115;
  assign or_2115 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1019
  logic [5:0] sum_2120;
  assign sum_2120 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
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
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:798
  logic and_2171;
  assign and_2171 = not_570_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2173;
  assign equal_2173 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
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
  // hls/stages/agreement.hpp:263
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
  // hls/stages/agreement.hpp:1028
  logic and_2211;
  assign and_2211 = ($signed(9'h0) < $signed(sum_2206[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2208, sum_2206[0]})));
  logic and_2212;
  assign and_2212 = (~(and_2200 | (equal_564_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2211;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2223;
  assign select_2223 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2225;
  assign select_2225 = and_2219 ? (equal_569_s2_q ? 8'h0 : select_2223) : patches_choice_column_q;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2239;
  assign select_2239 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2241;
  assign select_2241 = and_2219 ? (equal_569_s2_q ? 8'h0 : select_2239) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2242;
  assign equal_2242 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2443;
  assign select_2443 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1061
  logic or_2446;
  assign or_2446 = select_2443[7] | (~({select_2443[5], select_2443[3], select_2443[1]} == 3'h0));
  // hls/stages/agreement.hpp:1060
  logic or_2449;
  assign or_2449 = select_2443[7] | (~({select_2443[6], select_2443[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1059
  logic or_2452;
  assign or_2452 = select_2443[7] | (~(select_2443[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_2453;
  assign select_2453 = equal_569_s2_q ? x_s2_q[5:0] : {region_row_q, or_2452, or_2449, or_2446};
  // hls/stages/agreement.hpp:1140
  logic not_2454;
  assign not_2454 = ~equal_2080;
  // hls/stages/agreement.hpp:1069
  logic or_2458;
  assign or_2458 = (~sum_2456_s2_q) | equal_2242;
  // hls/stages/agreement.hpp:798
  logic and_2461;
  assign and_2461 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2458));
  // hls/stages/agreement.hpp:150
  logic and_2465;
  assign and_2465 = or_574_s2_q & (not_578_s2_q & and_604_s2_q);
  logic and_2480;
  assign and_2480 = or_574_s2_q & (not_578_s2_q & and_2478_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2465;
  logic and_2491;
  assign and_2491 = inside_v_s2_q & and_2480;
  logic explained;
  assign explained = inside_v_s2_q & and_632;
  // hls/stages/agreement.hpp:1024
  logic select_2493;
  assign select_2493 = slot_s2_q[2] ? shown_shown_q : and_632;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2493);
  // hls/stages/agreement.hpp:1024
  logic select_2496;
  assign select_2496 = slot_s2_q[2] ? shown_nearer_q : and_2058;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2493 ? select_2496 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1321
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1287
  logic select_2516;
  assign select_2516 = marks_first_s2_q ? (done_s2_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1273
  logic [7:0] sum_2517;
  assign sum_2517 = {1'b0, select_2516, 2'h0, select_2516, 1'b0, {2{select_2516}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1320
  logic and_2524;
  assign and_2524 = began_q & (seen_x_q == 3'h0);
  logic less_2525;
  assign less_2525 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1123
  logic [7:0] sum_2528;
  assign sum_2528 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2528[7]}}, sum_2528, x_s2_q[1:0]} + map_row_q;
  logic select_2530;
  assign select_2530 = draws_late_q ? read_half_q : write_half_q;
  // hls/stages/agreement.hpp:1273
  logic [7:0] sum_2531;
  assign sum_2531 = {1'b0, select_2530, 2'h0, select_2530, 1'b0, {2{select_2530}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1040
  logic and_2532;
  assign and_2532 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2533;
  assign and_2533 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2534;
  assign and_2534 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2535;
  assign and_2535 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1098
  logic [1:0] sum_2537;
  assign sum_2537 = {1'b0, and_2534} + ({1'b0, textured} + {1'b0, and_2535});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2532} + ({2'h0, and_2533} + {1'b0, sum_2537});
  // hls/stages/agreement.hpp:1040
  logic [7:0] select_2546;
  assign select_2546 = inside_v_s2_q ? (sum_2456_s2_q ? select_2443 : {select_2443[6:0], 1'b0}) : select_2443;
  // hls/stages/agreement.hpp:1061
  logic or_2549;
  assign or_2549 = select_2546[7] | (~({select_2546[5], select_2546[3], select_2546[1]} == 3'h0));
  // hls/stages/agreement.hpp:1040
  logic and_2566;
  assign and_2566 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2567;
  assign and_2567 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2568;
  assign and_2568 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2569;
  assign and_2569 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1100
  logic [1:0] sum_2571;
  assign sum_2571 = {1'b0, and_2568} + ({1'b0, shown} + {1'b0, and_2569});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2566} + ({2'h0, and_2567} + {1'b0, sum_2571});
  // hls/stages/agreement.hpp:1040
  logic and_2582;
  assign and_2582 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2583;
  assign and_2583 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2584;
  assign and_2584 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2585;
  assign and_2585 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2587;
  assign sum_2587 = {1'b0, and_2584} + ({1'b0, near} + {1'b0, and_2585});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2582} + ({2'h0, and_2583} + {1'b0, sum_2587});
  // hls/stages/agreement.hpp:1122
  logic not_2598;
  assign not_2598 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1123
  logic not_2600;
  assign not_2600 = ~({sum_2120, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:798
  logic select_2604;
  assign select_2604 = less_2596_s2_q ? (not_2598 & not_2600) : ((draws_late_q & not_2598) & not_2600);
  logic and_2607;
  assign and_2607 = not_570_s2_q & (drew_q & (ends_cell_s2_q & select_2604));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2641;
  assign select_2641 = sample_pair_whole_s2_q ? (and_542_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2643;
  assign select_2643 = sample_pair_whole_s2_q ? (and_542_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2663;
  assign select_2663 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2665;
  assign select_2665 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_557 : averager_mask_q) : averager_mask_q;
  logic select_2667;
  assign select_2667 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_561 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2668;
  assign select_2668 = and_544_s2_q ? select_550 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2669;
  assign select_2669 = and_544_s2_q ? select_554 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2671;
  assign select_2671 = and_544_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_544_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2673;
  assign select_2673 = and_544_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_544_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_544_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2676;
  assign select_2676 = and_544_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2677;
  assign select_2677 = and_544_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2678;
  assign select_2678 = and_544_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2679;
  assign select_2679 = and_544_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2680;
  assign select_2680 = and_544_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2681;
  assign select_2681 = and_544_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2682;
  assign select_2682 = and_544_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2683;
  assign select_2683 = and_544_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2684;
  assign select_2684 = and_544_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2685;
  assign select_2685 = and_544_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2686;
  assign select_2686 = and_544_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2687;
  assign select_2687 = and_544_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_544_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2689;
  assign select_2689 = and_544_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_544_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_544_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2692;
  assign select_2692 = and_544_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2693;
  assign select_2693 = and_544_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2694;
  assign select_2694 = and_544_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2695;
  assign select_2695 = and_544_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2696;
  assign select_2696 = and_544_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2697;
  assign select_2697 = and_544_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2698;
  assign select_2698 = and_544_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2699;
  assign select_2699 = and_544_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2700;
  assign select_2700 = and_544_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2701;
  assign select_2701 = and_544_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2702;
  assign select_2702 = and_544_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2703;
  assign select_2703 = and_544_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2704;
  assign select_2704 = and_544_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2705;
  assign select_2705 = and_544_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2706;
  assign select_2706 = and_544_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2707;
  assign select_2707 = and_544_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2708;
  assign select_2708 = and_544_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2709;
  assign select_2709 = and_544_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2710;
  assign select_2710 = and_544_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2711;
  assign select_2711 = and_544_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2712;
  assign select_2712 = and_544_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2713;
  assign select_2713 = and_544_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2714;
  assign select_2714 = and_544_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2715;
  assign select_2715 = and_544_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2716;
  assign select_2716 = and_544_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2717;
  assign select_2717 = and_544_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2718;
  assign select_2718 = and_544_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2719;
  assign select_2719 = and_544_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2720;
  assign select_2720 = and_544_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2721;
  assign select_2721 = and_544_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2722;
  assign select_2722 = and_544_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2723;
  assign select_2723 = and_544_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2725;
  assign difference_2725 = {1'b0, select_554} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2726;
  assign xor_2726 = difference_2725[8:0] ^ {9{difference_2725[9]}};
  logic [9:0] sum_2727;
  assign sum_2727 = {9'h0, difference_2725[9]} + {1'b0, xor_2726};
  logic [9:0] difference_2728;
  assign difference_2728 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2729;
  assign xor_2729 = difference_2728[8:0] ^ {9{difference_2728[9]}};
  logic [9:0] sum_2730;
  assign sum_2730 = {9'h0, difference_2728[9]} + {1'b0, xor_2729};
  logic [9:0] difference_2732;
  assign difference_2732 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2733;
  assign xor_2733 = difference_2732[8:0] ^ {9{difference_2732[9]}};
  logic [9:0] sum_2734;
  assign sum_2734 = {9'h0, difference_2732[9]} + {1'b0, xor_2733};
  logic [10:0] sum_2735;
  assign sum_2735 = ({1'b0, sum_2727} + {1'b0, sum_2730}) + {1'b0, sum_2734};
  logic [9:0] difference_2736;
  assign difference_2736 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2737;
  assign xor_2737 = difference_2736[8:0] ^ {9{difference_2736[9]}};
  logic [9:0] sum_2738;
  assign sum_2738 = {9'h0, difference_2736[9]} + {1'b0, xor_2737};
  logic [9:0] difference_2740;
  assign difference_2740 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2741;
  assign xor_2741 = difference_2740[8:0] ^ {9{difference_2740[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2762;
  assign sum_2762 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2764;
  assign sum_2764 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1154
  logic equal_2765;
  assign equal_2765 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2766;
  assign select_2766 = equal_2765 ? sum_2762 : moments_before_0_q;
  logic [13:0] select_2768;
  assign select_2768 = equal_2765 ? sum_2764 : moments_before_1_q;
  // hls/stages/agreement.hpp:798
  logic select_2771;
  assign select_2771 = equal_569_s2_q ? (moments_has_before_q | equal_2765) : moments_has_before_q;
  logic [13:0] select_2774;
  assign select_2774 = equal_569_s2_q ? ((select_2768 < select_2766) ? select_2766 : select_2768) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2775;
  assign sum_2775 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2778;
  assign select_2778 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2775)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2779;
  assign sum_2779 = {1'b0, sum_2764} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2782;
  assign select_2782 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2779)) : moments_left_alone_q;
  logic select_2785;
  assign select_2785 = equal_569_s2_q ? (~({3'h0, select_2768[13:2]} < sum_2779)) : moments_left_other_stops_q;
  logic select_2788;
  assign select_2788 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2775)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2789;
  assign sum_2789 = {1'b0, sum_2762} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2792;
  assign select_2792 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2789)) : moments_right_alone_q;
  logic select_2795;
  assign select_2795 = equal_569_s2_q ? (~({3'h0, select_2766[13:2]} < sum_2789)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2798;
  assign or_2798 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:798
  logic and_2806;
  assign and_2806 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2070)));
  logic and_2810;
  assign and_2810 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2079)));
  // hls/stages/moments.hpp:94
  logic and_2812;
  assign and_2812 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2815;
  assign select_2815 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2812)) : and_2812;
  // hls/stages/agreement.hpp:798
  logic and_2819;
  assign and_2819 = equal_569_s2_q & (equal_2765 & (cfg_prove_i & (cfg_same_table_i & select_2815)));
  // hls/stages/moments.hpp:95
  logic and_2822;
  assign and_2822 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2836;
  assign difference_2836 = {1'b0, select_550} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2836[9]} + (difference_2836[8:0] ^ {9{difference_2836[9]}});
  logic [9:0] difference_2848;
  assign difference_2848 = {1'b0, select_554} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2848[9]} + (difference_2848[8:0] ^ {9{difference_2848[9]}});
  // hls/stages/agreement.hpp:530
  logic select_3044;
  assign select_3044 = and_544_s2_q ? (equal_2939_s2_q ? and_3042_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:798
  logic not_3046;
  assign not_3046 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3047;
  assign less_3047 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:530
  logic and_3054;
  assign and_3054 = and_544_s2_q & (equal_677_s2_q & equal_2939_s2_q);
  // hls/stages/agreement.hpp:798
  logic and_3059;
  assign and_3059 = ends_cell_s2_q & (inside_v_s2_q & (and_3056_s2_q & not_633_s2_q));
  // hls/stages/agreement.hpp:1040
  logic and_3083;
  assign and_3083 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3084;
  assign and_3084 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3085;
  assign and_3085 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3086;
  assign and_3086 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1099
  logic [1:0] sum_3088;
  assign sum_3088 = {1'b0, and_3085} + ({1'b0, explained} + {1'b0, and_3086});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3083} + ({2'h0, and_3084} + {1'b0, sum_3088});
  // hls/stages/agreement.hpp:798
  logic and_3124;
  assign and_3124 = ends_cell_s2_q & (inside_v_s2_q & (not_633_s2_q & (and_3056_s2_q & and_2480)));
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_3149;
  assign difference_3149 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3152;
  assign less_3152 = {2'h0, difference_3149[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_3155;
  assign and_3155 = not_578_s2_q & (((and_2478_s2_q & and_630) & equal_3145_s2_q) & (~less_3152));
  // hls/stages/agreement.hpp:798
  logic and_3159;
  assign and_3159 = ends_cell_s2_q & (inside_v_s2_q & ((or_574_s2_q & and_3155) & not_633_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_3165;
  assign and_3165 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_3167;
  assign and_3167 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3168;
  assign select_3168 = or_574_s2_q ? {and_3167, and_3165} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_3170;
  assign select_3170 = less_577_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3171;
  assign select_3171 = or_574_s2_q ? select_3170 : 2'h0;
  // hls/stages/agreement.hpp:1037
  logic and_3173;
  assign and_3173 = and_632 & (select_3168[0] & select_3171[0]);
  // hls/stages/agreement.hpp:798
  logic and_3177;
  assign and_3177 = ends_cell_s2_q & (inside_v_s2_q & (not_633_s2_q & (select_3168[1] & and_3173)));
  logic and_3179;
  assign and_3179 = not_570_s2_q & (drew_q & and_3177);
  logic and_3185;
  assign and_3185 = ends_cell_s2_q & (inside_v_s2_q & (not_633_s2_q & (select_3171[1] & and_3173)));
  logic and_3187;
  assign and_3187 = not_570_s2_q & (drew_q & and_3185);
  // hls/stages/registration.hpp:76
  logic less_3190;
  assign less_3190 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_3192;
  assign select_3192 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3194;
  assign select_3194 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3196;
  assign select_3196 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3194} - {1'b0, select_3196};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3198;
  assign select_3198 = rise_2[8] ? select_3194 : select_3196;
  logic [8:0] fall;
  assign fall = {1'b0, select_3192} - {1'b0, select_3198};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3201;
  assign not_3201 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3190 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3201};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3203;
  assign xor_3203 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3203};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3209;
  assign select_3209 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3190 ? {taken, 1'b1} : {not_3201, select_3209, not_3201};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3211;
  assign sum_3211 = {left, 1'b1} + {taken_2, less_3190};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_3213;
  assign select_3213 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3215;
  assign select_3215 = equal_569_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_3217;
  assign select_3217 = equal_569_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3218;
  assign equal_3218 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_3222;
  assign and_3222 = and_632 & less_2172_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_3224;
  assign select_3224 = or_574_s2_q ? (less_577_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3228;
  assign sum_3228 = select_3224[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3231;
  assign select_3231 = (select_3194 < select_3196) ? ({sum_3228, select_3224[0], 5'h0} - {3'h0, select_3213}) : {sum_3228, select_3224[0], select_3213};
  logic [7:0] select_3232;
  assign select_3232 = ((select_3224 == 3'h0) | (select_3224 == 3'h4)) ? {sum_3228, select_3224[0], 5'h0} : select_3231;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3232[7]}}, select_3232} - {sum_2191[9], sum_2191, sum_2187[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3235;
  assign select_3235 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3235[11:7])) ? 12'h7f : select_3235;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3256;
  assign difference_3256 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3258;
  assign and_3258 = and_3222 & ($signed(difference_3256) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3271;
  assign less_3271 = $signed(difference_3256) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:798
  logic select_3279;
  assign select_3279 = drew_q ? (equal_3218 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3282;
  assign select_3282 = drew_q ? (equal_2173 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3287;
  assign select_3287 = (sum_2086 == 2'h2) ? (registration_fresh_q & (~select_2133)) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_3289;
  assign select_3289 = drew_q ? (and_2128 ? select_3287 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3291;
  assign select_3291 = and_3054 ? 4'hf : (equal_569_s2_q ? registration_fresh_q : select_3289);
  // hls/stages/agreement.hpp:1141
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2083;
  // hls/stages/registration.hpp:258
  logic not_3311;
  assign not_3311 = ~quarter_2[1];
  logic [3:0] select_3312;
  assign select_3312 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3311, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3311};
  // hls/stages/patches.hpp:91
  logic parity_3446;
  assign parity_3446 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3447;
  assign select_3447 = equal_2939_s2_q ? {patches_chance_q[14:0], parity_3446} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3449;
  assign not_3449 = ~and_2247;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3452;
  assign select_3452 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3452};
  // hls/stages/agreement.hpp:798
  logic and_3458;
  assign and_3458 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3462;
  assign and_3462 = not_3449 & (patches_fixed_q | ((not_570_s2_q & and_3458) & and_2219));
  // hls/stages/patches.hpp:358
  logic not_3474;
  assign not_3474 = ~select_2162[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3476;
  assign select_3476 = sample_pair_whole_s2_q ? (equal_2163 ? select_2162 : {not_3474, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3575;
  assign select_3575 = or_2255_s2_q ? {and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3577;
  assign select_3577 = equal_2249_s2_q ? patches_codes_at_q : (equal_2251_s2_q ? other[55:4] : select_3575);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_2354_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3580;
  assign select_3580 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3582;
  assign select_3582 = equal_2251_s2_q ? (new_row_s2_q ? word : select_3580) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3584;
  assign select_3584 = less_2341_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3586;
  assign select_3586 = less_3585_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3588;
  assign select_3588 = or_2255_s2_q ? (equal_2254_s2_q ? patches_next_codes_q : select_3586) : patches_next_codes_q;
  logic [55:0] select_3590;
  assign select_3590 = equal_2249_s2_q ? patches_next_codes_q : (equal_2251_s2_q ? select_3584 : select_3588);
  // hls/stages/count_bits.hpp:24
  logic parity_3595;
  assign parity_3595 = ^{and_2400_s2_q, and_2397_s2_q, and_2381_s2_q, and_2378};
  // hls/stages/count_bits.hpp:25
  logic or_3599;
  assign or_3599 = ({and_2381_s2_q, and_2378} == 2'h3) | (and_2397_s2_q & (and_2381_s2_q | and_2378));
  logic and_3600;
  assign and_3600 = and_2400_s2_q & (^{and_2397_s2_q, and_2381_s2_q, and_2378});
  // hls/stages/count_bits.hpp:24
  logic xor_3601;
  assign xor_3601 = or_3599 ^ and_3600;
  // hls/stages/count_bits.hpp:27
  logic and_3602;
  assign and_3602 = or_3599 & and_3600;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3604;
  assign select_3604 = or_2255_s2_q ? (and_2423_s2_q ? {and_3602, xor_3601, parity_3595} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3608;
  assign sum_3608 = {7'h0, patches_set_q} + (equal_2254_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3618;
  assign select_3618 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3620;
  assign select_3620 = equal_2249_s2_q ? patches_left_row_q : (equal_2251_s2_q ? select_3618 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3618;
  // hls/stages/count_bits.hpp:24
  logic xor_3624;
  assign xor_3624 = bits[17] ^ (^{select_3618[16:15], other[16:15]});
  logic xor_3627;
  assign xor_3627 = bits[11] ^ (^{select_3618[10:9], other[10:9]});
  logic xor_3630;
  assign xor_3630 = bits[14] ^ (^{select_3618[13:12], other[13:12]});
  logic xor_3633;
  assign xor_3633 = xor_3624 ^ (^{select_3618[14:9], other[14:9]});
  logic xor_3636;
  assign xor_3636 = bits[47] ^ (^{select_3618[46:45], other[46:45]});
  logic xor_3639;
  assign xor_3639 = bits[8] ^ (^{select_3618[7:6], other[7:6]});
  logic xor_3642;
  assign xor_3642 = bits[2] ^ (^{select_3618[1:0], other[1:0]});
  logic xor_3645;
  assign xor_3645 = bits[5] ^ (^{select_3618[4:3], other[4:3]});
  logic xor_3648;
  assign xor_3648 = xor_3639 ^ (^{select_3618[5:0], other[5:0]});
  logic parity_3650;
  assign parity_3650 = ^{select_3618[47:45], select_3618[8:0], other[47:45], other[8:0]};
  logic xor_3651;
  assign xor_3651 = xor_3633 ^ parity_3650;
  logic xor_3654;
  assign xor_3654 = bits[44] ^ (^{select_3618[43:42], other[43:42]});
  logic xor_3657;
  assign xor_3657 = bits[38] ^ (^{select_3618[37:36], other[37:36]});
  logic xor_3660;
  assign xor_3660 = bits[41] ^ (^{select_3618[40:39], other[40:39]});
  logic xor_3666;
  assign xor_3666 = bits[26] ^ (^{select_3618[25:24], other[25:24]});
  logic xor_3669;
  assign xor_3669 = bits[20] ^ (^{select_3618[19:18], other[19:18]});
  logic xor_3672;
  assign xor_3672 = bits[23] ^ (^{select_3618[22:21], other[22:21]});
  logic xor_3675;
  assign xor_3675 = xor_3666 ^ (^{select_3618[23:18], other[23:18]});
  logic xor_3678;
  assign xor_3678 = bits[35] ^ (^{select_3618[34:33], other[34:33]});
  logic xor_3681;
  assign xor_3681 = bits[29] ^ (^{select_3618[28:27], other[28:27]});
  logic xor_3684;
  assign xor_3684 = bits[32] ^ (^{select_3618[31:30], other[31:30]});
  logic xor_3687;
  assign xor_3687 = xor_3678 ^ (^{select_3618[32:27], other[32:27]});
  logic xor_3688;
  assign xor_3688 = xor_3675 ^ xor_3687;
  // hls/stages/count_bits.hpp:25
  logic or_3696;
  assign or_3696 = (xor_3627 & xor_3630) | (xor_3624 & (xor_3627 | xor_3630));
  logic or_3700;
  assign or_3700 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3704;
  assign or_3704 = (xor_3642 & xor_3645) | (xor_3639 & (xor_3642 | xor_3645));
  // hls/stages/count_bits.hpp:23
  logic or_3711;
  assign or_3711 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3715;
  assign or_3715 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3719;
  assign or_3719 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3722;
  assign parity_3722 = ^{or_3719, or_3715, or_3711};
  // hls/stages/count_bits.hpp:23
  logic or_3726;
  assign or_3726 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3730;
  assign or_3730 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3734;
  assign or_3734 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3737;
  assign parity_3737 = ^{or_3734, or_3730, or_3726};
  logic parity_3740;
  assign parity_3740 = ^{or_3734, or_3730, or_3726, or_3719, or_3715, or_3711, or_3704, or_3700, or_3696};
  // hls/stages/count_bits.hpp:23
  logic or_3744;
  assign or_3744 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3748;
  assign or_3748 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3752;
  assign or_3752 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3760;
  assign or_3760 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3764;
  assign or_3764 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3768;
  assign or_3768 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3771;
  assign parity_3771 = ^{or_3768, or_3764, or_3760};
  // hls/stages/count_bits.hpp:23
  logic or_3775;
  assign or_3775 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3779;
  assign or_3779 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3783;
  assign or_3783 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3786;
  assign parity_3786 = ^{or_3783, or_3779, or_3775};
  logic parity_3789;
  assign parity_3789 = ^{or_3783, or_3779, or_3775, or_3768, or_3764, or_3760, or_3752, or_3748, or_3744};
  // hls/stages/count_bits.hpp:25
  logic or_3793;
  assign or_3793 = (xor_3657 & xor_3660) | (xor_3654 & (xor_3657 | xor_3660));
  logic or_3797;
  assign or_3797 = (xor_3669 & xor_3672) | (xor_3666 & (xor_3669 | xor_3672));
  logic or_3801;
  assign or_3801 = (xor_3681 & xor_3684) | (xor_3678 & (xor_3681 | xor_3684));
  // hls/stages/count_bits.hpp:24
  logic parity_3804;
  assign parity_3804 = ^{or_3801, or_3797, or_3793};
  // hls/stages/count_bits.hpp:25
  logic and_3805;
  assign and_3805 = xor_3651 & (^{xor_3688, select_3618[44:36], other[44:36]});
  logic or_3809;
  assign or_3809 = (xor_3636 & xor_3648) | (xor_3633 & (xor_3636 | xor_3648));
  logic and_3812;
  assign and_3812 = (xor_3654 ^ (^{select_3618[41:36], other[41:36]})) & (xor_3675 | xor_3687);
  logic or_3813;
  assign or_3813 = (xor_3675 & xor_3687) | and_3812;
  // hls/stages/count_bits.hpp:24
  logic parity_3816;
  assign parity_3816 = ^{or_3813, or_3809, and_3805};
  logic parity_3819;
  assign parity_3819 = ^{or_3813, or_3809, and_3805, or_3801, or_3797, or_3793, or_3783, or_3779, or_3775, or_3768, or_3764, or_3760, or_3752, or_3748, or_3744};
  logic parity_3821;
  assign parity_3821 = ^{or_3813, or_3809, and_3805, or_3801, or_3797, or_3793, or_3783, or_3779, or_3775, or_3768, or_3764, or_3760, or_3752, or_3748, or_3744, or_3734, or_3730, or_3726, or_3719, or_3715, or_3711, or_3704, or_3700, or_3696};
  // hls/stages/count_bits.hpp:25
  logic and_3822;
  assign and_3822 = parity_3740 & parity_3819;
  logic or_3826;
  assign or_3826 = (parity_3722 & parity_3737) | ((^{or_3704, or_3700, or_3696}) & (parity_3722 | parity_3737));
  logic or_3830;
  assign or_3830 = (parity_3804 & parity_3816) | (parity_3789 & (parity_3804 | parity_3816));
  logic or_3837;
  assign or_3837 = (parity_3771 & parity_3786) | ((^{or_3752, or_3748, or_3744}) & (parity_3771 | parity_3786));
  logic or_3841;
  assign or_3841 = (or_3797 & or_3801) | (or_3793 & (or_3797 | or_3801));
  logic or_3845;
  assign or_3845 = (or_3809 & or_3813) | (and_3805 & (or_3809 | or_3813));
  // hls/stages/count_bits.hpp:23
  logic or_3852;
  assign or_3852 = (or_3748 & or_3752) | (or_3744 & (or_3748 | or_3752));
  // hls/stages/count_bits.hpp:25
  logic or_3856;
  assign or_3856 = (or_3764 & or_3768) | (or_3760 & (or_3764 | or_3768));
  logic or_3860;
  assign or_3860 = (or_3779 & or_3783) | (or_3775 & (or_3779 | or_3783));
  // hls/stages/count_bits.hpp:24
  logic parity_3863;
  assign parity_3863 = ^{or_3860, or_3856, or_3852};
  // hls/stages/count_bits.hpp:23
  logic or_3867;
  assign or_3867 = (or_3700 & or_3704) | (or_3696 & (or_3700 | or_3704));
  // hls/stages/count_bits.hpp:25
  logic or_3871;
  assign or_3871 = (or_3715 & or_3719) | (or_3711 & (or_3715 | or_3719));
  logic or_3875;
  assign or_3875 = (or_3730 & or_3734) | (or_3726 & (or_3730 | or_3734));
  // hls/stages/count_bits.hpp:24
  logic parity_3878;
  assign parity_3878 = ^{or_3875, or_3871, or_3867};
  logic parity_3881;
  assign parity_3881 = ^{or_3875, or_3871, or_3867, or_3860, or_3856, or_3852, or_3845, or_3841, or_3837};
  logic parity_3883;
  assign parity_3883 = ^{or_3875, or_3871, or_3867, or_3860, or_3856, or_3852, or_3845, or_3841, or_3837, or_3830, or_3826, and_3822};
  // hls/stages/count_bits.hpp:25
  logic or_3887;
  assign or_3887 = (or_3841 & or_3845) | (or_3837 & (or_3841 | or_3845));
  logic or_3891;
  assign or_3891 = (or_3856 & or_3860) | (or_3852 & (or_3856 | or_3860));
  logic or_3895;
  assign or_3895 = (or_3871 & or_3875) | (or_3867 & (or_3871 | or_3875));
  // hls/stages/count_bits.hpp:24
  logic parity_3898;
  assign parity_3898 = ^{or_3895, or_3891, or_3887};
  // hls/stages/count_bits.hpp:25
  logic and_3899;
  assign and_3899 = (^{or_3830, or_3826, and_3822}) & parity_3881;
  logic or_3903;
  assign or_3903 = (or_3826 & or_3830) | (and_3822 & (or_3826 | or_3830));
  logic or_3907;
  assign or_3907 = (parity_3863 & parity_3878) | ((^{or_3845, or_3841, or_3837}) & (parity_3863 | parity_3878));
  // hls/stages/count_bits.hpp:24
  logic parity_3910;
  assign parity_3910 = ^{or_3907, or_3903, and_3899};
  // hls/stages/count_bits.hpp:25
  logic and_3912;
  assign and_3912 = parity_3898 & parity_3910;
  logic or_3916;
  assign or_3916 = (or_3891 & or_3895) | (or_3887 & (or_3891 | or_3895));
  logic or_3920;
  assign or_3920 = (or_3903 & or_3907) | (and_3899 & (or_3903 | or_3907));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3965;
  assign select_3965 = equal_2251_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3968;
  assign select_3968 = equal_2249_s2_q ? patches_summed_first_q : (equal_2251_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3976;
  assign select_3976 = less_2429_s2_q ? (or_2432_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3979;
  assign select_3979 = less_2429_s2_q ? (or_2432_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3982;
  assign select_3982 = less_2429_s2_q ? (or_2432_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3987;
  assign select_3987 = equal_2249_s2_q ? (less_2429_s2_q & (or_2432_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3992;
  assign or_3992 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3993;
  assign and_3993 = patches_read_searches_s2_q & or_3992;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3994;
  assign select_3994 = and_3993 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3994};
  // hls/stages/patches.hpp:559
  logic and_3999;
  assign and_3999 = less_2429_s2_q & (or_2432_s2_q & (equal_2430_s2_q & (away == 6'h3f)));
  logic and_4004;
  assign and_4004 = less_2429_s2_q & (or_2432_s2_q & (equal_2430_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_4006;
  assign sum_4006 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4009;
  assign select_4009 = (equal_2430_s2_q & ({sum_4006[6], sum_4006} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_4011;
  assign select_4011 = less_2429_s2_q ? (or_2432_s2_q ? select_4009 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_4013;
  assign select_4013 = and_3993 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4014;
  assign select_4014 = equal_2249_s2_q ? select_4013[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4015;
  assign select_4015 = equal_2249_s2_q ? select_4013[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_4017;
  assign select_4017 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4018;
  assign select_4018 = equal_2249_s2_q ? select_4017 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_4019;
  assign select_4019 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4020;
  assign select_4020 = equal_2249_s2_q ? select_4019 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_4022;
  assign select_4022 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4024;
  assign select_4024 = equal_2249_s2_q ? (patches_read_first_q ? patches_read_far_q : select_4022) : patches_peak_far_q;
  logic [9:0] select_4027;
  assign select_4027 = equal_2249_s2_q ? (equal_4025_s2_q ? sum_3608 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:798
  logic select_4278;
  assign select_4278 = equal_569_s2_q ? shown_shown_q : (drew_q ? select_2493 : shown_shown_q);
  logic select_4280;
  assign select_4280 = equal_569_s2_q ? shown_nearer_q : (drew_q ? select_2496 : shown_nearer_q);
  // hls/stages/agreement.hpp:499
  logic [8:0] select_4283;
  assign select_4283 = equal_677_s2_q ? {{2{difference_4282[6]}}, difference_4282} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_4284;
  assign sum_4284 = select_4283[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_4287;
  assign select_4287 = less_4281_s2_q ? (sum_4284[7] ? region_row_q : next_region_row_q) : (and_3042_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_4289;
  assign select_4289 = and_544_s2_q ? (equal_2939_s2_q ? select_4287 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_4293;
  assign select_4293 = equal_569_s2_q ? select_2443 : (drew_q ? (ends_cell_s2_q ? select_2546 : select_2443) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4306;
  assign select_4306 = equal_2939_s2_q ? (less_4281_s2_q ? region_down_next_q : select_4283) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [6:0] select_4309;
  assign select_4309 = equal_677_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4311;
  assign select_4311 = and_544_s2_q ? (equal_2939_s2_q ? select_4309 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_4312;
  assign sum_4312 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4313;
  assign sum_4313 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4314;
  assign select_4314 = sum_4312[7] ? {1'b1, sum_4312[6:0], region_down_rest_q[0]} : sum_4313;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4284[7];
  // hls/stages/agreement.hpp:465
  logic select_4318;
  assign select_4318 = equal_2939_s2_q ? (less_4281_s2_q ? next : (region_fresh_q | equal_677_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_4323;
  assign or_4323 = segment_starts_q | not_572_s2_q;
  // hls/stages/agreement.hpp:1040
  logic select_4326;
  assign select_4326 = inside_v_s2_q ? (sum_2456_s2_q ? (equal_2242 & or_2458) : or_2458) : or_4323;
  // hls/stages/agreement.hpp:798
  logic select_4329;
  assign select_4329 = equal_569_s2_q ? or_4323 : (drew_q ? (ends_cell_s2_q ? select_4326 : or_4323) : or_4323);
  logic select_4489;
  assign select_4489 = drew_q ? (ends_cell_s2_q ? and_2534 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4492;
  assign select_4492 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4494;
  assign select_4494 = equal_569_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4492 : centres_values_0_of_skin_q);
  logic select_4495;
  assign select_4495 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4497;
  assign select_4497 = equal_569_s2_q ? centres_values_1_textured_q : (drew_q ? select_4495 : centres_values_1_textured_q);
  logic select_4498;
  assign select_4498 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4500;
  assign select_4500 = equal_569_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4498 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4506;
  assign select_4506 = equal_2939_s2_q ? (or_4503_s2_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4509;
  assign select_4509 = and_544_s2_q ? (equal_2939_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/registration.hpp:258
  logic not_4596;
  assign not_4596 = ~quarter[1];
  logic [3:0] select_4597;
  assign select_4597 = quarter[0] ? {quarter[1], 1'b0, not_4596, 1'b0} : {1'b0, quarter[1], 1'b0, not_4596};

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

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1412; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1423; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2517, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2524 & less_2525);
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
      averager_running_of_skin_q <= select_2663;
      averager_mask_q <= select_2665;
      averager_of_skin_q <= select_2667;
      census_filled_q <= and_544_s2_q ? {select_680[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2762;
      moments_turned_1_q <= sum_2764;
      moments_before_0_q <= equal_569_s2_q ? select_2766 : moments_before_0_q;
      moments_before_1_q <= equal_569_s2_q ? select_2768 : moments_before_1_q;
      moments_has_before_q <= select_2771;
      moments_most_before_q <= select_2774;
      moments_left_begins_q <= select_2778;
      moments_left_alone_q <= select_2782;
      moments_left_other_stops_q <= select_2785;
      moments_right_begins_q <= select_2788;
      moments_right_alone_q <= select_2792;
      moments_right_other_stops_q <= select_2795;
      moments_out_of_step_q <= or_2798;
      moments_turns_0_q <= and_2806;
      moments_turns_1_q <= and_2810;
      moments_begins_alone_q <= and_2819;
      moments_ends_q <= equal_569_s2_q & (equal_2765 & (not_2820 | and_2822));
      rows_passed_above_q <= and_544_s2_q ? select_679 : rows_passed_above_q;
      draws_late_q <= select_3044;
      shift_allowed_q <= not_3046 & (~less_3047);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3054 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3179});
      counts_turned_right_q <= and_3054 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3187});
      registration_displacement_over_q <= drew_q ? sum_3211[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3213;
      registration_slope_here_q <= select_3215;
      registration_expected_q <= select_3217;
      registration_of_right_q <= equal_569_s2_q ? registration_of_right_q : select_3279;
      registration_was_inside_q <= equal_569_s2_q ? registration_was_inside_q : select_3282;
      registration_fresh_q <= select_3291;
      patches_chance_q <= and_544_s2_q ? select_3447 : patches_chance_q;
      patches_fixed_q <= and_3462;
      patches_choice_valid_q <= and_2247 ? (select_2220 & not_3449) : select_2220;
      patches_choice_column_q <= select_2225;
      patches_choice_shift_q <= select_2230;
      patches_choice_slope_q <= select_2241;
      patches_band_q <= sample_pair_whole_s2_q ? select_2262 : patches_band_q;
      patches_fetch_q <= select_3476;
      patches_codes_at_q <= select_3577;
      patches_codes_further_q <= equal_2249_s2_q ? patches_codes_further_q : select_3582;
      patches_next_codes_q <= select_3590;
      patches_set_q <= equal_2249_s2_q ? 3'h0 : (equal_2251_s2_q ? 3'h0 : select_3604);
      patches_size_q <= sum_3608;
      patches_left_row_q <= select_3620;
      patches_summed_row_column_q <= equal_2249_s2_q ? patches_summed_row_column_q : select_3965;
      patches_summed_first_q <= select_3968;
      patches_read_row_differing_q <= equal_2249_s2_q ? select_3976 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2249_s2_q ? select_3979 : patches_read_row_column_q;
      patches_read_at_q <= equal_2249_s2_q ? select_3982 : patches_read_at_q;
      patches_read_first_q <= select_3987;
      patches_read_above_q <= equal_2249_s2_q ? and_3999 : patches_read_above_q;
      patches_read_below_q <= equal_2249_s2_q ? and_4004 : patches_read_below_q;
      patches_read_far_q <= equal_2249_s2_q ? select_4011 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4014;
      patches_peak_best_column_q <= select_4015;
      patches_peak_row_q <= equal_2249_s2_q ? select_3994 : patches_peak_row_q;
      patches_peak_above_q <= select_4018;
      patches_peak_below_q <= select_4020;
      patches_peak_far_q <= select_4024;
      patches_peak_size_q <= select_4027;
      patches_frame_ended_q <= equal_569_s2_q & equal_2765;
      shown_shown_q <= select_4278;
      shown_nearer_q <= select_4280;
      region_row_q <= select_4289;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4293;
      region_down_rest_q <= and_544_s2_q ? select_4306 : region_down_rest_q;
      region_down_back_q <= select_4311;
      region_down_next_q <= select_4314;
      region_fresh_q <= and_544_s2_q ? select_4318 : region_fresh_q;
      segment_starts_q <= select_4329;
      centres_values_0_textured_q <= equal_569_s2_q ? centres_values_0_textured_q : select_4489;
      centres_values_0_of_skin_q <= select_4494;
      centres_values_1_textured_q <= select_4497;
      centres_values_1_of_skin_q <= select_4500;
      map_row_q <= and_544_s2_q ? select_4506 : map_row_q;
      map_width_q <= select_4509;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_s2_q) : write_half_q;
      read_half_q <= select_2516;
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
      averager_total_0_q <= select_2641;
      averager_total_1_q <= select_2643;
      census_columns_values_0_cell_0_left_q <= select_2668;
      census_columns_values_0_cell_0_right_q <= select_2669;
      census_columns_values_0_cell_0_mask_q <= and_544_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2671;
      census_columns_values_0_cell_1_right_q <= select_2672;
      census_columns_values_0_cell_1_mask_q <= select_2673;
      census_columns_values_0_cell_2_left_q <= select_2674;
      census_columns_values_0_cell_2_right_q <= select_2675;
      census_columns_values_0_cell_2_mask_q <= select_2676;
      census_columns_values_0_cell_2_of_skin_q <= select_2677;
      census_columns_values_0_cell_3_left_q <= select_2678;
      census_columns_values_0_cell_3_right_q <= select_2679;
      census_columns_values_0_cell_3_mask_q <= select_2680;
      census_columns_values_0_cell_4_left_q <= select_2681;
      census_columns_values_0_cell_4_right_q <= select_2682;
      census_columns_values_0_cell_4_mask_q <= select_2683;
      census_columns_values_1_cell_0_left_q <= select_2684;
      census_columns_values_1_cell_0_right_q <= select_2685;
      census_columns_values_1_cell_0_mask_q <= select_2686;
      census_columns_values_1_cell_1_left_q <= select_2687;
      census_columns_values_1_cell_1_right_q <= select_2688;
      census_columns_values_1_cell_1_mask_q <= select_2689;
      census_columns_values_1_cell_2_left_q <= select_2690;
      census_columns_values_1_cell_2_right_q <= select_2691;
      census_columns_values_1_cell_2_mask_q <= select_2692;
      census_columns_values_1_cell_2_of_skin_q <= select_2693;
      census_columns_values_1_cell_3_left_q <= select_2694;
      census_columns_values_1_cell_3_right_q <= select_2695;
      census_columns_values_1_cell_3_mask_q <= select_2696;
      census_columns_values_1_cell_4_left_q <= select_2697;
      census_columns_values_1_cell_4_right_q <= select_2698;
      census_columns_values_1_cell_4_mask_q <= select_2699;
      census_columns_values_2_cell_0_left_q <= select_2700;
      census_columns_values_2_cell_0_right_q <= select_2701;
      census_columns_values_2_cell_0_mask_q <= select_2702;
      census_columns_values_2_cell_1_left_q <= select_2703;
      census_columns_values_2_cell_1_right_q <= select_2704;
      census_columns_values_2_cell_1_mask_q <= select_2705;
      census_columns_values_2_cell_2_left_q <= select_2706;
      census_columns_values_2_cell_2_right_q <= select_2707;
      census_columns_values_2_cell_2_mask_q <= select_2708;
      census_columns_values_2_cell_3_left_q <= select_2709;
      census_columns_values_2_cell_3_right_q <= select_2710;
      census_columns_values_2_cell_3_mask_q <= select_2711;
      census_columns_values_2_cell_4_left_q <= select_2712;
      census_columns_values_2_cell_4_right_q <= select_2713;
      census_columns_values_2_cell_4_mask_q <= select_2714;
      census_columns_values_3_cell_0_mask_q <= select_2715;
      census_columns_values_3_cell_1_left_q <= select_2716;
      census_columns_values_3_cell_1_right_q <= select_2717;
      census_columns_values_3_cell_1_mask_q <= select_2718;
      census_columns_values_3_cell_2_mask_q <= select_2719;
      census_columns_values_3_cell_3_left_q <= select_2720;
      census_columns_values_3_cell_3_right_q <= select_2721;
      census_columns_values_3_cell_3_mask_q <= select_2722;
      census_columns_values_3_cell_4_mask_q <= select_2723;
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
  logic and_2467_s3_q;
  logic and_2472_s3_q;
  logic and_2483_s3_q;
  logic and_2488_s3_q;
  logic and_2524_s3_q;
  logic less_2525_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2531_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2549_s3_q;
  logic or_2552_s3_q;
  logic or_2555_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2607_s3_q;
  logic [11:0] sum_2739_s3_q;
  logic [9:0] sum_2742_s3_q;
  logic equal_2750_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2868_s3_q;
  logic and_3054_s3_q;
  logic and_3061_s3_q;
  logic not_3082_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3126_s3_q;
  logic and_3161_s3_q;
  logic and_3221_s3_q;
  logic and_3222_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3258_s3_q;
  logic and_3272_s3_q;
  logic equal_3314_s3_q;
  logic parity_3692_s3_q;
  logic parity_3821_s3_q;
  logic parity_3883_s3_q;
  logic xor_3911_s3_q;
  logic parity_3923_s3_q;
  logic or_3927_s3_q;
  logic equal_3928_s3_q;
  logic and_4028_s3_q;
  logic less_4053_s3_q;
  logic equal_4353_s3_q;
  logic and_4517_s3_q;
  logic and_4532_s3_q;
  logic and_4534_s3_q;
  logic not_4546_s3_q;
  logic equal_4599_s3_q;
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
      and_2467_s3_q <= inside_v_s2_q & (and_2465 & not_633_s2_q);
      and_2472_s3_q <= inside_v_s2_q & and_634;
      and_2483_s3_q <= inside_v_s2_q & (not_633_s2_q & (and_2480 & and_2058));
      and_2488_s3_q <= not_570_s2_q & and_2461;
      and_2524_s3_q <= and_2524;
      less_2525_s3_q <= less_2525;
      index_2_s3_q <= index_2[5:0];
      sum_2531_s3_q <= sum_2531;
      textured_2_s3_q <= textured_2;
      or_2549_s3_q <= or_2549;
      or_2552_s3_q <= select_2546[7] | (~({select_2546[6], select_2546[3:2]} == 3'h0));
      or_2555_s3_q <= select_2546[7] | (~(select_2546[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2607_s3_q <= and_2607;
      sum_2739_s3_q <= {1'b0, sum_2735} + {2'h0, sum_2738};
      sum_2742_s3_q <= {9'h0, difference_2740[9]} + {1'b0, xor_2741};
      equal_2750_s3_q <= equal_2750_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2868_s3_q <= x_s2_q[7:3] == 5'h0;
      and_3054_s3_q <= and_3054;
      and_3061_s3_q <= not_570_s2_q & (drew_q & and_3059);
      not_3082_s3_q <= ~((draws_late_q & not_633_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_3126_s3_q <= not_570_s2_q & (drew_q & and_3124);
      and_3161_s3_q <= not_570_s2_q & (drew_q & and_3159);
      and_3221_s3_q <= not_570_s2_q & (drew_q & (half_ends & equal_3218));
      and_3222_s3_q <= and_3222;
      residual_s3_q <= residual[7:0];
      and_3258_s3_q <= and_3258;
      and_3272_s3_q <= and_3222 & less_3271;
      equal_3314_s3_q <= (registration_fresh_q & select_3312) == 4'h0;
      parity_3692_s3_q <= ^{xor_3688, xor_3651, select_3618[44:36], other[44:36]};
      parity_3821_s3_q <= parity_3821;
      parity_3883_s3_q <= parity_3883;
      xor_3911_s3_q <= parity_3898 ^ parity_3910;
      parity_3923_s3_q <= ^{or_3920, or_3916, and_3912};
      or_3927_s3_q <= (or_3916 & or_3920) | (and_3912 & (or_3916 | or_3920));
      equal_3928_s3_q <= equal_3928_s2_q;
      and_4028_s3_q <= equal_2249_s2_q & equal_4025_s2_q;
      less_4053_s3_q <= select_4018 < select_4020;
      equal_4353_s3_q <= equal_4353_s2_q;
      and_4517_s3_q <= said_q;
      and_4532_s3_q <= and_2607 & ({sum_2531, index_2[5:0]} == {sum_2517, index[5:0]});
      and_4534_s3_q <= less_3035 & proven_q;
      not_4546_s3_q <= not_4546_s2_q;
      equal_4599_s3_q <= (registration_fresh_q & select_4597) == 4'h0;
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2468;
  assign select_2468 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2469;
  assign sum_2469 = {6'h0, and_2467_s3_q} + select_2468;
  // hls/stages/agreement.hpp:1072
  logic [9:0] sum_2471;
  assign sum_2471 = {3'h0, sum_2469} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2473;
  assign select_2473 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2474;
  assign sum_2474 = {6'h0, and_2472_s3_q} + select_2473;
  // hls/stages/agreement.hpp:1073
  logic [9:0] sum_2476;
  assign sum_2476 = {3'h0, sum_2474} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2484;
  assign select_2484 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2485;
  assign sum_2485 = {6'h0, and_2483_s3_q} + select_2484;
  // hls/stages/agreement.hpp:1074
  logic [9:0] sum_2487;
  assign sum_2487 = {3'h0, sum_2485} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1105
  logic [2:0] select_2540;
  assign select_2540 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2541;
  assign difference_2541 = {1'b0, textured_2_s3_q} - {1'b0, select_2540};
  logic [4:0] t;
  assign t = {difference_2541[3], difference_2541} + (equal_564_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1111
  logic equal_2544;
  assign equal_2544 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1112
  logic not_2556;
  assign not_2556 = ~region_row_s3_q[2];
  logic [2:0] select_2557;
  assign select_2557 = region_row_s3_q[1] ? {1'b0, not_2556, 1'b0} : {region_row_s3_q[2], 1'b0, not_2556};
  logic [5:0] select_2558;
  assign select_2558 = region_row_s3_q[0] ? {select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0], 1'b0} : {1'b0, select_2557[2], 1'b0, select_2557[1], 1'b0, select_2557[0]};
  logic [11:0] select_2559;
  assign select_2559 = or_2555_s3_q ? {select_2558[5], 1'b0, select_2558[4], 1'b0, select_2558[3], 1'b0, select_2558[2], 1'b0, select_2558[1], 1'b0, select_2558[0], 1'b0} : {1'b0, select_2558[5], 1'b0, select_2558[4], 1'b0, select_2558[3], 1'b0, select_2558[2], 1'b0, select_2558[1], 1'b0, select_2558[0]};
  logic [23:0] select_2560;
  assign select_2560 = or_2552_s3_q ? {select_2559[11], 1'b0, select_2559[10], 1'b0, select_2559[9], 1'b0, select_2559[8], 1'b0, select_2559[7], 1'b0, select_2559[6], 1'b0, select_2559[5], 1'b0, select_2559[4], 1'b0, select_2559[3], 1'b0, select_2559[2], 1'b0, select_2559[1], 1'b0, select_2559[0], 1'b0} : {1'b0, select_2559[11], 1'b0, select_2559[10], 1'b0, select_2559[9], 1'b0, select_2559[8], 1'b0, select_2559[7], 1'b0, select_2559[6], 1'b0, select_2559[5], 1'b0, select_2559[4], 1'b0, select_2559[3], 1'b0, select_2559[2], 1'b0, select_2559[1], 1'b0, select_2559[0]};
  logic [47:0] select_2561;
  assign select_2561 = or_2549_s3_q ? {select_2560[23], 1'b0, select_2560[22], 1'b0, select_2560[21], 1'b0, select_2560[20], 1'b0, select_2560[19], 1'b0, select_2560[18], 1'b0, select_2560[17], 1'b0, select_2560[16], 1'b0, select_2560[15], 1'b0, select_2560[14], 1'b0, select_2560[13], 1'b0, select_2560[12], 1'b0, select_2560[11], 1'b0, select_2560[10], 1'b0, select_2560[9], 1'b0, select_2560[8], 1'b0, select_2560[7], 1'b0, select_2560[6], 1'b0, select_2560[5], 1'b0, select_2560[4], 1'b0, select_2560[3], 1'b0, select_2560[2], 1'b0, select_2560[1], 1'b0, select_2560[0], 1'b0} : {1'b0, select_2560[23], 1'b0, select_2560[22], 1'b0, select_2560[21], 1'b0, select_2560[20], 1'b0, select_2560[19], 1'b0, select_2560[18], 1'b0, select_2560[17], 1'b0, select_2560[16], 1'b0, select_2560[15], 1'b0, select_2560[14], 1'b0, select_2560[13], 1'b0, select_2560[12], 1'b0, select_2560[11], 1'b0, select_2560[10], 1'b0, select_2560[9], 1'b0, select_2560[8], 1'b0, select_2560[7], 1'b0, select_2560[6], 1'b0, select_2560[5], 1'b0, select_2560[4], 1'b0, select_2560[3], 1'b0, select_2560[2], 1'b0, select_2560[1], 1'b0, select_2560[0]};
  // hls/stages/agreement.hpp:1040
  logic and_2565;
  assign and_2565 = good_known_q & (~((good_q & select_2561) == 48'h0));
  // hls/stages/agreement.hpp:1107
  logic [2:0] select_2574;
  assign select_2574 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2575;
  assign difference_2575 = {1'b0, shown_2_s3_q} - {1'b0, select_2574};
  logic [4:0] around;
  assign around = {difference_2575[3], difference_2575} + (equal_564_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1114
  logic [5:0] sum_2578;
  assign sum_2578 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2544 ? and_2565 : (~({sum_2578, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2590;
  assign select_2590 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2591;
  assign difference_2591 = {1'b0, near_2_s3_q} - {1'b0, select_2590};
  logic [4:0] n;
  assign n = {difference_2591[3], difference_2591} + (equal_564_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1124
  logic and_2595;
  assign and_2595 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2633;
  assign select_2633 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2635;
  assign select_2635 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2637;
  assign select_2637 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2639;
  assign select_2639 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2644;
  assign sum_2644 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2645;
  assign difference_2645 = {1'b0, sum_2644[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2646;
  assign xor_2646 = {difference_2645[8:0], sum_2644[0]} ^ {10{difference_2645[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2645[9]} + {1'b0, xor_2646};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_547_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2651;
  assign select_2651 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2652;
  assign sum_2652 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2653;
  assign difference_2653 = {1'b0, sum_2652[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2654;
  assign xor_2654 = {difference_2653[8:0], sum_2652[0]} ^ {10{difference_2653[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2653[9]} + {1'b0, xor_2654};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_547_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2659;
  assign select_2659 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2743;
  assign sum_2743 = sum_2739_s3_q + {2'h0, sum_2742_s3_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2745;
  assign select_2745 = and_544_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2746;
  assign select_2746 = and_544_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2747;
  assign select_2747 = and_544_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2748;
  assign select_2748 = and_544_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2751;
  assign sum_2751 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2743};
  logic [13:0] sum_2753;
  assign sum_2753 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2751});
  // hls/stages/census.hpp:323
  logic and_2755;
  assign and_2755 = and_706_s3_q & (9'h4 < sum_2753[13:5]);
  // hls/stages/census.hpp:324
  logic and_2756;
  assign and_2756 = and_706_s3_q & less_730;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2757;
  assign sum_2757 = census_left_misses_q + {{17{and_2756}}, and_2755, 1'b0, and_2755};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2759;
  assign select_2759 = and_544_s3_q ? (equal_2750_s3_q ? 20'h0 : sum_2757) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2829;
  assign select_2829 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:530
  logic select_2832;
  assign select_2832 = and_544_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2835;
  assign and_2835 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2841;
  assign and_2841 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2842;
  assign and_2842 = and_2835 & and_2841;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2829[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2844;
  assign select_2844 = and_2842 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2846;
  assign select_2846 = equal_2750_s3_q ? {11'h0, select_2844} : (sharpness_sums_detail_0_q + {11'h0, select_2844});
  // hls/stages/agreement.hpp:462
  logic and_2853;
  assign and_2853 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2854;
  assign and_2854 = and_2835 & and_2853;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2829[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2856;
  assign select_2856 = and_2854 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2858;
  assign select_2858 = equal_2750_s3_q ? {11'h0, select_2856} : (sharpness_sums_detail_1_q + {11'h0, select_2856});
  logic [8:0] select_2861;
  assign select_2861 = and_2842 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2862;
  assign sum_2862 = (equal_2750_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2861};
  logic [8:0] select_2865;
  assign select_2865 = and_2854 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2866;
  assign sum_2866 = (equal_2750_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2865};
  // hls/stages/census.hpp:388
  logic less_2869;
  assign less_2869 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2870;
  assign less_2870 = x_s3_q[4:0] < 5'h3;
  logic not_2871;
  assign not_2871 = ~x_s3_q[1];
  logic [2:0] select_2872;
  assign select_2872 = x_s3_q[0] ? {1'b0, not_2871, 1'b0} : {x_s3_q[1], 1'b0, not_2871};
  logic [5:0] select_2873;
  assign select_2873 = slot_s3_q[2] ? {select_2872[2], 1'b0, select_2872[1], 1'b0, select_2872[0], 1'b0} : {1'b0, select_2872[2], 1'b0, select_2872[1], 1'b0, select_2872[0]};
  logic [11:0] select_2874;
  assign select_2874 = slot_s3_q[1] ? {select_2873[5], 1'b0, select_2873[4], 1'b0, select_2873[3], 1'b0, select_2873[2], 1'b0, select_2873[1], 1'b0, select_2873[0], 1'b0} : {1'b0, select_2873[5], 1'b0, select_2873[4], 1'b0, select_2873[3], 1'b0, select_2873[2], 1'b0, select_2873[1], 1'b0, select_2873[0]};
  logic [23:0] select_2875;
  assign select_2875 = slot_s3_q[0] ? {select_2874[11], 1'b0, select_2874[10], 1'b0, select_2874[9], 1'b0, select_2874[8], 1'b0, select_2874[7], 1'b0, select_2874[6], 1'b0, select_2874[5], 1'b0, select_2874[4], 1'b0, select_2874[3], 1'b0, select_2874[2], 1'b0, select_2874[1], 1'b0, select_2874[0], 1'b0} : {1'b0, select_2874[11], 1'b0, select_2874[10], 1'b0, select_2874[9], 1'b0, select_2874[8], 1'b0, select_2874[7], 1'b0, select_2874[6], 1'b0, select_2874[5], 1'b0, select_2874[4], 1'b0, select_2874[3], 1'b0, select_2874[2], 1'b0, select_2874[1], 1'b0, select_2874[0]};
  // hls/stages/census.hpp:390
  logic and_2879;
  assign and_2879 = less_2870 & (~((sharpness_sums_contrast_1_q & select_2875) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2881;
  assign select_2881 = (less_2869 & and_2879) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2881};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2884;
  assign select_2884 = equal_2868_s3_q ? (less_2869 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2889;
  assign and_2889 = less_2870 & (~((sharpness_sums_contrast_0_q & select_2875) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2891;
  assign select_2891 = (less_2869 & and_2889) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2891};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2894;
  assign select_2894 = equal_2868_s3_q ? (less_2869 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2896;
  assign select_2896 = equal_2868_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2898;
  assign select_2898 = equal_2868_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2900;
  assign select_2900 = equal_2868_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2889} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2902;
  assign select_2902 = equal_2868_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2879} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2907;
  assign select_2907 = so_s3_q ? (equal_2868_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2910;
  assign select_2910 = equal_2868_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2912;
  assign equal_2912 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2913;
  assign xor_2913 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2916;
  assign select_2916 = (equal_2912 | xor_2913) ? (five_times[0] & xor_2913) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2917;
  assign select_2917 = equal_2868_s3_q ? select_2916 : sharpness_comparing_less_detail_0_q;
  logic select_2918;
  assign select_2918 = so_s3_q ? select_2917 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2919;
  assign xor_2919 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2922;
  assign select_2922 = (equal_2912 | xor_2919) ? (five_times_2[0] & xor_2919) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2923;
  assign select_2923 = equal_2868_s3_q ? select_2922 : sharpness_comparing_less_detail_1_q;
  logic select_2924;
  assign select_2924 = so_s3_q ? select_2923 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2925;
  assign xor_2925 = sharpness_comparing_contrast_0_q[1] ^ and_2879;
  logic select_2928;
  assign select_2928 = (equal_2912 | xor_2925) ? (and_2879 & xor_2925) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2929;
  assign select_2929 = equal_2868_s3_q ? select_2928 : sharpness_comparing_less_contrast_0_q;
  logic select_2930;
  assign select_2930 = so_s3_q ? select_2929 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2931;
  assign xor_2931 = sharpness_comparing_contrast_1_q[1] ^ and_2889;
  logic select_2934;
  assign select_2934 = (equal_2912 | xor_2931) ? (and_2889 & xor_2931) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2935;
  assign select_2935 = equal_2868_s3_q ? select_2934 : sharpness_comparing_less_contrast_1_q;
  logic select_2936;
  assign select_2936 = so_s3_q ? select_2935 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3063;
  assign select_3063 = and_3054_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3061_s3_q});
  // hls/stages/agreement.hpp:798
  logic and_3066;
  assign and_3066 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2467_s3_q));
  logic and_3071;
  assign and_3071 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2472_s3_q));
  logic and_3076;
  assign and_3076 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2483_s3_q));
  // hls/stages/agreement.hpp:1106
  logic [2:0] select_3091;
  assign select_3091 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3092;
  assign difference_3092 = {1'b0, explained_2_s3_q} - {1'b0, select_3091};
  logic [4:0] e;
  assign e = {difference_3092[3], difference_3092} + (equal_564_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic [5:0] sum_3095;
  assign sum_3095 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1118
  logic not_3099;
  assign not_3099 = ~(equal_2544 ? and_2565 : (~({sum_3095, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:798
  logic and_3102;
  assign and_3102 = ends_cell_s3_q & (not_3082_s3_q & (centres_values_1_textured_s3_q & not_3099));
  logic and_3104;
  assign and_3104 = not_570_s3_q & (so_s3_q & and_3102);
  // hls/stages/agreement.hpp:1144
  logic less_3107;
  assign less_3107 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3108;
  assign select_3108 = less_3107 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3111;
  assign select_3111 = less_3107 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1145
  logic [10:0] sum_3112;
  assign sum_3112 = {1'b0, select_3111} + {3'h0, select_3111[9:2]};
  logic and_3114;
  assign and_3114 = (~(select_3108[9:4] == 6'h0)) & ({sum_3112, select_3111[1:0]} < {3'h0, select_3108});
  // hls/stages/agreement.hpp:1154
  logic [9:0] select_3117;
  assign select_3117 = x_s3_q[6] ? (equal_2080_s3_q ? 10'h0 : (and_3114 ? select_3108 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_3118;
  assign select_3118 = equal_569_s3_q ? select_3117 : 10'h0;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3120;
  assign select_3120 = and_3054_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3118});
  logic [13:0] select_3128;
  assign select_3128 = and_3054_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3126_s3_q});
  // hls/stages/agreement.hpp:1122
  logic and_3130;
  assign and_3130 = not_3082_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:798
  logic and_3133;
  assign and_3133 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_3130));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3135;
  assign select_3135 = and_3054_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3133});
  // hls/stages/agreement.hpp:1122
  logic and_3137;
  assign and_3137 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3099);
  // hls/stages/agreement.hpp:798
  logic and_3141;
  assign and_3141 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & (not_3082_s3_q & and_3137)));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3143;
  assign select_3143 = and_3054_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3141});
  logic [13:0] select_3163;
  assign select_3163 = and_3054_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3161_s3_q});
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3240;
  assign select_3240 = so_s3_q ? (equal_2173_s3_q ? (and_3222_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3241;
  assign select_3241 = equal_569_s3_q ? 8'h0 : select_3240;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3243;
  assign select_3243 = and_3221_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3241[7]}}, select_3241});
  // hls/stages/agreement.hpp:798
  logic and_3246;
  assign and_3246 = not_570_s3_q & (so_s3_q & (and_3222_s3_q & equal_2173_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3248;
  assign select_3248 = and_3221_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3246});
  // hls/stages/registration.hpp:107
  logic and_3250;
  assign and_3250 = and_3222_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3252;
  assign select_3252 = so_s3_q ? (equal_2173_s3_q ? {and_3250, and_3222_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3253;
  assign select_3253 = equal_569_s3_q ? 2'h0 : select_3252;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3254;
  assign sum_3254 = registration_half_votes_down_q + {{5{select_3253[1]}}, select_3253};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3260;
  assign select_3260 = so_s3_q ? (equal_2173_s3_q ? {and_3258_s3_q, and_3222_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3261;
  assign select_3261 = equal_569_s3_q ? 2'h0 : select_3260;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3262;
  assign sum_3262 = registration_half_votes_up_q + {{5{select_3261[1]}}, select_3261};
  // hls/stages/registration.hpp:107
  logic and_3265;
  assign and_3265 = and_3222_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3267;
  assign select_3267 = so_s3_q ? (equal_2173_s3_q ? {and_3265, and_3222_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3268;
  assign select_3268 = equal_569_s3_q ? 2'h0 : select_3267;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3269;
  assign sum_3269 = registration_half_half_votes_down_q + {{5{select_3268[1]}}, select_3268};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3274;
  assign select_3274 = so_s3_q ? (equal_2173_s3_q ? {and_3272_s3_q, and_3222_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3275;
  assign select_3275 = equal_569_s3_q ? 2'h0 : select_3274;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3276;
  assign sum_3276 = registration_half_half_votes_up_q + {{5{select_3275[1]}}, select_3275};
  // hls/stages/agreement.hpp:798
  logic and_3309;
  assign and_3309 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & less_2111_s3_q));
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3316;
  assign select_3316 = or_2115_s3_q ? 12'h0 : (equal_3314_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_3319;
  assign select_3319 = x_s3_q[6] ? (equal_2080_s3_q ? 12'h0 : (less_2111_s3_q ? select_3316 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_3320;
  assign select_3320 = equal_569_s3_q ? select_3319 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3321;
  assign and_3321 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1154
  logic and_3324;
  assign and_3324 = not_2454_s3_q & (less_2111_s3_q & ({and_3321, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:798
  logic and_3326;
  assign and_3326 = equal_569_s3_q & (x_s3_q[6] & and_3324);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3328;
  assign sum_3328 = {{2{select_3320[11]}}, select_3320} + (and_3326 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3331;
  assign select_3331 = or_2115_s3_q ? 12'h0 : (equal_3314_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_3334;
  assign select_3334 = x_s3_q[6] ? (equal_2080_s3_q ? 12'h0 : (less_2111_s3_q ? select_3331 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_3335;
  assign select_3335 = equal_569_s3_q ? select_3334 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3337;
  assign sum_3337 = {{2{select_3335[11]}}, select_3335} + (and_3326 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3339;
  assign not_3339 = ~all_s3_q;
  // hls/stages/agreement.hpp:1154
  logic and_3342;
  assign and_3342 = not_2454_s3_q & (less_2111_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3339, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_3348;
  assign and_3348 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3349;
  assign not_3349 = ~and_3348;
  logic less_3350;
  assign less_3350 = $signed({9'h1, {2{not_3349}}, and_3348}) < $signed(registration_up_q[13:2]);
  logic select_3351;
  assign select_3351 = (equal_569_s3_q & (x_s3_q[6] & and_3342)) ? less_3350 : registration_enough_q;
  // hls/stages/agreement.hpp:1154
  logic and_3355;
  assign and_3355 = x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_3356;
  assign and_3356 = equal_569_s3_q & and_3355;
  // hls/stages/registration.hpp:242
  logic less_3357;
  assign less_3357 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3359;
  assign less_3359 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3361;
  assign equal_3361 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_3365;
  assign and_3365 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & equal_3361)));
  // hls/stages/agreement.hpp:1154
  logic and_3372;
  assign and_3372 = x_s3_q[6] & (not_2454_s3_q & (less_2111_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3375;
  assign equal_3375 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1154
  logic and_3378;
  assign and_3378 = not_2454_s3_q & (less_2111_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3375));
  // hls/stages/registration.hpp:244
  logic and_3382;
  assign and_3382 = (equal_569_s3_q & (x_s3_q[6] & and_3378)) & (less_3359 | less_3357);
  // hls/stages/agreement.hpp:1154
  logic and_3387;
  assign and_3387 = not_2454_s3_q & (less_2111_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3375)));
  // hls/stages/registration.hpp:244
  logic and_3390;
  assign and_3390 = registration_votes_up_q & registration_other_down_q;
  logic select_3392;
  assign select_3392 = registration_votes_down_q ? (registration_other_up_q | and_3390) : and_3390;
  // hls/stages/registration.hpp:138
  logic and_3394;
  assign and_3394 = (equal_569_s3_q & (x_s3_q[6] & and_3387)) & (registration_other_enough_q & select_3392);
  // hls/stages/registration.hpp:245
  logic or_3397;
  assign or_3397 = registration_moved_q | (registration_enough_q & (and_3382 | and_3394));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3481;
  assign select_3481 = sample_pair_whole_s3_q ? (equal_2163_s3_q ? patches_place_0_slope_q : select_2269[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3486;
  assign select_3486 = sample_pair_whole_s3_q ? (equal_2163_s3_q ? patches_place_1_slope_q : select_2297[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3488;
  assign select_3488 = equal_2163_s3_q ? patches_valid_0_q : (select_2162_s3_q ? patches_valid_0_q : select_2265[0]);
  // hls/stages/agreement.hpp:277
  logic select_3491;
  assign select_3491 = sample_pair_whole_s3_q ? (and_2288 ? (sample_present_s3_q & select_3488) : select_3488) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3493;
  assign select_3493 = equal_2163_s3_q ? patches_valid_1_q : (select_2162_s3_q ? select_2265[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3496;
  assign select_3496 = sample_pair_whole_s3_q ? (and_2307 ? (sample_present_s3_q & select_3493) : select_3493) : patches_valid_1_q;
  logic [5:0] select_3499;
  assign select_3499 = sample_pair_whole_s3_q ? (select_2286[5] ? {1'b1, select_2286[4:0]} : (select_2286 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3502;
  assign select_3502 = sample_pair_whole_s3_q ? (select_2305[5] ? {1'b1, select_2305[4:0]} : (select_2305 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3505;
  assign select_3505 = sample_pair_whole_s3_q ? (select_2318[4] ? {1'b1, select_2318[3:0]} : (select_2318 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3508;
  assign select_3508 = sample_pair_whole_s3_q ? (select_2323[4] ? {1'b1, select_2323[3:0]} : (select_2323 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3927_s3_q, parity_3923_s3_q, xor_3911_s3_q, parity_3883_s3_q, parity_3821_s3_q, parity_3692_s3_q} + (equal_3928_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3932;
  assign select_3932 = equal_2249_s3_q ? patches_sums_values_0_q : (equal_2251_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3933;
  assign select_3933 = equal_2251_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3935;
  assign select_3935 = equal_2251_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3937;
  assign select_3937 = equal_2251_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3939;
  assign select_3939 = equal_2251_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3941;
  assign select_3941 = equal_2251_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3943;
  assign select_3943 = equal_2251_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3945;
  assign select_3945 = equal_2251_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3947;
  assign select_3947 = equal_2251_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3949;
  assign select_3949 = equal_2251_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3951;
  assign select_3951 = equal_2251_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3953;
  assign select_3953 = equal_2251_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3955;
  assign select_3955 = equal_2251_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3957;
  assign select_3957 = equal_2251_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3959;
  assign select_3959 = equal_2251_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3961;
  assign select_3961 = equal_2251_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3963;
  assign select_3963 = equal_2251_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_4034;
  assign difference_4034 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_4037;
  assign and_4037 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_4034, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_4040;
  assign not_4040 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_4043;
  assign and_4043 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_4037 & ((10'h38 < patches_peak_size_q) & not_4040));
  // hls/stages/patches.hpp:190
  logic and_4045;
  assign and_4045 = and_4028_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_4043);
  // hls/stages/patches.hpp:667
  logic not_4046;
  assign not_4046 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_4048;
  assign and_4048 = and_4045 & (not_2256_s3_q & not_4046);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4050;
  assign sum_4050 = {7'h0, and_4048} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4054;
  assign sum_4054 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4053_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_4061;
  assign not_4061 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4062;
  assign sum_4062 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4064;
  assign not_4064 = ~({eight, 3'h0} < {1'b0, sum_4062, fall_2[0]});
  logic [1:0] sum_4065;
  assign sum_4065 = {1'b0, not_4061} + {1'b0, not_4064};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4066;
  assign sum_4066 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4068;
  assign not_4068 = ~({eight, 3'h0} < {sum_4066, fall_2[1:0]});
  logic not_4071;
  assign not_4071 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4072;
  assign sum_4072 = {1'b0, not_4068} + {1'b0, not_4071};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4065} + {1'b0, sum_4072};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4075;
  assign select_4075 = less_4053_s3_q ? ({sum_4054, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_4054, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_4076;
  assign select_4076 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_4077;
  assign select_4077 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4078;
  assign sum_4078 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_4079;
  assign sum_4079 = {select_4077[5], select_4077} + {{3{sum_4078[3]}}, sum_4078};
  // hls/stages/patches.hpp:604
  logic [17:0] product_4080;
  assign product_4080 = $signed({{10{select_4076[7]}}, select_4076}) * $signed({{8{sum_4079[6]}}, sum_4079, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_4081;
  assign difference_4081 = {{6{select_4075[7]}}, select_4075} - {product_4080[17], product_4080[17:5]};
  // hls/stages/patches.hpp:611
  logic less_4082;
  assign less_4082 = $signed({{7{difference_4052[6]}}, difference_4052}) < $signed(difference_4081);
  // hls/stages/patches.hpp:189
  logic not_4083;
  assign not_4083 = ~less_4082;
  // hls/stages/patches.hpp:670
  logic and_4084;
  assign and_4084 = not_4083 & and_4048;
  logic [7:0] sum_4085;
  assign sum_4085 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4084};
  // hls/stages/patches.hpp:189
  logic not_4088;
  assign not_4088 = ~($signed(difference_4081) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_4089;
  assign and_4089 = not_4088 & and_4048;
  logic [7:0] sum_4090;
  assign sum_4090 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4089};
  // hls/stages/patches.hpp:192
  logic and_4092;
  assign and_4092 = and_4045 & (patches_second_s3_q & not_4046);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4094;
  assign sum_4094 = {7'h0, and_4092} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_4096;
  assign and_4096 = not_4083 & and_4092;
  logic [7:0] sum_4097;
  assign sum_4097 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4096};
  // hls/stages/patches.hpp:671
  logic and_4099;
  assign and_4099 = not_4088 & and_4092;
  logic [7:0] sum_4100;
  assign sum_4100 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4099};
  // hls/stages/patches.hpp:192
  logic and_4102;
  assign and_4102 = and_4045 & (patches_lower_s3_q & not_2256_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4104;
  assign sum_4104 = {7'h0, and_4102} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_4106;
  assign and_4106 = not_4083 & and_4102;
  logic [7:0] sum_4107;
  assign sum_4107 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4106};
  // hls/stages/patches.hpp:671
  logic and_4109;
  assign and_4109 = not_4088 & and_4102;
  logic [7:0] sum_4110;
  assign sum_4110 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4109};
  // hls/stages/patches.hpp:192
  logic and_4112;
  assign and_4112 = and_4045 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4114;
  assign sum_4114 = {7'h0, and_4112} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_4116;
  assign and_4116 = not_4083 & and_4112;
  logic [7:0] sum_4117;
  assign sum_4117 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4116};
  // hls/stages/patches.hpp:671
  logic and_4119;
  assign and_4119 = not_4088 & and_4112;
  logic [7:0] sum_4120;
  assign sum_4120 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4119};
  // hls/stages/agreement.hpp:1235
  logic equal_4121;
  assign equal_4121 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1142
  logic less_4122;
  assign less_4122 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_4126;
  assign and_4126 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (equal_4121 & less_4122)));
  // hls/stages/agreement.hpp:1154
  logic and_4131;
  assign and_4131 = x_s3_q[6] & (not_2454_s3_q & (less_4122 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:798
  logic and_4132;
  assign and_4132 = equal_569_s3_q & and_4131;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4134;
  assign or_4134 = (and_4126 ? patches_quarters_0_places_q : 8'h0) | (and_4132 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1154
  logic and_4138;
  assign and_4138 = x_s3_q[6] & (not_2454_s3_q & (less_4122 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:798
  logic and_4139;
  assign and_4139 = equal_569_s3_q & and_4138;
  // hls/stages/agreement.hpp:1154
  logic and_4145;
  assign and_4145 = x_s3_q[6] & (not_2454_s3_q & (less_4122 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:798
  logic and_4146;
  assign and_4146 = equal_569_s3_q & and_4145;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4148;
  assign or_4148 = (or_4134 | (and_4139 ? patches_quarters_2_places_q : 8'h0)) | (and_4146 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_4152;
  assign select_4152 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:798
  logic and_4156;
  assign and_4156 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (less_4122 & select_4152)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_4158;
  assign select_4158 = and_4126 ? (and_4156 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4160;
  assign select_4160 = and_4132 ? (and_4156 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4163;
  assign select_4163 = and_4139 ? (and_4156 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4166;
  assign select_4166 = and_4146 ? (and_4156 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_4169;
  assign select_4169 = and_4126 ? (and_4156 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4171;
  assign select_4171 = and_4132 ? (and_4156 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4174;
  assign select_4174 = and_4139 ? (and_4156 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4177;
  assign select_4177 = and_4146 ? (and_4156 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_4179;
  assign sum_4179 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1154
  logic and_4183;
  assign and_4183 = x_s3_q[6] & (not_2454_s3_q & (less_4122 & (sum_4179[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_4184;
  assign and_4184 = equal_569_s3_q & and_4183;
  // hls/stages/patches.hpp:630
  logic [7:0] select_4187;
  assign select_4187 = and_4184 ? (patches_word_places_q + (and_4132 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4190;
  assign select_4190 = and_4184 ? (patches_word_up_q + (and_4132 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4193;
  assign select_4193 = and_4184 ? (patches_word_down_q + (and_4132 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_4196;
  assign select_4196 = ($signed(difference_4081[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4081[5:0];
  logic [5:0] select_4197;
  assign select_4197 = ($signed(14'h10) < $signed(difference_4081)) ? 6'h10 : select_4196;
  // hls/stages/patches.hpp:673
  logic [5:0] select_4198;
  assign select_4198 = and_4045 ? select_4197 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_4200;
  assign select_4200 = patches_round_ends_q ? {{6{select_4198[5]}}, select_4198} : (patches_across_q + {{6{select_4198[5]}}, select_4198});
  // hls/stages/agreement.hpp:798
  logic and_4204;
  assign and_4204 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q & (equal_3361 & less_4122)));
  // hls/stages/agreement.hpp:1154
  logic and_4208;
  assign and_4208 = x_s3_q[6] & (not_2454_s3_q & (less_4122 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_4209;
  assign and_4209 = equal_569_s3_q & and_4208;
  // hls/stages/patches.hpp:657
  logic [7:0] select_4211;
  assign select_4211 = and_4204 ? (and_4209 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_4215;
  assign or_4215 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_4218;
  assign or_4218 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_4219;
  assign sum_4219 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_4221;
  assign select_4221 = and_4204 ? (and_4209 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_4224;
  assign and_4224 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_4226;
  assign select_4226 = and_4209 ? {and_4224, patches_found_q[2:1]} : (and_4204 ? {and_4224, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_4230;
  assign or_4230 = patches_partly_q | (patches_doubted_q & (~and_4209));
  // hls/stages/patches.hpp:656
  logic select_4233;
  assign select_4233 = and_4204 ? (and_4209 ? or_4230 : (and_4204 ? or_4230 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_4234;
  assign select_4234 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4238;
  assign select_4238 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_4240;
  assign sum_4240 = {sum_4079[6], sum_4079, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_4242;
  assign and_4242 = ({{5{sum_4240[10]}}, sum_4240} < 16'h3) & and_4045;
  logic [7:0] sum_4243;
  assign sum_4243 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4242};
  // hls/stages/patches.hpp:663
  logic [12:0] product_4248;
  assign product_4248 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_4211};
  // hls/stages/patches.hpp:192
  logic and_4250;
  assign and_4250 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4248[12:5] < patches_on_skin_q);
  logic select_4255;
  assign select_4255 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_4259;
  assign or_4259 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_4266;
  assign select_4266 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_4272;
  assign and_4272 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4273;
  assign sum_4273 = patches_age_q + {9'h0, and_4272};
  logic [9:0] select_4276;
  assign select_4276 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4273)) : sum_4273;
  // hls/stages/agreement.hpp:1200
  logic or_4334;
  assign or_4334 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1229
  logic equal_4336;
  assign equal_4336 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1238
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1239
  logic select_4342;
  assign select_4342 = (equal_4336 & equal_4121) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1147
  logic [10:0] sum_4345;
  assign sum_4345 = {1'b0, select_3111} + {2'h0, select_3111[9:1]};
  logic select_4348;
  assign select_4348 = (select_3108[9:3] == 7'h0) ? ((~or_4334) & (~select_4342)) : (~({sum_4345, select_3111[0]} < {2'h0, select_3108}));
  // hls/stages/agreement.hpp:1154
  logic [47:0] select_4350;
  assign select_4350 = x_s3_q[6] ? (equal_2080_s3_q ? good_q : {select_4348, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic select_4355;
  assign select_4355 = equal_569_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4353_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1229
  logic equal_4356;
  assign equal_4356 = x_s3_q[6:3] == 4'ha;
  logic equal_4358;
  assign equal_4358 = x_s3_q[6:3] == 4'hc;
  logic equal_4359;
  assign equal_4359 = x_s3_q[6:3] == 4'hb;
  logic equal_4360;
  assign equal_4360 = x_s3_q[6:3] == 4'h9;
  logic equal_4361;
  assign equal_4361 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_4363;
  assign select_4363 = equal_4360 ? counts_skin_unproven_q : (equal_4361 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4365;
  assign select_4365 = equal_4359 ? counts_regions_bad_q : (equal_4356 ? counts_nearer_q : select_4363);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4358 ? counts_on_skin_q : select_4365;
  // hls/stages/agreement.hpp:1234
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1242
  logic select_4368;
  assign select_4368 = (equal_4356 & equal_4121) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1160
  logic not_4369;
  assign not_4369 = ~hidden_for_q[7];
  logic [7:0] select_4371;
  assign select_4371 = select_4368 ? (hidden_for_q + {7'h0, not_4369}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_4373;
  assign select_4373 = equal_569_s3_q ? (equal_4353_s3_q ? select_4371 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1243
  logic [13:0] select_4374;
  assign select_4374 = equal_4121 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1137
  logic [7:0] select_4376;
  assign select_4376 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4378;
  assign select_4378 = equal_4361 ? cfg_unproven_skin_limit_i : (equal_4336 ? cfg_unproven_limit_i : select_4376);
  logic [7:0] select_4380;
  assign select_4380 = equal_4356 ? cfg_regions_limit_i : (equal_4360 ? cfg_hidden_limit_i : select_4378);
  logic [7:0] limit;
  assign limit = equal_4358 ? cfg_regions_limit_i : (equal_4359 ? {cfg_on_skin_limit_i, 3'h0} : select_4380);
  // hls/stages/agreement.hpp:1243
  logic not_4383;
  assign not_4383 = ~x_s3_q[2];
  logic [3:0] select_4384;
  assign select_4384 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4383, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4383};
  logic [7:0] select_4385;
  assign select_4385 = x_s3_q[0] ? {select_4384[3], 1'b0, select_4384[2], 1'b0, select_4384[1], 1'b0, select_4384[0], 1'b0} : {1'b0, select_4384[3], 1'b0, select_4384[2], 1'b0, select_4384[1], 1'b0, select_4384[0]};
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_4389;
  assign select_4389 = equal_4360 ? counts_skin_supervised_q : (equal_4361 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4391;
  assign select_4391 = equal_4359 ? counts_skin_textured_q : (equal_4356 ? counts_textured_q : select_4389);
  logic [13:0] of;
  assign of = equal_4358 ? counts_textured_q : select_4391;
  // hls/stages/agreement.hpp:1243
  logic [13:0] select_4393;
  assign select_4393 = ((limit & select_4385) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4374} + {1'b0, select_4393};
  // hls/stages/agreement.hpp:798
  logic select_4398;
  assign select_4398 = equal_569_s3_q ? (equal_4121 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1240
  logic and_4403;
  assign and_4403 = too_much_q & (~(equal_4361 & equal_4121));
  // hls/stages/agreement.hpp:1241
  logic select_4408;
  assign select_4408 = (over[14] & equal_4121) ? (and_4403 | ((equal_4361 | equal_4360) | (x_s3_q[6:3] == 4'hf))) : and_4403;
  // hls/stages/agreement.hpp:1137
  logic and_4413;
  assign and_4413 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1243
  logic select_4414;
  assign select_4414 = (equal_4358 & equal_4121) ? and_4413 : overlooks_q;
  // hls/stages/agreement.hpp:798
  logic [2:0] select_4416;
  assign select_4416 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4418;
  assign select_4418 = equal_569_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_4416 : box_textured_columns_values_0_q);
  logic [2:0] select_4419;
  assign select_4419 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4421;
  assign select_4421 = equal_569_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4419 : box_textured_columns_values_1_q);
  logic [2:0] select_4422;
  assign select_4422 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4424;
  assign select_4424 = equal_569_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4422 : box_textured_columns_values_2_q);
  logic [2:0] select_4425;
  assign select_4425 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4427;
  assign select_4427 = equal_569_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4425 : box_textured_columns_values_3_q);
  logic [2:0] select_4428;
  assign select_4428 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4430;
  assign select_4430 = equal_569_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4428 : box_textured_columns_values_4_q);
  logic [4:0] select_4432;
  assign select_4432 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4434;
  assign select_4434 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4436;
  assign select_4436 = equal_569_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4434 : box_explained_columns_values_0_q);
  logic [2:0] select_4437;
  assign select_4437 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4439;
  assign select_4439 = equal_569_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4437 : box_explained_columns_values_1_q);
  logic [2:0] select_4440;
  assign select_4440 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4442;
  assign select_4442 = equal_569_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4440 : box_explained_columns_values_2_q);
  logic [2:0] select_4443;
  assign select_4443 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4445;
  assign select_4445 = equal_569_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4443 : box_explained_columns_values_3_q);
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_569_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4446 : box_explained_columns_values_4_q);
  logic [4:0] select_4450;
  assign select_4450 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4453;
  assign select_4453 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4455;
  assign select_4455 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4457;
  assign select_4457 = equal_569_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4455 : box_shown_columns_values_1_q);
  logic [2:0] select_4458;
  assign select_4458 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4460;
  assign select_4460 = equal_569_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4458 : box_shown_columns_values_2_q);
  logic [2:0] select_4461;
  assign select_4461 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4463;
  assign select_4463 = equal_569_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4461 : box_shown_columns_values_3_q);
  logic [2:0] select_4464;
  assign select_4464 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4466;
  assign select_4466 = equal_569_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4464 : box_shown_columns_values_4_q);
  logic [4:0] select_4468;
  assign select_4468 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4471;
  assign select_4471 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4473;
  assign select_4473 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4475;
  assign select_4475 = equal_569_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4473 : box_nearer_columns_values_1_q);
  logic [2:0] select_4476;
  assign select_4476 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4478;
  assign select_4478 = equal_569_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4476 : box_nearer_columns_values_2_q);
  logic [2:0] select_4479;
  assign select_4479 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4481;
  assign select_4481 = equal_569_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4479 : box_nearer_columns_values_3_q);
  logic [2:0] select_4482;
  assign select_4482 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4484;
  assign select_4484 = equal_569_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4482 : box_nearer_columns_values_4_q);
  logic [4:0] select_4486;
  assign select_4486 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1321
  logic [1:0] select_4533;
  assign select_4533 = and_4532_s3_q ? {and_2595, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4537;
  assign select_4537 = and_2524_s3_q ? (less_2525_s3_q ? (select_4533[0] & and_4534_s3_q) : seen_q) : seen_q;
  logic select_4540;
  assign select_4540 = and_2524_s3_q ? (less_2525_s3_q ? (select_4533[1] & and_4534_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1251
  logic or_4547;
  assign or_4547 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4546_s3_q;
  // hls/stages/agreement.hpp:1253
  logic not_4555;
  assign not_4555 = ~(or_4334 | not_2820);
  // hls/stages/agreement.hpp:798
  logic and_4559;
  assign and_4559 = equal_569_s3_q & (equal_4353_s3_q & (not_4555 & (select_4342 | select_4408)));
  logic and_4562;
  assign and_4562 = equal_4353_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1162
  logic or_4566;
  assign or_4566 = select_2918 | (select_2930 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:798
  logic and_4573;
  assign and_4573 = equal_569_s3_q & (equal_4353_s3_q & (not_4555 & (select_2924 | select_2936)));
  // hls/stages/agreement.hpp:1162
  logic and_4578;
  assign and_4578 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4371 < cfg_hidden_frames_i));
  logic select_4584;
  assign select_4584 = (not_2820 | (select_4414 & not_4245)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:798
  logic and_4589;
  assign and_4589 = equal_569_s3_q & (equal_4353_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4593;
  assign and_4593 = equal_569_s3_q & (x_s3_q[6] & (not_2454_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1152
  logic [31:0] select_4601;
  assign select_4601 = equal_2102_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4599_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4602;
  assign select_4602 = equal_2100_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4601;
  logic [31:0] select_4603;
  assign select_4603 = equal_2098_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4602;
  logic [31:0] select_4604;
  assign select_4604 = equal_2096_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4603;
  logic [31:0] select_4605;
  assign select_4605 = equal_2094_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4604;
  logic [31:0] select_4606;
  assign select_4606 = equal_2092_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4605;
  logic [31:0] select_4607;
  assign select_4607 = equal_2090_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4606;
  logic [31:0] select_4608;
  assign select_4608 = equal_2088_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4607;
  // hls/stages/agreement.hpp:1150
  logic [9:0] select_4609;
  assign select_4609 = less_3107 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1154
  logic [31:0] select_4610;
  assign select_4610 = equal_2080_s3_q ? select_4608 : {2'h0, select_4609, select_3111, select_3108};

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
  assign regions_we = s3_en & and_2488_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2487, sum_2476, sum_2471};
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
  assign map_waddr = {sum_2531_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2607_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2595, is_seen};
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
      census_left_misses_q <= select_2759;
      sharpness_before_last_mask_q <= select_2832;
      sharpness_sums_detail_0_q <= and_544_s3_q ? select_2846 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_544_s3_q ? select_2858 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_544_s3_q ? sum_2862 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_544_s3_q ? sum_2866 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2884 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2894 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2896 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2898 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2900 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2902 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2907;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2910 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2918;
      sharpness_comparing_less_detail_1_q <= select_2924;
      sharpness_comparing_less_contrast_0_q <= select_2930;
      sharpness_comparing_less_contrast_1_q <= select_2936;
      counts_supervised_q <= select_3063;
      counts_textured_q <= and_3054_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3066});
      counts_explained_q <= and_3054_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3071});
      counts_nearer_q <= and_3054_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3076});
      counts_unproven_q <= and_3054_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3104});
      counts_regions_bad_q <= select_3120;
      counts_skin_supervised_q <= select_3128;
      counts_skin_textured_q <= select_3135;
      counts_skin_unproven_q <= select_3143;
      counts_on_skin_q <= select_3163;
      registration_half_across_q <= select_3243;
      registration_half_measured_q <= select_3248;
      registration_half_votes_down_q <= and_3221_s3_q ? 7'h0 : sum_3254;
      registration_half_votes_up_q <= and_3221_s3_q ? 7'h0 : sum_3262;
      registration_half_half_votes_down_q <= and_3221_s3_q ? 7'h0 : sum_3269;
      registration_half_half_votes_up_q <= and_3221_s3_q ? 7'h0 : sum_3276;
      registration_down_q <= and_3309 ? sum_3328 : registration_down_q;
      registration_up_q <= and_3309 ? sum_3337 : registration_up_q;
      registration_enough_q <= select_3351;
      registration_votes_down_q <= and_3356 ? less_3357 : registration_votes_down_q;
      registration_votes_up_q <= and_3356 ? less_3359 : registration_votes_up_q;
      registration_other_enough_q <= and_3365 ? select_3351 : registration_other_enough_q;
      registration_other_down_q <= and_3365 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3365 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_569_s3_q & and_3372)) & or_3397;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2267 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2270 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2271 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3481;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2296 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2298 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2299 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3486;
      patches_valid_0_q <= select_3491;
      patches_valid_1_q <= select_3496;
      patches_right_next_0_q <= select_3499;
      patches_right_next_1_q <= select_3502;
      patches_left_next_0_q <= select_3505;
      patches_left_next_1_q <= select_3508;
      patches_sums_values_0_q <= select_3932;
      patches_sums_values_1_q <= equal_2249_s3_q ? patches_sums_values_1_q : select_3933;
      patches_sums_values_2_q <= equal_2249_s3_q ? patches_sums_values_2_q : select_3935;
      patches_sums_values_3_q <= equal_2249_s3_q ? patches_sums_values_3_q : select_3937;
      patches_sums_values_4_q <= equal_2249_s3_q ? patches_sums_values_4_q : select_3939;
      patches_sums_values_5_q <= equal_2249_s3_q ? patches_sums_values_5_q : select_3941;
      patches_sums_values_6_q <= equal_2249_s3_q ? patches_sums_values_6_q : select_3943;
      patches_sums_values_7_q <= equal_2249_s3_q ? patches_sums_values_7_q : select_3945;
      patches_sums_values_8_q <= equal_2249_s3_q ? patches_sums_values_8_q : select_3947;
      patches_sums_values_9_q <= equal_2249_s3_q ? patches_sums_values_9_q : select_3949;
      patches_sums_values_10_q <= equal_2249_s3_q ? patches_sums_values_10_q : select_3951;
      patches_sums_values_11_q <= equal_2249_s3_q ? patches_sums_values_11_q : select_3953;
      patches_sums_values_12_q <= equal_2249_s3_q ? patches_sums_values_12_q : select_3955;
      patches_sums_values_13_q <= equal_2249_s3_q ? patches_sums_values_13_q : select_3957;
      patches_sums_values_14_q <= equal_2249_s3_q ? patches_sums_values_14_q : select_3959;
      patches_sums_values_15_q <= equal_2249_s3_q ? patches_sums_values_15_q : select_3961;
      patches_sums_values_16_q <= equal_2249_s3_q ? patches_sums_values_16_q : select_3963;
      patches_best_differing_q <= select_2442[9:0];
      patches_best_column_q <= select_2442[14:10];
      patches_quarters_0_places_q <= sum_4050;
      patches_quarters_0_up_q <= sum_4085;
      patches_quarters_0_down_q <= sum_4090;
      patches_quarters_1_places_q <= sum_4094;
      patches_quarters_1_up_q <= sum_4097;
      patches_quarters_1_down_q <= sum_4100;
      patches_quarters_2_places_q <= sum_4104;
      patches_quarters_2_up_q <= sum_4107;
      patches_quarters_2_down_q <= sum_4110;
      patches_quarters_3_places_q <= sum_4114;
      patches_quarters_3_up_q <= sum_4117;
      patches_quarters_3_down_q <= sum_4120;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_4148;
      patches_word_up_q <= ((select_4158 | select_4160) | select_4163) | select_4166;
      patches_word_down_q <= ((select_4169 | select_4171) | select_4174) | select_4177;
      patches_sum_places_q <= select_4187;
      patches_sum_up_q <= select_4190;
      patches_sum_down_q <= select_4193;
      patches_across_q <= select_4200;
      patches_places_q <= select_4211;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4215;
      patches_partly_q <= or_4218;
      patches_clear_limit_q <= sum_4219[8:2];
      patches_complete_q <= select_4221;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4204 ? select_4226 : patches_found_q;
      patches_doubted_q <= select_4233;
      patches_doubted_before_q <= select_4234;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4238;
      patches_on_skin_q <= sum_4243;
      patches_large_q <= not_4245 & and_4250;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4255;
      patches_spoiled_q <= or_4259;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4266;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4276;
      segment_textured_q <= select_2468 + {6'h0, and_3066};
      segment_explained_q <= select_2473 + {6'h0, and_3071};
      segment_nearer_q <= select_2484 + {6'h0, and_3076};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_569_s3_q ? select_4350 : good_q;
      good_known_q <= select_4355;
      hidden_for_q <= select_4373;
      product_q <= equal_569_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4398;
      disagree_q <= equal_569_s3_q ? select_4342 : disagree_q;
      too_much_q <= equal_569_s3_q ? select_4408 : too_much_q;
      hides_q <= equal_569_s3_q ? select_4368 : hides_q;
      overlooks_q <= equal_569_s3_q ? select_4414 : overlooks_q;
      seen_q <= select_4537;
      nearer_q <= select_4540;
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
      averager_quarter_1_0_q <= select_2633;
      averager_quarter_1_1_q <= select_2635;
      averager_quarter_2_0_q <= select_2637;
      averager_quarter_2_1_q <= select_2639;
      averager_detail_0_q <= select_2651;
      averager_detail_1_q <= select_2659;
      census_changes_values_0_left_q <= and_544_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_544_s3_q ? sum_2743 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2745;
      census_changes_values_1_right_q <= select_2746;
      census_changes_values_2_left_q <= select_2747;
      census_changes_values_2_right_q <= select_2748;
      sharpness_last_mask_q <= and_544_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_544_s3_q ? select_2829[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_544_s3_q ? select_2829[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4418;
      box_textured_columns_values_1_q <= select_4421;
      box_textured_columns_values_2_q <= select_4424;
      box_textured_columns_values_3_q <= select_4427;
      box_textured_columns_values_4_q <= select_4430;
      box_textured_sum_sums_values_0_q <= equal_569_s3_q ? box_textured_sum_sums_values_0_q : select_4432;
      box_explained_columns_values_0_q <= select_4436;
      box_explained_columns_values_1_q <= select_4439;
      box_explained_columns_values_2_q <= select_4442;
      box_explained_columns_values_3_q <= select_4445;
      box_explained_columns_values_4_q <= select_4448;
      box_explained_sum_sums_values_0_q <= equal_569_s3_q ? box_explained_sum_sums_values_0_q : select_4450;
      box_shown_columns_values_0_q <= equal_569_s3_q ? box_shown_columns_values_0_q : select_4453;
      box_shown_columns_values_1_q <= select_4457;
      box_shown_columns_values_2_q <= select_4460;
      box_shown_columns_values_3_q <= select_4463;
      box_shown_columns_values_4_q <= select_4466;
      box_shown_sum_sums_values_0_q <= equal_569_s3_q ? box_shown_sum_sums_values_0_q : select_4468;
      box_nearer_columns_values_0_q <= equal_569_s3_q ? box_nearer_columns_values_0_q : select_4471;
      box_nearer_columns_values_1_q <= select_4475;
      box_nearer_columns_values_2_q <= select_4478;
      box_nearer_columns_values_3_q <= select_4481;
      box_nearer_columns_values_4_q <= select_4484;
      box_nearer_sum_sums_values_0_q <= equal_569_s3_q ? box_nearer_sum_sums_values_0_q : select_4486;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4517_s4_q;
  logic or_4541_s4_q;
  logic and_4542_s4_q;
  logic and_4550_s4_q;
  logic and_4553_s4_q;
  logic and_4559_s4_q;
  logic and_4563_s4_q;
  logic and_4569_s4_q;
  logic and_4573_s4_q;
  logic and_4581_s4_q;
  logic and_4586_s4_q;
  logic and_4589_s4_q;
  logic and_4593_s4_q;
  logic [5:0] select_4595_s4_q;
  logic [31:0] select_4612_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4517_s4_q <= and_4517_s3_q;
      or_4541_s4_q <= not_2820 | select_4537;
      and_4542_s4_q <= cfg_prove_i & select_4540;
      and_4550_s4_q <= equal_569_s3_q & (equal_4353_s3_q & (cfg_prove_i & or_4547));
      and_4553_s4_q <= equal_569_s3_q & (equal_4353_s3_q & (cfg_prove_i & or_4334));
      and_4559_s4_q <= and_4559;
      and_4563_s4_q <= equal_569_s3_q & and_4562;
      and_4569_s4_q <= equal_569_s3_q & (equal_4353_s3_q & (not_4555 & or_4566));
      and_4573_s4_q <= and_4573;
      and_4581_s4_q <= equal_569_s3_q & (equal_4353_s3_q & (cfg_prove_i & and_4578));
      and_4586_s4_q <= equal_569_s3_q & (equal_4353_s3_q & select_4584);
      and_4589_s4_q <= and_4589;
      and_4593_s4_q <= and_4593;
      select_4595_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4612_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? select_4610 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4541_s4_q;
  assign marks_nearer_o = and_4542_s4_q;
  assign verdict_valid_o = and_4517_s4_q;
  assign verdict_unproven_yet_o = and_4550_s4_q;
  assign verdict_untextured_o = and_4553_s4_q;
  assign verdict_disagree_o = and_4559_s4_q;
  assign verdict_moved_o = and_4563_s4_q;
  assign verdict_unsharp_left_o = and_4569_s4_q;
  assign verdict_unsharp_right_o = and_4573_s4_q;
  assign verdict_hidden_o = and_4581_s4_q;
  assign verdict_overlooked_o = and_4586_s4_q;
  assign verdict_out_of_step_o = and_4589_s4_q;
  assign frame_valid_o = and_4593_s4_q;
  assign frame_index_o = select_4595_s4_q;
  assign frame_word_o = select_4612_s4_q;
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
  assign unused_bits = ^{over[13:0], sum_4284[6:0], product_4248[4:0], sum_4219[1:0], sum_4179[1:0], product_4080[4:0], sum_3211[0], difference_3149[1:0], detail_4[1:0], detail_3[1:0], sum_2753[4:0], sum_2187[0], sum_2183[0], sum_729[4:0], cfg_width_i[2:0]};

endmodule
