// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3075 bits, pipeline 851 bits, memories 66527 bits.
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
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_2527;
  assign sum_2527 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3587;
  assign difference_3587 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3803;
  assign not_3803 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3860;
  assign difference_3860 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4106;
  assign less_4106 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4107;
  assign sum_4107 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4108;
  assign select_4108 = less_4106 ? {sum_4107, cfg_height_i[5:3]} : 8'h0;
  logic not_4143;
  assign not_4143 = ~cfg_prove_i;

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
  logic [2:0] select_497;
  assign select_497 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_499;
  assign select_499 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [7:0] select_502;
  assign select_502 = ({select_499, select_497} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:117
  logic [7:0] select_503;
  assign select_503 = select_497[0] ? averager_place_q : select_502;
  // hls/stages/census.hpp:42
  logic or_504;
  assign or_504 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_507;
  assign and_507 = (select_497[0] & or_504) & (select_503 < 8'hbd);
  // hls/stages/census.hpp:42
  logic [2:0] select_512;
  assign select_512 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_499 : 6'h0;
  // hls/stages/census.hpp:51
  logic equal_529;
  assign equal_529 = select_497 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_530;
  assign equal_530 = select_512 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_531;
  assign and_531 = equal_530 & and_507;
  // hls/stages/agreement.hpp:276
  logic and_533;
  assign and_533 = sample_pair_whole_q & (equal_529 & and_531);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:624
  logic equal_561;
  assign equal_561 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:595
  logic or_562;
  assign or_562 = so | equal_561;
  // hls/stages/agreement.hpp:593
  logic [7:0] sum_563;
  assign sum_563 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:595
  logic [7:0] select_564;
  assign select_564 = run_shift_q[5] ? x_q : sum_563;
  logic less_565;
  assign less_565 = {2'h0, last_q} < select_564;
  // hls/stages/agreement.hpp:226
  logic not_566;
  assign not_566 = ~less_565;
  // hls/stages/agreement.hpp:615
  logic equal_576;
  assign equal_576 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:616
  logic equal_577;
  assign equal_577 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_578;
  assign and_578 = equal_577 & not_566;
  logic select_580;
  assign select_580 = or_562 ? not_566 : (equal_576 ? not_566 : and_578);
  // hls/stages/agreement.hpp:799
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:797
  logic [6:0] sum_594;
  assign sum_594 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_599;
  assign and_599 = equal_576 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_594} < select_564))));
  logic select_600;
  assign select_600 = or_562 ? not_566 : and_599;
  // hls/stages/agreement.hpp:822
  logic [5:0] right;
  assign right = sum_563[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:721
  logic not_630;
  assign not_630 = ~or_562;
  // hls/stages/agreement.hpp:149
  logic and_633;
  assign and_633 = not_630 & ((~equal_576) & and_578);
  // hls/stages/census.hpp:42
  logic [5:0] select_660;
  assign select_660 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_660 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_1658;
  assign and_1658 = (select_497 == 3'h0) & (select_499 == 6'h0);
  // hls/stages/patches.hpp:392
  logic not_1659;
  assign not_1659 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1662;
  assign not_1662 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_1663;
  assign and_1663 = patches_capturing_q & not_1662;
  // hls/stages/patches.hpp:364
  logic equal_1664;
  assign equal_1664 = {or_504, select_512} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1666;
  assign equal_1666 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1671;
  assign and_1671 = (not_1659 & (patches_work_q == 3'h0)) & (~(and_1663 | ((~equal_1664) | (~equal_1666))));
  // hls/stages/patches.hpp:530
  logic equal_1762;
  assign equal_1762 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:508
  logic not_1763;
  assign not_1763 = ~equal_1762;
  // hls/stages/patches.hpp:501
  logic equal_1764;
  assign equal_1764 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:454
  logic not_1765;
  assign not_1765 = ~equal_1764;
  // hls/stages/patches.hpp:495
  logic equal_1766;
  assign equal_1766 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1767;
  assign equal_1767 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:530
  logic or_1768;
  assign or_1768 = equal_1766 | equal_1767;
  // hls/stages/patches.hpp:456
  logic not_1769;
  assign not_1769 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1791;
  assign select_1791 = and_1671 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1792;
  assign select_1792 = and_1658 ? select_1791 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1794;
  assign and_1794 = and_1663 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1798;
  assign select_1798 = and_1658 ? (and_1671 | (and_1663 & (~and_1794))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1806;
  assign and_1806 = not_1763 & (not_1765 & (or_1768 & (patches_second_q & equal_1767)));
  // hls/stages/patches.hpp:167
  logic not_1823;
  assign not_1823 = ~equal_1767;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1839;
  assign select_1839 = and_1658 ? {select_1791[4], select_1791[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:454
  logic and_1849;
  assign and_1849 = not_1763 & (or_1768 & not_1765);
  // hls/stages/agreement.hpp:190
  logic and_1942;
  assign and_1942 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2113;
  assign select_2113 = sample_pair_whole_q ? (sample_last_q ? (select_512 + 3'h1) : select_512) : raster_at_y_q;
  logic [5:0] select_2115;
  assign select_2115 = sample_pair_whole_q ? (select_499 + {5'h0, equal_529}) : raster_at_column_q;
  logic [5:0] select_2118;
  assign select_2118 = sample_pair_whole_q ? (sample_last_q ? (select_660 + {5'h0, equal_530}) : select_660) : raster_at_row_q;
  logic select_2122;
  assign select_2122 = sample_pair_whole_q ? (sample_last_q ? (or_504 & (~raster_final_row_q)) : or_504) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2124;
  assign select_2124 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2128;
  assign select_2128 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:460
  logic equal_2433;
  assign equal_2433 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:465
  logic and_2434;
  assign and_2434 = and_533 & equal_2433;
  // hls/stages/agreement.hpp:524
  logic select_2437;
  assign select_2437 = (and_2434 | (~ends_cell_q)) ? and_2434 : ends_q;
  // hls/stages/agreement.hpp:530
  logic [2:0] now;
  assign now = select_2437 ? (and_2434 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:535
  logic [5:0] select_2441;
  assign select_2441 = select_2437 ? (and_2434 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2444;
  assign select_2444 = select_2437 ? (following_last_shift_q & (~and_2434)) : run_last_shift_q;
  // hls/stages/agreement.hpp:608
  logic and_2447;
  assign and_2447 = run_last_shift_q & equal_576;
  // hls/stages/agreement.hpp:617
  logic select_2449;
  assign select_2449 = equal_576 ? (~run_last_shift_q) : equal_577;
  // hls/stages/agreement.hpp:621
  logic equal_2450;
  assign equal_2450 = run_phase_q == 3'h1;
  logic not_2453;
  assign not_2453 = ~select_2449;
  // hls/stages/agreement.hpp:624
  logic equal_2455;
  assign equal_2455 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:608
  logic and_2456;
  assign and_2456 = final_row_q & so;
  // hls/stages/agreement.hpp:621
  logic [1:0] select_2457;
  assign select_2457 = equal_2455 ? 2'h1 : {2{and_2456}};
  logic [2:0] select_2459;
  assign select_2459 = (and_2447 | (select_2449 | equal_2450)) ? (equal_2450 ? 3'h2 : {not_2453, {2{select_2449}}}) : (equal_561 ? 3'h6 : {select_2457[0], select_2457});
  // hls/stages/agreement.hpp:608
  logic and_2462;
  assign and_2462 = select_2449 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:631
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2465;
  assign select_2465 = (plan_shift_q[5] & select_2449) ? value : 7'h0;
  logic [1:0] or_2466;
  assign or_2466 = {2{so}} | select_2465[5:4];
  // hls/stages/agreement.hpp:634
  logic [7:0] select_2467;
  assign select_2467 = select_2449 ? plan_columns_q : 8'h0;
  logic [6:0] or_2470;
  assign or_2470 = select_2467[6:0] | ((equal_2450 | equal_2455) ? whole_q : 7'h0);
  logic [1:0] or_2471;
  assign or_2471 = {2{and_2447}} | or_2470[3:2];
  // hls/stages/agreement.hpp:635
  logic [6:0] or_2473;
  assign or_2473 = {or_2470[6:4], or_2471, or_2470[1:0]} | (equal_561 ? drawn_q : 7'h0);
  logic [4:0] or_2474;
  assign or_2474 = {5{so}} | {or_2473[6], or_2473[3:0]};
  // hls/stages/agreement.hpp:641
  logic not_2478;
  assign not_2478 = ~run_shift_q[5];
  logic [6:0] difference_2480;
  assign difference_2480 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2481;
  assign select_2481 = equal_576 ? ({{7{not_2478}}, 1'b1} + run_span_q) : {difference_2480[6], difference_2480};
  // hls/stages/agreement.hpp:524
  logic [6:0] select_2485;
  assign select_2485 = and_2434 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_2487;
  assign select_2487 = select_2437 ? {select_2485[6], select_2485} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2490;
  assign select_2490 = select_2437 ? (and_2434 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2498;
  assign select_2498 = and_533 ? (equal_2433 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2501;
  assign select_2501 = and_533 ? (equal_2433 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2504;
  assign select_2504 = and_533 ? (equal_2433 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:532
  logic select_2518;
  assign select_2518 = (ends_cell_q | select_2437) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_576 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:527
  logic and_2522;
  assign and_2522 = (~select_2437) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:477
  logic [6:0] sum_2523;
  assign sum_2523 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:461
  logic select_2525;
  assign select_2525 = equal_2433 ? ({sum_2523[6], cfg_height_i[8:3]} == {1'b0, sum_2523[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2901;
  assign select_2901 = and_1658 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2902;
  assign select_2902 = sample_pair_whole_q ? select_2901 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_2903;
  assign and_2903 = not_1662 & equal_1664;
  logic [8:0] select_2904;
  assign select_2904 = and_2903 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2905;
  assign select_2905 = and_2903 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2906;
  assign select_2906 = sample_pair_first_q ? select_2904 : select_2905;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2908;
  assign select_2908 = sample_pair_whole_q ? (and_1658 ? select_2906[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2910;
  assign select_2910 = sample_pair_whole_q ? (and_1658 ? select_2906[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2913;
  assign select_2913 = sample_pair_whole_q ? (equal_1666 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2915;
  assign select_2915 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1666}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2916;
  assign equal_2916 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2917;
  assign not_2917 = ~equal_2916;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2919;
  assign select_2919 = sample_pair_whole_q ? (phase + {not_2917, 1'b1, not_2917, equal_2916}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:471
  logic equal_2921;
  assign equal_2921 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2925;
  assign select_2925 = equal_2921 ? ((select_2902 == 4'h6) ? 4'h0 : (select_2902 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2926;
  assign equal_2926 = select_2925 == 4'h0;
  // hls/stages/agreement.hpp:461
  logic [3:0] select_2929;
  assign select_2929 = equal_2433 ? (equal_2926 ? 4'h6 : (select_2925 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2931;
  assign select_2931 = equal_2921 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] select_2933;
  assign select_2933 = equal_2433 ? (select_2931 + {4'h0, equal_2926}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:521
  logic select_2938;
  assign select_2938 = and_533 ? (equal_2433 ? ((6'h2 < row) & equal_2926) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2940;
  assign select_2940 = and_533 ? (equal_2433 ? select_2931 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_2963;
  assign or_2963 = select_499[0] | select_660[5];
  logic [7:0] sum_2964;
  assign sum_2964 = {1'b0, select_499[2:1], or_2963, select_660[4:1]} + 8'h1;
  logic less_2965;
  assign less_2965 = {sum_2964, select_660[0], select_512, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_2968;
  assign select_2968 = and_1658 ? (and_1671 ? (~less_2965) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3007;
  assign or_3007 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3013;
  assign and_3013 = equal_1762 & not_1769;
  // hls/stages/patches.hpp:399
  logic and_3014;
  assign and_3014 = not_1823 & and_3013;
  logic [1:0] select_3016;
  assign select_3016 = equal_1764 ? 2'h0 : (equal_1766 ? 2'h3 : {equal_1767, and_3014});
  // hls/stages/patches.hpp:279
  logic equal_3018;
  assign equal_3018 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3019;
  assign not_3019 = ~equal_3018;
  // hls/stages/patches.hpp:279
  logic equal_3020;
  assign equal_3020 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3021;
  assign not_3021 = ~equal_3020;
  // hls/stages/patches.hpp:283
  logic not_3023;
  assign not_3023 = ~(patches_following_q == 3'h2);
  logic and_3026;
  assign and_3026 = (~(patches_following_q == 3'h1)) & not_3023;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3027;
  assign select_3027 = equal_3020 ? 2'h2 : {and_3026, not_3023};
  logic [3:0] select_3028;
  assign select_3028 = equal_3018 ? 4'h2 : {select_3027, {2{not_3021}}};
  // hls/stages/patches.hpp:405
  logic not_3031;
  assign not_3031 = ~or_3007;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3036;
  assign select_3036 = or_3007 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3038;
  assign select_3038 = or_3007 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
  assign fresh_re = s0_en & and_633;
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
  assign left_re = s0_en & select_580;
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
  assign right_codes_raddr = or_562 ? x_q[5:0] : (equal_576 ? sum_563[5:0] : x_q[5:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_580;
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
  assign best_left_raddr = or_562 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_600;
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
  assign patches_right_0_re = s0_en & (not_1763 & (not_1765 & (or_1768 & (equal_1767 & not_1769))));
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
  assign patches_right_1_re = s0_en & and_1806;
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
  assign patches_left_re = s0_en & (not_1763 & (not_1765 & (not_1823 & or_1768)));
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
  assign patches_columns_above_re = s0_en & and_1849;
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
      left_first_q <= and_1942 ? left_first_q : marks_first_i;
      right_q <= (~and_1942) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1942;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_497 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2113;
      raster_at_column_q <= select_2115;
      raster_at_row_q <= select_2118;
      raster_at_live_q <= select_2122;
      raster_rows_left_q <= sample_pair_whole_q ? select_2124 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2128;
      averager_place_q <= sample_pair_whole_q ? select_503 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2441;
      run_last_shift_q <= select_2444;
      run_span_q <= select_2437 ? (and_2434 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2459;
      following_shift_q <= select_2449 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2462;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2465[6], or_2466, select_2465[3:0]};
      following_columns_q <= {select_2467[7], or_2474[4], or_2473[5:4], or_2474[3:0]};
      plan_shift_q <= equal_576 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2481;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2487;
      columns_left_q <= select_2490;
      last_q <= and_533 ? (equal_2433 ? column : last_q) : last_q;
      least_q <= select_2498;
      whole_q <= select_2501;
      drawn_q <= select_2504;
      age_q <= select_2437 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2437 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2518;
      ends_q <= and_2522;
      final_row_q <= and_533 ? select_2525 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2902;
      patches_band_rows_rows_to_next_q <= select_2908;
      patches_band_rows_number_q <= select_2910;
      patches_next_band_rows_to_next_q <= select_2913;
      patches_next_band_number_q <= select_2915;
      patches_first_band_rows_to_next_q <= select_2919;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2916 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_533 ? select_2929 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_533 ? select_2933 : patches_choosing_number_q;
      patches_chooses_q <= select_2938;
      patches_choosing_band_q <= select_2940;
      patches_capturing_q <= sample_pair_whole_q ? select_1798 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_2968 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1792 : patches_row_q;
      patches_work_q <= or_3007 ? following : patches_work_q;
      patches_second_q <= not_1659 & (patches_second_q | (patches_ends_q & equal_1762));
      patches_following_q <= equal_1762 ? {2'h0, and_3013} : {equal_1764, select_3016};
      patches_following_beats_q <= {select_3028, not_3019};
      patches_begins_q <= sample_pair_whole_q & (and_1658 & and_1794);
      patches_ends_q <= not_3031 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3036;
      patches_code_row_q <= select_3038;
      patches_column_q <= or_3007 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3031 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_497_s1_q;
  logic [5:0] select_499_s1_q;
  logic [7:0] select_503_s1_q;
  logic and_507_s1_q;
  logic equal_513_s1_q;
  logic [5:0] column_s1_q;
  logic and_531_s1_q;
  logic and_533_s1_q;
  logic equal_557_s1_q;
  logic so_s1_q;
  logic equal_561_s1_q;
  logic or_562_s1_q;
  logic less_565_s1_q;
  logic not_566_s1_q;
  logic equal_576_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_600_s1_q;
  logic [5:0] right_s1_q;
  logic and_633_s1_q;
  logic [5:0] row_s1_q;
  logic and_1544_s1_q;
  logic equal_1545_s1_q;
  logic and_1658_s1_q;
  logic and_1671_s1_q;
  logic equal_1762_s1_q;
  logic not_1763_s1_q;
  logic equal_1764_s1_q;
  logic not_1765_s1_q;
  logic equal_1766_s1_q;
  logic equal_1767_s1_q;
  logic or_1768_s1_q;
  logic [4:0] select_1792_s1_q;
  logic select_1798_s1_q;
  logic [3:0] select_1839_s1_q;
  logic and_1849_s1_q;
  logic equal_2433_s1_q;
  logic and_2434_s1_q;
  logic or_3007_s1_q;
  logic not_3031_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
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
      select_497_s1_q <= select_497;
      select_499_s1_q <= select_499;
      select_503_s1_q <= select_503;
      and_507_s1_q <= and_507;
      equal_513_s1_q <= select_512 == 3'h0;
      column_s1_q <= column;
      and_531_s1_q <= and_531;
      and_533_s1_q <= and_533;
      equal_557_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_561_s1_q <= equal_561;
      or_562_s1_q <= or_562;
      less_565_s1_q <= less_565;
      not_566_s1_q <= not_566;
      equal_576_s1_q <= equal_576;
      x_s1_2_q <= x[6:0];
      select_600_s1_q <= select_600;
      right_s1_q <= right;
      and_633_s1_q <= and_633;
      row_s1_q <= row;
      and_1544_s1_q <= not_630 & and_599;
      equal_1545_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1658_s1_q <= and_1658;
      and_1671_s1_q <= and_1671;
      equal_1762_s1_q <= equal_1762;
      not_1763_s1_q <= not_1763;
      equal_1764_s1_q <= equal_1764;
      not_1765_s1_q <= not_1765;
      equal_1766_s1_q <= equal_1766;
      equal_1767_s1_q <= equal_1767;
      or_1768_s1_q <= or_1768;
      select_1792_s1_q <= select_1792;
      select_1798_s1_q <= select_1798;
      select_1839_s1_q <= select_1839;
      and_1849_s1_q <= and_1849;
      equal_2433_s1_q <= equal_2433;
      and_2434_s1_q <= and_2434;
      or_3007_s1_q <= or_3007;
      not_3031_s1_q <= not_3031;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
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
  logic and_508;
  assign and_508 = sample_pair_whole_s1_q & and_507_s1_q;
  // hls/stages/agreement.hpp:669
  logic equal_552;
  assign equal_552 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_553;
  assign equal_553 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic and_554;
  assign and_554 = equal_552 & equal_553;
  // hls/stages/moments.hpp:52
  logic [11:0] sum_555;
  assign sum_555 = moments_place_q + 12'h1;
  // hls/stages/agreement.hpp:1004
  logic [10:0] select_556;
  assign select_556 = and_554 ? 11'h0 : sum_555[10:0];
  // hls/stages/agreement.hpp:1010
  logic not_558;
  assign not_558 = ~equal_557_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_560;
  assign not_560 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_562_s1_q & not_566_s1_q;
  // hls/stages/moments.hpp:52
  logic [11:0] select_568;
  assign select_568 = and_554 ? 12'h0 : sum_555;
  // hls/stages/moments.hpp:54
  logic less_569;
  assign less_569 = 12'h66c < select_568;
  // hls/stages/moments.hpp:91
  logic not_570;
  assign not_570 = ~less_569;
  // hls/stages/agreement.hpp:789
  logic and_574;
  assign and_574 = not_558 & (not_560 & (equal_561_s1_q & (inside_v & not_570)));
  // hls/stages/agreement.hpp:976
  logic and_590;
  assign and_590 = (or_562_s1_q & (left_rdata_q[67] & not_566_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:967
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:968
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:969
  logic [5:0] select_609;
  assign select_609 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:669
  logic not_730;
  assign not_730 = ~equal_552;
  // hls/stages/agreement.hpp:672
  logic and_731;
  assign and_731 = left_rdata_q[12] & not_730;
  logic and_732;
  assign and_732 = left_rdata_q[30] & not_730;
  logic and_733;
  assign and_733 = left_rdata_q[48] & not_730;
  logic and_734;
  assign and_734 = left_rdata_q[66] & not_730;
  // hls/stages/agreement.hpp:673
  logic and_735;
  assign and_735 = right_codes_rdata_q[12] & not_730;
  logic and_736;
  assign and_736 = right_codes_rdata_q[27] & not_730;
  logic and_737;
  assign and_737 = right_codes_rdata_q[42] & not_730;
  logic and_738;
  assign and_738 = right_codes_rdata_q[57] & not_730;
  logic and_739;
  assign and_739 = right_codes_rdata_q[72] & not_730;
  logic and_740;
  assign and_740 = right_codes_rdata_q[85] & not_730;
  // hls/stages/agreement.hpp:221
  logic and_745;
  assign and_745 = left_rdata_q[48] & not_566_s1_q;
  logic and_746;
  assign and_746 = right_codes_rdata_q[42] & not_566_s1_q;
  logic [11:0] select_747;
  assign select_747 = less_565_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  logic [11:0] select_748;
  assign select_748 = less_565_s1_q ? 12'h0 : left_rdata_q[47:36];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_752;
  assign select_752 = and_745 ? (and_746 ? (~(select_747 ^ select_748)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_758;
  assign parity_758 = ^select_752[5:3];
  logic parity_761;
  assign parity_761 = ^select_752[8:6];
  logic parity_764;
  assign parity_764 = ^select_752[11:3];
  // hls/stages/agreement.hpp:221
  logic and_768;
  assign and_768 = left_rdata_q[66] & not_566_s1_q;
  logic and_769;
  assign and_769 = right_codes_rdata_q[57] & not_566_s1_q;
  logic [11:0] select_770;
  assign select_770 = less_565_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  logic [11:0] select_771;
  assign select_771 = less_565_s1_q ? 12'h0 : left_rdata_q[65:54];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_775;
  assign select_775 = and_768 ? (and_769 ? (~(select_770 ^ select_771)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_778;
  assign parity_778 = ^select_775[8:6];
  logic parity_781;
  assign parity_781 = ^select_775[11:9];
  // hls/stages/agreement.hpp:221
  logic and_785;
  assign and_785 = left_rdata_q[84] & not_566_s1_q;
  logic and_786;
  assign and_786 = right_codes_rdata_q[72] & not_566_s1_q;
  logic [11:0] select_787;
  assign select_787 = less_565_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  logic [11:0] select_788;
  assign select_788 = less_565_s1_q ? 12'h0 : left_rdata_q[83:72];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_792;
  assign select_792 = and_785 ? (and_786 ? (~(select_787 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_798;
  assign parity_798 = ^select_792[2:0];
  logic parity_801;
  assign parity_801 = ^select_792[5:3];
  logic parity_804;
  assign parity_804 = ^select_792[8:0];
  logic parity_810;
  assign parity_810 = ^select_792[11:9];
  logic parity_813;
  assign parity_813 = ^select_775[2:0];
  logic parity_816;
  assign parity_816 = ^{select_792[11:9], select_775[5:0]};
  logic parity_819;
  assign parity_819 = ^{select_792, select_775, select_752[2:0]};
  logic xor_820;
  assign xor_820 = parity_764 ^ parity_819;
  // hls/stages/count_bits.hpp:23
  logic or_824;
  assign or_824 = (select_752[1:0] == 2'h3) | (select_752[2] & (select_752[0] | select_752[1]));
  // hls/stages/count_bits.hpp:25
  logic or_828;
  assign or_828 = (select_775[7:6] == 2'h3) | (select_775[8] & (select_775[6] | select_775[7]));
  logic or_832;
  assign or_832 = (select_775[10:9] == 2'h3) | (select_775[11] & (select_775[9] | select_775[10]));
  // hls/stages/count_bits.hpp:23
  logic or_840;
  assign or_840 = (select_792[7:6] == 2'h3) | (select_792[8] & (~(select_792[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_844;
  assign or_844 = (select_792[1:0] == 2'h3) | (select_792[2] & (select_792[0] | select_792[1]));
  logic or_848;
  assign or_848 = (select_792[4:3] == 2'h3) | (select_792[5] & (select_792[3] | select_792[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_851;
  assign parity_851 = ^{or_848, or_844, or_840};
  // hls/stages/count_bits.hpp:23
  logic or_855;
  assign or_855 = (select_775[4:3] == 2'h3) | (select_775[5] & (select_775[3] | select_775[4]));
  // hls/stages/count_bits.hpp:25
  logic or_859;
  assign or_859 = (select_792[10:9] == 2'h3) | (select_792[11] & (select_792[9] | select_792[10]));
  logic or_863;
  assign or_863 = (select_775[1:0] == 2'h3) | (select_775[2] & (select_775[0] | select_775[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_866;
  assign parity_866 = ^{or_863, or_859, or_855};
  logic parity_869;
  assign parity_869 = ^{or_863, or_859, or_855, or_848, or_844, or_840, or_832, or_828, or_824};
  // hls/stages/count_bits.hpp:25
  logic and_870;
  assign and_870 = parity_764 & parity_819;
  logic or_874;
  assign or_874 = (parity_758 & parity_761) | ((^select_752[11:9]) & (parity_758 | parity_761));
  logic and_877;
  assign and_877 = (^{select_775[11:6], select_752[2:0]}) & (parity_804 | parity_816);
  logic or_878;
  assign or_878 = (parity_804 & parity_816) | and_877;
  // hls/stages/count_bits.hpp:23
  logic or_885;
  assign or_885 = (select_752[10:9] == 2'h3) | (select_752[11] & (select_752[9] | select_752[10]));
  // hls/stages/count_bits.hpp:25
  logic or_889;
  assign or_889 = (select_752[4:3] == 2'h3) | (select_752[5] & (select_752[3] | select_752[4]));
  logic or_893;
  assign or_893 = (select_752[7:6] == 2'h3) | (select_752[8] & (select_752[6] | select_752[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_896;
  assign parity_896 = ^{or_893, or_889, or_885};
  // hls/stages/count_bits.hpp:25
  logic or_900;
  assign or_900 = (parity_778 & parity_781) | ((^select_752[2:0]) & (parity_778 | parity_781));
  logic or_904;
  assign or_904 = (parity_798 & parity_801) | ((^select_792[8:6]) & (parity_798 | parity_801));
  logic or_908;
  assign or_908 = (parity_810 & parity_813) | ((^select_775[5:3]) & (parity_810 | parity_813));
  // hls/stages/count_bits.hpp:24
  logic parity_911;
  assign parity_911 = ^{or_908, or_904, or_900};
  logic parity_914;
  assign parity_914 = ^{or_908, or_904, or_900, or_893, or_889, or_885, or_878, or_874, and_870};
  logic xor_915;
  assign xor_915 = parity_869 ^ parity_914;
  // hls/stages/count_bits.hpp:25
  logic and_916;
  assign and_916 = parity_869 & parity_914;
  logic or_920;
  assign or_920 = (parity_851 & parity_866) | ((^{or_832, or_828, or_824}) & (parity_851 | parity_866));
  logic or_924;
  assign or_924 = (parity_896 & parity_911) | ((^{or_878, or_874, and_870}) & (parity_896 | parity_911));
  logic or_931;
  assign or_931 = (or_828 & or_832) | (or_824 & (or_828 | or_832));
  logic or_935;
  assign or_935 = (or_844 & or_848) | (or_840 & (or_844 | or_848));
  logic or_939;
  assign or_939 = (or_859 & or_863) | (or_855 & (or_859 | or_863));
  // hls/stages/count_bits.hpp:24
  logic parity_942;
  assign parity_942 = ^{or_939, or_935, or_931};
  // hls/stages/count_bits.hpp:25
  logic or_946;
  assign or_946 = (or_874 & or_878) | (and_870 & (or_874 | or_878));
  logic or_950;
  assign or_950 = (or_889 & or_893) | (or_885 & (or_889 | or_893));
  logic or_954;
  assign or_954 = (or_904 & or_908) | (or_900 & (or_904 | or_908));
  // hls/stages/count_bits.hpp:24
  logic parity_957;
  assign parity_957 = ^{or_954, or_950, or_946};
  logic parity_960;
  assign parity_960 = ^{or_954, or_950, or_946, or_939, or_935, or_931, or_924, or_920, and_916};
  // hls/stages/count_bits.hpp:25
  logic or_964;
  assign or_964 = (parity_942 & parity_957) | ((^{or_924, or_920, and_916}) & (parity_942 | parity_957));
  logic or_968;
  assign or_968 = (or_920 & or_924) | (and_916 & (or_920 | or_924));
  logic or_972;
  assign or_972 = (or_935 & or_939) | (or_931 & (or_935 | or_939));
  logic or_976;
  assign or_976 = (or_950 & or_954) | (or_946 & (or_950 | or_954));
  // hls/stages/count_bits.hpp:24
  logic parity_981;
  assign parity_981 = ^{or_976, or_972, or_968, or_964};
  // hls/stages/count_bits.hpp:25
  logic or_985;
  assign or_985 = (or_972 & or_976) | (or_968 & (or_972 | or_976));
  logic and_986;
  assign and_986 = or_964 & (^{or_976, or_972, or_968});
  // hls/stages/count_bits.hpp:24
  logic xor_987;
  assign xor_987 = or_985 ^ and_986;
  // hls/stages/count_bits.hpp:27
  logic and_988;
  assign and_988 = or_985 & and_986;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_989;
  assign select_989 = equal_576_s1_q ? {and_988, xor_987, parity_981, parity_960, xor_915, xor_820} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_562_s1_q ? 6'h0 : select_989;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1000;
  assign select_1000 = (slot_s1_q[0] ? and_786 : and_769) ? (~(select_748 ^ (slot_s1_q[0] ? select_787 : select_770))) : 12'h0;
  logic [11:0] select_1001;
  assign select_1001 = and_745 ? select_1000 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1007;
  assign parity_1007 = ^select_1001[5:3];
  logic parity_1010;
  assign parity_1010 = ^select_1001[8:6];
  logic parity_1013;
  assign parity_1013 = ^select_1001[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1017;
  assign and_1017 = right_codes_rdata_q[85] & not_566_s1_q;
  logic [11:0] select_1019;
  assign select_1019 = less_565_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1023;
  assign select_1023 = (slot_s1_q[0] ? and_1017 : and_786) ? (~(select_771 ^ (slot_s1_q[0] ? select_1019 : select_787))) : 12'h0;
  logic [11:0] select_1024;
  assign select_1024 = and_768 ? select_1023 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1027;
  assign parity_1027 = ^select_1024[8:6];
  logic parity_1030;
  assign parity_1030 = ^select_1024[11:9];
  // hls/stages/agreement.hpp:735
  logic select_1035;
  assign select_1035 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_566_s1_q) : and_1017;
  logic [11:0] select_1037;
  assign select_1037 = slot_s1_q[0] ? (less_565_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1019;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1041;
  assign select_1041 = and_785 ? (select_1035 ? (~(select_788 ^ select_1037)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1047;
  assign parity_1047 = ^select_1041[2:0];
  logic parity_1050;
  assign parity_1050 = ^select_1041[5:3];
  logic parity_1053;
  assign parity_1053 = ^select_1041[8:0];
  logic parity_1059;
  assign parity_1059 = ^select_1041[11:9];
  logic parity_1062;
  assign parity_1062 = ^select_1024[2:0];
  logic parity_1065;
  assign parity_1065 = ^{select_1041[11:9], select_1024[5:0]};
  logic parity_1068;
  assign parity_1068 = ^{select_1041, select_1024, select_1001[2:0]};
  logic xor_1069;
  assign xor_1069 = parity_1013 ^ parity_1068;
  // hls/stages/count_bits.hpp:23
  logic or_1073;
  assign or_1073 = (select_1001[1:0] == 2'h3) | (select_1001[2] & (select_1001[0] | select_1001[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1077;
  assign or_1077 = (select_1024[7:6] == 2'h3) | (select_1024[8] & (select_1024[6] | select_1024[7]));
  logic or_1081;
  assign or_1081 = (select_1024[10:9] == 2'h3) | (select_1024[11] & (select_1024[9] | select_1024[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1089;
  assign or_1089 = (select_1041[7:6] == 2'h3) | (select_1041[8] & (~(select_1041[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1093;
  assign or_1093 = (select_1041[1:0] == 2'h3) | (select_1041[2] & (select_1041[0] | select_1041[1]));
  logic or_1097;
  assign or_1097 = (select_1041[4:3] == 2'h3) | (select_1041[5] & (select_1041[3] | select_1041[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1100;
  assign parity_1100 = ^{or_1097, or_1093, or_1089};
  // hls/stages/count_bits.hpp:23
  logic or_1104;
  assign or_1104 = (select_1024[4:3] == 2'h3) | (select_1024[5] & (select_1024[3] | select_1024[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1108;
  assign or_1108 = (select_1041[10:9] == 2'h3) | (select_1041[11] & (select_1041[9] | select_1041[10]));
  logic or_1112;
  assign or_1112 = (select_1024[1:0] == 2'h3) | (select_1024[2] & (select_1024[0] | select_1024[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  logic parity_1118;
  assign parity_1118 = ^{or_1112, or_1108, or_1104, or_1097, or_1093, or_1089, or_1081, or_1077, or_1073};
  // hls/stages/count_bits.hpp:25
  logic and_1119;
  assign and_1119 = parity_1013 & parity_1068;
  logic or_1123;
  assign or_1123 = (parity_1007 & parity_1010) | ((^select_1001[11:9]) & (parity_1007 | parity_1010));
  logic and_1126;
  assign and_1126 = (^{select_1024[11:6], select_1001[2:0]}) & (parity_1053 | parity_1065);
  logic or_1127;
  assign or_1127 = (parity_1053 & parity_1065) | and_1126;
  // hls/stages/count_bits.hpp:23
  logic or_1134;
  assign or_1134 = (select_1001[10:9] == 2'h3) | (select_1001[11] & (select_1001[9] | select_1001[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1138;
  assign or_1138 = (select_1001[4:3] == 2'h3) | (select_1001[5] & (select_1001[3] | select_1001[4]));
  logic or_1142;
  assign or_1142 = (select_1001[7:6] == 2'h3) | (select_1001[8] & (select_1001[6] | select_1001[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1145;
  assign parity_1145 = ^{or_1142, or_1138, or_1134};
  // hls/stages/count_bits.hpp:25
  logic or_1149;
  assign or_1149 = (parity_1027 & parity_1030) | ((^select_1001[2:0]) & (parity_1027 | parity_1030));
  logic or_1153;
  assign or_1153 = (parity_1047 & parity_1050) | ((^select_1041[8:6]) & (parity_1047 | parity_1050));
  logic or_1157;
  assign or_1157 = (parity_1059 & parity_1062) | ((^select_1024[5:3]) & (parity_1059 | parity_1062));
  // hls/stages/count_bits.hpp:24
  logic parity_1160;
  assign parity_1160 = ^{or_1157, or_1153, or_1149};
  logic parity_1163;
  assign parity_1163 = ^{or_1157, or_1153, or_1149, or_1142, or_1138, or_1134, or_1127, or_1123, and_1119};
  logic xor_1164;
  assign xor_1164 = parity_1118 ^ parity_1163;
  // hls/stages/count_bits.hpp:25
  logic and_1165;
  assign and_1165 = parity_1118 & parity_1163;
  logic or_1169;
  assign or_1169 = (parity_1100 & parity_1115) | ((^{or_1081, or_1077, or_1073}) & (parity_1100 | parity_1115));
  logic or_1173;
  assign or_1173 = (parity_1145 & parity_1160) | ((^{or_1127, or_1123, and_1119}) & (parity_1145 | parity_1160));
  logic or_1180;
  assign or_1180 = (or_1077 & or_1081) | (or_1073 & (or_1077 | or_1081));
  logic or_1184;
  assign or_1184 = (or_1093 & or_1097) | (or_1089 & (or_1093 | or_1097));
  logic or_1188;
  assign or_1188 = (or_1108 & or_1112) | (or_1104 & (or_1108 | or_1112));
  // hls/stages/count_bits.hpp:24
  logic parity_1191;
  assign parity_1191 = ^{or_1188, or_1184, or_1180};
  // hls/stages/count_bits.hpp:25
  logic or_1195;
  assign or_1195 = (or_1123 & or_1127) | (and_1119 & (or_1123 | or_1127));
  logic or_1199;
  assign or_1199 = (or_1138 & or_1142) | (or_1134 & (or_1138 | or_1142));
  logic or_1203;
  assign or_1203 = (or_1153 & or_1157) | (or_1149 & (or_1153 | or_1157));
  // hls/stages/count_bits.hpp:24
  logic parity_1206;
  assign parity_1206 = ^{or_1203, or_1199, or_1195};
  logic parity_1209;
  assign parity_1209 = ^{or_1203, or_1199, or_1195, or_1188, or_1184, or_1180, or_1173, or_1169, and_1165};
  // hls/stages/count_bits.hpp:25
  logic or_1213;
  assign or_1213 = (parity_1191 & parity_1206) | ((^{or_1173, or_1169, and_1165}) & (parity_1191 | parity_1206));
  logic or_1217;
  assign or_1217 = (or_1169 & or_1173) | (and_1165 & (or_1169 | or_1173));
  logic or_1221;
  assign or_1221 = (or_1184 & or_1188) | (or_1180 & (or_1184 | or_1188));
  logic or_1225;
  assign or_1225 = (or_1199 & or_1203) | (or_1195 & (or_1199 | or_1203));
  // hls/stages/count_bits.hpp:24
  logic parity_1230;
  assign parity_1230 = ^{or_1225, or_1221, or_1217, or_1213};
  // hls/stages/count_bits.hpp:25
  logic or_1234;
  assign or_1234 = (or_1221 & or_1225) | (or_1217 & (or_1221 | or_1225));
  logic and_1235;
  assign and_1235 = or_1213 & (^{or_1225, or_1221, or_1217});
  // hls/stages/count_bits.hpp:24
  logic xor_1236;
  assign xor_1236 = or_1234 ^ and_1235;
  // hls/stages/count_bits.hpp:27
  logic and_1237;
  assign and_1237 = or_1234 & and_1235;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1238;
  assign select_1238 = equal_576_s1_q ? {and_1237, xor_1236, parity_1230, parity_1209, xor_1164, xor_1069} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_562_s1_q ? 6'h0 : select_1238;
  // hls/stages/agreement.hpp:221
  logic and_1246;
  assign and_1246 = right_codes_rdata_q[27] & not_566_s1_q;
  // hls/stages/agreement.hpp:735
  logic select_1247;
  assign select_1247 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_566_s1_q) : and_1246;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1249;
  assign select_1249 = less_565_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:735
  logic [11:0] select_1250;
  assign select_1250 = slot_s1_q[0] ? (less_565_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1249;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1254;
  assign select_1254 = and_745 ? (select_1247 ? (~(select_748 ^ select_1250)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1260;
  assign parity_1260 = ^select_1254[5:3];
  logic parity_1263;
  assign parity_1263 = ^select_1254[8:6];
  logic parity_1266;
  assign parity_1266 = ^select_1254[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1274;
  assign select_1274 = (slot_s1_q[0] ? and_1246 : and_746) ? (~(select_771 ^ (slot_s1_q[0] ? select_1249 : select_747))) : 12'h0;
  logic [11:0] select_1275;
  assign select_1275 = and_768 ? select_1274 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1275[8:6];
  logic parity_1281;
  assign parity_1281 = ^select_1275[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1289;
  assign select_1289 = (slot_s1_q[0] ? and_746 : and_769) ? (~(select_788 ^ (slot_s1_q[0] ? select_747 : select_770))) : 12'h0;
  logic [11:0] select_1290;
  assign select_1290 = and_785 ? select_1289 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1296;
  assign parity_1296 = ^select_1290[2:0];
  logic parity_1299;
  assign parity_1299 = ^select_1290[5:3];
  logic parity_1302;
  assign parity_1302 = ^select_1290[8:0];
  logic parity_1308;
  assign parity_1308 = ^select_1290[11:9];
  logic parity_1311;
  assign parity_1311 = ^select_1275[2:0];
  logic parity_1314;
  assign parity_1314 = ^{select_1290[11:9], select_1275[5:0]};
  logic parity_1317;
  assign parity_1317 = ^{select_1290, select_1275, select_1254[2:0]};
  logic xor_1318;
  assign xor_1318 = parity_1266 ^ parity_1317;
  // hls/stages/count_bits.hpp:23
  logic or_1322;
  assign or_1322 = (select_1254[1:0] == 2'h3) | (select_1254[2] & (select_1254[0] | select_1254[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1326;
  assign or_1326 = (select_1275[7:6] == 2'h3) | (select_1275[8] & (select_1275[6] | select_1275[7]));
  logic or_1330;
  assign or_1330 = (select_1275[10:9] == 2'h3) | (select_1275[11] & (select_1275[9] | select_1275[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1338;
  assign or_1338 = (select_1290[7:6] == 2'h3) | (select_1290[8] & (~(select_1290[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1342;
  assign or_1342 = (select_1290[1:0] == 2'h3) | (select_1290[2] & (select_1290[0] | select_1290[1]));
  logic or_1346;
  assign or_1346 = (select_1290[4:3] == 2'h3) | (select_1290[5] & (select_1290[3] | select_1290[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1349;
  assign parity_1349 = ^{or_1346, or_1342, or_1338};
  // hls/stages/count_bits.hpp:23
  logic or_1353;
  assign or_1353 = (select_1275[4:3] == 2'h3) | (select_1275[5] & (select_1275[3] | select_1275[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1357;
  assign or_1357 = (select_1290[10:9] == 2'h3) | (select_1290[11] & (select_1290[9] | select_1290[10]));
  logic or_1361;
  assign or_1361 = (select_1275[1:0] == 2'h3) | (select_1275[2] & (select_1275[0] | select_1275[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1364;
  assign parity_1364 = ^{or_1361, or_1357, or_1353};
  logic parity_1367;
  assign parity_1367 = ^{or_1361, or_1357, or_1353, or_1346, or_1342, or_1338, or_1330, or_1326, or_1322};
  // hls/stages/count_bits.hpp:25
  logic and_1368;
  assign and_1368 = parity_1266 & parity_1317;
  logic or_1372;
  assign or_1372 = (parity_1260 & parity_1263) | ((^select_1254[11:9]) & (parity_1260 | parity_1263));
  logic and_1375;
  assign and_1375 = (^{select_1275[11:6], select_1254[2:0]}) & (parity_1302 | parity_1314);
  logic or_1376;
  assign or_1376 = (parity_1302 & parity_1314) | and_1375;
  // hls/stages/count_bits.hpp:23
  logic or_1383;
  assign or_1383 = (select_1254[10:9] == 2'h3) | (select_1254[11] & (select_1254[9] | select_1254[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1387;
  assign or_1387 = (select_1254[4:3] == 2'h3) | (select_1254[5] & (select_1254[3] | select_1254[4]));
  logic or_1391;
  assign or_1391 = (select_1254[7:6] == 2'h3) | (select_1254[8] & (select_1254[6] | select_1254[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1394;
  assign parity_1394 = ^{or_1391, or_1387, or_1383};
  // hls/stages/count_bits.hpp:25
  logic or_1398;
  assign or_1398 = (parity_1278 & parity_1281) | ((^select_1254[2:0]) & (parity_1278 | parity_1281));
  logic or_1402;
  assign or_1402 = (parity_1296 & parity_1299) | ((^select_1290[8:6]) & (parity_1296 | parity_1299));
  logic or_1406;
  assign or_1406 = (parity_1308 & parity_1311) | ((^select_1275[5:3]) & (parity_1308 | parity_1311));
  // hls/stages/count_bits.hpp:24
  logic parity_1409;
  assign parity_1409 = ^{or_1406, or_1402, or_1398};
  logic parity_1412;
  assign parity_1412 = ^{or_1406, or_1402, or_1398, or_1391, or_1387, or_1383, or_1376, or_1372, and_1368};
  logic xor_1413;
  assign xor_1413 = parity_1367 ^ parity_1412;
  // hls/stages/count_bits.hpp:25
  logic and_1414;
  assign and_1414 = parity_1367 & parity_1412;
  logic or_1418;
  assign or_1418 = (parity_1349 & parity_1364) | ((^{or_1330, or_1326, or_1322}) & (parity_1349 | parity_1364));
  logic or_1422;
  assign or_1422 = (parity_1394 & parity_1409) | ((^{or_1376, or_1372, and_1368}) & (parity_1394 | parity_1409));
  logic or_1429;
  assign or_1429 = (or_1326 & or_1330) | (or_1322 & (or_1326 | or_1330));
  logic or_1433;
  assign or_1433 = (or_1342 & or_1346) | (or_1338 & (or_1342 | or_1346));
  logic or_1437;
  assign or_1437 = (or_1357 & or_1361) | (or_1353 & (or_1357 | or_1361));
  // hls/stages/count_bits.hpp:24
  logic parity_1440;
  assign parity_1440 = ^{or_1437, or_1433, or_1429};
  // hls/stages/count_bits.hpp:25
  logic or_1444;
  assign or_1444 = (or_1372 & or_1376) | (and_1368 & (or_1372 | or_1376));
  logic or_1448;
  assign or_1448 = (or_1387 & or_1391) | (or_1383 & (or_1387 | or_1391));
  logic or_1452;
  assign or_1452 = (or_1402 & or_1406) | (or_1398 & (or_1402 | or_1406));
  // hls/stages/count_bits.hpp:24
  logic parity_1455;
  assign parity_1455 = ^{or_1452, or_1448, or_1444};
  logic parity_1458;
  assign parity_1458 = ^{or_1452, or_1448, or_1444, or_1437, or_1433, or_1429, or_1422, or_1418, and_1414};
  // hls/stages/count_bits.hpp:25
  logic or_1462;
  assign or_1462 = (parity_1440 & parity_1455) | ((^{or_1422, or_1418, and_1414}) & (parity_1440 | parity_1455));
  logic or_1466;
  assign or_1466 = (or_1418 & or_1422) | (and_1414 & (or_1418 | or_1422));
  logic or_1470;
  assign or_1470 = (or_1433 & or_1437) | (or_1429 & (or_1433 | or_1437));
  logic or_1474;
  assign or_1474 = (or_1448 & or_1452) | (or_1444 & (or_1448 | or_1452));
  // hls/stages/count_bits.hpp:24
  logic parity_1479;
  assign parity_1479 = ^{or_1474, or_1470, or_1466, or_1462};
  // hls/stages/count_bits.hpp:25
  logic or_1483;
  assign or_1483 = (or_1470 & or_1474) | (or_1466 & (or_1470 | or_1474));
  logic and_1484;
  assign and_1484 = or_1462 & (^{or_1474, or_1470, or_1466});
  // hls/stages/count_bits.hpp:24
  logic xor_1485;
  assign xor_1485 = or_1483 ^ and_1484;
  // hls/stages/count_bits.hpp:27
  logic and_1486;
  assign and_1486 = or_1483 & and_1484;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1487;
  assign select_1487 = equal_576_s1_q ? {and_1486, xor_1485, parity_1479, parity_1458, xor_1413, xor_1318} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_562_s1_q ? 6'h0 : select_1487;
  // hls/stages/agreement.hpp:789
  logic and_1555;
  assign and_1555 = ends_cell_s1_q & inside_v;
  logic and_1557;
  assign and_1557 = not_558 & (so_s1_q & and_1555);
  logic [5:0] select_1561;
  assign select_1561 = so_s1_q ? x_s1_q[5:0] : (or_562_s1_q ? (less_565_s1_q ? 6'h0 : select_609) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1565;
  assign or_1565 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1574;
  assign and_1574 = or_562_s1_q & (slot_s1_q[2] & not_566_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1690;
  assign select_1690 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1690[16:7])) ? 8'h7f : select_1690[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1767_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1767_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:496
  logic less_1855;
  assign less_1855 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:497
  logic or_1856;
  assign or_1856 = equal_1766_s1_q | less_1855;
  // hls/stages/patches.hpp:500
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1861;
  assign select_1861 = equal_1766_s1_q ? patches_column_s1_q[0] : (or_1856 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1862;
  assign not_1862 = ~or_1856;
  // hls/stages/patches.hpp:497
  logic [4:0] sum_1863;
  assign sum_1863 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:499
  logic [4:0] select_1866;
  assign select_1866 = or_1856 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1863) + 5'h1) : sum_1863;
  // hls/stages/patches.hpp:501
  logic [4:0] select_1867;
  assign select_1867 = equal_1766_s1_q ? 5'h0 : select_1866;
  logic or_1868;
  assign or_1868 = equal_1766_s1_q | equal_1764_s1_q;
  // hls/stages/patches.hpp:477
  logic equal_1870;
  assign equal_1870 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1872;
  assign equal_1872 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:479
  logic and_1874;
  assign and_1874 = of_row & (~equal_1872);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1870 ? 2'h3 : {equal_1872, and_1874};
  // hls/stages/patches.hpp:465
  logic [8:0] sum_1877;
  assign sum_1877 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1878;
  assign sum_1878 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1877, pixel_2[0]} - {1'b0, sum_1878, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:467
  logic [11:0] sum_1880;
  assign sum_1880 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1881;
  assign sum_1881 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1880[11], sum_1880};
  logic [13:0] sum_1882;
  assign sum_1882 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1881, down_2[1]};
  logic [12:0] sum_1883;
  assign sum_1883 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1882[13:1];
  logic [14:0] sum_1884;
  assign sum_1884 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1883, sum_1882[0], down_2[0]};
  // hls/stages/patches.hpp:463
  logic [8:0] sum_1887;
  assign sum_1887 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1888;
  assign sum_1888 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1887};
  logic [10:0] sum_1889;
  assign sum_1889 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1888, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1890;
  assign sum_1890 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1889[10:1];
  // hls/stages/patches.hpp:464
  logic [11:0] smooth;
  assign smooth = {sum_1890, sum_1889[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:466
  logic [12:0] sum_1892;
  assign sum_1892 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1893;
  assign sum_1893 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1894;
  assign difference_1894 = {1'b0, sum_1892, smooth[0]} - {1'b0, sum_1893, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:478
  logic or_1900;
  assign or_1900 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1872) | equal_1870;
  // hls/stages/patches.hpp:473
  logic and_1905;
  assign and_1905 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1909;
  assign and_1909 = not_1765_s1_q & (or_1768_s1_q & (or_1900 & (equal_1767_s1_q & and_1905)));
  // hls/stages/patches.hpp:172
  logic and_1919;
  assign and_1919 = (~(equal_1767_s1_q | (~and_1905))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1923;
  assign and_1923 = not_1765_s1_q & (or_1768_s1_q & (and_1919 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:542
  logic less_1925;
  assign less_1925 = patches_step_q[4:0] < 5'h11;
  logic equal_1926;
  assign equal_1926 = patches_step_q[6:5] == 2'h0;
  logic not_1927;
  assign not_1927 = ~equal_1926;
  logic equal_1928;
  assign equal_1928 = patches_step_q[6:5] == 2'h3;
  logic not_1929;
  assign not_1929 = ~equal_1928;
  // hls/stages/patches.hpp:556
  logic select_1932;
  assign select_1932 = equal_1928 ? (less_1925 & (less_1925 & not_1929)) : less_1925;
  // hls/stages/patches.hpp:184
  logic and_1935;
  assign and_1935 = equal_1762_s1_q & (less_1925 ? (not_1927 & select_1932) : select_1932);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1963;
  assign sum_1963 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2260;
  assign select_2260 = equal_561_s1_q ? (inside_v ? select_568 : moments_place_q) : moments_place_q;
  logic [11:0] select_2262;
  assign select_2262 = equal_557_s1_q ? moments_place_q : (so_s1_q ? moments_place_q : select_2260);
  // hls/stages/agreement.hpp:461
  logic select_2530;
  assign select_2530 = equal_2433_s1_q ? (~({row_s1_q, 1'b0} < {sum_2527, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:521
  logic and_2791;
  assign and_2791 = and_533_s1_q & (equal_2433_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2792;
  assign and_2792 = and_2434_s1_q & and_2791;
  // hls/stages/registration.hpp:127
  logic and_2794;
  assign and_2794 = and_2434_s1_q & (~and_2791);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2795;
  assign select_2795 = and_2794 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2797;
  assign select_2797 = and_2792 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2795[15]}}, select_2795});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2798;
  assign select_2798 = and_2794 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2798[15]}}, select_2798};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2800;
  assign select_2800 = and_2792 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2801;
  assign and_2801 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2801 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3046;
  assign select_3046 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3049;
  assign select_3049 = equal_1764_s1_q ? patches_smooth_values_0_q : (or_1768_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3051;
  assign select_3051 = or_1768_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3053;
  assign select_3053 = equal_1762_s1_q ? patches_smooth_values_1_q : (equal_1764_s1_q ? patches_smooth_values_1_q : select_3051);
  logic [11:0] select_3054;
  assign select_3054 = or_1768_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3056;
  assign select_3056 = equal_1762_s1_q ? patches_smooth_values_2_q : (equal_1764_s1_q ? patches_smooth_values_2_q : select_3054);
  logic [11:0] select_3057;
  assign select_3057 = or_1768_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3059;
  assign select_3059 = equal_1762_s1_q ? patches_smooth_values_3_q : (equal_1764_s1_q ? patches_smooth_values_3_q : select_3057);
  logic [10:0] select_3061;
  assign select_3061 = equal_1764_s1_q ? patches_down_values_0_q : (or_1768_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3064;
  assign select_3064 = equal_1764_s1_q ? patches_down_values_1_q : (or_1768_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3067;
  assign select_3067 = equal_1764_s1_q ? patches_down_values_2_q : (or_1768_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3070;
  assign select_3070 = equal_1764_s1_q ? patches_down_values_3_q : (or_1768_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3107;
  assign and_3107 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3112;
  assign select_3112 = or_3007_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3114;
  assign select_3114 = and_3107 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3470;
  assign select_3470 = equal_1762_s1_q ? patches_summed_down_by_q : (equal_1764_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:552
  logic and_3503;
  assign and_3503 = less_1925 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:556
  logic select_3506;
  assign select_3506 = equal_1928 ? (less_1925 ? (not_1929 & and_3503) : and_3503) : and_3503;
  // hls/stages/patches.hpp:184
  logic select_3509;
  assign select_3509 = equal_1762_s1_q ? (less_1925 ? (not_1927 & select_3506) : select_3506) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3850;
  assign select_3850 = so_s1_q ? (and_2801 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3852;
  assign sum_3852 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3853;
  assign select_3853 = sum_1963[5] ? {1'b1, sum_1963[4:0], region_across_rest_q[2:0]} : sum_3852;
  // hls/stages/agreement.hpp:461
  logic [7:0] select_3855;
  assign select_3855 = equal_2433_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3858;
  assign select_3858 = equal_2433_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_503_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_508;
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
  assign census_memory_re = s1_en & and_533_s1_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 1645 x 4, DISTANCE 16, hls/stages/moments.hpp:106; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:1644];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1645; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [10:0] moments_memory_raddr;
  assign moments_memory_raddr = select_556;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_574;
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
  assign best_right_raddr = or_562_s1_q ? select_609 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_600_s1_q;
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
  assign shown_right_re = s1_en & and_1557;
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
  assign left_turns_re = s1_en & and_1574;
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
  assign right_turns_raddr = select_609;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1574;
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
  assign patches_right_codes_raddr = {select_1867, not_1862, select_1861};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1868;
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
  assign patches_left_codes_re = s1_en & (not_1763_s1_q & (new_row & equal_1764_s1_q));
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
  assign patches_rows_re = s1_en & and_1935;
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
  assign seen_columns_re = s1_en & and_1557;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_633_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_734, left_rdata_q[65:49], and_733, left_rdata_q[47:31], and_732, left_rdata_q[29:13], and_731, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_633_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_740, right_codes_rdata_q[84:73], and_739, right_codes_rdata_q[71:60], and_738, right_codes_rdata_q[56:43], and_737, right_codes_rdata_q[41:28], and_736, right_codes_rdata_q[26:13], and_735, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1849_s1_q;
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
      moments_place_q <= select_2262;
      row_q <= and_533_s1_q ? (equal_2433_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_533_s1_q ? select_2530 : lower_half_q;
      registration_slope_row_q <= select_2797;
      registration_slope_change_q <= select_2800;
      registration_slope_q <= so_s1_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3031_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3031_s1_q & select_3046;
      patches_smooth_values_0_q <= equal_1762_s1_q ? patches_smooth_values_0_q : select_3049;
      patches_smooth_values_1_q <= select_3053;
      patches_smooth_values_2_q <= select_3056;
      patches_smooth_values_3_q <= select_3059;
      patches_down_values_0_q <= equal_1762_s1_q ? patches_down_values_0_q : select_3061;
      patches_down_values_1_q <= equal_1762_s1_q ? patches_down_values_1_q : select_3064;
      patches_down_values_2_q <= equal_1762_s1_q ? patches_down_values_2_q : select_3067;
      patches_down_values_3_q <= equal_1762_s1_q ? patches_down_values_3_q : select_3070;
      patches_down_by_q <= or_3007_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3107});
      patches_along_q <= select_3112;
      patches_match_row_q <= or_3007_s1_q ? 4'h0 : select_3114;
      patches_summed_last_q <= not_1763_s1_q & (equal_1764_s1_q & and_3107);
      patches_summed_down_by_q <= select_3470;
      patches_step_q <= or_3007_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3509;
      region_across_rest_q <= select_3850;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3853;
      columns_begin_rest_q <= and_533_s1_q ? select_3855 : columns_begin_rest_q;
      columns_begin_back_q <= and_533_s1_q ? select_3858 : columns_begin_back_q;
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
  logic [2:0] select_497_s2_q;
  logic [5:0] select_499_s2_q;
  logic [7:0] select_503_s2_q;
  logic and_507_s2_q;
  logic and_508_s2_q;
  logic equal_513_s2_q;
  logic [5:0] column_s2_q;
  logic and_531_s2_q;
  logic and_533_s2_q;
  logic equal_553_s2_q;
  logic and_554_s2_q;
  logic [10:0] select_556_s2_q;
  logic equal_557_s2_q;
  logic not_558_s2_q;
  logic so_s2_q;
  logic not_560_s2_q;
  logic equal_561_s2_q;
  logic or_562_s2_q;
  logic less_565_s2_q;
  logic not_566_s2_q;
  logic inside_v_s2_q;
  logic less_569_s2_q;
  logic not_570_s2_q;
  logic and_574_s2_q;
  logic and_583_s2_q;
  logic and_591_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_622_s2_q;
  logic and_627_s2_q;
  logic and_629_s2_q;
  logic equal_662_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1240_s2_q;
  logic [5:0] select_1489_s2_q;
  logic and_1544_s2_q;
  logic equal_1545_s2_q;
  logic and_1555_s2_q;
  logic and_1557_s2_q;
  logic [5:0] select_1561_s2_q;
  logic or_1565_s2_q;
  logic and_1658_s2_q;
  logic and_1671_s2_q;
  logic less_1685_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1762_s2_q;
  logic equal_1764_s2_q;
  logic equal_1767_s2_q;
  logic or_1768_s2_q;
  logic [4:0] select_1792_s2_q;
  logic select_1798_s2_q;
  logic [3:0] select_1839_s2_q;
  logic less_1855_s2_q;
  logic new_row_s2_q;
  logic or_1868_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_1885_s2_q;
  logic less_1886_s2_q;
  logic less_1895_s2_q;
  logic less_1896_s2_q;
  logic and_1910_s2_q;
  logic and_1919_s2_q;
  logic and_1924_s2_q;
  logic less_1925_s2_q;
  logic equal_1926_s2_q;
  logic not_1927_s2_q;
  logic equal_1928_s2_q;
  logic not_1929_s2_q;
  logic and_1942_s2_q;
  logic select_1944_s2_q;
  logic and_1947_s2_q;
  logic sum_1963_s2_q;
  logic and_1984_s2_q;
  logic and_2102_s2_q;
  logic equal_2248_s2_q;
  logic equal_2433_s2_q;
  logic and_2560_s2_q;
  logic equal_2645_s2_q;
  logic less_3083_s2_q;
  logic equal_3426_s2_q;
  logic equal_3510_s2_q;
  logic less_3838_s2_q;
  logic equal_4056_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
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
      select_497_s2_q <= select_497_s1_q;
      select_499_s2_q <= select_499_s1_q;
      select_503_s2_q <= select_503_s1_q;
      and_507_s2_q <= and_507_s1_q;
      and_508_s2_q <= and_508;
      equal_513_s2_q <= equal_513_s1_q;
      column_s2_q <= column_s1_q;
      and_531_s2_q <= and_531_s1_q;
      and_533_s2_q <= and_533_s1_q;
      equal_553_s2_q <= equal_553;
      and_554_s2_q <= and_554;
      select_556_s2_q <= select_556;
      equal_557_s2_q <= equal_557_s1_q;
      not_558_s2_q <= not_558;
      so_s2_q <= so_s1_q;
      not_560_s2_q <= not_560;
      equal_561_s2_q <= equal_561_s1_q;
      or_562_s2_q <= or_562_s1_q;
      less_565_s2_q <= less_565_s1_q;
      not_566_s2_q <= not_566_s1_q;
      inside_v_s2_q <= inside_v;
      less_569_s2_q <= less_569;
      not_570_s2_q <= not_570;
      and_574_s2_q <= and_574;
      and_583_s2_q <= or_562_s1_q & (left_rdata_q[70] & not_566_s1_q);
      and_591_s2_q <= (or_562_s1_q & (left_rdata_q[68] & not_566_s1_q)) & and_590;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_622_s2_q <= or_562_s1_q & (left_rdata_q[71] & not_566_s1_q);
      and_627_s2_q <= or_562_s1_q & (right_codes_rdata_q[58] & not_566_s1_q);
      and_629_s2_q <= or_562_s1_q & (right_codes_rdata_q[59] & not_566_s1_q);
      equal_662_s2_q <= row_s1_q == 6'h0;
      column_2_s2_q <= column_2;
      select_1240_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1489_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1544_s2_q <= and_1544_s1_q;
      equal_1545_s2_q <= equal_1545_s1_q;
      and_1555_s2_q <= and_1555;
      and_1557_s2_q <= and_1557;
      select_1561_s2_q <= select_1561;
      or_1565_s2_q <= or_1565;
      and_1658_s2_q <= and_1658_s1_q;
      and_1671_s2_q <= and_1671_s1_q;
      less_1685_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1762_s2_q <= equal_1762_s1_q;
      equal_1764_s2_q <= equal_1764_s1_q;
      equal_1767_s2_q <= equal_1767_s1_q;
      or_1768_s2_q <= or_1768_s1_q;
      select_1792_s2_q <= select_1792_s1_q;
      select_1798_s2_q <= select_1798_s1_q;
      select_1839_s2_q <= select_1839_s1_q;
      less_1855_s2_q <= less_1855;
      new_row_s2_q <= new_row;
      or_1868_s2_q <= or_1868;
      of_row_2_s2_q <= of_row_2;
      less_1885_s2_q <= $signed(15'h100) < $signed(sum_1884);
      less_1886_s2_q <= $signed(sum_1884[14:8]) < $signed(7'h7f);
      less_1895_s2_q <= $signed(15'h100) < $signed(difference_1894);
      less_1896_s2_q <= $signed(difference_1894[14:8]) < $signed(7'h7f);
      and_1910_s2_q <= not_1763_s1_q & and_1909;
      and_1919_s2_q <= and_1919;
      and_1924_s2_q <= not_1763_s1_q & and_1923;
      less_1925_s2_q <= less_1925;
      equal_1926_s2_q <= equal_1926;
      not_1927_s2_q <= not_1927;
      equal_1928_s2_q <= equal_1928;
      not_1929_s2_q <= not_1929;
      and_1942_s2_q <= sample_pair_whole_q;
      select_1944_s2_q <= left_first_q;
      and_1947_s2_q <= right_q;
      sum_1963_s2_q <= sum_1963[5];
      and_1984_s2_q <= or_562_s1_q & (left_rdata_q[69] & not_566_s1_q);
      and_2102_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2248_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2433_s2_q <= equal_2433_s1_q;
      and_2560_s2_q <= or_562_s1_q & (not_566_s1_q & and_590);
      equal_2645_s2_q <= shift == 6'h0;
      less_3083_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3426_s2_q <= patches_match_row_q == 4'h0;
      equal_3510_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3838_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4056_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic moments_out_of_step_q;
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
  logic [11:0] select_511;
  assign select_511 = select_497_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_515;
  assign sum_515 = select_511 + (equal_513_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_517;
  assign sum_517 = {4'h0, sample_pair_pixel_1_q} + (select_497_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_519;
  assign sum_519 = sum_517 + (equal_513_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_497_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_523;
  assign and_523 = whole & (averager_memory_rdata_q[24] | equal_513_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_497_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_527;
  assign and_527 = all_of_skin & (averager_memory_rdata_q[25] | equal_513_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_507_s2_q ? sum_515[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_536;
  assign equal_536 = select_497_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_536 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_539;
  assign select_539 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_507_s2_q ? sum_519[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_536 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_543;
  assign select_543 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_544;
  assign and_544 = and_507_s2_q & and_523;
  // hls/stages/census.hpp:127
  logic select_546;
  assign select_546 = equal_536 ? and_544 : (averager_mask_q & and_544);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_546;
  // hls/stages/census.hpp:207
  logic and_548;
  assign and_548 = and_507_s2_q & and_527;
  // hls/stages/census.hpp:127
  logic select_550;
  assign select_550 = equal_536 ? and_548 : (averager_of_skin_q & and_548);
  // hls/stages/agreement.hpp:276
  logic and_551;
  assign and_551 = sample_pair_whole_s2_q & select_550;
  // hls/stages/agreement.hpp:979
  logic select_604;
  assign select_604 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:980
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:993
  logic [8:0] difference_614;
  assign difference_614 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:994
  logic [9:0] sum_615;
  assign sum_615 = {difference_614[8], difference_614} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_617;
  assign and_617 = (and_591_s2_q & select_604) & ({{22{sum_615[9]}}, sum_615} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_619;
  assign and_619 = or_562_s2_q & (not_566_s2_q & and_617);
  // hls/stages/moments.hpp:64
  logic and_620;
  assign and_620 = and_583_s2_q & and_619;
  // hls/stages/census.hpp:296
  logic less_635;
  assign less_635 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_636;
  assign less_636 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_637;
  assign less_637 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_638;
  assign less_638 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_639;
  assign less_639 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_640;
  assign less_640 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_641;
  assign less_641 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_642;
  assign less_642 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_643;
  assign less_643 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_644;
  assign less_644 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_645;
  assign less_645 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_646;
  assign less_646 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_647;
  assign less_647 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_648;
  assign less_648 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_649;
  assign less_649 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_650;
  assign less_650 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_651;
  assign less_651 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_652;
  assign less_652 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_653;
  assign less_653 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_654;
  assign less_654 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_655;
  assign less_655 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_656;
  assign less_656 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_657;
  assign less_657 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_658;
  assign less_658 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:456
  logic equal_659;
  assign equal_659 = column_s2_q == 6'h0;
  logic [3:0] select_663;
  assign select_663 = equal_662_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:457
  logic [4:0] select_664;
  assign select_664 = equal_659 ? {select_663, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_665;
  assign select_665 = equal_659 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_666;
  assign and_666 = select_664[4] & select_665[3];
  // hls/stages/census.hpp:288
  logic and_668;
  assign and_668 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_670;
  assign and_670 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_668);
  // hls/stages/agreement.hpp:457
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_670;
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
  logic [9:0] difference_693;
  assign difference_693 = {1'b0, select_539} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_694;
  assign xor_694 = difference_693[8:0] ^ {9{difference_693[9]}};
  logic [9:0] sum_695;
  assign sum_695 = {9'h0, difference_693[9]} + {1'b0, xor_694};
  logic [9:0] difference_696;
  assign difference_696 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_697;
  assign xor_697 = difference_696[8:0] ^ {9{difference_696[9]}};
  logic [9:0] sum_698;
  assign sum_698 = {9'h0, difference_696[9]} + {1'b0, xor_697};
  logic [9:0] difference_700;
  assign difference_700 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_701;
  assign xor_701 = difference_700[8:0] ^ {9{difference_700[9]}};
  logic [9:0] sum_702;
  assign sum_702 = {9'h0, difference_700[9]} + {1'b0, xor_701};
  logic [10:0] sum_703;
  assign sum_703 = ({1'b0, sum_695} + {1'b0, sum_698}) + {1'b0, sum_702};
  logic [9:0] difference_704;
  assign difference_704 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_705;
  assign xor_705 = difference_704[8:0] ^ {9{difference_704[9]}};
  logic [9:0] sum_706;
  assign sum_706 = {9'h0, difference_704[9]} + {1'b0, xor_705};
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_709;
  assign xor_709 = difference_708[8:0] ^ {9{difference_708[9]}};
  // hls/stages/agreement.hpp:457
  logic and_717;
  assign and_717 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_718;
  assign and_718 = and_666 & and_717;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_720;
  assign sum_720 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_722;
  assign and_722 = and_718 & ({{5{sum_720[6]}}, sum_720, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_726;
  assign sum_726 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:808
  logic or_742;
  assign or_742 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:809
  logic select_744;
  assign select_744 = or_742 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:779
  logic [5:0] select_991;
  assign select_991 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_992;
  assign difference_992 = {1'b0, column_2_s2_q} - {1'b0, select_991};
  logic [7:0] sum_994;
  assign sum_994 = {difference_992[6], difference_992} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:756
  logic [7:0] select_995;
  assign select_995 = slot_s2_q[0] ? chosen_score_q : sum_994;
  // hls/stages/agreement.hpp:779
  logic [6:0] difference_1241;
  assign difference_1241 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1240_s2_q};
  // hls/stages/agreement.hpp:750
  logic equal_1242;
  assign equal_1242 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:779
  logic [7:0] sum_1244;
  assign sum_1244 = {difference_1241[6], difference_1241} + (equal_1242 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1490;
  assign difference_1490 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1489_s2_q};
  logic [7:0] sum_1492;
  assign sum_1492 = {difference_1490[6], difference_1490} + (equal_1242 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:752
  logic less_1493;
  assign less_1493 = sum_1244 < sum_1492;
  logic [7:0] select_1494;
  assign select_1494 = less_1493 ? sum_1492 : sum_1244;
  logic less_1495;
  assign less_1495 = select_995 < select_1494;
  // hls/stages/agreement.hpp:802
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1495 ? select_1494 : select_995) : 8'h0;
  // hls/stages/agreement.hpp:809
  logic or_1499;
  assign or_1499 = select_744 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:814
  logic [5:0] select_1500;
  assign select_1500 = or_1499 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:721
  logic not_1501;
  assign not_1501 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:753
  logic [1:0] select_1502;
  assign select_1502 = less_1493 ? {slot_s2_q[0], not_1501} : 2'h0;
  logic [2:0] select_1504;
  assign select_1504 = less_1495 ? {select_1502, not_1501} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:814
  logic [2:0] select_1505;
  assign select_1505 = or_1499 ? select_1504 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1506;
  assign select_1506 = or_1499 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:811
  logic equal_1507;
  assign equal_1507 = select_1504 == 3'h1;
  logic or_1510;
  assign or_1510 = equal_1507 | (~(select_1504 == 3'h2));
  logic [7:0] select_1512;
  assign select_1512 = or_1510 ? before_0_q : before_1_q;
  logic [7:0] select_1513;
  assign select_1513 = equal_1507 ? (or_1510 ? sum_1244 : {7'h0, shift_not_right_q}) : select_1512;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1514;
  assign select_1514 = or_1499 ? select_1513 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1517;
  assign select_1517 = or_1499 ? (equal_1507 ? select_1512 : (or_1510 ? sum_1492 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1519;
  assign sum_1519 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1520;
  assign sum_1520 = {1'b0, before_v} + sum_1519;
  // hls/stages/agreement.hpp:756
  logic [6:0] select_1521;
  assign select_1521 = slot_s2_q[0] ? chosen_near_q : sum_1520;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1523;
  assign sum_1523 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1524;
  assign sum_1524 = {1'b0, before_v_2} + sum_1523;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1526;
  assign sum_1526 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1527;
  assign sum_1527 = {1'b0, before_v_3} + sum_1526;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1529;
  assign select_1529 = (sum_1524 < sum_1527) ? sum_1527 : sum_1524;
  // hls/stages/agreement.hpp:803
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1521 < select_1529) ? select_1529 : select_1521) : 7'h0;
  // hls/stages/agreement.hpp:814
  logic less_1533;
  assign less_1533 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1535;
  assign select_1535 = select_744 ? of_near : (less_1533 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1537;
  assign select_1537 = select_744 ? run_shift_s2_q : (less_1533 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1540;
  assign select_1540 = (run_shift_s2_q == 6'h3f) ? of_best : (select_744 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:819
  logic [7:0] select_1543;
  assign select_1543 = (run_shift_s2_q == 6'h1) ? of_best : (select_744 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:824
  logic select_1546;
  assign select_1546 = or_742 ? shift_first_s2_q : equal_1545_s2_q;
  // hls/stages/agreement.hpp:825
  logic or_1548;
  assign or_1548 = select_1546 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_1549;
  assign select_1549 = or_1548 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1550;
  assign select_1550 = or_1548 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1552;
  assign or_1552 = select_1546 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:833
  logic [6:0] select_1553;
  assign select_1553 = or_1552 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1554;
  assign select_1554 = or_1552 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1568;
  assign and_1568 = or_562_s2_q & (not_566_s2_q & (and_617 & or_1565_s2_q));
  // hls/stages/agreement.hpp:789
  logic and_1569;
  assign and_1569 = not_560_s2_q & and_1568;
  logic and_1572;
  assign and_1572 = not_558_s2_q & (so_s2_q ? and_1555_s2_q : (equal_561_s2_q & and_619));
  // hls/stages/moments.hpp:60
  logic and_1576;
  assign and_1576 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1004
  logic and_1577;
  assign and_1577 = not_570_s2_q & and_1576;
  logic and_1579;
  assign and_1579 = and_1576 & (moments_memory_rdata_q[1] ^ and_622_s2_q);
  logic and_1580;
  assign and_1580 = not_570_s2_q & and_1579;
  // hls/stages/agreement.hpp:789
  logic and_1583;
  assign and_1583 = not_558_s2_q & (not_560_s2_q & (equal_561_s2_q & inside_v_s2_q));
  // hls/stages/moments.hpp:60
  logic and_1585;
  assign and_1585 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1004
  logic and_1586;
  assign and_1586 = not_570_s2_q & and_1585;
  // hls/stages/moments.hpp:61
  logic and_1588;
  assign and_1588 = and_1585 & (moments_memory_rdata_q[3] ^ and_629_s2_q);
  // hls/stages/agreement.hpp:1004
  logic and_1589;
  assign and_1589 = not_570_s2_q & and_1588;
  // hls/stages/agreement.hpp:1129
  logic equal_1590;
  assign equal_1590 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1179
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1130
  logic [1:0] select_1593;
  assign select_1593 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1143
  logic [3:0] select_1595;
  assign select_1595 = equal_1590 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1593});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1596;
  assign sum_1596 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_1597;
  assign select_1597 = equal_557_s2_q ? select_1595 : {sum_1596, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1598;
  assign equal_1598 = x_s2_q[5:0] == 6'h3f;
  logic equal_1600;
  assign equal_1600 = x_s2_q[5:0] == 6'h3e;
  logic equal_1602;
  assign equal_1602 = x_s2_q[5:0] == 6'h3d;
  logic equal_1604;
  assign equal_1604 = x_s2_q[5:0] == 6'h3c;
  logic equal_1606;
  assign equal_1606 = x_s2_q[5:0] == 6'h3b;
  logic equal_1608;
  assign equal_1608 = x_s2_q[5:0] == 6'h36;
  logic equal_1610;
  assign equal_1610 = x_s2_q[5:0] == 6'h35;
  logic equal_1612;
  assign equal_1612 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1179
  logic and_1616;
  assign and_1616 = (~equal_1606) & ((~equal_1608) & ((~equal_1610) & (~equal_1612)));
  logic and_1620;
  assign and_1620 = (~equal_1598) & ((~equal_1600) & ((~equal_1602) & ((~equal_1604) & and_1616)));
  // hls/stages/agreement.hpp:1130
  logic less_1621;
  assign less_1621 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1625;
  assign or_1625 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1010
  logic [4:0] sum_1630;
  assign sum_1630 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1630, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1636;
  assign sum_1636 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1638;
  assign and_1638 = half_ends & ({{3{sum_1636[4]}}, sum_1636} < 8'h3);
  // hls/stages/agreement.hpp:789
  logic and_1639;
  assign and_1639 = so_s2_q & and_1638;
  logic select_1640;
  assign select_1640 = equal_557_s2_q ? (x_s2_q[6] & (equal_1590 ? and_1620 : (less_1621 & (~or_1625)))) : and_1639;
  // hls/stages/registration.hpp:258
  logic not_1642;
  assign not_1642 = ~lower_half_s2_q;
  logic [3:0] select_1643;
  assign select_1643 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1642, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1642};
  // hls/stages/patches.hpp:373
  logic [1:0] select_1672;
  assign select_1672 = and_1671_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1673;
  assign select_1673 = and_1671_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1674;
  assign select_1674 = and_1658_s2_q ? {select_1673, select_1672[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1675;
  assign select_1675 = and_1658_s2_q ? select_1672 : patches_fetch_q;
  logic equal_1676;
  assign equal_1676 = select_1675 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:789
  logic and_1684;
  assign and_1684 = not_558_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1686;
  assign equal_1686 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_562_s2_q ? (less_565_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1686 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1694;
  assign select_1694 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1695;
  assign select_1695 = b[1] ? a : 8'h0;
  logic [8:0] sum_1696;
  assign sum_1696 = {{2{select_1694[6]}}, select_1694} + {select_1695[7], select_1695};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1697;
  assign select_1697 = b[2] ? a : 8'h0;
  logic [7:0] select_1698;
  assign select_1698 = b[3] ? a : 8'h0;
  logic [8:0] sum_1699;
  assign sum_1699 = {{2{select_1697[7]}}, select_1697[7:1]} + {select_1698[7], select_1698};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1700;
  assign sum_1700 = {{3{sum_1696[8]}}, sum_1696[8:1]} + {sum_1699[8], sum_1699, select_1697[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1701;
  assign select_1701 = b[4] ? a : 8'h0;
  logic [7:0] select_1702;
  assign select_1702 = b[5] ? a : 8'h0;
  logic [8:0] difference_1703;
  assign difference_1703 = {{2{select_1701[7]}}, select_1701[7:1]} - {select_1702[7], select_1702};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1704;
  assign sum_1704 = {difference_1703, select_1701[0]} + {sum_1700[10], sum_1700[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1686 ? {sum_1704, sum_1700[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1706;
  assign sum_1706 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1709;
  assign and_1709 = less_1685_s2_q & (and_619 & ({{4{sum_1706[9]}}, sum_1706, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1713;
  assign and_1713 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1719;
  assign sum_1719 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1721;
  assign sum_1721 = {sum_1719[9], sum_1719[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1019
  logic and_1724;
  assign and_1724 = ($signed(9'h0) < $signed(sum_1719[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1721, sum_1719[0]})));
  logic and_1725;
  assign and_1725 = (~(and_1713 | (equal_553_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1724;
  // hls/stages/agreement.hpp:789
  logic and_1729;
  assign and_1729 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1709 & and_1725)));
  logic and_1730;
  assign and_1730 = not_558_s2_q & and_1729;
  // hls/stages/patches.hpp:156
  logic and_1732;
  assign and_1732 = and_1730 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1733;
  assign select_1733 = and_1732 ? and_1730 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:789
  logic [6:0] select_1736;
  assign select_1736 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  // hls/stages/patches.hpp:344
  logic [6:0] select_1738;
  assign select_1738 = and_1732 ? (equal_557_s2_q ? 7'h0 : select_1736) : patches_choice_column_q;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1741;
  assign select_1741 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_1743;
  assign select_1743 = and_1732 ? (equal_557_s2_q ? 6'h0 : select_1741) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1744;
  assign sum_1744 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1704[9]}}, sum_1704[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1747;
  assign select_1747 = ($signed(sum_1744[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1744[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1686 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1744[12:7])) ? 8'h7f : select_1747);
  // hls/stages/agreement.hpp:789
  logic [7:0] select_1752;
  assign select_1752 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_1754;
  assign select_1754 = and_1732 ? (equal_557_s2_q ? 8'h0 : select_1752) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1755;
  assign equal_1755 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:789
  logic and_1759;
  assign and_1759 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1713 | equal_1755)));
  logic and_1760;
  assign and_1760 = not_558_s2_q & and_1759;
  // hls/stages/patches.hpp:344
  logic and_1761;
  assign and_1761 = patches_chooses_s2_q & and_1760;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1775;
  assign select_1775 = and_1658_s2_q ? select_1673 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1776;
  assign equal_1776 = {patches_choosing_band_s2_q, and_1684} == {select_1775, select_1675[1]};
  // hls/stages/patches.hpp:482
  logic [2:0] sum_1876;
  assign sum_1876 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:486
  logic [1:0] sum_1914;
  assign sum_1914 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1950;
  assign select_1950 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1051
  logic or_1953;
  assign or_1953 = select_1950[7] | (~({select_1950[5], select_1950[3], select_1950[1]} == 3'h0));
  // hls/stages/agreement.hpp:1050
  logic or_1956;
  assign or_1956 = select_1950[7] | (~({select_1950[6], select_1950[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1959;
  assign or_1959 = select_1950[7] | (~(select_1950[6:4] == 3'h0));
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1960;
  assign select_1960 = equal_557_s2_q ? x_s2_q[5:0] : {region_row_q, or_1959, or_1956, or_1953};
  // hls/stages/agreement.hpp:1129
  logic not_1961;
  assign not_1961 = ~equal_1590;
  // hls/stages/agreement.hpp:1059
  logic or_1965;
  assign or_1965 = (~sum_1963_s2_q) | equal_1755;
  // hls/stages/agreement.hpp:789
  logic and_1968;
  assign and_1968 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1965));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_562_s2_q & (not_566_s2_q & and_591_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_619;
  // hls/stages/agreement.hpp:149
  logic and_1986;
  assign and_1986 = or_562_s2_q & (not_566_s2_q & and_1984_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_1995;
  assign and_1995 = inside_v_s2_q & and_1986;
  // hls/stages/agreement.hpp:1015
  logic select_1996;
  assign select_1996 = slot_s2_q[2] ? shown_shown_q : and_619;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_1996);
  // hls/stages/agreement.hpp:1015
  logic select_1999;
  assign select_1999 = slot_s2_q[2] ? shown_nearer_q : and_1568;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_1996 ? select_1999 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1272
  logic select_2002;
  assign select_2002 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1276
  logic select_2003;
  assign select_2003 = left_first_s2_q ? select_2002 : read_half_q;
  logic or_2004;
  assign or_2004 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [8:0] select_2005;
  assign select_2005 = or_2004 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1278
  logic [9:0] select_2007;
  assign select_2007 = left_first_s2_q ? 10'h1 : (or_2004 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1281
  logic and_2008;
  assign and_2008 = select_2005[8] & select_2007[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2008 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1292
  logic [5:0] select_2011;
  assign select_2011 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2013;
  assign select_2013 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2011});
  // hls/stages/agreement.hpp:1302
  logic equal_2014;
  assign equal_2014 = seen_x_q == 3'h7;
  logic [7:0] select_2016;
  assign select_2016 = and_2008 ? 8'h0 : (seen_column_q + {7'h0, equal_2014});
  // hls/stages/agreement.hpp:1309
  logic [10:0] index;
  assign index = select_2013 + {3'h0, select_2016};
  // hls/stages/agreement.hpp:1262
  logic [11:0] sum_2018;
  assign sum_2018 = {1'b0, {2{select_2003}}, 2'h0, {2{select_2003}}, 1'b0, {2{select_2003}}, 1'b0, select_2003} + {1'b0, index};
  // hls/stages/agreement.hpp:1275
  logic not_2019;
  assign not_2019 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2021;
  assign and_2021 = not_2019 & (began_q | and_2008);
  // hls/stages/agreement.hpp:1303
  logic [2:0] select_2023;
  assign select_2023 = and_2008 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1308
  logic and_2025;
  assign and_2025 = and_2021 & (select_2023 == 3'h0);
  logic less_2026;
  assign less_2026 = select_2016 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2027;
  assign and_2027 = and_2025 & less_2026;
  logic and_2028;
  assign and_2028 = and_1942_s2_q & and_2027;
  // hls/stages/agreement.hpp:278
  logic select_2030;
  assign select_2030 = and_1942_s2_q ? (left_first_s2_q ? and_2027 : and_2028) : and_2028;
  // hls/stages/agreement.hpp:1112
  logic [7:0] sum_2032;
  assign sum_2032 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2032[7], sum_2032, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1262
  logic [11:0] sum_2034;
  assign sum_2034 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1031
  logic and_2035;
  assign and_2035 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2036;
  assign and_2036 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2037;
  assign and_2037 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2038;
  assign and_2038 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2040;
  assign sum_2040 = {1'b0, and_2037} + ({1'b0, textured} + {1'b0, and_2038});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2035} + ({2'h0, and_2036} + {1'b0, sum_2040});
  // hls/stages/agreement.hpp:1031
  logic [7:0] select_2049;
  assign select_2049 = inside_v_s2_q ? (sum_1963_s2_q ? select_1950 : {select_1950[6:0], 1'b0}) : select_1950;
  // hls/stages/agreement.hpp:1051
  logic or_2052;
  assign or_2052 = select_2049[7] | (~({select_2049[5], select_2049[3], select_2049[1]} == 3'h0));
  // hls/stages/agreement.hpp:1031
  logic and_2069;
  assign and_2069 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2070;
  assign and_2070 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2071;
  assign and_2071 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2072;
  assign and_2072 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2074;
  assign sum_2074 = {1'b0, and_2071} + ({1'b0, shown} + {1'b0, and_2072});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2069} + ({2'h0, and_2070} + {1'b0, sum_2074});
  // hls/stages/agreement.hpp:1031
  logic and_2085;
  assign and_2085 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2086;
  assign and_2086 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2087;
  assign and_2087 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2088;
  assign and_2088 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1091
  logic [1:0] sum_2090;
  assign sum_2090 = {1'b0, and_2087} + ({1'b0, near} + {1'b0, and_2088});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2085} + ({2'h0, and_2086} + {1'b0, sum_2090});
  // hls/stages/agreement.hpp:789
  logic and_2106;
  assign and_2106 = ends_cell_s2_q & (and_2102_s2_q & (~({1'b0, sum_1630, last_s2_q[1:0]} < x_s2_q)));
  logic and_2108;
  assign and_2108 = not_558_s2_q & (so_s2_q & and_2106);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2140;
  assign select_2140 = sample_pair_whole_s2_q ? (and_531_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2142;
  assign select_2142 = sample_pair_whole_s2_q ? (and_531_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2161;
  assign select_2161 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2163;
  assign select_2163 = sample_pair_whole_s2_q ? (and_531_s2_q ? select_546 : averager_mask_q) : averager_mask_q;
  logic select_2165;
  assign select_2165 = sample_pair_whole_s2_q ? (and_531_s2_q ? select_550 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:521
  logic [8:0] select_2166;
  assign select_2166 = and_533_s2_q ? select_539 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2167;
  assign select_2167 = and_533_s2_q ? select_543 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2169;
  assign select_2169 = and_533_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2170;
  assign select_2170 = and_533_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2171;
  assign select_2171 = and_533_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2172;
  assign select_2172 = and_533_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2173;
  assign select_2173 = and_533_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2174;
  assign select_2174 = and_533_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2175;
  assign select_2175 = and_533_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2176;
  assign select_2176 = and_533_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2177;
  assign select_2177 = and_533_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2178;
  assign select_2178 = and_533_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2179;
  assign select_2179 = and_533_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2180;
  assign select_2180 = and_533_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2181;
  assign select_2181 = and_533_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2182;
  assign select_2182 = and_533_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2183;
  assign select_2183 = and_533_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2184;
  assign select_2184 = and_533_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2185;
  assign select_2185 = and_533_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2186;
  assign select_2186 = and_533_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2187;
  assign select_2187 = and_533_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2188;
  assign select_2188 = and_533_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2189;
  assign select_2189 = and_533_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2190;
  assign select_2190 = and_533_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2191;
  assign select_2191 = and_533_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2192;
  assign select_2192 = and_533_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2193;
  assign select_2193 = and_533_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2194;
  assign select_2194 = and_533_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2195;
  assign select_2195 = and_533_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2196;
  assign select_2196 = and_533_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2197;
  assign select_2197 = and_533_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2198;
  assign select_2198 = and_533_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_533_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2200;
  assign select_2200 = and_533_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2201;
  assign select_2201 = and_533_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_533_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2203;
  assign select_2203 = and_533_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2204;
  assign select_2204 = and_533_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_533_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2206;
  assign select_2206 = and_533_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2207;
  assign select_2207 = and_533_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2208;
  assign select_2208 = and_533_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2209;
  assign select_2209 = and_533_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2210;
  assign select_2210 = and_533_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2211;
  assign select_2211 = and_533_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2212;
  assign select_2212 = and_533_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2213;
  assign select_2213 = and_533_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_533_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_533_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2216;
  assign select_2216 = and_533_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2217;
  assign select_2217 = and_533_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2218;
  assign select_2218 = and_533_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_533_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2220;
  assign select_2220 = and_533_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2221;
  assign select_2221 = and_533_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2223;
  assign difference_2223 = {1'b0, select_543} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2224;
  assign xor_2224 = difference_2223[8:0] ^ {9{difference_2223[9]}};
  logic [9:0] sum_2225;
  assign sum_2225 = {9'h0, difference_2223[9]} + {1'b0, xor_2224};
  logic [9:0] difference_2226;
  assign difference_2226 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2227;
  assign xor_2227 = difference_2226[8:0] ^ {9{difference_2226[9]}};
  logic [9:0] sum_2228;
  assign sum_2228 = {9'h0, difference_2226[9]} + {1'b0, xor_2227};
  logic [9:0] difference_2230;
  assign difference_2230 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2231;
  assign xor_2231 = difference_2230[8:0] ^ {9{difference_2230[9]}};
  logic [9:0] sum_2232;
  assign sum_2232 = {9'h0, difference_2230[9]} + {1'b0, xor_2231};
  logic [10:0] sum_2233;
  assign sum_2233 = ({1'b0, sum_2225} + {1'b0, sum_2228}) + {1'b0, sum_2232};
  logic [9:0] difference_2234;
  assign difference_2234 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2235;
  assign xor_2235 = difference_2234[8:0] ^ {9{difference_2234[9]}};
  logic [9:0] sum_2236;
  assign sum_2236 = {9'h0, difference_2234[9]} + {1'b0, xor_2235};
  logic [9:0] difference_2238;
  assign difference_2238 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2239;
  assign xor_2239 = difference_2238[8:0] ^ {9{difference_2238[9]}};
  // hls/stages/agreement.hpp:1004
  logic [13:0] select_2265;
  assign select_2265 = less_569_s2_q ? moments_turned_0_q : ({13'h0, and_1579} + (and_554_s2_q ? 14'h0 : moments_turned_0_q));
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2267;
  assign select_2267 = equal_561_s2_q ? (inside_v_s2_q ? select_2265 : moments_turned_0_q) : moments_turned_0_q;
  logic [13:0] select_2269;
  assign select_2269 = equal_557_s2_q ? moments_turned_0_q : (so_s2_q ? moments_turned_0_q : select_2267);
  // hls/stages/agreement.hpp:1004
  logic [13:0] select_2272;
  assign select_2272 = less_569_s2_q ? moments_turned_1_q : ({13'h0, and_1588} + (and_554_s2_q ? 14'h0 : moments_turned_1_q));
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2274;
  assign select_2274 = equal_561_s2_q ? (inside_v_s2_q ? select_2272 : moments_turned_1_q) : moments_turned_1_q;
  logic [13:0] select_2276;
  assign select_2276 = equal_557_s2_q ? moments_turned_1_q : (so_s2_q ? moments_turned_1_q : select_2274);
  // hls/stages/agreement.hpp:1149
  logic equal_2277;
  assign equal_2277 = x_s2_q[6:0] == 7'h7f;
  logic equal_2278;
  assign equal_2278 = x_s2_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:789
  logic [13:0] select_2280;
  assign select_2280 = equal_2277 ? moments_before_0_q : (equal_2278 ? moments_turned_0_q : moments_before_0_q);
  logic [13:0] select_2283;
  assign select_2283 = equal_2277 ? moments_before_1_q : (equal_2278 ? moments_turned_1_q : moments_before_1_q);
  logic select_2286;
  assign select_2286 = equal_2277 ? moments_has_before_q : (moments_has_before_q | equal_2278);
  // hls/stages/moments.hpp:74
  logic [13:0] select_2289;
  assign select_2289 = (moments_before_1_q < moments_before_0_q) ? moments_before_0_q : moments_before_1_q;
  // hls/stages/moments.hpp:104
  logic [14:0] sum_2291;
  assign sum_2291 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2293;
  assign sum_2293 = {1'b0, moments_turned_0_q} + 15'h3;
  logic less_2294;
  assign less_2294 = {3'h0, counts_turned_right_q[13:2]} < sum_2293;
  logic [14:0] sum_2296;
  assign sum_2296 = {1'b0, moments_most_before_q} + 15'h3;
  logic not_2298;
  assign not_2298 = ~({3'h0, counts_turned_right_q[13:2]} < sum_2296);
  // hls/stages/moments.hpp:79
  logic or_2301;
  assign or_2301 = not_2298 | (~({3'h0, moments_before_0_q[13:2]} < sum_2293));
  // hls/stages/moments.hpp:104
  logic not_2304;
  assign not_2304 = ~({3'h0, counts_turned_left_q[13:2]} < sum_2296);
  // hls/stages/moments.hpp:79
  logic or_2307;
  assign or_2307 = not_2304 | (~({3'h0, moments_before_1_q[13:2]} < sum_2291));
  // hls/stages/moments.hpp:80
  logic select_2310;
  assign select_2310 = ({3'h0, counts_turned_left_q[13:2]} < sum_2291) ? ((~less_2294) & or_2301) : ((less_2294 | or_2307) ? or_2307 : or_2301);
  // hls/stages/moments.hpp:82
  logic select_2315;
  assign select_2315 = cfg_same_table_i ? (select_2310 | (moments_out_of_step_q & (~(not_2304 & not_2298)))) : moments_out_of_step_q;
  // hls/stages/agreement.hpp:789
  logic select_2318;
  assign select_2318 = equal_2277 ? moments_out_of_step_q : (equal_2278 ? (cfg_prove_i & select_2315) : moments_out_of_step_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2330;
  assign difference_2330 = {1'b0, select_539} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2330[9]} + (difference_2330[8:0] ^ {9{difference_2330[9]}});
  logic [9:0] difference_2342;
  assign difference_2342 = {1'b0, select_543} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2342[9]} + (difference_2342[8:0] ^ {9{difference_2342[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2533;
  assign select_2533 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2534;
  assign select_2534 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2535;
  assign select_2535 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2536;
  assign select_2536 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2537;
  assign select_2537 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2538;
  assign select_2538 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2542;
  assign select_2542 = slot_s2_q[0] ? 8'h0 : sum_994;
  // hls/stages/agreement.hpp:752
  logic less_2543;
  assign less_2543 = select_2542 < select_1494;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2545;
  assign select_2545 = slot_s2_q[0] ? 7'h0 : sum_1520;
  // hls/stages/agreement.hpp:789
  logic not_2550;
  assign not_2550 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2551;
  assign less_2551 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:521
  logic and_2558;
  assign and_2558 = and_533_s2_q & (equal_662_s2_q & equal_2433_s2_q);
  // hls/stages/agreement.hpp:789
  logic and_2564;
  assign and_2564 = not_558_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2560_s2_q)));
  // hls/stages/agreement.hpp:1031
  logic and_2584;
  assign and_2584 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2585;
  assign and_2585 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2586;
  assign and_2586 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2587;
  assign and_2587 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2589;
  assign sum_2589 = {1'b0, and_2586} + ({1'b0, explained} + {1'b0, and_2587});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2584} + ({2'h0, and_2585} + {1'b0, sum_2589});
  // hls/stages/agreement.hpp:789
  logic and_2625;
  assign and_2625 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2560_s2_q & and_1986)));
  // hls/stages/agreement.hpp:987
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:988
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:989
  logic [7:0] difference_2649;
  assign difference_2649 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2652;
  assign less_2652 = {2'h0, difference_2649[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2655;
  assign and_2655 = not_566_s2_q & (((and_1984_s2_q & and_617) & equal_2645_s2_q) & (~less_2652));
  // hls/stages/agreement.hpp:789
  logic and_2659;
  assign and_2659 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_562_s2_q & and_2655)));
  // hls/stages/agreement.hpp:149
  logic and_2664;
  assign and_2664 = not_566_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2666;
  assign and_2666 = not_566_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2667;
  assign select_2667 = or_562_s2_q ? {and_2666, and_2664} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2669;
  assign select_2669 = less_565_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2670;
  assign select_2670 = or_562_s2_q ? select_2669 : 2'h0;
  // hls/stages/agreement.hpp:1028
  logic and_2672;
  assign and_2672 = and_619 & (select_2667[0] & select_2670[0]);
  // hls/stages/agreement.hpp:789
  logic and_2676;
  assign and_2676 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2667[1] & and_2672)));
  logic and_2677;
  assign and_2677 = not_558_s2_q & and_2676;
  logic and_2683;
  assign and_2683 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2670[1] & and_2672)));
  logic and_2684;
  assign and_2684 = not_558_s2_q & and_2683;
  // hls/stages/registration.hpp:76
  logic less_2687;
  assign less_2687 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2689;
  assign select_2689 = or_562_s2_q ? (less_565_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2691;
  assign select_2691 = or_562_s2_q ? (less_565_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2693;
  assign select_2693 = or_562_s2_q ? (less_565_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2691} - {1'b0, select_2693};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2695;
  assign select_2695 = rise_2[8] ? select_2691 : select_2693;
  logic [8:0] fall;
  assign fall = {1'b0, select_2689} - {1'b0, select_2695};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2698;
  assign not_2698 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2687 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2698};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2700;
  assign xor_2700 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2700};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2706;
  assign select_2706 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2687 ? {taken, 1'b1} : {not_2698, select_2706, not_2698};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2708;
  assign sum_2708 = {left, 1'b1} + {taken_2, less_2687};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2710;
  assign select_2710 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2712;
  assign select_2712 = equal_557_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2714;
  assign select_2714 = equal_557_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2715;
  assign equal_2715 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2719;
  assign and_2719 = and_619 & less_1685_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2721;
  assign select_2721 = or_562_s2_q ? (less_565_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2725;
  assign sum_2725 = select_2721[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2728;
  assign select_2728 = (select_2691 < select_2693) ? ({sum_2725, select_2721[0], 5'h0} - {3'h0, select_2710}) : {sum_2725, select_2721[0], select_2710};
  logic [7:0] select_2729;
  assign select_2729 = ((select_2721 == 3'h0) | (select_2721 == 3'h4)) ? {sum_2725, select_2721[0], 5'h0} : select_2728;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2729[7]}}, select_2729} - {sum_1704[9], sum_1704, sum_1700[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2732;
  assign select_2732 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2732[11:7])) ? 12'h7f : select_2732;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2753;
  assign difference_2753 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2755;
  assign and_2755 = and_2719 & ($signed(difference_2753) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2768;
  assign less_2768 = $signed(difference_2753) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:789
  logic select_2776;
  assign select_2776 = so_s2_q ? (equal_2715 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2779;
  assign select_2779 = so_s2_q ? (equal_1686 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2784;
  assign select_2784 = (sum_1596 == 2'h2) ? (registration_fresh_q & (~select_1643)) : registration_fresh_q;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_2786;
  assign select_2786 = so_s2_q ? (and_1638 ? select_2784 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2788;
  assign select_2788 = and_2558 ? 4'hf : (equal_557_s2_q ? registration_fresh_q : select_2786);
  // hls/stages/agreement.hpp:1130
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1593;
  // hls/stages/registration.hpp:258
  logic not_2809;
  assign not_2809 = ~quarter_2[1];
  logic [3:0] select_2810;
  assign select_2810 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2809, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2809};
  // hls/stages/patches.hpp:91
  logic parity_2944;
  assign parity_2944 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:461
  logic [15:0] select_2945;
  assign select_2945 = equal_2433_s2_q ? {patches_chance_q[14:0], parity_2944} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_2947;
  assign not_2947 = ~and_1760;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2949;
  assign select_2949 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2949};
  // hls/stages/agreement.hpp:789
  logic and_2955;
  assign and_2955 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2959;
  assign and_2959 = not_2947 & (patches_fixed_q | ((not_558_s2_q & and_2955) & and_1732));
  // hls/stages/patches.hpp:354
  logic not_2972;
  assign not_2972 = ~select_1675[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_2974;
  assign select_2974 = sample_pair_whole_s2_q ? (equal_1676 ? select_1675 : {not_2972, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:518
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3073;
  assign select_3073 = or_1768_s2_q ? {less_1896_s2_q, less_1895_s2_q, less_1886_s2_q, less_1885_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3075;
  assign select_3075 = equal_1762_s2_q ? patches_codes_at_q : (equal_1764_s2_q ? other[55:4] : select_3073);
  // hls/stages/patches.hpp:501
  logic [27:0] word;
  assign word = or_1868_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [27:0] select_3078;
  assign select_3078 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3080;
  assign select_3080 = equal_1764_s2_q ? (new_row_s2_q ? word : select_3078) : patches_codes_further_q;
  // hls/stages/patches.hpp:519
  logic [55:0] select_3082;
  assign select_3082 = less_1855_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:489
  logic [55:0] select_3084;
  assign select_3084 = less_3083_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3086;
  assign select_3086 = or_1768_s2_q ? (equal_1767_s2_q ? patches_next_codes_q : select_3084) : patches_next_codes_q;
  logic [55:0] select_3088;
  assign select_3088 = equal_1762_s2_q ? patches_next_codes_q : (equal_1764_s2_q ? select_3082 : select_3086);
  // hls/stages/count_bits.hpp:24
  logic parity_3093;
  assign parity_3093 = ^{less_1896_s2_q, less_1895_s2_q, less_1886_s2_q, less_1885_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3097;
  assign or_3097 = ({less_1886_s2_q, less_1885_s2_q} == 2'h3) | (less_1895_s2_q & (less_1886_s2_q | less_1885_s2_q));
  logic and_3098;
  assign and_3098 = less_1896_s2_q & (^{less_1895_s2_q, less_1886_s2_q, less_1885_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3099;
  assign xor_3099 = or_3097 ^ and_3098;
  // hls/stages/count_bits.hpp:27
  logic and_3100;
  assign and_3100 = or_3097 & and_3098;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3102;
  assign select_3102 = or_1768_s2_q ? (and_1919_s2_q ? {and_3100, xor_3099, parity_3093} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3106;
  assign sum_3106 = {7'h0, patches_set_q} + (equal_1767_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:518
  logic [47:0] select_3116;
  assign select_3116 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3118;
  assign select_3118 = equal_1762_s2_q ? patches_left_row_q : (equal_1764_s2_q ? select_3116 : patches_left_row_q);
  // hls/stages/patches.hpp:520
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3116;
  // hls/stages/count_bits.hpp:24
  logic xor_3122;
  assign xor_3122 = bits[17] ^ (^{select_3116[16:15], other[16:15]});
  logic xor_3125;
  assign xor_3125 = bits[11] ^ (^{select_3116[10:9], other[10:9]});
  logic xor_3128;
  assign xor_3128 = bits[14] ^ (^{select_3116[13:12], other[13:12]});
  logic xor_3131;
  assign xor_3131 = xor_3122 ^ (^{select_3116[14:9], other[14:9]});
  logic xor_3134;
  assign xor_3134 = bits[47] ^ (^{select_3116[46:45], other[46:45]});
  logic xor_3137;
  assign xor_3137 = bits[8] ^ (^{select_3116[7:6], other[7:6]});
  logic xor_3140;
  assign xor_3140 = bits[2] ^ (^{select_3116[1:0], other[1:0]});
  logic xor_3143;
  assign xor_3143 = bits[5] ^ (^{select_3116[4:3], other[4:3]});
  logic xor_3146;
  assign xor_3146 = xor_3137 ^ (^{select_3116[5:0], other[5:0]});
  logic parity_3148;
  assign parity_3148 = ^{select_3116[47:45], select_3116[8:0], other[47:45], other[8:0]};
  logic xor_3149;
  assign xor_3149 = xor_3131 ^ parity_3148;
  logic xor_3152;
  assign xor_3152 = bits[44] ^ (^{select_3116[43:42], other[43:42]});
  logic xor_3155;
  assign xor_3155 = bits[38] ^ (^{select_3116[37:36], other[37:36]});
  logic xor_3158;
  assign xor_3158 = bits[41] ^ (^{select_3116[40:39], other[40:39]});
  logic xor_3164;
  assign xor_3164 = bits[26] ^ (^{select_3116[25:24], other[25:24]});
  logic xor_3167;
  assign xor_3167 = bits[20] ^ (^{select_3116[19:18], other[19:18]});
  logic xor_3170;
  assign xor_3170 = bits[23] ^ (^{select_3116[22:21], other[22:21]});
  logic xor_3173;
  assign xor_3173 = xor_3164 ^ (^{select_3116[23:18], other[23:18]});
  logic xor_3176;
  assign xor_3176 = bits[35] ^ (^{select_3116[34:33], other[34:33]});
  logic xor_3179;
  assign xor_3179 = bits[29] ^ (^{select_3116[28:27], other[28:27]});
  logic xor_3182;
  assign xor_3182 = bits[32] ^ (^{select_3116[31:30], other[31:30]});
  logic xor_3185;
  assign xor_3185 = xor_3176 ^ (^{select_3116[32:27], other[32:27]});
  logic xor_3186;
  assign xor_3186 = xor_3173 ^ xor_3185;
  // hls/stages/count_bits.hpp:25
  logic or_3194;
  assign or_3194 = (xor_3125 & xor_3128) | (xor_3122 & (xor_3125 | xor_3128));
  logic or_3198;
  assign or_3198 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3202;
  assign or_3202 = (xor_3140 & xor_3143) | (xor_3137 & (xor_3140 | xor_3143));
  // hls/stages/count_bits.hpp:23
  logic or_3209;
  assign or_3209 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3213;
  assign or_3213 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3217;
  assign or_3217 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3220;
  assign parity_3220 = ^{or_3217, or_3213, or_3209};
  // hls/stages/count_bits.hpp:23
  logic or_3224;
  assign or_3224 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3228;
  assign or_3228 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3232;
  assign or_3232 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3235;
  assign parity_3235 = ^{or_3232, or_3228, or_3224};
  logic parity_3238;
  assign parity_3238 = ^{or_3232, or_3228, or_3224, or_3217, or_3213, or_3209, or_3202, or_3198, or_3194};
  // hls/stages/count_bits.hpp:23
  logic or_3242;
  assign or_3242 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3246;
  assign or_3246 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3250;
  assign or_3250 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3258;
  assign or_3258 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3262;
  assign or_3262 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3266;
  assign or_3266 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3269;
  assign parity_3269 = ^{or_3266, or_3262, or_3258};
  // hls/stages/count_bits.hpp:23
  logic or_3273;
  assign or_3273 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3277;
  assign or_3277 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3281;
  assign or_3281 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3284;
  assign parity_3284 = ^{or_3281, or_3277, or_3273};
  logic parity_3287;
  assign parity_3287 = ^{or_3281, or_3277, or_3273, or_3266, or_3262, or_3258, or_3250, or_3246, or_3242};
  // hls/stages/count_bits.hpp:25
  logic or_3291;
  assign or_3291 = (xor_3155 & xor_3158) | (xor_3152 & (xor_3155 | xor_3158));
  logic or_3295;
  assign or_3295 = (xor_3167 & xor_3170) | (xor_3164 & (xor_3167 | xor_3170));
  logic or_3299;
  assign or_3299 = (xor_3179 & xor_3182) | (xor_3176 & (xor_3179 | xor_3182));
  // hls/stages/count_bits.hpp:24
  logic parity_3302;
  assign parity_3302 = ^{or_3299, or_3295, or_3291};
  // hls/stages/count_bits.hpp:25
  logic and_3303;
  assign and_3303 = xor_3149 & (^{xor_3186, select_3116[44:36], other[44:36]});
  logic or_3307;
  assign or_3307 = (xor_3134 & xor_3146) | (xor_3131 & (xor_3134 | xor_3146));
  logic and_3310;
  assign and_3310 = (xor_3152 ^ (^{select_3116[41:36], other[41:36]})) & (xor_3173 | xor_3185);
  logic or_3311;
  assign or_3311 = (xor_3173 & xor_3185) | and_3310;
  // hls/stages/count_bits.hpp:24
  logic parity_3314;
  assign parity_3314 = ^{or_3311, or_3307, and_3303};
  logic parity_3317;
  assign parity_3317 = ^{or_3311, or_3307, and_3303, or_3299, or_3295, or_3291, or_3281, or_3277, or_3273, or_3266, or_3262, or_3258, or_3250, or_3246, or_3242};
  logic parity_3319;
  assign parity_3319 = ^{or_3311, or_3307, and_3303, or_3299, or_3295, or_3291, or_3281, or_3277, or_3273, or_3266, or_3262, or_3258, or_3250, or_3246, or_3242, or_3232, or_3228, or_3224, or_3217, or_3213, or_3209, or_3202, or_3198, or_3194};
  // hls/stages/count_bits.hpp:25
  logic and_3320;
  assign and_3320 = parity_3238 & parity_3317;
  logic or_3324;
  assign or_3324 = (parity_3220 & parity_3235) | ((^{or_3202, or_3198, or_3194}) & (parity_3220 | parity_3235));
  logic or_3328;
  assign or_3328 = (parity_3302 & parity_3314) | (parity_3287 & (parity_3302 | parity_3314));
  logic or_3335;
  assign or_3335 = (parity_3269 & parity_3284) | ((^{or_3250, or_3246, or_3242}) & (parity_3269 | parity_3284));
  logic or_3339;
  assign or_3339 = (or_3295 & or_3299) | (or_3291 & (or_3295 | or_3299));
  logic or_3343;
  assign or_3343 = (or_3307 & or_3311) | (and_3303 & (or_3307 | or_3311));
  // hls/stages/count_bits.hpp:23
  logic or_3350;
  assign or_3350 = (or_3246 & or_3250) | (or_3242 & (or_3246 | or_3250));
  // hls/stages/count_bits.hpp:25
  logic or_3354;
  assign or_3354 = (or_3262 & or_3266) | (or_3258 & (or_3262 | or_3266));
  logic or_3358;
  assign or_3358 = (or_3277 & or_3281) | (or_3273 & (or_3277 | or_3281));
  // hls/stages/count_bits.hpp:24
  logic parity_3361;
  assign parity_3361 = ^{or_3358, or_3354, or_3350};
  // hls/stages/count_bits.hpp:23
  logic or_3365;
  assign or_3365 = (or_3198 & or_3202) | (or_3194 & (or_3198 | or_3202));
  // hls/stages/count_bits.hpp:25
  logic or_3369;
  assign or_3369 = (or_3213 & or_3217) | (or_3209 & (or_3213 | or_3217));
  logic or_3373;
  assign or_3373 = (or_3228 & or_3232) | (or_3224 & (or_3228 | or_3232));
  // hls/stages/count_bits.hpp:24
  logic parity_3376;
  assign parity_3376 = ^{or_3373, or_3369, or_3365};
  logic parity_3379;
  assign parity_3379 = ^{or_3373, or_3369, or_3365, or_3358, or_3354, or_3350, or_3343, or_3339, or_3335};
  logic parity_3381;
  assign parity_3381 = ^{or_3373, or_3369, or_3365, or_3358, or_3354, or_3350, or_3343, or_3339, or_3335, or_3328, or_3324, and_3320};
  // hls/stages/count_bits.hpp:25
  logic or_3385;
  assign or_3385 = (or_3339 & or_3343) | (or_3335 & (or_3339 | or_3343));
  logic or_3389;
  assign or_3389 = (or_3354 & or_3358) | (or_3350 & (or_3354 | or_3358));
  logic or_3393;
  assign or_3393 = (or_3369 & or_3373) | (or_3365 & (or_3369 | or_3373));
  // hls/stages/count_bits.hpp:24
  logic parity_3396;
  assign parity_3396 = ^{or_3393, or_3389, or_3385};
  // hls/stages/count_bits.hpp:25
  logic and_3397;
  assign and_3397 = (^{or_3328, or_3324, and_3320}) & parity_3379;
  logic or_3401;
  assign or_3401 = (or_3324 & or_3328) | (and_3320 & (or_3324 | or_3328));
  logic or_3405;
  assign or_3405 = (parity_3361 & parity_3376) | ((^{or_3343, or_3339, or_3335}) & (parity_3361 | parity_3376));
  // hls/stages/count_bits.hpp:24
  logic parity_3408;
  assign parity_3408 = ^{or_3405, or_3401, and_3397};
  // hls/stages/count_bits.hpp:25
  logic and_3410;
  assign and_3410 = parity_3396 & parity_3408;
  logic or_3414;
  assign or_3414 = (or_3389 & or_3393) | (or_3385 & (or_3389 | or_3393));
  logic or_3418;
  assign or_3418 = (or_3401 & or_3405) | (and_3397 & (or_3401 | or_3405));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3463;
  assign select_3463 = equal_1764_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3466;
  assign select_3466 = equal_1762_s2_q ? patches_summed_first_q : (equal_1764_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:552
  logic [9:0] select_3473;
  assign select_3473 = less_1925_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3476;
  assign select_3476 = equal_1928_s2_q ? (less_1925_s2_q ? (equal_1928_s2_q ? 10'h0 : select_3473) : 10'h0) : select_3473;
  logic [9:0] select_3478;
  assign select_3478 = less_1925_s2_q ? (equal_1926_s2_q ? 10'h0 : select_3476) : select_3476;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3480;
  assign select_3480 = less_1925_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3483;
  assign select_3483 = equal_1928_s2_q ? (less_1925_s2_q ? (equal_1928_s2_q ? 5'h0 : select_3480) : 5'h0) : select_3480;
  logic [4:0] select_3485;
  assign select_3485 = less_1925_s2_q ? (equal_1926_s2_q ? 5'h0 : select_3483) : select_3483;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3487;
  assign select_3487 = less_1925_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3490;
  assign select_3490 = equal_1928_s2_q ? (less_1925_s2_q ? (equal_1928_s2_q ? 5'h0 : select_3487) : 5'h0) : select_3487;
  logic [4:0] select_3492;
  assign select_3492 = less_1925_s2_q ? (equal_1926_s2_q ? 5'h0 : select_3490) : select_3490;
  // hls/stages/patches.hpp:552
  logic and_3495;
  assign and_3495 = less_1925_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:556
  logic select_3498;
  assign select_3498 = equal_1928_s2_q ? (less_1925_s2_q ? (not_1929_s2_q & and_3495) : and_3495) : and_3495;
  // hls/stages/patches.hpp:184
  logic select_3501;
  assign select_3501 = equal_1762_s2_q ? (less_1925_s2_q ? (not_1927_s2_q & select_3498) : select_3498) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3512;
  assign or_3512 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3513;
  assign and_3513 = patches_read_searches_s2_q & or_3512;
  // hls/stages/patches.hpp:536
  logic [4:0] select_3514;
  assign select_3514 = and_3513 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:543
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3514};
  // hls/stages/patches.hpp:552
  logic and_3518;
  assign and_3518 = less_1925_s2_q & (equal_3510_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:556
  logic select_3521;
  assign select_3521 = equal_1928_s2_q ? (less_1925_s2_q ? (not_1929_s2_q & and_3518) : and_3518) : and_3518;
  // hls/stages/patches.hpp:184
  logic select_3524;
  assign select_3524 = equal_1762_s2_q ? (less_1925_s2_q ? (not_1927_s2_q & select_3521) : select_3521) : patches_read_above_q;
  // hls/stages/patches.hpp:552
  logic and_3527;
  assign and_3527 = less_1925_s2_q & (equal_3510_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:556
  logic select_3530;
  assign select_3530 = equal_1928_s2_q ? (less_1925_s2_q ? (not_1929_s2_q & and_3527) : and_3527) : and_3527;
  // hls/stages/patches.hpp:184
  logic select_3533;
  assign select_3533 = equal_1762_s2_q ? (less_1925_s2_q ? (not_1927_s2_q & select_3530) : select_3530) : patches_read_below_q;
  // hls/stages/patches.hpp:549
  logic [6:0] sum_3534;
  assign sum_3534 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3537;
  assign select_3537 = (equal_3510_s2_q & ({sum_3534[6], sum_3534} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3538;
  assign select_3538 = less_1925_s2_q ? select_3537 : 10'h3ff;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3540;
  assign select_3540 = less_1925_s2_q ? (equal_1928_s2_q ? 10'h3ff : select_3538) : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3541;
  assign select_3541 = equal_1928_s2_q ? select_3540 : select_3538;
  logic [9:0] select_3543;
  assign select_3543 = less_1925_s2_q ? (equal_1926_s2_q ? 10'h3ff : select_3541) : select_3541;
  // hls/stages/patches.hpp:535
  logic [14:0] select_3545;
  assign select_3545 = and_3513 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3546;
  assign select_3546 = equal_1762_s2_q ? select_3545[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3547;
  assign select_3547 = equal_1762_s2_q ? select_3545[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3549;
  assign select_3549 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3551;
  assign select_3551 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:539
  logic [9:0] select_3554;
  assign select_3554 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3555;
  assign select_3555 = patches_read_first_q ? patches_read_far_q : select_3554;
  // hls/stages/patches.hpp:590
  logic [9:0] difference_3558;
  assign difference_3558 = select_3555 - select_3545[9:0];
  // hls/stages/patches.hpp:575
  logic less_3588;
  assign less_3588 = select_3549 < select_3551;
  // hls/stages/patches.hpp:581
  logic [1:0] sum_3589;
  assign sum_3589 = select_3514[4:3] + 2'h3;
  // hls/stages/patches.hpp:576
  logic [9:0] high;
  assign high = less_3588 ? select_3551 : select_3549;
  logic [9:0] low;
  assign low = (select_3551 < select_3549) ? select_3551 : select_3549;
  // hls/stages/patches.hpp:577
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3545[9:0];
  // hls/stages/patches.hpp:579
  logic not_3596;
  assign not_3596 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3597;
  assign sum_3597 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3599;
  assign not_3599 = ~({eight, 3'h0} < {1'b0, sum_3597, fall_2[0]});
  logic [1:0] sum_3600;
  assign sum_3600 = {1'b0, not_3596} + {1'b0, not_3599};
  // hls/stages/patches.hpp:580
  logic [10:0] sum_3601;
  assign sum_3601 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3603;
  assign not_3603 = ~({eight, 3'h0} < {sum_3601, fall_2[1:0]});
  logic not_3606;
  assign not_3606 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3607;
  assign sum_3607 = {1'b0, not_3603} + {1'b0, not_3606};
  // hls/stages/patches.hpp:579
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3600} + {1'b0, sum_3607};
  // hls/stages/patches.hpp:582
  logic [7:0] select_3610;
  assign select_3610 = less_3588 ? ({sum_3589, select_3514[2:0], 3'h0} - {5'h0, fraction}) : {sum_3589, select_3514[2:0], fraction};
  // hls/stages/agreement.hpp:789
  logic select_3835;
  assign select_3835 = equal_557_s2_q ? shown_shown_q : (so_s2_q ? select_1996 : shown_shown_q);
  logic select_3837;
  assign select_3837 = equal_557_s2_q ? shown_nearer_q : (so_s2_q ? select_1999 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3839;
  assign sum_3839 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:461
  logic [2:0] select_3841;
  assign select_3841 = less_3838_s2_q ? (sum_3839[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3843;
  assign select_3843 = equal_2433_s2_q ? (equal_662_s2_q ? 3'h0 : select_3841) : region_row_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3848;
  assign select_3848 = equal_557_s2_q ? select_1950 : (so_s2_q ? (ends_cell_s2_q ? select_2049 : select_1950) : 8'h1);
  // hls/stages/agreement.hpp:461
  logic [8:0] select_3862;
  assign select_3862 = equal_662_s2_q ? {{2{difference_3860[6]}}, difference_3860} : (less_3838_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:521
  logic [8:0] select_3864;
  assign select_3864 = and_533_s2_q ? (equal_2433_s2_q ? select_3862 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:461
  logic [6:0] select_3866;
  assign select_3866 = equal_662_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_3868;
  assign select_3868 = and_533_s2_q ? (equal_2433_s2_q ? select_3866 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3869;
  assign sum_3869 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3870;
  assign select_3870 = sum_3839[7] ? {1'b1, sum_3839[6:0], region_down_rest_q[0]} : sum_3869;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3839[7];
  // hls/stages/agreement.hpp:461
  logic select_3874;
  assign select_3874 = equal_2433_s2_q ? (equal_662_s2_q | (less_3838_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3879;
  assign or_3879 = segment_starts_q | not_560_s2_q;
  // hls/stages/agreement.hpp:1031
  logic select_3882;
  assign select_3882 = inside_v_s2_q ? (sum_1963_s2_q ? (equal_1755 & or_1965) : or_1965) : or_3879;
  // hls/stages/agreement.hpp:789
  logic select_3885;
  assign select_3885 = equal_557_s2_q ? or_3879 : (so_s2_q ? (ends_cell_s2_q ? select_3882 : or_3879) : or_3879);
  logic select_4044;
  assign select_4044 = so_s2_q ? (ends_cell_s2_q ? and_2037 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4047;
  assign select_4047 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4049;
  assign select_4049 = equal_557_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4047 : centres_values_0_of_skin_q);
  logic select_4050;
  assign select_4050 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4052;
  assign select_4052 = equal_557_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4050 : centres_values_1_textured_q);
  logic select_4053;
  assign select_4053 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4055;
  assign select_4055 = equal_557_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4053 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:461
  logic [10:0] select_4059;
  assign select_4059 = equal_2433_s2_q ? (equal_4056_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_4062;
  assign select_4062 = and_533_s2_q ? (equal_2433_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1272
  logic xor_4063;
  assign xor_4063 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4065;
  assign select_4065 = and_1942_s2_q ? (left_first_s2_q ? xor_4063 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4067;
  assign select_4067 = and_1942_s2_q ? (left_first_s2_q ? xor_4063 : select_4065) : write_half_q;
  logic select_4069;
  assign select_4069 = left_first_s2_q ? select_2002 : (and_1942_s2_q ? select_2003 : read_half_q);
  logic and_4073;
  assign and_4073 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4082;
  assign select_4082 = left_first_s2_q ? 10'h1 : (and_1942_s2_q ? select_2007 : rows_passed_q);
  logic [8:0] select_4085;
  assign select_4085 = left_first_s2_q ? {select_2005[7:0], or_2004} : (and_1942_s2_q ? {select_2005[7:0], or_2004} : columns_passed_q);
  logic select_4088;
  assign select_4088 = left_first_s2_q ? marks_last_s2_q : (and_1942_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4091;
  assign select_4091 = left_first_s2_q ? and_2021 : (and_1942_s2_q ? and_2021 : began_q);
  logic [2:0] select_4094;
  assign select_4094 = left_first_s2_q ? select_2023 : (and_1942_s2_q ? select_2023 : seen_x_q);
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_4099;
  assign select_4099 = left_first_s2_q ? 3'h0 : (and_2008 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4101;
  assign select_4101 = left_first_s2_q ? 3'h0 : (and_1942_s2_q ? select_4099 : seen_y_q);
  logic [7:0] select_4104;
  assign select_4104 = left_first_s2_q ? select_2016 : (and_1942_s2_q ? select_2016 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4110;
  assign select_4110 = left_first_s2_q ? select_4108 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4112;
  assign select_4112 = left_first_s2_q ? select_4108 : (and_1942_s2_q ? select_4110 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4117;
  assign and_4117 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4119;
  assign select_4119 = left_first_s2_q ? and_4117 : (and_1942_s2_q ? and_4117 : at_cell_end_q);
  logic select_4122;
  assign select_4122 = left_first_s2_q ? next_row : (and_1942_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4125;
  assign select_4125 = left_first_s2_q ? 11'h0 : (and_1942_s2_q ? select_2013 : seen_base_q);
  // hls/stages/agreement.hpp:789
  logic and_4192;
  assign and_4192 = equal_557_s2_q & (equal_2277 & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/registration.hpp:258
  logic not_4199;
  assign not_4199 = ~quarter[1];
  logic [3:0] select_4200;
  assign select_4200 = quarter[0] ? {quarter[1], 1'b0, not_4199, 1'b0} : {1'b0, quarter[1], 1'b0, not_4199};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1597;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1640;
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
  assign patches_choices_raddr = select_1674;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1676));
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
  assign regions_raddr = select_1960;
  logic regions_re;
  assign regions_re = s2_en & (equal_557_s2_q ? (x_s2_q[6] & not_1961) : and_1968);
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
  assign map_raddr = sum_2018;
  logic map_re;
  assign map_re = s2_en & select_2030;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_503_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_508_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_527, and_523, sum_519, sum_515};
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
  assign census_memory_we = s2_en & and_533_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_551, whole_2, select_543, select_539};
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
  assign moments_memory_waddr = select_556_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_574_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_629_s2_q, and_627_s2_q, and_622_s2_q, and_620};
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
  assign best_left_we = s2_en & and_1544_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1543, select_1540, select_1537, select_1535, select_1517, select_1514, select_1506, select_1505, select_1500};
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
  assign best_right_we = s2_en & and_1544_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1554, select_1553, select_1550, select_1549};
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
  assign shown_right_waddr = select_1561_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1572;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1569, not_560_s2_q};
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
  assign left_turns_we = s2_en & and_1583;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1580, and_1577};
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
  assign right_turns_we = s2_en & and_1583;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1589, and_1586};
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
  assign patches_right_codes_waddr = {sum_1876, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1910_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1896_s2_q, less_1895_s2_q, less_1886_s2_q, less_1885_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1914, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1924_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1896_s2_q, less_1895_s2_q, less_1886_s2_q, less_1885_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1557_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1995, textured};
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
      moments_out_of_step_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2161;
      averager_mask_q <= select_2163;
      averager_of_skin_q <= select_2165;
      census_filled_q <= and_533_s2_q ? {select_665[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= select_2269;
      moments_turned_1_q <= select_2276;
      moments_before_0_q <= equal_557_s2_q ? select_2280 : moments_before_0_q;
      moments_before_1_q <= equal_557_s2_q ? select_2283 : moments_before_1_q;
      moments_has_before_q <= equal_557_s2_q ? select_2286 : moments_has_before_q;
      moments_most_before_q <= equal_557_s2_q ? select_2289 : moments_most_before_q;
      moments_out_of_step_q <= equal_557_s2_q ? select_2318 : moments_out_of_step_q;
      rows_passed_above_q <= and_533_s2_q ? select_664 : rows_passed_above_q;
      chosen_score_q <= less_2543 ? select_1494 : select_2542;
      chosen_near_q <= (select_2545 < select_1529) ? select_1529 : select_2545;
      chosen_place_q <= less_2543 ? {select_1502, not_1501} : 3'h2;
      before_0_q <= select_2542;
      before_1_q <= sum_1244;
      before_2_q <= sum_1492;
      shift_allowed_q <= not_2550 & (~less_2551);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2558 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2677});
      counts_turned_right_q <= and_2558 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2684});
      registration_displacement_over_q <= so_s2_q ? sum_2708[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2710;
      registration_slope_here_q <= select_2712;
      registration_expected_q <= select_2714;
      registration_of_right_q <= equal_557_s2_q ? registration_of_right_q : select_2776;
      registration_was_inside_q <= equal_557_s2_q ? registration_was_inside_q : select_2779;
      registration_fresh_q <= select_2788;
      patches_chance_q <= and_533_s2_q ? select_2945 : patches_chance_q;
      patches_fixed_q <= and_2959;
      patches_choice_valid_q <= and_1760 ? (select_1733 & not_2947) : select_1733;
      patches_choice_column_q <= select_1738;
      patches_choice_shift_q <= select_1743;
      patches_choice_slope_q <= select_1754;
      patches_band_q <= sample_pair_whole_s2_q ? select_1775 : patches_band_q;
      patches_fetch_q <= select_2974;
      patches_codes_at_q <= select_3075;
      patches_codes_further_q <= equal_1762_s2_q ? patches_codes_further_q : select_3080;
      patches_next_codes_q <= select_3088;
      patches_set_q <= equal_1762_s2_q ? 3'h0 : (equal_1764_s2_q ? 3'h0 : select_3102);
      patches_size_q <= sum_3106;
      patches_left_row_q <= select_3118;
      patches_summed_row_column_q <= equal_1762_s2_q ? patches_summed_row_column_q : select_3463;
      patches_summed_first_q <= select_3466;
      patches_read_row_differing_q <= equal_1762_s2_q ? select_3478 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1762_s2_q ? select_3485 : patches_read_row_column_q;
      patches_read_at_q <= equal_1762_s2_q ? select_3492 : patches_read_at_q;
      patches_read_first_q <= select_3501;
      patches_read_above_q <= select_3524;
      patches_read_below_q <= select_3533;
      patches_read_far_q <= equal_1762_s2_q ? select_3543 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3546;
      patches_peak_best_column_q <= select_3547;
      patches_peak_row_q <= equal_1762_s2_q ? select_3514 : patches_peak_row_q;
      patches_peak_above_q <= equal_1762_s2_q ? select_3549 : patches_peak_above_q;
      patches_peak_below_q <= equal_1762_s2_q ? select_3551 : patches_peak_below_q;
      patches_peak_far_q <= equal_1762_s2_q ? select_3555 : patches_peak_far_q;
      patches_frame_ended_q <= equal_557_s2_q & (equal_2278 & (~equal_2277));
      shown_shown_q <= select_3835;
      shown_nearer_q <= select_3837;
      region_row_q <= and_533_s2_q ? select_3843 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3848;
      region_down_rest_q <= select_3864;
      region_down_back_q <= select_3868;
      region_down_next_q <= select_3870;
      region_fresh_q <= and_533_s2_q ? select_3874 : region_fresh_q;
      segment_starts_q <= select_3885;
      centres_values_0_textured_q <= equal_557_s2_q ? centres_values_0_textured_q : select_4044;
      centres_values_0_of_skin_q <= select_4049;
      centres_values_1_textured_q <= select_4052;
      centres_values_1_of_skin_q <= select_4055;
      map_row_q <= and_533_s2_q ? select_4059 : map_row_q;
      map_width_q <= select_4062;
      write_half_q <= select_4067;
      read_half_q <= and_1942_s2_q ? select_4069 : read_half_q;
      done_q <= and_1942_s2_q ? (not_2019 & and_4073) : and_4073;
      drew_q <= so_s2_q;
      said_q <= equal_557_s2_q & equal_2277;
      rows_passed_q <= and_1942_s2_q ? select_4082 : rows_passed_q;
      columns_passed_q <= and_1942_s2_q ? select_4085 : columns_passed_q;
      line_ended_q <= and_1942_s2_q ? select_4088 : line_ended_q;
      began_q <= and_1942_s2_q ? select_4091 : began_q;
      seen_x_q <= and_1942_s2_q ? select_4094 : seen_x_q;
      seen_y_q <= and_1942_s2_q ? select_4101 : seen_y_q;
      seen_column_q <= and_1942_s2_q ? select_4104 : seen_column_q;
      seen_rows_left_q <= and_1942_s2_q ? select_4112 : seen_rows_left_q;
      at_cell_end_q <= and_1942_s2_q ? select_4119 : at_cell_end_q;
      was_next_row_q <= and_1942_s2_q ? select_4122 : was_next_row_q;
      seen_base_q <= and_1942_s2_q ? select_4125 : seen_base_q;
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
      left_pixel_q <= and_1942_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_511 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_517 : averager_running_1_q;
      averager_total_0_q <= select_2140;
      averager_total_1_q <= select_2142;
      census_columns_values_0_cell_0_left_q <= select_2166;
      census_columns_values_0_cell_0_right_q <= select_2167;
      census_columns_values_0_cell_0_mask_q <= and_533_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2169;
      census_columns_values_0_cell_1_right_q <= select_2170;
      census_columns_values_0_cell_1_mask_q <= select_2171;
      census_columns_values_0_cell_2_left_q <= select_2172;
      census_columns_values_0_cell_2_right_q <= select_2173;
      census_columns_values_0_cell_2_mask_q <= select_2174;
      census_columns_values_0_cell_2_of_skin_q <= select_2175;
      census_columns_values_0_cell_3_left_q <= select_2176;
      census_columns_values_0_cell_3_right_q <= select_2177;
      census_columns_values_0_cell_3_mask_q <= select_2178;
      census_columns_values_0_cell_4_left_q <= select_2179;
      census_columns_values_0_cell_4_right_q <= select_2180;
      census_columns_values_0_cell_4_mask_q <= select_2181;
      census_columns_values_1_cell_0_left_q <= select_2182;
      census_columns_values_1_cell_0_right_q <= select_2183;
      census_columns_values_1_cell_0_mask_q <= select_2184;
      census_columns_values_1_cell_1_left_q <= select_2185;
      census_columns_values_1_cell_1_right_q <= select_2186;
      census_columns_values_1_cell_1_mask_q <= select_2187;
      census_columns_values_1_cell_2_left_q <= select_2188;
      census_columns_values_1_cell_2_right_q <= select_2189;
      census_columns_values_1_cell_2_mask_q <= select_2190;
      census_columns_values_1_cell_2_of_skin_q <= select_2191;
      census_columns_values_1_cell_3_left_q <= select_2192;
      census_columns_values_1_cell_3_right_q <= select_2193;
      census_columns_values_1_cell_3_mask_q <= select_2194;
      census_columns_values_1_cell_4_left_q <= select_2195;
      census_columns_values_1_cell_4_right_q <= select_2196;
      census_columns_values_1_cell_4_mask_q <= select_2197;
      census_columns_values_2_cell_0_left_q <= select_2198;
      census_columns_values_2_cell_0_right_q <= select_2199;
      census_columns_values_2_cell_0_mask_q <= select_2200;
      census_columns_values_2_cell_1_left_q <= select_2201;
      census_columns_values_2_cell_1_right_q <= select_2202;
      census_columns_values_2_cell_1_mask_q <= select_2203;
      census_columns_values_2_cell_2_left_q <= select_2204;
      census_columns_values_2_cell_2_right_q <= select_2205;
      census_columns_values_2_cell_2_mask_q <= select_2206;
      census_columns_values_2_cell_3_left_q <= select_2207;
      census_columns_values_2_cell_3_right_q <= select_2208;
      census_columns_values_2_cell_3_mask_q <= select_2209;
      census_columns_values_2_cell_4_left_q <= select_2210;
      census_columns_values_2_cell_4_right_q <= select_2211;
      census_columns_values_2_cell_4_mask_q <= select_2212;
      census_columns_values_3_cell_0_mask_q <= select_2213;
      census_columns_values_3_cell_1_left_q <= select_2214;
      census_columns_values_3_cell_1_right_q <= select_2215;
      census_columns_values_3_cell_1_mask_q <= select_2216;
      census_columns_values_3_cell_2_mask_q <= select_2217;
      census_columns_values_3_cell_3_left_q <= select_2218;
      census_columns_values_3_cell_3_right_q <= select_2219;
      census_columns_values_3_cell_3_mask_q <= select_2220;
      census_columns_values_3_cell_4_mask_q <= select_2221;
      sharpness_last_mean_0_q <= and_533_s2_q ? select_539 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_533_s2_q ? select_543 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2533;
      middle_sum_columns_values_2_q <= select_2534;
      middle_sum_columns_values_3_q <= select_2535;
      middle_sum_columns_values_4_q <= select_2536;
      middle_sum_columns_values_5_q <= select_2537;
      middle_sum_columns_values_6_q <= select_2538;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_994;
      sums_0_sum_sums_values_0_q <= sum_1244;
      sums_0_sum_sums_values_1_q <= equal_1242 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1492;
      sums_1_sum_sums_values_1_q <= equal_1242 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_497_s3_q;
  logic [5:0] select_499_s3_q;
  logic [5:0] column_s3_q;
  logic and_531_s3_q;
  logic and_533_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_536_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_553_s3_q;
  logic equal_557_s3_q;
  logic not_558_s3_q;
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
  logic less_651_s3_q;
  logic less_652_s3_q;
  logic less_653_s3_q;
  logic less_654_s3_q;
  logic less_655_s3_q;
  logic less_656_s3_q;
  logic less_657_s3_q;
  logic less_658_s3_q;
  logic and_666_s3_q;
  logic and_691_s3_q;
  logic and_692_s3_q;
  logic [11:0] sum_707_s3_q;
  logic [9:0] sum_710_s3_q;
  logic and_718_s3_q;
  logic and_722_s3_q;
  logic less_723_s3_q;
  logic less_727_s3_q;
  logic less_729_s3_q;
  logic equal_1590_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1596_s3_q;
  logic equal_1598_s3_q;
  logic equal_1600_s3_q;
  logic equal_1602_s3_q;
  logic equal_1604_s3_q;
  logic equal_1606_s3_q;
  logic equal_1608_s3_q;
  logic equal_1610_s3_q;
  logic equal_1612_s3_q;
  logic less_1621_s3_q;
  logic or_1625_s3_q;
  logic equal_1645_s3_q;
  logic and_1655_s3_q;
  logic and_1658_s3_q;
  logic select_1675_s3_q;
  logic equal_1676_s3_q;
  logic and_1684_s3_q;
  logic equal_1686_s3_q;
  logic select_1733_s3_q;
  logic and_1761_s3_q;
  logic equal_1762_s3_q;
  logic equal_1764_s3_q;
  logic and_1777_s3_q;
  logic [4:0] select_1792_s3_q;
  logic select_1798_s3_q;
  logic [3:0] select_1839_s3_q;
  logic less_1925_s3_q;
  logic equal_1926_s3_q;
  logic not_1927_s3_q;
  logic equal_1928_s3_q;
  logic and_1942_s3_q;
  logic select_1944_s3_q;
  logic and_1947_s3_q;
  logic or_1953_s3_q;
  logic or_1956_s3_q;
  logic or_1959_s3_q;
  logic not_1961_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_1988_s3_q;
  logic and_1993_s3_q;
  logic and_2025_s3_q;
  logic less_2026_s3_q;
  logic [11:0] sum_2034_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2052_s3_q;
  logic or_2055_s3_q;
  logic or_2058_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2108_s3_q;
  logic [11:0] sum_2237_s3_q;
  logic [9:0] sum_2240_s3_q;
  logic equal_2248_s3_q;
  logic equal_2277_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2558_s3_q;
  logic and_2564_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2626_s3_q;
  logic and_2660_s3_q;
  logic and_2718_s3_q;
  logic and_2719_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2755_s3_q;
  logic and_2769_s3_q;
  logic equal_2812_s3_q;
  logic parity_3190_s3_q;
  logic parity_3319_s3_q;
  logic parity_3381_s3_q;
  logic xor_3409_s3_q;
  logic parity_3421_s3_q;
  logic or_3425_s3_q;
  logic equal_3426_s3_q;
  logic [4:0] select_3545_s3_q;
  logic equal_3557_s3_q;
  logic less_3559_s3_q;
  logic less_3560_s3_q;
  logic or_3565_s3_q;
  logic [7:0] select_3610_s3_q;
  logic and_4128_s3_q;
  logic and_4192_s3_q;
  logic equal_4202_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
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
      select_497_s3_q <= select_497_s2_q;
      select_499_s3_q <= select_499_s2_q;
      column_s3_q <= column_s2_q;
      and_531_s3_q <= and_531_s2_q;
      and_533_s3_q <= and_533_s2_q;
      grey_s3_q <= grey;
      equal_536_s3_q <= equal_536;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_553_s3_q <= equal_553_s2_q;
      equal_557_s3_q <= equal_557_s2_q;
      not_558_s3_q <= not_558_s2_q;
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
      less_651_s3_q <= less_651;
      less_652_s3_q <= less_652;
      less_653_s3_q <= less_653;
      less_654_s3_q <= less_654;
      less_655_s3_q <= less_655;
      less_656_s3_q <= less_656;
      less_657_s3_q <= less_657;
      less_658_s3_q <= less_658;
      and_666_s3_q <= and_666;
      and_691_s3_q <= whole_22 & and_666;
      and_692_s3_q <= census_columns_values_1_cell_2_mask_q & and_666;
      sum_707_s3_q <= {1'b0, sum_703} + {2'h0, sum_706};
      sum_710_s3_q <= {9'h0, difference_708[9]} + {1'b0, xor_709};
      and_718_s3_q <= and_718;
      and_722_s3_q <= and_722;
      less_723_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_727_s3_q <= {{5{sum_726[6]}}, sum_726, half_grey_levels_2[3:0]} < 16'hffe1;
      less_729_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1590_s3_q <= equal_1590;
      all_s3_q <= all;
      sum_1596_s3_q <= sum_1596;
      equal_1598_s3_q <= equal_1598;
      equal_1600_s3_q <= equal_1600;
      equal_1602_s3_q <= equal_1602;
      equal_1604_s3_q <= equal_1604;
      equal_1606_s3_q <= equal_1606;
      equal_1608_s3_q <= equal_1608;
      equal_1610_s3_q <= equal_1610;
      equal_1612_s3_q <= equal_1612;
      less_1621_s3_q <= less_1621;
      or_1625_s3_q <= or_1625;
      equal_1645_s3_q <= (registration_fresh_q & select_1643) == 4'h0;
      and_1655_s3_q <= not_558_s2_q & and_1639;
      and_1658_s3_q <= and_1658_s2_q;
      select_1675_s3_q <= select_1675[1];
      equal_1676_s3_q <= equal_1676;
      and_1684_s3_q <= and_1684;
      equal_1686_s3_q <= equal_1686;
      select_1733_s3_q <= select_1733;
      and_1761_s3_q <= and_1761;
      equal_1762_s3_q <= equal_1762_s2_q;
      equal_1764_s3_q <= equal_1764_s2_q;
      and_1777_s3_q <= and_1761 & equal_1776;
      select_1792_s3_q <= select_1792_s2_q;
      select_1798_s3_q <= select_1798_s2_q;
      select_1839_s3_q <= select_1839_s2_q;
      less_1925_s3_q <= less_1925_s2_q;
      equal_1926_s3_q <= equal_1926_s2_q;
      not_1927_s3_q <= not_1927_s2_q;
      equal_1928_s3_q <= equal_1928_s2_q;
      and_1942_s3_q <= and_1942_s2_q;
      select_1944_s3_q <= select_1944_s2_q;
      and_1947_s3_q <= and_1947_s2_q;
      or_1953_s3_q <= or_1953;
      or_1956_s3_q <= or_1956;
      or_1959_s3_q <= or_1959;
      not_1961_s3_q <= not_1961;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_1988_s3_q <= inside_v_s2_q & (and_1986 & and_1568);
      and_1993_s3_q <= not_558_s2_q & and_1968;
      and_2025_s3_q <= and_2025;
      less_2026_s3_q <= less_2026;
      sum_2034_s3_q <= sum_2034;
      textured_2_s3_q <= textured_2;
      or_2052_s3_q <= or_2052;
      or_2055_s3_q <= select_2049[7] | (~({select_2049[6], select_2049[3:2]} == 3'h0));
      or_2058_s3_q <= select_2049[7] | (~(select_2049[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2108_s3_q <= and_2108;
      sum_2237_s3_q <= {1'b0, sum_2233} + {2'h0, sum_2236};
      sum_2240_s3_q <= {9'h0, difference_2238[9]} + {1'b0, xor_2239};
      equal_2248_s3_q <= equal_2248_s2_q;
      equal_2277_s3_q <= equal_2277;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2558_s3_q <= and_2558;
      and_2564_s3_q <= and_2564;
      explained_2_s3_q <= explained_2;
      and_2626_s3_q <= not_558_s2_q & and_2625;
      and_2660_s3_q <= not_558_s2_q & and_2659;
      and_2718_s3_q <= not_558_s2_q & (so_s2_q & (half_ends & equal_2715));
      and_2719_s3_q <= and_2719;
      residual_s3_q <= residual[7:0];
      and_2755_s3_q <= and_2755;
      and_2769_s3_q <= and_2719 & less_2768;
      equal_2812_s3_q <= (registration_fresh_q & select_2810) == 4'h0;
      parity_3190_s3_q <= ^{xor_3186, xor_3149, select_3116[44:36], other[44:36]};
      parity_3319_s3_q <= parity_3319;
      parity_3381_s3_q <= parity_3381;
      xor_3409_s3_q <= parity_3396 ^ parity_3408;
      parity_3421_s3_q <= ^{or_3418, or_3414, and_3410};
      or_3425_s3_q <= (or_3414 & or_3418) | (and_3410 & (or_3414 | or_3418));
      equal_3426_s3_q <= equal_3426_s2_q;
      select_3545_s3_q <= select_3545[14:10];
      equal_3557_s3_q <= select_3514[3:0] == 4'h0;
      less_3559_s3_q <= {difference_3558, 3'h0} < {3'h0, sum_3106};
      less_3560_s3_q <= select_3555 < select_3545[9:0];
      or_3565_s3_q <= (sum_3106 < 10'h39) | ({1'b0, sum_3106[9:1]} < select_3545[9:0]);
      select_3610_s3_q <= select_3610;
      and_4128_s3_q <= and_2108 & (sum_2034 == sum_2018);
      and_4192_s3_q <= and_4192;
      equal_4202_s3_q <= (registration_fresh_q & select_4200) == 4'h0;
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
  assign texture = sum_707_s3_q + {2'h0, sum_710_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_712;
  assign sum_712 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_714;
  assign sum_714 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_712});
  // hls/stages/census.hpp:305
  logic less_715;
  assign less_715 = 9'h4 < sum_714[13:5];
  logic and_716;
  assign and_716 = and_666_s3_q & less_715;
  // hls/stages/moments.hpp:30
  logic and_728;
  assign and_728 = (and_691_s3_q & and_718_s3_q) & less_727_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1647;
  assign equal_1647 = sum_1596_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1596_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1649;
  assign select_1649 = equal_1647 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1650;
  assign sum_1650 = (equal_1645_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1649[13]}}, select_1649};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1596_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1653;
  assign select_1653 = equal_1647 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1654;
  assign sum_1654 = (equal_1645_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1653[6]}}, select_1653};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1778;
  assign select_1778 = and_1777_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1733_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1780;
  assign select_1780 = equal_1676_s3_q ? patches_place_0_valid_q : (select_1675_s3_q ? patches_place_0_valid_q : select_1778[0]);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1781;
  assign select_1781 = select_1675_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1778[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1782;
  assign select_1782 = equal_1676_s3_q ? patches_place_0_column_q : select_1781[6:0];
  logic [5:0] select_1783;
  assign select_1783 = equal_1676_s3_q ? patches_place_0_shift_q : select_1781[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1784;
  assign sum_1784 = select_1782 + {select_1783[5], select_1783};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1785;
  assign sum_1785 = sum_1784[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1786;
  assign equal_1786 = {sum_1785[5], select_499_s3_q, select_497_s3_q} == {1'b0, sum_1785[4:0], sum_1784[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1788;
  assign or_1788 = and_1658_s3_q | (select_1780 & equal_1786);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1789;
  assign select_1789 = or_1788 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1799;
  assign select_1799 = or_1788 ? {and_1658_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1801;
  assign and_1801 = select_1798_s3_q & (~select_1799[5]);
  // hls/stages/patches.hpp:127
  logic select_1809;
  assign select_1809 = equal_1676_s3_q ? patches_place_1_valid_q : (select_1675_s3_q ? select_1778[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1810;
  assign select_1810 = select_1675_s3_q ? select_1778[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1811;
  assign select_1811 = equal_1676_s3_q ? patches_place_1_column_q : select_1810[6:0];
  logic [5:0] select_1812;
  assign select_1812 = equal_1676_s3_q ? patches_place_1_shift_q : select_1810[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1813;
  assign sum_1813 = select_1811 + {select_1812[5], select_1812};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1814;
  assign sum_1814 = sum_1813[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1815;
  assign equal_1815 = {sum_1814[5], select_499_s3_q, select_497_s3_q} == {1'b0, sum_1814[4:0], sum_1813[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1817;
  assign or_1817 = and_1658_s3_q | (select_1809 & equal_1815);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1818;
  assign select_1818 = or_1817 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1819;
  assign select_1819 = or_1817 ? {and_1658_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1821;
  assign and_1821 = select_1798_s3_q & (~select_1819[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1828;
  assign sum_1828 = select_1782 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1829;
  assign equal_1829 = {sum_1828[6], select_499_s3_q, select_497_s3_q} == {1'b0, sum_1828[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1831;
  assign or_1831 = and_1658_s3_q | (select_1780 & equal_1829);
  logic [4:0] select_1832;
  assign select_1832 = or_1831 ? {and_1658_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1833;
  assign sum_1833 = select_1811 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1834;
  assign equal_1834 = {sum_1833[6], select_499_s3_q, select_497_s3_q} == {1'b0, sum_1833[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1837;
  assign select_1837 = (and_1658_s3_q | (select_1809 & equal_1834)) ? {and_1658_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1832[4] ? select_1837[3:0] : select_1832[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1840;
  assign select_1840 = or_1831 ? and_1658_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1846;
  assign and_1846 = (select_1798_s3_q & (select_1792_s3_q[3] ^ select_1792_s3_q[4])) & ((~select_1832[4]) | (~select_1837[4]));
  // hls/stages/patches.hpp:184
  logic less_1937;
  assign less_1937 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1938;
  assign not_1938 = ~less_1937;
  logic [1:0] select_1939;
  assign select_1939 = patches_summed_first_s3_q ? 2'h2 : {less_1937, not_1938};
  logic [12:0] select_1940;
  assign select_1940 = select_1939[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1948;
  assign select_1948 = select_1939[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1947_s3_q, 1'b0, select_1944_s3_q, left_pixel_q};
  logic [14:0] select_1949;
  assign select_1949 = select_1939[1] ? {select_1940[12:8], patches_sums_values_0_q[9:8], select_1940[7:0]} : select_1948;
  // hls/stages/agreement.hpp:901
  logic [5:0] select_1974;
  assign select_1974 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_1975;
  assign sum_1975 = {5'h0, textured_s3_q} + select_1974;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_1977;
  assign sum_1977 = {4'h0, sum_1975} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:901
  logic [5:0] select_1979;
  assign select_1979 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_1980;
  assign sum_1980 = {5'h0, explained_s3_q} + select_1979;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_1982;
  assign sum_1982 = {4'h0, sum_1980} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:901
  logic [5:0] select_1989;
  assign select_1989 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:903
  logic [5:0] sum_1990;
  assign sum_1990 = {5'h0, and_1988_s3_q} + select_1989;
  // hls/stages/agreement.hpp:1064
  logic [9:0] sum_1992;
  assign sum_1992 = {4'h0, sum_1990} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2043;
  assign select_2043 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2044;
  assign difference_2044 = {1'b0, textured_2_s3_q} - {1'b0, select_2043};
  logic [4:0] t;
  assign t = {difference_2044[3], difference_2044} + (equal_553_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic equal_2047;
  assign equal_2047 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1102
  logic not_2059;
  assign not_2059 = ~region_row_s3_q[2];
  logic [2:0] select_2060;
  assign select_2060 = region_row_s3_q[1] ? {1'b0, not_2059, 1'b0} : {region_row_s3_q[2], 1'b0, not_2059};
  logic [5:0] select_2061;
  assign select_2061 = region_row_s3_q[0] ? {select_2060[2], 1'b0, select_2060[1], 1'b0, select_2060[0], 1'b0} : {1'b0, select_2060[2], 1'b0, select_2060[1], 1'b0, select_2060[0]};
  logic [11:0] select_2062;
  assign select_2062 = or_2058_s3_q ? {select_2061[5], 1'b0, select_2061[4], 1'b0, select_2061[3], 1'b0, select_2061[2], 1'b0, select_2061[1], 1'b0, select_2061[0], 1'b0} : {1'b0, select_2061[5], 1'b0, select_2061[4], 1'b0, select_2061[3], 1'b0, select_2061[2], 1'b0, select_2061[1], 1'b0, select_2061[0]};
  logic [23:0] select_2063;
  assign select_2063 = or_2055_s3_q ? {select_2062[11], 1'b0, select_2062[10], 1'b0, select_2062[9], 1'b0, select_2062[8], 1'b0, select_2062[7], 1'b0, select_2062[6], 1'b0, select_2062[5], 1'b0, select_2062[4], 1'b0, select_2062[3], 1'b0, select_2062[2], 1'b0, select_2062[1], 1'b0, select_2062[0], 1'b0} : {1'b0, select_2062[11], 1'b0, select_2062[10], 1'b0, select_2062[9], 1'b0, select_2062[8], 1'b0, select_2062[7], 1'b0, select_2062[6], 1'b0, select_2062[5], 1'b0, select_2062[4], 1'b0, select_2062[3], 1'b0, select_2062[2], 1'b0, select_2062[1], 1'b0, select_2062[0]};
  logic [47:0] select_2064;
  assign select_2064 = or_2052_s3_q ? {select_2063[23], 1'b0, select_2063[22], 1'b0, select_2063[21], 1'b0, select_2063[20], 1'b0, select_2063[19], 1'b0, select_2063[18], 1'b0, select_2063[17], 1'b0, select_2063[16], 1'b0, select_2063[15], 1'b0, select_2063[14], 1'b0, select_2063[13], 1'b0, select_2063[12], 1'b0, select_2063[11], 1'b0, select_2063[10], 1'b0, select_2063[9], 1'b0, select_2063[8], 1'b0, select_2063[7], 1'b0, select_2063[6], 1'b0, select_2063[5], 1'b0, select_2063[4], 1'b0, select_2063[3], 1'b0, select_2063[2], 1'b0, select_2063[1], 1'b0, select_2063[0], 1'b0} : {1'b0, select_2063[23], 1'b0, select_2063[22], 1'b0, select_2063[21], 1'b0, select_2063[20], 1'b0, select_2063[19], 1'b0, select_2063[18], 1'b0, select_2063[17], 1'b0, select_2063[16], 1'b0, select_2063[15], 1'b0, select_2063[14], 1'b0, select_2063[13], 1'b0, select_2063[12], 1'b0, select_2063[11], 1'b0, select_2063[10], 1'b0, select_2063[9], 1'b0, select_2063[8], 1'b0, select_2063[7], 1'b0, select_2063[6], 1'b0, select_2063[5], 1'b0, select_2063[4], 1'b0, select_2063[3], 1'b0, select_2063[2], 1'b0, select_2063[1], 1'b0, select_2063[0]};
  // hls/stages/agreement.hpp:1031
  logic and_2068;
  assign and_2068 = good_known_q & (~((good_q & select_2064) == 48'h0));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2077;
  assign select_2077 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2078;
  assign difference_2078 = {1'b0, shown_2_s3_q} - {1'b0, select_2077};
  logic [4:0] around;
  assign around = {difference_2078[3], difference_2078} + (equal_553_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1104
  logic [5:0] sum_2081;
  assign sum_2081 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2047 ? and_2068 : (~({sum_2081, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1098
  logic [2:0] select_2093;
  assign select_2093 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2094;
  assign difference_2094 = {1'b0, near_2_s3_q} - {1'b0, select_2093};
  logic [4:0] n;
  assign n = {difference_2094[3], difference_2094} + (equal_553_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic and_2098;
  assign and_2098 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2132;
  assign select_2132 = sample_pair_whole_s3_q ? (and_531_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2134;
  assign select_2134 = sample_pair_whole_s3_q ? (and_531_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2136;
  assign select_2136 = sample_pair_whole_s3_q ? (and_531_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2138;
  assign select_2138 = sample_pair_whole_s3_q ? (and_531_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2143;
  assign sum_2143 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2144;
  assign difference_2144 = {1'b0, sum_2143[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2145;
  assign xor_2145 = {difference_2144[8:0], sum_2143[0]} ^ {10{difference_2144[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2144[9]} + {1'b0, xor_2145};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_536_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2150;
  assign select_2150 = sample_pair_whole_s3_q ? (and_531_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2151;
  assign sum_2151 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2152;
  assign difference_2152 = {1'b0, sum_2151[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2153;
  assign xor_2153 = {difference_2152[8:0], sum_2151[0]} ^ {10{difference_2152[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2152[9]} + {1'b0, xor_2153};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_536_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2158;
  assign select_2158 = sample_pair_whole_s3_q ? (and_531_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2241;
  assign sum_2241 = sum_2237_s3_q + {2'h0, sum_2240_s3_q};
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2243;
  assign select_2243 = and_533_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2244;
  assign select_2244 = and_533_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2245;
  assign select_2245 = and_533_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2246;
  assign select_2246 = and_533_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2249;
  assign sum_2249 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2241};
  logic [13:0] sum_2251;
  assign sum_2251 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2249});
  // hls/stages/census.hpp:311
  logic and_2253;
  assign and_2253 = and_691_s3_q & (9'h4 < sum_2251[13:5]);
  // hls/stages/census.hpp:312
  logic and_2254;
  assign and_2254 = and_691_s3_q & less_715;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2255;
  assign sum_2255 = census_left_misses_q + {{17{and_2254}}, and_2253, 1'b0, and_2253};
  // hls/stages/agreement.hpp:521
  logic [19:0] select_2257;
  assign select_2257 = and_533_s3_q ? (equal_2248_s3_q ? 20'h0 : sum_2255) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2323;
  assign select_2323 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:521
  logic select_2326;
  assign select_2326 = and_533_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2329;
  assign and_2329 = whole_2_s3_q & (~(column_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:458
  logic and_2335;
  assign and_2335 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2336;
  assign and_2336 = and_2329 & and_2335;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2323[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2338;
  assign select_2338 = and_2336 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2340;
  assign select_2340 = equal_2248_s3_q ? {11'h0, select_2338} : (sharpness_sums_detail_0_q + {11'h0, select_2338});
  // hls/stages/agreement.hpp:458
  logic and_2347;
  assign and_2347 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2348;
  assign and_2348 = and_2329 & and_2347;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2323[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2350;
  assign select_2350 = and_2348 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2352;
  assign select_2352 = equal_2248_s3_q ? {11'h0, select_2350} : (sharpness_sums_detail_1_q + {11'h0, select_2350});
  logic [8:0] select_2355;
  assign select_2355 = and_2336 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2356;
  assign sum_2356 = (equal_2248_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2355};
  logic [8:0] select_2359;
  assign select_2359 = and_2348 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2360;
  assign sum_2360 = (equal_2248_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2359};
  // hls/stages/agreement.hpp:211
  logic equal_2362;
  assign equal_2362 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2363;
  assign less_2363 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2364;
  assign less_2364 = x_s3_q[4:0] < 5'h3;
  logic not_2365;
  assign not_2365 = ~x_s3_q[1];
  logic [2:0] select_2366;
  assign select_2366 = x_s3_q[0] ? {1'b0, not_2365, 1'b0} : {x_s3_q[1], 1'b0, not_2365};
  logic [5:0] select_2367;
  assign select_2367 = slot_s3_q[2] ? {select_2366[2], 1'b0, select_2366[1], 1'b0, select_2366[0], 1'b0} : {1'b0, select_2366[2], 1'b0, select_2366[1], 1'b0, select_2366[0]};
  logic [11:0] select_2368;
  assign select_2368 = slot_s3_q[1] ? {select_2367[5], 1'b0, select_2367[4], 1'b0, select_2367[3], 1'b0, select_2367[2], 1'b0, select_2367[1], 1'b0, select_2367[0], 1'b0} : {1'b0, select_2367[5], 1'b0, select_2367[4], 1'b0, select_2367[3], 1'b0, select_2367[2], 1'b0, select_2367[1], 1'b0, select_2367[0]};
  logic [23:0] select_2369;
  assign select_2369 = slot_s3_q[0] ? {select_2368[11], 1'b0, select_2368[10], 1'b0, select_2368[9], 1'b0, select_2368[8], 1'b0, select_2368[7], 1'b0, select_2368[6], 1'b0, select_2368[5], 1'b0, select_2368[4], 1'b0, select_2368[3], 1'b0, select_2368[2], 1'b0, select_2368[1], 1'b0, select_2368[0], 1'b0} : {1'b0, select_2368[11], 1'b0, select_2368[10], 1'b0, select_2368[9], 1'b0, select_2368[8], 1'b0, select_2368[7], 1'b0, select_2368[6], 1'b0, select_2368[5], 1'b0, select_2368[4], 1'b0, select_2368[3], 1'b0, select_2368[2], 1'b0, select_2368[1], 1'b0, select_2368[0]};
  // hls/stages/census.hpp:378
  logic and_2373;
  assign and_2373 = less_2364 & (~((sharpness_sums_contrast_1_q & select_2369) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2375;
  assign select_2375 = (less_2363 & and_2373) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2375};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2378;
  assign select_2378 = equal_2362 ? (less_2363 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2383;
  assign and_2383 = less_2364 & (~((sharpness_sums_contrast_0_q & select_2369) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2385;
  assign select_2385 = (less_2363 & and_2383) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2385};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2388;
  assign select_2388 = equal_2362 ? (less_2363 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2390;
  assign select_2390 = equal_2362 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2392;
  assign select_2392 = equal_2362 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2394;
  assign select_2394 = equal_2362 ? {sharpness_comparing_contrast_0_q[0], and_2383} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2396;
  assign select_2396 = equal_2362 ? {sharpness_comparing_contrast_1_q[0], and_2373} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2401;
  assign select_2401 = drew_q ? (equal_2362 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2405;
  assign select_2405 = drew_q ? (equal_2362 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2406;
  assign equal_2406 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2407;
  assign xor_2407 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2410;
  assign select_2410 = (equal_2406 | xor_2407) ? (five_times[0] & xor_2407) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2412;
  assign select_2412 = drew_q ? (equal_2362 ? select_2410 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2413;
  assign xor_2413 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2416;
  assign select_2416 = (equal_2406 | xor_2413) ? (five_times_2[0] & xor_2413) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2418;
  assign select_2418 = drew_q ? (equal_2362 ? select_2416 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2419;
  assign xor_2419 = sharpness_comparing_contrast_0_q[1] ^ and_2373;
  logic select_2422;
  assign select_2422 = (equal_2406 | xor_2419) ? (and_2373 & xor_2419) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2424;
  assign select_2424 = drew_q ? (equal_2362 ? select_2422 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2425;
  assign xor_2425 = sharpness_comparing_contrast_1_q[1] ^ and_2383;
  logic select_2428;
  assign select_2428 = (equal_2406 | xor_2425) ? (and_2383 & xor_2425) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2430;
  assign select_2430 = drew_q ? (equal_2362 ? select_2428 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2566;
  assign select_2566 = and_2558_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2564_s3_q});
  // hls/stages/agreement.hpp:789
  logic and_2569;
  assign and_2569 = not_558_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2574;
  assign and_2574 = not_558_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2579;
  assign and_2579 = not_558_s3_q & (drew_q & (ends_cell_s3_q & and_1988_s3_q));
  // hls/stages/agreement.hpp:1106
  logic not_2583;
  assign not_2583 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2592;
  assign select_2592 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2593;
  assign difference_2593 = {1'b0, explained_2_s3_q} - {1'b0, select_2592};
  logic [4:0] e;
  assign e = {difference_2593[3], difference_2593} + (equal_553_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2596;
  assign sum_2596 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1107
  logic not_2600;
  assign not_2600 = ~(equal_2047 ? and_2068 : (~({sum_2596, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:789
  logic and_2603;
  assign and_2603 = ends_cell_s3_q & (not_2583 & (centres_values_1_textured_s3_q & not_2600));
  logic and_2605;
  assign and_2605 = not_558_s3_q & (drew_q & and_2603);
  // hls/stages/agreement.hpp:1133
  logic less_2608;
  assign less_2608 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2609;
  assign select_2609 = less_2608 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2612;
  assign select_2612 = less_2608 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1134
  logic [10:0] sum_2613;
  assign sum_2613 = {1'b0, select_2612} + {3'h0, select_2612[9:2]};
  logic and_2615;
  assign and_2615 = (~(select_2609[9:4] == 6'h0)) & ({sum_2613, select_2612[1:0]} < {3'h0, select_2609});
  // hls/stages/agreement.hpp:1143
  logic [9:0] select_2618;
  assign select_2618 = x_s3_q[6] ? (equal_1590_s3_q ? 10'h0 : (and_2615 ? select_2609 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:789
  logic [9:0] select_2619;
  assign select_2619 = equal_557_s3_q ? select_2618 : 10'h0;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2621;
  assign select_2621 = and_2558_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2619});
  logic [13:0] select_2628;
  assign select_2628 = and_2558_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2626_s3_q});
  // hls/stages/agreement.hpp:1111
  logic and_2630;
  assign and_2630 = not_2583 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:789
  logic and_2633;
  assign and_2633 = not_558_s3_q & (drew_q & (ends_cell_s3_q & and_2630));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2635;
  assign select_2635 = and_2558_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2633});
  // hls/stages/agreement.hpp:1111
  logic and_2637;
  assign and_2637 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2600);
  // hls/stages/agreement.hpp:789
  logic and_2641;
  assign and_2641 = not_558_s3_q & (drew_q & (ends_cell_s3_q & (not_2583 & and_2637)));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2643;
  assign select_2643 = and_2558_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2641});
  logic [13:0] select_2662;
  assign select_2662 = and_2558_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2660_s3_q});
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2737;
  assign select_2737 = drew_q ? (equal_1686_s3_q ? (and_2719_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2738;
  assign select_2738 = equal_557_s3_q ? 8'h0 : select_2737;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2740;
  assign select_2740 = and_2718_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2738[7]}}, select_2738});
  // hls/stages/agreement.hpp:789
  logic and_2743;
  assign and_2743 = not_558_s3_q & (drew_q & (and_2719_s3_q & equal_1686_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2745;
  assign select_2745 = and_2718_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2743});
  // hls/stages/registration.hpp:107
  logic and_2747;
  assign and_2747 = and_2719_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2749;
  assign select_2749 = drew_q ? (equal_1686_s3_q ? {and_2747, and_2719_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2750;
  assign select_2750 = equal_557_s3_q ? 2'h0 : select_2749;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2751;
  assign sum_2751 = registration_half_votes_down_q + {{5{select_2750[1]}}, select_2750};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2757;
  assign select_2757 = drew_q ? (equal_1686_s3_q ? {and_2755_s3_q, and_2719_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2758;
  assign select_2758 = equal_557_s3_q ? 2'h0 : select_2757;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2759;
  assign sum_2759 = registration_half_votes_up_q + {{5{select_2758[1]}}, select_2758};
  // hls/stages/registration.hpp:107
  logic and_2762;
  assign and_2762 = and_2719_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2764;
  assign select_2764 = drew_q ? (equal_1686_s3_q ? {and_2762, and_2719_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2765;
  assign select_2765 = equal_557_s3_q ? 2'h0 : select_2764;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2766;
  assign sum_2766 = registration_half_half_votes_down_q + {{5{select_2765[1]}}, select_2765};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2771;
  assign select_2771 = drew_q ? (equal_1686_s3_q ? {and_2769_s3_q, and_2719_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2772;
  assign select_2772 = equal_557_s3_q ? 2'h0 : select_2771;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2773;
  assign sum_2773 = registration_half_half_votes_up_q + {{5{select_2772[1]}}, select_2772};
  // hls/stages/agreement.hpp:789
  logic and_2807;
  assign and_2807 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & less_1621_s3_q));
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2814;
  assign select_2814 = or_1625_s3_q ? 12'h0 : (equal_2812_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2817;
  assign select_2817 = x_s3_q[6] ? (equal_1590_s3_q ? 12'h0 : (less_1621_s3_q ? select_2814 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2818;
  assign select_2818 = equal_557_s3_q ? select_2817 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2819;
  assign and_2819 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_2822;
  assign and_2822 = not_1961_s3_q & (less_1621_s3_q & ({and_2819, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:789
  logic and_2824;
  assign and_2824 = equal_557_s3_q & (x_s3_q[6] & and_2822);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2826;
  assign sum_2826 = {{2{select_2818[11]}}, select_2818} + (and_2824 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2829;
  assign select_2829 = or_1625_s3_q ? 12'h0 : (equal_2812_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2832;
  assign select_2832 = x_s3_q[6] ? (equal_1590_s3_q ? 12'h0 : (less_1621_s3_q ? select_2829 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2833;
  assign select_2833 = equal_557_s3_q ? select_2832 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2835;
  assign sum_2835 = {{2{select_2833[11]}}, select_2833} + (and_2824 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2837;
  assign not_2837 = ~all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_2840;
  assign and_2840 = not_1961_s3_q & (less_1621_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2837, 1'b0}));
  // hls/stages/agreement.hpp:789
  logic and_2846;
  assign and_2846 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & (less_1621_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2847;
  assign not_2847 = ~and_2846;
  logic less_2848;
  assign less_2848 = $signed({9'h1, {2{not_2847}}, and_2846}) < $signed(registration_up_q[13:2]);
  logic select_2849;
  assign select_2849 = (equal_557_s3_q & (x_s3_q[6] & and_2840)) ? less_2848 : registration_enough_q;
  // hls/stages/agreement.hpp:1143
  logic and_2853;
  assign and_2853 = x_s3_q[6] & (not_1961_s3_q & (less_1621_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:789
  logic and_2854;
  assign and_2854 = equal_557_s3_q & and_2853;
  // hls/stages/registration.hpp:242
  logic less_2855;
  assign less_2855 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2857;
  assign less_2857 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2859;
  assign equal_2859 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:789
  logic and_2863;
  assign and_2863 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & (less_1621_s3_q & equal_2859)));
  // hls/stages/agreement.hpp:1143
  logic and_2870;
  assign and_2870 = x_s3_q[6] & (not_1961_s3_q & (less_1621_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2873;
  assign equal_2873 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1143
  logic and_2876;
  assign and_2876 = not_1961_s3_q & (less_1621_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2873));
  // hls/stages/registration.hpp:244
  logic and_2880;
  assign and_2880 = (equal_557_s3_q & (x_s3_q[6] & and_2876)) & (less_2857 | less_2855);
  // hls/stages/agreement.hpp:1143
  logic and_2885;
  assign and_2885 = not_1961_s3_q & (less_1621_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2873)));
  // hls/stages/registration.hpp:244
  logic and_2888;
  assign and_2888 = registration_votes_up_q & registration_other_down_q;
  logic select_2890;
  assign select_2890 = registration_votes_down_q ? (registration_other_up_q | and_2888) : and_2888;
  // hls/stages/registration.hpp:138
  logic and_2892;
  assign and_2892 = (equal_557_s3_q & (x_s3_q[6] & and_2885)) & (registration_other_enough_q & select_2890);
  // hls/stages/registration.hpp:245
  logic or_2895;
  assign or_2895 = registration_moved_q | (registration_enough_q & (and_2880 | and_2892));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_2979;
  assign select_2979 = sample_pair_whole_s3_q ? (equal_1676_s3_q ? patches_place_0_slope_q : select_1781[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2984;
  assign select_2984 = sample_pair_whole_s3_q ? (equal_1676_s3_q ? patches_place_1_slope_q : select_1810[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_2986;
  assign select_2986 = equal_1676_s3_q ? patches_valid_0_q : (select_1675_s3_q ? patches_valid_0_q : select_1778[0]);
  // hls/stages/agreement.hpp:276
  logic select_2989;
  assign select_2989 = sample_pair_whole_s3_q ? (and_1801 ? (sample_present_s3_q & select_2986) : select_2986) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2991;
  assign select_2991 = equal_1676_s3_q ? patches_valid_1_q : (select_1675_s3_q ? select_1778[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_2994;
  assign select_2994 = sample_pair_whole_s3_q ? (and_1821 ? (sample_present_s3_q & select_2991) : select_2991) : patches_valid_1_q;
  logic [5:0] select_2997;
  assign select_2997 = sample_pair_whole_s3_q ? (select_1799[5] ? {1'b1, select_1799[4:0]} : (select_1799 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3000;
  assign select_3000 = sample_pair_whole_s3_q ? (select_1819[5] ? {1'b1, select_1819[4:0]} : (select_1819 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3003;
  assign select_3003 = sample_pair_whole_s3_q ? (select_1832[4] ? {1'b1, select_1832[3:0]} : (select_1832 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3006;
  assign select_3006 = sample_pair_whole_s3_q ? (select_1837[4] ? {1'b1, select_1837[3:0]} : (select_1837 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:521
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3425_s3_q, parity_3421_s3_q, xor_3409_s3_q, parity_3381_s3_q, parity_3319_s3_q, parity_3190_s3_q} + (equal_3426_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3430;
  assign select_3430 = equal_1762_s3_q ? patches_sums_values_0_q : (equal_1764_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3431;
  assign select_3431 = equal_1764_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3433;
  assign select_3433 = equal_1764_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3435;
  assign select_3435 = equal_1764_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3437;
  assign select_3437 = equal_1764_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3439;
  assign select_3439 = equal_1764_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3441;
  assign select_3441 = equal_1764_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3443;
  assign select_3443 = equal_1764_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3445;
  assign select_3445 = equal_1764_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3447;
  assign select_3447 = equal_1764_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3449;
  assign select_3449 = equal_1764_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3451;
  assign select_3451 = equal_1764_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3453;
  assign select_3453 = equal_1764_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3455;
  assign select_3455 = equal_1764_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3457;
  assign select_3457 = equal_1764_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3459;
  assign select_3459 = equal_1764_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3461;
  assign select_3461 = equal_1764_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:595
  logic or_3566;
  assign or_3566 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3565_s3_q;
  logic or_3569;
  assign or_3569 = equal_3557_s3_q | (less_3559_s3_q | (less_3560_s3_q | or_3566));
  // hls/stages/patches.hpp:575
  logic not_3570;
  assign not_3570 = ~or_3569;
  // hls/stages/patches.hpp:556
  logic and_3571;
  assign and_3571 = equal_1928_s3_q & not_3570;
  // hls/stages/patches.hpp:184
  logic and_3574;
  assign and_3574 = equal_1762_s3_q & (less_1925_s3_q ? (not_1927_s3_q & and_3571) : and_3571);
  // hls/stages/patches.hpp:653
  logic not_3575;
  assign not_3575 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:556
  logic and_3577;
  assign and_3577 = equal_1928_s3_q & (patches_second_s3_q & not_3570);
  // hls/stages/patches.hpp:184
  logic and_3580;
  assign and_3580 = equal_1762_s3_q & (less_1925_s3_q ? (not_1927_s3_q & and_3577) : and_3577);
  // hls/stages/patches.hpp:653
  logic not_3581;
  assign not_3581 = ~and_3580;
  // hls/stages/patches.hpp:188
  logic and_3583;
  assign and_3583 = and_3574 & (not_3575 & not_3581);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3585;
  assign sum_3585 = {7'h0, and_3583} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:593
  logic [7:0] select_3611;
  assign select_3611 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:592
  logic [5:0] select_3612;
  assign select_3612 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3613;
  assign sum_3613 = {2'h0, select_3545_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3614;
  assign sum_3614 = {select_3612[5], select_3612} + {{3{sum_3613[3]}}, sum_3613};
  // hls/stages/patches.hpp:593
  logic [17:0] product_3615;
  assign product_3615 = $signed({{10{select_3611[7]}}, select_3611}) * $signed({{8{sum_3614[6]}}, sum_3614, select_3545_s3_q[2:0]});
  // hls/stages/patches.hpp:594
  logic [13:0] difference_3616;
  assign difference_3616 = {{6{select_3610_s3_q[7]}}, select_3610_s3_q} - {product_3615[17], product_3615[17:5]};
  // hls/stages/patches.hpp:600
  logic less_3617;
  assign less_3617 = $signed({{7{difference_3587[6]}}, difference_3587}) < $signed(difference_3616);
  // hls/stages/patches.hpp:556
  logic and_3620;
  assign and_3620 = equal_1928_s3_q & (not_3570 & (~less_3617));
  // hls/stages/patches.hpp:184
  logic and_3623;
  assign and_3623 = equal_1762_s3_q & (less_1925_s3_q ? (not_1927_s3_q & and_3620) : and_3620);
  // hls/stages/patches.hpp:656
  logic and_3624;
  assign and_3624 = and_3623 & and_3583;
  logic [7:0] sum_3625;
  assign sum_3625 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3624};
  // hls/stages/patches.hpp:556
  logic and_3629;
  assign and_3629 = not_3570 & (~($signed(difference_3616) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3630;
  assign and_3630 = equal_1928_s3_q & and_3629;
  // hls/stages/patches.hpp:184
  logic and_3633;
  assign and_3633 = equal_1762_s3_q & (less_1925_s3_q ? (not_1927_s3_q & and_3630) : and_3630);
  // hls/stages/patches.hpp:657
  logic and_3634;
  assign and_3634 = and_3633 & and_3583;
  logic [7:0] sum_3635;
  assign sum_3635 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3634};
  // hls/stages/patches.hpp:188
  logic and_3637;
  assign and_3637 = and_3574 & (and_3580 & not_3575);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3639;
  assign sum_3639 = {7'h0, and_3637} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:656
  logic and_3641;
  assign and_3641 = and_3623 & and_3637;
  logic [7:0] sum_3642;
  assign sum_3642 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3641};
  // hls/stages/patches.hpp:657
  logic and_3644;
  assign and_3644 = and_3633 & and_3637;
  logic [7:0] sum_3645;
  assign sum_3645 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3644};
  // hls/stages/patches.hpp:188
  logic and_3647;
  assign and_3647 = and_3574 & (patches_lower_s3_q & not_3581);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3649;
  assign sum_3649 = {7'h0, and_3647} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:656
  logic and_3651;
  assign and_3651 = and_3623 & and_3647;
  logic [7:0] sum_3652;
  assign sum_3652 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3651};
  // hls/stages/patches.hpp:657
  logic and_3654;
  assign and_3654 = and_3633 & and_3647;
  logic [7:0] sum_3655;
  assign sum_3655 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3654};
  // hls/stages/patches.hpp:188
  logic and_3657;
  assign and_3657 = and_3574 & (patches_lower_s3_q & and_3580);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3659;
  assign sum_3659 = {7'h0, and_3657} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:656
  logic and_3661;
  assign and_3661 = and_3623 & and_3657;
  logic [7:0] sum_3662;
  assign sum_3662 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3661};
  // hls/stages/patches.hpp:657
  logic and_3664;
  assign and_3664 = and_3633 & and_3657;
  logic [7:0] sum_3665;
  assign sum_3665 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3664};
  // hls/stages/agreement.hpp:1224
  logic equal_3666;
  assign equal_3666 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1131
  logic less_3667;
  assign less_3667 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:789
  logic and_3671;
  assign and_3671 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & (equal_3666 & less_3667)));
  // hls/stages/agreement.hpp:1143
  logic and_3676;
  assign and_3676 = x_s3_q[6] & (not_1961_s3_q & (less_3667 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:789
  logic and_3677;
  assign and_3677 = equal_557_s3_q & and_3676;
  // hls/stages/patches.hpp:619
  logic [7:0] or_3679;
  assign or_3679 = (and_3671 ? patches_quarters_0_places_q : 8'h0) | (and_3677 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1143
  logic and_3683;
  assign and_3683 = x_s3_q[6] & (not_1961_s3_q & (less_3667 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:789
  logic and_3684;
  assign and_3684 = equal_557_s3_q & and_3683;
  // hls/stages/agreement.hpp:1143
  logic and_3690;
  assign and_3690 = x_s3_q[6] & (not_1961_s3_q & (less_3667 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:789
  logic and_3691;
  assign and_3691 = equal_557_s3_q & and_3690;
  // hls/stages/patches.hpp:619
  logic [7:0] or_3693;
  assign or_3693 = (or_3679 | (and_3684 ? patches_quarters_2_places_q : 8'h0)) | (and_3691 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3697;
  assign select_3697 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:789
  logic and_3701;
  assign and_3701 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & (less_3667 & select_3697)));
  // hls/stages/patches.hpp:620
  logic [7:0] select_3703;
  assign select_3703 = and_3671 ? (and_3701 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3705;
  assign select_3705 = and_3677 ? (and_3701 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3708;
  assign select_3708 = and_3684 ? (and_3701 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3711;
  assign select_3711 = and_3691 ? (and_3701 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3714;
  assign select_3714 = and_3671 ? (and_3701 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3716;
  assign select_3716 = and_3677 ? (and_3701 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3719;
  assign select_3719 = and_3684 ? (and_3701 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3722;
  assign select_3722 = and_3691 ? (and_3701 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3724;
  assign sum_3724 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1143
  logic and_3728;
  assign and_3728 = x_s3_q[6] & (not_1961_s3_q & (less_3667 & (sum_3724[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_3729;
  assign and_3729 = equal_557_s3_q & and_3728;
  // hls/stages/patches.hpp:616
  logic [7:0] select_3732;
  assign select_3732 = and_3729 ? (patches_word_places_q + (and_3677 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3735;
  assign select_3735 = and_3729 ? (patches_word_up_q + (and_3677 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3738;
  assign select_3738 = and_3729 ? (patches_word_down_q + (and_3677 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:602
  logic [5:0] select_3742;
  assign select_3742 = ($signed(difference_3616[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3616[5:0];
  logic [5:0] select_3743;
  assign select_3743 = ($signed(14'h10) < $signed(difference_3616)) ? 6'h10 : select_3742;
  // hls/stages/patches.hpp:556
  logic [5:0] select_3745;
  assign select_3745 = equal_1928_s3_q ? (or_3569 ? 6'h0 : select_3743) : 6'h0;
  logic [5:0] select_3747;
  assign select_3747 = less_1925_s3_q ? (equal_1926_s3_q ? 6'h0 : select_3745) : select_3745;
  // hls/stages/patches.hpp:659
  logic [5:0] select_3749;
  assign select_3749 = and_3574 ? (equal_1762_s3_q ? select_3747 : 6'h0) : 6'h0;
  logic [11:0] sum_3750;
  assign sum_3750 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3749[5]}}, select_3749};
  // hls/stages/agreement.hpp:789
  logic and_3754;
  assign and_3754 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q & (equal_2859 & less_3667)));
  // hls/stages/agreement.hpp:1143
  logic and_3758;
  assign and_3758 = x_s3_q[6] & (not_1961_s3_q & (less_3667 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_3759;
  assign and_3759 = equal_557_s3_q & and_3758;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3761;
  assign select_3761 = and_3754 ? (and_3759 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:645
  logic or_3765;
  assign or_3765 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic or_3768;
  assign or_3768 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:647
  logic [8:0] sum_3769;
  assign sum_3769 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:642
  logic select_3771;
  assign select_3771 = and_3754 ? (and_3759 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3776;
  assign and_3776 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:642
  logic [2:0] select_3778;
  assign select_3778 = and_3759 ? {and_3776, patches_found_q[2:1]} : (and_3754 ? {and_3776, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:641
  logic or_3782;
  assign or_3782 = patches_partly_q | (patches_doubted_q & (~and_3759));
  // hls/stages/patches.hpp:642
  logic select_3785;
  assign select_3785 = and_3754 ? (and_3759 ? or_3782 : (and_3754 ? or_3782 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:640
  logic select_3786;
  assign select_3786 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:629
  logic [7:0] select_3790;
  assign select_3790 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:601
  logic [10:0] sum_3792;
  assign sum_3792 = {sum_3614[6], sum_3614, select_3545_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:556
  logic and_3795;
  assign and_3795 = equal_1928_s3_q & (not_3570 & ({{5{sum_3792[10]}}, sum_3792} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3798;
  assign and_3798 = equal_1762_s3_q & (less_1925_s3_q ? (not_1927_s3_q & and_3795) : and_3795);
  // hls/stages/patches.hpp:188
  logic and_3799;
  assign and_3799 = and_3574 & and_3798;
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3800;
  assign sum_3800 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3799};
  // hls/stages/patches.hpp:650
  logic [12:0] product_3801;
  assign product_3801 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3761};
  // hls/stages/patches.hpp:188
  logic and_3807;
  assign and_3807 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_3812;
  assign select_3812 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:630
  logic or_3816;
  assign or_3816 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:631
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:632
  logic select_3823;
  assign select_3823 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:633
  logic and_3829;
  assign and_3829 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3830;
  assign sum_3830 = patches_age_q + {9'h0, and_3829};
  logic [9:0] select_3833;
  assign select_3833 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3830)) : sum_3830;
  // hls/stages/agreement.hpp:1189
  logic or_3890;
  assign or_3890 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1218
  logic equal_3892;
  assign equal_3892 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1227
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1228
  logic select_3898;
  assign select_3898 = (equal_3892 & equal_3666) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1136
  logic [10:0] sum_3901;
  assign sum_3901 = {1'b0, select_2612} + {2'h0, select_2612[9:1]};
  logic select_3904;
  assign select_3904 = (select_2609[9:3] == 7'h0) ? ((~or_3890) & (~select_3898)) : (~({sum_3901, select_2612[0]} < {2'h0, select_2609}));
  // hls/stages/agreement.hpp:1143
  logic [47:0] select_3906;
  assign select_3906 = x_s3_q[6] ? (equal_1590_s3_q ? good_q : {select_3904, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:789
  logic select_3910;
  assign select_3910 = equal_557_s3_q ? ((x_s3_q[6] & good_known_q) | equal_2277_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1218
  logic equal_3911;
  assign equal_3911 = x_s3_q[6:3] == 4'ha;
  logic equal_3913;
  assign equal_3913 = x_s3_q[6:3] == 4'hc;
  logic equal_3914;
  assign equal_3914 = x_s3_q[6:3] == 4'hb;
  logic equal_3915;
  assign equal_3915 = x_s3_q[6:3] == 4'h9;
  logic equal_3916;
  assign equal_3916 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3918;
  assign select_3918 = equal_3915 ? counts_skin_unproven_q : (equal_3916 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3920;
  assign select_3920 = equal_3914 ? counts_regions_bad_q : (equal_3911 ? counts_nearer_q : select_3918);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3913 ? counts_on_skin_q : select_3920;
  // hls/stages/agreement.hpp:1223
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1231
  logic select_3923;
  assign select_3923 = (equal_3911 & equal_3666) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1149
  logic not_3924;
  assign not_3924 = ~hidden_for_q[7];
  logic [7:0] select_3926;
  assign select_3926 = select_3923 ? (hidden_for_q + {7'h0, not_3924}) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3928;
  assign select_3928 = equal_557_s3_q ? (equal_2277_s3_q ? select_3926 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_3929;
  assign select_3929 = equal_3666 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_3931;
  assign select_3931 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3933;
  assign select_3933 = equal_3916 ? cfg_unproven_skin_limit_i : (equal_3892 ? cfg_unproven_limit_i : select_3931);
  logic [7:0] select_3935;
  assign select_3935 = equal_3911 ? cfg_regions_limit_i : (equal_3915 ? cfg_hidden_limit_i : select_3933);
  logic [7:0] limit;
  assign limit = equal_3913 ? cfg_regions_limit_i : (equal_3914 ? {cfg_on_skin_limit_i, 3'h0} : select_3935);
  // hls/stages/agreement.hpp:1232
  logic not_3938;
  assign not_3938 = ~x_s3_q[2];
  logic [3:0] select_3939;
  assign select_3939 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3938, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3938};
  logic [7:0] select_3940;
  assign select_3940 = x_s3_q[0] ? {select_3939[3], 1'b0, select_3939[2], 1'b0, select_3939[1], 1'b0, select_3939[0], 1'b0} : {1'b0, select_3939[3], 1'b0, select_3939[2], 1'b0, select_3939[1], 1'b0, select_3939[0]};
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3944;
  assign select_3944 = equal_3915 ? counts_skin_supervised_q : (equal_3916 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3946;
  assign select_3946 = equal_3914 ? counts_skin_textured_q : (equal_3911 ? counts_textured_q : select_3944);
  logic [13:0] of;
  assign of = equal_3913 ? counts_textured_q : select_3946;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_3948;
  assign select_3948 = ((limit & select_3940) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3929} + {1'b0, select_3948};
  // hls/stages/agreement.hpp:789
  logic select_3953;
  assign select_3953 = equal_557_s3_q ? (equal_3666 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1229
  logic and_3958;
  assign and_3958 = too_much_q & (~(equal_3916 & equal_3666));
  // hls/stages/agreement.hpp:1230
  logic select_3963;
  assign select_3963 = (over[14] & equal_3666) ? (and_3958 | ((equal_3916 | equal_3915) | (x_s3_q[6:3] == 4'hf))) : and_3958;
  // hls/stages/agreement.hpp:1126
  logic and_3968;
  assign and_3968 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1232
  logic select_3969;
  assign select_3969 = (equal_3913 & equal_3666) ? and_3968 : overlooks_q;
  // hls/stages/agreement.hpp:789
  logic [2:0] select_3971;
  assign select_3971 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3973;
  assign select_3973 = equal_557_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_3971 : box_textured_columns_values_0_q);
  logic [2:0] select_3974;
  assign select_3974 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3976;
  assign select_3976 = equal_557_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_3974 : box_textured_columns_values_1_q);
  logic [2:0] select_3977;
  assign select_3977 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3979;
  assign select_3979 = equal_557_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_3977 : box_textured_columns_values_2_q);
  logic [2:0] select_3980;
  assign select_3980 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3982;
  assign select_3982 = equal_557_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_3980 : box_textured_columns_values_3_q);
  logic [2:0] select_3983;
  assign select_3983 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3985;
  assign select_3985 = equal_557_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_3983 : box_textured_columns_values_4_q);
  logic [4:0] select_3987;
  assign select_3987 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3989;
  assign select_3989 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3991;
  assign select_3991 = equal_557_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_3989 : box_explained_columns_values_0_q);
  logic [2:0] select_3992;
  assign select_3992 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3994;
  assign select_3994 = equal_557_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_3992 : box_explained_columns_values_1_q);
  logic [2:0] select_3995;
  assign select_3995 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3997;
  assign select_3997 = equal_557_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_3995 : box_explained_columns_values_2_q);
  logic [2:0] select_3998;
  assign select_3998 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4000;
  assign select_4000 = equal_557_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_3998 : box_explained_columns_values_3_q);
  logic [2:0] select_4001;
  assign select_4001 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4003;
  assign select_4003 = equal_557_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4001 : box_explained_columns_values_4_q);
  logic [4:0] select_4005;
  assign select_4005 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4008;
  assign select_4008 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4010;
  assign select_4010 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4012;
  assign select_4012 = equal_557_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4010 : box_shown_columns_values_1_q);
  logic [2:0] select_4013;
  assign select_4013 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4015;
  assign select_4015 = equal_557_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4013 : box_shown_columns_values_2_q);
  logic [2:0] select_4016;
  assign select_4016 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4018;
  assign select_4018 = equal_557_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4016 : box_shown_columns_values_3_q);
  logic [2:0] select_4019;
  assign select_4019 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4021;
  assign select_4021 = equal_557_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4019 : box_shown_columns_values_4_q);
  logic [4:0] select_4023;
  assign select_4023 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4026;
  assign select_4026 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4028;
  assign select_4028 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4030;
  assign select_4030 = equal_557_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4028 : box_nearer_columns_values_1_q);
  logic [2:0] select_4031;
  assign select_4031 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4033;
  assign select_4033 = equal_557_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4031 : box_nearer_columns_values_2_q);
  logic [2:0] select_4034;
  assign select_4034 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_557_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4034 : box_nearer_columns_values_3_q);
  logic [2:0] select_4037;
  assign select_4037 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4039;
  assign select_4039 = equal_557_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4037 : box_nearer_columns_values_4_q);
  logic [4:0] select_4041;
  assign select_4041 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1276
  logic select_4076;
  assign select_4076 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4078;
  assign select_4078 = left_first_s3_q ? done_s3_q : (and_1942_s3_q ? select_4076 : proven_q);
  // hls/stages/agreement.hpp:1309
  logic [1:0] select_4129;
  assign select_4129 = and_4128_s3_q ? {and_2098, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1310
  logic and_4130;
  assign and_4130 = select_4076 & less_4106;
  // hls/stages/agreement.hpp:438
  logic select_4133;
  assign select_4133 = and_2025_s3_q ? (less_2026_s3_q ? (select_4129[0] & and_4130) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4135;
  assign select_4135 = left_first_s3_q ? select_4133 : (and_1942_s3_q ? select_4133 : seen_q);
  logic select_4136;
  assign select_4136 = and_1942_s3_q ? select_4135 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4139;
  assign select_4139 = and_2025_s3_q ? (less_2026_s3_q ? (select_4129[1] & and_4130) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4141;
  assign select_4141 = left_first_s3_q ? select_4139 : (and_1942_s3_q ? select_4139 : nearer_q);
  logic select_4142;
  assign select_4142 = and_1942_s3_q ? select_4141 : nearer_q;
  // hls/stages/agreement.hpp:1240
  logic or_4150;
  assign or_4150 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1242
  logic not_4158;
  assign not_4158 = ~(or_3890 | not_4143);
  // hls/stages/agreement.hpp:789
  logic and_4162;
  assign and_4162 = equal_557_s3_q & (equal_2277_s3_q & (not_4158 & (select_3898 | select_3963)));
  logic and_4165;
  assign and_4165 = equal_2277_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1151
  logic or_4169;
  assign or_4169 = select_2412 | (select_2424 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:789
  logic and_4176;
  assign and_4176 = equal_557_s3_q & (equal_2277_s3_q & (not_4158 & (select_2418 | select_2430)));
  // hls/stages/agreement.hpp:1151
  logic and_4181;
  assign and_4181 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3926 < cfg_hidden_frames_i));
  logic select_4187;
  assign select_4187 = (not_4143 | (select_3969 & not_3803)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:789
  logic and_4196;
  assign and_4196 = equal_557_s3_q & (x_s3_q[6] & (not_1961_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4204;
  assign select_4204 = equal_1612_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4202_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4205;
  assign select_4205 = equal_1610_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4204;
  logic [31:0] select_4206;
  assign select_4206 = equal_1608_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4205;
  logic [31:0] select_4207;
  assign select_4207 = equal_1606_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4206;
  logic [31:0] select_4208;
  assign select_4208 = equal_1604_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4207;
  logic [31:0] select_4209;
  assign select_4209 = equal_1602_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4208;
  logic [31:0] select_4210;
  assign select_4210 = equal_1600_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4209;
  logic [31:0] select_4211;
  assign select_4211 = equal_1598_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4210;
  // hls/stages/agreement.hpp:1139
  logic [9:0] select_4212;
  assign select_4212 = less_2608 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1143
  logic [31:0] select_4213;
  assign select_4213 = equal_1590_s3_q ? select_4211 : {2'h0, select_4212, select_2612, select_2609};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_533_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_729_s3_q, and_728, less_723_s3_q, and_722_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_716, and_692_s3_q, and_691_s3_q, and_666_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q, less_640_s3_q, less_639_s3_q, less_638_s3_q, less_637_s3_q, less_636_s3_q, less_635_s3_q};
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
  assign registration_sums_waddr = {sum_1596_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1655_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1654, sum_1650};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1684_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1761_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1733_s3_q};
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
  assign patches_right_0_waddr = {select_1792_s3_q, select_1789};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1801);
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
  assign patches_right_1_waddr = {select_1792_s3_q, select_1818};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1821);
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
  assign patches_left_waddr = {select_1840, select_1839_s3_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1846);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1949;
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
  assign regions_waddr = {region_row_s3_q, or_1959_s3_q, or_1956_s3_q, or_1953_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_1993_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1992, sum_1982, sum_1977};
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
  assign map_waddr = sum_2034_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2108_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2098, is_seen};
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
      census_left_misses_q <= select_2257;
      sharpness_before_last_mask_q <= select_2326;
      sharpness_sums_detail_0_q <= and_533_s3_q ? select_2340 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_533_s3_q ? select_2352 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_533_s3_q ? sum_2356 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_533_s3_q ? sum_2360 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2378 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2388 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2390 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2392 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2394 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2396 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2401;
      sharpness_comparing_carry_1_q <= select_2405;
      sharpness_comparing_less_detail_0_q <= select_2412;
      sharpness_comparing_less_detail_1_q <= select_2418;
      sharpness_comparing_less_contrast_0_q <= select_2424;
      sharpness_comparing_less_contrast_1_q <= select_2430;
      counts_supervised_q <= select_2566;
      counts_textured_q <= and_2558_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2569});
      counts_explained_q <= and_2558_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2574});
      counts_nearer_q <= and_2558_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2579});
      counts_unproven_q <= and_2558_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2605});
      counts_regions_bad_q <= select_2621;
      counts_skin_supervised_q <= select_2628;
      counts_skin_textured_q <= select_2635;
      counts_skin_unproven_q <= select_2643;
      counts_on_skin_q <= select_2662;
      registration_half_across_q <= select_2740;
      registration_half_measured_q <= select_2745;
      registration_half_votes_down_q <= and_2718_s3_q ? 7'h0 : sum_2751;
      registration_half_votes_up_q <= and_2718_s3_q ? 7'h0 : sum_2759;
      registration_half_half_votes_down_q <= and_2718_s3_q ? 7'h0 : sum_2766;
      registration_half_half_votes_up_q <= and_2718_s3_q ? 7'h0 : sum_2773;
      registration_down_q <= and_2807 ? sum_2826 : registration_down_q;
      registration_up_q <= and_2807 ? sum_2835 : registration_up_q;
      registration_enough_q <= select_2849;
      registration_votes_down_q <= and_2854 ? less_2855 : registration_votes_down_q;
      registration_votes_up_q <= and_2854 ? less_2857 : registration_votes_up_q;
      registration_other_enough_q <= and_2863 ? select_2849 : registration_other_enough_q;
      registration_other_down_q <= and_2863 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2863 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_557_s3_q & and_2870)) & or_2895;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1780 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1782 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1783 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2979;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1809 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1811 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1812 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2984;
      patches_valid_0_q <= select_2989;
      patches_valid_1_q <= select_2994;
      patches_right_next_0_q <= select_2997;
      patches_right_next_1_q <= select_3000;
      patches_left_next_0_q <= select_3003;
      patches_left_next_1_q <= select_3006;
      patches_sums_values_0_q <= select_3430;
      patches_sums_values_1_q <= equal_1762_s3_q ? patches_sums_values_1_q : select_3431;
      patches_sums_values_2_q <= equal_1762_s3_q ? patches_sums_values_2_q : select_3433;
      patches_sums_values_3_q <= equal_1762_s3_q ? patches_sums_values_3_q : select_3435;
      patches_sums_values_4_q <= equal_1762_s3_q ? patches_sums_values_4_q : select_3437;
      patches_sums_values_5_q <= equal_1762_s3_q ? patches_sums_values_5_q : select_3439;
      patches_sums_values_6_q <= equal_1762_s3_q ? patches_sums_values_6_q : select_3441;
      patches_sums_values_7_q <= equal_1762_s3_q ? patches_sums_values_7_q : select_3443;
      patches_sums_values_8_q <= equal_1762_s3_q ? patches_sums_values_8_q : select_3445;
      patches_sums_values_9_q <= equal_1762_s3_q ? patches_sums_values_9_q : select_3447;
      patches_sums_values_10_q <= equal_1762_s3_q ? patches_sums_values_10_q : select_3449;
      patches_sums_values_11_q <= equal_1762_s3_q ? patches_sums_values_11_q : select_3451;
      patches_sums_values_12_q <= equal_1762_s3_q ? patches_sums_values_12_q : select_3453;
      patches_sums_values_13_q <= equal_1762_s3_q ? patches_sums_values_13_q : select_3455;
      patches_sums_values_14_q <= equal_1762_s3_q ? patches_sums_values_14_q : select_3457;
      patches_sums_values_15_q <= equal_1762_s3_q ? patches_sums_values_15_q : select_3459;
      patches_sums_values_16_q <= equal_1762_s3_q ? patches_sums_values_16_q : select_3461;
      patches_best_differing_q <= select_1949[9:0];
      patches_best_column_q <= select_1949[14:10];
      patches_quarters_0_places_q <= sum_3585;
      patches_quarters_0_up_q <= sum_3625;
      patches_quarters_0_down_q <= sum_3635;
      patches_quarters_1_places_q <= sum_3639;
      patches_quarters_1_up_q <= sum_3642;
      patches_quarters_1_down_q <= sum_3645;
      patches_quarters_2_places_q <= sum_3649;
      patches_quarters_2_up_q <= sum_3652;
      patches_quarters_2_down_q <= sum_3655;
      patches_quarters_3_places_q <= sum_3659;
      patches_quarters_3_up_q <= sum_3662;
      patches_quarters_3_down_q <= sum_3665;
      patches_word_places_q <= or_3693;
      patches_word_up_q <= ((select_3703 | select_3705) | select_3708) | select_3711;
      patches_word_down_q <= ((select_3714 | select_3716) | select_3719) | select_3722;
      patches_sum_places_q <= select_3732;
      patches_sum_up_q <= select_3735;
      patches_sum_down_q <= select_3738;
      patches_across_q <= sum_3750;
      patches_places_q <= select_3761;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3765;
      patches_partly_q <= or_3768;
      patches_clear_limit_q <= sum_3769[8:2];
      patches_complete_q <= select_3771;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3754 ? select_3778 : patches_found_q;
      patches_doubted_q <= select_3785;
      patches_doubted_before_q <= select_3786;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3790;
      patches_on_skin_q <= sum_3800;
      patches_on_skin_most_q <= product_3801[12:5];
      patches_large_q <= not_3803 & and_3807;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3812;
      patches_spoiled_q <= or_3816;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3823;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3833;
      segment_textured_q <= select_1974 + {5'h0, and_2569};
      segment_explained_q <= select_1979 + {5'h0, and_2574};
      segment_nearer_q <= select_1989 + {5'h0, and_2579};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_557_s3_q ? select_3906 : good_q;
      good_known_q <= select_3910;
      hidden_for_q <= select_3928;
      product_q <= equal_557_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3953;
      disagree_q <= equal_557_s3_q ? select_3898 : disagree_q;
      too_much_q <= equal_557_s3_q ? select_3963 : too_much_q;
      hides_q <= equal_557_s3_q ? select_3923 : hides_q;
      overlooks_q <= equal_557_s3_q ? select_3969 : overlooks_q;
      proven_q <= and_1942_s3_q ? select_4078 : proven_q;
      seen_q <= select_4136;
      nearer_q <= select_4142;
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
      averager_quarter_1_0_q <= select_2132;
      averager_quarter_1_1_q <= select_2134;
      averager_quarter_2_0_q <= select_2136;
      averager_quarter_2_1_q <= select_2138;
      averager_detail_0_q <= select_2150;
      averager_detail_1_q <= select_2158;
      census_changes_values_0_left_q <= and_533_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_533_s3_q ? sum_2241 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2243;
      census_changes_values_1_right_q <= select_2244;
      census_changes_values_2_left_q <= select_2245;
      census_changes_values_2_right_q <= select_2246;
      sharpness_last_mask_q <= and_533_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_533_s3_q ? select_2323[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_533_s3_q ? select_2323[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3973;
      box_textured_columns_values_1_q <= select_3976;
      box_textured_columns_values_2_q <= select_3979;
      box_textured_columns_values_3_q <= select_3982;
      box_textured_columns_values_4_q <= select_3985;
      box_textured_sum_sums_values_0_q <= equal_557_s3_q ? box_textured_sum_sums_values_0_q : select_3987;
      box_explained_columns_values_0_q <= select_3991;
      box_explained_columns_values_1_q <= select_3994;
      box_explained_columns_values_2_q <= select_3997;
      box_explained_columns_values_3_q <= select_4000;
      box_explained_columns_values_4_q <= select_4003;
      box_explained_sum_sums_values_0_q <= equal_557_s3_q ? box_explained_sum_sums_values_0_q : select_4005;
      box_shown_columns_values_0_q <= equal_557_s3_q ? box_shown_columns_values_0_q : select_4008;
      box_shown_columns_values_1_q <= select_4012;
      box_shown_columns_values_2_q <= select_4015;
      box_shown_columns_values_3_q <= select_4018;
      box_shown_columns_values_4_q <= select_4021;
      box_shown_sum_sums_values_0_q <= equal_557_s3_q ? box_shown_sum_sums_values_0_q : select_4023;
      box_nearer_columns_values_0_q <= equal_557_s3_q ? box_nearer_columns_values_0_q : select_4026;
      box_nearer_columns_values_1_q <= select_4030;
      box_nearer_columns_values_2_q <= select_4033;
      box_nearer_columns_values_3_q <= select_4036;
      box_nearer_columns_values_4_q <= select_4039;
      box_nearer_sum_sums_values_0_q <= equal_557_s3_q ? box_nearer_sum_sums_values_0_q : select_4041;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4080_s4_q;
  logic or_4144_s4_q;
  logic and_4145_s4_q;
  logic and_4153_s4_q;
  logic and_4156_s4_q;
  logic and_4162_s4_q;
  logic and_4166_s4_q;
  logic and_4172_s4_q;
  logic and_4176_s4_q;
  logic and_4184_s4_q;
  logic and_4189_s4_q;
  logic and_4192_s4_q;
  logic and_4196_s4_q;
  logic [5:0] select_4198_s4_q;
  logic [31:0] select_4215_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4080_s4_q <= said_q;
      or_4144_s4_q <= not_4143 | select_4136;
      and_4145_s4_q <= cfg_prove_i & select_4142;
      and_4153_s4_q <= equal_557_s3_q & (equal_2277_s3_q & (cfg_prove_i & or_4150));
      and_4156_s4_q <= equal_557_s3_q & (equal_2277_s3_q & (cfg_prove_i & or_3890));
      and_4162_s4_q <= and_4162;
      and_4166_s4_q <= equal_557_s3_q & and_4165;
      and_4172_s4_q <= equal_557_s3_q & (equal_2277_s3_q & (not_4158 & or_4169));
      and_4176_s4_q <= and_4176;
      and_4184_s4_q <= equal_557_s3_q & (equal_2277_s3_q & (cfg_prove_i & and_4181));
      and_4189_s4_q <= equal_557_s3_q & (equal_2277_s3_q & select_4187);
      and_4192_s4_q <= and_4192_s3_q;
      and_4196_s4_q <= and_4196;
      select_4198_s4_q <= equal_557_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4215_s4_q <= equal_557_s3_q ? (x_s3_q[6] ? select_4213 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4144_s4_q;
  assign marks_nearer_o = and_4145_s4_q;
  assign verdict_valid_o = and_4080_s4_q;
  assign verdict_unproven_yet_o = and_4153_s4_q;
  assign verdict_untextured_o = and_4156_s4_q;
  assign verdict_disagree_o = and_4162_s4_q;
  assign verdict_moved_o = and_4166_s4_q;
  assign verdict_unsharp_left_o = and_4172_s4_q;
  assign verdict_unsharp_right_o = and_4176_s4_q;
  assign verdict_hidden_o = and_4184_s4_q;
  assign verdict_overlooked_o = and_4189_s4_q;
  assign verdict_out_of_step_o = and_4192_s4_q;
  assign frame_valid_o = and_4196_s4_q;
  assign frame_index_o = select_4198_s4_q;
  assign frame_word_o = select_4215_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3801[4:0], sum_3769[1:0], sum_3724[1:0], product_3615[4:0], sum_2708[0], difference_2649[1:0], detail_4[1:0], detail_3[1:0], sum_2251[4:0], sum_1700[0], sum_1696[0], sum_714[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
