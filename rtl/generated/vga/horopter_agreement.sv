// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2946 bits, pipeline 831 bits, memories 101080 bits.
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
  logic [5:0] sum_2858;
  assign sum_2858 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3878;
  assign difference_3878 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4096;
  assign not_4096 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4153;
  assign difference_4153 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4368;
  assign less_4368 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4369;
  assign sum_4369 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4387;
  assign not_4387 = ~cfg_prove_i;

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
  // hls/stages/census.hpp:35
  logic [2:0] select_479;
  assign select_479 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_481;
  assign select_481 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_484;
  assign select_484 = ({select_481, select_479} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_485;
  assign select_485 = select_479[0] ? averager_place_q : select_484;
  // hls/stages/census.hpp:41
  logic or_486;
  assign or_486 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:411
  logic and_489;
  assign and_489 = (select_479[0] & or_486) & (select_485[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_494;
  assign select_494 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:270
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_481 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_511;
  assign equal_511 = select_479 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_512;
  assign equal_512 = select_494 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_513;
  assign and_513 = equal_512 & and_489;
  // hls/stages/agreement.hpp:270
  logic and_515;
  assign and_515 = sample_pair_whole_q & (equal_511 & and_513);
  // hls/stages/agreement.hpp:194
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:617
  logic equal_535;
  assign equal_535 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:588
  logic or_536;
  assign or_536 = so | equal_535;
  logic not_537;
  assign not_537 = ~or_536;
  // hls/stages/agreement.hpp:608
  logic equal_538;
  assign equal_538 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:609
  logic equal_540;
  assign equal_540 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_541;
  assign sum_541 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:588
  logic [7:0] select_542;
  assign select_542 = run_shift_q[5] ? x_q : sum_541;
  logic less_543;
  assign less_543 = {1'b0, last_q} < select_542;
  // hls/stages/agreement.hpp:222
  logic not_544;
  assign not_544 = ~less_543;
  // hls/stages/agreement.hpp:147
  logic and_545;
  assign and_545 = equal_540 & not_544;
  logic and_547;
  assign and_547 = not_537 & ((~equal_538) & and_545);
  // hls/stages/census.hpp:41
  logic [5:0] select_574;
  assign select_574 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_574 : 6'h0;
  // hls/stages/agreement.hpp:147
  logic select_631;
  assign select_631 = equal_538 ? not_544 : and_545;
  // hls/stages/agreement.hpp:790
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:147
  logic and_655;
  assign and_655 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_542)));
  logic and_656;
  assign and_656 = equal_538 & and_655;
  logic select_657;
  assign select_657 = or_536 ? not_544 : and_656;
  // hls/stages/agreement.hpp:813
  logic [6:0] right;
  assign right = sum_541[6:0] + 7'h7d;
  // hls/stages/patches.hpp:122
  logic and_2063;
  assign and_2063 = (select_479 == 3'h0) & (select_481 == 7'h0);
  // hls/stages/patches.hpp:391
  logic not_2064;
  assign not_2064 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2067;
  assign not_2067 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:361
  logic and_2068;
  assign and_2068 = patches_capturing_q & not_2067;
  // hls/stages/patches.hpp:363
  logic equal_2069;
  assign equal_2069 = {or_486, select_494} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2071;
  assign equal_2071 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2076;
  assign and_2076 = (not_2064 & (patches_work_q == 3'h0)) & (~(and_2068 | ((~equal_2069) | (~equal_2071))));
  // hls/stages/patches.hpp:529
  logic equal_2165;
  assign equal_2165 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_2166;
  assign not_2166 = ~equal_2165;
  // hls/stages/patches.hpp:500
  logic equal_2167;
  assign equal_2167 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_2168;
  assign not_2168 = ~equal_2167;
  // hls/stages/patches.hpp:494
  logic equal_2169;
  assign equal_2169 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2170;
  assign equal_2170 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_2171;
  assign or_2171 = equal_2169 | equal_2170;
  // hls/stages/patches.hpp:455
  logic not_2172;
  assign not_2172 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_2194;
  assign select_2194 = and_2076 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2195;
  assign select_2195 = and_2063 ? select_2194 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2197;
  assign and_2197 = and_2068 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2201;
  assign select_2201 = and_2063 ? (and_2076 | (and_2068 & (~and_2197))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2209;
  assign and_2209 = not_2166 & (not_2168 & (or_2171 & (patches_second_q & equal_2170)));
  // hls/stages/patches.hpp:167
  logic not_2226;
  assign not_2226 = ~equal_2170;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2242;
  assign select_2242 = and_2063 ? {select_2194[4], select_2194[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_2252;
  assign and_2252 = not_2166 & (or_2171 & not_2168);
  // hls/stages/agreement.hpp:270
  logic [2:0] select_2508;
  assign select_2508 = sample_pair_whole_q ? (sample_last_q ? (select_494 + 3'h1) : select_494) : raster_at_y_q;
  logic [6:0] select_2510;
  assign select_2510 = sample_pair_whole_q ? (select_481 + {6'h0, equal_511}) : raster_at_column_q;
  logic [5:0] select_2513;
  assign select_2513 = sample_pair_whole_q ? (sample_last_q ? (select_574 + {5'h0, equal_512}) : select_574) : raster_at_row_q;
  logic select_2517;
  assign select_2517 = sample_pair_whole_q ? (sample_last_q ? (or_486 & (~raster_final_row_q)) : or_486) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2519;
  assign select_2519 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:270
  logic select_2523;
  assign select_2523 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:453
  logic equal_2767;
  assign equal_2767 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:458
  logic and_2768;
  assign and_2768 = and_515 & equal_2767;
  // hls/stages/agreement.hpp:517
  logic select_2771;
  assign select_2771 = (and_2768 | (~ends_cell_q)) ? and_2768 : ends_q;
  // hls/stages/agreement.hpp:523
  logic [2:0] now;
  assign now = select_2771 ? (and_2768 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:528
  logic [5:0] select_2775;
  assign select_2775 = select_2771 ? (and_2768 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2778;
  assign select_2778 = select_2771 ? (following_last_shift_q & (~and_2768)) : run_last_shift_q;
  // hls/stages/agreement.hpp:601
  logic and_2781;
  assign and_2781 = run_last_shift_q & equal_538;
  // hls/stages/agreement.hpp:610
  logic select_2783;
  assign select_2783 = equal_538 ? (~run_last_shift_q) : equal_540;
  // hls/stages/agreement.hpp:614
  logic equal_2784;
  assign equal_2784 = run_phase_q == 3'h1;
  logic not_2787;
  assign not_2787 = ~select_2783;
  // hls/stages/agreement.hpp:617
  logic equal_2789;
  assign equal_2789 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:601
  logic and_2790;
  assign and_2790 = final_row_q & so;
  // hls/stages/agreement.hpp:614
  logic [1:0] select_2791;
  assign select_2791 = equal_2789 ? 2'h1 : {2{and_2790}};
  logic [2:0] select_2793;
  assign select_2793 = (and_2781 | (select_2783 | equal_2784)) ? (equal_2784 ? 3'h2 : {not_2787, {2{select_2783}}}) : (equal_535 ? 3'h6 : {select_2791[0], select_2791});
  // hls/stages/agreement.hpp:601
  logic and_2796;
  assign and_2796 = select_2783 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:624
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2799;
  assign select_2799 = (plan_shift_q[5] & select_2783) ? value : 7'h0;
  logic [1:0] or_2800;
  assign or_2800 = {2{so}} | select_2799[5:4];
  // hls/stages/agreement.hpp:627
  logic [7:0] or_2804;
  assign or_2804 = (select_2783 ? plan_columns_q : 8'h0) | ((equal_2784 | equal_2789) ? whole_q : 8'h0);
  logic [1:0] or_2805;
  assign or_2805 = {2{and_2781}} | or_2804[3:2];
  // hls/stages/agreement.hpp:628
  logic [7:0] or_2807;
  assign or_2807 = {or_2804[7:4], or_2805, or_2804[1:0]} | (equal_535 ? drawn_q : 8'h0);
  logic [4:0] or_2808;
  assign or_2808 = {5{so}} | {or_2807[6], or_2807[3:0]};
  // hls/stages/agreement.hpp:634
  logic not_2812;
  assign not_2812 = ~run_shift_q[5];
  logic [7:0] select_2815;
  assign select_2815 = equal_538 ? ({{7{not_2812}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:517
  logic [6:0] select_2819;
  assign select_2819 = and_2768 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2821;
  assign select_2821 = select_2771 ? {select_2819[6], select_2819} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2824;
  assign select_2824 = select_2771 ? (and_2768 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:514
  logic [6:0] select_2832;
  assign select_2832 = and_515 ? (equal_2767 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2835;
  assign select_2835 = and_515 ? (equal_2767 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2838;
  assign select_2838 = and_515 ? (equal_2767 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:525
  logic select_2849;
  assign select_2849 = (ends_cell_q | select_2771) ? (~(now == 3'h6)) : (equal_538 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:520
  logic and_2853;
  assign and_2853 = (~select_2771) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:470
  logic [6:0] sum_2854;
  assign sum_2854 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:454
  logic select_2856;
  assign select_2856 = equal_2767 ? ({sum_2854[6], cfg_height_i[8:3]} == {1'b0, sum_2854[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3191;
  assign select_3191 = and_2063 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_3192;
  assign select_3192 = sample_pair_whole_q ? select_3191 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_3193;
  assign and_3193 = not_2067 & equal_2069;
  logic [8:0] select_3194;
  assign select_3194 = and_3193 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3195;
  assign select_3195 = and_3193 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3196;
  assign select_3196 = sample_pair_first_q ? select_3194 : select_3195;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_3198;
  assign select_3198 = sample_pair_whole_q ? (and_2063 ? select_3196[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3200;
  assign select_3200 = sample_pair_whole_q ? (and_2063 ? select_3196[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3203;
  assign select_3203 = sample_pair_whole_q ? (equal_2071 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3205;
  assign select_3205 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2071}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3206;
  assign equal_3206 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3207;
  assign not_3207 = ~equal_3206;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_3209;
  assign select_3209 = sample_pair_whole_q ? (phase + {not_3207, 1'b1, not_3207, equal_3206}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:464
  logic equal_3211;
  assign equal_3211 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3215;
  assign select_3215 = equal_3211 ? ((select_3192 == 4'h6) ? 4'h0 : (select_3192 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3216;
  assign equal_3216 = select_3215 == 4'h0;
  // hls/stages/agreement.hpp:454
  logic [3:0] select_3219;
  assign select_3219 = equal_2767 ? (equal_3216 ? 4'h6 : (select_3215 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3221;
  assign select_3221 = equal_3211 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:454
  logic [4:0] select_3223;
  assign select_3223 = equal_2767 ? (select_3221 + {4'h0, equal_3216}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:514
  logic select_3228;
  assign select_3228 = and_515 ? (equal_2767 ? ((6'h2 < row) & equal_3216) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3230;
  assign select_3230 = and_515 ? (equal_2767 ? select_3221 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:370
  logic or_3254;
  assign or_3254 = select_481[0] | select_574[5];
  logic [7:0] sum_3255;
  assign sum_3255 = {1'b0, select_481[2:1], or_3254, select_574[4:1]} + 8'h1;
  logic less_3256;
  assign less_3256 = {sum_3255, select_574[0], select_494, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3259;
  assign select_3259 = and_2063 ? (and_2076 ? (~less_3256) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_3298;
  assign or_3298 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3304;
  assign and_3304 = equal_2165 & not_2172;
  // hls/stages/patches.hpp:398
  logic and_3305;
  assign and_3305 = not_2226 & and_3304;
  logic [1:0] select_3307;
  assign select_3307 = equal_2167 ? 2'h0 : (equal_2169 ? 2'h3 : {equal_2170, and_3305});
  // hls/stages/patches.hpp:279
  logic equal_3309;
  assign equal_3309 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3310;
  assign not_3310 = ~equal_3309;
  // hls/stages/patches.hpp:279
  logic equal_3311;
  assign equal_3311 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3312;
  assign not_3312 = ~equal_3311;
  // hls/stages/patches.hpp:283
  logic not_3314;
  assign not_3314 = ~(patches_following_q == 3'h2);
  logic and_3317;
  assign and_3317 = (~(patches_following_q == 3'h1)) & not_3314;
  // hls/stages/patches.hpp:396
  logic [1:0] select_3318;
  assign select_3318 = equal_3311 ? 2'h2 : {and_3317, not_3314};
  logic [3:0] select_3319;
  assign select_3319 = equal_3309 ? 4'h2 : {select_3318, {2{not_3312}}};
  // hls/stages/patches.hpp:404
  logic not_3322;
  assign not_3322 = ~or_3298;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_3327;
  assign select_3327 = or_3298 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3329;
  assign select_3329 = or_3298 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1339; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_547;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1340; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_536 ? not_544 : select_631);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1341; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_538 ? sum_541[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_537 & select_631);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1342; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_536 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_657;
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
  assign patches_right_0_re = s0_en & (not_2166 & (not_2168 & (or_2171 & (equal_2170 & not_2172))));
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
  assign patches_right_1_re = s0_en & and_2209;
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
  assign patches_left_re = s0_en & (not_2166 & (not_2168 & (not_2226 & or_2171)));
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
  assign patches_columns_above_re = s0_en & and_2252;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_479 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2508;
      raster_at_column_q <= select_2510;
      raster_at_row_q <= select_2513;
      raster_at_live_q <= select_2517;
      raster_rows_left_q <= sample_pair_whole_q ? select_2519 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2523;
      averager_place_q <= sample_pair_whole_q ? select_485 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2775;
      run_last_shift_q <= select_2778;
      run_span_q <= select_2771 ? (and_2768 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2793;
      following_shift_q <= select_2783 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2796;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2799[6], or_2800, select_2799[3:0]};
      following_columns_q <= {or_2807[7], or_2808[4], or_2807[5:4], or_2808[3:0]};
      plan_shift_q <= equal_538 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2815;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2821;
      columns_left_q <= select_2824;
      last_q <= and_515 ? (equal_2767 ? column : last_q) : last_q;
      least_q <= select_2832;
      whole_q <= select_2835;
      drawn_q <= select_2838;
      age_q <= select_2771 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2771 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2849;
      ends_q <= and_2853;
      final_row_q <= and_515 ? select_2856 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3192;
      patches_band_rows_rows_to_next_q <= select_3198;
      patches_band_rows_number_q <= select_3200;
      patches_next_band_rows_to_next_q <= select_3203;
      patches_next_band_number_q <= select_3205;
      patches_first_band_rows_to_next_q <= select_3209;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3206 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_515 ? select_3219 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_515 ? select_3223 : patches_choosing_number_q;
      patches_chooses_q <= select_3228;
      patches_choosing_band_q <= select_3230;
      patches_capturing_q <= sample_pair_whole_q ? select_2201 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3259 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2195 : patches_row_q;
      patches_work_q <= or_3298 ? following : patches_work_q;
      patches_second_q <= not_2064 & (patches_second_q | (patches_ends_q & equal_2165));
      patches_following_q <= equal_2165 ? {2'h0, and_3304} : {equal_2167, select_3307};
      patches_following_beats_q <= {select_3319, not_3310};
      patches_begins_q <= sample_pair_whole_q & (and_2063 & and_2197);
      patches_ends_q <= not_3322 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3327;
      patches_code_row_q <= select_3329;
      patches_column_q <= or_3298 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3322 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_479_s1_q;
  logic [6:0] select_481_s1_q;
  logic [8:0] select_485_s1_q;
  logic and_489_s1_q;
  logic equal_495_s1_q;
  logic [6:0] column_s1_q;
  logic and_513_s1_q;
  logic and_515_s1_q;
  logic so_s1_q;
  logic equal_535_s1_q;
  logic or_536_s1_q;
  logic equal_538_s1_q;
  logic less_543_s1_q;
  logic not_544_s1_q;
  logic and_547_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_657_s1_q;
  logic and_1936_s1_q;
  logic [6:0] right_s1_q;
  logic equal_1944_s1_q;
  logic equal_1954_s1_q;
  logic and_2063_s1_q;
  logic and_2076_s1_q;
  logic equal_2165_s1_q;
  logic not_2166_s1_q;
  logic equal_2167_s1_q;
  logic not_2168_s1_q;
  logic equal_2169_s1_q;
  logic equal_2170_s1_q;
  logic or_2171_s1_q;
  logic [4:0] select_2195_s1_q;
  logic select_2201_s1_q;
  logic [3:0] select_2242_s1_q;
  logic and_2252_s1_q;
  logic equal_2767_s1_q;
  logic and_2768_s1_q;
  logic or_3298_s1_q;
  logic not_3322_s1_q;
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
      select_479_s1_q <= select_479;
      select_481_s1_q <= select_481;
      select_485_s1_q <= select_485;
      and_489_s1_q <= and_489;
      equal_495_s1_q <= select_494 == 3'h0;
      column_s1_q <= column;
      and_513_s1_q <= and_513;
      and_515_s1_q <= and_515;
      so_s1_q <= so;
      equal_535_s1_q <= equal_535;
      or_536_s1_q <= or_536;
      equal_538_s1_q <= equal_538;
      less_543_s1_q <= less_543;
      not_544_s1_q <= not_544;
      and_547_s1_q <= and_547;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_657_s1_q <= select_657;
      and_1936_s1_q <= not_537 & and_656;
      right_s1_q <= right;
      equal_1944_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      equal_1954_s1_q <= run_phase_q == 3'h7;
      and_2063_s1_q <= and_2063;
      and_2076_s1_q <= and_2076;
      equal_2165_s1_q <= equal_2165;
      not_2166_s1_q <= not_2166;
      equal_2167_s1_q <= equal_2167;
      not_2168_s1_q <= not_2168;
      equal_2169_s1_q <= equal_2169;
      equal_2170_s1_q <= equal_2170;
      or_2171_s1_q <= or_2171;
      select_2195_s1_q <= select_2195;
      select_2201_s1_q <= select_2201;
      select_2242_s1_q <= select_2242;
      and_2252_s1_q <= and_2252;
      equal_2767_s1_q <= equal_2767;
      and_2768_s1_q <= and_2768;
      or_3298_s1_q <= or_3298;
      not_3322_s1_q <= not_3322;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:119
  logic and_490;
  assign and_490 = sample_pair_whole_s1_q & and_489_s1_q;
  // hls/stages/agreement.hpp:660
  logic not_635;
  assign not_635 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:663
  logic and_636;
  assign and_636 = left_rdata_q[12] & not_635;
  logic and_637;
  assign and_637 = left_rdata_q[28] & not_635;
  logic and_638;
  assign and_638 = left_rdata_q[44] & not_635;
  logic and_639;
  assign and_639 = left_rdata_q[60] & not_635;
  // hls/stages/agreement.hpp:664
  logic and_643;
  assign and_643 = right_codes_rdata_q[12] & not_635;
  logic and_644;
  assign and_644 = right_codes_rdata_q[25] & not_635;
  logic and_645;
  assign and_645 = right_codes_rdata_q[38] & not_635;
  logic and_646;
  assign and_646 = right_codes_rdata_q[51] & not_635;
  logic and_647;
  assign and_647 = right_codes_rdata_q[64] & not_635;
  logic and_648;
  assign and_648 = right_codes_rdata_q[77] & not_635;
  // hls/stages/agreement.hpp:218
  logic and_663;
  assign and_663 = left_rdata_q[44] & not_544_s1_q;
  logic and_664;
  assign and_664 = right_codes_rdata_q[38] & not_544_s1_q;
  logic [11:0] select_665;
  assign select_665 = less_543_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_666;
  assign select_666 = less_543_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_670;
  assign select_670 = and_663 ? (and_664 ? (~(select_665 ^ select_666)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_676;
  assign parity_676 = ^select_670[5:3];
  logic parity_679;
  assign parity_679 = ^select_670[8:6];
  logic parity_682;
  assign parity_682 = ^select_670[11:3];
  // hls/stages/agreement.hpp:218
  logic and_686;
  assign and_686 = left_rdata_q[60] & not_544_s1_q;
  logic and_687;
  assign and_687 = right_codes_rdata_q[51] & not_544_s1_q;
  logic [11:0] select_688;
  assign select_688 = less_543_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_689;
  assign select_689 = less_543_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_693;
  assign select_693 = and_686 ? (and_687 ? (~(select_688 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_696;
  assign parity_696 = ^select_693[8:6];
  logic parity_699;
  assign parity_699 = ^select_693[11:9];
  // hls/stages/agreement.hpp:218
  logic and_703;
  assign and_703 = left_rdata_q[76] & not_544_s1_q;
  logic and_704;
  assign and_704 = right_codes_rdata_q[64] & not_544_s1_q;
  logic [11:0] select_705;
  assign select_705 = less_543_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_706;
  assign select_706 = less_543_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_710;
  assign select_710 = and_703 ? (and_704 ? (~(select_705 ^ select_706)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_716;
  assign parity_716 = ^select_710[2:0];
  logic parity_719;
  assign parity_719 = ^select_710[5:3];
  logic parity_722;
  assign parity_722 = ^select_710[8:0];
  logic parity_728;
  assign parity_728 = ^select_710[11:9];
  logic parity_731;
  assign parity_731 = ^select_693[2:0];
  logic parity_734;
  assign parity_734 = ^{select_710[11:9], select_693[5:0]};
  logic parity_737;
  assign parity_737 = ^{select_710, select_693, select_670[2:0]};
  logic xor_738;
  assign xor_738 = parity_682 ^ parity_737;
  // hls/stages/count_bits.hpp:23
  logic or_742;
  assign or_742 = (select_670[1:0] == 2'h3) | (select_670[2] & (select_670[0] | select_670[1]));
  // hls/stages/count_bits.hpp:25
  logic or_746;
  assign or_746 = (select_693[7:6] == 2'h3) | (select_693[8] & (select_693[6] | select_693[7]));
  logic or_750;
  assign or_750 = (select_693[10:9] == 2'h3) | (select_693[11] & (select_693[9] | select_693[10]));
  // hls/stages/count_bits.hpp:23
  logic or_758;
  assign or_758 = (select_710[7:6] == 2'h3) | (select_710[8] & (~(select_710[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_762;
  assign or_762 = (select_710[1:0] == 2'h3) | (select_710[2] & (select_710[0] | select_710[1]));
  logic or_766;
  assign or_766 = (select_710[4:3] == 2'h3) | (select_710[5] & (select_710[3] | select_710[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_769;
  assign parity_769 = ^{or_766, or_762, or_758};
  // hls/stages/count_bits.hpp:23
  logic or_773;
  assign or_773 = (select_693[4:3] == 2'h3) | (select_693[5] & (select_693[3] | select_693[4]));
  // hls/stages/count_bits.hpp:25
  logic or_777;
  assign or_777 = (select_710[10:9] == 2'h3) | (select_710[11] & (select_710[9] | select_710[10]));
  logic or_781;
  assign or_781 = (select_693[1:0] == 2'h3) | (select_693[2] & (select_693[0] | select_693[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_784;
  assign parity_784 = ^{or_781, or_777, or_773};
  logic parity_787;
  assign parity_787 = ^{or_781, or_777, or_773, or_766, or_762, or_758, or_750, or_746, or_742};
  // hls/stages/count_bits.hpp:25
  logic and_788;
  assign and_788 = parity_682 & parity_737;
  logic or_792;
  assign or_792 = (parity_676 & parity_679) | ((^select_670[11:9]) & (parity_676 | parity_679));
  logic and_795;
  assign and_795 = (^{select_693[11:6], select_670[2:0]}) & (parity_722 | parity_734);
  logic or_796;
  assign or_796 = (parity_722 & parity_734) | and_795;
  // hls/stages/count_bits.hpp:23
  logic or_803;
  assign or_803 = (select_670[10:9] == 2'h3) | (select_670[11] & (select_670[9] | select_670[10]));
  // hls/stages/count_bits.hpp:25
  logic or_807;
  assign or_807 = (select_670[4:3] == 2'h3) | (select_670[5] & (select_670[3] | select_670[4]));
  logic or_811;
  assign or_811 = (select_670[7:6] == 2'h3) | (select_670[8] & (select_670[6] | select_670[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_814;
  assign parity_814 = ^{or_811, or_807, or_803};
  // hls/stages/count_bits.hpp:25
  logic or_818;
  assign or_818 = (parity_696 & parity_699) | ((^select_670[2:0]) & (parity_696 | parity_699));
  logic or_822;
  assign or_822 = (parity_716 & parity_719) | ((^select_710[8:6]) & (parity_716 | parity_719));
  logic or_826;
  assign or_826 = (parity_728 & parity_731) | ((^select_693[5:3]) & (parity_728 | parity_731));
  // hls/stages/count_bits.hpp:24
  logic parity_829;
  assign parity_829 = ^{or_826, or_822, or_818};
  logic parity_832;
  assign parity_832 = ^{or_826, or_822, or_818, or_811, or_807, or_803, or_796, or_792, and_788};
  logic xor_833;
  assign xor_833 = parity_787 ^ parity_832;
  // hls/stages/count_bits.hpp:25
  logic and_834;
  assign and_834 = parity_787 & parity_832;
  logic or_838;
  assign or_838 = (parity_769 & parity_784) | ((^{or_750, or_746, or_742}) & (parity_769 | parity_784));
  logic or_842;
  assign or_842 = (parity_814 & parity_829) | ((^{or_796, or_792, and_788}) & (parity_814 | parity_829));
  logic or_849;
  assign or_849 = (or_746 & or_750) | (or_742 & (or_746 | or_750));
  logic or_853;
  assign or_853 = (or_762 & or_766) | (or_758 & (or_762 | or_766));
  logic or_857;
  assign or_857 = (or_777 & or_781) | (or_773 & (or_777 | or_781));
  // hls/stages/count_bits.hpp:24
  logic parity_860;
  assign parity_860 = ^{or_857, or_853, or_849};
  // hls/stages/count_bits.hpp:25
  logic or_864;
  assign or_864 = (or_792 & or_796) | (and_788 & (or_792 | or_796));
  logic or_868;
  assign or_868 = (or_807 & or_811) | (or_803 & (or_807 | or_811));
  logic or_872;
  assign or_872 = (or_822 & or_826) | (or_818 & (or_822 | or_826));
  // hls/stages/count_bits.hpp:24
  logic parity_875;
  assign parity_875 = ^{or_872, or_868, or_864};
  logic parity_878;
  assign parity_878 = ^{or_872, or_868, or_864, or_857, or_853, or_849, or_842, or_838, and_834};
  // hls/stages/count_bits.hpp:25
  logic or_882;
  assign or_882 = (parity_860 & parity_875) | ((^{or_842, or_838, and_834}) & (parity_860 | parity_875));
  logic or_886;
  assign or_886 = (or_838 & or_842) | (and_834 & (or_838 | or_842));
  logic or_890;
  assign or_890 = (or_853 & or_857) | (or_849 & (or_853 | or_857));
  logic or_894;
  assign or_894 = (or_868 & or_872) | (or_864 & (or_868 | or_872));
  // hls/stages/count_bits.hpp:24
  logic parity_899;
  assign parity_899 = ^{or_894, or_890, or_886, or_882};
  // hls/stages/count_bits.hpp:25
  logic or_903;
  assign or_903 = (or_890 & or_894) | (or_886 & (or_890 | or_894));
  logic and_904;
  assign and_904 = or_882 & (^{or_894, or_890, or_886});
  // hls/stages/count_bits.hpp:24
  logic xor_905;
  assign xor_905 = or_903 ^ and_904;
  // hls/stages/count_bits.hpp:27
  logic and_906;
  assign and_906 = or_903 & and_904;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_907;
  assign select_907 = equal_538_s1_q ? {and_906, xor_905, parity_899, parity_878, xor_833, xor_738} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_536_s1_q ? 6'h0 : select_907;
  // hls/stages/agreement.hpp:770
  logic [5:0] select_909;
  assign select_909 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_910;
  assign difference_910 = {1'b0, column_2} - {1'b0, select_909};
  logic [7:0] sum_912;
  assign sum_912 = {difference_910[6], difference_910} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:676
  logic [11:0] select_916;
  assign select_916 = and_663 ? (and_687 ? (~(select_688 ^ select_666)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_922;
  assign parity_922 = ^select_916[5:3];
  logic parity_925;
  assign parity_925 = ^select_916[8:6];
  logic parity_928;
  assign parity_928 = ^select_916[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_935;
  assign select_935 = and_686 ? (and_704 ? (~(select_705 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_938;
  assign parity_938 = ^select_935[8:6];
  logic parity_941;
  assign parity_941 = ^select_935[11:9];
  // hls/stages/agreement.hpp:218
  logic and_945;
  assign and_945 = right_codes_rdata_q[77] & not_544_s1_q;
  logic [11:0] select_946;
  assign select_946 = less_543_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_950;
  assign select_950 = and_703 ? (and_945 ? (~(select_946 ^ select_706)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_956;
  assign parity_956 = ^select_950[2:0];
  logic parity_959;
  assign parity_959 = ^select_950[5:3];
  logic parity_962;
  assign parity_962 = ^select_950[8:0];
  logic parity_968;
  assign parity_968 = ^select_950[11:9];
  logic parity_971;
  assign parity_971 = ^select_935[2:0];
  logic parity_974;
  assign parity_974 = ^{select_950[11:9], select_935[5:0]};
  logic parity_977;
  assign parity_977 = ^{select_950, select_935, select_916[2:0]};
  logic xor_978;
  assign xor_978 = parity_928 ^ parity_977;
  // hls/stages/count_bits.hpp:23
  logic or_982;
  assign or_982 = (select_916[1:0] == 2'h3) | (select_916[2] & (select_916[0] | select_916[1]));
  // hls/stages/count_bits.hpp:25
  logic or_986;
  assign or_986 = (select_935[7:6] == 2'h3) | (select_935[8] & (select_935[6] | select_935[7]));
  logic or_990;
  assign or_990 = (select_935[10:9] == 2'h3) | (select_935[11] & (select_935[9] | select_935[10]));
  // hls/stages/count_bits.hpp:23
  logic or_998;
  assign or_998 = (select_950[7:6] == 2'h3) | (select_950[8] & (~(select_950[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1002;
  assign or_1002 = (select_950[1:0] == 2'h3) | (select_950[2] & (select_950[0] | select_950[1]));
  logic or_1006;
  assign or_1006 = (select_950[4:3] == 2'h3) | (select_950[5] & (select_950[3] | select_950[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1009;
  assign parity_1009 = ^{or_1006, or_1002, or_998};
  // hls/stages/count_bits.hpp:23
  logic or_1013;
  assign or_1013 = (select_935[4:3] == 2'h3) | (select_935[5] & (select_935[3] | select_935[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1017;
  assign or_1017 = (select_950[10:9] == 2'h3) | (select_950[11] & (select_950[9] | select_950[10]));
  logic or_1021;
  assign or_1021 = (select_935[1:0] == 2'h3) | (select_935[2] & (select_935[0] | select_935[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1024;
  assign parity_1024 = ^{or_1021, or_1017, or_1013};
  logic parity_1027;
  assign parity_1027 = ^{or_1021, or_1017, or_1013, or_1006, or_1002, or_998, or_990, or_986, or_982};
  // hls/stages/count_bits.hpp:25
  logic and_1028;
  assign and_1028 = parity_928 & parity_977;
  logic or_1032;
  assign or_1032 = (parity_922 & parity_925) | ((^select_916[11:9]) & (parity_922 | parity_925));
  logic and_1035;
  assign and_1035 = (^{select_935[11:6], select_916[2:0]}) & (parity_962 | parity_974);
  logic or_1036;
  assign or_1036 = (parity_962 & parity_974) | and_1035;
  // hls/stages/count_bits.hpp:23
  logic or_1043;
  assign or_1043 = (select_916[10:9] == 2'h3) | (select_916[11] & (select_916[9] | select_916[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1047;
  assign or_1047 = (select_916[4:3] == 2'h3) | (select_916[5] & (select_916[3] | select_916[4]));
  logic or_1051;
  assign or_1051 = (select_916[7:6] == 2'h3) | (select_916[8] & (select_916[6] | select_916[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1054;
  assign parity_1054 = ^{or_1051, or_1047, or_1043};
  // hls/stages/count_bits.hpp:25
  logic or_1058;
  assign or_1058 = (parity_938 & parity_941) | ((^select_916[2:0]) & (parity_938 | parity_941));
  logic or_1062;
  assign or_1062 = (parity_956 & parity_959) | ((^select_950[8:6]) & (parity_956 | parity_959));
  logic or_1066;
  assign or_1066 = (parity_968 & parity_971) | ((^select_935[5:3]) & (parity_968 | parity_971));
  // hls/stages/count_bits.hpp:24
  logic parity_1069;
  assign parity_1069 = ^{or_1066, or_1062, or_1058};
  logic parity_1072;
  assign parity_1072 = ^{or_1066, or_1062, or_1058, or_1051, or_1047, or_1043, or_1036, or_1032, and_1028};
  logic xor_1073;
  assign xor_1073 = parity_1027 ^ parity_1072;
  // hls/stages/count_bits.hpp:25
  logic and_1074;
  assign and_1074 = parity_1027 & parity_1072;
  logic or_1078;
  assign or_1078 = (parity_1009 & parity_1024) | ((^{or_990, or_986, or_982}) & (parity_1009 | parity_1024));
  logic or_1082;
  assign or_1082 = (parity_1054 & parity_1069) | ((^{or_1036, or_1032, and_1028}) & (parity_1054 | parity_1069));
  logic or_1089;
  assign or_1089 = (or_986 & or_990) | (or_982 & (or_986 | or_990));
  logic or_1093;
  assign or_1093 = (or_1002 & or_1006) | (or_998 & (or_1002 | or_1006));
  logic or_1097;
  assign or_1097 = (or_1017 & or_1021) | (or_1013 & (or_1017 | or_1021));
  // hls/stages/count_bits.hpp:24
  logic parity_1100;
  assign parity_1100 = ^{or_1097, or_1093, or_1089};
  // hls/stages/count_bits.hpp:25
  logic or_1104;
  assign or_1104 = (or_1032 & or_1036) | (and_1028 & (or_1032 | or_1036));
  logic or_1108;
  assign or_1108 = (or_1047 & or_1051) | (or_1043 & (or_1047 | or_1051));
  logic or_1112;
  assign or_1112 = (or_1062 & or_1066) | (or_1058 & (or_1062 | or_1066));
  // hls/stages/count_bits.hpp:24
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  logic parity_1118;
  assign parity_1118 = ^{or_1112, or_1108, or_1104, or_1097, or_1093, or_1089, or_1082, or_1078, and_1074};
  // hls/stages/count_bits.hpp:25
  logic or_1122;
  assign or_1122 = (parity_1100 & parity_1115) | ((^{or_1082, or_1078, and_1074}) & (parity_1100 | parity_1115));
  logic or_1126;
  assign or_1126 = (or_1078 & or_1082) | (and_1074 & (or_1078 | or_1082));
  logic or_1130;
  assign or_1130 = (or_1093 & or_1097) | (or_1089 & (or_1093 | or_1097));
  logic or_1134;
  assign or_1134 = (or_1108 & or_1112) | (or_1104 & (or_1108 | or_1112));
  // hls/stages/count_bits.hpp:24
  logic parity_1139;
  assign parity_1139 = ^{or_1134, or_1130, or_1126, or_1122};
  // hls/stages/count_bits.hpp:25
  logic or_1143;
  assign or_1143 = (or_1130 & or_1134) | (or_1126 & (or_1130 | or_1134));
  logic and_1144;
  assign and_1144 = or_1122 & (^{or_1134, or_1130, or_1126});
  // hls/stages/count_bits.hpp:24
  logic xor_1145;
  assign xor_1145 = or_1143 ^ and_1144;
  // hls/stages/count_bits.hpp:27
  logic and_1146;
  assign and_1146 = or_1143 & and_1144;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1147;
  assign select_1147 = equal_538_s1_q ? {and_1146, xor_1145, parity_1139, parity_1118, xor_1073, xor_978} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_536_s1_q ? 6'h0 : select_1147;
  // hls/stages/agreement.hpp:770
  logic [5:0] select_1149;
  assign select_1149 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1150;
  assign difference_1150 = {1'b0, column_3} - {1'b0, select_1149};
  logic [7:0] sum_1152;
  assign sum_1152 = {difference_1150[6], difference_1150} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:218
  logic and_1153;
  assign and_1153 = right_codes_rdata_q[25] & not_544_s1_q;
  logic [11:0] select_1154;
  assign select_1154 = less_543_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1158;
  assign select_1158 = and_663 ? (and_1153 ? (~(select_1154 ^ select_666)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1164;
  assign parity_1164 = ^select_1158[5:3];
  logic parity_1167;
  assign parity_1167 = ^select_1158[8:6];
  logic parity_1170;
  assign parity_1170 = ^select_1158[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1177;
  assign select_1177 = and_686 ? (and_664 ? (~(select_665 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1180;
  assign parity_1180 = ^select_1177[8:6];
  logic parity_1183;
  assign parity_1183 = ^select_1177[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1190;
  assign select_1190 = and_703 ? (and_687 ? (~(select_688 ^ select_706)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1196;
  assign parity_1196 = ^select_1190[2:0];
  logic parity_1199;
  assign parity_1199 = ^select_1190[5:3];
  logic parity_1202;
  assign parity_1202 = ^select_1190[8:0];
  logic parity_1208;
  assign parity_1208 = ^select_1190[11:9];
  logic parity_1211;
  assign parity_1211 = ^select_1177[2:0];
  logic parity_1214;
  assign parity_1214 = ^{select_1190[11:9], select_1177[5:0]};
  logic parity_1217;
  assign parity_1217 = ^{select_1190, select_1177, select_1158[2:0]};
  logic xor_1218;
  assign xor_1218 = parity_1170 ^ parity_1217;
  // hls/stages/count_bits.hpp:23
  logic or_1222;
  assign or_1222 = (select_1158[1:0] == 2'h3) | (select_1158[2] & (select_1158[0] | select_1158[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1226;
  assign or_1226 = (select_1177[7:6] == 2'h3) | (select_1177[8] & (select_1177[6] | select_1177[7]));
  logic or_1230;
  assign or_1230 = (select_1177[10:9] == 2'h3) | (select_1177[11] & (select_1177[9] | select_1177[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1238;
  assign or_1238 = (select_1190[7:6] == 2'h3) | (select_1190[8] & (~(select_1190[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1242;
  assign or_1242 = (select_1190[1:0] == 2'h3) | (select_1190[2] & (select_1190[0] | select_1190[1]));
  logic or_1246;
  assign or_1246 = (select_1190[4:3] == 2'h3) | (select_1190[5] & (select_1190[3] | select_1190[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1249;
  assign parity_1249 = ^{or_1246, or_1242, or_1238};
  // hls/stages/count_bits.hpp:23
  logic or_1253;
  assign or_1253 = (select_1177[4:3] == 2'h3) | (select_1177[5] & (select_1177[3] | select_1177[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1257;
  assign or_1257 = (select_1190[10:9] == 2'h3) | (select_1190[11] & (select_1190[9] | select_1190[10]));
  logic or_1261;
  assign or_1261 = (select_1177[1:0] == 2'h3) | (select_1177[2] & (select_1177[0] | select_1177[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1264;
  assign parity_1264 = ^{or_1261, or_1257, or_1253};
  logic parity_1267;
  assign parity_1267 = ^{or_1261, or_1257, or_1253, or_1246, or_1242, or_1238, or_1230, or_1226, or_1222};
  // hls/stages/count_bits.hpp:25
  logic and_1268;
  assign and_1268 = parity_1170 & parity_1217;
  logic or_1272;
  assign or_1272 = (parity_1164 & parity_1167) | ((^select_1158[11:9]) & (parity_1164 | parity_1167));
  logic and_1275;
  assign and_1275 = (^{select_1177[11:6], select_1158[2:0]}) & (parity_1202 | parity_1214);
  logic or_1276;
  assign or_1276 = (parity_1202 & parity_1214) | and_1275;
  // hls/stages/count_bits.hpp:23
  logic or_1283;
  assign or_1283 = (select_1158[10:9] == 2'h3) | (select_1158[11] & (select_1158[9] | select_1158[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1287;
  assign or_1287 = (select_1158[4:3] == 2'h3) | (select_1158[5] & (select_1158[3] | select_1158[4]));
  logic or_1291;
  assign or_1291 = (select_1158[7:6] == 2'h3) | (select_1158[8] & (select_1158[6] | select_1158[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1294;
  assign parity_1294 = ^{or_1291, or_1287, or_1283};
  // hls/stages/count_bits.hpp:25
  logic or_1298;
  assign or_1298 = (parity_1180 & parity_1183) | ((^select_1158[2:0]) & (parity_1180 | parity_1183));
  logic or_1302;
  assign or_1302 = (parity_1196 & parity_1199) | ((^select_1190[8:6]) & (parity_1196 | parity_1199));
  logic or_1306;
  assign or_1306 = (parity_1208 & parity_1211) | ((^select_1177[5:3]) & (parity_1208 | parity_1211));
  // hls/stages/count_bits.hpp:24
  logic parity_1309;
  assign parity_1309 = ^{or_1306, or_1302, or_1298};
  logic parity_1312;
  assign parity_1312 = ^{or_1306, or_1302, or_1298, or_1291, or_1287, or_1283, or_1276, or_1272, and_1268};
  logic xor_1313;
  assign xor_1313 = parity_1267 ^ parity_1312;
  // hls/stages/count_bits.hpp:25
  logic and_1314;
  assign and_1314 = parity_1267 & parity_1312;
  logic or_1318;
  assign or_1318 = (parity_1249 & parity_1264) | ((^{or_1230, or_1226, or_1222}) & (parity_1249 | parity_1264));
  logic or_1322;
  assign or_1322 = (parity_1294 & parity_1309) | ((^{or_1276, or_1272, and_1268}) & (parity_1294 | parity_1309));
  logic or_1329;
  assign or_1329 = (or_1226 & or_1230) | (or_1222 & (or_1226 | or_1230));
  logic or_1333;
  assign or_1333 = (or_1242 & or_1246) | (or_1238 & (or_1242 | or_1246));
  logic or_1337;
  assign or_1337 = (or_1257 & or_1261) | (or_1253 & (or_1257 | or_1261));
  // hls/stages/count_bits.hpp:24
  logic parity_1340;
  assign parity_1340 = ^{or_1337, or_1333, or_1329};
  // hls/stages/count_bits.hpp:25
  logic or_1344;
  assign or_1344 = (or_1272 & or_1276) | (and_1268 & (or_1272 | or_1276));
  logic or_1348;
  assign or_1348 = (or_1287 & or_1291) | (or_1283 & (or_1287 | or_1291));
  logic or_1352;
  assign or_1352 = (or_1302 & or_1306) | (or_1298 & (or_1302 | or_1306));
  // hls/stages/count_bits.hpp:24
  logic parity_1355;
  assign parity_1355 = ^{or_1352, or_1348, or_1344};
  logic parity_1358;
  assign parity_1358 = ^{or_1352, or_1348, or_1344, or_1337, or_1333, or_1329, or_1322, or_1318, and_1314};
  // hls/stages/count_bits.hpp:25
  logic or_1362;
  assign or_1362 = (parity_1340 & parity_1355) | ((^{or_1322, or_1318, and_1314}) & (parity_1340 | parity_1355));
  logic or_1366;
  assign or_1366 = (or_1318 & or_1322) | (and_1314 & (or_1318 | or_1322));
  logic or_1370;
  assign or_1370 = (or_1333 & or_1337) | (or_1329 & (or_1333 | or_1337));
  logic or_1374;
  assign or_1374 = (or_1348 & or_1352) | (or_1344 & (or_1348 | or_1352));
  // hls/stages/count_bits.hpp:24
  logic parity_1379;
  assign parity_1379 = ^{or_1374, or_1370, or_1366, or_1362};
  // hls/stages/count_bits.hpp:25
  logic or_1383;
  assign or_1383 = (or_1370 & or_1374) | (or_1366 & (or_1370 | or_1374));
  logic and_1384;
  assign and_1384 = or_1362 & (^{or_1374, or_1370, or_1366});
  // hls/stages/count_bits.hpp:24
  logic xor_1385;
  assign xor_1385 = or_1383 ^ and_1384;
  // hls/stages/count_bits.hpp:27
  logic and_1386;
  assign and_1386 = or_1383 & and_1384;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1387;
  assign select_1387 = equal_538_s1_q ? {and_1386, xor_1385, parity_1379, parity_1358, xor_1313, xor_1218} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_536_s1_q ? 6'h0 : select_1387;
  // hls/stages/agreement.hpp:770
  logic [5:0] select_1389;
  assign select_1389 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1390;
  assign difference_1390 = {1'b0, column_4} - {1'b0, select_1389};
  logic [7:0] sum_1392;
  assign sum_1392 = {difference_1390[6], difference_1390} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1400;
  assign select_1400 = and_663 ? (and_704 ? (~(select_705 ^ select_666)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1406;
  assign parity_1406 = ^select_1400[5:3];
  logic parity_1409;
  assign parity_1409 = ^select_1400[8:6];
  logic parity_1412;
  assign parity_1412 = ^select_1400[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1419;
  assign select_1419 = and_686 ? (and_945 ? (~(select_946 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1422;
  assign parity_1422 = ^select_1419[8:6];
  logic parity_1425;
  assign parity_1425 = ^select_1419[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] xor_1431;
  assign xor_1431 = (less_543_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_706;
  logic [11:0] select_1434;
  assign select_1434 = and_703 ? ((right_codes_rdata_q[90] & not_544_s1_q) ? (~xor_1431) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1440;
  assign parity_1440 = ^select_1434[2:0];
  logic parity_1443;
  assign parity_1443 = ^select_1434[5:3];
  logic parity_1446;
  assign parity_1446 = ^select_1434[8:0];
  logic parity_1452;
  assign parity_1452 = ^select_1434[11:9];
  logic parity_1455;
  assign parity_1455 = ^select_1419[2:0];
  logic parity_1458;
  assign parity_1458 = ^{select_1434[11:9], select_1419[5:0]};
  logic parity_1461;
  assign parity_1461 = ^{select_1434, select_1419, select_1400[2:0]};
  logic xor_1462;
  assign xor_1462 = parity_1412 ^ parity_1461;
  // hls/stages/count_bits.hpp:23
  logic or_1466;
  assign or_1466 = (select_1400[1:0] == 2'h3) | (select_1400[2] & (select_1400[0] | select_1400[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1470;
  assign or_1470 = (select_1419[7:6] == 2'h3) | (select_1419[8] & (select_1419[6] | select_1419[7]));
  logic or_1474;
  assign or_1474 = (select_1419[10:9] == 2'h3) | (select_1419[11] & (select_1419[9] | select_1419[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1482;
  assign or_1482 = (select_1434[7:6] == 2'h3) | (select_1434[8] & (~(select_1434[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1486;
  assign or_1486 = (select_1434[1:0] == 2'h3) | (select_1434[2] & (select_1434[0] | select_1434[1]));
  logic or_1490;
  assign or_1490 = (select_1434[4:3] == 2'h3) | (select_1434[5] & (select_1434[3] | select_1434[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1493;
  assign parity_1493 = ^{or_1490, or_1486, or_1482};
  // hls/stages/count_bits.hpp:23
  logic or_1497;
  assign or_1497 = (select_1419[4:3] == 2'h3) | (select_1419[5] & (select_1419[3] | select_1419[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1501;
  assign or_1501 = (select_1434[10:9] == 2'h3) | (select_1434[11] & (select_1434[9] | select_1434[10]));
  logic or_1505;
  assign or_1505 = (select_1419[1:0] == 2'h3) | (select_1419[2] & (select_1419[0] | select_1419[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1508;
  assign parity_1508 = ^{or_1505, or_1501, or_1497};
  logic parity_1511;
  assign parity_1511 = ^{or_1505, or_1501, or_1497, or_1490, or_1486, or_1482, or_1474, or_1470, or_1466};
  // hls/stages/count_bits.hpp:25
  logic and_1512;
  assign and_1512 = parity_1412 & parity_1461;
  logic or_1516;
  assign or_1516 = (parity_1406 & parity_1409) | ((^select_1400[11:9]) & (parity_1406 | parity_1409));
  logic and_1519;
  assign and_1519 = (^{select_1419[11:6], select_1400[2:0]}) & (parity_1446 | parity_1458);
  logic or_1520;
  assign or_1520 = (parity_1446 & parity_1458) | and_1519;
  // hls/stages/count_bits.hpp:23
  logic or_1527;
  assign or_1527 = (select_1400[10:9] == 2'h3) | (select_1400[11] & (select_1400[9] | select_1400[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1531;
  assign or_1531 = (select_1400[4:3] == 2'h3) | (select_1400[5] & (select_1400[3] | select_1400[4]));
  logic or_1535;
  assign or_1535 = (select_1400[7:6] == 2'h3) | (select_1400[8] & (select_1400[6] | select_1400[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1538;
  assign parity_1538 = ^{or_1535, or_1531, or_1527};
  // hls/stages/count_bits.hpp:25
  logic or_1542;
  assign or_1542 = (parity_1422 & parity_1425) | ((^select_1400[2:0]) & (parity_1422 | parity_1425));
  logic or_1546;
  assign or_1546 = (parity_1440 & parity_1443) | ((^select_1434[8:6]) & (parity_1440 | parity_1443));
  logic or_1550;
  assign or_1550 = (parity_1452 & parity_1455) | ((^select_1419[5:3]) & (parity_1452 | parity_1455));
  // hls/stages/count_bits.hpp:24
  logic parity_1553;
  assign parity_1553 = ^{or_1550, or_1546, or_1542};
  logic parity_1556;
  assign parity_1556 = ^{or_1550, or_1546, or_1542, or_1535, or_1531, or_1527, or_1520, or_1516, and_1512};
  logic xor_1557;
  assign xor_1557 = parity_1511 ^ parity_1556;
  // hls/stages/count_bits.hpp:25
  logic and_1558;
  assign and_1558 = parity_1511 & parity_1556;
  logic or_1562;
  assign or_1562 = (parity_1493 & parity_1508) | ((^{or_1474, or_1470, or_1466}) & (parity_1493 | parity_1508));
  logic or_1566;
  assign or_1566 = (parity_1538 & parity_1553) | ((^{or_1520, or_1516, and_1512}) & (parity_1538 | parity_1553));
  logic or_1573;
  assign or_1573 = (or_1470 & or_1474) | (or_1466 & (or_1470 | or_1474));
  logic or_1577;
  assign or_1577 = (or_1486 & or_1490) | (or_1482 & (or_1486 | or_1490));
  logic or_1581;
  assign or_1581 = (or_1501 & or_1505) | (or_1497 & (or_1501 | or_1505));
  // hls/stages/count_bits.hpp:24
  logic parity_1584;
  assign parity_1584 = ^{or_1581, or_1577, or_1573};
  // hls/stages/count_bits.hpp:25
  logic or_1588;
  assign or_1588 = (or_1516 & or_1520) | (and_1512 & (or_1516 | or_1520));
  logic or_1592;
  assign or_1592 = (or_1531 & or_1535) | (or_1527 & (or_1531 | or_1535));
  logic or_1596;
  assign or_1596 = (or_1546 & or_1550) | (or_1542 & (or_1546 | or_1550));
  // hls/stages/count_bits.hpp:24
  logic parity_1599;
  assign parity_1599 = ^{or_1596, or_1592, or_1588};
  logic parity_1602;
  assign parity_1602 = ^{or_1596, or_1592, or_1588, or_1581, or_1577, or_1573, or_1566, or_1562, and_1558};
  // hls/stages/count_bits.hpp:25
  logic or_1606;
  assign or_1606 = (parity_1584 & parity_1599) | ((^{or_1566, or_1562, and_1558}) & (parity_1584 | parity_1599));
  logic or_1610;
  assign or_1610 = (or_1562 & or_1566) | (and_1558 & (or_1562 | or_1566));
  logic or_1614;
  assign or_1614 = (or_1577 & or_1581) | (or_1573 & (or_1577 | or_1581));
  logic or_1618;
  assign or_1618 = (or_1592 & or_1596) | (or_1588 & (or_1592 | or_1596));
  // hls/stages/count_bits.hpp:24
  logic parity_1623;
  assign parity_1623 = ^{or_1618, or_1614, or_1610, or_1606};
  // hls/stages/count_bits.hpp:25
  logic or_1627;
  assign or_1627 = (or_1614 & or_1618) | (or_1610 & (or_1614 | or_1618));
  logic and_1628;
  assign and_1628 = or_1606 & (^{or_1618, or_1614, or_1610});
  // hls/stages/count_bits.hpp:24
  logic xor_1629;
  assign xor_1629 = or_1627 ^ and_1628;
  // hls/stages/count_bits.hpp:27
  logic and_1630;
  assign and_1630 = or_1627 & and_1628;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1631;
  assign select_1631 = equal_538_s1_q ? {and_1630, xor_1629, parity_1623, parity_1602, xor_1557, xor_1462} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_536_s1_q ? 6'h0 : select_1631;
  // hls/stages/agreement.hpp:770
  logic [5:0] select_1633;
  assign select_1633 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1634;
  assign difference_1634 = {1'b0, column_5} - {1'b0, select_1633};
  logic [7:0] sum_1636;
  assign sum_1636 = {difference_1634[6], difference_1634} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:676
  logic [11:0] not_1640;
  assign not_1640 = ~((less_543_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_666);
  logic [11:0] select_1642;
  assign select_1642 = and_663 ? ((right_codes_rdata_q[12] & not_544_s1_q) ? not_1640 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1648;
  assign parity_1648 = ^select_1642[5:3];
  logic parity_1651;
  assign parity_1651 = ^select_1642[8:6];
  logic parity_1654;
  assign parity_1654 = ^select_1642[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1661;
  assign select_1661 = and_686 ? (and_1153 ? (~(select_1154 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1664;
  assign parity_1664 = ^select_1661[8:6];
  logic parity_1667;
  assign parity_1667 = ^select_1661[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1674;
  assign select_1674 = and_703 ? (and_664 ? (~(select_665 ^ select_706)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1680;
  assign parity_1680 = ^select_1674[2:0];
  logic parity_1683;
  assign parity_1683 = ^select_1674[5:3];
  logic parity_1686;
  assign parity_1686 = ^select_1674[8:0];
  logic parity_1692;
  assign parity_1692 = ^select_1674[11:9];
  logic parity_1695;
  assign parity_1695 = ^select_1661[2:0];
  logic parity_1698;
  assign parity_1698 = ^{select_1674[11:9], select_1661[5:0]};
  logic parity_1701;
  assign parity_1701 = ^{select_1674, select_1661, select_1642[2:0]};
  logic xor_1702;
  assign xor_1702 = parity_1654 ^ parity_1701;
  // hls/stages/count_bits.hpp:23
  logic or_1706;
  assign or_1706 = (select_1642[1:0] == 2'h3) | (select_1642[2] & (select_1642[0] | select_1642[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1710;
  assign or_1710 = (select_1661[7:6] == 2'h3) | (select_1661[8] & (select_1661[6] | select_1661[7]));
  logic or_1714;
  assign or_1714 = (select_1661[10:9] == 2'h3) | (select_1661[11] & (select_1661[9] | select_1661[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1722;
  assign or_1722 = (select_1674[7:6] == 2'h3) | (select_1674[8] & (~(select_1674[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1726;
  assign or_1726 = (select_1674[1:0] == 2'h3) | (select_1674[2] & (select_1674[0] | select_1674[1]));
  logic or_1730;
  assign or_1730 = (select_1674[4:3] == 2'h3) | (select_1674[5] & (select_1674[3] | select_1674[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1733;
  assign parity_1733 = ^{or_1730, or_1726, or_1722};
  // hls/stages/count_bits.hpp:23
  logic or_1737;
  assign or_1737 = (select_1661[4:3] == 2'h3) | (select_1661[5] & (select_1661[3] | select_1661[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1741;
  assign or_1741 = (select_1674[10:9] == 2'h3) | (select_1674[11] & (select_1674[9] | select_1674[10]));
  logic or_1745;
  assign or_1745 = (select_1661[1:0] == 2'h3) | (select_1661[2] & (select_1661[0] | select_1661[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1748;
  assign parity_1748 = ^{or_1745, or_1741, or_1737};
  logic parity_1751;
  assign parity_1751 = ^{or_1745, or_1741, or_1737, or_1730, or_1726, or_1722, or_1714, or_1710, or_1706};
  // hls/stages/count_bits.hpp:25
  logic and_1752;
  assign and_1752 = parity_1654 & parity_1701;
  logic or_1756;
  assign or_1756 = (parity_1648 & parity_1651) | ((^select_1642[11:9]) & (parity_1648 | parity_1651));
  logic and_1759;
  assign and_1759 = (^{select_1661[11:6], select_1642[2:0]}) & (parity_1686 | parity_1698);
  logic or_1760;
  assign or_1760 = (parity_1686 & parity_1698) | and_1759;
  // hls/stages/count_bits.hpp:23
  logic or_1767;
  assign or_1767 = (select_1642[10:9] == 2'h3) | (select_1642[11] & (select_1642[9] | select_1642[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1771;
  assign or_1771 = (select_1642[4:3] == 2'h3) | (select_1642[5] & (select_1642[3] | select_1642[4]));
  logic or_1775;
  assign or_1775 = (select_1642[7:6] == 2'h3) | (select_1642[8] & (select_1642[6] | select_1642[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1778;
  assign parity_1778 = ^{or_1775, or_1771, or_1767};
  // hls/stages/count_bits.hpp:25
  logic or_1782;
  assign or_1782 = (parity_1664 & parity_1667) | ((^select_1642[2:0]) & (parity_1664 | parity_1667));
  logic or_1786;
  assign or_1786 = (parity_1680 & parity_1683) | ((^select_1674[8:6]) & (parity_1680 | parity_1683));
  logic or_1790;
  assign or_1790 = (parity_1692 & parity_1695) | ((^select_1661[5:3]) & (parity_1692 | parity_1695));
  // hls/stages/count_bits.hpp:24
  logic parity_1793;
  assign parity_1793 = ^{or_1790, or_1786, or_1782};
  logic parity_1796;
  assign parity_1796 = ^{or_1790, or_1786, or_1782, or_1775, or_1771, or_1767, or_1760, or_1756, and_1752};
  logic xor_1797;
  assign xor_1797 = parity_1751 ^ parity_1796;
  // hls/stages/count_bits.hpp:25
  logic and_1798;
  assign and_1798 = parity_1751 & parity_1796;
  logic or_1802;
  assign or_1802 = (parity_1733 & parity_1748) | ((^{or_1714, or_1710, or_1706}) & (parity_1733 | parity_1748));
  logic or_1806;
  assign or_1806 = (parity_1778 & parity_1793) | ((^{or_1760, or_1756, and_1752}) & (parity_1778 | parity_1793));
  logic or_1813;
  assign or_1813 = (or_1710 & or_1714) | (or_1706 & (or_1710 | or_1714));
  logic or_1817;
  assign or_1817 = (or_1726 & or_1730) | (or_1722 & (or_1726 | or_1730));
  logic or_1821;
  assign or_1821 = (or_1741 & or_1745) | (or_1737 & (or_1741 | or_1745));
  // hls/stages/count_bits.hpp:24
  logic parity_1824;
  assign parity_1824 = ^{or_1821, or_1817, or_1813};
  // hls/stages/count_bits.hpp:25
  logic or_1828;
  assign or_1828 = (or_1756 & or_1760) | (and_1752 & (or_1756 | or_1760));
  logic or_1832;
  assign or_1832 = (or_1771 & or_1775) | (or_1767 & (or_1771 | or_1775));
  logic or_1836;
  assign or_1836 = (or_1786 & or_1790) | (or_1782 & (or_1786 | or_1790));
  // hls/stages/count_bits.hpp:24
  logic parity_1839;
  assign parity_1839 = ^{or_1836, or_1832, or_1828};
  logic parity_1842;
  assign parity_1842 = ^{or_1836, or_1832, or_1828, or_1821, or_1817, or_1813, or_1806, or_1802, and_1798};
  // hls/stages/count_bits.hpp:25
  logic or_1846;
  assign or_1846 = (parity_1824 & parity_1839) | ((^{or_1806, or_1802, and_1798}) & (parity_1824 | parity_1839));
  logic or_1850;
  assign or_1850 = (or_1802 & or_1806) | (and_1798 & (or_1802 | or_1806));
  logic or_1854;
  assign or_1854 = (or_1817 & or_1821) | (or_1813 & (or_1817 | or_1821));
  logic or_1858;
  assign or_1858 = (or_1832 & or_1836) | (or_1828 & (or_1832 | or_1836));
  // hls/stages/count_bits.hpp:24
  logic parity_1863;
  assign parity_1863 = ^{or_1858, or_1854, or_1850, or_1846};
  // hls/stages/count_bits.hpp:25
  logic or_1867;
  assign or_1867 = (or_1854 & or_1858) | (or_1850 & (or_1854 | or_1858));
  logic and_1868;
  assign and_1868 = or_1846 & (^{or_1858, or_1854, or_1850});
  // hls/stages/count_bits.hpp:24
  logic xor_1869;
  assign xor_1869 = or_1867 ^ and_1868;
  // hls/stages/count_bits.hpp:27
  logic and_1870;
  assign and_1870 = or_1867 & and_1868;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1871;
  assign select_1871 = equal_538_s1_q ? {and_1870, xor_1869, parity_1863, parity_1842, xor_1797, xor_1702} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_536_s1_q ? 6'h0 : select_1871;
  // hls/stages/agreement.hpp:770
  logic [5:0] select_1873;
  assign select_1873 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1874;
  assign difference_1874 = {1'b0, column_6} - {1'b0, select_1873};
  logic [7:0] sum_1876;
  assign sum_1876 = {difference_1874[6], difference_1874} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:953
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:954
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:955
  logic [6:0] select_1940;
  assign select_1940 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:988
  logic not_1955;
  assign not_1955 = ~equal_1954_s1_q;
  // hls/stages/agreement.hpp:222
  logic inside_v;
  assign inside_v = or_536_s1_q & not_544_s1_q;
  // hls/stages/agreement.hpp:780
  logic and_1957;
  assign and_1957 = ends_cell_s1_q & inside_v;
  logic and_1959;
  assign and_1959 = not_1955 & (so_s1_q & and_1957);
  logic [6:0] select_1963;
  assign select_1963 = so_s1_q ? x_s1_q[6:0] : (or_536_s1_q ? (less_543_s1_q ? 7'h0 : select_1940) : 7'h0);
  // hls/stages/agreement.hpp:958
  logic and_1971;
  assign and_1971 = (or_536_s1_q & (left_rdata_q[61] & not_544_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:241
  logic or_1985;
  assign or_1985 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/registration.hpp:218
  logic [16:0] select_2095;
  assign select_2095 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2095[16:7])) ? 8'h7f : select_2095[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2170_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2170_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_2258;
  assign less_2258 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_2259;
  assign or_2259 = equal_2169_s1_q | less_2258;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2264;
  assign select_2264 = equal_2169_s1_q ? patches_column_s1_q[0] : (or_2259 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2265;
  assign not_2265 = ~or_2259;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_2266;
  assign sum_2266 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_2269;
  assign select_2269 = or_2259 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2266) + 5'h1) : sum_2266;
  // hls/stages/patches.hpp:500
  logic [4:0] select_2270;
  assign select_2270 = equal_2169_s1_q ? 5'h0 : select_2269;
  logic or_2271;
  assign or_2271 = equal_2169_s1_q | equal_2167_s1_q;
  // hls/stages/patches.hpp:476
  logic equal_2273;
  assign equal_2273 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2275;
  assign equal_2275 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_2277;
  assign and_2277 = of_row & (~equal_2275);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2273 ? 2'h3 : {equal_2275, and_2277};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_2280;
  assign sum_2280 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2281;
  assign sum_2281 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2280, pixel_2[0]} - {1'b0, sum_2281, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_2283;
  assign sum_2283 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2284;
  assign sum_2284 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2283[11], sum_2283};
  logic [13:0] sum_2285;
  assign sum_2285 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2284, down_2[1]};
  logic [12:0] sum_2286;
  assign sum_2286 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2285[13:1];
  logic [14:0] sum_2287;
  assign sum_2287 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2286, sum_2285[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_2290;
  assign sum_2290 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2291;
  assign sum_2291 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2290};
  logic [10:0] sum_2292;
  assign sum_2292 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2291, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2293;
  assign sum_2293 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2292[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_2293, sum_2292[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_2295;
  assign sum_2295 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2296;
  assign sum_2296 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2297;
  assign difference_2297 = {1'b0, sum_2295, smooth[0]} - {1'b0, sum_2296, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_2303;
  assign or_2303 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2275) | equal_2273;
  // hls/stages/patches.hpp:472
  logic and_2308;
  assign and_2308 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2312;
  assign and_2312 = not_2168_s1_q & (or_2171_s1_q & (or_2303 & (equal_2170_s1_q & and_2308)));
  // hls/stages/patches.hpp:172
  logic and_2322;
  assign and_2322 = (~(equal_2170_s1_q | (~and_2308))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2326;
  assign and_2326 = not_2168_s1_q & (or_2171_s1_q & (and_2322 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_2328;
  assign less_2328 = patches_step_q[4:0] < 5'h11;
  logic equal_2329;
  assign equal_2329 = patches_step_q[6:5] == 2'h0;
  logic not_2330;
  assign not_2330 = ~equal_2329;
  logic equal_2331;
  assign equal_2331 = patches_step_q[6:5] == 2'h3;
  logic not_2332;
  assign not_2332 = ~equal_2331;
  // hls/stages/patches.hpp:555
  logic select_2335;
  assign select_2335 = equal_2331 ? (less_2328 & (less_2328 & not_2332)) : less_2328;
  // hls/stages/patches.hpp:184
  logic and_2338;
  assign and_2338 = equal_2165_s1_q & (less_2328 ? (not_2330 & select_2335) : select_2335);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2359;
  assign sum_2359 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:450
  logic [5:0] or_2642;
  assign or_2642 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:454
  logic select_2861;
  assign select_2861 = equal_2767_s1_q ? (~({row_s1_q, 1'b0} < {sum_2858, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:514
  logic and_3081;
  assign and_3081 = and_515_s1_q & (equal_2767_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3082;
  assign and_3082 = and_2768_s1_q & and_3081;
  // hls/stages/registration.hpp:127
  logic and_3084;
  assign and_3084 = and_2768_s1_q & (~and_3081);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3085;
  assign select_3085 = and_3084 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3087;
  assign select_3087 = and_3082 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3085[15]}}, select_3085});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3088;
  assign select_3088 = and_3084 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3088[15]}}, select_3088};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3090;
  assign select_3090 = and_3082 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:147
  logic and_3091;
  assign and_3091 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3091 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3337;
  assign select_3337 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3340;
  assign select_3340 = equal_2167_s1_q ? patches_smooth_values_0_q : (or_2171_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3342;
  assign select_3342 = or_2171_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3344;
  assign select_3344 = equal_2165_s1_q ? patches_smooth_values_1_q : (equal_2167_s1_q ? patches_smooth_values_1_q : select_3342);
  logic [11:0] select_3345;
  assign select_3345 = or_2171_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3347;
  assign select_3347 = equal_2165_s1_q ? patches_smooth_values_2_q : (equal_2167_s1_q ? patches_smooth_values_2_q : select_3345);
  logic [11:0] select_3348;
  assign select_3348 = or_2171_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3350;
  assign select_3350 = equal_2165_s1_q ? patches_smooth_values_3_q : (equal_2167_s1_q ? patches_smooth_values_3_q : select_3348);
  logic [10:0] select_3352;
  assign select_3352 = equal_2167_s1_q ? patches_down_values_0_q : (or_2171_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3355;
  assign select_3355 = equal_2167_s1_q ? patches_down_values_1_q : (or_2171_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3358;
  assign select_3358 = equal_2167_s1_q ? patches_down_values_2_q : (or_2171_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3361;
  assign select_3361 = equal_2167_s1_q ? patches_down_values_3_q : (or_2171_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3398;
  assign and_3398 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_3403;
  assign select_3403 = or_3298_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_3405;
  assign select_3405 = and_3398 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3761;
  assign select_3761 = equal_2165_s1_q ? patches_summed_down_by_q : (equal_2167_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3794;
  assign and_3794 = less_2328 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3797;
  assign select_3797 = equal_2331 ? (less_2328 ? (not_2332 & and_3794) : and_3794) : and_3794;
  // hls/stages/patches.hpp:184
  logic select_3800;
  assign select_3800 = equal_2165_s1_q ? (less_2328 ? (not_2330 & select_3797) : select_3797) : patches_read_searches_q;
  // hls/stages/agreement.hpp:203
  logic [8:0] select_4143;
  assign select_4143 = so_s1_q ? (and_3091 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4145;
  assign sum_4145 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4146;
  assign select_4146 = sum_2359[5] ? {1'b1, sum_2359[4:0], region_across_rest_q[2:0]} : sum_4145;
  // hls/stages/agreement.hpp:454
  logic [8:0] select_4148;
  assign select_4148 = equal_2767_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4151;
  assign select_4151 = equal_2767_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_485_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_490;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:334; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s1_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_515_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1343; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_536_s1_q ? select_1940 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_657_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1344; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_1959;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2270, not_2265, select_2264};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2271;
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
  assign patches_left_codes_re = s1_en & (not_2166_s1_q & (new_row & equal_2167_s1_q));
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
  assign patches_rows_re = s1_en & and_2338;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1371; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_1959;
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
  assign left_we = s1_en & and_547_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_639, left_rdata_q[59:45], and_638, left_rdata_q[43:29], and_637, left_rdata_q[27:13], and_636, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_547_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_648, right_codes_rdata_q[76:65], and_647, right_codes_rdata_q[63:52], and_646, right_codes_rdata_q[50:39], and_645, right_codes_rdata_q[37:26], and_644, right_codes_rdata_q[24:13], and_643, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_2252_s1_q;
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
      row_q <= and_515_s1_q ? (equal_2767_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_515_s1_q ? select_2861 : lower_half_q;
      registration_slope_row_q <= select_3087;
      registration_slope_change_q <= select_3090;
      registration_slope_q <= so_s1_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3322_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3322_s1_q & select_3337;
      patches_smooth_values_0_q <= equal_2165_s1_q ? patches_smooth_values_0_q : select_3340;
      patches_smooth_values_1_q <= select_3344;
      patches_smooth_values_2_q <= select_3347;
      patches_smooth_values_3_q <= select_3350;
      patches_down_values_0_q <= equal_2165_s1_q ? patches_down_values_0_q : select_3352;
      patches_down_values_1_q <= equal_2165_s1_q ? patches_down_values_1_q : select_3355;
      patches_down_values_2_q <= equal_2165_s1_q ? patches_down_values_2_q : select_3358;
      patches_down_values_3_q <= equal_2165_s1_q ? patches_down_values_3_q : select_3361;
      patches_down_by_q <= or_3298_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3398});
      patches_along_q <= select_3403;
      patches_match_row_q <= or_3298_s1_q ? 4'h0 : select_3405;
      patches_summed_last_q <= not_2166_s1_q & (equal_2167_s1_q & and_3398);
      patches_summed_down_by_q <= select_3761;
      patches_step_q <= or_3298_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3800;
      region_across_rest_q <= select_4143;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4146;
      columns_begin_rest_q <= and_515_s1_q ? select_4148 : columns_begin_rest_q;
      columns_begin_back_q <= and_515_s1_q ? select_4151 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= sum_912;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1152;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1392;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1636;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1876;
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
  logic [2:0] select_479_s2_q;
  logic [6:0] select_481_s2_q;
  logic [8:0] select_485_s2_q;
  logic and_489_s2_q;
  logic and_490_s2_q;
  logic equal_495_s2_q;
  logic [6:0] column_s2_q;
  logic and_513_s2_q;
  logic and_515_s2_q;
  logic so_s2_q;
  logic equal_535_s2_q;
  logic or_536_s2_q;
  logic less_543_s2_q;
  logic not_544_s2_q;
  logic equal_576_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic and_1936_s2_q;
  logic [6:0] right_s2_q;
  logic equal_1944_s2_q;
  logic equal_1954_s2_q;
  logic not_1955_s2_q;
  logic inside_v_s2_q;
  logic and_1957_s2_q;
  logic and_1959_s2_q;
  logic [6:0] select_1963_s2_q;
  logic and_1972_s2_q;
  logic or_1985_s2_q;
  logic and_2063_s2_q;
  logic and_2076_s2_q;
  logic less_2090_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2165_s2_q;
  logic equal_2167_s2_q;
  logic equal_2170_s2_q;
  logic or_2171_s2_q;
  logic [4:0] select_2195_s2_q;
  logic select_2201_s2_q;
  logic [3:0] select_2242_s2_q;
  logic less_2258_s2_q;
  logic new_row_s2_q;
  logic or_2271_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_2288_s2_q;
  logic less_2289_s2_q;
  logic less_2298_s2_q;
  logic less_2299_s2_q;
  logic and_2313_s2_q;
  logic and_2322_s2_q;
  logic and_2327_s2_q;
  logic less_2328_s2_q;
  logic equal_2329_s2_q;
  logic not_2330_s2_q;
  logic equal_2331_s2_q;
  logic not_2332_s2_q;
  logic sum_2359_s2_q;
  logic and_2380_s2_q;
  logic and_2497_s2_q;
  logic equal_2643_s2_q;
  logic equal_2767_s2_q;
  logic and_2874_s2_q;
  logic equal_2959_s2_q;
  logic less_3374_s2_q;
  logic equal_3717_s2_q;
  logic equal_3801_s2_q;
  logic less_4131_s2_q;
  logic equal_4349_s2_q;
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
      select_479_s2_q <= select_479_s1_q;
      select_481_s2_q <= select_481_s1_q;
      select_485_s2_q <= select_485_s1_q;
      and_489_s2_q <= and_489_s1_q;
      and_490_s2_q <= and_490;
      equal_495_s2_q <= equal_495_s1_q;
      column_s2_q <= column_s1_q;
      and_513_s2_q <= and_513_s1_q;
      and_515_s2_q <= and_515_s1_q;
      so_s2_q <= so_s1_q;
      equal_535_s2_q <= equal_535_s1_q;
      or_536_s2_q <= or_536_s1_q;
      less_543_s2_q <= less_543_s1_q;
      not_544_s2_q <= not_544_s1_q;
      equal_576_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      and_1936_s2_q <= and_1936_s1_q;
      right_s2_q <= right_s1_q;
      equal_1944_s2_q <= equal_1944_s1_q;
      equal_1954_s2_q <= equal_1954_s1_q;
      not_1955_s2_q <= not_1955;
      inside_v_s2_q <= inside_v;
      and_1957_s2_q <= and_1957;
      and_1959_s2_q <= and_1959;
      select_1963_s2_q <= select_1963;
      and_1972_s2_q <= (or_536_s1_q & (left_rdata_q[62] & not_544_s1_q)) & and_1971;
      or_1985_s2_q <= or_1985;
      and_2063_s2_q <= and_2063_s1_q;
      and_2076_s2_q <= and_2076_s1_q;
      less_2090_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2165_s2_q <= equal_2165_s1_q;
      equal_2167_s2_q <= equal_2167_s1_q;
      equal_2170_s2_q <= equal_2170_s1_q;
      or_2171_s2_q <= or_2171_s1_q;
      select_2195_s2_q <= select_2195_s1_q;
      select_2201_s2_q <= select_2201_s1_q;
      select_2242_s2_q <= select_2242_s1_q;
      less_2258_s2_q <= less_2258;
      new_row_s2_q <= new_row;
      or_2271_s2_q <= or_2271;
      of_row_2_s2_q <= of_row_2;
      less_2288_s2_q <= $signed(15'h100) < $signed(sum_2287);
      less_2289_s2_q <= $signed(sum_2287[14:8]) < $signed(7'h7f);
      less_2298_s2_q <= $signed(15'h100) < $signed(difference_2297);
      less_2299_s2_q <= $signed(difference_2297[14:8]) < $signed(7'h7f);
      and_2313_s2_q <= not_2166_s1_q & and_2312;
      and_2322_s2_q <= and_2322;
      and_2327_s2_q <= not_2166_s1_q & and_2326;
      less_2328_s2_q <= less_2328;
      equal_2329_s2_q <= equal_2329;
      not_2330_s2_q <= not_2330;
      equal_2331_s2_q <= equal_2331;
      not_2332_s2_q <= not_2332;
      sum_2359_s2_q <= sum_2359[5];
      and_2380_s2_q <= or_536_s1_q & (left_rdata_q[63] & not_544_s1_q);
      and_2497_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2643_s2_q <= {column_s1_q[6], or_2642} == 7'h0;
      equal_2767_s2_q <= equal_2767_s1_q;
      and_2874_s2_q <= or_536_s1_q & (not_544_s1_q & and_1971);
      equal_2959_s2_q <= shift == 6'h0;
      less_3374_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3717_s2_q <= patches_match_row_q == 4'h0;
      equal_3801_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4131_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4349_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic shift_allowed_q;
  logic shift_not_right_q;
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
  // hls/stages/census.hpp:112
  logic [11:0] select_493;
  assign select_493 = select_479_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_497;
  assign sum_497 = select_493 + (equal_495_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_499;
  assign sum_499 = {4'h0, sample_pair_pixel_1_q} + (select_479_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_501;
  assign sum_501 = sum_499 + (equal_495_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:411
  logic whole;
  assign whole = select_479_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:122
  logic and_505;
  assign and_505 = whole & (averager_memory_rdata_q[24] | equal_495_s2_q);
  // hls/stages/agreement.hpp:411
  logic all_of_skin;
  assign all_of_skin = select_479_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_509;
  assign and_509 = all_of_skin & (averager_memory_rdata_q[25] | equal_495_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_489_s2_q ? sum_497[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_518;
  assign equal_518 = select_479_s2_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_518 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_521;
  assign select_521 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_489_s2_q ? sum_501[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_518 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_525;
  assign select_525 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_526;
  assign and_526 = and_489_s2_q & and_505;
  // hls/stages/census.hpp:126
  logic select_528;
  assign select_528 = equal_518 ? and_526 : (averager_mask_q & and_526);
  // hls/stages/agreement.hpp:270
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_528;
  // hls/stages/census.hpp:206
  logic and_530;
  assign and_530 = and_489_s2_q & and_509;
  // hls/stages/census.hpp:126
  logic select_532;
  assign select_532 = equal_518 ? and_530 : (averager_of_skin_q & and_530);
  // hls/stages/agreement.hpp:270
  logic and_533;
  assign and_533 = sample_pair_whole_s2_q & select_532;
  // hls/stages/census.hpp:294
  logic less_549;
  assign less_549 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_558;
  assign less_558 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_559;
  assign less_559 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_560;
  assign less_560 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_561;
  assign less_561 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_570;
  assign less_570 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_571;
  assign less_571 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_572;
  assign less_572 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:449
  logic equal_573;
  assign equal_573 = column_s2_q == 7'h0;
  logic [3:0] select_577;
  assign select_577 = equal_576_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:450
  logic [4:0] select_578;
  assign select_578 = equal_573 ? {select_577, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_579;
  assign select_579 = equal_573 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_580;
  assign and_580 = select_578[4] & select_579[3];
  // hls/stages/census.hpp:286
  logic and_582;
  assign and_582 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_584;
  assign and_584 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_582);
  // hls/stages/agreement.hpp:450
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_584;
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
  // hls/stages/census.hpp:270
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, select_521} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_608;
  assign xor_608 = difference_607[8:0] ^ {9{difference_607[9]}};
  logic [9:0] sum_609;
  assign sum_609 = {9'h0, difference_607[9]} + {1'b0, xor_608};
  logic [9:0] difference_610;
  assign difference_610 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_611;
  assign xor_611 = difference_610[8:0] ^ {9{difference_610[9]}};
  logic [9:0] sum_612;
  assign sum_612 = {9'h0, difference_610[9]} + {1'b0, xor_611};
  logic [9:0] difference_614;
  assign difference_614 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_615;
  assign xor_615 = difference_614[8:0] ^ {9{difference_614[9]}};
  logic [9:0] sum_616;
  assign sum_616 = {9'h0, difference_614[9]} + {1'b0, xor_615};
  logic [10:0] sum_617;
  assign sum_617 = ({1'b0, sum_609} + {1'b0, sum_612}) + {1'b0, sum_616};
  logic [9:0] difference_618;
  assign difference_618 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_619;
  assign xor_619 = difference_618[8:0] ^ {9{difference_618[9]}};
  logic [9:0] sum_620;
  assign sum_620 = {9'h0, difference_618[9]} + {1'b0, xor_619};
  logic [9:0] difference_622;
  assign difference_622 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_623;
  assign xor_623 = difference_622[8:0] ^ {9{difference_622[9]}};
  // hls/stages/agreement.hpp:799
  logic or_660;
  assign or_660 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:800
  logic select_662;
  assign select_662 = or_660 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:743
  logic less_1393;
  assign less_1393 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1394;
  assign select_1394 = less_1393 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1395;
  assign less_1395 = middle_sum_sum_sums_values_0_q < select_1394;
  logic [7:0] select_1396;
  assign select_1396 = less_1395 ? select_1394 : middle_sum_sum_sums_values_0_q;
  logic less_1877;
  assign less_1877 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1878;
  assign select_1878 = less_1877 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1879;
  assign less_1879 = select_1396 < select_1878;
  // hls/stages/agreement.hpp:793
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1879 ? select_1878 : select_1396) : 8'h0;
  // hls/stages/agreement.hpp:800
  logic or_1883;
  assign or_1883 = select_662 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:805
  logic [5:0] select_1884;
  assign select_1884 = or_1883 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:744
  logic or_1886;
  assign or_1886 = less_1393 | (~less_1395);
  logic [2:0] select_1887;
  assign select_1887 = less_1879 ? {less_1877, 2'h0} : {1'b0, or_1886, less_1395};
  // hls/stages/agreement.hpp:805
  logic [2:0] select_1888;
  assign select_1888 = or_1883 ? select_1887 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1889;
  assign select_1889 = or_1883 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:802
  logic equal_1890;
  assign equal_1890 = select_1887 == 3'h1;
  logic or_1893;
  assign or_1893 = equal_1890 | (~(select_1887 == 3'h2));
  logic [7:0] select_1895;
  assign select_1895 = or_1893 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1896;
  assign select_1896 = equal_1890 ? (or_1893 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1895;
  // hls/stages/agreement.hpp:805
  logic [7:0] select_1897;
  assign select_1897 = or_1883 ? select_1896 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:802
  logic [7:0] select_1898;
  assign select_1898 = or_1893 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:805
  logic [7:0] select_1900;
  assign select_1900 = or_1883 ? (equal_1890 ? select_1895 : select_1898) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1902;
  assign sum_1902 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1903;
  assign sum_1903 = {1'b0, before_v} + sum_1902;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1906;
  assign sum_1906 = {1'b0, before_v_2} + sum_1905;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1908;
  assign sum_1908 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1909;
  assign sum_1909 = {1'b0, before_v_3} + sum_1908;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1911;
  assign select_1911 = (sum_1906 < sum_1909) ? sum_1909 : sum_1906;
  logic [6:0] select_1913;
  assign select_1913 = (sum_1903 < select_1911) ? select_1911 : sum_1903;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1915;
  assign sum_1915 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1916;
  assign sum_1916 = {1'b0, before_v_4} + sum_1915;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1918;
  assign sum_1918 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1919;
  assign sum_1919 = {1'b0, before_v_5} + sum_1918;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1921;
  assign select_1921 = (sum_1916 < sum_1919) ? sum_1919 : sum_1916;
  // hls/stages/agreement.hpp:794
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1913 < select_1921) ? select_1921 : select_1913) : 7'h0;
  // hls/stages/agreement.hpp:805
  logic less_1925;
  assign less_1925 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:809
  logic [6:0] select_1927;
  assign select_1927 = select_662 ? of_near : (less_1925 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1929;
  assign select_1929 = select_662 ? run_shift_s2_q : (less_1925 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1932;
  assign select_1932 = (run_shift_s2_q == 6'h3f) ? of_best : (select_662 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1935;
  assign select_1935 = (run_shift_s2_q == 6'h1) ? of_best : (select_662 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:815
  logic select_1945;
  assign select_1945 = or_660 ? shift_first_s2_q : equal_1944_s2_q;
  // hls/stages/agreement.hpp:816
  logic or_1947;
  assign or_1947 = select_1945 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:820
  logic [7:0] select_1948;
  assign select_1948 = or_1947 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1949;
  assign select_1949 = or_1947 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1951;
  assign or_1951 = select_1945 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:824
  logic [6:0] select_1952;
  assign select_1952 = or_1951 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1953;
  assign select_1953 = or_1951 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:199
  logic not_1964;
  assign not_1964 = ~so_s2_q;
  // hls/stages/agreement.hpp:961
  logic select_1975;
  assign select_1975 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:962
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:975
  logic [8:0] difference_1978;
  assign difference_1978 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:976
  logic [9:0] sum_1979;
  assign sum_1979 = {difference_1978[8], difference_1978} + 10'h1;
  // hls/stages/agreement.hpp:241
  logic and_1981;
  assign and_1981 = (and_1972_s2_q & select_1975) & ({{22{sum_1979[9]}}, sum_1979} < 32'h3);
  // hls/stages/agreement.hpp:147
  logic and_1988;
  assign and_1988 = or_536_s2_q & (not_544_s2_q & (and_1981 & or_1985_s2_q));
  // hls/stages/agreement.hpp:780
  logic and_1989;
  assign and_1989 = not_1964 & and_1988;
  // hls/stages/agreement.hpp:147
  logic and_1991;
  assign and_1991 = or_536_s2_q & (not_544_s2_q & and_1981);
  // hls/stages/agreement.hpp:780
  logic and_1994;
  assign and_1994 = not_1955_s2_q & (so_s2_q ? and_1957_s2_q : (equal_535_s2_q & and_1991));
  // hls/stages/agreement.hpp:1104
  logic equal_1995;
  assign equal_1995 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1150
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1105
  logic [1:0] select_1998;
  assign select_1998 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1118
  logic [3:0] select_2000;
  assign select_2000 = equal_1995 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1998});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2001;
  assign sum_2001 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_2002;
  assign select_2002 = equal_1954_s2_q ? select_2000 : {sum_2001, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_2003;
  assign equal_2003 = x_s2_q[5:0] == 6'h3f;
  logic equal_2005;
  assign equal_2005 = x_s2_q[5:0] == 6'h3e;
  logic equal_2007;
  assign equal_2007 = x_s2_q[5:0] == 6'h3d;
  logic equal_2009;
  assign equal_2009 = x_s2_q[5:0] == 6'h3c;
  logic equal_2011;
  assign equal_2011 = x_s2_q[5:0] == 6'h3b;
  logic equal_2013;
  assign equal_2013 = x_s2_q[5:0] == 6'h36;
  logic equal_2015;
  assign equal_2015 = x_s2_q[5:0] == 6'h35;
  logic equal_2017;
  assign equal_2017 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1150
  logic and_2021;
  assign and_2021 = (~equal_2011) & ((~equal_2013) & ((~equal_2015) & (~equal_2017)));
  logic and_2025;
  assign and_2025 = (~equal_2003) & ((~equal_2005) & ((~equal_2007) & ((~equal_2009) & and_2021)));
  // hls/stages/agreement.hpp:1105
  logic less_2026;
  assign less_2026 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2030;
  assign or_2030 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:988
  logic [5:0] sum_2035;
  assign sum_2035 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:256
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2035, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2041;
  assign sum_2041 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2043;
  assign and_2043 = half_ends & ({{3{sum_2041[4]}}, sum_2041} < 8'h3);
  // hls/stages/agreement.hpp:780
  logic and_2044;
  assign and_2044 = so_s2_q & and_2043;
  logic select_2045;
  assign select_2045 = equal_1954_s2_q ? (x_s2_q[6] & (equal_1995 ? and_2025 : (less_2026 & (~or_2030)))) : and_2044;
  // hls/stages/registration.hpp:258
  logic not_2047;
  assign not_2047 = ~lower_half_s2_q;
  logic [3:0] select_2048;
  assign select_2048 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2047, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2047};
  // hls/stages/patches.hpp:372
  logic [1:0] select_2077;
  assign select_2077 = and_2076_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2078;
  assign select_2078 = and_2076_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] select_2079;
  assign select_2079 = and_2063_s2_q ? {select_2078, select_2077[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2080;
  assign select_2080 = and_2063_s2_q ? select_2077 : patches_fetch_q;
  logic equal_2081;
  assign equal_2081 = select_2080 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:780
  logic and_2089;
  assign and_2089 = not_1955_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2091;
  assign equal_2091 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:147
  logic [5:0] b;
  assign b = or_536_s2_q ? (less_543_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2091 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2099;
  assign select_2099 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2100;
  assign select_2100 = b[1] ? a : 8'h0;
  logic [8:0] sum_2101;
  assign sum_2101 = {{2{select_2099[6]}}, select_2099} + {select_2100[7], select_2100};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2102;
  assign select_2102 = b[2] ? a : 8'h0;
  logic [7:0] select_2103;
  assign select_2103 = b[3] ? a : 8'h0;
  logic [8:0] sum_2104;
  assign sum_2104 = {{2{select_2102[7]}}, select_2102[7:1]} + {select_2103[7], select_2103};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2105;
  assign sum_2105 = {{3{sum_2101[8]}}, sum_2101[8:1]} + {sum_2104[8], sum_2104, select_2102[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2106;
  assign select_2106 = b[4] ? a : 8'h0;
  logic [7:0] select_2107;
  assign select_2107 = b[5] ? a : 8'h0;
  logic [8:0] difference_2108;
  assign difference_2108 = {{2{select_2106[7]}}, select_2106[7:1]} - {select_2107[7], select_2107};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2109;
  assign sum_2109 = {difference_2108, select_2106[0]} + {sum_2105[10], sum_2105[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2091 ? {sum_2109, sum_2105[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2111;
  assign sum_2111 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:997
  logic and_2113;
  assign and_2113 = and_1991 & ({{4{sum_2111[9]}}, sum_2111, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:104
  logic and_2118;
  assign and_2118 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic equal_2119;
  assign equal_2119 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2125;
  assign sum_2125 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2127;
  assign sum_2127 = {sum_2125[9], sum_2125[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:997
  logic and_2130;
  assign and_2130 = ($signed(9'h0) < $signed(sum_2125[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2127, sum_2125[0]})));
  logic and_2131;
  assign and_2131 = (~(and_2118 | (equal_2119 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2130;
  // hls/stages/agreement.hpp:780
  logic and_2134;
  assign and_2134 = ends_cell_s2_q & (inside_v_s2_q & ((less_2090_s2_q & and_2113) & and_2131));
  logic and_2136;
  assign and_2136 = not_1955_s2_q & (so_s2_q & and_2134);
  // hls/stages/patches.hpp:156
  logic and_2138;
  assign and_2138 = and_2136 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:780
  logic [7:0] select_2141;
  assign select_2141 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2142;
  assign select_2142 = equal_1954_s2_q ? 8'h0 : select_2141;
  logic [5:0] select_2145;
  assign select_2145 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  logic [5:0] select_2146;
  assign select_2146 = equal_1954_s2_q ? 6'h0 : select_2145;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2147;
  assign sum_2147 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2109[9]}}, sum_2109[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2150;
  assign select_2150 = ($signed(sum_2147[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2147[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2091 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2147[12:7])) ? 8'h7f : select_2150);
  // hls/stages/agreement.hpp:780
  logic [7:0] select_2155;
  assign select_2155 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2156;
  assign select_2156 = equal_1954_s2_q ? 8'h0 : select_2155;
  // hls/stages/patches.hpp:342
  logic [22:0] select_2157;
  assign select_2157 = and_2138 ? {select_2156, select_2146, select_2142, and_2136} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:113
  logic equal_2158;
  assign equal_2158 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:780
  logic and_2162;
  assign and_2162 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2118 | equal_2158)));
  logic and_2163;
  assign and_2163 = not_1955_s2_q & and_2162;
  // hls/stages/patches.hpp:343
  logic and_2164;
  assign and_2164 = patches_chooses_s2_q & and_2163;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2178;
  assign select_2178 = and_2063_s2_q ? select_2078 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_2179;
  assign equal_2179 = {patches_choosing_band_s2_q, and_2089} == {select_2178, select_2080[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_2279;
  assign sum_2279 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_2317;
  assign sum_2317 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:203
  logic [7:0] select_2346;
  assign select_2346 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1026
  logic or_2349;
  assign or_2349 = select_2346[7] | (~({select_2346[5], select_2346[3], select_2346[1]} == 3'h0));
  // hls/stages/agreement.hpp:1025
  logic or_2352;
  assign or_2352 = select_2346[7] | (~({select_2346[6], select_2346[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1024
  logic or_2355;
  assign or_2355 = select_2346[7] | (~(select_2346[6:4] == 3'h0));
  // hls/stages/agreement.hpp:780
  logic [5:0] select_2356;
  assign select_2356 = equal_1954_s2_q ? x_s2_q[5:0] : {region_row_q, or_2355, or_2352, or_2349};
  // hls/stages/agreement.hpp:1104
  logic not_2357;
  assign not_2357 = ~equal_1995;
  // hls/stages/agreement.hpp:1034
  logic or_2361;
  assign or_2361 = (~sum_2359_s2_q) | equal_2158;
  // hls/stages/agreement.hpp:780
  logic and_2364;
  assign and_2364 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2361));
  // hls/stages/agreement.hpp:256
  logic textured;
  assign textured = inside_v_s2_q & (or_536_s2_q & (not_544_s2_q & and_1972_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_1991;
  // hls/stages/agreement.hpp:147
  logic and_2382;
  assign and_2382 = or_536_s2_q & (not_544_s2_q & and_2380_s2_q);
  // hls/stages/agreement.hpp:256
  logic and_2391;
  assign and_2391 = inside_v_s2_q & and_2382;
  // hls/stages/agreement.hpp:993
  logic select_2392;
  assign select_2392 = slot_s2_q[2] ? shown_shown_q : and_1991;
  // hls/stages/agreement.hpp:256
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2392);
  // hls/stages/agreement.hpp:993
  logic select_2395;
  assign select_2395 = slot_s2_q[2] ? shown_nearer_q : and_1988;
  // hls/stages/agreement.hpp:256
  logic near;
  assign near = inside_v_s2_q & (select_2392 ? select_2395 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1246
  logic or_2398;
  assign or_2398 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1248
  logic [16:0] select_2400;
  assign select_2400 = marks_first_s2_q ? 17'h1 : (or_2398 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1247
  logic [8:0] select_2402;
  assign select_2402 = or_2398 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1255
  logic select_2404;
  assign select_2404 = cfg_compete_i ? (or_2398 & select_2400[16]) : (select_2402[8] & select_2400[9]);
  // hls/stages/agreement.hpp:429
  logic next_row;
  assign next_row = select_2404 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1262
  logic [6:0] select_2407;
  assign select_2407 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2409;
  assign select_2409 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2407});
  // hls/stages/agreement.hpp:1272
  logic equal_2410;
  assign equal_2410 = seen_x_q == 3'h7;
  logic [7:0] select_2412;
  assign select_2412 = select_2404 ? 8'h0 : (seen_column_q + {7'h0, equal_2410});
  // hls/stages/agreement.hpp:1279
  logic [12:0] index;
  assign index = select_2409 + {5'h0, select_2412};
  // hls/stages/agreement.hpp:1246
  logic select_2415;
  assign select_2415 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1232
  logic [7:0] sum_2416;
  assign sum_2416 = {1'b0, select_2415, 2'h0, select_2415, 1'b0, {2{select_2415}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1245
  logic not_2417;
  assign not_2417 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:429
  logic and_2419;
  assign and_2419 = not_2417 & (began_q | select_2404);
  // hls/stages/agreement.hpp:1273
  logic [2:0] select_2421;
  assign select_2421 = select_2404 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1278
  logic and_2423;
  assign and_2423 = and_2419 & (select_2421 == 3'h0);
  logic less_2424;
  assign less_2424 = select_2412 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1087
  logic [7:0] sum_2427;
  assign sum_2427 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2427[7]}}, sum_2427, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1232
  logic [7:0] sum_2429;
  assign sum_2429 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1009
  logic and_2430;
  assign and_2430 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2431;
  assign and_2431 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2432;
  assign and_2432 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2433;
  assign and_2433 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1063
  logic [1:0] sum_2435;
  assign sum_2435 = {1'b0, and_2432} + ({1'b0, textured} + {1'b0, and_2433});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2430} + ({2'h0, and_2431} + {1'b0, sum_2435});
  // hls/stages/agreement.hpp:1009
  logic [7:0] select_2444;
  assign select_2444 = inside_v_s2_q ? (sum_2359_s2_q ? select_2346 : {select_2346[6:0], 1'b0}) : select_2346;
  // hls/stages/agreement.hpp:1026
  logic or_2447;
  assign or_2447 = select_2444[7] | (~({select_2444[5], select_2444[3], select_2444[1]} == 3'h0));
  // hls/stages/agreement.hpp:1009
  logic and_2464;
  assign and_2464 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2465;
  assign and_2465 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2466;
  assign and_2466 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2467;
  assign and_2467 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1065
  logic [1:0] sum_2469;
  assign sum_2469 = {1'b0, and_2466} + ({1'b0, shown} + {1'b0, and_2467});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2464} + ({2'h0, and_2465} + {1'b0, sum_2469});
  // hls/stages/agreement.hpp:1009
  logic and_2480;
  assign and_2480 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2481;
  assign and_2481 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2482;
  assign and_2482 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2483;
  assign and_2483 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1066
  logic [1:0] sum_2485;
  assign sum_2485 = {1'b0, and_2482} + ({1'b0, near} + {1'b0, and_2483});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2480} + ({2'h0, and_2481} + {1'b0, sum_2485});
  // hls/stages/agreement.hpp:780
  logic and_2501;
  assign and_2501 = ends_cell_s2_q & (and_2497_s2_q & (~({sum_2035, last_s2_q[1:0]} < x_s2_q)));
  logic and_2503;
  assign and_2503 = not_1955_s2_q & (so_s2_q & and_2501);
  // hls/stages/agreement.hpp:270
  logic [10:0] select_2535;
  assign select_2535 = sample_pair_whole_s2_q ? (and_513_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2537;
  assign select_2537 = sample_pair_whole_s2_q ? (and_513_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2556;
  assign select_2556 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2558;
  assign select_2558 = sample_pair_whole_s2_q ? (and_513_s2_q ? select_528 : averager_mask_q) : averager_mask_q;
  logic select_2560;
  assign select_2560 = sample_pair_whole_s2_q ? (and_513_s2_q ? select_532 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:514
  logic [8:0] select_2561;
  assign select_2561 = and_515_s2_q ? select_521 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2562;
  assign select_2562 = and_515_s2_q ? select_525 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2564;
  assign select_2564 = and_515_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2565;
  assign select_2565 = and_515_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2566;
  assign select_2566 = and_515_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2567;
  assign select_2567 = and_515_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2568;
  assign select_2568 = and_515_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2569;
  assign select_2569 = and_515_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2570;
  assign select_2570 = and_515_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2571;
  assign select_2571 = and_515_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2572;
  assign select_2572 = and_515_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2573;
  assign select_2573 = and_515_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2574;
  assign select_2574 = and_515_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2575;
  assign select_2575 = and_515_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2576;
  assign select_2576 = and_515_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2577;
  assign select_2577 = and_515_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2578;
  assign select_2578 = and_515_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2579;
  assign select_2579 = and_515_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2580;
  assign select_2580 = and_515_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2581;
  assign select_2581 = and_515_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2582;
  assign select_2582 = and_515_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2583;
  assign select_2583 = and_515_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2584;
  assign select_2584 = and_515_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2585;
  assign select_2585 = and_515_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2586;
  assign select_2586 = and_515_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2587;
  assign select_2587 = and_515_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2588;
  assign select_2588 = and_515_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2589;
  assign select_2589 = and_515_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2590;
  assign select_2590 = and_515_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2591;
  assign select_2591 = and_515_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2592;
  assign select_2592 = and_515_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2593;
  assign select_2593 = and_515_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2594;
  assign select_2594 = and_515_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2595;
  assign select_2595 = and_515_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2596;
  assign select_2596 = and_515_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2597;
  assign select_2597 = and_515_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2598;
  assign select_2598 = and_515_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2599;
  assign select_2599 = and_515_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2600;
  assign select_2600 = and_515_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2601;
  assign select_2601 = and_515_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2602;
  assign select_2602 = and_515_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2603;
  assign select_2603 = and_515_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2604;
  assign select_2604 = and_515_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2605;
  assign select_2605 = and_515_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2606;
  assign select_2606 = and_515_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2607;
  assign select_2607 = and_515_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2608;
  assign select_2608 = and_515_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2609;
  assign select_2609 = and_515_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2610;
  assign select_2610 = and_515_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2611;
  assign select_2611 = and_515_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2612;
  assign select_2612 = and_515_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2613;
  assign select_2613 = and_515_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2614;
  assign select_2614 = and_515_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2615;
  assign select_2615 = and_515_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2616;
  assign select_2616 = and_515_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2618;
  assign difference_2618 = {1'b0, select_525} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2619;
  assign xor_2619 = difference_2618[8:0] ^ {9{difference_2618[9]}};
  logic [9:0] sum_2620;
  assign sum_2620 = {9'h0, difference_2618[9]} + {1'b0, xor_2619};
  logic [9:0] difference_2621;
  assign difference_2621 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2622;
  assign xor_2622 = difference_2621[8:0] ^ {9{difference_2621[9]}};
  logic [9:0] sum_2623;
  assign sum_2623 = {9'h0, difference_2621[9]} + {1'b0, xor_2622};
  logic [9:0] difference_2625;
  assign difference_2625 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2626;
  assign xor_2626 = difference_2625[8:0] ^ {9{difference_2625[9]}};
  logic [9:0] sum_2627;
  assign sum_2627 = {9'h0, difference_2625[9]} + {1'b0, xor_2626};
  logic [10:0] sum_2628;
  assign sum_2628 = ({1'b0, sum_2620} + {1'b0, sum_2623}) + {1'b0, sum_2627};
  logic [9:0] difference_2629;
  assign difference_2629 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2630;
  assign xor_2630 = difference_2629[8:0] ^ {9{difference_2629[9]}};
  logic [9:0] sum_2631;
  assign sum_2631 = {9'h0, difference_2629[9]} + {1'b0, xor_2630};
  logic [9:0] difference_2633;
  assign difference_2633 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2634;
  assign xor_2634 = difference_2633[8:0] ^ {9{difference_2633[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2664;
  assign difference_2664 = {1'b0, select_521} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2664[9]} + (difference_2664[8:0] ^ {9{difference_2664[9]}});
  logic [9:0] difference_2676;
  assign difference_2676 = {1'b0, select_525} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2676[9]} + (difference_2676[8:0] ^ {9{difference_2676[9]}});
  // hls/stages/agreement.hpp:780
  logic not_2864;
  assign not_2864 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2865;
  assign less_2865 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:514
  logic and_2872;
  assign and_2872 = and_515_s2_q & (equal_576_s2_q & equal_2767_s2_q);
  // hls/stages/agreement.hpp:780
  logic and_2878;
  assign and_2878 = not_1955_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2874_s2_q)));
  // hls/stages/agreement.hpp:1009
  logic and_2898;
  assign and_2898 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2899;
  assign and_2899 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2900;
  assign and_2900 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2901;
  assign and_2901 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1064
  logic [1:0] sum_2903;
  assign sum_2903 = {1'b0, and_2900} + ({1'b0, explained} + {1'b0, and_2901});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2898} + ({2'h0, and_2899} + {1'b0, sum_2903});
  // hls/stages/agreement.hpp:780
  logic and_2939;
  assign and_2939 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2874_s2_q & and_2382)));
  // hls/stages/agreement.hpp:969
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:970
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:971
  logic [7:0] difference_2963;
  assign difference_2963 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2966;
  assign less_2966 = {2'h0, difference_2963[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:147
  logic and_2969;
  assign and_2969 = not_544_s2_q & (((and_2380_s2_q & and_1981) & equal_2959_s2_q) & (~less_2966));
  // hls/stages/agreement.hpp:780
  logic and_2973;
  assign and_2973 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_536_s2_q & and_2969)));
  // hls/stages/registration.hpp:76
  logic less_2977;
  assign less_2977 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_2979;
  assign select_2979 = or_536_s2_q ? (less_543_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2981;
  assign select_2981 = or_536_s2_q ? (less_543_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2983;
  assign select_2983 = or_536_s2_q ? (less_543_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2981} - {1'b0, select_2983};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2985;
  assign select_2985 = rise_2[8] ? select_2981 : select_2983;
  logic [8:0] fall;
  assign fall = {1'b0, select_2979} - {1'b0, select_2985};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2988;
  assign not_2988 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2977 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2988};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2990;
  assign xor_2990 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2990};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2996;
  assign select_2996 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2977 ? {taken, 1'b1} : {not_2988, select_2996, not_2988};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2998;
  assign sum_2998 = {left, 1'b1} + {taken_2, less_2977};
  // hls/stages/agreement.hpp:251
  logic [4:0] select_3000;
  assign select_3000 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3002;
  assign select_3002 = equal_1954_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3004;
  assign select_3004 = equal_1954_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3005;
  assign equal_3005 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:256
  logic and_3009;
  assign and_3009 = and_1991 & less_2090_s2_q;
  // hls/stages/agreement.hpp:147
  logic [2:0] select_3011;
  assign select_3011 = or_536_s2_q ? (less_543_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3015;
  assign sum_3015 = select_3011[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3018;
  assign select_3018 = (select_2981 < select_2983) ? ({sum_3015, select_3011[0], 5'h0} - {3'h0, select_3000}) : {sum_3015, select_3011[0], select_3000};
  logic [7:0] select_3019;
  assign select_3019 = ((select_3011 == 3'h0) | (select_3011 == 3'h4)) ? {sum_3015, select_3011[0], 5'h0} : select_3018;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3019[7]}}, select_3019} - {sum_2109[9], sum_2109, sum_2105[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3022;
  assign select_3022 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3022[11:7])) ? 12'h7f : select_3022;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3043;
  assign difference_3043 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3045;
  assign and_3045 = and_3009 & ($signed(difference_3043) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3058;
  assign less_3058 = $signed(difference_3043) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:780
  logic select_3066;
  assign select_3066 = so_s2_q ? (equal_3005 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3069;
  assign select_3069 = so_s2_q ? (equal_2091 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3074;
  assign select_3074 = (sum_2001 == 2'h2) ? (registration_fresh_q & (~select_2048)) : registration_fresh_q;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_3076;
  assign select_3076 = so_s2_q ? (and_2043 ? select_3074 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3078;
  assign select_3078 = and_2872 ? 4'hf : (equal_1954_s2_q ? registration_fresh_q : select_3076);
  // hls/stages/agreement.hpp:1105
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1998;
  // hls/stages/registration.hpp:258
  logic not_3099;
  assign not_3099 = ~quarter_2[1];
  logic [3:0] select_3100;
  assign select_3100 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3099, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3099};
  // hls/stages/patches.hpp:91
  logic parity_3234;
  assign parity_3234 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:454
  logic [15:0] select_3235;
  assign select_3235 = equal_2767_s2_q ? {patches_chance_q[14:0], parity_3234} : patches_chance_q;
  // hls/stages/patches.hpp:344
  logic not_3237;
  assign not_3237 = ~and_2163;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3240;
  assign select_3240 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3240};
  // hls/stages/agreement.hpp:780
  logic and_3246;
  assign and_3246 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3250;
  assign and_3250 = not_3237 & (patches_fixed_q | ((not_1955_s2_q & and_3246) & and_2138));
  // hls/stages/patches.hpp:353
  logic not_3263;
  assign not_3263 = ~select_2080[1];
  // hls/stages/agreement.hpp:270
  logic [1:0] select_3265;
  assign select_3265 = sample_pair_whole_s2_q ? (equal_2081 ? select_2080 : {not_3263, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3364;
  assign select_3364 = or_2171_s2_q ? {less_2299_s2_q, less_2298_s2_q, less_2289_s2_q, less_2288_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3366;
  assign select_3366 = equal_2165_s2_q ? patches_codes_at_q : (equal_2167_s2_q ? other[55:4] : select_3364);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_2271_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_3369;
  assign select_3369 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3371;
  assign select_3371 = equal_2167_s2_q ? (new_row_s2_q ? word : select_3369) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_3373;
  assign select_3373 = less_2258_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_3375;
  assign select_3375 = less_3374_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3377;
  assign select_3377 = or_2171_s2_q ? (equal_2170_s2_q ? patches_next_codes_q : select_3375) : patches_next_codes_q;
  logic [55:0] select_3379;
  assign select_3379 = equal_2165_s2_q ? patches_next_codes_q : (equal_2167_s2_q ? select_3373 : select_3377);
  // hls/stages/count_bits.hpp:24
  logic parity_3384;
  assign parity_3384 = ^{less_2299_s2_q, less_2298_s2_q, less_2289_s2_q, less_2288_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3388;
  assign or_3388 = ({less_2289_s2_q, less_2288_s2_q} == 2'h3) | (less_2298_s2_q & (less_2289_s2_q | less_2288_s2_q));
  logic and_3389;
  assign and_3389 = less_2299_s2_q & (^{less_2298_s2_q, less_2289_s2_q, less_2288_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3390;
  assign xor_3390 = or_3388 ^ and_3389;
  // hls/stages/count_bits.hpp:27
  logic and_3391;
  assign and_3391 = or_3388 & and_3389;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3393;
  assign select_3393 = or_2171_s2_q ? (and_2322_s2_q ? {and_3391, xor_3390, parity_3384} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3397;
  assign sum_3397 = {7'h0, patches_set_q} + (equal_2170_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_3407;
  assign select_3407 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3409;
  assign select_3409 = equal_2165_s2_q ? patches_left_row_q : (equal_2167_s2_q ? select_3407 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3407;
  // hls/stages/count_bits.hpp:24
  logic xor_3413;
  assign xor_3413 = bits[17] ^ (^{select_3407[16:15], other[16:15]});
  logic xor_3416;
  assign xor_3416 = bits[11] ^ (^{select_3407[10:9], other[10:9]});
  logic xor_3419;
  assign xor_3419 = bits[14] ^ (^{select_3407[13:12], other[13:12]});
  logic xor_3422;
  assign xor_3422 = xor_3413 ^ (^{select_3407[14:9], other[14:9]});
  logic xor_3425;
  assign xor_3425 = bits[47] ^ (^{select_3407[46:45], other[46:45]});
  logic xor_3428;
  assign xor_3428 = bits[8] ^ (^{select_3407[7:6], other[7:6]});
  logic xor_3431;
  assign xor_3431 = bits[2] ^ (^{select_3407[1:0], other[1:0]});
  logic xor_3434;
  assign xor_3434 = bits[5] ^ (^{select_3407[4:3], other[4:3]});
  logic xor_3437;
  assign xor_3437 = xor_3428 ^ (^{select_3407[5:0], other[5:0]});
  logic parity_3439;
  assign parity_3439 = ^{select_3407[47:45], select_3407[8:0], other[47:45], other[8:0]};
  logic xor_3440;
  assign xor_3440 = xor_3422 ^ parity_3439;
  logic xor_3443;
  assign xor_3443 = bits[44] ^ (^{select_3407[43:42], other[43:42]});
  logic xor_3446;
  assign xor_3446 = bits[38] ^ (^{select_3407[37:36], other[37:36]});
  logic xor_3449;
  assign xor_3449 = bits[41] ^ (^{select_3407[40:39], other[40:39]});
  logic xor_3455;
  assign xor_3455 = bits[26] ^ (^{select_3407[25:24], other[25:24]});
  logic xor_3458;
  assign xor_3458 = bits[20] ^ (^{select_3407[19:18], other[19:18]});
  logic xor_3461;
  assign xor_3461 = bits[23] ^ (^{select_3407[22:21], other[22:21]});
  logic xor_3464;
  assign xor_3464 = xor_3455 ^ (^{select_3407[23:18], other[23:18]});
  logic xor_3467;
  assign xor_3467 = bits[35] ^ (^{select_3407[34:33], other[34:33]});
  logic xor_3470;
  assign xor_3470 = bits[29] ^ (^{select_3407[28:27], other[28:27]});
  logic xor_3473;
  assign xor_3473 = bits[32] ^ (^{select_3407[31:30], other[31:30]});
  logic xor_3476;
  assign xor_3476 = xor_3467 ^ (^{select_3407[32:27], other[32:27]});
  logic xor_3477;
  assign xor_3477 = xor_3464 ^ xor_3476;
  // hls/stages/count_bits.hpp:25
  logic or_3485;
  assign or_3485 = (xor_3416 & xor_3419) | (xor_3413 & (xor_3416 | xor_3419));
  logic or_3489;
  assign or_3489 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3493;
  assign or_3493 = (xor_3431 & xor_3434) | (xor_3428 & (xor_3431 | xor_3434));
  // hls/stages/count_bits.hpp:23
  logic or_3500;
  assign or_3500 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3504;
  assign or_3504 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3508;
  assign or_3508 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3511;
  assign parity_3511 = ^{or_3508, or_3504, or_3500};
  // hls/stages/count_bits.hpp:23
  logic or_3515;
  assign or_3515 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3519;
  assign or_3519 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3523;
  assign or_3523 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3526;
  assign parity_3526 = ^{or_3523, or_3519, or_3515};
  logic parity_3529;
  assign parity_3529 = ^{or_3523, or_3519, or_3515, or_3508, or_3504, or_3500, or_3493, or_3489, or_3485};
  // hls/stages/count_bits.hpp:23
  logic or_3533;
  assign or_3533 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3537;
  assign or_3537 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3541;
  assign or_3541 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3549;
  assign or_3549 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3553;
  assign or_3553 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3557;
  assign or_3557 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3560;
  assign parity_3560 = ^{or_3557, or_3553, or_3549};
  // hls/stages/count_bits.hpp:23
  logic or_3564;
  assign or_3564 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3568;
  assign or_3568 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3572;
  assign or_3572 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3575;
  assign parity_3575 = ^{or_3572, or_3568, or_3564};
  logic parity_3578;
  assign parity_3578 = ^{or_3572, or_3568, or_3564, or_3557, or_3553, or_3549, or_3541, or_3537, or_3533};
  // hls/stages/count_bits.hpp:25
  logic or_3582;
  assign or_3582 = (xor_3446 & xor_3449) | (xor_3443 & (xor_3446 | xor_3449));
  logic or_3586;
  assign or_3586 = (xor_3458 & xor_3461) | (xor_3455 & (xor_3458 | xor_3461));
  logic or_3590;
  assign or_3590 = (xor_3470 & xor_3473) | (xor_3467 & (xor_3470 | xor_3473));
  // hls/stages/count_bits.hpp:24
  logic parity_3593;
  assign parity_3593 = ^{or_3590, or_3586, or_3582};
  // hls/stages/count_bits.hpp:25
  logic and_3594;
  assign and_3594 = xor_3440 & (^{xor_3477, select_3407[44:36], other[44:36]});
  logic or_3598;
  assign or_3598 = (xor_3425 & xor_3437) | (xor_3422 & (xor_3425 | xor_3437));
  logic and_3601;
  assign and_3601 = (xor_3443 ^ (^{select_3407[41:36], other[41:36]})) & (xor_3464 | xor_3476);
  logic or_3602;
  assign or_3602 = (xor_3464 & xor_3476) | and_3601;
  // hls/stages/count_bits.hpp:24
  logic parity_3605;
  assign parity_3605 = ^{or_3602, or_3598, and_3594};
  logic parity_3608;
  assign parity_3608 = ^{or_3602, or_3598, and_3594, or_3590, or_3586, or_3582, or_3572, or_3568, or_3564, or_3557, or_3553, or_3549, or_3541, or_3537, or_3533};
  logic parity_3610;
  assign parity_3610 = ^{or_3602, or_3598, and_3594, or_3590, or_3586, or_3582, or_3572, or_3568, or_3564, or_3557, or_3553, or_3549, or_3541, or_3537, or_3533, or_3523, or_3519, or_3515, or_3508, or_3504, or_3500, or_3493, or_3489, or_3485};
  // hls/stages/count_bits.hpp:25
  logic and_3611;
  assign and_3611 = parity_3529 & parity_3608;
  logic or_3615;
  assign or_3615 = (parity_3511 & parity_3526) | ((^{or_3493, or_3489, or_3485}) & (parity_3511 | parity_3526));
  logic or_3619;
  assign or_3619 = (parity_3593 & parity_3605) | (parity_3578 & (parity_3593 | parity_3605));
  logic or_3626;
  assign or_3626 = (parity_3560 & parity_3575) | ((^{or_3541, or_3537, or_3533}) & (parity_3560 | parity_3575));
  logic or_3630;
  assign or_3630 = (or_3586 & or_3590) | (or_3582 & (or_3586 | or_3590));
  logic or_3634;
  assign or_3634 = (or_3598 & or_3602) | (and_3594 & (or_3598 | or_3602));
  // hls/stages/count_bits.hpp:23
  logic or_3641;
  assign or_3641 = (or_3537 & or_3541) | (or_3533 & (or_3537 | or_3541));
  // hls/stages/count_bits.hpp:25
  logic or_3645;
  assign or_3645 = (or_3553 & or_3557) | (or_3549 & (or_3553 | or_3557));
  logic or_3649;
  assign or_3649 = (or_3568 & or_3572) | (or_3564 & (or_3568 | or_3572));
  // hls/stages/count_bits.hpp:24
  logic parity_3652;
  assign parity_3652 = ^{or_3649, or_3645, or_3641};
  // hls/stages/count_bits.hpp:23
  logic or_3656;
  assign or_3656 = (or_3489 & or_3493) | (or_3485 & (or_3489 | or_3493));
  // hls/stages/count_bits.hpp:25
  logic or_3660;
  assign or_3660 = (or_3504 & or_3508) | (or_3500 & (or_3504 | or_3508));
  logic or_3664;
  assign or_3664 = (or_3519 & or_3523) | (or_3515 & (or_3519 | or_3523));
  // hls/stages/count_bits.hpp:24
  logic parity_3667;
  assign parity_3667 = ^{or_3664, or_3660, or_3656};
  logic parity_3670;
  assign parity_3670 = ^{or_3664, or_3660, or_3656, or_3649, or_3645, or_3641, or_3634, or_3630, or_3626};
  logic parity_3672;
  assign parity_3672 = ^{or_3664, or_3660, or_3656, or_3649, or_3645, or_3641, or_3634, or_3630, or_3626, or_3619, or_3615, and_3611};
  // hls/stages/count_bits.hpp:25
  logic or_3676;
  assign or_3676 = (or_3630 & or_3634) | (or_3626 & (or_3630 | or_3634));
  logic or_3680;
  assign or_3680 = (or_3645 & or_3649) | (or_3641 & (or_3645 | or_3649));
  logic or_3684;
  assign or_3684 = (or_3660 & or_3664) | (or_3656 & (or_3660 | or_3664));
  // hls/stages/count_bits.hpp:24
  logic parity_3687;
  assign parity_3687 = ^{or_3684, or_3680, or_3676};
  // hls/stages/count_bits.hpp:25
  logic and_3688;
  assign and_3688 = (^{or_3619, or_3615, and_3611}) & parity_3670;
  logic or_3692;
  assign or_3692 = (or_3615 & or_3619) | (and_3611 & (or_3615 | or_3619));
  logic or_3696;
  assign or_3696 = (parity_3652 & parity_3667) | ((^{or_3634, or_3630, or_3626}) & (parity_3652 | parity_3667));
  // hls/stages/count_bits.hpp:24
  logic parity_3699;
  assign parity_3699 = ^{or_3696, or_3692, and_3688};
  // hls/stages/count_bits.hpp:25
  logic and_3701;
  assign and_3701 = parity_3687 & parity_3699;
  logic or_3705;
  assign or_3705 = (or_3680 & or_3684) | (or_3676 & (or_3680 | or_3684));
  logic or_3709;
  assign or_3709 = (or_3692 & or_3696) | (and_3688 & (or_3692 | or_3696));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3754;
  assign select_3754 = equal_2167_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3757;
  assign select_3757 = equal_2165_s2_q ? patches_summed_first_q : (equal_2167_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3764;
  assign select_3764 = less_2328_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3767;
  assign select_3767 = equal_2331_s2_q ? (less_2328_s2_q ? (equal_2331_s2_q ? 10'h0 : select_3764) : 10'h0) : select_3764;
  logic [9:0] select_3769;
  assign select_3769 = less_2328_s2_q ? (equal_2329_s2_q ? 10'h0 : select_3767) : select_3767;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3771;
  assign select_3771 = less_2328_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3774;
  assign select_3774 = equal_2331_s2_q ? (less_2328_s2_q ? (equal_2331_s2_q ? 5'h0 : select_3771) : 5'h0) : select_3771;
  logic [4:0] select_3776;
  assign select_3776 = less_2328_s2_q ? (equal_2329_s2_q ? 5'h0 : select_3774) : select_3774;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3778;
  assign select_3778 = less_2328_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3781;
  assign select_3781 = equal_2331_s2_q ? (less_2328_s2_q ? (equal_2331_s2_q ? 5'h0 : select_3778) : 5'h0) : select_3778;
  logic [4:0] select_3783;
  assign select_3783 = less_2328_s2_q ? (equal_2329_s2_q ? 5'h0 : select_3781) : select_3781;
  // hls/stages/patches.hpp:551
  logic and_3786;
  assign and_3786 = less_2328_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3789;
  assign select_3789 = equal_2331_s2_q ? (less_2328_s2_q ? (not_2332_s2_q & and_3786) : and_3786) : and_3786;
  // hls/stages/patches.hpp:184
  logic select_3792;
  assign select_3792 = equal_2165_s2_q ? (less_2328_s2_q ? (not_2330_s2_q & select_3789) : select_3789) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3803;
  assign or_3803 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3804;
  assign and_3804 = patches_read_searches_s2_q & or_3803;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3805;
  assign select_3805 = and_3804 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3805};
  // hls/stages/patches.hpp:551
  logic and_3809;
  assign and_3809 = less_2328_s2_q & (equal_3801_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3812;
  assign select_3812 = equal_2331_s2_q ? (less_2328_s2_q ? (not_2332_s2_q & and_3809) : and_3809) : and_3809;
  // hls/stages/patches.hpp:184
  logic select_3815;
  assign select_3815 = equal_2165_s2_q ? (less_2328_s2_q ? (not_2330_s2_q & select_3812) : select_3812) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3818;
  assign and_3818 = less_2328_s2_q & (equal_3801_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3821;
  assign select_3821 = equal_2331_s2_q ? (less_2328_s2_q ? (not_2332_s2_q & and_3818) : and_3818) : and_3818;
  // hls/stages/patches.hpp:184
  logic select_3824;
  assign select_3824 = equal_2165_s2_q ? (less_2328_s2_q ? (not_2330_s2_q & select_3821) : select_3821) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3825;
  assign sum_3825 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3828;
  assign select_3828 = (equal_3801_s2_q & ({sum_3825[6], sum_3825} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3829;
  assign select_3829 = less_2328_s2_q ? select_3828 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3831;
  assign select_3831 = less_2328_s2_q ? (equal_2331_s2_q ? 10'h3ff : select_3829) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3832;
  assign select_3832 = equal_2331_s2_q ? select_3831 : select_3829;
  logic [9:0] select_3834;
  assign select_3834 = less_2328_s2_q ? (equal_2329_s2_q ? 10'h3ff : select_3832) : select_3832;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3836;
  assign select_3836 = and_3804 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3837;
  assign select_3837 = equal_2165_s2_q ? select_3836[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3838;
  assign select_3838 = equal_2165_s2_q ? select_3836[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3840;
  assign select_3840 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3842;
  assign select_3842 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3845;
  assign select_3845 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3846;
  assign select_3846 = patches_read_first_q ? patches_read_far_q : select_3845;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3849;
  assign difference_3849 = select_3846 - select_3836[9:0];
  // hls/stages/patches.hpp:574
  logic less_3879;
  assign less_3879 = select_3840 < select_3842;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3880;
  assign sum_3880 = select_3805[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3879 ? select_3842 : select_3840;
  logic [9:0] low;
  assign low = (select_3842 < select_3840) ? select_3842 : select_3840;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3836[9:0];
  // hls/stages/patches.hpp:578
  logic not_3887;
  assign not_3887 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3888;
  assign sum_3888 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3890;
  assign not_3890 = ~({eight, 3'h0} < {1'b0, sum_3888, fall_2[0]});
  logic [1:0] sum_3891;
  assign sum_3891 = {1'b0, not_3887} + {1'b0, not_3890};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3892;
  assign sum_3892 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3894;
  assign not_3894 = ~({eight, 3'h0} < {sum_3892, fall_2[1:0]});
  logic not_3897;
  assign not_3897 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3898;
  assign sum_3898 = {1'b0, not_3894} + {1'b0, not_3897};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3891} + {1'b0, sum_3898};
  // hls/stages/patches.hpp:581
  logic [7:0] select_3901;
  assign select_3901 = less_3879 ? ({sum_3880, select_3805[2:0], 3'h0} - {5'h0, fraction}) : {sum_3880, select_3805[2:0], fraction};
  // hls/stages/agreement.hpp:1120
  logic equal_4064;
  assign equal_4064 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:780
  logic select_4128;
  assign select_4128 = equal_1954_s2_q ? shown_shown_q : (so_s2_q ? select_2392 : shown_shown_q);
  logic select_4130;
  assign select_4130 = equal_1954_s2_q ? shown_nearer_q : (so_s2_q ? select_2395 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4132;
  assign sum_4132 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:454
  logic [2:0] select_4134;
  assign select_4134 = less_4131_s2_q ? (sum_4132[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4136;
  assign select_4136 = equal_2767_s2_q ? (equal_576_s2_q ? 3'h0 : select_4134) : region_row_q;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_4141;
  assign select_4141 = equal_1954_s2_q ? select_2346 : (so_s2_q ? (ends_cell_s2_q ? select_2444 : select_2346) : 8'h1);
  // hls/stages/agreement.hpp:454
  logic [8:0] select_4155;
  assign select_4155 = equal_576_s2_q ? {{2{difference_4153[6]}}, difference_4153} : (less_4131_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:514
  logic [8:0] select_4157;
  assign select_4157 = and_515_s2_q ? (equal_2767_s2_q ? select_4155 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:454
  logic [6:0] select_4159;
  assign select_4159 = equal_576_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:514
  logic [6:0] select_4161;
  assign select_4161 = and_515_s2_q ? (equal_2767_s2_q ? select_4159 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4162;
  assign sum_4162 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4163;
  assign select_4163 = sum_4132[7] ? {1'b1, sum_4132[6:0], region_down_rest_q[0]} : sum_4162;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4132[7];
  // hls/stages/agreement.hpp:454
  logic select_4167;
  assign select_4167 = equal_2767_s2_q ? (equal_576_s2_q | (less_4131_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:203
  logic or_4172;
  assign or_4172 = segment_starts_q | not_1964;
  // hls/stages/agreement.hpp:1009
  logic select_4175;
  assign select_4175 = inside_v_s2_q ? (sum_2359_s2_q ? (equal_2158 & or_2361) : or_2361) : or_4172;
  // hls/stages/agreement.hpp:780
  logic select_4178;
  assign select_4178 = equal_1954_s2_q ? or_4172 : (so_s2_q ? (ends_cell_s2_q ? select_4175 : or_4172) : or_4172);
  logic select_4337;
  assign select_4337 = so_s2_q ? (ends_cell_s2_q ? and_2432 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4340;
  assign select_4340 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4342;
  assign select_4342 = equal_1954_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4340 : centres_values_0_of_skin_q);
  logic select_4343;
  assign select_4343 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4345;
  assign select_4345 = equal_1954_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4343 : centres_values_1_textured_q);
  logic select_4346;
  assign select_4346 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4348;
  assign select_4348 = equal_1954_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4346 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:454
  logic [12:0] select_4352;
  assign select_4352 = equal_2767_s2_q ? (equal_4349_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:514
  logic [6:0] select_4355;
  assign select_4355 = and_515_s2_q ? (equal_2767_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic [2:0] select_4366;
  assign select_4366 = select_2404 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:429
  logic [7:0] select_4372;
  assign select_4372 = marks_first_s2_q ? (less_4368 ? {sum_4369, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4440;
  assign not_4440 = ~quarter[1];
  logic [3:0] select_4441;
  assign select_4441 = quarter[0] ? {quarter[1], 1'b0, not_4440, 1'b0} : {1'b0, quarter[1], 1'b0, not_4440};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2002;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2045;
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
  assign patches_choices_raddr = select_2079;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2081));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1364; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2356;
  logic regions_re;
  assign regions_re = s2_en & (equal_1954_s2_q ? (x_s2_q[6] & not_2357) : and_2364);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1375; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2416, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2423 & less_2424);
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
  assign averager_memory_waddr = select_485_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_490_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_509, and_505, sum_501, sum_497};
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
  assign census_memory_we = s2_en & and_515_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_533, whole_2, select_525, select_521};
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

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_1936_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_1935, select_1932, select_1929, select_1927, select_1900, select_1897, select_1889, select_1888, select_1884};
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
  assign best_right_we = s2_en & and_1936_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1953, select_1952, select_1949, select_1948};
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
  assign shown_right_waddr = select_1963_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1994;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1989, not_1964};
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

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_2279, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2313_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2299_s2_q, less_2298_s2_q, less_2289_s2_q, less_2288_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2317, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2327_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2299_s2_q, less_2298_s2_q, less_2289_s2_q, less_2288_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1959_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2391, textured};
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
      rows_passed_above_q <= 5'h0;
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2556;
      averager_mask_q <= select_2558;
      averager_of_skin_q <= select_2560;
      census_filled_q <= and_515_s2_q ? {select_579[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_515_s2_q ? select_578 : rows_passed_above_q;
      shift_allowed_q <= not_2864 & (~less_2865);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2998[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3000;
      registration_slope_here_q <= select_3002;
      registration_expected_q <= select_3004;
      registration_of_right_q <= equal_1954_s2_q ? registration_of_right_q : select_3066;
      registration_was_inside_q <= equal_1954_s2_q ? registration_was_inside_q : select_3069;
      registration_fresh_q <= select_3078;
      patches_chance_q <= and_515_s2_q ? select_3235 : patches_chance_q;
      patches_fixed_q <= and_3250;
      patches_choice_valid_q <= and_2163 ? (select_2157[0] & not_3237) : select_2157[0];
      patches_choice_column_q <= select_2157[8:1];
      patches_choice_shift_q <= select_2157[14:9];
      patches_choice_slope_q <= select_2157[22:15];
      patches_band_q <= sample_pair_whole_s2_q ? select_2178 : patches_band_q;
      patches_fetch_q <= select_3265;
      patches_codes_at_q <= select_3366;
      patches_codes_further_q <= equal_2165_s2_q ? patches_codes_further_q : select_3371;
      patches_next_codes_q <= select_3379;
      patches_set_q <= equal_2165_s2_q ? 3'h0 : (equal_2167_s2_q ? 3'h0 : select_3393);
      patches_size_q <= sum_3397;
      patches_left_row_q <= select_3409;
      patches_summed_row_column_q <= equal_2165_s2_q ? patches_summed_row_column_q : select_3754;
      patches_summed_first_q <= select_3757;
      patches_read_row_differing_q <= equal_2165_s2_q ? select_3769 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2165_s2_q ? select_3776 : patches_read_row_column_q;
      patches_read_at_q <= equal_2165_s2_q ? select_3783 : patches_read_at_q;
      patches_read_first_q <= select_3792;
      patches_read_above_q <= select_3815;
      patches_read_below_q <= select_3824;
      patches_read_far_q <= equal_2165_s2_q ? select_3834 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3837;
      patches_peak_best_column_q <= select_3838;
      patches_peak_row_q <= equal_2165_s2_q ? select_3805 : patches_peak_row_q;
      patches_peak_above_q <= equal_2165_s2_q ? select_3840 : patches_peak_above_q;
      patches_peak_below_q <= equal_2165_s2_q ? select_3842 : patches_peak_below_q;
      patches_peak_far_q <= equal_2165_s2_q ? select_3846 : patches_peak_far_q;
      shown_shown_q <= select_4128;
      shown_nearer_q <= select_4130;
      region_row_q <= and_515_s2_q ? select_4136 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4141;
      region_down_rest_q <= select_4157;
      region_down_back_q <= select_4161;
      region_down_next_q <= select_4163;
      region_fresh_q <= and_515_s2_q ? select_4167 : region_fresh_q;
      segment_starts_q <= select_4178;
      centres_values_0_textured_q <= equal_1954_s2_q ? centres_values_0_textured_q : select_4337;
      centres_values_0_of_skin_q <= select_4342;
      centres_values_1_textured_q <= select_4345;
      centres_values_1_of_skin_q <= select_4348;
      map_row_q <= and_515_s2_q ? select_4352 : map_row_q;
      map_width_q <= select_4355;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2415;
      done_q <= not_2417 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_1954_s2_q & equal_4064;
      rows_passed_q <= select_2400;
      columns_passed_q <= {select_2402[7:0], or_2398};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2419;
      seen_x_q <= select_2421;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4366;
      seen_column_q <= select_2412;
      seen_rows_left_q <= select_4372;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2409;
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
      averager_running_0_q <= sample_pair_whole_s2_q ? select_493 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_499 : averager_running_1_q;
      averager_total_0_q <= select_2535;
      averager_total_1_q <= select_2537;
      census_columns_values_0_cell_0_left_q <= select_2561;
      census_columns_values_0_cell_0_right_q <= select_2562;
      census_columns_values_0_cell_0_mask_q <= and_515_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2564;
      census_columns_values_0_cell_1_right_q <= select_2565;
      census_columns_values_0_cell_1_mask_q <= select_2566;
      census_columns_values_0_cell_2_left_q <= select_2567;
      census_columns_values_0_cell_2_right_q <= select_2568;
      census_columns_values_0_cell_2_mask_q <= select_2569;
      census_columns_values_0_cell_2_of_skin_q <= select_2570;
      census_columns_values_0_cell_3_left_q <= select_2571;
      census_columns_values_0_cell_3_right_q <= select_2572;
      census_columns_values_0_cell_3_mask_q <= select_2573;
      census_columns_values_0_cell_4_left_q <= select_2574;
      census_columns_values_0_cell_4_right_q <= select_2575;
      census_columns_values_0_cell_4_mask_q <= select_2576;
      census_columns_values_1_cell_0_left_q <= select_2577;
      census_columns_values_1_cell_0_right_q <= select_2578;
      census_columns_values_1_cell_0_mask_q <= select_2579;
      census_columns_values_1_cell_1_left_q <= select_2580;
      census_columns_values_1_cell_1_right_q <= select_2581;
      census_columns_values_1_cell_1_mask_q <= select_2582;
      census_columns_values_1_cell_2_left_q <= select_2583;
      census_columns_values_1_cell_2_right_q <= select_2584;
      census_columns_values_1_cell_2_mask_q <= select_2585;
      census_columns_values_1_cell_2_of_skin_q <= select_2586;
      census_columns_values_1_cell_3_left_q <= select_2587;
      census_columns_values_1_cell_3_right_q <= select_2588;
      census_columns_values_1_cell_3_mask_q <= select_2589;
      census_columns_values_1_cell_4_left_q <= select_2590;
      census_columns_values_1_cell_4_right_q <= select_2591;
      census_columns_values_1_cell_4_mask_q <= select_2592;
      census_columns_values_2_cell_0_left_q <= select_2593;
      census_columns_values_2_cell_0_right_q <= select_2594;
      census_columns_values_2_cell_0_mask_q <= select_2595;
      census_columns_values_2_cell_1_left_q <= select_2596;
      census_columns_values_2_cell_1_right_q <= select_2597;
      census_columns_values_2_cell_1_mask_q <= select_2598;
      census_columns_values_2_cell_2_left_q <= select_2599;
      census_columns_values_2_cell_2_right_q <= select_2600;
      census_columns_values_2_cell_2_mask_q <= select_2601;
      census_columns_values_2_cell_3_left_q <= select_2602;
      census_columns_values_2_cell_3_right_q <= select_2603;
      census_columns_values_2_cell_3_mask_q <= select_2604;
      census_columns_values_2_cell_4_left_q <= select_2605;
      census_columns_values_2_cell_4_right_q <= select_2606;
      census_columns_values_2_cell_4_mask_q <= select_2607;
      census_columns_values_3_cell_0_mask_q <= select_2608;
      census_columns_values_3_cell_1_left_q <= select_2609;
      census_columns_values_3_cell_1_right_q <= select_2610;
      census_columns_values_3_cell_1_mask_q <= select_2611;
      census_columns_values_3_cell_2_mask_q <= select_2612;
      census_columns_values_3_cell_3_left_q <= select_2613;
      census_columns_values_3_cell_3_right_q <= select_2614;
      census_columns_values_3_cell_3_mask_q <= select_2615;
      census_columns_values_3_cell_4_mask_q <= select_2616;
      sharpness_last_mean_0_q <= and_515_s2_q ? select_521 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_515_s2_q ? select_525 : sharpness_last_mean_1_q;
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
  logic [2:0] region_row_s3_q;
  logic region_fresh_s3_q;
  logic centres_values_1_textured_s3_q;
  logic centres_values_1_of_skin_s3_q;
  logic [2:0] select_479_s3_q;
  logic [6:0] select_481_s3_q;
  logic [6:0] column_s3_q;
  logic and_513_s3_q;
  logic and_515_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_518_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic less_549_s3_q;
  logic less_550_s3_q;
  logic less_551_s3_q;
  logic less_552_s3_q;
  logic less_553_s3_q;
  logic less_554_s3_q;
  logic less_555_s3_q;
  logic less_556_s3_q;
  logic less_557_s3_q;
  logic less_558_s3_q;
  logic less_559_s3_q;
  logic less_560_s3_q;
  logic less_561_s3_q;
  logic less_562_s3_q;
  logic less_563_s3_q;
  logic less_564_s3_q;
  logic less_565_s3_q;
  logic less_566_s3_q;
  logic less_567_s3_q;
  logic less_568_s3_q;
  logic less_569_s3_q;
  logic less_570_s3_q;
  logic less_571_s3_q;
  logic less_572_s3_q;
  logic and_580_s3_q;
  logic and_605_s3_q;
  logic and_606_s3_q;
  logic [11:0] sum_621_s3_q;
  logic [9:0] sum_624_s3_q;
  logic equal_1954_s3_q;
  logic not_1955_s3_q;
  logic equal_1995_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2001_s3_q;
  logic equal_2003_s3_q;
  logic equal_2005_s3_q;
  logic equal_2007_s3_q;
  logic equal_2009_s3_q;
  logic equal_2011_s3_q;
  logic equal_2013_s3_q;
  logic equal_2015_s3_q;
  logic equal_2017_s3_q;
  logic less_2026_s3_q;
  logic or_2030_s3_q;
  logic equal_2050_s3_q;
  logic and_2060_s3_q;
  logic and_2063_s3_q;
  logic select_2080_s3_q;
  logic equal_2081_s3_q;
  logic and_2089_s3_q;
  logic equal_2091_s3_q;
  logic equal_2119_s3_q;
  logic select_2157_s3_q;
  logic and_2164_s3_q;
  logic equal_2165_s3_q;
  logic equal_2167_s3_q;
  logic and_2180_s3_q;
  logic [4:0] select_2195_s3_q;
  logic select_2201_s3_q;
  logic [3:0] select_2242_s3_q;
  logic less_2328_s3_q;
  logic equal_2329_s3_q;
  logic not_2330_s3_q;
  logic equal_2331_s3_q;
  logic or_2349_s3_q;
  logic or_2352_s3_q;
  logic or_2355_s3_q;
  logic not_2357_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2384_s3_q;
  logic and_2389_s3_q;
  logic and_2423_s3_q;
  logic less_2424_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2429_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2447_s3_q;
  logic or_2450_s3_q;
  logic or_2453_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2503_s3_q;
  logic [11:0] sum_2632_s3_q;
  logic [9:0] sum_2635_s3_q;
  logic equal_2643_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2872_s3_q;
  logic and_2878_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2940_s3_q;
  logic and_2974_s3_q;
  logic and_3008_s3_q;
  logic and_3009_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3045_s3_q;
  logic and_3059_s3_q;
  logic equal_3102_s3_q;
  logic parity_3481_s3_q;
  logic parity_3610_s3_q;
  logic parity_3672_s3_q;
  logic xor_3700_s3_q;
  logic parity_3712_s3_q;
  logic or_3716_s3_q;
  logic equal_3717_s3_q;
  logic [4:0] select_3836_s3_q;
  logic equal_3848_s3_q;
  logic less_3850_s3_q;
  logic less_3851_s3_q;
  logic or_3856_s3_q;
  logic [7:0] select_3901_s3_q;
  logic equal_4064_s3_q;
  logic and_4378_s3_q;
  logic not_4393_s3_q;
  logic equal_4443_s3_q;
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
      region_row_s3_q <= region_row_q;
      region_fresh_s3_q <= region_fresh_q;
      centres_values_1_textured_s3_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s3_q <= centres_values_1_of_skin_q;
      select_479_s3_q <= select_479_s2_q;
      select_481_s3_q <= select_481_s2_q;
      column_s3_q <= column_s2_q;
      and_513_s3_q <= and_513_s2_q;
      and_515_s3_q <= and_515_s2_q;
      grey_s3_q <= grey;
      equal_518_s3_q <= equal_518;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      less_549_s3_q <= less_549;
      less_550_s3_q <= less_550;
      less_551_s3_q <= less_551;
      less_552_s3_q <= less_552;
      less_553_s3_q <= less_553;
      less_554_s3_q <= less_554;
      less_555_s3_q <= less_555;
      less_556_s3_q <= less_556;
      less_557_s3_q <= less_557;
      less_558_s3_q <= less_558;
      less_559_s3_q <= less_559;
      less_560_s3_q <= less_560;
      less_561_s3_q <= less_561;
      less_562_s3_q <= less_562;
      less_563_s3_q <= less_563;
      less_564_s3_q <= less_564;
      less_565_s3_q <= less_565;
      less_566_s3_q <= less_566;
      less_567_s3_q <= less_567;
      less_568_s3_q <= less_568;
      less_569_s3_q <= less_569;
      less_570_s3_q <= less_570;
      less_571_s3_q <= less_571;
      less_572_s3_q <= less_572;
      and_580_s3_q <= and_580;
      and_605_s3_q <= whole_22 & and_580;
      and_606_s3_q <= census_columns_values_1_cell_2_mask_q & and_580;
      sum_621_s3_q <= {1'b0, sum_617} + {2'h0, sum_620};
      sum_624_s3_q <= {9'h0, difference_622[9]} + {1'b0, xor_623};
      equal_1954_s3_q <= equal_1954_s2_q;
      not_1955_s3_q <= not_1955_s2_q;
      equal_1995_s3_q <= equal_1995;
      all_s3_q <= all;
      sum_2001_s3_q <= sum_2001;
      equal_2003_s3_q <= equal_2003;
      equal_2005_s3_q <= equal_2005;
      equal_2007_s3_q <= equal_2007;
      equal_2009_s3_q <= equal_2009;
      equal_2011_s3_q <= equal_2011;
      equal_2013_s3_q <= equal_2013;
      equal_2015_s3_q <= equal_2015;
      equal_2017_s3_q <= equal_2017;
      less_2026_s3_q <= less_2026;
      or_2030_s3_q <= or_2030;
      equal_2050_s3_q <= (registration_fresh_q & select_2048) == 4'h0;
      and_2060_s3_q <= not_1955_s2_q & and_2044;
      and_2063_s3_q <= and_2063_s2_q;
      select_2080_s3_q <= select_2080[1];
      equal_2081_s3_q <= equal_2081;
      and_2089_s3_q <= and_2089;
      equal_2091_s3_q <= equal_2091;
      equal_2119_s3_q <= equal_2119;
      select_2157_s3_q <= select_2157[0];
      and_2164_s3_q <= and_2164;
      equal_2165_s3_q <= equal_2165_s2_q;
      equal_2167_s3_q <= equal_2167_s2_q;
      and_2180_s3_q <= and_2164 & equal_2179;
      select_2195_s3_q <= select_2195_s2_q;
      select_2201_s3_q <= select_2201_s2_q;
      select_2242_s3_q <= select_2242_s2_q;
      less_2328_s3_q <= less_2328_s2_q;
      equal_2329_s3_q <= equal_2329_s2_q;
      not_2330_s3_q <= not_2330_s2_q;
      equal_2331_s3_q <= equal_2331_s2_q;
      or_2349_s3_q <= or_2349;
      or_2352_s3_q <= or_2352;
      or_2355_s3_q <= or_2355;
      not_2357_s3_q <= not_2357;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2384_s3_q <= inside_v_s2_q & (and_2382 & and_1988);
      and_2389_s3_q <= not_1955_s2_q & and_2364;
      and_2423_s3_q <= and_2423;
      less_2424_s3_q <= less_2424;
      index_2_s3_q <= index_2[5:0];
      sum_2429_s3_q <= sum_2429;
      textured_2_s3_q <= textured_2;
      or_2447_s3_q <= or_2447;
      or_2450_s3_q <= select_2444[7] | (~({select_2444[6], select_2444[3:2]} == 3'h0));
      or_2453_s3_q <= select_2444[7] | (~(select_2444[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2503_s3_q <= and_2503;
      sum_2632_s3_q <= {1'b0, sum_2628} + {2'h0, sum_2631};
      sum_2635_s3_q <= {9'h0, difference_2633[9]} + {1'b0, xor_2634};
      equal_2643_s3_q <= equal_2643_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2872_s3_q <= and_2872;
      and_2878_s3_q <= and_2878;
      explained_2_s3_q <= explained_2;
      and_2940_s3_q <= not_1955_s2_q & and_2939;
      and_2974_s3_q <= not_1955_s2_q & and_2973;
      and_3008_s3_q <= not_1955_s2_q & (so_s2_q & (half_ends & equal_3005));
      and_3009_s3_q <= and_3009;
      residual_s3_q <= residual[7:0];
      and_3045_s3_q <= and_3045;
      and_3059_s3_q <= and_3009 & less_3058;
      equal_3102_s3_q <= (registration_fresh_q & select_3100) == 4'h0;
      parity_3481_s3_q <= ^{xor_3477, xor_3440, select_3407[44:36], other[44:36]};
      parity_3610_s3_q <= parity_3610;
      parity_3672_s3_q <= parity_3672;
      xor_3700_s3_q <= parity_3687 ^ parity_3699;
      parity_3712_s3_q <= ^{or_3709, or_3705, and_3701};
      or_3716_s3_q <= (or_3705 & or_3709) | (and_3701 & (or_3705 | or_3709));
      equal_3717_s3_q <= equal_3717_s2_q;
      select_3836_s3_q <= select_3836[14:10];
      equal_3848_s3_q <= select_3805[3:0] == 4'h0;
      less_3850_s3_q <= {difference_3849, 3'h0} < {3'h0, sum_3397};
      less_3851_s3_q <= select_3846 < select_3836[9:0];
      or_3856_s3_q <= (sum_3397 < 10'h39) | ({1'b0, sum_3397[9:1]} < select_3836[9:0]);
      select_3901_s3_q <= select_3901;
      equal_4064_s3_q <= equal_4064;
      and_4378_s3_q <= and_2503 & ({sum_2429, index_2[5:0]} == {sum_2416, index[5:0]});
      not_4393_s3_q <= ~proven_q;
      equal_4443_s3_q <= (registration_fresh_q & select_4441) == 4'h0;
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
  logic patches_frame_ended_q;
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
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_621_s3_q + {2'h0, sum_624_s3_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_626;
  assign sum_626 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_628;
  assign sum_628 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_626});
  // hls/stages/census.hpp:303
  logic less_629;
  assign less_629 = 9'h4 < sum_628[13:5];
  logic and_630;
  assign and_630 = and_580_s3_q & less_629;
  // hls/stages/registration.hpp:265
  logic equal_2052;
  assign equal_2052 = sum_2001_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2001_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2054;
  assign select_2054 = equal_2052 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2055;
  assign sum_2055 = (equal_2050_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2054[13]}}, select_2054};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2001_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2058;
  assign select_2058 = equal_2052 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2059;
  assign sum_2059 = (equal_2050_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2058[6]}}, select_2058};
  // hls/stages/patches.hpp:352
  logic [22:0] select_2181;
  assign select_2181 = and_2180_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2157_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2183;
  assign select_2183 = equal_2081_s3_q ? patches_place_0_valid_q : (select_2080_s3_q ? patches_place_0_valid_q : select_2181[0]);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2184;
  assign select_2184 = select_2080_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2181[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2185;
  assign select_2185 = equal_2081_s3_q ? patches_place_0_column_q : select_2184[7:0];
  logic [5:0] select_2186;
  assign select_2186 = equal_2081_s3_q ? patches_place_0_shift_q : select_2184[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2187;
  assign sum_2187 = select_2185 + {{2{select_2186[5]}}, select_2186};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2188;
  assign sum_2188 = sum_2187[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2189;
  assign equal_2189 = {sum_2188[6], select_481_s3_q, select_479_s3_q} == {1'b0, sum_2188[5:0], sum_2187[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2191;
  assign or_2191 = and_2063_s3_q | (select_2183 & equal_2189);
  // hls/stages/agreement.hpp:270
  logic [4:0] select_2192;
  assign select_2192 = or_2191 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2202;
  assign select_2202 = or_2191 ? {and_2063_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2204;
  assign and_2204 = select_2201_s3_q & (~select_2202[5]);
  // hls/stages/patches.hpp:127
  logic select_2212;
  assign select_2212 = equal_2081_s3_q ? patches_place_1_valid_q : (select_2080_s3_q ? select_2181[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2213;
  assign select_2213 = select_2080_s3_q ? select_2181[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2214;
  assign select_2214 = equal_2081_s3_q ? patches_place_1_column_q : select_2213[7:0];
  logic [5:0] select_2215;
  assign select_2215 = equal_2081_s3_q ? patches_place_1_shift_q : select_2213[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2216;
  assign sum_2216 = select_2214 + {{2{select_2215[5]}}, select_2215};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2217;
  assign sum_2217 = sum_2216[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2218;
  assign equal_2218 = {sum_2217[6], select_481_s3_q, select_479_s3_q} == {1'b0, sum_2217[5:0], sum_2216[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2220;
  assign or_2220 = and_2063_s3_q | (select_2212 & equal_2218);
  // hls/stages/agreement.hpp:270
  logic [4:0] select_2221;
  assign select_2221 = or_2220 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2222;
  assign select_2222 = or_2220 ? {and_2063_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2224;
  assign and_2224 = select_2201_s3_q & (~select_2222[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2231;
  assign sum_2231 = select_2185 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2232;
  assign equal_2232 = {sum_2231[7], select_481_s3_q, select_479_s3_q} == {1'b0, sum_2231[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2234;
  assign or_2234 = and_2063_s3_q | (select_2183 & equal_2232);
  logic [4:0] select_2235;
  assign select_2235 = or_2234 ? {and_2063_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2236;
  assign sum_2236 = select_2214 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2237;
  assign equal_2237 = {sum_2236[7], select_481_s3_q, select_479_s3_q} == {1'b0, sum_2236[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2240;
  assign select_2240 = (and_2063_s3_q | (select_2212 & equal_2237)) ? {and_2063_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_7;
  assign column_7 = select_2235[4] ? select_2240[3:0] : select_2235[3:0];
  // hls/stages/agreement.hpp:270
  logic select_2243;
  assign select_2243 = or_2234 ? and_2063_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2249;
  assign and_2249 = (select_2201_s3_q & (select_2195_s3_q[3] ^ select_2195_s3_q[4])) & ((~select_2235[4]) | (~select_2240[4]));
  // hls/stages/patches.hpp:184
  logic less_2340;
  assign less_2340 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2341;
  assign not_2341 = ~less_2340;
  logic [1:0] select_2342;
  assign select_2342 = patches_summed_first_s3_q ? 2'h2 : {less_2340, not_2341};
  logic [12:0] select_2343;
  assign select_2343 = select_2342[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2344;
  assign select_2344 = select_2342[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2345;
  assign select_2345 = select_2342[1] ? {select_2343[12:8], patches_sums_values_0_q[9:8], select_2343[7:0]} : select_2344;
  // hls/stages/agreement.hpp:890
  logic [6:0] select_2370;
  assign select_2370 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:891
  logic [6:0] sum_2371;
  assign sum_2371 = {6'h0, textured_s3_q} + select_2370;
  // hls/stages/agreement.hpp:1037
  logic [9:0] sum_2373;
  assign sum_2373 = {3'h0, sum_2371} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:890
  logic [6:0] select_2375;
  assign select_2375 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:891
  logic [6:0] sum_2376;
  assign sum_2376 = {6'h0, explained_s3_q} + select_2375;
  // hls/stages/agreement.hpp:1038
  logic [9:0] sum_2378;
  assign sum_2378 = {3'h0, sum_2376} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:890
  logic [6:0] select_2385;
  assign select_2385 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:892
  logic [6:0] sum_2386;
  assign sum_2386 = {6'h0, and_2384_s3_q} + select_2385;
  // hls/stages/agreement.hpp:1039
  logic [9:0] sum_2388;
  assign sum_2388 = {3'h0, sum_2386} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1070
  logic [2:0] select_2438;
  assign select_2438 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2439;
  assign difference_2439 = {1'b0, textured_2_s3_q} - {1'b0, select_2438};
  logic [4:0] t;
  assign t = {difference_2439[3], difference_2439} + (equal_2119_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1076
  logic equal_2442;
  assign equal_2442 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1077
  logic not_2454;
  assign not_2454 = ~region_row_s3_q[2];
  logic [2:0] select_2455;
  assign select_2455 = region_row_s3_q[1] ? {1'b0, not_2454, 1'b0} : {region_row_s3_q[2], 1'b0, not_2454};
  logic [5:0] select_2456;
  assign select_2456 = region_row_s3_q[0] ? {select_2455[2], 1'b0, select_2455[1], 1'b0, select_2455[0], 1'b0} : {1'b0, select_2455[2], 1'b0, select_2455[1], 1'b0, select_2455[0]};
  logic [11:0] select_2457;
  assign select_2457 = or_2453_s3_q ? {select_2456[5], 1'b0, select_2456[4], 1'b0, select_2456[3], 1'b0, select_2456[2], 1'b0, select_2456[1], 1'b0, select_2456[0], 1'b0} : {1'b0, select_2456[5], 1'b0, select_2456[4], 1'b0, select_2456[3], 1'b0, select_2456[2], 1'b0, select_2456[1], 1'b0, select_2456[0]};
  logic [23:0] select_2458;
  assign select_2458 = or_2450_s3_q ? {select_2457[11], 1'b0, select_2457[10], 1'b0, select_2457[9], 1'b0, select_2457[8], 1'b0, select_2457[7], 1'b0, select_2457[6], 1'b0, select_2457[5], 1'b0, select_2457[4], 1'b0, select_2457[3], 1'b0, select_2457[2], 1'b0, select_2457[1], 1'b0, select_2457[0], 1'b0} : {1'b0, select_2457[11], 1'b0, select_2457[10], 1'b0, select_2457[9], 1'b0, select_2457[8], 1'b0, select_2457[7], 1'b0, select_2457[6], 1'b0, select_2457[5], 1'b0, select_2457[4], 1'b0, select_2457[3], 1'b0, select_2457[2], 1'b0, select_2457[1], 1'b0, select_2457[0]};
  logic [47:0] select_2459;
  assign select_2459 = or_2447_s3_q ? {select_2458[23], 1'b0, select_2458[22], 1'b0, select_2458[21], 1'b0, select_2458[20], 1'b0, select_2458[19], 1'b0, select_2458[18], 1'b0, select_2458[17], 1'b0, select_2458[16], 1'b0, select_2458[15], 1'b0, select_2458[14], 1'b0, select_2458[13], 1'b0, select_2458[12], 1'b0, select_2458[11], 1'b0, select_2458[10], 1'b0, select_2458[9], 1'b0, select_2458[8], 1'b0, select_2458[7], 1'b0, select_2458[6], 1'b0, select_2458[5], 1'b0, select_2458[4], 1'b0, select_2458[3], 1'b0, select_2458[2], 1'b0, select_2458[1], 1'b0, select_2458[0], 1'b0} : {1'b0, select_2458[23], 1'b0, select_2458[22], 1'b0, select_2458[21], 1'b0, select_2458[20], 1'b0, select_2458[19], 1'b0, select_2458[18], 1'b0, select_2458[17], 1'b0, select_2458[16], 1'b0, select_2458[15], 1'b0, select_2458[14], 1'b0, select_2458[13], 1'b0, select_2458[12], 1'b0, select_2458[11], 1'b0, select_2458[10], 1'b0, select_2458[9], 1'b0, select_2458[8], 1'b0, select_2458[7], 1'b0, select_2458[6], 1'b0, select_2458[5], 1'b0, select_2458[4], 1'b0, select_2458[3], 1'b0, select_2458[2], 1'b0, select_2458[1], 1'b0, select_2458[0]};
  // hls/stages/agreement.hpp:1009
  logic and_2463;
  assign and_2463 = good_known_q & (~((good_q & select_2459) == 48'h0));
  // hls/stages/agreement.hpp:1072
  logic [2:0] select_2472;
  assign select_2472 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2473;
  assign difference_2473 = {1'b0, shown_2_s3_q} - {1'b0, select_2472};
  logic [4:0] around;
  assign around = {difference_2473[3], difference_2473} + (equal_2119_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1079
  logic [5:0] sum_2476;
  assign sum_2476 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2442 ? and_2463 : (~({sum_2476, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1073
  logic [2:0] select_2488;
  assign select_2488 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2489;
  assign difference_2489 = {1'b0, near_2_s3_q} - {1'b0, select_2488};
  logic [4:0] n;
  assign n = {difference_2489[3], difference_2489} + (equal_2119_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1088
  logic and_2493;
  assign and_2493 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_2527;
  assign select_2527 = sample_pair_whole_s3_q ? (and_513_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2529;
  assign select_2529 = sample_pair_whole_s3_q ? (and_513_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2531;
  assign select_2531 = sample_pair_whole_s3_q ? (and_513_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2533;
  assign select_2533 = sample_pair_whole_s3_q ? (and_513_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2538;
  assign sum_2538 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2539;
  assign difference_2539 = {1'b0, sum_2538[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2540;
  assign xor_2540 = {difference_2539[8:0], sum_2538[0]} ^ {10{difference_2539[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2539[9]} + {1'b0, xor_2540};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_518_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2545;
  assign select_2545 = sample_pair_whole_s3_q ? (and_513_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2546;
  assign sum_2546 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2547;
  assign difference_2547 = {1'b0, sum_2546[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2548;
  assign xor_2548 = {difference_2547[8:0], sum_2546[0]} ^ {10{difference_2547[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2547[9]} + {1'b0, xor_2548};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_518_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2553;
  assign select_2553 = sample_pair_whole_s3_q ? (and_513_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2636;
  assign sum_2636 = sum_2632_s3_q + {2'h0, sum_2635_s3_q};
  // hls/stages/agreement.hpp:514
  logic [11:0] select_2638;
  assign select_2638 = and_515_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2639;
  assign select_2639 = and_515_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2640;
  assign select_2640 = and_515_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2641;
  assign select_2641 = and_515_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2644;
  assign sum_2644 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2636};
  logic [13:0] sum_2646;
  assign sum_2646 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2644});
  // hls/stages/census.hpp:305
  logic and_2648;
  assign and_2648 = and_605_s3_q & (9'h4 < sum_2646[13:5]);
  // hls/stages/census.hpp:306
  logic and_2649;
  assign and_2649 = and_605_s3_q & less_629;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2650;
  assign sum_2650 = census_left_misses_q + {{17{and_2649}}, and_2648, 1'b0, and_2648};
  // hls/stages/agreement.hpp:514
  logic [19:0] select_2652;
  assign select_2652 = and_515_s3_q ? (equal_2643_s3_q ? 20'h0 : sum_2650) : census_left_misses_q;
  // hls/stages/agreement.hpp:270
  logic [27:0] select_2657;
  assign select_2657 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:514
  logic select_2660;
  assign select_2660 = and_515_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2663;
  assign and_2663 = whole_2_s3_q & (~(column_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:451
  logic and_2669;
  assign and_2669 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2670;
  assign and_2670 = and_2663 & and_2669;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2657[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2672;
  assign select_2672 = and_2670 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2674;
  assign select_2674 = equal_2643_s3_q ? {11'h0, select_2672} : (sharpness_sums_detail_0_q + {11'h0, select_2672});
  // hls/stages/agreement.hpp:451
  logic and_2681;
  assign and_2681 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2682;
  assign and_2682 = and_2663 & and_2681;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2657[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2684;
  assign select_2684 = and_2682 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2686;
  assign select_2686 = equal_2643_s3_q ? {11'h0, select_2684} : (sharpness_sums_detail_1_q + {11'h0, select_2684});
  logic [8:0] select_2689;
  assign select_2689 = and_2670 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2690;
  assign sum_2690 = (equal_2643_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2689};
  logic [8:0] select_2693;
  assign select_2693 = and_2682 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2694;
  assign sum_2694 = (equal_2643_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2693};
  // hls/stages/agreement.hpp:209
  logic equal_2696;
  assign equal_2696 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2697;
  assign less_2697 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2698;
  assign less_2698 = x_s3_q[4:0] < 5'h3;
  logic not_2699;
  assign not_2699 = ~x_s3_q[1];
  logic [2:0] select_2700;
  assign select_2700 = x_s3_q[0] ? {1'b0, not_2699, 1'b0} : {x_s3_q[1], 1'b0, not_2699};
  logic [5:0] select_2701;
  assign select_2701 = slot_s3_q[2] ? {select_2700[2], 1'b0, select_2700[1], 1'b0, select_2700[0], 1'b0} : {1'b0, select_2700[2], 1'b0, select_2700[1], 1'b0, select_2700[0]};
  logic [11:0] select_2702;
  assign select_2702 = slot_s3_q[1] ? {select_2701[5], 1'b0, select_2701[4], 1'b0, select_2701[3], 1'b0, select_2701[2], 1'b0, select_2701[1], 1'b0, select_2701[0], 1'b0} : {1'b0, select_2701[5], 1'b0, select_2701[4], 1'b0, select_2701[3], 1'b0, select_2701[2], 1'b0, select_2701[1], 1'b0, select_2701[0]};
  logic [23:0] select_2703;
  assign select_2703 = slot_s3_q[0] ? {select_2702[11], 1'b0, select_2702[10], 1'b0, select_2702[9], 1'b0, select_2702[8], 1'b0, select_2702[7], 1'b0, select_2702[6], 1'b0, select_2702[5], 1'b0, select_2702[4], 1'b0, select_2702[3], 1'b0, select_2702[2], 1'b0, select_2702[1], 1'b0, select_2702[0], 1'b0} : {1'b0, select_2702[11], 1'b0, select_2702[10], 1'b0, select_2702[9], 1'b0, select_2702[8], 1'b0, select_2702[7], 1'b0, select_2702[6], 1'b0, select_2702[5], 1'b0, select_2702[4], 1'b0, select_2702[3], 1'b0, select_2702[2], 1'b0, select_2702[1], 1'b0, select_2702[0]};
  // hls/stages/census.hpp:372
  logic and_2707;
  assign and_2707 = less_2698 & (~((sharpness_sums_contrast_1_q & select_2703) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2709;
  assign select_2709 = (less_2697 & and_2707) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2709};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2712;
  assign select_2712 = equal_2696 ? (less_2697 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2717;
  assign and_2717 = less_2698 & (~((sharpness_sums_contrast_0_q & select_2703) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2719;
  assign select_2719 = (less_2697 & and_2717) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2719};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2722;
  assign select_2722 = equal_2696 ? (less_2697 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2724;
  assign select_2724 = equal_2696 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2726;
  assign select_2726 = equal_2696 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2728;
  assign select_2728 = equal_2696 ? {sharpness_comparing_contrast_0_q[0], and_2717} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2730;
  assign select_2730 = equal_2696 ? {sharpness_comparing_contrast_1_q[0], and_2707} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:213
  logic select_2735;
  assign select_2735 = drew_q ? (equal_2696 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:213
  logic select_2739;
  assign select_2739 = drew_q ? (equal_2696 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2740;
  assign equal_2740 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2741;
  assign xor_2741 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2744;
  assign select_2744 = (equal_2740 | xor_2741) ? (five_times[0] & xor_2741) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2746;
  assign select_2746 = drew_q ? (equal_2696 ? select_2744 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2747;
  assign xor_2747 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2750;
  assign select_2750 = (equal_2740 | xor_2747) ? (five_times_2[0] & xor_2747) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2752;
  assign select_2752 = drew_q ? (equal_2696 ? select_2750 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2753;
  assign xor_2753 = sharpness_comparing_contrast_0_q[1] ^ and_2707;
  logic select_2756;
  assign select_2756 = (equal_2740 | xor_2753) ? (and_2707 & xor_2753) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2758;
  assign select_2758 = drew_q ? (equal_2696 ? select_2756 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2759;
  assign xor_2759 = sharpness_comparing_contrast_1_q[1] ^ and_2717;
  logic select_2762;
  assign select_2762 = (equal_2740 | xor_2759) ? (and_2717 & xor_2759) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2764;
  assign select_2764 = drew_q ? (equal_2696 ? select_2762 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2880;
  assign select_2880 = and_2872_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2878_s3_q});
  // hls/stages/agreement.hpp:780
  logic and_2883;
  assign and_2883 = not_1955_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2888;
  assign and_2888 = not_1955_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2893;
  assign and_2893 = not_1955_s3_q & (drew_q & (ends_cell_s3_q & and_2384_s3_q));
  // hls/stages/agreement.hpp:1081
  logic not_2897;
  assign not_2897 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1071
  logic [2:0] select_2906;
  assign select_2906 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2907;
  assign difference_2907 = {1'b0, explained_2_s3_q} - {1'b0, select_2906};
  logic [4:0] e;
  assign e = {difference_2907[3], difference_2907} + (equal_2119_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1078
  logic [5:0] sum_2910;
  assign sum_2910 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1082
  logic not_2914;
  assign not_2914 = ~(equal_2442 ? and_2463 : (~({sum_2910, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:780
  logic and_2917;
  assign and_2917 = ends_cell_s3_q & (not_2897 & (centres_values_1_textured_s3_q & not_2914));
  logic and_2919;
  assign and_2919 = not_1955_s3_q & (drew_q & and_2917);
  // hls/stages/agreement.hpp:1108
  logic less_2922;
  assign less_2922 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2923;
  assign select_2923 = less_2922 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2926;
  assign select_2926 = less_2922 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1109
  logic [10:0] sum_2927;
  assign sum_2927 = {1'b0, select_2926} + {3'h0, select_2926[9:2]};
  logic and_2929;
  assign and_2929 = (~(select_2923[9:4] == 6'h0)) & ({sum_2927, select_2926[1:0]} < {3'h0, select_2923});
  // hls/stages/agreement.hpp:1118
  logic [9:0] select_2932;
  assign select_2932 = x_s3_q[6] ? (equal_1995_s3_q ? 10'h0 : (and_2929 ? select_2923 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:780
  logic [9:0] select_2933;
  assign select_2933 = equal_1954_s3_q ? select_2932 : 10'h0;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2935;
  assign select_2935 = and_2872_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2933});
  logic [13:0] select_2942;
  assign select_2942 = and_2872_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2940_s3_q});
  // hls/stages/agreement.hpp:1086
  logic and_2944;
  assign and_2944 = not_2897 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:780
  logic and_2947;
  assign and_2947 = not_1955_s3_q & (drew_q & (ends_cell_s3_q & and_2944));
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2949;
  assign select_2949 = and_2872_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2947});
  // hls/stages/agreement.hpp:1086
  logic and_2951;
  assign and_2951 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2914);
  // hls/stages/agreement.hpp:780
  logic and_2955;
  assign and_2955 = not_1955_s3_q & (drew_q & (ends_cell_s3_q & (not_2897 & and_2951)));
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2957;
  assign select_2957 = and_2872_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2955});
  logic [13:0] select_2976;
  assign select_2976 = and_2872_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2974_s3_q});
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3027;
  assign select_3027 = drew_q ? (equal_2091_s3_q ? (and_3009_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3028;
  assign select_3028 = equal_1954_s3_q ? 8'h0 : select_3027;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3030;
  assign select_3030 = and_3008_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3028[7]}}, select_3028});
  // hls/stages/agreement.hpp:780
  logic and_3033;
  assign and_3033 = not_1955_s3_q & (drew_q & (and_3009_s3_q & equal_2091_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3035;
  assign select_3035 = and_3008_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3033});
  // hls/stages/registration.hpp:107
  logic and_3037;
  assign and_3037 = and_3009_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:780
  logic [1:0] select_3039;
  assign select_3039 = drew_q ? (equal_2091_s3_q ? {and_3037, and_3009_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3040;
  assign select_3040 = equal_1954_s3_q ? 2'h0 : select_3039;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3041;
  assign sum_3041 = registration_half_votes_down_q + {{5{select_3040[1]}}, select_3040};
  // hls/stages/agreement.hpp:780
  logic [1:0] select_3047;
  assign select_3047 = drew_q ? (equal_2091_s3_q ? {and_3045_s3_q, and_3009_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3048;
  assign select_3048 = equal_1954_s3_q ? 2'h0 : select_3047;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3049;
  assign sum_3049 = registration_half_votes_up_q + {{5{select_3048[1]}}, select_3048};
  // hls/stages/registration.hpp:107
  logic and_3052;
  assign and_3052 = and_3009_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:780
  logic [1:0] select_3054;
  assign select_3054 = drew_q ? (equal_2091_s3_q ? {and_3052, and_3009_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3055;
  assign select_3055 = equal_1954_s3_q ? 2'h0 : select_3054;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3056;
  assign sum_3056 = registration_half_half_votes_down_q + {{5{select_3055[1]}}, select_3055};
  // hls/stages/agreement.hpp:780
  logic [1:0] select_3061;
  assign select_3061 = drew_q ? (equal_2091_s3_q ? {and_3059_s3_q, and_3009_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3062;
  assign select_3062 = equal_1954_s3_q ? 2'h0 : select_3061;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3063;
  assign sum_3063 = registration_half_half_votes_up_q + {{5{select_3062[1]}}, select_3062};
  // hls/stages/agreement.hpp:780
  logic and_3097;
  assign and_3097 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & less_2026_s3_q));
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_3104;
  assign select_3104 = or_2030_s3_q ? 12'h0 : (equal_3102_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_3107;
  assign select_3107 = x_s3_q[6] ? (equal_1995_s3_q ? 12'h0 : (less_2026_s3_q ? select_3104 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:780
  logic [11:0] select_3108;
  assign select_3108 = equal_1954_s3_q ? select_3107 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3109;
  assign and_3109 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1118
  logic and_3112;
  assign and_3112 = not_2357_s3_q & (less_2026_s3_q & ({and_3109, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:780
  logic and_3114;
  assign and_3114 = equal_1954_s3_q & (x_s3_q[6] & and_3112);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3116;
  assign sum_3116 = {{2{select_3108[11]}}, select_3108} + (and_3114 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_3119;
  assign select_3119 = or_2030_s3_q ? 12'h0 : (equal_3102_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_3122;
  assign select_3122 = x_s3_q[6] ? (equal_1995_s3_q ? 12'h0 : (less_2026_s3_q ? select_3119 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:780
  logic [11:0] select_3123;
  assign select_3123 = equal_1954_s3_q ? select_3122 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3125;
  assign sum_3125 = {{2{select_3123[11]}}, select_3123} + (and_3114 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3127;
  assign not_3127 = ~all_s3_q;
  // hls/stages/agreement.hpp:1118
  logic and_3130;
  assign and_3130 = not_2357_s3_q & (less_2026_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3127, 1'b0}));
  // hls/stages/agreement.hpp:780
  logic and_3136;
  assign and_3136 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & (less_2026_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3137;
  assign not_3137 = ~and_3136;
  logic less_3138;
  assign less_3138 = $signed({9'h1, {2{not_3137}}, and_3136}) < $signed(registration_up_q[13:2]);
  logic select_3139;
  assign select_3139 = (equal_1954_s3_q & (x_s3_q[6] & and_3130)) ? less_3138 : registration_enough_q;
  // hls/stages/agreement.hpp:1118
  logic and_3143;
  assign and_3143 = x_s3_q[6] & (not_2357_s3_q & (less_2026_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:780
  logic and_3144;
  assign and_3144 = equal_1954_s3_q & and_3143;
  // hls/stages/registration.hpp:242
  logic less_3145;
  assign less_3145 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3147;
  assign less_3147 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3149;
  assign equal_3149 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:780
  logic and_3153;
  assign and_3153 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & (less_2026_s3_q & equal_3149)));
  // hls/stages/agreement.hpp:1118
  logic and_3160;
  assign and_3160 = x_s3_q[6] & (not_2357_s3_q & (less_2026_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3163;
  assign equal_3163 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1118
  logic and_3166;
  assign and_3166 = not_2357_s3_q & (less_2026_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3163));
  // hls/stages/registration.hpp:244
  logic and_3170;
  assign and_3170 = (equal_1954_s3_q & (x_s3_q[6] & and_3166)) & (less_3147 | less_3145);
  // hls/stages/agreement.hpp:1118
  logic and_3175;
  assign and_3175 = not_2357_s3_q & (less_2026_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3163)));
  // hls/stages/registration.hpp:244
  logic and_3178;
  assign and_3178 = registration_votes_up_q & registration_other_down_q;
  logic select_3180;
  assign select_3180 = registration_votes_down_q ? (registration_other_up_q | and_3178) : and_3178;
  // hls/stages/registration.hpp:138
  logic and_3182;
  assign and_3182 = (equal_1954_s3_q & (x_s3_q[6] & and_3175)) & (registration_other_enough_q & select_3180);
  // hls/stages/registration.hpp:245
  logic or_3185;
  assign or_3185 = registration_moved_q | (registration_enough_q & (and_3170 | and_3182));
  // hls/stages/agreement.hpp:270
  logic [7:0] select_3270;
  assign select_3270 = sample_pair_whole_s3_q ? (equal_2081_s3_q ? patches_place_0_slope_q : select_2184[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3275;
  assign select_3275 = sample_pair_whole_s3_q ? (equal_2081_s3_q ? patches_place_1_slope_q : select_2213[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3277;
  assign select_3277 = equal_2081_s3_q ? patches_valid_0_q : (select_2080_s3_q ? patches_valid_0_q : select_2181[0]);
  // hls/stages/agreement.hpp:270
  logic select_3280;
  assign select_3280 = sample_pair_whole_s3_q ? (and_2204 ? (sample_present_s3_q & select_3277) : select_3277) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3282;
  assign select_3282 = equal_2081_s3_q ? patches_valid_1_q : (select_2080_s3_q ? select_2181[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:270
  logic select_3285;
  assign select_3285 = sample_pair_whole_s3_q ? (and_2224 ? (sample_present_s3_q & select_3282) : select_3282) : patches_valid_1_q;
  logic [5:0] select_3288;
  assign select_3288 = sample_pair_whole_s3_q ? (select_2202[5] ? {1'b1, select_2202[4:0]} : (select_2202 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3291;
  assign select_3291 = sample_pair_whole_s3_q ? (select_2222[5] ? {1'b1, select_2222[4:0]} : (select_2222 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3294;
  assign select_3294 = sample_pair_whole_s3_q ? (select_2235[4] ? {1'b1, select_2235[3:0]} : (select_2235 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3297;
  assign select_3297 = sample_pair_whole_s3_q ? (select_2240[4] ? {1'b1, select_2240[3:0]} : (select_2240 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3716_s3_q, parity_3712_s3_q, xor_3700_s3_q, parity_3672_s3_q, parity_3610_s3_q, parity_3481_s3_q} + (equal_3717_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3721;
  assign select_3721 = equal_2165_s3_q ? patches_sums_values_0_q : (equal_2167_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3722;
  assign select_3722 = equal_2167_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3724;
  assign select_3724 = equal_2167_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3726;
  assign select_3726 = equal_2167_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3728;
  assign select_3728 = equal_2167_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3730;
  assign select_3730 = equal_2167_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3732;
  assign select_3732 = equal_2167_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3734;
  assign select_3734 = equal_2167_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3736;
  assign select_3736 = equal_2167_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3738;
  assign select_3738 = equal_2167_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3740;
  assign select_3740 = equal_2167_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3742;
  assign select_3742 = equal_2167_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3744;
  assign select_3744 = equal_2167_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3746;
  assign select_3746 = equal_2167_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3748;
  assign select_3748 = equal_2167_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3750;
  assign select_3750 = equal_2167_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3752;
  assign select_3752 = equal_2167_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_3857;
  assign or_3857 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3856_s3_q;
  logic or_3860;
  assign or_3860 = equal_3848_s3_q | (less_3850_s3_q | (less_3851_s3_q | or_3857));
  // hls/stages/patches.hpp:574
  logic not_3861;
  assign not_3861 = ~or_3860;
  // hls/stages/patches.hpp:555
  logic and_3862;
  assign and_3862 = equal_2331_s3_q & not_3861;
  // hls/stages/patches.hpp:184
  logic and_3865;
  assign and_3865 = equal_2165_s3_q & (less_2328_s3_q ? (not_2330_s3_q & and_3862) : and_3862);
  // hls/stages/patches.hpp:652
  logic not_3866;
  assign not_3866 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:555
  logic and_3868;
  assign and_3868 = equal_2331_s3_q & (patches_second_s3_q & not_3861);
  // hls/stages/patches.hpp:184
  logic and_3871;
  assign and_3871 = equal_2165_s3_q & (less_2328_s3_q ? (not_2330_s3_q & and_3868) : and_3868);
  // hls/stages/patches.hpp:652
  logic not_3872;
  assign not_3872 = ~and_3871;
  // hls/stages/patches.hpp:188
  logic and_3874;
  assign and_3874 = and_3865 & (not_3866 & not_3872);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3876;
  assign sum_3876 = {7'h0, and_3874} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_3902;
  assign select_3902 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3903;
  assign select_3903 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3904;
  assign sum_3904 = {2'h0, select_3836_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3905;
  assign sum_3905 = {select_3903[5], select_3903} + {{3{sum_3904[3]}}, sum_3904};
  // hls/stages/patches.hpp:592
  logic [17:0] product_3906;
  assign product_3906 = $signed({{10{select_3902[7]}}, select_3902}) * $signed({{8{sum_3905[6]}}, sum_3905, select_3836_s3_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_3907;
  assign difference_3907 = {{6{select_3901_s3_q[7]}}, select_3901_s3_q} - {product_3906[17], product_3906[17:5]};
  // hls/stages/patches.hpp:599
  logic less_3908;
  assign less_3908 = $signed({{7{difference_3878[6]}}, difference_3878}) < $signed(difference_3907);
  // hls/stages/patches.hpp:555
  logic and_3911;
  assign and_3911 = equal_2331_s3_q & (not_3861 & (~less_3908));
  // hls/stages/patches.hpp:184
  logic and_3914;
  assign and_3914 = equal_2165_s3_q & (less_2328_s3_q ? (not_2330_s3_q & and_3911) : and_3911);
  // hls/stages/patches.hpp:655
  logic and_3915;
  assign and_3915 = and_3914 & and_3874;
  logic [7:0] sum_3916;
  assign sum_3916 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3915};
  // hls/stages/patches.hpp:555
  logic and_3920;
  assign and_3920 = not_3861 & (~($signed(difference_3907) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3921;
  assign and_3921 = equal_2331_s3_q & and_3920;
  // hls/stages/patches.hpp:184
  logic and_3924;
  assign and_3924 = equal_2165_s3_q & (less_2328_s3_q ? (not_2330_s3_q & and_3921) : and_3921);
  // hls/stages/patches.hpp:656
  logic and_3925;
  assign and_3925 = and_3924 & and_3874;
  logic [7:0] sum_3926;
  assign sum_3926 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3925};
  // hls/stages/patches.hpp:188
  logic and_3928;
  assign and_3928 = and_3865 & (and_3871 & not_3866);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3930;
  assign sum_3930 = {7'h0, and_3928} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3932;
  assign and_3932 = and_3914 & and_3928;
  logic [7:0] sum_3933;
  assign sum_3933 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3932};
  // hls/stages/patches.hpp:656
  logic and_3935;
  assign and_3935 = and_3924 & and_3928;
  logic [7:0] sum_3936;
  assign sum_3936 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3935};
  // hls/stages/patches.hpp:188
  logic and_3938;
  assign and_3938 = and_3865 & (patches_lower_s3_q & not_3872);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3940;
  assign sum_3940 = {7'h0, and_3938} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3942;
  assign and_3942 = and_3914 & and_3938;
  logic [7:0] sum_3943;
  assign sum_3943 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3942};
  // hls/stages/patches.hpp:656
  logic and_3945;
  assign and_3945 = and_3924 & and_3938;
  logic [7:0] sum_3946;
  assign sum_3946 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3945};
  // hls/stages/patches.hpp:188
  logic and_3948;
  assign and_3948 = and_3865 & (patches_lower_s3_q & and_3871);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3950;
  assign sum_3950 = {7'h0, and_3948} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3952;
  assign and_3952 = and_3914 & and_3948;
  logic [7:0] sum_3953;
  assign sum_3953 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3952};
  // hls/stages/patches.hpp:656
  logic and_3955;
  assign and_3955 = and_3924 & and_3948;
  logic [7:0] sum_3956;
  assign sum_3956 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3955};
  // hls/stages/agreement.hpp:1195
  logic equal_3957;
  assign equal_3957 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1106
  logic less_3958;
  assign less_3958 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:780
  logic and_3962;
  assign and_3962 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & (equal_3957 & less_3958)));
  // hls/stages/agreement.hpp:1118
  logic and_3967;
  assign and_3967 = x_s3_q[6] & (not_2357_s3_q & (less_3958 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:780
  logic and_3968;
  assign and_3968 = equal_1954_s3_q & and_3967;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3970;
  assign or_3970 = (and_3962 ? patches_quarters_0_places_q : 8'h0) | (and_3968 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1118
  logic and_3974;
  assign and_3974 = x_s3_q[6] & (not_2357_s3_q & (less_3958 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:780
  logic and_3975;
  assign and_3975 = equal_1954_s3_q & and_3974;
  // hls/stages/agreement.hpp:1118
  logic and_3981;
  assign and_3981 = x_s3_q[6] & (not_2357_s3_q & (less_3958 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:780
  logic and_3982;
  assign and_3982 = equal_1954_s3_q & and_3981;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3984;
  assign or_3984 = (or_3970 | (and_3975 ? patches_quarters_2_places_q : 8'h0)) | (and_3982 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3988;
  assign select_3988 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:780
  logic and_3992;
  assign and_3992 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & (less_3958 & select_3988)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_3994;
  assign select_3994 = and_3962 ? (and_3992 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3996;
  assign select_3996 = and_3968 ? (and_3992 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3999;
  assign select_3999 = and_3975 ? (and_3992 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4002;
  assign select_4002 = and_3982 ? (and_3992 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_4005;
  assign select_4005 = and_3962 ? (and_3992 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4007;
  assign select_4007 = and_3968 ? (and_3992 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4010;
  assign select_4010 = and_3975 ? (and_3992 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4013;
  assign select_4013 = and_3982 ? (and_3992 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4015;
  assign sum_4015 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1118
  logic and_4019;
  assign and_4019 = x_s3_q[6] & (not_2357_s3_q & (less_3958 & (sum_4015[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:780
  logic and_4020;
  assign and_4020 = equal_1954_s3_q & and_4019;
  // hls/stages/patches.hpp:615
  logic [7:0] select_4023;
  assign select_4023 = and_4020 ? (patches_word_places_q + (and_3968 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4026;
  assign select_4026 = and_4020 ? (patches_word_up_q + (and_3968 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4029;
  assign select_4029 = and_4020 ? (patches_word_down_q + (and_3968 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_4033;
  assign select_4033 = ($signed(difference_3907[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3907[5:0];
  logic [5:0] select_4034;
  assign select_4034 = ($signed(14'h10) < $signed(difference_3907)) ? 6'h10 : select_4033;
  // hls/stages/patches.hpp:555
  logic [5:0] select_4036;
  assign select_4036 = equal_2331_s3_q ? (or_3860 ? 6'h0 : select_4034) : 6'h0;
  logic [5:0] select_4038;
  assign select_4038 = less_2328_s3_q ? (equal_2329_s3_q ? 6'h0 : select_4036) : select_4036;
  // hls/stages/patches.hpp:658
  logic [5:0] select_4040;
  assign select_4040 = and_3865 ? (equal_2165_s3_q ? select_4038 : 6'h0) : 6'h0;
  logic [11:0] sum_4041;
  assign sum_4041 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4040[5]}}, select_4040};
  // hls/stages/agreement.hpp:780
  logic and_4045;
  assign and_4045 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q & (equal_3149 & less_3958)));
  // hls/stages/agreement.hpp:1118
  logic and_4049;
  assign and_4049 = x_s3_q[6] & (not_2357_s3_q & (less_3958 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:780
  logic and_4050;
  assign and_4050 = equal_1954_s3_q & and_4049;
  // hls/stages/patches.hpp:642
  logic [7:0] select_4052;
  assign select_4052 = and_4045 ? (and_4050 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_4056;
  assign or_4056 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_4059;
  assign or_4059 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_4060;
  assign sum_4060 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_4062;
  assign select_4062 = and_4045 ? (and_4050 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:780
  logic and_4067;
  assign and_4067 = equal_1954_s3_q & ((x_s3_q[6:0] == 7'h70) & (~equal_4064_s3_q));
  // hls/stages/patches.hpp:188
  logic and_4069;
  assign and_4069 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_4071;
  assign select_4071 = and_4050 ? {and_4069, patches_found_q[2:1]} : (and_4045 ? {and_4069, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_4075;
  assign or_4075 = patches_partly_q | (patches_doubted_q & (~and_4050));
  // hls/stages/patches.hpp:641
  logic select_4078;
  assign select_4078 = and_4045 ? (and_4050 ? or_4075 : (and_4045 ? or_4075 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_4079;
  assign select_4079 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_4083;
  assign select_4083 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_4085;
  assign sum_4085 = {sum_3905[6], sum_3905, select_3836_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_4088;
  assign and_4088 = equal_2331_s3_q & (not_3861 & ({{5{sum_4085[10]}}, sum_4085} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4091;
  assign and_4091 = equal_2165_s3_q & (less_2328_s3_q ? (not_2330_s3_q & and_4088) : and_4088);
  // hls/stages/patches.hpp:188
  logic and_4092;
  assign and_4092 = and_3865 & and_4091;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4093;
  assign sum_4093 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4092};
  // hls/stages/patches.hpp:649
  logic [12:0] product_4094;
  assign product_4094 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4052};
  // hls/stages/patches.hpp:188
  logic and_4100;
  assign and_4100 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_4105;
  assign select_4105 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_4109;
  assign or_4109 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_4116;
  assign select_4116 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_4122;
  assign and_4122 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_4123;
  assign sum_4123 = patches_age_q + {9'h0, and_4122};
  logic [9:0] select_4126;
  assign select_4126 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4123)) : sum_4123;
  // hls/stages/agreement.hpp:1160
  logic or_4183;
  assign or_4183 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1189
  logic equal_4185;
  assign equal_4185 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1198
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1199
  logic select_4191;
  assign select_4191 = (equal_4185 & equal_3957) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1111
  logic [10:0] sum_4194;
  assign sum_4194 = {1'b0, select_2926} + {2'h0, select_2926[9:1]};
  logic select_4197;
  assign select_4197 = (select_2923[9:3] == 7'h0) ? ((~or_4183) & (~select_4191)) : (~({sum_4194, select_2926[0]} < {2'h0, select_2923}));
  // hls/stages/agreement.hpp:1118
  logic [47:0] select_4199;
  assign select_4199 = x_s3_q[6] ? (equal_1995_s3_q ? good_q : {select_4197, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:780
  logic select_4203;
  assign select_4203 = equal_1954_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4064_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1189
  logic equal_4204;
  assign equal_4204 = x_s3_q[6:3] == 4'ha;
  logic equal_4206;
  assign equal_4206 = x_s3_q[6:3] == 4'hc;
  logic equal_4207;
  assign equal_4207 = x_s3_q[6:3] == 4'hb;
  logic equal_4208;
  assign equal_4208 = x_s3_q[6:3] == 4'h9;
  logic equal_4209;
  assign equal_4209 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_4211;
  assign select_4211 = equal_4208 ? counts_skin_unproven_q : (equal_4209 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4213;
  assign select_4213 = equal_4207 ? counts_regions_bad_q : (equal_4204 ? counts_nearer_q : select_4211);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4206 ? counts_on_skin_q : select_4213;
  // hls/stages/agreement.hpp:1194
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1202
  logic select_4216;
  assign select_4216 = (equal_4204 & equal_3957) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1120
  logic not_4217;
  assign not_4217 = ~hidden_for_q[7];
  logic [7:0] select_4219;
  assign select_4219 = select_4216 ? (hidden_for_q + {7'h0, not_4217}) : 8'h0;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_4221;
  assign select_4221 = equal_1954_s3_q ? (equal_4064_s3_q ? select_4219 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1203
  logic [13:0] select_4222;
  assign select_4222 = equal_3957 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1101
  logic [7:0] select_4224;
  assign select_4224 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4226;
  assign select_4226 = equal_4209 ? cfg_unproven_skin_limit_i : (equal_4185 ? cfg_unproven_limit_i : select_4224);
  logic [7:0] select_4228;
  assign select_4228 = equal_4204 ? cfg_regions_limit_i : (equal_4208 ? cfg_hidden_limit_i : select_4226);
  logic [7:0] limit;
  assign limit = equal_4206 ? cfg_regions_limit_i : (equal_4207 ? {cfg_on_skin_limit_i, 3'h0} : select_4228);
  // hls/stages/agreement.hpp:1203
  logic not_4231;
  assign not_4231 = ~x_s3_q[2];
  logic [3:0] select_4232;
  assign select_4232 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4231, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4231};
  logic [7:0] select_4233;
  assign select_4233 = x_s3_q[0] ? {select_4232[3], 1'b0, select_4232[2], 1'b0, select_4232[1], 1'b0, select_4232[0], 1'b0} : {1'b0, select_4232[3], 1'b0, select_4232[2], 1'b0, select_4232[1], 1'b0, select_4232[0]};
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_4237;
  assign select_4237 = equal_4208 ? counts_skin_supervised_q : (equal_4209 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4239;
  assign select_4239 = equal_4207 ? counts_skin_textured_q : (equal_4204 ? counts_textured_q : select_4237);
  logic [13:0] of;
  assign of = equal_4206 ? counts_textured_q : select_4239;
  // hls/stages/agreement.hpp:1203
  logic [13:0] select_4241;
  assign select_4241 = ((limit & select_4233) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4222} + {1'b0, select_4241};
  // hls/stages/agreement.hpp:780
  logic select_4246;
  assign select_4246 = equal_1954_s3_q ? (equal_3957 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1200
  logic and_4251;
  assign and_4251 = too_much_q & (~(equal_4209 & equal_3957));
  // hls/stages/agreement.hpp:1201
  logic select_4256;
  assign select_4256 = (over[14] & equal_3957) ? (and_4251 | ((equal_4209 | equal_4208) | (x_s3_q[6:3] == 4'hf))) : and_4251;
  // hls/stages/agreement.hpp:1101
  logic and_4261;
  assign and_4261 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1203
  logic select_4262;
  assign select_4262 = (equal_4206 & equal_3957) ? and_4261 : overlooks_q;
  // hls/stages/agreement.hpp:780
  logic [2:0] select_4264;
  assign select_4264 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4266;
  assign select_4266 = equal_1954_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4264 : box_textured_columns_values_0_q);
  logic [2:0] select_4267;
  assign select_4267 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4269;
  assign select_4269 = equal_1954_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4267 : box_textured_columns_values_1_q);
  logic [2:0] select_4270;
  assign select_4270 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4272;
  assign select_4272 = equal_1954_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4270 : box_textured_columns_values_2_q);
  logic [2:0] select_4273;
  assign select_4273 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4275;
  assign select_4275 = equal_1954_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4273 : box_textured_columns_values_3_q);
  logic [2:0] select_4276;
  assign select_4276 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4278;
  assign select_4278 = equal_1954_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4276 : box_textured_columns_values_4_q);
  logic [4:0] select_4280;
  assign select_4280 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4282;
  assign select_4282 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4284;
  assign select_4284 = equal_1954_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4282 : box_explained_columns_values_0_q);
  logic [2:0] select_4285;
  assign select_4285 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4287;
  assign select_4287 = equal_1954_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4285 : box_explained_columns_values_1_q);
  logic [2:0] select_4288;
  assign select_4288 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4290;
  assign select_4290 = equal_1954_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4288 : box_explained_columns_values_2_q);
  logic [2:0] select_4291;
  assign select_4291 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4293;
  assign select_4293 = equal_1954_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4291 : box_explained_columns_values_3_q);
  logic [2:0] select_4294;
  assign select_4294 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4296;
  assign select_4296 = equal_1954_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4294 : box_explained_columns_values_4_q);
  logic [4:0] select_4298;
  assign select_4298 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4299;
  assign select_4299 = equal_1954_s3_q ? box_explained_sum_sums_values_0_q : select_4298;
  logic [2:0] select_4301;
  assign select_4301 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4303;
  assign select_4303 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4305;
  assign select_4305 = equal_1954_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4303 : box_shown_columns_values_1_q);
  logic [2:0] select_4306;
  assign select_4306 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4308;
  assign select_4308 = equal_1954_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4306 : box_shown_columns_values_2_q);
  logic [2:0] select_4309;
  assign select_4309 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4311;
  assign select_4311 = equal_1954_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4309 : box_shown_columns_values_3_q);
  logic [2:0] select_4312;
  assign select_4312 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4314;
  assign select_4314 = equal_1954_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4312 : box_shown_columns_values_4_q);
  logic [4:0] select_4316;
  assign select_4316 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4319;
  assign select_4319 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4321;
  assign select_4321 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4323;
  assign select_4323 = equal_1954_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4321 : box_nearer_columns_values_1_q);
  logic [2:0] select_4324;
  assign select_4324 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4326;
  assign select_4326 = equal_1954_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4324 : box_nearer_columns_values_2_q);
  logic [2:0] select_4327;
  assign select_4327 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4329;
  assign select_4329 = equal_1954_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4327 : box_nearer_columns_values_3_q);
  logic [2:0] select_4330;
  assign select_4330 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4332;
  assign select_4332 = equal_1954_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4330 : box_nearer_columns_values_4_q);
  logic [4:0] select_4334;
  assign select_4334 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1279
  logic [1:0] select_4379;
  assign select_4379 = and_4378_s3_q ? {and_2493, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1280
  logic and_4380;
  assign and_4380 = proven_q & less_4368;
  // hls/stages/agreement.hpp:431
  logic select_4383;
  assign select_4383 = and_2423_s3_q ? (less_2424_s3_q ? (select_4379[0] & and_4380) : seen_q) : seen_q;
  logic select_4386;
  assign select_4386 = and_2423_s3_q ? (less_2424_s3_q ? (select_4379[1] & and_4380) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1211
  logic or_4394;
  assign or_4394 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4393_s3_q;
  // hls/stages/agreement.hpp:1213
  logic not_4402;
  assign not_4402 = ~(or_4183 | not_4387);
  // hls/stages/agreement.hpp:780
  logic and_4406;
  assign and_4406 = equal_1954_s3_q & (equal_4064_s3_q & (not_4402 & (select_4191 | select_4256)));
  logic and_4409;
  assign and_4409 = equal_4064_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1122
  logic or_4413;
  assign or_4413 = select_2746 | (select_2758 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:780
  logic and_4420;
  assign and_4420 = equal_1954_s3_q & (equal_4064_s3_q & (not_4402 & (select_2752 | select_2764)));
  // hls/stages/agreement.hpp:1122
  logic and_4425;
  assign and_4425 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4219 < cfg_hidden_frames_i));
  logic select_4431;
  assign select_4431 = (not_4387 | (select_4262 & not_4096)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:780
  logic and_4437;
  assign and_4437 = equal_1954_s3_q & (x_s3_q[6] & (not_2357_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1116
  logic [31:0] select_4445;
  assign select_4445 = equal_2017_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4443_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4446;
  assign select_4446 = equal_2015_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4445;
  logic [31:0] select_4447;
  assign select_4447 = equal_2013_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4446;
  logic [31:0] select_4448;
  assign select_4448 = equal_2011_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4447;
  logic [31:0] select_4449;
  assign select_4449 = equal_2009_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4448;
  logic [31:0] select_4450;
  assign select_4450 = equal_2007_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4449;
  logic [31:0] select_4451;
  assign select_4451 = equal_2005_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4450;
  logic [31:0] select_4452;
  assign select_4452 = equal_2003_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4451;
  // hls/stages/agreement.hpp:1114
  logic [9:0] select_4453;
  assign select_4453 = less_2922 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1118
  logic [31:0] select_4454;
  assign select_4454 = equal_1995_s3_q ? select_4452 : {2'h0, select_4453, select_2926, select_2923};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_515_s3_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s3_q, and_630, and_606_s3_q, and_605_s3_q, and_580_s3_q, less_572_s3_q, less_571_s3_q, less_570_s3_q, less_569_s3_q, less_568_s3_q, less_567_s3_q, less_566_s3_q, less_565_s3_q, less_564_s3_q, less_563_s3_q, less_562_s3_q, less_561_s3_q, less_560_s3_q, less_559_s3_q, less_558_s3_q, less_557_s3_q, less_556_s3_q, less_555_s3_q, less_554_s3_q, less_553_s3_q, less_552_s3_q, less_551_s3_q, less_550_s3_q, less_549_s3_q};
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
  assign registration_sums_waddr = {sum_2001_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2060_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2059, sum_2055};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2089_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2164_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2157_s3_q};
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
  assign patches_right_0_waddr = {select_2195_s3_q, select_2192};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2204);
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
  assign patches_right_1_waddr = {select_2195_s3_q, select_2221};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2224);
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
  assign patches_left_waddr = {select_2243, select_2242_s3_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2249);
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
  assign patches_rows_wdata = select_2345;
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
  assign regions_waddr = {region_row_s3_q, or_2355_s3_q, or_2352_s3_q, or_2349_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2389_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2388, sum_2378, sum_2373};
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
  assign map_waddr = {sum_2429_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2503_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2493, is_seen};
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
      patches_frame_ended_q <= 1'b0;
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
      census_left_misses_q <= select_2652;
      sharpness_before_last_mask_q <= select_2660;
      sharpness_sums_detail_0_q <= and_515_s3_q ? select_2674 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_515_s3_q ? select_2686 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_515_s3_q ? sum_2690 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_515_s3_q ? sum_2694 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2712 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2722 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2724 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2726 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2728 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2730 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2735;
      sharpness_comparing_carry_1_q <= select_2739;
      sharpness_comparing_less_detail_0_q <= select_2746;
      sharpness_comparing_less_detail_1_q <= select_2752;
      sharpness_comparing_less_contrast_0_q <= select_2758;
      sharpness_comparing_less_contrast_1_q <= select_2764;
      counts_supervised_q <= select_2880;
      counts_textured_q <= and_2872_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2883});
      counts_explained_q <= and_2872_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2888});
      counts_nearer_q <= and_2872_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2893});
      counts_unproven_q <= and_2872_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2919});
      counts_regions_bad_q <= select_2935;
      counts_skin_supervised_q <= select_2942;
      counts_skin_textured_q <= select_2949;
      counts_skin_unproven_q <= select_2957;
      counts_on_skin_q <= select_2976;
      registration_half_across_q <= select_3030;
      registration_half_measured_q <= select_3035;
      registration_half_votes_down_q <= and_3008_s3_q ? 7'h0 : sum_3041;
      registration_half_votes_up_q <= and_3008_s3_q ? 7'h0 : sum_3049;
      registration_half_half_votes_down_q <= and_3008_s3_q ? 7'h0 : sum_3056;
      registration_half_half_votes_up_q <= and_3008_s3_q ? 7'h0 : sum_3063;
      registration_down_q <= and_3097 ? sum_3116 : registration_down_q;
      registration_up_q <= and_3097 ? sum_3125 : registration_up_q;
      registration_enough_q <= select_3139;
      registration_votes_down_q <= and_3144 ? less_3145 : registration_votes_down_q;
      registration_votes_up_q <= and_3144 ? less_3147 : registration_votes_up_q;
      registration_other_enough_q <= and_3153 ? select_3139 : registration_other_enough_q;
      registration_other_down_q <= and_3153 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3153 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1954_s3_q & and_3160)) & or_3185;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2183 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2185 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2186 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3270;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2212 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2214 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2215 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3275;
      patches_valid_0_q <= select_3280;
      patches_valid_1_q <= select_3285;
      patches_right_next_0_q <= select_3288;
      patches_right_next_1_q <= select_3291;
      patches_left_next_0_q <= select_3294;
      patches_left_next_1_q <= select_3297;
      patches_sums_values_0_q <= select_3721;
      patches_sums_values_1_q <= equal_2165_s3_q ? patches_sums_values_1_q : select_3722;
      patches_sums_values_2_q <= equal_2165_s3_q ? patches_sums_values_2_q : select_3724;
      patches_sums_values_3_q <= equal_2165_s3_q ? patches_sums_values_3_q : select_3726;
      patches_sums_values_4_q <= equal_2165_s3_q ? patches_sums_values_4_q : select_3728;
      patches_sums_values_5_q <= equal_2165_s3_q ? patches_sums_values_5_q : select_3730;
      patches_sums_values_6_q <= equal_2165_s3_q ? patches_sums_values_6_q : select_3732;
      patches_sums_values_7_q <= equal_2165_s3_q ? patches_sums_values_7_q : select_3734;
      patches_sums_values_8_q <= equal_2165_s3_q ? patches_sums_values_8_q : select_3736;
      patches_sums_values_9_q <= equal_2165_s3_q ? patches_sums_values_9_q : select_3738;
      patches_sums_values_10_q <= equal_2165_s3_q ? patches_sums_values_10_q : select_3740;
      patches_sums_values_11_q <= equal_2165_s3_q ? patches_sums_values_11_q : select_3742;
      patches_sums_values_12_q <= equal_2165_s3_q ? patches_sums_values_12_q : select_3744;
      patches_sums_values_13_q <= equal_2165_s3_q ? patches_sums_values_13_q : select_3746;
      patches_sums_values_14_q <= equal_2165_s3_q ? patches_sums_values_14_q : select_3748;
      patches_sums_values_15_q <= equal_2165_s3_q ? patches_sums_values_15_q : select_3750;
      patches_sums_values_16_q <= equal_2165_s3_q ? patches_sums_values_16_q : select_3752;
      patches_best_differing_q <= select_2345[9:0];
      patches_best_column_q <= select_2345[14:10];
      patches_quarters_0_places_q <= sum_3876;
      patches_quarters_0_up_q <= sum_3916;
      patches_quarters_0_down_q <= sum_3926;
      patches_quarters_1_places_q <= sum_3930;
      patches_quarters_1_up_q <= sum_3933;
      patches_quarters_1_down_q <= sum_3936;
      patches_quarters_2_places_q <= sum_3940;
      patches_quarters_2_up_q <= sum_3943;
      patches_quarters_2_down_q <= sum_3946;
      patches_quarters_3_places_q <= sum_3950;
      patches_quarters_3_up_q <= sum_3953;
      patches_quarters_3_down_q <= sum_3956;
      patches_word_places_q <= or_3984;
      patches_word_up_q <= ((select_3994 | select_3996) | select_3999) | select_4002;
      patches_word_down_q <= ((select_4005 | select_4007) | select_4010) | select_4013;
      patches_sum_places_q <= select_4023;
      patches_sum_up_q <= select_4026;
      patches_sum_down_q <= select_4029;
      patches_across_q <= sum_4041;
      patches_places_q <= select_4052;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4056;
      patches_partly_q <= or_4059;
      patches_clear_limit_q <= sum_4060[8:2];
      patches_complete_q <= select_4062;
      patches_frame_ended_q <= and_4067;
      patches_round_ends_q <= patches_complete_q & and_4067;
      patches_found_q <= and_4045 ? select_4071 : patches_found_q;
      patches_doubted_q <= select_4078;
      patches_doubted_before_q <= select_4079;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4083;
      patches_on_skin_q <= sum_4093;
      patches_on_skin_most_q <= product_4094[12:5];
      patches_large_q <= not_4096 & and_4100;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4105;
      patches_spoiled_q <= or_4109;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4116;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4126;
      segment_textured_q <= select_2370 + {6'h0, and_2883};
      segment_explained_q <= select_2375 + {6'h0, and_2888};
      segment_nearer_q <= select_2385 + {6'h0, and_2893};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1954_s3_q ? select_4199 : good_q;
      good_known_q <= select_4203;
      hidden_for_q <= select_4221;
      product_q <= equal_1954_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4246;
      disagree_q <= equal_1954_s3_q ? select_4191 : disagree_q;
      too_much_q <= equal_1954_s3_q ? select_4256 : too_much_q;
      hides_q <= equal_1954_s3_q ? select_4216 : hides_q;
      overlooks_q <= equal_1954_s3_q ? select_4262 : overlooks_q;
      seen_q <= select_4383;
      nearer_q <= select_4386;
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
      averager_quarter_1_0_q <= select_2527;
      averager_quarter_1_1_q <= select_2529;
      averager_quarter_2_0_q <= select_2531;
      averager_quarter_2_1_q <= select_2533;
      averager_detail_0_q <= select_2545;
      averager_detail_1_q <= select_2553;
      census_changes_values_0_left_q <= and_515_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_515_s3_q ? sum_2636 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2638;
      census_changes_values_1_right_q <= select_2639;
      census_changes_values_2_left_q <= select_2640;
      census_changes_values_2_right_q <= select_2641;
      sharpness_last_mask_q <= and_515_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_515_s3_q ? select_2657[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_515_s3_q ? select_2657[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4266;
      box_textured_columns_values_1_q <= select_4269;
      box_textured_columns_values_2_q <= select_4272;
      box_textured_columns_values_3_q <= select_4275;
      box_textured_columns_values_4_q <= select_4278;
      box_textured_sum_sums_values_0_q <= equal_1954_s3_q ? box_textured_sum_sums_values_0_q : select_4280;
      box_explained_columns_values_0_q <= select_4284;
      box_explained_columns_values_1_q <= select_4287;
      box_explained_columns_values_2_q <= select_4290;
      box_explained_columns_values_3_q <= select_4293;
      box_explained_columns_values_4_q <= select_4296;
      box_explained_sum_sums_values_0_q <= select_4299;
      box_shown_columns_values_0_q <= equal_1954_s3_q ? box_shown_columns_values_0_q : select_4301;
      box_shown_columns_values_1_q <= select_4305;
      box_shown_columns_values_2_q <= select_4308;
      box_shown_columns_values_3_q <= select_4311;
      box_shown_columns_values_4_q <= select_4314;
      box_shown_sum_sums_values_0_q <= equal_1954_s3_q ? box_shown_sum_sums_values_0_q : select_4316;
      box_nearer_columns_values_0_q <= equal_1954_s3_q ? box_nearer_columns_values_0_q : select_4319;
      box_nearer_columns_values_1_q <= select_4323;
      box_nearer_columns_values_2_q <= select_4326;
      box_nearer_columns_values_3_q <= select_4329;
      box_nearer_columns_values_4_q <= select_4332;
      box_nearer_sum_sums_values_0_q <= equal_1954_s3_q ? box_nearer_sum_sums_values_0_q : select_4334;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4363_s4_q;
  logic or_4388_s4_q;
  logic and_4389_s4_q;
  logic and_4397_s4_q;
  logic and_4400_s4_q;
  logic and_4406_s4_q;
  logic and_4410_s4_q;
  logic and_4416_s4_q;
  logic and_4420_s4_q;
  logic and_4428_s4_q;
  logic and_4433_s4_q;
  logic and_4437_s4_q;
  logic [5:0] select_4439_s4_q;
  logic [31:0] select_4456_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4363_s4_q <= said_q;
      or_4388_s4_q <= not_4387 | select_4383;
      and_4389_s4_q <= cfg_prove_i & select_4386;
      and_4397_s4_q <= equal_1954_s3_q & (equal_4064_s3_q & (cfg_prove_i & or_4394));
      and_4400_s4_q <= equal_1954_s3_q & (equal_4064_s3_q & (cfg_prove_i & or_4183));
      and_4406_s4_q <= and_4406;
      and_4410_s4_q <= equal_1954_s3_q & and_4409;
      and_4416_s4_q <= equal_1954_s3_q & (equal_4064_s3_q & (not_4402 & or_4413));
      and_4420_s4_q <= and_4420;
      and_4428_s4_q <= equal_1954_s3_q & (equal_4064_s3_q & (cfg_prove_i & and_4425));
      and_4433_s4_q <= equal_1954_s3_q & (equal_4064_s3_q & select_4431);
      and_4437_s4_q <= and_4437;
      select_4439_s4_q <= equal_1954_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4456_s4_q <= equal_1954_s3_q ? (x_s3_q[6] ? select_4454 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | registration_sums_error | patches_choices_error | patches_right_0_error | patches_right_1_error | patches_left_error | patches_columns_above_error | patches_right_codes_error | patches_left_codes_error | patches_rows_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign pixel_1_o = pixel_1_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4388_s4_q;
  assign marks_nearer_o = and_4389_s4_q;
  assign verdict_valid_o = and_4363_s4_q;
  assign verdict_unproven_yet_o = and_4397_s4_q;
  assign verdict_untextured_o = and_4400_s4_q;
  assign verdict_disagree_o = and_4406_s4_q;
  assign verdict_moved_o = and_4410_s4_q;
  assign verdict_unsharp_left_o = and_4416_s4_q;
  assign verdict_unsharp_right_o = and_4420_s4_q;
  assign verdict_hidden_o = and_4428_s4_q;
  assign verdict_overlooked_o = and_4433_s4_q;
  assign frame_valid_o = and_4437_s4_q;
  assign frame_index_o = select_4439_s4_q;
  assign frame_word_o = select_4456_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4094[4:0], sum_4060[1:0], sum_4015[1:0], product_3906[4:0], sum_2998[0], difference_2963[1:0], detail_4[1:0], detail_3[1:0], sum_2646[4:0], sum_2105[0], sum_2101[0], sum_628[4:0], cfg_width_i[2:0]};

endmodule
