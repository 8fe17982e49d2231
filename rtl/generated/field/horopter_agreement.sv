// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3098 bits, pipeline 832 bits, memories 66591 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic present_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [8:0] cfg_width_i,
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
  output logic valid_o,
  output logic [7:0] pixel_0_o,
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
  logic not_2347;
  assign not_2347 = ~cfg_prove_i;
  logic [5:0] sum_2560;
  assign sum_2560 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3582;
  assign difference_3582 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3775;
  assign not_3775 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3833;
  assign difference_3833 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4080;
  assign less_4080 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4081;
  assign sum_4081 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4082;
  assign select_4082 = less_4080 ? {sum_4081, cfg_height_i[5:3]} : 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic left_first_q;
  logic right_q;
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [5:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [7:0] averager_place_q;
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
  logic [5:0] last_q;
  logic [5:0] least_q;
  logic [6:0] whole_q;
  logic [6:0] drawn_q;
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
  logic [2:0] select_510;
  assign select_510 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_514;
  assign select_514 = select_510[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_518;
  assign or_518 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_519;
  assign select_519 = select_510[0] ? averager_inside_q : or_518;
  // hls/stages/census.hpp:42
  logic or_520;
  assign or_520 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_522;
  assign and_522 = select_519 & (select_510[0] & or_520);
  // hls/stages/census.hpp:42
  logic [2:0] select_527;
  assign select_527 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_543;
  assign select_543 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_543 : 6'h0;
  // hls/stages/census.hpp:53
  logic equal_545;
  assign equal_545 = select_510 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_546;
  assign equal_546 = select_527 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_547;
  assign and_547 = equal_546 & and_522;
  // hls/stages/agreement.hpp:276
  logic and_549;
  assign and_549 = sample_pair_whole_q & (equal_545 & and_547);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_578;
  assign equal_578 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_579;
  assign or_579 = so | equal_578;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_580;
  assign sum_580 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_581;
  assign select_581 = run_shift_q[5] ? x_q : sum_580;
  logic less_582;
  assign less_582 = {2'h0, last_q} < select_581;
  // hls/stages/agreement.hpp:226
  logic not_583;
  assign not_583 = ~less_582;
  // hls/stages/agreement.hpp:614
  logic equal_593;
  assign equal_593 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_594;
  assign equal_594 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_595;
  assign and_595 = equal_594 & not_583;
  logic select_597;
  assign select_597 = or_579 ? not_583 : (equal_593 ? not_583 : and_595);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:796
  logic [6:0] sum_611;
  assign sum_611 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_616;
  assign and_616 = equal_593 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_611} < select_581))));
  logic select_617;
  assign select_617 = or_579 ? not_583 : and_616;
  // hls/stages/agreement.hpp:821
  logic [5:0] right;
  assign right = sum_580[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:720
  logic not_647;
  assign not_647 = ~or_579;
  // hls/stages/agreement.hpp:149
  logic and_650;
  assign and_650 = not_647 & ((~equal_593) & and_595);
  // hls/stages/census.hpp:42
  logic [5:0] select_677;
  assign select_677 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_677 : 6'h0;
  // hls/stages/patches.hpp:396
  logic not_1673;
  assign not_1673 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_1676;
  assign not_1676 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_1677;
  assign and_1677 = patches_capturing_q & not_1676;
  // hls/stages/patches.hpp:368
  logic equal_1678;
  assign equal_1678 = {or_520, select_527} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_1680;
  assign equal_1680 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1685;
  assign and_1685 = (not_1673 & (patches_work_q == 3'h0)) & (~(and_1677 | ((~equal_1678) | (~equal_1680))));
  // hls/stages/patches.hpp:537
  logic equal_1776;
  assign equal_1776 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_1777;
  assign not_1777 = ~equal_1776;
  // hls/stages/patches.hpp:509
  logic equal_1778;
  assign equal_1778 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_1779;
  assign not_1779 = ~equal_1778;
  // hls/stages/patches.hpp:503
  logic equal_1780;
  assign equal_1780 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1781;
  assign equal_1781 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1782;
  assign or_1782 = equal_1780 | equal_1781;
  // hls/stages/patches.hpp:464
  logic not_1783;
  assign not_1783 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1805;
  assign select_1805 = and_1685 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1806;
  assign select_1806 = row_starts ? select_1805 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1808;
  assign and_1808 = and_1677 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1812;
  assign select_1812 = row_starts ? (and_1685 | (and_1677 & (~and_1808))) : patches_capturing_q;
  // hls/stages/agreement.hpp:275
  logic and_1820;
  assign and_1820 = not_1777 & (not_1779 & (or_1782 & (patches_second_q & equal_1781)));
  // hls/stages/patches.hpp:168
  logic not_1836;
  assign not_1836 = ~equal_1781;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1852;
  assign select_1852 = row_starts ? {select_1805[4], select_1805[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_1862;
  assign and_1862 = not_1777 & (or_1782 & not_1779);
  // hls/stages/agreement.hpp:190
  logic and_1968;
  assign and_1968 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2137;
  assign select_2137 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_510 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2140;
  assign select_2140 = sample_pair_whole_q ? (sample_last_q ? (select_527 + 3'h1) : select_527) : raster_at_y_q;
  logic [5:0] select_2143;
  assign select_2143 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_543 + {5'h0, equal_545})) : raster_at_column_q;
  logic [5:0] select_2146;
  assign select_2146 = sample_pair_whole_q ? (sample_last_q ? (select_677 + {5'h0, equal_546}) : select_677) : raster_at_row_q;
  logic select_2150;
  assign select_2150 = sample_pair_whole_q ? (sample_last_q ? (or_520 & (~raster_final_row_q)) : or_520) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2152;
  assign select_2152 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2156;
  assign select_2156 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2465;
  assign sum_2465 = {1'b0, last} + 7'h1;
  logic equal_2466;
  assign equal_2466 = {sum_2465[6], cfg_width_i[8:3]} == {1'b0, sum_2465[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2467;
  assign and_2467 = and_549 & equal_2466;
  // hls/stages/agreement.hpp:523
  logic select_2470;
  assign select_2470 = (and_2467 | (~ends_cell_q)) ? and_2467 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2470 ? (and_2467 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2474;
  assign select_2474 = select_2470 ? (and_2467 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2477;
  assign select_2477 = select_2470 ? (following_last_shift_q & (~and_2467)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2480;
  assign and_2480 = run_last_shift_q & equal_593;
  // hls/stages/agreement.hpp:616
  logic select_2482;
  assign select_2482 = equal_593 ? (~run_last_shift_q) : equal_594;
  // hls/stages/agreement.hpp:620
  logic equal_2483;
  assign equal_2483 = run_phase_q == 3'h1;
  logic not_2486;
  assign not_2486 = ~select_2482;
  // hls/stages/agreement.hpp:623
  logic equal_2488;
  assign equal_2488 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2489;
  assign and_2489 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2490;
  assign select_2490 = equal_2488 ? 2'h1 : {2{and_2489}};
  logic [2:0] select_2492;
  assign select_2492 = (and_2480 | (select_2482 | equal_2483)) ? (equal_2483 ? 3'h2 : {not_2486, {2{select_2482}}}) : (equal_578 ? 3'h6 : {select_2490[0], select_2490});
  // hls/stages/agreement.hpp:607
  logic and_2495;
  assign and_2495 = select_2482 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2498;
  assign select_2498 = (plan_shift_q[5] & select_2482) ? value : 7'h0;
  logic [1:0] or_2499;
  assign or_2499 = {2{so}} | select_2498[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2500;
  assign select_2500 = select_2482 ? plan_columns_q : 8'h0;
  logic [6:0] or_2503;
  assign or_2503 = select_2500[6:0] | ((equal_2483 | equal_2488) ? whole_q : 7'h0);
  logic [1:0] or_2504;
  assign or_2504 = {2{and_2480}} | or_2503[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2506;
  assign or_2506 = {or_2503[6:4], or_2504, or_2503[1:0]} | (equal_578 ? drawn_q : 7'h0);
  logic [4:0] or_2507;
  assign or_2507 = {5{so}} | {or_2506[6], or_2506[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2511;
  assign not_2511 = ~run_shift_q[5];
  logic [6:0] difference_2513;
  assign difference_2513 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2514;
  assign select_2514 = equal_593 ? ({{7{not_2511}}, 1'b1} + run_span_q) : {difference_2513[6], difference_2513};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2518;
  assign select_2518 = and_2467 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2520;
  assign select_2520 = select_2470 ? {select_2518[6], select_2518} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2523;
  assign select_2523 = select_2470 ? (and_2467 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2531;
  assign select_2531 = and_549 ? (equal_2466 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2532;
  assign sum_2532 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2534;
  assign select_2534 = and_549 ? (equal_2466 ? {sum_2532, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2535;
  assign sum_2535 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2537;
  assign select_2537 = and_549 ? (equal_2466 ? {sum_2535, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2551;
  assign select_2551 = (ends_cell_q | select_2470) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_593 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2555;
  assign and_2555 = (~select_2470) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2556;
  assign sum_2556 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2558;
  assign select_2558 = equal_2466 ? ({sum_2556[6], cfg_height_i[8:3]} == {1'b0, sum_2556[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2934;
  assign select_2934 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2935;
  assign select_2935 = sample_pair_whole_q ? select_2934 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_2936;
  assign and_2936 = not_1676 & equal_1678;
  logic [8:0] select_2937;
  assign select_2937 = and_2936 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2938;
  assign select_2938 = and_2936 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2939;
  assign select_2939 = sample_pair_first_q ? select_2937 : select_2938;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2941;
  assign select_2941 = sample_pair_whole_q ? (row_starts ? select_2939[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2943;
  assign select_2943 = sample_pair_whole_q ? (row_starts ? select_2939[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2946;
  assign select_2946 = sample_pair_whole_q ? (equal_1680 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2948;
  assign select_2948 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1680}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2949;
  assign equal_2949 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_2950;
  assign not_2950 = ~equal_2949;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2952;
  assign select_2952 = sample_pair_whole_q ? (phase + {not_2950, 1'b1, not_2950, equal_2949}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2954;
  assign equal_2954 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2958;
  assign select_2958 = equal_2954 ? ((select_2935 == 4'h6) ? 4'h0 : (select_2935 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2959;
  assign equal_2959 = select_2958 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2962;
  assign select_2962 = equal_2466 ? (equal_2959 ? 4'h6 : (select_2958 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2964;
  assign select_2964 = equal_2954 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2966;
  assign select_2966 = equal_2466 ? (select_2964 + {4'h0, equal_2959}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2971;
  assign select_2971 = and_549 ? (equal_2466 ? ((6'h2 < row) & equal_2959) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2973;
  assign select_2973 = and_549 ? (equal_2466 ? select_2964 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_2996;
  assign sum_2996 = {1'b0, select_677[5:1]} + 6'h1;
  logic less_2997;
  assign less_2997 = {sum_2996, select_677[0], select_527, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3000;
  assign select_3000 = row_starts ? (and_1685 ? (~less_2997) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3039;
  assign or_3039 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3044;
  assign select_3044 = (patches_second_q | patches_begins_q) ? not_1673 : (patches_ends_q & equal_1776);
  logic and_3045;
  assign and_3045 = equal_1776 & not_1783;
  // hls/stages/patches.hpp:403
  logic and_3046;
  assign and_3046 = not_1836 & and_3045;
  logic [1:0] select_3048;
  assign select_3048 = equal_1778 ? 2'h0 : (equal_1780 ? 2'h3 : {equal_1781, and_3046});
  // hls/stages/patches.hpp:283
  logic equal_3050;
  assign equal_3050 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3051;
  assign not_3051 = ~equal_3050;
  // hls/stages/patches.hpp:283
  logic equal_3052;
  assign equal_3052 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3053;
  assign not_3053 = ~equal_3052;
  // hls/stages/patches.hpp:287
  logic not_3055;
  assign not_3055 = ~(patches_following_q == 3'h2);
  logic and_3058;
  assign and_3058 = (~(patches_following_q == 3'h1)) & not_3055;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3059;
  assign select_3059 = equal_3052 ? 2'h2 : {and_3058, not_3055};
  logic [3:0] select_3060;
  assign select_3060 = equal_3050 ? 4'h2 : {select_3059, {2{not_3053}}};
  // hls/stages/patches.hpp:409
  logic not_3063;
  assign not_3063 = ~or_3039;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3068;
  assign select_3068 = or_3039 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3070;
  assign select_3070 = or_3039 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1372; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 33'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
`ifndef SYNTHESIS
  logic fresh_re;
  assign fresh_re = s0_en & and_650;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [84:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 85'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
`ifndef SYNTHESIS
  logic left_re;
  assign left_re = s0_en & select_597;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_579 ? x_q[5:0] : (equal_593 ? sum_580[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_597;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_579 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_617;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
`ifndef SYNTHESIS
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_1777 & (not_1779 & (or_1782 & (equal_1781 & not_1783))));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
`ifndef SYNTHESIS
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_1820;
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:790; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_1777 & (not_1779 & (not_1836 & or_1782)));
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:801; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
`ifndef SYNTHESIS
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_1862;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_first_q <= 1'b0;
      right_q <= 1'b0;
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 6'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 8'h0;
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
      last_q <= 6'h0;
      least_q <= 6'h0;
      whole_q <= 7'h0;
      drawn_q <= 7'h0;
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
      left_first_q <= and_1968 ? left_first_q : marks_first_i;
      right_q <= (~and_1968) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1968;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2137;
      raster_at_y_q <= select_2140;
      raster_at_column_q <= select_2143;
      raster_at_row_q <= select_2146;
      raster_at_live_q <= select_2150;
      raster_rows_left_q <= sample_pair_whole_q ? select_2152 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2156;
      averager_place_q <= sample_pair_whole_q ? select_514 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_519 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2474;
      run_last_shift_q <= select_2477;
      run_span_q <= select_2470 ? (and_2467 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2492;
      following_shift_q <= select_2482 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2495;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2498[6], or_2499, select_2498[3:0]};
      following_columns_q <= {select_2500[7], or_2507[4], or_2506[5:4], or_2507[3:0]};
      plan_shift_q <= equal_593 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2514;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2520;
      columns_left_q <= select_2523;
      last_q <= and_549 ? (equal_2466 ? last : last_q) : last_q;
      least_q <= select_2531;
      whole_q <= select_2534;
      drawn_q <= select_2537;
      age_q <= select_2470 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2470 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2551;
      ends_q <= and_2555;
      final_row_q <= and_549 ? select_2558 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2935;
      patches_band_rows_rows_to_next_q <= select_2941;
      patches_band_rows_number_q <= select_2943;
      patches_next_band_rows_to_next_q <= select_2946;
      patches_next_band_number_q <= select_2948;
      patches_first_band_rows_to_next_q <= select_2952;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2949 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_549 ? select_2962 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_549 ? select_2966 : patches_choosing_number_q;
      patches_chooses_q <= select_2971;
      patches_choosing_band_q <= select_2973;
      patches_capturing_q <= sample_pair_whole_q ? select_1812 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3000 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1806 : patches_row_q;
      patches_work_q <= or_3039 ? following : patches_work_q;
      patches_second_q <= select_3044;
      patches_following_q <= equal_1776 ? {2'h0, and_3045} : {equal_1778, select_3048};
      patches_following_beats_q <= {select_3060, not_3051};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1808);
      patches_ends_q <= not_3063 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3068;
      patches_code_row_q <= select_3070;
      patches_column_q <= or_3039 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3063 & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [5:0] last_s1_q;
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
  logic [2:0] select_510_s1_q;
  logic row_starts_s1_q;
  logic [7:0] select_514_s1_q;
  logic and_522_s1_q;
  logic equal_528_s1_q;
  logic [5:0] select_543_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_547_s1_q;
  logic and_549_s1_q;
  logic equal_574_s1_q;
  logic so_s1_q;
  logic equal_578_s1_q;
  logic or_579_s1_q;
  logic less_582_s1_q;
  logic not_583_s1_q;
  logic equal_593_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_617_s1_q;
  logic [5:0] right_s1_q;
  logic and_650_s1_q;
  logic [5:0] row_s1_q;
  logic and_1561_s1_q;
  logic equal_1562_s1_q;
  logic and_1685_s1_q;
  logic equal_1776_s1_q;
  logic not_1777_s1_q;
  logic equal_1778_s1_q;
  logic not_1779_s1_q;
  logic equal_1780_s1_q;
  logic equal_1781_s1_q;
  logic or_1782_s1_q;
  logic not_1783_s1_q;
  logic [4:0] select_1806_s1_q;
  logic select_1812_s1_q;
  logic [3:0] select_1852_s1_q;
  logic and_1862_s1_q;
  logic equal_2466_s1_q;
  logic and_2467_s1_q;
  logic or_3039_s1_q;
  logic not_3063_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
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
      select_510_s1_q <= select_510;
      row_starts_s1_q <= row_starts;
      select_514_s1_q <= select_514;
      and_522_s1_q <= and_522;
      equal_528_s1_q <= select_527 == 3'h0;
      select_543_s1_q <= select_543;
      last_s1_2_q <= last;
      and_547_s1_q <= and_547;
      and_549_s1_q <= and_549;
      equal_574_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_578_s1_q <= equal_578;
      or_579_s1_q <= or_579;
      less_582_s1_q <= less_582;
      not_583_s1_q <= not_583;
      equal_593_s1_q <= equal_593;
      x_s1_2_q <= x[6:0];
      select_617_s1_q <= select_617;
      right_s1_q <= right;
      and_650_s1_q <= and_650;
      row_s1_q <= row;
      and_1561_s1_q <= not_647 & and_616;
      equal_1562_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1685_s1_q <= and_1685;
      equal_1776_s1_q <= equal_1776;
      not_1777_s1_q <= not_1777;
      equal_1778_s1_q <= equal_1778;
      not_1779_s1_q <= not_1779;
      equal_1780_s1_q <= equal_1780;
      equal_1781_s1_q <= equal_1781;
      or_1782_s1_q <= or_1782;
      not_1783_s1_q <= not_1783;
      select_1806_s1_q <= select_1806;
      select_1812_s1_q <= select_1812;
      select_1852_s1_q <= select_1852;
      and_1862_s1_q <= and_1862;
      equal_2466_s1_q <= equal_2466;
      and_2467_s1_q <= and_2467;
      or_3039_s1_q <= or_3039;
      not_3063_s1_q <= not_3063;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic [5:0] sums_0_columns_values_0_q;
  logic [5:0] sums_0_columns_values_1_q;
  logic [5:0] sums_0_columns_values_2_q;
  logic [5:0] sums_0_columns_values_3_q;
  logic [5:0] sums_0_columns_values_4_q;
  logic [5:0] sums_0_columns_values_5_q;
  logic [5:0] sums_0_columns_values_6_q;
  logic [5:0] sums_0_columns_values_7_q;
  logic [5:0] sums_0_columns_values_8_q;
  logic [5:0] sums_0_columns_values_9_q;
  logic [5:0] sums_0_columns_values_10_q;
  logic [5:0] sums_0_columns_values_11_q;
  logic [5:0] sums_0_columns_values_12_q;
  logic [5:0] sums_0_columns_values_13_q;
  logic [5:0] sums_1_columns_values_0_q;
  logic [5:0] sums_1_columns_values_1_q;
  logic [5:0] sums_1_columns_values_2_q;
  logic [5:0] sums_1_columns_values_3_q;
  logic [5:0] sums_1_columns_values_4_q;
  logic [5:0] sums_1_columns_values_5_q;
  logic [5:0] sums_1_columns_values_6_q;
  logic [5:0] sums_1_columns_values_7_q;
  logic [5:0] sums_1_columns_values_8_q;
  logic [5:0] sums_1_columns_values_9_q;
  logic [5:0] sums_1_columns_values_10_q;
  logic [5:0] sums_1_columns_values_11_q;
  logic [5:0] sums_1_columns_values_12_q;
  logic [5:0] sums_1_columns_values_13_q;
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
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  // hls/stages/census.hpp:127
  logic and_523;
  assign and_523 = sample_pair_whole_s1_q & and_522_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_568;
  assign equal_568 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_569;
  assign equal_569 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_568 & equal_569;
  // hls/stages/moments.hpp:57
  logic [11:0] select_572;
  assign select_572 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [10:0] select_573;
  assign select_573 = first ? 11'h0 : select_572[10:0];
  // hls/stages/agreement.hpp:1009
  logic not_575;
  assign not_575 = ~equal_574_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_577;
  assign not_577 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_579_s1_q & not_583_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_572;
  // hls/stages/moments.hpp:104
  logic not_587;
  assign not_587 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:788
  logic and_591;
  assign and_591 = not_575 & (not_577 & (equal_578_s1_q & (inside_v & not_587)));
  // hls/stages/agreement.hpp:975
  logic and_607;
  assign and_607 = (or_579_s1_q & (left_rdata_q[67] & not_583_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [5:0] select_626;
  assign select_626 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:668
  logic not_747;
  assign not_747 = ~equal_568;
  // hls/stages/agreement.hpp:671
  logic and_748;
  assign and_748 = left_rdata_q[12] & not_747;
  logic and_749;
  assign and_749 = left_rdata_q[30] & not_747;
  logic and_750;
  assign and_750 = left_rdata_q[48] & not_747;
  logic and_751;
  assign and_751 = left_rdata_q[66] & not_747;
  // hls/stages/agreement.hpp:672
  logic and_752;
  assign and_752 = right_codes_rdata_q[12] & not_747;
  logic and_753;
  assign and_753 = right_codes_rdata_q[27] & not_747;
  logic and_754;
  assign and_754 = right_codes_rdata_q[42] & not_747;
  logic and_755;
  assign and_755 = right_codes_rdata_q[57] & not_747;
  logic and_756;
  assign and_756 = right_codes_rdata_q[72] & not_747;
  logic and_757;
  assign and_757 = right_codes_rdata_q[85] & not_747;
  // hls/stages/agreement.hpp:221
  logic and_762;
  assign and_762 = left_rdata_q[48] & not_583_s1_q;
  logic and_763;
  assign and_763 = right_codes_rdata_q[42] & not_583_s1_q;
  logic [11:0] select_764;
  assign select_764 = less_582_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_765;
  assign select_765 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_769;
  assign select_769 = and_762 ? (and_763 ? (~(select_764 ^ select_765)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_775;
  assign parity_775 = ^select_769[5:3];
  logic parity_778;
  assign parity_778 = ^select_769[8:6];
  logic parity_781;
  assign parity_781 = ^select_769[11:3];
  // hls/stages/agreement.hpp:221
  logic and_785;
  assign and_785 = left_rdata_q[66] & not_583_s1_q;
  logic and_786;
  assign and_786 = right_codes_rdata_q[57] & not_583_s1_q;
  logic [11:0] select_787;
  assign select_787 = less_582_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_788;
  assign select_788 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_792;
  assign select_792 = and_785 ? (and_786 ? (~(select_787 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_795;
  assign parity_795 = ^select_792[8:6];
  logic parity_798;
  assign parity_798 = ^select_792[11:9];
  // hls/stages/agreement.hpp:221
  logic and_802;
  assign and_802 = left_rdata_q[84] & not_583_s1_q;
  logic and_803;
  assign and_803 = right_codes_rdata_q[72] & not_583_s1_q;
  logic [11:0] select_804;
  assign select_804 = less_582_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_805;
  assign select_805 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
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
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1006;
  assign select_1006 = equal_593_s1_q ? {and_1005, xor_1004, parity_998, parity_977, xor_932, xor_837} : 6'h0;
  logic [5:0] column;
  assign column = or_579_s1_q ? 6'h0 : select_1006;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1017;
  assign select_1017 = (slot_s1_q[0] ? and_803 : and_786) ? (~(select_764 ^ (slot_s1_q[0] ? select_805 : select_788))) : 12'h0;
  logic [11:0] select_1018;
  assign select_1018 = and_762 ? select_1017 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1024;
  assign parity_1024 = ^select_1018[5:3];
  logic parity_1027;
  assign parity_1027 = ^select_1018[8:6];
  logic parity_1030;
  assign parity_1030 = ^select_1018[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1034;
  assign and_1034 = right_codes_rdata_q[85] & not_583_s1_q;
  logic [11:0] select_1036;
  assign select_1036 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1040;
  assign select_1040 = (slot_s1_q[0] ? and_1034 : and_803) ? (~(select_787 ^ (slot_s1_q[0] ? select_1036 : select_805))) : 12'h0;
  logic [11:0] select_1041;
  assign select_1041 = and_785 ? select_1040 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1044;
  assign parity_1044 = ^select_1041[8:6];
  logic parity_1047;
  assign parity_1047 = ^select_1041[11:9];
  // hls/stages/agreement.hpp:734
  logic select_1052;
  assign select_1052 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_583_s1_q) : and_1034;
  logic [11:0] select_1054;
  assign select_1054 = slot_s1_q[0] ? (less_582_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1036;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1058;
  assign select_1058 = and_802 ? (select_1052 ? (~(select_804 ^ select_1054)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1064;
  assign parity_1064 = ^select_1058[2:0];
  logic parity_1067;
  assign parity_1067 = ^select_1058[5:3];
  logic parity_1070;
  assign parity_1070 = ^select_1058[8:0];
  logic parity_1076;
  assign parity_1076 = ^select_1058[11:9];
  logic parity_1079;
  assign parity_1079 = ^select_1041[2:0];
  logic parity_1082;
  assign parity_1082 = ^{select_1058[11:9], select_1041[5:0]};
  logic parity_1085;
  assign parity_1085 = ^{select_1058, select_1041, select_1018[2:0]};
  logic xor_1086;
  assign xor_1086 = parity_1030 ^ parity_1085;
  // hls/stages/count_bits.hpp:23
  logic or_1090;
  assign or_1090 = (select_1018[1:0] == 2'h3) | (select_1018[2] & (select_1018[0] | select_1018[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1094;
  assign or_1094 = (select_1041[7:6] == 2'h3) | (select_1041[8] & (select_1041[6] | select_1041[7]));
  logic or_1098;
  assign or_1098 = (select_1041[10:9] == 2'h3) | (select_1041[11] & (select_1041[9] | select_1041[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1106;
  assign or_1106 = (select_1058[7:6] == 2'h3) | (select_1058[8] & (~(select_1058[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1110;
  assign or_1110 = (select_1058[1:0] == 2'h3) | (select_1058[2] & (select_1058[0] | select_1058[1]));
  logic or_1114;
  assign or_1114 = (select_1058[4:3] == 2'h3) | (select_1058[5] & (select_1058[3] | select_1058[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1117;
  assign parity_1117 = ^{or_1114, or_1110, or_1106};
  // hls/stages/count_bits.hpp:23
  logic or_1121;
  assign or_1121 = (select_1041[4:3] == 2'h3) | (select_1041[5] & (select_1041[3] | select_1041[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1125;
  assign or_1125 = (select_1058[10:9] == 2'h3) | (select_1058[11] & (select_1058[9] | select_1058[10]));
  logic or_1129;
  assign or_1129 = (select_1041[1:0] == 2'h3) | (select_1041[2] & (select_1041[0] | select_1041[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1132;
  assign parity_1132 = ^{or_1129, or_1125, or_1121};
  logic parity_1135;
  assign parity_1135 = ^{or_1129, or_1125, or_1121, or_1114, or_1110, or_1106, or_1098, or_1094, or_1090};
  // hls/stages/count_bits.hpp:25
  logic and_1136;
  assign and_1136 = parity_1030 & parity_1085;
  logic or_1140;
  assign or_1140 = (parity_1024 & parity_1027) | ((^select_1018[11:9]) & (parity_1024 | parity_1027));
  logic and_1143;
  assign and_1143 = (^{select_1041[11:6], select_1018[2:0]}) & (parity_1070 | parity_1082);
  logic or_1144;
  assign or_1144 = (parity_1070 & parity_1082) | and_1143;
  // hls/stages/count_bits.hpp:23
  logic or_1151;
  assign or_1151 = (select_1018[10:9] == 2'h3) | (select_1018[11] & (select_1018[9] | select_1018[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1155;
  assign or_1155 = (select_1018[4:3] == 2'h3) | (select_1018[5] & (select_1018[3] | select_1018[4]));
  logic or_1159;
  assign or_1159 = (select_1018[7:6] == 2'h3) | (select_1018[8] & (select_1018[6] | select_1018[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1162;
  assign parity_1162 = ^{or_1159, or_1155, or_1151};
  // hls/stages/count_bits.hpp:25
  logic or_1166;
  assign or_1166 = (parity_1044 & parity_1047) | ((^select_1018[2:0]) & (parity_1044 | parity_1047));
  logic or_1170;
  assign or_1170 = (parity_1064 & parity_1067) | ((^select_1058[8:6]) & (parity_1064 | parity_1067));
  logic or_1174;
  assign or_1174 = (parity_1076 & parity_1079) | ((^select_1041[5:3]) & (parity_1076 | parity_1079));
  // hls/stages/count_bits.hpp:24
  logic parity_1177;
  assign parity_1177 = ^{or_1174, or_1170, or_1166};
  logic parity_1180;
  assign parity_1180 = ^{or_1174, or_1170, or_1166, or_1159, or_1155, or_1151, or_1144, or_1140, and_1136};
  logic xor_1181;
  assign xor_1181 = parity_1135 ^ parity_1180;
  // hls/stages/count_bits.hpp:25
  logic and_1182;
  assign and_1182 = parity_1135 & parity_1180;
  logic or_1186;
  assign or_1186 = (parity_1117 & parity_1132) | ((^{or_1098, or_1094, or_1090}) & (parity_1117 | parity_1132));
  logic or_1190;
  assign or_1190 = (parity_1162 & parity_1177) | ((^{or_1144, or_1140, and_1136}) & (parity_1162 | parity_1177));
  logic or_1197;
  assign or_1197 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  logic or_1201;
  assign or_1201 = (or_1110 & or_1114) | (or_1106 & (or_1110 | or_1114));
  logic or_1205;
  assign or_1205 = (or_1125 & or_1129) | (or_1121 & (or_1125 | or_1129));
  // hls/stages/count_bits.hpp:24
  logic parity_1208;
  assign parity_1208 = ^{or_1205, or_1201, or_1197};
  // hls/stages/count_bits.hpp:25
  logic or_1212;
  assign or_1212 = (or_1140 & or_1144) | (and_1136 & (or_1140 | or_1144));
  logic or_1216;
  assign or_1216 = (or_1155 & or_1159) | (or_1151 & (or_1155 | or_1159));
  logic or_1220;
  assign or_1220 = (or_1170 & or_1174) | (or_1166 & (or_1170 | or_1174));
  // hls/stages/count_bits.hpp:24
  logic parity_1223;
  assign parity_1223 = ^{or_1220, or_1216, or_1212};
  logic parity_1226;
  assign parity_1226 = ^{or_1220, or_1216, or_1212, or_1205, or_1201, or_1197, or_1190, or_1186, and_1182};
  // hls/stages/count_bits.hpp:25
  logic or_1230;
  assign or_1230 = (parity_1208 & parity_1223) | ((^{or_1190, or_1186, and_1182}) & (parity_1208 | parity_1223));
  logic or_1234;
  assign or_1234 = (or_1186 & or_1190) | (and_1182 & (or_1186 | or_1190));
  logic or_1238;
  assign or_1238 = (or_1201 & or_1205) | (or_1197 & (or_1201 | or_1205));
  logic or_1242;
  assign or_1242 = (or_1216 & or_1220) | (or_1212 & (or_1216 | or_1220));
  // hls/stages/count_bits.hpp:24
  logic parity_1247;
  assign parity_1247 = ^{or_1242, or_1238, or_1234, or_1230};
  // hls/stages/count_bits.hpp:25
  logic or_1251;
  assign or_1251 = (or_1238 & or_1242) | (or_1234 & (or_1238 | or_1242));
  logic and_1252;
  assign and_1252 = or_1230 & (^{or_1242, or_1238, or_1234});
  // hls/stages/count_bits.hpp:24
  logic xor_1253;
  assign xor_1253 = or_1251 ^ and_1252;
  // hls/stages/count_bits.hpp:27
  logic and_1254;
  assign and_1254 = or_1251 & and_1252;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1255;
  assign select_1255 = equal_593_s1_q ? {and_1254, xor_1253, parity_1247, parity_1226, xor_1181, xor_1086} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_579_s1_q ? 6'h0 : select_1255;
  // hls/stages/agreement.hpp:221
  logic and_1263;
  assign and_1263 = right_codes_rdata_q[27] & not_583_s1_q;
  // hls/stages/agreement.hpp:734
  logic select_1264;
  assign select_1264 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_583_s1_q) : and_1263;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1266;
  assign select_1266 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1267;
  assign select_1267 = slot_s1_q[0] ? (less_582_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1266;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1271;
  assign select_1271 = and_762 ? (select_1264 ? (~(select_764 ^ select_1267)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1277;
  assign parity_1277 = ^select_1271[5:3];
  logic parity_1280;
  assign parity_1280 = ^select_1271[8:6];
  logic parity_1283;
  assign parity_1283 = ^select_1271[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1291;
  assign select_1291 = (slot_s1_q[0] ? and_1263 : and_763) ? (~(select_787 ^ (slot_s1_q[0] ? select_1266 : select_765))) : 12'h0;
  logic [11:0] select_1292;
  assign select_1292 = and_785 ? select_1291 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1295;
  assign parity_1295 = ^select_1292[8:6];
  logic parity_1298;
  assign parity_1298 = ^select_1292[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1306;
  assign select_1306 = (slot_s1_q[0] ? and_763 : and_786) ? (~(select_804 ^ (slot_s1_q[0] ? select_765 : select_788))) : 12'h0;
  logic [11:0] select_1307;
  assign select_1307 = and_802 ? select_1306 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1313;
  assign parity_1313 = ^select_1307[2:0];
  logic parity_1316;
  assign parity_1316 = ^select_1307[5:3];
  logic parity_1319;
  assign parity_1319 = ^select_1307[8:0];
  logic parity_1325;
  assign parity_1325 = ^select_1307[11:9];
  logic parity_1328;
  assign parity_1328 = ^select_1292[2:0];
  logic parity_1331;
  assign parity_1331 = ^{select_1307[11:9], select_1292[5:0]};
  logic parity_1334;
  assign parity_1334 = ^{select_1307, select_1292, select_1271[2:0]};
  logic xor_1335;
  assign xor_1335 = parity_1283 ^ parity_1334;
  // hls/stages/count_bits.hpp:23
  logic or_1339;
  assign or_1339 = (select_1271[1:0] == 2'h3) | (select_1271[2] & (select_1271[0] | select_1271[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1343;
  assign or_1343 = (select_1292[7:6] == 2'h3) | (select_1292[8] & (select_1292[6] | select_1292[7]));
  logic or_1347;
  assign or_1347 = (select_1292[10:9] == 2'h3) | (select_1292[11] & (select_1292[9] | select_1292[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1355;
  assign or_1355 = (select_1307[7:6] == 2'h3) | (select_1307[8] & (~(select_1307[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1359;
  assign or_1359 = (select_1307[1:0] == 2'h3) | (select_1307[2] & (select_1307[0] | select_1307[1]));
  logic or_1363;
  assign or_1363 = (select_1307[4:3] == 2'h3) | (select_1307[5] & (select_1307[3] | select_1307[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1366;
  assign parity_1366 = ^{or_1363, or_1359, or_1355};
  // hls/stages/count_bits.hpp:23
  logic or_1370;
  assign or_1370 = (select_1292[4:3] == 2'h3) | (select_1292[5] & (select_1292[3] | select_1292[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1374;
  assign or_1374 = (select_1307[10:9] == 2'h3) | (select_1307[11] & (select_1307[9] | select_1307[10]));
  logic or_1378;
  assign or_1378 = (select_1292[1:0] == 2'h3) | (select_1292[2] & (select_1292[0] | select_1292[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1381;
  assign parity_1381 = ^{or_1378, or_1374, or_1370};
  logic parity_1384;
  assign parity_1384 = ^{or_1378, or_1374, or_1370, or_1363, or_1359, or_1355, or_1347, or_1343, or_1339};
  // hls/stages/count_bits.hpp:25
  logic and_1385;
  assign and_1385 = parity_1283 & parity_1334;
  logic or_1389;
  assign or_1389 = (parity_1277 & parity_1280) | ((^select_1271[11:9]) & (parity_1277 | parity_1280));
  logic and_1392;
  assign and_1392 = (^{select_1292[11:6], select_1271[2:0]}) & (parity_1319 | parity_1331);
  logic or_1393;
  assign or_1393 = (parity_1319 & parity_1331) | and_1392;
  // hls/stages/count_bits.hpp:23
  logic or_1400;
  assign or_1400 = (select_1271[10:9] == 2'h3) | (select_1271[11] & (select_1271[9] | select_1271[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1404;
  assign or_1404 = (select_1271[4:3] == 2'h3) | (select_1271[5] & (select_1271[3] | select_1271[4]));
  logic or_1408;
  assign or_1408 = (select_1271[7:6] == 2'h3) | (select_1271[8] & (select_1271[6] | select_1271[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1411;
  assign parity_1411 = ^{or_1408, or_1404, or_1400};
  // hls/stages/count_bits.hpp:25
  logic or_1415;
  assign or_1415 = (parity_1295 & parity_1298) | ((^select_1271[2:0]) & (parity_1295 | parity_1298));
  logic or_1419;
  assign or_1419 = (parity_1313 & parity_1316) | ((^select_1307[8:6]) & (parity_1313 | parity_1316));
  logic or_1423;
  assign or_1423 = (parity_1325 & parity_1328) | ((^select_1292[5:3]) & (parity_1325 | parity_1328));
  // hls/stages/count_bits.hpp:24
  logic parity_1426;
  assign parity_1426 = ^{or_1423, or_1419, or_1415};
  logic parity_1429;
  assign parity_1429 = ^{or_1423, or_1419, or_1415, or_1408, or_1404, or_1400, or_1393, or_1389, and_1385};
  logic xor_1430;
  assign xor_1430 = parity_1384 ^ parity_1429;
  // hls/stages/count_bits.hpp:25
  logic and_1431;
  assign and_1431 = parity_1384 & parity_1429;
  logic or_1435;
  assign or_1435 = (parity_1366 & parity_1381) | ((^{or_1347, or_1343, or_1339}) & (parity_1366 | parity_1381));
  logic or_1439;
  assign or_1439 = (parity_1411 & parity_1426) | ((^{or_1393, or_1389, and_1385}) & (parity_1411 | parity_1426));
  logic or_1446;
  assign or_1446 = (or_1343 & or_1347) | (or_1339 & (or_1343 | or_1347));
  logic or_1450;
  assign or_1450 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  logic or_1454;
  assign or_1454 = (or_1374 & or_1378) | (or_1370 & (or_1374 | or_1378));
  // hls/stages/count_bits.hpp:24
  logic parity_1457;
  assign parity_1457 = ^{or_1454, or_1450, or_1446};
  // hls/stages/count_bits.hpp:25
  logic or_1461;
  assign or_1461 = (or_1389 & or_1393) | (and_1385 & (or_1389 | or_1393));
  logic or_1465;
  assign or_1465 = (or_1404 & or_1408) | (or_1400 & (or_1404 | or_1408));
  logic or_1469;
  assign or_1469 = (or_1419 & or_1423) | (or_1415 & (or_1419 | or_1423));
  // hls/stages/count_bits.hpp:24
  logic parity_1472;
  assign parity_1472 = ^{or_1469, or_1465, or_1461};
  logic parity_1475;
  assign parity_1475 = ^{or_1469, or_1465, or_1461, or_1454, or_1450, or_1446, or_1439, or_1435, and_1431};
  // hls/stages/count_bits.hpp:25
  logic or_1479;
  assign or_1479 = (parity_1457 & parity_1472) | ((^{or_1439, or_1435, and_1431}) & (parity_1457 | parity_1472));
  logic or_1483;
  assign or_1483 = (or_1435 & or_1439) | (and_1431 & (or_1435 | or_1439));
  logic or_1487;
  assign or_1487 = (or_1450 & or_1454) | (or_1446 & (or_1450 | or_1454));
  logic or_1491;
  assign or_1491 = (or_1465 & or_1469) | (or_1461 & (or_1465 | or_1469));
  // hls/stages/count_bits.hpp:24
  logic parity_1496;
  assign parity_1496 = ^{or_1491, or_1487, or_1483, or_1479};
  // hls/stages/count_bits.hpp:25
  logic or_1500;
  assign or_1500 = (or_1487 & or_1491) | (or_1483 & (or_1487 | or_1491));
  logic and_1501;
  assign and_1501 = or_1479 & (^{or_1491, or_1487, or_1483});
  // hls/stages/count_bits.hpp:24
  logic xor_1502;
  assign xor_1502 = or_1500 ^ and_1501;
  // hls/stages/count_bits.hpp:27
  logic and_1503;
  assign and_1503 = or_1500 & and_1501;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1504;
  assign select_1504 = equal_593_s1_q ? {and_1503, xor_1502, parity_1496, parity_1475, xor_1430, xor_1335} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_579_s1_q ? 6'h0 : select_1504;
  // hls/stages/agreement.hpp:788
  logic and_1572;
  assign and_1572 = ends_cell_s1_q & inside_v;
  logic and_1574;
  assign and_1574 = not_575 & (so_s1_q & and_1572);
  logic [5:0] select_1578;
  assign select_1578 = so_s1_q ? x_s1_q[5:0] : (or_579_s1_q ? (less_582_s1_q ? 6'h0 : select_626) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1582;
  assign or_1582 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1591;
  assign and_1591 = or_579_s1_q & (slot_s1_q[2] & not_583_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1704;
  assign select_1704 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1704[16:7])) ? 8'h7f : select_1704[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1781_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1781_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_1868;
  assign less_1868 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_1869;
  assign or_1869 = equal_1780_s1_q | less_1868;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1874;
  assign select_1874 = equal_1780_s1_q ? patches_column_s1_q[0] : (or_1869 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1875;
  assign not_1875 = ~or_1869;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_1876;
  assign sum_1876 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_1879;
  assign select_1879 = or_1869 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1876) + 5'h1) : sum_1876;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1880;
  assign select_1880 = equal_1780_s1_q ? 5'h0 : select_1879;
  logic or_1881;
  assign or_1881 = equal_1780_s1_q | equal_1778_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_1883;
  assign equal_1883 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1885;
  assign equal_1885 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1887;
  assign and_1887 = of_row & (~equal_1885);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1883 ? 2'h3 : {equal_1885, and_1887};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1890;
  assign sum_1890 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1891;
  assign sum_1891 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1890, pixel_2[0]} - {1'b0, sum_1891, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1893;
  assign sum_1893 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1894;
  assign sum_1894 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1893[11], sum_1893};
  logic [13:0] sum_1895;
  assign sum_1895 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1894, down_2[1]};
  logic [12:0] sum_1896;
  assign sum_1896 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1895[13:1];
  logic [14:0] sum_1897;
  assign sum_1897 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1896, sum_1895[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_1904;
  assign or_1904 = (sum_1897[8] & (~(sum_1897[7:0] == 8'h0))) | (~(sum_1897[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1909;
  assign sum_1909 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1910;
  assign sum_1910 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1909};
  logic [10:0] sum_1911;
  assign sum_1911 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1910, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1912;
  assign sum_1912 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1911[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1912, sum_1911[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1914;
  assign sum_1914 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1915;
  assign sum_1915 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1916;
  assign difference_1916 = {1'b0, sum_1914, smooth[0]} - {1'b0, sum_1915, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_1923;
  assign or_1923 = (difference_1916[8] & (~(difference_1916[7:0] == 8'h0))) | (~(difference_1916[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_1931;
  assign or_1931 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1885) | equal_1883;
  // hls/stages/patches.hpp:481
  logic and_1936;
  assign and_1936 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:275
  logic and_1940;
  assign and_1940 = not_1779_s1_q & (or_1782_s1_q & (or_1931 & (equal_1781_s1_q & and_1936)));
  // hls/stages/patches.hpp:174
  logic and_1950;
  assign and_1950 = (~(equal_1781_s1_q | (~and_1936))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:275
  logic and_1954;
  assign and_1954 = not_1779_s1_q & (or_1782_s1_q & (and_1950 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_1956;
  assign less_1956 = patches_step_q[4:0] < 5'h11;
  logic equal_1957;
  assign equal_1957 = patches_step_q[6:5] == 2'h2;
  logic equal_1958;
  assign equal_1958 = patches_step_q[6:5] == 2'h1;
  logic or_1959;
  assign or_1959 = equal_1957 | equal_1958;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1989;
  assign sum_1989 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:460
  logic select_2563;
  assign select_2563 = equal_2466_s1_q ? (~({row_s1_q, 1'b0} < {sum_2560, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2824;
  assign and_2824 = and_549_s1_q & (equal_2466_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2825;
  assign and_2825 = and_2467_s1_q & and_2824;
  // hls/stages/registration.hpp:127
  logic and_2827;
  assign and_2827 = and_2467_s1_q & (~and_2824);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2828;
  assign select_2828 = and_2827 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2830;
  assign select_2830 = and_2825 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2828[15]}}, select_2828});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2831;
  assign select_2831 = and_2827 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2831[15]}}, select_2831};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2833;
  assign select_2833 = and_2825 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2834;
  assign and_2834 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2834 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3078;
  assign select_3078 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:275
  logic [11:0] select_3081;
  assign select_3081 = equal_1778_s1_q ? patches_smooth_values_0_q : (or_1782_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3083;
  assign select_3083 = or_1782_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3085;
  assign select_3085 = equal_1776_s1_q ? patches_smooth_values_1_q : (equal_1778_s1_q ? patches_smooth_values_1_q : select_3083);
  logic [11:0] select_3086;
  assign select_3086 = or_1782_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3088;
  assign select_3088 = equal_1776_s1_q ? patches_smooth_values_2_q : (equal_1778_s1_q ? patches_smooth_values_2_q : select_3086);
  logic [11:0] select_3089;
  assign select_3089 = or_1782_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3091;
  assign select_3091 = equal_1776_s1_q ? patches_smooth_values_3_q : (equal_1778_s1_q ? patches_smooth_values_3_q : select_3089);
  logic [10:0] select_3093;
  assign select_3093 = equal_1778_s1_q ? patches_down_values_0_q : (or_1782_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3096;
  assign select_3096 = equal_1778_s1_q ? patches_down_values_1_q : (or_1782_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3099;
  assign select_3099 = equal_1778_s1_q ? patches_down_values_2_q : (or_1782_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3102;
  assign select_3102 = equal_1778_s1_q ? patches_down_values_3_q : (or_1782_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3139;
  assign and_3139 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3144;
  assign select_3144 = or_3039_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3146;
  assign select_3146 = and_3139 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3502;
  assign select_3502 = equal_1776_s1_q ? patches_summed_down_by_q : (equal_1778_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3520;
  assign select_3520 = equal_1776_s1_q ? (less_1956 & (equal_1958 & or_1959)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3823;
  assign select_3823 = so_s1_q ? (and_2834 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3825;
  assign sum_3825 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3826;
  assign select_3826 = sum_1989[5] ? {1'b1, sum_1989[4:0], region_across_rest_q[2:0]} : sum_3825;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3828;
  assign select_3828 = equal_2466_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3831;
  assign select_3831 = equal_2466_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_514_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_523;
`endif
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:352; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = last_s1_2_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s1_en & and_549_s1_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 1645 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:1644];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1645; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [10:0] moments_memory_raddr;
  assign moments_memory_raddr = select_573;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_591;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_579_s1_q ? select_626 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_617_s1_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic shown_right_re;
  assign shown_right_re = s1_en & and_1574;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] left_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [5:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic left_turns_re;
  assign left_turns_re = s1_en & and_1591;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_626;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1591;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1880, not_1875, select_1874};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1881;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_1777_s1_q & (new_row & equal_1778_s1_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:821; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
`ifndef SYNTHESIS
  logic patches_rows_re;
  assign patches_rows_re = s1_en & (equal_1776_s1_q & (less_1956 & or_1959));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1405; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_1574;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_650_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_751, left_rdata_q[65:49], and_750, left_rdata_q[47:31], and_749, left_rdata_q[29:13], and_748, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 6'd47) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 6'd47) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [5:0] right_codes_waddr;
  assign right_codes_waddr = x_s1_q[5:0];
  logic right_codes_we;
  assign right_codes_we = s1_en & and_650_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_757, right_codes_rdata_q[84:73], and_756, right_codes_rdata_q[71:60], and_755, right_codes_rdata_q[56:43], and_754, right_codes_rdata_q[41:28], and_753, right_codes_rdata_q[26:13], and_752, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 6'd47) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 6'd47) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s1_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s1_en & and_1862_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_q[23:0], pixel_2};
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
      moments_place_q <= 12'h0;
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
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
    end else if (s1_en) begin
      moments_place_q <= select_572;
      moments_taken_q <= not_575 & (not_577 & (equal_578_s1_q & inside_v));
      moments_starts_q <= not_575 & (not_577 & (equal_578_s1_q & (inside_v & first)));
      row_q <= and_549_s1_q ? (equal_2466_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_549_s1_q ? select_2563 : lower_half_q;
      registration_slope_row_q <= select_2830;
      registration_slope_change_q <= select_2833;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3063_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3063_s1_q & select_3078;
      patches_smooth_values_0_q <= equal_1776_s1_q ? patches_smooth_values_0_q : select_3081;
      patches_smooth_values_1_q <= select_3085;
      patches_smooth_values_2_q <= select_3088;
      patches_smooth_values_3_q <= select_3091;
      patches_down_values_0_q <= equal_1776_s1_q ? patches_down_values_0_q : select_3093;
      patches_down_values_1_q <= equal_1776_s1_q ? patches_down_values_1_q : select_3096;
      patches_down_values_2_q <= equal_1776_s1_q ? patches_down_values_2_q : select_3099;
      patches_down_values_3_q <= equal_1776_s1_q ? patches_down_values_3_q : select_3102;
      patches_down_by_q <= or_3039_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3139});
      patches_along_q <= select_3144;
      patches_match_row_q <= or_3039_s1_q ? 4'h0 : select_3146;
      patches_summed_last_q <= not_1777_s1_q & (equal_1778_s1_q & and_3139);
      patches_summed_down_by_q <= select_3502;
      patches_step_q <= or_3039_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3520;
      region_across_rest_q <= select_3823;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3826;
      columns_begin_rest_q <= and_549_s1_q ? select_3828 : columns_begin_rest_q;
      columns_begin_back_q <= and_549_s1_q ? select_3831 : columns_begin_back_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_columns_values_0_q = 6'h0;
    sums_0_columns_values_1_q = 6'h0;
    sums_0_columns_values_2_q = 6'h0;
    sums_0_columns_values_3_q = 6'h0;
    sums_0_columns_values_4_q = 6'h0;
    sums_0_columns_values_5_q = 6'h0;
    sums_0_columns_values_6_q = 6'h0;
    sums_0_columns_values_7_q = 6'h0;
    sums_0_columns_values_8_q = 6'h0;
    sums_0_columns_values_9_q = 6'h0;
    sums_0_columns_values_10_q = 6'h0;
    sums_0_columns_values_11_q = 6'h0;
    sums_0_columns_values_12_q = 6'h0;
    sums_0_columns_values_13_q = 6'h0;
    sums_1_columns_values_0_q = 6'h0;
    sums_1_columns_values_1_q = 6'h0;
    sums_1_columns_values_2_q = 6'h0;
    sums_1_columns_values_3_q = 6'h0;
    sums_1_columns_values_4_q = 6'h0;
    sums_1_columns_values_5_q = 6'h0;
    sums_1_columns_values_6_q = 6'h0;
    sums_1_columns_values_7_q = 6'h0;
    sums_1_columns_values_8_q = 6'h0;
    sums_1_columns_values_9_q = 6'h0;
    sums_1_columns_values_10_q = 6'h0;
    sums_1_columns_values_11_q = 6'h0;
    sums_1_columns_values_12_q = 6'h0;
    sums_1_columns_values_13_q = 6'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      sums_0_columns_values_0_q <= column_2;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_columns_values_7_q <= sums_0_columns_values_6_q;
      sums_0_columns_values_8_q <= sums_0_columns_values_7_q;
      sums_0_columns_values_9_q <= sums_0_columns_values_8_q;
      sums_0_columns_values_10_q <= sums_0_columns_values_9_q;
      sums_0_columns_values_11_q <= sums_0_columns_values_10_q;
      sums_0_columns_values_12_q <= sums_0_columns_values_11_q;
      sums_0_columns_values_13_q <= sums_0_columns_values_12_q;
      sums_1_columns_values_0_q <= column_3;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_columns_values_7_q <= sums_1_columns_values_6_q;
      sums_1_columns_values_8_q <= sums_1_columns_values_7_q;
      sums_1_columns_values_9_q <= sums_1_columns_values_8_q;
      sums_1_columns_values_10_q <= sums_1_columns_values_9_q;
      sums_1_columns_values_11_q <= sums_1_columns_values_10_q;
      sums_1_columns_values_12_q <= sums_1_columns_values_11_q;
      sums_1_columns_values_13_q <= sums_1_columns_values_12_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic left_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_present_s2_q;
  logic moments_starts_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [5:0] last_s2_q;
  logic [3:0] age_s2_q;
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
  logic [2:0] select_510_s2_q;
  logic row_starts_s2_q;
  logic [7:0] select_514_s2_q;
  logic and_522_s2_q;
  logic and_523_s2_q;
  logic equal_528_s2_q;
  logic [5:0] select_543_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_547_s2_q;
  logic and_549_s2_q;
  logic equal_569_s2_q;
  logic [10:0] select_573_s2_q;
  logic equal_574_s2_q;
  logic not_575_s2_q;
  logic so_s2_q;
  logic not_577_s2_q;
  logic equal_578_s2_q;
  logic or_579_s2_q;
  logic less_582_s2_q;
  logic not_583_s2_q;
  logic inside_v_s2_q;
  logic not_587_s2_q;
  logic and_591_s2_q;
  logic and_600_s2_q;
  logic and_608_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_639_s2_q;
  logic and_644_s2_q;
  logic and_646_s2_q;
  logic equal_679_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1257_s2_q;
  logic [5:0] select_1506_s2_q;
  logic and_1561_s2_q;
  logic equal_1562_s2_q;
  logic and_1572_s2_q;
  logic and_1574_s2_q;
  logic [5:0] select_1578_s2_q;
  logic or_1582_s2_q;
  logic and_1685_s2_q;
  logic less_1699_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1776_s2_q;
  logic equal_1778_s2_q;
  logic equal_1781_s2_q;
  logic or_1782_s2_q;
  logic not_1783_s2_q;
  logic [4:0] select_1806_s2_q;
  logic select_1812_s2_q;
  logic [3:0] select_1852_s2_q;
  logic less_1868_s2_q;
  logic new_row_s2_q;
  logic or_1881_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1898_s2_q;
  logic or_1904_s2_q;
  logic and_1908_s2_q;
  logic and_1924_s2_q;
  logic and_1927_s2_q;
  logic and_1941_s2_q;
  logic and_1950_s2_q;
  logic and_1955_s2_q;
  logic less_1956_s2_q;
  logic equal_1957_s2_q;
  logic or_1959_s2_q;
  logic and_1968_s2_q;
  logic select_1970_s2_q;
  logic and_1973_s2_q;
  logic sum_1989_s2_q;
  logic and_2010_s2_q;
  logic and_2128_s2_q;
  logic equal_2277_s2_q;
  logic equal_2466_s2_q;
  logic and_2593_s2_q;
  logic equal_2678_s2_q;
  logic less_3115_s2_q;
  logic equal_3458_s2_q;
  logic equal_3555_s2_q;
  logic less_3811_s2_q;
  logic equal_4030_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      moments_starts_s2_q <= moments_starts_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q;
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
      select_510_s2_q <= select_510_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_514_s2_q <= select_514_s1_q;
      and_522_s2_q <= and_522_s1_q;
      and_523_s2_q <= and_523;
      equal_528_s2_q <= equal_528_s1_q;
      select_543_s2_q <= select_543_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_547_s2_q <= and_547_s1_q;
      and_549_s2_q <= and_549_s1_q;
      equal_569_s2_q <= equal_569;
      select_573_s2_q <= select_573;
      equal_574_s2_q <= equal_574_s1_q;
      not_575_s2_q <= not_575;
      so_s2_q <= so_s1_q;
      not_577_s2_q <= not_577;
      equal_578_s2_q <= equal_578_s1_q;
      or_579_s2_q <= or_579_s1_q;
      less_582_s2_q <= less_582_s1_q;
      not_583_s2_q <= not_583_s1_q;
      inside_v_s2_q <= inside_v;
      not_587_s2_q <= not_587;
      and_591_s2_q <= and_591;
      and_600_s2_q <= or_579_s1_q & (left_rdata_q[70] & not_583_s1_q);
      and_608_s2_q <= (or_579_s1_q & (left_rdata_q[68] & not_583_s1_q)) & and_607;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_639_s2_q <= or_579_s1_q & (left_rdata_q[71] & not_583_s1_q);
      and_644_s2_q <= or_579_s1_q & (right_codes_rdata_q[58] & not_583_s1_q);
      and_646_s2_q <= or_579_s1_q & (right_codes_rdata_q[59] & not_583_s1_q);
      equal_679_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1257_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1506_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1561_s2_q <= and_1561_s1_q;
      equal_1562_s2_q <= equal_1562_s1_q;
      and_1572_s2_q <= and_1572;
      and_1574_s2_q <= and_1574;
      select_1578_s2_q <= select_1578;
      or_1582_s2_q <= or_1582;
      and_1685_s2_q <= and_1685_s1_q;
      less_1699_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1776_s2_q <= equal_1776_s1_q;
      equal_1778_s2_q <= equal_1778_s1_q;
      equal_1781_s2_q <= equal_1781_s1_q;
      or_1782_s2_q <= or_1782_s1_q;
      not_1783_s2_q <= not_1783_s1_q;
      select_1806_s2_q <= select_1806_s1_q;
      select_1812_s2_q <= select_1812_s1_q;
      select_1852_s2_q <= select_1852_s1_q;
      less_1868_s2_q <= less_1868;
      new_row_s2_q <= new_row;
      or_1881_s2_q <= or_1881;
      of_row_2_s2_q <= of_row_2;
      not_1898_s2_q <= ~sum_1897[14];
      or_1904_s2_q <= or_1904;
      and_1908_s2_q <= sum_1897[14] & (~(sum_1897[13:8] == 6'h3f));
      and_1924_s2_q <= (~difference_1916[14]) & or_1923;
      and_1927_s2_q <= difference_1916[14] & (~(difference_1916[13:8] == 6'h3f));
      and_1941_s2_q <= not_1777_s1_q & and_1940;
      and_1950_s2_q <= and_1950;
      and_1955_s2_q <= not_1777_s1_q & and_1954;
      less_1956_s2_q <= less_1956;
      equal_1957_s2_q <= equal_1957;
      or_1959_s2_q <= or_1959;
      and_1968_s2_q <= sample_pair_whole_q;
      select_1970_s2_q <= left_first_q;
      and_1973_s2_q <= right_q;
      sum_1989_s2_q <= sum_1989[5];
      and_2010_s2_q <= or_579_s1_q & (left_rdata_q[69] & not_583_s1_q);
      and_2128_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2277_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2466_s2_q <= equal_2466_s1_q;
      and_2593_s2_q <= or_579_s1_q & (not_583_s1_q & and_607);
      equal_2678_s2_q <= shift == 6'h0;
      less_3115_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3458_s2_q <= patches_match_row_q == 4'h0;
      equal_3555_s2_q <= patches_step_q[6:5] == 2'h3;
      less_3811_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4030_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
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
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [7:0] chosen_score_q;
  logic [6:0] chosen_near_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
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
  logic [10:0] map_row_q;
  logic [5:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  logic [9:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [10:0] seen_base_q;
  // hls/stages/census.hpp:117
  logic [11:0] select_526;
  assign select_526 = select_510_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_530;
  assign sum_530 = select_526 + (equal_528_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_532;
  assign sum_532 = {4'h0, sample_pair_pixel_1_q} + (select_510_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_534;
  assign sum_534 = sum_532 + (equal_528_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_510_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_538;
  assign and_538 = whole & (averager_memory_rdata_q[24] | equal_528_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_510_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_542;
  assign and_542 = all_of_skin & (averager_memory_rdata_q[25] | equal_528_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_522_s2_q ? sum_530[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_552;
  assign equal_552 = select_510_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_552 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_555;
  assign select_555 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_522_s2_q ? sum_534[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_552 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_559;
  assign select_559 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_560;
  assign and_560 = and_522_s2_q & and_538;
  // hls/stages/census.hpp:134
  logic select_562;
  assign select_562 = equal_552 ? and_560 : (averager_mask_q & and_560);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_562;
  // hls/stages/census.hpp:218
  logic and_564;
  assign and_564 = and_522_s2_q & and_542;
  // hls/stages/census.hpp:134
  logic select_566;
  assign select_566 = equal_552 ? and_564 : (averager_of_skin_q & and_564);
  // hls/stages/agreement.hpp:276
  logic and_567;
  assign and_567 = sample_pair_whole_s2_q & select_566;
  // hls/stages/agreement.hpp:978
  logic select_621;
  assign select_621 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_631;
  assign difference_631 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_632;
  assign sum_632 = {difference_631[8], difference_631} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_634;
  assign and_634 = (and_608_s2_q & select_621) & ({{22{sum_632[9]}}, sum_632} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_636;
  assign and_636 = or_579_s2_q & (not_583_s2_q & and_634);
  // hls/stages/moments.hpp:77
  logic and_637;
  assign and_637 = and_600_s2_q & and_636;
  // hls/stages/census.hpp:308
  logic less_652;
  assign less_652 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_664;
  assign less_664 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_676;
  assign equal_676 = last_s2_2_q == 6'h0;
  logic [3:0] select_680;
  assign select_680 = equal_679_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_681;
  assign select_681 = equal_676 ? {select_680, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_682;
  assign select_682 = equal_676 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_683;
  assign and_683 = select_681[4] & select_682[3];
  // hls/stages/census.hpp:300
  logic and_685;
  assign and_685 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_687;
  assign and_687 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_685);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_687;
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
  logic [9:0] difference_710;
  assign difference_710 = {1'b0, select_555} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_711;
  assign xor_711 = difference_710[8:0] ^ {9{difference_710[9]}};
  logic [9:0] sum_712;
  assign sum_712 = {9'h0, difference_710[9]} + {1'b0, xor_711};
  logic [9:0] difference_713;
  assign difference_713 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_714;
  assign xor_714 = difference_713[8:0] ^ {9{difference_713[9]}};
  logic [9:0] sum_715;
  assign sum_715 = {9'h0, difference_713[9]} + {1'b0, xor_714};
  logic [9:0] difference_717;
  assign difference_717 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_718;
  assign xor_718 = difference_717[8:0] ^ {9{difference_717[9]}};
  logic [9:0] sum_719;
  assign sum_719 = {9'h0, difference_717[9]} + {1'b0, xor_718};
  logic [10:0] sum_720;
  assign sum_720 = ({1'b0, sum_712} + {1'b0, sum_715}) + {1'b0, sum_719};
  logic [9:0] difference_721;
  assign difference_721 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_722;
  assign xor_722 = difference_721[8:0] ^ {9{difference_721[9]}};
  logic [9:0] sum_723;
  assign sum_723 = {9'h0, difference_721[9]} + {1'b0, xor_722};
  logic [9:0] difference_725;
  assign difference_725 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_726;
  assign xor_726 = difference_725[8:0] ^ {9{difference_725[9]}};
  // hls/stages/agreement.hpp:456
  logic and_734;
  assign and_734 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_735;
  assign and_735 = and_683 & and_734;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_737;
  assign sum_737 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_739;
  assign and_739 = and_735 & ({{5{sum_737[6]}}, sum_737, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_743;
  assign sum_743 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_759;
  assign or_759 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_761;
  assign select_761 = or_759 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1008;
  assign select_1008 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1009;
  assign difference_1009 = {1'b0, column_s2_q} - {1'b0, select_1008};
  logic [7:0] sum_1011;
  assign sum_1011 = {difference_1009[6], difference_1009} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1012;
  assign select_1012 = slot_s2_q[0] ? chosen_score_q : sum_1011;
  // hls/stages/agreement.hpp:778
  logic [6:0] difference_1258;
  assign difference_1258 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1257_s2_q};
  // hls/stages/agreement.hpp:749
  logic equal_1259;
  assign equal_1259 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1261;
  assign sum_1261 = {difference_1258[6], difference_1258} + (equal_1259 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1507;
  assign difference_1507 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1506_s2_q};
  logic [7:0] sum_1509;
  assign sum_1509 = {difference_1507[6], difference_1507} + (equal_1259 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:751
  logic less_1510;
  assign less_1510 = sum_1261 < sum_1509;
  logic [7:0] select_1511;
  assign select_1511 = less_1510 ? sum_1509 : sum_1261;
  logic less_1512;
  assign less_1512 = select_1012 < select_1511;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1512 ? select_1511 : select_1012) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1516;
  assign or_1516 = select_761 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1517;
  assign select_1517 = or_1516 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:720
  logic not_1518;
  assign not_1518 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1519;
  assign select_1519 = less_1510 ? {slot_s2_q[0], not_1518} : 2'h0;
  logic [2:0] select_1521;
  assign select_1521 = less_1512 ? {select_1519, not_1518} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1522;
  assign select_1522 = or_1516 ? select_1521 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1523;
  assign select_1523 = or_1516 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1524;
  assign equal_1524 = select_1521 == 3'h1;
  logic or_1527;
  assign or_1527 = equal_1524 | (~(select_1521 == 3'h2));
  logic [7:0] select_1529;
  assign select_1529 = or_1527 ? before_0_q : before_1_q;
  logic [7:0] select_1530;
  assign select_1530 = equal_1524 ? (or_1527 ? sum_1261 : {7'h0, shift_not_right_q}) : select_1529;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1531;
  assign select_1531 = or_1516 ? select_1530 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1534;
  assign select_1534 = or_1516 ? (equal_1524 ? select_1529 : (or_1527 ? sum_1509 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1536;
  assign sum_1536 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, before_v} + sum_1536;
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1538;
  assign select_1538 = slot_s2_q[0] ? chosen_near_q : sum_1537;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1540;
  assign sum_1540 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, before_v_2} + sum_1540;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1543;
  assign sum_1543 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1544;
  assign sum_1544 = {1'b0, before_v_3} + sum_1543;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1546;
  assign select_1546 = (sum_1541 < sum_1544) ? sum_1544 : sum_1541;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1538 < select_1546) ? select_1546 : select_1538) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1550;
  assign less_1550 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_1552;
  assign select_1552 = select_761 ? of_near : (less_1550 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1554;
  assign select_1554 = select_761 ? run_shift_s2_q : (less_1550 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1557;
  assign select_1557 = (run_shift_s2_q == 6'h3f) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1560;
  assign select_1560 = (run_shift_s2_q == 6'h1) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_1563;
  assign select_1563 = or_759 ? shift_first_s2_q : equal_1562_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_1565;
  assign or_1565 = select_1563 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1566;
  assign select_1566 = or_1565 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1567;
  assign select_1567 = or_1565 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1569;
  assign or_1569 = select_1563 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_1570;
  assign select_1570 = or_1569 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1571;
  assign select_1571 = or_1569 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1585;
  assign and_1585 = or_579_s2_q & (not_583_s2_q & (and_634 & or_1582_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_1586;
  assign and_1586 = not_577_s2_q & and_1585;
  logic and_1589;
  assign and_1589 = not_575_s2_q & (so_s2_q ? and_1572_s2_q : (equal_578_s2_q & and_636));
  // hls/stages/moments.hpp:73
  logic and_1593;
  assign and_1593 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1594;
  assign and_1594 = not_587_s2_q & and_1593;
  logic and_1597;
  assign and_1597 = not_587_s2_q & (and_1593 & (moments_memory_rdata_q[1] ^ and_639_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1602;
  assign and_1602 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1603;
  assign and_1603 = not_587_s2_q & and_1602;
  logic and_1606;
  assign and_1606 = not_587_s2_q & (and_1602 & (moments_memory_rdata_q[3] ^ and_646_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_1607;
  assign equal_1607 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1610;
  assign select_1610 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1612;
  assign select_1612 = equal_1607 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1610});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1613;
  assign sum_1613 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1614;
  assign select_1614 = equal_574_s2_q ? select_1612 : {sum_1613, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1615;
  assign equal_1615 = x_s2_q[5:0] == 6'h3f;
  logic equal_1617;
  assign equal_1617 = x_s2_q[5:0] == 6'h3e;
  logic equal_1619;
  assign equal_1619 = x_s2_q[5:0] == 6'h3d;
  logic equal_1621;
  assign equal_1621 = x_s2_q[5:0] == 6'h3c;
  logic equal_1623;
  assign equal_1623 = x_s2_q[5:0] == 6'h3b;
  logic equal_1625;
  assign equal_1625 = x_s2_q[5:0] == 6'h36;
  logic equal_1627;
  assign equal_1627 = x_s2_q[5:0] == 6'h35;
  logic equal_1629;
  assign equal_1629 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1633;
  assign and_1633 = (~equal_1623) & ((~equal_1625) & ((~equal_1627) & (~equal_1629)));
  logic and_1637;
  assign and_1637 = (~equal_1615) & ((~equal_1617) & ((~equal_1619) & ((~equal_1621) & and_1633)));
  // hls/stages/agreement.hpp:1129
  logic less_1638;
  assign less_1638 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1642;
  assign or_1642 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [4:0] sum_1647;
  assign sum_1647 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1647, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1653;
  assign sum_1653 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1655;
  assign and_1655 = half_ends & ({{3{sum_1653[4]}}, sum_1653} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_1656;
  assign and_1656 = so_s2_q & and_1655;
  logic select_1657;
  assign select_1657 = equal_574_s2_q ? (x_s2_q[6] & (equal_1607 ? and_1637 : (less_1638 & (~or_1642)))) : and_1656;
  // hls/stages/registration.hpp:258
  logic not_1659;
  assign not_1659 = ~lower_half_s2_q;
  logic [3:0] select_1660;
  assign select_1660 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1659, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1659};
  // hls/stages/patches.hpp:377
  logic [1:0] select_1686;
  assign select_1686 = and_1685_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1687;
  assign select_1687 = and_1685_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1688;
  assign select_1688 = row_starts_s2_q ? {select_1687, select_1686[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1689;
  assign select_1689 = row_starts_s2_q ? select_1686 : patches_fetch_q;
  logic equal_1690;
  assign equal_1690 = select_1689 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_1698;
  assign and_1698 = not_575_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1700;
  assign equal_1700 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_579_s2_q ? (less_582_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1700 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1708;
  assign select_1708 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1709;
  assign select_1709 = b[1] ? a : 8'h0;
  logic [8:0] sum_1710;
  assign sum_1710 = {{2{select_1708[6]}}, select_1708} + {select_1709[7], select_1709};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1711;
  assign select_1711 = b[2] ? a : 8'h0;
  logic [7:0] select_1712;
  assign select_1712 = b[3] ? a : 8'h0;
  logic [8:0] sum_1713;
  assign sum_1713 = {{2{select_1711[7]}}, select_1711[7:1]} + {select_1712[7], select_1712};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1714;
  assign sum_1714 = {{3{sum_1710[8]}}, sum_1710[8:1]} + {sum_1713[8], sum_1713, select_1711[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1715;
  assign select_1715 = b[4] ? a : 8'h0;
  logic [7:0] select_1716;
  assign select_1716 = b[5] ? a : 8'h0;
  logic [8:0] difference_1717;
  assign difference_1717 = {{2{select_1715[7]}}, select_1715[7:1]} - {select_1716[7], select_1716};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1718;
  assign sum_1718 = {difference_1717, select_1715[0]} + {sum_1714[10], sum_1714[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1700 ? {sum_1718, sum_1714[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1720;
  assign sum_1720 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1723;
  assign and_1723 = less_1699_s2_q & (and_636 & ({{4{sum_1720[9]}}, sum_1720, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1727;
  assign and_1727 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1733;
  assign sum_1733 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1735;
  assign sum_1735 = {sum_1733[9], sum_1733[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_1738;
  assign and_1738 = ($signed(9'h0) < $signed(sum_1733[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1735, sum_1733[0]})));
  logic and_1739;
  assign and_1739 = (~(and_1727 | (equal_569_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1738;
  // hls/stages/agreement.hpp:788
  logic and_1743;
  assign and_1743 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1723 & and_1739)));
  logic and_1744;
  assign and_1744 = not_575_s2_q & and_1743;
  // hls/stages/patches.hpp:157
  logic and_1746;
  assign and_1746 = and_1744 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1747;
  assign select_1747 = and_1746 ? and_1744 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1750;
  assign select_1750 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1752;
  assign select_1752 = and_1746 ? (equal_574_s2_q ? 8'h0 : select_1750) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1755;
  assign select_1755 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_1757;
  assign select_1757 = and_1746 ? (equal_574_s2_q ? 6'h0 : select_1755) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1758;
  assign sum_1758 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1718[9]}}, sum_1718[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1761;
  assign select_1761 = ($signed(sum_1758[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1758[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1700 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1758[12:7])) ? 8'h7f : select_1761);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1766;
  assign select_1766 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1768;
  assign select_1768 = and_1746 ? (equal_574_s2_q ? 8'h0 : select_1766) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1769;
  assign equal_1769 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_1773;
  assign and_1773 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1727 | equal_1769)));
  logic and_1774;
  assign and_1774 = not_575_s2_q & and_1773;
  // hls/stages/patches.hpp:348
  logic and_1775;
  assign and_1775 = patches_chooses_s2_q & and_1774;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1789;
  assign select_1789 = row_starts_s2_q ? select_1687 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1790;
  assign equal_1790 = {patches_choosing_band_s2_q, and_1698} == {select_1789, select_1689[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1889;
  assign sum_1889 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1905;
  assign and_1905 = not_1898_s2_q & or_1904_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1945;
  assign sum_1945 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1976;
  assign select_1976 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1979;
  assign or_1979 = select_1976[7] | (~({select_1976[5], select_1976[3], select_1976[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1982;
  assign or_1982 = select_1976[7] | (~({select_1976[6], select_1976[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1985;
  assign or_1985 = select_1976[7] | (~(select_1976[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1986;
  assign select_1986 = equal_574_s2_q ? x_s2_q[5:0] : {region_row_q, or_1985, or_1982, or_1979};
  // hls/stages/agreement.hpp:1128
  logic not_1987;
  assign not_1987 = ~equal_1607;
  // hls/stages/agreement.hpp:1058
  logic or_1991;
  assign or_1991 = (~sum_1989_s2_q) | equal_1769;
  // hls/stages/agreement.hpp:788
  logic and_1994;
  assign and_1994 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1991));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_579_s2_q & (not_583_s2_q & and_608_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_636;
  // hls/stages/agreement.hpp:149
  logic and_2012;
  assign and_2012 = or_579_s2_q & (not_583_s2_q & and_2010_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2021;
  assign and_2021 = inside_v_s2_q & and_2012;
  // hls/stages/agreement.hpp:1014
  logic select_2022;
  assign select_2022 = slot_s2_q[2] ? shown_shown_q : and_636;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2022);
  // hls/stages/agreement.hpp:1014
  logic select_2025;
  assign select_2025 = slot_s2_q[2] ? shown_nearer_q : and_1585;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2022 ? select_2025 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1271
  logic select_2028;
  assign select_2028 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1275
  logic select_2029;
  assign select_2029 = left_first_s2_q ? select_2028 : read_half_q;
  logic or_2030;
  assign or_2030 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2031;
  assign select_2031 = or_2030 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1277
  logic [9:0] select_2033;
  assign select_2033 = left_first_s2_q ? 10'h1 : (or_2030 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1280
  logic and_2034;
  assign and_2034 = select_2031[8] & select_2033[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2034 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [5:0] select_2037;
  assign select_2037 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2039;
  assign select_2039 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2037});
  // hls/stages/agreement.hpp:1301
  logic equal_2040;
  assign equal_2040 = seen_x_q == 3'h7;
  logic [7:0] select_2042;
  assign select_2042 = and_2034 ? 8'h0 : (seen_column_q + {7'h0, equal_2040});
  // hls/stages/agreement.hpp:1308
  logic [10:0] index;
  assign index = select_2039 + {3'h0, select_2042};
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2044;
  assign sum_2044 = {1'b0, {2{select_2029}}, 2'h0, {2{select_2029}}, 1'b0, {2{select_2029}}, 1'b0, select_2029} + {1'b0, index};
  // hls/stages/agreement.hpp:1274
  logic not_2045;
  assign not_2045 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2047;
  assign and_2047 = not_2045 & (began_q | and_2034);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2049;
  assign select_2049 = and_2034 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2051;
  assign and_2051 = and_2047 & (select_2049 == 3'h0);
  logic less_2052;
  assign less_2052 = select_2042 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2053;
  assign and_2053 = and_2051 & less_2052;
  logic and_2054;
  assign and_2054 = and_1968_s2_q & and_2053;
  // hls/stages/agreement.hpp:278
  logic select_2056;
  assign select_2056 = and_1968_s2_q ? (left_first_s2_q ? and_2053 : and_2054) : and_2054;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2058;
  assign sum_2058 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2058[7], sum_2058, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2060;
  assign sum_2060 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2061;
  assign and_2061 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2062;
  assign and_2062 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2063;
  assign and_2063 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2064;
  assign and_2064 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2066;
  assign sum_2066 = {1'b0, and_2063} + ({1'b0, textured} + {1'b0, and_2064});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2061} + ({2'h0, and_2062} + {1'b0, sum_2066});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2075;
  assign select_2075 = inside_v_s2_q ? (sum_1989_s2_q ? select_1976 : {select_1976[6:0], 1'b0}) : select_1976;
  // hls/stages/agreement.hpp:1050
  logic or_2078;
  assign or_2078 = select_2075[7] | (~({select_2075[5], select_2075[3], select_2075[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2095;
  assign and_2095 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2096;
  assign and_2096 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2097;
  assign and_2097 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2098;
  assign and_2098 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2100;
  assign sum_2100 = {1'b0, and_2097} + ({1'b0, shown} + {1'b0, and_2098});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2095} + ({2'h0, and_2096} + {1'b0, sum_2100});
  // hls/stages/agreement.hpp:1030
  logic and_2111;
  assign and_2111 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2112;
  assign and_2112 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2113;
  assign and_2113 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2114;
  assign and_2114 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2116;
  assign sum_2116 = {1'b0, and_2113} + ({1'b0, near} + {1'b0, and_2114});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2111} + ({2'h0, and_2112} + {1'b0, sum_2116});
  // hls/stages/agreement.hpp:788
  logic and_2132;
  assign and_2132 = ends_cell_s2_q & (and_2128_s2_q & (~({1'b0, sum_1647, last_s2_q[1:0]} < x_s2_q)));
  logic and_2134;
  assign and_2134 = not_575_s2_q & (so_s2_q & and_2132);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2168;
  assign select_2168 = sample_pair_whole_s2_q ? (and_547_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2170;
  assign select_2170 = sample_pair_whole_s2_q ? (and_547_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2190;
  assign select_2190 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2192;
  assign select_2192 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_562 : averager_mask_q) : averager_mask_q;
  logic select_2194;
  assign select_2194 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_566 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2195;
  assign select_2195 = and_549_s2_q ? select_555 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2196;
  assign select_2196 = and_549_s2_q ? select_559 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2198;
  assign select_2198 = and_549_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_549_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2200;
  assign select_2200 = and_549_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2201;
  assign select_2201 = and_549_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_549_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2203;
  assign select_2203 = and_549_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2204;
  assign select_2204 = and_549_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2205;
  assign select_2205 = and_549_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_549_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2207;
  assign select_2207 = and_549_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2208;
  assign select_2208 = and_549_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_549_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2210;
  assign select_2210 = and_549_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2211;
  assign select_2211 = and_549_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_549_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2213;
  assign select_2213 = and_549_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_549_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_549_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2216;
  assign select_2216 = and_549_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_549_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_549_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2219;
  assign select_2219 = and_549_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2220;
  assign select_2220 = and_549_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2221;
  assign select_2221 = and_549_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_549_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2223;
  assign select_2223 = and_549_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2224;
  assign select_2224 = and_549_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_549_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2226;
  assign select_2226 = and_549_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2227;
  assign select_2227 = and_549_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_549_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2229;
  assign select_2229 = and_549_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2230;
  assign select_2230 = and_549_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_549_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2232;
  assign select_2232 = and_549_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2233;
  assign select_2233 = and_549_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_549_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2235;
  assign select_2235 = and_549_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2236;
  assign select_2236 = and_549_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_549_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2238;
  assign select_2238 = and_549_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2239;
  assign select_2239 = and_549_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_549_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2241;
  assign select_2241 = and_549_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2242;
  assign select_2242 = and_549_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2243;
  assign select_2243 = and_549_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_549_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2245;
  assign select_2245 = and_549_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2246;
  assign select_2246 = and_549_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2247;
  assign select_2247 = and_549_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2248;
  assign select_2248 = and_549_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2249;
  assign select_2249 = and_549_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2250;
  assign select_2250 = and_549_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2252;
  assign difference_2252 = {1'b0, select_559} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2253;
  assign xor_2253 = difference_2252[8:0] ^ {9{difference_2252[9]}};
  logic [9:0] sum_2254;
  assign sum_2254 = {9'h0, difference_2252[9]} + {1'b0, xor_2253};
  logic [9:0] difference_2255;
  assign difference_2255 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2256;
  assign xor_2256 = difference_2255[8:0] ^ {9{difference_2255[9]}};
  logic [9:0] sum_2257;
  assign sum_2257 = {9'h0, difference_2255[9]} + {1'b0, xor_2256};
  logic [9:0] difference_2259;
  assign difference_2259 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2260;
  assign xor_2260 = difference_2259[8:0] ^ {9{difference_2259[9]}};
  logic [9:0] sum_2261;
  assign sum_2261 = {9'h0, difference_2259[9]} + {1'b0, xor_2260};
  logic [10:0] sum_2262;
  assign sum_2262 = ({1'b0, sum_2254} + {1'b0, sum_2257}) + {1'b0, sum_2261};
  logic [9:0] difference_2263;
  assign difference_2263 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2264;
  assign xor_2264 = difference_2263[8:0] ^ {9{difference_2263[9]}};
  logic [9:0] sum_2265;
  assign sum_2265 = {9'h0, difference_2263[9]} + {1'b0, xor_2264};
  logic [9:0] difference_2267;
  assign difference_2267 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2268;
  assign xor_2268 = difference_2267[8:0] ^ {9{difference_2267[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2289;
  assign sum_2289 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2291;
  assign sum_2291 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2292;
  assign equal_2292 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2293;
  assign select_2293 = equal_2292 ? sum_2289 : moments_before_0_q;
  logic [13:0] select_2295;
  assign select_2295 = equal_2292 ? sum_2291 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2298;
  assign select_2298 = equal_574_s2_q ? (moments_has_before_q | equal_2292) : moments_has_before_q;
  logic [13:0] select_2301;
  assign select_2301 = equal_574_s2_q ? ((select_2295 < select_2293) ? select_2293 : select_2295) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2302;
  assign sum_2302 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2305;
  assign select_2305 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2302)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2306;
  assign sum_2306 = {1'b0, sum_2291} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2309;
  assign select_2309 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2306)) : moments_left_alone_q;
  logic select_2312;
  assign select_2312 = equal_574_s2_q ? (~({3'h0, select_2295[13:2]} < sum_2306)) : moments_left_other_stops_q;
  logic select_2315;
  assign select_2315 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2302)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2316;
  assign sum_2316 = {1'b0, sum_2289} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2319;
  assign select_2319 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2316)) : moments_right_alone_q;
  logic select_2322;
  assign select_2322 = equal_574_s2_q ? (~({3'h0, select_2293[13:2]} < sum_2316)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2325;
  assign or_2325 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2333;
  assign and_2333 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1597)));
  logic and_2337;
  assign and_2337 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1606)));
  // hls/stages/moments.hpp:94
  logic and_2339;
  assign and_2339 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2342;
  assign select_2342 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2339)) : and_2339;
  // hls/stages/agreement.hpp:788
  logic and_2346;
  assign and_2346 = equal_574_s2_q & (equal_2292 & (cfg_prove_i & (cfg_same_table_i & select_2342)));
  // hls/stages/moments.hpp:95
  logic and_2349;
  assign and_2349 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2363;
  assign difference_2363 = {1'b0, select_555} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2363[9]} + (difference_2363[8:0] ^ {9{difference_2363[9]}});
  logic [9:0] difference_2375;
  assign difference_2375 = {1'b0, select_559} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2375[9]} + (difference_2375[8:0] ^ {9{difference_2375[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2566;
  assign select_2566 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2567;
  assign select_2567 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2568;
  assign select_2568 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2569;
  assign select_2569 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2575;
  assign select_2575 = slot_s2_q[0] ? 8'h0 : sum_1011;
  // hls/stages/agreement.hpp:751
  logic less_2576;
  assign less_2576 = select_2575 < select_1511;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2578;
  assign select_2578 = slot_s2_q[0] ? 7'h0 : sum_1537;
  // hls/stages/agreement.hpp:788
  logic not_2583;
  assign not_2583 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2584;
  assign less_2584 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2591;
  assign and_2591 = and_549_s2_q & (equal_679_s2_q & equal_2466_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2597;
  assign and_2597 = not_575_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2593_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2617;
  assign and_2617 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2618;
  assign and_2618 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2619;
  assign and_2619 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2620;
  assign and_2620 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2622;
  assign sum_2622 = {1'b0, and_2619} + ({1'b0, explained} + {1'b0, and_2620});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2617} + ({2'h0, and_2618} + {1'b0, sum_2622});
  // hls/stages/agreement.hpp:788
  logic and_2658;
  assign and_2658 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2593_s2_q & and_2012)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2682;
  assign difference_2682 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2685;
  assign less_2685 = {2'h0, difference_2682[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2688;
  assign and_2688 = not_583_s2_q & (((and_2010_s2_q & and_634) & equal_2678_s2_q) & (~less_2685));
  // hls/stages/agreement.hpp:788
  logic and_2692;
  assign and_2692 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_579_s2_q & and_2688)));
  // hls/stages/agreement.hpp:149
  logic and_2697;
  assign and_2697 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2699;
  assign and_2699 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2700;
  assign select_2700 = or_579_s2_q ? {and_2699, and_2697} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2702;
  assign select_2702 = less_582_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2703;
  assign select_2703 = or_579_s2_q ? select_2702 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2705;
  assign and_2705 = and_636 & (select_2700[0] & select_2703[0]);
  // hls/stages/agreement.hpp:788
  logic and_2709;
  assign and_2709 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2700[1] & and_2705)));
  logic and_2710;
  assign and_2710 = not_575_s2_q & and_2709;
  logic and_2716;
  assign and_2716 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2703[1] & and_2705)));
  logic and_2717;
  assign and_2717 = not_575_s2_q & and_2716;
  // hls/stages/registration.hpp:76
  logic less_2720;
  assign less_2720 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2722;
  assign select_2722 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2724;
  assign select_2724 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2726;
  assign select_2726 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2724} - {1'b0, select_2726};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2728;
  assign select_2728 = rise_2[8] ? select_2724 : select_2726;
  logic [8:0] fall;
  assign fall = {1'b0, select_2722} - {1'b0, select_2728};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2731;
  assign not_2731 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2720 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2731};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2733;
  assign xor_2733 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2733};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2739;
  assign select_2739 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2720 ? {taken, 1'b1} : {not_2731, select_2739, not_2731};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2741;
  assign sum_2741 = {left, 1'b1} + {taken_2, less_2720};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2743;
  assign select_2743 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2745;
  assign select_2745 = equal_574_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2747;
  assign select_2747 = equal_574_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2748;
  assign equal_2748 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2752;
  assign and_2752 = and_636 & less_1699_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2754;
  assign select_2754 = or_579_s2_q ? (less_582_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2758;
  assign sum_2758 = select_2754[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2761;
  assign select_2761 = (select_2724 < select_2726) ? ({sum_2758, select_2754[0], 5'h0} - {3'h0, select_2743}) : {sum_2758, select_2754[0], select_2743};
  logic [7:0] select_2762;
  assign select_2762 = ((select_2754 == 3'h0) | (select_2754 == 3'h4)) ? {sum_2758, select_2754[0], 5'h0} : select_2761;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2762[7]}}, select_2762} - {sum_1718[9], sum_1718, sum_1714[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2765;
  assign select_2765 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2765[11:7])) ? 12'h7f : select_2765;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2786;
  assign difference_2786 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2788;
  assign and_2788 = and_2752 & ($signed(difference_2786) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2801;
  assign less_2801 = $signed(difference_2786) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2809;
  assign select_2809 = so_s2_q ? (equal_2748 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2812;
  assign select_2812 = so_s2_q ? (equal_1700 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2817;
  assign select_2817 = (sum_1613 == 2'h2) ? (registration_fresh_q & (~select_1660)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2819;
  assign select_2819 = so_s2_q ? (and_1655 ? select_2817 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2821;
  assign select_2821 = and_2591 ? 4'hf : (equal_574_s2_q ? registration_fresh_q : select_2819);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1610;
  // hls/stages/registration.hpp:258
  logic not_2842;
  assign not_2842 = ~quarter_2[1];
  logic [3:0] select_2843;
  assign select_2843 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2842, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2842};
  // hls/stages/patches.hpp:91
  logic parity_2977;
  assign parity_2977 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2978;
  assign select_2978 = equal_2466_s2_q ? {patches_chance_q[14:0], parity_2977} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_2980;
  assign not_2980 = ~and_1774;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2982;
  assign select_2982 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2982};
  // hls/stages/agreement.hpp:788
  logic and_2988;
  assign and_2988 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_2992;
  assign and_2992 = not_2980 & (patches_fixed_q | ((not_575_s2_q & and_2988) & and_1746));
  // hls/stages/patches.hpp:358
  logic not_3004;
  assign not_3004 = ~select_1689[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3006;
  assign select_3006 = sample_pair_whole_s2_q ? (equal_1690 ? select_1689 : {not_3004, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:275
  logic [51:0] select_3105;
  assign select_3105 = or_1782_s2_q ? {and_1927_s2_q, and_1924_s2_q, and_1908_s2_q, and_1905, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3107;
  assign select_3107 = equal_1776_s2_q ? patches_codes_at_q : (equal_1778_s2_q ? other[55:4] : select_3105);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1881_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3110;
  assign select_3110 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:275
  logic [27:0] select_3112;
  assign select_3112 = equal_1778_s2_q ? (new_row_s2_q ? word : select_3110) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3114;
  assign select_3114 = less_1868_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3116;
  assign select_3116 = less_3115_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:275
  logic [55:0] select_3118;
  assign select_3118 = or_1782_s2_q ? (equal_1781_s2_q ? patches_next_codes_q : select_3116) : patches_next_codes_q;
  logic [55:0] select_3120;
  assign select_3120 = equal_1776_s2_q ? patches_next_codes_q : (equal_1778_s2_q ? select_3114 : select_3118);
  // hls/stages/count_bits.hpp:24
  logic parity_3125;
  assign parity_3125 = ^{and_1927_s2_q, and_1924_s2_q, and_1908_s2_q, and_1905};
  // hls/stages/count_bits.hpp:25
  logic or_3129;
  assign or_3129 = ({and_1908_s2_q, and_1905} == 2'h3) | (and_1924_s2_q & (and_1908_s2_q | and_1905));
  logic and_3130;
  assign and_3130 = and_1927_s2_q & (^{and_1924_s2_q, and_1908_s2_q, and_1905});
  // hls/stages/count_bits.hpp:24
  logic xor_3131;
  assign xor_3131 = or_3129 ^ and_3130;
  // hls/stages/count_bits.hpp:27
  logic and_3132;
  assign and_3132 = or_3129 & and_3130;
  // hls/stages/agreement.hpp:275
  logic [2:0] select_3134;
  assign select_3134 = or_1782_s2_q ? (and_1950_s2_q ? {and_3132, xor_3131, parity_3125} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3138;
  assign sum_3138 = {7'h0, patches_set_q} + (equal_1781_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3148;
  assign select_3148 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:275
  logic [47:0] select_3150;
  assign select_3150 = equal_1776_s2_q ? patches_left_row_q : (equal_1778_s2_q ? select_3148 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3148;
  // hls/stages/count_bits.hpp:24
  logic xor_3154;
  assign xor_3154 = bits[17] ^ (^{select_3148[16:15], other[16:15]});
  logic xor_3157;
  assign xor_3157 = bits[11] ^ (^{select_3148[10:9], other[10:9]});
  logic xor_3160;
  assign xor_3160 = bits[14] ^ (^{select_3148[13:12], other[13:12]});
  logic xor_3163;
  assign xor_3163 = xor_3154 ^ (^{select_3148[14:9], other[14:9]});
  logic xor_3166;
  assign xor_3166 = bits[47] ^ (^{select_3148[46:45], other[46:45]});
  logic xor_3169;
  assign xor_3169 = bits[8] ^ (^{select_3148[7:6], other[7:6]});
  logic xor_3172;
  assign xor_3172 = bits[2] ^ (^{select_3148[1:0], other[1:0]});
  logic xor_3175;
  assign xor_3175 = bits[5] ^ (^{select_3148[4:3], other[4:3]});
  logic xor_3178;
  assign xor_3178 = xor_3169 ^ (^{select_3148[5:0], other[5:0]});
  logic parity_3180;
  assign parity_3180 = ^{select_3148[47:45], select_3148[8:0], other[47:45], other[8:0]};
  logic xor_3181;
  assign xor_3181 = xor_3163 ^ parity_3180;
  logic xor_3184;
  assign xor_3184 = bits[44] ^ (^{select_3148[43:42], other[43:42]});
  logic xor_3187;
  assign xor_3187 = bits[38] ^ (^{select_3148[37:36], other[37:36]});
  logic xor_3190;
  assign xor_3190 = bits[41] ^ (^{select_3148[40:39], other[40:39]});
  logic xor_3196;
  assign xor_3196 = bits[26] ^ (^{select_3148[25:24], other[25:24]});
  logic xor_3199;
  assign xor_3199 = bits[20] ^ (^{select_3148[19:18], other[19:18]});
  logic xor_3202;
  assign xor_3202 = bits[23] ^ (^{select_3148[22:21], other[22:21]});
  logic xor_3205;
  assign xor_3205 = xor_3196 ^ (^{select_3148[23:18], other[23:18]});
  logic xor_3208;
  assign xor_3208 = bits[35] ^ (^{select_3148[34:33], other[34:33]});
  logic xor_3211;
  assign xor_3211 = bits[29] ^ (^{select_3148[28:27], other[28:27]});
  logic xor_3214;
  assign xor_3214 = bits[32] ^ (^{select_3148[31:30], other[31:30]});
  logic xor_3217;
  assign xor_3217 = xor_3208 ^ (^{select_3148[32:27], other[32:27]});
  logic xor_3218;
  assign xor_3218 = xor_3205 ^ xor_3217;
  // hls/stages/count_bits.hpp:25
  logic or_3226;
  assign or_3226 = (xor_3157 & xor_3160) | (xor_3154 & (xor_3157 | xor_3160));
  logic or_3230;
  assign or_3230 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3234;
  assign or_3234 = (xor_3172 & xor_3175) | (xor_3169 & (xor_3172 | xor_3175));
  // hls/stages/count_bits.hpp:23
  logic or_3241;
  assign or_3241 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3245;
  assign or_3245 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3249;
  assign or_3249 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3252;
  assign parity_3252 = ^{or_3249, or_3245, or_3241};
  // hls/stages/count_bits.hpp:23
  logic or_3256;
  assign or_3256 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3260;
  assign or_3260 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3264;
  assign or_3264 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3267;
  assign parity_3267 = ^{or_3264, or_3260, or_3256};
  logic parity_3270;
  assign parity_3270 = ^{or_3264, or_3260, or_3256, or_3249, or_3245, or_3241, or_3234, or_3230, or_3226};
  // hls/stages/count_bits.hpp:23
  logic or_3274;
  assign or_3274 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3278;
  assign or_3278 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3282;
  assign or_3282 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3290;
  assign or_3290 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3294;
  assign or_3294 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3298;
  assign or_3298 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3301;
  assign parity_3301 = ^{or_3298, or_3294, or_3290};
  // hls/stages/count_bits.hpp:23
  logic or_3305;
  assign or_3305 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3309;
  assign or_3309 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3313;
  assign or_3313 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3316;
  assign parity_3316 = ^{or_3313, or_3309, or_3305};
  logic parity_3319;
  assign parity_3319 = ^{or_3313, or_3309, or_3305, or_3298, or_3294, or_3290, or_3282, or_3278, or_3274};
  // hls/stages/count_bits.hpp:25
  logic or_3323;
  assign or_3323 = (xor_3187 & xor_3190) | (xor_3184 & (xor_3187 | xor_3190));
  logic or_3327;
  assign or_3327 = (xor_3199 & xor_3202) | (xor_3196 & (xor_3199 | xor_3202));
  logic or_3331;
  assign or_3331 = (xor_3211 & xor_3214) | (xor_3208 & (xor_3211 | xor_3214));
  // hls/stages/count_bits.hpp:24
  logic parity_3334;
  assign parity_3334 = ^{or_3331, or_3327, or_3323};
  // hls/stages/count_bits.hpp:25
  logic and_3335;
  assign and_3335 = xor_3181 & (^{xor_3218, select_3148[44:36], other[44:36]});
  logic or_3339;
  assign or_3339 = (xor_3166 & xor_3178) | (xor_3163 & (xor_3166 | xor_3178));
  logic and_3342;
  assign and_3342 = (xor_3184 ^ (^{select_3148[41:36], other[41:36]})) & (xor_3205 | xor_3217);
  logic or_3343;
  assign or_3343 = (xor_3205 & xor_3217) | and_3342;
  // hls/stages/count_bits.hpp:24
  logic parity_3346;
  assign parity_3346 = ^{or_3343, or_3339, and_3335};
  logic parity_3349;
  assign parity_3349 = ^{or_3343, or_3339, and_3335, or_3331, or_3327, or_3323, or_3313, or_3309, or_3305, or_3298, or_3294, or_3290, or_3282, or_3278, or_3274};
  logic parity_3351;
  assign parity_3351 = ^{or_3343, or_3339, and_3335, or_3331, or_3327, or_3323, or_3313, or_3309, or_3305, or_3298, or_3294, or_3290, or_3282, or_3278, or_3274, or_3264, or_3260, or_3256, or_3249, or_3245, or_3241, or_3234, or_3230, or_3226};
  // hls/stages/count_bits.hpp:25
  logic and_3352;
  assign and_3352 = parity_3270 & parity_3349;
  logic or_3356;
  assign or_3356 = (parity_3252 & parity_3267) | ((^{or_3234, or_3230, or_3226}) & (parity_3252 | parity_3267));
  logic or_3360;
  assign or_3360 = (parity_3334 & parity_3346) | (parity_3319 & (parity_3334 | parity_3346));
  logic or_3367;
  assign or_3367 = (parity_3301 & parity_3316) | ((^{or_3282, or_3278, or_3274}) & (parity_3301 | parity_3316));
  logic or_3371;
  assign or_3371 = (or_3327 & or_3331) | (or_3323 & (or_3327 | or_3331));
  logic or_3375;
  assign or_3375 = (or_3339 & or_3343) | (and_3335 & (or_3339 | or_3343));
  // hls/stages/count_bits.hpp:23
  logic or_3382;
  assign or_3382 = (or_3278 & or_3282) | (or_3274 & (or_3278 | or_3282));
  // hls/stages/count_bits.hpp:25
  logic or_3386;
  assign or_3386 = (or_3294 & or_3298) | (or_3290 & (or_3294 | or_3298));
  logic or_3390;
  assign or_3390 = (or_3309 & or_3313) | (or_3305 & (or_3309 | or_3313));
  // hls/stages/count_bits.hpp:24
  logic parity_3393;
  assign parity_3393 = ^{or_3390, or_3386, or_3382};
  // hls/stages/count_bits.hpp:23
  logic or_3397;
  assign or_3397 = (or_3230 & or_3234) | (or_3226 & (or_3230 | or_3234));
  // hls/stages/count_bits.hpp:25
  logic or_3401;
  assign or_3401 = (or_3245 & or_3249) | (or_3241 & (or_3245 | or_3249));
  logic or_3405;
  assign or_3405 = (or_3260 & or_3264) | (or_3256 & (or_3260 | or_3264));
  // hls/stages/count_bits.hpp:24
  logic parity_3408;
  assign parity_3408 = ^{or_3405, or_3401, or_3397};
  logic parity_3411;
  assign parity_3411 = ^{or_3405, or_3401, or_3397, or_3390, or_3386, or_3382, or_3375, or_3371, or_3367};
  logic parity_3413;
  assign parity_3413 = ^{or_3405, or_3401, or_3397, or_3390, or_3386, or_3382, or_3375, or_3371, or_3367, or_3360, or_3356, and_3352};
  // hls/stages/count_bits.hpp:25
  logic or_3417;
  assign or_3417 = (or_3371 & or_3375) | (or_3367 & (or_3371 | or_3375));
  logic or_3421;
  assign or_3421 = (or_3386 & or_3390) | (or_3382 & (or_3386 | or_3390));
  logic or_3425;
  assign or_3425 = (or_3401 & or_3405) | (or_3397 & (or_3401 | or_3405));
  // hls/stages/count_bits.hpp:24
  logic parity_3428;
  assign parity_3428 = ^{or_3425, or_3421, or_3417};
  // hls/stages/count_bits.hpp:25
  logic and_3429;
  assign and_3429 = (^{or_3360, or_3356, and_3352}) & parity_3411;
  logic or_3433;
  assign or_3433 = (or_3356 & or_3360) | (and_3352 & (or_3356 | or_3360));
  logic or_3437;
  assign or_3437 = (parity_3393 & parity_3408) | ((^{or_3375, or_3371, or_3367}) & (parity_3393 | parity_3408));
  // hls/stages/count_bits.hpp:24
  logic parity_3440;
  assign parity_3440 = ^{or_3437, or_3433, and_3429};
  // hls/stages/count_bits.hpp:25
  logic and_3442;
  assign and_3442 = parity_3428 & parity_3440;
  logic or_3446;
  assign or_3446 = (or_3421 & or_3425) | (or_3417 & (or_3421 | or_3425));
  logic or_3450;
  assign or_3450 = (or_3433 & or_3437) | (and_3429 & (or_3433 | or_3437));
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3495;
  assign select_3495 = equal_1778_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3498;
  assign select_3498 = equal_1776_s2_q ? patches_summed_first_q : (equal_1778_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3506;
  assign select_3506 = less_1956_s2_q ? (or_1959_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3509;
  assign select_3509 = less_1956_s2_q ? (or_1959_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3512;
  assign select_3512 = less_1956_s2_q ? (or_1959_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:275
  logic select_3517;
  assign select_3517 = equal_1776_s2_q ? (less_1956_s2_q & (or_1959_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3522;
  assign or_3522 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3523;
  assign and_3523 = patches_read_searches_s2_q & or_3522;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3524;
  assign select_3524 = and_3523 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3524};
  // hls/stages/patches.hpp:559
  logic and_3529;
  assign and_3529 = less_1956_s2_q & (or_1959_s2_q & (equal_1957_s2_q & (away == 6'h3f)));
  logic and_3534;
  assign and_3534 = less_1956_s2_q & (or_1959_s2_q & (equal_1957_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3536;
  assign sum_3536 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3539;
  assign select_3539 = (equal_1957_s2_q & ({sum_3536[6], sum_3536} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3541;
  assign select_3541 = less_1956_s2_q ? (or_1959_s2_q ? select_3539 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3543;
  assign select_3543 = and_3523 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3544;
  assign select_3544 = equal_1776_s2_q ? select_3543[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3545;
  assign select_3545 = equal_1776_s2_q ? select_3543[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3547;
  assign select_3547 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3548;
  assign select_3548 = equal_1776_s2_q ? select_3547 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3549;
  assign select_3549 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3550;
  assign select_3550 = equal_1776_s2_q ? select_3549 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3552;
  assign select_3552 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3554;
  assign select_3554 = equal_1776_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3552) : patches_peak_far_q;
  logic [9:0] select_3557;
  assign select_3557 = equal_1776_s2_q ? (equal_3555_s2_q ? sum_3138 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:788
  logic select_3808;
  assign select_3808 = equal_574_s2_q ? shown_shown_q : (so_s2_q ? select_2022 : shown_shown_q);
  logic select_3810;
  assign select_3810 = equal_574_s2_q ? shown_nearer_q : (so_s2_q ? select_2025 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3812;
  assign sum_3812 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3814;
  assign select_3814 = less_3811_s2_q ? (sum_3812[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3816;
  assign select_3816 = equal_2466_s2_q ? (equal_679_s2_q ? 3'h0 : select_3814) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3821;
  assign select_3821 = equal_574_s2_q ? select_1976 : (so_s2_q ? (ends_cell_s2_q ? select_2075 : select_1976) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3835;
  assign select_3835 = equal_679_s2_q ? {{2{difference_3833[6]}}, difference_3833} : (less_3811_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3837;
  assign select_3837 = and_549_s2_q ? (equal_2466_s2_q ? select_3835 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3839;
  assign select_3839 = equal_679_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3841;
  assign select_3841 = and_549_s2_q ? (equal_2466_s2_q ? select_3839 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3842;
  assign sum_3842 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3843;
  assign select_3843 = sum_3812[7] ? {1'b1, sum_3812[6:0], region_down_rest_q[0]} : sum_3842;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3812[7];
  // hls/stages/agreement.hpp:460
  logic select_3847;
  assign select_3847 = equal_2466_s2_q ? (equal_679_s2_q | (less_3811_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3852;
  assign or_3852 = segment_starts_q | not_577_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3855;
  assign select_3855 = inside_v_s2_q ? (sum_1989_s2_q ? (equal_1769 & or_1991) : or_1991) : or_3852;
  // hls/stages/agreement.hpp:788
  logic select_3858;
  assign select_3858 = equal_574_s2_q ? or_3852 : (so_s2_q ? (ends_cell_s2_q ? select_3855 : or_3852) : or_3852);
  // hls/stages/agreement.hpp:1147
  logic equal_3882;
  assign equal_3882 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4018;
  assign select_4018 = so_s2_q ? (ends_cell_s2_q ? and_2063 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4021;
  assign select_4021 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4023;
  assign select_4023 = equal_574_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4021 : centres_values_0_of_skin_q);
  logic select_4024;
  assign select_4024 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4026;
  assign select_4026 = equal_574_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4024 : centres_values_1_textured_q);
  logic select_4027;
  assign select_4027 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4029;
  assign select_4029 = equal_574_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4027 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4033;
  assign select_4033 = equal_2466_s2_q ? (equal_4030_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4036;
  assign select_4036 = and_549_s2_q ? (equal_2466_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4037;
  assign xor_4037 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4039;
  assign select_4039 = and_1968_s2_q ? (left_first_s2_q ? xor_4037 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4041;
  assign select_4041 = and_1968_s2_q ? (left_first_s2_q ? xor_4037 : select_4039) : write_half_q;
  logic select_4043;
  assign select_4043 = left_first_s2_q ? select_2028 : (and_1968_s2_q ? select_2029 : read_half_q);
  logic and_4047;
  assign and_4047 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4056;
  assign select_4056 = left_first_s2_q ? 10'h1 : (and_1968_s2_q ? select_2033 : rows_passed_q);
  logic [8:0] select_4059;
  assign select_4059 = left_first_s2_q ? {select_2031[7:0], or_2030} : (and_1968_s2_q ? {select_2031[7:0], or_2030} : columns_passed_q);
  logic select_4062;
  assign select_4062 = left_first_s2_q ? marks_last_s2_q : (and_1968_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4065;
  assign select_4065 = left_first_s2_q ? and_2047 : (and_1968_s2_q ? and_2047 : began_q);
  logic [2:0] select_4068;
  assign select_4068 = left_first_s2_q ? select_2049 : (and_1968_s2_q ? select_2049 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4073;
  assign select_4073 = left_first_s2_q ? 3'h0 : (and_2034 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4075;
  assign select_4075 = left_first_s2_q ? 3'h0 : (and_1968_s2_q ? select_4073 : seen_y_q);
  logic [7:0] select_4078;
  assign select_4078 = left_first_s2_q ? select_2042 : (and_1968_s2_q ? select_2042 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4084;
  assign select_4084 = left_first_s2_q ? select_4082 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4086;
  assign select_4086 = left_first_s2_q ? select_4082 : (and_1968_s2_q ? select_4084 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4091;
  assign and_4091 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4093;
  assign select_4093 = left_first_s2_q ? and_4091 : (and_1968_s2_q ? and_4091 : at_cell_end_q);
  logic select_4096;
  assign select_4096 = left_first_s2_q ? next_row : (and_1968_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4099;
  assign select_4099 = left_first_s2_q ? 11'h0 : (and_1968_s2_q ? select_2039 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4172;
  assign not_4172 = ~quarter[1];
  logic [3:0] select_4173;
  assign select_4173 = quarter[0] ? {quarter[1], 1'b0, not_4172, 1'b0} : {1'b0, quarter[1], 1'b0, not_4172};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1614;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1657;
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 12, hls/stages/patches.hpp:777; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1688;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1690));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1398; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1986;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_574_s2_q ? (x_s2_q[6] & not_1987) : and_1994);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2044;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2056;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_514_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_523_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_542, and_538, sum_534, sum_530};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 8'd189) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 8'd189) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = last_s2_2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_549_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_567, whole_2, select_559, select_555};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 6'd47) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 6'd47) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory moments_memory, write
  logic [10:0] moments_memory_waddr;
  assign moments_memory_waddr = select_573_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_591_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_646_s2_q, and_644_s2_q, and_639_s2_q, and_637};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 11'd1645) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 11'd1645) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1561_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1560, select_1557, select_1554, select_1552, select_1534, select_1531, select_1523, select_1522, select_1517};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s1_sim;
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
      if (best_left_waddr >= 6'd47) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 6'd47) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = right_s2_q;
  logic best_right_we;
  assign best_right_we = s2_en & and_1561_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1571, select_1570, select_1567, select_1566};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 6'd47) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 6'd47) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_1578_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1589;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1586, not_577_s2_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 6'd47) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 6'd47) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory left_turns, write
  logic [5:0] left_turns_waddr;
  assign left_turns_waddr = x_s2_q[5:0];
  logic left_turns_we;
  assign left_turns_we = s2_en & moments_taken_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1597, and_1594};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 6'd47) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 6'd47) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [5:0] right_turns_waddr;
  assign right_turns_waddr = x_s2_q[5:0];
  logic right_turns_we;
  assign right_turns_we = s2_en & moments_taken_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1606, and_1603};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 6'd47) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 6'd47) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1889, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1941_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1927_s2_q, and_1924_s2_q, and_1908_s2_q, and_1905, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1945, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1955_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1927_s2_q, and_1924_s2_q, and_1908_s2_q, and_1905, patches_codes_at_q[51:8]};
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
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s2_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s2_en & and_1574_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2021, textured};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 6'd47) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 6'd47) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
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
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
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
      map_row_q <= 11'h0;
      map_width_q <= 6'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
      rows_passed_q <= 10'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 11'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2190;
      averager_mask_q <= select_2192;
      averager_of_skin_q <= select_2194;
      census_filled_q <= and_549_s2_q ? {select_682[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2289;
      moments_turned_1_q <= sum_2291;
      moments_before_0_q <= equal_574_s2_q ? select_2293 : moments_before_0_q;
      moments_before_1_q <= equal_574_s2_q ? select_2295 : moments_before_1_q;
      moments_has_before_q <= select_2298;
      moments_most_before_q <= select_2301;
      moments_left_begins_q <= select_2305;
      moments_left_alone_q <= select_2309;
      moments_left_other_stops_q <= select_2312;
      moments_right_begins_q <= select_2315;
      moments_right_alone_q <= select_2319;
      moments_right_other_stops_q <= select_2322;
      moments_out_of_step_q <= or_2325;
      moments_turns_0_q <= and_2333;
      moments_turns_1_q <= and_2337;
      moments_begins_alone_q <= and_2346;
      moments_ends_q <= equal_574_s2_q & (equal_2292 & (not_2347 | and_2349));
      rows_passed_above_q <= and_549_s2_q ? select_681 : rows_passed_above_q;
      chosen_score_q <= less_2576 ? select_1511 : select_2575;
      chosen_near_q <= (select_2578 < select_1546) ? select_1546 : select_2578;
      chosen_place_q <= less_2576 ? {select_1519, not_1518} : 3'h2;
      before_0_q <= select_2575;
      before_1_q <= sum_1261;
      before_2_q <= sum_1509;
      shift_allowed_q <= not_2583 & (~less_2584);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2591 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2710});
      counts_turned_right_q <= and_2591 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2717});
      registration_displacement_over_q <= so_s2_q ? sum_2741[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2743;
      registration_slope_here_q <= select_2745;
      registration_expected_q <= select_2747;
      registration_of_right_q <= equal_574_s2_q ? registration_of_right_q : select_2809;
      registration_was_inside_q <= equal_574_s2_q ? registration_was_inside_q : select_2812;
      registration_fresh_q <= select_2821;
      patches_chance_q <= and_549_s2_q ? select_2978 : patches_chance_q;
      patches_fixed_q <= and_2992;
      patches_choice_valid_q <= and_1774 ? (select_1747 & not_2980) : select_1747;
      patches_choice_column_q <= select_1752;
      patches_choice_shift_q <= select_1757;
      patches_choice_slope_q <= select_1768;
      patches_band_q <= sample_pair_whole_s2_q ? select_1789 : patches_band_q;
      patches_fetch_q <= select_3006;
      patches_codes_at_q <= select_3107;
      patches_codes_further_q <= equal_1776_s2_q ? patches_codes_further_q : select_3112;
      patches_next_codes_q <= select_3120;
      patches_set_q <= equal_1776_s2_q ? 3'h0 : (equal_1778_s2_q ? 3'h0 : select_3134);
      patches_size_q <= sum_3138;
      patches_left_row_q <= select_3150;
      patches_summed_row_column_q <= equal_1776_s2_q ? patches_summed_row_column_q : select_3495;
      patches_summed_first_q <= select_3498;
      patches_read_row_differing_q <= equal_1776_s2_q ? select_3506 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1776_s2_q ? select_3509 : patches_read_row_column_q;
      patches_read_at_q <= equal_1776_s2_q ? select_3512 : patches_read_at_q;
      patches_read_first_q <= select_3517;
      patches_read_above_q <= equal_1776_s2_q ? and_3529 : patches_read_above_q;
      patches_read_below_q <= equal_1776_s2_q ? and_3534 : patches_read_below_q;
      patches_read_far_q <= equal_1776_s2_q ? select_3541 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3544;
      patches_peak_best_column_q <= select_3545;
      patches_peak_row_q <= equal_1776_s2_q ? select_3524 : patches_peak_row_q;
      patches_peak_above_q <= select_3548;
      patches_peak_below_q <= select_3550;
      patches_peak_far_q <= select_3554;
      patches_peak_size_q <= select_3557;
      patches_frame_ended_q <= equal_574_s2_q & equal_2292;
      shown_shown_q <= select_3808;
      shown_nearer_q <= select_3810;
      region_row_q <= and_549_s2_q ? select_3816 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3821;
      region_down_rest_q <= select_3837;
      region_down_back_q <= select_3841;
      region_down_next_q <= select_3843;
      region_fresh_q <= and_549_s2_q ? select_3847 : region_fresh_q;
      segment_starts_q <= select_3858;
      centres_values_0_textured_q <= equal_574_s2_q ? centres_values_0_textured_q : select_4018;
      centres_values_0_of_skin_q <= select_4023;
      centres_values_1_textured_q <= select_4026;
      centres_values_1_of_skin_q <= select_4029;
      map_row_q <= and_549_s2_q ? select_4033 : map_row_q;
      map_width_q <= select_4036;
      write_half_q <= select_4041;
      read_half_q <= and_1968_s2_q ? select_4043 : read_half_q;
      done_q <= and_1968_s2_q ? (not_2045 & and_4047) : and_4047;
      drew_q <= so_s2_q;
      said_q <= equal_574_s2_q & equal_3882;
      rows_passed_q <= and_1968_s2_q ? select_4056 : rows_passed_q;
      columns_passed_q <= and_1968_s2_q ? select_4059 : columns_passed_q;
      line_ended_q <= and_1968_s2_q ? select_4062 : line_ended_q;
      began_q <= and_1968_s2_q ? select_4065 : began_q;
      seen_x_q <= and_1968_s2_q ? select_4068 : seen_x_q;
      seen_y_q <= and_1968_s2_q ? select_4075 : seen_y_q;
      seen_column_q <= and_1968_s2_q ? select_4078 : seen_column_q;
      seen_rows_left_q <= and_1968_s2_q ? select_4086 : seen_rows_left_q;
      at_cell_end_q <= and_1968_s2_q ? select_4093 : at_cell_end_q;
      was_next_row_q <= and_1968_s2_q ? select_4096 : was_next_row_q;
      seen_base_q <= and_1968_s2_q ? select_4099 : seen_base_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
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
    middle_sum_columns_values_0_q = 6'h0;
    middle_sum_columns_values_1_q = 6'h0;
    middle_sum_columns_values_2_q = 6'h0;
    middle_sum_columns_values_3_q = 6'h0;
    middle_sum_columns_values_4_q = 6'h0;
    middle_sum_columns_values_5_q = 6'h0;
    middle_sum_columns_values_6_q = 6'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      left_pixel_q <= and_1968_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_526 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_532 : averager_running_1_q;
      averager_total_0_q <= select_2168;
      averager_total_1_q <= select_2170;
      census_columns_values_0_cell_0_left_q <= select_2195;
      census_columns_values_0_cell_0_right_q <= select_2196;
      census_columns_values_0_cell_0_mask_q <= and_549_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2198;
      census_columns_values_0_cell_1_right_q <= select_2199;
      census_columns_values_0_cell_1_mask_q <= select_2200;
      census_columns_values_0_cell_2_left_q <= select_2201;
      census_columns_values_0_cell_2_right_q <= select_2202;
      census_columns_values_0_cell_2_mask_q <= select_2203;
      census_columns_values_0_cell_2_of_skin_q <= select_2204;
      census_columns_values_0_cell_3_left_q <= select_2205;
      census_columns_values_0_cell_3_right_q <= select_2206;
      census_columns_values_0_cell_3_mask_q <= select_2207;
      census_columns_values_0_cell_4_left_q <= select_2208;
      census_columns_values_0_cell_4_right_q <= select_2209;
      census_columns_values_0_cell_4_mask_q <= select_2210;
      census_columns_values_1_cell_0_left_q <= select_2211;
      census_columns_values_1_cell_0_right_q <= select_2212;
      census_columns_values_1_cell_0_mask_q <= select_2213;
      census_columns_values_1_cell_1_left_q <= select_2214;
      census_columns_values_1_cell_1_right_q <= select_2215;
      census_columns_values_1_cell_1_mask_q <= select_2216;
      census_columns_values_1_cell_2_left_q <= select_2217;
      census_columns_values_1_cell_2_right_q <= select_2218;
      census_columns_values_1_cell_2_mask_q <= select_2219;
      census_columns_values_1_cell_2_of_skin_q <= select_2220;
      census_columns_values_1_cell_3_left_q <= select_2221;
      census_columns_values_1_cell_3_right_q <= select_2222;
      census_columns_values_1_cell_3_mask_q <= select_2223;
      census_columns_values_1_cell_4_left_q <= select_2224;
      census_columns_values_1_cell_4_right_q <= select_2225;
      census_columns_values_1_cell_4_mask_q <= select_2226;
      census_columns_values_2_cell_0_left_q <= select_2227;
      census_columns_values_2_cell_0_right_q <= select_2228;
      census_columns_values_2_cell_0_mask_q <= select_2229;
      census_columns_values_2_cell_1_left_q <= select_2230;
      census_columns_values_2_cell_1_right_q <= select_2231;
      census_columns_values_2_cell_1_mask_q <= select_2232;
      census_columns_values_2_cell_2_left_q <= select_2233;
      census_columns_values_2_cell_2_right_q <= select_2234;
      census_columns_values_2_cell_2_mask_q <= select_2235;
      census_columns_values_2_cell_3_left_q <= select_2236;
      census_columns_values_2_cell_3_right_q <= select_2237;
      census_columns_values_2_cell_3_mask_q <= select_2238;
      census_columns_values_2_cell_4_left_q <= select_2239;
      census_columns_values_2_cell_4_right_q <= select_2240;
      census_columns_values_2_cell_4_mask_q <= select_2241;
      census_columns_values_3_cell_0_mask_q <= select_2242;
      census_columns_values_3_cell_1_left_q <= select_2243;
      census_columns_values_3_cell_1_right_q <= select_2244;
      census_columns_values_3_cell_1_mask_q <= select_2245;
      census_columns_values_3_cell_2_mask_q <= select_2246;
      census_columns_values_3_cell_3_left_q <= select_2247;
      census_columns_values_3_cell_3_right_q <= select_2248;
      census_columns_values_3_cell_3_mask_q <= select_2249;
      census_columns_values_3_cell_4_mask_q <= select_2250;
      sharpness_last_mean_0_q <= and_549_s2_q ? select_555 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_549_s2_q ? select_559 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2566;
      middle_sum_columns_values_2_q <= select_2567;
      middle_sum_columns_values_3_q <= select_2568;
      middle_sum_columns_values_4_q <= select_2569;
      middle_sum_columns_values_5_q <= select_2570;
      middle_sum_columns_values_6_q <= select_2571;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1011;
      sums_0_sum_sums_values_0_q <= sum_1261;
      sums_0_sum_sums_values_1_q <= equal_1259 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1509;
      sums_1_sum_sums_values_1_q <= equal_1259 ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
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
  logic done_s3_q;
  logic [2:0] select_510_s3_q;
  logic row_starts_s3_q;
  logic [5:0] select_543_s3_q;
  logic [5:0] last_s3_q;
  logic and_547_s3_q;
  logic and_549_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_552_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_569_s3_q;
  logic equal_574_s3_q;
  logic not_575_s3_q;
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
  logic less_675_s3_q;
  logic and_683_s3_q;
  logic and_708_s3_q;
  logic and_709_s3_q;
  logic [11:0] sum_724_s3_q;
  logic [9:0] sum_727_s3_q;
  logic and_735_s3_q;
  logic and_739_s3_q;
  logic less_740_s3_q;
  logic less_744_s3_q;
  logic less_746_s3_q;
  logic equal_1607_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1613_s3_q;
  logic equal_1615_s3_q;
  logic equal_1617_s3_q;
  logic equal_1619_s3_q;
  logic equal_1621_s3_q;
  logic equal_1623_s3_q;
  logic equal_1625_s3_q;
  logic equal_1627_s3_q;
  logic equal_1629_s3_q;
  logic less_1638_s3_q;
  logic or_1642_s3_q;
  logic equal_1662_s3_q;
  logic and_1672_s3_q;
  logic select_1689_s3_q;
  logic equal_1690_s3_q;
  logic and_1698_s3_q;
  logic equal_1700_s3_q;
  logic select_1747_s3_q;
  logic and_1775_s3_q;
  logic equal_1776_s3_q;
  logic equal_1778_s3_q;
  logic not_1783_s3_q;
  logic and_1791_s3_q;
  logic [4:0] select_1806_s3_q;
  logic select_1812_s3_q;
  logic [3:0] select_1852_s3_q;
  logic and_1968_s3_q;
  logic select_1970_s3_q;
  logic and_1973_s3_q;
  logic or_1979_s3_q;
  logic or_1982_s3_q;
  logic or_1985_s3_q;
  logic not_1987_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2014_s3_q;
  logic and_2019_s3_q;
  logic and_2051_s3_q;
  logic less_2052_s3_q;
  logic [11:0] sum_2060_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2078_s3_q;
  logic or_2081_s3_q;
  logic or_2084_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2134_s3_q;
  logic [11:0] sum_2266_s3_q;
  logic [9:0] sum_2269_s3_q;
  logic equal_2277_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2591_s3_q;
  logic and_2597_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2659_s3_q;
  logic and_2693_s3_q;
  logic and_2751_s3_q;
  logic and_2752_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2788_s3_q;
  logic and_2802_s3_q;
  logic equal_2845_s3_q;
  logic parity_3222_s3_q;
  logic parity_3351_s3_q;
  logic parity_3413_s3_q;
  logic xor_3441_s3_q;
  logic parity_3453_s3_q;
  logic or_3457_s3_q;
  logic equal_3458_s3_q;
  logic and_3558_s3_q;
  logic less_3583_s3_q;
  logic equal_3882_s3_q;
  logic and_4102_s3_q;
  logic equal_4175_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_pixel_0_s3_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s3_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      census_columns_values_1_cell_2_of_skin_s3_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[2];
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
      done_s3_q <= done_q;
      select_510_s3_q <= select_510_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_543_s3_q <= select_543_s2_q;
      last_s3_q <= last_s2_2_q;
      and_547_s3_q <= and_547_s2_q;
      and_549_s3_q <= and_549_s2_q;
      grey_s3_q <= grey;
      equal_552_s3_q <= equal_552;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_569_s3_q <= equal_569_s2_q;
      equal_574_s3_q <= equal_574_s2_q;
      not_575_s3_q <= not_575_s2_q;
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
      less_675_s3_q <= less_675;
      and_683_s3_q <= and_683;
      and_708_s3_q <= whole_22 & and_683;
      and_709_s3_q <= census_columns_values_1_cell_2_mask_q & and_683;
      sum_724_s3_q <= {1'b0, sum_720} + {2'h0, sum_723};
      sum_727_s3_q <= {9'h0, difference_725[9]} + {1'b0, xor_726};
      and_735_s3_q <= and_735;
      and_739_s3_q <= and_739;
      less_740_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_744_s3_q <= {{5{sum_743[6]}}, sum_743, half_grey_levels_2[3:0]} < 16'hffe1;
      less_746_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1607_s3_q <= equal_1607;
      all_s3_q <= all;
      sum_1613_s3_q <= sum_1613;
      equal_1615_s3_q <= equal_1615;
      equal_1617_s3_q <= equal_1617;
      equal_1619_s3_q <= equal_1619;
      equal_1621_s3_q <= equal_1621;
      equal_1623_s3_q <= equal_1623;
      equal_1625_s3_q <= equal_1625;
      equal_1627_s3_q <= equal_1627;
      equal_1629_s3_q <= equal_1629;
      less_1638_s3_q <= less_1638;
      or_1642_s3_q <= or_1642;
      equal_1662_s3_q <= (registration_fresh_q & select_1660) == 4'h0;
      and_1672_s3_q <= not_575_s2_q & and_1656;
      select_1689_s3_q <= select_1689[1];
      equal_1690_s3_q <= equal_1690;
      and_1698_s3_q <= and_1698;
      equal_1700_s3_q <= equal_1700;
      select_1747_s3_q <= select_1747;
      and_1775_s3_q <= and_1775;
      equal_1776_s3_q <= equal_1776_s2_q;
      equal_1778_s3_q <= equal_1778_s2_q;
      not_1783_s3_q <= not_1783_s2_q;
      and_1791_s3_q <= and_1775 & equal_1790;
      select_1806_s3_q <= select_1806_s2_q;
      select_1812_s3_q <= select_1812_s2_q;
      select_1852_s3_q <= select_1852_s2_q;
      and_1968_s3_q <= and_1968_s2_q;
      select_1970_s3_q <= select_1970_s2_q;
      and_1973_s3_q <= and_1973_s2_q;
      or_1979_s3_q <= or_1979;
      or_1982_s3_q <= or_1982;
      or_1985_s3_q <= or_1985;
      not_1987_s3_q <= not_1987;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2014_s3_q <= inside_v_s2_q & (and_2012 & and_1585);
      and_2019_s3_q <= not_575_s2_q & and_1994;
      and_2051_s3_q <= and_2051;
      less_2052_s3_q <= less_2052;
      sum_2060_s3_q <= sum_2060;
      textured_2_s3_q <= textured_2;
      or_2078_s3_q <= or_2078;
      or_2081_s3_q <= select_2075[7] | (~({select_2075[6], select_2075[3:2]} == 3'h0));
      or_2084_s3_q <= select_2075[7] | (~(select_2075[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2134_s3_q <= and_2134;
      sum_2266_s3_q <= {1'b0, sum_2262} + {2'h0, sum_2265};
      sum_2269_s3_q <= {9'h0, difference_2267[9]} + {1'b0, xor_2268};
      equal_2277_s3_q <= equal_2277_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2591_s3_q <= and_2591;
      and_2597_s3_q <= and_2597;
      explained_2_s3_q <= explained_2;
      and_2659_s3_q <= not_575_s2_q & and_2658;
      and_2693_s3_q <= not_575_s2_q & and_2692;
      and_2751_s3_q <= not_575_s2_q & (so_s2_q & (half_ends & equal_2748));
      and_2752_s3_q <= and_2752;
      residual_s3_q <= residual[7:0];
      and_2788_s3_q <= and_2788;
      and_2802_s3_q <= and_2752 & less_2801;
      equal_2845_s3_q <= (registration_fresh_q & select_2843) == 4'h0;
      parity_3222_s3_q <= ^{xor_3218, xor_3181, select_3148[44:36], other[44:36]};
      parity_3351_s3_q <= parity_3351;
      parity_3413_s3_q <= parity_3413;
      xor_3441_s3_q <= parity_3428 ^ parity_3440;
      parity_3453_s3_q <= ^{or_3450, or_3446, and_3442};
      or_3457_s3_q <= (or_3446 & or_3450) | (and_3442 & (or_3446 | or_3450));
      equal_3458_s3_q <= equal_3458_s2_q;
      and_3558_s3_q <= equal_1776_s2_q & equal_3555_s2_q;
      less_3583_s3_q <= select_3548 < select_3550;
      equal_3882_s3_q <= equal_3882;
      and_4102_s3_q <= and_2134 & (sum_2060 == sum_2044);
      equal_4175_s3_q <= (registration_fresh_q & select_4173) == 4'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic [5:0] segment_textured_q;
  logic [5:0] segment_explained_q;
  logic [5:0] segment_nearer_q;
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
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_724_s3_q + {2'h0, sum_727_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_729;
  assign sum_729 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_731;
  assign sum_731 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_729});
  // hls/stages/census.hpp:317
  logic less_732;
  assign less_732 = 9'h4 < sum_731[13:5];
  logic and_733;
  assign and_733 = and_683_s3_q & less_732;
  // hls/stages/moments.hpp:30
  logic and_745;
  assign and_745 = (and_708_s3_q & and_735_s3_q) & less_744_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1664;
  assign equal_1664 = sum_1613_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1613_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1666;
  assign select_1666 = equal_1664 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1667;
  assign sum_1667 = (equal_1662_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1666[13]}}, select_1666};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1613_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1670;
  assign select_1670 = equal_1664 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1671;
  assign sum_1671 = (equal_1662_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1670[6]}}, select_1670};
  // hls/stages/patches.hpp:357
  logic [22:0] select_1792;
  assign select_1792 = and_1791_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1747_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1794;
  assign select_1794 = equal_1690_s3_q ? patches_place_0_valid_q : (select_1689_s3_q ? patches_place_0_valid_q : select_1792[0]);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1795;
  assign sum_1795 = {1'b0, select_543_s3_q, select_510_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_1796;
  assign select_1796 = select_1689_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1792[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1797;
  assign select_1797 = equal_1690_s3_q ? patches_place_0_column_q : select_1796[7:0];
  logic [5:0] select_1798;
  assign select_1798 = equal_1690_s3_q ? patches_place_0_shift_q : select_1796[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1799;
  assign sum_1799 = select_1797 + {{2{select_1798[5]}}, select_1798};
  // hls/stages/patches.hpp:132
  logic equal_1800;
  assign equal_1800 = {sum_1799, sum_1795[0], select_510_s3_q[1:0]} == {1'b0, sum_1795[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1802;
  assign or_1802 = row_starts_s3_q | (select_1794 & equal_1800);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1803;
  assign select_1803 = or_1802 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1813;
  assign select_1813 = or_1802 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1815;
  assign and_1815 = select_1812_s3_q & (~select_1813[5]);
  // hls/stages/patches.hpp:127
  logic select_1823;
  assign select_1823 = equal_1690_s3_q ? patches_place_1_valid_q : (select_1689_s3_q ? select_1792[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_1824;
  assign select_1824 = select_1689_s3_q ? select_1792[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1825;
  assign select_1825 = equal_1690_s3_q ? patches_place_1_column_q : select_1824[7:0];
  logic [5:0] select_1826;
  assign select_1826 = equal_1690_s3_q ? patches_place_1_shift_q : select_1824[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1827;
  assign sum_1827 = select_1825 + {{2{select_1826[5]}}, select_1826};
  // hls/stages/patches.hpp:132
  logic equal_1828;
  assign equal_1828 = {sum_1827[7], sum_1795, select_510_s3_q[1:0]} == {1'b0, sum_1827[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1830;
  assign or_1830 = row_starts_s3_q | (select_1823 & equal_1828);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1831;
  assign select_1831 = or_1830 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1832;
  assign select_1832 = or_1830 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1834;
  assign and_1834 = select_1812_s3_q & (~select_1832[5]);
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1841;
  assign sum_1841 = select_1797[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1842;
  assign equal_1842 = {sum_1841[6], select_543_s3_q, select_510_s3_q} == {1'b0, sum_1841[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1844;
  assign or_1844 = row_starts_s3_q | (select_1794 & equal_1842);
  logic [4:0] select_1845;
  assign select_1845 = or_1844 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1846;
  assign sum_1846 = select_1825[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1847;
  assign equal_1847 = {sum_1846[6], select_543_s3_q, select_510_s3_q} == {1'b0, sum_1846[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1850;
  assign select_1850 = (row_starts_s3_q | (select_1823 & equal_1847)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1845[4] ? select_1850[3:0] : select_1845[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1853;
  assign select_1853 = or_1844 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1859;
  assign and_1859 = (select_1812_s3_q & (select_1806_s3_q[3] ^ select_1806_s3_q[4])) & ((~select_1845[4]) | (~select_1850[4]));
  // hls/stages/patches.hpp:186
  logic less_1963;
  assign less_1963 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1964;
  assign not_1964 = ~less_1963;
  logic [1:0] select_1965;
  assign select_1965 = patches_summed_first_s3_q ? 2'h2 : {less_1963, not_1964};
  logic [12:0] select_1966;
  assign select_1966 = select_1965[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1974;
  assign select_1974 = select_1965[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1973_s3_q, 1'b0, select_1970_s3_q, left_pixel_q};
  logic [14:0] select_1975;
  assign select_1975 = select_1965[1] ? {select_1966[12:8], patches_sums_values_0_q[9:8], select_1966[7:0]} : select_1974;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2000;
  assign select_2000 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2001;
  assign sum_2001 = {5'h0, textured_s3_q} + select_2000;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2003;
  assign sum_2003 = {4'h0, sum_2001} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2005;
  assign select_2005 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2006;
  assign sum_2006 = {5'h0, explained_s3_q} + select_2005;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2008;
  assign sum_2008 = {4'h0, sum_2006} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2015;
  assign select_2015 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_2016;
  assign sum_2016 = {5'h0, and_2014_s3_q} + select_2015;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2018;
  assign sum_2018 = {4'h0, sum_2016} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2069;
  assign select_2069 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2070;
  assign difference_2070 = {1'b0, textured_2_s3_q} - {1'b0, select_2069};
  logic [4:0] t;
  assign t = {difference_2070[3], difference_2070} + (equal_569_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2073;
  assign equal_2073 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2085;
  assign not_2085 = ~region_row_s3_q[2];
  logic [2:0] select_2086;
  assign select_2086 = region_row_s3_q[1] ? {1'b0, not_2085, 1'b0} : {region_row_s3_q[2], 1'b0, not_2085};
  logic [5:0] select_2087;
  assign select_2087 = region_row_s3_q[0] ? {select_2086[2], 1'b0, select_2086[1], 1'b0, select_2086[0], 1'b0} : {1'b0, select_2086[2], 1'b0, select_2086[1], 1'b0, select_2086[0]};
  logic [11:0] select_2088;
  assign select_2088 = or_2084_s3_q ? {select_2087[5], 1'b0, select_2087[4], 1'b0, select_2087[3], 1'b0, select_2087[2], 1'b0, select_2087[1], 1'b0, select_2087[0], 1'b0} : {1'b0, select_2087[5], 1'b0, select_2087[4], 1'b0, select_2087[3], 1'b0, select_2087[2], 1'b0, select_2087[1], 1'b0, select_2087[0]};
  logic [23:0] select_2089;
  assign select_2089 = or_2081_s3_q ? {select_2088[11], 1'b0, select_2088[10], 1'b0, select_2088[9], 1'b0, select_2088[8], 1'b0, select_2088[7], 1'b0, select_2088[6], 1'b0, select_2088[5], 1'b0, select_2088[4], 1'b0, select_2088[3], 1'b0, select_2088[2], 1'b0, select_2088[1], 1'b0, select_2088[0], 1'b0} : {1'b0, select_2088[11], 1'b0, select_2088[10], 1'b0, select_2088[9], 1'b0, select_2088[8], 1'b0, select_2088[7], 1'b0, select_2088[6], 1'b0, select_2088[5], 1'b0, select_2088[4], 1'b0, select_2088[3], 1'b0, select_2088[2], 1'b0, select_2088[1], 1'b0, select_2088[0]};
  logic [47:0] select_2090;
  assign select_2090 = or_2078_s3_q ? {select_2089[23], 1'b0, select_2089[22], 1'b0, select_2089[21], 1'b0, select_2089[20], 1'b0, select_2089[19], 1'b0, select_2089[18], 1'b0, select_2089[17], 1'b0, select_2089[16], 1'b0, select_2089[15], 1'b0, select_2089[14], 1'b0, select_2089[13], 1'b0, select_2089[12], 1'b0, select_2089[11], 1'b0, select_2089[10], 1'b0, select_2089[9], 1'b0, select_2089[8], 1'b0, select_2089[7], 1'b0, select_2089[6], 1'b0, select_2089[5], 1'b0, select_2089[4], 1'b0, select_2089[3], 1'b0, select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0], 1'b0} : {1'b0, select_2089[23], 1'b0, select_2089[22], 1'b0, select_2089[21], 1'b0, select_2089[20], 1'b0, select_2089[19], 1'b0, select_2089[18], 1'b0, select_2089[17], 1'b0, select_2089[16], 1'b0, select_2089[15], 1'b0, select_2089[14], 1'b0, select_2089[13], 1'b0, select_2089[12], 1'b0, select_2089[11], 1'b0, select_2089[10], 1'b0, select_2089[9], 1'b0, select_2089[8], 1'b0, select_2089[7], 1'b0, select_2089[6], 1'b0, select_2089[5], 1'b0, select_2089[4], 1'b0, select_2089[3], 1'b0, select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2094;
  assign and_2094 = good_known_q & (~((good_q & select_2090) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2103;
  assign select_2103 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2104;
  assign difference_2104 = {1'b0, shown_2_s3_q} - {1'b0, select_2103};
  logic [4:0] around;
  assign around = {difference_2104[3], difference_2104} + (equal_569_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2107;
  assign sum_2107 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2073 ? and_2094 : (~({sum_2107, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2119;
  assign select_2119 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2120;
  assign difference_2120 = {1'b0, near_2_s3_q} - {1'b0, select_2119};
  logic [4:0] n;
  assign n = {difference_2120[3], difference_2120} + (equal_569_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2124;
  assign and_2124 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2160;
  assign select_2160 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2162;
  assign select_2162 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2164;
  assign select_2164 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2166;
  assign select_2166 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2171;
  assign sum_2171 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2172;
  assign difference_2172 = {1'b0, sum_2171[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2173;
  assign xor_2173 = {difference_2172[8:0], sum_2171[0]} ^ {10{difference_2172[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2172[9]} + {1'b0, xor_2173};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_552_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2178;
  assign select_2178 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2179;
  assign sum_2179 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2180;
  assign difference_2180 = {1'b0, sum_2179[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2181;
  assign xor_2181 = {difference_2180[8:0], sum_2179[0]} ^ {10{difference_2180[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2180[9]} + {1'b0, xor_2181};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_552_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2186;
  assign select_2186 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2270;
  assign sum_2270 = sum_2266_s3_q + {2'h0, sum_2269_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2272;
  assign select_2272 = and_549_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2273;
  assign select_2273 = and_549_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2274;
  assign select_2274 = and_549_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2275;
  assign select_2275 = and_549_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2278;
  assign sum_2278 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2270};
  logic [13:0] sum_2280;
  assign sum_2280 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2278});
  // hls/stages/census.hpp:323
  logic and_2282;
  assign and_2282 = and_708_s3_q & (9'h4 < sum_2280[13:5]);
  // hls/stages/census.hpp:324
  logic and_2283;
  assign and_2283 = and_708_s3_q & less_732;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2284;
  assign sum_2284 = census_left_misses_q + {{17{and_2283}}, and_2282, 1'b0, and_2282};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2286;
  assign select_2286 = and_549_s3_q ? (equal_2277_s3_q ? 20'h0 : sum_2284) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2356;
  assign select_2356 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2359;
  assign select_2359 = and_549_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2362;
  assign and_2362 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2368;
  assign and_2368 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2369;
  assign and_2369 = and_2362 & and_2368;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2356[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2371;
  assign select_2371 = and_2369 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2373;
  assign select_2373 = equal_2277_s3_q ? {11'h0, select_2371} : (sharpness_sums_detail_0_q + {11'h0, select_2371});
  // hls/stages/agreement.hpp:457
  logic and_2380;
  assign and_2380 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2381;
  assign and_2381 = and_2362 & and_2380;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2356[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2383;
  assign select_2383 = and_2381 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2385;
  assign select_2385 = equal_2277_s3_q ? {11'h0, select_2383} : (sharpness_sums_detail_1_q + {11'h0, select_2383});
  logic [8:0] select_2388;
  assign select_2388 = and_2369 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2389;
  assign sum_2389 = (equal_2277_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2388};
  logic [8:0] select_2392;
  assign select_2392 = and_2381 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2393;
  assign sum_2393 = (equal_2277_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2392};
  // hls/stages/agreement.hpp:211
  logic equal_2395;
  assign equal_2395 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2396;
  assign less_2396 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2397;
  assign less_2397 = x_s3_q[4:0] < 5'h3;
  logic not_2398;
  assign not_2398 = ~x_s3_q[1];
  logic [2:0] select_2399;
  assign select_2399 = x_s3_q[0] ? {1'b0, not_2398, 1'b0} : {x_s3_q[1], 1'b0, not_2398};
  logic [5:0] select_2400;
  assign select_2400 = slot_s3_q[2] ? {select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0], 1'b0} : {1'b0, select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0]};
  logic [11:0] select_2401;
  assign select_2401 = slot_s3_q[1] ? {select_2400[5], 1'b0, select_2400[4], 1'b0, select_2400[3], 1'b0, select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0], 1'b0} : {1'b0, select_2400[5], 1'b0, select_2400[4], 1'b0, select_2400[3], 1'b0, select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0]};
  logic [23:0] select_2402;
  assign select_2402 = slot_s3_q[0] ? {select_2401[11], 1'b0, select_2401[10], 1'b0, select_2401[9], 1'b0, select_2401[8], 1'b0, select_2401[7], 1'b0, select_2401[6], 1'b0, select_2401[5], 1'b0, select_2401[4], 1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0], 1'b0} : {1'b0, select_2401[11], 1'b0, select_2401[10], 1'b0, select_2401[9], 1'b0, select_2401[8], 1'b0, select_2401[7], 1'b0, select_2401[6], 1'b0, select_2401[5], 1'b0, select_2401[4], 1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0]};
  // hls/stages/census.hpp:390
  logic and_2406;
  assign and_2406 = less_2397 & (~((sharpness_sums_contrast_1_q & select_2402) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2408;
  assign select_2408 = (less_2396 & and_2406) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2408};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2411;
  assign select_2411 = equal_2395 ? (less_2396 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2416;
  assign and_2416 = less_2397 & (~((sharpness_sums_contrast_0_q & select_2402) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2418;
  assign select_2418 = (less_2396 & and_2416) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2418};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2421;
  assign select_2421 = equal_2395 ? (less_2396 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2423;
  assign select_2423 = equal_2395 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2425;
  assign select_2425 = equal_2395 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2427;
  assign select_2427 = equal_2395 ? {sharpness_comparing_contrast_0_q[0], and_2416} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2429;
  assign select_2429 = equal_2395 ? {sharpness_comparing_contrast_1_q[0], and_2406} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2434;
  assign select_2434 = drew_q ? (equal_2395 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2438;
  assign select_2438 = drew_q ? (equal_2395 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2439;
  assign equal_2439 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2440;
  assign xor_2440 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2443;
  assign select_2443 = (equal_2439 | xor_2440) ? (five_times[0] & xor_2440) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2445;
  assign select_2445 = drew_q ? (equal_2395 ? select_2443 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2446;
  assign xor_2446 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2449;
  assign select_2449 = (equal_2439 | xor_2446) ? (five_times_2[0] & xor_2446) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2451;
  assign select_2451 = drew_q ? (equal_2395 ? select_2449 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2452;
  assign xor_2452 = sharpness_comparing_contrast_0_q[1] ^ and_2406;
  logic select_2455;
  assign select_2455 = (equal_2439 | xor_2452) ? (and_2406 & xor_2452) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2457;
  assign select_2457 = drew_q ? (equal_2395 ? select_2455 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2458;
  assign xor_2458 = sharpness_comparing_contrast_1_q[1] ^ and_2416;
  logic select_2461;
  assign select_2461 = (equal_2439 | xor_2458) ? (and_2416 & xor_2458) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2463;
  assign select_2463 = drew_q ? (equal_2395 ? select_2461 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2599;
  assign select_2599 = and_2591_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2597_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2602;
  assign and_2602 = not_575_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2607;
  assign and_2607 = not_575_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2612;
  assign and_2612 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2014_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2616;
  assign not_2616 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2625;
  assign select_2625 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2626;
  assign difference_2626 = {1'b0, explained_2_s3_q} - {1'b0, select_2625};
  logic [4:0] e;
  assign e = {difference_2626[3], difference_2626} + (equal_569_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2629;
  assign sum_2629 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2633;
  assign not_2633 = ~(equal_2073 ? and_2094 : (~({sum_2629, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2636;
  assign and_2636 = ends_cell_s3_q & (not_2616 & (centres_values_1_textured_s3_q & not_2633));
  logic and_2638;
  assign and_2638 = not_575_s3_q & (drew_q & and_2636);
  // hls/stages/agreement.hpp:1132
  logic less_2641;
  assign less_2641 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2642;
  assign select_2642 = less_2641 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2645;
  assign select_2645 = less_2641 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2646;
  assign sum_2646 = {1'b0, select_2645} + {3'h0, select_2645[9:2]};
  logic and_2648;
  assign and_2648 = (~(select_2642[9:4] == 6'h0)) & ({sum_2646, select_2645[1:0]} < {3'h0, select_2642});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2651;
  assign select_2651 = x_s3_q[6] ? (equal_1607_s3_q ? 10'h0 : (and_2648 ? select_2642 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2652;
  assign select_2652 = equal_574_s3_q ? select_2651 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2654;
  assign select_2654 = and_2591_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2652});
  logic [13:0] select_2661;
  assign select_2661 = and_2591_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2659_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2663;
  assign and_2663 = not_2616 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2666;
  assign and_2666 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2663));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2668;
  assign select_2668 = and_2591_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2666});
  // hls/stages/agreement.hpp:1110
  logic and_2670;
  assign and_2670 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2633);
  // hls/stages/agreement.hpp:788
  logic and_2674;
  assign and_2674 = not_575_s3_q & (drew_q & (ends_cell_s3_q & (not_2616 & and_2670)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2676;
  assign select_2676 = and_2591_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2674});
  logic [13:0] select_2695;
  assign select_2695 = and_2591_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2693_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2770;
  assign select_2770 = drew_q ? (equal_1700_s3_q ? (and_2752_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2771;
  assign select_2771 = equal_574_s3_q ? 8'h0 : select_2770;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2773;
  assign select_2773 = and_2751_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2771[7]}}, select_2771});
  // hls/stages/agreement.hpp:788
  logic and_2776;
  assign and_2776 = not_575_s3_q & (drew_q & (and_2752_s3_q & equal_1700_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2778;
  assign select_2778 = and_2751_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2776});
  // hls/stages/registration.hpp:107
  logic and_2780;
  assign and_2780 = and_2752_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2782;
  assign select_2782 = drew_q ? (equal_1700_s3_q ? {and_2780, and_2752_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2783;
  assign select_2783 = equal_574_s3_q ? 2'h0 : select_2782;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2784;
  assign sum_2784 = registration_half_votes_down_q + {{5{select_2783[1]}}, select_2783};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2790;
  assign select_2790 = drew_q ? (equal_1700_s3_q ? {and_2788_s3_q, and_2752_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2791;
  assign select_2791 = equal_574_s3_q ? 2'h0 : select_2790;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2792;
  assign sum_2792 = registration_half_votes_up_q + {{5{select_2791[1]}}, select_2791};
  // hls/stages/registration.hpp:107
  logic and_2795;
  assign and_2795 = and_2752_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2797;
  assign select_2797 = drew_q ? (equal_1700_s3_q ? {and_2795, and_2752_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2798;
  assign select_2798 = equal_574_s3_q ? 2'h0 : select_2797;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2799;
  assign sum_2799 = registration_half_half_votes_down_q + {{5{select_2798[1]}}, select_2798};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2804;
  assign select_2804 = drew_q ? (equal_1700_s3_q ? {and_2802_s3_q, and_2752_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2805;
  assign select_2805 = equal_574_s3_q ? 2'h0 : select_2804;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2806;
  assign sum_2806 = registration_half_half_votes_up_q + {{5{select_2805[1]}}, select_2805};
  // hls/stages/agreement.hpp:788
  logic and_2840;
  assign and_2840 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & less_1638_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2847;
  assign select_2847 = or_1642_s3_q ? 12'h0 : (equal_2845_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2850;
  assign select_2850 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2847 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2851;
  assign select_2851 = equal_574_s3_q ? select_2850 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2852;
  assign and_2852 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2855;
  assign and_2855 = not_1987_s3_q & (less_1638_s3_q & ({and_2852, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2857;
  assign and_2857 = equal_574_s3_q & (x_s3_q[6] & and_2855);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2859;
  assign sum_2859 = {{2{select_2851[11]}}, select_2851} + (and_2857 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2862;
  assign select_2862 = or_1642_s3_q ? 12'h0 : (equal_2845_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2865;
  assign select_2865 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2862 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2866;
  assign select_2866 = equal_574_s3_q ? select_2865 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2868;
  assign sum_2868 = {{2{select_2866[11]}}, select_2866} + (and_2857 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2870;
  assign not_2870 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2873;
  assign and_2873 = not_1987_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2870, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2879;
  assign and_2879 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & (less_1638_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2880;
  assign not_2880 = ~and_2879;
  logic less_2881;
  assign less_2881 = $signed({9'h1, {2{not_2880}}, and_2879}) < $signed(registration_up_q[13:2]);
  logic select_2882;
  assign select_2882 = (equal_574_s3_q & (x_s3_q[6] & and_2873)) ? less_2881 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2886;
  assign and_2886 = x_s3_q[6] & (not_1987_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2887;
  assign and_2887 = equal_574_s3_q & and_2886;
  // hls/stages/registration.hpp:242
  logic less_2888;
  assign less_2888 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2890;
  assign less_2890 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2892;
  assign equal_2892 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2896;
  assign and_2896 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & (less_1638_s3_q & equal_2892)));
  // hls/stages/agreement.hpp:1142
  logic and_2903;
  assign and_2903 = x_s3_q[6] & (not_1987_s3_q & (less_1638_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2906;
  assign equal_2906 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2909;
  assign and_2909 = not_1987_s3_q & (less_1638_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2906));
  // hls/stages/registration.hpp:244
  logic and_2913;
  assign and_2913 = (equal_574_s3_q & (x_s3_q[6] & and_2909)) & (less_2890 | less_2888);
  // hls/stages/agreement.hpp:1142
  logic and_2918;
  assign and_2918 = not_1987_s3_q & (less_1638_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2906)));
  // hls/stages/registration.hpp:244
  logic and_2921;
  assign and_2921 = registration_votes_up_q & registration_other_down_q;
  logic select_2923;
  assign select_2923 = registration_votes_down_q ? (registration_other_up_q | and_2921) : and_2921;
  // hls/stages/registration.hpp:138
  logic and_2925;
  assign and_2925 = (equal_574_s3_q & (x_s3_q[6] & and_2918)) & (registration_other_enough_q & select_2923);
  // hls/stages/registration.hpp:245
  logic or_2928;
  assign or_2928 = registration_moved_q | (registration_enough_q & (and_2913 | and_2925));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3011;
  assign select_3011 = sample_pair_whole_s3_q ? (equal_1690_s3_q ? patches_place_0_slope_q : select_1796[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3016;
  assign select_3016 = sample_pair_whole_s3_q ? (equal_1690_s3_q ? patches_place_1_slope_q : select_1824[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3018;
  assign select_3018 = equal_1690_s3_q ? patches_valid_0_q : (select_1689_s3_q ? patches_valid_0_q : select_1792[0]);
  // hls/stages/agreement.hpp:276
  logic select_3021;
  assign select_3021 = sample_pair_whole_s3_q ? (and_1815 ? (sample_present_s3_q & select_3018) : select_3018) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3023;
  assign select_3023 = equal_1690_s3_q ? patches_valid_1_q : (select_1689_s3_q ? select_1792[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3026;
  assign select_3026 = sample_pair_whole_s3_q ? (and_1834 ? (sample_present_s3_q & select_3023) : select_3023) : patches_valid_1_q;
  logic [5:0] select_3029;
  assign select_3029 = sample_pair_whole_s3_q ? (select_1813[5] ? {1'b1, select_1813[4:0]} : (select_1813 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3032;
  assign select_3032 = sample_pair_whole_s3_q ? (select_1832[5] ? {1'b1, select_1832[4:0]} : (select_1832 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3035;
  assign select_3035 = sample_pair_whole_s3_q ? (select_1845[4] ? {1'b1, select_1845[3:0]} : (select_1845 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3038;
  assign select_3038 = sample_pair_whole_s3_q ? (select_1850[4] ? {1'b1, select_1850[3:0]} : (select_1850 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3457_s3_q, parity_3453_s3_q, xor_3441_s3_q, parity_3413_s3_q, parity_3351_s3_q, parity_3222_s3_q} + (equal_3458_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3462;
  assign select_3462 = equal_1776_s3_q ? patches_sums_values_0_q : (equal_1778_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3463;
  assign select_3463 = equal_1778_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3465;
  assign select_3465 = equal_1778_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3467;
  assign select_3467 = equal_1778_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3469;
  assign select_3469 = equal_1778_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3471;
  assign select_3471 = equal_1778_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1778_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1778_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1778_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1778_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1778_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1778_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1778_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1778_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1778_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1778_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1778_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_3564;
  assign difference_3564 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_3567;
  assign and_3567 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_3564, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_3570;
  assign not_3570 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_3573;
  assign and_3573 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_3567 & ((10'h38 < patches_peak_size_q) & not_3570));
  // hls/stages/patches.hpp:190
  logic and_3575;
  assign and_3575 = and_3558_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_3573);
  // hls/stages/patches.hpp:667
  logic not_3576;
  assign not_3576 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_3578;
  assign and_3578 = and_3575 & (not_1783_s3_q & not_3576);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3580;
  assign sum_3580 = {7'h0, and_3578} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3584;
  assign sum_3584 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3583_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_3591;
  assign not_3591 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3592;
  assign sum_3592 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3594;
  assign not_3594 = ~({eight, 3'h0} < {1'b0, sum_3592, fall_2[0]});
  logic [1:0] sum_3595;
  assign sum_3595 = {1'b0, not_3591} + {1'b0, not_3594};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3596;
  assign sum_3596 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3598;
  assign not_3598 = ~({eight, 3'h0} < {sum_3596, fall_2[1:0]});
  logic not_3601;
  assign not_3601 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3602;
  assign sum_3602 = {1'b0, not_3598} + {1'b0, not_3601};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3595} + {1'b0, sum_3602};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3605;
  assign select_3605 = less_3583_s3_q ? ({sum_3584, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_3584, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3606;
  assign select_3606 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_3607;
  assign select_3607 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3608;
  assign sum_3608 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_3609;
  assign sum_3609 = {select_3607[5], select_3607} + {{3{sum_3608[3]}}, sum_3608};
  // hls/stages/patches.hpp:604
  logic [17:0] product_3610;
  assign product_3610 = $signed({{10{select_3606[7]}}, select_3606}) * $signed({{8{sum_3609[6]}}, sum_3609, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_3611;
  assign difference_3611 = {{6{select_3605[7]}}, select_3605} - {product_3610[17], product_3610[17:5]};
  // hls/stages/patches.hpp:611
  logic less_3612;
  assign less_3612 = $signed({{7{difference_3582[6]}}, difference_3582}) < $signed(difference_3611);
  // hls/stages/patches.hpp:189
  logic not_3613;
  assign not_3613 = ~less_3612;
  // hls/stages/patches.hpp:670
  logic and_3614;
  assign and_3614 = not_3613 & and_3578;
  logic [7:0] sum_3615;
  assign sum_3615 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3614};
  // hls/stages/patches.hpp:189
  logic not_3618;
  assign not_3618 = ~($signed(difference_3611) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_3619;
  assign and_3619 = not_3618 & and_3578;
  logic [7:0] sum_3620;
  assign sum_3620 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3619};
  // hls/stages/patches.hpp:192
  logic and_3622;
  assign and_3622 = and_3575 & (patches_second_s3_q & not_3576);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3624;
  assign sum_3624 = {7'h0, and_3622} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3626;
  assign and_3626 = not_3613 & and_3622;
  logic [7:0] sum_3627;
  assign sum_3627 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3626};
  // hls/stages/patches.hpp:671
  logic and_3629;
  assign and_3629 = not_3618 & and_3622;
  logic [7:0] sum_3630;
  assign sum_3630 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3629};
  // hls/stages/patches.hpp:192
  logic and_3632;
  assign and_3632 = and_3575 & (patches_lower_s3_q & not_1783_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3634;
  assign sum_3634 = {7'h0, and_3632} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3636;
  assign and_3636 = not_3613 & and_3632;
  logic [7:0] sum_3637;
  assign sum_3637 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3636};
  // hls/stages/patches.hpp:671
  logic and_3639;
  assign and_3639 = not_3618 & and_3632;
  logic [7:0] sum_3640;
  assign sum_3640 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3639};
  // hls/stages/patches.hpp:192
  logic and_3642;
  assign and_3642 = and_3575 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3644;
  assign sum_3644 = {7'h0, and_3642} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3646;
  assign and_3646 = not_3613 & and_3642;
  logic [7:0] sum_3647;
  assign sum_3647 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3646};
  // hls/stages/patches.hpp:671
  logic and_3649;
  assign and_3649 = not_3618 & and_3642;
  logic [7:0] sum_3650;
  assign sum_3650 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3649};
  // hls/stages/agreement.hpp:1223
  logic equal_3651;
  assign equal_3651 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3652;
  assign less_3652 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3656;
  assign and_3656 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & (equal_3651 & less_3652)));
  // hls/stages/agreement.hpp:1142
  logic and_3661;
  assign and_3661 = x_s3_q[6] & (not_1987_s3_q & (less_3652 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3662;
  assign and_3662 = equal_574_s3_q & and_3661;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3664;
  assign or_3664 = (and_3656 ? patches_quarters_0_places_q : 8'h0) | (and_3662 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3668;
  assign and_3668 = x_s3_q[6] & (not_1987_s3_q & (less_3652 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3669;
  assign and_3669 = equal_574_s3_q & and_3668;
  // hls/stages/agreement.hpp:1142
  logic and_3675;
  assign and_3675 = x_s3_q[6] & (not_1987_s3_q & (less_3652 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3676;
  assign and_3676 = equal_574_s3_q & and_3675;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3678;
  assign or_3678 = (or_3664 | (and_3669 ? patches_quarters_2_places_q : 8'h0)) | (and_3676 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_3682;
  assign select_3682 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3686;
  assign and_3686 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & (less_3652 & select_3682)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_3688;
  assign select_3688 = and_3656 ? (and_3686 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3690;
  assign select_3690 = and_3662 ? (and_3686 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3693;
  assign select_3693 = and_3669 ? (and_3686 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3696;
  assign select_3696 = and_3676 ? (and_3686 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3699;
  assign select_3699 = and_3656 ? (and_3686 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3701;
  assign select_3701 = and_3662 ? (and_3686 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3704;
  assign select_3704 = and_3669 ? (and_3686 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3707;
  assign select_3707 = and_3676 ? (and_3686 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3709;
  assign sum_3709 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3713;
  assign and_3713 = x_s3_q[6] & (not_1987_s3_q & (less_3652 & (sum_3709[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3714;
  assign and_3714 = equal_574_s3_q & and_3713;
  // hls/stages/patches.hpp:630
  logic [7:0] select_3717;
  assign select_3717 = and_3714 ? (patches_word_places_q + (and_3662 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3720;
  assign select_3720 = and_3714 ? (patches_word_up_q + (and_3662 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3723;
  assign select_3723 = and_3714 ? (patches_word_down_q + (and_3662 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3726;
  assign select_3726 = ($signed(difference_3611[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3611[5:0];
  logic [5:0] select_3727;
  assign select_3727 = ($signed(14'h10) < $signed(difference_3611)) ? 6'h10 : select_3726;
  // hls/stages/patches.hpp:673
  logic [5:0] select_3728;
  assign select_3728 = and_3575 ? select_3727 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_3730;
  assign select_3730 = patches_round_ends_q ? {{6{select_3728[5]}}, select_3728} : (patches_across_q + {{6{select_3728[5]}}, select_3728});
  // hls/stages/agreement.hpp:788
  logic and_3734;
  assign and_3734 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q & (equal_2892 & less_3652)));
  // hls/stages/agreement.hpp:1142
  logic and_3738;
  assign and_3738 = x_s3_q[6] & (not_1987_s3_q & (less_3652 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3739;
  assign and_3739 = equal_574_s3_q & and_3738;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3741;
  assign select_3741 = and_3734 ? (and_3739 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3745;
  assign or_3745 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3748;
  assign or_3748 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3749;
  assign sum_3749 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3751;
  assign select_3751 = and_3734 ? (and_3739 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3754;
  assign and_3754 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3756;
  assign select_3756 = and_3739 ? {and_3754, patches_found_q[2:1]} : (and_3734 ? {and_3754, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_3760;
  assign or_3760 = patches_partly_q | (patches_doubted_q & (~and_3739));
  // hls/stages/patches.hpp:656
  logic select_3763;
  assign select_3763 = and_3734 ? (and_3739 ? or_3760 : (and_3734 ? or_3760 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_3764;
  assign select_3764 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3768;
  assign select_3768 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_3770;
  assign sum_3770 = {sum_3609[6], sum_3609, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_3772;
  assign and_3772 = ({{5{sum_3770[10]}}, sum_3770} < 16'h3) & and_3575;
  logic [7:0] sum_3773;
  assign sum_3773 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3772};
  // hls/stages/patches.hpp:663
  logic [12:0] product_3778;
  assign product_3778 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_3741};
  // hls/stages/patches.hpp:192
  logic and_3780;
  assign and_3780 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3778[12:5] < patches_on_skin_q);
  logic select_3785;
  assign select_3785 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3789;
  assign or_3789 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3796;
  assign select_3796 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3802;
  assign and_3802 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3803;
  assign sum_3803 = patches_age_q + {9'h0, and_3802};
  logic [9:0] select_3806;
  assign select_3806 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3803)) : sum_3803;
  // hls/stages/agreement.hpp:1188
  logic or_3863;
  assign or_3863 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3865;
  assign equal_3865 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3871;
  assign select_3871 = (equal_3865 & equal_3651) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3874;
  assign sum_3874 = {1'b0, select_2645} + {2'h0, select_2645[9:1]};
  logic select_3877;
  assign select_3877 = (select_2642[9:3] == 7'h0) ? ((~or_3863) & (~select_3871)) : (~({sum_3874, select_2645[0]} < {2'h0, select_2642}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3879;
  assign select_3879 = x_s3_q[6] ? (equal_1607_s3_q ? good_q : {select_3877, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3884;
  assign select_3884 = equal_574_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3882_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3885;
  assign equal_3885 = x_s3_q[6:3] == 4'ha;
  logic equal_3887;
  assign equal_3887 = x_s3_q[6:3] == 4'hc;
  logic equal_3888;
  assign equal_3888 = x_s3_q[6:3] == 4'hb;
  logic equal_3889;
  assign equal_3889 = x_s3_q[6:3] == 4'h9;
  logic equal_3890;
  assign equal_3890 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3892;
  assign select_3892 = equal_3889 ? counts_skin_unproven_q : (equal_3890 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3894;
  assign select_3894 = equal_3888 ? counts_regions_bad_q : (equal_3885 ? counts_nearer_q : select_3892);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3887 ? counts_on_skin_q : select_3894;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3897;
  assign select_3897 = (equal_3885 & equal_3651) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3898;
  assign not_3898 = ~hidden_for_q[7];
  logic [7:0] select_3900;
  assign select_3900 = select_3897 ? (hidden_for_q + {7'h0, not_3898}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3902;
  assign select_3902 = equal_574_s3_q ? (equal_3882_s3_q ? select_3900 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3903;
  assign select_3903 = equal_3651 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3905;
  assign select_3905 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3907;
  assign select_3907 = equal_3890 ? cfg_unproven_skin_limit_i : (equal_3865 ? cfg_unproven_limit_i : select_3905);
  logic [7:0] select_3909;
  assign select_3909 = equal_3885 ? cfg_regions_limit_i : (equal_3889 ? cfg_hidden_limit_i : select_3907);
  logic [7:0] limit;
  assign limit = equal_3887 ? cfg_regions_limit_i : (equal_3888 ? {cfg_on_skin_limit_i, 3'h0} : select_3909);
  // hls/stages/agreement.hpp:1231
  logic not_3912;
  assign not_3912 = ~x_s3_q[2];
  logic [3:0] select_3913;
  assign select_3913 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3912, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3912};
  logic [7:0] select_3914;
  assign select_3914 = x_s3_q[0] ? {select_3913[3], 1'b0, select_3913[2], 1'b0, select_3913[1], 1'b0, select_3913[0], 1'b0} : {1'b0, select_3913[3], 1'b0, select_3913[2], 1'b0, select_3913[1], 1'b0, select_3913[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3918;
  assign select_3918 = equal_3889 ? counts_skin_supervised_q : (equal_3890 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3920;
  assign select_3920 = equal_3888 ? counts_skin_textured_q : (equal_3885 ? counts_textured_q : select_3918);
  logic [13:0] of;
  assign of = equal_3887 ? counts_textured_q : select_3920;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3922;
  assign select_3922 = ((limit & select_3914) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3903} + {1'b0, select_3922};
  // hls/stages/agreement.hpp:788
  logic select_3927;
  assign select_3927 = equal_574_s3_q ? (equal_3651 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3932;
  assign and_3932 = too_much_q & (~(equal_3890 & equal_3651));
  // hls/stages/agreement.hpp:1229
  logic select_3937;
  assign select_3937 = (over[14] & equal_3651) ? (and_3932 | ((equal_3890 | equal_3889) | (x_s3_q[6:3] == 4'hf))) : and_3932;
  // hls/stages/agreement.hpp:1125
  logic and_3942;
  assign and_3942 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_3943;
  assign select_3943 = (equal_3887 & equal_3651) ? and_3942 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_3945;
  assign select_3945 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3947;
  assign select_3947 = equal_574_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_3945 : box_textured_columns_values_0_q);
  logic [2:0] select_3948;
  assign select_3948 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3950;
  assign select_3950 = equal_574_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_3948 : box_textured_columns_values_1_q);
  logic [2:0] select_3951;
  assign select_3951 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3953;
  assign select_3953 = equal_574_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_3951 : box_textured_columns_values_2_q);
  logic [2:0] select_3954;
  assign select_3954 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3956;
  assign select_3956 = equal_574_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_3954 : box_textured_columns_values_3_q);
  logic [2:0] select_3957;
  assign select_3957 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3959;
  assign select_3959 = equal_574_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_3957 : box_textured_columns_values_4_q);
  logic [4:0] select_3961;
  assign select_3961 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3963;
  assign select_3963 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3965;
  assign select_3965 = equal_574_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_3963 : box_explained_columns_values_0_q);
  logic [2:0] select_3966;
  assign select_3966 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3968;
  assign select_3968 = equal_574_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_3966 : box_explained_columns_values_1_q);
  logic [2:0] select_3969;
  assign select_3969 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3971;
  assign select_3971 = equal_574_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_3969 : box_explained_columns_values_2_q);
  logic [2:0] select_3972;
  assign select_3972 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3974;
  assign select_3974 = equal_574_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_3972 : box_explained_columns_values_3_q);
  logic [2:0] select_3975;
  assign select_3975 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3977;
  assign select_3977 = equal_574_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_3975 : box_explained_columns_values_4_q);
  logic [4:0] select_3979;
  assign select_3979 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_3982;
  assign select_3982 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3984;
  assign select_3984 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3986;
  assign select_3986 = equal_574_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_3984 : box_shown_columns_values_1_q);
  logic [2:0] select_3987;
  assign select_3987 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3989;
  assign select_3989 = equal_574_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_3987 : box_shown_columns_values_2_q);
  logic [2:0] select_3990;
  assign select_3990 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3992;
  assign select_3992 = equal_574_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_3990 : box_shown_columns_values_3_q);
  logic [2:0] select_3993;
  assign select_3993 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3995;
  assign select_3995 = equal_574_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_3993 : box_shown_columns_values_4_q);
  logic [4:0] select_3997;
  assign select_3997 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4000;
  assign select_4000 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4002;
  assign select_4002 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4004;
  assign select_4004 = equal_574_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4002 : box_nearer_columns_values_1_q);
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_574_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4005 : box_nearer_columns_values_2_q);
  logic [2:0] select_4008;
  assign select_4008 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4010;
  assign select_4010 = equal_574_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4008 : box_nearer_columns_values_3_q);
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_574_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4011 : box_nearer_columns_values_4_q);
  logic [4:0] select_4015;
  assign select_4015 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4050;
  assign select_4050 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4052;
  assign select_4052 = left_first_s3_q ? done_s3_q : (and_1968_s3_q ? select_4050 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4103;
  assign select_4103 = and_4102_s3_q ? {and_2124, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4104;
  assign and_4104 = select_4050 & less_4080;
  // hls/stages/agreement.hpp:438
  logic select_4107;
  assign select_4107 = and_2051_s3_q ? (less_2052_s3_q ? (select_4103[0] & and_4104) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4109;
  assign select_4109 = left_first_s3_q ? select_4107 : (and_1968_s3_q ? select_4107 : seen_q);
  logic select_4110;
  assign select_4110 = and_1968_s3_q ? select_4109 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4113;
  assign select_4113 = and_2051_s3_q ? (less_2052_s3_q ? (select_4103[1] & and_4104) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4115;
  assign select_4115 = left_first_s3_q ? select_4113 : (and_1968_s3_q ? select_4113 : nearer_q);
  logic select_4116;
  assign select_4116 = and_1968_s3_q ? select_4115 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4123;
  assign or_4123 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4131;
  assign not_4131 = ~(or_3863 | not_2347);
  // hls/stages/agreement.hpp:788
  logic and_4135;
  assign and_4135 = equal_574_s3_q & (equal_3882_s3_q & (not_4131 & (select_3871 | select_3937)));
  logic and_4138;
  assign and_4138 = equal_3882_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4142;
  assign or_4142 = select_2445 | (select_2457 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4149;
  assign and_4149 = equal_574_s3_q & (equal_3882_s3_q & (not_4131 & (select_2451 | select_2463)));
  // hls/stages/agreement.hpp:1150
  logic and_4154;
  assign and_4154 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3900 < cfg_hidden_frames_i));
  logic select_4160;
  assign select_4160 = (not_2347 | (select_3943 & not_3775)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4165;
  assign and_4165 = equal_574_s3_q & (equal_3882_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4169;
  assign and_4169 = equal_574_s3_q & (x_s3_q[6] & (not_1987_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4177;
  assign select_4177 = equal_1629_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4175_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4178;
  assign select_4178 = equal_1627_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4177;
  logic [31:0] select_4179;
  assign select_4179 = equal_1625_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4178;
  logic [31:0] select_4180;
  assign select_4180 = equal_1623_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4179;
  logic [31:0] select_4181;
  assign select_4181 = equal_1621_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4180;
  logic [31:0] select_4182;
  assign select_4182 = equal_1619_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4181;
  logic [31:0] select_4183;
  assign select_4183 = equal_1617_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4182;
  logic [31:0] select_4184;
  assign select_4184 = equal_1615_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4183;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4185;
  assign select_4185 = less_2641 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4186;
  assign select_4186 = equal_1607_s3_q ? select_4184 : {2'h0, select_4185, select_2645, select_2642};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_549_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_746_s3_q, and_745, less_740_s3_q, and_739_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_733, and_709_s3_q, and_708_s3_q, and_683_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
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
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1613_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1672_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1671, sum_1667};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1698_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1775_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1747_s3_q};
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
  assign patches_right_0_waddr = {select_1806_s3_q, select_1803};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1815);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s3_q;
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
  assign patches_right_1_waddr = {select_1806_s3_q, select_1831};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1834);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s3_q;
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
  assign patches_left_waddr = {select_1853, select_1852_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1859);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s3_q;
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
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1975;
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
  assign regions_waddr = {region_row_s3_q, or_1985_s3_q, or_1982_s3_q, or_1979_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2019_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2018, sum_2008, sum_2003};
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
  logic [11:0] map_waddr;
  assign map_waddr = sum_2060_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2134_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2124, is_seen};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 12'd3290) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 12'd3290) $error("map: read outside, address %0d", map_raddr);
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
      segment_textured_q <= 6'h0;
      segment_explained_q <= 6'h0;
      segment_nearer_q <= 6'h0;
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
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2286;
      sharpness_before_last_mask_q <= select_2359;
      sharpness_sums_detail_0_q <= and_549_s3_q ? select_2373 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_549_s3_q ? select_2385 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_549_s3_q ? sum_2389 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_549_s3_q ? sum_2393 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2411 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2421 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2423 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2425 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2427 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2429 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2434;
      sharpness_comparing_carry_1_q <= select_2438;
      sharpness_comparing_less_detail_0_q <= select_2445;
      sharpness_comparing_less_detail_1_q <= select_2451;
      sharpness_comparing_less_contrast_0_q <= select_2457;
      sharpness_comparing_less_contrast_1_q <= select_2463;
      counts_supervised_q <= select_2599;
      counts_textured_q <= and_2591_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2602});
      counts_explained_q <= and_2591_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2607});
      counts_nearer_q <= and_2591_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2612});
      counts_unproven_q <= and_2591_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2638});
      counts_regions_bad_q <= select_2654;
      counts_skin_supervised_q <= select_2661;
      counts_skin_textured_q <= select_2668;
      counts_skin_unproven_q <= select_2676;
      counts_on_skin_q <= select_2695;
      registration_half_across_q <= select_2773;
      registration_half_measured_q <= select_2778;
      registration_half_votes_down_q <= and_2751_s3_q ? 7'h0 : sum_2784;
      registration_half_votes_up_q <= and_2751_s3_q ? 7'h0 : sum_2792;
      registration_half_half_votes_down_q <= and_2751_s3_q ? 7'h0 : sum_2799;
      registration_half_half_votes_up_q <= and_2751_s3_q ? 7'h0 : sum_2806;
      registration_down_q <= and_2840 ? sum_2859 : registration_down_q;
      registration_up_q <= and_2840 ? sum_2868 : registration_up_q;
      registration_enough_q <= select_2882;
      registration_votes_down_q <= and_2887 ? less_2888 : registration_votes_down_q;
      registration_votes_up_q <= and_2887 ? less_2890 : registration_votes_up_q;
      registration_other_enough_q <= and_2896 ? select_2882 : registration_other_enough_q;
      registration_other_down_q <= and_2896 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2896 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_574_s3_q & and_2903)) & or_2928;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1794 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1797 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1798 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3011;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1823 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1825 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1826 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3016;
      patches_valid_0_q <= select_3021;
      patches_valid_1_q <= select_3026;
      patches_right_next_0_q <= select_3029;
      patches_right_next_1_q <= select_3032;
      patches_left_next_0_q <= select_3035;
      patches_left_next_1_q <= select_3038;
      patches_sums_values_0_q <= select_3462;
      patches_sums_values_1_q <= equal_1776_s3_q ? patches_sums_values_1_q : select_3463;
      patches_sums_values_2_q <= equal_1776_s3_q ? patches_sums_values_2_q : select_3465;
      patches_sums_values_3_q <= equal_1776_s3_q ? patches_sums_values_3_q : select_3467;
      patches_sums_values_4_q <= equal_1776_s3_q ? patches_sums_values_4_q : select_3469;
      patches_sums_values_5_q <= equal_1776_s3_q ? patches_sums_values_5_q : select_3471;
      patches_sums_values_6_q <= equal_1776_s3_q ? patches_sums_values_6_q : select_3473;
      patches_sums_values_7_q <= equal_1776_s3_q ? patches_sums_values_7_q : select_3475;
      patches_sums_values_8_q <= equal_1776_s3_q ? patches_sums_values_8_q : select_3477;
      patches_sums_values_9_q <= equal_1776_s3_q ? patches_sums_values_9_q : select_3479;
      patches_sums_values_10_q <= equal_1776_s3_q ? patches_sums_values_10_q : select_3481;
      patches_sums_values_11_q <= equal_1776_s3_q ? patches_sums_values_11_q : select_3483;
      patches_sums_values_12_q <= equal_1776_s3_q ? patches_sums_values_12_q : select_3485;
      patches_sums_values_13_q <= equal_1776_s3_q ? patches_sums_values_13_q : select_3487;
      patches_sums_values_14_q <= equal_1776_s3_q ? patches_sums_values_14_q : select_3489;
      patches_sums_values_15_q <= equal_1776_s3_q ? patches_sums_values_15_q : select_3491;
      patches_sums_values_16_q <= equal_1776_s3_q ? patches_sums_values_16_q : select_3493;
      patches_best_differing_q <= select_1975[9:0];
      patches_best_column_q <= select_1975[14:10];
      patches_quarters_0_places_q <= sum_3580;
      patches_quarters_0_up_q <= sum_3615;
      patches_quarters_0_down_q <= sum_3620;
      patches_quarters_1_places_q <= sum_3624;
      patches_quarters_1_up_q <= sum_3627;
      patches_quarters_1_down_q <= sum_3630;
      patches_quarters_2_places_q <= sum_3634;
      patches_quarters_2_up_q <= sum_3637;
      patches_quarters_2_down_q <= sum_3640;
      patches_quarters_3_places_q <= sum_3644;
      patches_quarters_3_up_q <= sum_3647;
      patches_quarters_3_down_q <= sum_3650;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_3678;
      patches_word_up_q <= ((select_3688 | select_3690) | select_3693) | select_3696;
      patches_word_down_q <= ((select_3699 | select_3701) | select_3704) | select_3707;
      patches_sum_places_q <= select_3717;
      patches_sum_up_q <= select_3720;
      patches_sum_down_q <= select_3723;
      patches_across_q <= select_3730;
      patches_places_q <= select_3741;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3745;
      patches_partly_q <= or_3748;
      patches_clear_limit_q <= sum_3749[8:2];
      patches_complete_q <= select_3751;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3734 ? select_3756 : patches_found_q;
      patches_doubted_q <= select_3763;
      patches_doubted_before_q <= select_3764;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3768;
      patches_on_skin_q <= sum_3773;
      patches_large_q <= not_3775 & and_3780;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3785;
      patches_spoiled_q <= or_3789;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3796;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3806;
      segment_textured_q <= select_2000 + {5'h0, and_2602};
      segment_explained_q <= select_2005 + {5'h0, and_2607};
      segment_nearer_q <= select_2015 + {5'h0, and_2612};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_574_s3_q ? select_3879 : good_q;
      good_known_q <= select_3884;
      hidden_for_q <= select_3902;
      product_q <= equal_574_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3927;
      disagree_q <= equal_574_s3_q ? select_3871 : disagree_q;
      too_much_q <= equal_574_s3_q ? select_3937 : too_much_q;
      hides_q <= equal_574_s3_q ? select_3897 : hides_q;
      overlooks_q <= equal_574_s3_q ? select_3943 : overlooks_q;
      proven_q <= and_1968_s3_q ? select_4052 : proven_q;
      seen_q <= select_4110;
      nearer_q <= select_4116;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
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
      averager_quarter_1_0_q <= select_2160;
      averager_quarter_1_1_q <= select_2162;
      averager_quarter_2_0_q <= select_2164;
      averager_quarter_2_1_q <= select_2166;
      averager_detail_0_q <= select_2178;
      averager_detail_1_q <= select_2186;
      census_changes_values_0_left_q <= and_549_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_549_s3_q ? sum_2270 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2272;
      census_changes_values_1_right_q <= select_2273;
      census_changes_values_2_left_q <= select_2274;
      census_changes_values_2_right_q <= select_2275;
      sharpness_last_mask_q <= and_549_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_549_s3_q ? select_2356[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_549_s3_q ? select_2356[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3947;
      box_textured_columns_values_1_q <= select_3950;
      box_textured_columns_values_2_q <= select_3953;
      box_textured_columns_values_3_q <= select_3956;
      box_textured_columns_values_4_q <= select_3959;
      box_textured_sum_sums_values_0_q <= equal_574_s3_q ? box_textured_sum_sums_values_0_q : select_3961;
      box_explained_columns_values_0_q <= select_3965;
      box_explained_columns_values_1_q <= select_3968;
      box_explained_columns_values_2_q <= select_3971;
      box_explained_columns_values_3_q <= select_3974;
      box_explained_columns_values_4_q <= select_3977;
      box_explained_sum_sums_values_0_q <= equal_574_s3_q ? box_explained_sum_sums_values_0_q : select_3979;
      box_shown_columns_values_0_q <= equal_574_s3_q ? box_shown_columns_values_0_q : select_3982;
      box_shown_columns_values_1_q <= select_3986;
      box_shown_columns_values_2_q <= select_3989;
      box_shown_columns_values_3_q <= select_3992;
      box_shown_columns_values_4_q <= select_3995;
      box_shown_sum_sums_values_0_q <= equal_574_s3_q ? box_shown_sum_sums_values_0_q : select_3997;
      box_nearer_columns_values_0_q <= equal_574_s3_q ? box_nearer_columns_values_0_q : select_4000;
      box_nearer_columns_values_1_q <= select_4004;
      box_nearer_columns_values_2_q <= select_4007;
      box_nearer_columns_values_3_q <= select_4010;
      box_nearer_columns_values_4_q <= select_4013;
      box_nearer_sum_sums_values_0_q <= equal_574_s3_q ? box_nearer_sum_sums_values_0_q : select_4015;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4054_s4_q;
  logic or_4117_s4_q;
  logic and_4118_s4_q;
  logic and_4126_s4_q;
  logic and_4129_s4_q;
  logic and_4135_s4_q;
  logic and_4139_s4_q;
  logic and_4145_s4_q;
  logic and_4149_s4_q;
  logic and_4157_s4_q;
  logic and_4162_s4_q;
  logic and_4165_s4_q;
  logic and_4169_s4_q;
  logic [5:0] select_4171_s4_q;
  logic [31:0] select_4188_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4054_s4_q <= said_q;
      or_4117_s4_q <= not_2347 | select_4110;
      and_4118_s4_q <= cfg_prove_i & select_4116;
      and_4126_s4_q <= equal_574_s3_q & (equal_3882_s3_q & (cfg_prove_i & or_4123));
      and_4129_s4_q <= equal_574_s3_q & (equal_3882_s3_q & (cfg_prove_i & or_3863));
      and_4135_s4_q <= and_4135;
      and_4139_s4_q <= equal_574_s3_q & and_4138;
      and_4145_s4_q <= equal_574_s3_q & (equal_3882_s3_q & (not_4131 & or_4142));
      and_4149_s4_q <= and_4149;
      and_4157_s4_q <= equal_574_s3_q & (equal_3882_s3_q & (cfg_prove_i & and_4154));
      and_4162_s4_q <= equal_574_s3_q & (equal_3882_s3_q & select_4160);
      and_4165_s4_q <= and_4165;
      and_4169_s4_q <= and_4169;
      select_4171_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4188_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? select_4186 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4117_s4_q;
  assign marks_nearer_o = and_4118_s4_q;
  assign verdict_valid_o = and_4054_s4_q;
  assign verdict_unproven_yet_o = and_4126_s4_q;
  assign verdict_untextured_o = and_4129_s4_q;
  assign verdict_disagree_o = and_4135_s4_q;
  assign verdict_moved_o = and_4139_s4_q;
  assign verdict_unsharp_left_o = and_4145_s4_q;
  assign verdict_unsharp_right_o = and_4149_s4_q;
  assign verdict_hidden_o = and_4157_s4_q;
  assign verdict_overlooked_o = and_4162_s4_q;
  assign verdict_out_of_step_o = and_4165_s4_q;
  assign frame_valid_o = and_4169_s4_q;
  assign frame_index_o = select_4171_s4_q;
  assign frame_word_o = select_4188_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3778[4:0], sum_3749[1:0], sum_3709[1:0], product_3610[4:0], sum_2741[0], difference_2682[1:0], detail_4[1:0], detail_3[1:0], sum_2280[4:0], sum_1714[0], sum_1710[0], sum_731[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
