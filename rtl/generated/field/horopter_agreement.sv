// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2471 bits, pipeline 1116 bits, memories 28508 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic saturated_i,
  input  logic mask_i,
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
  logic [3:0] sum_1587;
  assign sum_1587 = {2'h0, cfg_width_i[8:7]} + 4'hf;
  logic [5:0] sum_1594;
  assign sum_1594 = {1'b0, cfg_width_i[8:4]} + 6'h7;
  logic [5:0] sum_1621;
  assign sum_1621 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [7:0] limit;
  assign limit = {2'h0, cfg_moved_limit_i} + 8'hff;
  logic [6:0] difference_2068;
  assign difference_2068 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_2272;
  assign less_2272 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_2273;
  assign sum_2273 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_2274;
  assign select_2274 = less_2272 ? {sum_2273, cfg_height_i[5:3]} : 8'h0;
  logic not_2309;
  assign not_2309 = ~cfg_prove_i;

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
  logic [2:0] select_297;
  assign select_297 = left_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_299;
  assign select_299 = left_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:92
  logic [7:0] select_302;
  assign select_302 = ({select_299, select_297} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:93
  logic [7:0] select_303;
  assign select_303 = select_297[0] ? averager_place_q : select_302;
  // hls/stages/agreement.hpp:117
  logic and_305;
  assign and_305 = right_q & (~marks_first_i);
  // hls/stages/census.hpp:40
  logic or_306;
  assign or_306 = left_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:171
  logic and_312;
  assign and_312 = (~((~or_306) | (~select_297[0]))) & (select_303 < 8'hbd);
  // hls/stages/census.hpp:40
  logic [2:0] select_319;
  assign select_319 = left_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/census.hpp:45
  logic equal_331;
  assign equal_331 = select_297 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_332;
  assign equal_332 = select_319 == 3'h7;
  // hls/stages/census.hpp:102
  logic and_333;
  assign and_333 = equal_332 & and_312;
  // hls/stages/census.hpp:103
  logic and_334;
  assign and_334 = equal_331 & and_333;
  // hls/stages/agreement.hpp:333
  logic equal_349;
  assign equal_349 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:320
  logic not_350;
  assign not_350 = ~equal_349;
  // hls/stages/agreement.hpp:333
  logic equal_351;
  assign equal_351 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:390
  logic less_352;
  assign less_352 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:394
  logic not_353;
  assign not_353 = ~less_352;
  // hls/stages/agreement.hpp:298
  logic and_354;
  assign and_354 = equal_351 & not_353;
  logic and_355;
  assign and_355 = not_350 & and_354;
  // hls/stages/census.hpp:40
  logic [5:0] row;
  assign row = left_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:748
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:298
  logic and_439;
  assign and_439 = drew & not_353;
  // hls/stages/agreement.hpp:409
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:818
  logic or_935;
  assign or_935 = left_first_q | raster_row_ended_q;
  // hls/stages/agreement.hpp:819
  logic [8:0] select_936;
  assign select_936 = or_935 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:820
  logic [9:0] select_938;
  assign select_938 = left_first_q ? 10'h1 : (or_935 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:696
  logic [6:0] sum_1031;
  assign sum_1031 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/census.hpp:46
  logic [2:0] sum_1043;
  assign sum_1043 = select_297 + 3'h1;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_1046;
  assign select_1046 = and_305 ? (left_first_q ? sum_1043 : (and_305 ? sum_1043 : raster_at_x_q)) : raster_at_x_q;
  // hls/stages/census.hpp:52
  logic [2:0] select_1048;
  assign select_1048 = marks_last_i ? (select_319 + 3'h1) : select_319;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_1050;
  assign select_1050 = left_first_q ? select_1048 : (and_305 ? select_1048 : raster_at_y_q);
  // hls/stages/census.hpp:45
  logic [5:0] sum_1052;
  assign sum_1052 = select_299 + {5'h0, equal_331};
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1054;
  assign select_1054 = left_first_q ? sum_1052 : (and_305 ? sum_1052 : raster_at_column_q);
  // hls/stages/census.hpp:52
  logic [5:0] select_1057;
  assign select_1057 = marks_last_i ? (row + {5'h0, equal_332}) : row;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1059;
  assign select_1059 = left_first_q ? select_1057 : (and_305 ? select_1057 : raster_at_row_q);
  // hls/stages/census.hpp:52
  logic select_1063;
  assign select_1063 = marks_last_i ? (or_306 & (~raster_final_row_q)) : or_306;
  // hls/stages/agreement.hpp:176
  logic select_1065;
  assign select_1065 = left_first_q ? select_1063 : (and_305 ? select_1063 : raster_at_live_q);
  // hls/stages/census.hpp:44
  logic [8:0] select_1068;
  assign select_1068 = left_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, marks_last_i});
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1070;
  assign select_1070 = left_first_q ? cfg_height_i : (and_305 ? select_1068 : raster_rows_left_q);
  logic select_1073;
  assign select_1073 = left_first_q ? marks_last_i : (and_305 ? marks_last_i : raster_row_ended_q);
  // hls/stages/census.hpp:43
  logic equal_1075;
  assign equal_1075 = raster_rows_left_q == 9'h1;
  // hls/stages/agreement.hpp:176
  logic select_1077;
  assign select_1077 = left_first_q ? equal_1075 : (and_305 ? equal_1075 : raster_final_row_q);
  logic [7:0] select_1130;
  assign select_1130 = left_first_q ? select_303 : (and_305 ? select_303 : averager_place_q);
  // hls/stages/agreement.hpp:242
  logic equal_1486;
  assign equal_1486 = {last[7:6], select_299} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:169
  logic [2:0] select_1487;
  assign select_1487 = ends_q ? following_phase_q : run_phase_q;
  // hls/stages/agreement.hpp:173
  logic [2:0] select_1489;
  assign select_1489 = and_334 ? (equal_1486 ? 3'h1 : select_1487) : select_1487;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_1491;
  assign select_1491 = left_first_q ? select_1489 : (and_305 ? select_1489 : select_1487);
  // hls/stages/agreement.hpp:169
  logic [7:0] select_1493;
  assign select_1493 = ends_q ? following_lowest_q : run_lowest_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1495;
  assign select_1495 = and_334 ? (equal_1486 ? 8'h0 : select_1493) : select_1493;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1497;
  assign select_1497 = left_first_q ? select_1495 : (and_305 ? select_1495 : select_1493);
  // hls/stages/agreement.hpp:169
  logic [7:0] select_1499;
  assign select_1499 = ends_q ? following_highest_q : run_highest_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1501;
  assign select_1501 = and_334 ? (equal_1486 ? 8'h0 : select_1499) : select_1499;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1503;
  assign select_1503 = left_first_q ? select_1501 : (and_305 ? select_1501 : select_1499);
  // hls/stages/agreement.hpp:169
  logic [7:0] select_1505;
  assign select_1505 = ends_q ? following_beats_q : run_beats_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1507;
  assign select_1507 = and_334 ? (equal_1486 ? 8'hc : select_1505) : select_1505;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1509;
  assign select_1509 = left_first_q ? select_1507 : (and_305 ? select_1507 : select_1505);
  // hls/stages/agreement.hpp:169
  logic [5:0] select_1511;
  assign select_1511 = ends_q ? following_shift_q : run_shift_q;
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1513;
  assign select_1513 = and_334 ? (equal_1486 ? 6'h0 : select_1511) : select_1511;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1515;
  assign select_1515 = left_first_q ? select_1513 : (and_305 ? select_1513 : select_1511);
  // hls/stages/agreement.hpp:169
  logic select_1517;
  assign select_1517 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:243
  logic not_1518;
  assign not_1518 = ~equal_1486;
  // hls/stages/agreement.hpp:173
  logic select_1520;
  assign select_1520 = and_334 ? (select_1517 & not_1518) : select_1517;
  // hls/stages/agreement.hpp:176
  logic select_1522;
  assign select_1522 = left_first_q ? select_1520 : (and_305 ? select_1520 : select_1517);
  // hls/stages/agreement.hpp:325
  logic not_1524;
  assign not_1524 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:333
  logic equal_1525;
  assign equal_1525 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:150
  logic or_1526;
  assign or_1526 = equal_1525 | equal_351;
  logic [2:0] select_1527;
  assign select_1527 = equal_349 ? {run_last_shift_q, {2{not_1524}}} : {1'b0, or_1526, equal_351};
  logic [7:0] select_1530;
  assign select_1530 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [5:0] select_1531;
  assign select_1531 = equal_351 ? least_q : 6'h0;
  logic [7:0] select_1535;
  assign select_1535 = run_last_shift_q ? {2'h0, last_q} : (run_shift_q[5] ? {2'h0, last_q} : next_highest_q);
  logic [5:0] select_1537;
  assign select_1537 = equal_351 ? last_q : (equal_1525 ? last_q : 6'h0);
  logic [6:0] select_1541;
  assign select_1541 = equal_1525 ? whole_beats_q : 7'h0;
  logic [7:0] select_1543;
  assign select_1543 = equal_349 ? (run_last_shift_q ? {1'b0, whole_beats_q} : next_beats_q) : (equal_351 ? first_beats_q : {1'b0, select_1541});
  logic [5:0] select_1548;
  assign select_1548 = equal_349 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_351 ? (6'h0 - least_q) : 6'h0);
  // hls/stages/agreement.hpp:130
  logic not_1550;
  assign not_1550 = ~drew;
  // hls/stages/agreement.hpp:150
  logic select_1554;
  assign select_1554 = equal_349 ? (next_last_shift_q & not_1524) : (equal_351 & (least_q == 6'h0));
  // hls/stages/agreement.hpp:169
  logic [7:0] select_1557;
  assign select_1557 = ends_q ? following_lowest_q : (x_q + 8'h1);
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1559;
  assign select_1559 = and_334 ? (equal_1486 ? 8'h0 : select_1557) : select_1557;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1561;
  assign select_1561 = left_first_q ? select_1559 : (and_305 ? select_1559 : select_1557);
  // hls/stages/agreement.hpp:169
  logic [7:0] select_1564;
  assign select_1564 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1566;
  assign select_1566 = and_334 ? (equal_1486 ? 8'hc : select_1564) : select_1564;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1568;
  assign select_1568 = left_first_q ? select_1566 : (and_305 ? select_1566 : select_1564);
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1571;
  assign select_1571 = and_334 ? (equal_1486 ? select_299 : last_q) : last_q;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1574;
  assign select_1574 = and_305 ? (left_first_q ? select_1571 : (and_305 ? select_1571 : last_q)) : last_q;
  // hls/stages/agreement.hpp:249
  logic less_1580;
  assign less_1580 = 5'he < select_299[5:1];
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1583;
  assign select_1583 = and_334 ? (equal_1486 ? (less_1580 ? 6'h1e : select_299) : least_q) : least_q;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1586;
  assign select_1586 = and_305 ? (left_first_q ? select_1583 : (and_305 ? select_1583 : least_q)) : least_q;
  // hls/stages/agreement.hpp:243
  logic [7:0] select_1589;
  assign select_1589 = equal_1486 ? (less_1580 ? {sum_1587, cfg_width_i[6:3]} : 8'hf) : first_beats_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1590;
  assign select_1590 = and_334 ? select_1589 : first_beats_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_1592;
  assign select_1592 = left_first_q ? select_1590 : (and_305 ? select_1590 : first_beats_q);
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1596;
  assign select_1596 = and_334 ? (equal_1486 ? {sum_1594, cfg_width_i[3]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1598;
  assign select_1598 = left_first_q ? select_1596 : (and_305 ? select_1596 : whole_beats_q);
  // hls/stages/agreement.hpp:301
  logic not_1600;
  assign not_1600 = ~ends_q;
  // hls/stages/agreement.hpp:169
  logic [5:0] select_1601;
  assign select_1601 = ends_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1603;
  assign select_1603 = and_334 ? (equal_1486 ? 7'h0 : {select_1601, not_1600}) : {select_1601, not_1600};
  // hls/stages/agreement.hpp:176
  logic [6:0] select_1605;
  assign select_1605 = left_first_q ? select_1603 : (and_305 ? select_1603 : {select_1601, not_1600});
  // hls/stages/agreement.hpp:169
  logic and_1608;
  assign and_1608 = not_1600 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:173
  logic select_1610;
  assign select_1610 = and_334 ? (and_1608 & not_1518) : and_1608;
  // hls/stages/agreement.hpp:176
  logic select_1613;
  assign select_1613 = and_305 ? (left_first_q ? select_1610 : (and_305 ? select_1610 : and_1608)) : and_1608;
  // hls/stages/agreement.hpp:261
  logic [6:0] sum_1614;
  assign sum_1614 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:243
  logic select_1616;
  assign select_1616 = equal_1486 ? ({sum_1614[6], cfg_height_i[8:3]} == {1'b0, sum_1614[5:0]}) : final_row_q;
  // hls/stages/agreement.hpp:173
  logic select_1617;
  assign select_1617 = and_334 ? select_1616 : final_row_q;
  // hls/stages/agreement.hpp:176
  logic select_1619;
  assign select_1619 = left_first_q ? select_1617 : (and_305 ? select_1617 : final_row_q);
  // hls/stages/agreement.hpp:608
  logic [4:0] sum_1758;
  assign sum_1758 = {1'b0, last_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:143
  logic not_2141;
  assign not_2141 = ~run_shift_q[5];
  // hls/stages/agreement.hpp:176
  logic [9:0] select_2252;
  assign select_2252 = and_305 ? (left_first_q ? 10'h1 : (and_305 ? select_938 : rows_passed_q)) : rows_passed_q;
  logic [8:0] select_2254;
  assign select_2254 = left_first_q ? {select_936[7:0], or_935} : (and_305 ? {select_936[7:0], or_935} : columns_passed_q);

  // Memory fresh, 47 x 28, DISTANCE 12, hls/stages/agreement.hpp:885; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 28'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_355;
  logic [27:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 73, DISTANCE 12, hls/stages/agreement.hpp:886; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [72:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 73'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (equal_349 ? not_353 : (equal_351 ? not_353 : and_439));
  logic [72:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:887; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_349 ? (run_shift_q + x_q[5:0]) : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (equal_349 ? not_353 : and_354);
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
      left_first_q <= and_305 ? left_first_q : marks_first_i;
      right_q <= (~and_305) & (~marks_last_i);
      raster_at_x_q <= select_1046;
      raster_at_y_q <= and_305 ? select_1050 : raster_at_y_q;
      raster_at_column_q <= and_305 ? select_1054 : raster_at_column_q;
      raster_at_row_q <= and_305 ? select_1059 : raster_at_row_q;
      raster_at_live_q <= and_305 ? select_1065 : raster_at_live_q;
      raster_rows_left_q <= and_305 ? select_1070 : raster_rows_left_q;
      raster_row_ended_q <= and_305 ? select_1073 : raster_row_ended_q;
      raster_final_row_q <= and_305 ? select_1077 : raster_final_row_q;
      averager_place_q <= and_305 ? select_1130 : averager_place_q;
      run_phase_q <= and_305 ? select_1491 : select_1487;
      run_lowest_q <= and_305 ? select_1497 : select_1493;
      run_highest_q <= and_305 ? select_1503 : select_1499;
      run_beats_q <= and_305 ? select_1509 : select_1505;
      run_shift_q <= and_305 ? select_1515 : select_1511;
      run_last_shift_q <= and_305 ? select_1522 : select_1517;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1527;
      following_lowest_q <= drew ? 8'h0 : (equal_349 ? select_1530 : {2'h0, select_1531});
      following_highest_q <= drew ? 8'h0 : (equal_349 ? select_1535 : {2'h0, select_1537});
      following_beats_q <= drew ? 8'h3f : select_1543;
      following_shift_q <= drew ? 6'h0 : select_1548;
      following_last_shift_q <= not_1550 & select_1554;
      x_q <= and_305 ? select_1561 : select_1557;
      beats_left_q <= and_305 ? select_1568 : select_1564;
      last_q <= select_1574;
      least_q <= select_1586;
      first_beats_q <= and_305 ? select_1592 : first_beats_q;
      whole_beats_q <= and_305 ? select_1598 : whole_beats_q;
      age_q <= and_305 ? select_1605 : {select_1601, not_1600};
      ends_q <= select_1613;
      final_row_q <= and_305 ? select_1619 : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_2141}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{2{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 8'hff);
      rows_passed_q <= select_2252;
      columns_passed_q <= and_305 ? select_2254 : columns_passed_q;
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
  logic select_297_s1_q;
  logic [5:0] select_299_s1_q;
  logic [7:0] select_303_s1_q;
  logic and_305_s1_q;
  logic and_312_s1_q;
  logic equal_320_s1_q;
  logic and_333_s1_q;
  logic and_334_s1_q;
  logic equal_340_s1_q;
  logic equal_349_s1_q;
  logic not_350_s1_q;
  logic equal_351_s1_q;
  logic less_352_s1_q;
  logic not_353_s1_q;
  logic and_355_s1_q;
  logic [5:0] row_s1_q;
  logic drew_s1_q;
  logic and_439_s1_q;
  logic [6:0] x_s1_2_q;
  logic and_490_s1_q;
  logic equal_496_s1_q;
  logic equal_563_s1_q;
  logic equal_800_s1_q;
  logic equal_864_s1_q;
  logic equal_887_s1_q;
  logic equal_890_s1_q;
  logic and_939_s1_q;
  logic not_1033_s1_q;
  logic equal_1486_s1_q;
  logic not_1550_s1_q;
  logic less_1759_s1_q;
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
      select_297_s1_q <= select_297[0];
      select_299_s1_q <= select_299;
      select_303_s1_q <= select_303;
      and_305_s1_q <= and_305;
      and_312_s1_q <= and_312;
      equal_320_s1_q <= select_319 == 3'h0;
      and_333_s1_q <= and_333;
      and_334_s1_q <= and_334;
      equal_340_s1_q <= select_297 == 3'h1;
      equal_349_s1_q <= equal_349;
      not_350_s1_q <= not_350;
      equal_351_s1_q <= equal_351;
      less_352_s1_q <= less_352;
      not_353_s1_q <= not_353;
      and_355_s1_q <= and_355;
      row_s1_q <= row;
      drew_s1_q <= drew;
      and_439_s1_q <= and_439;
      x_s1_2_q <= x[6:0];
      and_490_s1_q <= age_q[2] & (~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q}));
      equal_496_s1_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      equal_563_s1_q <= run_lowest_q == x_q;
      equal_800_s1_q <= run_lowest_q == x;
      equal_864_s1_q <= run_highest_q == x;
      equal_887_s1_q <= x_q == {2'h0, last_q};
      equal_890_s1_q <= run_phase_q == 3'h5;
      and_939_s1_q <= select_936[8] & select_938[9];
      not_1033_s1_q <= ~({sum_1031, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1486_s1_q <= equal_1486;
      not_1550_s1_q <= not_1550;
      less_1759_s1_q <= {2'h0, sum_1758, last_q[1]} < x_q;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:365
  logic equal_443;
  assign equal_443 = row_q == 6'h0;
  logic [11:0] select_444;
  assign select_444 = equal_443 ? 12'h0 : left_rdata_q[11:0];
  logic not_445;
  assign not_445 = ~equal_443;
  logic and_446;
  assign and_446 = left_rdata_q[12] & not_445;
  logic and_447;
  assign and_447 = left_rdata_q[13] & not_445;
  logic and_448;
  assign and_448 = left_rdata_q[14] & not_445;
  logic equal_449;
  assign equal_449 = row_q[5:1] == 5'h0;
  logic [11:0] select_450;
  assign select_450 = equal_449 ? 12'h0 : left_rdata_q[26:15];
  logic not_451;
  assign not_451 = ~equal_449;
  logic and_452;
  assign and_452 = left_rdata_q[27] & not_451;
  logic and_453;
  assign and_453 = left_rdata_q[28] & not_451;
  logic and_454;
  assign and_454 = left_rdata_q[29] & not_451;
  logic less_455;
  assign less_455 = row_q < 6'h3;
  logic [11:0] select_456;
  assign select_456 = less_455 ? 12'h0 : left_rdata_q[41:30];
  logic not_457;
  assign not_457 = ~less_455;
  logic and_458;
  assign and_458 = left_rdata_q[42] & not_457;
  logic and_459;
  assign and_459 = left_rdata_q[43] & not_457;
  logic and_460;
  assign and_460 = left_rdata_q[44] & not_457;
  logic equal_461;
  assign equal_461 = row_q[5:2] == 4'h0;
  logic [11:0] select_462;
  assign select_462 = equal_461 ? 12'h0 : left_rdata_q[56:45];
  logic not_463;
  assign not_463 = ~equal_461;
  logic and_464;
  assign and_464 = left_rdata_q[57] & not_463;
  // hls/stages/agreement.hpp:366
  logic [11:0] select_469;
  assign select_469 = equal_443 ? 12'h0 : right_codes_rdata_q[11:0];
  logic and_470;
  assign and_470 = right_codes_rdata_q[12] & not_445;
  logic [11:0] select_471;
  assign select_471 = equal_449 ? 12'h0 : right_codes_rdata_q[24:13];
  logic and_472;
  assign and_472 = right_codes_rdata_q[25] & not_451;
  logic [11:0] select_473;
  assign select_473 = less_455 ? 12'h0 : right_codes_rdata_q[37:26];
  logic and_474;
  assign and_474 = right_codes_rdata_q[38] & not_457;
  logic [11:0] select_475;
  assign select_475 = equal_461 ? 12'h0 : right_codes_rdata_q[50:39];
  logic and_476;
  assign and_476 = right_codes_rdata_q[51] & not_463;
  logic less_477;
  assign less_477 = row_q < 6'h5;
  logic [11:0] select_478;
  assign select_478 = less_477 ? 12'h0 : right_codes_rdata_q[63:52];
  logic and_480;
  assign and_480 = right_codes_rdata_q[64] & (~less_477);
  logic less_481;
  assign less_481 = row_q[5:1] < 5'h3;
  logic [11:0] select_482;
  assign select_482 = less_481 ? 12'h0 : right_codes_rdata_q[76:65];
  logic and_484;
  assign and_484 = right_codes_rdata_q[77] & (~less_481);
  // hls/stages/agreement.hpp:318
  logic not_491;
  assign not_491 = ~equal_351_s1_q;
  // hls/stages/agreement.hpp:298
  logic and_492;
  assign and_492 = not_491 & and_439_s1_q;
  logic select_493;
  assign select_493 = equal_349_s1_q ? and_490_s1_q : and_492;
  // hls/stages/agreement.hpp:159
  logic and_502;
  assign and_502 = left_rdata_q[42] & not_353_s1_q;
  logic [11:0] a;
  assign a = less_352_s1_q ? 12'h0 : left_rdata_q[41:30];
  logic [11:0] b;
  assign b = less_352_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_508;
  assign not_508 = ~(a ^ b);
  logic [1:0] sum_510;
  assign sum_510 = {1'b0, not_508[2]} + ({1'b0, not_508[0]} + {1'b0, not_508[1]});
  logic [2:0] sum_513;
  assign sum_513 = {2'h0, not_508[5]} + ({2'h0, not_508[4]} + ({2'h0, not_508[3]} + {1'b0, sum_510}));
  logic [2:0] sum_514;
  assign sum_514 = {2'h0, not_508[6]} + sum_513;
  logic [3:0] sum_517;
  assign sum_517 = {3'h0, not_508[9]} + ({3'h0, not_508[8]} + ({3'h0, not_508[7]} + {1'b0, sum_514}));
  // hls/stages/agreement.hpp:159
  logic [11:0] a_2;
  assign a_2 = less_352_s1_q ? 12'h0 : left_rdata_q[56:45];
  logic [11:0] b_2;
  assign b_2 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_527;
  assign not_527 = ~(a_2 ^ b_2);
  logic [1:0] sum_529;
  assign sum_529 = {1'b0, not_527[2]} + ({1'b0, not_527[0]} + {1'b0, not_527[1]});
  logic [2:0] sum_532;
  assign sum_532 = {2'h0, not_527[5]} + ({2'h0, not_527[4]} + ({2'h0, not_527[3]} + {1'b0, sum_529}));
  logic [2:0] sum_533;
  assign sum_533 = {2'h0, not_527[6]} + sum_532;
  logic [3:0] sum_536;
  assign sum_536 = {3'h0, not_527[9]} + ({3'h0, not_527[8]} + ({3'h0, not_527[7]} + {1'b0, sum_533}));
  // hls/stages/agreement.hpp:159
  logic and_541;
  assign and_541 = left_rdata_q[72] & not_353_s1_q;
  logic [11:0] a_3;
  assign a_3 = less_352_s1_q ? 12'h0 : left_rdata_q[71:60];
  logic [11:0] b_3;
  assign b_3 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_547;
  assign not_547 = ~(a_3 ^ b_3);
  logic [1:0] sum_549;
  assign sum_549 = {1'b0, not_547[2]} + ({1'b0, not_547[0]} + {1'b0, not_547[1]});
  logic [2:0] sum_552;
  assign sum_552 = {2'h0, not_547[5]} + ({2'h0, not_547[4]} + ({2'h0, not_547[3]} + {1'b0, sum_549}));
  logic [2:0] sum_553;
  assign sum_553 = {2'h0, not_547[6]} + sum_552;
  logic [3:0] sum_556;
  assign sum_556 = {3'h0, not_547[9]} + ({3'h0, not_547[8]} + ({3'h0, not_547[7]} + {1'b0, sum_553}));
  logic [11:0] not_568;
  assign not_568 = ~(a ^ b_2);
  logic [1:0] sum_570;
  assign sum_570 = {1'b0, not_568[2]} + ({1'b0, not_568[0]} + {1'b0, not_568[1]});
  logic [2:0] sum_573;
  assign sum_573 = {2'h0, not_568[5]} + ({2'h0, not_568[4]} + ({2'h0, not_568[3]} + {1'b0, sum_570}));
  logic [2:0] sum_574;
  assign sum_574 = {2'h0, not_568[6]} + sum_573;
  logic [3:0] sum_577;
  assign sum_577 = {3'h0, not_568[9]} + ({3'h0, not_568[8]} + ({3'h0, not_568[7]} + {1'b0, sum_574}));
  logic [11:0] not_583;
  assign not_583 = ~(a_2 ^ b_3);
  logic [1:0] sum_585;
  assign sum_585 = {1'b0, not_583[2]} + ({1'b0, not_583[0]} + {1'b0, not_583[1]});
  logic [2:0] sum_588;
  assign sum_588 = {2'h0, not_583[5]} + ({2'h0, not_583[4]} + ({2'h0, not_583[3]} + {1'b0, sum_585}));
  logic [2:0] sum_589;
  assign sum_589 = {2'h0, not_583[6]} + sum_588;
  logic [3:0] sum_592;
  assign sum_592 = {3'h0, not_583[9]} + ({3'h0, not_583[8]} + ({3'h0, not_583[7]} + {1'b0, sum_589}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_4;
  assign b_4 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_601;
  assign not_601 = ~(a_3 ^ b_4);
  logic [1:0] sum_603;
  assign sum_603 = {1'b0, not_601[2]} + ({1'b0, not_601[0]} + {1'b0, not_601[1]});
  logic [2:0] sum_606;
  assign sum_606 = {2'h0, not_601[5]} + ({2'h0, not_601[4]} + ({2'h0, not_601[3]} + {1'b0, sum_603}));
  logic [2:0] sum_607;
  assign sum_607 = {2'h0, not_601[6]} + sum_606;
  logic [3:0] sum_610;
  assign sum_610 = {3'h0, not_601[9]} + ({3'h0, not_601[8]} + ({3'h0, not_601[7]} + {1'b0, sum_607}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_5;
  assign b_5 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_625;
  assign not_625 = ~(a ^ b_5);
  logic [1:0] sum_627;
  assign sum_627 = {1'b0, not_625[2]} + ({1'b0, not_625[0]} + {1'b0, not_625[1]});
  logic [2:0] sum_630;
  assign sum_630 = {2'h0, not_625[5]} + ({2'h0, not_625[4]} + ({2'h0, not_625[3]} + {1'b0, sum_627}));
  logic [2:0] sum_631;
  assign sum_631 = {2'h0, not_625[6]} + sum_630;
  logic [3:0] sum_634;
  assign sum_634 = {3'h0, not_625[9]} + ({3'h0, not_625[8]} + ({3'h0, not_625[7]} + {1'b0, sum_631}));
  logic [11:0] not_640;
  assign not_640 = ~(a_2 ^ b);
  logic [1:0] sum_642;
  assign sum_642 = {1'b0, not_640[2]} + ({1'b0, not_640[0]} + {1'b0, not_640[1]});
  logic [2:0] sum_645;
  assign sum_645 = {2'h0, not_640[5]} + ({2'h0, not_640[4]} + ({2'h0, not_640[3]} + {1'b0, sum_642}));
  logic [2:0] sum_646;
  assign sum_646 = {2'h0, not_640[6]} + sum_645;
  logic [3:0] sum_649;
  assign sum_649 = {3'h0, not_640[9]} + ({3'h0, not_640[8]} + ({3'h0, not_640[7]} + {1'b0, sum_646}));
  logic [11:0] not_656;
  assign not_656 = ~(a_3 ^ b_2);
  logic [1:0] sum_658;
  assign sum_658 = {1'b0, not_656[2]} + ({1'b0, not_656[0]} + {1'b0, not_656[1]});
  logic [2:0] sum_661;
  assign sum_661 = {2'h0, not_656[5]} + ({2'h0, not_656[4]} + ({2'h0, not_656[3]} + {1'b0, sum_658}));
  logic [2:0] sum_662;
  assign sum_662 = {2'h0, not_656[6]} + sum_661;
  logic [3:0] sum_665;
  assign sum_665 = {3'h0, not_656[9]} + ({3'h0, not_656[8]} + ({3'h0, not_656[7]} + {1'b0, sum_662}));
  logic [11:0] not_680;
  assign not_680 = ~(a ^ b_3);
  logic [1:0] sum_682;
  assign sum_682 = {1'b0, not_680[2]} + ({1'b0, not_680[0]} + {1'b0, not_680[1]});
  logic [2:0] sum_685;
  assign sum_685 = {2'h0, not_680[5]} + ({2'h0, not_680[4]} + ({2'h0, not_680[3]} + {1'b0, sum_682}));
  logic [2:0] sum_686;
  assign sum_686 = {2'h0, not_680[6]} + sum_685;
  logic [3:0] sum_689;
  assign sum_689 = {3'h0, not_680[9]} + ({3'h0, not_680[8]} + ({3'h0, not_680[7]} + {1'b0, sum_686}));
  logic [11:0] not_695;
  assign not_695 = ~(a_2 ^ b_4);
  logic [1:0] sum_697;
  assign sum_697 = {1'b0, not_695[2]} + ({1'b0, not_695[0]} + {1'b0, not_695[1]});
  logic [2:0] sum_700;
  assign sum_700 = {2'h0, not_695[5]} + ({2'h0, not_695[4]} + ({2'h0, not_695[3]} + {1'b0, sum_697}));
  logic [2:0] sum_701;
  assign sum_701 = {2'h0, not_695[6]} + sum_700;
  logic [3:0] sum_704;
  assign sum_704 = {3'h0, not_695[9]} + ({3'h0, not_695[8]} + ({3'h0, not_695[7]} + {1'b0, sum_701}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_6;
  assign b_6 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[89:78];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_713;
  assign not_713 = ~(a_3 ^ b_6);
  logic [1:0] sum_715;
  assign sum_715 = {1'b0, not_713[2]} + ({1'b0, not_713[0]} + {1'b0, not_713[1]});
  logic [2:0] sum_718;
  assign sum_718 = {2'h0, not_713[5]} + ({2'h0, not_713[4]} + ({2'h0, not_713[3]} + {1'b0, sum_715}));
  logic [2:0] sum_719;
  assign sum_719 = {2'h0, not_713[6]} + sum_718;
  logic [3:0] sum_722;
  assign sum_722 = {3'h0, not_713[9]} + ({3'h0, not_713[8]} + ({3'h0, not_713[7]} + {1'b0, sum_719}));
  // hls/stages/agreement.hpp:159
  logic [11:0] b_7;
  assign b_7 = less_352_s1_q ? 12'h0 : right_codes_rdata_q[11:0];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_742;
  assign not_742 = ~(a ^ b_7);
  logic [1:0] sum_744;
  assign sum_744 = {1'b0, not_742[2]} + ({1'b0, not_742[0]} + {1'b0, not_742[1]});
  logic [2:0] sum_747;
  assign sum_747 = {2'h0, not_742[5]} + ({2'h0, not_742[4]} + ({2'h0, not_742[3]} + {1'b0, sum_744}));
  logic [2:0] sum_748;
  assign sum_748 = {2'h0, not_742[6]} + sum_747;
  logic [3:0] sum_751;
  assign sum_751 = {3'h0, not_742[9]} + ({3'h0, not_742[8]} + ({3'h0, not_742[7]} + {1'b0, sum_748}));
  logic [11:0] not_757;
  assign not_757 = ~(a_2 ^ b_5);
  logic [1:0] sum_759;
  assign sum_759 = {1'b0, not_757[2]} + ({1'b0, not_757[0]} + {1'b0, not_757[1]});
  logic [2:0] sum_762;
  assign sum_762 = {2'h0, not_757[5]} + ({2'h0, not_757[4]} + ({2'h0, not_757[3]} + {1'b0, sum_759}));
  logic [2:0] sum_763;
  assign sum_763 = {2'h0, not_757[6]} + sum_762;
  logic [3:0] sum_766;
  assign sum_766 = {3'h0, not_757[9]} + ({3'h0, not_757[8]} + ({3'h0, not_757[7]} + {1'b0, sum_763}));
  logic [11:0] not_773;
  assign not_773 = ~(a_3 ^ b);
  logic [1:0] sum_775;
  assign sum_775 = {1'b0, not_773[2]} + ({1'b0, not_773[0]} + {1'b0, not_773[1]});
  logic [2:0] sum_778;
  assign sum_778 = {2'h0, not_773[5]} + ({2'h0, not_773[4]} + ({2'h0, not_773[3]} + {1'b0, sum_775}));
  logic [2:0] sum_779;
  assign sum_779 = {2'h0, not_773[6]} + sum_778;
  logic [3:0] sum_782;
  assign sum_782 = {3'h0, not_773[9]} + ({3'h0, not_773[8]} + ({3'h0, not_773[7]} + {1'b0, sum_779}));
  // hls/stages/agreement.hpp:573
  logic not_899;
  assign not_899 = ~(row_q[5:3] == 3'h0);
  // hls/stages/agreement.hpp:298
  logic and_1035;
  assign and_1035 = drew_s1_q & (((6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0))) & not_1033_s1_q);
  // hls/stages/agreement.hpp:173
  logic [5:0] select_1576;
  assign select_1576 = and_334_s1_q ? (equal_1486_s1_q ? row_s1_q : row_q) : row_q;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_1578;
  assign select_1578 = left_first_s1_q ? select_1576 : (and_305_s1_q ? select_1576 : row_q);
  // hls/stages/agreement.hpp:243
  logic select_1624;
  assign select_1624 = equal_1486_s1_q ? (~({row_s1_q, 1'b0} < {sum_1621, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:173
  logic select_1625;
  assign select_1625 = and_334_s1_q ? select_1624 : lower_half_q;
  // hls/stages/agreement.hpp:176
  logic select_1627;
  assign select_1627 = left_first_s1_q ? select_1625 : (and_305_s1_q ? select_1625 : lower_half_q);

  // Memory best_left, 47 x 22, DISTANCE 12, hls/stages/agreement.hpp:888; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 22'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = equal_349_s1_q ? x_s1_2_q[5:0] : x_s1_q[5:0];
  logic best_left_re;
  assign best_left_re = s1_en & select_493;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_355_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_464, select_462, and_460, and_459, and_458, select_456, and_454, and_453, and_452, select_450, and_448, and_447, and_446, select_444, fresh_rdata_q[27:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_355_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_484, select_482, and_480, select_478, and_476, select_475, and_474, select_473, and_472, select_471, and_470, select_469, fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_305_s1_q ? select_1578 : row_q;
      lower_half_q <= and_305_s1_q ? select_1627 : lower_half_q;
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
  logic select_297_s2_q;
  logic [5:0] select_299_s2_q;
  logic [7:0] select_303_s2_q;
  logic and_305_s2_q;
  logic and_312_s2_q;
  logic equal_320_s2_q;
  logic and_333_s2_q;
  logic and_334_s2_q;
  logic equal_340_s2_q;
  logic equal_349_s2_q;
  logic not_350_s2_q;
  logic equal_351_s2_q;
  logic less_352_s2_q;
  logic not_353_s2_q;
  logic equal_383_s2_q;
  logic drew_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_491_s2_q;
  logic select_493_s2_q;
  logic equal_496_s2_q;
  logic and_502_s2_q;
  logic and_503_s2_q;
  logic not_508_s2_q;
  logic [3:0] sum_518_s2_q;
  logic and_521_s2_q;
  logic and_522_s2_q;
  logic not_527_s2_q;
  logic [3:0] sum_537_s2_q;
  logic and_541_s2_q;
  logic and_542_s2_q;
  logic not_547_s2_q;
  logic [3:0] sum_557_s2_q;
  logic equal_563_s2_q;
  logic not_568_s2_q;
  logic [3:0] sum_578_s2_q;
  logic not_583_s2_q;
  logic [3:0] sum_593_s2_q;
  logic and_597_s2_q;
  logic not_601_s2_q;
  logic [3:0] sum_611_s2_q;
  logic and_621_s2_q;
  logic not_625_s2_q;
  logic [3:0] sum_635_s2_q;
  logic not_640_s2_q;
  logic [3:0] sum_650_s2_q;
  logic not_656_s2_q;
  logic [3:0] sum_666_s2_q;
  logic not_680_s2_q;
  logic [3:0] sum_690_s2_q;
  logic not_695_s2_q;
  logic [3:0] sum_705_s2_q;
  logic and_710_s2_q;
  logic not_713_s2_q;
  logic [3:0] sum_723_s2_q;
  logic and_739_s2_q;
  logic not_742_s2_q;
  logic [3:0] sum_752_s2_q;
  logic not_757_s2_q;
  logic [3:0] sum_767_s2_q;
  logic not_773_s2_q;
  logic [3:0] sum_783_s2_q;
  logic equal_800_s2_q;
  logic and_858_s2_q;
  logic equal_864_s2_q;
  logic equal_887_s2_q;
  logic equal_890_s2_q;
  logic and_901_s2_q;
  logic and_931_s2_q;
  logic and_939_s2_q;
  logic and_1037_s2_q;
  logic equal_1399_s2_q;
  logic equal_1486_s2_q;
  logic not_1550_s2_q;
  logic and_1674_s2_q;
  logic less_1756_s2_q;
  logic less_1759_s2_q;
  logic equal_2024_s2_q;
  logic less_2039_s2_q;
  logic equal_2216_s2_q;
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
      select_297_s2_q <= select_297_s1_q;
      select_299_s2_q <= select_299_s1_q;
      select_303_s2_q <= select_303_s1_q;
      and_305_s2_q <= and_305_s1_q;
      and_312_s2_q <= and_312_s1_q;
      equal_320_s2_q <= equal_320_s1_q;
      and_333_s2_q <= and_333_s1_q;
      and_334_s2_q <= and_334_s1_q;
      equal_340_s2_q <= equal_340_s1_q;
      equal_349_s2_q <= equal_349_s1_q;
      not_350_s2_q <= not_350_s1_q;
      equal_351_s2_q <= equal_351_s1_q;
      less_352_s2_q <= less_352_s1_q;
      not_353_s2_q <= not_353_s1_q;
      equal_383_s2_q <= row_s1_q == 6'h0;
      drew_s2_q <= drew_s1_q;
      x_s2_2_q <= x_s1_2_q;
      not_491_s2_q <= not_491;
      select_493_s2_q <= select_493;
      equal_496_s2_q <= equal_496_s1_q;
      and_502_s2_q <= and_502;
      and_503_s2_q <= right_codes_rdata_q[38] & not_353_s1_q;
      not_508_s2_q <= not_508[11];
      sum_518_s2_q <= {3'h0, not_508[10]} + sum_517;
      and_521_s2_q <= left_rdata_q[57] & not_353_s1_q;
      and_522_s2_q <= right_codes_rdata_q[51] & not_353_s1_q;
      not_527_s2_q <= not_527[11];
      sum_537_s2_q <= {3'h0, not_527[10]} + sum_536;
      and_541_s2_q <= and_541;
      and_542_s2_q <= right_codes_rdata_q[64] & not_353_s1_q;
      not_547_s2_q <= not_547[11];
      sum_557_s2_q <= {3'h0, not_547[10]} + sum_556;
      equal_563_s2_q <= equal_563_s1_q;
      not_568_s2_q <= not_568[11];
      sum_578_s2_q <= {3'h0, not_568[10]} + sum_577;
      not_583_s2_q <= not_583[11];
      sum_593_s2_q <= {3'h0, not_583[10]} + sum_592;
      and_597_s2_q <= right_codes_rdata_q[77] & not_353_s1_q;
      not_601_s2_q <= not_601[11];
      sum_611_s2_q <= {3'h0, not_601[10]} + sum_610;
      and_621_s2_q <= right_codes_rdata_q[25] & not_353_s1_q;
      not_625_s2_q <= not_625[11];
      sum_635_s2_q <= {3'h0, not_625[10]} + sum_634;
      not_640_s2_q <= not_640[11];
      sum_650_s2_q <= {3'h0, not_640[10]} + sum_649;
      not_656_s2_q <= not_656[11];
      sum_666_s2_q <= {3'h0, not_656[10]} + sum_665;
      not_680_s2_q <= not_680[11];
      sum_690_s2_q <= {3'h0, not_680[10]} + sum_689;
      not_695_s2_q <= not_695[11];
      sum_705_s2_q <= {3'h0, not_695[10]} + sum_704;
      and_710_s2_q <= and_541 & (right_codes_rdata_q[90] & not_353_s1_q);
      not_713_s2_q <= not_713[11];
      sum_723_s2_q <= {3'h0, not_713[10]} + sum_722;
      and_739_s2_q <= and_502 & (right_codes_rdata_q[12] & not_353_s1_q);
      not_742_s2_q <= not_742[11];
      sum_752_s2_q <= {3'h0, not_742[10]} + sum_751;
      not_757_s2_q <= not_757[11];
      sum_767_s2_q <= {3'h0, not_757[10]} + sum_766;
      not_773_s2_q <= not_773[11];
      sum_783_s2_q <= {3'h0, not_773[10]} + sum_782;
      equal_800_s2_q <= equal_800_s1_q;
      and_858_s2_q <= equal_349_s1_q & and_490_s1_q;
      equal_864_s2_q <= equal_864_s1_q;
      equal_887_s2_q <= equal_887_s1_q;
      equal_890_s2_q <= equal_890_s1_q;
      and_901_s2_q <= left_rdata_q[58] & (left_rdata_q[59] & not_899);
      and_931_s2_q <= not_350_s1_q & and_492;
      and_939_s2_q <= and_939_s1_q;
      and_1037_s2_q <= not_350_s1_q & (not_491 & and_1035);
      equal_1399_s2_q <= (select_299_s1_q | row_s1_q) == 6'h0;
      equal_1486_s2_q <= equal_1486_s1_q;
      not_1550_s2_q <= not_1550_s1_q;
      and_1674_s2_q <= left_rdata_q[58] & not_899;
      less_1756_s2_q <= 5'h4 < row_q[5:1];
      less_1759_s2_q <= less_1759_s1_q;
      equal_2024_s2_q <= row_s1_q[5:2] == 4'h0;
      less_2039_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_2216_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [23:0] slope_row_q;
  logic [27:0] slope_change_q;
  logic [27:0] slope_q;
  logic [23:0] next_slope_row_q;
  logic [27:0] next_slope_change_q;
  // hls/stages/census.hpp:96
  logic and_313;
  assign and_313 = and_305_s2_q & and_312_s2_q;
  // hls/stages/agreement.hpp:176
  logic select_315;
  assign select_315 = and_305_s2_q ? (left_first_s2_q ? and_312_s2_q : and_313) : and_313;
  // hls/stages/agreement.hpp:237
  logic and_335;
  assign and_335 = and_305_s2_q & and_334_s2_q;
  // hls/stages/agreement.hpp:176
  logic select_337;
  assign select_337 = and_305_s2_q ? (left_first_s2_q ? and_334_s2_q : and_335) : and_335;
  // hls/stages/agreement.hpp:375
  logic [3:0] column;
  assign column = (and_502_s2_q & and_503_s2_q) ? ({3'h0, not_508_s2_q} + sum_518_s2_q) : 4'h0;
  logic [3:0] select_539;
  assign select_539 = (and_521_s2_q & and_522_s2_q) ? ({3'h0, not_527_s2_q} + sum_537_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_2;
  assign column_2 = {1'b0, column} + {1'b0, select_539};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_559;
  assign select_559 = (and_541_s2_q & and_542_s2_q) ? ({3'h0, not_547_s2_q} + sum_557_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_559};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_562;
  assign difference_562 = {2'h0, column_3} - (age_s2_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] sum_565;
  assign sum_565 = difference_562 + (equal_563_s2_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:375
  logic [3:0] column_4;
  assign column_4 = (and_502_s2_q & and_522_s2_q) ? ({3'h0, not_568_s2_q} + sum_578_s2_q) : 4'h0;
  logic [3:0] select_595;
  assign select_595 = (and_521_s2_q & and_542_s2_q) ? ({3'h0, not_583_s2_q} + sum_593_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4} + {1'b0, select_595};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_613;
  assign select_613 = (and_541_s2_q & and_597_s2_q) ? ({3'h0, not_601_s2_q} + sum_611_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_613};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_616;
  assign difference_616 = {2'h0, column_6} - (age_s2_q[1] ? sums_1_columns_values_6_q : 8'h0);
  logic [7:0] sum_618;
  assign sum_618 = difference_616 + (equal_563_s2_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic less_619;
  assign less_619 = sum_565 < sum_618;
  // hls/stages/agreement.hpp:375
  logic [3:0] column_7;
  assign column_7 = (and_502_s2_q & and_621_s2_q) ? ({3'h0, not_625_s2_q} + sum_635_s2_q) : 4'h0;
  logic [3:0] select_652;
  assign select_652 = (and_521_s2_q & and_503_s2_q) ? ({3'h0, not_640_s2_q} + sum_650_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7} + {1'b0, select_652};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_668;
  assign select_668 = (and_541_s2_q & and_522_s2_q) ? ({3'h0, not_656_s2_q} + sum_666_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_668};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_671;
  assign difference_671 = {2'h0, column_9} - (age_s2_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] sum_673;
  assign sum_673 = difference_671 + (equal_563_s2_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic not_675;
  assign not_675 = ~less_619;
  logic [1:0] best;
  assign best = ((less_619 ? sum_618 : sum_565) < sum_673) ? 2'h3 : {not_675, less_619};
  // hls/stages/agreement.hpp:375
  logic [3:0] column_10;
  assign column_10 = (and_502_s2_q & and_542_s2_q) ? ({3'h0, not_680_s2_q} + sum_690_s2_q) : 4'h0;
  logic [3:0] select_707;
  assign select_707 = (and_521_s2_q & and_597_s2_q) ? ({3'h0, not_695_s2_q} + sum_705_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10} + {1'b0, select_707};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_725;
  assign select_725 = and_710_s2_q ? ({3'h0, not_713_s2_q} + sum_723_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_725};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_728;
  assign difference_728 = {2'h0, column_12} - (age_s2_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] sum_730;
  assign sum_730 = difference_728 + (equal_563_s2_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:418
  logic [7:0] select_732;
  assign select_732 = best[1] ? (best[0] ? sum_673 : sum_565) : (best[0] ? sum_618 : sum_730);
  logic [1:0] best_2;
  assign best_2 = (select_732 < sum_730) ? 2'h0 : best;
  // hls/stages/agreement.hpp:375
  logic [3:0] column_13;
  assign column_13 = and_739_s2_q ? ({3'h0, not_742_s2_q} + sum_752_s2_q) : 4'h0;
  logic [3:0] select_769;
  assign select_769 = (and_521_s2_q & and_621_s2_q) ? ({3'h0, not_757_s2_q} + sum_767_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13} + {1'b0, select_769};
  // hls/stages/agreement.hpp:375
  logic [3:0] select_785;
  assign select_785 = (and_541_s2_q & and_503_s2_q) ? ({3'h0, not_773_s2_q} + sum_783_s2_q) : 4'h0;
  // hls/stages/agreement.hpp:403
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_785};
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_788;
  assign difference_788 = {2'h0, column_15} - (age_s2_q[1] ? sums_4_columns_values_6_q : 8'h0);
  logic [7:0] sum_790;
  assign sum_790 = difference_788 + (equal_563_s2_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:430
  logic [5:0] partner;
  assign partner = run_shift_s2_q + x_s2_2_q[5:0];
  // hls/stages/agreement.hpp:298
  logic [5:0] select_861;
  assign select_861 = equal_349_s2_q ? partner : (x_s2_q[5:0] + best_left_rdata_q[13:8]);
  logic [7:0] select_1630;
  assign select_1630 = equal_349_s2_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1631;
  assign select_1631 = equal_349_s2_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1632;
  assign select_1632 = equal_349_s2_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1633;
  assign select_1633 = equal_349_s2_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1634;
  assign select_1634 = equal_349_s2_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1635;
  assign select_1635 = equal_349_s2_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1638;
  assign select_1638 = equal_349_s2_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1639;
  assign select_1639 = equal_349_s2_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1640;
  assign select_1640 = equal_349_s2_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1641;
  assign select_1641 = equal_349_s2_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1642;
  assign select_1642 = equal_349_s2_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1643;
  assign select_1643 = equal_349_s2_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1646;
  assign select_1646 = equal_349_s2_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1647;
  assign select_1647 = equal_349_s2_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1648;
  assign select_1648 = equal_349_s2_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1649;
  assign select_1649 = equal_349_s2_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1650;
  assign select_1650 = equal_349_s2_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1651;
  assign select_1651 = equal_349_s2_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  logic [7:0] select_1654;
  assign select_1654 = equal_349_s2_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1655;
  assign select_1655 = equal_349_s2_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1656;
  assign select_1656 = equal_349_s2_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1657;
  assign select_1657 = equal_349_s2_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1658;
  assign select_1658 = equal_349_s2_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1659;
  assign select_1659 = equal_349_s2_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1662;
  assign select_1662 = equal_349_s2_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1663;
  assign select_1663 = equal_349_s2_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1664;
  assign select_1664 = equal_349_s2_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1665;
  assign select_1665 = equal_349_s2_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1666;
  assign select_1666 = equal_349_s2_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1667;
  assign select_1667 = equal_349_s2_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:637
  logic [16:0] select_1764;
  assign select_1764 = ($signed(slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : slope_change_q[27:11];
  logic [13:0] select_1766;
  assign select_1766 = ($signed(10'h0) < $signed(select_1764[16:7])) ? 14'h7f : select_1764[13:0];
  // hls/stages/agreement.hpp:632
  logic [9:0] select_1767;
  assign select_1767 = best_left_rdata_q[12] ? select_1766[9:0] : 10'h0;
  logic [8:0] difference_1769;
  assign difference_1769 = select_1767[9:1] - (best_left_rdata_q[13] ? select_1766[8:0] : 9'h0);
  // hls/stages/agreement.hpp:630
  logic [12:0] sum_1772;
  assign sum_1772 = (best_left_rdata_q[8] ? select_1766[13:1] : 13'h0) + (best_left_rdata_q[9] ? select_1766[12:0] : 13'h0);
  // hls/stages/agreement.hpp:631
  logic [11:0] select_1773;
  assign select_1773 = best_left_rdata_q[10] ? select_1766[11:0] : 12'h0;
  logic [10:0] sum_1775;
  assign sum_1775 = select_1773[11:1] + (best_left_rdata_q[11] ? select_1766[10:0] : 11'h0);
  // hls/stages/agreement.hpp:633
  logic [11:0] sum_1776;
  assign sum_1776 = sum_1772[12:1] + {sum_1775, select_1773[0]};
  logic [9:0] sum_1777;
  assign sum_1777 = {difference_1769, select_1767[0]} + sum_1776[11:2];
  // hls/stages/agreement.hpp:605
  logic [12:0] sum_1778;
  assign sum_1778 = {slope_q[27], slope_q[27:16]} + {{5{sum_1777[9]}}, sum_1777[9:2]};
  // hls/stages/agreement.hpp:630
  logic [7:0] select_1781;
  assign select_1781 = ($signed(sum_1778[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1778[7:0];
  logic [7:0] slope;
  assign slope = ($signed(6'h0) < $signed(sum_1778[12:7])) ? 8'h7f : select_1781;
  logic [6:0] select_1783;
  assign select_1783 = best_left_rdata_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1784;
  assign select_1784 = best_left_rdata_q[9] ? slope : 8'h0;
  logic [8:0] sum_1785;
  assign sum_1785 = {{2{select_1783[6]}}, select_1783} + {select_1784[7], select_1784};
  // hls/stages/agreement.hpp:631
  logic [7:0] select_1786;
  assign select_1786 = best_left_rdata_q[10] ? slope : 8'h0;
  logic [7:0] select_1787;
  assign select_1787 = best_left_rdata_q[11] ? slope : 8'h0;
  logic [8:0] sum_1788;
  assign sum_1788 = {{2{select_1786[7]}}, select_1786[7:1]} + {select_1787[7], select_1787};
  // hls/stages/agreement.hpp:633
  logic [10:0] sum_1789;
  assign sum_1789 = {{3{sum_1785[8]}}, sum_1785[8:1]} + {sum_1788[8], sum_1788, select_1786[0]};
  // hls/stages/agreement.hpp:632
  logic [7:0] select_1790;
  assign select_1790 = best_left_rdata_q[12] ? slope : 8'h0;
  logic [7:0] select_1791;
  assign select_1791 = best_left_rdata_q[13] ? slope : 8'h0;
  logic [8:0] difference_1792;
  assign difference_1792 = {{2{select_1790[7]}}, select_1790[7:1]} - {select_1791[7], select_1791};
  // hls/stages/agreement.hpp:256
  logic [23:0] select_2025;
  assign select_2025 = equal_2024_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : next_slope_row_q;
  // hls/stages/agreement.hpp:173
  logic [23:0] select_2027;
  assign select_2027 = and_334_s2_q ? (equal_1486_s2_q ? select_2025 : slope_row_q) : slope_row_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_2029;
  assign select_2029 = left_first_s2_q ? select_2027 : (and_305_s2_q ? select_2027 : slope_row_q);
  // hls/stages/agreement.hpp:257
  logic [27:0] select_2031;
  assign select_2031 = equal_2024_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : next_slope_change_q;
  // hls/stages/agreement.hpp:173
  logic [27:0] select_2033;
  assign select_2033 = and_334_s2_q ? (equal_1486_s2_q ? select_2031 : slope_change_q) : slope_change_q;
  // hls/stages/agreement.hpp:176
  logic [27:0] select_2035;
  assign select_2035 = left_first_s2_q ? select_2033 : (and_305_s2_q ? select_2033 : slope_change_q);
  // hls/stages/agreement.hpp:137
  logic [23:0] sum_2137;
  assign sum_2137 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + slope_row_q;
  // hls/stages/agreement.hpp:138
  logic [27:0] sum_2138;
  assign sum_2138 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + slope_change_q;

  // Memory averager_memory, 189 x 25, DISTANCE 16, hls/stages/census.hpp:139; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [24:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 25'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_303_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & select_315;
  logic [24:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 76, DISTANCE 16, hls/stages/census.hpp:244; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [75:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 76'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = select_299_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & select_337;
  logic [75:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 47 x 15, DISTANCE 12, hls/stages/agreement.hpp:889; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 15'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = select_861;
  logic best_right_re;
  assign best_right_re = s2_en & select_493_s2_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory seen_columns, 47 x 12, DISTANCE 12, hls/stages/agreement.hpp:918; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_931_s2_q;
  logic [11:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      slope_row_q <= 24'h0;
      slope_change_q <= 28'h0;
      slope_q <= 28'h0;
      next_slope_row_q <= 24'h0;
      next_slope_change_q <= 28'h0;
    end else if (s2_en) begin
      slope_row_q <= and_305_s2_q ? select_2029 : slope_row_q;
      slope_change_q <= and_305_s2_q ? select_2035 : slope_change_q;
      slope_q <= drew_s2_q ? (slope_change_q + slope_q) : {slope_row_q, 4'h0};
      next_slope_row_q <= sum_2137;
      next_slope_change_q <= sum_2138;
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
      sums_0_columns_values_0_q <= equal_349_s2_q ? {2'h0, column_12} : sums_0_columns_values_0_q;
      sums_0_columns_values_1_q <= select_1630;
      sums_0_columns_values_2_q <= select_1631;
      sums_0_columns_values_3_q <= select_1632;
      sums_0_columns_values_4_q <= select_1633;
      sums_0_columns_values_5_q <= select_1634;
      sums_0_columns_values_6_q <= select_1635;
      sums_0_sum_sums_values_0_q <= equal_349_s2_q ? sum_730 : sums_0_sum_sums_values_0_q;
      sums_1_columns_values_0_q <= equal_349_s2_q ? {2'h0, column_6} : sums_1_columns_values_0_q;
      sums_1_columns_values_1_q <= select_1638;
      sums_1_columns_values_2_q <= select_1639;
      sums_1_columns_values_3_q <= select_1640;
      sums_1_columns_values_4_q <= select_1641;
      sums_1_columns_values_5_q <= select_1642;
      sums_1_columns_values_6_q <= select_1643;
      sums_1_sum_sums_values_0_q <= equal_349_s2_q ? sum_618 : sums_1_sum_sums_values_0_q;
      sums_2_columns_values_0_q <= equal_349_s2_q ? {2'h0, column_3} : sums_2_columns_values_0_q;
      sums_2_columns_values_1_q <= select_1646;
      sums_2_columns_values_2_q <= select_1647;
      sums_2_columns_values_3_q <= select_1648;
      sums_2_columns_values_4_q <= select_1649;
      sums_2_columns_values_5_q <= select_1650;
      sums_2_columns_values_6_q <= select_1651;
      sums_2_sum_sums_values_0_q <= equal_349_s2_q ? sum_565 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= equal_349_s2_q ? {2'h0, column_9} : sums_3_columns_values_0_q;
      sums_3_columns_values_1_q <= select_1654;
      sums_3_columns_values_2_q <= select_1655;
      sums_3_columns_values_3_q <= select_1656;
      sums_3_columns_values_4_q <= select_1657;
      sums_3_columns_values_5_q <= select_1658;
      sums_3_columns_values_6_q <= select_1659;
      sums_3_sum_sums_values_0_q <= equal_349_s2_q ? sum_673 : sums_3_sum_sums_values_0_q;
      sums_4_columns_values_0_q <= equal_349_s2_q ? {2'h0, column_15} : sums_4_columns_values_0_q;
      sums_4_columns_values_1_q <= select_1662;
      sums_4_columns_values_2_q <= select_1663;
      sums_4_columns_values_3_q <= select_1664;
      sums_4_columns_values_4_q <= select_1665;
      sums_4_columns_values_5_q <= select_1666;
      sums_4_columns_values_6_q <= select_1667;
      sums_4_sum_sums_values_0_q <= equal_349_s2_q ? sum_790 : sums_4_sum_sums_values_0_q;
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
  logic select_297_s3_q;
  logic [5:0] select_299_s3_q;
  logic [7:0] select_303_s3_q;
  logic and_305_s3_q;
  logic and_312_s3_q;
  logic select_315_s3_q;
  logic equal_320_s3_q;
  logic and_333_s3_q;
  logic and_334_s3_q;
  logic select_337_s3_q;
  logic equal_340_s3_q;
  logic equal_349_s3_q;
  logic not_350_s3_q;
  logic equal_351_s3_q;
  logic less_352_s3_q;
  logic not_353_s3_q;
  logic equal_383_s3_q;
  logic drew_s3_q;
  logic [6:0] x_s3_2_q;
  logic not_491_s3_q;
  logic [21:0] best_left_rdata_s3_q;
  logic equal_496_s3_q;
  logic [7:0] sum_565_s3_q;
  logic [7:0] sum_618_s3_q;
  logic [7:0] sum_673_s3_q;
  logic [7:0] sum_730_s3_q;
  logic [1:0] best_2_s3_q;
  logic [7:0] sum_790_s3_q;
  logic equal_800_s3_q;
  logic and_858_s3_q;
  logic [5:0] partner_s3_q;
  logic equal_864_s3_q;
  logic equal_887_s3_q;
  logic equal_890_s3_q;
  logic and_901_s3_q;
  logic and_931_s3_q;
  logic and_939_s3_q;
  logic and_1037_s3_q;
  logic equal_1399_s3_q;
  logic equal_1486_s3_q;
  logic not_1550_s3_q;
  logic and_1674_s3_q;
  logic less_1756_s3_q;
  logic less_1759_s3_q;
  logic [9:0] sum_1789_s3_q;
  logic select_1790_s3_q;
  logic [8:0] difference_1792_s3_q;
  logic less_2039_s3_q;
  logic equal_2216_s3_q;
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
      select_297_s3_q <= select_297_s2_q;
      select_299_s3_q <= select_299_s2_q;
      select_303_s3_q <= select_303_s2_q;
      and_305_s3_q <= and_305_s2_q;
      and_312_s3_q <= and_312_s2_q;
      select_315_s3_q <= select_315;
      equal_320_s3_q <= equal_320_s2_q;
      and_333_s3_q <= and_333_s2_q;
      and_334_s3_q <= and_334_s2_q;
      select_337_s3_q <= select_337;
      equal_340_s3_q <= equal_340_s2_q;
      equal_349_s3_q <= equal_349_s2_q;
      not_350_s3_q <= not_350_s2_q;
      equal_351_s3_q <= equal_351_s2_q;
      less_352_s3_q <= less_352_s2_q;
      not_353_s3_q <= not_353_s2_q;
      equal_383_s3_q <= equal_383_s2_q;
      drew_s3_q <= drew_s2_q;
      x_s3_2_q <= x_s2_2_q;
      not_491_s3_q <= not_491_s2_q;
      best_left_rdata_s3_q <= best_left_rdata_q;
      equal_496_s3_q <= equal_496_s2_q;
      sum_565_s3_q <= sum_565;
      sum_618_s3_q <= sum_618;
      sum_673_s3_q <= sum_673;
      sum_730_s3_q <= sum_730;
      best_2_s3_q <= best_2;
      sum_790_s3_q <= sum_790;
      equal_800_s3_q <= equal_800_s2_q;
      and_858_s3_q <= and_858_s2_q;
      partner_s3_q <= partner;
      equal_864_s3_q <= equal_864_s2_q;
      equal_887_s3_q <= equal_887_s2_q;
      equal_890_s3_q <= equal_890_s2_q;
      and_901_s3_q <= and_901_s2_q;
      and_931_s3_q <= and_931_s2_q;
      and_939_s3_q <= and_939_s2_q;
      and_1037_s3_q <= and_1037_s2_q;
      equal_1399_s3_q <= equal_1399_s2_q;
      equal_1486_s3_q <= equal_1486_s2_q;
      not_1550_s3_q <= not_1550_s2_q;
      and_1674_s3_q <= and_1674_s2_q;
      less_1756_s3_q <= less_1756_s2_q;
      less_1759_s3_q <= less_1759_s2_q;
      sum_1789_s3_q <= sum_1789[10:1];
      select_1790_s3_q <= select_1790[0];
      difference_1792_s3_q <= difference_1792;
      less_2039_s3_q <= less_2039_s2_q;
      equal_2216_s3_q <= equal_2216_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_running_mask_q;
  logic averager_mask_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
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
  logic [11:0] counts_measured_0_q;
  logic [11:0] counts_measured_1_q;
  logic [11:0] counts_measured_2_q;
  logic [11:0] counts_measured_3_q;
  logic [14:0] counts_votes_0_up_q;
  logic [14:0] counts_votes_1_down_q;
  logic [14:0] counts_votes_1_up_q;
  logic [14:0] counts_votes_2_down_q;
  logic [14:0] counts_votes_2_up_q;
  logic [14:0] counts_votes_3_down_q;
  logic [14:0] counts_votes_3_up_q;
  logic [14:0] counts_votes_4_down_q;
  logic [14:0] counts_votes_4_up_q;
  logic [14:0] counts_half_votes_0_down_q;
  logic [14:0] counts_half_votes_0_up_q;
  logic [14:0] counts_half_votes_1_down_q;
  logic [14:0] counts_half_votes_1_up_q;
  logic [14:0] counts_half_votes_2_down_q;
  logic [14:0] counts_half_votes_2_up_q;
  logic [14:0] counts_half_votes_3_down_q;
  logic [14:0] counts_half_votes_3_up_q;
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
  // hls/stages/census.hpp:90
  logic [11:0] select_318;
  assign select_318 = select_297_s3_q ? ({4'h0, left_pixel_q} + averager_running_0_q) : {4'h0, left_pixel_q};
  // hls/stages/census.hpp:98
  logic [11:0] sum_322;
  assign sum_322 = select_318 + (equal_320_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:90
  logic [11:0] sum_324;
  assign sum_324 = {4'h0, pixel_0_s3_q} + (select_297_s3_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:98
  logic [11:0] sum_326;
  assign sum_326 = sum_324 + (equal_320_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:171
  logic whole;
  assign whole = select_297_s3_q ? (mask_s3_q & averager_running_mask_q) : mask_s3_q;
  // hls/stages/census.hpp:99
  logic and_330;
  assign and_330 = whole & (averager_memory_rdata_q[24] | equal_320_s3_q);
  // hls/stages/census.hpp:121
  logic [8:0] grey;
  assign grey = and_312_s3_q ? sum_322[11:3] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_340_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:121
  logic [8:0] grey_2;
  assign grey_2 = and_312_s3_q ? sum_326[11:3] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_340_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:121
  logic and_346;
  assign and_346 = and_312_s3_q & and_330;
  // hls/stages/census.hpp:102
  logic whole_2;
  assign whole_2 = equal_340_s3_q ? and_346 : (averager_mask_q & and_346);
  // hls/stages/census.hpp:206
  logic less_357;
  assign less_357 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_358;
  assign less_358 = census_memory_rdata_q[46:38] < census_columns_values_1_cell_2_left_q;
  logic less_359;
  assign less_359 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_360;
  assign less_360 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_361;
  assign less_361 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_362;
  assign less_362 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_363;
  assign less_363 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_364;
  assign less_364 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_365;
  assign less_365 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_366;
  assign less_366 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_367;
  assign less_367 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_368;
  assign less_368 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:207
  logic less_369;
  assign less_369 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_370;
  assign less_370 = census_memory_rdata_q[55:47] < census_columns_values_1_cell_2_right_q;
  logic less_371;
  assign less_371 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_372;
  assign less_372 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_373;
  assign less_373 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_374;
  assign less_374 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_375;
  assign less_375 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_376;
  assign less_376 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_377;
  assign less_377 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_378;
  assign less_378 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_379;
  assign less_379 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_380;
  assign less_380 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:238
  logic equal_381;
  assign equal_381 = select_299_s3_q == 6'h0;
  logic [3:0] select_384;
  assign select_384 = equal_383_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:239
  logic [4:0] select_385;
  assign select_385 = equal_381 ? {select_384, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:188
  logic [3:0] select_386;
  assign select_386 = equal_381 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:211
  logic and_387;
  assign and_387 = select_385[4] & select_386[3];
  // hls/stages/census.hpp:198
  logic and_389;
  assign and_389 = census_memory_rdata_q[37] & (census_memory_rdata_q[18] & whole_2);
  logic and_391;
  assign and_391 = census_memory_rdata_q[75] & (census_memory_rdata_q[56] & and_389);
  // hls/stages/agreement.hpp:239
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_391;
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
  // hls/stages/census.hpp:182
  logic [9:0] difference_414;
  assign difference_414 = {1'b0, total[10:2]} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_415;
  assign xor_415 = difference_414[8:0] ^ {9{difference_414[9]}};
  logic [9:0] sum_416;
  assign sum_416 = {9'h0, difference_414[9]} + {1'b0, xor_415};
  logic [9:0] difference_417;
  assign difference_417 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_418;
  assign xor_418 = difference_417[8:0] ^ {9{difference_417[9]}};
  logic [9:0] sum_419;
  assign sum_419 = {9'h0, difference_417[9]} + {1'b0, xor_418};
  logic [9:0] difference_421;
  assign difference_421 = {1'b0, census_memory_rdata_q[27:19]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_422;
  assign xor_422 = difference_421[8:0] ^ {9{difference_421[9]}};
  logic [9:0] sum_423;
  assign sum_423 = {9'h0, difference_421[9]} + {1'b0, xor_422};
  logic [10:0] sum_424;
  assign sum_424 = ({1'b0, sum_416} + {1'b0, sum_419}) + {1'b0, sum_423};
  logic [9:0] difference_425;
  assign difference_425 = {1'b0, census_memory_rdata_q[46:38]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_426;
  assign xor_426 = difference_425[8:0] ^ {9{difference_425[9]}};
  logic [9:0] sum_427;
  assign sum_427 = {9'h0, difference_425[9]} + {1'b0, xor_426};
  logic [9:0] difference_429;
  assign difference_429 = {1'b0, census_memory_rdata_q[65:57]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_430;
  assign xor_430 = difference_429[8:0] ^ {9{difference_429[9]}};
  logic [9:0] sum_431;
  assign sum_431 = {9'h0, difference_429[9]} + {1'b0, xor_430};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_424} + {2'h0, sum_427}) + {2'h0, sum_431};
  // hls/stages/agreement.hpp:410
  logic not_498;
  assign not_498 = ~($signed(run_shift_s3_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_499;
  assign less_499 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s3_q);
  // hls/stages/agreement.hpp:418
  logic [7:0] select_737;
  assign select_737 = best_2_s3_q[1] ? (best_2_s3_q[0] ? sum_673_s3_q : sum_565_s3_q) : (best_2_s3_q[0] ? sum_618_s3_q : sum_730_s3_q);
  logic less_791;
  assign less_791 = select_737 < sum_790_s3_q;
  logic [1:0] select_792;
  assign select_792 = less_791 ? 2'h0 : best_2_s3_q;
  // hls/stages/agreement.hpp:420
  logic [7:0] select_795;
  assign select_795 = select_792[1] ? (select_792[0] ? sum_673_s3_q : sum_565_s3_q) : (select_792[0] ? sum_618_s3_q : sum_730_s3_q);
  logic [7:0] of_best;
  assign of_best = less_791 ? sum_790_s3_q : select_795;
  logic [7:0] of_best_2;
  assign of_best_2 = (not_498 & (~less_499)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:422
  logic less_798;
  assign less_798 = $signed(run_shift_s3_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:425
  logic less_799;
  assign less_799 = best_left_rdata_s3_q[7:0] < of_best_2;
  logic or_801;
  assign or_801 = less_799 | equal_800_s3_q;
  // hls/stages/agreement.hpp:428
  logic [7:0] select_804;
  assign select_804 = less_798 ? (or_801 ? of_best_2 : best_left_rdata_s3_q[7:0]) : (less_799 ? of_best_2 : best_left_rdata_s3_q[7:0]);
  logic [5:0] select_808;
  assign select_808 = less_798 ? (or_801 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]) : (less_799 ? run_shift_s3_q : best_left_rdata_s3_q[13:8]);
  // hls/stages/agreement.hpp:438
  logic [2:0] near_best;
  assign near_best = ({less_791, select_792} == 3'h4) ? 3'h3 : (({less_791, select_792} == 3'h0) ? 3'h1 : {less_791, select_792});
  // hls/stages/agreement.hpp:439
  logic [2:0] sum_815;
  assign sum_815 = near_best + 3'h1;
  logic [7:0] select_818;
  assign select_818 = sum_815[1] ? (sum_815[0] ? sum_673_s3_q : sum_565_s3_q) : (sum_815[0] ? sum_618_s3_q : sum_730_s3_q);
  logic [7:0] select_819;
  assign select_819 = sum_815[2] ? sum_790_s3_q : select_818;
  logic [2:0] sum_820;
  assign sum_820 = near_best + 3'h7;
  logic [7:0] select_823;
  assign select_823 = sum_820[1] ? (sum_820[0] ? sum_673_s3_q : sum_565_s3_q) : (sum_820[0] ? sum_618_s3_q : sum_730_s3_q);
  logic [7:0] select_824;
  assign select_824 = sum_820[2] ? sum_790_s3_q : select_823;
  logic [8:0] difference_825;
  assign difference_825 = {1'b0, select_819} - {1'b0, select_824};
  // hls/stages/agreement.hpp:440
  logic [7:0] select_829;
  assign select_829 = near_best[1] ? (near_best[0] ? sum_673_s3_q : sum_565_s3_q) : (near_best[0] ? sum_618_s3_q : sum_730_s3_q);
  logic [7:0] select_830;
  assign select_830 = near_best[2] ? sum_790_s3_q : select_829;
  logic [8:0] sum_831;
  assign sum_831 = {1'b0, select_819} + {1'b0, select_824};
  logic [9:0] difference_832;
  assign difference_832 = {1'b0, select_830, 1'b0} - {1'b0, sum_831};
  // hls/stages/agreement.hpp:442
  logic [8:0] twice;
  assign twice = difference_832[9] ? 9'h0 : difference_832[8:0];
  // hls/stages/agreement.hpp:441
  logic [7:0] xor_834;
  assign xor_834 = difference_825[7:0] ^ {8{difference_825[8]}};
  logic [8:0] size;
  assign size = {8'h0, difference_825[8]} + {1'b0, xor_834};
  // hls/stages/agreement.hpp:443
  logic [9:0] difference_838;
  assign difference_838 = {1'b0, twice} - (({1'b0, size[8:1]} < twice) ? {1'b0, size} : {twice, 1'b0});
  // hls/stages/agreement.hpp:432
  logic less_863;
  assign less_863 = best_right_rdata_q[7:0] < of_best_2;
  logic or_865;
  assign or_865 = less_863 | equal_864_s3_q;
  // hls/stages/agreement.hpp:433
  logic [7:0] select_868;
  assign select_868 = less_798 ? (or_865 ? of_best_2 : best_right_rdata_q[7:0]) : (less_863 ? of_best_2 : best_right_rdata_q[7:0]);
  logic [7:0] select_869;
  assign select_869 = equal_496_s3_q ? of_best_2 : select_868;
  logic [6:0] select_872;
  assign select_872 = less_798 ? (or_865 ? x_s3_2_q : best_right_rdata_q[14:8]) : (less_863 ? x_s3_2_q : best_right_rdata_q[14:8]);
  logic [6:0] select_873;
  assign select_873 = equal_496_s3_q ? x_s3_2_q : select_872;
  // hls/stages/agreement.hpp:134
  logic [7:0] select_874;
  assign select_874 = drew_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:646
  logic or_877;
  assign or_877 = select_874[7] | (~({select_874[5], select_874[3], select_874[1]} == 3'h0));
  // hls/stages/agreement.hpp:645
  logic or_880;
  assign or_880 = select_874[7] | (~({select_874[6], select_874[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:644
  logic or_883;
  assign or_883 = select_874[7] | (~(select_874[6:4] == 3'h0));
  // hls/stages/agreement.hpp:461
  logic [5:0] sum_885;
  assign sum_885 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:654
  logic or_888;
  assign or_888 = (~sum_885[5]) | equal_887_s3_q;
  // hls/stages/agreement.hpp:583
  logic and_889;
  assign and_889 = not_353_s3_q & or_888;
  // hls/stages/agreement.hpp:714
  logic equal_891;
  assign equal_891 = x_s3_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:298
  logic and_893;
  assign and_893 = equal_890_s3_q & (~equal_891);
  // hls/stages/agreement.hpp:162
  logic textured;
  assign textured = not_353_s3_q & and_901_s3_q;
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_q[14:8]} - {1'b0, x_s3_q};
  // hls/stages/agreement.hpp:576
  logic [9:0] sum_910;
  assign sum_910 = {way[8], way} + 10'h1;
  logic and_912;
  assign and_912 = (and_901_s3_q & (8'hb6 < best_left_rdata_s3_q[7:0])) & ({{6{sum_910[9]}}, sum_910} < 16'h3);
  // hls/stages/agreement.hpp:162
  logic explained;
  assign explained = not_353_s3_q & and_912;
  // hls/stages/agreement.hpp:578
  logic and_920;
  assign and_920 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s3_q[13:8]));
  // hls/stages/agreement.hpp:162
  logic and_922;
  assign and_922 = and_912 & ((cfg_nearer_below_i & best_left_rdata_s3_q[13]) | and_920);
  logic near;
  assign near = not_353_s3_q & and_922;
  // hls/stages/agreement.hpp:814
  logic select_933;
  assign select_933 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:818
  logic select_934;
  assign select_934 = left_first_s3_q ? select_933 : read_half_q;
  // hls/stages/agreement.hpp:173
  logic next_row;
  assign next_row = and_939_s3_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:834
  logic [5:0] select_942;
  assign select_942 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_944;
  assign select_944 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_942});
  // hls/stages/agreement.hpp:844
  logic equal_945;
  assign equal_945 = seen_x_q == 3'h7;
  logic [7:0] select_947;
  assign select_947 = and_939_s3_q ? 8'h0 : (seen_column_q + {7'h0, equal_945});
  // hls/stages/agreement.hpp:847
  logic [10:0] index;
  assign index = select_944 + {3'h0, select_947};
  // hls/stages/agreement.hpp:804
  logic [11:0] sum_949;
  assign sum_949 = {1'b0, {2{select_934}}, 2'h0, {2{select_934}}, 1'b0, {2{select_934}}, 1'b0, select_934} + {1'b0, index};
  // hls/stages/census.hpp:31
  logic not_950;
  assign not_950 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:173
  logic and_952;
  assign and_952 = not_950 & (began_q | and_939_s3_q);
  // hls/stages/agreement.hpp:845
  logic [2:0] select_954;
  assign select_954 = and_939_s3_q ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:846
  logic and_956;
  assign and_956 = and_952 & (select_954 == 3'h0);
  logic less_957;
  assign less_957 = select_947 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:176
  logic and_958;
  assign and_958 = and_956 & less_957;
  logic and_959;
  assign and_959 = and_305_s3_q & and_958;
  // hls/stages/agreement.hpp:697
  logic [7:0] sum_963;
  assign sum_963 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_963[7], sum_963, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:804
  logic [11:0] sum_965;
  assign sum_965 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:583
  logic [3:0] select_966;
  assign select_966 = less_352_s3_q ? 4'h0 : seen_columns_rdata_q[11:8];
  logic and_967;
  assign and_967 = seen_columns_rdata_q[6] & not_353_s3_q;
  logic and_968;
  assign and_968 = seen_columns_rdata_q[3] & not_353_s3_q;
  logic and_969;
  assign and_969 = seen_columns_rdata_q[0] & not_353_s3_q;
  // hls/stages/agreement.hpp:677
  logic [1:0] sum_971;
  assign sum_971 = {1'b0, and_968} + ({1'b0, textured} + {1'b0, and_969});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_966[1]} + ({2'h0, and_967} + {1'b0, sum_971});
  // hls/stages/agreement.hpp:583
  logic [7:0] select_981;
  assign select_981 = less_352_s3_q ? select_874 : (sum_885[5] ? select_874 : {select_874[6:0], 1'b0});
  // hls/stages/agreement.hpp:646
  logic or_984;
  assign or_984 = select_981[7] | (~({select_981[5], select_981[3], select_981[1]} == 3'h0));
  // hls/stages/agreement.hpp:583
  logic and_1000;
  assign and_1000 = seen_columns_rdata_q[7] & not_353_s3_q;
  logic and_1001;
  assign and_1001 = seen_columns_rdata_q[4] & not_353_s3_q;
  logic and_1002;
  assign and_1002 = seen_columns_rdata_q[1] & not_353_s3_q;
  // hls/stages/agreement.hpp:678
  logic [1:0] sum_1004;
  assign sum_1004 = {1'b0, and_1001} + ({1'b0, explained} + {1'b0, and_1002});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_966[2]} + ({2'h0, and_1000} + {1'b0, sum_1004});
  // hls/stages/agreement.hpp:583
  logic and_1015;
  assign and_1015 = seen_columns_rdata_q[5] & not_353_s3_q;
  logic and_1016;
  assign and_1016 = seen_columns_rdata_q[2] & not_353_s3_q;
  // hls/stages/agreement.hpp:679
  logic [1:0] sum_1018;
  assign sum_1018 = {1'b0, and_1015} + ({1'b0, near} + {1'b0, and_1016});
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_966[3]} + ({2'h0, select_966[0]} + {1'b0, sum_1018});
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1080;
  assign select_1080 = left_first_s3_q ? select_318 : (and_305_s3_q ? select_318 : averager_running_0_q);
  logic [11:0] select_1083;
  assign select_1083 = left_first_s3_q ? sum_324 : (and_305_s3_q ? sum_324 : averager_running_1_q);
  // hls/stages/census.hpp:128
  logic [10:0] select_1101;
  assign select_1101 = and_333_s3_q ? total : averager_total_0_q;
  // hls/stages/agreement.hpp:176
  logic [10:0] select_1103;
  assign select_1103 = left_first_s3_q ? select_1101 : (and_305_s3_q ? select_1101 : averager_total_0_q);
  // hls/stages/census.hpp:128
  logic [10:0] select_1105;
  assign select_1105 = and_333_s3_q ? total_2 : averager_total_1_q;
  // hls/stages/agreement.hpp:176
  logic [10:0] select_1107;
  assign select_1107 = left_first_s3_q ? select_1105 : (and_305_s3_q ? select_1105 : averager_total_1_q);
  logic select_1133;
  assign select_1133 = left_first_s3_q ? whole : (and_305_s3_q ? whole : averager_running_mask_q);
  // hls/stages/census.hpp:134
  logic select_1135;
  assign select_1135 = and_333_s3_q ? whole_2 : averager_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1137;
  assign select_1137 = left_first_s3_q ? select_1135 : (and_305_s3_q ? select_1135 : averager_mask_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1139;
  assign select_1139 = and_334_s3_q ? total[10:2] : census_columns_values_0_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1140;
  assign select_1140 = and_305_s3_q ? select_1139 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1142;
  assign select_1142 = and_305_s3_q ? (left_first_s3_q ? select_1139 : select_1140) : census_columns_values_0_cell_0_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1143;
  assign select_1143 = and_334_s3_q ? total_2[10:2] : census_columns_values_0_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1144;
  assign select_1144 = and_305_s3_q ? select_1143 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1146;
  assign select_1146 = and_305_s3_q ? (left_first_s3_q ? select_1143 : select_1144) : census_columns_values_0_cell_0_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1147;
  assign select_1147 = and_334_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1148;
  assign select_1148 = and_305_s3_q ? select_1147 : census_columns_values_0_cell_0_mask_q;
  logic select_1150;
  assign select_1150 = and_305_s3_q ? (left_first_s3_q ? select_1147 : select_1148) : census_columns_values_0_cell_0_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1151;
  assign select_1151 = and_334_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1152;
  assign select_1152 = and_305_s3_q ? select_1151 : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1154;
  assign select_1154 = and_305_s3_q ? (left_first_s3_q ? select_1151 : select_1152) : census_columns_values_0_cell_1_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1155;
  assign select_1155 = and_334_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1156;
  assign select_1156 = and_305_s3_q ? select_1155 : census_columns_values_0_cell_1_right_q;
  logic [8:0] select_1158;
  assign select_1158 = and_305_s3_q ? (left_first_s3_q ? select_1155 : select_1156) : census_columns_values_0_cell_1_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1159;
  assign select_1159 = and_334_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1160;
  assign select_1160 = and_305_s3_q ? select_1159 : census_columns_values_0_cell_1_mask_q;
  logic select_1162;
  assign select_1162 = and_305_s3_q ? (left_first_s3_q ? select_1159 : select_1160) : census_columns_values_0_cell_1_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1163;
  assign select_1163 = and_334_s3_q ? census_memory_rdata_q[27:19] : census_columns_values_0_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1164;
  assign select_1164 = and_305_s3_q ? select_1163 : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1166;
  assign select_1166 = and_305_s3_q ? (left_first_s3_q ? select_1163 : select_1164) : census_columns_values_0_cell_2_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1167;
  assign select_1167 = and_334_s3_q ? census_memory_rdata_q[36:28] : census_columns_values_0_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1168;
  assign select_1168 = and_305_s3_q ? select_1167 : census_columns_values_0_cell_2_right_q;
  logic [8:0] select_1170;
  assign select_1170 = and_305_s3_q ? (left_first_s3_q ? select_1167 : select_1168) : census_columns_values_0_cell_2_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1171;
  assign select_1171 = and_334_s3_q ? census_memory_rdata_q[37] : census_columns_values_0_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1172;
  assign select_1172 = and_305_s3_q ? select_1171 : census_columns_values_0_cell_2_mask_q;
  logic select_1174;
  assign select_1174 = and_305_s3_q ? (left_first_s3_q ? select_1171 : select_1172) : census_columns_values_0_cell_2_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1175;
  assign select_1175 = and_334_s3_q ? census_memory_rdata_q[46:38] : census_columns_values_0_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1176;
  assign select_1176 = and_305_s3_q ? select_1175 : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1178;
  assign select_1178 = and_305_s3_q ? (left_first_s3_q ? select_1175 : select_1176) : census_columns_values_0_cell_3_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1179;
  assign select_1179 = and_334_s3_q ? census_memory_rdata_q[55:47] : census_columns_values_0_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1180;
  assign select_1180 = and_305_s3_q ? select_1179 : census_columns_values_0_cell_3_right_q;
  logic [8:0] select_1182;
  assign select_1182 = and_305_s3_q ? (left_first_s3_q ? select_1179 : select_1180) : census_columns_values_0_cell_3_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1183;
  assign select_1183 = and_334_s3_q ? census_memory_rdata_q[56] : census_columns_values_0_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1184;
  assign select_1184 = and_305_s3_q ? select_1183 : census_columns_values_0_cell_3_mask_q;
  logic select_1186;
  assign select_1186 = and_305_s3_q ? (left_first_s3_q ? select_1183 : select_1184) : census_columns_values_0_cell_3_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1187;
  assign select_1187 = and_334_s3_q ? census_memory_rdata_q[65:57] : census_columns_values_0_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1188;
  assign select_1188 = and_305_s3_q ? select_1187 : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1190;
  assign select_1190 = and_305_s3_q ? (left_first_s3_q ? select_1187 : select_1188) : census_columns_values_0_cell_4_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1191;
  assign select_1191 = and_334_s3_q ? census_memory_rdata_q[74:66] : census_columns_values_0_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1192;
  assign select_1192 = and_305_s3_q ? select_1191 : census_columns_values_0_cell_4_right_q;
  logic [8:0] select_1194;
  assign select_1194 = and_305_s3_q ? (left_first_s3_q ? select_1191 : select_1192) : census_columns_values_0_cell_4_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1195;
  assign select_1195 = and_334_s3_q ? census_memory_rdata_q[75] : census_columns_values_0_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1196;
  assign select_1196 = and_305_s3_q ? select_1195 : census_columns_values_0_cell_4_mask_q;
  logic select_1198;
  assign select_1198 = and_305_s3_q ? (left_first_s3_q ? select_1195 : select_1196) : census_columns_values_0_cell_4_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1199;
  assign select_1199 = and_334_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1200;
  assign select_1200 = and_305_s3_q ? select_1199 : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1202;
  assign select_1202 = and_305_s3_q ? (left_first_s3_q ? select_1199 : select_1200) : census_columns_values_1_cell_0_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1203;
  assign select_1203 = and_334_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1204;
  assign select_1204 = and_305_s3_q ? select_1203 : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1206;
  assign select_1206 = and_305_s3_q ? (left_first_s3_q ? select_1203 : select_1204) : census_columns_values_1_cell_0_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1207;
  assign select_1207 = and_334_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1208;
  assign select_1208 = and_305_s3_q ? select_1207 : census_columns_values_1_cell_0_mask_q;
  logic select_1210;
  assign select_1210 = and_305_s3_q ? (left_first_s3_q ? select_1207 : select_1208) : census_columns_values_1_cell_0_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1211;
  assign select_1211 = and_334_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1212;
  assign select_1212 = and_305_s3_q ? select_1211 : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1214;
  assign select_1214 = and_305_s3_q ? (left_first_s3_q ? select_1211 : select_1212) : census_columns_values_1_cell_1_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1215;
  assign select_1215 = and_334_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1216;
  assign select_1216 = and_305_s3_q ? select_1215 : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1218;
  assign select_1218 = and_305_s3_q ? (left_first_s3_q ? select_1215 : select_1216) : census_columns_values_1_cell_1_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1219;
  assign select_1219 = and_334_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1220;
  assign select_1220 = and_305_s3_q ? select_1219 : census_columns_values_1_cell_1_mask_q;
  logic select_1222;
  assign select_1222 = and_305_s3_q ? (left_first_s3_q ? select_1219 : select_1220) : census_columns_values_1_cell_1_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1223;
  assign select_1223 = and_334_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1224;
  assign select_1224 = and_305_s3_q ? select_1223 : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1226;
  assign select_1226 = and_305_s3_q ? (left_first_s3_q ? select_1223 : select_1224) : census_columns_values_1_cell_2_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1227;
  assign select_1227 = and_334_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1228;
  assign select_1228 = and_305_s3_q ? select_1227 : census_columns_values_1_cell_2_right_q;
  logic [8:0] select_1230;
  assign select_1230 = and_305_s3_q ? (left_first_s3_q ? select_1227 : select_1228) : census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1231;
  assign select_1231 = and_334_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1232;
  assign select_1232 = and_305_s3_q ? select_1231 : census_columns_values_1_cell_2_mask_q;
  logic select_1234;
  assign select_1234 = and_305_s3_q ? (left_first_s3_q ? select_1231 : select_1232) : census_columns_values_1_cell_2_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1235;
  assign select_1235 = and_334_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1236;
  assign select_1236 = and_305_s3_q ? select_1235 : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1238;
  assign select_1238 = and_305_s3_q ? (left_first_s3_q ? select_1235 : select_1236) : census_columns_values_1_cell_3_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1239;
  assign select_1239 = and_334_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1240;
  assign select_1240 = and_305_s3_q ? select_1239 : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1242;
  assign select_1242 = and_305_s3_q ? (left_first_s3_q ? select_1239 : select_1240) : census_columns_values_1_cell_3_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1243;
  assign select_1243 = and_334_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1244;
  assign select_1244 = and_305_s3_q ? select_1243 : census_columns_values_1_cell_3_mask_q;
  logic select_1246;
  assign select_1246 = and_305_s3_q ? (left_first_s3_q ? select_1243 : select_1244) : census_columns_values_1_cell_3_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1247;
  assign select_1247 = and_334_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1248;
  assign select_1248 = and_305_s3_q ? select_1247 : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1250;
  assign select_1250 = and_305_s3_q ? (left_first_s3_q ? select_1247 : select_1248) : census_columns_values_1_cell_4_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1251;
  assign select_1251 = and_334_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1252;
  assign select_1252 = and_305_s3_q ? select_1251 : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1254;
  assign select_1254 = and_305_s3_q ? (left_first_s3_q ? select_1251 : select_1252) : census_columns_values_1_cell_4_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1255;
  assign select_1255 = and_334_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1256;
  assign select_1256 = and_305_s3_q ? select_1255 : census_columns_values_1_cell_4_mask_q;
  logic select_1258;
  assign select_1258 = and_305_s3_q ? (left_first_s3_q ? select_1255 : select_1256) : census_columns_values_1_cell_4_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1259;
  assign select_1259 = and_334_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1260;
  assign select_1260 = and_305_s3_q ? select_1259 : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1262;
  assign select_1262 = and_305_s3_q ? (left_first_s3_q ? select_1259 : select_1260) : census_columns_values_2_cell_0_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1263;
  assign select_1263 = and_334_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1264;
  assign select_1264 = and_305_s3_q ? select_1263 : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1266;
  assign select_1266 = and_305_s3_q ? (left_first_s3_q ? select_1263 : select_1264) : census_columns_values_2_cell_0_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1267;
  assign select_1267 = and_334_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1268;
  assign select_1268 = and_305_s3_q ? select_1267 : census_columns_values_2_cell_0_mask_q;
  logic select_1270;
  assign select_1270 = and_305_s3_q ? (left_first_s3_q ? select_1267 : select_1268) : census_columns_values_2_cell_0_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1271;
  assign select_1271 = and_334_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1272;
  assign select_1272 = and_305_s3_q ? select_1271 : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1274;
  assign select_1274 = and_305_s3_q ? (left_first_s3_q ? select_1271 : select_1272) : census_columns_values_2_cell_1_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1275;
  assign select_1275 = and_334_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1276;
  assign select_1276 = and_305_s3_q ? select_1275 : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1278;
  assign select_1278 = and_305_s3_q ? (left_first_s3_q ? select_1275 : select_1276) : census_columns_values_2_cell_1_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1279;
  assign select_1279 = and_334_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1280;
  assign select_1280 = and_305_s3_q ? select_1279 : census_columns_values_2_cell_1_mask_q;
  logic select_1282;
  assign select_1282 = and_305_s3_q ? (left_first_s3_q ? select_1279 : select_1280) : census_columns_values_2_cell_1_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1283;
  assign select_1283 = and_334_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1284;
  assign select_1284 = and_305_s3_q ? select_1283 : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1286;
  assign select_1286 = and_305_s3_q ? (left_first_s3_q ? select_1283 : select_1284) : census_columns_values_2_cell_2_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1287;
  assign select_1287 = and_334_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1288;
  assign select_1288 = and_305_s3_q ? select_1287 : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1290;
  assign select_1290 = and_305_s3_q ? (left_first_s3_q ? select_1287 : select_1288) : census_columns_values_2_cell_2_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1291;
  assign select_1291 = and_334_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1292;
  assign select_1292 = and_305_s3_q ? select_1291 : census_columns_values_2_cell_2_mask_q;
  logic select_1294;
  assign select_1294 = and_305_s3_q ? (left_first_s3_q ? select_1291 : select_1292) : census_columns_values_2_cell_2_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1295;
  assign select_1295 = and_334_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1296;
  assign select_1296 = and_305_s3_q ? select_1295 : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1298;
  assign select_1298 = and_305_s3_q ? (left_first_s3_q ? select_1295 : select_1296) : census_columns_values_2_cell_3_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1299;
  assign select_1299 = and_334_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1300;
  assign select_1300 = and_305_s3_q ? select_1299 : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1302;
  assign select_1302 = and_305_s3_q ? (left_first_s3_q ? select_1299 : select_1300) : census_columns_values_2_cell_3_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1303;
  assign select_1303 = and_334_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1304;
  assign select_1304 = and_305_s3_q ? select_1303 : census_columns_values_2_cell_3_mask_q;
  logic select_1306;
  assign select_1306 = and_305_s3_q ? (left_first_s3_q ? select_1303 : select_1304) : census_columns_values_2_cell_3_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1307;
  assign select_1307 = and_334_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1308;
  assign select_1308 = and_305_s3_q ? select_1307 : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1310;
  assign select_1310 = and_305_s3_q ? (left_first_s3_q ? select_1307 : select_1308) : census_columns_values_2_cell_4_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1311;
  assign select_1311 = and_334_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1312;
  assign select_1312 = and_305_s3_q ? select_1311 : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1314;
  assign select_1314 = and_305_s3_q ? (left_first_s3_q ? select_1311 : select_1312) : census_columns_values_2_cell_4_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1315;
  assign select_1315 = and_334_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1316;
  assign select_1316 = and_305_s3_q ? select_1315 : census_columns_values_2_cell_4_mask_q;
  logic select_1318;
  assign select_1318 = and_305_s3_q ? (left_first_s3_q ? select_1315 : select_1316) : census_columns_values_2_cell_4_mask_q;
  // hls/stages/agreement.hpp:173
  logic select_1319;
  assign select_1319 = and_334_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1320;
  assign select_1320 = and_305_s3_q ? select_1319 : census_columns_values_3_cell_0_mask_q;
  logic select_1322;
  assign select_1322 = and_305_s3_q ? (left_first_s3_q ? select_1319 : select_1320) : census_columns_values_3_cell_0_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1323;
  assign select_1323 = and_334_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1324;
  assign select_1324 = and_305_s3_q ? select_1323 : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1326;
  assign select_1326 = and_305_s3_q ? (left_first_s3_q ? select_1323 : select_1324) : census_columns_values_3_cell_1_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1327;
  assign select_1327 = and_334_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1328;
  assign select_1328 = and_305_s3_q ? select_1327 : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1330;
  assign select_1330 = and_305_s3_q ? (left_first_s3_q ? select_1327 : select_1328) : census_columns_values_3_cell_1_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1331;
  assign select_1331 = and_334_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1332;
  assign select_1332 = and_305_s3_q ? select_1331 : census_columns_values_3_cell_1_mask_q;
  logic select_1334;
  assign select_1334 = and_305_s3_q ? (left_first_s3_q ? select_1331 : select_1332) : census_columns_values_3_cell_1_mask_q;
  // hls/stages/agreement.hpp:173
  logic select_1335;
  assign select_1335 = and_334_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1336;
  assign select_1336 = and_305_s3_q ? select_1335 : census_columns_values_3_cell_2_mask_q;
  logic select_1338;
  assign select_1338 = and_305_s3_q ? (left_first_s3_q ? select_1335 : select_1336) : census_columns_values_3_cell_2_mask_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1339;
  assign select_1339 = and_334_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1340;
  assign select_1340 = and_305_s3_q ? select_1339 : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1342;
  assign select_1342 = and_305_s3_q ? (left_first_s3_q ? select_1339 : select_1340) : census_columns_values_3_cell_3_left_q;
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1343;
  assign select_1343 = and_334_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1344;
  assign select_1344 = and_305_s3_q ? select_1343 : census_columns_values_3_cell_3_right_q;
  logic [8:0] select_1346;
  assign select_1346 = and_305_s3_q ? (left_first_s3_q ? select_1343 : select_1344) : census_columns_values_3_cell_3_right_q;
  // hls/stages/agreement.hpp:173
  logic select_1347;
  assign select_1347 = and_334_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1348;
  assign select_1348 = and_305_s3_q ? select_1347 : census_columns_values_3_cell_3_mask_q;
  logic select_1350;
  assign select_1350 = and_305_s3_q ? (left_first_s3_q ? select_1347 : select_1348) : census_columns_values_3_cell_3_mask_q;
  // hls/stages/agreement.hpp:173
  logic select_1351;
  assign select_1351 = and_334_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1352;
  assign select_1352 = and_305_s3_q ? select_1351 : census_columns_values_3_cell_4_mask_q;
  logic select_1354;
  assign select_1354 = and_305_s3_q ? (left_first_s3_q ? select_1351 : select_1352) : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:184
  logic [9:0] difference_1359;
  assign difference_1359 = {1'b0, total_2[10:2]} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_1360;
  assign xor_1360 = difference_1359[8:0] ^ {9{difference_1359[9]}};
  logic [9:0] sum_1361;
  assign sum_1361 = {9'h0, difference_1359[9]} + {1'b0, xor_1360};
  logic [9:0] difference_1362;
  assign difference_1362 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_1363;
  assign xor_1363 = difference_1362[8:0] ^ {9{difference_1362[9]}};
  logic [9:0] sum_1364;
  assign sum_1364 = {9'h0, difference_1362[9]} + {1'b0, xor_1363};
  logic [9:0] difference_1366;
  assign difference_1366 = {1'b0, census_memory_rdata_q[36:28]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_1367;
  assign xor_1367 = difference_1366[8:0] ^ {9{difference_1366[9]}};
  logic [9:0] sum_1368;
  assign sum_1368 = {9'h0, difference_1366[9]} + {1'b0, xor_1367};
  logic [10:0] sum_1369;
  assign sum_1369 = ({1'b0, sum_1361} + {1'b0, sum_1364}) + {1'b0, sum_1368};
  logic [9:0] difference_1370;
  assign difference_1370 = {1'b0, census_memory_rdata_q[55:47]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_1371;
  assign xor_1371 = difference_1370[8:0] ^ {9{difference_1370[9]}};
  logic [9:0] sum_1372;
  assign sum_1372 = {9'h0, difference_1370[9]} + {1'b0, xor_1371};
  logic [9:0] difference_1374;
  assign difference_1374 = {1'b0, census_memory_rdata_q[74:66]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_1375;
  assign xor_1375 = difference_1374[8:0] ^ {9{difference_1374[9]}};
  logic [9:0] sum_1376;
  assign sum_1376 = {9'h0, difference_1374[9]} + {1'b0, xor_1375};
  // hls/stages/agreement.hpp:173
  logic [3:0] select_1412;
  assign select_1412 = and_334_s3_q ? {select_386[2:0], 1'b1} : census_filled_q;
  // hls/stages/agreement.hpp:176
  logic [3:0] select_1414;
  assign select_1414 = left_first_s3_q ? select_1412 : (and_305_s3_q ? select_1412 : census_filled_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1416;
  assign select_1416 = and_334_s3_q ? total[10:2] : sharpness_last_mean_0_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1418;
  assign select_1418 = left_first_s3_q ? select_1416 : (and_305_s3_q ? select_1416 : sharpness_last_mean_0_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1420;
  assign select_1420 = and_334_s3_q ? total_2[10:2] : sharpness_last_mean_1_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1422;
  assign select_1422 = left_first_s3_q ? select_1420 : (and_305_s3_q ? select_1420 : sharpness_last_mean_1_q);
  // hls/stages/census.hpp:263
  logic [9:0] difference_1439;
  assign difference_1439 = {1'b0, total[10:2]} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1439[9]} + (difference_1439[8:0] ^ {9{difference_1439[9]}});
  logic [9:0] difference_1453;
  assign difference_1453 = {1'b0, total_2[10:2]} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1453[9]} + (difference_1453[8:0] ^ {9{difference_1453[9]}});
  // hls/stages/agreement.hpp:173
  logic [4:0] select_1481;
  assign select_1481 = and_334_s3_q ? select_385 : rows_passed_above_q;
  // hls/stages/agreement.hpp:176
  logic [4:0] select_1483;
  assign select_1483 = left_first_s3_q ? select_1481 : (and_305_s3_q ? select_1481 : rows_passed_above_q);
  // hls/stages/agreement.hpp:173
  logic and_1670;
  assign and_1670 = and_334_s3_q & (equal_383_s3_q & equal_1486_s3_q);
  // hls/stages/agreement.hpp:176
  logic and_1671;
  assign and_1671 = and_305_s3_q & and_1670;
  logic select_1673;
  assign select_1673 = and_305_s3_q ? (left_first_s3_q ? and_1670 : and_1671) : and_1671;
  // hls/stages/agreement.hpp:298
  logic and_1678;
  assign and_1678 = not_350_s3_q & (not_491_s3_q & (drew_s3_q & (not_353_s3_q & and_1674_s3_q)));
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1723;
  assign select_1723 = less_352_s3_q ? 9'h0 : (and_901_s3_q ? {and_912, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [8:0] select_1726;
  assign select_1726 = equal_349_s3_q ? 9'h0 : (equal_351_s3_q ? 9'h0 : (drew_s3_q ? select_1723 : 9'h0));
  // hls/stages/agreement.hpp:544
  logic [23:0] sum_1727;
  assign sum_1727 = counts_too_little_explained_q + {{15{select_1726[8]}}, select_1726};
  // hls/stages/agreement.hpp:580
  logic [9:0] select_1749;
  assign select_1749 = and_1674_s3_q ? ({1'b0, and_922, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:298
  logic [9:0] select_1752;
  assign select_1752 = equal_351_s3_q ? 10'h0 : (drew_s3_q ? (less_352_s3_q ? 10'h0 : select_1749) : 10'h0);
  logic [9:0] select_1753;
  assign select_1753 = equal_349_s3_q ? 10'h0 : select_1752;
  // hls/stages/agreement.hpp:554
  logic [23:0] select_1755;
  assign select_1755 = select_1673 ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1753[9]}}, select_1753});
  // hls/stages/agreement.hpp:580
  logic and_1757;
  assign and_1757 = and_912 & less_1756_s3_q;
  // hls/stages/agreement.hpp:612
  logic equal_1760;
  assign equal_1760 = {lower_half_s3_q, less_1759_s3_q} == 2'h3;
  logic equal_1761;
  assign equal_1761 = {lower_half_s3_q, less_1759_s3_q} == 2'h2;
  logic equal_1762;
  assign equal_1762 = {lower_half_s3_q, less_1759_s3_q} == 2'h1;
  // hls/stages/agreement.hpp:633
  logic [9:0] sum_1793;
  assign sum_1793 = {difference_1792_s3_q, select_1790_s3_q} + {sum_1789_s3_q[9], sum_1789_s3_q[9:1]};
  // hls/stages/agreement.hpp:607
  logic [11:0] difference_1794;
  assign difference_1794 = {{4{best_left_rdata_s3_q[21]}}, best_left_rdata_s3_q[21:14]} - {sum_1793[9], sum_1793, sum_1789_s3_q[0]};
  // hls/stages/agreement.hpp:637
  logic [11:0] select_1796;
  assign select_1796 = ($signed(difference_1794[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1794;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_1796[11:7])) ? 12'h7f : select_1796;
  // hls/stages/agreement.hpp:612
  logic not_1836;
  assign not_1836 = ~equal_1760;
  logic not_1837;
  assign not_1837 = ~equal_1761;
  // hls/stages/agreement.hpp:162
  logic and_1842;
  assign and_1842 = not_353_s3_q & (and_1757 & (not_1836 & (not_1837 & (~equal_1762))));
  // hls/stages/agreement.hpp:298
  logic and_1845;
  assign and_1845 = not_350_s3_q & (not_491_s3_q & (drew_s3_q & and_1842));
  logic and_1852;
  assign and_1852 = drew_s3_q & (not_353_s3_q & (and_1757 & (not_1836 & (equal_1762 & not_1837))));
  logic and_1854;
  assign and_1854 = not_350_s3_q & (not_491_s3_q & and_1852);
  logic and_1860;
  assign and_1860 = drew_s3_q & (not_353_s3_q & (and_1757 & (equal_1761 & not_1836)));
  logic and_1862;
  assign and_1862 = not_350_s3_q & (not_491_s3_q & and_1860);
  logic and_1868;
  assign and_1868 = not_491_s3_q & (drew_s3_q & (not_353_s3_q & (and_1757 & equal_1760)));
  logic and_1869;
  assign and_1869 = not_350_s3_q & and_1868;
  // hls/stages/agreement.hpp:625
  logic [12:0] difference_1880;
  assign difference_1880 = 13'h0 - {residual[11], residual};
  // hls/stages/agreement.hpp:162
  logic and_1882;
  assign and_1882 = and_1757 & ($signed(difference_1880) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1885;
  assign select_1885 = equal_351_s3_q ? 2'h0 : (drew_s3_q ? (less_352_s3_q ? 2'h0 : {and_1882, and_1757}) : 2'h0);
  logic [1:0] to_up;
  assign to_up = equal_349_s3_q ? 2'h0 : select_1885;
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1888;
  assign select_1888 = select_1673 ? 15'h0 : (counts_votes_0_up_q + {{13{to_up[1]}}, to_up});
  // hls/stages/agreement.hpp:619
  logic not_1889;
  assign not_1889 = ~less_1759_s3_q;
  // hls/stages/agreement.hpp:625
  logic less_1891;
  assign less_1891 = $signed(residual[7:0]) < $signed(limit);
  // hls/stages/agreement.hpp:618
  logic and_1892;
  assign and_1892 = not_1889 & less_1891;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1895;
  assign select_1895 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1892, not_1889} : 2'h0)) : 2'h0;
  logic [1:0] to_down_2;
  assign to_down_2 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1895);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1899;
  assign select_1899 = select_1673 ? 15'h0 : (counts_votes_1_down_q + {{13{to_down_2[1]}}, to_down_2});
  // hls/stages/agreement.hpp:625
  logic less_1900;
  assign less_1900 = $signed(difference_1880) < $signed({{5{limit[7]}}, limit});
  // hls/stages/agreement.hpp:618
  logic and_1901;
  assign and_1901 = not_1889 & less_1900;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1904;
  assign select_1904 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1901, not_1889} : 2'h0)) : 2'h0;
  logic [1:0] to_up_2;
  assign to_up_2 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1904);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1908;
  assign select_1908 = select_1673 ? 15'h0 : (counts_votes_1_up_q + {{13{to_up_2[1]}}, to_up_2});
  // hls/stages/agreement.hpp:618
  logic and_1909;
  assign and_1909 = less_1759_s3_q & less_1891;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1911;
  assign select_1911 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1909, less_1759_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_3;
  assign to_down_3 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1911 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1916;
  assign select_1916 = select_1673 ? 15'h0 : (counts_votes_2_down_q + {{13{to_down_3[1]}}, to_down_3});
  // hls/stages/agreement.hpp:618
  logic and_1917;
  assign and_1917 = less_1759_s3_q & less_1900;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1919;
  assign select_1919 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1917, less_1759_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_3;
  assign to_up_3 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1919 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1924;
  assign select_1924 = select_1673 ? 15'h0 : (counts_votes_2_up_q + {{13{to_up_3[1]}}, to_up_3});
  // hls/stages/agreement.hpp:619
  logic not_1925;
  assign not_1925 = ~lower_half_s3_q;
  // hls/stages/agreement.hpp:162
  logic and_1926;
  assign and_1926 = less_1891 & not_1925;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1929;
  assign select_1929 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1926, not_1925} : 2'h0)) : 2'h0;
  logic [1:0] to_down_4;
  assign to_down_4 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1929);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1933;
  assign select_1933 = select_1673 ? 15'h0 : (counts_votes_3_down_q + {{13{to_down_4[1]}}, to_down_4});
  // hls/stages/agreement.hpp:162
  logic and_1934;
  assign and_1934 = less_1900 & not_1925;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1937;
  assign select_1937 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1934, not_1925} : 2'h0)) : 2'h0;
  logic [1:0] to_up_4;
  assign to_up_4 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1937);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1941;
  assign select_1941 = select_1673 ? 15'h0 : (counts_votes_3_up_q + {{13{to_up_4[1]}}, to_up_4});
  // hls/stages/agreement.hpp:162
  logic and_1942;
  assign and_1942 = lower_half_s3_q & less_1891;
  logic [1:0] select_1944;
  assign select_1944 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1942, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_5;
  assign to_down_5 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1944 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1949;
  assign select_1949 = select_1673 ? 15'h0 : (counts_votes_4_down_q + {{13{to_down_5[1]}}, to_down_5});
  // hls/stages/agreement.hpp:162
  logic and_1950;
  assign and_1950 = lower_half_s3_q & less_1900;
  logic [1:0] select_1952;
  assign select_1952 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1950, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_5;
  assign to_up_5 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1952 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1957;
  assign select_1957 = select_1673 ? 15'h0 : (counts_votes_4_up_q + {{13{to_up_5[1]}}, to_up_5});
  // hls/stages/agreement.hpp:625
  logic less_1958;
  assign less_1958 = $signed(residual[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1959;
  assign and_1959 = not_1889 & less_1958;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1962;
  assign select_1962 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1959, not_1889} : 2'h0)) : 2'h0;
  logic [1:0] to_down_6;
  assign to_down_6 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1962);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1966;
  assign select_1966 = select_1673 ? 15'h0 : (counts_half_votes_0_down_q + {{13{to_down_6[1]}}, to_down_6});
  // hls/stages/agreement.hpp:625
  logic less_1967;
  assign less_1967 = $signed(difference_1880) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1968;
  assign and_1968 = not_1889 & less_1967;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1971;
  assign select_1971 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1968, not_1889} : 2'h0)) : 2'h0;
  logic [1:0] to_up_6;
  assign to_up_6 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1971);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1975;
  assign select_1975 = select_1673 ? 15'h0 : (counts_half_votes_0_up_q + {{13{to_up_6[1]}}, to_up_6});
  // hls/stages/agreement.hpp:618
  logic and_1976;
  assign and_1976 = less_1759_s3_q & less_1958;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1978;
  assign select_1978 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1976, less_1759_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_7;
  assign to_down_7 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1978 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1983;
  assign select_1983 = select_1673 ? 15'h0 : (counts_half_votes_1_down_q + {{13{to_down_7[1]}}, to_down_7});
  // hls/stages/agreement.hpp:618
  logic and_1984;
  assign and_1984 = less_1759_s3_q & less_1967;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1986;
  assign select_1986 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_1984, less_1759_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_7;
  assign to_up_7 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_1986 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1991;
  assign select_1991 = select_1673 ? 15'h0 : (counts_half_votes_1_up_q + {{13{to_up_7[1]}}, to_up_7});
  // hls/stages/agreement.hpp:162
  logic and_1992;
  assign and_1992 = less_1958 & not_1925;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1995;
  assign select_1995 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_1992, not_1925} : 2'h0)) : 2'h0;
  logic [1:0] to_down_8;
  assign to_down_8 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_1995);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1999;
  assign select_1999 = select_1673 ? 15'h0 : (counts_half_votes_2_down_q + {{13{to_down_8[1]}}, to_down_8});
  // hls/stages/agreement.hpp:162
  logic and_2000;
  assign and_2000 = less_1967 & not_1925;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_2003;
  assign select_2003 = drew_s3_q ? (less_352_s3_q ? 2'h0 : (and_1757 ? {and_2000, not_1925} : 2'h0)) : 2'h0;
  logic [1:0] to_up_8;
  assign to_up_8 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : select_2003);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_2007;
  assign select_2007 = select_1673 ? 15'h0 : (counts_half_votes_2_up_q + {{13{to_up_8[1]}}, to_up_8});
  // hls/stages/agreement.hpp:162
  logic and_2008;
  assign and_2008 = lower_half_s3_q & less_1958;
  logic [1:0] select_2010;
  assign select_2010 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_2008, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_9;
  assign to_down_9 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_2010 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_2015;
  assign select_2015 = select_1673 ? 15'h0 : (counts_half_votes_3_down_q + {{13{to_down_9[1]}}, to_down_9});
  // hls/stages/agreement.hpp:162
  logic and_2016;
  assign and_2016 = lower_half_s3_q & less_1967;
  logic [1:0] select_2018;
  assign select_2018 = less_352_s3_q ? 2'h0 : (and_1757 ? {and_2016, lower_half_s3_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_9;
  assign to_up_9 = equal_349_s3_q ? 2'h0 : (equal_351_s3_q ? 2'h0 : (drew_s3_q ? select_2018 : 2'h0));
  // hls/stages/agreement.hpp:178
  logic [14:0] select_2023;
  assign select_2023 = select_1673 ? 15'h0 : (counts_half_votes_3_up_q + {{13{to_up_9[1]}}, to_up_9});
  // hls/stages/agreement.hpp:477
  logic [7:0] sum_2040;
  assign sum_2040 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:243
  logic [2:0] select_2042;
  assign select_2042 = less_2039_s3_q ? (sum_2040[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_2044;
  assign select_2044 = equal_1486_s3_q ? (equal_383_s3_q ? 3'h0 : select_2042) : region_row_q;
  // hls/stages/agreement.hpp:173
  logic [2:0] select_2045;
  assign select_2045 = and_334_s3_q ? select_2044 : region_row_q;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_2047;
  assign select_2047 = left_first_s3_q ? select_2045 : (and_305_s3_q ? select_2045 : region_row_q);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_2051;
  assign select_2051 = equal_349_s3_q ? select_874 : (equal_351_s3_q ? select_874 : (drew_s3_q ? select_981 : 8'h1));
  // hls/stages/agreement.hpp:478
  logic [8:0] sum_2052;
  assign sum_2052 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/agreement.hpp:479
  logic [8:0] select_2053;
  assign select_2053 = sum_885[5] ? {1'b1, sum_885[4:0], region_across_rest_q[2:0]} : sum_2052;
  // hls/stages/agreement.hpp:134
  logic [8:0] select_2054;
  assign select_2054 = drew_s3_q ? select_2053 : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/agreement.hpp:243
  logic [7:0] select_2057;
  assign select_2057 = equal_1486_s3_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_2058;
  assign select_2058 = and_334_s3_q ? select_2057 : columns_begin_rest_q;
  // hls/stages/agreement.hpp:176
  logic [7:0] select_2060;
  assign select_2060 = left_first_s3_q ? select_2058 : (and_305_s3_q ? select_2058 : columns_begin_rest_q);
  // hls/stages/agreement.hpp:243
  logic [6:0] select_2063;
  assign select_2063 = equal_1486_s3_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:173
  logic [6:0] select_2064;
  assign select_2064 = and_334_s3_q ? select_2063 : columns_begin_back_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_2066;
  assign select_2066 = left_first_s3_q ? select_2064 : (and_305_s3_q ? select_2064 : columns_begin_back_q);
  // hls/stages/agreement.hpp:243
  logic [8:0] select_2070;
  assign select_2070 = equal_383_s3_q ? {{2{difference_2068[6]}}, difference_2068} : (less_2039_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_2072;
  assign select_2072 = and_334_s3_q ? (equal_1486_s3_q ? select_2070 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_2074;
  assign select_2074 = left_first_s3_q ? select_2072 : (and_305_s3_q ? select_2072 : region_down_rest_q);
  // hls/stages/agreement.hpp:243
  logic [6:0] select_2077;
  assign select_2077 = equal_383_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:173
  logic [6:0] select_2079;
  assign select_2079 = and_334_s3_q ? (equal_1486_s3_q ? select_2077 : region_down_back_q) : region_down_back_q;
  // hls/stages/agreement.hpp:176
  logic [6:0] select_2081;
  assign select_2081 = left_first_s3_q ? select_2079 : (and_305_s3_q ? select_2079 : region_down_back_q);
  // hls/stages/agreement.hpp:478
  logic [8:0] sum_2083;
  assign sum_2083 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/agreement.hpp:479
  logic [8:0] select_2084;
  assign select_2084 = sum_2040[7] ? {1'b1, sum_2040[6:0], region_down_rest_q[0]} : sum_2083;
  // hls/stages/agreement.hpp:461
  logic next;
  assign next = ~sum_2040[7];
  // hls/stages/agreement.hpp:243
  logic select_2088;
  assign select_2088 = equal_1486_s3_q ? (equal_383_s3_q | (less_2039_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:173
  logic select_2089;
  assign select_2089 = and_334_s3_q ? select_2088 : region_fresh_q;
  // hls/stages/agreement.hpp:176
  logic select_2091;
  assign select_2091 = left_first_s3_q ? select_2089 : (and_305_s3_q ? select_2089 : region_fresh_q);
  // hls/stages/agreement.hpp:134
  logic or_2096;
  assign or_2096 = segment_starts_q | not_1550_s3_q;
  // hls/stages/agreement.hpp:583
  logic select_2099;
  assign select_2099 = less_352_s3_q ? or_2096 : (sum_885[5] ? (equal_887_s3_q & or_888) : or_888);
  // hls/stages/agreement.hpp:298
  logic select_2102;
  assign select_2102 = equal_349_s3_q ? or_2096 : (equal_351_s3_q ? or_2096 : (drew_s3_q ? select_2099 : or_2096));
  // hls/stages/agreement.hpp:727
  logic equal_2104;
  assign equal_2104 = x_s3_q[5:0] == 6'h3f;
  // hls/stages/agreement.hpp:729
  logic [7:0] select_2128;
  assign select_2128 = ($signed(24'h0) < $signed(counts_too_much_hidden_q)) ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_2130;
  assign select_2130 = equal_890_s3_q ? (equal_2104 ? select_2128 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_2132;
  assign select_2132 = equal_351_s3_q ? hidden_for_q : (drew_s3_q ? hidden_for_q : select_2130);
  // hls/stages/agreement.hpp:139
  logic not_2134;
  assign not_2134 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:298
  logic select_2211;
  assign select_2211 = equal_351_s3_q ? centres_values_0_q : (drew_s3_q ? and_968 : centres_values_0_q);
  logic select_2214;
  assign select_2214 = equal_351_s3_q ? centres_values_1_q : (drew_s3_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/agreement.hpp:243
  logic [10:0] select_2219;
  assign select_2219 = equal_1486_s3_q ? (equal_2216_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:173
  logic [10:0] select_2220;
  assign select_2220 = and_334_s3_q ? select_2219 : map_row_q;
  // hls/stages/agreement.hpp:176
  logic [10:0] select_2222;
  assign select_2222 = left_first_s3_q ? select_2220 : (and_305_s3_q ? select_2220 : map_row_q);
  // hls/stages/agreement.hpp:173
  logic [5:0] select_2225;
  assign select_2225 = and_334_s3_q ? (equal_1486_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:176
  logic [5:0] select_2227;
  assign select_2227 = left_first_s3_q ? select_2225 : (and_305_s3_q ? select_2225 : map_width_q);
  // hls/stages/agreement.hpp:814
  logic xor_2229;
  assign xor_2229 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:176
  logic select_2231;
  assign select_2231 = and_305_s3_q ? (left_first_s3_q ? xor_2229 : write_half_q) : write_half_q;
  logic select_2233;
  assign select_2233 = and_305_s3_q ? (left_first_s3_q ? xor_2229 : select_2231) : write_half_q;
  logic select_2235;
  assign select_2235 = left_first_s3_q ? select_933 : (and_305_s3_q ? select_934 : read_half_q);
  logic and_2239;
  assign and_2239 = (~begins_product_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:298
  logic and_2249;
  assign and_2249 = not_350_s3_q & (not_491_s3_q & (not_1550_s3_q & (equal_890_s3_q & equal_2104)));
  // hls/stages/agreement.hpp:176
  logic select_2258;
  assign select_2258 = and_305_s3_q ? (left_first_s3_q ? and_952 : (and_305_s3_q ? and_952 : began_q)) : began_q;
  logic [2:0] select_2260;
  assign select_2260 = left_first_s3_q ? select_954 : (and_305_s3_q ? select_954 : seen_x_q);
  // hls/stages/agreement.hpp:843
  logic [2:0] select_2264;
  assign select_2264 = and_939_s3_q ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:176
  logic [2:0] select_2267;
  assign select_2267 = left_first_s3_q ? 3'h0 : (and_305_s3_q ? (left_first_s3_q ? 3'h0 : select_2264) : seen_y_q);
  logic [7:0] select_2270;
  assign select_2270 = left_first_s3_q ? select_947 : (and_305_s3_q ? select_947 : seen_column_q);
  // hls/stages/agreement.hpp:173
  logic [7:0] select_2276;
  assign select_2276 = left_first_s3_q ? select_2274 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:176
  logic [7:0] select_2278;
  assign select_2278 = left_first_s3_q ? select_2274 : (and_305_s3_q ? select_2276 : seen_rows_left_q);
  // hls/stages/agreement.hpp:173
  logic and_2283;
  assign and_2283 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:176
  logic select_2285;
  assign select_2285 = left_first_s3_q ? and_2283 : (and_305_s3_q ? and_2283 : at_cell_end_q);
  logic select_2288;
  assign select_2288 = left_first_s3_q ? next_row : (and_305_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_2291;
  assign select_2291 = left_first_s3_q ? 11'h0 : (and_305_s3_q ? select_944 : seen_base_q);
  // hls/stages/agreement.hpp:785
  logic [12:0] upper;
  assign upper = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, counts_measured_2_q} + {1'b0, counts_measured_3_q};
  // hls/stages/agreement.hpp:789
  logic [13:0] sum_2370;
  assign sum_2370 = {1'b0, upper} + {1'b0, lower};
  logic less_2371;
  assign less_2371 = 11'h4 < sum_2370[13:3];
  // hls/stages/agreement.hpp:785
  logic [12:0] left;
  assign left = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_2_q};
  // hls/stages/agreement.hpp:786
  logic less_2374;
  assign less_2374 = 11'he < left[12:2];
  // hls/stages/agreement.hpp:496
  logic less_2376;
  assign less_2376 = $signed(15'h0) < $signed(counts_votes_0_up_q);
  // hls/stages/agreement.hpp:790
  logic or_2377;
  assign or_2377 = (~less_2374) | less_2376;
  // hls/stages/agreement.hpp:785
  logic [12:0] right;
  assign right = {1'b0, counts_measured_1_q} + {1'b0, counts_measured_3_q};
  // hls/stages/agreement.hpp:786
  logic less_2379;
  assign less_2379 = 11'he < right[12:2];
  // hls/stages/agreement.hpp:496
  logic less_2381;
  assign less_2381 = $signed(15'h0) < $signed(counts_half_votes_0_up_q);
  // hls/stages/agreement.hpp:790
  logic select_2383;
  assign select_2383 = less_2371 ? (or_2377 ? less_2376 : less_2381) : less_2381;
  logic or_2384;
  assign or_2384 = (~less_2379) | select_2383;
  // hls/stages/agreement.hpp:786
  logic less_2385;
  assign less_2385 = 11'he < upper[12:2];
  // hls/stages/agreement.hpp:496
  logic less_2387;
  assign less_2387 = $signed(15'h0) < $signed(counts_half_votes_1_up_q);
  // hls/stages/agreement.hpp:790
  logic select_2388;
  assign select_2388 = or_2384 ? select_2383 : less_2387;
  logic select_2390;
  assign select_2390 = less_2371 ? select_2388 : (less_2374 ? select_2388 : less_2387);
  logic or_2391;
  assign or_2391 = (~less_2385) | select_2390;
  // hls/stages/agreement.hpp:496
  logic less_2392;
  assign less_2392 = $signed(15'h0) < $signed(counts_half_votes_2_up_q);
  // hls/stages/agreement.hpp:790
  logic select_2393;
  assign select_2393 = or_2391 ? select_2390 : less_2392;
  logic select_2396;
  assign select_2396 = less_2371 ? select_2393 : (less_2374 ? select_2393 : (less_2379 ? select_2393 : less_2392));
  // hls/stages/agreement.hpp:787
  logic less_2397;
  assign less_2397 = 11'he < lower[12:2];
  // hls/stages/agreement.hpp:790
  logic or_2399;
  assign or_2399 = select_2396 | (~less_2397);
  // hls/stages/agreement.hpp:496
  logic less_2400;
  assign less_2400 = $signed(15'h0) < $signed(counts_half_votes_3_up_q);
  // hls/stages/agreement.hpp:791
  logic select_2401;
  assign select_2401 = or_2399 ? select_2396 : less_2400;
  logic select_2404;
  assign select_2404 = less_2374 ? select_2401 : (less_2379 ? select_2401 : (less_2385 ? select_2401 : less_2400));
  // hls/stages/agreement.hpp:731
  logic and_2416;
  assign and_2416 = ($signed(15'h0) < $signed(counts_votes_3_up_q)) & ($signed(15'h0) < $signed(counts_votes_4_down_q));
  logic select_2418;
  assign select_2418 = ($signed(15'h0) < $signed(counts_votes_3_down_q)) ? (($signed(15'h0) < $signed(counts_votes_4_up_q)) | and_2416) : and_2416;
  logic and_2419;
  assign and_2419 = (less_2385 & less_2397) & select_2418;
  logic select_2421;
  assign select_2421 = ($signed(15'h0) < $signed(counts_votes_1_up_q)) ? (($signed(15'h0) < $signed(counts_votes_2_down_q)) | and_2419) : and_2419;
  logic select_2423;
  assign select_2423 = ($signed(15'h0) < $signed(counts_votes_1_down_q)) ? (($signed(15'h0) < $signed(counts_votes_2_up_q)) | select_2421) : select_2421;
  logic select_2424;
  assign select_2424 = (less_2374 & less_2379) ? select_2423 : and_2419;
  logic or_2425;
  assign or_2425 = (less_2371 ? select_2401 : select_2404) | select_2424;
  logic or_2427;
  assign or_2427 = ($signed(15'h0) < $signed(counts_half_votes_3_down_q)) | or_2425;
  logic select_2428;
  assign select_2428 = or_2399 ? or_2425 : or_2427;
  logic or_2430;
  assign or_2430 = ($signed(15'h0) < $signed(counts_half_votes_2_down_q)) | select_2428;
  logic and_2477;
  assign and_2477 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_2128 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:298
  logic and_2481;
  assign and_2481 = not_1550_s3_q & (equal_890_s3_q & (equal_2104 & (cfg_prove_i & and_2477)));
  logic [11:0] select_2505;
  assign select_2505 = equal_890_s3_q ? (equal_2104 ? counts_measured_0_q : 12'h0) : 12'h0;
  logic [11:0] select_2508;
  assign select_2508 = equal_349_s3_q ? 12'h0 : (equal_351_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2505));
  logic [11:0] select_2510;
  assign select_2510 = equal_890_s3_q ? (equal_2104 ? counts_measured_1_q : 12'h0) : 12'h0;
  logic [11:0] select_2513;
  assign select_2513 = equal_349_s3_q ? 12'h0 : (equal_351_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2510));
  logic [11:0] select_2515;
  assign select_2515 = equal_890_s3_q ? (equal_2104 ? counts_measured_2_q : 12'h0) : 12'h0;
  logic [11:0] select_2518;
  assign select_2518 = equal_349_s3_q ? 12'h0 : (equal_351_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2515));
  logic [11:0] select_2520;
  assign select_2520 = equal_890_s3_q ? (equal_2104 ? counts_measured_3_q : 12'h0) : 12'h0;
  logic [11:0] select_2523;
  assign select_2523 = equal_349_s3_q ? 12'h0 : (equal_351_s3_q ? 12'h0 : (drew_s3_q ? 12'h0 : select_2520));

  // Memory regions, 64 x 36, DISTANCE 12, hls/stages/agreement.hpp:902; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = drew_s3_q ? {region_row_q, or_883, or_880, or_877} : x_s3_q[5:0];
  logic regions_re;
  assign regions_re = s3_en & (not_350_s3_q & (not_491_s3_q & (drew_s3_q ? and_889 : and_893)));
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:922; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_949;
  logic map_re;
  assign map_re = s3_en & (and_305_s3_q ? (left_first_s3_q ? and_958 : and_959) : and_959);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_303_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & select_315_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_330, sum_326, sum_322};
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
  assign census_memory_waddr = select_299_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & select_337_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[56:0], whole_2, total_2[10:2], total[10:2]};
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
  assign best_right_we = s3_en & and_858_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_873, select_869};
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
  assign seen_columns_we = s3_en & and_931_s3_q;
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
      averager_running_mask_q <= 1'b0;
      averager_mask_q <= 1'b0;
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      counts_measured_0_q <= 12'h0;
      counts_measured_1_q <= 12'h0;
      counts_measured_2_q <= 12'h0;
      counts_measured_3_q <= 12'h0;
      counts_votes_0_up_q <= 15'h0;
      counts_votes_1_down_q <= 15'h0;
      counts_votes_1_up_q <= 15'h0;
      counts_votes_2_down_q <= 15'h0;
      counts_votes_2_up_q <= 15'h0;
      counts_votes_3_down_q <= 15'h0;
      counts_votes_3_up_q <= 15'h0;
      counts_votes_4_down_q <= 15'h0;
      counts_votes_4_up_q <= 15'h0;
      counts_half_votes_0_down_q <= 15'h0;
      counts_half_votes_0_up_q <= 15'h0;
      counts_half_votes_1_down_q <= 15'h0;
      counts_half_votes_1_up_q <= 15'h0;
      counts_half_votes_2_down_q <= 15'h0;
      counts_half_votes_2_up_q <= 15'h0;
      counts_half_votes_3_down_q <= 15'h0;
      counts_half_votes_3_up_q <= 15'h0;
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
      averager_running_mask_q <= and_305_s3_q ? select_1133 : averager_running_mask_q;
      averager_mask_q <= and_305_s3_q ? select_1137 : averager_mask_q;
      census_filled_q <= and_305_s3_q ? select_1414 : census_filled_q;
      rows_passed_above_q <= and_305_s3_q ? select_1483 : rows_passed_above_q;
      counts_too_little_explained_q <= select_1673 ? 24'h0 : sum_1727;
      counts_too_much_hidden_q <= select_1755;
      counts_measured_0_q <= select_1673 ? 12'h0 : (counts_measured_0_q + {11'h0, and_1845});
      counts_measured_1_q <= select_1673 ? 12'h0 : (counts_measured_1_q + {11'h0, and_1854});
      counts_measured_2_q <= select_1673 ? 12'h0 : (counts_measured_2_q + {11'h0, and_1862});
      counts_measured_3_q <= select_1673 ? 12'h0 : (counts_measured_3_q + {11'h0, and_1869});
      counts_votes_0_up_q <= select_1888;
      counts_votes_1_down_q <= select_1899;
      counts_votes_1_up_q <= select_1908;
      counts_votes_2_down_q <= select_1916;
      counts_votes_2_up_q <= select_1924;
      counts_votes_3_down_q <= select_1933;
      counts_votes_3_up_q <= select_1941;
      counts_votes_4_down_q <= select_1949;
      counts_votes_4_up_q <= select_1957;
      counts_half_votes_0_down_q <= select_1966;
      counts_half_votes_0_up_q <= select_1975;
      counts_half_votes_1_down_q <= select_1983;
      counts_half_votes_1_up_q <= select_1991;
      counts_half_votes_2_down_q <= select_1999;
      counts_half_votes_2_up_q <= select_2007;
      counts_half_votes_3_down_q <= select_2015;
      counts_half_votes_3_up_q <= select_2023;
      region_row_q <= and_305_s3_q ? select_2047 : region_row_q;
      region_columns_q <= select_2051;
      region_across_rest_q <= select_2054;
      region_across_back_q <= drew_s3_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_305_s3_q ? select_2060 : columns_begin_rest_q;
      columns_begin_back_q <= and_305_s3_q ? select_2066 : columns_begin_back_q;
      region_down_rest_q <= and_305_s3_q ? select_2074 : region_down_rest_q;
      region_down_back_q <= and_305_s3_q ? select_2081 : region_down_back_q;
      region_down_next_q <= select_2084;
      region_fresh_q <= and_305_s3_q ? select_2091 : region_fresh_q;
      segment_starts_q <= select_2102;
      hidden_for_q <= equal_349_s3_q ? hidden_for_q : select_2132;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_2134};
      next_region_row_q <= region_row_q + 3'h1;
      begins_product_q <= drew_s3_q;
      centres_values_0_q <= equal_349_s3_q ? centres_values_0_q : select_2211;
      centres_values_1_q <= equal_349_s3_q ? centres_values_1_q : select_2214;
      map_row_q <= and_305_s3_q ? select_2222 : map_row_q;
      map_width_q <= and_305_s3_q ? select_2227 : map_width_q;
      write_half_q <= select_2233;
      read_half_q <= and_305_s3_q ? select_2235 : read_half_q;
      done_q <= and_305_s3_q ? (not_950 & and_2239) : and_2239;
      said_q <= and_2249;
      began_q <= select_2258;
      seen_x_q <= and_305_s3_q ? select_2260 : seen_x_q;
      seen_y_q <= and_305_s3_q ? select_2267 : seen_y_q;
      seen_column_q <= and_305_s3_q ? select_2270 : seen_column_q;
      seen_rows_left_q <= and_305_s3_q ? select_2278 : seen_rows_left_q;
      at_cell_end_q <= and_305_s3_q ? select_2285 : at_cell_end_q;
      was_next_row_q <= and_305_s3_q ? select_2288 : was_next_row_q;
      seen_base_q <= and_305_s3_q ? select_2291 : seen_base_q;
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
      left_pixel_q <= and_305_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= and_305_s3_q ? select_1080 : averager_running_0_q;
      averager_running_1_q <= and_305_s3_q ? select_1083 : averager_running_1_q;
      averager_total_0_q <= and_305_s3_q ? select_1103 : averager_total_0_q;
      averager_total_1_q <= and_305_s3_q ? select_1107 : averager_total_1_q;
      census_columns_values_0_cell_0_left_q <= select_1142;
      census_columns_values_0_cell_0_right_q <= select_1146;
      census_columns_values_0_cell_0_mask_q <= select_1150;
      census_columns_values_0_cell_1_left_q <= select_1154;
      census_columns_values_0_cell_1_right_q <= select_1158;
      census_columns_values_0_cell_1_mask_q <= select_1162;
      census_columns_values_0_cell_2_left_q <= select_1166;
      census_columns_values_0_cell_2_right_q <= select_1170;
      census_columns_values_0_cell_2_mask_q <= select_1174;
      census_columns_values_0_cell_3_left_q <= select_1178;
      census_columns_values_0_cell_3_right_q <= select_1182;
      census_columns_values_0_cell_3_mask_q <= select_1186;
      census_columns_values_0_cell_4_left_q <= select_1190;
      census_columns_values_0_cell_4_right_q <= select_1194;
      census_columns_values_0_cell_4_mask_q <= select_1198;
      census_columns_values_1_cell_0_left_q <= select_1202;
      census_columns_values_1_cell_0_right_q <= select_1206;
      census_columns_values_1_cell_0_mask_q <= select_1210;
      census_columns_values_1_cell_1_left_q <= select_1214;
      census_columns_values_1_cell_1_right_q <= select_1218;
      census_columns_values_1_cell_1_mask_q <= select_1222;
      census_columns_values_1_cell_2_left_q <= select_1226;
      census_columns_values_1_cell_2_right_q <= select_1230;
      census_columns_values_1_cell_2_mask_q <= select_1234;
      census_columns_values_1_cell_3_left_q <= select_1238;
      census_columns_values_1_cell_3_right_q <= select_1242;
      census_columns_values_1_cell_3_mask_q <= select_1246;
      census_columns_values_1_cell_4_left_q <= select_1250;
      census_columns_values_1_cell_4_right_q <= select_1254;
      census_columns_values_1_cell_4_mask_q <= select_1258;
      census_columns_values_2_cell_0_left_q <= select_1262;
      census_columns_values_2_cell_0_right_q <= select_1266;
      census_columns_values_2_cell_0_mask_q <= select_1270;
      census_columns_values_2_cell_1_left_q <= select_1274;
      census_columns_values_2_cell_1_right_q <= select_1278;
      census_columns_values_2_cell_1_mask_q <= select_1282;
      census_columns_values_2_cell_2_left_q <= select_1286;
      census_columns_values_2_cell_2_right_q <= select_1290;
      census_columns_values_2_cell_2_mask_q <= select_1294;
      census_columns_values_2_cell_3_left_q <= select_1298;
      census_columns_values_2_cell_3_right_q <= select_1302;
      census_columns_values_2_cell_3_mask_q <= select_1306;
      census_columns_values_2_cell_4_left_q <= select_1310;
      census_columns_values_2_cell_4_right_q <= select_1314;
      census_columns_values_2_cell_4_mask_q <= select_1318;
      census_columns_values_3_cell_0_mask_q <= select_1322;
      census_columns_values_3_cell_1_left_q <= select_1326;
      census_columns_values_3_cell_1_right_q <= select_1330;
      census_columns_values_3_cell_1_mask_q <= select_1334;
      census_columns_values_3_cell_2_mask_q <= select_1338;
      census_columns_values_3_cell_3_left_q <= select_1342;
      census_columns_values_3_cell_3_right_q <= select_1346;
      census_columns_values_3_cell_3_mask_q <= select_1350;
      census_columns_values_3_cell_4_mask_q <= select_1354;
      sharpness_last_mean_0_q <= and_305_s3_q ? select_1418 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_305_s3_q ? select_1422 : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic [5:0] x_s4_q;
  logic age_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic begins_product_s4_q;
  logic done_s4_q;
  logic [5:0] select_299_s4_q;
  logic and_305_s4_q;
  logic and_333_s4_q;
  logic and_334_s4_q;
  logic select_337_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_340_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic equal_349_s4_q;
  logic not_350_s4_q;
  logic equal_351_s4_q;
  logic less_352_s4_q;
  logic not_353_s4_q;
  logic less_357_s4_q;
  logic less_358_s4_q;
  logic less_359_s4_q;
  logic less_360_s4_q;
  logic less_361_s4_q;
  logic less_362_s4_q;
  logic less_363_s4_q;
  logic less_364_s4_q;
  logic less_365_s4_q;
  logic less_366_s4_q;
  logic less_367_s4_q;
  logic less_368_s4_q;
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
  logic and_387_s4_q;
  logic and_412_s4_q;
  logic and_413_s4_q;
  logic [11:0] texture_s4_q;
  logic [5:0] x_s4_2_q;
  logic not_491_s4_q;
  logic [7:0] best_left_rdata_s4_q;
  logic equal_496_s4_q;
  logic select_792_s4_q;
  logic less_798_s4_q;
  logic less_799_s4_q;
  logic or_801_s4_q;
  logic [7:0] select_805_s4_q;
  logic [5:0] select_809_s4_q;
  logic equal_814_s4_q;
  logic difference_825_s4_q;
  logic [1:0] sum_826_s4_q;
  logic [8:0] twice_s4_q;
  logic [9:0] difference_838_s4_q;
  logic and_858_s4_q;
  logic or_877_s4_q;
  logic or_880_s4_q;
  logic or_883_s4_q;
  logic equal_890_s4_q;
  logic equal_891_s4_q;
  logic and_901_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic near_s4_q;
  logic and_930_s4_q;
  logic and_956_s4_q;
  logic less_957_s4_q;
  logic [11:0] sum_965_s4_q;
  logic [2:0] textured_2_s4_q;
  logic equal_976_s4_q;
  logic or_984_s4_q;
  logic or_987_s4_q;
  logic or_990_s4_q;
  logic [2:0] explained_2_s4_q;
  logic [2:0] near_2_s4_q;
  logic and_1037_s4_q;
  logic [11:0] sum_1377_s4_q;
  logic equal_1399_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic not_1550_s4_q;
  logic select_1673_s4_q;
  logic and_1678_s4_q;
  logic or_1698_s4_q;
  logic and_1757_s4_q;
  logic equal_1760_s4_q;
  logic equal_1761_s4_q;
  logic equal_1762_s4_q;
  logic [7:0] residual_s4_q;
  logic equal_2104_s4_q;
  logic less_2110_s4_q;
  logic and_2294_s4_q;
  logic less_2371_s4_q;
  logic less_2374_s4_q;
  logic or_2377_s4_q;
  logic less_2379_s4_q;
  logic or_2384_s4_q;
  logic less_2385_s4_q;
  logic or_2391_s4_q;
  logic select_2428_s4_q;
  logic or_2430_s4_q;
  logic less_2432_s4_q;
  logic less_2435_s4_q;
  logic select_2439_s4_q;
  logic and_2483_s4_q;
  logic [11:0] select_2508_s4_q;
  logic [11:0] select_2513_s4_q;
  logic [11:0] select_2518_s4_q;
  logic [11:0] select_2523_s4_q;
  logic and_2546_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      x_s4_q <= x_s3_q[5:0];
      age_s4_q <= age_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      begins_product_s4_q <= begins_product_q;
      done_s4_q <= done_q;
      select_299_s4_q <= select_299_s3_q;
      and_305_s4_q <= and_305_s3_q;
      and_333_s4_q <= and_333_s3_q;
      and_334_s4_q <= and_334_s3_q;
      select_337_s4_q <= select_337_s3_q;
      grey_s4_q <= grey;
      equal_340_s4_q <= equal_340_s3_q;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      equal_349_s4_q <= equal_349_s3_q;
      not_350_s4_q <= not_350_s3_q;
      equal_351_s4_q <= equal_351_s3_q;
      less_352_s4_q <= less_352_s3_q;
      not_353_s4_q <= not_353_s3_q;
      less_357_s4_q <= less_357;
      less_358_s4_q <= less_358;
      less_359_s4_q <= less_359;
      less_360_s4_q <= less_360;
      less_361_s4_q <= less_361;
      less_362_s4_q <= less_362;
      less_363_s4_q <= less_363;
      less_364_s4_q <= less_364;
      less_365_s4_q <= less_365;
      less_366_s4_q <= less_366;
      less_367_s4_q <= less_367;
      less_368_s4_q <= less_368;
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
      and_387_s4_q <= and_387;
      and_412_s4_q <= whole_22 & and_387;
      and_413_s4_q <= census_columns_values_1_cell_2_mask_q & and_387;
      texture_s4_q <= texture;
      x_s4_2_q <= x_s3_2_q[5:0];
      not_491_s4_q <= not_491_s3_q;
      best_left_rdata_s4_q <= best_left_rdata_s3_q[21:14];
      equal_496_s4_q <= equal_496_s3_q;
      select_792_s4_q <= select_792[0];
      less_798_s4_q <= less_798;
      less_799_s4_q <= less_799;
      or_801_s4_q <= or_801;
      select_805_s4_q <= equal_496_s3_q ? of_best_2 : select_804;
      select_809_s4_q <= equal_496_s3_q ? run_shift_s3_q : select_808;
      equal_814_s4_q <= {less_791, select_792} == near_best;
      difference_825_s4_q <= difference_825[8];
      sum_826_s4_q <= {less_791, select_792[1]} + 2'h3;
      twice_s4_q <= twice;
      difference_838_s4_q <= difference_838;
      and_858_s4_q <= and_858_s3_q;
      or_877_s4_q <= or_877;
      or_880_s4_q <= or_880;
      or_883_s4_q <= or_883;
      equal_890_s4_q <= equal_890_s3_q;
      equal_891_s4_q <= equal_891;
      and_901_s4_q <= and_901_s3_q;
      textured_s4_q <= textured;
      explained_s4_q <= explained;
      near_s4_q <= near;
      and_930_s4_q <= not_350_s3_q & (not_491_s3_q & (drew_s3_q & and_889));
      and_956_s4_q <= and_956;
      less_957_s4_q <= less_957;
      sum_965_s4_q <= sum_965;
      textured_2_s4_q <= textured_2;
      equal_976_s4_q <= x_s3_q == 8'h0;
      or_984_s4_q <= or_984;
      or_987_s4_q <= select_981[7] | (~({select_981[6], select_981[3:2]} == 3'h0));
      or_990_s4_q <= select_981[7] | (~(select_981[6:4] == 3'h0));
      explained_2_s4_q <= explained_2;
      near_2_s4_q <= near_2;
      and_1037_s4_q <= and_1037_s3_q;
      sum_1377_s4_q <= ({1'b0, sum_1369} + {2'h0, sum_1372}) + {2'h0, sum_1376};
      equal_1399_s4_q <= equal_1399_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      not_1550_s4_q <= not_1550_s3_q;
      select_1673_s4_q <= select_1673;
      and_1678_s4_q <= and_1678;
      or_1698_s4_q <= (x_s3_q[7:1] == 7'h0) | (~centres_values_1_q);
      and_1757_s4_q <= and_1757;
      equal_1760_s4_q <= equal_1760;
      equal_1761_s4_q <= equal_1761;
      equal_1762_s4_q <= equal_1762;
      residual_s4_q <= residual[7:0];
      equal_2104_s4_q <= equal_2104;
      less_2110_s4_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      and_2294_s4_q <= and_1037_s3_q & (sum_965 == sum_949);
      less_2371_s4_q <= less_2371;
      less_2374_s4_q <= less_2374;
      or_2377_s4_q <= or_2377;
      less_2379_s4_q <= less_2379;
      or_2384_s4_q <= or_2384;
      less_2385_s4_q <= less_2385;
      or_2391_s4_q <= or_2391;
      select_2428_s4_q <= select_2428;
      or_2430_s4_q <= or_2430;
      less_2432_s4_q <= $signed(15'h0) < $signed(counts_half_votes_1_down_q);
      less_2435_s4_q <= $signed(15'h0) < $signed(counts_half_votes_0_down_q);
      select_2439_s4_q <= less_2397 ? or_2427 : select_2424;
      and_2483_s4_q <= not_350_s3_q & (not_491_s3_q & and_2481);
      select_2508_s4_q <= select_2508;
      select_2513_s4_q <= select_2513;
      select_2518_s4_q <= select_2518;
      select_2523_s4_q <= select_2523;
      and_2546_s4_q <= not_350_s3_q & (not_491_s3_q & (not_1550_s3_q & and_893));
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
  logic [19:0] counts_across_0_q;
  logic [19:0] counts_across_1_q;
  logic [19:0] counts_across_2_q;
  logic [19:0] counts_across_3_q;
  logic [14:0] counts_votes_0_down_q;
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
  // hls/stages/census.hpp:193
  logic [12:0] sum_433;
  assign sum_433 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_435;
  assign sum_435 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_433});
  // hls/stages/census.hpp:214
  logic less_436;
  assign less_436 = 9'h4 < sum_435[13:5];
  logic and_437;
  assign and_437 = and_387_s4_q & less_436;
  // hls/stages/agreement.hpp:443
  logic not_839;
  assign not_839 = ~difference_838_s4_q[9];
  logic [8:0] xor_840;
  assign xor_840 = twice_s4_q ^ {9{not_839}};
  logic [10:0] sum_841;
  assign sum_841 = {difference_838_s4_q[8:0], 1'b0, not_839} + {not_839, xor_840, not_839};
  logic not_842;
  assign not_842 = ~sum_841[10];
  logic [8:0] xor_843;
  assign xor_843 = twice_s4_q ^ {9{not_842}};
  logic [10:0] sum_844;
  assign sum_844 = {sum_841[9:0], not_842} + {not_842, xor_843, not_842};
  logic not_845;
  assign not_845 = ~sum_844[10];
  logic [8:0] xor_846;
  assign xor_846 = twice_s4_q ^ {9{not_845}};
  logic [10:0] sum_847;
  assign sum_847 = {sum_844[9:0], not_845} + {not_845, xor_846, not_845};
  logic not_848;
  assign not_848 = ~sum_847[10];
  logic [8:0] xor_849;
  assign xor_849 = twice_s4_q ^ {9{not_848}};
  logic [10:0] sum_850;
  assign sum_850 = {sum_847[9:0], not_848} + {not_848, xor_849, not_848};
  // hls/stages/agreement.hpp:446
  logic [7:0] difference_851;
  assign difference_851 = {sum_826_s4_q, select_792_s4_q, 5'h0} - {3'h0, difference_838_s4_q[9], sum_841[10], sum_844[10], sum_847[10], sum_850[10]};
  // hls/stages/agreement.hpp:426
  logic [7:0] select_852;
  assign select_852 = difference_825_s4_q ? difference_851 : {sum_826_s4_q, select_792_s4_q, difference_838_s4_q[9], sum_841[10], sum_844[10], sum_847[10], sum_850[10]};
  logic [7:0] select_853;
  assign select_853 = equal_814_s4_q ? select_852 : {sum_826_s4_q, select_792_s4_q, 5'h0};
  // hls/stages/agreement.hpp:428
  logic [7:0] select_856;
  assign select_856 = less_798_s4_q ? (or_801_s4_q ? select_853 : best_left_rdata_s4_q) : (less_799_s4_q ? select_853 : best_left_rdata_s4_q);
  logic [7:0] select_857;
  assign select_857 = equal_496_s4_q ? select_853 : select_856;
  // hls/stages/agreement.hpp:528
  logic [5:0] select_903;
  assign select_903 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:529
  logic [5:0] sum_904;
  assign sum_904 = {5'h0, textured_s4_q} + select_903;
  // hls/stages/agreement.hpp:657
  logic [11:0] sum_906;
  assign sum_906 = {6'h0, sum_904} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[11:0]);
  // hls/stages/agreement.hpp:528
  logic [5:0] select_914;
  assign select_914 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:529
  logic [5:0] sum_915;
  assign sum_915 = {5'h0, explained_s4_q} + select_914;
  // hls/stages/agreement.hpp:658
  logic [11:0] sum_917;
  assign sum_917 = {6'h0, sum_915} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[23:12]);
  // hls/stages/agreement.hpp:528
  logic [5:0] select_924;
  assign select_924 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:530
  logic [5:0] sum_925;
  assign sum_925 = {5'h0, near_s4_q} + select_924;
  // hls/stages/agreement.hpp:659
  logic [11:0] sum_927;
  assign sum_927 = {6'h0, sum_925} + (region_fresh_s4_q ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:683
  logic [4:0] difference_975;
  assign difference_975 = {2'h0, textured_2_s4_q} - (age_s4_q ? box_textured_columns_values_4_q : 5'h0);
  logic [4:0] t;
  assign t = difference_975 + (equal_976_s4_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:689
  logic not_991;
  assign not_991 = ~region_row_s4_q[2];
  logic [2:0] select_992;
  assign select_992 = region_row_s4_q[1] ? {1'b0, not_991, 1'b0} : {region_row_s4_q[2], 1'b0, not_991};
  logic [5:0] select_993;
  assign select_993 = region_row_s4_q[0] ? {select_992[2], 1'b0, select_992[1], 1'b0, select_992[0], 1'b0} : {1'b0, select_992[2], 1'b0, select_992[1], 1'b0, select_992[0]};
  logic [11:0] select_994;
  assign select_994 = or_990_s4_q ? {select_993[5], 1'b0, select_993[4], 1'b0, select_993[3], 1'b0, select_993[2], 1'b0, select_993[1], 1'b0, select_993[0], 1'b0} : {1'b0, select_993[5], 1'b0, select_993[4], 1'b0, select_993[3], 1'b0, select_993[2], 1'b0, select_993[1], 1'b0, select_993[0]};
  logic [23:0] select_995;
  assign select_995 = or_987_s4_q ? {select_994[11], 1'b0, select_994[10], 1'b0, select_994[9], 1'b0, select_994[8], 1'b0, select_994[7], 1'b0, select_994[6], 1'b0, select_994[5], 1'b0, select_994[4], 1'b0, select_994[3], 1'b0, select_994[2], 1'b0, select_994[1], 1'b0, select_994[0], 1'b0} : {1'b0, select_994[11], 1'b0, select_994[10], 1'b0, select_994[9], 1'b0, select_994[8], 1'b0, select_994[7], 1'b0, select_994[6], 1'b0, select_994[5], 1'b0, select_994[4], 1'b0, select_994[3], 1'b0, select_994[2], 1'b0, select_994[1], 1'b0, select_994[0]};
  logic [47:0] select_996;
  assign select_996 = or_984_s4_q ? {select_995[23], 1'b0, select_995[22], 1'b0, select_995[21], 1'b0, select_995[20], 1'b0, select_995[19], 1'b0, select_995[18], 1'b0, select_995[17], 1'b0, select_995[16], 1'b0, select_995[15], 1'b0, select_995[14], 1'b0, select_995[13], 1'b0, select_995[12], 1'b0, select_995[11], 1'b0, select_995[10], 1'b0, select_995[9], 1'b0, select_995[8], 1'b0, select_995[7], 1'b0, select_995[6], 1'b0, select_995[5], 1'b0, select_995[4], 1'b0, select_995[3], 1'b0, select_995[2], 1'b0, select_995[1], 1'b0, select_995[0], 1'b0} : {1'b0, select_995[23], 1'b0, select_995[22], 1'b0, select_995[21], 1'b0, select_995[20], 1'b0, select_995[19], 1'b0, select_995[18], 1'b0, select_995[17], 1'b0, select_995[16], 1'b0, select_995[15], 1'b0, select_995[14], 1'b0, select_995[13], 1'b0, select_995[12], 1'b0, select_995[11], 1'b0, select_995[10], 1'b0, select_995[9], 1'b0, select_995[8], 1'b0, select_995[7], 1'b0, select_995[6], 1'b0, select_995[5], 1'b0, select_995[4], 1'b0, select_995[3], 1'b0, select_995[2], 1'b0, select_995[1], 1'b0, select_995[0]};
  // hls/stages/agreement.hpp:684
  logic [4:0] difference_1008;
  assign difference_1008 = {2'h0, explained_2_s4_q} - (age_s4_q ? box_explained_columns_values_4_q : 5'h0);
  logic [4:0] e;
  assign e = difference_1008 + (equal_976_s4_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:690
  logic [5:0] sum_1011;
  assign sum_1011 = {1'b0, e} + {2'h0, e[4:1]};
  logic is_seen;
  assign is_seen = (t[4:1] == 4'h0) ? (~((good_q & select_996) == 48'h0)) : (~({sum_1011, e[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:685
  logic [4:0] difference_1022;
  assign difference_1022 = {2'h0, near_2_s4_q} - (age_s4_q ? box_nearer_columns_values_4_q : 5'h0);
  logic [4:0] n;
  assign n = difference_1022 + (equal_976_s4_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:698
  logic and_1026;
  assign and_1026 = is_seen & ({1'b0, e[4:1]} < n);
  // hls/stages/census.hpp:127
  logic [8:0] select_1085;
  assign select_1085 = and_333_s4_q ? grey_s4_q : averager_quarter_1_0_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1087;
  assign select_1087 = left_first_s4_q ? select_1085 : (and_305_s4_q ? select_1085 : averager_quarter_1_0_q);
  // hls/stages/census.hpp:127
  logic [8:0] select_1089;
  assign select_1089 = and_333_s4_q ? grey_2_s4_q : averager_quarter_1_1_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1091;
  assign select_1091 = left_first_s4_q ? select_1089 : (and_305_s4_q ? select_1089 : averager_quarter_1_1_q);
  // hls/stages/census.hpp:126
  logic [8:0] select_1093;
  assign select_1093 = and_333_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1095;
  assign select_1095 = left_first_s4_q ? select_1093 : (and_305_s4_q ? select_1093 : averager_quarter_2_0_q);
  // hls/stages/census.hpp:126
  logic [8:0] select_1097;
  assign select_1097 = and_333_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
  // hls/stages/agreement.hpp:176
  logic [8:0] select_1099;
  assign select_1099 = left_first_s4_q ? select_1097 : (and_305_s4_q ? select_1097 : averager_quarter_2_1_q);
  // hls/stages/census.hpp:123
  logic [9:0] sum_1109;
  assign sum_1109 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_1110;
  assign difference_1110 = {1'b0, sum_1109[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:124
  logic [9:0] xor_1111;
  assign xor_1111 = {difference_1110[8:0], sum_1109[0]} ^ {10{difference_1110[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1110[9]} + {1'b0, xor_1111};
  // hls/stages/census.hpp:125
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_340_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/census.hpp:129
  logic [13:0] select_1115;
  assign select_1115 = and_333_s4_q ? detail : averager_detail_0_q;
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1117;
  assign select_1117 = left_first_s4_q ? select_1115 : (and_305_s4_q ? select_1115 : averager_detail_0_q);
  // hls/stages/census.hpp:123
  logic [9:0] sum_1119;
  assign sum_1119 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_1120;
  assign difference_1120 = {1'b0, sum_1119[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:124
  logic [9:0] xor_1121;
  assign xor_1121 = {difference_1120[8:0], sum_1119[0]} ^ {10{difference_1120[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1120[9]} + {1'b0, xor_1121};
  // hls/stages/census.hpp:125
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_340_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/census.hpp:129
  logic [13:0] select_1125;
  assign select_1125 = and_333_s4_q ? detail_2 : averager_detail_1_q;
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1127;
  assign select_1127 = left_first_s4_q ? select_1125 : (and_305_s4_q ? select_1125 : averager_detail_1_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1355;
  assign select_1355 = and_334_s4_q ? texture_s4_q : census_changes_values_0_left_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1357;
  assign select_1357 = left_first_s4_q ? select_1355 : (and_305_s4_q ? select_1355 : census_changes_values_0_left_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1378;
  assign select_1378 = and_334_s4_q ? sum_1377_s4_q : census_changes_values_0_right_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1380;
  assign select_1380 = left_first_s4_q ? select_1378 : (and_305_s4_q ? select_1378 : census_changes_values_0_right_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1382;
  assign select_1382 = and_334_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1384;
  assign select_1384 = left_first_s4_q ? select_1382 : (and_305_s4_q ? select_1382 : census_changes_values_1_left_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1386;
  assign select_1386 = and_334_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1388;
  assign select_1388 = left_first_s4_q ? select_1386 : (and_305_s4_q ? select_1386 : census_changes_values_1_right_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1390;
  assign select_1390 = and_334_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1392;
  assign select_1392 = left_first_s4_q ? select_1390 : (and_305_s4_q ? select_1390 : census_changes_values_2_left_q);
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1394;
  assign select_1394 = and_334_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/agreement.hpp:176
  logic [11:0] select_1396;
  assign select_1396 = left_first_s4_q ? select_1394 : (and_305_s4_q ? select_1394 : census_changes_values_2_right_q);
  // hls/stages/census.hpp:194
  logic [12:0] sum_1400;
  assign sum_1400 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1377_s4_q};
  logic [13:0] sum_1402;
  assign sum_1402 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_1400});
  // hls/stages/census.hpp:216
  logic and_1404;
  assign and_1404 = and_412_s4_q & (9'h4 < sum_1402[13:5]);
  // hls/stages/census.hpp:217
  logic and_1405;
  assign and_1405 = and_412_s4_q & less_436;
  // hls/stages/census.hpp:218
  logic [19:0] sum_1406;
  assign sum_1406 = census_left_misses_q + {{17{and_1405}}, and_1404, 1'b0, and_1404};
  // hls/stages/agreement.hpp:173
  logic [19:0] select_1408;
  assign select_1408 = and_334_s4_q ? (equal_1399_s4_q ? 20'h0 : sum_1406) : census_left_misses_q;
  // hls/stages/agreement.hpp:176
  logic [19:0] select_1410;
  assign select_1410 = left_first_s4_q ? select_1408 : (and_305_s4_q ? select_1408 : census_left_misses_q);
  // hls/stages/agreement.hpp:173
  logic select_1424;
  assign select_1424 = and_334_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
  // hls/stages/agreement.hpp:176
  logic select_1426;
  assign select_1426 = left_first_s4_q ? select_1424 : (and_305_s4_q ? select_1424 : sharpness_last_mask_q);
  // hls/stages/agreement.hpp:173
  logic [13:0] select_1428;
  assign select_1428 = and_334_s4_q ? detail : sharpness_last_detail_0_q;
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1430;
  assign select_1430 = left_first_s4_q ? select_1428 : (and_305_s4_q ? select_1428 : sharpness_last_detail_0_q);
  // hls/stages/agreement.hpp:173
  logic [13:0] select_1432;
  assign select_1432 = and_334_s4_q ? detail_2 : sharpness_last_detail_1_q;
  // hls/stages/agreement.hpp:176
  logic [13:0] select_1434;
  assign select_1434 = left_first_s4_q ? select_1432 : (and_305_s4_q ? select_1432 : sharpness_last_detail_1_q);
  // hls/stages/census.hpp:265
  logic and_1438;
  assign and_1438 = whole_2_s4_q & (~(select_299_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:240
  logic and_1444;
  assign and_1444 = and_1438 & (sharpness_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail};
  // hls/stages/census.hpp:266
  logic [12:0] select_1446;
  assign select_1446 = and_1444 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:267
  logic [23:0] select_1448;
  assign select_1448 = equal_1399_s4_q ? {11'h0, select_1446} : (sharpness_sums_detail_0_q + {11'h0, select_1446});
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1449;
  assign select_1449 = and_334_s4_q ? select_1448 : sharpness_sums_detail_0_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1451;
  assign select_1451 = left_first_s4_q ? select_1449 : (and_305_s4_q ? select_1449 : sharpness_sums_detail_0_q);
  // hls/stages/agreement.hpp:240
  logic and_1458;
  assign and_1458 = and_1438 & (sharpness_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2};
  // hls/stages/census.hpp:266
  logic [12:0] select_1460;
  assign select_1460 = and_1458 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:267
  logic [23:0] select_1462;
  assign select_1462 = equal_1399_s4_q ? {11'h0, select_1460} : (sharpness_sums_detail_1_q + {11'h0, select_1460});
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1463;
  assign select_1463 = and_334_s4_q ? select_1462 : sharpness_sums_detail_1_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1465;
  assign select_1465 = left_first_s4_q ? select_1463 : (and_305_s4_q ? select_1463 : sharpness_sums_detail_1_q);
  // hls/stages/census.hpp:267
  logic [8:0] select_1468;
  assign select_1468 = and_1444 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_1469;
  assign sum_1469 = (equal_1399_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1468};
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1470;
  assign select_1470 = and_334_s4_q ? sum_1469 : sharpness_sums_contrast_0_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1472;
  assign select_1472 = left_first_s4_q ? select_1470 : (and_305_s4_q ? select_1470 : sharpness_sums_contrast_0_q);
  // hls/stages/census.hpp:267
  logic [8:0] select_1475;
  assign select_1475 = and_1458 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_1476;
  assign sum_1476 = (equal_1399_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1475};
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1477;
  assign select_1477 = and_334_s4_q ? sum_1476 : sharpness_sums_contrast_1_q;
  // hls/stages/agreement.hpp:176
  logic [23:0] select_1479;
  assign select_1479 = left_first_s4_q ? select_1477 : (and_305_s4_q ? select_1477 : sharpness_sums_contrast_1_q);
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1680;
  assign select_1680 = select_1673_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1678_s4_q});
  // hls/stages/agreement.hpp:298
  logic and_1683;
  assign and_1683 = not_350_s4_q & (not_491_s4_q & (begins_product_q & textured_s4_q));
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1685;
  assign select_1685 = select_1673_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_1683});
  // hls/stages/agreement.hpp:298
  logic and_1688;
  assign and_1688 = not_350_s4_q & (not_491_s4_q & (begins_product_q & explained_s4_q));
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1690;
  assign select_1690 = select_1673_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_1688});
  // hls/stages/agreement.hpp:298
  logic and_1693;
  assign and_1693 = not_350_s4_q & (not_491_s4_q & (begins_product_q & near_s4_q));
  // hls/stages/agreement.hpp:692
  logic or_1699;
  assign or_1699 = is_seen | or_1698_s4_q;
  // hls/stages/agreement.hpp:298
  logic and_1703;
  assign and_1703 = not_350_s4_q & (not_491_s4_q & (begins_product_q & (~or_1699)));
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1705;
  assign select_1705 = select_1673_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1703});
  // hls/stages/agreement.hpp:716
  logic less_1706;
  assign less_1706 = region_row_s4_q < x_s4_q[5:3];
  logic [11:0] select_1707;
  assign select_1707 = less_1706 ? 12'h0 : regions_rdata_q[11:0];
  logic [11:0] select_1710;
  assign select_1710 = less_1706 ? 12'h0 : regions_rdata_q[23:12];
  // hls/stages/agreement.hpp:717
  logic [12:0] sum_1711;
  assign sum_1711 = {1'b0, select_1710} + {3'h0, select_1710[11:2]};
  logic and_1713;
  assign and_1713 = (~(select_1707[11:4] == 8'h0)) & ({sum_1711, select_1710[1:0]} < {3'h0, select_1707});
  // hls/stages/agreement.hpp:298
  logic [11:0] select_1716;
  assign select_1716 = equal_890_s4_q ? (equal_891_s4_q ? 12'h0 : (and_1713 ? select_1707 : 12'h0)) : 12'h0;
  logic [11:0] select_1718;
  assign select_1718 = equal_351_s4_q ? 12'h0 : (begins_product_q ? 12'h0 : select_1716);
  logic [11:0] select_1719;
  assign select_1719 = equal_349_s4_q ? 12'h0 : select_1718;
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1721;
  assign select_1721 = select_1673_s4_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1719});
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1731;
  assign select_1731 = less_352_s4_q ? 9'h0 : (and_901_s4_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [20:0] select_1732;
  assign select_1732 = begins_product_q ? {{12{select_1731[8]}}, select_1731} : {1'b0, select_1716, 8'h0};
  logic [20:0] select_1734;
  assign select_1734 = equal_349_s4_q ? 21'h0 : (equal_351_s4_q ? 21'h0 : select_1732);
  // hls/stages/agreement.hpp:554
  logic [23:0] select_1736;
  assign select_1736 = select_1673_s4_q ? 24'h0 : (counts_too_many_bad_q + {{3{select_1734[20]}}, select_1734});
  // hls/stages/agreement.hpp:596
  logic [8:0] select_1738;
  assign select_1738 = and_901_s4_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1739;
  assign select_1739 = less_352_s4_q ? 8'h0 : select_1738[7:0];
  // hls/stages/agreement.hpp:162
  logic and_1740;
  assign and_1740 = not_353_s4_q & select_1738[8];
  // hls/stages/agreement.hpp:696
  logic [2:0] select_1742;
  assign select_1742 = or_1699 ? {3{and_1740}} : ({3{and_1740}} + 3'h1);
  // hls/stages/agreement.hpp:298
  logic [10:0] select_1744;
  assign select_1744 = equal_351_s4_q ? 11'h0 : (begins_product_q ? {select_1742, select_1739} : 11'h0);
  logic [10:0] select_1745;
  assign select_1745 = equal_349_s4_q ? 11'h0 : select_1744;
  // hls/stages/agreement.hpp:546
  logic [23:0] sum_1746;
  assign sum_1746 = counts_too_much_unproven_q + {{13{select_1745[10]}}, select_1745};
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1800;
  assign select_1800 = equal_1761_s4_q ? 8'h0 : (equal_1762_s4_q ? 8'h0 : residual_s4_q);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1803;
  assign select_1803 = less_352_s4_q ? 8'h0 : (and_1757_s4_q ? (equal_1760_s4_q ? 8'h0 : select_1800) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1806;
  assign select_1806 = equal_349_s4_q ? 8'h0 : (equal_351_s4_q ? 8'h0 : (begins_product_q ? select_1803 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1808;
  assign select_1808 = select_1673_s4_q ? 20'h0 : (counts_across_0_q + {{12{select_1806[7]}}, select_1806});
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1810;
  assign select_1810 = equal_1761_s4_q ? 8'h0 : (equal_1762_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1813;
  assign select_1813 = less_352_s4_q ? 8'h0 : (and_1757_s4_q ? (equal_1760_s4_q ? 8'h0 : select_1810) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1816;
  assign select_1816 = equal_349_s4_q ? 8'h0 : (equal_351_s4_q ? 8'h0 : (begins_product_q ? select_1813 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1818;
  assign select_1818 = select_1673_s4_q ? 20'h0 : (counts_across_1_q + {{12{select_1816[7]}}, select_1816});
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1820;
  assign select_1820 = equal_1760_s4_q ? 8'h0 : (equal_1761_s4_q ? residual_s4_q : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1823;
  assign select_1823 = begins_product_q ? (less_352_s4_q ? 8'h0 : (and_1757_s4_q ? select_1820 : 8'h0)) : 8'h0;
  logic [7:0] select_1825;
  assign select_1825 = equal_349_s4_q ? 8'h0 : (equal_351_s4_q ? 8'h0 : select_1823);
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1827;
  assign select_1827 = select_1673_s4_q ? 20'h0 : (counts_across_2_q + {{12{select_1825[7]}}, select_1825});
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1830;
  assign select_1830 = less_352_s4_q ? 8'h0 : (and_1757_s4_q ? (equal_1760_s4_q ? residual_s4_q : 8'h0) : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1833;
  assign select_1833 = equal_349_s4_q ? 8'h0 : (equal_351_s4_q ? 8'h0 : (begins_product_q ? select_1830 : 8'h0));
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1835;
  assign select_1835 = select_1673_s4_q ? 20'h0 : (counts_across_3_q + {{12{select_1833[7]}}, select_1833});
  // hls/stages/agreement.hpp:162
  logic and_1873;
  assign and_1873 = and_1757_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1875;
  assign select_1875 = begins_product_q ? (less_352_s4_q ? 2'h0 : {and_1873, and_1757_s4_q}) : 2'h0;
  logic [1:0] to_down;
  assign to_down = equal_349_s4_q ? 2'h0 : (equal_351_s4_q ? 2'h0 : select_1875);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1879;
  assign select_1879 = select_1673_s4_q ? 15'h0 : (counts_votes_0_down_q + {{13{to_down[1]}}, to_down});
  // hls/stages/agreement.hpp:712
  logic and_2109;
  assign and_2109 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:719
  logic [12:0] sum_2113;
  assign sum_2113 = {1'b0, select_1710} + {2'h0, select_1710[11:1]};
  logic select_2116;
  assign select_2116 = (select_1707[11:3] == 9'h0) ? (and_2109 & (~less_2110_s4_q)) : (~({sum_2113, select_1710[0]} < {2'h0, select_1707}));
  // hls/stages/agreement.hpp:727
  logic [47:0] select_2117;
  assign select_2117 = equal_891_s4_q ? good_next_q : {select_2116, good_next_q[47:1]};
  // hls/stages/agreement.hpp:298
  logic [47:0] select_2119;
  assign select_2119 = equal_890_s4_q ? (equal_2104_s4_q ? select_2117 : good_q) : good_q;
  logic [47:0] select_2121;
  assign select_2121 = equal_351_s4_q ? good_q : (begins_product_q ? good_q : select_2119);
  logic [47:0] select_2124;
  assign select_2124 = begins_product_q ? good_next_q : (equal_890_s4_q ? select_2117 : good_next_q);
  logic [47:0] select_2126;
  assign select_2126 = equal_349_s4_q ? good_next_q : (equal_351_s4_q ? good_next_q : select_2124);
  // hls/stages/agreement.hpp:744
  logic [35:0] select_2147;
  assign select_2147 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:738
  logic [35:0] detail_left;
  assign detail_left = begins_product_s4_q ? 36'h0 : select_2147;
  // hls/stages/agreement.hpp:744
  logic [35:0] select_2150;
  assign select_2150 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:748
  logic [35:0] detail_right;
  assign detail_right = begins_product_s4_q ? 36'h0 : select_2150;
  // hls/stages/agreement.hpp:738
  logic [34:0] select_2152;
  assign select_2152 = begins_product_s4_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:748
  logic [34:0] select_2153;
  assign select_2153 = begins_product_s4_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:738
  logic [17:0] select_2154;
  assign select_2154 = begins_product_s4_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:748
  logic [17:0] select_2155;
  assign select_2155 = begins_product_s4_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:298
  logic [4:0] select_2156;
  assign select_2156 = begins_product_q ? {2'h0, textured_2_s4_q} : box_textured_columns_values_0_q;
  logic [4:0] select_2158;
  assign select_2158 = equal_349_s4_q ? box_textured_columns_values_0_q : (equal_351_s4_q ? box_textured_columns_values_0_q : select_2156);
  logic [4:0] select_2159;
  assign select_2159 = begins_product_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_2161;
  assign select_2161 = equal_349_s4_q ? box_textured_columns_values_1_q : (equal_351_s4_q ? box_textured_columns_values_1_q : select_2159);
  logic [4:0] select_2162;
  assign select_2162 = begins_product_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_2164;
  assign select_2164 = equal_349_s4_q ? box_textured_columns_values_2_q : (equal_351_s4_q ? box_textured_columns_values_2_q : select_2162);
  logic [4:0] select_2165;
  assign select_2165 = begins_product_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_2167;
  assign select_2167 = equal_349_s4_q ? box_textured_columns_values_3_q : (equal_351_s4_q ? box_textured_columns_values_3_q : select_2165);
  logic [4:0] select_2168;
  assign select_2168 = begins_product_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_2170;
  assign select_2170 = equal_349_s4_q ? box_textured_columns_values_4_q : (equal_351_s4_q ? box_textured_columns_values_4_q : select_2168);
  logic [4:0] select_2172;
  assign select_2172 = equal_351_s4_q ? box_textured_sum_sums_values_0_q : (begins_product_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_2174;
  assign select_2174 = begins_product_q ? {2'h0, explained_2_s4_q} : box_explained_columns_values_0_q;
  logic [4:0] select_2176;
  assign select_2176 = equal_349_s4_q ? box_explained_columns_values_0_q : (equal_351_s4_q ? box_explained_columns_values_0_q : select_2174);
  logic [4:0] select_2177;
  assign select_2177 = begins_product_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_2179;
  assign select_2179 = equal_349_s4_q ? box_explained_columns_values_1_q : (equal_351_s4_q ? box_explained_columns_values_1_q : select_2177);
  logic [4:0] select_2180;
  assign select_2180 = begins_product_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_2182;
  assign select_2182 = equal_349_s4_q ? box_explained_columns_values_2_q : (equal_351_s4_q ? box_explained_columns_values_2_q : select_2180);
  logic [4:0] select_2183;
  assign select_2183 = begins_product_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_2185;
  assign select_2185 = equal_349_s4_q ? box_explained_columns_values_3_q : (equal_351_s4_q ? box_explained_columns_values_3_q : select_2183);
  logic [4:0] select_2186;
  assign select_2186 = begins_product_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_2188;
  assign select_2188 = equal_349_s4_q ? box_explained_columns_values_4_q : (equal_351_s4_q ? box_explained_columns_values_4_q : select_2186);
  logic [4:0] select_2190;
  assign select_2190 = equal_351_s4_q ? box_explained_sum_sums_values_0_q : (begins_product_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_2192;
  assign select_2192 = begins_product_q ? {2'h0, near_2_s4_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_2194;
  assign select_2194 = equal_349_s4_q ? box_nearer_columns_values_0_q : (equal_351_s4_q ? box_nearer_columns_values_0_q : select_2192);
  logic [4:0] select_2195;
  assign select_2195 = begins_product_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_2197;
  assign select_2197 = equal_349_s4_q ? box_nearer_columns_values_1_q : (equal_351_s4_q ? box_nearer_columns_values_1_q : select_2195);
  logic [4:0] select_2198;
  assign select_2198 = begins_product_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_2200;
  assign select_2200 = equal_349_s4_q ? box_nearer_columns_values_2_q : (equal_351_s4_q ? box_nearer_columns_values_2_q : select_2198);
  logic [4:0] select_2201;
  assign select_2201 = begins_product_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_2203;
  assign select_2203 = equal_349_s4_q ? box_nearer_columns_values_3_q : (equal_351_s4_q ? box_nearer_columns_values_3_q : select_2201);
  logic [4:0] select_2204;
  assign select_2204 = begins_product_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_2206;
  assign select_2206 = equal_349_s4_q ? box_nearer_columns_values_4_q : (equal_351_s4_q ? box_nearer_columns_values_4_q : select_2204);
  logic [4:0] select_2208;
  assign select_2208 = equal_351_s4_q ? box_nearer_sum_sums_values_0_q : (begins_product_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:818
  logic select_2242;
  assign select_2242 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:176
  logic select_2244;
  assign select_2244 = left_first_s4_q ? done_s4_q : (and_305_s4_q ? select_2242 : proven_q);
  // hls/stages/agreement.hpp:847
  logic [1:0] select_2295;
  assign select_2295 = and_2294_s4_q ? {and_1026, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:848
  logic and_2296;
  assign and_2296 = select_2242 & less_2272;
  // hls/stages/agreement.hpp:176
  logic select_2299;
  assign select_2299 = and_956_s4_q ? (less_957_s4_q ? (select_2295[0] & and_2296) : seen_q) : seen_q;
  logic select_2301;
  assign select_2301 = left_first_s4_q ? select_2299 : (and_305_s4_q ? select_2299 : seen_q);
  logic select_2302;
  assign select_2302 = and_305_s4_q ? select_2301 : seen_q;
  logic select_2305;
  assign select_2305 = and_956_s4_q ? (less_957_s4_q ? (select_2295[1] & and_2296) : nearer_q) : nearer_q;
  logic select_2307;
  assign select_2307 = left_first_s4_q ? select_2305 : (and_305_s4_q ? select_2305 : nearer_q);
  logic select_2308;
  assign select_2308 = and_305_s4_q ? select_2307 : nearer_q;
  // hls/stages/agreement.hpp:298
  logic [13:0] select_2313;
  assign select_2313 = equal_890_s4_q ? (equal_2104_s4_q ? counts_supervised_q : 14'h0) : 14'h0;
  logic [13:0] select_2315;
  assign select_2315 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2313);
  logic [13:0] select_2318;
  assign select_2318 = equal_890_s4_q ? (equal_2104_s4_q ? counts_textured_q : 14'h0) : 14'h0;
  logic [13:0] select_2320;
  assign select_2320 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2318);
  logic [13:0] select_2323;
  assign select_2323 = equal_890_s4_q ? (equal_2104_s4_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_2325;
  assign select_2325 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2323);
  logic [13:0] select_2328;
  assign select_2328 = equal_890_s4_q ? (equal_2104_s4_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_2330;
  assign select_2330 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2328);
  logic [13:0] select_2333;
  assign select_2333 = equal_890_s4_q ? (equal_2104_s4_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_2335;
  assign select_2335 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2333);
  logic [13:0] select_2338;
  assign select_2338 = equal_890_s4_q ? (equal_2104_s4_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_2340;
  assign select_2340 = equal_351_s4_q ? 14'h0 : (begins_product_q ? 14'h0 : select_2338);
  logic and_2346;
  assign and_2346 = not_1550_s4_q & (equal_890_s4_q & (equal_2104_s4_q & (cfg_prove_i & (~proven_q))));
  // hls/stages/agreement.hpp:764
  logic not_2349;
  assign not_2349 = ~and_2109;
  // hls/stages/agreement.hpp:298
  logic and_2353;
  assign and_2353 = not_1550_s4_q & (equal_890_s4_q & (equal_2104_s4_q & (cfg_prove_i & not_2349)));
  // hls/stages/agreement.hpp:765
  logic or_2356;
  assign or_2356 = not_2309 | not_2349;
  // hls/stages/agreement.hpp:731
  logic or_2361;
  assign or_2361 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  // hls/stages/agreement.hpp:298
  logic and_2363;
  assign and_2363 = equal_2104_s4_q & ((less_2110_s4_q | or_2356) ? (~or_2356) : or_2361);
  logic and_2367;
  assign and_2367 = not_350_s4_q & (not_491_s4_q & (not_1550_s4_q & (equal_890_s4_q & and_2363)));
  // hls/stages/agreement.hpp:731
  logic select_2431;
  assign select_2431 = or_2391_s4_q ? select_2428_s4_q : or_2430_s4_q;
  logic or_2433;
  assign or_2433 = less_2432_s4_q | select_2431;
  logic select_2434;
  assign select_2434 = or_2384_s4_q ? select_2431 : or_2433;
  logic or_2436;
  assign or_2436 = less_2435_s4_q | select_2434;
  logic or_2438;
  assign or_2438 = ($signed(15'h0) < $signed(counts_votes_0_down_q)) | (or_2377_s4_q ? select_2434 : or_2436);
  logic select_2441;
  assign select_2441 = less_2379_s4_q ? or_2433 : (less_2385_s4_q ? or_2430_s4_q : select_2439_s4_q);
  logic select_2443;
  assign select_2443 = less_2371_s4_q ? or_2438 : (less_2374_s4_q ? or_2436 : select_2441);
  // hls/stages/agreement.hpp:298
  logic and_2447;
  assign and_2447 = not_1550_s4_q & (equal_890_s4_q & (equal_2104_s4_q & (cfg_prove_i & select_2443)));
  // hls/stages/agreement.hpp:771
  logic and_2450;
  assign and_2450 = cfg_prove_i & and_2109;
  // hls/stages/agreement.hpp:772
  logic [36:0] sum_2451;
  assign sum_2451 = {1'b0, detail_right} + {3'h0, detail_right[35:2]};
  logic less_2453;
  assign less_2453 = {sharpness_sums_contrast_0_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_q};
  // hls/stages/agreement.hpp:731
  logic or_2456;
  assign or_2456 = ({detail_left, 3'h0} < {sum_2451, detail_right[1:0]}) | (less_2453 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:298
  logic and_2460;
  assign and_2460 = not_1550_s4_q & (equal_890_s4_q & (equal_2104_s4_q & (and_2450 & or_2456)));
  // hls/stages/agreement.hpp:775
  logic [36:0] sum_2463;
  assign sum_2463 = {1'b0, detail_left} + {3'h0, detail_left[35:2]};
  logic less_2465;
  assign less_2465 = {sharpness_sums_contrast_1_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_q};
  // hls/stages/agreement.hpp:731
  logic or_2466;
  assign or_2466 = ({detail_right, 3'h0} < {sum_2463, detail_left[1:0]}) | less_2465;
  // hls/stages/agreement.hpp:298
  logic and_2470;
  assign and_2470 = not_1550_s4_q & (equal_890_s4_q & (equal_2104_s4_q & (and_2450 & or_2466)));
  logic [19:0] select_2485;
  assign select_2485 = equal_890_s4_q ? (equal_2104_s4_q ? counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2487;
  assign select_2487 = equal_351_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2485);
  logic [19:0] select_2490;
  assign select_2490 = equal_890_s4_q ? (equal_2104_s4_q ? counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2492;
  assign select_2492 = equal_351_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2490);
  logic [19:0] select_2495;
  assign select_2495 = equal_890_s4_q ? (equal_2104_s4_q ? counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2497;
  assign select_2497 = equal_351_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2495);
  logic [19:0] select_2500;
  assign select_2500 = equal_890_s4_q ? (equal_2104_s4_q ? counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2502;
  assign select_2502 = equal_351_s4_q ? 20'h0 : (begins_product_q ? 20'h0 : select_2500);
  logic [23:0] select_2525;
  assign select_2525 = equal_890_s4_q ? (equal_2104_s4_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2527;
  assign select_2527 = equal_351_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2525);
  logic [23:0] select_2530;
  assign select_2530 = equal_890_s4_q ? (equal_2104_s4_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2532;
  assign select_2532 = equal_351_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2530);
  logic [23:0] select_2535;
  assign select_2535 = equal_890_s4_q ? (equal_2104_s4_q ? sharpness_sums_contrast_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2537;
  assign select_2537 = equal_351_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2535);
  logic [23:0] select_2540;
  assign select_2540 = equal_890_s4_q ? (equal_2104_s4_q ? sharpness_sums_contrast_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2542;
  assign select_2542 = equal_351_s4_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2540);
  logic [5:0] select_2549;
  assign select_2549 = begins_product_q ? 6'h0 : (equal_890_s4_q ? (equal_891_s4_q ? 6'h0 : x_s4_q) : 6'h0);
  logic [11:0] select_2554;
  assign select_2554 = begins_product_q ? 12'h0 : (equal_890_s4_q ? (equal_891_s4_q ? 12'h0 : select_1707) : 12'h0);
  logic [11:0] select_2559;
  assign select_2559 = begins_product_q ? 12'h0 : (equal_890_s4_q ? (equal_891_s4_q ? 12'h0 : select_1710) : 12'h0);
  // hls/stages/agreement.hpp:727
  logic [11:0] select_2563;
  assign select_2563 = equal_891_s4_q ? 12'h0 : (less_1706 ? 12'h0 : regions_rdata_q[35:24]);
  // hls/stages/agreement.hpp:298
  logic [11:0] select_2565;
  assign select_2565 = begins_product_q ? 12'h0 : (equal_890_s4_q ? select_2563 : 12'h0);

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = select_299_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & select_337_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {and_437, and_413_s4_q, and_412_s4_q, and_387_s4_q, less_380_s4_q, less_379_s4_q, less_378_s4_q, less_377_s4_q, less_376_s4_q, less_375_s4_q, less_374_s4_q, less_373_s4_q, less_372_s4_q, less_371_s4_q, less_370_s4_q, less_369_s4_q, less_368_s4_q, less_367_s4_q, less_366_s4_q, less_365_s4_q, less_364_s4_q, less_363_s4_q, less_362_s4_q, less_361_s4_q, less_360_s4_q, less_359_s4_q, less_358_s4_q, less_357_s4_q};
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
  assign best_left_we = s4_en & and_858_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_857, select_809_s4_q, select_805_s4_q};
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
  assign regions_waddr = {region_row_s4_q, or_883_s4_q, or_880_s4_q, or_877_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_930_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_927, sum_917, sum_906};
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
  assign map_waddr = sum_965_s4_q;
  logic map_we;
  assign map_we = s4_en & and_1037_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1026, is_seen};
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
      counts_across_0_q <= 20'h0;
      counts_across_1_q <= 20'h0;
      counts_across_2_q <= 20'h0;
      counts_across_3_q <= 20'h0;
      counts_votes_0_down_q <= 15'h0;
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
      census_left_misses_q <= and_305_s4_q ? select_1410 : census_left_misses_q;
      sharpness_sums_detail_0_q <= and_305_s4_q ? select_1451 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_305_s4_q ? select_1465 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_305_s4_q ? select_1472 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_305_s4_q ? select_1479 : sharpness_sums_contrast_1_q;
      counts_supervised_q <= select_1680;
      counts_textured_q <= select_1685;
      counts_explained_q <= select_1690;
      counts_nearer_q <= select_1673_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1693});
      counts_unproven_q <= select_1705;
      counts_regions_bad_q <= select_1721;
      counts_too_many_bad_q <= select_1736;
      counts_too_much_unproven_q <= select_1673_s4_q ? 24'h0 : sum_1746;
      counts_across_0_q <= select_1808;
      counts_across_1_q <= select_1818;
      counts_across_2_q <= select_1827;
      counts_across_3_q <= select_1835;
      counts_votes_0_down_q <= select_1879;
      segment_textured_q <= select_903 + {5'h0, and_1683};
      segment_explained_q <= select_914 + {5'h0, and_1688};
      segment_nearer_q <= select_924 + {5'h0, and_1693};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_349_s4_q ? good_q : select_2121;
      good_next_q <= select_2126;
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_2152;
      addend_1_q <= select_2153;
      multiplier_0_q <= select_2154;
      multiplier_1_q <= select_2155;
      proven_q <= and_305_s4_q ? select_2244 : proven_q;
      seen_q <= select_2302;
      nearer_q <= select_2308;
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
      averager_quarter_1_0_q <= and_305_s4_q ? select_1087 : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_305_s4_q ? select_1091 : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_305_s4_q ? select_1095 : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_305_s4_q ? select_1099 : averager_quarter_2_1_q;
      averager_detail_0_q <= and_305_s4_q ? select_1117 : averager_detail_0_q;
      averager_detail_1_q <= and_305_s4_q ? select_1127 : averager_detail_1_q;
      census_changes_values_0_left_q <= and_305_s4_q ? select_1357 : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_305_s4_q ? select_1380 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= and_305_s4_q ? select_1384 : census_changes_values_1_left_q;
      census_changes_values_1_right_q <= and_305_s4_q ? select_1388 : census_changes_values_1_right_q;
      census_changes_values_2_left_q <= and_305_s4_q ? select_1392 : census_changes_values_2_left_q;
      census_changes_values_2_right_q <= and_305_s4_q ? select_1396 : census_changes_values_2_right_q;
      sharpness_last_mask_q <= and_305_s4_q ? select_1426 : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_305_s4_q ? select_1430 : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_305_s4_q ? select_1434 : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_2158;
      box_textured_columns_values_1_q <= select_2161;
      box_textured_columns_values_2_q <= select_2164;
      box_textured_columns_values_3_q <= select_2167;
      box_textured_columns_values_4_q <= select_2170;
      box_textured_sum_sums_values_0_q <= equal_349_s4_q ? box_textured_sum_sums_values_0_q : select_2172;
      box_explained_columns_values_0_q <= select_2176;
      box_explained_columns_values_1_q <= select_2179;
      box_explained_columns_values_2_q <= select_2182;
      box_explained_columns_values_3_q <= select_2185;
      box_explained_columns_values_4_q <= select_2188;
      box_explained_sum_sums_values_0_q <= equal_349_s4_q ? box_explained_sum_sums_values_0_q : select_2190;
      box_nearer_columns_values_0_q <= select_2194;
      box_nearer_columns_values_1_q <= select_2197;
      box_nearer_columns_values_2_q <= select_2200;
      box_nearer_columns_values_3_q <= select_2203;
      box_nearer_columns_values_4_q <= select_2206;
      box_nearer_sum_sums_values_0_q <= equal_349_s4_q ? box_nearer_sum_sums_values_0_q : select_2208;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_2249_s5_q;
  logic or_2310_s5_q;
  logic and_2311_s5_q;
  logic [13:0] select_2316_s5_q;
  logic [13:0] select_2321_s5_q;
  logic [13:0] select_2326_s5_q;
  logic [13:0] select_2331_s5_q;
  logic [13:0] select_2336_s5_q;
  logic [13:0] select_2341_s5_q;
  logic and_2348_s5_q;
  logic and_2355_s5_q;
  logic and_2367_s5_q;
  logic and_2449_s5_q;
  logic and_2462_s5_q;
  logic and_2472_s5_q;
  logic and_2483_s5_q;
  logic [19:0] select_2488_s5_q;
  logic [19:0] select_2493_s5_q;
  logic [19:0] select_2498_s5_q;
  logic [19:0] select_2503_s5_q;
  logic [11:0] select_2508_s5_q;
  logic [11:0] select_2513_s5_q;
  logic [11:0] select_2518_s5_q;
  logic [11:0] select_2523_s5_q;
  logic [23:0] select_2528_s5_q;
  logic [23:0] select_2533_s5_q;
  logic [23:0] select_2538_s5_q;
  logic [23:0] select_2543_s5_q;
  logic and_2546_s5_q;
  logic [5:0] select_2551_s5_q;
  logic [11:0] select_2556_s5_q;
  logic [11:0] select_2561_s5_q;
  logic [11:0] select_2567_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_2249_s5_q <= said_q;
      or_2310_s5_q <= not_2309 | select_2302;
      and_2311_s5_q <= cfg_prove_i & select_2308;
      select_2316_s5_q <= equal_349_s4_q ? 14'h0 : select_2315;
      select_2321_s5_q <= equal_349_s4_q ? 14'h0 : select_2320;
      select_2326_s5_q <= equal_349_s4_q ? 14'h0 : select_2325;
      select_2331_s5_q <= equal_349_s4_q ? 14'h0 : select_2330;
      select_2336_s5_q <= equal_349_s4_q ? 14'h0 : select_2335;
      select_2341_s5_q <= equal_349_s4_q ? 14'h0 : select_2340;
      and_2348_s5_q <= not_350_s4_q & (not_491_s4_q & and_2346);
      and_2355_s5_q <= not_350_s4_q & (not_491_s4_q & and_2353);
      and_2367_s5_q <= and_2367;
      and_2449_s5_q <= not_350_s4_q & (not_491_s4_q & and_2447);
      and_2462_s5_q <= not_350_s4_q & (not_491_s4_q & and_2460);
      and_2472_s5_q <= not_350_s4_q & (not_491_s4_q & and_2470);
      and_2483_s5_q <= and_2483_s4_q;
      select_2488_s5_q <= equal_349_s4_q ? 20'h0 : select_2487;
      select_2493_s5_q <= equal_349_s4_q ? 20'h0 : select_2492;
      select_2498_s5_q <= equal_349_s4_q ? 20'h0 : select_2497;
      select_2503_s5_q <= equal_349_s4_q ? 20'h0 : select_2502;
      select_2508_s5_q <= select_2508_s4_q;
      select_2513_s5_q <= select_2513_s4_q;
      select_2518_s5_q <= select_2518_s4_q;
      select_2523_s5_q <= select_2523_s4_q;
      select_2528_s5_q <= equal_349_s4_q ? 24'h0 : select_2527;
      select_2533_s5_q <= equal_349_s4_q ? 24'h0 : select_2532;
      select_2538_s5_q <= equal_349_s4_q ? 24'h0 : select_2537;
      select_2543_s5_q <= equal_349_s4_q ? 24'h0 : select_2542;
      and_2546_s5_q <= and_2546_s4_q;
      select_2551_s5_q <= equal_349_s4_q ? 6'h0 : (equal_351_s4_q ? 6'h0 : select_2549);
      select_2556_s5_q <= equal_349_s4_q ? 12'h0 : (equal_351_s4_q ? 12'h0 : select_2554);
      select_2561_s5_q <= equal_349_s4_q ? 12'h0 : (equal_351_s4_q ? 12'h0 : select_2559);
      select_2567_s5_q <= equal_349_s4_q ? 12'h0 : (equal_351_s4_q ? 12'h0 : select_2565);
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_2310_s5_q;
  assign marks_nearer_o = and_2311_s5_q;
  assign verdict_valid_o = and_2249_s5_q;
  assign verdict_supervised_o = {2'h0, select_2316_s5_q};
  assign verdict_textured_o = {2'h0, select_2321_s5_q};
  assign verdict_explained_o = {2'h0, select_2326_s5_q};
  assign verdict_nearer_o = {2'h0, select_2331_s5_q};
  assign verdict_unproven_o = {2'h0, select_2336_s5_q};
  assign verdict_regions_bad_o = {2'h0, select_2341_s5_q};
  assign verdict_unproven_yet_o = and_2348_s5_q;
  assign verdict_untextured_o = and_2355_s5_q;
  assign verdict_disagree_o = and_2367_s5_q;
  assign verdict_moved_o = and_2449_s5_q;
  assign verdict_unsharp_left_o = and_2462_s5_q;
  assign verdict_unsharp_right_o = and_2472_s5_q;
  assign verdict_hidden_o = and_2483_s5_q;
  assign verdict_across_0_o = select_2488_s5_q;
  assign verdict_across_1_o = select_2493_s5_q;
  assign verdict_across_2_o = select_2498_s5_q;
  assign verdict_across_3_o = select_2503_s5_q;
  assign verdict_measured_0_o = select_2508_s5_q;
  assign verdict_measured_1_o = select_2513_s5_q;
  assign verdict_measured_2_o = select_2518_s5_q;
  assign verdict_measured_3_o = select_2523_s5_q;
  assign verdict_detail_0_o = select_2528_s5_q;
  assign verdict_detail_1_o = select_2533_s5_q;
  assign verdict_contrast_0_o = select_2538_s5_q;
  assign verdict_contrast_1_o = select_2543_s5_q;
  assign region_valid_o = and_2546_s5_q;
  assign region_region_o = select_2551_s5_q;
  assign region_textured_o = select_2556_s5_q;
  assign region_explained_o = select_2561_s5_q;
  assign region_nearer_o = select_2567_s5_q;
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
  assign unused_bits = ^{right[1:0], left[1:0], sum_2370[2:0], sum_1789[0], sum_1785[0], sum_1777[1:0], sum_1776[1:0], sum_1772[0], detail_4[1:0], detail_3[1:0], sum_1402[4:0], sum_850[9:0], sum_435[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
