// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2094 bits, pipeline 977 bits, memories 31282 bits.
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
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_2616;
  assign sum_2616 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2875;
  assign difference_2875 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3107;
  assign less_3107 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3108;
  assign sum_3108 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3109;
  assign select_3109 = less_3107 ? {sum_3108, cfg_height_i[5:3]} : 8'h0;
  logic not_3144;
  assign not_3144 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic left_first_q;
  logic right_q;
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic sample_of_skin_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [5:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_first_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [7:0] averager_place_q;
  logic averager_running_mask_q;
  logic [4:0] rows_passed_above_q;
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
  logic [5:0] row_q;
  logic [5:0] least_q;
  logic [6:0] whole_q;
  logic [6:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  logic lower_half_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_377;
  assign select_377 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_379;
  assign select_379 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [7:0] select_382;
  assign select_382 = ({select_379, select_377} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:95
  logic [7:0] select_383;
  assign select_383 = select_377[0] ? averager_place_q : select_382;
  // hls/stages/census.hpp:40
  logic or_384;
  assign or_384 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:213
  logic and_390;
  assign and_390 = (~((~or_384) | (~select_377[0]))) & (select_383 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_395;
  assign select_395 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = select_377[0] ? (sample_present_q & averager_running_mask_q) : sample_present_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_379 : 6'h0;
  // hls/stages/census.hpp:45
  logic equal_412;
  assign equal_412 = select_377 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_413;
  assign equal_413 = select_395 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_414;
  assign and_414 = equal_413 & and_390;
  // hls/stages/agreement.hpp:215
  logic and_416;
  assign and_416 = sample_pair_whole_q & (equal_412 & and_414);
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_436;
  assign equal_436 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:391
  logic or_437;
  assign or_437 = so | equal_436;
  // hls/stages/agreement.hpp:527
  logic not_438;
  assign not_438 = ~or_437;
  // hls/stages/agreement.hpp:397
  logic equal_439;
  assign equal_439 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_441;
  assign equal_441 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:389
  logic [7:0] sum_442;
  assign sum_442 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_443;
  assign select_443 = run_shift_q[5] ? x_q : sum_442;
  logic less_444;
  assign less_444 = {2'h0, last_q} < select_443;
  // hls/stages/agreement.hpp:163
  logic not_445;
  assign not_445 = ~less_444;
  // hls/stages/agreement.hpp:551
  logic and_446;
  assign and_446 = equal_441 & not_445;
  logic and_448;
  assign and_448 = not_438 & ((~equal_439) & and_446);
  // hls/stages/agreement.hpp:309
  logic equal_474;
  assign equal_474 = column == 6'h0;
  // hls/stages/census.hpp:40
  logic [5:0] select_475;
  assign select_475 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_475 : 6'h0;
  // hls/stages/agreement.hpp:309
  logic equal_477;
  assign equal_477 = row == 6'h0;
  logic [3:0] select_478;
  assign select_478 = equal_477 ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_479;
  assign select_479 = equal_474 ? {select_478, 1'b1} : rows_passed_above_q;
  // hls/stages/agreement.hpp:551
  logic select_532;
  assign select_532 = equal_439 ? not_445 : and_446;
  // hls/stages/agreement.hpp:597
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:594
  logic [6:0] sum_552;
  assign sum_552 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:191
  logic and_557;
  assign and_557 = equal_439 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_552} < select_443))));
  logic select_558;
  assign select_558 = or_437 ? not_445 : and_557;
  // hls/stages/agreement.hpp:602
  logic equal_561;
  assign equal_561 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:606
  logic or_563;
  assign or_563 = equal_561 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:618
  logic [5:0] right;
  assign right = sum_442[5:0] + 6'h3d;
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1434;
  assign sum_1434 = slot_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:747
  logic [4:0] sum_1465;
  assign sum_1465 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/registration.hpp:249
  logic equal_1482;
  assign equal_1482 = sum_1434 == 2'h0;
  // hls/stages/registration.hpp:248
  logic not_1487;
  assign not_1487 = ~sum_1434[0];
  // hls/stages/registration.hpp:250
  logic [8:0] select_1489;
  assign select_1489 = equal_1482 ? 9'h188 : ({7'h62, not_1487, 1'b1} + 9'h1);
  // hls/stages/agreement.hpp:135
  logic and_1521;
  assign and_1521 = ends_cell_q & so;
  // hls/stages/registration.hpp:250
  logic select_1758;
  assign select_1758 = select_1489[1] ? (final_row_q & select_1489[0]) : (and_1521 & (~select_1489[0]));
  logic select_1759;
  assign select_1759 = select_1489[0] ? so : ends_q;
  logic [2:0] select_1761;
  assign select_1761 = select_1489[1] ? {2'h0, select_1759} : (select_1489[0] ? {2'h0, ends_cell_q} : slot_q);
  logic [2:0] select_1762;
  assign select_1762 = select_1489[2] ? {2'h0, select_1758} : select_1761;
  logic [6:0] select_1764;
  assign select_1764 = select_1489[0] ? whole_q : {1'b0, least_q};
  logic [7:0] select_1765;
  assign select_1765 = select_1489[1] ? (select_1489[0] ? {age_q, 1'b1} : {1'b0, drawn_q}) : {1'b0, select_1764};
  logic [5:0] select_1766;
  assign select_1766 = select_1489[0] ? row_q : last_q;
  logic [7:0] select_1768;
  assign select_1768 = select_1489[1] ? {2'h0, select_1766} : (select_1489[0] ? columns_left_q : x_q);
  logic [7:0] select_1770;
  assign select_1770 = select_1489[3] ? {5'h0, select_1762} : (select_1489[2] ? select_1765 : select_1768);
  // hls/stages/agreement.hpp:421
  logic [7:0] select_1774;
  assign select_1774 = (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
  // hls/stages/agreement.hpp:423
  logic not_1775;
  assign not_1775 = ~run_shift_q[5];
  logic [6:0] difference_1777;
  assign difference_1777 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_1778;
  assign select_1778 = equal_439 ? ({{7{not_1775}}, 1'b1} + run_span_q) : {difference_1777[6], difference_1777};
  // hls/stages/agreement.hpp:422
  logic [5:0] select_1782;
  assign select_1782 = equal_439 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
  // hls/stages/agreement.hpp:399
  logic select_1784;
  assign select_1784 = equal_439 ? (~run_last_shift_q) : equal_441;
  // hls/stages/agreement.hpp:416
  logic [7:0] select_1785;
  assign select_1785 = select_1784 ? plan_columns_q : 8'h0;
  // hls/stages/agreement.hpp:403
  logic equal_1786;
  assign equal_1786 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:406
  logic equal_1787;
  assign equal_1787 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:416
  logic [6:0] or_1790;
  assign or_1790 = select_1785[6:0] | ((equal_1786 | equal_1787) ? whole_q : 7'h0);
  // hls/stages/agreement.hpp:146
  logic and_1791;
  assign and_1791 = run_last_shift_q & equal_439;
  // hls/stages/agreement.hpp:416
  logic [1:0] or_1792;
  assign or_1792 = {2{and_1791}} | or_1790[3:2];
  // hls/stages/agreement.hpp:417
  logic [6:0] or_1794;
  assign or_1794 = {or_1790[6:4], or_1792, or_1790[1:0]} | (equal_436 ? drawn_q : 7'h0);
  logic [4:0] or_1795;
  assign or_1795 = {5{so}} | {or_1794[6], or_1794[3:0]};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1796;
  assign select_1796 = select_1489[0] ? {{2{select_1782[5]}}, select_1782} : {select_1785[7], or_1795[4], or_1794[5:4], or_1795[3:0]};
  logic [7:0] select_1797;
  assign select_1797 = select_1489[1] ? (select_1489[0] ? select_1774 : select_1778) : select_1796;
  // hls/stages/agreement.hpp:413
  logic [6:0] value_2;
  assign value_2 = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_1800;
  assign select_1800 = (plan_shift_q[5] & select_1784) ? value_2 : 7'h0;
  logic [1:0] or_1801;
  assign or_1801 = {2{so}} | select_1800[5:4];
  // hls/stages/registration.hpp:250
  logic [7:0] select_1802;
  assign select_1802 = select_1489[0] ? {{2{select_1800[6]}}, or_1801, select_1800[3:0]} : plan_span_q;
  // hls/stages/agreement.hpp:146
  logic and_1804;
  assign and_1804 = select_1784 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:410
  logic [5:0] select_1805;
  assign select_1805 = select_1784 ? plan_shift_q : 6'h0;
  // hls/stages/registration.hpp:250
  logic [5:0] select_1806;
  assign select_1806 = select_1489[0] ? {5'h0, and_1804} : select_1805;
  logic [7:0] select_1807;
  assign select_1807 = select_1489[1] ? select_1802 : {{2{select_1806[5]}}, select_1806};
  // hls/stages/agreement.hpp:403
  logic not_1811;
  assign not_1811 = ~select_1784;
  // hls/stages/agreement.hpp:146
  logic and_1813;
  assign and_1813 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_1814;
  assign select_1814 = equal_1787 ? 2'h1 : {2{and_1813}};
  logic [2:0] select_1816;
  assign select_1816 = (and_1791 | (select_1784 | equal_1786)) ? (equal_1786 ? 3'h2 : {not_1811, {2{select_1784}}}) : (equal_436 ? 3'h6 : {select_1814[0], select_1814});
  // hls/stages/registration.hpp:250
  logic [2:0] select_1817;
  assign select_1817 = select_1489[0] ? select_1816 : 3'h0;
  logic [7:0] select_1819;
  assign select_1819 = select_1489[1] ? {5'h0, select_1817} : (select_1489[0] ? 8'h0 : run_span_q);
  logic [4:0] select_1821;
  assign select_1821 = select_1489[0] ? {2'h0, run_phase_q} : rows_passed_above_q;
  logic [5:0] select_1822;
  assign select_1822 = select_1489[1] ? (select_1489[0] ? {5'h0, run_last_shift_q} : run_shift_q) : {1'b0, select_1821};
  logic [7:0] select_1823;
  assign select_1823 = select_1489[2] ? select_1819 : {{2{select_1822[5]}}, select_1822};
  logic [7:0] select_1824;
  assign select_1824 = select_1489[3] ? (select_1489[2] ? select_1797 : select_1807) : select_1823;
  logic [7:0] select_2112;
  assign select_2112 = select_1489[0] ? {7'h0, averager_running_mask_q} : averager_place_q;
  logic select_2133;
  assign select_2133 = select_1489[0] ? raster_final_row_q : raster_row_ended_q;
  logic [7:0] select_2134;
  assign select_2134 = select_1489[0] ? {7'h0, raster_rows_left_q[8]} : raster_rows_left_q[7:0];
  logic select_2138;
  assign select_2138 = select_1489[0] ? raster_at_live_q : raster_at_first_q;
  logic [5:0] select_2140;
  assign select_2140 = select_1489[1] ? {5'h0, select_2138} : (select_1489[0] ? raster_at_row_q : raster_at_column_q);
  logic select_2142;
  assign select_2142 = select_1489[0] ? sample_of_skin_q : sample_present_q;
  logic [2:0] select_2143;
  assign select_2143 = select_1489[1] ? (select_1489[0] ? raster_at_y_q : raster_at_x_q) : {2'h0, select_2142};
  // hls/stages/agreement.hpp:123
  logic and_2149;
  assign and_2149 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:211
  logic and_2316;
  assign and_2316 = ((6'h6 < row_q) & (~(x_q[7:2] == 6'h0))) & (~({1'b0, sum_1465, last_q[1:0]} < x_q));
  // hls/stages/agreement.hpp:215
  logic [2:0] select_2324;
  assign select_2324 = sample_pair_whole_q ? (sample_last_q ? (select_395 + 3'h1) : select_395) : raster_at_y_q;
  logic [5:0] select_2326;
  assign select_2326 = sample_pair_whole_q ? (select_379 + {5'h0, equal_412}) : raster_at_column_q;
  logic [5:0] select_2329;
  assign select_2329 = sample_pair_whole_q ? (sample_last_q ? (select_475 + {5'h0, equal_413}) : select_475) : raster_at_row_q;
  logic select_2334;
  assign select_2334 = sample_pair_whole_q ? (sample_last_q ? (or_384 & (~raster_final_row_q)) : or_384) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_2336;
  assign select_2336 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:215
  logic select_2340;
  assign select_2340 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:313
  logic equal_2560;
  assign equal_2560 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:318
  logic and_2561;
  assign and_2561 = and_416 & equal_2560;
  // hls/stages/agreement.hpp:368
  logic select_2564;
  assign select_2564 = (and_2561 | (~ends_cell_q)) ? and_2561 : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_2564 ? (and_2561 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_2568;
  assign select_2568 = select_2564 ? (and_2561 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2571;
  assign select_2571 = select_2564 ? (following_last_shift_q & (~and_2561)) : run_last_shift_q;
  // hls/stages/agreement.hpp:368
  logic [6:0] select_2574;
  assign select_2574 = and_2561 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_2576;
  assign select_2576 = select_2564 ? {select_2574[6], select_2574} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2579;
  assign select_2579 = select_2564 ? (and_2561 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:365
  logic [5:0] select_2587;
  assign select_2587 = and_416 ? (equal_2560 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2590;
  assign select_2590 = and_416 ? (equal_2560 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2593;
  assign select_2593 = and_416 ? (equal_2560 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_2607;
  assign select_2607 = (ends_cell_q | select_2564) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_439 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_2611;
  assign and_2611 = (~select_2564) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:329
  logic [6:0] sum_2612;
  assign sum_2612 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:314
  logic select_2614;
  assign select_2614 = equal_2560 ? ({sum_2612[6], cfg_height_i[8:3]} == {1'b0, sum_2612[5:0]}) : final_row_q;
  logic select_2619;
  assign select_2619 = equal_2560 ? (~({row, 1'b0} < {sum_2616, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_2751;
  assign and_2751 = and_416 & (equal_2560 & (row[5:2] == 4'h0));

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1071; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_448;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1072; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_437 ? not_445 : select_532);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1073; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_439 ? sum_442[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_438 & select_532);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1074; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_437 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_558;
  logic [45:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_first_q <= 1'b0;
      right_q <= 1'b0;
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      sample_of_skin_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 6'h0;
      raster_at_row_q <= 6'h0;
      raster_at_first_q <= 1'b0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 8'h0;
      averager_running_mask_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
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
      row_q <= 6'h0;
      least_q <= 6'h0;
      whole_q <= 7'h0;
      drawn_q <= 7'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      lower_half_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_2149 ? left_first_q : marks_first_i;
      right_q <= (~and_2149) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_2149;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      sample_of_skin_q <= mask_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_377 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2324;
      raster_at_column_q <= select_2326;
      raster_at_row_q <= select_2329;
      raster_at_first_q <= sample_pair_whole_q ? sample_pair_first_q : raster_at_first_q;
      raster_at_live_q <= select_2334;
      raster_rows_left_q <= sample_pair_whole_q ? select_2336 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2340;
      averager_place_q <= sample_pair_whole_q ? select_383 : averager_place_q;
      averager_running_mask_q <= sample_pair_whole_q ? whole : averager_running_mask_q;
      rows_passed_above_q <= and_416 ? select_479 : rows_passed_above_q;
      run_phase_q <= now;
      run_shift_q <= select_2568;
      run_last_shift_q <= select_2571;
      run_span_q <= select_2564 ? (and_2561 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_1816;
      following_shift_q <= select_1805;
      following_last_shift_q <= and_1804;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_1800[6], or_1801, select_1800[3:0]};
      following_columns_q <= {select_1785[7], or_1795[4], or_1794[5:4], or_1795[3:0]};
      plan_shift_q <= select_1782;
      plan_span_q <= select_1778;
      plan_columns_q <= select_1774;
      x_q <= select_2576;
      columns_left_q <= select_2579;
      last_q <= and_416 ? (equal_2560 ? column : last_q) : last_q;
      row_q <= and_416 ? (equal_2560 ? row : row_q) : row_q;
      least_q <= select_2587;
      whole_q <= select_2590;
      drawn_q <= select_2593;
      age_q <= select_2564 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2564 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2607;
      ends_q <= and_2611;
      final_row_q <= and_416 ? select_2614 : final_row_q;
      lower_half_q <= and_416 ? select_2619 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_of_skin_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic lower_half_s1_q;
  logic select_377_s1_q;
  logic [7:0] select_383_s1_q;
  logic and_390_s1_q;
  logic equal_396_s1_q;
  logic whole_s1_q;
  logic [5:0] column_s1_q;
  logic and_414_s1_q;
  logic and_416_s1_q;
  logic equal_419_s1_q;
  logic so_s1_q;
  logic equal_436_s1_q;
  logic or_437_s1_q;
  logic equal_439_s1_q;
  logic less_444_s1_q;
  logic not_445_s1_q;
  logic and_448_s1_q;
  logic equal_474_s1_q;
  logic equal_477_s1_q;
  logic select_479_s1_q;
  logic not_536_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_558_s1_q;
  logic select_565_s1_q;
  logic and_1367_s1_q;
  logic [5:0] right_s1_q;
  logic select_1374_s1_q;
  logic equal_1383_s1_q;
  logic not_1388_s1_q;
  logic [1:0] sum_1434_s1_q;
  logic less_1466_s1_q;
  logic equal_1482_s1_q;
  logic [8:0] select_1489_s1_q;
  logic and_1521_s1_q;
  logic less_1541_s1_q;
  logic [7:0] select_1770_s1_q;
  logic [7:0] select_1824_s1_q;
  logic [7:0] select_2112_s1_q;
  logic [7:0] select_2135_s1_q;
  logic [5:0] select_2144_s1_q;
  logic select_2145_s1_q;
  logic equal_2180_s1_q;
  logic and_2318_s1_q;
  logic equal_2506_s1_q;
  logic equal_2560_s1_q;
  logic and_2752_s1_q;
  logic and_2754_s1_q;
  logic less_2860_s1_q;
  logic equal_3057_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_of_skin_s1_q <= sample_of_skin_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      lower_half_s1_q <= lower_half_q;
      select_377_s1_q <= select_377[0];
      select_383_s1_q <= select_383;
      and_390_s1_q <= and_390;
      equal_396_s1_q <= select_395 == 3'h0;
      whole_s1_q <= whole;
      column_s1_q <= column;
      and_414_s1_q <= and_414;
      and_416_s1_q <= and_416;
      equal_419_s1_q <= select_377 == 3'h1;
      so_s1_q <= so;
      equal_436_s1_q <= equal_436;
      or_437_s1_q <= or_437;
      equal_439_s1_q <= equal_439;
      less_444_s1_q <= less_444;
      not_445_s1_q <= not_445;
      and_448_s1_q <= and_448;
      equal_474_s1_q <= equal_474;
      equal_477_s1_q <= equal_477;
      select_479_s1_q <= select_479[4];
      not_536_s1_q <= ~(row_q == 6'h0);
      x_s1_2_q <= x[6:0];
      select_558_s1_q <= select_558;
      select_565_s1_q <= or_563 ? equal_561 : (~age_q[3]);
      and_1367_s1_q <= not_438 & and_557;
      right_s1_q <= right;
      select_1374_s1_q <= or_563 ? equal_561 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1383_s1_q <= run_phase_q == 3'h7;
      not_1388_s1_q <= ~(row_q[5:3] == 3'h0);
      sum_1434_s1_q <= sum_1434;
      less_1466_s1_q <= {2'h0, sum_1465, last_q[1]} < x_q;
      equal_1482_s1_q <= equal_1482;
      select_1489_s1_q <= select_1489;
      and_1521_s1_q <= and_1521;
      less_1541_s1_q <= 5'h4 < row_q[5:1];
      select_1770_s1_q <= select_1770;
      select_1824_s1_q <= select_1824;
      select_2112_s1_q <= select_2112;
      select_2135_s1_q <= select_1489[1] ? {7'h0, select_2133} : select_2134;
      select_2144_s1_q <= select_1489[2] ? select_2140 : {3'h0, select_2143};
      select_2145_s1_q <= select_1489[0] ? sample_last_q : sample_pair_whole_q;
      equal_2180_s1_q <= x_q == {2'h0, last_q};
      and_2318_s1_q <= so & (ends_cell_q & and_2316);
      equal_2506_s1_q <= (column | row) == 6'h0;
      equal_2560_s1_q <= equal_2560;
      and_2752_s1_q <= and_2561 & and_2751;
      and_2754_s1_q <= and_2561 & (~and_2751);
      less_2860_s1_q <= 5'h2 < row[5:1];
      equal_3057_s1_q <= row[5:3] == 3'h0;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:98
  logic and_391;
  assign and_391 = sample_pair_whole_s1_q & and_390_s1_q;
  // hls/stages/agreement.hpp:452
  logic and_537;
  assign and_537 = left_rdata_q[12] & not_536_s1_q;
  logic and_538;
  assign and_538 = left_rdata_q[28] & not_536_s1_q;
  logic and_539;
  assign and_539 = left_rdata_q[44] & not_536_s1_q;
  logic and_540;
  assign and_540 = left_rdata_q[60] & not_536_s1_q;
  // hls/stages/agreement.hpp:453
  logic and_544;
  assign and_544 = right_codes_rdata_q[12] & not_536_s1_q;
  logic and_545;
  assign and_545 = right_codes_rdata_q[25] & not_536_s1_q;
  logic and_546;
  assign and_546 = right_codes_rdata_q[38] & not_536_s1_q;
  logic and_547;
  assign and_547 = right_codes_rdata_q[51] & not_536_s1_q;
  logic and_548;
  assign and_548 = right_codes_rdata_q[64] & not_536_s1_q;
  logic and_549;
  assign and_549 = right_codes_rdata_q[77] & not_536_s1_q;
  // hls/stages/agreement.hpp:159
  logic and_571;
  assign and_571 = left_rdata_q[44] & not_445_s1_q;
  logic and_572;
  assign and_572 = right_codes_rdata_q[38] & not_445_s1_q;
  logic [11:0] select_573;
  assign select_573 = less_444_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_574;
  assign select_574 = less_444_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_578;
  assign select_578 = and_571 ? (and_572 ? (~(select_573 ^ select_574)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_584;
  assign parity_584 = ^select_578[5:3];
  logic parity_587;
  assign parity_587 = ^select_578[8:6];
  logic parity_590;
  assign parity_590 = ^select_578[11:3];
  // hls/stages/agreement.hpp:159
  logic and_594;
  assign and_594 = left_rdata_q[60] & not_445_s1_q;
  logic and_595;
  assign and_595 = right_codes_rdata_q[51] & not_445_s1_q;
  logic [11:0] select_596;
  assign select_596 = less_444_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_597;
  assign select_597 = less_444_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_601;
  assign select_601 = and_594 ? (and_595 ? (~(select_596 ^ select_597)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_604;
  assign parity_604 = ^select_601[8:6];
  logic parity_607;
  assign parity_607 = ^select_601[11:9];
  // hls/stages/agreement.hpp:159
  logic and_611;
  assign and_611 = left_rdata_q[76] & not_445_s1_q;
  logic and_612;
  assign and_612 = right_codes_rdata_q[64] & not_445_s1_q;
  logic [11:0] select_613;
  assign select_613 = less_444_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_614;
  assign select_614 = less_444_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_618;
  assign select_618 = and_611 ? (and_612 ? (~(select_613 ^ select_614)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_624;
  assign parity_624 = ^select_618[2:0];
  logic parity_627;
  assign parity_627 = ^select_618[5:3];
  logic parity_630;
  assign parity_630 = ^select_618[8:0];
  logic parity_636;
  assign parity_636 = ^select_618[11:9];
  logic parity_639;
  assign parity_639 = ^select_601[2:0];
  logic parity_642;
  assign parity_642 = ^{select_618[11:9], select_601[5:0]};
  logic parity_645;
  assign parity_645 = ^{select_618, select_601, select_578[2:0]};
  logic xor_646;
  assign xor_646 = parity_590 ^ parity_645;
  // hls/stages/agreement.hpp:479
  logic or_650;
  assign or_650 = (select_578[1:0] == 2'h3) | (select_578[2] & (select_578[0] | select_578[1]));
  // hls/stages/agreement.hpp:481
  logic or_654;
  assign or_654 = (select_601[7:6] == 2'h3) | (select_601[8] & (select_601[6] | select_601[7]));
  logic or_658;
  assign or_658 = (select_601[10:9] == 2'h3) | (select_601[11] & (select_601[9] | select_601[10]));
  // hls/stages/agreement.hpp:479
  logic or_666;
  assign or_666 = (select_618[7:6] == 2'h3) | (select_618[8] & (~(select_618[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_670;
  assign or_670 = (select_618[1:0] == 2'h3) | (select_618[2] & (select_618[0] | select_618[1]));
  logic or_674;
  assign or_674 = (select_618[4:3] == 2'h3) | (select_618[5] & (select_618[3] | select_618[4]));
  // hls/stages/agreement.hpp:480
  logic parity_677;
  assign parity_677 = ^{or_674, or_670, or_666};
  // hls/stages/agreement.hpp:479
  logic or_681;
  assign or_681 = (select_601[4:3] == 2'h3) | (select_601[5] & (select_601[3] | select_601[4]));
  // hls/stages/agreement.hpp:481
  logic or_685;
  assign or_685 = (select_618[10:9] == 2'h3) | (select_618[11] & (select_618[9] | select_618[10]));
  logic or_689;
  assign or_689 = (select_601[1:0] == 2'h3) | (select_601[2] & (select_601[0] | select_601[1]));
  // hls/stages/agreement.hpp:480
  logic parity_692;
  assign parity_692 = ^{or_689, or_685, or_681};
  logic parity_695;
  assign parity_695 = ^{or_689, or_685, or_681, or_674, or_670, or_666, or_658, or_654, or_650};
  // hls/stages/agreement.hpp:481
  logic and_696;
  assign and_696 = parity_590 & parity_645;
  logic or_700;
  assign or_700 = (parity_584 & parity_587) | ((^select_578[11:9]) & (parity_584 | parity_587));
  logic and_703;
  assign and_703 = (^{select_601[11:6], select_578[2:0]}) & (parity_630 | parity_642);
  logic or_704;
  assign or_704 = (parity_630 & parity_642) | and_703;
  // hls/stages/agreement.hpp:479
  logic or_711;
  assign or_711 = (select_578[10:9] == 2'h3) | (select_578[11] & (select_578[9] | select_578[10]));
  // hls/stages/agreement.hpp:481
  logic or_715;
  assign or_715 = (select_578[4:3] == 2'h3) | (select_578[5] & (select_578[3] | select_578[4]));
  logic or_719;
  assign or_719 = (select_578[7:6] == 2'h3) | (select_578[8] & (select_578[6] | select_578[7]));
  // hls/stages/agreement.hpp:480
  logic parity_722;
  assign parity_722 = ^{or_719, or_715, or_711};
  // hls/stages/agreement.hpp:481
  logic or_726;
  assign or_726 = (parity_604 & parity_607) | ((^select_578[2:0]) & (parity_604 | parity_607));
  logic or_730;
  assign or_730 = (parity_624 & parity_627) | ((^select_618[8:6]) & (parity_624 | parity_627));
  logic or_734;
  assign or_734 = (parity_636 & parity_639) | ((^select_601[5:3]) & (parity_636 | parity_639));
  // hls/stages/agreement.hpp:480
  logic parity_737;
  assign parity_737 = ^{or_734, or_730, or_726};
  logic parity_740;
  assign parity_740 = ^{or_734, or_730, or_726, or_719, or_715, or_711, or_704, or_700, and_696};
  logic xor_741;
  assign xor_741 = parity_695 ^ parity_740;
  // hls/stages/agreement.hpp:481
  logic and_742;
  assign and_742 = parity_695 & parity_740;
  logic or_746;
  assign or_746 = (parity_677 & parity_692) | ((^{or_658, or_654, or_650}) & (parity_677 | parity_692));
  logic or_750;
  assign or_750 = (parity_722 & parity_737) | ((^{or_704, or_700, and_696}) & (parity_722 | parity_737));
  logic or_757;
  assign or_757 = (or_654 & or_658) | (or_650 & (or_654 | or_658));
  logic or_761;
  assign or_761 = (or_670 & or_674) | (or_666 & (or_670 | or_674));
  logic or_765;
  assign or_765 = (or_685 & or_689) | (or_681 & (or_685 | or_689));
  // hls/stages/agreement.hpp:480
  logic parity_768;
  assign parity_768 = ^{or_765, or_761, or_757};
  // hls/stages/agreement.hpp:481
  logic or_772;
  assign or_772 = (or_700 & or_704) | (and_696 & (or_700 | or_704));
  logic or_776;
  assign or_776 = (or_715 & or_719) | (or_711 & (or_715 | or_719));
  logic or_780;
  assign or_780 = (or_730 & or_734) | (or_726 & (or_730 | or_734));
  // hls/stages/agreement.hpp:480
  logic parity_783;
  assign parity_783 = ^{or_780, or_776, or_772};
  logic parity_786;
  assign parity_786 = ^{or_780, or_776, or_772, or_765, or_761, or_757, or_750, or_746, and_742};
  // hls/stages/agreement.hpp:481
  logic or_790;
  assign or_790 = (parity_768 & parity_783) | ((^{or_750, or_746, and_742}) & (parity_768 | parity_783));
  logic or_794;
  assign or_794 = (or_746 & or_750) | (and_742 & (or_746 | or_750));
  logic or_798;
  assign or_798 = (or_761 & or_765) | (or_757 & (or_761 | or_765));
  logic or_802;
  assign or_802 = (or_776 & or_780) | (or_772 & (or_776 | or_780));
  // hls/stages/agreement.hpp:480
  logic parity_807;
  assign parity_807 = ^{or_802, or_798, or_794, or_790};
  // hls/stages/agreement.hpp:481
  logic or_811;
  assign or_811 = (or_798 & or_802) | (or_794 & (or_798 | or_802));
  logic and_812;
  assign and_812 = or_790 & (^{or_802, or_798, or_794});
  // hls/stages/agreement.hpp:480
  logic xor_813;
  assign xor_813 = or_811 ^ and_812;
  // hls/stages/agreement.hpp:483
  logic and_814;
  assign and_814 = or_811 & and_812;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_815;
  assign select_815 = equal_439_s1_q ? {and_814, xor_813, parity_807, parity_786, xor_741, xor_646} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_437_s1_q ? 6'h0 : select_815;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_826;
  assign select_826 = (slot_s1_q[0] ? and_612 : and_595) ? (~(select_574 ^ (slot_s1_q[0] ? select_613 : select_596))) : 12'h0;
  logic [11:0] select_827;
  assign select_827 = and_571 ? select_826 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_833;
  assign parity_833 = ^select_827[5:3];
  logic parity_836;
  assign parity_836 = ^select_827[8:6];
  logic parity_839;
  assign parity_839 = ^select_827[11:3];
  // hls/stages/agreement.hpp:159
  logic and_843;
  assign and_843 = right_codes_rdata_q[77] & not_445_s1_q;
  logic [11:0] select_845;
  assign select_845 = less_444_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_849;
  assign select_849 = (slot_s1_q[0] ? and_843 : and_612) ? (~(select_597 ^ (slot_s1_q[0] ? select_845 : select_613))) : 12'h0;
  logic [11:0] select_850;
  assign select_850 = and_594 ? select_849 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_853;
  assign parity_853 = ^select_850[8:6];
  logic parity_856;
  assign parity_856 = ^select_850[11:9];
  // hls/stages/agreement.hpp:541
  logic select_861;
  assign select_861 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_445_s1_q) : and_843;
  logic [11:0] select_863;
  assign select_863 = slot_s1_q[0] ? (less_444_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_845;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_867;
  assign select_867 = and_611 ? (select_861 ? (~(select_614 ^ select_863)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_873;
  assign parity_873 = ^select_867[2:0];
  logic parity_876;
  assign parity_876 = ^select_867[5:3];
  logic parity_879;
  assign parity_879 = ^select_867[8:0];
  logic parity_885;
  assign parity_885 = ^select_867[11:9];
  logic parity_888;
  assign parity_888 = ^select_850[2:0];
  logic parity_891;
  assign parity_891 = ^{select_867[11:9], select_850[5:0]};
  logic parity_894;
  assign parity_894 = ^{select_867, select_850, select_827[2:0]};
  logic xor_895;
  assign xor_895 = parity_839 ^ parity_894;
  // hls/stages/agreement.hpp:479
  logic or_899;
  assign or_899 = (select_827[1:0] == 2'h3) | (select_827[2] & (select_827[0] | select_827[1]));
  // hls/stages/agreement.hpp:481
  logic or_903;
  assign or_903 = (select_850[7:6] == 2'h3) | (select_850[8] & (select_850[6] | select_850[7]));
  logic or_907;
  assign or_907 = (select_850[10:9] == 2'h3) | (select_850[11] & (select_850[9] | select_850[10]));
  // hls/stages/agreement.hpp:479
  logic or_915;
  assign or_915 = (select_867[7:6] == 2'h3) | (select_867[8] & (~(select_867[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_919;
  assign or_919 = (select_867[1:0] == 2'h3) | (select_867[2] & (select_867[0] | select_867[1]));
  logic or_923;
  assign or_923 = (select_867[4:3] == 2'h3) | (select_867[5] & (select_867[3] | select_867[4]));
  // hls/stages/agreement.hpp:480
  logic parity_926;
  assign parity_926 = ^{or_923, or_919, or_915};
  // hls/stages/agreement.hpp:479
  logic or_930;
  assign or_930 = (select_850[4:3] == 2'h3) | (select_850[5] & (select_850[3] | select_850[4]));
  // hls/stages/agreement.hpp:481
  logic or_934;
  assign or_934 = (select_867[10:9] == 2'h3) | (select_867[11] & (select_867[9] | select_867[10]));
  logic or_938;
  assign or_938 = (select_850[1:0] == 2'h3) | (select_850[2] & (select_850[0] | select_850[1]));
  // hls/stages/agreement.hpp:480
  logic parity_941;
  assign parity_941 = ^{or_938, or_934, or_930};
  logic parity_944;
  assign parity_944 = ^{or_938, or_934, or_930, or_923, or_919, or_915, or_907, or_903, or_899};
  // hls/stages/agreement.hpp:481
  logic and_945;
  assign and_945 = parity_839 & parity_894;
  logic or_949;
  assign or_949 = (parity_833 & parity_836) | ((^select_827[11:9]) & (parity_833 | parity_836));
  logic and_952;
  assign and_952 = (^{select_850[11:6], select_827[2:0]}) & (parity_879 | parity_891);
  logic or_953;
  assign or_953 = (parity_879 & parity_891) | and_952;
  // hls/stages/agreement.hpp:479
  logic or_960;
  assign or_960 = (select_827[10:9] == 2'h3) | (select_827[11] & (select_827[9] | select_827[10]));
  // hls/stages/agreement.hpp:481
  logic or_964;
  assign or_964 = (select_827[4:3] == 2'h3) | (select_827[5] & (select_827[3] | select_827[4]));
  logic or_968;
  assign or_968 = (select_827[7:6] == 2'h3) | (select_827[8] & (select_827[6] | select_827[7]));
  // hls/stages/agreement.hpp:480
  logic parity_971;
  assign parity_971 = ^{or_968, or_964, or_960};
  // hls/stages/agreement.hpp:481
  logic or_975;
  assign or_975 = (parity_853 & parity_856) | ((^select_827[2:0]) & (parity_853 | parity_856));
  logic or_979;
  assign or_979 = (parity_873 & parity_876) | ((^select_867[8:6]) & (parity_873 | parity_876));
  logic or_983;
  assign or_983 = (parity_885 & parity_888) | ((^select_850[5:3]) & (parity_885 | parity_888));
  // hls/stages/agreement.hpp:480
  logic parity_986;
  assign parity_986 = ^{or_983, or_979, or_975};
  logic parity_989;
  assign parity_989 = ^{or_983, or_979, or_975, or_968, or_964, or_960, or_953, or_949, and_945};
  logic xor_990;
  assign xor_990 = parity_944 ^ parity_989;
  // hls/stages/agreement.hpp:481
  logic and_991;
  assign and_991 = parity_944 & parity_989;
  logic or_995;
  assign or_995 = (parity_926 & parity_941) | ((^{or_907, or_903, or_899}) & (parity_926 | parity_941));
  logic or_999;
  assign or_999 = (parity_971 & parity_986) | ((^{or_953, or_949, and_945}) & (parity_971 | parity_986));
  logic or_1006;
  assign or_1006 = (or_903 & or_907) | (or_899 & (or_903 | or_907));
  logic or_1010;
  assign or_1010 = (or_919 & or_923) | (or_915 & (or_919 | or_923));
  logic or_1014;
  assign or_1014 = (or_934 & or_938) | (or_930 & (or_934 | or_938));
  // hls/stages/agreement.hpp:480
  logic parity_1017;
  assign parity_1017 = ^{or_1014, or_1010, or_1006};
  // hls/stages/agreement.hpp:481
  logic or_1021;
  assign or_1021 = (or_949 & or_953) | (and_945 & (or_949 | or_953));
  logic or_1025;
  assign or_1025 = (or_964 & or_968) | (or_960 & (or_964 | or_968));
  logic or_1029;
  assign or_1029 = (or_979 & or_983) | (or_975 & (or_979 | or_983));
  // hls/stages/agreement.hpp:480
  logic parity_1032;
  assign parity_1032 = ^{or_1029, or_1025, or_1021};
  logic parity_1035;
  assign parity_1035 = ^{or_1029, or_1025, or_1021, or_1014, or_1010, or_1006, or_999, or_995, and_991};
  // hls/stages/agreement.hpp:481
  logic or_1039;
  assign or_1039 = (parity_1017 & parity_1032) | ((^{or_999, or_995, and_991}) & (parity_1017 | parity_1032));
  logic or_1043;
  assign or_1043 = (or_995 & or_999) | (and_991 & (or_995 | or_999));
  logic or_1047;
  assign or_1047 = (or_1010 & or_1014) | (or_1006 & (or_1010 | or_1014));
  logic or_1051;
  assign or_1051 = (or_1025 & or_1029) | (or_1021 & (or_1025 | or_1029));
  // hls/stages/agreement.hpp:480
  logic parity_1056;
  assign parity_1056 = ^{or_1051, or_1047, or_1043, or_1039};
  // hls/stages/agreement.hpp:481
  logic or_1060;
  assign or_1060 = (or_1047 & or_1051) | (or_1043 & (or_1047 | or_1051));
  logic and_1061;
  assign and_1061 = or_1039 & (^{or_1051, or_1047, or_1043});
  // hls/stages/agreement.hpp:480
  logic xor_1062;
  assign xor_1062 = or_1060 ^ and_1061;
  // hls/stages/agreement.hpp:483
  logic and_1063;
  assign and_1063 = or_1060 & and_1061;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1064;
  assign select_1064 = equal_439_s1_q ? {and_1063, xor_1062, parity_1056, parity_1035, xor_990, xor_895} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_437_s1_q ? 6'h0 : select_1064;
  // hls/stages/agreement.hpp:159
  logic and_1072;
  assign and_1072 = right_codes_rdata_q[25] & not_445_s1_q;
  // hls/stages/agreement.hpp:541
  logic select_1073;
  assign select_1073 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_445_s1_q) : and_1072;
  // hls/stages/agreement.hpp:159
  logic [11:0] select_1075;
  assign select_1075 = less_444_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:541
  logic [11:0] select_1076;
  assign select_1076 = slot_s1_q[0] ? (less_444_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1075;
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1080;
  assign select_1080 = and_571 ? (select_1073 ? (~(select_574 ^ select_1076)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1086;
  assign parity_1086 = ^select_1080[5:3];
  logic parity_1089;
  assign parity_1089 = ^select_1080[8:6];
  logic parity_1092;
  assign parity_1092 = ^select_1080[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1100;
  assign select_1100 = (slot_s1_q[0] ? and_1072 : and_572) ? (~(select_597 ^ (slot_s1_q[0] ? select_1075 : select_573))) : 12'h0;
  logic [11:0] select_1101;
  assign select_1101 = and_594 ? select_1100 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1104;
  assign parity_1104 = ^select_1101[8:6];
  logic parity_1107;
  assign parity_1107 = ^select_1101[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1115;
  assign select_1115 = (slot_s1_q[0] ? and_572 : and_595) ? (~(select_614 ^ (slot_s1_q[0] ? select_573 : select_596))) : 12'h0;
  logic [11:0] select_1116;
  assign select_1116 = and_611 ? select_1115 : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1122;
  assign parity_1122 = ^select_1116[2:0];
  logic parity_1125;
  assign parity_1125 = ^select_1116[5:3];
  logic parity_1128;
  assign parity_1128 = ^select_1116[8:0];
  logic parity_1134;
  assign parity_1134 = ^select_1116[11:9];
  logic parity_1137;
  assign parity_1137 = ^select_1101[2:0];
  logic parity_1140;
  assign parity_1140 = ^{select_1116[11:9], select_1101[5:0]};
  logic parity_1143;
  assign parity_1143 = ^{select_1116, select_1101, select_1080[2:0]};
  logic xor_1144;
  assign xor_1144 = parity_1092 ^ parity_1143;
  // hls/stages/agreement.hpp:479
  logic or_1148;
  assign or_1148 = (select_1080[1:0] == 2'h3) | (select_1080[2] & (select_1080[0] | select_1080[1]));
  // hls/stages/agreement.hpp:481
  logic or_1152;
  assign or_1152 = (select_1101[7:6] == 2'h3) | (select_1101[8] & (select_1101[6] | select_1101[7]));
  logic or_1156;
  assign or_1156 = (select_1101[10:9] == 2'h3) | (select_1101[11] & (select_1101[9] | select_1101[10]));
  // hls/stages/agreement.hpp:479
  logic or_1164;
  assign or_1164 = (select_1116[7:6] == 2'h3) | (select_1116[8] & (~(select_1116[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1168;
  assign or_1168 = (select_1116[1:0] == 2'h3) | (select_1116[2] & (select_1116[0] | select_1116[1]));
  logic or_1172;
  assign or_1172 = (select_1116[4:3] == 2'h3) | (select_1116[5] & (select_1116[3] | select_1116[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1175;
  assign parity_1175 = ^{or_1172, or_1168, or_1164};
  // hls/stages/agreement.hpp:479
  logic or_1179;
  assign or_1179 = (select_1101[4:3] == 2'h3) | (select_1101[5] & (select_1101[3] | select_1101[4]));
  // hls/stages/agreement.hpp:481
  logic or_1183;
  assign or_1183 = (select_1116[10:9] == 2'h3) | (select_1116[11] & (select_1116[9] | select_1116[10]));
  logic or_1187;
  assign or_1187 = (select_1101[1:0] == 2'h3) | (select_1101[2] & (select_1101[0] | select_1101[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1190;
  assign parity_1190 = ^{or_1187, or_1183, or_1179};
  logic parity_1193;
  assign parity_1193 = ^{or_1187, or_1183, or_1179, or_1172, or_1168, or_1164, or_1156, or_1152, or_1148};
  // hls/stages/agreement.hpp:481
  logic and_1194;
  assign and_1194 = parity_1092 & parity_1143;
  logic or_1198;
  assign or_1198 = (parity_1086 & parity_1089) | ((^select_1080[11:9]) & (parity_1086 | parity_1089));
  logic and_1201;
  assign and_1201 = (^{select_1101[11:6], select_1080[2:0]}) & (parity_1128 | parity_1140);
  logic or_1202;
  assign or_1202 = (parity_1128 & parity_1140) | and_1201;
  // hls/stages/agreement.hpp:479
  logic or_1209;
  assign or_1209 = (select_1080[10:9] == 2'h3) | (select_1080[11] & (select_1080[9] | select_1080[10]));
  // hls/stages/agreement.hpp:481
  logic or_1213;
  assign or_1213 = (select_1080[4:3] == 2'h3) | (select_1080[5] & (select_1080[3] | select_1080[4]));
  logic or_1217;
  assign or_1217 = (select_1080[7:6] == 2'h3) | (select_1080[8] & (select_1080[6] | select_1080[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1220;
  assign parity_1220 = ^{or_1217, or_1213, or_1209};
  // hls/stages/agreement.hpp:481
  logic or_1224;
  assign or_1224 = (parity_1104 & parity_1107) | ((^select_1080[2:0]) & (parity_1104 | parity_1107));
  logic or_1228;
  assign or_1228 = (parity_1122 & parity_1125) | ((^select_1116[8:6]) & (parity_1122 | parity_1125));
  logic or_1232;
  assign or_1232 = (parity_1134 & parity_1137) | ((^select_1101[5:3]) & (parity_1134 | parity_1137));
  // hls/stages/agreement.hpp:480
  logic parity_1235;
  assign parity_1235 = ^{or_1232, or_1228, or_1224};
  logic parity_1238;
  assign parity_1238 = ^{or_1232, or_1228, or_1224, or_1217, or_1213, or_1209, or_1202, or_1198, and_1194};
  logic xor_1239;
  assign xor_1239 = parity_1193 ^ parity_1238;
  // hls/stages/agreement.hpp:481
  logic and_1240;
  assign and_1240 = parity_1193 & parity_1238;
  logic or_1244;
  assign or_1244 = (parity_1175 & parity_1190) | ((^{or_1156, or_1152, or_1148}) & (parity_1175 | parity_1190));
  logic or_1248;
  assign or_1248 = (parity_1220 & parity_1235) | ((^{or_1202, or_1198, and_1194}) & (parity_1220 | parity_1235));
  logic or_1255;
  assign or_1255 = (or_1152 & or_1156) | (or_1148 & (or_1152 | or_1156));
  logic or_1259;
  assign or_1259 = (or_1168 & or_1172) | (or_1164 & (or_1168 | or_1172));
  logic or_1263;
  assign or_1263 = (or_1183 & or_1187) | (or_1179 & (or_1183 | or_1187));
  // hls/stages/agreement.hpp:480
  logic parity_1266;
  assign parity_1266 = ^{or_1263, or_1259, or_1255};
  // hls/stages/agreement.hpp:481
  logic or_1270;
  assign or_1270 = (or_1198 & or_1202) | (and_1194 & (or_1198 | or_1202));
  logic or_1274;
  assign or_1274 = (or_1213 & or_1217) | (or_1209 & (or_1213 | or_1217));
  logic or_1278;
  assign or_1278 = (or_1228 & or_1232) | (or_1224 & (or_1228 | or_1232));
  // hls/stages/agreement.hpp:480
  logic parity_1281;
  assign parity_1281 = ^{or_1278, or_1274, or_1270};
  logic parity_1284;
  assign parity_1284 = ^{or_1278, or_1274, or_1270, or_1263, or_1259, or_1255, or_1248, or_1244, and_1240};
  // hls/stages/agreement.hpp:481
  logic or_1288;
  assign or_1288 = (parity_1266 & parity_1281) | ((^{or_1248, or_1244, and_1240}) & (parity_1266 | parity_1281));
  logic or_1292;
  assign or_1292 = (or_1244 & or_1248) | (and_1240 & (or_1244 | or_1248));
  logic or_1296;
  assign or_1296 = (or_1259 & or_1263) | (or_1255 & (or_1259 | or_1263));
  logic or_1300;
  assign or_1300 = (or_1274 & or_1278) | (or_1270 & (or_1274 | or_1278));
  // hls/stages/agreement.hpp:480
  logic parity_1305;
  assign parity_1305 = ^{or_1300, or_1296, or_1292, or_1288};
  // hls/stages/agreement.hpp:481
  logic or_1309;
  assign or_1309 = (or_1296 & or_1300) | (or_1292 & (or_1296 | or_1300));
  logic and_1310;
  assign and_1310 = or_1288 & (^{or_1300, or_1296, or_1292});
  // hls/stages/agreement.hpp:480
  logic xor_1311;
  assign xor_1311 = or_1309 ^ and_1310;
  // hls/stages/agreement.hpp:483
  logic and_1312;
  assign and_1312 = or_1309 & and_1310;
  // hls/stages/agreement.hpp:551
  logic [5:0] select_1313;
  assign select_1313 = equal_439_s1_q ? {and_1312, xor_1311, parity_1305, parity_1284, xor_1239, xor_1144} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_437_s1_q ? 6'h0 : select_1313;
  // hls/stages/agreement.hpp:720
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:721
  logic [5:0] sum_1369;
  assign sum_1369 = x_s1_q[5:0] + shift;
  // hls/stages/agreement.hpp:724
  logic and_1389;
  assign and_1389 = (or_437_s1_q & (left_rdata_q[61] & not_445_s1_q)) & not_1388_s1_q;
  // hls/stages/agreement.hpp:182
  logic or_1411;
  assign or_1411 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_1422;
  assign select_1422 = so_s1_q ? x_s1_q[5:0] : (or_437_s1_q ? (less_444_s1_q ? 6'h0 : sum_1369) : 6'h0);

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_383_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_391;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1075; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_437_s1_q ? sum_1369 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_558_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_448_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_540, left_rdata_q[59:45], and_539, left_rdata_q[43:29], and_538, left_rdata_q[27:13], and_537, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_448_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_549, right_codes_rdata_q[76:65], and_548, right_codes_rdata_q[63:52], and_547, right_codes_rdata_q[50:39], and_546, right_codes_rdata_q[37:26], and_545, right_codes_rdata_q[24:13], and_544, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  logic sample_pair_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_of_skin_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [3:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic select_377_s2_q;
  logic [7:0] select_383_s2_q;
  logic and_390_s2_q;
  logic and_391_s2_q;
  logic equal_396_s2_q;
  logic whole_s2_q;
  logic [5:0] column_s2_q;
  logic and_414_s2_q;
  logic and_416_s2_q;
  logic equal_419_s2_q;
  logic so_s2_q;
  logic equal_436_s2_q;
  logic or_437_s2_q;
  logic less_444_s2_q;
  logic not_445_s2_q;
  logic equal_474_s2_q;
  logic equal_477_s2_q;
  logic select_479_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_565_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1066_s2_q;
  logic [5:0] select_1315_s2_q;
  logic and_1367_s2_q;
  logic [5:0] right_s2_q;
  logic select_1374_s2_q;
  logic equal_1383_s2_q;
  logic and_1390_s2_q;
  logic and_1393_s2_q;
  logic and_1397_s2_q;
  logic or_1411_s2_q;
  logic [5:0] select_1422_s2_q;
  logic [1:0] sum_1434_s2_q;
  logic less_1466_s2_q;
  logic equal_1482_s2_q;
  logic [8:0] select_1489_s2_q;
  logic and_1521_s2_q;
  logic less_1541_s2_q;
  logic [7:0] select_1770_s2_q;
  logic [7:0] select_1824_s2_q;
  logic [7:0] select_2112_s2_q;
  logic [7:0] select_2135_s2_q;
  logic [5:0] select_2144_s2_q;
  logic select_2145_s2_q;
  logic and_2149_s2_q;
  logic and_2152_s2_q;
  logic select_2154_s2_q;
  logic equal_2180_s2_q;
  logic and_2318_s2_q;
  logic equal_2506_s2_q;
  logic equal_2560_s2_q;
  logic and_2752_s2_q;
  logic and_2754_s2_q;
  logic less_2860_s2_q;
  logic equal_3057_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= sample_of_skin_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_first_s2_q <= sample_pair_first_s1_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_of_skin_s2_q <= sample_of_skin_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_s1_q;
      select_377_s2_q <= select_377_s1_q;
      select_383_s2_q <= select_383_s1_q;
      and_390_s2_q <= and_390_s1_q;
      and_391_s2_q <= and_391;
      equal_396_s2_q <= equal_396_s1_q;
      whole_s2_q <= whole_s1_q;
      column_s2_q <= column_s1_q;
      and_414_s2_q <= and_414_s1_q;
      and_416_s2_q <= and_416_s1_q;
      equal_419_s2_q <= equal_419_s1_q;
      so_s2_q <= so_s1_q;
      equal_436_s2_q <= equal_436_s1_q;
      or_437_s2_q <= or_437_s1_q;
      less_444_s2_q <= less_444_s1_q;
      not_445_s2_q <= not_445_s1_q;
      equal_474_s2_q <= equal_474_s1_q;
      equal_477_s2_q <= equal_477_s1_q;
      select_479_s2_q <= select_479_s1_q;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_565_s2_q <= select_565_s1_q;
      column_2_s2_q <= column_2;
      select_1066_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1315_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1367_s2_q <= and_1367_s1_q;
      right_s2_q <= right_s1_q;
      select_1374_s2_q <= select_1374_s1_q;
      equal_1383_s2_q <= equal_1383_s1_q;
      and_1390_s2_q <= not_445_s1_q & and_1389;
      and_1393_s2_q <= (or_437_s1_q & (left_rdata_q[62] & not_445_s1_q)) & and_1389;
      and_1397_s2_q <= not_445_s1_q & (or_437_s1_q & (left_rdata_q[63] & not_445_s1_q));
      or_1411_s2_q <= or_1411;
      select_1422_s2_q <= select_1422;
      sum_1434_s2_q <= sum_1434_s1_q;
      less_1466_s2_q <= less_1466_s1_q;
      equal_1482_s2_q <= equal_1482_s1_q;
      select_1489_s2_q <= select_1489_s1_q;
      and_1521_s2_q <= and_1521_s1_q;
      less_1541_s2_q <= less_1541_s1_q;
      select_1770_s2_q <= select_1770_s1_q;
      select_1824_s2_q <= select_1824_s1_q;
      select_2112_s2_q <= select_2112_s1_q;
      select_2135_s2_q <= select_2135_s1_q;
      select_2144_s2_q <= select_2144_s1_q;
      select_2145_s2_q <= select_2145_s1_q;
      and_2149_s2_q <= sample_pair_whole_q;
      and_2152_s2_q <= right_q;
      select_2154_s2_q <= left_first_q;
      equal_2180_s2_q <= equal_2180_s1_q;
      and_2318_s2_q <= and_2318_s1_q;
      equal_2506_s2_q <= equal_2506_s1_q;
      equal_2560_s2_q <= equal_2560_s1_q;
      and_2752_s2_q <= and_2752_s1_q;
      and_2754_s2_q <= and_2754_s1_q;
      less_2860_s2_q <= less_2860_s1_q;
      equal_3057_s2_q <= equal_3057_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
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
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_394;
  assign select_394 = select_377_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_398;
  assign sum_398 = select_394 + (equal_396_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_400;
  assign sum_400 = {4'h0, sample_pair_pixel_1_q} + (select_377_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_402;
  assign sum_402 = sum_400 + (equal_396_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_406;
  assign and_406 = whole_s2_q & (averager_memory_rdata_q[24] | equal_396_s2_q);
  // hls/stages/agreement.hpp:213
  logic all_of_skin;
  assign all_of_skin = select_377_s2_q ? (sample_of_skin_s2_q & averager_running_of_skin_q) : sample_of_skin_s2_q;
  // hls/stages/census.hpp:102
  logic and_410;
  assign and_410 = all_of_skin & (averager_memory_rdata_q[25] | equal_396_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_390_s2_q ? sum_398[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_390_s2_q ? sum_402[11:3] : 9'h0;
  logic and_427;
  assign and_427 = and_390_s2_q & and_406;
  // hls/stages/census.hpp:105
  logic select_429;
  assign select_429 = equal_419_s2_q ? and_427 : (averager_mask_q & and_427);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_429;
  // hls/stages/census.hpp:126
  logic and_431;
  assign and_431 = and_390_s2_q & and_410;
  // hls/stages/census.hpp:105
  logic select_433;
  assign select_433 = equal_419_s2_q ? and_431 : (averager_of_skin_q & and_431);
  // hls/stages/agreement.hpp:596
  logic not_567;
  assign not_567 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_568;
  assign less_568 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:178
  logic and_570;
  assign and_570 = not_567 & (~less_568);
  // hls/stages/agreement.hpp:586
  logic [5:0] select_817;
  assign select_817 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_818;
  assign difference_818 = {1'b0, column_2_s2_q} - {1'b0, select_817};
  logic [7:0] sum_820;
  assign sum_820 = {difference_818[6], difference_818} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:562
  logic [7:0] select_821;
  assign select_821 = slot_s2_q[0] ? chosen_score_q : sum_820;
  // hls/stages/agreement.hpp:586
  logic [6:0] difference_1067;
  assign difference_1067 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1066_s2_q};
  // hls/stages/agreement.hpp:556
  logic equal_1068;
  assign equal_1068 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_1070;
  assign sum_1070 = {difference_1067[6], difference_1067} + (equal_1068 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1316;
  assign difference_1316 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1315_s2_q};
  logic [7:0] sum_1318;
  assign sum_1318 = {difference_1316[6], difference_1316} + (equal_1068 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:558
  logic less_1319;
  assign less_1319 = sum_1070 < sum_1318;
  logic [7:0] select_1320;
  assign select_1320 = less_1319 ? sum_1318 : sum_1070;
  logic less_1321;
  assign less_1321 = select_821 < select_1320;
  logic [7:0] select_1322;
  assign select_1322 = less_1321 ? select_1320 : select_821;
  // hls/stages/agreement.hpp:600
  logic [7:0] of_best;
  assign of_best = and_570 ? select_1322 : 8'h0;
  // hls/stages/agreement.hpp:607
  logic or_1325;
  assign or_1325 = select_565_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:612
  logic [5:0] select_1326;
  assign select_1326 = or_1325 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:527
  logic not_1327;
  assign not_1327 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:559
  logic [1:0] select_1328;
  assign select_1328 = less_1319 ? {slot_s2_q[0], not_1327} : 2'h0;
  logic [2:0] select_1330;
  assign select_1330 = less_1321 ? {select_1328, not_1327} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:612
  logic [2:0] select_1331;
  assign select_1331 = or_1325 ? select_1330 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1332;
  assign select_1332 = or_1325 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:609
  logic equal_1333;
  assign equal_1333 = select_1330 == 3'h1;
  logic equal_1334;
  assign equal_1334 = select_1330 == 3'h2;
  logic not_1335;
  assign not_1335 = ~equal_1334;
  logic [2:0] select_1336;
  assign select_1336 = equal_1333 ? 3'h2 : {not_1335, {2{equal_1334}}};
  logic [7:0] select_1338;
  assign select_1338 = select_1336[1] ? sum_1318 : (select_1336[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1341;
  assign sum_1341 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1342;
  assign sum_1342 = {1'b0, before_v} + sum_1341;
  // hls/stages/agreement.hpp:562
  logic [6:0] select_1343;
  assign select_1343 = slot_s2_q[0] ? chosen_near_q : sum_1342;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1345;
  assign sum_1345 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1346;
  assign sum_1346 = {1'b0, before_v_2} + sum_1345;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1348;
  assign sum_1348 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1349;
  assign sum_1349 = {1'b0, before_v_3} + sum_1348;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1351;
  assign select_1351 = (sum_1346 < sum_1349) ? sum_1349 : sum_1346;
  logic [6:0] select_1353;
  assign select_1353 = (select_1343 < select_1351) ? select_1351 : select_1343;
  // hls/stages/agreement.hpp:609
  logic [6:0] select_1354;
  assign select_1354 = select_1336[0] ? {4'h0, select_1330} : select_1353;
  logic [7:0] select_1355;
  assign select_1355 = select_1336[1] ? (select_1336[0] ? before_1_q : sum_1070) : {1'b0, select_1354};
  // hls/stages/agreement.hpp:612
  logic [7:0] select_1357;
  assign select_1357 = or_1325 ? (select_1336[2] ? select_1338 : select_1355) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:610
  logic [1:0] select_1358;
  assign select_1358 = equal_1333 ? 2'h0 : {not_1335, equal_1334};
  logic [7:0] select_1360;
  assign select_1360 = select_1358[1] ? sum_1318 : (select_1358[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:612
  logic [7:0] select_1361;
  assign select_1361 = or_1325 ? select_1360 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:601
  logic [6:0] of_near;
  assign of_near = and_570 ? select_1353 : 7'h0;
  // hls/stages/agreement.hpp:612
  logic or_1364;
  assign or_1364 = select_565_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:616
  logic [6:0] select_1365;
  assign select_1365 = or_1364 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1366;
  assign select_1366 = or_1364 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:621
  logic or_1376;
  assign or_1376 = select_1374_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:625
  logic [7:0] select_1377;
  assign select_1377 = or_1376 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1378;
  assign select_1378 = or_1376 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1380;
  assign or_1380 = select_1374_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:629
  logic [6:0] select_1381;
  assign select_1381 = or_1380 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1382;
  assign select_1382 = or_1380 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:747
  logic not_1384;
  assign not_1384 = ~equal_1383_s2_q;
  // hls/stages/agreement.hpp:182
  logic and_1394;
  assign and_1394 = not_445_s2_q & and_1393_s2_q;
  // hls/stages/agreement.hpp:727
  logic select_1400;
  assign select_1400 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:728
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:734
  logic [8:0] difference_1403;
  assign difference_1403 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:735
  logic [9:0] sum_1404;
  assign sum_1404 = {difference_1403[8], difference_1403} + 10'h1;
  // hls/stages/agreement.hpp:182
  logic and_1406;
  assign and_1406 = (and_1393_s2_q & select_1400) & ({{22{sum_1404[9]}}, sum_1404} < 32'h3);
  logic and_1407;
  assign and_1407 = not_445_s2_q & and_1406;
  logic and_1413;
  assign and_1413 = not_445_s2_q & (and_1406 & or_1411_s2_q);
  // hls/stages/agreement.hpp:191
  logic [8:0] select_1414;
  assign select_1414 = less_444_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_437_s2_q ? {select_1414, and_1413, and_1407, and_1397_s2_q, and_1394, and_1390_s2_q, not_445_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:211
  logic and_1416;
  assign and_1416 = ends_cell_s2_q & inside_v[0];
  logic and_1418;
  assign and_1418 = not_1384 & (so_s2_q & and_1416);
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1466_s2_q;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_1548;
  assign select_1548 = or_437_s2_q ? (less_444_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_1550;
  assign select_1550 = or_437_s2_q ? (less_444_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/agreement.hpp:192
  logic [4:0] select_1552;
  assign select_1552 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:76
  logic less_1641;
  assign less_1641 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_1643;
  assign select_1643 = or_437_s2_q ? (less_444_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_1548} - {1'b0, select_1550};
  // hls/stages/registration.hpp:35
  logic [7:0] select_1645;
  assign select_1645 = rise[8] ? select_1548 : select_1550;
  logic [8:0] difference_1646;
  assign difference_1646 = {1'b0, select_1643} - {1'b0, select_1645};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_1646[8] ? 8'h0 : difference_1646[7:0];
  // hls/stages/registration.hpp:37
  logic not_1648;
  assign not_1648 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_1641 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_1648};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_1650;
  assign xor_1650 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_1650};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size) ? {wide, 1'b0} : size);
  logic [7:0] select_1656;
  assign select_1656 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_1641 ? {taken, 1'b1} : {not_1648, select_1656, not_1648};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_1658;
  assign sum_1658 = {left, 1'b1} + {taken_2, less_1641};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1684;
  assign select_1684 = select_1489_s2_q[1] ? sum_1318 : (select_1489_s2_q[0] ? before_2_q : before_0_q);
  logic [6:0] select_1686;
  assign select_1686 = select_1489_s2_q[0] ? {4'h0, select_1330} : select_1353;
  logic [7:0] select_1687;
  assign select_1687 = select_1489_s2_q[1] ? (select_1489_s2_q[0] ? before_1_q : sum_1070) : {1'b0, select_1686};
  // hls/stages/agreement.hpp:174
  logic [7:0] select_1692;
  assign select_1692 = slot_s2_q[0] ? 8'h0 : sum_820;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1694;
  assign select_1694 = select_1489_s2_q[1] ? (select_1489_s2_q[0] ? select_1322 : sum_1318) : (select_1489_s2_q[0] ? sum_1070 : select_1692);
  // hls/stages/agreement.hpp:558
  logic less_1695;
  assign less_1695 = select_1692 < select_1320;
  // hls/stages/agreement.hpp:559
  logic [2:0] select_1696;
  assign select_1696 = less_1695 ? {select_1328, not_1327} : 3'h2;
  // hls/stages/agreement.hpp:174
  logic [6:0] select_1697;
  assign select_1697 = slot_s2_q[0] ? 7'h0 : sum_1342;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1699;
  assign select_1699 = (select_1697 < select_1351) ? select_1351 : select_1697;
  // hls/stages/registration.hpp:250
  logic [6:0] select_1700;
  assign select_1700 = select_1489_s2_q[0] ? {4'h0, select_1696} : select_1699;
  // hls/stages/agreement.hpp:558
  logic [7:0] select_1701;
  assign select_1701 = less_1695 ? select_1320 : select_1692;
  // hls/stages/agreement.hpp:586
  logic [7:0] select_1702;
  assign select_1702 = equal_1068 ? 8'h0 : sums_1_sum_sums_values_0_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1704;
  assign select_1704 = select_1489_s2_q[1] ? {1'b0, select_1700} : (select_1489_s2_q[0] ? select_1701 : select_1702);
  logic [7:0] select_1706;
  assign select_1706 = select_1489_s2_q[0] ? sum_1318 : {2'h0, sums_1_columns_values_13_q};
  logic [5:0] select_1707;
  assign select_1707 = select_1489_s2_q[0] ? sums_1_columns_values_12_q : sums_1_columns_values_11_q;
  logic [5:0] select_1709;
  assign select_1709 = select_1489_s2_q[0] ? sums_1_columns_values_10_q : sums_1_columns_values_9_q;
  logic [5:0] select_1710;
  assign select_1710 = select_1489_s2_q[0] ? sums_1_columns_values_8_q : sums_1_columns_values_7_q;
  logic [5:0] select_1711;
  assign select_1711 = select_1489_s2_q[1] ? select_1709 : select_1710;
  logic [7:0] select_1712;
  assign select_1712 = select_1489_s2_q[2] ? (select_1489_s2_q[1] ? select_1706 : {2'h0, select_1707}) : {2'h0, select_1711};
  logic [7:0] select_1713;
  assign select_1713 = select_1489_s2_q[3] ? (select_1489_s2_q[2] ? select_1694 : select_1704) : select_1712;
  logic [5:0] select_1714;
  assign select_1714 = select_1489_s2_q[0] ? sums_1_columns_values_6_q : sums_1_columns_values_5_q;
  logic [5:0] select_1715;
  assign select_1715 = select_1489_s2_q[0] ? sums_1_columns_values_4_q : sums_1_columns_values_3_q;
  logic [5:0] select_1716;
  assign select_1716 = select_1489_s2_q[1] ? select_1714 : select_1715;
  logic [5:0] select_1717;
  assign select_1717 = select_1489_s2_q[0] ? sums_1_columns_values_2_q : sums_1_columns_values_1_q;
  // hls/stages/agreement.hpp:586
  logic [7:0] select_1718;
  assign select_1718 = equal_1068 ? 8'h0 : sums_0_sum_sums_values_0_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1719;
  assign select_1719 = select_1489_s2_q[0] ? {2'h0, sums_1_columns_values_0_q} : select_1718;
  logic [7:0] select_1721;
  assign select_1721 = select_1489_s2_q[2] ? {2'h0, select_1716} : (select_1489_s2_q[1] ? {2'h0, select_1717} : select_1719);
  logic [7:0] select_1722;
  assign select_1722 = select_1489_s2_q[0] ? sum_1070 : {2'h0, sums_0_columns_values_13_q};
  logic [5:0] select_1723;
  assign select_1723 = select_1489_s2_q[0] ? sums_0_columns_values_12_q : sums_0_columns_values_11_q;
  logic [5:0] select_1725;
  assign select_1725 = select_1489_s2_q[0] ? sums_0_columns_values_10_q : sums_0_columns_values_9_q;
  logic [5:0] select_1726;
  assign select_1726 = select_1489_s2_q[0] ? sums_0_columns_values_8_q : sums_0_columns_values_7_q;
  logic [5:0] select_1727;
  assign select_1727 = select_1489_s2_q[1] ? select_1725 : select_1726;
  logic [7:0] select_1728;
  assign select_1728 = select_1489_s2_q[2] ? (select_1489_s2_q[1] ? select_1722 : {2'h0, select_1723}) : {2'h0, select_1727};
  logic [7:0] select_1730;
  assign select_1730 = select_1489_s2_q[4] ? select_1713 : (select_1489_s2_q[3] ? select_1721 : select_1728);
  logic [5:0] select_1732;
  assign select_1732 = select_1489_s2_q[0] ? sums_0_columns_values_6_q : sums_0_columns_values_5_q;
  logic [5:0] select_1733;
  assign select_1733 = select_1489_s2_q[0] ? sums_0_columns_values_4_q : sums_0_columns_values_3_q;
  logic [5:0] select_1734;
  assign select_1734 = select_1489_s2_q[1] ? select_1732 : select_1733;
  logic [5:0] select_1735;
  assign select_1735 = select_1489_s2_q[0] ? sums_0_columns_values_2_q : sums_0_columns_values_1_q;
  // hls/stages/agreement.hpp:174
  logic [7:0] select_1736;
  assign select_1736 = slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_820;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1737;
  assign select_1737 = select_1489_s2_q[0] ? {2'h0, sums_0_columns_values_0_q} : select_1736;
  logic [7:0] select_1739;
  assign select_1739 = select_1489_s2_q[2] ? {2'h0, select_1734} : (select_1489_s2_q[1] ? {2'h0, select_1735} : select_1737);
  // hls/stages/agreement.hpp:174
  logic [5:0] select_1740;
  assign select_1740 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [5:0] select_1741;
  assign select_1741 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_1743;
  assign select_1743 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_1744;
  assign select_1744 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  // hls/stages/registration.hpp:250
  logic [5:0] select_1746;
  assign select_1746 = select_1489_s2_q[1] ? (select_1489_s2_q[0] ? select_1740 : select_1741) : (select_1489_s2_q[0] ? select_1743 : select_1744);
  // hls/stages/agreement.hpp:174
  logic [5:0] select_1747;
  assign select_1747 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_1748;
  assign select_1748 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_1750;
  assign select_1750 = slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
  // hls/stages/registration.hpp:250
  logic [5:0] select_1752;
  assign select_1752 = select_1489_s2_q[1] ? (select_1489_s2_q[0] ? select_1747 : select_1748) : (select_1489_s2_q[0] ? select_1750 : {5'h0, lower_half_s2_q});
  logic [5:0] select_1753;
  assign select_1753 = select_1489_s2_q[2] ? select_1746 : select_1752;
  logic [7:0] select_1771;
  assign select_1771 = select_1489_s2_q[4] ? (select_1489_s2_q[3] ? select_1739 : {2'h0, select_1753}) : select_1770_s2_q;
  logic select_2110;
  assign select_2110 = select_1489_s2_q[0] ? averager_mask_q : averager_running_of_skin_q;
  logic [7:0] select_2129;
  assign select_2129 = select_1489_s2_q[0] ? {4'h0, averager_running_1_q[11:8]} : averager_running_1_q[7:0];
  logic [7:0] select_2132;
  assign select_2132 = select_1489_s2_q[0] ? {4'h0, averager_running_0_q[11:8]} : averager_running_0_q[7:0];
  logic [7:0] select_2146;
  assign select_2146 = select_1489_s2_q[0] ? {7'h0, sample_pair_first_s2_q} : sample_pair_pixel_1_q;
  logic [7:0] select_2153;
  assign select_2153 = select_1489_s2_q[0] ? sample_pair_pixel_0_q : {7'h0, and_2152_s2_q};
  // hls/stages/agreement.hpp:123
  logic [7:0] select_2155;
  assign select_2155 = and_2149_s2_q ? left_pixel_q : pixel_0_s2_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_2157;
  assign select_2157 = select_1489_s2_q[1] ? select_2153 : (select_1489_s2_q[0] ? {7'h0, select_2154_s2_q} : select_2155);
  logic [7:0] select_2158;
  assign select_2158 = select_1489_s2_q[2] ? (select_1489_s2_q[1] ? {7'h0, select_2145_s2_q} : select_2146) : select_2157;
  // hls/stages/agreement.hpp:197
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:215
  logic select_2373;
  assign select_2373 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2375;
  assign select_2375 = sample_pair_whole_s2_q ? (and_414_s2_q ? select_429 : averager_mask_q) : averager_mask_q;
  logic select_2377;
  assign select_2377 = sample_pair_whole_s2_q ? (and_414_s2_q ? select_433 : averager_of_skin_q) : averager_of_skin_q;

  // Memory census_memory, 47 x 80, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [79:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 80'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_416_s2_q;
  logic [79:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1076; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1418;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1100; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1418;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_383_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_391_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_410, and_406, sum_402, sum_398};
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

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1367_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1366, select_1365, select_1361, select_1357, select_1332, select_1331, select_1326};
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
  assign best_right_we = s2_en & and_1367_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1382, select_1381, select_1378, select_1377};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s2_q;
      averager_running_of_skin_q <= select_2373;
      averager_mask_q <= select_2375;
      averager_of_skin_q <= select_2377;
      chosen_score_q <= select_1701;
      chosen_near_q <= select_1699;
      chosen_place_q <= select_1696;
      before_0_q <= select_1692;
      before_1_q <= sum_1070;
      before_2_q <= sum_1318;
      registration_displacement_over_q <= so_s2_q ? sum_1658[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_1552;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
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
      left_pixel_q <= select_2155;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_394 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_400 : averager_running_1_q;
      middle_sum_columns_values_0_q <= select_1750;
      middle_sum_columns_values_1_q <= select_1748;
      middle_sum_columns_values_2_q <= select_1747;
      middle_sum_columns_values_3_q <= select_1744;
      middle_sum_columns_values_4_q <= select_1743;
      middle_sum_columns_values_5_q <= select_1741;
      middle_sum_columns_values_6_q <= select_1740;
      middle_sum_sum_sums_values_0_q <= select_1736;
      sums_0_sum_sums_values_0_q <= sum_1070;
      sums_0_sum_sums_values_1_q <= select_1718;
      sums_1_sum_sums_values_0_q <= sum_1318;
      sums_1_sum_sums_values_1_q <= select_1702;
    end
  end

  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [5:0] column_s3_q;
  logic and_414_s3_q;
  logic and_416_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_419_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_434_s3_q;
  logic so_s3_q;
  logic equal_474_s3_q;
  logic equal_477_s3_q;
  logic select_479_s3_q;
  logic equal_1383_s3_q;
  logic not_1384_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1418_s3_q;
  logic [5:0] select_1422_s3_q;
  logic and_1427_s3_q;
  logic [1:0] sum_1434_s3_q;
  logic right_2_s3_q;
  logic equal_1482_s3_q;
  logic [8:0] select_1489_s3_q;
  logic and_1521_s3_q;
  logic and_1542_s3_q;
  logic less_1551_s3_q;
  logic [7:0] select_1688_s3_q;
  logic [7:0] select_1730_s3_q;
  logic [7:0] select_1771_s3_q;
  logic [7:0] select_1824_s3_q;
  logic select_2111_s3_q;
  logic [7:0] select_2112_s3_q;
  logic [7:0] select_2129_s3_q;
  logic [7:0] select_2136_s3_q;
  logic and_2149_s3_q;
  logic [7:0] select_2159_s3_q;
  logic equal_2180_s3_q;
  logic textured_s3_q;
  logic and_2319_s3_q;
  logic equal_2506_s3_q;
  logic equal_2560_s3_q;
  logic and_2752_s3_q;
  logic and_2754_s3_q;
  logic less_2860_s3_q;
  logic equal_3057_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[2];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_414_s3_q <= and_414_s2_q;
      and_416_s3_q <= and_416_s2_q;
      grey_s3_q <= grey;
      equal_419_s3_q <= equal_419_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_434_s3_q <= sample_pair_whole_s2_q & select_433;
      so_s3_q <= so_s2_q;
      equal_474_s3_q <= equal_474_s2_q;
      equal_477_s3_q <= equal_477_s2_q;
      select_479_s3_q <= select_479_s2_q;
      equal_1383_s3_q <= equal_1383_s2_q;
      not_1384_s3_q <= not_1384;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1418_s3_q <= and_1418;
      select_1422_s3_q <= select_1422_s2_q;
      and_1427_s3_q <= not_1384 & (so_s2_q ? and_1416 : (equal_436_s2_q & inside_v[4]));
      sum_1434_s3_q <= sum_1434_s2_q;
      right_2_s3_q <= right_2;
      equal_1482_s3_q <= equal_1482_s2_q;
      select_1489_s3_q <= select_1489_s2_q;
      and_1521_s3_q <= and_1521_s2_q;
      and_1542_s3_q <= inside_v[4] & less_1541_s2_q;
      less_1551_s3_q <= select_1548 < select_1550;
      select_1688_s3_q <= select_1489_s2_q[2] ? select_1684 : select_1687;
      select_1730_s3_q <= select_1730;
      select_1771_s3_q <= select_1771;
      select_1824_s3_q <= select_1824_s2_q;
      select_2111_s3_q <= select_1489_s2_q[1] ? averager_of_skin_q : select_2110;
      select_2112_s3_q <= select_2112_s2_q;
      select_2129_s3_q <= select_2129;
      select_2136_s3_q <= select_1489_s2_q[2] ? select_2132 : select_2135_s2_q;
      and_2149_s3_q <= and_2149_s2_q;
      select_2159_s3_q <= select_1489_s2_q[3] ? {2'h0, select_2144_s2_q} : select_2158;
      equal_2180_s3_q <= equal_2180_s2_q;
      textured_s3_q <= textured;
      and_2319_s3_q <= not_1384 & and_2318_s2_q;
      equal_2506_s3_q <= equal_2506_s2_q;
      equal_2560_s3_q <= equal_2560_s2_q;
      and_2752_s3_q <= and_2752_s2_q;
      and_2754_s3_q <= and_2754_s2_q;
      less_2860_s3_q <= less_2860_s2_q;
      equal_3057_s3_q <= equal_3057_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_0_cell_0_of_skin_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic census_columns_values_0_cell_1_of_skin_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
  logic census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] census_columns_values_0_cell_3_left_q;
  logic [8:0] census_columns_values_0_cell_3_right_q;
  logic census_columns_values_0_cell_3_mask_q;
  logic census_columns_values_0_cell_3_of_skin_q;
  logic [8:0] census_columns_values_0_cell_4_left_q;
  logic [8:0] census_columns_values_0_cell_4_right_q;
  logic census_columns_values_0_cell_4_mask_q;
  logic census_columns_values_0_cell_4_of_skin_q;
  logic [8:0] census_columns_values_1_cell_0_left_q;
  logic [8:0] census_columns_values_1_cell_0_right_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_0_of_skin_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_1_of_skin_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_3_of_skin_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_1_cell_4_of_skin_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_0_of_skin_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic census_columns_values_2_cell_1_of_skin_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_2_of_skin_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_3_of_skin_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_2_cell_4_of_skin_q;
  logic [8:0] census_columns_values_3_cell_0_left_q;
  logic [8:0] census_columns_values_3_cell_0_right_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_0_of_skin_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_1_of_skin_q;
  logic [8:0] census_columns_values_3_cell_2_left_q;
  logic [8:0] census_columns_values_3_cell_2_right_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_2_of_skin_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic census_columns_values_3_cell_3_of_skin_q;
  logic [8:0] census_columns_values_3_cell_4_left_q;
  logic [8:0] census_columns_values_3_cell_4_right_q;
  logic census_columns_values_3_cell_4_mask_q;
  logic census_columns_values_3_cell_4_of_skin_q;
  logic [8:0] census_columns_values_4_cell_0_left_q;
  logic [8:0] census_columns_values_4_cell_0_right_q;
  logic census_columns_values_4_cell_0_mask_q;
  logic census_columns_values_4_cell_0_of_skin_q;
  logic [8:0] census_columns_values_4_cell_1_left_q;
  logic [8:0] census_columns_values_4_cell_1_right_q;
  logic census_columns_values_4_cell_1_mask_q;
  logic census_columns_values_4_cell_1_of_skin_q;
  logic [8:0] census_columns_values_4_cell_2_left_q;
  logic [8:0] census_columns_values_4_cell_2_right_q;
  logic census_columns_values_4_cell_2_mask_q;
  logic census_columns_values_4_cell_2_of_skin_q;
  logic [8:0] census_columns_values_4_cell_3_left_q;
  logic [8:0] census_columns_values_4_cell_3_right_q;
  logic census_columns_values_4_cell_3_mask_q;
  logic census_columns_values_4_cell_3_of_skin_q;
  logic [8:0] census_columns_values_4_cell_4_left_q;
  logic [8:0] census_columns_values_4_cell_4_right_q;
  logic census_columns_values_4_cell_4_mask_q;
  logic census_columns_values_4_cell_4_of_skin_q;
  logic sharpness_last_valid_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic sharpness_last_mask_q;
  logic sharpness_last_of_skin_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [7:0] registration_slope_here_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [3:0] registration_fresh_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
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
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s3_q} + (equal_419_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_422;
  assign select_422 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_419_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_426;
  assign select_426 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_450;
  assign less_450 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_451;
  assign less_451 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_452;
  assign less_452 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_453;
  assign less_453 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_454;
  assign less_454 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_455;
  assign less_455 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_456;
  assign less_456 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_457;
  assign less_457 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_458;
  assign less_458 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_459;
  assign less_459 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_460;
  assign less_460 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_461;
  assign less_461 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_462;
  assign less_462 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_463;
  assign less_463 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_464;
  assign less_464 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_465;
  assign less_465 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_466;
  assign less_466 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_467;
  assign less_467 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_468;
  assign less_468 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_469;
  assign less_469 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_470;
  assign less_470 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_471;
  assign less_471 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_472;
  assign less_472 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_473;
  assign less_473 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:206
  logic and_483;
  assign and_483 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_485;
  assign and_485 = census_memory_rdata_q[78] & (census_memory_rdata_q[58] & and_483);
  // hls/stages/agreement.hpp:310
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_485;
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
  // hls/stages/census.hpp:190
  logic [9:0] difference_508;
  assign difference_508 = {1'b0, select_422} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_509;
  assign xor_509 = difference_508[8:0] ^ {9{difference_508[9]}};
  logic [9:0] sum_510;
  assign sum_510 = {9'h0, difference_508[9]} + {1'b0, xor_509};
  logic [9:0] difference_511;
  assign difference_511 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_512;
  assign xor_512 = difference_511[8:0] ^ {9{difference_511[9]}};
  logic [9:0] sum_513;
  assign sum_513 = {9'h0, difference_511[9]} + {1'b0, xor_512};
  logic [9:0] difference_515;
  assign difference_515 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_516;
  assign xor_516 = difference_515[8:0] ^ {9{difference_515[9]}};
  logic [9:0] sum_517;
  assign sum_517 = {9'h0, difference_515[9]} + {1'b0, xor_516};
  logic [10:0] sum_518;
  assign sum_518 = ({1'b0, sum_510} + {1'b0, sum_513}) + {1'b0, sum_517};
  logic [9:0] difference_519;
  assign difference_519 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_520;
  assign xor_520 = difference_519[8:0] ^ {9{difference_519[9]}};
  logic [9:0] sum_521;
  assign sum_521 = {9'h0, difference_519[9]} + {1'b0, xor_520};
  logic [9:0] difference_523;
  assign difference_523 = {1'b0, census_memory_rdata_q[68:60]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_524;
  assign xor_524 = difference_523[8:0] ^ {9{difference_523[9]}};
  logic [9:0] sum_525;
  assign sum_525 = {9'h0, difference_523[9]} + {1'b0, xor_524};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_518} + {2'h0, sum_521}) + {2'h0, sum_525};
  // hls/stages/agreement.hpp:139
  logic not_1423;
  assign not_1423 = ~so_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1424;
  assign and_1424 = not_1423 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:859
  logic equal_1428;
  assign equal_1428 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:899
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:860
  logic [1:0] select_1431;
  assign select_1431 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:872
  logic [3:0] select_1433;
  assign select_1433 = equal_1428 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1431});
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1435;
  assign select_1435 = equal_1383_s3_q ? select_1433 : {sum_1434_s3_q, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:897
  logic equal_1436;
  assign equal_1436 = x_s3_q[5:0] == 6'h3e;
  logic equal_1438;
  assign equal_1438 = x_s3_q[5:0] == 6'h3d;
  logic equal_1440;
  assign equal_1440 = x_s3_q[5:0] == 6'h3c;
  logic equal_1442;
  assign equal_1442 = x_s3_q[5:0] == 6'h3b;
  logic equal_1444;
  assign equal_1444 = x_s3_q[5:0] == 6'h36;
  logic equal_1446;
  assign equal_1446 = x_s3_q[5:0] == 6'h35;
  logic equal_1448;
  assign equal_1448 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:899
  logic and_1452;
  assign and_1452 = (~equal_1442) & ((~equal_1444) & ((~equal_1446) & (~equal_1448)));
  // hls/stages/agreement.hpp:860
  logic less_1456;
  assign less_1456 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1460;
  assign or_1460 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:872
  logic select_1463;
  assign select_1463 = equal_1428 ? ((~equal_1436) & ((~equal_1438) & ((~equal_1440) & and_1452))) : (less_1456 & (~or_1460));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1471;
  assign sum_1471 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1473;
  assign and_1473 = half_ends & ({{3{sum_1471[4]}}, sum_1471} < 8'h3);
  // hls/stages/agreement.hpp:211
  logic and_1474;
  assign and_1474 = so_s3_q & and_1473;
  // hls/stages/registration.hpp:243
  logic not_1477;
  assign not_1477 = ~lower_half_s3_q;
  logic [3:0] select_1478;
  assign select_1478 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1477, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1477};
  // hls/stages/agreement.hpp:143
  logic or_1490;
  assign or_1490 = segment_starts_q | not_1423;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1495;
  assign select_1495 = select_1489_s3_q[0] ? {8{region_down_next_q[8]}} : region_down_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [7:0] sum_1496;
  assign sum_1496 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1497;
  assign sum_1497 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1498;
  assign select_1498 = sum_1496[7] ? {1'b1, sum_1496[6:0], region_down_rest_q[0]} : sum_1497;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1500;
  assign select_1500 = select_1489_s3_q[1] ? select_1495 : (select_1489_s3_q[0] ? {8{select_1498[8]}} : select_1498[7:0]);
  logic [5:0] select_1503;
  assign select_1503 = select_1489_s3_q[0] ? {6{region_down_back_q[6]}} : region_down_back_q[5:0];
  logic [7:0] select_1504;
  assign select_1504 = select_1489_s3_q[0] ? {8{region_down_rest_q[8]}} : region_down_rest_q[7:0];
  logic [7:0] select_1505;
  assign select_1505 = select_1489_s3_q[1] ? {{2{region_down_back_q[6]}}, select_1503} : select_1504;
  logic [5:0] select_1507;
  assign select_1507 = select_1489_s3_q[0] ? {6{columns_begin_back_q[6]}} : columns_begin_back_q[5:0];
  logic [6:0] select_1508;
  assign select_1508 = select_1489_s3_q[0] ? {7{columns_begin_rest_q[7]}} : columns_begin_rest_q[6:0];
  logic [7:0] select_1509;
  assign select_1509 = select_1489_s3_q[1] ? {{2{columns_begin_back_q[6]}}, select_1507} : {columns_begin_rest_q[7], select_1508};
  logic [7:0] select_1510;
  assign select_1510 = select_1489_s3_q[0] ? {8{region_across_next_q[8]}} : region_across_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1511;
  assign sum_1511 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1512;
  assign sum_1512 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1513;
  assign select_1513 = sum_1511[5] ? {1'b1, sum_1511[4:0], region_across_rest_q[2:0]} : sum_1512;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1515;
  assign select_1515 = select_1489_s3_q[1] ? select_1510 : (select_1489_s3_q[0] ? {8{select_1513[8]}} : select_1513[7:0]);
  logic [7:0] select_1517;
  assign select_1517 = select_1489_s3_q[3] ? (select_1489_s3_q[2] ? select_1505 : 8'h0) : (select_1489_s3_q[2] ? select_1509 : select_1515);
  // hls/stages/agreement.hpp:143
  logic [6:0] select_1519;
  assign select_1519 = so_s3_q ? region_across_back_q : columns_begin_back_q;
  // hls/stages/registration.hpp:250
  logic [5:0] select_1520;
  assign select_1520 = select_1489_s3_q[0] ? {6{select_1519[6]}} : select_1519[5:0];
  // hls/stages/agreement.hpp:143
  logic [8:0] select_1523;
  assign select_1523 = so_s3_q ? (and_1521_s3_q ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/registration.hpp:250
  logic [7:0] select_1525;
  assign select_1525 = select_1489_s3_q[1] ? {{2{select_1519[6]}}, select_1520} : (select_1489_s3_q[0] ? {8{select_1523[8]}} : select_1523[7:0]);
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1526;
  assign select_1526 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:131
  logic [2:0] sum_1527;
  assign sum_1527 = region_row_q + 3'h1;
  // hls/stages/registration.hpp:250
  logic [2:0] select_1528;
  assign select_1528 = select_1489_s3_q[0] ? next_region_row_q : sum_1527;
  logic [7:0] select_1530;
  assign select_1530 = select_1489_s3_q[2] ? select_1525 : (select_1489_s3_q[1] ? select_1526 : {5'h0, select_1528});
  logic [2:0] select_1532;
  assign select_1532 = select_1489_s3_q[1] ? (select_1489_s3_q[0] ? region_row_q : 3'h0) : 3'h0;
  logic [2:0] select_1533;
  assign select_1533 = select_1489_s3_q[2] ? select_1532 : 3'h0;
  logic and_1537;
  assign and_1537 = (select_1489_s3_q[0] ? shown_nearer_q : shown_shown_q) & (~select_1489_s3_q[1]);
  // hls/stages/registration.hpp:83
  logic equal_1540;
  assign equal_1540 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_1546;
  assign sum_1546 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_1553;
  assign difference_1553 = {sum_1546, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_1554;
  assign select_1554 = less_1551_s3_q ? difference_1553 : {sum_1546, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_1555;
  assign select_1555 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_1546, inside_v_s3_q[11], 5'h0} : select_1554;
  // hls/stages/registration.hpp:206
  logic [16:0] select_1557;
  assign select_1557 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1557[16:7])) ? 8'h7f : select_1557[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1540 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:199
  logic [6:0] select_1561;
  assign select_1561 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1562;
  assign select_1562 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1563;
  assign sum_1563 = {{2{select_1561[6]}}, select_1561} + {select_1562[7], select_1562};
  // hls/stages/registration.hpp:200
  logic [7:0] select_1564;
  assign select_1564 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1565;
  assign select_1565 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1566;
  assign sum_1566 = {{2{select_1564[7]}}, select_1564[7:1]} + {select_1565[7], select_1565};
  // hls/stages/registration.hpp:202
  logic [10:0] sum_1567;
  assign sum_1567 = {{3{sum_1563[8]}}, sum_1563[8:1]} + {sum_1566[8], sum_1566, select_1564[0]};
  // hls/stages/registration.hpp:201
  logic [7:0] select_1568;
  assign select_1568 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1569;
  assign select_1569 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1570;
  assign difference_1570 = {{2{select_1568[7]}}, select_1568[7:1]} - {select_1569[7], select_1569};
  // hls/stages/registration.hpp:202
  logic [9:0] sum_1571;
  assign sum_1571 = {difference_1570, select_1568[0]} + {sum_1567[10], sum_1567[10:2]};
  // hls/stages/registration.hpp:101
  logic [11:0] value;
  assign value = {{4{select_1555[7]}}, select_1555} - {sum_1571[9], sum_1571, sum_1567[1]};
  // hls/stages/registration.hpp:206
  logic [11:0] select_1574;
  assign select_1574 = ($signed(value[11:7]) < $signed(5'h1f)) ? 12'hf80 : value;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1574[11:7])) ? 12'h7f : select_1574;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1614;
  assign select_1614 = select_1489_s3_q[0] ? {{4{registration_slope_q[27]}}, registration_slope_q[27:24]} : registration_slope_q[23:16];
  logic [7:0] select_1615;
  assign select_1615 = select_1489_s3_q[0] ? registration_slope_q[15:8] : registration_slope_q[7:0];
  logic [7:0] select_1617;
  assign select_1617 = select_1489_s3_q[0] ? {{4{registration_slope_change_q[27]}}, registration_slope_change_q[27:24]} : registration_slope_change_q[23:16];
  logic [7:0] select_1618;
  assign select_1618 = select_1489_s3_q[0] ? registration_slope_change_q[15:8] : registration_slope_change_q[7:0];
  logic [7:0] select_1620;
  assign select_1620 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_1614 : select_1615) : (select_1489_s3_q[1] ? select_1617 : select_1618);
  logic [7:0] select_1621;
  assign select_1621 = select_1489_s3_q[0] ? {{4{registration_slope_row_q[23]}}, registration_slope_row_q[23:20]} : registration_slope_row_q[19:12];
  logic [7:0] select_1622;
  assign select_1622 = select_1489_s3_q[0] ? registration_slope_row_q[11:4] : {registration_slope_row_q[3:0], 4'h0};
  logic [7:0] select_1624;
  assign select_1624 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_1621 : select_1622) : {4'h0, registration_fresh_q};
  // hls/stages/registration.hpp:106
  logic select_1626;
  assign select_1626 = equal_1540 ? inside_v_s3_q[0] : registration_was_inside_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1634;
  assign sum_1634 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1571[9]}}, sum_1571[9:2]};
  // hls/stages/registration.hpp:206
  logic [7:0] select_1637;
  assign select_1637 = ($signed(sum_1634[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1634[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_1639;
  assign select_1639 = equal_1540 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1634[12:7])) ? 8'h7f : select_1637);
  // hls/stages/registration.hpp:250
  logic [7:0] select_1660;
  assign select_1660 = select_1489_s3_q[0] ? {6'h0, registration_displacement_over_q[9:8]} : registration_displacement_over_q[7:0];
  logic [7:0] select_1661;
  assign select_1661 = select_1489_s3_q[1] ? {3'h0, registration_displacement_fraction_q} : select_1660;
  // hls/stages/census.hpp:328
  logic less_1827;
  assign less_1827 = x_s3_q[4:0] < 5'h3;
  logic not_1828;
  assign not_1828 = ~x_s3_q[1];
  logic [2:0] select_1829;
  assign select_1829 = x_s3_q[0] ? {1'b0, not_1828, 1'b0} : {x_s3_q[1], 1'b0, not_1828};
  logic [5:0] select_1830;
  assign select_1830 = slot_s3_q[2] ? {select_1829[2], 1'b0, select_1829[1], 1'b0, select_1829[0], 1'b0} : {1'b0, select_1829[2], 1'b0, select_1829[1], 1'b0, select_1829[0]};
  logic [11:0] select_1831;
  assign select_1831 = slot_s3_q[1] ? {select_1830[5], 1'b0, select_1830[4], 1'b0, select_1830[3], 1'b0, select_1830[2], 1'b0, select_1830[1], 1'b0, select_1830[0], 1'b0} : {1'b0, select_1830[5], 1'b0, select_1830[4], 1'b0, select_1830[3], 1'b0, select_1830[2], 1'b0, select_1830[1], 1'b0, select_1830[0]};
  logic [23:0] select_1832;
  assign select_1832 = slot_s3_q[0] ? {select_1831[11], 1'b0, select_1831[10], 1'b0, select_1831[9], 1'b0, select_1831[8], 1'b0, select_1831[7], 1'b0, select_1831[6], 1'b0, select_1831[5], 1'b0, select_1831[4], 1'b0, select_1831[3], 1'b0, select_1831[2], 1'b0, select_1831[1], 1'b0, select_1831[0], 1'b0} : {1'b0, select_1831[11], 1'b0, select_1831[10], 1'b0, select_1831[9], 1'b0, select_1831[8], 1'b0, select_1831[7], 1'b0, select_1831[6], 1'b0, select_1831[5], 1'b0, select_1831[4], 1'b0, select_1831[3], 1'b0, select_1831[2], 1'b0, select_1831[1], 1'b0, select_1831[0]};
  // hls/stages/census.hpp:291
  logic and_1836;
  assign and_1836 = less_1827 & (~((sharpness_sums_contrast_0_q & select_1832) == 24'h0));
  logic and_1846;
  assign and_1846 = less_1827 & (~((sharpness_sums_contrast_1_q & select_1832) == 24'h0));
  // hls/stages/registration.hpp:250
  logic select_1933;
  assign select_1933 = select_1489_s3_q[0] ? sharpness_last_of_skin_q : sharpness_last_mask_q;
  logic [7:0] select_1934;
  assign select_1934 = select_1489_s3_q[0] ? {7'h0, sharpness_last_mean_1_q[8]} : sharpness_last_mean_1_q[7:0];
  logic [7:0] select_1936;
  assign select_1936 = select_1489_s3_q[0] ? {7'h0, sharpness_last_mean_0_q[8]} : sharpness_last_mean_0_q[7:0];
  logic [7:0] select_1937;
  assign select_1937 = select_1489_s3_q[1] ? select_1936 : {7'h0, sharpness_last_valid_q};
  logic [7:0] select_1938;
  assign select_1938 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_1933} : select_1934) : select_1937;
  logic select_1960;
  assign select_1960 = select_1489_s3_q[0] ? census_columns_values_4_cell_4_of_skin_q : census_columns_values_4_cell_4_mask_q;
  logic [7:0] select_1961;
  assign select_1961 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_4_right_q[8]} : census_columns_values_4_cell_4_right_q[7:0];
  logic [7:0] select_1963;
  assign select_1963 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_4_left_q[8]} : census_columns_values_4_cell_4_left_q[7:0];
  logic select_1964;
  assign select_1964 = select_1489_s3_q[0] ? census_columns_values_4_cell_3_of_skin_q : census_columns_values_4_cell_3_mask_q;
  logic [7:0] select_1966;
  assign select_1966 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_1960} : select_1961) : (select_1489_s3_q[1] ? select_1963 : {7'h0, select_1964});
  logic [7:0] select_1970;
  assign select_1970 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_3_right_q[8]} : census_columns_values_4_cell_3_right_q[7:0];
  logic [7:0] select_1971;
  assign select_1971 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_3_left_q[8]} : census_columns_values_4_cell_3_left_q[7:0];
  logic select_1973;
  assign select_1973 = select_1489_s3_q[0] ? census_columns_values_4_cell_2_of_skin_q : census_columns_values_4_cell_2_mask_q;
  logic [7:0] select_1974;
  assign select_1974 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_2_right_q[8]} : census_columns_values_4_cell_2_right_q[7:0];
  logic [7:0] select_1976;
  assign select_1976 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_1970 : select_1971) : (select_1489_s3_q[1] ? {7'h0, select_1973} : select_1974);
  logic [7:0] select_1977;
  assign select_1977 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_2_left_q[8]} : census_columns_values_4_cell_2_left_q[7:0];
  logic select_1978;
  assign select_1978 = select_1489_s3_q[0] ? census_columns_values_4_cell_1_of_skin_q : census_columns_values_4_cell_1_mask_q;
  logic [7:0] select_1980;
  assign select_1980 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_1_right_q[8]} : census_columns_values_4_cell_1_right_q[7:0];
  logic [7:0] select_1981;
  assign select_1981 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_1_left_q[8]} : census_columns_values_4_cell_1_left_q[7:0];
  logic [7:0] select_1983;
  assign select_1983 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_1977 : {7'h0, select_1978}) : (select_1489_s3_q[1] ? select_1980 : select_1981);
  logic select_1985;
  assign select_1985 = select_1489_s3_q[0] ? census_columns_values_4_cell_0_of_skin_q : census_columns_values_4_cell_0_mask_q;
  logic [7:0] select_1986;
  assign select_1986 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_0_right_q[8]} : census_columns_values_4_cell_0_right_q[7:0];
  logic [7:0] select_1988;
  assign select_1988 = select_1489_s3_q[0] ? {7'h0, census_columns_values_4_cell_0_left_q[8]} : census_columns_values_4_cell_0_left_q[7:0];
  logic select_1989;
  assign select_1989 = select_1489_s3_q[0] ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_3_cell_4_mask_q;
  logic [7:0] select_1991;
  assign select_1991 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_1985} : select_1986) : (select_1489_s3_q[1] ? select_1988 : {7'h0, select_1989});
  logic [7:0] select_1992;
  assign select_1992 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_4_right_q[8]} : census_columns_values_3_cell_4_right_q[7:0];
  logic [7:0] select_1993;
  assign select_1993 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_4_left_q[8]} : census_columns_values_3_cell_4_left_q[7:0];
  logic select_1995;
  assign select_1995 = select_1489_s3_q[0] ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_3_cell_3_mask_q;
  logic [7:0] select_1996;
  assign select_1996 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_3_right_q[8]} : census_columns_values_3_cell_3_right_q[7:0];
  logic [7:0] select_1998;
  assign select_1998 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_1992 : select_1993) : (select_1489_s3_q[1] ? {7'h0, select_1995} : select_1996);
  logic [7:0] select_2000;
  assign select_2000 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_1976 : select_1983) : (select_1489_s3_q[3] ? select_1991 : select_1998);
  logic [7:0] select_2001;
  assign select_2001 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_3_left_q[8]} : census_columns_values_3_cell_3_left_q[7:0];
  logic select_2002;
  assign select_2002 = select_1489_s3_q[0] ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_3_cell_2_mask_q;
  logic [7:0] select_2004;
  assign select_2004 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_2_right_q[8]} : census_columns_values_3_cell_2_right_q[7:0];
  logic [7:0] select_2005;
  assign select_2005 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_2_left_q[8]} : census_columns_values_3_cell_2_left_q[7:0];
  logic [7:0] select_2007;
  assign select_2007 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2001 : {7'h0, select_2002}) : (select_1489_s3_q[1] ? select_2004 : select_2005);
  logic select_2008;
  assign select_2008 = select_1489_s3_q[0] ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_3_cell_1_mask_q;
  logic [7:0] select_2009;
  assign select_2009 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_1_right_q[8]} : census_columns_values_3_cell_1_right_q[7:0];
  logic [7:0] select_2011;
  assign select_2011 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_1_left_q[8]} : census_columns_values_3_cell_1_left_q[7:0];
  logic select_2012;
  assign select_2012 = select_1489_s3_q[0] ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_3_cell_0_mask_q;
  logic [7:0] select_2014;
  assign select_2014 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_2008} : select_2009) : (select_1489_s3_q[1] ? select_2011 : {7'h0, select_2012});
  logic [7:0] select_2016;
  assign select_2016 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_0_right_q[8]} : census_columns_values_3_cell_0_right_q[7:0];
  logic [7:0] select_2017;
  assign select_2017 = select_1489_s3_q[0] ? {7'h0, census_columns_values_3_cell_0_left_q[8]} : census_columns_values_3_cell_0_left_q[7:0];
  logic select_2019;
  assign select_2019 = select_1489_s3_q[0] ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_2_cell_4_mask_q;
  logic [7:0] select_2020;
  assign select_2020 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_4_right_q[8]} : census_columns_values_2_cell_4_right_q[7:0];
  logic [7:0] select_2022;
  assign select_2022 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2016 : select_2017) : (select_1489_s3_q[1] ? {7'h0, select_2019} : select_2020);
  logic [7:0] select_2023;
  assign select_2023 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_4_left_q[8]} : census_columns_values_2_cell_4_left_q[7:0];
  logic select_2024;
  assign select_2024 = select_1489_s3_q[0] ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_2_cell_3_mask_q;
  logic [7:0] select_2026;
  assign select_2026 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_3_right_q[8]} : census_columns_values_2_cell_3_right_q[7:0];
  logic [7:0] select_2027;
  assign select_2027 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_3_left_q[8]} : census_columns_values_2_cell_3_left_q[7:0];
  logic [7:0] select_2029;
  assign select_2029 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2023 : {7'h0, select_2024}) : (select_1489_s3_q[1] ? select_2026 : select_2027);
  logic [7:0] select_2031;
  assign select_2031 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_2007 : select_2014) : (select_1489_s3_q[3] ? select_2022 : select_2029);
  logic select_2034;
  assign select_2034 = select_1489_s3_q[0] ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_2_cell_2_mask_q;
  logic [7:0] select_2035;
  assign select_2035 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_2_right_q[8]} : census_columns_values_2_cell_2_right_q[7:0];
  logic [7:0] select_2037;
  assign select_2037 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_2_left_q[8]} : census_columns_values_2_cell_2_left_q[7:0];
  logic select_2038;
  assign select_2038 = select_1489_s3_q[0] ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_2_cell_1_mask_q;
  logic [7:0] select_2040;
  assign select_2040 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_2034} : select_2035) : (select_1489_s3_q[1] ? select_2037 : {7'h0, select_2038});
  logic [7:0] select_2041;
  assign select_2041 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_1_right_q[8]} : census_columns_values_2_cell_1_right_q[7:0];
  logic [7:0] select_2042;
  assign select_2042 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_1_left_q[8]} : census_columns_values_2_cell_1_left_q[7:0];
  logic select_2044;
  assign select_2044 = select_1489_s3_q[0] ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_2_cell_0_mask_q;
  logic [7:0] select_2045;
  assign select_2045 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_0_right_q[8]} : census_columns_values_2_cell_0_right_q[7:0];
  logic [7:0] select_2047;
  assign select_2047 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2041 : select_2042) : (select_1489_s3_q[1] ? {7'h0, select_2044} : select_2045);
  logic [7:0] select_2049;
  assign select_2049 = select_1489_s3_q[0] ? {7'h0, census_columns_values_2_cell_0_left_q[8]} : census_columns_values_2_cell_0_left_q[7:0];
  logic select_2050;
  assign select_2050 = select_1489_s3_q[0] ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_1_cell_4_mask_q;
  logic [7:0] select_2052;
  assign select_2052 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_4_right_q[8]} : census_columns_values_1_cell_4_right_q[7:0];
  logic [7:0] select_2053;
  assign select_2053 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_4_left_q[8]} : census_columns_values_1_cell_4_left_q[7:0];
  logic [7:0] select_2055;
  assign select_2055 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2049 : {7'h0, select_2050}) : (select_1489_s3_q[1] ? select_2052 : select_2053);
  logic select_2056;
  assign select_2056 = select_1489_s3_q[0] ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_1_cell_3_mask_q;
  logic [7:0] select_2057;
  assign select_2057 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_3_right_q[8]} : census_columns_values_1_cell_3_right_q[7:0];
  logic [7:0] select_2059;
  assign select_2059 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_3_left_q[8]} : census_columns_values_1_cell_3_left_q[7:0];
  logic select_2060;
  assign select_2060 = select_1489_s3_q[0] ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_1_cell_2_mask_q;
  logic [7:0] select_2062;
  assign select_2062 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_2056} : select_2057) : (select_1489_s3_q[1] ? select_2059 : {7'h0, select_2060});
  logic [7:0] select_2064;
  assign select_2064 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_2040 : select_2047) : (select_1489_s3_q[3] ? select_2055 : select_2062);
  logic [7:0] select_2065;
  assign select_2065 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_2_right_q[8]} : census_columns_values_1_cell_2_right_q[7:0];
  logic [7:0] select_2066;
  assign select_2066 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_2_left_q[8]} : census_columns_values_1_cell_2_left_q[7:0];
  logic select_2068;
  assign select_2068 = select_1489_s3_q[0] ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_1_cell_1_mask_q;
  logic [7:0] select_2069;
  assign select_2069 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_1_right_q[8]} : census_columns_values_1_cell_1_right_q[7:0];
  logic [7:0] select_2071;
  assign select_2071 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2065 : select_2066) : (select_1489_s3_q[1] ? {7'h0, select_2068} : select_2069);
  logic [7:0] select_2072;
  assign select_2072 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_1_left_q[8]} : census_columns_values_1_cell_1_left_q[7:0];
  logic select_2073;
  assign select_2073 = select_1489_s3_q[0] ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_1_cell_0_mask_q;
  logic [7:0] select_2075;
  assign select_2075 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_0_right_q[8]} : census_columns_values_1_cell_0_right_q[7:0];
  logic [7:0] select_2076;
  assign select_2076 = select_1489_s3_q[0] ? {7'h0, census_columns_values_1_cell_0_left_q[8]} : census_columns_values_1_cell_0_left_q[7:0];
  logic [7:0] select_2078;
  assign select_2078 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2072 : {7'h0, select_2073}) : (select_1489_s3_q[1] ? select_2075 : select_2076);
  logic select_2080;
  assign select_2080 = select_1489_s3_q[0] ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_0_cell_4_mask_q;
  logic [7:0] select_2081;
  assign select_2081 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_4_right_q[8]} : census_columns_values_0_cell_4_right_q[7:0];
  logic [7:0] select_2083;
  assign select_2083 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_4_left_q[8]} : census_columns_values_0_cell_4_left_q[7:0];
  logic select_2084;
  assign select_2084 = select_1489_s3_q[0] ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_0_cell_3_mask_q;
  logic [7:0] select_2086;
  assign select_2086 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_2080} : select_2081) : (select_1489_s3_q[1] ? select_2083 : {7'h0, select_2084});
  logic [7:0] select_2087;
  assign select_2087 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_3_right_q[8]} : census_columns_values_0_cell_3_right_q[7:0];
  logic [7:0] select_2088;
  assign select_2088 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_3_left_q[8]} : census_columns_values_0_cell_3_left_q[7:0];
  logic select_2090;
  assign select_2090 = select_1489_s3_q[0] ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_0_cell_2_mask_q;
  logic [7:0] select_2091;
  assign select_2091 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_2_right_q[8]} : census_columns_values_0_cell_2_right_q[7:0];
  logic [7:0] select_2093;
  assign select_2093 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2087 : select_2088) : (select_1489_s3_q[1] ? {7'h0, select_2090} : select_2091);
  logic [7:0] select_2095;
  assign select_2095 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_2071 : select_2078) : (select_1489_s3_q[3] ? select_2086 : select_2093);
  logic [7:0] select_2097;
  assign select_2097 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_2_left_q[8]} : census_columns_values_0_cell_2_left_q[7:0];
  logic select_2098;
  assign select_2098 = select_1489_s3_q[0] ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_0_cell_1_mask_q;
  logic [7:0] select_2100;
  assign select_2100 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_1_right_q[8]} : census_columns_values_0_cell_1_right_q[7:0];
  logic [7:0] select_2101;
  assign select_2101 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_1_left_q[8]} : census_columns_values_0_cell_1_left_q[7:0];
  logic [7:0] select_2103;
  assign select_2103 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2097 : {7'h0, select_2098}) : (select_1489_s3_q[1] ? select_2100 : select_2101);
  logic select_2104;
  assign select_2104 = select_1489_s3_q[0] ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_0_cell_0_mask_q;
  logic [7:0] select_2105;
  assign select_2105 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_0_right_q[8]} : census_columns_values_0_cell_0_right_q[7:0];
  logic [7:0] select_2107;
  assign select_2107 = select_1489_s3_q[0] ? {7'h0, census_columns_values_0_cell_0_left_q[8]} : census_columns_values_0_cell_0_left_q[7:0];
  logic [7:0] select_2108;
  assign select_2108 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? {7'h0, select_2104} : select_2105) : select_2107;
  logic [7:0] select_2113;
  assign select_2113 = select_1489_s3_q[0] ? {2'h0, averager_detail_1_q[13:8]} : averager_detail_1_q[7:0];
  logic [7:0] select_2115;
  assign select_2115 = select_1489_s3_q[2] ? {7'h0, select_2111_s3_q} : (select_1489_s3_q[1] ? select_2112_s3_q : select_2113);
  logic [7:0] select_2116;
  assign select_2116 = select_1489_s3_q[0] ? {2'h0, averager_detail_0_q[13:8]} : averager_detail_0_q[7:0];
  logic [7:0] select_2117;
  assign select_2117 = select_1489_s3_q[0] ? {5'h0, averager_total_1_q[10:8]} : averager_total_1_q[7:0];
  logic [7:0] select_2119;
  assign select_2119 = select_1489_s3_q[0] ? {5'h0, averager_total_0_q[10:8]} : averager_total_0_q[7:0];
  logic [7:0] select_2120;
  assign select_2120 = select_1489_s3_q[0] ? {7'h0, averager_quarter_2_1_q[8]} : averager_quarter_2_1_q[7:0];
  logic [7:0] select_2122;
  assign select_2122 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2116 : select_2117) : (select_1489_s3_q[1] ? select_2119 : select_2120);
  logic [7:0] select_2124;
  assign select_2124 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_2103 : select_2108) : (select_1489_s3_q[3] ? select_2115 : select_2122);
  logic [7:0] select_2125;
  assign select_2125 = select_1489_s3_q[0] ? {7'h0, averager_quarter_2_0_q[8]} : averager_quarter_2_0_q[7:0];
  logic [7:0] select_2126;
  assign select_2126 = select_1489_s3_q[0] ? {7'h0, averager_quarter_1_1_q[8]} : averager_quarter_1_1_q[7:0];
  logic [7:0] select_2128;
  assign select_2128 = select_1489_s3_q[0] ? {7'h0, averager_quarter_1_0_q[8]} : averager_quarter_1_0_q[7:0];
  logic [7:0] select_2131;
  assign select_2131 = select_1489_s3_q[2] ? (select_1489_s3_q[1] ? select_2125 : select_2126) : (select_1489_s3_q[1] ? select_2128 : select_2129_s3_q);
  logic [7:0] select_2160;
  assign select_2160 = select_1489_s3_q[4] ? (select_1489_s3_q[3] ? select_2131 : select_2136_s3_q) : select_2159_s3_q;
  logic [7:0] select_2162;
  assign select_2162 = select_1489_s3_q[6] ? (select_1489_s3_q[5] ? select_2064 : select_2095) : (select_1489_s3_q[5] ? select_2124 : select_2160);
  // hls/stages/agreement.hpp:781
  logic or_2169;
  assign or_2169 = select_1526[7] | (~({select_1526[5], select_1526[3], select_1526[1]} == 3'h0));
  // hls/stages/agreement.hpp:780
  logic or_2172;
  assign or_2172 = select_1526[7] | (~({select_1526[6], select_1526[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:779
  logic or_2175;
  assign or_2175 = select_1526[7] | (~(select_1526[6:4] == 3'h0));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_2176;
  assign select_2176 = equal_1383_s3_q ? x_s3_q[5:0] : {region_row_q, or_2175, or_2172, or_2169};
  // hls/stages/agreement.hpp:859
  logic not_2177;
  assign not_2177 = ~equal_1428;
  // hls/stages/agreement.hpp:789
  logic or_2181;
  assign or_2181 = (~sum_1511[5]) | equal_2180_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_2184;
  assign and_2184 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_2181));
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_2198;
  assign and_2198 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_2205;
  assign and_2205 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:752
  logic select_2206;
  assign select_2206 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_2206);
  // hls/stages/agreement.hpp:752
  logic select_2209;
  assign select_2209 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s3_q[0] & (select_2206 ? select_2209 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:980
  logic select_2212;
  assign select_2212 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:984
  logic select_2213;
  assign select_2213 = left_first_s3_q ? select_2212 : read_half_q;
  logic or_2214;
  assign or_2214 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:985
  logic [8:0] select_2215;
  assign select_2215 = or_2214 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:986
  logic [9:0] select_2217;
  assign select_2217 = left_first_s3_q ? 10'h1 : (or_2214 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:989
  logic and_2218;
  assign and_2218 = select_2215[8] & select_2217[9];
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = and_2218 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1000
  logic [5:0] select_2221;
  assign select_2221 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2223;
  assign select_2223 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_2221});
  // hls/stages/agreement.hpp:1010
  logic equal_2224;
  assign equal_2224 = seen_x_q == 3'h7;
  logic [7:0] select_2226;
  assign select_2226 = and_2218 ? 8'h0 : (seen_column_q + {7'h0, equal_2224});
  // hls/stages/agreement.hpp:1013
  logic [10:0] index;
  assign index = select_2223 + {3'h0, select_2226};
  // hls/stages/agreement.hpp:970
  logic [11:0] sum_2228;
  assign sum_2228 = {1'b0, {2{select_2213}}, 2'h0, {2{select_2213}}, 1'b0, {2{select_2213}}, 1'b0, select_2213} + {1'b0, index};
  // hls/stages/agreement.hpp:983
  logic not_2229;
  assign not_2229 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:218
  logic and_2231;
  assign and_2231 = not_2229 & (began_q | and_2218);
  // hls/stages/agreement.hpp:1011
  logic [2:0] select_2233;
  assign select_2233 = and_2218 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1012
  logic and_2235;
  assign and_2235 = and_2231 & (select_2233 == 3'h0);
  logic less_2236;
  assign less_2236 = select_2226 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:220
  logic and_2237;
  assign and_2237 = and_2235 & less_2236;
  logic and_2238;
  assign and_2238 = and_2149_s3_q & and_2237;
  logic select_2240;
  assign select_2240 = and_2149_s3_q ? (left_first_s3_q ? and_2237 : and_2238) : and_2238;
  // hls/stages/agreement.hpp:842
  logic [7:0] sum_2242;
  assign sum_2242 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2242[7], sum_2242, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:970
  logic [11:0] sum_2244;
  assign sum_2244 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:765
  logic and_2245;
  assign and_2245 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_2246;
  assign and_2246 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_2247;
  assign and_2247 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_2248;
  assign and_2248 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:818
  logic [1:0] sum_2250;
  assign sum_2250 = {1'b0, and_2247} + ({1'b0, textured_s3_q} + {1'b0, and_2248});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2245} + ({2'h0, and_2246} + {1'b0, sum_2250});
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2253;
  assign select_2253 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2254;
  assign difference_2254 = {1'b0, textured_2} - {1'b0, select_2253};
  // hls/stages/agreement.hpp:823
  logic equal_2255;
  assign equal_2255 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:825
  logic [4:0] t;
  assign t = {difference_2254[3], difference_2254} + (equal_2255 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_2260;
  assign select_2260 = inside_v_s3_q[0] ? (sum_1511[5] ? select_1526 : {select_1526[6:0], 1'b0}) : select_1526;
  // hls/stages/agreement.hpp:781
  logic or_2263;
  assign or_2263 = select_2260[7] | (~({select_2260[5], select_2260[3], select_2260[1]} == 3'h0));
  // hls/stages/agreement.hpp:765
  logic and_2280;
  assign and_2280 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_2281;
  assign and_2281 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_2282;
  assign and_2282 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_2283;
  assign and_2283 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_2285;
  assign sum_2285 = {1'b0, and_2282} + ({1'b0, shown} + {1'b0, and_2283});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2280} + ({2'h0, and_2281} + {1'b0, sum_2285});
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2288;
  assign select_2288 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2289;
  assign difference_2289 = {1'b0, shown_2} - {1'b0, select_2288};
  logic [4:0] around;
  assign around = {difference_2289[3], difference_2289} + (equal_2255 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:834
  logic [5:0] sum_2292;
  assign sum_2292 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:765
  logic and_2296;
  assign and_2296 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_2297;
  assign and_2297 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_2298;
  assign and_2298 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_2299;
  assign and_2299 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:821
  logic [1:0] sum_2301;
  assign sum_2301 = {1'b0, and_2298} + ({1'b0, near} + {1'b0, and_2299});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2296} + ({2'h0, and_2297} + {1'b0, sum_2301});
  // hls/stages/agreement.hpp:828
  logic [2:0] select_2304;
  assign select_2304 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2305;
  assign difference_2305 = {1'b0, near_2} - {1'b0, select_2304};
  logic [4:0] n;
  assign n = {difference_2305[3], difference_2305} + (equal_2255 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_2344;
  assign select_2344 = sample_pair_whole_s3_q ? (and_414_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2346;
  assign select_2346 = sample_pair_whole_s3_q ? (and_414_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2348;
  assign select_2348 = sample_pair_whole_s3_q ? (and_414_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2350;
  assign select_2350 = sample_pair_whole_s3_q ? (and_414_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  logic [10:0] select_2352;
  assign select_2352 = sample_pair_whole_s3_q ? (and_414_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2354;
  assign select_2354 = sample_pair_whole_s3_q ? (and_414_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2355;
  assign sum_2355 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2356;
  assign difference_2356 = {1'b0, sum_2355[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2357;
  assign xor_2357 = {difference_2356[8:0], sum_2355[0]} ^ {10{difference_2356[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2356[9]} + {1'b0, xor_2357};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_419_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2362;
  assign select_2362 = sample_pair_whole_s3_q ? (and_414_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2363;
  assign sum_2363 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2364;
  assign difference_2364 = {1'b0, sum_2363[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2365;
  assign xor_2365 = {difference_2364[8:0], sum_2363[0]} ^ {10{difference_2364[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_2364[9]} + {1'b0, xor_2365};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_419_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2370;
  assign select_2370 = sample_pair_whole_s3_q ? (and_414_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2378;
  assign select_2378 = and_416_s3_q ? select_422 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2379;
  assign select_2379 = and_416_s3_q ? select_426 : census_columns_values_0_cell_0_right_q;
  logic select_2380;
  assign select_2380 = and_416_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic select_2381;
  assign select_2381 = and_416_s3_q ? and_434_s3_q : census_columns_values_0_cell_0_of_skin_q;
  logic [8:0] select_2382;
  assign select_2382 = and_416_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2383;
  assign select_2383 = and_416_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2384;
  assign select_2384 = and_416_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic select_2385;
  assign select_2385 = and_416_s3_q ? census_memory_rdata_q[19] : census_columns_values_0_cell_1_of_skin_q;
  logic [8:0] select_2386;
  assign select_2386 = and_416_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2387;
  assign select_2387 = and_416_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2388;
  assign select_2388 = and_416_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2389;
  assign select_2389 = and_416_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2390;
  assign select_2390 = and_416_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2391;
  assign select_2391 = and_416_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2392;
  assign select_2392 = and_416_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic select_2393;
  assign select_2393 = and_416_s3_q ? census_memory_rdata_q[59] : census_columns_values_0_cell_3_of_skin_q;
  logic [8:0] select_2394;
  assign select_2394 = and_416_s3_q ? census_memory_rdata_q[68:60] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2395;
  assign select_2395 = and_416_s3_q ? census_memory_rdata_q[77:69] : census_columns_values_0_cell_4_right_q;
  logic select_2396;
  assign select_2396 = and_416_s3_q ? census_memory_rdata_q[78] : census_columns_values_0_cell_4_mask_q;
  logic select_2397;
  assign select_2397 = and_416_s3_q ? census_memory_rdata_q[79] : census_columns_values_0_cell_4_of_skin_q;
  logic [8:0] select_2398;
  assign select_2398 = and_416_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2399;
  assign select_2399 = and_416_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2400;
  assign select_2400 = and_416_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2401;
  assign select_2401 = and_416_s3_q ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_1_cell_0_of_skin_q;
  logic [8:0] select_2402;
  assign select_2402 = and_416_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2403;
  assign select_2403 = and_416_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2404;
  assign select_2404 = and_416_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic select_2405;
  assign select_2405 = and_416_s3_q ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_1_cell_1_of_skin_q;
  logic [8:0] select_2406;
  assign select_2406 = and_416_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2407;
  assign select_2407 = and_416_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2408;
  assign select_2408 = and_416_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2409;
  assign select_2409 = and_416_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2410;
  assign select_2410 = and_416_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2411;
  assign select_2411 = and_416_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2412;
  assign select_2412 = and_416_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic select_2413;
  assign select_2413 = and_416_s3_q ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_1_cell_3_of_skin_q;
  logic [8:0] select_2414;
  assign select_2414 = and_416_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2415;
  assign select_2415 = and_416_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2416;
  assign select_2416 = and_416_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic select_2417;
  assign select_2417 = and_416_s3_q ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_1_cell_4_of_skin_q;
  logic [8:0] select_2418;
  assign select_2418 = and_416_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2419;
  assign select_2419 = and_416_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2420;
  assign select_2420 = and_416_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2421;
  assign select_2421 = and_416_s3_q ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_2_cell_0_of_skin_q;
  logic [8:0] select_2422;
  assign select_2422 = and_416_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2423;
  assign select_2423 = and_416_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2424;
  assign select_2424 = and_416_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic select_2425;
  assign select_2425 = and_416_s3_q ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_2_cell_1_of_skin_q;
  logic [8:0] select_2426;
  assign select_2426 = and_416_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2427;
  assign select_2427 = and_416_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2428;
  assign select_2428 = and_416_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2429;
  assign select_2429 = and_416_s3_q ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_2_cell_2_of_skin_q;
  logic [8:0] select_2430;
  assign select_2430 = and_416_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2431;
  assign select_2431 = and_416_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2432;
  assign select_2432 = and_416_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic select_2433;
  assign select_2433 = and_416_s3_q ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_2_cell_3_of_skin_q;
  logic [8:0] select_2434;
  assign select_2434 = and_416_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2435;
  assign select_2435 = and_416_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2436;
  assign select_2436 = and_416_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2437;
  assign select_2437 = and_416_s3_q ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_2_cell_4_of_skin_q;
  logic [8:0] select_2438;
  assign select_2438 = and_416_s3_q ? census_columns_values_2_cell_0_left_q : census_columns_values_3_cell_0_left_q;
  logic [8:0] select_2439;
  assign select_2439 = and_416_s3_q ? census_columns_values_2_cell_0_right_q : census_columns_values_3_cell_0_right_q;
  logic select_2440;
  assign select_2440 = and_416_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic select_2441;
  assign select_2441 = and_416_s3_q ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_3_cell_0_of_skin_q;
  logic [8:0] select_2442;
  assign select_2442 = and_416_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2443;
  assign select_2443 = and_416_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2444;
  assign select_2444 = and_416_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2445;
  assign select_2445 = and_416_s3_q ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_3_cell_1_of_skin_q;
  logic [8:0] select_2446;
  assign select_2446 = and_416_s3_q ? census_columns_values_2_cell_2_left_q : census_columns_values_3_cell_2_left_q;
  logic [8:0] select_2447;
  assign select_2447 = and_416_s3_q ? census_columns_values_2_cell_2_right_q : census_columns_values_3_cell_2_right_q;
  logic select_2448;
  assign select_2448 = and_416_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2449;
  assign select_2449 = and_416_s3_q ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_3_cell_2_of_skin_q;
  logic [8:0] select_2450;
  assign select_2450 = and_416_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2451;
  assign select_2451 = and_416_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2452;
  assign select_2452 = and_416_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2453;
  assign select_2453 = and_416_s3_q ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_3_cell_3_of_skin_q;
  logic [8:0] select_2454;
  assign select_2454 = and_416_s3_q ? census_columns_values_2_cell_4_left_q : census_columns_values_3_cell_4_left_q;
  logic [8:0] select_2455;
  assign select_2455 = and_416_s3_q ? census_columns_values_2_cell_4_right_q : census_columns_values_3_cell_4_right_q;
  logic select_2456;
  assign select_2456 = and_416_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  logic select_2457;
  assign select_2457 = and_416_s3_q ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_3_cell_4_of_skin_q;
  logic [8:0] select_2458;
  assign select_2458 = and_416_s3_q ? census_columns_values_3_cell_0_left_q : census_columns_values_4_cell_0_left_q;
  logic [8:0] select_2459;
  assign select_2459 = and_416_s3_q ? census_columns_values_3_cell_0_right_q : census_columns_values_4_cell_0_right_q;
  logic select_2460;
  assign select_2460 = and_416_s3_q ? census_columns_values_3_cell_0_mask_q : census_columns_values_4_cell_0_mask_q;
  logic select_2461;
  assign select_2461 = and_416_s3_q ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_4_cell_0_of_skin_q;
  logic [8:0] select_2462;
  assign select_2462 = and_416_s3_q ? census_columns_values_3_cell_1_left_q : census_columns_values_4_cell_1_left_q;
  logic [8:0] select_2463;
  assign select_2463 = and_416_s3_q ? census_columns_values_3_cell_1_right_q : census_columns_values_4_cell_1_right_q;
  logic select_2464;
  assign select_2464 = and_416_s3_q ? census_columns_values_3_cell_1_mask_q : census_columns_values_4_cell_1_mask_q;
  logic select_2465;
  assign select_2465 = and_416_s3_q ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_4_cell_1_of_skin_q;
  logic [8:0] select_2466;
  assign select_2466 = and_416_s3_q ? census_columns_values_3_cell_2_left_q : census_columns_values_4_cell_2_left_q;
  logic [8:0] select_2467;
  assign select_2467 = and_416_s3_q ? census_columns_values_3_cell_2_right_q : census_columns_values_4_cell_2_right_q;
  logic select_2468;
  assign select_2468 = and_416_s3_q ? census_columns_values_3_cell_2_mask_q : census_columns_values_4_cell_2_mask_q;
  logic select_2469;
  assign select_2469 = and_416_s3_q ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_4_cell_2_of_skin_q;
  logic [8:0] select_2470;
  assign select_2470 = and_416_s3_q ? census_columns_values_3_cell_3_left_q : census_columns_values_4_cell_3_left_q;
  logic [8:0] select_2471;
  assign select_2471 = and_416_s3_q ? census_columns_values_3_cell_3_right_q : census_columns_values_4_cell_3_right_q;
  logic select_2472;
  assign select_2472 = and_416_s3_q ? census_columns_values_3_cell_3_mask_q : census_columns_values_4_cell_3_mask_q;
  logic select_2473;
  assign select_2473 = and_416_s3_q ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_4_cell_3_of_skin_q;
  logic [8:0] select_2474;
  assign select_2474 = and_416_s3_q ? census_columns_values_3_cell_4_left_q : census_columns_values_4_cell_4_left_q;
  logic [8:0] select_2475;
  assign select_2475 = and_416_s3_q ? census_columns_values_3_cell_4_right_q : census_columns_values_4_cell_4_right_q;
  logic select_2476;
  assign select_2476 = and_416_s3_q ? census_columns_values_3_cell_4_mask_q : census_columns_values_4_cell_4_mask_q;
  logic select_2477;
  assign select_2477 = and_416_s3_q ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_4_cell_4_of_skin_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_2479;
  assign difference_2479 = {1'b0, select_426} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2480;
  assign xor_2480 = difference_2479[8:0] ^ {9{difference_2479[9]}};
  logic [9:0] sum_2481;
  assign sum_2481 = {9'h0, difference_2479[9]} + {1'b0, xor_2480};
  logic [9:0] difference_2482;
  assign difference_2482 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2483;
  assign xor_2483 = difference_2482[8:0] ^ {9{difference_2482[9]}};
  logic [9:0] sum_2484;
  assign sum_2484 = {9'h0, difference_2482[9]} + {1'b0, xor_2483};
  logic [9:0] difference_2486;
  assign difference_2486 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2487;
  assign xor_2487 = difference_2486[8:0] ^ {9{difference_2486[9]}};
  logic [9:0] sum_2488;
  assign sum_2488 = {9'h0, difference_2486[9]} + {1'b0, xor_2487};
  logic [10:0] sum_2489;
  assign sum_2489 = ({1'b0, sum_2481} + {1'b0, sum_2484}) + {1'b0, sum_2488};
  logic [9:0] difference_2490;
  assign difference_2490 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2491;
  assign xor_2491 = difference_2490[8:0] ^ {9{difference_2490[9]}};
  logic [9:0] sum_2492;
  assign sum_2492 = {9'h0, difference_2490[9]} + {1'b0, xor_2491};
  logic [9:0] difference_2494;
  assign difference_2494 = {1'b0, census_memory_rdata_q[77:69]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2495;
  assign xor_2495 = difference_2494[8:0] ^ {9{difference_2494[9]}};
  logic [9:0] sum_2496;
  assign sum_2496 = {9'h0, difference_2494[9]} + {1'b0, xor_2495};
  // hls/stages/census.hpp:275
  logic and_2527;
  assign and_2527 = whole_2_s3_q & (~(column_s3_q[5:1] == 5'h0));
  // hls/stages/census.hpp:273
  logic [9:0] difference_2528;
  assign difference_2528 = {1'b0, select_422} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2528[9]} + (difference_2528[8:0] ^ {9{difference_2528[9]}});
  // hls/stages/agreement.hpp:311
  logic and_2533;
  assign and_2533 = and_2527 & (sharpness_last_mask_q & (7'h2 < contrast[8:2]));
  // hls/stages/census.hpp:273
  logic [9:0] difference_2539;
  assign difference_2539 = {1'b0, select_426} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2539[9]} + (difference_2539[8:0] ^ {9{difference_2539[9]}});
  // hls/stages/agreement.hpp:311
  logic and_2544;
  assign and_2544 = and_2527 & (sharpness_last_mask_q & (7'h2 < contrast_2[8:2]));
  // hls/stages/census.hpp:277
  logic [8:0] select_2551;
  assign select_2551 = and_2533 ? contrast : 9'h0;
  logic [23:0] sum_2552;
  assign sum_2552 = (equal_2506_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2551};
  logic [8:0] select_2555;
  assign select_2555 = and_2544 ? contrast_2 : 9'h0;
  logic [23:0] sum_2556;
  assign sum_2556 = (equal_2506_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2555};
  // hls/stages/agreement.hpp:365
  logic and_2622;
  assign and_2622 = and_416_s3_q & (equal_477_s3_q & equal_2560_s3_q);
  // hls/stages/agreement.hpp:211
  logic and_2625;
  assign and_2625 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:765
  logic and_2646;
  assign and_2646 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_2647;
  assign and_2647 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_2648;
  assign and_2648 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_2649;
  assign and_2649 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:819
  logic [1:0] sum_2651;
  assign sum_2651 = {1'b0, and_2648} + ({1'b0, explained} + {1'b0, and_2649});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2646} + ({2'h0, and_2647} + {1'b0, sum_2651});
  // hls/stages/agreement.hpp:826
  logic [2:0] select_2654;
  assign select_2654 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2655;
  assign difference_2655 = {1'b0, explained_2} - {1'b0, select_2654};
  logic [4:0] e;
  assign e = {difference_2655[3], difference_2655} + (equal_2255 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_2658;
  assign sum_2658 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:211
  logic and_2686;
  assign and_2686 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  logic [7:0] select_2707;
  assign select_2707 = equal_1383_s3_q ? registration_slope_here_q : (so_s3_q ? select_1639 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2708;
  assign equal_2708 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:211
  logic select_2737;
  assign select_2737 = so_s3_q ? (equal_2708 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2740;
  assign select_2740 = equal_1383_s3_q ? registration_was_inside_q : (so_s3_q ? select_1626 : registration_was_inside_q);
  // hls/stages/registration.hpp:253
  logic [3:0] select_2744;
  assign select_2744 = (sum_1434_s3_q == 2'h2) ? (registration_fresh_q & (~select_1478)) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_2746;
  assign select_2746 = so_s3_q ? (and_1473 ? select_2744 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_2748;
  assign select_2748 = and_2622 ? 4'hf : (equal_1383_s3_q ? registration_fresh_q : select_2746);
  // hls/stages/registration.hpp:121
  logic [15:0] select_2755;
  assign select_2755 = and_2754_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_2757;
  assign select_2757 = and_2752_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2755[15]}}, select_2755});
  // hls/stages/registration.hpp:122
  logic [15:0] select_2758;
  assign select_2758 = and_2754_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2758[15]}}, select_2758};
  // hls/stages/registration.hpp:124
  logic [27:0] select_2760;
  assign select_2760 = and_2752_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:117
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_1521_s3_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:860
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1431;
  // hls/stages/registration.hpp:243
  logic not_2768;
  assign not_2768 = ~quarter_2[1];
  logic [3:0] select_2769;
  assign select_2769 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2768, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2768};
  // hls/stages/agreement.hpp:211
  logic select_2857;
  assign select_2857 = equal_1383_s3_q ? shown_shown_q : (so_s3_q ? select_2206 : shown_shown_q);
  logic select_2859;
  assign select_2859 = equal_1383_s3_q ? shown_nearer_q : (so_s3_q ? select_2209 : shown_nearer_q);
  // hls/stages/agreement.hpp:314
  logic [2:0] select_2862;
  assign select_2862 = less_2860_s3_q ? (sum_1496[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2864;
  assign select_2864 = equal_2560_s3_q ? (equal_477_s3_q ? 3'h0 : select_2862) : region_row_q;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2868;
  assign select_2868 = equal_1383_s3_q ? select_1526 : (so_s3_q ? (ends_cell_s3_q ? select_2260 : select_1526) : 8'h1);
  // hls/stages/agreement.hpp:314
  logic [7:0] select_2870;
  assign select_2870 = equal_2560_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_2873;
  assign select_2873 = equal_2560_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  logic [8:0] select_2877;
  assign select_2877 = equal_477_s3_q ? {{2{difference_2875[6]}}, difference_2875} : (less_2860_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2879;
  assign select_2879 = and_416_s3_q ? (equal_2560_s3_q ? select_2877 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [6:0] select_2881;
  assign select_2881 = equal_477_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_2883;
  assign select_2883 = and_416_s3_q ? (equal_2560_s3_q ? select_2881 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1496[7];
  // hls/stages/agreement.hpp:314
  logic select_2887;
  assign select_2887 = equal_2560_s3_q ? (equal_477_s3_q | (less_2860_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:765
  logic select_2894;
  assign select_2894 = inside_v_s3_q[0] ? (sum_1511[5] ? (equal_2180_s3_q & or_2181) : or_2181) : or_1490;
  // hls/stages/agreement.hpp:211
  logic select_2897;
  assign select_2897 = equal_1383_s3_q ? or_1490 : (so_s3_q ? (ends_cell_s3_q ? select_2894 : or_1490) : or_1490);
  // hls/stages/agreement.hpp:872
  logic equal_2922;
  assign equal_2922 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_2973;
  assign select_2973 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_2975;
  assign select_2975 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_2977;
  assign select_2977 = equal_1383_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_2975 : box_textured_columns_values_1_q);
  logic [2:0] select_2978;
  assign select_2978 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_2980;
  assign select_2980 = equal_1383_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_2978 : box_textured_columns_values_2_q);
  logic [2:0] select_2981;
  assign select_2981 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_2983;
  assign select_2983 = equal_1383_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_2981 : box_textured_columns_values_3_q);
  logic [2:0] select_2984;
  assign select_2984 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_2986;
  assign select_2986 = equal_1383_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_2984 : box_textured_columns_values_4_q);
  logic [4:0] select_2988;
  assign select_2988 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_2991;
  assign select_2991 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_2993;
  assign select_2993 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_2995;
  assign select_2995 = equal_1383_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_2993 : box_explained_columns_values_1_q);
  logic [2:0] select_2996;
  assign select_2996 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_2998;
  assign select_2998 = equal_1383_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_2996 : box_explained_columns_values_2_q);
  logic [2:0] select_2999;
  assign select_2999 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3001;
  assign select_3001 = equal_1383_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_2999 : box_explained_columns_values_3_q);
  logic [2:0] select_3002;
  assign select_3002 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3004;
  assign select_3004 = equal_1383_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3002 : box_explained_columns_values_4_q);
  logic [4:0] select_3006;
  assign select_3006 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3007;
  assign select_3007 = equal_1383_s3_q ? box_explained_sum_sums_values_0_q : select_3006;
  logic [2:0] select_3009;
  assign select_3009 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3011;
  assign select_3011 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3013;
  assign select_3013 = equal_1383_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3011 : box_shown_columns_values_1_q);
  logic [2:0] select_3014;
  assign select_3014 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3016;
  assign select_3016 = equal_1383_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3014 : box_shown_columns_values_2_q);
  logic [2:0] select_3017;
  assign select_3017 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3019;
  assign select_3019 = equal_1383_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3017 : box_shown_columns_values_3_q);
  logic [2:0] select_3020;
  assign select_3020 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3022;
  assign select_3022 = equal_1383_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3020 : box_shown_columns_values_4_q);
  logic [4:0] select_3024;
  assign select_3024 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3027;
  assign select_3027 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3029;
  assign select_3029 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3031;
  assign select_3031 = equal_1383_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3029 : box_nearer_columns_values_1_q);
  logic [2:0] select_3032;
  assign select_3032 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3034;
  assign select_3034 = equal_1383_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3032 : box_nearer_columns_values_2_q);
  logic [2:0] select_3035;
  assign select_3035 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3037;
  assign select_3037 = equal_1383_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3035 : box_nearer_columns_values_3_q);
  logic [2:0] select_3038;
  assign select_3038 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3040;
  assign select_3040 = equal_1383_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3038 : box_nearer_columns_values_4_q);
  logic [4:0] select_3042;
  assign select_3042 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3045;
  assign select_3045 = so_s3_q ? (ends_cell_s3_q ? and_2247 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3048;
  assign select_3048 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3050;
  assign select_3050 = equal_1383_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3048 : centres_values_0_of_skin_q);
  logic select_3051;
  assign select_3051 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3053;
  assign select_3053 = equal_1383_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3051 : centres_values_1_textured_q);
  logic select_3054;
  assign select_3054 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3056;
  assign select_3056 = equal_1383_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3054 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:314
  logic [10:0] select_3060;
  assign select_3060 = equal_2560_s3_q ? (equal_3057_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [5:0] select_3063;
  assign select_3063 = and_416_s3_q ? (equal_2560_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:980
  logic xor_3064;
  assign xor_3064 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:220
  logic select_3066;
  assign select_3066 = and_2149_s3_q ? (left_first_s3_q ? xor_3064 : write_half_q) : write_half_q;
  logic select_3068;
  assign select_3068 = and_2149_s3_q ? (left_first_s3_q ? xor_3064 : select_3066) : write_half_q;
  logic select_3070;
  assign select_3070 = left_first_s3_q ? select_2212 : (and_2149_s3_q ? select_2213 : read_half_q);
  logic and_3074;
  assign and_3074 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3083;
  assign select_3083 = left_first_s3_q ? 10'h1 : (and_2149_s3_q ? select_2217 : rows_passed_q);
  logic [8:0] select_3086;
  assign select_3086 = left_first_s3_q ? {select_2215[7:0], or_2214} : (and_2149_s3_q ? {select_2215[7:0], or_2214} : columns_passed_q);
  logic select_3089;
  assign select_3089 = left_first_s3_q ? marks_last_s3_q : (and_2149_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3092;
  assign select_3092 = left_first_s3_q ? and_2231 : (and_2149_s3_q ? and_2231 : began_q);
  logic [2:0] select_3095;
  assign select_3095 = left_first_s3_q ? select_2233 : (and_2149_s3_q ? select_2233 : seen_x_q);
  // hls/stages/agreement.hpp:1009
  logic [2:0] select_3100;
  assign select_3100 = left_first_s3_q ? 3'h0 : (and_2218 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:220
  logic [2:0] select_3102;
  assign select_3102 = left_first_s3_q ? 3'h0 : (and_2149_s3_q ? select_3100 : seen_y_q);
  logic [7:0] select_3105;
  assign select_3105 = left_first_s3_q ? select_2226 : (and_2149_s3_q ? select_2226 : seen_column_q);
  // hls/stages/agreement.hpp:218
  logic [7:0] select_3111;
  assign select_3111 = left_first_s3_q ? select_3109 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:220
  logic [7:0] select_3113;
  assign select_3113 = left_first_s3_q ? select_3109 : (and_2149_s3_q ? select_3111 : seen_rows_left_q);
  // hls/stages/agreement.hpp:218
  logic and_3118;
  assign and_3118 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:220
  logic select_3120;
  assign select_3120 = left_first_s3_q ? and_3118 : (and_2149_s3_q ? and_3118 : at_cell_end_q);
  logic select_3123;
  assign select_3123 = left_first_s3_q ? next_row : (and_2149_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3126;
  assign select_3126 = left_first_s3_q ? 11'h0 : (and_2149_s3_q ? select_2223 : seen_base_q);
  // hls/stages/registration.hpp:243
  logic not_3187;
  assign not_3187 = ~quarter[1];
  logic [3:0] select_3188;
  assign select_3188 = quarter[0] ? {quarter[1], 1'b0, not_3187, 1'b0} : {1'b0, quarter[1], 1'b0, not_3187};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:260; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1435;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1383_s3_q ? (x_s3_q[6] & select_1463) : and_1474);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1093; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2176;
  logic regions_re;
  assign regions_re = s3_en & (equal_1383_s3_q ? (x_s3_q[6] & not_2177) : and_2184);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1104; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2228;
  logic map_re;
  assign map_re = s3_en & select_2240;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_416_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[59:0], and_434_s3_q, whole_2_s3_q, select_426, select_422};
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

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_1422_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1427_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1424, not_1423};
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

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1418_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2205, textured_s3_q};
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
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
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
    end else if (s3_en) begin
      sharpness_sums_contrast_0_q <= and_416_s3_q ? sum_2552 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_416_s3_q ? sum_2556 : sharpness_sums_contrast_1_q;
      registration_slope_here_q <= select_2707;
      registration_of_right_q <= equal_1383_s3_q ? registration_of_right_q : select_2737;
      registration_was_inside_q <= select_2740;
      registration_fresh_q <= select_2748;
      registration_slope_row_q <= select_2757;
      registration_slope_change_q <= select_2760;
      registration_slope_q <= so_s3_q ? column_5 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_2857;
      shown_nearer_q <= select_2859;
      region_row_q <= and_416_s3_q ? select_2864 : region_row_q;
      next_region_row_q <= sum_1527;
      region_columns_q <= select_2868;
      region_across_rest_q <= select_1523;
      region_across_back_q <= select_1519;
      region_across_next_q <= select_1513;
      columns_begin_rest_q <= and_416_s3_q ? select_2870 : columns_begin_rest_q;
      columns_begin_back_q <= and_416_s3_q ? select_2873 : columns_begin_back_q;
      region_down_rest_q <= select_2879;
      region_down_back_q <= select_2883;
      region_down_next_q <= select_1498;
      region_fresh_q <= and_416_s3_q ? select_2887 : region_fresh_q;
      segment_starts_q <= select_2897;
      centres_values_0_textured_q <= equal_1383_s3_q ? centres_values_0_textured_q : select_3045;
      centres_values_0_of_skin_q <= select_3050;
      centres_values_1_textured_q <= select_3053;
      centres_values_1_of_skin_q <= select_3056;
      map_row_q <= and_416_s3_q ? select_3060 : map_row_q;
      map_width_q <= select_3063;
      write_half_q <= select_3068;
      read_half_q <= and_2149_s3_q ? select_3070 : read_half_q;
      done_q <= and_2149_s3_q ? (not_2229 & and_3074) : and_3074;
      drew_q <= so_s3_q;
      said_q <= equal_1383_s3_q & equal_2922;
      rows_passed_q <= and_2149_s3_q ? select_3083 : rows_passed_q;
      columns_passed_q <= and_2149_s3_q ? select_3086 : columns_passed_q;
      line_ended_q <= and_2149_s3_q ? select_3089 : line_ended_q;
      began_q <= and_2149_s3_q ? select_3092 : began_q;
      seen_x_q <= and_2149_s3_q ? select_3095 : seen_x_q;
      seen_y_q <= and_2149_s3_q ? select_3102 : seen_y_q;
      seen_column_q <= and_2149_s3_q ? select_3105 : seen_column_q;
      seen_rows_left_q <= and_2149_s3_q ? select_3113 : seen_rows_left_q;
      at_cell_end_q <= and_2149_s3_q ? select_3120 : at_cell_end_q;
      was_next_row_q <= and_2149_s3_q ? select_3123 : was_next_row_q;
      seen_base_q <= and_2149_s3_q ? select_3126 : seen_base_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_0_cell_0_of_skin_q = 1'b0;
    census_columns_values_0_cell_1_left_q = 9'h0;
    census_columns_values_0_cell_1_right_q = 9'h0;
    census_columns_values_0_cell_1_mask_q = 1'b0;
    census_columns_values_0_cell_1_of_skin_q = 1'b0;
    census_columns_values_0_cell_2_left_q = 9'h0;
    census_columns_values_0_cell_2_right_q = 9'h0;
    census_columns_values_0_cell_2_mask_q = 1'b0;
    census_columns_values_0_cell_2_of_skin_q = 1'b0;
    census_columns_values_0_cell_3_left_q = 9'h0;
    census_columns_values_0_cell_3_right_q = 9'h0;
    census_columns_values_0_cell_3_mask_q = 1'b0;
    census_columns_values_0_cell_3_of_skin_q = 1'b0;
    census_columns_values_0_cell_4_left_q = 9'h0;
    census_columns_values_0_cell_4_right_q = 9'h0;
    census_columns_values_0_cell_4_mask_q = 1'b0;
    census_columns_values_0_cell_4_of_skin_q = 1'b0;
    census_columns_values_1_cell_0_left_q = 9'h0;
    census_columns_values_1_cell_0_right_q = 9'h0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_0_of_skin_q = 1'b0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_1_of_skin_q = 1'b0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_3_of_skin_q = 1'b0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_1_cell_4_of_skin_q = 1'b0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_0_of_skin_q = 1'b0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_1_of_skin_q = 1'b0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_2_of_skin_q = 1'b0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_3_of_skin_q = 1'b0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_4_of_skin_q = 1'b0;
    census_columns_values_3_cell_0_left_q = 9'h0;
    census_columns_values_3_cell_0_right_q = 9'h0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_0_of_skin_q = 1'b0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_1_of_skin_q = 1'b0;
    census_columns_values_3_cell_2_left_q = 9'h0;
    census_columns_values_3_cell_2_right_q = 9'h0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_2_of_skin_q = 1'b0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    census_columns_values_3_cell_3_of_skin_q = 1'b0;
    census_columns_values_3_cell_4_left_q = 9'h0;
    census_columns_values_3_cell_4_right_q = 9'h0;
    census_columns_values_3_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_4_of_skin_q = 1'b0;
    census_columns_values_4_cell_0_left_q = 9'h0;
    census_columns_values_4_cell_0_right_q = 9'h0;
    census_columns_values_4_cell_0_mask_q = 1'b0;
    census_columns_values_4_cell_0_of_skin_q = 1'b0;
    census_columns_values_4_cell_1_left_q = 9'h0;
    census_columns_values_4_cell_1_right_q = 9'h0;
    census_columns_values_4_cell_1_mask_q = 1'b0;
    census_columns_values_4_cell_1_of_skin_q = 1'b0;
    census_columns_values_4_cell_2_left_q = 9'h0;
    census_columns_values_4_cell_2_right_q = 9'h0;
    census_columns_values_4_cell_2_mask_q = 1'b0;
    census_columns_values_4_cell_2_of_skin_q = 1'b0;
    census_columns_values_4_cell_3_left_q = 9'h0;
    census_columns_values_4_cell_3_right_q = 9'h0;
    census_columns_values_4_cell_3_mask_q = 1'b0;
    census_columns_values_4_cell_3_of_skin_q = 1'b0;
    census_columns_values_4_cell_4_left_q = 9'h0;
    census_columns_values_4_cell_4_right_q = 9'h0;
    census_columns_values_4_cell_4_mask_q = 1'b0;
    census_columns_values_4_cell_4_of_skin_q = 1'b0;
    sharpness_last_valid_q = 1'b0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_of_skin_q = 1'b0;
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
      averager_quarter_1_0_q <= select_2344;
      averager_quarter_1_1_q <= select_2346;
      averager_quarter_2_0_q <= select_2348;
      averager_quarter_2_1_q <= select_2350;
      averager_total_0_q <= select_2352;
      averager_total_1_q <= select_2354;
      averager_detail_0_q <= select_2362;
      averager_detail_1_q <= select_2370;
      census_columns_values_0_cell_0_left_q <= select_2378;
      census_columns_values_0_cell_0_right_q <= select_2379;
      census_columns_values_0_cell_0_mask_q <= select_2380;
      census_columns_values_0_cell_0_of_skin_q <= select_2381;
      census_columns_values_0_cell_1_left_q <= select_2382;
      census_columns_values_0_cell_1_right_q <= select_2383;
      census_columns_values_0_cell_1_mask_q <= select_2384;
      census_columns_values_0_cell_1_of_skin_q <= select_2385;
      census_columns_values_0_cell_2_left_q <= select_2386;
      census_columns_values_0_cell_2_right_q <= select_2387;
      census_columns_values_0_cell_2_mask_q <= select_2388;
      census_columns_values_0_cell_2_of_skin_q <= select_2389;
      census_columns_values_0_cell_3_left_q <= select_2390;
      census_columns_values_0_cell_3_right_q <= select_2391;
      census_columns_values_0_cell_3_mask_q <= select_2392;
      census_columns_values_0_cell_3_of_skin_q <= select_2393;
      census_columns_values_0_cell_4_left_q <= select_2394;
      census_columns_values_0_cell_4_right_q <= select_2395;
      census_columns_values_0_cell_4_mask_q <= select_2396;
      census_columns_values_0_cell_4_of_skin_q <= select_2397;
      census_columns_values_1_cell_0_left_q <= select_2398;
      census_columns_values_1_cell_0_right_q <= select_2399;
      census_columns_values_1_cell_0_mask_q <= select_2400;
      census_columns_values_1_cell_0_of_skin_q <= select_2401;
      census_columns_values_1_cell_1_left_q <= select_2402;
      census_columns_values_1_cell_1_right_q <= select_2403;
      census_columns_values_1_cell_1_mask_q <= select_2404;
      census_columns_values_1_cell_1_of_skin_q <= select_2405;
      census_columns_values_1_cell_2_left_q <= select_2406;
      census_columns_values_1_cell_2_right_q <= select_2407;
      census_columns_values_1_cell_2_mask_q <= select_2408;
      census_columns_values_1_cell_2_of_skin_q <= select_2409;
      census_columns_values_1_cell_3_left_q <= select_2410;
      census_columns_values_1_cell_3_right_q <= select_2411;
      census_columns_values_1_cell_3_mask_q <= select_2412;
      census_columns_values_1_cell_3_of_skin_q <= select_2413;
      census_columns_values_1_cell_4_left_q <= select_2414;
      census_columns_values_1_cell_4_right_q <= select_2415;
      census_columns_values_1_cell_4_mask_q <= select_2416;
      census_columns_values_1_cell_4_of_skin_q <= select_2417;
      census_columns_values_2_cell_0_left_q <= select_2418;
      census_columns_values_2_cell_0_right_q <= select_2419;
      census_columns_values_2_cell_0_mask_q <= select_2420;
      census_columns_values_2_cell_0_of_skin_q <= select_2421;
      census_columns_values_2_cell_1_left_q <= select_2422;
      census_columns_values_2_cell_1_right_q <= select_2423;
      census_columns_values_2_cell_1_mask_q <= select_2424;
      census_columns_values_2_cell_1_of_skin_q <= select_2425;
      census_columns_values_2_cell_2_left_q <= select_2426;
      census_columns_values_2_cell_2_right_q <= select_2427;
      census_columns_values_2_cell_2_mask_q <= select_2428;
      census_columns_values_2_cell_2_of_skin_q <= select_2429;
      census_columns_values_2_cell_3_left_q <= select_2430;
      census_columns_values_2_cell_3_right_q <= select_2431;
      census_columns_values_2_cell_3_mask_q <= select_2432;
      census_columns_values_2_cell_3_of_skin_q <= select_2433;
      census_columns_values_2_cell_4_left_q <= select_2434;
      census_columns_values_2_cell_4_right_q <= select_2435;
      census_columns_values_2_cell_4_mask_q <= select_2436;
      census_columns_values_2_cell_4_of_skin_q <= select_2437;
      census_columns_values_3_cell_0_left_q <= select_2438;
      census_columns_values_3_cell_0_right_q <= select_2439;
      census_columns_values_3_cell_0_mask_q <= select_2440;
      census_columns_values_3_cell_0_of_skin_q <= select_2441;
      census_columns_values_3_cell_1_left_q <= select_2442;
      census_columns_values_3_cell_1_right_q <= select_2443;
      census_columns_values_3_cell_1_mask_q <= select_2444;
      census_columns_values_3_cell_1_of_skin_q <= select_2445;
      census_columns_values_3_cell_2_left_q <= select_2446;
      census_columns_values_3_cell_2_right_q <= select_2447;
      census_columns_values_3_cell_2_mask_q <= select_2448;
      census_columns_values_3_cell_2_of_skin_q <= select_2449;
      census_columns_values_3_cell_3_left_q <= select_2450;
      census_columns_values_3_cell_3_right_q <= select_2451;
      census_columns_values_3_cell_3_mask_q <= select_2452;
      census_columns_values_3_cell_3_of_skin_q <= select_2453;
      census_columns_values_3_cell_4_left_q <= select_2454;
      census_columns_values_3_cell_4_right_q <= select_2455;
      census_columns_values_3_cell_4_mask_q <= select_2456;
      census_columns_values_3_cell_4_of_skin_q <= select_2457;
      census_columns_values_4_cell_0_left_q <= select_2458;
      census_columns_values_4_cell_0_right_q <= select_2459;
      census_columns_values_4_cell_0_mask_q <= select_2460;
      census_columns_values_4_cell_0_of_skin_q <= select_2461;
      census_columns_values_4_cell_1_left_q <= select_2462;
      census_columns_values_4_cell_1_right_q <= select_2463;
      census_columns_values_4_cell_1_mask_q <= select_2464;
      census_columns_values_4_cell_1_of_skin_q <= select_2465;
      census_columns_values_4_cell_2_left_q <= select_2466;
      census_columns_values_4_cell_2_right_q <= select_2467;
      census_columns_values_4_cell_2_mask_q <= select_2468;
      census_columns_values_4_cell_2_of_skin_q <= select_2469;
      census_columns_values_4_cell_3_left_q <= select_2470;
      census_columns_values_4_cell_3_right_q <= select_2471;
      census_columns_values_4_cell_3_mask_q <= select_2472;
      census_columns_values_4_cell_3_of_skin_q <= select_2473;
      census_columns_values_4_cell_4_left_q <= select_2474;
      census_columns_values_4_cell_4_right_q <= select_2475;
      census_columns_values_4_cell_4_mask_q <= select_2476;
      census_columns_values_4_cell_4_of_skin_q <= select_2477;
      sharpness_last_valid_q <= sharpness_last_valid_q | and_416_s3_q;
      sharpness_last_mean_0_q <= and_416_s3_q ? select_422 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_416_s3_q ? select_426 : sharpness_last_mean_1_q;
      sharpness_last_mask_q <= and_416_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_of_skin_q <= and_416_s3_q ? and_434_s3_q : sharpness_last_of_skin_q;
      box_textured_columns_values_0_q <= equal_1383_s3_q ? box_textured_columns_values_0_q : select_2973;
      box_textured_columns_values_1_q <= select_2977;
      box_textured_columns_values_2_q <= select_2980;
      box_textured_columns_values_3_q <= select_2983;
      box_textured_columns_values_4_q <= select_2986;
      box_textured_sum_sums_values_0_q <= equal_1383_s3_q ? box_textured_sum_sums_values_0_q : select_2988;
      box_explained_columns_values_0_q <= equal_1383_s3_q ? box_explained_columns_values_0_q : select_2991;
      box_explained_columns_values_1_q <= select_2995;
      box_explained_columns_values_2_q <= select_2998;
      box_explained_columns_values_3_q <= select_3001;
      box_explained_columns_values_4_q <= select_3004;
      box_explained_sum_sums_values_0_q <= select_3007;
      box_shown_columns_values_0_q <= equal_1383_s3_q ? box_shown_columns_values_0_q : select_3009;
      box_shown_columns_values_1_q <= select_3013;
      box_shown_columns_values_2_q <= select_3016;
      box_shown_columns_values_3_q <= select_3019;
      box_shown_columns_values_4_q <= select_3022;
      box_shown_sum_sums_values_0_q <= equal_1383_s3_q ? box_shown_sum_sums_values_0_q : select_3024;
      box_nearer_columns_values_0_q <= equal_1383_s3_q ? box_nearer_columns_values_0_q : select_3027;
      box_nearer_columns_values_1_q <= select_3031;
      box_nearer_columns_values_2_q <= select_3034;
      box_nearer_columns_values_3_q <= select_3037;
      box_nearer_columns_values_4_q <= select_3040;
      box_nearer_sum_sums_values_0_q <= equal_1383_s3_q ? box_nearer_sum_sums_values_0_q : select_3042;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic census_columns_values_1_cell_2_mask_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [23:0] sharpness_sums_contrast_0_s4_q;
  logic [23:0] sharpness_sums_contrast_1_s4_q;
  logic [7:0] x_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic done_s4_q;
  logic [5:0] column_s4_q;
  logic and_416_s4_q;
  logic less_450_s4_q;
  logic less_451_s4_q;
  logic less_452_s4_q;
  logic less_453_s4_q;
  logic less_454_s4_q;
  logic less_455_s4_q;
  logic less_456_s4_q;
  logic less_457_s4_q;
  logic less_458_s4_q;
  logic less_459_s4_q;
  logic less_460_s4_q;
  logic less_461_s4_q;
  logic less_462_s4_q;
  logic less_463_s4_q;
  logic less_464_s4_q;
  logic less_465_s4_q;
  logic less_466_s4_q;
  logic less_467_s4_q;
  logic less_468_s4_q;
  logic less_469_s4_q;
  logic less_470_s4_q;
  logic less_471_s4_q;
  logic less_472_s4_q;
  logic less_473_s4_q;
  logic equal_474_s4_q;
  logic select_479_s4_q;
  logic whole_22_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1383_s4_q;
  logic not_1384_s4_q;
  logic equal_1428_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1434_s4_q;
  logic equal_1436_s4_q;
  logic equal_1438_s4_q;
  logic equal_1440_s4_q;
  logic equal_1442_s4_q;
  logic equal_1444_s4_q;
  logic equal_1446_s4_q;
  logic equal_1448_s4_q;
  logic less_1456_s4_q;
  logic or_1460_s4_q;
  logic equal_1480_s4_q;
  logic equal_1482_s4_q;
  logic [8:0] select_1489_s4_q;
  logic or_1490_s4_q;
  logic [7:0] select_1500_s4_q;
  logic [7:0] select_1517_s4_q;
  logic [7:0] select_1534_s4_q;
  logic and_1537_s4_q;
  logic equal_1540_s4_q;
  logic and_1542_s4_q;
  logic [11:0] residual_s4_q;
  logic [7:0] select_1625_s4_q;
  logic select_1627_s4_q;
  logic [7:0] select_1639_s4_q;
  logic [7:0] select_1661_s4_q;
  logic [7:0] select_1688_s4_q;
  logic [7:0] select_1730_s4_q;
  logic [7:0] select_1771_s4_q;
  logic [7:0] select_1824_s4_q;
  logic equal_1826_s4_q;
  logic and_1836_s4_q;
  logic and_1846_s4_q;
  logic less_1854_s4_q;
  logic [7:0] select_1938_s4_q;
  logic [7:0] select_1966_s4_q;
  logic [7:0] select_2032_s4_q;
  logic and_2149_s4_q;
  logic [7:0] select_2162_s4_q;
  logic and_2166_s4_q;
  logic or_2169_s4_q;
  logic or_2172_s4_q;
  logic or_2175_s4_q;
  logic not_2177_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2198_s4_q;
  logic and_2203_s4_q;
  logic and_2235_s4_q;
  logic less_2236_s4_q;
  logic [11:0] sum_2244_s4_q;
  logic equal_2258_s4_q;
  logic or_2263_s4_q;
  logic or_2266_s4_q;
  logic or_2269_s4_q;
  logic not_2294_s4_q;
  logic less_2308_s4_q;
  logic and_2319_s4_q;
  logic [11:0] sum_2497_s4_q;
  logic equal_2506_s4_q;
  logic [27:0] select_2522_s4_q;
  logic and_2533_s4_q;
  logic and_2544_s4_q;
  logic and_2622_s4_q;
  logic and_2626_s4_q;
  logic not_2660_s4_q;
  logic and_2688_s4_q;
  logic and_2711_s4_q;
  logic equal_2771_s4_q;
  logic equal_2922_s4_q;
  logic and_3129_s4_q;
  logic equal_3190_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      census_columns_values_1_cell_2_mask_s4_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      sharpness_sums_contrast_0_s4_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s4_q <= sharpness_sums_contrast_1_q;
      x_s4_q <= x_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      column_s4_q <= column_s3_q;
      and_416_s4_q <= and_416_s3_q;
      less_450_s4_q <= less_450;
      less_451_s4_q <= less_451;
      less_452_s4_q <= less_452;
      less_453_s4_q <= less_453;
      less_454_s4_q <= less_454;
      less_455_s4_q <= less_455;
      less_456_s4_q <= less_456;
      less_457_s4_q <= less_457;
      less_458_s4_q <= less_458;
      less_459_s4_q <= less_459;
      less_460_s4_q <= less_460;
      less_461_s4_q <= less_461;
      less_462_s4_q <= less_462;
      less_463_s4_q <= less_463;
      less_464_s4_q <= less_464;
      less_465_s4_q <= less_465;
      less_466_s4_q <= less_466;
      less_467_s4_q <= less_467;
      less_468_s4_q <= less_468;
      less_469_s4_q <= less_469;
      less_470_s4_q <= less_470;
      less_471_s4_q <= less_471;
      less_472_s4_q <= less_472;
      less_473_s4_q <= less_473;
      equal_474_s4_q <= equal_474_s3_q;
      select_479_s4_q <= select_479_s3_q;
      whole_22_s4_q <= whole_22;
      texture_s4_q <= texture;
      equal_1383_s4_q <= equal_1383_s3_q;
      not_1384_s4_q <= not_1384_s3_q;
      equal_1428_s4_q <= equal_1428;
      all_s4_q <= all;
      sum_1434_s4_q <= sum_1434_s3_q;
      equal_1436_s4_q <= equal_1436;
      equal_1438_s4_q <= equal_1438;
      equal_1440_s4_q <= equal_1440;
      equal_1442_s4_q <= equal_1442;
      equal_1444_s4_q <= equal_1444;
      equal_1446_s4_q <= equal_1446;
      equal_1448_s4_q <= equal_1448;
      less_1456_s4_q <= less_1456;
      or_1460_s4_q <= or_1460;
      equal_1480_s4_q <= (registration_fresh_q & select_1478) == 4'h0;
      equal_1482_s4_q <= equal_1482_s3_q;
      select_1489_s4_q <= select_1489_s3_q;
      or_1490_s4_q <= or_1490;
      select_1500_s4_q <= select_1500;
      select_1517_s4_q <= select_1517;
      select_1534_s4_q <= select_1489_s3_q[3] ? select_1530 : {5'h0, select_1533};
      and_1537_s4_q <= and_1537;
      equal_1540_s4_q <= equal_1540;
      and_1542_s4_q <= and_1542_s3_q;
      residual_s4_q <= residual;
      select_1625_s4_q <= select_1489_s3_q[3] ? select_1620 : select_1624;
      select_1627_s4_q <= select_1489_s3_q[0] ? select_1626 : registration_of_right_q;
      select_1639_s4_q <= select_1639;
      select_1661_s4_q <= select_1661;
      select_1688_s4_q <= select_1688_s3_q;
      select_1730_s4_q <= select_1730_s3_q;
      select_1771_s4_q <= select_1771_s3_q;
      select_1824_s4_q <= select_1824_s3_q;
      equal_1826_s4_q <= {x_s3_q[4:0], slot_s3_q} == 8'h0;
      and_1836_s4_q <= and_1836;
      and_1846_s4_q <= and_1846;
      less_1854_s4_q <= 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
      select_1938_s4_q <= select_1938;
      select_1966_s4_q <= select_1966;
      select_2032_s4_q <= select_1489_s3_q[5] ? select_2000 : select_2031;
      and_2149_s4_q <= and_2149_s3_q;
      select_2162_s4_q <= select_2162;
      and_2166_s4_q <= not_1384_s3_q & and_1474;
      or_2169_s4_q <= or_2169;
      or_2172_s4_q <= or_2172;
      or_2175_s4_q <= or_2175;
      not_2177_s4_q <= not_2177;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2198_s4_q <= and_2198;
      and_2203_s4_q <= not_1384_s3_q & and_2184;
      and_2235_s4_q <= and_2235;
      less_2236_s4_q <= less_2236;
      sum_2244_s4_q <= sum_2244;
      equal_2258_s4_q <= t[4:1] == 4'h0;
      or_2263_s4_q <= or_2263;
      or_2266_s4_q <= select_2260[7] | (~({select_2260[6], select_2260[3:2]} == 3'h0));
      or_2269_s4_q <= select_2260[7] | (~(select_2260[6:4] == 3'h0));
      not_2294_s4_q <= ~({sum_2292, around[0]} < {2'h0, t});
      less_2308_s4_q <= {1'b0, around[4:1]} < n;
      and_2319_s4_q <= and_2319_s3_q;
      sum_2497_s4_q <= ({1'b0, sum_2489} + {2'h0, sum_2492}) + {2'h0, sum_2496};
      equal_2506_s4_q <= equal_2506_s3_q;
      select_2522_s4_q <= sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
      and_2533_s4_q <= and_2533;
      and_2544_s4_q <= and_2544;
      and_2622_s4_q <= and_2622;
      and_2626_s4_q <= not_1384_s3_q & and_2625;
      not_2660_s4_q <= ~({sum_2658, e[0]} < {2'h0, t});
      and_2688_s4_q <= not_1384_s3_q & (so_s3_q & and_2686);
      and_2711_s4_q <= not_1384_s3_q & (so_s3_q & (half_ends & equal_2708));
      equal_2771_s4_q <= (registration_fresh_q & select_2769) == 4'h0;
      equal_2922_s4_q <= equal_2922;
      and_3129_s4_q <= and_2319_s3_q & (sum_2244 == sum_2228);
      equal_3190_s4_q <= (registration_fresh_q & select_3188) == 4'h0;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [11:0] census_changes_values_3_left_q;
  logic [11:0] census_changes_values_3_right_q;
  logic [19:0] census_left_misses_q;
  logic [4:0] census_filled_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
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
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_480;
  assign select_480 = equal_474_s4_q ? 4'h0 : census_filled_q[3:0];
  // hls/stages/census.hpp:219
  logic and_481;
  assign and_481 = select_479_s4_q & select_480[3];
  // hls/stages/census.hpp:220
  logic and_506;
  assign and_506 = whole_22_s4_q & and_481;
  // hls/stages/census.hpp:229
  logic and_507;
  assign and_507 = census_columns_values_1_cell_2_mask_s4_q & and_481;
  // hls/stages/census.hpp:201
  logic [12:0] sum_527;
  assign sum_527 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_529;
  assign sum_529 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_527});
  // hls/stages/census.hpp:223
  logic less_530;
  assign less_530 = 9'h4 < sum_529[13:5];
  logic and_531;
  assign and_531 = and_481 & less_530;
  // hls/stages/registration.hpp:249
  logic [6:0] select_1483;
  assign select_1483 = sum_1434_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  logic [13:0] select_1484;
  assign select_1484 = equal_1482_s4_q ? registration_half_across_q : {{7{select_1483[6]}}, select_1483};
  logic [19:0] sum_1485;
  assign sum_1485 = (equal_1480_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1484[13]}}, select_1484};
  // hls/stages/registration.hpp:250
  logic select_1491;
  assign select_1491 = select_1489_s4_q[0] ? segment_started_q : or_1490_s4_q;
  logic [5:0] select_1493;
  assign select_1493 = select_1489_s4_q[0] ? segment_textured_q : {5'h0, region_fresh_s4_q};
  logic [5:0] select_1494;
  assign select_1494 = select_1489_s4_q[1] ? (select_1489_s4_q[0] ? segment_nearer_q : segment_explained_q) : select_1493;
  logic [7:0] select_1502;
  assign select_1502 = select_1489_s4_q[3] ? {7'h0, select_1491} : (select_1489_s4_q[2] ? {2'h0, select_1494} : select_1500_s4_q);
  logic not_1538;
  assign not_1538 = ~select_1489_s4_q[2];
  logic and_1539;
  assign and_1539 = and_1537_s4_q & not_1538;
  // hls/stages/registration.hpp:193
  logic [12:0] difference_1577;
  assign difference_1577 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  logic less_1578;
  assign less_1578 = $signed(difference_1577) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_1579;
  assign and_1579 = and_1542_s4_q & less_1578;
  logic [1:0] select_1580;
  assign select_1580 = equal_1540_s4_q ? {and_1579, and_1542_s4_q} : 2'h0;
  // hls/stages/registration.hpp:193
  logic less_1581;
  assign less_1581 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_1582;
  assign and_1582 = and_1542_s4_q & less_1581;
  logic [1:0] select_1583;
  assign select_1583 = equal_1540_s4_q ? {and_1582, and_1542_s4_q} : 2'h0;
  logic and_1585;
  assign and_1585 = and_1542_s4_q & ($signed(difference_1577) < $signed({7'h0, cfg_moved_limit_i}));
  logic [1:0] select_1586;
  assign select_1586 = equal_1540_s4_q ? {and_1585, and_1542_s4_q} : 2'h0;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1588;
  assign select_1588 = select_1489_s4_q[1] ? select_1580 : (select_1489_s4_q[0] ? select_1583 : select_1586);
  // hls/stages/registration.hpp:106
  logic and_1590;
  assign and_1590 = and_1542_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  logic [1:0] select_1591;
  assign select_1591 = equal_1540_s4_q ? {and_1590, and_1542_s4_q} : 2'h0;
  logic and_1592;
  assign and_1592 = and_1542_s4_q & equal_1540_s4_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1593;
  assign select_1593 = select_1489_s4_q[0] ? select_1591 : {1'b0, and_1592};
  // hls/stages/registration.hpp:106
  logic [7:0] select_1595;
  assign select_1595 = equal_1540_s4_q ? (and_1542_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1597;
  assign select_1597 = select_1489_s4_q[1] ? {{6{select_1593[1]}}, select_1593} : (select_1489_s4_q[0] ? select_1595 : 8'h0);
  logic [7:0] select_1598;
  assign select_1598 = select_1489_s4_q[2] ? {{6{select_1588[1]}}, select_1588} : select_1597;
  logic [7:0] select_1600;
  assign select_1600 = select_1489_s4_q[4] ? select_1534_s4_q : (select_1489_s4_q[3] ? {7'h0, and_1539} : select_1598);
  logic [7:0] select_1601;
  assign select_1601 = select_1489_s4_q[5] ? (select_1489_s4_q[4] ? select_1502 : select_1517_s4_q) : select_1600;
  logic select_1602;
  assign select_1602 = select_1489_s4_q[0] ? registration_other_up_q : registration_other_down_q;
  logic and_1604;
  assign and_1604 = not_1538 & (select_1489_s4_q[1] ? registration_moved_q : select_1602);
  logic select_1605;
  assign select_1605 = select_1489_s4_q[0] ? registration_other_enough_q : registration_votes_up_q;
  logic select_1606;
  assign select_1606 = select_1489_s4_q[0] ? registration_votes_down_q : registration_enough_q;
  logic select_1607;
  assign select_1607 = select_1489_s4_q[1] ? select_1605 : select_1606;
  logic [7:0] select_1608;
  assign select_1608 = select_1489_s4_q[0] ? {{2{registration_up_q[13]}}, registration_up_q[13:8]} : registration_up_q[7:0];
  logic [7:0] select_1609;
  assign select_1609 = select_1489_s4_q[0] ? {{2{registration_down_q[13]}}, registration_down_q[13:8]} : registration_down_q[7:0];
  logic [7:0] select_1611;
  assign select_1611 = select_1489_s4_q[2] ? {7'h0, select_1607} : (select_1489_s4_q[1] ? select_1608 : select_1609);
  logic [7:0] select_1613;
  assign select_1613 = select_1489_s4_q[4] ? 8'h0 : (select_1489_s4_q[3] ? {7'h0, and_1604} : select_1611);
  logic [6:0] select_1628;
  assign select_1628 = select_1489_s4_q[1] ? {6'h0, select_1627_s4_q} : registration_half_half_votes_up_q;
  logic [6:0] select_1629;
  assign select_1629 = select_1489_s4_q[0] ? registration_half_half_votes_down_q : registration_half_votes_up_q;
  logic [6:0] select_1630;
  assign select_1630 = select_1489_s4_q[0] ? registration_half_votes_down_q : {1'b0, registration_half_measured_q};
  logic [6:0] select_1632;
  assign select_1632 = select_1489_s4_q[2] ? select_1628 : (select_1489_s4_q[1] ? select_1629 : select_1630);
  logic [7:0] select_1633;
  assign select_1633 = select_1489_s4_q[0] ? {{2{registration_half_across_q[13]}}, registration_half_across_q[13:8]} : registration_half_across_q[7:0];
  logic [7:0] select_1662;
  assign select_1662 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1633 : select_1639_s4_q) : select_1661_s4_q;
  logic [7:0] select_1663;
  assign select_1663 = select_1489_s4_q[3] ? {select_1632[6], select_1632} : select_1662;
  logic [7:0] select_1665;
  assign select_1665 = select_1489_s4_q[5] ? select_1613 : (select_1489_s4_q[4] ? select_1625_s4_q : select_1663);
  logic [7:0] select_1667;
  assign select_1667 = select_1489_s4_q[0] ? {2'h0, counts_skin_unproven_q[13:8]} : counts_skin_unproven_q[7:0];
  logic [7:0] select_1668;
  assign select_1668 = select_1489_s4_q[0] ? {2'h0, counts_skin_textured_q[13:8]} : counts_skin_textured_q[7:0];
  logic [7:0] select_1670;
  assign select_1670 = select_1489_s4_q[0] ? {2'h0, counts_skin_supervised_q[13:8]} : counts_skin_supervised_q[7:0];
  logic [7:0] select_1671;
  assign select_1671 = select_1489_s4_q[0] ? {2'h0, counts_regions_bad_q[13:8]} : counts_regions_bad_q[7:0];
  logic [7:0] select_1673;
  assign select_1673 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1667 : select_1668) : (select_1489_s4_q[1] ? select_1670 : select_1671);
  logic [7:0] select_1674;
  assign select_1674 = select_1489_s4_q[0] ? {2'h0, counts_unproven_q[13:8]} : counts_unproven_q[7:0];
  logic [7:0] select_1675;
  assign select_1675 = select_1489_s4_q[0] ? {2'h0, counts_nearer_q[13:8]} : counts_nearer_q[7:0];
  logic [7:0] select_1677;
  assign select_1677 = select_1489_s4_q[0] ? {2'h0, counts_explained_q[13:8]} : counts_explained_q[7:0];
  logic [7:0] select_1678;
  assign select_1678 = select_1489_s4_q[0] ? {2'h0, counts_textured_q[13:8]} : counts_textured_q[7:0];
  logic [7:0] select_1680;
  assign select_1680 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1674 : select_1675) : (select_1489_s4_q[1] ? select_1677 : select_1678);
  logic [7:0] select_1682;
  assign select_1682 = select_1489_s4_q[0] ? {2'h0, counts_supervised_q[13:8]} : counts_supervised_q[7:0];
  logic [7:0] select_1690;
  assign select_1690 = select_1489_s4_q[4] ? (select_1489_s4_q[3] ? select_1673 : select_1680) : (select_1489_s4_q[3] ? select_1682 : select_1688_s4_q);
  // hls/stages/agreement.hpp:150
  logic equal_1825;
  assign equal_1825 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:305
  logic xor_1837;
  assign xor_1837 = sharpness_comparing_contrast_1_q[1] ^ and_1836_s4_q;
  logic select_1840;
  assign select_1840 = (equal_1826_s4_q | xor_1837) ? (and_1836_s4_q & xor_1837) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1842;
  assign select_1842 = drew_q ? (equal_1825 ? select_1840 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/census.hpp:305
  logic xor_1847;
  assign xor_1847 = sharpness_comparing_contrast_0_q[1] ^ and_1846_s4_q;
  logic select_1850;
  assign select_1850 = (equal_1826_s4_q | xor_1847) ? (and_1846_s4_q & xor_1847) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1852;
  assign select_1852 = drew_q ? (equal_1825 ? select_1850 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:296
  logic [17:0] select_1856;
  assign select_1856 = (less_1854_s4_q & and_1846_s4_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_1856};
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/census.hpp:304
  logic xor_1860;
  assign xor_1860 = sharpness_comparing_product_1_q[2] ^ five_times[0];
  logic select_1863;
  assign select_1863 = (equal_1826_s4_q | xor_1860) ? (five_times[0] & xor_1860) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_1865;
  assign select_1865 = drew_q ? (equal_1825 ? select_1863 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:296
  logic [17:0] select_1867;
  assign select_1867 = (less_1854_s4_q & and_1836_s4_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_1867};
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/census.hpp:304
  logic xor_1871;
  assign xor_1871 = sharpness_comparing_product_0_q[2] ^ five_times_2[0];
  logic select_1874;
  assign select_1874 = (equal_1826_s4_q | xor_1871) ? (five_times_2[0] & xor_1871) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_1876;
  assign select_1876 = drew_q ? (equal_1825 ? select_1874 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  logic select_1879;
  assign select_1879 = drew_q ? (equal_1825 ? five_times[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  logic select_1881;
  assign select_1881 = drew_q ? (equal_1825 ? five_times_2[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/registration.hpp:250
  logic select_1883;
  assign select_1883 = select_1489_s4_q[1] ? (select_1489_s4_q[0] ? select_1865 : select_1876) : (select_1489_s4_q[0] ? select_1879 : select_1881);
  logic select_1884;
  assign select_1884 = select_1489_s4_q[2] ? (select_1489_s4_q[0] ? select_1842 : select_1852) : select_1883;
  // hls/stages/agreement.hpp:154
  logic [1:0] select_1885;
  assign select_1885 = equal_1825 ? {sharpness_comparing_contrast_1_q[0], and_1846_s4_q} : sharpness_comparing_contrast_1_q;
  logic [1:0] select_1886;
  assign select_1886 = drew_q ? select_1885 : sharpness_comparing_contrast_1_q;
  logic [1:0] select_1887;
  assign select_1887 = equal_1825 ? {sharpness_comparing_contrast_0_q[0], and_1836_s4_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_1888;
  assign select_1888 = drew_q ? select_1887 : sharpness_comparing_contrast_0_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1889;
  assign select_1889 = select_1489_s4_q[0] ? select_1886 : select_1888;
  // hls/stages/agreement.hpp:154
  logic [2:0] select_1890;
  assign select_1890 = equal_1825 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [2:0] select_1891;
  assign select_1891 = drew_q ? select_1890 : sharpness_comparing_product_1_q;
  logic [2:0] select_1892;
  assign select_1892 = equal_1825 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_1893;
  assign select_1893 = drew_q ? select_1892 : sharpness_comparing_product_0_q;
  // hls/stages/registration.hpp:250
  logic [2:0] select_1895;
  assign select_1895 = select_1489_s4_q[1] ? {1'b0, select_1889} : (select_1489_s4_q[0] ? select_1891 : select_1893);
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1897;
  assign select_1897 = equal_1825 ? (less_1854_s4_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [17:0] select_1898;
  assign select_1898 = drew_q ? select_1897 : sharpness_comparing_rest_1_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1899;
  assign select_1899 = select_1489_s4_q[0] ? 2'h0 : select_1898[17:16];
  logic [7:0] select_1901;
  assign select_1901 = select_1489_s4_q[1] ? {6'h0, select_1899} : (select_1489_s4_q[0] ? select_1898[15:8] : select_1898[7:0]);
  logic [7:0] select_1903;
  assign select_1903 = select_1489_s4_q[3] ? {7'h0, select_1884} : (select_1489_s4_q[2] ? {5'h0, select_1895} : select_1901);
  logic [7:0] select_1905;
  assign select_1905 = select_1489_s4_q[5] ? select_1771_s4_q : (select_1489_s4_q[4] ? select_1824_s4_q : select_1903);
  logic [7:0] select_1906;
  assign select_1906 = select_1489_s4_q[6] ? (select_1489_s4_q[5] ? select_1690 : select_1730_s4_q) : select_1905;
  logic [7:0] select_1907;
  assign select_1907 = select_1489_s4_q[7] ? (select_1489_s4_q[6] ? select_1601 : select_1665) : select_1906;
  // hls/stages/agreement.hpp:154
  logic [17:0] select_1909;
  assign select_1909 = equal_1825 ? (less_1854_s4_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  logic [17:0] select_1910;
  assign select_1910 = drew_q ? select_1909 : sharpness_comparing_rest_0_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_1911;
  assign select_1911 = select_1489_s4_q[0] ? 2'h0 : select_1910[17:16];
  logic [7:0] select_1913;
  assign select_1913 = select_1489_s4_q[1] ? {6'h0, select_1911} : (select_1489_s4_q[0] ? select_1910[15:8] : select_1910[7:0]);
  logic [7:0] select_1914;
  assign select_1914 = select_1489_s4_q[0] ? 8'h0 : sharpness_sums_contrast_1_s4_q[23:16];
  logic [7:0] select_1915;
  assign select_1915 = select_1489_s4_q[0] ? sharpness_sums_contrast_1_s4_q[15:8] : sharpness_sums_contrast_1_s4_q[7:0];
  logic [7:0] select_1917;
  assign select_1917 = select_1489_s4_q[2] ? select_1913 : (select_1489_s4_q[1] ? select_1914 : select_1915);
  logic [7:0] select_1918;
  assign select_1918 = select_1489_s4_q[0] ? 8'h0 : sharpness_sums_contrast_0_s4_q[23:16];
  logic [7:0] select_1919;
  assign select_1919 = select_1489_s4_q[0] ? sharpness_sums_contrast_0_s4_q[15:8] : sharpness_sums_contrast_0_s4_q[7:0];
  logic [7:0] select_1922;
  assign select_1922 = select_1489_s4_q[0] ? sharpness_sums_detail_1_q[15:8] : sharpness_sums_detail_1_q[7:0];
  logic [7:0] select_1923;
  assign select_1923 = select_1489_s4_q[1] ? (select_1489_s4_q[0] ? 8'h0 : sharpness_sums_detail_1_q[23:16]) : select_1922;
  logic [7:0] select_1924;
  assign select_1924 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1918 : select_1919) : select_1923;
  logic [7:0] select_1927;
  assign select_1927 = select_1489_s4_q[0] ? sharpness_sums_detail_0_q[15:8] : sharpness_sums_detail_0_q[7:0];
  logic [7:0] select_1928;
  assign select_1928 = select_1489_s4_q[1] ? (select_1489_s4_q[0] ? 8'h0 : sharpness_sums_detail_0_q[23:16]) : select_1927;
  logic [7:0] select_1929;
  assign select_1929 = select_1489_s4_q[0] ? {2'h0, sharpness_last_detail_1_q[13:8]} : sharpness_last_detail_1_q[7:0];
  logic [7:0] select_1930;
  assign select_1930 = select_1489_s4_q[0] ? {2'h0, sharpness_last_detail_0_q[13:8]} : sharpness_last_detail_0_q[7:0];
  logic [7:0] select_1932;
  assign select_1932 = select_1489_s4_q[2] ? select_1928 : (select_1489_s4_q[1] ? select_1929 : select_1930);
  logic [7:0] select_1940;
  assign select_1940 = select_1489_s4_q[4] ? (select_1489_s4_q[3] ? select_1917 : select_1924) : (select_1489_s4_q[3] ? select_1932 : select_1938_s4_q);
  logic [2:0] select_1941;
  assign select_1941 = select_1489_s4_q[0] ? {3{census_left_misses_q[19]}} : census_left_misses_q[18:16];
  logic [7:0] select_1942;
  assign select_1942 = select_1489_s4_q[0] ? census_left_misses_q[15:8] : census_left_misses_q[7:0];
  logic [7:0] select_1943;
  assign select_1943 = select_1489_s4_q[1] ? {{5{census_left_misses_q[19]}}, select_1941} : select_1942;
  logic [7:0] select_1945;
  assign select_1945 = select_1489_s4_q[0] ? {4'h0, census_changes_values_3_right_q[11:8]} : census_changes_values_3_right_q[7:0];
  logic [7:0] select_1946;
  assign select_1946 = select_1489_s4_q[0] ? {4'h0, census_changes_values_3_left_q[11:8]} : census_changes_values_3_left_q[7:0];
  logic [7:0] select_1948;
  assign select_1948 = select_1489_s4_q[0] ? {4'h0, census_changes_values_2_right_q[11:8]} : census_changes_values_2_right_q[7:0];
  logic [7:0] select_1949;
  assign select_1949 = select_1489_s4_q[0] ? {4'h0, census_changes_values_2_left_q[11:8]} : census_changes_values_2_left_q[7:0];
  logic [7:0] select_1951;
  assign select_1951 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1945 : select_1946) : (select_1489_s4_q[1] ? select_1948 : select_1949);
  logic [7:0] select_1952;
  assign select_1952 = select_1489_s4_q[3] ? (select_1489_s4_q[2] ? {3'h0, census_filled_q} : select_1943) : select_1951;
  logic [7:0] select_1953;
  assign select_1953 = select_1489_s4_q[0] ? {4'h0, census_changes_values_1_right_q[11:8]} : census_changes_values_1_right_q[7:0];
  logic [7:0] select_1954;
  assign select_1954 = select_1489_s4_q[0] ? {4'h0, census_changes_values_1_left_q[11:8]} : census_changes_values_1_left_q[7:0];
  logic [7:0] select_1956;
  assign select_1956 = select_1489_s4_q[0] ? {4'h0, census_changes_values_0_right_q[11:8]} : census_changes_values_0_right_q[7:0];
  logic [7:0] select_1957;
  assign select_1957 = select_1489_s4_q[0] ? {4'h0, census_changes_values_0_left_q[11:8]} : census_changes_values_0_left_q[7:0];
  logic [7:0] select_1959;
  assign select_1959 = select_1489_s4_q[2] ? (select_1489_s4_q[1] ? select_1953 : select_1954) : (select_1489_s4_q[1] ? select_1956 : select_1957);
  logic [7:0] select_1968;
  assign select_1968 = select_1489_s4_q[4] ? select_1952 : (select_1489_s4_q[3] ? select_1959 : select_1966_s4_q);
  logic [7:0] select_2033;
  assign select_2033 = select_1489_s4_q[6] ? (select_1489_s4_q[5] ? select_1940 : select_1968) : select_2032_s4_q;
  logic [7:0] select_2164;
  assign select_2164 = select_1489_s4_q[8] ? select_1907 : (select_1489_s4_q[7] ? select_2033 : select_2162_s4_q);
  logic [11:0] sum_2165;
  assign sum_2165 = (equal_1480_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{4{select_2164[7]}}, select_2164};
  // hls/stages/agreement.hpp:659
  logic [5:0] select_2188;
  assign select_2188 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:660
  logic [5:0] sum_2189;
  assign sum_2189 = {5'h0, textured_s4_q} + select_2188;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_2191;
  assign sum_2191 = {4'h0, sum_2189} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:659
  logic [5:0] select_2193;
  assign select_2193 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:660
  logic [5:0] sum_2194;
  assign sum_2194 = {5'h0, explained_s4_q} + select_2193;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_2196;
  assign sum_2196 = {4'h0, sum_2194} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:659
  logic [5:0] select_2199;
  assign select_2199 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:661
  logic [5:0] sum_2200;
  assign sum_2200 = {5'h0, and_2198_s4_q} + select_2199;
  // hls/stages/agreement.hpp:794
  logic [9:0] sum_2202;
  assign sum_2202 = {4'h0, sum_2200} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:832
  logic not_2270;
  assign not_2270 = ~region_row_s4_q[2];
  logic [2:0] select_2271;
  assign select_2271 = region_row_s4_q[1] ? {1'b0, not_2270, 1'b0} : {region_row_s4_q[2], 1'b0, not_2270};
  logic [5:0] select_2272;
  assign select_2272 = region_row_s4_q[0] ? {select_2271[2], 1'b0, select_2271[1], 1'b0, select_2271[0], 1'b0} : {1'b0, select_2271[2], 1'b0, select_2271[1], 1'b0, select_2271[0]};
  logic [11:0] select_2273;
  assign select_2273 = or_2269_s4_q ? {select_2272[5], 1'b0, select_2272[4], 1'b0, select_2272[3], 1'b0, select_2272[2], 1'b0, select_2272[1], 1'b0, select_2272[0], 1'b0} : {1'b0, select_2272[5], 1'b0, select_2272[4], 1'b0, select_2272[3], 1'b0, select_2272[2], 1'b0, select_2272[1], 1'b0, select_2272[0]};
  logic [23:0] select_2274;
  assign select_2274 = or_2266_s4_q ? {select_2273[11], 1'b0, select_2273[10], 1'b0, select_2273[9], 1'b0, select_2273[8], 1'b0, select_2273[7], 1'b0, select_2273[6], 1'b0, select_2273[5], 1'b0, select_2273[4], 1'b0, select_2273[3], 1'b0, select_2273[2], 1'b0, select_2273[1], 1'b0, select_2273[0], 1'b0} : {1'b0, select_2273[11], 1'b0, select_2273[10], 1'b0, select_2273[9], 1'b0, select_2273[8], 1'b0, select_2273[7], 1'b0, select_2273[6], 1'b0, select_2273[5], 1'b0, select_2273[4], 1'b0, select_2273[3], 1'b0, select_2273[2], 1'b0, select_2273[1], 1'b0, select_2273[0]};
  logic [47:0] select_2275;
  assign select_2275 = or_2263_s4_q ? {select_2274[23], 1'b0, select_2274[22], 1'b0, select_2274[21], 1'b0, select_2274[20], 1'b0, select_2274[19], 1'b0, select_2274[18], 1'b0, select_2274[17], 1'b0, select_2274[16], 1'b0, select_2274[15], 1'b0, select_2274[14], 1'b0, select_2274[13], 1'b0, select_2274[12], 1'b0, select_2274[11], 1'b0, select_2274[10], 1'b0, select_2274[9], 1'b0, select_2274[8], 1'b0, select_2274[7], 1'b0, select_2274[6], 1'b0, select_2274[5], 1'b0, select_2274[4], 1'b0, select_2274[3], 1'b0, select_2274[2], 1'b0, select_2274[1], 1'b0, select_2274[0], 1'b0} : {1'b0, select_2274[23], 1'b0, select_2274[22], 1'b0, select_2274[21], 1'b0, select_2274[20], 1'b0, select_2274[19], 1'b0, select_2274[18], 1'b0, select_2274[17], 1'b0, select_2274[16], 1'b0, select_2274[15], 1'b0, select_2274[14], 1'b0, select_2274[13], 1'b0, select_2274[12], 1'b0, select_2274[11], 1'b0, select_2274[10], 1'b0, select_2274[9], 1'b0, select_2274[8], 1'b0, select_2274[7], 1'b0, select_2274[6], 1'b0, select_2274[5], 1'b0, select_2274[4], 1'b0, select_2274[3], 1'b0, select_2274[2], 1'b0, select_2274[1], 1'b0, select_2274[0]};
  // hls/stages/agreement.hpp:765
  logic and_2279;
  assign and_2279 = good_known_q & (~((good_q & select_2275) == 48'h0));
  // hls/stages/agreement.hpp:834
  logic is_seen;
  assign is_seen = equal_2258_s4_q ? and_2279 : not_2294_s4_q;
  // hls/stages/agreement.hpp:843
  logic and_2309;
  assign and_2309 = is_seen & less_2308_s4_q;
  // hls/stages/agreement.hpp:365
  logic [11:0] select_2499;
  assign select_2499 = and_416_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2500;
  assign select_2500 = and_416_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2501;
  assign select_2501 = and_416_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2502;
  assign select_2502 = and_416_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  logic [11:0] select_2503;
  assign select_2503 = and_416_s4_q ? census_changes_values_2_left_q : census_changes_values_3_left_q;
  logic [11:0] select_2504;
  assign select_2504 = and_416_s4_q ? census_changes_values_2_right_q : census_changes_values_3_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_2507;
  assign sum_2507 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2497_s4_q};
  logic [13:0] sum_2509;
  assign sum_2509 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2507});
  // hls/stages/census.hpp:225
  logic and_2511;
  assign and_2511 = and_506 & (9'h4 < sum_2509[13:5]);
  // hls/stages/census.hpp:226
  logic and_2512;
  assign and_2512 = and_506 & less_530;
  // hls/stages/census.hpp:227
  logic [19:0] sum_2513;
  assign sum_2513 = census_left_misses_q + {{17{and_2512}}, and_2511, 1'b0, and_2511};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_2515;
  assign select_2515 = and_416_s4_q ? (equal_2506_s4_q ? 20'h0 : sum_2513) : census_left_misses_q;
  logic [13:0] select_2523;
  assign select_2523 = and_416_s4_q ? select_2522_s4_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2524;
  assign select_2524 = and_416_s4_q ? select_2522_s4_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2522_s4_q[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2535;
  assign select_2535 = and_2533_s4_q ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2537;
  assign select_2537 = equal_2506_s4_q ? {11'h0, select_2535} : (sharpness_sums_detail_0_q + {11'h0, select_2535});
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2522_s4_q[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2546;
  assign select_2546 = and_2544_s4_q ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2548;
  assign select_2548 = equal_2506_s4_q ? {11'h0, select_2546} : (sharpness_sums_detail_1_q + {11'h0, select_2546});
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2628;
  assign select_2628 = and_2622_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2626_s4_q});
  // hls/stages/agreement.hpp:211
  logic and_2631;
  assign and_2631 = not_1384_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2636;
  assign and_2636 = not_1384_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2641;
  assign and_2641 = not_1384_s4_q & (drew_q & (ends_cell_s4_q & and_2198_s4_q));
  // hls/stages/agreement.hpp:836
  logic not_2645;
  assign not_2645 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:837
  logic not_2662;
  assign not_2662 = ~(equal_2258_s4_q ? and_2279 : not_2660_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2665;
  assign and_2665 = ends_cell_s4_q & (not_2645 & (centres_values_1_textured_s4_q & not_2662));
  logic and_2667;
  assign and_2667 = not_1384_s4_q & (drew_q & and_2665);
  // hls/stages/agreement.hpp:862
  logic less_2670;
  assign less_2670 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2671;
  assign select_2671 = less_2670 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2674;
  assign select_2674 = less_2670 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:863
  logic [10:0] sum_2675;
  assign sum_2675 = {1'b0, select_2674} + {3'h0, select_2674[9:2]};
  logic and_2677;
  assign and_2677 = (~(select_2671[9:4] == 6'h0)) & ({sum_2675, select_2674[1:0]} < {3'h0, select_2671});
  // hls/stages/agreement.hpp:872
  logic [9:0] select_2680;
  assign select_2680 = x_s4_q[6] ? (equal_1428_s4_q ? 10'h0 : (and_2677 ? select_2671 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_2681;
  assign select_2681 = equal_1383_s4_q ? select_2680 : 10'h0;
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2683;
  assign select_2683 = and_2622_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2681});
  logic [13:0] select_2690;
  assign select_2690 = and_2622_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2688_s4_q});
  // hls/stages/agreement.hpp:841
  logic and_2692;
  assign and_2692 = not_2645 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_2695;
  assign and_2695 = not_1384_s4_q & (drew_q & (ends_cell_s4_q & and_2692));
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2697;
  assign select_2697 = and_2622_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2695});
  // hls/stages/agreement.hpp:841
  logic and_2699;
  assign and_2699 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2662);
  // hls/stages/agreement.hpp:211
  logic and_2703;
  assign and_2703 = not_1384_s4_q & (drew_q & (ends_cell_s4_q & (not_2645 & and_2699)));
  // hls/stages/agreement.hpp:682
  logic [13:0] select_2705;
  assign select_2705 = and_2622_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2703});
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2713;
  assign select_2713 = equal_1383_s4_q ? 8'h0 : (drew_q ? select_1595 : 8'h0);
  // hls/stages/registration.hpp:126
  logic [13:0] select_2715;
  assign select_2715 = and_2711_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2713[7]}}, select_2713});
  // hls/stages/agreement.hpp:211
  logic and_2717;
  assign and_2717 = not_1384_s4_q & (drew_q & and_1592);
  // hls/stages/registration.hpp:126
  logic [5:0] select_2719;
  assign select_2719 = and_2711_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2717});
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2721;
  assign select_2721 = equal_1383_s4_q ? 2'h0 : (drew_q ? select_1591 : 2'h0);
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2722;
  assign sum_2722 = registration_half_votes_down_q + {{5{select_2721[1]}}, select_2721};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2725;
  assign select_2725 = equal_1383_s4_q ? 2'h0 : (drew_q ? select_1586 : 2'h0);
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2726;
  assign sum_2726 = registration_half_votes_up_q + {{5{select_2725[1]}}, select_2725};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2729;
  assign select_2729 = equal_1383_s4_q ? 2'h0 : (drew_q ? select_1583 : 2'h0);
  // hls/stages/registration.hpp:172
  logic [6:0] sum_2730;
  assign sum_2730 = registration_half_half_votes_down_q + {{5{select_2729[1]}}, select_2729};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_2733;
  assign select_2733 = equal_1383_s4_q ? 2'h0 : (drew_q ? select_1580 : 2'h0);
  // hls/stages/registration.hpp:173
  logic [6:0] sum_2734;
  assign sum_2734 = registration_half_half_votes_up_q + {{5{select_2733[1]}}, select_2733};
  // hls/stages/agreement.hpp:211
  logic and_2766;
  assign and_2766 = equal_1383_s4_q & (x_s4_q[6] & (not_2177_s4_q & less_1456_s4_q));
  // hls/stages/agreement.hpp:862
  logic [11:0] select_2773;
  assign select_2773 = or_1460_s4_q ? 12'h0 : (equal_2771_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_2776;
  assign select_2776 = x_s4_q[6] ? (equal_1428_s4_q ? 12'h0 : (less_1456_s4_q ? select_2773 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2777;
  assign select_2777 = equal_1383_s4_q ? select_2776 : 12'h0;
  // hls/stages/registration.hpp:145
  logic and_2778;
  assign and_2778 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:872
  logic and_2781;
  assign and_2781 = not_2177_s4_q & (less_1456_s4_q & ({and_2778, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:211
  logic and_2783;
  assign and_2783 = equal_1383_s4_q & (x_s4_q[6] & and_2781);
  // hls/stages/registration.hpp:237
  logic [13:0] sum_2785;
  assign sum_2785 = {{2{select_2777[11]}}, select_2777} + (and_2783 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:862
  logic [11:0] select_2788;
  assign select_2788 = or_1460_s4_q ? 12'h0 : (equal_2771_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_2791;
  assign select_2791 = x_s4_q[6] ? (equal_1428_s4_q ? 12'h0 : (less_1456_s4_q ? select_2788 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_2792;
  assign select_2792 = equal_1383_s4_q ? select_2791 : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_2794;
  assign sum_2794 = {{2{select_2792[11]}}, select_2792} + (and_2783 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:142
  logic not_2796;
  assign not_2796 = ~all_s4_q;
  // hls/stages/agreement.hpp:872
  logic and_2799;
  assign and_2799 = not_2177_s4_q & (less_1456_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2796, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_2805;
  assign and_2805 = equal_1383_s4_q & (x_s4_q[6] & (not_2177_s4_q & (less_1456_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:231
  logic not_2806;
  assign not_2806 = ~and_2805;
  logic less_2807;
  assign less_2807 = $signed({9'h1, {2{not_2806}}, and_2805}) < $signed(registration_up_q[13:2]);
  logic select_2808;
  assign select_2808 = (equal_1383_s4_q & (x_s4_q[6] & and_2799)) ? less_2807 : registration_enough_q;
  // hls/stages/agreement.hpp:872
  logic and_2812;
  assign and_2812 = x_s4_q[6] & (not_2177_s4_q & (less_1456_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_2813;
  assign and_2813 = equal_1383_s4_q & and_2812;
  // hls/stages/registration.hpp:227
  logic less_2814;
  assign less_2814 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2816;
  assign less_2816 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:872
  logic and_2821;
  assign and_2821 = x_s4_q[6] & (not_2177_s4_q & (less_1456_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_2822;
  assign and_2822 = equal_1383_s4_q & and_2821;
  // hls/stages/agreement.hpp:872
  logic and_2829;
  assign and_2829 = x_s4_q[6] & (not_2177_s4_q & (less_1456_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:149
  logic equal_2832;
  assign equal_2832 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:872
  logic and_2835;
  assign and_2835 = not_2177_s4_q & (less_1456_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2832));
  // hls/stages/registration.hpp:229
  logic and_2839;
  assign and_2839 = (equal_1383_s4_q & (x_s4_q[6] & and_2835)) & (less_2816 | less_2814);
  // hls/stages/agreement.hpp:872
  logic and_2844;
  assign and_2844 = not_2177_s4_q & (less_1456_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2832)));
  // hls/stages/registration.hpp:229
  logic and_2847;
  assign and_2847 = registration_votes_up_q & registration_other_down_q;
  logic select_2849;
  assign select_2849 = registration_votes_down_q ? (registration_other_up_q | and_2847) : and_2847;
  // hls/stages/registration.hpp:130
  logic and_2851;
  assign and_2851 = (equal_1383_s4_q & (x_s4_q[6] & and_2844)) & (registration_other_enough_q & select_2849);
  // hls/stages/registration.hpp:230
  logic or_2854;
  assign or_2854 = registration_moved_q | (registration_enough_q & (and_2839 | and_2851));
  // hls/stages/agreement.hpp:909
  logic or_2902;
  assign or_2902 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:931
  logic equal_2904;
  assign equal_2904 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:937
  logic equal_2905;
  assign equal_2905 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:940
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:941
  logic select_2911;
  assign select_2911 = (equal_2904 & equal_2905) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:865
  logic [10:0] sum_2914;
  assign sum_2914 = {1'b0, select_2674} + {2'h0, select_2674[9:1]};
  logic select_2917;
  assign select_2917 = (select_2671[9:3] == 7'h0) ? ((~or_2902) & (~select_2911)) : (~({sum_2914, select_2674[0]} < {2'h0, select_2671}));
  // hls/stages/agreement.hpp:872
  logic [47:0] select_2919;
  assign select_2919 = x_s4_q[6] ? (equal_1428_s4_q ? good_q : {select_2917, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:211
  logic select_2924;
  assign select_2924 = equal_1383_s4_q ? ((x_s4_q[6] & good_known_q) | equal_2922_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:931
  logic equal_2925;
  assign equal_2925 = x_s4_q[6:3] == 4'ha;
  logic equal_2927;
  assign equal_2927 = x_s4_q[6:3] == 4'h9;
  logic equal_2928;
  assign equal_2928 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:856
  logic [13:0] select_2930;
  assign select_2930 = equal_2927 ? counts_skin_unproven_q : (equal_2928 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_2925 ? counts_nearer_q : select_2930;
  // hls/stages/agreement.hpp:936
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:944
  logic select_2933;
  assign select_2933 = (equal_2925 & equal_2905) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:873
  logic not_2934;
  assign not_2934 = ~hidden_for_q[7];
  logic [7:0] select_2936;
  assign select_2936 = select_2933 ? (hidden_for_q + {7'h0, not_2934}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_2938;
  assign select_2938 = equal_1383_s4_q ? (equal_2922_s4_q ? select_2936 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:944
  logic [13:0] select_2939;
  assign select_2939 = equal_2905 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:856
  logic [7:0] select_2941;
  assign select_2941 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_2943;
  assign select_2943 = equal_2928 ? cfg_unproven_skin_limit_i : (equal_2904 ? cfg_unproven_limit_i : select_2941);
  logic [7:0] limit;
  assign limit = equal_2925 ? cfg_regions_limit_i : (equal_2927 ? cfg_hidden_limit_i : select_2943);
  // hls/stages/agreement.hpp:944
  logic not_2946;
  assign not_2946 = ~x_s4_q[2];
  logic [3:0] select_2947;
  assign select_2947 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_2946, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_2946};
  logic [7:0] select_2948;
  assign select_2948 = x_s4_q[0] ? {select_2947[3], 1'b0, select_2947[2], 1'b0, select_2947[1], 1'b0, select_2947[0], 1'b0} : {1'b0, select_2947[3], 1'b0, select_2947[2], 1'b0, select_2947[1], 1'b0, select_2947[0]};
  // hls/stages/agreement.hpp:856
  logic [13:0] select_2952;
  assign select_2952 = equal_2927 ? counts_skin_supervised_q : (equal_2928 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_2925 ? counts_textured_q : select_2952;
  // hls/stages/agreement.hpp:944
  logic [13:0] select_2954;
  assign select_2954 = ((limit & select_2948) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_2939} + {1'b0, select_2954};
  // hls/stages/agreement.hpp:211
  logic select_2959;
  assign select_2959 = equal_1383_s4_q ? (equal_2905 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:942
  logic and_2964;
  assign and_2964 = too_much_q & (~(equal_2928 & equal_2905));
  // hls/stages/agreement.hpp:943
  logic select_2969;
  assign select_2969 = (over[14] & equal_2905) ? (and_2964 | ((equal_2928 | equal_2927) | (x_s4_q[6:3] == 4'hf))) : and_2964;
  // hls/stages/agreement.hpp:984
  logic select_3077;
  assign select_3077 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:220
  logic select_3079;
  assign select_3079 = left_first_s4_q ? done_s4_q : (and_2149_s4_q ? select_3077 : proven_q);
  // hls/stages/agreement.hpp:1013
  logic [1:0] select_3130;
  assign select_3130 = and_3129_s4_q ? {and_2309, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1014
  logic and_3131;
  assign and_3131 = select_3077 & less_3107;
  // hls/stages/agreement.hpp:220
  logic select_3134;
  assign select_3134 = and_2235_s4_q ? (less_2236_s4_q ? (select_3130[0] & and_3131) : seen_q) : seen_q;
  logic select_3136;
  assign select_3136 = left_first_s4_q ? select_3134 : (and_2149_s4_q ? select_3134 : seen_q);
  logic select_3137;
  assign select_3137 = and_2149_s4_q ? select_3136 : seen_q;
  logic select_3140;
  assign select_3140 = and_2235_s4_q ? (less_2236_s4_q ? (select_3130[1] & and_3131) : nearer_q) : nearer_q;
  logic select_3142;
  assign select_3142 = left_first_s4_q ? select_3140 : (and_2149_s4_q ? select_3140 : nearer_q);
  logic select_3143;
  assign select_3143 = and_2149_s4_q ? select_3142 : nearer_q;
  // hls/stages/agreement.hpp:211
  logic and_3150;
  assign and_3150 = equal_1383_s4_q & (equal_2922_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:953
  logic not_3155;
  assign not_3155 = ~(or_2902 | not_3144);
  // hls/stages/agreement.hpp:211
  logic and_3159;
  assign and_3159 = equal_1383_s4_q & (equal_2922_s4_q & (not_3155 & (select_2911 | select_2969)));
  logic and_3162;
  assign and_3162 = equal_1383_s4_q & (equal_2922_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:875
  logic or_3165;
  assign or_3165 = select_1876 | (select_1852 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:211
  logic and_3172;
  assign and_3172 = equal_1383_s4_q & (equal_2922_s4_q & (not_3155 & (select_1865 | select_1842)));
  // hls/stages/agreement.hpp:875
  logic and_3177;
  assign and_3177 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2936 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:211
  logic and_3184;
  assign and_3184 = equal_1383_s4_q & (x_s4_q[6] & (not_2177_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:870
  logic [31:0] select_3192;
  assign select_3192 = equal_1448_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3190_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3193;
  assign select_3193 = equal_1446_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3192;
  logic [31:0] select_3194;
  assign select_3194 = equal_1444_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3193;
  logic [31:0] select_3195;
  assign select_3195 = equal_1442_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3194;
  logic [31:0] select_3196;
  assign select_3196 = equal_1440_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3195;
  logic [31:0] select_3197;
  assign select_3197 = equal_1438_s4_q ? {8'h0, sharpness_sums_contrast_0_s4_q} : select_3196;
  logic [31:0] select_3198;
  assign select_3198 = equal_1436_s4_q ? {8'h0, sharpness_sums_contrast_1_s4_q} : select_3197;
  // hls/stages/agreement.hpp:868
  logic [9:0] select_3199;
  assign select_3199 = less_2670 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:872
  logic [31:0] select_3200;
  assign select_3200 = equal_1428_s4_q ? select_3198 : {2'h0, select_3199, select_2674, select_2671};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_416_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_531, and_507, and_506, and_481, less_473_s4_q, less_472_s4_q, less_471_s4_q, less_470_s4_q, less_469_s4_q, less_468_s4_q, less_467_s4_q, less_466_s4_q, less_465_s4_q, less_464_s4_q, less_463_s4_q, less_462_s4_q, less_461_s4_q, less_460_s4_q, less_459_s4_q, less_458_s4_q, less_457_s4_q, less_456_s4_q, less_455_s4_q, less_454_s4_q, less_453_s4_q, less_452_s4_q, less_451_s4_q, less_450_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [5:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
      fresh_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
      fresh_re_s3_sim <= fresh_re_s2_sim;
      fresh_raddr_s3_sim <= fresh_raddr_s2_sim;
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
      if (fresh_re_s3_sim && fresh_raddr_s3_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1434_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2166_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_2165, sum_1485};
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

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_2175_s4_q, or_2172_s4_q, or_2169_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2203_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2202, sum_2196, sum_2191};
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
  assign map_waddr = sum_2244_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2319_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2309, is_seen};
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
      census_filled_q <= 5'h0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
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
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= select_2515;
      census_filled_q <= and_416_s4_q ? {select_480, 1'b1} : census_filled_q;
      sharpness_sums_detail_0_q <= and_416_s4_q ? select_2537 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_416_s4_q ? select_2548 : sharpness_sums_detail_1_q;
      sharpness_comparing_rest_0_q <= select_1910;
      sharpness_comparing_rest_1_q <= select_1898;
      sharpness_comparing_product_0_q <= select_1893;
      sharpness_comparing_product_1_q <= select_1891;
      sharpness_comparing_contrast_0_q <= select_1888;
      sharpness_comparing_contrast_1_q <= select_1886;
      sharpness_comparing_carry_0_q <= select_1881;
      sharpness_comparing_carry_1_q <= select_1879;
      sharpness_comparing_less_detail_0_q <= select_1876;
      sharpness_comparing_less_detail_1_q <= select_1865;
      sharpness_comparing_less_contrast_0_q <= select_1852;
      sharpness_comparing_less_contrast_1_q <= select_1842;
      counts_supervised_q <= select_2628;
      counts_textured_q <= and_2622_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2631});
      counts_explained_q <= and_2622_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2636});
      counts_nearer_q <= and_2622_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2641});
      counts_unproven_q <= and_2622_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2667});
      counts_regions_bad_q <= select_2683;
      counts_skin_supervised_q <= select_2690;
      counts_skin_textured_q <= select_2697;
      counts_skin_unproven_q <= select_2705;
      registration_half_across_q <= select_2715;
      registration_half_measured_q <= select_2719;
      registration_half_votes_down_q <= and_2711_s4_q ? 7'h0 : sum_2722;
      registration_half_votes_up_q <= and_2711_s4_q ? 7'h0 : sum_2726;
      registration_half_half_votes_down_q <= and_2711_s4_q ? 7'h0 : sum_2730;
      registration_half_half_votes_up_q <= and_2711_s4_q ? 7'h0 : sum_2734;
      registration_down_q <= and_2766 ? sum_2785 : registration_down_q;
      registration_up_q <= and_2766 ? sum_2794 : registration_up_q;
      registration_enough_q <= select_2808;
      registration_votes_down_q <= and_2813 ? less_2814 : registration_votes_down_q;
      registration_votes_up_q <= and_2813 ? less_2816 : registration_votes_up_q;
      registration_other_enough_q <= and_2822 ? select_2808 : registration_other_enough_q;
      registration_other_down_q <= and_2822 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2822 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1383_s4_q & and_2829)) & or_2854;
      segment_textured_q <= select_2188 + {5'h0, and_2631};
      segment_explained_q <= select_2193 + {5'h0, and_2636};
      segment_nearer_q <= select_2199 + {5'h0, and_2641};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1383_s4_q ? select_2919 : good_q;
      good_known_q <= select_2924;
      hidden_for_q <= select_2938;
      product_q <= equal_1383_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_2959;
      disagree_q <= equal_1383_s4_q ? select_2911 : disagree_q;
      too_much_q <= equal_1383_s4_q ? select_2969 : too_much_q;
      hides_q <= equal_1383_s4_q ? select_2933 : hides_q;
      proven_q <= and_2149_s4_q ? select_3079 : proven_q;
      seen_q <= select_3137;
      nearer_q <= select_3143;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    census_changes_values_3_left_q = 12'h0;
    census_changes_values_3_right_q = 12'h0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      census_changes_values_0_left_q <= and_416_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_416_s4_q ? sum_2497_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2499;
      census_changes_values_1_right_q <= select_2500;
      census_changes_values_2_left_q <= select_2501;
      census_changes_values_2_right_q <= select_2502;
      census_changes_values_3_left_q <= select_2503;
      census_changes_values_3_right_q <= select_2504;
      sharpness_last_detail_0_q <= select_2523;
      sharpness_last_detail_1_q <= select_2524;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3081_s5_q;
  logic or_3145_s5_q;
  logic and_3146_s5_q;
  logic and_3150_s5_q;
  logic and_3153_s5_q;
  logic and_3159_s5_q;
  logic and_3162_s5_q;
  logic and_3168_s5_q;
  logic and_3172_s5_q;
  logic and_3180_s5_q;
  logic and_3184_s5_q;
  logic [5:0] select_3186_s5_q;
  logic [31:0] select_3202_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3081_s5_q <= said_q;
      or_3145_s5_q <= not_3144 | select_3137;
      and_3146_s5_q <= cfg_prove_i & select_3143;
      and_3150_s5_q <= and_3150;
      and_3153_s5_q <= equal_1383_s4_q & (equal_2922_s4_q & (cfg_prove_i & or_2902));
      and_3159_s5_q <= and_3159;
      and_3162_s5_q <= and_3162;
      and_3168_s5_q <= equal_1383_s4_q & (equal_2922_s4_q & (not_3155 & or_3165));
      and_3172_s5_q <= and_3172;
      and_3180_s5_q <= equal_1383_s4_q & (equal_2922_s4_q & (cfg_prove_i & and_3177));
      and_3184_s5_q <= and_3184;
      select_3186_s5_q <= equal_1383_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3202_s5_q <= equal_1383_s4_q ? (x_s4_q[6] ? select_3200 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3145_s5_q;
  assign marks_nearer_o = and_3146_s5_q;
  assign verdict_valid_o = and_3081_s5_q;
  assign verdict_unproven_yet_o = and_3150_s5_q;
  assign verdict_untextured_o = and_3153_s5_q;
  assign verdict_disagree_o = and_3159_s5_q;
  assign verdict_moved_o = and_3162_s5_q;
  assign verdict_unsharp_left_o = and_3168_s5_q;
  assign verdict_unsharp_right_o = and_3172_s5_q;
  assign verdict_hidden_o = and_3180_s5_q;
  assign frame_valid_o = and_3184_s5_q;
  assign frame_index_o = select_3186_s5_q;
  assign frame_word_o = select_3202_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], detail_4[1:0], detail_3[1:0], sum_2509[4:0], sum_1658[0], sum_1567[0], sum_1563[0], sum_529[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
