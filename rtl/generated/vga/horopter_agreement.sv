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
  logic not_2823;
  assign not_2823 = ~cfg_prove_i;
  logic [5:0] sum_3033;
  assign sum_3033 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_3038;
  assign less_3038 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_4055;
  assign difference_4055 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4248;
  assign not_4248 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4285;
  assign difference_4285 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4526;
  assign sum_4526 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4527;
  assign select_4527 = (6'h4 < cfg_height_i[8:3]) ? {sum_4526, cfg_height_i[4:3]} : 8'h0;

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
  logic and_609;
  assign and_609 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_576)));
  logic and_610;
  assign and_610 = equal_588 & and_609;
  logic select_611;
  assign select_611 = or_574 ? not_578 : and_610;
  // hls/stages/agreement.hpp:831
  logic [6:0] right;
  assign right = sum_575[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:604
  logic not_646;
  assign not_646 = ~or_574;
  // hls/stages/agreement.hpp:150
  logic and_649;
  assign and_649 = not_646 & ((~equal_588) & and_590);
  // hls/stages/census.hpp:42
  logic [5:0] select_676;
  assign select_676 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_676 : 6'h0;
  // hls/stages/patches.hpp:396
  logic not_2147;
  assign not_2147 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_2150;
  assign not_2150 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_2151;
  assign and_2151 = patches_capturing_q & not_2150;
  // hls/stages/patches.hpp:368
  logic equal_2152;
  assign equal_2152 = {or_515, select_522} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_2154;
  assign equal_2154 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2159;
  assign and_2159 = (not_2147 & (patches_work_q == 3'h0)) & (~(and_2151 | ((~equal_2152) | (~equal_2154))));
  // hls/stages/patches.hpp:537
  logic equal_2250;
  assign equal_2250 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_2251;
  assign not_2251 = ~equal_2250;
  // hls/stages/patches.hpp:509
  logic equal_2252;
  assign equal_2252 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_2253;
  assign not_2253 = ~equal_2252;
  // hls/stages/patches.hpp:503
  logic equal_2254;
  assign equal_2254 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_2255;
  assign equal_2255 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_2256;
  assign or_2256 = equal_2254 | equal_2255;
  // hls/stages/patches.hpp:464
  logic not_2257;
  assign not_2257 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_2279;
  assign select_2279 = and_2159 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2280;
  assign select_2280 = row_starts ? select_2279 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2282;
  assign and_2282 = and_2151 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2286;
  assign select_2286 = row_starts ? (and_2159 | (and_2151 & (~and_2282))) : patches_capturing_q;
  // hls/stages/agreement.hpp:276
  logic and_2294;
  assign and_2294 = not_2251 & (not_2253 & (or_2256 & (patches_second_q & equal_2255)));
  // hls/stages/patches.hpp:168
  logic not_2310;
  assign not_2310 = ~equal_2255;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2326;
  assign select_2326 = row_starts ? {select_2279[4], select_2279[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_2336;
  assign and_2336 = not_2251 & (or_2256 & not_2253);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2613;
  assign select_2613 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_505 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2616;
  assign select_2616 = sample_pair_whole_q ? (sample_last_q ? (select_522 + 3'h1) : select_522) : raster_at_y_q;
  logic [6:0] select_2619;
  assign select_2619 = sample_pair_whole_q ? (sample_last_q ? 7'h0 : (select_538 + {6'h0, equal_540})) : raster_at_column_q;
  logic [5:0] select_2622;
  assign select_2622 = sample_pair_whole_q ? (sample_last_q ? (select_676 + {5'h0, equal_541}) : select_676) : raster_at_row_q;
  logic select_2626;
  assign select_2626 = sample_pair_whole_q ? (sample_last_q ? (or_515 & (~raster_final_row_q)) : or_515) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2628;
  assign select_2628 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2632;
  assign select_2632 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [7:0] sum_2941;
  assign sum_2941 = {1'b0, last} + 8'h1;
  logic equal_2942;
  assign equal_2942 = {sum_2941[7], cfg_width_i[9:3]} == {1'b0, sum_2941[6:0]};
  // hls/stages/agreement.hpp:469
  logic and_2943;
  assign and_2943 = and_544 & equal_2942;
  // hls/stages/agreement.hpp:533
  logic select_2946;
  assign select_2946 = (and_2943 | (~ends_cell_q)) ? and_2943 : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2946 ? (and_2943 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2950;
  assign select_2950 = select_2946 ? (and_2943 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2953;
  assign select_2953 = select_2946 ? (following_last_shift_q & (~and_2943)) : run_last_shift_q;
  // hls/stages/agreement.hpp:617
  logic and_2956;
  assign and_2956 = run_last_shift_q & equal_588;
  // hls/stages/agreement.hpp:626
  logic select_2958;
  assign select_2958 = equal_588 ? (~run_last_shift_q) : equal_589;
  // hls/stages/agreement.hpp:630
  logic equal_2959;
  assign equal_2959 = run_phase_q == 3'h1;
  logic not_2962;
  assign not_2962 = ~select_2958;
  // hls/stages/agreement.hpp:633
  logic equal_2964;
  assign equal_2964 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2965;
  assign and_2965 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2966;
  assign select_2966 = equal_2964 ? 2'h1 : {2{and_2965}};
  logic [2:0] select_2968;
  assign select_2968 = (and_2956 | (select_2958 | equal_2959)) ? (equal_2959 ? 3'h2 : {not_2962, {2{select_2958}}}) : (equal_573 ? 3'h6 : {select_2966[0], select_2966});
  // hls/stages/agreement.hpp:617
  logic and_2971;
  assign and_2971 = select_2958 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2974;
  assign select_2974 = (plan_shift_q[5] & select_2958) ? value : 7'h0;
  logic [1:0] or_2975;
  assign or_2975 = {2{so}} | select_2974[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] or_2979;
  assign or_2979 = (select_2958 ? plan_columns_q : 8'h0) | ((equal_2959 | equal_2964) ? whole_q : 8'h0);
  logic [1:0] or_2980;
  assign or_2980 = {2{and_2956}} | or_2979[3:2];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2982;
  assign or_2982 = {or_2979[7:4], or_2980, or_2979[1:0]} | (equal_573 ? drawn_q : 8'h0);
  logic [4:0] or_2983;
  assign or_2983 = {5{so}} | {or_2982[6], or_2982[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2987;
  assign not_2987 = ~run_shift_q[5];
  logic [7:0] select_2990;
  assign select_2990 = equal_588 ? ({{7{not_2987}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2994;
  assign select_2994 = and_2943 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2996;
  assign select_2996 = select_2946 ? {select_2994[6], select_2994} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2999;
  assign select_2999 = select_2946 ? (and_2943 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:530
  logic [6:0] select_3007;
  assign select_3007 = and_544 ? (equal_2942 ? ((6'he < last[6:1]) ? 7'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [5:0] sum_3008;
  assign sum_3008 = {1'b0, last[6:2]} + 6'h3;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3010;
  assign select_3010 = and_544 ? (equal_2942 ? {sum_3008, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_3011;
  assign sum_3011 = {1'b0, last[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3013;
  assign select_3013 = and_544 ? (equal_2942 ? {sum_3011, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_3024;
  assign select_3024 = (ends_cell_q | select_2946) ? (~(now == 3'h6)) : (equal_588 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_3028;
  assign and_3028 = (~select_2946) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_3029;
  assign sum_3029 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_3031;
  assign select_3031 = equal_2942 ? ({sum_3029[6], cfg_height_i[8:3]} == {1'b0, sum_3029[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3406;
  assign select_3406 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3407;
  assign select_3407 = sample_pair_whole_q ? select_3406 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_3408;
  assign and_3408 = not_2150 & equal_2152;
  logic [8:0] select_3409;
  assign select_3409 = and_3408 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3410;
  assign select_3410 = and_3408 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3411;
  assign select_3411 = sample_pair_first_q ? select_3409 : select_3410;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3413;
  assign select_3413 = sample_pair_whole_q ? (row_starts ? select_3411[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3415;
  assign select_3415 = sample_pair_whole_q ? (row_starts ? select_3411[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3418;
  assign select_3418 = sample_pair_whole_q ? (equal_2154 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3420;
  assign select_3420 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2154}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_3421;
  assign equal_3421 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_3422;
  assign not_3422 = ~equal_3421;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3424;
  assign select_3424 = sample_pair_whole_q ? (phase + {not_3422, 1'b1, not_3422, equal_3421}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_3426;
  assign equal_3426 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3430;
  assign select_3430 = equal_3426 ? ((select_3407 == 4'h6) ? 4'h0 : (select_3407 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3431;
  assign equal_3431 = select_3430 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_3434;
  assign select_3434 = equal_2942 ? (equal_3431 ? 4'h6 : (select_3430 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3436;
  assign select_3436 = equal_3426 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3438;
  assign select_3438 = equal_2942 ? (select_3436 + {4'h0, equal_3431}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:530
  logic select_3443;
  assign select_3443 = and_544 ? (equal_2942 ? ((6'h2 < row) & equal_3431) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3445;
  assign select_3445 = and_544 ? (equal_2942 ? select_3436 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3469;
  assign sum_3469 = {1'b0, select_676[5:1]} + 6'h1;
  logic less_3470;
  assign less_3470 = {sum_3469, select_676[0], select_522, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3473;
  assign select_3473 = row_starts ? (and_2159 ? (~less_3470) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3512;
  assign or_3512 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3517;
  assign select_3517 = (patches_second_q | patches_begins_q) ? not_2147 : (patches_ends_q & equal_2250);
  logic and_3518;
  assign and_3518 = equal_2250 & not_2257;
  // hls/stages/patches.hpp:403
  logic and_3519;
  assign and_3519 = not_2310 & and_3518;
  logic [1:0] select_3521;
  assign select_3521 = equal_2252 ? 2'h0 : (equal_2254 ? 2'h3 : {equal_2255, and_3519});
  // hls/stages/patches.hpp:283
  logic equal_3523;
  assign equal_3523 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3524;
  assign not_3524 = ~equal_3523;
  // hls/stages/patches.hpp:283
  logic equal_3525;
  assign equal_3525 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3526;
  assign not_3526 = ~equal_3525;
  // hls/stages/patches.hpp:287
  logic not_3528;
  assign not_3528 = ~(patches_following_q == 3'h2);
  logic and_3531;
  assign and_3531 = (~(patches_following_q == 3'h1)) & not_3528;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3532;
  assign select_3532 = equal_3525 ? 2'h2 : {and_3531, not_3528};
  logic [3:0] select_3533;
  assign select_3533 = equal_3523 ? 4'h2 : {select_3532, {2{not_3526}}};
  // hls/stages/patches.hpp:409
  logic not_3536;
  assign not_3536 = ~or_3512;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3541;
  assign select_3541 = or_3512 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3543;
  assign select_3543 = or_3512 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1389; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_649;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1390; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1391; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_574 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_611;
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
  assign patches_right_0_re = s0_en & (not_2251 & (not_2253 & (or_2256 & (equal_2255 & not_2257))));
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
  assign patches_right_1_re = s0_en & and_2294;
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
  assign patches_left_re = s0_en & (not_2251 & (not_2253 & (not_2310 & or_2256)));
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
  assign patches_columns_above_re = s0_en & and_2336;
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
      raster_at_x_q <= select_2613;
      raster_at_y_q <= select_2616;
      raster_at_column_q <= select_2619;
      raster_at_row_q <= select_2622;
      raster_at_live_q <= select_2626;
      raster_rows_left_q <= sample_pair_whole_q ? select_2628 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2632;
      averager_place_q <= sample_pair_whole_q ? select_509 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_514 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2950;
      run_last_shift_q <= select_2953;
      run_span_q <= select_2946 ? (and_2943 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2968;
      following_shift_q <= select_2958 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2971;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2974[6], or_2975, select_2974[3:0]};
      following_columns_q <= {or_2982[7], or_2983[4], or_2982[5:4], or_2983[3:0]};
      plan_shift_q <= equal_588 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2990;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2996;
      columns_left_q <= select_2999;
      last_q <= and_544 ? (equal_2942 ? last : last_q) : last_q;
      least_q <= select_3007;
      whole_q <= select_3010;
      drawn_q <= select_3013;
      age_q <= select_2946 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2946 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3024;
      ends_q <= and_3028;
      final_row_q <= and_544 ? select_3031 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3407;
      patches_band_rows_rows_to_next_q <= select_3413;
      patches_band_rows_number_q <= select_3415;
      patches_next_band_rows_to_next_q <= select_3418;
      patches_next_band_number_q <= select_3420;
      patches_first_band_rows_to_next_q <= select_3424;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3421 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_544 ? select_3434 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_544 ? select_3438 : patches_choosing_number_q;
      patches_chooses_q <= select_3443;
      patches_choosing_band_q <= select_3445;
      patches_capturing_q <= sample_pair_whole_q ? select_2286 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3473 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2280 : patches_row_q;
      patches_work_q <= or_3512 ? following : patches_work_q;
      patches_second_q <= select_3517;
      patches_following_q <= equal_2250 ? {2'h0, and_3518} : {equal_2252, select_3521};
      patches_following_beats_q <= {select_3533, not_3524};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_2282);
      patches_ends_q <= not_3536 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3541;
      patches_code_row_q <= select_3543;
      patches_column_q <= or_3512 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3536 & (patches_column_q == 5'h1e);
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
  logic select_611_s1_q;
  logic [6:0] right_s1_q;
  logic and_649_s1_q;
  logic [5:0] row_s1_q;
  logic and_2035_s1_q;
  logic equal_2036_s1_q;
  logic and_2159_s1_q;
  logic equal_2250_s1_q;
  logic not_2251_s1_q;
  logic equal_2252_s1_q;
  logic not_2253_s1_q;
  logic equal_2254_s1_q;
  logic equal_2255_s1_q;
  logic or_2256_s1_q;
  logic not_2257_s1_q;
  logic [4:0] select_2280_s1_q;
  logic select_2286_s1_q;
  logic [3:0] select_2326_s1_q;
  logic and_2336_s1_q;
  logic equal_2942_s1_q;
  logic and_2943_s1_q;
  logic or_3512_s1_q;
  logic not_3536_s1_q;
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
      select_611_s1_q <= select_611;
      right_s1_q <= right;
      and_649_s1_q <= and_649;
      row_s1_q <= row;
      and_2035_s1_q <= not_646 & and_610;
      equal_2036_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2159_s1_q <= and_2159;
      equal_2250_s1_q <= equal_2250;
      not_2251_s1_q <= not_2251;
      equal_2252_s1_q <= equal_2252;
      not_2253_s1_q <= not_2253;
      equal_2254_s1_q <= equal_2254;
      equal_2255_s1_q <= equal_2255;
      or_2256_s1_q <= or_2256;
      not_2257_s1_q <= not_2257;
      select_2280_s1_q <= select_2280;
      select_2286_s1_q <= select_2286;
      select_2326_s1_q <= select_2326;
      and_2336_s1_q <= and_2336;
      equal_2942_s1_q <= equal_2942;
      and_2943_s1_q <= and_2943;
      or_3512_s1_q <= or_3512;
      not_3536_s1_q <= not_3536;
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
  // hls/stages/moments.hpp:68
  logic [13:0] select_567;
  assign select_567 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:798
  logic [12:0] select_568;
  assign select_568 = first ? 13'h0 : select_567[12:0];
  // hls/stages/agreement.hpp:1022
  logic not_570;
  assign not_570 = ~equal_569_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_572;
  assign not_572 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_574_s1_q & not_578_s1_q;
  // hls/stages/moments.hpp:74
  logic [7:0] place;
  assign place = first ? 8'h0 : select_567[13:6];
  // hls/stages/moments.hpp:131
  logic not_582;
  assign not_582 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:798
  logic and_586;
  assign and_586 = not_570 & (not_572 & (equal_573_s1_q & (inside_v & not_582)));
  // hls/stages/agreement.hpp:985
  logic and_601;
  assign and_601 = (or_574_s1_q & (left_rdata_q[67] & not_578_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:977
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:978
  logic [6:0] select_620;
  assign select_620 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:1014
  logic less_633;
  assign less_633 = 6'h2 < row_q;
  // hls/stages/agreement.hpp:1016
  logic and_643;
  assign and_643 = (or_574_s1_q & (right_codes_rdata_q[58] & not_578_s1_q)) & less_633;
  // hls/stages/agreement.hpp:679
  logic or_747;
  assign or_747 = late_q | (~equal_563);
  // hls/stages/agreement.hpp:681
  logic and_748;
  assign and_748 = left_rdata_q[12] & or_747;
  logic and_749;
  assign and_749 = left_rdata_q[30] & or_747;
  logic and_750;
  assign and_750 = left_rdata_q[48] & or_747;
  logic and_751;
  assign and_751 = left_rdata_q[66] & or_747;
  // hls/stages/agreement.hpp:682
  logic and_752;
  assign and_752 = right_codes_rdata_q[12] & or_747;
  logic and_753;
  assign and_753 = right_codes_rdata_q[27] & or_747;
  logic and_754;
  assign and_754 = right_codes_rdata_q[42] & or_747;
  logic and_755;
  assign and_755 = right_codes_rdata_q[57] & or_747;
  logic and_756;
  assign and_756 = right_codes_rdata_q[72] & or_747;
  logic and_757;
  assign and_757 = right_codes_rdata_q[85] & or_747;
  // hls/stages/agreement.hpp:222
  logic and_762;
  assign and_762 = left_rdata_q[48] & not_578_s1_q;
  logic and_763;
  assign and_763 = right_codes_rdata_q[42] & not_578_s1_q;
  logic [11:0] select_764;
  assign select_764 = less_577_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_765;
  assign select_765 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_769;
  assign select_769 = and_762 ? (and_763 ? (~(select_764 ^ select_765)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_775;
  assign parity_775 = ^select_769[5:3];
  logic parity_778;
  assign parity_778 = ^select_769[8:6];
  logic parity_781;
  assign parity_781 = ^select_769[11:3];
  // hls/stages/agreement.hpp:222
  logic and_785;
  assign and_785 = left_rdata_q[66] & not_578_s1_q;
  logic and_786;
  assign and_786 = right_codes_rdata_q[57] & not_578_s1_q;
  logic [11:0] select_787;
  assign select_787 = less_577_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_788;
  assign select_788 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_792;
  assign select_792 = and_785 ? (and_786 ? (~(select_787 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_795;
  assign parity_795 = ^select_792[8:6];
  logic parity_798;
  assign parity_798 = ^select_792[11:9];
  // hls/stages/agreement.hpp:222
  logic and_802;
  assign and_802 = left_rdata_q[84] & not_578_s1_q;
  logic and_803;
  assign and_803 = right_codes_rdata_q[72] & not_578_s1_q;
  logic [11:0] select_804;
  assign select_804 = less_577_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_805;
  assign select_805 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_809;
  assign select_809 = and_802 ? (and_803 ? (~(select_804 ^ select_805)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_815;
  assign parity_815 = ^select_809[2:0];
  logic parity_818;
  assign parity_818 = ^select_809[5:3];
  logic parity_821;
  assign parity_821 = ^select_809[8:0];
  logic parity_827;
  assign parity_827 = ^select_809[11:9];
  logic parity_830;
  assign parity_830 = ^select_792[2:0];
  logic parity_833;
  assign parity_833 = ^{select_809[11:9], select_792[5:0]};
  logic parity_836;
  assign parity_836 = ^{select_809, select_792, select_769[2:0]};
  logic xor_837;
  assign xor_837 = parity_781 ^ parity_836;
  // hls/stages/count_bits.hpp:23
  logic or_841;
  assign or_841 = (select_769[1:0] == 2'h3) | (select_769[2] & (select_769[0] | select_769[1]));
  // hls/stages/count_bits.hpp:25
  logic or_845;
  assign or_845 = (select_792[7:6] == 2'h3) | (select_792[8] & (select_792[6] | select_792[7]));
  logic or_849;
  assign or_849 = (select_792[10:9] == 2'h3) | (select_792[11] & (select_792[9] | select_792[10]));
  // hls/stages/count_bits.hpp:23
  logic or_857;
  assign or_857 = (select_809[7:6] == 2'h3) | (select_809[8] & (~(select_809[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_861;
  assign or_861 = (select_809[1:0] == 2'h3) | (select_809[2] & (select_809[0] | select_809[1]));
  logic or_865;
  assign or_865 = (select_809[4:3] == 2'h3) | (select_809[5] & (select_809[3] | select_809[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_868;
  assign parity_868 = ^{or_865, or_861, or_857};
  // hls/stages/count_bits.hpp:23
  logic or_872;
  assign or_872 = (select_792[4:3] == 2'h3) | (select_792[5] & (select_792[3] | select_792[4]));
  // hls/stages/count_bits.hpp:25
  logic or_876;
  assign or_876 = (select_809[10:9] == 2'h3) | (select_809[11] & (select_809[9] | select_809[10]));
  logic or_880;
  assign or_880 = (select_792[1:0] == 2'h3) | (select_792[2] & (select_792[0] | select_792[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_883;
  assign parity_883 = ^{or_880, or_876, or_872};
  logic parity_886;
  assign parity_886 = ^{or_880, or_876, or_872, or_865, or_861, or_857, or_849, or_845, or_841};
  // hls/stages/count_bits.hpp:25
  logic and_887;
  assign and_887 = parity_781 & parity_836;
  logic or_891;
  assign or_891 = (parity_775 & parity_778) | ((^select_769[11:9]) & (parity_775 | parity_778));
  logic and_894;
  assign and_894 = (^{select_792[11:6], select_769[2:0]}) & (parity_821 | parity_833);
  logic or_895;
  assign or_895 = (parity_821 & parity_833) | and_894;
  // hls/stages/count_bits.hpp:23
  logic or_902;
  assign or_902 = (select_769[10:9] == 2'h3) | (select_769[11] & (select_769[9] | select_769[10]));
  // hls/stages/count_bits.hpp:25
  logic or_906;
  assign or_906 = (select_769[4:3] == 2'h3) | (select_769[5] & (select_769[3] | select_769[4]));
  logic or_910;
  assign or_910 = (select_769[7:6] == 2'h3) | (select_769[8] & (select_769[6] | select_769[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_913;
  assign parity_913 = ^{or_910, or_906, or_902};
  // hls/stages/count_bits.hpp:25
  logic or_917;
  assign or_917 = (parity_795 & parity_798) | ((^select_769[2:0]) & (parity_795 | parity_798));
  logic or_921;
  assign or_921 = (parity_815 & parity_818) | ((^select_809[8:6]) & (parity_815 | parity_818));
  logic or_925;
  assign or_925 = (parity_827 & parity_830) | ((^select_792[5:3]) & (parity_827 | parity_830));
  // hls/stages/count_bits.hpp:24
  logic parity_928;
  assign parity_928 = ^{or_925, or_921, or_917};
  logic parity_931;
  assign parity_931 = ^{or_925, or_921, or_917, or_910, or_906, or_902, or_895, or_891, and_887};
  logic xor_932;
  assign xor_932 = parity_886 ^ parity_931;
  // hls/stages/count_bits.hpp:25
  logic and_933;
  assign and_933 = parity_886 & parity_931;
  logic or_937;
  assign or_937 = (parity_868 & parity_883) | ((^{or_849, or_845, or_841}) & (parity_868 | parity_883));
  logic or_941;
  assign or_941 = (parity_913 & parity_928) | ((^{or_895, or_891, and_887}) & (parity_913 | parity_928));
  logic or_948;
  assign or_948 = (or_845 & or_849) | (or_841 & (or_845 | or_849));
  logic or_952;
  assign or_952 = (or_861 & or_865) | (or_857 & (or_861 | or_865));
  logic or_956;
  assign or_956 = (or_876 & or_880) | (or_872 & (or_876 | or_880));
  // hls/stages/count_bits.hpp:24
  logic parity_959;
  assign parity_959 = ^{or_956, or_952, or_948};
  // hls/stages/count_bits.hpp:25
  logic or_963;
  assign or_963 = (or_891 & or_895) | (and_887 & (or_891 | or_895));
  logic or_967;
  assign or_967 = (or_906 & or_910) | (or_902 & (or_906 | or_910));
  logic or_971;
  assign or_971 = (or_921 & or_925) | (or_917 & (or_921 | or_925));
  // hls/stages/count_bits.hpp:24
  logic parity_974;
  assign parity_974 = ^{or_971, or_967, or_963};
  logic parity_977;
  assign parity_977 = ^{or_971, or_967, or_963, or_956, or_952, or_948, or_941, or_937, and_933};
  // hls/stages/count_bits.hpp:25
  logic or_981;
  assign or_981 = (parity_959 & parity_974) | ((^{or_941, or_937, and_933}) & (parity_959 | parity_974));
  logic or_985;
  assign or_985 = (or_937 & or_941) | (and_933 & (or_937 | or_941));
  logic or_989;
  assign or_989 = (or_952 & or_956) | (or_948 & (or_952 | or_956));
  logic or_993;
  assign or_993 = (or_967 & or_971) | (or_963 & (or_967 | or_971));
  // hls/stages/count_bits.hpp:24
  logic parity_998;
  assign parity_998 = ^{or_993, or_989, or_985, or_981};
  // hls/stages/count_bits.hpp:25
  logic or_1002;
  assign or_1002 = (or_989 & or_993) | (or_985 & (or_989 | or_993));
  logic and_1003;
  assign and_1003 = or_981 & (^{or_993, or_989, or_985});
  // hls/stages/count_bits.hpp:24
  logic xor_1004;
  assign xor_1004 = or_1002 ^ and_1003;
  // hls/stages/count_bits.hpp:27
  logic and_1005;
  assign and_1005 = or_1002 & and_1003;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1006;
  assign select_1006 = equal_588_s1_q ? {and_1005, xor_1004, parity_998, parity_977, xor_932, xor_837} : 6'h0;
  logic [5:0] column;
  assign column = or_574_s1_q ? 6'h0 : select_1006;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1008;
  assign select_1008 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1009;
  assign difference_1009 = {1'b0, column} - {1'b0, select_1008};
  logic [7:0] sum_1011;
  assign sum_1011 = {difference_1009[6], difference_1009} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1015;
  assign select_1015 = and_762 ? (and_786 ? (~(select_764 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1021;
  assign parity_1021 = ^select_1015[5:3];
  logic parity_1024;
  assign parity_1024 = ^select_1015[8:6];
  logic parity_1027;
  assign parity_1027 = ^select_1015[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1034;
  assign select_1034 = and_785 ? (and_803 ? (~(select_787 ^ select_805)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1037;
  assign parity_1037 = ^select_1034[8:6];
  logic parity_1040;
  assign parity_1040 = ^select_1034[11:9];
  // hls/stages/agreement.hpp:222
  logic and_1044;
  assign and_1044 = right_codes_rdata_q[85] & not_578_s1_q;
  logic [11:0] select_1045;
  assign select_1045 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1049;
  assign select_1049 = and_802 ? (and_1044 ? (~(select_804 ^ select_1045)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1055;
  assign parity_1055 = ^select_1049[2:0];
  logic parity_1058;
  assign parity_1058 = ^select_1049[5:3];
  logic parity_1061;
  assign parity_1061 = ^select_1049[8:0];
  logic parity_1067;
  assign parity_1067 = ^select_1049[11:9];
  logic parity_1070;
  assign parity_1070 = ^select_1034[2:0];
  logic parity_1073;
  assign parity_1073 = ^{select_1049[11:9], select_1034[5:0]};
  logic parity_1076;
  assign parity_1076 = ^{select_1049, select_1034, select_1015[2:0]};
  logic xor_1077;
  assign xor_1077 = parity_1027 ^ parity_1076;
  // hls/stages/count_bits.hpp:23
  logic or_1081;
  assign or_1081 = (select_1015[1:0] == 2'h3) | (select_1015[2] & (select_1015[0] | select_1015[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1085;
  assign or_1085 = (select_1034[7:6] == 2'h3) | (select_1034[8] & (select_1034[6] | select_1034[7]));
  logic or_1089;
  assign or_1089 = (select_1034[10:9] == 2'h3) | (select_1034[11] & (select_1034[9] | select_1034[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1097;
  assign or_1097 = (select_1049[7:6] == 2'h3) | (select_1049[8] & (~(select_1049[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1101;
  assign or_1101 = (select_1049[1:0] == 2'h3) | (select_1049[2] & (select_1049[0] | select_1049[1]));
  logic or_1105;
  assign or_1105 = (select_1049[4:3] == 2'h3) | (select_1049[5] & (select_1049[3] | select_1049[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1108;
  assign parity_1108 = ^{or_1105, or_1101, or_1097};
  // hls/stages/count_bits.hpp:23
  logic or_1112;
  assign or_1112 = (select_1034[4:3] == 2'h3) | (select_1034[5] & (select_1034[3] | select_1034[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1116;
  assign or_1116 = (select_1049[10:9] == 2'h3) | (select_1049[11] & (select_1049[9] | select_1049[10]));
  logic or_1120;
  assign or_1120 = (select_1034[1:0] == 2'h3) | (select_1034[2] & (select_1034[0] | select_1034[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1123;
  assign parity_1123 = ^{or_1120, or_1116, or_1112};
  logic parity_1126;
  assign parity_1126 = ^{or_1120, or_1116, or_1112, or_1105, or_1101, or_1097, or_1089, or_1085, or_1081};
  // hls/stages/count_bits.hpp:25
  logic and_1127;
  assign and_1127 = parity_1027 & parity_1076;
  logic or_1131;
  assign or_1131 = (parity_1021 & parity_1024) | ((^select_1015[11:9]) & (parity_1021 | parity_1024));
  logic and_1134;
  assign and_1134 = (^{select_1034[11:6], select_1015[2:0]}) & (parity_1061 | parity_1073);
  logic or_1135;
  assign or_1135 = (parity_1061 & parity_1073) | and_1134;
  // hls/stages/count_bits.hpp:23
  logic or_1142;
  assign or_1142 = (select_1015[10:9] == 2'h3) | (select_1015[11] & (select_1015[9] | select_1015[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1146;
  assign or_1146 = (select_1015[4:3] == 2'h3) | (select_1015[5] & (select_1015[3] | select_1015[4]));
  logic or_1150;
  assign or_1150 = (select_1015[7:6] == 2'h3) | (select_1015[8] & (select_1015[6] | select_1015[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1153;
  assign parity_1153 = ^{or_1150, or_1146, or_1142};
  // hls/stages/count_bits.hpp:25
  logic or_1157;
  assign or_1157 = (parity_1037 & parity_1040) | ((^select_1015[2:0]) & (parity_1037 | parity_1040));
  logic or_1161;
  assign or_1161 = (parity_1055 & parity_1058) | ((^select_1049[8:6]) & (parity_1055 | parity_1058));
  logic or_1165;
  assign or_1165 = (parity_1067 & parity_1070) | ((^select_1034[5:3]) & (parity_1067 | parity_1070));
  // hls/stages/count_bits.hpp:24
  logic parity_1168;
  assign parity_1168 = ^{or_1165, or_1161, or_1157};
  logic parity_1171;
  assign parity_1171 = ^{or_1165, or_1161, or_1157, or_1150, or_1146, or_1142, or_1135, or_1131, and_1127};
  logic xor_1172;
  assign xor_1172 = parity_1126 ^ parity_1171;
  // hls/stages/count_bits.hpp:25
  logic and_1173;
  assign and_1173 = parity_1126 & parity_1171;
  logic or_1177;
  assign or_1177 = (parity_1108 & parity_1123) | ((^{or_1089, or_1085, or_1081}) & (parity_1108 | parity_1123));
  logic or_1181;
  assign or_1181 = (parity_1153 & parity_1168) | ((^{or_1135, or_1131, and_1127}) & (parity_1153 | parity_1168));
  logic or_1188;
  assign or_1188 = (or_1085 & or_1089) | (or_1081 & (or_1085 | or_1089));
  logic or_1192;
  assign or_1192 = (or_1101 & or_1105) | (or_1097 & (or_1101 | or_1105));
  logic or_1196;
  assign or_1196 = (or_1116 & or_1120) | (or_1112 & (or_1116 | or_1120));
  // hls/stages/count_bits.hpp:24
  logic parity_1199;
  assign parity_1199 = ^{or_1196, or_1192, or_1188};
  // hls/stages/count_bits.hpp:25
  logic or_1203;
  assign or_1203 = (or_1131 & or_1135) | (and_1127 & (or_1131 | or_1135));
  logic or_1207;
  assign or_1207 = (or_1146 & or_1150) | (or_1142 & (or_1146 | or_1150));
  logic or_1211;
  assign or_1211 = (or_1161 & or_1165) | (or_1157 & (or_1161 | or_1165));
  // hls/stages/count_bits.hpp:24
  logic parity_1214;
  assign parity_1214 = ^{or_1211, or_1207, or_1203};
  logic parity_1217;
  assign parity_1217 = ^{or_1211, or_1207, or_1203, or_1196, or_1192, or_1188, or_1181, or_1177, and_1173};
  // hls/stages/count_bits.hpp:25
  logic or_1221;
  assign or_1221 = (parity_1199 & parity_1214) | ((^{or_1181, or_1177, and_1173}) & (parity_1199 | parity_1214));
  logic or_1225;
  assign or_1225 = (or_1177 & or_1181) | (and_1173 & (or_1177 | or_1181));
  logic or_1229;
  assign or_1229 = (or_1192 & or_1196) | (or_1188 & (or_1192 | or_1196));
  logic or_1233;
  assign or_1233 = (or_1207 & or_1211) | (or_1203 & (or_1207 | or_1211));
  // hls/stages/count_bits.hpp:24
  logic parity_1238;
  assign parity_1238 = ^{or_1233, or_1229, or_1225, or_1221};
  // hls/stages/count_bits.hpp:25
  logic or_1242;
  assign or_1242 = (or_1229 & or_1233) | (or_1225 & (or_1229 | or_1233));
  logic and_1243;
  assign and_1243 = or_1221 & (^{or_1233, or_1229, or_1225});
  // hls/stages/count_bits.hpp:24
  logic xor_1244;
  assign xor_1244 = or_1242 ^ and_1243;
  // hls/stages/count_bits.hpp:27
  logic and_1245;
  assign and_1245 = or_1242 & and_1243;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1246;
  assign select_1246 = equal_588_s1_q ? {and_1245, xor_1244, parity_1238, parity_1217, xor_1172, xor_1077} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_574_s1_q ? 6'h0 : select_1246;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1248;
  assign select_1248 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1249;
  assign difference_1249 = {1'b0, column_2} - {1'b0, select_1248};
  logic [7:0] sum_1251;
  assign sum_1251 = {difference_1249[6], difference_1249} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:222
  logic and_1252;
  assign and_1252 = right_codes_rdata_q[27] & not_578_s1_q;
  logic [11:0] select_1253;
  assign select_1253 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1257;
  assign select_1257 = and_762 ? (and_1252 ? (~(select_764 ^ select_1253)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1263;
  assign parity_1263 = ^select_1257[5:3];
  logic parity_1266;
  assign parity_1266 = ^select_1257[8:6];
  logic parity_1269;
  assign parity_1269 = ^select_1257[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1276;
  assign select_1276 = and_785 ? (and_763 ? (~(select_787 ^ select_765)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1279;
  assign parity_1279 = ^select_1276[8:6];
  logic parity_1282;
  assign parity_1282 = ^select_1276[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1289;
  assign select_1289 = and_802 ? (and_786 ? (~(select_804 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1295;
  assign parity_1295 = ^select_1289[2:0];
  logic parity_1298;
  assign parity_1298 = ^select_1289[5:3];
  logic parity_1301;
  assign parity_1301 = ^select_1289[8:0];
  logic parity_1307;
  assign parity_1307 = ^select_1289[11:9];
  logic parity_1310;
  assign parity_1310 = ^select_1276[2:0];
  logic parity_1313;
  assign parity_1313 = ^{select_1289[11:9], select_1276[5:0]};
  logic parity_1316;
  assign parity_1316 = ^{select_1289, select_1276, select_1257[2:0]};
  logic xor_1317;
  assign xor_1317 = parity_1269 ^ parity_1316;
  // hls/stages/count_bits.hpp:23
  logic or_1321;
  assign or_1321 = (select_1257[1:0] == 2'h3) | (select_1257[2] & (select_1257[0] | select_1257[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1325;
  assign or_1325 = (select_1276[7:6] == 2'h3) | (select_1276[8] & (select_1276[6] | select_1276[7]));
  logic or_1329;
  assign or_1329 = (select_1276[10:9] == 2'h3) | (select_1276[11] & (select_1276[9] | select_1276[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1337;
  assign or_1337 = (select_1289[7:6] == 2'h3) | (select_1289[8] & (~(select_1289[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1341;
  assign or_1341 = (select_1289[1:0] == 2'h3) | (select_1289[2] & (select_1289[0] | select_1289[1]));
  logic or_1345;
  assign or_1345 = (select_1289[4:3] == 2'h3) | (select_1289[5] & (select_1289[3] | select_1289[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1348;
  assign parity_1348 = ^{or_1345, or_1341, or_1337};
  // hls/stages/count_bits.hpp:23
  logic or_1352;
  assign or_1352 = (select_1276[4:3] == 2'h3) | (select_1276[5] & (select_1276[3] | select_1276[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1356;
  assign or_1356 = (select_1289[10:9] == 2'h3) | (select_1289[11] & (select_1289[9] | select_1289[10]));
  logic or_1360;
  assign or_1360 = (select_1276[1:0] == 2'h3) | (select_1276[2] & (select_1276[0] | select_1276[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1363;
  assign parity_1363 = ^{or_1360, or_1356, or_1352};
  logic parity_1366;
  assign parity_1366 = ^{or_1360, or_1356, or_1352, or_1345, or_1341, or_1337, or_1329, or_1325, or_1321};
  // hls/stages/count_bits.hpp:25
  logic and_1367;
  assign and_1367 = parity_1269 & parity_1316;
  logic or_1371;
  assign or_1371 = (parity_1263 & parity_1266) | ((^select_1257[11:9]) & (parity_1263 | parity_1266));
  logic and_1374;
  assign and_1374 = (^{select_1276[11:6], select_1257[2:0]}) & (parity_1301 | parity_1313);
  logic or_1375;
  assign or_1375 = (parity_1301 & parity_1313) | and_1374;
  // hls/stages/count_bits.hpp:23
  logic or_1382;
  assign or_1382 = (select_1257[10:9] == 2'h3) | (select_1257[11] & (select_1257[9] | select_1257[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = (select_1257[4:3] == 2'h3) | (select_1257[5] & (select_1257[3] | select_1257[4]));
  logic or_1390;
  assign or_1390 = (select_1257[7:6] == 2'h3) | (select_1257[8] & (select_1257[6] | select_1257[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1393;
  assign parity_1393 = ^{or_1390, or_1386, or_1382};
  // hls/stages/count_bits.hpp:25
  logic or_1397;
  assign or_1397 = (parity_1279 & parity_1282) | ((^select_1257[2:0]) & (parity_1279 | parity_1282));
  logic or_1401;
  assign or_1401 = (parity_1295 & parity_1298) | ((^select_1289[8:6]) & (parity_1295 | parity_1298));
  logic or_1405;
  assign or_1405 = (parity_1307 & parity_1310) | ((^select_1276[5:3]) & (parity_1307 | parity_1310));
  // hls/stages/count_bits.hpp:24
  logic parity_1408;
  assign parity_1408 = ^{or_1405, or_1401, or_1397};
  logic parity_1411;
  assign parity_1411 = ^{or_1405, or_1401, or_1397, or_1390, or_1386, or_1382, or_1375, or_1371, and_1367};
  logic xor_1412;
  assign xor_1412 = parity_1366 ^ parity_1411;
  // hls/stages/count_bits.hpp:25
  logic and_1413;
  assign and_1413 = parity_1366 & parity_1411;
  logic or_1417;
  assign or_1417 = (parity_1348 & parity_1363) | ((^{or_1329, or_1325, or_1321}) & (parity_1348 | parity_1363));
  logic or_1421;
  assign or_1421 = (parity_1393 & parity_1408) | ((^{or_1375, or_1371, and_1367}) & (parity_1393 | parity_1408));
  logic or_1428;
  assign or_1428 = (or_1325 & or_1329) | (or_1321 & (or_1325 | or_1329));
  logic or_1432;
  assign or_1432 = (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
  logic or_1436;
  assign or_1436 = (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
  // hls/stages/count_bits.hpp:24
  logic parity_1439;
  assign parity_1439 = ^{or_1436, or_1432, or_1428};
  // hls/stages/count_bits.hpp:25
  logic or_1443;
  assign or_1443 = (or_1371 & or_1375) | (and_1367 & (or_1371 | or_1375));
  logic or_1447;
  assign or_1447 = (or_1386 & or_1390) | (or_1382 & (or_1386 | or_1390));
  logic or_1451;
  assign or_1451 = (or_1401 & or_1405) | (or_1397 & (or_1401 | or_1405));
  // hls/stages/count_bits.hpp:24
  logic parity_1454;
  assign parity_1454 = ^{or_1451, or_1447, or_1443};
  logic parity_1457;
  assign parity_1457 = ^{or_1451, or_1447, or_1443, or_1436, or_1432, or_1428, or_1421, or_1417, and_1413};
  // hls/stages/count_bits.hpp:25
  logic or_1461;
  assign or_1461 = (parity_1439 & parity_1454) | ((^{or_1421, or_1417, and_1413}) & (parity_1439 | parity_1454));
  logic or_1465;
  assign or_1465 = (or_1417 & or_1421) | (and_1413 & (or_1417 | or_1421));
  logic or_1469;
  assign or_1469 = (or_1432 & or_1436) | (or_1428 & (or_1432 | or_1436));
  logic or_1473;
  assign or_1473 = (or_1447 & or_1451) | (or_1443 & (or_1447 | or_1451));
  // hls/stages/count_bits.hpp:24
  logic parity_1478;
  assign parity_1478 = ^{or_1473, or_1469, or_1465, or_1461};
  // hls/stages/count_bits.hpp:25
  logic or_1482;
  assign or_1482 = (or_1469 & or_1473) | (or_1465 & (or_1469 | or_1473));
  logic and_1483;
  assign and_1483 = or_1461 & (^{or_1473, or_1469, or_1465});
  // hls/stages/count_bits.hpp:24
  logic xor_1484;
  assign xor_1484 = or_1482 ^ and_1483;
  // hls/stages/count_bits.hpp:27
  logic and_1485;
  assign and_1485 = or_1482 & and_1483;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1486;
  assign select_1486 = equal_588_s1_q ? {and_1485, xor_1484, parity_1478, parity_1457, xor_1412, xor_1317} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_574_s1_q ? 6'h0 : select_1486;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1488;
  assign select_1488 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1489;
  assign difference_1489 = {1'b0, column_3} - {1'b0, select_1488};
  logic [7:0] sum_1491;
  assign sum_1491 = {difference_1489[6], difference_1489} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1499;
  assign select_1499 = and_762 ? (and_803 ? (~(select_764 ^ select_805)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1505;
  assign parity_1505 = ^select_1499[5:3];
  logic parity_1508;
  assign parity_1508 = ^select_1499[8:6];
  logic parity_1511;
  assign parity_1511 = ^select_1499[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1518;
  assign select_1518 = and_785 ? (and_1044 ? (~(select_787 ^ select_1045)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1521;
  assign parity_1521 = ^select_1518[8:6];
  logic parity_1524;
  assign parity_1524 = ^select_1518[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] xor_1530;
  assign xor_1530 = select_804 ^ (less_577_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1533;
  assign select_1533 = and_802 ? ((right_codes_rdata_q[98] & not_578_s1_q) ? (~xor_1530) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1539;
  assign parity_1539 = ^select_1533[2:0];
  logic parity_1542;
  assign parity_1542 = ^select_1533[5:3];
  logic parity_1545;
  assign parity_1545 = ^select_1533[8:0];
  logic parity_1551;
  assign parity_1551 = ^select_1533[11:9];
  logic parity_1554;
  assign parity_1554 = ^select_1518[2:0];
  logic parity_1557;
  assign parity_1557 = ^{select_1533[11:9], select_1518[5:0]};
  logic parity_1560;
  assign parity_1560 = ^{select_1533, select_1518, select_1499[2:0]};
  logic xor_1561;
  assign xor_1561 = parity_1511 ^ parity_1560;
  // hls/stages/count_bits.hpp:23
  logic or_1565;
  assign or_1565 = (select_1499[1:0] == 2'h3) | (select_1499[2] & (select_1499[0] | select_1499[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1569;
  assign or_1569 = (select_1518[7:6] == 2'h3) | (select_1518[8] & (select_1518[6] | select_1518[7]));
  logic or_1573;
  assign or_1573 = (select_1518[10:9] == 2'h3) | (select_1518[11] & (select_1518[9] | select_1518[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1581;
  assign or_1581 = (select_1533[7:6] == 2'h3) | (select_1533[8] & (~(select_1533[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1585;
  assign or_1585 = (select_1533[1:0] == 2'h3) | (select_1533[2] & (select_1533[0] | select_1533[1]));
  logic or_1589;
  assign or_1589 = (select_1533[4:3] == 2'h3) | (select_1533[5] & (select_1533[3] | select_1533[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1592;
  assign parity_1592 = ^{or_1589, or_1585, or_1581};
  // hls/stages/count_bits.hpp:23
  logic or_1596;
  assign or_1596 = (select_1518[4:3] == 2'h3) | (select_1518[5] & (select_1518[3] | select_1518[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1600;
  assign or_1600 = (select_1533[10:9] == 2'h3) | (select_1533[11] & (select_1533[9] | select_1533[10]));
  logic or_1604;
  assign or_1604 = (select_1518[1:0] == 2'h3) | (select_1518[2] & (select_1518[0] | select_1518[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1607;
  assign parity_1607 = ^{or_1604, or_1600, or_1596};
  logic parity_1610;
  assign parity_1610 = ^{or_1604, or_1600, or_1596, or_1589, or_1585, or_1581, or_1573, or_1569, or_1565};
  // hls/stages/count_bits.hpp:25
  logic and_1611;
  assign and_1611 = parity_1511 & parity_1560;
  logic or_1615;
  assign or_1615 = (parity_1505 & parity_1508) | ((^select_1499[11:9]) & (parity_1505 | parity_1508));
  logic and_1618;
  assign and_1618 = (^{select_1518[11:6], select_1499[2:0]}) & (parity_1545 | parity_1557);
  logic or_1619;
  assign or_1619 = (parity_1545 & parity_1557) | and_1618;
  // hls/stages/count_bits.hpp:23
  logic or_1626;
  assign or_1626 = (select_1499[10:9] == 2'h3) | (select_1499[11] & (select_1499[9] | select_1499[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1630;
  assign or_1630 = (select_1499[4:3] == 2'h3) | (select_1499[5] & (select_1499[3] | select_1499[4]));
  logic or_1634;
  assign or_1634 = (select_1499[7:6] == 2'h3) | (select_1499[8] & (select_1499[6] | select_1499[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1637;
  assign parity_1637 = ^{or_1634, or_1630, or_1626};
  // hls/stages/count_bits.hpp:25
  logic or_1641;
  assign or_1641 = (parity_1521 & parity_1524) | ((^select_1499[2:0]) & (parity_1521 | parity_1524));
  logic or_1645;
  assign or_1645 = (parity_1539 & parity_1542) | ((^select_1533[8:6]) & (parity_1539 | parity_1542));
  logic or_1649;
  assign or_1649 = (parity_1551 & parity_1554) | ((^select_1518[5:3]) & (parity_1551 | parity_1554));
  // hls/stages/count_bits.hpp:24
  logic parity_1652;
  assign parity_1652 = ^{or_1649, or_1645, or_1641};
  logic parity_1655;
  assign parity_1655 = ^{or_1649, or_1645, or_1641, or_1634, or_1630, or_1626, or_1619, or_1615, and_1611};
  logic xor_1656;
  assign xor_1656 = parity_1610 ^ parity_1655;
  // hls/stages/count_bits.hpp:25
  logic and_1657;
  assign and_1657 = parity_1610 & parity_1655;
  logic or_1661;
  assign or_1661 = (parity_1592 & parity_1607) | ((^{or_1573, or_1569, or_1565}) & (parity_1592 | parity_1607));
  logic or_1665;
  assign or_1665 = (parity_1637 & parity_1652) | ((^{or_1619, or_1615, and_1611}) & (parity_1637 | parity_1652));
  logic or_1672;
  assign or_1672 = (or_1569 & or_1573) | (or_1565 & (or_1569 | or_1573));
  logic or_1676;
  assign or_1676 = (or_1585 & or_1589) | (or_1581 & (or_1585 | or_1589));
  logic or_1680;
  assign or_1680 = (or_1600 & or_1604) | (or_1596 & (or_1600 | or_1604));
  // hls/stages/count_bits.hpp:24
  logic parity_1683;
  assign parity_1683 = ^{or_1680, or_1676, or_1672};
  // hls/stages/count_bits.hpp:25
  logic or_1687;
  assign or_1687 = (or_1615 & or_1619) | (and_1611 & (or_1615 | or_1619));
  logic or_1691;
  assign or_1691 = (or_1630 & or_1634) | (or_1626 & (or_1630 | or_1634));
  logic or_1695;
  assign or_1695 = (or_1645 & or_1649) | (or_1641 & (or_1645 | or_1649));
  // hls/stages/count_bits.hpp:24
  logic parity_1698;
  assign parity_1698 = ^{or_1695, or_1691, or_1687};
  logic parity_1701;
  assign parity_1701 = ^{or_1695, or_1691, or_1687, or_1680, or_1676, or_1672, or_1665, or_1661, and_1657};
  // hls/stages/count_bits.hpp:25
  logic or_1705;
  assign or_1705 = (parity_1683 & parity_1698) | ((^{or_1665, or_1661, and_1657}) & (parity_1683 | parity_1698));
  logic or_1709;
  assign or_1709 = (or_1661 & or_1665) | (and_1657 & (or_1661 | or_1665));
  logic or_1713;
  assign or_1713 = (or_1676 & or_1680) | (or_1672 & (or_1676 | or_1680));
  logic or_1717;
  assign or_1717 = (or_1691 & or_1695) | (or_1687 & (or_1691 | or_1695));
  // hls/stages/count_bits.hpp:24
  logic parity_1722;
  assign parity_1722 = ^{or_1717, or_1713, or_1709, or_1705};
  // hls/stages/count_bits.hpp:25
  logic or_1726;
  assign or_1726 = (or_1713 & or_1717) | (or_1709 & (or_1713 | or_1717));
  logic and_1727;
  assign and_1727 = or_1705 & (^{or_1717, or_1713, or_1709});
  // hls/stages/count_bits.hpp:24
  logic xor_1728;
  assign xor_1728 = or_1726 ^ and_1727;
  // hls/stages/count_bits.hpp:27
  logic and_1729;
  assign and_1729 = or_1726 & and_1727;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1730;
  assign select_1730 = equal_588_s1_q ? {and_1729, xor_1728, parity_1722, parity_1701, xor_1656, xor_1561} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_574_s1_q ? 6'h0 : select_1730;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1732;
  assign select_1732 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1733;
  assign difference_1733 = {1'b0, column_4} - {1'b0, select_1732};
  logic [7:0] sum_1735;
  assign sum_1735 = {difference_1733[6], difference_1733} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:694
  logic [11:0] not_1739;
  assign not_1739 = ~(select_764 ^ (less_577_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1741;
  assign select_1741 = and_762 ? ((right_codes_rdata_q[12] & not_578_s1_q) ? not_1739 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1747;
  assign parity_1747 = ^select_1741[5:3];
  logic parity_1750;
  assign parity_1750 = ^select_1741[8:6];
  logic parity_1753;
  assign parity_1753 = ^select_1741[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1760;
  assign select_1760 = and_785 ? (and_1252 ? (~(select_787 ^ select_1253)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1763;
  assign parity_1763 = ^select_1760[8:6];
  logic parity_1766;
  assign parity_1766 = ^select_1760[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1773;
  assign select_1773 = and_802 ? (and_763 ? (~(select_804 ^ select_765)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1779;
  assign parity_1779 = ^select_1773[2:0];
  logic parity_1782;
  assign parity_1782 = ^select_1773[5:3];
  logic parity_1785;
  assign parity_1785 = ^select_1773[8:0];
  logic parity_1791;
  assign parity_1791 = ^select_1773[11:9];
  logic parity_1794;
  assign parity_1794 = ^select_1760[2:0];
  logic parity_1797;
  assign parity_1797 = ^{select_1773[11:9], select_1760[5:0]};
  logic parity_1800;
  assign parity_1800 = ^{select_1773, select_1760, select_1741[2:0]};
  logic xor_1801;
  assign xor_1801 = parity_1753 ^ parity_1800;
  // hls/stages/count_bits.hpp:23
  logic or_1805;
  assign or_1805 = (select_1741[1:0] == 2'h3) | (select_1741[2] & (select_1741[0] | select_1741[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1809;
  assign or_1809 = (select_1760[7:6] == 2'h3) | (select_1760[8] & (select_1760[6] | select_1760[7]));
  logic or_1813;
  assign or_1813 = (select_1760[10:9] == 2'h3) | (select_1760[11] & (select_1760[9] | select_1760[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1821;
  assign or_1821 = (select_1773[7:6] == 2'h3) | (select_1773[8] & (~(select_1773[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1825;
  assign or_1825 = (select_1773[1:0] == 2'h3) | (select_1773[2] & (select_1773[0] | select_1773[1]));
  logic or_1829;
  assign or_1829 = (select_1773[4:3] == 2'h3) | (select_1773[5] & (select_1773[3] | select_1773[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1832;
  assign parity_1832 = ^{or_1829, or_1825, or_1821};
  // hls/stages/count_bits.hpp:23
  logic or_1836;
  assign or_1836 = (select_1760[4:3] == 2'h3) | (select_1760[5] & (select_1760[3] | select_1760[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1840;
  assign or_1840 = (select_1773[10:9] == 2'h3) | (select_1773[11] & (select_1773[9] | select_1773[10]));
  logic or_1844;
  assign or_1844 = (select_1760[1:0] == 2'h3) | (select_1760[2] & (select_1760[0] | select_1760[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1847;
  assign parity_1847 = ^{or_1844, or_1840, or_1836};
  logic parity_1850;
  assign parity_1850 = ^{or_1844, or_1840, or_1836, or_1829, or_1825, or_1821, or_1813, or_1809, or_1805};
  // hls/stages/count_bits.hpp:25
  logic and_1851;
  assign and_1851 = parity_1753 & parity_1800;
  logic or_1855;
  assign or_1855 = (parity_1747 & parity_1750) | ((^select_1741[11:9]) & (parity_1747 | parity_1750));
  logic and_1858;
  assign and_1858 = (^{select_1760[11:6], select_1741[2:0]}) & (parity_1785 | parity_1797);
  logic or_1859;
  assign or_1859 = (parity_1785 & parity_1797) | and_1858;
  // hls/stages/count_bits.hpp:23
  logic or_1866;
  assign or_1866 = (select_1741[10:9] == 2'h3) | (select_1741[11] & (select_1741[9] | select_1741[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1870;
  assign or_1870 = (select_1741[4:3] == 2'h3) | (select_1741[5] & (select_1741[3] | select_1741[4]));
  logic or_1874;
  assign or_1874 = (select_1741[7:6] == 2'h3) | (select_1741[8] & (select_1741[6] | select_1741[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1877;
  assign parity_1877 = ^{or_1874, or_1870, or_1866};
  // hls/stages/count_bits.hpp:25
  logic or_1881;
  assign or_1881 = (parity_1763 & parity_1766) | ((^select_1741[2:0]) & (parity_1763 | parity_1766));
  logic or_1885;
  assign or_1885 = (parity_1779 & parity_1782) | ((^select_1773[8:6]) & (parity_1779 | parity_1782));
  logic or_1889;
  assign or_1889 = (parity_1791 & parity_1794) | ((^select_1760[5:3]) & (parity_1791 | parity_1794));
  // hls/stages/count_bits.hpp:24
  logic parity_1892;
  assign parity_1892 = ^{or_1889, or_1885, or_1881};
  logic parity_1895;
  assign parity_1895 = ^{or_1889, or_1885, or_1881, or_1874, or_1870, or_1866, or_1859, or_1855, and_1851};
  logic xor_1896;
  assign xor_1896 = parity_1850 ^ parity_1895;
  // hls/stages/count_bits.hpp:25
  logic and_1897;
  assign and_1897 = parity_1850 & parity_1895;
  logic or_1901;
  assign or_1901 = (parity_1832 & parity_1847) | ((^{or_1813, or_1809, or_1805}) & (parity_1832 | parity_1847));
  logic or_1905;
  assign or_1905 = (parity_1877 & parity_1892) | ((^{or_1859, or_1855, and_1851}) & (parity_1877 | parity_1892));
  logic or_1912;
  assign or_1912 = (or_1809 & or_1813) | (or_1805 & (or_1809 | or_1813));
  logic or_1916;
  assign or_1916 = (or_1825 & or_1829) | (or_1821 & (or_1825 | or_1829));
  logic or_1920;
  assign or_1920 = (or_1840 & or_1844) | (or_1836 & (or_1840 | or_1844));
  // hls/stages/count_bits.hpp:24
  logic parity_1923;
  assign parity_1923 = ^{or_1920, or_1916, or_1912};
  // hls/stages/count_bits.hpp:25
  logic or_1927;
  assign or_1927 = (or_1855 & or_1859) | (and_1851 & (or_1855 | or_1859));
  logic or_1931;
  assign or_1931 = (or_1870 & or_1874) | (or_1866 & (or_1870 | or_1874));
  logic or_1935;
  assign or_1935 = (or_1885 & or_1889) | (or_1881 & (or_1885 | or_1889));
  // hls/stages/count_bits.hpp:24
  logic parity_1938;
  assign parity_1938 = ^{or_1935, or_1931, or_1927};
  logic parity_1941;
  assign parity_1941 = ^{or_1935, or_1931, or_1927, or_1920, or_1916, or_1912, or_1905, or_1901, and_1897};
  // hls/stages/count_bits.hpp:25
  logic or_1945;
  assign or_1945 = (parity_1923 & parity_1938) | ((^{or_1905, or_1901, and_1897}) & (parity_1923 | parity_1938));
  logic or_1949;
  assign or_1949 = (or_1901 & or_1905) | (and_1897 & (or_1901 | or_1905));
  logic or_1953;
  assign or_1953 = (or_1916 & or_1920) | (or_1912 & (or_1916 | or_1920));
  logic or_1957;
  assign or_1957 = (or_1931 & or_1935) | (or_1927 & (or_1931 | or_1935));
  // hls/stages/count_bits.hpp:24
  logic parity_1962;
  assign parity_1962 = ^{or_1957, or_1953, or_1949, or_1945};
  // hls/stages/count_bits.hpp:25
  logic or_1966;
  assign or_1966 = (or_1953 & or_1957) | (or_1949 & (or_1953 | or_1957));
  logic and_1967;
  assign and_1967 = or_1945 & (^{or_1957, or_1953, or_1949});
  // hls/stages/count_bits.hpp:24
  logic xor_1968;
  assign xor_1968 = or_1966 ^ and_1967;
  // hls/stages/count_bits.hpp:27
  logic and_1969;
  assign and_1969 = or_1966 & and_1967;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1970;
  assign select_1970 = equal_588_s1_q ? {and_1969, xor_1968, parity_1962, parity_1941, xor_1896, xor_1801} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_574_s1_q ? 6'h0 : select_1970;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1972;
  assign select_1972 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1973;
  assign difference_1973 = {1'b0, column_5} - {1'b0, select_1972};
  logic [7:0] sum_1975;
  assign sum_1975 = {difference_1973[6], difference_1973} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:798
  logic and_2046;
  assign and_2046 = ends_cell_s1_q & inside_v;
  logic and_2048;
  assign and_2048 = not_570 & (so_s1_q & and_2046);
  logic [6:0] select_2052;
  assign select_2052 = so_s1_q ? x_s1_q[6:0] : (or_574_s1_q ? (less_577_s1_q ? 7'h0 : select_620) : 7'h0);
  // hls/stages/agreement.hpp:248
  logic or_2056;
  assign or_2056 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
  logic and_2065;
  assign and_2065 = or_574_s1_q & (slot_s1_q[2] & not_578_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2178;
  assign select_2178 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2178[16:7])) ? 8'h7f : select_2178[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_2255_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2255_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_2342;
  assign less_2342 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_2343;
  assign or_2343 = equal_2254_s1_q | less_2342;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2348;
  assign select_2348 = equal_2254_s1_q ? patches_column_s1_q[0] : (or_2343 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2349;
  assign not_2349 = ~or_2343;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_2350;
  assign sum_2350 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_2353;
  assign select_2353 = or_2343 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2350) + 5'h1) : sum_2350;
  // hls/stages/patches.hpp:509
  logic [4:0] select_2354;
  assign select_2354 = equal_2254_s1_q ? 5'h0 : select_2353;
  logic or_2355;
  assign or_2355 = equal_2254_s1_q | equal_2252_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_2357;
  assign equal_2357 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2359;
  assign equal_2359 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_2361;
  assign and_2361 = of_row & (~equal_2359);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2357 ? 2'h3 : {equal_2359, and_2361};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_2364;
  assign sum_2364 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2365;
  assign sum_2365 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2364, pixel_2[0]} - {1'b0, sum_2365, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_2367;
  assign sum_2367 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2368;
  assign sum_2368 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2367[11], sum_2367};
  logic [13:0] sum_2369;
  assign sum_2369 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2368, down_2[1]};
  logic [12:0] sum_2370;
  assign sum_2370 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2369[13:1];
  logic [14:0] sum_2371;
  assign sum_2371 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2370, sum_2369[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_2378;
  assign or_2378 = (sum_2371[8] & (~(sum_2371[7:0] == 8'h0))) | (~(sum_2371[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_2383;
  assign sum_2383 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2384;
  assign sum_2384 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2383};
  logic [10:0] sum_2385;
  assign sum_2385 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2384, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2386;
  assign sum_2386 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2385[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_2386, sum_2385[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_2388;
  assign sum_2388 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2389;
  assign sum_2389 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2390;
  assign difference_2390 = {1'b0, sum_2388, smooth[0]} - {1'b0, sum_2389, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_2397;
  assign or_2397 = (difference_2390[8] & (~(difference_2390[7:0] == 8'h0))) | (~(difference_2390[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_2405;
  assign or_2405 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2359) | equal_2357;
  // hls/stages/patches.hpp:481
  logic and_2410;
  assign and_2410 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:276
  logic and_2414;
  assign and_2414 = not_2253_s1_q & (or_2256_s1_q & (or_2405 & (equal_2255_s1_q & and_2410)));
  // hls/stages/patches.hpp:174
  logic and_2424;
  assign and_2424 = (~(equal_2255_s1_q | (~and_2410))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
  logic and_2428;
  assign and_2428 = not_2253_s1_q & (or_2256_s1_q & (and_2424 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_2430;
  assign less_2430 = patches_step_q[4:0] < 5'h11;
  logic equal_2431;
  assign equal_2431 = patches_step_q[6:5] == 2'h2;
  logic equal_2432;
  assign equal_2432 = patches_step_q[6:5] == 2'h1;
  logic or_2433;
  assign or_2433 = equal_2431 | equal_2432;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2457;
  assign sum_2457 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1290
  logic or_2502;
  assign or_2502 = sample_pair_first_q | line_ended_q;
  // hls/stages/agreement.hpp:1292
  logic [16:0] select_2504;
  assign select_2504 = sample_pair_first_q ? 17'h1 : (or_2502 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1291
  logic [8:0] select_2506;
  assign select_2506 = or_2502 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1299
  logic select_2508;
  assign select_2508 = cfg_compete_i ? (or_2502 & select_2504[16]) : (select_2506[8] & select_2504[9]);
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2508 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1306
  logic [6:0] select_2511;
  assign select_2511 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2513;
  assign select_2513 = sample_pair_first_q ? 13'h0 : (seen_base_q + {6'h0, select_2511});
  // hls/stages/agreement.hpp:1317
  logic equal_2514;
  assign equal_2514 = seen_x_q == 3'h7;
  // hls/stages/agreement.hpp:1289
  logic not_2521;
  assign not_2521 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:461
  logic [5:0] or_2752;
  assign or_2752 = last_s1_2_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:465
  logic select_3036;
  assign select_3036 = equal_2942_s1_q ? (~({row_s1_q, 1'b0} < {sum_3033, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_3039;
  assign and_3039 = proven_q & less_3038;
  // hls/stages/agreement.hpp:530
  logic select_3043;
  assign select_3043 = and_544_s1_q ? (equal_2942_s1_q ? (and_3039 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_3044;
  assign equal_3044 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_3045;
  assign and_3045 = and_3039 & equal_3044;
  // hls/stages/agreement.hpp:530
  logic and_3296;
  assign and_3296 = and_544_s1_q & (equal_2942_s1_q & equal_3044);
  // hls/stages/registration.hpp:128
  logic and_3297;
  assign and_3297 = and_2943_s1_q & and_3296;
  // hls/stages/registration.hpp:127
  logic and_3299;
  assign and_3299 = and_2943_s1_q & (~and_3296);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3300;
  assign select_3300 = and_3299 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3302;
  assign select_3302 = and_3297 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3300[15]}}, select_3300});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3303;
  assign select_3303 = and_3299 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3303[15]}}, select_3303};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3305;
  assign select_3305 = and_3297 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_3306;
  assign and_3306 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_3306 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3551;
  assign select_3551 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3554;
  assign select_3554 = equal_2252_s1_q ? patches_smooth_values_0_q : (or_2256_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3556;
  assign select_3556 = or_2256_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3558;
  assign select_3558 = equal_2250_s1_q ? patches_smooth_values_1_q : (equal_2252_s1_q ? patches_smooth_values_1_q : select_3556);
  logic [11:0] select_3559;
  assign select_3559 = or_2256_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3561;
  assign select_3561 = equal_2250_s1_q ? patches_smooth_values_2_q : (equal_2252_s1_q ? patches_smooth_values_2_q : select_3559);
  logic [11:0] select_3562;
  assign select_3562 = or_2256_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3564;
  assign select_3564 = equal_2250_s1_q ? patches_smooth_values_3_q : (equal_2252_s1_q ? patches_smooth_values_3_q : select_3562);
  logic [10:0] select_3566;
  assign select_3566 = equal_2252_s1_q ? patches_down_values_0_q : (or_2256_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3569;
  assign select_3569 = equal_2252_s1_q ? patches_down_values_1_q : (or_2256_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3572;
  assign select_3572 = equal_2252_s1_q ? patches_down_values_2_q : (or_2256_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3575;
  assign select_3575 = equal_2252_s1_q ? patches_down_values_3_q : (or_2256_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3612;
  assign and_3612 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3617;
  assign select_3617 = or_3512_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3619;
  assign select_3619 = and_3612 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3975;
  assign select_3975 = equal_2250_s1_q ? patches_summed_down_by_q : (equal_2252_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3993;
  assign select_3993 = equal_2250_s1_q ? (less_2430 & (equal_2432 & or_2433)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_4298;
  assign select_4298 = so_s1_q ? (and_3306 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4300;
  assign sum_4300 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4301;
  assign select_4301 = sum_2457[5] ? {1'b1, sum_2457[4:0], region_across_rest_q[2:0]} : sum_4300;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4303;
  assign select_4303 = equal_2942_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4306;
  assign select_4306 = equal_2942_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1162
  logic equal_4356;
  assign equal_4356 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:1316
  logic [2:0] select_4523;
  assign select_4523 = select_2508 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4529;
  assign select_4529 = sample_pair_first_q ? select_4527 : (seen_rows_left_q - {7'h0, was_next_row_q});

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

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:155; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1393; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_574_s1_q ? select_620 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_611_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1394; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_2048;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1395; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_2065;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1395; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_620;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2065;
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
  assign patches_right_codes_raddr = {select_2354, not_2349, select_2348};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2355;
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
  assign patches_left_codes_re = s1_en & (not_2251_s1_q & (new_row & equal_2252_s1_q));
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
  assign patches_rows_re = s1_en & (equal_2250_s1_q & (less_2430 & or_2433));
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1422; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2048;
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
  assign left_we = s1_en & and_649_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_751, left_rdata_q[65:49], and_750, left_rdata_q[47:31], and_749, left_rdata_q[29:13], and_748, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_649_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_757, right_codes_rdata_q[84:73], and_756, right_codes_rdata_q[71:60], and_755, right_codes_rdata_q[56:43], and_754, right_codes_rdata_q[41:28], and_753, right_codes_rdata_q[26:13], and_752, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2336_s1_q;
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
      row_q <= and_544_s1_q ? (equal_2942_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_544_s1_q ? select_3036 : lower_half_q;
      late_q <= select_3043;
      registration_slope_row_q <= select_3302;
      registration_slope_change_q <= select_3305;
      registration_slope_q <= so_s1_q ? column_7 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3536_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3536_s1_q & select_3551;
      patches_smooth_values_0_q <= equal_2250_s1_q ? patches_smooth_values_0_q : select_3554;
      patches_smooth_values_1_q <= select_3558;
      patches_smooth_values_2_q <= select_3561;
      patches_smooth_values_3_q <= select_3564;
      patches_down_values_0_q <= equal_2250_s1_q ? patches_down_values_0_q : select_3566;
      patches_down_values_1_q <= equal_2250_s1_q ? patches_down_values_1_q : select_3569;
      patches_down_values_2_q <= equal_2250_s1_q ? patches_down_values_2_q : select_3572;
      patches_down_values_3_q <= equal_2250_s1_q ? patches_down_values_3_q : select_3575;
      patches_down_by_q <= or_3512_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3612});
      patches_along_q <= select_3617;
      patches_match_row_q <= or_3512_s1_q ? 4'h0 : select_3619;
      patches_summed_last_q <= not_2251_s1_q & (equal_2252_s1_q & and_3612);
      patches_summed_down_by_q <= select_3975;
      patches_step_q <= or_3512_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3993;
      region_across_rest_q <= select_4298;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4301;
      columns_begin_rest_q <= and_544_s1_q ? select_4303 : columns_begin_rest_q;
      columns_begin_back_q <= and_544_s1_q ? select_4306 : columns_begin_back_q;
      done_q <= not_2521 & ((~drew_q) & (done_q | said_q));
      proven_q <= sample_pair_first_q ? done_q : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_569_s1_q & equal_4356;
      rows_passed_q <= select_2504;
      columns_passed_q <= {select_2506[7:0], or_2502};
      line_ended_q <= sample_last_q;
      began_q <= not_2521 & (began_q | select_2508);
      seen_x_q <= select_2508 ? 3'h0 : (seen_x_q + 3'h1);
      seen_y_q <= sample_pair_first_q ? 3'h0 : select_4523;
      seen_column_q <= select_2508 ? 8'h0 : (seen_column_q + {7'h0, equal_2514});
      seen_rows_left_q <= select_4529;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2513;
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
      middle_sum_sum_sums_values_0_q <= sum_1011;
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1251;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1491;
      sums_2_columns_values_0_q <= column_4;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1735;
      sums_3_columns_values_0_q <= column_5;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1975;
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
  logic and_602_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_634_s2_q;
  logic and_637_s2_q;
  logic and_643_s2_q;
  logic and_645_s2_q;
  logic equal_678_s2_q;
  logic and_2035_s2_q;
  logic equal_2036_s2_q;
  logic and_2046_s2_q;
  logic and_2048_s2_q;
  logic [6:0] select_2052_s2_q;
  logic or_2056_s2_q;
  logic and_2159_s2_q;
  logic less_2173_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2250_s2_q;
  logic equal_2252_s2_q;
  logic equal_2255_s2_q;
  logic or_2256_s2_q;
  logic not_2257_s2_q;
  logic [4:0] select_2280_s2_q;
  logic select_2286_s2_q;
  logic [3:0] select_2326_s2_q;
  logic less_2342_s2_q;
  logic new_row_s2_q;
  logic or_2355_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_2372_s2_q;
  logic or_2378_s2_q;
  logic and_2382_s2_q;
  logic and_2398_s2_q;
  logic and_2401_s2_q;
  logic and_2415_s2_q;
  logic and_2424_s2_q;
  logic and_2429_s2_q;
  logic less_2430_s2_q;
  logic equal_2431_s2_q;
  logic or_2433_s2_q;
  logic sum_2457_s2_q;
  logic not_2467_s2_q;
  logic and_2481_s2_q;
  logic less_2599_s2_q;
  logic equal_2753_s2_q;
  logic equal_2942_s2_q;
  logic and_3045_s2_q;
  logic and_3059_s2_q;
  logic equal_3148_s2_q;
  logic less_3588_s2_q;
  logic equal_3931_s2_q;
  logic equal_4028_s2_q;
  logic less_4284_s2_q;
  logic equal_4356_s2_q;
  logic or_4506_s2_q;
  logic not_4549_s2_q;
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
      and_602_s2_q <= (or_574_s1_q & (left_rdata_q[68] & not_578_s1_q)) & and_601;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_634_s2_q <= (or_574_s1_q & (left_rdata_q[70] & not_578_s1_q)) & less_633;
      and_637_s2_q <= or_574_s1_q & (left_rdata_q[71] & not_578_s1_q);
      and_643_s2_q <= and_643;
      and_645_s2_q <= or_574_s1_q & (right_codes_rdata_q[59] & not_578_s1_q);
      equal_678_s2_q <= row_s1_q == 6'h0;
      and_2035_s2_q <= and_2035_s1_q;
      equal_2036_s2_q <= equal_2036_s1_q;
      and_2046_s2_q <= and_2046;
      and_2048_s2_q <= and_2048;
      select_2052_s2_q <= select_2052;
      or_2056_s2_q <= or_2056;
      and_2159_s2_q <= and_2159_s1_q;
      less_2173_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2250_s2_q <= equal_2250_s1_q;
      equal_2252_s2_q <= equal_2252_s1_q;
      equal_2255_s2_q <= equal_2255_s1_q;
      or_2256_s2_q <= or_2256_s1_q;
      not_2257_s2_q <= not_2257_s1_q;
      select_2280_s2_q <= select_2280_s1_q;
      select_2286_s2_q <= select_2286_s1_q;
      select_2326_s2_q <= select_2326_s1_q;
      less_2342_s2_q <= less_2342;
      new_row_s2_q <= new_row;
      or_2355_s2_q <= or_2355;
      of_row_2_s2_q <= of_row_2;
      not_2372_s2_q <= ~sum_2371[14];
      or_2378_s2_q <= or_2378;
      and_2382_s2_q <= sum_2371[14] & (~(sum_2371[13:8] == 6'h3f));
      and_2398_s2_q <= (~difference_2390[14]) & or_2397;
      and_2401_s2_q <= difference_2390[14] & (~(difference_2390[13:8] == 6'h3f));
      and_2415_s2_q <= not_2251_s1_q & and_2414;
      and_2424_s2_q <= and_2424;
      and_2429_s2_q <= not_2251_s1_q & and_2428;
      less_2430_s2_q <= less_2430;
      equal_2431_s2_q <= equal_2431;
      or_2433_s2_q <= or_2433;
      sum_2457_s2_q <= sum_2457[5];
      not_2467_s2_q <= ~late_q;
      and_2481_s2_q <= or_574_s1_q & (left_rdata_q[69] & not_578_s1_q);
      less_2599_s2_q <= 6'h6 < row_q;
      equal_2753_s2_q <= {last_s1_2_q[6], or_2752} == 7'h0;
      equal_2942_s2_q <= equal_2942_s1_q;
      and_3045_s2_q <= and_3045;
      and_3059_s2_q <= or_574_s1_q & (not_578_s1_q & and_601);
      equal_3148_s2_q <= shift == 6'h0;
      less_3588_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3931_s2_q <= patches_match_row_q == 4'h0;
      equal_4028_s2_q <= patches_step_q[6:5] == 2'h3;
      less_4284_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4356_s2_q <= equal_4356;
      or_4506_s2_q <= and_3045 | (~(row_s1_q[5:3] == 3'h0));
      not_4549_s2_q <= ~proven_q;
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
  logic select_615;
  assign select_615 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_625;
  assign difference_625 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_626;
  assign sum_626 = {difference_625[8], difference_625} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_628;
  assign and_628 = (and_602_s2_q & select_615) & ({{22{sum_626[9]}}, sum_626} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_630;
  assign and_630 = or_574_s2_q & (not_578_s2_q & and_628);
  // hls/stages/moments.hpp:89
  logic and_635;
  assign and_635 = and_630 & and_634_s2_q;
  // hls/stages/census.hpp:308
  logic less_651;
  assign less_651 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_663;
  assign less_663 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_675;
  assign equal_675 = last_s2_2_q == 7'h0;
  logic [3:0] select_679;
  assign select_679 = equal_678_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_680;
  assign select_680 = equal_675 ? {select_679, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_681;
  assign select_681 = equal_675 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_682;
  assign and_682 = select_680[4] & select_681[3];
  // hls/stages/census.hpp:300
  logic and_684;
  assign and_684 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_686;
  assign and_686 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_684);
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_686;
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
  logic [9:0] difference_709;
  assign difference_709 = {1'b0, select_550} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_710;
  assign xor_710 = difference_709[8:0] ^ {9{difference_709[9]}};
  logic [9:0] sum_711;
  assign sum_711 = {9'h0, difference_709[9]} + {1'b0, xor_710};
  logic [9:0] difference_712;
  assign difference_712 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_713;
  assign xor_713 = difference_712[8:0] ^ {9{difference_712[9]}};
  logic [9:0] sum_714;
  assign sum_714 = {9'h0, difference_712[9]} + {1'b0, xor_713};
  logic [9:0] difference_716;
  assign difference_716 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_717;
  assign xor_717 = difference_716[8:0] ^ {9{difference_716[9]}};
  logic [9:0] sum_718;
  assign sum_718 = {9'h0, difference_716[9]} + {1'b0, xor_717};
  logic [10:0] sum_719;
  assign sum_719 = ({1'b0, sum_711} + {1'b0, sum_714}) + {1'b0, sum_718};
  logic [9:0] difference_720;
  assign difference_720 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_721;
  assign xor_721 = difference_720[8:0] ^ {9{difference_720[9]}};
  logic [9:0] sum_722;
  assign sum_722 = {9'h0, difference_720[9]} + {1'b0, xor_721};
  logic [9:0] difference_724;
  assign difference_724 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_725;
  assign xor_725 = difference_724[8:0] ^ {9{difference_724[9]}};
  // hls/stages/agreement.hpp:461
  logic and_733;
  assign and_733 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_734;
  assign and_734 = and_682 & and_733;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_736;
  assign sum_736 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_738;
  assign and_738 = and_734 & ({{5{sum_736[6]}}, sum_736, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_742;
  assign sum_742 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:817
  logic or_759;
  assign or_759 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:818
  logic select_761;
  assign select_761 = or_759 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:761
  logic less_1492;
  assign less_1492 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1493;
  assign select_1493 = less_1492 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1494;
  assign less_1494 = middle_sum_sum_sums_values_0_q < select_1493;
  logic [7:0] select_1495;
  assign select_1495 = less_1494 ? select_1493 : middle_sum_sum_sums_values_0_q;
  logic less_1976;
  assign less_1976 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1977;
  assign select_1977 = less_1976 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1978;
  assign less_1978 = select_1495 < select_1977;
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1978 ? select_1977 : select_1495) : 8'h0;
  // hls/stages/agreement.hpp:818
  logic or_1982;
  assign or_1982 = select_761 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:823
  logic [5:0] select_1983;
  assign select_1983 = or_1982 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:762
  logic or_1985;
  assign or_1985 = less_1492 | (~less_1494);
  logic [2:0] select_1986;
  assign select_1986 = less_1978 ? {less_1976, 2'h0} : {1'b0, or_1985, less_1494};
  // hls/stages/agreement.hpp:823
  logic [2:0] select_1987;
  assign select_1987 = or_1982 ? select_1986 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1988;
  assign select_1988 = or_1982 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:820
  logic equal_1989;
  assign equal_1989 = select_1986 == 3'h1;
  logic or_1992;
  assign or_1992 = equal_1989 | (~(select_1986 == 3'h2));
  logic [7:0] select_1994;
  assign select_1994 = or_1992 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1995;
  assign select_1995 = equal_1989 ? (or_1992 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1994;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1996;
  assign select_1996 = or_1982 ? select_1995 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:821
  logic [7:0] select_1997;
  assign select_1997 = or_1992 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1999;
  assign select_1999 = or_1982 ? (equal_1989 ? select_1994 : select_1997) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2001;
  assign sum_2001 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_2002;
  assign sum_2002 = {1'b0, before_v} + sum_2001;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2004;
  assign sum_2004 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_2005;
  assign sum_2005 = {1'b0, before_v_2} + sum_2004;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_2008;
  assign sum_2008 = {1'b0, before_v_3} + sum_2007;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2010;
  assign select_2010 = (sum_2005 < sum_2008) ? sum_2008 : sum_2005;
  logic [6:0] select_2012;
  assign select_2012 = (sum_2002 < select_2010) ? select_2010 : sum_2002;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2014;
  assign sum_2014 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2015;
  assign sum_2015 = {1'b0, before_v_4} + sum_2014;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_2017;
  assign sum_2017 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2018;
  assign sum_2018 = {1'b0, before_v_5} + sum_2017;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2020;
  assign select_2020 = (sum_2015 < sum_2018) ? sum_2018 : sum_2015;
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2012 < select_2020) ? select_2020 : select_2012) : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_2024;
  assign less_2024 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:827
  logic [6:0] select_2026;
  assign select_2026 = select_761 ? of_near : (less_2024 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2028;
  assign select_2028 = select_761 ? run_shift_s2_q : (less_2024 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2031;
  assign select_2031 = (run_shift_s2_q == 6'h3f) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2034;
  assign select_2034 = (run_shift_s2_q == 6'h1) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:833
  logic select_2037;
  assign select_2037 = or_759 ? shift_first_s2_q : equal_2036_s2_q;
  // hls/stages/agreement.hpp:834
  logic or_2039;
  assign or_2039 = select_2037 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:838
  logic [7:0] select_2040;
  assign select_2040 = or_2039 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2041;
  assign select_2041 = or_2039 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2043;
  assign or_2043 = select_2037 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:842
  logic [6:0] select_2044;
  assign select_2044 = or_2043 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2045;
  assign select_2045 = or_2043 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_2059;
  assign and_2059 = or_574_s2_q & (not_578_s2_q & (and_628 & or_2056_s2_q));
  // hls/stages/agreement.hpp:798
  logic and_2060;
  assign and_2060 = not_572_s2_q & and_2059;
  logic and_2063;
  assign and_2063 = not_570_s2_q & (drew_q ? and_2046_s2_q : (equal_573_s2_q & and_630));
  // hls/stages/moments.hpp:85
  logic and_2067;
  assign and_2067 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1015
  logic and_2068;
  assign and_2068 = not_582_s2_q & and_2067;
  logic and_2071;
  assign and_2071 = not_582_s2_q & (and_2067 & (moments_memory_rdata_q[1] ^ and_637_s2_q));
  // hls/stages/moments.hpp:85
  logic and_2076;
  assign and_2076 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1015
  logic and_2077;
  assign and_2077 = not_582_s2_q & and_2076;
  logic and_2080;
  assign and_2080 = not_582_s2_q & (and_2076 & (moments_memory_rdata_q[3] ^ and_645_s2_q));
  // hls/stages/agreement.hpp:1143
  logic equal_2081;
  assign equal_2081 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1193
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1144
  logic [1:0] select_2084;
  assign select_2084 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1157
  logic [3:0] select_2086;
  assign select_2086 = equal_2081 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2084});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2087;
  assign sum_2087 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_2088;
  assign select_2088 = equal_569_s2_q ? select_2086 : {sum_2087, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_2089;
  assign equal_2089 = x_s2_q[5:0] == 6'h3f;
  logic equal_2091;
  assign equal_2091 = x_s2_q[5:0] == 6'h3e;
  logic equal_2093;
  assign equal_2093 = x_s2_q[5:0] == 6'h3d;
  logic equal_2095;
  assign equal_2095 = x_s2_q[5:0] == 6'h3c;
  logic equal_2097;
  assign equal_2097 = x_s2_q[5:0] == 6'h3b;
  logic equal_2099;
  assign equal_2099 = x_s2_q[5:0] == 6'h36;
  logic equal_2101;
  assign equal_2101 = x_s2_q[5:0] == 6'h35;
  logic equal_2103;
  assign equal_2103 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1193
  logic and_2107;
  assign and_2107 = (~equal_2097) & ((~equal_2099) & ((~equal_2101) & (~equal_2103)));
  logic and_2111;
  assign and_2111 = (~equal_2089) & ((~equal_2091) & ((~equal_2093) & ((~equal_2095) & and_2107)));
  // hls/stages/agreement.hpp:1144
  logic less_2112;
  assign less_2112 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2116;
  assign or_2116 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1022
  logic [5:0] sum_2121;
  assign sum_2121 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2121, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2127;
  assign sum_2127 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2129;
  assign and_2129 = half_ends & ({{3{sum_2127[4]}}, sum_2127} < 8'h3);
  // hls/stages/agreement.hpp:798
  logic and_2130;
  assign and_2130 = drew_q & and_2129;
  logic select_2131;
  assign select_2131 = equal_569_s2_q ? (x_s2_q[6] & (equal_2081 ? and_2111 : (less_2112 & (~or_2116)))) : and_2130;
  // hls/stages/registration.hpp:258
  logic not_2133;
  assign not_2133 = ~lower_half_s2_q;
  logic [3:0] select_2134;
  assign select_2134 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2133, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2133};
  // hls/stages/patches.hpp:377
  logic [1:0] select_2160;
  assign select_2160 = and_2159_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2161;
  assign select_2161 = and_2159_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_2162;
  assign select_2162 = row_starts_s2_q ? {select_2161, select_2160[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2163;
  assign select_2163 = row_starts_s2_q ? select_2160 : patches_fetch_q;
  logic equal_2164;
  assign equal_2164 = select_2163 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:798
  logic and_2172;
  assign and_2172 = not_570_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2174;
  assign equal_2174 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_574_s2_q ? (less_577_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2174 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2182;
  assign select_2182 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2183;
  assign select_2183 = b[1] ? a : 8'h0;
  logic [8:0] sum_2184;
  assign sum_2184 = {{2{select_2182[6]}}, select_2182} + {select_2183[7], select_2183};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2185;
  assign select_2185 = b[2] ? a : 8'h0;
  logic [7:0] select_2186;
  assign select_2186 = b[3] ? a : 8'h0;
  logic [8:0] sum_2187;
  assign sum_2187 = {{2{select_2185[7]}}, select_2185[7:1]} + {select_2186[7], select_2186};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2188;
  assign sum_2188 = {{3{sum_2184[8]}}, sum_2184[8:1]} + {sum_2187[8], sum_2187, select_2185[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2189;
  assign select_2189 = b[4] ? a : 8'h0;
  logic [7:0] select_2190;
  assign select_2190 = b[5] ? a : 8'h0;
  logic [8:0] difference_2191;
  assign difference_2191 = {{2{select_2189[7]}}, select_2189[7:1]} - {select_2190[7], select_2190};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2192;
  assign sum_2192 = {difference_2191, select_2189[0]} + {sum_2188[10], sum_2188[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2174 ? {sum_2192, sum_2188[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2194;
  assign sum_2194 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:263
  logic and_2197;
  assign and_2197 = less_2173_s2_q & (and_630 & ({{4{sum_2194[9]}}, sum_2194, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2201;
  assign and_2201 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2207;
  assign sum_2207 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2209;
  assign sum_2209 = {sum_2207[9], sum_2207[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1031
  logic and_2212;
  assign and_2212 = ($signed(9'h0) < $signed(sum_2207[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2209, sum_2207[0]})));
  logic and_2213;
  assign and_2213 = (~(and_2201 | (equal_564_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2212;
  // hls/stages/agreement.hpp:798
  logic and_2217;
  assign and_2217 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2197 & and_2213)));
  logic and_2218;
  assign and_2218 = not_570_s2_q & and_2217;
  // hls/stages/patches.hpp:157
  logic and_2220;
  assign and_2220 = and_2218 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_2221;
  assign select_2221 = and_2220 ? and_2218 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2224;
  assign select_2224 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2226;
  assign select_2226 = and_2220 ? (equal_569_s2_q ? 8'h0 : select_2224) : patches_choice_column_q;
  // hls/stages/agreement.hpp:798
  logic [5:0] select_2229;
  assign select_2229 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_2231;
  assign select_2231 = and_2220 ? (equal_569_s2_q ? 6'h0 : select_2229) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2232;
  assign sum_2232 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2192[9]}}, sum_2192[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2235;
  assign select_2235 = ($signed(sum_2232[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2232[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2174 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2232[12:7])) ? 8'h7f : select_2235);
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2240;
  assign select_2240 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_2242;
  assign select_2242 = and_2220 ? (equal_569_s2_q ? 8'h0 : select_2240) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2243;
  assign equal_2243 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:798
  logic and_2247;
  assign and_2247 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2201 | equal_2243)));
  logic and_2248;
  assign and_2248 = not_570_s2_q & and_2247;
  // hls/stages/patches.hpp:348
  logic and_2249;
  assign and_2249 = patches_chooses_s2_q & and_2248;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2263;
  assign select_2263 = row_starts_s2_q ? select_2161 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_2264;
  assign equal_2264 = {patches_choosing_band_s2_q, and_2172} == {select_2263, select_2163[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_2363;
  assign sum_2363 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_2379;
  assign and_2379 = not_2372_s2_q & or_2378_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_2419;
  assign sum_2419 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_2444;
  assign select_2444 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1064
  logic or_2447;
  assign or_2447 = select_2444[7] | (~({select_2444[5], select_2444[3], select_2444[1]} == 3'h0));
  // hls/stages/agreement.hpp:1063
  logic or_2450;
  assign or_2450 = select_2444[7] | (~({select_2444[6], select_2444[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1062
  logic or_2453;
  assign or_2453 = select_2444[7] | (~(select_2444[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_2454;
  assign select_2454 = equal_569_s2_q ? x_s2_q[5:0] : {region_row_q, or_2453, or_2450, or_2447};
  // hls/stages/agreement.hpp:1143
  logic not_2455;
  assign not_2455 = ~equal_2081;
  // hls/stages/agreement.hpp:1072
  logic or_2459;
  assign or_2459 = (~sum_2457_s2_q) | equal_2243;
  // hls/stages/agreement.hpp:798
  logic and_2462;
  assign and_2462 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2459));
  // hls/stages/agreement.hpp:150
  logic and_2466;
  assign and_2466 = or_574_s2_q & (not_578_s2_q & and_602_s2_q);
  logic and_2483;
  assign and_2483 = or_574_s2_q & (not_578_s2_q & and_2481_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2466;
  logic and_2494;
  assign and_2494 = inside_v_s2_q & and_2483;
  logic explained;
  assign explained = inside_v_s2_q & and_630;
  // hls/stages/agreement.hpp:1027
  logic select_2496;
  assign select_2496 = slot_s2_q[2] ? shown_shown_q : and_630;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2496);
  // hls/stages/agreement.hpp:1027
  logic select_2499;
  assign select_2499 = slot_s2_q[2] ? shown_nearer_q : and_2059;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2496 ? select_2499 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1324
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1290
  logic select_2519;
  assign select_2519 = marks_first_s2_q ? (done_s2_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1276
  logic [7:0] sum_2520;
  assign sum_2520 = {1'b0, select_2519, 2'h0, select_2519, 1'b0, {2{select_2519}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1323
  logic and_2527;
  assign and_2527 = began_q & (seen_x_q == 3'h0);
  logic less_2528;
  assign less_2528 = seen_column_q < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1126
  logic [7:0] sum_2531;
  assign sum_2531 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2531[7]}}, sum_2531, x_s2_q[1:0]} + map_row_q;
  logic select_2533;
  assign select_2533 = draws_late_q ? read_half_q : write_half_q;
  // hls/stages/agreement.hpp:1276
  logic [7:0] sum_2534;
  assign sum_2534 = {1'b0, select_2533, 2'h0, select_2533, 1'b0, {2{select_2533}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1043
  logic and_2535;
  assign and_2535 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2536;
  assign and_2536 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2537;
  assign and_2537 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2538;
  assign and_2538 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2540;
  assign sum_2540 = {1'b0, and_2537} + ({1'b0, textured} + {1'b0, and_2538});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2535} + ({2'h0, and_2536} + {1'b0, sum_2540});
  // hls/stages/agreement.hpp:1043
  logic [7:0] select_2549;
  assign select_2549 = inside_v_s2_q ? (sum_2457_s2_q ? select_2444 : {select_2444[6:0], 1'b0}) : select_2444;
  // hls/stages/agreement.hpp:1064
  logic or_2552;
  assign or_2552 = select_2549[7] | (~({select_2549[5], select_2549[3], select_2549[1]} == 3'h0));
  // hls/stages/agreement.hpp:1043
  logic and_2569;
  assign and_2569 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2570;
  assign and_2570 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2571;
  assign and_2571 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2572;
  assign and_2572 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2574;
  assign sum_2574 = {1'b0, and_2571} + ({1'b0, shown} + {1'b0, and_2572});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2569} + ({2'h0, and_2570} + {1'b0, sum_2574});
  // hls/stages/agreement.hpp:1043
  logic and_2585;
  assign and_2585 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2586;
  assign and_2586 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2587;
  assign and_2587 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2588;
  assign and_2588 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_2590;
  assign sum_2590 = {1'b0, and_2587} + ({1'b0, near} + {1'b0, and_2588});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2585} + ({2'h0, and_2586} + {1'b0, sum_2590});
  // hls/stages/agreement.hpp:1125
  logic not_2601;
  assign not_2601 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1126
  logic not_2603;
  assign not_2603 = ~({sum_2121, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:798
  logic select_2607;
  assign select_2607 = less_2599_s2_q ? (not_2601 & not_2603) : ((draws_late_q & not_2601) & not_2603);
  logic and_2610;
  assign and_2610 = not_570_s2_q & (drew_q & (ends_cell_s2_q & select_2607));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2644;
  assign select_2644 = sample_pair_whole_s2_q ? (and_542_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2646;
  assign select_2646 = sample_pair_whole_s2_q ? (and_542_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2666;
  assign select_2666 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2668;
  assign select_2668 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_557 : averager_mask_q) : averager_mask_q;
  logic select_2670;
  assign select_2670 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_561 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2671;
  assign select_2671 = and_544_s2_q ? select_550 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_544_s2_q ? select_554 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2674;
  assign select_2674 = and_544_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_544_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2676;
  assign select_2676 = and_544_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_544_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_544_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2679;
  assign select_2679 = and_544_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2680;
  assign select_2680 = and_544_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2681;
  assign select_2681 = and_544_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2682;
  assign select_2682 = and_544_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2683;
  assign select_2683 = and_544_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2684;
  assign select_2684 = and_544_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2685;
  assign select_2685 = and_544_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2686;
  assign select_2686 = and_544_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2687;
  assign select_2687 = and_544_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_544_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2689;
  assign select_2689 = and_544_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2690;
  assign select_2690 = and_544_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2691;
  assign select_2691 = and_544_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2692;
  assign select_2692 = and_544_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2693;
  assign select_2693 = and_544_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2694;
  assign select_2694 = and_544_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2695;
  assign select_2695 = and_544_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2696;
  assign select_2696 = and_544_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2697;
  assign select_2697 = and_544_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2698;
  assign select_2698 = and_544_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2699;
  assign select_2699 = and_544_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2700;
  assign select_2700 = and_544_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2701;
  assign select_2701 = and_544_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2702;
  assign select_2702 = and_544_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2703;
  assign select_2703 = and_544_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2704;
  assign select_2704 = and_544_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2705;
  assign select_2705 = and_544_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2706;
  assign select_2706 = and_544_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2707;
  assign select_2707 = and_544_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2708;
  assign select_2708 = and_544_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2709;
  assign select_2709 = and_544_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2710;
  assign select_2710 = and_544_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2711;
  assign select_2711 = and_544_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2712;
  assign select_2712 = and_544_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2713;
  assign select_2713 = and_544_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2714;
  assign select_2714 = and_544_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2715;
  assign select_2715 = and_544_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2716;
  assign select_2716 = and_544_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2717;
  assign select_2717 = and_544_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2718;
  assign select_2718 = and_544_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2719;
  assign select_2719 = and_544_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2720;
  assign select_2720 = and_544_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2721;
  assign select_2721 = and_544_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2722;
  assign select_2722 = and_544_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2723;
  assign select_2723 = and_544_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2724;
  assign select_2724 = and_544_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2725;
  assign select_2725 = and_544_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2726;
  assign select_2726 = and_544_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2728;
  assign difference_2728 = {1'b0, select_554} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2729;
  assign xor_2729 = difference_2728[8:0] ^ {9{difference_2728[9]}};
  logic [9:0] sum_2730;
  assign sum_2730 = {9'h0, difference_2728[9]} + {1'b0, xor_2729};
  logic [9:0] difference_2731;
  assign difference_2731 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2732;
  assign xor_2732 = difference_2731[8:0] ^ {9{difference_2731[9]}};
  logic [9:0] sum_2733;
  assign sum_2733 = {9'h0, difference_2731[9]} + {1'b0, xor_2732};
  logic [9:0] difference_2735;
  assign difference_2735 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2736;
  assign xor_2736 = difference_2735[8:0] ^ {9{difference_2735[9]}};
  logic [9:0] sum_2737;
  assign sum_2737 = {9'h0, difference_2735[9]} + {1'b0, xor_2736};
  logic [10:0] sum_2738;
  assign sum_2738 = ({1'b0, sum_2730} + {1'b0, sum_2733}) + {1'b0, sum_2737};
  logic [9:0] difference_2739;
  assign difference_2739 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2740;
  assign xor_2740 = difference_2739[8:0] ^ {9{difference_2739[9]}};
  logic [9:0] sum_2741;
  assign sum_2741 = {9'h0, difference_2739[9]} + {1'b0, xor_2740};
  logic [9:0] difference_2743;
  assign difference_2743 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2744;
  assign xor_2744 = difference_2743[8:0] ^ {9{difference_2743[9]}};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2765;
  assign sum_2765 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2767;
  assign sum_2767 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1157
  logic equal_2768;
  assign equal_2768 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:153
  logic [13:0] select_2769;
  assign select_2769 = equal_2768 ? sum_2765 : moments_before_0_q;
  logic [13:0] select_2771;
  assign select_2771 = equal_2768 ? sum_2767 : moments_before_1_q;
  // hls/stages/agreement.hpp:798
  logic select_2774;
  assign select_2774 = equal_569_s2_q ? (moments_has_before_q | equal_2768) : moments_has_before_q;
  logic [13:0] select_2777;
  assign select_2777 = equal_569_s2_q ? ((select_2771 < select_2769) ? select_2769 : select_2771) : moments_most_before_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2778;
  assign sum_2778 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2781;
  assign select_2781 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2778)) : moments_left_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2782;
  assign sum_2782 = {1'b0, sum_2767} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2785;
  assign select_2785 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2782)) : moments_left_alone_q;
  logic select_2788;
  assign select_2788 = equal_569_s2_q ? (~({3'h0, select_2771[13:2]} < sum_2782)) : moments_left_other_stops_q;
  logic select_2791;
  assign select_2791 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2778)) : moments_right_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2792;
  assign sum_2792 = {1'b0, sum_2765} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2795;
  assign select_2795 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2792)) : moments_right_alone_q;
  logic select_2798;
  assign select_2798 = equal_569_s2_q ? (~({3'h0, select_2769[13:2]} < sum_2792)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:798
  logic and_2809;
  assign and_2809 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2071)));
  logic and_2813;
  assign and_2813 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_2080)));
  // hls/stages/moments.hpp:106
  logic and_2815;
  assign and_2815 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2818;
  assign select_2818 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2815)) : and_2815;
  // hls/stages/agreement.hpp:798
  logic and_2822;
  assign and_2822 = equal_569_s2_q & (equal_2768 & (cfg_prove_i & (cfg_same_table_i & select_2818)));
  // hls/stages/moments.hpp:107
  logic and_2825;
  assign and_2825 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2839;
  assign difference_2839 = {1'b0, select_550} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2839[9]} + (difference_2839[8:0] ^ {9{difference_2839[9]}});
  logic [9:0] difference_2851;
  assign difference_2851 = {1'b0, select_554} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2851[9]} + (difference_2851[8:0] ^ {9{difference_2851[9]}});
  // hls/stages/agreement.hpp:530
  logic select_3047;
  assign select_3047 = and_544_s2_q ? (equal_2942_s2_q ? and_3045_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:798
  logic not_3049;
  assign not_3049 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3050;
  assign less_3050 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:530
  logic and_3057;
  assign and_3057 = and_544_s2_q & (equal_678_s2_q & equal_2942_s2_q);
  // hls/stages/agreement.hpp:798
  logic and_3062;
  assign and_3062 = ends_cell_s2_q & (inside_v_s2_q & (and_3059_s2_q & not_2467_s2_q));
  // hls/stages/agreement.hpp:1043
  logic and_3086;
  assign and_3086 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3087;
  assign and_3087 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3088;
  assign and_3088 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3089;
  assign and_3089 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1102
  logic [1:0] sum_3091;
  assign sum_3091 = {1'b0, and_3088} + ({1'b0, explained} + {1'b0, and_3089});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3086} + ({2'h0, and_3087} + {1'b0, sum_3091});
  // hls/stages/agreement.hpp:798
  logic and_3127;
  assign and_3127 = ends_cell_s2_q & (inside_v_s2_q & (not_2467_s2_q & (and_3059_s2_q & and_2483)));
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_3152;
  assign difference_3152 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3155;
  assign less_3155 = {2'h0, difference_3152[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_3158;
  assign and_3158 = not_578_s2_q & (((and_2481_s2_q & and_628) & equal_3148_s2_q) & (~less_3155));
  // hls/stages/agreement.hpp:798
  logic and_3162;
  assign and_3162 = ends_cell_s2_q & (inside_v_s2_q & ((or_574_s2_q & and_3158) & not_2467_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_3168;
  assign and_3168 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_3170;
  assign and_3170 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3171;
  assign select_3171 = or_574_s2_q ? {and_3170, and_3168} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_3173;
  assign select_3173 = less_577_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_3174;
  assign select_3174 = or_574_s2_q ? select_3173 : 2'h0;
  // hls/stages/agreement.hpp:1040
  logic and_3176;
  assign and_3176 = and_630 & (select_3171[0] & select_3174[0]);
  // hls/stages/agreement.hpp:798
  logic and_3180;
  assign and_3180 = ends_cell_s2_q & (inside_v_s2_q & (not_2467_s2_q & (select_3171[1] & and_3176)));
  logic and_3182;
  assign and_3182 = not_570_s2_q & (drew_q & and_3180);
  logic and_3188;
  assign and_3188 = ends_cell_s2_q & (inside_v_s2_q & (not_2467_s2_q & (select_3174[1] & and_3176)));
  logic and_3190;
  assign and_3190 = not_570_s2_q & (drew_q & and_3188);
  // hls/stages/registration.hpp:76
  logic less_3193;
  assign less_3193 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_3195;
  assign select_3195 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3197;
  assign select_3197 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3199;
  assign select_3199 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3197} - {1'b0, select_3199};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3201;
  assign select_3201 = rise_2[8] ? select_3197 : select_3199;
  logic [8:0] fall;
  assign fall = {1'b0, select_3195} - {1'b0, select_3201};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3204;
  assign not_3204 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3193 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3204};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3206;
  assign xor_3206 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3206};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3212;
  assign select_3212 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3193 ? {taken, 1'b1} : {not_3204, select_3212, not_3204};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3214;
  assign sum_3214 = {left, 1'b1} + {taken_2, less_3193};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_3216;
  assign select_3216 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3218;
  assign select_3218 = equal_569_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_3220;
  assign select_3220 = equal_569_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3221;
  assign equal_3221 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_3225;
  assign and_3225 = and_630 & less_2173_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_3227;
  assign select_3227 = or_574_s2_q ? (less_577_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3231;
  assign sum_3231 = select_3227[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3234;
  assign select_3234 = (select_3197 < select_3199) ? ({sum_3231, select_3227[0], 5'h0} - {3'h0, select_3216}) : {sum_3231, select_3227[0], select_3216};
  logic [7:0] select_3235;
  assign select_3235 = ((select_3227 == 3'h0) | (select_3227 == 3'h4)) ? {sum_3231, select_3227[0], 5'h0} : select_3234;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3235[7]}}, select_3235} - {sum_2192[9], sum_2192, sum_2188[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3238;
  assign select_3238 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3238[11:7])) ? 12'h7f : select_3238;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3259;
  assign difference_3259 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3261;
  assign and_3261 = and_3225 & ($signed(difference_3259) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3274;
  assign less_3274 = $signed(difference_3259) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:798
  logic select_3282;
  assign select_3282 = drew_q ? (equal_3221 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3285;
  assign select_3285 = drew_q ? (equal_2174 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3290;
  assign select_3290 = (sum_2087 == 2'h2) ? (registration_fresh_q & (~select_2134)) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_3292;
  assign select_3292 = drew_q ? (and_2129 ? select_3290 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3294;
  assign select_3294 = and_3057 ? 4'hf : (equal_569_s2_q ? registration_fresh_q : select_3292);
  // hls/stages/agreement.hpp:1144
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2084;
  // hls/stages/registration.hpp:258
  logic not_3314;
  assign not_3314 = ~quarter_2[1];
  logic [3:0] select_3315;
  assign select_3315 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3314, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3314};
  // hls/stages/patches.hpp:91
  logic parity_3449;
  assign parity_3449 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3450;
  assign select_3450 = equal_2942_s2_q ? {patches_chance_q[14:0], parity_3449} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3452;
  assign not_3452 = ~and_2248;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3455;
  assign select_3455 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3455};
  // hls/stages/agreement.hpp:798
  logic and_3461;
  assign and_3461 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3465;
  assign and_3465 = not_3452 & (patches_fixed_q | ((not_570_s2_q & and_3461) & and_2220));
  // hls/stages/patches.hpp:358
  logic not_3477;
  assign not_3477 = ~select_2163[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3479;
  assign select_3479 = sample_pair_whole_s2_q ? (equal_2164 ? select_2163 : {not_3477, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3578;
  assign select_3578 = or_2256_s2_q ? {and_2401_s2_q, and_2398_s2_q, and_2382_s2_q, and_2379, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3580;
  assign select_3580 = equal_2250_s2_q ? patches_codes_at_q : (equal_2252_s2_q ? other[55:4] : select_3578);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_2355_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3583;
  assign select_3583 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3585;
  assign select_3585 = equal_2252_s2_q ? (new_row_s2_q ? word : select_3583) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3587;
  assign select_3587 = less_2342_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3589;
  assign select_3589 = less_3588_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3591;
  assign select_3591 = or_2256_s2_q ? (equal_2255_s2_q ? patches_next_codes_q : select_3589) : patches_next_codes_q;
  logic [55:0] select_3593;
  assign select_3593 = equal_2250_s2_q ? patches_next_codes_q : (equal_2252_s2_q ? select_3587 : select_3591);
  // hls/stages/count_bits.hpp:24
  logic parity_3598;
  assign parity_3598 = ^{and_2401_s2_q, and_2398_s2_q, and_2382_s2_q, and_2379};
  // hls/stages/count_bits.hpp:25
  logic or_3602;
  assign or_3602 = ({and_2382_s2_q, and_2379} == 2'h3) | (and_2398_s2_q & (and_2382_s2_q | and_2379));
  logic and_3603;
  assign and_3603 = and_2401_s2_q & (^{and_2398_s2_q, and_2382_s2_q, and_2379});
  // hls/stages/count_bits.hpp:24
  logic xor_3604;
  assign xor_3604 = or_3602 ^ and_3603;
  // hls/stages/count_bits.hpp:27
  logic and_3605;
  assign and_3605 = or_3602 & and_3603;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3607;
  assign select_3607 = or_2256_s2_q ? (and_2424_s2_q ? {and_3605, xor_3604, parity_3598} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3611;
  assign sum_3611 = {7'h0, patches_set_q} + (equal_2255_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3621;
  assign select_3621 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3623;
  assign select_3623 = equal_2250_s2_q ? patches_left_row_q : (equal_2252_s2_q ? select_3621 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3621;
  // hls/stages/count_bits.hpp:24
  logic xor_3627;
  assign xor_3627 = bits[17] ^ (^{select_3621[16:15], other[16:15]});
  logic xor_3630;
  assign xor_3630 = bits[11] ^ (^{select_3621[10:9], other[10:9]});
  logic xor_3633;
  assign xor_3633 = bits[14] ^ (^{select_3621[13:12], other[13:12]});
  logic xor_3636;
  assign xor_3636 = xor_3627 ^ (^{select_3621[14:9], other[14:9]});
  logic xor_3639;
  assign xor_3639 = bits[47] ^ (^{select_3621[46:45], other[46:45]});
  logic xor_3642;
  assign xor_3642 = bits[8] ^ (^{select_3621[7:6], other[7:6]});
  logic xor_3645;
  assign xor_3645 = bits[2] ^ (^{select_3621[1:0], other[1:0]});
  logic xor_3648;
  assign xor_3648 = bits[5] ^ (^{select_3621[4:3], other[4:3]});
  logic xor_3651;
  assign xor_3651 = xor_3642 ^ (^{select_3621[5:0], other[5:0]});
  logic parity_3653;
  assign parity_3653 = ^{select_3621[47:45], select_3621[8:0], other[47:45], other[8:0]};
  logic xor_3654;
  assign xor_3654 = xor_3636 ^ parity_3653;
  logic xor_3657;
  assign xor_3657 = bits[44] ^ (^{select_3621[43:42], other[43:42]});
  logic xor_3660;
  assign xor_3660 = bits[38] ^ (^{select_3621[37:36], other[37:36]});
  logic xor_3663;
  assign xor_3663 = bits[41] ^ (^{select_3621[40:39], other[40:39]});
  logic xor_3669;
  assign xor_3669 = bits[26] ^ (^{select_3621[25:24], other[25:24]});
  logic xor_3672;
  assign xor_3672 = bits[20] ^ (^{select_3621[19:18], other[19:18]});
  logic xor_3675;
  assign xor_3675 = bits[23] ^ (^{select_3621[22:21], other[22:21]});
  logic xor_3678;
  assign xor_3678 = xor_3669 ^ (^{select_3621[23:18], other[23:18]});
  logic xor_3681;
  assign xor_3681 = bits[35] ^ (^{select_3621[34:33], other[34:33]});
  logic xor_3684;
  assign xor_3684 = bits[29] ^ (^{select_3621[28:27], other[28:27]});
  logic xor_3687;
  assign xor_3687 = bits[32] ^ (^{select_3621[31:30], other[31:30]});
  logic xor_3690;
  assign xor_3690 = xor_3681 ^ (^{select_3621[32:27], other[32:27]});
  logic xor_3691;
  assign xor_3691 = xor_3678 ^ xor_3690;
  // hls/stages/count_bits.hpp:25
  logic or_3699;
  assign or_3699 = (xor_3630 & xor_3633) | (xor_3627 & (xor_3630 | xor_3633));
  logic or_3703;
  assign or_3703 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3707;
  assign or_3707 = (xor_3645 & xor_3648) | (xor_3642 & (xor_3645 | xor_3648));
  // hls/stages/count_bits.hpp:23
  logic or_3714;
  assign or_3714 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3718;
  assign or_3718 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3722;
  assign or_3722 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3725;
  assign parity_3725 = ^{or_3722, or_3718, or_3714};
  // hls/stages/count_bits.hpp:23
  logic or_3729;
  assign or_3729 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3733;
  assign or_3733 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3737;
  assign or_3737 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3740;
  assign parity_3740 = ^{or_3737, or_3733, or_3729};
  logic parity_3743;
  assign parity_3743 = ^{or_3737, or_3733, or_3729, or_3722, or_3718, or_3714, or_3707, or_3703, or_3699};
  // hls/stages/count_bits.hpp:23
  logic or_3747;
  assign or_3747 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3751;
  assign or_3751 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3755;
  assign or_3755 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3763;
  assign or_3763 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3767;
  assign or_3767 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3771;
  assign or_3771 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3774;
  assign parity_3774 = ^{or_3771, or_3767, or_3763};
  // hls/stages/count_bits.hpp:23
  logic or_3778;
  assign or_3778 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3782;
  assign or_3782 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3786;
  assign or_3786 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3789;
  assign parity_3789 = ^{or_3786, or_3782, or_3778};
  logic parity_3792;
  assign parity_3792 = ^{or_3786, or_3782, or_3778, or_3771, or_3767, or_3763, or_3755, or_3751, or_3747};
  // hls/stages/count_bits.hpp:25
  logic or_3796;
  assign or_3796 = (xor_3660 & xor_3663) | (xor_3657 & (xor_3660 | xor_3663));
  logic or_3800;
  assign or_3800 = (xor_3672 & xor_3675) | (xor_3669 & (xor_3672 | xor_3675));
  logic or_3804;
  assign or_3804 = (xor_3684 & xor_3687) | (xor_3681 & (xor_3684 | xor_3687));
  // hls/stages/count_bits.hpp:24
  logic parity_3807;
  assign parity_3807 = ^{or_3804, or_3800, or_3796};
  // hls/stages/count_bits.hpp:25
  logic and_3808;
  assign and_3808 = xor_3654 & (^{xor_3691, select_3621[44:36], other[44:36]});
  logic or_3812;
  assign or_3812 = (xor_3639 & xor_3651) | (xor_3636 & (xor_3639 | xor_3651));
  logic and_3815;
  assign and_3815 = (xor_3657 ^ (^{select_3621[41:36], other[41:36]})) & (xor_3678 | xor_3690);
  logic or_3816;
  assign or_3816 = (xor_3678 & xor_3690) | and_3815;
  // hls/stages/count_bits.hpp:24
  logic parity_3819;
  assign parity_3819 = ^{or_3816, or_3812, and_3808};
  logic parity_3822;
  assign parity_3822 = ^{or_3816, or_3812, and_3808, or_3804, or_3800, or_3796, or_3786, or_3782, or_3778, or_3771, or_3767, or_3763, or_3755, or_3751, or_3747};
  logic parity_3824;
  assign parity_3824 = ^{or_3816, or_3812, and_3808, or_3804, or_3800, or_3796, or_3786, or_3782, or_3778, or_3771, or_3767, or_3763, or_3755, or_3751, or_3747, or_3737, or_3733, or_3729, or_3722, or_3718, or_3714, or_3707, or_3703, or_3699};
  // hls/stages/count_bits.hpp:25
  logic and_3825;
  assign and_3825 = parity_3743 & parity_3822;
  logic or_3829;
  assign or_3829 = (parity_3725 & parity_3740) | ((^{or_3707, or_3703, or_3699}) & (parity_3725 | parity_3740));
  logic or_3833;
  assign or_3833 = (parity_3807 & parity_3819) | (parity_3792 & (parity_3807 | parity_3819));
  logic or_3840;
  assign or_3840 = (parity_3774 & parity_3789) | ((^{or_3755, or_3751, or_3747}) & (parity_3774 | parity_3789));
  logic or_3844;
  assign or_3844 = (or_3800 & or_3804) | (or_3796 & (or_3800 | or_3804));
  logic or_3848;
  assign or_3848 = (or_3812 & or_3816) | (and_3808 & (or_3812 | or_3816));
  // hls/stages/count_bits.hpp:23
  logic or_3855;
  assign or_3855 = (or_3751 & or_3755) | (or_3747 & (or_3751 | or_3755));
  // hls/stages/count_bits.hpp:25
  logic or_3859;
  assign or_3859 = (or_3767 & or_3771) | (or_3763 & (or_3767 | or_3771));
  logic or_3863;
  assign or_3863 = (or_3782 & or_3786) | (or_3778 & (or_3782 | or_3786));
  // hls/stages/count_bits.hpp:24
  logic parity_3866;
  assign parity_3866 = ^{or_3863, or_3859, or_3855};
  // hls/stages/count_bits.hpp:23
  logic or_3870;
  assign or_3870 = (or_3703 & or_3707) | (or_3699 & (or_3703 | or_3707));
  // hls/stages/count_bits.hpp:25
  logic or_3874;
  assign or_3874 = (or_3718 & or_3722) | (or_3714 & (or_3718 | or_3722));
  logic or_3878;
  assign or_3878 = (or_3733 & or_3737) | (or_3729 & (or_3733 | or_3737));
  // hls/stages/count_bits.hpp:24
  logic parity_3881;
  assign parity_3881 = ^{or_3878, or_3874, or_3870};
  logic parity_3884;
  assign parity_3884 = ^{or_3878, or_3874, or_3870, or_3863, or_3859, or_3855, or_3848, or_3844, or_3840};
  logic parity_3886;
  assign parity_3886 = ^{or_3878, or_3874, or_3870, or_3863, or_3859, or_3855, or_3848, or_3844, or_3840, or_3833, or_3829, and_3825};
  // hls/stages/count_bits.hpp:25
  logic or_3890;
  assign or_3890 = (or_3844 & or_3848) | (or_3840 & (or_3844 | or_3848));
  logic or_3894;
  assign or_3894 = (or_3859 & or_3863) | (or_3855 & (or_3859 | or_3863));
  logic or_3898;
  assign or_3898 = (or_3874 & or_3878) | (or_3870 & (or_3874 | or_3878));
  // hls/stages/count_bits.hpp:24
  logic parity_3901;
  assign parity_3901 = ^{or_3898, or_3894, or_3890};
  // hls/stages/count_bits.hpp:25
  logic and_3902;
  assign and_3902 = (^{or_3833, or_3829, and_3825}) & parity_3884;
  logic or_3906;
  assign or_3906 = (or_3829 & or_3833) | (and_3825 & (or_3829 | or_3833));
  logic or_3910;
  assign or_3910 = (parity_3866 & parity_3881) | ((^{or_3848, or_3844, or_3840}) & (parity_3866 | parity_3881));
  // hls/stages/count_bits.hpp:24
  logic parity_3913;
  assign parity_3913 = ^{or_3910, or_3906, and_3902};
  // hls/stages/count_bits.hpp:25
  logic and_3915;
  assign and_3915 = parity_3901 & parity_3913;
  logic or_3919;
  assign or_3919 = (or_3894 & or_3898) | (or_3890 & (or_3894 | or_3898));
  logic or_3923;
  assign or_3923 = (or_3906 & or_3910) | (and_3902 & (or_3906 | or_3910));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3968;
  assign select_3968 = equal_2252_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3971;
  assign select_3971 = equal_2250_s2_q ? patches_summed_first_q : (equal_2252_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3979;
  assign select_3979 = less_2430_s2_q ? (or_2433_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3982;
  assign select_3982 = less_2430_s2_q ? (or_2433_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3985;
  assign select_3985 = less_2430_s2_q ? (or_2433_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3990;
  assign select_3990 = equal_2250_s2_q ? (less_2430_s2_q & (or_2433_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3995;
  assign or_3995 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3996;
  assign and_3996 = patches_read_searches_s2_q & or_3995;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3997;
  assign select_3997 = and_3996 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3997};
  // hls/stages/patches.hpp:559
  logic and_4002;
  assign and_4002 = less_2430_s2_q & (or_2433_s2_q & (equal_2431_s2_q & (away == 6'h3f)));
  logic and_4007;
  assign and_4007 = less_2430_s2_q & (or_2433_s2_q & (equal_2431_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_4009;
  assign sum_4009 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_4012;
  assign select_4012 = (equal_2431_s2_q & ({sum_4009[6], sum_4009} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_4014;
  assign select_4014 = less_2430_s2_q ? (or_2433_s2_q ? select_4012 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_4016;
  assign select_4016 = and_3996 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4017;
  assign select_4017 = equal_2250_s2_q ? select_4016[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4018;
  assign select_4018 = equal_2250_s2_q ? select_4016[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_4020;
  assign select_4020 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4021;
  assign select_4021 = equal_2250_s2_q ? select_4020 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_4022;
  assign select_4022 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4023;
  assign select_4023 = equal_2250_s2_q ? select_4022 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_4025;
  assign select_4025 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_4027;
  assign select_4027 = equal_2250_s2_q ? (patches_read_first_q ? patches_read_far_q : select_4025) : patches_peak_far_q;
  logic [9:0] select_4030;
  assign select_4030 = equal_2250_s2_q ? (equal_4028_s2_q ? sum_3611 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:798
  logic select_4281;
  assign select_4281 = equal_569_s2_q ? shown_shown_q : (drew_q ? select_2496 : shown_shown_q);
  logic select_4283;
  assign select_4283 = equal_569_s2_q ? shown_nearer_q : (drew_q ? select_2499 : shown_nearer_q);
  // hls/stages/agreement.hpp:499
  logic [8:0] select_4286;
  assign select_4286 = equal_678_s2_q ? {{2{difference_4285[6]}}, difference_4285} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_4287;
  assign sum_4287 = select_4286[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_4290;
  assign select_4290 = less_4284_s2_q ? (sum_4287[7] ? region_row_q : next_region_row_q) : (and_3045_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_4292;
  assign select_4292 = and_544_s2_q ? (equal_2942_s2_q ? select_4290 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_4296;
  assign select_4296 = equal_569_s2_q ? select_2444 : (drew_q ? (ends_cell_s2_q ? select_2549 : select_2444) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_4309;
  assign select_4309 = equal_2942_s2_q ? (less_4284_s2_q ? region_down_next_q : select_4286) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [6:0] select_4312;
  assign select_4312 = equal_678_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4314;
  assign select_4314 = and_544_s2_q ? (equal_2942_s2_q ? select_4312 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_4315;
  assign sum_4315 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4316;
  assign sum_4316 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4317;
  assign select_4317 = sum_4315[7] ? {1'b1, sum_4315[6:0], region_down_rest_q[0]} : sum_4316;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4287[7];
  // hls/stages/agreement.hpp:465
  logic select_4321;
  assign select_4321 = equal_2942_s2_q ? (less_4284_s2_q ? next : (region_fresh_q | equal_678_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_4326;
  assign or_4326 = segment_starts_q | not_572_s2_q;
  // hls/stages/agreement.hpp:1043
  logic select_4329;
  assign select_4329 = inside_v_s2_q ? (sum_2457_s2_q ? (equal_2243 & or_2459) : or_2459) : or_4326;
  // hls/stages/agreement.hpp:798
  logic select_4332;
  assign select_4332 = equal_569_s2_q ? or_4326 : (drew_q ? (ends_cell_s2_q ? select_4329 : or_4326) : or_4326);
  logic select_4492;
  assign select_4492 = drew_q ? (ends_cell_s2_q ? and_2537 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4495;
  assign select_4495 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4497;
  assign select_4497 = equal_569_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4495 : centres_values_0_of_skin_q);
  logic select_4498;
  assign select_4498 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4500;
  assign select_4500 = equal_569_s2_q ? centres_values_1_textured_q : (drew_q ? select_4498 : centres_values_1_textured_q);
  logic select_4501;
  assign select_4501 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4503;
  assign select_4503 = equal_569_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4501 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4509;
  assign select_4509 = equal_2942_s2_q ? (or_4506_s2_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4512;
  assign select_4512 = and_544_s2_q ? (equal_2942_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/registration.hpp:258
  logic not_4599;
  assign not_4599 = ~quarter[1];
  logic [3:0] select_4600;
  assign select_4600 = quarter[0] ? {quarter[1], 1'b0, not_4599, 1'b0} : {1'b0, quarter[1], 1'b0, not_4599};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2088;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2131;
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
  assign patches_choices_raddr = select_2162;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2164));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1415; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2454;
  logic regions_re;
  assign regions_re = s2_en & (equal_569_s2_q ? (x_s2_q[6] & not_2455) : and_2462);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1426; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2520, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2527 & less_2528);
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
  assign moments_memory_wdata = {and_645_s2_q, and_643_s2_q, and_637_s2_q, and_635};
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
  assign best_left_we = s2_en & and_2035_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2034, select_2031, select_2028, select_2026, select_1999, select_1996, select_1988, select_1987, select_1983};
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
  assign best_right_we = s2_en & and_2035_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2045, select_2044, select_2041, select_2040};
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
  assign shown_right_waddr = select_2052_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2063;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2060, not_572_s2_q};
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
  assign left_turns_wdata = {and_2071, and_2068};
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
  assign right_turns_wdata = {and_2080, and_2077};
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
  assign patches_right_codes_waddr = {sum_2363, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2415_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {and_2401_s2_q, and_2398_s2_q, and_2382_s2_q, and_2379, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2419, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2429_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {and_2401_s2_q, and_2398_s2_q, and_2382_s2_q, and_2379, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2048_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2494, textured};
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
      averager_running_of_skin_q <= select_2666;
      averager_mask_q <= select_2668;
      averager_of_skin_q <= select_2670;
      census_filled_q <= and_544_s2_q ? {select_681[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2765;
      moments_turned_1_q <= sum_2767;
      moments_before_0_q <= equal_569_s2_q ? select_2769 : moments_before_0_q;
      moments_before_1_q <= equal_569_s2_q ? select_2771 : moments_before_1_q;
      moments_has_before_q <= select_2774;
      moments_most_before_q <= select_2777;
      moments_left_begins_q <= select_2781;
      moments_left_alone_q <= select_2785;
      moments_left_other_stops_q <= select_2788;
      moments_right_begins_q <= select_2791;
      moments_right_alone_q <= select_2795;
      moments_right_other_stops_q <= select_2798;
      moments_out_of_step_q <= out_of_step;
      moments_turns_0_q <= and_2809;
      moments_turns_1_q <= and_2813;
      moments_begins_alone_q <= and_2822;
      moments_ends_q <= equal_569_s2_q & (equal_2768 & (not_2823 | and_2825));
      rows_passed_above_q <= and_544_s2_q ? select_680 : rows_passed_above_q;
      draws_late_q <= select_3047;
      shift_allowed_q <= not_3049 & (~less_3050);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3057 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3182});
      counts_turned_right_q <= and_3057 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3190});
      registration_displacement_over_q <= drew_q ? sum_3214[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3216;
      registration_slope_here_q <= select_3218;
      registration_expected_q <= select_3220;
      registration_of_right_q <= equal_569_s2_q ? registration_of_right_q : select_3282;
      registration_was_inside_q <= equal_569_s2_q ? registration_was_inside_q : select_3285;
      registration_fresh_q <= select_3294;
      patches_chance_q <= and_544_s2_q ? select_3450 : patches_chance_q;
      patches_fixed_q <= and_3465;
      patches_choice_valid_q <= and_2248 ? (select_2221 & not_3452) : select_2221;
      patches_choice_column_q <= select_2226;
      patches_choice_shift_q <= select_2231;
      patches_choice_slope_q <= select_2242;
      patches_band_q <= sample_pair_whole_s2_q ? select_2263 : patches_band_q;
      patches_fetch_q <= select_3479;
      patches_codes_at_q <= select_3580;
      patches_codes_further_q <= equal_2250_s2_q ? patches_codes_further_q : select_3585;
      patches_next_codes_q <= select_3593;
      patches_set_q <= equal_2250_s2_q ? 3'h0 : (equal_2252_s2_q ? 3'h0 : select_3607);
      patches_size_q <= sum_3611;
      patches_left_row_q <= select_3623;
      patches_summed_row_column_q <= equal_2250_s2_q ? patches_summed_row_column_q : select_3968;
      patches_summed_first_q <= select_3971;
      patches_read_row_differing_q <= equal_2250_s2_q ? select_3979 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2250_s2_q ? select_3982 : patches_read_row_column_q;
      patches_read_at_q <= equal_2250_s2_q ? select_3985 : patches_read_at_q;
      patches_read_first_q <= select_3990;
      patches_read_above_q <= equal_2250_s2_q ? and_4002 : patches_read_above_q;
      patches_read_below_q <= equal_2250_s2_q ? and_4007 : patches_read_below_q;
      patches_read_far_q <= equal_2250_s2_q ? select_4014 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4017;
      patches_peak_best_column_q <= select_4018;
      patches_peak_row_q <= equal_2250_s2_q ? select_3997 : patches_peak_row_q;
      patches_peak_above_q <= select_4021;
      patches_peak_below_q <= select_4023;
      patches_peak_far_q <= select_4027;
      patches_peak_size_q <= select_4030;
      patches_frame_ended_q <= equal_569_s2_q & equal_2768;
      shown_shown_q <= select_4281;
      shown_nearer_q <= select_4283;
      region_row_q <= select_4292;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4296;
      region_down_rest_q <= and_544_s2_q ? select_4309 : region_down_rest_q;
      region_down_back_q <= select_4314;
      region_down_next_q <= select_4317;
      region_fresh_q <= and_544_s2_q ? select_4321 : region_fresh_q;
      segment_starts_q <= select_4332;
      centres_values_0_textured_q <= equal_569_s2_q ? centres_values_0_textured_q : select_4492;
      centres_values_0_of_skin_q <= select_4497;
      centres_values_1_textured_q <= select_4500;
      centres_values_1_of_skin_q <= select_4503;
      map_row_q <= and_544_s2_q ? select_4509 : map_row_q;
      map_width_q <= select_4512;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_s2_q) : write_half_q;
      read_half_q <= select_2519;
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
      averager_total_0_q <= select_2644;
      averager_total_1_q <= select_2646;
      census_columns_values_0_cell_0_left_q <= select_2671;
      census_columns_values_0_cell_0_right_q <= select_2672;
      census_columns_values_0_cell_0_mask_q <= and_544_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2674;
      census_columns_values_0_cell_1_right_q <= select_2675;
      census_columns_values_0_cell_1_mask_q <= select_2676;
      census_columns_values_0_cell_2_left_q <= select_2677;
      census_columns_values_0_cell_2_right_q <= select_2678;
      census_columns_values_0_cell_2_mask_q <= select_2679;
      census_columns_values_0_cell_2_of_skin_q <= select_2680;
      census_columns_values_0_cell_3_left_q <= select_2681;
      census_columns_values_0_cell_3_right_q <= select_2682;
      census_columns_values_0_cell_3_mask_q <= select_2683;
      census_columns_values_0_cell_4_left_q <= select_2684;
      census_columns_values_0_cell_4_right_q <= select_2685;
      census_columns_values_0_cell_4_mask_q <= select_2686;
      census_columns_values_1_cell_0_left_q <= select_2687;
      census_columns_values_1_cell_0_right_q <= select_2688;
      census_columns_values_1_cell_0_mask_q <= select_2689;
      census_columns_values_1_cell_1_left_q <= select_2690;
      census_columns_values_1_cell_1_right_q <= select_2691;
      census_columns_values_1_cell_1_mask_q <= select_2692;
      census_columns_values_1_cell_2_left_q <= select_2693;
      census_columns_values_1_cell_2_right_q <= select_2694;
      census_columns_values_1_cell_2_mask_q <= select_2695;
      census_columns_values_1_cell_2_of_skin_q <= select_2696;
      census_columns_values_1_cell_3_left_q <= select_2697;
      census_columns_values_1_cell_3_right_q <= select_2698;
      census_columns_values_1_cell_3_mask_q <= select_2699;
      census_columns_values_1_cell_4_left_q <= select_2700;
      census_columns_values_1_cell_4_right_q <= select_2701;
      census_columns_values_1_cell_4_mask_q <= select_2702;
      census_columns_values_2_cell_0_left_q <= select_2703;
      census_columns_values_2_cell_0_right_q <= select_2704;
      census_columns_values_2_cell_0_mask_q <= select_2705;
      census_columns_values_2_cell_1_left_q <= select_2706;
      census_columns_values_2_cell_1_right_q <= select_2707;
      census_columns_values_2_cell_1_mask_q <= select_2708;
      census_columns_values_2_cell_2_left_q <= select_2709;
      census_columns_values_2_cell_2_right_q <= select_2710;
      census_columns_values_2_cell_2_mask_q <= select_2711;
      census_columns_values_2_cell_3_left_q <= select_2712;
      census_columns_values_2_cell_3_right_q <= select_2713;
      census_columns_values_2_cell_3_mask_q <= select_2714;
      census_columns_values_2_cell_4_left_q <= select_2715;
      census_columns_values_2_cell_4_right_q <= select_2716;
      census_columns_values_2_cell_4_mask_q <= select_2717;
      census_columns_values_3_cell_0_mask_q <= select_2718;
      census_columns_values_3_cell_1_left_q <= select_2719;
      census_columns_values_3_cell_1_right_q <= select_2720;
      census_columns_values_3_cell_1_mask_q <= select_2721;
      census_columns_values_3_cell_2_mask_q <= select_2722;
      census_columns_values_3_cell_3_left_q <= select_2723;
      census_columns_values_3_cell_3_right_q <= select_2724;
      census_columns_values_3_cell_3_mask_q <= select_2725;
      census_columns_values_3_cell_4_mask_q <= select_2726;
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
  logic less_674_s3_q;
  logic and_682_s3_q;
  logic and_707_s3_q;
  logic and_708_s3_q;
  logic [11:0] sum_723_s3_q;
  logic [9:0] sum_726_s3_q;
  logic and_734_s3_q;
  logic and_738_s3_q;
  logic less_739_s3_q;
  logic less_743_s3_q;
  logic less_745_s3_q;
  logic equal_2081_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2087_s3_q;
  logic equal_2089_s3_q;
  logic equal_2091_s3_q;
  logic equal_2093_s3_q;
  logic equal_2095_s3_q;
  logic equal_2097_s3_q;
  logic equal_2099_s3_q;
  logic equal_2101_s3_q;
  logic equal_2103_s3_q;
  logic less_2112_s3_q;
  logic or_2116_s3_q;
  logic equal_2136_s3_q;
  logic and_2146_s3_q;
  logic select_2163_s3_q;
  logic equal_2164_s3_q;
  logic and_2172_s3_q;
  logic equal_2174_s3_q;
  logic select_2221_s3_q;
  logic and_2249_s3_q;
  logic equal_2250_s3_q;
  logic equal_2252_s3_q;
  logic not_2257_s3_q;
  logic and_2265_s3_q;
  logic [4:0] select_2280_s3_q;
  logic select_2286_s3_q;
  logic [3:0] select_2326_s3_q;
  logic or_2447_s3_q;
  logic or_2450_s3_q;
  logic or_2453_s3_q;
  logic not_2455_s3_q;
  logic and_2469_s3_q;
  logic and_2475_s3_q;
  logic and_2486_s3_q;
  logic and_2491_s3_q;
  logic and_2527_s3_q;
  logic less_2528_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2534_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2552_s3_q;
  logic or_2555_s3_q;
  logic or_2558_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2610_s3_q;
  logic [11:0] sum_2742_s3_q;
  logic [9:0] sum_2745_s3_q;
  logic equal_2753_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2871_s3_q;
  logic and_3057_s3_q;
  logic and_3064_s3_q;
  logic not_3085_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3129_s3_q;
  logic and_3164_s3_q;
  logic and_3224_s3_q;
  logic and_3225_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3261_s3_q;
  logic and_3275_s3_q;
  logic equal_3317_s3_q;
  logic parity_3695_s3_q;
  logic parity_3824_s3_q;
  logic parity_3886_s3_q;
  logic xor_3914_s3_q;
  logic parity_3926_s3_q;
  logic or_3930_s3_q;
  logic equal_3931_s3_q;
  logic and_4031_s3_q;
  logic less_4056_s3_q;
  logic equal_4356_s3_q;
  logic and_4520_s3_q;
  logic and_4535_s3_q;
  logic and_4537_s3_q;
  logic not_4549_s3_q;
  logic equal_4602_s3_q;
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
      less_674_s3_q <= less_674;
      and_682_s3_q <= and_682;
      and_707_s3_q <= whole_22 & and_682;
      and_708_s3_q <= census_columns_values_1_cell_2_mask_q & and_682;
      sum_723_s3_q <= {1'b0, sum_719} + {2'h0, sum_722};
      sum_726_s3_q <= {9'h0, difference_724[9]} + {1'b0, xor_725};
      and_734_s3_q <= and_734;
      and_738_s3_q <= and_738;
      less_739_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_743_s3_q <= {{5{sum_742[6]}}, sum_742, half_grey_levels_2[3:0]} < 16'hffe1;
      less_745_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2081_s3_q <= equal_2081;
      all_s3_q <= all;
      sum_2087_s3_q <= sum_2087;
      equal_2089_s3_q <= equal_2089;
      equal_2091_s3_q <= equal_2091;
      equal_2093_s3_q <= equal_2093;
      equal_2095_s3_q <= equal_2095;
      equal_2097_s3_q <= equal_2097;
      equal_2099_s3_q <= equal_2099;
      equal_2101_s3_q <= equal_2101;
      equal_2103_s3_q <= equal_2103;
      less_2112_s3_q <= less_2112;
      or_2116_s3_q <= or_2116;
      equal_2136_s3_q <= (registration_fresh_q & select_2134) == 4'h0;
      and_2146_s3_q <= not_570_s2_q & and_2130;
      select_2163_s3_q <= select_2163[1];
      equal_2164_s3_q <= equal_2164;
      and_2172_s3_q <= and_2172;
      equal_2174_s3_q <= equal_2174;
      select_2221_s3_q <= select_2221;
      and_2249_s3_q <= and_2249;
      equal_2250_s3_q <= equal_2250_s2_q;
      equal_2252_s3_q <= equal_2252_s2_q;
      not_2257_s3_q <= not_2257_s2_q;
      and_2265_s3_q <= and_2249 & equal_2264;
      select_2280_s3_q <= select_2280_s2_q;
      select_2286_s3_q <= select_2286_s2_q;
      select_2326_s3_q <= select_2326_s2_q;
      or_2447_s3_q <= or_2447;
      or_2450_s3_q <= or_2450;
      or_2453_s3_q <= or_2453;
      not_2455_s3_q <= not_2455;
      and_2469_s3_q <= inside_v_s2_q & (and_2466 & not_2467_s2_q);
      and_2475_s3_q <= inside_v_s2_q & (and_630 & not_2467_s2_q);
      and_2486_s3_q <= inside_v_s2_q & (not_2467_s2_q & (and_2483 & and_2059));
      and_2491_s3_q <= not_570_s2_q & and_2462;
      and_2527_s3_q <= and_2527;
      less_2528_s3_q <= less_2528;
      index_2_s3_q <= index_2[5:0];
      sum_2534_s3_q <= sum_2534;
      textured_2_s3_q <= textured_2;
      or_2552_s3_q <= or_2552;
      or_2555_s3_q <= select_2549[7] | (~({select_2549[6], select_2549[3:2]} == 3'h0));
      or_2558_s3_q <= select_2549[7] | (~(select_2549[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2610_s3_q <= and_2610;
      sum_2742_s3_q <= {1'b0, sum_2738} + {2'h0, sum_2741};
      sum_2745_s3_q <= {9'h0, difference_2743[9]} + {1'b0, xor_2744};
      equal_2753_s3_q <= equal_2753_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2871_s3_q <= x_s2_q[7:3] == 5'h0;
      and_3057_s3_q <= and_3057;
      and_3064_s3_q <= not_570_s2_q & (drew_q & and_3062);
      not_3085_s3_q <= ~((draws_late_q & not_2467_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_3129_s3_q <= not_570_s2_q & (drew_q & and_3127);
      and_3164_s3_q <= not_570_s2_q & (drew_q & and_3162);
      and_3224_s3_q <= not_570_s2_q & (drew_q & (half_ends & equal_3221));
      and_3225_s3_q <= and_3225;
      residual_s3_q <= residual[7:0];
      and_3261_s3_q <= and_3261;
      and_3275_s3_q <= and_3225 & less_3274;
      equal_3317_s3_q <= (registration_fresh_q & select_3315) == 4'h0;
      parity_3695_s3_q <= ^{xor_3691, xor_3654, select_3621[44:36], other[44:36]};
      parity_3824_s3_q <= parity_3824;
      parity_3886_s3_q <= parity_3886;
      xor_3914_s3_q <= parity_3901 ^ parity_3913;
      parity_3926_s3_q <= ^{or_3923, or_3919, and_3915};
      or_3930_s3_q <= (or_3919 & or_3923) | (and_3915 & (or_3919 | or_3923));
      equal_3931_s3_q <= equal_3931_s2_q;
      and_4031_s3_q <= equal_2250_s2_q & equal_4028_s2_q;
      less_4056_s3_q <= select_4021 < select_4023;
      equal_4356_s3_q <= equal_4356_s2_q;
      and_4520_s3_q <= said_q;
      and_4535_s3_q <= and_2610 & ({sum_2534, index_2[5:0]} == {sum_2520, index[5:0]});
      and_4537_s3_q <= less_3038 & proven_q;
      not_4549_s3_q <= not_4549_s2_q;
      equal_4602_s3_q <= (registration_fresh_q & select_4600) == 4'h0;
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
  assign texture = sum_723_s3_q + {2'h0, sum_726_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_728;
  assign sum_728 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_730;
  assign sum_730 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_728});
  // hls/stages/census.hpp:317
  logic less_731;
  assign less_731 = 9'h4 < sum_730[13:5];
  logic and_732;
  assign and_732 = and_682_s3_q & less_731;
  // hls/stages/moments.hpp:33
  logic and_744;
  assign and_744 = (and_707_s3_q & and_734_s3_q) & less_743_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2138;
  assign equal_2138 = sum_2087_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2087_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2140;
  assign select_2140 = equal_2138 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2141;
  assign sum_2141 = (equal_2136_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2140[13]}}, select_2140};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2087_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2144;
  assign select_2144 = equal_2138 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2145;
  assign sum_2145 = (equal_2136_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2144[6]}}, select_2144};
  // hls/stages/patches.hpp:357
  logic [22:0] select_2266;
  assign select_2266 = and_2265_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2221_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2268;
  assign select_2268 = equal_2164_s3_q ? patches_place_0_valid_q : (select_2163_s3_q ? patches_place_0_valid_q : select_2266[0]);
  // hls/stages/patches.hpp:132
  logic [8:0] sum_2269;
  assign sum_2269 = {1'b0, select_538_s3_q, select_505_s3_q[2]} + 9'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_2270;
  assign select_2270 = select_2163_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2266[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2271;
  assign select_2271 = equal_2164_s3_q ? patches_place_0_column_q : select_2270[7:0];
  logic [5:0] select_2272;
  assign select_2272 = equal_2164_s3_q ? patches_place_0_shift_q : select_2270[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2273;
  assign sum_2273 = {1'b0, select_2271} + {{3{select_2272[5]}}, select_2272};
  // hls/stages/patches.hpp:132
  logic equal_2274;
  assign equal_2274 = {sum_2273, sum_2269[0], select_505_s3_q[1:0]} == {1'b0, sum_2269[8:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2276;
  assign or_2276 = row_starts_s3_q | (select_2268 & equal_2274);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_2277;
  assign select_2277 = or_2276 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2287;
  assign select_2287 = or_2276 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_2289;
  assign and_2289 = select_2286_s3_q & (~select_2287[5]);
  // hls/stages/patches.hpp:127
  logic select_2297;
  assign select_2297 = equal_2164_s3_q ? patches_place_1_valid_q : (select_2163_s3_q ? select_2266[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_2298;
  assign select_2298 = select_2163_s3_q ? select_2266[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2299;
  assign select_2299 = equal_2164_s3_q ? patches_place_1_column_q : select_2298[7:0];
  logic [5:0] select_2300;
  assign select_2300 = equal_2164_s3_q ? patches_place_1_shift_q : select_2298[13:8];
  // hls/stages/patches.hpp:327
  logic [8:0] sum_2301;
  assign sum_2301 = {1'b0, select_2299} + {{3{select_2300[5]}}, select_2300};
  // hls/stages/patches.hpp:132
  logic equal_2302;
  assign equal_2302 = {sum_2301[8], sum_2269, select_505_s3_q[1:0]} == {1'b0, sum_2301[7:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_2304;
  assign or_2304 = row_starts_s3_q | (select_2297 & equal_2302);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_2305;
  assign select_2305 = or_2304 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_2306;
  assign select_2306 = or_2304 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_2308;
  assign and_2308 = select_2286_s3_q & (~select_2306[5]);
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2315;
  assign sum_2315 = select_2271 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2316;
  assign equal_2316 = {sum_2315[7], select_538_s3_q, select_505_s3_q} == {1'b0, sum_2315[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_2318;
  assign or_2318 = row_starts_s3_q | (select_2268 & equal_2316);
  logic [4:0] select_2319;
  assign select_2319 = or_2318 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2320;
  assign sum_2320 = select_2299 + 8'hff;
  // hls/stages/patches.hpp:133
  logic equal_2321;
  assign equal_2321 = {sum_2320[7], select_538_s3_q, select_505_s3_q} == {1'b0, sum_2320[6:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_2324;
  assign select_2324 = (row_starts_s3_q | (select_2297 & equal_2321)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_6;
  assign column_6 = select_2319[4] ? select_2324[3:0] : select_2319[3:0];
  // hls/stages/agreement.hpp:277
  logic select_2327;
  assign select_2327 = or_2318 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_2333;
  assign and_2333 = (select_2286_s3_q & (select_2280_s3_q[3] ^ select_2280_s3_q[4])) & ((~select_2319[4]) | (~select_2324[4]));
  // hls/stages/patches.hpp:186
  logic less_2437;
  assign less_2437 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_2438;
  assign not_2438 = ~less_2437;
  logic [1:0] select_2439;
  assign select_2439 = patches_summed_first_s3_q ? 2'h2 : {less_2437, not_2438};
  logic [12:0] select_2441;
  assign select_2441 = select_2439[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2442;
  assign select_2442 = select_2439[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2443;
  assign select_2443 = (select_2439 == 2'h2) ? {select_2441[12:8], patches_sums_values_0_q[9:8], select_2441[7:0]} : select_2442;
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2470;
  assign select_2470 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2471;
  assign sum_2471 = {6'h0, and_2469_s3_q} + select_2470;
  // hls/stages/agreement.hpp:1075
  logic [9:0] sum_2473;
  assign sum_2473 = {3'h0, sum_2471} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2476;
  assign select_2476 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2477;
  assign sum_2477 = {6'h0, and_2475_s3_q} + select_2476;
  // hls/stages/agreement.hpp:1076
  logic [9:0] sum_2479;
  assign sum_2479 = {3'h0, sum_2477} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2487;
  assign select_2487 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2488;
  assign sum_2488 = {6'h0, and_2486_s3_q} + select_2487;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2490;
  assign sum_2490 = {3'h0, sum_2488} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2543;
  assign select_2543 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2544;
  assign difference_2544 = {1'b0, textured_2_s3_q} - {1'b0, select_2543};
  logic [4:0] t;
  assign t = {difference_2544[3], difference_2544} + (equal_564_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1114
  logic equal_2547;
  assign equal_2547 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1115
  logic not_2559;
  assign not_2559 = ~region_row_s3_q[2];
  logic [2:0] select_2560;
  assign select_2560 = region_row_s3_q[1] ? {1'b0, not_2559, 1'b0} : {region_row_s3_q[2], 1'b0, not_2559};
  logic [5:0] select_2561;
  assign select_2561 = region_row_s3_q[0] ? {select_2560[2], 1'b0, select_2560[1], 1'b0, select_2560[0], 1'b0} : {1'b0, select_2560[2], 1'b0, select_2560[1], 1'b0, select_2560[0]};
  logic [11:0] select_2562;
  assign select_2562 = or_2558_s3_q ? {select_2561[5], 1'b0, select_2561[4], 1'b0, select_2561[3], 1'b0, select_2561[2], 1'b0, select_2561[1], 1'b0, select_2561[0], 1'b0} : {1'b0, select_2561[5], 1'b0, select_2561[4], 1'b0, select_2561[3], 1'b0, select_2561[2], 1'b0, select_2561[1], 1'b0, select_2561[0]};
  logic [23:0] select_2563;
  assign select_2563 = or_2555_s3_q ? {select_2562[11], 1'b0, select_2562[10], 1'b0, select_2562[9], 1'b0, select_2562[8], 1'b0, select_2562[7], 1'b0, select_2562[6], 1'b0, select_2562[5], 1'b0, select_2562[4], 1'b0, select_2562[3], 1'b0, select_2562[2], 1'b0, select_2562[1], 1'b0, select_2562[0], 1'b0} : {1'b0, select_2562[11], 1'b0, select_2562[10], 1'b0, select_2562[9], 1'b0, select_2562[8], 1'b0, select_2562[7], 1'b0, select_2562[6], 1'b0, select_2562[5], 1'b0, select_2562[4], 1'b0, select_2562[3], 1'b0, select_2562[2], 1'b0, select_2562[1], 1'b0, select_2562[0]};
  logic [47:0] select_2564;
  assign select_2564 = or_2552_s3_q ? {select_2563[23], 1'b0, select_2563[22], 1'b0, select_2563[21], 1'b0, select_2563[20], 1'b0, select_2563[19], 1'b0, select_2563[18], 1'b0, select_2563[17], 1'b0, select_2563[16], 1'b0, select_2563[15], 1'b0, select_2563[14], 1'b0, select_2563[13], 1'b0, select_2563[12], 1'b0, select_2563[11], 1'b0, select_2563[10], 1'b0, select_2563[9], 1'b0, select_2563[8], 1'b0, select_2563[7], 1'b0, select_2563[6], 1'b0, select_2563[5], 1'b0, select_2563[4], 1'b0, select_2563[3], 1'b0, select_2563[2], 1'b0, select_2563[1], 1'b0, select_2563[0], 1'b0} : {1'b0, select_2563[23], 1'b0, select_2563[22], 1'b0, select_2563[21], 1'b0, select_2563[20], 1'b0, select_2563[19], 1'b0, select_2563[18], 1'b0, select_2563[17], 1'b0, select_2563[16], 1'b0, select_2563[15], 1'b0, select_2563[14], 1'b0, select_2563[13], 1'b0, select_2563[12], 1'b0, select_2563[11], 1'b0, select_2563[10], 1'b0, select_2563[9], 1'b0, select_2563[8], 1'b0, select_2563[7], 1'b0, select_2563[6], 1'b0, select_2563[5], 1'b0, select_2563[4], 1'b0, select_2563[3], 1'b0, select_2563[2], 1'b0, select_2563[1], 1'b0, select_2563[0]};
  // hls/stages/agreement.hpp:1043
  logic and_2568;
  assign and_2568 = good_known_q & (~((good_q & select_2564) == 48'h0));
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2577;
  assign select_2577 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2578;
  assign difference_2578 = {1'b0, shown_2_s3_q} - {1'b0, select_2577};
  logic [4:0] around;
  assign around = {difference_2578[3], difference_2578} + (equal_564_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1117
  logic [5:0] sum_2581;
  assign sum_2581 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2547 ? and_2568 : (~({sum_2581, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_2593;
  assign select_2593 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2594;
  assign difference_2594 = {1'b0, near_2_s3_q} - {1'b0, select_2593};
  logic [4:0] n;
  assign n = {difference_2594[3], difference_2594} + (equal_564_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1127
  logic and_2598;
  assign and_2598 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2636;
  assign select_2636 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2638;
  assign select_2638 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2640;
  assign select_2640 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2642;
  assign select_2642 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2647;
  assign sum_2647 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2648;
  assign difference_2648 = {1'b0, sum_2647[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2649;
  assign xor_2649 = {difference_2648[8:0], sum_2647[0]} ^ {10{difference_2648[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2648[9]} + {1'b0, xor_2649};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_547_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2654;
  assign select_2654 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2655;
  assign sum_2655 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2656;
  assign difference_2656 = {1'b0, sum_2655[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2657;
  assign xor_2657 = {difference_2656[8:0], sum_2655[0]} ^ {10{difference_2656[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2656[9]} + {1'b0, xor_2657};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_547_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2662;
  assign select_2662 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2746;
  assign sum_2746 = sum_2742_s3_q + {2'h0, sum_2745_s3_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2748;
  assign select_2748 = and_544_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2749;
  assign select_2749 = and_544_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2750;
  assign select_2750 = and_544_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2751;
  assign select_2751 = and_544_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2754;
  assign sum_2754 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2746};
  logic [13:0] sum_2756;
  assign sum_2756 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2754});
  // hls/stages/census.hpp:323
  logic and_2758;
  assign and_2758 = and_707_s3_q & (9'h4 < sum_2756[13:5]);
  // hls/stages/census.hpp:324
  logic and_2759;
  assign and_2759 = and_707_s3_q & less_731;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2760;
  assign sum_2760 = census_left_misses_q + {{17{and_2759}}, and_2758, 1'b0, and_2758};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2762;
  assign select_2762 = and_544_s3_q ? (equal_2753_s3_q ? 20'h0 : sum_2760) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2832;
  assign select_2832 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:530
  logic select_2835;
  assign select_2835 = and_544_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2838;
  assign and_2838 = whole_2_s3_q & (~(last_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2844;
  assign and_2844 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2845;
  assign and_2845 = and_2838 & and_2844;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2832[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2847;
  assign select_2847 = and_2845 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2849;
  assign select_2849 = equal_2753_s3_q ? {11'h0, select_2847} : (sharpness_sums_detail_0_q + {11'h0, select_2847});
  // hls/stages/agreement.hpp:462
  logic and_2856;
  assign and_2856 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2857;
  assign and_2857 = and_2838 & and_2856;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2832[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2859;
  assign select_2859 = and_2857 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2861;
  assign select_2861 = equal_2753_s3_q ? {11'h0, select_2859} : (sharpness_sums_detail_1_q + {11'h0, select_2859});
  logic [8:0] select_2864;
  assign select_2864 = and_2845 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2865;
  assign sum_2865 = (equal_2753_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2864};
  logic [8:0] select_2868;
  assign select_2868 = and_2857 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2869;
  assign sum_2869 = (equal_2753_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2868};
  // hls/stages/census.hpp:388
  logic less_2872;
  assign less_2872 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2873;
  assign less_2873 = x_s3_q[4:0] < 5'h3;
  logic not_2874;
  assign not_2874 = ~x_s3_q[1];
  logic [2:0] select_2875;
  assign select_2875 = x_s3_q[0] ? {1'b0, not_2874, 1'b0} : {x_s3_q[1], 1'b0, not_2874};
  logic [5:0] select_2876;
  assign select_2876 = slot_s3_q[2] ? {select_2875[2], 1'b0, select_2875[1], 1'b0, select_2875[0], 1'b0} : {1'b0, select_2875[2], 1'b0, select_2875[1], 1'b0, select_2875[0]};
  logic [11:0] select_2877;
  assign select_2877 = slot_s3_q[1] ? {select_2876[5], 1'b0, select_2876[4], 1'b0, select_2876[3], 1'b0, select_2876[2], 1'b0, select_2876[1], 1'b0, select_2876[0], 1'b0} : {1'b0, select_2876[5], 1'b0, select_2876[4], 1'b0, select_2876[3], 1'b0, select_2876[2], 1'b0, select_2876[1], 1'b0, select_2876[0]};
  logic [23:0] select_2878;
  assign select_2878 = slot_s3_q[0] ? {select_2877[11], 1'b0, select_2877[10], 1'b0, select_2877[9], 1'b0, select_2877[8], 1'b0, select_2877[7], 1'b0, select_2877[6], 1'b0, select_2877[5], 1'b0, select_2877[4], 1'b0, select_2877[3], 1'b0, select_2877[2], 1'b0, select_2877[1], 1'b0, select_2877[0], 1'b0} : {1'b0, select_2877[11], 1'b0, select_2877[10], 1'b0, select_2877[9], 1'b0, select_2877[8], 1'b0, select_2877[7], 1'b0, select_2877[6], 1'b0, select_2877[5], 1'b0, select_2877[4], 1'b0, select_2877[3], 1'b0, select_2877[2], 1'b0, select_2877[1], 1'b0, select_2877[0]};
  // hls/stages/census.hpp:390
  logic and_2882;
  assign and_2882 = less_2873 & (~((sharpness_sums_contrast_1_q & select_2878) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2884;
  assign select_2884 = (less_2872 & and_2882) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2884};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2887;
  assign select_2887 = equal_2871_s3_q ? (less_2872 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2892;
  assign and_2892 = less_2873 & (~((sharpness_sums_contrast_0_q & select_2878) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2894;
  assign select_2894 = (less_2872 & and_2892) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2894};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2897;
  assign select_2897 = equal_2871_s3_q ? (less_2872 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2899;
  assign select_2899 = equal_2871_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2901;
  assign select_2901 = equal_2871_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2903;
  assign select_2903 = equal_2871_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2892} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2905;
  assign select_2905 = equal_2871_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2882} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2910;
  assign select_2910 = so_s3_q ? (equal_2871_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2913;
  assign select_2913 = equal_2871_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2915;
  assign equal_2915 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2916;
  assign xor_2916 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2919;
  assign select_2919 = (equal_2915 | xor_2916) ? (five_times[0] & xor_2916) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2920;
  assign select_2920 = equal_2871_s3_q ? select_2919 : sharpness_comparing_less_detail_0_q;
  logic select_2921;
  assign select_2921 = so_s3_q ? select_2920 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2922;
  assign xor_2922 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2925;
  assign select_2925 = (equal_2915 | xor_2922) ? (five_times_2[0] & xor_2922) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2926;
  assign select_2926 = equal_2871_s3_q ? select_2925 : sharpness_comparing_less_detail_1_q;
  logic select_2927;
  assign select_2927 = so_s3_q ? select_2926 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2928;
  assign xor_2928 = sharpness_comparing_contrast_0_q[1] ^ and_2882;
  logic select_2931;
  assign select_2931 = (equal_2915 | xor_2928) ? (and_2882 & xor_2928) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2932;
  assign select_2932 = equal_2871_s3_q ? select_2931 : sharpness_comparing_less_contrast_0_q;
  logic select_2933;
  assign select_2933 = so_s3_q ? select_2932 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2934;
  assign xor_2934 = sharpness_comparing_contrast_1_q[1] ^ and_2892;
  logic select_2937;
  assign select_2937 = (equal_2915 | xor_2934) ? (and_2892 & xor_2934) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2938;
  assign select_2938 = equal_2871_s3_q ? select_2937 : sharpness_comparing_less_contrast_1_q;
  logic select_2939;
  assign select_2939 = so_s3_q ? select_2938 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3066;
  assign select_3066 = and_3057_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3064_s3_q});
  // hls/stages/agreement.hpp:798
  logic and_3069;
  assign and_3069 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2469_s3_q));
  logic and_3074;
  assign and_3074 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2475_s3_q));
  logic and_3079;
  assign and_3079 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_2486_s3_q));
  // hls/stages/agreement.hpp:1109
  logic [2:0] select_3094;
  assign select_3094 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3095;
  assign difference_3095 = {1'b0, explained_2_s3_q} - {1'b0, select_3094};
  logic [4:0] e;
  assign e = {difference_3095[3], difference_3095} + (equal_564_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1116
  logic [5:0] sum_3098;
  assign sum_3098 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1121
  logic not_3102;
  assign not_3102 = ~(equal_2547 ? and_2568 : (~({sum_3098, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:798
  logic and_3105;
  assign and_3105 = ends_cell_s3_q & (not_3085_s3_q & (centres_values_1_textured_s3_q & not_3102));
  logic and_3107;
  assign and_3107 = not_570_s3_q & (so_s3_q & and_3105);
  // hls/stages/agreement.hpp:1147
  logic less_3110;
  assign less_3110 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3111;
  assign select_3111 = less_3110 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3114;
  assign select_3114 = less_3110 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1148
  logic [10:0] sum_3115;
  assign sum_3115 = {1'b0, select_3114} + {3'h0, select_3114[9:2]};
  logic and_3117;
  assign and_3117 = (~(select_3111[9:4] == 6'h0)) & ({sum_3115, select_3114[1:0]} < {3'h0, select_3111});
  // hls/stages/agreement.hpp:1157
  logic [9:0] select_3120;
  assign select_3120 = x_s3_q[6] ? (equal_2081_s3_q ? 10'h0 : (and_3117 ? select_3111 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_3121;
  assign select_3121 = equal_569_s3_q ? select_3120 : 10'h0;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3123;
  assign select_3123 = and_3057_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3121});
  logic [13:0] select_3131;
  assign select_3131 = and_3057_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3129_s3_q});
  // hls/stages/agreement.hpp:1125
  logic and_3133;
  assign and_3133 = not_3085_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:798
  logic and_3136;
  assign and_3136 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & and_3133));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3138;
  assign select_3138 = and_3057_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3136});
  // hls/stages/agreement.hpp:1125
  logic and_3140;
  assign and_3140 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3102);
  // hls/stages/agreement.hpp:798
  logic and_3144;
  assign and_3144 = not_570_s3_q & (so_s3_q & (ends_cell_s3_q & (not_3085_s3_q & and_3140)));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_3146;
  assign select_3146 = and_3057_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3144});
  logic [13:0] select_3166;
  assign select_3166 = and_3057_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3164_s3_q});
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3243;
  assign select_3243 = so_s3_q ? (equal_2174_s3_q ? (and_3225_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3244;
  assign select_3244 = equal_569_s3_q ? 8'h0 : select_3243;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3246;
  assign select_3246 = and_3224_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3244[7]}}, select_3244});
  // hls/stages/agreement.hpp:798
  logic and_3249;
  assign and_3249 = not_570_s3_q & (so_s3_q & (and_3225_s3_q & equal_2174_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3251;
  assign select_3251 = and_3224_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3249});
  // hls/stages/registration.hpp:107
  logic and_3253;
  assign and_3253 = and_3225_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3255;
  assign select_3255 = so_s3_q ? (equal_2174_s3_q ? {and_3253, and_3225_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3256;
  assign select_3256 = equal_569_s3_q ? 2'h0 : select_3255;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3257;
  assign sum_3257 = registration_half_votes_down_q + {{5{select_3256[1]}}, select_3256};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3263;
  assign select_3263 = so_s3_q ? (equal_2174_s3_q ? {and_3261_s3_q, and_3225_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3264;
  assign select_3264 = equal_569_s3_q ? 2'h0 : select_3263;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3265;
  assign sum_3265 = registration_half_votes_up_q + {{5{select_3264[1]}}, select_3264};
  // hls/stages/registration.hpp:107
  logic and_3268;
  assign and_3268 = and_3225_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3270;
  assign select_3270 = so_s3_q ? (equal_2174_s3_q ? {and_3268, and_3225_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3271;
  assign select_3271 = equal_569_s3_q ? 2'h0 : select_3270;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3272;
  assign sum_3272 = registration_half_half_votes_down_q + {{5{select_3271[1]}}, select_3271};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_3277;
  assign select_3277 = so_s3_q ? (equal_2174_s3_q ? {and_3275_s3_q, and_3225_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3278;
  assign select_3278 = equal_569_s3_q ? 2'h0 : select_3277;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3279;
  assign sum_3279 = registration_half_half_votes_up_q + {{5{select_3278[1]}}, select_3278};
  // hls/stages/agreement.hpp:798
  logic and_3312;
  assign and_3312 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & less_2112_s3_q));
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_3319;
  assign select_3319 = or_2116_s3_q ? 12'h0 : (equal_3317_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_3322;
  assign select_3322 = x_s3_q[6] ? (equal_2081_s3_q ? 12'h0 : (less_2112_s3_q ? select_3319 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_3323;
  assign select_3323 = equal_569_s3_q ? select_3322 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3324;
  assign and_3324 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1157
  logic and_3327;
  assign and_3327 = not_2455_s3_q & (less_2112_s3_q & ({and_3324, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:798
  logic and_3329;
  assign and_3329 = equal_569_s3_q & (x_s3_q[6] & and_3327);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3331;
  assign sum_3331 = {{2{select_3323[11]}}, select_3323} + (and_3329 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_3334;
  assign select_3334 = or_2116_s3_q ? 12'h0 : (equal_3317_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_3337;
  assign select_3337 = x_s3_q[6] ? (equal_2081_s3_q ? 12'h0 : (less_2112_s3_q ? select_3334 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_3338;
  assign select_3338 = equal_569_s3_q ? select_3337 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3340;
  assign sum_3340 = {{2{select_3338[11]}}, select_3338} + (and_3329 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3342;
  assign not_3342 = ~all_s3_q;
  // hls/stages/agreement.hpp:1157
  logic and_3345;
  assign and_3345 = not_2455_s3_q & (less_2112_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3342, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_3351;
  assign and_3351 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & (less_2112_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3352;
  assign not_3352 = ~and_3351;
  logic less_3353;
  assign less_3353 = $signed({9'h1, {2{not_3352}}, and_3351}) < $signed(registration_up_q[13:2]);
  logic select_3354;
  assign select_3354 = (equal_569_s3_q & (x_s3_q[6] & and_3345)) ? less_3353 : registration_enough_q;
  // hls/stages/agreement.hpp:1157
  logic and_3358;
  assign and_3358 = x_s3_q[6] & (not_2455_s3_q & (less_2112_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_3359;
  assign and_3359 = equal_569_s3_q & and_3358;
  // hls/stages/registration.hpp:242
  logic less_3360;
  assign less_3360 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3362;
  assign less_3362 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3364;
  assign equal_3364 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_3368;
  assign and_3368 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & (less_2112_s3_q & equal_3364)));
  // hls/stages/agreement.hpp:1157
  logic and_3375;
  assign and_3375 = x_s3_q[6] & (not_2455_s3_q & (less_2112_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3378;
  assign equal_3378 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1157
  logic and_3381;
  assign and_3381 = not_2455_s3_q & (less_2112_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3378));
  // hls/stages/registration.hpp:244
  logic and_3385;
  assign and_3385 = (equal_569_s3_q & (x_s3_q[6] & and_3381)) & (less_3362 | less_3360);
  // hls/stages/agreement.hpp:1157
  logic and_3390;
  assign and_3390 = not_2455_s3_q & (less_2112_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3378)));
  // hls/stages/registration.hpp:244
  logic and_3393;
  assign and_3393 = registration_votes_up_q & registration_other_down_q;
  logic select_3395;
  assign select_3395 = registration_votes_down_q ? (registration_other_up_q | and_3393) : and_3393;
  // hls/stages/registration.hpp:138
  logic and_3397;
  assign and_3397 = (equal_569_s3_q & (x_s3_q[6] & and_3390)) & (registration_other_enough_q & select_3395);
  // hls/stages/registration.hpp:245
  logic or_3400;
  assign or_3400 = registration_moved_q | (registration_enough_q & (and_3385 | and_3397));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3484;
  assign select_3484 = sample_pair_whole_s3_q ? (equal_2164_s3_q ? patches_place_0_slope_q : select_2270[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3489;
  assign select_3489 = sample_pair_whole_s3_q ? (equal_2164_s3_q ? patches_place_1_slope_q : select_2298[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3491;
  assign select_3491 = equal_2164_s3_q ? patches_valid_0_q : (select_2163_s3_q ? patches_valid_0_q : select_2266[0]);
  // hls/stages/agreement.hpp:277
  logic select_3494;
  assign select_3494 = sample_pair_whole_s3_q ? (and_2289 ? (sample_present_s3_q & select_3491) : select_3491) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3496;
  assign select_3496 = equal_2164_s3_q ? patches_valid_1_q : (select_2163_s3_q ? select_2266[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3499;
  assign select_3499 = sample_pair_whole_s3_q ? (and_2308 ? (sample_present_s3_q & select_3496) : select_3496) : patches_valid_1_q;
  logic [5:0] select_3502;
  assign select_3502 = sample_pair_whole_s3_q ? (select_2287[5] ? {1'b1, select_2287[4:0]} : (select_2287 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3505;
  assign select_3505 = sample_pair_whole_s3_q ? (select_2306[5] ? {1'b1, select_2306[4:0]} : (select_2306 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3508;
  assign select_3508 = sample_pair_whole_s3_q ? (select_2319[4] ? {1'b1, select_2319[3:0]} : (select_2319 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3511;
  assign select_3511 = sample_pair_whole_s3_q ? (select_2324[4] ? {1'b1, select_2324[3:0]} : (select_2324 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3930_s3_q, parity_3926_s3_q, xor_3914_s3_q, parity_3886_s3_q, parity_3824_s3_q, parity_3695_s3_q} + (equal_3931_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3935;
  assign select_3935 = equal_2250_s3_q ? patches_sums_values_0_q : (equal_2252_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3936;
  assign select_3936 = equal_2252_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3938;
  assign select_3938 = equal_2252_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3940;
  assign select_3940 = equal_2252_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3942;
  assign select_3942 = equal_2252_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3944;
  assign select_3944 = equal_2252_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3946;
  assign select_3946 = equal_2252_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3948;
  assign select_3948 = equal_2252_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3950;
  assign select_3950 = equal_2252_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3952;
  assign select_3952 = equal_2252_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3954;
  assign select_3954 = equal_2252_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3956;
  assign select_3956 = equal_2252_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3958;
  assign select_3958 = equal_2252_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3960;
  assign select_3960 = equal_2252_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3962;
  assign select_3962 = equal_2252_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3964;
  assign select_3964 = equal_2252_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3966;
  assign select_3966 = equal_2252_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_4037;
  assign difference_4037 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_4040;
  assign and_4040 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_4037, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_4043;
  assign not_4043 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_4046;
  assign and_4046 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_4040 & ((10'h38 < patches_peak_size_q) & not_4043));
  // hls/stages/patches.hpp:190
  logic and_4048;
  assign and_4048 = and_4031_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_4046);
  // hls/stages/patches.hpp:667
  logic not_4049;
  assign not_4049 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_4051;
  assign and_4051 = and_4048 & (not_2257_s3_q & not_4049);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4053;
  assign sum_4053 = {7'h0, and_4051} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_4057;
  assign sum_4057 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_4056_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_4064;
  assign not_4064 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4065;
  assign sum_4065 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4067;
  assign not_4067 = ~({eight, 3'h0} < {1'b0, sum_4065, fall_2[0]});
  logic [1:0] sum_4068;
  assign sum_4068 = {1'b0, not_4064} + {1'b0, not_4067};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_4069;
  assign sum_4069 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4071;
  assign not_4071 = ~({eight, 3'h0} < {sum_4069, fall_2[1:0]});
  logic not_4074;
  assign not_4074 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4075;
  assign sum_4075 = {1'b0, not_4071} + {1'b0, not_4074};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4068} + {1'b0, sum_4075};
  // hls/stages/patches.hpp:587
  logic [7:0] select_4078;
  assign select_4078 = less_4056_s3_q ? ({sum_4057, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_4057, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_4079;
  assign select_4079 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_4080;
  assign select_4080 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4081;
  assign sum_4081 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_4082;
  assign sum_4082 = {select_4080[5], select_4080} + {{3{sum_4081[3]}}, sum_4081};
  // hls/stages/patches.hpp:604
  logic [17:0] product_4083;
  assign product_4083 = $signed({{10{select_4079[7]}}, select_4079}) * $signed({{8{sum_4082[6]}}, sum_4082, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_4084;
  assign difference_4084 = {{6{select_4078[7]}}, select_4078} - {product_4083[17], product_4083[17:5]};
  // hls/stages/patches.hpp:611
  logic less_4085;
  assign less_4085 = $signed({{7{difference_4055[6]}}, difference_4055}) < $signed(difference_4084);
  // hls/stages/patches.hpp:189
  logic not_4086;
  assign not_4086 = ~less_4085;
  // hls/stages/patches.hpp:670
  logic and_4087;
  assign and_4087 = not_4086 & and_4051;
  logic [7:0] sum_4088;
  assign sum_4088 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4087};
  // hls/stages/patches.hpp:189
  logic not_4091;
  assign not_4091 = ~($signed(difference_4084) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_4092;
  assign and_4092 = not_4091 & and_4051;
  logic [7:0] sum_4093;
  assign sum_4093 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4092};
  // hls/stages/patches.hpp:192
  logic and_4095;
  assign and_4095 = and_4048 & (patches_second_s3_q & not_4049);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4097;
  assign sum_4097 = {7'h0, and_4095} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_4099;
  assign and_4099 = not_4086 & and_4095;
  logic [7:0] sum_4100;
  assign sum_4100 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4099};
  // hls/stages/patches.hpp:671
  logic and_4102;
  assign and_4102 = not_4091 & and_4095;
  logic [7:0] sum_4103;
  assign sum_4103 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4102};
  // hls/stages/patches.hpp:192
  logic and_4105;
  assign and_4105 = and_4048 & (patches_lower_s3_q & not_2257_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4107;
  assign sum_4107 = {7'h0, and_4105} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_4109;
  assign and_4109 = not_4086 & and_4105;
  logic [7:0] sum_4110;
  assign sum_4110 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4109};
  // hls/stages/patches.hpp:671
  logic and_4112;
  assign and_4112 = not_4091 & and_4105;
  logic [7:0] sum_4113;
  assign sum_4113 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4112};
  // hls/stages/patches.hpp:192
  logic and_4115;
  assign and_4115 = and_4048 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_4117;
  assign sum_4117 = {7'h0, and_4115} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_4119;
  assign and_4119 = not_4086 & and_4115;
  logic [7:0] sum_4120;
  assign sum_4120 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4119};
  // hls/stages/patches.hpp:671
  logic and_4122;
  assign and_4122 = not_4091 & and_4115;
  logic [7:0] sum_4123;
  assign sum_4123 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4122};
  // hls/stages/agreement.hpp:1238
  logic equal_4124;
  assign equal_4124 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1145
  logic less_4125;
  assign less_4125 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_4129;
  assign and_4129 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & (equal_4124 & less_4125)));
  // hls/stages/agreement.hpp:1157
  logic and_4134;
  assign and_4134 = x_s3_q[6] & (not_2455_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:798
  logic and_4135;
  assign and_4135 = equal_569_s3_q & and_4134;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4137;
  assign or_4137 = (and_4129 ? patches_quarters_0_places_q : 8'h0) | (and_4135 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1157
  logic and_4141;
  assign and_4141 = x_s3_q[6] & (not_2455_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:798
  logic and_4142;
  assign and_4142 = equal_569_s3_q & and_4141;
  // hls/stages/agreement.hpp:1157
  logic and_4148;
  assign and_4148 = x_s3_q[6] & (not_2455_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:798
  logic and_4149;
  assign and_4149 = equal_569_s3_q & and_4148;
  // hls/stages/patches.hpp:633
  logic [7:0] or_4151;
  assign or_4151 = (or_4137 | (and_4142 ? patches_quarters_2_places_q : 8'h0)) | (and_4149 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_4155;
  assign select_4155 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:798
  logic and_4159;
  assign and_4159 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & (less_4125 & select_4155)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_4161;
  assign select_4161 = and_4129 ? (and_4159 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4163;
  assign select_4163 = and_4135 ? (and_4159 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4166;
  assign select_4166 = and_4142 ? (and_4159 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4169;
  assign select_4169 = and_4149 ? (and_4159 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_4172;
  assign select_4172 = and_4129 ? (and_4159 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4174;
  assign select_4174 = and_4135 ? (and_4159 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4177;
  assign select_4177 = and_4142 ? (and_4159 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4180;
  assign select_4180 = and_4149 ? (and_4159 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_4182;
  assign sum_4182 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1157
  logic and_4186;
  assign and_4186 = x_s3_q[6] & (not_2455_s3_q & (less_4125 & (sum_4182[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_4187;
  assign and_4187 = equal_569_s3_q & and_4186;
  // hls/stages/patches.hpp:630
  logic [7:0] select_4190;
  assign select_4190 = and_4187 ? (patches_word_places_q + (and_4135 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4193;
  assign select_4193 = and_4187 ? (patches_word_up_q + (and_4135 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4196;
  assign select_4196 = and_4187 ? (patches_word_down_q + (and_4135 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_4199;
  assign select_4199 = ($signed(difference_4084[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4084[5:0];
  logic [5:0] select_4200;
  assign select_4200 = ($signed(14'h10) < $signed(difference_4084)) ? 6'h10 : select_4199;
  // hls/stages/patches.hpp:673
  logic [5:0] select_4201;
  assign select_4201 = and_4048 ? select_4200 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_4203;
  assign select_4203 = patches_round_ends_q ? {{6{select_4201[5]}}, select_4201} : (patches_across_q + {{6{select_4201[5]}}, select_4201});
  // hls/stages/agreement.hpp:798
  logic and_4207;
  assign and_4207 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q & (equal_3364 & less_4125)));
  // hls/stages/agreement.hpp:1157
  logic and_4211;
  assign and_4211 = x_s3_q[6] & (not_2455_s3_q & (less_4125 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_4212;
  assign and_4212 = equal_569_s3_q & and_4211;
  // hls/stages/patches.hpp:657
  logic [7:0] select_4214;
  assign select_4214 = and_4207 ? (and_4212 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_4218;
  assign or_4218 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_4221;
  assign or_4221 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_4222;
  assign sum_4222 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_4224;
  assign select_4224 = and_4207 ? (and_4212 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_4227;
  assign and_4227 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_4229;
  assign select_4229 = and_4212 ? {and_4227, patches_found_q[2:1]} : (and_4207 ? {and_4227, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_4233;
  assign or_4233 = patches_partly_q | (patches_doubted_q & (~and_4212));
  // hls/stages/patches.hpp:656
  logic select_4236;
  assign select_4236 = and_4207 ? (and_4212 ? or_4233 : (and_4207 ? or_4233 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_4237;
  assign select_4237 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4241;
  assign select_4241 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_4243;
  assign sum_4243 = {sum_4082[6], sum_4082, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_4245;
  assign and_4245 = ({{5{sum_4243[10]}}, sum_4243} < 16'h3) & and_4048;
  logic [7:0] sum_4246;
  assign sum_4246 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4245};
  // hls/stages/patches.hpp:663
  logic [12:0] product_4251;
  assign product_4251 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_4214};
  // hls/stages/patches.hpp:192
  logic and_4253;
  assign and_4253 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_4251[12:5] < patches_on_skin_q);
  logic select_4258;
  assign select_4258 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_4262;
  assign or_4262 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_4269;
  assign select_4269 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_4275;
  assign and_4275 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4276;
  assign sum_4276 = patches_age_q + {9'h0, and_4275};
  logic [9:0] select_4279;
  assign select_4279 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4276)) : sum_4276;
  // hls/stages/agreement.hpp:1203
  logic or_4337;
  assign or_4337 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1232
  logic equal_4339;
  assign equal_4339 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1241
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1242
  logic select_4345;
  assign select_4345 = (equal_4339 & equal_4124) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_4348;
  assign sum_4348 = {1'b0, select_3114} + {2'h0, select_3114[9:1]};
  logic select_4351;
  assign select_4351 = (select_3111[9:3] == 7'h0) ? ((~or_4337) & (~select_4345)) : (~({sum_4348, select_3114[0]} < {2'h0, select_3111}));
  // hls/stages/agreement.hpp:1157
  logic [47:0] select_4353;
  assign select_4353 = x_s3_q[6] ? (equal_2081_s3_q ? good_q : {select_4351, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic select_4358;
  assign select_4358 = equal_569_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4356_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1232
  logic equal_4359;
  assign equal_4359 = x_s3_q[6:3] == 4'ha;
  logic equal_4361;
  assign equal_4361 = x_s3_q[6:3] == 4'hc;
  logic equal_4362;
  assign equal_4362 = x_s3_q[6:3] == 4'hb;
  logic equal_4363;
  assign equal_4363 = x_s3_q[6:3] == 4'h9;
  logic equal_4364;
  assign equal_4364 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_4366;
  assign select_4366 = equal_4363 ? counts_skin_unproven_q : (equal_4364 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4368;
  assign select_4368 = equal_4362 ? counts_regions_bad_q : (equal_4359 ? counts_nearer_q : select_4366);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4361 ? counts_on_skin_q : select_4368;
  // hls/stages/agreement.hpp:1237
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1245
  logic select_4371;
  assign select_4371 = (equal_4359 & equal_4124) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1163
  logic not_4372;
  assign not_4372 = ~hidden_for_q[7];
  logic [7:0] select_4374;
  assign select_4374 = select_4371 ? (hidden_for_q + {7'h0, not_4372}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_4376;
  assign select_4376 = equal_569_s3_q ? (equal_4356_s3_q ? select_4374 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1246
  logic [13:0] select_4377;
  assign select_4377 = equal_4124 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1140
  logic [7:0] select_4379;
  assign select_4379 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4381;
  assign select_4381 = equal_4364 ? cfg_unproven_skin_limit_i : (equal_4339 ? cfg_unproven_limit_i : select_4379);
  logic [7:0] select_4383;
  assign select_4383 = equal_4359 ? cfg_regions_limit_i : (equal_4363 ? cfg_hidden_limit_i : select_4381);
  logic [7:0] limit;
  assign limit = equal_4361 ? cfg_regions_limit_i : (equal_4362 ? {cfg_on_skin_limit_i, 3'h0} : select_4383);
  // hls/stages/agreement.hpp:1246
  logic not_4386;
  assign not_4386 = ~x_s3_q[2];
  logic [3:0] select_4387;
  assign select_4387 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4386, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4386};
  logic [7:0] select_4388;
  assign select_4388 = x_s3_q[0] ? {select_4387[3], 1'b0, select_4387[2], 1'b0, select_4387[1], 1'b0, select_4387[0], 1'b0} : {1'b0, select_4387[3], 1'b0, select_4387[2], 1'b0, select_4387[1], 1'b0, select_4387[0]};
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_4392;
  assign select_4392 = equal_4363 ? counts_skin_supervised_q : (equal_4364 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4394;
  assign select_4394 = equal_4362 ? counts_skin_textured_q : (equal_4359 ? counts_textured_q : select_4392);
  logic [13:0] of;
  assign of = equal_4361 ? counts_textured_q : select_4394;
  // hls/stages/agreement.hpp:1246
  logic [13:0] select_4396;
  assign select_4396 = ((limit & select_4388) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4377} + {1'b0, select_4396};
  // hls/stages/agreement.hpp:798
  logic select_4401;
  assign select_4401 = equal_569_s3_q ? (equal_4124 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1243
  logic and_4406;
  assign and_4406 = too_much_q & (~(equal_4364 & equal_4124));
  // hls/stages/agreement.hpp:1244
  logic select_4411;
  assign select_4411 = (over[14] & equal_4124) ? (and_4406 | ((equal_4364 | equal_4363) | (x_s3_q[6:3] == 4'hf))) : and_4406;
  // hls/stages/agreement.hpp:1140
  logic and_4416;
  assign and_4416 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1246
  logic select_4417;
  assign select_4417 = (equal_4361 & equal_4124) ? and_4416 : overlooks_q;
  // hls/stages/agreement.hpp:798
  logic [2:0] select_4419;
  assign select_4419 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4421;
  assign select_4421 = equal_569_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_4419 : box_textured_columns_values_0_q);
  logic [2:0] select_4422;
  assign select_4422 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4424;
  assign select_4424 = equal_569_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4422 : box_textured_columns_values_1_q);
  logic [2:0] select_4425;
  assign select_4425 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4427;
  assign select_4427 = equal_569_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4425 : box_textured_columns_values_2_q);
  logic [2:0] select_4428;
  assign select_4428 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4430;
  assign select_4430 = equal_569_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4428 : box_textured_columns_values_3_q);
  logic [2:0] select_4431;
  assign select_4431 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4433;
  assign select_4433 = equal_569_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4431 : box_textured_columns_values_4_q);
  logic [4:0] select_4435;
  assign select_4435 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4437;
  assign select_4437 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4439;
  assign select_4439 = equal_569_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4437 : box_explained_columns_values_0_q);
  logic [2:0] select_4440;
  assign select_4440 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4442;
  assign select_4442 = equal_569_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4440 : box_explained_columns_values_1_q);
  logic [2:0] select_4443;
  assign select_4443 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4445;
  assign select_4445 = equal_569_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4443 : box_explained_columns_values_2_q);
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_569_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4446 : box_explained_columns_values_3_q);
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_569_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4449 : box_explained_columns_values_4_q);
  logic [4:0] select_4453;
  assign select_4453 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4456;
  assign select_4456 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4458;
  assign select_4458 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4460;
  assign select_4460 = equal_569_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4458 : box_shown_columns_values_1_q);
  logic [2:0] select_4461;
  assign select_4461 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4463;
  assign select_4463 = equal_569_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4461 : box_shown_columns_values_2_q);
  logic [2:0] select_4464;
  assign select_4464 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4466;
  assign select_4466 = equal_569_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4464 : box_shown_columns_values_3_q);
  logic [2:0] select_4467;
  assign select_4467 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4469;
  assign select_4469 = equal_569_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4467 : box_shown_columns_values_4_q);
  logic [4:0] select_4471;
  assign select_4471 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4474;
  assign select_4474 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4476;
  assign select_4476 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4478;
  assign select_4478 = equal_569_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4476 : box_nearer_columns_values_1_q);
  logic [2:0] select_4479;
  assign select_4479 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4481;
  assign select_4481 = equal_569_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4479 : box_nearer_columns_values_2_q);
  logic [2:0] select_4482;
  assign select_4482 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4484;
  assign select_4484 = equal_569_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4482 : box_nearer_columns_values_3_q);
  logic [2:0] select_4485;
  assign select_4485 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4487;
  assign select_4487 = equal_569_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4485 : box_nearer_columns_values_4_q);
  logic [4:0] select_4489;
  assign select_4489 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1324
  logic [1:0] select_4536;
  assign select_4536 = and_4535_s3_q ? {and_2598, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4540;
  assign select_4540 = and_2527_s3_q ? (less_2528_s3_q ? (select_4536[0] & and_4537_s3_q) : seen_q) : seen_q;
  logic select_4543;
  assign select_4543 = and_2527_s3_q ? (less_2528_s3_q ? (select_4536[1] & and_4537_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1254
  logic or_4550;
  assign or_4550 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4549_s3_q;
  // hls/stages/agreement.hpp:1256
  logic not_4558;
  assign not_4558 = ~(or_4337 | not_2823);
  // hls/stages/agreement.hpp:798
  logic and_4562;
  assign and_4562 = equal_569_s3_q & (equal_4356_s3_q & (not_4558 & (select_4345 | select_4411)));
  logic and_4565;
  assign and_4565 = equal_4356_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1165
  logic or_4569;
  assign or_4569 = select_2921 | (select_2933 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:798
  logic and_4576;
  assign and_4576 = equal_569_s3_q & (equal_4356_s3_q & (not_4558 & (select_2927 | select_2939)));
  // hls/stages/agreement.hpp:1165
  logic and_4581;
  assign and_4581 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4374 < cfg_hidden_frames_i));
  logic select_4587;
  assign select_4587 = (not_2823 | (select_4417 & not_4248)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:798
  logic and_4592;
  assign and_4592 = equal_569_s3_q & (equal_4356_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4596;
  assign and_4596 = equal_569_s3_q & (x_s3_q[6] & (not_2455_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1155
  logic [31:0] select_4604;
  assign select_4604 = equal_2103_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4602_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4605;
  assign select_4605 = equal_2101_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4604;
  logic [31:0] select_4606;
  assign select_4606 = equal_2099_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4605;
  logic [31:0] select_4607;
  assign select_4607 = equal_2097_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4606;
  logic [31:0] select_4608;
  assign select_4608 = equal_2095_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4607;
  logic [31:0] select_4609;
  assign select_4609 = equal_2093_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4608;
  logic [31:0] select_4610;
  assign select_4610 = equal_2091_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4609;
  logic [31:0] select_4611;
  assign select_4611 = equal_2089_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4610;
  // hls/stages/agreement.hpp:1153
  logic [9:0] select_4612;
  assign select_4612 = less_3110 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4613;
  assign select_4613 = equal_2081_s3_q ? select_4611 : {2'h0, select_4612, select_3114, select_3111};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_544_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_745_s3_q, and_744, less_739_s3_q, and_738_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_732, and_708_s3_q, and_707_s3_q, and_682_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q};
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
  assign registration_sums_waddr = {sum_2087_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2146_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2145, sum_2141};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2172_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2249_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2221_s3_q};
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
  assign patches_right_0_waddr = {select_2280_s3_q, select_2277};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2289);
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
  assign patches_right_1_waddr = {select_2280_s3_q, select_2305};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2308);
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
  assign patches_left_waddr = {select_2327, select_2326_s3_q, column_6};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2333);
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
  assign patches_rows_wdata = select_2443;
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
  assign regions_waddr = {region_row_s3_q, or_2453_s3_q, or_2450_s3_q, or_2447_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2491_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2490, sum_2479, sum_2473};
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
  assign map_waddr = {sum_2534_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2610_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2598, is_seen};
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
      census_left_misses_q <= select_2762;
      sharpness_before_last_mask_q <= select_2835;
      sharpness_sums_detail_0_q <= and_544_s3_q ? select_2849 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_544_s3_q ? select_2861 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_544_s3_q ? sum_2865 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_544_s3_q ? sum_2869 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2887 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2897 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2899 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2901 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2903 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2905 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2910;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2913 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2921;
      sharpness_comparing_less_detail_1_q <= select_2927;
      sharpness_comparing_less_contrast_0_q <= select_2933;
      sharpness_comparing_less_contrast_1_q <= select_2939;
      counts_supervised_q <= select_3066;
      counts_textured_q <= and_3057_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3069});
      counts_explained_q <= and_3057_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3074});
      counts_nearer_q <= and_3057_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3079});
      counts_unproven_q <= and_3057_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3107});
      counts_regions_bad_q <= select_3123;
      counts_skin_supervised_q <= select_3131;
      counts_skin_textured_q <= select_3138;
      counts_skin_unproven_q <= select_3146;
      counts_on_skin_q <= select_3166;
      registration_half_across_q <= select_3246;
      registration_half_measured_q <= select_3251;
      registration_half_votes_down_q <= and_3224_s3_q ? 7'h0 : sum_3257;
      registration_half_votes_up_q <= and_3224_s3_q ? 7'h0 : sum_3265;
      registration_half_half_votes_down_q <= and_3224_s3_q ? 7'h0 : sum_3272;
      registration_half_half_votes_up_q <= and_3224_s3_q ? 7'h0 : sum_3279;
      registration_down_q <= and_3312 ? sum_3331 : registration_down_q;
      registration_up_q <= and_3312 ? sum_3340 : registration_up_q;
      registration_enough_q <= select_3354;
      registration_votes_down_q <= and_3359 ? less_3360 : registration_votes_down_q;
      registration_votes_up_q <= and_3359 ? less_3362 : registration_votes_up_q;
      registration_other_enough_q <= and_3368 ? select_3354 : registration_other_enough_q;
      registration_other_down_q <= and_3368 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3368 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_569_s3_q & and_3375)) & or_3400;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2268 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2271 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2272 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3484;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2297 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2299 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2300 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3489;
      patches_valid_0_q <= select_3494;
      patches_valid_1_q <= select_3499;
      patches_right_next_0_q <= select_3502;
      patches_right_next_1_q <= select_3505;
      patches_left_next_0_q <= select_3508;
      patches_left_next_1_q <= select_3511;
      patches_sums_values_0_q <= select_3935;
      patches_sums_values_1_q <= equal_2250_s3_q ? patches_sums_values_1_q : select_3936;
      patches_sums_values_2_q <= equal_2250_s3_q ? patches_sums_values_2_q : select_3938;
      patches_sums_values_3_q <= equal_2250_s3_q ? patches_sums_values_3_q : select_3940;
      patches_sums_values_4_q <= equal_2250_s3_q ? patches_sums_values_4_q : select_3942;
      patches_sums_values_5_q <= equal_2250_s3_q ? patches_sums_values_5_q : select_3944;
      patches_sums_values_6_q <= equal_2250_s3_q ? patches_sums_values_6_q : select_3946;
      patches_sums_values_7_q <= equal_2250_s3_q ? patches_sums_values_7_q : select_3948;
      patches_sums_values_8_q <= equal_2250_s3_q ? patches_sums_values_8_q : select_3950;
      patches_sums_values_9_q <= equal_2250_s3_q ? patches_sums_values_9_q : select_3952;
      patches_sums_values_10_q <= equal_2250_s3_q ? patches_sums_values_10_q : select_3954;
      patches_sums_values_11_q <= equal_2250_s3_q ? patches_sums_values_11_q : select_3956;
      patches_sums_values_12_q <= equal_2250_s3_q ? patches_sums_values_12_q : select_3958;
      patches_sums_values_13_q <= equal_2250_s3_q ? patches_sums_values_13_q : select_3960;
      patches_sums_values_14_q <= equal_2250_s3_q ? patches_sums_values_14_q : select_3962;
      patches_sums_values_15_q <= equal_2250_s3_q ? patches_sums_values_15_q : select_3964;
      patches_sums_values_16_q <= equal_2250_s3_q ? patches_sums_values_16_q : select_3966;
      patches_best_differing_q <= select_2443[9:0];
      patches_best_column_q <= select_2443[14:10];
      patches_quarters_0_places_q <= sum_4053;
      patches_quarters_0_up_q <= sum_4088;
      patches_quarters_0_down_q <= sum_4093;
      patches_quarters_1_places_q <= sum_4097;
      patches_quarters_1_up_q <= sum_4100;
      patches_quarters_1_down_q <= sum_4103;
      patches_quarters_2_places_q <= sum_4107;
      patches_quarters_2_up_q <= sum_4110;
      patches_quarters_2_down_q <= sum_4113;
      patches_quarters_3_places_q <= sum_4117;
      patches_quarters_3_up_q <= sum_4120;
      patches_quarters_3_down_q <= sum_4123;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_4151;
      patches_word_up_q <= ((select_4161 | select_4163) | select_4166) | select_4169;
      patches_word_down_q <= ((select_4172 | select_4174) | select_4177) | select_4180;
      patches_sum_places_q <= select_4190;
      patches_sum_up_q <= select_4193;
      patches_sum_down_q <= select_4196;
      patches_across_q <= select_4203;
      patches_places_q <= select_4214;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4218;
      patches_partly_q <= or_4221;
      patches_clear_limit_q <= sum_4222[8:2];
      patches_complete_q <= select_4224;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4207 ? select_4229 : patches_found_q;
      patches_doubted_q <= select_4236;
      patches_doubted_before_q <= select_4237;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4241;
      patches_on_skin_q <= sum_4246;
      patches_large_q <= not_4248 & and_4253;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4258;
      patches_spoiled_q <= or_4262;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4269;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4279;
      segment_textured_q <= select_2470 + {6'h0, and_3069};
      segment_explained_q <= select_2476 + {6'h0, and_3074};
      segment_nearer_q <= select_2487 + {6'h0, and_3079};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_569_s3_q ? select_4353 : good_q;
      good_known_q <= select_4358;
      hidden_for_q <= select_4376;
      product_q <= equal_569_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4401;
      disagree_q <= equal_569_s3_q ? select_4345 : disagree_q;
      too_much_q <= equal_569_s3_q ? select_4411 : too_much_q;
      hides_q <= equal_569_s3_q ? select_4371 : hides_q;
      overlooks_q <= equal_569_s3_q ? select_4417 : overlooks_q;
      seen_q <= select_4540;
      nearer_q <= select_4543;
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
      averager_quarter_1_0_q <= select_2636;
      averager_quarter_1_1_q <= select_2638;
      averager_quarter_2_0_q <= select_2640;
      averager_quarter_2_1_q <= select_2642;
      averager_detail_0_q <= select_2654;
      averager_detail_1_q <= select_2662;
      census_changes_values_0_left_q <= and_544_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_544_s3_q ? sum_2746 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2748;
      census_changes_values_1_right_q <= select_2749;
      census_changes_values_2_left_q <= select_2750;
      census_changes_values_2_right_q <= select_2751;
      sharpness_last_mask_q <= and_544_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_544_s3_q ? select_2832[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_544_s3_q ? select_2832[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4421;
      box_textured_columns_values_1_q <= select_4424;
      box_textured_columns_values_2_q <= select_4427;
      box_textured_columns_values_3_q <= select_4430;
      box_textured_columns_values_4_q <= select_4433;
      box_textured_sum_sums_values_0_q <= equal_569_s3_q ? box_textured_sum_sums_values_0_q : select_4435;
      box_explained_columns_values_0_q <= select_4439;
      box_explained_columns_values_1_q <= select_4442;
      box_explained_columns_values_2_q <= select_4445;
      box_explained_columns_values_3_q <= select_4448;
      box_explained_columns_values_4_q <= select_4451;
      box_explained_sum_sums_values_0_q <= equal_569_s3_q ? box_explained_sum_sums_values_0_q : select_4453;
      box_shown_columns_values_0_q <= equal_569_s3_q ? box_shown_columns_values_0_q : select_4456;
      box_shown_columns_values_1_q <= select_4460;
      box_shown_columns_values_2_q <= select_4463;
      box_shown_columns_values_3_q <= select_4466;
      box_shown_columns_values_4_q <= select_4469;
      box_shown_sum_sums_values_0_q <= equal_569_s3_q ? box_shown_sum_sums_values_0_q : select_4471;
      box_nearer_columns_values_0_q <= equal_569_s3_q ? box_nearer_columns_values_0_q : select_4474;
      box_nearer_columns_values_1_q <= select_4478;
      box_nearer_columns_values_2_q <= select_4481;
      box_nearer_columns_values_3_q <= select_4484;
      box_nearer_columns_values_4_q <= select_4487;
      box_nearer_sum_sums_values_0_q <= equal_569_s3_q ? box_nearer_sum_sums_values_0_q : select_4489;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4520_s4_q;
  logic or_4544_s4_q;
  logic and_4545_s4_q;
  logic and_4553_s4_q;
  logic and_4556_s4_q;
  logic and_4562_s4_q;
  logic and_4566_s4_q;
  logic and_4572_s4_q;
  logic and_4576_s4_q;
  logic and_4584_s4_q;
  logic and_4589_s4_q;
  logic and_4592_s4_q;
  logic and_4596_s4_q;
  logic [5:0] select_4598_s4_q;
  logic [31:0] select_4615_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4520_s4_q <= and_4520_s3_q;
      or_4544_s4_q <= not_2823 | select_4540;
      and_4545_s4_q <= cfg_prove_i & select_4543;
      and_4553_s4_q <= equal_569_s3_q & (equal_4356_s3_q & (cfg_prove_i & or_4550));
      and_4556_s4_q <= equal_569_s3_q & (equal_4356_s3_q & (cfg_prove_i & or_4337));
      and_4562_s4_q <= and_4562;
      and_4566_s4_q <= equal_569_s3_q & and_4565;
      and_4572_s4_q <= equal_569_s3_q & (equal_4356_s3_q & (not_4558 & or_4569));
      and_4576_s4_q <= and_4576;
      and_4584_s4_q <= equal_569_s3_q & (equal_4356_s3_q & (cfg_prove_i & and_4581));
      and_4589_s4_q <= equal_569_s3_q & (equal_4356_s3_q & select_4587);
      and_4592_s4_q <= and_4592;
      and_4596_s4_q <= and_4596;
      select_4598_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4615_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? select_4613 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4544_s4_q;
  assign marks_nearer_o = and_4545_s4_q;
  assign verdict_valid_o = and_4520_s4_q;
  assign verdict_unproven_yet_o = and_4553_s4_q;
  assign verdict_untextured_o = and_4556_s4_q;
  assign verdict_disagree_o = and_4562_s4_q;
  assign verdict_moved_o = and_4566_s4_q;
  assign verdict_unsharp_left_o = and_4572_s4_q;
  assign verdict_unsharp_right_o = and_4576_s4_q;
  assign verdict_hidden_o = and_4584_s4_q;
  assign verdict_overlooked_o = and_4589_s4_q;
  assign verdict_out_of_step_o = and_4592_s4_q;
  assign frame_valid_o = and_4596_s4_q;
  assign frame_index_o = select_4598_s4_q;
  assign frame_word_o = select_4615_s4_q;
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
  assign unused_bits = ^{over[13:0], sum_4287[6:0], product_4251[4:0], sum_4222[1:0], sum_4182[1:0], product_4083[4:0], sum_3214[0], difference_3152[1:0], detail_4[1:0], detail_3[1:0], sum_2756[4:0], sum_2188[0], sum_2184[0], sum_730[4:0], cfg_width_i[2:0]};

endmodule
