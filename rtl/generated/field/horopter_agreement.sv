// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2475 bits, pipeline 1121 bits, memories 29026 bits.
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
  output logic [15:0] verdict_supervised_o,
  output logic [15:0] verdict_textured_o,
  output logic [15:0] verdict_explained_o,
  output logic [15:0] verdict_nearer_o,
  output logic [15:0] verdict_unproven_o,
  output logic [15:0] verdict_regions_bad_o,
  output logic verdict_unproven_yet_o,
  output logic verdict_untextured_o,
  output logic verdict_disagree_o,
  output logic verdict_moved_o,
  output logic verdict_unsharp_left_o,
  output logic verdict_unsharp_right_o,
  output logic verdict_hidden_o,
  output logic signed [19:0] verdict_across_0_o,
  output logic signed [19:0] verdict_across_1_o,
  output logic signed [19:0] verdict_across_2_o,
  output logic signed [19:0] verdict_across_3_o,
  output logic [11:0] verdict_measured_0_o,
  output logic [11:0] verdict_measured_1_o,
  output logic [11:0] verdict_measured_2_o,
  output logic [11:0] verdict_measured_3_o,
  output logic [23:0] verdict_detail_0_o,
  output logic [23:0] verdict_detail_1_o,
  output logic [23:0] verdict_contrast_0_o,
  output logic [23:0] verdict_contrast_1_o,
  output logic region_valid_o,
  output logic [5:0] region_region_o,
  output logic [11:0] region_textured_o,
  output logic [11:0] region_explained_o,
  output logic [11:0] region_nearer_o
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
  logic [3:0] sum_1619;
  assign sum_1619 = {2'h0, cfg_width_i[8:7]} + 4'hf;
  logic [5:0] sum_1626;
  assign sum_1626 = {1'b0, cfg_width_i[8:4]} + 6'h7;
  logic [5:0] sum_1653;
  assign sum_1653 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_2100;
  assign difference_2100 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2302;
  assign less_2302 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2303;
  assign sum_2303 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2304;
  assign select_2304 = less_2302 ? {sum_2303, cfg_height_i[5:3]} : 8'h0;
  logic not_2339;
  assign not_2339 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic left_first_q;
  logic right_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [5:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [7:0] averager_place_q;
  logic averager_running_mask_q;
  logic [2:0] run_phase_q;
  logic [7:0] run_lowest_q;
  logic [7:0] run_highest_q;
  logic [7:0] run_beats_q;
  logic [5:0] run_shift_q;
  logic run_last_shift_q;
  logic [2:0] following_phase_q;
  logic [7:0] following_lowest_q;
  logic [7:0] following_highest_q;
  logic [7:0] following_beats_q;
  logic [5:0] following_shift_q;
  logic following_last_shift_q;
  logic [7:0] x_q;
  logic [7:0] beats_left_q;
  logic [5:0] last_q;
  logic [5:0] least_q;
  logic [7:0] first_beats_q;
  logic [6:0] whole_beats_q;
  logic [6:0] age_q;
  logic ends_q;
  logic final_row_q;
  logic [7:0] next_lowest_q;
  logic [7:0] next_highest_q;
  logic [7:0] next_beats_q;
  logic [5:0] next_shift_q;
  logic next_last_shift_q;
  logic [9:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_302;
  assign select_302 = left_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_304;
  assign select_304 = left_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [7:0] select_307;
  assign select_307 = ({select_304, select_302} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:95
  logic [7:0] select_308;
  assign select_308 = select_302[0] ? averager_place_q : select_307;
  // hls/stages/agreement.hpp:123
  logic and_310;
  assign and_310 = right_q & (~marks_first_i);
  // hls/stages/census.hpp:40
  logic or_311;
  assign or_311 = left_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:174
  logic and_317;
  assign and_317 = (~((~or_311) | (~select_302[0]))) & (select_308 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_324;
  assign select_324 = left_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:174
  logic whole;
  assign whole = select_302[0] ? (present_i & averager_running_mask_q) : present_i;
  // hls/stages/census.hpp:45
  logic equal_340;
  assign equal_340 = select_302 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_341;
  assign equal_341 = select_324 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_342;
  assign and_342 = equal_341 & and_317;
  // hls/stages/census.hpp:106
  logic and_343;
  assign and_343 = equal_340 & and_342;
  // hls/stages/agreement.hpp:334
  logic equal_361;
  assign equal_361 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:321
  logic not_362;
  assign not_362 = ~equal_361;
  // hls/stages/agreement.hpp:334
  logic equal_363;
  assign equal_363 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:392
  logic less_364;
  assign less_364 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:396
  logic not_365;
  assign not_365 = ~less_364;
  // hls/stages/agreement.hpp:299
  logic and_366;
  assign and_366 = equal_363 & not_365;
  logic and_367;
  assign and_367 = not_362 & and_366;
  // hls/stages/census.hpp:40
  logic [5:0] row;
  assign row = left_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:640
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:299
  logic and_451;
  assign and_451 = drew & not_365;
  // hls/stages/agreement.hpp:411
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:698
  logic or_952;
  assign or_952 = left_first_q | raster_row_ended_q;
  // hls/stages/agreement.hpp:699
  logic [8:0] select_953;
  assign select_953 = or_952 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:700
  logic [9:0] select_955;
  assign select_955 = left_first_q ? 10'h1 : (or_952 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1048;
  assign sum_1048 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/census.hpp:46
  logic [2:0] sum_1060;
  assign sum_1060 = select_302 + 3'h1;
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1063;
  assign select_1063 = and_310 ? (left_first_q ? sum_1060 : (and_310 ? sum_1060 : raster_at_x_q)) : raster_at_x_q;
  // hls/stages/census.hpp:52
  logic [2:0] select_1065;
  assign select_1065 = marks_last_i ? (select_324 + 3'h1) : select_324;
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1067;
  assign select_1067 = left_first_q ? select_1065 : (and_310 ? select_1065 : raster_at_y_q);
  // hls/stages/census.hpp:45
  logic [5:0] sum_1069;
  assign sum_1069 = select_304 + {5'h0, equal_340};
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1071;
  assign select_1071 = left_first_q ? sum_1069 : (and_310 ? sum_1069 : raster_at_column_q);
  // hls/stages/census.hpp:52
  logic [5:0] select_1074;
  assign select_1074 = marks_last_i ? (row + {5'h0, equal_341}) : row;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1076;
  assign select_1076 = left_first_q ? select_1074 : (and_310 ? select_1074 : raster_at_row_q);
  // hls/stages/census.hpp:52
  logic select_1080;
  assign select_1080 = marks_last_i ? (or_311 & (~raster_final_row_q)) : or_311;
  // hls/stages/agreement.hpp:179
  logic select_1082;
  assign select_1082 = left_first_q ? select_1080 : (and_310 ? select_1080 : raster_at_live_q);
  // hls/stages/census.hpp:44
  logic [8:0] select_1085;
  assign select_1085 = left_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, marks_last_i});
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1087;
  assign select_1087 = left_first_q ? cfg_height_i : (and_310 ? select_1085 : raster_rows_left_q);
  logic select_1090;
  assign select_1090 = left_first_q ? marks_last_i : (and_310 ? marks_last_i : raster_row_ended_q);
  // hls/stages/census.hpp:43
  logic equal_1092;
  assign equal_1092 = raster_rows_left_q == 9'h1;
  // hls/stages/agreement.hpp:179
  logic select_1094;
  assign select_1094 = left_first_q ? equal_1092 : (and_310 ? equal_1092 : raster_final_row_q);
  logic [7:0] select_1147;
  assign select_1147 = left_first_q ? select_308 : (and_310 ? select_308 : averager_place_q);
  logic select_1150;
  assign select_1150 = left_first_q ? whole : (and_310 ? whole : averager_running_mask_q);
  // hls/stages/agreement.hpp:245
  logic equal_1518;
  assign equal_1518 = {last[7:6], select_304} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:172
  logic [2:0] select_1519;
  assign select_1519 = ends_q ? following_phase_q : run_phase_q;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_1521;
  assign select_1521 = and_343 ? (equal_1518 ? 3'h1 : select_1519) : select_1519;
  // hls/stages/agreement.hpp:179
  logic [2:0] select_1523;
  assign select_1523 = left_first_q ? select_1521 : (and_310 ? select_1521 : select_1519);
  // hls/stages/agreement.hpp:172
  logic [7:0] select_1525;
  assign select_1525 = ends_q ? following_lowest_q : run_lowest_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1527;
  assign select_1527 = and_343 ? (equal_1518 ? 8'h0 : select_1525) : select_1525;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1529;
  assign select_1529 = left_first_q ? select_1527 : (and_310 ? select_1527 : select_1525);
  // hls/stages/agreement.hpp:172
  logic [7:0] select_1531;
  assign select_1531 = ends_q ? following_highest_q : run_highest_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1533;
  assign select_1533 = and_343 ? (equal_1518 ? 8'h0 : select_1531) : select_1531;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1535;
  assign select_1535 = left_first_q ? select_1533 : (and_310 ? select_1533 : select_1531);
  // hls/stages/agreement.hpp:172
  logic [7:0] select_1537;
  assign select_1537 = ends_q ? following_beats_q : run_beats_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1539;
  assign select_1539 = and_343 ? (equal_1518 ? 8'hc : select_1537) : select_1537;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1541;
  assign select_1541 = left_first_q ? select_1539 : (and_310 ? select_1539 : select_1537);
  // hls/stages/agreement.hpp:172
  logic [5:0] select_1543;
  assign select_1543 = ends_q ? following_shift_q : run_shift_q;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1545;
  assign select_1545 = and_343 ? (equal_1518 ? 6'h0 : select_1543) : select_1543;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1547;
  assign select_1547 = left_first_q ? select_1545 : (and_310 ? select_1545 : select_1543);
  // hls/stages/agreement.hpp:172
  logic select_1549;
  assign select_1549 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:246
  logic not_1550;
  assign not_1550 = ~equal_1518;
  // hls/stages/agreement.hpp:176
  logic select_1552;
  assign select_1552 = and_343 ? (select_1549 & not_1550) : select_1549;
  // hls/stages/agreement.hpp:179
  logic select_1554;
  assign select_1554 = left_first_q ? select_1552 : (and_310 ? select_1552 : select_1549);
  // hls/stages/agreement.hpp:326
  logic not_1556;
  assign not_1556 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:334
  logic equal_1557;
  assign equal_1557 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:153
  logic or_1558;
  assign or_1558 = equal_1557 | equal_363;
  logic [2:0] select_1559;
  assign select_1559 = equal_361 ? {run_last_shift_q, {2{not_1556}}} : {1'b0, or_1558, equal_363};
  logic [7:0] select_1562;
  assign select_1562 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [5:0] select_1563;
  assign select_1563 = equal_363 ? least_q : 6'h0;
  logic [7:0] select_1567;
  assign select_1567 = run_last_shift_q ? {2'h0, last_q} : (run_shift_q[5] ? {2'h0, last_q} : next_highest_q);
  logic [5:0] select_1569;
  assign select_1569 = equal_363 ? last_q : (equal_1557 ? last_q : 6'h0);
  logic [6:0] select_1573;
  assign select_1573 = equal_1557 ? whole_beats_q : 7'h0;
  logic [7:0] select_1575;
  assign select_1575 = equal_361 ? (run_last_shift_q ? {1'b0, whole_beats_q} : next_beats_q) : (equal_363 ? first_beats_q : {1'b0, select_1573});
  logic [5:0] select_1580;
  assign select_1580 = equal_361 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_363 ? (6'h0 - least_q) : 6'h0);
  // hls/stages/agreement.hpp:136
  logic not_1582;
  assign not_1582 = ~drew;
  // hls/stages/agreement.hpp:153
  logic select_1586;
  assign select_1586 = equal_361 ? (next_last_shift_q & not_1556) : (equal_363 & (least_q == 6'h0));
  // hls/stages/agreement.hpp:172
  logic [7:0] select_1589;
  assign select_1589 = ends_q ? following_lowest_q : (x_q + 8'h1);
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1591;
  assign select_1591 = and_343 ? (equal_1518 ? 8'h0 : select_1589) : select_1589;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1593;
  assign select_1593 = left_first_q ? select_1591 : (and_310 ? select_1591 : select_1589);
  // hls/stages/agreement.hpp:172
  logic [7:0] select_1596;
  assign select_1596 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1598;
  assign select_1598 = and_343 ? (equal_1518 ? 8'hc : select_1596) : select_1596;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1600;
  assign select_1600 = left_first_q ? select_1598 : (and_310 ? select_1598 : select_1596);
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1603;
  assign select_1603 = and_343 ? (equal_1518 ? select_304 : last_q) : last_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1606;
  assign select_1606 = and_310 ? (left_first_q ? select_1603 : (and_310 ? select_1603 : last_q)) : last_q;
  // hls/stages/agreement.hpp:252
  logic less_1612;
  assign less_1612 = 5'he < select_304[5:1];
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1615;
  assign select_1615 = and_343 ? (equal_1518 ? (less_1612 ? 6'h1e : select_304) : least_q) : least_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1618;
  assign select_1618 = and_310 ? (left_first_q ? select_1615 : (and_310 ? select_1615 : least_q)) : least_q;
  // hls/stages/agreement.hpp:246
  logic [7:0] select_1621;
  assign select_1621 = equal_1518 ? (less_1612 ? {sum_1619, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1622;
  assign select_1622 = and_343 ? select_1621 : first_beats_q;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_1624;
  assign select_1624 = left_first_q ? select_1622 : (and_310 ? select_1622 : first_beats_q);
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1628;
  assign select_1628 = and_343 ? (equal_1518 ? {sum_1626, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:179
  logic [6:0] select_1630;
  assign select_1630 = left_first_q ? select_1628 : (and_310 ? select_1628 : whole_beats_q);
  // hls/stages/agreement.hpp:302
  logic not_1632;
  assign not_1632 = ~ends_q;
  // hls/stages/agreement.hpp:172
  logic [5:0] select_1633;
  assign select_1633 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1635;
  assign select_1635 = and_343 ? (equal_1518 ? 7'h0 : {select_1633, not_1632}) : {select_1633, not_1632};
  // hls/stages/agreement.hpp:179
  logic [6:0] select_1637;
  assign select_1637 = left_first_q ? select_1635 : (and_310 ? select_1635 : {select_1633, not_1632});
  // hls/stages/agreement.hpp:172
  logic and_1640;
  assign and_1640 = not_1632 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:176
  logic select_1642;
  assign select_1642 = and_343 ? (and_1640 & not_1550) : and_1640;
  // hls/stages/agreement.hpp:179
  logic select_1645;
  assign select_1645 = and_310 ? (left_first_q ? select_1642 : (and_310 ? select_1642 : and_1640)) : and_1640;
  // hls/stages/agreement.hpp:262
  logic [6:0] sum_1646;
  assign sum_1646 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:246
  logic select_1648;
  assign select_1648 = equal_1518 ? ({sum_1646[6], cfg_height_i[8:3]} == {1'b0, sum_1646[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:176
  logic select_1649;
  assign select_1649 = and_343 ? select_1648 : final_row_q;
  // hls/stages/agreement.hpp:179
  logic select_1651;
  assign select_1651 = left_first_q ? select_1649 : (and_310 ? select_1649 : final_row_q);
  // hls/stages/agreement.hpp:512
  logic [4:0] sum_1791;
  assign sum_1791 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:146
  logic not_2171;
  assign not_2171 = ~run_shift_q[5];
  // hls/stages/agreement.hpp:179
  logic [9:0] select_2282;
  assign select_2282 = and_310 ? (left_first_q ? 10'h1 : (and_310 ? select_955 : rows_passed_q)) : rows_passed_q;
  logic [8:0] select_2284;
  assign select_2284 = left_first_q ? {select_953[7:0], or_952} : (and_310 ? {select_953[7:0], or_952} : columns_passed_q);

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:765; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_367;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:766; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (equal_361 ? not_365 : (equal_363 ? not_365 : and_451));
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:767; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_361 ? (run_shift_q + x_q[5:0]) : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_361 ? not_365 : and_366);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_first_q <= 1'b0;
      right_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 6'h0;
      raster_at_row_q <= 6'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 8'h0;
      averager_running_mask_q <= 1'b0;
      run_phase_q <= 3'h0;
      run_lowest_q <= 8'h0;
      run_highest_q <= 8'h0;
      run_beats_q <= 8'h0;
      run_shift_q <= 6'h0;
      run_last_shift_q <= 1'b0;
      following_phase_q <= 3'h0;
      following_lowest_q <= 8'h0;
      following_highest_q <= 8'h0;
      following_beats_q <= 8'h0;
      following_shift_q <= 6'h0;
      following_last_shift_q <= 1'b0;
      x_q <= 8'h0;
      beats_left_q <= 8'h0;
      last_q <= 6'h0;
      least_q <= 6'h0;
      first_beats_q <= 8'h0;
      whole_beats_q <= 7'h0;
      age_q <= 7'h0;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      next_lowest_q <= 8'h0;
      next_highest_q <= 8'h0;
      next_beats_q <= 8'h0;
      next_shift_q <= 6'h0;
      next_last_shift_q <= 1'b0;
      rows_passed_q <= 10'h0;
      columns_passed_q <= 9'h0;
    end else if (s0_en) begin
      left_first_q <= and_310 ? left_first_q : marks_first_i;
      right_q <= (~and_310) & (~marks_last_i);
      raster_at_x_q <= select_1063;
      raster_at_y_q <= and_310 ? select_1067 : raster_at_y_q;
      raster_at_column_q <= and_310 ? select_1071 : raster_at_column_q;
      raster_at_row_q <= and_310 ? select_1076 : raster_at_row_q;
      raster_at_live_q <= and_310 ? select_1082 : raster_at_live_q;
      raster_rows_left_q <= and_310 ? select_1087 : raster_rows_left_q;
      raster_row_ended_q <= and_310 ? select_1090 : raster_row_ended_q;
      raster_final_row_q <= and_310 ? select_1094 : raster_final_row_q;
      averager_place_q <= and_310 ? select_1147 : averager_place_q;
      averager_running_mask_q <= and_310 ? select_1150 : averager_running_mask_q;
      run_phase_q <= and_310 ? select_1523 : select_1519;
      run_lowest_q <= and_310 ? select_1529 : select_1525;
      run_highest_q <= and_310 ? select_1535 : select_1531;
      run_beats_q <= and_310 ? select_1541 : select_1537;
      run_shift_q <= and_310 ? select_1547 : select_1543;
      run_last_shift_q <= and_310 ? select_1554 : select_1549;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1559;
      following_lowest_q <= drew ? 8'h0 : (equal_361 ? select_1562 : {2'h0, select_1563});
      following_highest_q <= drew ? 8'h0 : (equal_361 ? select_1567 : {2'h0, select_1569});
      following_beats_q <= drew ? 8'h3f : select_1575;
      following_shift_q <= drew ? 6'h0 : select_1580;
      following_last_shift_q <= not_1582 & select_1586;
      x_q <= and_310 ? select_1593 : select_1589;
      beats_left_q <= and_310 ? select_1600 : select_1596;
      last_q <= select_1606;
      least_q <= select_1618;
      first_beats_q <= and_310 ? select_1624 : first_beats_q;
      whole_beats_q <= and_310 ? select_1630 : whole_beats_q;
      age_q <= and_310 ? select_1637 : {select_1633, not_1632};
      ends_q <= select_1645;
      final_row_q <= and_310 ? select_1651 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_2171}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{2{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 8'hff);
      rows_passed_q <= select_2282;
      columns_passed_q <= and_310 ? select_2284 : columns_passed_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic marks_last_s1_q;
  logic left_first_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [1:0] age_s1_q;
  logic select_302_s1_q;
  logic [5:0] select_304_s1_q;
  logic [7:0] select_308_s1_q;
  logic and_310_s1_q;
  logic and_317_s1_q;
  logic equal_325_s1_q;
  logic whole_s1_q;
  logic and_342_s1_q;
  logic and_343_s1_q;
  logic equal_349_s1_q;
  logic equal_361_s1_q;
  logic not_362_s1_q;
  logic equal_363_s1_q;
  logic less_364_s1_q;
  logic not_365_s1_q;
  logic and_367_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_451_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_505_s1_q;
  logic equal_511_s1_q;
  logic equal_578_s1_q;
  logic equal_815_s1_q;
  logic equal_879_s1_q;
  logic equal_902_s1_q;
  logic equal_905_s1_q;
  logic and_956_s1_q;
  logic not_1050_s1_q;
  logic equal_1518_s1_q;
  logic not_1582_s1_q;
  logic less_1792_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      marks_last_s1_q <= marks_last_i;
      left_first_s1_q <= left_first_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4]};
      select_302_s1_q <= select_302[0];
      select_304_s1_q <= select_304;
      select_308_s1_q <= select_308;
      and_310_s1_q <= and_310;
      and_317_s1_q <= and_317;
      equal_325_s1_q <= select_324 == 3'h0;
      whole_s1_q <= whole;
      and_342_s1_q <= and_342;
      and_343_s1_q <= and_343;
      equal_349_s1_q <= select_302 == 3'h1;
      equal_361_s1_q <= equal_361;
      not_362_s1_q <= not_362;
      equal_363_s1_q <= equal_363;
      less_364_s1_q <= less_364;
      not_365_s1_q <= not_365;
      and_367_s1_q <= and_367;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_451_s1_q <= and_451;
      x_s1_2_q <= x[6:0];
      and_505_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_511_s1_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      equal_578_s1_q <= run_lowest_q == x_q;
      equal_815_s1_q <= run_lowest_q == x;
      equal_879_s1_q <= run_highest_q == x;
      equal_902_s1_q <= x_q == {2'h0, last_q};
      equal_905_s1_q <= run_phase_q == 3'h5;
      and_956_s1_q <= select_953[8] & select_955[9];
      not_1050_s1_q <= ~({sum_1048, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1518_s1_q <= equal_1518;
      not_1582_s1_q <= not_1582;
      less_1792_s1_q <= {2'h0, sum_1791, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:367
  logic equal_455;
  assign equal_455 = row_q == 6'h0;
  logic [11:0] select_456;
  assign select_456 = equal_455 ? 12'h0 : left_rdata_q[11:0];
  logic not_457;
  assign not_457 = ~equal_455;
  logic and_458;
  assign and_458 = left_rdata_q[12] & not_457;
  logic and_459;
  assign and_459 = left_rdata_q[13] & not_457;
  logic and_460;
  assign and_460 = left_rdata_q[14] & not_457;
  logic and_461;
  assign and_461 = left_rdata_q[15] & not_457;
  logic equal_462;
  assign equal_462 = row_q[5:1] == 5'h0;
  logic [11:0] select_463;
  assign select_463 = equal_462 ? 12'h0 : left_rdata_q[27:16];
  logic not_464;
  assign not_464 = ~equal_462;
  logic and_465;
  assign and_465 = left_rdata_q[28] & not_464;
  logic and_466;
  assign and_466 = left_rdata_q[29] & not_464;
  logic and_467;
  assign and_467 = left_rdata_q[30] & not_464;
  logic and_468;
  assign and_468 = left_rdata_q[31] & not_464;
  logic less_469;
  assign less_469 = row_q < 6'h3;
  logic [11:0] select_470;
  assign select_470 = less_469 ? 12'h0 : left_rdata_q[43:32];
  logic not_471;
  assign not_471 = ~less_469;
  logic and_472;
  assign and_472 = left_rdata_q[44] & not_471;
  logic and_473;
  assign and_473 = left_rdata_q[45] & not_471;
  logic and_474;
  assign and_474 = left_rdata_q[46] & not_471;
  logic and_475;
  assign and_475 = left_rdata_q[47] & not_471;
  logic equal_476;
  assign equal_476 = row_q[5:2] == 4'h0;
  logic [11:0] select_477;
  assign select_477 = equal_476 ? 12'h0 : left_rdata_q[59:48];
  logic not_478;
  assign not_478 = ~equal_476;
  logic and_479;
  assign and_479 = left_rdata_q[60] & not_478;
  // hls/stages/agreement.hpp:368
  logic [11:0] select_484;
  assign select_484 = equal_455 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_485;
  assign and_485 = right_codes_rdata_q[12] & not_457;
  logic [11:0] select_486;
  assign select_486 = equal_462 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_487;
  assign and_487 = right_codes_rdata_q[25] & not_464;
  logic [11:0] select_488;
  assign select_488 = less_469 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_489;
  assign and_489 = right_codes_rdata_q[38] & not_471;
  logic [11:0] select_490;
  assign select_490 = equal_476 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_491;
  assign and_491 = right_codes_rdata_q[51] & not_478;
  logic less_492;
  assign less_492 = row_q < 6'h5;
  logic [11:0] select_493;
  assign select_493 = less_492 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_495;
  assign and_495 = right_codes_rdata_q[64] & (~less_492);
  logic less_496;
  assign less_496 = row_q[5:1] < 5'h3;
  logic [11:0] select_497;
  assign select_497 = less_496 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_499;
  assign and_499 = right_codes_rdata_q[77] & (~less_496);
  // hls/stages/agreement.hpp:319
  logic not_506;
  assign not_506 = ~equal_363_s1_q;
  // hls/stages/agreement.hpp:299
  logic and_507;
  assign and_507 = not_506 & and_451_s1_q;
  logic select_508;
  assign select_508 = equal_361_s1_q ? and_505_s1_q : and_507;
  // hls/stages/agreement.hpp:162
  logic and_517;
  assign and_517 = left_rdata_q[44] & not_365_s1_q;
  logic [11:0] a;
  assign a = less_364_s1_q ? 12'h0 : left_rdata_q[43:32];
  logic [11:0] b;
  assign b = less_364_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_523;
  assign not_523 = ~(a ^ b);
  logic [1:0] sum_525;
  assign sum_525 = {1'b0, not_523[2]} + ({1'b0, not_523[0]} + {1'b0, not_523[1]});
  logic [2:0] sum_528;
  assign sum_528 = {2'h0, not_523[5]} + ({2'h0, not_523[4]} + ({2'h0, not_523[3]} + {1'b0, sum_525}));
  logic [2:0] sum_529;
  assign sum_529 = {2'h0, not_523[6]} + sum_528;
  logic [3:0] sum_532;
  assign sum_532 = {3'h0, not_523[9]} + ({3'h0, not_523[8]} + ({3'h0, not_523[7]} + {1'b0, sum_529}));
  // hls/stages/agreement.hpp:162
  logic [11:0] a_2;
  assign a_2 = less_364_s1_q ? 12'h0 : left_rdata_q[59:48];
  logic [11:0] b_2;
  assign b_2 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_542;
  assign not_542 = ~(a_2 ^ b_2);
  logic [1:0] sum_544;
  assign sum_544 = {1'b0, not_542[2]} + ({1'b0, not_542[0]} + {1'b0, not_542[1]});
  logic [2:0] sum_547;
  assign sum_547 = {2'h0, not_542[5]} + ({2'h0, not_542[4]} + ({2'h0, not_542[3]} + {1'b0, sum_544}));
  logic [2:0] sum_548;
  assign sum_548 = {2'h0, not_542[6]} + sum_547;
  logic [3:0] sum_551;
  assign sum_551 = {3'h0, not_542[9]} + ({3'h0, not_542[8]} + ({3'h0, not_542[7]} + {1'b0, sum_548}));
  // hls/stages/agreement.hpp:162
  logic and_556;
  assign and_556 = left_rdata_q[76] & not_365_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_364_s1_q ? 12'h0 : left_rdata_q[75:64];
  logic [11:0] b_3;
  assign b_3 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_562;
  assign not_562 = ~(a_3 ^ b_3);
  logic [1:0] sum_564;
  assign sum_564 = {1'b0, not_562[2]} + ({1'b0, not_562[0]} + {1'b0, not_562[1]});
  logic [2:0] sum_567;
  assign sum_567 = {2'h0, not_562[5]} + ({2'h0, not_562[4]} + ({2'h0, not_562[3]} + {1'b0, sum_564}));
  logic [2:0] sum_568;
  assign sum_568 = {2'h0, not_562[6]} + sum_567;
  logic [3:0] sum_571;
  assign sum_571 = {3'h0, not_562[9]} + ({3'h0, not_562[8]} + ({3'h0, not_562[7]} + {1'b0, sum_568}));
  logic [11:0] not_583;
  assign not_583 = ~(a ^ b_2);
  logic [1:0] sum_585;
  assign sum_585 = {1'b0, not_583[2]} + ({1'b0, not_583[0]} + {1'b0, not_583[1]});
  logic [2:0] sum_588;
  assign sum_588 = {2'h0, not_583[5]} + ({2'h0, not_583[4]} + ({2'h0, not_583[3]} + {1'b0, sum_585}));
  logic [2:0] sum_589;
  assign sum_589 = {2'h0, not_583[6]} + sum_588;
  logic [3:0] sum_592;
  assign sum_592 = {3'h0, not_583[9]} + ({3'h0, not_583[8]} + ({3'h0, not_583[7]} + {1'b0, sum_589}));
  logic [11:0] not_598;
  assign not_598 = ~(a_2 ^ b_3);
  logic [1:0] sum_600;
  assign sum_600 = {1'b0, not_598[2]} + ({1'b0, not_598[0]} + {1'b0, not_598[1]});
  logic [2:0] sum_603;
  assign sum_603 = {2'h0, not_598[5]} + ({2'h0, not_598[4]} + ({2'h0, not_598[3]} + {1'b0, sum_600}));
  logic [2:0] sum_604;
  assign sum_604 = {2'h0, not_598[6]} + sum_603;
  logic [3:0] sum_607;
  assign sum_607 = {3'h0, not_598[9]} + ({3'h0, not_598[8]} + ({3'h0, not_598[7]} + {1'b0, sum_604}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_4;
  assign b_4 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_616;
  assign not_616 = ~(a_3 ^ b_4);
  logic [1:0] sum_618;
  assign sum_618 = {1'b0, not_616[2]} + ({1'b0, not_616[0]} + {1'b0, not_616[1]});
  logic [2:0] sum_621;
  assign sum_621 = {2'h0, not_616[5]} + ({2'h0, not_616[4]} + ({2'h0, not_616[3]} + {1'b0, sum_618}));
  logic [2:0] sum_622;
  assign sum_622 = {2'h0, not_616[6]} + sum_621;
  logic [3:0] sum_625;
  assign sum_625 = {3'h0, not_616[9]} + ({3'h0, not_616[8]} + ({3'h0, not_616[7]} + {1'b0, sum_622}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_5;
  assign b_5 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_640;
  assign not_640 = ~(a ^ b_5);
  logic [1:0] sum_642;
  assign sum_642 = {1'b0, not_640[2]} + ({1'b0, not_640[0]} + {1'b0, not_640[1]});
  logic [2:0] sum_645;
  assign sum_645 = {2'h0, not_640[5]} + ({2'h0, not_640[4]} + ({2'h0, not_640[3]} + {1'b0, sum_642}));
  logic [2:0] sum_646;
  assign sum_646 = {2'h0, not_640[6]} + sum_645;
  logic [3:0] sum_649;
  assign sum_649 = {3'h0, not_640[9]} + ({3'h0, not_640[8]} + ({3'h0, not_640[7]} + {1'b0, sum_646}));
  logic [11:0] not_655;
  assign not_655 = ~(a_2 ^ b);
  logic [1:0] sum_657;
  assign sum_657 = {1'b0, not_655[2]} + ({1'b0, not_655[0]} + {1'b0, not_655[1]});
  logic [2:0] sum_660;
  assign sum_660 = {2'h0, not_655[5]} + ({2'h0, not_655[4]} + ({2'h0, not_655[3]} + {1'b0, sum_657}));
  logic [2:0] sum_661;
  assign sum_661 = {2'h0, not_655[6]} + sum_660;
  logic [3:0] sum_664;
  assign sum_664 = {3'h0, not_655[9]} + ({3'h0, not_655[8]} + ({3'h0, not_655[7]} + {1'b0, sum_661}));
  logic [11:0] not_671;
  assign not_671 = ~(a_3 ^ b_2);
  logic [1:0] sum_673;
  assign sum_673 = {1'b0, not_671[2]} + ({1'b0, not_671[0]} + {1'b0, not_671[1]});
  logic [2:0] sum_676;
  assign sum_676 = {2'h0, not_671[5]} + ({2'h0, not_671[4]} + ({2'h0, not_671[3]} + {1'b0, sum_673}));
  logic [2:0] sum_677;
  assign sum_677 = {2'h0, not_671[6]} + sum_676;
  logic [3:0] sum_680;
  assign sum_680 = {3'h0, not_671[9]} + ({3'h0, not_671[8]} + ({3'h0, not_671[7]} + {1'b0, sum_677}));
  logic [11:0] not_695;
  assign not_695 = ~(a ^ b_3);
  logic [1:0] sum_697;
  assign sum_697 = {1'b0, not_695[2]} + ({1'b0, not_695[0]} + {1'b0, not_695[1]});
  logic [2:0] sum_700;
  assign sum_700 = {2'h0, not_695[5]} + ({2'h0, not_695[4]} + ({2'h0, not_695[3]} + {1'b0, sum_697}));
  logic [2:0] sum_701;
  assign sum_701 = {2'h0, not_695[6]} + sum_700;
  logic [3:0] sum_704;
  assign sum_704 = {3'h0, not_695[9]} + ({3'h0, not_695[8]} + ({3'h0, not_695[7]} + {1'b0, sum_701}));
  logic [11:0] not_710;
  assign not_710 = ~(a_2 ^ b_4);
  logic [1:0] sum_712;
  assign sum_712 = {1'b0, not_710[2]} + ({1'b0, not_710[0]} + {1'b0, not_710[1]});
  logic [2:0] sum_715;
  assign sum_715 = {2'h0, not_710[5]} + ({2'h0, not_710[4]} + ({2'h0, not_710[3]} + {1'b0, sum_712}));
  logic [2:0] sum_716;
  assign sum_716 = {2'h0, not_710[6]} + sum_715;
  logic [3:0] sum_719;
  assign sum_719 = {3'h0, not_710[9]} + ({3'h0, not_710[8]} + ({3'h0, not_710[7]} + {1'b0, sum_716}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_6;
  assign b_6 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_728;
  assign not_728 = ~(a_3 ^ b_6);
  logic [1:0] sum_730;
  assign sum_730 = {1'b0, not_728[2]} + ({1'b0, not_728[0]} + {1'b0, not_728[1]});
  logic [2:0] sum_733;
  assign sum_733 = {2'h0, not_728[5]} + ({2'h0, not_728[4]} + ({2'h0, not_728[3]} + {1'b0, sum_730}));
  logic [2:0] sum_734;
  assign sum_734 = {2'h0, not_728[6]} + sum_733;
  logic [3:0] sum_737;
  assign sum_737 = {3'h0, not_728[9]} + ({3'h0, not_728[8]} + ({3'h0, not_728[7]} + {1'b0, sum_734}));
  // hls/stages/agreement.hpp:162
  logic [11:0] b_7;
  assign b_7 = less_364_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:377
  logic [11:0] not_757;
  assign not_757 = ~(a ^ b_7);
  logic [1:0] sum_759;
  assign sum_759 = {1'b0, not_757[2]} + ({1'b0, not_757[0]} + {1'b0, not_757[1]});
  logic [2:0] sum_762;
  assign sum_762 = {2'h0, not_757[5]} + ({2'h0, not_757[4]} + ({2'h0, not_757[3]} + {1'b0, sum_759}));
  logic [2:0] sum_763;
  assign sum_763 = {2'h0, not_757[6]} + sum_762;
  logic [3:0] sum_766;
  assign sum_766 = {3'h0, not_757[9]} + ({3'h0, not_757[8]} + ({3'h0, not_757[7]} + {1'b0, sum_763}));
  logic [11:0] not_772;
  assign not_772 = ~(a_2 ^ b_5);
  logic [1:0] sum_774;
  assign sum_774 = {1'b0, not_772[2]} + ({1'b0, not_772[0]} + {1'b0, not_772[1]});
  logic [2:0] sum_777;
  assign sum_777 = {2'h0, not_772[5]} + ({2'h0, not_772[4]} + ({2'h0, not_772[3]} + {1'b0, sum_774}));
  logic [2:0] sum_778;
  assign sum_778 = {2'h0, not_772[6]} + sum_777;
  logic [3:0] sum_781;
  assign sum_781 = {3'h0, not_772[9]} + ({3'h0, not_772[8]} + ({3'h0, not_772[7]} + {1'b0, sum_778}));
  logic [11:0] not_788;
  assign not_788 = ~(a_3 ^ b);
  logic [1:0] sum_790;
  assign sum_790 = {1'b0, not_788[2]} + ({1'b0, not_788[0]} + {1'b0, not_788[1]});
  logic [2:0] sum_793;
  assign sum_793 = {2'h0, not_788[5]} + ({2'h0, not_788[4]} + ({2'h0, not_788[3]} + {1'b0, sum_790}));
  logic [2:0] sum_794;
  assign sum_794 = {2'h0, not_788[6]} + sum_793;
  logic [3:0] sum_797;
  assign sum_797 = {3'h0, not_788[9]} + ({3'h0, not_788[8]} + ({3'h0, not_788[7]} + {1'b0, sum_794}));
  // hls/stages/agreement.hpp:504
  logic not_914;
  assign not_914 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:299
  logic and_1052;
  assign and_1052 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1050_s1_q);
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1608;
  assign select_1608 = and_343_s1_q ? (equal_1518_s1_q ? row_s1_q : row_q) : row_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_1610;
  assign select_1610 = left_first_s1_q ? select_1608 : (and_310_s1_q ? select_1608 : row_q);
  // hls/stages/agreement.hpp:246
  logic select_1656;
  assign select_1656 = equal_1518_s1_q ? (~({row_s1_q, 1'b0} < {sum_1653, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:176
  logic select_1657;
  assign select_1657 = and_343_s1_q ? select_1656 : lower_half_q;
  // hls/stages/agreement.hpp:179
  logic select_1659;
  assign select_1659 = left_first_s1_q ? select_1657 : (and_310_s1_q ? select_1657 : lower_half_q);

  // Memory best_left, 47 x 22, DISTANCE 12, hls/stages/agreement.hpp:768; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 22'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = equal_361_s1_q ? x_s1_2_q[5:0] : x_s1_q[5:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_508;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_367_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_479, select_477, and_475, and_474, and_473, and_472, select_470, and_468, and_467, and_466, and_465, select_463, and_461, and_460, and_459, and_458, select_456, fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_367_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_499, select_497, and_495, select_493, and_491, select_490, and_489, select_488, and_487, select_486, and_485, select_484, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_310_s1_q ? select_1610 : row_q;
      lower_half_q <= and_310_s1_q ? select_1659 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic left_first_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [1:0] age_s2_q;
  logic lower_half_s2_q;
  logic select_302_s2_q;
  logic [5:0] select_304_s2_q;
  logic [7:0] select_308_s2_q;
  logic and_310_s2_q;
  logic and_317_s2_q;
  logic equal_325_s2_q;
  logic whole_s2_q;
  logic and_342_s2_q;
  logic and_343_s2_q;
  logic equal_349_s2_q;
  logic equal_361_s2_q;
  logic not_362_s2_q;
  logic equal_363_s2_q;
  logic less_364_s2_q;
  logic not_365_s2_q;
  logic equal_395_s2_q;
  logic drew_s2_q;
  logic left_rdata_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_506_s2_q;
  logic select_508_s2_q;
  logic equal_511_s2_q;
  logic and_517_s2_q;
  logic and_518_s2_q;
  logic not_523_s2_q;
  logic [3:0] sum_533_s2_q;
  logic and_536_s2_q;
  logic and_537_s2_q;
  logic not_542_s2_q;
  logic [3:0] sum_552_s2_q;
  logic and_556_s2_q;
  logic and_557_s2_q;
  logic not_562_s2_q;
  logic [3:0] sum_572_s2_q;
  logic equal_578_s2_q;
  logic not_583_s2_q;
  logic [3:0] sum_593_s2_q;
  logic not_598_s2_q;
  logic [3:0] sum_608_s2_q;
  logic and_612_s2_q;
  logic not_616_s2_q;
  logic [3:0] sum_626_s2_q;
  logic and_636_s2_q;
  logic not_640_s2_q;
  logic [3:0] sum_650_s2_q;
  logic not_655_s2_q;
  logic [3:0] sum_665_s2_q;
  logic not_671_s2_q;
  logic [3:0] sum_681_s2_q;
  logic not_695_s2_q;
  logic [3:0] sum_705_s2_q;
  logic not_710_s2_q;
  logic [3:0] sum_720_s2_q;
  logic and_725_s2_q;
  logic not_728_s2_q;
  logic [3:0] sum_738_s2_q;
  logic and_754_s2_q;
  logic not_757_s2_q;
  logic [3:0] sum_767_s2_q;
  logic not_772_s2_q;
  logic [3:0] sum_782_s2_q;
  logic not_788_s2_q;
  logic [3:0] sum_798_s2_q;
  logic equal_815_s2_q;
  logic and_873_s2_q;
  logic equal_879_s2_q;
  logic equal_902_s2_q;
  logic equal_905_s2_q;
  logic and_916_s2_q;
  logic and_947_s2_q;
  logic and_956_s2_q;
  logic and_1054_s2_q;
  logic equal_1431_s2_q;
  logic equal_1518_s2_q;
  logic not_1582_s2_q;
  logic and_1706_s2_q;
  logic less_1789_s2_q;
  logic less_1792_s2_q;
  logic equal_2054_s2_q;
  logic less_2071_s2_q;
  logic equal_2246_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= marks_last_s1_q;
      left_first_s2_q <= left_first_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q;
      lower_half_s2_q <= lower_half_q;
      select_302_s2_q <= select_302_s1_q;
      select_304_s2_q <= select_304_s1_q;
      select_308_s2_q <= select_308_s1_q;
      and_310_s2_q <= and_310_s1_q;
      and_317_s2_q <= and_317_s1_q;
      equal_325_s2_q <= equal_325_s1_q;
      whole_s2_q <= whole_s1_q;
      and_342_s2_q <= and_342_s1_q;
      and_343_s2_q <= and_343_s1_q;
      equal_349_s2_q <= equal_349_s1_q;
      equal_361_s2_q <= equal_361_s1_q;
      not_362_s2_q <= not_362_s1_q;
      equal_363_s2_q <= equal_363_s1_q;
      less_364_s2_q <= less_364_s1_q;
      not_365_s2_q <= not_365_s1_q;
      equal_395_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      left_rdata_s2_q <= left_rdata_q[63];
      x_s2_2_q <= x_s1_2_q;
      not_506_s2_q <= not_506;
      select_508_s2_q <= select_508;
      equal_511_s2_q <= equal_511_s1_q;
      and_517_s2_q <= and_517;
      and_518_s2_q <= right_codes_rdata_q[38] & not_365_s1_q;
      not_523_s2_q <= not_523[11];
      sum_533_s2_q <= {3'h0, not_523[10]} + sum_532;
      and_536_s2_q <= left_rdata_q[60] & not_365_s1_q;
      and_537_s2_q <= right_codes_rdata_q[51] & not_365_s1_q;
      not_542_s2_q <= not_542[11];
      sum_552_s2_q <= {3'h0, not_542[10]} + sum_551;
      and_556_s2_q <= and_556;
      and_557_s2_q <= right_codes_rdata_q[64] & not_365_s1_q;
      not_562_s2_q <= not_562[11];
      sum_572_s2_q <= {3'h0, not_562[10]} + sum_571;
      equal_578_s2_q <= equal_578_s1_q;
      not_583_s2_q <= not_583[11];
      sum_593_s2_q <= {3'h0, not_583[10]} + sum_592;
      not_598_s2_q <= not_598[11];
      sum_608_s2_q <= {3'h0, not_598[10]} + sum_607;
      and_612_s2_q <= right_codes_rdata_q[77] & not_365_s1_q;
      not_616_s2_q <= not_616[11];
      sum_626_s2_q <= {3'h0, not_616[10]} + sum_625;
      and_636_s2_q <= right_codes_rdata_q[25] & not_365_s1_q;
      not_640_s2_q <= not_640[11];
      sum_650_s2_q <= {3'h0, not_640[10]} + sum_649;
      not_655_s2_q <= not_655[11];
      sum_665_s2_q <= {3'h0, not_655[10]} + sum_664;
      not_671_s2_q <= not_671[11];
      sum_681_s2_q <= {3'h0, not_671[10]} + sum_680;
      not_695_s2_q <= not_695[11];
      sum_705_s2_q <= {3'h0, not_695[10]} + sum_704;
      not_710_s2_q <= not_710[11];
      sum_720_s2_q <= {3'h0, not_710[10]} + sum_719;
      and_725_s2_q <= and_556 & (right_codes_rdata_q[90] & not_365_s1_q);
      not_728_s2_q <= not_728[11];
      sum_738_s2_q <= {3'h0, not_728[10]} + sum_737;
      and_754_s2_q <= and_517 & (right_codes_rdata_q[12] & not_365_s1_q);
      not_757_s2_q <= not_757[11];
      sum_767_s2_q <= {3'h0, not_757[10]} + sum_766;
      not_772_s2_q <= not_772[11];
      sum_782_s2_q <= {3'h0, not_772[10]} + sum_781;
      not_788_s2_q <= not_788[11];
      sum_798_s2_q <= {3'h0, not_788[10]} + sum_797;
      equal_815_s2_q <= equal_815_s1_q;
      and_873_s2_q <= equal_361_s1_q & and_505_s1_q;
      equal_879_s2_q <= equal_879_s1_q;
      equal_902_s2_q <= equal_902_s1_q;
      equal_905_s2_q <= equal_905_s1_q;
      and_916_s2_q <= left_rdata_q[61] & (left_rdata_q[62] & not_914);
      and_947_s2_q <= not_362_s1_q & and_507;
      and_956_s2_q <= and_956_s1_q;
      and_1054_s2_q <= not_362_s1_q & (not_506 & and_1052);
      equal_1431_s2_q <= (select_304_s1_q | row_s1_q) == 6'h0;
      equal_1518_s2_q <= equal_1518_s1_q;
      not_1582_s2_q <= not_1582_s1_q;
      and_1706_s2_q <= left_rdata_q[61] & not_914;
      less_1789_s2_q <= 5'h4 < row_q[5:1];
      less_1792_s2_q <= less_1792_s1_q;
      equal_2054_s2_q <= row_s1_q[5:2] == 4'h0;
      less_2071_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2246_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_columns_values_0_q;
  logic [7:0] sums_0_columns_values_1_q;
  logic [7:0] sums_0_columns_values_2_q;
  logic [7:0] sums_0_columns_values_3_q;
  logic [7:0] sums_0_columns_values_4_q;
  logic [7:0] sums_0_columns_values_5_q;
  logic [7:0] sums_0_columns_values_6_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_1_columns_values_0_q;
  logic [7:0] sums_1_columns_values_1_q;
  logic [7:0] sums_1_columns_values_2_q;
  logic [7:0] sums_1_columns_values_3_q;
  logic [7:0] sums_1_columns_values_4_q;
  logic [7:0] sums_1_columns_values_5_q;
  logic [7:0] sums_1_columns_values_6_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_2_columns_values_0_q;
  logic [7:0] sums_2_columns_values_1_q;
  logic [7:0] sums_2_columns_values_2_q;
  logic [7:0] sums_2_columns_values_3_q;
  logic [7:0] sums_2_columns_values_4_q;
  logic [7:0] sums_2_columns_values_5_q;
  logic [7:0] sums_2_columns_values_6_q;
  logic [7:0] sums_2_sum_sums_values_0_q;
  logic [7:0] sums_3_columns_values_0_q;
  logic [7:0] sums_3_columns_values_1_q;
  logic [7:0] sums_3_columns_values_2_q;
  logic [7:0] sums_3_columns_values_3_q;
  logic [7:0] sums_3_columns_values_4_q;
  logic [7:0] sums_3_columns_values_5_q;
  logic [7:0] sums_3_columns_values_6_q;
  logic [7:0] sums_3_sum_sums_values_0_q;
  logic [7:0] sums_4_columns_values_0_q;
  logic [7:0] sums_4_columns_values_1_q;
  logic [7:0] sums_4_columns_values_2_q;
  logic [7:0] sums_4_columns_values_3_q;
  logic [7:0] sums_4_columns_values_4_q;
  logic [7:0] sums_4_columns_values_5_q;
  logic [7:0] sums_4_columns_values_6_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [23:0] registration_next_slope_row_q;
  logic [27:0] registration_next_slope_change_q;
  // hls/stages/census.hpp:98
  logic and_318;
  assign and_318 = and_310_s2_q & and_317_s2_q;
  // hls/stages/agreement.hpp:179
  logic select_320;
  assign select_320 = and_310_s2_q ? (left_first_s2_q ? and_317_s2_q : and_318) : and_318;
  // hls/stages/agreement.hpp:240
  logic and_344;
  assign and_344 = and_310_s2_q & and_343_s2_q;
  // hls/stages/agreement.hpp:179
  logic select_346;
  assign select_346 = and_310_s2_q ? (left_first_s2_q ? and_343_s2_q : and_344) : and_344;
  // hls/stages/agreement.hpp:377
  logic [3:0] column;
  assign column = (and_517_s2_q & and_518_s2_q) ? ({3'h0, not_523_s2_q} + sum_533_s2_q) : 4'h0;
  logic [3:0] select_554;
  assign select_554 = (and_536_s2_q & and_537_s2_q) ? ({3'h0, not_542_s2_q} + sum_552_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_2;
  assign column_2 = {1'b0, column} + {1'b0, select_554};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_574;
  assign select_574 = (and_556_s2_q & and_557_s2_q) ? ({3'h0, not_562_s2_q} + sum_572_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_574};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_577;
  assign difference_577 = {2'h0, column_3} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_580;
  assign sum_580 = difference_577 + (equal_578_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:377
  logic [3:0] column_4;
  assign column_4 = (and_517_s2_q & and_537_s2_q) ? ({3'h0, not_583_s2_q} + sum_593_s2_q) : 4'h0;
  logic [3:0] select_610;
  assign select_610 = (and_536_s2_q & and_557_s2_q) ? ({3'h0, not_598_s2_q} + sum_608_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4} + {1'b0, select_610};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_628;
  assign select_628 = (and_556_s2_q & and_612_s2_q) ? ({3'h0, not_616_s2_q} + sum_626_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_628};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_631;
  assign difference_631 = {2'h0, column_6} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_633;
  assign sum_633 = difference_631 + (equal_578_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic less_634;
  assign less_634 = sum_580 < sum_633;
  // hls/stages/agreement.hpp:377
  logic [3:0] column_7;
  assign column_7 = (and_517_s2_q & and_636_s2_q) ? ({3'h0, not_640_s2_q} + sum_650_s2_q) : 4'h0;
  logic [3:0] select_667;
  assign select_667 = (and_536_s2_q & and_518_s2_q) ? ({3'h0, not_655_s2_q} + sum_665_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7} + {1'b0, select_667};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_683;
  assign select_683 = (and_556_s2_q & and_537_s2_q) ? ({3'h0, not_671_s2_q} + sum_681_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_683};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_686;
  assign difference_686 = {2'h0, column_9} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_688;
  assign sum_688 = difference_686 + (equal_578_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic not_690;
  assign not_690 = ~less_634;
  logic [1:0] best;
  assign best = ((less_634 ? sum_633 : sum_580) < sum_688) ? 2'h3 : {not_690, less_634};
  // hls/stages/agreement.hpp:377
  logic [3:0] column_10;
  assign column_10 = (and_517_s2_q & and_557_s2_q) ? ({3'h0, not_695_s2_q} + sum_705_s2_q) : 4'h0;
  logic [3:0] select_722;
  assign select_722 = (and_536_s2_q & and_612_s2_q) ? ({3'h0, not_710_s2_q} + sum_720_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10} + {1'b0, select_722};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_740;
  assign select_740 = and_725_s2_q ? ({3'h0, not_728_s2_q} + sum_738_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_740};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_743;
  assign difference_743 = {2'h0, column_12} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_745;
  assign sum_745 = difference_743 + (equal_578_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:420
  logic [7:0] select_747;
  assign select_747 = best[1] ? (best[0] ? sum_688 : sum_580) : (best[0] ? sum_633 : sum_745);
  logic [1:0] best_2;
  assign best_2 = (select_747 < sum_745) ? 2'h0 : best;
  // hls/stages/agreement.hpp:377
  logic [3:0] column_13;
  assign column_13 = and_754_s2_q ? ({3'h0, not_757_s2_q} + sum_767_s2_q) : 4'h0;
  logic [3:0] select_784;
  assign select_784 = (and_536_s2_q & and_636_s2_q) ? ({3'h0, not_772_s2_q} + sum_782_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13} + {1'b0, select_784};
  // hls/stages/agreement.hpp:377
  logic [3:0] select_800;
  assign select_800 = (and_556_s2_q & and_518_s2_q) ? ({3'h0, not_788_s2_q} + sum_798_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:405
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_800};
  // hls/stages/agreement.hpp:407
  logic [7:0] difference_803;
  assign difference_803 = {2'h0, column_15} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_805;
  assign sum_805 = difference_803 + (equal_578_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:432
  logic [5:0] partner;
  assign partner = run_shift_s2_q + x_s2_2_q[5:0];
  // hls/stages/agreement.hpp:299
  logic [5:0] select_876;
  assign select_876 = equal_361_s2_q ? partner : (x_s2_q[5:0] + best_left_rdata_q[13:8]);
  logic [7:0] select_1662;
  assign select_1662 = equal_361_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1663;
  assign select_1663 = equal_361_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1664;
  assign select_1664 = equal_361_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1665;
  assign select_1665 = equal_361_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1666;
  assign select_1666 = equal_361_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1667;
  assign select_1667 = equal_361_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1670;
  assign select_1670 = equal_361_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1671;
  assign select_1671 = equal_361_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1672;
  assign select_1672 = equal_361_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1673;
  assign select_1673 = equal_361_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1674;
  assign select_1674 = equal_361_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1675;
  assign select_1675 = equal_361_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1678;
  assign select_1678 = equal_361_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1679;
  assign select_1679 = equal_361_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1680;
  assign select_1680 = equal_361_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1681;
  assign select_1681 = equal_361_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1682;
  assign select_1682 = equal_361_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1683;
  assign select_1683 = equal_361_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1686;
  assign select_1686 = equal_361_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1687;
  assign select_1687 = equal_361_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1688;
  assign select_1688 = equal_361_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1689;
  assign select_1689 = equal_361_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1690;
  assign select_1690 = equal_361_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1691;
  assign select_1691 = equal_361_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1694;
  assign select_1694 = equal_361_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1695;
  assign select_1695 = equal_361_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1696;
  assign select_1696 = equal_361_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1697;
  assign select_1697 = equal_361_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1698;
  assign select_1698 = equal_361_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1699;
  assign select_1699 = equal_361_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/registration.hpp:158
  logic [16:0] select_1797;
  assign select_1797 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [13:0] select_1799;
  assign select_1799 = ($signed(10'h0) < $signed(select_1797[16:7])) ? 14'h7f : select_1797[13:0];
  // hls/stages/registration.hpp:153
  logic [9:0] select_1800;
  assign select_1800 = best_left_rdata_q[12] ? select_1799[9:0] : 10'h0;
  logic [8:0] difference_1802;
  assign difference_1802 = select_1800[9:1] - (best_left_rdata_q[13] ? select_1799[8:0] : 9'h0);
  // hls/stages/registration.hpp:151
  logic [12:0] sum_1805;
  assign sum_1805 = (best_left_rdata_q[8] ? select_1799[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1799[12:0] : 13'h0);
  // hls/stages/registration.hpp:152
  logic [11:0] select_1806;
  assign select_1806 = best_left_rdata_q[10] ? select_1799[11:0] : 12'h0;
  logic [10:0] sum_1808;
  assign sum_1808 = select_1806[11:1] + (best_left_rdata_q[11] ? select_1799[10:0] : 11'h0);
  // hls/stages/registration.hpp:154
  logic [11:0] sum_1809;
  assign sum_1809 = sum_1805[12:1] + {sum_1808, select_1806[0]};
  logic [9:0] sum_1810;
  assign sum_1810 = {difference_1802, select_1800[0]} + sum_1809[11:2];
  // hls/stages/registration.hpp:67
  logic [12:0] sum_1811;
  assign sum_1811 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_1810[9]}}, sum_1810[9:2]};
  // hls/stages/registration.hpp:151
  logic [7:0] select_1814;
  assign select_1814 = ($signed(sum_1811[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1811[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1811[12:7])) ? 8'h7f : select_1814;
  logic [6:0] select_1816;
  assign select_1816 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1817;
  assign select_1817 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1818;
  assign sum_1818 = {{2{select_1816[6]}}, select_1816} + {select_1817[7], select_1817};
  // hls/stages/registration.hpp:152
  logic [7:0] select_1819;
  assign select_1819 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1820;
  assign select_1820 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1821;
  assign sum_1821 = {{2{select_1819[7]}}, select_1819[7:1]} + {select_1820[7], select_1820};
  // hls/stages/registration.hpp:154
  logic [10:0] sum_1822;
  assign sum_1822 = {{3{sum_1818[8]}}, sum_1818[8:1]} + {sum_1821[8], sum_1821, select_1819[0]};
  // hls/stages/registration.hpp:153
  logic [7:0] select_1823;
  assign select_1823 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1824;
  assign select_1824 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1825;
  assign difference_1825 = {{2{select_1823[7]}}, select_1823[7:1]} - {select_1824[7], select_1824};
  // hls/stages/registration.hpp:57
  logic [23:0] select_2055;
  assign select_2055 = equal_2054_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : registration_next_slope_row_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_2057;
  assign select_2057 = and_343_s2_q ? (equal_1518_s2_q ? select_2055 : registration_slope_row_q) : registration_slope_row_q;
  // hls/stages/agreement.hpp:179
  logic [23:0] select_2059;
  assign select_2059 = left_first_s2_q ? select_2057 : (and_310_s2_q ? select_2057 : registration_slope_row_q);
  // hls/stages/registration.hpp:58
  logic [27:0] select_2061;
  assign select_2061 = equal_2054_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : registration_next_slope_change_q;
  // hls/stages/agreement.hpp:176
  logic [27:0] select_2063;
  assign select_2063 = and_343_s2_q ? (equal_1518_s2_q ? select_2061 : registration_slope_change_q) : registration_slope_change_q;
  // hls/stages/agreement.hpp:179
  logic [27:0] select_2065;
  assign select_2065 = left_first_s2_q ? select_2063 : (and_310_s2_q ? select_2063 : registration_slope_change_q);
  // hls/stages/registration.hpp:48
  logic [27:0] select_2068;
  assign select_2068 = drew_s2_q ? (registration_slope_change_q + registration_slope_q) : {registration_slope_row_q, 4'h0};
  // hls/stages/registration.hpp:50
  logic [23:0] sum_2069;
  assign sum_2069 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + registration_slope_row_q;
  // hls/stages/registration.hpp:51
  logic [27:0] sum_2070;
  assign sum_2070 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + registration_slope_change_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:146; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_308_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & select_320;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = select_304_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & select_346;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 47 x 15, DISTANCE 12, hls/stages/agreement.hpp:769; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 15'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = select_876;
  logic best_right_re;
  assign best_right_re = s2_en & select_508_s2_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory seen_columns, 47 x 12, DISTANCE 12, hls/stages/agreement.hpp:797; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_947_s2_q;
  logic [11:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      registration_next_slope_row_q <= 24'h0;
      registration_next_slope_change_q <= 28'h0;
    end else if (s2_en) begin
      registration_slope_row_q <= and_310_s2_q ? select_2059 : registration_slope_row_q;
      registration_slope_change_q <= and_310_s2_q ? select_2065 : registration_slope_change_q;
      registration_slope_q <= select_2068;
      registration_next_slope_row_q <= sum_2069;
      registration_next_slope_change_q <= sum_2070;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_columns_values_0_q = 8'h0;
    sums_0_columns_values_1_q = 8'h0;
    sums_0_columns_values_2_q = 8'h0;
    sums_0_columns_values_3_q = 8'h0;
    sums_0_columns_values_4_q = 8'h0;
    sums_0_columns_values_5_q = 8'h0;
    sums_0_columns_values_6_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_1_columns_values_0_q = 8'h0;
    sums_1_columns_values_1_q = 8'h0;
    sums_1_columns_values_2_q = 8'h0;
    sums_1_columns_values_3_q = 8'h0;
    sums_1_columns_values_4_q = 8'h0;
    sums_1_columns_values_5_q = 8'h0;
    sums_1_columns_values_6_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_2_columns_values_0_q = 8'h0;
    sums_2_columns_values_1_q = 8'h0;
    sums_2_columns_values_2_q = 8'h0;
    sums_2_columns_values_3_q = 8'h0;
    sums_2_columns_values_4_q = 8'h0;
    sums_2_columns_values_5_q = 8'h0;
    sums_2_columns_values_6_q = 8'h0;
    sums_2_sum_sums_values_0_q = 8'h0;
    sums_3_columns_values_0_q = 8'h0;
    sums_3_columns_values_1_q = 8'h0;
    sums_3_columns_values_2_q = 8'h0;
    sums_3_columns_values_3_q = 8'h0;
    sums_3_columns_values_4_q = 8'h0;
    sums_3_columns_values_5_q = 8'h0;
    sums_3_columns_values_6_q = 8'h0;
    sums_3_sum_sums_values_0_q = 8'h0;
    sums_4_columns_values_0_q = 8'h0;
    sums_4_columns_values_1_q = 8'h0;
    sums_4_columns_values_2_q = 8'h0;
    sums_4_columns_values_3_q = 8'h0;
    sums_4_columns_values_4_q = 8'h0;
    sums_4_columns_values_5_q = 8'h0;
    sums_4_columns_values_6_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      sums_0_columns_values_0_q <= equal_361_s2_q ? {2'h0, column_12} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1662;
      sums_0_columns_values_2_q <= select_1663;
      sums_0_columns_values_3_q <= select_1664;
      sums_0_columns_values_4_q <= select_1665;
      sums_0_columns_values_5_q <= select_1666;
      sums_0_columns_values_6_q <= select_1667;
      sums_0_sum_sums_values_0_q <= equal_361_s2_q ? sum_745 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_361_s2_q ? {2'h0, column_6} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1670;
      sums_1_columns_values_2_q <= select_1671;
      sums_1_columns_values_3_q <= select_1672;
      sums_1_columns_values_4_q <= select_1673;
      sums_1_columns_values_5_q <= select_1674;
      sums_1_columns_values_6_q <= select_1675;
      sums_1_sum_sums_values_0_q <= equal_361_s2_q ? sum_633 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_361_s2_q ? {2'h0, column_3} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1678;
      sums_2_columns_values_2_q <= select_1679;
      sums_2_columns_values_3_q <= select_1680;
      sums_2_columns_values_4_q <= select_1681;
      sums_2_columns_values_5_q <= select_1682;
      sums_2_columns_values_6_q <= select_1683;
      sums_2_sum_sums_values_0_q <= equal_361_s2_q ? sum_580 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_361_s2_q ? {2'h0, column_9} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1686;
      sums_3_columns_values_2_q <= select_1687;
      sums_3_columns_values_3_q <= select_1688;
      sums_3_columns_values_4_q <= select_1689;
      sums_3_columns_values_5_q <= select_1690;
      sums_3_columns_values_6_q <= select_1691;
      sums_3_sum_sums_values_0_q <= equal_361_s2_q ? sum_688 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_361_s2_q ? {2'h0, column_15} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1694;
      sums_4_columns_values_2_q <= select_1695;
      sums_4_columns_values_3_q <= select_1696;
      sums_4_columns_values_4_q <= select_1697;
      sums_4_columns_values_5_q <= select_1698;
      sums_4_columns_values_6_q <= select_1699;
      sums_4_sum_sums_values_0_q <= equal_361_s2_q ? sum_805 : sums_4_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic lower_half_s3_q;
  logic select_302_s3_q;
  logic [5:0] select_304_s3_q;
  logic [7:0] select_308_s3_q;
  logic and_310_s3_q;
  logic and_317_s3_q;
  logic select_320_s3_q;
  logic equal_325_s3_q;
  logic whole_s3_q;
  logic and_342_s3_q;
  logic and_343_s3_q;
  logic select_346_s3_q;
  logic equal_349_s3_q;
  logic equal_361_s3_q;
  logic not_362_s3_q;
  logic equal_363_s3_q;
  logic less_364_s3_q;
  logic not_365_s3_q;
  logic equal_395_s3_q;
  logic drew_s3_q;
  logic left_rdata_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_506_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_511_s3_q;
  logic [7:0] sum_580_s3_q;
  logic [7:0] sum_633_s3_q;
  logic [7:0] sum_688_s3_q;
  logic [7:0] sum_745_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_805_s3_q;
  logic equal_815_s3_q;
  logic and_873_s3_q;
  logic [5:0] partner_s3_q;
  logic equal_879_s3_q;
  logic equal_902_s3_q;
  logic equal_905_s3_q;
  logic and_916_s3_q;
  logic and_947_s3_q;
  logic and_956_s3_q;
  logic and_1054_s3_q;
  logic equal_1431_s3_q;
  logic equal_1518_s3_q;
  logic not_1582_s3_q;
  logic and_1706_s3_q;
  logic less_1789_s3_q;
  logic less_1792_s3_q;
  logic [9:0] sum_1822_s3_q;
  logic select_1823_s3_q;
  logic [8:0] difference_1825_s3_q;
  logic less_2071_s3_q;
  logic equal_2246_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[0];
      lower_half_s3_q <= lower_half_s2_q;
      select_302_s3_q <= select_302_s2_q;
      select_304_s3_q <= select_304_s2_q;
      select_308_s3_q <= select_308_s2_q;
      and_310_s3_q <= and_310_s2_q;
      and_317_s3_q <= and_317_s2_q;
      select_320_s3_q <= select_320;
      equal_325_s3_q <= equal_325_s2_q;
      whole_s3_q <= whole_s2_q;
      and_342_s3_q <= and_342_s2_q;
      and_343_s3_q <= and_343_s2_q;
      select_346_s3_q <= select_346;
      equal_349_s3_q <= equal_349_s2_q;
      equal_361_s3_q <= equal_361_s2_q;
      not_362_s3_q <= not_362_s2_q;
      equal_363_s3_q <= equal_363_s2_q;
      less_364_s3_q <= less_364_s2_q;
      not_365_s3_q <= not_365_s2_q;
      equal_395_s3_q <= equal_395_s2_q;
      drew_s3_q <= drew_s2_q;
      left_rdata_s3_q <= left_rdata_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_506_s3_q <= not_506_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_511_s3_q <= equal_511_s2_q;
      sum_580_s3_q <= sum_580;
      sum_633_s3_q <= sum_633;
      sum_688_s3_q <= sum_688;
      sum_745_s3_q <= sum_745;
      best_2_s3_q <= best_2;
      sum_805_s3_q <= sum_805;
      equal_815_s3_q <= equal_815_s2_q;
      and_873_s3_q <= and_873_s2_q;
      partner_s3_q <= partner;
      equal_879_s3_q <= equal_879_s2_q;
      equal_902_s3_q <= equal_902_s2_q;
      equal_905_s3_q <= equal_905_s2_q;
      and_916_s3_q <= and_916_s2_q;
      and_947_s3_q <= and_947_s2_q;
      and_956_s3_q <= and_956_s2_q;
      and_1054_s3_q <= and_1054_s2_q;
      equal_1431_s3_q <= equal_1431_s2_q;
      equal_1518_s3_q <= equal_1518_s2_q;
      not_1582_s3_q <= not_1582_s2_q;
      and_1706_s3_q <= and_1706_s2_q;
      less_1789_s3_q <= less_1789_s2_q;
      less_1792_s3_q <= less_1792_s2_q;
      sum_1822_s3_q <= sum_1822[10:1];
      select_1823_s3_q <= select_1823[0];
      difference_1825_s3_q <= difference_1825;
      less_2071_s3_q <= less_2071_s2_q;
      equal_2246_s3_q <= equal_2246_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
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
  logic [23:0] counts_too_little_explained_q;
  logic [23:0] counts_too_much_hidden_q;
  logic [11:0] registration_counts_measured_0_q;
  logic [11:0] registration_counts_measured_1_q;
  logic [11:0] registration_counts_measured_2_q;
  logic [11:0] registration_counts_measured_3_q;
  logic [14:0] registration_counts_votes_0_down_q;
  logic [14:0] registration_counts_votes_0_up_q;
  logic [14:0] registration_counts_votes_1_down_q;
  logic [14:0] registration_counts_votes_1_up_q;
  logic [14:0] registration_counts_votes_2_down_q;
  logic [14:0] registration_counts_votes_2_up_q;
  logic [14:0] registration_counts_votes_3_down_q;
  logic [14:0] registration_counts_votes_3_up_q;
  logic [14:0] registration_counts_votes_4_down_q;
  logic [14:0] registration_counts_votes_4_up_q;
  logic [14:0] registration_counts_half_votes_0_down_q;
  logic [14:0] registration_counts_half_votes_0_up_q;
  logic [14:0] registration_counts_half_votes_1_down_q;
  logic [14:0] registration_counts_half_votes_1_up_q;
  logic [14:0] registration_counts_half_votes_2_down_q;
  logic [14:0] registration_counts_half_votes_2_up_q;
  logic [14:0] registration_counts_half_votes_3_down_q;
  logic [14:0] registration_counts_half_votes_3_up_q;
  logic [2:0] region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [7:0] hidden_for_q;
  logic [7:0] next_hidden_for_q;
  logic [2:0] next_region_row_q;
  logic begins_product_q;
  logic centres_values_0_q;
  logic centres_values_1_q;
  logic [10:0] map_row_q;
  logic [5:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic said_q;
  logic began_q;
  logic [2:0] seen_x_q;
  logic [2:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [10:0] seen_base_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_323;
  assign select_323 = select_302_s3_q ? ({4'h0, left_pixel_q} + averager_running_0_q) : {4'h0, left_pixel_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_327;
  assign sum_327 = select_323 + (equal_325_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_329;
  assign sum_329 = {4'h0, pixel_0_s3_q} + (select_302_s3_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_331;
  assign sum_331 = sum_329 + (equal_325_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/census.hpp:101
  logic and_335;
  assign and_335 = whole_s3_q & (averager_memory_rdata_q[24] | equal_325_s3_q);
  // hls/stages/agreement.hpp:174
  logic all_of_skin;
  assign all_of_skin = select_302_s3_q ? (mask_s3_q & averager_running_of_skin_q) : mask_s3_q;
  // hls/stages/census.hpp:102
  logic and_339;
  assign and_339 = all_of_skin & (averager_memory_rdata_q[25] | equal_325_s3_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_317_s3_q ? sum_327[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_349_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey_2;
  assign grey_2 = and_317_s3_q ? sum_331[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_349_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:126
  logic and_355;
  assign and_355 = and_317_s3_q & and_335;
  // hls/stages/census.hpp:105
  logic whole_2;
  assign whole_2 = equal_349_s3_q ? and_355 : (averager_mask_q & and_355);
  // hls/stages/census.hpp:126
  logic and_358;
  assign and_358 = and_317_s3_q & and_339;
  // hls/stages/census.hpp:105
  logic select_360;
  assign select_360 = equal_349_s3_q ? and_358 : (averager_of_skin_q & and_358);
  // hls/stages/census.hpp:214
  logic less_369;
  assign less_369 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_370;
  assign less_370 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_371;
  assign less_371 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_372;
  assign less_372 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_373;
  assign less_373 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_374;
  assign less_374 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_375;
  assign less_375 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_376;
  assign less_376 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_377;
  assign less_377 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_378;
  assign less_378 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_379;
  assign less_379 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_380;
  assign less_380 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_381;
  assign less_381 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_382;
  assign less_382 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_383;
  assign less_383 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_384;
  assign less_384 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_385;
  assign less_385 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_386;
  assign less_386 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_387;
  assign less_387 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_388;
  assign less_388 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_389;
  assign less_389 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_390;
  assign less_390 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_391;
  assign less_391 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_392;
  assign less_392 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:241
  logic equal_393;
  assign equal_393 = select_304_s3_q == 6'h0;
  logic [3:0] select_396;
  assign select_396 = equal_395_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:242
  logic [4:0] select_397;
  assign select_397 = equal_393 ? {select_396, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_398;
  assign select_398 = equal_393 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:219
  logic and_399;
  assign and_399 = select_397[4] & select_398[3];
  // hls/stages/census.hpp:206
  logic and_401;
  assign and_401 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_403;
  assign and_403 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_401);
  // hls/stages/agreement.hpp:242
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_403;
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
  logic [9:0] difference_426;
  assign difference_426 = {1'b0, total[10:2]} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_427;
  assign xor_427 = difference_426[8:0] ^ {9{difference_426[9]}};
  logic [9:0] sum_428;
  assign sum_428 = {9'h0, difference_426[9]} + {1'b0, xor_427};
  logic [9:0] difference_429;
  assign difference_429 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_430;
  assign xor_430 = difference_429[8:0] ^ {9{difference_429[9]}};
  logic [9:0] sum_431;
  assign sum_431 = {9'h0, difference_429[9]} + {1'b0, xor_430};
  logic [9:0] difference_433;
  assign difference_433 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_434;
  assign xor_434 = difference_433[8:0] ^ {9{difference_433[9]}};
  logic [9:0] sum_435;
  assign sum_435 = {9'h0, difference_433[9]} + {1'b0, xor_434};
  logic [10:0] sum_436;
  assign sum_436 = ({1'b0, sum_428} + {1'b0, sum_431}) + {1'b0, sum_435};
  logic [9:0] difference_437;
  assign difference_437 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_438;
  assign xor_438 = difference_437[8:0] ^ {9{difference_437[9]}};
  logic [9:0] sum_439;
  assign sum_439 = {9'h0, difference_437[9]} + {1'b0, xor_438};
  logic [9:0] difference_441;
  assign difference_441 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_442;
  assign xor_442 = difference_441[8:0] ^ {9{difference_441[9]}};
  logic [9:0] sum_443;
  assign sum_443 = {9'h0, difference_441[9]} + {1'b0, xor_442};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_436} + {2'h0, sum_439}) + {2'h0, sum_443};
  // hls/stages/agreement.hpp:412
  logic not_513;
  assign not_513 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_514;
  assign less_514 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:420
  logic [7:0] select_752;
  assign select_752 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_688_s3_q : sum_580_s3_q) : (best_2_s3_q[0] ? sum_633_s3_q : sum_745_s3_q);
  logic less_806;
  assign less_806 = select_752 < sum_805_s3_q;
  logic [1:0] select_807;
  assign select_807 = less_806 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_810;
  assign select_810 = select_807[1] ? (select_807[0] ? sum_688_s3_q : sum_580_s3_q) : (select_807[0] ? sum_633_s3_q : sum_745_s3_q);
  logic [7:0] of_best;
  assign of_best = less_806 ? sum_805_s3_q : select_810;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_513 & (~less_514)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:424
  logic less_813;
  assign less_813 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:427
  logic less_814;
  assign less_814 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_816;
  assign or_816 = less_814 | equal_815_s3_q;
  // hls/stages/agreement.hpp:430
  logic [7:0] select_819;
  assign select_819 = less_813 ? (or_816 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_814 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_823;
  assign select_823 = less_813 ? (or_816 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_814 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/registration.hpp:21
  logic [2:0] near_best;
  assign near_best = ({less_806, select_807} == 3'h4) ? 3'h3 : (({less_806, select_807} == 3'h0) ? 3'h1 : {less_806, select_807});
  // hls/stages/registration.hpp:23
  logic [2:0] sum_830;
  assign sum_830 = near_best + 3'h1;
  logic [7:0] select_833;
  assign select_833 = sum_830[1] ? (sum_830[0] ? sum_688_s3_q : sum_580_s3_q) : (sum_830[0] ? sum_633_s3_q : sum_745_s3_q);
  logic [7:0] below;
  assign below = sum_830[2] ? sum_805_s3_q : select_833;
  // hls/stages/registration.hpp:22
  logic [2:0] sum_835;
  assign sum_835 = near_best + 3'h7;
  logic [7:0] select_838;
  assign select_838 = sum_835[1] ? (sum_835[0] ? sum_688_s3_q : sum_580_s3_q) : (sum_835[0] ? sum_633_s3_q : sum_745_s3_q);
  logic [7:0] above;
  assign above = sum_835[2] ? sum_805_s3_q : select_838;
  // hls/stages/registration.hpp:24
  logic [8:0] rise;
  assign rise = {1'b0, below} - {1'b0, above};
  // hls/stages/registration.hpp:26
  logic [7:0] select_844;
  assign select_844 = near_best[1] ? (near_best[0] ? sum_688_s3_q : sum_580_s3_q) : (near_best[0] ? sum_633_s3_q : sum_745_s3_q);
  logic [7:0] select_845;
  assign select_845 = near_best[2] ? sum_805_s3_q : select_844;
  logic [7:0] select_846;
  assign select_846 = rise[8] ? below : above;
  logic [8:0] fall;
  assign fall = {1'b0, select_845} - {1'b0, select_846};
  // hls/stages/registration.hpp:27
  logic [7:0] twice;
  assign twice = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:25
  logic [7:0] xor_849;
  assign xor_849 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_849};
  // hls/stages/agreement.hpp:434
  logic less_878;
  assign less_878 = best_right_rdata_q[7:0] < of_best_2;
  logic or_880;
  assign or_880 = less_878 | equal_879_s3_q;
  // hls/stages/agreement.hpp:435
  logic [7:0] select_883;
  assign select_883 = less_813 ? (or_880 ? of_best_2 : best_right_rdata_q[7:0]) : (less_878 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_884;
  assign select_884 = equal_511_s3_q ? of_best_2 : select_883;
  logic [6:0] select_887;
  assign select_887 = less_813 ? (or_880 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_878 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_888;
  assign select_888 = equal_511_s3_q ? x_s3_2_q : select_887;
  // hls/stages/agreement.hpp:140
  logic [7:0] select_889;
  assign select_889 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:538
  logic or_892;
  assign or_892 = select_889[7] | (~({select_889[5], select_889[3], select_889[1]} == 3'h0));
  // hls/stages/agreement.hpp:537
  logic or_895;
  assign or_895 = select_889[7] | (~({select_889[6], select_889[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:536
  logic or_898;
  assign or_898 = select_889[7] | (~(select_889[6:4] == 3'h0));
  // hls/stages/division.hpp:18
  logic [5:0] sum_900;
  assign sum_900 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:546
  logic or_903;
  assign or_903 = (~sum_900[5]) | equal_902_s3_q;
  // hls/stages/agreement.hpp:516
  logic and_904;
  assign and_904 = not_365_s3_q & or_903;
  // hls/stages/agreement.hpp:606
  logic equal_906;
  assign equal_906 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:299
  logic and_908;
  assign and_908 = equal_905_s3_q & (~equal_906);
  // hls/stages/agreement.hpp:165
  logic textured;
  assign textured = not_365_s3_q & and_916_s3_q;
  // hls/stages/agreement.hpp:505
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:507
  logic [9:0] sum_925;
  assign sum_925 = {way[8], way} + 10'h1;
  logic and_927;
  assign and_927 = (and_916_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_925[9]}}, sum_925} < 16'h3);
  // hls/stages/agreement.hpp:165
  logic explained;
  assign explained = not_365_s3_q & and_927;
  // hls/stages/agreement.hpp:509
  logic and_935;
  assign and_935 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:165
  logic and_937;
  assign and_937 = and_927 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_935);
  logic near;
  assign near = not_365_s3_q & and_937;
  // hls/stages/agreement.hpp:694
  logic select_950;
  assign select_950 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:698
  logic select_951;
  assign select_951 = left_first_s3_q ? select_950 : read_half_q;
  // hls/stages/agreement.hpp:176
  logic next_row;
  assign next_row = and_956_s3_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:714
  logic [5:0] select_959;
  assign select_959 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_961;
  assign select_961 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_959});
  // hls/stages/agreement.hpp:724
  logic equal_962;
  assign equal_962 = seen_x_q == 3'h7;
  logic [7:0] select_964;
  assign select_964 = and_956_s3_q ? 8'h0 : (seen_column_q + {7'h0, equal_962});
  // hls/stages/agreement.hpp:727
  logic [10:0] index;
  assign index = select_961 + {3'h0, select_964};
  // hls/stages/agreement.hpp:684
  logic [11:0] sum_966;
  assign sum_966 = {1'b0, {2{select_951}}, 2'h0, {2{select_951}}, 1'b0, {2{select_951}}, 1'b0, select_951} + {1'b0, index};
  // hls/stages/census.hpp:31
  logic not_967;
  assign not_967 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:176
  logic and_969;
  assign and_969 = not_967 & (began_q | and_956_s3_q);
  // hls/stages/agreement.hpp:725
  logic [2:0] select_971;
  assign select_971 = and_956_s3_q ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:726
  logic and_973;
  assign and_973 = and_969 & (select_971 == 3'h0);
  logic less_974;
  assign less_974 = select_964 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:179
  logic and_975;
  assign and_975 = and_973 & less_974;
  logic and_976;
  assign and_976 = and_310_s3_q & and_975;
  // hls/stages/agreement.hpp:589
  logic [7:0] sum_980;
  assign sum_980 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_980[7], sum_980, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:684
  logic [11:0] sum_982;
  assign sum_982 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:516
  logic [3:0] select_983;
  assign select_983 = less_364_s3_q ? 4'h0 : seen_columns_rdata_q[11:8];
  logic and_984;
  assign and_984 = seen_columns_rdata_q[6] & not_365_s3_q;
  logic and_985;
  assign and_985 = seen_columns_rdata_q[3] & not_365_s3_q;
  logic and_986;
  assign and_986 = seen_columns_rdata_q[0] & not_365_s3_q;
  // hls/stages/agreement.hpp:569
  logic [1:0] sum_988;
  assign sum_988 = {1'b0, and_985} + ({1'b0, textured} + {1'b0, and_986});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_983[1]} + ({2'h0, and_984} + {1'b0, sum_988});
  // hls/stages/agreement.hpp:516
  logic [7:0] select_998;
  assign select_998 = less_364_s3_q ? select_889 : (sum_900[5] ? select_889 : {select_889[6:0], 1'b0});
  // hls/stages/agreement.hpp:538
  logic or_1001;
  assign or_1001 = select_998[7] | (~({select_998[5], select_998[3], select_998[1]} == 3'h0));
  // hls/stages/agreement.hpp:516
  logic and_1017;
  assign and_1017 = seen_columns_rdata_q[7] & not_365_s3_q;
  logic and_1018;
  assign and_1018 = seen_columns_rdata_q[4] & not_365_s3_q;
  logic and_1019;
  assign and_1019 = seen_columns_rdata_q[1] & not_365_s3_q;
  // hls/stages/agreement.hpp:570
  logic [1:0] sum_1021;
  assign sum_1021 = {1'b0, and_1018} + ({1'b0, explained} + {1'b0, and_1019});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_983[2]} + ({2'h0, and_1017} + {1'b0, sum_1021});
  // hls/stages/agreement.hpp:516
  logic and_1032;
  assign and_1032 = seen_columns_rdata_q[5] & not_365_s3_q;
  logic and_1033;
  assign and_1033 = seen_columns_rdata_q[2] & not_365_s3_q;
  // hls/stages/agreement.hpp:571
  logic [1:0] sum_1035;
  assign sum_1035 = {1'b0, and_1032} + ({1'b0, near} + {1'b0, and_1033});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_983[3]} + ({2'h0, select_983[0]} + {1'b0, sum_1035});
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1097;
  assign select_1097 = left_first_s3_q ? select_323 : (and_310_s3_q ? select_323 : averager_running_0_q);
  logic [11:0] select_1100;
  assign select_1100 = left_first_s3_q ? sum_329 : (and_310_s3_q ? sum_329 : averager_running_1_q);
  // hls/stages/census.hpp:133
  logic [10:0] select_1118;
  assign select_1118 = and_342_s3_q ? total : averager_total_0_q;
  // hls/stages/agreement.hpp:179
  logic [10:0] select_1120;
  assign select_1120 = left_first_s3_q ? select_1118 : (and_310_s3_q ? select_1118 : averager_total_0_q);
  // hls/stages/census.hpp:133
  logic [10:0] select_1122;
  assign select_1122 = and_342_s3_q ? total_2 : averager_total_1_q;
  // hls/stages/agreement.hpp:179
  logic [10:0] select_1124;
  assign select_1124 = left_first_s3_q ? select_1122 : (and_310_s3_q ? select_1122 : averager_total_1_q);
  logic select_1153;
  assign select_1153 = left_first_s3_q ? all_of_skin : (and_310_s3_q ? all_of_skin : averager_running_of_skin_q);
  // hls/stages/census.hpp:141
  logic select_1155;
  assign select_1155 = and_342_s3_q ? whole_2 : averager_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1157;
  assign select_1157 = left_first_s3_q ? select_1155 : (and_310_s3_q ? select_1155 : averager_mask_q);
  // hls/stages/census.hpp:141
  logic select_1159;
  assign select_1159 = and_342_s3_q ? select_360 : averager_of_skin_q;
  // hls/stages/agreement.hpp:179
  logic select_1161;
  assign select_1161 = left_first_s3_q ? select_1159 : (and_310_s3_q ? select_1159 : averager_of_skin_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1163;
  assign select_1163 = and_343_s3_q ? total[10:2] : census_columns_values_0_cell_0_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1164;
  assign select_1164 = and_310_s3_q ? select_1163 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1166;
  assign select_1166 = and_310_s3_q ? (left_first_s3_q ? select_1163 : select_1164) : census_columns_values_0_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1167;
  assign select_1167 = and_343_s3_q ? total_2[10:2] : census_columns_values_0_cell_0_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1168;
  assign select_1168 = and_310_s3_q ? select_1167 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1170;
  assign select_1170 = and_310_s3_q ? (left_first_s3_q ? select_1167 : select_1168) : census_columns_values_0_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1171;
  assign select_1171 = and_343_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1172;
  assign select_1172 = and_310_s3_q ? select_1171 : census_columns_values_0_cell_0_mask_q;
  logic select_1174;
  assign select_1174 = and_310_s3_q ? (left_first_s3_q ? select_1171 : select_1172) : census_columns_values_0_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1175;
  assign select_1175 = and_343_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1176;
  assign select_1176 = and_310_s3_q ? select_1175 : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1178;
  assign select_1178 = and_310_s3_q ? (left_first_s3_q ? select_1175 : select_1176) : census_columns_values_0_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1179;
  assign select_1179 = and_343_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1180;
  assign select_1180 = and_310_s3_q ? select_1179 : census_columns_values_0_cell_1_right_q;
  logic [8:0] select_1182;
  assign select_1182 = and_310_s3_q ? (left_first_s3_q ? select_1179 : select_1180) : census_columns_values_0_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1183;
  assign select_1183 = and_343_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1184;
  assign select_1184 = and_310_s3_q ? select_1183 : census_columns_values_0_cell_1_mask_q;
  logic select_1186;
  assign select_1186 = and_310_s3_q ? (left_first_s3_q ? select_1183 : select_1184) : census_columns_values_0_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1187;
  assign select_1187 = and_343_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1188;
  assign select_1188 = and_310_s3_q ? select_1187 : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1190;
  assign select_1190 = and_310_s3_q ? (left_first_s3_q ? select_1187 : select_1188) : census_columns_values_0_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1191;
  assign select_1191 = and_343_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1192;
  assign select_1192 = and_310_s3_q ? select_1191 : census_columns_values_0_cell_2_right_q;
  logic [8:0] select_1194;
  assign select_1194 = and_310_s3_q ? (left_first_s3_q ? select_1191 : select_1192) : census_columns_values_0_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1195;
  assign select_1195 = and_343_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1196;
  assign select_1196 = and_310_s3_q ? select_1195 : census_columns_values_0_cell_2_mask_q;
  logic select_1198;
  assign select_1198 = and_310_s3_q ? (left_first_s3_q ? select_1195 : select_1196) : census_columns_values_0_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1199;
  assign select_1199 = and_343_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  // hls/stages/agreement.hpp:179
  logic select_1200;
  assign select_1200 = and_310_s3_q ? select_1199 : census_columns_values_0_cell_2_of_skin_q;
  logic select_1202;
  assign select_1202 = and_310_s3_q ? (left_first_s3_q ? select_1199 : select_1200) : census_columns_values_0_cell_2_of_skin_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1203;
  assign select_1203 = and_343_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1204;
  assign select_1204 = and_310_s3_q ? select_1203 : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1206;
  assign select_1206 = and_310_s3_q ? (left_first_s3_q ? select_1203 : select_1204) : census_columns_values_0_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1207;
  assign select_1207 = and_343_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1208;
  assign select_1208 = and_310_s3_q ? select_1207 : census_columns_values_0_cell_3_right_q;
  logic [8:0] select_1210;
  assign select_1210 = and_310_s3_q ? (left_first_s3_q ? select_1207 : select_1208) : census_columns_values_0_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1211;
  assign select_1211 = and_343_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1212;
  assign select_1212 = and_310_s3_q ? select_1211 : census_columns_values_0_cell_3_mask_q;
  logic select_1214;
  assign select_1214 = and_310_s3_q ? (left_first_s3_q ? select_1211 : select_1212) : census_columns_values_0_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1215;
  assign select_1215 = and_343_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1216;
  assign select_1216 = and_310_s3_q ? select_1215 : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1218;
  assign select_1218 = and_310_s3_q ? (left_first_s3_q ? select_1215 : select_1216) : census_columns_values_0_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1219;
  assign select_1219 = and_343_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1220;
  assign select_1220 = and_310_s3_q ? select_1219 : census_columns_values_0_cell_4_right_q;
  logic [8:0] select_1222;
  assign select_1222 = and_310_s3_q ? (left_first_s3_q ? select_1219 : select_1220) : census_columns_values_0_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1223;
  assign select_1223 = and_343_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1224;
  assign select_1224 = and_310_s3_q ? select_1223 : census_columns_values_0_cell_4_mask_q;
  logic select_1226;
  assign select_1226 = and_310_s3_q ? (left_first_s3_q ? select_1223 : select_1224) : census_columns_values_0_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1227;
  assign select_1227 = and_343_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1228;
  assign select_1228 = and_310_s3_q ? select_1227 : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1230;
  assign select_1230 = and_310_s3_q ? (left_first_s3_q ? select_1227 : select_1228) : census_columns_values_1_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1231;
  assign select_1231 = and_343_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1232;
  assign select_1232 = and_310_s3_q ? select_1231 : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1234;
  assign select_1234 = and_310_s3_q ? (left_first_s3_q ? select_1231 : select_1232) : census_columns_values_1_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1235;
  assign select_1235 = and_343_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1236;
  assign select_1236 = and_310_s3_q ? select_1235 : census_columns_values_1_cell_0_mask_q;
  logic select_1238;
  assign select_1238 = and_310_s3_q ? (left_first_s3_q ? select_1235 : select_1236) : census_columns_values_1_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1239;
  assign select_1239 = and_343_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1240;
  assign select_1240 = and_310_s3_q ? select_1239 : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1242;
  assign select_1242 = and_310_s3_q ? (left_first_s3_q ? select_1239 : select_1240) : census_columns_values_1_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1243;
  assign select_1243 = and_343_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1244;
  assign select_1244 = and_310_s3_q ? select_1243 : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1246;
  assign select_1246 = and_310_s3_q ? (left_first_s3_q ? select_1243 : select_1244) : census_columns_values_1_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1247;
  assign select_1247 = and_343_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1248;
  assign select_1248 = and_310_s3_q ? select_1247 : census_columns_values_1_cell_1_mask_q;
  logic select_1250;
  assign select_1250 = and_310_s3_q ? (left_first_s3_q ? select_1247 : select_1248) : census_columns_values_1_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1251;
  assign select_1251 = and_343_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1252;
  assign select_1252 = and_310_s3_q ? select_1251 : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1254;
  assign select_1254 = and_310_s3_q ? (left_first_s3_q ? select_1251 : select_1252) : census_columns_values_1_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1255;
  assign select_1255 = and_343_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1256;
  assign select_1256 = and_310_s3_q ? select_1255 : census_columns_values_1_cell_2_right_q;
  logic [8:0] select_1258;
  assign select_1258 = and_310_s3_q ? (left_first_s3_q ? select_1255 : select_1256) : census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1259;
  assign select_1259 = and_343_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1260;
  assign select_1260 = and_310_s3_q ? select_1259 : census_columns_values_1_cell_2_mask_q;
  logic select_1262;
  assign select_1262 = and_310_s3_q ? (left_first_s3_q ? select_1259 : select_1260) : census_columns_values_1_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1263;
  assign select_1263 = and_343_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  // hls/stages/agreement.hpp:179
  logic select_1264;
  assign select_1264 = and_310_s3_q ? select_1263 : census_columns_values_1_cell_2_of_skin_q;
  logic select_1266;
  assign select_1266 = and_310_s3_q ? (left_first_s3_q ? select_1263 : select_1264) : census_columns_values_1_cell_2_of_skin_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1267;
  assign select_1267 = and_343_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1268;
  assign select_1268 = and_310_s3_q ? select_1267 : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1270;
  assign select_1270 = and_310_s3_q ? (left_first_s3_q ? select_1267 : select_1268) : census_columns_values_1_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1271;
  assign select_1271 = and_343_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1272;
  assign select_1272 = and_310_s3_q ? select_1271 : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1274;
  assign select_1274 = and_310_s3_q ? (left_first_s3_q ? select_1271 : select_1272) : census_columns_values_1_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1275;
  assign select_1275 = and_343_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1276;
  assign select_1276 = and_310_s3_q ? select_1275 : census_columns_values_1_cell_3_mask_q;
  logic select_1278;
  assign select_1278 = and_310_s3_q ? (left_first_s3_q ? select_1275 : select_1276) : census_columns_values_1_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1279;
  assign select_1279 = and_343_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1280;
  assign select_1280 = and_310_s3_q ? select_1279 : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1282;
  assign select_1282 = and_310_s3_q ? (left_first_s3_q ? select_1279 : select_1280) : census_columns_values_1_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1283;
  assign select_1283 = and_343_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1284;
  assign select_1284 = and_310_s3_q ? select_1283 : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1286;
  assign select_1286 = and_310_s3_q ? (left_first_s3_q ? select_1283 : select_1284) : census_columns_values_1_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1287;
  assign select_1287 = and_343_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1288;
  assign select_1288 = and_310_s3_q ? select_1287 : census_columns_values_1_cell_4_mask_q;
  logic select_1290;
  assign select_1290 = and_310_s3_q ? (left_first_s3_q ? select_1287 : select_1288) : census_columns_values_1_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1291;
  assign select_1291 = and_343_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1292;
  assign select_1292 = and_310_s3_q ? select_1291 : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1294;
  assign select_1294 = and_310_s3_q ? (left_first_s3_q ? select_1291 : select_1292) : census_columns_values_2_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1295;
  assign select_1295 = and_343_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1296;
  assign select_1296 = and_310_s3_q ? select_1295 : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1298;
  assign select_1298 = and_310_s3_q ? (left_first_s3_q ? select_1295 : select_1296) : census_columns_values_2_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1299;
  assign select_1299 = and_343_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1300;
  assign select_1300 = and_310_s3_q ? select_1299 : census_columns_values_2_cell_0_mask_q;
  logic select_1302;
  assign select_1302 = and_310_s3_q ? (left_first_s3_q ? select_1299 : select_1300) : census_columns_values_2_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1303;
  assign select_1303 = and_343_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1304;
  assign select_1304 = and_310_s3_q ? select_1303 : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1306;
  assign select_1306 = and_310_s3_q ? (left_first_s3_q ? select_1303 : select_1304) : census_columns_values_2_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1307;
  assign select_1307 = and_343_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1308;
  assign select_1308 = and_310_s3_q ? select_1307 : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1310;
  assign select_1310 = and_310_s3_q ? (left_first_s3_q ? select_1307 : select_1308) : census_columns_values_2_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1311;
  assign select_1311 = and_343_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1312;
  assign select_1312 = and_310_s3_q ? select_1311 : census_columns_values_2_cell_1_mask_q;
  logic select_1314;
  assign select_1314 = and_310_s3_q ? (left_first_s3_q ? select_1311 : select_1312) : census_columns_values_2_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1315;
  assign select_1315 = and_343_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1316;
  assign select_1316 = and_310_s3_q ? select_1315 : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1318;
  assign select_1318 = and_310_s3_q ? (left_first_s3_q ? select_1315 : select_1316) : census_columns_values_2_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1319;
  assign select_1319 = and_343_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1320;
  assign select_1320 = and_310_s3_q ? select_1319 : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1322;
  assign select_1322 = and_310_s3_q ? (left_first_s3_q ? select_1319 : select_1320) : census_columns_values_2_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1323;
  assign select_1323 = and_343_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1324;
  assign select_1324 = and_310_s3_q ? select_1323 : census_columns_values_2_cell_2_mask_q;
  logic select_1326;
  assign select_1326 = and_310_s3_q ? (left_first_s3_q ? select_1323 : select_1324) : census_columns_values_2_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1327;
  assign select_1327 = and_343_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1328;
  assign select_1328 = and_310_s3_q ? select_1327 : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1330;
  assign select_1330 = and_310_s3_q ? (left_first_s3_q ? select_1327 : select_1328) : census_columns_values_2_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1331;
  assign select_1331 = and_343_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1332;
  assign select_1332 = and_310_s3_q ? select_1331 : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1334;
  assign select_1334 = and_310_s3_q ? (left_first_s3_q ? select_1331 : select_1332) : census_columns_values_2_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1335;
  assign select_1335 = and_343_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1336;
  assign select_1336 = and_310_s3_q ? select_1335 : census_columns_values_2_cell_3_mask_q;
  logic select_1338;
  assign select_1338 = and_310_s3_q ? (left_first_s3_q ? select_1335 : select_1336) : census_columns_values_2_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1339;
  assign select_1339 = and_343_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1340;
  assign select_1340 = and_310_s3_q ? select_1339 : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1342;
  assign select_1342 = and_310_s3_q ? (left_first_s3_q ? select_1339 : select_1340) : census_columns_values_2_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1343;
  assign select_1343 = and_343_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1344;
  assign select_1344 = and_310_s3_q ? select_1343 : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1346;
  assign select_1346 = and_310_s3_q ? (left_first_s3_q ? select_1343 : select_1344) : census_columns_values_2_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1347;
  assign select_1347 = and_343_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1348;
  assign select_1348 = and_310_s3_q ? select_1347 : census_columns_values_2_cell_4_mask_q;
  logic select_1350;
  assign select_1350 = and_310_s3_q ? (left_first_s3_q ? select_1347 : select_1348) : census_columns_values_2_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1351;
  assign select_1351 = and_343_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1352;
  assign select_1352 = and_310_s3_q ? select_1351 : census_columns_values_3_cell_0_mask_q;
  logic select_1354;
  assign select_1354 = and_310_s3_q ? (left_first_s3_q ? select_1351 : select_1352) : census_columns_values_3_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1355;
  assign select_1355 = and_343_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1356;
  assign select_1356 = and_310_s3_q ? select_1355 : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1358;
  assign select_1358 = and_310_s3_q ? (left_first_s3_q ? select_1355 : select_1356) : census_columns_values_3_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1359;
  assign select_1359 = and_343_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1360;
  assign select_1360 = and_310_s3_q ? select_1359 : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1362;
  assign select_1362 = and_310_s3_q ? (left_first_s3_q ? select_1359 : select_1360) : census_columns_values_3_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1363;
  assign select_1363 = and_343_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1364;
  assign select_1364 = and_310_s3_q ? select_1363 : census_columns_values_3_cell_1_mask_q;
  logic select_1366;
  assign select_1366 = and_310_s3_q ? (left_first_s3_q ? select_1363 : select_1364) : census_columns_values_3_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1367;
  assign select_1367 = and_343_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1368;
  assign select_1368 = and_310_s3_q ? select_1367 : census_columns_values_3_cell_2_mask_q;
  logic select_1370;
  assign select_1370 = and_310_s3_q ? (left_first_s3_q ? select_1367 : select_1368) : census_columns_values_3_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1371;
  assign select_1371 = and_343_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1372;
  assign select_1372 = and_310_s3_q ? select_1371 : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1374;
  assign select_1374 = and_310_s3_q ? (left_first_s3_q ? select_1371 : select_1372) : census_columns_values_3_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1375;
  assign select_1375 = and_343_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1376;
  assign select_1376 = and_310_s3_q ? select_1375 : census_columns_values_3_cell_3_right_q;
  logic [8:0] select_1378;
  assign select_1378 = and_310_s3_q ? (left_first_s3_q ? select_1375 : select_1376) : census_columns_values_3_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic select_1379;
  assign select_1379 = and_343_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1380;
  assign select_1380 = and_310_s3_q ? select_1379 : census_columns_values_3_cell_3_mask_q;
  logic select_1382;
  assign select_1382 = and_310_s3_q ? (left_first_s3_q ? select_1379 : select_1380) : census_columns_values_3_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1383;
  assign select_1383 = and_343_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1384;
  assign select_1384 = and_310_s3_q ? select_1383 : census_columns_values_3_cell_4_mask_q;
  logic select_1386;
  assign select_1386 = and_310_s3_q ? (left_first_s3_q ? select_1383 : select_1384) : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_1391;
  assign difference_1391 = {1'b0, total_2[10:2]} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1392;
  assign xor_1392 = difference_1391[8:0] ^ {9{difference_1391[9]}};
  logic [9:0] sum_1393;
  assign sum_1393 = {9'h0, difference_1391[9]} + {1'b0, xor_1392};
  logic [9:0] difference_1394;
  assign difference_1394 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1395;
  assign xor_1395 = difference_1394[8:0] ^ {9{difference_1394[9]}};
  logic [9:0] sum_1396;
  assign sum_1396 = {9'h0, difference_1394[9]} + {1'b0, xor_1395};
  logic [9:0] difference_1398;
  assign difference_1398 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1399;
  assign xor_1399 = difference_1398[8:0] ^ {9{difference_1398[9]}};
  logic [9:0] sum_1400;
  assign sum_1400 = {9'h0, difference_1398[9]} + {1'b0, xor_1399};
  logic [10:0] sum_1401;
  assign sum_1401 = ({1'b0, sum_1393} + {1'b0, sum_1396}) + {1'b0, sum_1400};
  logic [9:0] difference_1402;
  assign difference_1402 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1403;
  assign xor_1403 = difference_1402[8:0] ^ {9{difference_1402[9]}};
  logic [9:0] sum_1404;
  assign sum_1404 = {9'h0, difference_1402[9]} + {1'b0, xor_1403};
  logic [9:0] difference_1406;
  assign difference_1406 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1407;
  assign xor_1407 = difference_1406[8:0] ^ {9{difference_1406[9]}};
  logic [9:0] sum_1408;
  assign sum_1408 = {9'h0, difference_1406[9]} + {1'b0, xor_1407};
  // hls/stages/agreement.hpp:176
  logic [3:0] select_1444;
  assign select_1444 = and_343_s3_q ? {select_398[2:0], 1'b1} : census_filled_q;
  // hls/stages/agreement.hpp:179
  logic [3:0] select_1446;
  assign select_1446 = left_first_s3_q ? select_1444 : (and_310_s3_q ? select_1444 : census_filled_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1448;
  assign select_1448 = and_343_s3_q ? total[10:2] : sharpness_last_mean_0_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1450;
  assign select_1450 = left_first_s3_q ? select_1448 : (and_310_s3_q ? select_1448 : sharpness_last_mean_0_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1452;
  assign select_1452 = and_343_s3_q ? total_2[10:2] : sharpness_last_mean_1_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1454;
  assign select_1454 = left_first_s3_q ? select_1452 : (and_310_s3_q ? select_1452 : sharpness_last_mean_1_q);
  // hls/stages/census.hpp:273
  logic [9:0] difference_1471;
  assign difference_1471 = {1'b0, total[10:2]} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1471[9]} + (difference_1471[8:0] ^ {9{difference_1471[9]}});
  logic [9:0] difference_1485;
  assign difference_1485 = {1'b0, total_2[10:2]} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1485[9]} + (difference_1485[8:0] ^ {9{difference_1485[9]}});
  // hls/stages/agreement.hpp:176
  logic [4:0] select_1513;
  assign select_1513 = and_343_s3_q ? select_397 : rows_passed_above_q;
  // hls/stages/agreement.hpp:179
  logic [4:0] select_1515;
  assign select_1515 = left_first_s3_q ? select_1513 : (and_310_s3_q ? select_1513 : rows_passed_above_q);
  // hls/stages/agreement.hpp:176
  logic and_1702;
  assign and_1702 = and_343_s3_q & (equal_395_s3_q & equal_1518_s3_q);
  // hls/stages/agreement.hpp:179
  logic and_1703;
  assign and_1703 = and_310_s3_q & and_1702;
  logic select_1705;
  assign select_1705 = and_310_s3_q ? (left_first_s3_q ? and_1702 : and_1703) : and_1703;
  // hls/stages/agreement.hpp:299
  logic and_1710;
  assign and_1710 = not_362_s3_q & (not_506_s3_q & (drew_s3_q & (not_365_s3_q & and_1706_s3_q)));
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1755;
  assign select_1755 = less_364_s3_q ? 9'h0 : (and_916_s3_q ? {and_927, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [8:0] select_1758;
  assign select_1758 = equal_361_s3_q ? 9'h0 : (equal_363_s3_q ? 9'h0 : (drew_s3_q ? select_1755 : 9'h0));
  // hls/stages/agreement.hpp:480
  logic [23:0] sum_1759;
  assign sum_1759 = counts_too_little_explained_q + {{15{select_1758[8]}}, select_1758};
  // hls/stages/agreement.hpp:511
  logic [9:0] select_1782;
  assign select_1782 = (left_rdata_s3_q & and_1706_s3_q) ? ({1'b0, and_937, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:299
  logic [9:0] select_1785;
  assign select_1785 = equal_363_s3_q ? 10'h0 : (drew_s3_q ? (less_364_s3_q ? 10'h0 : select_1782) : 10'h0);
  logic [9:0] select_1786;
  assign select_1786 = equal_361_s3_q ? 10'h0 : select_1785;
  // hls/stages/agreement.hpp:484
  logic [23:0] select_1788;
  assign select_1788 = select_1705 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1786[9]}}, select_1786});
  // hls/stages/agreement.hpp:511
  logic and_1790;
  assign and_1790 = and_927 & less_1789_s3_q;
  // hls/stages/registration.hpp:73
  logic equal_1793;
  assign equal_1793 = {lower_half_s3_q, less_1792_s3_q} == 2'h3;
  logic equal_1794;
  assign equal_1794 = {lower_half_s3_q, less_1792_s3_q} == 2'h2;
  logic equal_1795;
  assign equal_1795 = {lower_half_s3_q, less_1792_s3_q} == 2'h1;
  // hls/stages/registration.hpp:154
  logic [9:0] sum_1826;
  assign sum_1826 = {difference_1825_s3_q, select_1823_s3_q} + {sum_1822_s3_q[9], sum_1822_s3_q[9:1]};
  // hls/stages/registration.hpp:69
  logic [11:0] difference_1827;
  assign difference_1827 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1826[9], sum_1826, sum_1822_s3_q[0]};
  // hls/stages/registration.hpp:158
  logic [11:0] select_1829;
  assign select_1829 = ($signed(difference_1827[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1827;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1829[11:7])) ? 12'h7f : select_1829;
  // hls/stages/registration.hpp:73
  logic not_1869;
  assign not_1869 = ~equal_1793;
  logic not_1870;
  assign not_1870 = ~equal_1794;
  // hls/stages/agreement.hpp:165
  logic and_1875;
  assign and_1875 = not_365_s3_q & (and_1790 & (not_1869 & (not_1870 & (~equal_1795))));
  // hls/stages/agreement.hpp:299
  logic and_1878;
  assign and_1878 = not_362_s3_q & (not_506_s3_q & (drew_s3_q & and_1875));
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1880;
  assign select_1880 = select_1705 ? 12'h0 : (registration_counts_measured_0_q + {11'h0, and_1878});
  // hls/stages/agreement.hpp:299
  logic and_1885;
  assign and_1885 = drew_s3_q & (not_365_s3_q & (and_1790 & (not_1869 & (equal_1795 & not_1870))));
  logic and_1887;
  assign and_1887 = not_362_s3_q & (not_506_s3_q & and_1885);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1889;
  assign select_1889 = select_1705 ? 12'h0 : (registration_counts_measured_1_q + {11'h0, and_1887});
  // hls/stages/agreement.hpp:299
  logic and_1893;
  assign and_1893 = drew_s3_q & (not_365_s3_q & (and_1790 & (equal_1794 & not_1869)));
  logic and_1895;
  assign and_1895 = not_362_s3_q & (not_506_s3_q & and_1893);
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1897;
  assign select_1897 = select_1705 ? 12'h0 : (registration_counts_measured_2_q + {11'h0, and_1895});
  // hls/stages/agreement.hpp:299
  logic and_1901;
  assign and_1901 = not_506_s3_q & (drew_s3_q & (not_365_s3_q & (and_1790 & equal_1793)));
  logic and_1902;
  assign and_1902 = not_362_s3_q & and_1901;
  // hls/stages/agreement.hpp:485
  logic [11:0] select_1904;
  assign select_1904 = select_1705 ? 12'h0 : (registration_counts_measured_3_q + {11'h0, and_1902});
  // hls/stages/registration.hpp:146
  logic less_1905;
  assign less_1905 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:165
  logic and_1906;
  assign and_1906 = and_1790 & less_1905;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1909;
  assign select_1909 = equal_363_s3_q ? 2'h0 : (drew_s3_q ? (less_364_s3_q ? 2'h0 : {and_1906, and_1790}) : 2'h0);
  logic [1:0] select_1910;
  assign select_1910 = equal_361_s3_q ? 2'h0 : select_1909;
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1911;
  assign sum_1911 = registration_counts_votes_0_down_q + {{13{select_1910[1]}}, select_1910};
  // hls/stages/registration.hpp:146
  logic [12:0] difference_1913;
  assign difference_1913 = 13'h0 - {residual[11], residual};
  logic less_1914;
  assign less_1914 = $signed(difference_1913) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:165
  logic and_1915;
  assign and_1915 = and_1790 & less_1914;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1918;
  assign select_1918 = equal_363_s3_q ? 2'h0 : (drew_s3_q ? (less_364_s3_q ? 2'h0 : {and_1915, and_1790}) : 2'h0);
  logic [1:0] select_1919;
  assign select_1919 = equal_361_s3_q ? 2'h0 : select_1918;
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1920;
  assign sum_1920 = registration_counts_votes_0_up_q + {{13{select_1919[1]}}, select_1919};
  // hls/stages/registration.hpp:80
  logic not_1922;
  assign not_1922 = ~less_1792_s3_q;
  // hls/stages/registration.hpp:79
  logic and_1923;
  assign and_1923 = less_1905 & not_1922;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1926;
  assign select_1926 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1923, not_1922} : 2'h0)) : 2'h0;
  logic [1:0] select_1928;
  assign select_1928 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_1926);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1929;
  assign sum_1929 = registration_counts_votes_1_down_q + {{13{select_1928[1]}}, select_1928};
  // hls/stages/registration.hpp:79
  logic and_1931;
  assign and_1931 = less_1914 & not_1922;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1934;
  assign select_1934 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1931, not_1922} : 2'h0)) : 2'h0;
  logic [1:0] select_1936;
  assign select_1936 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_1934);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1937;
  assign sum_1937 = registration_counts_votes_1_up_q + {{13{select_1936[1]}}, select_1936};
  // hls/stages/registration.hpp:79
  logic and_1939;
  assign and_1939 = less_1792_s3_q & less_1905;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1941;
  assign select_1941 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_1939, less_1792_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1944;
  assign select_1944 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_1941 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1945;
  assign sum_1945 = registration_counts_votes_2_down_q + {{13{select_1944[1]}}, select_1944};
  // hls/stages/registration.hpp:79
  logic and_1947;
  assign and_1947 = less_1792_s3_q & less_1914;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_1949;
  assign select_1949 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_1947, less_1792_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1952;
  assign select_1952 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_1949 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1953;
  assign sum_1953 = registration_counts_votes_2_up_q + {{13{select_1952[1]}}, select_1952};
  // hls/stages/registration.hpp:80
  logic not_1955;
  assign not_1955 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:165
  logic and_1956;
  assign and_1956 = less_1905 & not_1955;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1959;
  assign select_1959 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1956, not_1955} : 2'h0)) : 2'h0;
  logic [1:0] select_1961;
  assign select_1961 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_1959);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1962;
  assign sum_1962 = registration_counts_votes_3_down_q + {{13{select_1961[1]}}, select_1961};
  // hls/stages/agreement.hpp:165
  logic and_1964;
  assign and_1964 = less_1914 & not_1955;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1967;
  assign select_1967 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1964, not_1955} : 2'h0)) : 2'h0;
  logic [1:0] select_1969;
  assign select_1969 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_1967);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1970;
  assign sum_1970 = registration_counts_votes_3_up_q + {{13{select_1969[1]}}, select_1969};
  // hls/stages/agreement.hpp:165
  logic and_1972;
  assign and_1972 = lower_half_s3_q & less_1905;
  logic [1:0] select_1974;
  assign select_1974 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_1972, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1977;
  assign select_1977 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_1974 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1978;
  assign sum_1978 = registration_counts_votes_4_down_q + {{13{select_1977[1]}}, select_1977};
  // hls/stages/agreement.hpp:165
  logic and_1980;
  assign and_1980 = lower_half_s3_q & less_1914;
  logic [1:0] select_1982;
  assign select_1982 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_1980, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1985;
  assign select_1985 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_1982 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_1986;
  assign sum_1986 = registration_counts_votes_4_up_q + {{13{select_1985[1]}}, select_1985};
  // hls/stages/registration.hpp:146
  logic less_1988;
  assign less_1988 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1989;
  assign and_1989 = not_1922 & less_1988;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_1992;
  assign select_1992 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1989, not_1922} : 2'h0)) : 2'h0;
  logic [1:0] select_1994;
  assign select_1994 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_1992);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_1995;
  assign sum_1995 = registration_counts_half_votes_0_down_q + {{13{select_1994[1]}}, select_1994};
  // hls/stages/registration.hpp:146
  logic less_1997;
  assign less_1997 = $signed(difference_1913) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:79
  logic and_1998;
  assign and_1998 = not_1922 & less_1997;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2001;
  assign select_2001 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_1998, not_1922} : 2'h0)) : 2'h0;
  logic [1:0] select_2003;
  assign select_2003 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_2001);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_2004;
  assign sum_2004 = registration_counts_half_votes_0_up_q + {{13{select_2003[1]}}, select_2003};
  // hls/stages/registration.hpp:79
  logic and_2006;
  assign and_2006 = less_1792_s3_q & less_1988;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_2008;
  assign select_2008 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_2006, less_1792_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2011;
  assign select_2011 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_2008 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_2012;
  assign sum_2012 = registration_counts_half_votes_1_down_q + {{13{select_2011[1]}}, select_2011};
  // hls/stages/registration.hpp:79
  logic and_2014;
  assign and_2014 = less_1792_s3_q & less_1997;
  // hls/stages/agreement.hpp:165
  logic [1:0] select_2016;
  assign select_2016 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_2014, less_1792_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2019;
  assign select_2019 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_2016 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_2020;
  assign sum_2020 = registration_counts_half_votes_1_up_q + {{13{select_2019[1]}}, select_2019};
  // hls/stages/agreement.hpp:165
  logic and_2022;
  assign and_2022 = less_1988 & not_1955;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2025;
  assign select_2025 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_2022, not_1955} : 2'h0)) : 2'h0;
  logic [1:0] select_2027;
  assign select_2027 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_2025);
  // hls/stages/registration.hpp:121
  logic [14:0] sum_2028;
  assign sum_2028 = registration_counts_half_votes_2_down_q + {{13{select_2027[1]}}, select_2027};
  // hls/stages/agreement.hpp:165
  logic and_2030;
  assign and_2030 = less_1997 & not_1955;
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2033;
  assign select_2033 = drew_s3_q ? (less_364_s3_q ? 2'h0 : (and_1790 ? {and_2030, not_1955} : 2'h0)) : 2'h0;
  logic [1:0] select_2035;
  assign select_2035 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : select_2033);
  // hls/stages/registration.hpp:122
  logic [14:0] sum_2036;
  assign sum_2036 = registration_counts_half_votes_2_up_q + {{13{select_2035[1]}}, select_2035};
  // hls/stages/agreement.hpp:165
  logic and_2038;
  assign and_2038 = lower_half_s3_q & less_1988;
  logic [1:0] select_2040;
  assign select_2040 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_2038, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2043;
  assign select_2043 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_2040 : 2'h0));
  // hls/stages/registration.hpp:121
  logic [14:0] sum_2044;
  assign sum_2044 = registration_counts_half_votes_3_down_q + {{13{select_2043[1]}}, select_2043};
  // hls/stages/agreement.hpp:165
  logic and_2046;
  assign and_2046 = lower_half_s3_q & less_1997;
  logic [1:0] select_2048;
  assign select_2048 = less_364_s3_q ? 2'h0 : (and_1790 ? {and_2046, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:299
  logic [1:0] select_2051;
  assign select_2051 = equal_361_s3_q ? 2'h0 : (equal_363_s3_q ? 2'h0 : (drew_s3_q ? select_2048 : 2'h0));
  // hls/stages/registration.hpp:122
  logic [14:0] sum_2052;
  assign sum_2052 = registration_counts_half_votes_3_up_q + {{13{select_2051[1]}}, select_2051};
  // hls/stages/division.hpp:34
  logic [7:0] sum_2072;
  assign sum_2072 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:246
  logic [2:0] select_2074;
  assign select_2074 = less_2071_s3_q ? (sum_2072[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2076;
  assign select_2076 = equal_1518_s3_q ? (equal_395_s3_q ? 3'h0 : select_2074) : region_row_q;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_2077;
  assign select_2077 = and_343_s3_q ? select_2076 : region_row_q;
  // hls/stages/agreement.hpp:179
  logic [2:0] select_2079;
  assign select_2079 = left_first_s3_q ? select_2077 : (and_310_s3_q ? select_2077 : region_row_q);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_2083;
  assign select_2083 = equal_361_s3_q ? select_889 : (equal_363_s3_q ? select_889 : (drew_s3_q ? select_998 : 8'h1));
  // hls/stages/division.hpp:35
  logic [8:0] sum_2084;
  assign sum_2084 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2085;
  assign select_2085 = sum_900[5] ? {1'b1, sum_900[4:0], region_across_rest_q[2:0]} : sum_2084;
  // hls/stages/agreement.hpp:140
  logic [8:0] select_2086;
  assign select_2086 = drew_s3_q ? select_2085 : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/agreement.hpp:246
  logic [7:0] select_2089;
  assign select_2089 = equal_1518_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_2090;
  assign select_2090 = and_343_s3_q ? select_2089 : columns_begin_rest_q;
  // hls/stages/agreement.hpp:179
  logic [7:0] select_2092;
  assign select_2092 = left_first_s3_q ? select_2090 : (and_310_s3_q ? select_2090 : columns_begin_rest_q);
  // hls/stages/agreement.hpp:246
  logic [6:0] select_2095;
  assign select_2095 = equal_1518_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_2096;
  assign select_2096 = and_343_s3_q ? select_2095 : columns_begin_back_q;
  // hls/stages/agreement.hpp:179
  logic [6:0] select_2098;
  assign select_2098 = left_first_s3_q ? select_2096 : (and_310_s3_q ? select_2096 : columns_begin_back_q);
  // hls/stages/agreement.hpp:246
  logic [8:0] select_2102;
  assign select_2102 = equal_395_s3_q ? {{2{difference_2100[6]}}, difference_2100} : (less_2071_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:176
  logic [8:0] select_2104;
  assign select_2104 = and_343_s3_q ? (equal_1518_s3_q ? select_2102 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_2106;
  assign select_2106 = left_first_s3_q ? select_2104 : (and_310_s3_q ? select_2104 : region_down_rest_q);
  // hls/stages/agreement.hpp:246
  logic [6:0] select_2109;
  assign select_2109 = equal_395_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_2111;
  assign select_2111 = and_343_s3_q ? (equal_1518_s3_q ? select_2109 : region_down_back_q) : region_down_back_q;
  // hls/stages/agreement.hpp:179
  logic [6:0] select_2113;
  assign select_2113 = left_first_s3_q ? select_2111 : (and_310_s3_q ? select_2111 : region_down_back_q);
  // hls/stages/division.hpp:35
  logic [8:0] sum_2115;
  assign sum_2115 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_2116;
  assign select_2116 = sum_2072[7] ? {1'b1, sum_2072[6:0], region_down_rest_q[0]} : sum_2115;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_2072[7];
  // hls/stages/agreement.hpp:246
  logic select_2120;
  assign select_2120 = equal_1518_s3_q ? (equal_395_s3_q | (less_2071_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:176
  logic select_2121;
  assign select_2121 = and_343_s3_q ? select_2120 : region_fresh_q;
  // hls/stages/agreement.hpp:179
  logic select_2123;
  assign select_2123 = left_first_s3_q ? select_2121 : (and_310_s3_q ? select_2121 : region_fresh_q);
  // hls/stages/agreement.hpp:140
  logic or_2128;
  assign or_2128 = segment_starts_q | not_1582_s3_q;
  // hls/stages/agreement.hpp:516
  logic select_2131;
  assign select_2131 = less_364_s3_q ? or_2128 : (sum_900[5] ? (equal_902_s3_q & or_903) : or_903);
  // hls/stages/agreement.hpp:299
  logic select_2134;
  assign select_2134 = equal_361_s3_q ? or_2128 : (equal_363_s3_q ? or_2128 : (drew_s3_q ? select_2131 : or_2128));
  // hls/stages/agreement.hpp:619
  logic equal_2136;
  assign equal_2136 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:621
  logic [7:0] select_2160;
  assign select_2160 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_2162;
  assign select_2162 = equal_905_s3_q ? (equal_2136 ? select_2160 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_2164;
  assign select_2164 = equal_363_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_2162);
  // hls/stages/agreement.hpp:142
  logic not_2166;
  assign not_2166 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:299
  logic select_2241;
  assign select_2241 = equal_363_s3_q ? centres_values_0_q : (drew_s3_q ? and_985 : centres_values_0_q);
  logic select_2244;
  assign select_2244 = equal_363_s3_q ? centres_values_1_q : (drew_s3_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/agreement.hpp:246
  logic [10:0] select_2249;
  assign select_2249 = equal_1518_s3_q ? (equal_2246_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:176
  logic [10:0] select_2250;
  assign select_2250 = and_343_s3_q ? select_2249 : map_row_q;
  // hls/stages/agreement.hpp:179
  logic [10:0] select_2252;
  assign select_2252 = left_first_s3_q ? select_2250 : (and_310_s3_q ? select_2250 : map_row_q);
  // hls/stages/agreement.hpp:176
  logic [5:0] select_2255;
  assign select_2255 = and_343_s3_q ? (equal_1518_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:179
  logic [5:0] select_2257;
  assign select_2257 = left_first_s3_q ? select_2255 : (and_310_s3_q ? select_2255 : map_width_q);
  // hls/stages/agreement.hpp:694
  logic xor_2259;
  assign xor_2259 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:179
  logic select_2261;
  assign select_2261 = and_310_s3_q ? (left_first_s3_q ? xor_2259 : write_half_q) : write_half_q;
  logic select_2263;
  assign select_2263 = and_310_s3_q ? (left_first_s3_q ? xor_2259 : select_2261) : write_half_q;
  logic select_2265;
  assign select_2265 = left_first_s3_q ? select_950 : (and_310_s3_q ? select_951 : read_half_q);
  logic and_2269;
  assign and_2269 = (~begins_product_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:299
  logic and_2279;
  assign and_2279 = not_362_s3_q & (not_506_s3_q & (not_1582_s3_q & (equal_905_s3_q & equal_2136)));
  // hls/stages/agreement.hpp:179
  logic select_2288;
  assign select_2288 = and_310_s3_q ? (left_first_s3_q ? and_969 : (and_310_s3_q ? and_969 : began_q)) : began_q;
  logic [2:0] select_2290;
  assign select_2290 = left_first_s3_q ? select_971 : (and_310_s3_q ? select_971 : seen_x_q);
  // hls/stages/agreement.hpp:723
  logic [2:0] select_2294;
  assign select_2294 = and_956_s3_q ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:179
  logic [2:0] select_2297;
  assign select_2297 = left_first_s3_q ? 3'h0 : (and_310_s3_q ? (left_first_s3_q ? 3'h0 : select_2294) : seen_y_q);
  logic [7:0] select_2300;
  assign select_2300 = left_first_s3_q ? select_964 : (and_310_s3_q ? select_964 : seen_column_q);
  // hls/stages/agreement.hpp:176
  logic [7:0] select_2306;
  assign select_2306 = left_first_s3_q ? select_2304 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:179
  logic [7:0] select_2308;
  assign select_2308 = left_first_s3_q ? select_2304 : (and_310_s3_q ? select_2306 : seen_rows_left_q);
  // hls/stages/agreement.hpp:176
  logic and_2313;
  assign and_2313 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:179
  logic select_2315;
  assign select_2315 = left_first_s3_q ? and_2313 : (and_310_s3_q ? and_2313 : at_cell_end_q);
  logic select_2318;
  assign select_2318 = left_first_s3_q ? next_row : (and_310_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2321;
  assign select_2321 = left_first_s3_q ? 11'h0 : (and_310_s3_q ? select_961 : seen_base_q);
  // hls/stages/registration.hpp:99
  logic [12:0] upper;
  assign upper = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, registration_counts_measured_2_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:103
  logic [13:0] sum_2400;
  assign sum_2400 = {1'b0, upper} + {1'b0, lower};
  logic less_2401;
  assign less_2401 = 11'h4 < sum_2400[13:3];
  // hls/stages/registration.hpp:99
  logic [12:0] left;
  assign left = {1'b0, registration_counts_measured_0_q} + {1'b0, registration_counts_measured_2_q};
  // hls/stages/registration.hpp:100
  logic less_2404;
  assign less_2404 = 11'he < left[12:2];
  // hls/stages/registration.hpp:119
  logic less_2406;
  assign less_2406 = $signed(15'h0) < $signed(registration_counts_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic or_2407;
  assign or_2407 = (~less_2404) | less_2406;
  // hls/stages/registration.hpp:99
  logic [12:0] right;
  assign right = {1'b0, registration_counts_measured_1_q} + {1'b0, registration_counts_measured_3_q};
  // hls/stages/registration.hpp:100
  logic less_2409;
  assign less_2409 = 11'he < right[12:2];
  // hls/stages/registration.hpp:119
  logic less_2411;
  assign less_2411 = $signed(15'h0) < $signed(registration_counts_half_votes_0_up_q);
  // hls/stages/registration.hpp:104
  logic select_2413;
  assign select_2413 = less_2401 ? (or_2407 ? less_2406 : less_2411) : less_2411;
  logic or_2414;
  assign or_2414 = (~less_2409) | select_2413;
  // hls/stages/registration.hpp:100
  logic less_2415;
  assign less_2415 = 11'he < upper[12:2];
  // hls/stages/registration.hpp:119
  logic less_2417;
  assign less_2417 = $signed(15'h0) < $signed(registration_counts_half_votes_1_up_q);
  // hls/stages/registration.hpp:104
  logic select_2418;
  assign select_2418 = or_2414 ? select_2413 : less_2417;
  logic select_2420;
  assign select_2420 = less_2401 ? select_2418 : (less_2404 ? select_2418 : less_2417);
  logic or_2421;
  assign or_2421 = (~less_2415) | select_2420;
  // hls/stages/registration.hpp:119
  logic less_2422;
  assign less_2422 = $signed(15'h0) < $signed(registration_counts_half_votes_2_up_q);
  // hls/stages/registration.hpp:104
  logic select_2423;
  assign select_2423 = or_2421 ? select_2420 : less_2422;
  logic select_2426;
  assign select_2426 = less_2401 ? select_2423 : (less_2404 ? select_2423 : (less_2409 ? select_2423 : less_2422));
  // hls/stages/registration.hpp:101
  logic less_2427;
  assign less_2427 = 11'he < lower[12:2];
  // hls/stages/registration.hpp:104
  logic or_2429;
  assign or_2429 = select_2426 | (~less_2427);
  // hls/stages/registration.hpp:119
  logic less_2430;
  assign less_2430 = $signed(15'h0) < $signed(registration_counts_half_votes_3_up_q);
  // hls/stages/registration.hpp:105
  logic select_2431;
  assign select_2431 = or_2429 ? select_2426 : less_2430;
  logic select_2434;
  assign select_2434 = less_2404 ? select_2431 : (less_2409 ? select_2431 : (less_2415 ? select_2431 : less_2430));
  // hls/stages/agreement.hpp:623
  logic and_2446;
  assign and_2446 = ($signed(15'h0) < $signed(registration_counts_votes_3_up_q)) & ($signed(15'h0) < $signed(registration_counts_votes_4_down_q));
  logic or_2447;
  assign or_2447 = ($signed(15'h0) < $signed(registration_counts_votes_4_up_q)) | and_2446;
  logic select_2448;
  assign select_2448 = ($signed(15'h0) < $signed(registration_counts_votes_3_down_q)) ? or_2447 : and_2446;
  logic and_2449;
  assign and_2449 = (less_2415 & less_2427) & select_2448;
  logic or_2450;
  assign or_2450 = ($signed(15'h0) < $signed(registration_counts_votes_2_down_q)) | and_2449;
  logic select_2451;
  assign select_2451 = ($signed(15'h0) < $signed(registration_counts_votes_1_up_q)) ? or_2450 : and_2449;
  logic or_2452;
  assign or_2452 = ($signed(15'h0) < $signed(registration_counts_votes_2_up_q)) | select_2451;
  logic select_2453;
  assign select_2453 = ($signed(15'h0) < $signed(registration_counts_votes_1_down_q)) ? or_2452 : select_2451;
  logic select_2454;
  assign select_2454 = (less_2404 & less_2409) ? select_2453 : and_2449;
  logic or_2455;
  assign or_2455 = (less_2401 ? select_2431 : select_2434) | select_2454;
  // hls/stages/registration.hpp:119
  logic less_2456;
  assign less_2456 = $signed(15'h0) < $signed(registration_counts_half_votes_3_down_q);
  // hls/stages/agreement.hpp:623
  logic or_2457;
  assign or_2457 = less_2456 | or_2455;
  logic select_2458;
  assign select_2458 = or_2429 ? or_2455 : or_2457;
  // hls/stages/registration.hpp:119
  logic less_2459;
  assign less_2459 = $signed(15'h0) < $signed(registration_counts_half_votes_2_down_q);
  logic less_2462;
  assign less_2462 = $signed(15'h0) < $signed(registration_counts_half_votes_1_down_q);
  logic less_2465;
  assign less_2465 = $signed(15'h0) < $signed(registration_counts_half_votes_0_down_q);
  // hls/stages/agreement.hpp:623
  logic and_2507;
  assign and_2507 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2160 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:299
  logic and_2511;
  assign and_2511 = not_1582_s3_q & (equal_905_s3_q & (equal_2136 & (cfg_prove_i & and_2507)));
  logic [11:0] select_2535;
  assign select_2535 = equal_905_s3_q ? (equal_2136 ? registration_counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2538;
  assign select_2538 = equal_361_s3_q ? 12'h0 : (equal_363_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2535));
  logic [11:0] select_2540;
  assign select_2540 = equal_905_s3_q ? (equal_2136 ? registration_counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2543;
  assign select_2543 = equal_361_s3_q ? 12'h0 : (equal_363_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2540));
  logic [11:0] select_2545;
  assign select_2545 = equal_905_s3_q ? (equal_2136 ? registration_counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2548;
  assign select_2548 = equal_361_s3_q ? 12'h0 : (equal_363_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2545));
  logic [11:0] select_2550;
  assign select_2550 = equal_905_s3_q ? (equal_2136 ? registration_counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2553;
  assign select_2553 = equal_361_s3_q ? 12'h0 : (equal_363_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2550));

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:782; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_898, or_895, or_892} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_362_s3_q & (not_506_s3_q & (drew_s3_q ? and_904 : and_908)));
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:801; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_966;
  logic map_re;
  assign map_re = s3_en & (and_310_s3_q ? (left_first_s3_q ? and_975 : and_976) : and_976);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_308_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & select_320_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_339, and_335, sum_331, sum_327};
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
  assign census_memory_waddr = select_304_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & select_346_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], select_360, whole_2, total_2[10:2], total[10:2]};
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

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = partner_s3_q;
  logic best_right_we;
  assign best_right_we = s3_en & and_873_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_888, select_884};
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

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_947_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[8:0], near, explained, textured};
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
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      registration_counts_measured_0_q <= 12'h0;
      registration_counts_measured_1_q <= 12'h0;
      registration_counts_measured_2_q <= 12'h0;
      registration_counts_measured_3_q <= 12'h0;
      registration_counts_votes_0_down_q <= 15'h0;
      registration_counts_votes_0_up_q <= 15'h0;
      registration_counts_votes_1_down_q <= 15'h0;
      registration_counts_votes_1_up_q <= 15'h0;
      registration_counts_votes_2_down_q <= 15'h0;
      registration_counts_votes_2_up_q <= 15'h0;
      registration_counts_votes_3_down_q <= 15'h0;
      registration_counts_votes_3_up_q <= 15'h0;
      registration_counts_votes_4_down_q <= 15'h0;
      registration_counts_votes_4_up_q <= 15'h0;
      registration_counts_half_votes_0_down_q <= 15'h0;
      registration_counts_half_votes_0_up_q <= 15'h0;
      registration_counts_half_votes_1_down_q <= 15'h0;
      registration_counts_half_votes_1_up_q <= 15'h0;
      registration_counts_half_votes_2_down_q <= 15'h0;
      registration_counts_half_votes_2_up_q <= 15'h0;
      registration_counts_half_votes_3_down_q <= 15'h0;
      registration_counts_half_votes_3_up_q <= 15'h0;
      region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      hidden_for_q <= 8'h0;
      next_hidden_for_q <= 8'h0;
      next_region_row_q <= 3'h0;
      begins_product_q <= 1'b0;
      centres_values_0_q <= 1'b0;
      centres_values_1_q <= 1'b0;
      map_row_q <= 11'h0;
      map_width_q <= 6'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      said_q <= 1'b0;
      began_q <= 1'b0;
      seen_x_q <= 3'h0;
      seen_y_q <= 3'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 11'h0;
    end else if (s3_en) begin
      averager_running_of_skin_q <= and_310_s3_q ? select_1153 : averager_running_of_skin_q;
      averager_mask_q <= and_310_s3_q ? select_1157 : averager_mask_q;
      averager_of_skin_q <= and_310_s3_q ? select_1161 : averager_of_skin_q;
      census_filled_q <= and_310_s3_q ? select_1446 : census_filled_q;
      rows_passed_above_q <= and_310_s3_q ? select_1515 : rows_passed_above_q;
      counts_too_little_explained_q <= select_1705 ? 24'h0 : sum_1759;
      counts_too_much_hidden_q <= select_1788;
      registration_counts_measured_0_q <= select_1880;
      registration_counts_measured_1_q <= select_1889;
      registration_counts_measured_2_q <= select_1897;
      registration_counts_measured_3_q <= select_1904;
      registration_counts_votes_0_down_q <= select_1705 ? 15'h0 : sum_1911;
      registration_counts_votes_0_up_q <= select_1705 ? 15'h0 : sum_1920;
      registration_counts_votes_1_down_q <= select_1705 ? 15'h0 : sum_1929;
      registration_counts_votes_1_up_q <= select_1705 ? 15'h0 : sum_1937;
      registration_counts_votes_2_down_q <= select_1705 ? 15'h0 : sum_1945;
      registration_counts_votes_2_up_q <= select_1705 ? 15'h0 : sum_1953;
      registration_counts_votes_3_down_q <= select_1705 ? 15'h0 : sum_1962;
      registration_counts_votes_3_up_q <= select_1705 ? 15'h0 : sum_1970;
      registration_counts_votes_4_down_q <= select_1705 ? 15'h0 : sum_1978;
      registration_counts_votes_4_up_q <= select_1705 ? 15'h0 : sum_1986;
      registration_counts_half_votes_0_down_q <= select_1705 ? 15'h0 : sum_1995;
      registration_counts_half_votes_0_up_q <= select_1705 ? 15'h0 : sum_2004;
      registration_counts_half_votes_1_down_q <= select_1705 ? 15'h0 : sum_2012;
      registration_counts_half_votes_1_up_q <= select_1705 ? 15'h0 : sum_2020;
      registration_counts_half_votes_2_down_q <= select_1705 ? 15'h0 : sum_2028;
      registration_counts_half_votes_2_up_q <= select_1705 ? 15'h0 : sum_2036;
      registration_counts_half_votes_3_down_q <= select_1705 ? 15'h0 : sum_2044;
      registration_counts_half_votes_3_up_q <= select_1705 ? 15'h0 : sum_2052;
      region_row_q <= and_310_s3_q ? select_2079 : region_row_q;
      region_columns_q <= select_2083;
      region_across_rest_q <= select_2086;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_310_s3_q ? select_2092 : columns_begin_rest_q;
      columns_begin_back_q <= and_310_s3_q ? select_2098 : columns_begin_back_q;
      region_down_rest_q <= and_310_s3_q ? select_2106 : region_down_rest_q;
      region_down_back_q <= and_310_s3_q ? select_2113 : region_down_back_q;
      region_down_next_q <= select_2116;
      region_fresh_q <= and_310_s3_q ? select_2123 : region_fresh_q;
      segment_starts_q <= select_2134;
      hidden_for_q <= equal_361_s3_q ? hidden_for_q : select_2164;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_2166};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_q <= equal_361_s3_q ? centres_values_0_q : select_2241;
      centres_values_1_q <= equal_361_s3_q ? centres_values_1_q : select_2244;
      map_row_q <= and_310_s3_q ? select_2252 : map_row_q;
      map_width_q <= and_310_s3_q ? select_2257 : map_width_q;
      write_half_q <= select_2263;
      read_half_q <= and_310_s3_q ? select_2265 : read_half_q;
      done_q <= and_310_s3_q ? (not_967 & and_2269) : and_2269;
      said_q <= and_2279;
      began_q <= select_2288;
      seen_x_q <= and_310_s3_q ? select_2290 : seen_x_q;
      seen_y_q <= and_310_s3_q ? select_2297 : seen_y_q;
      seen_column_q <= and_310_s3_q ? select_2300 : seen_column_q;
      seen_rows_left_q <= and_310_s3_q ? select_2308 : seen_rows_left_q;
      at_cell_end_q <= and_310_s3_q ? select_2315 : at_cell_end_q;
      was_next_row_q <= and_310_s3_q ? select_2318 : was_next_row_q;
      seen_base_q <= and_310_s3_q ? select_2321 : seen_base_q;
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s3_en) begin
      left_pixel_q <= and_310_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= and_310_s3_q ? select_1097 : averager_running_0_q;
      averager_running_1_q <= and_310_s3_q ? select_1100 : averager_running_1_q;
      averager_total_0_q <= and_310_s3_q ? select_1120 : averager_total_0_q;
      averager_total_1_q <= and_310_s3_q ? select_1124 : averager_total_1_q;
      census_columns_values_0_cell_0_left_q <= select_1166;
      census_columns_values_0_cell_0_right_q <= select_1170;
      census_columns_values_0_cell_0_mask_q <= select_1174;
      census_columns_values_0_cell_1_left_q <= select_1178;
      census_columns_values_0_cell_1_right_q <= select_1182;
      census_columns_values_0_cell_1_mask_q <= select_1186;
      census_columns_values_0_cell_2_left_q <= select_1190;
      census_columns_values_0_cell_2_right_q <= select_1194;
      census_columns_values_0_cell_2_mask_q <= select_1198;
      census_columns_values_0_cell_2_of_skin_q <= select_1202;
      census_columns_values_0_cell_3_left_q <= select_1206;
      census_columns_values_0_cell_3_right_q <= select_1210;
      census_columns_values_0_cell_3_mask_q <= select_1214;
      census_columns_values_0_cell_4_left_q <= select_1218;
      census_columns_values_0_cell_4_right_q <= select_1222;
      census_columns_values_0_cell_4_mask_q <= select_1226;
      census_columns_values_1_cell_0_left_q <= select_1230;
      census_columns_values_1_cell_0_right_q <= select_1234;
      census_columns_values_1_cell_0_mask_q <= select_1238;
      census_columns_values_1_cell_1_left_q <= select_1242;
      census_columns_values_1_cell_1_right_q <= select_1246;
      census_columns_values_1_cell_1_mask_q <= select_1250;
      census_columns_values_1_cell_2_left_q <= select_1254;
      census_columns_values_1_cell_2_right_q <= select_1258;
      census_columns_values_1_cell_2_mask_q <= select_1262;
      census_columns_values_1_cell_2_of_skin_q <= select_1266;
      census_columns_values_1_cell_3_left_q <= select_1270;
      census_columns_values_1_cell_3_right_q <= select_1274;
      census_columns_values_1_cell_3_mask_q <= select_1278;
      census_columns_values_1_cell_4_left_q <= select_1282;
      census_columns_values_1_cell_4_right_q <= select_1286;
      census_columns_values_1_cell_4_mask_q <= select_1290;
      census_columns_values_2_cell_0_left_q <= select_1294;
      census_columns_values_2_cell_0_right_q <= select_1298;
      census_columns_values_2_cell_0_mask_q <= select_1302;
      census_columns_values_2_cell_1_left_q <= select_1306;
      census_columns_values_2_cell_1_right_q <= select_1310;
      census_columns_values_2_cell_1_mask_q <= select_1314;
      census_columns_values_2_cell_2_left_q <= select_1318;
      census_columns_values_2_cell_2_right_q <= select_1322;
      census_columns_values_2_cell_2_mask_q <= select_1326;
      census_columns_values_2_cell_3_left_q <= select_1330;
      census_columns_values_2_cell_3_right_q <= select_1334;
      census_columns_values_2_cell_3_mask_q <= select_1338;
      census_columns_values_2_cell_4_left_q <= select_1342;
      census_columns_values_2_cell_4_right_q <= select_1346;
      census_columns_values_2_cell_4_mask_q <= select_1350;
      census_columns_values_3_cell_0_mask_q <= select_1354;
      census_columns_values_3_cell_1_left_q <= select_1358;
      census_columns_values_3_cell_1_right_q <= select_1362;
      census_columns_values_3_cell_1_mask_q <= select_1366;
      census_columns_values_3_cell_2_mask_q <= select_1370;
      census_columns_values_3_cell_3_left_q <= select_1374;
      census_columns_values_3_cell_3_right_q <= select_1378;
      census_columns_values_3_cell_3_mask_q <= select_1382;
      census_columns_values_3_cell_4_mask_q <= select_1386;
      sharpness_last_mean_0_q <= and_310_s3_q ? select_1450 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_310_s3_q ? select_1454 : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic done_s4_q;
  logic [5:0] select_304_s4_q;
  logic and_310_s4_q;
  logic and_342_s4_q;
  logic and_343_s4_q;
  logic select_346_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_349_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_361_s4_q;
  logic not_362_s4_q;
  logic equal_363_s4_q;
  logic less_364_s4_q;
  logic not_365_s4_q;
  logic less_369_s4_q;
  logic less_370_s4_q;
  logic less_371_s4_q;
  logic less_372_s4_q;
  logic less_373_s4_q;
  logic less_374_s4_q;
  logic less_375_s4_q;
  logic less_376_s4_q;
  logic less_377_s4_q;
  logic less_378_s4_q;
  logic less_379_s4_q;
  logic less_380_s4_q;
  logic less_381_s4_q;
  logic less_382_s4_q;
  logic less_383_s4_q;
  logic less_384_s4_q;
  logic less_385_s4_q;
  logic less_386_s4_q;
  logic less_387_s4_q;
  logic less_388_s4_q;
  logic less_389_s4_q;
  logic less_390_s4_q;
  logic less_391_s4_q;
  logic less_392_s4_q;
  logic and_399_s4_q;
  logic and_424_s4_q;
  logic and_425_s4_q;
  logic [11:0] texture_s4_q;
  logic [5:0] x_s4_2_q;
  logic not_506_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_511_s4_q;
  logic select_807_s4_q;
  logic less_813_s4_q;
  logic less_814_s4_q;
  logic or_816_s4_q;
  logic [7:0] select_820_s4_q;
  logic [5:0] select_824_s4_q;
  logic equal_829_s4_q;
  logic rise_s4_q;
  logic [1:0] sum_841_s4_q;
  logic [7:0] twice_s4_q;
  logic [8:0] difference_853_s4_q;
  logic and_873_s4_q;
  logic or_892_s4_q;
  logic or_895_s4_q;
  logic or_898_s4_q;
  logic equal_905_s4_q;
  logic equal_906_s4_q;
  logic and_916_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_939_s4_q;
  logic and_946_s4_q;
  logic and_973_s4_q;
  logic less_974_s4_q;
  logic [11:0] sum_982_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_993_s4_q;
  logic or_1001_s4_q;
  logic or_1004_s4_q;
  logic or_1007_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1054_s4_q;
  logic [11:0] sum_1409_s4_q;
  logic equal_1431_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1582_s4_q;
  logic select_1705_s4_q;
  logic and_1710_s4_q;
  logic or_1730_s4_q;
  logic and_1790_s4_q;
  logic equal_1793_s4_q;
  logic equal_1794_s4_q;
  logic equal_1795_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_2136_s4_q;
  logic less_2142_s4_q;
  logic and_2324_s4_q;
  logic less_2401_s4_q;
  logic less_2402_s4_q;
  logic less_2404_s4_q;
  logic or_2407_s4_q;
  logic less_2409_s4_q;
  logic or_2414_s4_q;
  logic less_2415_s4_q;
  logic or_2421_s4_q;
  logic select_2458_s4_q;
  logic or_2460_s4_q;
  logic less_2462_s4_q;
  logic less_2465_s4_q;
  logic select_2469_s4_q;
  logic and_2513_s4_q;
  logic [11:0] select_2538_s4_q;
  logic [11:0] select_2543_s4_q;
  logic [11:0] select_2548_s4_q;
  logic [11:0] select_2553_s4_q;
  logic and_2576_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      done_s4_q <= done_q;
      select_304_s4_q <= select_304_s3_q;
      and_310_s4_q <= and_310_s3_q;
      and_342_s4_q <= and_342_s3_q;
      and_343_s4_q <= and_343_s3_q;
      select_346_s4_q <= select_346_s3_q;
      grey_s4_q <= grey;
      equal_349_s4_q <= equal_349_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      equal_361_s4_q <= equal_361_s3_q;
      not_362_s4_q <= not_362_s3_q;
      equal_363_s4_q <= equal_363_s3_q;
      less_364_s4_q <= less_364_s3_q;
      not_365_s4_q <= not_365_s3_q;
      less_369_s4_q <= less_369;
      less_370_s4_q <= less_370;
      less_371_s4_q <= less_371;
      less_372_s4_q <= less_372;
      less_373_s4_q <= less_373;
      less_374_s4_q <= less_374;
      less_375_s4_q <= less_375;
      less_376_s4_q <= less_376;
      less_377_s4_q <= less_377;
      less_378_s4_q <= less_378;
      less_379_s4_q <= less_379;
      less_380_s4_q <= less_380;
      less_381_s4_q <= less_381;
      less_382_s4_q <= less_382;
      less_383_s4_q <= less_383;
      less_384_s4_q <= less_384;
      less_385_s4_q <= less_385;
      less_386_s4_q <= less_386;
      less_387_s4_q <= less_387;
      less_388_s4_q <= less_388;
      less_389_s4_q <= less_389;
      less_390_s4_q <= less_390;
      less_391_s4_q <= less_391;
      less_392_s4_q <= less_392;
      and_399_s4_q <= and_399;
      and_424_s4_q <= whole_22 & and_399;
      and_425_s4_q <= census_columns_values_1_cell_2_mask_q & and_399;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q[5:0];
      not_506_s4_q <= not_506_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_511_s4_q <= equal_511_s3_q;
      select_807_s4_q <= select_807[0];
      less_813_s4_q <= less_813;
      less_814_s4_q <= less_814;
      or_816_s4_q <= or_816;
      select_820_s4_q <= equal_511_s3_q ? of_best_2 : select_819;
      select_824_s4_q <= equal_511_s3_q ? run_shift_s3_q : select_823;
      equal_829_s4_q <= {less_806, select_807} == near_best;
      rise_s4_q <= rise[8];
      sum_841_s4_q <= {less_806, select_807[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_853_s4_q <= {1'b0, twice} - (({twice, 1'b0} < size) ? {twice, 1'b0} : size);
      and_873_s4_q <= and_873_s3_q;
      or_892_s4_q <= or_892;
      or_895_s4_q <= or_895;
      or_898_s4_q <= or_898;
      equal_905_s4_q <= equal_905_s3_q;
      equal_906_s4_q <= equal_906;
      and_916_s4_q <= and_916_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      and_939_s4_q <= not_365_s3_q & (left_rdata_s3_q & and_937);
      and_946_s4_q <= not_362_s3_q & (not_506_s3_q & (drew_s3_q & and_904));
      and_973_s4_q <= and_973;
      less_974_s4_q <= less_974;
      sum_982_s4_q <= sum_982;
      textured_2_s4_q <= textured_2;
      equal_993_s4_q <= x_s3_q == 8'h0;
      or_1001_s4_q <= or_1001;
      or_1004_s4_q <= select_998[7] | (~({select_998[6], select_998[3:2]} == 3'h0));
      or_1007_s4_q <= select_998[7] | (~(select_998[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1054_s4_q <= and_1054_s3_q;
      sum_1409_s4_q <= ({1'b0, sum_1401} + {2'h0, sum_1404}) + {2'h0, sum_1408};
      equal_1431_s4_q <= equal_1431_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1582_s4_q <= not_1582_s3_q;
      select_1705_s4_q <= select_1705;
      and_1710_s4_q <= and_1710;
      or_1730_s4_q <= (x_s3_q[7:1] == 7'h0) | (~centres_values_1_q);
      and_1790_s4_q <= and_1790;
      equal_1793_s4_q <= equal_1793;
      equal_1794_s4_q <= equal_1794;
      equal_1795_s4_q <= equal_1795;
      residual_s4_q <= residual[7:0];
      equal_2136_s4_q <= equal_2136;
      less_2142_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_2324_s4_q <= and_1054_s3_q & (sum_982 == sum_966);
      less_2401_s4_q <= less_2401;
      less_2402_s4_q <= $signed(15'h0) < $signed(registration_counts_votes_0_down_q);
      less_2404_s4_q <= less_2404;
      or_2407_s4_q <= or_2407;
      less_2409_s4_q <= less_2409;
      or_2414_s4_q <= or_2414;
      less_2415_s4_q <= less_2415;
      or_2421_s4_q <= or_2421;
      select_2458_s4_q <= select_2458;
      or_2460_s4_q <= less_2459 | select_2458;
      less_2462_s4_q <= less_2462;
      less_2465_s4_q <= less_2465;
      select_2469_s4_q <= less_2427 ? or_2457 : select_2454;
      and_2513_s4_q <= not_362_s3_q & (not_506_s3_q & and_2511);
      select_2538_s4_q <= select_2538;
      select_2543_s4_q <= select_2543;
      select_2548_s4_q <= select_2548;
      select_2553_s4_q <= select_2553;
      and_2576_s4_q <= not_362_s3_q & (not_506_s3_q & (not_1582_s3_q & and_908));
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  logic [19:0] registration_counts_across_0_q;
  logic [19:0] registration_counts_across_1_q;
  logic [19:0] registration_counts_across_2_q;
  logic [19:0] registration_counts_across_3_q;
  logic [5:0] segment_textured_q;
  logic [5:0] segment_explained_q;
  logic [5:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic [47:0] good_next_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  logic [4:0] box_textured_columns_values_0_q;
  logic [4:0] box_textured_columns_values_1_q;
  logic [4:0] box_textured_columns_values_2_q;
  logic [4:0] box_textured_columns_values_3_q;
  logic [4:0] box_textured_columns_values_4_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_columns_values_0_q;
  logic [4:0] box_explained_columns_values_1_q;
  logic [4:0] box_explained_columns_values_2_q;
  logic [4:0] box_explained_columns_values_3_q;
  logic [4:0] box_explained_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_nearer_columns_values_0_q;
  logic [4:0] box_nearer_columns_values_1_q;
  logic [4:0] box_nearer_columns_values_2_q;
  logic [4:0] box_nearer_columns_values_3_q;
  logic [4:0] box_nearer_columns_values_4_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:201
  logic [12:0] sum_445;
  assign sum_445 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_447;
  assign sum_447 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_445});
  // hls/stages/census.hpp:223
  logic less_448;
  assign less_448 = 9'h4 < sum_447[13:5];
  logic and_449;
  assign and_449 = and_399_s4_q & less_448;
  // hls/stages/registration.hpp:28
  logic not_854;
  assign not_854 = ~difference_853_s4_q[8];
  logic [7:0] xor_855;
  assign xor_855 = twice_s4_q ^ {8{not_854}};
  logic [9:0] sum_856;
  assign sum_856 = {difference_853_s4_q[7:0], 1'b0, not_854} + {not_854, xor_855, not_854};
  logic not_857;
  assign not_857 = ~sum_856[9];
  logic [7:0] xor_858;
  assign xor_858 = twice_s4_q ^ {8{not_857}};
  logic [9:0] sum_859;
  assign sum_859 = {sum_856[8:0], not_857} + {not_857, xor_858, not_857};
  logic not_860;
  assign not_860 = ~sum_859[9];
  logic [7:0] xor_861;
  assign xor_861 = twice_s4_q ^ {8{not_860}};
  logic [9:0] sum_862;
  assign sum_862 = {sum_859[8:0], not_860} + {not_860, xor_861, not_860};
  logic not_863;
  assign not_863 = ~sum_862[9];
  logic [7:0] xor_864;
  assign xor_864 = twice_s4_q ^ {8{not_863}};
  logic [9:0] sum_865;
  assign sum_865 = {sum_862[8:0], not_863} + {not_863, xor_864, not_863};
  // hls/stages/registration.hpp:31
  logic [7:0] difference_866;
  assign difference_866 = {sum_841_s4_q, select_807_s4_q, 5'h0} - {3'h0, difference_853_s4_q[8], sum_856[9], sum_859[9], sum_862[9], sum_865[9]};
  // hls/stages/agreement.hpp:428
  logic [7:0] select_867;
  assign select_867 = rise_s4_q ? difference_866 : {sum_841_s4_q, select_807_s4_q, difference_853_s4_q[8], sum_856[9], sum_859[9], sum_862[9], sum_865[9]};
  logic [7:0] select_868;
  assign select_868 = equal_829_s4_q ? select_867 : {sum_841_s4_q, select_807_s4_q, 5'h0};
  // hls/stages/agreement.hpp:430
  logic [7:0] select_871;
  assign select_871 = less_813_s4_q ? (or_816_s4_q ? select_868 : best_left_rdata_s4_q) : (less_814_s4_q ? select_868 : best_left_rdata_s4_q);
  logic [7:0] select_872;
  assign select_872 = equal_511_s4_q ? select_868 : select_871;
  // hls/stages/agreement.hpp:464
  logic [5:0] select_918;
  assign select_918 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:465
  logic [5:0] sum_919;
  assign sum_919 = {5'h0, textured_s4_q} + select_918;
  // hls/stages/agreement.hpp:549
  logic [11:0] sum_921;
  assign sum_921 = {6'h0, sum_919} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:464
  logic [5:0] select_929;
  assign select_929 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:465
  logic [5:0] sum_930;
  assign sum_930 = {5'h0, explained_s4_q} + select_929;
  // hls/stages/agreement.hpp:550
  logic [11:0] sum_932;
  assign sum_932 = {6'h0, sum_930} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:464
  logic [5:0] select_940;
  assign select_940 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:466
  logic [5:0] sum_941;
  assign sum_941 = {5'h0, and_939_s4_q} + select_940;
  // hls/stages/agreement.hpp:551
  logic [11:0] sum_943;
  assign sum_943 = {6'h0, sum_941} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:575
  logic [4:0] difference_992;
  assign difference_992 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_992 + (equal_993_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:581
  logic not_1008;
  assign not_1008 = ~region_row_s4_q[2];
  logic [2:0] select_1009;
  assign select_1009 = region_row_s4_q[1] ? {1'b0, not_1008, 1'b0} : {region_row_s4_q[2], 1'b0, not_1008};
  logic [5:0] select_1010;
  assign select_1010 = region_row_s4_q[0] ? {select_1009[2], 1'b0, select_1009[1], 1'b0, select_1009[0], 1'b0} : {1'b0, select_1009[2], 1'b0, select_1009[1], 1'b0, select_1009[0]};
  logic [11:0] select_1011;
  assign select_1011 = or_1007_s4_q ? {select_1010[5], 1'b0, select_1010[4], 1'b0, select_1010[3], 1'b0, select_1010[2], 1'b0, select_1010[1], 1'b0, select_1010[0], 1'b0} : {1'b0, select_1010[5], 1'b0, select_1010[4], 1'b0, select_1010[3], 1'b0, select_1010[2], 1'b0, select_1010[1], 1'b0, select_1010[0]};
  logic [23:0] select_1012;
  assign select_1012 = or_1004_s4_q ? {select_1011[11], 1'b0, select_1011[10], 1'b0, select_1011[9], 1'b0, select_1011[8], 1'b0, select_1011[7], 1'b0, select_1011[6], 1'b0, select_1011[5], 1'b0, select_1011[4], 1'b0, select_1011[3], 1'b0, select_1011[2], 1'b0, select_1011[1], 1'b0, select_1011[0], 1'b0} : {1'b0, select_1011[11], 1'b0, select_1011[10], 1'b0, select_1011[9], 1'b0, select_1011[8], 1'b0, select_1011[7], 1'b0, select_1011[6], 1'b0, select_1011[5], 1'b0, select_1011[4], 1'b0, select_1011[3], 1'b0, select_1011[2], 1'b0, select_1011[1], 1'b0, select_1011[0]};
  logic [47:0] select_1013;
  assign select_1013 = or_1001_s4_q ? {select_1012[23], 1'b0, select_1012[22], 1'b0, select_1012[21], 1'b0, select_1012[20], 1'b0, select_1012[19], 1'b0, select_1012[18], 1'b0, select_1012[17], 1'b0, select_1012[16], 1'b0, select_1012[15], 1'b0, select_1012[14], 1'b0, select_1012[13], 1'b0, select_1012[12], 1'b0, select_1012[11], 1'b0, select_1012[10], 1'b0, select_1012[9], 1'b0, select_1012[8], 1'b0, select_1012[7], 1'b0, select_1012[6], 1'b0, select_1012[5], 1'b0, select_1012[4], 1'b0, select_1012[3], 1'b0, select_1012[2], 1'b0, select_1012[1], 1'b0, select_1012[0], 1'b0} : {1'b0, select_1012[23], 1'b0, select_1012[22], 1'b0, select_1012[21], 1'b0, select_1012[20], 1'b0, select_1012[19], 1'b0, select_1012[18], 1'b0, select_1012[17], 1'b0, select_1012[16], 1'b0, select_1012[15], 1'b0, select_1012[14], 1'b0, select_1012[13], 1'b0, select_1012[12], 1'b0, select_1012[11], 1'b0, select_1012[10], 1'b0, select_1012[9], 1'b0, select_1012[8], 1'b0, select_1012[7], 1'b0, select_1012[6], 1'b0, select_1012[5], 1'b0, select_1012[4], 1'b0, select_1012[3], 1'b0, select_1012[2], 1'b0, select_1012[1], 1'b0, select_1012[0]};
  // hls/stages/agreement.hpp:576
  logic [4:0] difference_1025;
  assign difference_1025 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1025 + (equal_993_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:582
  logic [5:0] sum_1028;
  assign sum_1028 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_1013) == 48'h0)) : (~({sum_1028, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:577
  logic [4:0] difference_1039;
  assign difference_1039 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1039 + (equal_993_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:590
  logic and_1043;
  assign and_1043 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/census.hpp:132
  logic [8:0] select_1102;
  assign select_1102 = and_342_s4_q ? grey_s4_q : averager_quarter_1_0_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1104;
  assign select_1104 = left_first_s4_q ? select_1102 : (and_310_s4_q ? select_1102 : averager_quarter_1_0_q);
  // hls/stages/census.hpp:132
  logic [8:0] select_1106;
  assign select_1106 = and_342_s4_q ? grey_2_s4_q : averager_quarter_1_1_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1108;
  assign select_1108 = left_first_s4_q ? select_1106 : (and_310_s4_q ? select_1106 : averager_quarter_1_1_q);
  // hls/stages/census.hpp:131
  logic [8:0] select_1110;
  assign select_1110 = and_342_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1112;
  assign select_1112 = left_first_s4_q ? select_1110 : (and_310_s4_q ? select_1110 : averager_quarter_2_0_q);
  // hls/stages/census.hpp:131
  logic [8:0] select_1114;
  assign select_1114 = and_342_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
  // hls/stages/agreement.hpp:179
  logic [8:0] select_1116;
  assign select_1116 = left_first_s4_q ? select_1114 : (and_310_s4_q ? select_1114 : averager_quarter_2_1_q);
  // hls/stages/census.hpp:128
  logic [9:0] sum_1126;
  assign sum_1126 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1127;
  assign difference_1127 = {1'b0, sum_1126[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1128;
  assign xor_1128 = {difference_1127[8:0], sum_1126[0]} ^ {10{difference_1127[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1127[9]} + {1'b0, xor_1128};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_349_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/census.hpp:134
  logic [13:0] select_1132;
  assign select_1132 = and_342_s4_q ? detail : averager_detail_0_q;
  // hls/stages/agreement.hpp:179
  logic [13:0] select_1134;
  assign select_1134 = left_first_s4_q ? select_1132 : (and_310_s4_q ? select_1132 : averager_detail_0_q);
  // hls/stages/census.hpp:128
  logic [9:0] sum_1136;
  assign sum_1136 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1137;
  assign difference_1137 = {1'b0, sum_1136[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_1138;
  assign xor_1138 = {difference_1137[8:0], sum_1136[0]} ^ {10{difference_1137[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1137[9]} + {1'b0, xor_1138};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_349_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/census.hpp:134
  logic [13:0] select_1142;
  assign select_1142 = and_342_s4_q ? detail_2 : averager_detail_1_q;
  // hls/stages/agreement.hpp:179
  logic [13:0] select_1144;
  assign select_1144 = left_first_s4_q ? select_1142 : (and_310_s4_q ? select_1142 : averager_detail_1_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1387;
  assign select_1387 = and_343_s4_q ? texture_s4_q : census_changes_values_0_left_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1389;
  assign select_1389 = left_first_s4_q ? select_1387 : (and_310_s4_q ? select_1387 : census_changes_values_0_left_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1410;
  assign select_1410 = and_343_s4_q ? sum_1409_s4_q : census_changes_values_0_right_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1412;
  assign select_1412 = left_first_s4_q ? select_1410 : (and_310_s4_q ? select_1410 : census_changes_values_0_right_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1414;
  assign select_1414 = and_343_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1416;
  assign select_1416 = left_first_s4_q ? select_1414 : (and_310_s4_q ? select_1414 : census_changes_values_1_left_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1418;
  assign select_1418 = and_343_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1420;
  assign select_1420 = left_first_s4_q ? select_1418 : (and_310_s4_q ? select_1418 : census_changes_values_1_right_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1422;
  assign select_1422 = and_343_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1424;
  assign select_1424 = left_first_s4_q ? select_1422 : (and_310_s4_q ? select_1422 : census_changes_values_2_left_q);
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1426;
  assign select_1426 = and_343_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/agreement.hpp:179
  logic [11:0] select_1428;
  assign select_1428 = left_first_s4_q ? select_1426 : (and_310_s4_q ? select_1426 : census_changes_values_2_right_q);
  // hls/stages/census.hpp:202
  logic [12:0] sum_1432;
  assign sum_1432 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1409_s4_q};
  logic [13:0] sum_1434;
  assign sum_1434 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1432});
  // hls/stages/census.hpp:225
  logic and_1436;
  assign and_1436 = and_424_s4_q & (9'h4 < sum_1434[13:5]);
  // hls/stages/census.hpp:226
  logic and_1437;
  assign and_1437 = and_424_s4_q & less_448;
  // hls/stages/census.hpp:227
  logic [19:0] sum_1438;
  assign sum_1438 = census_left_misses_q + {{17{and_1437}}, and_1436, 1'b0, and_1436};
  // hls/stages/agreement.hpp:176
  logic [19:0] select_1440;
  assign select_1440 = and_343_s4_q ? (equal_1431_s4_q ? 20'h0 : sum_1438) : census_left_misses_q;
  // hls/stages/agreement.hpp:179
  logic [19:0] select_1442;
  assign select_1442 = left_first_s4_q ? select_1440 : (and_310_s4_q ? select_1440 : census_left_misses_q);
  // hls/stages/agreement.hpp:176
  logic select_1456;
  assign select_1456 = and_343_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
  // hls/stages/agreement.hpp:179
  logic select_1458;
  assign select_1458 = left_first_s4_q ? select_1456 : (and_310_s4_q ? select_1456 : sharpness_last_mask_q);
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1460;
  assign select_1460 = and_343_s4_q ? detail : sharpness_last_detail_0_q;
  // hls/stages/agreement.hpp:179
  logic [13:0] select_1462;
  assign select_1462 = left_first_s4_q ? select_1460 : (and_310_s4_q ? select_1460 : sharpness_last_detail_0_q);
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1464;
  assign select_1464 = and_343_s4_q ? detail_2 : sharpness_last_detail_1_q;
  // hls/stages/agreement.hpp:179
  logic [13:0] select_1466;
  assign select_1466 = left_first_s4_q ? select_1464 : (and_310_s4_q ? select_1464 : sharpness_last_detail_1_q);
  // hls/stages/census.hpp:275
  logic and_1470;
  assign and_1470 = whole_2_s4_q & (~(select_304_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:243
  logic and_1476;
  assign and_1476 = and_1470 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail};
  // hls/stages/census.hpp:276
  logic [12:0] select_1478;
  assign select_1478 = and_1476 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1480;
  assign select_1480 = equal_1431_s4_q ? {11'h0, select_1478} : (sharpness_sums_detail_0_q + {11'h0, select_1478});
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1481;
  assign select_1481 = and_343_s4_q ? select_1480 : sharpness_sums_detail_0_q;
  // hls/stages/agreement.hpp:179
  logic [23:0] select_1483;
  assign select_1483 = left_first_s4_q ? select_1481 : (and_310_s4_q ? select_1481 : sharpness_sums_detail_0_q);
  // hls/stages/agreement.hpp:243
  logic and_1490;
  assign and_1490 = and_1470 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2};
  // hls/stages/census.hpp:276
  logic [12:0] select_1492;
  assign select_1492 = and_1490 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_1494;
  assign select_1494 = equal_1431_s4_q ? {11'h0, select_1492} : (sharpness_sums_detail_1_q + {11'h0, select_1492});
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1495;
  assign select_1495 = and_343_s4_q ? select_1494 : sharpness_sums_detail_1_q;
  // hls/stages/agreement.hpp:179
  logic [23:0] select_1497;
  assign select_1497 = left_first_s4_q ? select_1495 : (and_310_s4_q ? select_1495 : sharpness_sums_detail_1_q);
  // hls/stages/census.hpp:277
  logic [8:0] select_1500;
  assign select_1500 = and_1476 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1501;
  assign sum_1501 = (equal_1431_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1500};
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1502;
  assign select_1502 = and_343_s4_q ? sum_1501 : sharpness_sums_contrast_0_q;
  // hls/stages/agreement.hpp:179
  logic [23:0] select_1504;
  assign select_1504 = left_first_s4_q ? select_1502 : (and_310_s4_q ? select_1502 : sharpness_sums_contrast_0_q);
  // hls/stages/census.hpp:277
  logic [8:0] select_1507;
  assign select_1507 = and_1490 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1508;
  assign sum_1508 = (equal_1431_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1507};
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1509;
  assign select_1509 = and_343_s4_q ? sum_1508 : sharpness_sums_contrast_1_q;
  // hls/stages/agreement.hpp:179
  logic [23:0] select_1511;
  assign select_1511 = left_first_s4_q ? select_1509 : (and_310_s4_q ? select_1509 : sharpness_sums_contrast_1_q);
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1712;
  assign select_1712 = select_1705_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1710_s4_q});
  // hls/stages/agreement.hpp:299
  logic and_1715;
  assign and_1715 = not_362_s4_q & (not_506_s4_q & (begins_product_q & textured_s4_q));
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1717;
  assign select_1717 = select_1705_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1715});
  // hls/stages/agreement.hpp:299
  logic and_1720;
  assign and_1720 = not_362_s4_q & (not_506_s4_q & (begins_product_q & explained_s4_q));
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1722;
  assign select_1722 = select_1705_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1720});
  // hls/stages/agreement.hpp:299
  logic and_1725;
  assign and_1725 = not_362_s4_q & (not_506_s4_q & (begins_product_q & and_939_s4_q));
  // hls/stages/agreement.hpp:584
  logic or_1731;
  assign or_1731 = is_seen | or_1730_s4_q;
  // hls/stages/agreement.hpp:299
  logic and_1735;
  assign and_1735 = not_362_s4_q & (not_506_s4_q & (begins_product_q & (~or_1731)));
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1737;
  assign select_1737 = select_1705_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1735});
  // hls/stages/agreement.hpp:608
  logic less_1738;
  assign less_1738 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1739;
  assign select_1739 = less_1738 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1742;
  assign select_1742 = less_1738 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:609
  logic [12:0] sum_1743;
  assign sum_1743 = {1'b0, select_1742} + {3'h0, select_1742[11:2]};
  logic and_1745;
  assign and_1745 = (~(select_1739[11:4] == 8'h0)) & ({sum_1743, select_1742[1:0]} < {3'h0, select_1739});
  // hls/stages/agreement.hpp:299
  logic [11:0] select_1748;
  assign select_1748 = equal_905_s4_q ? (equal_906_s4_q ? 12'h0 : (and_1745 ? select_1739 : 12'h0)) : 12'h0;
  logic [11:0] select_1750;
  assign select_1750 = equal_363_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1748);
  logic [11:0] select_1751;
  assign select_1751 = equal_361_s4_q ? 12'h0 : select_1750;
  // hls/stages/agreement.hpp:484
  logic [13:0] select_1753;
  assign select_1753 = select_1705_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1751});
  // hls/stages/agreement.hpp:165
  logic [8:0] select_1763;
  assign select_1763 = less_364_s4_q ? 9'h0 : (and_916_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:299
  logic [20:0] select_1764;
  assign select_1764 = begins_product_q ? {{12{select_1763[8]}}, select_1763} : {1'b0, select_1748, 8'h0};
  logic [20:0] select_1766;
  assign select_1766 = equal_361_s4_q ? 21'h0 : (equal_363_s4_q ? 21'h0 : select_1764);
  // hls/stages/agreement.hpp:484
  logic [23:0] select_1768;
  assign select_1768 = select_1705_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1766[20]}}, select_1766});
  // hls/stages/agreement.hpp:530
  logic [8:0] select_1770;
  assign select_1770 = and_916_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1771;
  assign select_1771 = less_364_s4_q ? 8'h0 : select_1770[7:0];
  // hls/stages/agreement.hpp:165
  logic and_1772;
  assign and_1772 = not_365_s4_q & select_1770[8];
  // hls/stages/agreement.hpp:588
  logic [2:0] select_1774;
  assign select_1774 = or_1731 ? {3{and_1772}} : ({3{and_1772}} + 3'h1);
  // hls/stages/agreement.hpp:299
  logic [10:0] select_1776;
  assign select_1776 = equal_363_s4_q ? 11'h0 : (begins_product_q ? {select_1774, select_1771} : 11'h0);
  logic [10:0] select_1777;
  assign select_1777 = equal_361_s4_q ? 11'h0 : select_1776;
  // hls/stages/agreement.hpp:482
  logic [23:0] sum_1778;
  assign sum_1778 = counts_too_much_unproven_q + {{13{select_1777[10]}}, select_1777};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1833;
  assign select_1833 = equal_1794_s4_q ? 8'h0 : (equal_1795_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1836;
  assign select_1836 = less_364_s4_q ? 8'h0 : (and_1790_s4_q ? (equal_1793_s4_q ? 8'h0 : select_1833) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1839;
  assign select_1839 = equal_361_s4_q ? 8'h0 : (equal_363_s4_q ? 8'h0 : (begins_product_q ? select_1836 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1840;
  assign sum_1840 = registration_counts_across_0_q + {{12{select_1839[7]}}, select_1839};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1843;
  assign select_1843 = equal_1794_s4_q ? 8'h0 : (equal_1795_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1846;
  assign select_1846 = less_364_s4_q ? 8'h0 : (and_1790_s4_q ? (equal_1793_s4_q ? 8'h0 : select_1843) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1849;
  assign select_1849 = equal_361_s4_q ? 8'h0 : (equal_363_s4_q ? 8'h0 : (begins_product_q ? select_1846 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1850;
  assign sum_1850 = registration_counts_across_1_q + {{12{select_1849[7]}}, select_1849};
  // hls/stages/registration.hpp:80
  logic [7:0] select_1853;
  assign select_1853 = equal_1793_s4_q ? 8'h0 : (equal_1794_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1856;
  assign select_1856 = begins_product_q ? (less_364_s4_q ? 8'h0 : (and_1790_s4_q ? select_1853 : 8'h0)) : 8'h0;
  logic [7:0] select_1858;
  assign select_1858 = equal_361_s4_q ? 8'h0 : (equal_363_s4_q ? 8'h0 : select_1856);
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1859;
  assign sum_1859 = registration_counts_across_2_q + {{12{select_1858[7]}}, select_1858};
  // hls/stages/agreement.hpp:165
  logic [7:0] select_1863;
  assign select_1863 = less_364_s4_q ? 8'h0 : (and_1790_s4_q ? (equal_1793_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:299
  logic [7:0] select_1866;
  assign select_1866 = equal_361_s4_q ? 8'h0 : (equal_363_s4_q ? 8'h0 : (begins_product_q ? select_1863 : 8'h0));
  // hls/stages/registration.hpp:89
  logic [19:0] sum_1867;
  assign sum_1867 = registration_counts_across_3_q + {{12{select_1866[7]}}, select_1866};
  // hls/stages/agreement.hpp:604
  logic and_2141;
  assign and_2141 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:611
  logic [12:0] sum_2145;
  assign sum_2145 = {1'b0, select_1742} + {2'h0, select_1742[11:1]};
  logic select_2148;
  assign select_2148 = (select_1739[11:3] == 9'h0) ? (and_2141 & (~less_2142_s4_q)) : (~({sum_2145, select_1742[0]} < {2'h0, select_1739}));
  // hls/stages/agreement.hpp:619
  logic [47:0] select_2149;
  assign select_2149 = equal_906_s4_q ? good_next_q : {select_2148, good_next_q[47:1]};
  // hls/stages/agreement.hpp:299
  logic [47:0] select_2151;
  assign select_2151 = equal_905_s4_q ? (equal_2136_s4_q ? select_2149 : good_q) : good_q;
  logic [47:0] select_2153;
  assign select_2153 = equal_363_s4_q ? good_q : (begins_product_q ? good_q : select_2151);
  logic [47:0] select_2156;
  assign select_2156 = begins_product_q ? good_next_q : (equal_905_s4_q ? select_2149 : good_next_q);
  logic [47:0] select_2158;
  assign select_2158 = equal_361_s4_q ? good_next_q : (equal_363_s4_q ? good_next_q : select_2156);
  // hls/stages/agreement.hpp:636
  logic [35:0] select_2177;
  assign select_2177 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:630
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_2177;
  // hls/stages/agreement.hpp:636
  logic [35:0] select_2180;
  assign select_2180 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:640
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_2180;
  // hls/stages/agreement.hpp:630
  logic [34:0] select_2182;
  assign select_2182 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:640
  logic [34:0] select_2183;
  assign select_2183 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:630
  logic [17:0] select_2184;
  assign select_2184 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:640
  logic [17:0] select_2185;
  assign select_2185 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:299
  logic [4:0] select_2186;
  assign select_2186 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_2188;
  assign select_2188 = equal_361_s4_q ? box_textured_columns_values_0_q : (equal_363_s4_q ? box_textured_columns_values_0_q : select_2186);
  logic [4:0] select_2189;
  assign select_2189 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_2191;
  assign select_2191 = equal_361_s4_q ? box_textured_columns_values_1_q : (equal_363_s4_q ? box_textured_columns_values_1_q : select_2189);
  logic [4:0] select_2192;
  assign select_2192 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_2194;
  assign select_2194 = equal_361_s4_q ? box_textured_columns_values_2_q : (equal_363_s4_q ? box_textured_columns_values_2_q : select_2192);
  logic [4:0] select_2195;
  assign select_2195 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_2197;
  assign select_2197 = equal_361_s4_q ? box_textured_columns_values_3_q : (equal_363_s4_q ? box_textured_columns_values_3_q : select_2195);
  logic [4:0] select_2198;
  assign select_2198 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_2200;
  assign select_2200 = equal_361_s4_q ? box_textured_columns_values_4_q : (equal_363_s4_q ? box_textured_columns_values_4_q : select_2198);
  logic [4:0] select_2202;
  assign select_2202 = equal_363_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_2204;
  assign select_2204 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_2206;
  assign select_2206 = equal_361_s4_q ? box_explained_columns_values_0_q : (equal_363_s4_q ? box_explained_columns_values_0_q : select_2204);
  logic [4:0] select_2207;
  assign select_2207 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_2209;
  assign select_2209 = equal_361_s4_q ? box_explained_columns_values_1_q : (equal_363_s4_q ? box_explained_columns_values_1_q : select_2207);
  logic [4:0] select_2210;
  assign select_2210 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_2212;
  assign select_2212 = equal_361_s4_q ? box_explained_columns_values_2_q : (equal_363_s4_q ? box_explained_columns_values_2_q : select_2210);
  logic [4:0] select_2213;
  assign select_2213 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_2215;
  assign select_2215 = equal_361_s4_q ? box_explained_columns_values_3_q : (equal_363_s4_q ? box_explained_columns_values_3_q : select_2213);
  logic [4:0] select_2216;
  assign select_2216 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_2218;
  assign select_2218 = equal_361_s4_q ? box_explained_columns_values_4_q : (equal_363_s4_q ? box_explained_columns_values_4_q : select_2216);
  logic [4:0] select_2220;
  assign select_2220 = equal_363_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_2222;
  assign select_2222 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_2224;
  assign select_2224 = equal_361_s4_q ? box_nearer_columns_values_0_q : (equal_363_s4_q ? box_nearer_columns_values_0_q : select_2222);
  logic [4:0] select_2225;
  assign select_2225 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_2227;
  assign select_2227 = equal_361_s4_q ? box_nearer_columns_values_1_q : (equal_363_s4_q ? box_nearer_columns_values_1_q : select_2225);
  logic [4:0] select_2228;
  assign select_2228 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_2230;
  assign select_2230 = equal_361_s4_q ? box_nearer_columns_values_2_q : (equal_363_s4_q ? box_nearer_columns_values_2_q : select_2228);
  logic [4:0] select_2231;
  assign select_2231 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_2233;
  assign select_2233 = equal_361_s4_q ? box_nearer_columns_values_3_q : (equal_363_s4_q ? box_nearer_columns_values_3_q : select_2231);
  logic [4:0] select_2234;
  assign select_2234 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_2236;
  assign select_2236 = equal_361_s4_q ? box_nearer_columns_values_4_q : (equal_363_s4_q ? box_nearer_columns_values_4_q : select_2234);
  logic [4:0] select_2238;
  assign select_2238 = equal_363_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:698
  logic select_2272;
  assign select_2272 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:179
  logic select_2274;
  assign select_2274 = left_first_s4_q ? done_s4_q : (and_310_s4_q ? select_2272 : proven_q);
  // hls/stages/agreement.hpp:727
  logic [1:0] select_2325;
  assign select_2325 = and_2324_s4_q ? {and_1043, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:728
  logic and_2326;
  assign and_2326 = select_2272 & less_2302;
  // hls/stages/agreement.hpp:179
  logic select_2329;
  assign select_2329 = and_973_s4_q ? (less_974_s4_q ? (select_2325[0] & and_2326) : seen_q) : seen_q;
  logic select_2331;
  assign select_2331 = left_first_s4_q ? select_2329 : (and_310_s4_q ? select_2329 : seen_q);
  logic select_2332;
  assign select_2332 = and_310_s4_q ? select_2331 : seen_q;
  logic select_2335;
  assign select_2335 = and_973_s4_q ? (less_974_s4_q ? (select_2325[1] & and_2326) : nearer_q) : nearer_q;
  logic select_2337;
  assign select_2337 = left_first_s4_q ? select_2335 : (and_310_s4_q ? select_2335 : nearer_q);
  logic select_2338;
  assign select_2338 = and_310_s4_q ? select_2337 : nearer_q;
  // hls/stages/agreement.hpp:299
  logic [13:0] select_2343;
  assign select_2343 = equal_905_s4_q ? (equal_2136_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2345;
  assign select_2345 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2343);
  logic [13:0] select_2348;
  assign select_2348 = equal_905_s4_q ? (equal_2136_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2350;
  assign select_2350 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2348);
  logic [13:0] select_2353;
  assign select_2353 = equal_905_s4_q ? (equal_2136_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2355;
  assign select_2355 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2353);
  logic [13:0] select_2358;
  assign select_2358 = equal_905_s4_q ? (equal_2136_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2360;
  assign select_2360 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2358);
  logic [13:0] select_2363;
  assign select_2363 = equal_905_s4_q ? (equal_2136_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2365;
  assign select_2365 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2363);
  logic [13:0] select_2368;
  assign select_2368 = equal_905_s4_q ? (equal_2136_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_2370;
  assign select_2370 = equal_363_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2368);
  logic and_2376;
  assign and_2376 = not_1582_s4_q & (equal_905_s4_q & (equal_2136_s4_q & (cfg_prove_i & (~proven_q))));
  // hls/stages/agreement.hpp:656
  logic not_2379;
  assign not_2379 = ~and_2141;
  // hls/stages/agreement.hpp:299
  logic and_2383;
  assign and_2383 = not_1582_s4_q & (equal_905_s4_q & (equal_2136_s4_q & (cfg_prove_i & not_2379)));
  // hls/stages/agreement.hpp:657
  logic or_2386;
  assign or_2386 = not_2339 | not_2379;
  // hls/stages/agreement.hpp:623
  logic or_2391;
  assign or_2391 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  // hls/stages/agreement.hpp:299
  logic and_2393;
  assign and_2393 = equal_2136_s4_q & ((less_2142_s4_q | or_2386) ? (~or_2386) : or_2391);
  logic and_2397;
  assign and_2397 = not_362_s4_q & (not_506_s4_q & (not_1582_s4_q & (equal_905_s4_q & and_2393)));
  // hls/stages/agreement.hpp:623
  logic select_2461;
  assign select_2461 = or_2421_s4_q ? select_2458_s4_q : or_2460_s4_q;
  logic or_2463;
  assign or_2463 = less_2462_s4_q | select_2461;
  logic select_2464;
  assign select_2464 = or_2414_s4_q ? select_2461 : or_2463;
  logic or_2466;
  assign or_2466 = less_2465_s4_q | select_2464;
  logic select_2471;
  assign select_2471 = less_2409_s4_q ? or_2463 : (less_2415_s4_q ? or_2460_s4_q : select_2469_s4_q);
  logic select_2473;
  assign select_2473 = less_2401_s4_q ? (less_2402_s4_q | (or_2407_s4_q ? select_2464 : or_2466)) : (less_2404_s4_q ? or_2466 : select_2471);
  // hls/stages/agreement.hpp:299
  logic and_2477;
  assign and_2477 = not_1582_s4_q & (equal_905_s4_q & (equal_2136_s4_q & (cfg_prove_i & select_2473)));
  // hls/stages/agreement.hpp:663
  logic and_2480;
  assign and_2480 = cfg_prove_i & and_2141;
  // hls/stages/agreement.hpp:664
  logic [36:0] sum_2481;
  assign sum_2481 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2483;
  assign less_2483 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:623
  logic or_2486;
  assign or_2486 = ({detail_left, 3'h0} < {sum_2481, detail_right[1:0]}) | (less_2483 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:299
  logic and_2490;
  assign and_2490 = not_1582_s4_q & (equal_905_s4_q & (equal_2136_s4_q & (and_2480 & or_2486)));
  // hls/stages/agreement.hpp:667
  logic [36:0] sum_2493;
  assign sum_2493 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2495;
  assign less_2495 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:623
  logic or_2496;
  assign or_2496 = ({detail_right, 3'h0} < {sum_2493, detail_left[1:0]}) | less_2495;
  // hls/stages/agreement.hpp:299
  logic and_2500;
  assign and_2500 = not_1582_s4_q & (equal_905_s4_q & (equal_2136_s4_q & (and_2480 & or_2496)));
  logic [19:0] select_2515;
  assign select_2515 = equal_905_s4_q ? (equal_2136_s4_q ? registration_counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2517;
  assign select_2517 = equal_363_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2515);
  logic [19:0] select_2520;
  assign select_2520 = equal_905_s4_q ? (equal_2136_s4_q ? registration_counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2522;
  assign select_2522 = equal_363_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2520);
  logic [19:0] select_2525;
  assign select_2525 = equal_905_s4_q ? (equal_2136_s4_q ? registration_counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2527;
  assign select_2527 = equal_363_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2525);
  logic [19:0] select_2530;
  assign select_2530 = equal_905_s4_q ? (equal_2136_s4_q ? registration_counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2532;
  assign select_2532 = equal_363_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2530);
  logic [23:0] select_2555;
  assign select_2555 = equal_905_s4_q ? (equal_2136_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2557;
  assign select_2557 = equal_363_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2555);
  logic [23:0] select_2560;
  assign select_2560 = equal_905_s4_q ? (equal_2136_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2562;
  assign select_2562 = equal_363_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2560);
  logic [23:0] select_2565;
  assign select_2565 = equal_905_s4_q ? (equal_2136_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2567;
  assign select_2567 = equal_363_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2565);
  logic [23:0] select_2570;
  assign select_2570 = equal_905_s4_q ? (equal_2136_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2572;
  assign select_2572 = equal_363_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2570);
  logic [5:0] select_2579;
  assign select_2579 = begins_product_q ? 6'h0 : (equal_905_s4_q ? (equal_906_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2584;
  assign select_2584 = begins_product_q ? 12'h0 : (equal_905_s4_q ? (equal_906_s4_q ? 12'h0 : select_1739) : 12'h0);
  logic [11:0] select_2589;
  assign select_2589 = begins_product_q ? 12'h0 : (equal_905_s4_q ? (equal_906_s4_q ? 12'h0 : select_1742) : 12'h0);
  // hls/stages/agreement.hpp:619
  logic [11:0] select_2593;
  assign select_2593 = equal_906_s4_q ? 12'h0 : (less_1738 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:299
  logic [11:0] select_2595;
  assign select_2595 = begins_product_q ? 12'h0 : (equal_905_s4_q ? select_2593 : 12'h0);

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = select_304_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & select_346_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_449, and_425_s4_q, and_424_s4_q, and_399_s4_q, less_392_s4_q, less_391_s4_q, less_390_s4_q, less_389_s4_q, less_388_s4_q, less_387_s4_q, less_386_s4_q, less_385_s4_q, less_384_s4_q, less_383_s4_q, less_382_s4_q, less_381_s4_q, less_380_s4_q, less_379_s4_q, less_378_s4_q, less_377_s4_q, less_376_s4_q, less_375_s4_q, less_374_s4_q, less_373_s4_q, less_372_s4_q, less_371_s4_q, less_370_s4_q, less_369_s4_q};
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

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s4_2_q;
  logic best_left_we;
  assign best_left_we = s4_en & and_873_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_872, select_824_s4_q, select_820_s4_q};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s2_sim;
  logic best_left_re_s2_sim;
  logic [5:0] best_left_raddr_s3_sim;
  logic best_left_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s2_sim <= 1'b0;
      best_left_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s2_sim <= best_left_re;
      best_left_raddr_s2_sim <= best_left_raddr;
      best_left_re_s3_sim <= best_left_re_s2_sim;
      best_left_raddr_s3_sim <= best_left_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s2_sim && best_left_raddr_s2_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s3_sim && best_left_raddr_s3_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 6'd47) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 6'd47) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_898_s4_q, or_895_s4_q, or_892_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_946_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_943, sum_932, sum_921};
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
  assign map_waddr = sum_982_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1054_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1043, is_seen};
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
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_too_many_bad_q <= 24'h0;
      counts_too_much_unproven_q <= 24'h0;
      registration_counts_across_0_q <= 20'h0;
      registration_counts_across_1_q <= 20'h0;
      registration_counts_across_2_q <= 20'h0;
      registration_counts_across_3_q <= 20'h0;
      segment_textured_q <= 6'h0;
      segment_explained_q <= 6'h0;
      segment_nearer_q <= 6'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_next_q <= 48'h0;
      product_0_q <= 36'h0;
      product_1_q <= 36'h0;
      addend_0_q <= 35'h0;
      addend_1_q <= 35'h0;
      multiplier_0_q <= 18'h0;
      multiplier_1_q <= 18'h0;
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= and_310_s4_q ? select_1442 : census_left_misses_q;
      sharpness_sums_detail_0_q <= and_310_s4_q ? select_1483 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_310_s4_q ? select_1497 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_310_s4_q ? select_1504 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_310_s4_q ? select_1511 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1712;
      counts_textured_q <= select_1717;
      counts_explained_q <= select_1722;
      counts_nearer_q <= select_1705_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1725});
      counts_unproven_q <= select_1737;
      counts_regions_bad_q <= select_1753;
      counts_too_many_bad_q <= select_1768;
      counts_too_much_unproven_q <= select_1705_s4_q ? 24'h0 : sum_1778;
      registration_counts_across_0_q <= select_1705_s4_q ? 20'h0 : sum_1840;
      registration_counts_across_1_q <= select_1705_s4_q ? 20'h0 : sum_1850;
      registration_counts_across_2_q <= select_1705_s4_q ? 20'h0 : sum_1859;
      registration_counts_across_3_q <= select_1705_s4_q ? 20'h0 : sum_1867;
      segment_textured_q <= select_918 + {5'h0, and_1715};
      segment_explained_q <= select_929 + {5'h0, and_1720};
      segment_nearer_q <= select_940 + {5'h0, and_1725};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_361_s4_q ? good_q : select_2153;
      good_next_q <= select_2158;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_2182;
      addend_1_q <= select_2183;
      multiplier_0_q <= select_2184;
      multiplier_1_q <= select_2185;
      proven_q <= and_310_s4_q ? select_2274 : proven_q;
      seen_q <= select_2332;
      nearer_q <= select_2338;
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
    box_textured_columns_values_0_q = 5'h0;
    box_textured_columns_values_1_q = 5'h0;
    box_textured_columns_values_2_q = 5'h0;
    box_textured_columns_values_3_q = 5'h0;
    box_textured_columns_values_4_q = 5'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_columns_values_0_q = 5'h0;
    box_explained_columns_values_1_q = 5'h0;
    box_explained_columns_values_2_q = 5'h0;
    box_explained_columns_values_3_q = 5'h0;
    box_explained_columns_values_4_q = 5'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_nearer_columns_values_0_q = 5'h0;
    box_nearer_columns_values_1_q = 5'h0;
    box_nearer_columns_values_2_q = 5'h0;
    box_nearer_columns_values_3_q = 5'h0;
    box_nearer_columns_values_4_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      averager_quarter_1_0_q <= and_310_s4_q ? select_1104 : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_310_s4_q ? select_1108 : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_310_s4_q ? select_1112 : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_310_s4_q ? select_1116 : averager_quarter_2_1_q;
      averager_detail_0_q <= and_310_s4_q ? select_1134 : averager_detail_0_q;
      averager_detail_1_q <= and_310_s4_q ? select_1144 : averager_detail_1_q;
      census_changes_values_0_left_q <= and_310_s4_q ? select_1389 : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_310_s4_q ? select_1412 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= and_310_s4_q ? select_1416 : census_changes_values_1_left_q;
      census_changes_values_1_right_q <= and_310_s4_q ? select_1420 : census_changes_values_1_right_q;
      census_changes_values_2_left_q <= and_310_s4_q ? select_1424 : census_changes_values_2_left_q;
      census_changes_values_2_right_q <= and_310_s4_q ? select_1428 : census_changes_values_2_right_q;
      sharpness_last_mask_q <= and_310_s4_q ? select_1458 : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_310_s4_q ? select_1462 : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_310_s4_q ? select_1466 : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_2188;
      box_textured_columns_values_1_q <= select_2191;
      box_textured_columns_values_2_q <= select_2194;
      box_textured_columns_values_3_q <= select_2197;
      box_textured_columns_values_4_q <= select_2200;
      box_textured_sum_sums_values_0_q <= equal_361_s4_q ? box_textured_sum_sums_values_0_q : select_2202;
      box_explained_columns_values_0_q <= select_2206;
      box_explained_columns_values_1_q <= select_2209;
      box_explained_columns_values_2_q <= select_2212;
      box_explained_columns_values_3_q <= select_2215;
      box_explained_columns_values_4_q <= select_2218;
      box_explained_sum_sums_values_0_q <= equal_361_s4_q ? box_explained_sum_sums_values_0_q : select_2220;
      box_nearer_columns_values_0_q <= select_2224;
      box_nearer_columns_values_1_q <= select_2227;
      box_nearer_columns_values_2_q <= select_2230;
      box_nearer_columns_values_3_q <= select_2233;
      box_nearer_columns_values_4_q <= select_2236;
      box_nearer_sum_sums_values_0_q <= equal_361_s4_q ? box_nearer_sum_sums_values_0_q : select_2238;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2279_s5_q;
  logic or_2340_s5_q;
  logic and_2341_s5_q;
  logic [13:0] select_2346_s5_q;
  logic [13:0] select_2351_s5_q;
  logic [13:0] select_2356_s5_q;
  logic [13:0] select_2361_s5_q;
  logic [13:0] select_2366_s5_q;
  logic [13:0] select_2371_s5_q;
  logic and_2378_s5_q;
  logic and_2385_s5_q;
  logic and_2397_s5_q;
  logic and_2479_s5_q;
  logic and_2492_s5_q;
  logic and_2502_s5_q;
  logic and_2513_s5_q;
  logic [19:0] select_2518_s5_q;
  logic [19:0] select_2523_s5_q;
  logic [19:0] select_2528_s5_q;
  logic [19:0] select_2533_s5_q;
  logic [11:0] select_2538_s5_q;
  logic [11:0] select_2543_s5_q;
  logic [11:0] select_2548_s5_q;
  logic [11:0] select_2553_s5_q;
  logic [23:0] select_2558_s5_q;
  logic [23:0] select_2563_s5_q;
  logic [23:0] select_2568_s5_q;
  logic [23:0] select_2573_s5_q;
  logic and_2576_s5_q;
  logic [5:0] select_2581_s5_q;
  logic [11:0] select_2586_s5_q;
  logic [11:0] select_2591_s5_q;
  logic [11:0] select_2597_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_2279_s5_q <= said_q;
      or_2340_s5_q <= not_2339 | select_2332;
      and_2341_s5_q <= cfg_prove_i & select_2338;
      select_2346_s5_q <= equal_361_s4_q ? 14'h0 : select_2345;
      select_2351_s5_q <= equal_361_s4_q ? 14'h0 : select_2350;
      select_2356_s5_q <= equal_361_s4_q ? 14'h0 : select_2355;
      select_2361_s5_q <= equal_361_s4_q ? 14'h0 : select_2360;
      select_2366_s5_q <= equal_361_s4_q ? 14'h0 : select_2365;
      select_2371_s5_q <= equal_361_s4_q ? 14'h0 : select_2370;
      and_2378_s5_q <= not_362_s4_q & (not_506_s4_q & and_2376);
      and_2385_s5_q <= not_362_s4_q & (not_506_s4_q & and_2383);
      and_2397_s5_q <= and_2397;
      and_2479_s5_q <= not_362_s4_q & (not_506_s4_q & and_2477);
      and_2492_s5_q <= not_362_s4_q & (not_506_s4_q & and_2490);
      and_2502_s5_q <= not_362_s4_q & (not_506_s4_q & and_2500);
      and_2513_s5_q <= and_2513_s4_q;
      select_2518_s5_q <= equal_361_s4_q ? 20'h0 : select_2517;
      select_2523_s5_q <= equal_361_s4_q ? 20'h0 : select_2522;
      select_2528_s5_q <= equal_361_s4_q ? 20'h0 : select_2527;
      select_2533_s5_q <= equal_361_s4_q ? 20'h0 : select_2532;
      select_2538_s5_q <= select_2538_s4_q;
      select_2543_s5_q <= select_2543_s4_q;
      select_2548_s5_q <= select_2548_s4_q;
      select_2553_s5_q <= select_2553_s4_q;
      select_2558_s5_q <= equal_361_s4_q ? 24'h0 : select_2557;
      select_2563_s5_q <= equal_361_s4_q ? 24'h0 : select_2562;
      select_2568_s5_q <= equal_361_s4_q ? 24'h0 : select_2567;
      select_2573_s5_q <= equal_361_s4_q ? 24'h0 : select_2572;
      and_2576_s5_q <= and_2576_s4_q;
      select_2581_s5_q <= equal_361_s4_q ? 6'h0 : (equal_363_s4_q ? 6'h0 : select_2579);
      select_2586_s5_q <= equal_361_s4_q ? 12'h0 : (equal_363_s4_q ? 12'h0 : select_2584);
      select_2591_s5_q <= equal_361_s4_q ? 12'h0 : (equal_363_s4_q ? 12'h0 : select_2589);
      select_2597_s5_q <= equal_361_s4_q ? 12'h0 : (equal_363_s4_q ? 12'h0 : select_2595);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2340_s5_q;
  assign marks_nearer_o = and_2341_s5_q;
  assign verdict_valid_o = and_2279_s5_q;
  assign verdict_supervised_o = {2'h0, select_2346_s5_q};
  assign verdict_textured_o = {2'h0, select_2351_s5_q};
  assign verdict_explained_o = {2'h0, select_2356_s5_q};
  assign verdict_nearer_o = {2'h0, select_2361_s5_q};
  assign verdict_unproven_o = {2'h0, select_2366_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_2371_s5_q};
  assign verdict_unproven_yet_o = and_2378_s5_q;
  assign verdict_untextured_o = and_2385_s5_q;
  assign verdict_disagree_o = and_2397_s5_q;
  assign verdict_moved_o = and_2479_s5_q;
  assign verdict_unsharp_left_o = and_2492_s5_q;
  assign verdict_unsharp_right_o = and_2502_s5_q;
  assign verdict_hidden_o = and_2513_s5_q;
  assign verdict_across_0_o = select_2518_s5_q;
  assign verdict_across_1_o = select_2523_s5_q;
  assign verdict_across_2_o = select_2528_s5_q;
  assign verdict_across_3_o = select_2533_s5_q;
  assign verdict_measured_0_o = select_2538_s5_q;
  assign verdict_measured_1_o = select_2543_s5_q;
  assign verdict_measured_2_o = select_2548_s5_q;
  assign verdict_measured_3_o = select_2553_s5_q;
  assign verdict_detail_0_o = select_2558_s5_q;
  assign verdict_detail_1_o = select_2563_s5_q;
  assign verdict_contrast_0_o = select_2568_s5_q;
  assign verdict_contrast_1_o = select_2573_s5_q;
  assign region_valid_o = and_2576_s5_q;
  assign region_region_o = select_2581_s5_q;
  assign region_textured_o = select_2586_s5_q;
  assign region_explained_o = select_2591_s5_q;
  assign region_nearer_o = select_2597_s5_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2400[2:0], sum_1822[0], sum_1818[0], sum_1810[1:0], sum_1809[1:0], sum_1805[0], detail_4[1:0], detail_3[1:0], sum_1434[4:0], sum_865[8:0], sum_447[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
