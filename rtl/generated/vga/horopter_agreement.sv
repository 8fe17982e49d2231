// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3046 bits, pipeline 862 bits, memories 127160 bits.
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
  logic [5:0] sum_2979;
  assign sum_2979 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4023;
  assign difference_4023 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4239;
  assign not_4239 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4296;
  assign difference_4296 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4511;
  assign less_4511 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4512;
  assign sum_4512 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4530;
  assign not_4530 = ~cfg_prove_i;

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
  logic [2:0] select_489;
  assign select_489 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_491;
  assign select_491 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [8:0] select_494;
  assign select_494 = ({select_491, select_489} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_495;
  assign select_495 = select_489[0] ? averager_place_q : select_494;
  // hls/stages/census.hpp:42
  logic or_496;
  assign or_496 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:417
  logic and_499;
  assign and_499 = (select_489[0] & or_496) & (select_495[8:6] < 3'h5);
  // hls/stages/census.hpp:42
  logic [2:0] select_504;
  assign select_504 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_491 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_521;
  assign equal_521 = select_489 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_522;
  assign equal_522 = select_504 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_523;
  assign and_523 = equal_522 & and_499;
  // hls/stages/agreement.hpp:276
  logic and_525;
  assign and_525 = sample_pair_whole_q & (equal_521 & and_523);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_553;
  assign equal_553 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_554;
  assign or_554 = so | equal_553;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_555;
  assign sum_555 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_556;
  assign select_556 = run_shift_q[5] ? x_q : sum_555;
  logic less_557;
  assign less_557 = {1'b0, last_q} < select_556;
  // hls/stages/agreement.hpp:226
  logic not_558;
  assign not_558 = ~less_557;
  // hls/stages/agreement.hpp:614
  logic equal_568;
  assign equal_568 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_569;
  assign equal_569 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_570;
  assign and_570 = equal_569 & not_558;
  logic select_572;
  assign select_572 = or_554 ? not_558 : (equal_568 ? not_558 : and_570);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_590;
  assign and_590 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_556)));
  logic and_591;
  assign and_591 = equal_568 & and_590;
  logic select_592;
  assign select_592 = or_554 ? not_558 : and_591;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_555[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:594
  logic not_622;
  assign not_622 = ~or_554;
  // hls/stages/agreement.hpp:149
  logic and_625;
  assign and_625 = not_622 & ((~equal_568) & and_570);
  // hls/stages/census.hpp:42
  logic [5:0] select_652;
  assign select_652 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_652 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_2124;
  assign and_2124 = (select_489 == 3'h0) & (select_491 == 7'h0);
  // hls/stages/patches.hpp:391
  logic not_2125;
  assign not_2125 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2128;
  assign not_2128 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:361
  logic and_2129;
  assign and_2129 = patches_capturing_q & not_2128;
  // hls/stages/patches.hpp:363
  logic equal_2130;
  assign equal_2130 = {or_496, select_504} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2132;
  assign equal_2132 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2137;
  assign and_2137 = (not_2125 & (patches_work_q == 3'h0)) & (~(and_2129 | ((~equal_2130) | (~equal_2132))));
  // hls/stages/patches.hpp:529
  logic equal_2225;
  assign equal_2225 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_2226;
  assign not_2226 = ~equal_2225;
  // hls/stages/patches.hpp:500
  logic equal_2227;
  assign equal_2227 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_2228;
  assign not_2228 = ~equal_2227;
  // hls/stages/patches.hpp:494
  logic equal_2229;
  assign equal_2229 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2230;
  assign equal_2230 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_2231;
  assign or_2231 = equal_2229 | equal_2230;
  // hls/stages/patches.hpp:455
  logic not_2232;
  assign not_2232 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_2254;
  assign select_2254 = and_2137 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2255;
  assign select_2255 = and_2124 ? select_2254 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2257;
  assign and_2257 = and_2129 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2261;
  assign select_2261 = and_2124 ? (and_2137 | (and_2129 & (~and_2257))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2269;
  assign and_2269 = not_2226 & (not_2228 & (or_2231 & (patches_second_q & equal_2230)));
  // hls/stages/patches.hpp:167
  logic not_2286;
  assign not_2286 = ~equal_2230;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2302;
  assign select_2302 = and_2124 ? {select_2254[4], select_2254[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_2312;
  assign and_2312 = not_2226 & (or_2231 & not_2228);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2569;
  assign select_2569 = sample_pair_whole_q ? (sample_last_q ? (select_504 + 3'h1) : select_504) : raster_at_y_q;
  logic [6:0] select_2571;
  assign select_2571 = sample_pair_whole_q ? (select_491 + {6'h0, equal_521}) : raster_at_column_q;
  logic [5:0] select_2574;
  assign select_2574 = sample_pair_whole_q ? (sample_last_q ? (select_652 + {5'h0, equal_522}) : select_652) : raster_at_row_q;
  logic select_2578;
  assign select_2578 = sample_pair_whole_q ? (sample_last_q ? (or_496 & (~raster_final_row_q)) : or_496) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2580;
  assign select_2580 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2584;
  assign select_2584 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic equal_2888;
  assign equal_2888 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:464
  logic and_2889;
  assign and_2889 = and_525 & equal_2888;
  // hls/stages/agreement.hpp:523
  logic select_2892;
  assign select_2892 = (and_2889 | (~ends_cell_q)) ? and_2889 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2892 ? (and_2889 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2896;
  assign select_2896 = select_2892 ? (and_2889 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2899;
  assign select_2899 = select_2892 ? (following_last_shift_q & (~and_2889)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2902;
  assign and_2902 = run_last_shift_q & equal_568;
  // hls/stages/agreement.hpp:616
  logic select_2904;
  assign select_2904 = equal_568 ? (~run_last_shift_q) : equal_569;
  // hls/stages/agreement.hpp:620
  logic equal_2905;
  assign equal_2905 = run_phase_q == 3'h1;
  logic not_2908;
  assign not_2908 = ~select_2904;
  // hls/stages/agreement.hpp:623
  logic equal_2910;
  assign equal_2910 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2911;
  assign and_2911 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2912;
  assign select_2912 = equal_2910 ? 2'h1 : {2{and_2911}};
  logic [2:0] select_2914;
  assign select_2914 = (and_2902 | (select_2904 | equal_2905)) ? (equal_2905 ? 3'h2 : {not_2908, {2{select_2904}}}) : (equal_553 ? 3'h6 : {select_2912[0], select_2912});
  // hls/stages/agreement.hpp:607
  logic and_2917;
  assign and_2917 = select_2904 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2920;
  assign select_2920 = (plan_shift_q[5] & select_2904) ? value : 7'h0;
  logic [1:0] or_2921;
  assign or_2921 = {2{so}} | select_2920[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2925;
  assign or_2925 = (select_2904 ? plan_columns_q : 8'h0) | ((equal_2905 | equal_2910) ? whole_q : 8'h0);
  logic [1:0] or_2926;
  assign or_2926 = {2{and_2902}} | or_2925[3:2];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2928;
  assign or_2928 = {or_2925[7:4], or_2926, or_2925[1:0]} | (equal_553 ? drawn_q : 8'h0);
  logic [4:0] or_2929;
  assign or_2929 = {5{so}} | {or_2928[6], or_2928[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2933;
  assign not_2933 = ~run_shift_q[5];
  logic [7:0] select_2936;
  assign select_2936 = equal_568 ? ({{7{not_2933}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2940;
  assign select_2940 = and_2889 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2942;
  assign select_2942 = select_2892 ? {select_2940[6], select_2940} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2945;
  assign select_2945 = select_2892 ? (and_2889 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2953;
  assign select_2953 = and_525 ? (equal_2888 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2956;
  assign select_2956 = and_525 ? (equal_2888 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2959;
  assign select_2959 = and_525 ? (equal_2888 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2970;
  assign select_2970 = (ends_cell_q | select_2892) ? (~(now == 3'h6)) : (equal_568 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2974;
  assign and_2974 = (~select_2892) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2975;
  assign sum_2975 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2977;
  assign select_2977 = equal_2888 ? ({sum_2975[6], cfg_height_i[8:3]} == {1'b0, sum_2975[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3336;
  assign select_3336 = and_2124 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3337;
  assign select_3337 = sample_pair_whole_q ? select_3336 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_3338;
  assign and_3338 = not_2128 & equal_2130;
  logic [8:0] select_3339;
  assign select_3339 = and_3338 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3340;
  assign select_3340 = and_3338 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3341;
  assign select_3341 = sample_pair_first_q ? select_3339 : select_3340;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3343;
  assign select_3343 = sample_pair_whole_q ? (and_2124 ? select_3341[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3345;
  assign select_3345 = sample_pair_whole_q ? (and_2124 ? select_3341[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3348;
  assign select_3348 = sample_pair_whole_q ? (equal_2132 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3350;
  assign select_3350 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2132}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3351;
  assign equal_3351 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3352;
  assign not_3352 = ~equal_3351;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3354;
  assign select_3354 = sample_pair_whole_q ? (phase + {not_3352, 1'b1, not_3352, equal_3351}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_3356;
  assign equal_3356 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3360;
  assign select_3360 = equal_3356 ? ((select_3337 == 4'h6) ? 4'h0 : (select_3337 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3361;
  assign equal_3361 = select_3360 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_3364;
  assign select_3364 = equal_2888 ? (equal_3361 ? 4'h6 : (select_3360 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3366;
  assign select_3366 = equal_3356 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_3368;
  assign select_3368 = equal_2888 ? (select_3366 + {4'h0, equal_3361}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_3373;
  assign select_3373 = and_525 ? (equal_2888 ? ((6'h2 < row) & equal_3361) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3375;
  assign select_3375 = and_525 ? (equal_2888 ? select_3366 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:370
  logic or_3399;
  assign or_3399 = select_491[0] | select_652[5];
  logic [7:0] sum_3400;
  assign sum_3400 = {1'b0, select_491[2:1], or_3399, select_652[4:1]} + 8'h1;
  logic less_3401;
  assign less_3401 = {sum_3400, select_652[0], select_504, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3404;
  assign select_3404 = and_2124 ? (and_2137 ? (~less_3401) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_3443;
  assign or_3443 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3449;
  assign and_3449 = equal_2225 & not_2232;
  // hls/stages/patches.hpp:398
  logic and_3450;
  assign and_3450 = not_2286 & and_3449;
  logic [1:0] select_3452;
  assign select_3452 = equal_2227 ? 2'h0 : (equal_2229 ? 2'h3 : {equal_2230, and_3450});
  // hls/stages/patches.hpp:279
  logic equal_3454;
  assign equal_3454 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3455;
  assign not_3455 = ~equal_3454;
  // hls/stages/patches.hpp:279
  logic equal_3456;
  assign equal_3456 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3457;
  assign not_3457 = ~equal_3456;
  // hls/stages/patches.hpp:283
  logic not_3459;
  assign not_3459 = ~(patches_following_q == 3'h2);
  logic and_3462;
  assign and_3462 = (~(patches_following_q == 3'h1)) & not_3459;
  // hls/stages/patches.hpp:396
  logic [1:0] select_3463;
  assign select_3463 = equal_3456 ? 2'h2 : {and_3462, not_3459};
  logic [3:0] select_3464;
  assign select_3464 = equal_3454 ? 4'h2 : {select_3463, {2{not_3457}}};
  // hls/stages/patches.hpp:404
  logic not_3467;
  assign not_3467 = ~or_3443;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_3472;
  assign select_3472 = or_3443 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3474;
  assign select_3474 = or_3443 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1371; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_625;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1372; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_572;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_554 ? x_q[6:0] : (equal_568 ? sum_555[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_572;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_554 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_592;
  logic [62:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [61:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[61:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2226 & (not_2228 & (or_2231 & (equal_2230 & not_2232))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2269;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2226 & (not_2228 & (not_2286 & or_2231)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:786; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_2312;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_489 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2569;
      raster_at_column_q <= select_2571;
      raster_at_row_q <= select_2574;
      raster_at_live_q <= select_2578;
      raster_rows_left_q <= sample_pair_whole_q ? select_2580 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2584;
      averager_place_q <= sample_pair_whole_q ? select_495 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2896;
      run_last_shift_q <= select_2899;
      run_span_q <= select_2892 ? (and_2889 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2914;
      following_shift_q <= select_2904 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2917;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2920[6], or_2921, select_2920[3:0]};
      following_columns_q <= {or_2928[7], or_2929[4], or_2928[5:4], or_2929[3:0]};
      plan_shift_q <= equal_568 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2936;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2942;
      columns_left_q <= select_2945;
      last_q <= and_525 ? (equal_2888 ? column : last_q) : last_q;
      least_q <= select_2953;
      whole_q <= select_2956;
      drawn_q <= select_2959;
      age_q <= select_2892 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2892 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2970;
      ends_q <= and_2974;
      final_row_q <= and_525 ? select_2977 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3337;
      patches_band_rows_rows_to_next_q <= select_3343;
      patches_band_rows_number_q <= select_3345;
      patches_next_band_rows_to_next_q <= select_3348;
      patches_next_band_number_q <= select_3350;
      patches_first_band_rows_to_next_q <= select_3354;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3351 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_525 ? select_3364 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_525 ? select_3368 : patches_choosing_number_q;
      patches_chooses_q <= select_3373;
      patches_choosing_band_q <= select_3375;
      patches_capturing_q <= sample_pair_whole_q ? select_2261 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3404 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2255 : patches_row_q;
      patches_work_q <= or_3443 ? following : patches_work_q;
      patches_second_q <= not_2125 & (patches_second_q | (patches_ends_q & equal_2225));
      patches_following_q <= equal_2225 ? {2'h0, and_3449} : {equal_2227, select_3452};
      patches_following_beats_q <= {select_3464, not_3455};
      patches_begins_q <= sample_pair_whole_q & (and_2124 & and_2257);
      patches_ends_q <= not_3467 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3472;
      patches_code_row_q <= select_3474;
      patches_column_q <= or_3443 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3467 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_489_s1_q;
  logic [6:0] select_491_s1_q;
  logic [8:0] select_495_s1_q;
  logic and_499_s1_q;
  logic equal_505_s1_q;
  logic [6:0] column_s1_q;
  logic and_523_s1_q;
  logic and_525_s1_q;
  logic equal_549_s1_q;
  logic so_s1_q;
  logic equal_553_s1_q;
  logic or_554_s1_q;
  logic less_557_s1_q;
  logic not_558_s1_q;
  logic equal_568_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_592_s1_q;
  logic [6:0] right_s1_q;
  logic and_625_s1_q;
  logic [5:0] row_s1_q;
  logic and_2010_s1_q;
  logic equal_2011_s1_q;
  logic and_2124_s1_q;
  logic and_2137_s1_q;
  logic equal_2225_s1_q;
  logic not_2226_s1_q;
  logic equal_2227_s1_q;
  logic not_2228_s1_q;
  logic equal_2229_s1_q;
  logic equal_2230_s1_q;
  logic or_2231_s1_q;
  logic [4:0] select_2255_s1_q;
  logic select_2261_s1_q;
  logic [3:0] select_2302_s1_q;
  logic and_2312_s1_q;
  logic equal_2888_s1_q;
  logic and_2889_s1_q;
  logic or_3443_s1_q;
  logic not_3467_s1_q;
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
      select_489_s1_q <= select_489;
      select_491_s1_q <= select_491;
      select_495_s1_q <= select_495;
      and_499_s1_q <= and_499;
      equal_505_s1_q <= select_504 == 3'h0;
      column_s1_q <= column;
      and_523_s1_q <= and_523;
      and_525_s1_q <= and_525;
      equal_549_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_553_s1_q <= equal_553;
      or_554_s1_q <= or_554;
      less_557_s1_q <= less_557;
      not_558_s1_q <= not_558;
      equal_568_s1_q <= equal_568;
      x_s1_2_q <= x[6:0];
      select_592_s1_q <= select_592;
      right_s1_q <= right;
      and_625_s1_q <= and_625;
      row_s1_q <= row;
      and_2010_s1_q <= not_622 & and_591;
      equal_2011_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2124_s1_q <= and_2124;
      and_2137_s1_q <= and_2137;
      equal_2225_s1_q <= equal_2225;
      not_2226_s1_q <= not_2226;
      equal_2227_s1_q <= equal_2227;
      not_2228_s1_q <= not_2228;
      equal_2229_s1_q <= equal_2229;
      equal_2230_s1_q <= equal_2230;
      or_2231_s1_q <= or_2231;
      select_2255_s1_q <= select_2255;
      select_2261_s1_q <= select_2261;
      select_2302_s1_q <= select_2302;
      and_2312_s1_q <= and_2312;
      equal_2888_s1_q <= equal_2888;
      and_2889_s1_q <= and_2889;
      or_3443_s1_q <= or_3443;
      not_3467_s1_q <= not_3467;
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
  logic and_500;
  assign and_500 = sample_pair_whole_s1_q & and_499_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_544;
  assign equal_544 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_545;
  assign equal_545 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic and_546;
  assign and_546 = equal_544 & equal_545;
  // hls/stages/moments.hpp:52
  logic [13:0] sum_547;
  assign sum_547 = moments_place_q + 14'h1;
  // hls/stages/agreement.hpp:1003
  logic [12:0] select_548;
  assign select_548 = and_546 ? 13'h0 : sum_547[12:0];
  // hls/stages/agreement.hpp:1009
  logic not_550;
  assign not_550 = ~equal_549_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_552;
  assign not_552 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_554_s1_q & not_558_s1_q;
  // hls/stages/moments.hpp:52
  logic [13:0] select_560;
  assign select_560 = and_546 ? 14'h0 : sum_547;
  // hls/stages/moments.hpp:54
  logic less_561;
  assign less_561 = 8'h4a < select_560[13:6];
  // hls/stages/moments.hpp:90
  logic not_562;
  assign not_562 = ~less_561;
  // hls/stages/agreement.hpp:788
  logic and_566;
  assign and_566 = not_550 & (not_552 & (equal_553_s1_q & (inside_v & not_562)));
  // hls/stages/agreement.hpp:975
  logic and_582;
  assign and_582 = (or_554_s1_q & (left_rdata_q[67] & not_558_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [6:0] select_601;
  assign select_601 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:668
  logic not_722;
  assign not_722 = ~equal_544;
  // hls/stages/agreement.hpp:671
  logic and_723;
  assign and_723 = left_rdata_q[12] & not_722;
  logic and_724;
  assign and_724 = left_rdata_q[30] & not_722;
  logic and_725;
  assign and_725 = left_rdata_q[48] & not_722;
  logic and_726;
  assign and_726 = left_rdata_q[66] & not_722;
  // hls/stages/agreement.hpp:672
  logic and_727;
  assign and_727 = right_codes_rdata_q[12] & not_722;
  logic and_728;
  assign and_728 = right_codes_rdata_q[27] & not_722;
  logic and_729;
  assign and_729 = right_codes_rdata_q[42] & not_722;
  logic and_730;
  assign and_730 = right_codes_rdata_q[57] & not_722;
  logic and_731;
  assign and_731 = right_codes_rdata_q[72] & not_722;
  logic and_732;
  assign and_732 = right_codes_rdata_q[85] & not_722;
  // hls/stages/agreement.hpp:221
  logic and_737;
  assign and_737 = left_rdata_q[48] & not_558_s1_q;
  logic and_738;
  assign and_738 = right_codes_rdata_q[42] & not_558_s1_q;
  logic [11:0] select_739;
  assign select_739 = less_557_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_740;
  assign select_740 = less_557_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_744;
  assign select_744 = and_737 ? (and_738 ? (~(select_739 ^ select_740)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_750;
  assign parity_750 = ^select_744[5:3];
  logic parity_753;
  assign parity_753 = ^select_744[8:6];
  logic parity_756;
  assign parity_756 = ^select_744[11:3];
  // hls/stages/agreement.hpp:221
  logic and_760;
  assign and_760 = left_rdata_q[66] & not_558_s1_q;
  logic and_761;
  assign and_761 = right_codes_rdata_q[57] & not_558_s1_q;
  logic [11:0] select_762;
  assign select_762 = less_557_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_763;
  assign select_763 = less_557_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_767;
  assign select_767 = and_760 ? (and_761 ? (~(select_762 ^ select_763)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_770;
  assign parity_770 = ^select_767[8:6];
  logic parity_773;
  assign parity_773 = ^select_767[11:9];
  // hls/stages/agreement.hpp:221
  logic and_777;
  assign and_777 = left_rdata_q[84] & not_558_s1_q;
  logic and_778;
  assign and_778 = right_codes_rdata_q[72] & not_558_s1_q;
  logic [11:0] select_779;
  assign select_779 = less_557_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_780;
  assign select_780 = less_557_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_784;
  assign select_784 = and_777 ? (and_778 ? (~(select_779 ^ select_780)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_790;
  assign parity_790 = ^select_784[2:0];
  logic parity_793;
  assign parity_793 = ^select_784[5:3];
  logic parity_796;
  assign parity_796 = ^select_784[8:0];
  logic parity_802;
  assign parity_802 = ^select_784[11:9];
  logic parity_805;
  assign parity_805 = ^select_767[2:0];
  logic parity_808;
  assign parity_808 = ^{select_784[11:9], select_767[5:0]};
  logic parity_811;
  assign parity_811 = ^{select_784, select_767, select_744[2:0]};
  logic xor_812;
  assign xor_812 = parity_756 ^ parity_811;
  // hls/stages/count_bits.hpp:23
  logic or_816;
  assign or_816 = (select_744[1:0] == 2'h3) | (select_744[2] & (select_744[0] | select_744[1]));
  // hls/stages/count_bits.hpp:25
  logic or_820;
  assign or_820 = (select_767[7:6] == 2'h3) | (select_767[8] & (select_767[6] | select_767[7]));
  logic or_824;
  assign or_824 = (select_767[10:9] == 2'h3) | (select_767[11] & (select_767[9] | select_767[10]));
  // hls/stages/count_bits.hpp:23
  logic or_832;
  assign or_832 = (select_784[7:6] == 2'h3) | (select_784[8] & (~(select_784[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_836;
  assign or_836 = (select_784[1:0] == 2'h3) | (select_784[2] & (select_784[0] | select_784[1]));
  logic or_840;
  assign or_840 = (select_784[4:3] == 2'h3) | (select_784[5] & (select_784[3] | select_784[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_843;
  assign parity_843 = ^{or_840, or_836, or_832};
  // hls/stages/count_bits.hpp:23
  logic or_847;
  assign or_847 = (select_767[4:3] == 2'h3) | (select_767[5] & (select_767[3] | select_767[4]));
  // hls/stages/count_bits.hpp:25
  logic or_851;
  assign or_851 = (select_784[10:9] == 2'h3) | (select_784[11] & (select_784[9] | select_784[10]));
  logic or_855;
  assign or_855 = (select_767[1:0] == 2'h3) | (select_767[2] & (select_767[0] | select_767[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_858;
  assign parity_858 = ^{or_855, or_851, or_847};
  logic parity_861;
  assign parity_861 = ^{or_855, or_851, or_847, or_840, or_836, or_832, or_824, or_820, or_816};
  // hls/stages/count_bits.hpp:25
  logic and_862;
  assign and_862 = parity_756 & parity_811;
  logic or_866;
  assign or_866 = (parity_750 & parity_753) | ((^select_744[11:9]) & (parity_750 | parity_753));
  logic and_869;
  assign and_869 = (^{select_767[11:6], select_744[2:0]}) & (parity_796 | parity_808);
  logic or_870;
  assign or_870 = (parity_796 & parity_808) | and_869;
  // hls/stages/count_bits.hpp:23
  logic or_877;
  assign or_877 = (select_744[10:9] == 2'h3) | (select_744[11] & (select_744[9] | select_744[10]));
  // hls/stages/count_bits.hpp:25
  logic or_881;
  assign or_881 = (select_744[4:3] == 2'h3) | (select_744[5] & (select_744[3] | select_744[4]));
  logic or_885;
  assign or_885 = (select_744[7:6] == 2'h3) | (select_744[8] & (select_744[6] | select_744[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_888;
  assign parity_888 = ^{or_885, or_881, or_877};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (parity_770 & parity_773) | ((^select_744[2:0]) & (parity_770 | parity_773));
  logic or_896;
  assign or_896 = (parity_790 & parity_793) | ((^select_784[8:6]) & (parity_790 | parity_793));
  logic or_900;
  assign or_900 = (parity_802 & parity_805) | ((^select_767[5:3]) & (parity_802 | parity_805));
  // hls/stages/count_bits.hpp:24
  logic parity_903;
  assign parity_903 = ^{or_900, or_896, or_892};
  logic parity_906;
  assign parity_906 = ^{or_900, or_896, or_892, or_885, or_881, or_877, or_870, or_866, and_862};
  logic xor_907;
  assign xor_907 = parity_861 ^ parity_906;
  // hls/stages/count_bits.hpp:25
  logic and_908;
  assign and_908 = parity_861 & parity_906;
  logic or_912;
  assign or_912 = (parity_843 & parity_858) | ((^{or_824, or_820, or_816}) & (parity_843 | parity_858));
  logic or_916;
  assign or_916 = (parity_888 & parity_903) | ((^{or_870, or_866, and_862}) & (parity_888 | parity_903));
  logic or_923;
  assign or_923 = (or_820 & or_824) | (or_816 & (or_820 | or_824));
  logic or_927;
  assign or_927 = (or_836 & or_840) | (or_832 & (or_836 | or_840));
  logic or_931;
  assign or_931 = (or_851 & or_855) | (or_847 & (or_851 | or_855));
  // hls/stages/count_bits.hpp:24
  logic parity_934;
  assign parity_934 = ^{or_931, or_927, or_923};
  // hls/stages/count_bits.hpp:25
  logic or_938;
  assign or_938 = (or_866 & or_870) | (and_862 & (or_866 | or_870));
  logic or_942;
  assign or_942 = (or_881 & or_885) | (or_877 & (or_881 | or_885));
  logic or_946;
  assign or_946 = (or_896 & or_900) | (or_892 & (or_896 | or_900));
  // hls/stages/count_bits.hpp:24
  logic parity_949;
  assign parity_949 = ^{or_946, or_942, or_938};
  logic parity_952;
  assign parity_952 = ^{or_946, or_942, or_938, or_931, or_927, or_923, or_916, or_912, and_908};
  // hls/stages/count_bits.hpp:25
  logic or_956;
  assign or_956 = (parity_934 & parity_949) | ((^{or_916, or_912, and_908}) & (parity_934 | parity_949));
  logic or_960;
  assign or_960 = (or_912 & or_916) | (and_908 & (or_912 | or_916));
  logic or_964;
  assign or_964 = (or_927 & or_931) | (or_923 & (or_927 | or_931));
  logic or_968;
  assign or_968 = (or_942 & or_946) | (or_938 & (or_942 | or_946));
  // hls/stages/count_bits.hpp:24
  logic parity_973;
  assign parity_973 = ^{or_968, or_964, or_960, or_956};
  // hls/stages/count_bits.hpp:25
  logic or_977;
  assign or_977 = (or_964 & or_968) | (or_960 & (or_964 | or_968));
  logic and_978;
  assign and_978 = or_956 & (^{or_968, or_964, or_960});
  // hls/stages/count_bits.hpp:24
  logic xor_979;
  assign xor_979 = or_977 ^ and_978;
  // hls/stages/count_bits.hpp:27
  logic and_980;
  assign and_980 = or_977 & and_978;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_981;
  assign select_981 = equal_568_s1_q ? {and_980, xor_979, parity_973, parity_952, xor_907, xor_812} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_554_s1_q ? 6'h0 : select_981;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_983;
  assign select_983 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_984;
  assign difference_984 = {1'b0, column_2} - {1'b0, select_983};
  logic [7:0] sum_986;
  assign sum_986 = {difference_984[6], difference_984} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_990;
  assign select_990 = and_737 ? (and_761 ? (~(select_739 ^ select_763)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_996;
  assign parity_996 = ^select_990[5:3];
  logic parity_999;
  assign parity_999 = ^select_990[8:6];
  logic parity_1002;
  assign parity_1002 = ^select_990[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1009;
  assign select_1009 = and_760 ? (and_778 ? (~(select_762 ^ select_780)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1012;
  assign parity_1012 = ^select_1009[8:6];
  logic parity_1015;
  assign parity_1015 = ^select_1009[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1019;
  assign and_1019 = right_codes_rdata_q[85] & not_558_s1_q;
  logic [11:0] select_1020;
  assign select_1020 = less_557_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1024;
  assign select_1024 = and_777 ? (and_1019 ? (~(select_779 ^ select_1020)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1030;
  assign parity_1030 = ^select_1024[2:0];
  logic parity_1033;
  assign parity_1033 = ^select_1024[5:3];
  logic parity_1036;
  assign parity_1036 = ^select_1024[8:0];
  logic parity_1042;
  assign parity_1042 = ^select_1024[11:9];
  logic parity_1045;
  assign parity_1045 = ^select_1009[2:0];
  logic parity_1048;
  assign parity_1048 = ^{select_1024[11:9], select_1009[5:0]};
  logic parity_1051;
  assign parity_1051 = ^{select_1024, select_1009, select_990[2:0]};
  logic xor_1052;
  assign xor_1052 = parity_1002 ^ parity_1051;
  // hls/stages/count_bits.hpp:23
  logic or_1056;
  assign or_1056 = (select_990[1:0] == 2'h3) | (select_990[2] & (select_990[0] | select_990[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1060;
  assign or_1060 = (select_1009[7:6] == 2'h3) | (select_1009[8] & (select_1009[6] | select_1009[7]));
  logic or_1064;
  assign or_1064 = (select_1009[10:9] == 2'h3) | (select_1009[11] & (select_1009[9] | select_1009[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1072;
  assign or_1072 = (select_1024[7:6] == 2'h3) | (select_1024[8] & (~(select_1024[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1076;
  assign or_1076 = (select_1024[1:0] == 2'h3) | (select_1024[2] & (select_1024[0] | select_1024[1]));
  logic or_1080;
  assign or_1080 = (select_1024[4:3] == 2'h3) | (select_1024[5] & (select_1024[3] | select_1024[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1083;
  assign parity_1083 = ^{or_1080, or_1076, or_1072};
  // hls/stages/count_bits.hpp:23
  logic or_1087;
  assign or_1087 = (select_1009[4:3] == 2'h3) | (select_1009[5] & (select_1009[3] | select_1009[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1091;
  assign or_1091 = (select_1024[10:9] == 2'h3) | (select_1024[11] & (select_1024[9] | select_1024[10]));
  logic or_1095;
  assign or_1095 = (select_1009[1:0] == 2'h3) | (select_1009[2] & (select_1009[0] | select_1009[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1098;
  assign parity_1098 = ^{or_1095, or_1091, or_1087};
  logic parity_1101;
  assign parity_1101 = ^{or_1095, or_1091, or_1087, or_1080, or_1076, or_1072, or_1064, or_1060, or_1056};
  // hls/stages/count_bits.hpp:25
  logic and_1102;
  assign and_1102 = parity_1002 & parity_1051;
  logic or_1106;
  assign or_1106 = (parity_996 & parity_999) | ((^select_990[11:9]) & (parity_996 | parity_999));
  logic and_1109;
  assign and_1109 = (^{select_1009[11:6], select_990[2:0]}) & (parity_1036 | parity_1048);
  logic or_1110;
  assign or_1110 = (parity_1036 & parity_1048) | and_1109;
  // hls/stages/count_bits.hpp:23
  logic or_1117;
  assign or_1117 = (select_990[10:9] == 2'h3) | (select_990[11] & (select_990[9] | select_990[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1121;
  assign or_1121 = (select_990[4:3] == 2'h3) | (select_990[5] & (select_990[3] | select_990[4]));
  logic or_1125;
  assign or_1125 = (select_990[7:6] == 2'h3) | (select_990[8] & (select_990[6] | select_990[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1128;
  assign parity_1128 = ^{or_1125, or_1121, or_1117};
  // hls/stages/count_bits.hpp:25
  logic or_1132;
  assign or_1132 = (parity_1012 & parity_1015) | ((^select_990[2:0]) & (parity_1012 | parity_1015));
  logic or_1136;
  assign or_1136 = (parity_1030 & parity_1033) | ((^select_1024[8:6]) & (parity_1030 | parity_1033));
  logic or_1140;
  assign or_1140 = (parity_1042 & parity_1045) | ((^select_1009[5:3]) & (parity_1042 | parity_1045));
  // hls/stages/count_bits.hpp:24
  logic parity_1143;
  assign parity_1143 = ^{or_1140, or_1136, or_1132};
  logic parity_1146;
  assign parity_1146 = ^{or_1140, or_1136, or_1132, or_1125, or_1121, or_1117, or_1110, or_1106, and_1102};
  logic xor_1147;
  assign xor_1147 = parity_1101 ^ parity_1146;
  // hls/stages/count_bits.hpp:25
  logic and_1148;
  assign and_1148 = parity_1101 & parity_1146;
  logic or_1152;
  assign or_1152 = (parity_1083 & parity_1098) | ((^{or_1064, or_1060, or_1056}) & (parity_1083 | parity_1098));
  logic or_1156;
  assign or_1156 = (parity_1128 & parity_1143) | ((^{or_1110, or_1106, and_1102}) & (parity_1128 | parity_1143));
  logic or_1163;
  assign or_1163 = (or_1060 & or_1064) | (or_1056 & (or_1060 | or_1064));
  logic or_1167;
  assign or_1167 = (or_1076 & or_1080) | (or_1072 & (or_1076 | or_1080));
  logic or_1171;
  assign or_1171 = (or_1091 & or_1095) | (or_1087 & (or_1091 | or_1095));
  // hls/stages/count_bits.hpp:24
  logic parity_1174;
  assign parity_1174 = ^{or_1171, or_1167, or_1163};
  // hls/stages/count_bits.hpp:25
  logic or_1178;
  assign or_1178 = (or_1106 & or_1110) | (and_1102 & (or_1106 | or_1110));
  logic or_1182;
  assign or_1182 = (or_1121 & or_1125) | (or_1117 & (or_1121 | or_1125));
  logic or_1186;
  assign or_1186 = (or_1136 & or_1140) | (or_1132 & (or_1136 | or_1140));
  // hls/stages/count_bits.hpp:24
  logic parity_1189;
  assign parity_1189 = ^{or_1186, or_1182, or_1178};
  logic parity_1192;
  assign parity_1192 = ^{or_1186, or_1182, or_1178, or_1171, or_1167, or_1163, or_1156, or_1152, and_1148};
  // hls/stages/count_bits.hpp:25
  logic or_1196;
  assign or_1196 = (parity_1174 & parity_1189) | ((^{or_1156, or_1152, and_1148}) & (parity_1174 | parity_1189));
  logic or_1200;
  assign or_1200 = (or_1152 & or_1156) | (and_1148 & (or_1152 | or_1156));
  logic or_1204;
  assign or_1204 = (or_1167 & or_1171) | (or_1163 & (or_1167 | or_1171));
  logic or_1208;
  assign or_1208 = (or_1182 & or_1186) | (or_1178 & (or_1182 | or_1186));
  // hls/stages/count_bits.hpp:24
  logic parity_1213;
  assign parity_1213 = ^{or_1208, or_1204, or_1200, or_1196};
  // hls/stages/count_bits.hpp:25
  logic or_1217;
  assign or_1217 = (or_1204 & or_1208) | (or_1200 & (or_1204 | or_1208));
  logic and_1218;
  assign and_1218 = or_1196 & (^{or_1208, or_1204, or_1200});
  // hls/stages/count_bits.hpp:24
  logic xor_1219;
  assign xor_1219 = or_1217 ^ and_1218;
  // hls/stages/count_bits.hpp:27
  logic and_1220;
  assign and_1220 = or_1217 & and_1218;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1221;
  assign select_1221 = equal_568_s1_q ? {and_1220, xor_1219, parity_1213, parity_1192, xor_1147, xor_1052} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_554_s1_q ? 6'h0 : select_1221;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1223;
  assign select_1223 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1224;
  assign difference_1224 = {1'b0, column_3} - {1'b0, select_1223};
  logic [7:0] sum_1226;
  assign sum_1226 = {difference_1224[6], difference_1224} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1227;
  assign and_1227 = right_codes_rdata_q[27] & not_558_s1_q;
  logic [11:0] select_1228;
  assign select_1228 = less_557_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1232;
  assign select_1232 = and_737 ? (and_1227 ? (~(select_739 ^ select_1228)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1238;
  assign parity_1238 = ^select_1232[5:3];
  logic parity_1241;
  assign parity_1241 = ^select_1232[8:6];
  logic parity_1244;
  assign parity_1244 = ^select_1232[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1251;
  assign select_1251 = and_760 ? (and_738 ? (~(select_762 ^ select_740)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1254;
  assign parity_1254 = ^select_1251[8:6];
  logic parity_1257;
  assign parity_1257 = ^select_1251[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1264;
  assign select_1264 = and_777 ? (and_761 ? (~(select_779 ^ select_763)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1270;
  assign parity_1270 = ^select_1264[2:0];
  logic parity_1273;
  assign parity_1273 = ^select_1264[5:3];
  logic parity_1276;
  assign parity_1276 = ^select_1264[8:0];
  logic parity_1282;
  assign parity_1282 = ^select_1264[11:9];
  logic parity_1285;
  assign parity_1285 = ^select_1251[2:0];
  logic parity_1288;
  assign parity_1288 = ^{select_1264[11:9], select_1251[5:0]};
  logic parity_1291;
  assign parity_1291 = ^{select_1264, select_1251, select_1232[2:0]};
  logic xor_1292;
  assign xor_1292 = parity_1244 ^ parity_1291;
  // hls/stages/count_bits.hpp:23
  logic or_1296;
  assign or_1296 = (select_1232[1:0] == 2'h3) | (select_1232[2] & (select_1232[0] | select_1232[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1300;
  assign or_1300 = (select_1251[7:6] == 2'h3) | (select_1251[8] & (select_1251[6] | select_1251[7]));
  logic or_1304;
  assign or_1304 = (select_1251[10:9] == 2'h3) | (select_1251[11] & (select_1251[9] | select_1251[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1312;
  assign or_1312 = (select_1264[7:6] == 2'h3) | (select_1264[8] & (~(select_1264[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1316;
  assign or_1316 = (select_1264[1:0] == 2'h3) | (select_1264[2] & (select_1264[0] | select_1264[1]));
  logic or_1320;
  assign or_1320 = (select_1264[4:3] == 2'h3) | (select_1264[5] & (select_1264[3] | select_1264[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1323;
  assign parity_1323 = ^{or_1320, or_1316, or_1312};
  // hls/stages/count_bits.hpp:23
  logic or_1327;
  assign or_1327 = (select_1251[4:3] == 2'h3) | (select_1251[5] & (select_1251[3] | select_1251[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1331;
  assign or_1331 = (select_1264[10:9] == 2'h3) | (select_1264[11] & (select_1264[9] | select_1264[10]));
  logic or_1335;
  assign or_1335 = (select_1251[1:0] == 2'h3) | (select_1251[2] & (select_1251[0] | select_1251[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1338;
  assign parity_1338 = ^{or_1335, or_1331, or_1327};
  logic parity_1341;
  assign parity_1341 = ^{or_1335, or_1331, or_1327, or_1320, or_1316, or_1312, or_1304, or_1300, or_1296};
  // hls/stages/count_bits.hpp:25
  logic and_1342;
  assign and_1342 = parity_1244 & parity_1291;
  logic or_1346;
  assign or_1346 = (parity_1238 & parity_1241) | ((^select_1232[11:9]) & (parity_1238 | parity_1241));
  logic and_1349;
  assign and_1349 = (^{select_1251[11:6], select_1232[2:0]}) & (parity_1276 | parity_1288);
  logic or_1350;
  assign or_1350 = (parity_1276 & parity_1288) | and_1349;
  // hls/stages/count_bits.hpp:23
  logic or_1357;
  assign or_1357 = (select_1232[10:9] == 2'h3) | (select_1232[11] & (select_1232[9] | select_1232[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1361;
  assign or_1361 = (select_1232[4:3] == 2'h3) | (select_1232[5] & (select_1232[3] | select_1232[4]));
  logic or_1365;
  assign or_1365 = (select_1232[7:6] == 2'h3) | (select_1232[8] & (select_1232[6] | select_1232[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1368;
  assign parity_1368 = ^{or_1365, or_1361, or_1357};
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (parity_1254 & parity_1257) | ((^select_1232[2:0]) & (parity_1254 | parity_1257));
  logic or_1376;
  assign or_1376 = (parity_1270 & parity_1273) | ((^select_1264[8:6]) & (parity_1270 | parity_1273));
  logic or_1380;
  assign or_1380 = (parity_1282 & parity_1285) | ((^select_1251[5:3]) & (parity_1282 | parity_1285));
  // hls/stages/count_bits.hpp:24
  logic parity_1383;
  assign parity_1383 = ^{or_1380, or_1376, or_1372};
  logic parity_1386;
  assign parity_1386 = ^{or_1380, or_1376, or_1372, or_1365, or_1361, or_1357, or_1350, or_1346, and_1342};
  logic xor_1387;
  assign xor_1387 = parity_1341 ^ parity_1386;
  // hls/stages/count_bits.hpp:25
  logic and_1388;
  assign and_1388 = parity_1341 & parity_1386;
  logic or_1392;
  assign or_1392 = (parity_1323 & parity_1338) | ((^{or_1304, or_1300, or_1296}) & (parity_1323 | parity_1338));
  logic or_1396;
  assign or_1396 = (parity_1368 & parity_1383) | ((^{or_1350, or_1346, and_1342}) & (parity_1368 | parity_1383));
  logic or_1403;
  assign or_1403 = (or_1300 & or_1304) | (or_1296 & (or_1300 | or_1304));
  logic or_1407;
  assign or_1407 = (or_1316 & or_1320) | (or_1312 & (or_1316 | or_1320));
  logic or_1411;
  assign or_1411 = (or_1331 & or_1335) | (or_1327 & (or_1331 | or_1335));
  // hls/stages/count_bits.hpp:24
  logic parity_1414;
  assign parity_1414 = ^{or_1411, or_1407, or_1403};
  // hls/stages/count_bits.hpp:25
  logic or_1418;
  assign or_1418 = (or_1346 & or_1350) | (and_1342 & (or_1346 | or_1350));
  logic or_1422;
  assign or_1422 = (or_1361 & or_1365) | (or_1357 & (or_1361 | or_1365));
  logic or_1426;
  assign or_1426 = (or_1376 & or_1380) | (or_1372 & (or_1376 | or_1380));
  // hls/stages/count_bits.hpp:24
  logic parity_1429;
  assign parity_1429 = ^{or_1426, or_1422, or_1418};
  logic parity_1432;
  assign parity_1432 = ^{or_1426, or_1422, or_1418, or_1411, or_1407, or_1403, or_1396, or_1392, and_1388};
  // hls/stages/count_bits.hpp:25
  logic or_1436;
  assign or_1436 = (parity_1414 & parity_1429) | ((^{or_1396, or_1392, and_1388}) & (parity_1414 | parity_1429));
  logic or_1440;
  assign or_1440 = (or_1392 & or_1396) | (and_1388 & (or_1392 | or_1396));
  logic or_1444;
  assign or_1444 = (or_1407 & or_1411) | (or_1403 & (or_1407 | or_1411));
  logic or_1448;
  assign or_1448 = (or_1422 & or_1426) | (or_1418 & (or_1422 | or_1426));
  // hls/stages/count_bits.hpp:24
  logic parity_1453;
  assign parity_1453 = ^{or_1448, or_1444, or_1440, or_1436};
  // hls/stages/count_bits.hpp:25
  logic or_1457;
  assign or_1457 = (or_1444 & or_1448) | (or_1440 & (or_1444 | or_1448));
  logic and_1458;
  assign and_1458 = or_1436 & (^{or_1448, or_1444, or_1440});
  // hls/stages/count_bits.hpp:24
  logic xor_1459;
  assign xor_1459 = or_1457 ^ and_1458;
  // hls/stages/count_bits.hpp:27
  logic and_1460;
  assign and_1460 = or_1457 & and_1458;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1461;
  assign select_1461 = equal_568_s1_q ? {and_1460, xor_1459, parity_1453, parity_1432, xor_1387, xor_1292} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_554_s1_q ? 6'h0 : select_1461;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1463;
  assign select_1463 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1464;
  assign difference_1464 = {1'b0, column_4} - {1'b0, select_1463};
  logic [7:0] sum_1466;
  assign sum_1466 = {difference_1464[6], difference_1464} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1474;
  assign select_1474 = and_737 ? (and_778 ? (~(select_739 ^ select_780)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1480;
  assign parity_1480 = ^select_1474[5:3];
  logic parity_1483;
  assign parity_1483 = ^select_1474[8:6];
  logic parity_1486;
  assign parity_1486 = ^select_1474[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1493;
  assign select_1493 = and_760 ? (and_1019 ? (~(select_762 ^ select_1020)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1496;
  assign parity_1496 = ^select_1493[8:6];
  logic parity_1499;
  assign parity_1499 = ^select_1493[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] xor_1505;
  assign xor_1505 = select_779 ^ (less_557_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1508;
  assign select_1508 = and_777 ? ((right_codes_rdata_q[98] & not_558_s1_q) ? (~xor_1505) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1514;
  assign parity_1514 = ^select_1508[2:0];
  logic parity_1517;
  assign parity_1517 = ^select_1508[5:3];
  logic parity_1520;
  assign parity_1520 = ^select_1508[8:0];
  logic parity_1526;
  assign parity_1526 = ^select_1508[11:9];
  logic parity_1529;
  assign parity_1529 = ^select_1493[2:0];
  logic parity_1532;
  assign parity_1532 = ^{select_1508[11:9], select_1493[5:0]};
  logic parity_1535;
  assign parity_1535 = ^{select_1508, select_1493, select_1474[2:0]};
  logic xor_1536;
  assign xor_1536 = parity_1486 ^ parity_1535;
  // hls/stages/count_bits.hpp:23
  logic or_1540;
  assign or_1540 = (select_1474[1:0] == 2'h3) | (select_1474[2] & (select_1474[0] | select_1474[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1544;
  assign or_1544 = (select_1493[7:6] == 2'h3) | (select_1493[8] & (select_1493[6] | select_1493[7]));
  logic or_1548;
  assign or_1548 = (select_1493[10:9] == 2'h3) | (select_1493[11] & (select_1493[9] | select_1493[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1556;
  assign or_1556 = (select_1508[7:6] == 2'h3) | (select_1508[8] & (~(select_1508[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1560;
  assign or_1560 = (select_1508[1:0] == 2'h3) | (select_1508[2] & (select_1508[0] | select_1508[1]));
  logic or_1564;
  assign or_1564 = (select_1508[4:3] == 2'h3) | (select_1508[5] & (select_1508[3] | select_1508[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1567;
  assign parity_1567 = ^{or_1564, or_1560, or_1556};
  // hls/stages/count_bits.hpp:23
  logic or_1571;
  assign or_1571 = (select_1493[4:3] == 2'h3) | (select_1493[5] & (select_1493[3] | select_1493[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1575;
  assign or_1575 = (select_1508[10:9] == 2'h3) | (select_1508[11] & (select_1508[9] | select_1508[10]));
  logic or_1579;
  assign or_1579 = (select_1493[1:0] == 2'h3) | (select_1493[2] & (select_1493[0] | select_1493[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1582;
  assign parity_1582 = ^{or_1579, or_1575, or_1571};
  logic parity_1585;
  assign parity_1585 = ^{or_1579, or_1575, or_1571, or_1564, or_1560, or_1556, or_1548, or_1544, or_1540};
  // hls/stages/count_bits.hpp:25
  logic and_1586;
  assign and_1586 = parity_1486 & parity_1535;
  logic or_1590;
  assign or_1590 = (parity_1480 & parity_1483) | ((^select_1474[11:9]) & (parity_1480 | parity_1483));
  logic and_1593;
  assign and_1593 = (^{select_1493[11:6], select_1474[2:0]}) & (parity_1520 | parity_1532);
  logic or_1594;
  assign or_1594 = (parity_1520 & parity_1532) | and_1593;
  // hls/stages/count_bits.hpp:23
  logic or_1601;
  assign or_1601 = (select_1474[10:9] == 2'h3) | (select_1474[11] & (select_1474[9] | select_1474[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1605;
  assign or_1605 = (select_1474[4:3] == 2'h3) | (select_1474[5] & (select_1474[3] | select_1474[4]));
  logic or_1609;
  assign or_1609 = (select_1474[7:6] == 2'h3) | (select_1474[8] & (select_1474[6] | select_1474[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1612;
  assign parity_1612 = ^{or_1609, or_1605, or_1601};
  // hls/stages/count_bits.hpp:25
  logic or_1616;
  assign or_1616 = (parity_1496 & parity_1499) | ((^select_1474[2:0]) & (parity_1496 | parity_1499));
  logic or_1620;
  assign or_1620 = (parity_1514 & parity_1517) | ((^select_1508[8:6]) & (parity_1514 | parity_1517));
  logic or_1624;
  assign or_1624 = (parity_1526 & parity_1529) | ((^select_1493[5:3]) & (parity_1526 | parity_1529));
  // hls/stages/count_bits.hpp:24
  logic parity_1627;
  assign parity_1627 = ^{or_1624, or_1620, or_1616};
  logic parity_1630;
  assign parity_1630 = ^{or_1624, or_1620, or_1616, or_1609, or_1605, or_1601, or_1594, or_1590, and_1586};
  logic xor_1631;
  assign xor_1631 = parity_1585 ^ parity_1630;
  // hls/stages/count_bits.hpp:25
  logic and_1632;
  assign and_1632 = parity_1585 & parity_1630;
  logic or_1636;
  assign or_1636 = (parity_1567 & parity_1582) | ((^{or_1548, or_1544, or_1540}) & (parity_1567 | parity_1582));
  logic or_1640;
  assign or_1640 = (parity_1612 & parity_1627) | ((^{or_1594, or_1590, and_1586}) & (parity_1612 | parity_1627));
  logic or_1647;
  assign or_1647 = (or_1544 & or_1548) | (or_1540 & (or_1544 | or_1548));
  logic or_1651;
  assign or_1651 = (or_1560 & or_1564) | (or_1556 & (or_1560 | or_1564));
  logic or_1655;
  assign or_1655 = (or_1575 & or_1579) | (or_1571 & (or_1575 | or_1579));
  // hls/stages/count_bits.hpp:24
  logic parity_1658;
  assign parity_1658 = ^{or_1655, or_1651, or_1647};
  // hls/stages/count_bits.hpp:25
  logic or_1662;
  assign or_1662 = (or_1590 & or_1594) | (and_1586 & (or_1590 | or_1594));
  logic or_1666;
  assign or_1666 = (or_1605 & or_1609) | (or_1601 & (or_1605 | or_1609));
  logic or_1670;
  assign or_1670 = (or_1620 & or_1624) | (or_1616 & (or_1620 | or_1624));
  // hls/stages/count_bits.hpp:24
  logic parity_1673;
  assign parity_1673 = ^{or_1670, or_1666, or_1662};
  logic parity_1676;
  assign parity_1676 = ^{or_1670, or_1666, or_1662, or_1655, or_1651, or_1647, or_1640, or_1636, and_1632};
  // hls/stages/count_bits.hpp:25
  logic or_1680;
  assign or_1680 = (parity_1658 & parity_1673) | ((^{or_1640, or_1636, and_1632}) & (parity_1658 | parity_1673));
  logic or_1684;
  assign or_1684 = (or_1636 & or_1640) | (and_1632 & (or_1636 | or_1640));
  logic or_1688;
  assign or_1688 = (or_1651 & or_1655) | (or_1647 & (or_1651 | or_1655));
  logic or_1692;
  assign or_1692 = (or_1666 & or_1670) | (or_1662 & (or_1666 | or_1670));
  // hls/stages/count_bits.hpp:24
  logic parity_1697;
  assign parity_1697 = ^{or_1692, or_1688, or_1684, or_1680};
  // hls/stages/count_bits.hpp:25
  logic or_1701;
  assign or_1701 = (or_1688 & or_1692) | (or_1684 & (or_1688 | or_1692));
  logic and_1702;
  assign and_1702 = or_1680 & (^{or_1692, or_1688, or_1684});
  // hls/stages/count_bits.hpp:24
  logic xor_1703;
  assign xor_1703 = or_1701 ^ and_1702;
  // hls/stages/count_bits.hpp:27
  logic and_1704;
  assign and_1704 = or_1701 & and_1702;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1705;
  assign select_1705 = equal_568_s1_q ? {and_1704, xor_1703, parity_1697, parity_1676, xor_1631, xor_1536} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_554_s1_q ? 6'h0 : select_1705;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1707;
  assign select_1707 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1708;
  assign difference_1708 = {1'b0, column_5} - {1'b0, select_1707};
  logic [7:0] sum_1710;
  assign sum_1710 = {difference_1708[6], difference_1708} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:684
  logic [11:0] not_1714;
  assign not_1714 = ~(select_739 ^ (less_557_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1716;
  assign select_1716 = and_737 ? ((right_codes_rdata_q[12] & not_558_s1_q) ? not_1714 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1722;
  assign parity_1722 = ^select_1716[5:3];
  logic parity_1725;
  assign parity_1725 = ^select_1716[8:6];
  logic parity_1728;
  assign parity_1728 = ^select_1716[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1735;
  assign select_1735 = and_760 ? (and_1227 ? (~(select_762 ^ select_1228)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1738;
  assign parity_1738 = ^select_1735[8:6];
  logic parity_1741;
  assign parity_1741 = ^select_1735[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1748;
  assign select_1748 = and_777 ? (and_738 ? (~(select_779 ^ select_740)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1754;
  assign parity_1754 = ^select_1748[2:0];
  logic parity_1757;
  assign parity_1757 = ^select_1748[5:3];
  logic parity_1760;
  assign parity_1760 = ^select_1748[8:0];
  logic parity_1766;
  assign parity_1766 = ^select_1748[11:9];
  logic parity_1769;
  assign parity_1769 = ^select_1735[2:0];
  logic parity_1772;
  assign parity_1772 = ^{select_1748[11:9], select_1735[5:0]};
  logic parity_1775;
  assign parity_1775 = ^{select_1748, select_1735, select_1716[2:0]};
  logic xor_1776;
  assign xor_1776 = parity_1728 ^ parity_1775;
  // hls/stages/count_bits.hpp:23
  logic or_1780;
  assign or_1780 = (select_1716[1:0] == 2'h3) | (select_1716[2] & (select_1716[0] | select_1716[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1784;
  assign or_1784 = (select_1735[7:6] == 2'h3) | (select_1735[8] & (select_1735[6] | select_1735[7]));
  logic or_1788;
  assign or_1788 = (select_1735[10:9] == 2'h3) | (select_1735[11] & (select_1735[9] | select_1735[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1796;
  assign or_1796 = (select_1748[7:6] == 2'h3) | (select_1748[8] & (~(select_1748[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1800;
  assign or_1800 = (select_1748[1:0] == 2'h3) | (select_1748[2] & (select_1748[0] | select_1748[1]));
  logic or_1804;
  assign or_1804 = (select_1748[4:3] == 2'h3) | (select_1748[5] & (select_1748[3] | select_1748[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1807;
  assign parity_1807 = ^{or_1804, or_1800, or_1796};
  // hls/stages/count_bits.hpp:23
  logic or_1811;
  assign or_1811 = (select_1735[4:3] == 2'h3) | (select_1735[5] & (select_1735[3] | select_1735[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1815;
  assign or_1815 = (select_1748[10:9] == 2'h3) | (select_1748[11] & (select_1748[9] | select_1748[10]));
  logic or_1819;
  assign or_1819 = (select_1735[1:0] == 2'h3) | (select_1735[2] & (select_1735[0] | select_1735[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1822;
  assign parity_1822 = ^{or_1819, or_1815, or_1811};
  logic parity_1825;
  assign parity_1825 = ^{or_1819, or_1815, or_1811, or_1804, or_1800, or_1796, or_1788, or_1784, or_1780};
  // hls/stages/count_bits.hpp:25
  logic and_1826;
  assign and_1826 = parity_1728 & parity_1775;
  logic or_1830;
  assign or_1830 = (parity_1722 & parity_1725) | ((^select_1716[11:9]) & (parity_1722 | parity_1725));
  logic and_1833;
  assign and_1833 = (^{select_1735[11:6], select_1716[2:0]}) & (parity_1760 | parity_1772);
  logic or_1834;
  assign or_1834 = (parity_1760 & parity_1772) | and_1833;
  // hls/stages/count_bits.hpp:23
  logic or_1841;
  assign or_1841 = (select_1716[10:9] == 2'h3) | (select_1716[11] & (select_1716[9] | select_1716[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1845;
  assign or_1845 = (select_1716[4:3] == 2'h3) | (select_1716[5] & (select_1716[3] | select_1716[4]));
  logic or_1849;
  assign or_1849 = (select_1716[7:6] == 2'h3) | (select_1716[8] & (select_1716[6] | select_1716[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1852;
  assign parity_1852 = ^{or_1849, or_1845, or_1841};
  // hls/stages/count_bits.hpp:25
  logic or_1856;
  assign or_1856 = (parity_1738 & parity_1741) | ((^select_1716[2:0]) & (parity_1738 | parity_1741));
  logic or_1860;
  assign or_1860 = (parity_1754 & parity_1757) | ((^select_1748[8:6]) & (parity_1754 | parity_1757));
  logic or_1864;
  assign or_1864 = (parity_1766 & parity_1769) | ((^select_1735[5:3]) & (parity_1766 | parity_1769));
  // hls/stages/count_bits.hpp:24
  logic parity_1867;
  assign parity_1867 = ^{or_1864, or_1860, or_1856};
  logic parity_1870;
  assign parity_1870 = ^{or_1864, or_1860, or_1856, or_1849, or_1845, or_1841, or_1834, or_1830, and_1826};
  logic xor_1871;
  assign xor_1871 = parity_1825 ^ parity_1870;
  // hls/stages/count_bits.hpp:25
  logic and_1872;
  assign and_1872 = parity_1825 & parity_1870;
  logic or_1876;
  assign or_1876 = (parity_1807 & parity_1822) | ((^{or_1788, or_1784, or_1780}) & (parity_1807 | parity_1822));
  logic or_1880;
  assign or_1880 = (parity_1852 & parity_1867) | ((^{or_1834, or_1830, and_1826}) & (parity_1852 | parity_1867));
  logic or_1887;
  assign or_1887 = (or_1784 & or_1788) | (or_1780 & (or_1784 | or_1788));
  logic or_1891;
  assign or_1891 = (or_1800 & or_1804) | (or_1796 & (or_1800 | or_1804));
  logic or_1895;
  assign or_1895 = (or_1815 & or_1819) | (or_1811 & (or_1815 | or_1819));
  // hls/stages/count_bits.hpp:24
  logic parity_1898;
  assign parity_1898 = ^{or_1895, or_1891, or_1887};
  // hls/stages/count_bits.hpp:25
  logic or_1902;
  assign or_1902 = (or_1830 & or_1834) | (and_1826 & (or_1830 | or_1834));
  logic or_1906;
  assign or_1906 = (or_1845 & or_1849) | (or_1841 & (or_1845 | or_1849));
  logic or_1910;
  assign or_1910 = (or_1860 & or_1864) | (or_1856 & (or_1860 | or_1864));
  // hls/stages/count_bits.hpp:24
  logic parity_1913;
  assign parity_1913 = ^{or_1910, or_1906, or_1902};
  logic parity_1916;
  assign parity_1916 = ^{or_1910, or_1906, or_1902, or_1895, or_1891, or_1887, or_1880, or_1876, and_1872};
  // hls/stages/count_bits.hpp:25
  logic or_1920;
  assign or_1920 = (parity_1898 & parity_1913) | ((^{or_1880, or_1876, and_1872}) & (parity_1898 | parity_1913));
  logic or_1924;
  assign or_1924 = (or_1876 & or_1880) | (and_1872 & (or_1876 | or_1880));
  logic or_1928;
  assign or_1928 = (or_1891 & or_1895) | (or_1887 & (or_1891 | or_1895));
  logic or_1932;
  assign or_1932 = (or_1906 & or_1910) | (or_1902 & (or_1906 | or_1910));
  // hls/stages/count_bits.hpp:24
  logic parity_1937;
  assign parity_1937 = ^{or_1932, or_1928, or_1924, or_1920};
  // hls/stages/count_bits.hpp:25
  logic or_1941;
  assign or_1941 = (or_1928 & or_1932) | (or_1924 & (or_1928 | or_1932));
  logic and_1942;
  assign and_1942 = or_1920 & (^{or_1932, or_1928, or_1924});
  // hls/stages/count_bits.hpp:24
  logic xor_1943;
  assign xor_1943 = or_1941 ^ and_1942;
  // hls/stages/count_bits.hpp:27
  logic and_1944;
  assign and_1944 = or_1941 & and_1942;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1945;
  assign select_1945 = equal_568_s1_q ? {and_1944, xor_1943, parity_1937, parity_1916, xor_1871, xor_1776} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_554_s1_q ? 6'h0 : select_1945;
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1947;
  assign select_1947 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1948;
  assign difference_1948 = {1'b0, column_6} - {1'b0, select_1947};
  logic [7:0] sum_1950;
  assign sum_1950 = {difference_1948[6], difference_1948} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_2021;
  assign and_2021 = ends_cell_s1_q & inside_v;
  logic and_2023;
  assign and_2023 = not_550 & (so_s1_q & and_2021);
  logic [6:0] select_2027;
  assign select_2027 = so_s1_q ? x_s1_q[6:0] : (or_554_s1_q ? (less_557_s1_q ? 7'h0 : select_601) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2031;
  assign or_2031 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2040;
  assign and_2040 = or_554_s1_q & (slot_s1_q[2] & not_558_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2156;
  assign select_2156 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2156[16:7])) ? 8'h7f : select_2156[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2230_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2230_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_2318;
  assign less_2318 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_2319;
  assign or_2319 = equal_2229_s1_q | less_2318;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2324;
  assign select_2324 = equal_2229_s1_q ? patches_column_s1_q[0] : (or_2319 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2325;
  assign not_2325 = ~or_2319;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_2326;
  assign sum_2326 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_2329;
  assign select_2329 = or_2319 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2326) + 5'h1) : sum_2326;
  // hls/stages/patches.hpp:500
  logic [4:0] select_2330;
  assign select_2330 = equal_2229_s1_q ? 5'h0 : select_2329;
  logic or_2331;
  assign or_2331 = equal_2229_s1_q | equal_2227_s1_q;
  // hls/stages/patches.hpp:476
  logic equal_2333;
  assign equal_2333 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2335;
  assign equal_2335 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_2337;
  assign and_2337 = of_row & (~equal_2335);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2333 ? 2'h3 : {equal_2335, and_2337};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_2340;
  assign sum_2340 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2341;
  assign sum_2341 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2340, pixel_2[0]} - {1'b0, sum_2341, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_2343;
  assign sum_2343 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2344;
  assign sum_2344 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2343[11], sum_2343};
  logic [13:0] sum_2345;
  assign sum_2345 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2344, down_2[1]};
  logic [12:0] sum_2346;
  assign sum_2346 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2345[13:1];
  logic [14:0] sum_2347;
  assign sum_2347 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2346, sum_2345[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_2350;
  assign sum_2350 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2351;
  assign sum_2351 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2350};
  logic [10:0] sum_2352;
  assign sum_2352 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2351, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2353;
  assign sum_2353 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2352[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_2353, sum_2352[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_2355;
  assign sum_2355 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2356;
  assign sum_2356 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2357;
  assign difference_2357 = {1'b0, sum_2355, smooth[0]} - {1'b0, sum_2356, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_2363;
  assign or_2363 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2335) | equal_2333;
  // hls/stages/patches.hpp:472
  logic and_2368;
  assign and_2368 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2372;
  assign and_2372 = not_2228_s1_q & (or_2231_s1_q & (or_2363 & (equal_2230_s1_q & and_2368)));
  // hls/stages/patches.hpp:172
  logic and_2382;
  assign and_2382 = (~(equal_2230_s1_q | (~and_2368))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2386;
  assign and_2386 = not_2228_s1_q & (or_2231_s1_q & (and_2382 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_2388;
  assign less_2388 = patches_step_q[4:0] < 5'h11;
  logic equal_2389;
  assign equal_2389 = patches_step_q[6:5] == 2'h0;
  logic not_2390;
  assign not_2390 = ~equal_2389;
  logic equal_2391;
  assign equal_2391 = patches_step_q[6:5] == 2'h3;
  logic not_2392;
  assign not_2392 = ~equal_2391;
  // hls/stages/patches.hpp:555
  logic select_2395;
  assign select_2395 = equal_2391 ? (less_2388 & (less_2388 & not_2392)) : less_2388;
  // hls/stages/patches.hpp:184
  logic and_2398;
  assign and_2398 = equal_2225_s1_q & (less_2388 ? (not_2390 & select_2395) : select_2395);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2420;
  assign sum_2420 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:456
  logic [5:0] or_2703;
  assign or_2703 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2716;
  assign select_2716 = equal_553_s1_q ? (inside_v ? select_560 : moments_place_q) : moments_place_q;
  logic [13:0] select_2718;
  assign select_2718 = equal_549_s1_q ? moments_place_q : (so_s1_q ? moments_place_q : select_2716);
  // hls/stages/agreement.hpp:460
  logic select_2982;
  assign select_2982 = equal_2888_s1_q ? (~({row_s1_q, 1'b0} < {sum_2979, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_3226;
  assign and_3226 = and_525_s1_q & (equal_2888_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3227;
  assign and_3227 = and_2889_s1_q & and_3226;
  // hls/stages/registration.hpp:127
  logic and_3229;
  assign and_3229 = and_2889_s1_q & (~and_3226);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3230;
  assign select_3230 = and_3229 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3232;
  assign select_3232 = and_3227 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3230[15]}}, select_3230});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3233;
  assign select_3233 = and_3229 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3233[15]}}, select_3233};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3235;
  assign select_3235 = and_3227 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3236;
  assign and_3236 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3236 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3482;
  assign select_3482 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3485;
  assign select_3485 = equal_2227_s1_q ? patches_smooth_values_0_q : (or_2231_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3487;
  assign select_3487 = or_2231_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3489;
  assign select_3489 = equal_2225_s1_q ? patches_smooth_values_1_q : (equal_2227_s1_q ? patches_smooth_values_1_q : select_3487);
  logic [11:0] select_3490;
  assign select_3490 = or_2231_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3492;
  assign select_3492 = equal_2225_s1_q ? patches_smooth_values_2_q : (equal_2227_s1_q ? patches_smooth_values_2_q : select_3490);
  logic [11:0] select_3493;
  assign select_3493 = or_2231_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3495;
  assign select_3495 = equal_2225_s1_q ? patches_smooth_values_3_q : (equal_2227_s1_q ? patches_smooth_values_3_q : select_3493);
  logic [10:0] select_3497;
  assign select_3497 = equal_2227_s1_q ? patches_down_values_0_q : (or_2231_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3500;
  assign select_3500 = equal_2227_s1_q ? patches_down_values_1_q : (or_2231_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3503;
  assign select_3503 = equal_2227_s1_q ? patches_down_values_2_q : (or_2231_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3506;
  assign select_3506 = equal_2227_s1_q ? patches_down_values_3_q : (or_2231_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3543;
  assign and_3543 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_3548;
  assign select_3548 = or_3443_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_3550;
  assign select_3550 = and_3543 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3906;
  assign select_3906 = equal_2225_s1_q ? patches_summed_down_by_q : (equal_2227_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3939;
  assign and_3939 = less_2388 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3942;
  assign select_3942 = equal_2391 ? (less_2388 ? (not_2392 & and_3939) : and_3939) : and_3939;
  // hls/stages/patches.hpp:184
  logic select_3945;
  assign select_3945 = equal_2225_s1_q ? (less_2388 ? (not_2390 & select_3942) : select_3942) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4286;
  assign select_4286 = so_s1_q ? (and_3236 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4288;
  assign sum_4288 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4289;
  assign select_4289 = sum_2420[5] ? {1'b1, sum_2420[4:0], region_across_rest_q[2:0]} : sum_4288;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4291;
  assign select_4291 = equal_2888_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4294;
  assign select_4294 = equal_2888_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_495_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_500;
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
  assign census_memory_re = s1_en & and_525_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:95; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [4:0] moments_memory_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) moments_memory_mem[i] = 5'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_548;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_566;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_554_s1_q ? select_601 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_592_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_2023;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] left_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_turns_mem[i] = 3'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[6:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_2040;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_601;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2040;
  logic [2:0] right_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_word_q <= right_turns_mem[right_turns_raddr];
  end
  logic [1:0] right_turns_rdata_q;
  assign right_turns_rdata_q = right_turns_word_q[1:0];
  logic right_turns_read_q, right_turns_error;
  always_ff @(posedge clk_i) right_turns_read_q <= rst_ni & right_turns_re;
  assign right_turns_error = right_turns_read_q & ^right_turns_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2330, not_2325, select_2324};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2331;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_2226_s1_q & (new_row & equal_2227_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & and_2398;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1404; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2023;
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
  assign left_we = s1_en & and_625_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_726, left_rdata_q[65:49], and_725, left_rdata_q[47:31], and_724, left_rdata_q[29:13], and_723, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_625_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_732, right_codes_rdata_q[84:73], and_731, right_codes_rdata_q[71:60], and_730, right_codes_rdata_q[56:43], and_729, right_codes_rdata_q[41:28], and_728, right_codes_rdata_q[26:13], and_727, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2312_s1_q;
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
      moments_place_q <= select_2718;
      row_q <= and_525_s1_q ? (equal_2888_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_525_s1_q ? select_2982 : lower_half_q;
      registration_slope_row_q <= select_3232;
      registration_slope_change_q <= select_3235;
      registration_slope_q <= so_s1_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3467_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3467_s1_q & select_3482;
      patches_smooth_values_0_q <= equal_2225_s1_q ? patches_smooth_values_0_q : select_3485;
      patches_smooth_values_1_q <= select_3489;
      patches_smooth_values_2_q <= select_3492;
      patches_smooth_values_3_q <= select_3495;
      patches_down_values_0_q <= equal_2225_s1_q ? patches_down_values_0_q : select_3497;
      patches_down_values_1_q <= equal_2225_s1_q ? patches_down_values_1_q : select_3500;
      patches_down_values_2_q <= equal_2225_s1_q ? patches_down_values_2_q : select_3503;
      patches_down_values_3_q <= equal_2225_s1_q ? patches_down_values_3_q : select_3506;
      patches_down_by_q <= or_3443_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3543});
      patches_along_q <= select_3548;
      patches_match_row_q <= or_3443_s1_q ? 4'h0 : select_3550;
      patches_summed_last_q <= not_2226_s1_q & (equal_2227_s1_q & and_3543);
      patches_summed_down_by_q <= select_3906;
      patches_step_q <= or_3443_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3945;
      region_across_rest_q <= select_4286;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4289;
      columns_begin_rest_q <= and_525_s1_q ? select_4291 : columns_begin_rest_q;
      columns_begin_back_q <= and_525_s1_q ? select_4294 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= sum_986;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1226;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1466;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1710;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1950;
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
  logic [2:0] select_489_s2_q;
  logic [6:0] select_491_s2_q;
  logic [8:0] select_495_s2_q;
  logic and_499_s2_q;
  logic and_500_s2_q;
  logic equal_505_s2_q;
  logic [6:0] column_s2_q;
  logic and_523_s2_q;
  logic and_525_s2_q;
  logic equal_545_s2_q;
  logic and_546_s2_q;
  logic [12:0] select_548_s2_q;
  logic equal_549_s2_q;
  logic not_550_s2_q;
  logic so_s2_q;
  logic not_552_s2_q;
  logic equal_553_s2_q;
  logic or_554_s2_q;
  logic less_557_s2_q;
  logic not_558_s2_q;
  logic inside_v_s2_q;
  logic less_561_s2_q;
  logic not_562_s2_q;
  logic and_566_s2_q;
  logic and_575_s2_q;
  logic and_583_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_614_s2_q;
  logic and_619_s2_q;
  logic and_621_s2_q;
  logic equal_654_s2_q;
  logic and_2010_s2_q;
  logic equal_2011_s2_q;
  logic and_2021_s2_q;
  logic and_2023_s2_q;
  logic [6:0] select_2027_s2_q;
  logic or_2031_s2_q;
  logic and_2124_s2_q;
  logic and_2137_s2_q;
  logic less_2151_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2225_s2_q;
  logic equal_2227_s2_q;
  logic equal_2230_s2_q;
  logic or_2231_s2_q;
  logic [4:0] select_2255_s2_q;
  logic select_2261_s2_q;
  logic [3:0] select_2302_s2_q;
  logic less_2318_s2_q;
  logic new_row_s2_q;
  logic or_2331_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_2348_s2_q;
  logic less_2349_s2_q;
  logic less_2358_s2_q;
  logic less_2359_s2_q;
  logic and_2373_s2_q;
  logic and_2382_s2_q;
  logic and_2387_s2_q;
  logic less_2388_s2_q;
  logic equal_2389_s2_q;
  logic not_2390_s2_q;
  logic equal_2391_s2_q;
  logic not_2392_s2_q;
  logic sum_2420_s2_q;
  logic and_2441_s2_q;
  logic and_2558_s2_q;
  logic equal_2704_s2_q;
  logic equal_2888_s2_q;
  logic and_2995_s2_q;
  logic equal_3080_s2_q;
  logic less_3519_s2_q;
  logic equal_3862_s2_q;
  logic equal_3946_s2_q;
  logic less_4274_s2_q;
  logic equal_4492_s2_q;
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
      select_489_s2_q <= select_489_s1_q;
      select_491_s2_q <= select_491_s1_q;
      select_495_s2_q <= select_495_s1_q;
      and_499_s2_q <= and_499_s1_q;
      and_500_s2_q <= and_500;
      equal_505_s2_q <= equal_505_s1_q;
      column_s2_q <= column_s1_q;
      and_523_s2_q <= and_523_s1_q;
      and_525_s2_q <= and_525_s1_q;
      equal_545_s2_q <= equal_545;
      and_546_s2_q <= and_546;
      select_548_s2_q <= select_548;
      equal_549_s2_q <= equal_549_s1_q;
      not_550_s2_q <= not_550;
      so_s2_q <= so_s1_q;
      not_552_s2_q <= not_552;
      equal_553_s2_q <= equal_553_s1_q;
      or_554_s2_q <= or_554_s1_q;
      less_557_s2_q <= less_557_s1_q;
      not_558_s2_q <= not_558_s1_q;
      inside_v_s2_q <= inside_v;
      less_561_s2_q <= less_561;
      not_562_s2_q <= not_562;
      and_566_s2_q <= and_566;
      and_575_s2_q <= or_554_s1_q & (left_rdata_q[70] & not_558_s1_q);
      and_583_s2_q <= (or_554_s1_q & (left_rdata_q[68] & not_558_s1_q)) & and_582;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_614_s2_q <= or_554_s1_q & (left_rdata_q[71] & not_558_s1_q);
      and_619_s2_q <= or_554_s1_q & (right_codes_rdata_q[58] & not_558_s1_q);
      and_621_s2_q <= or_554_s1_q & (right_codes_rdata_q[59] & not_558_s1_q);
      equal_654_s2_q <= row_s1_q == 6'h0;
      and_2010_s2_q <= and_2010_s1_q;
      equal_2011_s2_q <= equal_2011_s1_q;
      and_2021_s2_q <= and_2021;
      and_2023_s2_q <= and_2023;
      select_2027_s2_q <= select_2027;
      or_2031_s2_q <= or_2031;
      and_2124_s2_q <= and_2124_s1_q;
      and_2137_s2_q <= and_2137_s1_q;
      less_2151_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2225_s2_q <= equal_2225_s1_q;
      equal_2227_s2_q <= equal_2227_s1_q;
      equal_2230_s2_q <= equal_2230_s1_q;
      or_2231_s2_q <= or_2231_s1_q;
      select_2255_s2_q <= select_2255_s1_q;
      select_2261_s2_q <= select_2261_s1_q;
      select_2302_s2_q <= select_2302_s1_q;
      less_2318_s2_q <= less_2318;
      new_row_s2_q <= new_row;
      or_2331_s2_q <= or_2331;
      of_row_2_s2_q <= of_row_2;
      less_2348_s2_q <= $signed(15'h100) < $signed(sum_2347);
      less_2349_s2_q <= $signed(sum_2347[14:8]) < $signed(7'h7f);
      less_2358_s2_q <= $signed(15'h100) < $signed(difference_2357);
      less_2359_s2_q <= $signed(difference_2357[14:8]) < $signed(7'h7f);
      and_2373_s2_q <= not_2226_s1_q & and_2372;
      and_2382_s2_q <= and_2382;
      and_2387_s2_q <= not_2226_s1_q & and_2386;
      less_2388_s2_q <= less_2388;
      equal_2389_s2_q <= equal_2389;
      not_2390_s2_q <= not_2390;
      equal_2391_s2_q <= equal_2391;
      not_2392_s2_q <= not_2392;
      sum_2420_s2_q <= sum_2420[5];
      and_2441_s2_q <= or_554_s1_q & (left_rdata_q[69] & not_558_s1_q);
      and_2558_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2704_s2_q <= {column_s1_q[6], or_2703} == 7'h0;
      equal_2888_s2_q <= equal_2888_s1_q;
      and_2995_s2_q <= or_554_s1_q & (not_558_s1_q & and_582);
      equal_3080_s2_q <= shift == 6'h0;
      less_3519_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3862_s2_q <= patches_match_row_q == 4'h0;
      equal_3946_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4274_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4492_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [11:0] select_503;
  assign select_503 = select_489_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_507;
  assign sum_507 = select_503 + (equal_505_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_509;
  assign sum_509 = {4'h0, sample_pair_pixel_1_q} + (select_489_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_511;
  assign sum_511 = sum_509 + (equal_505_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:417
  logic whole;
  assign whole = select_489_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_515;
  assign and_515 = whole & (averager_memory_rdata_q[24] | equal_505_s2_q);
  // hls/stages/agreement.hpp:417
  logic all_of_skin;
  assign all_of_skin = select_489_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_519;
  assign and_519 = all_of_skin & (averager_memory_rdata_q[25] | equal_505_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_499_s2_q ? sum_507[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_528;
  assign equal_528 = select_489_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_528 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_531;
  assign select_531 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_499_s2_q ? sum_511[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_528 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_535;
  assign select_535 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_536;
  assign and_536 = and_499_s2_q & and_515;
  // hls/stages/census.hpp:127
  logic select_538;
  assign select_538 = equal_528 ? and_536 : (averager_mask_q & and_536);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_538;
  // hls/stages/census.hpp:207
  logic and_540;
  assign and_540 = and_499_s2_q & and_519;
  // hls/stages/census.hpp:127
  logic select_542;
  assign select_542 = equal_528 ? and_540 : (averager_of_skin_q & and_540);
  // hls/stages/agreement.hpp:276
  logic and_543;
  assign and_543 = sample_pair_whole_s2_q & select_542;
  // hls/stages/agreement.hpp:978
  logic select_596;
  assign select_596 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_606;
  assign difference_606 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_607;
  assign sum_607 = {difference_606[8], difference_606} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_609;
  assign and_609 = (and_583_s2_q & select_596) & ({{22{sum_607[9]}}, sum_607} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_611;
  assign and_611 = or_554_s2_q & (not_558_s2_q & and_609);
  // hls/stages/moments.hpp:64
  logic and_612;
  assign and_612 = and_575_s2_q & and_611;
  // hls/stages/census.hpp:296
  logic less_627;
  assign less_627 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_628;
  assign less_628 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_629;
  assign less_629 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_630;
  assign less_630 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_631;
  assign less_631 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_632;
  assign less_632 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_633;
  assign less_633 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_634;
  assign less_634 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_635;
  assign less_635 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_636;
  assign less_636 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_637;
  assign less_637 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_638;
  assign less_638 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_639;
  assign less_639 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_640;
  assign less_640 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_641;
  assign less_641 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_642;
  assign less_642 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_643;
  assign less_643 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_644;
  assign less_644 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_645;
  assign less_645 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_646;
  assign less_646 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_647;
  assign less_647 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_648;
  assign less_648 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_649;
  assign less_649 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_650;
  assign less_650 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_651;
  assign equal_651 = column_s2_q == 7'h0;
  logic [3:0] select_655;
  assign select_655 = equal_654_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_656;
  assign select_656 = equal_651 ? {select_655, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_657;
  assign select_657 = equal_651 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_658;
  assign and_658 = select_656[4] & select_657[3];
  // hls/stages/census.hpp:288
  logic and_660;
  assign and_660 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_662;
  assign and_662 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_660);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_662;
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
  logic [9:0] difference_685;
  assign difference_685 = {1'b0, select_531} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_686;
  assign xor_686 = difference_685[8:0] ^ {9{difference_685[9]}};
  logic [9:0] sum_687;
  assign sum_687 = {9'h0, difference_685[9]} + {1'b0, xor_686};
  logic [9:0] difference_688;
  assign difference_688 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_689;
  assign xor_689 = difference_688[8:0] ^ {9{difference_688[9]}};
  logic [9:0] sum_690;
  assign sum_690 = {9'h0, difference_688[9]} + {1'b0, xor_689};
  logic [9:0] difference_692;
  assign difference_692 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_693;
  assign xor_693 = difference_692[8:0] ^ {9{difference_692[9]}};
  logic [9:0] sum_694;
  assign sum_694 = {9'h0, difference_692[9]} + {1'b0, xor_693};
  logic [10:0] sum_695;
  assign sum_695 = ({1'b0, sum_687} + {1'b0, sum_690}) + {1'b0, sum_694};
  logic [9:0] difference_696;
  assign difference_696 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_697;
  assign xor_697 = difference_696[8:0] ^ {9{difference_696[9]}};
  logic [9:0] sum_698;
  assign sum_698 = {9'h0, difference_696[9]} + {1'b0, xor_697};
  logic [9:0] difference_700;
  assign difference_700 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_701;
  assign xor_701 = difference_700[8:0] ^ {9{difference_700[9]}};
  // hls/stages/agreement.hpp:456
  logic and_709;
  assign and_709 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_710;
  assign and_710 = and_658 & and_709;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_712;
  assign sum_712 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_714;
  assign and_714 = and_710 & ({{5{sum_712[6]}}, sum_712, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_718;
  assign sum_718 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_734;
  assign or_734 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_736;
  assign select_736 = or_734 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:751
  logic less_1467;
  assign less_1467 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1468;
  assign select_1468 = less_1467 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1469;
  assign less_1469 = middle_sum_sum_sums_values_0_q < select_1468;
  logic [7:0] select_1470;
  assign select_1470 = less_1469 ? select_1468 : middle_sum_sum_sums_values_0_q;
  logic less_1951;
  assign less_1951 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1952;
  assign select_1952 = less_1951 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1953;
  assign less_1953 = select_1470 < select_1952;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1953 ? select_1952 : select_1470) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1957;
  assign or_1957 = select_736 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1958;
  assign select_1958 = or_1957 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:752
  logic or_1960;
  assign or_1960 = less_1467 | (~less_1469);
  logic [2:0] select_1961;
  assign select_1961 = less_1953 ? {less_1951, 2'h0} : {1'b0, or_1960, less_1469};
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1962;
  assign select_1962 = or_1957 ? select_1961 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1963;
  assign select_1963 = or_1957 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1964;
  assign equal_1964 = select_1961 == 3'h1;
  logic or_1967;
  assign or_1967 = equal_1964 | (~(select_1961 == 3'h2));
  logic [7:0] select_1969;
  assign select_1969 = or_1967 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1970;
  assign select_1970 = equal_1964 ? (or_1967 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1969;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1971;
  assign select_1971 = or_1957 ? select_1970 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1972;
  assign select_1972 = or_1967 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1974;
  assign select_1974 = or_1957 ? (equal_1964 ? select_1969 : select_1972) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1976;
  assign sum_1976 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1977;
  assign sum_1977 = {1'b0, before_v} + sum_1976;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1979;
  assign sum_1979 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1980;
  assign sum_1980 = {1'b0, before_v_2} + sum_1979;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1982;
  assign sum_1982 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1983;
  assign sum_1983 = {1'b0, before_v_3} + sum_1982;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1985;
  assign select_1985 = (sum_1980 < sum_1983) ? sum_1983 : sum_1980;
  logic [6:0] select_1987;
  assign select_1987 = (sum_1977 < select_1985) ? select_1985 : sum_1977;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1989;
  assign sum_1989 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1990;
  assign sum_1990 = {1'b0, before_v_4} + sum_1989;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1992;
  assign sum_1992 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1993;
  assign sum_1993 = {1'b0, before_v_5} + sum_1992;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1995;
  assign select_1995 = (sum_1990 < sum_1993) ? sum_1993 : sum_1990;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1987 < select_1995) ? select_1995 : select_1987) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1999;
  assign less_1999 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_2001;
  assign select_2001 = select_736 ? of_near : (less_1999 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2003;
  assign select_2003 = select_736 ? run_shift_s2_q : (less_1999 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2006;
  assign select_2006 = (run_shift_s2_q == 6'h3f) ? of_best : (select_736 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_2009;
  assign select_2009 = (run_shift_s2_q == 6'h1) ? of_best : (select_736 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_2012;
  assign select_2012 = or_734 ? shift_first_s2_q : equal_2011_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_2014;
  assign or_2014 = select_2012 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_2015;
  assign select_2015 = or_2014 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2016;
  assign select_2016 = or_2014 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2018;
  assign or_2018 = select_2012 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_2019;
  assign select_2019 = or_2018 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2020;
  assign select_2020 = or_2018 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2034;
  assign and_2034 = or_554_s2_q & (not_558_s2_q & (and_609 & or_2031_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_2035;
  assign and_2035 = not_552_s2_q & and_2034;
  logic and_2038;
  assign and_2038 = not_550_s2_q & (so_s2_q ? and_2021_s2_q : (equal_553_s2_q & and_611));
  // hls/stages/moments.hpp:60
  logic and_2042;
  assign and_2042 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_2043;
  assign and_2043 = not_562_s2_q & and_2042;
  logic and_2045;
  assign and_2045 = and_2042 & (moments_memory_rdata_q[1] ^ and_614_s2_q);
  logic and_2046;
  assign and_2046 = not_562_s2_q & and_2045;
  // hls/stages/agreement.hpp:788
  logic and_2049;
  assign and_2049 = not_550_s2_q & (not_552_s2_q & (equal_553_s2_q & inside_v_s2_q));
  // hls/stages/moments.hpp:60
  logic and_2051;
  assign and_2051 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_2052;
  assign and_2052 = not_562_s2_q & and_2051;
  // hls/stages/moments.hpp:61
  logic and_2054;
  assign and_2054 = and_2051 & (moments_memory_rdata_q[3] ^ and_621_s2_q);
  // hls/stages/agreement.hpp:1003
  logic and_2055;
  assign and_2055 = not_562_s2_q & and_2054;
  // hls/stages/agreement.hpp:1128
  logic equal_2056;
  assign equal_2056 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1177
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_2059;
  assign select_2059 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_2061;
  assign select_2061 = equal_2056 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2059});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2062;
  assign sum_2062 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2063;
  assign select_2063 = equal_549_s2_q ? select_2061 : {sum_2062, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_2064;
  assign equal_2064 = x_s2_q[5:0] == 6'h3f;
  logic equal_2066;
  assign equal_2066 = x_s2_q[5:0] == 6'h3e;
  logic equal_2068;
  assign equal_2068 = x_s2_q[5:0] == 6'h3d;
  logic equal_2070;
  assign equal_2070 = x_s2_q[5:0] == 6'h3c;
  logic equal_2072;
  assign equal_2072 = x_s2_q[5:0] == 6'h3b;
  logic equal_2074;
  assign equal_2074 = x_s2_q[5:0] == 6'h36;
  logic equal_2076;
  assign equal_2076 = x_s2_q[5:0] == 6'h35;
  logic equal_2078;
  assign equal_2078 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1177
  logic and_2082;
  assign and_2082 = (~equal_2072) & ((~equal_2074) & ((~equal_2076) & (~equal_2078)));
  logic and_2086;
  assign and_2086 = (~equal_2064) & ((~equal_2066) & ((~equal_2068) & ((~equal_2070) & and_2082)));
  // hls/stages/agreement.hpp:1129
  logic less_2087;
  assign less_2087 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2091;
  assign or_2091 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_2096;
  assign sum_2096 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2096, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2102;
  assign sum_2102 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2104;
  assign and_2104 = half_ends & ({{3{sum_2102[4]}}, sum_2102} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_2105;
  assign and_2105 = so_s2_q & and_2104;
  logic select_2106;
  assign select_2106 = equal_549_s2_q ? (x_s2_q[6] & (equal_2056 ? and_2086 : (less_2087 & (~or_2091)))) : and_2105;
  // hls/stages/registration.hpp:258
  logic not_2108;
  assign not_2108 = ~lower_half_s2_q;
  logic [3:0] select_2109;
  assign select_2109 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2108, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2108};
  // hls/stages/patches.hpp:372
  logic [1:0] select_2138;
  assign select_2138 = and_2137_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2139;
  assign select_2139 = and_2137_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2140;
  assign select_2140 = and_2124_s2_q ? {select_2139, select_2138[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2141;
  assign select_2141 = and_2124_s2_q ? select_2138 : patches_fetch_q;
  logic equal_2142;
  assign equal_2142 = select_2141 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_2150;
  assign and_2150 = not_550_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2152;
  assign equal_2152 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_554_s2_q ? (less_557_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2152 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2160;
  assign select_2160 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2161;
  assign select_2161 = b[1] ? a : 8'h0;
  logic [8:0] sum_2162;
  assign sum_2162 = {{2{select_2160[6]}}, select_2160} + {select_2161[7], select_2161};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2163;
  assign select_2163 = b[2] ? a : 8'h0;
  logic [7:0] select_2164;
  assign select_2164 = b[3] ? a : 8'h0;
  logic [8:0] sum_2165;
  assign sum_2165 = {{2{select_2163[7]}}, select_2163[7:1]} + {select_2164[7], select_2164};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2166;
  assign sum_2166 = {{3{sum_2162[8]}}, sum_2162[8:1]} + {sum_2165[8], sum_2165, select_2163[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2167;
  assign select_2167 = b[4] ? a : 8'h0;
  logic [7:0] select_2168;
  assign select_2168 = b[5] ? a : 8'h0;
  logic [8:0] difference_2169;
  assign difference_2169 = {{2{select_2167[7]}}, select_2167[7:1]} - {select_2168[7], select_2168};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2170;
  assign sum_2170 = {difference_2169, select_2167[0]} + {sum_2166[10], sum_2166[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2152 ? {sum_2170, sum_2166[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2172;
  assign sum_2172 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2175;
  assign and_2175 = less_2151_s2_q & (and_611 & ({{4{sum_2172[9]}}, sum_2172, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2179;
  assign and_2179 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2185;
  assign sum_2185 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2187;
  assign sum_2187 = {sum_2185[9], sum_2185[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_2190;
  assign and_2190 = ($signed(9'h0) < $signed(sum_2185[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2187, sum_2185[0]})));
  logic and_2191;
  assign and_2191 = (~(and_2179 | (equal_545_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2190;
  // hls/stages/agreement.hpp:788
  logic and_2195;
  assign and_2195 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2175 & and_2191)));
  logic and_2196;
  assign and_2196 = not_550_s2_q & and_2195;
  // hls/stages/patches.hpp:156
  logic and_2198;
  assign and_2198 = and_2196 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2201;
  assign select_2201 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2202;
  assign select_2202 = equal_549_s2_q ? 8'h0 : select_2201;
  logic [5:0] select_2205;
  assign select_2205 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  logic [5:0] select_2206;
  assign select_2206 = equal_549_s2_q ? 6'h0 : select_2205;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2207;
  assign sum_2207 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2170[9]}}, sum_2170[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2210;
  assign select_2210 = ($signed(sum_2207[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2207[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2152 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2207[12:7])) ? 8'h7f : select_2210);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2215;
  assign select_2215 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2216;
  assign select_2216 = equal_549_s2_q ? 8'h0 : select_2215;
  // hls/stages/patches.hpp:342
  logic [22:0] select_2217;
  assign select_2217 = and_2198 ? {select_2216, select_2206, select_2202, and_2196} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:113
  logic equal_2218;
  assign equal_2218 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_2222;
  assign and_2222 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2179 | equal_2218)));
  logic and_2223;
  assign and_2223 = not_550_s2_q & and_2222;
  // hls/stages/patches.hpp:343
  logic and_2224;
  assign and_2224 = patches_chooses_s2_q & and_2223;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2238;
  assign select_2238 = and_2124_s2_q ? select_2139 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_2239;
  assign equal_2239 = {patches_choosing_band_s2_q, and_2150} == {select_2238, select_2141[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_2339;
  assign sum_2339 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_2377;
  assign sum_2377 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2407;
  assign select_2407 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_2410;
  assign or_2410 = select_2407[7] | (~({select_2407[5], select_2407[3], select_2407[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2413;
  assign or_2413 = select_2407[7] | (~({select_2407[6], select_2407[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_2416;
  assign or_2416 = select_2407[7] | (~(select_2407[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_2417;
  assign select_2417 = equal_549_s2_q ? x_s2_q[5:0] : {region_row_q, or_2416, or_2413, or_2410};
  // hls/stages/agreement.hpp:1128
  logic not_2418;
  assign not_2418 = ~equal_2056;
  // hls/stages/agreement.hpp:1058
  logic or_2422;
  assign or_2422 = (~sum_2420_s2_q) | equal_2218;
  // hls/stages/agreement.hpp:788
  logic and_2425;
  assign and_2425 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2422));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_554_s2_q & (not_558_s2_q & and_583_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_611;
  // hls/stages/agreement.hpp:149
  logic and_2443;
  assign and_2443 = or_554_s2_q & (not_558_s2_q & and_2441_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2452;
  assign and_2452 = inside_v_s2_q & and_2443;
  // hls/stages/agreement.hpp:1014
  logic select_2453;
  assign select_2453 = slot_s2_q[2] ? shown_shown_q : and_611;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2453);
  // hls/stages/agreement.hpp:1014
  logic select_2456;
  assign select_2456 = slot_s2_q[2] ? shown_nearer_q : and_2034;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2453 ? select_2456 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1274
  logic or_2459;
  assign or_2459 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [16:0] select_2461;
  assign select_2461 = marks_first_s2_q ? 17'h1 : (or_2459 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1275
  logic [8:0] select_2463;
  assign select_2463 = or_2459 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1283
  logic select_2465;
  assign select_2465 = cfg_compete_i ? (or_2459 & select_2461[16]) : (select_2463[8] & select_2461[9]);
  // hls/stages/agreement.hpp:435
  logic next_row;
  assign next_row = select_2465 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1290
  logic [6:0] select_2468;
  assign select_2468 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2470;
  assign select_2470 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2468});
  // hls/stages/agreement.hpp:1300
  logic equal_2471;
  assign equal_2471 = seen_x_q == 3'h7;
  logic [7:0] select_2473;
  assign select_2473 = select_2465 ? 8'h0 : (seen_column_q + {7'h0, equal_2471});
  // hls/stages/agreement.hpp:1307
  logic [12:0] index;
  assign index = select_2470 + {5'h0, select_2473};
  // hls/stages/agreement.hpp:1274
  logic select_2476;
  assign select_2476 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1260
  logic [7:0] sum_2477;
  assign sum_2477 = {1'b0, select_2476, 2'h0, select_2476, 1'b0, {2{select_2476}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1273
  logic not_2478;
  assign not_2478 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:435
  logic and_2480;
  assign and_2480 = not_2478 & (began_q | select_2465);
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_2482;
  assign select_2482 = select_2465 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1306
  logic and_2484;
  assign and_2484 = and_2480 & (select_2482 == 3'h0);
  logic less_2485;
  assign less_2485 = select_2473 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2488;
  assign sum_2488 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2488[7]}}, sum_2488, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1260
  logic [7:0] sum_2490;
  assign sum_2490 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1030
  logic and_2491;
  assign and_2491 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2492;
  assign and_2492 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2493;
  assign and_2493 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2494;
  assign and_2494 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2496;
  assign sum_2496 = {1'b0, and_2493} + ({1'b0, textured} + {1'b0, and_2494});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2491} + ({2'h0, and_2492} + {1'b0, sum_2496});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2505;
  assign select_2505 = inside_v_s2_q ? (sum_2420_s2_q ? select_2407 : {select_2407[6:0], 1'b0}) : select_2407;
  // hls/stages/agreement.hpp:1050
  logic or_2508;
  assign or_2508 = select_2505[7] | (~({select_2505[5], select_2505[3], select_2505[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2525;
  assign and_2525 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2526;
  assign and_2526 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2527;
  assign and_2527 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2528;
  assign and_2528 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2530;
  assign sum_2530 = {1'b0, and_2527} + ({1'b0, shown} + {1'b0, and_2528});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2525} + ({2'h0, and_2526} + {1'b0, sum_2530});
  // hls/stages/agreement.hpp:1030
  logic and_2541;
  assign and_2541 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2542;
  assign and_2542 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2543;
  assign and_2543 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2544;
  assign and_2544 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2546;
  assign sum_2546 = {1'b0, and_2543} + ({1'b0, near} + {1'b0, and_2544});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2541} + ({2'h0, and_2542} + {1'b0, sum_2546});
  // hls/stages/agreement.hpp:788
  logic and_2562;
  assign and_2562 = ends_cell_s2_q & (and_2558_s2_q & (~({sum_2096, last_s2_q[1:0]} < x_s2_q)));
  logic and_2564;
  assign and_2564 = not_550_s2_q & (so_s2_q & and_2562);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2596;
  assign select_2596 = sample_pair_whole_s2_q ? (and_523_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2598;
  assign select_2598 = sample_pair_whole_s2_q ? (and_523_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2617;
  assign select_2617 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2619;
  assign select_2619 = sample_pair_whole_s2_q ? (and_523_s2_q ? select_538 : averager_mask_q) : averager_mask_q;
  logic select_2621;
  assign select_2621 = sample_pair_whole_s2_q ? (and_523_s2_q ? select_542 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2622;
  assign select_2622 = and_525_s2_q ? select_531 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2623;
  assign select_2623 = and_525_s2_q ? select_535 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2625;
  assign select_2625 = and_525_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2626;
  assign select_2626 = and_525_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2627;
  assign select_2627 = and_525_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2628;
  assign select_2628 = and_525_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2629;
  assign select_2629 = and_525_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2630;
  assign select_2630 = and_525_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2631;
  assign select_2631 = and_525_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2632;
  assign select_2632 = and_525_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2633;
  assign select_2633 = and_525_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2634;
  assign select_2634 = and_525_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2635;
  assign select_2635 = and_525_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2636;
  assign select_2636 = and_525_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2637;
  assign select_2637 = and_525_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2638;
  assign select_2638 = and_525_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2639;
  assign select_2639 = and_525_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2640;
  assign select_2640 = and_525_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2641;
  assign select_2641 = and_525_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2642;
  assign select_2642 = and_525_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2643;
  assign select_2643 = and_525_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2644;
  assign select_2644 = and_525_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2645;
  assign select_2645 = and_525_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2646;
  assign select_2646 = and_525_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2647;
  assign select_2647 = and_525_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2648;
  assign select_2648 = and_525_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2649;
  assign select_2649 = and_525_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2650;
  assign select_2650 = and_525_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2651;
  assign select_2651 = and_525_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2652;
  assign select_2652 = and_525_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2653;
  assign select_2653 = and_525_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2654;
  assign select_2654 = and_525_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2655;
  assign select_2655 = and_525_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2656;
  assign select_2656 = and_525_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2657;
  assign select_2657 = and_525_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2658;
  assign select_2658 = and_525_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2659;
  assign select_2659 = and_525_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2660;
  assign select_2660 = and_525_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2661;
  assign select_2661 = and_525_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2662;
  assign select_2662 = and_525_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2663;
  assign select_2663 = and_525_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2664;
  assign select_2664 = and_525_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2665;
  assign select_2665 = and_525_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2666;
  assign select_2666 = and_525_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2667;
  assign select_2667 = and_525_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2668;
  assign select_2668 = and_525_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2669;
  assign select_2669 = and_525_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2670;
  assign select_2670 = and_525_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2671;
  assign select_2671 = and_525_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2672;
  assign select_2672 = and_525_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2673;
  assign select_2673 = and_525_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_525_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_525_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2676;
  assign select_2676 = and_525_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2677;
  assign select_2677 = and_525_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2679;
  assign difference_2679 = {1'b0, select_535} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2680;
  assign xor_2680 = difference_2679[8:0] ^ {9{difference_2679[9]}};
  logic [9:0] sum_2681;
  assign sum_2681 = {9'h0, difference_2679[9]} + {1'b0, xor_2680};
  logic [9:0] difference_2682;
  assign difference_2682 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2683;
  assign xor_2683 = difference_2682[8:0] ^ {9{difference_2682[9]}};
  logic [9:0] sum_2684;
  assign sum_2684 = {9'h0, difference_2682[9]} + {1'b0, xor_2683};
  logic [9:0] difference_2686;
  assign difference_2686 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2687;
  assign xor_2687 = difference_2686[8:0] ^ {9{difference_2686[9]}};
  logic [9:0] sum_2688;
  assign sum_2688 = {9'h0, difference_2686[9]} + {1'b0, xor_2687};
  logic [10:0] sum_2689;
  assign sum_2689 = ({1'b0, sum_2681} + {1'b0, sum_2684}) + {1'b0, sum_2688};
  logic [9:0] difference_2690;
  assign difference_2690 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2691;
  assign xor_2691 = difference_2690[8:0] ^ {9{difference_2690[9]}};
  logic [9:0] sum_2692;
  assign sum_2692 = {9'h0, difference_2690[9]} + {1'b0, xor_2691};
  logic [9:0] difference_2694;
  assign difference_2694 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2695;
  assign xor_2695 = difference_2694[8:0] ^ {9{difference_2694[9]}};
  // hls/stages/agreement.hpp:1003
  logic [13:0] select_2721;
  assign select_2721 = less_561_s2_q ? moments_turned_0_q : ({13'h0, and_2045} + (and_546_s2_q ? 14'h0 : moments_turned_0_q));
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2723;
  assign select_2723 = equal_553_s2_q ? (inside_v_s2_q ? select_2721 : moments_turned_0_q) : moments_turned_0_q;
  logic [13:0] select_2725;
  assign select_2725 = equal_549_s2_q ? moments_turned_0_q : (so_s2_q ? moments_turned_0_q : select_2723);
  // hls/stages/agreement.hpp:1003
  logic [13:0] select_2728;
  assign select_2728 = less_561_s2_q ? moments_turned_1_q : ({13'h0, and_2054} + (and_546_s2_q ? 14'h0 : moments_turned_1_q));
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2730;
  assign select_2730 = equal_553_s2_q ? (inside_v_s2_q ? select_2728 : moments_turned_1_q) : moments_turned_1_q;
  logic [13:0] select_2732;
  assign select_2732 = equal_549_s2_q ? moments_turned_1_q : (so_s2_q ? moments_turned_1_q : select_2730);
  // hls/stages/agreement.hpp:1147
  logic equal_2733;
  assign equal_2733 = x_s2_q[6:0] == 7'h7f;
  logic equal_2734;
  assign equal_2734 = x_s2_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2736;
  assign select_2736 = equal_2733 ? moments_before_0_q : (equal_2734 ? moments_turned_0_q : moments_before_0_q);
  logic [13:0] select_2739;
  assign select_2739 = equal_2733 ? moments_before_1_q : (equal_2734 ? moments_turned_1_q : moments_before_1_q);
  logic select_2742;
  assign select_2742 = equal_2733 ? moments_has_before_q : (moments_has_before_q | equal_2734);
  // hls/stages/moments.hpp:72
  logic [13:0] most_before;
  assign most_before = (moments_before_1_q < moments_before_0_q) ? moments_before_0_q : moments_before_1_q;
  // hls/stages/moments.hpp:93
  logic [14:0] sum_2746;
  assign sum_2746 = {1'b0, most_before} + 15'h3;
  logic not_2748;
  assign not_2748 = ~({3'h0, counts_turned_left_q[13:2]} < sum_2746);
  logic [14:0] sum_2749;
  assign sum_2749 = {1'b0, moments_turned_1_q} + 15'h3;
  logic less_2750;
  assign less_2750 = {3'h0, counts_turned_left_q[13:2]} < sum_2749;
  // hls/stages/moments.hpp:77
  logic select_2755;
  assign select_2755 = (not_2748 | less_2750) ? (~less_2750) : (~({3'h0, moments_before_1_q[13:2]} < sum_2749));
  // hls/stages/moments.hpp:93
  logic not_2757;
  assign not_2757 = ~({3'h0, counts_turned_right_q[13:2]} < sum_2746);
  logic [14:0] sum_2758;
  assign sum_2758 = {1'b0, moments_turned_0_q} + 15'h3;
  logic less_2759;
  assign less_2759 = {3'h0, counts_turned_right_q[13:2]} < sum_2758;
  // hls/stages/agreement.hpp:1144
  logic select_2764;
  assign select_2764 = (not_2757 | less_2759) ? (~less_2759) : (~({3'h0, moments_before_0_q[13:2]} < sum_2758));
  // hls/stages/moments.hpp:80
  logic or_2769;
  assign or_2769 = (select_2755 | select_2764) | (moments_out_of_step_q & (~(not_2748 & not_2757)));
  // hls/stages/moments.hpp:82
  logic and_2771;
  assign and_2771 = cfg_prove_i & (cfg_same_table_i ? or_2769 : moments_out_of_step_q);
  // hls/stages/agreement.hpp:788
  logic select_2773;
  assign select_2773 = equal_2733 ? moments_out_of_step_q : (equal_2734 ? and_2771 : moments_out_of_step_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2785;
  assign difference_2785 = {1'b0, select_531} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2785[9]} + (difference_2785[8:0] ^ {9{difference_2785[9]}});
  logic [9:0] difference_2797;
  assign difference_2797 = {1'b0, select_535} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2797[9]} + (difference_2797[8:0] ^ {9{difference_2797[9]}});
  // hls/stages/agreement.hpp:788
  logic not_2985;
  assign not_2985 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2986;
  assign less_2986 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2993;
  assign and_2993 = and_525_s2_q & (equal_654_s2_q & equal_2888_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2999;
  assign and_2999 = not_550_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2995_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_3019;
  assign and_3019 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3020;
  assign and_3020 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3021;
  assign and_3021 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3022;
  assign and_3022 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_3024;
  assign sum_3024 = {1'b0, and_3021} + ({1'b0, explained} + {1'b0, and_3022});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3019} + ({2'h0, and_3020} + {1'b0, sum_3024});
  // hls/stages/agreement.hpp:788
  logic and_3060;
  assign and_3060 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2995_s2_q & and_2443)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_3084;
  assign difference_3084 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3087;
  assign less_3087 = {2'h0, difference_3084[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3090;
  assign and_3090 = not_558_s2_q & (((and_2441_s2_q & and_609) & equal_3080_s2_q) & (~less_3087));
  // hls/stages/agreement.hpp:788
  logic and_3094;
  assign and_3094 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_554_s2_q & and_3090)));
  // hls/stages/agreement.hpp:149
  logic and_3099;
  assign and_3099 = not_558_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3101;
  assign and_3101 = not_558_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3102;
  assign select_3102 = or_554_s2_q ? {and_3101, and_3099} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3104;
  assign select_3104 = less_557_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3105;
  assign select_3105 = or_554_s2_q ? select_3104 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_3107;
  assign and_3107 = and_611 & (select_3102[0] & select_3105[0]);
  // hls/stages/agreement.hpp:788
  logic and_3111;
  assign and_3111 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3102[1] & and_3107)));
  logic and_3112;
  assign and_3112 = not_550_s2_q & and_3111;
  logic and_3118;
  assign and_3118 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3105[1] & and_3107)));
  logic and_3119;
  assign and_3119 = not_550_s2_q & and_3118;
  // hls/stages/registration.hpp:76
  logic less_3122;
  assign less_3122 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3124;
  assign select_3124 = or_554_s2_q ? (less_557_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3126;
  assign select_3126 = or_554_s2_q ? (less_557_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3128;
  assign select_3128 = or_554_s2_q ? (less_557_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3126} - {1'b0, select_3128};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3130;
  assign select_3130 = rise_2[8] ? select_3126 : select_3128;
  logic [8:0] fall;
  assign fall = {1'b0, select_3124} - {1'b0, select_3130};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3133;
  assign not_3133 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3122 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3133};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3135;
  assign xor_3135 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3135};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3141;
  assign select_3141 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3122 ? {taken, 1'b1} : {not_3133, select_3141, not_3133};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3143;
  assign sum_3143 = {left, 1'b1} + {taken_2, less_3122};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3145;
  assign select_3145 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3147;
  assign select_3147 = equal_549_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3149;
  assign select_3149 = equal_549_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3150;
  assign equal_3150 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3154;
  assign and_3154 = and_611 & less_2151_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3156;
  assign select_3156 = or_554_s2_q ? (less_557_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3160;
  assign sum_3160 = select_3156[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3163;
  assign select_3163 = (select_3126 < select_3128) ? ({sum_3160, select_3156[0], 5'h0} - {3'h0, select_3145}) : {sum_3160, select_3156[0], select_3145};
  logic [7:0] select_3164;
  assign select_3164 = ((select_3156 == 3'h0) | (select_3156 == 3'h4)) ? {sum_3160, select_3156[0], 5'h0} : select_3163;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3164[7]}}, select_3164} - {sum_2170[9], sum_2170, sum_2166[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3167;
  assign select_3167 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3167[11:7])) ? 12'h7f : select_3167;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3188;
  assign difference_3188 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3190;
  assign and_3190 = and_3154 & ($signed(difference_3188) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3203;
  assign less_3203 = $signed(difference_3188) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_3211;
  assign select_3211 = so_s2_q ? (equal_3150 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3214;
  assign select_3214 = so_s2_q ? (equal_2152 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3219;
  assign select_3219 = (sum_2062 == 2'h2) ? (registration_fresh_q & (~select_2109)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_3221;
  assign select_3221 = so_s2_q ? (and_2104 ? select_3219 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3223;
  assign select_3223 = and_2993 ? 4'hf : (equal_549_s2_q ? registration_fresh_q : select_3221);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2059;
  // hls/stages/registration.hpp:258
  logic not_3244;
  assign not_3244 = ~quarter_2[1];
  logic [3:0] select_3245;
  assign select_3245 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3244, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3244};
  // hls/stages/patches.hpp:91
  logic parity_3379;
  assign parity_3379 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_3380;
  assign select_3380 = equal_2888_s2_q ? {patches_chance_q[14:0], parity_3379} : patches_chance_q;
  // hls/stages/patches.hpp:344
  logic not_3382;
  assign not_3382 = ~and_2223;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3385;
  assign select_3385 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3385};
  // hls/stages/agreement.hpp:788
  logic and_3391;
  assign and_3391 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3395;
  assign and_3395 = not_3382 & (patches_fixed_q | ((not_550_s2_q & and_3391) & and_2198));
  // hls/stages/patches.hpp:353
  logic not_3408;
  assign not_3408 = ~select_2141[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3410;
  assign select_3410 = sample_pair_whole_s2_q ? (equal_2142 ? select_2141 : {not_3408, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3509;
  assign select_3509 = or_2231_s2_q ? {less_2359_s2_q, less_2358_s2_q, less_2349_s2_q, less_2348_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3511;
  assign select_3511 = equal_2225_s2_q ? patches_codes_at_q : (equal_2227_s2_q ? other[55:4] : select_3509);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_2331_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_3514;
  assign select_3514 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3516;
  assign select_3516 = equal_2227_s2_q ? (new_row_s2_q ? word : select_3514) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_3518;
  assign select_3518 = less_2318_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_3520;
  assign select_3520 = less_3519_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3522;
  assign select_3522 = or_2231_s2_q ? (equal_2230_s2_q ? patches_next_codes_q : select_3520) : patches_next_codes_q;
  logic [55:0] select_3524;
  assign select_3524 = equal_2225_s2_q ? patches_next_codes_q : (equal_2227_s2_q ? select_3518 : select_3522);
  // hls/stages/count_bits.hpp:24
  logic parity_3529;
  assign parity_3529 = ^{less_2359_s2_q, less_2358_s2_q, less_2349_s2_q, less_2348_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3533;
  assign or_3533 = ({less_2349_s2_q, less_2348_s2_q} == 2'h3) | (less_2358_s2_q & (less_2349_s2_q | less_2348_s2_q));
  logic and_3534;
  assign and_3534 = less_2359_s2_q & (^{less_2358_s2_q, less_2349_s2_q, less_2348_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3535;
  assign xor_3535 = or_3533 ^ and_3534;
  // hls/stages/count_bits.hpp:27
  logic and_3536;
  assign and_3536 = or_3533 & and_3534;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3538;
  assign select_3538 = or_2231_s2_q ? (and_2382_s2_q ? {and_3536, xor_3535, parity_3529} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3542;
  assign sum_3542 = {7'h0, patches_set_q} + (equal_2230_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_3552;
  assign select_3552 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3554;
  assign select_3554 = equal_2225_s2_q ? patches_left_row_q : (equal_2227_s2_q ? select_3552 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3552;
  // hls/stages/count_bits.hpp:24
  logic xor_3558;
  assign xor_3558 = bits[17] ^ (^{select_3552[16:15], other[16:15]});
  logic xor_3561;
  assign xor_3561 = bits[11] ^ (^{select_3552[10:9], other[10:9]});
  logic xor_3564;
  assign xor_3564 = bits[14] ^ (^{select_3552[13:12], other[13:12]});
  logic xor_3567;
  assign xor_3567 = xor_3558 ^ (^{select_3552[14:9], other[14:9]});
  logic xor_3570;
  assign xor_3570 = bits[47] ^ (^{select_3552[46:45], other[46:45]});
  logic xor_3573;
  assign xor_3573 = bits[8] ^ (^{select_3552[7:6], other[7:6]});
  logic xor_3576;
  assign xor_3576 = bits[2] ^ (^{select_3552[1:0], other[1:0]});
  logic xor_3579;
  assign xor_3579 = bits[5] ^ (^{select_3552[4:3], other[4:3]});
  logic xor_3582;
  assign xor_3582 = xor_3573 ^ (^{select_3552[5:0], other[5:0]});
  logic parity_3584;
  assign parity_3584 = ^{select_3552[47:45], select_3552[8:0], other[47:45], other[8:0]};
  logic xor_3585;
  assign xor_3585 = xor_3567 ^ parity_3584;
  logic xor_3588;
  assign xor_3588 = bits[44] ^ (^{select_3552[43:42], other[43:42]});
  logic xor_3591;
  assign xor_3591 = bits[38] ^ (^{select_3552[37:36], other[37:36]});
  logic xor_3594;
  assign xor_3594 = bits[41] ^ (^{select_3552[40:39], other[40:39]});
  logic xor_3600;
  assign xor_3600 = bits[26] ^ (^{select_3552[25:24], other[25:24]});
  logic xor_3603;
  assign xor_3603 = bits[20] ^ (^{select_3552[19:18], other[19:18]});
  logic xor_3606;
  assign xor_3606 = bits[23] ^ (^{select_3552[22:21], other[22:21]});
  logic xor_3609;
  assign xor_3609 = xor_3600 ^ (^{select_3552[23:18], other[23:18]});
  logic xor_3612;
  assign xor_3612 = bits[35] ^ (^{select_3552[34:33], other[34:33]});
  logic xor_3615;
  assign xor_3615 = bits[29] ^ (^{select_3552[28:27], other[28:27]});
  logic xor_3618;
  assign xor_3618 = bits[32] ^ (^{select_3552[31:30], other[31:30]});
  logic xor_3621;
  assign xor_3621 = xor_3612 ^ (^{select_3552[32:27], other[32:27]});
  logic xor_3622;
  assign xor_3622 = xor_3609 ^ xor_3621;
  // hls/stages/count_bits.hpp:25
  logic or_3630;
  assign or_3630 = (xor_3561 & xor_3564) | (xor_3558 & (xor_3561 | xor_3564));
  logic or_3634;
  assign or_3634 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3638;
  assign or_3638 = (xor_3576 & xor_3579) | (xor_3573 & (xor_3576 | xor_3579));
  // hls/stages/count_bits.hpp:23
  logic or_3645;
  assign or_3645 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3649;
  assign or_3649 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3653;
  assign or_3653 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3656;
  assign parity_3656 = ^{or_3653, or_3649, or_3645};
  // hls/stages/count_bits.hpp:23
  logic or_3660;
  assign or_3660 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3664;
  assign or_3664 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3668;
  assign or_3668 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3671;
  assign parity_3671 = ^{or_3668, or_3664, or_3660};
  logic parity_3674;
  assign parity_3674 = ^{or_3668, or_3664, or_3660, or_3653, or_3649, or_3645, or_3638, or_3634, or_3630};
  // hls/stages/count_bits.hpp:23
  logic or_3678;
  assign or_3678 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3682;
  assign or_3682 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3686;
  assign or_3686 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3694;
  assign or_3694 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3698;
  assign or_3698 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3702;
  assign or_3702 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3705;
  assign parity_3705 = ^{or_3702, or_3698, or_3694};
  // hls/stages/count_bits.hpp:23
  logic or_3709;
  assign or_3709 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3713;
  assign or_3713 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3717;
  assign or_3717 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3720;
  assign parity_3720 = ^{or_3717, or_3713, or_3709};
  logic parity_3723;
  assign parity_3723 = ^{or_3717, or_3713, or_3709, or_3702, or_3698, or_3694, or_3686, or_3682, or_3678};
  // hls/stages/count_bits.hpp:25
  logic or_3727;
  assign or_3727 = (xor_3591 & xor_3594) | (xor_3588 & (xor_3591 | xor_3594));
  logic or_3731;
  assign or_3731 = (xor_3603 & xor_3606) | (xor_3600 & (xor_3603 | xor_3606));
  logic or_3735;
  assign or_3735 = (xor_3615 & xor_3618) | (xor_3612 & (xor_3615 | xor_3618));
  // hls/stages/count_bits.hpp:24
  logic parity_3738;
  assign parity_3738 = ^{or_3735, or_3731, or_3727};
  // hls/stages/count_bits.hpp:25
  logic and_3739;
  assign and_3739 = xor_3585 & (^{xor_3622, select_3552[44:36], other[44:36]});
  logic or_3743;
  assign or_3743 = (xor_3570 & xor_3582) | (xor_3567 & (xor_3570 | xor_3582));
  logic and_3746;
  assign and_3746 = (xor_3588 ^ (^{select_3552[41:36], other[41:36]})) & (xor_3609 | xor_3621);
  logic or_3747;
  assign or_3747 = (xor_3609 & xor_3621) | and_3746;
  // hls/stages/count_bits.hpp:24
  logic parity_3750;
  assign parity_3750 = ^{or_3747, or_3743, and_3739};
  logic parity_3753;
  assign parity_3753 = ^{or_3747, or_3743, and_3739, or_3735, or_3731, or_3727, or_3717, or_3713, or_3709, or_3702, or_3698, or_3694, or_3686, or_3682, or_3678};
  logic parity_3755;
  assign parity_3755 = ^{or_3747, or_3743, and_3739, or_3735, or_3731, or_3727, or_3717, or_3713, or_3709, or_3702, or_3698, or_3694, or_3686, or_3682, or_3678, or_3668, or_3664, or_3660, or_3653, or_3649, or_3645, or_3638, or_3634, or_3630};
  // hls/stages/count_bits.hpp:25
  logic and_3756;
  assign and_3756 = parity_3674 & parity_3753;
  logic or_3760;
  assign or_3760 = (parity_3656 & parity_3671) | ((^{or_3638, or_3634, or_3630}) & (parity_3656 | parity_3671));
  logic or_3764;
  assign or_3764 = (parity_3738 & parity_3750) | (parity_3723 & (parity_3738 | parity_3750));
  logic or_3771;
  assign or_3771 = (parity_3705 & parity_3720) | ((^{or_3686, or_3682, or_3678}) & (parity_3705 | parity_3720));
  logic or_3775;
  assign or_3775 = (or_3731 & or_3735) | (or_3727 & (or_3731 | or_3735));
  logic or_3779;
  assign or_3779 = (or_3743 & or_3747) | (and_3739 & (or_3743 | or_3747));
  // hls/stages/count_bits.hpp:23
  logic or_3786;
  assign or_3786 = (or_3682 & or_3686) | (or_3678 & (or_3682 | or_3686));
  // hls/stages/count_bits.hpp:25
  logic or_3790;
  assign or_3790 = (or_3698 & or_3702) | (or_3694 & (or_3698 | or_3702));
  logic or_3794;
  assign or_3794 = (or_3713 & or_3717) | (or_3709 & (or_3713 | or_3717));
  // hls/stages/count_bits.hpp:24
  logic parity_3797;
  assign parity_3797 = ^{or_3794, or_3790, or_3786};
  // hls/stages/count_bits.hpp:23
  logic or_3801;
  assign or_3801 = (or_3634 & or_3638) | (or_3630 & (or_3634 | or_3638));
  // hls/stages/count_bits.hpp:25
  logic or_3805;
  assign or_3805 = (or_3649 & or_3653) | (or_3645 & (or_3649 | or_3653));
  logic or_3809;
  assign or_3809 = (or_3664 & or_3668) | (or_3660 & (or_3664 | or_3668));
  // hls/stages/count_bits.hpp:24
  logic parity_3812;
  assign parity_3812 = ^{or_3809, or_3805, or_3801};
  logic parity_3815;
  assign parity_3815 = ^{or_3809, or_3805, or_3801, or_3794, or_3790, or_3786, or_3779, or_3775, or_3771};
  logic parity_3817;
  assign parity_3817 = ^{or_3809, or_3805, or_3801, or_3794, or_3790, or_3786, or_3779, or_3775, or_3771, or_3764, or_3760, and_3756};
  // hls/stages/count_bits.hpp:25
  logic or_3821;
  assign or_3821 = (or_3775 & or_3779) | (or_3771 & (or_3775 | or_3779));
  logic or_3825;
  assign or_3825 = (or_3790 & or_3794) | (or_3786 & (or_3790 | or_3794));
  logic or_3829;
  assign or_3829 = (or_3805 & or_3809) | (or_3801 & (or_3805 | or_3809));
  // hls/stages/count_bits.hpp:24
  logic parity_3832;
  assign parity_3832 = ^{or_3829, or_3825, or_3821};
  // hls/stages/count_bits.hpp:25
  logic and_3833;
  assign and_3833 = (^{or_3764, or_3760, and_3756}) & parity_3815;
  logic or_3837;
  assign or_3837 = (or_3760 & or_3764) | (and_3756 & (or_3760 | or_3764));
  logic or_3841;
  assign or_3841 = (parity_3797 & parity_3812) | ((^{or_3779, or_3775, or_3771}) & (parity_3797 | parity_3812));
  // hls/stages/count_bits.hpp:24
  logic parity_3844;
  assign parity_3844 = ^{or_3841, or_3837, and_3833};
  // hls/stages/count_bits.hpp:25
  logic and_3846;
  assign and_3846 = parity_3832 & parity_3844;
  logic or_3850;
  assign or_3850 = (or_3825 & or_3829) | (or_3821 & (or_3825 | or_3829));
  logic or_3854;
  assign or_3854 = (or_3837 & or_3841) | (and_3833 & (or_3837 | or_3841));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3899;
  assign select_3899 = equal_2227_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3902;
  assign select_3902 = equal_2225_s2_q ? patches_summed_first_q : (equal_2227_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3909;
  assign select_3909 = less_2388_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3912;
  assign select_3912 = equal_2391_s2_q ? (less_2388_s2_q ? (equal_2391_s2_q ? 10'h0 : select_3909) : 10'h0) : select_3909;
  logic [9:0] select_3914;
  assign select_3914 = less_2388_s2_q ? (equal_2389_s2_q ? 10'h0 : select_3912) : select_3912;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3916;
  assign select_3916 = less_2388_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3919;
  assign select_3919 = equal_2391_s2_q ? (less_2388_s2_q ? (equal_2391_s2_q ? 5'h0 : select_3916) : 5'h0) : select_3916;
  logic [4:0] select_3921;
  assign select_3921 = less_2388_s2_q ? (equal_2389_s2_q ? 5'h0 : select_3919) : select_3919;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3923;
  assign select_3923 = less_2388_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3926;
  assign select_3926 = equal_2391_s2_q ? (less_2388_s2_q ? (equal_2391_s2_q ? 5'h0 : select_3923) : 5'h0) : select_3923;
  logic [4:0] select_3928;
  assign select_3928 = less_2388_s2_q ? (equal_2389_s2_q ? 5'h0 : select_3926) : select_3926;
  // hls/stages/patches.hpp:551
  logic and_3931;
  assign and_3931 = less_2388_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3934;
  assign select_3934 = equal_2391_s2_q ? (less_2388_s2_q ? (not_2392_s2_q & and_3931) : and_3931) : and_3931;
  // hls/stages/patches.hpp:184
  logic select_3937;
  assign select_3937 = equal_2225_s2_q ? (less_2388_s2_q ? (not_2390_s2_q & select_3934) : select_3934) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3948;
  assign or_3948 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3949;
  assign and_3949 = patches_read_searches_s2_q & or_3948;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3950;
  assign select_3950 = and_3949 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3950};
  // hls/stages/patches.hpp:551
  logic and_3954;
  assign and_3954 = less_2388_s2_q & (equal_3946_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3957;
  assign select_3957 = equal_2391_s2_q ? (less_2388_s2_q ? (not_2392_s2_q & and_3954) : and_3954) : and_3954;
  // hls/stages/patches.hpp:184
  logic select_3960;
  assign select_3960 = equal_2225_s2_q ? (less_2388_s2_q ? (not_2390_s2_q & select_3957) : select_3957) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3963;
  assign and_3963 = less_2388_s2_q & (equal_3946_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3966;
  assign select_3966 = equal_2391_s2_q ? (less_2388_s2_q ? (not_2392_s2_q & and_3963) : and_3963) : and_3963;
  // hls/stages/patches.hpp:184
  logic select_3969;
  assign select_3969 = equal_2225_s2_q ? (less_2388_s2_q ? (not_2390_s2_q & select_3966) : select_3966) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3970;
  assign sum_3970 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3973;
  assign select_3973 = (equal_3946_s2_q & ({sum_3970[6], sum_3970} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3974;
  assign select_3974 = less_2388_s2_q ? select_3973 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3976;
  assign select_3976 = less_2388_s2_q ? (equal_2391_s2_q ? 10'h3ff : select_3974) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3977;
  assign select_3977 = equal_2391_s2_q ? select_3976 : select_3974;
  logic [9:0] select_3979;
  assign select_3979 = less_2388_s2_q ? (equal_2389_s2_q ? 10'h3ff : select_3977) : select_3977;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3981;
  assign select_3981 = and_3949 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3982;
  assign select_3982 = equal_2225_s2_q ? select_3981[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3983;
  assign select_3983 = equal_2225_s2_q ? select_3981[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3985;
  assign select_3985 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3987;
  assign select_3987 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3990;
  assign select_3990 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3991;
  assign select_3991 = patches_read_first_q ? patches_read_far_q : select_3990;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3994;
  assign difference_3994 = select_3991 - select_3981[9:0];
  // hls/stages/patches.hpp:574
  logic less_4024;
  assign less_4024 = select_3985 < select_3987;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_4025;
  assign sum_4025 = select_3950[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_4024 ? select_3987 : select_3985;
  logic [9:0] low;
  assign low = (select_3987 < select_3985) ? select_3987 : select_3985;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3981[9:0];
  // hls/stages/patches.hpp:578
  logic not_4032;
  assign not_4032 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4033;
  assign sum_4033 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4035;
  assign not_4035 = ~({eight, 3'h0} < {1'b0, sum_4033, fall_2[0]});
  logic [1:0] sum_4036;
  assign sum_4036 = {1'b0, not_4032} + {1'b0, not_4035};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_4037;
  assign sum_4037 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4039;
  assign not_4039 = ~({eight, 3'h0} < {sum_4037, fall_2[1:0]});
  logic not_4042;
  assign not_4042 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4043;
  assign sum_4043 = {1'b0, not_4039} + {1'b0, not_4042};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4036} + {1'b0, sum_4043};
  // hls/stages/patches.hpp:581
  logic [7:0] select_4046;
  assign select_4046 = less_4024 ? ({sum_4025, select_3950[2:0], 3'h0} - {5'h0, fraction}) : {sum_4025, select_3950[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_4271;
  assign select_4271 = equal_549_s2_q ? shown_shown_q : (so_s2_q ? select_2453 : shown_shown_q);
  logic select_4273;
  assign select_4273 = equal_549_s2_q ? shown_nearer_q : (so_s2_q ? select_2456 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4275;
  assign sum_4275 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_4277;
  assign select_4277 = less_4274_s2_q ? (sum_4275[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4279;
  assign select_4279 = equal_2888_s2_q ? (equal_654_s2_q ? 3'h0 : select_4277) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4284;
  assign select_4284 = equal_549_s2_q ? select_2407 : (so_s2_q ? (ends_cell_s2_q ? select_2505 : select_2407) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_4298;
  assign select_4298 = equal_654_s2_q ? {{2{difference_4296[6]}}, difference_4296} : (less_4274_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_4300;
  assign select_4300 = and_525_s2_q ? (equal_2888_s2_q ? select_4298 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_4302;
  assign select_4302 = equal_654_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4304;
  assign select_4304 = and_525_s2_q ? (equal_2888_s2_q ? select_4302 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4305;
  assign sum_4305 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4306;
  assign select_4306 = sum_4275[7] ? {1'b1, sum_4275[6:0], region_down_rest_q[0]} : sum_4305;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4275[7];
  // hls/stages/agreement.hpp:460
  logic select_4310;
  assign select_4310 = equal_2888_s2_q ? (equal_654_s2_q | (less_4274_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4315;
  assign or_4315 = segment_starts_q | not_552_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_4318;
  assign select_4318 = inside_v_s2_q ? (sum_2420_s2_q ? (equal_2218 & or_2422) : or_2422) : or_4315;
  // hls/stages/agreement.hpp:788
  logic select_4321;
  assign select_4321 = equal_549_s2_q ? or_4315 : (so_s2_q ? (ends_cell_s2_q ? select_4318 : or_4315) : or_4315);
  logic select_4480;
  assign select_4480 = so_s2_q ? (ends_cell_s2_q ? and_2493 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4483;
  assign select_4483 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4485;
  assign select_4485 = equal_549_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4483 : centres_values_0_of_skin_q);
  logic select_4486;
  assign select_4486 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4488;
  assign select_4488 = equal_549_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4486 : centres_values_1_textured_q);
  logic select_4489;
  assign select_4489 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4491;
  assign select_4491 = equal_549_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4489 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4495;
  assign select_4495 = equal_2888_s2_q ? (equal_4492_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4498;
  assign select_4498 = and_525_s2_q ? (equal_2888_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1299
  logic [2:0] select_4509;
  assign select_4509 = select_2465 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:435
  logic [7:0] select_4515;
  assign select_4515 = marks_first_s2_q ? (less_4511 ? {sum_4512, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:788
  logic and_4579;
  assign and_4579 = equal_549_s2_q & (equal_2733 & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/registration.hpp:258
  logic not_4586;
  assign not_4586 = ~quarter[1];
  logic [3:0] select_4587;
  assign select_4587 = quarter[0] ? {quarter[1], 1'b0, not_4586, 1'b0} : {1'b0, quarter[1], 1'b0, not_4586};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2063;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2106;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:762; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2140;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2142));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1397; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2417;
  logic regions_re;
  assign regions_re = s2_en & (equal_549_s2_q ? (x_s2_q[6] & not_2418) : and_2425);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1408; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2477, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2484 & less_2485);
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
  assign averager_memory_waddr = select_495_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_500_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_519, and_515, sum_511, sum_507};
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
  assign census_memory_we = s2_en & and_525_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_543, whole_2, select_535, select_531};
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
  assign moments_memory_waddr = select_548_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_566_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_621_s2_q, and_619_s2_q, and_614_s2_q, and_612};
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
  assign best_left_we = s2_en & and_2010_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2009, select_2006, select_2003, select_2001, select_1974, select_1971, select_1963, select_1962, select_1958};
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
  assign best_right_we = s2_en & and_2010_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2020, select_2019, select_2016, select_2015};
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
  assign shown_right_waddr = select_2027_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2038;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2035, not_552_s2_q};
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
  assign left_turns_we = s2_en & and_2049;
  logic [1:0] left_turns_wdata;
  assign left_turns_wdata = {and_2046, and_2043};
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
  assign right_turns_we = s2_en & and_2049;
  logic [1:0] right_turns_wdata;
  assign right_turns_wdata = {and_2055, and_2052};
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
  assign patches_right_codes_waddr = {sum_2339, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2373_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2359_s2_q, less_2358_s2_q, less_2349_s2_q, less_2348_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2377, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2387_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2359_s2_q, less_2358_s2_q, less_2349_s2_q, less_2348_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_2023_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2452, textured};
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
      averager_running_of_skin_q <= select_2617;
      averager_mask_q <= select_2619;
      averager_of_skin_q <= select_2621;
      census_filled_q <= and_525_s2_q ? {select_657[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= select_2725;
      moments_turned_1_q <= select_2732;
      moments_before_0_q <= equal_549_s2_q ? select_2736 : moments_before_0_q;
      moments_before_1_q <= equal_549_s2_q ? select_2739 : moments_before_1_q;
      moments_has_before_q <= equal_549_s2_q ? select_2742 : moments_has_before_q;
      moments_out_of_step_q <= equal_549_s2_q ? select_2773 : moments_out_of_step_q;
      rows_passed_above_q <= and_525_s2_q ? select_656 : rows_passed_above_q;
      shift_allowed_q <= not_2985 & (~less_2986);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2993 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3112});
      counts_turned_right_q <= and_2993 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3119});
      registration_displacement_over_q <= so_s2_q ? sum_3143[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3145;
      registration_slope_here_q <= select_3147;
      registration_expected_q <= select_3149;
      registration_of_right_q <= equal_549_s2_q ? registration_of_right_q : select_3211;
      registration_was_inside_q <= equal_549_s2_q ? registration_was_inside_q : select_3214;
      registration_fresh_q <= select_3223;
      patches_chance_q <= and_525_s2_q ? select_3380 : patches_chance_q;
      patches_fixed_q <= and_3395;
      patches_choice_valid_q <= and_2223 ? (select_2217[0] & not_3382) : select_2217[0];
      patches_choice_column_q <= select_2217[8:1];
      patches_choice_shift_q <= select_2217[14:9];
      patches_choice_slope_q <= select_2217[22:15];
      patches_band_q <= sample_pair_whole_s2_q ? select_2238 : patches_band_q;
      patches_fetch_q <= select_3410;
      patches_codes_at_q <= select_3511;
      patches_codes_further_q <= equal_2225_s2_q ? patches_codes_further_q : select_3516;
      patches_next_codes_q <= select_3524;
      patches_set_q <= equal_2225_s2_q ? 3'h0 : (equal_2227_s2_q ? 3'h0 : select_3538);
      patches_size_q <= sum_3542;
      patches_left_row_q <= select_3554;
      patches_summed_row_column_q <= equal_2225_s2_q ? patches_summed_row_column_q : select_3899;
      patches_summed_first_q <= select_3902;
      patches_read_row_differing_q <= equal_2225_s2_q ? select_3914 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2225_s2_q ? select_3921 : patches_read_row_column_q;
      patches_read_at_q <= equal_2225_s2_q ? select_3928 : patches_read_at_q;
      patches_read_first_q <= select_3937;
      patches_read_above_q <= select_3960;
      patches_read_below_q <= select_3969;
      patches_read_far_q <= equal_2225_s2_q ? select_3979 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3982;
      patches_peak_best_column_q <= select_3983;
      patches_peak_row_q <= equal_2225_s2_q ? select_3950 : patches_peak_row_q;
      patches_peak_above_q <= equal_2225_s2_q ? select_3985 : patches_peak_above_q;
      patches_peak_below_q <= equal_2225_s2_q ? select_3987 : patches_peak_below_q;
      patches_peak_far_q <= equal_2225_s2_q ? select_3991 : patches_peak_far_q;
      patches_frame_ended_q <= equal_549_s2_q & (equal_2734 & (~equal_2733));
      shown_shown_q <= select_4271;
      shown_nearer_q <= select_4273;
      region_row_q <= and_525_s2_q ? select_4279 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4284;
      region_down_rest_q <= select_4300;
      region_down_back_q <= select_4304;
      region_down_next_q <= select_4306;
      region_fresh_q <= and_525_s2_q ? select_4310 : region_fresh_q;
      segment_starts_q <= select_4321;
      centres_values_0_textured_q <= equal_549_s2_q ? centres_values_0_textured_q : select_4480;
      centres_values_0_of_skin_q <= select_4485;
      centres_values_1_textured_q <= select_4488;
      centres_values_1_of_skin_q <= select_4491;
      map_row_q <= and_525_s2_q ? select_4495 : map_row_q;
      map_width_q <= select_4498;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2476;
      done_q <= not_2478 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_549_s2_q & equal_2733;
      rows_passed_q <= select_2461;
      columns_passed_q <= {select_2463[7:0], or_2459};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2480;
      seen_x_q <= select_2482;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4509;
      seen_column_q <= select_2473;
      seen_rows_left_q <= select_4515;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2470;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_503 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_509 : averager_running_1_q;
      averager_total_0_q <= select_2596;
      averager_total_1_q <= select_2598;
      census_columns_values_0_cell_0_left_q <= select_2622;
      census_columns_values_0_cell_0_right_q <= select_2623;
      census_columns_values_0_cell_0_mask_q <= and_525_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2625;
      census_columns_values_0_cell_1_right_q <= select_2626;
      census_columns_values_0_cell_1_mask_q <= select_2627;
      census_columns_values_0_cell_2_left_q <= select_2628;
      census_columns_values_0_cell_2_right_q <= select_2629;
      census_columns_values_0_cell_2_mask_q <= select_2630;
      census_columns_values_0_cell_2_of_skin_q <= select_2631;
      census_columns_values_0_cell_3_left_q <= select_2632;
      census_columns_values_0_cell_3_right_q <= select_2633;
      census_columns_values_0_cell_3_mask_q <= select_2634;
      census_columns_values_0_cell_4_left_q <= select_2635;
      census_columns_values_0_cell_4_right_q <= select_2636;
      census_columns_values_0_cell_4_mask_q <= select_2637;
      census_columns_values_1_cell_0_left_q <= select_2638;
      census_columns_values_1_cell_0_right_q <= select_2639;
      census_columns_values_1_cell_0_mask_q <= select_2640;
      census_columns_values_1_cell_1_left_q <= select_2641;
      census_columns_values_1_cell_1_right_q <= select_2642;
      census_columns_values_1_cell_1_mask_q <= select_2643;
      census_columns_values_1_cell_2_left_q <= select_2644;
      census_columns_values_1_cell_2_right_q <= select_2645;
      census_columns_values_1_cell_2_mask_q <= select_2646;
      census_columns_values_1_cell_2_of_skin_q <= select_2647;
      census_columns_values_1_cell_3_left_q <= select_2648;
      census_columns_values_1_cell_3_right_q <= select_2649;
      census_columns_values_1_cell_3_mask_q <= select_2650;
      census_columns_values_1_cell_4_left_q <= select_2651;
      census_columns_values_1_cell_4_right_q <= select_2652;
      census_columns_values_1_cell_4_mask_q <= select_2653;
      census_columns_values_2_cell_0_left_q <= select_2654;
      census_columns_values_2_cell_0_right_q <= select_2655;
      census_columns_values_2_cell_0_mask_q <= select_2656;
      census_columns_values_2_cell_1_left_q <= select_2657;
      census_columns_values_2_cell_1_right_q <= select_2658;
      census_columns_values_2_cell_1_mask_q <= select_2659;
      census_columns_values_2_cell_2_left_q <= select_2660;
      census_columns_values_2_cell_2_right_q <= select_2661;
      census_columns_values_2_cell_2_mask_q <= select_2662;
      census_columns_values_2_cell_3_left_q <= select_2663;
      census_columns_values_2_cell_3_right_q <= select_2664;
      census_columns_values_2_cell_3_mask_q <= select_2665;
      census_columns_values_2_cell_4_left_q <= select_2666;
      census_columns_values_2_cell_4_right_q <= select_2667;
      census_columns_values_2_cell_4_mask_q <= select_2668;
      census_columns_values_3_cell_0_mask_q <= select_2669;
      census_columns_values_3_cell_1_left_q <= select_2670;
      census_columns_values_3_cell_1_right_q <= select_2671;
      census_columns_values_3_cell_1_mask_q <= select_2672;
      census_columns_values_3_cell_2_mask_q <= select_2673;
      census_columns_values_3_cell_3_left_q <= select_2674;
      census_columns_values_3_cell_3_right_q <= select_2675;
      census_columns_values_3_cell_3_mask_q <= select_2676;
      census_columns_values_3_cell_4_mask_q <= select_2677;
      sharpness_last_mean_0_q <= and_525_s2_q ? select_531 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_525_s2_q ? select_535 : sharpness_last_mean_1_q;
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
  logic [2:0] select_489_s3_q;
  logic [6:0] select_491_s3_q;
  logic [6:0] column_s3_q;
  logic and_523_s3_q;
  logic and_525_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_528_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_545_s3_q;
  logic equal_549_s3_q;
  logic not_550_s3_q;
  logic less_627_s3_q;
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
  logic and_658_s3_q;
  logic and_683_s3_q;
  logic and_684_s3_q;
  logic [11:0] sum_699_s3_q;
  logic [9:0] sum_702_s3_q;
  logic and_710_s3_q;
  logic and_714_s3_q;
  logic less_715_s3_q;
  logic less_719_s3_q;
  logic less_721_s3_q;
  logic equal_2056_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2062_s3_q;
  logic equal_2064_s3_q;
  logic equal_2066_s3_q;
  logic equal_2068_s3_q;
  logic equal_2070_s3_q;
  logic equal_2072_s3_q;
  logic equal_2074_s3_q;
  logic equal_2076_s3_q;
  logic equal_2078_s3_q;
  logic less_2087_s3_q;
  logic or_2091_s3_q;
  logic equal_2111_s3_q;
  logic and_2121_s3_q;
  logic and_2124_s3_q;
  logic select_2141_s3_q;
  logic equal_2142_s3_q;
  logic and_2150_s3_q;
  logic equal_2152_s3_q;
  logic select_2217_s3_q;
  logic and_2224_s3_q;
  logic equal_2225_s3_q;
  logic equal_2227_s3_q;
  logic and_2240_s3_q;
  logic [4:0] select_2255_s3_q;
  logic select_2261_s3_q;
  logic [3:0] select_2302_s3_q;
  logic less_2388_s3_q;
  logic equal_2389_s3_q;
  logic not_2390_s3_q;
  logic equal_2391_s3_q;
  logic or_2410_s3_q;
  logic or_2413_s3_q;
  logic or_2416_s3_q;
  logic not_2418_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2445_s3_q;
  logic and_2450_s3_q;
  logic and_2484_s3_q;
  logic less_2485_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2490_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2508_s3_q;
  logic or_2511_s3_q;
  logic or_2514_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2564_s3_q;
  logic [11:0] sum_2693_s3_q;
  logic [9:0] sum_2696_s3_q;
  logic equal_2704_s3_q;
  logic equal_2733_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2993_s3_q;
  logic and_2999_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3061_s3_q;
  logic and_3095_s3_q;
  logic and_3153_s3_q;
  logic and_3154_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3190_s3_q;
  logic and_3204_s3_q;
  logic equal_3247_s3_q;
  logic parity_3626_s3_q;
  logic parity_3755_s3_q;
  logic parity_3817_s3_q;
  logic xor_3845_s3_q;
  logic parity_3857_s3_q;
  logic or_3861_s3_q;
  logic equal_3862_s3_q;
  logic [4:0] select_3981_s3_q;
  logic equal_3993_s3_q;
  logic less_3995_s3_q;
  logic less_3996_s3_q;
  logic or_4001_s3_q;
  logic [7:0] select_4046_s3_q;
  logic and_4521_s3_q;
  logic not_4536_s3_q;
  logic and_4579_s3_q;
  logic equal_4589_s3_q;
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
      select_489_s3_q <= select_489_s2_q;
      select_491_s3_q <= select_491_s2_q;
      column_s3_q <= column_s2_q;
      and_523_s3_q <= and_523_s2_q;
      and_525_s3_q <= and_525_s2_q;
      grey_s3_q <= grey;
      equal_528_s3_q <= equal_528;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_545_s3_q <= equal_545_s2_q;
      equal_549_s3_q <= equal_549_s2_q;
      not_550_s3_q <= not_550_s2_q;
      less_627_s3_q <= less_627;
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
      and_658_s3_q <= and_658;
      and_683_s3_q <= whole_22 & and_658;
      and_684_s3_q <= census_columns_values_1_cell_2_mask_q & and_658;
      sum_699_s3_q <= {1'b0, sum_695} + {2'h0, sum_698};
      sum_702_s3_q <= {9'h0, difference_700[9]} + {1'b0, xor_701};
      and_710_s3_q <= and_710;
      and_714_s3_q <= and_714;
      less_715_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_719_s3_q <= {{5{sum_718[6]}}, sum_718, half_grey_levels_2[3:0]} < 16'hffe1;
      less_721_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2056_s3_q <= equal_2056;
      all_s3_q <= all;
      sum_2062_s3_q <= sum_2062;
      equal_2064_s3_q <= equal_2064;
      equal_2066_s3_q <= equal_2066;
      equal_2068_s3_q <= equal_2068;
      equal_2070_s3_q <= equal_2070;
      equal_2072_s3_q <= equal_2072;
      equal_2074_s3_q <= equal_2074;
      equal_2076_s3_q <= equal_2076;
      equal_2078_s3_q <= equal_2078;
      less_2087_s3_q <= less_2087;
      or_2091_s3_q <= or_2091;
      equal_2111_s3_q <= (registration_fresh_q & select_2109) == 4'h0;
      and_2121_s3_q <= not_550_s2_q & and_2105;
      and_2124_s3_q <= and_2124_s2_q;
      select_2141_s3_q <= select_2141[1];
      equal_2142_s3_q <= equal_2142;
      and_2150_s3_q <= and_2150;
      equal_2152_s3_q <= equal_2152;
      select_2217_s3_q <= select_2217[0];
      and_2224_s3_q <= and_2224;
      equal_2225_s3_q <= equal_2225_s2_q;
      equal_2227_s3_q <= equal_2227_s2_q;
      and_2240_s3_q <= and_2224 & equal_2239;
      select_2255_s3_q <= select_2255_s2_q;
      select_2261_s3_q <= select_2261_s2_q;
      select_2302_s3_q <= select_2302_s2_q;
      less_2388_s3_q <= less_2388_s2_q;
      equal_2389_s3_q <= equal_2389_s2_q;
      not_2390_s3_q <= not_2390_s2_q;
      equal_2391_s3_q <= equal_2391_s2_q;
      or_2410_s3_q <= or_2410;
      or_2413_s3_q <= or_2413;
      or_2416_s3_q <= or_2416;
      not_2418_s3_q <= not_2418;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2445_s3_q <= inside_v_s2_q & (and_2443 & and_2034);
      and_2450_s3_q <= not_550_s2_q & and_2425;
      and_2484_s3_q <= and_2484;
      less_2485_s3_q <= less_2485;
      index_2_s3_q <= index_2[5:0];
      sum_2490_s3_q <= sum_2490;
      textured_2_s3_q <= textured_2;
      or_2508_s3_q <= or_2508;
      or_2511_s3_q <= select_2505[7] | (~({select_2505[6], select_2505[3:2]} == 3'h0));
      or_2514_s3_q <= select_2505[7] | (~(select_2505[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2564_s3_q <= and_2564;
      sum_2693_s3_q <= {1'b0, sum_2689} + {2'h0, sum_2692};
      sum_2696_s3_q <= {9'h0, difference_2694[9]} + {1'b0, xor_2695};
      equal_2704_s3_q <= equal_2704_s2_q;
      equal_2733_s3_q <= equal_2733;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2993_s3_q <= and_2993;
      and_2999_s3_q <= and_2999;
      explained_2_s3_q <= explained_2;
      and_3061_s3_q <= not_550_s2_q & and_3060;
      and_3095_s3_q <= not_550_s2_q & and_3094;
      and_3153_s3_q <= not_550_s2_q & (so_s2_q & (half_ends & equal_3150));
      and_3154_s3_q <= and_3154;
      residual_s3_q <= residual[7:0];
      and_3190_s3_q <= and_3190;
      and_3204_s3_q <= and_3154 & less_3203;
      equal_3247_s3_q <= (registration_fresh_q & select_3245) == 4'h0;
      parity_3626_s3_q <= ^{xor_3622, xor_3585, select_3552[44:36], other[44:36]};
      parity_3755_s3_q <= parity_3755;
      parity_3817_s3_q <= parity_3817;
      xor_3845_s3_q <= parity_3832 ^ parity_3844;
      parity_3857_s3_q <= ^{or_3854, or_3850, and_3846};
      or_3861_s3_q <= (or_3850 & or_3854) | (and_3846 & (or_3850 | or_3854));
      equal_3862_s3_q <= equal_3862_s2_q;
      select_3981_s3_q <= select_3981[14:10];
      equal_3993_s3_q <= select_3950[3:0] == 4'h0;
      less_3995_s3_q <= {difference_3994, 3'h0} < {3'h0, sum_3542};
      less_3996_s3_q <= select_3991 < select_3981[9:0];
      or_4001_s3_q <= (sum_3542 < 10'h39) | ({1'b0, sum_3542[9:1]} < select_3981[9:0]);
      select_4046_s3_q <= select_4046;
      and_4521_s3_q <= and_2564 & ({sum_2490, index_2[5:0]} == {sum_2477, index[5:0]});
      not_4536_s3_q <= ~proven_q;
      and_4579_s3_q <= and_4579;
      equal_4589_s3_q <= (registration_fresh_q & select_4587) == 4'h0;
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
  assign texture = sum_699_s3_q + {2'h0, sum_702_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_704;
  assign sum_704 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_706;
  assign sum_706 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_704});
  // hls/stages/census.hpp:305
  logic less_707;
  assign less_707 = 9'h4 < sum_706[13:5];
  logic and_708;
  assign and_708 = and_658_s3_q & less_707;
  // hls/stages/moments.hpp:30
  logic and_720;
  assign and_720 = (and_683_s3_q & and_710_s3_q) & less_719_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2113;
  assign equal_2113 = sum_2062_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2062_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2115;
  assign select_2115 = equal_2113 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2116;
  assign sum_2116 = (equal_2111_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2115[13]}}, select_2115};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2062_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2119;
  assign select_2119 = equal_2113 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2120;
  assign sum_2120 = (equal_2111_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2119[6]}}, select_2119};
  // hls/stages/patches.hpp:352
  logic [22:0] select_2241;
  assign select_2241 = and_2240_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2217_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2243;
  assign select_2243 = equal_2142_s3_q ? patches_place_0_valid_q : (select_2141_s3_q ? patches_place_0_valid_q : select_2241[0]);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2244;
  assign select_2244 = select_2141_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2241[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2245;
  assign select_2245 = equal_2142_s3_q ? patches_place_0_column_q : select_2244[7:0];
  logic [5:0] select_2246;
  assign select_2246 = equal_2142_s3_q ? patches_place_0_shift_q : select_2244[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2247;
  assign sum_2247 = select_2245 + {{2{select_2246[5]}}, select_2246};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2248;
  assign sum_2248 = sum_2247[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2249;
  assign equal_2249 = {sum_2248[6], select_491_s3_q, select_489_s3_q} == {1'b0, sum_2248[5:0], sum_2247[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2251;
  assign or_2251 = and_2124_s3_q | (select_2243 & equal_2249);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2252;
  assign select_2252 = or_2251 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2262;
  assign select_2262 = or_2251 ? {and_2124_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2264;
  assign and_2264 = select_2261_s3_q & (~select_2262[5]);
  // hls/stages/patches.hpp:127
  logic select_2272;
  assign select_2272 = equal_2142_s3_q ? patches_place_1_valid_q : (select_2141_s3_q ? select_2241[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2273;
  assign select_2273 = select_2141_s3_q ? select_2241[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2274;
  assign select_2274 = equal_2142_s3_q ? patches_place_1_column_q : select_2273[7:0];
  logic [5:0] select_2275;
  assign select_2275 = equal_2142_s3_q ? patches_place_1_shift_q : select_2273[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2276;
  assign sum_2276 = select_2274 + {{2{select_2275[5]}}, select_2275};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2277;
  assign sum_2277 = sum_2276[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2278;
  assign equal_2278 = {sum_2277[6], select_491_s3_q, select_489_s3_q} == {1'b0, sum_2277[5:0], sum_2276[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2280;
  assign or_2280 = and_2124_s3_q | (select_2272 & equal_2278);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2281;
  assign select_2281 = or_2280 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2282;
  assign select_2282 = or_2280 ? {and_2124_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2284;
  assign and_2284 = select_2261_s3_q & (~select_2282[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2291;
  assign sum_2291 = select_2245 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2292;
  assign equal_2292 = {sum_2291[7], select_491_s3_q, select_489_s3_q} == {1'b0, sum_2291[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2294;
  assign or_2294 = and_2124_s3_q | (select_2243 & equal_2292);
  logic [4:0] select_2295;
  assign select_2295 = or_2294 ? {and_2124_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2296;
  assign sum_2296 = select_2274 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2297;
  assign equal_2297 = {sum_2296[7], select_491_s3_q, select_489_s3_q} == {1'b0, sum_2296[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2300;
  assign select_2300 = (and_2124_s3_q | (select_2272 & equal_2297)) ? {and_2124_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_7;
  assign column_7 = select_2295[4] ? select_2300[3:0] : select_2295[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2303;
  assign select_2303 = or_2294 ? and_2124_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2309;
  assign and_2309 = (select_2261_s3_q & (select_2255_s3_q[3] ^ select_2255_s3_q[4])) & ((~select_2295[4]) | (~select_2300[4]));
  // hls/stages/patches.hpp:184
  logic less_2400;
  assign less_2400 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2401;
  assign not_2401 = ~less_2400;
  logic [1:0] select_2402;
  assign select_2402 = patches_summed_first_s3_q ? 2'h2 : {less_2400, not_2401};
  logic [12:0] select_2404;
  assign select_2404 = select_2402[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2405;
  assign select_2405 = select_2402[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2406;
  assign select_2406 = (select_2402 == 2'h2) ? {select_2404[12:8], patches_sums_values_0_q[9:8], select_2404[7:0]} : select_2405;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2431;
  assign select_2431 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2432;
  assign sum_2432 = {6'h0, textured_s3_q} + select_2431;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2434;
  assign sum_2434 = {3'h0, sum_2432} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2436;
  assign select_2436 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2437;
  assign sum_2437 = {6'h0, explained_s3_q} + select_2436;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2439;
  assign sum_2439 = {3'h0, sum_2437} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2446;
  assign select_2446 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2447;
  assign sum_2447 = {6'h0, and_2445_s3_q} + select_2446;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2449;
  assign sum_2449 = {3'h0, sum_2447} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2499;
  assign select_2499 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2500;
  assign difference_2500 = {1'b0, textured_2_s3_q} - {1'b0, select_2499};
  logic [4:0] t;
  assign t = {difference_2500[3], difference_2500} + (equal_545_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2503;
  assign equal_2503 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2515;
  assign not_2515 = ~region_row_s3_q[2];
  logic [2:0] select_2516;
  assign select_2516 = region_row_s3_q[1] ? {1'b0, not_2515, 1'b0} : {region_row_s3_q[2], 1'b0, not_2515};
  logic [5:0] select_2517;
  assign select_2517 = region_row_s3_q[0] ? {select_2516[2], 1'b0, select_2516[1], 1'b0, select_2516[0], 1'b0} : {1'b0, select_2516[2], 1'b0, select_2516[1], 1'b0, select_2516[0]};
  logic [11:0] select_2518;
  assign select_2518 = or_2514_s3_q ? {select_2517[5], 1'b0, select_2517[4], 1'b0, select_2517[3], 1'b0, select_2517[2], 1'b0, select_2517[1], 1'b0, select_2517[0], 1'b0} : {1'b0, select_2517[5], 1'b0, select_2517[4], 1'b0, select_2517[3], 1'b0, select_2517[2], 1'b0, select_2517[1], 1'b0, select_2517[0]};
  logic [23:0] select_2519;
  assign select_2519 = or_2511_s3_q ? {select_2518[11], 1'b0, select_2518[10], 1'b0, select_2518[9], 1'b0, select_2518[8], 1'b0, select_2518[7], 1'b0, select_2518[6], 1'b0, select_2518[5], 1'b0, select_2518[4], 1'b0, select_2518[3], 1'b0, select_2518[2], 1'b0, select_2518[1], 1'b0, select_2518[0], 1'b0} : {1'b0, select_2518[11], 1'b0, select_2518[10], 1'b0, select_2518[9], 1'b0, select_2518[8], 1'b0, select_2518[7], 1'b0, select_2518[6], 1'b0, select_2518[5], 1'b0, select_2518[4], 1'b0, select_2518[3], 1'b0, select_2518[2], 1'b0, select_2518[1], 1'b0, select_2518[0]};
  logic [47:0] select_2520;
  assign select_2520 = or_2508_s3_q ? {select_2519[23], 1'b0, select_2519[22], 1'b0, select_2519[21], 1'b0, select_2519[20], 1'b0, select_2519[19], 1'b0, select_2519[18], 1'b0, select_2519[17], 1'b0, select_2519[16], 1'b0, select_2519[15], 1'b0, select_2519[14], 1'b0, select_2519[13], 1'b0, select_2519[12], 1'b0, select_2519[11], 1'b0, select_2519[10], 1'b0, select_2519[9], 1'b0, select_2519[8], 1'b0, select_2519[7], 1'b0, select_2519[6], 1'b0, select_2519[5], 1'b0, select_2519[4], 1'b0, select_2519[3], 1'b0, select_2519[2], 1'b0, select_2519[1], 1'b0, select_2519[0], 1'b0} : {1'b0, select_2519[23], 1'b0, select_2519[22], 1'b0, select_2519[21], 1'b0, select_2519[20], 1'b0, select_2519[19], 1'b0, select_2519[18], 1'b0, select_2519[17], 1'b0, select_2519[16], 1'b0, select_2519[15], 1'b0, select_2519[14], 1'b0, select_2519[13], 1'b0, select_2519[12], 1'b0, select_2519[11], 1'b0, select_2519[10], 1'b0, select_2519[9], 1'b0, select_2519[8], 1'b0, select_2519[7], 1'b0, select_2519[6], 1'b0, select_2519[5], 1'b0, select_2519[4], 1'b0, select_2519[3], 1'b0, select_2519[2], 1'b0, select_2519[1], 1'b0, select_2519[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2524;
  assign and_2524 = good_known_q & (~((good_q & select_2520) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2533;
  assign select_2533 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2534;
  assign difference_2534 = {1'b0, shown_2_s3_q} - {1'b0, select_2533};
  logic [4:0] around;
  assign around = {difference_2534[3], difference_2534} + (equal_545_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2537;
  assign sum_2537 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2503 ? and_2524 : (~({sum_2537, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2549;
  assign select_2549 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2550;
  assign difference_2550 = {1'b0, near_2_s3_q} - {1'b0, select_2549};
  logic [4:0] n;
  assign n = {difference_2550[3], difference_2550} + (equal_545_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2554;
  assign and_2554 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2588;
  assign select_2588 = sample_pair_whole_s3_q ? (and_523_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2590;
  assign select_2590 = sample_pair_whole_s3_q ? (and_523_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2592;
  assign select_2592 = sample_pair_whole_s3_q ? (and_523_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2594;
  assign select_2594 = sample_pair_whole_s3_q ? (and_523_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2599;
  assign sum_2599 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2600;
  assign difference_2600 = {1'b0, sum_2599[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2601;
  assign xor_2601 = {difference_2600[8:0], sum_2599[0]} ^ {10{difference_2600[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2600[9]} + {1'b0, xor_2601};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_528_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2606;
  assign select_2606 = sample_pair_whole_s3_q ? (and_523_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2607;
  assign sum_2607 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2608;
  assign difference_2608 = {1'b0, sum_2607[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2609;
  assign xor_2609 = {difference_2608[8:0], sum_2607[0]} ^ {10{difference_2608[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2608[9]} + {1'b0, xor_2609};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_528_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2614;
  assign select_2614 = sample_pair_whole_s3_q ? (and_523_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2697;
  assign sum_2697 = sum_2693_s3_q + {2'h0, sum_2696_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2699;
  assign select_2699 = and_525_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2700;
  assign select_2700 = and_525_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2701;
  assign select_2701 = and_525_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2702;
  assign select_2702 = and_525_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2705;
  assign sum_2705 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2697};
  logic [13:0] sum_2707;
  assign sum_2707 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2705});
  // hls/stages/census.hpp:311
  logic and_2709;
  assign and_2709 = and_683_s3_q & (9'h4 < sum_2707[13:5]);
  // hls/stages/census.hpp:312
  logic and_2710;
  assign and_2710 = and_683_s3_q & less_707;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2711;
  assign sum_2711 = census_left_misses_q + {{17{and_2710}}, and_2709, 1'b0, and_2709};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2713;
  assign select_2713 = and_525_s3_q ? (equal_2704_s3_q ? 20'h0 : sum_2711) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2778;
  assign select_2778 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2781;
  assign select_2781 = and_525_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2784;
  assign and_2784 = whole_2_s3_q & (~(column_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2790;
  assign and_2790 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2791;
  assign and_2791 = and_2784 & and_2790;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2778[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2793;
  assign select_2793 = and_2791 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2795;
  assign select_2795 = equal_2704_s3_q ? {11'h0, select_2793} : (sharpness_sums_detail_0_q + {11'h0, select_2793});
  // hls/stages/agreement.hpp:457
  logic and_2802;
  assign and_2802 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2803;
  assign and_2803 = and_2784 & and_2802;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2778[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2805;
  assign select_2805 = and_2803 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2807;
  assign select_2807 = equal_2704_s3_q ? {11'h0, select_2805} : (sharpness_sums_detail_1_q + {11'h0, select_2805});
  logic [8:0] select_2810;
  assign select_2810 = and_2791 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2811;
  assign sum_2811 = (equal_2704_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2810};
  logic [8:0] select_2814;
  assign select_2814 = and_2803 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2815;
  assign sum_2815 = (equal_2704_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2814};
  // hls/stages/agreement.hpp:211
  logic equal_2817;
  assign equal_2817 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2818;
  assign less_2818 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2819;
  assign less_2819 = x_s3_q[4:0] < 5'h3;
  logic not_2820;
  assign not_2820 = ~x_s3_q[1];
  logic [2:0] select_2821;
  assign select_2821 = x_s3_q[0] ? {1'b0, not_2820, 1'b0} : {x_s3_q[1], 1'b0, not_2820};
  logic [5:0] select_2822;
  assign select_2822 = slot_s3_q[2] ? {select_2821[2], 1'b0, select_2821[1], 1'b0, select_2821[0], 1'b0} : {1'b0, select_2821[2], 1'b0, select_2821[1], 1'b0, select_2821[0]};
  logic [11:0] select_2823;
  assign select_2823 = slot_s3_q[1] ? {select_2822[5], 1'b0, select_2822[4], 1'b0, select_2822[3], 1'b0, select_2822[2], 1'b0, select_2822[1], 1'b0, select_2822[0], 1'b0} : {1'b0, select_2822[5], 1'b0, select_2822[4], 1'b0, select_2822[3], 1'b0, select_2822[2], 1'b0, select_2822[1], 1'b0, select_2822[0]};
  logic [23:0] select_2824;
  assign select_2824 = slot_s3_q[0] ? {select_2823[11], 1'b0, select_2823[10], 1'b0, select_2823[9], 1'b0, select_2823[8], 1'b0, select_2823[7], 1'b0, select_2823[6], 1'b0, select_2823[5], 1'b0, select_2823[4], 1'b0, select_2823[3], 1'b0, select_2823[2], 1'b0, select_2823[1], 1'b0, select_2823[0], 1'b0} : {1'b0, select_2823[11], 1'b0, select_2823[10], 1'b0, select_2823[9], 1'b0, select_2823[8], 1'b0, select_2823[7], 1'b0, select_2823[6], 1'b0, select_2823[5], 1'b0, select_2823[4], 1'b0, select_2823[3], 1'b0, select_2823[2], 1'b0, select_2823[1], 1'b0, select_2823[0]};
  // hls/stages/census.hpp:378
  logic and_2828;
  assign and_2828 = less_2819 & (~((sharpness_sums_contrast_1_q & select_2824) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2830;
  assign select_2830 = (less_2818 & and_2828) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2830};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2833;
  assign select_2833 = equal_2817 ? (less_2818 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2838;
  assign and_2838 = less_2819 & (~((sharpness_sums_contrast_0_q & select_2824) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2840;
  assign select_2840 = (less_2818 & and_2838) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2840};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2843;
  assign select_2843 = equal_2817 ? (less_2818 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2845;
  assign select_2845 = equal_2817 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2847;
  assign select_2847 = equal_2817 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2849;
  assign select_2849 = equal_2817 ? {sharpness_comparing_contrast_0_q[0], and_2838} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2851;
  assign select_2851 = equal_2817 ? {sharpness_comparing_contrast_1_q[0], and_2828} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2856;
  assign select_2856 = drew_q ? (equal_2817 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2860;
  assign select_2860 = drew_q ? (equal_2817 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2861;
  assign equal_2861 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2862;
  assign xor_2862 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2865;
  assign select_2865 = (equal_2861 | xor_2862) ? (five_times[0] & xor_2862) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2867;
  assign select_2867 = drew_q ? (equal_2817 ? select_2865 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2868;
  assign xor_2868 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2871;
  assign select_2871 = (equal_2861 | xor_2868) ? (five_times_2[0] & xor_2868) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2873;
  assign select_2873 = drew_q ? (equal_2817 ? select_2871 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2874;
  assign xor_2874 = sharpness_comparing_contrast_0_q[1] ^ and_2828;
  logic select_2877;
  assign select_2877 = (equal_2861 | xor_2874) ? (and_2828 & xor_2874) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2879;
  assign select_2879 = drew_q ? (equal_2817 ? select_2877 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2880;
  assign xor_2880 = sharpness_comparing_contrast_1_q[1] ^ and_2838;
  logic select_2883;
  assign select_2883 = (equal_2861 | xor_2880) ? (and_2838 & xor_2880) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2885;
  assign select_2885 = drew_q ? (equal_2817 ? select_2883 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3001;
  assign select_3001 = and_2993_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2999_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_3004;
  assign and_3004 = not_550_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3009;
  assign and_3009 = not_550_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3014;
  assign and_3014 = not_550_s3_q & (drew_q & (ends_cell_s3_q & and_2445_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_3018;
  assign not_3018 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_3027;
  assign select_3027 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3028;
  assign difference_3028 = {1'b0, explained_2_s3_q} - {1'b0, select_3027};
  logic [4:0] e;
  assign e = {difference_3028[3], difference_3028} + (equal_545_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_3031;
  assign sum_3031 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_3035;
  assign not_3035 = ~(equal_2503 ? and_2524 : (~({sum_3031, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_3038;
  assign and_3038 = ends_cell_s3_q & (not_3018 & (centres_values_1_textured_s3_q & not_3035));
  logic and_3040;
  assign and_3040 = not_550_s3_q & (drew_q & and_3038);
  // hls/stages/agreement.hpp:1132
  logic less_3043;
  assign less_3043 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3044;
  assign select_3044 = less_3043 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3047;
  assign select_3047 = less_3043 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_3048;
  assign sum_3048 = {1'b0, select_3047} + {3'h0, select_3047[9:2]};
  logic and_3050;
  assign and_3050 = (~(select_3044[9:4] == 6'h0)) & ({sum_3048, select_3047[1:0]} < {3'h0, select_3044});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_3053;
  assign select_3053 = x_s3_q[6] ? (equal_2056_s3_q ? 10'h0 : (and_3050 ? select_3044 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_3054;
  assign select_3054 = equal_549_s3_q ? select_3053 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3056;
  assign select_3056 = and_2993_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3054});
  logic [13:0] select_3063;
  assign select_3063 = and_2993_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3061_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_3065;
  assign and_3065 = not_3018 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_3068;
  assign and_3068 = not_550_s3_q & (drew_q & (ends_cell_s3_q & and_3065));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3070;
  assign select_3070 = and_2993_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3068});
  // hls/stages/agreement.hpp:1110
  logic and_3072;
  assign and_3072 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3035);
  // hls/stages/agreement.hpp:788
  logic and_3076;
  assign and_3076 = not_550_s3_q & (drew_q & (ends_cell_s3_q & (not_3018 & and_3072)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_3078;
  assign select_3078 = and_2993_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3076});
  logic [13:0] select_3097;
  assign select_3097 = and_2993_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3095_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3172;
  assign select_3172 = drew_q ? (equal_2152_s3_q ? (and_3154_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3173;
  assign select_3173 = equal_549_s3_q ? 8'h0 : select_3172;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3175;
  assign select_3175 = and_3153_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3173[7]}}, select_3173});
  // hls/stages/agreement.hpp:788
  logic and_3178;
  assign and_3178 = not_550_s3_q & (drew_q & (and_3154_s3_q & equal_2152_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3180;
  assign select_3180 = and_3153_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3178});
  // hls/stages/registration.hpp:107
  logic and_3182;
  assign and_3182 = and_3154_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3184;
  assign select_3184 = drew_q ? (equal_2152_s3_q ? {and_3182, and_3154_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3185;
  assign select_3185 = equal_549_s3_q ? 2'h0 : select_3184;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3186;
  assign sum_3186 = registration_half_votes_down_q + {{5{select_3185[1]}}, select_3185};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3192;
  assign select_3192 = drew_q ? (equal_2152_s3_q ? {and_3190_s3_q, and_3154_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3193;
  assign select_3193 = equal_549_s3_q ? 2'h0 : select_3192;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3194;
  assign sum_3194 = registration_half_votes_up_q + {{5{select_3193[1]}}, select_3193};
  // hls/stages/registration.hpp:107
  logic and_3197;
  assign and_3197 = and_3154_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3199;
  assign select_3199 = drew_q ? (equal_2152_s3_q ? {and_3197, and_3154_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3200;
  assign select_3200 = equal_549_s3_q ? 2'h0 : select_3199;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3201;
  assign sum_3201 = registration_half_half_votes_down_q + {{5{select_3200[1]}}, select_3200};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_3206;
  assign select_3206 = drew_q ? (equal_2152_s3_q ? {and_3204_s3_q, and_3154_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3207;
  assign select_3207 = equal_549_s3_q ? 2'h0 : select_3206;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3208;
  assign sum_3208 = registration_half_half_votes_up_q + {{5{select_3207[1]}}, select_3207};
  // hls/stages/agreement.hpp:788
  logic and_3242;
  assign and_3242 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & less_2087_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3249;
  assign select_3249 = or_2091_s3_q ? 12'h0 : (equal_3247_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3252;
  assign select_3252 = x_s3_q[6] ? (equal_2056_s3_q ? 12'h0 : (less_2087_s3_q ? select_3249 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3253;
  assign select_3253 = equal_549_s3_q ? select_3252 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3254;
  assign and_3254 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3257;
  assign and_3257 = not_2418_s3_q & (less_2087_s3_q & ({and_3254, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_3259;
  assign and_3259 = equal_549_s3_q & (x_s3_q[6] & and_3257);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3261;
  assign sum_3261 = {{2{select_3253[11]}}, select_3253} + (and_3259 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_3264;
  assign select_3264 = or_2091_s3_q ? 12'h0 : (equal_3247_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_3267;
  assign select_3267 = x_s3_q[6] ? (equal_2056_s3_q ? 12'h0 : (less_2087_s3_q ? select_3264 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_3268;
  assign select_3268 = equal_549_s3_q ? select_3267 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3270;
  assign sum_3270 = {{2{select_3268[11]}}, select_3268} + (and_3259 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3272;
  assign not_3272 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_3275;
  assign and_3275 = not_2418_s3_q & (less_2087_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3272, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_3281;
  assign and_3281 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & (less_2087_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3282;
  assign not_3282 = ~and_3281;
  logic less_3283;
  assign less_3283 = $signed({9'h1, {2{not_3282}}, and_3281}) < $signed(registration_up_q[13:2]);
  logic select_3284;
  assign select_3284 = (equal_549_s3_q & (x_s3_q[6] & and_3275)) ? less_3283 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_3288;
  assign and_3288 = x_s3_q[6] & (not_2418_s3_q & (less_2087_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_3289;
  assign and_3289 = equal_549_s3_q & and_3288;
  // hls/stages/registration.hpp:242
  logic less_3290;
  assign less_3290 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3292;
  assign less_3292 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3294;
  assign equal_3294 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_3298;
  assign and_3298 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & (less_2087_s3_q & equal_3294)));
  // hls/stages/agreement.hpp:1142
  logic and_3305;
  assign and_3305 = x_s3_q[6] & (not_2418_s3_q & (less_2087_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3308;
  assign equal_3308 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_3311;
  assign and_3311 = not_2418_s3_q & (less_2087_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3308));
  // hls/stages/registration.hpp:244
  logic and_3315;
  assign and_3315 = (equal_549_s3_q & (x_s3_q[6] & and_3311)) & (less_3292 | less_3290);
  // hls/stages/agreement.hpp:1142
  logic and_3320;
  assign and_3320 = not_2418_s3_q & (less_2087_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3308)));
  // hls/stages/registration.hpp:244
  logic and_3323;
  assign and_3323 = registration_votes_up_q & registration_other_down_q;
  logic select_3325;
  assign select_3325 = registration_votes_down_q ? (registration_other_up_q | and_3323) : and_3323;
  // hls/stages/registration.hpp:138
  logic and_3327;
  assign and_3327 = (equal_549_s3_q & (x_s3_q[6] & and_3320)) & (registration_other_enough_q & select_3325);
  // hls/stages/registration.hpp:245
  logic or_3330;
  assign or_3330 = registration_moved_q | (registration_enough_q & (and_3315 | and_3327));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3415;
  assign select_3415 = sample_pair_whole_s3_q ? (equal_2142_s3_q ? patches_place_0_slope_q : select_2244[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3420;
  assign select_3420 = sample_pair_whole_s3_q ? (equal_2142_s3_q ? patches_place_1_slope_q : select_2273[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3422;
  assign select_3422 = equal_2142_s3_q ? patches_valid_0_q : (select_2141_s3_q ? patches_valid_0_q : select_2241[0]);
  // hls/stages/agreement.hpp:276
  logic select_3425;
  assign select_3425 = sample_pair_whole_s3_q ? (and_2264 ? (sample_present_s3_q & select_3422) : select_3422) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3427;
  assign select_3427 = equal_2142_s3_q ? patches_valid_1_q : (select_2141_s3_q ? select_2241[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3430;
  assign select_3430 = sample_pair_whole_s3_q ? (and_2284 ? (sample_present_s3_q & select_3427) : select_3427) : patches_valid_1_q;
  logic [5:0] select_3433;
  assign select_3433 = sample_pair_whole_s3_q ? (select_2262[5] ? {1'b1, select_2262[4:0]} : (select_2262 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3436;
  assign select_3436 = sample_pair_whole_s3_q ? (select_2282[5] ? {1'b1, select_2282[4:0]} : (select_2282 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3439;
  assign select_3439 = sample_pair_whole_s3_q ? (select_2295[4] ? {1'b1, select_2295[3:0]} : (select_2295 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3442;
  assign select_3442 = sample_pair_whole_s3_q ? (select_2300[4] ? {1'b1, select_2300[3:0]} : (select_2300 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3861_s3_q, parity_3857_s3_q, xor_3845_s3_q, parity_3817_s3_q, parity_3755_s3_q, parity_3626_s3_q} + (equal_3862_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3866;
  assign select_3866 = equal_2225_s3_q ? patches_sums_values_0_q : (equal_2227_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3867;
  assign select_3867 = equal_2227_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3869;
  assign select_3869 = equal_2227_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3871;
  assign select_3871 = equal_2227_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3873;
  assign select_3873 = equal_2227_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3875;
  assign select_3875 = equal_2227_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3877;
  assign select_3877 = equal_2227_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3879;
  assign select_3879 = equal_2227_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3881;
  assign select_3881 = equal_2227_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3883;
  assign select_3883 = equal_2227_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3885;
  assign select_3885 = equal_2227_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3887;
  assign select_3887 = equal_2227_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3889;
  assign select_3889 = equal_2227_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3891;
  assign select_3891 = equal_2227_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3893;
  assign select_3893 = equal_2227_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3895;
  assign select_3895 = equal_2227_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3897;
  assign select_3897 = equal_2227_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_4002;
  assign or_4002 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4001_s3_q;
  logic or_4005;
  assign or_4005 = equal_3993_s3_q | (less_3995_s3_q | (less_3996_s3_q | or_4002));
  // hls/stages/patches.hpp:574
  logic not_4006;
  assign not_4006 = ~or_4005;
  // hls/stages/patches.hpp:555
  logic and_4007;
  assign and_4007 = equal_2391_s3_q & not_4006;
  // hls/stages/patches.hpp:184
  logic and_4010;
  assign and_4010 = equal_2225_s3_q & (less_2388_s3_q ? (not_2390_s3_q & and_4007) : and_4007);
  // hls/stages/patches.hpp:652
  logic not_4011;
  assign not_4011 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:555
  logic and_4013;
  assign and_4013 = equal_2391_s3_q & (patches_second_s3_q & not_4006);
  // hls/stages/patches.hpp:184
  logic and_4016;
  assign and_4016 = equal_2225_s3_q & (less_2388_s3_q ? (not_2390_s3_q & and_4013) : and_4013);
  // hls/stages/patches.hpp:652
  logic not_4017;
  assign not_4017 = ~and_4016;
  // hls/stages/patches.hpp:188
  logic and_4019;
  assign and_4019 = and_4010 & (not_4011 & not_4017);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_4021;
  assign sum_4021 = {7'h0, and_4019} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_4047;
  assign select_4047 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_4048;
  assign select_4048 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4049;
  assign sum_4049 = {2'h0, select_3981_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4050;
  assign sum_4050 = {select_4048[5], select_4048} + {{3{sum_4049[3]}}, sum_4049};
  // hls/stages/patches.hpp:592
  logic [17:0] product_4051;
  assign product_4051 = $signed({{10{select_4047[7]}}, select_4047}) * $signed({{8{sum_4050[6]}}, sum_4050, select_3981_s3_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_4052;
  assign difference_4052 = {{6{select_4046_s3_q[7]}}, select_4046_s3_q} - {product_4051[17], product_4051[17:5]};
  // hls/stages/patches.hpp:599
  logic less_4053;
  assign less_4053 = $signed({{7{difference_4023[6]}}, difference_4023}) < $signed(difference_4052);
  // hls/stages/patches.hpp:555
  logic and_4056;
  assign and_4056 = equal_2391_s3_q & (not_4006 & (~less_4053));
  // hls/stages/patches.hpp:184
  logic and_4059;
  assign and_4059 = equal_2225_s3_q & (less_2388_s3_q ? (not_2390_s3_q & and_4056) : and_4056);
  // hls/stages/patches.hpp:655
  logic and_4060;
  assign and_4060 = and_4059 & and_4019;
  logic [7:0] sum_4061;
  assign sum_4061 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4060};
  // hls/stages/patches.hpp:555
  logic and_4065;
  assign and_4065 = not_4006 & (~($signed(difference_4052) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4066;
  assign and_4066 = equal_2391_s3_q & and_4065;
  // hls/stages/patches.hpp:184
  logic and_4069;
  assign and_4069 = equal_2225_s3_q & (less_2388_s3_q ? (not_2390_s3_q & and_4066) : and_4066);
  // hls/stages/patches.hpp:656
  logic and_4070;
  assign and_4070 = and_4069 & and_4019;
  logic [7:0] sum_4071;
  assign sum_4071 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4070};
  // hls/stages/patches.hpp:188
  logic and_4073;
  assign and_4073 = and_4010 & (and_4016 & not_4011);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_4075;
  assign sum_4075 = {7'h0, and_4073} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_4077;
  assign and_4077 = and_4059 & and_4073;
  logic [7:0] sum_4078;
  assign sum_4078 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4077};
  // hls/stages/patches.hpp:656
  logic and_4080;
  assign and_4080 = and_4069 & and_4073;
  logic [7:0] sum_4081;
  assign sum_4081 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4080};
  // hls/stages/patches.hpp:188
  logic and_4083;
  assign and_4083 = and_4010 & (patches_lower_s3_q & not_4017);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_4085;
  assign sum_4085 = {7'h0, and_4083} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_4087;
  assign and_4087 = and_4059 & and_4083;
  logic [7:0] sum_4088;
  assign sum_4088 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4087};
  // hls/stages/patches.hpp:656
  logic and_4090;
  assign and_4090 = and_4069 & and_4083;
  logic [7:0] sum_4091;
  assign sum_4091 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4090};
  // hls/stages/patches.hpp:188
  logic and_4093;
  assign and_4093 = and_4010 & (patches_lower_s3_q & and_4016);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_4095;
  assign sum_4095 = {7'h0, and_4093} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_4097;
  assign and_4097 = and_4059 & and_4093;
  logic [7:0] sum_4098;
  assign sum_4098 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4097};
  // hls/stages/patches.hpp:656
  logic and_4100;
  assign and_4100 = and_4069 & and_4093;
  logic [7:0] sum_4101;
  assign sum_4101 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4100};
  // hls/stages/agreement.hpp:1222
  logic equal_4102;
  assign equal_4102 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_4103;
  assign less_4103 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_4107;
  assign and_4107 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & (equal_4102 & less_4103)));
  // hls/stages/agreement.hpp:1142
  logic and_4112;
  assign and_4112 = x_s3_q[6] & (not_2418_s3_q & (less_4103 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_4113;
  assign and_4113 = equal_549_s3_q & and_4112;
  // hls/stages/patches.hpp:618
  logic [7:0] or_4115;
  assign or_4115 = (and_4107 ? patches_quarters_0_places_q : 8'h0) | (and_4113 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_4119;
  assign and_4119 = x_s3_q[6] & (not_2418_s3_q & (less_4103 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_4120;
  assign and_4120 = equal_549_s3_q & and_4119;
  // hls/stages/agreement.hpp:1142
  logic and_4126;
  assign and_4126 = x_s3_q[6] & (not_2418_s3_q & (less_4103 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_4127;
  assign and_4127 = equal_549_s3_q & and_4126;
  // hls/stages/patches.hpp:618
  logic [7:0] or_4129;
  assign or_4129 = (or_4115 | (and_4120 ? patches_quarters_2_places_q : 8'h0)) | (and_4127 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_4133;
  assign select_4133 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_4137;
  assign and_4137 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & (less_4103 & select_4133)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_4139;
  assign select_4139 = and_4107 ? (and_4137 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4141;
  assign select_4141 = and_4113 ? (and_4137 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4144;
  assign select_4144 = and_4120 ? (and_4137 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4147;
  assign select_4147 = and_4127 ? (and_4137 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_4150;
  assign select_4150 = and_4107 ? (and_4137 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4152;
  assign select_4152 = and_4113 ? (and_4137 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4155;
  assign select_4155 = and_4120 ? (and_4137 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4158;
  assign select_4158 = and_4127 ? (and_4137 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4160;
  assign sum_4160 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_4164;
  assign and_4164 = x_s3_q[6] & (not_2418_s3_q & (less_4103 & (sum_4160[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4165;
  assign and_4165 = equal_549_s3_q & and_4164;
  // hls/stages/patches.hpp:615
  logic [7:0] select_4168;
  assign select_4168 = and_4165 ? (patches_word_places_q + (and_4113 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4171;
  assign select_4171 = and_4165 ? (patches_word_up_q + (and_4113 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4174;
  assign select_4174 = and_4165 ? (patches_word_down_q + (and_4113 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_4178;
  assign select_4178 = ($signed(difference_4052[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4052[5:0];
  logic [5:0] select_4179;
  assign select_4179 = ($signed(14'h10) < $signed(difference_4052)) ? 6'h10 : select_4178;
  // hls/stages/patches.hpp:555
  logic [5:0] select_4181;
  assign select_4181 = equal_2391_s3_q ? (or_4005 ? 6'h0 : select_4179) : 6'h0;
  logic [5:0] select_4183;
  assign select_4183 = less_2388_s3_q ? (equal_2389_s3_q ? 6'h0 : select_4181) : select_4181;
  // hls/stages/patches.hpp:658
  logic [5:0] select_4185;
  assign select_4185 = and_4010 ? (equal_2225_s3_q ? select_4183 : 6'h0) : 6'h0;
  logic [11:0] sum_4186;
  assign sum_4186 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4185[5]}}, select_4185};
  // hls/stages/agreement.hpp:788
  logic and_4190;
  assign and_4190 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q & (equal_3294 & less_4103)));
  // hls/stages/agreement.hpp:1142
  logic and_4194;
  assign and_4194 = x_s3_q[6] & (not_2418_s3_q & (less_4103 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_4195;
  assign and_4195 = equal_549_s3_q & and_4194;
  // hls/stages/patches.hpp:642
  logic [7:0] select_4197;
  assign select_4197 = and_4190 ? (and_4195 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_4201;
  assign or_4201 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_4204;
  assign or_4204 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_4205;
  assign sum_4205 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_4207;
  assign select_4207 = and_4190 ? (and_4195 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_4212;
  assign and_4212 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_4214;
  assign select_4214 = and_4195 ? {and_4212, patches_found_q[2:1]} : (and_4190 ? {and_4212, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_4218;
  assign or_4218 = patches_partly_q | (patches_doubted_q & (~and_4195));
  // hls/stages/patches.hpp:641
  logic select_4221;
  assign select_4221 = and_4190 ? (and_4195 ? or_4218 : (and_4190 ? or_4218 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_4222;
  assign select_4222 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_4226;
  assign select_4226 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_4228;
  assign sum_4228 = {sum_4050[6], sum_4050, select_3981_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_4231;
  assign and_4231 = equal_2391_s3_q & (not_4006 & ({{5{sum_4228[10]}}, sum_4228} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4234;
  assign and_4234 = equal_2225_s3_q & (less_2388_s3_q ? (not_2390_s3_q & and_4231) : and_4231);
  // hls/stages/patches.hpp:188
  logic and_4235;
  assign and_4235 = and_4010 & and_4234;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4236;
  assign sum_4236 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4235};
  // hls/stages/patches.hpp:649
  logic [12:0] product_4237;
  assign product_4237 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4197};
  // hls/stages/patches.hpp:188
  logic and_4243;
  assign and_4243 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_4248;
  assign select_4248 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_4252;
  assign or_4252 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_4259;
  assign select_4259 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_4265;
  assign and_4265 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4266;
  assign sum_4266 = patches_age_q + {9'h0, and_4265};
  logic [9:0] select_4269;
  assign select_4269 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4266)) : sum_4266;
  // hls/stages/agreement.hpp:1187
  logic or_4326;
  assign or_4326 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1216
  logic equal_4328;
  assign equal_4328 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1225
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1226
  logic select_4334;
  assign select_4334 = (equal_4328 & equal_4102) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_4337;
  assign sum_4337 = {1'b0, select_3047} + {2'h0, select_3047[9:1]};
  logic select_4340;
  assign select_4340 = (select_3044[9:3] == 7'h0) ? ((~or_4326) & (~select_4334)) : (~({sum_4337, select_3047[0]} < {2'h0, select_3044}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_4342;
  assign select_4342 = x_s3_q[6] ? (equal_2056_s3_q ? good_q : {select_4340, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_4346;
  assign select_4346 = equal_549_s3_q ? ((x_s3_q[6] & good_known_q) | equal_2733_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1216
  logic equal_4347;
  assign equal_4347 = x_s3_q[6:3] == 4'ha;
  logic equal_4349;
  assign equal_4349 = x_s3_q[6:3] == 4'hc;
  logic equal_4350;
  assign equal_4350 = x_s3_q[6:3] == 4'hb;
  logic equal_4351;
  assign equal_4351 = x_s3_q[6:3] == 4'h9;
  logic equal_4352;
  assign equal_4352 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4354;
  assign select_4354 = equal_4351 ? counts_skin_unproven_q : (equal_4352 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4356;
  assign select_4356 = equal_4350 ? counts_regions_bad_q : (equal_4347 ? counts_nearer_q : select_4354);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4349 ? counts_on_skin_q : select_4356;
  // hls/stages/agreement.hpp:1221
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1229
  logic select_4359;
  assign select_4359 = (equal_4347 & equal_4102) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1147
  logic not_4360;
  assign not_4360 = ~hidden_for_q[7];
  logic [7:0] select_4362;
  assign select_4362 = select_4359 ? (hidden_for_q + {7'h0, not_4360}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_4364;
  assign select_4364 = equal_549_s3_q ? (equal_2733_s3_q ? select_4362 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1230
  logic [13:0] select_4365;
  assign select_4365 = equal_4102 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_4367;
  assign select_4367 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4369;
  assign select_4369 = equal_4352 ? cfg_unproven_skin_limit_i : (equal_4328 ? cfg_unproven_limit_i : select_4367);
  logic [7:0] select_4371;
  assign select_4371 = equal_4347 ? cfg_regions_limit_i : (equal_4351 ? cfg_hidden_limit_i : select_4369);
  logic [7:0] limit;
  assign limit = equal_4349 ? cfg_regions_limit_i : (equal_4350 ? {cfg_on_skin_limit_i, 3'h0} : select_4371);
  // hls/stages/agreement.hpp:1230
  logic not_4374;
  assign not_4374 = ~x_s3_q[2];
  logic [3:0] select_4375;
  assign select_4375 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4374, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4374};
  logic [7:0] select_4376;
  assign select_4376 = x_s3_q[0] ? {select_4375[3], 1'b0, select_4375[2], 1'b0, select_4375[1], 1'b0, select_4375[0], 1'b0} : {1'b0, select_4375[3], 1'b0, select_4375[2], 1'b0, select_4375[1], 1'b0, select_4375[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_4380;
  assign select_4380 = equal_4351 ? counts_skin_supervised_q : (equal_4352 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4382;
  assign select_4382 = equal_4350 ? counts_skin_textured_q : (equal_4347 ? counts_textured_q : select_4380);
  logic [13:0] of;
  assign of = equal_4349 ? counts_textured_q : select_4382;
  // hls/stages/agreement.hpp:1230
  logic [13:0] select_4384;
  assign select_4384 = ((limit & select_4376) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4365} + {1'b0, select_4384};
  // hls/stages/agreement.hpp:788
  logic select_4389;
  assign select_4389 = equal_549_s3_q ? (equal_4102 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1227
  logic and_4394;
  assign and_4394 = too_much_q & (~(equal_4352 & equal_4102));
  // hls/stages/agreement.hpp:1228
  logic select_4399;
  assign select_4399 = (over[14] & equal_4102) ? (and_4394 | ((equal_4352 | equal_4351) | (x_s3_q[6:3] == 4'hf))) : and_4394;
  // hls/stages/agreement.hpp:1125
  logic and_4404;
  assign and_4404 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1230
  logic select_4405;
  assign select_4405 = (equal_4349 & equal_4102) ? and_4404 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4407;
  assign select_4407 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4409;
  assign select_4409 = equal_549_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4407 : box_textured_columns_values_0_q);
  logic [2:0] select_4410;
  assign select_4410 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4412;
  assign select_4412 = equal_549_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4410 : box_textured_columns_values_1_q);
  logic [2:0] select_4413;
  assign select_4413 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4415;
  assign select_4415 = equal_549_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4413 : box_textured_columns_values_2_q);
  logic [2:0] select_4416;
  assign select_4416 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4418;
  assign select_4418 = equal_549_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4416 : box_textured_columns_values_3_q);
  logic [2:0] select_4419;
  assign select_4419 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4421;
  assign select_4421 = equal_549_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4419 : box_textured_columns_values_4_q);
  logic [4:0] select_4423;
  assign select_4423 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4425;
  assign select_4425 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4427;
  assign select_4427 = equal_549_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4425 : box_explained_columns_values_0_q);
  logic [2:0] select_4428;
  assign select_4428 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4430;
  assign select_4430 = equal_549_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4428 : box_explained_columns_values_1_q);
  logic [2:0] select_4431;
  assign select_4431 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4433;
  assign select_4433 = equal_549_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4431 : box_explained_columns_values_2_q);
  logic [2:0] select_4434;
  assign select_4434 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4436;
  assign select_4436 = equal_549_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4434 : box_explained_columns_values_3_q);
  logic [2:0] select_4437;
  assign select_4437 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4439;
  assign select_4439 = equal_549_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4437 : box_explained_columns_values_4_q);
  logic [4:0] select_4441;
  assign select_4441 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4444;
  assign select_4444 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_549_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4446 : box_shown_columns_values_1_q);
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_549_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4449 : box_shown_columns_values_2_q);
  logic [2:0] select_4452;
  assign select_4452 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4454;
  assign select_4454 = equal_549_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4452 : box_shown_columns_values_3_q);
  logic [2:0] select_4455;
  assign select_4455 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4457;
  assign select_4457 = equal_549_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4455 : box_shown_columns_values_4_q);
  logic [4:0] select_4459;
  assign select_4459 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4462;
  assign select_4462 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4464;
  assign select_4464 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4466;
  assign select_4466 = equal_549_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4464 : box_nearer_columns_values_1_q);
  logic [2:0] select_4467;
  assign select_4467 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4469;
  assign select_4469 = equal_549_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4467 : box_nearer_columns_values_2_q);
  logic [2:0] select_4470;
  assign select_4470 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4472;
  assign select_4472 = equal_549_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4470 : box_nearer_columns_values_3_q);
  logic [2:0] select_4473;
  assign select_4473 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4475;
  assign select_4475 = equal_549_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4473 : box_nearer_columns_values_4_q);
  logic [4:0] select_4477;
  assign select_4477 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1307
  logic [1:0] select_4522;
  assign select_4522 = and_4521_s3_q ? {and_2554, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1308
  logic and_4523;
  assign and_4523 = proven_q & less_4511;
  // hls/stages/agreement.hpp:437
  logic select_4526;
  assign select_4526 = and_2484_s3_q ? (less_2485_s3_q ? (select_4522[0] & and_4523) : seen_q) : seen_q;
  logic select_4529;
  assign select_4529 = and_2484_s3_q ? (less_2485_s3_q ? (select_4522[1] & and_4523) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1238
  logic or_4537;
  assign or_4537 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4536_s3_q;
  // hls/stages/agreement.hpp:1240
  logic not_4545;
  assign not_4545 = ~(or_4326 | not_4530);
  // hls/stages/agreement.hpp:788
  logic and_4549;
  assign and_4549 = equal_549_s3_q & (equal_2733_s3_q & (not_4545 & (select_4334 | select_4399)));
  logic and_4552;
  assign and_4552 = equal_2733_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1149
  logic or_4556;
  assign or_4556 = select_2867 | (select_2879 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4563;
  assign and_4563 = equal_549_s3_q & (equal_2733_s3_q & (not_4545 & (select_2873 | select_2885)));
  // hls/stages/agreement.hpp:1149
  logic and_4568;
  assign and_4568 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4362 < cfg_hidden_frames_i));
  logic select_4574;
  assign select_4574 = (not_4530 | (select_4405 & not_4239)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4583;
  assign and_4583 = equal_549_s3_q & (x_s3_q[6] & (not_2418_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4591;
  assign select_4591 = equal_2078_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4589_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4592;
  assign select_4592 = equal_2076_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4591;
  logic [31:0] select_4593;
  assign select_4593 = equal_2074_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4592;
  logic [31:0] select_4594;
  assign select_4594 = equal_2072_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4593;
  logic [31:0] select_4595;
  assign select_4595 = equal_2070_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4594;
  logic [31:0] select_4596;
  assign select_4596 = equal_2068_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4595;
  logic [31:0] select_4597;
  assign select_4597 = equal_2066_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4596;
  logic [31:0] select_4598;
  assign select_4598 = equal_2064_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4597;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4599;
  assign select_4599 = less_3043 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4600;
  assign select_4600 = equal_2056_s3_q ? select_4598 : {2'h0, select_4599, select_3047, select_3044};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_525_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_721_s3_q, and_720, less_715_s3_q, and_714_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_708, and_684_s3_q, and_683_s3_q, and_658_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q, less_640_s3_q, less_639_s3_q, less_638_s3_q, less_637_s3_q, less_636_s3_q, less_635_s3_q, less_634_s3_q, less_633_s3_q, less_632_s3_q, less_631_s3_q, less_630_s3_q, less_629_s3_q, less_628_s3_q, less_627_s3_q};
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
  assign registration_sums_waddr = {sum_2062_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2121_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2120, sum_2116};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2150_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2224_s3_q;
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
  assign patches_right_0_waddr = {select_2255_s3_q, select_2252};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2264);
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
  assign patches_right_1_waddr = {select_2255_s3_q, select_2281};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2284);
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
  assign patches_left_waddr = {select_2303, select_2302_s3_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2309);
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
  assign patches_rows_wdata = select_2406;
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
  assign regions_waddr = {region_row_s3_q, or_2416_s3_q, or_2413_s3_q, or_2410_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2450_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2449, sum_2439, sum_2434};
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
  assign map_waddr = {sum_2490_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2564_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2554, is_seen};
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
      census_left_misses_q <= select_2713;
      sharpness_before_last_mask_q <= select_2781;
      sharpness_sums_detail_0_q <= and_525_s3_q ? select_2795 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_525_s3_q ? select_2807 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_525_s3_q ? sum_2811 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_525_s3_q ? sum_2815 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2833 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2843 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2845 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2847 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2849 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2851 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2856;
      sharpness_comparing_carry_1_q <= select_2860;
      sharpness_comparing_less_detail_0_q <= select_2867;
      sharpness_comparing_less_detail_1_q <= select_2873;
      sharpness_comparing_less_contrast_0_q <= select_2879;
      sharpness_comparing_less_contrast_1_q <= select_2885;
      counts_supervised_q <= select_3001;
      counts_textured_q <= and_2993_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3004});
      counts_explained_q <= and_2993_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3009});
      counts_nearer_q <= and_2993_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3014});
      counts_unproven_q <= and_2993_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3040});
      counts_regions_bad_q <= select_3056;
      counts_skin_supervised_q <= select_3063;
      counts_skin_textured_q <= select_3070;
      counts_skin_unproven_q <= select_3078;
      counts_on_skin_q <= select_3097;
      registration_half_across_q <= select_3175;
      registration_half_measured_q <= select_3180;
      registration_half_votes_down_q <= and_3153_s3_q ? 7'h0 : sum_3186;
      registration_half_votes_up_q <= and_3153_s3_q ? 7'h0 : sum_3194;
      registration_half_half_votes_down_q <= and_3153_s3_q ? 7'h0 : sum_3201;
      registration_half_half_votes_up_q <= and_3153_s3_q ? 7'h0 : sum_3208;
      registration_down_q <= and_3242 ? sum_3261 : registration_down_q;
      registration_up_q <= and_3242 ? sum_3270 : registration_up_q;
      registration_enough_q <= select_3284;
      registration_votes_down_q <= and_3289 ? less_3290 : registration_votes_down_q;
      registration_votes_up_q <= and_3289 ? less_3292 : registration_votes_up_q;
      registration_other_enough_q <= and_3298 ? select_3284 : registration_other_enough_q;
      registration_other_down_q <= and_3298 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3298 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_549_s3_q & and_3305)) & or_3330;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2243 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2245 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2246 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3415;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2272 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2274 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2275 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3420;
      patches_valid_0_q <= select_3425;
      patches_valid_1_q <= select_3430;
      patches_right_next_0_q <= select_3433;
      patches_right_next_1_q <= select_3436;
      patches_left_next_0_q <= select_3439;
      patches_left_next_1_q <= select_3442;
      patches_sums_values_0_q <= select_3866;
      patches_sums_values_1_q <= equal_2225_s3_q ? patches_sums_values_1_q : select_3867;
      patches_sums_values_2_q <= equal_2225_s3_q ? patches_sums_values_2_q : select_3869;
      patches_sums_values_3_q <= equal_2225_s3_q ? patches_sums_values_3_q : select_3871;
      patches_sums_values_4_q <= equal_2225_s3_q ? patches_sums_values_4_q : select_3873;
      patches_sums_values_5_q <= equal_2225_s3_q ? patches_sums_values_5_q : select_3875;
      patches_sums_values_6_q <= equal_2225_s3_q ? patches_sums_values_6_q : select_3877;
      patches_sums_values_7_q <= equal_2225_s3_q ? patches_sums_values_7_q : select_3879;
      patches_sums_values_8_q <= equal_2225_s3_q ? patches_sums_values_8_q : select_3881;
      patches_sums_values_9_q <= equal_2225_s3_q ? patches_sums_values_9_q : select_3883;
      patches_sums_values_10_q <= equal_2225_s3_q ? patches_sums_values_10_q : select_3885;
      patches_sums_values_11_q <= equal_2225_s3_q ? patches_sums_values_11_q : select_3887;
      patches_sums_values_12_q <= equal_2225_s3_q ? patches_sums_values_12_q : select_3889;
      patches_sums_values_13_q <= equal_2225_s3_q ? patches_sums_values_13_q : select_3891;
      patches_sums_values_14_q <= equal_2225_s3_q ? patches_sums_values_14_q : select_3893;
      patches_sums_values_15_q <= equal_2225_s3_q ? patches_sums_values_15_q : select_3895;
      patches_sums_values_16_q <= equal_2225_s3_q ? patches_sums_values_16_q : select_3897;
      patches_best_differing_q <= select_2406[9:0];
      patches_best_column_q <= select_2406[14:10];
      patches_quarters_0_places_q <= sum_4021;
      patches_quarters_0_up_q <= sum_4061;
      patches_quarters_0_down_q <= sum_4071;
      patches_quarters_1_places_q <= sum_4075;
      patches_quarters_1_up_q <= sum_4078;
      patches_quarters_1_down_q <= sum_4081;
      patches_quarters_2_places_q <= sum_4085;
      patches_quarters_2_up_q <= sum_4088;
      patches_quarters_2_down_q <= sum_4091;
      patches_quarters_3_places_q <= sum_4095;
      patches_quarters_3_up_q <= sum_4098;
      patches_quarters_3_down_q <= sum_4101;
      patches_word_places_q <= or_4129;
      patches_word_up_q <= ((select_4139 | select_4141) | select_4144) | select_4147;
      patches_word_down_q <= ((select_4150 | select_4152) | select_4155) | select_4158;
      patches_sum_places_q <= select_4168;
      patches_sum_up_q <= select_4171;
      patches_sum_down_q <= select_4174;
      patches_across_q <= sum_4186;
      patches_places_q <= select_4197;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4201;
      patches_partly_q <= or_4204;
      patches_clear_limit_q <= sum_4205[8:2];
      patches_complete_q <= select_4207;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4190 ? select_4214 : patches_found_q;
      patches_doubted_q <= select_4221;
      patches_doubted_before_q <= select_4222;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4226;
      patches_on_skin_q <= sum_4236;
      patches_on_skin_most_q <= product_4237[12:5];
      patches_large_q <= not_4239 & and_4243;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4248;
      patches_spoiled_q <= or_4252;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4259;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4269;
      segment_textured_q <= select_2431 + {6'h0, and_3004};
      segment_explained_q <= select_2436 + {6'h0, and_3009};
      segment_nearer_q <= select_2446 + {6'h0, and_3014};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_549_s3_q ? select_4342 : good_q;
      good_known_q <= select_4346;
      hidden_for_q <= select_4364;
      product_q <= equal_549_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4389;
      disagree_q <= equal_549_s3_q ? select_4334 : disagree_q;
      too_much_q <= equal_549_s3_q ? select_4399 : too_much_q;
      hides_q <= equal_549_s3_q ? select_4359 : hides_q;
      overlooks_q <= equal_549_s3_q ? select_4405 : overlooks_q;
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
      averager_quarter_1_0_q <= select_2588;
      averager_quarter_1_1_q <= select_2590;
      averager_quarter_2_0_q <= select_2592;
      averager_quarter_2_1_q <= select_2594;
      averager_detail_0_q <= select_2606;
      averager_detail_1_q <= select_2614;
      census_changes_values_0_left_q <= and_525_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_525_s3_q ? sum_2697 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2699;
      census_changes_values_1_right_q <= select_2700;
      census_changes_values_2_left_q <= select_2701;
      census_changes_values_2_right_q <= select_2702;
      sharpness_last_mask_q <= and_525_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_525_s3_q ? select_2778[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_525_s3_q ? select_2778[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4409;
      box_textured_columns_values_1_q <= select_4412;
      box_textured_columns_values_2_q <= select_4415;
      box_textured_columns_values_3_q <= select_4418;
      box_textured_columns_values_4_q <= select_4421;
      box_textured_sum_sums_values_0_q <= equal_549_s3_q ? box_textured_sum_sums_values_0_q : select_4423;
      box_explained_columns_values_0_q <= select_4427;
      box_explained_columns_values_1_q <= select_4430;
      box_explained_columns_values_2_q <= select_4433;
      box_explained_columns_values_3_q <= select_4436;
      box_explained_columns_values_4_q <= select_4439;
      box_explained_sum_sums_values_0_q <= equal_549_s3_q ? box_explained_sum_sums_values_0_q : select_4441;
      box_shown_columns_values_0_q <= equal_549_s3_q ? box_shown_columns_values_0_q : select_4444;
      box_shown_columns_values_1_q <= select_4448;
      box_shown_columns_values_2_q <= select_4451;
      box_shown_columns_values_3_q <= select_4454;
      box_shown_columns_values_4_q <= select_4457;
      box_shown_sum_sums_values_0_q <= equal_549_s3_q ? box_shown_sum_sums_values_0_q : select_4459;
      box_nearer_columns_values_0_q <= equal_549_s3_q ? box_nearer_columns_values_0_q : select_4462;
      box_nearer_columns_values_1_q <= select_4466;
      box_nearer_columns_values_2_q <= select_4469;
      box_nearer_columns_values_3_q <= select_4472;
      box_nearer_columns_values_4_q <= select_4475;
      box_nearer_sum_sums_values_0_q <= equal_549_s3_q ? box_nearer_sum_sums_values_0_q : select_4477;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4506_s4_q;
  logic or_4531_s4_q;
  logic and_4532_s4_q;
  logic and_4540_s4_q;
  logic and_4543_s4_q;
  logic and_4549_s4_q;
  logic and_4553_s4_q;
  logic and_4559_s4_q;
  logic and_4563_s4_q;
  logic and_4571_s4_q;
  logic and_4576_s4_q;
  logic and_4579_s4_q;
  logic and_4583_s4_q;
  logic [5:0] select_4585_s4_q;
  logic [31:0] select_4602_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4506_s4_q <= said_q;
      or_4531_s4_q <= not_4530 | select_4526;
      and_4532_s4_q <= cfg_prove_i & select_4529;
      and_4540_s4_q <= equal_549_s3_q & (equal_2733_s3_q & (cfg_prove_i & or_4537));
      and_4543_s4_q <= equal_549_s3_q & (equal_2733_s3_q & (cfg_prove_i & or_4326));
      and_4549_s4_q <= and_4549;
      and_4553_s4_q <= equal_549_s3_q & and_4552;
      and_4559_s4_q <= equal_549_s3_q & (equal_2733_s3_q & (not_4545 & or_4556));
      and_4563_s4_q <= and_4563;
      and_4571_s4_q <= equal_549_s3_q & (equal_2733_s3_q & (cfg_prove_i & and_4568));
      and_4576_s4_q <= equal_549_s3_q & (equal_2733_s3_q & select_4574);
      and_4579_s4_q <= and_4579_s3_q;
      and_4583_s4_q <= and_4583;
      select_4585_s4_q <= equal_549_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4602_s4_q <= equal_549_s3_q ? (x_s3_q[6] ? select_4600 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4531_s4_q;
  assign marks_nearer_o = and_4532_s4_q;
  assign verdict_valid_o = and_4506_s4_q;
  assign verdict_unproven_yet_o = and_4540_s4_q;
  assign verdict_untextured_o = and_4543_s4_q;
  assign verdict_disagree_o = and_4549_s4_q;
  assign verdict_moved_o = and_4553_s4_q;
  assign verdict_unsharp_left_o = and_4559_s4_q;
  assign verdict_unsharp_right_o = and_4563_s4_q;
  assign verdict_hidden_o = and_4571_s4_q;
  assign verdict_overlooked_o = and_4576_s4_q;
  assign verdict_out_of_step_o = and_4579_s4_q;
  assign frame_valid_o = and_4583_s4_q;
  assign frame_index_o = select_4585_s4_q;
  assign frame_word_o = select_4602_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4237[4:0], sum_4205[1:0], sum_4160[1:0], product_4051[4:0], sum_3143[0], difference_3084[1:0], detail_4[1:0], detail_3[1:0], sum_2707[4:0], sum_2166[0], sum_2162[0], sum_706[4:0], cfg_width_i[2:0]};

endmodule
