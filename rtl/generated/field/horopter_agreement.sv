// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3100 bits, pipeline 842 bits, memories 66591 bits.
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
  logic not_2356;
  assign not_2356 = ~cfg_prove_i;
  logic [5:0] sum_2569;
  assign sum_2569 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_2574;
  assign less_2574 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_3601;
  assign difference_3601 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3794;
  assign not_3794 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3852;
  assign difference_3852 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4102;
  assign sum_4102 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4103;
  assign select_4103 = (6'h4 < cfg_height_i[8:3]) ? {sum_4102, cfg_height_i[4:3]} : 8'h0;

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
  logic [2:0] select_512;
  assign select_512 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_516;
  assign select_516 = select_512[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_520;
  assign or_520 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_521;
  assign select_521 = select_512[0] ? averager_inside_q : or_520;
  // hls/stages/census.hpp:42
  logic or_522;
  assign or_522 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:422
  logic and_524;
  assign and_524 = select_521 & (select_512[0] & or_522);
  // hls/stages/census.hpp:42
  logic [2:0] select_529;
  assign select_529 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_545;
  assign select_545 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_545 : 6'h0;
  // hls/stages/census.hpp:53
  logic equal_547;
  assign equal_547 = select_512 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_548;
  assign equal_548 = select_529 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_549;
  assign and_549 = equal_548 & and_524;
  // hls/stages/agreement.hpp:276
  logic and_551;
  assign and_551 = sample_pair_whole_q & (equal_547 & and_549);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:630
  logic equal_580;
  assign equal_580 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic or_581;
  assign or_581 = so | equal_580;
  // hls/stages/agreement.hpp:599
  logic [7:0] sum_582;
  assign sum_582 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:601
  logic [7:0] select_583;
  assign select_583 = run_shift_q[5] ? x_q : sum_582;
  logic less_584;
  assign less_584 = {2'h0, last_q} < select_583;
  // hls/stages/agreement.hpp:226
  logic not_585;
  assign not_585 = ~less_584;
  // hls/stages/agreement.hpp:621
  logic equal_595;
  assign equal_595 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:622
  logic equal_596;
  assign equal_596 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_597;
  assign and_597 = equal_596 & not_585;
  logic select_599;
  assign select_599 = or_581 ? not_585 : (equal_595 ? not_585 : and_597);
  // hls/stages/agreement.hpp:805
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:803
  logic [6:0] sum_614;
  assign sum_614 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_619;
  assign and_619 = equal_595 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_614} < select_583))));
  logic select_620;
  assign select_620 = or_581 ? not_585 : and_619;
  // hls/stages/agreement.hpp:828
  logic [5:0] right;
  assign right = sum_582[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:727
  logic not_652;
  assign not_652 = ~or_581;
  // hls/stages/agreement.hpp:149
  logic and_655;
  assign and_655 = not_652 & ((~equal_595) & and_597);
  // hls/stages/census.hpp:42
  logic [5:0] select_682;
  assign select_682 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_682 : 6'h0;
  // hls/stages/patches.hpp:396
  logic not_1679;
  assign not_1679 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_1682;
  assign not_1682 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_1683;
  assign and_1683 = patches_capturing_q & not_1682;
  // hls/stages/patches.hpp:368
  logic equal_1684;
  assign equal_1684 = {or_522, select_529} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_1686;
  assign equal_1686 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1691;
  assign and_1691 = (not_1679 & (patches_work_q == 3'h0)) & (~(and_1683 | ((~equal_1684) | (~equal_1686))));
  // hls/stages/patches.hpp:537
  logic equal_1782;
  assign equal_1782 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_1783;
  assign not_1783 = ~equal_1782;
  // hls/stages/patches.hpp:509
  logic equal_1784;
  assign equal_1784 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_1785;
  assign not_1785 = ~equal_1784;
  // hls/stages/patches.hpp:503
  logic equal_1786;
  assign equal_1786 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1787;
  assign equal_1787 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1788;
  assign or_1788 = equal_1786 | equal_1787;
  // hls/stages/patches.hpp:464
  logic not_1789;
  assign not_1789 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1811;
  assign select_1811 = and_1691 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1812;
  assign select_1812 = row_starts ? select_1811 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1814;
  assign and_1814 = and_1683 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1818;
  assign select_1818 = row_starts ? (and_1691 | (and_1683 & (~and_1814))) : patches_capturing_q;
  // hls/stages/agreement.hpp:275
  logic and_1826;
  assign and_1826 = not_1783 & (not_1785 & (or_1788 & (patches_second_q & equal_1787)));
  // hls/stages/patches.hpp:168
  logic not_1842;
  assign not_1842 = ~equal_1787;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1858;
  assign select_1858 = row_starts ? {select_1811[4], select_1811[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_1868;
  assign and_1868 = not_1783 & (or_1788 & not_1785);
  // hls/stages/agreement.hpp:190
  logic and_1974;
  assign and_1974 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2146;
  assign select_2146 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_512 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2149;
  assign select_2149 = sample_pair_whole_q ? (sample_last_q ? (select_529 + 3'h1) : select_529) : raster_at_y_q;
  logic [5:0] select_2152;
  assign select_2152 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_545 + {5'h0, equal_547})) : raster_at_column_q;
  logic [5:0] select_2155;
  assign select_2155 = sample_pair_whole_q ? (sample_last_q ? (select_682 + {5'h0, equal_548}) : select_682) : raster_at_row_q;
  logic select_2159;
  assign select_2159 = sample_pair_whole_q ? (sample_last_q ? (or_522 & (~raster_final_row_q)) : or_522) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2161;
  assign select_2161 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2165;
  assign select_2165 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2474;
  assign sum_2474 = {1'b0, last} + 7'h1;
  logic equal_2475;
  assign equal_2475 = {sum_2474[6], cfg_width_i[8:3]} == {1'b0, sum_2474[5:0]};
  // hls/stages/agreement.hpp:468
  logic and_2476;
  assign and_2476 = and_551 & equal_2475;
  // hls/stages/agreement.hpp:530
  logic select_2479;
  assign select_2479 = (and_2476 | (~ends_cell_q)) ? and_2476 : ends_q;
  // hls/stages/agreement.hpp:536
  logic [2:0] now;
  assign now = select_2479 ? (and_2476 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:541
  logic [5:0] select_2483;
  assign select_2483 = select_2479 ? (and_2476 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2486;
  assign select_2486 = select_2479 ? (following_last_shift_q & (~and_2476)) : run_last_shift_q;
  // hls/stages/agreement.hpp:614
  logic and_2489;
  assign and_2489 = run_last_shift_q & equal_595;
  // hls/stages/agreement.hpp:623
  logic select_2491;
  assign select_2491 = equal_595 ? (~run_last_shift_q) : equal_596;
  // hls/stages/agreement.hpp:627
  logic equal_2492;
  assign equal_2492 = run_phase_q == 3'h1;
  logic not_2495;
  assign not_2495 = ~select_2491;
  // hls/stages/agreement.hpp:630
  logic equal_2497;
  assign equal_2497 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:614
  logic and_2498;
  assign and_2498 = final_row_q & so;
  // hls/stages/agreement.hpp:627
  logic [1:0] select_2499;
  assign select_2499 = equal_2497 ? 2'h1 : {2{and_2498}};
  logic [2:0] select_2501;
  assign select_2501 = (and_2489 | (select_2491 | equal_2492)) ? (equal_2492 ? 3'h2 : {not_2495, {2{select_2491}}}) : (equal_580 ? 3'h6 : {select_2499[0], select_2499});
  // hls/stages/agreement.hpp:614
  logic and_2504;
  assign and_2504 = select_2491 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:637
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2507;
  assign select_2507 = (plan_shift_q[5] & select_2491) ? value : 7'h0;
  logic [1:0] or_2508;
  assign or_2508 = {2{so}} | select_2507[5:4];
  // hls/stages/agreement.hpp:640
  logic [7:0] select_2509;
  assign select_2509 = select_2491 ? plan_columns_q : 8'h0;
  logic [6:0] or_2512;
  assign or_2512 = select_2509[6:0] | ((equal_2492 | equal_2497) ? whole_q : 7'h0);
  logic [1:0] or_2513;
  assign or_2513 = {2{and_2489}} | or_2512[3:2];
  // hls/stages/agreement.hpp:641
  logic [6:0] or_2515;
  assign or_2515 = {or_2512[6:4], or_2513, or_2512[1:0]} | (equal_580 ? drawn_q : 7'h0);
  logic [4:0] or_2516;
  assign or_2516 = {5{so}} | {or_2515[6], or_2515[3:0]};
  // hls/stages/agreement.hpp:647
  logic not_2520;
  assign not_2520 = ~run_shift_q[5];
  logic [6:0] difference_2522;
  assign difference_2522 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2523;
  assign select_2523 = equal_595 ? ({{7{not_2520}}, 1'b1} + run_span_q) : {difference_2522[6], difference_2522};
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2527;
  assign select_2527 = and_2476 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:533
  logic [7:0] select_2529;
  assign select_2529 = select_2479 ? {select_2527[6], select_2527} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2532;
  assign select_2532 = select_2479 ? (and_2476 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:527
  logic [5:0] select_2540;
  assign select_2540 = and_551 ? (equal_2475 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:480
  logic [4:0] sum_2541;
  assign sum_2541 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:527
  logic [6:0] select_2543;
  assign select_2543 = and_551 ? (equal_2475 ? {sum_2541, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2544;
  assign sum_2544 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:527
  logic [6:0] select_2546;
  assign select_2546 = and_551 ? (equal_2475 ? {sum_2544, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:538
  logic select_2560;
  assign select_2560 = (ends_cell_q | select_2479) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_595 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:533
  logic and_2564;
  assign and_2564 = (~select_2479) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:483
  logic [6:0] sum_2565;
  assign sum_2565 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:464
  logic select_2567;
  assign select_2567 = equal_2475 ? ({sum_2565[6], cfg_height_i[8:3]} == {1'b0, sum_2565[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2953;
  assign select_2953 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2954;
  assign select_2954 = sample_pair_whole_q ? select_2953 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_2955;
  assign and_2955 = not_1682 & equal_1684;
  logic [8:0] select_2956;
  assign select_2956 = and_2955 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2957;
  assign select_2957 = and_2955 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2958;
  assign select_2958 = sample_pair_first_q ? select_2956 : select_2957;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2960;
  assign select_2960 = sample_pair_whole_q ? (row_starts ? select_2958[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2962;
  assign select_2962 = sample_pair_whole_q ? (row_starts ? select_2958[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2965;
  assign select_2965 = sample_pair_whole_q ? (equal_1686 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2967;
  assign select_2967 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1686}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2968;
  assign equal_2968 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_2969;
  assign not_2969 = ~equal_2968;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2971;
  assign select_2971 = sample_pair_whole_q ? (phase + {not_2969, 1'b1, not_2969, equal_2968}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:477
  logic equal_2973;
  assign equal_2973 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2977;
  assign select_2977 = equal_2973 ? ((select_2954 == 4'h6) ? 4'h0 : (select_2954 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2978;
  assign equal_2978 = select_2977 == 4'h0;
  // hls/stages/agreement.hpp:464
  logic [3:0] select_2981;
  assign select_2981 = equal_2475 ? (equal_2978 ? 4'h6 : (select_2977 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2983;
  assign select_2983 = equal_2973 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:464
  logic [4:0] select_2985;
  assign select_2985 = equal_2475 ? (select_2983 + {4'h0, equal_2978}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:527
  logic select_2990;
  assign select_2990 = and_551 ? (equal_2475 ? ((6'h2 < row) & equal_2978) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2992;
  assign select_2992 = and_551 ? (equal_2475 ? select_2983 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3015;
  assign sum_3015 = {1'b0, select_682[5:1]} + 6'h1;
  logic less_3016;
  assign less_3016 = {sum_3015, select_682[0], select_529, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3019;
  assign select_3019 = row_starts ? (and_1691 ? (~less_3016) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3058;
  assign or_3058 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3063;
  assign select_3063 = (patches_second_q | patches_begins_q) ? not_1679 : (patches_ends_q & equal_1782);
  logic and_3064;
  assign and_3064 = equal_1782 & not_1789;
  // hls/stages/patches.hpp:403
  logic and_3065;
  assign and_3065 = not_1842 & and_3064;
  logic [1:0] select_3067;
  assign select_3067 = equal_1784 ? 2'h0 : (equal_1786 ? 2'h3 : {equal_1787, and_3065});
  // hls/stages/patches.hpp:283
  logic equal_3069;
  assign equal_3069 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3070;
  assign not_3070 = ~equal_3069;
  // hls/stages/patches.hpp:283
  logic equal_3071;
  assign equal_3071 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3072;
  assign not_3072 = ~equal_3071;
  // hls/stages/patches.hpp:287
  logic not_3074;
  assign not_3074 = ~(patches_following_q == 3'h2);
  logic and_3077;
  assign and_3077 = (~(patches_following_q == 3'h1)) & not_3074;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3078;
  assign select_3078 = equal_3071 ? 2'h2 : {and_3077, not_3074};
  logic [3:0] select_3079;
  assign select_3079 = equal_3069 ? 4'h2 : {select_3078, {2{not_3072}}};
  // hls/stages/patches.hpp:409
  logic not_3082;
  assign not_3082 = ~or_3058;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3087;
  assign select_3087 = or_3058 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3089;
  assign select_3089 = or_3058 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1382; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign fresh_re = s0_en & and_655;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1383; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign left_re = s0_en & select_599;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1384; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_581 ? x_q[5:0] : (equal_595 ? sum_582[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_599;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1385; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_581 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_620;
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
  assign patches_right_0_re = s0_en & (not_1783 & (not_1785 & (or_1788 & (equal_1787 & not_1789))));
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
  assign patches_right_1_re = s0_en & and_1826;
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
  assign patches_left_re = s0_en & (not_1783 & (not_1785 & (not_1842 & or_1788)));
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
  assign patches_columns_above_re = s0_en & and_1868;
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
      left_first_q <= and_1974 ? left_first_q : marks_first_i;
      right_q <= (~and_1974) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1974;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2146;
      raster_at_y_q <= select_2149;
      raster_at_column_q <= select_2152;
      raster_at_row_q <= select_2155;
      raster_at_live_q <= select_2159;
      raster_rows_left_q <= sample_pair_whole_q ? select_2161 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2165;
      averager_place_q <= sample_pair_whole_q ? select_516 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_521 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2483;
      run_last_shift_q <= select_2486;
      run_span_q <= select_2479 ? (and_2476 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2501;
      following_shift_q <= select_2491 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2504;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2507[6], or_2508, select_2507[3:0]};
      following_columns_q <= {select_2509[7], or_2516[4], or_2515[5:4], or_2516[3:0]};
      plan_shift_q <= equal_595 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2523;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2529;
      columns_left_q <= select_2532;
      last_q <= and_551 ? (equal_2475 ? last : last_q) : last_q;
      least_q <= select_2540;
      whole_q <= select_2543;
      drawn_q <= select_2546;
      age_q <= select_2479 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2479 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2560;
      ends_q <= and_2564;
      final_row_q <= and_551 ? select_2567 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2954;
      patches_band_rows_rows_to_next_q <= select_2960;
      patches_band_rows_number_q <= select_2962;
      patches_next_band_rows_to_next_q <= select_2965;
      patches_next_band_number_q <= select_2967;
      patches_first_band_rows_to_next_q <= select_2971;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2968 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_551 ? select_2981 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_551 ? select_2985 : patches_choosing_number_q;
      patches_chooses_q <= select_2990;
      patches_choosing_band_q <= select_2992;
      patches_capturing_q <= sample_pair_whole_q ? select_1818 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3019 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1812 : patches_row_q;
      patches_work_q <= or_3058 ? following : patches_work_q;
      patches_second_q <= select_3063;
      patches_following_q <= equal_1782 ? {2'h0, and_3064} : {equal_1784, select_3067};
      patches_following_beats_q <= {select_3079, not_3070};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1814);
      patches_ends_q <= not_3082 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3087;
      patches_code_row_q <= select_3089;
      patches_column_q <= or_3058 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3082 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_512_s1_q;
  logic row_starts_s1_q;
  logic [7:0] select_516_s1_q;
  logic and_524_s1_q;
  logic equal_530_s1_q;
  logic [5:0] select_545_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_549_s1_q;
  logic and_551_s1_q;
  logic equal_576_s1_q;
  logic so_s1_q;
  logic equal_580_s1_q;
  logic or_581_s1_q;
  logic less_584_s1_q;
  logic not_585_s1_q;
  logic equal_595_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_620_s1_q;
  logic [5:0] right_s1_q;
  logic and_655_s1_q;
  logic [5:0] row_s1_q;
  logic and_1567_s1_q;
  logic equal_1568_s1_q;
  logic and_1691_s1_q;
  logic equal_1782_s1_q;
  logic not_1783_s1_q;
  logic equal_1784_s1_q;
  logic not_1785_s1_q;
  logic equal_1786_s1_q;
  logic equal_1787_s1_q;
  logic or_1788_s1_q;
  logic not_1789_s1_q;
  logic [4:0] select_1812_s1_q;
  logic select_1818_s1_q;
  logic [3:0] select_1858_s1_q;
  logic and_1868_s1_q;
  logic equal_2475_s1_q;
  logic and_2476_s1_q;
  logic or_3058_s1_q;
  logic not_3082_s1_q;
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
      select_512_s1_q <= select_512;
      row_starts_s1_q <= row_starts;
      select_516_s1_q <= select_516;
      and_524_s1_q <= and_524;
      equal_530_s1_q <= select_529 == 3'h0;
      select_545_s1_q <= select_545;
      last_s1_2_q <= last;
      and_549_s1_q <= and_549;
      and_551_s1_q <= and_551;
      equal_576_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_580_s1_q <= equal_580;
      or_581_s1_q <= or_581;
      less_584_s1_q <= less_584;
      not_585_s1_q <= not_585;
      equal_595_s1_q <= equal_595;
      x_s1_2_q <= x[6:0];
      select_620_s1_q <= select_620;
      right_s1_q <= right;
      and_655_s1_q <= and_655;
      row_s1_q <= row;
      and_1567_s1_q <= not_652 & and_619;
      equal_1568_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1691_s1_q <= and_1691;
      equal_1782_s1_q <= equal_1782;
      not_1783_s1_q <= not_1783;
      equal_1784_s1_q <= equal_1784;
      not_1785_s1_q <= not_1785;
      equal_1786_s1_q <= equal_1786;
      equal_1787_s1_q <= equal_1787;
      or_1788_s1_q <= or_1788;
      not_1789_s1_q <= not_1789;
      select_1812_s1_q <= select_1812;
      select_1818_s1_q <= select_1818;
      select_1858_s1_q <= select_1858;
      and_1868_s1_q <= and_1868;
      equal_2475_s1_q <= equal_2475;
      and_2476_s1_q <= and_2476;
      or_3058_s1_q <= or_3058;
      not_3082_s1_q <= not_3082;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic late_q;
  logic draws_late_q;
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
  logic done_q;
  logic proven_q;
  logic drew_q;
  logic said_q;
  // hls/stages/census.hpp:127
  logic and_525;
  assign and_525 = sample_pair_whole_s1_q & and_524_s1_q;
  // hls/stages/agreement.hpp:675
  logic equal_570;
  assign equal_570 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_571;
  assign equal_571 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_570 & equal_571;
  // hls/stages/moments.hpp:57
  logic [11:0] select_574;
  assign select_574 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:795
  logic [10:0] select_575;
  assign select_575 = first ? 11'h0 : select_574[10:0];
  // hls/stages/agreement.hpp:1016
  logic not_577;
  assign not_577 = ~equal_576_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_579;
  assign not_579 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_581_s1_q & not_585_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_574;
  // hls/stages/moments.hpp:104
  logic not_589;
  assign not_589 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:795
  logic and_593;
  assign and_593 = not_577 & (not_579 & (equal_580_s1_q & (inside_v & not_589)));
  // hls/stages/agreement.hpp:982
  logic and_610;
  assign and_610 = (or_581_s1_q & (left_rdata_q[67] & not_585_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:973
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:974
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:975
  logic [5:0] select_629;
  assign select_629 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:676
  logic or_753;
  assign or_753 = late_q | (~equal_570);
  // hls/stages/agreement.hpp:678
  logic and_754;
  assign and_754 = left_rdata_q[12] & or_753;
  logic and_755;
  assign and_755 = left_rdata_q[30] & or_753;
  logic and_756;
  assign and_756 = left_rdata_q[48] & or_753;
  logic and_757;
  assign and_757 = left_rdata_q[66] & or_753;
  // hls/stages/agreement.hpp:679
  logic and_758;
  assign and_758 = right_codes_rdata_q[12] & or_753;
  logic and_759;
  assign and_759 = right_codes_rdata_q[27] & or_753;
  logic and_760;
  assign and_760 = right_codes_rdata_q[42] & or_753;
  logic and_761;
  assign and_761 = right_codes_rdata_q[57] & or_753;
  logic and_762;
  assign and_762 = right_codes_rdata_q[72] & or_753;
  logic and_763;
  assign and_763 = right_codes_rdata_q[85] & or_753;
  // hls/stages/agreement.hpp:221
  logic and_768;
  assign and_768 = left_rdata_q[48] & not_585_s1_q;
  logic and_769;
  assign and_769 = right_codes_rdata_q[42] & not_585_s1_q;
  logic [11:0] select_770;
  assign select_770 = less_584_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_771;
  assign select_771 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_775;
  assign select_775 = and_768 ? (and_769 ? (~(select_770 ^ select_771)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_781;
  assign parity_781 = ^select_775[5:3];
  logic parity_784;
  assign parity_784 = ^select_775[8:6];
  logic parity_787;
  assign parity_787 = ^select_775[11:3];
  // hls/stages/agreement.hpp:221
  logic and_791;
  assign and_791 = left_rdata_q[66] & not_585_s1_q;
  logic and_792;
  assign and_792 = right_codes_rdata_q[57] & not_585_s1_q;
  logic [11:0] select_793;
  assign select_793 = less_584_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_794;
  assign select_794 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_798;
  assign select_798 = and_791 ? (and_792 ? (~(select_793 ^ select_794)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_801;
  assign parity_801 = ^select_798[8:6];
  logic parity_804;
  assign parity_804 = ^select_798[11:9];
  // hls/stages/agreement.hpp:221
  logic and_808;
  assign and_808 = left_rdata_q[84] & not_585_s1_q;
  logic and_809;
  assign and_809 = right_codes_rdata_q[72] & not_585_s1_q;
  logic [11:0] select_810;
  assign select_810 = less_584_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_811;
  assign select_811 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_815;
  assign select_815 = and_808 ? (and_809 ? (~(select_810 ^ select_811)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_821;
  assign parity_821 = ^select_815[2:0];
  logic parity_824;
  assign parity_824 = ^select_815[5:3];
  logic parity_827;
  assign parity_827 = ^select_815[8:0];
  logic parity_833;
  assign parity_833 = ^select_815[11:9];
  logic parity_836;
  assign parity_836 = ^select_798[2:0];
  logic parity_839;
  assign parity_839 = ^{select_815[11:9], select_798[5:0]};
  logic parity_842;
  assign parity_842 = ^{select_815, select_798, select_775[2:0]};
  logic xor_843;
  assign xor_843 = parity_787 ^ parity_842;
  // hls/stages/count_bits.hpp:23
  logic or_847;
  assign or_847 = (select_775[1:0] == 2'h3) | (select_775[2] & (select_775[0] | select_775[1]));
  // hls/stages/count_bits.hpp:25
  logic or_851;
  assign or_851 = (select_798[7:6] == 2'h3) | (select_798[8] & (select_798[6] | select_798[7]));
  logic or_855;
  assign or_855 = (select_798[10:9] == 2'h3) | (select_798[11] & (select_798[9] | select_798[10]));
  // hls/stages/count_bits.hpp:23
  logic or_863;
  assign or_863 = (select_815[7:6] == 2'h3) | (select_815[8] & (~(select_815[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_867;
  assign or_867 = (select_815[1:0] == 2'h3) | (select_815[2] & (select_815[0] | select_815[1]));
  logic or_871;
  assign or_871 = (select_815[4:3] == 2'h3) | (select_815[5] & (select_815[3] | select_815[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_874;
  assign parity_874 = ^{or_871, or_867, or_863};
  // hls/stages/count_bits.hpp:23
  logic or_878;
  assign or_878 = (select_798[4:3] == 2'h3) | (select_798[5] & (select_798[3] | select_798[4]));
  // hls/stages/count_bits.hpp:25
  logic or_882;
  assign or_882 = (select_815[10:9] == 2'h3) | (select_815[11] & (select_815[9] | select_815[10]));
  logic or_886;
  assign or_886 = (select_798[1:0] == 2'h3) | (select_798[2] & (select_798[0] | select_798[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_889;
  assign parity_889 = ^{or_886, or_882, or_878};
  logic parity_892;
  assign parity_892 = ^{or_886, or_882, or_878, or_871, or_867, or_863, or_855, or_851, or_847};
  // hls/stages/count_bits.hpp:25
  logic and_893;
  assign and_893 = parity_787 & parity_842;
  logic or_897;
  assign or_897 = (parity_781 & parity_784) | ((^select_775[11:9]) & (parity_781 | parity_784));
  logic and_900;
  assign and_900 = (^{select_798[11:6], select_775[2:0]}) & (parity_827 | parity_839);
  logic or_901;
  assign or_901 = (parity_827 & parity_839) | and_900;
  // hls/stages/count_bits.hpp:23
  logic or_908;
  assign or_908 = (select_775[10:9] == 2'h3) | (select_775[11] & (select_775[9] | select_775[10]));
  // hls/stages/count_bits.hpp:25
  logic or_912;
  assign or_912 = (select_775[4:3] == 2'h3) | (select_775[5] & (select_775[3] | select_775[4]));
  logic or_916;
  assign or_916 = (select_775[7:6] == 2'h3) | (select_775[8] & (select_775[6] | select_775[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_919;
  assign parity_919 = ^{or_916, or_912, or_908};
  // hls/stages/count_bits.hpp:25
  logic or_923;
  assign or_923 = (parity_801 & parity_804) | ((^select_775[2:0]) & (parity_801 | parity_804));
  logic or_927;
  assign or_927 = (parity_821 & parity_824) | ((^select_815[8:6]) & (parity_821 | parity_824));
  logic or_931;
  assign or_931 = (parity_833 & parity_836) | ((^select_798[5:3]) & (parity_833 | parity_836));
  // hls/stages/count_bits.hpp:24
  logic parity_934;
  assign parity_934 = ^{or_931, or_927, or_923};
  logic parity_937;
  assign parity_937 = ^{or_931, or_927, or_923, or_916, or_912, or_908, or_901, or_897, and_893};
  logic xor_938;
  assign xor_938 = parity_892 ^ parity_937;
  // hls/stages/count_bits.hpp:25
  logic and_939;
  assign and_939 = parity_892 & parity_937;
  logic or_943;
  assign or_943 = (parity_874 & parity_889) | ((^{or_855, or_851, or_847}) & (parity_874 | parity_889));
  logic or_947;
  assign or_947 = (parity_919 & parity_934) | ((^{or_901, or_897, and_893}) & (parity_919 | parity_934));
  logic or_954;
  assign or_954 = (or_851 & or_855) | (or_847 & (or_851 | or_855));
  logic or_958;
  assign or_958 = (or_867 & or_871) | (or_863 & (or_867 | or_871));
  logic or_962;
  assign or_962 = (or_882 & or_886) | (or_878 & (or_882 | or_886));
  // hls/stages/count_bits.hpp:24
  logic parity_965;
  assign parity_965 = ^{or_962, or_958, or_954};
  // hls/stages/count_bits.hpp:25
  logic or_969;
  assign or_969 = (or_897 & or_901) | (and_893 & (or_897 | or_901));
  logic or_973;
  assign or_973 = (or_912 & or_916) | (or_908 & (or_912 | or_916));
  logic or_977;
  assign or_977 = (or_927 & or_931) | (or_923 & (or_927 | or_931));
  // hls/stages/count_bits.hpp:24
  logic parity_980;
  assign parity_980 = ^{or_977, or_973, or_969};
  logic parity_983;
  assign parity_983 = ^{or_977, or_973, or_969, or_962, or_958, or_954, or_947, or_943, and_939};
  // hls/stages/count_bits.hpp:25
  logic or_987;
  assign or_987 = (parity_965 & parity_980) | ((^{or_947, or_943, and_939}) & (parity_965 | parity_980));
  logic or_991;
  assign or_991 = (or_943 & or_947) | (and_939 & (or_943 | or_947));
  logic or_995;
  assign or_995 = (or_958 & or_962) | (or_954 & (or_958 | or_962));
  logic or_999;
  assign or_999 = (or_973 & or_977) | (or_969 & (or_973 | or_977));
  // hls/stages/count_bits.hpp:24
  logic parity_1004;
  assign parity_1004 = ^{or_999, or_995, or_991, or_987};
  // hls/stages/count_bits.hpp:25
  logic or_1008;
  assign or_1008 = (or_995 & or_999) | (or_991 & (or_995 | or_999));
  logic and_1009;
  assign and_1009 = or_987 & (^{or_999, or_995, or_991});
  // hls/stages/count_bits.hpp:24
  logic xor_1010;
  assign xor_1010 = or_1008 ^ and_1009;
  // hls/stages/count_bits.hpp:27
  logic and_1011;
  assign and_1011 = or_1008 & and_1009;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1012;
  assign select_1012 = equal_595_s1_q ? {and_1011, xor_1010, parity_1004, parity_983, xor_938, xor_843} : 6'h0;
  logic [5:0] column;
  assign column = or_581_s1_q ? 6'h0 : select_1012;
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1023;
  assign select_1023 = (slot_s1_q[0] ? and_809 : and_792) ? (~(select_770 ^ (slot_s1_q[0] ? select_811 : select_794))) : 12'h0;
  logic [11:0] select_1024;
  assign select_1024 = and_768 ? select_1023 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1030;
  assign parity_1030 = ^select_1024[5:3];
  logic parity_1033;
  assign parity_1033 = ^select_1024[8:6];
  logic parity_1036;
  assign parity_1036 = ^select_1024[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1040;
  assign and_1040 = right_codes_rdata_q[85] & not_585_s1_q;
  logic [11:0] select_1042;
  assign select_1042 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1046;
  assign select_1046 = (slot_s1_q[0] ? and_1040 : and_809) ? (~(select_793 ^ (slot_s1_q[0] ? select_1042 : select_811))) : 12'h0;
  logic [11:0] select_1047;
  assign select_1047 = and_791 ? select_1046 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1050;
  assign parity_1050 = ^select_1047[8:6];
  logic parity_1053;
  assign parity_1053 = ^select_1047[11:9];
  // hls/stages/agreement.hpp:741
  logic select_1058;
  assign select_1058 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_585_s1_q) : and_1040;
  logic [11:0] select_1060;
  assign select_1060 = slot_s1_q[0] ? (less_584_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1042;
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1064;
  assign select_1064 = and_808 ? (select_1058 ? (~(select_810 ^ select_1060)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1070;
  assign parity_1070 = ^select_1064[2:0];
  logic parity_1073;
  assign parity_1073 = ^select_1064[5:3];
  logic parity_1076;
  assign parity_1076 = ^select_1064[8:0];
  logic parity_1082;
  assign parity_1082 = ^select_1064[11:9];
  logic parity_1085;
  assign parity_1085 = ^select_1047[2:0];
  logic parity_1088;
  assign parity_1088 = ^{select_1064[11:9], select_1047[5:0]};
  logic parity_1091;
  assign parity_1091 = ^{select_1064, select_1047, select_1024[2:0]};
  logic xor_1092;
  assign xor_1092 = parity_1036 ^ parity_1091;
  // hls/stages/count_bits.hpp:23
  logic or_1096;
  assign or_1096 = (select_1024[1:0] == 2'h3) | (select_1024[2] & (select_1024[0] | select_1024[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1100;
  assign or_1100 = (select_1047[7:6] == 2'h3) | (select_1047[8] & (select_1047[6] | select_1047[7]));
  logic or_1104;
  assign or_1104 = (select_1047[10:9] == 2'h3) | (select_1047[11] & (select_1047[9] | select_1047[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1112;
  assign or_1112 = (select_1064[7:6] == 2'h3) | (select_1064[8] & (~(select_1064[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1116;
  assign or_1116 = (select_1064[1:0] == 2'h3) | (select_1064[2] & (select_1064[0] | select_1064[1]));
  logic or_1120;
  assign or_1120 = (select_1064[4:3] == 2'h3) | (select_1064[5] & (select_1064[3] | select_1064[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1123;
  assign parity_1123 = ^{or_1120, or_1116, or_1112};
  // hls/stages/count_bits.hpp:23
  logic or_1127;
  assign or_1127 = (select_1047[4:3] == 2'h3) | (select_1047[5] & (select_1047[3] | select_1047[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1131;
  assign or_1131 = (select_1064[10:9] == 2'h3) | (select_1064[11] & (select_1064[9] | select_1064[10]));
  logic or_1135;
  assign or_1135 = (select_1047[1:0] == 2'h3) | (select_1047[2] & (select_1047[0] | select_1047[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1138;
  assign parity_1138 = ^{or_1135, or_1131, or_1127};
  logic parity_1141;
  assign parity_1141 = ^{or_1135, or_1131, or_1127, or_1120, or_1116, or_1112, or_1104, or_1100, or_1096};
  // hls/stages/count_bits.hpp:25
  logic and_1142;
  assign and_1142 = parity_1036 & parity_1091;
  logic or_1146;
  assign or_1146 = (parity_1030 & parity_1033) | ((^select_1024[11:9]) & (parity_1030 | parity_1033));
  logic and_1149;
  assign and_1149 = (^{select_1047[11:6], select_1024[2:0]}) & (parity_1076 | parity_1088);
  logic or_1150;
  assign or_1150 = (parity_1076 & parity_1088) | and_1149;
  // hls/stages/count_bits.hpp:23
  logic or_1157;
  assign or_1157 = (select_1024[10:9] == 2'h3) | (select_1024[11] & (select_1024[9] | select_1024[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1161;
  assign or_1161 = (select_1024[4:3] == 2'h3) | (select_1024[5] & (select_1024[3] | select_1024[4]));
  logic or_1165;
  assign or_1165 = (select_1024[7:6] == 2'h3) | (select_1024[8] & (select_1024[6] | select_1024[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1168;
  assign parity_1168 = ^{or_1165, or_1161, or_1157};
  // hls/stages/count_bits.hpp:25
  logic or_1172;
  assign or_1172 = (parity_1050 & parity_1053) | ((^select_1024[2:0]) & (parity_1050 | parity_1053));
  logic or_1176;
  assign or_1176 = (parity_1070 & parity_1073) | ((^select_1064[8:6]) & (parity_1070 | parity_1073));
  logic or_1180;
  assign or_1180 = (parity_1082 & parity_1085) | ((^select_1047[5:3]) & (parity_1082 | parity_1085));
  // hls/stages/count_bits.hpp:24
  logic parity_1183;
  assign parity_1183 = ^{or_1180, or_1176, or_1172};
  logic parity_1186;
  assign parity_1186 = ^{or_1180, or_1176, or_1172, or_1165, or_1161, or_1157, or_1150, or_1146, and_1142};
  logic xor_1187;
  assign xor_1187 = parity_1141 ^ parity_1186;
  // hls/stages/count_bits.hpp:25
  logic and_1188;
  assign and_1188 = parity_1141 & parity_1186;
  logic or_1192;
  assign or_1192 = (parity_1123 & parity_1138) | ((^{or_1104, or_1100, or_1096}) & (parity_1123 | parity_1138));
  logic or_1196;
  assign or_1196 = (parity_1168 & parity_1183) | ((^{or_1150, or_1146, and_1142}) & (parity_1168 | parity_1183));
  logic or_1203;
  assign or_1203 = (or_1100 & or_1104) | (or_1096 & (or_1100 | or_1104));
  logic or_1207;
  assign or_1207 = (or_1116 & or_1120) | (or_1112 & (or_1116 | or_1120));
  logic or_1211;
  assign or_1211 = (or_1131 & or_1135) | (or_1127 & (or_1131 | or_1135));
  // hls/stages/count_bits.hpp:24
  logic parity_1214;
  assign parity_1214 = ^{or_1211, or_1207, or_1203};
  // hls/stages/count_bits.hpp:25
  logic or_1218;
  assign or_1218 = (or_1146 & or_1150) | (and_1142 & (or_1146 | or_1150));
  logic or_1222;
  assign or_1222 = (or_1161 & or_1165) | (or_1157 & (or_1161 | or_1165));
  logic or_1226;
  assign or_1226 = (or_1176 & or_1180) | (or_1172 & (or_1176 | or_1180));
  // hls/stages/count_bits.hpp:24
  logic parity_1229;
  assign parity_1229 = ^{or_1226, or_1222, or_1218};
  logic parity_1232;
  assign parity_1232 = ^{or_1226, or_1222, or_1218, or_1211, or_1207, or_1203, or_1196, or_1192, and_1188};
  // hls/stages/count_bits.hpp:25
  logic or_1236;
  assign or_1236 = (parity_1214 & parity_1229) | ((^{or_1196, or_1192, and_1188}) & (parity_1214 | parity_1229));
  logic or_1240;
  assign or_1240 = (or_1192 & or_1196) | (and_1188 & (or_1192 | or_1196));
  logic or_1244;
  assign or_1244 = (or_1207 & or_1211) | (or_1203 & (or_1207 | or_1211));
  logic or_1248;
  assign or_1248 = (or_1222 & or_1226) | (or_1218 & (or_1222 | or_1226));
  // hls/stages/count_bits.hpp:24
  logic parity_1253;
  assign parity_1253 = ^{or_1248, or_1244, or_1240, or_1236};
  // hls/stages/count_bits.hpp:25
  logic or_1257;
  assign or_1257 = (or_1244 & or_1248) | (or_1240 & (or_1244 | or_1248));
  logic and_1258;
  assign and_1258 = or_1236 & (^{or_1248, or_1244, or_1240});
  // hls/stages/count_bits.hpp:24
  logic xor_1259;
  assign xor_1259 = or_1257 ^ and_1258;
  // hls/stages/count_bits.hpp:27
  logic and_1260;
  assign and_1260 = or_1257 & and_1258;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1261;
  assign select_1261 = equal_595_s1_q ? {and_1260, xor_1259, parity_1253, parity_1232, xor_1187, xor_1092} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_581_s1_q ? 6'h0 : select_1261;
  // hls/stages/agreement.hpp:221
  logic and_1269;
  assign and_1269 = right_codes_rdata_q[27] & not_585_s1_q;
  // hls/stages/agreement.hpp:741
  logic select_1270;
  assign select_1270 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_585_s1_q) : and_1269;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1272;
  assign select_1272 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:741
  logic [11:0] select_1273;
  assign select_1273 = slot_s1_q[0] ? (less_584_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1272;
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1277;
  assign select_1277 = and_768 ? (select_1270 ? (~(select_770 ^ select_1273)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1283;
  assign parity_1283 = ^select_1277[5:3];
  logic parity_1286;
  assign parity_1286 = ^select_1277[8:6];
  logic parity_1289;
  assign parity_1289 = ^select_1277[11:3];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1297;
  assign select_1297 = (slot_s1_q[0] ? and_1269 : and_769) ? (~(select_793 ^ (slot_s1_q[0] ? select_1272 : select_771))) : 12'h0;
  logic [11:0] select_1298;
  assign select_1298 = and_791 ? select_1297 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1301;
  assign parity_1301 = ^select_1298[8:6];
  logic parity_1304;
  assign parity_1304 = ^select_1298[11:9];
  // hls/stages/agreement.hpp:691
  logic [11:0] select_1312;
  assign select_1312 = (slot_s1_q[0] ? and_769 : and_792) ? (~(select_810 ^ (slot_s1_q[0] ? select_771 : select_794))) : 12'h0;
  logic [11:0] select_1313;
  assign select_1313 = and_808 ? select_1312 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1319;
  assign parity_1319 = ^select_1313[2:0];
  logic parity_1322;
  assign parity_1322 = ^select_1313[5:3];
  logic parity_1325;
  assign parity_1325 = ^select_1313[8:0];
  logic parity_1331;
  assign parity_1331 = ^select_1313[11:9];
  logic parity_1334;
  assign parity_1334 = ^select_1298[2:0];
  logic parity_1337;
  assign parity_1337 = ^{select_1313[11:9], select_1298[5:0]};
  logic parity_1340;
  assign parity_1340 = ^{select_1313, select_1298, select_1277[2:0]};
  logic xor_1341;
  assign xor_1341 = parity_1289 ^ parity_1340;
  // hls/stages/count_bits.hpp:23
  logic or_1345;
  assign or_1345 = (select_1277[1:0] == 2'h3) | (select_1277[2] & (select_1277[0] | select_1277[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1349;
  assign or_1349 = (select_1298[7:6] == 2'h3) | (select_1298[8] & (select_1298[6] | select_1298[7]));
  logic or_1353;
  assign or_1353 = (select_1298[10:9] == 2'h3) | (select_1298[11] & (select_1298[9] | select_1298[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1361;
  assign or_1361 = (select_1313[7:6] == 2'h3) | (select_1313[8] & (~(select_1313[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1365;
  assign or_1365 = (select_1313[1:0] == 2'h3) | (select_1313[2] & (select_1313[0] | select_1313[1]));
  logic or_1369;
  assign or_1369 = (select_1313[4:3] == 2'h3) | (select_1313[5] & (select_1313[3] | select_1313[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1372;
  assign parity_1372 = ^{or_1369, or_1365, or_1361};
  // hls/stages/count_bits.hpp:23
  logic or_1376;
  assign or_1376 = (select_1298[4:3] == 2'h3) | (select_1298[5] & (select_1298[3] | select_1298[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1380;
  assign or_1380 = (select_1313[10:9] == 2'h3) | (select_1313[11] & (select_1313[9] | select_1313[10]));
  logic or_1384;
  assign or_1384 = (select_1298[1:0] == 2'h3) | (select_1298[2] & (select_1298[0] | select_1298[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1387;
  assign parity_1387 = ^{or_1384, or_1380, or_1376};
  logic parity_1390;
  assign parity_1390 = ^{or_1384, or_1380, or_1376, or_1369, or_1365, or_1361, or_1353, or_1349, or_1345};
  // hls/stages/count_bits.hpp:25
  logic and_1391;
  assign and_1391 = parity_1289 & parity_1340;
  logic or_1395;
  assign or_1395 = (parity_1283 & parity_1286) | ((^select_1277[11:9]) & (parity_1283 | parity_1286));
  logic and_1398;
  assign and_1398 = (^{select_1298[11:6], select_1277[2:0]}) & (parity_1325 | parity_1337);
  logic or_1399;
  assign or_1399 = (parity_1325 & parity_1337) | and_1398;
  // hls/stages/count_bits.hpp:23
  logic or_1406;
  assign or_1406 = (select_1277[10:9] == 2'h3) | (select_1277[11] & (select_1277[9] | select_1277[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1410;
  assign or_1410 = (select_1277[4:3] == 2'h3) | (select_1277[5] & (select_1277[3] | select_1277[4]));
  logic or_1414;
  assign or_1414 = (select_1277[7:6] == 2'h3) | (select_1277[8] & (select_1277[6] | select_1277[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1417;
  assign parity_1417 = ^{or_1414, or_1410, or_1406};
  // hls/stages/count_bits.hpp:25
  logic or_1421;
  assign or_1421 = (parity_1301 & parity_1304) | ((^select_1277[2:0]) & (parity_1301 | parity_1304));
  logic or_1425;
  assign or_1425 = (parity_1319 & parity_1322) | ((^select_1313[8:6]) & (parity_1319 | parity_1322));
  logic or_1429;
  assign or_1429 = (parity_1331 & parity_1334) | ((^select_1298[5:3]) & (parity_1331 | parity_1334));
  // hls/stages/count_bits.hpp:24
  logic parity_1432;
  assign parity_1432 = ^{or_1429, or_1425, or_1421};
  logic parity_1435;
  assign parity_1435 = ^{or_1429, or_1425, or_1421, or_1414, or_1410, or_1406, or_1399, or_1395, and_1391};
  logic xor_1436;
  assign xor_1436 = parity_1390 ^ parity_1435;
  // hls/stages/count_bits.hpp:25
  logic and_1437;
  assign and_1437 = parity_1390 & parity_1435;
  logic or_1441;
  assign or_1441 = (parity_1372 & parity_1387) | ((^{or_1353, or_1349, or_1345}) & (parity_1372 | parity_1387));
  logic or_1445;
  assign or_1445 = (parity_1417 & parity_1432) | ((^{or_1399, or_1395, and_1391}) & (parity_1417 | parity_1432));
  logic or_1452;
  assign or_1452 = (or_1349 & or_1353) | (or_1345 & (or_1349 | or_1353));
  logic or_1456;
  assign or_1456 = (or_1365 & or_1369) | (or_1361 & (or_1365 | or_1369));
  logic or_1460;
  assign or_1460 = (or_1380 & or_1384) | (or_1376 & (or_1380 | or_1384));
  // hls/stages/count_bits.hpp:24
  logic parity_1463;
  assign parity_1463 = ^{or_1460, or_1456, or_1452};
  // hls/stages/count_bits.hpp:25
  logic or_1467;
  assign or_1467 = (or_1395 & or_1399) | (and_1391 & (or_1395 | or_1399));
  logic or_1471;
  assign or_1471 = (or_1410 & or_1414) | (or_1406 & (or_1410 | or_1414));
  logic or_1475;
  assign or_1475 = (or_1425 & or_1429) | (or_1421 & (or_1425 | or_1429));
  // hls/stages/count_bits.hpp:24
  logic parity_1478;
  assign parity_1478 = ^{or_1475, or_1471, or_1467};
  logic parity_1481;
  assign parity_1481 = ^{or_1475, or_1471, or_1467, or_1460, or_1456, or_1452, or_1445, or_1441, and_1437};
  // hls/stages/count_bits.hpp:25
  logic or_1485;
  assign or_1485 = (parity_1463 & parity_1478) | ((^{or_1445, or_1441, and_1437}) & (parity_1463 | parity_1478));
  logic or_1489;
  assign or_1489 = (or_1441 & or_1445) | (and_1437 & (or_1441 | or_1445));
  logic or_1493;
  assign or_1493 = (or_1456 & or_1460) | (or_1452 & (or_1456 | or_1460));
  logic or_1497;
  assign or_1497 = (or_1471 & or_1475) | (or_1467 & (or_1471 | or_1475));
  // hls/stages/count_bits.hpp:24
  logic parity_1502;
  assign parity_1502 = ^{or_1497, or_1493, or_1489, or_1485};
  // hls/stages/count_bits.hpp:25
  logic or_1506;
  assign or_1506 = (or_1493 & or_1497) | (or_1489 & (or_1493 | or_1497));
  logic and_1507;
  assign and_1507 = or_1485 & (^{or_1497, or_1493, or_1489});
  // hls/stages/count_bits.hpp:24
  logic xor_1508;
  assign xor_1508 = or_1506 ^ and_1507;
  // hls/stages/count_bits.hpp:27
  logic and_1509;
  assign and_1509 = or_1506 & and_1507;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1510;
  assign select_1510 = equal_595_s1_q ? {and_1509, xor_1508, parity_1502, parity_1481, xor_1436, xor_1341} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_581_s1_q ? 6'h0 : select_1510;
  // hls/stages/agreement.hpp:795
  logic and_1578;
  assign and_1578 = ends_cell_s1_q & inside_v;
  logic and_1580;
  assign and_1580 = not_577 & (so_s1_q & and_1578);
  logic [5:0] select_1584;
  assign select_1584 = so_s1_q ? x_s1_q[5:0] : (or_581_s1_q ? (less_584_s1_q ? 6'h0 : select_629) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1588;
  assign or_1588 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1597;
  assign and_1597 = or_581_s1_q & (slot_s1_q[2] & not_585_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1710;
  assign select_1710 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1710[16:7])) ? 8'h7f : select_1710[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1787_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1787_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_1874;
  assign less_1874 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_1875;
  assign or_1875 = equal_1786_s1_q | less_1874;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1880;
  assign select_1880 = equal_1786_s1_q ? patches_column_s1_q[0] : (or_1875 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1881;
  assign not_1881 = ~or_1875;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_1882;
  assign sum_1882 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_1885;
  assign select_1885 = or_1875 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1882) + 5'h1) : sum_1882;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1886;
  assign select_1886 = equal_1786_s1_q ? 5'h0 : select_1885;
  logic or_1887;
  assign or_1887 = equal_1786_s1_q | equal_1784_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_1889;
  assign equal_1889 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1891;
  assign equal_1891 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1893;
  assign and_1893 = of_row & (~equal_1891);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1889 ? 2'h3 : {equal_1891, and_1893};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1896;
  assign sum_1896 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1897;
  assign sum_1897 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1896, pixel_2[0]} - {1'b0, sum_1897, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1899;
  assign sum_1899 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1900;
  assign sum_1900 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1899[11], sum_1899};
  logic [13:0] sum_1901;
  assign sum_1901 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1900, down_2[1]};
  logic [12:0] sum_1902;
  assign sum_1902 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1901[13:1];
  logic [14:0] sum_1903;
  assign sum_1903 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1902, sum_1901[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_1910;
  assign or_1910 = (sum_1903[8] & (~(sum_1903[7:0] == 8'h0))) | (~(sum_1903[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1915;
  assign sum_1915 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1916;
  assign sum_1916 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1915};
  logic [10:0] sum_1917;
  assign sum_1917 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1916, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1918;
  assign sum_1918 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1917[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1918, sum_1917[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1920;
  assign sum_1920 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1921;
  assign sum_1921 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1922;
  assign difference_1922 = {1'b0, sum_1920, smooth[0]} - {1'b0, sum_1921, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_1929;
  assign or_1929 = (difference_1922[8] & (~(difference_1922[7:0] == 8'h0))) | (~(difference_1922[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_1937;
  assign or_1937 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1891) | equal_1889;
  // hls/stages/patches.hpp:481
  logic and_1942;
  assign and_1942 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:275
  logic and_1946;
  assign and_1946 = not_1785_s1_q & (or_1788_s1_q & (or_1937 & (equal_1787_s1_q & and_1942)));
  // hls/stages/patches.hpp:174
  logic and_1956;
  assign and_1956 = (~(equal_1787_s1_q | (~and_1942))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:275
  logic and_1960;
  assign and_1960 = not_1785_s1_q & (or_1788_s1_q & (and_1956 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_1962;
  assign less_1962 = patches_step_q[4:0] < 5'h11;
  logic equal_1963;
  assign equal_1963 = patches_step_q[6:5] == 2'h2;
  logic equal_1964;
  assign equal_1964 = patches_step_q[6:5] == 2'h1;
  logic or_1965;
  assign or_1965 = equal_1963 | equal_1964;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1995;
  assign sum_1995 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1282
  logic not_2051;
  assign not_2051 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:464
  logic select_2572;
  assign select_2572 = equal_2475_s1_q ? (~({row_s1_q, 1'b0} < {sum_2569, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:471
  logic and_2575;
  assign and_2575 = proven_q & less_2574;
  // hls/stages/agreement.hpp:527
  logic select_2579;
  assign select_2579 = and_551_s1_q ? (equal_2475_s1_q ? (and_2575 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:472
  logic equal_2580;
  assign equal_2580 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:473
  logic and_2581;
  assign and_2581 = and_2575 & equal_2580;
  // hls/stages/agreement.hpp:527
  logic select_2583;
  assign select_2583 = and_551_s1_q ? (equal_2475_s1_q ? and_2581 : draws_late_q) : draws_late_q;
  logic and_2843;
  assign and_2843 = and_551_s1_q & (equal_2475_s1_q & equal_2580);
  // hls/stages/registration.hpp:128
  logic and_2844;
  assign and_2844 = and_2476_s1_q & and_2843;
  // hls/stages/registration.hpp:127
  logic and_2846;
  assign and_2846 = and_2476_s1_q & (~and_2843);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2847;
  assign select_2847 = and_2846 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2849;
  assign select_2849 = and_2844 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2847[15]}}, select_2847});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2850;
  assign select_2850 = and_2846 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2850[15]}}, select_2850};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2852;
  assign select_2852 = and_2844 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2853;
  assign and_2853 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2853 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3097;
  assign select_3097 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:275
  logic [11:0] select_3100;
  assign select_3100 = equal_1784_s1_q ? patches_smooth_values_0_q : (or_1788_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3102;
  assign select_3102 = or_1788_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3104;
  assign select_3104 = equal_1782_s1_q ? patches_smooth_values_1_q : (equal_1784_s1_q ? patches_smooth_values_1_q : select_3102);
  logic [11:0] select_3105;
  assign select_3105 = or_1788_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3107;
  assign select_3107 = equal_1782_s1_q ? patches_smooth_values_2_q : (equal_1784_s1_q ? patches_smooth_values_2_q : select_3105);
  logic [11:0] select_3108;
  assign select_3108 = or_1788_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3110;
  assign select_3110 = equal_1782_s1_q ? patches_smooth_values_3_q : (equal_1784_s1_q ? patches_smooth_values_3_q : select_3108);
  logic [10:0] select_3112;
  assign select_3112 = equal_1784_s1_q ? patches_down_values_0_q : (or_1788_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3115;
  assign select_3115 = equal_1784_s1_q ? patches_down_values_1_q : (or_1788_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3118;
  assign select_3118 = equal_1784_s1_q ? patches_down_values_2_q : (or_1788_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3121;
  assign select_3121 = equal_1784_s1_q ? patches_down_values_3_q : (or_1788_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3158;
  assign and_3158 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3163;
  assign select_3163 = or_3058_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3165;
  assign select_3165 = and_3158 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3521;
  assign select_3521 = equal_1782_s1_q ? patches_summed_down_by_q : (equal_1784_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3539;
  assign select_3539 = equal_1782_s1_q ? (less_1962 & (equal_1964 & or_1965)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3842;
  assign select_3842 = so_s1_q ? (and_2853 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3844;
  assign sum_3844 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3845;
  assign select_3845 = sum_1995[5] ? {1'b1, sum_1995[4:0], region_across_rest_q[2:0]} : sum_3844;
  // hls/stages/agreement.hpp:464
  logic [7:0] select_3847;
  assign select_3847 = equal_2475_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3850;
  assign select_3850 = equal_2475_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1155
  logic equal_3901;
  assign equal_3901 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:278
  logic and_4068;
  assign and_4068 = (~drew_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:1283
  logic select_4071;
  assign select_4071 = sample_pair_first_q ? done_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4073;
  assign select_4073 = sample_pair_first_q ? done_q : (sample_pair_whole_q ? select_4071 : proven_q);

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_516_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_525;
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
  assign census_memory_re = s1_en & and_551_s1_q;
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
  assign moments_memory_raddr = select_575;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_593;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1386; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_581_s1_q ? select_629 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_620_s1_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1387; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_1580;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_1597;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_629;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1597;
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
  assign patches_right_codes_raddr = {select_1886, not_1881, select_1880};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1887;
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
  assign patches_left_codes_re = s1_en & (not_1783_s1_q & (new_row & equal_1784_s1_q));
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
  assign patches_rows_re = s1_en & (equal_1782_s1_q & (less_1962 & or_1965));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1415; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign seen_columns_re = s1_en & and_1580;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_655_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_757, left_rdata_q[65:49], and_756, left_rdata_q[47:31], and_755, left_rdata_q[29:13], and_754, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_655_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_763, right_codes_rdata_q[84:73], and_762, right_codes_rdata_q[71:60], and_761, right_codes_rdata_q[56:43], and_760, right_codes_rdata_q[41:28], and_759, right_codes_rdata_q[26:13], and_758, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1868_s1_q;
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
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s1_en) begin
      moments_place_q <= select_574;
      moments_taken_q <= not_577 & (not_579 & (equal_580_s1_q & inside_v));
      moments_starts_q <= not_577 & (not_579 & (equal_580_s1_q & (inside_v & first)));
      row_q <= and_551_s1_q ? (equal_2475_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_551_s1_q ? select_2572 : lower_half_q;
      late_q <= select_2579;
      draws_late_q <= select_2583;
      registration_slope_row_q <= select_2849;
      registration_slope_change_q <= select_2852;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3082_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3082_s1_q & select_3097;
      patches_smooth_values_0_q <= equal_1782_s1_q ? patches_smooth_values_0_q : select_3100;
      patches_smooth_values_1_q <= select_3104;
      patches_smooth_values_2_q <= select_3107;
      patches_smooth_values_3_q <= select_3110;
      patches_down_values_0_q <= equal_1782_s1_q ? patches_down_values_0_q : select_3112;
      patches_down_values_1_q <= equal_1782_s1_q ? patches_down_values_1_q : select_3115;
      patches_down_values_2_q <= equal_1782_s1_q ? patches_down_values_2_q : select_3118;
      patches_down_values_3_q <= equal_1782_s1_q ? patches_down_values_3_q : select_3121;
      patches_down_by_q <= or_3058_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3158});
      patches_along_q <= select_3163;
      patches_match_row_q <= or_3058_s1_q ? 4'h0 : select_3165;
      patches_summed_last_q <= not_1783_s1_q & (equal_1784_s1_q & and_3158);
      patches_summed_down_by_q <= select_3521;
      patches_step_q <= or_3058_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3539;
      region_across_rest_q <= select_3842;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3845;
      columns_begin_rest_q <= and_551_s1_q ? select_3847 : columns_begin_rest_q;
      columns_begin_back_q <= and_551_s1_q ? select_3850 : columns_begin_back_q;
      done_q <= sample_pair_whole_q ? (not_2051 & and_4068) : and_4068;
      proven_q <= sample_pair_whole_q ? select_4073 : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_576_s1_q & equal_3901;
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
  logic done_s2_q;
  logic [2:0] select_512_s2_q;
  logic row_starts_s2_q;
  logic [7:0] select_516_s2_q;
  logic and_524_s2_q;
  logic and_525_s2_q;
  logic equal_530_s2_q;
  logic [5:0] select_545_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_549_s2_q;
  logic and_551_s2_q;
  logic equal_571_s2_q;
  logic [10:0] select_575_s2_q;
  logic equal_576_s2_q;
  logic not_577_s2_q;
  logic not_579_s2_q;
  logic equal_580_s2_q;
  logic or_581_s2_q;
  logic less_584_s2_q;
  logic not_585_s2_q;
  logic inside_v_s2_q;
  logic not_589_s2_q;
  logic and_593_s2_q;
  logic and_602_s2_q;
  logic and_611_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic not_640_s2_q;
  logic and_644_s2_q;
  logic and_649_s2_q;
  logic and_651_s2_q;
  logic equal_684_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1263_s2_q;
  logic [5:0] select_1512_s2_q;
  logic and_1567_s2_q;
  logic equal_1568_s2_q;
  logic and_1578_s2_q;
  logic and_1580_s2_q;
  logic [5:0] select_1584_s2_q;
  logic or_1588_s2_q;
  logic and_1691_s2_q;
  logic less_1705_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1782_s2_q;
  logic equal_1784_s2_q;
  logic equal_1787_s2_q;
  logic or_1788_s2_q;
  logic not_1789_s2_q;
  logic [4:0] select_1812_s2_q;
  logic select_1818_s2_q;
  logic [3:0] select_1858_s2_q;
  logic less_1874_s2_q;
  logic new_row_s2_q;
  logic or_1887_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1904_s2_q;
  logic or_1910_s2_q;
  logic and_1914_s2_q;
  logic and_1930_s2_q;
  logic and_1933_s2_q;
  logic and_1947_s2_q;
  logic and_1956_s2_q;
  logic and_1961_s2_q;
  logic less_1962_s2_q;
  logic equal_1963_s2_q;
  logic or_1965_s2_q;
  logic and_1974_s2_q;
  logic select_1976_s2_q;
  logic and_1979_s2_q;
  logic sum_1995_s2_q;
  logic and_2016_s2_q;
  logic not_2051_s2_q;
  logic and_2137_s2_q;
  logic equal_2286_s2_q;
  logic equal_2475_s2_q;
  logic and_2612_s2_q;
  logic equal_2697_s2_q;
  logic less_3134_s2_q;
  logic equal_3477_s2_q;
  logic equal_3574_s2_q;
  logic less_3830_s2_q;
  logic equal_3901_s2_q;
  logic or_4051_s2_q;
  logic and_4125_s2_q;
  logic not_4143_s2_q;
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
      done_s2_q <= done_q;
      select_512_s2_q <= select_512_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_516_s2_q <= select_516_s1_q;
      and_524_s2_q <= and_524_s1_q;
      and_525_s2_q <= and_525;
      equal_530_s2_q <= equal_530_s1_q;
      select_545_s2_q <= select_545_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_549_s2_q <= and_549_s1_q;
      and_551_s2_q <= and_551_s1_q;
      equal_571_s2_q <= equal_571;
      select_575_s2_q <= select_575;
      equal_576_s2_q <= equal_576_s1_q;
      not_577_s2_q <= not_577;
      not_579_s2_q <= not_579;
      equal_580_s2_q <= equal_580_s1_q;
      or_581_s2_q <= or_581_s1_q;
      less_584_s2_q <= less_584_s1_q;
      not_585_s2_q <= not_585_s1_q;
      inside_v_s2_q <= inside_v;
      not_589_s2_q <= not_589;
      and_593_s2_q <= and_593;
      and_602_s2_q <= or_581_s1_q & (left_rdata_q[70] & not_585_s1_q);
      and_611_s2_q <= (or_581_s1_q & (left_rdata_q[68] & not_585_s1_q)) & and_610;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      not_640_s2_q <= ~late_q;
      and_644_s2_q <= or_581_s1_q & (left_rdata_q[71] & not_585_s1_q);
      and_649_s2_q <= or_581_s1_q & (right_codes_rdata_q[58] & not_585_s1_q);
      and_651_s2_q <= or_581_s1_q & (right_codes_rdata_q[59] & not_585_s1_q);
      equal_684_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1263_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1512_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1567_s2_q <= and_1567_s1_q;
      equal_1568_s2_q <= equal_1568_s1_q;
      and_1578_s2_q <= and_1578;
      and_1580_s2_q <= and_1580;
      select_1584_s2_q <= select_1584;
      or_1588_s2_q <= or_1588;
      and_1691_s2_q <= and_1691_s1_q;
      less_1705_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1782_s2_q <= equal_1782_s1_q;
      equal_1784_s2_q <= equal_1784_s1_q;
      equal_1787_s2_q <= equal_1787_s1_q;
      or_1788_s2_q <= or_1788_s1_q;
      not_1789_s2_q <= not_1789_s1_q;
      select_1812_s2_q <= select_1812_s1_q;
      select_1818_s2_q <= select_1818_s1_q;
      select_1858_s2_q <= select_1858_s1_q;
      less_1874_s2_q <= less_1874;
      new_row_s2_q <= new_row;
      or_1887_s2_q <= or_1887;
      of_row_2_s2_q <= of_row_2;
      not_1904_s2_q <= ~sum_1903[14];
      or_1910_s2_q <= or_1910;
      and_1914_s2_q <= sum_1903[14] & (~(sum_1903[13:8] == 6'h3f));
      and_1930_s2_q <= (~difference_1922[14]) & or_1929;
      and_1933_s2_q <= difference_1922[14] & (~(difference_1922[13:8] == 6'h3f));
      and_1947_s2_q <= not_1783_s1_q & and_1946;
      and_1956_s2_q <= and_1956;
      and_1961_s2_q <= not_1783_s1_q & and_1960;
      less_1962_s2_q <= less_1962;
      equal_1963_s2_q <= equal_1963;
      or_1965_s2_q <= or_1965;
      and_1974_s2_q <= sample_pair_whole_q;
      select_1976_s2_q <= left_first_q;
      and_1979_s2_q <= right_q;
      sum_1995_s2_q <= sum_1995[5];
      and_2016_s2_q <= or_581_s1_q & (left_rdata_q[69] & not_585_s1_q);
      not_2051_s2_q <= not_2051;
      and_2137_s2_q <= (draws_late_q | (6'h6 < row_q)) & (~(x_s1_q[7:2] == 6'h0));
      equal_2286_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2475_s2_q <= equal_2475_s1_q;
      and_2612_s2_q <= or_581_s1_q & (not_585_s1_q & and_610);
      equal_2697_s2_q <= shift == 6'h0;
      less_3134_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3477_s2_q <= patches_match_row_q == 4'h0;
      equal_3574_s2_q <= patches_step_q[6:5] == 2'h3;
      less_3830_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3901_s2_q <= equal_3901;
      or_4051_s2_q <= and_2581 | (~(row_s1_q[5:3] == 3'h0));
      and_4125_s2_q <= less_2574 & select_4071;
      not_4143_s2_q <= ~proven_q;
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
  logic [11:0] select_528;
  assign select_528 = select_512_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_532;
  assign sum_532 = select_528 + (equal_530_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_534;
  assign sum_534 = {4'h0, sample_pair_pixel_1_q} + (select_512_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_536;
  assign sum_536 = sum_534 + (equal_530_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:422
  logic whole;
  assign whole = select_512_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_540;
  assign and_540 = whole & (averager_memory_rdata_q[24] | equal_530_s2_q);
  // hls/stages/agreement.hpp:422
  logic all_of_skin;
  assign all_of_skin = select_512_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_544;
  assign and_544 = all_of_skin & (averager_memory_rdata_q[25] | equal_530_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_524_s2_q ? sum_532[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_554;
  assign equal_554 = select_512_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_554 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_557;
  assign select_557 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_524_s2_q ? sum_536[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_554 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_561;
  assign select_561 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_562;
  assign and_562 = and_524_s2_q & and_540;
  // hls/stages/census.hpp:134
  logic select_564;
  assign select_564 = equal_554 ? and_562 : (averager_mask_q & and_562);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_564;
  // hls/stages/census.hpp:218
  logic and_566;
  assign and_566 = and_524_s2_q & and_544;
  // hls/stages/census.hpp:134
  logic select_568;
  assign select_568 = equal_554 ? and_566 : (averager_of_skin_q & and_566);
  // hls/stages/agreement.hpp:276
  logic and_569;
  assign and_569 = sample_pair_whole_s2_q & select_568;
  // hls/stages/agreement.hpp:985
  logic select_624;
  assign select_624 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:986
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:999
  logic [8:0] difference_634;
  assign difference_634 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1000
  logic [9:0] sum_635;
  assign sum_635 = {difference_634[8], difference_634} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_637;
  assign and_637 = (and_611_s2_q & select_624) & ({{22{sum_635[9]}}, sum_635} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_639;
  assign and_639 = or_581_s2_q & (not_585_s2_q & and_637);
  // hls/stages/moments.hpp:77
  logic and_642;
  assign and_642 = and_602_s2_q & (and_639 & not_640_s2_q);
  // hls/stages/census.hpp:308
  logic less_657;
  assign less_657 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_666;
  assign less_666 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_667;
  assign less_667 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_669;
  assign less_669 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_678;
  assign less_678 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_679;
  assign less_679 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:459
  logic equal_681;
  assign equal_681 = last_s2_2_q == 6'h0;
  logic [3:0] select_685;
  assign select_685 = equal_684_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:460
  logic [4:0] select_686;
  assign select_686 = equal_681 ? {select_685, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_687;
  assign select_687 = equal_681 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_688;
  assign and_688 = select_686[4] & select_687[3];
  // hls/stages/census.hpp:300
  logic and_690;
  assign and_690 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_692;
  assign and_692 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_690);
  // hls/stages/agreement.hpp:460
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_692;
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
  logic [9:0] difference_715;
  assign difference_715 = {1'b0, select_557} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_716;
  assign xor_716 = difference_715[8:0] ^ {9{difference_715[9]}};
  logic [9:0] sum_717;
  assign sum_717 = {9'h0, difference_715[9]} + {1'b0, xor_716};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_719;
  assign xor_719 = difference_718[8:0] ^ {9{difference_718[9]}};
  logic [9:0] sum_720;
  assign sum_720 = {9'h0, difference_718[9]} + {1'b0, xor_719};
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_723;
  assign xor_723 = difference_722[8:0] ^ {9{difference_722[9]}};
  logic [9:0] sum_724;
  assign sum_724 = {9'h0, difference_722[9]} + {1'b0, xor_723};
  logic [10:0] sum_725;
  assign sum_725 = ({1'b0, sum_717} + {1'b0, sum_720}) + {1'b0, sum_724};
  logic [9:0] difference_726;
  assign difference_726 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_727;
  assign xor_727 = difference_726[8:0] ^ {9{difference_726[9]}};
  logic [9:0] sum_728;
  assign sum_728 = {9'h0, difference_726[9]} + {1'b0, xor_727};
  logic [9:0] difference_730;
  assign difference_730 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_731;
  assign xor_731 = difference_730[8:0] ^ {9{difference_730[9]}};
  // hls/stages/agreement.hpp:460
  logic and_739;
  assign and_739 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_740;
  assign and_740 = and_688 & and_739;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_742;
  assign sum_742 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_744;
  assign and_744 = and_740 & ({{5{sum_742[6]}}, sum_742, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_748;
  assign sum_748 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:814
  logic or_765;
  assign or_765 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:815
  logic select_767;
  assign select_767 = or_765 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:785
  logic [5:0] select_1014;
  assign select_1014 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1015;
  assign difference_1015 = {1'b0, column_s2_q} - {1'b0, select_1014};
  logic [7:0] sum_1017;
  assign sum_1017 = {difference_1015[6], difference_1015} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:762
  logic [7:0] select_1018;
  assign select_1018 = slot_s2_q[0] ? chosen_score_q : sum_1017;
  // hls/stages/agreement.hpp:785
  logic [6:0] difference_1264;
  assign difference_1264 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1263_s2_q};
  // hls/stages/agreement.hpp:756
  logic equal_1265;
  assign equal_1265 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:785
  logic [7:0] sum_1267;
  assign sum_1267 = {difference_1264[6], difference_1264} + (equal_1265 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1513;
  assign difference_1513 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1512_s2_q};
  logic [7:0] sum_1515;
  assign sum_1515 = {difference_1513[6], difference_1513} + (equal_1265 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:758
  logic less_1516;
  assign less_1516 = sum_1267 < sum_1515;
  logic [7:0] select_1517;
  assign select_1517 = less_1516 ? sum_1515 : sum_1267;
  logic less_1518;
  assign less_1518 = select_1018 < select_1517;
  // hls/stages/agreement.hpp:808
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1518 ? select_1517 : select_1018) : 8'h0;
  // hls/stages/agreement.hpp:815
  logic or_1522;
  assign or_1522 = select_767 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:820
  logic [5:0] select_1523;
  assign select_1523 = or_1522 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:727
  logic not_1524;
  assign not_1524 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:759
  logic [1:0] select_1525;
  assign select_1525 = less_1516 ? {slot_s2_q[0], not_1524} : 2'h0;
  logic [2:0] select_1527;
  assign select_1527 = less_1518 ? {select_1525, not_1524} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:820
  logic [2:0] select_1528;
  assign select_1528 = or_1522 ? select_1527 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1529;
  assign select_1529 = or_1522 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:817
  logic equal_1530;
  assign equal_1530 = select_1527 == 3'h1;
  logic or_1533;
  assign or_1533 = equal_1530 | (~(select_1527 == 3'h2));
  logic [7:0] select_1535;
  assign select_1535 = or_1533 ? before_0_q : before_1_q;
  logic [7:0] select_1536;
  assign select_1536 = equal_1530 ? (or_1533 ? sum_1267 : {7'h0, shift_not_right_q}) : select_1535;
  // hls/stages/agreement.hpp:820
  logic [7:0] select_1537;
  assign select_1537 = or_1522 ? select_1536 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1540;
  assign select_1540 = or_1522 ? (equal_1530 ? select_1535 : (or_1533 ? sum_1515 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_1542;
  assign sum_1542 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1543;
  assign sum_1543 = {1'b0, before_v} + sum_1542;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_1544;
  assign select_1544 = slot_s2_q[0] ? chosen_near_q : sum_1543;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_1546;
  assign sum_1546 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1547;
  assign sum_1547 = {1'b0, before_v_2} + sum_1546;
  // hls/stages/agreement.hpp:786
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:787
  logic [6:0] sum_1549;
  assign sum_1549 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1550;
  assign sum_1550 = {1'b0, before_v_3} + sum_1549;
  // hls/stages/agreement.hpp:758
  logic [6:0] select_1552;
  assign select_1552 = (sum_1547 < sum_1550) ? sum_1550 : sum_1547;
  // hls/stages/agreement.hpp:809
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1544 < select_1552) ? select_1552 : select_1544) : 7'h0;
  // hls/stages/agreement.hpp:820
  logic less_1556;
  assign less_1556 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:824
  logic [6:0] select_1558;
  assign select_1558 = select_767 ? of_near : (less_1556 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1560;
  assign select_1560 = select_767 ? run_shift_s2_q : (less_1556 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1563;
  assign select_1563 = (run_shift_s2_q == 6'h3f) ? of_best : (select_767 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:825
  logic [7:0] select_1566;
  assign select_1566 = (run_shift_s2_q == 6'h1) ? of_best : (select_767 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:830
  logic select_1569;
  assign select_1569 = or_765 ? shift_first_s2_q : equal_1568_s2_q;
  // hls/stages/agreement.hpp:831
  logic or_1571;
  assign or_1571 = select_1569 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:835
  logic [7:0] select_1572;
  assign select_1572 = or_1571 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1573;
  assign select_1573 = or_1571 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1575;
  assign or_1575 = select_1569 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:839
  logic [6:0] select_1576;
  assign select_1576 = or_1575 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1577;
  assign select_1577 = or_1575 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1591;
  assign and_1591 = or_581_s2_q & (not_585_s2_q & (and_637 & or_1588_s2_q));
  // hls/stages/agreement.hpp:795
  logic and_1592;
  assign and_1592 = not_579_s2_q & and_1591;
  logic and_1595;
  assign and_1595 = not_577_s2_q & (drew_q ? and_1578_s2_q : (equal_580_s2_q & and_639));
  // hls/stages/moments.hpp:73
  logic and_1599;
  assign and_1599 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1010
  logic and_1600;
  assign and_1600 = not_589_s2_q & and_1599;
  logic and_1603;
  assign and_1603 = not_589_s2_q & (and_1599 & (moments_memory_rdata_q[1] ^ and_644_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1608;
  assign and_1608 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1010
  logic and_1609;
  assign and_1609 = not_589_s2_q & and_1608;
  logic and_1612;
  assign and_1612 = not_589_s2_q & (and_1608 & (moments_memory_rdata_q[3] ^ and_651_s2_q));
  // hls/stages/agreement.hpp:1136
  logic equal_1613;
  assign equal_1613 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1186
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1137
  logic [1:0] select_1616;
  assign select_1616 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1150
  logic [3:0] select_1618;
  assign select_1618 = equal_1613 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1616});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1619;
  assign sum_1619 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:795
  logic [3:0] select_1620;
  assign select_1620 = equal_576_s2_q ? select_1618 : {sum_1619, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1621;
  assign equal_1621 = x_s2_q[5:0] == 6'h3f;
  logic equal_1623;
  assign equal_1623 = x_s2_q[5:0] == 6'h3e;
  logic equal_1625;
  assign equal_1625 = x_s2_q[5:0] == 6'h3d;
  logic equal_1627;
  assign equal_1627 = x_s2_q[5:0] == 6'h3c;
  logic equal_1629;
  assign equal_1629 = x_s2_q[5:0] == 6'h3b;
  logic equal_1631;
  assign equal_1631 = x_s2_q[5:0] == 6'h36;
  logic equal_1633;
  assign equal_1633 = x_s2_q[5:0] == 6'h35;
  logic equal_1635;
  assign equal_1635 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1186
  logic and_1639;
  assign and_1639 = (~equal_1629) & ((~equal_1631) & ((~equal_1633) & (~equal_1635)));
  logic and_1643;
  assign and_1643 = (~equal_1621) & ((~equal_1623) & ((~equal_1625) & ((~equal_1627) & and_1639)));
  // hls/stages/agreement.hpp:1137
  logic less_1644;
  assign less_1644 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1648;
  assign or_1648 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1016
  logic [4:0] sum_1653;
  assign sum_1653 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1653, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1659;
  assign sum_1659 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1661;
  assign and_1661 = half_ends & ({{3{sum_1659[4]}}, sum_1659} < 8'h3);
  // hls/stages/agreement.hpp:795
  logic and_1662;
  assign and_1662 = drew_q & and_1661;
  logic select_1663;
  assign select_1663 = equal_576_s2_q ? (x_s2_q[6] & (equal_1613 ? and_1643 : (less_1644 & (~or_1648)))) : and_1662;
  // hls/stages/registration.hpp:258
  logic not_1665;
  assign not_1665 = ~lower_half_s2_q;
  logic [3:0] select_1666;
  assign select_1666 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1665, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1665};
  // hls/stages/patches.hpp:377
  logic [1:0] select_1692;
  assign select_1692 = and_1691_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1693;
  assign select_1693 = and_1691_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1694;
  assign select_1694 = row_starts_s2_q ? {select_1693, select_1692[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1695;
  assign select_1695 = row_starts_s2_q ? select_1692 : patches_fetch_q;
  logic equal_1696;
  assign equal_1696 = select_1695 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:795
  logic and_1704;
  assign and_1704 = not_577_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1706;
  assign equal_1706 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_581_s2_q ? (less_584_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1706 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1714;
  assign select_1714 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1715;
  assign select_1715 = b[1] ? a : 8'h0;
  logic [8:0] sum_1716;
  assign sum_1716 = {{2{select_1714[6]}}, select_1714} + {select_1715[7], select_1715};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1717;
  assign select_1717 = b[2] ? a : 8'h0;
  logic [7:0] select_1718;
  assign select_1718 = b[3] ? a : 8'h0;
  logic [8:0] sum_1719;
  assign sum_1719 = {{2{select_1717[7]}}, select_1717[7:1]} + {select_1718[7], select_1718};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1720;
  assign sum_1720 = {{3{sum_1716[8]}}, sum_1716[8:1]} + {sum_1719[8], sum_1719, select_1717[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1721;
  assign select_1721 = b[4] ? a : 8'h0;
  logic [7:0] select_1722;
  assign select_1722 = b[5] ? a : 8'h0;
  logic [8:0] difference_1723;
  assign difference_1723 = {{2{select_1721[7]}}, select_1721[7:1]} - {select_1722[7], select_1722};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1724;
  assign sum_1724 = {difference_1723, select_1721[0]} + {sum_1720[10], sum_1720[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1706 ? {sum_1724, sum_1720[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1726;
  assign sum_1726 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1729;
  assign and_1729 = less_1705_s2_q & (and_639 & ({{4{sum_1726[9]}}, sum_1726, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1733;
  assign and_1733 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1739;
  assign sum_1739 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1741;
  assign sum_1741 = {sum_1739[9], sum_1739[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1025
  logic and_1744;
  assign and_1744 = ($signed(9'h0) < $signed(sum_1739[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1741, sum_1739[0]})));
  logic and_1745;
  assign and_1745 = (~(and_1733 | (equal_571_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1744;
  // hls/stages/agreement.hpp:795
  logic and_1749;
  assign and_1749 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1729 & and_1745)));
  logic and_1750;
  assign and_1750 = not_577_s2_q & and_1749;
  // hls/stages/patches.hpp:157
  logic and_1752;
  assign and_1752 = and_1750 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1753;
  assign select_1753 = and_1752 ? and_1750 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_1756;
  assign select_1756 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1758;
  assign select_1758 = and_1752 ? (equal_576_s2_q ? 8'h0 : select_1756) : patches_choice_column_q;
  // hls/stages/agreement.hpp:795
  logic [5:0] select_1761;
  assign select_1761 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_1763;
  assign select_1763 = and_1752 ? (equal_576_s2_q ? 6'h0 : select_1761) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1764;
  assign sum_1764 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1724[9]}}, sum_1724[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1767;
  assign select_1767 = ($signed(sum_1764[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1764[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1706 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1764[12:7])) ? 8'h7f : select_1767);
  // hls/stages/agreement.hpp:795
  logic [7:0] select_1772;
  assign select_1772 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1774;
  assign select_1774 = and_1752 ? (equal_576_s2_q ? 8'h0 : select_1772) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1775;
  assign equal_1775 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:795
  logic and_1779;
  assign and_1779 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1733 | equal_1775)));
  logic and_1780;
  assign and_1780 = not_577_s2_q & and_1779;
  // hls/stages/patches.hpp:348
  logic and_1781;
  assign and_1781 = patches_chooses_s2_q & and_1780;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1795;
  assign select_1795 = row_starts_s2_q ? select_1693 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1796;
  assign equal_1796 = {patches_choosing_band_s2_q, and_1704} == {select_1795, select_1695[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1895;
  assign sum_1895 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1911;
  assign and_1911 = not_1904_s2_q & or_1910_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1951;
  assign sum_1951 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1982;
  assign select_1982 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1057
  logic or_1985;
  assign or_1985 = select_1982[7] | (~({select_1982[5], select_1982[3], select_1982[1]} == 3'h0));
  // hls/stages/agreement.hpp:1056
  logic or_1988;
  assign or_1988 = select_1982[7] | (~({select_1982[6], select_1982[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1055
  logic or_1991;
  assign or_1991 = select_1982[7] | (~(select_1982[6:4] == 3'h0));
  // hls/stages/agreement.hpp:795
  logic [5:0] select_1992;
  assign select_1992 = equal_576_s2_q ? x_s2_q[5:0] : {region_row_q, or_1991, or_1988, or_1985};
  // hls/stages/agreement.hpp:1136
  logic not_1993;
  assign not_1993 = ~equal_1613;
  // hls/stages/agreement.hpp:1065
  logic or_1997;
  assign or_1997 = (~sum_1995_s2_q) | equal_1775;
  // hls/stages/agreement.hpp:795
  logic and_2000;
  assign and_2000 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_1997));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_581_s2_q & (not_585_s2_q & and_611_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_639;
  // hls/stages/agreement.hpp:149
  logic and_2018;
  assign and_2018 = or_581_s2_q & (not_585_s2_q & and_2016_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2027;
  assign and_2027 = inside_v_s2_q & and_2018;
  // hls/stages/agreement.hpp:1021
  logic select_2028;
  assign select_2028 = slot_s2_q[2] ? shown_shown_q : and_639;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2028);
  // hls/stages/agreement.hpp:1021
  logic select_2031;
  assign select_2031 = slot_s2_q[2] ? shown_nearer_q : and_1591;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2028 ? select_2031 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1279
  logic select_2034;
  assign select_2034 = done_s2_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1283
  logic select_2035;
  assign select_2035 = left_first_s2_q ? select_2034 : read_half_q;
  logic or_2036;
  assign or_2036 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1284
  logic [8:0] select_2037;
  assign select_2037 = or_2036 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1285
  logic [9:0] select_2039;
  assign select_2039 = left_first_s2_q ? 10'h1 : (or_2036 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1288
  logic and_2040;
  assign and_2040 = select_2037[8] & select_2039[9];
  // hls/stages/agreement.hpp:440
  logic next_row;
  assign next_row = and_2040 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1299
  logic [5:0] select_2043;
  assign select_2043 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2045;
  assign select_2045 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2043});
  // hls/stages/agreement.hpp:1310
  logic equal_2046;
  assign equal_2046 = seen_x_q == 3'h7;
  logic [7:0] select_2048;
  assign select_2048 = and_2040 ? 8'h0 : (seen_column_q + {7'h0, equal_2046});
  // hls/stages/agreement.hpp:1317
  logic [10:0] index;
  assign index = select_2045 + {3'h0, select_2048};
  // hls/stages/agreement.hpp:1269
  logic [11:0] sum_2050;
  assign sum_2050 = {1'b0, {2{select_2035}}, 2'h0, {2{select_2035}}, 1'b0, {2{select_2035}}, 1'b0, select_2035} + {1'b0, index};
  // hls/stages/agreement.hpp:440
  logic and_2053;
  assign and_2053 = not_2051_s2_q & (began_q | and_2040);
  // hls/stages/agreement.hpp:1311
  logic [2:0] select_2055;
  assign select_2055 = and_2040 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1316
  logic and_2057;
  assign and_2057 = and_2053 & (select_2055 == 3'h0);
  logic less_2058;
  assign less_2058 = select_2048 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:442
  logic and_2059;
  assign and_2059 = and_2057 & less_2058;
  logic and_2060;
  assign and_2060 = and_1974_s2_q & and_2059;
  // hls/stages/agreement.hpp:278
  logic select_2062;
  assign select_2062 = and_1974_s2_q ? (left_first_s2_q ? and_2059 : and_2060) : and_2060;
  // hls/stages/agreement.hpp:1119
  logic select_2064;
  assign select_2064 = draws_late_s2_q ? read_half_q : write_half_q;
  logic [7:0] sum_2065;
  assign sum_2065 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2065[7], sum_2065, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1269
  logic [11:0] sum_2067;
  assign sum_2067 = {1'b0, {2{select_2064}}, 2'h0, {2{select_2064}}, 1'b0, {2{select_2064}}, 1'b0, select_2064} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1037
  logic and_2068;
  assign and_2068 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2069;
  assign and_2069 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2070;
  assign and_2070 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2071;
  assign and_2071 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1094
  logic [1:0] sum_2073;
  assign sum_2073 = {1'b0, and_2070} + ({1'b0, textured} + {1'b0, and_2071});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2068} + ({2'h0, and_2069} + {1'b0, sum_2073});
  // hls/stages/agreement.hpp:1037
  logic [7:0] select_2082;
  assign select_2082 = inside_v_s2_q ? (sum_1995_s2_q ? select_1982 : {select_1982[6:0], 1'b0}) : select_1982;
  // hls/stages/agreement.hpp:1057
  logic or_2085;
  assign or_2085 = select_2082[7] | (~({select_2082[5], select_2082[3], select_2082[1]} == 3'h0));
  // hls/stages/agreement.hpp:1037
  logic and_2103;
  assign and_2103 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2104;
  assign and_2104 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2105;
  assign and_2105 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2106;
  assign and_2106 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1096
  logic [1:0] sum_2108;
  assign sum_2108 = {1'b0, and_2105} + ({1'b0, shown} + {1'b0, and_2106});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2103} + ({2'h0, and_2104} + {1'b0, sum_2108});
  // hls/stages/agreement.hpp:1037
  logic and_2119;
  assign and_2119 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2120;
  assign and_2120 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2121;
  assign and_2121 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2122;
  assign and_2122 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1097
  logic [1:0] sum_2124;
  assign sum_2124 = {1'b0, and_2121} + ({1'b0, near} + {1'b0, and_2122});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2119} + ({2'h0, and_2120} + {1'b0, sum_2124});
  // hls/stages/agreement.hpp:795
  logic and_2141;
  assign and_2141 = ends_cell_s2_q & (and_2137_s2_q & (~({1'b0, sum_1653, last_s2_q[1:0]} < x_s2_q)));
  logic and_2143;
  assign and_2143 = not_577_s2_q & (drew_q & and_2141);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2177;
  assign select_2177 = sample_pair_whole_s2_q ? (and_549_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2179;
  assign select_2179 = sample_pair_whole_s2_q ? (and_549_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2199;
  assign select_2199 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2201;
  assign select_2201 = sample_pair_whole_s2_q ? (and_549_s2_q ? select_564 : averager_mask_q) : averager_mask_q;
  logic select_2203;
  assign select_2203 = sample_pair_whole_s2_q ? (and_549_s2_q ? select_568 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:527
  logic [8:0] select_2204;
  assign select_2204 = and_551_s2_q ? select_557 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_551_s2_q ? select_561 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2207;
  assign select_2207 = and_551_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2208;
  assign select_2208 = and_551_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2209;
  assign select_2209 = and_551_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2210;
  assign select_2210 = and_551_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2211;
  assign select_2211 = and_551_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2212;
  assign select_2212 = and_551_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2213;
  assign select_2213 = and_551_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2214;
  assign select_2214 = and_551_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_551_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2216;
  assign select_2216 = and_551_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_551_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_551_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2219;
  assign select_2219 = and_551_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2220;
  assign select_2220 = and_551_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_551_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2222;
  assign select_2222 = and_551_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2223;
  assign select_2223 = and_551_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_551_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2225;
  assign select_2225 = and_551_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2226;
  assign select_2226 = and_551_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2227;
  assign select_2227 = and_551_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2228;
  assign select_2228 = and_551_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2229;
  assign select_2229 = and_551_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2230;
  assign select_2230 = and_551_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_551_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2232;
  assign select_2232 = and_551_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2233;
  assign select_2233 = and_551_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_551_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2235;
  assign select_2235 = and_551_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2236;
  assign select_2236 = and_551_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_551_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2238;
  assign select_2238 = and_551_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2239;
  assign select_2239 = and_551_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_551_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2241;
  assign select_2241 = and_551_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2242;
  assign select_2242 = and_551_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_551_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2244;
  assign select_2244 = and_551_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2245;
  assign select_2245 = and_551_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2246;
  assign select_2246 = and_551_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2247;
  assign select_2247 = and_551_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2248;
  assign select_2248 = and_551_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2249;
  assign select_2249 = and_551_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2250;
  assign select_2250 = and_551_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2251;
  assign select_2251 = and_551_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2252;
  assign select_2252 = and_551_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2253;
  assign select_2253 = and_551_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2254;
  assign select_2254 = and_551_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2255;
  assign select_2255 = and_551_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2256;
  assign select_2256 = and_551_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2257;
  assign select_2257 = and_551_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2258;
  assign select_2258 = and_551_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2259;
  assign select_2259 = and_551_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2261;
  assign difference_2261 = {1'b0, select_561} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2262;
  assign xor_2262 = difference_2261[8:0] ^ {9{difference_2261[9]}};
  logic [9:0] sum_2263;
  assign sum_2263 = {9'h0, difference_2261[9]} + {1'b0, xor_2262};
  logic [9:0] difference_2264;
  assign difference_2264 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2265;
  assign xor_2265 = difference_2264[8:0] ^ {9{difference_2264[9]}};
  logic [9:0] sum_2266;
  assign sum_2266 = {9'h0, difference_2264[9]} + {1'b0, xor_2265};
  logic [9:0] difference_2268;
  assign difference_2268 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2269;
  assign xor_2269 = difference_2268[8:0] ^ {9{difference_2268[9]}};
  logic [9:0] sum_2270;
  assign sum_2270 = {9'h0, difference_2268[9]} + {1'b0, xor_2269};
  logic [10:0] sum_2271;
  assign sum_2271 = ({1'b0, sum_2263} + {1'b0, sum_2266}) + {1'b0, sum_2270};
  logic [9:0] difference_2272;
  assign difference_2272 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2273;
  assign xor_2273 = difference_2272[8:0] ^ {9{difference_2272[9]}};
  logic [9:0] sum_2274;
  assign sum_2274 = {9'h0, difference_2272[9]} + {1'b0, xor_2273};
  logic [9:0] difference_2276;
  assign difference_2276 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2277;
  assign xor_2277 = difference_2276[8:0] ^ {9{difference_2276[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2298;
  assign sum_2298 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2300;
  assign sum_2300 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1150
  logic equal_2301;
  assign equal_2301 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2302;
  assign select_2302 = equal_2301 ? sum_2298 : moments_before_0_q;
  logic [13:0] select_2304;
  assign select_2304 = equal_2301 ? sum_2300 : moments_before_1_q;
  // hls/stages/agreement.hpp:795
  logic select_2307;
  assign select_2307 = equal_576_s2_q ? (moments_has_before_q | equal_2301) : moments_has_before_q;
  logic [13:0] select_2310;
  assign select_2310 = equal_576_s2_q ? ((select_2304 < select_2302) ? select_2302 : select_2304) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2311;
  assign sum_2311 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2314;
  assign select_2314 = equal_576_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2311)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2315;
  assign sum_2315 = {1'b0, sum_2300} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2318;
  assign select_2318 = equal_576_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2315)) : moments_left_alone_q;
  logic select_2321;
  assign select_2321 = equal_576_s2_q ? (~({3'h0, select_2304[13:2]} < sum_2315)) : moments_left_other_stops_q;
  logic select_2324;
  assign select_2324 = equal_576_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2311)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2325;
  assign sum_2325 = {1'b0, sum_2298} + 15'h3;
  // hls/stages/agreement.hpp:795
  logic select_2328;
  assign select_2328 = equal_576_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2325)) : moments_right_alone_q;
  logic select_2331;
  assign select_2331 = equal_576_s2_q ? (~({3'h0, select_2302[13:2]} < sum_2325)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2334;
  assign or_2334 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:795
  logic and_2342;
  assign and_2342 = not_577_s2_q & (not_579_s2_q & (equal_580_s2_q & (inside_v_s2_q & and_1603)));
  logic and_2346;
  assign and_2346 = not_577_s2_q & (not_579_s2_q & (equal_580_s2_q & (inside_v_s2_q & and_1612)));
  // hls/stages/moments.hpp:94
  logic and_2348;
  assign and_2348 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2351;
  assign select_2351 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2348)) : and_2348;
  // hls/stages/agreement.hpp:795
  logic and_2355;
  assign and_2355 = equal_576_s2_q & (equal_2301 & (cfg_prove_i & (cfg_same_table_i & select_2351)));
  // hls/stages/moments.hpp:95
  logic and_2358;
  assign and_2358 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2372;
  assign difference_2372 = {1'b0, select_557} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2372[9]} + (difference_2372[8:0] ^ {9{difference_2372[9]}});
  logic [9:0] difference_2384;
  assign difference_2384 = {1'b0, select_561} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2384[9]} + (difference_2384[8:0] ^ {9{difference_2384[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2585;
  assign select_2585 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2586;
  assign select_2586 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2587;
  assign select_2587 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2588;
  assign select_2588 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2589;
  assign select_2589 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2590;
  assign select_2590 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2594;
  assign select_2594 = slot_s2_q[0] ? 8'h0 : sum_1017;
  // hls/stages/agreement.hpp:758
  logic less_2595;
  assign less_2595 = select_2594 < select_1517;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2597;
  assign select_2597 = slot_s2_q[0] ? 7'h0 : sum_1543;
  // hls/stages/agreement.hpp:795
  logic not_2602;
  assign not_2602 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2603;
  assign less_2603 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:527
  logic and_2610;
  assign and_2610 = and_551_s2_q & (equal_684_s2_q & equal_2475_s2_q);
  // hls/stages/agreement.hpp:795
  logic and_2616;
  assign and_2616 = not_577_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & and_2612_s2_q)));
  // hls/stages/agreement.hpp:1037
  logic and_2636;
  assign and_2636 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2637;
  assign and_2637 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2638;
  assign and_2638 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2639;
  assign and_2639 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1095
  logic [1:0] sum_2641;
  assign sum_2641 = {1'b0, and_2638} + ({1'b0, explained} + {1'b0, and_2639});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2636} + ({2'h0, and_2637} + {1'b0, sum_2641});
  // hls/stages/agreement.hpp:795
  logic and_2677;
  assign and_2677 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2612_s2_q & and_2018)));
  // hls/stages/agreement.hpp:993
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:994
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:995
  logic [7:0] difference_2701;
  assign difference_2701 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2704;
  assign less_2704 = {2'h0, difference_2701[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2707;
  assign and_2707 = not_585_s2_q & (((and_2016_s2_q & and_637) & equal_2697_s2_q) & (~less_2704));
  // hls/stages/agreement.hpp:795
  logic and_2711;
  assign and_2711 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (or_581_s2_q & and_2707)));
  // hls/stages/agreement.hpp:149
  logic and_2716;
  assign and_2716 = not_585_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2718;
  assign and_2718 = not_585_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2719;
  assign select_2719 = or_581_s2_q ? {and_2718, and_2716} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2721;
  assign select_2721 = less_584_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2722;
  assign select_2722 = or_581_s2_q ? select_2721 : 2'h0;
  // hls/stages/agreement.hpp:1034
  logic and_2725;
  assign and_2725 = and_639 & (not_640_s2_q & (select_2719[0] & select_2722[0]));
  // hls/stages/agreement.hpp:795
  logic and_2729;
  assign and_2729 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2719[1] & and_2725)));
  logic and_2730;
  assign and_2730 = not_577_s2_q & and_2729;
  logic and_2736;
  assign and_2736 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2722[1] & and_2725)));
  logic and_2737;
  assign and_2737 = not_577_s2_q & and_2736;
  // hls/stages/registration.hpp:76
  logic less_2740;
  assign less_2740 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2742;
  assign select_2742 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2744;
  assign select_2744 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2746;
  assign select_2746 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2744} - {1'b0, select_2746};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2748;
  assign select_2748 = rise_2[8] ? select_2744 : select_2746;
  logic [8:0] fall;
  assign fall = {1'b0, select_2742} - {1'b0, select_2748};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2751;
  assign not_2751 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2740 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2751};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2753;
  assign xor_2753 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2753};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2759;
  assign select_2759 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2740 ? {taken, 1'b1} : {not_2751, select_2759, not_2751};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2761;
  assign sum_2761 = {left, 1'b1} + {taken_2, less_2740};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2763;
  assign select_2763 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_2765;
  assign select_2765 = equal_576_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_2767;
  assign select_2767 = equal_576_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2768;
  assign equal_2768 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2772;
  assign and_2772 = and_639 & less_1705_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2774;
  assign select_2774 = or_581_s2_q ? (less_584_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2778;
  assign sum_2778 = select_2774[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2781;
  assign select_2781 = (select_2744 < select_2746) ? ({sum_2778, select_2774[0], 5'h0} - {3'h0, select_2763}) : {sum_2778, select_2774[0], select_2763};
  logic [7:0] select_2782;
  assign select_2782 = ((select_2774 == 3'h0) | (select_2774 == 3'h4)) ? {sum_2778, select_2774[0], 5'h0} : select_2781;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2782[7]}}, select_2782} - {sum_1724[9], sum_1724, sum_1720[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2785;
  assign select_2785 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2785[11:7])) ? 12'h7f : select_2785;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2806;
  assign difference_2806 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2808;
  assign and_2808 = and_2772 & ($signed(difference_2806) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2821;
  assign less_2821 = $signed(difference_2806) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:795
  logic select_2829;
  assign select_2829 = drew_q ? (equal_2768 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2832;
  assign select_2832 = drew_q ? (equal_1706 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2837;
  assign select_2837 = (sum_1619 == 2'h2) ? (registration_fresh_q & (~select_1666)) : registration_fresh_q;
  // hls/stages/agreement.hpp:795
  logic [3:0] select_2839;
  assign select_2839 = drew_q ? (and_1661 ? select_2837 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2841;
  assign select_2841 = and_2610 ? 4'hf : (equal_576_s2_q ? registration_fresh_q : select_2839);
  // hls/stages/agreement.hpp:1137
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1616;
  // hls/stages/registration.hpp:258
  logic not_2861;
  assign not_2861 = ~quarter_2[1];
  logic [3:0] select_2862;
  assign select_2862 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2861, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2861};
  // hls/stages/patches.hpp:91
  logic parity_2996;
  assign parity_2996 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:464
  logic [15:0] select_2997;
  assign select_2997 = equal_2475_s2_q ? {patches_chance_q[14:0], parity_2996} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_2999;
  assign not_2999 = ~and_1780;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_3001;
  assign select_3001 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_3001};
  // hls/stages/agreement.hpp:795
  logic and_3007;
  assign and_3007 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3011;
  assign and_3011 = not_2999 & (patches_fixed_q | ((not_577_s2_q & and_3007) & and_1752));
  // hls/stages/patches.hpp:358
  logic not_3023;
  assign not_3023 = ~select_1695[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3025;
  assign select_3025 = sample_pair_whole_s2_q ? (equal_1696 ? select_1695 : {not_3023, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:275
  logic [51:0] select_3124;
  assign select_3124 = or_1788_s2_q ? {and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3126;
  assign select_3126 = equal_1782_s2_q ? patches_codes_at_q : (equal_1784_s2_q ? other[55:4] : select_3124);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1887_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3129;
  assign select_3129 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:275
  logic [27:0] select_3131;
  assign select_3131 = equal_1784_s2_q ? (new_row_s2_q ? word : select_3129) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3133;
  assign select_3133 = less_1874_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3135;
  assign select_3135 = less_3134_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:275
  logic [55:0] select_3137;
  assign select_3137 = or_1788_s2_q ? (equal_1787_s2_q ? patches_next_codes_q : select_3135) : patches_next_codes_q;
  logic [55:0] select_3139;
  assign select_3139 = equal_1782_s2_q ? patches_next_codes_q : (equal_1784_s2_q ? select_3133 : select_3137);
  // hls/stages/count_bits.hpp:24
  logic parity_3144;
  assign parity_3144 = ^{and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911};
  // hls/stages/count_bits.hpp:25
  logic or_3148;
  assign or_3148 = ({and_1914_s2_q, and_1911} == 2'h3) | (and_1930_s2_q & (and_1914_s2_q | and_1911));
  logic and_3149;
  assign and_3149 = and_1933_s2_q & (^{and_1930_s2_q, and_1914_s2_q, and_1911});
  // hls/stages/count_bits.hpp:24
  logic xor_3150;
  assign xor_3150 = or_3148 ^ and_3149;
  // hls/stages/count_bits.hpp:27
  logic and_3151;
  assign and_3151 = or_3148 & and_3149;
  // hls/stages/agreement.hpp:275
  logic [2:0] select_3153;
  assign select_3153 = or_1788_s2_q ? (and_1956_s2_q ? {and_3151, xor_3150, parity_3144} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3157;
  assign sum_3157 = {7'h0, patches_set_q} + (equal_1787_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3167;
  assign select_3167 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:275
  logic [47:0] select_3169;
  assign select_3169 = equal_1782_s2_q ? patches_left_row_q : (equal_1784_s2_q ? select_3167 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3167;
  // hls/stages/count_bits.hpp:24
  logic xor_3173;
  assign xor_3173 = bits[17] ^ (^{select_3167[16:15], other[16:15]});
  logic xor_3176;
  assign xor_3176 = bits[11] ^ (^{select_3167[10:9], other[10:9]});
  logic xor_3179;
  assign xor_3179 = bits[14] ^ (^{select_3167[13:12], other[13:12]});
  logic xor_3182;
  assign xor_3182 = xor_3173 ^ (^{select_3167[14:9], other[14:9]});
  logic xor_3185;
  assign xor_3185 = bits[47] ^ (^{select_3167[46:45], other[46:45]});
  logic xor_3188;
  assign xor_3188 = bits[8] ^ (^{select_3167[7:6], other[7:6]});
  logic xor_3191;
  assign xor_3191 = bits[2] ^ (^{select_3167[1:0], other[1:0]});
  logic xor_3194;
  assign xor_3194 = bits[5] ^ (^{select_3167[4:3], other[4:3]});
  logic xor_3197;
  assign xor_3197 = xor_3188 ^ (^{select_3167[5:0], other[5:0]});
  logic parity_3199;
  assign parity_3199 = ^{select_3167[47:45], select_3167[8:0], other[47:45], other[8:0]};
  logic xor_3200;
  assign xor_3200 = xor_3182 ^ parity_3199;
  logic xor_3203;
  assign xor_3203 = bits[44] ^ (^{select_3167[43:42], other[43:42]});
  logic xor_3206;
  assign xor_3206 = bits[38] ^ (^{select_3167[37:36], other[37:36]});
  logic xor_3209;
  assign xor_3209 = bits[41] ^ (^{select_3167[40:39], other[40:39]});
  logic xor_3215;
  assign xor_3215 = bits[26] ^ (^{select_3167[25:24], other[25:24]});
  logic xor_3218;
  assign xor_3218 = bits[20] ^ (^{select_3167[19:18], other[19:18]});
  logic xor_3221;
  assign xor_3221 = bits[23] ^ (^{select_3167[22:21], other[22:21]});
  logic xor_3224;
  assign xor_3224 = xor_3215 ^ (^{select_3167[23:18], other[23:18]});
  logic xor_3227;
  assign xor_3227 = bits[35] ^ (^{select_3167[34:33], other[34:33]});
  logic xor_3230;
  assign xor_3230 = bits[29] ^ (^{select_3167[28:27], other[28:27]});
  logic xor_3233;
  assign xor_3233 = bits[32] ^ (^{select_3167[31:30], other[31:30]});
  logic xor_3236;
  assign xor_3236 = xor_3227 ^ (^{select_3167[32:27], other[32:27]});
  logic xor_3237;
  assign xor_3237 = xor_3224 ^ xor_3236;
  // hls/stages/count_bits.hpp:25
  logic or_3245;
  assign or_3245 = (xor_3176 & xor_3179) | (xor_3173 & (xor_3176 | xor_3179));
  logic or_3249;
  assign or_3249 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3253;
  assign or_3253 = (xor_3191 & xor_3194) | (xor_3188 & (xor_3191 | xor_3194));
  // hls/stages/count_bits.hpp:23
  logic or_3260;
  assign or_3260 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3264;
  assign or_3264 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3268;
  assign or_3268 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3271;
  assign parity_3271 = ^{or_3268, or_3264, or_3260};
  // hls/stages/count_bits.hpp:23
  logic or_3275;
  assign or_3275 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3279;
  assign or_3279 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3283;
  assign or_3283 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3286;
  assign parity_3286 = ^{or_3283, or_3279, or_3275};
  logic parity_3289;
  assign parity_3289 = ^{or_3283, or_3279, or_3275, or_3268, or_3264, or_3260, or_3253, or_3249, or_3245};
  // hls/stages/count_bits.hpp:23
  logic or_3293;
  assign or_3293 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3297;
  assign or_3297 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3301;
  assign or_3301 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3309;
  assign or_3309 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3313;
  assign or_3313 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3317;
  assign or_3317 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3320;
  assign parity_3320 = ^{or_3317, or_3313, or_3309};
  // hls/stages/count_bits.hpp:23
  logic or_3324;
  assign or_3324 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3328;
  assign or_3328 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3332;
  assign or_3332 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3335;
  assign parity_3335 = ^{or_3332, or_3328, or_3324};
  logic parity_3338;
  assign parity_3338 = ^{or_3332, or_3328, or_3324, or_3317, or_3313, or_3309, or_3301, or_3297, or_3293};
  // hls/stages/count_bits.hpp:25
  logic or_3342;
  assign or_3342 = (xor_3206 & xor_3209) | (xor_3203 & (xor_3206 | xor_3209));
  logic or_3346;
  assign or_3346 = (xor_3218 & xor_3221) | (xor_3215 & (xor_3218 | xor_3221));
  logic or_3350;
  assign or_3350 = (xor_3230 & xor_3233) | (xor_3227 & (xor_3230 | xor_3233));
  // hls/stages/count_bits.hpp:24
  logic parity_3353;
  assign parity_3353 = ^{or_3350, or_3346, or_3342};
  // hls/stages/count_bits.hpp:25
  logic and_3354;
  assign and_3354 = xor_3200 & (^{xor_3237, select_3167[44:36], other[44:36]});
  logic or_3358;
  assign or_3358 = (xor_3185 & xor_3197) | (xor_3182 & (xor_3185 | xor_3197));
  logic and_3361;
  assign and_3361 = (xor_3203 ^ (^{select_3167[41:36], other[41:36]})) & (xor_3224 | xor_3236);
  logic or_3362;
  assign or_3362 = (xor_3224 & xor_3236) | and_3361;
  // hls/stages/count_bits.hpp:24
  logic parity_3365;
  assign parity_3365 = ^{or_3362, or_3358, and_3354};
  logic parity_3368;
  assign parity_3368 = ^{or_3362, or_3358, and_3354, or_3350, or_3346, or_3342, or_3332, or_3328, or_3324, or_3317, or_3313, or_3309, or_3301, or_3297, or_3293};
  logic parity_3370;
  assign parity_3370 = ^{or_3362, or_3358, and_3354, or_3350, or_3346, or_3342, or_3332, or_3328, or_3324, or_3317, or_3313, or_3309, or_3301, or_3297, or_3293, or_3283, or_3279, or_3275, or_3268, or_3264, or_3260, or_3253, or_3249, or_3245};
  // hls/stages/count_bits.hpp:25
  logic and_3371;
  assign and_3371 = parity_3289 & parity_3368;
  logic or_3375;
  assign or_3375 = (parity_3271 & parity_3286) | ((^{or_3253, or_3249, or_3245}) & (parity_3271 | parity_3286));
  logic or_3379;
  assign or_3379 = (parity_3353 & parity_3365) | (parity_3338 & (parity_3353 | parity_3365));
  logic or_3386;
  assign or_3386 = (parity_3320 & parity_3335) | ((^{or_3301, or_3297, or_3293}) & (parity_3320 | parity_3335));
  logic or_3390;
  assign or_3390 = (or_3346 & or_3350) | (or_3342 & (or_3346 | or_3350));
  logic or_3394;
  assign or_3394 = (or_3358 & or_3362) | (and_3354 & (or_3358 | or_3362));
  // hls/stages/count_bits.hpp:23
  logic or_3401;
  assign or_3401 = (or_3297 & or_3301) | (or_3293 & (or_3297 | or_3301));
  // hls/stages/count_bits.hpp:25
  logic or_3405;
  assign or_3405 = (or_3313 & or_3317) | (or_3309 & (or_3313 | or_3317));
  logic or_3409;
  assign or_3409 = (or_3328 & or_3332) | (or_3324 & (or_3328 | or_3332));
  // hls/stages/count_bits.hpp:24
  logic parity_3412;
  assign parity_3412 = ^{or_3409, or_3405, or_3401};
  // hls/stages/count_bits.hpp:23
  logic or_3416;
  assign or_3416 = (or_3249 & or_3253) | (or_3245 & (or_3249 | or_3253));
  // hls/stages/count_bits.hpp:25
  logic or_3420;
  assign or_3420 = (or_3264 & or_3268) | (or_3260 & (or_3264 | or_3268));
  logic or_3424;
  assign or_3424 = (or_3279 & or_3283) | (or_3275 & (or_3279 | or_3283));
  // hls/stages/count_bits.hpp:24
  logic parity_3427;
  assign parity_3427 = ^{or_3424, or_3420, or_3416};
  logic parity_3430;
  assign parity_3430 = ^{or_3424, or_3420, or_3416, or_3409, or_3405, or_3401, or_3394, or_3390, or_3386};
  logic parity_3432;
  assign parity_3432 = ^{or_3424, or_3420, or_3416, or_3409, or_3405, or_3401, or_3394, or_3390, or_3386, or_3379, or_3375, and_3371};
  // hls/stages/count_bits.hpp:25
  logic or_3436;
  assign or_3436 = (or_3390 & or_3394) | (or_3386 & (or_3390 | or_3394));
  logic or_3440;
  assign or_3440 = (or_3405 & or_3409) | (or_3401 & (or_3405 | or_3409));
  logic or_3444;
  assign or_3444 = (or_3420 & or_3424) | (or_3416 & (or_3420 | or_3424));
  // hls/stages/count_bits.hpp:24
  logic parity_3447;
  assign parity_3447 = ^{or_3444, or_3440, or_3436};
  // hls/stages/count_bits.hpp:25
  logic and_3448;
  assign and_3448 = (^{or_3379, or_3375, and_3371}) & parity_3430;
  logic or_3452;
  assign or_3452 = (or_3375 & or_3379) | (and_3371 & (or_3375 | or_3379));
  logic or_3456;
  assign or_3456 = (parity_3412 & parity_3427) | ((^{or_3394, or_3390, or_3386}) & (parity_3412 | parity_3427));
  // hls/stages/count_bits.hpp:24
  logic parity_3459;
  assign parity_3459 = ^{or_3456, or_3452, and_3448};
  // hls/stages/count_bits.hpp:25
  logic and_3461;
  assign and_3461 = parity_3447 & parity_3459;
  logic or_3465;
  assign or_3465 = (or_3440 & or_3444) | (or_3436 & (or_3440 | or_3444));
  logic or_3469;
  assign or_3469 = (or_3452 & or_3456) | (and_3448 & (or_3452 | or_3456));
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3514;
  assign select_3514 = equal_1784_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3517;
  assign select_3517 = equal_1782_s2_q ? patches_summed_first_q : (equal_1784_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3525;
  assign select_3525 = less_1962_s2_q ? (or_1965_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3528;
  assign select_3528 = less_1962_s2_q ? (or_1965_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3531;
  assign select_3531 = less_1962_s2_q ? (or_1965_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:275
  logic select_3536;
  assign select_3536 = equal_1782_s2_q ? (less_1962_s2_q & (or_1965_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3541;
  assign or_3541 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3542;
  assign and_3542 = patches_read_searches_s2_q & or_3541;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3543;
  assign select_3543 = and_3542 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3543};
  // hls/stages/patches.hpp:559
  logic and_3548;
  assign and_3548 = less_1962_s2_q & (or_1965_s2_q & (equal_1963_s2_q & (away == 6'h3f)));
  logic and_3553;
  assign and_3553 = less_1962_s2_q & (or_1965_s2_q & (equal_1963_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3555;
  assign sum_3555 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3558;
  assign select_3558 = (equal_1963_s2_q & ({sum_3555[6], sum_3555} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3560;
  assign select_3560 = less_1962_s2_q ? (or_1965_s2_q ? select_3558 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3562;
  assign select_3562 = and_3542 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3563;
  assign select_3563 = equal_1782_s2_q ? select_3562[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3564;
  assign select_3564 = equal_1782_s2_q ? select_3562[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3566;
  assign select_3566 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3567;
  assign select_3567 = equal_1782_s2_q ? select_3566 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3568;
  assign select_3568 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3569;
  assign select_3569 = equal_1782_s2_q ? select_3568 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3571;
  assign select_3571 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3573;
  assign select_3573 = equal_1782_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3571) : patches_peak_far_q;
  logic [9:0] select_3576;
  assign select_3576 = equal_1782_s2_q ? (equal_3574_s2_q ? sum_3157 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:795
  logic select_3827;
  assign select_3827 = equal_576_s2_q ? shown_shown_q : (drew_q ? select_2028 : shown_shown_q);
  logic select_3829;
  assign select_3829 = equal_576_s2_q ? shown_nearer_q : (drew_q ? select_2031 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3831;
  assign sum_3831 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:464
  logic [2:0] select_3833;
  assign select_3833 = less_3830_s2_q ? (sum_3831[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3835;
  assign select_3835 = equal_2475_s2_q ? (equal_684_s2_q ? 3'h0 : select_3833) : region_row_q;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_3840;
  assign select_3840 = equal_576_s2_q ? select_1982 : (drew_q ? (ends_cell_s2_q ? select_2082 : select_1982) : 8'h1);
  // hls/stages/agreement.hpp:464
  logic [8:0] select_3854;
  assign select_3854 = equal_684_s2_q ? {{2{difference_3852[6]}}, difference_3852} : (less_3830_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:527
  logic [8:0] select_3856;
  assign select_3856 = and_551_s2_q ? (equal_2475_s2_q ? select_3854 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] select_3858;
  assign select_3858 = equal_684_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:527
  logic [6:0] select_3860;
  assign select_3860 = and_551_s2_q ? (equal_2475_s2_q ? select_3858 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3861;
  assign sum_3861 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3862;
  assign select_3862 = sum_3831[7] ? {1'b1, sum_3831[6:0], region_down_rest_q[0]} : sum_3861;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3831[7];
  // hls/stages/agreement.hpp:464
  logic select_3866;
  assign select_3866 = equal_2475_s2_q ? (equal_684_s2_q | (less_3830_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3871;
  assign or_3871 = segment_starts_q | not_579_s2_q;
  // hls/stages/agreement.hpp:1037
  logic select_3874;
  assign select_3874 = inside_v_s2_q ? (sum_1995_s2_q ? (equal_1775 & or_1997) : or_1997) : or_3871;
  // hls/stages/agreement.hpp:795
  logic select_3877;
  assign select_3877 = equal_576_s2_q ? or_3871 : (drew_q ? (ends_cell_s2_q ? select_3874 : or_3871) : or_3871);
  logic select_4037;
  assign select_4037 = drew_q ? (ends_cell_s2_q ? and_2070 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4040;
  assign select_4040 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4042;
  assign select_4042 = equal_576_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4040 : centres_values_0_of_skin_q);
  logic select_4043;
  assign select_4043 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4045;
  assign select_4045 = equal_576_s2_q ? centres_values_1_textured_q : (drew_q ? select_4043 : centres_values_1_textured_q);
  logic select_4046;
  assign select_4046 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4048;
  assign select_4048 = equal_576_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4046 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:464
  logic [10:0] select_4054;
  assign select_4054 = equal_2475_s2_q ? (or_4051_s2_q ? (map_row_q + {5'h0, map_width_q}) : 11'h0) : map_row_q;
  // hls/stages/agreement.hpp:527
  logic [5:0] select_4057;
  assign select_4057 = and_551_s2_q ? (equal_2475_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1279
  logic xor_4058;
  assign xor_4058 = write_half_q ^ done_s2_q;
  // hls/stages/agreement.hpp:442
  logic select_4060;
  assign select_4060 = and_1974_s2_q ? (left_first_s2_q ? xor_4058 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4062;
  assign select_4062 = and_1974_s2_q ? (left_first_s2_q ? xor_4058 : select_4060) : write_half_q;
  logic select_4064;
  assign select_4064 = left_first_s2_q ? select_2034 : (and_1974_s2_q ? select_2035 : read_half_q);
  logic [9:0] select_4077;
  assign select_4077 = left_first_s2_q ? 10'h1 : (and_1974_s2_q ? select_2039 : rows_passed_q);
  logic [8:0] select_4080;
  assign select_4080 = left_first_s2_q ? {select_2037[7:0], or_2036} : (and_1974_s2_q ? {select_2037[7:0], or_2036} : columns_passed_q);
  logic select_4083;
  assign select_4083 = left_first_s2_q ? marks_last_s2_q : (and_1974_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4086;
  assign select_4086 = left_first_s2_q ? and_2053 : (and_1974_s2_q ? and_2053 : began_q);
  logic [2:0] select_4089;
  assign select_4089 = left_first_s2_q ? select_2055 : (and_1974_s2_q ? select_2055 : seen_x_q);
  // hls/stages/agreement.hpp:1309
  logic [2:0] select_4094;
  assign select_4094 = left_first_s2_q ? 3'h0 : (and_2040 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4096;
  assign select_4096 = left_first_s2_q ? 3'h0 : (and_1974_s2_q ? select_4094 : seen_y_q);
  logic [7:0] select_4099;
  assign select_4099 = left_first_s2_q ? select_2048 : (and_1974_s2_q ? select_2048 : seen_column_q);
  // hls/stages/agreement.hpp:440
  logic [7:0] select_4105;
  assign select_4105 = left_first_s2_q ? select_4103 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4107;
  assign select_4107 = left_first_s2_q ? select_4103 : (and_1974_s2_q ? select_4105 : seen_rows_left_q);
  // hls/stages/agreement.hpp:440
  logic and_4112;
  assign and_4112 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4114;
  assign select_4114 = left_first_s2_q ? and_4112 : (and_1974_s2_q ? and_4112 : at_cell_end_q);
  logic select_4117;
  assign select_4117 = left_first_s2_q ? next_row : (and_1974_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4120;
  assign select_4120 = left_first_s2_q ? 11'h0 : (and_1974_s2_q ? select_2045 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4193;
  assign not_4193 = ~quarter[1];
  logic [3:0] select_4194;
  assign select_4194 = quarter[0] ? {quarter[1], 1'b0, not_4193, 1'b0} : {1'b0, quarter[1], 1'b0, not_4193};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1620;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1663;
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
  assign patches_choices_raddr = select_1694;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1696));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1408; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1992;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_576_s2_q ? (x_s2_q[6] & not_1993) : and_2000);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1419; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2050;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2062;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_516_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_525_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_544, and_540, sum_536, sum_532};
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
  assign census_memory_we = s2_en & and_551_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_569, whole_2, select_561, select_557};
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
  assign moments_memory_waddr = select_575_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_593_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_651_s2_q, and_649_s2_q, and_644_s2_q, and_642};
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
  assign best_left_we = s2_en & and_1567_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1566, select_1563, select_1560, select_1558, select_1540, select_1537, select_1529, select_1528, select_1523};
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
  assign best_right_we = s2_en & and_1567_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1577, select_1576, select_1573, select_1572};
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
  assign shown_right_waddr = select_1584_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1595;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1592, not_579_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1603, and_1600};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1612, and_1609};
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
  assign patches_right_codes_waddr = {sum_1895, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1947_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1951, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1961_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1580_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2027, textured};
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
      averager_running_of_skin_q <= select_2199;
      averager_mask_q <= select_2201;
      averager_of_skin_q <= select_2203;
      census_filled_q <= and_551_s2_q ? {select_687[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2298;
      moments_turned_1_q <= sum_2300;
      moments_before_0_q <= equal_576_s2_q ? select_2302 : moments_before_0_q;
      moments_before_1_q <= equal_576_s2_q ? select_2304 : moments_before_1_q;
      moments_has_before_q <= select_2307;
      moments_most_before_q <= select_2310;
      moments_left_begins_q <= select_2314;
      moments_left_alone_q <= select_2318;
      moments_left_other_stops_q <= select_2321;
      moments_right_begins_q <= select_2324;
      moments_right_alone_q <= select_2328;
      moments_right_other_stops_q <= select_2331;
      moments_out_of_step_q <= or_2334;
      moments_turns_0_q <= and_2342;
      moments_turns_1_q <= and_2346;
      moments_begins_alone_q <= and_2355;
      moments_ends_q <= equal_576_s2_q & (equal_2301 & (not_2356 | and_2358));
      rows_passed_above_q <= and_551_s2_q ? select_686 : rows_passed_above_q;
      chosen_score_q <= less_2595 ? select_1517 : select_2594;
      chosen_near_q <= (select_2597 < select_1552) ? select_1552 : select_2597;
      chosen_place_q <= less_2595 ? {select_1525, not_1524} : 3'h2;
      before_0_q <= select_2594;
      before_1_q <= sum_1267;
      before_2_q <= sum_1515;
      shift_allowed_q <= not_2602 & (~less_2603);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2610 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2730});
      counts_turned_right_q <= and_2610 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2737});
      registration_displacement_over_q <= drew_q ? sum_2761[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2763;
      registration_slope_here_q <= select_2765;
      registration_expected_q <= select_2767;
      registration_of_right_q <= equal_576_s2_q ? registration_of_right_q : select_2829;
      registration_was_inside_q <= equal_576_s2_q ? registration_was_inside_q : select_2832;
      registration_fresh_q <= select_2841;
      patches_chance_q <= and_551_s2_q ? select_2997 : patches_chance_q;
      patches_fixed_q <= and_3011;
      patches_choice_valid_q <= and_1780 ? (select_1753 & not_2999) : select_1753;
      patches_choice_column_q <= select_1758;
      patches_choice_shift_q <= select_1763;
      patches_choice_slope_q <= select_1774;
      patches_band_q <= sample_pair_whole_s2_q ? select_1795 : patches_band_q;
      patches_fetch_q <= select_3025;
      patches_codes_at_q <= select_3126;
      patches_codes_further_q <= equal_1782_s2_q ? patches_codes_further_q : select_3131;
      patches_next_codes_q <= select_3139;
      patches_set_q <= equal_1782_s2_q ? 3'h0 : (equal_1784_s2_q ? 3'h0 : select_3153);
      patches_size_q <= sum_3157;
      patches_left_row_q <= select_3169;
      patches_summed_row_column_q <= equal_1782_s2_q ? patches_summed_row_column_q : select_3514;
      patches_summed_first_q <= select_3517;
      patches_read_row_differing_q <= equal_1782_s2_q ? select_3525 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1782_s2_q ? select_3528 : patches_read_row_column_q;
      patches_read_at_q <= equal_1782_s2_q ? select_3531 : patches_read_at_q;
      patches_read_first_q <= select_3536;
      patches_read_above_q <= equal_1782_s2_q ? and_3548 : patches_read_above_q;
      patches_read_below_q <= equal_1782_s2_q ? and_3553 : patches_read_below_q;
      patches_read_far_q <= equal_1782_s2_q ? select_3560 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3563;
      patches_peak_best_column_q <= select_3564;
      patches_peak_row_q <= equal_1782_s2_q ? select_3543 : patches_peak_row_q;
      patches_peak_above_q <= select_3567;
      patches_peak_below_q <= select_3569;
      patches_peak_far_q <= select_3573;
      patches_peak_size_q <= select_3576;
      patches_frame_ended_q <= equal_576_s2_q & equal_2301;
      shown_shown_q <= select_3827;
      shown_nearer_q <= select_3829;
      region_row_q <= and_551_s2_q ? select_3835 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3840;
      region_down_rest_q <= select_3856;
      region_down_back_q <= select_3860;
      region_down_next_q <= select_3862;
      region_fresh_q <= and_551_s2_q ? select_3866 : region_fresh_q;
      segment_starts_q <= select_3877;
      centres_values_0_textured_q <= equal_576_s2_q ? centres_values_0_textured_q : select_4037;
      centres_values_0_of_skin_q <= select_4042;
      centres_values_1_textured_q <= select_4045;
      centres_values_1_of_skin_q <= select_4048;
      map_row_q <= and_551_s2_q ? select_4054 : map_row_q;
      map_width_q <= select_4057;
      write_half_q <= select_4062;
      read_half_q <= and_1974_s2_q ? select_4064 : read_half_q;
      rows_passed_q <= and_1974_s2_q ? select_4077 : rows_passed_q;
      columns_passed_q <= and_1974_s2_q ? select_4080 : columns_passed_q;
      line_ended_q <= and_1974_s2_q ? select_4083 : line_ended_q;
      began_q <= and_1974_s2_q ? select_4086 : began_q;
      seen_x_q <= and_1974_s2_q ? select_4089 : seen_x_q;
      seen_y_q <= and_1974_s2_q ? select_4096 : seen_y_q;
      seen_column_q <= and_1974_s2_q ? select_4099 : seen_column_q;
      seen_rows_left_q <= and_1974_s2_q ? select_4107 : seen_rows_left_q;
      at_cell_end_q <= and_1974_s2_q ? select_4114 : at_cell_end_q;
      was_next_row_q <= and_1974_s2_q ? select_4117 : was_next_row_q;
      seen_base_q <= and_1974_s2_q ? select_4120 : seen_base_q;
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
      left_pixel_q <= and_1974_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_528 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_534 : averager_running_1_q;
      averager_total_0_q <= select_2177;
      averager_total_1_q <= select_2179;
      census_columns_values_0_cell_0_left_q <= select_2204;
      census_columns_values_0_cell_0_right_q <= select_2205;
      census_columns_values_0_cell_0_mask_q <= and_551_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2207;
      census_columns_values_0_cell_1_right_q <= select_2208;
      census_columns_values_0_cell_1_mask_q <= select_2209;
      census_columns_values_0_cell_2_left_q <= select_2210;
      census_columns_values_0_cell_2_right_q <= select_2211;
      census_columns_values_0_cell_2_mask_q <= select_2212;
      census_columns_values_0_cell_2_of_skin_q <= select_2213;
      census_columns_values_0_cell_3_left_q <= select_2214;
      census_columns_values_0_cell_3_right_q <= select_2215;
      census_columns_values_0_cell_3_mask_q <= select_2216;
      census_columns_values_0_cell_4_left_q <= select_2217;
      census_columns_values_0_cell_4_right_q <= select_2218;
      census_columns_values_0_cell_4_mask_q <= select_2219;
      census_columns_values_1_cell_0_left_q <= select_2220;
      census_columns_values_1_cell_0_right_q <= select_2221;
      census_columns_values_1_cell_0_mask_q <= select_2222;
      census_columns_values_1_cell_1_left_q <= select_2223;
      census_columns_values_1_cell_1_right_q <= select_2224;
      census_columns_values_1_cell_1_mask_q <= select_2225;
      census_columns_values_1_cell_2_left_q <= select_2226;
      census_columns_values_1_cell_2_right_q <= select_2227;
      census_columns_values_1_cell_2_mask_q <= select_2228;
      census_columns_values_1_cell_2_of_skin_q <= select_2229;
      census_columns_values_1_cell_3_left_q <= select_2230;
      census_columns_values_1_cell_3_right_q <= select_2231;
      census_columns_values_1_cell_3_mask_q <= select_2232;
      census_columns_values_1_cell_4_left_q <= select_2233;
      census_columns_values_1_cell_4_right_q <= select_2234;
      census_columns_values_1_cell_4_mask_q <= select_2235;
      census_columns_values_2_cell_0_left_q <= select_2236;
      census_columns_values_2_cell_0_right_q <= select_2237;
      census_columns_values_2_cell_0_mask_q <= select_2238;
      census_columns_values_2_cell_1_left_q <= select_2239;
      census_columns_values_2_cell_1_right_q <= select_2240;
      census_columns_values_2_cell_1_mask_q <= select_2241;
      census_columns_values_2_cell_2_left_q <= select_2242;
      census_columns_values_2_cell_2_right_q <= select_2243;
      census_columns_values_2_cell_2_mask_q <= select_2244;
      census_columns_values_2_cell_3_left_q <= select_2245;
      census_columns_values_2_cell_3_right_q <= select_2246;
      census_columns_values_2_cell_3_mask_q <= select_2247;
      census_columns_values_2_cell_4_left_q <= select_2248;
      census_columns_values_2_cell_4_right_q <= select_2249;
      census_columns_values_2_cell_4_mask_q <= select_2250;
      census_columns_values_3_cell_0_mask_q <= select_2251;
      census_columns_values_3_cell_1_left_q <= select_2252;
      census_columns_values_3_cell_1_right_q <= select_2253;
      census_columns_values_3_cell_1_mask_q <= select_2254;
      census_columns_values_3_cell_2_mask_q <= select_2255;
      census_columns_values_3_cell_3_left_q <= select_2256;
      census_columns_values_3_cell_3_right_q <= select_2257;
      census_columns_values_3_cell_3_mask_q <= select_2258;
      census_columns_values_3_cell_4_mask_q <= select_2259;
      sharpness_last_mean_0_q <= and_551_s2_q ? select_557 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_551_s2_q ? select_561 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2585;
      middle_sum_columns_values_2_q <= select_2586;
      middle_sum_columns_values_3_q <= select_2587;
      middle_sum_columns_values_4_q <= select_2588;
      middle_sum_columns_values_5_q <= select_2589;
      middle_sum_columns_values_6_q <= select_2590;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1017;
      sums_0_sum_sums_values_0_q <= sum_1267;
      sums_0_sum_sums_values_1_q <= equal_1265 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1515;
      sums_1_sum_sums_values_1_q <= equal_1265 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_512_s3_q;
  logic row_starts_s3_q;
  logic [5:0] select_545_s3_q;
  logic [5:0] last_s3_q;
  logic and_549_s3_q;
  logic and_551_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_554_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_571_s3_q;
  logic equal_576_s3_q;
  logic not_577_s3_q;
  logic so_s3_q;
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
  logic less_678_s3_q;
  logic less_679_s3_q;
  logic less_680_s3_q;
  logic and_688_s3_q;
  logic and_713_s3_q;
  logic and_714_s3_q;
  logic [11:0] sum_729_s3_q;
  logic [9:0] sum_732_s3_q;
  logic and_740_s3_q;
  logic and_744_s3_q;
  logic less_745_s3_q;
  logic less_749_s3_q;
  logic less_751_s3_q;
  logic equal_1613_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1619_s3_q;
  logic equal_1621_s3_q;
  logic equal_1623_s3_q;
  logic equal_1625_s3_q;
  logic equal_1627_s3_q;
  logic equal_1629_s3_q;
  logic equal_1631_s3_q;
  logic equal_1633_s3_q;
  logic equal_1635_s3_q;
  logic less_1644_s3_q;
  logic or_1648_s3_q;
  logic equal_1668_s3_q;
  logic and_1678_s3_q;
  logic select_1695_s3_q;
  logic equal_1696_s3_q;
  logic and_1704_s3_q;
  logic equal_1706_s3_q;
  logic select_1753_s3_q;
  logic and_1781_s3_q;
  logic equal_1782_s3_q;
  logic equal_1784_s3_q;
  logic not_1789_s3_q;
  logic and_1797_s3_q;
  logic [4:0] select_1812_s3_q;
  logic select_1818_s3_q;
  logic [3:0] select_1858_s3_q;
  logic and_1974_s3_q;
  logic select_1976_s3_q;
  logic and_1979_s3_q;
  logic or_1985_s3_q;
  logic or_1988_s3_q;
  logic or_1991_s3_q;
  logic not_1993_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2020_s3_q;
  logic and_2025_s3_q;
  logic and_2057_s3_q;
  logic less_2058_s3_q;
  logic [11:0] sum_2067_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2085_s3_q;
  logic or_2088_s3_q;
  logic or_2091_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2143_s3_q;
  logic [11:0] sum_2275_s3_q;
  logic [9:0] sum_2278_s3_q;
  logic equal_2286_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2610_s3_q;
  logic and_2616_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2678_s3_q;
  logic and_2712_s3_q;
  logic and_2771_s3_q;
  logic and_2772_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2808_s3_q;
  logic and_2822_s3_q;
  logic equal_2864_s3_q;
  logic parity_3241_s3_q;
  logic parity_3370_s3_q;
  logic parity_3432_s3_q;
  logic xor_3460_s3_q;
  logic parity_3472_s3_q;
  logic or_3476_s3_q;
  logic equal_3477_s3_q;
  logic and_3577_s3_q;
  logic less_3602_s3_q;
  logic equal_3901_s3_q;
  logic and_4075_s3_q;
  logic and_4123_s3_q;
  logic and_4125_s3_q;
  logic not_4143_s3_q;
  logic equal_4196_s3_q;
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
      select_512_s3_q <= select_512_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_545_s3_q <= select_545_s2_q;
      last_s3_q <= last_s2_2_q;
      and_549_s3_q <= and_549_s2_q;
      and_551_s3_q <= and_551_s2_q;
      grey_s3_q <= grey;
      equal_554_s3_q <= equal_554;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_571_s3_q <= equal_571_s2_q;
      equal_576_s3_q <= equal_576_s2_q;
      not_577_s3_q <= not_577_s2_q;
      so_s3_q <= drew_q;
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
      less_678_s3_q <= less_678;
      less_679_s3_q <= less_679;
      less_680_s3_q <= less_680;
      and_688_s3_q <= and_688;
      and_713_s3_q <= whole_22 & and_688;
      and_714_s3_q <= census_columns_values_1_cell_2_mask_q & and_688;
      sum_729_s3_q <= {1'b0, sum_725} + {2'h0, sum_728};
      sum_732_s3_q <= {9'h0, difference_730[9]} + {1'b0, xor_731};
      and_740_s3_q <= and_740;
      and_744_s3_q <= and_744;
      less_745_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_749_s3_q <= {{5{sum_748[6]}}, sum_748, half_grey_levels_2[3:0]} < 16'hffe1;
      less_751_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1613_s3_q <= equal_1613;
      all_s3_q <= all;
      sum_1619_s3_q <= sum_1619;
      equal_1621_s3_q <= equal_1621;
      equal_1623_s3_q <= equal_1623;
      equal_1625_s3_q <= equal_1625;
      equal_1627_s3_q <= equal_1627;
      equal_1629_s3_q <= equal_1629;
      equal_1631_s3_q <= equal_1631;
      equal_1633_s3_q <= equal_1633;
      equal_1635_s3_q <= equal_1635;
      less_1644_s3_q <= less_1644;
      or_1648_s3_q <= or_1648;
      equal_1668_s3_q <= (registration_fresh_q & select_1666) == 4'h0;
      and_1678_s3_q <= not_577_s2_q & and_1662;
      select_1695_s3_q <= select_1695[1];
      equal_1696_s3_q <= equal_1696;
      and_1704_s3_q <= and_1704;
      equal_1706_s3_q <= equal_1706;
      select_1753_s3_q <= select_1753;
      and_1781_s3_q <= and_1781;
      equal_1782_s3_q <= equal_1782_s2_q;
      equal_1784_s3_q <= equal_1784_s2_q;
      not_1789_s3_q <= not_1789_s2_q;
      and_1797_s3_q <= and_1781 & equal_1796;
      select_1812_s3_q <= select_1812_s2_q;
      select_1818_s3_q <= select_1818_s2_q;
      select_1858_s3_q <= select_1858_s2_q;
      and_1974_s3_q <= and_1974_s2_q;
      select_1976_s3_q <= select_1976_s2_q;
      and_1979_s3_q <= and_1979_s2_q;
      or_1985_s3_q <= or_1985;
      or_1988_s3_q <= or_1988;
      or_1991_s3_q <= or_1991;
      not_1993_s3_q <= not_1993;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2020_s3_q <= inside_v_s2_q & (and_2018 & and_1591);
      and_2025_s3_q <= not_577_s2_q & and_2000;
      and_2057_s3_q <= and_2057;
      less_2058_s3_q <= less_2058;
      sum_2067_s3_q <= sum_2067;
      textured_2_s3_q <= textured_2;
      or_2085_s3_q <= or_2085;
      or_2088_s3_q <= select_2082[7] | (~({select_2082[6], select_2082[3:2]} == 3'h0));
      or_2091_s3_q <= select_2082[7] | (~(select_2082[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2143_s3_q <= and_2143;
      sum_2275_s3_q <= {1'b0, sum_2271} + {2'h0, sum_2274};
      sum_2278_s3_q <= {9'h0, difference_2276[9]} + {1'b0, xor_2277};
      equal_2286_s3_q <= equal_2286_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2610_s3_q <= and_2610;
      and_2616_s3_q <= and_2616;
      explained_2_s3_q <= explained_2;
      and_2678_s3_q <= not_577_s2_q & and_2677;
      and_2712_s3_q <= not_577_s2_q & and_2711;
      and_2771_s3_q <= not_577_s2_q & (drew_q & (half_ends & equal_2768));
      and_2772_s3_q <= and_2772;
      residual_s3_q <= residual[7:0];
      and_2808_s3_q <= and_2808;
      and_2822_s3_q <= and_2772 & less_2821;
      equal_2864_s3_q <= (registration_fresh_q & select_2862) == 4'h0;
      parity_3241_s3_q <= ^{xor_3237, xor_3200, select_3167[44:36], other[44:36]};
      parity_3370_s3_q <= parity_3370;
      parity_3432_s3_q <= parity_3432;
      xor_3460_s3_q <= parity_3447 ^ parity_3459;
      parity_3472_s3_q <= ^{or_3469, or_3465, and_3461};
      or_3476_s3_q <= (or_3465 & or_3469) | (and_3461 & (or_3465 | or_3469));
      equal_3477_s3_q <= equal_3477_s2_q;
      and_3577_s3_q <= equal_1782_s2_q & equal_3574_s2_q;
      less_3602_s3_q <= select_3567 < select_3569;
      equal_3901_s3_q <= equal_3901_s2_q;
      and_4075_s3_q <= said_q;
      and_4123_s3_q <= and_2143 & (sum_2067 == sum_2050);
      and_4125_s3_q <= and_4125_s2_q;
      not_4143_s3_q <= not_4143_s2_q;
      equal_4196_s3_q <= (registration_fresh_q & select_4194) == 4'h0;
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
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_729_s3_q + {2'h0, sum_732_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_734;
  assign sum_734 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_736;
  assign sum_736 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_734});
  // hls/stages/census.hpp:317
  logic less_737;
  assign less_737 = 9'h4 < sum_736[13:5];
  logic and_738;
  assign and_738 = and_688_s3_q & less_737;
  // hls/stages/moments.hpp:30
  logic and_750;
  assign and_750 = (and_713_s3_q & and_740_s3_q) & less_749_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1670;
  assign equal_1670 = sum_1619_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1619_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1672;
  assign select_1672 = equal_1670 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1673;
  assign sum_1673 = (equal_1668_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1672[13]}}, select_1672};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1619_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1676;
  assign select_1676 = equal_1670 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1677;
  assign sum_1677 = (equal_1668_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1676[6]}}, select_1676};
  // hls/stages/patches.hpp:357
  logic [22:0] select_1798;
  assign select_1798 = and_1797_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1753_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1800;
  assign select_1800 = equal_1696_s3_q ? patches_place_0_valid_q : (select_1695_s3_q ? patches_place_0_valid_q : select_1798[0]);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1801;
  assign sum_1801 = {1'b0, select_545_s3_q, select_512_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_1802;
  assign select_1802 = select_1695_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1798[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1803;
  assign select_1803 = equal_1696_s3_q ? patches_place_0_column_q : select_1802[7:0];
  logic [5:0] select_1804;
  assign select_1804 = equal_1696_s3_q ? patches_place_0_shift_q : select_1802[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1805;
  assign sum_1805 = select_1803 + {{2{select_1804[5]}}, select_1804};
  // hls/stages/patches.hpp:132
  logic equal_1806;
  assign equal_1806 = {sum_1805, sum_1801[0], select_512_s3_q[1:0]} == {1'b0, sum_1801[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1808;
  assign or_1808 = row_starts_s3_q | (select_1800 & equal_1806);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1809;
  assign select_1809 = or_1808 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1819;
  assign select_1819 = or_1808 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1821;
  assign and_1821 = select_1818_s3_q & (~select_1819[5]);
  // hls/stages/patches.hpp:127
  logic select_1829;
  assign select_1829 = equal_1696_s3_q ? patches_place_1_valid_q : (select_1695_s3_q ? select_1798[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_1830;
  assign select_1830 = select_1695_s3_q ? select_1798[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1831;
  assign select_1831 = equal_1696_s3_q ? patches_place_1_column_q : select_1830[7:0];
  logic [5:0] select_1832;
  assign select_1832 = equal_1696_s3_q ? patches_place_1_shift_q : select_1830[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1833;
  assign sum_1833 = select_1831 + {{2{select_1832[5]}}, select_1832};
  // hls/stages/patches.hpp:132
  logic equal_1834;
  assign equal_1834 = {sum_1833[7], sum_1801, select_512_s3_q[1:0]} == {1'b0, sum_1833[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1836;
  assign or_1836 = row_starts_s3_q | (select_1829 & equal_1834);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1837;
  assign select_1837 = or_1836 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1838;
  assign select_1838 = or_1836 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1840;
  assign and_1840 = select_1818_s3_q & (~select_1838[5]);
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1847;
  assign sum_1847 = select_1803[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1848;
  assign equal_1848 = {sum_1847[6], select_545_s3_q, select_512_s3_q} == {1'b0, sum_1847[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1850;
  assign or_1850 = row_starts_s3_q | (select_1800 & equal_1848);
  logic [4:0] select_1851;
  assign select_1851 = or_1850 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1852;
  assign sum_1852 = select_1831[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1853;
  assign equal_1853 = {sum_1852[6], select_545_s3_q, select_512_s3_q} == {1'b0, sum_1852[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1856;
  assign select_1856 = (row_starts_s3_q | (select_1829 & equal_1853)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1851[4] ? select_1856[3:0] : select_1851[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1859;
  assign select_1859 = or_1850 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1865;
  assign and_1865 = (select_1818_s3_q & (select_1812_s3_q[3] ^ select_1812_s3_q[4])) & ((~select_1851[4]) | (~select_1856[4]));
  // hls/stages/patches.hpp:186
  logic less_1969;
  assign less_1969 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1970;
  assign not_1970 = ~less_1969;
  logic [1:0] select_1971;
  assign select_1971 = patches_summed_first_s3_q ? 2'h2 : {less_1969, not_1970};
  logic [12:0] select_1972;
  assign select_1972 = select_1971[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1980;
  assign select_1980 = select_1971[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1979_s3_q, 1'b0, select_1976_s3_q, left_pixel_q};
  logic [14:0] select_1981;
  assign select_1981 = select_1971[1] ? {select_1972[12:8], patches_sums_values_0_q[9:8], select_1972[7:0]} : select_1980;
  // hls/stages/agreement.hpp:907
  logic [5:0] select_2006;
  assign select_2006 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:908
  logic [5:0] sum_2007;
  assign sum_2007 = {5'h0, textured_s3_q} + select_2006;
  // hls/stages/agreement.hpp:1068
  logic [9:0] sum_2009;
  assign sum_2009 = {4'h0, sum_2007} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:907
  logic [5:0] select_2011;
  assign select_2011 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:908
  logic [5:0] sum_2012;
  assign sum_2012 = {5'h0, explained_s3_q} + select_2011;
  // hls/stages/agreement.hpp:1069
  logic [9:0] sum_2014;
  assign sum_2014 = {4'h0, sum_2012} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:907
  logic [5:0] select_2021;
  assign select_2021 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:909
  logic [5:0] sum_2022;
  assign sum_2022 = {5'h0, and_2020_s3_q} + select_2021;
  // hls/stages/agreement.hpp:1070
  logic [9:0] sum_2024;
  assign sum_2024 = {4'h0, sum_2022} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1101
  logic [2:0] select_2076;
  assign select_2076 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2077;
  assign difference_2077 = {1'b0, textured_2_s3_q} - {1'b0, select_2076};
  logic [4:0] t;
  assign t = {difference_2077[3], difference_2077} + (equal_571_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1107
  logic equal_2080;
  assign equal_2080 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1108
  logic [2:0] region_row;
  assign region_row = draws_late_s3_q ? 3'h5 : region_row_s3_q;
  // hls/stages/agreement.hpp:1109
  logic not_2093;
  assign not_2093 = ~region_row[2];
  logic [2:0] select_2094;
  assign select_2094 = region_row[1] ? {1'b0, not_2093, 1'b0} : {region_row[2], 1'b0, not_2093};
  logic [5:0] select_2095;
  assign select_2095 = region_row[0] ? {select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0], 1'b0} : {1'b0, select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0]};
  logic [11:0] select_2096;
  assign select_2096 = or_2091_s3_q ? {select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0], 1'b0} : {1'b0, select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0]};
  logic [23:0] select_2097;
  assign select_2097 = or_2088_s3_q ? {select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0], 1'b0} : {1'b0, select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0]};
  logic [47:0] select_2098;
  assign select_2098 = or_2085_s3_q ? {select_2097[23], 1'b0, select_2097[22], 1'b0, select_2097[21], 1'b0, select_2097[20], 1'b0, select_2097[19], 1'b0, select_2097[18], 1'b0, select_2097[17], 1'b0, select_2097[16], 1'b0, select_2097[15], 1'b0, select_2097[14], 1'b0, select_2097[13], 1'b0, select_2097[12], 1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[23], 1'b0, select_2097[22], 1'b0, select_2097[21], 1'b0, select_2097[20], 1'b0, select_2097[19], 1'b0, select_2097[18], 1'b0, select_2097[17], 1'b0, select_2097[16], 1'b0, select_2097[15], 1'b0, select_2097[14], 1'b0, select_2097[13], 1'b0, select_2097[12], 1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  // hls/stages/agreement.hpp:1037
  logic and_2102;
  assign and_2102 = good_known_q & (~((good_q & select_2098) == 48'h0));
  // hls/stages/agreement.hpp:1103
  logic [2:0] select_2111;
  assign select_2111 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2112;
  assign difference_2112 = {1'b0, shown_2_s3_q} - {1'b0, select_2111};
  logic [4:0] around;
  assign around = {difference_2112[3], difference_2112} + (equal_571_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1111
  logic [5:0] sum_2115;
  assign sum_2115 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2080 ? and_2102 : (~({sum_2115, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1104
  logic [2:0] select_2127;
  assign select_2127 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2128;
  assign difference_2128 = {1'b0, near_2_s3_q} - {1'b0, select_2127};
  logic [4:0] n;
  assign n = {difference_2128[3], difference_2128} + (equal_571_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1120
  logic and_2132;
  assign and_2132 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s3_q ? (and_549_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2171;
  assign select_2171 = sample_pair_whole_s3_q ? (and_549_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2173;
  assign select_2173 = sample_pair_whole_s3_q ? (and_549_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2175;
  assign select_2175 = sample_pair_whole_s3_q ? (and_549_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2180;
  assign sum_2180 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2181;
  assign difference_2181 = {1'b0, sum_2180[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2182;
  assign xor_2182 = {difference_2181[8:0], sum_2180[0]} ^ {10{difference_2181[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2181[9]} + {1'b0, xor_2182};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_554_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2187;
  assign select_2187 = sample_pair_whole_s3_q ? (and_549_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2188;
  assign sum_2188 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2189;
  assign difference_2189 = {1'b0, sum_2188[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2190;
  assign xor_2190 = {difference_2189[8:0], sum_2188[0]} ^ {10{difference_2189[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2189[9]} + {1'b0, xor_2190};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_554_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2195;
  assign select_2195 = sample_pair_whole_s3_q ? (and_549_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2279;
  assign sum_2279 = sum_2275_s3_q + {2'h0, sum_2278_s3_q};
  // hls/stages/agreement.hpp:527
  logic [11:0] select_2281;
  assign select_2281 = and_551_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2282;
  assign select_2282 = and_551_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2283;
  assign select_2283 = and_551_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2284;
  assign select_2284 = and_551_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2287;
  assign sum_2287 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2279};
  logic [13:0] sum_2289;
  assign sum_2289 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2287});
  // hls/stages/census.hpp:323
  logic and_2291;
  assign and_2291 = and_713_s3_q & (9'h4 < sum_2289[13:5]);
  // hls/stages/census.hpp:324
  logic and_2292;
  assign and_2292 = and_713_s3_q & less_737;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2293;
  assign sum_2293 = census_left_misses_q + {{17{and_2292}}, and_2291, 1'b0, and_2291};
  // hls/stages/agreement.hpp:527
  logic [19:0] select_2295;
  assign select_2295 = and_551_s3_q ? (equal_2286_s3_q ? 20'h0 : sum_2293) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2365;
  assign select_2365 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:527
  logic select_2368;
  assign select_2368 = and_551_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2371;
  assign and_2371 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:461
  logic and_2377;
  assign and_2377 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2378;
  assign and_2378 = and_2371 & and_2377;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2365[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2380;
  assign select_2380 = and_2378 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2382;
  assign select_2382 = equal_2286_s3_q ? {11'h0, select_2380} : (sharpness_sums_detail_0_q + {11'h0, select_2380});
  // hls/stages/agreement.hpp:461
  logic and_2389;
  assign and_2389 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2390;
  assign and_2390 = and_2371 & and_2389;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2365[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2392;
  assign select_2392 = and_2390 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2394;
  assign select_2394 = equal_2286_s3_q ? {11'h0, select_2392} : (sharpness_sums_detail_1_q + {11'h0, select_2392});
  logic [8:0] select_2397;
  assign select_2397 = and_2378 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2398;
  assign sum_2398 = (equal_2286_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2397};
  logic [8:0] select_2401;
  assign select_2401 = and_2390 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2402;
  assign sum_2402 = (equal_2286_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2401};
  // hls/stages/agreement.hpp:211
  logic equal_2404;
  assign equal_2404 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2405;
  assign less_2405 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2406;
  assign less_2406 = x_s3_q[4:0] < 5'h3;
  logic not_2407;
  assign not_2407 = ~x_s3_q[1];
  logic [2:0] select_2408;
  assign select_2408 = x_s3_q[0] ? {1'b0, not_2407, 1'b0} : {x_s3_q[1], 1'b0, not_2407};
  logic [5:0] select_2409;
  assign select_2409 = slot_s3_q[2] ? {select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0], 1'b0} : {1'b0, select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0]};
  logic [11:0] select_2410;
  assign select_2410 = slot_s3_q[1] ? {select_2409[5], 1'b0, select_2409[4], 1'b0, select_2409[3], 1'b0, select_2409[2], 1'b0, select_2409[1], 1'b0, select_2409[0], 1'b0} : {1'b0, select_2409[5], 1'b0, select_2409[4], 1'b0, select_2409[3], 1'b0, select_2409[2], 1'b0, select_2409[1], 1'b0, select_2409[0]};
  logic [23:0] select_2411;
  assign select_2411 = slot_s3_q[0] ? {select_2410[11], 1'b0, select_2410[10], 1'b0, select_2410[9], 1'b0, select_2410[8], 1'b0, select_2410[7], 1'b0, select_2410[6], 1'b0, select_2410[5], 1'b0, select_2410[4], 1'b0, select_2410[3], 1'b0, select_2410[2], 1'b0, select_2410[1], 1'b0, select_2410[0], 1'b0} : {1'b0, select_2410[11], 1'b0, select_2410[10], 1'b0, select_2410[9], 1'b0, select_2410[8], 1'b0, select_2410[7], 1'b0, select_2410[6], 1'b0, select_2410[5], 1'b0, select_2410[4], 1'b0, select_2410[3], 1'b0, select_2410[2], 1'b0, select_2410[1], 1'b0, select_2410[0]};
  // hls/stages/census.hpp:390
  logic and_2415;
  assign and_2415 = less_2406 & (~((sharpness_sums_contrast_1_q & select_2411) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2417;
  assign select_2417 = (less_2405 & and_2415) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2417};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2420;
  assign select_2420 = equal_2404 ? (less_2405 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2425;
  assign and_2425 = less_2406 & (~((sharpness_sums_contrast_0_q & select_2411) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2427;
  assign select_2427 = (less_2405 & and_2425) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2427};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2430;
  assign select_2430 = equal_2404 ? (less_2405 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2432;
  assign select_2432 = equal_2404 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2434;
  assign select_2434 = equal_2404 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2436;
  assign select_2436 = equal_2404 ? {sharpness_comparing_contrast_0_q[0], and_2425} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2438;
  assign select_2438 = equal_2404 ? {sharpness_comparing_contrast_1_q[0], and_2415} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2443;
  assign select_2443 = so_s3_q ? (equal_2404 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2447;
  assign select_2447 = so_s3_q ? (equal_2404 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2448;
  assign equal_2448 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2449;
  assign xor_2449 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2452;
  assign select_2452 = (equal_2448 | xor_2449) ? (five_times[0] & xor_2449) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2454;
  assign select_2454 = so_s3_q ? (equal_2404 ? select_2452 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2455;
  assign xor_2455 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2458;
  assign select_2458 = (equal_2448 | xor_2455) ? (five_times_2[0] & xor_2455) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2460;
  assign select_2460 = so_s3_q ? (equal_2404 ? select_2458 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2461;
  assign xor_2461 = sharpness_comparing_contrast_0_q[1] ^ and_2415;
  logic select_2464;
  assign select_2464 = (equal_2448 | xor_2461) ? (and_2415 & xor_2461) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2466;
  assign select_2466 = so_s3_q ? (equal_2404 ? select_2464 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2467;
  assign xor_2467 = sharpness_comparing_contrast_1_q[1] ^ and_2425;
  logic select_2470;
  assign select_2470 = (equal_2448 | xor_2467) ? (and_2425 & xor_2467) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2472;
  assign select_2472 = so_s3_q ? (equal_2404 ? select_2470 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:933
  logic [13:0] select_2618;
  assign select_2618 = and_2610_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2616_s3_q});
  // hls/stages/agreement.hpp:795
  logic and_2621;
  assign and_2621 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2626;
  assign and_2626 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2631;
  assign and_2631 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2020_s3_q));
  // hls/stages/agreement.hpp:1113
  logic not_2635;
  assign not_2635 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1102
  logic [2:0] select_2644;
  assign select_2644 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2645;
  assign difference_2645 = {1'b0, explained_2_s3_q} - {1'b0, select_2644};
  logic [4:0] e;
  assign e = {difference_2645[3], difference_2645} + (equal_571_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1110
  logic [5:0] sum_2648;
  assign sum_2648 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1114
  logic not_2652;
  assign not_2652 = ~(equal_2080 ? and_2102 : (~({sum_2648, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:795
  logic and_2655;
  assign and_2655 = ends_cell_s3_q & (not_2635 & (centres_values_1_textured_s3_q & not_2652));
  logic and_2657;
  assign and_2657 = not_577_s3_q & (so_s3_q & and_2655);
  // hls/stages/agreement.hpp:1140
  logic less_2660;
  assign less_2660 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2661;
  assign select_2661 = less_2660 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2664;
  assign select_2664 = less_2660 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1141
  logic [10:0] sum_2665;
  assign sum_2665 = {1'b0, select_2664} + {3'h0, select_2664[9:2]};
  logic and_2667;
  assign and_2667 = (~(select_2661[9:4] == 6'h0)) & ({sum_2665, select_2664[1:0]} < {3'h0, select_2661});
  // hls/stages/agreement.hpp:1150
  logic [9:0] select_2670;
  assign select_2670 = x_s3_q[6] ? (equal_1613_s3_q ? 10'h0 : (and_2667 ? select_2661 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:795
  logic [9:0] select_2671;
  assign select_2671 = equal_576_s3_q ? select_2670 : 10'h0;
  // hls/stages/agreement.hpp:933
  logic [13:0] select_2673;
  assign select_2673 = and_2610_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2671});
  logic [13:0] select_2680;
  assign select_2680 = and_2610_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2678_s3_q});
  // hls/stages/agreement.hpp:1118
  logic and_2682;
  assign and_2682 = not_2635 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:795
  logic and_2685;
  assign and_2685 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2682));
  // hls/stages/agreement.hpp:933
  logic [13:0] select_2687;
  assign select_2687 = and_2610_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2685});
  // hls/stages/agreement.hpp:1118
  logic and_2689;
  assign and_2689 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2652);
  // hls/stages/agreement.hpp:795
  logic and_2693;
  assign and_2693 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & (not_2635 & and_2689)));
  // hls/stages/agreement.hpp:933
  logic [13:0] select_2695;
  assign select_2695 = and_2610_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2693});
  logic [13:0] select_2714;
  assign select_2714 = and_2610_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2712_s3_q});
  // hls/stages/agreement.hpp:795
  logic [7:0] select_2790;
  assign select_2790 = so_s3_q ? (equal_1706_s3_q ? (and_2772_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2791;
  assign select_2791 = equal_576_s3_q ? 8'h0 : select_2790;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2793;
  assign select_2793 = and_2771_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2791[7]}}, select_2791});
  // hls/stages/agreement.hpp:795
  logic and_2796;
  assign and_2796 = not_577_s3_q & (so_s3_q & (and_2772_s3_q & equal_1706_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2798;
  assign select_2798 = and_2771_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2796});
  // hls/stages/registration.hpp:107
  logic and_2800;
  assign and_2800 = and_2772_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:795
  logic [1:0] select_2802;
  assign select_2802 = so_s3_q ? (equal_1706_s3_q ? {and_2800, and_2772_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2803;
  assign select_2803 = equal_576_s3_q ? 2'h0 : select_2802;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2804;
  assign sum_2804 = registration_half_votes_down_q + {{5{select_2803[1]}}, select_2803};
  // hls/stages/agreement.hpp:795
  logic [1:0] select_2810;
  assign select_2810 = so_s3_q ? (equal_1706_s3_q ? {and_2808_s3_q, and_2772_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2811;
  assign select_2811 = equal_576_s3_q ? 2'h0 : select_2810;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2812;
  assign sum_2812 = registration_half_votes_up_q + {{5{select_2811[1]}}, select_2811};
  // hls/stages/registration.hpp:107
  logic and_2815;
  assign and_2815 = and_2772_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:795
  logic [1:0] select_2817;
  assign select_2817 = so_s3_q ? (equal_1706_s3_q ? {and_2815, and_2772_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2818;
  assign select_2818 = equal_576_s3_q ? 2'h0 : select_2817;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2819;
  assign sum_2819 = registration_half_half_votes_down_q + {{5{select_2818[1]}}, select_2818};
  // hls/stages/agreement.hpp:795
  logic [1:0] select_2824;
  assign select_2824 = so_s3_q ? (equal_1706_s3_q ? {and_2822_s3_q, and_2772_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2825;
  assign select_2825 = equal_576_s3_q ? 2'h0 : select_2824;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2826;
  assign sum_2826 = registration_half_half_votes_up_q + {{5{select_2825[1]}}, select_2825};
  // hls/stages/agreement.hpp:795
  logic and_2859;
  assign and_2859 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & less_1644_s3_q));
  // hls/stages/agreement.hpp:1138
  logic [11:0] select_2866;
  assign select_2866 = or_1648_s3_q ? 12'h0 : (equal_2864_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1150
  logic [11:0] select_2869;
  assign select_2869 = x_s3_q[6] ? (equal_1613_s3_q ? 12'h0 : (less_1644_s3_q ? select_2866 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:795
  logic [11:0] select_2870;
  assign select_2870 = equal_576_s3_q ? select_2869 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2871;
  assign and_2871 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1150
  logic and_2874;
  assign and_2874 = not_1993_s3_q & (less_1644_s3_q & ({and_2871, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:795
  logic and_2876;
  assign and_2876 = equal_576_s3_q & (x_s3_q[6] & and_2874);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2878;
  assign sum_2878 = {{2{select_2870[11]}}, select_2870} + (and_2876 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1138
  logic [11:0] select_2881;
  assign select_2881 = or_1648_s3_q ? 12'h0 : (equal_2864_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1150
  logic [11:0] select_2884;
  assign select_2884 = x_s3_q[6] ? (equal_1613_s3_q ? 12'h0 : (less_1644_s3_q ? select_2881 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:795
  logic [11:0] select_2885;
  assign select_2885 = equal_576_s3_q ? select_2884 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2887;
  assign sum_2887 = {{2{select_2885[11]}}, select_2885} + (and_2876 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2889;
  assign not_2889 = ~all_s3_q;
  // hls/stages/agreement.hpp:1150
  logic and_2892;
  assign and_2892 = not_1993_s3_q & (less_1644_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2889, 1'b0}));
  // hls/stages/agreement.hpp:795
  logic and_2898;
  assign and_2898 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2899;
  assign not_2899 = ~and_2898;
  logic less_2900;
  assign less_2900 = $signed({9'h1, {2{not_2899}}, and_2898}) < $signed(registration_up_q[13:2]);
  logic select_2901;
  assign select_2901 = (equal_576_s3_q & (x_s3_q[6] & and_2892)) ? less_2900 : registration_enough_q;
  // hls/stages/agreement.hpp:1150
  logic and_2905;
  assign and_2905 = x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:795
  logic and_2906;
  assign and_2906 = equal_576_s3_q & and_2905;
  // hls/stages/registration.hpp:242
  logic less_2907;
  assign less_2907 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2909;
  assign less_2909 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2911;
  assign equal_2911 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:795
  logic and_2915;
  assign and_2915 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & equal_2911)));
  // hls/stages/agreement.hpp:1150
  logic and_2922;
  assign and_2922 = x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2925;
  assign equal_2925 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1150
  logic and_2928;
  assign and_2928 = not_1993_s3_q & (less_1644_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2925));
  // hls/stages/registration.hpp:244
  logic and_2932;
  assign and_2932 = (equal_576_s3_q & (x_s3_q[6] & and_2928)) & (less_2909 | less_2907);
  // hls/stages/agreement.hpp:1150
  logic and_2937;
  assign and_2937 = not_1993_s3_q & (less_1644_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2925)));
  // hls/stages/registration.hpp:244
  logic and_2940;
  assign and_2940 = registration_votes_up_q & registration_other_down_q;
  logic select_2942;
  assign select_2942 = registration_votes_down_q ? (registration_other_up_q | and_2940) : and_2940;
  // hls/stages/registration.hpp:138
  logic and_2944;
  assign and_2944 = (equal_576_s3_q & (x_s3_q[6] & and_2937)) & (registration_other_enough_q & select_2942);
  // hls/stages/registration.hpp:245
  logic or_2947;
  assign or_2947 = registration_moved_q | (registration_enough_q & (and_2932 | and_2944));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3030;
  assign select_3030 = sample_pair_whole_s3_q ? (equal_1696_s3_q ? patches_place_0_slope_q : select_1802[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3035;
  assign select_3035 = sample_pair_whole_s3_q ? (equal_1696_s3_q ? patches_place_1_slope_q : select_1830[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3037;
  assign select_3037 = equal_1696_s3_q ? patches_valid_0_q : (select_1695_s3_q ? patches_valid_0_q : select_1798[0]);
  // hls/stages/agreement.hpp:276
  logic select_3040;
  assign select_3040 = sample_pair_whole_s3_q ? (and_1821 ? (sample_present_s3_q & select_3037) : select_3037) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3042;
  assign select_3042 = equal_1696_s3_q ? patches_valid_1_q : (select_1695_s3_q ? select_1798[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3045;
  assign select_3045 = sample_pair_whole_s3_q ? (and_1840 ? (sample_present_s3_q & select_3042) : select_3042) : patches_valid_1_q;
  logic [5:0] select_3048;
  assign select_3048 = sample_pair_whole_s3_q ? (select_1819[5] ? {1'b1, select_1819[4:0]} : (select_1819 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3051;
  assign select_3051 = sample_pair_whole_s3_q ? (select_1838[5] ? {1'b1, select_1838[4:0]} : (select_1838 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3054;
  assign select_3054 = sample_pair_whole_s3_q ? (select_1851[4] ? {1'b1, select_1851[3:0]} : (select_1851 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3057;
  assign select_3057 = sample_pair_whole_s3_q ? (select_1856[4] ? {1'b1, select_1856[3:0]} : (select_1856 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3476_s3_q, parity_3472_s3_q, xor_3460_s3_q, parity_3432_s3_q, parity_3370_s3_q, parity_3241_s3_q} + (equal_3477_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3481;
  assign select_3481 = equal_1782_s3_q ? patches_sums_values_0_q : (equal_1784_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3482;
  assign select_3482 = equal_1784_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1784_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1784_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1784_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1784_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1784_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1784_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3496;
  assign select_3496 = equal_1784_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3498;
  assign select_3498 = equal_1784_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3500;
  assign select_3500 = equal_1784_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3502;
  assign select_3502 = equal_1784_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3504;
  assign select_3504 = equal_1784_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3506;
  assign select_3506 = equal_1784_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3508;
  assign select_3508 = equal_1784_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3510;
  assign select_3510 = equal_1784_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3512;
  assign select_3512 = equal_1784_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_3583;
  assign difference_3583 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_3586;
  assign and_3586 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_3583, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_3589;
  assign not_3589 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_3592;
  assign and_3592 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_3586 & ((10'h38 < patches_peak_size_q) & not_3589));
  // hls/stages/patches.hpp:190
  logic and_3594;
  assign and_3594 = and_3577_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_3592);
  // hls/stages/patches.hpp:667
  logic not_3595;
  assign not_3595 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_3597;
  assign and_3597 = and_3594 & (not_1789_s3_q & not_3595);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3599;
  assign sum_3599 = {7'h0, and_3597} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3603;
  assign sum_3603 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3602_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_3610;
  assign not_3610 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3611;
  assign sum_3611 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3613;
  assign not_3613 = ~({eight, 3'h0} < {1'b0, sum_3611, fall_2[0]});
  logic [1:0] sum_3614;
  assign sum_3614 = {1'b0, not_3610} + {1'b0, not_3613};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3615;
  assign sum_3615 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3617;
  assign not_3617 = ~({eight, 3'h0} < {sum_3615, fall_2[1:0]});
  logic not_3620;
  assign not_3620 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3621;
  assign sum_3621 = {1'b0, not_3617} + {1'b0, not_3620};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3614} + {1'b0, sum_3621};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3624;
  assign select_3624 = less_3602_s3_q ? ({sum_3603, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_3603, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3625;
  assign select_3625 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_3626;
  assign select_3626 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3627;
  assign sum_3627 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_3628;
  assign sum_3628 = {select_3626[5], select_3626} + {{3{sum_3627[3]}}, sum_3627};
  // hls/stages/patches.hpp:604
  logic [17:0] product_3629;
  assign product_3629 = $signed({{10{select_3625[7]}}, select_3625}) * $signed({{8{sum_3628[6]}}, sum_3628, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_3630;
  assign difference_3630 = {{6{select_3624[7]}}, select_3624} - {product_3629[17], product_3629[17:5]};
  // hls/stages/patches.hpp:611
  logic less_3631;
  assign less_3631 = $signed({{7{difference_3601[6]}}, difference_3601}) < $signed(difference_3630);
  // hls/stages/patches.hpp:189
  logic not_3632;
  assign not_3632 = ~less_3631;
  // hls/stages/patches.hpp:670
  logic and_3633;
  assign and_3633 = not_3632 & and_3597;
  logic [7:0] sum_3634;
  assign sum_3634 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3633};
  // hls/stages/patches.hpp:189
  logic not_3637;
  assign not_3637 = ~($signed(difference_3630) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_3638;
  assign and_3638 = not_3637 & and_3597;
  logic [7:0] sum_3639;
  assign sum_3639 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3638};
  // hls/stages/patches.hpp:192
  logic and_3641;
  assign and_3641 = and_3594 & (patches_second_s3_q & not_3595);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3643;
  assign sum_3643 = {7'h0, and_3641} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3645;
  assign and_3645 = not_3632 & and_3641;
  logic [7:0] sum_3646;
  assign sum_3646 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3645};
  // hls/stages/patches.hpp:671
  logic and_3648;
  assign and_3648 = not_3637 & and_3641;
  logic [7:0] sum_3649;
  assign sum_3649 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3648};
  // hls/stages/patches.hpp:192
  logic and_3651;
  assign and_3651 = and_3594 & (patches_lower_s3_q & not_1789_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3653;
  assign sum_3653 = {7'h0, and_3651} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3655;
  assign and_3655 = not_3632 & and_3651;
  logic [7:0] sum_3656;
  assign sum_3656 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3655};
  // hls/stages/patches.hpp:671
  logic and_3658;
  assign and_3658 = not_3637 & and_3651;
  logic [7:0] sum_3659;
  assign sum_3659 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3658};
  // hls/stages/patches.hpp:192
  logic and_3661;
  assign and_3661 = and_3594 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3663;
  assign sum_3663 = {7'h0, and_3661} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3665;
  assign and_3665 = not_3632 & and_3661;
  logic [7:0] sum_3666;
  assign sum_3666 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3665};
  // hls/stages/patches.hpp:671
  logic and_3668;
  assign and_3668 = not_3637 & and_3661;
  logic [7:0] sum_3669;
  assign sum_3669 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3668};
  // hls/stages/agreement.hpp:1231
  logic equal_3670;
  assign equal_3670 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1138
  logic less_3671;
  assign less_3671 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:795
  logic and_3675;
  assign and_3675 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (equal_3670 & less_3671)));
  // hls/stages/agreement.hpp:1150
  logic and_3680;
  assign and_3680 = x_s3_q[6] & (not_1993_s3_q & (less_3671 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:795
  logic and_3681;
  assign and_3681 = equal_576_s3_q & and_3680;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3683;
  assign or_3683 = (and_3675 ? patches_quarters_0_places_q : 8'h0) | (and_3681 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1150
  logic and_3687;
  assign and_3687 = x_s3_q[6] & (not_1993_s3_q & (less_3671 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:795
  logic and_3688;
  assign and_3688 = equal_576_s3_q & and_3687;
  // hls/stages/agreement.hpp:1150
  logic and_3694;
  assign and_3694 = x_s3_q[6] & (not_1993_s3_q & (less_3671 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:795
  logic and_3695;
  assign and_3695 = equal_576_s3_q & and_3694;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3697;
  assign or_3697 = (or_3683 | (and_3688 ? patches_quarters_2_places_q : 8'h0)) | (and_3695 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_3701;
  assign select_3701 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:795
  logic and_3705;
  assign and_3705 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_3671 & select_3701)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_3707;
  assign select_3707 = and_3675 ? (and_3705 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3709;
  assign select_3709 = and_3681 ? (and_3705 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3712;
  assign select_3712 = and_3688 ? (and_3705 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3715;
  assign select_3715 = and_3695 ? (and_3705 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3718;
  assign select_3718 = and_3675 ? (and_3705 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3720;
  assign select_3720 = and_3681 ? (and_3705 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3723;
  assign select_3723 = and_3688 ? (and_3705 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3726;
  assign select_3726 = and_3695 ? (and_3705 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3728;
  assign sum_3728 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1150
  logic and_3732;
  assign and_3732 = x_s3_q[6] & (not_1993_s3_q & (less_3671 & (sum_3728[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:795
  logic and_3733;
  assign and_3733 = equal_576_s3_q & and_3732;
  // hls/stages/patches.hpp:630
  logic [7:0] select_3736;
  assign select_3736 = and_3733 ? (patches_word_places_q + (and_3681 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3739;
  assign select_3739 = and_3733 ? (patches_word_up_q + (and_3681 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3742;
  assign select_3742 = and_3733 ? (patches_word_down_q + (and_3681 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3745;
  assign select_3745 = ($signed(difference_3630[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3630[5:0];
  logic [5:0] select_3746;
  assign select_3746 = ($signed(14'h10) < $signed(difference_3630)) ? 6'h10 : select_3745;
  // hls/stages/patches.hpp:673
  logic [5:0] select_3747;
  assign select_3747 = and_3594 ? select_3746 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_3749;
  assign select_3749 = patches_round_ends_q ? {{6{select_3747[5]}}, select_3747} : (patches_across_q + {{6{select_3747[5]}}, select_3747});
  // hls/stages/agreement.hpp:795
  logic and_3753;
  assign and_3753 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (equal_2911 & less_3671)));
  // hls/stages/agreement.hpp:1150
  logic and_3757;
  assign and_3757 = x_s3_q[6] & (not_1993_s3_q & (less_3671 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:795
  logic and_3758;
  assign and_3758 = equal_576_s3_q & and_3757;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3760;
  assign select_3760 = and_3753 ? (and_3758 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3764;
  assign or_3764 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3767;
  assign or_3767 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3768;
  assign sum_3768 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3770;
  assign select_3770 = and_3753 ? (and_3758 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3773;
  assign and_3773 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3775;
  assign select_3775 = and_3758 ? {and_3773, patches_found_q[2:1]} : (and_3753 ? {and_3773, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_3779;
  assign or_3779 = patches_partly_q | (patches_doubted_q & (~and_3758));
  // hls/stages/patches.hpp:656
  logic select_3782;
  assign select_3782 = and_3753 ? (and_3758 ? or_3779 : (and_3753 ? or_3779 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_3783;
  assign select_3783 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3787;
  assign select_3787 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_3789;
  assign sum_3789 = {sum_3628[6], sum_3628, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_3791;
  assign and_3791 = ({{5{sum_3789[10]}}, sum_3789} < 16'h3) & and_3594;
  logic [7:0] sum_3792;
  assign sum_3792 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3791};
  // hls/stages/patches.hpp:663
  logic [12:0] product_3797;
  assign product_3797 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_3760};
  // hls/stages/patches.hpp:192
  logic and_3799;
  assign and_3799 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3797[12:5] < patches_on_skin_q);
  logic select_3804;
  assign select_3804 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3808;
  assign or_3808 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3815;
  assign select_3815 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3821;
  assign and_3821 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3822;
  assign sum_3822 = patches_age_q + {9'h0, and_3821};
  logic [9:0] select_3825;
  assign select_3825 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3822)) : sum_3822;
  // hls/stages/agreement.hpp:1196
  logic or_3882;
  assign or_3882 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1225
  logic equal_3884;
  assign equal_3884 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1234
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1235
  logic select_3890;
  assign select_3890 = (equal_3884 & equal_3670) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1143
  logic [10:0] sum_3893;
  assign sum_3893 = {1'b0, select_2664} + {2'h0, select_2664[9:1]};
  logic select_3896;
  assign select_3896 = (select_2661[9:3] == 7'h0) ? ((~or_3882) & (~select_3890)) : (~({sum_3893, select_2664[0]} < {2'h0, select_2661}));
  // hls/stages/agreement.hpp:1150
  logic [47:0] select_3898;
  assign select_3898 = x_s3_q[6] ? (equal_1613_s3_q ? good_q : {select_3896, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:795
  logic select_3903;
  assign select_3903 = equal_576_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3901_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1225
  logic equal_3904;
  assign equal_3904 = x_s3_q[6:3] == 4'ha;
  logic equal_3906;
  assign equal_3906 = x_s3_q[6:3] == 4'hc;
  logic equal_3907;
  assign equal_3907 = x_s3_q[6:3] == 4'hb;
  logic equal_3908;
  assign equal_3908 = x_s3_q[6:3] == 4'h9;
  logic equal_3909;
  assign equal_3909 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1133
  logic [13:0] select_3911;
  assign select_3911 = equal_3908 ? counts_skin_unproven_q : (equal_3909 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3913;
  assign select_3913 = equal_3907 ? counts_regions_bad_q : (equal_3904 ? counts_nearer_q : select_3911);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3906 ? counts_on_skin_q : select_3913;
  // hls/stages/agreement.hpp:1230
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1238
  logic select_3916;
  assign select_3916 = (equal_3904 & equal_3670) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1156
  logic not_3917;
  assign not_3917 = ~hidden_for_q[7];
  logic [7:0] select_3919;
  assign select_3919 = select_3916 ? (hidden_for_q + {7'h0, not_3917}) : 8'h0;
  // hls/stages/agreement.hpp:795
  logic [7:0] select_3921;
  assign select_3921 = equal_576_s3_q ? (equal_3901_s3_q ? select_3919 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1239
  logic [13:0] select_3922;
  assign select_3922 = equal_3670 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1133
  logic [7:0] select_3924;
  assign select_3924 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3926;
  assign select_3926 = equal_3909 ? cfg_unproven_skin_limit_i : (equal_3884 ? cfg_unproven_limit_i : select_3924);
  logic [7:0] select_3928;
  assign select_3928 = equal_3904 ? cfg_regions_limit_i : (equal_3908 ? cfg_hidden_limit_i : select_3926);
  logic [7:0] limit;
  assign limit = equal_3906 ? cfg_regions_limit_i : (equal_3907 ? {cfg_on_skin_limit_i, 3'h0} : select_3928);
  // hls/stages/agreement.hpp:1239
  logic not_3931;
  assign not_3931 = ~x_s3_q[2];
  logic [3:0] select_3932;
  assign select_3932 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3931, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3931};
  logic [7:0] select_3933;
  assign select_3933 = x_s3_q[0] ? {select_3932[3], 1'b0, select_3932[2], 1'b0, select_3932[1], 1'b0, select_3932[0], 1'b0} : {1'b0, select_3932[3], 1'b0, select_3932[2], 1'b0, select_3932[1], 1'b0, select_3932[0]};
  // hls/stages/agreement.hpp:1133
  logic [13:0] select_3937;
  assign select_3937 = equal_3908 ? counts_skin_supervised_q : (equal_3909 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3939;
  assign select_3939 = equal_3907 ? counts_skin_textured_q : (equal_3904 ? counts_textured_q : select_3937);
  logic [13:0] of;
  assign of = equal_3906 ? counts_textured_q : select_3939;
  // hls/stages/agreement.hpp:1239
  logic [13:0] select_3941;
  assign select_3941 = ((limit & select_3933) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3922} + {1'b0, select_3941};
  // hls/stages/agreement.hpp:795
  logic select_3946;
  assign select_3946 = equal_576_s3_q ? (equal_3670 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1236
  logic and_3951;
  assign and_3951 = too_much_q & (~(equal_3909 & equal_3670));
  // hls/stages/agreement.hpp:1237
  logic select_3956;
  assign select_3956 = (over[14] & equal_3670) ? (and_3951 | ((equal_3909 | equal_3908) | (x_s3_q[6:3] == 4'hf))) : and_3951;
  // hls/stages/agreement.hpp:1133
  logic and_3961;
  assign and_3961 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1239
  logic select_3962;
  assign select_3962 = (equal_3906 & equal_3670) ? and_3961 : overlooks_q;
  // hls/stages/agreement.hpp:795
  logic [2:0] select_3964;
  assign select_3964 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3966;
  assign select_3966 = equal_576_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_3964 : box_textured_columns_values_0_q);
  logic [2:0] select_3967;
  assign select_3967 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3969;
  assign select_3969 = equal_576_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3967 : box_textured_columns_values_1_q);
  logic [2:0] select_3970;
  assign select_3970 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3972;
  assign select_3972 = equal_576_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3970 : box_textured_columns_values_2_q);
  logic [2:0] select_3973;
  assign select_3973 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3975;
  assign select_3975 = equal_576_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3973 : box_textured_columns_values_3_q);
  logic [2:0] select_3976;
  assign select_3976 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3978;
  assign select_3978 = equal_576_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3976 : box_textured_columns_values_4_q);
  logic [4:0] select_3980;
  assign select_3980 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3982;
  assign select_3982 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3984;
  assign select_3984 = equal_576_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_3982 : box_explained_columns_values_0_q);
  logic [2:0] select_3985;
  assign select_3985 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3987;
  assign select_3987 = equal_576_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3985 : box_explained_columns_values_1_q);
  logic [2:0] select_3988;
  assign select_3988 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3990;
  assign select_3990 = equal_576_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3988 : box_explained_columns_values_2_q);
  logic [2:0] select_3991;
  assign select_3991 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3993;
  assign select_3993 = equal_576_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3991 : box_explained_columns_values_3_q);
  logic [2:0] select_3994;
  assign select_3994 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3996;
  assign select_3996 = equal_576_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3994 : box_explained_columns_values_4_q);
  logic [4:0] select_3998;
  assign select_3998 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4001;
  assign select_4001 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_576_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4003 : box_shown_columns_values_1_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_576_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4006 : box_shown_columns_values_2_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_576_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4009 : box_shown_columns_values_3_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_576_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4012 : box_shown_columns_values_4_q);
  logic [4:0] select_4016;
  assign select_4016 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4019;
  assign select_4019 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_576_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4021 : box_nearer_columns_values_1_q);
  logic [2:0] select_4024;
  assign select_4024 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4026;
  assign select_4026 = equal_576_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4024 : box_nearer_columns_values_2_q);
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_576_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4027 : box_nearer_columns_values_3_q);
  logic [2:0] select_4030;
  assign select_4030 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4032;
  assign select_4032 = equal_576_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4030 : box_nearer_columns_values_4_q);
  logic [4:0] select_4034;
  assign select_4034 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1317
  logic [1:0] select_4124;
  assign select_4124 = and_4123_s3_q ? {and_2132, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:442
  logic select_4128;
  assign select_4128 = and_2057_s3_q ? (less_2058_s3_q ? (select_4124[0] & and_4125_s3_q) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4130;
  assign select_4130 = left_first_s3_q ? select_4128 : (and_1974_s3_q ? select_4128 : seen_q);
  logic select_4131;
  assign select_4131 = and_1974_s3_q ? select_4130 : seen_q;
  // hls/stages/agreement.hpp:442
  logic select_4134;
  assign select_4134 = and_2057_s3_q ? (less_2058_s3_q ? (select_4124[1] & and_4125_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4136;
  assign select_4136 = left_first_s3_q ? select_4134 : (and_1974_s3_q ? select_4134 : nearer_q);
  logic select_4137;
  assign select_4137 = and_1974_s3_q ? select_4136 : nearer_q;
  // hls/stages/agreement.hpp:1247
  logic or_4144;
  assign or_4144 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4143_s3_q;
  // hls/stages/agreement.hpp:1249
  logic not_4152;
  assign not_4152 = ~(or_3882 | not_2356);
  // hls/stages/agreement.hpp:795
  logic and_4156;
  assign and_4156 = equal_576_s3_q & (equal_3901_s3_q & (not_4152 & (select_3890 | select_3956)));
  logic and_4159;
  assign and_4159 = equal_3901_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1158
  logic or_4163;
  assign or_4163 = select_2454 | (select_2466 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:795
  logic and_4170;
  assign and_4170 = equal_576_s3_q & (equal_3901_s3_q & (not_4152 & (select_2460 | select_2472)));
  // hls/stages/agreement.hpp:1158
  logic and_4175;
  assign and_4175 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3919 < cfg_hidden_frames_i));
  logic select_4181;
  assign select_4181 = (not_2356 | (select_3962 & not_3794)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:795
  logic and_4186;
  assign and_4186 = equal_576_s3_q & (equal_3901_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4190;
  assign and_4190 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1148
  logic [31:0] select_4198;
  assign select_4198 = equal_1635_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4196_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4199;
  assign select_4199 = equal_1633_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4198;
  logic [31:0] select_4200;
  assign select_4200 = equal_1631_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4199;
  logic [31:0] select_4201;
  assign select_4201 = equal_1629_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4200;
  logic [31:0] select_4202;
  assign select_4202 = equal_1627_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4201;
  logic [31:0] select_4203;
  assign select_4203 = equal_1625_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4202;
  logic [31:0] select_4204;
  assign select_4204 = equal_1623_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4203;
  logic [31:0] select_4205;
  assign select_4205 = equal_1621_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4204;
  // hls/stages/agreement.hpp:1146
  logic [9:0] select_4206;
  assign select_4206 = less_2660 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1150
  logic [31:0] select_4207;
  assign select_4207 = equal_1613_s3_q ? select_4205 : {2'h0, select_4206, select_2664, select_2661};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_551_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_751_s3_q, and_750, less_745_s3_q, and_744_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_738, and_714_s3_q, and_713_s3_q, and_688_s3_q, less_680_s3_q, less_679_s3_q, less_678_s3_q, less_677_s3_q, less_676_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q};
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
  assign registration_sums_waddr = {sum_1619_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1678_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1677, sum_1673};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1704_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1781_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1753_s3_q};
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
  assign patches_right_0_waddr = {select_1812_s3_q, select_1809};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1821);
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
  assign patches_right_1_waddr = {select_1812_s3_q, select_1837};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1840);
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
  assign patches_left_waddr = {select_1859, select_1858_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1865);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1981;
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
  assign regions_waddr = {region_row_s3_q, or_1991_s3_q, or_1988_s3_q, or_1985_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2025_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2024, sum_2014, sum_2009};
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
  assign map_waddr = sum_2067_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2143_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2132, is_seen};
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
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2295;
      sharpness_before_last_mask_q <= select_2368;
      sharpness_sums_detail_0_q <= and_551_s3_q ? select_2382 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_551_s3_q ? select_2394 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_551_s3_q ? sum_2398 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_551_s3_q ? sum_2402 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2420 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2430 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2432 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2434 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2436 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2438 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2443;
      sharpness_comparing_carry_1_q <= select_2447;
      sharpness_comparing_less_detail_0_q <= select_2454;
      sharpness_comparing_less_detail_1_q <= select_2460;
      sharpness_comparing_less_contrast_0_q <= select_2466;
      sharpness_comparing_less_contrast_1_q <= select_2472;
      counts_supervised_q <= select_2618;
      counts_textured_q <= and_2610_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2621});
      counts_explained_q <= and_2610_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2626});
      counts_nearer_q <= and_2610_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2631});
      counts_unproven_q <= and_2610_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2657});
      counts_regions_bad_q <= select_2673;
      counts_skin_supervised_q <= select_2680;
      counts_skin_textured_q <= select_2687;
      counts_skin_unproven_q <= select_2695;
      counts_on_skin_q <= select_2714;
      registration_half_across_q <= select_2793;
      registration_half_measured_q <= select_2798;
      registration_half_votes_down_q <= and_2771_s3_q ? 7'h0 : sum_2804;
      registration_half_votes_up_q <= and_2771_s3_q ? 7'h0 : sum_2812;
      registration_half_half_votes_down_q <= and_2771_s3_q ? 7'h0 : sum_2819;
      registration_half_half_votes_up_q <= and_2771_s3_q ? 7'h0 : sum_2826;
      registration_down_q <= and_2859 ? sum_2878 : registration_down_q;
      registration_up_q <= and_2859 ? sum_2887 : registration_up_q;
      registration_enough_q <= select_2901;
      registration_votes_down_q <= and_2906 ? less_2907 : registration_votes_down_q;
      registration_votes_up_q <= and_2906 ? less_2909 : registration_votes_up_q;
      registration_other_enough_q <= and_2915 ? select_2901 : registration_other_enough_q;
      registration_other_down_q <= and_2915 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2915 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_576_s3_q & and_2922)) & or_2947;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1800 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1803 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1804 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3030;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1829 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1831 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1832 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3035;
      patches_valid_0_q <= select_3040;
      patches_valid_1_q <= select_3045;
      patches_right_next_0_q <= select_3048;
      patches_right_next_1_q <= select_3051;
      patches_left_next_0_q <= select_3054;
      patches_left_next_1_q <= select_3057;
      patches_sums_values_0_q <= select_3481;
      patches_sums_values_1_q <= equal_1782_s3_q ? patches_sums_values_1_q : select_3482;
      patches_sums_values_2_q <= equal_1782_s3_q ? patches_sums_values_2_q : select_3484;
      patches_sums_values_3_q <= equal_1782_s3_q ? patches_sums_values_3_q : select_3486;
      patches_sums_values_4_q <= equal_1782_s3_q ? patches_sums_values_4_q : select_3488;
      patches_sums_values_5_q <= equal_1782_s3_q ? patches_sums_values_5_q : select_3490;
      patches_sums_values_6_q <= equal_1782_s3_q ? patches_sums_values_6_q : select_3492;
      patches_sums_values_7_q <= equal_1782_s3_q ? patches_sums_values_7_q : select_3494;
      patches_sums_values_8_q <= equal_1782_s3_q ? patches_sums_values_8_q : select_3496;
      patches_sums_values_9_q <= equal_1782_s3_q ? patches_sums_values_9_q : select_3498;
      patches_sums_values_10_q <= equal_1782_s3_q ? patches_sums_values_10_q : select_3500;
      patches_sums_values_11_q <= equal_1782_s3_q ? patches_sums_values_11_q : select_3502;
      patches_sums_values_12_q <= equal_1782_s3_q ? patches_sums_values_12_q : select_3504;
      patches_sums_values_13_q <= equal_1782_s3_q ? patches_sums_values_13_q : select_3506;
      patches_sums_values_14_q <= equal_1782_s3_q ? patches_sums_values_14_q : select_3508;
      patches_sums_values_15_q <= equal_1782_s3_q ? patches_sums_values_15_q : select_3510;
      patches_sums_values_16_q <= equal_1782_s3_q ? patches_sums_values_16_q : select_3512;
      patches_best_differing_q <= select_1981[9:0];
      patches_best_column_q <= select_1981[14:10];
      patches_quarters_0_places_q <= sum_3599;
      patches_quarters_0_up_q <= sum_3634;
      patches_quarters_0_down_q <= sum_3639;
      patches_quarters_1_places_q <= sum_3643;
      patches_quarters_1_up_q <= sum_3646;
      patches_quarters_1_down_q <= sum_3649;
      patches_quarters_2_places_q <= sum_3653;
      patches_quarters_2_up_q <= sum_3656;
      patches_quarters_2_down_q <= sum_3659;
      patches_quarters_3_places_q <= sum_3663;
      patches_quarters_3_up_q <= sum_3666;
      patches_quarters_3_down_q <= sum_3669;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_3697;
      patches_word_up_q <= ((select_3707 | select_3709) | select_3712) | select_3715;
      patches_word_down_q <= ((select_3718 | select_3720) | select_3723) | select_3726;
      patches_sum_places_q <= select_3736;
      patches_sum_up_q <= select_3739;
      patches_sum_down_q <= select_3742;
      patches_across_q <= select_3749;
      patches_places_q <= select_3760;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3764;
      patches_partly_q <= or_3767;
      patches_clear_limit_q <= sum_3768[8:2];
      patches_complete_q <= select_3770;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3753 ? select_3775 : patches_found_q;
      patches_doubted_q <= select_3782;
      patches_doubted_before_q <= select_3783;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3787;
      patches_on_skin_q <= sum_3792;
      patches_large_q <= not_3794 & and_3799;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3804;
      patches_spoiled_q <= or_3808;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3815;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3825;
      segment_textured_q <= select_2006 + {5'h0, and_2621};
      segment_explained_q <= select_2011 + {5'h0, and_2626};
      segment_nearer_q <= select_2021 + {5'h0, and_2631};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_576_s3_q ? select_3898 : good_q;
      good_known_q <= select_3903;
      hidden_for_q <= select_3921;
      product_q <= equal_576_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3946;
      disagree_q <= equal_576_s3_q ? select_3890 : disagree_q;
      too_much_q <= equal_576_s3_q ? select_3956 : too_much_q;
      hides_q <= equal_576_s3_q ? select_3916 : hides_q;
      overlooks_q <= equal_576_s3_q ? select_3962 : overlooks_q;
      seen_q <= select_4131;
      nearer_q <= select_4137;
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
      averager_quarter_1_0_q <= select_2169;
      averager_quarter_1_1_q <= select_2171;
      averager_quarter_2_0_q <= select_2173;
      averager_quarter_2_1_q <= select_2175;
      averager_detail_0_q <= select_2187;
      averager_detail_1_q <= select_2195;
      census_changes_values_0_left_q <= and_551_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_551_s3_q ? sum_2279 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2281;
      census_changes_values_1_right_q <= select_2282;
      census_changes_values_2_left_q <= select_2283;
      census_changes_values_2_right_q <= select_2284;
      sharpness_last_mask_q <= and_551_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_551_s3_q ? select_2365[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_551_s3_q ? select_2365[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3966;
      box_textured_columns_values_1_q <= select_3969;
      box_textured_columns_values_2_q <= select_3972;
      box_textured_columns_values_3_q <= select_3975;
      box_textured_columns_values_4_q <= select_3978;
      box_textured_sum_sums_values_0_q <= equal_576_s3_q ? box_textured_sum_sums_values_0_q : select_3980;
      box_explained_columns_values_0_q <= select_3984;
      box_explained_columns_values_1_q <= select_3987;
      box_explained_columns_values_2_q <= select_3990;
      box_explained_columns_values_3_q <= select_3993;
      box_explained_columns_values_4_q <= select_3996;
      box_explained_sum_sums_values_0_q <= equal_576_s3_q ? box_explained_sum_sums_values_0_q : select_3998;
      box_shown_columns_values_0_q <= equal_576_s3_q ? box_shown_columns_values_0_q : select_4001;
      box_shown_columns_values_1_q <= select_4005;
      box_shown_columns_values_2_q <= select_4008;
      box_shown_columns_values_3_q <= select_4011;
      box_shown_columns_values_4_q <= select_4014;
      box_shown_sum_sums_values_0_q <= equal_576_s3_q ? box_shown_sum_sums_values_0_q : select_4016;
      box_nearer_columns_values_0_q <= equal_576_s3_q ? box_nearer_columns_values_0_q : select_4019;
      box_nearer_columns_values_1_q <= select_4023;
      box_nearer_columns_values_2_q <= select_4026;
      box_nearer_columns_values_3_q <= select_4029;
      box_nearer_columns_values_4_q <= select_4032;
      box_nearer_sum_sums_values_0_q <= equal_576_s3_q ? box_nearer_sum_sums_values_0_q : select_4034;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4075_s4_q;
  logic or_4138_s4_q;
  logic and_4139_s4_q;
  logic and_4147_s4_q;
  logic and_4150_s4_q;
  logic and_4156_s4_q;
  logic and_4160_s4_q;
  logic and_4166_s4_q;
  logic and_4170_s4_q;
  logic and_4178_s4_q;
  logic and_4183_s4_q;
  logic and_4186_s4_q;
  logic and_4190_s4_q;
  logic [5:0] select_4192_s4_q;
  logic [31:0] select_4209_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4075_s4_q <= and_4075_s3_q;
      or_4138_s4_q <= not_2356 | select_4131;
      and_4139_s4_q <= cfg_prove_i & select_4137;
      and_4147_s4_q <= equal_576_s3_q & (equal_3901_s3_q & (cfg_prove_i & or_4144));
      and_4150_s4_q <= equal_576_s3_q & (equal_3901_s3_q & (cfg_prove_i & or_3882));
      and_4156_s4_q <= and_4156;
      and_4160_s4_q <= equal_576_s3_q & and_4159;
      and_4166_s4_q <= equal_576_s3_q & (equal_3901_s3_q & (not_4152 & or_4163));
      and_4170_s4_q <= and_4170;
      and_4178_s4_q <= equal_576_s3_q & (equal_3901_s3_q & (cfg_prove_i & and_4175));
      and_4183_s4_q <= equal_576_s3_q & (equal_3901_s3_q & select_4181);
      and_4186_s4_q <= and_4186;
      and_4190_s4_q <= and_4190;
      select_4192_s4_q <= equal_576_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4209_s4_q <= equal_576_s3_q ? (x_s3_q[6] ? select_4207 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4138_s4_q;
  assign marks_nearer_o = and_4139_s4_q;
  assign verdict_valid_o = and_4075_s4_q;
  assign verdict_unproven_yet_o = and_4147_s4_q;
  assign verdict_untextured_o = and_4150_s4_q;
  assign verdict_disagree_o = and_4156_s4_q;
  assign verdict_moved_o = and_4160_s4_q;
  assign verdict_unsharp_left_o = and_4166_s4_q;
  assign verdict_unsharp_right_o = and_4170_s4_q;
  assign verdict_hidden_o = and_4178_s4_q;
  assign verdict_overlooked_o = and_4183_s4_q;
  assign verdict_out_of_step_o = and_4186_s4_q;
  assign frame_valid_o = and_4190_s4_q;
  assign frame_index_o = select_4192_s4_q;
  assign frame_word_o = select_4209_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3797[4:0], sum_3768[1:0], sum_3728[1:0], product_3629[4:0], sum_2761[0], difference_2701[1:0], detail_4[1:0], detail_3[1:0], sum_2289[4:0], sum_1720[0], sum_1716[0], sum_736[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
