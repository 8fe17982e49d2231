// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 27 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2494 bits, pipeline 7453 bits, memories 86424 bits.
module horopter_agreement (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic en_i,
  input  logic valid_i,
  input  logic [7:0] pixel_0_i,
  input  logic [7:0] pixel_1_i,
  input  logic saturated_i,
  input  logic mask_i,
  input  logic marks_first_i,
  input  logic marks_last_i,
  input  logic [10:0] cfg_width_i,
  input  logic [10:0] cfg_height_i,
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
  output logic [7:0] pixel_1_o,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s9_en = en_i & valid_s9_q;
  assign s10_en = en_i & valid_s10_q;
  assign s11_en = en_i & valid_s11_q;
  assign s12_en = en_i & valid_s12_q;
  assign s13_en = en_i & valid_s13_q;
  assign s14_en = en_i & valid_s14_q;
  assign s15_en = en_i & valid_s15_q;
  assign s16_en = en_i & valid_s16_q;
  assign s17_en = en_i & valid_s17_q;
  assign s18_en = en_i & valid_s18_q;
  assign s19_en = en_i & valid_s19_q;
  assign s20_en = en_i & valid_s20_q;
  assign s21_en = en_i & valid_s21_q;
  assign s22_en = en_i & valid_s22_q;
  assign s23_en = en_i & valid_s23_q;
  assign s24_en = en_i & valid_s24_q;
  assign s25_en = en_i & valid_s25_q;
  assign s26_en = en_i & valid_s26_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [5:0] sum_1262;
  assign sum_1262 = {1'b0, cfg_width_i[10:6]} + 6'h1;
  logic [6:0] sum_1266;
  assign sum_1266 = {1'b0, cfg_width_i[10:5]} + 7'h11;
  logic [6:0] sum_1281;
  assign sum_1281 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [7:0] limit;
  assign limit = {2'h0, cfg_moved_limit_i} + 8'hff;
  logic [7:0] difference_1707;
  assign difference_1707 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_1868;
  assign less_1868 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_1869;
  assign sum_1869 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_1887;
  assign not_1887 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_x_q;
  logic [3:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [8:0] averager_place_q;
  logic [13:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_295;
  assign select_295 = marks_first_i ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);
  // hls/stages/census.hpp:87
  logic equal_296;
  assign equal_296 = select_295[1:0] == 2'h0;
  // hls/stages/census.hpp:35
  logic [6:0] select_298;
  assign select_298 = marks_first_i ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:92
  logic [8:0] select_301;
  assign select_301 = ({select_298, select_295} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:40
  logic or_303;
  assign or_303 = marks_first_i | raster_at_live_q;
  logic [3:0] select_315;
  assign select_315 = marks_first_i ? 4'h0 : raster_at_y_q;
  // hls/stages/census.hpp:45
  logic equal_327;
  assign equal_327 = select_295 == 4'hf;
  // hls/stages/census.hpp:48
  logic equal_328;
  assign equal_328 = select_315 == 4'hf;
  // hls/stages/census.hpp:40
  logic [6:0] row;
  assign row = marks_first_i ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:818
  logic or_926;
  assign or_926 = marks_first_i | raster_row_ended_q;
  // hls/stages/agreement.hpp:820
  logic [13:0] select_928;
  assign select_928 = marks_first_i ? 14'h1 : (or_926 ? {rows_passed_q[12:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:819
  logic [8:0] select_930;
  assign select_930 = or_926 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:827
  logic select_932;
  assign select_932 = cfg_compete_i ? (or_926 & select_928[13]) : (select_930[8] & select_928[9]);
  // hls/stages/census.hpp:44
  logic [10:0] select_1040;
  assign select_1040 = marks_first_i ? cfg_height_i : (raster_rows_left_q - {10'h0, marks_last_i});

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_x_q <= 4'h0;
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 9'h0;
      rows_passed_q <= 14'h0;
      columns_passed_q <= 9'h0;
    end else if (s0_en) begin
      raster_at_x_q <= select_295 + 4'h1;
      raster_at_y_q <= marks_last_i ? (select_315 + 4'h1) : select_315;
      raster_at_column_q <= select_298 + {6'h0, equal_327};
      raster_at_row_q <= marks_last_i ? (row + {6'h0, equal_328}) : row;
      raster_at_live_q <= marks_last_i ? (or_303 & (~raster_final_row_q)) : or_303;
      raster_rows_left_q <= select_1040;
      raster_row_ended_q <= marks_last_i;
      raster_final_row_q <= raster_rows_left_q == 11'h1;
      averager_place_q <= equal_296 ? select_301 : averager_place_q;
      rows_passed_q <= select_928;
      columns_passed_q <= {select_930[7:0], or_926};
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic equal_296_s1_q;
  logic [6:0] select_298_s1_q;
  logic not_308_s1_q;
  logic equal_316_s1_q;
  logic equal_327_s1_q;
  logic equal_328_s1_q;
  logic equal_333_s1_q;
  logic [6:0] row_s1_q;
  logic select_932_s1_q;
  logic [7:0] sum_1277_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      equal_296_s1_q <= equal_296;
      select_298_s1_q <= select_298;
      not_308_s1_q <= ~((~or_303) | (~(select_295[1:0] == 2'h3)));
      equal_316_s1_q <= select_315 == 4'h0;
      equal_327_s1_q <= equal_327;
      equal_328_s1_q <= equal_328;
      equal_333_s1_q <= select_295 == 4'h3;
      row_s1_q <= row;
      select_932_s1_q <= select_932;
      sum_1277_s1_q <= {1'b0, row} + 8'h1;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
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
  logic [6:0] last_q;
  logic [6:0] least_q;
  logic [7:0] first_beats_q;
  logic [7:0] whole_beats_q;
  logic ends_q;
  logic final_row_q;
  logic [7:0] next_lowest_q;
  logic [7:0] next_highest_q;
  logic [7:0] next_beats_q;
  logic [5:0] next_shift_q;
  logic next_last_shift_q;
  // hls/stages/agreement.hpp:171
  logic and_311;
  assign and_311 = not_308_s1_q & (~(averager_place_q[8:5] == 4'hf));
  // hls/stages/census.hpp:102
  logic and_329;
  assign and_329 = equal_328_s1_q & and_311;
  // hls/stages/census.hpp:103
  logic and_330;
  assign and_330 = equal_327_s1_q & and_329;
  // hls/stages/agreement.hpp:333
  logic equal_342;
  assign equal_342 = run_phase_q == 3'h3;
  logic equal_344;
  assign equal_344 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:390
  logic less_345;
  assign less_345 = run_highest_q < x_q;
  // hls/stages/agreement.hpp:394
  logic not_346;
  assign not_346 = ~less_345;
  // hls/stages/agreement.hpp:748
  logic drew;
  assign drew = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:298
  logic [6:0] select_459;
  assign select_459 = equal_342 ? ({run_shift_q[5], run_shift_q} + x_q[6:0]) : x_q[6:0];
  // hls/stages/agreement.hpp:409
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:696
  logic [6:0] sum_1023;
  assign sum_1023 = {1'b0, run_highest_q[7:2]} + 7'h1;
  // hls/stages/agreement.hpp:242
  logic equal_1194;
  assign equal_1194 = {last[7], select_298_s1_q} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:170
  logic [2:0] select_1195;
  assign select_1195 = ends_q ? following_phase_q : run_phase_q;
  logic [7:0] select_1198;
  assign select_1198 = ends_q ? following_lowest_q : run_lowest_q;
  logic [7:0] select_1201;
  assign select_1201 = ends_q ? following_highest_q : run_highest_q;
  logic [7:0] select_1204;
  assign select_1204 = ends_q ? following_beats_q : run_beats_q;
  logic [5:0] select_1207;
  assign select_1207 = ends_q ? following_shift_q : run_shift_q;
  logic select_1210;
  assign select_1210 = ends_q ? following_last_shift_q : run_last_shift_q;
  // hls/stages/agreement.hpp:243
  logic not_1211;
  assign not_1211 = ~equal_1194;
  // hls/stages/agreement.hpp:325
  logic not_1214;
  assign not_1214 = ~run_last_shift_q;
  // hls/stages/agreement.hpp:333
  logic equal_1215;
  assign equal_1215 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:150
  logic or_1216;
  assign or_1216 = equal_1215 | equal_344;
  logic [2:0] select_1217;
  assign select_1217 = equal_342 ? {run_last_shift_q, {2{not_1214}}} : {1'b0, or_1216, equal_344};
  logic [7:0] select_1220;
  assign select_1220 = run_last_shift_q ? 8'h0 : (run_shift_q[5] ? next_lowest_q : 8'h0);
  logic [6:0] select_1221;
  assign select_1221 = equal_344 ? least_q : 7'h0;
  logic [7:0] select_1225;
  assign select_1225 = run_last_shift_q ? {1'b0, last_q} : (run_shift_q[5] ? {1'b0, last_q} : next_highest_q);
  logic [6:0] select_1227;
  assign select_1227 = equal_344 ? last_q : (equal_1215 ? last_q : 7'h0);
  logic [7:0] select_1233;
  assign select_1233 = equal_342 ? (run_last_shift_q ? whole_beats_q : next_beats_q) : (equal_344 ? first_beats_q : (equal_1215 ? whole_beats_q : 8'h0));
  logic [5:0] select_1238;
  assign select_1238 = equal_342 ? (run_last_shift_q ? 6'h0 : next_shift_q) : (equal_344 ? (6'h0 - least_q[5:0]) : 6'h0);
  // hls/stages/agreement.hpp:130
  logic not_1240;
  assign not_1240 = ~drew;
  // hls/stages/agreement.hpp:150
  logic select_1244;
  assign select_1244 = equal_342 ? (next_last_shift_q & not_1214) : (equal_344 & (least_q == 7'h0));
  // hls/stages/agreement.hpp:170
  logic [7:0] select_1247;
  assign select_1247 = ends_q ? following_lowest_q : (x_q + 8'h1);
  logic [7:0] select_1251;
  assign select_1251 = ends_q ? following_beats_q : (beats_left_q + 8'hff);
  // hls/stages/agreement.hpp:249
  logic less_1258;
  assign less_1258 = 6'he < select_298_s1_q[6:1];
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1261;
  assign select_1261 = and_330 ? (equal_1194 ? (less_1258 ? 7'h1e : select_298_s1_q) : least_q) : least_q;
  // hls/stages/agreement.hpp:243
  logic [7:0] select_1264;
  assign select_1264 = equal_1194 ? (less_1258 ? {sum_1262, cfg_width_i[5:4]} : 8'h23) : first_beats_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1268;
  assign select_1268 = and_330 ? (equal_1194 ? {sum_1266, cfg_width_i[4]} : whole_beats_q) : whole_beats_q;
  // hls/stages/agreement.hpp:301
  logic not_1269;
  assign not_1269 = ~ends_q;
  // hls/stages/agreement.hpp:170
  logic and_1274;
  assign and_1274 = not_1269 & (beats_left_q == 8'h1);
  // hls/stages/agreement.hpp:261
  logic equal_1278;
  assign equal_1278 = {sum_1277_s1_q[7], cfg_height_i[10:4]} == {1'b0, sum_1277_s1_q[6:0]};
  // hls/stages/agreement.hpp:608
  logic [5:0] sum_1412;
  assign sum_1412 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:143
  logic not_1771;
  assign not_1771 = ~run_shift_q[5];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      last_q <= 7'h0;
      least_q <= 7'h0;
      first_beats_q <= 8'h0;
      whole_beats_q <= 8'h0;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      next_lowest_q <= 8'h0;
      next_highest_q <= 8'h0;
      next_beats_q <= 8'h0;
      next_shift_q <= 6'h0;
      next_last_shift_q <= 1'b0;
    end else if (s1_en) begin
      run_phase_q <= and_330 ? (equal_1194 ? 3'h1 : select_1195) : select_1195;
      run_lowest_q <= and_330 ? (equal_1194 ? 8'h0 : select_1198) : select_1198;
      run_highest_q <= and_330 ? (equal_1194 ? 8'h0 : select_1201) : select_1201;
      run_beats_q <= and_330 ? (equal_1194 ? 8'h20 : select_1204) : select_1204;
      run_shift_q <= and_330 ? (equal_1194 ? 6'h0 : select_1207) : select_1207;
      run_last_shift_q <= and_330 ? (select_1210 & not_1211) : select_1210;
      following_phase_q <= drew ? {final_row_q, 1'b0, final_row_q} : select_1217;
      following_lowest_q <= drew ? 8'h0 : (equal_342 ? select_1220 : {1'b0, select_1221});
      following_highest_q <= drew ? 8'h0 : (equal_342 ? select_1225 : {1'b0, select_1227});
      following_beats_q <= drew ? 8'h3f : select_1233;
      following_shift_q <= drew ? 6'h0 : select_1238;
      following_last_shift_q <= not_1240 & select_1244;
      x_q <= and_330 ? (equal_1194 ? 8'h0 : select_1247) : select_1247;
      beats_left_q <= and_330 ? (equal_1194 ? 8'h20 : select_1251) : select_1251;
      last_q <= and_330 ? (equal_1194 ? select_298_s1_q : last_q) : last_q;
      least_q <= select_1261;
      first_beats_q <= and_330 ? select_1264 : first_beats_q;
      whole_beats_q <= select_1268;
      ends_q <= and_330 ? (and_1274 & not_1211) : and_1274;
      final_row_q <= and_330 ? (equal_1194 ? equal_1278 : final_row_q) : final_row_q;
      next_lowest_q <= run_lowest_q + 8'hff;
      next_highest_q <= run_highest_q + 8'hff;
      next_beats_q <= {{7{not_1771}}, 1'b1} + run_beats_q;
      next_shift_q <= run_shift_q + 6'h1;
      next_last_shift_q <= {{3{run_shift_q[5]}}, run_shift_q} == ({2'h0, least_q} + 9'h1ff);
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic ends_s2_q;
  logic equal_296_s2_q;
  logic [6:0] select_298_s2_q;
  logic [8:0] select_302_s2_q;
  logic and_311_s2_q;
  logic equal_316_s2_q;
  logic and_329_s2_q;
  logic and_330_s2_q;
  logic equal_333_s2_q;
  logic equal_342_s2_q;
  logic equal_344_s2_q;
  logic less_345_s2_q;
  logic not_346_s2_q;
  logic [6:0] row_s2_q;
  logic drew_s2_q;
  logic and_432_s2_q;
  logic [6:0] select_459_s2_q;
  logic [6:0] x_s2_2_q;
  logic not_482_s2_q;
  logic equal_489_s2_q;
  logic equal_556_s2_q;
  logic equal_793_s2_q;
  logic equal_857_s2_q;
  logic equal_880_s2_q;
  logic equal_883_s2_q;
  logic select_932_s2_q;
  logic not_1025_s2_q;
  logic equal_1194_s2_q;
  logic not_1240_s2_q;
  logic not_1269_s2_q;
  logic less_1413_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= raster_row_ended_q;
      run_shift_s2_q <= run_shift_q;
      x_s2_q <= x_q;
      ends_s2_q <= ends_q;
      equal_296_s2_q <= equal_296_s1_q;
      select_298_s2_q <= select_298_s1_q;
      select_302_s2_q <= averager_place_q;
      and_311_s2_q <= and_311;
      equal_316_s2_q <= equal_316_s1_q;
      and_329_s2_q <= and_329;
      and_330_s2_q <= and_330;
      equal_333_s2_q <= equal_333_s1_q;
      equal_342_s2_q <= equal_342;
      equal_344_s2_q <= equal_344;
      less_345_s2_q <= less_345;
      not_346_s2_q <= not_346;
      row_s2_q <= row_s1_q;
      drew_s2_q <= drew;
      and_432_s2_q <= drew & not_346;
      select_459_s2_q <= select_459;
      x_s2_2_q <= x[6:0];
      not_482_s2_q <= ~(({1'b0, run_highest_q} + 9'h3) < {1'b0, x_q});
      equal_489_s2_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_556_s2_q <= run_lowest_q == x_q;
      equal_793_s2_q <= run_lowest_q == x;
      equal_857_s2_q <= run_highest_q == x;
      equal_880_s2_q <= x_q == {1'b0, last_q};
      equal_883_s2_q <= run_phase_q == 3'h5;
      select_932_s2_q <= select_932_s1_q;
      not_1025_s2_q <= ~({sum_1023, run_highest_q[1:0]} < {1'b0, x_q});
      equal_1194_s2_q <= equal_1194;
      not_1240_s2_q <= not_1240;
      not_1269_s2_q <= not_1269;
      less_1413_s2_q <= {1'b0, sum_1412, last_q[1]} < x_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:298
  logic and_347;
  assign and_347 = equal_344_s2_q & not_346_s2_q;
  logic select_434;
  assign select_434 = equal_342_s2_q ? not_346_s2_q : (equal_344_s2_q ? not_346_s2_q : and_432_s2_q);
  // hls/stages/agreement.hpp:170
  logic [5:0] select_1270;
  assign select_1270 = ends_s2_q ? 6'h0 : age_q[5:0];
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1272;
  assign select_1272 = and_330_s2_q ? (equal_1194_s2_q ? 7'h0 : {select_1270, not_1269_s2_q}) : {select_1270, not_1269_s2_q};

  // Memory left, 120 x 73, DISTANCE 32, hls/stages/agreement.hpp:886; read in stage 2, written in stage 5: 2 < 5 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [72:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 73'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s2_q[6:0];
  logic left_re;
  assign left_re = s2_en & select_434;
  logic [72:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 32, hls/stages/agreement.hpp:887; read in stage 2, written in stage 5: 2 < 5 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_459_s2_q;
  logic right_codes_re;
  assign right_codes_re = s2_en & (equal_342_s2_q ? not_346_s2_q : and_347);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s2_en) begin
      age_q <= select_1272;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic [5:0] run_shift_s3_q;
  logic [7:0] x_s3_q;
  logic [1:0] age_s3_q;
  logic equal_296_s3_q;
  logic [6:0] select_298_s3_q;
  logic [8:0] select_302_s3_q;
  logic and_311_s3_q;
  logic equal_316_s3_q;
  logic and_329_s3_q;
  logic and_330_s3_q;
  logic equal_333_s3_q;
  logic equal_342_s3_q;
  logic equal_344_s3_q;
  logic less_345_s3_q;
  logic not_346_s3_q;
  logic and_347_s3_q;
  logic [6:0] row_s3_q;
  logic drew_s3_q;
  logic and_432_s3_q;
  logic [6:0] x_s3_2_q;
  logic and_483_s3_q;
  logic equal_489_s3_q;
  logic equal_556_s3_q;
  logic equal_793_s3_q;
  logic equal_857_s3_q;
  logic equal_880_s3_q;
  logic equal_883_s3_q;
  logic select_932_s3_q;
  logic not_1025_s3_q;
  logic equal_1194_s3_q;
  logic not_1240_s3_q;
  logic less_1413_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      run_shift_s3_q <= run_shift_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= {age_q[6], age_q[4]};
      equal_296_s3_q <= equal_296_s2_q;
      select_298_s3_q <= select_298_s2_q;
      select_302_s3_q <= select_302_s2_q;
      and_311_s3_q <= and_311_s2_q;
      equal_316_s3_q <= equal_316_s2_q;
      and_329_s3_q <= and_329_s2_q;
      and_330_s3_q <= and_330_s2_q;
      equal_333_s3_q <= equal_333_s2_q;
      equal_342_s3_q <= equal_342_s2_q;
      equal_344_s3_q <= equal_344_s2_q;
      less_345_s3_q <= less_345_s2_q;
      not_346_s3_q <= not_346_s2_q;
      and_347_s3_q <= and_347;
      row_s3_q <= row_s2_q;
      drew_s3_q <= drew_s2_q;
      and_432_s3_q <= and_432_s2_q;
      x_s3_2_q <= x_s2_2_q;
      and_483_s3_q <= age_q[2] & not_482_s2_q;
      equal_489_s3_q <= equal_489_s2_q;
      equal_556_s3_q <= equal_556_s2_q;
      equal_793_s3_q <= equal_793_s2_q;
      equal_857_s3_q <= equal_857_s2_q;
      equal_880_s3_q <= equal_880_s2_q;
      equal_883_s3_q <= equal_883_s2_q;
      select_932_s3_q <= select_932_s2_q;
      not_1025_s3_q <= not_1025_s2_q;
      equal_1194_s3_q <= equal_1194_s2_q;
      not_1240_s3_q <= not_1240_s2_q;
      less_1413_s3_q <= less_1413_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:320
  logic not_343;
  assign not_343 = ~equal_342_s3_q;
  // hls/stages/agreement.hpp:298
  logic and_348;
  assign and_348 = not_343 & and_347_s3_q;

  // Memory fresh, 120 x 28, DISTANCE 32, hls/stages/agreement.hpp:885; read in stage 3, written in stage 25: 3 < 25 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 28'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s3_q[6:0];
  logic fresh_re;
  assign fresh_re = s3_en & and_348;
  logic [27:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic [5:0] run_shift_s4_q;
  logic [7:0] x_s4_q;
  logic [1:0] age_s4_q;
  logic equal_296_s4_q;
  logic [6:0] select_298_s4_q;
  logic [8:0] select_302_s4_q;
  logic and_311_s4_q;
  logic equal_316_s4_q;
  logic and_329_s4_q;
  logic and_330_s4_q;
  logic equal_333_s4_q;
  logic equal_342_s4_q;
  logic not_343_s4_q;
  logic equal_344_s4_q;
  logic less_345_s4_q;
  logic not_346_s4_q;
  logic and_348_s4_q;
  logic [6:0] row_s4_q;
  logic drew_s4_q;
  logic and_432_s4_q;
  logic [72:0] left_rdata_s4_q;
  logic [90:0] right_codes_rdata_s4_q;
  logic [6:0] x_s4_2_q;
  logic and_483_s4_q;
  logic equal_489_s4_q;
  logic equal_556_s4_q;
  logic equal_793_s4_q;
  logic equal_857_s4_q;
  logic equal_880_s4_q;
  logic equal_883_s4_q;
  logic select_932_s4_q;
  logic not_1025_s4_q;
  logic equal_1194_s4_q;
  logic not_1240_s4_q;
  logic less_1413_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      run_shift_s4_q <= run_shift_s3_q;
      x_s4_q <= x_s3_q;
      age_s4_q <= age_s3_q;
      equal_296_s4_q <= equal_296_s3_q;
      select_298_s4_q <= select_298_s3_q;
      select_302_s4_q <= select_302_s3_q;
      and_311_s4_q <= and_311_s3_q;
      equal_316_s4_q <= equal_316_s3_q;
      and_329_s4_q <= and_329_s3_q;
      and_330_s4_q <= and_330_s3_q;
      equal_333_s4_q <= equal_333_s3_q;
      equal_342_s4_q <= equal_342_s3_q;
      not_343_s4_q <= not_343;
      equal_344_s4_q <= equal_344_s3_q;
      less_345_s4_q <= less_345_s3_q;
      not_346_s4_q <= not_346_s3_q;
      and_348_s4_q <= and_348;
      row_s4_q <= row_s3_q;
      drew_s4_q <= drew_s3_q;
      and_432_s4_q <= and_432_s3_q;
      left_rdata_s4_q <= left_rdata_q;
      right_codes_rdata_s4_q <= right_codes_rdata_q;
      x_s4_2_q <= x_s3_2_q;
      and_483_s4_q <= and_483_s3_q;
      equal_489_s4_q <= equal_489_s3_q;
      equal_556_s4_q <= equal_556_s3_q;
      equal_793_s4_q <= equal_793_s3_q;
      equal_857_s4_q <= equal_857_s3_q;
      equal_880_s4_q <= equal_880_s3_q;
      equal_883_s4_q <= equal_883_s3_q;
      select_932_s4_q <= select_932_s3_q;
      not_1025_s4_q <= not_1025_s3_q;
      equal_1194_s4_q <= equal_1194_s3_q;
      not_1240_s4_q <= not_1240_s3_q;
      less_1413_s4_q <= less_1413_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  // hls/stages/agreement.hpp:365
  logic equal_436;
  assign equal_436 = row_q == 7'h0;
  logic not_438;
  assign not_438 = ~equal_436;
  logic equal_442;
  assign equal_442 = row_q[6:1] == 6'h0;
  logic not_444;
  assign not_444 = ~equal_442;
  logic less_448;
  assign less_448 = row_q < 7'h3;
  logic not_450;
  assign not_450 = ~less_448;
  logic equal_454;
  assign equal_454 = row_q[6:2] == 5'h0;
  logic not_456;
  assign not_456 = ~equal_454;
  // hls/stages/agreement.hpp:366
  logic less_470;
  assign less_470 = row_q < 7'h5;
  logic less_474;
  assign less_474 = row_q[6:1] < 6'h3;
  // hls/stages/agreement.hpp:159
  logic and_495;
  assign and_495 = left_rdata_s4_q[42] & not_346_s4_q;
  logic [11:0] a;
  assign a = less_345_s4_q ? 12'h0 : left_rdata_s4_q[41:30];
  logic [11:0] b;
  assign b = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[37:26];
  logic [11:0] a_2;
  assign a_2 = less_345_s4_q ? 12'h0 : left_rdata_s4_q[56:45];
  logic [11:0] b_2;
  assign b_2 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[50:39];
  logic and_534;
  assign and_534 = left_rdata_s4_q[72] & not_346_s4_q;
  logic [11:0] a_3;
  assign a_3 = less_345_s4_q ? 12'h0 : left_rdata_s4_q[71:60];
  logic [11:0] b_3;
  assign b_3 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[63:52];
  logic [11:0] b_4;
  assign b_4 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[76:65];
  logic [11:0] b_5;
  assign b_5 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[24:13];
  logic [11:0] b_6;
  assign b_6 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[89:78];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_706;
  assign not_706 = ~(a_3 ^ b_6);
  // hls/stages/agreement.hpp:159
  logic [11:0] b_7;
  assign b_7 = less_345_s4_q ? 12'h0 : right_codes_rdata_s4_q[11:0];
  // hls/stages/agreement.hpp:375
  logic [11:0] not_735;
  assign not_735 = ~(a ^ b_7);
  // hls/stages/agreement.hpp:573
  logic not_892;
  assign not_892 = ~(row_q[6:3] == 4'h0);
  // hls/stages/agreement.hpp:298
  logic and_1027;
  assign and_1027 = drew_s4_q & (((7'h6 < row_q) & (~(x_s4_q[7:2] == 6'h0))) & not_1025_s4_q);
  // hls/stages/agreement.hpp:243
  logic select_1284;
  assign select_1284 = equal_1194_s4_q ? (~({row_s4_q, 1'b0} < {sum_1281, cfg_height_i[4]})) : lower_half_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
    end else if (s4_en) begin
      row_q <= and_330_s4_q ? (equal_1194_s4_q ? row_s4_q : row_q) : row_q;
      lower_half_q <= and_330_s4_q ? select_1284 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic [5:0] run_shift_s5_q;
  logic [7:0] x_s5_q;
  logic [1:0] age_s5_q;
  logic lower_half_s5_q;
  logic equal_296_s5_q;
  logic [6:0] select_298_s5_q;
  logic [8:0] select_302_s5_q;
  logic and_311_s5_q;
  logic equal_316_s5_q;
  logic and_329_s5_q;
  logic and_330_s5_q;
  logic equal_333_s5_q;
  logic equal_342_s5_q;
  logic not_343_s5_q;
  logic equal_344_s5_q;
  logic less_345_s5_q;
  logic not_346_s5_q;
  logic and_348_s5_q;
  logic [27:0] fresh_rdata_s5_q;
  logic equal_376_s5_q;
  logic drew_s5_q;
  logic and_432_s5_q;
  logic [11:0] select_437_s5_q;
  logic and_439_s5_q;
  logic and_440_s5_q;
  logic and_441_s5_q;
  logic [11:0] select_443_s5_q;
  logic and_445_s5_q;
  logic and_446_s5_q;
  logic and_447_s5_q;
  logic [11:0] select_449_s5_q;
  logic and_451_s5_q;
  logic and_452_s5_q;
  logic and_453_s5_q;
  logic [11:0] select_455_s5_q;
  logic and_457_s5_q;
  logic [11:0] select_462_s5_q;
  logic and_463_s5_q;
  logic [11:0] select_464_s5_q;
  logic and_465_s5_q;
  logic [11:0] select_466_s5_q;
  logic and_467_s5_q;
  logic [11:0] select_468_s5_q;
  logic and_469_s5_q;
  logic [11:0] select_471_s5_q;
  logic and_473_s5_q;
  logic [11:0] select_475_s5_q;
  logic and_477_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_483_s5_q;
  logic equal_489_s5_q;
  logic and_495_s5_q;
  logic and_496_s5_q;
  logic [11:0] a_s5_q;
  logic [11:0] b_s5_q;
  logic and_514_s5_q;
  logic and_515_s5_q;
  logic [11:0] a_2_s5_q;
  logic [11:0] b_2_s5_q;
  logic and_534_s5_q;
  logic and_535_s5_q;
  logic [11:0] a_3_s5_q;
  logic [11:0] b_3_s5_q;
  logic equal_556_s5_q;
  logic and_590_s5_q;
  logic [11:0] b_4_s5_q;
  logic and_614_s5_q;
  logic [11:0] b_5_s5_q;
  logic and_703_s5_q;
  logic [9:0] not_706_s5_q;
  logic [1:0] sum_707_s5_q;
  logic and_732_s5_q;
  logic [9:0] not_735_s5_q;
  logic [1:0] sum_736_s5_q;
  logic equal_793_s5_q;
  logic equal_857_s5_q;
  logic equal_880_s5_q;
  logic equal_883_s5_q;
  logic and_894_s5_q;
  logic select_932_s5_q;
  logic and_1027_s5_q;
  logic equal_1143_s5_q;
  logic equal_1194_s5_q;
  logic not_1240_s5_q;
  logic and_1328_s5_q;
  logic less_1410_s5_q;
  logic less_1413_s5_q;
  logic equal_1678_s5_q;
  logic less_1687_s5_q;
  logic equal_1846_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      run_shift_s5_q <= run_shift_s4_q;
      x_s5_q <= x_s4_q;
      age_s5_q <= age_s4_q;
      lower_half_s5_q <= lower_half_q;
      equal_296_s5_q <= equal_296_s4_q;
      select_298_s5_q <= select_298_s4_q;
      select_302_s5_q <= select_302_s4_q;
      and_311_s5_q <= and_311_s4_q;
      equal_316_s5_q <= equal_316_s4_q;
      and_329_s5_q <= and_329_s4_q;
      and_330_s5_q <= and_330_s4_q;
      equal_333_s5_q <= equal_333_s4_q;
      equal_342_s5_q <= equal_342_s4_q;
      not_343_s5_q <= not_343_s4_q;
      equal_344_s5_q <= equal_344_s4_q;
      less_345_s5_q <= less_345_s4_q;
      not_346_s5_q <= not_346_s4_q;
      and_348_s5_q <= and_348_s4_q;
      fresh_rdata_s5_q <= fresh_rdata_q;
      equal_376_s5_q <= row_s4_q == 7'h0;
      drew_s5_q <= drew_s4_q;
      and_432_s5_q <= and_432_s4_q;
      select_437_s5_q <= equal_436 ? 12'h0 : left_rdata_s4_q[11:0];
      and_439_s5_q <= left_rdata_s4_q[12] & not_438;
      and_440_s5_q <= left_rdata_s4_q[13] & not_438;
      and_441_s5_q <= left_rdata_s4_q[14] & not_438;
      select_443_s5_q <= equal_442 ? 12'h0 : left_rdata_s4_q[26:15];
      and_445_s5_q <= left_rdata_s4_q[27] & not_444;
      and_446_s5_q <= left_rdata_s4_q[28] & not_444;
      and_447_s5_q <= left_rdata_s4_q[29] & not_444;
      select_449_s5_q <= less_448 ? 12'h0 : left_rdata_s4_q[41:30];
      and_451_s5_q <= left_rdata_s4_q[42] & not_450;
      and_452_s5_q <= left_rdata_s4_q[43] & not_450;
      and_453_s5_q <= left_rdata_s4_q[44] & not_450;
      select_455_s5_q <= equal_454 ? 12'h0 : left_rdata_s4_q[56:45];
      and_457_s5_q <= left_rdata_s4_q[57] & not_456;
      select_462_s5_q <= equal_436 ? 12'h0 : right_codes_rdata_s4_q[11:0];
      and_463_s5_q <= right_codes_rdata_s4_q[12] & not_438;
      select_464_s5_q <= equal_442 ? 12'h0 : right_codes_rdata_s4_q[24:13];
      and_465_s5_q <= right_codes_rdata_s4_q[25] & not_444;
      select_466_s5_q <= less_448 ? 12'h0 : right_codes_rdata_s4_q[37:26];
      and_467_s5_q <= right_codes_rdata_s4_q[38] & not_450;
      select_468_s5_q <= equal_454 ? 12'h0 : right_codes_rdata_s4_q[50:39];
      and_469_s5_q <= right_codes_rdata_s4_q[51] & not_456;
      select_471_s5_q <= less_470 ? 12'h0 : right_codes_rdata_s4_q[63:52];
      and_473_s5_q <= right_codes_rdata_s4_q[64] & (~less_470);
      select_475_s5_q <= less_474 ? 12'h0 : right_codes_rdata_s4_q[76:65];
      and_477_s5_q <= right_codes_rdata_s4_q[77] & (~less_474);
      x_s5_2_q <= x_s4_2_q;
      and_483_s5_q <= and_483_s4_q;
      equal_489_s5_q <= equal_489_s4_q;
      and_495_s5_q <= and_495;
      and_496_s5_q <= right_codes_rdata_s4_q[38] & not_346_s4_q;
      a_s5_q <= a;
      b_s5_q <= b;
      and_514_s5_q <= left_rdata_s4_q[57] & not_346_s4_q;
      and_515_s5_q <= right_codes_rdata_s4_q[51] & not_346_s4_q;
      a_2_s5_q <= a_2;
      b_2_s5_q <= b_2;
      and_534_s5_q <= and_534;
      and_535_s5_q <= right_codes_rdata_s4_q[64] & not_346_s4_q;
      a_3_s5_q <= a_3;
      b_3_s5_q <= b_3;
      equal_556_s5_q <= equal_556_s4_q;
      and_590_s5_q <= right_codes_rdata_s4_q[77] & not_346_s4_q;
      b_4_s5_q <= b_4;
      and_614_s5_q <= right_codes_rdata_s4_q[25] & not_346_s4_q;
      b_5_s5_q <= b_5;
      and_703_s5_q <= and_534 & (right_codes_rdata_s4_q[90] & not_346_s4_q);
      not_706_s5_q <= not_706[11:2];
      sum_707_s5_q <= {1'b0, not_706[0]} + {1'b0, not_706[1]};
      and_732_s5_q <= and_495 & (right_codes_rdata_s4_q[12] & not_346_s4_q);
      not_735_s5_q <= not_735[11:2];
      sum_736_s5_q <= {1'b0, not_735[0]} + {1'b0, not_735[1]};
      equal_793_s5_q <= equal_793_s4_q;
      equal_857_s5_q <= equal_857_s4_q;
      equal_880_s5_q <= equal_880_s4_q;
      equal_883_s5_q <= equal_883_s4_q;
      and_894_s5_q <= left_rdata_s4_q[58] & (left_rdata_s4_q[59] & not_892);
      select_932_s5_q <= select_932_s4_q;
      and_1027_s5_q <= and_1027;
      equal_1143_s5_q <= (select_298_s4_q | row_s4_q) == 7'h0;
      equal_1194_s5_q <= equal_1194_s4_q;
      not_1240_s5_q <= not_1240_s4_q;
      and_1328_s5_q <= left_rdata_s4_q[58] & not_892;
      less_1410_s5_q <= 6'h4 < row_q[6:1];
      less_1413_s5_q <= less_1413_s4_q;
      equal_1678_s5_q <= row_s4_q[6:2] == 5'h0;
      less_1687_s5_q <= 6'h2 < row_s4_q[6:1];
      equal_1846_s5_q <= row_s4_q[6:3] == 4'h0;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:375
  logic [11:0] not_501;
  assign not_501 = ~(a_s5_q ^ b_s5_q);
  logic [1:0] sum_503;
  assign sum_503 = {1'b0, not_501[2]} + ({1'b0, not_501[0]} + {1'b0, not_501[1]});
  logic [11:0] not_520;
  assign not_520 = ~(a_2_s5_q ^ b_2_s5_q);
  logic [1:0] sum_522;
  assign sum_522 = {1'b0, not_520[2]} + ({1'b0, not_520[0]} + {1'b0, not_520[1]});
  logic [11:0] not_540;
  assign not_540 = ~(a_3_s5_q ^ b_3_s5_q);
  logic [1:0] sum_542;
  assign sum_542 = {1'b0, not_540[2]} + ({1'b0, not_540[0]} + {1'b0, not_540[1]});
  logic [11:0] not_561;
  assign not_561 = ~(a_s5_q ^ b_2_s5_q);
  logic [1:0] sum_563;
  assign sum_563 = {1'b0, not_561[2]} + ({1'b0, not_561[0]} + {1'b0, not_561[1]});
  logic [11:0] not_576;
  assign not_576 = ~(a_2_s5_q ^ b_3_s5_q);
  logic [1:0] sum_578;
  assign sum_578 = {1'b0, not_576[2]} + ({1'b0, not_576[0]} + {1'b0, not_576[1]});
  logic [11:0] not_594;
  assign not_594 = ~(a_3_s5_q ^ b_4_s5_q);
  logic [1:0] sum_596;
  assign sum_596 = {1'b0, not_594[2]} + ({1'b0, not_594[0]} + {1'b0, not_594[1]});
  logic [11:0] not_618;
  assign not_618 = ~(a_s5_q ^ b_5_s5_q);
  logic [1:0] sum_620;
  assign sum_620 = {1'b0, not_618[2]} + ({1'b0, not_618[0]} + {1'b0, not_618[1]});
  logic [11:0] not_633;
  assign not_633 = ~(a_2_s5_q ^ b_s5_q);
  logic [1:0] sum_635;
  assign sum_635 = {1'b0, not_633[2]} + ({1'b0, not_633[0]} + {1'b0, not_633[1]});
  logic [11:0] not_649;
  assign not_649 = ~(a_3_s5_q ^ b_2_s5_q);
  logic [1:0] sum_651;
  assign sum_651 = {1'b0, not_649[2]} + ({1'b0, not_649[0]} + {1'b0, not_649[1]});
  logic [11:0] not_673;
  assign not_673 = ~(a_s5_q ^ b_3_s5_q);
  logic [1:0] sum_675;
  assign sum_675 = {1'b0, not_673[2]} + ({1'b0, not_673[0]} + {1'b0, not_673[1]});
  logic [11:0] not_688;
  assign not_688 = ~(a_2_s5_q ^ b_4_s5_q);
  logic [1:0] sum_690;
  assign sum_690 = {1'b0, not_688[2]} + ({1'b0, not_688[0]} + {1'b0, not_688[1]});
  logic [1:0] sum_708;
  assign sum_708 = {1'b0, not_706_s5_q[0]} + sum_707_s5_q;
  logic [1:0] sum_737;
  assign sum_737 = {1'b0, not_735_s5_q[0]} + sum_736_s5_q;
  logic [11:0] not_750;
  assign not_750 = ~(a_2_s5_q ^ b_5_s5_q);
  logic [1:0] sum_752;
  assign sum_752 = {1'b0, not_750[2]} + ({1'b0, not_750[0]} + {1'b0, not_750[1]});
  logic [11:0] not_766;
  assign not_766 = ~(a_3_s5_q ^ b_s5_q);
  logic [1:0] sum_768;
  assign sum_768 = {1'b0, not_766[2]} + ({1'b0, not_766[0]} + {1'b0, not_766[1]});

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s5_q[6:0];
  logic left_we;
  assign left_we = s5_en & and_348_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_457_s5_q, select_455_s5_q, and_453_s5_q, and_452_s5_q, and_451_s5_q, select_449_s5_q, and_447_s5_q, and_446_s5_q, and_445_s5_q, select_443_s5_q, and_441_s5_q, and_440_s5_q, and_439_s5_q, select_437_s5_q, fresh_rdata_s5_q[27:26], fresh_rdata_s5_q[24], fresh_rdata_s5_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s3_sim;
  logic left_re_s3_sim;
  logic [6:0] left_raddr_s4_sim;
  logic left_re_s4_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s3_sim <= 1'b0;
      left_re_s4_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s3_sim <= left_re;
      left_raddr_s3_sim <= left_raddr;
      left_re_s4_sim <= left_re_s3_sim;
      left_raddr_s4_sim <= left_raddr_s3_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s3_sim && left_raddr_s3_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s4_sim && left_raddr_s4_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s5_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s5_en & and_348_s5_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_477_s5_q, select_475_s5_q, and_473_s5_q, select_471_s5_q, and_469_s5_q, select_468_s5_q, and_467_s5_q, select_466_s5_q, and_465_s5_q, select_464_s5_q, and_463_s5_q, select_462_s5_q, fresh_rdata_s5_q[25], fresh_rdata_s5_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s3_sim;
  logic right_codes_re_s3_sim;
  logic [6:0] right_codes_raddr_s4_sim;
  logic right_codes_re_s4_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s3_sim <= 1'b0;
      right_codes_re_s4_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s3_sim <= right_codes_re;
      right_codes_raddr_s3_sim <= right_codes_raddr;
      right_codes_re_s4_sim <= right_codes_re_s3_sim;
      right_codes_raddr_s4_sim <= right_codes_raddr_s3_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s3_sim && right_codes_raddr_s3_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s4_sim && right_codes_raddr_s4_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [1:0] age_s6_q;
  logic lower_half_s6_q;
  logic equal_296_s6_q;
  logic [6:0] select_298_s6_q;
  logic [8:0] select_302_s6_q;
  logic and_311_s6_q;
  logic equal_316_s6_q;
  logic and_329_s6_q;
  logic and_330_s6_q;
  logic equal_333_s6_q;
  logic equal_342_s6_q;
  logic not_343_s6_q;
  logic equal_344_s6_q;
  logic less_345_s6_q;
  logic not_346_s6_q;
  logic equal_376_s6_q;
  logic drew_s6_q;
  logic and_432_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_483_s6_q;
  logic equal_489_s6_q;
  logic and_495_s6_q;
  logic and_496_s6_q;
  logic [7:0] not_501_s6_q;
  logic [2:0] sum_504_s6_q;
  logic and_514_s6_q;
  logic and_515_s6_q;
  logic [7:0] not_520_s6_q;
  logic [2:0] sum_523_s6_q;
  logic and_534_s6_q;
  logic and_535_s6_q;
  logic [7:0] not_540_s6_q;
  logic [2:0] sum_543_s6_q;
  logic equal_556_s6_q;
  logic [7:0] not_561_s6_q;
  logic [2:0] sum_564_s6_q;
  logic [7:0] not_576_s6_q;
  logic [2:0] sum_579_s6_q;
  logic and_590_s6_q;
  logic [7:0] not_594_s6_q;
  logic [2:0] sum_597_s6_q;
  logic and_614_s6_q;
  logic [7:0] not_618_s6_q;
  logic [2:0] sum_621_s6_q;
  logic [7:0] not_633_s6_q;
  logic [2:0] sum_636_s6_q;
  logic [7:0] not_649_s6_q;
  logic [2:0] sum_652_s6_q;
  logic [7:0] not_673_s6_q;
  logic [2:0] sum_676_s6_q;
  logic [7:0] not_688_s6_q;
  logic [2:0] sum_691_s6_q;
  logic and_703_s6_q;
  logic [7:0] not_706_s6_q;
  logic [2:0] sum_709_s6_q;
  logic and_732_s6_q;
  logic [7:0] not_735_s6_q;
  logic [2:0] sum_738_s6_q;
  logic [7:0] not_750_s6_q;
  logic [2:0] sum_753_s6_q;
  logic [7:0] not_766_s6_q;
  logic [2:0] sum_769_s6_q;
  logic equal_793_s6_q;
  logic equal_857_s6_q;
  logic equal_880_s6_q;
  logic equal_883_s6_q;
  logic and_894_s6_q;
  logic select_932_s6_q;
  logic and_1027_s6_q;
  logic equal_1143_s6_q;
  logic equal_1194_s6_q;
  logic not_1240_s6_q;
  logic and_1328_s6_q;
  logic less_1410_s6_q;
  logic less_1413_s6_q;
  logic equal_1678_s6_q;
  logic less_1687_s6_q;
  logic equal_1846_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      age_s6_q <= age_s5_q;
      lower_half_s6_q <= lower_half_s5_q;
      equal_296_s6_q <= equal_296_s5_q;
      select_298_s6_q <= select_298_s5_q;
      select_302_s6_q <= select_302_s5_q;
      and_311_s6_q <= and_311_s5_q;
      equal_316_s6_q <= equal_316_s5_q;
      and_329_s6_q <= and_329_s5_q;
      and_330_s6_q <= and_330_s5_q;
      equal_333_s6_q <= equal_333_s5_q;
      equal_342_s6_q <= equal_342_s5_q;
      not_343_s6_q <= not_343_s5_q;
      equal_344_s6_q <= equal_344_s5_q;
      less_345_s6_q <= less_345_s5_q;
      not_346_s6_q <= not_346_s5_q;
      equal_376_s6_q <= equal_376_s5_q;
      drew_s6_q <= drew_s5_q;
      and_432_s6_q <= and_432_s5_q;
      x_s6_2_q <= x_s5_2_q;
      and_483_s6_q <= and_483_s5_q;
      equal_489_s6_q <= equal_489_s5_q;
      and_495_s6_q <= and_495_s5_q;
      and_496_s6_q <= and_496_s5_q;
      not_501_s6_q <= not_501[11:4];
      sum_504_s6_q <= {2'h0, not_501[3]} + {1'b0, sum_503};
      and_514_s6_q <= and_514_s5_q;
      and_515_s6_q <= and_515_s5_q;
      not_520_s6_q <= not_520[11:4];
      sum_523_s6_q <= {2'h0, not_520[3]} + {1'b0, sum_522};
      and_534_s6_q <= and_534_s5_q;
      and_535_s6_q <= and_535_s5_q;
      not_540_s6_q <= not_540[11:4];
      sum_543_s6_q <= {2'h0, not_540[3]} + {1'b0, sum_542};
      equal_556_s6_q <= equal_556_s5_q;
      not_561_s6_q <= not_561[11:4];
      sum_564_s6_q <= {2'h0, not_561[3]} + {1'b0, sum_563};
      not_576_s6_q <= not_576[11:4];
      sum_579_s6_q <= {2'h0, not_576[3]} + {1'b0, sum_578};
      and_590_s6_q <= and_590_s5_q;
      not_594_s6_q <= not_594[11:4];
      sum_597_s6_q <= {2'h0, not_594[3]} + {1'b0, sum_596};
      and_614_s6_q <= and_614_s5_q;
      not_618_s6_q <= not_618[11:4];
      sum_621_s6_q <= {2'h0, not_618[3]} + {1'b0, sum_620};
      not_633_s6_q <= not_633[11:4];
      sum_636_s6_q <= {2'h0, not_633[3]} + {1'b0, sum_635};
      not_649_s6_q <= not_649[11:4];
      sum_652_s6_q <= {2'h0, not_649[3]} + {1'b0, sum_651};
      not_673_s6_q <= not_673[11:4];
      sum_676_s6_q <= {2'h0, not_673[3]} + {1'b0, sum_675};
      not_688_s6_q <= not_688[11:4];
      sum_691_s6_q <= {2'h0, not_688[3]} + {1'b0, sum_690};
      and_703_s6_q <= and_703_s5_q;
      not_706_s6_q <= not_706_s5_q[9:2];
      sum_709_s6_q <= {2'h0, not_706_s5_q[1]} + {1'b0, sum_708};
      and_732_s6_q <= and_732_s5_q;
      not_735_s6_q <= not_735_s5_q[9:2];
      sum_738_s6_q <= {2'h0, not_735_s5_q[1]} + {1'b0, sum_737};
      not_750_s6_q <= not_750[11:4];
      sum_753_s6_q <= {2'h0, not_750[3]} + {1'b0, sum_752};
      not_766_s6_q <= not_766[11:4];
      sum_769_s6_q <= {2'h0, not_766[3]} + {1'b0, sum_768};
      equal_793_s6_q <= equal_793_s5_q;
      equal_857_s6_q <= equal_857_s5_q;
      equal_880_s6_q <= equal_880_s5_q;
      equal_883_s6_q <= equal_883_s5_q;
      and_894_s6_q <= and_894_s5_q;
      select_932_s6_q <= select_932_s5_q;
      and_1027_s6_q <= and_1027_s5_q;
      equal_1143_s6_q <= equal_1143_s5_q;
      equal_1194_s6_q <= equal_1194_s5_q;
      not_1240_s6_q <= not_1240_s5_q;
      and_1328_s6_q <= and_1328_s5_q;
      less_1410_s6_q <= less_1410_s5_q;
      less_1413_s6_q <= less_1413_s5_q;
      equal_1678_s6_q <= equal_1678_s5_q;
      less_1687_s6_q <= less_1687_s5_q;
      equal_1846_s6_q <= equal_1846_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:375
  logic [2:0] sum_506;
  assign sum_506 = {2'h0, not_501_s6_q[1]} + ({2'h0, not_501_s6_q[0]} + sum_504_s6_q);
  logic [2:0] sum_525;
  assign sum_525 = {2'h0, not_520_s6_q[1]} + ({2'h0, not_520_s6_q[0]} + sum_523_s6_q);
  logic [2:0] sum_545;
  assign sum_545 = {2'h0, not_540_s6_q[1]} + ({2'h0, not_540_s6_q[0]} + sum_543_s6_q);
  logic [2:0] sum_566;
  assign sum_566 = {2'h0, not_561_s6_q[1]} + ({2'h0, not_561_s6_q[0]} + sum_564_s6_q);
  logic [2:0] sum_581;
  assign sum_581 = {2'h0, not_576_s6_q[1]} + ({2'h0, not_576_s6_q[0]} + sum_579_s6_q);
  logic [2:0] sum_599;
  assign sum_599 = {2'h0, not_594_s6_q[1]} + ({2'h0, not_594_s6_q[0]} + sum_597_s6_q);
  logic [2:0] sum_623;
  assign sum_623 = {2'h0, not_618_s6_q[1]} + ({2'h0, not_618_s6_q[0]} + sum_621_s6_q);
  logic [2:0] sum_638;
  assign sum_638 = {2'h0, not_633_s6_q[1]} + ({2'h0, not_633_s6_q[0]} + sum_636_s6_q);
  logic [2:0] sum_654;
  assign sum_654 = {2'h0, not_649_s6_q[1]} + ({2'h0, not_649_s6_q[0]} + sum_652_s6_q);
  logic [2:0] sum_678;
  assign sum_678 = {2'h0, not_673_s6_q[1]} + ({2'h0, not_673_s6_q[0]} + sum_676_s6_q);
  logic [2:0] sum_693;
  assign sum_693 = {2'h0, not_688_s6_q[1]} + ({2'h0, not_688_s6_q[0]} + sum_691_s6_q);
  logic [2:0] sum_711;
  assign sum_711 = {2'h0, not_706_s6_q[1]} + ({2'h0, not_706_s6_q[0]} + sum_709_s6_q);
  logic [2:0] sum_740;
  assign sum_740 = {2'h0, not_735_s6_q[1]} + ({2'h0, not_735_s6_q[0]} + sum_738_s6_q);
  logic [2:0] sum_755;
  assign sum_755 = {2'h0, not_750_s6_q[1]} + ({2'h0, not_750_s6_q[0]} + sum_753_s6_q);
  logic [2:0] sum_771;
  assign sum_771 = {2'h0, not_766_s6_q[1]} + ({2'h0, not_766_s6_q[0]} + sum_769_s6_q);

  logic [7:0] pixel_0_s7_q;
  logic [7:0] pixel_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic [5:0] run_shift_s7_q;
  logic [7:0] x_s7_q;
  logic [1:0] age_s7_q;
  logic lower_half_s7_q;
  logic equal_296_s7_q;
  logic [6:0] select_298_s7_q;
  logic [8:0] select_302_s7_q;
  logic and_311_s7_q;
  logic equal_316_s7_q;
  logic and_329_s7_q;
  logic and_330_s7_q;
  logic equal_333_s7_q;
  logic equal_342_s7_q;
  logic not_343_s7_q;
  logic equal_344_s7_q;
  logic less_345_s7_q;
  logic not_346_s7_q;
  logic equal_376_s7_q;
  logic drew_s7_q;
  logic and_432_s7_q;
  logic [6:0] x_s7_2_q;
  logic and_483_s7_q;
  logic equal_489_s7_q;
  logic and_495_s7_q;
  logic and_496_s7_q;
  logic [5:0] not_501_s7_q;
  logic [2:0] sum_506_s7_q;
  logic and_514_s7_q;
  logic and_515_s7_q;
  logic [5:0] not_520_s7_q;
  logic [2:0] sum_525_s7_q;
  logic and_534_s7_q;
  logic and_535_s7_q;
  logic [5:0] not_540_s7_q;
  logic [2:0] sum_545_s7_q;
  logic equal_556_s7_q;
  logic [5:0] not_561_s7_q;
  logic [2:0] sum_566_s7_q;
  logic [5:0] not_576_s7_q;
  logic [2:0] sum_581_s7_q;
  logic and_590_s7_q;
  logic [5:0] not_594_s7_q;
  logic [2:0] sum_599_s7_q;
  logic and_614_s7_q;
  logic [5:0] not_618_s7_q;
  logic [2:0] sum_623_s7_q;
  logic [5:0] not_633_s7_q;
  logic [2:0] sum_638_s7_q;
  logic [5:0] not_649_s7_q;
  logic [2:0] sum_654_s7_q;
  logic [5:0] not_673_s7_q;
  logic [2:0] sum_678_s7_q;
  logic [5:0] not_688_s7_q;
  logic [2:0] sum_693_s7_q;
  logic and_703_s7_q;
  logic [5:0] not_706_s7_q;
  logic [2:0] sum_711_s7_q;
  logic and_732_s7_q;
  logic [5:0] not_735_s7_q;
  logic [2:0] sum_740_s7_q;
  logic [5:0] not_750_s7_q;
  logic [2:0] sum_755_s7_q;
  logic [5:0] not_766_s7_q;
  logic [2:0] sum_771_s7_q;
  logic equal_793_s7_q;
  logic equal_857_s7_q;
  logic equal_880_s7_q;
  logic equal_883_s7_q;
  logic and_894_s7_q;
  logic select_932_s7_q;
  logic and_1027_s7_q;
  logic equal_1143_s7_q;
  logic equal_1194_s7_q;
  logic not_1240_s7_q;
  logic and_1328_s7_q;
  logic less_1410_s7_q;
  logic less_1413_s7_q;
  logic equal_1678_s7_q;
  logic less_1687_s7_q;
  logic equal_1846_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      run_shift_s7_q <= run_shift_s6_q;
      x_s7_q <= x_s6_q;
      age_s7_q <= age_s6_q;
      lower_half_s7_q <= lower_half_s6_q;
      equal_296_s7_q <= equal_296_s6_q;
      select_298_s7_q <= select_298_s6_q;
      select_302_s7_q <= select_302_s6_q;
      and_311_s7_q <= and_311_s6_q;
      equal_316_s7_q <= equal_316_s6_q;
      and_329_s7_q <= and_329_s6_q;
      and_330_s7_q <= and_330_s6_q;
      equal_333_s7_q <= equal_333_s6_q;
      equal_342_s7_q <= equal_342_s6_q;
      not_343_s7_q <= not_343_s6_q;
      equal_344_s7_q <= equal_344_s6_q;
      less_345_s7_q <= less_345_s6_q;
      not_346_s7_q <= not_346_s6_q;
      equal_376_s7_q <= equal_376_s6_q;
      drew_s7_q <= drew_s6_q;
      and_432_s7_q <= and_432_s6_q;
      x_s7_2_q <= x_s6_2_q;
      and_483_s7_q <= and_483_s6_q;
      equal_489_s7_q <= equal_489_s6_q;
      and_495_s7_q <= and_495_s6_q;
      and_496_s7_q <= and_496_s6_q;
      not_501_s7_q <= not_501_s6_q[7:2];
      sum_506_s7_q <= sum_506;
      and_514_s7_q <= and_514_s6_q;
      and_515_s7_q <= and_515_s6_q;
      not_520_s7_q <= not_520_s6_q[7:2];
      sum_525_s7_q <= sum_525;
      and_534_s7_q <= and_534_s6_q;
      and_535_s7_q <= and_535_s6_q;
      not_540_s7_q <= not_540_s6_q[7:2];
      sum_545_s7_q <= sum_545;
      equal_556_s7_q <= equal_556_s6_q;
      not_561_s7_q <= not_561_s6_q[7:2];
      sum_566_s7_q <= sum_566;
      not_576_s7_q <= not_576_s6_q[7:2];
      sum_581_s7_q <= sum_581;
      and_590_s7_q <= and_590_s6_q;
      not_594_s7_q <= not_594_s6_q[7:2];
      sum_599_s7_q <= sum_599;
      and_614_s7_q <= and_614_s6_q;
      not_618_s7_q <= not_618_s6_q[7:2];
      sum_623_s7_q <= sum_623;
      not_633_s7_q <= not_633_s6_q[7:2];
      sum_638_s7_q <= sum_638;
      not_649_s7_q <= not_649_s6_q[7:2];
      sum_654_s7_q <= sum_654;
      not_673_s7_q <= not_673_s6_q[7:2];
      sum_678_s7_q <= sum_678;
      not_688_s7_q <= not_688_s6_q[7:2];
      sum_693_s7_q <= sum_693;
      and_703_s7_q <= and_703_s6_q;
      not_706_s7_q <= not_706_s6_q[7:2];
      sum_711_s7_q <= sum_711;
      and_732_s7_q <= and_732_s6_q;
      not_735_s7_q <= not_735_s6_q[7:2];
      sum_740_s7_q <= sum_740;
      not_750_s7_q <= not_750_s6_q[7:2];
      sum_755_s7_q <= sum_755;
      not_766_s7_q <= not_766_s6_q[7:2];
      sum_771_s7_q <= sum_771;
      equal_793_s7_q <= equal_793_s6_q;
      equal_857_s7_q <= equal_857_s6_q;
      equal_880_s7_q <= equal_880_s6_q;
      equal_883_s7_q <= equal_883_s6_q;
      and_894_s7_q <= and_894_s6_q;
      select_932_s7_q <= select_932_s6_q;
      and_1027_s7_q <= and_1027_s6_q;
      equal_1143_s7_q <= equal_1143_s6_q;
      equal_1194_s7_q <= equal_1194_s6_q;
      not_1240_s7_q <= not_1240_s6_q;
      and_1328_s7_q <= and_1328_s6_q;
      less_1410_s7_q <= less_1410_s6_q;
      less_1413_s7_q <= less_1413_s6_q;
      equal_1678_s7_q <= equal_1678_s6_q;
      less_1687_s7_q <= less_1687_s6_q;
      equal_1846_s7_q <= equal_1846_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:375
  logic [2:0] sum_507;
  assign sum_507 = {2'h0, not_501_s7_q[0]} + sum_506_s7_q;
  logic [2:0] sum_526;
  assign sum_526 = {2'h0, not_520_s7_q[0]} + sum_525_s7_q;
  logic [2:0] sum_546;
  assign sum_546 = {2'h0, not_540_s7_q[0]} + sum_545_s7_q;
  logic [2:0] sum_567;
  assign sum_567 = {2'h0, not_561_s7_q[0]} + sum_566_s7_q;
  logic [2:0] sum_582;
  assign sum_582 = {2'h0, not_576_s7_q[0]} + sum_581_s7_q;
  logic [2:0] sum_600;
  assign sum_600 = {2'h0, not_594_s7_q[0]} + sum_599_s7_q;
  logic [2:0] sum_624;
  assign sum_624 = {2'h0, not_618_s7_q[0]} + sum_623_s7_q;
  logic [2:0] sum_639;
  assign sum_639 = {2'h0, not_633_s7_q[0]} + sum_638_s7_q;
  logic [2:0] sum_655;
  assign sum_655 = {2'h0, not_649_s7_q[0]} + sum_654_s7_q;
  logic [2:0] sum_679;
  assign sum_679 = {2'h0, not_673_s7_q[0]} + sum_678_s7_q;
  logic [2:0] sum_694;
  assign sum_694 = {2'h0, not_688_s7_q[0]} + sum_693_s7_q;
  logic [2:0] sum_712;
  assign sum_712 = {2'h0, not_706_s7_q[0]} + sum_711_s7_q;
  logic [2:0] sum_741;
  assign sum_741 = {2'h0, not_735_s7_q[0]} + sum_740_s7_q;
  logic [2:0] sum_756;
  assign sum_756 = {2'h0, not_750_s7_q[0]} + sum_755_s7_q;
  logic [2:0] sum_772;
  assign sum_772 = {2'h0, not_766_s7_q[0]} + sum_771_s7_q;

  logic [7:0] pixel_0_s8_q;
  logic [7:0] pixel_1_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [1:0] age_s8_q;
  logic lower_half_s8_q;
  logic equal_296_s8_q;
  logic [6:0] select_298_s8_q;
  logic [8:0] select_302_s8_q;
  logic and_311_s8_q;
  logic equal_316_s8_q;
  logic and_329_s8_q;
  logic and_330_s8_q;
  logic equal_333_s8_q;
  logic equal_342_s8_q;
  logic not_343_s8_q;
  logic equal_344_s8_q;
  logic less_345_s8_q;
  logic not_346_s8_q;
  logic equal_376_s8_q;
  logic drew_s8_q;
  logic and_432_s8_q;
  logic [6:0] x_s8_2_q;
  logic and_483_s8_q;
  logic equal_489_s8_q;
  logic and_495_s8_q;
  logic and_496_s8_q;
  logic [3:0] not_501_s8_q;
  logic [3:0] sum_508_s8_q;
  logic and_514_s8_q;
  logic and_515_s8_q;
  logic [3:0] not_520_s8_q;
  logic [3:0] sum_527_s8_q;
  logic and_534_s8_q;
  logic and_535_s8_q;
  logic [3:0] not_540_s8_q;
  logic [3:0] sum_547_s8_q;
  logic equal_556_s8_q;
  logic [3:0] not_561_s8_q;
  logic [3:0] sum_568_s8_q;
  logic [3:0] not_576_s8_q;
  logic [3:0] sum_583_s8_q;
  logic and_590_s8_q;
  logic [3:0] not_594_s8_q;
  logic [3:0] sum_601_s8_q;
  logic and_614_s8_q;
  logic [3:0] not_618_s8_q;
  logic [3:0] sum_625_s8_q;
  logic [3:0] not_633_s8_q;
  logic [3:0] sum_640_s8_q;
  logic [3:0] not_649_s8_q;
  logic [3:0] sum_656_s8_q;
  logic [3:0] not_673_s8_q;
  logic [3:0] sum_680_s8_q;
  logic [3:0] not_688_s8_q;
  logic [3:0] sum_695_s8_q;
  logic and_703_s8_q;
  logic [3:0] not_706_s8_q;
  logic [3:0] sum_713_s8_q;
  logic and_732_s8_q;
  logic [3:0] not_735_s8_q;
  logic [3:0] sum_742_s8_q;
  logic [3:0] not_750_s8_q;
  logic [3:0] sum_757_s8_q;
  logic [3:0] not_766_s8_q;
  logic [3:0] sum_773_s8_q;
  logic equal_793_s8_q;
  logic equal_857_s8_q;
  logic equal_880_s8_q;
  logic equal_883_s8_q;
  logic and_894_s8_q;
  logic select_932_s8_q;
  logic and_1027_s8_q;
  logic equal_1143_s8_q;
  logic equal_1194_s8_q;
  logic not_1240_s8_q;
  logic and_1328_s8_q;
  logic less_1410_s8_q;
  logic less_1413_s8_q;
  logic equal_1678_s8_q;
  logic less_1687_s8_q;
  logic equal_1846_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      age_s8_q <= age_s7_q;
      lower_half_s8_q <= lower_half_s7_q;
      equal_296_s8_q <= equal_296_s7_q;
      select_298_s8_q <= select_298_s7_q;
      select_302_s8_q <= select_302_s7_q;
      and_311_s8_q <= and_311_s7_q;
      equal_316_s8_q <= equal_316_s7_q;
      and_329_s8_q <= and_329_s7_q;
      and_330_s8_q <= and_330_s7_q;
      equal_333_s8_q <= equal_333_s7_q;
      equal_342_s8_q <= equal_342_s7_q;
      not_343_s8_q <= not_343_s7_q;
      equal_344_s8_q <= equal_344_s7_q;
      less_345_s8_q <= less_345_s7_q;
      not_346_s8_q <= not_346_s7_q;
      equal_376_s8_q <= equal_376_s7_q;
      drew_s8_q <= drew_s7_q;
      and_432_s8_q <= and_432_s7_q;
      x_s8_2_q <= x_s7_2_q;
      and_483_s8_q <= and_483_s7_q;
      equal_489_s8_q <= equal_489_s7_q;
      and_495_s8_q <= and_495_s7_q;
      and_496_s8_q <= and_496_s7_q;
      not_501_s8_q <= not_501_s7_q[5:2];
      sum_508_s8_q <= {3'h0, not_501_s7_q[1]} + {1'b0, sum_507};
      and_514_s8_q <= and_514_s7_q;
      and_515_s8_q <= and_515_s7_q;
      not_520_s8_q <= not_520_s7_q[5:2];
      sum_527_s8_q <= {3'h0, not_520_s7_q[1]} + {1'b0, sum_526};
      and_534_s8_q <= and_534_s7_q;
      and_535_s8_q <= and_535_s7_q;
      not_540_s8_q <= not_540_s7_q[5:2];
      sum_547_s8_q <= {3'h0, not_540_s7_q[1]} + {1'b0, sum_546};
      equal_556_s8_q <= equal_556_s7_q;
      not_561_s8_q <= not_561_s7_q[5:2];
      sum_568_s8_q <= {3'h0, not_561_s7_q[1]} + {1'b0, sum_567};
      not_576_s8_q <= not_576_s7_q[5:2];
      sum_583_s8_q <= {3'h0, not_576_s7_q[1]} + {1'b0, sum_582};
      and_590_s8_q <= and_590_s7_q;
      not_594_s8_q <= not_594_s7_q[5:2];
      sum_601_s8_q <= {3'h0, not_594_s7_q[1]} + {1'b0, sum_600};
      and_614_s8_q <= and_614_s7_q;
      not_618_s8_q <= not_618_s7_q[5:2];
      sum_625_s8_q <= {3'h0, not_618_s7_q[1]} + {1'b0, sum_624};
      not_633_s8_q <= not_633_s7_q[5:2];
      sum_640_s8_q <= {3'h0, not_633_s7_q[1]} + {1'b0, sum_639};
      not_649_s8_q <= not_649_s7_q[5:2];
      sum_656_s8_q <= {3'h0, not_649_s7_q[1]} + {1'b0, sum_655};
      not_673_s8_q <= not_673_s7_q[5:2];
      sum_680_s8_q <= {3'h0, not_673_s7_q[1]} + {1'b0, sum_679};
      not_688_s8_q <= not_688_s7_q[5:2];
      sum_695_s8_q <= {3'h0, not_688_s7_q[1]} + {1'b0, sum_694};
      and_703_s8_q <= and_703_s7_q;
      not_706_s8_q <= not_706_s7_q[5:2];
      sum_713_s8_q <= {3'h0, not_706_s7_q[1]} + {1'b0, sum_712};
      and_732_s8_q <= and_732_s7_q;
      not_735_s8_q <= not_735_s7_q[5:2];
      sum_742_s8_q <= {3'h0, not_735_s7_q[1]} + {1'b0, sum_741};
      not_750_s8_q <= not_750_s7_q[5:2];
      sum_757_s8_q <= {3'h0, not_750_s7_q[1]} + {1'b0, sum_756};
      not_766_s8_q <= not_766_s7_q[5:2];
      sum_773_s8_q <= {3'h0, not_766_s7_q[1]} + {1'b0, sum_772};
      equal_793_s8_q <= equal_793_s7_q;
      equal_857_s8_q <= equal_857_s7_q;
      equal_880_s8_q <= equal_880_s7_q;
      equal_883_s8_q <= equal_883_s7_q;
      and_894_s8_q <= and_894_s7_q;
      select_932_s8_q <= select_932_s7_q;
      and_1027_s8_q <= and_1027_s7_q;
      equal_1143_s8_q <= equal_1143_s7_q;
      equal_1194_s8_q <= equal_1194_s7_q;
      not_1240_s8_q <= not_1240_s7_q;
      and_1328_s8_q <= and_1328_s7_q;
      less_1410_s8_q <= less_1410_s7_q;
      less_1413_s8_q <= less_1413_s7_q;
      equal_1678_s8_q <= equal_1678_s7_q;
      less_1687_s8_q <= less_1687_s7_q;
      equal_1846_s8_q <= equal_1846_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:375
  logic [3:0] sum_510;
  assign sum_510 = {3'h0, not_501_s8_q[1]} + ({3'h0, not_501_s8_q[0]} + sum_508_s8_q);
  logic [3:0] sum_529;
  assign sum_529 = {3'h0, not_520_s8_q[1]} + ({3'h0, not_520_s8_q[0]} + sum_527_s8_q);
  logic [3:0] sum_549;
  assign sum_549 = {3'h0, not_540_s8_q[1]} + ({3'h0, not_540_s8_q[0]} + sum_547_s8_q);
  logic [3:0] sum_570;
  assign sum_570 = {3'h0, not_561_s8_q[1]} + ({3'h0, not_561_s8_q[0]} + sum_568_s8_q);
  logic [3:0] sum_585;
  assign sum_585 = {3'h0, not_576_s8_q[1]} + ({3'h0, not_576_s8_q[0]} + sum_583_s8_q);
  logic [3:0] sum_603;
  assign sum_603 = {3'h0, not_594_s8_q[1]} + ({3'h0, not_594_s8_q[0]} + sum_601_s8_q);
  logic [3:0] sum_627;
  assign sum_627 = {3'h0, not_618_s8_q[1]} + ({3'h0, not_618_s8_q[0]} + sum_625_s8_q);
  logic [3:0] sum_642;
  assign sum_642 = {3'h0, not_633_s8_q[1]} + ({3'h0, not_633_s8_q[0]} + sum_640_s8_q);
  logic [3:0] sum_658;
  assign sum_658 = {3'h0, not_649_s8_q[1]} + ({3'h0, not_649_s8_q[0]} + sum_656_s8_q);
  logic [3:0] sum_682;
  assign sum_682 = {3'h0, not_673_s8_q[1]} + ({3'h0, not_673_s8_q[0]} + sum_680_s8_q);
  logic [3:0] sum_697;
  assign sum_697 = {3'h0, not_688_s8_q[1]} + ({3'h0, not_688_s8_q[0]} + sum_695_s8_q);
  logic [3:0] sum_715;
  assign sum_715 = {3'h0, not_706_s8_q[1]} + ({3'h0, not_706_s8_q[0]} + sum_713_s8_q);
  logic [3:0] sum_744;
  assign sum_744 = {3'h0, not_735_s8_q[1]} + ({3'h0, not_735_s8_q[0]} + sum_742_s8_q);
  logic [3:0] sum_759;
  assign sum_759 = {3'h0, not_750_s8_q[1]} + ({3'h0, not_750_s8_q[0]} + sum_757_s8_q);
  logic [3:0] sum_775;
  assign sum_775 = {3'h0, not_766_s8_q[1]} + ({3'h0, not_766_s8_q[0]} + sum_773_s8_q);

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [1:0] age_s9_q;
  logic lower_half_s9_q;
  logic equal_296_s9_q;
  logic [6:0] select_298_s9_q;
  logic [8:0] select_302_s9_q;
  logic and_311_s9_q;
  logic equal_316_s9_q;
  logic and_329_s9_q;
  logic and_330_s9_q;
  logic equal_333_s9_q;
  logic equal_342_s9_q;
  logic not_343_s9_q;
  logic equal_344_s9_q;
  logic less_345_s9_q;
  logic not_346_s9_q;
  logic equal_376_s9_q;
  logic drew_s9_q;
  logic and_432_s9_q;
  logic [6:0] x_s9_2_q;
  logic and_483_s9_q;
  logic equal_489_s9_q;
  logic and_495_s9_q;
  logic and_496_s9_q;
  logic [1:0] not_501_s9_q;
  logic [3:0] sum_510_s9_q;
  logic and_514_s9_q;
  logic and_515_s9_q;
  logic [1:0] not_520_s9_q;
  logic [3:0] sum_529_s9_q;
  logic and_534_s9_q;
  logic and_535_s9_q;
  logic [1:0] not_540_s9_q;
  logic [3:0] sum_549_s9_q;
  logic equal_556_s9_q;
  logic [1:0] not_561_s9_q;
  logic [3:0] sum_570_s9_q;
  logic [1:0] not_576_s9_q;
  logic [3:0] sum_585_s9_q;
  logic and_590_s9_q;
  logic [1:0] not_594_s9_q;
  logic [3:0] sum_603_s9_q;
  logic and_614_s9_q;
  logic [1:0] not_618_s9_q;
  logic [3:0] sum_627_s9_q;
  logic [1:0] not_633_s9_q;
  logic [3:0] sum_642_s9_q;
  logic [1:0] not_649_s9_q;
  logic [3:0] sum_658_s9_q;
  logic [1:0] not_673_s9_q;
  logic [3:0] sum_682_s9_q;
  logic [1:0] not_688_s9_q;
  logic [3:0] sum_697_s9_q;
  logic and_703_s9_q;
  logic [1:0] not_706_s9_q;
  logic [3:0] sum_715_s9_q;
  logic and_732_s9_q;
  logic [1:0] not_735_s9_q;
  logic [3:0] sum_744_s9_q;
  logic [1:0] not_750_s9_q;
  logic [3:0] sum_759_s9_q;
  logic [1:0] not_766_s9_q;
  logic [3:0] sum_775_s9_q;
  logic equal_793_s9_q;
  logic equal_857_s9_q;
  logic equal_880_s9_q;
  logic equal_883_s9_q;
  logic and_894_s9_q;
  logic select_932_s9_q;
  logic and_1027_s9_q;
  logic equal_1143_s9_q;
  logic equal_1194_s9_q;
  logic not_1240_s9_q;
  logic and_1328_s9_q;
  logic less_1410_s9_q;
  logic less_1413_s9_q;
  logic equal_1678_s9_q;
  logic less_1687_s9_q;
  logic equal_1846_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      age_s9_q <= age_s8_q;
      lower_half_s9_q <= lower_half_s8_q;
      equal_296_s9_q <= equal_296_s8_q;
      select_298_s9_q <= select_298_s8_q;
      select_302_s9_q <= select_302_s8_q;
      and_311_s9_q <= and_311_s8_q;
      equal_316_s9_q <= equal_316_s8_q;
      and_329_s9_q <= and_329_s8_q;
      and_330_s9_q <= and_330_s8_q;
      equal_333_s9_q <= equal_333_s8_q;
      equal_342_s9_q <= equal_342_s8_q;
      not_343_s9_q <= not_343_s8_q;
      equal_344_s9_q <= equal_344_s8_q;
      less_345_s9_q <= less_345_s8_q;
      not_346_s9_q <= not_346_s8_q;
      equal_376_s9_q <= equal_376_s8_q;
      drew_s9_q <= drew_s8_q;
      and_432_s9_q <= and_432_s8_q;
      x_s9_2_q <= x_s8_2_q;
      and_483_s9_q <= and_483_s8_q;
      equal_489_s9_q <= equal_489_s8_q;
      and_495_s9_q <= and_495_s8_q;
      and_496_s9_q <= and_496_s8_q;
      not_501_s9_q <= not_501_s8_q[3:2];
      sum_510_s9_q <= sum_510;
      and_514_s9_q <= and_514_s8_q;
      and_515_s9_q <= and_515_s8_q;
      not_520_s9_q <= not_520_s8_q[3:2];
      sum_529_s9_q <= sum_529;
      and_534_s9_q <= and_534_s8_q;
      and_535_s9_q <= and_535_s8_q;
      not_540_s9_q <= not_540_s8_q[3:2];
      sum_549_s9_q <= sum_549;
      equal_556_s9_q <= equal_556_s8_q;
      not_561_s9_q <= not_561_s8_q[3:2];
      sum_570_s9_q <= sum_570;
      not_576_s9_q <= not_576_s8_q[3:2];
      sum_585_s9_q <= sum_585;
      and_590_s9_q <= and_590_s8_q;
      not_594_s9_q <= not_594_s8_q[3:2];
      sum_603_s9_q <= sum_603;
      and_614_s9_q <= and_614_s8_q;
      not_618_s9_q <= not_618_s8_q[3:2];
      sum_627_s9_q <= sum_627;
      not_633_s9_q <= not_633_s8_q[3:2];
      sum_642_s9_q <= sum_642;
      not_649_s9_q <= not_649_s8_q[3:2];
      sum_658_s9_q <= sum_658;
      not_673_s9_q <= not_673_s8_q[3:2];
      sum_682_s9_q <= sum_682;
      not_688_s9_q <= not_688_s8_q[3:2];
      sum_697_s9_q <= sum_697;
      and_703_s9_q <= and_703_s8_q;
      not_706_s9_q <= not_706_s8_q[3:2];
      sum_715_s9_q <= sum_715;
      and_732_s9_q <= and_732_s8_q;
      not_735_s9_q <= not_735_s8_q[3:2];
      sum_744_s9_q <= sum_744;
      not_750_s9_q <= not_750_s8_q[3:2];
      sum_759_s9_q <= sum_759;
      not_766_s9_q <= not_766_s8_q[3:2];
      sum_775_s9_q <= sum_775;
      equal_793_s9_q <= equal_793_s8_q;
      equal_857_s9_q <= equal_857_s8_q;
      equal_880_s9_q <= equal_880_s8_q;
      equal_883_s9_q <= equal_883_s8_q;
      and_894_s9_q <= and_894_s8_q;
      select_932_s9_q <= select_932_s8_q;
      and_1027_s9_q <= and_1027_s8_q;
      equal_1143_s9_q <= equal_1143_s8_q;
      equal_1194_s9_q <= equal_1194_s8_q;
      not_1240_s9_q <= not_1240_s8_q;
      and_1328_s9_q <= and_1328_s8_q;
      less_1410_s9_q <= less_1410_s8_q;
      less_1413_s9_q <= less_1413_s8_q;
      equal_1678_s9_q <= equal_1678_s8_q;
      less_1687_s9_q <= less_1687_s8_q;
      equal_1846_s9_q <= equal_1846_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [23:0] slope_row_q;
  logic [27:0] slope_change_q;
  logic [27:0] slope_q;
  logic [23:0] next_slope_row_q;
  logic [27:0] next_slope_change_q;
  // hls/stages/agreement.hpp:318
  logic not_484;
  assign not_484 = ~equal_344_s9_q;
  // hls/stages/agreement.hpp:298
  logic and_485;
  assign and_485 = not_484 & and_432_s9_q;
  logic select_486;
  assign select_486 = equal_342_s9_q ? and_483_s9_q : and_485;
  // hls/stages/agreement.hpp:375
  logic [3:0] sum_512;
  assign sum_512 = {3'h0, not_501_s9_q[1]} + ({3'h0, not_501_s9_q[0]} + sum_510_s9_q);
  logic [3:0] column;
  assign column = (and_495_s9_q & and_496_s9_q) ? sum_512 : 4'h0;
  logic [3:0] sum_531;
  assign sum_531 = {3'h0, not_520_s9_q[1]} + ({3'h0, not_520_s9_q[0]} + sum_529_s9_q);
  logic [3:0] sum_551;
  assign sum_551 = {3'h0, not_540_s9_q[1]} + ({3'h0, not_540_s9_q[0]} + sum_549_s9_q);
  logic [3:0] sum_572;
  assign sum_572 = {3'h0, not_561_s9_q[1]} + ({3'h0, not_561_s9_q[0]} + sum_570_s9_q);
  logic [3:0] column_4;
  assign column_4 = (and_495_s9_q & and_515_s9_q) ? sum_572 : 4'h0;
  logic [3:0] sum_587;
  assign sum_587 = {3'h0, not_576_s9_q[1]} + ({3'h0, not_576_s9_q[0]} + sum_585_s9_q);
  logic [3:0] sum_605;
  assign sum_605 = {3'h0, not_594_s9_q[1]} + ({3'h0, not_594_s9_q[0]} + sum_603_s9_q);
  logic [3:0] sum_629;
  assign sum_629 = {3'h0, not_618_s9_q[1]} + ({3'h0, not_618_s9_q[0]} + sum_627_s9_q);
  logic [3:0] column_7;
  assign column_7 = (and_495_s9_q & and_614_s9_q) ? sum_629 : 4'h0;
  logic [3:0] sum_644;
  assign sum_644 = {3'h0, not_633_s9_q[1]} + ({3'h0, not_633_s9_q[0]} + sum_642_s9_q);
  logic [3:0] sum_660;
  assign sum_660 = {3'h0, not_649_s9_q[1]} + ({3'h0, not_649_s9_q[0]} + sum_658_s9_q);
  logic [3:0] sum_684;
  assign sum_684 = {3'h0, not_673_s9_q[1]} + ({3'h0, not_673_s9_q[0]} + sum_682_s9_q);
  logic [3:0] column_10;
  assign column_10 = (and_495_s9_q & and_535_s9_q) ? sum_684 : 4'h0;
  logic [3:0] sum_699;
  assign sum_699 = {3'h0, not_688_s9_q[1]} + ({3'h0, not_688_s9_q[0]} + sum_697_s9_q);
  logic [3:0] sum_717;
  assign sum_717 = {3'h0, not_706_s9_q[1]} + ({3'h0, not_706_s9_q[0]} + sum_715_s9_q);
  logic [3:0] sum_746;
  assign sum_746 = {3'h0, not_735_s9_q[1]} + ({3'h0, not_735_s9_q[0]} + sum_744_s9_q);
  logic [3:0] column_13;
  assign column_13 = and_732_s9_q ? sum_746 : 4'h0;
  logic [3:0] sum_761;
  assign sum_761 = {3'h0, not_750_s9_q[1]} + ({3'h0, not_750_s9_q[0]} + sum_759_s9_q);
  logic [3:0] sum_777;
  assign sum_777 = {3'h0, not_766_s9_q[1]} + ({3'h0, not_766_s9_q[0]} + sum_775_s9_q);
  // hls/stages/agreement.hpp:637
  logic [16:0] select_1418;
  assign select_1418 = ($signed(slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : slope_change_q[27:11];
  // hls/stages/agreement.hpp:256
  logic [23:0] select_1679;
  assign select_1679 = equal_1678_s9_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : next_slope_row_q;
  // hls/stages/agreement.hpp:173
  logic [23:0] select_1681;
  assign select_1681 = and_330_s9_q ? (equal_1194_s9_q ? select_1679 : slope_row_q) : slope_row_q;
  // hls/stages/agreement.hpp:257
  logic [27:0] select_1682;
  assign select_1682 = equal_1678_s9_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : next_slope_change_q;
  // hls/stages/agreement.hpp:173
  logic [27:0] select_1684;
  assign select_1684 = and_330_s9_q ? (equal_1194_s9_q ? select_1682 : slope_change_q) : slope_change_q;
  // hls/stages/agreement.hpp:137
  logic [23:0] sum_1767;
  assign sum_1767 = {{8{cfg_epipolar_row_i[15]}}, $unsigned(cfg_epipolar_row_i)} + slope_row_q;
  // hls/stages/agreement.hpp:138
  logic [27:0] sum_1768;
  assign sum_1768 = {{12{cfg_epipolar_both_i[15]}}, $unsigned(cfg_epipolar_both_i)} + slope_change_q;

  // Memory best_left, 120 x 22, DISTANCE 32, hls/stages/agreement.hpp:888; read in stage 9, written in stage 26: 9 < 26 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 22'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = equal_342_s9_q ? x_s9_2_q : x_s9_q[6:0];
  logic best_left_re;
  assign best_left_re = s9_en & select_486;
  logic [21:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      slope_row_q <= 24'h0;
      slope_change_q <= 28'h0;
      slope_q <= 28'h0;
      next_slope_row_q <= 24'h0;
      next_slope_change_q <= 28'h0;
    end else if (s9_en) begin
      slope_row_q <= select_1681;
      slope_change_q <= select_1684;
      slope_q <= drew_s9_q ? (slope_change_q + slope_q) : {slope_row_q, 4'h0};
      next_slope_row_q <= sum_1767;
      next_slope_change_q <= sum_1768;
    end
  end

  logic [7:0] pixel_0_s10_q;
  logic [7:0] pixel_1_s10_q;
  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [1:0] age_s10_q;
  logic lower_half_s10_q;
  logic [11:0] slope_s10_q;
  logic equal_296_s10_q;
  logic [6:0] select_298_s10_q;
  logic [8:0] select_302_s10_q;
  logic and_311_s10_q;
  logic equal_316_s10_q;
  logic and_329_s10_q;
  logic and_330_s10_q;
  logic equal_333_s10_q;
  logic equal_342_s10_q;
  logic not_343_s10_q;
  logic equal_344_s10_q;
  logic less_345_s10_q;
  logic not_346_s10_q;
  logic equal_376_s10_q;
  logic drew_s10_q;
  logic [6:0] x_s10_2_q;
  logic not_484_s10_q;
  logic select_486_s10_q;
  logic equal_489_s10_q;
  logic [3:0] column_s10_q;
  logic [3:0] select_532_s10_q;
  logic [3:0] select_552_s10_q;
  logic equal_556_s10_q;
  logic [3:0] column_4_s10_q;
  logic [3:0] select_588_s10_q;
  logic [3:0] select_606_s10_q;
  logic [3:0] column_7_s10_q;
  logic [3:0] select_645_s10_q;
  logic [3:0] select_661_s10_q;
  logic [3:0] column_10_s10_q;
  logic [3:0] select_700_s10_q;
  logic [3:0] select_718_s10_q;
  logic [3:0] column_13_s10_q;
  logic [3:0] select_762_s10_q;
  logic [3:0] select_778_s10_q;
  logic equal_793_s10_q;
  logic and_851_s10_q;
  logic equal_857_s10_q;
  logic equal_880_s10_q;
  logic equal_883_s10_q;
  logic and_894_s10_q;
  logic and_924_s10_q;
  logic select_932_s10_q;
  logic and_1029_s10_q;
  logic equal_1143_s10_q;
  logic equal_1194_s10_q;
  logic not_1240_s10_q;
  logic and_1328_s10_q;
  logic less_1410_s10_q;
  logic less_1413_s10_q;
  logic [16:0] select_1418_s10_q;
  logic less_1687_s10_q;
  logic equal_1846_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      age_s10_q <= age_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      slope_s10_q <= slope_q[27:16];
      equal_296_s10_q <= equal_296_s9_q;
      select_298_s10_q <= select_298_s9_q;
      select_302_s10_q <= select_302_s9_q;
      and_311_s10_q <= and_311_s9_q;
      equal_316_s10_q <= equal_316_s9_q;
      and_329_s10_q <= and_329_s9_q;
      and_330_s10_q <= and_330_s9_q;
      equal_333_s10_q <= equal_333_s9_q;
      equal_342_s10_q <= equal_342_s9_q;
      not_343_s10_q <= not_343_s9_q;
      equal_344_s10_q <= equal_344_s9_q;
      less_345_s10_q <= less_345_s9_q;
      not_346_s10_q <= not_346_s9_q;
      equal_376_s10_q <= equal_376_s9_q;
      drew_s10_q <= drew_s9_q;
      x_s10_2_q <= x_s9_2_q;
      not_484_s10_q <= not_484;
      select_486_s10_q <= select_486;
      equal_489_s10_q <= equal_489_s9_q;
      column_s10_q <= column;
      select_532_s10_q <= (and_514_s9_q & and_515_s9_q) ? sum_531 : 4'h0;
      select_552_s10_q <= (and_534_s9_q & and_535_s9_q) ? sum_551 : 4'h0;
      equal_556_s10_q <= equal_556_s9_q;
      column_4_s10_q <= column_4;
      select_588_s10_q <= (and_514_s9_q & and_535_s9_q) ? sum_587 : 4'h0;
      select_606_s10_q <= (and_534_s9_q & and_590_s9_q) ? sum_605 : 4'h0;
      column_7_s10_q <= column_7;
      select_645_s10_q <= (and_514_s9_q & and_496_s9_q) ? sum_644 : 4'h0;
      select_661_s10_q <= (and_534_s9_q & and_515_s9_q) ? sum_660 : 4'h0;
      column_10_s10_q <= column_10;
      select_700_s10_q <= (and_514_s9_q & and_590_s9_q) ? sum_699 : 4'h0;
      select_718_s10_q <= and_703_s9_q ? sum_717 : 4'h0;
      column_13_s10_q <= column_13;
      select_762_s10_q <= (and_514_s9_q & and_614_s9_q) ? sum_761 : 4'h0;
      select_778_s10_q <= (and_534_s9_q & and_496_s9_q) ? sum_777 : 4'h0;
      equal_793_s10_q <= equal_793_s9_q;
      and_851_s10_q <= equal_342_s9_q & and_483_s9_q;
      equal_857_s10_q <= equal_857_s9_q;
      equal_880_s10_q <= equal_880_s9_q;
      equal_883_s10_q <= equal_883_s9_q;
      and_894_s10_q <= and_894_s9_q;
      and_924_s10_q <= not_343_s9_q & and_485;
      select_932_s10_q <= select_932_s9_q;
      and_1029_s10_q <= not_343_s9_q & (not_484 & and_1027_s9_q);
      equal_1143_s10_q <= equal_1143_s9_q;
      equal_1194_s10_q <= equal_1194_s9_q;
      not_1240_s10_q <= not_1240_s9_q;
      and_1328_s10_q <= and_1328_s9_q;
      less_1410_s10_q <= less_1410_s9_q;
      less_1413_s10_q <= less_1413_s9_q;
      select_1418_s10_q <= select_1418;
      less_1687_s10_q <= less_1687_s9_q;
      equal_1846_s10_q <= equal_1846_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:403
  logic [4:0] column_2;
  assign column_2 = {1'b0, column_s10_q} + {1'b0, select_532_s10_q};
  logic [5:0] column_3;
  assign column_3 = {1'b0, column_2} + {2'h0, select_552_s10_q};
  logic [4:0] column_5;
  assign column_5 = {1'b0, column_4_s10_q} + {1'b0, select_588_s10_q};
  logic [5:0] column_6;
  assign column_6 = {1'b0, column_5} + {2'h0, select_606_s10_q};
  logic [4:0] column_8;
  assign column_8 = {1'b0, column_7_s10_q} + {1'b0, select_645_s10_q};
  logic [5:0] column_9;
  assign column_9 = {1'b0, column_8} + {2'h0, select_661_s10_q};
  logic [4:0] column_11;
  assign column_11 = {1'b0, column_10_s10_q} + {1'b0, select_700_s10_q};
  logic [5:0] column_12;
  assign column_12 = {1'b0, column_11} + {2'h0, select_718_s10_q};
  logic [4:0] column_14;
  assign column_14 = {1'b0, column_13_s10_q} + {1'b0, select_762_s10_q};
  logic [5:0] column_15;
  assign column_15 = {1'b0, column_14} + {2'h0, select_778_s10_q};
  // hls/stages/agreement.hpp:637
  logic [13:0] select_1420;
  assign select_1420 = ($signed(10'h0) < $signed(select_1418_s10_q[16:7])) ? 14'h7f : select_1418_s10_q[13:0];

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [1:0] age_s11_q;
  logic lower_half_s11_q;
  logic [11:0] slope_s11_q;
  logic equal_296_s11_q;
  logic [6:0] select_298_s11_q;
  logic [8:0] select_302_s11_q;
  logic and_311_s11_q;
  logic equal_316_s11_q;
  logic and_329_s11_q;
  logic and_330_s11_q;
  logic equal_333_s11_q;
  logic equal_342_s11_q;
  logic not_343_s11_q;
  logic equal_344_s11_q;
  logic less_345_s11_q;
  logic not_346_s11_q;
  logic equal_376_s11_q;
  logic drew_s11_q;
  logic [6:0] x_s11_2_q;
  logic not_484_s11_q;
  logic select_486_s11_q;
  logic [21:0] best_left_rdata_s11_q;
  logic equal_489_s11_q;
  logic [5:0] column_3_s11_q;
  logic equal_556_s11_q;
  logic [5:0] column_6_s11_q;
  logic [5:0] column_9_s11_q;
  logic [5:0] column_12_s11_q;
  logic [5:0] column_15_s11_q;
  logic equal_793_s11_q;
  logic and_851_s11_q;
  logic equal_857_s11_q;
  logic equal_880_s11_q;
  logic equal_883_s11_q;
  logic and_894_s11_q;
  logic and_924_s11_q;
  logic select_932_s11_q;
  logic and_1029_s11_q;
  logic equal_1143_s11_q;
  logic equal_1194_s11_q;
  logic not_1240_s11_q;
  logic and_1328_s11_q;
  logic less_1410_s11_q;
  logic less_1413_s11_q;
  logic [13:0] select_1420_s11_q;
  logic less_1687_s11_q;
  logic equal_1846_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      age_s11_q <= age_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      slope_s11_q <= slope_s10_q;
      equal_296_s11_q <= equal_296_s10_q;
      select_298_s11_q <= select_298_s10_q;
      select_302_s11_q <= select_302_s10_q;
      and_311_s11_q <= and_311_s10_q;
      equal_316_s11_q <= equal_316_s10_q;
      and_329_s11_q <= and_329_s10_q;
      and_330_s11_q <= and_330_s10_q;
      equal_333_s11_q <= equal_333_s10_q;
      equal_342_s11_q <= equal_342_s10_q;
      not_343_s11_q <= not_343_s10_q;
      equal_344_s11_q <= equal_344_s10_q;
      less_345_s11_q <= less_345_s10_q;
      not_346_s11_q <= not_346_s10_q;
      equal_376_s11_q <= equal_376_s10_q;
      drew_s11_q <= drew_s10_q;
      x_s11_2_q <= x_s10_2_q;
      not_484_s11_q <= not_484_s10_q;
      select_486_s11_q <= select_486_s10_q;
      best_left_rdata_s11_q <= best_left_rdata_q;
      equal_489_s11_q <= equal_489_s10_q;
      column_3_s11_q <= column_3;
      equal_556_s11_q <= equal_556_s10_q;
      column_6_s11_q <= column_6;
      column_9_s11_q <= column_9;
      column_12_s11_q <= column_12;
      column_15_s11_q <= column_15;
      equal_793_s11_q <= equal_793_s10_q;
      and_851_s11_q <= and_851_s10_q;
      equal_857_s11_q <= equal_857_s10_q;
      equal_880_s11_q <= equal_880_s10_q;
      equal_883_s11_q <= equal_883_s10_q;
      and_894_s11_q <= and_894_s10_q;
      and_924_s11_q <= and_924_s10_q;
      select_932_s11_q <= select_932_s10_q;
      and_1029_s11_q <= and_1029_s10_q;
      equal_1143_s11_q <= equal_1143_s10_q;
      equal_1194_s11_q <= equal_1194_s10_q;
      not_1240_s11_q <= not_1240_s10_q;
      and_1328_s11_q <= and_1328_s10_q;
      less_1410_s11_q <= less_1410_s10_q;
      less_1413_s11_q <= less_1413_s10_q;
      select_1420_s11_q <= select_1420;
      less_1687_s11_q <= less_1687_s10_q;
      equal_1846_s11_q <= equal_1846_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_1_columns_values_0_q;
  logic [7:0] sums_1_columns_values_1_q;
  logic [7:0] sums_1_columns_values_2_q;
  logic [7:0] sums_1_columns_values_3_q;
  logic [7:0] sums_1_columns_values_4_q;
  logic [7:0] sums_1_columns_values_5_q;
  logic [7:0] sums_1_columns_values_6_q;
  logic [7:0] sums_2_columns_values_0_q;
  logic [7:0] sums_2_columns_values_1_q;
  logic [7:0] sums_2_columns_values_2_q;
  logic [7:0] sums_2_columns_values_3_q;
  logic [7:0] sums_2_columns_values_4_q;
  logic [7:0] sums_2_columns_values_5_q;
  logic [7:0] sums_2_columns_values_6_q;
  // hls/stages/agreement.hpp:405
  logic [7:0] difference_555;
  assign difference_555 = {2'h0, column_3_s11_q} - (age_s11_q[1] ? sums_2_columns_values_6_q : 8'h0);
  logic [7:0] difference_609;
  assign difference_609 = {2'h0, column_6_s11_q} - (age_s11_q[1] ? sums_1_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1294;
  assign select_1294 = equal_342_s11_q ? {2'h0, column_6_s11_q} : sums_1_columns_values_0_q;
  logic [7:0] select_1295;
  assign select_1295 = equal_342_s11_q ? sums_1_columns_values_0_q : sums_1_columns_values_1_q;
  logic [7:0] select_1296;
  assign select_1296 = equal_342_s11_q ? sums_1_columns_values_1_q : sums_1_columns_values_2_q;
  logic [7:0] select_1297;
  assign select_1297 = equal_342_s11_q ? sums_1_columns_values_2_q : sums_1_columns_values_3_q;
  logic [7:0] select_1298;
  assign select_1298 = equal_342_s11_q ? sums_1_columns_values_3_q : sums_1_columns_values_4_q;
  logic [7:0] select_1299;
  assign select_1299 = equal_342_s11_q ? sums_1_columns_values_4_q : sums_1_columns_values_5_q;
  logic [7:0] select_1300;
  assign select_1300 = equal_342_s11_q ? sums_1_columns_values_5_q : sums_1_columns_values_6_q;
  logic [7:0] select_1302;
  assign select_1302 = equal_342_s11_q ? {2'h0, column_3_s11_q} : sums_2_columns_values_0_q;
  logic [7:0] select_1303;
  assign select_1303 = equal_342_s11_q ? sums_2_columns_values_0_q : sums_2_columns_values_1_q;
  logic [7:0] select_1304;
  assign select_1304 = equal_342_s11_q ? sums_2_columns_values_1_q : sums_2_columns_values_2_q;
  logic [7:0] select_1305;
  assign select_1305 = equal_342_s11_q ? sums_2_columns_values_2_q : sums_2_columns_values_3_q;
  logic [7:0] select_1306;
  assign select_1306 = equal_342_s11_q ? sums_2_columns_values_3_q : sums_2_columns_values_4_q;
  logic [7:0] select_1307;
  assign select_1307 = equal_342_s11_q ? sums_2_columns_values_4_q : sums_2_columns_values_5_q;
  logic [7:0] select_1308;
  assign select_1308 = equal_342_s11_q ? sums_2_columns_values_5_q : sums_2_columns_values_6_q;
  // hls/stages/agreement.hpp:632
  logic [9:0] select_1421;
  assign select_1421 = best_left_rdata_s11_q[12] ? select_1420_s11_q[9:0] : 10'h0;
  logic [8:0] difference_1423;
  assign difference_1423 = select_1421[9:1] - (best_left_rdata_s11_q[13] ? select_1420_s11_q[8:0] : 9'h0);
  // hls/stages/agreement.hpp:630
  logic [12:0] sum_1426;
  assign sum_1426 = (best_left_rdata_s11_q[8] ? select_1420_s11_q[13:1] : 13'h0) + (best_left_rdata_s11_q[9] ? select_1420_s11_q[12:0] : 13'h0);
  // hls/stages/agreement.hpp:631
  logic [11:0] select_1427;
  assign select_1427 = best_left_rdata_s11_q[10] ? select_1420_s11_q[11:0] : 12'h0;
  logic [10:0] sum_1429;
  assign sum_1429 = select_1427[11:1] + (best_left_rdata_s11_q[11] ? select_1420_s11_q[10:0] : 11'h0);

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_1_columns_values_0_q = 8'h0;
    sums_1_columns_values_1_q = 8'h0;
    sums_1_columns_values_2_q = 8'h0;
    sums_1_columns_values_3_q = 8'h0;
    sums_1_columns_values_4_q = 8'h0;
    sums_1_columns_values_5_q = 8'h0;
    sums_1_columns_values_6_q = 8'h0;
    sums_2_columns_values_0_q = 8'h0;
    sums_2_columns_values_1_q = 8'h0;
    sums_2_columns_values_2_q = 8'h0;
    sums_2_columns_values_3_q = 8'h0;
    sums_2_columns_values_4_q = 8'h0;
    sums_2_columns_values_5_q = 8'h0;
    sums_2_columns_values_6_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s11_en) begin
      sums_1_columns_values_0_q <= select_1294;
      sums_1_columns_values_1_q <= select_1295;
      sums_1_columns_values_2_q <= select_1296;
      sums_1_columns_values_3_q <= select_1297;
      sums_1_columns_values_4_q <= select_1298;
      sums_1_columns_values_5_q <= select_1299;
      sums_1_columns_values_6_q <= select_1300;
      sums_2_columns_values_0_q <= select_1302;
      sums_2_columns_values_1_q <= select_1303;
      sums_2_columns_values_2_q <= select_1304;
      sums_2_columns_values_3_q <= select_1305;
      sums_2_columns_values_4_q <= select_1306;
      sums_2_columns_values_5_q <= select_1307;
      sums_2_columns_values_6_q <= select_1308;
    end
  end

  logic [7:0] pixel_0_s12_q;
  logic [7:0] pixel_1_s12_q;
  logic saturated_s12_q;
  logic mask_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [1:0] age_s12_q;
  logic lower_half_s12_q;
  logic [11:0] slope_s12_q;
  logic equal_296_s12_q;
  logic [6:0] select_298_s12_q;
  logic [8:0] select_302_s12_q;
  logic and_311_s12_q;
  logic equal_316_s12_q;
  logic and_329_s12_q;
  logic and_330_s12_q;
  logic equal_333_s12_q;
  logic equal_342_s12_q;
  logic not_343_s12_q;
  logic equal_344_s12_q;
  logic less_345_s12_q;
  logic not_346_s12_q;
  logic equal_376_s12_q;
  logic drew_s12_q;
  logic [6:0] x_s12_2_q;
  logic not_484_s12_q;
  logic select_486_s12_q;
  logic [21:0] best_left_rdata_s12_q;
  logic equal_489_s12_q;
  logic [7:0] difference_555_s12_q;
  logic equal_556_s12_q;
  logic [7:0] difference_609_s12_q;
  logic [5:0] column_9_s12_q;
  logic [5:0] column_12_s12_q;
  logic [5:0] column_15_s12_q;
  logic equal_793_s12_q;
  logic and_851_s12_q;
  logic equal_857_s12_q;
  logic equal_880_s12_q;
  logic equal_883_s12_q;
  logic and_894_s12_q;
  logic and_924_s12_q;
  logic select_932_s12_q;
  logic and_1029_s12_q;
  logic equal_1143_s12_q;
  logic equal_1194_s12_q;
  logic not_1240_s12_q;
  logic and_1328_s12_q;
  logic less_1410_s12_q;
  logic less_1413_s12_q;
  logic select_1421_s12_q;
  logic [8:0] difference_1423_s12_q;
  logic [11:0] sum_1426_s12_q;
  logic select_1427_s12_q;
  logic [10:0] sum_1429_s12_q;
  logic less_1687_s12_q;
  logic equal_1846_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      age_s12_q <= age_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      slope_s12_q <= slope_s11_q;
      equal_296_s12_q <= equal_296_s11_q;
      select_298_s12_q <= select_298_s11_q;
      select_302_s12_q <= select_302_s11_q;
      and_311_s12_q <= and_311_s11_q;
      equal_316_s12_q <= equal_316_s11_q;
      and_329_s12_q <= and_329_s11_q;
      and_330_s12_q <= and_330_s11_q;
      equal_333_s12_q <= equal_333_s11_q;
      equal_342_s12_q <= equal_342_s11_q;
      not_343_s12_q <= not_343_s11_q;
      equal_344_s12_q <= equal_344_s11_q;
      less_345_s12_q <= less_345_s11_q;
      not_346_s12_q <= not_346_s11_q;
      equal_376_s12_q <= equal_376_s11_q;
      drew_s12_q <= drew_s11_q;
      x_s12_2_q <= x_s11_2_q;
      not_484_s12_q <= not_484_s11_q;
      select_486_s12_q <= select_486_s11_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      equal_489_s12_q <= equal_489_s11_q;
      difference_555_s12_q <= difference_555;
      equal_556_s12_q <= equal_556_s11_q;
      difference_609_s12_q <= difference_609;
      column_9_s12_q <= column_9_s11_q;
      column_12_s12_q <= column_12_s11_q;
      column_15_s12_q <= column_15_s11_q;
      equal_793_s12_q <= equal_793_s11_q;
      and_851_s12_q <= and_851_s11_q;
      equal_857_s12_q <= equal_857_s11_q;
      equal_880_s12_q <= equal_880_s11_q;
      equal_883_s12_q <= equal_883_s11_q;
      and_894_s12_q <= and_894_s11_q;
      and_924_s12_q <= and_924_s11_q;
      select_932_s12_q <= select_932_s11_q;
      and_1029_s12_q <= and_1029_s11_q;
      equal_1143_s12_q <= equal_1143_s11_q;
      equal_1194_s12_q <= equal_1194_s11_q;
      not_1240_s12_q <= not_1240_s11_q;
      and_1328_s12_q <= and_1328_s11_q;
      less_1410_s12_q <= less_1410_s11_q;
      less_1413_s12_q <= less_1413_s11_q;
      select_1421_s12_q <= select_1421[0];
      difference_1423_s12_q <= difference_1423;
      sum_1426_s12_q <= sum_1426[12:1];
      select_1427_s12_q <= select_1427[0];
      sum_1429_s12_q <= sum_1429;
      less_1687_s12_q <= less_1687_s11_q;
      equal_1846_s12_q <= equal_1846_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_columns_values_0_q;
  logic [7:0] sums_0_columns_values_1_q;
  logic [7:0] sums_0_columns_values_2_q;
  logic [7:0] sums_0_columns_values_3_q;
  logic [7:0] sums_0_columns_values_4_q;
  logic [7:0] sums_0_columns_values_5_q;
  logic [7:0] sums_0_columns_values_6_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_2_sum_sums_values_0_q;
  logic [7:0] sums_3_columns_values_0_q;
  logic [7:0] sums_3_columns_values_1_q;
  logic [7:0] sums_3_columns_values_2_q;
  logic [7:0] sums_3_columns_values_3_q;
  logic [7:0] sums_3_columns_values_4_q;
  logic [7:0] sums_3_columns_values_5_q;
  logic [7:0] sums_3_columns_values_6_q;
  logic [7:0] sums_4_columns_values_0_q;
  logic [7:0] sums_4_columns_values_1_q;
  logic [7:0] sums_4_columns_values_2_q;
  logic [7:0] sums_4_columns_values_3_q;
  logic [7:0] sums_4_columns_values_4_q;
  logic [7:0] sums_4_columns_values_5_q;
  logic [7:0] sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:405
  logic [7:0] sum_558;
  assign sum_558 = difference_555_s12_q + (equal_556_s12_q ? 8'h0 : sums_2_sum_sums_values_0_q);
  logic [7:0] sum_611;
  assign sum_611 = difference_609_s12_q + (equal_556_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q);
  logic [7:0] difference_664;
  assign difference_664 = {2'h0, column_9_s12_q} - (age_s12_q[1] ? sums_3_columns_values_6_q : 8'h0);
  logic [7:0] difference_721;
  assign difference_721 = {2'h0, column_12_s12_q} - (age_s12_q[1] ? sums_0_columns_values_6_q : 8'h0);
  logic [7:0] difference_781;
  assign difference_781 = {2'h0, column_15_s12_q} - (age_s12_q[1] ? sums_4_columns_values_6_q : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1286;
  assign select_1286 = equal_342_s12_q ? {2'h0, column_12_s12_q} : sums_0_columns_values_0_q;
  logic [7:0] select_1287;
  assign select_1287 = equal_342_s12_q ? sums_0_columns_values_0_q : sums_0_columns_values_1_q;
  logic [7:0] select_1288;
  assign select_1288 = equal_342_s12_q ? sums_0_columns_values_1_q : sums_0_columns_values_2_q;
  logic [7:0] select_1289;
  assign select_1289 = equal_342_s12_q ? sums_0_columns_values_2_q : sums_0_columns_values_3_q;
  logic [7:0] select_1290;
  assign select_1290 = equal_342_s12_q ? sums_0_columns_values_3_q : sums_0_columns_values_4_q;
  logic [7:0] select_1291;
  assign select_1291 = equal_342_s12_q ? sums_0_columns_values_4_q : sums_0_columns_values_5_q;
  logic [7:0] select_1292;
  assign select_1292 = equal_342_s12_q ? sums_0_columns_values_5_q : sums_0_columns_values_6_q;
  logic [7:0] select_1310;
  assign select_1310 = equal_342_s12_q ? {2'h0, column_9_s12_q} : sums_3_columns_values_0_q;
  logic [7:0] select_1311;
  assign select_1311 = equal_342_s12_q ? sums_3_columns_values_0_q : sums_3_columns_values_1_q;
  logic [7:0] select_1312;
  assign select_1312 = equal_342_s12_q ? sums_3_columns_values_1_q : sums_3_columns_values_2_q;
  logic [7:0] select_1313;
  assign select_1313 = equal_342_s12_q ? sums_3_columns_values_2_q : sums_3_columns_values_3_q;
  logic [7:0] select_1314;
  assign select_1314 = equal_342_s12_q ? sums_3_columns_values_3_q : sums_3_columns_values_4_q;
  logic [7:0] select_1315;
  assign select_1315 = equal_342_s12_q ? sums_3_columns_values_4_q : sums_3_columns_values_5_q;
  logic [7:0] select_1316;
  assign select_1316 = equal_342_s12_q ? sums_3_columns_values_5_q : sums_3_columns_values_6_q;
  logic [7:0] select_1318;
  assign select_1318 = equal_342_s12_q ? {2'h0, column_15_s12_q} : sums_4_columns_values_0_q;
  logic [7:0] select_1319;
  assign select_1319 = equal_342_s12_q ? sums_4_columns_values_0_q : sums_4_columns_values_1_q;
  logic [7:0] select_1320;
  assign select_1320 = equal_342_s12_q ? sums_4_columns_values_1_q : sums_4_columns_values_2_q;
  logic [7:0] select_1321;
  assign select_1321 = equal_342_s12_q ? sums_4_columns_values_2_q : sums_4_columns_values_3_q;
  logic [7:0] select_1322;
  assign select_1322 = equal_342_s12_q ? sums_4_columns_values_3_q : sums_4_columns_values_4_q;
  logic [7:0] select_1323;
  assign select_1323 = equal_342_s12_q ? sums_4_columns_values_4_q : sums_4_columns_values_5_q;
  logic [7:0] select_1324;
  assign select_1324 = equal_342_s12_q ? sums_4_columns_values_5_q : sums_4_columns_values_6_q;
  // hls/stages/agreement.hpp:633
  logic [11:0] sum_1430;
  assign sum_1430 = sum_1426_s12_q + {sum_1429_s12_q, select_1427_s12_q};
  logic [9:0] sum_1431;
  assign sum_1431 = {difference_1423_s12_q, select_1421_s12_q} + sum_1430[11:2];

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
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_2_sum_sums_values_0_q = 8'h0;
    sums_3_columns_values_0_q = 8'h0;
    sums_3_columns_values_1_q = 8'h0;
    sums_3_columns_values_2_q = 8'h0;
    sums_3_columns_values_3_q = 8'h0;
    sums_3_columns_values_4_q = 8'h0;
    sums_3_columns_values_5_q = 8'h0;
    sums_3_columns_values_6_q = 8'h0;
    sums_4_columns_values_0_q = 8'h0;
    sums_4_columns_values_1_q = 8'h0;
    sums_4_columns_values_2_q = 8'h0;
    sums_4_columns_values_3_q = 8'h0;
    sums_4_columns_values_4_q = 8'h0;
    sums_4_columns_values_5_q = 8'h0;
    sums_4_columns_values_6_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s12_en) begin
      sums_0_columns_values_0_q <= select_1286;
      sums_0_columns_values_1_q <= select_1287;
      sums_0_columns_values_2_q <= select_1288;
      sums_0_columns_values_3_q <= select_1289;
      sums_0_columns_values_4_q <= select_1290;
      sums_0_columns_values_5_q <= select_1291;
      sums_0_columns_values_6_q <= select_1292;
      sums_1_sum_sums_values_0_q <= equal_342_s12_q ? sum_611 : sums_1_sum_sums_values_0_q;
      sums_2_sum_sums_values_0_q <= equal_342_s12_q ? sum_558 : sums_2_sum_sums_values_0_q;
      sums_3_columns_values_0_q <= select_1310;
      sums_3_columns_values_1_q <= select_1311;
      sums_3_columns_values_2_q <= select_1312;
      sums_3_columns_values_3_q <= select_1313;
      sums_3_columns_values_4_q <= select_1314;
      sums_3_columns_values_5_q <= select_1315;
      sums_3_columns_values_6_q <= select_1316;
      sums_4_columns_values_0_q <= select_1318;
      sums_4_columns_values_1_q <= select_1319;
      sums_4_columns_values_2_q <= select_1320;
      sums_4_columns_values_3_q <= select_1321;
      sums_4_columns_values_4_q <= select_1322;
      sums_4_columns_values_5_q <= select_1323;
      sums_4_columns_values_6_q <= select_1324;
    end
  end

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic age_s13_q;
  logic lower_half_s13_q;
  logic [11:0] slope_s13_q;
  logic equal_296_s13_q;
  logic [6:0] select_298_s13_q;
  logic [8:0] select_302_s13_q;
  logic and_311_s13_q;
  logic equal_316_s13_q;
  logic and_329_s13_q;
  logic and_330_s13_q;
  logic equal_333_s13_q;
  logic equal_342_s13_q;
  logic not_343_s13_q;
  logic equal_344_s13_q;
  logic less_345_s13_q;
  logic not_346_s13_q;
  logic equal_376_s13_q;
  logic drew_s13_q;
  logic [6:0] x_s13_2_q;
  logic not_484_s13_q;
  logic select_486_s13_q;
  logic [21:0] best_left_rdata_s13_q;
  logic equal_489_s13_q;
  logic equal_556_s13_q;
  logic [7:0] sum_558_s13_q;
  logic [7:0] sum_611_s13_q;
  logic less_612_s13_q;
  logic [7:0] difference_664_s13_q;
  logic [7:0] difference_721_s13_q;
  logic [7:0] difference_781_s13_q;
  logic equal_793_s13_q;
  logic and_851_s13_q;
  logic equal_857_s13_q;
  logic equal_880_s13_q;
  logic equal_883_s13_q;
  logic and_894_s13_q;
  logic and_924_s13_q;
  logic select_932_s13_q;
  logic and_1029_s13_q;
  logic equal_1143_s13_q;
  logic equal_1194_s13_q;
  logic not_1240_s13_q;
  logic and_1328_s13_q;
  logic less_1410_s13_q;
  logic less_1413_s13_q;
  logic [7:0] sum_1431_s13_q;
  logic less_1687_s13_q;
  logic equal_1846_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= age_s12_q[0];
      lower_half_s13_q <= lower_half_s12_q;
      slope_s13_q <= slope_s12_q;
      equal_296_s13_q <= equal_296_s12_q;
      select_298_s13_q <= select_298_s12_q;
      select_302_s13_q <= select_302_s12_q;
      and_311_s13_q <= and_311_s12_q;
      equal_316_s13_q <= equal_316_s12_q;
      and_329_s13_q <= and_329_s12_q;
      and_330_s13_q <= and_330_s12_q;
      equal_333_s13_q <= equal_333_s12_q;
      equal_342_s13_q <= equal_342_s12_q;
      not_343_s13_q <= not_343_s12_q;
      equal_344_s13_q <= equal_344_s12_q;
      less_345_s13_q <= less_345_s12_q;
      not_346_s13_q <= not_346_s12_q;
      equal_376_s13_q <= equal_376_s12_q;
      drew_s13_q <= drew_s12_q;
      x_s13_2_q <= x_s12_2_q;
      not_484_s13_q <= not_484_s12_q;
      select_486_s13_q <= select_486_s12_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      equal_489_s13_q <= equal_489_s12_q;
      equal_556_s13_q <= equal_556_s12_q;
      sum_558_s13_q <= sum_558;
      sum_611_s13_q <= sum_611;
      less_612_s13_q <= sum_558 < sum_611;
      difference_664_s13_q <= difference_664;
      difference_721_s13_q <= difference_721;
      difference_781_s13_q <= difference_781;
      equal_793_s13_q <= equal_793_s12_q;
      and_851_s13_q <= and_851_s12_q;
      equal_857_s13_q <= equal_857_s12_q;
      equal_880_s13_q <= equal_880_s12_q;
      equal_883_s13_q <= equal_883_s12_q;
      and_894_s13_q <= and_894_s12_q;
      and_924_s13_q <= and_924_s12_q;
      select_932_s13_q <= select_932_s12_q;
      and_1029_s13_q <= and_1029_s12_q;
      equal_1143_s13_q <= equal_1143_s12_q;
      equal_1194_s13_q <= equal_1194_s12_q;
      not_1240_s13_q <= not_1240_s12_q;
      and_1328_s13_q <= and_1328_s12_q;
      less_1410_s13_q <= less_1410_s12_q;
      less_1413_s13_q <= less_1413_s12_q;
      sum_1431_s13_q <= sum_1431[9:2];
      less_1687_s13_q <= less_1687_s12_q;
      equal_1846_s13_q <= equal_1846_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_3_sum_sums_values_0_q;
  logic [7:0] sums_4_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:405
  logic [7:0] sum_666;
  assign sum_666 = difference_664_s13_q + (equal_556_s13_q ? 8'h0 : sums_3_sum_sums_values_0_q);
  logic [7:0] sum_723;
  assign sum_723 = difference_721_s13_q + (equal_556_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q);
  logic [7:0] sum_783;
  assign sum_783 = difference_781_s13_q + (equal_556_s13_q ? 8'h0 : sums_4_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:430
  logic [6:0] partner;
  assign partner = {run_shift_s13_q[5], run_shift_s13_q} + x_s13_2_q;
  // hls/stages/agreement.hpp:572
  logic [6:0] sum_853;
  assign sum_853 = x_s13_q[6:0] + {best_left_rdata_s13_q[13], best_left_rdata_s13_q[13:8]};
  // hls/stages/agreement.hpp:605
  logic [12:0] sum_1432;
  assign sum_1432 = {slope_s13_q[11], slope_s13_q} + {{5{sum_1431_s13_q[7]}}, sum_1431_s13_q};

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_3_sum_sums_values_0_q = 8'h0;
    sums_4_sum_sums_values_0_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s13_en) begin
      sums_0_sum_sums_values_0_q <= equal_342_s13_q ? sum_723 : sums_0_sum_sums_values_0_q;
      sums_3_sum_sums_values_0_q <= equal_342_s13_q ? sum_666 : sums_3_sum_sums_values_0_q;
      sums_4_sum_sums_values_0_q <= equal_342_s13_q ? sum_783 : sums_4_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s14_q;
  logic [7:0] pixel_1_s14_q;
  logic saturated_s14_q;
  logic mask_s14_q;
  logic marks_first_s14_q;
  logic marks_last_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic age_s14_q;
  logic lower_half_s14_q;
  logic equal_296_s14_q;
  logic [6:0] select_298_s14_q;
  logic [8:0] select_302_s14_q;
  logic and_311_s14_q;
  logic equal_316_s14_q;
  logic and_329_s14_q;
  logic and_330_s14_q;
  logic equal_333_s14_q;
  logic equal_342_s14_q;
  logic not_343_s14_q;
  logic equal_344_s14_q;
  logic less_345_s14_q;
  logic not_346_s14_q;
  logic equal_376_s14_q;
  logic drew_s14_q;
  logic [6:0] x_s14_2_q;
  logic not_484_s14_q;
  logic select_486_s14_q;
  logic [21:0] best_left_rdata_s14_q;
  logic equal_489_s14_q;
  logic [7:0] sum_558_s14_q;
  logic [7:0] sum_611_s14_q;
  logic less_612_s14_q;
  logic [7:0] sum_666_s14_q;
  logic less_667_s14_q;
  logic [7:0] sum_723_s14_q;
  logic [7:0] sum_783_s14_q;
  logic equal_793_s14_q;
  logic and_851_s14_q;
  logic [6:0] partner_s14_q;
  logic [6:0] select_854_s14_q;
  logic equal_857_s14_q;
  logic equal_880_s14_q;
  logic equal_883_s14_q;
  logic and_894_s14_q;
  logic and_924_s14_q;
  logic select_932_s14_q;
  logic and_1029_s14_q;
  logic equal_1143_s14_q;
  logic equal_1194_s14_q;
  logic not_1240_s14_q;
  logic and_1328_s14_q;
  logic less_1410_s14_q;
  logic less_1413_s14_q;
  logic [7:0] sum_1432_s14_q;
  logic less_1433_s14_q;
  logic less_1434_s14_q;
  logic less_1687_s14_q;
  logic equal_1846_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      pixel_0_s14_q <= pixel_0_s13_q;
      pixel_1_s14_q <= pixel_1_s13_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      equal_296_s14_q <= equal_296_s13_q;
      select_298_s14_q <= select_298_s13_q;
      select_302_s14_q <= select_302_s13_q;
      and_311_s14_q <= and_311_s13_q;
      equal_316_s14_q <= equal_316_s13_q;
      and_329_s14_q <= and_329_s13_q;
      and_330_s14_q <= and_330_s13_q;
      equal_333_s14_q <= equal_333_s13_q;
      equal_342_s14_q <= equal_342_s13_q;
      not_343_s14_q <= not_343_s13_q;
      equal_344_s14_q <= equal_344_s13_q;
      less_345_s14_q <= less_345_s13_q;
      not_346_s14_q <= not_346_s13_q;
      equal_376_s14_q <= equal_376_s13_q;
      drew_s14_q <= drew_s13_q;
      x_s14_2_q <= x_s13_2_q;
      not_484_s14_q <= not_484_s13_q;
      select_486_s14_q <= select_486_s13_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      equal_489_s14_q <= equal_489_s13_q;
      sum_558_s14_q <= sum_558_s13_q;
      sum_611_s14_q <= sum_611_s13_q;
      less_612_s14_q <= less_612_s13_q;
      sum_666_s14_q <= sum_666;
      less_667_s14_q <= (less_612_s13_q ? sum_611_s13_q : sum_558_s13_q) < sum_666;
      sum_723_s14_q <= sum_723;
      sum_783_s14_q <= sum_783;
      equal_793_s14_q <= equal_793_s13_q;
      and_851_s14_q <= and_851_s13_q;
      partner_s14_q <= partner;
      select_854_s14_q <= equal_342_s13_q ? partner : sum_853;
      equal_857_s14_q <= equal_857_s13_q;
      equal_880_s14_q <= equal_880_s13_q;
      equal_883_s14_q <= equal_883_s13_q;
      and_894_s14_q <= and_894_s13_q;
      and_924_s14_q <= and_924_s13_q;
      select_932_s14_q <= select_932_s13_q;
      and_1029_s14_q <= and_1029_s13_q;
      equal_1143_s14_q <= equal_1143_s13_q;
      equal_1194_s14_q <= equal_1194_s13_q;
      not_1240_s14_q <= not_1240_s13_q;
      and_1328_s14_q <= and_1328_s13_q;
      less_1410_s14_q <= less_1410_s13_q;
      less_1413_s14_q <= less_1413_s13_q;
      sum_1432_s14_q <= sum_1432[7:0];
      less_1433_s14_q <= $signed(6'h0) < $signed(sum_1432[12:7]);
      less_1434_s14_q <= $signed(sum_1432[12:7]) < $signed(6'h3f);
      less_1687_s14_q <= less_1687_s13_q;
      equal_1846_s14_q <= equal_1846_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:418
  logic not_668;
  assign not_668 = ~less_612_s14_q;
  logic [1:0] best;
  assign best = less_667_s14_q ? 2'h3 : {not_668, less_612_s14_q};
  logic [7:0] select_725;
  assign select_725 = best[1] ? (best[0] ? sum_666_s14_q : sum_558_s14_q) : (best[0] ? sum_611_s14_q : sum_723_s14_q);
  // hls/stages/agreement.hpp:630
  logic [7:0] slope;
  assign slope = less_1433_s14_q ? 8'h7f : (less_1434_s14_q ? 8'h80 : sum_1432_s14_q);
  logic [6:0] select_1437;
  assign select_1437 = best_left_rdata_s14_q[8] ? slope[7:1] : 7'h0;
  logic [7:0] select_1438;
  assign select_1438 = best_left_rdata_s14_q[9] ? slope : 8'h0;
  logic [8:0] sum_1439;
  assign sum_1439 = {{2{select_1437[6]}}, select_1437} + {select_1438[7], select_1438};
  // hls/stages/agreement.hpp:631
  logic [7:0] select_1440;
  assign select_1440 = best_left_rdata_s14_q[10] ? slope : 8'h0;
  logic [7:0] select_1441;
  assign select_1441 = best_left_rdata_s14_q[11] ? slope : 8'h0;
  logic [8:0] sum_1442;
  assign sum_1442 = {{2{select_1440[7]}}, select_1440[7:1]} + {select_1441[7], select_1441};
  // hls/stages/agreement.hpp:632
  logic [7:0] select_1444;
  assign select_1444 = best_left_rdata_s14_q[12] ? slope : 8'h0;
  logic [7:0] select_1445;
  assign select_1445 = best_left_rdata_s14_q[13] ? slope : 8'h0;
  logic [8:0] difference_1446;
  assign difference_1446 = {{2{select_1444[7]}}, select_1444[7:1]} - {select_1445[7], select_1445};

  // Memory best_right, 120 x 15, DISTANCE 32, hls/stages/agreement.hpp:889; read in stage 14, written in stage 19: 14 < 19 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 15'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = select_854_s14_q;
  logic best_right_re;
  assign best_right_re = s14_en & select_486_s14_q;
  logic [14:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic mask_s15_q;
  logic marks_first_s15_q;
  logic marks_last_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic lower_half_s15_q;
  logic equal_296_s15_q;
  logic [6:0] select_298_s15_q;
  logic [8:0] select_302_s15_q;
  logic and_311_s15_q;
  logic equal_316_s15_q;
  logic and_329_s15_q;
  logic and_330_s15_q;
  logic equal_333_s15_q;
  logic equal_342_s15_q;
  logic not_343_s15_q;
  logic equal_344_s15_q;
  logic less_345_s15_q;
  logic not_346_s15_q;
  logic equal_376_s15_q;
  logic drew_s15_q;
  logic [6:0] x_s15_2_q;
  logic not_484_s15_q;
  logic [21:0] best_left_rdata_s15_q;
  logic equal_489_s15_q;
  logic [7:0] sum_558_s15_q;
  logic [7:0] sum_611_s15_q;
  logic [7:0] sum_666_s15_q;
  logic [1:0] best_s15_q;
  logic [7:0] sum_723_s15_q;
  logic less_726_s15_q;
  logic [7:0] sum_783_s15_q;
  logic equal_793_s15_q;
  logic and_851_s15_q;
  logic [6:0] partner_s15_q;
  logic equal_857_s15_q;
  logic equal_880_s15_q;
  logic equal_883_s15_q;
  logic and_894_s15_q;
  logic and_924_s15_q;
  logic select_932_s15_q;
  logic and_1029_s15_q;
  logic equal_1143_s15_q;
  logic equal_1194_s15_q;
  logic not_1240_s15_q;
  logic and_1328_s15_q;
  logic less_1410_s15_q;
  logic less_1413_s15_q;
  logic [7:0] sum_1439_s15_q;
  logic select_1440_s15_q;
  logic [8:0] sum_1442_s15_q;
  logic select_1444_s15_q;
  logic [8:0] difference_1446_s15_q;
  logic less_1687_s15_q;
  logic equal_1846_s15_q;
  always_ff @(posedge clk_i) begin
    if (s14_en) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      equal_296_s15_q <= equal_296_s14_q;
      select_298_s15_q <= select_298_s14_q;
      select_302_s15_q <= select_302_s14_q;
      and_311_s15_q <= and_311_s14_q;
      equal_316_s15_q <= equal_316_s14_q;
      and_329_s15_q <= and_329_s14_q;
      and_330_s15_q <= and_330_s14_q;
      equal_333_s15_q <= equal_333_s14_q;
      equal_342_s15_q <= equal_342_s14_q;
      not_343_s15_q <= not_343_s14_q;
      equal_344_s15_q <= equal_344_s14_q;
      less_345_s15_q <= less_345_s14_q;
      not_346_s15_q <= not_346_s14_q;
      equal_376_s15_q <= equal_376_s14_q;
      drew_s15_q <= drew_s14_q;
      x_s15_2_q <= x_s14_2_q;
      not_484_s15_q <= not_484_s14_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      equal_489_s15_q <= equal_489_s14_q;
      sum_558_s15_q <= sum_558_s14_q;
      sum_611_s15_q <= sum_611_s14_q;
      sum_666_s15_q <= sum_666_s14_q;
      best_s15_q <= best;
      sum_723_s15_q <= sum_723_s14_q;
      less_726_s15_q <= select_725 < sum_723_s14_q;
      sum_783_s15_q <= sum_783_s14_q;
      equal_793_s15_q <= equal_793_s14_q;
      and_851_s15_q <= and_851_s14_q;
      partner_s15_q <= partner_s14_q;
      equal_857_s15_q <= equal_857_s14_q;
      equal_880_s15_q <= equal_880_s14_q;
      equal_883_s15_q <= equal_883_s14_q;
      and_894_s15_q <= and_894_s14_q;
      and_924_s15_q <= and_924_s14_q;
      select_932_s15_q <= select_932_s14_q;
      and_1029_s15_q <= and_1029_s14_q;
      equal_1143_s15_q <= equal_1143_s14_q;
      equal_1194_s15_q <= equal_1194_s14_q;
      not_1240_s15_q <= not_1240_s14_q;
      and_1328_s15_q <= and_1328_s14_q;
      less_1410_s15_q <= less_1410_s14_q;
      less_1413_s15_q <= less_1413_s14_q;
      sum_1439_s15_q <= sum_1439[8:1];
      select_1440_s15_q <= select_1440[0];
      sum_1442_s15_q <= sum_1442;
      select_1444_s15_q <= select_1444[0];
      difference_1446_s15_q <= difference_1446;
      less_1687_s15_q <= less_1687_s14_q;
      equal_1846_s15_q <= equal_1846_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:418
  logic [1:0] best_2;
  assign best_2 = less_726_s15_q ? 2'h0 : best_s15_q;
  logic [7:0] select_730;
  assign select_730 = best_2[1] ? (best_2[0] ? sum_666_s15_q : sum_558_s15_q) : (best_2[0] ? sum_611_s15_q : sum_723_s15_q);
  // hls/stages/agreement.hpp:633
  logic [10:0] sum_1443;
  assign sum_1443 = {{3{sum_1439_s15_q[7]}}, sum_1439_s15_q} + {sum_1442_s15_q[8], sum_1442_s15_q, select_1440_s15_q};
  logic [9:0] sum_1447;
  assign sum_1447 = {difference_1446_s15_q, select_1444_s15_q} + {sum_1443[10], sum_1443[10:2]};

  // Memory averager_memory, 480 x 29, DISTANCE 16, hls/stages/census.hpp:139; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 29'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_302_s15_q;
  logic averager_memory_re;
  assign averager_memory_re = s15_en & and_311_s15_q;
  logic [28:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic mask_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic [5:0] run_shift_s16_q;
  logic [7:0] x_s16_q;
  logic age_s16_q;
  logic lower_half_s16_q;
  logic equal_296_s16_q;
  logic [6:0] select_298_s16_q;
  logic [8:0] select_302_s16_q;
  logic and_311_s16_q;
  logic equal_316_s16_q;
  logic and_329_s16_q;
  logic and_330_s16_q;
  logic equal_333_s16_q;
  logic equal_342_s16_q;
  logic not_343_s16_q;
  logic equal_344_s16_q;
  logic less_345_s16_q;
  logic not_346_s16_q;
  logic equal_376_s16_q;
  logic drew_s16_q;
  logic [6:0] x_s16_2_q;
  logic not_484_s16_q;
  logic [21:0] best_left_rdata_s16_q;
  logic equal_489_s16_q;
  logic [7:0] sum_558_s16_q;
  logic [7:0] sum_611_s16_q;
  logic [7:0] sum_666_s16_q;
  logic [7:0] sum_723_s16_q;
  logic [1:0] best_2_s16_q;
  logic [7:0] sum_783_s16_q;
  logic less_784_s16_q;
  logic equal_793_s16_q;
  logic and_851_s16_q;
  logic [6:0] partner_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic equal_857_s16_q;
  logic equal_880_s16_q;
  logic equal_883_s16_q;
  logic and_894_s16_q;
  logic and_924_s16_q;
  logic select_932_s16_q;
  logic and_1029_s16_q;
  logic equal_1143_s16_q;
  logic equal_1194_s16_q;
  logic not_1240_s16_q;
  logic and_1328_s16_q;
  logic less_1410_s16_q;
  logic less_1413_s16_q;
  logic sum_1443_s16_q;
  logic [9:0] sum_1447_s16_q;
  logic less_1687_s16_q;
  logic equal_1846_s16_q;
  always_ff @(posedge clk_i) begin
    if (s15_en) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      equal_296_s16_q <= equal_296_s15_q;
      select_298_s16_q <= select_298_s15_q;
      select_302_s16_q <= select_302_s15_q;
      and_311_s16_q <= and_311_s15_q;
      equal_316_s16_q <= equal_316_s15_q;
      and_329_s16_q <= and_329_s15_q;
      and_330_s16_q <= and_330_s15_q;
      equal_333_s16_q <= equal_333_s15_q;
      equal_342_s16_q <= equal_342_s15_q;
      not_343_s16_q <= not_343_s15_q;
      equal_344_s16_q <= equal_344_s15_q;
      less_345_s16_q <= less_345_s15_q;
      not_346_s16_q <= not_346_s15_q;
      equal_376_s16_q <= equal_376_s15_q;
      drew_s16_q <= drew_s15_q;
      x_s16_2_q <= x_s15_2_q;
      not_484_s16_q <= not_484_s15_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      equal_489_s16_q <= equal_489_s15_q;
      sum_558_s16_q <= sum_558_s15_q;
      sum_611_s16_q <= sum_611_s15_q;
      sum_666_s16_q <= sum_666_s15_q;
      sum_723_s16_q <= sum_723_s15_q;
      best_2_s16_q <= best_2;
      sum_783_s16_q <= sum_783_s15_q;
      less_784_s16_q <= select_730 < sum_783_s15_q;
      equal_793_s16_q <= equal_793_s15_q;
      and_851_s16_q <= and_851_s15_q;
      partner_s16_q <= partner_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_q;
      equal_857_s16_q <= equal_857_s15_q;
      equal_880_s16_q <= equal_880_s15_q;
      equal_883_s16_q <= equal_883_s15_q;
      and_894_s16_q <= and_894_s15_q;
      and_924_s16_q <= and_924_s15_q;
      select_932_s16_q <= select_932_s15_q;
      and_1029_s16_q <= and_1029_s15_q;
      equal_1143_s16_q <= equal_1143_s15_q;
      equal_1194_s16_q <= equal_1194_s15_q;
      not_1240_s16_q <= not_1240_s15_q;
      and_1328_s16_q <= and_1328_s15_q;
      less_1410_s16_q <= less_1410_s15_q;
      less_1413_s16_q <= less_1413_s15_q;
      sum_1443_s16_q <= sum_1443[1];
      sum_1447_s16_q <= sum_1447;
      less_1687_s16_q <= less_1687_s15_q;
      equal_1846_s16_q <= equal_1846_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic averager_running_mask_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:90
  logic [13:0] select_314;
  assign select_314 = equal_296_s16_q ? {6'h0, pixel_0_s16_q} : ({6'h0, pixel_0_s16_q} + averager_running_0_q);
  logic [13:0] sum_320;
  assign sum_320 = {6'h0, pixel_1_s16_q} + (equal_296_s16_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:171
  logic whole;
  assign whole = equal_296_s16_q ? mask_s16_q : (mask_s16_q & averager_running_mask_q);
  // hls/stages/agreement.hpp:410
  logic less_490;
  assign less_490 = $signed(run_shift_s16_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_492;
  assign less_492 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s16_q);
  // hls/stages/agreement.hpp:418
  logic [1:0] select_785;
  assign select_785 = less_784_s16_q ? 2'h0 : best_2_s16_q;
  // hls/stages/agreement.hpp:420
  logic [7:0] select_788;
  assign select_788 = select_785[1] ? (select_785[0] ? sum_666_s16_q : sum_558_s16_q) : (select_785[0] ? sum_611_s16_q : sum_723_s16_q);
  logic [7:0] of_best;
  assign of_best = less_784_s16_q ? sum_783_s16_q : select_788;
  logic [7:0] of_best_2;
  assign of_best_2 = ((~less_490) & (~less_492)) ? of_best : 8'h0;
  // hls/stages/agreement.hpp:438
  logic [2:0] select_805;
  assign select_805 = ({less_784_s16_q, select_785} == 3'h0) ? 3'h1 : {less_784_s16_q, select_785};
  logic [2:0] near_best;
  assign near_best = ({less_784_s16_q, select_785} == 3'h4) ? 3'h3 : select_805;
  // hls/stages/agreement.hpp:461
  logic [5:0] sum_878;
  assign sum_878 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:574
  logic [8:0] way;
  assign way = {2'h0, best_right_rdata_s16_q[14:8]} - {1'b0, x_s16_q};
  // hls/stages/agreement.hpp:607
  logic [11:0] difference_1448;
  assign difference_1448 = {{4{best_left_rdata_s16_q[21]}}, best_left_rdata_s16_q[21:14]} - {sum_1447_s16_q[9], sum_1447_s16_q, sum_1443_s16_q};
  // hls/stages/agreement.hpp:478
  logic [8:0] sum_1697;
  assign sum_1697 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/agreement.hpp:479
  logic [8:0] select_1698;
  assign select_1698 = sum_878[5] ? {1'b1, sum_878[4:0], region_across_rest_q[2:0]} : sum_1697;
  // hls/stages/agreement.hpp:243
  logic [8:0] select_1702;
  assign select_1702 = equal_1194_s16_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_1705;
  assign select_1705 = equal_1194_s16_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_running_mask_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s16_en) begin
      averager_running_mask_q <= whole;
      region_across_rest_q <= drew_s16_q ? select_1698 : columns_begin_rest_q;
      region_across_back_q <= drew_s16_q ? region_across_back_q : columns_begin_back_q;
      columns_begin_rest_q <= and_330_s16_q ? select_1702 : columns_begin_rest_q;
      columns_begin_back_q <= and_330_s16_q ? select_1705 : columns_begin_back_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_running_0_q = 14'h0;
    averager_running_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s16_en) begin
      averager_running_0_q <= select_314;
      averager_running_1_q <= sum_320;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic [5:0] run_shift_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic lower_half_s17_q;
  logic [6:0] select_298_s17_q;
  logic [8:0] select_302_s17_q;
  logic and_311_s17_q;
  logic [28:0] averager_memory_rdata_s17_q;
  logic equal_316_s17_q;
  logic and_329_s17_q;
  logic and_330_s17_q;
  logic equal_333_s17_q;
  logic equal_342_s17_q;
  logic not_343_s17_q;
  logic equal_344_s17_q;
  logic less_345_s17_q;
  logic not_346_s17_q;
  logic equal_376_s17_q;
  logic drew_s17_q;
  logic [6:0] x_s17_2_q;
  logic not_484_s17_q;
  logic [21:0] best_left_rdata_s17_q;
  logic equal_489_s17_q;
  logic [7:0] sum_558_s17_q;
  logic [7:0] sum_611_s17_q;
  logic [7:0] sum_666_s17_q;
  logic [7:0] sum_723_s17_q;
  logic [7:0] sum_783_s17_q;
  logic less_784_s17_q;
  logic [1:0] select_785_s17_q;
  logic [7:0] of_best_2_s17_q;
  logic equal_793_s17_q;
  logic [2:0] near_best_s17_q;
  logic and_851_s17_q;
  logic [6:0] partner_s17_q;
  logic [14:0] best_right_rdata_s17_q;
  logic equal_857_s17_q;
  logic sum_878_s17_q;
  logic equal_880_s17_q;
  logic equal_883_s17_q;
  logic and_894_s17_q;
  logic [8:0] way_s17_q;
  logic and_924_s17_q;
  logic select_932_s17_q;
  logic and_1029_s17_q;
  logic equal_1143_s17_q;
  logic equal_1194_s17_q;
  logic not_1240_s17_q;
  logic and_1328_s17_q;
  logic less_1410_s17_q;
  logic less_1413_s17_q;
  logic [11:0] difference_1448_s17_q;
  logic less_1687_s17_q;
  logic equal_1846_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      run_shift_s17_q <= run_shift_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      select_298_s17_q <= select_298_s16_q;
      select_302_s17_q <= select_302_s16_q;
      and_311_s17_q <= and_311_s16_q;
      averager_memory_rdata_s17_q <= averager_memory_rdata_q;
      equal_316_s17_q <= equal_316_s16_q;
      and_329_s17_q <= and_329_s16_q;
      and_330_s17_q <= and_330_s16_q;
      equal_333_s17_q <= equal_333_s16_q;
      equal_342_s17_q <= equal_342_s16_q;
      not_343_s17_q <= not_343_s16_q;
      equal_344_s17_q <= equal_344_s16_q;
      less_345_s17_q <= less_345_s16_q;
      not_346_s17_q <= not_346_s16_q;
      equal_376_s17_q <= equal_376_s16_q;
      drew_s17_q <= drew_s16_q;
      x_s17_2_q <= x_s16_2_q;
      not_484_s17_q <= not_484_s16_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      equal_489_s17_q <= equal_489_s16_q;
      sum_558_s17_q <= sum_558_s16_q;
      sum_611_s17_q <= sum_611_s16_q;
      sum_666_s17_q <= sum_666_s16_q;
      sum_723_s17_q <= sum_723_s16_q;
      sum_783_s17_q <= sum_783_s16_q;
      less_784_s17_q <= less_784_s16_q;
      select_785_s17_q <= select_785;
      of_best_2_s17_q <= of_best_2;
      equal_793_s17_q <= equal_793_s16_q;
      near_best_s17_q <= near_best;
      and_851_s17_q <= and_851_s16_q;
      partner_s17_q <= partner_s16_q;
      best_right_rdata_s17_q <= best_right_rdata_s16_q;
      equal_857_s17_q <= equal_857_s16_q;
      sum_878_s17_q <= sum_878[5];
      equal_880_s17_q <= equal_880_s16_q;
      equal_883_s17_q <= equal_883_s16_q;
      and_894_s17_q <= and_894_s16_q;
      way_s17_q <= way;
      and_924_s17_q <= and_924_s16_q;
      select_932_s17_q <= select_932_s16_q;
      and_1029_s17_q <= and_1029_s16_q;
      equal_1143_s17_q <= equal_1143_s16_q;
      equal_1194_s17_q <= equal_1194_s16_q;
      not_1240_s17_q <= not_1240_s16_q;
      and_1328_s17_q <= and_1328_s16_q;
      less_1410_s17_q <= less_1410_s16_q;
      less_1413_s17_q <= less_1413_s16_q;
      difference_1448_s17_q <= difference_1448;
      less_1687_s17_q <= less_1687_s16_q;
      equal_1846_s17_q <= equal_1846_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:98
  logic [13:0] sum_318;
  assign sum_318 = averager_running_0_q + (equal_316_s17_q ? 14'h0 : averager_memory_rdata_s17_q[13:0]);
  logic [13:0] sum_322;
  assign sum_322 = averager_running_1_q + (equal_316_s17_q ? 14'h0 : averager_memory_rdata_s17_q[27:14]);
  // hls/stages/census.hpp:99
  logic and_326;
  assign and_326 = averager_running_mask_q & (averager_memory_rdata_s17_q[28] | equal_316_s17_q);
  // hls/stages/agreement.hpp:425
  logic less_792;
  assign less_792 = best_left_rdata_s17_q[7:0] < of_best_2_s17_q;
  // hls/stages/agreement.hpp:439
  logic [2:0] sum_808;
  assign sum_808 = near_best_s17_q + 3'h1;
  logic [7:0] select_811;
  assign select_811 = sum_808[1] ? (sum_808[0] ? sum_666_s17_q : sum_558_s17_q) : (sum_808[0] ? sum_611_s17_q : sum_723_s17_q);
  logic [2:0] sum_813;
  assign sum_813 = near_best_s17_q + 3'h7;
  logic [7:0] select_816;
  assign select_816 = sum_813[1] ? (sum_813[0] ? sum_666_s17_q : sum_558_s17_q) : (sum_813[0] ? sum_611_s17_q : sum_723_s17_q);
  // hls/stages/agreement.hpp:440
  logic [7:0] select_822;
  assign select_822 = near_best_s17_q[1] ? (near_best_s17_q[0] ? sum_666_s17_q : sum_558_s17_q) : (near_best_s17_q[0] ? sum_611_s17_q : sum_723_s17_q);
  // hls/stages/agreement.hpp:432
  logic less_856;
  assign less_856 = best_right_rdata_s17_q[7:0] < of_best_2_s17_q;
  // hls/stages/agreement.hpp:134
  logic [7:0] select_867;
  assign select_867 = drew_s17_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:646
  logic or_870;
  assign or_870 = select_867[7] | (~({select_867[5], select_867[3], select_867[1]} == 3'h0));
  // hls/stages/agreement.hpp:654
  logic or_881;
  assign or_881 = (~sum_878_s17_q) | equal_880_s17_q;
  // hls/stages/agreement.hpp:583
  logic and_882;
  assign and_882 = not_346_s17_q & or_881;
  // hls/stages/agreement.hpp:714
  logic equal_884;
  assign equal_884 = x_s17_q[5:4] == 2'h3;
  // hls/stages/agreement.hpp:298
  logic and_886;
  assign and_886 = equal_883_s17_q & (~equal_884);
  logic and_889;
  assign and_889 = not_343_s17_q & (not_484_s17_q & (drew_s17_q ? and_882 : and_886));
  // hls/stages/agreement.hpp:576
  logic [9:0] sum_903;
  assign sum_903 = {way_s17_q[8], way_s17_q} + 10'h1;
  // hls/stages/agreement.hpp:578
  logic and_913;
  assign and_913 = cfg_nearer_above_i & ($signed(6'h0) < $signed(best_left_rdata_s17_q[13:8]));
  // hls/stages/agreement.hpp:583
  logic [7:0] select_973;
  assign select_973 = less_345_s17_q ? select_867 : (sum_878_s17_q ? select_867 : {select_867[6:0], 1'b0});
  // hls/stages/agreement.hpp:646
  logic or_976;
  assign or_976 = select_973[7] | (~({select_973[5], select_973[3], select_973[1]} == 3'h0));
  // hls/stages/agreement.hpp:637
  logic [11:0] select_1450;
  assign select_1450 = ($signed(difference_1448_s17_q[11:7]) < $signed(5'h1f)) ? 12'hf80 : difference_1448_s17_q;
  // hls/stages/agreement.hpp:477
  logic [7:0] sum_1688;
  assign sum_1688 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1696;
  assign select_1696 = equal_342_s17_q ? select_867 : (equal_344_s17_q ? select_867 : (drew_s17_q ? select_973 : 8'h1));
  // hls/stages/agreement.hpp:243
  logic [8:0] select_1709;
  assign select_1709 = equal_376_s17_q ? {difference_1707[7], difference_1707} : (less_1687_s17_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1711;
  assign select_1711 = and_330_s17_q ? (equal_1194_s17_q ? select_1709 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:243
  logic [7:0] select_1713;
  assign select_1713 = equal_376_s17_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1715;
  assign select_1715 = and_330_s17_q ? (equal_1194_s17_q ? select_1713 : region_down_back_q) : region_down_back_q;
  // hls/stages/agreement.hpp:479
  logic [8:0] select_1717;
  assign select_1717 = sum_1688[7] ? {1'b1, sum_1688[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 76, DISTANCE 16, hls/stages/census.hpp:244; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [75:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 76'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = select_298_s17_q;
  logic census_memory_re;
  assign census_memory_re = s17_en & and_330_s17_q;
  logic [75:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory seen_columns, 120 x 12, DISTANCE 32, hls/stages/agreement.hpp:918; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [11:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 12'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s17_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s17_en & and_924_s17_q;
  logic [11:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s17_en) begin
      region_columns_q <= select_1696;
      region_down_rest_q <= select_1711;
      region_down_back_q <= select_1715;
      region_down_next_q <= select_1717;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic [5:0] run_shift_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic lower_half_s18_q;
  logic [6:0] select_298_s18_q;
  logic [8:0] select_302_s18_q;
  logic and_311_s18_q;
  logic [13:0] sum_318_s18_q;
  logic [13:0] sum_322_s18_q;
  logic and_326_s18_q;
  logic and_329_s18_q;
  logic and_330_s18_q;
  logic equal_333_s18_q;
  logic equal_342_s18_q;
  logic not_343_s18_q;
  logic equal_344_s18_q;
  logic less_345_s18_q;
  logic not_346_s18_q;
  logic equal_376_s18_q;
  logic drew_s18_q;
  logic [6:0] x_s18_2_q;
  logic not_484_s18_q;
  logic [21:0] best_left_rdata_s18_q;
  logic equal_489_s18_q;
  logic select_785_s18_q;
  logic [7:0] of_best_2_s18_q;
  logic less_792_s18_q;
  logic or_794_s18_q;
  logic equal_807_s18_q;
  logic [7:0] select_812_s18_q;
  logic [7:0] select_817_s18_q;
  logic [1:0] sum_819_s18_q;
  logic [7:0] select_823_s18_q;
  logic and_851_s18_q;
  logic [6:0] partner_s18_q;
  logic [14:0] best_right_rdata_s18_q;
  logic less_856_s18_q;
  logic or_858_s18_q;
  logic or_870_s18_q;
  logic or_873_s18_q;
  logic or_876_s18_q;
  logic equal_883_s18_q;
  logic equal_884_s18_q;
  logic and_889_s18_q;
  logic and_894_s18_q;
  logic and_901_s18_q;
  logic less_904_s18_q;
  logic and_913_s18_q;
  logic and_923_s18_q;
  logic and_924_s18_q;
  logic select_932_s18_q;
  logic or_976_s18_q;
  logic or_979_s18_q;
  logic or_982_s18_q;
  logic and_1029_s18_q;
  logic equal_1143_s18_q;
  logic equal_1194_s18_q;
  logic not_1240_s18_q;
  logic and_1328_s18_q;
  logic less_1410_s18_q;
  logic less_1413_s18_q;
  logic [11:0] select_1450_s18_q;
  logic less_1451_s18_q;
  logic less_1687_s18_q;
  logic sum_1688_s18_q;
  logic select_1728_s18_q;
  logic equal_1846_s18_q;
  logic and_2124_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      run_shift_s18_q <= run_shift_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      select_298_s18_q <= select_298_s17_q;
      select_302_s18_q <= select_302_s17_q;
      and_311_s18_q <= and_311_s17_q;
      sum_318_s18_q <= sum_318;
      sum_322_s18_q <= sum_322;
      and_326_s18_q <= and_326;
      and_329_s18_q <= and_329_s17_q;
      and_330_s18_q <= and_330_s17_q;
      equal_333_s18_q <= equal_333_s17_q;
      equal_342_s18_q <= equal_342_s17_q;
      not_343_s18_q <= not_343_s17_q;
      equal_344_s18_q <= equal_344_s17_q;
      less_345_s18_q <= less_345_s17_q;
      not_346_s18_q <= not_346_s17_q;
      equal_376_s18_q <= equal_376_s17_q;
      drew_s18_q <= drew_s17_q;
      x_s18_2_q <= x_s17_2_q;
      not_484_s18_q <= not_484_s17_q;
      best_left_rdata_s18_q <= best_left_rdata_s17_q;
      equal_489_s18_q <= equal_489_s17_q;
      select_785_s18_q <= select_785_s17_q[0];
      of_best_2_s18_q <= of_best_2_s17_q;
      less_792_s18_q <= less_792;
      or_794_s18_q <= less_792 | equal_793_s17_q;
      equal_807_s18_q <= {less_784_s17_q, select_785_s17_q} == near_best_s17_q;
      select_812_s18_q <= sum_808[2] ? sum_783_s17_q : select_811;
      select_817_s18_q <= sum_813[2] ? sum_783_s17_q : select_816;
      sum_819_s18_q <= {less_784_s17_q, select_785_s17_q[1]} + 2'h3;
      select_823_s18_q <= near_best_s17_q[2] ? sum_783_s17_q : select_822;
      and_851_s18_q <= and_851_s17_q;
      partner_s18_q <= partner_s17_q;
      best_right_rdata_s18_q <= best_right_rdata_s17_q;
      less_856_s18_q <= less_856;
      or_858_s18_q <= less_856 | equal_857_s17_q;
      or_870_s18_q <= or_870;
      or_873_s18_q <= select_867[7] | (~({select_867[6], select_867[3:2]} == 3'h0));
      or_876_s18_q <= select_867[7] | (~(select_867[6:4] == 3'h0));
      equal_883_s18_q <= equal_883_s17_q;
      equal_884_s18_q <= equal_884;
      and_889_s18_q <= and_889;
      and_894_s18_q <= and_894_s17_q;
      and_901_s18_q <= and_894_s17_q & (8'hb6 < best_left_rdata_s17_q[7:0]);
      less_904_s18_q <= {{6{sum_903[9]}}, sum_903} < 16'h3;
      and_913_s18_q <= and_913;
      and_923_s18_q <= not_343_s17_q & (not_484_s17_q & (drew_s17_q & and_882));
      and_924_s18_q <= and_924_s17_q;
      select_932_s18_q <= select_932_s17_q;
      or_976_s18_q <= or_976;
      or_979_s18_q <= select_973[7] | (~({select_973[6], select_973[3:2]} == 3'h0));
      or_982_s18_q <= select_973[7] | (~(select_973[6:4] == 3'h0));
      and_1029_s18_q <= and_1029_s17_q;
      equal_1143_s18_q <= equal_1143_s17_q;
      equal_1194_s18_q <= equal_1194_s17_q;
      not_1240_s18_q <= not_1240_s17_q;
      and_1328_s18_q <= and_1328_s17_q;
      less_1410_s18_q <= less_1410_s17_q;
      less_1413_s18_q <= less_1413_s17_q;
      select_1450_s18_q <= select_1450;
      less_1451_s18_q <= $signed(5'h0) < $signed(select_1450[11:7]);
      less_1687_s18_q <= less_1687_s17_q;
      sum_1688_s18_q <= sum_1688[7];
      select_1728_s18_q <= sum_878_s17_q ? (equal_880_s17_q & or_881) : or_881;
      equal_1846_s18_q <= equal_1846_s17_q;
      and_2124_s18_q <= not_343_s17_q & (not_484_s17_q & (not_1240_s17_q & and_886));
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic [2:0] region_row_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic [2:0] next_region_row_q;
  // hls/stages/census.hpp:121
  logic [8:0] grey;
  assign grey = and_311_s18_q ? sum_318_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_333_s18_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:121
  logic [8:0] grey_2;
  assign grey_2 = and_311_s18_q ? sum_322_s18_q[13:5] : 9'h0;
  // hls/stages/census.hpp:122
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_333_s18_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:121
  logic and_339;
  assign and_339 = and_311_s18_q & and_326_s18_q;
  // hls/stages/census.hpp:102
  logic whole_2;
  assign whole_2 = equal_333_s18_q ? and_339 : (averager_mask_q & and_339);
  // hls/stages/agreement.hpp:422
  logic less_791;
  assign less_791 = $signed(run_shift_s18_q) < $signed(6'h1);
  // hls/stages/agreement.hpp:428
  logic [7:0] select_797;
  assign select_797 = less_791 ? (or_794_s18_q ? of_best_2_s18_q : best_left_rdata_s18_q[7:0]) : (less_792_s18_q ? of_best_2_s18_q : best_left_rdata_s18_q[7:0]);
  logic [5:0] select_801;
  assign select_801 = less_791 ? (or_794_s18_q ? run_shift_s18_q : best_left_rdata_s18_q[13:8]) : (less_792_s18_q ? run_shift_s18_q : best_left_rdata_s18_q[13:8]);
  // hls/stages/agreement.hpp:439
  logic [8:0] difference_818;
  assign difference_818 = {1'b0, select_812_s18_q} - {1'b0, select_817_s18_q};
  // hls/stages/agreement.hpp:440
  logic [8:0] sum_824;
  assign sum_824 = {1'b0, select_812_s18_q} + {1'b0, select_817_s18_q};
  // hls/stages/agreement.hpp:433
  logic [7:0] select_861;
  assign select_861 = less_791 ? (or_858_s18_q ? of_best_2_s18_q : best_right_rdata_s18_q[7:0]) : (less_856_s18_q ? of_best_2_s18_q : best_right_rdata_s18_q[7:0]);
  logic [6:0] select_865;
  assign select_865 = less_791 ? (or_858_s18_q ? x_s18_2_q : best_right_rdata_s18_q[14:8]) : (less_856_s18_q ? x_s18_2_q : best_right_rdata_s18_q[14:8]);
  // hls/stages/agreement.hpp:298
  logic [5:0] select_877;
  assign select_877 = drew_s18_q ? {region_row_q, or_876_s18_q, or_873_s18_q, or_870_s18_q} : x_s18_q[5:0];
  // hls/stages/agreement.hpp:576
  logic and_905;
  assign and_905 = and_901_s18_q & less_904_s18_q;
  // hls/stages/agreement.hpp:162
  logic and_915;
  assign and_915 = and_905 & ((cfg_nearer_below_i & best_left_rdata_s18_q[13]) | and_913_s18_q);
  // hls/stages/agreement.hpp:580
  logic and_1411;
  assign and_1411 = and_905 & less_1410_s18_q;
  // hls/stages/agreement.hpp:612
  logic equal_1414;
  assign equal_1414 = {lower_half_s18_q, less_1413_s18_q} == 2'h3;
  logic equal_1415;
  assign equal_1415 = {lower_half_s18_q, less_1413_s18_q} == 2'h2;
  logic equal_1416;
  assign equal_1416 = {lower_half_s18_q, less_1413_s18_q} == 2'h1;
  // hls/stages/agreement.hpp:637
  logic [11:0] residual;
  assign residual = less_1451_s18_q ? 12'h7f : select_1450_s18_q;
  // hls/stages/agreement.hpp:612
  logic not_1490;
  assign not_1490 = ~equal_1414;
  logic not_1491;
  assign not_1491 = ~equal_1415;
  // hls/stages/agreement.hpp:162
  logic and_1496;
  assign and_1496 = not_346_s18_q & (and_1411 & (not_1490 & (not_1491 & (~equal_1416))));
  logic and_1505;
  assign and_1505 = not_346_s18_q & (and_1411 & (not_1490 & (equal_1416 & not_1491)));
  // hls/stages/agreement.hpp:298
  logic and_1514;
  assign and_1514 = drew_s18_q & (not_346_s18_q & (and_1411 & (equal_1415 & not_1490)));
  logic and_1522;
  assign and_1522 = not_484_s18_q & (drew_s18_q & (not_346_s18_q & (and_1411 & equal_1414)));
  // hls/stages/agreement.hpp:243
  logic [2:0] select_1690;
  assign select_1690 = less_1687_s18_q ? (sum_1688_s18_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_1692;
  assign select_1692 = equal_1194_s18_q ? (equal_376_s18_q ? 3'h0 : select_1690) : region_row_q;
  // hls/stages/agreement.hpp:461
  logic next;
  assign next = ~sum_1688_s18_q;
  // hls/stages/agreement.hpp:243
  logic select_1721;
  assign select_1721 = equal_1194_s18_q ? (equal_376_s18_q | (less_1687_s18_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:134
  logic or_1726;
  assign or_1726 = segment_starts_q | not_1240_s18_q;
  // hls/stages/agreement.hpp:298
  logic select_1730;
  assign select_1730 = drew_s18_q ? (less_345_s18_q ? or_1726 : select_1728_s18_q) : or_1726;
  logic select_1732;
  assign select_1732 = equal_342_s18_q ? or_1726 : (equal_344_s18_q ? or_1726 : select_1730);

  // Memory regions, 64 x 36, DISTANCE 32, hls/stages/agreement.hpp:902; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [35:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 36'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_877;
  logic regions_re;
  assign regions_re = s18_en & and_889_s18_q;
  logic [35:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_302_s18_q;
  logic averager_memory_we;
  assign averager_memory_we = s18_en & and_311_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_326_s18_q, sum_322_s18_q, sum_318_s18_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s16_sim;
  logic averager_memory_re_s16_sim;
  logic [8:0] averager_memory_raddr_s17_sim;
  logic averager_memory_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s16_sim <= 1'b0;
      averager_memory_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s16_sim <= averager_memory_re;
      averager_memory_raddr_s16_sim <= averager_memory_raddr;
      averager_memory_re_s17_sim <= averager_memory_re_s16_sim;
      averager_memory_raddr_s17_sim <= averager_memory_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s16_sim && averager_memory_raddr_s16_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s17_sim && averager_memory_raddr_s17_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_mask_q <= 1'b0;
      region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      next_region_row_q <= 3'h0;
    end else if (s18_en) begin
      averager_mask_q <= and_329_s18_q ? whole_2 : averager_mask_q;
      region_row_q <= and_330_s18_q ? select_1692 : region_row_q;
      region_fresh_q <= and_330_s18_q ? select_1721 : region_fresh_q;
      segment_starts_q <= select_1732;
      next_region_row_q <= region_row_q + 3'h1;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s18_en) begin
      averager_total_0_q <= and_329_s18_q ? total : averager_total_0_q;
      averager_total_1_q <= and_329_s18_q ? total_2 : averager_total_1_q;
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic lower_half_s19_q;
  logic [2:0] region_row_s19_q;
  logic region_fresh_s19_q;
  logic [6:0] select_298_s19_q;
  logic and_329_s19_q;
  logic and_330_s19_q;
  logic [75:0] census_memory_rdata_s19_q;
  logic [8:0] grey_s19_q;
  logic equal_333_s19_q;
  logic [8:0] total_s19_q;
  logic [8:0] grey_2_s19_q;
  logic [8:0] total_2_s19_q;
  logic whole_2_s19_q;
  logic equal_342_s19_q;
  logic not_343_s19_q;
  logic equal_344_s19_q;
  logic less_345_s19_q;
  logic not_346_s19_q;
  logic equal_376_s19_q;
  logic drew_s19_q;
  logic [6:0] x_s19_2_q;
  logic not_484_s19_q;
  logic [7:0] best_left_rdata_s19_q;
  logic equal_489_s19_q;
  logic select_785_s19_q;
  logic less_791_s19_q;
  logic less_792_s19_q;
  logic or_794_s19_q;
  logic [7:0] select_798_s19_q;
  logic [5:0] select_802_s19_q;
  logic equal_807_s19_q;
  logic difference_818_s19_q;
  logic [1:0] sum_819_s19_q;
  logic [9:0] difference_825_s19_q;
  logic [7:0] xor_827_s19_q;
  logic and_851_s19_q;
  logic [6:0] partner_s19_q;
  logic [7:0] select_862_s19_q;
  logic [6:0] select_866_s19_q;
  logic or_870_s19_q;
  logic or_873_s19_q;
  logic or_876_s19_q;
  logic equal_883_s19_q;
  logic equal_884_s19_q;
  logic and_894_s19_q;
  logic and_905_s19_q;
  logic and_915_s19_q;
  logic and_923_s19_q;
  logic and_924_s19_q;
  logic [11:0] seen_columns_rdata_s19_q;
  logic select_932_s19_q;
  logic or_976_s19_q;
  logic or_979_s19_q;
  logic or_982_s19_q;
  logic and_1029_s19_q;
  logic equal_1143_s19_q;
  logic equal_1194_s19_q;
  logic not_1240_s19_q;
  logic and_1328_s19_q;
  logic and_1411_s19_q;
  logic less_1413_s19_q;
  logic equal_1414_s19_q;
  logic equal_1415_s19_q;
  logic equal_1416_s19_q;
  logic [7:0] residual_s19_q;
  logic and_1497_s19_q;
  logic and_1506_s19_q;
  logic and_1515_s19_q;
  logic and_1523_s19_q;
  logic [12:0] difference_1534_s19_q;
  logic equal_1846_s19_q;
  logic and_2124_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      region_row_s19_q <= region_row_q;
      region_fresh_s19_q <= region_fresh_q;
      select_298_s19_q <= select_298_s18_q;
      and_329_s19_q <= and_329_s18_q;
      and_330_s19_q <= and_330_s18_q;
      census_memory_rdata_s19_q <= census_memory_rdata_q;
      grey_s19_q <= grey;
      equal_333_s19_q <= equal_333_s18_q;
      total_s19_q <= total[10:2];
      grey_2_s19_q <= grey_2;
      total_2_s19_q <= total_2[10:2];
      whole_2_s19_q <= whole_2;
      equal_342_s19_q <= equal_342_s18_q;
      not_343_s19_q <= not_343_s18_q;
      equal_344_s19_q <= equal_344_s18_q;
      less_345_s19_q <= less_345_s18_q;
      not_346_s19_q <= not_346_s18_q;
      equal_376_s19_q <= equal_376_s18_q;
      drew_s19_q <= drew_s18_q;
      x_s19_2_q <= x_s18_2_q;
      not_484_s19_q <= not_484_s18_q;
      best_left_rdata_s19_q <= best_left_rdata_s18_q[21:14];
      equal_489_s19_q <= equal_489_s18_q;
      select_785_s19_q <= select_785_s18_q;
      less_791_s19_q <= less_791;
      less_792_s19_q <= less_792_s18_q;
      or_794_s19_q <= or_794_s18_q;
      select_798_s19_q <= equal_489_s18_q ? of_best_2_s18_q : select_797;
      select_802_s19_q <= equal_489_s18_q ? run_shift_s18_q : select_801;
      equal_807_s19_q <= equal_807_s18_q;
      difference_818_s19_q <= difference_818[8];
      sum_819_s19_q <= sum_819_s18_q;
      difference_825_s19_q <= {1'b0, select_823_s18_q, 1'b0} - {1'b0, sum_824};
      xor_827_s19_q <= difference_818[7:0] ^ {8{difference_818[8]}};
      and_851_s19_q <= and_851_s18_q;
      partner_s19_q <= partner_s18_q;
      select_862_s19_q <= equal_489_s18_q ? of_best_2_s18_q : select_861;
      select_866_s19_q <= equal_489_s18_q ? x_s18_2_q : select_865;
      or_870_s19_q <= or_870_s18_q;
      or_873_s19_q <= or_873_s18_q;
      or_876_s19_q <= or_876_s18_q;
      equal_883_s19_q <= equal_883_s18_q;
      equal_884_s19_q <= equal_884_s18_q;
      and_894_s19_q <= and_894_s18_q;
      and_905_s19_q <= and_905;
      and_915_s19_q <= and_915;
      and_923_s19_q <= and_923_s18_q;
      and_924_s19_q <= and_924_s18_q;
      seen_columns_rdata_s19_q <= seen_columns_rdata_q;
      select_932_s19_q <= select_932_s18_q;
      or_976_s19_q <= or_976_s18_q;
      or_979_s19_q <= or_979_s18_q;
      or_982_s19_q <= or_982_s18_q;
      and_1029_s19_q <= and_1029_s18_q;
      equal_1143_s19_q <= equal_1143_s18_q;
      equal_1194_s19_q <= equal_1194_s18_q;
      not_1240_s19_q <= not_1240_s18_q;
      and_1328_s19_q <= and_1328_s18_q;
      and_1411_s19_q <= and_1411;
      less_1413_s19_q <= less_1413_s18_q;
      equal_1414_s19_q <= equal_1414;
      equal_1415_s19_q <= equal_1415;
      equal_1416_s19_q <= equal_1416;
      residual_s19_q <= residual[7:0];
      and_1497_s19_q <= drew_s18_q & and_1496;
      and_1506_s19_q <= drew_s18_q & and_1505;
      and_1515_s19_q <= not_484_s18_q & and_1514;
      and_1523_s19_q <= not_343_s18_q & and_1522;
      difference_1534_s19_q <= 13'h0 - {residual[11], residual};
      equal_1846_s19_q <= equal_1846_s18_q;
      and_2124_s19_q <= and_2124_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
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
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic [3:0] census_filled_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [11:0] counts_measured_0_q;
  logic [11:0] counts_measured_1_q;
  logic [11:0] counts_measured_2_q;
  logic [11:0] counts_measured_3_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  // hls/stages/census.hpp:206
  logic less_350;
  assign less_350 = census_memory_rdata_s19_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_351;
  assign less_351 = census_memory_rdata_s19_q[46:38] < census_columns_values_1_cell_2_left_q;
  logic less_352;
  assign less_352 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_353;
  assign less_353 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_354;
  assign less_354 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_355;
  assign less_355 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_356;
  assign less_356 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_357;
  assign less_357 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_358;
  assign less_358 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_359;
  assign less_359 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_360;
  assign less_360 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_361;
  assign less_361 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:207
  logic less_362;
  assign less_362 = census_memory_rdata_s19_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_363;
  assign less_363 = census_memory_rdata_s19_q[55:47] < census_columns_values_1_cell_2_right_q;
  logic less_364;
  assign less_364 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_365;
  assign less_365 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_366;
  assign less_366 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_367;
  assign less_367 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_368;
  assign less_368 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_369;
  assign less_369 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_370;
  assign less_370 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_371;
  assign less_371 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_372;
  assign less_372 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_373;
  assign less_373 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:238
  logic equal_374;
  assign equal_374 = select_298_s19_q == 7'h0;
  logic [3:0] select_377;
  assign select_377 = equal_376_s19_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:239
  logic [4:0] select_378;
  assign select_378 = equal_374 ? {select_377, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:188
  logic [3:0] select_379;
  assign select_379 = equal_374 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:198
  logic and_382;
  assign and_382 = census_memory_rdata_s19_q[37] & (census_memory_rdata_s19_q[18] & whole_2_s19_q);
  logic and_384;
  assign and_384 = census_memory_rdata_s19_q[75] & (census_memory_rdata_s19_q[56] & and_382);
  // hls/stages/census.hpp:182
  logic [9:0] difference_407;
  assign difference_407 = {1'b0, total_s19_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_410;
  assign difference_410 = {1'b0, census_memory_rdata_s19_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_414;
  assign difference_414 = {1'b0, census_memory_rdata_s19_q[27:19]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_418;
  assign difference_418 = {1'b0, census_memory_rdata_s19_q[46:38]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_422;
  assign difference_422 = {1'b0, census_memory_rdata_s19_q[65:57]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:442
  logic [8:0] twice;
  assign twice = difference_825_s19_q[9] ? 9'h0 : difference_825_s19_q[8:0];
  // hls/stages/agreement.hpp:441
  logic [8:0] size;
  assign size = {8'h0, difference_818_s19_q} + {1'b0, xor_827_s19_q};
  // hls/stages/agreement.hpp:162
  logic textured;
  assign textured = not_346_s19_q & and_894_s19_q;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_896;
  assign select_896 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:162
  logic explained;
  assign explained = not_346_s19_q & and_905_s19_q;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_907;
  assign select_907 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:162
  logic near;
  assign near = not_346_s19_q & and_915_s19_q;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_917;
  assign select_917 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:583
  logic and_960;
  assign and_960 = seen_columns_rdata_s19_q[3] & not_346_s19_q;
  logic and_961;
  assign and_961 = seen_columns_rdata_s19_q[0] & not_346_s19_q;
  logic and_993;
  assign and_993 = seen_columns_rdata_s19_q[4] & not_346_s19_q;
  logic and_994;
  assign and_994 = seen_columns_rdata_s19_q[1] & not_346_s19_q;
  logic and_1007;
  assign and_1007 = seen_columns_rdata_s19_q[5] & not_346_s19_q;
  logic and_1008;
  assign and_1008 = seen_columns_rdata_s19_q[2] & not_346_s19_q;
  // hls/stages/census.hpp:123
  logic [9:0] sum_1048;
  assign sum_1048 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s19_q};
  logic [9:0] sum_1055;
  assign sum_1055 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s19_q};
  // hls/stages/agreement.hpp:173
  logic [8:0] select_1063;
  assign select_1063 = and_330_s19_q ? total_s19_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_1064;
  assign select_1064 = and_330_s19_q ? total_2_s19_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_1066;
  assign select_1066 = and_330_s19_q ? census_memory_rdata_s19_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_1067;
  assign select_1067 = and_330_s19_q ? census_memory_rdata_s19_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_1068;
  assign select_1068 = and_330_s19_q ? census_memory_rdata_s19_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_1069;
  assign select_1069 = and_330_s19_q ? census_memory_rdata_s19_q[27:19] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_1070;
  assign select_1070 = and_330_s19_q ? census_memory_rdata_s19_q[36:28] : census_columns_values_0_cell_2_right_q;
  logic select_1071;
  assign select_1071 = and_330_s19_q ? census_memory_rdata_s19_q[37] : census_columns_values_0_cell_2_mask_q;
  logic [8:0] select_1072;
  assign select_1072 = and_330_s19_q ? census_memory_rdata_s19_q[46:38] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_1073;
  assign select_1073 = and_330_s19_q ? census_memory_rdata_s19_q[55:47] : census_columns_values_0_cell_3_right_q;
  logic select_1074;
  assign select_1074 = and_330_s19_q ? census_memory_rdata_s19_q[56] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_1075;
  assign select_1075 = and_330_s19_q ? census_memory_rdata_s19_q[65:57] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_1076;
  assign select_1076 = and_330_s19_q ? census_memory_rdata_s19_q[74:66] : census_columns_values_0_cell_4_right_q;
  logic select_1077;
  assign select_1077 = and_330_s19_q ? census_memory_rdata_s19_q[75] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_1078;
  assign select_1078 = and_330_s19_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_1079;
  assign select_1079 = and_330_s19_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_1081;
  assign select_1081 = and_330_s19_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_1082;
  assign select_1082 = and_330_s19_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_1084;
  assign select_1084 = and_330_s19_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_1085;
  assign select_1085 = and_330_s19_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic [8:0] select_1087;
  assign select_1087 = and_330_s19_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_1088;
  assign select_1088 = and_330_s19_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_1090;
  assign select_1090 = and_330_s19_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_1091;
  assign select_1091 = and_330_s19_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_1093;
  assign select_1093 = and_330_s19_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_1094;
  assign select_1094 = and_330_s19_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_1096;
  assign select_1096 = and_330_s19_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_1097;
  assign select_1097 = and_330_s19_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_1099;
  assign select_1099 = and_330_s19_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_1100;
  assign select_1100 = and_330_s19_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_1102;
  assign select_1102 = and_330_s19_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_1103;
  assign select_1103 = and_330_s19_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_1105;
  assign select_1105 = and_330_s19_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_1106;
  assign select_1106 = and_330_s19_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_1109;
  assign select_1109 = and_330_s19_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_1110;
  assign select_1110 = and_330_s19_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_1113;
  assign select_1113 = and_330_s19_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_1114;
  assign select_1114 = and_330_s19_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:184
  logic [9:0] difference_1118;
  assign difference_1118 = {1'b0, total_2_s19_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_1121;
  assign difference_1121 = {1'b0, census_memory_rdata_s19_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_1125;
  assign difference_1125 = {1'b0, census_memory_rdata_s19_q[36:28]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_1129;
  assign difference_1129 = {1'b0, census_memory_rdata_s19_q[55:47]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_1133;
  assign difference_1133 = {1'b0, census_memory_rdata_s19_q[74:66]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:263
  logic [9:0] difference_1162;
  assign difference_1162 = {1'b0, total_s19_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_1173;
  assign difference_1173 = {1'b0, total_2_s19_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:173
  logic and_1327;
  assign and_1327 = and_330_s19_q & (equal_376_s19_q & equal_1194_s19_q);
  // hls/stages/agreement.hpp:298
  logic and_1332;
  assign and_1332 = not_343_s19_q & (not_484_s19_q & (drew_s19_q & (not_346_s19_q & and_1328_s19_q)));
  logic and_1337;
  assign and_1337 = not_343_s19_q & (not_484_s19_q & (drew_s19_q & textured));
  logic and_1342;
  assign and_1342 = not_343_s19_q & (not_484_s19_q & (drew_s19_q & explained));
  logic and_1347;
  assign and_1347 = not_343_s19_q & (not_484_s19_q & (drew_s19_q & near));
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1377;
  assign select_1377 = less_345_s19_q ? 9'h0 : (and_894_s19_q ? {and_905_s19_q, cfg_explained_limit_i} : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [8:0] select_1380;
  assign select_1380 = equal_342_s19_q ? 9'h0 : (equal_344_s19_q ? 9'h0 : (drew_s19_q ? select_1377 : 9'h0));
  // hls/stages/agreement.hpp:580
  logic [9:0] select_1403;
  assign select_1403 = and_1328_s19_q ? ({1'b0, and_915_s19_q, 8'h0} - {2'h0, cfg_hidden_limit_i}) : 10'h0;
  // hls/stages/agreement.hpp:298
  logic [9:0] select_1406;
  assign select_1406 = equal_344_s19_q ? 10'h0 : (drew_s19_q ? (less_345_s19_q ? 10'h0 : select_1403) : 10'h0);
  logic and_1499;
  assign and_1499 = not_343_s19_q & (not_484_s19_q & and_1497_s19_q);
  logic and_1508;
  assign and_1508 = not_343_s19_q & (not_484_s19_q & and_1506_s19_q);
  logic and_1516;
  assign and_1516 = not_343_s19_q & and_1515_s19_q;
  // hls/stages/agreement.hpp:178
  logic [11:0] select_1525;
  assign select_1525 = and_1327 ? 12'h0 : (counts_measured_3_q + {11'h0, and_1523_s19_q});
  // hls/stages/agreement.hpp:625
  logic less_1535;
  assign less_1535 = $signed(difference_1534_s19_q) < $signed({7'h0, cfg_moved_limit_i});
  // hls/stages/agreement.hpp:162
  logic and_1536;
  assign and_1536 = and_1411_s19_q & less_1535;
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1538;
  assign select_1538 = drew_s19_q ? (less_345_s19_q ? 2'h0 : {and_1536, and_1411_s19_q}) : 2'h0;
  // hls/stages/agreement.hpp:619
  logic not_1543;
  assign not_1543 = ~less_1413_s19_q;
  // hls/stages/agreement.hpp:625
  logic less_1621;
  assign less_1621 = $signed(difference_1534_s19_q) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1622;
  assign and_1622 = not_1543 & less_1621;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1624;
  assign select_1624 = less_345_s19_q ? 2'h0 : (and_1411_s19_q ? {and_1622, not_1543} : 2'h0);
  // hls/stages/agreement.hpp:618
  logic and_1638;
  assign and_1638 = less_1413_s19_q & less_1621;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1640;
  assign select_1640 = less_345_s19_q ? 2'h0 : (and_1411_s19_q ? {and_1638, less_1413_s19_q} : 2'h0);
  // hls/stages/agreement.hpp:785
  logic [12:0] upper;
  assign upper = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_1_q};
  logic [12:0] lower;
  assign lower = {1'b0, counts_measured_2_q} + {1'b0, counts_measured_3_q};
  // hls/stages/agreement.hpp:789
  logic [13:0] sum_1948;
  assign sum_1948 = {1'b0, upper} + {1'b0, lower};
  // hls/stages/agreement.hpp:785
  logic [12:0] left;
  assign left = {1'b0, counts_measured_0_q} + {1'b0, counts_measured_2_q};

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = select_298_s19_q;
  logic census_memory_we;
  assign census_memory_we = s19_en & and_330_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s19_q[56:0], whole_2_s19_q, total_2_s19_q, total_s19_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s18_sim;
  logic census_memory_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s18_sim <= census_memory_re;
      census_memory_raddr_s18_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s18_sim && census_memory_raddr_s18_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = partner_s19_q;
  logic best_right_we;
  assign best_right_we = s19_en & and_851_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_866_s19_q, select_862_s19_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s15_sim;
  logic best_right_re_s15_sim;
  logic [6:0] best_right_raddr_s16_sim;
  logic best_right_re_s16_sim;
  logic [6:0] best_right_raddr_s17_sim;
  logic best_right_re_s17_sim;
  logic [6:0] best_right_raddr_s18_sim;
  logic best_right_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
      best_right_re_s17_sim <= 1'b0;
      best_right_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s15_sim <= best_right_re;
      best_right_raddr_s15_sim <= best_right_raddr;
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
      best_right_re_s17_sim <= best_right_re_s16_sim;
      best_right_raddr_s17_sim <= best_right_raddr_s16_sim;
      best_right_re_s18_sim <= best_right_re_s17_sim;
      best_right_raddr_s18_sim <= best_right_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s15_sim && best_right_raddr_s15_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s16_sim && best_right_raddr_s16_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s17_sim && best_right_raddr_s17_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s18_sim && best_right_raddr_s18_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s19_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s19_en & and_924_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q[8:0], near, explained, textured};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s18_sim;
  logic seen_columns_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s18_sim <= seen_columns_re;
      seen_columns_raddr_s18_sim <= seen_columns_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s18_sim && seen_columns_raddr_s18_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_measured_0_q <= 12'h0;
      counts_measured_1_q <= 12'h0;
      counts_measured_2_q <= 12'h0;
      counts_measured_3_q <= 12'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
    end else if (s19_en) begin
      census_filled_q <= and_330_s19_q ? {select_379[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_330_s19_q ? select_378 : rows_passed_above_q;
      counts_measured_0_q <= and_1327 ? 12'h0 : (counts_measured_0_q + {11'h0, and_1499});
      counts_measured_1_q <= and_1327 ? 12'h0 : (counts_measured_1_q + {11'h0, and_1508});
      counts_measured_2_q <= and_1327 ? 12'h0 : (counts_measured_2_q + {11'h0, and_1516});
      counts_measured_3_q <= select_1525;
      segment_textured_q <= select_896 + {6'h0, and_1337};
      segment_explained_q <= select_907 + {6'h0, and_1342};
      segment_nearer_q <= select_917 + {6'h0, and_1347};
      segment_started_q <= ~segment_starts_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
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
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s19_en) begin
      averager_quarter_1_0_q <= and_329_s19_q ? grey_s19_q : averager_quarter_1_0_q;
      averager_quarter_1_1_q <= and_329_s19_q ? grey_2_s19_q : averager_quarter_1_1_q;
      averager_quarter_2_0_q <= and_329_s19_q ? averager_quarter_1_0_q : averager_quarter_2_0_q;
      averager_quarter_2_1_q <= and_329_s19_q ? averager_quarter_1_1_q : averager_quarter_2_1_q;
      census_columns_values_0_cell_0_left_q <= select_1063;
      census_columns_values_0_cell_0_right_q <= select_1064;
      census_columns_values_0_cell_1_left_q <= select_1066;
      census_columns_values_0_cell_1_right_q <= select_1067;
      census_columns_values_0_cell_1_mask_q <= select_1068;
      census_columns_values_0_cell_2_left_q <= select_1069;
      census_columns_values_0_cell_2_right_q <= select_1070;
      census_columns_values_0_cell_2_mask_q <= select_1071;
      census_columns_values_0_cell_3_left_q <= select_1072;
      census_columns_values_0_cell_3_right_q <= select_1073;
      census_columns_values_0_cell_3_mask_q <= select_1074;
      census_columns_values_0_cell_4_left_q <= select_1075;
      census_columns_values_0_cell_4_right_q <= select_1076;
      census_columns_values_0_cell_4_mask_q <= select_1077;
      census_columns_values_1_cell_0_left_q <= select_1078;
      census_columns_values_1_cell_0_right_q <= select_1079;
      census_columns_values_1_cell_1_left_q <= select_1081;
      census_columns_values_1_cell_1_right_q <= select_1082;
      census_columns_values_1_cell_2_left_q <= select_1084;
      census_columns_values_1_cell_2_right_q <= select_1085;
      census_columns_values_1_cell_3_left_q <= select_1087;
      census_columns_values_1_cell_3_right_q <= select_1088;
      census_columns_values_1_cell_4_left_q <= select_1090;
      census_columns_values_1_cell_4_right_q <= select_1091;
      census_columns_values_2_cell_0_left_q <= select_1093;
      census_columns_values_2_cell_0_right_q <= select_1094;
      census_columns_values_2_cell_1_left_q <= select_1096;
      census_columns_values_2_cell_1_right_q <= select_1097;
      census_columns_values_2_cell_2_left_q <= select_1099;
      census_columns_values_2_cell_2_right_q <= select_1100;
      census_columns_values_2_cell_3_left_q <= select_1102;
      census_columns_values_2_cell_3_right_q <= select_1103;
      census_columns_values_2_cell_4_left_q <= select_1105;
      census_columns_values_2_cell_4_right_q <= select_1106;
      census_columns_values_3_cell_1_left_q <= select_1109;
      census_columns_values_3_cell_1_right_q <= select_1110;
      census_columns_values_3_cell_3_left_q <= select_1113;
      census_columns_values_3_cell_3_right_q <= select_1114;
      sharpness_last_mean_0_q <= and_330_s19_q ? total_s19_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_330_s19_q ? total_2_s19_q : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic census_columns_values_0_cell_1_mask_s20_q;
  logic census_columns_values_0_cell_2_mask_s20_q;
  logic census_columns_values_0_cell_3_mask_s20_q;
  logic census_columns_values_0_cell_4_mask_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic lower_half_s20_q;
  logic [11:0] counts_measured_0_s20_q;
  logic [11:0] counts_measured_1_s20_q;
  logic [11:0] counts_measured_2_s20_q;
  logic [11:0] counts_measured_3_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic [6:0] select_298_s20_q;
  logic and_329_s20_q;
  logic and_330_s20_q;
  logic equal_333_s20_q;
  logic whole_2_s20_q;
  logic equal_342_s20_q;
  logic not_343_s20_q;
  logic equal_344_s20_q;
  logic less_345_s20_q;
  logic not_346_s20_q;
  logic less_350_s20_q;
  logic less_351_s20_q;
  logic less_352_s20_q;
  logic less_353_s20_q;
  logic less_354_s20_q;
  logic less_355_s20_q;
  logic less_356_s20_q;
  logic less_357_s20_q;
  logic less_358_s20_q;
  logic less_359_s20_q;
  logic less_360_s20_q;
  logic less_361_s20_q;
  logic less_362_s20_q;
  logic less_363_s20_q;
  logic less_364_s20_q;
  logic less_365_s20_q;
  logic less_366_s20_q;
  logic less_367_s20_q;
  logic less_368_s20_q;
  logic less_369_s20_q;
  logic less_370_s20_q;
  logic less_371_s20_q;
  logic less_372_s20_q;
  logic less_373_s20_q;
  logic and_380_s20_q;
  logic and_384_s20_q;
  logic difference_407_s20_q;
  logic [8:0] xor_408_s20_q;
  logic difference_410_s20_q;
  logic [8:0] xor_411_s20_q;
  logic difference_414_s20_q;
  logic [8:0] xor_415_s20_q;
  logic difference_418_s20_q;
  logic [8:0] xor_419_s20_q;
  logic difference_422_s20_q;
  logic [8:0] xor_423_s20_q;
  logic drew_s20_q;
  logic [6:0] x_s20_2_q;
  logic not_484_s20_q;
  logic [7:0] best_left_rdata_s20_q;
  logic equal_489_s20_q;
  logic select_785_s20_q;
  logic less_791_s20_q;
  logic less_792_s20_q;
  logic or_794_s20_q;
  logic [7:0] select_798_s20_q;
  logic [5:0] select_802_s20_q;
  logic equal_807_s20_q;
  logic difference_818_s20_q;
  logic [1:0] sum_819_s20_q;
  logic [8:0] twice_s20_q;
  logic [8:0] size_s20_q;
  logic less_829_s20_q;
  logic and_851_s20_q;
  logic or_870_s20_q;
  logic or_873_s20_q;
  logic or_876_s20_q;
  logic equal_883_s20_q;
  logic equal_884_s20_q;
  logic [35:0] regions_rdata_s20_q;
  logic and_894_s20_q;
  logic [6:0] sum_897_s20_q;
  logic [6:0] sum_908_s20_q;
  logic [6:0] sum_918_s20_q;
  logic and_923_s20_q;
  logic select_932_s20_q;
  logic [3:0] select_958_s20_q;
  logic and_959_s20_q;
  logic and_960_s20_q;
  logic [1:0] sum_963_s20_q;
  logic or_976_s20_q;
  logic or_979_s20_q;
  logic or_982_s20_q;
  logic and_992_s20_q;
  logic [1:0] sum_996_s20_q;
  logic [1:0] sum_1010_s20_q;
  logic and_1029_s20_q;
  logic sum_1048_s20_q;
  logic [9:0] difference_1049_s20_q;
  logic sum_1055_s20_q;
  logic [9:0] difference_1056_s20_q;
  logic difference_1118_s20_q;
  logic [8:0] xor_1119_s20_q;
  logic difference_1121_s20_q;
  logic [8:0] xor_1122_s20_q;
  logic difference_1125_s20_q;
  logic [8:0] xor_1126_s20_q;
  logic difference_1129_s20_q;
  logic [8:0] xor_1130_s20_q;
  logic difference_1133_s20_q;
  logic [8:0] xor_1134_s20_q;
  logic equal_1143_s20_q;
  logic difference_1162_s20_q;
  logic [8:0] xor_1163_s20_q;
  logic difference_1173_s20_q;
  logic [8:0] xor_1174_s20_q;
  logic equal_1194_s20_q;
  logic not_1240_s20_q;
  logic and_1327_s20_q;
  logic and_1332_s20_q;
  logic and_1337_s20_q;
  logic and_1342_s20_q;
  logic and_1347_s20_q;
  logic [8:0] select_1380_s20_q;
  logic [9:0] select_1406_s20_q;
  logic and_1411_s20_q;
  logic less_1413_s20_q;
  logic equal_1414_s20_q;
  logic equal_1415_s20_q;
  logic equal_1416_s20_q;
  logic [7:0] residual_s20_q;
  logic [1:0] select_1539_s20_q;
  logic not_1543_s20_q;
  logic less_1554_s20_q;
  logic less_1621_s20_q;
  logic [1:0] select_1625_s20_q;
  logic [1:0] select_1641_s20_q;
  logic equal_1846_s20_q;
  logic [10:0] sum_1948_s20_q;
  logic less_1952_s20_q;
  logic less_1963_s20_q;
  logic less_1975_s20_q;
  logic and_2124_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      census_columns_values_0_cell_1_mask_s20_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s20_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s20_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s20_q <= census_columns_values_0_cell_4_mask_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_measured_0_s20_q <= counts_measured_0_q;
      counts_measured_1_s20_q <= counts_measured_1_q;
      counts_measured_2_s20_q <= counts_measured_2_q;
      counts_measured_3_s20_q <= counts_measured_3_q;
      region_row_s20_q <= region_row_s19_q;
      region_fresh_s20_q <= region_fresh_s19_q;
      select_298_s20_q <= select_298_s19_q;
      and_329_s20_q <= and_329_s19_q;
      and_330_s20_q <= and_330_s19_q;
      equal_333_s20_q <= equal_333_s19_q;
      whole_2_s20_q <= whole_2_s19_q;
      equal_342_s20_q <= equal_342_s19_q;
      not_343_s20_q <= not_343_s19_q;
      equal_344_s20_q <= equal_344_s19_q;
      less_345_s20_q <= less_345_s19_q;
      not_346_s20_q <= not_346_s19_q;
      less_350_s20_q <= less_350;
      less_351_s20_q <= less_351;
      less_352_s20_q <= less_352;
      less_353_s20_q <= less_353;
      less_354_s20_q <= less_354;
      less_355_s20_q <= less_355;
      less_356_s20_q <= less_356;
      less_357_s20_q <= less_357;
      less_358_s20_q <= less_358;
      less_359_s20_q <= less_359;
      less_360_s20_q <= less_360;
      less_361_s20_q <= less_361;
      less_362_s20_q <= less_362;
      less_363_s20_q <= less_363;
      less_364_s20_q <= less_364;
      less_365_s20_q <= less_365;
      less_366_s20_q <= less_366;
      less_367_s20_q <= less_367;
      less_368_s20_q <= less_368;
      less_369_s20_q <= less_369;
      less_370_s20_q <= less_370;
      less_371_s20_q <= less_371;
      less_372_s20_q <= less_372;
      less_373_s20_q <= less_373;
      and_380_s20_q <= select_378[4] & select_379[3];
      and_384_s20_q <= and_384;
      difference_407_s20_q <= difference_407[9];
      xor_408_s20_q <= difference_407[8:0] ^ {9{difference_407[9]}};
      difference_410_s20_q <= difference_410[9];
      xor_411_s20_q <= difference_410[8:0] ^ {9{difference_410[9]}};
      difference_414_s20_q <= difference_414[9];
      xor_415_s20_q <= difference_414[8:0] ^ {9{difference_414[9]}};
      difference_418_s20_q <= difference_418[9];
      xor_419_s20_q <= difference_418[8:0] ^ {9{difference_418[9]}};
      difference_422_s20_q <= difference_422[9];
      xor_423_s20_q <= difference_422[8:0] ^ {9{difference_422[9]}};
      drew_s20_q <= drew_s19_q;
      x_s20_2_q <= x_s19_2_q;
      not_484_s20_q <= not_484_s19_q;
      best_left_rdata_s20_q <= best_left_rdata_s19_q;
      equal_489_s20_q <= equal_489_s19_q;
      select_785_s20_q <= select_785_s19_q;
      less_791_s20_q <= less_791_s19_q;
      less_792_s20_q <= less_792_s19_q;
      or_794_s20_q <= or_794_s19_q;
      select_798_s20_q <= select_798_s19_q;
      select_802_s20_q <= select_802_s19_q;
      equal_807_s20_q <= equal_807_s19_q;
      difference_818_s20_q <= difference_818_s19_q;
      sum_819_s20_q <= sum_819_s19_q;
      twice_s20_q <= twice;
      size_s20_q <= size;
      less_829_s20_q <= {1'b0, size[8:1]} < twice;
      and_851_s20_q <= and_851_s19_q;
      or_870_s20_q <= or_870_s19_q;
      or_873_s20_q <= or_873_s19_q;
      or_876_s20_q <= or_876_s19_q;
      equal_883_s20_q <= equal_883_s19_q;
      equal_884_s20_q <= equal_884_s19_q;
      regions_rdata_s20_q <= regions_rdata_q;
      and_894_s20_q <= and_894_s19_q;
      sum_897_s20_q <= {6'h0, textured} + select_896;
      sum_908_s20_q <= {6'h0, explained} + select_907;
      sum_918_s20_q <= {6'h0, near} + select_917;
      and_923_s20_q <= and_923_s19_q;
      select_932_s20_q <= select_932_s19_q;
      select_958_s20_q <= less_345_s19_q ? 4'h0 : seen_columns_rdata_s19_q[11:8];
      and_959_s20_q <= seen_columns_rdata_s19_q[6] & not_346_s19_q;
      and_960_s20_q <= and_960;
      sum_963_s20_q <= {1'b0, and_960} + ({1'b0, textured} + {1'b0, and_961});
      or_976_s20_q <= or_976_s19_q;
      or_979_s20_q <= or_979_s19_q;
      or_982_s20_q <= or_982_s19_q;
      and_992_s20_q <= seen_columns_rdata_s19_q[7] & not_346_s19_q;
      sum_996_s20_q <= {1'b0, and_993} + ({1'b0, explained} + {1'b0, and_994});
      sum_1010_s20_q <= {1'b0, and_1007} + ({1'b0, near} + {1'b0, and_1008});
      and_1029_s20_q <= and_1029_s19_q;
      sum_1048_s20_q <= sum_1048[0];
      difference_1049_s20_q <= {1'b0, sum_1048[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_1055_s20_q <= sum_1055[0];
      difference_1056_s20_q <= {1'b0, sum_1055[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_1118_s20_q <= difference_1118[9];
      xor_1119_s20_q <= difference_1118[8:0] ^ {9{difference_1118[9]}};
      difference_1121_s20_q <= difference_1121[9];
      xor_1122_s20_q <= difference_1121[8:0] ^ {9{difference_1121[9]}};
      difference_1125_s20_q <= difference_1125[9];
      xor_1126_s20_q <= difference_1125[8:0] ^ {9{difference_1125[9]}};
      difference_1129_s20_q <= difference_1129[9];
      xor_1130_s20_q <= difference_1129[8:0] ^ {9{difference_1129[9]}};
      difference_1133_s20_q <= difference_1133[9];
      xor_1134_s20_q <= difference_1133[8:0] ^ {9{difference_1133[9]}};
      equal_1143_s20_q <= equal_1143_s19_q;
      difference_1162_s20_q <= difference_1162[9];
      xor_1163_s20_q <= difference_1162[8:0] ^ {9{difference_1162[9]}};
      difference_1173_s20_q <= difference_1173[9];
      xor_1174_s20_q <= difference_1173[8:0] ^ {9{difference_1173[9]}};
      equal_1194_s20_q <= equal_1194_s19_q;
      not_1240_s20_q <= not_1240_s19_q;
      and_1327_s20_q <= and_1327;
      and_1332_s20_q <= and_1332;
      and_1337_s20_q <= and_1337;
      and_1342_s20_q <= and_1342;
      and_1347_s20_q <= and_1347;
      select_1380_s20_q <= select_1380;
      select_1406_s20_q <= select_1406;
      and_1411_s20_q <= and_1411_s19_q;
      less_1413_s20_q <= less_1413_s19_q;
      equal_1414_s20_q <= equal_1414_s19_q;
      equal_1415_s20_q <= equal_1415_s19_q;
      equal_1416_s20_q <= equal_1416_s19_q;
      residual_s20_q <= residual_s19_q;
      select_1539_s20_q <= equal_344_s19_q ? 2'h0 : select_1538;
      not_1543_s20_q <= not_1543;
      less_1554_s20_q <= $signed(difference_1534_s19_q) < $signed({{5{limit[7]}}, limit});
      less_1621_s20_q <= less_1621;
      select_1625_s20_q <= drew_s19_q ? select_1624 : 2'h0;
      select_1641_s20_q <= drew_s19_q ? select_1640 : 2'h0;
      equal_1846_s20_q <= equal_1846_s19_q;
      sum_1948_s20_q <= sum_1948[13:3];
      less_1952_s20_q <= 11'he < left[12:2];
      less_1963_s20_q <= 11'he < upper[12:2];
      less_1975_s20_q <= 11'he < lower[12:2];
      and_2124_s20_q <= and_2124_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [23:0] counts_too_little_explained_q;
  logic [23:0] counts_too_much_hidden_q;
  logic [14:0] counts_votes_0_up_q;
  logic [14:0] counts_half_votes_0_up_q;
  logic [14:0] counts_half_votes_1_up_q;
  logic centres_values_0_q;
  logic centres_values_1_q;
  // hls/stages/agreement.hpp:239
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_384_s20_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s20_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s20_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s20_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s20_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:182
  logic [9:0] sum_409;
  assign sum_409 = {9'h0, difference_407_s20_q} + {1'b0, xor_408_s20_q};
  logic [9:0] sum_412;
  assign sum_412 = {9'h0, difference_410_s20_q} + {1'b0, xor_411_s20_q};
  // hls/stages/agreement.hpp:443
  logic [9:0] difference_831;
  assign difference_831 = {1'b0, twice_s20_q} - (less_829_s20_q ? {1'b0, size_s20_q} : {twice_s20_q, 1'b0});
  // hls/stages/agreement.hpp:657
  logic [11:0] sum_899;
  assign sum_899 = {5'h0, sum_897_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[11:0]);
  // hls/stages/agreement.hpp:658
  logic [11:0] sum_910;
  assign sum_910 = {5'h0, sum_908_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[23:12]);
  // hls/stages/agreement.hpp:659
  logic [11:0] sum_920;
  assign sum_920 = {5'h0, sum_918_s20_q} + (region_fresh_s20_q ? 12'h0 : regions_rdata_s20_q[35:24]);
  // hls/stages/agreement.hpp:677
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, select_958_s20_q[1]} + ({2'h0, and_959_s20_q} + {1'b0, sum_963_s20_q});
  // hls/stages/agreement.hpp:678
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, select_958_s20_q[2]} + ({2'h0, and_992_s20_q} + {1'b0, sum_996_s20_q});
  // hls/stages/agreement.hpp:679
  logic [2:0] near_2;
  assign near_2 = {2'h0, select_958_s20_q[3]} + ({2'h0, select_958_s20_q[0]} + {1'b0, sum_1010_s20_q});
  // hls/stages/census.hpp:124
  logic [9:0] xor_1050;
  assign xor_1050 = {difference_1049_s20_q[8:0], sum_1048_s20_q} ^ {10{difference_1049_s20_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_1049_s20_q[9]} + {1'b0, xor_1050};
  logic [9:0] xor_1057;
  assign xor_1057 = {difference_1056_s20_q[8:0], sum_1055_s20_q} ^ {10{difference_1056_s20_q[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_1056_s20_q[9]} + {1'b0, xor_1057};
  // hls/stages/agreement.hpp:173
  logic select_1065;
  assign select_1065 = and_330_s20_q ? whole_2_s20_q : census_columns_values_0_cell_0_mask_q;
  logic select_1080;
  assign select_1080 = and_330_s20_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_1083;
  assign select_1083 = and_330_s20_q ? census_columns_values_0_cell_1_mask_s20_q : census_columns_values_1_cell_1_mask_q;
  logic select_1086;
  assign select_1086 = and_330_s20_q ? census_columns_values_0_cell_2_mask_s20_q : census_columns_values_1_cell_2_mask_q;
  logic select_1089;
  assign select_1089 = and_330_s20_q ? census_columns_values_0_cell_3_mask_s20_q : census_columns_values_1_cell_3_mask_q;
  logic select_1092;
  assign select_1092 = and_330_s20_q ? census_columns_values_0_cell_4_mask_s20_q : census_columns_values_1_cell_4_mask_q;
  logic select_1095;
  assign select_1095 = and_330_s20_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_1098;
  assign select_1098 = and_330_s20_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:184
  logic [9:0] sum_1120;
  assign sum_1120 = {9'h0, difference_1118_s20_q} + {1'b0, xor_1119_s20_q};
  logic [9:0] sum_1123;
  assign sum_1123 = {9'h0, difference_1121_s20_q} + {1'b0, xor_1122_s20_q};
  // hls/stages/census.hpp:263
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_1162_s20_q} + xor_1163_s20_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_1173_s20_q} + xor_1174_s20_q;
  // hls/stages/agreement.hpp:716
  logic less_1360;
  assign less_1360 = region_row_s20_q < x_s20_q[5:3];
  logic [11:0] select_1364;
  assign select_1364 = less_1360 ? 12'h0 : regions_rdata_s20_q[23:12];
  // hls/stages/agreement.hpp:544
  logic [23:0] sum_1381;
  assign sum_1381 = counts_too_little_explained_q + {{15{select_1380_s20_q[8]}}, select_1380_s20_q};
  // hls/stages/agreement.hpp:298
  logic [9:0] select_1407;
  assign select_1407 = equal_342_s20_q ? 10'h0 : select_1406_s20_q;
  // hls/stages/agreement.hpp:554
  logic [23:0] select_1409;
  assign select_1409 = and_1327_s20_q ? 24'h0 : (counts_too_much_hidden_q + {{14{select_1407[9]}}, select_1407});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up;
  assign to_up = equal_342_s20_q ? 2'h0 : select_1539_s20_q;
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1542;
  assign select_1542 = and_1327_s20_q ? 15'h0 : (counts_votes_0_up_q + {{13{to_up[1]}}, to_up});
  // hls/stages/agreement.hpp:625
  logic less_1545;
  assign less_1545 = $signed(residual_s20_q) < $signed(limit);
  // hls/stages/agreement.hpp:618
  logic and_1546;
  assign and_1546 = not_1543_s20_q & less_1545;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1548;
  assign select_1548 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1546, not_1543_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:618
  logic and_1555;
  assign and_1555 = not_1543_s20_q & less_1554_s20_q;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1557;
  assign select_1557 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1555, not_1543_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_2;
  assign to_up_2 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1557 : 2'h0));
  // hls/stages/agreement.hpp:618
  logic and_1563;
  assign and_1563 = less_1413_s20_q & less_1545;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1565;
  assign select_1565 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1563, less_1413_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:618
  logic and_1571;
  assign and_1571 = less_1413_s20_q & less_1554_s20_q;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1573;
  assign select_1573 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1571, less_1413_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_3;
  assign to_up_3 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1573 : 2'h0));
  // hls/stages/agreement.hpp:619
  logic not_1579;
  assign not_1579 = ~lower_half_s20_q;
  // hls/stages/agreement.hpp:162
  logic and_1580;
  assign and_1580 = less_1545 & not_1579;
  logic [1:0] select_1582;
  assign select_1582 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1580, not_1579} : 2'h0);
  logic and_1588;
  assign and_1588 = less_1554_s20_q & not_1579;
  logic [1:0] select_1590;
  assign select_1590 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1588, not_1579} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_4;
  assign to_up_4 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1590 : 2'h0));
  // hls/stages/agreement.hpp:162
  logic and_1596;
  assign and_1596 = lower_half_s20_q & less_1545;
  logic [1:0] select_1598;
  assign select_1598 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1596, lower_half_s20_q} : 2'h0);
  logic and_1604;
  assign and_1604 = lower_half_s20_q & less_1554_s20_q;
  logic [1:0] select_1606;
  assign select_1606 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1604, lower_half_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_5;
  assign to_up_5 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1606 : 2'h0));
  // hls/stages/agreement.hpp:625
  logic less_1612;
  assign less_1612 = $signed(residual_s20_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:618
  logic and_1613;
  assign and_1613 = not_1543_s20_q & less_1612;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1615;
  assign select_1615 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1613, not_1543_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_6;
  assign to_up_6 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : select_1625_s20_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1629;
  assign select_1629 = and_1327_s20_q ? 15'h0 : (counts_half_votes_0_up_q + {{13{to_up_6[1]}}, to_up_6});
  // hls/stages/agreement.hpp:618
  logic and_1630;
  assign and_1630 = less_1413_s20_q & less_1612;
  // hls/stages/agreement.hpp:162
  logic [1:0] select_1632;
  assign select_1632 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1630, less_1413_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_7;
  assign to_up_7 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : select_1641_s20_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1645;
  assign select_1645 = and_1327_s20_q ? 15'h0 : (counts_half_votes_1_up_q + {{13{to_up_7[1]}}, to_up_7});
  // hls/stages/agreement.hpp:162
  logic and_1646;
  assign and_1646 = less_1612 & not_1579;
  logic [1:0] select_1648;
  assign select_1648 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1646, not_1579} : 2'h0);
  logic and_1654;
  assign and_1654 = less_1621_s20_q & not_1579;
  logic [1:0] select_1656;
  assign select_1656 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1654, not_1579} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_8;
  assign to_up_8 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1656 : 2'h0));
  // hls/stages/agreement.hpp:162
  logic and_1662;
  assign and_1662 = lower_half_s20_q & less_1612;
  logic [1:0] select_1664;
  assign select_1664 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1662, lower_half_s20_q} : 2'h0);
  logic and_1670;
  assign and_1670 = lower_half_s20_q & less_1621_s20_q;
  logic [1:0] select_1672;
  assign select_1672 = less_345_s20_q ? 2'h0 : (and_1411_s20_q ? {and_1670, lower_half_s20_q} : 2'h0);
  // hls/stages/agreement.hpp:298
  logic [1:0] to_up_9;
  assign to_up_9 = equal_342_s20_q ? 2'h0 : (equal_344_s20_q ? 2'h0 : (drew_s20_q ? select_1672 : 2'h0));
  logic select_1841;
  assign select_1841 = equal_344_s20_q ? centres_values_0_q : (drew_s20_q ? and_960_s20_q : centres_values_0_q);
  logic select_1844;
  assign select_1844 = equal_344_s20_q ? centres_values_1_q : (drew_s20_q ? centres_values_0_q : centres_values_1_q);
  // hls/stages/agreement.hpp:496
  logic less_1954;
  assign less_1954 = $signed(15'h0) < $signed(counts_votes_0_up_q);
  // hls/stages/agreement.hpp:790
  logic or_1955;
  assign or_1955 = (~less_1952_s20_q) | less_1954;
  // hls/stages/agreement.hpp:785
  logic [12:0] right;
  assign right = {1'b0, counts_measured_1_s20_q} + {1'b0, counts_measured_3_s20_q};
  // hls/stages/agreement.hpp:496
  logic less_1959;
  assign less_1959 = $signed(15'h0) < $signed(counts_half_votes_0_up_q);
  // hls/stages/agreement.hpp:727
  logic [11:0] select_2141;
  assign select_2141 = equal_884_s20_q ? 12'h0 : (less_1360 ? 12'h0 : regions_rdata_s20_q[35:24]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_too_little_explained_q <= 24'h0;
      counts_too_much_hidden_q <= 24'h0;
      counts_votes_0_up_q <= 15'h0;
      counts_half_votes_0_up_q <= 15'h0;
      counts_half_votes_1_up_q <= 15'h0;
      centres_values_0_q <= 1'b0;
      centres_values_1_q <= 1'b0;
    end else if (s20_en) begin
      counts_too_little_explained_q <= and_1327_s20_q ? 24'h0 : sum_1381;
      counts_too_much_hidden_q <= select_1409;
      counts_votes_0_up_q <= select_1542;
      counts_half_votes_0_up_q <= select_1629;
      counts_half_votes_1_up_q <= select_1645;
      centres_values_0_q <= equal_342_s20_q ? centres_values_0_q : select_1841;
      centres_values_1_q <= equal_342_s20_q ? centres_values_1_q : select_1844;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s20_en) begin
      census_columns_values_0_cell_0_mask_q <= select_1065;
      census_columns_values_1_cell_0_mask_q <= select_1080;
      census_columns_values_1_cell_1_mask_q <= select_1083;
      census_columns_values_1_cell_2_mask_q <= select_1086;
      census_columns_values_1_cell_3_mask_q <= select_1089;
      census_columns_values_1_cell_4_mask_q <= select_1092;
      census_columns_values_2_cell_0_mask_q <= select_1095;
      census_columns_values_2_cell_1_mask_q <= select_1098;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic census_columns_values_1_cell_2_mask_s21_q;
  logic census_columns_values_1_cell_3_mask_s21_q;
  logic census_columns_values_1_cell_4_mask_s21_q;
  logic census_columns_values_2_cell_0_mask_s21_q;
  logic census_columns_values_2_cell_1_mask_s21_q;
  logic [7:0] x_s21_q;
  logic age_s21_q;
  logic [11:0] counts_measured_0_s21_q;
  logic [11:0] counts_measured_1_s21_q;
  logic [11:0] counts_measured_2_s21_q;
  logic [11:0] counts_measured_3_s21_q;
  logic [2:0] region_row_s21_q;
  logic [6:0] select_298_s21_q;
  logic and_329_s21_q;
  logic and_330_s21_q;
  logic equal_333_s21_q;
  logic whole_2_s21_q;
  logic equal_342_s21_q;
  logic not_343_s21_q;
  logic equal_344_s21_q;
  logic less_345_s21_q;
  logic not_346_s21_q;
  logic less_350_s21_q;
  logic less_351_s21_q;
  logic less_352_s21_q;
  logic less_353_s21_q;
  logic less_354_s21_q;
  logic less_355_s21_q;
  logic less_356_s21_q;
  logic less_357_s21_q;
  logic less_358_s21_q;
  logic less_359_s21_q;
  logic less_360_s21_q;
  logic less_361_s21_q;
  logic less_362_s21_q;
  logic less_363_s21_q;
  logic less_364_s21_q;
  logic less_365_s21_q;
  logic less_366_s21_q;
  logic less_367_s21_q;
  logic less_368_s21_q;
  logic less_369_s21_q;
  logic less_370_s21_q;
  logic less_371_s21_q;
  logic less_372_s21_q;
  logic less_373_s21_q;
  logic and_380_s21_q;
  logic whole_9_s21_q;
  logic [10:0] sum_413_s21_q;
  logic [9:0] sum_416_s21_q;
  logic [9:0] sum_420_s21_q;
  logic [9:0] sum_424_s21_q;
  logic drew_s21_q;
  logic [6:0] x_s21_2_q;
  logic not_484_s21_q;
  logic [7:0] best_left_rdata_s21_q;
  logic equal_489_s21_q;
  logic select_785_s21_q;
  logic less_791_s21_q;
  logic less_792_s21_q;
  logic or_794_s21_q;
  logic [7:0] select_798_s21_q;
  logic [5:0] select_802_s21_q;
  logic equal_807_s21_q;
  logic difference_818_s21_q;
  logic [1:0] sum_819_s21_q;
  logic [8:0] twice_s21_q;
  logic [9:0] difference_831_s21_q;
  logic and_851_s21_q;
  logic or_870_s21_q;
  logic or_873_s21_q;
  logic or_876_s21_q;
  logic equal_883_s21_q;
  logic equal_884_s21_q;
  logic and_894_s21_q;
  logic [11:0] sum_899_s21_q;
  logic [11:0] sum_910_s21_q;
  logic [11:0] sum_920_s21_q;
  logic and_923_s21_q;
  logic select_932_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_976_s21_q;
  logic or_979_s21_q;
  logic or_982_s21_q;
  logic [2:0] explained_2_s21_q;
  logic [2:0] near_2_s21_q;
  logic and_1029_s21_q;
  logic [10:0] size_2_s21_q;
  logic [10:0] size_3_s21_q;
  logic [10:0] sum_1124_s21_q;
  logic [9:0] sum_1127_s21_q;
  logic [9:0] sum_1131_s21_q;
  logic [9:0] sum_1135_s21_q;
  logic equal_1143_s21_q;
  logic [8:0] contrast_s21_q;
  logic [8:0] contrast_2_s21_q;
  logic equal_1194_s21_q;
  logic not_1240_s21_q;
  logic and_1327_s21_q;
  logic and_1332_s21_q;
  logic and_1337_s21_q;
  logic and_1342_s21_q;
  logic and_1347_s21_q;
  logic or_1352_s21_q;
  logic [11:0] select_1361_s21_q;
  logic [11:0] select_1364_s21_q;
  logic and_1411_s21_q;
  logic equal_1414_s21_q;
  logic equal_1415_s21_q;
  logic equal_1416_s21_q;
  logic [7:0] residual_s21_q;
  logic [1:0] select_1549_s21_q;
  logic [1:0] to_up_2_s21_q;
  logic [1:0] select_1566_s21_q;
  logic [1:0] to_up_3_s21_q;
  logic [1:0] select_1583_s21_q;
  logic [1:0] to_up_4_s21_q;
  logic [1:0] select_1599_s21_q;
  logic [1:0] to_up_5_s21_q;
  logic [1:0] select_1616_s21_q;
  logic [1:0] select_1633_s21_q;
  logic [1:0] select_1649_s21_q;
  logic [1:0] to_up_8_s21_q;
  logic [1:0] select_1665_s21_q;
  logic [1:0] to_up_9_s21_q;
  logic less_1740_s21_q;
  logic [12:0] sum_1743_s21_q;
  logic less_1757_s21_q;
  logic equal_1846_s21_q;
  logic less_1949_s21_q;
  logic less_1952_s21_q;
  logic or_1955_s21_q;
  logic less_1957_s21_q;
  logic less_1959_s21_q;
  logic select_1960_s21_q;
  logic less_1963_s21_q;
  logic less_1965_s21_q;
  logic less_1975_s21_q;
  logic and_2124_s21_q;
  logic [11:0] select_2143_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      census_columns_values_1_cell_2_mask_s21_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_3_mask_s21_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s21_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s21_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s21_q <= census_columns_values_2_cell_1_mask_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      counts_measured_0_s21_q <= counts_measured_0_s20_q;
      counts_measured_1_s21_q <= counts_measured_1_s20_q;
      counts_measured_2_s21_q <= counts_measured_2_s20_q;
      counts_measured_3_s21_q <= counts_measured_3_s20_q;
      region_row_s21_q <= region_row_s20_q;
      select_298_s21_q <= select_298_s20_q;
      and_329_s21_q <= and_329_s20_q;
      and_330_s21_q <= and_330_s20_q;
      equal_333_s21_q <= equal_333_s20_q;
      whole_2_s21_q <= whole_2_s20_q;
      equal_342_s21_q <= equal_342_s20_q;
      not_343_s21_q <= not_343_s20_q;
      equal_344_s21_q <= equal_344_s20_q;
      less_345_s21_q <= less_345_s20_q;
      not_346_s21_q <= not_346_s20_q;
      less_350_s21_q <= less_350_s20_q;
      less_351_s21_q <= less_351_s20_q;
      less_352_s21_q <= less_352_s20_q;
      less_353_s21_q <= less_353_s20_q;
      less_354_s21_q <= less_354_s20_q;
      less_355_s21_q <= less_355_s20_q;
      less_356_s21_q <= less_356_s20_q;
      less_357_s21_q <= less_357_s20_q;
      less_358_s21_q <= less_358_s20_q;
      less_359_s21_q <= less_359_s20_q;
      less_360_s21_q <= less_360_s20_q;
      less_361_s21_q <= less_361_s20_q;
      less_362_s21_q <= less_362_s20_q;
      less_363_s21_q <= less_363_s20_q;
      less_364_s21_q <= less_364_s20_q;
      less_365_s21_q <= less_365_s20_q;
      less_366_s21_q <= less_366_s20_q;
      less_367_s21_q <= less_367_s20_q;
      less_368_s21_q <= less_368_s20_q;
      less_369_s21_q <= less_369_s20_q;
      less_370_s21_q <= less_370_s20_q;
      less_371_s21_q <= less_371_s20_q;
      less_372_s21_q <= less_372_s20_q;
      less_373_s21_q <= less_373_s20_q;
      and_380_s21_q <= and_380_s20_q;
      whole_9_s21_q <= whole_9;
      sum_413_s21_q <= {1'b0, sum_409} + {1'b0, sum_412};
      sum_416_s21_q <= {9'h0, difference_414_s20_q} + {1'b0, xor_415_s20_q};
      sum_420_s21_q <= {9'h0, difference_418_s20_q} + {1'b0, xor_419_s20_q};
      sum_424_s21_q <= {9'h0, difference_422_s20_q} + {1'b0, xor_423_s20_q};
      drew_s21_q <= drew_s20_q;
      x_s21_2_q <= x_s20_2_q;
      not_484_s21_q <= not_484_s20_q;
      best_left_rdata_s21_q <= best_left_rdata_s20_q;
      equal_489_s21_q <= equal_489_s20_q;
      select_785_s21_q <= select_785_s20_q;
      less_791_s21_q <= less_791_s20_q;
      less_792_s21_q <= less_792_s20_q;
      or_794_s21_q <= or_794_s20_q;
      select_798_s21_q <= select_798_s20_q;
      select_802_s21_q <= select_802_s20_q;
      equal_807_s21_q <= equal_807_s20_q;
      difference_818_s21_q <= difference_818_s20_q;
      sum_819_s21_q <= sum_819_s20_q;
      twice_s21_q <= twice_s20_q;
      difference_831_s21_q <= difference_831;
      and_851_s21_q <= and_851_s20_q;
      or_870_s21_q <= or_870_s20_q;
      or_873_s21_q <= or_873_s20_q;
      or_876_s21_q <= or_876_s20_q;
      equal_883_s21_q <= equal_883_s20_q;
      equal_884_s21_q <= equal_884_s20_q;
      and_894_s21_q <= and_894_s20_q;
      sum_899_s21_q <= sum_899;
      sum_910_s21_q <= sum_910;
      sum_920_s21_q <= sum_920;
      and_923_s21_q <= and_923_s20_q;
      select_932_s21_q <= select_932_s20_q;
      textured_2_s21_q <= textured_2;
      or_976_s21_q <= or_976_s20_q;
      or_979_s21_q <= or_979_s20_q;
      or_982_s21_q <= or_982_s20_q;
      explained_2_s21_q <= explained_2;
      near_2_s21_q <= near_2;
      and_1029_s21_q <= and_1029_s20_q;
      size_2_s21_q <= size_2;
      size_3_s21_q <= size_3;
      sum_1124_s21_q <= {1'b0, sum_1120} + {1'b0, sum_1123};
      sum_1127_s21_q <= {9'h0, difference_1125_s20_q} + {1'b0, xor_1126_s20_q};
      sum_1131_s21_q <= {9'h0, difference_1129_s20_q} + {1'b0, xor_1130_s20_q};
      sum_1135_s21_q <= {9'h0, difference_1133_s20_q} + {1'b0, xor_1134_s20_q};
      equal_1143_s21_q <= equal_1143_s20_q;
      contrast_s21_q <= contrast;
      contrast_2_s21_q <= contrast_2;
      equal_1194_s21_q <= equal_1194_s20_q;
      not_1240_s21_q <= not_1240_s20_q;
      and_1327_s21_q <= and_1327_s20_q;
      and_1332_s21_q <= and_1332_s20_q;
      and_1337_s21_q <= and_1337_s20_q;
      and_1342_s21_q <= and_1342_s20_q;
      and_1347_s21_q <= and_1347_s20_q;
      or_1352_s21_q <= (x_s20_q[7:1] == 7'h0) | (~centres_values_1_q);
      select_1361_s21_q <= less_1360 ? 12'h0 : regions_rdata_s20_q[11:0];
      select_1364_s21_q <= select_1364;
      and_1411_s21_q <= and_1411_s20_q;
      equal_1414_s21_q <= equal_1414_s20_q;
      equal_1415_s21_q <= equal_1415_s20_q;
      equal_1416_s21_q <= equal_1416_s20_q;
      residual_s21_q <= residual_s20_q;
      select_1549_s21_q <= drew_s20_q ? select_1548 : 2'h0;
      to_up_2_s21_q <= to_up_2;
      select_1566_s21_q <= drew_s20_q ? select_1565 : 2'h0;
      to_up_3_s21_q <= to_up_3;
      select_1583_s21_q <= drew_s20_q ? select_1582 : 2'h0;
      to_up_4_s21_q <= to_up_4;
      select_1599_s21_q <= drew_s20_q ? select_1598 : 2'h0;
      to_up_5_s21_q <= to_up_5;
      select_1616_s21_q <= drew_s20_q ? select_1615 : 2'h0;
      select_1633_s21_q <= drew_s20_q ? select_1632 : 2'h0;
      select_1649_s21_q <= drew_s20_q ? select_1648 : 2'h0;
      to_up_8_s21_q <= to_up_8;
      select_1665_s21_q <= drew_s20_q ? select_1664 : 2'h0;
      to_up_9_s21_q <= to_up_9;
      less_1740_s21_q <= $signed(24'h0) < $signed(counts_too_little_explained_q);
      sum_1743_s21_q <= {1'b0, select_1364} + {2'h0, select_1364[11:1]};
      less_1757_s21_q <= $signed(24'h0) < $signed(counts_too_much_hidden_q);
      equal_1846_s21_q <= equal_1846_s20_q;
      less_1949_s21_q <= 11'h4 < sum_1948_s20_q;
      less_1952_s21_q <= less_1952_s20_q;
      or_1955_s21_q <= or_1955;
      less_1957_s21_q <= 11'he < right[12:2];
      less_1959_s21_q <= less_1959;
      select_1960_s21_q <= or_1955 ? less_1954 : less_1959;
      less_1963_s21_q <= less_1963_s20_q;
      less_1965_s21_q <= $signed(15'h0) < $signed(counts_half_votes_1_up_q);
      less_1975_s21_q <= less_1975_s20_q;
      and_2124_s21_q <= and_2124_s20_q;
      select_2143_s21_q <= drew_s20_q ? 12'h0 : (equal_883_s20_q ? select_2141 : 12'h0);
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_textured_q;
  logic [14:0] counts_votes_1_down_q;
  logic [14:0] counts_votes_1_up_q;
  logic [14:0] counts_votes_2_down_q;
  logic [14:0] counts_votes_2_up_q;
  logic [14:0] counts_votes_3_down_q;
  logic [14:0] counts_votes_3_up_q;
  logic [14:0] counts_votes_4_down_q;
  logic [14:0] counts_votes_4_up_q;
  logic [14:0] counts_half_votes_0_down_q;
  logic [14:0] counts_half_votes_1_down_q;
  logic [14:0] counts_half_votes_2_down_q;
  logic [14:0] counts_half_votes_2_up_q;
  logic [14:0] counts_half_votes_3_down_q;
  logic [14:0] counts_half_votes_3_up_q;
  logic [4:0] box_textured_columns_values_0_q;
  logic [4:0] box_textured_columns_values_1_q;
  logic [4:0] box_textured_columns_values_2_q;
  logic [4:0] box_textured_columns_values_3_q;
  logic [4:0] box_textured_columns_values_4_q;
  logic [4:0] box_explained_columns_values_0_q;
  logic [4:0] box_explained_columns_values_1_q;
  logic [4:0] box_explained_columns_values_2_q;
  logic [4:0] box_explained_columns_values_3_q;
  logic [4:0] box_explained_columns_values_4_q;
  logic [4:0] box_nearer_columns_values_0_q;
  logic [4:0] box_nearer_columns_values_1_q;
  logic [4:0] box_nearer_columns_values_2_q;
  logic [4:0] box_nearer_columns_values_3_q;
  logic [4:0] box_nearer_columns_values_4_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:239
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s21_q & whole_9_s21_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s21_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s21_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s21_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s21_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:182
  logic [10:0] sum_417;
  assign sum_417 = sum_413_s21_q + {1'b0, sum_416_s21_q};
  // hls/stages/agreement.hpp:443
  logic not_832;
  assign not_832 = ~difference_831_s21_q[9];
  logic [8:0] xor_833;
  assign xor_833 = twice_s21_q ^ {9{not_832}};
  logic [10:0] sum_834;
  assign sum_834 = {difference_831_s21_q[8:0], 1'b0, not_832} + {not_832, xor_833, not_832};
  // hls/stages/agreement.hpp:173
  logic next_row;
  assign next_row = select_932_s21_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:834
  logic [6:0] select_935;
  assign select_935 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:844
  logic equal_938;
  assign equal_938 = seen_x_q == 4'hf;
  // hls/stages/census.hpp:31
  logic not_945;
  assign not_945 = ~marks_first_s21_q;
  // hls/stages/agreement.hpp:683
  logic [4:0] difference_967;
  assign difference_967 = {2'h0, textured_2_s21_q} - (age_s21_q ? box_textured_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:684
  logic [4:0] difference_1000;
  assign difference_1000 = {2'h0, explained_2_s21_q} - (age_s21_q ? box_explained_columns_values_4_q : 5'h0);
  // hls/stages/agreement.hpp:685
  logic [4:0] difference_1014;
  assign difference_1014 = {2'h0, near_2_s21_q} - (age_s21_q ? box_nearer_columns_values_4_q : 5'h0);
  // hls/stages/census.hpp:125
  logic [13:0] detail;
  assign detail = {3'h0, size_2_s21_q} + (equal_333_s21_q ? 14'h0 : averager_detail_0_q);
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3_s21_q} + (equal_333_s21_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:173
  logic select_1101;
  assign select_1101 = and_330_s21_q ? census_columns_values_1_cell_2_mask_s21_q : census_columns_values_2_cell_2_mask_q;
  logic select_1104;
  assign select_1104 = and_330_s21_q ? census_columns_values_1_cell_3_mask_s21_q : census_columns_values_2_cell_3_mask_q;
  logic select_1107;
  assign select_1107 = and_330_s21_q ? census_columns_values_1_cell_4_mask_s21_q : census_columns_values_2_cell_4_mask_q;
  logic select_1108;
  assign select_1108 = and_330_s21_q ? census_columns_values_2_cell_0_mask_s21_q : census_columns_values_3_cell_0_mask_q;
  logic select_1111;
  assign select_1111 = and_330_s21_q ? census_columns_values_2_cell_1_mask_s21_q : census_columns_values_3_cell_1_mask_q;
  logic select_1112;
  assign select_1112 = and_330_s21_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_1115;
  assign select_1115 = and_330_s21_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:184
  logic [10:0] sum_1128;
  assign sum_1128 = sum_1124_s21_q + {1'b0, sum_1127_s21_q};
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1334;
  assign select_1334 = and_1327_s21_q ? 14'h0 : (counts_supervised_q + {13'h0, and_1332_s21_q});
  logic [13:0] select_1339;
  assign select_1339 = and_1327_s21_q ? 14'h0 : (counts_textured_q + {13'h0, and_1337_s21_q});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_2;
  assign to_down_2 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1549_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1553;
  assign select_1553 = and_1327_s21_q ? 15'h0 : (counts_votes_1_down_q + {{13{to_down_2[1]}}, to_down_2});
  logic [14:0] select_1562;
  assign select_1562 = and_1327_s21_q ? 15'h0 : (counts_votes_1_up_q + {{13{to_up_2_s21_q[1]}}, to_up_2_s21_q});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_3;
  assign to_down_3 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1566_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1570;
  assign select_1570 = and_1327_s21_q ? 15'h0 : (counts_votes_2_down_q + {{13{to_down_3[1]}}, to_down_3});
  logic [14:0] select_1578;
  assign select_1578 = and_1327_s21_q ? 15'h0 : (counts_votes_2_up_q + {{13{to_up_3_s21_q[1]}}, to_up_3_s21_q});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_4;
  assign to_down_4 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1583_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1587;
  assign select_1587 = and_1327_s21_q ? 15'h0 : (counts_votes_3_down_q + {{13{to_down_4[1]}}, to_down_4});
  logic [14:0] select_1595;
  assign select_1595 = and_1327_s21_q ? 15'h0 : (counts_votes_3_up_q + {{13{to_up_4_s21_q[1]}}, to_up_4_s21_q});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_5;
  assign to_down_5 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1599_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1603;
  assign select_1603 = and_1327_s21_q ? 15'h0 : (counts_votes_4_down_q + {{13{to_down_5[1]}}, to_down_5});
  logic [14:0] select_1611;
  assign select_1611 = and_1327_s21_q ? 15'h0 : (counts_votes_4_up_q + {{13{to_up_5_s21_q[1]}}, to_up_5_s21_q});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_6;
  assign to_down_6 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1616_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1620;
  assign select_1620 = and_1327_s21_q ? 15'h0 : (counts_half_votes_0_down_q + {{13{to_down_6[1]}}, to_down_6});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_7;
  assign to_down_7 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1633_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1637;
  assign select_1637 = and_1327_s21_q ? 15'h0 : (counts_half_votes_1_down_q + {{13{to_down_7[1]}}, to_down_7});
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_8;
  assign to_down_8 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1649_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1653;
  assign select_1653 = and_1327_s21_q ? 15'h0 : (counts_half_votes_2_down_q + {{13{to_down_8[1]}}, to_down_8});
  // hls/stages/agreement.hpp:499
  logic [14:0] sum_1660;
  assign sum_1660 = counts_half_votes_2_up_q + {{13{to_up_8_s21_q[1]}}, to_up_8_s21_q};
  // hls/stages/agreement.hpp:298
  logic [1:0] to_down_9;
  assign to_down_9 = equal_342_s21_q ? 2'h0 : (equal_344_s21_q ? 2'h0 : select_1665_s21_q);
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1669;
  assign select_1669 = and_1327_s21_q ? 15'h0 : (counts_half_votes_3_down_q + {{13{to_down_9[1]}}, to_down_9});
  // hls/stages/agreement.hpp:499
  logic [14:0] sum_1676;
  assign sum_1676 = counts_half_votes_3_up_q + {{13{to_up_9_s21_q[1]}}, to_up_9_s21_q};
  // hls/stages/agreement.hpp:712
  logic and_1739;
  assign and_1739 = (~({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q})) & (11'h4 < counts_textured_q[13:3]);
  // hls/stages/agreement.hpp:719
  logic less_1744;
  assign less_1744 = {sum_1743_s21_q, select_1364_s21_q[0]} < {2'h0, select_1361_s21_q};
  logic select_1746;
  assign select_1746 = (select_1361_s21_q[11:3] == 9'h0) ? (and_1739 & (~less_1740_s21_q)) : (~less_1744);
  // hls/stages/agreement.hpp:298
  logic [4:0] select_1786;
  assign select_1786 = drew_s21_q ? {2'h0, textured_2_s21_q} : box_textured_columns_values_0_q;
  logic [4:0] select_1788;
  assign select_1788 = equal_342_s21_q ? box_textured_columns_values_0_q : (equal_344_s21_q ? box_textured_columns_values_0_q : select_1786);
  logic [4:0] select_1789;
  assign select_1789 = drew_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [4:0] select_1791;
  assign select_1791 = equal_342_s21_q ? box_textured_columns_values_1_q : (equal_344_s21_q ? box_textured_columns_values_1_q : select_1789);
  logic [4:0] select_1792;
  assign select_1792 = drew_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [4:0] select_1794;
  assign select_1794 = equal_342_s21_q ? box_textured_columns_values_2_q : (equal_344_s21_q ? box_textured_columns_values_2_q : select_1792);
  logic [4:0] select_1795;
  assign select_1795 = drew_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [4:0] select_1797;
  assign select_1797 = equal_342_s21_q ? box_textured_columns_values_3_q : (equal_344_s21_q ? box_textured_columns_values_3_q : select_1795);
  logic [4:0] select_1798;
  assign select_1798 = drew_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [4:0] select_1800;
  assign select_1800 = equal_342_s21_q ? box_textured_columns_values_4_q : (equal_344_s21_q ? box_textured_columns_values_4_q : select_1798);
  logic [4:0] select_1804;
  assign select_1804 = drew_s21_q ? {2'h0, explained_2_s21_q} : box_explained_columns_values_0_q;
  logic [4:0] select_1806;
  assign select_1806 = equal_342_s21_q ? box_explained_columns_values_0_q : (equal_344_s21_q ? box_explained_columns_values_0_q : select_1804);
  logic [4:0] select_1807;
  assign select_1807 = drew_s21_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [4:0] select_1809;
  assign select_1809 = equal_342_s21_q ? box_explained_columns_values_1_q : (equal_344_s21_q ? box_explained_columns_values_1_q : select_1807);
  logic [4:0] select_1810;
  assign select_1810 = drew_s21_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [4:0] select_1812;
  assign select_1812 = equal_342_s21_q ? box_explained_columns_values_2_q : (equal_344_s21_q ? box_explained_columns_values_2_q : select_1810);
  logic [4:0] select_1813;
  assign select_1813 = drew_s21_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [4:0] select_1815;
  assign select_1815 = equal_342_s21_q ? box_explained_columns_values_3_q : (equal_344_s21_q ? box_explained_columns_values_3_q : select_1813);
  logic [4:0] select_1816;
  assign select_1816 = drew_s21_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [4:0] select_1818;
  assign select_1818 = equal_342_s21_q ? box_explained_columns_values_4_q : (equal_344_s21_q ? box_explained_columns_values_4_q : select_1816);
  logic [4:0] select_1822;
  assign select_1822 = drew_s21_q ? {2'h0, near_2_s21_q} : box_nearer_columns_values_0_q;
  logic [4:0] select_1824;
  assign select_1824 = equal_342_s21_q ? box_nearer_columns_values_0_q : (equal_344_s21_q ? box_nearer_columns_values_0_q : select_1822);
  logic [4:0] select_1825;
  assign select_1825 = drew_s21_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [4:0] select_1827;
  assign select_1827 = equal_342_s21_q ? box_nearer_columns_values_1_q : (equal_344_s21_q ? box_nearer_columns_values_1_q : select_1825);
  logic [4:0] select_1828;
  assign select_1828 = drew_s21_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [4:0] select_1830;
  assign select_1830 = equal_342_s21_q ? box_nearer_columns_values_2_q : (equal_344_s21_q ? box_nearer_columns_values_2_q : select_1828);
  logic [4:0] select_1831;
  assign select_1831 = drew_s21_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [4:0] select_1833;
  assign select_1833 = equal_342_s21_q ? box_nearer_columns_values_3_q : (equal_344_s21_q ? box_nearer_columns_values_3_q : select_1831);
  logic [4:0] select_1834;
  assign select_1834 = drew_s21_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [4:0] select_1836;
  assign select_1836 = equal_342_s21_q ? box_nearer_columns_values_4_q : (equal_344_s21_q ? box_nearer_columns_values_4_q : select_1834);
  // hls/stages/agreement.hpp:843
  logic [3:0] select_1866;
  assign select_1866 = select_932_s21_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:173
  logic [7:0] select_1872;
  assign select_1872 = marks_first_s21_q ? (less_1868 ? {sum_1869, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:790
  logic select_1961;
  assign select_1961 = less_1949_s21_q ? select_1960_s21_q : less_1959_s21_q;
  logic or_1962;
  assign or_1962 = (~less_1957_s21_q) | select_1961;
  logic select_1966;
  assign select_1966 = or_1962 ? select_1961 : less_1965_s21_q;
  logic select_1968;
  assign select_1968 = less_1949_s21_q ? select_1966 : (less_1952_s21_q ? select_1966 : less_1965_s21_q);
  // hls/stages/agreement.hpp:731
  logic and_1994;
  assign and_1994 = ($signed(15'h0) < $signed(counts_votes_3_up_q)) & ($signed(15'h0) < $signed(counts_votes_4_down_q));
  logic select_1996;
  assign select_1996 = ($signed(15'h0) < $signed(counts_votes_3_down_q)) ? (($signed(15'h0) < $signed(counts_votes_4_up_q)) | and_1994) : and_1994;
  // hls/stages/agreement.hpp:298
  logic [11:0] select_2145;
  assign select_2145 = equal_342_s21_q ? 12'h0 : (equal_344_s21_q ? 12'h0 : select_2143_s21_q);

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s21_q, or_876_s21_q, or_873_s21_q, or_870_s21_q};
  logic regions_we;
  assign regions_we = s21_en & and_923_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_920_s21_q, sum_910_s21_q, sum_899_s21_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s19_sim;
  logic regions_re_s19_sim;
  logic [5:0] regions_raddr_s20_sim;
  logic regions_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s19_sim <= 1'b0;
      regions_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s19_sim <= regions_re;
      regions_raddr_s19_sim <= regions_raddr;
      regions_re_s20_sim <= regions_re_s19_sim;
      regions_raddr_s20_sim <= regions_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s19_sim && regions_raddr_s19_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s20_sim && regions_raddr_s20_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_supervised_q <= 14'h0;
      counts_textured_q <= 14'h0;
      counts_votes_1_down_q <= 15'h0;
      counts_votes_1_up_q <= 15'h0;
      counts_votes_2_down_q <= 15'h0;
      counts_votes_2_up_q <= 15'h0;
      counts_votes_3_down_q <= 15'h0;
      counts_votes_3_up_q <= 15'h0;
      counts_votes_4_down_q <= 15'h0;
      counts_votes_4_up_q <= 15'h0;
      counts_half_votes_0_down_q <= 15'h0;
      counts_half_votes_1_down_q <= 15'h0;
      counts_half_votes_2_down_q <= 15'h0;
      counts_half_votes_2_up_q <= 15'h0;
      counts_half_votes_3_down_q <= 15'h0;
      counts_half_votes_3_up_q <= 15'h0;
      began_q <= 1'b0;
      seen_x_q <= 4'h0;
      seen_y_q <= 4'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s21_en) begin
      counts_supervised_q <= select_1334;
      counts_textured_q <= select_1339;
      counts_votes_1_down_q <= select_1553;
      counts_votes_1_up_q <= select_1562;
      counts_votes_2_down_q <= select_1570;
      counts_votes_2_up_q <= select_1578;
      counts_votes_3_down_q <= select_1587;
      counts_votes_3_up_q <= select_1595;
      counts_votes_4_down_q <= select_1603;
      counts_votes_4_up_q <= select_1611;
      counts_half_votes_0_down_q <= select_1620;
      counts_half_votes_1_down_q <= select_1637;
      counts_half_votes_2_down_q <= select_1653;
      counts_half_votes_2_up_q <= and_1327_s21_q ? 15'h0 : sum_1660;
      counts_half_votes_3_down_q <= select_1669;
      counts_half_votes_3_up_q <= and_1327_s21_q ? 15'h0 : sum_1676;
      began_q <= not_945 & (began_q | select_932_s21_q);
      seen_x_q <= select_932_s21_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s21_q ? 4'h0 : select_1866;
      seen_column_q <= select_932_s21_q ? 8'h0 : (seen_column_q + {7'h0, equal_938});
      seen_rows_left_q <= select_1872;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s21_q ? 13'h0 : (seen_base_q + {6'h0, select_935});
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    box_textured_columns_values_0_q = 5'h0;
    box_textured_columns_values_1_q = 5'h0;
    box_textured_columns_values_2_q = 5'h0;
    box_textured_columns_values_3_q = 5'h0;
    box_textured_columns_values_4_q = 5'h0;
    box_explained_columns_values_0_q = 5'h0;
    box_explained_columns_values_1_q = 5'h0;
    box_explained_columns_values_2_q = 5'h0;
    box_explained_columns_values_3_q = 5'h0;
    box_explained_columns_values_4_q = 5'h0;
    box_nearer_columns_values_0_q = 5'h0;
    box_nearer_columns_values_1_q = 5'h0;
    box_nearer_columns_values_2_q = 5'h0;
    box_nearer_columns_values_3_q = 5'h0;
    box_nearer_columns_values_4_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s21_en) begin
      averager_detail_0_q <= and_329_s21_q ? detail : averager_detail_0_q;
      averager_detail_1_q <= and_329_s21_q ? detail_2 : averager_detail_1_q;
      census_columns_values_2_cell_2_mask_q <= select_1101;
      census_columns_values_2_cell_3_mask_q <= select_1104;
      census_columns_values_2_cell_4_mask_q <= select_1107;
      census_columns_values_3_cell_0_mask_q <= select_1108;
      census_columns_values_3_cell_1_mask_q <= select_1111;
      census_columns_values_3_cell_2_mask_q <= select_1112;
      census_columns_values_3_cell_3_mask_q <= select_1115;
      box_textured_columns_values_0_q <= select_1788;
      box_textured_columns_values_1_q <= select_1791;
      box_textured_columns_values_2_q <= select_1794;
      box_textured_columns_values_3_q <= select_1797;
      box_textured_columns_values_4_q <= select_1800;
      box_explained_columns_values_0_q <= select_1806;
      box_explained_columns_values_1_q <= select_1809;
      box_explained_columns_values_2_q <= select_1812;
      box_explained_columns_values_3_q <= select_1815;
      box_explained_columns_values_4_q <= select_1818;
      box_nearer_columns_values_0_q <= select_1824;
      box_nearer_columns_values_1_q <= select_1827;
      box_nearer_columns_values_2_q <= select_1830;
      box_nearer_columns_values_3_q <= select_1833;
      box_nearer_columns_values_4_q <= select_1836;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic census_columns_values_2_cell_4_mask_s22_q;
  logic census_columns_values_3_cell_0_mask_s22_q;
  logic census_columns_values_3_cell_1_mask_s22_q;
  logic census_columns_values_3_cell_2_mask_s22_q;
  logic census_columns_values_3_cell_3_mask_s22_q;
  logic [5:0] x_s22_q;
  logic [13:0] counts_supervised_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [11:0] counts_measured_0_s22_q;
  logic [11:0] counts_measured_1_s22_q;
  logic [11:0] counts_measured_2_s22_q;
  logic [11:0] counts_measured_3_s22_q;
  logic [2:0] region_row_s22_q;
  logic [6:0] select_298_s22_q;
  logic and_330_s22_q;
  logic whole_2_s22_q;
  logic equal_342_s22_q;
  logic not_343_s22_q;
  logic equal_344_s22_q;
  logic less_345_s22_q;
  logic not_346_s22_q;
  logic less_350_s22_q;
  logic less_351_s22_q;
  logic less_352_s22_q;
  logic less_353_s22_q;
  logic less_354_s22_q;
  logic less_355_s22_q;
  logic less_356_s22_q;
  logic less_357_s22_q;
  logic less_358_s22_q;
  logic less_359_s22_q;
  logic less_360_s22_q;
  logic less_361_s22_q;
  logic less_362_s22_q;
  logic less_363_s22_q;
  logic less_364_s22_q;
  logic less_365_s22_q;
  logic less_366_s22_q;
  logic less_367_s22_q;
  logic less_368_s22_q;
  logic less_369_s22_q;
  logic less_370_s22_q;
  logic less_371_s22_q;
  logic less_372_s22_q;
  logic less_373_s22_q;
  logic and_380_s22_q;
  logic whole_16_s22_q;
  logic and_406_s22_q;
  logic [11:0] sum_421_s22_q;
  logic [9:0] sum_424_s22_q;
  logic drew_s22_q;
  logic [6:0] x_s22_2_q;
  logic not_484_s22_q;
  logic [7:0] best_left_rdata_s22_q;
  logic equal_489_s22_q;
  logic select_785_s22_q;
  logic less_791_s22_q;
  logic less_792_s22_q;
  logic or_794_s22_q;
  logic [7:0] select_798_s22_q;
  logic [5:0] select_802_s22_q;
  logic equal_807_s22_q;
  logic difference_818_s22_q;
  logic [1:0] sum_819_s22_q;
  logic [8:0] twice_s22_q;
  logic difference_831_s22_q;
  logic [10:0] sum_834_s22_q;
  logic and_851_s22_q;
  logic equal_883_s22_q;
  logic equal_884_s22_q;
  logic and_894_s22_q;
  logic not_945_s22_q;
  logic [7:0] sum_955_s22_q;
  logic [4:0] difference_967_s22_q;
  logic equal_968_s22_q;
  logic or_976_s22_q;
  logic or_979_s22_q;
  logic or_982_s22_q;
  logic [4:0] difference_1000_s22_q;
  logic [4:0] difference_1014_s22_q;
  logic and_1029_s22_q;
  logic [13:0] detail_s22_q;
  logic [13:0] detail_2_s22_q;
  logic [11:0] sum_1132_s22_q;
  logic [9:0] sum_1135_s22_q;
  logic equal_1143_s22_q;
  logic [8:0] contrast_s22_q;
  logic [8:0] contrast_2_s22_q;
  logic equal_1194_s22_q;
  logic not_1240_s22_q;
  logic and_1327_s22_q;
  logic and_1342_s22_q;
  logic and_1347_s22_q;
  logic or_1352_s22_q;
  logic [11:0] select_1361_s22_q;
  logic [11:0] select_1364_s22_q;
  logic and_1411_s22_q;
  logic equal_1414_s22_q;
  logic equal_1415_s22_q;
  logic equal_1416_s22_q;
  logic [7:0] residual_s22_q;
  logic and_1739_s22_q;
  logic less_1740_s22_q;
  logic select_1746_s22_q;
  logic less_1757_s22_q;
  logic equal_1846_s22_q;
  logic less_1949_s22_q;
  logic less_1952_s22_q;
  logic or_1955_s22_q;
  logic less_1957_s22_q;
  logic or_1962_s22_q;
  logic less_1963_s22_q;
  logic select_1968_s22_q;
  logic less_1970_s22_q;
  logic less_1975_s22_q;
  logic less_1978_s22_q;
  logic less_1985_s22_q;
  logic less_1986_s22_q;
  logic less_1987_s22_q;
  logic less_1988_s22_q;
  logic and_1989_s22_q;
  logic select_1996_s22_q;
  logic less_2004_s22_q;
  logic less_2007_s22_q;
  logic less_2010_s22_q;
  logic less_2013_s22_q;
  logic and_2124_s22_q;
  logic [11:0] select_2145_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      census_columns_values_2_cell_4_mask_s22_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s22_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s22_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s22_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s22_q <= census_columns_values_3_cell_3_mask_q;
      x_s22_q <= x_s21_q[5:0];
      counts_supervised_s22_q <= counts_supervised_q;
      counts_textured_s22_q <= counts_textured_q;
      counts_measured_0_s22_q <= counts_measured_0_s21_q;
      counts_measured_1_s22_q <= counts_measured_1_s21_q;
      counts_measured_2_s22_q <= counts_measured_2_s21_q;
      counts_measured_3_s22_q <= counts_measured_3_s21_q;
      region_row_s22_q <= region_row_s21_q;
      select_298_s22_q <= select_298_s21_q;
      and_330_s22_q <= and_330_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      equal_342_s22_q <= equal_342_s21_q;
      not_343_s22_q <= not_343_s21_q;
      equal_344_s22_q <= equal_344_s21_q;
      less_345_s22_q <= less_345_s21_q;
      not_346_s22_q <= not_346_s21_q;
      less_350_s22_q <= less_350_s21_q;
      less_351_s22_q <= less_351_s21_q;
      less_352_s22_q <= less_352_s21_q;
      less_353_s22_q <= less_353_s21_q;
      less_354_s22_q <= less_354_s21_q;
      less_355_s22_q <= less_355_s21_q;
      less_356_s22_q <= less_356_s21_q;
      less_357_s22_q <= less_357_s21_q;
      less_358_s22_q <= less_358_s21_q;
      less_359_s22_q <= less_359_s21_q;
      less_360_s22_q <= less_360_s21_q;
      less_361_s22_q <= less_361_s21_q;
      less_362_s22_q <= less_362_s21_q;
      less_363_s22_q <= less_363_s21_q;
      less_364_s22_q <= less_364_s21_q;
      less_365_s22_q <= less_365_s21_q;
      less_366_s22_q <= less_366_s21_q;
      less_367_s22_q <= less_367_s21_q;
      less_368_s22_q <= less_368_s21_q;
      less_369_s22_q <= less_369_s21_q;
      less_370_s22_q <= less_370_s21_q;
      less_371_s22_q <= less_371_s21_q;
      less_372_s22_q <= less_372_s21_q;
      less_373_s22_q <= less_373_s21_q;
      and_380_s22_q <= and_380_s21_q;
      whole_16_s22_q <= whole_16;
      and_406_s22_q <= census_columns_values_1_cell_2_mask_s21_q & and_380_s21_q;
      sum_421_s22_q <= {1'b0, sum_417} + {2'h0, sum_420_s21_q};
      sum_424_s22_q <= sum_424_s21_q;
      drew_s22_q <= drew_s21_q;
      x_s22_2_q <= x_s21_2_q;
      not_484_s22_q <= not_484_s21_q;
      best_left_rdata_s22_q <= best_left_rdata_s21_q;
      equal_489_s22_q <= equal_489_s21_q;
      select_785_s22_q <= select_785_s21_q;
      less_791_s22_q <= less_791_s21_q;
      less_792_s22_q <= less_792_s21_q;
      or_794_s22_q <= or_794_s21_q;
      select_798_s22_q <= select_798_s21_q;
      select_802_s22_q <= select_802_s21_q;
      equal_807_s22_q <= equal_807_s21_q;
      difference_818_s22_q <= difference_818_s21_q;
      sum_819_s22_q <= sum_819_s21_q;
      twice_s22_q <= twice_s21_q;
      difference_831_s22_q <= difference_831_s21_q[9];
      sum_834_s22_q <= sum_834;
      and_851_s22_q <= and_851_s21_q;
      equal_883_s22_q <= equal_883_s21_q;
      equal_884_s22_q <= equal_884_s21_q;
      and_894_s22_q <= and_894_s21_q;
      not_945_s22_q <= not_945;
      sum_955_s22_q <= {2'h0, x_s21_q[7:2]} + 8'hff;
      difference_967_s22_q <= difference_967;
      equal_968_s22_q <= x_s21_q == 8'h0;
      or_976_s22_q <= or_976_s21_q;
      or_979_s22_q <= or_979_s21_q;
      or_982_s22_q <= or_982_s21_q;
      difference_1000_s22_q <= difference_1000;
      difference_1014_s22_q <= difference_1014;
      and_1029_s22_q <= and_1029_s21_q;
      detail_s22_q <= detail;
      detail_2_s22_q <= detail_2;
      sum_1132_s22_q <= {1'b0, sum_1128} + {2'h0, sum_1131_s21_q};
      sum_1135_s22_q <= sum_1135_s21_q;
      equal_1143_s22_q <= equal_1143_s21_q;
      contrast_s22_q <= contrast_s21_q;
      contrast_2_s22_q <= contrast_2_s21_q;
      equal_1194_s22_q <= equal_1194_s21_q;
      not_1240_s22_q <= not_1240_s21_q;
      and_1327_s22_q <= and_1327_s21_q;
      and_1342_s22_q <= and_1342_s21_q;
      and_1347_s22_q <= and_1347_s21_q;
      or_1352_s22_q <= or_1352_s21_q;
      select_1361_s22_q <= select_1361_s21_q;
      select_1364_s22_q <= select_1364_s21_q;
      and_1411_s22_q <= and_1411_s21_q;
      equal_1414_s22_q <= equal_1414_s21_q;
      equal_1415_s22_q <= equal_1415_s21_q;
      equal_1416_s22_q <= equal_1416_s21_q;
      residual_s22_q <= residual_s21_q;
      and_1739_s22_q <= and_1739;
      less_1740_s22_q <= less_1740_s21_q;
      select_1746_s22_q <= select_1746;
      less_1757_s22_q <= less_1757_s21_q;
      equal_1846_s22_q <= equal_1846_s21_q;
      less_1949_s22_q <= less_1949_s21_q;
      less_1952_s22_q <= less_1952_s21_q;
      or_1955_s22_q <= or_1955_s21_q;
      less_1957_s22_q <= less_1957_s21_q;
      or_1962_s22_q <= or_1962;
      less_1963_s22_q <= less_1963_s21_q;
      select_1968_s22_q <= select_1968;
      less_1970_s22_q <= $signed(15'h0) < $signed(counts_half_votes_2_up_q);
      less_1975_s22_q <= less_1975_s21_q;
      less_1978_s22_q <= $signed(15'h0) < $signed(counts_half_votes_3_up_q);
      less_1985_s22_q <= $signed(15'h0) < $signed(counts_votes_1_down_q);
      less_1986_s22_q <= $signed(15'h0) < $signed(counts_votes_2_up_q);
      less_1987_s22_q <= $signed(15'h0) < $signed(counts_votes_1_up_q);
      less_1988_s22_q <= $signed(15'h0) < $signed(counts_votes_2_down_q);
      and_1989_s22_q <= less_1963_s21_q & less_1975_s21_q;
      select_1996_s22_q <= select_1996;
      less_2004_s22_q <= $signed(15'h0) < $signed(counts_half_votes_3_down_q);
      less_2007_s22_q <= $signed(15'h0) < $signed(counts_half_votes_2_down_q);
      less_2010_s22_q <= $signed(15'h0) < $signed(counts_half_votes_1_down_q);
      less_2013_s22_q <= $signed(15'h0) < $signed(counts_half_votes_0_down_q);
      and_2124_s22_q <= and_2124_s21_q;
      select_2145_s22_q <= select_2145;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic sharpness_last_mask_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [47:0] good_next_q;
  logic begins_product_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic said_q;
  // hls/stages/agreement.hpp:239
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s22_q & whole_16_s22_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s22_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s22_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s22_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s22_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:182
  logic [11:0] texture;
  assign texture = sum_421_s22_q + {2'h0, sum_424_s22_q};
  // hls/stages/agreement.hpp:443
  logic not_835;
  assign not_835 = ~sum_834_s22_q[10];
  logic [8:0] xor_836;
  assign xor_836 = twice_s22_q ^ {9{not_835}};
  // hls/stages/agreement.hpp:847
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:818
  logic select_943;
  assign select_943 = marks_first_s22_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:804
  logic [10:0] sum_944;
  assign sum_944 = {1'b0, {5{select_943}}, 1'b0, {2{select_943}}, 1'b0, select_943} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:697
  logic [12:0] index_2;
  assign index_2 = {{3{sum_955_s22_q[7]}}, sum_955_s22_q, x_s22_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:804
  logic [10:0] sum_957;
  assign sum_957 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:683
  logic [4:0] t;
  assign t = difference_967_s22_q + (equal_968_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:689
  logic not_983;
  assign not_983 = ~region_row_s22_q[2];
  logic [2:0] select_984;
  assign select_984 = region_row_s22_q[1] ? {1'b0, not_983, 1'b0} : {region_row_s22_q[2], 1'b0, not_983};
  logic [5:0] select_985;
  assign select_985 = region_row_s22_q[0] ? {select_984[2], 1'b0, select_984[1], 1'b0, select_984[0], 1'b0} : {1'b0, select_984[2], 1'b0, select_984[1], 1'b0, select_984[0]};
  logic [11:0] select_986;
  assign select_986 = or_982_s22_q ? {select_985[5], 1'b0, select_985[4], 1'b0, select_985[3], 1'b0, select_985[2], 1'b0, select_985[1], 1'b0, select_985[0], 1'b0} : {1'b0, select_985[5], 1'b0, select_985[4], 1'b0, select_985[3], 1'b0, select_985[2], 1'b0, select_985[1], 1'b0, select_985[0]};
  logic [23:0] select_987;
  assign select_987 = or_979_s22_q ? {select_986[11], 1'b0, select_986[10], 1'b0, select_986[9], 1'b0, select_986[8], 1'b0, select_986[7], 1'b0, select_986[6], 1'b0, select_986[5], 1'b0, select_986[4], 1'b0, select_986[3], 1'b0, select_986[2], 1'b0, select_986[1], 1'b0, select_986[0], 1'b0} : {1'b0, select_986[11], 1'b0, select_986[10], 1'b0, select_986[9], 1'b0, select_986[8], 1'b0, select_986[7], 1'b0, select_986[6], 1'b0, select_986[5], 1'b0, select_986[4], 1'b0, select_986[3], 1'b0, select_986[2], 1'b0, select_986[1], 1'b0, select_986[0]};
  // hls/stages/agreement.hpp:684
  logic [4:0] e;
  assign e = difference_1000_s22_q + (equal_968_s22_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:685
  logic [4:0] n;
  assign n = difference_1014_s22_q + (equal_968_s22_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:173
  logic select_1116;
  assign select_1116 = and_330_s22_q ? census_columns_values_2_cell_4_mask_s22_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:184
  logic [11:0] sum_1136;
  assign sum_1136 = sum_1132_s22_q + {2'h0, sum_1135_s22_q};
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1138;
  assign select_1138 = and_330_s22_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_1139;
  assign select_1139 = and_330_s22_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/census.hpp:265
  logic and_1161;
  assign and_1161 = whole_2_s22_q & (~(select_298_s22_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:240
  logic and_1167;
  assign and_1167 = and_1161 & (sharpness_last_mask_q & (7'h2 < contrast_s22_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, detail_s22_q};
  // hls/stages/agreement.hpp:240
  logic and_1178;
  assign and_1178 = and_1161 & (sharpness_last_mask_q & (7'h2 < contrast_2_s22_q[8:2]));
  // hls/stages/census.hpp:264
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, detail_2_s22_q};
  // hls/stages/agreement.hpp:717
  logic [12:0] sum_1365;
  assign sum_1365 = {1'b0, select_1364_s22_q} + {3'h0, select_1364_s22_q[11:2]};
  // hls/stages/agreement.hpp:727
  logic equal_1734;
  assign equal_1734 = x_s22_q == 6'h3f;
  logic [47:0] select_1747;
  assign select_1747 = equal_884_s22_q ? good_next_q : {select_1746_s22_q, good_next_q[47:1]};
  // hls/stages/agreement.hpp:298
  logic [47:0] select_1754;
  assign select_1754 = drew_s22_q ? good_next_q : (equal_883_s22_q ? select_1747 : good_next_q);
  logic [47:0] select_1756;
  assign select_1756 = equal_342_s22_q ? good_next_q : (equal_344_s22_q ? good_next_q : select_1754);
  logic [4:0] select_1802;
  assign select_1802 = equal_344_s22_q ? box_textured_sum_sums_values_0_q : (drew_s22_q ? t : box_textured_sum_sums_values_0_q);
  logic [4:0] select_1820;
  assign select_1820 = equal_344_s22_q ? box_explained_sum_sums_values_0_q : (drew_s22_q ? e : box_explained_sum_sums_values_0_q);
  logic [4:0] select_1821;
  assign select_1821 = equal_342_s22_q ? box_explained_sum_sums_values_0_q : select_1820;
  logic [4:0] select_1838;
  assign select_1838 = equal_344_s22_q ? box_nearer_sum_sums_values_0_q : (drew_s22_q ? n : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:243
  logic [12:0] select_1849;
  assign select_1849 = equal_1194_s22_q ? (equal_1846_s22_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:173
  logic [6:0] select_1852;
  assign select_1852 = and_330_s22_q ? (equal_1194_s22_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:298
  logic and_1862;
  assign and_1862 = not_484_s22_q & (not_1240_s22_q & (equal_883_s22_q & equal_1734));
  logic [13:0] select_1891;
  assign select_1891 = equal_883_s22_q ? (equal_1734 ? counts_supervised_s22_q : 14'h0) : 14'h0;
  logic [13:0] select_1894;
  assign select_1894 = equal_342_s22_q ? 14'h0 : (equal_344_s22_q ? 14'h0 : (drew_s22_q ? 14'h0 : select_1891));
  logic [13:0] select_1896;
  assign select_1896 = equal_883_s22_q ? (equal_1734 ? counts_textured_s22_q : 14'h0) : 14'h0;
  logic [13:0] select_1899;
  assign select_1899 = equal_342_s22_q ? 14'h0 : (equal_344_s22_q ? 14'h0 : (drew_s22_q ? 14'h0 : select_1896));
  // hls/stages/agreement.hpp:790
  logic or_1969;
  assign or_1969 = (~less_1963_s22_q) | select_1968_s22_q;
  logic select_1971;
  assign select_1971 = or_1969 ? select_1968_s22_q : less_1970_s22_q;
  logic select_1973;
  assign select_1973 = less_1952_s22_q ? select_1971 : (less_1957_s22_q ? select_1971 : less_1970_s22_q);
  // hls/stages/agreement.hpp:731
  logic and_1997;
  assign and_1997 = and_1989_s22_q & select_1996_s22_q;
  logic select_1999;
  assign select_1999 = less_1987_s22_q ? (less_1988_s22_q | and_1997) : and_1997;
  logic select_2002;
  assign select_2002 = (less_1952_s22_q & less_1957_s22_q) ? (less_1985_s22_q ? (less_1986_s22_q | select_1999) : select_1999) : and_1997;
  // hls/stages/agreement.hpp:298
  logic [11:0] select_2083;
  assign select_2083 = equal_883_s22_q ? (equal_1734 ? counts_measured_0_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2086;
  assign select_2086 = equal_342_s22_q ? 12'h0 : (equal_344_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2083));
  logic [11:0] select_2088;
  assign select_2088 = equal_883_s22_q ? (equal_1734 ? counts_measured_1_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2091;
  assign select_2091 = equal_342_s22_q ? 12'h0 : (equal_344_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2088));
  logic [11:0] select_2093;
  assign select_2093 = equal_883_s22_q ? (equal_1734 ? counts_measured_2_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2096;
  assign select_2096 = equal_342_s22_q ? 12'h0 : (equal_344_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2093));
  logic [11:0] select_2098;
  assign select_2098 = equal_883_s22_q ? (equal_1734 ? counts_measured_3_s22_q : 12'h0) : 12'h0;
  logic [11:0] select_2101;
  assign select_2101 = equal_342_s22_q ? 12'h0 : (equal_344_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2098));
  logic [5:0] select_2127;
  assign select_2127 = drew_s22_q ? 6'h0 : (equal_883_s22_q ? (equal_884_s22_q ? 6'h0 : x_s22_q) : 6'h0);
  logic [11:0] select_2136;
  assign select_2136 = equal_883_s22_q ? (equal_884_s22_q ? 12'h0 : select_1364_s22_q) : 12'h0;
  logic [11:0] select_2139;
  assign select_2139 = equal_342_s22_q ? 12'h0 : (equal_344_s22_q ? 12'h0 : (drew_s22_q ? 12'h0 : select_2136));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      good_next_q <= 48'h0;
      begins_product_q <= 1'b0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s22_en) begin
      good_next_q <= select_1756;
      begins_product_q <= drew_s22_q;
      map_row_q <= and_330_s22_q ? select_1849 : map_row_q;
      map_width_q <= select_1852;
      write_half_q <= marks_first_s22_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_943;
      done_q <= not_945_s22_q & ((~begins_product_q) & (done_q | said_q));
      said_q <= not_343_s22_q & and_1862;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_3_cell_4_mask_q = 1'b0;
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s22_en) begin
      census_columns_values_3_cell_4_mask_q <= select_1116;
      census_changes_values_0_left_q <= and_330_s22_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_330_s22_q ? sum_1136 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_1138;
      census_changes_values_1_right_q <= select_1139;
      sharpness_last_mask_q <= and_330_s22_q ? whole_2_s22_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_330_s22_q ? detail_s22_q : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_330_s22_q ? detail_2_s22_q : sharpness_last_detail_1_q;
      box_textured_sum_sums_values_0_q <= equal_342_s22_q ? box_textured_sum_sums_values_0_q : select_1802;
      box_explained_sum_sums_values_0_q <= select_1821;
      box_nearer_sum_sums_values_0_q <= equal_342_s22_q ? box_nearer_sum_sums_values_0_q : select_1838;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic [11:0] census_changes_values_1_left_s23_q;
  logic [11:0] census_changes_values_1_right_s23_q;
  logic begins_product_s23_q;
  logic done_s23_q;
  logic [6:0] select_298_s23_q;
  logic and_330_s23_q;
  logic equal_342_s23_q;
  logic not_343_s23_q;
  logic equal_344_s23_q;
  logic less_345_s23_q;
  logic not_346_s23_q;
  logic less_350_s23_q;
  logic less_351_s23_q;
  logic less_352_s23_q;
  logic less_353_s23_q;
  logic less_354_s23_q;
  logic less_355_s23_q;
  logic less_356_s23_q;
  logic less_357_s23_q;
  logic less_358_s23_q;
  logic less_359_s23_q;
  logic less_360_s23_q;
  logic less_361_s23_q;
  logic less_362_s23_q;
  logic less_363_s23_q;
  logic less_364_s23_q;
  logic less_365_s23_q;
  logic less_366_s23_q;
  logic less_367_s23_q;
  logic less_368_s23_q;
  logic less_369_s23_q;
  logic less_370_s23_q;
  logic less_371_s23_q;
  logic less_372_s23_q;
  logic less_373_s23_q;
  logic and_380_s23_q;
  logic and_405_s23_q;
  logic and_406_s23_q;
  logic [12:0] sum_426_s23_q;
  logic [6:0] x_s23_q;
  logic not_484_s23_q;
  logic [7:0] best_left_rdata_s23_q;
  logic equal_489_s23_q;
  logic select_785_s23_q;
  logic less_791_s23_q;
  logic less_792_s23_q;
  logic or_794_s23_q;
  logic [7:0] select_798_s23_q;
  logic [5:0] select_802_s23_q;
  logic equal_807_s23_q;
  logic difference_818_s23_q;
  logic [1:0] sum_819_s23_q;
  logic [8:0] twice_s23_q;
  logic difference_831_s23_q;
  logic sum_834_s23_q;
  logic [10:0] sum_837_s23_q;
  logic and_851_s23_q;
  logic equal_883_s23_q;
  logic equal_884_s23_q;
  logic and_894_s23_q;
  logic [2:0] index_s23_q;
  logic [10:0] sum_944_s23_q;
  logic and_951_s23_q;
  logic less_952_s23_q;
  logic [2:0] index_2_s23_q;
  logic [10:0] sum_957_s23_q;
  logic [4:0] t_s23_q;
  logic or_976_s23_q;
  logic [23:0] select_987_s23_q;
  logic [4:0] e_s23_q;
  logic less_1017_s23_q;
  logic and_1029_s23_q;
  logic equal_1143_s23_q;
  logic [12:0] sum_1144_s23_q;
  logic [12:0] select_1169_s23_q;
  logic [12:0] select_1180_s23_q;
  logic [8:0] select_1185_s23_q;
  logic [8:0] select_1189_s23_q;
  logic not_1240_s23_q;
  logic and_1327_s23_q;
  logic and_1342_s23_q;
  logic and_1347_s23_q;
  logic or_1352_s23_q;
  logic [11:0] select_1361_s23_q;
  logic less_1366_s23_q;
  logic and_1411_s23_q;
  logic equal_1414_s23_q;
  logic equal_1415_s23_q;
  logic equal_1416_s23_q;
  logic [7:0] residual_s23_q;
  logic equal_1734_s23_q;
  logic and_1739_s23_q;
  logic less_1740_s23_q;
  logic [47:0] select_1747_s23_q;
  logic less_1757_s23_q;
  logic [13:0] select_1894_s23_q;
  logic [13:0] select_1899_s23_q;
  logic less_1949_s23_q;
  logic less_1952_s23_q;
  logic or_1955_s23_q;
  logic less_1957_s23_q;
  logic or_1962_s23_q;
  logic less_1963_s23_q;
  logic or_1969_s23_q;
  logic select_1974_s23_q;
  logic less_1975_s23_q;
  logic less_1978_s23_q;
  logic select_2002_s23_q;
  logic less_2004_s23_q;
  logic less_2007_s23_q;
  logic less_2010_s23_q;
  logic less_2013_s23_q;
  logic [11:0] select_2086_s23_q;
  logic [11:0] select_2091_s23_q;
  logic [11:0] select_2096_s23_q;
  logic [11:0] select_2101_s23_q;
  logic and_2124_s23_q;
  logic [5:0] select_2129_s23_q;
  logic [11:0] select_2139_s23_q;
  logic [11:0] select_2145_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      census_changes_values_1_left_s23_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s23_q <= census_changes_values_1_right_q;
      begins_product_s23_q <= begins_product_q;
      done_s23_q <= done_q;
      select_298_s23_q <= select_298_s22_q;
      and_330_s23_q <= and_330_s22_q;
      equal_342_s23_q <= equal_342_s22_q;
      not_343_s23_q <= not_343_s22_q;
      equal_344_s23_q <= equal_344_s22_q;
      less_345_s23_q <= less_345_s22_q;
      not_346_s23_q <= not_346_s22_q;
      less_350_s23_q <= less_350_s22_q;
      less_351_s23_q <= less_351_s22_q;
      less_352_s23_q <= less_352_s22_q;
      less_353_s23_q <= less_353_s22_q;
      less_354_s23_q <= less_354_s22_q;
      less_355_s23_q <= less_355_s22_q;
      less_356_s23_q <= less_356_s22_q;
      less_357_s23_q <= less_357_s22_q;
      less_358_s23_q <= less_358_s22_q;
      less_359_s23_q <= less_359_s22_q;
      less_360_s23_q <= less_360_s22_q;
      less_361_s23_q <= less_361_s22_q;
      less_362_s23_q <= less_362_s22_q;
      less_363_s23_q <= less_363_s22_q;
      less_364_s23_q <= less_364_s22_q;
      less_365_s23_q <= less_365_s22_q;
      less_366_s23_q <= less_366_s22_q;
      less_367_s23_q <= less_367_s22_q;
      less_368_s23_q <= less_368_s22_q;
      less_369_s23_q <= less_369_s22_q;
      less_370_s23_q <= less_370_s22_q;
      less_371_s23_q <= less_371_s22_q;
      less_372_s23_q <= less_372_s22_q;
      less_373_s23_q <= less_373_s22_q;
      and_380_s23_q <= and_380_s22_q;
      and_405_s23_q <= whole_22 & and_380_s22_q;
      and_406_s23_q <= and_406_s22_q;
      sum_426_s23_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      x_s23_q <= x_s22_2_q;
      not_484_s23_q <= not_484_s22_q;
      best_left_rdata_s23_q <= best_left_rdata_s22_q;
      equal_489_s23_q <= equal_489_s22_q;
      select_785_s23_q <= select_785_s22_q;
      less_791_s23_q <= less_791_s22_q;
      less_792_s23_q <= less_792_s22_q;
      or_794_s23_q <= or_794_s22_q;
      select_798_s23_q <= select_798_s22_q;
      select_802_s23_q <= select_802_s22_q;
      equal_807_s23_q <= equal_807_s22_q;
      difference_818_s23_q <= difference_818_s22_q;
      sum_819_s23_q <= sum_819_s22_q;
      twice_s23_q <= twice_s22_q;
      difference_831_s23_q <= difference_831_s22_q;
      sum_834_s23_q <= sum_834_s22_q[10];
      sum_837_s23_q <= {sum_834_s22_q[9:0], not_835} + {not_835, xor_836, not_835};
      and_851_s23_q <= and_851_s22_q;
      equal_883_s23_q <= equal_883_s22_q;
      equal_884_s23_q <= equal_884_s22_q;
      and_894_s23_q <= and_894_s22_q;
      index_s23_q <= index[2:0];
      sum_944_s23_q <= sum_944;
      and_951_s23_q <= began_q & (seen_x_q == 4'h0);
      less_952_s23_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s23_q <= index_2[2:0];
      sum_957_s23_q <= sum_957;
      t_s23_q <= t;
      or_976_s23_q <= or_976_s22_q;
      select_987_s23_q <= select_987;
      e_s23_q <= e;
      less_1017_s23_q <= {1'b0, e[4:1]} < n;
      and_1029_s23_q <= and_1029_s22_q;
      equal_1143_s23_q <= equal_1143_s22_q;
      sum_1144_s23_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_1136};
      select_1169_s23_q <= and_1167 ? detail_3[14:2] : 13'h0;
      select_1180_s23_q <= and_1178 ? detail_4[14:2] : 13'h0;
      select_1185_s23_q <= and_1167 ? contrast_s22_q : 9'h0;
      select_1189_s23_q <= and_1178 ? contrast_2_s22_q : 9'h0;
      not_1240_s23_q <= not_1240_s22_q;
      and_1327_s23_q <= and_1327_s22_q;
      and_1342_s23_q <= and_1342_s22_q;
      and_1347_s23_q <= and_1347_s22_q;
      or_1352_s23_q <= or_1352_s22_q;
      select_1361_s23_q <= select_1361_s22_q;
      less_1366_s23_q <= {sum_1365, select_1364_s22_q[1:0]} < {3'h0, select_1361_s22_q};
      and_1411_s23_q <= and_1411_s22_q;
      equal_1414_s23_q <= equal_1414_s22_q;
      equal_1415_s23_q <= equal_1415_s22_q;
      equal_1416_s23_q <= equal_1416_s22_q;
      residual_s23_q <= residual_s22_q;
      equal_1734_s23_q <= equal_1734;
      and_1739_s23_q <= and_1739_s22_q;
      less_1740_s23_q <= less_1740_s22_q;
      select_1747_s23_q <= select_1747;
      less_1757_s23_q <= less_1757_s22_q;
      select_1894_s23_q <= select_1894;
      select_1899_s23_q <= select_1899;
      less_1949_s23_q <= less_1949_s22_q;
      less_1952_s23_q <= less_1952_s22_q;
      or_1955_s23_q <= or_1955_s22_q;
      less_1957_s23_q <= less_1957_s22_q;
      or_1962_s23_q <= or_1962_s22_q;
      less_1963_s23_q <= less_1963_s22_q;
      or_1969_s23_q <= or_1969;
      select_1974_s23_q <= less_1949_s22_q ? select_1971 : select_1973;
      less_1975_s23_q <= less_1975_s22_q;
      less_1978_s23_q <= less_1978_s22_q;
      select_2002_s23_q <= select_2002;
      less_2004_s23_q <= less_2004_s22_q;
      less_2007_s23_q <= less_2007_s22_q;
      less_2010_s23_q <= less_2010_s22_q;
      less_2013_s23_q <= less_2013_s22_q;
      select_2086_s23_q <= select_2086;
      select_2091_s23_q <= select_2091;
      select_2096_s23_q <= select_2096;
      select_2101_s23_q <= select_2101;
      and_2124_s23_q <= and_2124_s22_q;
      select_2129_s23_q <= equal_342_s22_q ? 6'h0 : (equal_344_s22_q ? 6'h0 : select_2127);
      select_2139_s23_q <= select_2139;
      select_2145_s23_q <= select_2145_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [47:0] good_q;
  logic [7:0] hidden_for_q;
  logic [7:0] next_hidden_for_q;
  logic [35:0] product_0_q;
  logic [35:0] product_1_q;
  logic [34:0] addend_0_q;
  logic [34:0] addend_1_q;
  logic [17:0] multiplier_0_q;
  logic [17:0] multiplier_1_q;
  // hls/stages/census.hpp:193
  logic [13:0] sum_427;
  assign sum_427 = {2'h0, census_changes_values_1_left_s23_q} + {1'b0, sum_426_s23_q};
  logic [13:0] sum_428;
  assign sum_428 = {2'h0, census_changes_values_2_left_q} + sum_427;
  // hls/stages/agreement.hpp:443
  logic not_838;
  assign not_838 = ~sum_837_s23_q[10];
  logic [8:0] xor_839;
  assign xor_839 = twice_s23_q ^ {9{not_838}};
  logic [10:0] sum_840;
  assign sum_840 = {sum_837_s23_q[9:0], not_838} + {not_838, xor_839, not_838};
  logic not_841;
  assign not_841 = ~sum_840[10];
  // hls/stages/agreement.hpp:689
  logic [47:0] select_988;
  assign select_988 = or_976_s23_q ? {select_987_s23_q[23], 1'b0, select_987_s23_q[22], 1'b0, select_987_s23_q[21], 1'b0, select_987_s23_q[20], 1'b0, select_987_s23_q[19], 1'b0, select_987_s23_q[18], 1'b0, select_987_s23_q[17], 1'b0, select_987_s23_q[16], 1'b0, select_987_s23_q[15], 1'b0, select_987_s23_q[14], 1'b0, select_987_s23_q[13], 1'b0, select_987_s23_q[12], 1'b0, select_987_s23_q[11], 1'b0, select_987_s23_q[10], 1'b0, select_987_s23_q[9], 1'b0, select_987_s23_q[8], 1'b0, select_987_s23_q[7], 1'b0, select_987_s23_q[6], 1'b0, select_987_s23_q[5], 1'b0, select_987_s23_q[4], 1'b0, select_987_s23_q[3], 1'b0, select_987_s23_q[2], 1'b0, select_987_s23_q[1], 1'b0, select_987_s23_q[0], 1'b0} : {1'b0, select_987_s23_q[23], 1'b0, select_987_s23_q[22], 1'b0, select_987_s23_q[21], 1'b0, select_987_s23_q[20], 1'b0, select_987_s23_q[19], 1'b0, select_987_s23_q[18], 1'b0, select_987_s23_q[17], 1'b0, select_987_s23_q[16], 1'b0, select_987_s23_q[15], 1'b0, select_987_s23_q[14], 1'b0, select_987_s23_q[13], 1'b0, select_987_s23_q[12], 1'b0, select_987_s23_q[11], 1'b0, select_987_s23_q[10], 1'b0, select_987_s23_q[9], 1'b0, select_987_s23_q[8], 1'b0, select_987_s23_q[7], 1'b0, select_987_s23_q[6], 1'b0, select_987_s23_q[5], 1'b0, select_987_s23_q[4], 1'b0, select_987_s23_q[3], 1'b0, select_987_s23_q[2], 1'b0, select_987_s23_q[1], 1'b0, select_987_s23_q[0]};
  // hls/stages/agreement.hpp:690
  logic [5:0] sum_1003;
  assign sum_1003 = {1'b0, e_s23_q} + {2'h0, e_s23_q[4:1]};
  // hls/stages/agreement.hpp:173
  logic [11:0] select_1140;
  assign select_1140 = and_330_s23_q ? census_changes_values_1_left_s23_q : census_changes_values_2_left_q;
  logic [11:0] select_1141;
  assign select_1141 = and_330_s23_q ? census_changes_values_1_right_s23_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:194
  logic [13:0] sum_1145;
  assign sum_1145 = {2'h0, census_changes_values_1_right_s23_q} + {1'b0, sum_1144_s23_q};
  logic [13:0] sum_1146;
  assign sum_1146 = {2'h0, census_changes_values_2_right_q} + sum_1145;
  // hls/stages/census.hpp:267
  logic [23:0] select_1171;
  assign select_1171 = equal_1143_s23_q ? {11'h0, select_1169_s23_q} : (sharpness_sums_detail_0_q + {11'h0, select_1169_s23_q});
  logic [23:0] select_1182;
  assign select_1182 = equal_1143_s23_q ? {11'h0, select_1180_s23_q} : (sharpness_sums_detail_1_q + {11'h0, select_1180_s23_q});
  logic [23:0] sum_1186;
  assign sum_1186 = (equal_1143_s23_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_1185_s23_q};
  logic [23:0] sum_1190;
  assign sum_1190 = (equal_1143_s23_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_1189_s23_q};
  // hls/stages/agreement.hpp:298
  logic [47:0] select_1749;
  assign select_1749 = equal_883_s23_q ? (equal_1734_s23_q ? select_1747_s23_q : good_q) : good_q;
  logic [47:0] select_1751;
  assign select_1751 = equal_344_s23_q ? good_q : (begins_product_q ? good_q : select_1749);
  // hls/stages/agreement.hpp:729
  logic [7:0] select_1758;
  assign select_1758 = less_1757_s23_q ? next_hidden_for_q : 8'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1760;
  assign select_1760 = equal_883_s23_q ? (equal_1734_s23_q ? select_1758 : hidden_for_q) : hidden_for_q;
  logic [7:0] select_1762;
  assign select_1762 = equal_344_s23_q ? hidden_for_q : (begins_product_q ? hidden_for_q : select_1760);
  // hls/stages/agreement.hpp:139
  logic not_1764;
  assign not_1764 = ~hidden_for_q[7];
  // hls/stages/agreement.hpp:744
  logic [35:0] select_1777;
  assign select_1777 = multiplier_0_q[17] ? (product_0_q + {1'b0, addend_0_q}) : product_0_q;
  // hls/stages/agreement.hpp:738
  logic [35:0] detail_left;
  assign detail_left = begins_product_s23_q ? 36'h0 : select_1777;
  // hls/stages/agreement.hpp:744
  logic [35:0] select_1780;
  assign select_1780 = multiplier_1_q[17] ? (product_1_q + {1'b0, addend_1_q}) : product_1_q;
  // hls/stages/agreement.hpp:748
  logic [35:0] detail_right;
  assign detail_right = begins_product_s23_q ? 36'h0 : select_1780;
  // hls/stages/agreement.hpp:738
  logic [34:0] select_1782;
  assign select_1782 = begins_product_s23_q ? {sharpness_sums_detail_0_q[23:6], 17'h0} : {1'b0, addend_0_q[34:1]};
  // hls/stages/agreement.hpp:748
  logic [34:0] select_1783;
  assign select_1783 = begins_product_s23_q ? {sharpness_sums_detail_1_q[23:6], 17'h0} : {1'b0, addend_1_q[34:1]};
  // hls/stages/agreement.hpp:738
  logic [17:0] select_1784;
  assign select_1784 = begins_product_s23_q ? sharpness_sums_contrast_1_q[23:6] : {multiplier_0_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:748
  logic [17:0] select_1785;
  assign select_1785 = begins_product_s23_q ? sharpness_sums_contrast_0_q[23:6] : {multiplier_1_q[16:0], 1'b0};
  // hls/stages/agreement.hpp:847
  logic and_1878;
  assign and_1878 = and_1029_s23_q & ({sum_957_s23_q, index_2_s23_q} == {sum_944_s23_q, index_s23_q});
  // hls/stages/agreement.hpp:790
  logic or_1977;
  assign or_1977 = select_1974_s23_q | (~less_1975_s23_q);
  // hls/stages/agreement.hpp:791
  logic select_1979;
  assign select_1979 = or_1977 ? select_1974_s23_q : less_1978_s23_q;
  logic select_1981;
  assign select_1981 = less_1957_s23_q ? select_1979 : (less_1963_s23_q ? select_1979 : less_1978_s23_q);
  // hls/stages/agreement.hpp:731
  logic and_2055;
  assign and_2055 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_1758 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:298
  logic [23:0] select_2103;
  assign select_2103 = equal_883_s23_q ? (equal_1734_s23_q ? sharpness_sums_detail_0_q : 24'h0) : 24'h0;
  logic [23:0] select_2105;
  assign select_2105 = equal_344_s23_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2103);
  logic [23:0] select_2108;
  assign select_2108 = equal_883_s23_q ? (equal_1734_s23_q ? sharpness_sums_detail_1_q : 24'h0) : 24'h0;
  logic [23:0] select_2110;
  assign select_2110 = equal_344_s23_q ? 24'h0 : (begins_product_q ? 24'h0 : select_2108);

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:922; read in stage 23, written in stage 24: 23 < 24 < 23 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_944_s23_q, index_s23_q};
  logic map_re;
  assign map_re = s23_en & (and_951_s23_q & less_952_s23_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      good_q <= 48'h0;
      hidden_for_q <= 8'h0;
      next_hidden_for_q <= 8'h0;
      product_0_q <= 36'h0;
      product_1_q <= 36'h0;
      addend_0_q <= 35'h0;
      addend_1_q <= 35'h0;
      multiplier_0_q <= 18'h0;
      multiplier_1_q <= 18'h0;
    end else if (s23_en) begin
      sharpness_sums_detail_0_q <= and_330_s23_q ? select_1171 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_330_s23_q ? select_1182 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_330_s23_q ? sum_1186 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_330_s23_q ? sum_1190 : sharpness_sums_contrast_1_q;
      good_q <= equal_342_s23_q ? good_q : select_1751;
      hidden_for_q <= equal_342_s23_q ? hidden_for_q : select_1762;
      next_hidden_for_q <= hidden_for_q + {7'h0, not_1764};
      product_0_q <= detail_left;
      product_1_q <= detail_right;
      addend_0_q <= select_1782;
      addend_1_q <= select_1783;
      multiplier_0_q <= select_1784;
      multiplier_1_q <= select_1785;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      census_changes_values_2_left_q <= select_1140;
      census_changes_values_2_right_q <= select_1141;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic [23:0] sharpness_sums_contrast_0_s24_q;
  logic [23:0] sharpness_sums_contrast_1_s24_q;
  logic done_s24_q;
  logic [6:0] select_298_s24_q;
  logic and_330_s24_q;
  logic equal_342_s24_q;
  logic not_343_s24_q;
  logic equal_344_s24_q;
  logic less_345_s24_q;
  logic not_346_s24_q;
  logic less_350_s24_q;
  logic less_351_s24_q;
  logic less_352_s24_q;
  logic less_353_s24_q;
  logic less_354_s24_q;
  logic less_355_s24_q;
  logic less_356_s24_q;
  logic less_357_s24_q;
  logic less_358_s24_q;
  logic less_359_s24_q;
  logic less_360_s24_q;
  logic less_361_s24_q;
  logic less_362_s24_q;
  logic less_363_s24_q;
  logic less_364_s24_q;
  logic less_365_s24_q;
  logic less_366_s24_q;
  logic less_367_s24_q;
  logic less_368_s24_q;
  logic less_369_s24_q;
  logic less_370_s24_q;
  logic less_371_s24_q;
  logic less_372_s24_q;
  logic less_373_s24_q;
  logic and_380_s24_q;
  logic and_405_s24_q;
  logic and_406_s24_q;
  logic [8:0] sum_428_s24_q;
  logic drew_s24_q;
  logic [6:0] x_s24_q;
  logic not_484_s24_q;
  logic [7:0] best_left_rdata_s24_q;
  logic equal_489_s24_q;
  logic select_785_s24_q;
  logic less_791_s24_q;
  logic less_792_s24_q;
  logic or_794_s24_q;
  logic [7:0] select_798_s24_q;
  logic [5:0] select_802_s24_q;
  logic equal_807_s24_q;
  logic difference_818_s24_q;
  logic [1:0] sum_819_s24_q;
  logic difference_831_s24_q;
  logic sum_834_s24_q;
  logic sum_837_s24_q;
  logic [10:0] sum_840_s24_q;
  logic not_841_s24_q;
  logic [8:0] xor_842_s24_q;
  logic and_851_s24_q;
  logic equal_883_s24_q;
  logic equal_884_s24_q;
  logic and_894_s24_q;
  logic and_951_s24_q;
  logic less_952_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_957_s24_q;
  logic equal_971_s24_q;
  logic not_991_s24_q;
  logic not_1005_s24_q;
  logic less_1017_s24_q;
  logic and_1029_s24_q;
  logic equal_1143_s24_q;
  logic [8:0] sum_1146_s24_q;
  logic not_1240_s24_q;
  logic and_1327_s24_q;
  logic and_1342_s24_q;
  logic and_1347_s24_q;
  logic or_1352_s24_q;
  logic [11:0] select_1361_s24_q;
  logic and_1367_s24_q;
  logic and_1411_s24_q;
  logic equal_1414_s24_q;
  logic equal_1415_s24_q;
  logic equal_1416_s24_q;
  logic [7:0] residual_s24_q;
  logic equal_1734_s24_q;
  logic and_1739_s24_q;
  logic less_1740_s24_q;
  logic and_1863_s24_q;
  logic and_1878_s24_q;
  logic [13:0] select_1894_s24_q;
  logic [13:0] select_1899_s24_q;
  logic less_1949_s24_q;
  logic less_1952_s24_q;
  logic or_1955_s24_q;
  logic less_1957_s24_q;
  logic or_1962_s24_q;
  logic less_1963_s24_q;
  logic or_1969_s24_q;
  logic less_1975_s24_q;
  logic or_1977_s24_q;
  logic select_1979_s24_q;
  logic select_1982_s24_q;
  logic select_2002_s24_q;
  logic less_2004_s24_q;
  logic less_2007_s24_q;
  logic less_2010_s24_q;
  logic less_2013_s24_q;
  logic and_2057_s24_q;
  logic [11:0] select_2086_s24_q;
  logic [11:0] select_2091_s24_q;
  logic [11:0] select_2096_s24_q;
  logic [11:0] select_2101_s24_q;
  logic [23:0] select_2106_s24_q;
  logic [23:0] select_2111_s24_q;
  logic and_2124_s24_q;
  logic [5:0] select_2129_s24_q;
  logic [11:0] select_2139_s24_q;
  logic [11:0] select_2145_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      sharpness_sums_contrast_0_s24_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s24_q <= sharpness_sums_contrast_1_q;
      done_s24_q <= done_s23_q;
      select_298_s24_q <= select_298_s23_q;
      and_330_s24_q <= and_330_s23_q;
      equal_342_s24_q <= equal_342_s23_q;
      not_343_s24_q <= not_343_s23_q;
      equal_344_s24_q <= equal_344_s23_q;
      less_345_s24_q <= less_345_s23_q;
      not_346_s24_q <= not_346_s23_q;
      less_350_s24_q <= less_350_s23_q;
      less_351_s24_q <= less_351_s23_q;
      less_352_s24_q <= less_352_s23_q;
      less_353_s24_q <= less_353_s23_q;
      less_354_s24_q <= less_354_s23_q;
      less_355_s24_q <= less_355_s23_q;
      less_356_s24_q <= less_356_s23_q;
      less_357_s24_q <= less_357_s23_q;
      less_358_s24_q <= less_358_s23_q;
      less_359_s24_q <= less_359_s23_q;
      less_360_s24_q <= less_360_s23_q;
      less_361_s24_q <= less_361_s23_q;
      less_362_s24_q <= less_362_s23_q;
      less_363_s24_q <= less_363_s23_q;
      less_364_s24_q <= less_364_s23_q;
      less_365_s24_q <= less_365_s23_q;
      less_366_s24_q <= less_366_s23_q;
      less_367_s24_q <= less_367_s23_q;
      less_368_s24_q <= less_368_s23_q;
      less_369_s24_q <= less_369_s23_q;
      less_370_s24_q <= less_370_s23_q;
      less_371_s24_q <= less_371_s23_q;
      less_372_s24_q <= less_372_s23_q;
      less_373_s24_q <= less_373_s23_q;
      and_380_s24_q <= and_380_s23_q;
      and_405_s24_q <= and_405_s23_q;
      and_406_s24_q <= and_406_s23_q;
      sum_428_s24_q <= sum_428[13:5];
      drew_s24_q <= begins_product_q;
      x_s24_q <= x_s23_q;
      not_484_s24_q <= not_484_s23_q;
      best_left_rdata_s24_q <= best_left_rdata_s23_q;
      equal_489_s24_q <= equal_489_s23_q;
      select_785_s24_q <= select_785_s23_q;
      less_791_s24_q <= less_791_s23_q;
      less_792_s24_q <= less_792_s23_q;
      or_794_s24_q <= or_794_s23_q;
      select_798_s24_q <= select_798_s23_q;
      select_802_s24_q <= select_802_s23_q;
      equal_807_s24_q <= equal_807_s23_q;
      difference_818_s24_q <= difference_818_s23_q;
      sum_819_s24_q <= sum_819_s23_q;
      difference_831_s24_q <= difference_831_s23_q;
      sum_834_s24_q <= sum_834_s23_q;
      sum_837_s24_q <= sum_837_s23_q[10];
      sum_840_s24_q <= sum_840;
      not_841_s24_q <= not_841;
      xor_842_s24_q <= twice_s23_q ^ {9{not_841}};
      and_851_s24_q <= and_851_s23_q;
      equal_883_s24_q <= equal_883_s23_q;
      equal_884_s24_q <= equal_884_s23_q;
      and_894_s24_q <= and_894_s23_q;
      and_951_s24_q <= and_951_s23_q;
      less_952_s24_q <= less_952_s23_q;
      index_2_s24_q <= index_2_s23_q;
      sum_957_s24_q <= sum_957_s23_q;
      equal_971_s24_q <= t_s23_q[4:1] == 4'h0;
      not_991_s24_q <= ~((good_q & select_988) == 48'h0);
      not_1005_s24_q <= ~({sum_1003, e_s23_q[0]} < {2'h0, t_s23_q});
      less_1017_s24_q <= less_1017_s23_q;
      and_1029_s24_q <= and_1029_s23_q;
      equal_1143_s24_q <= equal_1143_s23_q;
      sum_1146_s24_q <= sum_1146[13:5];
      not_1240_s24_q <= not_1240_s23_q;
      and_1327_s24_q <= and_1327_s23_q;
      and_1342_s24_q <= and_1342_s23_q;
      and_1347_s24_q <= and_1347_s23_q;
      or_1352_s24_q <= or_1352_s23_q;
      select_1361_s24_q <= select_1361_s23_q;
      and_1367_s24_q <= (~(select_1361_s23_q[11:4] == 8'h0)) & less_1366_s23_q;
      and_1411_s24_q <= and_1411_s23_q;
      equal_1414_s24_q <= equal_1414_s23_q;
      equal_1415_s24_q <= equal_1415_s23_q;
      equal_1416_s24_q <= equal_1416_s23_q;
      residual_s24_q <= residual_s23_q;
      equal_1734_s24_q <= equal_1734_s23_q;
      and_1739_s24_q <= and_1739_s23_q;
      less_1740_s24_q <= less_1740_s23_q;
      and_1863_s24_q <= said_q;
      and_1878_s24_q <= and_1878;
      select_1894_s24_q <= select_1894_s23_q;
      select_1899_s24_q <= select_1899_s23_q;
      less_1949_s24_q <= less_1949_s23_q;
      less_1952_s24_q <= less_1952_s23_q;
      or_1955_s24_q <= or_1955_s23_q;
      less_1957_s24_q <= less_1957_s23_q;
      or_1962_s24_q <= or_1962_s23_q;
      less_1963_s24_q <= less_1963_s23_q;
      or_1969_s24_q <= or_1969_s23_q;
      less_1975_s24_q <= less_1975_s23_q;
      or_1977_s24_q <= or_1977;
      select_1979_s24_q <= select_1979;
      select_1982_s24_q <= less_1952_s23_q ? select_1979 : select_1981;
      select_2002_s24_q <= select_2002_s23_q;
      less_2004_s24_q <= less_2004_s23_q;
      less_2007_s24_q <= less_2007_s23_q;
      less_2010_s24_q <= less_2010_s23_q;
      less_2013_s24_q <= less_2013_s23_q;
      and_2057_s24_q <= equal_1734_s23_q & (cfg_prove_i & and_2055);
      select_2086_s24_q <= select_2086_s23_q;
      select_2091_s24_q <= select_2091_s23_q;
      select_2096_s24_q <= select_2096_s23_q;
      select_2101_s24_q <= select_2101_s23_q;
      select_2106_s24_q <= equal_342_s23_q ? 24'h0 : select_2105;
      select_2111_s24_q <= equal_342_s23_q ? 24'h0 : select_2110;
      and_2124_s24_q <= and_2124_s23_q;
      select_2129_s24_q <= select_2129_s23_q;
      select_2139_s24_q <= select_2139_s23_q;
      select_2145_s24_q <= select_2145_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic proven_q;
  // hls/stages/agreement.hpp:443
  logic [10:0] sum_843;
  assign sum_843 = {sum_840_s24_q[9:0], not_841_s24_q} + {not_841_s24_q, xor_842_s24_q, not_841_s24_q};
  // hls/stages/agreement.hpp:446
  logic [7:0] difference_844;
  assign difference_844 = {sum_819_s24_q, select_785_s24_q, 5'h0} - {3'h0, difference_831_s24_q, sum_834_s24_q, sum_837_s24_q, sum_840_s24_q[10], sum_843[10]};
  // hls/stages/agreement.hpp:690
  logic is_seen;
  assign is_seen = equal_971_s24_q ? not_991_s24_q : not_1005_s24_q;
  // hls/stages/agreement.hpp:698
  logic and_1018;
  assign and_1018 = is_seen & less_1017_s24_q;
  // hls/stages/agreement.hpp:692
  logic or_1353;
  assign or_1353 = is_seen | or_1352_s24_q;
  // hls/stages/agreement.hpp:727
  logic [11:0] select_1369;
  assign select_1369 = equal_884_s24_q ? 12'h0 : (and_1367_s24_q ? select_1361_s24_q : 12'h0);
  // hls/stages/agreement.hpp:298
  logic [11:0] select_1370;
  assign select_1370 = equal_883_s24_q ? select_1369 : 12'h0;
  logic [11:0] select_1373;
  assign select_1373 = equal_342_s24_q ? 12'h0 : (equal_344_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_1370));
  // hls/stages/agreement.hpp:162
  logic [8:0] select_1385;
  assign select_1385 = less_345_s24_q ? 9'h0 : (and_894_s24_q ? (9'h0 - {1'b0, cfg_regions_limit_i}) : 9'h0);
  // hls/stages/agreement.hpp:298
  logic [20:0] select_1386;
  assign select_1386 = drew_s24_q ? {{12{select_1385[8]}}, select_1385} : {1'b0, select_1370, 8'h0};
  logic [20:0] select_1388;
  assign select_1388 = equal_342_s24_q ? 21'h0 : (equal_344_s24_q ? 21'h0 : select_1386);
  // hls/stages/agreement.hpp:596
  logic [8:0] select_1392;
  assign select_1392 = and_894_s24_q ? (9'h0 - {1'b0, cfg_unproven_limit_i}) : 9'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1393;
  assign select_1393 = less_345_s24_q ? 8'h0 : select_1392[7:0];
  // hls/stages/agreement.hpp:162
  logic and_1394;
  assign and_1394 = not_346_s24_q & select_1392[8];
  // hls/stages/agreement.hpp:696
  logic [2:0] select_1396;
  assign select_1396 = or_1353 ? {3{and_1394}} : ({3{and_1394}} + 3'h1);
  // hls/stages/agreement.hpp:162
  logic and_1527;
  assign and_1527 = and_1411_s24_q & ($signed(residual_s24_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:298
  logic [1:0] select_1529;
  assign select_1529 = drew_s24_q ? (less_345_s24_q ? 2'h0 : {and_1527, and_1411_s24_q}) : 2'h0;
  logic and_1923;
  assign and_1923 = equal_883_s24_q & (equal_1734_s24_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:731
  logic or_2003;
  assign or_2003 = (less_1949_s24_q ? select_1979_s24_q : select_1982_s24_q) | select_2002_s24_q;
  logic or_2005;
  assign or_2005 = less_2004_s24_q | or_2003;
  logic select_2006;
  assign select_2006 = or_1977_s24_q ? or_2003 : or_2005;
  logic or_2008;
  assign or_2008 = less_2007_s24_q | select_2006;
  logic select_2018;
  assign select_2018 = less_1963_s24_q ? or_2008 : (less_1975_s24_q ? or_2005 : select_2002_s24_q);
  // hls/stages/agreement.hpp:298
  logic and_2060;
  assign and_2060 = not_484_s24_q & (not_1240_s24_q & (equal_883_s24_q & and_2057_s24_q));
  logic [11:0] select_2131;
  assign select_2131 = equal_883_s24_q ? (equal_884_s24_q ? 12'h0 : select_1361_s24_q) : 12'h0;
  logic [11:0] select_2134;
  assign select_2134 = equal_342_s24_q ? 12'h0 : (equal_344_s24_q ? 12'h0 : (drew_s24_q ? 12'h0 : select_2131));

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_957_s24_q, index_2_s24_q};
  logic map_we;
  assign map_we = s24_en & and_1029_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1018, is_seen};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 14'd16080) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 14'd16080) $error("map: read outside, address %0d", map_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      proven_q <= 1'b0;
    end else if (s24_en) begin
      proven_q <= marks_first_s24_q ? done_s24_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic [23:0] sharpness_sums_contrast_0_s25_q;
  logic [23:0] sharpness_sums_contrast_1_s25_q;
  logic [6:0] select_298_s25_q;
  logic and_330_s25_q;
  logic equal_342_s25_q;
  logic not_343_s25_q;
  logic equal_344_s25_q;
  logic less_345_s25_q;
  logic less_350_s25_q;
  logic less_351_s25_q;
  logic less_352_s25_q;
  logic less_353_s25_q;
  logic less_354_s25_q;
  logic less_355_s25_q;
  logic less_356_s25_q;
  logic less_357_s25_q;
  logic less_358_s25_q;
  logic less_359_s25_q;
  logic less_360_s25_q;
  logic less_361_s25_q;
  logic less_362_s25_q;
  logic less_363_s25_q;
  logic less_364_s25_q;
  logic less_365_s25_q;
  logic less_366_s25_q;
  logic less_367_s25_q;
  logic less_368_s25_q;
  logic less_369_s25_q;
  logic less_370_s25_q;
  logic less_371_s25_q;
  logic less_372_s25_q;
  logic less_373_s25_q;
  logic and_380_s25_q;
  logic and_405_s25_q;
  logic and_406_s25_q;
  logic less_429_s25_q;
  logic drew_s25_q;
  logic [6:0] x_s25_q;
  logic not_484_s25_q;
  logic [7:0] best_left_rdata_s25_q;
  logic equal_489_s25_q;
  logic select_785_s25_q;
  logic less_791_s25_q;
  logic less_792_s25_q;
  logic or_794_s25_q;
  logic [7:0] select_798_s25_q;
  logic [5:0] select_802_s25_q;
  logic equal_807_s25_q;
  logic difference_818_s25_q;
  logic [1:0] sum_819_s25_q;
  logic difference_831_s25_q;
  logic sum_834_s25_q;
  logic sum_837_s25_q;
  logic sum_840_s25_q;
  logic sum_843_s25_q;
  logic [7:0] difference_844_s25_q;
  logic and_851_s25_q;
  logic equal_883_s25_q;
  logic and_951_s25_q;
  logic less_952_s25_q;
  logic [1:0] map_rdata_s25_q;
  logic is_seen_s25_q;
  logic and_1018_s25_q;
  logic equal_1143_s25_q;
  logic and_1148_s25_q;
  logic not_1240_s25_q;
  logic and_1327_s25_q;
  logic and_1342_s25_q;
  logic and_1347_s25_q;
  logic and_1357_s25_q;
  logic [11:0] select_1373_s25_q;
  logic [20:0] select_1388_s25_q;
  logic [10:0] select_1397_s25_q;
  logic and_1411_s25_q;
  logic equal_1414_s25_q;
  logic equal_1415_s25_q;
  logic equal_1416_s25_q;
  logic [7:0] residual_s25_q;
  logic [1:0] select_1530_s25_q;
  logic equal_1734_s25_q;
  logic and_1739_s25_q;
  logic less_1740_s25_q;
  logic [35:0] detail_left_s25_q;
  logic [35:0] detail_right_s25_q;
  logic and_1863_s25_q;
  logic and_1878_s25_q;
  logic [13:0] select_1894_s25_q;
  logic [13:0] select_1899_s25_q;
  logic and_1926_s25_q;
  logic less_1949_s25_q;
  logic less_1952_s25_q;
  logic or_1955_s25_q;
  logic less_1957_s25_q;
  logic or_1962_s25_q;
  logic select_2009_s25_q;
  logic less_2010_s25_q;
  logic less_2013_s25_q;
  logic select_2018_s25_q;
  logic [36:0] sum_2029_s25_q;
  logic [36:0] sum_2041_s25_q;
  logic and_2061_s25_q;
  logic [11:0] select_2086_s25_q;
  logic [11:0] select_2091_s25_q;
  logic [11:0] select_2096_s25_q;
  logic [11:0] select_2101_s25_q;
  logic [23:0] select_2106_s25_q;
  logic [23:0] select_2111_s25_q;
  logic and_2124_s25_q;
  logic [5:0] select_2129_s25_q;
  logic [11:0] select_2134_s25_q;
  logic [11:0] select_2139_s25_q;
  logic [11:0] select_2145_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      sharpness_sums_contrast_0_s25_q <= sharpness_sums_contrast_0_s24_q;
      sharpness_sums_contrast_1_s25_q <= sharpness_sums_contrast_1_s24_q;
      select_298_s25_q <= select_298_s24_q;
      and_330_s25_q <= and_330_s24_q;
      equal_342_s25_q <= equal_342_s24_q;
      not_343_s25_q <= not_343_s24_q;
      equal_344_s25_q <= equal_344_s24_q;
      less_345_s25_q <= less_345_s24_q;
      less_350_s25_q <= less_350_s24_q;
      less_351_s25_q <= less_351_s24_q;
      less_352_s25_q <= less_352_s24_q;
      less_353_s25_q <= less_353_s24_q;
      less_354_s25_q <= less_354_s24_q;
      less_355_s25_q <= less_355_s24_q;
      less_356_s25_q <= less_356_s24_q;
      less_357_s25_q <= less_357_s24_q;
      less_358_s25_q <= less_358_s24_q;
      less_359_s25_q <= less_359_s24_q;
      less_360_s25_q <= less_360_s24_q;
      less_361_s25_q <= less_361_s24_q;
      less_362_s25_q <= less_362_s24_q;
      less_363_s25_q <= less_363_s24_q;
      less_364_s25_q <= less_364_s24_q;
      less_365_s25_q <= less_365_s24_q;
      less_366_s25_q <= less_366_s24_q;
      less_367_s25_q <= less_367_s24_q;
      less_368_s25_q <= less_368_s24_q;
      less_369_s25_q <= less_369_s24_q;
      less_370_s25_q <= less_370_s24_q;
      less_371_s25_q <= less_371_s24_q;
      less_372_s25_q <= less_372_s24_q;
      less_373_s25_q <= less_373_s24_q;
      and_380_s25_q <= and_380_s24_q;
      and_405_s25_q <= and_405_s24_q;
      and_406_s25_q <= and_406_s24_q;
      less_429_s25_q <= 9'h4 < sum_428_s24_q;
      drew_s25_q <= drew_s24_q;
      x_s25_q <= x_s24_q;
      not_484_s25_q <= not_484_s24_q;
      best_left_rdata_s25_q <= best_left_rdata_s24_q;
      equal_489_s25_q <= equal_489_s24_q;
      select_785_s25_q <= select_785_s24_q;
      less_791_s25_q <= less_791_s24_q;
      less_792_s25_q <= less_792_s24_q;
      or_794_s25_q <= or_794_s24_q;
      select_798_s25_q <= select_798_s24_q;
      select_802_s25_q <= select_802_s24_q;
      equal_807_s25_q <= equal_807_s24_q;
      difference_818_s25_q <= difference_818_s24_q;
      sum_819_s25_q <= sum_819_s24_q;
      difference_831_s25_q <= difference_831_s24_q;
      sum_834_s25_q <= sum_834_s24_q;
      sum_837_s25_q <= sum_837_s24_q;
      sum_840_s25_q <= sum_840_s24_q[10];
      sum_843_s25_q <= sum_843[10];
      difference_844_s25_q <= difference_844;
      and_851_s25_q <= and_851_s24_q;
      equal_883_s25_q <= equal_883_s24_q;
      and_951_s25_q <= and_951_s24_q;
      less_952_s25_q <= less_952_s24_q;
      map_rdata_s25_q <= map_rdata_q;
      is_seen_s25_q <= is_seen;
      and_1018_s25_q <= and_1018;
      equal_1143_s25_q <= equal_1143_s24_q;
      and_1148_s25_q <= and_405_s24_q & (9'h4 < sum_1146_s24_q);
      not_1240_s25_q <= not_1240_s24_q;
      and_1327_s25_q <= and_1327_s24_q;
      and_1342_s25_q <= and_1342_s24_q;
      and_1347_s25_q <= and_1347_s24_q;
      and_1357_s25_q <= not_343_s24_q & (not_484_s24_q & (drew_s24_q & (~or_1353)));
      select_1373_s25_q <= select_1373;
      select_1388_s25_q <= select_1388;
      select_1397_s25_q <= drew_s24_q ? {select_1396, select_1393} : 11'h0;
      and_1411_s25_q <= and_1411_s24_q;
      equal_1414_s25_q <= equal_1414_s24_q;
      equal_1415_s25_q <= equal_1415_s24_q;
      equal_1416_s25_q <= equal_1416_s24_q;
      residual_s25_q <= residual_s24_q;
      select_1530_s25_q <= equal_344_s24_q ? 2'h0 : select_1529;
      equal_1734_s25_q <= equal_1734_s24_q;
      and_1739_s25_q <= and_1739_s24_q;
      less_1740_s25_q <= less_1740_s24_q;
      detail_left_s25_q <= product_0_q;
      detail_right_s25_q <= product_1_q;
      and_1863_s25_q <= and_1863_s24_q;
      and_1878_s25_q <= and_1878_s24_q;
      select_1894_s25_q <= select_1894_s24_q;
      select_1899_s25_q <= select_1899_s24_q;
      and_1926_s25_q <= not_343_s24_q & (not_484_s24_q & (not_1240_s24_q & and_1923));
      less_1949_s25_q <= less_1949_s24_q;
      less_1952_s25_q <= less_1952_s24_q;
      or_1955_s25_q <= or_1955_s24_q;
      less_1957_s25_q <= less_1957_s24_q;
      or_1962_s25_q <= or_1962_s24_q;
      select_2009_s25_q <= or_1969_s24_q ? select_2006 : or_2008;
      less_2010_s25_q <= less_2010_s24_q;
      less_2013_s25_q <= less_2013_s24_q;
      select_2018_s25_q <= select_2018;
      sum_2029_s25_q <= {1'b0, product_1_q} + {3'h0, product_1_q[35:2]};
      sum_2041_s25_q <= {1'b0, product_0_q} + {3'h0, product_0_q[35:2]};
      and_2061_s25_q <= not_343_s24_q & and_2060;
      select_2086_s25_q <= select_2086_s24_q;
      select_2091_s25_q <= select_2091_s24_q;
      select_2096_s25_q <= select_2096_s24_q;
      select_2101_s25_q <= select_2101_s24_q;
      select_2106_s25_q <= select_2106_s24_q;
      select_2111_s25_q <= select_2111_s24_q;
      and_2124_s25_q <= and_2124_s24_q;
      select_2129_s25_q <= select_2129_s24_q;
      select_2134_s25_q <= select_2134;
      select_2139_s25_q <= select_2139_s24_q;
      select_2145_s25_q <= select_2145_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [23:0] counts_too_many_bad_q;
  logic [23:0] counts_too_much_unproven_q;
  logic [14:0] counts_votes_0_down_q;
  // hls/stages/census.hpp:214
  logic and_430;
  assign and_430 = and_380_s25_q & less_429_s25_q;
  // hls/stages/agreement.hpp:426
  logic [7:0] select_845;
  assign select_845 = difference_818_s25_q ? difference_844_s25_q : {sum_819_s25_q, select_785_s25_q, difference_831_s25_q, sum_834_s25_q, sum_837_s25_q, sum_840_s25_q, sum_843_s25_q};
  logic [7:0] select_846;
  assign select_846 = equal_807_s25_q ? select_845 : {sum_819_s25_q, select_785_s25_q, 5'h0};
  // hls/stages/agreement.hpp:428
  logic [7:0] select_849;
  assign select_849 = less_791_s25_q ? (or_794_s25_q ? select_846 : best_left_rdata_s25_q) : (less_792_s25_q ? select_846 : best_left_rdata_s25_q);
  // hls/stages/census.hpp:217
  logic and_1149;
  assign and_1149 = and_405_s25_q & less_429_s25_q;
  // hls/stages/census.hpp:218
  logic [19:0] sum_1150;
  assign sum_1150 = census_left_misses_q + {{17{and_1149}}, and_1148_s25_q, 1'b0, and_1148_s25_q};
  // hls/stages/agreement.hpp:173
  logic [19:0] select_1152;
  assign select_1152 = and_330_s25_q ? (equal_1143_s25_q ? 20'h0 : sum_1150) : census_left_misses_q;
  // hls/stages/agreement.hpp:545
  logic [23:0] sum_1389;
  assign sum_1389 = counts_too_many_bad_q + {{3{select_1388_s25_q[20]}}, select_1388_s25_q};
  // hls/stages/agreement.hpp:298
  logic [10:0] select_1399;
  assign select_1399 = equal_342_s25_q ? 11'h0 : (equal_344_s25_q ? 11'h0 : select_1397_s25_q);
  // hls/stages/agreement.hpp:546
  logic [23:0] sum_1400;
  assign sum_1400 = counts_too_much_unproven_q + {{13{select_1399[10]}}, select_1399};
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1454;
  assign select_1454 = equal_1415_s25_q ? 8'h0 : (equal_1416_s25_q ? 8'h0 : residual_s25_q);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1457;
  assign select_1457 = less_345_s25_q ? 8'h0 : (and_1411_s25_q ? (equal_1414_s25_q ? 8'h0 : select_1454) : 8'h0);
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1464;
  assign select_1464 = equal_1415_s25_q ? 8'h0 : (equal_1416_s25_q ? residual_s25_q : 8'h0);
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1467;
  assign select_1467 = less_345_s25_q ? 8'h0 : (and_1411_s25_q ? (equal_1414_s25_q ? 8'h0 : select_1464) : 8'h0);
  // hls/stages/agreement.hpp:619
  logic [7:0] select_1474;
  assign select_1474 = equal_1414_s25_q ? 8'h0 : (equal_1415_s25_q ? residual_s25_q : 8'h0);
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1477;
  assign select_1477 = drew_s25_q ? (less_345_s25_q ? 8'h0 : (and_1411_s25_q ? select_1474 : 8'h0)) : 8'h0;
  // hls/stages/agreement.hpp:162
  logic [7:0] select_1483;
  assign select_1483 = and_1411_s25_q ? (equal_1414_s25_q ? residual_s25_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1486;
  assign select_1486 = equal_344_s25_q ? 8'h0 : (drew_s25_q ? (less_345_s25_q ? 8'h0 : select_1483) : 8'h0);
  logic [1:0] to_down;
  assign to_down = equal_342_s25_q ? 2'h0 : select_1530_s25_q;
  // hls/stages/agreement.hpp:178
  logic [14:0] select_1533;
  assign select_1533 = and_1327_s25_q ? 15'h0 : (counts_votes_0_down_q + {{13{to_down[1]}}, to_down});
  // hls/stages/agreement.hpp:847
  logic [1:0] select_1879;
  assign select_1879 = and_1878_s25_q ? {and_1018_s25_q, is_seen_s25_q} : map_rdata_s25_q;
  // hls/stages/agreement.hpp:848
  logic and_1880;
  assign and_1880 = proven_q & less_1868;
  // hls/stages/agreement.hpp:764
  logic not_1927;
  assign not_1927 = ~and_1739_s25_q;
  // hls/stages/agreement.hpp:298
  logic and_1931;
  assign and_1931 = not_1240_s25_q & (equal_883_s25_q & (equal_1734_s25_q & (cfg_prove_i & not_1927)));
  // hls/stages/agreement.hpp:765
  logic or_1934;
  assign or_1934 = not_1887 | not_1927;
  // hls/stages/agreement.hpp:731
  logic or_1939;
  assign or_1939 = ($signed(24'h0) < $signed(counts_too_many_bad_q)) | ($signed(24'h0) < $signed(counts_too_much_unproven_q));
  logic or_2011;
  assign or_2011 = less_2010_s25_q | select_2009_s25_q;
  logic select_2012;
  assign select_2012 = or_1962_s25_q ? select_2009_s25_q : or_2011;
  logic or_2014;
  assign or_2014 = less_2013_s25_q | select_2012;
  logic or_2016;
  assign or_2016 = ($signed(15'h0) < $signed(counts_votes_0_down_q)) | (or_1955_s25_q ? select_2012 : or_2014);
  logic select_2020;
  assign select_2020 = less_1952_s25_q ? or_2014 : (less_1957_s25_q ? or_2011 : select_2018_s25_q);
  // hls/stages/agreement.hpp:771
  logic and_2028;
  assign and_2028 = cfg_prove_i & and_1739_s25_q;
  // hls/stages/agreement.hpp:772
  logic less_2030;
  assign less_2030 = {detail_left_s25_q, 3'h0} < {sum_2029_s25_q, detail_right_s25_q[1:0]};
  logic less_2031;
  assign less_2031 = {sharpness_sums_contrast_0_s25_q, 2'h0} < {2'h0, sharpness_sums_contrast_1_s25_q};
  // hls/stages/agreement.hpp:731
  logic or_2034;
  assign or_2034 = less_2030 | (less_2031 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:775
  logic less_2042;
  assign less_2042 = {detail_right_s25_q, 3'h0} < {sum_2041_s25_q, detail_left_s25_q[1:0]};
  logic less_2043;
  assign less_2043 = {sharpness_sums_contrast_1_s25_q, 2'h0} < {2'h0, sharpness_sums_contrast_0_s25_q};
  // hls/stages/agreement.hpp:298
  logic [23:0] select_2113;
  assign select_2113 = equal_883_s25_q ? (equal_1734_s25_q ? sharpness_sums_contrast_0_s25_q : 24'h0) : 24'h0;
  logic [23:0] select_2116;
  assign select_2116 = equal_342_s25_q ? 24'h0 : (equal_344_s25_q ? 24'h0 : (drew_s25_q ? 24'h0 : select_2113));
  logic [23:0] select_2118;
  assign select_2118 = equal_883_s25_q ? (equal_1734_s25_q ? sharpness_sums_contrast_1_s25_q : 24'h0) : 24'h0;
  logic [23:0] select_2121;
  assign select_2121 = equal_342_s25_q ? 24'h0 : (equal_344_s25_q ? 24'h0 : (drew_s25_q ? 24'h0 : select_2118));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = select_298_s25_q;
  logic fresh_we;
  assign fresh_we = s25_en & and_330_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {and_430, and_406_s25_q, and_405_s25_q, and_380_s25_q, less_373_s25_q, less_372_s25_q, less_371_s25_q, less_370_s25_q, less_369_s25_q, less_368_s25_q, less_367_s25_q, less_366_s25_q, less_365_s25_q, less_364_s25_q, less_363_s25_q, less_362_s25_q, less_361_s25_q, less_360_s25_q, less_359_s25_q, less_358_s25_q, less_357_s25_q, less_356_s25_q, less_355_s25_q, less_354_s25_q, less_353_s25_q, less_352_s25_q, less_351_s25_q, less_350_s25_q};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s4_sim;
  logic fresh_re_s4_sim;
  logic [6:0] fresh_raddr_s5_sim;
  logic fresh_re_s5_sim;
  logic [6:0] fresh_raddr_s6_sim;
  logic fresh_re_s6_sim;
  logic [6:0] fresh_raddr_s7_sim;
  logic fresh_re_s7_sim;
  logic [6:0] fresh_raddr_s8_sim;
  logic fresh_re_s8_sim;
  logic [6:0] fresh_raddr_s9_sim;
  logic fresh_re_s9_sim;
  logic [6:0] fresh_raddr_s10_sim;
  logic fresh_re_s10_sim;
  logic [6:0] fresh_raddr_s11_sim;
  logic fresh_re_s11_sim;
  logic [6:0] fresh_raddr_s12_sim;
  logic fresh_re_s12_sim;
  logic [6:0] fresh_raddr_s13_sim;
  logic fresh_re_s13_sim;
  logic [6:0] fresh_raddr_s14_sim;
  logic fresh_re_s14_sim;
  logic [6:0] fresh_raddr_s15_sim;
  logic fresh_re_s15_sim;
  logic [6:0] fresh_raddr_s16_sim;
  logic fresh_re_s16_sim;
  logic [6:0] fresh_raddr_s17_sim;
  logic fresh_re_s17_sim;
  logic [6:0] fresh_raddr_s18_sim;
  logic fresh_re_s18_sim;
  logic [6:0] fresh_raddr_s19_sim;
  logic fresh_re_s19_sim;
  logic [6:0] fresh_raddr_s20_sim;
  logic fresh_re_s20_sim;
  logic [6:0] fresh_raddr_s21_sim;
  logic fresh_re_s21_sim;
  logic [6:0] fresh_raddr_s22_sim;
  logic fresh_re_s22_sim;
  logic [6:0] fresh_raddr_s23_sim;
  logic fresh_re_s23_sim;
  logic [6:0] fresh_raddr_s24_sim;
  logic fresh_re_s24_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s4_sim <= 1'b0;
      fresh_re_s5_sim <= 1'b0;
      fresh_re_s6_sim <= 1'b0;
      fresh_re_s7_sim <= 1'b0;
      fresh_re_s8_sim <= 1'b0;
      fresh_re_s9_sim <= 1'b0;
      fresh_re_s10_sim <= 1'b0;
      fresh_re_s11_sim <= 1'b0;
      fresh_re_s12_sim <= 1'b0;
      fresh_re_s13_sim <= 1'b0;
      fresh_re_s14_sim <= 1'b0;
      fresh_re_s15_sim <= 1'b0;
      fresh_re_s16_sim <= 1'b0;
      fresh_re_s17_sim <= 1'b0;
      fresh_re_s18_sim <= 1'b0;
      fresh_re_s19_sim <= 1'b0;
      fresh_re_s20_sim <= 1'b0;
      fresh_re_s21_sim <= 1'b0;
      fresh_re_s22_sim <= 1'b0;
      fresh_re_s23_sim <= 1'b0;
      fresh_re_s24_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s4_sim <= fresh_re;
      fresh_raddr_s4_sim <= fresh_raddr;
      fresh_re_s5_sim <= fresh_re_s4_sim;
      fresh_raddr_s5_sim <= fresh_raddr_s4_sim;
      fresh_re_s6_sim <= fresh_re_s5_sim;
      fresh_raddr_s6_sim <= fresh_raddr_s5_sim;
      fresh_re_s7_sim <= fresh_re_s6_sim;
      fresh_raddr_s7_sim <= fresh_raddr_s6_sim;
      fresh_re_s8_sim <= fresh_re_s7_sim;
      fresh_raddr_s8_sim <= fresh_raddr_s7_sim;
      fresh_re_s9_sim <= fresh_re_s8_sim;
      fresh_raddr_s9_sim <= fresh_raddr_s8_sim;
      fresh_re_s10_sim <= fresh_re_s9_sim;
      fresh_raddr_s10_sim <= fresh_raddr_s9_sim;
      fresh_re_s11_sim <= fresh_re_s10_sim;
      fresh_raddr_s11_sim <= fresh_raddr_s10_sim;
      fresh_re_s12_sim <= fresh_re_s11_sim;
      fresh_raddr_s12_sim <= fresh_raddr_s11_sim;
      fresh_re_s13_sim <= fresh_re_s12_sim;
      fresh_raddr_s13_sim <= fresh_raddr_s12_sim;
      fresh_re_s14_sim <= fresh_re_s13_sim;
      fresh_raddr_s14_sim <= fresh_raddr_s13_sim;
      fresh_re_s15_sim <= fresh_re_s14_sim;
      fresh_raddr_s15_sim <= fresh_raddr_s14_sim;
      fresh_re_s16_sim <= fresh_re_s15_sim;
      fresh_raddr_s16_sim <= fresh_raddr_s15_sim;
      fresh_re_s17_sim <= fresh_re_s16_sim;
      fresh_raddr_s17_sim <= fresh_raddr_s16_sim;
      fresh_re_s18_sim <= fresh_re_s17_sim;
      fresh_raddr_s18_sim <= fresh_raddr_s17_sim;
      fresh_re_s19_sim <= fresh_re_s18_sim;
      fresh_raddr_s19_sim <= fresh_raddr_s18_sim;
      fresh_re_s20_sim <= fresh_re_s19_sim;
      fresh_raddr_s20_sim <= fresh_raddr_s19_sim;
      fresh_re_s21_sim <= fresh_re_s20_sim;
      fresh_raddr_s21_sim <= fresh_raddr_s20_sim;
      fresh_re_s22_sim <= fresh_re_s21_sim;
      fresh_raddr_s22_sim <= fresh_raddr_s21_sim;
      fresh_re_s23_sim <= fresh_re_s22_sim;
      fresh_raddr_s23_sim <= fresh_raddr_s22_sim;
      fresh_re_s24_sim <= fresh_re_s23_sim;
      fresh_raddr_s24_sim <= fresh_raddr_s23_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s4_sim && fresh_raddr_s4_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s5_sim && fresh_raddr_s5_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s6_sim && fresh_raddr_s6_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s7_sim && fresh_raddr_s7_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s8_sim && fresh_raddr_s8_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s9_sim && fresh_raddr_s9_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s10_sim && fresh_raddr_s10_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s11_sim && fresh_raddr_s11_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s12_sim && fresh_raddr_s12_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s13_sim && fresh_raddr_s13_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s14_sim && fresh_raddr_s14_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s15_sim && fresh_raddr_s15_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s16_sim && fresh_raddr_s16_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s17_sim && fresh_raddr_s17_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s18_sim && fresh_raddr_s18_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s19_sim && fresh_raddr_s19_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s20_sim && fresh_raddr_s20_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s21_sim && fresh_raddr_s21_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s22_sim && fresh_raddr_s22_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s23_sim && fresh_raddr_s23_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s24_sim && fresh_raddr_s24_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      counts_too_many_bad_q <= 24'h0;
      counts_too_much_unproven_q <= 24'h0;
      counts_votes_0_down_q <= 15'h0;
    end else if (s25_en) begin
      census_left_misses_q <= select_1152;
      counts_too_many_bad_q <= and_1327_s25_q ? 24'h0 : sum_1389;
      counts_too_much_unproven_q <= and_1327_s25_q ? 24'h0 : sum_1400;
      counts_votes_0_down_q <= select_1533;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic equal_342_s26_q;
  logic not_343_s26_q;
  logic equal_344_s26_q;
  logic drew_s26_q;
  logic [6:0] x_s26_q;
  logic not_484_s26_q;
  logic [7:0] select_798_s26_q;
  logic [5:0] select_802_s26_q;
  logic [7:0] select_850_s26_q;
  logic and_851_s26_q;
  logic equal_883_s26_q;
  logic and_951_s26_q;
  logic less_952_s26_q;
  logic not_1240_s26_q;
  logic and_1327_s26_q;
  logic and_1342_s26_q;
  logic and_1347_s26_q;
  logic and_1357_s26_q;
  logic [11:0] select_1373_s26_q;
  logic [7:0] select_1459_s26_q;
  logic [7:0] select_1469_s26_q;
  logic [7:0] select_1479_s26_q;
  logic [7:0] select_1487_s26_q;
  logic equal_1734_s26_q;
  logic and_1863_s26_q;
  logic and_1881_s26_q;
  logic and_1884_s26_q;
  logic [13:0] select_1894_s26_q;
  logic [13:0] select_1899_s26_q;
  logic and_1926_s26_q;
  logic and_1933_s26_q;
  logic select_1940_s26_q;
  logic select_2021_s26_q;
  logic and_2035_s26_q;
  logic and_2045_s26_q;
  logic and_2061_s26_q;
  logic [11:0] select_2086_s26_q;
  logic [11:0] select_2091_s26_q;
  logic [11:0] select_2096_s26_q;
  logic [11:0] select_2101_s26_q;
  logic [23:0] select_2106_s26_q;
  logic [23:0] select_2111_s26_q;
  logic [23:0] select_2116_s26_q;
  logic [23:0] select_2121_s26_q;
  logic and_2124_s26_q;
  logic [5:0] select_2129_s26_q;
  logic [11:0] select_2134_s26_q;
  logic [11:0] select_2139_s26_q;
  logic [11:0] select_2145_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      equal_342_s26_q <= equal_342_s25_q;
      not_343_s26_q <= not_343_s25_q;
      equal_344_s26_q <= equal_344_s25_q;
      drew_s26_q <= drew_s25_q;
      x_s26_q <= x_s25_q;
      not_484_s26_q <= not_484_s25_q;
      select_798_s26_q <= select_798_s25_q;
      select_802_s26_q <= select_802_s25_q;
      select_850_s26_q <= equal_489_s25_q ? select_846 : select_849;
      and_851_s26_q <= and_851_s25_q;
      equal_883_s26_q <= equal_883_s25_q;
      and_951_s26_q <= and_951_s25_q;
      less_952_s26_q <= less_952_s25_q;
      not_1240_s26_q <= not_1240_s25_q;
      and_1327_s26_q <= and_1327_s25_q;
      and_1342_s26_q <= and_1342_s25_q;
      and_1347_s26_q <= and_1347_s25_q;
      and_1357_s26_q <= and_1357_s25_q;
      select_1373_s26_q <= select_1373_s25_q;
      select_1459_s26_q <= equal_344_s25_q ? 8'h0 : (drew_s25_q ? select_1457 : 8'h0);
      select_1469_s26_q <= equal_344_s25_q ? 8'h0 : (drew_s25_q ? select_1467 : 8'h0);
      select_1479_s26_q <= equal_342_s25_q ? 8'h0 : (equal_344_s25_q ? 8'h0 : select_1477);
      select_1487_s26_q <= equal_342_s25_q ? 8'h0 : select_1486;
      equal_1734_s26_q <= equal_1734_s25_q;
      and_1863_s26_q <= and_1863_s25_q;
      and_1881_s26_q <= select_1879[0] & and_1880;
      and_1884_s26_q <= select_1879[1] & and_1880;
      select_1894_s26_q <= select_1894_s25_q;
      select_1899_s26_q <= select_1899_s25_q;
      and_1926_s26_q <= and_1926_s25_q;
      and_1933_s26_q <= not_343_s25_q & (not_484_s25_q & and_1931);
      select_1940_s26_q <= (less_1740_s25_q | or_1934) ? (~or_1934) : or_1939;
      select_2021_s26_q <= less_1949_s25_q ? or_2016 : select_2020;
      and_2035_s26_q <= and_2028 & or_2034;
      and_2045_s26_q <= and_2028 & (less_2042 | less_2043);
      and_2061_s26_q <= and_2061_s25_q;
      select_2086_s26_q <= select_2086_s25_q;
      select_2091_s26_q <= select_2091_s25_q;
      select_2096_s26_q <= select_2096_s25_q;
      select_2101_s26_q <= select_2101_s25_q;
      select_2106_s26_q <= select_2106_s25_q;
      select_2111_s26_q <= select_2111_s25_q;
      select_2116_s26_q <= select_2116;
      select_2121_s26_q <= select_2121;
      and_2124_s26_q <= and_2124_s25_q;
      select_2129_s26_q <= select_2129_s25_q;
      select_2134_s26_q <= select_2134_s25_q;
      select_2139_s26_q <= select_2139_s25_q;
      select_2145_s26_q <= select_2145_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [19:0] counts_across_0_q;
  logic [19:0] counts_across_1_q;
  logic [19:0] counts_across_2_q;
  logic [19:0] counts_across_3_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/agreement.hpp:554
  logic [13:0] select_1344;
  assign select_1344 = and_1327_s26_q ? 14'h0 : (counts_explained_q + {13'h0, and_1342_s26_q});
  logic [13:0] select_1349;
  assign select_1349 = and_1327_s26_q ? 14'h0 : (counts_nearer_q + {13'h0, and_1347_s26_q});
  logic [13:0] select_1359;
  assign select_1359 = and_1327_s26_q ? 14'h0 : (counts_unproven_q + {13'h0, and_1357_s26_q});
  logic [13:0] select_1375;
  assign select_1375 = and_1327_s26_q ? 14'h0 : (counts_regions_bad_q + {2'h0, select_1373_s26_q});
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1460;
  assign select_1460 = equal_342_s26_q ? 8'h0 : select_1459_s26_q;
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1462;
  assign select_1462 = and_1327_s26_q ? 20'h0 : (counts_across_0_q + {{12{select_1460[7]}}, select_1460});
  // hls/stages/agreement.hpp:298
  logic [7:0] select_1470;
  assign select_1470 = equal_342_s26_q ? 8'h0 : select_1469_s26_q;
  // hls/stages/agreement.hpp:178
  logic [19:0] select_1472;
  assign select_1472 = and_1327_s26_q ? 20'h0 : (counts_across_1_q + {{12{select_1470[7]}}, select_1470});
  // hls/stages/agreement.hpp:549
  logic [19:0] sum_1480;
  assign sum_1480 = counts_across_2_q + {{12{select_1479_s26_q[7]}}, select_1479_s26_q};
  logic [19:0] sum_1488;
  assign sum_1488 = counts_across_3_q + {{12{select_1487_s26_q[7]}}, select_1487_s26_q};
  // hls/stages/agreement.hpp:176
  logic select_1883;
  assign select_1883 = and_951_s26_q ? (less_952_s26_q ? and_1881_s26_q : seen_q) : seen_q;
  logic select_1886;
  assign select_1886 = and_951_s26_q ? (less_952_s26_q ? and_1884_s26_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:298
  logic [13:0] select_1901;
  assign select_1901 = equal_883_s26_q ? (equal_1734_s26_q ? counts_explained_q : 14'h0) : 14'h0;
  logic [13:0] select_1904;
  assign select_1904 = equal_342_s26_q ? 14'h0 : (equal_344_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1901));
  logic [13:0] select_1906;
  assign select_1906 = equal_883_s26_q ? (equal_1734_s26_q ? counts_nearer_q : 14'h0) : 14'h0;
  logic [13:0] select_1909;
  assign select_1909 = equal_342_s26_q ? 14'h0 : (equal_344_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1906));
  logic [13:0] select_1911;
  assign select_1911 = equal_883_s26_q ? (equal_1734_s26_q ? counts_unproven_q : 14'h0) : 14'h0;
  logic [13:0] select_1914;
  assign select_1914 = equal_342_s26_q ? 14'h0 : (equal_344_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1911));
  logic [13:0] select_1916;
  assign select_1916 = equal_883_s26_q ? (equal_1734_s26_q ? counts_regions_bad_q : 14'h0) : 14'h0;
  logic [13:0] select_1919;
  assign select_1919 = equal_342_s26_q ? 14'h0 : (equal_344_s26_q ? 14'h0 : (drew_s26_q ? 14'h0 : select_1916));
  logic and_1943;
  assign and_1943 = not_1240_s26_q & (equal_883_s26_q & (equal_1734_s26_q & select_1940_s26_q));
  logic and_2024;
  assign and_2024 = equal_883_s26_q & (equal_1734_s26_q & (cfg_prove_i & select_2021_s26_q));
  logic and_2038;
  assign and_2038 = not_1240_s26_q & (equal_883_s26_q & (equal_1734_s26_q & and_2035_s26_q));
  logic and_2048;
  assign and_2048 = not_1240_s26_q & (equal_883_s26_q & (equal_1734_s26_q & and_2045_s26_q));
  logic [19:0] select_2063;
  assign select_2063 = equal_883_s26_q ? (equal_1734_s26_q ? counts_across_0_q : 20'h0) : 20'h0;
  logic [19:0] select_2066;
  assign select_2066 = equal_342_s26_q ? 20'h0 : (equal_344_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2063));
  logic [19:0] select_2068;
  assign select_2068 = equal_883_s26_q ? (equal_1734_s26_q ? counts_across_1_q : 20'h0) : 20'h0;
  logic [19:0] select_2071;
  assign select_2071 = equal_342_s26_q ? 20'h0 : (equal_344_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2068));
  logic [19:0] select_2073;
  assign select_2073 = equal_883_s26_q ? (equal_1734_s26_q ? counts_across_2_q : 20'h0) : 20'h0;
  logic [19:0] select_2076;
  assign select_2076 = equal_342_s26_q ? 20'h0 : (equal_344_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2073));
  logic [19:0] select_2078;
  assign select_2078 = equal_883_s26_q ? (equal_1734_s26_q ? counts_across_3_q : 20'h0) : 20'h0;
  logic [19:0] select_2081;
  assign select_2081 = equal_342_s26_q ? 20'h0 : (equal_344_s26_q ? 20'h0 : (drew_s26_q ? 20'h0 : select_2078));

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s26_q;
  logic best_left_we;
  assign best_left_we = s26_en & and_851_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_850_s26_q, select_802_s26_q, select_798_s26_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s10_sim;
  logic best_left_re_s10_sim;
  logic [6:0] best_left_raddr_s11_sim;
  logic best_left_re_s11_sim;
  logic [6:0] best_left_raddr_s12_sim;
  logic best_left_re_s12_sim;
  logic [6:0] best_left_raddr_s13_sim;
  logic best_left_re_s13_sim;
  logic [6:0] best_left_raddr_s14_sim;
  logic best_left_re_s14_sim;
  logic [6:0] best_left_raddr_s15_sim;
  logic best_left_re_s15_sim;
  logic [6:0] best_left_raddr_s16_sim;
  logic best_left_re_s16_sim;
  logic [6:0] best_left_raddr_s17_sim;
  logic best_left_re_s17_sim;
  logic [6:0] best_left_raddr_s18_sim;
  logic best_left_re_s18_sim;
  logic [6:0] best_left_raddr_s19_sim;
  logic best_left_re_s19_sim;
  logic [6:0] best_left_raddr_s20_sim;
  logic best_left_re_s20_sim;
  logic [6:0] best_left_raddr_s21_sim;
  logic best_left_re_s21_sim;
  logic [6:0] best_left_raddr_s22_sim;
  logic best_left_re_s22_sim;
  logic [6:0] best_left_raddr_s23_sim;
  logic best_left_re_s23_sim;
  logic [6:0] best_left_raddr_s24_sim;
  logic best_left_re_s24_sim;
  logic [6:0] best_left_raddr_s25_sim;
  logic best_left_re_s25_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s10_sim <= 1'b0;
      best_left_re_s11_sim <= 1'b0;
      best_left_re_s12_sim <= 1'b0;
      best_left_re_s13_sim <= 1'b0;
      best_left_re_s14_sim <= 1'b0;
      best_left_re_s15_sim <= 1'b0;
      best_left_re_s16_sim <= 1'b0;
      best_left_re_s17_sim <= 1'b0;
      best_left_re_s18_sim <= 1'b0;
      best_left_re_s19_sim <= 1'b0;
      best_left_re_s20_sim <= 1'b0;
      best_left_re_s21_sim <= 1'b0;
      best_left_re_s22_sim <= 1'b0;
      best_left_re_s23_sim <= 1'b0;
      best_left_re_s24_sim <= 1'b0;
      best_left_re_s25_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s10_sim <= best_left_re;
      best_left_raddr_s10_sim <= best_left_raddr;
      best_left_re_s11_sim <= best_left_re_s10_sim;
      best_left_raddr_s11_sim <= best_left_raddr_s10_sim;
      best_left_re_s12_sim <= best_left_re_s11_sim;
      best_left_raddr_s12_sim <= best_left_raddr_s11_sim;
      best_left_re_s13_sim <= best_left_re_s12_sim;
      best_left_raddr_s13_sim <= best_left_raddr_s12_sim;
      best_left_re_s14_sim <= best_left_re_s13_sim;
      best_left_raddr_s14_sim <= best_left_raddr_s13_sim;
      best_left_re_s15_sim <= best_left_re_s14_sim;
      best_left_raddr_s15_sim <= best_left_raddr_s14_sim;
      best_left_re_s16_sim <= best_left_re_s15_sim;
      best_left_raddr_s16_sim <= best_left_raddr_s15_sim;
      best_left_re_s17_sim <= best_left_re_s16_sim;
      best_left_raddr_s17_sim <= best_left_raddr_s16_sim;
      best_left_re_s18_sim <= best_left_re_s17_sim;
      best_left_raddr_s18_sim <= best_left_raddr_s17_sim;
      best_left_re_s19_sim <= best_left_re_s18_sim;
      best_left_raddr_s19_sim <= best_left_raddr_s18_sim;
      best_left_re_s20_sim <= best_left_re_s19_sim;
      best_left_raddr_s20_sim <= best_left_raddr_s19_sim;
      best_left_re_s21_sim <= best_left_re_s20_sim;
      best_left_raddr_s21_sim <= best_left_raddr_s20_sim;
      best_left_re_s22_sim <= best_left_re_s21_sim;
      best_left_raddr_s22_sim <= best_left_raddr_s21_sim;
      best_left_re_s23_sim <= best_left_re_s22_sim;
      best_left_raddr_s23_sim <= best_left_raddr_s22_sim;
      best_left_re_s24_sim <= best_left_re_s23_sim;
      best_left_raddr_s24_sim <= best_left_raddr_s23_sim;
      best_left_re_s25_sim <= best_left_re_s24_sim;
      best_left_raddr_s25_sim <= best_left_raddr_s24_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s10_sim && best_left_raddr_s10_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s11_sim && best_left_raddr_s11_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s12_sim && best_left_raddr_s12_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s13_sim && best_left_raddr_s13_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s14_sim && best_left_raddr_s14_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s15_sim && best_left_raddr_s15_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s16_sim && best_left_raddr_s16_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s17_sim && best_left_raddr_s17_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s18_sim && best_left_raddr_s18_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s19_sim && best_left_raddr_s19_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s20_sim && best_left_raddr_s20_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s21_sim && best_left_raddr_s21_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s22_sim && best_left_raddr_s22_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s23_sim && best_left_raddr_s23_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s24_sim && best_left_raddr_s24_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s25_sim && best_left_raddr_s25_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 7'd120) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd120) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_across_0_q <= 20'h0;
      counts_across_1_q <= 20'h0;
      counts_across_2_q <= 20'h0;
      counts_across_3_q <= 20'h0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s26_en) begin
      counts_explained_q <= select_1344;
      counts_nearer_q <= select_1349;
      counts_unproven_q <= select_1359;
      counts_regions_bad_q <= select_1375;
      counts_across_0_q <= select_1462;
      counts_across_1_q <= select_1472;
      counts_across_2_q <= and_1327_s26_q ? 20'h0 : sum_1480;
      counts_across_3_q <= and_1327_s26_q ? 20'h0 : sum_1488;
      seen_q <= select_1883;
      nearer_q <= select_1886;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic and_1863_s27_q;
  logic or_1888_s27_q;
  logic and_1889_s27_q;
  logic [13:0] select_1894_s27_q;
  logic [13:0] select_1899_s27_q;
  logic [13:0] select_1904_s27_q;
  logic [13:0] select_1909_s27_q;
  logic [13:0] select_1914_s27_q;
  logic [13:0] select_1919_s27_q;
  logic and_1926_s27_q;
  logic and_1933_s27_q;
  logic and_1945_s27_q;
  logic and_2027_s27_q;
  logic and_2040_s27_q;
  logic and_2050_s27_q;
  logic and_2061_s27_q;
  logic [19:0] select_2066_s27_q;
  logic [19:0] select_2071_s27_q;
  logic [19:0] select_2076_s27_q;
  logic [19:0] select_2081_s27_q;
  logic [11:0] select_2086_s27_q;
  logic [11:0] select_2091_s27_q;
  logic [11:0] select_2096_s27_q;
  logic [11:0] select_2101_s27_q;
  logic [23:0] select_2106_s27_q;
  logic [23:0] select_2111_s27_q;
  logic [23:0] select_2116_s27_q;
  logic [23:0] select_2121_s27_q;
  logic and_2124_s27_q;
  logic [5:0] select_2129_s27_q;
  logic [11:0] select_2134_s27_q;
  logic [11:0] select_2139_s27_q;
  logic [11:0] select_2145_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      and_1863_s27_q <= and_1863_s26_q;
      or_1888_s27_q <= not_1887 | select_1883;
      and_1889_s27_q <= cfg_prove_i & select_1886;
      select_1894_s27_q <= select_1894_s26_q;
      select_1899_s27_q <= select_1899_s26_q;
      select_1904_s27_q <= select_1904;
      select_1909_s27_q <= select_1909;
      select_1914_s27_q <= select_1914;
      select_1919_s27_q <= select_1919;
      and_1926_s27_q <= and_1926_s26_q;
      and_1933_s27_q <= and_1933_s26_q;
      and_1945_s27_q <= not_343_s26_q & (not_484_s26_q & and_1943);
      and_2027_s27_q <= not_343_s26_q & (not_484_s26_q & (not_1240_s26_q & and_2024));
      and_2040_s27_q <= not_343_s26_q & (not_484_s26_q & and_2038);
      and_2050_s27_q <= not_343_s26_q & (not_484_s26_q & and_2048);
      and_2061_s27_q <= and_2061_s26_q;
      select_2066_s27_q <= select_2066;
      select_2071_s27_q <= select_2071;
      select_2076_s27_q <= select_2076;
      select_2081_s27_q <= select_2081;
      select_2086_s27_q <= select_2086_s26_q;
      select_2091_s27_q <= select_2091_s26_q;
      select_2096_s27_q <= select_2096_s26_q;
      select_2101_s27_q <= select_2101_s26_q;
      select_2106_s27_q <= select_2106_s26_q;
      select_2111_s27_q <= select_2111_s26_q;
      select_2116_s27_q <= select_2116_s26_q;
      select_2121_s27_q <= select_2121_s26_q;
      and_2124_s27_q <= and_2124_s26_q;
      select_2129_s27_q <= select_2129_s26_q;
      select_2134_s27_q <= select_2134_s26_q;
      select_2139_s27_q <= select_2139_s26_q;
      select_2145_s27_q <= select_2145_s26_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s27_q;
  assign pixel_1_o = pixel_1_s27_q;
  assign saturated_o = saturated_s27_q;
  assign mask_o = mask_s27_q;
  assign marks_first_o = marks_first_s27_q;
  assign marks_last_o = marks_last_s27_q;
  assign marks_seen_o = or_1888_s27_q;
  assign marks_nearer_o = and_1889_s27_q;
  assign verdict_valid_o = and_1863_s27_q;
  assign verdict_supervised_o = {2'h0, select_1894_s27_q};
  assign verdict_textured_o = {2'h0, select_1899_s27_q};
  assign verdict_explained_o = {2'h0, select_1904_s27_q};
  assign verdict_nearer_o = {2'h0, select_1909_s27_q};
  assign verdict_unproven_o = {2'h0, select_1914_s27_q};
  assign verdict_regions_bad_o = {2'h0, select_1919_s27_q};
  assign verdict_unproven_yet_o = and_1926_s27_q;
  assign verdict_untextured_o = and_1933_s27_q;
  assign verdict_disagree_o = and_1945_s27_q;
  assign verdict_moved_o = and_2027_s27_q;
  assign verdict_unsharp_left_o = and_2040_s27_q;
  assign verdict_unsharp_right_o = and_2050_s27_q;
  assign verdict_hidden_o = and_2061_s27_q;
  assign verdict_across_0_o = select_2066_s27_q;
  assign verdict_across_1_o = select_2071_s27_q;
  assign verdict_across_2_o = select_2076_s27_q;
  assign verdict_across_3_o = select_2081_s27_q;
  assign verdict_measured_0_o = select_2086_s27_q;
  assign verdict_measured_1_o = select_2091_s27_q;
  assign verdict_measured_2_o = select_2096_s27_q;
  assign verdict_measured_3_o = select_2101_s27_q;
  assign verdict_detail_0_o = select_2106_s27_q;
  assign verdict_detail_1_o = select_2111_s27_q;
  assign verdict_contrast_0_o = select_2116_s27_q;
  assign verdict_contrast_1_o = select_2121_s27_q;
  assign region_valid_o = and_2124_s27_q;
  assign region_region_o = select_2129_s27_q;
  assign region_textured_o = select_2134_s27_q;
  assign region_explained_o = select_2139_s27_q;
  assign region_nearer_o = select_2145_s27_q;
  assign valid_o = valid_s27_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
      valid_s8_q <= 1'b0;
      valid_s9_q <= 1'b0;
      valid_s10_q <= 1'b0;
      valid_s11_q <= 1'b0;
      valid_s12_q <= 1'b0;
      valid_s13_q <= 1'b0;
      valid_s14_q <= 1'b0;
      valid_s15_q <= 1'b0;
      valid_s16_q <= 1'b0;
      valid_s17_q <= 1'b0;
      valid_s18_q <= 1'b0;
      valid_s19_q <= 1'b0;
      valid_s20_q <= 1'b0;
      valid_s21_q <= 1'b0;
      valid_s22_q <= 1'b0;
      valid_s23_q <= 1'b0;
      valid_s24_q <= 1'b0;
      valid_s25_q <= 1'b0;
      valid_s26_q <= 1'b0;
      valid_s27_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
      valid_s9_q <= valid_s8_q;
      valid_s10_q <= valid_s9_q;
      valid_s11_q <= valid_s10_q;
      valid_s12_q <= valid_s11_q;
      valid_s13_q <= valid_s12_q;
      valid_s14_q <= valid_s13_q;
      valid_s15_q <= valid_s14_q;
      valid_s16_q <= valid_s15_q;
      valid_s17_q <= valid_s16_q;
      valid_s18_q <= valid_s17_q;
      valid_s19_q <= valid_s18_q;
      valid_s20_q <= valid_s19_q;
      valid_s21_q <= valid_s20_q;
      valid_s22_q <= valid_s21_q;
      valid_s23_q <= valid_s22_q;
      valid_s24_q <= valid_s23_q;
      valid_s25_q <= valid_s24_q;
      valid_s26_q <= valid_s25_q;
      valid_s27_q <= valid_s26_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{right[1:0], left[1:0], sum_1948[2:0], sum_1443[0], sum_1439[0], sum_1431[1:0], sum_1430[1:0], sum_1426[0], detail_4[1:0], detail_3[1:0], sum_1146[4:0], sum_843[9:0], sum_428[4:0], cfg_width_i[3:0]};

endmodule
