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
  logic not_2360;
  assign not_2360 = ~cfg_prove_i;
  logic [5:0] sum_2573;
  assign sum_2573 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_2578;
  assign less_2578 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_3611;
  assign difference_3611 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3804;
  assign not_3804 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3841;
  assign difference_3841 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4113;
  assign sum_4113 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4114;
  assign select_4114 = (6'h4 < cfg_height_i[8:3]) ? {sum_4113, cfg_height_i[4:3]} : 8'h0;

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
  // hls/stages/agreement.hpp:423
  logic and_524;
  assign and_524 = select_521 & (select_512[0] & or_522);
  // hls/stages/census.hpp:42
  logic [2:0] select_529;
  assign select_529 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_545;
  assign select_545 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
  logic and_551;
  assign and_551 = sample_pair_whole_q & (equal_547 & and_549);
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:633
  logic equal_580;
  assign equal_580 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:604
  logic or_581;
  assign or_581 = so | equal_580;
  // hls/stages/agreement.hpp:602
  logic [7:0] sum_582;
  assign sum_582 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:604
  logic [7:0] select_583;
  assign select_583 = run_shift_q[5] ? x_q : sum_582;
  logic less_584;
  assign less_584 = {2'h0, last_q} < select_583;
  // hls/stages/agreement.hpp:227
  logic not_585;
  assign not_585 = ~less_584;
  // hls/stages/agreement.hpp:624
  logic equal_595;
  assign equal_595 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:625
  logic equal_596;
  assign equal_596 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:150
  logic and_597;
  assign and_597 = equal_596 & not_585;
  logic select_599;
  assign select_599 = or_581 ? not_585 : (equal_595 ? not_585 : and_597);
  // hls/stages/agreement.hpp:808
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:806
  logic [6:0] sum_614;
  assign sum_614 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:150
  logic and_619;
  assign and_619 = equal_595 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_614} < select_583))));
  logic select_620;
  assign select_620 = or_581 ? not_585 : and_619;
  // hls/stages/agreement.hpp:831
  logic [5:0] right;
  assign right = sum_582[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:730
  logic not_652;
  assign not_652 = ~or_581;
  // hls/stages/agreement.hpp:150
  logic and_655;
  assign and_655 = not_652 & ((~equal_595) & and_597);
  // hls/stages/census.hpp:42
  logic [5:0] select_682;
  assign select_682 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:276
  logic and_1826;
  assign and_1826 = not_1783 & (not_1785 & (or_1788 & (patches_second_q & equal_1787)));
  // hls/stages/patches.hpp:168
  logic not_1842;
  assign not_1842 = ~equal_1787;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1858;
  assign select_1858 = row_starts ? {select_1811[4], select_1811[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_1868;
  assign and_1868 = not_1783 & (or_1788 & not_1785);
  // hls/stages/agreement.hpp:191
  logic and_1974;
  assign and_1974 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2150;
  assign select_2150 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_512 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2153;
  assign select_2153 = sample_pair_whole_q ? (sample_last_q ? (select_529 + 3'h1) : select_529) : raster_at_y_q;
  logic [5:0] select_2156;
  assign select_2156 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_545 + {5'h0, equal_547})) : raster_at_column_q;
  logic [5:0] select_2159;
  assign select_2159 = sample_pair_whole_q ? (sample_last_q ? (select_682 + {5'h0, equal_548}) : select_682) : raster_at_row_q;
  logic select_2163;
  assign select_2163 = sample_pair_whole_q ? (sample_last_q ? (or_522 & (~raster_final_row_q)) : or_522) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2165;
  assign select_2165 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2169;
  assign select_2169 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] sum_2478;
  assign sum_2478 = {1'b0, last} + 7'h1;
  logic equal_2479;
  assign equal_2479 = {sum_2478[6], cfg_width_i[8:3]} == {1'b0, sum_2478[5:0]};
  // hls/stages/agreement.hpp:469
  logic and_2480;
  assign and_2480 = and_551 & equal_2479;
  // hls/stages/agreement.hpp:533
  logic select_2483;
  assign select_2483 = (and_2480 | (~ends_cell_q)) ? and_2480 : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2483 ? (and_2480 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2487;
  assign select_2487 = select_2483 ? (and_2480 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2490;
  assign select_2490 = select_2483 ? (following_last_shift_q & (~and_2480)) : run_last_shift_q;
  // hls/stages/agreement.hpp:617
  logic and_2493;
  assign and_2493 = run_last_shift_q & equal_595;
  // hls/stages/agreement.hpp:626
  logic select_2495;
  assign select_2495 = equal_595 ? (~run_last_shift_q) : equal_596;
  // hls/stages/agreement.hpp:630
  logic equal_2496;
  assign equal_2496 = run_phase_q == 3'h1;
  logic not_2499;
  assign not_2499 = ~select_2495;
  // hls/stages/agreement.hpp:633
  logic equal_2501;
  assign equal_2501 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2502;
  assign and_2502 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2503;
  assign select_2503 = equal_2501 ? 2'h1 : {2{and_2502}};
  logic [2:0] select_2505;
  assign select_2505 = (and_2493 | (select_2495 | equal_2496)) ? (equal_2496 ? 3'h2 : {not_2499, {2{select_2495}}}) : (equal_580 ? 3'h6 : {select_2503[0], select_2503});
  // hls/stages/agreement.hpp:617
  logic and_2508;
  assign and_2508 = select_2495 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2511;
  assign select_2511 = (plan_shift_q[5] & select_2495) ? value : 7'h0;
  logic [1:0] or_2512;
  assign or_2512 = {2{so}} | select_2511[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] select_2513;
  assign select_2513 = select_2495 ? plan_columns_q : 8'h0;
  logic [6:0] or_2516;
  assign or_2516 = select_2513[6:0] | ((equal_2496 | equal_2501) ? whole_q : 7'h0);
  logic [1:0] or_2517;
  assign or_2517 = {2{and_2493}} | or_2516[3:2];
  // hls/stages/agreement.hpp:644
  logic [6:0] or_2519;
  assign or_2519 = {or_2516[6:4], or_2517, or_2516[1:0]} | (equal_580 ? drawn_q : 7'h0);
  logic [4:0] or_2520;
  assign or_2520 = {5{so}} | {or_2519[6], or_2519[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2524;
  assign not_2524 = ~run_shift_q[5];
  logic [6:0] difference_2526;
  assign difference_2526 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2527;
  assign select_2527 = equal_595 ? ({{7{not_2524}}, 1'b1} + run_span_q) : {difference_2526[6], difference_2526};
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2531;
  assign select_2531 = and_2480 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2533;
  assign select_2533 = select_2483 ? {select_2531[6], select_2531} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2536;
  assign select_2536 = select_2483 ? (and_2480 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:530
  logic [5:0] select_2544;
  assign select_2544 = and_551 ? (equal_2479 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2545;
  assign sum_2545 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2547;
  assign select_2547 = and_551 ? (equal_2479 ? {sum_2545, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [4:0] sum_2548;
  assign sum_2548 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2550;
  assign select_2550 = and_551 ? (equal_2479 ? {sum_2548, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_2564;
  assign select_2564 = (ends_cell_q | select_2483) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_595 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_2568;
  assign and_2568 = (~select_2483) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_2569;
  assign sum_2569 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_2571;
  assign select_2571 = equal_2479 ? ({sum_2569[6], cfg_height_i[8:3]} == {1'b0, sum_2569[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2963;
  assign select_2963 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2964;
  assign select_2964 = sample_pair_whole_q ? select_2963 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_2965;
  assign and_2965 = not_1682 & equal_1684;
  logic [8:0] select_2966;
  assign select_2966 = and_2965 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2967;
  assign select_2967 = and_2965 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2968;
  assign select_2968 = sample_pair_first_q ? select_2966 : select_2967;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2970;
  assign select_2970 = sample_pair_whole_q ? (row_starts ? select_2968[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2972;
  assign select_2972 = sample_pair_whole_q ? (row_starts ? select_2968[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2975;
  assign select_2975 = sample_pair_whole_q ? (equal_1686 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2977;
  assign select_2977 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1686}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2978;
  assign equal_2978 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_2979;
  assign not_2979 = ~equal_2978;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2981;
  assign select_2981 = sample_pair_whole_q ? (phase + {not_2979, 1'b1, not_2979, equal_2978}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_2983;
  assign equal_2983 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2987;
  assign select_2987 = equal_2983 ? ((select_2964 == 4'h6) ? 4'h0 : (select_2964 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2988;
  assign equal_2988 = select_2987 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_2991;
  assign select_2991 = equal_2479 ? (equal_2988 ? 4'h6 : (select_2987 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2993;
  assign select_2993 = equal_2983 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_2995;
  assign select_2995 = equal_2479 ? (select_2993 + {4'h0, equal_2988}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:530
  logic select_3000;
  assign select_3000 = and_551 ? (equal_2479 ? ((6'h2 < row) & equal_2988) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3002;
  assign select_3002 = and_551 ? (equal_2479 ? select_2993 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3025;
  assign sum_3025 = {1'b0, select_682[5:1]} + 6'h1;
  logic less_3026;
  assign less_3026 = {sum_3025, select_682[0], select_529, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3029;
  assign select_3029 = row_starts ? (and_1691 ? (~less_3026) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3068;
  assign or_3068 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3073;
  assign select_3073 = (patches_second_q | patches_begins_q) ? not_1679 : (patches_ends_q & equal_1782);
  logic and_3074;
  assign and_3074 = equal_1782 & not_1789;
  // hls/stages/patches.hpp:403
  logic and_3075;
  assign and_3075 = not_1842 & and_3074;
  logic [1:0] select_3077;
  assign select_3077 = equal_1784 ? 2'h0 : (equal_1786 ? 2'h3 : {equal_1787, and_3075});
  // hls/stages/patches.hpp:283
  logic equal_3079;
  assign equal_3079 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3080;
  assign not_3080 = ~equal_3079;
  // hls/stages/patches.hpp:283
  logic equal_3081;
  assign equal_3081 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3082;
  assign not_3082 = ~equal_3081;
  // hls/stages/patches.hpp:287
  logic not_3084;
  assign not_3084 = ~(patches_following_q == 3'h2);
  logic and_3087;
  assign and_3087 = (~(patches_following_q == 3'h1)) & not_3084;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3088;
  assign select_3088 = equal_3081 ? 2'h2 : {and_3087, not_3084};
  logic [3:0] select_3089;
  assign select_3089 = equal_3079 ? 4'h2 : {select_3088, {2{not_3082}}};
  // hls/stages/patches.hpp:409
  logic not_3092;
  assign not_3092 = ~or_3068;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3097;
  assign select_3097 = or_3068 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3099;
  assign select_3099 = or_3068 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1386; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1387; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1388; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1389; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
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
      raster_at_x_q <= select_2150;
      raster_at_y_q <= select_2153;
      raster_at_column_q <= select_2156;
      raster_at_row_q <= select_2159;
      raster_at_live_q <= select_2163;
      raster_rows_left_q <= sample_pair_whole_q ? select_2165 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2169;
      averager_place_q <= sample_pair_whole_q ? select_516 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_521 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2487;
      run_last_shift_q <= select_2490;
      run_span_q <= select_2483 ? (and_2480 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2505;
      following_shift_q <= select_2495 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2508;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2511[6], or_2512, select_2511[3:0]};
      following_columns_q <= {select_2513[7], or_2520[4], or_2519[5:4], or_2520[3:0]};
      plan_shift_q <= equal_595 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2527;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2533;
      columns_left_q <= select_2536;
      last_q <= and_551 ? (equal_2479 ? last : last_q) : last_q;
      least_q <= select_2544;
      whole_q <= select_2547;
      drawn_q <= select_2550;
      age_q <= select_2483 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2483 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2564;
      ends_q <= and_2568;
      final_row_q <= and_551 ? select_2571 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2964;
      patches_band_rows_rows_to_next_q <= select_2970;
      patches_band_rows_number_q <= select_2972;
      patches_next_band_rows_to_next_q <= select_2975;
      patches_next_band_number_q <= select_2977;
      patches_first_band_rows_to_next_q <= select_2981;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2978 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_551 ? select_2991 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_551 ? select_2995 : patches_choosing_number_q;
      patches_chooses_q <= select_3000;
      patches_choosing_band_q <= select_3002;
      patches_capturing_q <= sample_pair_whole_q ? select_1818 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3029 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1812 : patches_row_q;
      patches_work_q <= or_3068 ? following : patches_work_q;
      patches_second_q <= select_3073;
      patches_following_q <= equal_1782 ? {2'h0, and_3074} : {equal_1784, select_3077};
      patches_following_beats_q <= {select_3089, not_3080};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1814);
      patches_ends_q <= not_3092 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3097;
      patches_code_row_q <= select_3099;
      patches_column_q <= or_3068 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3092 & (patches_column_q == 5'h1e);
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
  logic equal_2479_s1_q;
  logic and_2480_s1_q;
  logic or_3068_s1_q;
  logic not_3092_s1_q;
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
      equal_2479_s1_q <= equal_2479;
      and_2480_s1_q <= and_2480;
      or_3068_s1_q <= or_3068;
      not_3092_s1_q <= not_3092;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic late_q;
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
  // hls/stages/agreement.hpp:678
  logic equal_570;
  assign equal_570 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_571;
  assign equal_571 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_570 & equal_571;
  // hls/stages/moments.hpp:57
  logic [11:0] select_574;
  assign select_574 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:798
  logic [10:0] select_575;
  assign select_575 = first ? 11'h0 : select_574[10:0];
  // hls/stages/agreement.hpp:1019
  logic not_577;
  assign not_577 = ~equal_576_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_579;
  assign not_579 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_581_s1_q & not_585_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_574;
  // hls/stages/moments.hpp:104
  logic not_589;
  assign not_589 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:798
  logic and_593;
  assign and_593 = not_577 & (not_579 & (equal_580_s1_q & (inside_v & not_589)));
  // hls/stages/agreement.hpp:985
  logic and_610;
  assign and_610 = (or_581_s1_q & (left_rdata_q[67] & not_585_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:977
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:978
  logic [5:0] select_629;
  assign select_629 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:679
  logic or_753;
  assign or_753 = late_q | (~equal_570);
  // hls/stages/agreement.hpp:681
  logic and_754;
  assign and_754 = left_rdata_q[12] & or_753;
  logic and_755;
  assign and_755 = left_rdata_q[30] & or_753;
  logic and_756;
  assign and_756 = left_rdata_q[48] & or_753;
  logic and_757;
  assign and_757 = left_rdata_q[66] & or_753;
  // hls/stages/agreement.hpp:682
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
  // hls/stages/agreement.hpp:222
  logic and_768;
  assign and_768 = left_rdata_q[48] & not_585_s1_q;
  logic and_769;
  assign and_769 = right_codes_rdata_q[42] & not_585_s1_q;
  logic [11:0] select_770;
  assign select_770 = less_584_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_771;
  assign select_771 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_775;
  assign select_775 = and_768 ? (and_769 ? (~(select_770 ^ select_771)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_781;
  assign parity_781 = ^select_775[5:3];
  logic parity_784;
  assign parity_784 = ^select_775[8:6];
  logic parity_787;
  assign parity_787 = ^select_775[11:3];
  // hls/stages/agreement.hpp:222
  logic and_791;
  assign and_791 = left_rdata_q[66] & not_585_s1_q;
  logic and_792;
  assign and_792 = right_codes_rdata_q[57] & not_585_s1_q;
  logic [11:0] select_793;
  assign select_793 = less_584_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_794;
  assign select_794 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_798;
  assign select_798 = and_791 ? (and_792 ? (~(select_793 ^ select_794)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_801;
  assign parity_801 = ^select_798[8:6];
  logic parity_804;
  assign parity_804 = ^select_798[11:9];
  // hls/stages/agreement.hpp:222
  logic and_808;
  assign and_808 = left_rdata_q[84] & not_585_s1_q;
  logic and_809;
  assign and_809 = right_codes_rdata_q[72] & not_585_s1_q;
  logic [11:0] select_810;
  assign select_810 = less_584_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_811;
  assign select_811 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1012;
  assign select_1012 = equal_595_s1_q ? {and_1011, xor_1010, parity_1004, parity_983, xor_938, xor_843} : 6'h0;
  logic [5:0] column;
  assign column = or_581_s1_q ? 6'h0 : select_1012;
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:222
  logic and_1040;
  assign and_1040 = right_codes_rdata_q[85] & not_585_s1_q;
  logic [11:0] select_1042;
  assign select_1042 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1046;
  assign select_1046 = (slot_s1_q[0] ? and_1040 : and_809) ? (~(select_793 ^ (slot_s1_q[0] ? select_1042 : select_811))) : 12'h0;
  logic [11:0] select_1047;
  assign select_1047 = and_791 ? select_1046 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1050;
  assign parity_1050 = ^select_1047[8:6];
  logic parity_1053;
  assign parity_1053 = ^select_1047[11:9];
  // hls/stages/agreement.hpp:744
  logic select_1058;
  assign select_1058 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_585_s1_q) : and_1040;
  logic [11:0] select_1060;
  assign select_1060 = slot_s1_q[0] ? (less_584_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1042;
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1261;
  assign select_1261 = equal_595_s1_q ? {and_1260, xor_1259, parity_1253, parity_1232, xor_1187, xor_1092} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_581_s1_q ? 6'h0 : select_1261;
  // hls/stages/agreement.hpp:222
  logic and_1269;
  assign and_1269 = right_codes_rdata_q[27] & not_585_s1_q;
  // hls/stages/agreement.hpp:744
  logic select_1270;
  assign select_1270 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_585_s1_q) : and_1269;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1272;
  assign select_1272 = less_584_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:744
  logic [11:0] select_1273;
  assign select_1273 = slot_s1_q[0] ? (less_584_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1272;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1277;
  assign select_1277 = and_768 ? (select_1270 ? (~(select_770 ^ select_1273)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1283;
  assign parity_1283 = ^select_1277[5:3];
  logic parity_1286;
  assign parity_1286 = ^select_1277[8:6];
  logic parity_1289;
  assign parity_1289 = ^select_1277[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1297;
  assign select_1297 = (slot_s1_q[0] ? and_1269 : and_769) ? (~(select_793 ^ (slot_s1_q[0] ? select_1272 : select_771))) : 12'h0;
  logic [11:0] select_1298;
  assign select_1298 = and_791 ? select_1297 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1301;
  assign parity_1301 = ^select_1298[8:6];
  logic parity_1304;
  assign parity_1304 = ^select_1298[11:9];
  // hls/stages/agreement.hpp:694
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
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1510;
  assign select_1510 = equal_595_s1_q ? {and_1509, xor_1508, parity_1502, parity_1481, xor_1436, xor_1341} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_581_s1_q ? 6'h0 : select_1510;
  // hls/stages/agreement.hpp:798
  logic and_1578;
  assign and_1578 = ends_cell_s1_q & inside_v;
  logic and_1580;
  assign and_1580 = not_577 & (so_s1_q & and_1578);
  logic [5:0] select_1584;
  assign select_1584 = so_s1_q ? x_s1_q[5:0] : (or_581_s1_q ? (less_584_s1_q ? 6'h0 : select_629) : 6'h0);
  // hls/stages/agreement.hpp:248
  logic or_1588;
  assign or_1588 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
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
  // hls/stages/agreement.hpp:276
  logic and_1946;
  assign and_1946 = not_1785_s1_q & (or_1788_s1_q & (or_1937 & (equal_1787_s1_q & and_1942)));
  // hls/stages/patches.hpp:174
  logic and_1956;
  assign and_1956 = (~(equal_1787_s1_q | (~and_1942))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
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
  // hls/stages/agreement.hpp:1286
  logic not_2055;
  assign not_2055 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:465
  logic select_2576;
  assign select_2576 = equal_2479_s1_q ? (~({row_s1_q, 1'b0} < {sum_2573, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_2579;
  assign and_2579 = proven_q & less_2578;
  // hls/stages/agreement.hpp:530
  logic select_2583;
  assign select_2583 = and_551_s1_q ? (equal_2479_s1_q ? (and_2579 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_2584;
  assign equal_2584 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_2585;
  assign and_2585 = and_2579 & equal_2584;
  // hls/stages/agreement.hpp:530
  logic and_2853;
  assign and_2853 = and_551_s1_q & (equal_2479_s1_q & equal_2584);
  // hls/stages/registration.hpp:128
  logic and_2854;
  assign and_2854 = and_2480_s1_q & and_2853;
  // hls/stages/registration.hpp:127
  logic and_2856;
  assign and_2856 = and_2480_s1_q & (~and_2853);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2857;
  assign select_2857 = and_2856 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2859;
  assign select_2859 = and_2854 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2857[15]}}, select_2857});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2860;
  assign select_2860 = and_2856 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2860[15]}}, select_2860};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2862;
  assign select_2862 = and_2854 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_2863;
  assign and_2863 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2863 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3107;
  assign select_3107 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3110;
  assign select_3110 = equal_1784_s1_q ? patches_smooth_values_0_q : (or_1788_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3112;
  assign select_3112 = or_1788_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3114;
  assign select_3114 = equal_1782_s1_q ? patches_smooth_values_1_q : (equal_1784_s1_q ? patches_smooth_values_1_q : select_3112);
  logic [11:0] select_3115;
  assign select_3115 = or_1788_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3117;
  assign select_3117 = equal_1782_s1_q ? patches_smooth_values_2_q : (equal_1784_s1_q ? patches_smooth_values_2_q : select_3115);
  logic [11:0] select_3118;
  assign select_3118 = or_1788_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3120;
  assign select_3120 = equal_1782_s1_q ? patches_smooth_values_3_q : (equal_1784_s1_q ? patches_smooth_values_3_q : select_3118);
  logic [10:0] select_3122;
  assign select_3122 = equal_1784_s1_q ? patches_down_values_0_q : (or_1788_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3125;
  assign select_3125 = equal_1784_s1_q ? patches_down_values_1_q : (or_1788_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3128;
  assign select_3128 = equal_1784_s1_q ? patches_down_values_2_q : (or_1788_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3131;
  assign select_3131 = equal_1784_s1_q ? patches_down_values_3_q : (or_1788_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3168;
  assign and_3168 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3173;
  assign select_3173 = or_3068_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3175;
  assign select_3175 = and_3168 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3531;
  assign select_3531 = equal_1782_s1_q ? patches_summed_down_by_q : (equal_1784_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3549;
  assign select_3549 = equal_1782_s1_q ? (less_1962 & (equal_1964 & or_1965)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3854;
  assign select_3854 = so_s1_q ? (and_2863 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3856;
  assign sum_3856 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3857;
  assign select_3857 = sum_1995[5] ? {1'b1, sum_1995[4:0], region_across_rest_q[2:0]} : sum_3856;
  // hls/stages/agreement.hpp:465
  logic [7:0] select_3859;
  assign select_3859 = equal_2479_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3862;
  assign select_3862 = equal_2479_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1159
  logic equal_3912;
  assign equal_3912 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:279
  logic and_4079;
  assign and_4079 = (~drew_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:1287
  logic select_4082;
  assign select_4082 = sample_pair_first_q ? done_q : proven_q;
  // hls/stages/agreement.hpp:279
  logic select_4084;
  assign select_4084 = sample_pair_first_q ? done_q : (sample_pair_whole_q ? select_4082 : proven_q);

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

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1390; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1391; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1419; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
      row_q <= and_551_s1_q ? (equal_2479_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_551_s1_q ? select_2576 : lower_half_q;
      late_q <= select_2583;
      registration_slope_row_q <= select_2859;
      registration_slope_change_q <= select_2862;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3092_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3092_s1_q & select_3107;
      patches_smooth_values_0_q <= equal_1782_s1_q ? patches_smooth_values_0_q : select_3110;
      patches_smooth_values_1_q <= select_3114;
      patches_smooth_values_2_q <= select_3117;
      patches_smooth_values_3_q <= select_3120;
      patches_down_values_0_q <= equal_1782_s1_q ? patches_down_values_0_q : select_3122;
      patches_down_values_1_q <= equal_1782_s1_q ? patches_down_values_1_q : select_3125;
      patches_down_values_2_q <= equal_1782_s1_q ? patches_down_values_2_q : select_3128;
      patches_down_values_3_q <= equal_1782_s1_q ? patches_down_values_3_q : select_3131;
      patches_down_by_q <= or_3068_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3168});
      patches_along_q <= select_3173;
      patches_match_row_q <= or_3068_s1_q ? 4'h0 : select_3175;
      patches_summed_last_q <= not_1783_s1_q & (equal_1784_s1_q & and_3168);
      patches_summed_down_by_q <= select_3531;
      patches_step_q <= or_3068_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3549;
      region_across_rest_q <= select_3854;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3857;
      columns_begin_rest_q <= and_551_s1_q ? select_3859 : columns_begin_rest_q;
      columns_begin_back_q <= and_551_s1_q ? select_3862 : columns_begin_back_q;
      done_q <= sample_pair_whole_q ? (not_2055 & and_4079) : and_4079;
      proven_q <= sample_pair_whole_q ? select_4084 : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_576_s1_q & equal_3912;
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
  logic and_2017_s2_q;
  logic not_2055_s2_q;
  logic less_2136_s2_q;
  logic equal_2290_s2_q;
  logic equal_2479_s2_q;
  logic and_2585_s2_q;
  logic and_2616_s2_q;
  logic equal_2705_s2_q;
  logic less_3144_s2_q;
  logic equal_3487_s2_q;
  logic equal_3584_s2_q;
  logic less_3840_s2_q;
  logic equal_3912_s2_q;
  logic or_4062_s2_q;
  logic and_4136_s2_q;
  logic not_4154_s2_q;
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
      and_2017_s2_q <= or_581_s1_q & (left_rdata_q[69] & not_585_s1_q);
      not_2055_s2_q <= not_2055;
      less_2136_s2_q <= 6'h6 < row_q;
      equal_2290_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2479_s2_q <= equal_2479_s1_q;
      and_2585_s2_q <= and_2585;
      and_2616_s2_q <= or_581_s1_q & (not_585_s1_q & and_610);
      equal_2705_s2_q <= shift == 6'h0;
      less_3144_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3487_s2_q <= patches_match_row_q == 4'h0;
      equal_3584_s2_q <= patches_step_q[6:5] == 2'h3;
      less_3840_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3912_s2_q <= equal_3912;
      or_4062_s2_q <= and_2585 | (~(row_s1_q[5:3] == 3'h0));
      and_4136_s2_q <= less_2578 & select_4082;
      not_4154_s2_q <= ~proven_q;
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
  logic draws_late_q;
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
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = select_512_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_540;
  assign and_540 = whole & (averager_memory_rdata_q[24] | equal_530_s2_q);
  // hls/stages/agreement.hpp:423
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
  // hls/stages/agreement.hpp:277
  logic [8:0] select_557;
  assign select_557 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_524_s2_q ? sum_536[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_554 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_561;
  assign select_561 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_562;
  assign and_562 = and_524_s2_q & and_540;
  // hls/stages/census.hpp:134
  logic select_564;
  assign select_564 = equal_554 ? and_562 : (averager_mask_q & and_562);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_564;
  // hls/stages/census.hpp:218
  logic and_566;
  assign and_566 = and_524_s2_q & and_544;
  // hls/stages/census.hpp:134
  logic select_568;
  assign select_568 = equal_554 ? and_566 : (averager_of_skin_q & and_566);
  // hls/stages/agreement.hpp:277
  logic and_569;
  assign and_569 = sample_pair_whole_s2_q & select_568;
  // hls/stages/agreement.hpp:988
  logic select_624;
  assign select_624 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_634;
  assign difference_634 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_635;
  assign sum_635 = {difference_634[8], difference_634} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_637;
  assign and_637 = (and_611_s2_q & select_624) & ({{22{sum_635[9]}}, sum_635} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_639;
  assign and_639 = or_581_s2_q & (not_585_s2_q & and_637);
  // hls/stages/agreement.hpp:263
  logic and_641;
  assign and_641 = and_639 & not_640_s2_q;
  // hls/stages/moments.hpp:77
  logic and_642;
  assign and_642 = and_602_s2_q & and_641;
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
  // hls/stages/agreement.hpp:460
  logic equal_681;
  assign equal_681 = last_s2_2_q == 6'h0;
  logic [3:0] select_685;
  assign select_685 = equal_684_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:461
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
  // hls/stages/agreement.hpp:817
  logic or_765;
  assign or_765 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:818
  logic select_767;
  assign select_767 = or_765 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1014;
  assign select_1014 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1015;
  assign difference_1015 = {1'b0, column_s2_q} - {1'b0, select_1014};
  logic [7:0] sum_1017;
  assign sum_1017 = {difference_1015[6], difference_1015} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_1018;
  assign select_1018 = slot_s2_q[0] ? chosen_score_q : sum_1017;
  // hls/stages/agreement.hpp:788
  logic [6:0] difference_1264;
  assign difference_1264 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1263_s2_q};
  // hls/stages/agreement.hpp:759
  logic equal_1265;
  assign equal_1265 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1267;
  assign sum_1267 = {difference_1264[6], difference_1264} + (equal_1265 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1513;
  assign difference_1513 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1512_s2_q};
  logic [7:0] sum_1515;
  assign sum_1515 = {difference_1513[6], difference_1513} + (equal_1265 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:761
  logic less_1516;
  assign less_1516 = sum_1267 < sum_1515;
  logic [7:0] select_1517;
  assign select_1517 = less_1516 ? sum_1515 : sum_1267;
  logic less_1518;
  assign less_1518 = select_1018 < select_1517;
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1518 ? select_1517 : select_1018) : 8'h0;
  // hls/stages/agreement.hpp:818
  logic or_1522;
  assign or_1522 = select_767 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:823
  logic [5:0] select_1523;
  assign select_1523 = or_1522 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:730
  logic not_1524;
  assign not_1524 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:762
  logic [1:0] select_1525;
  assign select_1525 = less_1516 ? {slot_s2_q[0], not_1524} : 2'h0;
  logic [2:0] select_1527;
  assign select_1527 = less_1518 ? {select_1525, not_1524} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:823
  logic [2:0] select_1528;
  assign select_1528 = or_1522 ? select_1527 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1529;
  assign select_1529 = or_1522 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:820
  logic equal_1530;
  assign equal_1530 = select_1527 == 3'h1;
  logic or_1533;
  assign or_1533 = equal_1530 | (~(select_1527 == 3'h2));
  logic [7:0] select_1535;
  assign select_1535 = or_1533 ? before_0_q : before_1_q;
  logic [7:0] select_1536;
  assign select_1536 = equal_1530 ? (or_1533 ? sum_1267 : {7'h0, shift_not_right_q}) : select_1535;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1537;
  assign select_1537 = or_1522 ? select_1536 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1540;
  assign select_1540 = or_1522 ? (equal_1530 ? select_1535 : (or_1533 ? sum_1515 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1542;
  assign sum_1542 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1543;
  assign sum_1543 = {1'b0, before_v} + sum_1542;
  // hls/stages/agreement.hpp:765
  logic [6:0] select_1544;
  assign select_1544 = slot_s2_q[0] ? chosen_near_q : sum_1543;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1546;
  assign sum_1546 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1547;
  assign sum_1547 = {1'b0, before_v_2} + sum_1546;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1549;
  assign sum_1549 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1550;
  assign sum_1550 = {1'b0, before_v_3} + sum_1549;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1552;
  assign select_1552 = (sum_1547 < sum_1550) ? sum_1550 : sum_1547;
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1544 < select_1552) ? select_1552 : select_1544) : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_1556;
  assign less_1556 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:827
  logic [6:0] select_1558;
  assign select_1558 = select_767 ? of_near : (less_1556 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1560;
  assign select_1560 = select_767 ? run_shift_s2_q : (less_1556 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1563;
  assign select_1563 = (run_shift_s2_q == 6'h3f) ? of_best : (select_767 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1566;
  assign select_1566 = (run_shift_s2_q == 6'h1) ? of_best : (select_767 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:833
  logic select_1569;
  assign select_1569 = or_765 ? shift_first_s2_q : equal_1568_s2_q;
  // hls/stages/agreement.hpp:834
  logic or_1571;
  assign or_1571 = select_1569 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:838
  logic [7:0] select_1572;
  assign select_1572 = or_1571 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1573;
  assign select_1573 = or_1571 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1575;
  assign or_1575 = select_1569 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:842
  logic [6:0] select_1576;
  assign select_1576 = or_1575 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1577;
  assign select_1577 = or_1575 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_1591;
  assign and_1591 = or_581_s2_q & (not_585_s2_q & (and_637 & or_1588_s2_q));
  // hls/stages/agreement.hpp:798
  logic and_1592;
  assign and_1592 = not_579_s2_q & and_1591;
  logic and_1595;
  assign and_1595 = not_577_s2_q & (drew_q ? and_1578_s2_q : (equal_580_s2_q & and_639));
  // hls/stages/moments.hpp:73
  logic and_1599;
  assign and_1599 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1013
  logic and_1600;
  assign and_1600 = not_589_s2_q & and_1599;
  logic and_1603;
  assign and_1603 = not_589_s2_q & (and_1599 & (moments_memory_rdata_q[1] ^ and_644_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1608;
  assign and_1608 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1013
  logic and_1609;
  assign and_1609 = not_589_s2_q & and_1608;
  logic and_1612;
  assign and_1612 = not_589_s2_q & (and_1608 & (moments_memory_rdata_q[3] ^ and_651_s2_q));
  // hls/stages/agreement.hpp:1140
  logic equal_1613;
  assign equal_1613 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1190
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1141
  logic [1:0] select_1616;
  assign select_1616 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1154
  logic [3:0] select_1618;
  assign select_1618 = equal_1613 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1616});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1619;
  assign sum_1619 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:1190
  logic and_1639;
  assign and_1639 = (~equal_1629) & ((~equal_1631) & ((~equal_1633) & (~equal_1635)));
  logic and_1643;
  assign and_1643 = (~equal_1621) & ((~equal_1623) & ((~equal_1625) & ((~equal_1627) & and_1639)));
  // hls/stages/agreement.hpp:1141
  logic less_1644;
  assign less_1644 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1648;
  assign or_1648 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1019
  logic [4:0] sum_1653;
  assign sum_1653 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:263
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
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:798
  logic and_1704;
  assign and_1704 = not_577_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1706;
  assign equal_1706 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
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
  // hls/stages/agreement.hpp:263
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
  // hls/stages/agreement.hpp:1028
  logic and_1744;
  assign and_1744 = ($signed(9'h0) < $signed(sum_1739[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1741, sum_1739[0]})));
  logic and_1745;
  assign and_1745 = (~(and_1733 | (equal_571_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1744;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1756;
  assign select_1756 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1758;
  assign select_1758 = and_1752 ? (equal_576_s2_q ? 8'h0 : select_1756) : patches_choice_column_q;
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1772;
  assign select_1772 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1774;
  assign select_1774 = and_1752 ? (equal_576_s2_q ? 8'h0 : select_1772) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1775;
  assign equal_1775 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:798
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
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1982;
  assign select_1982 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1061
  logic or_1985;
  assign or_1985 = select_1982[7] | (~({select_1982[5], select_1982[3], select_1982[1]} == 3'h0));
  // hls/stages/agreement.hpp:1060
  logic or_1988;
  assign or_1988 = select_1982[7] | (~({select_1982[6], select_1982[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1059
  logic or_1991;
  assign or_1991 = select_1982[7] | (~(select_1982[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1992;
  assign select_1992 = equal_576_s2_q ? x_s2_q[5:0] : {region_row_q, or_1991, or_1988, or_1985};
  // hls/stages/agreement.hpp:1140
  logic not_1993;
  assign not_1993 = ~equal_1613;
  // hls/stages/agreement.hpp:1069
  logic or_1997;
  assign or_1997 = (~sum_1995_s2_q) | equal_1775;
  // hls/stages/agreement.hpp:798
  logic and_2000;
  assign and_2000 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_1997));
  // hls/stages/agreement.hpp:150
  logic and_2004;
  assign and_2004 = or_581_s2_q & (not_585_s2_q & and_611_s2_q);
  logic and_2019;
  assign and_2019 = or_581_s2_q & (not_585_s2_q & and_2017_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2004;
  logic and_2030;
  assign and_2030 = inside_v_s2_q & and_2019;
  logic explained;
  assign explained = inside_v_s2_q & and_639;
  // hls/stages/agreement.hpp:1024
  logic select_2032;
  assign select_2032 = slot_s2_q[2] ? shown_shown_q : and_639;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2032);
  // hls/stages/agreement.hpp:1024
  logic select_2035;
  assign select_2035 = slot_s2_q[2] ? shown_nearer_q : and_1591;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2032 ? select_2035 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1283
  logic select_2038;
  assign select_2038 = done_s2_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1287
  logic select_2039;
  assign select_2039 = left_first_s2_q ? select_2038 : read_half_q;
  logic or_2040;
  assign or_2040 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1288
  logic [8:0] select_2041;
  assign select_2041 = or_2040 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1289
  logic [9:0] select_2043;
  assign select_2043 = left_first_s2_q ? 10'h1 : (or_2040 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1292
  logic and_2044;
  assign and_2044 = select_2041[8] & select_2043[9];
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = and_2044 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1303
  logic [5:0] select_2047;
  assign select_2047 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2049;
  assign select_2049 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2047});
  // hls/stages/agreement.hpp:1314
  logic equal_2050;
  assign equal_2050 = seen_x_q == 3'h7;
  logic [7:0] select_2052;
  assign select_2052 = and_2044 ? 8'h0 : (seen_column_q + {7'h0, equal_2050});
  // hls/stages/agreement.hpp:1321
  logic [10:0] index;
  assign index = select_2049 + {3'h0, select_2052};
  // hls/stages/agreement.hpp:1273
  logic [11:0] sum_2054;
  assign sum_2054 = {1'b0, {2{select_2039}}, 2'h0, {2{select_2039}}, 1'b0, {2{select_2039}}, 1'b0, select_2039} + {1'b0, index};
  // hls/stages/agreement.hpp:441
  logic and_2057;
  assign and_2057 = not_2055_s2_q & (began_q | and_2044);
  // hls/stages/agreement.hpp:1315
  logic [2:0] select_2059;
  assign select_2059 = and_2044 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1320
  logic and_2061;
  assign and_2061 = and_2057 & (select_2059 == 3'h0);
  logic less_2062;
  assign less_2062 = select_2052 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:443
  logic and_2063;
  assign and_2063 = and_2061 & less_2062;
  logic and_2064;
  assign and_2064 = and_1974_s2_q & and_2063;
  // hls/stages/agreement.hpp:279
  logic select_2066;
  assign select_2066 = and_1974_s2_q ? (left_first_s2_q ? and_2063 : and_2064) : and_2064;
  // hls/stages/agreement.hpp:1123
  logic select_2068;
  assign select_2068 = draws_late_q ? read_half_q : write_half_q;
  logic [7:0] sum_2069;
  assign sum_2069 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2069[7], sum_2069, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1273
  logic [11:0] sum_2071;
  assign sum_2071 = {1'b0, {2{select_2068}}, 2'h0, {2{select_2068}}, 1'b0, {2{select_2068}}, 1'b0, select_2068} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1040
  logic and_2072;
  assign and_2072 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2073;
  assign and_2073 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2074;
  assign and_2074 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2075;
  assign and_2075 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1098
  logic [1:0] sum_2077;
  assign sum_2077 = {1'b0, and_2074} + ({1'b0, textured} + {1'b0, and_2075});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2072} + ({2'h0, and_2073} + {1'b0, sum_2077});
  // hls/stages/agreement.hpp:1040
  logic [7:0] select_2086;
  assign select_2086 = inside_v_s2_q ? (sum_1995_s2_q ? select_1982 : {select_1982[6:0], 1'b0}) : select_1982;
  // hls/stages/agreement.hpp:1061
  logic or_2089;
  assign or_2089 = select_2086[7] | (~({select_2086[5], select_2086[3], select_2086[1]} == 3'h0));
  // hls/stages/agreement.hpp:1040
  logic and_2106;
  assign and_2106 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2107;
  assign and_2107 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2108;
  assign and_2108 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2109;
  assign and_2109 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1100
  logic [1:0] sum_2111;
  assign sum_2111 = {1'b0, and_2108} + ({1'b0, shown} + {1'b0, and_2109});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2106} + ({2'h0, and_2107} + {1'b0, sum_2111});
  // hls/stages/agreement.hpp:1040
  logic and_2122;
  assign and_2122 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2123;
  assign and_2123 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2124;
  assign and_2124 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2125;
  assign and_2125 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2127;
  assign sum_2127 = {1'b0, and_2124} + ({1'b0, near} + {1'b0, and_2125});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2122} + ({2'h0, and_2123} + {1'b0, sum_2127});
  // hls/stages/agreement.hpp:1122
  logic not_2138;
  assign not_2138 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1123
  logic not_2140;
  assign not_2140 = ~({1'b0, sum_1653, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:798
  logic select_2144;
  assign select_2144 = less_2136_s2_q ? (not_2138 & not_2140) : ((draws_late_q & not_2138) & not_2140);
  logic and_2147;
  assign and_2147 = not_577_s2_q & (drew_q & (ends_cell_s2_q & select_2144));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2181;
  assign select_2181 = sample_pair_whole_s2_q ? (and_549_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2183;
  assign select_2183 = sample_pair_whole_s2_q ? (and_549_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2203;
  assign select_2203 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2205;
  assign select_2205 = sample_pair_whole_s2_q ? (and_549_s2_q ? select_564 : averager_mask_q) : averager_mask_q;
  logic select_2207;
  assign select_2207 = sample_pair_whole_s2_q ? (and_549_s2_q ? select_568 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2208;
  assign select_2208 = and_551_s2_q ? select_557 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_551_s2_q ? select_561 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2211;
  assign select_2211 = and_551_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_551_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2213;
  assign select_2213 = and_551_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_551_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_551_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2216;
  assign select_2216 = and_551_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2217;
  assign select_2217 = and_551_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2218;
  assign select_2218 = and_551_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_551_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2220;
  assign select_2220 = and_551_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2221;
  assign select_2221 = and_551_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_551_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2223;
  assign select_2223 = and_551_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2224;
  assign select_2224 = and_551_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_551_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2226;
  assign select_2226 = and_551_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2227;
  assign select_2227 = and_551_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_551_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2229;
  assign select_2229 = and_551_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2230;
  assign select_2230 = and_551_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_551_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2232;
  assign select_2232 = and_551_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2233;
  assign select_2233 = and_551_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2234;
  assign select_2234 = and_551_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_551_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2236;
  assign select_2236 = and_551_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2237;
  assign select_2237 = and_551_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_551_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2239;
  assign select_2239 = and_551_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2240;
  assign select_2240 = and_551_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_551_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2242;
  assign select_2242 = and_551_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2243;
  assign select_2243 = and_551_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_551_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2245;
  assign select_2245 = and_551_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2246;
  assign select_2246 = and_551_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_551_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2248;
  assign select_2248 = and_551_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2249;
  assign select_2249 = and_551_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_551_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2251;
  assign select_2251 = and_551_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2252;
  assign select_2252 = and_551_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2253;
  assign select_2253 = and_551_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2254;
  assign select_2254 = and_551_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2255;
  assign select_2255 = and_551_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2256;
  assign select_2256 = and_551_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2257;
  assign select_2257 = and_551_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2258;
  assign select_2258 = and_551_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2259;
  assign select_2259 = and_551_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2260;
  assign select_2260 = and_551_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2261;
  assign select_2261 = and_551_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2262;
  assign select_2262 = and_551_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2263;
  assign select_2263 = and_551_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2265;
  assign difference_2265 = {1'b0, select_561} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2266;
  assign xor_2266 = difference_2265[8:0] ^ {9{difference_2265[9]}};
  logic [9:0] sum_2267;
  assign sum_2267 = {9'h0, difference_2265[9]} + {1'b0, xor_2266};
  logic [9:0] difference_2268;
  assign difference_2268 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2269;
  assign xor_2269 = difference_2268[8:0] ^ {9{difference_2268[9]}};
  logic [9:0] sum_2270;
  assign sum_2270 = {9'h0, difference_2268[9]} + {1'b0, xor_2269};
  logic [9:0] difference_2272;
  assign difference_2272 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2273;
  assign xor_2273 = difference_2272[8:0] ^ {9{difference_2272[9]}};
  logic [9:0] sum_2274;
  assign sum_2274 = {9'h0, difference_2272[9]} + {1'b0, xor_2273};
  logic [10:0] sum_2275;
  assign sum_2275 = ({1'b0, sum_2267} + {1'b0, sum_2270}) + {1'b0, sum_2274};
  logic [9:0] difference_2276;
  assign difference_2276 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2277;
  assign xor_2277 = difference_2276[8:0] ^ {9{difference_2276[9]}};
  logic [9:0] sum_2278;
  assign sum_2278 = {9'h0, difference_2276[9]} + {1'b0, xor_2277};
  logic [9:0] difference_2280;
  assign difference_2280 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2281;
  assign xor_2281 = difference_2280[8:0] ^ {9{difference_2280[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2302;
  assign sum_2302 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2304;
  assign sum_2304 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1154
  logic equal_2305;
  assign equal_2305 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2306;
  assign select_2306 = equal_2305 ? sum_2302 : moments_before_0_q;
  logic [13:0] select_2308;
  assign select_2308 = equal_2305 ? sum_2304 : moments_before_1_q;
  // hls/stages/agreement.hpp:798
  logic select_2311;
  assign select_2311 = equal_576_s2_q ? (moments_has_before_q | equal_2305) : moments_has_before_q;
  logic [13:0] select_2314;
  assign select_2314 = equal_576_s2_q ? ((select_2308 < select_2306) ? select_2306 : select_2308) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2315;
  assign sum_2315 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2318;
  assign select_2318 = equal_576_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2315)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2319;
  assign sum_2319 = {1'b0, sum_2304} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2322;
  assign select_2322 = equal_576_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2319)) : moments_left_alone_q;
  logic select_2325;
  assign select_2325 = equal_576_s2_q ? (~({3'h0, select_2308[13:2]} < sum_2319)) : moments_left_other_stops_q;
  logic select_2328;
  assign select_2328 = equal_576_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2315)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2329;
  assign sum_2329 = {1'b0, sum_2302} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2332;
  assign select_2332 = equal_576_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2329)) : moments_right_alone_q;
  logic select_2335;
  assign select_2335 = equal_576_s2_q ? (~({3'h0, select_2306[13:2]} < sum_2329)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2338;
  assign or_2338 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:798
  logic and_2346;
  assign and_2346 = not_577_s2_q & (not_579_s2_q & (equal_580_s2_q & (inside_v_s2_q & and_1603)));
  logic and_2350;
  assign and_2350 = not_577_s2_q & (not_579_s2_q & (equal_580_s2_q & (inside_v_s2_q & and_1612)));
  // hls/stages/moments.hpp:94
  logic and_2352;
  assign and_2352 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2355;
  assign select_2355 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2352)) : and_2352;
  // hls/stages/agreement.hpp:798
  logic and_2359;
  assign and_2359 = equal_576_s2_q & (equal_2305 & (cfg_prove_i & (cfg_same_table_i & select_2355)));
  // hls/stages/moments.hpp:95
  logic and_2362;
  assign and_2362 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2376;
  assign difference_2376 = {1'b0, select_557} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2376[9]} + (difference_2376[8:0] ^ {9{difference_2376[9]}});
  logic [9:0] difference_2388;
  assign difference_2388 = {1'b0, select_561} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2388[9]} + (difference_2388[8:0] ^ {9{difference_2388[9]}});
  // hls/stages/agreement.hpp:530
  logic select_2587;
  assign select_2587 = and_551_s2_q ? (equal_2479_s2_q ? and_2585_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2589;
  assign select_2589 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2590;
  assign select_2590 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2591;
  assign select_2591 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2592;
  assign select_2592 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2593;
  assign select_2593 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2594;
  assign select_2594 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2598;
  assign select_2598 = slot_s2_q[0] ? 8'h0 : sum_1017;
  // hls/stages/agreement.hpp:761
  logic less_2599;
  assign less_2599 = select_2598 < select_1517;
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2601;
  assign select_2601 = slot_s2_q[0] ? 7'h0 : sum_1543;
  // hls/stages/agreement.hpp:798
  logic not_2606;
  assign not_2606 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2607;
  assign less_2607 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:530
  logic and_2614;
  assign and_2614 = and_551_s2_q & (equal_684_s2_q & equal_2479_s2_q);
  // hls/stages/agreement.hpp:798
  logic and_2619;
  assign and_2619 = ends_cell_s2_q & (inside_v_s2_q & (and_2616_s2_q & not_640_s2_q));
  // hls/stages/agreement.hpp:1040
  logic and_2643;
  assign and_2643 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2644;
  assign and_2644 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2645;
  assign and_2645 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2646;
  assign and_2646 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1099
  logic [1:0] sum_2648;
  assign sum_2648 = {1'b0, and_2645} + ({1'b0, explained} + {1'b0, and_2646});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2643} + ({2'h0, and_2644} + {1'b0, sum_2648});
  // hls/stages/agreement.hpp:798
  logic and_2684;
  assign and_2684 = ends_cell_s2_q & (inside_v_s2_q & (not_640_s2_q & (and_2616_s2_q & and_2019)));
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_2709;
  assign difference_2709 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2712;
  assign less_2712 = {2'h0, difference_2709[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_2715;
  assign and_2715 = not_585_s2_q & (((and_2017_s2_q & and_637) & equal_2705_s2_q) & (~less_2712));
  // hls/stages/agreement.hpp:798
  logic and_2719;
  assign and_2719 = ends_cell_s2_q & (inside_v_s2_q & ((or_581_s2_q & and_2715) & not_640_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_2725;
  assign and_2725 = not_585_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2727;
  assign and_2727 = not_585_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2728;
  assign select_2728 = or_581_s2_q ? {and_2727, and_2725} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2730;
  assign select_2730 = less_584_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2731;
  assign select_2731 = or_581_s2_q ? select_2730 : 2'h0;
  // hls/stages/agreement.hpp:1037
  logic and_2733;
  assign and_2733 = and_639 & (select_2728[0] & select_2731[0]);
  // hls/stages/agreement.hpp:798
  logic and_2737;
  assign and_2737 = ends_cell_s2_q & (inside_v_s2_q & (not_640_s2_q & (select_2728[1] & and_2733)));
  logic and_2739;
  assign and_2739 = not_577_s2_q & (drew_q & and_2737);
  logic and_2745;
  assign and_2745 = ends_cell_s2_q & (inside_v_s2_q & (not_640_s2_q & (select_2731[1] & and_2733)));
  logic and_2747;
  assign and_2747 = not_577_s2_q & (drew_q & and_2745);
  // hls/stages/registration.hpp:76
  logic less_2750;
  assign less_2750 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2752;
  assign select_2752 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2754;
  assign select_2754 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2756;
  assign select_2756 = or_581_s2_q ? (less_584_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2754} - {1'b0, select_2756};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2758;
  assign select_2758 = rise_2[8] ? select_2754 : select_2756;
  logic [8:0] fall;
  assign fall = {1'b0, select_2752} - {1'b0, select_2758};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2761;
  assign not_2761 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2750 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2761};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2763;
  assign xor_2763 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2763};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2769;
  assign select_2769 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2750 ? {taken, 1'b1} : {not_2761, select_2769, not_2761};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2771;
  assign sum_2771 = {left, 1'b1} + {taken_2, less_2750};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2773;
  assign select_2773 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2775;
  assign select_2775 = equal_576_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_2777;
  assign select_2777 = equal_576_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2778;
  assign equal_2778 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_2782;
  assign and_2782 = and_639 & less_1705_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2784;
  assign select_2784 = or_581_s2_q ? (less_584_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2788;
  assign sum_2788 = select_2784[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2791;
  assign select_2791 = (select_2754 < select_2756) ? ({sum_2788, select_2784[0], 5'h0} - {3'h0, select_2773}) : {sum_2788, select_2784[0], select_2773};
  logic [7:0] select_2792;
  assign select_2792 = ((select_2784 == 3'h0) | (select_2784 == 3'h4)) ? {sum_2788, select_2784[0], 5'h0} : select_2791;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2792[7]}}, select_2792} - {sum_1724[9], sum_1724, sum_1720[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2795;
  assign select_2795 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2795[11:7])) ? 12'h7f : select_2795;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2816;
  assign difference_2816 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2818;
  assign and_2818 = and_2782 & ($signed(difference_2816) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2831;
  assign less_2831 = $signed(difference_2816) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:798
  logic select_2839;
  assign select_2839 = drew_q ? (equal_2778 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2842;
  assign select_2842 = drew_q ? (equal_1706 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2847;
  assign select_2847 = (sum_1619 == 2'h2) ? (registration_fresh_q & (~select_1666)) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_2849;
  assign select_2849 = drew_q ? (and_1661 ? select_2847 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2851;
  assign select_2851 = and_2614 ? 4'hf : (equal_576_s2_q ? registration_fresh_q : select_2849);
  // hls/stages/agreement.hpp:1141
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1616;
  // hls/stages/registration.hpp:258
  logic not_2871;
  assign not_2871 = ~quarter_2[1];
  logic [3:0] select_2872;
  assign select_2872 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2871, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2871};
  // hls/stages/patches.hpp:91
  logic parity_3006;
  assign parity_3006 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3007;
  assign select_3007 = equal_2479_s2_q ? {patches_chance_q[14:0], parity_3006} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3009;
  assign not_3009 = ~and_1780;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_3011;
  assign select_3011 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_3011};
  // hls/stages/agreement.hpp:798
  logic and_3017;
  assign and_3017 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3021;
  assign and_3021 = not_3009 & (patches_fixed_q | ((not_577_s2_q & and_3017) & and_1752));
  // hls/stages/patches.hpp:358
  logic not_3033;
  assign not_3033 = ~select_1695[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3035;
  assign select_3035 = sample_pair_whole_s2_q ? (equal_1696 ? select_1695 : {not_3033, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3134;
  assign select_3134 = or_1788_s2_q ? {and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3136;
  assign select_3136 = equal_1782_s2_q ? patches_codes_at_q : (equal_1784_s2_q ? other[55:4] : select_3134);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1887_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3139;
  assign select_3139 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3141;
  assign select_3141 = equal_1784_s2_q ? (new_row_s2_q ? word : select_3139) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3143;
  assign select_3143 = less_1874_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3145;
  assign select_3145 = less_3144_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3147;
  assign select_3147 = or_1788_s2_q ? (equal_1787_s2_q ? patches_next_codes_q : select_3145) : patches_next_codes_q;
  logic [55:0] select_3149;
  assign select_3149 = equal_1782_s2_q ? patches_next_codes_q : (equal_1784_s2_q ? select_3143 : select_3147);
  // hls/stages/count_bits.hpp:24
  logic parity_3154;
  assign parity_3154 = ^{and_1933_s2_q, and_1930_s2_q, and_1914_s2_q, and_1911};
  // hls/stages/count_bits.hpp:25
  logic or_3158;
  assign or_3158 = ({and_1914_s2_q, and_1911} == 2'h3) | (and_1930_s2_q & (and_1914_s2_q | and_1911));
  logic and_3159;
  assign and_3159 = and_1933_s2_q & (^{and_1930_s2_q, and_1914_s2_q, and_1911});
  // hls/stages/count_bits.hpp:24
  logic xor_3160;
  assign xor_3160 = or_3158 ^ and_3159;
  // hls/stages/count_bits.hpp:27
  logic and_3161;
  assign and_3161 = or_3158 & and_3159;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3163;
  assign select_3163 = or_1788_s2_q ? (and_1956_s2_q ? {and_3161, xor_3160, parity_3154} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3167;
  assign sum_3167 = {7'h0, patches_set_q} + (equal_1787_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3177;
  assign select_3177 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3179;
  assign select_3179 = equal_1782_s2_q ? patches_left_row_q : (equal_1784_s2_q ? select_3177 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3177;
  // hls/stages/count_bits.hpp:24
  logic xor_3183;
  assign xor_3183 = bits[17] ^ (^{select_3177[16:15], other[16:15]});
  logic xor_3186;
  assign xor_3186 = bits[11] ^ (^{select_3177[10:9], other[10:9]});
  logic xor_3189;
  assign xor_3189 = bits[14] ^ (^{select_3177[13:12], other[13:12]});
  logic xor_3192;
  assign xor_3192 = xor_3183 ^ (^{select_3177[14:9], other[14:9]});
  logic xor_3195;
  assign xor_3195 = bits[47] ^ (^{select_3177[46:45], other[46:45]});
  logic xor_3198;
  assign xor_3198 = bits[8] ^ (^{select_3177[7:6], other[7:6]});
  logic xor_3201;
  assign xor_3201 = bits[2] ^ (^{select_3177[1:0], other[1:0]});
  logic xor_3204;
  assign xor_3204 = bits[5] ^ (^{select_3177[4:3], other[4:3]});
  logic xor_3207;
  assign xor_3207 = xor_3198 ^ (^{select_3177[5:0], other[5:0]});
  logic parity_3209;
  assign parity_3209 = ^{select_3177[47:45], select_3177[8:0], other[47:45], other[8:0]};
  logic xor_3210;
  assign xor_3210 = xor_3192 ^ parity_3209;
  logic xor_3213;
  assign xor_3213 = bits[44] ^ (^{select_3177[43:42], other[43:42]});
  logic xor_3216;
  assign xor_3216 = bits[38] ^ (^{select_3177[37:36], other[37:36]});
  logic xor_3219;
  assign xor_3219 = bits[41] ^ (^{select_3177[40:39], other[40:39]});
  logic xor_3225;
  assign xor_3225 = bits[26] ^ (^{select_3177[25:24], other[25:24]});
  logic xor_3228;
  assign xor_3228 = bits[20] ^ (^{select_3177[19:18], other[19:18]});
  logic xor_3231;
  assign xor_3231 = bits[23] ^ (^{select_3177[22:21], other[22:21]});
  logic xor_3234;
  assign xor_3234 = xor_3225 ^ (^{select_3177[23:18], other[23:18]});
  logic xor_3237;
  assign xor_3237 = bits[35] ^ (^{select_3177[34:33], other[34:33]});
  logic xor_3240;
  assign xor_3240 = bits[29] ^ (^{select_3177[28:27], other[28:27]});
  logic xor_3243;
  assign xor_3243 = bits[32] ^ (^{select_3177[31:30], other[31:30]});
  logic xor_3246;
  assign xor_3246 = xor_3237 ^ (^{select_3177[32:27], other[32:27]});
  logic xor_3247;
  assign xor_3247 = xor_3234 ^ xor_3246;
  // hls/stages/count_bits.hpp:25
  logic or_3255;
  assign or_3255 = (xor_3186 & xor_3189) | (xor_3183 & (xor_3186 | xor_3189));
  logic or_3259;
  assign or_3259 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3263;
  assign or_3263 = (xor_3201 & xor_3204) | (xor_3198 & (xor_3201 | xor_3204));
  // hls/stages/count_bits.hpp:23
  logic or_3270;
  assign or_3270 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3274;
  assign or_3274 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3278;
  assign or_3278 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3281;
  assign parity_3281 = ^{or_3278, or_3274, or_3270};
  // hls/stages/count_bits.hpp:23
  logic or_3285;
  assign or_3285 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3289;
  assign or_3289 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3293;
  assign or_3293 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3296;
  assign parity_3296 = ^{or_3293, or_3289, or_3285};
  logic parity_3299;
  assign parity_3299 = ^{or_3293, or_3289, or_3285, or_3278, or_3274, or_3270, or_3263, or_3259, or_3255};
  // hls/stages/count_bits.hpp:23
  logic or_3303;
  assign or_3303 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3307;
  assign or_3307 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3311;
  assign or_3311 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3319;
  assign or_3319 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3323;
  assign or_3323 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3327;
  assign or_3327 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3330;
  assign parity_3330 = ^{or_3327, or_3323, or_3319};
  // hls/stages/count_bits.hpp:23
  logic or_3334;
  assign or_3334 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3338;
  assign or_3338 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3342;
  assign or_3342 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3345;
  assign parity_3345 = ^{or_3342, or_3338, or_3334};
  logic parity_3348;
  assign parity_3348 = ^{or_3342, or_3338, or_3334, or_3327, or_3323, or_3319, or_3311, or_3307, or_3303};
  // hls/stages/count_bits.hpp:25
  logic or_3352;
  assign or_3352 = (xor_3216 & xor_3219) | (xor_3213 & (xor_3216 | xor_3219));
  logic or_3356;
  assign or_3356 = (xor_3228 & xor_3231) | (xor_3225 & (xor_3228 | xor_3231));
  logic or_3360;
  assign or_3360 = (xor_3240 & xor_3243) | (xor_3237 & (xor_3240 | xor_3243));
  // hls/stages/count_bits.hpp:24
  logic parity_3363;
  assign parity_3363 = ^{or_3360, or_3356, or_3352};
  // hls/stages/count_bits.hpp:25
  logic and_3364;
  assign and_3364 = xor_3210 & (^{xor_3247, select_3177[44:36], other[44:36]});
  logic or_3368;
  assign or_3368 = (xor_3195 & xor_3207) | (xor_3192 & (xor_3195 | xor_3207));
  logic and_3371;
  assign and_3371 = (xor_3213 ^ (^{select_3177[41:36], other[41:36]})) & (xor_3234 | xor_3246);
  logic or_3372;
  assign or_3372 = (xor_3234 & xor_3246) | and_3371;
  // hls/stages/count_bits.hpp:24
  logic parity_3375;
  assign parity_3375 = ^{or_3372, or_3368, and_3364};
  logic parity_3378;
  assign parity_3378 = ^{or_3372, or_3368, and_3364, or_3360, or_3356, or_3352, or_3342, or_3338, or_3334, or_3327, or_3323, or_3319, or_3311, or_3307, or_3303};
  logic parity_3380;
  assign parity_3380 = ^{or_3372, or_3368, and_3364, or_3360, or_3356, or_3352, or_3342, or_3338, or_3334, or_3327, or_3323, or_3319, or_3311, or_3307, or_3303, or_3293, or_3289, or_3285, or_3278, or_3274, or_3270, or_3263, or_3259, or_3255};
  // hls/stages/count_bits.hpp:25
  logic and_3381;
  assign and_3381 = parity_3299 & parity_3378;
  logic or_3385;
  assign or_3385 = (parity_3281 & parity_3296) | ((^{or_3263, or_3259, or_3255}) & (parity_3281 | parity_3296));
  logic or_3389;
  assign or_3389 = (parity_3363 & parity_3375) | (parity_3348 & (parity_3363 | parity_3375));
  logic or_3396;
  assign or_3396 = (parity_3330 & parity_3345) | ((^{or_3311, or_3307, or_3303}) & (parity_3330 | parity_3345));
  logic or_3400;
  assign or_3400 = (or_3356 & or_3360) | (or_3352 & (or_3356 | or_3360));
  logic or_3404;
  assign or_3404 = (or_3368 & or_3372) | (and_3364 & (or_3368 | or_3372));
  // hls/stages/count_bits.hpp:23
  logic or_3411;
  assign or_3411 = (or_3307 & or_3311) | (or_3303 & (or_3307 | or_3311));
  // hls/stages/count_bits.hpp:25
  logic or_3415;
  assign or_3415 = (or_3323 & or_3327) | (or_3319 & (or_3323 | or_3327));
  logic or_3419;
  assign or_3419 = (or_3338 & or_3342) | (or_3334 & (or_3338 | or_3342));
  // hls/stages/count_bits.hpp:24
  logic parity_3422;
  assign parity_3422 = ^{or_3419, or_3415, or_3411};
  // hls/stages/count_bits.hpp:23
  logic or_3426;
  assign or_3426 = (or_3259 & or_3263) | (or_3255 & (or_3259 | or_3263));
  // hls/stages/count_bits.hpp:25
  logic or_3430;
  assign or_3430 = (or_3274 & or_3278) | (or_3270 & (or_3274 | or_3278));
  logic or_3434;
  assign or_3434 = (or_3289 & or_3293) | (or_3285 & (or_3289 | or_3293));
  // hls/stages/count_bits.hpp:24
  logic parity_3437;
  assign parity_3437 = ^{or_3434, or_3430, or_3426};
  logic parity_3440;
  assign parity_3440 = ^{or_3434, or_3430, or_3426, or_3419, or_3415, or_3411, or_3404, or_3400, or_3396};
  logic parity_3442;
  assign parity_3442 = ^{or_3434, or_3430, or_3426, or_3419, or_3415, or_3411, or_3404, or_3400, or_3396, or_3389, or_3385, and_3381};
  // hls/stages/count_bits.hpp:25
  logic or_3446;
  assign or_3446 = (or_3400 & or_3404) | (or_3396 & (or_3400 | or_3404));
  logic or_3450;
  assign or_3450 = (or_3415 & or_3419) | (or_3411 & (or_3415 | or_3419));
  logic or_3454;
  assign or_3454 = (or_3430 & or_3434) | (or_3426 & (or_3430 | or_3434));
  // hls/stages/count_bits.hpp:24
  logic parity_3457;
  assign parity_3457 = ^{or_3454, or_3450, or_3446};
  // hls/stages/count_bits.hpp:25
  logic and_3458;
  assign and_3458 = (^{or_3389, or_3385, and_3381}) & parity_3440;
  logic or_3462;
  assign or_3462 = (or_3385 & or_3389) | (and_3381 & (or_3385 | or_3389));
  logic or_3466;
  assign or_3466 = (parity_3422 & parity_3437) | ((^{or_3404, or_3400, or_3396}) & (parity_3422 | parity_3437));
  // hls/stages/count_bits.hpp:24
  logic parity_3469;
  assign parity_3469 = ^{or_3466, or_3462, and_3458};
  // hls/stages/count_bits.hpp:25
  logic and_3471;
  assign and_3471 = parity_3457 & parity_3469;
  logic or_3475;
  assign or_3475 = (or_3450 & or_3454) | (or_3446 & (or_3450 | or_3454));
  logic or_3479;
  assign or_3479 = (or_3462 & or_3466) | (and_3458 & (or_3462 | or_3466));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3524;
  assign select_3524 = equal_1784_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3527;
  assign select_3527 = equal_1782_s2_q ? patches_summed_first_q : (equal_1784_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3535;
  assign select_3535 = less_1962_s2_q ? (or_1965_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3538;
  assign select_3538 = less_1962_s2_q ? (or_1965_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3541;
  assign select_3541 = less_1962_s2_q ? (or_1965_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3546;
  assign select_3546 = equal_1782_s2_q ? (less_1962_s2_q & (or_1965_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3551;
  assign or_3551 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3552;
  assign and_3552 = patches_read_searches_s2_q & or_3551;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3553;
  assign select_3553 = and_3552 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3553};
  // hls/stages/patches.hpp:559
  logic and_3558;
  assign and_3558 = less_1962_s2_q & (or_1965_s2_q & (equal_1963_s2_q & (away == 6'h3f)));
  logic and_3563;
  assign and_3563 = less_1962_s2_q & (or_1965_s2_q & (equal_1963_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3565;
  assign sum_3565 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3568;
  assign select_3568 = (equal_1963_s2_q & ({sum_3565[6], sum_3565} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3570;
  assign select_3570 = less_1962_s2_q ? (or_1965_s2_q ? select_3568 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3572;
  assign select_3572 = and_3552 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3573;
  assign select_3573 = equal_1782_s2_q ? select_3572[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3574;
  assign select_3574 = equal_1782_s2_q ? select_3572[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3576;
  assign select_3576 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3577;
  assign select_3577 = equal_1782_s2_q ? select_3576 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3578;
  assign select_3578 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3579;
  assign select_3579 = equal_1782_s2_q ? select_3578 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3581;
  assign select_3581 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3583;
  assign select_3583 = equal_1782_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3581) : patches_peak_far_q;
  logic [9:0] select_3586;
  assign select_3586 = equal_1782_s2_q ? (equal_3584_s2_q ? sum_3167 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:798
  logic select_3837;
  assign select_3837 = equal_576_s2_q ? shown_shown_q : (drew_q ? select_2032 : shown_shown_q);
  logic select_3839;
  assign select_3839 = equal_576_s2_q ? shown_nearer_q : (drew_q ? select_2035 : shown_nearer_q);
  // hls/stages/agreement.hpp:499
  logic [8:0] select_3842;
  assign select_3842 = equal_684_s2_q ? {{2{difference_3841[6]}}, difference_3841} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_3843;
  assign sum_3843 = select_3842[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3846;
  assign select_3846 = less_3840_s2_q ? (sum_3843[7] ? region_row_q : next_region_row_q) : (and_2585_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_3848;
  assign select_3848 = and_551_s2_q ? (equal_2479_s2_q ? select_3846 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3852;
  assign select_3852 = equal_576_s2_q ? select_1982 : (drew_q ? (ends_cell_s2_q ? select_2086 : select_1982) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3865;
  assign select_3865 = equal_2479_s2_q ? (less_3840_s2_q ? region_down_next_q : select_3842) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [6:0] select_3868;
  assign select_3868 = equal_684_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_3870;
  assign select_3870 = and_551_s2_q ? (equal_2479_s2_q ? select_3868 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3871;
  assign sum_3871 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3872;
  assign sum_3872 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3873;
  assign select_3873 = sum_3871[7] ? {1'b1, sum_3871[6:0], region_down_rest_q[0]} : sum_3872;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3843[7];
  // hls/stages/agreement.hpp:465
  logic select_3877;
  assign select_3877 = equal_2479_s2_q ? (less_3840_s2_q ? next : (region_fresh_q | equal_684_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_3882;
  assign or_3882 = segment_starts_q | not_579_s2_q;
  // hls/stages/agreement.hpp:1040
  logic select_3885;
  assign select_3885 = inside_v_s2_q ? (sum_1995_s2_q ? (equal_1775 & or_1997) : or_1997) : or_3882;
  // hls/stages/agreement.hpp:798
  logic select_3888;
  assign select_3888 = equal_576_s2_q ? or_3882 : (drew_q ? (ends_cell_s2_q ? select_3885 : or_3882) : or_3882);
  logic select_4048;
  assign select_4048 = drew_q ? (ends_cell_s2_q ? and_2074 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4051;
  assign select_4051 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4053;
  assign select_4053 = equal_576_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4051 : centres_values_0_of_skin_q);
  logic select_4054;
  assign select_4054 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4056;
  assign select_4056 = equal_576_s2_q ? centres_values_1_textured_q : (drew_q ? select_4054 : centres_values_1_textured_q);
  logic select_4057;
  assign select_4057 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4059;
  assign select_4059 = equal_576_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4057 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [10:0] select_4065;
  assign select_4065 = equal_2479_s2_q ? (or_4062_s2_q ? (map_row_q + {5'h0, map_width_q}) : 11'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [5:0] select_4068;
  assign select_4068 = and_551_s2_q ? (equal_2479_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1283
  logic xor_4069;
  assign xor_4069 = write_half_q ^ done_s2_q;
  // hls/stages/agreement.hpp:443
  logic select_4071;
  assign select_4071 = and_1974_s2_q ? (left_first_s2_q ? xor_4069 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:279
  logic select_4073;
  assign select_4073 = and_1974_s2_q ? (left_first_s2_q ? xor_4069 : select_4071) : write_half_q;
  logic select_4075;
  assign select_4075 = left_first_s2_q ? select_2038 : (and_1974_s2_q ? select_2039 : read_half_q);
  logic [9:0] select_4088;
  assign select_4088 = left_first_s2_q ? 10'h1 : (and_1974_s2_q ? select_2043 : rows_passed_q);
  logic [8:0] select_4091;
  assign select_4091 = left_first_s2_q ? {select_2041[7:0], or_2040} : (and_1974_s2_q ? {select_2041[7:0], or_2040} : columns_passed_q);
  logic select_4094;
  assign select_4094 = left_first_s2_q ? marks_last_s2_q : (and_1974_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4097;
  assign select_4097 = left_first_s2_q ? and_2057 : (and_1974_s2_q ? and_2057 : began_q);
  logic [2:0] select_4100;
  assign select_4100 = left_first_s2_q ? select_2059 : (and_1974_s2_q ? select_2059 : seen_x_q);
  // hls/stages/agreement.hpp:1313
  logic [2:0] select_4105;
  assign select_4105 = left_first_s2_q ? 3'h0 : (and_2044 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:279
  logic [2:0] select_4107;
  assign select_4107 = left_first_s2_q ? 3'h0 : (and_1974_s2_q ? select_4105 : seen_y_q);
  logic [7:0] select_4110;
  assign select_4110 = left_first_s2_q ? select_2052 : (and_1974_s2_q ? select_2052 : seen_column_q);
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4116;
  assign select_4116 = left_first_s2_q ? select_4114 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:279
  logic [7:0] select_4118;
  assign select_4118 = left_first_s2_q ? select_4114 : (and_1974_s2_q ? select_4116 : seen_rows_left_q);
  // hls/stages/agreement.hpp:441
  logic and_4123;
  assign and_4123 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:279
  logic select_4125;
  assign select_4125 = left_first_s2_q ? and_4123 : (and_1974_s2_q ? and_4123 : at_cell_end_q);
  logic select_4128;
  assign select_4128 = left_first_s2_q ? next_row : (and_1974_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4131;
  assign select_4131 = left_first_s2_q ? 11'h0 : (and_1974_s2_q ? select_2049 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4204;
  assign not_4204 = ~quarter[1];
  logic [3:0] select_4205;
  assign select_4205 = quarter[0] ? {quarter[1], 1'b0, not_4204, 1'b0} : {1'b0, quarter[1], 1'b0, not_4204};

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

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1412; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1423; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2054;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2066;
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
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2030, textured};
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
      draws_late_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2203;
      averager_mask_q <= select_2205;
      averager_of_skin_q <= select_2207;
      census_filled_q <= and_551_s2_q ? {select_687[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2302;
      moments_turned_1_q <= sum_2304;
      moments_before_0_q <= equal_576_s2_q ? select_2306 : moments_before_0_q;
      moments_before_1_q <= equal_576_s2_q ? select_2308 : moments_before_1_q;
      moments_has_before_q <= select_2311;
      moments_most_before_q <= select_2314;
      moments_left_begins_q <= select_2318;
      moments_left_alone_q <= select_2322;
      moments_left_other_stops_q <= select_2325;
      moments_right_begins_q <= select_2328;
      moments_right_alone_q <= select_2332;
      moments_right_other_stops_q <= select_2335;
      moments_out_of_step_q <= or_2338;
      moments_turns_0_q <= and_2346;
      moments_turns_1_q <= and_2350;
      moments_begins_alone_q <= and_2359;
      moments_ends_q <= equal_576_s2_q & (equal_2305 & (not_2360 | and_2362));
      rows_passed_above_q <= and_551_s2_q ? select_686 : rows_passed_above_q;
      draws_late_q <= select_2587;
      chosen_score_q <= less_2599 ? select_1517 : select_2598;
      chosen_near_q <= (select_2601 < select_1552) ? select_1552 : select_2601;
      chosen_place_q <= less_2599 ? {select_1525, not_1524} : 3'h2;
      before_0_q <= select_2598;
      before_1_q <= sum_1267;
      before_2_q <= sum_1515;
      shift_allowed_q <= not_2606 & (~less_2607);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2614 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2739});
      counts_turned_right_q <= and_2614 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2747});
      registration_displacement_over_q <= drew_q ? sum_2771[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2773;
      registration_slope_here_q <= select_2775;
      registration_expected_q <= select_2777;
      registration_of_right_q <= equal_576_s2_q ? registration_of_right_q : select_2839;
      registration_was_inside_q <= equal_576_s2_q ? registration_was_inside_q : select_2842;
      registration_fresh_q <= select_2851;
      patches_chance_q <= and_551_s2_q ? select_3007 : patches_chance_q;
      patches_fixed_q <= and_3021;
      patches_choice_valid_q <= and_1780 ? (select_1753 & not_3009) : select_1753;
      patches_choice_column_q <= select_1758;
      patches_choice_shift_q <= select_1763;
      patches_choice_slope_q <= select_1774;
      patches_band_q <= sample_pair_whole_s2_q ? select_1795 : patches_band_q;
      patches_fetch_q <= select_3035;
      patches_codes_at_q <= select_3136;
      patches_codes_further_q <= equal_1782_s2_q ? patches_codes_further_q : select_3141;
      patches_next_codes_q <= select_3149;
      patches_set_q <= equal_1782_s2_q ? 3'h0 : (equal_1784_s2_q ? 3'h0 : select_3163);
      patches_size_q <= sum_3167;
      patches_left_row_q <= select_3179;
      patches_summed_row_column_q <= equal_1782_s2_q ? patches_summed_row_column_q : select_3524;
      patches_summed_first_q <= select_3527;
      patches_read_row_differing_q <= equal_1782_s2_q ? select_3535 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1782_s2_q ? select_3538 : patches_read_row_column_q;
      patches_read_at_q <= equal_1782_s2_q ? select_3541 : patches_read_at_q;
      patches_read_first_q <= select_3546;
      patches_read_above_q <= equal_1782_s2_q ? and_3558 : patches_read_above_q;
      patches_read_below_q <= equal_1782_s2_q ? and_3563 : patches_read_below_q;
      patches_read_far_q <= equal_1782_s2_q ? select_3570 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3573;
      patches_peak_best_column_q <= select_3574;
      patches_peak_row_q <= equal_1782_s2_q ? select_3553 : patches_peak_row_q;
      patches_peak_above_q <= select_3577;
      patches_peak_below_q <= select_3579;
      patches_peak_far_q <= select_3583;
      patches_peak_size_q <= select_3586;
      patches_frame_ended_q <= equal_576_s2_q & equal_2305;
      shown_shown_q <= select_3837;
      shown_nearer_q <= select_3839;
      region_row_q <= select_3848;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3852;
      region_down_rest_q <= and_551_s2_q ? select_3865 : region_down_rest_q;
      region_down_back_q <= select_3870;
      region_down_next_q <= select_3873;
      region_fresh_q <= and_551_s2_q ? select_3877 : region_fresh_q;
      segment_starts_q <= select_3888;
      centres_values_0_textured_q <= equal_576_s2_q ? centres_values_0_textured_q : select_4048;
      centres_values_0_of_skin_q <= select_4053;
      centres_values_1_textured_q <= select_4056;
      centres_values_1_of_skin_q <= select_4059;
      map_row_q <= and_551_s2_q ? select_4065 : map_row_q;
      map_width_q <= select_4068;
      write_half_q <= select_4073;
      read_half_q <= and_1974_s2_q ? select_4075 : read_half_q;
      rows_passed_q <= and_1974_s2_q ? select_4088 : rows_passed_q;
      columns_passed_q <= and_1974_s2_q ? select_4091 : columns_passed_q;
      line_ended_q <= and_1974_s2_q ? select_4094 : line_ended_q;
      began_q <= and_1974_s2_q ? select_4097 : began_q;
      seen_x_q <= and_1974_s2_q ? select_4100 : seen_x_q;
      seen_y_q <= and_1974_s2_q ? select_4107 : seen_y_q;
      seen_column_q <= and_1974_s2_q ? select_4110 : seen_column_q;
      seen_rows_left_q <= and_1974_s2_q ? select_4118 : seen_rows_left_q;
      at_cell_end_q <= and_1974_s2_q ? select_4125 : at_cell_end_q;
      was_next_row_q <= and_1974_s2_q ? select_4128 : was_next_row_q;
      seen_base_q <= and_1974_s2_q ? select_4131 : seen_base_q;
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
      averager_total_0_q <= select_2181;
      averager_total_1_q <= select_2183;
      census_columns_values_0_cell_0_left_q <= select_2208;
      census_columns_values_0_cell_0_right_q <= select_2209;
      census_columns_values_0_cell_0_mask_q <= and_551_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2211;
      census_columns_values_0_cell_1_right_q <= select_2212;
      census_columns_values_0_cell_1_mask_q <= select_2213;
      census_columns_values_0_cell_2_left_q <= select_2214;
      census_columns_values_0_cell_2_right_q <= select_2215;
      census_columns_values_0_cell_2_mask_q <= select_2216;
      census_columns_values_0_cell_2_of_skin_q <= select_2217;
      census_columns_values_0_cell_3_left_q <= select_2218;
      census_columns_values_0_cell_3_right_q <= select_2219;
      census_columns_values_0_cell_3_mask_q <= select_2220;
      census_columns_values_0_cell_4_left_q <= select_2221;
      census_columns_values_0_cell_4_right_q <= select_2222;
      census_columns_values_0_cell_4_mask_q <= select_2223;
      census_columns_values_1_cell_0_left_q <= select_2224;
      census_columns_values_1_cell_0_right_q <= select_2225;
      census_columns_values_1_cell_0_mask_q <= select_2226;
      census_columns_values_1_cell_1_left_q <= select_2227;
      census_columns_values_1_cell_1_right_q <= select_2228;
      census_columns_values_1_cell_1_mask_q <= select_2229;
      census_columns_values_1_cell_2_left_q <= select_2230;
      census_columns_values_1_cell_2_right_q <= select_2231;
      census_columns_values_1_cell_2_mask_q <= select_2232;
      census_columns_values_1_cell_2_of_skin_q <= select_2233;
      census_columns_values_1_cell_3_left_q <= select_2234;
      census_columns_values_1_cell_3_right_q <= select_2235;
      census_columns_values_1_cell_3_mask_q <= select_2236;
      census_columns_values_1_cell_4_left_q <= select_2237;
      census_columns_values_1_cell_4_right_q <= select_2238;
      census_columns_values_1_cell_4_mask_q <= select_2239;
      census_columns_values_2_cell_0_left_q <= select_2240;
      census_columns_values_2_cell_0_right_q <= select_2241;
      census_columns_values_2_cell_0_mask_q <= select_2242;
      census_columns_values_2_cell_1_left_q <= select_2243;
      census_columns_values_2_cell_1_right_q <= select_2244;
      census_columns_values_2_cell_1_mask_q <= select_2245;
      census_columns_values_2_cell_2_left_q <= select_2246;
      census_columns_values_2_cell_2_right_q <= select_2247;
      census_columns_values_2_cell_2_mask_q <= select_2248;
      census_columns_values_2_cell_3_left_q <= select_2249;
      census_columns_values_2_cell_3_right_q <= select_2250;
      census_columns_values_2_cell_3_mask_q <= select_2251;
      census_columns_values_2_cell_4_left_q <= select_2252;
      census_columns_values_2_cell_4_right_q <= select_2253;
      census_columns_values_2_cell_4_mask_q <= select_2254;
      census_columns_values_3_cell_0_mask_q <= select_2255;
      census_columns_values_3_cell_1_left_q <= select_2256;
      census_columns_values_3_cell_1_right_q <= select_2257;
      census_columns_values_3_cell_1_mask_q <= select_2258;
      census_columns_values_3_cell_2_mask_q <= select_2259;
      census_columns_values_3_cell_3_left_q <= select_2260;
      census_columns_values_3_cell_3_right_q <= select_2261;
      census_columns_values_3_cell_3_mask_q <= select_2262;
      census_columns_values_3_cell_4_mask_q <= select_2263;
      sharpness_last_mean_0_q <= and_551_s2_q ? select_557 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_551_s2_q ? select_561 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2589;
      middle_sum_columns_values_2_q <= select_2590;
      middle_sum_columns_values_3_q <= select_2591;
      middle_sum_columns_values_4_q <= select_2592;
      middle_sum_columns_values_5_q <= select_2593;
      middle_sum_columns_values_6_q <= select_2594;
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
  logic and_2006_s3_q;
  logic and_2011_s3_q;
  logic and_2022_s3_q;
  logic and_2027_s3_q;
  logic and_2061_s3_q;
  logic less_2062_s3_q;
  logic [11:0] sum_2071_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2089_s3_q;
  logic or_2092_s3_q;
  logic or_2095_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2147_s3_q;
  logic [11:0] sum_2279_s3_q;
  logic [9:0] sum_2282_s3_q;
  logic equal_2290_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2408_s3_q;
  logic and_2614_s3_q;
  logic and_2621_s3_q;
  logic not_2642_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2686_s3_q;
  logic and_2721_s3_q;
  logic and_2781_s3_q;
  logic and_2782_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2818_s3_q;
  logic and_2832_s3_q;
  logic equal_2874_s3_q;
  logic parity_3251_s3_q;
  logic parity_3380_s3_q;
  logic parity_3442_s3_q;
  logic xor_3470_s3_q;
  logic parity_3482_s3_q;
  logic or_3486_s3_q;
  logic equal_3487_s3_q;
  logic and_3587_s3_q;
  logic less_3612_s3_q;
  logic equal_3912_s3_q;
  logic and_4086_s3_q;
  logic and_4134_s3_q;
  logic and_4136_s3_q;
  logic not_4154_s3_q;
  logic equal_4207_s3_q;
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
      x_s3_q <= x_s2_q[6:0];
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
      and_2006_s3_q <= inside_v_s2_q & (and_2004 & not_640_s2_q);
      and_2011_s3_q <= inside_v_s2_q & and_641;
      and_2022_s3_q <= inside_v_s2_q & (not_640_s2_q & (and_2019 & and_1591));
      and_2027_s3_q <= not_577_s2_q & and_2000;
      and_2061_s3_q <= and_2061;
      less_2062_s3_q <= less_2062;
      sum_2071_s3_q <= sum_2071;
      textured_2_s3_q <= textured_2;
      or_2089_s3_q <= or_2089;
      or_2092_s3_q <= select_2086[7] | (~({select_2086[6], select_2086[3:2]} == 3'h0));
      or_2095_s3_q <= select_2086[7] | (~(select_2086[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2147_s3_q <= and_2147;
      sum_2279_s3_q <= {1'b0, sum_2275} + {2'h0, sum_2278};
      sum_2282_s3_q <= {9'h0, difference_2280[9]} + {1'b0, xor_2281};
      equal_2290_s3_q <= equal_2290_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2408_s3_q <= x_s2_q[7:3] == 5'h0;
      and_2614_s3_q <= and_2614;
      and_2621_s3_q <= not_577_s2_q & (drew_q & and_2619);
      not_2642_s3_q <= ~((draws_late_q & not_640_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_2686_s3_q <= not_577_s2_q & (drew_q & and_2684);
      and_2721_s3_q <= not_577_s2_q & (drew_q & and_2719);
      and_2781_s3_q <= not_577_s2_q & (drew_q & (half_ends & equal_2778));
      and_2782_s3_q <= and_2782;
      residual_s3_q <= residual[7:0];
      and_2818_s3_q <= and_2818;
      and_2832_s3_q <= and_2782 & less_2831;
      equal_2874_s3_q <= (registration_fresh_q & select_2872) == 4'h0;
      parity_3251_s3_q <= ^{xor_3247, xor_3210, select_3177[44:36], other[44:36]};
      parity_3380_s3_q <= parity_3380;
      parity_3442_s3_q <= parity_3442;
      xor_3470_s3_q <= parity_3457 ^ parity_3469;
      parity_3482_s3_q <= ^{or_3479, or_3475, and_3471};
      or_3486_s3_q <= (or_3475 & or_3479) | (and_3471 & (or_3475 | or_3479));
      equal_3487_s3_q <= equal_3487_s2_q;
      and_3587_s3_q <= equal_1782_s2_q & equal_3584_s2_q;
      less_3612_s3_q <= select_3577 < select_3579;
      equal_3912_s3_q <= equal_3912_s2_q;
      and_4086_s3_q <= said_q;
      and_4134_s3_q <= and_2147 & (sum_2071 == sum_2054);
      and_4136_s3_q <= and_4136_s2_q;
      not_4154_s3_q <= not_4154_s2_q;
      equal_4207_s3_q <= (registration_fresh_q & select_4205) == 4'h0;
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:277
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
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2007;
  assign select_2007 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:911
  logic [5:0] sum_2008;
  assign sum_2008 = {5'h0, and_2006_s3_q} + select_2007;
  // hls/stages/agreement.hpp:1072
  logic [9:0] sum_2010;
  assign sum_2010 = {4'h0, sum_2008} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2012;
  assign select_2012 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:911
  logic [5:0] sum_2013;
  assign sum_2013 = {5'h0, and_2011_s3_q} + select_2012;
  // hls/stages/agreement.hpp:1073
  logic [9:0] sum_2015;
  assign sum_2015 = {4'h0, sum_2013} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2023;
  assign select_2023 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:912
  logic [5:0] sum_2024;
  assign sum_2024 = {5'h0, and_2022_s3_q} + select_2023;
  // hls/stages/agreement.hpp:1074
  logic [9:0] sum_2026;
  assign sum_2026 = {4'h0, sum_2024} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1105
  logic [2:0] select_2080;
  assign select_2080 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2081;
  assign difference_2081 = {1'b0, textured_2_s3_q} - {1'b0, select_2080};
  logic [4:0] t;
  assign t = {difference_2081[3], difference_2081} + (equal_571_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1111
  logic equal_2084;
  assign equal_2084 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1112
  logic not_2096;
  assign not_2096 = ~region_row_s3_q[2];
  logic [2:0] select_2097;
  assign select_2097 = region_row_s3_q[1] ? {1'b0, not_2096, 1'b0} : {region_row_s3_q[2], 1'b0, not_2096};
  logic [5:0] select_2098;
  assign select_2098 = region_row_s3_q[0] ? {select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  logic [11:0] select_2099;
  assign select_2099 = or_2095_s3_q ? {select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0], 1'b0} : {1'b0, select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0]};
  logic [23:0] select_2100;
  assign select_2100 = or_2092_s3_q ? {select_2099[11], 1'b0, select_2099[10], 1'b0, select_2099[9], 1'b0, select_2099[8], 1'b0, select_2099[7], 1'b0, select_2099[6], 1'b0, select_2099[5], 1'b0, select_2099[4], 1'b0, select_2099[3], 1'b0, select_2099[2], 1'b0, select_2099[1], 1'b0, select_2099[0], 1'b0} : {1'b0, select_2099[11], 1'b0, select_2099[10], 1'b0, select_2099[9], 1'b0, select_2099[8], 1'b0, select_2099[7], 1'b0, select_2099[6], 1'b0, select_2099[5], 1'b0, select_2099[4], 1'b0, select_2099[3], 1'b0, select_2099[2], 1'b0, select_2099[1], 1'b0, select_2099[0]};
  logic [47:0] select_2101;
  assign select_2101 = or_2089_s3_q ? {select_2100[23], 1'b0, select_2100[22], 1'b0, select_2100[21], 1'b0, select_2100[20], 1'b0, select_2100[19], 1'b0, select_2100[18], 1'b0, select_2100[17], 1'b0, select_2100[16], 1'b0, select_2100[15], 1'b0, select_2100[14], 1'b0, select_2100[13], 1'b0, select_2100[12], 1'b0, select_2100[11], 1'b0, select_2100[10], 1'b0, select_2100[9], 1'b0, select_2100[8], 1'b0, select_2100[7], 1'b0, select_2100[6], 1'b0, select_2100[5], 1'b0, select_2100[4], 1'b0, select_2100[3], 1'b0, select_2100[2], 1'b0, select_2100[1], 1'b0, select_2100[0], 1'b0} : {1'b0, select_2100[23], 1'b0, select_2100[22], 1'b0, select_2100[21], 1'b0, select_2100[20], 1'b0, select_2100[19], 1'b0, select_2100[18], 1'b0, select_2100[17], 1'b0, select_2100[16], 1'b0, select_2100[15], 1'b0, select_2100[14], 1'b0, select_2100[13], 1'b0, select_2100[12], 1'b0, select_2100[11], 1'b0, select_2100[10], 1'b0, select_2100[9], 1'b0, select_2100[8], 1'b0, select_2100[7], 1'b0, select_2100[6], 1'b0, select_2100[5], 1'b0, select_2100[4], 1'b0, select_2100[3], 1'b0, select_2100[2], 1'b0, select_2100[1], 1'b0, select_2100[0]};
  // hls/stages/agreement.hpp:1040
  logic and_2105;
  assign and_2105 = good_known_q & (~((good_q & select_2101) == 48'h0));
  // hls/stages/agreement.hpp:1107
  logic [2:0] select_2114;
  assign select_2114 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2115;
  assign difference_2115 = {1'b0, shown_2_s3_q} - {1'b0, select_2114};
  logic [4:0] around;
  assign around = {difference_2115[3], difference_2115} + (equal_571_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1114
  logic [5:0] sum_2118;
  assign sum_2118 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2084 ? and_2105 : (~({sum_2118, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2130;
  assign select_2130 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2131;
  assign difference_2131 = {1'b0, near_2_s3_q} - {1'b0, select_2130};
  logic [4:0] n;
  assign n = {difference_2131[3], difference_2131} + (equal_571_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1124
  logic and_2135;
  assign and_2135 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2173;
  assign select_2173 = sample_pair_whole_s3_q ? (and_549_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2175;
  assign select_2175 = sample_pair_whole_s3_q ? (and_549_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2177;
  assign select_2177 = sample_pair_whole_s3_q ? (and_549_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2179;
  assign select_2179 = sample_pair_whole_s3_q ? (and_549_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2184;
  assign sum_2184 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2185;
  assign difference_2185 = {1'b0, sum_2184[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2186;
  assign xor_2186 = {difference_2185[8:0], sum_2184[0]} ^ {10{difference_2185[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2185[9]} + {1'b0, xor_2186};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_554_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2191;
  assign select_2191 = sample_pair_whole_s3_q ? (and_549_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2192;
  assign sum_2192 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2193;
  assign difference_2193 = {1'b0, sum_2192[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2194;
  assign xor_2194 = {difference_2193[8:0], sum_2192[0]} ^ {10{difference_2193[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2193[9]} + {1'b0, xor_2194};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_554_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2199;
  assign select_2199 = sample_pair_whole_s3_q ? (and_549_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2283;
  assign sum_2283 = sum_2279_s3_q + {2'h0, sum_2282_s3_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2285;
  assign select_2285 = and_551_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2286;
  assign select_2286 = and_551_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2287;
  assign select_2287 = and_551_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2288;
  assign select_2288 = and_551_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2291;
  assign sum_2291 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2283};
  logic [13:0] sum_2293;
  assign sum_2293 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2291});
  // hls/stages/census.hpp:323
  logic and_2295;
  assign and_2295 = and_713_s3_q & (9'h4 < sum_2293[13:5]);
  // hls/stages/census.hpp:324
  logic and_2296;
  assign and_2296 = and_713_s3_q & less_737;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2297;
  assign sum_2297 = census_left_misses_q + {{17{and_2296}}, and_2295, 1'b0, and_2295};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2299;
  assign select_2299 = and_551_s3_q ? (equal_2290_s3_q ? 20'h0 : sum_2297) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2369;
  assign select_2369 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:530
  logic select_2372;
  assign select_2372 = and_551_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2375;
  assign and_2375 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:462
  logic and_2381;
  assign and_2381 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2382;
  assign and_2382 = and_2375 & and_2381;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2369[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2384;
  assign select_2384 = and_2382 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2386;
  assign select_2386 = equal_2290_s3_q ? {11'h0, select_2384} : (sharpness_sums_detail_0_q + {11'h0, select_2384});
  // hls/stages/agreement.hpp:462
  logic and_2393;
  assign and_2393 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2394;
  assign and_2394 = and_2375 & and_2393;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2369[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2396;
  assign select_2396 = and_2394 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2398;
  assign select_2398 = equal_2290_s3_q ? {11'h0, select_2396} : (sharpness_sums_detail_1_q + {11'h0, select_2396});
  logic [8:0] select_2401;
  assign select_2401 = and_2382 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2402;
  assign sum_2402 = (equal_2290_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2401};
  logic [8:0] select_2405;
  assign select_2405 = and_2394 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2406;
  assign sum_2406 = (equal_2290_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2405};
  // hls/stages/census.hpp:388
  logic less_2409;
  assign less_2409 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2410;
  assign less_2410 = x_s3_q[4:0] < 5'h3;
  logic not_2411;
  assign not_2411 = ~x_s3_q[1];
  logic [2:0] select_2412;
  assign select_2412 = x_s3_q[0] ? {1'b0, not_2411, 1'b0} : {x_s3_q[1], 1'b0, not_2411};
  logic [5:0] select_2413;
  assign select_2413 = slot_s3_q[2] ? {select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0], 1'b0} : {1'b0, select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0]};
  logic [11:0] select_2414;
  assign select_2414 = slot_s3_q[1] ? {select_2413[5], 1'b0, select_2413[4], 1'b0, select_2413[3], 1'b0, select_2413[2], 1'b0, select_2413[1], 1'b0, select_2413[0], 1'b0} : {1'b0, select_2413[5], 1'b0, select_2413[4], 1'b0, select_2413[3], 1'b0, select_2413[2], 1'b0, select_2413[1], 1'b0, select_2413[0]};
  logic [23:0] select_2415;
  assign select_2415 = slot_s3_q[0] ? {select_2414[11], 1'b0, select_2414[10], 1'b0, select_2414[9], 1'b0, select_2414[8], 1'b0, select_2414[7], 1'b0, select_2414[6], 1'b0, select_2414[5], 1'b0, select_2414[4], 1'b0, select_2414[3], 1'b0, select_2414[2], 1'b0, select_2414[1], 1'b0, select_2414[0], 1'b0} : {1'b0, select_2414[11], 1'b0, select_2414[10], 1'b0, select_2414[9], 1'b0, select_2414[8], 1'b0, select_2414[7], 1'b0, select_2414[6], 1'b0, select_2414[5], 1'b0, select_2414[4], 1'b0, select_2414[3], 1'b0, select_2414[2], 1'b0, select_2414[1], 1'b0, select_2414[0]};
  // hls/stages/census.hpp:390
  logic and_2419;
  assign and_2419 = less_2410 & (~((sharpness_sums_contrast_1_q & select_2415) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2421;
  assign select_2421 = (less_2409 & and_2419) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2421};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2424;
  assign select_2424 = equal_2408_s3_q ? (less_2409 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2429;
  assign and_2429 = less_2410 & (~((sharpness_sums_contrast_0_q & select_2415) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2431;
  assign select_2431 = (less_2409 & and_2429) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2431};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2434;
  assign select_2434 = equal_2408_s3_q ? (less_2409 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2436;
  assign select_2436 = equal_2408_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2438;
  assign select_2438 = equal_2408_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2440;
  assign select_2440 = equal_2408_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2429} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2442;
  assign select_2442 = equal_2408_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2419} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2447;
  assign select_2447 = so_s3_q ? (equal_2408_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2450;
  assign select_2450 = equal_2408_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2452;
  assign equal_2452 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2456;
  assign select_2456 = (equal_2452 | xor_2453) ? (five_times[0] & xor_2453) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2457;
  assign select_2457 = equal_2408_s3_q ? select_2456 : sharpness_comparing_less_detail_0_q;
  logic select_2458;
  assign select_2458 = so_s3_q ? select_2457 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2459;
  assign xor_2459 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2462;
  assign select_2462 = (equal_2452 | xor_2459) ? (five_times_2[0] & xor_2459) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2463;
  assign select_2463 = equal_2408_s3_q ? select_2462 : sharpness_comparing_less_detail_1_q;
  logic select_2464;
  assign select_2464 = so_s3_q ? select_2463 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2465;
  assign xor_2465 = sharpness_comparing_contrast_0_q[1] ^ and_2419;
  logic select_2468;
  assign select_2468 = (equal_2452 | xor_2465) ? (and_2419 & xor_2465) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2469;
  assign select_2469 = equal_2408_s3_q ? select_2468 : sharpness_comparing_less_contrast_0_q;
  logic select_2470;
  assign select_2470 = so_s3_q ? select_2469 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2471;
  assign xor_2471 = sharpness_comparing_contrast_1_q[1] ^ and_2429;
  logic select_2474;
  assign select_2474 = (equal_2452 | xor_2471) ? (and_2429 & xor_2471) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2475;
  assign select_2475 = equal_2408_s3_q ? select_2474 : sharpness_comparing_less_contrast_1_q;
  logic select_2476;
  assign select_2476 = so_s3_q ? select_2475 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2623;
  assign select_2623 = and_2614_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2621_s3_q});
  // hls/stages/agreement.hpp:798
  logic and_2626;
  assign and_2626 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2006_s3_q));
  logic and_2631;
  assign and_2631 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2011_s3_q));
  logic and_2636;
  assign and_2636 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2022_s3_q));
  // hls/stages/agreement.hpp:1106
  logic [2:0] select_2651;
  assign select_2651 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2652;
  assign difference_2652 = {1'b0, explained_2_s3_q} - {1'b0, select_2651};
  logic [4:0] e;
  assign e = {difference_2652[3], difference_2652} + (equal_571_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic [5:0] sum_2655;
  assign sum_2655 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1118
  logic not_2659;
  assign not_2659 = ~(equal_2084 ? and_2105 : (~({sum_2655, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:798
  logic and_2662;
  assign and_2662 = ends_cell_s3_q & (not_2642_s3_q & (centres_values_1_textured_s3_q & not_2659));
  logic and_2664;
  assign and_2664 = not_577_s3_q & (so_s3_q & and_2662);
  // hls/stages/agreement.hpp:1144
  logic less_2667;
  assign less_2667 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2668;
  assign select_2668 = less_2667 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2671;
  assign select_2671 = less_2667 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1145
  logic [10:0] sum_2672;
  assign sum_2672 = {1'b0, select_2671} + {3'h0, select_2671[9:2]};
  logic and_2674;
  assign and_2674 = (~(select_2668[9:4] == 6'h0)) & ({sum_2672, select_2671[1:0]} < {3'h0, select_2668});
  // hls/stages/agreement.hpp:1154
  logic [9:0] select_2677;
  assign select_2677 = x_s3_q[6] ? (equal_1613_s3_q ? 10'h0 : (and_2674 ? select_2668 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_2678;
  assign select_2678 = equal_576_s3_q ? select_2677 : 10'h0;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2680;
  assign select_2680 = and_2614_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2678});
  logic [13:0] select_2688;
  assign select_2688 = and_2614_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2686_s3_q});
  // hls/stages/agreement.hpp:1122
  logic and_2690;
  assign and_2690 = not_2642_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:798
  logic and_2693;
  assign and_2693 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & and_2690));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2695;
  assign select_2695 = and_2614_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2693});
  // hls/stages/agreement.hpp:1122
  logic and_2697;
  assign and_2697 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2659);
  // hls/stages/agreement.hpp:798
  logic and_2701;
  assign and_2701 = not_577_s3_q & (so_s3_q & (ends_cell_s3_q & (not_2642_s3_q & and_2697)));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2703;
  assign select_2703 = and_2614_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2701});
  logic [13:0] select_2723;
  assign select_2723 = and_2614_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2721_s3_q});
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2800;
  assign select_2800 = so_s3_q ? (equal_1706_s3_q ? (and_2782_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2801;
  assign select_2801 = equal_576_s3_q ? 8'h0 : select_2800;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2803;
  assign select_2803 = and_2781_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2801[7]}}, select_2801});
  // hls/stages/agreement.hpp:798
  logic and_2806;
  assign and_2806 = not_577_s3_q & (so_s3_q & (and_2782_s3_q & equal_1706_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2808;
  assign select_2808 = and_2781_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2806});
  // hls/stages/registration.hpp:107
  logic and_2810;
  assign and_2810 = and_2782_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2812;
  assign select_2812 = so_s3_q ? (equal_1706_s3_q ? {and_2810, and_2782_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2813;
  assign select_2813 = equal_576_s3_q ? 2'h0 : select_2812;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2814;
  assign sum_2814 = registration_half_votes_down_q + {{5{select_2813[1]}}, select_2813};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2820;
  assign select_2820 = so_s3_q ? (equal_1706_s3_q ? {and_2818_s3_q, and_2782_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2821;
  assign select_2821 = equal_576_s3_q ? 2'h0 : select_2820;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2822;
  assign sum_2822 = registration_half_votes_up_q + {{5{select_2821[1]}}, select_2821};
  // hls/stages/registration.hpp:107
  logic and_2825;
  assign and_2825 = and_2782_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2827;
  assign select_2827 = so_s3_q ? (equal_1706_s3_q ? {and_2825, and_2782_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2828;
  assign select_2828 = equal_576_s3_q ? 2'h0 : select_2827;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2829;
  assign sum_2829 = registration_half_half_votes_down_q + {{5{select_2828[1]}}, select_2828};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2834;
  assign select_2834 = so_s3_q ? (equal_1706_s3_q ? {and_2832_s3_q, and_2782_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2835;
  assign select_2835 = equal_576_s3_q ? 2'h0 : select_2834;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2836;
  assign sum_2836 = registration_half_half_votes_up_q + {{5{select_2835[1]}}, select_2835};
  // hls/stages/agreement.hpp:798
  logic and_2869;
  assign and_2869 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & less_1644_s3_q));
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2876;
  assign select_2876 = or_1648_s3_q ? 12'h0 : (equal_2874_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_2879;
  assign select_2879 = x_s3_q[6] ? (equal_1613_s3_q ? 12'h0 : (less_1644_s3_q ? select_2876 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2880;
  assign select_2880 = equal_576_s3_q ? select_2879 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2881;
  assign and_2881 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1154
  logic and_2884;
  assign and_2884 = not_1993_s3_q & (less_1644_s3_q & ({and_2881, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:798
  logic and_2886;
  assign and_2886 = equal_576_s3_q & (x_s3_q[6] & and_2884);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2888;
  assign sum_2888 = {{2{select_2880[11]}}, select_2880} + (and_2886 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2891;
  assign select_2891 = or_1648_s3_q ? 12'h0 : (equal_2874_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_2894;
  assign select_2894 = x_s3_q[6] ? (equal_1613_s3_q ? 12'h0 : (less_1644_s3_q ? select_2891 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2895;
  assign select_2895 = equal_576_s3_q ? select_2894 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2897;
  assign sum_2897 = {{2{select_2895[11]}}, select_2895} + (and_2886 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2899;
  assign not_2899 = ~all_s3_q;
  // hls/stages/agreement.hpp:1154
  logic and_2902;
  assign and_2902 = not_1993_s3_q & (less_1644_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2899, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_2908;
  assign and_2908 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2909;
  assign not_2909 = ~and_2908;
  logic less_2910;
  assign less_2910 = $signed({9'h1, {2{not_2909}}, and_2908}) < $signed(registration_up_q[13:2]);
  logic select_2911;
  assign select_2911 = (equal_576_s3_q & (x_s3_q[6] & and_2902)) ? less_2910 : registration_enough_q;
  // hls/stages/agreement.hpp:1154
  logic and_2915;
  assign and_2915 = x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_2916;
  assign and_2916 = equal_576_s3_q & and_2915;
  // hls/stages/registration.hpp:242
  logic less_2917;
  assign less_2917 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2919;
  assign less_2919 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2921;
  assign equal_2921 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_2925;
  assign and_2925 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & equal_2921)));
  // hls/stages/agreement.hpp:1154
  logic and_2932;
  assign and_2932 = x_s3_q[6] & (not_1993_s3_q & (less_1644_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2935;
  assign equal_2935 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1154
  logic and_2938;
  assign and_2938 = not_1993_s3_q & (less_1644_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2935));
  // hls/stages/registration.hpp:244
  logic and_2942;
  assign and_2942 = (equal_576_s3_q & (x_s3_q[6] & and_2938)) & (less_2919 | less_2917);
  // hls/stages/agreement.hpp:1154
  logic and_2947;
  assign and_2947 = not_1993_s3_q & (less_1644_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2935)));
  // hls/stages/registration.hpp:244
  logic and_2950;
  assign and_2950 = registration_votes_up_q & registration_other_down_q;
  logic select_2952;
  assign select_2952 = registration_votes_down_q ? (registration_other_up_q | and_2950) : and_2950;
  // hls/stages/registration.hpp:138
  logic and_2954;
  assign and_2954 = (equal_576_s3_q & (x_s3_q[6] & and_2947)) & (registration_other_enough_q & select_2952);
  // hls/stages/registration.hpp:245
  logic or_2957;
  assign or_2957 = registration_moved_q | (registration_enough_q & (and_2942 | and_2954));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3040;
  assign select_3040 = sample_pair_whole_s3_q ? (equal_1696_s3_q ? patches_place_0_slope_q : select_1802[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3045;
  assign select_3045 = sample_pair_whole_s3_q ? (equal_1696_s3_q ? patches_place_1_slope_q : select_1830[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3047;
  assign select_3047 = equal_1696_s3_q ? patches_valid_0_q : (select_1695_s3_q ? patches_valid_0_q : select_1798[0]);
  // hls/stages/agreement.hpp:277
  logic select_3050;
  assign select_3050 = sample_pair_whole_s3_q ? (and_1821 ? (sample_present_s3_q & select_3047) : select_3047) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3052;
  assign select_3052 = equal_1696_s3_q ? patches_valid_1_q : (select_1695_s3_q ? select_1798[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3055;
  assign select_3055 = sample_pair_whole_s3_q ? (and_1840 ? (sample_present_s3_q & select_3052) : select_3052) : patches_valid_1_q;
  logic [5:0] select_3058;
  assign select_3058 = sample_pair_whole_s3_q ? (select_1819[5] ? {1'b1, select_1819[4:0]} : (select_1819 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3061;
  assign select_3061 = sample_pair_whole_s3_q ? (select_1838[5] ? {1'b1, select_1838[4:0]} : (select_1838 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3064;
  assign select_3064 = sample_pair_whole_s3_q ? (select_1851[4] ? {1'b1, select_1851[3:0]} : (select_1851 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3067;
  assign select_3067 = sample_pair_whole_s3_q ? (select_1856[4] ? {1'b1, select_1856[3:0]} : (select_1856 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3486_s3_q, parity_3482_s3_q, xor_3470_s3_q, parity_3442_s3_q, parity_3380_s3_q, parity_3251_s3_q} + (equal_3487_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3491;
  assign select_3491 = equal_1782_s3_q ? patches_sums_values_0_q : (equal_1784_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3492;
  assign select_3492 = equal_1784_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1784_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3496;
  assign select_3496 = equal_1784_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3498;
  assign select_3498 = equal_1784_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3500;
  assign select_3500 = equal_1784_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3502;
  assign select_3502 = equal_1784_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3504;
  assign select_3504 = equal_1784_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3506;
  assign select_3506 = equal_1784_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3508;
  assign select_3508 = equal_1784_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3510;
  assign select_3510 = equal_1784_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3512;
  assign select_3512 = equal_1784_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3514;
  assign select_3514 = equal_1784_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3516;
  assign select_3516 = equal_1784_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3518;
  assign select_3518 = equal_1784_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3520;
  assign select_3520 = equal_1784_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3522;
  assign select_3522 = equal_1784_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_3593;
  assign difference_3593 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_3596;
  assign and_3596 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_3593, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_3599;
  assign not_3599 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_3602;
  assign and_3602 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_3596 & ((10'h38 < patches_peak_size_q) & not_3599));
  // hls/stages/patches.hpp:190
  logic and_3604;
  assign and_3604 = and_3587_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_3602);
  // hls/stages/patches.hpp:667
  logic not_3605;
  assign not_3605 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_3607;
  assign and_3607 = and_3604 & (not_1789_s3_q & not_3605);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3609;
  assign sum_3609 = {7'h0, and_3607} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3613;
  assign sum_3613 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3612_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_3620;
  assign not_3620 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3621;
  assign sum_3621 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3623;
  assign not_3623 = ~({eight, 3'h0} < {1'b0, sum_3621, fall_2[0]});
  logic [1:0] sum_3624;
  assign sum_3624 = {1'b0, not_3620} + {1'b0, not_3623};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3625;
  assign sum_3625 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3627;
  assign not_3627 = ~({eight, 3'h0} < {sum_3625, fall_2[1:0]});
  logic not_3630;
  assign not_3630 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3631;
  assign sum_3631 = {1'b0, not_3627} + {1'b0, not_3630};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3624} + {1'b0, sum_3631};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3634;
  assign select_3634 = less_3612_s3_q ? ({sum_3613, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_3613, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3635;
  assign select_3635 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_3636;
  assign select_3636 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3637;
  assign sum_3637 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_3638;
  assign sum_3638 = {select_3636[5], select_3636} + {{3{sum_3637[3]}}, sum_3637};
  // hls/stages/patches.hpp:604
  logic [17:0] product_3639;
  assign product_3639 = $signed({{10{select_3635[7]}}, select_3635}) * $signed({{8{sum_3638[6]}}, sum_3638, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_3640;
  assign difference_3640 = {{6{select_3634[7]}}, select_3634} - {product_3639[17], product_3639[17:5]};
  // hls/stages/patches.hpp:611
  logic less_3641;
  assign less_3641 = $signed({{7{difference_3611[6]}}, difference_3611}) < $signed(difference_3640);
  // hls/stages/patches.hpp:189
  logic not_3642;
  assign not_3642 = ~less_3641;
  // hls/stages/patches.hpp:670
  logic and_3643;
  assign and_3643 = not_3642 & and_3607;
  logic [7:0] sum_3644;
  assign sum_3644 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3643};
  // hls/stages/patches.hpp:189
  logic not_3647;
  assign not_3647 = ~($signed(difference_3640) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_3648;
  assign and_3648 = not_3647 & and_3607;
  logic [7:0] sum_3649;
  assign sum_3649 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3648};
  // hls/stages/patches.hpp:192
  logic and_3651;
  assign and_3651 = and_3604 & (patches_second_s3_q & not_3605);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3653;
  assign sum_3653 = {7'h0, and_3651} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3655;
  assign and_3655 = not_3642 & and_3651;
  logic [7:0] sum_3656;
  assign sum_3656 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3655};
  // hls/stages/patches.hpp:671
  logic and_3658;
  assign and_3658 = not_3647 & and_3651;
  logic [7:0] sum_3659;
  assign sum_3659 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3658};
  // hls/stages/patches.hpp:192
  logic and_3661;
  assign and_3661 = and_3604 & (patches_lower_s3_q & not_1789_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3663;
  assign sum_3663 = {7'h0, and_3661} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3665;
  assign and_3665 = not_3642 & and_3661;
  logic [7:0] sum_3666;
  assign sum_3666 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3665};
  // hls/stages/patches.hpp:671
  logic and_3668;
  assign and_3668 = not_3647 & and_3661;
  logic [7:0] sum_3669;
  assign sum_3669 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3668};
  // hls/stages/patches.hpp:192
  logic and_3671;
  assign and_3671 = and_3604 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3673;
  assign sum_3673 = {7'h0, and_3671} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3675;
  assign and_3675 = not_3642 & and_3671;
  logic [7:0] sum_3676;
  assign sum_3676 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3675};
  // hls/stages/patches.hpp:671
  logic and_3678;
  assign and_3678 = not_3647 & and_3671;
  logic [7:0] sum_3679;
  assign sum_3679 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3678};
  // hls/stages/agreement.hpp:1235
  logic equal_3680;
  assign equal_3680 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1142
  logic less_3681;
  assign less_3681 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_3685;
  assign and_3685 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (equal_3680 & less_3681)));
  // hls/stages/agreement.hpp:1154
  logic and_3690;
  assign and_3690 = x_s3_q[6] & (not_1993_s3_q & (less_3681 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:798
  logic and_3691;
  assign and_3691 = equal_576_s3_q & and_3690;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3693;
  assign or_3693 = (and_3685 ? patches_quarters_0_places_q : 8'h0) | (and_3691 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1154
  logic and_3697;
  assign and_3697 = x_s3_q[6] & (not_1993_s3_q & (less_3681 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:798
  logic and_3698;
  assign and_3698 = equal_576_s3_q & and_3697;
  // hls/stages/agreement.hpp:1154
  logic and_3704;
  assign and_3704 = x_s3_q[6] & (not_1993_s3_q & (less_3681 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:798
  logic and_3705;
  assign and_3705 = equal_576_s3_q & and_3704;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3707;
  assign or_3707 = (or_3693 | (and_3698 ? patches_quarters_2_places_q : 8'h0)) | (and_3705 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_3711;
  assign select_3711 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:798
  logic and_3715;
  assign and_3715 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (less_3681 & select_3711)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_3717;
  assign select_3717 = and_3685 ? (and_3715 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3719;
  assign select_3719 = and_3691 ? (and_3715 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3722;
  assign select_3722 = and_3698 ? (and_3715 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3725;
  assign select_3725 = and_3705 ? (and_3715 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3728;
  assign select_3728 = and_3685 ? (and_3715 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3730;
  assign select_3730 = and_3691 ? (and_3715 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3733;
  assign select_3733 = and_3698 ? (and_3715 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3736;
  assign select_3736 = and_3705 ? (and_3715 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3738;
  assign sum_3738 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1154
  logic and_3742;
  assign and_3742 = x_s3_q[6] & (not_1993_s3_q & (less_3681 & (sum_3738[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_3743;
  assign and_3743 = equal_576_s3_q & and_3742;
  // hls/stages/patches.hpp:630
  logic [7:0] select_3746;
  assign select_3746 = and_3743 ? (patches_word_places_q + (and_3691 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3749;
  assign select_3749 = and_3743 ? (patches_word_up_q + (and_3691 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3752;
  assign select_3752 = and_3743 ? (patches_word_down_q + (and_3691 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3755;
  assign select_3755 = ($signed(difference_3640[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3640[5:0];
  logic [5:0] select_3756;
  assign select_3756 = ($signed(14'h10) < $signed(difference_3640)) ? 6'h10 : select_3755;
  // hls/stages/patches.hpp:673
  logic [5:0] select_3757;
  assign select_3757 = and_3604 ? select_3756 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_3759;
  assign select_3759 = patches_round_ends_q ? {{6{select_3757[5]}}, select_3757} : (patches_across_q + {{6{select_3757[5]}}, select_3757});
  // hls/stages/agreement.hpp:798
  logic and_3763;
  assign and_3763 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q & (equal_2921 & less_3681)));
  // hls/stages/agreement.hpp:1154
  logic and_3767;
  assign and_3767 = x_s3_q[6] & (not_1993_s3_q & (less_3681 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_3768;
  assign and_3768 = equal_576_s3_q & and_3767;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3770;
  assign select_3770 = and_3763 ? (and_3768 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3774;
  assign or_3774 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3777;
  assign or_3777 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3778;
  assign sum_3778 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3780;
  assign select_3780 = and_3763 ? (and_3768 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3783;
  assign and_3783 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3785;
  assign select_3785 = and_3768 ? {and_3783, patches_found_q[2:1]} : (and_3763 ? {and_3783, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_3789;
  assign or_3789 = patches_partly_q | (patches_doubted_q & (~and_3768));
  // hls/stages/patches.hpp:656
  logic select_3792;
  assign select_3792 = and_3763 ? (and_3768 ? or_3789 : (and_3763 ? or_3789 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_3793;
  assign select_3793 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3797;
  assign select_3797 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_3799;
  assign sum_3799 = {sum_3638[6], sum_3638, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_3801;
  assign and_3801 = ({{5{sum_3799[10]}}, sum_3799} < 16'h3) & and_3604;
  logic [7:0] sum_3802;
  assign sum_3802 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3801};
  // hls/stages/patches.hpp:663
  logic [12:0] product_3807;
  assign product_3807 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_3770};
  // hls/stages/patches.hpp:192
  logic and_3809;
  assign and_3809 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3807[12:5] < patches_on_skin_q);
  logic select_3814;
  assign select_3814 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3818;
  assign or_3818 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3825;
  assign select_3825 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3831;
  assign and_3831 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3832;
  assign sum_3832 = patches_age_q + {9'h0, and_3831};
  logic [9:0] select_3835;
  assign select_3835 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3832)) : sum_3832;
  // hls/stages/agreement.hpp:1200
  logic or_3893;
  assign or_3893 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1229
  logic equal_3895;
  assign equal_3895 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1238
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1239
  logic select_3901;
  assign select_3901 = (equal_3895 & equal_3680) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1147
  logic [10:0] sum_3904;
  assign sum_3904 = {1'b0, select_2671} + {2'h0, select_2671[9:1]};
  logic select_3907;
  assign select_3907 = (select_2668[9:3] == 7'h0) ? ((~or_3893) & (~select_3901)) : (~({sum_3904, select_2671[0]} < {2'h0, select_2668}));
  // hls/stages/agreement.hpp:1154
  logic [47:0] select_3909;
  assign select_3909 = x_s3_q[6] ? (equal_1613_s3_q ? good_q : {select_3907, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic select_3914;
  assign select_3914 = equal_576_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3912_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1229
  logic equal_3915;
  assign equal_3915 = x_s3_q[6:3] == 4'ha;
  logic equal_3917;
  assign equal_3917 = x_s3_q[6:3] == 4'hc;
  logic equal_3918;
  assign equal_3918 = x_s3_q[6:3] == 4'hb;
  logic equal_3919;
  assign equal_3919 = x_s3_q[6:3] == 4'h9;
  logic equal_3920;
  assign equal_3920 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_3922;
  assign select_3922 = equal_3919 ? counts_skin_unproven_q : (equal_3920 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3924;
  assign select_3924 = equal_3918 ? counts_regions_bad_q : (equal_3915 ? counts_nearer_q : select_3922);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3917 ? counts_on_skin_q : select_3924;
  // hls/stages/agreement.hpp:1234
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1242
  logic select_3927;
  assign select_3927 = (equal_3915 & equal_3680) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1160
  logic not_3928;
  assign not_3928 = ~hidden_for_q[7];
  logic [7:0] select_3930;
  assign select_3930 = select_3927 ? (hidden_for_q + {7'h0, not_3928}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3932;
  assign select_3932 = equal_576_s3_q ? (equal_3912_s3_q ? select_3930 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1243
  logic [13:0] select_3933;
  assign select_3933 = equal_3680 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1137
  logic [7:0] select_3935;
  assign select_3935 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3937;
  assign select_3937 = equal_3920 ? cfg_unproven_skin_limit_i : (equal_3895 ? cfg_unproven_limit_i : select_3935);
  logic [7:0] select_3939;
  assign select_3939 = equal_3915 ? cfg_regions_limit_i : (equal_3919 ? cfg_hidden_limit_i : select_3937);
  logic [7:0] limit;
  assign limit = equal_3917 ? cfg_regions_limit_i : (equal_3918 ? {cfg_on_skin_limit_i, 3'h0} : select_3939);
  // hls/stages/agreement.hpp:1243
  logic not_3942;
  assign not_3942 = ~x_s3_q[2];
  logic [3:0] select_3943;
  assign select_3943 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3942, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3942};
  logic [7:0] select_3944;
  assign select_3944 = x_s3_q[0] ? {select_3943[3], 1'b0, select_3943[2], 1'b0, select_3943[1], 1'b0, select_3943[0], 1'b0} : {1'b0, select_3943[3], 1'b0, select_3943[2], 1'b0, select_3943[1], 1'b0, select_3943[0]};
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_3948;
  assign select_3948 = equal_3919 ? counts_skin_supervised_q : (equal_3920 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3950;
  assign select_3950 = equal_3918 ? counts_skin_textured_q : (equal_3915 ? counts_textured_q : select_3948);
  logic [13:0] of;
  assign of = equal_3917 ? counts_textured_q : select_3950;
  // hls/stages/agreement.hpp:1243
  logic [13:0] select_3952;
  assign select_3952 = ((limit & select_3944) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3933} + {1'b0, select_3952};
  // hls/stages/agreement.hpp:798
  logic select_3957;
  assign select_3957 = equal_576_s3_q ? (equal_3680 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1240
  logic and_3962;
  assign and_3962 = too_much_q & (~(equal_3920 & equal_3680));
  // hls/stages/agreement.hpp:1241
  logic select_3967;
  assign select_3967 = (over[14] & equal_3680) ? (and_3962 | ((equal_3920 | equal_3919) | (x_s3_q[6:3] == 4'hf))) : and_3962;
  // hls/stages/agreement.hpp:1137
  logic and_3972;
  assign and_3972 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1243
  logic select_3973;
  assign select_3973 = (equal_3917 & equal_3680) ? and_3972 : overlooks_q;
  // hls/stages/agreement.hpp:798
  logic [2:0] select_3975;
  assign select_3975 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3977;
  assign select_3977 = equal_576_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_3975 : box_textured_columns_values_0_q);
  logic [2:0] select_3978;
  assign select_3978 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3980;
  assign select_3980 = equal_576_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3978 : box_textured_columns_values_1_q);
  logic [2:0] select_3981;
  assign select_3981 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3983;
  assign select_3983 = equal_576_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3981 : box_textured_columns_values_2_q);
  logic [2:0] select_3984;
  assign select_3984 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3986;
  assign select_3986 = equal_576_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3984 : box_textured_columns_values_3_q);
  logic [2:0] select_3987;
  assign select_3987 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3989;
  assign select_3989 = equal_576_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3987 : box_textured_columns_values_4_q);
  logic [4:0] select_3991;
  assign select_3991 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3993;
  assign select_3993 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3995;
  assign select_3995 = equal_576_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_3993 : box_explained_columns_values_0_q);
  logic [2:0] select_3996;
  assign select_3996 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3998;
  assign select_3998 = equal_576_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3996 : box_explained_columns_values_1_q);
  logic [2:0] select_3999;
  assign select_3999 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4001;
  assign select_4001 = equal_576_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3999 : box_explained_columns_values_2_q);
  logic [2:0] select_4002;
  assign select_4002 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4004;
  assign select_4004 = equal_576_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4002 : box_explained_columns_values_3_q);
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_576_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4005 : box_explained_columns_values_4_q);
  logic [4:0] select_4009;
  assign select_4009 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4012;
  assign select_4012 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_576_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4014 : box_shown_columns_values_1_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_576_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4017 : box_shown_columns_values_2_q);
  logic [2:0] select_4020;
  assign select_4020 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4022;
  assign select_4022 = equal_576_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4020 : box_shown_columns_values_3_q);
  logic [2:0] select_4023;
  assign select_4023 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4025;
  assign select_4025 = equal_576_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4023 : box_shown_columns_values_4_q);
  logic [4:0] select_4027;
  assign select_4027 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4030;
  assign select_4030 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_576_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4032 : box_nearer_columns_values_1_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_576_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4035 : box_nearer_columns_values_2_q);
  logic [2:0] select_4038;
  assign select_4038 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4040;
  assign select_4040 = equal_576_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4038 : box_nearer_columns_values_3_q);
  logic [2:0] select_4041;
  assign select_4041 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4043;
  assign select_4043 = equal_576_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4041 : box_nearer_columns_values_4_q);
  logic [4:0] select_4045;
  assign select_4045 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1321
  logic [1:0] select_4135;
  assign select_4135 = and_4134_s3_q ? {and_2135, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4139;
  assign select_4139 = and_2061_s3_q ? (less_2062_s3_q ? (select_4135[0] & and_4136_s3_q) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:279
  logic select_4141;
  assign select_4141 = left_first_s3_q ? select_4139 : (and_1974_s3_q ? select_4139 : seen_q);
  logic select_4142;
  assign select_4142 = and_1974_s3_q ? select_4141 : seen_q;
  // hls/stages/agreement.hpp:443
  logic select_4145;
  assign select_4145 = and_2061_s3_q ? (less_2062_s3_q ? (select_4135[1] & and_4136_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:279
  logic select_4147;
  assign select_4147 = left_first_s3_q ? select_4145 : (and_1974_s3_q ? select_4145 : nearer_q);
  logic select_4148;
  assign select_4148 = and_1974_s3_q ? select_4147 : nearer_q;
  // hls/stages/agreement.hpp:1251
  logic or_4155;
  assign or_4155 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4154_s3_q;
  // hls/stages/agreement.hpp:1253
  logic not_4163;
  assign not_4163 = ~(or_3893 | not_2360);
  // hls/stages/agreement.hpp:798
  logic and_4167;
  assign and_4167 = equal_576_s3_q & (equal_3912_s3_q & (not_4163 & (select_3901 | select_3967)));
  logic and_4170;
  assign and_4170 = equal_3912_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1162
  logic or_4174;
  assign or_4174 = select_2458 | (select_2470 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:798
  logic and_4181;
  assign and_4181 = equal_576_s3_q & (equal_3912_s3_q & (not_4163 & (select_2464 | select_2476)));
  // hls/stages/agreement.hpp:1162
  logic and_4186;
  assign and_4186 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3930 < cfg_hidden_frames_i));
  logic select_4192;
  assign select_4192 = (not_2360 | (select_3973 & not_3804)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:798
  logic and_4197;
  assign and_4197 = equal_576_s3_q & (equal_3912_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4201;
  assign and_4201 = equal_576_s3_q & (x_s3_q[6] & (not_1993_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1152
  logic [31:0] select_4209;
  assign select_4209 = equal_1635_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4207_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4210;
  assign select_4210 = equal_1633_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4209;
  logic [31:0] select_4211;
  assign select_4211 = equal_1631_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4210;
  logic [31:0] select_4212;
  assign select_4212 = equal_1629_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4211;
  logic [31:0] select_4213;
  assign select_4213 = equal_1627_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4212;
  logic [31:0] select_4214;
  assign select_4214 = equal_1625_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4213;
  logic [31:0] select_4215;
  assign select_4215 = equal_1623_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4214;
  logic [31:0] select_4216;
  assign select_4216 = equal_1621_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4215;
  // hls/stages/agreement.hpp:1150
  logic [9:0] select_4217;
  assign select_4217 = less_2667 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1154
  logic [31:0] select_4218;
  assign select_4218 = equal_1613_s3_q ? select_4216 : {2'h0, select_4217, select_2671, select_2668};

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
  assign regions_we = s3_en & and_2027_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2026, sum_2015, sum_2010};
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
  assign map_waddr = sum_2071_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2147_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2135, is_seen};
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
      census_left_misses_q <= select_2299;
      sharpness_before_last_mask_q <= select_2372;
      sharpness_sums_detail_0_q <= and_551_s3_q ? select_2386 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_551_s3_q ? select_2398 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_551_s3_q ? sum_2402 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_551_s3_q ? sum_2406 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2424 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2434 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2436 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2438 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2440 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2442 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2447;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2450 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2458;
      sharpness_comparing_less_detail_1_q <= select_2464;
      sharpness_comparing_less_contrast_0_q <= select_2470;
      sharpness_comparing_less_contrast_1_q <= select_2476;
      counts_supervised_q <= select_2623;
      counts_textured_q <= and_2614_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2626});
      counts_explained_q <= and_2614_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2631});
      counts_nearer_q <= and_2614_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2636});
      counts_unproven_q <= and_2614_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2664});
      counts_regions_bad_q <= select_2680;
      counts_skin_supervised_q <= select_2688;
      counts_skin_textured_q <= select_2695;
      counts_skin_unproven_q <= select_2703;
      counts_on_skin_q <= select_2723;
      registration_half_across_q <= select_2803;
      registration_half_measured_q <= select_2808;
      registration_half_votes_down_q <= and_2781_s3_q ? 7'h0 : sum_2814;
      registration_half_votes_up_q <= and_2781_s3_q ? 7'h0 : sum_2822;
      registration_half_half_votes_down_q <= and_2781_s3_q ? 7'h0 : sum_2829;
      registration_half_half_votes_up_q <= and_2781_s3_q ? 7'h0 : sum_2836;
      registration_down_q <= and_2869 ? sum_2888 : registration_down_q;
      registration_up_q <= and_2869 ? sum_2897 : registration_up_q;
      registration_enough_q <= select_2911;
      registration_votes_down_q <= and_2916 ? less_2917 : registration_votes_down_q;
      registration_votes_up_q <= and_2916 ? less_2919 : registration_votes_up_q;
      registration_other_enough_q <= and_2925 ? select_2911 : registration_other_enough_q;
      registration_other_down_q <= and_2925 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2925 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_576_s3_q & and_2932)) & or_2957;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1800 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1803 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1804 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3040;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1829 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1831 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1832 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3045;
      patches_valid_0_q <= select_3050;
      patches_valid_1_q <= select_3055;
      patches_right_next_0_q <= select_3058;
      patches_right_next_1_q <= select_3061;
      patches_left_next_0_q <= select_3064;
      patches_left_next_1_q <= select_3067;
      patches_sums_values_0_q <= select_3491;
      patches_sums_values_1_q <= equal_1782_s3_q ? patches_sums_values_1_q : select_3492;
      patches_sums_values_2_q <= equal_1782_s3_q ? patches_sums_values_2_q : select_3494;
      patches_sums_values_3_q <= equal_1782_s3_q ? patches_sums_values_3_q : select_3496;
      patches_sums_values_4_q <= equal_1782_s3_q ? patches_sums_values_4_q : select_3498;
      patches_sums_values_5_q <= equal_1782_s3_q ? patches_sums_values_5_q : select_3500;
      patches_sums_values_6_q <= equal_1782_s3_q ? patches_sums_values_6_q : select_3502;
      patches_sums_values_7_q <= equal_1782_s3_q ? patches_sums_values_7_q : select_3504;
      patches_sums_values_8_q <= equal_1782_s3_q ? patches_sums_values_8_q : select_3506;
      patches_sums_values_9_q <= equal_1782_s3_q ? patches_sums_values_9_q : select_3508;
      patches_sums_values_10_q <= equal_1782_s3_q ? patches_sums_values_10_q : select_3510;
      patches_sums_values_11_q <= equal_1782_s3_q ? patches_sums_values_11_q : select_3512;
      patches_sums_values_12_q <= equal_1782_s3_q ? patches_sums_values_12_q : select_3514;
      patches_sums_values_13_q <= equal_1782_s3_q ? patches_sums_values_13_q : select_3516;
      patches_sums_values_14_q <= equal_1782_s3_q ? patches_sums_values_14_q : select_3518;
      patches_sums_values_15_q <= equal_1782_s3_q ? patches_sums_values_15_q : select_3520;
      patches_sums_values_16_q <= equal_1782_s3_q ? patches_sums_values_16_q : select_3522;
      patches_best_differing_q <= select_1981[9:0];
      patches_best_column_q <= select_1981[14:10];
      patches_quarters_0_places_q <= sum_3609;
      patches_quarters_0_up_q <= sum_3644;
      patches_quarters_0_down_q <= sum_3649;
      patches_quarters_1_places_q <= sum_3653;
      patches_quarters_1_up_q <= sum_3656;
      patches_quarters_1_down_q <= sum_3659;
      patches_quarters_2_places_q <= sum_3663;
      patches_quarters_2_up_q <= sum_3666;
      patches_quarters_2_down_q <= sum_3669;
      patches_quarters_3_places_q <= sum_3673;
      patches_quarters_3_up_q <= sum_3676;
      patches_quarters_3_down_q <= sum_3679;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_3707;
      patches_word_up_q <= ((select_3717 | select_3719) | select_3722) | select_3725;
      patches_word_down_q <= ((select_3728 | select_3730) | select_3733) | select_3736;
      patches_sum_places_q <= select_3746;
      patches_sum_up_q <= select_3749;
      patches_sum_down_q <= select_3752;
      patches_across_q <= select_3759;
      patches_places_q <= select_3770;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3774;
      patches_partly_q <= or_3777;
      patches_clear_limit_q <= sum_3778[8:2];
      patches_complete_q <= select_3780;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3763 ? select_3785 : patches_found_q;
      patches_doubted_q <= select_3792;
      patches_doubted_before_q <= select_3793;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3797;
      patches_on_skin_q <= sum_3802;
      patches_large_q <= not_3804 & and_3809;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3814;
      patches_spoiled_q <= or_3818;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3825;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3835;
      segment_textured_q <= select_2007 + {5'h0, and_2626};
      segment_explained_q <= select_2012 + {5'h0, and_2631};
      segment_nearer_q <= select_2023 + {5'h0, and_2636};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_576_s3_q ? select_3909 : good_q;
      good_known_q <= select_3914;
      hidden_for_q <= select_3932;
      product_q <= equal_576_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3957;
      disagree_q <= equal_576_s3_q ? select_3901 : disagree_q;
      too_much_q <= equal_576_s3_q ? select_3967 : too_much_q;
      hides_q <= equal_576_s3_q ? select_3927 : hides_q;
      overlooks_q <= equal_576_s3_q ? select_3973 : overlooks_q;
      seen_q <= select_4142;
      nearer_q <= select_4148;
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
      averager_quarter_1_0_q <= select_2173;
      averager_quarter_1_1_q <= select_2175;
      averager_quarter_2_0_q <= select_2177;
      averager_quarter_2_1_q <= select_2179;
      averager_detail_0_q <= select_2191;
      averager_detail_1_q <= select_2199;
      census_changes_values_0_left_q <= and_551_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_551_s3_q ? sum_2283 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2285;
      census_changes_values_1_right_q <= select_2286;
      census_changes_values_2_left_q <= select_2287;
      census_changes_values_2_right_q <= select_2288;
      sharpness_last_mask_q <= and_551_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_551_s3_q ? select_2369[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_551_s3_q ? select_2369[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3977;
      box_textured_columns_values_1_q <= select_3980;
      box_textured_columns_values_2_q <= select_3983;
      box_textured_columns_values_3_q <= select_3986;
      box_textured_columns_values_4_q <= select_3989;
      box_textured_sum_sums_values_0_q <= equal_576_s3_q ? box_textured_sum_sums_values_0_q : select_3991;
      box_explained_columns_values_0_q <= select_3995;
      box_explained_columns_values_1_q <= select_3998;
      box_explained_columns_values_2_q <= select_4001;
      box_explained_columns_values_3_q <= select_4004;
      box_explained_columns_values_4_q <= select_4007;
      box_explained_sum_sums_values_0_q <= equal_576_s3_q ? box_explained_sum_sums_values_0_q : select_4009;
      box_shown_columns_values_0_q <= equal_576_s3_q ? box_shown_columns_values_0_q : select_4012;
      box_shown_columns_values_1_q <= select_4016;
      box_shown_columns_values_2_q <= select_4019;
      box_shown_columns_values_3_q <= select_4022;
      box_shown_columns_values_4_q <= select_4025;
      box_shown_sum_sums_values_0_q <= equal_576_s3_q ? box_shown_sum_sums_values_0_q : select_4027;
      box_nearer_columns_values_0_q <= equal_576_s3_q ? box_nearer_columns_values_0_q : select_4030;
      box_nearer_columns_values_1_q <= select_4034;
      box_nearer_columns_values_2_q <= select_4037;
      box_nearer_columns_values_3_q <= select_4040;
      box_nearer_columns_values_4_q <= select_4043;
      box_nearer_sum_sums_values_0_q <= equal_576_s3_q ? box_nearer_sum_sums_values_0_q : select_4045;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4086_s4_q;
  logic or_4149_s4_q;
  logic and_4150_s4_q;
  logic and_4158_s4_q;
  logic and_4161_s4_q;
  logic and_4167_s4_q;
  logic and_4171_s4_q;
  logic and_4177_s4_q;
  logic and_4181_s4_q;
  logic and_4189_s4_q;
  logic and_4194_s4_q;
  logic and_4197_s4_q;
  logic and_4201_s4_q;
  logic [5:0] select_4203_s4_q;
  logic [31:0] select_4220_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4086_s4_q <= and_4086_s3_q;
      or_4149_s4_q <= not_2360 | select_4142;
      and_4150_s4_q <= cfg_prove_i & select_4148;
      and_4158_s4_q <= equal_576_s3_q & (equal_3912_s3_q & (cfg_prove_i & or_4155));
      and_4161_s4_q <= equal_576_s3_q & (equal_3912_s3_q & (cfg_prove_i & or_3893));
      and_4167_s4_q <= and_4167;
      and_4171_s4_q <= equal_576_s3_q & and_4170;
      and_4177_s4_q <= equal_576_s3_q & (equal_3912_s3_q & (not_4163 & or_4174));
      and_4181_s4_q <= and_4181;
      and_4189_s4_q <= equal_576_s3_q & (equal_3912_s3_q & (cfg_prove_i & and_4186));
      and_4194_s4_q <= equal_576_s3_q & (equal_3912_s3_q & select_4192);
      and_4197_s4_q <= and_4197;
      and_4201_s4_q <= and_4201;
      select_4203_s4_q <= equal_576_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4220_s4_q <= equal_576_s3_q ? (x_s3_q[6] ? select_4218 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4149_s4_q;
  assign marks_nearer_o = and_4150_s4_q;
  assign verdict_valid_o = and_4086_s4_q;
  assign verdict_unproven_yet_o = and_4158_s4_q;
  assign verdict_untextured_o = and_4161_s4_q;
  assign verdict_disagree_o = and_4167_s4_q;
  assign verdict_moved_o = and_4171_s4_q;
  assign verdict_unsharp_left_o = and_4177_s4_q;
  assign verdict_unsharp_right_o = and_4181_s4_q;
  assign verdict_hidden_o = and_4189_s4_q;
  assign verdict_overlooked_o = and_4194_s4_q;
  assign verdict_out_of_step_o = and_4197_s4_q;
  assign frame_valid_o = and_4201_s4_q;
  assign frame_index_o = select_4203_s4_q;
  assign frame_word_o = select_4220_s4_q;
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
  assign unused_bits = ^{over[13:0], sum_3843[6:0], product_3807[4:0], sum_3778[1:0], sum_3738[1:0], product_3639[4:0], sum_2771[0], difference_2709[1:0], detail_4[1:0], detail_3[1:0], sum_2293[4:0], sum_1720[0], sum_1716[0], sum_736[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
