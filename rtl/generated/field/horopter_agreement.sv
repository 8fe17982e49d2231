// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3087 bits, pipeline 849 bits, memories 66527 bits.
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
  logic not_2331;
  assign not_2331 = ~cfg_prove_i;
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_2544;
  assign sum_2544 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3604;
  assign difference_3604 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3818;
  assign not_3818 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3875;
  assign difference_3875 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4122;
  assign less_4122 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4123;
  assign sum_4123 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4124;
  assign select_4124 = less_4122 ? {sum_4123, cfg_height_i[5:3]} : 8'h0;

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
  // hls/stages/census.hpp:36
  logic [2:0] select_509;
  assign select_509 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_511;
  assign select_511 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [7:0] select_514;
  assign select_514 = ({select_511, select_509} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:117
  logic [7:0] select_515;
  assign select_515 = select_509[0] ? averager_place_q : select_514;
  // hls/stages/census.hpp:42
  logic or_516;
  assign or_516 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_519;
  assign and_519 = (select_509[0] & or_516) & (select_515 < 8'hbd);
  // hls/stages/census.hpp:42
  logic [2:0] select_524;
  assign select_524 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_511 : 6'h0;
  // hls/stages/census.hpp:51
  logic equal_541;
  assign equal_541 = select_509 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_542;
  assign equal_542 = select_524 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_543;
  assign and_543 = equal_542 & and_519;
  // hls/stages/agreement.hpp:276
  logic and_545;
  assign and_545 = sample_pair_whole_q & (equal_541 & and_543);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:624
  logic equal_574;
  assign equal_574 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:595
  logic or_575;
  assign or_575 = so | equal_574;
  // hls/stages/agreement.hpp:593
  logic [7:0] sum_576;
  assign sum_576 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:595
  logic [7:0] select_577;
  assign select_577 = run_shift_q[5] ? x_q : sum_576;
  logic less_578;
  assign less_578 = {2'h0, last_q} < select_577;
  // hls/stages/agreement.hpp:226
  logic not_579;
  assign not_579 = ~less_578;
  // hls/stages/agreement.hpp:615
  logic equal_589;
  assign equal_589 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:616
  logic equal_590;
  assign equal_590 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_591;
  assign and_591 = equal_590 & not_579;
  logic select_593;
  assign select_593 = or_575 ? not_579 : (equal_589 ? not_579 : and_591);
  // hls/stages/agreement.hpp:799
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:797
  logic [6:0] sum_607;
  assign sum_607 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_612;
  assign and_612 = equal_589 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_607} < select_577))));
  logic select_613;
  assign select_613 = or_575 ? not_579 : and_612;
  // hls/stages/agreement.hpp:822
  logic [5:0] right;
  assign right = sum_576[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:721
  logic not_643;
  assign not_643 = ~or_575;
  // hls/stages/agreement.hpp:149
  logic and_646;
  assign and_646 = not_643 & ((~equal_589) & and_591);
  // hls/stages/census.hpp:42
  logic [5:0] select_673;
  assign select_673 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_673 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_1671;
  assign and_1671 = (select_509 == 3'h0) & (select_511 == 6'h0);
  // hls/stages/patches.hpp:392
  logic not_1672;
  assign not_1672 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1675;
  assign not_1675 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_1676;
  assign and_1676 = patches_capturing_q & not_1675;
  // hls/stages/patches.hpp:364
  logic equal_1677;
  assign equal_1677 = {or_516, select_524} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1679;
  assign equal_1679 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1684;
  assign and_1684 = (not_1672 & (patches_work_q == 3'h0)) & (~(and_1676 | ((~equal_1677) | (~equal_1679))));
  // hls/stages/patches.hpp:530
  logic equal_1775;
  assign equal_1775 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:508
  logic not_1776;
  assign not_1776 = ~equal_1775;
  // hls/stages/patches.hpp:501
  logic equal_1777;
  assign equal_1777 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:454
  logic not_1778;
  assign not_1778 = ~equal_1777;
  // hls/stages/patches.hpp:495
  logic equal_1779;
  assign equal_1779 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1780;
  assign equal_1780 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:530
  logic or_1781;
  assign or_1781 = equal_1779 | equal_1780;
  // hls/stages/patches.hpp:456
  logic not_1782;
  assign not_1782 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1804;
  assign select_1804 = and_1684 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1805;
  assign select_1805 = and_1671 ? select_1804 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1807;
  assign and_1807 = and_1676 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1811;
  assign select_1811 = and_1671 ? (and_1684 | (and_1676 & (~and_1807))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1819;
  assign and_1819 = not_1776 & (not_1778 & (or_1781 & (patches_second_q & equal_1780)));
  // hls/stages/patches.hpp:167
  logic not_1836;
  assign not_1836 = ~equal_1780;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1852;
  assign select_1852 = and_1671 ? {select_1804[4], select_1804[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:454
  logic and_1862;
  assign and_1862 = not_1776 & (or_1781 & not_1778);
  // hls/stages/agreement.hpp:190
  logic and_1955;
  assign and_1955 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2126;
  assign select_2126 = sample_pair_whole_q ? (sample_last_q ? (select_524 + 3'h1) : select_524) : raster_at_y_q;
  logic [5:0] select_2128;
  assign select_2128 = sample_pair_whole_q ? (select_511 + {5'h0, equal_541}) : raster_at_column_q;
  logic [5:0] select_2131;
  assign select_2131 = sample_pair_whole_q ? (sample_last_q ? (select_673 + {5'h0, equal_542}) : select_673) : raster_at_row_q;
  logic select_2135;
  assign select_2135 = sample_pair_whole_q ? (sample_last_q ? (or_516 & (~raster_final_row_q)) : or_516) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2137;
  assign select_2137 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2141;
  assign select_2141 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:460
  logic equal_2450;
  assign equal_2450 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:465
  logic and_2451;
  assign and_2451 = and_545 & equal_2450;
  // hls/stages/agreement.hpp:524
  logic select_2454;
  assign select_2454 = (and_2451 | (~ends_cell_q)) ? and_2451 : ends_q;
  // hls/stages/agreement.hpp:530
  logic [2:0] now;
  assign now = select_2454 ? (and_2451 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:535
  logic [5:0] select_2458;
  assign select_2458 = select_2454 ? (and_2451 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2461;
  assign select_2461 = select_2454 ? (following_last_shift_q & (~and_2451)) : run_last_shift_q;
  // hls/stages/agreement.hpp:608
  logic and_2464;
  assign and_2464 = run_last_shift_q & equal_589;
  // hls/stages/agreement.hpp:617
  logic select_2466;
  assign select_2466 = equal_589 ? (~run_last_shift_q) : equal_590;
  // hls/stages/agreement.hpp:621
  logic equal_2467;
  assign equal_2467 = run_phase_q == 3'h1;
  logic not_2470;
  assign not_2470 = ~select_2466;
  // hls/stages/agreement.hpp:624
  logic equal_2472;
  assign equal_2472 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:608
  logic and_2473;
  assign and_2473 = final_row_q & so;
  // hls/stages/agreement.hpp:621
  logic [1:0] select_2474;
  assign select_2474 = equal_2472 ? 2'h1 : {2{and_2473}};
  logic [2:0] select_2476;
  assign select_2476 = (and_2464 | (select_2466 | equal_2467)) ? (equal_2467 ? 3'h2 : {not_2470, {2{select_2466}}}) : (equal_574 ? 3'h6 : {select_2474[0], select_2474});
  // hls/stages/agreement.hpp:608
  logic and_2479;
  assign and_2479 = select_2466 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:631
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2482;
  assign select_2482 = (plan_shift_q[5] & select_2466) ? value : 7'h0;
  logic [1:0] or_2483;
  assign or_2483 = {2{so}} | select_2482[5:4];
  // hls/stages/agreement.hpp:634
  logic [7:0] select_2484;
  assign select_2484 = select_2466 ? plan_columns_q : 8'h0;
  logic [6:0] or_2487;
  assign or_2487 = select_2484[6:0] | ((equal_2467 | equal_2472) ? whole_q : 7'h0);
  logic [1:0] or_2488;
  assign or_2488 = {2{and_2464}} | or_2487[3:2];
  // hls/stages/agreement.hpp:635
  logic [6:0] or_2490;
  assign or_2490 = {or_2487[6:4], or_2488, or_2487[1:0]} | (equal_574 ? drawn_q : 7'h0);
  logic [4:0] or_2491;
  assign or_2491 = {5{so}} | {or_2490[6], or_2490[3:0]};
  // hls/stages/agreement.hpp:641
  logic not_2495;
  assign not_2495 = ~run_shift_q[5];
  logic [6:0] difference_2497;
  assign difference_2497 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2498;
  assign select_2498 = equal_589 ? ({{7{not_2495}}, 1'b1} + run_span_q) : {difference_2497[6], difference_2497};
  // hls/stages/agreement.hpp:524
  logic [6:0] select_2502;
  assign select_2502 = and_2451 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_2504;
  assign select_2504 = select_2454 ? {select_2502[6], select_2502} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2507;
  assign select_2507 = select_2454 ? (and_2451 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2515;
  assign select_2515 = and_545 ? (equal_2450 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2518;
  assign select_2518 = and_545 ? (equal_2450 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2521;
  assign select_2521 = and_545 ? (equal_2450 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:532
  logic select_2535;
  assign select_2535 = (ends_cell_q | select_2454) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_589 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:527
  logic and_2539;
  assign and_2539 = (~select_2454) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:477
  logic [6:0] sum_2540;
  assign sum_2540 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:461
  logic select_2542;
  assign select_2542 = equal_2450 ? ({sum_2540[6], cfg_height_i[8:3]} == {1'b0, sum_2540[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2918;
  assign select_2918 = and_1671 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2919;
  assign select_2919 = sample_pair_whole_q ? select_2918 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_2920;
  assign and_2920 = not_1675 & equal_1677;
  logic [8:0] select_2921;
  assign select_2921 = and_2920 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2922;
  assign select_2922 = and_2920 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2923;
  assign select_2923 = sample_pair_first_q ? select_2921 : select_2922;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2925;
  assign select_2925 = sample_pair_whole_q ? (and_1671 ? select_2923[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2927;
  assign select_2927 = sample_pair_whole_q ? (and_1671 ? select_2923[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2930;
  assign select_2930 = sample_pair_whole_q ? (equal_1679 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2932;
  assign select_2932 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1679}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2933;
  assign equal_2933 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2934;
  assign not_2934 = ~equal_2933;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2936;
  assign select_2936 = sample_pair_whole_q ? (phase + {not_2934, 1'b1, not_2934, equal_2933}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:471
  logic equal_2938;
  assign equal_2938 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2942;
  assign select_2942 = equal_2938 ? ((select_2919 == 4'h6) ? 4'h0 : (select_2919 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2943;
  assign equal_2943 = select_2942 == 4'h0;
  // hls/stages/agreement.hpp:461
  logic [3:0] select_2946;
  assign select_2946 = equal_2450 ? (equal_2943 ? 4'h6 : (select_2942 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2948;
  assign select_2948 = equal_2938 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] select_2950;
  assign select_2950 = equal_2450 ? (select_2948 + {4'h0, equal_2943}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:521
  logic select_2955;
  assign select_2955 = and_545 ? (equal_2450 ? ((6'h2 < row) & equal_2943) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2957;
  assign select_2957 = and_545 ? (equal_2450 ? select_2948 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_2980;
  assign or_2980 = select_511[0] | select_673[5];
  logic [7:0] sum_2981;
  assign sum_2981 = {1'b0, select_511[2:1], or_2980, select_673[4:1]} + 8'h1;
  logic less_2982;
  assign less_2982 = {sum_2981, select_673[0], select_524, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_2985;
  assign select_2985 = and_1671 ? (and_1684 ? (~less_2982) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3024;
  assign or_3024 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3030;
  assign and_3030 = equal_1775 & not_1782;
  // hls/stages/patches.hpp:399
  logic and_3031;
  assign and_3031 = not_1836 & and_3030;
  logic [1:0] select_3033;
  assign select_3033 = equal_1777 ? 2'h0 : (equal_1779 ? 2'h3 : {equal_1780, and_3031});
  // hls/stages/patches.hpp:279
  logic equal_3035;
  assign equal_3035 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3036;
  assign not_3036 = ~equal_3035;
  // hls/stages/patches.hpp:279
  logic equal_3037;
  assign equal_3037 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3038;
  assign not_3038 = ~equal_3037;
  // hls/stages/patches.hpp:283
  logic not_3040;
  assign not_3040 = ~(patches_following_q == 3'h2);
  logic and_3043;
  assign and_3043 = (~(patches_following_q == 3'h1)) & not_3040;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3044;
  assign select_3044 = equal_3037 ? 2'h2 : {and_3043, not_3040};
  logic [3:0] select_3045;
  assign select_3045 = equal_3035 ? 4'h2 : {select_3044, {2{not_3038}}};
  // hls/stages/patches.hpp:405
  logic not_3048;
  assign not_3048 = ~or_3024;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3053;
  assign select_3053 = or_3024 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3055;
  assign select_3055 = or_3024 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 33'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_646;
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [84:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 85'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & select_593;
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_575 ? x_q[5:0] : (equal_589 ? sum_576[5:0] : x_q[5:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_593;
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_575 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_613;
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_1776 & (not_1778 & (or_1781 & (equal_1780 & not_1782))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_1819;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:776; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_1776 & (not_1778 & (not_1836 & or_1781)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:787; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_1862;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
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
      left_first_q <= and_1955 ? left_first_q : marks_first_i;
      right_q <= (~and_1955) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1955;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_509 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2126;
      raster_at_column_q <= select_2128;
      raster_at_row_q <= select_2131;
      raster_at_live_q <= select_2135;
      raster_rows_left_q <= sample_pair_whole_q ? select_2137 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2141;
      averager_place_q <= sample_pair_whole_q ? select_515 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2458;
      run_last_shift_q <= select_2461;
      run_span_q <= select_2454 ? (and_2451 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2476;
      following_shift_q <= select_2466 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2479;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2482[6], or_2483, select_2482[3:0]};
      following_columns_q <= {select_2484[7], or_2491[4], or_2490[5:4], or_2491[3:0]};
      plan_shift_q <= equal_589 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2498;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2504;
      columns_left_q <= select_2507;
      last_q <= and_545 ? (equal_2450 ? column : last_q) : last_q;
      least_q <= select_2515;
      whole_q <= select_2518;
      drawn_q <= select_2521;
      age_q <= select_2454 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2454 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2535;
      ends_q <= and_2539;
      final_row_q <= and_545 ? select_2542 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2919;
      patches_band_rows_rows_to_next_q <= select_2925;
      patches_band_rows_number_q <= select_2927;
      patches_next_band_rows_to_next_q <= select_2930;
      patches_next_band_number_q <= select_2932;
      patches_first_band_rows_to_next_q <= select_2936;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2933 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_545 ? select_2946 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_545 ? select_2950 : patches_choosing_number_q;
      patches_chooses_q <= select_2955;
      patches_choosing_band_q <= select_2957;
      patches_capturing_q <= sample_pair_whole_q ? select_1811 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_2985 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1805 : patches_row_q;
      patches_work_q <= or_3024 ? following : patches_work_q;
      patches_second_q <= not_1672 & (patches_second_q | (patches_ends_q & equal_1775));
      patches_following_q <= equal_1775 ? {2'h0, and_3030} : {equal_1777, select_3033};
      patches_following_beats_q <= {select_3045, not_3036};
      patches_begins_q <= sample_pair_whole_q & (and_1671 & and_1807);
      patches_ends_q <= not_3048 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3053;
      patches_code_row_q <= select_3055;
      patches_column_q <= or_3024 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3048 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_509_s1_q;
  logic [5:0] select_511_s1_q;
  logic [7:0] select_515_s1_q;
  logic and_519_s1_q;
  logic equal_525_s1_q;
  logic [5:0] column_s1_q;
  logic and_543_s1_q;
  logic and_545_s1_q;
  logic equal_570_s1_q;
  logic so_s1_q;
  logic equal_574_s1_q;
  logic or_575_s1_q;
  logic less_578_s1_q;
  logic not_579_s1_q;
  logic equal_589_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_613_s1_q;
  logic [5:0] right_s1_q;
  logic and_646_s1_q;
  logic [5:0] row_s1_q;
  logic and_1557_s1_q;
  logic equal_1558_s1_q;
  logic and_1671_s1_q;
  logic and_1684_s1_q;
  logic equal_1775_s1_q;
  logic not_1776_s1_q;
  logic equal_1777_s1_q;
  logic not_1778_s1_q;
  logic equal_1779_s1_q;
  logic equal_1780_s1_q;
  logic or_1781_s1_q;
  logic [4:0] select_1805_s1_q;
  logic select_1811_s1_q;
  logic [3:0] select_1852_s1_q;
  logic and_1862_s1_q;
  logic equal_2450_s1_q;
  logic and_2451_s1_q;
  logic or_3024_s1_q;
  logic not_3048_s1_q;
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
      select_509_s1_q <= select_509;
      select_511_s1_q <= select_511;
      select_515_s1_q <= select_515;
      and_519_s1_q <= and_519;
      equal_525_s1_q <= select_524 == 3'h0;
      column_s1_q <= column;
      and_543_s1_q <= and_543;
      and_545_s1_q <= and_545;
      equal_570_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_574_s1_q <= equal_574;
      or_575_s1_q <= or_575;
      less_578_s1_q <= less_578;
      not_579_s1_q <= not_579;
      equal_589_s1_q <= equal_589;
      x_s1_2_q <= x[6:0];
      select_613_s1_q <= select_613;
      right_s1_q <= right;
      and_646_s1_q <= and_646;
      row_s1_q <= row;
      and_1557_s1_q <= not_643 & and_612;
      equal_1558_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1671_s1_q <= and_1671;
      and_1684_s1_q <= and_1684;
      equal_1775_s1_q <= equal_1775;
      not_1776_s1_q <= not_1776;
      equal_1777_s1_q <= equal_1777;
      not_1778_s1_q <= not_1778;
      equal_1779_s1_q <= equal_1779;
      equal_1780_s1_q <= equal_1780;
      or_1781_s1_q <= or_1781;
      select_1805_s1_q <= select_1805;
      select_1811_s1_q <= select_1811;
      select_1852_s1_q <= select_1852;
      and_1862_s1_q <= and_1862;
      equal_2450_s1_q <= equal_2450;
      and_2451_s1_q <= and_2451;
      or_3024_s1_q <= or_3024;
      not_3048_s1_q <= not_3048;
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
  // hls/stages/census.hpp:120
  logic and_520;
  assign and_520 = sample_pair_whole_s1_q & and_519_s1_q;
  // hls/stages/agreement.hpp:669
  logic equal_564;
  assign equal_564 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_565;
  assign equal_565 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_564 & equal_565;
  // hls/stages/moments.hpp:57
  logic [11:0] select_568;
  assign select_568 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:789
  logic [10:0] select_569;
  assign select_569 = first ? 11'h0 : select_568[10:0];
  // hls/stages/agreement.hpp:1010
  logic not_571;
  assign not_571 = ~equal_570_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_573;
  assign not_573 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_575_s1_q & not_579_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_568;
  // hls/stages/moments.hpp:104
  logic not_583;
  assign not_583 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:789
  logic and_587;
  assign and_587 = not_571 & (not_573 & (equal_574_s1_q & (inside_v & not_583)));
  // hls/stages/agreement.hpp:976
  logic and_603;
  assign and_603 = (or_575_s1_q & (left_rdata_q[67] & not_579_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:967
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:968
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:969
  logic [5:0] select_622;
  assign select_622 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:669
  logic not_743;
  assign not_743 = ~equal_564;
  // hls/stages/agreement.hpp:672
  logic and_744;
  assign and_744 = left_rdata_q[12] & not_743;
  logic and_745;
  assign and_745 = left_rdata_q[30] & not_743;
  logic and_746;
  assign and_746 = left_rdata_q[48] & not_743;
  logic and_747;
  assign and_747 = left_rdata_q[66] & not_743;
  // hls/stages/agreement.hpp:673
  logic and_748;
  assign and_748 = right_codes_rdata_q[12] & not_743;
  logic and_749;
  assign and_749 = right_codes_rdata_q[27] & not_743;
  logic and_750;
  assign and_750 = right_codes_rdata_q[42] & not_743;
  logic and_751;
  assign and_751 = right_codes_rdata_q[57] & not_743;
  logic and_752;
  assign and_752 = right_codes_rdata_q[72] & not_743;
  logic and_753;
  assign and_753 = right_codes_rdata_q[85] & not_743;
  // hls/stages/agreement.hpp:221
  logic and_758;
  assign and_758 = left_rdata_q[48] & not_579_s1_q;
  logic and_759;
  assign and_759 = right_codes_rdata_q[42] & not_579_s1_q;
  logic [11:0] select_760;
  assign select_760 = less_578_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_761;
  assign select_761 = less_578_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_765;
  assign select_765 = and_758 ? (and_759 ? (~(select_760 ^ select_761)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_771;
  assign parity_771 = ^select_765[5:3];
  logic parity_774;
  assign parity_774 = ^select_765[8:6];
  logic parity_777;
  assign parity_777 = ^select_765[11:3];
  // hls/stages/agreement.hpp:221
  logic and_781;
  assign and_781 = left_rdata_q[66] & not_579_s1_q;
  logic and_782;
  assign and_782 = right_codes_rdata_q[57] & not_579_s1_q;
  logic [11:0] select_783;
  assign select_783 = less_578_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_784;
  assign select_784 = less_578_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_788;
  assign select_788 = and_781 ? (and_782 ? (~(select_783 ^ select_784)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_791;
  assign parity_791 = ^select_788[8:6];
  logic parity_794;
  assign parity_794 = ^select_788[11:9];
  // hls/stages/agreement.hpp:221
  logic and_798;
  assign and_798 = left_rdata_q[84] & not_579_s1_q;
  logic and_799;
  assign and_799 = right_codes_rdata_q[72] & not_579_s1_q;
  logic [11:0] select_800;
  assign select_800 = less_578_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_801;
  assign select_801 = less_578_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_805;
  assign select_805 = and_798 ? (and_799 ? (~(select_800 ^ select_801)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_811;
  assign parity_811 = ^select_805[2:0];
  logic parity_814;
  assign parity_814 = ^select_805[5:3];
  logic parity_817;
  assign parity_817 = ^select_805[8:0];
  logic parity_823;
  assign parity_823 = ^select_805[11:9];
  logic parity_826;
  assign parity_826 = ^select_788[2:0];
  logic parity_829;
  assign parity_829 = ^{select_805[11:9], select_788[5:0]};
  logic parity_832;
  assign parity_832 = ^{select_805, select_788, select_765[2:0]};
  logic xor_833;
  assign xor_833 = parity_777 ^ parity_832;
  // hls/stages/count_bits.hpp:23
  logic or_837;
  assign or_837 = (select_765[1:0] == 2'h3) | (select_765[2] & (select_765[0] | select_765[1]));
  // hls/stages/count_bits.hpp:25
  logic or_841;
  assign or_841 = (select_788[7:6] == 2'h3) | (select_788[8] & (select_788[6] | select_788[7]));
  logic or_845;
  assign or_845 = (select_788[10:9] == 2'h3) | (select_788[11] & (select_788[9] | select_788[10]));
  // hls/stages/count_bits.hpp:23
  logic or_853;
  assign or_853 = (select_805[7:6] == 2'h3) | (select_805[8] & (~(select_805[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_857;
  assign or_857 = (select_805[1:0] == 2'h3) | (select_805[2] & (select_805[0] | select_805[1]));
  logic or_861;
  assign or_861 = (select_805[4:3] == 2'h3) | (select_805[5] & (select_805[3] | select_805[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_864;
  assign parity_864 = ^{or_861, or_857, or_853};
  // hls/stages/count_bits.hpp:23
  logic or_868;
  assign or_868 = (select_788[4:3] == 2'h3) | (select_788[5] & (select_788[3] | select_788[4]));
  // hls/stages/count_bits.hpp:25
  logic or_872;
  assign or_872 = (select_805[10:9] == 2'h3) | (select_805[11] & (select_805[9] | select_805[10]));
  logic or_876;
  assign or_876 = (select_788[1:0] == 2'h3) | (select_788[2] & (select_788[0] | select_788[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_879;
  assign parity_879 = ^{or_876, or_872, or_868};
  logic parity_882;
  assign parity_882 = ^{or_876, or_872, or_868, or_861, or_857, or_853, or_845, or_841, or_837};
  // hls/stages/count_bits.hpp:25
  logic and_883;
  assign and_883 = parity_777 & parity_832;
  logic or_887;
  assign or_887 = (parity_771 & parity_774) | ((^select_765[11:9]) & (parity_771 | parity_774));
  logic and_890;
  assign and_890 = (^{select_788[11:6], select_765[2:0]}) & (parity_817 | parity_829);
  logic or_891;
  assign or_891 = (parity_817 & parity_829) | and_890;
  // hls/stages/count_bits.hpp:23
  logic or_898;
  assign or_898 = (select_765[10:9] == 2'h3) | (select_765[11] & (select_765[9] | select_765[10]));
  // hls/stages/count_bits.hpp:25
  logic or_902;
  assign or_902 = (select_765[4:3] == 2'h3) | (select_765[5] & (select_765[3] | select_765[4]));
  logic or_906;
  assign or_906 = (select_765[7:6] == 2'h3) | (select_765[8] & (select_765[6] | select_765[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_909;
  assign parity_909 = ^{or_906, or_902, or_898};
  // hls/stages/count_bits.hpp:25
  logic or_913;
  assign or_913 = (parity_791 & parity_794) | ((^select_765[2:0]) & (parity_791 | parity_794));
  logic or_917;
  assign or_917 = (parity_811 & parity_814) | ((^select_805[8:6]) & (parity_811 | parity_814));
  logic or_921;
  assign or_921 = (parity_823 & parity_826) | ((^select_788[5:3]) & (parity_823 | parity_826));
  // hls/stages/count_bits.hpp:24
  logic parity_924;
  assign parity_924 = ^{or_921, or_917, or_913};
  logic parity_927;
  assign parity_927 = ^{or_921, or_917, or_913, or_906, or_902, or_898, or_891, or_887, and_883};
  logic xor_928;
  assign xor_928 = parity_882 ^ parity_927;
  // hls/stages/count_bits.hpp:25
  logic and_929;
  assign and_929 = parity_882 & parity_927;
  logic or_933;
  assign or_933 = (parity_864 & parity_879) | ((^{or_845, or_841, or_837}) & (parity_864 | parity_879));
  logic or_937;
  assign or_937 = (parity_909 & parity_924) | ((^{or_891, or_887, and_883}) & (parity_909 | parity_924));
  logic or_944;
  assign or_944 = (or_841 & or_845) | (or_837 & (or_841 | or_845));
  logic or_948;
  assign or_948 = (or_857 & or_861) | (or_853 & (or_857 | or_861));
  logic or_952;
  assign or_952 = (or_872 & or_876) | (or_868 & (or_872 | or_876));
  // hls/stages/count_bits.hpp:24
  logic parity_955;
  assign parity_955 = ^{or_952, or_948, or_944};
  // hls/stages/count_bits.hpp:25
  logic or_959;
  assign or_959 = (or_887 & or_891) | (and_883 & (or_887 | or_891));
  logic or_963;
  assign or_963 = (or_902 & or_906) | (or_898 & (or_902 | or_906));
  logic or_967;
  assign or_967 = (or_917 & or_921) | (or_913 & (or_917 | or_921));
  // hls/stages/count_bits.hpp:24
  logic parity_970;
  assign parity_970 = ^{or_967, or_963, or_959};
  logic parity_973;
  assign parity_973 = ^{or_967, or_963, or_959, or_952, or_948, or_944, or_937, or_933, and_929};
  // hls/stages/count_bits.hpp:25
  logic or_977;
  assign or_977 = (parity_955 & parity_970) | ((^{or_937, or_933, and_929}) & (parity_955 | parity_970));
  logic or_981;
  assign or_981 = (or_933 & or_937) | (and_929 & (or_933 | or_937));
  logic or_985;
  assign or_985 = (or_948 & or_952) | (or_944 & (or_948 | or_952));
  logic or_989;
  assign or_989 = (or_963 & or_967) | (or_959 & (or_963 | or_967));
  // hls/stages/count_bits.hpp:24
  logic parity_994;
  assign parity_994 = ^{or_989, or_985, or_981, or_977};
  // hls/stages/count_bits.hpp:25
  logic or_998;
  assign or_998 = (or_985 & or_989) | (or_981 & (or_985 | or_989));
  logic and_999;
  assign and_999 = or_977 & (^{or_989, or_985, or_981});
  // hls/stages/count_bits.hpp:24
  logic xor_1000;
  assign xor_1000 = or_998 ^ and_999;
  // hls/stages/count_bits.hpp:27
  logic and_1001;
  assign and_1001 = or_998 & and_999;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1002;
  assign select_1002 = equal_589_s1_q ? {and_1001, xor_1000, parity_994, parity_973, xor_928, xor_833} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_575_s1_q ? 6'h0 : select_1002;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1013;
  assign select_1013 = (slot_s1_q[0] ? and_799 : and_782) ? (~(select_760 ^ (slot_s1_q[0] ? select_801 : select_784))) : 12'h0;
  logic [11:0] select_1014;
  assign select_1014 = and_758 ? select_1013 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1020;
  assign parity_1020 = ^select_1014[5:3];
  logic parity_1023;
  assign parity_1023 = ^select_1014[8:6];
  logic parity_1026;
  assign parity_1026 = ^select_1014[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1030;
  assign and_1030 = right_codes_rdata_q[85] & not_579_s1_q;
  logic [11:0] select_1032;
  assign select_1032 = less_578_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1036;
  assign select_1036 = (slot_s1_q[0] ? and_1030 : and_799) ? (~(select_783 ^ (slot_s1_q[0] ? select_1032 : select_801))) : 12'h0;
  logic [11:0] select_1037;
  assign select_1037 = and_781 ? select_1036 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^select_1037[8:6];
  logic parity_1043;
  assign parity_1043 = ^select_1037[11:9];
  // hls/stages/agreement.hpp:735
  logic select_1048;
  assign select_1048 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_579_s1_q) : and_1030;
  logic [11:0] select_1050;
  assign select_1050 = slot_s1_q[0] ? (less_578_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1032;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1054;
  assign select_1054 = and_798 ? (select_1048 ? (~(select_800 ^ select_1050)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1060;
  assign parity_1060 = ^select_1054[2:0];
  logic parity_1063;
  assign parity_1063 = ^select_1054[5:3];
  logic parity_1066;
  assign parity_1066 = ^select_1054[8:0];
  logic parity_1072;
  assign parity_1072 = ^select_1054[11:9];
  logic parity_1075;
  assign parity_1075 = ^select_1037[2:0];
  logic parity_1078;
  assign parity_1078 = ^{select_1054[11:9], select_1037[5:0]};
  logic parity_1081;
  assign parity_1081 = ^{select_1054, select_1037, select_1014[2:0]};
  logic xor_1082;
  assign xor_1082 = parity_1026 ^ parity_1081;
  // hls/stages/count_bits.hpp:23
  logic or_1086;
  assign or_1086 = (select_1014[1:0] == 2'h3) | (select_1014[2] & (select_1014[0] | select_1014[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1090;
  assign or_1090 = (select_1037[7:6] == 2'h3) | (select_1037[8] & (select_1037[6] | select_1037[7]));
  logic or_1094;
  assign or_1094 = (select_1037[10:9] == 2'h3) | (select_1037[11] & (select_1037[9] | select_1037[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1102;
  assign or_1102 = (select_1054[7:6] == 2'h3) | (select_1054[8] & (~(select_1054[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1106;
  assign or_1106 = (select_1054[1:0] == 2'h3) | (select_1054[2] & (select_1054[0] | select_1054[1]));
  logic or_1110;
  assign or_1110 = (select_1054[4:3] == 2'h3) | (select_1054[5] & (select_1054[3] | select_1054[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1113;
  assign parity_1113 = ^{or_1110, or_1106, or_1102};
  // hls/stages/count_bits.hpp:23
  logic or_1117;
  assign or_1117 = (select_1037[4:3] == 2'h3) | (select_1037[5] & (select_1037[3] | select_1037[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1121;
  assign or_1121 = (select_1054[10:9] == 2'h3) | (select_1054[11] & (select_1054[9] | select_1054[10]));
  logic or_1125;
  assign or_1125 = (select_1037[1:0] == 2'h3) | (select_1037[2] & (select_1037[0] | select_1037[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1128;
  assign parity_1128 = ^{or_1125, or_1121, or_1117};
  logic parity_1131;
  assign parity_1131 = ^{or_1125, or_1121, or_1117, or_1110, or_1106, or_1102, or_1094, or_1090, or_1086};
  // hls/stages/count_bits.hpp:25
  logic and_1132;
  assign and_1132 = parity_1026 & parity_1081;
  logic or_1136;
  assign or_1136 = (parity_1020 & parity_1023) | ((^select_1014[11:9]) & (parity_1020 | parity_1023));
  logic and_1139;
  assign and_1139 = (^{select_1037[11:6], select_1014[2:0]}) & (parity_1066 | parity_1078);
  logic or_1140;
  assign or_1140 = (parity_1066 & parity_1078) | and_1139;
  // hls/stages/count_bits.hpp:23
  logic or_1147;
  assign or_1147 = (select_1014[10:9] == 2'h3) | (select_1014[11] & (select_1014[9] | select_1014[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1151;
  assign or_1151 = (select_1014[4:3] == 2'h3) | (select_1014[5] & (select_1014[3] | select_1014[4]));
  logic or_1155;
  assign or_1155 = (select_1014[7:6] == 2'h3) | (select_1014[8] & (select_1014[6] | select_1014[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1158;
  assign parity_1158 = ^{or_1155, or_1151, or_1147};
  // hls/stages/count_bits.hpp:25
  logic or_1162;
  assign or_1162 = (parity_1040 & parity_1043) | ((^select_1014[2:0]) & (parity_1040 | parity_1043));
  logic or_1166;
  assign or_1166 = (parity_1060 & parity_1063) | ((^select_1054[8:6]) & (parity_1060 | parity_1063));
  logic or_1170;
  assign or_1170 = (parity_1072 & parity_1075) | ((^select_1037[5:3]) & (parity_1072 | parity_1075));
  // hls/stages/count_bits.hpp:24
  logic parity_1173;
  assign parity_1173 = ^{or_1170, or_1166, or_1162};
  logic parity_1176;
  assign parity_1176 = ^{or_1170, or_1166, or_1162, or_1155, or_1151, or_1147, or_1140, or_1136, and_1132};
  logic xor_1177;
  assign xor_1177 = parity_1131 ^ parity_1176;
  // hls/stages/count_bits.hpp:25
  logic and_1178;
  assign and_1178 = parity_1131 & parity_1176;
  logic or_1182;
  assign or_1182 = (parity_1113 & parity_1128) | ((^{or_1094, or_1090, or_1086}) & (parity_1113 | parity_1128));
  logic or_1186;
  assign or_1186 = (parity_1158 & parity_1173) | ((^{or_1140, or_1136, and_1132}) & (parity_1158 | parity_1173));
  logic or_1193;
  assign or_1193 = (or_1090 & or_1094) | (or_1086 & (or_1090 | or_1094));
  logic or_1197;
  assign or_1197 = (or_1106 & or_1110) | (or_1102 & (or_1106 | or_1110));
  logic or_1201;
  assign or_1201 = (or_1121 & or_1125) | (or_1117 & (or_1121 | or_1125));
  // hls/stages/count_bits.hpp:24
  logic parity_1204;
  assign parity_1204 = ^{or_1201, or_1197, or_1193};
  // hls/stages/count_bits.hpp:25
  logic or_1208;
  assign or_1208 = (or_1136 & or_1140) | (and_1132 & (or_1136 | or_1140));
  logic or_1212;
  assign or_1212 = (or_1151 & or_1155) | (or_1147 & (or_1151 | or_1155));
  logic or_1216;
  assign or_1216 = (or_1166 & or_1170) | (or_1162 & (or_1166 | or_1170));
  // hls/stages/count_bits.hpp:24
  logic parity_1219;
  assign parity_1219 = ^{or_1216, or_1212, or_1208};
  logic parity_1222;
  assign parity_1222 = ^{or_1216, or_1212, or_1208, or_1201, or_1197, or_1193, or_1186, or_1182, and_1178};
  // hls/stages/count_bits.hpp:25
  logic or_1226;
  assign or_1226 = (parity_1204 & parity_1219) | ((^{or_1186, or_1182, and_1178}) & (parity_1204 | parity_1219));
  logic or_1230;
  assign or_1230 = (or_1182 & or_1186) | (and_1178 & (or_1182 | or_1186));
  logic or_1234;
  assign or_1234 = (or_1197 & or_1201) | (or_1193 & (or_1197 | or_1201));
  logic or_1238;
  assign or_1238 = (or_1212 & or_1216) | (or_1208 & (or_1212 | or_1216));
  // hls/stages/count_bits.hpp:24
  logic parity_1243;
  assign parity_1243 = ^{or_1238, or_1234, or_1230, or_1226};
  // hls/stages/count_bits.hpp:25
  logic or_1247;
  assign or_1247 = (or_1234 & or_1238) | (or_1230 & (or_1234 | or_1238));
  logic and_1248;
  assign and_1248 = or_1226 & (^{or_1238, or_1234, or_1230});
  // hls/stages/count_bits.hpp:24
  logic xor_1249;
  assign xor_1249 = or_1247 ^ and_1248;
  // hls/stages/count_bits.hpp:27
  logic and_1250;
  assign and_1250 = or_1247 & and_1248;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1251;
  assign select_1251 = equal_589_s1_q ? {and_1250, xor_1249, parity_1243, parity_1222, xor_1177, xor_1082} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_575_s1_q ? 6'h0 : select_1251;
  // hls/stages/agreement.hpp:221
  logic and_1259;
  assign and_1259 = right_codes_rdata_q[27] & not_579_s1_q;
  // hls/stages/agreement.hpp:735
  logic select_1260;
  assign select_1260 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_579_s1_q) : and_1259;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1262;
  assign select_1262 = less_578_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:735
  logic [11:0] select_1263;
  assign select_1263 = slot_s1_q[0] ? (less_578_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1262;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1267;
  assign select_1267 = and_758 ? (select_1260 ? (~(select_760 ^ select_1263)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1273;
  assign parity_1273 = ^select_1267[5:3];
  logic parity_1276;
  assign parity_1276 = ^select_1267[8:6];
  logic parity_1279;
  assign parity_1279 = ^select_1267[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1287;
  assign select_1287 = (slot_s1_q[0] ? and_1259 : and_759) ? (~(select_783 ^ (slot_s1_q[0] ? select_1262 : select_761))) : 12'h0;
  logic [11:0] select_1288;
  assign select_1288 = and_781 ? select_1287 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1291;
  assign parity_1291 = ^select_1288[8:6];
  logic parity_1294;
  assign parity_1294 = ^select_1288[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1302;
  assign select_1302 = (slot_s1_q[0] ? and_759 : and_782) ? (~(select_800 ^ (slot_s1_q[0] ? select_761 : select_784))) : 12'h0;
  logic [11:0] select_1303;
  assign select_1303 = and_798 ? select_1302 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1309;
  assign parity_1309 = ^select_1303[2:0];
  logic parity_1312;
  assign parity_1312 = ^select_1303[5:3];
  logic parity_1315;
  assign parity_1315 = ^select_1303[8:0];
  logic parity_1321;
  assign parity_1321 = ^select_1303[11:9];
  logic parity_1324;
  assign parity_1324 = ^select_1288[2:0];
  logic parity_1327;
  assign parity_1327 = ^{select_1303[11:9], select_1288[5:0]};
  logic parity_1330;
  assign parity_1330 = ^{select_1303, select_1288, select_1267[2:0]};
  logic xor_1331;
  assign xor_1331 = parity_1279 ^ parity_1330;
  // hls/stages/count_bits.hpp:23
  logic or_1335;
  assign or_1335 = (select_1267[1:0] == 2'h3) | (select_1267[2] & (select_1267[0] | select_1267[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1339;
  assign or_1339 = (select_1288[7:6] == 2'h3) | (select_1288[8] & (select_1288[6] | select_1288[7]));
  logic or_1343;
  assign or_1343 = (select_1288[10:9] == 2'h3) | (select_1288[11] & (select_1288[9] | select_1288[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1351;
  assign or_1351 = (select_1303[7:6] == 2'h3) | (select_1303[8] & (~(select_1303[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1355;
  assign or_1355 = (select_1303[1:0] == 2'h3) | (select_1303[2] & (select_1303[0] | select_1303[1]));
  logic or_1359;
  assign or_1359 = (select_1303[4:3] == 2'h3) | (select_1303[5] & (select_1303[3] | select_1303[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1362;
  assign parity_1362 = ^{or_1359, or_1355, or_1351};
  // hls/stages/count_bits.hpp:23
  logic or_1366;
  assign or_1366 = (select_1288[4:3] == 2'h3) | (select_1288[5] & (select_1288[3] | select_1288[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1370;
  assign or_1370 = (select_1303[10:9] == 2'h3) | (select_1303[11] & (select_1303[9] | select_1303[10]));
  logic or_1374;
  assign or_1374 = (select_1288[1:0] == 2'h3) | (select_1288[2] & (select_1288[0] | select_1288[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1377;
  assign parity_1377 = ^{or_1374, or_1370, or_1366};
  logic parity_1380;
  assign parity_1380 = ^{or_1374, or_1370, or_1366, or_1359, or_1355, or_1351, or_1343, or_1339, or_1335};
  // hls/stages/count_bits.hpp:25
  logic and_1381;
  assign and_1381 = parity_1279 & parity_1330;
  logic or_1385;
  assign or_1385 = (parity_1273 & parity_1276) | ((^select_1267[11:9]) & (parity_1273 | parity_1276));
  logic and_1388;
  assign and_1388 = (^{select_1288[11:6], select_1267[2:0]}) & (parity_1315 | parity_1327);
  logic or_1389;
  assign or_1389 = (parity_1315 & parity_1327) | and_1388;
  // hls/stages/count_bits.hpp:23
  logic or_1396;
  assign or_1396 = (select_1267[10:9] == 2'h3) | (select_1267[11] & (select_1267[9] | select_1267[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1400;
  assign or_1400 = (select_1267[4:3] == 2'h3) | (select_1267[5] & (select_1267[3] | select_1267[4]));
  logic or_1404;
  assign or_1404 = (select_1267[7:6] == 2'h3) | (select_1267[8] & (select_1267[6] | select_1267[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1407;
  assign parity_1407 = ^{or_1404, or_1400, or_1396};
  // hls/stages/count_bits.hpp:25
  logic or_1411;
  assign or_1411 = (parity_1291 & parity_1294) | ((^select_1267[2:0]) & (parity_1291 | parity_1294));
  logic or_1415;
  assign or_1415 = (parity_1309 & parity_1312) | ((^select_1303[8:6]) & (parity_1309 | parity_1312));
  logic or_1419;
  assign or_1419 = (parity_1321 & parity_1324) | ((^select_1288[5:3]) & (parity_1321 | parity_1324));
  // hls/stages/count_bits.hpp:24
  logic parity_1422;
  assign parity_1422 = ^{or_1419, or_1415, or_1411};
  logic parity_1425;
  assign parity_1425 = ^{or_1419, or_1415, or_1411, or_1404, or_1400, or_1396, or_1389, or_1385, and_1381};
  logic xor_1426;
  assign xor_1426 = parity_1380 ^ parity_1425;
  // hls/stages/count_bits.hpp:25
  logic and_1427;
  assign and_1427 = parity_1380 & parity_1425;
  logic or_1431;
  assign or_1431 = (parity_1362 & parity_1377) | ((^{or_1343, or_1339, or_1335}) & (parity_1362 | parity_1377));
  logic or_1435;
  assign or_1435 = (parity_1407 & parity_1422) | ((^{or_1389, or_1385, and_1381}) & (parity_1407 | parity_1422));
  logic or_1442;
  assign or_1442 = (or_1339 & or_1343) | (or_1335 & (or_1339 | or_1343));
  logic or_1446;
  assign or_1446 = (or_1355 & or_1359) | (or_1351 & (or_1355 | or_1359));
  logic or_1450;
  assign or_1450 = (or_1370 & or_1374) | (or_1366 & (or_1370 | or_1374));
  // hls/stages/count_bits.hpp:24
  logic parity_1453;
  assign parity_1453 = ^{or_1450, or_1446, or_1442};
  // hls/stages/count_bits.hpp:25
  logic or_1457;
  assign or_1457 = (or_1385 & or_1389) | (and_1381 & (or_1385 | or_1389));
  logic or_1461;
  assign or_1461 = (or_1400 & or_1404) | (or_1396 & (or_1400 | or_1404));
  logic or_1465;
  assign or_1465 = (or_1415 & or_1419) | (or_1411 & (or_1415 | or_1419));
  // hls/stages/count_bits.hpp:24
  logic parity_1468;
  assign parity_1468 = ^{or_1465, or_1461, or_1457};
  logic parity_1471;
  assign parity_1471 = ^{or_1465, or_1461, or_1457, or_1450, or_1446, or_1442, or_1435, or_1431, and_1427};
  // hls/stages/count_bits.hpp:25
  logic or_1475;
  assign or_1475 = (parity_1453 & parity_1468) | ((^{or_1435, or_1431, and_1427}) & (parity_1453 | parity_1468));
  logic or_1479;
  assign or_1479 = (or_1431 & or_1435) | (and_1427 & (or_1431 | or_1435));
  logic or_1483;
  assign or_1483 = (or_1446 & or_1450) | (or_1442 & (or_1446 | or_1450));
  logic or_1487;
  assign or_1487 = (or_1461 & or_1465) | (or_1457 & (or_1461 | or_1465));
  // hls/stages/count_bits.hpp:24
  logic parity_1492;
  assign parity_1492 = ^{or_1487, or_1483, or_1479, or_1475};
  // hls/stages/count_bits.hpp:25
  logic or_1496;
  assign or_1496 = (or_1483 & or_1487) | (or_1479 & (or_1483 | or_1487));
  logic and_1497;
  assign and_1497 = or_1475 & (^{or_1487, or_1483, or_1479});
  // hls/stages/count_bits.hpp:24
  logic xor_1498;
  assign xor_1498 = or_1496 ^ and_1497;
  // hls/stages/count_bits.hpp:27
  logic and_1499;
  assign and_1499 = or_1496 & and_1497;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1500;
  assign select_1500 = equal_589_s1_q ? {and_1499, xor_1498, parity_1492, parity_1471, xor_1426, xor_1331} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_575_s1_q ? 6'h0 : select_1500;
  // hls/stages/agreement.hpp:789
  logic and_1568;
  assign and_1568 = ends_cell_s1_q & inside_v;
  logic and_1570;
  assign and_1570 = not_571 & (so_s1_q & and_1568);
  logic [5:0] select_1574;
  assign select_1574 = so_s1_q ? x_s1_q[5:0] : (or_575_s1_q ? (less_578_s1_q ? 6'h0 : select_622) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1578;
  assign or_1578 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1587;
  assign and_1587 = or_575_s1_q & (slot_s1_q[2] & not_579_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1703;
  assign select_1703 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1703[16:7])) ? 8'h7f : select_1703[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1780_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1780_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:496
  logic less_1868;
  assign less_1868 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:497
  logic or_1869;
  assign or_1869 = equal_1779_s1_q | less_1868;
  // hls/stages/patches.hpp:500
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1874;
  assign select_1874 = equal_1779_s1_q ? patches_column_s1_q[0] : (or_1869 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1875;
  assign not_1875 = ~or_1869;
  // hls/stages/patches.hpp:497
  logic [4:0] sum_1876;
  assign sum_1876 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:499
  logic [4:0] select_1879;
  assign select_1879 = or_1869 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1876) + 5'h1) : sum_1876;
  // hls/stages/patches.hpp:501
  logic [4:0] select_1880;
  assign select_1880 = equal_1779_s1_q ? 5'h0 : select_1879;
  logic or_1881;
  assign or_1881 = equal_1779_s1_q | equal_1777_s1_q;
  // hls/stages/patches.hpp:477
  logic equal_1883;
  assign equal_1883 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1885;
  assign equal_1885 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:479
  logic and_1887;
  assign and_1887 = of_row & (~equal_1885);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1883 ? 2'h3 : {equal_1885, and_1887};
  // hls/stages/patches.hpp:465
  logic [8:0] sum_1890;
  assign sum_1890 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1891;
  assign sum_1891 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1890, pixel_2[0]} - {1'b0, sum_1891, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:467
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
  // hls/stages/patches.hpp:463
  logic [8:0] sum_1900;
  assign sum_1900 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1901;
  assign sum_1901 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1900};
  logic [10:0] sum_1902;
  assign sum_1902 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1901, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1903;
  assign sum_1903 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1902[10:1];
  // hls/stages/patches.hpp:464
  logic [11:0] smooth;
  assign smooth = {sum_1903, sum_1902[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:466
  logic [12:0] sum_1905;
  assign sum_1905 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1906;
  assign sum_1906 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1907;
  assign difference_1907 = {1'b0, sum_1905, smooth[0]} - {1'b0, sum_1906, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:478
  logic or_1913;
  assign or_1913 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1885) | equal_1883;
  // hls/stages/patches.hpp:473
  logic and_1918;
  assign and_1918 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1922;
  assign and_1922 = not_1778_s1_q & (or_1781_s1_q & (or_1913 & (equal_1780_s1_q & and_1918)));
  // hls/stages/patches.hpp:172
  logic and_1932;
  assign and_1932 = (~(equal_1780_s1_q | (~and_1918))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1936;
  assign and_1936 = not_1778_s1_q & (or_1781_s1_q & (and_1932 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:542
  logic less_1938;
  assign less_1938 = patches_step_q[4:0] < 5'h11;
  logic equal_1939;
  assign equal_1939 = patches_step_q[6:5] == 2'h0;
  logic not_1940;
  assign not_1940 = ~equal_1939;
  logic equal_1941;
  assign equal_1941 = patches_step_q[6:5] == 2'h3;
  logic not_1942;
  assign not_1942 = ~equal_1941;
  // hls/stages/patches.hpp:556
  logic select_1945;
  assign select_1945 = equal_1941 ? (less_1938 & (less_1938 & not_1942)) : less_1938;
  // hls/stages/patches.hpp:184
  logic and_1948;
  assign and_1948 = equal_1775_s1_q & (less_1938 ? (not_1940 & select_1945) : select_1945);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1976;
  assign sum_1976 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:461
  logic select_2547;
  assign select_2547 = equal_2450_s1_q ? (~({row_s1_q, 1'b0} < {sum_2544, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:521
  logic and_2808;
  assign and_2808 = and_545_s1_q & (equal_2450_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2809;
  assign and_2809 = and_2451_s1_q & and_2808;
  // hls/stages/registration.hpp:127
  logic and_2811;
  assign and_2811 = and_2451_s1_q & (~and_2808);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2812;
  assign select_2812 = and_2811 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2814;
  assign select_2814 = and_2809 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2812[15]}}, select_2812});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2815;
  assign select_2815 = and_2811 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2815[15]}}, select_2815};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2817;
  assign select_2817 = and_2809 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2818;
  assign and_2818 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2818 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3063;
  assign select_3063 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3066;
  assign select_3066 = equal_1777_s1_q ? patches_smooth_values_0_q : (or_1781_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3068;
  assign select_3068 = or_1781_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3070;
  assign select_3070 = equal_1775_s1_q ? patches_smooth_values_1_q : (equal_1777_s1_q ? patches_smooth_values_1_q : select_3068);
  logic [11:0] select_3071;
  assign select_3071 = or_1781_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3073;
  assign select_3073 = equal_1775_s1_q ? patches_smooth_values_2_q : (equal_1777_s1_q ? patches_smooth_values_2_q : select_3071);
  logic [11:0] select_3074;
  assign select_3074 = or_1781_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3076;
  assign select_3076 = equal_1775_s1_q ? patches_smooth_values_3_q : (equal_1777_s1_q ? patches_smooth_values_3_q : select_3074);
  logic [10:0] select_3078;
  assign select_3078 = equal_1777_s1_q ? patches_down_values_0_q : (or_1781_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3081;
  assign select_3081 = equal_1777_s1_q ? patches_down_values_1_q : (or_1781_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3084;
  assign select_3084 = equal_1777_s1_q ? patches_down_values_2_q : (or_1781_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3087;
  assign select_3087 = equal_1777_s1_q ? patches_down_values_3_q : (or_1781_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3124;
  assign and_3124 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3129;
  assign select_3129 = or_3024_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3131;
  assign select_3131 = and_3124 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3487;
  assign select_3487 = equal_1775_s1_q ? patches_summed_down_by_q : (equal_1777_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:552
  logic and_3520;
  assign and_3520 = less_1938 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:556
  logic select_3523;
  assign select_3523 = equal_1941 ? (less_1938 ? (not_1942 & and_3520) : and_3520) : and_3520;
  // hls/stages/patches.hpp:184
  logic select_3526;
  assign select_3526 = equal_1775_s1_q ? (less_1938 ? (not_1940 & select_3523) : select_3523) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3865;
  assign select_3865 = so_s1_q ? (and_2818 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3867;
  assign sum_3867 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3868;
  assign select_3868 = sum_1976[5] ? {1'b1, sum_1976[4:0], region_across_rest_q[2:0]} : sum_3867;
  // hls/stages/agreement.hpp:461
  logic [7:0] select_3870;
  assign select_3870 = equal_2450_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3873;
  assign select_3873 = equal_2450_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_515_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_520;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:340; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s1_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_545_s1_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 1645 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:1644];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1645; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [10:0] moments_memory_raddr;
  assign moments_memory_raddr = select_569;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_587;
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_575_s1_q ? select_622 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_613_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_1570;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] left_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [5:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[5:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_1587;
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_622;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1587;
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1880, not_1875, select_1874};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1881;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:793; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_1776_s1_q & (new_row & equal_1777_s1_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s1_en & and_1948;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1406; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_1570;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_646_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_747, left_rdata_q[65:49], and_746, left_rdata_q[47:31], and_745, left_rdata_q[29:13], and_744, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_646_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_753, right_codes_rdata_q[84:73], and_752, right_codes_rdata_q[71:60], and_751, right_codes_rdata_q[56:43], and_750, right_codes_rdata_q[41:28], and_749, right_codes_rdata_q[26:13], and_748, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      moments_place_q <= select_568;
      moments_taken_q <= not_571 & (not_573 & (equal_574_s1_q & inside_v));
      moments_starts_q <= not_571 & (not_573 & (equal_574_s1_q & (inside_v & first)));
      row_q <= and_545_s1_q ? (equal_2450_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_545_s1_q ? select_2547 : lower_half_q;
      registration_slope_row_q <= select_2814;
      registration_slope_change_q <= select_2817;
      registration_slope_q <= so_s1_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3048_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3048_s1_q & select_3063;
      patches_smooth_values_0_q <= equal_1775_s1_q ? patches_smooth_values_0_q : select_3066;
      patches_smooth_values_1_q <= select_3070;
      patches_smooth_values_2_q <= select_3073;
      patches_smooth_values_3_q <= select_3076;
      patches_down_values_0_q <= equal_1775_s1_q ? patches_down_values_0_q : select_3078;
      patches_down_values_1_q <= equal_1775_s1_q ? patches_down_values_1_q : select_3081;
      patches_down_values_2_q <= equal_1775_s1_q ? patches_down_values_2_q : select_3084;
      patches_down_values_3_q <= equal_1775_s1_q ? patches_down_values_3_q : select_3087;
      patches_down_by_q <= or_3024_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3124});
      patches_along_q <= select_3129;
      patches_match_row_q <= or_3024_s1_q ? 4'h0 : select_3131;
      patches_summed_last_q <= not_1776_s1_q & (equal_1777_s1_q & and_3124);
      patches_summed_down_by_q <= select_3487;
      patches_step_q <= or_3024_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3526;
      region_across_rest_q <= select_3865;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3868;
      columns_begin_rest_q <= and_545_s1_q ? select_3870 : columns_begin_rest_q;
      columns_begin_back_q <= and_545_s1_q ? select_3873 : columns_begin_back_q;
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
      sums_0_columns_values_0_q <= column_3;
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
      sums_1_columns_values_0_q <= column_4;
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
  logic [2:0] select_509_s2_q;
  logic [5:0] select_511_s2_q;
  logic [7:0] select_515_s2_q;
  logic and_519_s2_q;
  logic and_520_s2_q;
  logic equal_525_s2_q;
  logic [5:0] column_s2_q;
  logic and_543_s2_q;
  logic and_545_s2_q;
  logic equal_565_s2_q;
  logic [10:0] select_569_s2_q;
  logic equal_570_s2_q;
  logic not_571_s2_q;
  logic so_s2_q;
  logic not_573_s2_q;
  logic equal_574_s2_q;
  logic or_575_s2_q;
  logic less_578_s2_q;
  logic not_579_s2_q;
  logic inside_v_s2_q;
  logic not_583_s2_q;
  logic and_587_s2_q;
  logic and_596_s2_q;
  logic and_604_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_635_s2_q;
  logic and_640_s2_q;
  logic and_642_s2_q;
  logic equal_675_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1253_s2_q;
  logic [5:0] select_1502_s2_q;
  logic and_1557_s2_q;
  logic equal_1558_s2_q;
  logic and_1568_s2_q;
  logic and_1570_s2_q;
  logic [5:0] select_1574_s2_q;
  logic or_1578_s2_q;
  logic and_1671_s2_q;
  logic and_1684_s2_q;
  logic less_1698_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1775_s2_q;
  logic equal_1777_s2_q;
  logic equal_1780_s2_q;
  logic or_1781_s2_q;
  logic [4:0] select_1805_s2_q;
  logic select_1811_s2_q;
  logic [3:0] select_1852_s2_q;
  logic less_1868_s2_q;
  logic new_row_s2_q;
  logic or_1881_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_1898_s2_q;
  logic less_1899_s2_q;
  logic less_1908_s2_q;
  logic less_1909_s2_q;
  logic and_1923_s2_q;
  logic and_1932_s2_q;
  logic and_1937_s2_q;
  logic less_1938_s2_q;
  logic equal_1939_s2_q;
  logic not_1940_s2_q;
  logic equal_1941_s2_q;
  logic not_1942_s2_q;
  logic and_1955_s2_q;
  logic select_1957_s2_q;
  logic and_1960_s2_q;
  logic sum_1976_s2_q;
  logic and_1997_s2_q;
  logic and_2115_s2_q;
  logic equal_2261_s2_q;
  logic equal_2450_s2_q;
  logic and_2577_s2_q;
  logic equal_2662_s2_q;
  logic less_3100_s2_q;
  logic equal_3443_s2_q;
  logic equal_3527_s2_q;
  logic less_3853_s2_q;
  logic equal_4072_s2_q;
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
      select_509_s2_q <= select_509_s1_q;
      select_511_s2_q <= select_511_s1_q;
      select_515_s2_q <= select_515_s1_q;
      and_519_s2_q <= and_519_s1_q;
      and_520_s2_q <= and_520;
      equal_525_s2_q <= equal_525_s1_q;
      column_s2_q <= column_s1_q;
      and_543_s2_q <= and_543_s1_q;
      and_545_s2_q <= and_545_s1_q;
      equal_565_s2_q <= equal_565;
      select_569_s2_q <= select_569;
      equal_570_s2_q <= equal_570_s1_q;
      not_571_s2_q <= not_571;
      so_s2_q <= so_s1_q;
      not_573_s2_q <= not_573;
      equal_574_s2_q <= equal_574_s1_q;
      or_575_s2_q <= or_575_s1_q;
      less_578_s2_q <= less_578_s1_q;
      not_579_s2_q <= not_579_s1_q;
      inside_v_s2_q <= inside_v;
      not_583_s2_q <= not_583;
      and_587_s2_q <= and_587;
      and_596_s2_q <= or_575_s1_q & (left_rdata_q[70] & not_579_s1_q);
      and_604_s2_q <= (or_575_s1_q & (left_rdata_q[68] & not_579_s1_q)) & and_603;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_635_s2_q <= or_575_s1_q & (left_rdata_q[71] & not_579_s1_q);
      and_640_s2_q <= or_575_s1_q & (right_codes_rdata_q[58] & not_579_s1_q);
      and_642_s2_q <= or_575_s1_q & (right_codes_rdata_q[59] & not_579_s1_q);
      equal_675_s2_q <= row_s1_q == 6'h0;
      column_2_s2_q <= column_2;
      select_1253_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1502_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1557_s2_q <= and_1557_s1_q;
      equal_1558_s2_q <= equal_1558_s1_q;
      and_1568_s2_q <= and_1568;
      and_1570_s2_q <= and_1570;
      select_1574_s2_q <= select_1574;
      or_1578_s2_q <= or_1578;
      and_1671_s2_q <= and_1671_s1_q;
      and_1684_s2_q <= and_1684_s1_q;
      less_1698_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1775_s2_q <= equal_1775_s1_q;
      equal_1777_s2_q <= equal_1777_s1_q;
      equal_1780_s2_q <= equal_1780_s1_q;
      or_1781_s2_q <= or_1781_s1_q;
      select_1805_s2_q <= select_1805_s1_q;
      select_1811_s2_q <= select_1811_s1_q;
      select_1852_s2_q <= select_1852_s1_q;
      less_1868_s2_q <= less_1868;
      new_row_s2_q <= new_row;
      or_1881_s2_q <= or_1881;
      of_row_2_s2_q <= of_row_2;
      less_1898_s2_q <= $signed(15'h100) < $signed(sum_1897);
      less_1899_s2_q <= $signed(sum_1897[14:8]) < $signed(7'h7f);
      less_1908_s2_q <= $signed(15'h100) < $signed(difference_1907);
      less_1909_s2_q <= $signed(difference_1907[14:8]) < $signed(7'h7f);
      and_1923_s2_q <= not_1776_s1_q & and_1922;
      and_1932_s2_q <= and_1932;
      and_1937_s2_q <= not_1776_s1_q & and_1936;
      less_1938_s2_q <= less_1938;
      equal_1939_s2_q <= equal_1939;
      not_1940_s2_q <= not_1940;
      equal_1941_s2_q <= equal_1941;
      not_1942_s2_q <= not_1942;
      and_1955_s2_q <= sample_pair_whole_q;
      select_1957_s2_q <= left_first_q;
      and_1960_s2_q <= right_q;
      sum_1976_s2_q <= sum_1976[5];
      and_1997_s2_q <= or_575_s1_q & (left_rdata_q[69] & not_579_s1_q);
      and_2115_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2261_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2450_s2_q <= equal_2450_s1_q;
      and_2577_s2_q <= or_575_s1_q & (not_579_s1_q & and_603);
      equal_2662_s2_q <= shift == 6'h0;
      less_3100_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3443_s2_q <= patches_match_row_q == 4'h0;
      equal_3527_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3853_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4072_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [6:0] patches_choice_column_q;
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
  // hls/stages/census.hpp:113
  logic [11:0] select_523;
  assign select_523 = select_509_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_527;
  assign sum_527 = select_523 + (equal_525_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_529;
  assign sum_529 = {4'h0, sample_pair_pixel_1_q} + (select_509_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_531;
  assign sum_531 = sum_529 + (equal_525_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_509_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_535;
  assign and_535 = whole & (averager_memory_rdata_q[24] | equal_525_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_509_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_539;
  assign and_539 = all_of_skin & (averager_memory_rdata_q[25] | equal_525_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_519_s2_q ? sum_527[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_548;
  assign equal_548 = select_509_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_548 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_551;
  assign select_551 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_519_s2_q ? sum_531[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_548 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_555;
  assign select_555 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_556;
  assign and_556 = and_519_s2_q & and_535;
  // hls/stages/census.hpp:127
  logic select_558;
  assign select_558 = equal_548 ? and_556 : (averager_mask_q & and_556);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_558;
  // hls/stages/census.hpp:207
  logic and_560;
  assign and_560 = and_519_s2_q & and_539;
  // hls/stages/census.hpp:127
  logic select_562;
  assign select_562 = equal_548 ? and_560 : (averager_of_skin_q & and_560);
  // hls/stages/agreement.hpp:276
  logic and_563;
  assign and_563 = sample_pair_whole_s2_q & select_562;
  // hls/stages/agreement.hpp:979
  logic select_617;
  assign select_617 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:980
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:993
  logic [8:0] difference_627;
  assign difference_627 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:994
  logic [9:0] sum_628;
  assign sum_628 = {difference_627[8], difference_627} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_630;
  assign and_630 = (and_604_s2_q & select_617) & ({{22{sum_628[9]}}, sum_628} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_632;
  assign and_632 = or_575_s2_q & (not_579_s2_q & and_630);
  // hls/stages/moments.hpp:77
  logic and_633;
  assign and_633 = and_596_s2_q & and_632;
  // hls/stages/census.hpp:296
  logic less_648;
  assign less_648 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_660;
  assign less_660 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:456
  logic equal_672;
  assign equal_672 = column_s2_q == 6'h0;
  logic [3:0] select_676;
  assign select_676 = equal_675_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:457
  logic [4:0] select_677;
  assign select_677 = equal_672 ? {select_676, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_678;
  assign select_678 = equal_672 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_679;
  assign and_679 = select_677[4] & select_678[3];
  // hls/stages/census.hpp:288
  logic and_681;
  assign and_681 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_683;
  assign and_683 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_681);
  // hls/stages/agreement.hpp:457
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_683;
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
  logic [9:0] difference_706;
  assign difference_706 = {1'b0, select_551} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_707;
  assign xor_707 = difference_706[8:0] ^ {9{difference_706[9]}};
  logic [9:0] sum_708;
  assign sum_708 = {9'h0, difference_706[9]} + {1'b0, xor_707};
  logic [9:0] difference_709;
  assign difference_709 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_710;
  assign xor_710 = difference_709[8:0] ^ {9{difference_709[9]}};
  logic [9:0] sum_711;
  assign sum_711 = {9'h0, difference_709[9]} + {1'b0, xor_710};
  logic [9:0] difference_713;
  assign difference_713 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_714;
  assign xor_714 = difference_713[8:0] ^ {9{difference_713[9]}};
  logic [9:0] sum_715;
  assign sum_715 = {9'h0, difference_713[9]} + {1'b0, xor_714};
  logic [10:0] sum_716;
  assign sum_716 = ({1'b0, sum_708} + {1'b0, sum_711}) + {1'b0, sum_715};
  logic [9:0] difference_717;
  assign difference_717 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_718;
  assign xor_718 = difference_717[8:0] ^ {9{difference_717[9]}};
  logic [9:0] sum_719;
  assign sum_719 = {9'h0, difference_717[9]} + {1'b0, xor_718};
  logic [9:0] difference_721;
  assign difference_721 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_722;
  assign xor_722 = difference_721[8:0] ^ {9{difference_721[9]}};
  // hls/stages/agreement.hpp:457
  logic and_730;
  assign and_730 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_731;
  assign and_731 = and_679 & and_730;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_733;
  assign sum_733 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_735;
  assign and_735 = and_731 & ({{5{sum_733[6]}}, sum_733, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_739;
  assign sum_739 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:808
  logic or_755;
  assign or_755 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:809
  logic select_757;
  assign select_757 = or_755 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1004;
  assign select_1004 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1005;
  assign difference_1005 = {1'b0, column_2_s2_q} - {1'b0, select_1004};
  logic [7:0] sum_1007;
  assign sum_1007 = {difference_1005[6], difference_1005} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:756
  logic [7:0] select_1008;
  assign select_1008 = slot_s2_q[0] ? chosen_score_q : sum_1007;
  // hls/stages/agreement.hpp:779
  logic [6:0] difference_1254;
  assign difference_1254 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1253_s2_q};
  // hls/stages/agreement.hpp:750
  logic equal_1255;
  assign equal_1255 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:779
  logic [7:0] sum_1257;
  assign sum_1257 = {difference_1254[6], difference_1254} + (equal_1255 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1503;
  assign difference_1503 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1502_s2_q};
  logic [7:0] sum_1505;
  assign sum_1505 = {difference_1503[6], difference_1503} + (equal_1255 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:752
  logic less_1506;
  assign less_1506 = sum_1257 < sum_1505;
  logic [7:0] select_1507;
  assign select_1507 = less_1506 ? sum_1505 : sum_1257;
  logic less_1508;
  assign less_1508 = select_1008 < select_1507;
  // hls/stages/agreement.hpp:802
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1508 ? select_1507 : select_1008) : 8'h0;
  // hls/stages/agreement.hpp:809
  logic or_1512;
  assign or_1512 = select_757 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:814
  logic [5:0] select_1513;
  assign select_1513 = or_1512 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:721
  logic not_1514;
  assign not_1514 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:753
  logic [1:0] select_1515;
  assign select_1515 = less_1506 ? {slot_s2_q[0], not_1514} : 2'h0;
  logic [2:0] select_1517;
  assign select_1517 = less_1508 ? {select_1515, not_1514} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:814
  logic [2:0] select_1518;
  assign select_1518 = or_1512 ? select_1517 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1519;
  assign select_1519 = or_1512 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:811
  logic equal_1520;
  assign equal_1520 = select_1517 == 3'h1;
  logic or_1523;
  assign or_1523 = equal_1520 | (~(select_1517 == 3'h2));
  logic [7:0] select_1525;
  assign select_1525 = or_1523 ? before_0_q : before_1_q;
  logic [7:0] select_1526;
  assign select_1526 = equal_1520 ? (or_1523 ? sum_1257 : {7'h0, shift_not_right_q}) : select_1525;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1527;
  assign select_1527 = or_1512 ? select_1526 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1530;
  assign select_1530 = or_1512 ? (equal_1520 ? select_1525 : (or_1523 ? sum_1505 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1532;
  assign sum_1532 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1533;
  assign sum_1533 = {1'b0, before_v} + sum_1532;
  // hls/stages/agreement.hpp:756
  logic [6:0] select_1534;
  assign select_1534 = slot_s2_q[0] ? chosen_near_q : sum_1533;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1536;
  assign sum_1536 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, before_v_2} + sum_1536;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1539;
  assign sum_1539 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1540;
  assign sum_1540 = {1'b0, before_v_3} + sum_1539;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1542;
  assign select_1542 = (sum_1537 < sum_1540) ? sum_1540 : sum_1537;
  // hls/stages/agreement.hpp:803
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1534 < select_1542) ? select_1542 : select_1534) : 7'h0;
  // hls/stages/agreement.hpp:814
  logic less_1546;
  assign less_1546 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1548;
  assign select_1548 = select_757 ? of_near : (less_1546 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1550;
  assign select_1550 = select_757 ? run_shift_s2_q : (less_1546 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1553;
  assign select_1553 = (run_shift_s2_q == 6'h3f) ? of_best : (select_757 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:819
  logic [7:0] select_1556;
  assign select_1556 = (run_shift_s2_q == 6'h1) ? of_best : (select_757 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:824
  logic select_1559;
  assign select_1559 = or_755 ? shift_first_s2_q : equal_1558_s2_q;
  // hls/stages/agreement.hpp:825
  logic or_1561;
  assign or_1561 = select_1559 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_1562;
  assign select_1562 = or_1561 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1563;
  assign select_1563 = or_1561 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1565;
  assign or_1565 = select_1559 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:833
  logic [6:0] select_1566;
  assign select_1566 = or_1565 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1567;
  assign select_1567 = or_1565 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1581;
  assign and_1581 = or_575_s2_q & (not_579_s2_q & (and_630 & or_1578_s2_q));
  // hls/stages/agreement.hpp:789
  logic and_1582;
  assign and_1582 = not_573_s2_q & and_1581;
  logic and_1585;
  assign and_1585 = not_571_s2_q & (so_s2_q ? and_1568_s2_q : (equal_574_s2_q & and_632));
  // hls/stages/moments.hpp:73
  logic and_1589;
  assign and_1589 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1004
  logic and_1590;
  assign and_1590 = not_583_s2_q & and_1589;
  logic and_1593;
  assign and_1593 = not_583_s2_q & (and_1589 & (moments_memory_rdata_q[1] ^ and_635_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1598;
  assign and_1598 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1004
  logic and_1599;
  assign and_1599 = not_583_s2_q & and_1598;
  logic and_1602;
  assign and_1602 = not_583_s2_q & (and_1598 & (moments_memory_rdata_q[3] ^ and_642_s2_q));
  // hls/stages/agreement.hpp:1129
  logic equal_1603;
  assign equal_1603 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1179
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1130
  logic [1:0] select_1606;
  assign select_1606 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1143
  logic [3:0] select_1608;
  assign select_1608 = equal_1603 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1606});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1609;
  assign sum_1609 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_1610;
  assign select_1610 = equal_570_s2_q ? select_1608 : {sum_1609, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1611;
  assign equal_1611 = x_s2_q[5:0] == 6'h3f;
  logic equal_1613;
  assign equal_1613 = x_s2_q[5:0] == 6'h3e;
  logic equal_1615;
  assign equal_1615 = x_s2_q[5:0] == 6'h3d;
  logic equal_1617;
  assign equal_1617 = x_s2_q[5:0] == 6'h3c;
  logic equal_1619;
  assign equal_1619 = x_s2_q[5:0] == 6'h3b;
  logic equal_1621;
  assign equal_1621 = x_s2_q[5:0] == 6'h36;
  logic equal_1623;
  assign equal_1623 = x_s2_q[5:0] == 6'h35;
  logic equal_1625;
  assign equal_1625 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1179
  logic and_1629;
  assign and_1629 = (~equal_1619) & ((~equal_1621) & ((~equal_1623) & (~equal_1625)));
  logic and_1633;
  assign and_1633 = (~equal_1611) & ((~equal_1613) & ((~equal_1615) & ((~equal_1617) & and_1629)));
  // hls/stages/agreement.hpp:1130
  logic less_1634;
  assign less_1634 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1638;
  assign or_1638 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1010
  logic [4:0] sum_1643;
  assign sum_1643 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1643, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1649;
  assign sum_1649 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1651;
  assign and_1651 = half_ends & ({{3{sum_1649[4]}}, sum_1649} < 8'h3);
  // hls/stages/agreement.hpp:789
  logic and_1652;
  assign and_1652 = so_s2_q & and_1651;
  logic select_1653;
  assign select_1653 = equal_570_s2_q ? (x_s2_q[6] & (equal_1603 ? and_1633 : (less_1634 & (~or_1638)))) : and_1652;
  // hls/stages/registration.hpp:258
  logic not_1655;
  assign not_1655 = ~lower_half_s2_q;
  logic [3:0] select_1656;
  assign select_1656 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1655, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1655};
  // hls/stages/patches.hpp:373
  logic [1:0] select_1685;
  assign select_1685 = and_1684_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1686;
  assign select_1686 = and_1684_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1687;
  assign select_1687 = and_1671_s2_q ? {select_1686, select_1685[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1688;
  assign select_1688 = and_1671_s2_q ? select_1685 : patches_fetch_q;
  logic equal_1689;
  assign equal_1689 = select_1688 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:789
  logic and_1697;
  assign and_1697 = not_571_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1699;
  assign equal_1699 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_575_s2_q ? (less_578_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1699 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1707;
  assign select_1707 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1708;
  assign select_1708 = b[1] ? a : 8'h0;
  logic [8:0] sum_1709;
  assign sum_1709 = {{2{select_1707[6]}}, select_1707} + {select_1708[7], select_1708};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1710;
  assign select_1710 = b[2] ? a : 8'h0;
  logic [7:0] select_1711;
  assign select_1711 = b[3] ? a : 8'h0;
  logic [8:0] sum_1712;
  assign sum_1712 = {{2{select_1710[7]}}, select_1710[7:1]} + {select_1711[7], select_1711};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1713;
  assign sum_1713 = {{3{sum_1709[8]}}, sum_1709[8:1]} + {sum_1712[8], sum_1712, select_1710[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1714;
  assign select_1714 = b[4] ? a : 8'h0;
  logic [7:0] select_1715;
  assign select_1715 = b[5] ? a : 8'h0;
  logic [8:0] difference_1716;
  assign difference_1716 = {{2{select_1714[7]}}, select_1714[7:1]} - {select_1715[7], select_1715};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1717;
  assign sum_1717 = {difference_1716, select_1714[0]} + {sum_1713[10], sum_1713[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1699 ? {sum_1717, sum_1713[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1719;
  assign sum_1719 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1722;
  assign and_1722 = less_1698_s2_q & (and_632 & ({{4{sum_1719[9]}}, sum_1719, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1726;
  assign and_1726 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1732;
  assign sum_1732 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1734;
  assign sum_1734 = {sum_1732[9], sum_1732[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1019
  logic and_1737;
  assign and_1737 = ($signed(9'h0) < $signed(sum_1732[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1734, sum_1732[0]})));
  logic and_1738;
  assign and_1738 = (~(and_1726 | (equal_565_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1737;
  // hls/stages/agreement.hpp:789
  logic and_1742;
  assign and_1742 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1722 & and_1738)));
  logic and_1743;
  assign and_1743 = not_571_s2_q & and_1742;
  // hls/stages/patches.hpp:156
  logic and_1745;
  assign and_1745 = and_1743 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1746;
  assign select_1746 = and_1745 ? and_1743 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:789
  logic [6:0] select_1749;
  assign select_1749 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  // hls/stages/patches.hpp:344
  logic [6:0] select_1751;
  assign select_1751 = and_1745 ? (equal_570_s2_q ? 7'h0 : select_1749) : patches_choice_column_q;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1754;
  assign select_1754 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_1756;
  assign select_1756 = and_1745 ? (equal_570_s2_q ? 6'h0 : select_1754) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1757;
  assign sum_1757 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1717[9]}}, sum_1717[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1760;
  assign select_1760 = ($signed(sum_1757[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1757[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1699 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1757[12:7])) ? 8'h7f : select_1760);
  // hls/stages/agreement.hpp:789
  logic [7:0] select_1765;
  assign select_1765 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_1767;
  assign select_1767 = and_1745 ? (equal_570_s2_q ? 8'h0 : select_1765) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1768;
  assign equal_1768 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:789
  logic and_1772;
  assign and_1772 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1726 | equal_1768)));
  logic and_1773;
  assign and_1773 = not_571_s2_q & and_1772;
  // hls/stages/patches.hpp:344
  logic and_1774;
  assign and_1774 = patches_chooses_s2_q & and_1773;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1788;
  assign select_1788 = and_1671_s2_q ? select_1686 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1789;
  assign equal_1789 = {patches_choosing_band_s2_q, and_1697} == {select_1788, select_1688[1]};
  // hls/stages/patches.hpp:482
  logic [2:0] sum_1889;
  assign sum_1889 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:486
  logic [1:0] sum_1927;
  assign sum_1927 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1963;
  assign select_1963 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1051
  logic or_1966;
  assign or_1966 = select_1963[7] | (~({select_1963[5], select_1963[3], select_1963[1]} == 3'h0));
  // hls/stages/agreement.hpp:1050
  logic or_1969;
  assign or_1969 = select_1963[7] | (~({select_1963[6], select_1963[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1972;
  assign or_1972 = select_1963[7] | (~(select_1963[6:4] == 3'h0));
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1973;
  assign select_1973 = equal_570_s2_q ? x_s2_q[5:0] : {region_row_q, or_1972, or_1969, or_1966};
  // hls/stages/agreement.hpp:1129
  logic not_1974;
  assign not_1974 = ~equal_1603;
  // hls/stages/agreement.hpp:1059
  logic or_1978;
  assign or_1978 = (~sum_1976_s2_q) | equal_1768;
  // hls/stages/agreement.hpp:789
  logic and_1981;
  assign and_1981 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1978));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_575_s2_q & (not_579_s2_q & and_604_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_632;
  // hls/stages/agreement.hpp:149
  logic and_1999;
  assign and_1999 = or_575_s2_q & (not_579_s2_q & and_1997_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2008;
  assign and_2008 = inside_v_s2_q & and_1999;
  // hls/stages/agreement.hpp:1015
  logic select_2009;
  assign select_2009 = slot_s2_q[2] ? shown_shown_q : and_632;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2009);
  // hls/stages/agreement.hpp:1015
  logic select_2012;
  assign select_2012 = slot_s2_q[2] ? shown_nearer_q : and_1581;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2009 ? select_2012 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1272
  logic select_2015;
  assign select_2015 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1276
  logic select_2016;
  assign select_2016 = left_first_s2_q ? select_2015 : read_half_q;
  logic or_2017;
  assign or_2017 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [8:0] select_2018;
  assign select_2018 = or_2017 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1278
  logic [9:0] select_2020;
  assign select_2020 = left_first_s2_q ? 10'h1 : (or_2017 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1281
  logic and_2021;
  assign and_2021 = select_2018[8] & select_2020[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2021 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1292
  logic [5:0] select_2024;
  assign select_2024 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2026;
  assign select_2026 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2024});
  // hls/stages/agreement.hpp:1302
  logic equal_2027;
  assign equal_2027 = seen_x_q == 3'h7;
  logic [7:0] select_2029;
  assign select_2029 = and_2021 ? 8'h0 : (seen_column_q + {7'h0, equal_2027});
  // hls/stages/agreement.hpp:1309
  logic [10:0] index;
  assign index = select_2026 + {3'h0, select_2029};
  // hls/stages/agreement.hpp:1262
  logic [11:0] sum_2031;
  assign sum_2031 = {1'b0, {2{select_2016}}, 2'h0, {2{select_2016}}, 1'b0, {2{select_2016}}, 1'b0, select_2016} + {1'b0, index};
  // hls/stages/agreement.hpp:1275
  logic not_2032;
  assign not_2032 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2034;
  assign and_2034 = not_2032 & (began_q | and_2021);
  // hls/stages/agreement.hpp:1303
  logic [2:0] select_2036;
  assign select_2036 = and_2021 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1308
  logic and_2038;
  assign and_2038 = and_2034 & (select_2036 == 3'h0);
  logic less_2039;
  assign less_2039 = select_2029 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2040;
  assign and_2040 = and_2038 & less_2039;
  logic and_2041;
  assign and_2041 = and_1955_s2_q & and_2040;
  // hls/stages/agreement.hpp:278
  logic select_2043;
  assign select_2043 = and_1955_s2_q ? (left_first_s2_q ? and_2040 : and_2041) : and_2041;
  // hls/stages/agreement.hpp:1112
  logic [7:0] sum_2045;
  assign sum_2045 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2045[7], sum_2045, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1262
  logic [11:0] sum_2047;
  assign sum_2047 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1031
  logic and_2048;
  assign and_2048 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2049;
  assign and_2049 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2050;
  assign and_2050 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2051;
  assign and_2051 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2053;
  assign sum_2053 = {1'b0, and_2050} + ({1'b0, textured} + {1'b0, and_2051});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2048} + ({2'h0, and_2049} + {1'b0, sum_2053});
  // hls/stages/agreement.hpp:1031
  logic [7:0] select_2062;
  assign select_2062 = inside_v_s2_q ? (sum_1976_s2_q ? select_1963 : {select_1963[6:0], 1'b0}) : select_1963;
  // hls/stages/agreement.hpp:1051
  logic or_2065;
  assign or_2065 = select_2062[7] | (~({select_2062[5], select_2062[3], select_2062[1]} == 3'h0));
  // hls/stages/agreement.hpp:1031
  logic and_2082;
  assign and_2082 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2083;
  assign and_2083 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2084;
  assign and_2084 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2085;
  assign and_2085 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2087;
  assign sum_2087 = {1'b0, and_2084} + ({1'b0, shown} + {1'b0, and_2085});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2082} + ({2'h0, and_2083} + {1'b0, sum_2087});
  // hls/stages/agreement.hpp:1031
  logic and_2098;
  assign and_2098 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2099;
  assign and_2099 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2100;
  assign and_2100 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2101;
  assign and_2101 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1091
  logic [1:0] sum_2103;
  assign sum_2103 = {1'b0, and_2100} + ({1'b0, near} + {1'b0, and_2101});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2098} + ({2'h0, and_2099} + {1'b0, sum_2103});
  // hls/stages/agreement.hpp:789
  logic and_2119;
  assign and_2119 = ends_cell_s2_q & (and_2115_s2_q & (~({1'b0, sum_1643, last_s2_q[1:0]} < x_s2_q)));
  logic and_2121;
  assign and_2121 = not_571_s2_q & (so_s2_q & and_2119);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2153;
  assign select_2153 = sample_pair_whole_s2_q ? (and_543_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2155;
  assign select_2155 = sample_pair_whole_s2_q ? (and_543_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2174;
  assign select_2174 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2176;
  assign select_2176 = sample_pair_whole_s2_q ? (and_543_s2_q ? select_558 : averager_mask_q) : averager_mask_q;
  logic select_2178;
  assign select_2178 = sample_pair_whole_s2_q ? (and_543_s2_q ? select_562 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:521
  logic [8:0] select_2179;
  assign select_2179 = and_545_s2_q ? select_551 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2180;
  assign select_2180 = and_545_s2_q ? select_555 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2182;
  assign select_2182 = and_545_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2183;
  assign select_2183 = and_545_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2184;
  assign select_2184 = and_545_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2185;
  assign select_2185 = and_545_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2186;
  assign select_2186 = and_545_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2187;
  assign select_2187 = and_545_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2188;
  assign select_2188 = and_545_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2189;
  assign select_2189 = and_545_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2190;
  assign select_2190 = and_545_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2191;
  assign select_2191 = and_545_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2192;
  assign select_2192 = and_545_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2193;
  assign select_2193 = and_545_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2194;
  assign select_2194 = and_545_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2195;
  assign select_2195 = and_545_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2196;
  assign select_2196 = and_545_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2197;
  assign select_2197 = and_545_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2198;
  assign select_2198 = and_545_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_545_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2200;
  assign select_2200 = and_545_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2201;
  assign select_2201 = and_545_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_545_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2203;
  assign select_2203 = and_545_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2204;
  assign select_2204 = and_545_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2205;
  assign select_2205 = and_545_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_545_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2207;
  assign select_2207 = and_545_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2208;
  assign select_2208 = and_545_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_545_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2210;
  assign select_2210 = and_545_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2211;
  assign select_2211 = and_545_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_545_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2213;
  assign select_2213 = and_545_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_545_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_545_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2216;
  assign select_2216 = and_545_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_545_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_545_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2219;
  assign select_2219 = and_545_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2220;
  assign select_2220 = and_545_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_545_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2222;
  assign select_2222 = and_545_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2223;
  assign select_2223 = and_545_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_545_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2225;
  assign select_2225 = and_545_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2226;
  assign select_2226 = and_545_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2227;
  assign select_2227 = and_545_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_545_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2229;
  assign select_2229 = and_545_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2230;
  assign select_2230 = and_545_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2231;
  assign select_2231 = and_545_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2232;
  assign select_2232 = and_545_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2233;
  assign select_2233 = and_545_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2234;
  assign select_2234 = and_545_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2236;
  assign difference_2236 = {1'b0, select_555} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2237;
  assign xor_2237 = difference_2236[8:0] ^ {9{difference_2236[9]}};
  logic [9:0] sum_2238;
  assign sum_2238 = {9'h0, difference_2236[9]} + {1'b0, xor_2237};
  logic [9:0] difference_2239;
  assign difference_2239 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2240;
  assign xor_2240 = difference_2239[8:0] ^ {9{difference_2239[9]}};
  logic [9:0] sum_2241;
  assign sum_2241 = {9'h0, difference_2239[9]} + {1'b0, xor_2240};
  logic [9:0] difference_2243;
  assign difference_2243 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2244;
  assign xor_2244 = difference_2243[8:0] ^ {9{difference_2243[9]}};
  logic [9:0] sum_2245;
  assign sum_2245 = {9'h0, difference_2243[9]} + {1'b0, xor_2244};
  logic [10:0] sum_2246;
  assign sum_2246 = ({1'b0, sum_2238} + {1'b0, sum_2241}) + {1'b0, sum_2245};
  logic [9:0] difference_2247;
  assign difference_2247 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2248;
  assign xor_2248 = difference_2247[8:0] ^ {9{difference_2247[9]}};
  logic [9:0] sum_2249;
  assign sum_2249 = {9'h0, difference_2247[9]} + {1'b0, xor_2248};
  logic [9:0] difference_2251;
  assign difference_2251 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2252;
  assign xor_2252 = difference_2251[8:0] ^ {9{difference_2251[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2273;
  assign sum_2273 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2275;
  assign sum_2275 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1143
  logic equal_2276;
  assign equal_2276 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2277;
  assign select_2277 = equal_2276 ? sum_2273 : moments_before_0_q;
  logic [13:0] select_2279;
  assign select_2279 = equal_2276 ? sum_2275 : moments_before_1_q;
  // hls/stages/agreement.hpp:789
  logic select_2282;
  assign select_2282 = equal_570_s2_q ? (moments_has_before_q | equal_2276) : moments_has_before_q;
  logic [13:0] select_2285;
  assign select_2285 = equal_570_s2_q ? ((select_2279 < select_2277) ? select_2277 : select_2279) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2286;
  assign sum_2286 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2289;
  assign select_2289 = equal_570_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2286)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2290;
  assign sum_2290 = {1'b0, sum_2275} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2293;
  assign select_2293 = equal_570_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2290)) : moments_left_alone_q;
  logic select_2296;
  assign select_2296 = equal_570_s2_q ? (~({3'h0, select_2279[13:2]} < sum_2290)) : moments_left_other_stops_q;
  logic select_2299;
  assign select_2299 = equal_570_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2286)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2300;
  assign sum_2300 = {1'b0, sum_2273} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2303;
  assign select_2303 = equal_570_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2300)) : moments_right_alone_q;
  logic select_2306;
  assign select_2306 = equal_570_s2_q ? (~({3'h0, select_2277[13:2]} < sum_2300)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2309;
  assign or_2309 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:789
  logic and_2317;
  assign and_2317 = not_571_s2_q & (not_573_s2_q & (equal_574_s2_q & (inside_v_s2_q & and_1593)));
  logic and_2321;
  assign and_2321 = not_571_s2_q & (not_573_s2_q & (equal_574_s2_q & (inside_v_s2_q & and_1602)));
  // hls/stages/moments.hpp:94
  logic and_2323;
  assign and_2323 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2326;
  assign select_2326 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2323)) : and_2323;
  // hls/stages/agreement.hpp:789
  logic and_2330;
  assign and_2330 = equal_570_s2_q & (equal_2276 & (cfg_prove_i & (cfg_same_table_i & select_2326)));
  // hls/stages/moments.hpp:95
  logic and_2333;
  assign and_2333 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2347;
  assign difference_2347 = {1'b0, select_551} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2347[9]} + (difference_2347[8:0] ^ {9{difference_2347[9]}});
  logic [9:0] difference_2359;
  assign difference_2359 = {1'b0, select_555} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2359[9]} + (difference_2359[8:0] ^ {9{difference_2359[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2550;
  assign select_2550 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2551;
  assign select_2551 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2552;
  assign select_2552 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2553;
  assign select_2553 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2554;
  assign select_2554 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2555;
  assign select_2555 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2559;
  assign select_2559 = slot_s2_q[0] ? 8'h0 : sum_1007;
  // hls/stages/agreement.hpp:752
  logic less_2560;
  assign less_2560 = select_2559 < select_1507;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2562;
  assign select_2562 = slot_s2_q[0] ? 7'h0 : sum_1533;
  // hls/stages/agreement.hpp:789
  logic not_2567;
  assign not_2567 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2568;
  assign less_2568 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:521
  logic and_2575;
  assign and_2575 = and_545_s2_q & (equal_675_s2_q & equal_2450_s2_q);
  // hls/stages/agreement.hpp:789
  logic and_2581;
  assign and_2581 = not_571_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2577_s2_q)));
  // hls/stages/agreement.hpp:1031
  logic and_2601;
  assign and_2601 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2602;
  assign and_2602 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2603;
  assign and_2603 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2604;
  assign and_2604 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2606;
  assign sum_2606 = {1'b0, and_2603} + ({1'b0, explained} + {1'b0, and_2604});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2601} + ({2'h0, and_2602} + {1'b0, sum_2606});
  // hls/stages/agreement.hpp:789
  logic and_2642;
  assign and_2642 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2577_s2_q & and_1999)));
  // hls/stages/agreement.hpp:987
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:988
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:989
  logic [7:0] difference_2666;
  assign difference_2666 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2669;
  assign less_2669 = {2'h0, difference_2666[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2672;
  assign and_2672 = not_579_s2_q & (((and_1997_s2_q & and_630) & equal_2662_s2_q) & (~less_2669));
  // hls/stages/agreement.hpp:789
  logic and_2676;
  assign and_2676 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_575_s2_q & and_2672)));
  // hls/stages/agreement.hpp:149
  logic and_2681;
  assign and_2681 = not_579_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2683;
  assign and_2683 = not_579_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2684;
  assign select_2684 = or_575_s2_q ? {and_2683, and_2681} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2686;
  assign select_2686 = less_578_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2687;
  assign select_2687 = or_575_s2_q ? select_2686 : 2'h0;
  // hls/stages/agreement.hpp:1028
  logic and_2689;
  assign and_2689 = and_632 & (select_2684[0] & select_2687[0]);
  // hls/stages/agreement.hpp:789
  logic and_2693;
  assign and_2693 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2684[1] & and_2689)));
  logic and_2694;
  assign and_2694 = not_571_s2_q & and_2693;
  logic and_2700;
  assign and_2700 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2687[1] & and_2689)));
  logic and_2701;
  assign and_2701 = not_571_s2_q & and_2700;
  // hls/stages/registration.hpp:76
  logic less_2704;
  assign less_2704 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2706;
  assign select_2706 = or_575_s2_q ? (less_578_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2708;
  assign select_2708 = or_575_s2_q ? (less_578_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2710;
  assign select_2710 = or_575_s2_q ? (less_578_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2708} - {1'b0, select_2710};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2712;
  assign select_2712 = rise_2[8] ? select_2708 : select_2710;
  logic [8:0] fall;
  assign fall = {1'b0, select_2706} - {1'b0, select_2712};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2715;
  assign not_2715 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2704 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2715};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2717;
  assign xor_2717 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2717};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2723;
  assign select_2723 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2704 ? {taken, 1'b1} : {not_2715, select_2723, not_2715};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2725;
  assign sum_2725 = {left, 1'b1} + {taken_2, less_2704};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2727;
  assign select_2727 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2729;
  assign select_2729 = equal_570_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2731;
  assign select_2731 = equal_570_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2732;
  assign equal_2732 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2736;
  assign and_2736 = and_632 & less_1698_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2738;
  assign select_2738 = or_575_s2_q ? (less_578_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2742;
  assign sum_2742 = select_2738[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2745;
  assign select_2745 = (select_2708 < select_2710) ? ({sum_2742, select_2738[0], 5'h0} - {3'h0, select_2727}) : {sum_2742, select_2738[0], select_2727};
  logic [7:0] select_2746;
  assign select_2746 = ((select_2738 == 3'h0) | (select_2738 == 3'h4)) ? {sum_2742, select_2738[0], 5'h0} : select_2745;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2746[7]}}, select_2746} - {sum_1717[9], sum_1717, sum_1713[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2749;
  assign select_2749 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2749[11:7])) ? 12'h7f : select_2749;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2770;
  assign difference_2770 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2772;
  assign and_2772 = and_2736 & ($signed(difference_2770) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2785;
  assign less_2785 = $signed(difference_2770) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:789
  logic select_2793;
  assign select_2793 = so_s2_q ? (equal_2732 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2796;
  assign select_2796 = so_s2_q ? (equal_1699 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2801;
  assign select_2801 = (sum_1609 == 2'h2) ? (registration_fresh_q & (~select_1656)) : registration_fresh_q;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_2803;
  assign select_2803 = so_s2_q ? (and_1651 ? select_2801 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2805;
  assign select_2805 = and_2575 ? 4'hf : (equal_570_s2_q ? registration_fresh_q : select_2803);
  // hls/stages/agreement.hpp:1130
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1606;
  // hls/stages/registration.hpp:258
  logic not_2826;
  assign not_2826 = ~quarter_2[1];
  logic [3:0] select_2827;
  assign select_2827 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2826, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2826};
  // hls/stages/patches.hpp:91
  logic parity_2961;
  assign parity_2961 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:461
  logic [15:0] select_2962;
  assign select_2962 = equal_2450_s2_q ? {patches_chance_q[14:0], parity_2961} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_2964;
  assign not_2964 = ~and_1773;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2966;
  assign select_2966 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2966};
  // hls/stages/agreement.hpp:789
  logic and_2972;
  assign and_2972 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2976;
  assign and_2976 = not_2964 & (patches_fixed_q | ((not_571_s2_q & and_2972) & and_1745));
  // hls/stages/patches.hpp:354
  logic not_2989;
  assign not_2989 = ~select_1688[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_2991;
  assign select_2991 = sample_pair_whole_s2_q ? (equal_1689 ? select_1688 : {not_2989, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:518
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3090;
  assign select_3090 = or_1781_s2_q ? {less_1909_s2_q, less_1908_s2_q, less_1899_s2_q, less_1898_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3092;
  assign select_3092 = equal_1775_s2_q ? patches_codes_at_q : (equal_1777_s2_q ? other[55:4] : select_3090);
  // hls/stages/patches.hpp:501
  logic [27:0] word;
  assign word = or_1881_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [27:0] select_3095;
  assign select_3095 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3097;
  assign select_3097 = equal_1777_s2_q ? (new_row_s2_q ? word : select_3095) : patches_codes_further_q;
  // hls/stages/patches.hpp:519
  logic [55:0] select_3099;
  assign select_3099 = less_1868_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:489
  logic [55:0] select_3101;
  assign select_3101 = less_3100_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3103;
  assign select_3103 = or_1781_s2_q ? (equal_1780_s2_q ? patches_next_codes_q : select_3101) : patches_next_codes_q;
  logic [55:0] select_3105;
  assign select_3105 = equal_1775_s2_q ? patches_next_codes_q : (equal_1777_s2_q ? select_3099 : select_3103);
  // hls/stages/count_bits.hpp:24
  logic parity_3110;
  assign parity_3110 = ^{less_1909_s2_q, less_1908_s2_q, less_1899_s2_q, less_1898_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3114;
  assign or_3114 = ({less_1899_s2_q, less_1898_s2_q} == 2'h3) | (less_1908_s2_q & (less_1899_s2_q | less_1898_s2_q));
  logic and_3115;
  assign and_3115 = less_1909_s2_q & (^{less_1908_s2_q, less_1899_s2_q, less_1898_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3116;
  assign xor_3116 = or_3114 ^ and_3115;
  // hls/stages/count_bits.hpp:27
  logic and_3117;
  assign and_3117 = or_3114 & and_3115;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3119;
  assign select_3119 = or_1781_s2_q ? (and_1932_s2_q ? {and_3117, xor_3116, parity_3110} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3123;
  assign sum_3123 = {7'h0, patches_set_q} + (equal_1780_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:518
  logic [47:0] select_3133;
  assign select_3133 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3135;
  assign select_3135 = equal_1775_s2_q ? patches_left_row_q : (equal_1777_s2_q ? select_3133 : patches_left_row_q);
  // hls/stages/patches.hpp:520
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3133;
  // hls/stages/count_bits.hpp:24
  logic xor_3139;
  assign xor_3139 = bits[17] ^ (^{select_3133[16:15], other[16:15]});
  logic xor_3142;
  assign xor_3142 = bits[11] ^ (^{select_3133[10:9], other[10:9]});
  logic xor_3145;
  assign xor_3145 = bits[14] ^ (^{select_3133[13:12], other[13:12]});
  logic xor_3148;
  assign xor_3148 = xor_3139 ^ (^{select_3133[14:9], other[14:9]});
  logic xor_3151;
  assign xor_3151 = bits[47] ^ (^{select_3133[46:45], other[46:45]});
  logic xor_3154;
  assign xor_3154 = bits[8] ^ (^{select_3133[7:6], other[7:6]});
  logic xor_3157;
  assign xor_3157 = bits[2] ^ (^{select_3133[1:0], other[1:0]});
  logic xor_3160;
  assign xor_3160 = bits[5] ^ (^{select_3133[4:3], other[4:3]});
  logic xor_3163;
  assign xor_3163 = xor_3154 ^ (^{select_3133[5:0], other[5:0]});
  logic parity_3165;
  assign parity_3165 = ^{select_3133[47:45], select_3133[8:0], other[47:45], other[8:0]};
  logic xor_3166;
  assign xor_3166 = xor_3148 ^ parity_3165;
  logic xor_3169;
  assign xor_3169 = bits[44] ^ (^{select_3133[43:42], other[43:42]});
  logic xor_3172;
  assign xor_3172 = bits[38] ^ (^{select_3133[37:36], other[37:36]});
  logic xor_3175;
  assign xor_3175 = bits[41] ^ (^{select_3133[40:39], other[40:39]});
  logic xor_3181;
  assign xor_3181 = bits[26] ^ (^{select_3133[25:24], other[25:24]});
  logic xor_3184;
  assign xor_3184 = bits[20] ^ (^{select_3133[19:18], other[19:18]});
  logic xor_3187;
  assign xor_3187 = bits[23] ^ (^{select_3133[22:21], other[22:21]});
  logic xor_3190;
  assign xor_3190 = xor_3181 ^ (^{select_3133[23:18], other[23:18]});
  logic xor_3193;
  assign xor_3193 = bits[35] ^ (^{select_3133[34:33], other[34:33]});
  logic xor_3196;
  assign xor_3196 = bits[29] ^ (^{select_3133[28:27], other[28:27]});
  logic xor_3199;
  assign xor_3199 = bits[32] ^ (^{select_3133[31:30], other[31:30]});
  logic xor_3202;
  assign xor_3202 = xor_3193 ^ (^{select_3133[32:27], other[32:27]});
  logic xor_3203;
  assign xor_3203 = xor_3190 ^ xor_3202;
  // hls/stages/count_bits.hpp:25
  logic or_3211;
  assign or_3211 = (xor_3142 & xor_3145) | (xor_3139 & (xor_3142 | xor_3145));
  logic or_3215;
  assign or_3215 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3219;
  assign or_3219 = (xor_3157 & xor_3160) | (xor_3154 & (xor_3157 | xor_3160));
  // hls/stages/count_bits.hpp:23
  logic or_3226;
  assign or_3226 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3230;
  assign or_3230 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3234;
  assign or_3234 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3237;
  assign parity_3237 = ^{or_3234, or_3230, or_3226};
  // hls/stages/count_bits.hpp:23
  logic or_3241;
  assign or_3241 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3245;
  assign or_3245 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3249;
  assign or_3249 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3252;
  assign parity_3252 = ^{or_3249, or_3245, or_3241};
  logic parity_3255;
  assign parity_3255 = ^{or_3249, or_3245, or_3241, or_3234, or_3230, or_3226, or_3219, or_3215, or_3211};
  // hls/stages/count_bits.hpp:23
  logic or_3259;
  assign or_3259 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3263;
  assign or_3263 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3267;
  assign or_3267 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3275;
  assign or_3275 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3279;
  assign or_3279 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3283;
  assign or_3283 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3286;
  assign parity_3286 = ^{or_3283, or_3279, or_3275};
  // hls/stages/count_bits.hpp:23
  logic or_3290;
  assign or_3290 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3294;
  assign or_3294 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3298;
  assign or_3298 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3301;
  assign parity_3301 = ^{or_3298, or_3294, or_3290};
  logic parity_3304;
  assign parity_3304 = ^{or_3298, or_3294, or_3290, or_3283, or_3279, or_3275, or_3267, or_3263, or_3259};
  // hls/stages/count_bits.hpp:25
  logic or_3308;
  assign or_3308 = (xor_3172 & xor_3175) | (xor_3169 & (xor_3172 | xor_3175));
  logic or_3312;
  assign or_3312 = (xor_3184 & xor_3187) | (xor_3181 & (xor_3184 | xor_3187));
  logic or_3316;
  assign or_3316 = (xor_3196 & xor_3199) | (xor_3193 & (xor_3196 | xor_3199));
  // hls/stages/count_bits.hpp:24
  logic parity_3319;
  assign parity_3319 = ^{or_3316, or_3312, or_3308};
  // hls/stages/count_bits.hpp:25
  logic and_3320;
  assign and_3320 = xor_3166 & (^{xor_3203, select_3133[44:36], other[44:36]});
  logic or_3324;
  assign or_3324 = (xor_3151 & xor_3163) | (xor_3148 & (xor_3151 | xor_3163));
  logic and_3327;
  assign and_3327 = (xor_3169 ^ (^{select_3133[41:36], other[41:36]})) & (xor_3190 | xor_3202);
  logic or_3328;
  assign or_3328 = (xor_3190 & xor_3202) | and_3327;
  // hls/stages/count_bits.hpp:24
  logic parity_3331;
  assign parity_3331 = ^{or_3328, or_3324, and_3320};
  logic parity_3334;
  assign parity_3334 = ^{or_3328, or_3324, and_3320, or_3316, or_3312, or_3308, or_3298, or_3294, or_3290, or_3283, or_3279, or_3275, or_3267, or_3263, or_3259};
  logic parity_3336;
  assign parity_3336 = ^{or_3328, or_3324, and_3320, or_3316, or_3312, or_3308, or_3298, or_3294, or_3290, or_3283, or_3279, or_3275, or_3267, or_3263, or_3259, or_3249, or_3245, or_3241, or_3234, or_3230, or_3226, or_3219, or_3215, or_3211};
  // hls/stages/count_bits.hpp:25
  logic and_3337;
  assign and_3337 = parity_3255 & parity_3334;
  logic or_3341;
  assign or_3341 = (parity_3237 & parity_3252) | ((^{or_3219, or_3215, or_3211}) & (parity_3237 | parity_3252));
  logic or_3345;
  assign or_3345 = (parity_3319 & parity_3331) | (parity_3304 & (parity_3319 | parity_3331));
  logic or_3352;
  assign or_3352 = (parity_3286 & parity_3301) | ((^{or_3267, or_3263, or_3259}) & (parity_3286 | parity_3301));
  logic or_3356;
  assign or_3356 = (or_3312 & or_3316) | (or_3308 & (or_3312 | or_3316));
  logic or_3360;
  assign or_3360 = (or_3324 & or_3328) | (and_3320 & (or_3324 | or_3328));
  // hls/stages/count_bits.hpp:23
  logic or_3367;
  assign or_3367 = (or_3263 & or_3267) | (or_3259 & (or_3263 | or_3267));
  // hls/stages/count_bits.hpp:25
  logic or_3371;
  assign or_3371 = (or_3279 & or_3283) | (or_3275 & (or_3279 | or_3283));
  logic or_3375;
  assign or_3375 = (or_3294 & or_3298) | (or_3290 & (or_3294 | or_3298));
  // hls/stages/count_bits.hpp:24
  logic parity_3378;
  assign parity_3378 = ^{or_3375, or_3371, or_3367};
  // hls/stages/count_bits.hpp:23
  logic or_3382;
  assign or_3382 = (or_3215 & or_3219) | (or_3211 & (or_3215 | or_3219));
  // hls/stages/count_bits.hpp:25
  logic or_3386;
  assign or_3386 = (or_3230 & or_3234) | (or_3226 & (or_3230 | or_3234));
  logic or_3390;
  assign or_3390 = (or_3245 & or_3249) | (or_3241 & (or_3245 | or_3249));
  // hls/stages/count_bits.hpp:24
  logic parity_3393;
  assign parity_3393 = ^{or_3390, or_3386, or_3382};
  logic parity_3396;
  assign parity_3396 = ^{or_3390, or_3386, or_3382, or_3375, or_3371, or_3367, or_3360, or_3356, or_3352};
  logic parity_3398;
  assign parity_3398 = ^{or_3390, or_3386, or_3382, or_3375, or_3371, or_3367, or_3360, or_3356, or_3352, or_3345, or_3341, and_3337};
  // hls/stages/count_bits.hpp:25
  logic or_3402;
  assign or_3402 = (or_3356 & or_3360) | (or_3352 & (or_3356 | or_3360));
  logic or_3406;
  assign or_3406 = (or_3371 & or_3375) | (or_3367 & (or_3371 | or_3375));
  logic or_3410;
  assign or_3410 = (or_3386 & or_3390) | (or_3382 & (or_3386 | or_3390));
  // hls/stages/count_bits.hpp:24
  logic parity_3413;
  assign parity_3413 = ^{or_3410, or_3406, or_3402};
  // hls/stages/count_bits.hpp:25
  logic and_3414;
  assign and_3414 = (^{or_3345, or_3341, and_3337}) & parity_3396;
  logic or_3418;
  assign or_3418 = (or_3341 & or_3345) | (and_3337 & (or_3341 | or_3345));
  logic or_3422;
  assign or_3422 = (parity_3378 & parity_3393) | ((^{or_3360, or_3356, or_3352}) & (parity_3378 | parity_3393));
  // hls/stages/count_bits.hpp:24
  logic parity_3425;
  assign parity_3425 = ^{or_3422, or_3418, and_3414};
  // hls/stages/count_bits.hpp:25
  logic and_3427;
  assign and_3427 = parity_3413 & parity_3425;
  logic or_3431;
  assign or_3431 = (or_3406 & or_3410) | (or_3402 & (or_3406 | or_3410));
  logic or_3435;
  assign or_3435 = (or_3418 & or_3422) | (and_3414 & (or_3418 | or_3422));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3480;
  assign select_3480 = equal_1777_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3483;
  assign select_3483 = equal_1775_s2_q ? patches_summed_first_q : (equal_1777_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:552
  logic [9:0] select_3490;
  assign select_3490 = less_1938_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3493;
  assign select_3493 = equal_1941_s2_q ? (less_1938_s2_q ? (equal_1941_s2_q ? 10'h0 : select_3490) : 10'h0) : select_3490;
  logic [9:0] select_3495;
  assign select_3495 = less_1938_s2_q ? (equal_1939_s2_q ? 10'h0 : select_3493) : select_3493;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3497;
  assign select_3497 = less_1938_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3500;
  assign select_3500 = equal_1941_s2_q ? (less_1938_s2_q ? (equal_1941_s2_q ? 5'h0 : select_3497) : 5'h0) : select_3497;
  logic [4:0] select_3502;
  assign select_3502 = less_1938_s2_q ? (equal_1939_s2_q ? 5'h0 : select_3500) : select_3500;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3504;
  assign select_3504 = less_1938_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3507;
  assign select_3507 = equal_1941_s2_q ? (less_1938_s2_q ? (equal_1941_s2_q ? 5'h0 : select_3504) : 5'h0) : select_3504;
  logic [4:0] select_3509;
  assign select_3509 = less_1938_s2_q ? (equal_1939_s2_q ? 5'h0 : select_3507) : select_3507;
  // hls/stages/patches.hpp:552
  logic and_3512;
  assign and_3512 = less_1938_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:556
  logic select_3515;
  assign select_3515 = equal_1941_s2_q ? (less_1938_s2_q ? (not_1942_s2_q & and_3512) : and_3512) : and_3512;
  // hls/stages/patches.hpp:184
  logic select_3518;
  assign select_3518 = equal_1775_s2_q ? (less_1938_s2_q ? (not_1940_s2_q & select_3515) : select_3515) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3529;
  assign or_3529 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3530;
  assign and_3530 = patches_read_searches_s2_q & or_3529;
  // hls/stages/patches.hpp:536
  logic [4:0] select_3531;
  assign select_3531 = and_3530 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:543
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3531};
  // hls/stages/patches.hpp:552
  logic and_3535;
  assign and_3535 = less_1938_s2_q & (equal_3527_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:556
  logic select_3538;
  assign select_3538 = equal_1941_s2_q ? (less_1938_s2_q ? (not_1942_s2_q & and_3535) : and_3535) : and_3535;
  // hls/stages/patches.hpp:184
  logic select_3541;
  assign select_3541 = equal_1775_s2_q ? (less_1938_s2_q ? (not_1940_s2_q & select_3538) : select_3538) : patches_read_above_q;
  // hls/stages/patches.hpp:552
  logic and_3544;
  assign and_3544 = less_1938_s2_q & (equal_3527_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:556
  logic select_3547;
  assign select_3547 = equal_1941_s2_q ? (less_1938_s2_q ? (not_1942_s2_q & and_3544) : and_3544) : and_3544;
  // hls/stages/patches.hpp:184
  logic select_3550;
  assign select_3550 = equal_1775_s2_q ? (less_1938_s2_q ? (not_1940_s2_q & select_3547) : select_3547) : patches_read_below_q;
  // hls/stages/patches.hpp:549
  logic [6:0] sum_3551;
  assign sum_3551 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3554;
  assign select_3554 = (equal_3527_s2_q & ({sum_3551[6], sum_3551} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3555;
  assign select_3555 = less_1938_s2_q ? select_3554 : 10'h3ff;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3557;
  assign select_3557 = less_1938_s2_q ? (equal_1941_s2_q ? 10'h3ff : select_3555) : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3558;
  assign select_3558 = equal_1941_s2_q ? select_3557 : select_3555;
  logic [9:0] select_3560;
  assign select_3560 = less_1938_s2_q ? (equal_1939_s2_q ? 10'h3ff : select_3558) : select_3558;
  // hls/stages/patches.hpp:535
  logic [14:0] select_3562;
  assign select_3562 = and_3530 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3563;
  assign select_3563 = equal_1775_s2_q ? select_3562[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3564;
  assign select_3564 = equal_1775_s2_q ? select_3562[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3566;
  assign select_3566 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3568;
  assign select_3568 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:539
  logic [9:0] select_3571;
  assign select_3571 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3572;
  assign select_3572 = patches_read_first_q ? patches_read_far_q : select_3571;
  // hls/stages/patches.hpp:590
  logic [9:0] difference_3575;
  assign difference_3575 = select_3572 - select_3562[9:0];
  // hls/stages/patches.hpp:575
  logic less_3605;
  assign less_3605 = select_3566 < select_3568;
  // hls/stages/patches.hpp:581
  logic [1:0] sum_3606;
  assign sum_3606 = select_3531[4:3] + 2'h3;
  // hls/stages/patches.hpp:576
  logic [9:0] high;
  assign high = less_3605 ? select_3568 : select_3566;
  logic [9:0] low;
  assign low = (select_3568 < select_3566) ? select_3568 : select_3566;
  // hls/stages/patches.hpp:577
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3562[9:0];
  // hls/stages/patches.hpp:579
  logic not_3613;
  assign not_3613 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3614;
  assign sum_3614 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3616;
  assign not_3616 = ~({eight, 3'h0} < {1'b0, sum_3614, fall_2[0]});
  logic [1:0] sum_3617;
  assign sum_3617 = {1'b0, not_3613} + {1'b0, not_3616};
  // hls/stages/patches.hpp:580
  logic [10:0] sum_3618;
  assign sum_3618 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3620;
  assign not_3620 = ~({eight, 3'h0} < {sum_3618, fall_2[1:0]});
  logic not_3623;
  assign not_3623 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3624;
  assign sum_3624 = {1'b0, not_3620} + {1'b0, not_3623};
  // hls/stages/patches.hpp:579
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3617} + {1'b0, sum_3624};
  // hls/stages/patches.hpp:582
  logic [7:0] select_3627;
  assign select_3627 = less_3605 ? ({sum_3606, select_3531[2:0], 3'h0} - {5'h0, fraction}) : {sum_3606, select_3531[2:0], fraction};
  // hls/stages/agreement.hpp:789
  logic select_3850;
  assign select_3850 = equal_570_s2_q ? shown_shown_q : (so_s2_q ? select_2009 : shown_shown_q);
  logic select_3852;
  assign select_3852 = equal_570_s2_q ? shown_nearer_q : (so_s2_q ? select_2012 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3854;
  assign sum_3854 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:461
  logic [2:0] select_3856;
  assign select_3856 = less_3853_s2_q ? (sum_3854[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3858;
  assign select_3858 = equal_2450_s2_q ? (equal_675_s2_q ? 3'h0 : select_3856) : region_row_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3863;
  assign select_3863 = equal_570_s2_q ? select_1963 : (so_s2_q ? (ends_cell_s2_q ? select_2062 : select_1963) : 8'h1);
  // hls/stages/agreement.hpp:461
  logic [8:0] select_3877;
  assign select_3877 = equal_675_s2_q ? {{2{difference_3875[6]}}, difference_3875} : (less_3853_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:521
  logic [8:0] select_3879;
  assign select_3879 = and_545_s2_q ? (equal_2450_s2_q ? select_3877 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:461
  logic [6:0] select_3881;
  assign select_3881 = equal_675_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_3883;
  assign select_3883 = and_545_s2_q ? (equal_2450_s2_q ? select_3881 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3884;
  assign sum_3884 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3885;
  assign select_3885 = sum_3854[7] ? {1'b1, sum_3854[6:0], region_down_rest_q[0]} : sum_3884;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3854[7];
  // hls/stages/agreement.hpp:461
  logic select_3889;
  assign select_3889 = equal_2450_s2_q ? (equal_675_s2_q | (less_3853_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3894;
  assign or_3894 = segment_starts_q | not_573_s2_q;
  // hls/stages/agreement.hpp:1031
  logic select_3897;
  assign select_3897 = inside_v_s2_q ? (sum_1976_s2_q ? (equal_1768 & or_1978) : or_1978) : or_3894;
  // hls/stages/agreement.hpp:789
  logic select_3900;
  assign select_3900 = equal_570_s2_q ? or_3894 : (so_s2_q ? (ends_cell_s2_q ? select_3897 : or_3894) : or_3894);
  // hls/stages/agreement.hpp:1148
  logic equal_3924;
  assign equal_3924 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:789
  logic select_4060;
  assign select_4060 = so_s2_q ? (ends_cell_s2_q ? and_2050 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4063;
  assign select_4063 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4065;
  assign select_4065 = equal_570_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4063 : centres_values_0_of_skin_q);
  logic select_4066;
  assign select_4066 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4068;
  assign select_4068 = equal_570_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4066 : centres_values_1_textured_q);
  logic select_4069;
  assign select_4069 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4071;
  assign select_4071 = equal_570_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4069 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:461
  logic [10:0] select_4075;
  assign select_4075 = equal_2450_s2_q ? (equal_4072_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_4078;
  assign select_4078 = and_545_s2_q ? (equal_2450_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1272
  logic xor_4079;
  assign xor_4079 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4081;
  assign select_4081 = and_1955_s2_q ? (left_first_s2_q ? xor_4079 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4083;
  assign select_4083 = and_1955_s2_q ? (left_first_s2_q ? xor_4079 : select_4081) : write_half_q;
  logic select_4085;
  assign select_4085 = left_first_s2_q ? select_2015 : (and_1955_s2_q ? select_2016 : read_half_q);
  logic and_4089;
  assign and_4089 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4098;
  assign select_4098 = left_first_s2_q ? 10'h1 : (and_1955_s2_q ? select_2020 : rows_passed_q);
  logic [8:0] select_4101;
  assign select_4101 = left_first_s2_q ? {select_2018[7:0], or_2017} : (and_1955_s2_q ? {select_2018[7:0], or_2017} : columns_passed_q);
  logic select_4104;
  assign select_4104 = left_first_s2_q ? marks_last_s2_q : (and_1955_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4107;
  assign select_4107 = left_first_s2_q ? and_2034 : (and_1955_s2_q ? and_2034 : began_q);
  logic [2:0] select_4110;
  assign select_4110 = left_first_s2_q ? select_2036 : (and_1955_s2_q ? select_2036 : seen_x_q);
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_4115;
  assign select_4115 = left_first_s2_q ? 3'h0 : (and_2021 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4117;
  assign select_4117 = left_first_s2_q ? 3'h0 : (and_1955_s2_q ? select_4115 : seen_y_q);
  logic [7:0] select_4120;
  assign select_4120 = left_first_s2_q ? select_2029 : (and_1955_s2_q ? select_2029 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4126;
  assign select_4126 = left_first_s2_q ? select_4124 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4128;
  assign select_4128 = left_first_s2_q ? select_4124 : (and_1955_s2_q ? select_4126 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4133;
  assign and_4133 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4135;
  assign select_4135 = left_first_s2_q ? and_4133 : (and_1955_s2_q ? and_4133 : at_cell_end_q);
  logic select_4138;
  assign select_4138 = left_first_s2_q ? next_row : (and_1955_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4141;
  assign select_4141 = left_first_s2_q ? 11'h0 : (and_1955_s2_q ? select_2026 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4214;
  assign not_4214 = ~quarter[1];
  logic [3:0] select_4215;
  assign select_4215 = quarter[0] ? {quarter[1], 1'b0, not_4214, 1'b0} : {1'b0, quarter[1], 1'b0, not_4214};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1610;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1653;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:763; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1687;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1689));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1399; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1973;
  logic regions_re;
  assign regions_re = s2_en & (equal_570_s2_q ? (x_s2_q[6] & not_1974) : and_1981);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1410; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2031;
  logic map_re;
  assign map_re = s2_en & select_2043;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_515_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_520_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_539, and_535, sum_531, sum_527};
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
  assign census_memory_waddr = column_s2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_545_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_563, whole_2, select_555, select_551};
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
  assign moments_memory_waddr = select_569_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_587_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_642_s2_q, and_640_s2_q, and_635_s2_q, and_633};
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
  assign best_left_we = s2_en & and_1557_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1556, select_1553, select_1550, select_1548, select_1530, select_1527, select_1519, select_1518, select_1513};
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
  assign best_right_we = s2_en & and_1557_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1567, select_1566, select_1563, select_1562};
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
  assign shown_right_waddr = select_1574_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1585;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1582, not_573_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1593, and_1590};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1602, and_1599};
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
  assign patches_right_codes_we = s2_en & and_1923_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1909_s2_q, less_1908_s2_q, less_1899_s2_q, less_1898_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1927, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1937_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1909_s2_q, less_1908_s2_q, less_1899_s2_q, less_1898_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1570_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2008, textured};
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
      patches_choice_column_q <= 7'h0;
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
      averager_running_of_skin_q <= select_2174;
      averager_mask_q <= select_2176;
      averager_of_skin_q <= select_2178;
      census_filled_q <= and_545_s2_q ? {select_678[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2273;
      moments_turned_1_q <= sum_2275;
      moments_before_0_q <= equal_570_s2_q ? select_2277 : moments_before_0_q;
      moments_before_1_q <= equal_570_s2_q ? select_2279 : moments_before_1_q;
      moments_has_before_q <= select_2282;
      moments_most_before_q <= select_2285;
      moments_left_begins_q <= select_2289;
      moments_left_alone_q <= select_2293;
      moments_left_other_stops_q <= select_2296;
      moments_right_begins_q <= select_2299;
      moments_right_alone_q <= select_2303;
      moments_right_other_stops_q <= select_2306;
      moments_out_of_step_q <= or_2309;
      moments_turns_0_q <= and_2317;
      moments_turns_1_q <= and_2321;
      moments_begins_alone_q <= and_2330;
      moments_ends_q <= equal_570_s2_q & (equal_2276 & (not_2331 | and_2333));
      rows_passed_above_q <= and_545_s2_q ? select_677 : rows_passed_above_q;
      chosen_score_q <= less_2560 ? select_1507 : select_2559;
      chosen_near_q <= (select_2562 < select_1542) ? select_1542 : select_2562;
      chosen_place_q <= less_2560 ? {select_1515, not_1514} : 3'h2;
      before_0_q <= select_2559;
      before_1_q <= sum_1257;
      before_2_q <= sum_1505;
      shift_allowed_q <= not_2567 & (~less_2568);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2575 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2694});
      counts_turned_right_q <= and_2575 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2701});
      registration_displacement_over_q <= so_s2_q ? sum_2725[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2727;
      registration_slope_here_q <= select_2729;
      registration_expected_q <= select_2731;
      registration_of_right_q <= equal_570_s2_q ? registration_of_right_q : select_2793;
      registration_was_inside_q <= equal_570_s2_q ? registration_was_inside_q : select_2796;
      registration_fresh_q <= select_2805;
      patches_chance_q <= and_545_s2_q ? select_2962 : patches_chance_q;
      patches_fixed_q <= and_2976;
      patches_choice_valid_q <= and_1773 ? (select_1746 & not_2964) : select_1746;
      patches_choice_column_q <= select_1751;
      patches_choice_shift_q <= select_1756;
      patches_choice_slope_q <= select_1767;
      patches_band_q <= sample_pair_whole_s2_q ? select_1788 : patches_band_q;
      patches_fetch_q <= select_2991;
      patches_codes_at_q <= select_3092;
      patches_codes_further_q <= equal_1775_s2_q ? patches_codes_further_q : select_3097;
      patches_next_codes_q <= select_3105;
      patches_set_q <= equal_1775_s2_q ? 3'h0 : (equal_1777_s2_q ? 3'h0 : select_3119);
      patches_size_q <= sum_3123;
      patches_left_row_q <= select_3135;
      patches_summed_row_column_q <= equal_1775_s2_q ? patches_summed_row_column_q : select_3480;
      patches_summed_first_q <= select_3483;
      patches_read_row_differing_q <= equal_1775_s2_q ? select_3495 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1775_s2_q ? select_3502 : patches_read_row_column_q;
      patches_read_at_q <= equal_1775_s2_q ? select_3509 : patches_read_at_q;
      patches_read_first_q <= select_3518;
      patches_read_above_q <= select_3541;
      patches_read_below_q <= select_3550;
      patches_read_far_q <= equal_1775_s2_q ? select_3560 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3563;
      patches_peak_best_column_q <= select_3564;
      patches_peak_row_q <= equal_1775_s2_q ? select_3531 : patches_peak_row_q;
      patches_peak_above_q <= equal_1775_s2_q ? select_3566 : patches_peak_above_q;
      patches_peak_below_q <= equal_1775_s2_q ? select_3568 : patches_peak_below_q;
      patches_peak_far_q <= equal_1775_s2_q ? select_3572 : patches_peak_far_q;
      patches_frame_ended_q <= equal_570_s2_q & equal_2276;
      shown_shown_q <= select_3850;
      shown_nearer_q <= select_3852;
      region_row_q <= and_545_s2_q ? select_3858 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3863;
      region_down_rest_q <= select_3879;
      region_down_back_q <= select_3883;
      region_down_next_q <= select_3885;
      region_fresh_q <= and_545_s2_q ? select_3889 : region_fresh_q;
      segment_starts_q <= select_3900;
      centres_values_0_textured_q <= equal_570_s2_q ? centres_values_0_textured_q : select_4060;
      centres_values_0_of_skin_q <= select_4065;
      centres_values_1_textured_q <= select_4068;
      centres_values_1_of_skin_q <= select_4071;
      map_row_q <= and_545_s2_q ? select_4075 : map_row_q;
      map_width_q <= select_4078;
      write_half_q <= select_4083;
      read_half_q <= and_1955_s2_q ? select_4085 : read_half_q;
      done_q <= and_1955_s2_q ? (not_2032 & and_4089) : and_4089;
      drew_q <= so_s2_q;
      said_q <= equal_570_s2_q & equal_3924;
      rows_passed_q <= and_1955_s2_q ? select_4098 : rows_passed_q;
      columns_passed_q <= and_1955_s2_q ? select_4101 : columns_passed_q;
      line_ended_q <= and_1955_s2_q ? select_4104 : line_ended_q;
      began_q <= and_1955_s2_q ? select_4107 : began_q;
      seen_x_q <= and_1955_s2_q ? select_4110 : seen_x_q;
      seen_y_q <= and_1955_s2_q ? select_4117 : seen_y_q;
      seen_column_q <= and_1955_s2_q ? select_4120 : seen_column_q;
      seen_rows_left_q <= and_1955_s2_q ? select_4128 : seen_rows_left_q;
      at_cell_end_q <= and_1955_s2_q ? select_4135 : at_cell_end_q;
      was_next_row_q <= and_1955_s2_q ? select_4138 : was_next_row_q;
      seen_base_q <= and_1955_s2_q ? select_4141 : seen_base_q;
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
      left_pixel_q <= and_1955_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_523 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_529 : averager_running_1_q;
      averager_total_0_q <= select_2153;
      averager_total_1_q <= select_2155;
      census_columns_values_0_cell_0_left_q <= select_2179;
      census_columns_values_0_cell_0_right_q <= select_2180;
      census_columns_values_0_cell_0_mask_q <= and_545_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2182;
      census_columns_values_0_cell_1_right_q <= select_2183;
      census_columns_values_0_cell_1_mask_q <= select_2184;
      census_columns_values_0_cell_2_left_q <= select_2185;
      census_columns_values_0_cell_2_right_q <= select_2186;
      census_columns_values_0_cell_2_mask_q <= select_2187;
      census_columns_values_0_cell_2_of_skin_q <= select_2188;
      census_columns_values_0_cell_3_left_q <= select_2189;
      census_columns_values_0_cell_3_right_q <= select_2190;
      census_columns_values_0_cell_3_mask_q <= select_2191;
      census_columns_values_0_cell_4_left_q <= select_2192;
      census_columns_values_0_cell_4_right_q <= select_2193;
      census_columns_values_0_cell_4_mask_q <= select_2194;
      census_columns_values_1_cell_0_left_q <= select_2195;
      census_columns_values_1_cell_0_right_q <= select_2196;
      census_columns_values_1_cell_0_mask_q <= select_2197;
      census_columns_values_1_cell_1_left_q <= select_2198;
      census_columns_values_1_cell_1_right_q <= select_2199;
      census_columns_values_1_cell_1_mask_q <= select_2200;
      census_columns_values_1_cell_2_left_q <= select_2201;
      census_columns_values_1_cell_2_right_q <= select_2202;
      census_columns_values_1_cell_2_mask_q <= select_2203;
      census_columns_values_1_cell_2_of_skin_q <= select_2204;
      census_columns_values_1_cell_3_left_q <= select_2205;
      census_columns_values_1_cell_3_right_q <= select_2206;
      census_columns_values_1_cell_3_mask_q <= select_2207;
      census_columns_values_1_cell_4_left_q <= select_2208;
      census_columns_values_1_cell_4_right_q <= select_2209;
      census_columns_values_1_cell_4_mask_q <= select_2210;
      census_columns_values_2_cell_0_left_q <= select_2211;
      census_columns_values_2_cell_0_right_q <= select_2212;
      census_columns_values_2_cell_0_mask_q <= select_2213;
      census_columns_values_2_cell_1_left_q <= select_2214;
      census_columns_values_2_cell_1_right_q <= select_2215;
      census_columns_values_2_cell_1_mask_q <= select_2216;
      census_columns_values_2_cell_2_left_q <= select_2217;
      census_columns_values_2_cell_2_right_q <= select_2218;
      census_columns_values_2_cell_2_mask_q <= select_2219;
      census_columns_values_2_cell_3_left_q <= select_2220;
      census_columns_values_2_cell_3_right_q <= select_2221;
      census_columns_values_2_cell_3_mask_q <= select_2222;
      census_columns_values_2_cell_4_left_q <= select_2223;
      census_columns_values_2_cell_4_right_q <= select_2224;
      census_columns_values_2_cell_4_mask_q <= select_2225;
      census_columns_values_3_cell_0_mask_q <= select_2226;
      census_columns_values_3_cell_1_left_q <= select_2227;
      census_columns_values_3_cell_1_right_q <= select_2228;
      census_columns_values_3_cell_1_mask_q <= select_2229;
      census_columns_values_3_cell_2_mask_q <= select_2230;
      census_columns_values_3_cell_3_left_q <= select_2231;
      census_columns_values_3_cell_3_right_q <= select_2232;
      census_columns_values_3_cell_3_mask_q <= select_2233;
      census_columns_values_3_cell_4_mask_q <= select_2234;
      sharpness_last_mean_0_q <= and_545_s2_q ? select_551 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_545_s2_q ? select_555 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2550;
      middle_sum_columns_values_2_q <= select_2551;
      middle_sum_columns_values_3_q <= select_2552;
      middle_sum_columns_values_4_q <= select_2553;
      middle_sum_columns_values_5_q <= select_2554;
      middle_sum_columns_values_6_q <= select_2555;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1007;
      sums_0_sum_sums_values_0_q <= sum_1257;
      sums_0_sum_sums_values_1_q <= equal_1255 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1505;
      sums_1_sum_sums_values_1_q <= equal_1255 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_509_s3_q;
  logic [5:0] select_511_s3_q;
  logic [5:0] column_s3_q;
  logic and_543_s3_q;
  logic and_545_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_548_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_565_s3_q;
  logic equal_570_s3_q;
  logic not_571_s3_q;
  logic less_648_s3_q;
  logic less_649_s3_q;
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
  logic and_679_s3_q;
  logic and_704_s3_q;
  logic and_705_s3_q;
  logic [11:0] sum_720_s3_q;
  logic [9:0] sum_723_s3_q;
  logic and_731_s3_q;
  logic and_735_s3_q;
  logic less_736_s3_q;
  logic less_740_s3_q;
  logic less_742_s3_q;
  logic equal_1603_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1609_s3_q;
  logic equal_1611_s3_q;
  logic equal_1613_s3_q;
  logic equal_1615_s3_q;
  logic equal_1617_s3_q;
  logic equal_1619_s3_q;
  logic equal_1621_s3_q;
  logic equal_1623_s3_q;
  logic equal_1625_s3_q;
  logic less_1634_s3_q;
  logic or_1638_s3_q;
  logic equal_1658_s3_q;
  logic and_1668_s3_q;
  logic and_1671_s3_q;
  logic select_1688_s3_q;
  logic equal_1689_s3_q;
  logic and_1697_s3_q;
  logic equal_1699_s3_q;
  logic select_1746_s3_q;
  logic and_1774_s3_q;
  logic equal_1775_s3_q;
  logic equal_1777_s3_q;
  logic and_1790_s3_q;
  logic [4:0] select_1805_s3_q;
  logic select_1811_s3_q;
  logic [3:0] select_1852_s3_q;
  logic less_1938_s3_q;
  logic equal_1939_s3_q;
  logic not_1940_s3_q;
  logic equal_1941_s3_q;
  logic and_1955_s3_q;
  logic select_1957_s3_q;
  logic and_1960_s3_q;
  logic or_1966_s3_q;
  logic or_1969_s3_q;
  logic or_1972_s3_q;
  logic not_1974_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2001_s3_q;
  logic and_2006_s3_q;
  logic and_2038_s3_q;
  logic less_2039_s3_q;
  logic [11:0] sum_2047_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2065_s3_q;
  logic or_2068_s3_q;
  logic or_2071_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2121_s3_q;
  logic [11:0] sum_2250_s3_q;
  logic [9:0] sum_2253_s3_q;
  logic equal_2261_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2575_s3_q;
  logic and_2581_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2643_s3_q;
  logic and_2677_s3_q;
  logic and_2735_s3_q;
  logic and_2736_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2772_s3_q;
  logic and_2786_s3_q;
  logic equal_2829_s3_q;
  logic parity_3207_s3_q;
  logic parity_3336_s3_q;
  logic parity_3398_s3_q;
  logic xor_3426_s3_q;
  logic parity_3438_s3_q;
  logic or_3442_s3_q;
  logic equal_3443_s3_q;
  logic [4:0] select_3562_s3_q;
  logic equal_3574_s3_q;
  logic less_3576_s3_q;
  logic less_3577_s3_q;
  logic or_3582_s3_q;
  logic [7:0] select_3627_s3_q;
  logic equal_3924_s3_q;
  logic and_4144_s3_q;
  logic equal_4217_s3_q;
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
      select_509_s3_q <= select_509_s2_q;
      select_511_s3_q <= select_511_s2_q;
      column_s3_q <= column_s2_q;
      and_543_s3_q <= and_543_s2_q;
      and_545_s3_q <= and_545_s2_q;
      grey_s3_q <= grey;
      equal_548_s3_q <= equal_548;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_565_s3_q <= equal_565_s2_q;
      equal_570_s3_q <= equal_570_s2_q;
      not_571_s3_q <= not_571_s2_q;
      less_648_s3_q <= less_648;
      less_649_s3_q <= less_649;
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
      and_679_s3_q <= and_679;
      and_704_s3_q <= whole_22 & and_679;
      and_705_s3_q <= census_columns_values_1_cell_2_mask_q & and_679;
      sum_720_s3_q <= {1'b0, sum_716} + {2'h0, sum_719};
      sum_723_s3_q <= {9'h0, difference_721[9]} + {1'b0, xor_722};
      and_731_s3_q <= and_731;
      and_735_s3_q <= and_735;
      less_736_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_740_s3_q <= {{5{sum_739[6]}}, sum_739, half_grey_levels_2[3:0]} < 16'hffe1;
      less_742_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1603_s3_q <= equal_1603;
      all_s3_q <= all;
      sum_1609_s3_q <= sum_1609;
      equal_1611_s3_q <= equal_1611;
      equal_1613_s3_q <= equal_1613;
      equal_1615_s3_q <= equal_1615;
      equal_1617_s3_q <= equal_1617;
      equal_1619_s3_q <= equal_1619;
      equal_1621_s3_q <= equal_1621;
      equal_1623_s3_q <= equal_1623;
      equal_1625_s3_q <= equal_1625;
      less_1634_s3_q <= less_1634;
      or_1638_s3_q <= or_1638;
      equal_1658_s3_q <= (registration_fresh_q & select_1656) == 4'h0;
      and_1668_s3_q <= not_571_s2_q & and_1652;
      and_1671_s3_q <= and_1671_s2_q;
      select_1688_s3_q <= select_1688[1];
      equal_1689_s3_q <= equal_1689;
      and_1697_s3_q <= and_1697;
      equal_1699_s3_q <= equal_1699;
      select_1746_s3_q <= select_1746;
      and_1774_s3_q <= and_1774;
      equal_1775_s3_q <= equal_1775_s2_q;
      equal_1777_s3_q <= equal_1777_s2_q;
      and_1790_s3_q <= and_1774 & equal_1789;
      select_1805_s3_q <= select_1805_s2_q;
      select_1811_s3_q <= select_1811_s2_q;
      select_1852_s3_q <= select_1852_s2_q;
      less_1938_s3_q <= less_1938_s2_q;
      equal_1939_s3_q <= equal_1939_s2_q;
      not_1940_s3_q <= not_1940_s2_q;
      equal_1941_s3_q <= equal_1941_s2_q;
      and_1955_s3_q <= and_1955_s2_q;
      select_1957_s3_q <= select_1957_s2_q;
      and_1960_s3_q <= and_1960_s2_q;
      or_1966_s3_q <= or_1966;
      or_1969_s3_q <= or_1969;
      or_1972_s3_q <= or_1972;
      not_1974_s3_q <= not_1974;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2001_s3_q <= inside_v_s2_q & (and_1999 & and_1581);
      and_2006_s3_q <= not_571_s2_q & and_1981;
      and_2038_s3_q <= and_2038;
      less_2039_s3_q <= less_2039;
      sum_2047_s3_q <= sum_2047;
      textured_2_s3_q <= textured_2;
      or_2065_s3_q <= or_2065;
      or_2068_s3_q <= select_2062[7] | (~({select_2062[6], select_2062[3:2]} == 3'h0));
      or_2071_s3_q <= select_2062[7] | (~(select_2062[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2121_s3_q <= and_2121;
      sum_2250_s3_q <= {1'b0, sum_2246} + {2'h0, sum_2249};
      sum_2253_s3_q <= {9'h0, difference_2251[9]} + {1'b0, xor_2252};
      equal_2261_s3_q <= equal_2261_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2575_s3_q <= and_2575;
      and_2581_s3_q <= and_2581;
      explained_2_s3_q <= explained_2;
      and_2643_s3_q <= not_571_s2_q & and_2642;
      and_2677_s3_q <= not_571_s2_q & and_2676;
      and_2735_s3_q <= not_571_s2_q & (so_s2_q & (half_ends & equal_2732));
      and_2736_s3_q <= and_2736;
      residual_s3_q <= residual[7:0];
      and_2772_s3_q <= and_2772;
      and_2786_s3_q <= and_2736 & less_2785;
      equal_2829_s3_q <= (registration_fresh_q & select_2827) == 4'h0;
      parity_3207_s3_q <= ^{xor_3203, xor_3166, select_3133[44:36], other[44:36]};
      parity_3336_s3_q <= parity_3336;
      parity_3398_s3_q <= parity_3398;
      xor_3426_s3_q <= parity_3413 ^ parity_3425;
      parity_3438_s3_q <= ^{or_3435, or_3431, and_3427};
      or_3442_s3_q <= (or_3431 & or_3435) | (and_3427 & (or_3431 | or_3435));
      equal_3443_s3_q <= equal_3443_s2_q;
      select_3562_s3_q <= select_3562[14:10];
      equal_3574_s3_q <= select_3531[3:0] == 4'h0;
      less_3576_s3_q <= {difference_3575, 3'h0} < {3'h0, sum_3123};
      less_3577_s3_q <= select_3572 < select_3562[9:0];
      or_3582_s3_q <= (sum_3123 < 10'h39) | ({1'b0, sum_3123[9:1]} < select_3562[9:0]);
      select_3627_s3_q <= select_3627;
      equal_3924_s3_q <= equal_3924;
      and_4144_s3_q <= and_2121 & (sum_2047 == sum_2031);
      equal_4217_s3_q <= (registration_fresh_q & select_4215) == 4'h0;
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
  logic [6:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic patches_place_1_valid_q;
  logic [6:0] patches_place_1_column_q;
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
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_720_s3_q + {2'h0, sum_723_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_725;
  assign sum_725 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_727;
  assign sum_727 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_725});
  // hls/stages/census.hpp:305
  logic less_728;
  assign less_728 = 9'h4 < sum_727[13:5];
  logic and_729;
  assign and_729 = and_679_s3_q & less_728;
  // hls/stages/moments.hpp:30
  logic and_741;
  assign and_741 = (and_704_s3_q & and_731_s3_q) & less_740_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1660;
  assign equal_1660 = sum_1609_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1609_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1662;
  assign select_1662 = equal_1660 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1663;
  assign sum_1663 = (equal_1658_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1662[13]}}, select_1662};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1609_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1666;
  assign select_1666 = equal_1660 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1667;
  assign sum_1667 = (equal_1658_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1666[6]}}, select_1666};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1791;
  assign select_1791 = and_1790_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1746_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1793;
  assign select_1793 = equal_1689_s3_q ? patches_place_0_valid_q : (select_1688_s3_q ? patches_place_0_valid_q : select_1791[0]);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1794;
  assign select_1794 = select_1688_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1791[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1795;
  assign select_1795 = equal_1689_s3_q ? patches_place_0_column_q : select_1794[6:0];
  logic [5:0] select_1796;
  assign select_1796 = equal_1689_s3_q ? patches_place_0_shift_q : select_1794[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1797;
  assign sum_1797 = select_1795 + {select_1796[5], select_1796};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1798;
  assign sum_1798 = sum_1797[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1799;
  assign equal_1799 = {sum_1798[5], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1798[4:0], sum_1797[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1801;
  assign or_1801 = and_1671_s3_q | (select_1793 & equal_1799);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1802;
  assign select_1802 = or_1801 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1812;
  assign select_1812 = or_1801 ? {and_1671_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1814;
  assign and_1814 = select_1811_s3_q & (~select_1812[5]);
  // hls/stages/patches.hpp:127
  logic select_1822;
  assign select_1822 = equal_1689_s3_q ? patches_place_1_valid_q : (select_1688_s3_q ? select_1791[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1823;
  assign select_1823 = select_1688_s3_q ? select_1791[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1824;
  assign select_1824 = equal_1689_s3_q ? patches_place_1_column_q : select_1823[6:0];
  logic [5:0] select_1825;
  assign select_1825 = equal_1689_s3_q ? patches_place_1_shift_q : select_1823[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1826;
  assign sum_1826 = select_1824 + {select_1825[5], select_1825};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1827;
  assign sum_1827 = sum_1826[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1828;
  assign equal_1828 = {sum_1827[5], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1827[4:0], sum_1826[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1830;
  assign or_1830 = and_1671_s3_q | (select_1822 & equal_1828);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1831;
  assign select_1831 = or_1830 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1832;
  assign select_1832 = or_1830 ? {and_1671_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1834;
  assign and_1834 = select_1811_s3_q & (~select_1832[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1841;
  assign sum_1841 = select_1795 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1842;
  assign equal_1842 = {sum_1841[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1841[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1844;
  assign or_1844 = and_1671_s3_q | (select_1793 & equal_1842);
  logic [4:0] select_1845;
  assign select_1845 = or_1844 ? {and_1671_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1846;
  assign sum_1846 = select_1824 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1847;
  assign equal_1847 = {sum_1846[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1846[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1850;
  assign select_1850 = (and_1671_s3_q | (select_1822 & equal_1847)) ? {and_1671_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1845[4] ? select_1850[3:0] : select_1845[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1853;
  assign select_1853 = or_1844 ? and_1671_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1859;
  assign and_1859 = (select_1811_s3_q & (select_1805_s3_q[3] ^ select_1805_s3_q[4])) & ((~select_1845[4]) | (~select_1850[4]));
  // hls/stages/patches.hpp:184
  logic less_1950;
  assign less_1950 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1951;
  assign not_1951 = ~less_1950;
  logic [1:0] select_1952;
  assign select_1952 = patches_summed_first_s3_q ? 2'h2 : {less_1950, not_1951};
  logic [12:0] select_1953;
  assign select_1953 = select_1952[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1961;
  assign select_1961 = select_1952[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1960_s3_q, 1'b0, select_1957_s3_q, left_pixel_q};
  logic [14:0] select_1962;
  assign select_1962 = select_1952[1] ? {select_1953[12:8], patches_sums_values_0_q[9:8], select_1953[7:0]} : select_1961;
  // hls/stages/agreement.hpp:901
  logic [5:0] select_1987;
  assign select_1987 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_1988;
  assign sum_1988 = {5'h0, textured_s3_q} + select_1987;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_1990;
  assign sum_1990 = {4'h0, sum_1988} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:901
  logic [5:0] select_1992;
  assign select_1992 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_1993;
  assign sum_1993 = {5'h0, explained_s3_q} + select_1992;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_1995;
  assign sum_1995 = {4'h0, sum_1993} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:901
  logic [5:0] select_2002;
  assign select_2002 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:903
  logic [5:0] sum_2003;
  assign sum_2003 = {5'h0, and_2001_s3_q} + select_2002;
  // hls/stages/agreement.hpp:1064
  logic [9:0] sum_2005;
  assign sum_2005 = {4'h0, sum_2003} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2056;
  assign select_2056 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2057;
  assign difference_2057 = {1'b0, textured_2_s3_q} - {1'b0, select_2056};
  logic [4:0] t;
  assign t = {difference_2057[3], difference_2057} + (equal_565_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic equal_2060;
  assign equal_2060 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1102
  logic not_2072;
  assign not_2072 = ~region_row_s3_q[2];
  logic [2:0] select_2073;
  assign select_2073 = region_row_s3_q[1] ? {1'b0, not_2072, 1'b0} : {region_row_s3_q[2], 1'b0, not_2072};
  logic [5:0] select_2074;
  assign select_2074 = region_row_s3_q[0] ? {select_2073[2], 1'b0, select_2073[1], 1'b0, select_2073[0], 1'b0} : {1'b0, select_2073[2], 1'b0, select_2073[1], 1'b0, select_2073[0]};
  logic [11:0] select_2075;
  assign select_2075 = or_2071_s3_q ? {select_2074[5], 1'b0, select_2074[4], 1'b0, select_2074[3], 1'b0, select_2074[2], 1'b0, select_2074[1], 1'b0, select_2074[0], 1'b0} : {1'b0, select_2074[5], 1'b0, select_2074[4], 1'b0, select_2074[3], 1'b0, select_2074[2], 1'b0, select_2074[1], 1'b0, select_2074[0]};
  logic [23:0] select_2076;
  assign select_2076 = or_2068_s3_q ? {select_2075[11], 1'b0, select_2075[10], 1'b0, select_2075[9], 1'b0, select_2075[8], 1'b0, select_2075[7], 1'b0, select_2075[6], 1'b0, select_2075[5], 1'b0, select_2075[4], 1'b0, select_2075[3], 1'b0, select_2075[2], 1'b0, select_2075[1], 1'b0, select_2075[0], 1'b0} : {1'b0, select_2075[11], 1'b0, select_2075[10], 1'b0, select_2075[9], 1'b0, select_2075[8], 1'b0, select_2075[7], 1'b0, select_2075[6], 1'b0, select_2075[5], 1'b0, select_2075[4], 1'b0, select_2075[3], 1'b0, select_2075[2], 1'b0, select_2075[1], 1'b0, select_2075[0]};
  logic [47:0] select_2077;
  assign select_2077 = or_2065_s3_q ? {select_2076[23], 1'b0, select_2076[22], 1'b0, select_2076[21], 1'b0, select_2076[20], 1'b0, select_2076[19], 1'b0, select_2076[18], 1'b0, select_2076[17], 1'b0, select_2076[16], 1'b0, select_2076[15], 1'b0, select_2076[14], 1'b0, select_2076[13], 1'b0, select_2076[12], 1'b0, select_2076[11], 1'b0, select_2076[10], 1'b0, select_2076[9], 1'b0, select_2076[8], 1'b0, select_2076[7], 1'b0, select_2076[6], 1'b0, select_2076[5], 1'b0, select_2076[4], 1'b0, select_2076[3], 1'b0, select_2076[2], 1'b0, select_2076[1], 1'b0, select_2076[0], 1'b0} : {1'b0, select_2076[23], 1'b0, select_2076[22], 1'b0, select_2076[21], 1'b0, select_2076[20], 1'b0, select_2076[19], 1'b0, select_2076[18], 1'b0, select_2076[17], 1'b0, select_2076[16], 1'b0, select_2076[15], 1'b0, select_2076[14], 1'b0, select_2076[13], 1'b0, select_2076[12], 1'b0, select_2076[11], 1'b0, select_2076[10], 1'b0, select_2076[9], 1'b0, select_2076[8], 1'b0, select_2076[7], 1'b0, select_2076[6], 1'b0, select_2076[5], 1'b0, select_2076[4], 1'b0, select_2076[3], 1'b0, select_2076[2], 1'b0, select_2076[1], 1'b0, select_2076[0]};
  // hls/stages/agreement.hpp:1031
  logic and_2081;
  assign and_2081 = good_known_q & (~((good_q & select_2077) == 48'h0));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2090;
  assign select_2090 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2091;
  assign difference_2091 = {1'b0, shown_2_s3_q} - {1'b0, select_2090};
  logic [4:0] around;
  assign around = {difference_2091[3], difference_2091} + (equal_565_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1104
  logic [5:0] sum_2094;
  assign sum_2094 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2060 ? and_2081 : (~({sum_2094, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1098
  logic [2:0] select_2106;
  assign select_2106 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2107;
  assign difference_2107 = {1'b0, near_2_s3_q} - {1'b0, select_2106};
  logic [4:0] n;
  assign n = {difference_2107[3], difference_2107} + (equal_565_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic and_2111;
  assign and_2111 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2145;
  assign select_2145 = sample_pair_whole_s3_q ? (and_543_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2147;
  assign select_2147 = sample_pair_whole_s3_q ? (and_543_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2149;
  assign select_2149 = sample_pair_whole_s3_q ? (and_543_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2151;
  assign select_2151 = sample_pair_whole_s3_q ? (and_543_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2156;
  assign sum_2156 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2157;
  assign difference_2157 = {1'b0, sum_2156[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2158;
  assign xor_2158 = {difference_2157[8:0], sum_2156[0]} ^ {10{difference_2157[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2157[9]} + {1'b0, xor_2158};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_548_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2163;
  assign select_2163 = sample_pair_whole_s3_q ? (and_543_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2164;
  assign sum_2164 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2165;
  assign difference_2165 = {1'b0, sum_2164[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2166;
  assign xor_2166 = {difference_2165[8:0], sum_2164[0]} ^ {10{difference_2165[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2165[9]} + {1'b0, xor_2166};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_548_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2171;
  assign select_2171 = sample_pair_whole_s3_q ? (and_543_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2254;
  assign sum_2254 = sum_2250_s3_q + {2'h0, sum_2253_s3_q};
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2256;
  assign select_2256 = and_545_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2257;
  assign select_2257 = and_545_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2258;
  assign select_2258 = and_545_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2259;
  assign select_2259 = and_545_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2262;
  assign sum_2262 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2254};
  logic [13:0] sum_2264;
  assign sum_2264 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2262});
  // hls/stages/census.hpp:311
  logic and_2266;
  assign and_2266 = and_704_s3_q & (9'h4 < sum_2264[13:5]);
  // hls/stages/census.hpp:312
  logic and_2267;
  assign and_2267 = and_704_s3_q & less_728;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2268;
  assign sum_2268 = census_left_misses_q + {{17{and_2267}}, and_2266, 1'b0, and_2266};
  // hls/stages/agreement.hpp:521
  logic [19:0] select_2270;
  assign select_2270 = and_545_s3_q ? (equal_2261_s3_q ? 20'h0 : sum_2268) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2340;
  assign select_2340 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:521
  logic select_2343;
  assign select_2343 = and_545_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2346;
  assign and_2346 = whole_2_s3_q & (~(column_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:458
  logic and_2352;
  assign and_2352 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2353;
  assign and_2353 = and_2346 & and_2352;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2340[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2355;
  assign select_2355 = and_2353 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2357;
  assign select_2357 = equal_2261_s3_q ? {11'h0, select_2355} : (sharpness_sums_detail_0_q + {11'h0, select_2355});
  // hls/stages/agreement.hpp:458
  logic and_2364;
  assign and_2364 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2365;
  assign and_2365 = and_2346 & and_2364;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2340[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2367;
  assign select_2367 = and_2365 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2369;
  assign select_2369 = equal_2261_s3_q ? {11'h0, select_2367} : (sharpness_sums_detail_1_q + {11'h0, select_2367});
  logic [8:0] select_2372;
  assign select_2372 = and_2353 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2373;
  assign sum_2373 = (equal_2261_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2372};
  logic [8:0] select_2376;
  assign select_2376 = and_2365 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2377;
  assign sum_2377 = (equal_2261_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2376};
  // hls/stages/agreement.hpp:211
  logic equal_2379;
  assign equal_2379 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2380;
  assign less_2380 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2381;
  assign less_2381 = x_s3_q[4:0] < 5'h3;
  logic not_2382;
  assign not_2382 = ~x_s3_q[1];
  logic [2:0] select_2383;
  assign select_2383 = x_s3_q[0] ? {1'b0, not_2382, 1'b0} : {x_s3_q[1], 1'b0, not_2382};
  logic [5:0] select_2384;
  assign select_2384 = slot_s3_q[2] ? {select_2383[2], 1'b0, select_2383[1], 1'b0, select_2383[0], 1'b0} : {1'b0, select_2383[2], 1'b0, select_2383[1], 1'b0, select_2383[0]};
  logic [11:0] select_2385;
  assign select_2385 = slot_s3_q[1] ? {select_2384[5], 1'b0, select_2384[4], 1'b0, select_2384[3], 1'b0, select_2384[2], 1'b0, select_2384[1], 1'b0, select_2384[0], 1'b0} : {1'b0, select_2384[5], 1'b0, select_2384[4], 1'b0, select_2384[3], 1'b0, select_2384[2], 1'b0, select_2384[1], 1'b0, select_2384[0]};
  logic [23:0] select_2386;
  assign select_2386 = slot_s3_q[0] ? {select_2385[11], 1'b0, select_2385[10], 1'b0, select_2385[9], 1'b0, select_2385[8], 1'b0, select_2385[7], 1'b0, select_2385[6], 1'b0, select_2385[5], 1'b0, select_2385[4], 1'b0, select_2385[3], 1'b0, select_2385[2], 1'b0, select_2385[1], 1'b0, select_2385[0], 1'b0} : {1'b0, select_2385[11], 1'b0, select_2385[10], 1'b0, select_2385[9], 1'b0, select_2385[8], 1'b0, select_2385[7], 1'b0, select_2385[6], 1'b0, select_2385[5], 1'b0, select_2385[4], 1'b0, select_2385[3], 1'b0, select_2385[2], 1'b0, select_2385[1], 1'b0, select_2385[0]};
  // hls/stages/census.hpp:378
  logic and_2390;
  assign and_2390 = less_2381 & (~((sharpness_sums_contrast_1_q & select_2386) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2392;
  assign select_2392 = (less_2380 & and_2390) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2392};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2395;
  assign select_2395 = equal_2379 ? (less_2380 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2400;
  assign and_2400 = less_2381 & (~((sharpness_sums_contrast_0_q & select_2386) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2402;
  assign select_2402 = (less_2380 & and_2400) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2402};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2405;
  assign select_2405 = equal_2379 ? (less_2380 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2407;
  assign select_2407 = equal_2379 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2409;
  assign select_2409 = equal_2379 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2411;
  assign select_2411 = equal_2379 ? {sharpness_comparing_contrast_0_q[0], and_2400} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2413;
  assign select_2413 = equal_2379 ? {sharpness_comparing_contrast_1_q[0], and_2390} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2418;
  assign select_2418 = drew_q ? (equal_2379 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2422;
  assign select_2422 = drew_q ? (equal_2379 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2423;
  assign equal_2423 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2424;
  assign xor_2424 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2427;
  assign select_2427 = (equal_2423 | xor_2424) ? (five_times[0] & xor_2424) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2429;
  assign select_2429 = drew_q ? (equal_2379 ? select_2427 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2430;
  assign xor_2430 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2433;
  assign select_2433 = (equal_2423 | xor_2430) ? (five_times_2[0] & xor_2430) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2435;
  assign select_2435 = drew_q ? (equal_2379 ? select_2433 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2436;
  assign xor_2436 = sharpness_comparing_contrast_0_q[1] ^ and_2390;
  logic select_2439;
  assign select_2439 = (equal_2423 | xor_2436) ? (and_2390 & xor_2436) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2441;
  assign select_2441 = drew_q ? (equal_2379 ? select_2439 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2442;
  assign xor_2442 = sharpness_comparing_contrast_1_q[1] ^ and_2400;
  logic select_2445;
  assign select_2445 = (equal_2423 | xor_2442) ? (and_2400 & xor_2442) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2447;
  assign select_2447 = drew_q ? (equal_2379 ? select_2445 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2583;
  assign select_2583 = and_2575_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2581_s3_q});
  // hls/stages/agreement.hpp:789
  logic and_2586;
  assign and_2586 = not_571_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2591;
  assign and_2591 = not_571_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2596;
  assign and_2596 = not_571_s3_q & (drew_q & (ends_cell_s3_q & and_2001_s3_q));
  // hls/stages/agreement.hpp:1106
  logic not_2600;
  assign not_2600 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2609;
  assign select_2609 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2610;
  assign difference_2610 = {1'b0, explained_2_s3_q} - {1'b0, select_2609};
  logic [4:0] e;
  assign e = {difference_2610[3], difference_2610} + (equal_565_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2613;
  assign sum_2613 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1107
  logic not_2617;
  assign not_2617 = ~(equal_2060 ? and_2081 : (~({sum_2613, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:789
  logic and_2620;
  assign and_2620 = ends_cell_s3_q & (not_2600 & (centres_values_1_textured_s3_q & not_2617));
  logic and_2622;
  assign and_2622 = not_571_s3_q & (drew_q & and_2620);
  // hls/stages/agreement.hpp:1133
  logic less_2625;
  assign less_2625 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2626;
  assign select_2626 = less_2625 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2629;
  assign select_2629 = less_2625 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1134
  logic [10:0] sum_2630;
  assign sum_2630 = {1'b0, select_2629} + {3'h0, select_2629[9:2]};
  logic and_2632;
  assign and_2632 = (~(select_2626[9:4] == 6'h0)) & ({sum_2630, select_2629[1:0]} < {3'h0, select_2626});
  // hls/stages/agreement.hpp:1143
  logic [9:0] select_2635;
  assign select_2635 = x_s3_q[6] ? (equal_1603_s3_q ? 10'h0 : (and_2632 ? select_2626 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:789
  logic [9:0] select_2636;
  assign select_2636 = equal_570_s3_q ? select_2635 : 10'h0;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2638;
  assign select_2638 = and_2575_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2636});
  logic [13:0] select_2645;
  assign select_2645 = and_2575_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2643_s3_q});
  // hls/stages/agreement.hpp:1111
  logic and_2647;
  assign and_2647 = not_2600 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:789
  logic and_2650;
  assign and_2650 = not_571_s3_q & (drew_q & (ends_cell_s3_q & and_2647));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2652;
  assign select_2652 = and_2575_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2650});
  // hls/stages/agreement.hpp:1111
  logic and_2654;
  assign and_2654 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2617);
  // hls/stages/agreement.hpp:789
  logic and_2658;
  assign and_2658 = not_571_s3_q & (drew_q & (ends_cell_s3_q & (not_2600 & and_2654)));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2660;
  assign select_2660 = and_2575_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2658});
  logic [13:0] select_2679;
  assign select_2679 = and_2575_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2677_s3_q});
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2754;
  assign select_2754 = drew_q ? (equal_1699_s3_q ? (and_2736_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2755;
  assign select_2755 = equal_570_s3_q ? 8'h0 : select_2754;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2757;
  assign select_2757 = and_2735_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2755[7]}}, select_2755});
  // hls/stages/agreement.hpp:789
  logic and_2760;
  assign and_2760 = not_571_s3_q & (drew_q & (and_2736_s3_q & equal_1699_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2762;
  assign select_2762 = and_2735_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2760});
  // hls/stages/registration.hpp:107
  logic and_2764;
  assign and_2764 = and_2736_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2766;
  assign select_2766 = drew_q ? (equal_1699_s3_q ? {and_2764, and_2736_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2767;
  assign select_2767 = equal_570_s3_q ? 2'h0 : select_2766;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2768;
  assign sum_2768 = registration_half_votes_down_q + {{5{select_2767[1]}}, select_2767};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2774;
  assign select_2774 = drew_q ? (equal_1699_s3_q ? {and_2772_s3_q, and_2736_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2775;
  assign select_2775 = equal_570_s3_q ? 2'h0 : select_2774;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2776;
  assign sum_2776 = registration_half_votes_up_q + {{5{select_2775[1]}}, select_2775};
  // hls/stages/registration.hpp:107
  logic and_2779;
  assign and_2779 = and_2736_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2781;
  assign select_2781 = drew_q ? (equal_1699_s3_q ? {and_2779, and_2736_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2782;
  assign select_2782 = equal_570_s3_q ? 2'h0 : select_2781;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2783;
  assign sum_2783 = registration_half_half_votes_down_q + {{5{select_2782[1]}}, select_2782};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2788;
  assign select_2788 = drew_q ? (equal_1699_s3_q ? {and_2786_s3_q, and_2736_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2789;
  assign select_2789 = equal_570_s3_q ? 2'h0 : select_2788;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2790;
  assign sum_2790 = registration_half_half_votes_up_q + {{5{select_2789[1]}}, select_2789};
  // hls/stages/agreement.hpp:789
  logic and_2824;
  assign and_2824 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & less_1634_s3_q));
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2831;
  assign select_2831 = or_1638_s3_q ? 12'h0 : (equal_2829_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2834;
  assign select_2834 = x_s3_q[6] ? (equal_1603_s3_q ? 12'h0 : (less_1634_s3_q ? select_2831 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2835;
  assign select_2835 = equal_570_s3_q ? select_2834 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2836;
  assign and_2836 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_2839;
  assign and_2839 = not_1974_s3_q & (less_1634_s3_q & ({and_2836, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:789
  logic and_2841;
  assign and_2841 = equal_570_s3_q & (x_s3_q[6] & and_2839);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2843;
  assign sum_2843 = {{2{select_2835[11]}}, select_2835} + (and_2841 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2846;
  assign select_2846 = or_1638_s3_q ? 12'h0 : (equal_2829_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2849;
  assign select_2849 = x_s3_q[6] ? (equal_1603_s3_q ? 12'h0 : (less_1634_s3_q ? select_2846 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2850;
  assign select_2850 = equal_570_s3_q ? select_2849 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2852;
  assign sum_2852 = {{2{select_2850[11]}}, select_2850} + (and_2841 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2854;
  assign not_2854 = ~all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_2857;
  assign and_2857 = not_1974_s3_q & (less_1634_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2854, 1'b0}));
  // hls/stages/agreement.hpp:789
  logic and_2863;
  assign and_2863 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & (less_1634_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2864;
  assign not_2864 = ~and_2863;
  logic less_2865;
  assign less_2865 = $signed({9'h1, {2{not_2864}}, and_2863}) < $signed(registration_up_q[13:2]);
  logic select_2866;
  assign select_2866 = (equal_570_s3_q & (x_s3_q[6] & and_2857)) ? less_2865 : registration_enough_q;
  // hls/stages/agreement.hpp:1143
  logic and_2870;
  assign and_2870 = x_s3_q[6] & (not_1974_s3_q & (less_1634_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:789
  logic and_2871;
  assign and_2871 = equal_570_s3_q & and_2870;
  // hls/stages/registration.hpp:242
  logic less_2872;
  assign less_2872 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2874;
  assign less_2874 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2876;
  assign equal_2876 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:789
  logic and_2880;
  assign and_2880 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & (less_1634_s3_q & equal_2876)));
  // hls/stages/agreement.hpp:1143
  logic and_2887;
  assign and_2887 = x_s3_q[6] & (not_1974_s3_q & (less_1634_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2890;
  assign equal_2890 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1143
  logic and_2893;
  assign and_2893 = not_1974_s3_q & (less_1634_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2890));
  // hls/stages/registration.hpp:244
  logic and_2897;
  assign and_2897 = (equal_570_s3_q & (x_s3_q[6] & and_2893)) & (less_2874 | less_2872);
  // hls/stages/agreement.hpp:1143
  logic and_2902;
  assign and_2902 = not_1974_s3_q & (less_1634_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2890)));
  // hls/stages/registration.hpp:244
  logic and_2905;
  assign and_2905 = registration_votes_up_q & registration_other_down_q;
  logic select_2907;
  assign select_2907 = registration_votes_down_q ? (registration_other_up_q | and_2905) : and_2905;
  // hls/stages/registration.hpp:138
  logic and_2909;
  assign and_2909 = (equal_570_s3_q & (x_s3_q[6] & and_2902)) & (registration_other_enough_q & select_2907);
  // hls/stages/registration.hpp:245
  logic or_2912;
  assign or_2912 = registration_moved_q | (registration_enough_q & (and_2897 | and_2909));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_2996;
  assign select_2996 = sample_pair_whole_s3_q ? (equal_1689_s3_q ? patches_place_0_slope_q : select_1794[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_3001;
  assign select_3001 = sample_pair_whole_s3_q ? (equal_1689_s3_q ? patches_place_1_slope_q : select_1823[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3003;
  assign select_3003 = equal_1689_s3_q ? patches_valid_0_q : (select_1688_s3_q ? patches_valid_0_q : select_1791[0]);
  // hls/stages/agreement.hpp:276
  logic select_3006;
  assign select_3006 = sample_pair_whole_s3_q ? (and_1814 ? (sample_present_s3_q & select_3003) : select_3003) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3008;
  assign select_3008 = equal_1689_s3_q ? patches_valid_1_q : (select_1688_s3_q ? select_1791[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3011;
  assign select_3011 = sample_pair_whole_s3_q ? (and_1834 ? (sample_present_s3_q & select_3008) : select_3008) : patches_valid_1_q;
  logic [5:0] select_3014;
  assign select_3014 = sample_pair_whole_s3_q ? (select_1812[5] ? {1'b1, select_1812[4:0]} : (select_1812 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3017;
  assign select_3017 = sample_pair_whole_s3_q ? (select_1832[5] ? {1'b1, select_1832[4:0]} : (select_1832 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3020;
  assign select_3020 = sample_pair_whole_s3_q ? (select_1845[4] ? {1'b1, select_1845[3:0]} : (select_1845 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3023;
  assign select_3023 = sample_pair_whole_s3_q ? (select_1850[4] ? {1'b1, select_1850[3:0]} : (select_1850 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:521
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3442_s3_q, parity_3438_s3_q, xor_3426_s3_q, parity_3398_s3_q, parity_3336_s3_q, parity_3207_s3_q} + (equal_3443_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3447;
  assign select_3447 = equal_1775_s3_q ? patches_sums_values_0_q : (equal_1777_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3448;
  assign select_3448 = equal_1777_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3450;
  assign select_3450 = equal_1777_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3452;
  assign select_3452 = equal_1777_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3454;
  assign select_3454 = equal_1777_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3456;
  assign select_3456 = equal_1777_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3458;
  assign select_3458 = equal_1777_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3460;
  assign select_3460 = equal_1777_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3462;
  assign select_3462 = equal_1777_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3464;
  assign select_3464 = equal_1777_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3466;
  assign select_3466 = equal_1777_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3468;
  assign select_3468 = equal_1777_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3470;
  assign select_3470 = equal_1777_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1777_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1777_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1777_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1777_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:595
  logic or_3583;
  assign or_3583 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3582_s3_q;
  logic or_3586;
  assign or_3586 = equal_3574_s3_q | (less_3576_s3_q | (less_3577_s3_q | or_3583));
  // hls/stages/patches.hpp:575
  logic not_3587;
  assign not_3587 = ~or_3586;
  // hls/stages/patches.hpp:556
  logic and_3588;
  assign and_3588 = equal_1941_s3_q & not_3587;
  // hls/stages/patches.hpp:184
  logic and_3591;
  assign and_3591 = equal_1775_s3_q & (less_1938_s3_q ? (not_1940_s3_q & and_3588) : and_3588);
  // hls/stages/patches.hpp:653
  logic not_3592;
  assign not_3592 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:556
  logic and_3594;
  assign and_3594 = equal_1941_s3_q & (patches_second_s3_q & not_3587);
  // hls/stages/patches.hpp:184
  logic and_3597;
  assign and_3597 = equal_1775_s3_q & (less_1938_s3_q ? (not_1940_s3_q & and_3594) : and_3594);
  // hls/stages/patches.hpp:653
  logic not_3598;
  assign not_3598 = ~and_3597;
  // hls/stages/patches.hpp:188
  logic and_3600;
  assign and_3600 = and_3591 & (not_3592 & not_3598);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3602;
  assign sum_3602 = {7'h0, and_3600} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:593
  logic [7:0] select_3628;
  assign select_3628 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:592
  logic [5:0] select_3629;
  assign select_3629 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3630;
  assign sum_3630 = {2'h0, select_3562_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3631;
  assign sum_3631 = {select_3629[5], select_3629} + {{3{sum_3630[3]}}, sum_3630};
  // hls/stages/patches.hpp:593
  logic [17:0] product_3632;
  assign product_3632 = $signed({{10{select_3628[7]}}, select_3628}) * $signed({{8{sum_3631[6]}}, sum_3631, select_3562_s3_q[2:0]});
  // hls/stages/patches.hpp:594
  logic [13:0] difference_3633;
  assign difference_3633 = {{6{select_3627_s3_q[7]}}, select_3627_s3_q} - {product_3632[17], product_3632[17:5]};
  // hls/stages/patches.hpp:600
  logic less_3634;
  assign less_3634 = $signed({{7{difference_3604[6]}}, difference_3604}) < $signed(difference_3633);
  // hls/stages/patches.hpp:556
  logic and_3637;
  assign and_3637 = equal_1941_s3_q & (not_3587 & (~less_3634));
  // hls/stages/patches.hpp:184
  logic and_3640;
  assign and_3640 = equal_1775_s3_q & (less_1938_s3_q ? (not_1940_s3_q & and_3637) : and_3637);
  // hls/stages/patches.hpp:656
  logic and_3641;
  assign and_3641 = and_3640 & and_3600;
  logic [7:0] sum_3642;
  assign sum_3642 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3641};
  // hls/stages/patches.hpp:556
  logic and_3646;
  assign and_3646 = not_3587 & (~($signed(difference_3633) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3647;
  assign and_3647 = equal_1941_s3_q & and_3646;
  // hls/stages/patches.hpp:184
  logic and_3650;
  assign and_3650 = equal_1775_s3_q & (less_1938_s3_q ? (not_1940_s3_q & and_3647) : and_3647);
  // hls/stages/patches.hpp:657
  logic and_3651;
  assign and_3651 = and_3650 & and_3600;
  logic [7:0] sum_3652;
  assign sum_3652 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3651};
  // hls/stages/patches.hpp:188
  logic and_3654;
  assign and_3654 = and_3591 & (and_3597 & not_3592);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3656;
  assign sum_3656 = {7'h0, and_3654} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:656
  logic and_3658;
  assign and_3658 = and_3640 & and_3654;
  logic [7:0] sum_3659;
  assign sum_3659 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3658};
  // hls/stages/patches.hpp:657
  logic and_3661;
  assign and_3661 = and_3650 & and_3654;
  logic [7:0] sum_3662;
  assign sum_3662 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3661};
  // hls/stages/patches.hpp:188
  logic and_3664;
  assign and_3664 = and_3591 & (patches_lower_s3_q & not_3598);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3666;
  assign sum_3666 = {7'h0, and_3664} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:656
  logic and_3668;
  assign and_3668 = and_3640 & and_3664;
  logic [7:0] sum_3669;
  assign sum_3669 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3668};
  // hls/stages/patches.hpp:657
  logic and_3671;
  assign and_3671 = and_3650 & and_3664;
  logic [7:0] sum_3672;
  assign sum_3672 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3671};
  // hls/stages/patches.hpp:188
  logic and_3674;
  assign and_3674 = and_3591 & (patches_lower_s3_q & and_3597);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3676;
  assign sum_3676 = {7'h0, and_3674} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:656
  logic and_3678;
  assign and_3678 = and_3640 & and_3674;
  logic [7:0] sum_3679;
  assign sum_3679 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3678};
  // hls/stages/patches.hpp:657
  logic and_3681;
  assign and_3681 = and_3650 & and_3674;
  logic [7:0] sum_3682;
  assign sum_3682 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3681};
  // hls/stages/agreement.hpp:1224
  logic equal_3683;
  assign equal_3683 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1131
  logic less_3684;
  assign less_3684 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:789
  logic and_3688;
  assign and_3688 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & (equal_3683 & less_3684)));
  // hls/stages/agreement.hpp:1143
  logic and_3693;
  assign and_3693 = x_s3_q[6] & (not_1974_s3_q & (less_3684 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:789
  logic and_3694;
  assign and_3694 = equal_570_s3_q & and_3693;
  // hls/stages/patches.hpp:619
  logic [7:0] or_3696;
  assign or_3696 = (and_3688 ? patches_quarters_0_places_q : 8'h0) | (and_3694 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1143
  logic and_3700;
  assign and_3700 = x_s3_q[6] & (not_1974_s3_q & (less_3684 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:789
  logic and_3701;
  assign and_3701 = equal_570_s3_q & and_3700;
  // hls/stages/agreement.hpp:1143
  logic and_3707;
  assign and_3707 = x_s3_q[6] & (not_1974_s3_q & (less_3684 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:789
  logic and_3708;
  assign and_3708 = equal_570_s3_q & and_3707;
  // hls/stages/patches.hpp:619
  logic [7:0] or_3710;
  assign or_3710 = (or_3696 | (and_3701 ? patches_quarters_2_places_q : 8'h0)) | (and_3708 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3714;
  assign select_3714 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:789
  logic and_3718;
  assign and_3718 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & (less_3684 & select_3714)));
  // hls/stages/patches.hpp:620
  logic [7:0] select_3720;
  assign select_3720 = and_3688 ? (and_3718 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3722;
  assign select_3722 = and_3694 ? (and_3718 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3725;
  assign select_3725 = and_3701 ? (and_3718 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3728;
  assign select_3728 = and_3708 ? (and_3718 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3731;
  assign select_3731 = and_3688 ? (and_3718 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3733;
  assign select_3733 = and_3694 ? (and_3718 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3736;
  assign select_3736 = and_3701 ? (and_3718 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3739;
  assign select_3739 = and_3708 ? (and_3718 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3741;
  assign sum_3741 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1143
  logic and_3745;
  assign and_3745 = x_s3_q[6] & (not_1974_s3_q & (less_3684 & (sum_3741[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_3746;
  assign and_3746 = equal_570_s3_q & and_3745;
  // hls/stages/patches.hpp:616
  logic [7:0] select_3749;
  assign select_3749 = and_3746 ? (patches_word_places_q + (and_3694 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3752;
  assign select_3752 = and_3746 ? (patches_word_up_q + (and_3694 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3755;
  assign select_3755 = and_3746 ? (patches_word_down_q + (and_3694 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:602
  logic [5:0] select_3759;
  assign select_3759 = ($signed(difference_3633[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3633[5:0];
  logic [5:0] select_3760;
  assign select_3760 = ($signed(14'h10) < $signed(difference_3633)) ? 6'h10 : select_3759;
  // hls/stages/patches.hpp:556
  logic [5:0] select_3762;
  assign select_3762 = equal_1941_s3_q ? (or_3586 ? 6'h0 : select_3760) : 6'h0;
  logic [5:0] select_3764;
  assign select_3764 = less_1938_s3_q ? (equal_1939_s3_q ? 6'h0 : select_3762) : select_3762;
  // hls/stages/patches.hpp:659
  logic [5:0] select_3766;
  assign select_3766 = and_3591 ? (equal_1775_s3_q ? select_3764 : 6'h0) : 6'h0;
  logic [11:0] sum_3767;
  assign sum_3767 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3766[5]}}, select_3766};
  // hls/stages/agreement.hpp:789
  logic and_3771;
  assign and_3771 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q & (equal_2876 & less_3684)));
  // hls/stages/agreement.hpp:1143
  logic and_3775;
  assign and_3775 = x_s3_q[6] & (not_1974_s3_q & (less_3684 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_3776;
  assign and_3776 = equal_570_s3_q & and_3775;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3778;
  assign select_3778 = and_3771 ? (and_3776 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:645
  logic or_3782;
  assign or_3782 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic or_3785;
  assign or_3785 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:647
  logic [8:0] sum_3786;
  assign sum_3786 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:642
  logic select_3788;
  assign select_3788 = and_3771 ? (and_3776 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3791;
  assign and_3791 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:642
  logic [2:0] select_3793;
  assign select_3793 = and_3776 ? {and_3791, patches_found_q[2:1]} : (and_3771 ? {and_3791, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:641
  logic or_3797;
  assign or_3797 = patches_partly_q | (patches_doubted_q & (~and_3776));
  // hls/stages/patches.hpp:642
  logic select_3800;
  assign select_3800 = and_3771 ? (and_3776 ? or_3797 : (and_3771 ? or_3797 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:640
  logic select_3801;
  assign select_3801 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:629
  logic [7:0] select_3805;
  assign select_3805 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:601
  logic [10:0] sum_3807;
  assign sum_3807 = {sum_3631[6], sum_3631, select_3562_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:556
  logic and_3810;
  assign and_3810 = equal_1941_s3_q & (not_3587 & ({{5{sum_3807[10]}}, sum_3807} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3813;
  assign and_3813 = equal_1775_s3_q & (less_1938_s3_q ? (not_1940_s3_q & and_3810) : and_3810);
  // hls/stages/patches.hpp:188
  logic and_3814;
  assign and_3814 = and_3591 & and_3813;
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3815;
  assign sum_3815 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3814};
  // hls/stages/patches.hpp:650
  logic [12:0] product_3816;
  assign product_3816 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3778};
  // hls/stages/patches.hpp:188
  logic and_3822;
  assign and_3822 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_3827;
  assign select_3827 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:630
  logic or_3831;
  assign or_3831 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:631
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:632
  logic select_3838;
  assign select_3838 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:633
  logic and_3844;
  assign and_3844 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3845;
  assign sum_3845 = patches_age_q + {9'h0, and_3844};
  logic [9:0] select_3848;
  assign select_3848 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3845)) : sum_3845;
  // hls/stages/agreement.hpp:1189
  logic or_3905;
  assign or_3905 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1218
  logic equal_3907;
  assign equal_3907 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1227
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1228
  logic select_3913;
  assign select_3913 = (equal_3907 & equal_3683) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1136
  logic [10:0] sum_3916;
  assign sum_3916 = {1'b0, select_2629} + {2'h0, select_2629[9:1]};
  logic select_3919;
  assign select_3919 = (select_2626[9:3] == 7'h0) ? ((~or_3905) & (~select_3913)) : (~({sum_3916, select_2629[0]} < {2'h0, select_2626}));
  // hls/stages/agreement.hpp:1143
  logic [47:0] select_3921;
  assign select_3921 = x_s3_q[6] ? (equal_1603_s3_q ? good_q : {select_3919, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:789
  logic select_3926;
  assign select_3926 = equal_570_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3924_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1218
  logic equal_3927;
  assign equal_3927 = x_s3_q[6:3] == 4'ha;
  logic equal_3929;
  assign equal_3929 = x_s3_q[6:3] == 4'hc;
  logic equal_3930;
  assign equal_3930 = x_s3_q[6:3] == 4'hb;
  logic equal_3931;
  assign equal_3931 = x_s3_q[6:3] == 4'h9;
  logic equal_3932;
  assign equal_3932 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3934;
  assign select_3934 = equal_3931 ? counts_skin_unproven_q : (equal_3932 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3936;
  assign select_3936 = equal_3930 ? counts_regions_bad_q : (equal_3927 ? counts_nearer_q : select_3934);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3929 ? counts_on_skin_q : select_3936;
  // hls/stages/agreement.hpp:1223
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1231
  logic select_3939;
  assign select_3939 = (equal_3927 & equal_3683) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1149
  logic not_3940;
  assign not_3940 = ~hidden_for_q[7];
  logic [7:0] select_3942;
  assign select_3942 = select_3939 ? (hidden_for_q + {7'h0, not_3940}) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3944;
  assign select_3944 = equal_570_s3_q ? (equal_3924_s3_q ? select_3942 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_3945;
  assign select_3945 = equal_3683 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_3947;
  assign select_3947 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3949;
  assign select_3949 = equal_3932 ? cfg_unproven_skin_limit_i : (equal_3907 ? cfg_unproven_limit_i : select_3947);
  logic [7:0] select_3951;
  assign select_3951 = equal_3927 ? cfg_regions_limit_i : (equal_3931 ? cfg_hidden_limit_i : select_3949);
  logic [7:0] limit;
  assign limit = equal_3929 ? cfg_regions_limit_i : (equal_3930 ? {cfg_on_skin_limit_i, 3'h0} : select_3951);
  // hls/stages/agreement.hpp:1232
  logic not_3954;
  assign not_3954 = ~x_s3_q[2];
  logic [3:0] select_3955;
  assign select_3955 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3954, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3954};
  logic [7:0] select_3956;
  assign select_3956 = x_s3_q[0] ? {select_3955[3], 1'b0, select_3955[2], 1'b0, select_3955[1], 1'b0, select_3955[0], 1'b0} : {1'b0, select_3955[3], 1'b0, select_3955[2], 1'b0, select_3955[1], 1'b0, select_3955[0]};
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3960;
  assign select_3960 = equal_3931 ? counts_skin_supervised_q : (equal_3932 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3962;
  assign select_3962 = equal_3930 ? counts_skin_textured_q : (equal_3927 ? counts_textured_q : select_3960);
  logic [13:0] of;
  assign of = equal_3929 ? counts_textured_q : select_3962;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_3964;
  assign select_3964 = ((limit & select_3956) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3945} + {1'b0, select_3964};
  // hls/stages/agreement.hpp:789
  logic select_3969;
  assign select_3969 = equal_570_s3_q ? (equal_3683 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1229
  logic and_3974;
  assign and_3974 = too_much_q & (~(equal_3932 & equal_3683));
  // hls/stages/agreement.hpp:1230
  logic select_3979;
  assign select_3979 = (over[14] & equal_3683) ? (and_3974 | ((equal_3932 | equal_3931) | (x_s3_q[6:3] == 4'hf))) : and_3974;
  // hls/stages/agreement.hpp:1126
  logic and_3984;
  assign and_3984 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1232
  logic select_3985;
  assign select_3985 = (equal_3929 & equal_3683) ? and_3984 : overlooks_q;
  // hls/stages/agreement.hpp:789
  logic [2:0] select_3987;
  assign select_3987 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3989;
  assign select_3989 = equal_570_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_3987 : box_textured_columns_values_0_q);
  logic [2:0] select_3990;
  assign select_3990 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3992;
  assign select_3992 = equal_570_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_3990 : box_textured_columns_values_1_q);
  logic [2:0] select_3993;
  assign select_3993 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3995;
  assign select_3995 = equal_570_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_3993 : box_textured_columns_values_2_q);
  logic [2:0] select_3996;
  assign select_3996 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3998;
  assign select_3998 = equal_570_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_3996 : box_textured_columns_values_3_q);
  logic [2:0] select_3999;
  assign select_3999 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4001;
  assign select_4001 = equal_570_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_3999 : box_textured_columns_values_4_q);
  logic [4:0] select_4003;
  assign select_4003 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_570_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4005 : box_explained_columns_values_0_q);
  logic [2:0] select_4008;
  assign select_4008 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4010;
  assign select_4010 = equal_570_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4008 : box_explained_columns_values_1_q);
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_570_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4011 : box_explained_columns_values_2_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_570_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4014 : box_explained_columns_values_3_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_570_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4017 : box_explained_columns_values_4_q);
  logic [4:0] select_4021;
  assign select_4021 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4024;
  assign select_4024 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4026;
  assign select_4026 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4028;
  assign select_4028 = equal_570_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4026 : box_shown_columns_values_1_q);
  logic [2:0] select_4029;
  assign select_4029 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4031;
  assign select_4031 = equal_570_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4029 : box_shown_columns_values_2_q);
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_570_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4032 : box_shown_columns_values_3_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_570_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4035 : box_shown_columns_values_4_q);
  logic [4:0] select_4039;
  assign select_4039 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4042;
  assign select_4042 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4044;
  assign select_4044 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4046;
  assign select_4046 = equal_570_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4044 : box_nearer_columns_values_1_q);
  logic [2:0] select_4047;
  assign select_4047 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4049;
  assign select_4049 = equal_570_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4047 : box_nearer_columns_values_2_q);
  logic [2:0] select_4050;
  assign select_4050 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4052;
  assign select_4052 = equal_570_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4050 : box_nearer_columns_values_3_q);
  logic [2:0] select_4053;
  assign select_4053 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4055;
  assign select_4055 = equal_570_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4053 : box_nearer_columns_values_4_q);
  logic [4:0] select_4057;
  assign select_4057 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1276
  logic select_4092;
  assign select_4092 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4094;
  assign select_4094 = left_first_s3_q ? done_s3_q : (and_1955_s3_q ? select_4092 : proven_q);
  // hls/stages/agreement.hpp:1309
  logic [1:0] select_4145;
  assign select_4145 = and_4144_s3_q ? {and_2111, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1310
  logic and_4146;
  assign and_4146 = select_4092 & less_4122;
  // hls/stages/agreement.hpp:438
  logic select_4149;
  assign select_4149 = and_2038_s3_q ? (less_2039_s3_q ? (select_4145[0] & and_4146) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4151;
  assign select_4151 = left_first_s3_q ? select_4149 : (and_1955_s3_q ? select_4149 : seen_q);
  logic select_4152;
  assign select_4152 = and_1955_s3_q ? select_4151 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4155;
  assign select_4155 = and_2038_s3_q ? (less_2039_s3_q ? (select_4145[1] & and_4146) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4157;
  assign select_4157 = left_first_s3_q ? select_4155 : (and_1955_s3_q ? select_4155 : nearer_q);
  logic select_4158;
  assign select_4158 = and_1955_s3_q ? select_4157 : nearer_q;
  // hls/stages/agreement.hpp:1240
  logic or_4165;
  assign or_4165 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1242
  logic not_4173;
  assign not_4173 = ~(or_3905 | not_2331);
  // hls/stages/agreement.hpp:789
  logic and_4177;
  assign and_4177 = equal_570_s3_q & (equal_3924_s3_q & (not_4173 & (select_3913 | select_3979)));
  logic and_4180;
  assign and_4180 = equal_3924_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1151
  logic or_4184;
  assign or_4184 = select_2429 | (select_2441 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:789
  logic and_4191;
  assign and_4191 = equal_570_s3_q & (equal_3924_s3_q & (not_4173 & (select_2435 | select_2447)));
  // hls/stages/agreement.hpp:1151
  logic and_4196;
  assign and_4196 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3942 < cfg_hidden_frames_i));
  logic select_4202;
  assign select_4202 = (not_2331 | (select_3985 & not_3818)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:789
  logic and_4207;
  assign and_4207 = equal_570_s3_q & (equal_3924_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4211;
  assign and_4211 = equal_570_s3_q & (x_s3_q[6] & (not_1974_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4219;
  assign select_4219 = equal_1625_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4217_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4220;
  assign select_4220 = equal_1623_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4219;
  logic [31:0] select_4221;
  assign select_4221 = equal_1621_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4220;
  logic [31:0] select_4222;
  assign select_4222 = equal_1619_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4221;
  logic [31:0] select_4223;
  assign select_4223 = equal_1617_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4222;
  logic [31:0] select_4224;
  assign select_4224 = equal_1615_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4223;
  logic [31:0] select_4225;
  assign select_4225 = equal_1613_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4224;
  logic [31:0] select_4226;
  assign select_4226 = equal_1611_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4225;
  // hls/stages/agreement.hpp:1139
  logic [9:0] select_4227;
  assign select_4227 = less_2625 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1143
  logic [31:0] select_4228;
  assign select_4228 = equal_1603_s3_q ? select_4226 : {2'h0, select_4227, select_2629, select_2626};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_545_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_742_s3_q, and_741, less_736_s3_q, and_735_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_729, and_705_s3_q, and_704_s3_q, and_679_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q};
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
  assign registration_sums_waddr = {sum_1609_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1668_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1667, sum_1663};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1697_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1774_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1746_s3_q};
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
  assign patches_right_0_waddr = {select_1805_s3_q, select_1802};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1814);
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
  assign patches_right_1_waddr = {select_1805_s3_q, select_1831};
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
  assign patches_left_waddr = {select_1853, select_1852_s3_q, column_5};
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1962;
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
  assign regions_waddr = {region_row_s3_q, or_1972_s3_q, or_1969_s3_q, or_1966_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2006_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2005, sum_1995, sum_1990};
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
  assign map_waddr = sum_2047_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2121_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2111, is_seen};
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
      patches_place_0_column_q <= 7'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_valid_q <= 1'b0;
      patches_place_1_column_q <= 7'h0;
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
      census_left_misses_q <= select_2270;
      sharpness_before_last_mask_q <= select_2343;
      sharpness_sums_detail_0_q <= and_545_s3_q ? select_2357 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_545_s3_q ? select_2369 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_545_s3_q ? sum_2373 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_545_s3_q ? sum_2377 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2395 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2405 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2407 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2409 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2411 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2413 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2418;
      sharpness_comparing_carry_1_q <= select_2422;
      sharpness_comparing_less_detail_0_q <= select_2429;
      sharpness_comparing_less_detail_1_q <= select_2435;
      sharpness_comparing_less_contrast_0_q <= select_2441;
      sharpness_comparing_less_contrast_1_q <= select_2447;
      counts_supervised_q <= select_2583;
      counts_textured_q <= and_2575_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2586});
      counts_explained_q <= and_2575_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2591});
      counts_nearer_q <= and_2575_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2596});
      counts_unproven_q <= and_2575_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2622});
      counts_regions_bad_q <= select_2638;
      counts_skin_supervised_q <= select_2645;
      counts_skin_textured_q <= select_2652;
      counts_skin_unproven_q <= select_2660;
      counts_on_skin_q <= select_2679;
      registration_half_across_q <= select_2757;
      registration_half_measured_q <= select_2762;
      registration_half_votes_down_q <= and_2735_s3_q ? 7'h0 : sum_2768;
      registration_half_votes_up_q <= and_2735_s3_q ? 7'h0 : sum_2776;
      registration_half_half_votes_down_q <= and_2735_s3_q ? 7'h0 : sum_2783;
      registration_half_half_votes_up_q <= and_2735_s3_q ? 7'h0 : sum_2790;
      registration_down_q <= and_2824 ? sum_2843 : registration_down_q;
      registration_up_q <= and_2824 ? sum_2852 : registration_up_q;
      registration_enough_q <= select_2866;
      registration_votes_down_q <= and_2871 ? less_2872 : registration_votes_down_q;
      registration_votes_up_q <= and_2871 ? less_2874 : registration_votes_up_q;
      registration_other_enough_q <= and_2880 ? select_2866 : registration_other_enough_q;
      registration_other_down_q <= and_2880 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2880 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_570_s3_q & and_2887)) & or_2912;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1793 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1795 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1796 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2996;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1822 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1824 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1825 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3001;
      patches_valid_0_q <= select_3006;
      patches_valid_1_q <= select_3011;
      patches_right_next_0_q <= select_3014;
      patches_right_next_1_q <= select_3017;
      patches_left_next_0_q <= select_3020;
      patches_left_next_1_q <= select_3023;
      patches_sums_values_0_q <= select_3447;
      patches_sums_values_1_q <= equal_1775_s3_q ? patches_sums_values_1_q : select_3448;
      patches_sums_values_2_q <= equal_1775_s3_q ? patches_sums_values_2_q : select_3450;
      patches_sums_values_3_q <= equal_1775_s3_q ? patches_sums_values_3_q : select_3452;
      patches_sums_values_4_q <= equal_1775_s3_q ? patches_sums_values_4_q : select_3454;
      patches_sums_values_5_q <= equal_1775_s3_q ? patches_sums_values_5_q : select_3456;
      patches_sums_values_6_q <= equal_1775_s3_q ? patches_sums_values_6_q : select_3458;
      patches_sums_values_7_q <= equal_1775_s3_q ? patches_sums_values_7_q : select_3460;
      patches_sums_values_8_q <= equal_1775_s3_q ? patches_sums_values_8_q : select_3462;
      patches_sums_values_9_q <= equal_1775_s3_q ? patches_sums_values_9_q : select_3464;
      patches_sums_values_10_q <= equal_1775_s3_q ? patches_sums_values_10_q : select_3466;
      patches_sums_values_11_q <= equal_1775_s3_q ? patches_sums_values_11_q : select_3468;
      patches_sums_values_12_q <= equal_1775_s3_q ? patches_sums_values_12_q : select_3470;
      patches_sums_values_13_q <= equal_1775_s3_q ? patches_sums_values_13_q : select_3472;
      patches_sums_values_14_q <= equal_1775_s3_q ? patches_sums_values_14_q : select_3474;
      patches_sums_values_15_q <= equal_1775_s3_q ? patches_sums_values_15_q : select_3476;
      patches_sums_values_16_q <= equal_1775_s3_q ? patches_sums_values_16_q : select_3478;
      patches_best_differing_q <= select_1962[9:0];
      patches_best_column_q <= select_1962[14:10];
      patches_quarters_0_places_q <= sum_3602;
      patches_quarters_0_up_q <= sum_3642;
      patches_quarters_0_down_q <= sum_3652;
      patches_quarters_1_places_q <= sum_3656;
      patches_quarters_1_up_q <= sum_3659;
      patches_quarters_1_down_q <= sum_3662;
      patches_quarters_2_places_q <= sum_3666;
      patches_quarters_2_up_q <= sum_3669;
      patches_quarters_2_down_q <= sum_3672;
      patches_quarters_3_places_q <= sum_3676;
      patches_quarters_3_up_q <= sum_3679;
      patches_quarters_3_down_q <= sum_3682;
      patches_word_places_q <= or_3710;
      patches_word_up_q <= ((select_3720 | select_3722) | select_3725) | select_3728;
      patches_word_down_q <= ((select_3731 | select_3733) | select_3736) | select_3739;
      patches_sum_places_q <= select_3749;
      patches_sum_up_q <= select_3752;
      patches_sum_down_q <= select_3755;
      patches_across_q <= sum_3767;
      patches_places_q <= select_3778;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3782;
      patches_partly_q <= or_3785;
      patches_clear_limit_q <= sum_3786[8:2];
      patches_complete_q <= select_3788;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3771 ? select_3793 : patches_found_q;
      patches_doubted_q <= select_3800;
      patches_doubted_before_q <= select_3801;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3805;
      patches_on_skin_q <= sum_3815;
      patches_on_skin_most_q <= product_3816[12:5];
      patches_large_q <= not_3818 & and_3822;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3827;
      patches_spoiled_q <= or_3831;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3838;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3848;
      segment_textured_q <= select_1987 + {5'h0, and_2586};
      segment_explained_q <= select_1992 + {5'h0, and_2591};
      segment_nearer_q <= select_2002 + {5'h0, and_2596};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_570_s3_q ? select_3921 : good_q;
      good_known_q <= select_3926;
      hidden_for_q <= select_3944;
      product_q <= equal_570_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3969;
      disagree_q <= equal_570_s3_q ? select_3913 : disagree_q;
      too_much_q <= equal_570_s3_q ? select_3979 : too_much_q;
      hides_q <= equal_570_s3_q ? select_3939 : hides_q;
      overlooks_q <= equal_570_s3_q ? select_3985 : overlooks_q;
      proven_q <= and_1955_s3_q ? select_4094 : proven_q;
      seen_q <= select_4152;
      nearer_q <= select_4158;
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
      averager_quarter_1_0_q <= select_2145;
      averager_quarter_1_1_q <= select_2147;
      averager_quarter_2_0_q <= select_2149;
      averager_quarter_2_1_q <= select_2151;
      averager_detail_0_q <= select_2163;
      averager_detail_1_q <= select_2171;
      census_changes_values_0_left_q <= and_545_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_545_s3_q ? sum_2254 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2256;
      census_changes_values_1_right_q <= select_2257;
      census_changes_values_2_left_q <= select_2258;
      census_changes_values_2_right_q <= select_2259;
      sharpness_last_mask_q <= and_545_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_545_s3_q ? select_2340[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_545_s3_q ? select_2340[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3989;
      box_textured_columns_values_1_q <= select_3992;
      box_textured_columns_values_2_q <= select_3995;
      box_textured_columns_values_3_q <= select_3998;
      box_textured_columns_values_4_q <= select_4001;
      box_textured_sum_sums_values_0_q <= equal_570_s3_q ? box_textured_sum_sums_values_0_q : select_4003;
      box_explained_columns_values_0_q <= select_4007;
      box_explained_columns_values_1_q <= select_4010;
      box_explained_columns_values_2_q <= select_4013;
      box_explained_columns_values_3_q <= select_4016;
      box_explained_columns_values_4_q <= select_4019;
      box_explained_sum_sums_values_0_q <= equal_570_s3_q ? box_explained_sum_sums_values_0_q : select_4021;
      box_shown_columns_values_0_q <= equal_570_s3_q ? box_shown_columns_values_0_q : select_4024;
      box_shown_columns_values_1_q <= select_4028;
      box_shown_columns_values_2_q <= select_4031;
      box_shown_columns_values_3_q <= select_4034;
      box_shown_columns_values_4_q <= select_4037;
      box_shown_sum_sums_values_0_q <= equal_570_s3_q ? box_shown_sum_sums_values_0_q : select_4039;
      box_nearer_columns_values_0_q <= equal_570_s3_q ? box_nearer_columns_values_0_q : select_4042;
      box_nearer_columns_values_1_q <= select_4046;
      box_nearer_columns_values_2_q <= select_4049;
      box_nearer_columns_values_3_q <= select_4052;
      box_nearer_columns_values_4_q <= select_4055;
      box_nearer_sum_sums_values_0_q <= equal_570_s3_q ? box_nearer_sum_sums_values_0_q : select_4057;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4096_s4_q;
  logic or_4159_s4_q;
  logic and_4160_s4_q;
  logic and_4168_s4_q;
  logic and_4171_s4_q;
  logic and_4177_s4_q;
  logic and_4181_s4_q;
  logic and_4187_s4_q;
  logic and_4191_s4_q;
  logic and_4199_s4_q;
  logic and_4204_s4_q;
  logic and_4207_s4_q;
  logic and_4211_s4_q;
  logic [5:0] select_4213_s4_q;
  logic [31:0] select_4230_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4096_s4_q <= said_q;
      or_4159_s4_q <= not_2331 | select_4152;
      and_4160_s4_q <= cfg_prove_i & select_4158;
      and_4168_s4_q <= equal_570_s3_q & (equal_3924_s3_q & (cfg_prove_i & or_4165));
      and_4171_s4_q <= equal_570_s3_q & (equal_3924_s3_q & (cfg_prove_i & or_3905));
      and_4177_s4_q <= and_4177;
      and_4181_s4_q <= equal_570_s3_q & and_4180;
      and_4187_s4_q <= equal_570_s3_q & (equal_3924_s3_q & (not_4173 & or_4184));
      and_4191_s4_q <= and_4191;
      and_4199_s4_q <= equal_570_s3_q & (equal_3924_s3_q & (cfg_prove_i & and_4196));
      and_4204_s4_q <= equal_570_s3_q & (equal_3924_s3_q & select_4202);
      and_4207_s4_q <= and_4207;
      and_4211_s4_q <= and_4211;
      select_4213_s4_q <= equal_570_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4230_s4_q <= equal_570_s3_q ? (x_s3_q[6] ? select_4228 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4159_s4_q;
  assign marks_nearer_o = and_4160_s4_q;
  assign verdict_valid_o = and_4096_s4_q;
  assign verdict_unproven_yet_o = and_4168_s4_q;
  assign verdict_untextured_o = and_4171_s4_q;
  assign verdict_disagree_o = and_4177_s4_q;
  assign verdict_moved_o = and_4181_s4_q;
  assign verdict_unsharp_left_o = and_4187_s4_q;
  assign verdict_unsharp_right_o = and_4191_s4_q;
  assign verdict_hidden_o = and_4199_s4_q;
  assign verdict_overlooked_o = and_4204_s4_q;
  assign verdict_out_of_step_o = and_4207_s4_q;
  assign frame_valid_o = and_4211_s4_q;
  assign frame_index_o = select_4213_s4_q;
  assign frame_word_o = select_4230_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3816[4:0], sum_3786[1:0], sum_3741[1:0], product_3632[4:0], sum_2725[0], difference_2666[1:0], detail_4[1:0], detail_3[1:0], sum_2264[4:0], sum_1713[0], sum_1709[0], sum_727[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
